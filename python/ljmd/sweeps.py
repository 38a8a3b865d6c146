"""Sweeps: one deck at many settings, each point a run of its own."""

from __future__ import annotations

import csv
import itertools
import json
import math
import os
import pathlib
import re
import tempfile
from collections.abc import Mapping, Sequence
from typing import TYPE_CHECKING, Any, overload

from . import _check, _core, _program, _progress
from ._text import html_lines, html_table, mixed_table, with_error
from .errors import Error, InputError
from .reading.files import is_there
from .reading.sweeps import read_request
from .runs import Run

if TYPE_CHECKING:
    from ._types import Path
    from .reading.observables import Observable

_PLAIN = re.compile(r"(?!(?:true|false|inf|nan)$)[A-Za-z][A-Za-z0-9_.-]*$")
_MOST_POINTS = 10_000  # as of the program


class Point:
    """One point of a sweep: `name`, `values` of the varied keys, `directory`, and `run` (as `ljmd.open`) with its results.

    failure: why it has no results; empty: it has, or has not ended yet
    """

    def __init__(self, name: str, values: dict[str, Any], directory: pathlib.Path, failure: str = ""):
        self.name, self.values, self.directory, self.failure = name, values, directory, failure

    @property
    def begun(self) -> bool:
        """Whether it has a run, which may be unfinished."""
        return is_there(self.directory / "run.json")

    @property
    def run(self) -> Run:
        """Raises DataError before the run has begun."""
        return Run.open(self.directory)

    def observables(self) -> dict[str, Observable]:
        """By name; analyses of few bodies as "orbit_period". Empty without results."""
        return self.run.all_observables() if self.begun else {}

    def __repr__(self) -> str:
        state = f"failed: {self.failure}" if self.failure else "not begun" if not self.begun else \
            "finished" if self.run.finished else "not finished"
        return f"<ljmd.Point {self.name}: {state}>"


class Sweep(Sequence[Point]):
    """The points of a sweep, in their order: `sweep[0].run["pressure"]`; all numbers: `sweep.to_dataframe()`.

    directory: where its files are; those of a temporary one are gone when the sweep is
    keys: that are varied
    """

    def __init__(self, directory, keys, points, temporary=None):
        self.directory, self.keys, self._points, self._temporary = directory, list(keys), list(points), temporary

    @classmethod
    def open(cls, directory: Path, failures: Mapping[str, str] | None = None, temporary: Any = None) -> "Sweep":
        """See `ljmd.open_sweep`."""
        directory = _check.directory_of(directory)
        request = read_request(directory)
        points = [Point(name, dict(zip(request.keys, map(_value, values))), request.folder(name), (failures or {}).get(name, ""))
                  for name, values in zip(request.names, request.values)]
        return cls(directory, request.keys, points, temporary)

    @overload
    def __getitem__(self, k: int) -> Point: ...

    @overload
    def __getitem__(self, k: slice) -> list[Point]: ...

    def __getitem__(self, k: int | slice) -> Point | list[Point]:
        return self._points[k]

    def __len__(self) -> int:
        return len(self._points)

    @property
    def failures(self) -> dict[str, str]:
        """Why points failed, by their names."""
        return {point.name: point.failure for point in self if point.failure}

    @property
    def finished(self) -> bool:
        """Whether all points have results."""
        return all(point.begun and point.run.finished for point in self)

    def to_dataframe(self) -> Any:
        """A row for each point, as sweep.csv: the varied keys, then each observable and its `NAME_standard_error`, then `remarks`.

        NaN is what is not known: of points without results, and errors of numbers that have none. A pandas DataFrame; without
        pandas a NumPy structured array.
        """
        found = [point.observables() for point in self]
        names = list(dict.fromkeys(name for each in found for name in each))
        columns = {key: [point.values[key] for point in self] for key in self.keys}
        for name in names:
            columns[name] = [each[name].mean if name in each else math.nan for each in found]
            columns[f"{name}_standard_error"] = [each[name].error if name in each else math.nan for each in found]
        columns["remarks"] = ["; ".join([f"failed: {point.failure}"] * bool(point.failure) +
                                        [f"{name}: {value.remark}" for name, value in each.items() if value.remark])
                              for point, each in zip(self, found)]
        return mixed_table(columns)

    def _rows(self) -> list:
        rows = []
        for point in self:
            found = point.observables()
            shown = [with_error(found[name].mean, found[name].error) if name in found else "failed" if point.failure else ""
                     for name in self._shown(found)]
            rows.append([*point.values.values(), *shown])
        return rows

    def _shown(self, found) -> list:
        fluid = not self._points or "total_energy" not in found or "temperature" in found
        return ["temperature", "potential_energy", "pressure"] if fluid else ["total_energy"]

    def _heading(self) -> str:
        failed = len(self.failures)
        return f"ljmd sweep: {len(self)} points; {self.directory}" + (f"; {failed} failed" if failed else "")

    def __repr__(self) -> str:
        header = [*self.keys, *self._shown(self._points[0].observables() if self._points else {})]
        rows = [[str(cell) for cell in row] for row in self._rows()]
        widths = [max(len(row[k]) for row in [header, *rows]) for k in range(len(header))]
        lines = ["  " + "  ".join(cell.ljust(width) for cell, width in zip(row, widths)).rstrip() for row in [header, *rows]]
        return "\n".join([self._heading(), *lines])

    def _repr_html_(self) -> str:
        header = [*self.keys, *self._shown(self._points[0].observables() if self._points else {})]
        return html_table(header, self._rows(), self._heading()) + html_lines(self.failures.values())

    def __reduce__(self):
        if self._temporary is not None:
            raise TypeError("the files of this sweep are temporary: give it a directory, or pickle its to_dataframe()")
        return Sweep.open, (self.directory, self.failures)


def open_sweep(directory: Path) -> Sweep:
    """The sweep in a directory, of Python or of `ljmd sweep`; it may be unfinished. Raises DataError if there is none."""
    return Sweep.open(directory)


def _value(text: str):
    """The value of a setting: a number, a truth value, or text."""
    for kind in (int, float):
        try:
            return kind(text)
        except ValueError:
            pass
    if text in ("true", "false"):
        return text == "true"
    return text[1:-1] if len(text) > 1 and text[0] == text[-1] and text[0] in "'\"" else text


def _setting(value, key: str) -> str:
    """A value of a key as --set takes it."""
    return value if isinstance(value, str) and _PLAIN.match(value) else _core.value_text(value, key)


def _points_of(points) -> tuple:
    """Keys, and a row of values for each point, from {"key": values, ...} (all combinations) or [{"key": value, ...}, ...]."""
    if isinstance(points, Mapping):
        keys = list(points)
        lists = []
        for key in keys:
            lists.append(_check.listed(points[key], f"sweep: the values of {_check.shown(key)}"))
        if math.prod(map(len, lists)) > _MOST_POINTS:
            raise InputError(f"sweep: {math.prod(map(len, lists))} points; at most {_MOST_POINTS} are allowed")
        rows = list(itertools.product(*lists))
    else:
        points = _check.listed(points, "points")
        if not all(isinstance(point, Mapping) for point in points):
            raise InputError('sweep: points are {"system.temperature": [1.0, 1.5]}, all combinations of the values, or a list with a '
                             'table for each point')
        keys = list(points[0]) if points else []
        if any(set(point) != set(keys) for point in points):
            raise InputError("sweep: every point has the same keys")
        rows = [tuple(point[key] for key in keys) for point in points]
    if not keys or not rows:
        raise InputError("sweep: no points")
    if not all(isinstance(key, str) for key in keys):
        raise InputError(f"sweep: keys are text, as of --set: {keys}")
    return keys, rows


def sweep(deck, points, *, jobs=None, directory=None, progress=True, force: bool = False) -> Sweep:
    """See `Deck.sweep`."""
    if deck._pair is not None:
        raise InputError("a pair potential in Python runs in memory alone: sweeps have files")
    keys, rows = _points_of(points)
    options = ["--jobs", _check.whole(jobs, "jobs", 1)] if jobs is not None else []
    options += ["--force"] if _check.truth(force, "force") else []
    temporary = None
    if directory is None:
        temporary = tempfile.TemporaryDirectory(prefix="ljmd-sweep-")
        directory = temporary.name
    directory = _check.directory_of(directory)
    with tempfile.TemporaryDirectory(prefix="ljmd-") as folder:
        listed = pathlib.Path(folder) / "points.csv"
        with open(listed, "w", encoding="utf-8", newline="") as file:
            csv.writer(file).writerows([keys, *([_setting(value, key) for value, key in zip(row, keys)] for row in rows)])
        deck_file, settings = deck._in_file(pathlib.Path(folder))
        with _progress.shown(progress, len(rows), unit="point") as tell:
            done = re.compile(r"\[(\d+)/\d+\] ")

            def told(line):
                found = done.match(line)
                if tell is not None and found:
                    tell(int(found[1]))

            note = "points that had begun have checkpoints: the same sweep goes on" if temporary is None else ""
            try:
                code, text, said = _program.call(["sweep", deck_file, "--list", listed, "--out", directory, "--json", *options,
                                                  *settings], told=told, allowed=(0, 5), note=note)
            except Error as error:
                raise type(error)(_in_words_of_python(str(error), listed, deck_file)) from None
    if not text.strip():
        _program.raise_error(code, said)
    _program.warned(_in_words_of_python(line, listed, deck_file) for line in said if not line.startswith("["))
    failures = {each["name"]: each["failure"] for each in json.loads(text)["points"] if each["failure"]}
    return Sweep.open(directory, failures, temporary)


def _in_words_of_python(text: str, listed, deck_file) -> str:
    """Without the names of temporary files and of options of the command line."""
    text = text.replace(f"{os.fspath(listed)}:", "points:").replace("--list ", "sweep of ").replace("--force", "force=True")
    return text.replace(os.fspath(deck_file), "Deck")
