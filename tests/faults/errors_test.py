#!/usr/bin/env python3
"""Lets calls of `ljmd` to the file system fail, one at a time, and looks what becomes of it.

Usage: errors_test.py --ljmd PROGRAM --faults LIBRARY [--calls N]

Each command is given once without a fault. Then one of its calls ends with EIO, EINTR, ENOSPC, EACCES, EMFILE or EAGAIN,
or reads or writes half of what it should (LIBRARY is preloaded, see fault_at_call.cpp): N of the calls for each command
and error, at equal distances, the first looks at what is there, and all looks of a resumed run; or with N = 0 every
call. The command must end as it does without the fault, and leave the same; or with one message that names the cause
and the exit code of input, output or a checkpoint; and when it is given again, without a fault, it must end as if
nothing had happened. All kinds of calls must be seen: a fault in one that is never called tests nothing.

Prints one line for each command and error, and "N passed, M failed". Exit code 1 when something failed.
"""

from __future__ import annotations

import errno
import os
import shutil
import subprocess
import sys
from collections import Counter
from dataclasses import dataclass, field, replace
from pathlib import Path
from typing import Callable

from faulty_runs import (FORMATS, Case, Failure, NumberOption, Runner, Tally, check_same_run, commands, make_case,
                         read_counts, run_tests)
from harness import snapshot
import waiting

ERRORS = ("EIO", "EINTR", "ENOSPC", "EACCES", "EMFILE", "EAGAIN", "short")

DECK_ERROR, INPUT_ERROR, OUTPUT_ERROR, POINTS_FAILED, CHECKPOINT_ERROR, NO_ROOM = 2, 3, 4, 5, 6, 7

# Calls that are always disturbed by EIO: they look at what the arguments name, and decide what is done.
FIRST_LOOKS = 3

# Commands whose looks at files are all disturbed: a wrong answer to one could cost the run that is there.
MAY_COST_A_RUN = "resume"

# Nothing is linked, and nothing is made shorter in a run that begins.
UNSEEN = {"link"}


@dataclass
class Task:
    """A command, what it finds, and what it must leave."""

    name: str
    arguments: list[str]  # "{out}" is the directory that it writes
    codes: tuple[int, ...]  # with which it may end
    check: Callable[[Path], None]  # what it left there
    found: Path | None = None  # is there before
    again: list[str] = field(default_factory=list)  # what else is said to give it again
    go_on: Callable[[Path], None] | None = None  # instead of giving it again
    words: str = ""  # on stdout, where they are the result

    def prepare(self, folder: Path) -> Path:
        out = folder / "out"
        shutil.rmtree(out, ignore_errors=True)
        if self.found is not None:
            shutil.copytree(self.found, out)
        return out

    def run(self, runner: Runner, out: Path, fault: str | None = None, more: list[str] | None = None):
        arguments = [argument.format(out=out) for argument in self.arguments + (more or [])]
        return subprocess.run([str(runner.program), *arguments], env=runner.environment(fault), capture_output=True,
                              text=True, timeout=waiting.PATIENCE)

    def require_success(self, runner: Runner, out: Path, more: list[str] | None = None) -> str:
        done = self.run(runner, out, more=more)
        if done.returncode != 0:
            raise Failure(f"without a fault it ended with {done.returncode}: {done.stderr.strip()}")
        self.check(out)
        return done.stdout


def check_message(talk: str, error: str) -> None:
    if talk.count("error: ") != 1 or "internal error" in talk:
        raise Failure(f"says: {talk.strip()}")
    words_of_hdf5 = ".h5md" in talk or "can't retrieve stat info" in talk
    name = "EIO" if error == "look" else error
    cause = "" if error == "short" else os.strerror(getattr(errno, name))
    if cause not in talk and not words_of_hdf5:
        raise Failure(f"does not name the cause: {talk.strip()}")
    if "/" not in talk.replace(cause, ""):
        raise Failure(f"names no file: {talk.strip()}")


def disturb(runner: Runner, task: Task, folder: Path, error: str, call: int) -> int:
    """@return the exit code"""
    out = task.prepare(folder)
    done = task.run(runner, out, f"{error}:{call}")
    if done.returncode == 0:
        task.check(out)
        if task.words and done.stdout != task.words and "damaged " not in done.stdout:
            raise Failure("prints something else, and does not say why")
        return 0
    if done.returncode not in task.codes:
        raise Failure(f"ended with {done.returncode}: {done.stderr.strip()}")
    check_message(done.stderr, error)
    if task.go_on is not None:
        task.go_on(out)
        task.check(out)
    else:
        task.require_success(runner, out, task.again)
    return done.returncode


def disturb_calls(runner: Runner, task: Task, folder: Path, error: str, calls: int, at_most: int, tally: Tally) -> None:
    """@param at_most  calls, 0: all"""
    before = tally.failed
    codes: Counter[int] = Counter()

    def attempt(call: int) -> None:
        codes[disturb(runner, task, folder, error, call)] += 1

    tried = set(range(1, calls + 1))
    if 0 < at_most < calls:
        tried = {calls * (2 * k + 1) // (2 * at_most) + 1 for k in range(at_most)}
        tried |= set(range(1, FIRST_LOOKS + 1)) if error == "EIO" else set()
    for call in sorted(tried):
        tally.attempt(f"{task.name}, {error} at call {call} of {calls}", lambda: attempt(call))
    ends = ", ".join(f"exit code {code} {number} times" for code, number in sorted(codes.items()))
    print(f"{task.name}: {error} at {len(tried)} of {calls} calls: {ends}; {tally.failed - before} failed", flush=True)


def check_directory(expected: Path) -> Callable[[Path], None]:
    """Byte for byte."""

    def check(found: Path) -> None:
        ours, theirs = snapshot(found), snapshot(expected)
        if ours != theirs:
            raise Failure(f"{sorted(name for name in ours.keys() | theirs.keys() if ours.get(name) != theirs.get(name))} "
                          "differ from what they are without a fault")

    return check


def check_sweep(expected: Path) -> Callable[[Path], None]:
    def check(found: Path) -> None:
        for name in ("sweep.csv", "sweep.json", "points/deck.toml"):
            if (found / name).read_bytes() != (expected / name).read_bytes():
                raise Failure(f"{name} differs from what it is without a fault")
        for point in (expected / "points").iterdir():
            if point.is_dir():
                check_same_run(found / "points" / point.name, point)

    return check


def run_tasks(runner: Runner, folder: Path, form: str, case: Case) -> list[Task]:
    """A run, one that replaces another, and the second half of one."""
    same = lambda out: check_same_run(out, case.whole)  # noqa: E731
    run = ["run", str(case.deck), "--out", "{out}", "--quiet"]
    other = make_case(runner, folder / f"other-{form}", form, 3, 6, 5)
    _, resume = commands(runner, case, folder / f"half-{form}")
    resumed = Task(f"resume, {form}", ["resume", "{out}", "--quiet"], (INPUT_ERROR, OUTPUT_ERROR, CHECKPOINT_ERROR), same,
                   found=resume.killed)
    return [Task(f"run, {form}", run, (DECK_ERROR, OUTPUT_ERROR), same,
                 go_on=lambda out: begin_or_go_on(runner, out, case)),
            Task(f"run --force, {form}", [*run, "--force"], (DECK_ERROR, OUTPUT_ERROR), same, found=other.whole),
            resumed, interrupted_replacement(resumed, other.whole, folder / f"replacing-{form}")]


def interrupted_replacement(run: Task, earlier: Path, folder: Path) -> Task:
    """A run with its first checkpoint, killed before the run that it replaces was removed, which must not come back."""
    assert run.found is not None
    shutil.copytree(run.found, folder)
    max(folder.glob("checkpoint.?"), key=lambda path: path.stat().st_mtime_ns).unlink()
    shutil.copytree(earlier, folder / ".ljmd-earlier")
    return replace(run, name=f"{run.name}, another set aside", found=folder)


def begin_or_go_on(runner: Runner, out: Path, case: Case) -> None:
    if out.exists():
        runner.go_on(out, case.deck, kill_again=False)
    else:
        runner.finish(runner.start(["run", str(case.deck), "--out", str(out)]), (0,))


def undisturbed(runner: Runner, task: Task, folder: Path) -> Path:
    """What the task leaves without a fault, where it will be disturbed, as some files name their directory. What it
    prints then are its words."""
    out = task.prepare(folder / "disturbed")
    task.words = task.require_success(runner, out)
    return Path(shutil.copytree(out, folder / f"expected-{task.name.replace(' ', '-')}"))


def other_tasks(runner: Runner, folder: Path, cases: dict[str, Case]) -> list[Task]:
    """What reads a run, and what starts runs."""
    reading = (INPUT_ERROR, OUTPUT_ERROR)
    anything = lambda out: None  # noqa: E731
    run = str(cases["h5md"].whole)
    tasks = [Task(f"analyze, {form}", ["analyze", str(cases[form].whole), "rdf", "msd", "--out", "{out}"], reading,
                  anything, again=["--force"]) for form in ("h5md", "xyz")]
    tasks += [Task(f"export --to {target}", ["export", run, "--to", target, "--out", "{out}", "--quiet"],
                   (DECK_ERROR, *reading), anything, again=["--force"]) for target in ("lammps", "extxyz", "h5md")]
    tasks.append(Task("info", ["info", "{out}"], reading, anything, found=cases["xyz"].whole))
    sweep = Task("sweep", ["sweep", str(cases["xyz"].deck), "--grid", "system.temperature=1|1.1", "--jobs", "1",
                           "--out", "{out}", "--quiet"], (DECK_ERROR, *reading, POINTS_FAILED, NO_ROOM), anything)
    sweep.check = check_sweep(undisturbed(runner, sweep, folder))
    tasks.append(Task("info of a sweep", ["info", "{out}"], reading, anything, found=folder / "expected-sweep"))
    table = ["reproduce", "verlet1967", "--quick", "--rows", "0.45:1.552", "--jobs", "1", "--out"]
    runner.finish(runner.start([*table, str(folder / "table")]), (0,))
    tasks.append(Task("reproduce, from finished rows", [*table, "{out}", "--quiet"], (*reading, POINTS_FAILED), anything,
                      found=folder / "table"))
    for task in tasks:
        task.check = check_directory(undisturbed(runner, task, folder))
    return [*tasks, sweep]


def tests(runner: Runner, folder: Path, tally: Tally, at_most: int) -> None:
    cases = {form: make_case(runner, folder / f"short-{form}", form, 6, 12, 5) for form in FORMATS}
    tasks = [task for form in FORMATS for task in run_tasks(runner, folder, form, cases[form])]
    disturbed = folder / "disturbed"
    disturbed.mkdir()
    tasks += other_tasks(runner, folder, cases)
    seen: Counter[str] = Counter()
    for task in tasks:
        out = task.prepare(disturbed)
        task.run(runner, out, f"count:{folder / 'numbers'}")
        counts = read_counts(folder / "numbers")
        seen.update(counts)
        for error in ERRORS:
            disturb_calls(runner, task, disturbed, error, counts[error], at_most, tally)
        if at_most > 0 and task.name.startswith(MAY_COST_A_RUN):
            disturb_calls(runner, task, disturbed, "look", counts["look"], 0, tally)
    if never := [kind for kind, number in seen.items() if number == 0 and kind not in UNSEEN]:
        tally.fail("calls", f"none of {', '.join(never)} was seen, so that faults of them test nothing")


if __name__ == "__main__":
    sys.exit(run_tests(sys.argv[1:], "Let calls to the file system fail, and look what becomes of it.", tests,
                       NumberOption("--calls", 1, "to disturb, for each command and error; 0: all")))
