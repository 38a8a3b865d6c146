"""What a version promises by name is still there: functions of the documented headers, names of the Python package, commands with
their options, keys of decks.

Usage: public_names.py --ljmd PROGRAM --libraries FILE... [--python FOLDER] [--write | --self-test]

public_names.json, beside this file, has the names of the last version with a promise. More names are fine; one that is missing, or a
function that takes something else, breaks programs of users: it needs a new first number. --write is for a release.
"""

import argparse
import json
import pathlib
import re
import subprocess
import sys

ROOT = pathlib.Path(__file__).resolve().parent.parent.parent
BASELINE = pathlib.Path(__file__).with_name("public_names.json")
INCLUDE = ROOT / "include" / "ljmd"


def output_of(*command) -> str:
    return subprocess.run([str(word) for word in command], check=True, capture_output=True, text=True).stdout


def functions(libraries: list[str]) -> list[str]:
    """Those that the documented headers declare and the libraries define."""
    text = "\n".join(file.read_text() for file in sorted(INCLUDE.rglob("*.hpp")) if "detail" not in file.parts)
    text = re.sub(r"//.*", "", text)
    owners = set(re.findall(r"\b(?:class|struct)\s+(\w+)", text))
    free = set(re.findall(r"\b(\w+)\(", text))
    found = set()
    for line in output_of("nm", "--demangle", "--defined-only", *libraries).splitlines():
        match = re.fullmatch(r"[0-9a-f]+ T (ljmd::((?:\w+::)*)([~\w]+)(?:\[abi:\w+\])?\(.*)", line)
        if match:
            name, scope, function = match.groups()
            if (scope.split("::")[0] in owners) if scope else function in free:
                found.add(name.replace("std::__cxx11::", "std::").replace(
                    "std::basic_string<char, std::char_traits<char>, std::allocator<char> >", "std::string"))
    return sorted(found)


def python_names(folder: pathlib.Path) -> list[str]:
    script = """
import ljmd
for name in ljmd.__all__:
    thing = getattr(ljmd, name)
    print(name)
    if isinstance(thing, type) and not issubclass(thing, BaseException):
        print(*(f"{name}.{part}" for part in vars(thing) if not part.startswith("_")), sep="\\n")
"""
    words = subprocess.run([sys.executable, "-c", script], check=True, capture_output=True, text=True,
                           env={"PYTHONPATH": str(folder), "PATH": "/usr/bin:/bin"}).stdout.split()
    return sorted(set(words))


def commands(program: str) -> list[str]:
    """Commands, and their options as the completion of a shell has them."""
    names = [line.split("\t")[0] for line in output_of(program, "complete", "").splitlines()]
    found = []
    for name in (name for name in names if not name.startswith("-")):
        options = [line.split("\t")[0] for line in output_of(program, "complete", name, "-").splitlines()]
        found += [name, *(f"{name} {option}" for option in options if option.startswith("-"))]
    return sorted(set(found))


def deck_keys(program: str) -> list[str]:
    """"[fluid] system.lattice.cells", from the JSON Schema."""
    schema = json.loads(output_of(program, "info", "--schema"))
    found = set()

    def walk(node, path):
        if isinstance(node, dict):
            for key, inner in node.get("properties", {}).items():
                found.add(f"{path}.{key}".lstrip("."))
                walk(inner, f"{path}.{key}")
            for key, inner in node.items():
                if key != "properties":
                    walk(inner, path)
        elif isinstance(node, list):
            for inner in node:
                walk(inner, path)

    for kind, part in (("few bodies", "then"), ("fluid", "else")):
        walk(schema[part], f"[{kind}] ")
    return sorted(name.replace("] .", "] ") for name in found)


def missing(promised: dict, present: dict) -> list[str]:
    """What was promised and is gone."""
    return [f"{kind}: {name}" for kind, names in promised.items() if kind in present for name in sorted(set(names) - set(present[kind]))]


def main() -> int:
    parser = argparse.ArgumentParser(description=__doc__.splitlines()[0])
    parser.add_argument("--ljmd", required=True)
    parser.add_argument("--libraries", nargs="+", required=True)
    parser.add_argument("--python", type=pathlib.Path)
    parser.add_argument("--write", action="store_true")
    parser.add_argument("--self-test", action="store_true")
    options = parser.parse_args()
    present = {"functions": functions(options.libraries), "commands": commands(options.ljmd), "deck keys": deck_keys(options.ljmd)}
    if options.python:
        present["python"] = python_names(options.python)
    if options.write:
        BASELINE.write_text(json.dumps(present, indent=1, sort_keys=True) + "\n")
        return 0
    promised = json.loads(BASELINE.read_text())
    counts = ", ".join(f"{len(names)} {kind}" for kind, names in present.items())
    if options.self_test:  # one name of each kind is taken away
        for kind, names in present.items():
            taken = next(name for name in names if name in promised[kind])
            if f"{kind}: {taken}" not in missing(promised, {**present, kind: [name for name in names if name != taken]}):
                print(f"FAIL {kind}: {taken} can be taken away")
                return 1
        print(f"ok   of {counts} none can be taken away")
        return 0
    gone = missing(promised, present)
    for name in gone:
        print(f"FAIL gone, though version 1 promises it: {name}")
    print(f"{'FAIL' if gone else 'ok  '} {counts}")
    return 1 if gone else 0


if __name__ == "__main__":
    sys.exit(main())
