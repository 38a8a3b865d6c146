"""What a program has to offer to be timed, and how programs are called."""

from __future__ import annotations

import os
import subprocess
from abc import ABC, abstractmethod
from dataclasses import dataclass, field
from itertools import takewhile
from pathlib import Path
from typing import Any, Optional, Sequence

from workload import Case


class ProgramFailed(Exception):
    """A program that could not be run, or whose answer could not be read: one line that says which and why."""


@dataclass(frozen=True)
class Measurement:
    """What one run found. Energies are per atom; `rate` is in atom-steps a second of the time loop alone."""

    steps: int
    seconds: float
    rate: float
    potential_energy_initial: float
    potential_energy_final: float
    total_energy_final: float
    details: dict[str, Any] = field(default_factory=dict)


class Program(ABC):
    """A molecular dynamics program, in one way of running it."""

    name: str
    precision: str  # of positions and forces: double, or mixed (forces in single precision)
    note = ""  # what is not as in the other programs

    def tolerance(self, atoms: int) -> float:
        """Largest relative error of the potential energy of the start that the program's arithmetic explains."""
        return 1e-9 if self.precision == "double" else 1e-6

    @abstractmethod
    def identify(self) -> Optional[dict[str, Any]]:
        """Version and build, or None where the program is not installed."""

    @abstractmethod
    def prepare(self, case: Case) -> None:
        """Write the input files of a case. Raises ProgramFailed."""

    @abstractmethod
    def run(self, case: Case, steps: int, threads: int) -> Measurement:
        """Run a prepared case. Raises ProgramFailed."""

    def check(self, case: Case, steps: int) -> Measurement:
        """As `run` on one thread; final energies are those after exactly `steps` steps."""
        return self.run(case, steps, 1)


def execute(command: Sequence[Any], folder: Path, typed: str = "", **variables: str) -> str:
    """Run a command in a folder and return what it wrote to stdout.

    `typed` is its stdin. Variables of OpenMP but OMP_WAIT_POLICY are taken out of its environment, then `variables` put
    in. Raises ProgramFailed if it cannot be run or fails, with the last words that it wrote.
    """
    environment = {name: value for name, value in os.environ.items()
                   if not name.startswith("OMP_") or name == "OMP_WAIT_POLICY"}
    words = [str(word) for word in command]
    try:
        done = subprocess.run(words, cwd=folder, input=typed, capture_output=True, text=True, check=False,
                              env={**environment, **variables}, errors="replace")
    except OSError as error:
        raise ProgramFailed(f"{words[0]}: cannot be run: {error.strerror}") from None
    if done.returncode != 0:
        raise ProgramFailed(f"{' '.join(words)}: exit code {done.returncode}: {last_words(done.stdout + done.stderr)}")
    return done.stdout


def last_words(text: str) -> str:
    """Of what a program that failed has written: the paragraph that calls itself fatal, as GROMACS does before it says
    where to read more, or else the last line with a letter in it."""
    lines = [line.strip() for line in text.splitlines()]
    fatal = [number for number, line in enumerate(lines) if line.lower().startswith("fatal error:")]
    if fatal:
        return " ".join(takewhile(bool, lines[fatal[-1] :]))
    said = [line for line in lines if any(map(str.isalpha, line))]
    return said[-1] if said else "no word"
