"""The pictures of a few-body run: orbits, phase portraits, errors of conserved quantities."""

from __future__ import annotations

import math
import sys
from functools import partial
from pathlib import Path
from typing import Callable

import few_body_points
import numpy as np
import style
from ljmd.reading import few_bodies
from ljmd.reading.few_bodies import FewBodyRun
from ljmd.reading.trajectories import spread
from style import plt

MOST_PANELS = 16
MOST_COMPARED = 12  # bodies whose tracks are compared
CONSERVED = {"momentum": "$P$", "angular_momentum": "$L$"}  # prefix of the columns, symbol


def pictures(path: Path, relative_to: int = 1) -> dict[str, Callable[[], plt.Figure]]:
    """What draws the pictures that suit a run, by name; `relative_to` is a body, counted from 1."""
    run = few_bodies.load(path)
    if run.trajectory is None:
        print(f"{run.path / 'trajectory.csv'}: not there, no pictures of orbits", file=sys.stderr)
    return pictures_of(run, few_body_points.body_index(run, relative_to))


def pictures_of(run: FewBodyRun, relative_to: int) -> dict[str, Callable[[], plt.Figure]]:
    """As pictures(); the body is counted from 0."""
    made: dict[str, Callable[[], plt.Figure]] = {"energy": partial(plot_energy, run)}
    points = few_body_points.plane_points(run)
    if points is not None and run.force != "pendulum":  # which only ever draws its circle
        made["orbit"] = partial(plot_orbit, run, points)
    if few_body_points.phase_points(run) is not None:
        made["phase"] = partial(plot_phase, run)
    if momentum_columns(run):
        made["momentum"] = partial(plot_momentum, run)
    if run.trajectory is not None and run.bodies > 1:
        made["relative"] = partial(plot_relative, run, relative_to)
    return made


def coincide(one: np.ndarray, other: np.ndarray) -> bool:
    """Whether nearly all points of a path (F, 2) lie on another path, within 0.3 % of its size."""
    size = float(np.ptp(other, axis=0).max())
    if size == 0.0:
        return False
    some, other = one[spread(len(one), 100)], other[spread(len(other), 4000)]
    start, step = other[:-1], np.diff(other, axis=0)
    length = np.maximum((step**2).sum(axis=1), 1e-300)
    along = np.clip(((some[:, np.newaxis] - start) * step).sum(axis=2) / length, 0.0, 1.0)
    nearest = np.linalg.norm(start + along[..., np.newaxis] * step - some[:, np.newaxis], axis=2).min(axis=1)
    return bool(np.mean(nearest < 0.003 * size) > 0.9)


def widths(points: np.ndarray) -> list[float]:
    """Widths of the paths (F, N, 2): those on the same track are each thinner than the one below, so that all are seen."""
    bodies = points.shape[1]
    below = [0] * bodies  # how many of the later ones lie on the track of a body
    if len(points) > 2 and bodies <= MOST_COMPARED:
        for body in range(bodies):
            below[body] = sum(coincide(points[:, later], points[:, body]) for later in range(body + 1, bodies))
    return [0.9 + 2.4 * count for count in below]


def draw_paths(axes: plt.Axes, run: FewBodyRun, points: np.ndarray) -> None:
    """The path of every body in a plane with equal scales: open circle at its start, full one at its end."""
    for body, width in enumerate(widths(points)):
        x, y = points[:, body].T
        axes.plot(x, y, color=style.colour(body), linewidth=width, label=run.name(body), zorder=2)
        draw_ends(axes, x, y, style.colour(body))
    axes.set_aspect("equal", adjustable="datalim")
    axes.margins(0.08)


def draw_ends(axes: plt.Axes, x: np.ndarray, y: np.ndarray, colour: str) -> None:
    """An open circle where a path starts, a smaller full one where it ends: both are seen where it is closed."""
    axes.plot(x[0], y[0], "o", color=colour, markerfacecolor="white", markersize=9.0, markeredgewidth=1.3, zorder=3)
    axes.plot(x[-1], y[-1], "o", color=colour, markeredgecolor="white", markeredgewidth=0.7, markersize=6.0, zorder=4)


def legend_of_paths(axes: plt.Axes, bodies: int) -> None:
    """The bodies, where there are several, and what the circles mean, beside the panel."""
    handles = axes.get_legend_handles_labels()[0] if bodies > 1 else []
    ends = [plt.Line2D([], [], marker="o", linestyle="", color=style.GREY, markerfacecolor=face, markersize=6, label=label)
            for face, label in (("white", "start"), (style.GREY, "end"))]
    style.legend_beside(axes, handles=[*handles, *ends], ncol=math.ceil(bodies / 20))


def plane_panel(points: np.ndarray) -> tuple[plt.Figure, plt.Axes]:
    """An empty panel about as high as the paths (..., 2) want it with equal scales."""
    width, height = np.ptp(points.reshape(-1, 2), axis=0)
    shape = height / width if width > 0.0 else 1.0
    return plt.subplots(figsize=(7.0, 1.0 + 5.0 * min(max(shape, 0.5), 1.0)), constrained_layout=True)


def plot_orbit(run: FewBodyRun, points: np.ndarray) -> plt.Figure:
    """Where the bodies went, in the x-y plane."""
    figure, axes = plane_panel(points)
    draw_paths(axes, run, points)
    if run.bodies == 1:
        axes.plot(0.0, 0.0, "+", color=style.BLACK, markersize=9)
    seen_along_z = run.trajectory.positions.shape[2] == 3
    axes.set_xlabel("$x$")
    axes.set_ylabel("$y$   (seen along $z$)" if seen_along_z else "$y$")
    legend_of_paths(axes, run.bodies)
    style.head(figure, run.title, run.status)
    return figure


def plot_relative(run: FewBodyRun, reference: int) -> plt.Figure:
    """The paths as seen from one body; against time where there is but one dimension."""
    points = few_body_points.relative(run.trajectory.positions, reference)
    seen_from = f"from {style.plain(run.name(reference))}"
    if points.shape[2] == 1:
        figure, axes = plt.subplots(figsize=(7.0, 4.5), constrained_layout=True)
        for body in range(run.bodies):
            axes.plot(run.trajectory.time, points[:, body, 0], color=style.colour(body), label=run.name(body))
        axes.set_xlabel("$t$")
        axes.set_ylabel(f"{few_body_points.coordinate(run)[0]} {seen_from}")
        style.legend_beside(axes, ncol=math.ceil(run.bodies / 20))
    else:
        figure, axes = plane_panel(points[:, :, :2])
        draw_paths(axes, run, points[:, :, :2])
        axes.set_xlabel(f"$x$ {seen_from}")
        axes.set_ylabel(f"$y$ {seen_from}")
        legend_of_paths(axes, run.bodies)
    style.head(figure, run.title, run.status)
    return figure


def plot_phase(run: FewBodyRun) -> plt.Figure:
    """Velocity against the first coordinate, a panel for each body."""
    points = few_body_points.phase_points(run)
    panels = min(run.bodies, MOST_PANELS)
    columns = panels if panels <= 3 else math.ceil(math.sqrt(panels))
    rows = math.ceil(panels / columns)
    size = (7.0, 5.0) if panels == 1 else (1.0 + 3.2 * columns, 0.5 + 2.8 * rows)
    figure, grid = plt.subplots(rows, columns, squeeze=False, figsize=size, constrained_layout=True)
    for body, axes in enumerate(grid.flat):
        if body >= panels:
            axes.set_visible(False)
            continue
        position, velocity = points[:, body].T
        colour = style.colour(body)
        axes.plot(position, velocity, color=colour, linewidth=0.9)
        draw_ends(axes, position, velocity, colour)
        axes.set_xlabel(few_body_points.coordinate(run)[0])
        axes.set_ylabel(few_body_points.coordinate(run)[1])
        axes.margins(0.08)
        if run.bodies > 1:
            axes.set_title(style.plain(run.name(body)), fontsize=10)
    legend_of_paths(grid[0, -1], 1)
    style.head(figure, run.title, run.status if run.bodies == 1 else "")
    if panels < run.bodies:
        grid[-1, 0].set_xlabel(f"{few_body_points.coordinate(run)[0]}\nbodies 1 to {panels} of {run.bodies}")
    return figure


def worst(values: np.ndarray) -> float:
    """The largest absolute value; 0 where there is no number."""
    return float(np.nanmax(np.abs(values), initial=0.0))


def plot_energy(run: FewBodyRun) -> plt.Figure:
    """How far the total energy is from its start, above the energies themselves."""
    time, energy = run.thermo["time"], run.thermo["total_energy"]
    figure, (upper, lower) = plt.subplots(2, 1, sharex=True, figsize=(7.0, 5.6), constrained_layout=True)
    error = energy - energy[0]
    marker = "." if time.size < 3 else ""
    upper.plot(time, error, color=style.BLACK, linewidth=0.9, marker=marker)
    upper.set_ylabel("$E - E(0)$")
    relative = f" = {worst(error) / abs(energy[0]):.2g} $|E(0)|$" if energy[0] != 0.0 else ""
    for name, colour, label in (
        ("kinetic_energy", style.PURPLE, "kinetic"),
        ("potential_energy", style.BLUE, "potential"),
        ("total_energy", style.BLACK, "total"),
    ):
        lower.plot(time, run.thermo[name], color=colour, linewidth=0.9, marker=marker, label=label)
    lower.set_xlabel("$t$")
    lower.set_ylabel("energy")
    style.legend_beside(lower)
    largest = f"largest $|E - E(0)|$ = {worst(error):.2g}{relative}"
    style.head(figure, run.title, "; ".join(filter(None, [largest, run.status])))
    return figure


def momentum_columns(run: FewBodyRun) -> dict[str, list[str]]:
    """Columns of the momenta, by prefix. The momentum of a single body is no error: something fixed acts on it."""
    found = {}
    for prefix in CONSERVED:
        columns = [f"{prefix}_{axis}" for axis in "xyz" if f"{prefix}_{axis}" in run.thermo]
        if columns and (prefix == "angular_momentum" or run.bodies > 1):
            found[prefix] = columns
    return found


def plot_momentum(run: FewBodyRun) -> plt.Figure:
    """How far momentum and angular momentum of the system are from their start."""
    columns_of = momentum_columns(run)
    size = (7.0, 0.8 + 2.4 * len(columns_of))
    figure, grid = plt.subplots(len(columns_of), 1, sharex=True, squeeze=False, figsize=size, constrained_layout=True)
    time = run.thermo["time"]
    marker = "." if time.size < 3 else ""
    for axes, (prefix, columns) in zip(grid[:, 0], columns_of.items()):
        symbol = CONSERVED[prefix].strip("$")
        for k, column in enumerate(columns):
            error = run.thermo[column] - run.thermo[column][0]
            label = f"${symbol}_{column[-1]}$ from {run.thermo[column][0]:.6g}"
            axes.plot(time, error, color=style.colour(k), linewidth=0.9, marker=marker, label=label)
        axes.set_ylabel(f"${symbol} - {symbol}(0)$")
        style.legend_beside(axes)
    grid[-1, 0].set_xlabel("$t$")
    figure.align_ylabels(grid[:, 0])
    style.head(figure, run.title, run.status)
    return figure
