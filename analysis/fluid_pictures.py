"""The pictures of a run of a fluid, also of one that was stopped, fails or goes on, and of the tables of `ljmd analyze`.

thermo (thermodynamics against time), atoms (the last configuration) and, where there are these tables, rdf (the radial
distribution function), sk (the structure factor), msd (displacements), vacf and vibrational_spectrum (velocities),
stress_autocorrelation (viscosity), and those of time_pictures.py (scattering functions).
"""

from __future__ import annotations

import math
from functools import partial
from pathlib import Path
from typing import Callable, Optional

import atoms_picture
import numpy as np
import structure_pictures
import style
from ljmd.reading import fluids
from ljmd.reading.files import damaged, is_there
from ljmd.reading.fluids import FluidRun
from ljmd.reading.stages import Stage
from ljmd.reading.tables import Table
from style import plt

RDF_COLUMNS = ("r", "g", "g_standard_error")
BLOCKS = 20
PANELS = {
    "temperature": style.VERMILION,
    "potential_energy": style.BLUE,
    "kinetic_energy": style.PURPLE,
    "total_energy": style.BLACK,
    "pressure": style.GREEN,
    "edge_x": style.SKY,  # these three where a barostat changes each edge by itself
    "edge_y": style.SKY,
    "edge_z": style.SKY,
}
SI_COLUMNS = {"time": "time_ps", "temperature": "temperature_K", "pressure": "pressure_bar", "r": "r_nm"}


def block_averages(time: np.ndarray, values: np.ndarray, blocks: int = BLOCKS) -> tuple[np.ndarray, np.ndarray, float]:
    """Means of `time` and `values` over consecutive blocks of equal length, and the error of one block.

    The error of a block mean is the standard deviation of all block means, in the unit of `values`. Rows that do not
    fill a block are left out at the start. Fewer blocks are made when there are fewer than two rows for each; without
    rows for two blocks, the arrays are empty and the error is NaN.
    """
    blocks = min(blocks, len(values) // 2)
    if blocks < 2:
        return np.empty(0), np.empty(0), float("nan")
    length = len(values) // blocks
    first = len(values) - blocks * length
    block_times = time[first:].reshape(blocks, length).mean(axis=1)
    block_means = values[first:].reshape(blocks, length).mean(axis=1)
    return block_times, block_means, float(block_means.std(ddof=1))


def peaks(r: np.ndarray, g: np.ndarray, error: np.ndarray, most: int = 4) -> list[int]:
    """Rows of the peaks of g(r), nearest first: highest within 0.25 sigma, and above 1 by 2 % and 4 standard errors."""
    found = []
    for i in range(1, len(r) - 1):
        near = np.abs(r - r[i]) <= 0.25
        inside = r[i] + 0.25 <= r[-1]  # else what looks like a peak may be the slope of one farther out
        significant = g[i] - 1.0 > max(0.02, 4.0 * np.nan_to_num(error[i]))
        if inside and significant and g[i] == g[near].max() and not np.any(near[found]):
            found.append(i)
    return found[:most]


def summit(r: np.ndarray, g: np.ndarray, error: np.ndarray, top: int) -> tuple[float, float]:
    """Place and height of the peak whose highest row is `top`: of the parabola through what lies next to it in height.

    A flat peak is highest where its noise is, which may be far from its middle. So the parabola takes the upper tenth, or
    six standard errors where that is more, but not more than the upper half.
    """
    height = g[top] - 1.0
    depth = np.clip(6.0 * np.nan_to_num(error[top]), 0.1 * height, 0.5 * height)
    upper = (np.abs(r - r[top]) <= 0.25) & (g > g[top] - depth)
    if np.count_nonzero(upper) >= 5:
        curvature, slope, level = np.polyfit(r[upper] - r[top], g[upper], 2)
        from_top = -slope / (2.0 * curvature) if curvature < 0.0 else np.inf
        if upper[np.argmin(np.abs(r - r[top] - from_top))]:  # else it spans two peaks that lie close together
            return float(r[top] + from_top), float(level + 0.5 * slope * from_top)
    return float(r[top]), float(g[top])


def si_factor(table: Table, name: str) -> Optional[float]:
    """SI units in one reduced unit of column `name`, from the columns themselves; None without an SI column."""
    si_name = SI_COLUMNS.get(name)
    if si_name not in table:
        return None
    reduced, si = table[name], table[si_name]
    usable = np.isfinite(reduced) & np.isfinite(si)
    square = float(np.dot(reduced[usable], reduced[usable]))
    factor = float(np.dot(reduced[usable], si[usable])) / square if square > 0.0 else 0.0
    return factor if factor > 0.0 else None


def add_si_axis(axes: plt.Axes, table: Table, name: str, vertical: bool) -> None:
    """A second scale in SI units opposite to the reduced one, where the run has the SI column."""
    factor = si_factor(table, name)
    if factor is None:
        return
    functions = (lambda x: x * factor, lambda x: x / factor)
    label = style.LABELS[SI_COLUMNS[name]]
    if vertical:
        axes.secondary_yaxis("right", functions=functions).set_ylabel(label)
    else:
        axes.secondary_xaxis("top", functions=functions).set_xlabel(label)


def value_range(values: np.ndarray, sampled: np.ndarray) -> tuple[float, float]:
    """Limits of a vertical axis, with room for the caption at the top.

    They hold all sampled rows. The other rows may add at most as much again on either side, so that a start far from
    equilibrium does not flatten what is measured; beyond that its line leaves the panel.
    """
    finite = np.isfinite(values)
    outer_low, outer_high = np.percentile(values[finite], [1.0, 99.0])
    low, high = outer_low, outer_high
    kept = values[finite & sampled]
    if kept.size:
        span = kept.max() - kept.min()
        low = min(kept.min(), max(outer_low, kept.min() - span))
        high = max(kept.max(), min(outer_high, kept.max() + span))
    size = max(abs(low), abs(high)) or 1.0
    span = high - low if high - low > 1e-9 * size else 0.01 * size  # no magnifying of round-off
    return low - 0.08 * span, high + 0.35 * span


def draw_stage(axes: plt.Axes, run: FluidRun, stage: Stage, name: str, colour: str) -> None:
    """Shade a sampled stage; on it the block averages, and the mean of the run as a band of one standard error."""
    rows = run.rows_of(stage)
    time = run.thermo["time"][rows]
    if time.size == 0:
        return
    axes.axvspan(time[0], time[-1], color="#EEEEEE", zorder=0, linewidth=0, label="sampled stage")
    observable = run.observables.get(name)
    if observable is not None and math.isfinite(observable.mean):
        error = np.nan_to_num(observable.error)
        band = ([observable.mean - error] * 2, [observable.mean + error] * 2)
        axes.fill_between(time[[0, -1]], *band, color=style.ORANGE, alpha=0.45, linewidth=0, zorder=3)
        label = r"mean $\pm$ standard error"
        axes.plot(time[[0, -1]], [observable.mean] * 2, color=style.ORANGE, linewidth=1.5, zorder=3, label=label)
    block_times, block_means, error = block_averages(time, run.thermo[name][rows])
    if block_means.size and np.isfinite(error):
        axes.errorbar(
            block_times, block_means, yerr=error, fmt="o", markersize=3.5, color=colour, markerfacecolor="white",
            markeredgewidth=1.0, elinewidth=1.0, capsize=2.0, zorder=4, label=f"{block_means.size} block averages",
        )


def panel_caption(run: FluidRun, name: str) -> str:
    """The mean with its standard error and, for the total energy, the drift of the sampled stages."""
    parts = []
    observable = run.observables.get(name)
    if observable is not None and math.isfinite(observable.mean):
        symbol = style.LABELS[name].split(" / ")[0].strip("$")
        mean = style.with_uncertainty(observable.mean, observable.error)
        parts.append(rf"$\langle {symbol} \rangle$ = {mean}")
    if name == "total_energy":
        drifts = [stage.energy_drift for stage in run.stages if stage.sampled and stage.energy_drift is not None]
        parts += [rf"conserved energy drifts by {drift:.1e} $\epsilon/\tau$" for drift in drifts]
    return ",  ".join(parts)


def plot_thermo(run: FluidRun) -> plt.Figure:
    """Temperature, energies per atom and pressure against time, one panel each."""
    names = [name for name in PANELS if name in run.thermo and np.isfinite(run.thermo[name]).any()]
    if not names:
        raise damaged(run.path / "thermo.csv", f"no numbers in {', '.join(PANELS)}")
    time = run.thermo["time"]
    sampled_stages = [stage for stage in run.stages if stage.sampled]
    sampled = np.zeros(time.size, dtype=bool)
    for stage in sampled_stages:
        sampled |= run.rows_of(stage)
    figure, grid = plt.subplots(
        len(names), 1, sharex=True, squeeze=False, figsize=(7.0, 1.25 + 1.65 * len(names)), constrained_layout=True
    )
    for axes, name in zip(grid[:, 0], names):
        values = run.thermo[name]
        axes.plot(time, values, color=PANELS[name], linewidth=0.6, alpha=0.7, marker="." if time.size < 3 else "")
        axes.set_ylim(value_range(values, sampled))
        for stage in sampled_stages:
            draw_stage(axes, run, stage, name, PANELS[name])
        axes.set_ylabel(style.LABELS[name])
        axes.text(
            0.99, 0.95, panel_caption(run, name), transform=axes.transAxes, ha="right", va="top", fontsize=9, zorder=5,
            bbox={"facecolor": "white", "alpha": 0.75, "edgecolor": "none", "pad": 1.5},
        )
        add_si_axis(axes, run.thermo, name, vertical=True)
    if time[-1] > time[0]:
        grid[0, 0].set_xlim(time[0], time[-1])
    add_si_axis(grid[0, 0], run.thermo, "time", vertical=False)
    grid[-1, 0].set_xlabel(style.LABELS["time"])
    legend = dict(zip(*grid[-1, 0].get_legend_handles_labels()[::-1]))  # one entry for each label
    if legend:
        grid[-1, 0].legend(
            legend.values(), legend.keys(), loc="upper center", bbox_to_anchor=(0.5, -0.32), ncol=len(legend)
        )
    figure.align_ylabels(grid[:, 0])
    style.head(figure, run.title, run.status)
    return figure


def read_rdf(path: Path) -> Optional[Table]:
    """g(r) with its errors; None when it has no value."""
    return structure_pictures.read(path, RDF_COLUMNS[0], RDF_COLUMNS[1:])


def plot_rdf(run: FluidRun, table: Table) -> plt.Figure:
    """g(r) with a band of one standard error; its peaks carry their place and height."""
    r, g, error = (table[name] for name in RDF_COLUMNS)
    figure, axes = plt.subplots(figsize=(7.0, 4.5), constrained_layout=True)
    band = rf"$\pm$ standard error (at most {np.nanmax(error, initial=0.0):.2g})"
    axes.axhline(1.0, color=style.GREY, linewidth=0.8, linestyle="--")
    axes.fill_between(r, g - error, g + error, color=style.SKY, alpha=0.6, linewidth=0, label=band)
    axes.plot(r, g, color=style.BLUE, linewidth=1.3)
    for top in peaks(r, g, error):
        place, height = summit(r, g, error, top)
        axes.annotate(
            f"{height:.2f} at {place:.2f}$\\,\\sigma$", (place, height), xytext=(0, 6), textcoords="offset points",
            ha="center", va="bottom", fontsize=9,
        )
    axes.set_xlim(0.0, r[-1])
    axes.set_ylim(0.0, 1.12 * max(1.0, float(np.nanmax(g))))
    axes.set_xlabel(style.LABELS["r"])
    axes.set_ylabel(style.LABELS["g"])
    axes.legend(loc="upper right")
    add_si_axis(axes, table, "r", vertical=False)
    style.head(figure, run.title)
    return figure


def pictures(path: Path) -> dict[str, Callable[[], plt.Figure]]:
    """What draws the pictures of a run, by name."""
    run = fluids.load(path)
    figures: dict[str, Callable[[], plt.Figure]] = {"thermo": partial(plot_thermo, run)}
    configuration = atoms_picture.last_configuration(path)
    if configuration is not None:
        figures["atoms"] = partial(atoms_picture.plot_atoms, path, configuration)
    return figures | pictures_of_tables(run)


def pictures_of_tables(run: FluidRun) -> dict[str, Callable[[], plt.Figure]]:
    """What draws the tables of a run, or of `ljmd analyze`, by name."""
    path = run.path / "rdf.csv"
    table = read_rdf(path) if is_there(path) else None
    figures = {} if table is None else {"rdf": partial(plot_rdf, run, table)}
    return figures | structure_pictures.pictures(run)
