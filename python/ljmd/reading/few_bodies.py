"""The directory of a run of few bodies. All quantities are in the units that its deck chose."""

from __future__ import annotations

from dataclasses import dataclass, replace
from pathlib import Path
from typing import Optional

from ..errors import InputError
from . import decks, records, stages, trajectories
from .files import damaged, field
from .records import Record
from .tables import Table, read_table
from .trajectories import Trajectory

THERMO_COLUMNS = ("step", "time", "potential_energy", "kinetic_energy", "total_energy")


@dataclass(frozen=True)
class System:
    force: str  # newtonian-gravity, radial-kepler, pendulum, ...
    bodies: int
    dimensions: int


@dataclass(frozen=True)
class FewBodyRun:
    """What one run of a few-body system left behind."""

    path: Path
    title: str
    force: str
    bodies: int
    dimensions: int
    thermo: Table  # energies, momenta and angular momenta of the whole system
    trajectory: Optional[Trajectory]  # None when the run wrote none
    status: str = ""  # how far a run has come that has not ended

    def name(self, body: int) -> str:
        """How a body, counted from 0, is called: decks count from 1."""
        return f"body {body + 1}"


def load(path: Path) -> FewBodyRun:
    """Read and check the directory of a few-body run.

    Raises InputError when `path` is no such directory, DataError when a file is missing or damaged.
    """
    record = records.read(path)
    if record.kind != "few-body":
        raise InputError(f"{path}: a run of a fluid, a few-body system is needed")
    growing = not record.finished
    system = system_in_deck(record) if growing else system_in_results(record)
    thermo = read_table(path / "thermo.csv", THERMO_COLUMNS, increasing=("step",), growing=growing)
    status = ""
    if growing:
        status = records.status_of(record, thermo["step"][-1], stages.last_step(stages.in_deck(record)))
    frames = trajectories.read(path, growing=growing)
    return FewBodyRun(path, record.title, system.force, system.bodies, system.dimensions, thermo,
                      None if frames is None else fitted(path, system, frames), status)


def system_in_results(record: Record) -> System:
    """The system, as results.json has it."""
    path = record.path / "results.json"
    system = field(path, records.read_results(record), "system", dict)
    return System(
        force=field(path, system, "force", str),
        bodies=field(path, system, "bodies", int),
        dimensions=field(path, system, "dimensions", int),
    )


def system_in_deck(record: Record) -> System:
    """Force, bodies and coordinates of each body of a few-body deck."""
    tables = decks.of_run(record)
    bodies = field(record.file, tables, "body", list)
    if not bodies:
        raise damaged(record.file, "the deck has no bodies")
    return System(
        force=field(record.file, field(record.file, tables, "force", dict), "type", str),
        bodies=len(bodies),
        dimensions=len(field(record.file, bodies[0], "position", list)),
    )


def fitted(path: Path, system: System, frames: Trajectory) -> Trajectory:
    """The frames, checked against the system, in as many dimensions as it has: H5MD and XYZ always have three."""
    _, bodies, dimensions = frames.positions.shape
    if bodies != system.bodies or dimensions < system.dimensions:
        found = f"{bodies} bodies in {dimensions} dimensions"
        raise damaged(path, f"the trajectory has {found}, the run has {system.bodies} in {system.dimensions}")
    velocities = None if frames.velocities is None else frames.velocities[:, :, : system.dimensions]
    return replace(frames, positions=frames.positions[:, :, : system.dimensions], velocities=velocities)
