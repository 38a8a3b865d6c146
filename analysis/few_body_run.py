"""Reading a run directory of a few-body system. All quantities are in the units that its deck chose."""

from __future__ import annotations

from dataclasses import dataclass, replace
from pathlib import Path
from typing import Optional

import numpy as np
import trajectory
import unfinished_run
from checked_files import RunDirectoryError, Table, damaged, field, read_json, read_table
from run_directory import has_ended, kind_of, status_of
from trajectory import Trajectory
from unfinished_run import System

THERMO_COLUMNS = ("step", "time", "potential_energy", "kinetic_energy", "total_energy")


@dataclass(frozen=True)
class FewBodyRun:
    """What one run of a few-body system left behind."""

    path: Path
    title: str
    force: str  # newtonian-gravity, radial-kepler, pendulum, ...
    bodies: int
    dimensions: int
    thermo: Table  # energies, momenta and angular momenta of the whole system
    trajectory: Optional[Trajectory]  # None when the run wrote none
    status: str = ""  # how far a run has come that has not ended

    def name(self, body: int) -> str:
        """How a body, counted from 0, is called: decks count from 1."""
        return f"body {body + 1}"

    @property
    def coordinate(self) -> tuple[str, str]:
        """Symbols of the first coordinate and of its velocity."""
        symbols = {"radial-kepler": (r"$\rho$", r"$v_\rho$"), "pendulum": (r"$\theta$", r"$\omega$")}
        return symbols.get(self.force, ("$x$", "$v_x$"))


def load(path: Path) -> FewBodyRun:
    """Read and check the directory of a few-body run.

    Raises RunDirectoryError, with exit code 2 when `path` is no such directory, 3 when a file is missing or damaged.
    """
    if kind_of(path) != "few-body":
        raise RunDirectoryError(f"{path}: a run of a fluid, a few-body system is needed", exit_code=2)
    record = read_json(path / "run.json")
    ended = has_ended(path)
    system = system_in_results(path / "results.json") if ended else unfinished_run.system(path)
    thermo = read_table(path / "thermo.csv", THERMO_COLUMNS, increasing=("step",), growing=not ended)
    run = FewBodyRun(
        path=path,
        title=field(path / "run.json", record, "title", str, default=""),
        force=system.force,
        bodies=system.bodies,
        dimensions=system.dimensions,
        thermo=thermo,
        trajectory=trajectory.read(path, growing=not ended),
        status="" if ended else status_of(path, thermo["step"][-1], unfinished_run.stages(path)),
    )
    return run if run.trajectory is None else replace(run, trajectory=fitted(run, run.trajectory))


def system_in_results(path: Path) -> System:
    """The system, as results.json has it."""
    system = field(path, read_json(path), "system", dict)
    return System(
        force=field(path, system, "force", str),
        bodies=field(path, system, "bodies", int),
        dimensions=field(path, system, "dimensions", int),
    )


def fitted(run: FewBodyRun, frames: Trajectory) -> Trajectory:
    """The frames, checked against the run, in as many dimensions as it has: H5MD and XYZ always have three."""
    _, bodies, dimensions = frames.positions.shape
    if bodies != run.bodies or dimensions < run.dimensions:
        found = f"{bodies} bodies in {dimensions} dimensions"
        raise damaged(run.path, f"the trajectory has {found}, the run has {run.bodies} in {run.dimensions}")
    velocities = None if frames.velocities is None else frames.velocities[:, :, : run.dimensions]
    return replace(frames, positions=frames.positions[:, :, : run.dimensions], velocities=velocities)


def plane_points(run: FewBodyRun) -> Optional[np.ndarray]:
    """Where the bodies are in the x-y plane (F, N, 2); None where the coordinates do not lie in a plane.

    Three dimensions are projected along z. The distance and the angle of one body become a point, and so do the angles
    of pendulums of length 1, which hang down at 0.
    """
    frames = run.trajectory
    if frames is None:
        return None
    if frames.positions.shape[2] >= 2:
        return frames.positions[:, :, :2]
    first = frames.positions[:, :, 0]
    if run.force == "radial-kepler" and frames.angle is not None and run.bodies == 1:
        angle = frames.angle[:, np.newaxis]
        return np.stack([first * np.cos(angle), first * np.sin(angle)], axis=2)
    if run.force == "pendulum":
        return np.stack([np.sin(first), -np.cos(first)], axis=2)
    return None


def phase_points(run: FewBodyRun) -> Optional[np.ndarray]:
    """First coordinate and its velocity, for each body (F, N, 2); None without velocities."""
    frames = run.trajectory
    if frames is None or frames.velocities is None:
        return None
    return np.stack([frames.positions[:, :, 0], frames.velocities[:, :, 0]], axis=2)


def body_index(run: FewBodyRun, number: int) -> int:
    """The index of body `number`, counted from 1; an error with exit code 2 when there is no such body."""
    if not 1 <= number <= run.bodies:
        raise RunDirectoryError(f"there is no body {number}: {run.path} has {run.bodies}", exit_code=2)
    return number - 1


def relative(points: np.ndarray, body: int) -> np.ndarray:
    """Points of all bodies (F, N, ...) as seen from one of them."""
    return points - points[:, body : body + 1]
