"""Reading a run directory of ljmd: thermo.csv, rdf.csv, results.json and run.json, checked as they are read.

What is here serves runs of a fluid; few_body_run.py reads those of few-body systems, trajectory.py trajectories. Plain
names are in reduced units (sigma = epsilon = m = k_B = 1), energies per atom; SI columns carry a suffix (temperature_K,
pressure_bar, time_ps, r_nm).
"""

from __future__ import annotations

from dataclasses import dataclass
from pathlib import Path
from typing import Optional

import numpy as np
import unfinished_run
from checked_files import RunDirectoryError, Table, damaged, field, has_values, read_json, read_table
from stage import Stage

THERMO_COLUMNS = (
    "step",
    "time",
    "temperature",
    "potential_energy",
    "kinetic_energy",
    "total_energy",
    "pressure",
)
RDF_COLUMNS = ("r", "g", "g_standard_error")
KINDS = ("fluid", "few-body")


@dataclass(frozen=True)
class Observable:
    """A mean and its standard error, both in `unit`; None where the run could not tell."""

    mean: Optional[float]
    standard_error: Optional[float]
    unit: str


@dataclass(frozen=True)
class RunDirectory:
    """What one run left behind. Columns are float arrays of equal length; an empty field is NaN."""

    path: Path
    title: str
    thermo: Table
    rdf: Optional[Table]  # None when the run has no rdf.csv, or no g(r) in it
    observables: dict[str, Observable]
    stages: list[Stage]
    status: str = ""  # how far a run has come that has not ended

    def rows_of(self, stage: Stage) -> np.ndarray:
        """Mask of the rows of thermo that belong to a stage."""
        step = self.thermo["step"]
        return (step >= stage.first_step) & (step <= stage.last_step)


def kind_of(path: Path) -> str:
    """Whether `path` holds a run of a fluid or of a few-body system, as its run.json says.

    Raises RunDirectoryError, with exit code 2 when `path` is no directory, 3 when run.json is missing or damaged.
    """
    if not path.is_dir():
        raise RunDirectoryError(f"{path}: {'not a directory' if path.exists() else 'no such directory'}", exit_code=2)
    record = read_json(path / "run.json")
    kind = field(path / "run.json", record, "kind", str, default="fluid")
    if kind not in KINDS:
        raise damaged(path / "run.json", f"'kind' is '{kind}', must be one of {', '.join(KINDS)}")
    return kind


def has_ended(path: Path) -> bool:
    """Whether the run in `path` has come to its end, as its run.json says; else it was stopped, has failed or goes on."""
    return field(path / "run.json", read_json(path / "run.json"), "finished", bool, default=True)


def status_of(path: Path, last_step: float, stages: list[Stage]) -> str:
    """How far a run in `path` has come that has not ended: it was stopped, has failed or goes on."""
    what = "blew up" if (path / "failed.xyz").exists() else "has not come to its end"
    steps = f" of {stages[-1].last_step}" if stages else ""
    return f"the run {what}: drawn up to step {last_step:.0f}{steps}"


def load(path: Path) -> RunDirectory:
    """Read and check the directory of a run of a fluid. A run that has not ended has no observables, and its stages are
    those of its deck.

    Raises RunDirectoryError, with exit code 2 when `path` is no such directory, 3 when a file is missing or damaged.
    """
    if kind_of(path) != "fluid":
        raise RunDirectoryError(f"{path}: a run of a few-body system, a fluid is needed", exit_code=2)
    record = read_json(path / "run.json")
    ended = has_ended(path)
    if ended:
        observables, stages = read_results(path / "results.json")
    else:
        observables, stages = {}, unfinished_run.stages(path)
    thermo = read_table(path / "thermo.csv", THERMO_COLUMNS, increasing=("step", "time"), growing=not ended)
    return RunDirectory(
        path=path,
        title=field(path / "run.json", record, "title", str, default=""),
        thermo=thermo,
        rdf=read_rdf(path / "rdf.csv"),
        observables=observables,
        stages=stages,
        status="" if ended else status_of(path, thermo["step"][-1], stages),
    )


def tables_of_analysis(path: Path, title: str = "") -> RunDirectory:
    """The tables that `ljmd analyze` wrote, as a run without observables and stages.

    Without a title it is the name of the run that the directory lies in, or else of the directory itself.
    """
    inside = path.resolve()
    title = title or (inside.parent.name if (inside.parent / "run.json").exists() else inside.name)
    return RunDirectory(path=path, title=title, thermo={}, rdf=read_rdf(path / "rdf.csv"), observables={}, stages=[])


def read_rdf(path: Path) -> Optional[Table]:
    """The columns of rdf.csv; None when there is no such file, or no g(r) in it."""
    if not path.exists():
        return None
    table = read_table(path, RDF_COLUMNS, increasing=("r",))
    return table if has_values(path, table, ("g",)) else None


def read_results(path: Path) -> tuple[dict[str, Observable], list[Stage]]:
    """The observables and the stages of results.json."""
    record = read_json(path)
    observables = {
        name: Observable(
            mean=field(path, entry, "mean", float, default=None),
            standard_error=field(path, entry, "standard_error", float, default=None),
            unit=field(path, entry, "unit", str, default=""),
        )
        for name, entry in field(path, record, "observables", dict).items()
    }
    stages = [
        Stage(
            name=field(path, entry, "name", str),
            first_step=field(path, entry, "first_step", int),
            last_step=field(path, entry, "last_step", int),
            sampled=field(path, entry, "sampled", bool),
            energy_drift=field(path, entry, "energy_drift", float, default=None),
        )
        for entry in field(path, record, "stages", list)
    ]
    return observables, stages
