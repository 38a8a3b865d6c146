"""Any other program, by a small file that says how to call it and where its answer is (`--engine FILE` of harness.py).

    name      = "my engine"
    precision = "double"                              # or "mixed": forces in single precision
    command   = "./engine --data {start} --steps {steps} --threads {threads}"
    rate      = 'rate (\\S+) M'                        # regular expressions for what it prints; the group is the number
    unit      = 1e6                                   # of the rate [atom-steps/s]; 1 by default
    potential_energy_initial = '^step 0 .*U/N (\\S+)'  # per atom, in reduced units
    potential_energy_final   = '^last .*U/N (\\S+)'
    total_energy_final       = '^last .*E/N (\\S+)'
    note      = "starts from velocities of its own"   # what is not as in the other programs
    policies  = ["fixed"]                             # lists that it can keep: fixed, strict; both by default
    version   = "./engine --version"                  # a command whose first line names version and build

Of several matches the last one counts. In the command stand, in braces: {start} (the start as a data file of LAMMPS),
{atoms}, {cells} (cubic cells of four atoms along an edge), {steps}, {threads}, {cutoff}, {skin}, {every} (steps that a
list is kept, of the policy fixed), {time_step}, {thermo_every}, {density}, {temperature}. No shell reads the command. A
program is called by its name on the PATH, by an absolute path, or by one that begins with a dot, from the folder of the
adapter.
"""

from __future__ import annotations

import re
import shlex
import shutil
from pathlib import Path
from typing import Any, Optional

import workload
from ljmd.errors import InputError
from ljmd.reading import decks
from programs import Measurement, Program, ProgramFailed, execute
from workload import Case

PATTERNS = ("rate", "potential_energy_initial", "potential_energy_final", "total_energy_final")
WORDS = ("name", "precision", "command", *PATTERNS)
OPTIONAL = {"note": str, "version": str, "unit": (int, float), "policies": list}


class Foreign(Program):
    """A program that an adapter describes."""

    def __init__(self, file: Path):
        """Raises InputError for an adapter that is missing or makes no sense."""
        self.file = file
        self.adapter = decks.read(file)
        self.check_adapter()
        self.name = self.adapter["name"]
        self.precision = self.adapter["precision"]
        self.note = self.adapter.get("note", "")

    def check_adapter(self) -> None:
        for key, value in self.adapter.items():
            if key not in WORDS and key not in OPTIONAL:
                raise InputError(f"{self.file}: unknown key '{key}', known: {', '.join([*WORDS, *OPTIONAL])}")
            if not isinstance(value, OPTIONAL.get(key, str)):
                raise InputError(f"{self.file}: {key} has the wrong type: {value!r}")
        for key in WORDS:
            if not self.adapter.get(key):
                raise InputError(f"{self.file}: '{key}' is missing")
        if self.adapter["precision"] not in ("double", "mixed"):
            raise InputError(f"{self.file}: precision is double or mixed, not '{self.adapter['precision']}'")
        for policy in self.adapter.get("policies", []):
            if policy not in workload.POLICIES:
                raise InputError(f"{self.file}: policies are {', '.join(workload.POLICIES)}, not {policy!r}")
        for key in PATTERNS:
            try:
                groups = re.compile(self.adapter[key]).groups
            except re.error as error:
                raise InputError(f"{self.file}: {key} is no regular expression: {error}") from None
            if groups != 1:
                raise InputError(f"{self.file}: {key} needs one group, for the number; it has {groups}")
        try:
            self.words(self.adapter["command"], **self.values(workload.melt(108), "start", 1, 1))
        except (KeyError, IndexError, ValueError) as error:
            raise InputError(f"{self.file}: the command cannot be used: {error!r}; {Path(__file__).name} says what may "
                             "stand in braces") from None

    @staticmethod
    def values(start: workload.Configuration, data: Any, steps: int, threads: int) -> dict[str, Any]:
        """What the command's braces stand for."""
        return {"start": data, "atoms": start.atoms, "cells": workload.cells_of(start.atoms), "steps": steps,
                "threads": threads, "cutoff": workload.CUTOFF, "skin": workload.SKIN, "every": workload.REBUILD_EVERY,
                "time_step": workload.TIME_STEP, "thermo_every": workload.THERMO_EVERY, "density": workload.DENSITY,
                "temperature": workload.TEMPERATURE}

    def words(self, command: str, **values: Any) -> list[str]:
        """The words of a command; a program beside the adapter by its whole path."""
        found = [word.format(**values) for word in shlex.split(command)]
        if found[0].startswith("."):
            found[0] = str((self.file.parent / found[0]).resolve())
        return found

    def identify(self) -> Optional[dict[str, Any]]:
        command = self.words(self.adapter["command"], **self.values(workload.melt(108), "start", 1, 1))
        if not shutil.which(command[0]):
            return None
        if "version" not in self.adapter:
            return {"adapter": self.file.name}
        try:
            said = execute(self.words(self.adapter["version"]), self.file.resolve().parent)
        except ProgramFailed:
            return None
        return {"version": (said.splitlines() or [""])[0]}

    def prepare(self, case: Case) -> None:
        if case.policy not in self.adapter.get("policies", workload.POLICIES):
            raise ProgramFailed(f"it has no lists of the policy {case.policy}")
        case.file("start.data", workload.write_lammps_data)

    def run(self, case: Case, steps: int, threads: int) -> Measurement:
        values = self.values(case.configuration, case.folder / "start.data", steps, threads)
        said = execute(self.words(self.adapter["command"], **values), case.folder, OMP_NUM_THREADS=str(threads))
        rate, initial, final, total = (self.number(key, said) for key in PATTERNS)
        rate *= self.adapter.get("unit", 1.0)
        if not rate > 0.0:
            raise ProgramFailed(f"{self.name}: a rate of {rate}")
        return Measurement(steps, case.atoms * steps / rate, rate, initial, final, total)

    def number(self, key: str, said: str) -> float:
        found = re.findall(self.adapter[key], said, re.M)
        if not found:
            raise ProgramFailed(f"{self.name}: {key} is not in what it printed: no match of {self.adapter[key]}")
        try:
            return float(found[-1])
        except ValueError:
            raise ProgramFailed(f"{self.name}: {key} is no number: {found[-1]}") from None
