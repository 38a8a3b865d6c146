#!/usr/bin/env python3
"""Starts and resumes runs on file systems that have no locks, cannot synchronise files, or let signals interrupt that.

Usage: odd_file_system_test.py --ljmd PROGRAM --faults LIBRARY [--seed N]

LIBRARY is preloaded, see odd_file_system.cpp. For each format of a trajectory a run and, from its first checkpoint, `ljmd
resume` must end with exit code 0 and the files of the run to which nothing happened; `ljmd analyze` must read them.

Prints one line for each format, and "N passed, M failed". Exit code 1 when something failed.
"""

from __future__ import annotations

import errno
import shutil
import subprocess
import sys
from pathlib import Path

from faulty_runs import FORMATS, Case, Failure, Runner, Tally, check_same_run, make_case, run_tests
import waiting

FAULTS = [f"flock:{errno.ENOLCK}", f"flock:{errno.EOPNOTSUPP}", f"fsync:{errno.EINVAL}", "signal"]
STOPPED = 75


def whole_run(runner: Runner, case: Case, directory: Path, fault: str) -> None:
    shutil.rmtree(directory, ignore_errors=True)
    runner.finish(runner.start(["run", str(case.deck), "--out", str(directory)], fault), (0,))
    check_same_run(directory, case.whole)


def two_parts(runner: Runner, case: Case, directory: Path, fault: str) -> None:
    shutil.rmtree(directory, ignore_errors=True)
    arguments = ["run", str(case.deck), "--out", str(directory), "--walltime", "0.000001s"]
    runner.finish(runner.start(arguments, fault), (STOPPED,))
    runner.finish(runner.start(["resume", str(directory)], fault), (0,))
    check_same_run(directory, case.whole)


def analyzed(runner: Runner, case: Case, directory: Path, fault: str) -> None:
    shutil.rmtree(directory, ignore_errors=True)
    arguments = [str(runner.program), "analyze", str(case.whole), "rdf", "--out", str(directory)]
    done = subprocess.run(arguments, env=runner.environment(fault), capture_output=True, text=True, timeout=waiting.PATIENCE)
    if done.returncode != 0:
        raise Failure(f"{arguments[1:]} ended with {done.returncode}: {done.stderr.strip()}")


def tests(runner: Runner, folder: Path, tally: Tally, _: int) -> None:
    for form in FORMATS:
        case = make_case(runner, folder / form, form, 6, 12, 5)
        before = tally.failed
        for fault in FAULTS:
            tally.attempt(f"{form}, run with {fault}", lambda: whole_run(runner, case, folder / "out", fault))
            tally.attempt(f"{form}, resume with {fault}", lambda: two_parts(runner, case, folder / "out", fault))
            if form != "csv":
                tally.attempt(f"{form}, analyze with {fault}", lambda: analyzed(runner, case, folder / "read", fault))
        print(f"{form}: {len(FAULTS)} odd file systems: {tally.failed - before} failed", flush=True)


if __name__ == "__main__":
    sys.exit(run_tests(sys.argv[1:], "Run on file systems that cannot do all that others can.", tests))
