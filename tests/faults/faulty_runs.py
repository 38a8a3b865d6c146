"""What tests of runs that are disturbed share: small decks, a preloaded library of faults, the comparison of two runs.

All files of a run that was disturbed and resumed must be byte for byte what they are without, times and provenance
excepted. A run that has written a checkpoint must not begin again.
"""

from __future__ import annotations

import argparse
import json
import os
import random
import shutil
import signal
import subprocess
import sys
import tempfile
import time
from dataclasses import dataclass
from pathlib import Path
from typing import Callable, Optional

sys.path.insert(0, str(Path(__file__).resolve().parents[1] / "cli"))

from harness import DECK, STARS, Failure, check_same_run, replaced  # noqa: E402
import keeper  # noqa: E402
import waiting  # noqa: E402

# seconds; what cannot be read within them is taken for a file without frames, which lets a test ask for less
PATIENCE_OF_HDF5 = 60

TABLES = """trajectory = {{ format = "{format}", every = 3{velocities} }}
checkpoint = {{ every = {checkpoint} }}
[analysis]
{analysis}
"""

FORMATS = ("h5md", "xyz", "csv")


@dataclass
class Case:
    """A deck and its run in one piece."""

    deck: Path
    whole: Path


def deck_text(form: str, equilibrate: int, production: int, checkpoint: int, cells: int = 3) -> str:
    """A deck of the command-line tests with a trajectory, checkpoints and an analysis."""
    if form == "csv":
        base = replaced(STARS, ("steps = 100", f"steps = {production}"), ("every = 10", "every = 2"))
        velocities, analysis = "", "orbit = { body = 1, about = 2 }"
    else:
        base = replaced(DECK, ("cells = 3", f"cells = {cells}"), ("steps = 20", f"steps = {equilibrate}"),
                        ("steps = 40", f"steps = {production}"), ("thermo = { every = 5 }", "thermo = { every = 2 }"))
        velocities, analysis = ", velocities = true", "rdf = { bins = 20, every = 4 }"
    return base + TABLES.format(format=form, velocities=velocities, checkpoint=checkpoint, analysis=analysis)


def frames_on_disk(directory: Path) -> int:
    path = directory / "trajectory.h5md"
    if not path.exists():
        return -1
    # HDF5 waits, practically for ever, for the writer to mend a half-written piece: another process can be left alone.
    count = ("import h5py, sys; file = h5py.File(sys.argv[1], 'r', libver='latest', swmr=True); "
             "print(file['particles/trajectory/position/value'].shape[0])")
    try:
        found = subprocess.run([sys.executable, "-c", count, str(path)], capture_output=True, text=True, timeout=PATIENCE_OF_HDF5)
    except subprocess.TimeoutExpired:
        return -1
    return int(found.stdout) if found.returncode == 0 else -1  # not yet a file: nothing was written that counts


class Runner:
    def __init__(self, program: Path, library: Path, random_source: random.Random, every: int) -> None:
        self.program = program
        self.interpreter = [sys.executable] if program.suffix == ".py" else []
        self.library = library
        self.random = random_source
        self.every = every  # of the calls that can be disturbed this many-th is

    def environment(self, fault: Optional[str], folder: Optional[Path] = None) -> dict[str, str]:
        """@param folder  the one that a power cut is felt in"""
        environment = dict(os.environ)
        if fault is not None:
            environment["LD_PRELOAD"] = str(self.library)
            environment["LJMD_FAULT"] = fault
            environment["LJMD_FAULT_FOLDER"] = str(folder or "")
            # The address sanitizer, where the program is built with it, need not be the first of its libraries; and
            # HDF5 loses some memory when a file cannot be closed.
            environment["ASAN_OPTIONS"] = ":".join(filter(None, [environment.get("ASAN_OPTIONS"),
                                                                 "verify_asan_link_order=0", "detect_leaks=0"]))
        return environment

    def start(self, arguments: list[str], fault: Optional[str] = None, folder: Optional[Path] = None) -> subprocess.Popen:
        return subprocess.Popen([*self.interpreter, str(self.program), *arguments, "--quiet"], env=self.environment(fault, folder),
                                stdout=subprocess.DEVNULL, stderr=subprocess.PIPE, text=True)

    def finish(self, process: subprocess.Popen, allowed: tuple[int, ...]) -> int:
        _, talk = process.communicate(timeout=waiting.PATIENCE)
        if process.returncode not in allowed:
            raise Failure(f"{process.args[1:]} ended with {process.returncode}: {talk.strip()}")
        return process.returncode

    def kill_after(self, process: subprocess.Popen, seconds: float) -> bool:
        """Whether it was killed, and had not ended before."""
        try:
            process.wait(timeout=seconds)
        except subprocess.TimeoutExpired:
            process.send_signal(signal.SIGKILL)
        return self.finish(process, (0, -signal.SIGKILL)) != 0

    def go_on(self, directory: Path, deck: Path, kill_again: bool) -> int:
        """Bring a run that was killed to its end. @return the last step at which it went on; -1: it began again"""
        while True:
            checkpoints = list(directory.glob("checkpoint.?"))
            if not checkpoints:
                # Killed before there was a checkpoint to resume from: it begins again, and nothing else is lost.
                if frames_on_disk(directory) > 1:
                    raise Failure("frames, but no checkpoint")
                self.finish(self.start(["run", str(deck), "--out", str(directory), "--force"]), (0,))
                return -1
            killed = False
            if kill_again and self.random.random() < 1 / 3:
                killed = self.kill_after(self.start(["resume", str(directory)]), self.random.uniform(0.0, 0.1))
            if not killed:
                self.finish(self.start(["resume", str(directory)]), (0,))
                record = json.loads((directory / "run.json").read_text())
                if not record["resumed_at_steps"]:
                    raise Failure("run.json does not tell where it went on")
                return record["resumed_at_steps"][-1]


def make_case(runner: Runner, folder: Path, form: str, equilibrate: int, production: int, checkpoint: int,
              cells: int = 3) -> Case:
    folder.mkdir()
    case = Case(folder / "deck.toml", folder / "whole")
    case.deck.write_text(deck_text(form, equilibrate, production, checkpoint, cells))
    runner.finish(runner.start(["run", str(case.deck), "--out", str(case.whole)]), (0,))
    return case


@dataclass
class Command:
    """`ljmd run`, or `ljmd resume` of a run that was killed: what the calls that are disturbed belong to."""

    name: str
    case: Case
    killed: Optional[Path] = None

    def prepare(self, folder: Path) -> tuple[list[str], Path]:
        """@return the arguments, and the directory of the run, made ready in the folder"""
        directory = folder / "out"
        shutil.rmtree(directory, ignore_errors=True)
        if self.killed is None:
            return ["run", str(self.case.deck), "--out", str(directory)], directory
        shutil.copytree(self.killed, directory)
        return ["resume", str(directory)], directory

    def count_calls(self, runner: Runner, folder: Path) -> int:
        """That change a file."""
        folder.mkdir(exist_ok=True)
        arguments, _ = self.prepare(folder)
        runner.finish(runner.start(arguments, f"count:{folder / 'numbers'}"), (0,))
        return read_counts(folder / "numbers")["changes"]


def read_counts(path: Path) -> dict[str, int]:
    """Calls of each kind, of those that change a file, and of those that may end with each error."""
    return {name: int(number) for name, number in (line.split() for line in path.read_text().splitlines())}


def commands(runner: Runner, case: Case, folder: Path) -> list[Command]:
    run = Command("run", case)
    half = 2 * run.count_calls(runner, folder) // 5  # of the steps: the end has more calls than the beginning
    arguments, directory = run.prepare(folder)
    runner.finish(runner.start(arguments, f"kill:{half}"), (-signal.SIGKILL,))
    if not list(directory.glob("checkpoint.?")):
        raise Failure("killed halfway, a run has no checkpoint")
    killed = folder / "killed"
    shutil.rmtree(killed, ignore_errors=True)
    directory.rename(killed)
    return [run, Command("resume", case, killed)]


def measure(runner: Runner, case: Case, directory: Path) -> float:
    begin = time.perf_counter()
    runner.finish(runner.start(["run", str(case.deck), "--out", str(directory), "--force"]), (0,))
    return time.perf_counter() - begin


class Tally:
    """Counts attempts, and prints those that failed."""

    def __init__(self) -> None:
        self.passed = self.failed = 0

    def attempt(self, what: str, action: Callable[[], None]) -> None:
        try:
            action()
            self.passed += 1
        except (Failure, subprocess.TimeoutExpired) as failure:
            self.fail(what, failure)

    def fail(self, what: str, why: object) -> None:
        self.failed += 1
        print(f"FAILED {what}: {why}", flush=True)

    def finish(self) -> int:
        """@return the exit code"""
        print(f"{self.passed} passed, {self.failed} failed")
        return 1 if self.failed or not self.passed else 0


@dataclass
class NumberOption:
    name: str
    default: int
    help: str


def run_tests(arguments: list[str], description: str, tests: Callable[[Runner, Path, Tally, int], None],
              option: Optional[NumberOption] = None) -> int:
    """Read the options, let the tests be made in a folder of their own, and tell how they went.

    @param option  whose number the tests get; 0 where there is none
    @return the exit code
    """
    parser = argparse.ArgumentParser(description=description)
    parser.add_argument("--ljmd", type=Path, required=True)
    parser.add_argument("--faults", type=Path, required=True, help="the library fault_at_call")
    parser.add_argument("--seed", type=int, default=1)
    parser.add_argument("--every", type=int, default=1, metavar="N", help="disturb only each N-th call: a sample")
    if option is not None:
        parser.add_argument(option.name, dest="number", type=int, default=option.default, help=option.help)
    options = parser.parse_args(arguments)
    runner = Runner(options.ljmd.resolve(), options.faults.resolve(), random.Random(options.seed),
                    options.every)

    def kept() -> int:
        tally = Tally()
        tests(runner, Path(tempfile.gettempdir()), tally, getattr(options, "number", 0))
        return tally.finish()

    return keeper.kept(kept)
