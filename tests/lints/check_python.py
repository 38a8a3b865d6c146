"""Modules of the Python package import each other in no circle, not within a function either.

Usage: check_python.py ROOT | --self-test      What only type checkers read (TYPE_CHECKING) does not count.
"""

import ast
import sys
from pathlib import Path

import lint


def imported(path, package):
    """Modules of the package that a module imports; names with dots, relative to the package."""
    tree = ast.parse(path.read_text(encoding="utf-8"))
    skipped = {node for test in ast.walk(tree) if isinstance(test, ast.If) and "TYPE_CHECKING" in ast.unparse(test.test)
               for part in test.body for node in ast.walk(part)}
    here = path.relative_to(package).with_suffix("").parts[:-1]
    for node in ast.walk(tree):
        if isinstance(node, ast.ImportFrom) and node.level > 0 and node not in skipped:
            base = [*here[:len(here) - node.level + 1], *(node.module.split(".") if node.module else [])]
            yield from {".".join([*base, alias.name]) for alias in node.names} | {".".join(base)}


def check(root):
    package = root / "python" / "ljmd"
    files = {".".join(path.relative_to(package).with_suffix("").parts): path for path in sorted(package.rglob("*.py"))}
    graph = {name: sorted({other for other in imported(path, package) if other in files and other != name}) for name, path in files.items()}
    complaints, done = [], set()

    def walk(name, trail):
        if name in trail:
            complaints.append("circle of imports: " + " -> ".join([*trail[trail.index(name):], name]))
        elif name not in done:
            for other in graph[name]:
                walk(other, [*trail, name])
            done.add(name)

    for name in graph:
        walk(name, [])
    return complaints if files else [f"no modules found under {package}"]


SOUND = {
    "python/ljmd/__init__.py": "import importlib\n",
    "python/ljmd/a.py": "from typing import TYPE_CHECKING\nfrom . import b\nfrom .deep import c\n",
    "python/ljmd/b.py": "if TYPE_CHECKING:\n    from .a import A\n",
    "python/ljmd/deep/__init__.py": "",
    "python/ljmd/deep/c.py": "from ..b import B\n",
}
VIOLATIONS = [
    ("python/ljmd/b.py", "from .a import A\n", "circle of imports: a -> b -> a"),
    ("python/ljmd/b.py", "def f():\n    from . import a\n", "circle of imports: a -> b -> a"),
    ("python/ljmd/b.py", "from .deep import c\n", "b -> deep.c -> b"),
]


def self_test():
    return lint.self_test(check, SOUND, VIOLATIONS)


if __name__ == "__main__":
    sys.exit(lint.main(sys.argv[1:], __doc__, check, self_test))
