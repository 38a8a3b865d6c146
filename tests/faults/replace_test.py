#!/usr/bin/env python3
"""Disturbs `ljmd run --force` where it replaces an earlier run, and looks whether one of the two is whole.

Usage: replace_test.py --ljmd PROGRAM --faults LIBRARY [--seed N]

A run takes the place of a finished one of another deck. It is killed in each call that changes a file (LIBRARY is
preloaded, see fault_at_call.cpp), its power is cut, or it finds no space from such a call on, until the new run has its
first checkpoint. `ljmd resume` must then end with the files of the earlier run, or with those of the new one, and with
nothing else; and both must happen.

Prints one line for each kind, and "N passed, M failed". Exit code 1 when something failed.
"""

from __future__ import annotations

import shutil
import signal
import sys
from dataclasses import dataclass, field
from pathlib import Path

from faulty_runs import Case, Command, Failure, Runner, Tally, check_same_run, make_case, run_tests

FORM = "xyz"
OUTPUT_ERROR = 4
CALLS_AFTER = 5  # a fault that the new run survives is followed by so many
MOST_CALLS = 200


@dataclass
class Replacement(Command):
    """`ljmd run --force` where an earlier run lies."""

    earlier: Path = Path()
    left: list[str] = field(default_factory=list)  # what was there in the end, for one fault after the other

    def prepare(self, folder: Path) -> tuple[list[str], Path]:
        directory = folder / "out"
        shutil.rmtree(directory, ignore_errors=True)
        shutil.copytree(self.earlier, directory)
        return ["run", str(self.case.deck), "--out", str(directory), "--force"], directory


def disturb(runner: Runner, command: Replacement, folder: Path, fault: str) -> None:
    shutil.rmtree(folder, ignore_errors=True)
    folder.mkdir()
    arguments, directory = command.prepare(folder)
    runner.finish(runner.start(arguments, fault, folder), (0, OUTPUT_ERROR, -signal.SIGKILL))
    runner.finish(runner.start(["resume", str(directory)]), (0,))
    if left := [path.name for path in directory.glob(".*")]:
        raise Failure(f"has left {left}")
    try:
        check_same_run(directory, command.case.whole)
        command.left.append("new")
    except Failure:
        check_same_run(directory, command.earlier)
        command.left.append("earlier")


def tests(runner: Runner, folder: Path, tally: Tally, _: int) -> None:
    earlier = make_case(runner, folder / "earlier", FORM, 6, 6, 5)
    case = make_case(runner, folder / "new", FORM, 6, 12, 5)
    for mode in ("kill", "full", "none"):
        command = Replacement(mode, Case(case.deck, case.whole), earlier=earlier.whole)
        before = tally.failed
        number = 0
        while command.left[-CALLS_AFTER:] != ["new"] * CALLS_AFTER and number < MOST_CALLS:
            number += runner.every
            tally.attempt(f"{mode} at call {number}",
                          lambda: disturb(runner, command, folder / "disk", f"{mode}:{number}"))
        if command.left[0] != "earlier" or command.left[-1] != "new":
            tally.fail(mode, f"found one after the other: {', '.join(command.left)}")
        print(f"{FORM}: {mode} at each of {number} calls: {tally.failed - before} failed", flush=True)


if __name__ == "__main__":
    sys.exit(run_tests(sys.argv[1:], "Disturb runs that replace others, and look whether one of the two is whole.", tests))
