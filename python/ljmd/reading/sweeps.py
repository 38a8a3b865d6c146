"""The directory of a sweep: sweep.json says what was asked for, sweep.csv has all numbers once it has come to its end, and
before that its points have them."""

from __future__ import annotations

import math
from dataclasses import dataclass, field as member
from pathlib import Path
from typing import Any, Optional, Sequence

import numpy as np

from ..errors import DataError
from .files import damaged, field, is_there, read_json, read_text
from .observables import Observable, all_of
from .tables import Table, TextColumns, checked_numbers, rows_of

ERROR = "_standard_error"
REMARKS = "remarks"  # the column of sweep.csv that is no number


@dataclass(frozen=True)
class Request:
    """What sweep.json asks for: points with the values of the varied keys, as texts of --set."""

    directory: Path
    keys: list[str]
    names: list[str]
    values: list[list[str]]
    replicas: bool  # runs of one deck, whose seeds alone differ

    def folder(self, name: str) -> Path:
        """Where the run of a point is."""
        return self.directory / "points" / name


@dataclass(frozen=True)
class Point:
    """What a point has found that has come to its end."""

    title: str
    density: float  # measured under a barostat, else that of the box; NaN of few bodies
    equation_of_state: Optional[str]
    observables: dict[str, Observable]  # by the names of columns of sweep.csv


@dataclass(frozen=True)
class SweepTable:
    """A sweep by columns: of the varied keys their values as texts, of the observables numbers, NaN where there are none."""

    keys: TextColumns
    observables: Table
    title: str = ""
    status: str = ""  # how far a sweep has come that has not ended
    equations: list[Optional[str]] = member(default_factory=list)  # of the fluid of each point; None: there is none
    densities: np.ndarray = member(default_factory=lambda: np.empty(0))  # of each point
    merged: Optional[dict[str, Observable]] = None  # of replicas: what all of them say; None of a sweep


def read_request(directory: Path) -> Request:
    """Raises DataError where the directory holds no sweep, or sweep.json is damaged."""
    path = directory / "sweep.json"
    if not is_there(path):
        raise DataError(f"{directory} holds no sweep: it has no sweep.json")
    data = read_json(path)
    points = field(path, data, "points", list)
    keys = field(path, data, "keys", list)
    values = [[str(value) for value in field(path, point, "values", list)] for point in points]
    if any(len(row) != len(keys) for row in values):
        raise damaged(path, f"a point without a value for each of {', '.join(map(str, keys))}")
    return Request(directory, [str(key) for key in keys], [field(path, point, "name", str) for point in points], values,
                   "replicas" in data)


def read_point(request: Request, name: str) -> Optional[Point]:
    """The results of a point; None before it has any."""
    path = request.folder(name) / "results.json"
    if not is_there(path):
        return None
    results = read_json(path)
    found = all_of(path, results)
    return Point(field(path, results, "title", str, default=""), density_of(path, results, found),
                 field(path, results, "equation_of_state", str, default=None), found)


def density_of(path: Path, results: dict[str, Any], found: dict[str, Observable]) -> float:
    if "density" in found and math.isfinite(found["density"].mean):
        return found["density"].mean
    return float(field(path, field(path, results, "system", dict, default={}), "density", float, default=math.nan))


def load(directory: Path) -> SweepTable:
    """The table of a sweep or, where it has not come to its end, what the points say that have."""
    request = read_request(directory)
    points = [read_point(request, name) for name in request.names]
    status = ""
    if is_there(directory / "sweep.csv"):
        columns, observables = read_csv(directory / "sweep.csv", request.keys)
    else:
        columns, observables = columns_of(request, points)
        done = sum(one is not None for one in points)
        status = "" if done == len(points) else f"the sweep has not come to its end: {done} of {len(points)} points"
        if done == 0:
            raise damaged(directory, "no point has come to its end yet")
    merged: Optional[dict[str, Observable]] = None
    if request.replicas:
        columns = {"replica": [str(number + 1) for number in range(len(points))]}  # their seeds are no axis
        together = directory / "results.json"
        merged = all_of(together, read_json(together)) if is_there(together) else {}
    fitting = len(points) == len(next(iter(columns.values()), []))  # else the table is of another sweep
    return SweepTable(
        columns, observables, next((one.title for one in points if one), "") or directory.resolve().name, status,
        [one.equation_of_state if one else None for one in points] if fitting else [],
        np.array([one.density if one else math.nan for one in points]) if fitting else np.empty(0),
        merged,
    )


def columns_of(request: Request, points: Sequence[Optional[Point]]) -> tuple[TextColumns, Table]:
    """The columns that sweep.csv will have."""
    keys = {key: [row[k] for row in request.values] for k, key in enumerate(request.keys)}
    observables: Table = {}
    for row, point in enumerate(points):
        for name, found in ({} if point is None else point.observables).items():
            for column, number in ((name, found.mean), (name + ERROR, found.error)):
                if math.isfinite(number):
                    observables.setdefault(column, np.full(len(points), math.nan))[row] = number
    return keys, observables


def read_csv(path: Path, keys: Sequence[str]) -> tuple[TextColumns, Table]:
    """sweep.csv."""
    header, rows = rows_of(path, read_text(path))
    if header[: len(keys)] != list(keys):
        raise damaged(path, f"does not begin with the keys of sweep.json, {', '.join(keys)}")
    if not rows:
        raise damaged(path, "no rows below the header")
    kept = [k for k in range(len(keys), len(header)) if header[k] != REMARKS]
    numbers = checked_numbers(path, [header[k] for k in kept], [[row[k] for k in kept] for row in rows])
    return ({key: [row[k] for row in rows] for k, key in enumerate(keys)},
            {header[k]: numbers[:, column] for column, k in enumerate(kept)})
