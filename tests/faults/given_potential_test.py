#!/usr/bin/env python3
"""Kills runs that have a pair potential from Python. Checks that each can be resumed from the table in its directory.

Usage: given_potential_test.py --ljmd PROGRAM --faults LIBRARY [--every N]

As kill_test.py, with one format of a trajectory; PROGRAM is given_potential.py, and PYTHONPATH has the package.
"""

from __future__ import annotations

import sys
from pathlib import Path

from faulty_runs import Failure, Runner, Tally, commands, make_case, run_tests
from kill_test import kill_at_each_call


def tests(runner: Runner, folder: Path, tally: Tally, _: int) -> None:
    case = make_case(runner, folder / "run", "xyz", 6, 12, 5)
    if not (case.whole / "given-potential.json").is_file():
        raise Failure("the directory has no table of the potential")
    for command in commands(runner, case, folder / "calls"):
        kill_at_each_call(runner, command, folder / "calls", tally, "given potential")


if __name__ == "__main__":
    sys.exit(run_tests(sys.argv[1:], "Kill runs with a pair potential of Python's, and resume them.", tests))
