#!/usr/bin/env python3
"""Checks that the tree looks as a reader expects it.

    check_tree.py ROOT                      check the tree at ROOT
    check_tree.py --compile-commands FILE   check the compiler's commands of a build
    check_tree.py --self-test               check that violations are caught, on made-up trees

Rules:
- every src/<room>/x.cpp has its tests/<room>/x_test.cpp, but for WITHOUT_TEST, and every pair formula the test of its
  closed form;
- at the top level stand only the names in TOP_LEVEL;
- a file in src/ or include/ has at most MAXIMUM_LINES lines;
- no file asks for fast-math;
- no name of a test holds `[`, `]`, `;` or `\\`: CMake splits or joins such names, and a test of half a name runs nothing.
"""

import json
import re
import subprocess
import sys
from fnmatch import fnmatch
from pathlib import Path

import lint

# sources without a test of their own -> why
WITHOUT_TEST = {
    "src/cli/main.cpp": "hands the command line over; the tests in tests/cli run the program",
    "src/execution/mpi/*.cpp": "takes several processes: tests/mpi runs the program in them",
    "src/forces/few_body/*.cpp": "plug-ins: the tests that loop over the registry try each",
    "src/python/*.cpp": "the binding: tests/python tries it through the package",
    "src/page/absent_formats.cpp": "stands for what a page lacks: tests/page/engine_test.py opens decks that name it",
    "src/page/exports.cpp": "the door to the page's script: tests/page/engine_test.py calls it",
    "src/page/page_run.cpp": "tests/page/engine_test.py runs all decks with it",
    "src/io/formats/readable/*.cpp": "plug-ins: tests/io/formats/readable_format_test.cpp tries each",
    "src/integrators/methods/*.cpp": "plug-ins: the tests that loop over the registry try each",
}

TOP_LEVEL = {
    ".ci", ".clang-format", ".clang-tidy", ".editorconfig", ".git-blame-ignore-revs", ".gitignore", ".zenodo.json", "CHANGELOG.md",
    "CITATION.cff", "CMakeLists.txt", "CMakePresets.json", "CONTRIBUTING.md", "LICENSE", "README.md", "analysis", "cmake",
    "codemeta.json", "docs", "include", "inputs", "packaging", "pyproject.toml", "python", "src", "tests", "tools",
}

# Where tests/CMakeLists.txt looks for cases with the tag [long]: elsewhere they would be in no set.
WITH_LONG_TESTS = {"neighbors", "run", "physics", "parity"}

MAXIMUM_LINES = 400

# Written by programs: the page of `ljmd report` in one file, and what it is built from.
GENERATED = {Path("src/report/web/dist"), Path("src/report/web/package-lock.json")}

# Flags and pragmas that allow the compiler to compute something else than what is written.
FAST_MATH = re.compile(r"fast-math|-Ofast\b|-funsafe-math|-fassociative-math|-freciprocal-math|-ffinite-math-only")
FAST_MATH_FILES = ("CMakeLists.txt", "CMakePresets.json", "*.cmake", "*.cpp", "*.hpp", "*.in", "*.sh", "tools/*",
                   ".ci/*")


def git_files(root, *options):
    """Files by 'git ls-files' relative to the root; None where git does not know the tree."""
    try:
        answer = subprocess.run(["git", "-C", str(root), "ls-files", "-z", *options], capture_output=True, check=True)
    except (OSError, subprocess.CalledProcessError):
        return None
    return [Path(name) for name in answer.stdout.decode().split("\0") if name]


def list_files(root):
    """All files of the project, relative to the root: git's and new ones, or simply all where git is not in use."""
    if (root / ".git").exists():
        files = git_files(root, "--cached", "--others", "--exclude-standard")
        if files:
            return sorted({path for path in files if (root / path).is_file()})
    files = (path.relative_to(root) for path in root.rglob("*") if path.is_file())
    return sorted(path for path in files
                  if path.parts[0] not in ("build", "runs", ".git") and "__pycache__" not in path.parts)


def check_mirror(files):
    complaints = []
    names = {path.as_posix() for path in files}
    for name in sorted(names):
        match = re.fullmatch(r"src/(.+)\.cpp|include/ljmd/detail/(potentials/formulas/.+)\.hpp", name)
        excused = any(fnmatch(name, pattern) for pattern in WITHOUT_TEST)
        test = match and f"tests/{match[1] or match[2]}_test.cpp"
        if test and not excused and test not in names:
            complaints.append(f"{name}: no {test}")
    return complaints


def check_top_level(files):
    names = {path.parts[0] for path in files}
    return [f"{name}: not a name for the top level" for name in sorted(names - TOP_LEVEL)]


def check_lengths(root, files):
    complaints = []
    for path in files:
        if path.parts[0] in ("src", "include") and path not in GENERATED and path.parent not in GENERATED:
            lines = len((root / path).read_bytes().splitlines())
            if lines > MAXIMUM_LINES:
                complaints.append(f"{path}: {lines} lines; at most {MAXIMUM_LINES}, better 200")
    return complaints


def check_fast_math(root, files):
    complaints = []
    for path in files:
        if path.parts[:2] == ("tests", "lints") or not any(path.match(pattern) for pattern in FAST_MATH_FILES):
            continue
        comment = "//" if path.suffix in (".cpp", ".hpp") else "#"
        text = (root / path).read_text(encoding="utf-8", errors="replace")
        for number, line in enumerate(text.splitlines(), 1):
            if FAST_MATH.search(line.split(comment)[0]) or (comment == "//" and re.match(r".*#.*fast-math", line)):
                complaints.append(f"{path}:{number}: fast-math")
    return complaints


def check_cross_products(root, files):
    """Eigen declares cross() in one header and defines it in another, which precompiled headers have: without them it is missing at
    the end, when all is linked."""
    texts = {path: (root / path).read_text(encoding="utf-8") for path in files if path.suffix in (".cpp", ".hpp") and path.parts[0] in ("src", "include")}
    return [f"{path}: cross() without #include <Eigen/Geometry>" for path, text in texts.items()
            if ".cross(" in text and "<Eigen/Geometry>" not in text and "<Eigen/Dense>" not in text]


def check_test_names(root, files):
    complaints = []
    for path in files:
        if path.name.endswith("_test.cpp"):
            text = (root / path).read_text(encoding="utf-8")
            for name in re.findall(r'TEST_CASE\(\s*"([^"]*)', text):
                if re.search(r"[\[\];\\]", name):
                    complaints.append(f"{path}: test name {name!r} holds one of [ ] ; \\")
            if re.search(r'TEST_CASE\([^;{]*\[long\]', text) and path.parts[1] not in WITH_LONG_TESTS:
                complaints.append(f"{path}: [long] is not looked for in tests/{path.parts[1]}; tests/CMakeLists.txt says where")
    return complaints


def check(root):
    files = list_files(root)
    return check_mirror(files) + check_top_level(files) + check_lengths(root, files) + check_fast_math(root, files) + \
        check_cross_products(root, files) + check_test_names(root, files)


def check_commands(entries):
    return [f"{entry['file']}: compiled with {FAST_MATH.search(entry['command']).group()}"
            for entry in entries if FAST_MATH.search(entry["command"])]


SOUND = {
    "CMakeLists.txt": "# -ffast-math is never used\nproject(x)\n",
    "src/cli/main.cpp": "",
    "src/core/a.cpp": "\n" * MAXIMUM_LINES,
    "tests/core/a_test.cpp": "\n" * (MAXIMUM_LINES + 1),
    "README.md": "We do not use -ffast-math.\n",
}

# what is wrong: (file, its text, what the complaint must say)
VIOLATIONS = [
    ("src/core/b.cpp", "", "no tests/core/b_test.cpp"),
    ("include/ljmd/core/moment.hpp", "return r.cross(p);\n", "cross() without"),
    ("src/core/deep/b.cpp", "", "no tests/core/deep/b_test.cpp"),
    ("include/ljmd/detail/potentials/formulas/b.hpp", "", "no tests/potentials/formulas/b_test.cpp"),
    ("tests/core/c_test.cpp", 'TEST_CASE("one; two") {}', "test name"),
    ("tests/core/c_test.cpp", 'TEST_CASE("one", "[long]") {}', "[long] is not looked for"),
    ("notes.txt", "", "not a name for the top level"),
    ("scripts/run", "", "not a name for the top level"),
    ("include/ljmd/core/long.hpp", "\n" * (MAXIMUM_LINES + 1), "at most"),
    ("cmake/X.cmake", "add_compile_options(-ffast-math)\n", "fast-math"),
    ("CMakePresets.json", '{"CMAKE_CXX_FLAGS": "-Ofast"}\n', "fast-math"),
    ("include/ljmd/core/p.hpp", '#pragma GCC optimize("fast-math")\n', "fast-math"),
    ("tools/build", "g++ -ffinite-math-only x.cpp\n", "fast-math"),
]


def self_test():
    found = check_commands([{"file": "x.cpp", "command": "g++ -Ofast -c x.cpp"}])
    return lint.self_test(check, SOUND, VIOLATIONS, [] if found else ["-Ofast in a compiler's command went unseen"])


def main(arguments):
    if len(arguments) == 2 and arguments[0] == "--compile-commands":
        entries = json.loads(Path(arguments[1]).read_text(encoding="utf-8"))
        return lint.report(check_commands(entries) if entries else [f"{arguments[1]} is empty"])
    return lint.main(arguments, __doc__, check, self_test)


if __name__ == "__main__":
    sys.exit(main(sys.argv[1:]))
