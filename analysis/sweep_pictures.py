"""The pictures of a sweep: an observable with error bars against one of the varied keys, one picture for each column.
Of replicas each one, beside what all of them say together.

One line for each value, or set of values, of the other keys. Points that have failed are left out. Beside pressures,
energies and compressibility factors stands the equation of state of the fluid, where it has one (`ljmd eos`).

A temperature that was asked for is not always the one that a run has. Against a temperature points are drawn where it was
measured, with its error; open circles show where it was asked. In the legend a temperature that was missed by more than
three errors has what was found beside it.
"""

from __future__ import annotations

import math
import re
from dataclasses import dataclass
from functools import partial
from pathlib import Path
from typing import Any, Callable, Optional, Sequence

import equation_of_state
import numpy as np
import style
from ljmd.errors import InputError
from ljmd.reading import sweeps
from ljmd.reading.sweeps import ERROR, SweepTable
from style import plt

USUAL = ("pressure", "total_energy")
MOST_STATES = 120  # at which an equation of state is asked, of all lines together
MOST_COLOURS = len(style.CYCLE) - 1  # beyond them lines get the colours of a scale
BESIDE = 4  # lines beyond which the legend stands beside the panel


SEED = "system.seed"


def axes_of(sweep: SweepTable) -> list[str]:
    """The varied keys, without a seed that is another one at each point."""
    keys = list(sweep.keys)
    own = len(keys) > 1 and SEED in keys and len(set(sweep.keys[SEED])) == len(sweep.keys[SEED])
    return [key for key in keys if not (own and key == SEED)]


def choose_key(sweep: SweepTable, wanted: Optional[str]) -> str:
    keys = axes_of(sweep)
    if wanted is None:
        return keys[-1]
    found = [key for key in keys if wanted in (key, key.rpartition(".")[2])]
    if len(found) != 1:
        raise InputError(f"{'more than one' if found else 'no'} key '{wanted}' is varied (found: {', '.join(keys)})")
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


def one_temperature(found: np.ndarray, error: np.ndarray) -> Optional[float]:
    """The mean of temperatures that agree within three errors, as they do along an isotherm: its curve does not follow their noise."""
    if len(found) < 2 or not (error > 0).all():
        return None
    mean = float(np.average(found, weights=error ** -2))
    return None if missed(np.full(len(found), mean), found, error).any() else mean


def label_of(key: str, value: str, rows: Sequence[int], sweep: SweepTable) -> str:
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


@dataclass(frozen=True)
class Axis:
    """Where the points stand: by a varied key or, where that is a temperature, by the one that was measured."""

    label: str
    places: np.ndarray
    error: Optional[np.ndarray] = None
    asked: Optional[np.ndarray] = None  # the temperatures, where they have a place on this axis
    categories: tuple[str, ...] = ()  # what stands at 0, 1, ...: texts have no order and no distance


def axis_of(sweep: SweepTable, observable: str, against: str) -> Axis:
    texts = sweep.keys[against]
    values, units = zip(*map(split_unit, texts))
    name = against.rpartition(".")[2]
    numeric = sweep.merged is None and len(set(units)) == 1 and not math.isnan(values[0])
    if is_temperature(against) and observable != "temperature" and "temperature" in sweep.observables:
        found = sweep.observables["temperature"]
        error = np.nan_to_num(sweep.observables.get("temperature" + ERROR, np.zeros(len(found))))
        # One in kelvin has no place on an axis in reduced units.
        asked = np.array(values) if numeric and not units[0] else None
        return Axis(style.LABELS["temperature"] + ", measured", found, error, asked)
    if not numeric:
        ticks = tuple(dict.fromkeys(texts))
        return Axis(style.plain(name), np.array([ticks.index(text) for text in texts], float), categories=ticks)
    usual = style.LABELS.get(name, style.plain(name.replace("_", " ")))
    return Axis(f"{style.plain(name.replace('_', ' '))} / {style.plain(units[0])}" if units[0] else usual, np.array(values))


def lines_of(sweep: SweepTable, axis: Axis, y: np.ndarray, others: Sequence[str]) -> dict[tuple[str, ...], np.ndarray]:
    """The rows of each line, from left to right, by the values of the other keys."""
    found: dict[tuple[str, ...], list[int]] = {}
    for row in np.flatnonzero(np.isfinite(y) & np.isfinite(axis.places)):
        found.setdefault(tuple(sweep.keys[key][row] for key in others), []).append(row)
    return {values: np.array(sorted(rows, key=lambda row: axis.places[row])) for values, rows in found.items()}


def colours_of(lines: dict[tuple[str, ...], np.ndarray]) -> list[Any]:
    """Of few lines those of the style; of many a scale, in the order of the values where these are numbers."""
    if len(lines) <= MOST_COLOURS:
        return [style.colour(number) for number in range(len(lines))]
    first = [split_unit(values[0])[0] for values in lines]
    rank = np.argsort(np.argsort(first)) if not np.isnan(first).any() else np.arange(len(lines))
    return list(plt.get_cmap("viridis")(0.92 * rank / (len(lines) - 1)))


def equation_beside(sweep: SweepTable, axis: Axis, observable: str, rows: np.ndarray, count: int) -> Optional[
        tuple[np.ndarray, np.ndarray]]:
    """The equation of state along a line: at `count` places from the first to the last point, with temperature and density
    between those of the points. None where there is none, or the line mixes fluids."""
    models = {sweep.equations[row] for row in rows} if sweep.equations else {None}
    if observable not in equation_of_state.OBSERVABLES or len(models) != 1 or None in models or axis.categories:
        return None
    places, temperatures = axis.places[rows], sweep.observables["temperature"][rows]
    errors = np.nan_to_num(sweep.observables.get("temperature" + ERROR, np.zeros(len(axis.places))))[rows]
    if axis.asked is None and (mean := one_temperature(temperatures, errors)) is not None:
        temperatures = np.full(len(rows), mean)
    densities = sweep.densities[rows]
    if not (np.isfinite(temperatures).all() and np.isfinite(densities).all()):
        return None
    x = np.unique(np.concatenate([np.linspace(places[0], places[-1], count), places]))
    found = equation_of_state.values(models.pop(), observable, np.interp(x, places, temperatures),
                                     np.interp(x, places, densities))
    return None if found is None or np.isnan(found).all() else (x, found)


def plot(sweep: SweepTable, observable: str, against: str) -> plt.Figure:
    """The points with their error bars and, where there is one, the equation of state."""
    axis = axis_of(sweep, observable, against)
    y = sweep.observables[observable]
    error = np.nan_to_num(sweep.observables.get(observable + ERROR, np.zeros(len(y))))
    others = [key for key in axes_of(sweep) if key != against]
    lines = lines_of(sweep, axis, y, others)
    beside = len(lines) > BESIDE or (axis.asked is not None and bool(others))
    figure, axes = plt.subplots(figsize=(8.2 if beside else 7.0, 4.9), constrained_layout=True)
    curves = 0
    for number, ((values, rows), colour) in enumerate(zip(lines.items(), colours_of(lines))):
        label = ", ".join(label_of(key, value, rows, sweep) for key, value in zip(others, values))
        x = axis.places[rows]
        if axis.categories:  # side by side
            x = x + 0.12 * (number - 0.5 * (len(lines) - 1)) / max(1.0, 0.25 * len(lines))
        curve = equation_beside(sweep, axis, observable, rows, max(4, MOST_STATES // len(lines)))
        if curve is not None:
            axes.plot(*curve, color=colour, linewidth=1.2, alpha=0.75, zorder=1)
            curves += 1
        elif not axis.categories:
            axes.plot(x, y[rows], color=colour, linewidth=0.9, alpha=0.5, zorder=1)
        axes.errorbar(x, y[rows], yerr=error[rows], xerr=None if axis.error is None else axis.error[rows], fmt="o",
                      markersize=4.5, elinewidth=1.0, capsize=2, color=colour, label=style.plain(label), zorder=3)
        if axis.asked is not None:
            axes.hlines(y[rows], axis.asked[rows], x, colors=[colour], linewidth=0.6, alpha=0.5, zorder=1)
            axes.plot(axis.asked[rows], y[rows], "o", markersize=5.0, markerfacecolor="white", markeredgewidth=1.0,
                      color=colour, zorder=2)
    merged = (sweep.merged or {}).get(observable)
    if merged is not None and math.isfinite(merged.mean):
        axes.axhline(merged.mean, color=style.colour(1), linewidth=1.2, zorder=1, label="all replicas")
        if math.isfinite(merged.error):
            axes.axhspan(merged.mean - merged.error, merged.mean + merged.error, color=style.colour(1), alpha=0.15, linewidth=0, zorder=0)
        axes.legend()
    if axis.categories:
        axes.set_xticks(range(len(axis.categories)), [style.plain(text) for text in axis.categories])
        axes.set_xlim(-0.5, len(axis.categories) - 0.5)
        axes.grid(False, axis="x")
    axes.set_xlabel(axis.label)
    axes.set_ylabel(style.LABELS.get(observable, style.plain(observable.replace("_", " "))))
    draw_legend(axes, sweep, axis, bool(others), curves, beside)
    alike = sweep.merged is None and len(y) > 1 and SEED not in sweep.keys and "temperature" in sweep.observables
    style.head(figure, sweep.title, "; ".join(filter(None, (sweep.status, "all points have one seed: they deviate alike" if alike else ""))))
    return figure


def draw_legend(axes: plt.Axes, sweep: SweepTable, axis: Axis, named: bool, curves: int, beside: bool) -> None:
    """The lines, where there are other keys, and what filled and open circles and curves mean."""
    handles = axes.get_legend_handles_labels()[0] if named else []
    if axis.asked is not None:
        for face, label in ((style.GREY, "filled: temperature measured"), ("white", "open: temperature asked")):
            handles.append(plt.Line2D([], [], marker="o", linestyle="", color=style.GREY, markerfacecolor=face,
                                      markersize=5.0, label=label))
    if curves:
        models = " and ".join(sorted({one for one in sweep.equations if one}))
        handles.append(plt.Line2D([], [], color=style.GREY, linewidth=1.2, label=f"equation of state {models},\nwhere one phase is stable"))
    if handles and beside:
        style.legend_beside(axes, handles=handles, ncols=1 + (len(handles) - 1) // 20)
    elif handles:
        axes.legend(handles=handles)


def pictures(directory: Path, against: Optional[str]) -> dict[str, Callable[[], plt.Figure]]:
    """What draws each observable that has a value at some point, by its name."""
    sweep = sweeps.load(directory)
    key = choose_key(sweep, against)
    names = [name for name, values in sweep.observables.items() if not name.endswith(ERROR) and np.isfinite(values).any()]
    return {name: partial(plot, sweep, name, key) for name in names}


def usual(names: Sequence[str]) -> list[str]:
    """The observable that is drawn where none is asked for."""
    return [next((name for name in USUAL if name in names), *names[:1])] if names else []
