"""The directory of a run of a fluid.

Plain names are in reduced units (sigma = epsilon = m = k_B = 1), energies per atom; SI columns carry a suffix
(temperature_K, pressure_bar, time_ps).
"""

from __future__ import annotations

from dataclasses import dataclass
from pathlib import Path

import numpy as np

from ..errors import InputError
from . import records, stages
from .files import is_there
from .observables import Observable, observables
from .stages import Stage
from .tables import Table, read_table

THERMO_COLUMNS = ("step", "time", "temperature", "potential_energy", "kinetic_energy", "total_energy", "pressure")


@dataclass(frozen=True)
class FluidRun:
    """What one run left behind. Columns are float arrays of equal length; an empty field is NaN."""

    path: Path
    title: str
    thermo: Table
    observables: dict[str, Observable]
    stages: list[Stage]
    status: str = ""  # how far a run has come that has not ended

    def rows_of(self, stage: Stage) -> np.ndarray:
        """Mask of the rows of thermo that belong to a stage."""
        step = self.thermo["step"]
        return (step >= stage.first_step) & (step <= stage.last_step)


def load(path: Path) -> FluidRun:
    """Read and check the directory of a run of a fluid. A run that has not ended has no observables, and its stages are
    those of its deck.

    Raises InputError when `path` is no such directory, DataError when a file is missing or damaged.
    """
    record = records.read(path)
    if record.kind != "fluid":
        raise InputError(f"{path}: a run of a few-body system, a fluid is needed")
    results = records.read_results(record) if record.finished else {}
    file = path / "results.json"
    found = stages.in_results(file, results) if record.finished else stages.in_deck(record)
    thermo = read_table(path / "thermo.csv", THERMO_COLUMNS, increasing=("step", "time"), growing=not record.finished)
    return FluidRun(
        path=path,
        title=record.title,
        thermo=thermo,
        observables=observables(file, results),
        stages=found,
        status="" if record.finished else records.status_of(record, thermo["step"][-1], stages.last_step(found)),
    )


def tables_of_analysis(path: Path, title: str = "") -> FluidRun:
    """The tables that `ljmd analyze` wrote, as a run without observables and stages.

    Without a title it is the name of the run that the directory lies in, or else of the directory itself.
    """
    inside = path.resolve()
    title = title or (inside.parent.name if is_there(inside.parent / "run.json") else inside.name)
    return FluidRun(path=path, title=title, thermo={}, observables={}, stages=[])
