#!/usr/bin/env python3
"""Lets the disk fill up under `ljmd run`, and looks whether anything was lost.

Usage: full_disk_test.py --ljmd PROGRAM --faults LIBRARY [--seed N]

For each format of a trajectory a short run is made in one piece. Then the same run finds no space left, from each of its
calls on that change a file (LIBRARY is preloaded): at a checkpoint, the trajectory, the thermo file, at the end. Or it
is told so when it syncs or closes a file, from each such time on, as on a file system that writes late. So does
`ljmd resume` when it makes the second half of the run; and the run on file systems of a few hundred kilobytes, where
such may be mounted. It must end with exit code 4 and one message and leave no temporary file, what was reported must be
there, and the run must go on when there is space again.

Prints one line for each kind, and "N passed, M failed". Exit code 1 when something failed.
"""

from __future__ import annotations

import ctypes
import json
import shutil
import subprocess
import sys
from pathlib import Path

from faulty_runs import (FORMATS, Case, Command, Failure, Runner, Tally, check_same_run, commands, make_case,
                         run_tests)
import waiting

OUTPUT_ERROR = 4


def check_message(talk: str, directory: Path) -> None:
    if talk.count("error: ") != 1 or "No space left on device" not in talk:
        raise Failure(f"says: {talk.strip()}")
    if (directory / "run.json").exists() and not list(directory.glob("checkpoint.?")) and "no checkpoint yet: begin it again" not in talk:
        raise Failure(f"cannot be resumed, but says: {talk.strip()}")


def run_without_space(runner: Runner, command: Command, folder: Path, fault: str) -> bool:
    """@return whether the run was stopped by it"""
    arguments, directory = command.prepare(folder)
    process = runner.start(arguments, fault)
    _, talk = process.communicate(timeout=waiting.PATIENCE)
    if process.returncode != 0:  # 0: nothing was written from that call on
        if process.returncode != OUTPUT_ERROR:
            raise Failure(f"ended with {process.returncode}: {talk.strip()}")
        check_message(talk, directory)
        before = [path.name for path in command.killed.glob(".*")] if command.killed else []
        if left := [path.name for path in directory.glob(".*") if path.name not in before]:
            raise Failure(f"has left {left}")
        runner.go_on(directory, command.case.deck, kill_again=False)
    elif not json.loads((directory / "run.json").read_text())["finished"]:
        raise Failure("ended well, but has not finished")
    check_same_run(directory, command.case.whole)
    return process.returncode != 0


def full_from_sync(runner: Runner, command: Command, folder: Path, form: str, tally: Tally) -> None:
    """Files are closed and synced until a run does not need the one that fails."""
    before = tally.failed
    stopped = True
    number = 0

    def attempt() -> None:
        nonlocal stopped
        stopped = False  # unless it says so: after a failure the next one would tell nothing new
        stopped = run_without_space(runner, command, folder, f"late:{number}")

    while stopped:
        number += runner.every
        tally.attempt(f"{form}, full when {command.name} syncs or closes for the {number}th time", attempt)
    if number < 10:
        tally.fail(form, f"{command.name} has synced and closed files {number - 1} times")
    print(f"{form}: full at each of {number - 1} times that {command.name} syncs or closes a file: "
          f"{tally.failed - before} failed", flush=True)


def full_disk(runner: Runner, case: Case, mount: Path, kilobytes: int) -> bool:
    """@return whether the run was stopped by it"""
    subprocess.run(["mount", "-t", "tmpfs", "-o", f"size={kilobytes}k", "tmpfs", str(mount)], check=True)
    try:
        directory = mount / "out"
        process = runner.start(["run", str(case.deck), "--out", str(directory)])
        _, talk = process.communicate(timeout=waiting.PATIENCE)
        if process.returncode == 0:
            check_same_run(directory, case.whole)
            return False
        if process.returncode != OUTPUT_ERROR:
            raise Failure(f"ended with {process.returncode}: {talk.strip()}")
        check_message(talk, directory)
        if directory.exists():
            subprocess.run(["mount", "-o", "remount,size=10m", str(mount)], check=True)
            runner.go_on(directory, case.deck, kill_again=False)
            check_same_run(directory, case.whole)
        return True
    finally:
        subprocess.run(["umount", str(mount)], check=True)


def has_own_mounts() -> bool:
    """Give this process a namespace of mounts, private to it and its children: they are gone with it, also if it is killed."""
    new_namespace, recursive, private = 0x00020000, 1 << 14, 1 << 18
    system = ctypes.CDLL(None)
    return system.unshare(new_namespace) == 0 and system.mount(b"none", b"/", None, recursive | private, None) == 0


def may_mount(folder: Path) -> bool:
    folder.mkdir()
    if shutil.which("mount") is None or not has_own_mounts():
        return False
    made = subprocess.run(["mount", "-t", "tmpfs", "-o", "size=64k", "tmpfs", str(folder)], capture_output=True)
    if made.returncode == 0:
        subprocess.run(["umount", str(folder)], check=True)
    return made.returncode == 0


def fill_a_disk(runner: Runner, case: Case, mount: Path, form: str, tally: Tally) -> None:
    stopped = []

    def attempt(kilobytes: int) -> None:
        if full_disk(runner, case, mount, kilobytes):
            stopped.append(kilobytes)

    before = tally.failed
    sizes = [*range(4, 400, 12 * runner.every), 1000, 2000, 4000]  # the last ones have room for all that a run of a fluid writes
    for kilobytes in sizes:
        tally.attempt(f"{form}, a disk of {kilobytes} kB", lambda: attempt(kilobytes))
    if not stopped or len(stopped) == len(sizes):
        tally.fail(form, f"{len(stopped)} of {len(sizes)} disks were full: the sizes test nothing")
    print(f"{form}: {len(sizes)} disks, {len(stopped)} of them too small: {tally.failed - before} failed", flush=True)


def tests(runner: Runner, folder: Path, tally: Tally, _: int) -> None:
    mountable = may_mount(folder / "mount")
    if not mountable:
        print("small disks: skipped, file systems may not be mounted here")
    for form in FORMATS:
        case = make_case(runner, folder / f"short-{form}", form, 6, 12, 5)
        for command in commands(runner, case, folder / "calls"):
            calls = command.count_calls(runner, folder / "calls")
            before = tally.failed
            for call in range(1, calls + 1):
                tally.attempt(f"{form}, full from call {call} of {command.name}",
                              lambda: run_without_space(runner, command, folder, f"full:{call}"))
            print(f"{form}: full from each of {calls} calls of {command.name}: {tally.failed - before} failed", flush=True)
            full_from_sync(runner, command, folder / "calls", form, tally)
        if mountable:
            fill_a_disk(runner, case, folder / "mount", form, tally)


if __name__ == "__main__":
    sys.exit(run_tests(sys.argv[1:], "Let disks fill up during runs, resume them, and check that nothing was lost.",
                       tests))
