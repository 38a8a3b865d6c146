"""What `ljmd compare` has left: its checks and, where it compared that, trajectories, averages and g(r)."""

from __future__ import annotations

import math
from dataclasses import dataclass
from pathlib import Path
from typing import Any, Optional

import numpy as np

from ..errors import InputError
from .files import damaged, field, read_json
from .tables import Table, read_table

RDF_COLUMNS = ("r", "g_ljmd", "g_ljmd_standard_error", "g_peer", "g_peer_standard_error")
BESIDE_PAIRINGS = ("step", "time", "potential_energy_difference", "kinetic_energy_difference")
GSL_ERRORS = ("position_error", "velocity_error", "energy_error", "angular_momentum_error")


@dataclass(frozen=True)
class Check:
    """A number that tells how far two programs are apart, and how far they may be; NaN where ljmd had no number."""

    name: str
    value: float
    tolerance: float
    passed: bool


@dataclass(frozen=True)
class Average:
    """Means of one observable in both programs, with their standard errors."""

    name: str
    ours: tuple[float, float]
    theirs: tuple[float, float]

    @property
    def error(self) -> float:
        """Standard error of the difference."""
        return math.hypot(self.ours[1], self.theirs[1])

    @property
    def difference(self) -> float:
        return self.ours[0] - self.theirs[0]


@dataclass(frozen=True)
class FluidComparison:
    """What one comparison left behind; None and empty where it did not compare that."""

    program: str  # openmm, lammps, or engine: one of the user, that was judged
    deck: str
    peer: str  # name and version
    peer_of_long_runs: str
    checks: list[Check]
    time_step: float
    rate: Optional[float]  # lambda of exp(lambda t) [1/tau], of the first pairing
    trajectory: Optional[Table]
    averages: list[Average]
    rdf: Optional[Table]

    @property
    def pairings(self) -> list[str]:
        return [name for name in self.trajectory or {} if name not in BESIDE_PAIRINGS]

    def check(self, name: str) -> Optional[Check]:
        return next((check for check in self.checks if check.name == name), None)


def load(directory: Path, program: str) -> FluidComparison:
    """Read and check one comparison. The JSON says what was compared: a table of another time is not read."""
    path = directory / f"compare-{program}.json"
    record = read_json(path)
    trajectory = field(path, record, "trajectory", dict, default={})
    averages = field(path, record, "averages", dict, default={})
    peer = field(path, record, "peer", str)
    frames = field(path, averages, "rdf_configurations", int, default=0)
    rdf = directory / f"compare-{program}-rdf.csv"
    comparison = FluidComparison(
        program=program,
        deck=field(path, record, "deck", str),
        peer=peer,
        peer_of_long_runs=field(path, record, "peer_of_long_runs", str, default=peer),
        checks=[read_check(path, entry) for entry in field(path, record, "checks", list)],
        time_step=float(field(path, trajectory, "time_step", float, default=math.nan)),
        rate=field(path, trajectory, "divergence_rate", float, default=None),
        trajectory=read_trajectory(directory / f"compare-{program}-trajectory.csv") if trajectory else None,
        averages=read_averages(path, averages) if averages else [],
        rdf=read_table(rdf, RDF_COLUMNS, increasing=("r",)) if frames > 0 else None,
    )
    if comparison.trajectory is None and not comparison.averages:
        raise InputError(f"{path}: neither trajectories nor averages were compared, there is nothing to draw")
    return comparison


def load_judgement(directory: Path) -> FluidComparison:
    """What `ljmd compare` has found of an engine of the user, from judge.json."""
    path = directory / "judge.json"
    record = read_json(path)
    trajectory = field(path, record, "trajectory", dict, default={})
    steps = field(path, trajectory, "steps", list, default=[])
    averages = field(path, record, "averages", dict, default={})
    peer = field(path, record, "peer", str)

    def column(name: str) -> np.ndarray:
        return np.array([float(field(path, step, name, float, default=math.nan)) for step in steps])

    comparison = FluidComparison(
        program="engine",
        deck=field(path, record, "deck", str),
        peer=peer,
        peer_of_long_runs=peer,
        checks=[read_check(path, entry) for entry in field(path, record, "checks", list)],
        time_step=float(field(path, trajectory, "time_step", float, default=math.nan)),
        rate=None,
        trajectory={"time": column("time"), "ljmd - the engine": column("distance")} if steps else None,
        averages=read_averages(path, averages) if field(path, averages, "observables", dict, default={}) else [],
        rdf=None,
    )
    if comparison.trajectory is None and not comparison.averages:
        raise InputError(f"{path}: neither a trajectory nor averages were judged, there is nothing to draw")
    return comparison


def read_check(path: Path, entry: Any) -> Check:
    return Check(
        name=field(path, entry, "name", str),
        value=float(field(path, entry, "value", float, default=math.nan)),
        tolerance=float(field(path, entry, "tolerance", float)),
        passed=field(path, entry, "passed", bool),
    )


def read_trajectory(path: Path) -> Table:
    table = read_table(path, BESIDE_PAIRINGS, increasing=("step", "time"))
    pairings = [name for name in table if name not in BESIDE_PAIRINGS]
    if not pairings:
        raise damaged(path, "line 1: no column with distances")
    nameless = [name for name in pairings if " - " not in name]
    if nameless:
        raise damaged(path, f"line 1: column '{nameless[0]}' is no pair 'OURS - THEIRS'")
    return table


def read_averages(path: Path, record: dict[str, Any]) -> list[Average]:
    return [
        Average(name, *(read_estimate(path, field(path, entry, side, dict)) for side in ("ljmd", "peer")))
        for name, entry in field(path, record, "observables", dict).items()
    ]


def read_estimate(path: Path, entry: dict[str, Any]) -> tuple[float, float]:
    mean, error = (float(field(path, entry, name, float, default=math.nan)) for name in ("mean", "standard_error"))
    return mean, error


def load_gsl(directory: Path) -> tuple[str, Table]:
    """Of few bodies against an adaptive solution (GSL): the name of the deck, and the errors against time."""
    path = directory / "compare-gsl.json"
    deck = field(path, read_json(path), "deck", str)
    return deck, read_table(directory / "compare-gsl.csv", ("time", *GSL_ERRORS, "reference_error"), increasing=("time",))
