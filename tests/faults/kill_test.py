#!/usr/bin/env python3
"""Kills `ljmd run` and `ljmd resume`, and looks whether anything was lost.

Usage: kill_test.py --ljmd PROGRAM --faults LIBRARY [--kills N] [--seed N]

For each format of a trajectory a short run is made in one piece. Then the same run is killed: in every call that
changes a file, and in every one after half of the bytes (LIBRARY is preloaded, see fault_at_call.cpp); so is the second
half of it, which `ljmd resume` makes; and a longer run is killed at N random times, in all formats together, and again
in one of three cases while it is resumed.

Prints one line for each kind, and "N passed, M failed". Exit code 1 when something failed.
"""

from __future__ import annotations

import shutil
import signal
import sys
import time
from pathlib import Path

from faulty_runs import (FORMATS, Case, Command, Failure, NumberOption, Runner, Tally, check_same_run, commands,
                         make_case, measure, run_tests)


def kill_at_call(runner: Runner, command: Command, folder: Path, mode: str, call: int) -> None:
    arguments, directory = command.prepare(folder)
    if runner.finish(runner.start(arguments, f"{mode}:{call}"), (0, -signal.SIGKILL)) == 0:
        raise Failure("was not killed")
    runner.go_on(directory, command.case.deck, kill_again=False)
    check_same_run(directory, command.case.whole)


def kill_at_each_call(runner: Runner, command: Command, folder: Path, tally: Tally, form: str) -> None:
    calls = command.count_calls(runner, folder)
    for mode in ("kill", "tear"):
        before = tally.failed
        for call in range(1, calls + 1, runner.every):
            tally.attempt(f"{form}, {mode} at call {call} of {command.name}",
                          lambda: kill_at_call(runner, command, folder, mode, call))
        print(f"{form}: {mode} at each of {calls} calls of {command.name}: {tally.failed - before} failed", flush=True)


def kill_at_random(runner: Runner, case: Case, folder: Path, seconds: float) -> None:
    arguments, directory = Command("run", case).prepare(folder)
    process = runner.start(arguments)
    if runner.kill_after(process, runner.random.uniform(0.0, seconds)):
        if not directory.exists():
            return
        runner.go_on(directory, case.deck, kill_again=True)
    check_same_run(directory, case.whole)


def replicas(case: Case, folder: Path) -> tuple[list[str], Path]:
    """The command that makes two replicas, in the same place each time: their records name it."""
    out = folder / "replicas"
    if out.exists():
        shutil.rmtree(out)
    return ["run", str(case.deck), "--replicas", "2", "--jobs", "2", "--out", str(out), "--quiet"], out


def kill_replicas(runner: Runner, case: Case, folder: Path, whole: Path, seconds: float) -> None:
    """The command is killed; its runs stop by themselves, and the same command resumes them and merges their results."""
    arguments, out = replicas(case, folder)
    runner.kill_after(runner.start(arguments), runner.random.uniform(0.0, seconds))
    runner.finish(runner.start(arguments), (0,))
    for replica in ("replica-1", "replica-2"):
        check_same_run(out / "points" / replica, whole / "points" / replica)
    for name in ("sweep.json", "results.json", "results.txt"):
        if (out / name).read_bytes() != (whole / name).read_bytes():
            raise Failure(f"{name} differs from that of replicas to which nothing happened")


def kill_replicas_at_random(runner: Runner, case: Case, folder: Path, tally: Tally, kills: int) -> None:
    arguments, out = replicas(case, folder)
    begin = time.perf_counter()
    runner.finish(runner.start(arguments), (0,))
    seconds = time.perf_counter() - begin
    whole = Path(shutil.copytree(out, folder / "whole-replicas"))
    before = tally.failed
    for number in range(kills):
        tally.attempt(f"replicas, random kill {number}", lambda: kill_replicas(runner, case, folder, whole, seconds))
    print(f"replicas: {kills} kills at random times: {tally.failed - before} failed", flush=True)


def tests(runner: Runner, folder: Path, tally: Tally, all_kills: int) -> None:
    for form in FORMATS:
        short = make_case(runner, folder / f"short-{form}", form, 6, 12, 5)
        for command in commands(runner, short, folder / "calls"):
            kill_at_each_call(runner, command, folder / "calls", tally, form)
        long = make_case(runner, folder / f"long-{form}", form, 200, 400, 50)
        seconds = measure(runner, long, folder / "time")
        before = tally.failed
        kills = all_kills // len(FORMATS)
        for number in range(kills):
            tally.attempt(f"{form}, random kill {number}", lambda: kill_at_random(runner, long, folder, seconds))
        print(f"{form}: {kills} kills at random times: {tally.failed - before} failed", flush=True)
        if form == "xyz":
            kill_replicas_at_random(runner, long, folder, tally, kills // 2)


if __name__ == "__main__":
    sys.exit(run_tests(sys.argv[1:], "Kill runs, resume them, and check that nothing was lost.", tests,
                       NumberOption("--kills", 60, "at random times, in all formats together")))
