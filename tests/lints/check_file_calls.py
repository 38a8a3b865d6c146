#!/usr/bin/env python3
"""Checks that an error of the file system can't become an error that no one expects, or be lost.

    check_file_calls.py ROOT          check the tree at ROOT
    check_file_calls.py --self-test   check that violations are caught, on made-up trees

Operations of std::filesystem throw std::filesystem::filesystem_error, which would be reported as a bug of the program;
so does reading through the buffer of a std::ifstream. What src/ and include/ ask of the file system goes through
ljmd::files (src/io/files/file_system.hpp), what they read through open_input() (src/io/files/input_file.hpp),
what they write through OutputFile: these report errors of one type, with path and cause.
"""

import re
import sys

import lint

# file -> why it may call what others may not
ALLOWED = {
    "src/io/files/file_system.hpp": "the operations themselves",
    "src/io/files/file_system.cpp": "the operations themselves",
    "src/io/files/input_file.hpp": "open_input() itself",
    "src/io/files/input_file.cpp": "open_input() itself",
    "src/io/files/text_file.cpp": "reads through a std::istream, which turns what its buffer throws into a state",
    "src/cli/bench.cpp": "the kernel's word on this process; where there is none, nothing is told",
}

# Types of std::filesystem, which do nothing.
TYPES = {"path", "file_type", "file_status", "perms", "filesystem_error"}

RULES = [
    (re.compile(r"(?:\bstd::filesystem|\bfs)::(?!" + "|".join(rf"{name}\b" for name in sorted(TYPES)) + r")(\w+)"),
     "call ljmd::files, which reports errors"),
    # Found by the type of their argument, without a namespace.
    (re.compile(r"(?<![\w:.>])(is_regular_file|is_directory|is_symlink|file_size|symlink_status|create_director\w+|"
                r"remove_all|current_path|weakly_canonical|temp_directory_path|read_symlink|last_write_time|"
                r"copy_file|resize_file)\("),
     "call ljmd::files, which reports errors"),
    (re.compile(r"\bstd::ifstream\s+\w+\s*[({]"), "open it with open_input()"),
    (re.compile(r"\bstd::(o?fstream)\b"), "write with OutputFile"),
    (re.compile(r"\b\w+\.open\("), "open it with open_input()"),
    (re.compile(r"\bistreambuf_iterator\b|\.rdbuf\("), "read through the stream: its buffer throws"),
    (re.compile(r"\bjson::parse\((?:file|stream|input|in)\b"), "read the text first, by read_input(): parsing uses the buffer"),
    (re.compile(r"\b(?:std::)?(?:fopen|opendir|tmpfile|freopen)\(|\bstd::(?:rename|remove)\(\w+\)"),
     "call ljmd::files, open_input() or OutputFile"),
]


def check(root):
    complaints = []
    for path in lint.sources(root):
        name = path.relative_to(root).as_posix()
        if name in ALLOWED:
            continue
        for number, line in enumerate(lint.without_comments(path.read_text(encoding="utf-8")).splitlines(), 1):
            if line.lstrip().startswith("#include"):
                continue
            for pattern, advice in RULES:
                if found := pattern.search(line):
                    complaints.append(f"{name}:{number}: {found.group()}: {advice}")
    return complaints


SOUND = """#include <filesystem>
namespace fs = std::filesystem;
std::size_t length(const fs::path& path, std::filesystem::file_type type) {
    std::ifstream file = open_input(path);
    files::remove(path);  // not fs::remove(path)
    return files::is_directory(path) || file_.exists("name") ? 0 : store.remove(path);
}
"""

VIOLATIONS = [
    "if (std::filesystem::exists(path)) {",
    "fs::remove(path, error);",
    "for (const fs::directory_entry& entry : list) {",
    "return is_directory(path);",
    "std::ifstream file(path, std::ios::binary);",
    "std::ifstream file{path};",
    "file.open(path);",
    "std::ofstream(path) << text;",
    "std::fstream both;",
    "return {std::istreambuf_iterator<char>(file), {}};",
    "out << file.rdbuf();",
    "FILE* file = std::fopen(name, mode);",
    "std::remove(name);",
    "return nlohmann::json::parse(file);",
]


def self_test():
    sound = {"src/run/x.cpp": SOUND, "src/io/files/file_system.cpp": VIOLATIONS[0]}  # the latter is in ALLOWED
    return lint.self_test(check, sound, [("src/run/x.cpp", SOUND + line + "\n", "src/run/x.cpp") for line in VIOLATIONS])


if __name__ == "__main__":
    sys.exit(lint.main(sys.argv[1:], __doc__, check, self_test))
