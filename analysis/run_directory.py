"""Reading a run directory of ljmd: thermo.csv, rdf.csv, results.json and run.json, checked as they are read.

What is here serves runs of a fluid; few_body_run.py reads those of few-body systems, trajectory.py trajectories. Plain
names are in reduced units (sigma = epsilon = m = k_B = 1), energies per atom; SI columns carry a suffix (temperature_K,
pressure_bar, time_ps, r_nm).
"""

from __future__ import annotations

import csv
import functools
import json
import math
import sys
from dataclasses import dataclass
from pathlib import Path
from typing import Any, Callable, Optional, Sequence

import numpy as np

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

Table = dict[str, np.ndarray]


class RunDirectoryError(Exception):
    """A run directory that cannot be used: one line, and the exit code of ljmd that it stands for."""

    def __init__(self, message: str, exit_code: int):
        super().__init__(message)
        self.exit_code = exit_code


def reports_errors(main: Callable[[Optional[Sequence[str]]], int]) -> Callable[..., int]:
    """The main() of a script, which ends a RunDirectoryError as one line on stderr and its exit code."""

    @functools.wraps(main)
    def guarded(arguments: Optional[Sequence[str]] = None) -> int:
        try:
            return main(arguments)
        except RunDirectoryError as error:
            print(f"error: {error}", file=sys.stderr)
            return error.exit_code

    return guarded


def damaged(path: Path, what: str) -> RunDirectoryError:
    """The error for a file whose content cannot be used (exit code 3)."""
    return RunDirectoryError(f"{path}: {what}", exit_code=3)


@dataclass(frozen=True)
class Stage:
    """One stage of the run. Its rows in thermo.csv are those with first_step <= step <= last_step."""

    name: str
    first_step: int
    last_step: int
    sampled: bool
    energy_drift: Optional[float]  # slope of the total energy per atom [epsilon/tau]


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
        import unfinished_run  # here, as it reads with what is defined in this module

        observables, stages = {}, unfinished_run.stages(path)
    return RunDirectory(
        path=path,
        title=field(path / "run.json", record, "title", str, default=""),
        thermo=read_table(path / "thermo.csv", THERMO_COLUMNS, increasing=("step", "time"), growing=not ended),
        rdf=read_rdf(path / "rdf.csv"),
        observables=observables,
        stages=stages,
    )


def tables_of_analysis(path: Path) -> RunDirectory:
    """The tables that `ljmd analyze` wrote, as a run without observables and stages.

    The title is the name of the run that the directory lies in, or else of the directory itself.
    """
    inside = path.resolve()
    title = inside.parent.name if (inside.parent / "run.json").exists() else inside.name
    return RunDirectory(path=path, title=title, thermo={}, rdf=read_rdf(path / "rdf.csv"), observables={}, stages=[])


def read_text(path: Path) -> str:
    """The text of a file; a byte-order mark is dropped."""
    try:
        return path.read_text(encoding="utf-8-sig")
    except FileNotFoundError:
        raise damaged(path, "no such file") from None
    except UnicodeDecodeError:
        raise damaged(path, "not a text file") from None
    except OSError as error:
        raise damaged(path, f"cannot be read: {error.strerror}") from None


def read_table(path: Path, required: tuple[str, ...], increasing: tuple[str, ...], growing: bool = False) -> Table:
    """A CSV file with one header row as columns of numbers; empty fields become NaN.

    The columns `required` must be there; those named `increasing` must have a number in every row, each above the last.
    Of a `growing` file, which was being written, a last line without an end does not count.
    """
    text = read_text(path)
    if growing:
        text = text[: text.rfind("\n") + 1]
    try:
        rows = list(csv.reader(text.splitlines()))
    except csv.Error as error:
        raise damaged(path, str(error)) from None
    if not rows:
        raise damaged(path, "empty, without even a header row")
    header, body = rows[0], rows[1:]
    missing = [name for name in required if name not in header]
    if missing:
        raise damaged(path, f"line 1: no column '{missing[0]}' (found: {', '.join(header)})")
    if not body:
        raise damaged(path, "no rows below the header")
    values = np.empty((len(body), len(header)))
    for row, fields in enumerate(body):
        where = f"line {row + 2}"
        if len(fields) != len(header):
            raise damaged(path, f"{where}: {len(fields)} fields, the header has {len(header)}")
        for column, text in enumerate(fields):
            try:
                values[row, column] = float(text) if text else math.nan
            except ValueError:
                raise damaged(path, f"{where}: '{text}' in column '{header[column]}' is not a number") from None
    table = {name: values[:, column] for column, name in enumerate(header)}
    for name in increasing:
        steps = np.diff(table[name], prepend=-math.inf)
        disorder = np.flatnonzero(~((steps > 0.0) & np.isfinite(table[name])))
        if disorder.size:
            raise damaged(path, f"line {disorder[0] + 2}: column '{name}' has no number above the one before")
    return table


def has_values(path: Path, table: Table, names: Sequence[str]) -> bool:
    """Whether the columns `names` of a table have a number in every row. One without any is of a quantity that has no value
    in this run (g(r) of a single atom, viscosity at zero temperature): there is nothing to draw then, which is said.

    Raises RunDirectoryError (exit code 3) for a column with some numbers.
    """
    for name in names:
        gaps = np.flatnonzero(~np.isfinite(table[name]))
        if gaps.size == table[name].size:
            print(f"{path}: '{name}' has no value in this run, no picture of it", file=sys.stderr)
            return False
        if gaps.size:
            raise damaged(path, f"line {gaps[0] + 2}: column '{name}' has no number")
    return True


def read_rdf(path: Path) -> Optional[Table]:
    """The columns of rdf.csv; None when there is no such file, or no g(r) in it."""
    if not path.exists():
        return None
    table = read_table(path, RDF_COLUMNS, increasing=("r",))
    return table if has_values(path, table, ("g",)) else None


def read_json(path: Path) -> dict[str, Any]:
    """A JSON file that holds one object."""
    try:
        content = json.loads(read_text(path))
    except json.JSONDecodeError as error:
        raise damaged(path, f"line {error.lineno}: {error.msg}") from None
    except RecursionError:
        raise damaged(path, "nested too deeply") from None
    if not isinstance(content, dict):
        raise damaged(path, "must hold a JSON object")
    return content


def field(path: Path, record: Any, name: str, kind: Any, **fallback: Any) -> Any:
    """record[name], which must be of `kind`; `default=` makes it optional, and null counts as absent then."""
    if not isinstance(record, dict):
        raise damaged(path, f"an object with '{name}' was expected, found {json.dumps(record)[:40]}")
    value = record.get(name)
    if value is None and "default" in fallback:
        return fallback["default"]
    allowed = (int, float) if kind is float else kind
    if not isinstance(value, allowed) or (isinstance(value, bool) and kind is not bool):
        found = f"is {json.dumps(value)[:40]}" if name in record else "is missing"
        raise damaged(path, f"'{name}' {found}, must be of type {kind.__name__}")
    return value


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
