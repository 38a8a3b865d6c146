#!/usr/bin/env python3
"""Pictures take the package's reader, and nothing of its compiled part. Prints "N passed, M failed"."""

from __future__ import annotations

import ast
import os
import shutil
import subprocess
import sys
from pathlib import Path
from typing import Any, Iterator

import fixtures
from fixtures import ANALYSIS, check_error, png_size, write_gravity

PACKAGE = ANALYSIS.parent / "python" / "ljmd"
# Modules that read files of data, and calls that open any file.
READERS = ("csv", "h5py", "json", "tomli", "tomllib")
OPENERS = ("fromfile", "genfromtxt", "load", "loads", "loadtxt", "open", "read_bytes", "read_csv", "read_text")
# They read what a program prints, no file of a run: json.loads().
OF_PROGRAMS = {"convergence.py", "program.py"}


def tree(tmp: Path, package: bool = True) -> Path:
    """A copy of the scripts with the package beside them that has no extension. Returns the folder of the scripts."""
    shutil.copytree(ANALYSIS, tmp / "tree" / "analysis", ignore=shutil.ignore_patterns("__pycache__"))
    if package:
        shutil.copytree(PACKAGE, tmp / "tree" / "python" / "ljmd", ignore=shutil.ignore_patterns("__pycache__", "_core*"))
    return tmp / "tree" / "analysis"


def run(*command: Any, **environment: str) -> subprocess.CompletedProcess[str]:
    """A Python that sees no other package ljmd."""
    kept = {name: value for name, value in os.environ.items() if name not in ("PYTHONPATH", "LJMD_PYTHON")}
    return subprocess.run([sys.executable, *map(str, command)], capture_output=True, text=True, check=False,
                          env={**kept, "PYTHONDONTWRITEBYTECODE": "1", **environment})


def test_pictures_need_no_extension(tmp: Path) -> None:
    few = write_gravity(tmp / "few", **fixtures.EIGHT, masses=[1, 1, 1], steps=20)
    found = run(tree(tmp) / "plot.py", few, "orbit", "energy", "--out", tmp / "out")
    assert (found.returncode, found.stderr) == (0, ""), found
    assert min(png_size(tmp / "out" / "orbit.png")) > 100 and (tmp / "out" / "energy.png").exists()


def test_results_are_opened_without_it_and_all_else_says_what_is_missing(tmp: Path) -> None:
    few = write_gravity(tmp / "few", **fixtures.EIGHT, masses=[1, 1, 1], steps=20)
    place = tree(tmp).parent / "python"
    code = "import ljmd; run = ljmd.open({!r}); print(len(run.thermo), ljmd.DataError.__name__, 'Deck' in dir(ljmd)); {}"
    found = run("-c", code.format(str(few), "ljmd.Deck"), PYTHONPATH=str(place))
    assert found.stdout == "21 DataError True\n" and found.returncode == 1, found
    message = found.stderr.splitlines()[-1]
    assert message.startswith("ImportError: the compiled part of ljmd is missing:") and f"{place / 'ljmd'} has no _core" in message, message
    # One that was built for another Python: its file has another name.
    (place / "ljmd" / "_core.cpython-38-x86_64-linux-gnu.so").write_text("")
    for use in ("ljmd.Deck", "from ljmd import Deck", "import ljmd.simulation", "ljmd.__version__", "from ljmd import _core"):
        found = run("-c", code.format(str(few), use), PYTHONPATH=str(place))
        message = found.stderr.splitlines()[-1]
        assert "_core.cpython-38-x86_64-linux-gnu.so: take the Python that it was built for" in message, (use, message)
        assert f"this is Python {sys.version_info.major}.{sys.version_info.minor}" in message, message
    # One that is damaged.
    (place / "ljmd" / "_core.so").write_text("no library")
    message = run("-c", "import ljmd; ljmd.Deck", PYTHONPATH=str(place)).stderr.splitlines()[-1]
    assert "cannot be loaded by Python" in message, message


def test_scripts_without_the_package_say_so(tmp: Path) -> None:
    scripts = tree(tmp, package=False)
    for script in ("plot.py", "animate.py", "convergence.py", "derivatives.py"):
        check_error(run(scripts / script, tmp), 2, "Python package ljmd", str(tmp / "tree" / "python"))


def test_the_package_beside_the_scripts_is_taken(tmp: Path) -> None:
    """One of another version that this Python has may read other files."""
    other = tmp / "other" / "ljmd"
    other.mkdir(parents=True)
    (other / "__init__.py").write_text("raise ImportError('of another version')")
    few = write_gravity(tmp / "few", **fixtures.EIGHT, masses=[1, 1, 1], steps=20)
    found = run(tree(tmp) / "plot.py", few, "orbit", "--out", tmp / "out", PYTHONPATH=str(other.parent))
    assert found.returncode == 0, found
    shutil.rmtree(tmp / "tree" / "python")
    check_error(run(tmp / "tree" / "analysis" / "plot.py", few, PYTHONPATH=str(other.parent)), 2, "of another version")


def own_readers(text: str) -> Iterator[str]:
    """Imports and calls by which a source would read a file by itself."""
    for node in ast.walk(ast.parse(text)):
        if isinstance(node, ast.Import):
            yield from (one.name for one in node.names if one.name.split(".")[0] in READERS)
        elif isinstance(node, ast.ImportFrom) and (node.module or "").split(".")[0] in READERS:
            yield node.module or ""
        elif isinstance(node, ast.Call):
            name = getattr(node.func, "attr", getattr(node.func, "id", ""))
            holder = getattr(node.func, "value", None)
            if name in OPENERS and not (isinstance(holder, ast.Name) and holder.id in LOADED):
                yield f"{name}()"


# Modules of ljmd.reading whose load() is the reader.
LOADED = {path.stem for path in (PACKAGE / "reading").glob("*.py")}


def test_no_script_reads_files_by_itself(_: Path) -> None:
    assert list(own_readers("import csv\nfrom h5py import File\nopen(a)\npath.read_text()\nnp.loadtxt(b)\nfluids.load(c)")) == [
        "csv", "h5py", "open()", "read_text()", "loadtxt()"]
    sources = sorted(ANALYSIS.glob("*.py"))
    assert len(sources) > 10
    for path in sources:
        found = set(own_readers(path.read_text())) - ({"json", "loads()"} if path.name in OF_PROGRAMS else set())
        assert not found, f"{path.name}: {found}; what is in files is read by python/ljmd/reading"


if __name__ == "__main__":
    sys.exit(fixtures.run_tests(globals()))
