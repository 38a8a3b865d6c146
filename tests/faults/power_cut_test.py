#!/usr/bin/env python3
"""Cuts the power under `ljmd run` and `ljmd resume`, and looks whether anything was lost that had been synced.

Usage: power_cut_test.py --ljmd PROGRAM --faults LIBRARY [--seed N]

For each format of a trajectory a short run is made in one piece. Then the same run, and the second half of it, which
`ljmd resume` makes, are cut off before each call that syncs, names, removes or shortens a file. The preloaded LIBRARY
leaves of their files what was synced (tests/faults/disk.hpp), and of the rest nothing, the names only, or the names and
some blocks. The run must go on to the same end; and the later the cut, the later the step that it goes on from: so
each checkpoint is on the disk, with all that it counts, before the run does anything else.

Prints one line for each kind, and "N passed, M failed". Exit code 1 when something failed.
"""

from __future__ import annotations

import shutil
import signal
import sys
from pathlib import Path

from faulty_runs import FORMATS, Command, Failure, Runner, Tally, check_same_run, commands, make_case, run_tests

RESTS = ("names", "none", "blocks")


class Cuts:
    """Of one command, one after the other, until the command ends before the next."""

    def __init__(self, runner: Runner, command: Command, folder: Path, rest: str) -> None:
        self.runner, self.command, self.folder, self.rest = runner, command, folder, rest
        self.number = 0
        self.ended = False
        self.steps: list[int] = []  # from which the run went on

    def next(self) -> None:
        shutil.rmtree(self.folder, ignore_errors=True)
        self.folder.mkdir()
        arguments, directory = self.command.prepare(self.folder)
        process = self.runner.start(arguments, f"{self.rest}:{self.number}", self.folder)
        if self.runner.finish(process, (0, -signal.SIGKILL)) == 0:
            self.ended = True
        else:
            self.steps.append(self.runner.go_on(directory, self.command.case.deck, kill_again=False))
            if self.steps[-1] < max(self.steps):
                raise Failure(f"went on from step {self.steps[-1]}, after an earlier cut from {max(self.steps)}")
        check_same_run(directory, self.command.case.whole)


def cut(runner: Runner, command: Command, folder: Path, rest: str, form: str, tally: Tally) -> None:
    before = tally.failed
    cuts = Cuts(runner, command, folder, rest)
    while not cuts.ended:
        cuts.number += runner.every
        tally.attempt(f"{form}, cut {cuts.number} of {command.name} that leaves {rest}", cuts.next)
    last = int((command.case.whole / "thermo.csv").read_text().splitlines()[-1].split(",")[0])
    if runner.every == 1 and (len(set(cuts.steps)) < 3 or cuts.steps[-1] != last):
        tally.fail(form, f"went on from {sorted(set(cuts.steps))} of {last}")
    print(f"{form}: power cut at each of {cuts.number - 1} calls of {command.name}, what is left are {rest}: "
          f"{tally.failed - before} failed", flush=True)


def tests(runner: Runner, folder: Path, tally: Tally, _: int) -> None:
    for form in FORMATS:
        case = make_case(runner, folder / f"short-{form}", form, 6, 12, 5)
        for command in commands(runner, case, folder / "calls"):
            for rest in RESTS:
                cut(runner, command, folder / "disk", rest, form, tally)


if __name__ == "__main__":
    sys.exit(run_tests(sys.argv[1:], "Cut the power of runs, resume them, and check that nothing was lost.", tests))
