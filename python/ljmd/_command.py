"""The command `ljmd` of an installed wheel, whose program lies in the package: Python only starts it, and is the Python of its pictures."""

import os
import pathlib
import sys


def main() -> None:
    program = pathlib.Path(__file__).resolve().parent / "bin" / "ljmd"
    os.environ.setdefault("LJMD_PYTHON", sys.executable)
    os.execv(program, [sys.argv[0], *sys.argv[1:]])
