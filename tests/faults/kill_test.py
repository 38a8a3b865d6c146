#!/usr/bin/env python3
"""Kills `ljmd run` and `ljmd resume`, and looks whether anything was lost.

Usage: kill_test.py --ljmd PROGRAM --faults LIBRARY [--kills N] [--seed N]

For each format of a trajectory a short run is made in one piece. Then the same run is killed: in every call that
changes a file, and in every one after half of the bytes (LIBRARY is preloaded, see fault_at_call.cpp), and at N random
times, in all formats together; what is gone on with is killed again in one of three cases.

Prints one line for each kind, and "N passed, M failed". Exit code 1 when something failed.
"""

from __future__ import annotations

import signal
import sys
from pathlib import Path

from faulty_runs import (FORMATS, Case, Failure, Runner, Tally, check_same_run, count_calls, make_case, measure,
                         new_directory, run_tests)


def kill_at_call(runner: Runner, case: Case, folder: Path, mode: str, call: int) -> None:
    directory = new_directory(folder)
    code = runner.finish(runner.start(["run", str(case.deck), "--out", str(directory)], f"{mode}:{call}"),
                         (0, -signal.SIGKILL))
    if code == 0:
        raise Failure("was not killed")
    runner.go_on(directory, case.deck, kill_again=False)
    check_same_run(directory, case.whole)


def kill_at_random(runner: Runner, case: Case, folder: Path, seconds: float) -> None:
    directory = new_directory(folder)
    process = runner.start(["run", str(case.deck), "--out", str(directory)])
    if runner.kill_after(process, runner.random.uniform(0.0, seconds)):
        if not directory.exists():
            return
        runner.go_on(directory, case.deck, kill_again=True)
    check_same_run(directory, case.whole)


def tests(runner: Runner, folder: Path, tally: Tally, all_kills: int) -> None:
    for form in FORMATS:
        short = make_case(runner, folder / f"short-{form}", form, 6, 12, 5)
        calls = count_calls(runner, short, folder / "calls")
        for mode in ("kill", "tear"):
            before = tally.failed
            for call in range(1, calls + 1):
                tally.attempt(f"{form}, {mode} at call {call}", lambda: kill_at_call(runner, short, folder, mode, call))
            print(f"{form}: {mode} at each of {calls} calls: {tally.failed - before} failed", flush=True)
        long = make_case(runner, folder / f"long-{form}", form, 200, 400, 50)
        seconds = measure(runner, long, folder / "time")
        before = tally.failed
        kills = all_kills // len(FORMATS)
        for number in range(kills):
            tally.attempt(f"{form}, random kill {number}", lambda: kill_at_random(runner, long, folder, seconds))
        print(f"{form}: {kills} kills at random times: {tally.failed - before} failed", flush=True)


if __name__ == "__main__":
    sys.exit(run_tests(sys.argv[1:], "Kill runs, go on with them, and look whether anything was lost.", tests, kills=60))
