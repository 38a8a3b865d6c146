#!/usr/bin/env python3
"""The picture of a sweep: an observable with error bars against one of the varied keys.

    plot_sweep.py DIR [--observable NAME] [--against KEY] [--out FILE]

DIR is where `ljmd sweep` wrote. NAME is a column of sweep.csv, pressure by default (of few bodies total_energy); KEY is a varied key or
the last part of its name, the last key by default. One line for each value, or set of values, of the other keys. Points that have
failed are left out.

A temperature that was asked for is not always the one that a run has. Against a temperature points are drawn where it was measured,
with its error; open circles show where it was asked. In the legend a temperature that was missed by more than three errors has
what was found beside it.
 Draws FILE (.png, .pdf or .svg), DIR/NAME.png by default, and prints its path.
Exit codes: 0 ok, 2 usage, 3 a file is missing or damaged, 4 the picture cannot be written.
"""

from __future__ import annotations

import argparse
import csv
import math
import re
import sys
from dataclasses import dataclass
from pathlib import Path
from typing import Optional, Sequence

import numpy as np

sys.path.insert(0, str(Path(__file__).resolve().parent))
import style  # noqa: E402
from checked_files import RunDirectoryError, damaged, field, read_json, read_text, reports_errors  # noqa: E402
from style import plt  # noqa: E402

USUAL = ("pressure", "total_energy")
ERROR = "_standard_error"
REMARKS = "remarks"  # the column that is no number


@dataclass(frozen=True)
class Sweep:
    """sweep.csv by columns: of the varied keys their values as texts, of the observables numbers, NaN where there are none."""

    keys: dict[str, list[str]]
    observables: dict[str, np.ndarray]


def load(directory: Path) -> Sweep:
    """Read and check what a sweep has left."""
    keys = field(directory / "sweep.json", read_json(directory / "sweep.json"), "keys", list)
    path = directory / "sweep.csv"
    try:
        rows = list(csv.reader(read_text(path).splitlines()))
    except csv.Error as error:
        raise damaged(path, str(error)) from None
    if not rows or rows[0][: len(keys)] != keys:
        raise damaged(path, f"does not begin with the keys of sweep.json, {', '.join(map(str, keys))}")
    header, body = rows[0], rows[1:]
    if not body:
        raise damaged(path, "no rows below the header")
    for number, row in enumerate(body, 2):
        if len(row) != len(header):
            raise damaged(path, f"line {number}: {len(row)} fields, the header has {len(header)}")
    columns = {name: [row[k] for row in body] for k, name in enumerate(header)}
    try:
        observables = {name: np.array([float(text or "nan") for text in columns[name]]) for name in header[len(keys):]
                       if name != REMARKS}
    except ValueError as error:
        raise damaged(path, str(error)) from None
    return Sweep({key: columns[key] for key in keys}, observables)


def choose_observable(sweep: Sweep, wanted: Optional[str]) -> str:
    names = [name for name in sweep.observables if not name.endswith(ERROR)]
    if wanted is None:
        wanted = next((name for name in USUAL if name in names), None)
    if wanted not in names:
        raise RunDirectoryError(f"no observable '{wanted}' (found: {', '.join(names) or 'none'})", exit_code=2)
    if not np.isfinite(sweep.observables[wanted]).any():
        known = [name for name in names if np.isfinite(sweep.observables[name]).any()]
        raise RunDirectoryError(f"no point has a value of '{wanted}' (values: {', '.join(known) or 'none'})", exit_code=2)
    return wanted


def choose_key(sweep: Sweep, wanted: Optional[str]) -> str:
    keys = list(sweep.keys)
    if wanted is None:
        return keys[-1]
    found = [key for key in keys if wanted in (key, key.rpartition(".")[2])]
    if len(found) != 1:
        raise RunDirectoryError(f"{'more than one' if found else 'no'} key '{wanted}' is varied (found: {', '.join(keys)})",
                                exit_code=2)
    return found[0]


def split_unit(text: str) -> tuple[float, str]:
    """The number and the unit of "1.2" or "86.5 K"; NaN and the text itself when it is no such thing."""
    parts = re.fullmatch(r"\"?([-+]?[0-9.]+(?:[eE][-+]?[0-9]+)?)\s*([^\d\s\"][^\"]*)?\"?", text)
    try:
        return (float(parts[1]), parts[2] or "") if parts else (math.nan, text)
    except ValueError:
        return math.nan, text


def shortened(text: str) -> str:
    """A value as the legend has it: a number with six digits, which tell the lines of a grid apart."""
    value, unit = split_unit(text)
    return text if math.isnan(value) else f"{value:.6g} {unit}".rstrip()


def is_temperature(key: str) -> bool:
    return key.rpartition(".")[2] == "temperature"


def missed(asked: np.ndarray, found: np.ndarray, error: np.ndarray) -> np.ndarray:
    """Where a measured temperature is off the one that was asked by more than three errors."""
    return np.isfinite(found) & (np.abs(found - asked) > 3.0 * np.nan_to_num(error))


def label_of(key: str, value: str, rows: Sequence[int], sweep: Sweep) -> str:
    """What a line has of one of the keys that are not on the axis."""
    label = f"{key.rpartition('.')[2]} = {shortened(value)}"
    asked, unit = split_unit(value)
    found = sweep.observables.get("temperature")
    if not is_temperature(key) or unit or found is None:
        return label
    error = sweep.observables.get("temperature" + ERROR, np.zeros(len(found)))
    if not missed(asked, found[rows], error[rows]).any():
        return label
    least, most = f"{np.nanmin(found[rows]):.3g}", f"{np.nanmax(found[rows]):.3g}"
    return f"{label} (found {least})" if least == most else f"{label} (found {least} to {most})"


def plot(sweep: Sweep, observable: str, against: str) -> plt.Figure:
    texts = sweep.keys[against]
    values, units = zip(*map(split_unit, texts))
    numeric = len(set(units)) == 1 and not math.isnan(values[0])
    ticks = list(dict.fromkeys(texts))
    x = np.array(values if numeric else [ticks.index(text) for text in texts], float)
    y = sweep.observables[observable]
    error = sweep.observables.get(observable + ERROR, np.full(len(y), math.nan))
    name = against.rpartition(".")[2]
    label_of_x = f"{name} / {units[0]}" if numeric and units[0] else style.LABELS.get(name, style.plain(name))
    asked = x_error = None
    if is_temperature(against) and observable != "temperature" and "temperature" in sweep.observables:
        asked = x if numeric and not units[0] else None  # one in kelvin has no place on an axis in reduced units
        x = sweep.observables["temperature"]
        x_error = np.nan_to_num(sweep.observables.get("temperature" + ERROR, np.zeros(len(x))))
        numeric = True
        label_of_x = style.LABELS["temperature"] + ", measured"

    lines: dict[tuple[str, ...], list[int]] = {}
    others = [key for key in sweep.keys if key != against]
    for k in np.flatnonzero(np.isfinite(y)):
        lines.setdefault(tuple(sweep.keys[key][k] for key in others), []).append(k)
    figure, axes = plt.subplots(figsize=(7.0, 4.8), constrained_layout=True)
    shades = plt.get_cmap("viridis")(np.linspace(0.0, 0.9, len(lines)))
    for number, (others_values, rows) in enumerate(lines.items()):
        rows = sorted(rows, key=lambda k: x[k])
        label = ", ".join(label_of(key, value, rows, sweep) for key, value in zip(others, others_values))
        colour = style.colour(number) if len(lines) <= len(style.CYCLE) else shades[number]
        axes.errorbar(x[rows], y[rows], yerr=np.nan_to_num(error[rows]), xerr=None if x_error is None else x_error[rows],
                      fmt="o-", markersize=3.5, elinewidth=0.9, capsize=2, color=colour, label=style.plain(label))
        if asked is not None:
            axes.plot(asked[rows], y[rows], "o", markersize=6.5, fillstyle="none", markeredgewidth=0.9, color=colour, alpha=0.6,
                      label="open: temperature asked" if number == len(lines) - 1 else None)
    if not numeric:
        axes.set_xticks(range(len(ticks)), [style.plain(text) for text in ticks])
    axes.set_xlabel(label_of_x)
    axes.set_ylabel(style.LABELS.get(observable, style.plain(observable)))
    if lines and (others or asked is not None):
        axes.legend(ncols=1 + (len(lines) - 1) // 12)
    return figure


@reports_errors
def main(arguments: Optional[Sequence[str]] = None) -> int:
    parser = argparse.ArgumentParser(description="Make the picture of a sweep.")
    parser.add_argument("directory", metavar="DIR", type=Path, help="directory that `ljmd sweep` wrote")
    parser.add_argument("--observable", metavar="NAME", help="column of sweep.csv (pressure)")
    parser.add_argument("--against", metavar="KEY", help="varied key on the axis (the last)")
    parser.add_argument("--out", type=Path, metavar="FILE", help="the picture (DIR/NAME.png)")
    options = parser.parse_args(arguments)
    style.check_format(options.out)
    sweep = load(options.directory)
    observable = choose_observable(sweep, options.observable)
    style.use()
    style.save(plot(sweep, observable, choose_key(sweep, options.against)),
               options.out or options.directory / f"{observable}.png")
    return 0


if __name__ == "__main__":
    sys.exit(main())
