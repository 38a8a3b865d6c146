#!/usr/bin/env python3
"""Gives `ljmd run` too few descriptors, too little memory, a clock that jumps, and looks how it ends.

Usage: limits_test.py --ljmd PROGRAM --faults LIBRARY [--seed N] [--every N]

Limits begin where `ljmd --version` just works: below, the system cannot load the program. Every run must end well, or with the
exit code of its failure and one message, and go on without the limit.

Prints one line for each kind, and "N passed, M failed". Exit code 1 when something failed.
"""

from __future__ import annotations

import resource
import subprocess
import sys
from pathlib import Path
from typing import Callable

from faulty_runs import Case, Command, Failure, Runner, Tally, check_same_run, make_case, run_tests
import waiting

KIBIBYTE = 1 << 10
MEBIBYTE = 1 << 20


def least(program: Path, limit: int, values: range) -> int:
    """The first value of the limit under which the program works at all."""
    for value in values:
        if subprocess.run([str(program), "--version"], capture_output=True, preexec_fn=limited(limit, value)).returncode == 0:
            return value
    raise Failure("`ljmd --version` works under none of the limits")


def limited(limit: int, value: int) -> Callable[[], None]:
    return lambda: resource.setrlimit(limit, (value, value))


def run_limited(runner: Runner, case: Case, folder: Path, limit: int, value: int, codes: tuple[int, ...]) -> bool:
    """@return whether the limit was felt"""
    arguments, directory = Command("run", case).prepare(folder)
    done = subprocess.run([str(runner.program), *arguments, "--quiet"], capture_output=True, text=True,
                          timeout=waiting.PATIENCE, preexec_fn=limited(limit, value))
    if done.returncode not in (0, *codes):
        raise Failure(f"ended with {done.returncode}: {done.stderr.strip()}")
    if done.returncode != 0 and done.stderr.count("error: ") != 1:
        raise Failure(f"says: {done.stderr.strip()}")
    if done.returncode == 0 or directory.exists():
        if done.returncode != 0:
            runner.go_on(directory, case.deck, kill_again=False)
        check_same_run(directory, case.whole)
    return done.returncode != 0


def try_limits(runner: Runner, case: Case, folder: Path, tally: Tally, what: str, limit: int, values: range,
               codes: tuple[int, ...]) -> None:
    before, felt = tally.failed, []

    def attempt(value: int) -> None:
        if run_limited(runner, case, folder, limit, value, codes):
            felt.append(value)

    for value in values:
        tally.attempt(f"{what} {value}", lambda: attempt(value))
    if not felt:
        tally.fail(what, "no limit is too low: they test nothing")
    print(f"{what}: {len(values)} limits, {len(felt)} of them too low: {tally.failed - before} failed", flush=True)


def clock_jumps(runner: Runner, case: Case, folder: Path) -> None:
    """No wall time of a run is measured by that clock."""
    arguments, directory = Command("run", case).prepare(folder)
    runner.finish(runner.start([*arguments, "--walltime", "1h"], "clock:31536000"), (0,))
    check_same_run(directory, case.whole)


def tests(runner: Runner, folder: Path, tally: Tally, _: int) -> None:
    case = make_case(runner, folder / "short", "h5md", 6, 12, 5)
    tally.attempt("a clock that jumps by a year", lambda: clock_jumps(runner, case, folder))
    first = least(runner.program, resource.RLIMIT_NOFILE, range(3, 40))
    try_limits(runner, case, folder, tally, "descriptors", resource.RLIMIT_NOFILE, range(first, first + 10), (2, 4))
    case = make_case(runner, folder / "large", "h5md", 4, 2, 3, cells=16)
    first = least(runner.program, resource.RLIMIT_AS, range(16 * MEBIBYTE, 4096 * MEBIBYTE, 8 * MEBIBYTE))
    # In steps as small as what a library asks for at a time: one that ends the program when it is refused is felt in few of them.
    try_limits(runner, case, folder, tally, "bytes of memory", resource.RLIMIT_AS,
               range(first, first + 16 * MEBIBYTE, runner.every * 64 * KIBIBYTE), (4, 7))


if __name__ == "__main__":
    sys.exit(run_tests(sys.argv[1:], "Give runs too little of something, resume them, and check that nothing was lost.",
                       tests))
