#!/usr/bin/env python3
"""Checks that no file is written beside the doors that look whose file is replaced.

    check_outputs.py ROOT          check the tree at ROOT
    check_outputs.py --self-test   check that violations are caught, on made-up trees

In C++ the door is write_output() and NamedOutput (src/run/output_guard.hpp), in Python ljmd._output. Whoever else opens a
file for writing is named here with the reason why nothing of others can be there.
"""

import ast
import re
import sys

import lint

CALLS = re.compile(r"\b(?:write_file_atomically|write_configuration|write_pair_table|make_trajectory_writer|overwrite_beginning|"
                   r"ClaimedFile::claim|H5Fcreate|H5Fopen|mkstemp|creat)\(|\b(?:ReplacementFile|OutputFile) \w+[({]|"
                   r"\bO_(?:CREAT|TRUNC|WRONLY|RDWR|APPEND)\b|\bofstream\b|\.output = (?!\"/dev/null\")")

RUN = "the directory of a run, which is locked; check_directory() has refused all that the run would replace"
STUDY = "the directory of a study, which is locked and bears its record; what was there without one was refused"
SCRATCH = "a scratch folder of its own"
MEMORY = "the memory of a page, which has no other files"
# file of C++ -> why it may write beside the door
ALLOWED = {
    "src/run/output_guard.cpp": "the door itself",
    "src/io/files/output_file.cpp": "how the door and runs write",
    "src/io/files/replacement_file.cpp": "how the door and runs replace",
    "src/io/files/replacement_file.hpp": "how the door and runs replace",
    "src/io/files/checkpoint_file.cpp": RUN,
    "src/io/files/output_file.hpp": "declarations",
    "src/io/formats/extended_xyz_writer.hpp": "declarations",
    "src/io/formats/trajectory_writer.hpp": "declarations",
    "src/io/tables/pair_table_file.hpp": "declarations",
    "src/io/formats/extended_xyz_writer.cpp": "write_configuration(), whose callers are named here",
    "src/io/formats/trajectory_writer.cpp": "make_trajectory_writer(), whose callers are named here",
    "src/io/tables/pair_table_file.cpp": "write_pair_table(), whose callers are named here",
    "src/io/hdf5/hdf5_output.cpp": "a trajectory, whose place make_trajectory_writer() was given",
    "src/io/hdf5/hdf5_input.cpp": "opens to read",
    "src/io/files/claimed_file.cpp": "logs of a study, whose places check_places() has looked at; links are not followed",
    "src/io/files/process.cpp": "what a child process prints; callers are named here, and links are not followed",
    "src/cli/streams.cpp": "/dev/null in place of a stream that is closed",
    "src/compare/export.cpp": "a trajectory that grows where NamedOutput says",
    "src/judge/engine_command.cpp": "the log of an engine, whose place check_out() has looked at",
    "src/compare/lammps_peer.cpp": SCRATCH,
    "src/study/slurm_array.cpp": SCRATCH,
    "src/run/run_record.cpp": RUN,
    "src/run/run_directory.cpp": RUN,
    "src/run/run_in_directory.cpp": RUN,
    "src/page/exports.cpp": MEMORY,
    "src/page/page_run.cpp": MEMORY,
    "src/study/job_pool.cpp": STUDY,
    "src/study/replicas.cpp": STUDY,
    "src/study/row_run.cpp": STUDY,
    "src/study/run_lines.cpp": STUDY,
    "src/study/sweep_record.cpp": STUDY,
    "src/cli/commands/reproduce_command.cpp": STUDY,
    "src/cli/commands/sweep_command.cpp": STUDY,
    "src/cli/commands/reference_command.cpp": STUDY,
}

# (file of Python, function) -> why it may write beside the door
ALLOWED_FUNCTIONS = {
    ("python/ljmd/_output.py", "replacing"): "the door itself",
    ("python/ljmd/deck.py", "_in_file"): "a temporary folder of its own",
    ("python/ljmd/sweeps.py", "sweep"): "a temporary folder of its own",
}
WRITING_METHODS = {"write_text", "write_bytes", "savefig", "saving", "to_csv", "to_json", "tofile", "rename", "savetxt", "savez", "dump",
                   "copyfile", "copy2", "copytree", "move", "symlink_to", "touch"}


def writes(call):
    """Whether a call in Python opens, makes or moves a file."""
    name = call.func.attr if isinstance(call.func, ast.Attribute) else getattr(call.func, "id", "")
    words = [one.value for one in [*call.args, *(each.value for each in call.keywords)]
             if isinstance(one, ast.Constant) and isinstance(one.value, str)]
    if isinstance(call.func, ast.Attribute) and getattr(call.func.value, "id", "") == "_output":
        return False
    if name in ("open", "File", "fdopen"):
        flags = any(isinstance(one, ast.Attribute) and one.attr.startswith("O_") for each in call.args for one in ast.walk(each))
        return flags or any(re.fullmatch(r"[rwxabt+-]*[wxa+][rwxabt+-]*", word) for word in words)
    if name == "replace":  # of a path: that of a text has two arguments
        return len(call.args) == 1 and isinstance(call.func, ast.Attribute) and not call.keywords
    return name in WRITING_METHODS


class Places(ast.NodeVisitor):
    """The calls of a module that write, but for those in the block of replacing()."""

    def __init__(self):
        self.function = ""
        self.found = []

    def visit_FunctionDef(self, node):
        outer, self.function = self.function, node.name
        self.generic_visit(node)
        self.function = outer

    def visit_With(self, node):
        calls = [item.context_expr.func for item in node.items if isinstance(item.context_expr, ast.Call)]
        if "replacing" not in [getattr(call, "attr", getattr(call, "id", "")) for call in calls]:
            self.generic_visit(node)

    def visit_Call(self, node):
        if writes(node):
            self.found.append((self.function, node.lineno))
        self.generic_visit(node)


def check(root):
    complaints = []
    seen = set()
    for path in lint.sources(root):
        name = path.relative_to(root).as_posix()
        for number, line in enumerate(lint.without_comments(path.read_text(encoding="utf-8")).splitlines(), 1):
            if not line.lstrip().startswith("#include") and (found := CALLS.search(line)):
                seen.add(name)
                if name not in ALLOWED:
                    complaints.append(f"{name}:{number}: {found.group()}: write with write_output() or NamedOutput")
    for folder in ("python", "analysis"):
        for path in sorted((root / folder).rglob("*.py")):
            name = path.relative_to(root).as_posix()
            places = Places()
            places.visit(ast.parse(path.read_text(encoding="utf-8")))
            for function, number in places.found:
                seen.add((name, function))
                if (name, function) not in ALLOWED_FUNCTIONS:
                    complaints.append(f"{name}:{number}: {function}() writes a file: do it through ljmd._output")
    if (root / "src/run/output_guard.cpp").exists():  # not in a made-up tree
        complaints += [f"{name}: is said to write files, and does not" for name in [*ALLOWED, *ALLOWED_FUNCTIONS] if name not in seen]
    return complaints


SOUND = {
    "src/cli/x.cpp": "void x() {\n    write_output(path, {}, text);  // not write_file_atomically(path, text)\n"
                     "    NamedOutput file(path, {});\n    run({.output = \"/dev/null\"});\n}\n",
    "src/run/run_record.cpp": "write_file_atomically(deck.outputs() / name, text);\n",
    "python/ljmd/x.py": "def x(path, text):\n    _output.write_text(path, text)\n    with _output.replacing(path) as half:\n        half.write_text(text)\n"
                        "    with open(path) as file:\n        return file.read().replace('a', 'b')\n",
}
VIOLATIONS = [
    *(("src/cli/y.cpp", line, "src/cli/y.cpp") for line in (
        "write_file_atomically(path, text);", "ReplacementFile file(path);", "OutputFile file(path);", "write_configuration(path, state, true);",
        "const auto writer = make_trajectory_writer(\"xyz\", state, {});", "::openat(at, name, O_WRONLY | flags);", "H5Fcreate(name, a, b, c);",
        "run_process({.output = log});", "std::ofstream file(path);", "ClaimedFile::claim(path);")),
    *(("python/ljmd/y.py", f"def y(path):\n    {line}\n", "y() writes a file") for line in (
        "open(path, 'w')", "path.open(mode='ab')", "path.write_text('')", "figure.savefig(path)", "half.replace(path)", "np.savetxt(path, a)",
        "os.open(path, os.O_CREAT)", "h5py.File(path, 'w')", "with other(path) as file: file.write_bytes(b'')")),
    ("analysis/y.py", "path.write_text('')", "writes a file"),
]


if __name__ == "__main__":
    sys.exit(lint.main(sys.argv[1:], __doc__, check, lambda: lint.self_test(check, SOUND, VIOLATIONS)))
