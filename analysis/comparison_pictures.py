"""The picture of a comparison of ljmd with OpenMM, LAMMPS, an engine of the user or, for few bodies, an adaptive
solution of high order (GSL).

What was not compared is left out. Of the trajectories: the distance of the atom that is furthest off, with the fitted
growth exp(lambda t) and what the checks allow. Of long runs: g(r) of both programs with its difference, and the averages
by their difference over its standard error. Of few bodies: errors against time.
"""

from __future__ import annotations

import math
import re
from dataclasses import dataclass
from functools import partial
from pathlib import Path
from typing import Callable, Optional

import numpy as np
import style
from ljmd.reading import comparisons
from ljmd.reading.comparisons import RDF_COLUMNS, Check, FluidComparison
from ljmd.reading.files import is_there
from ljmd.reading.tables import Table
from style import plt

PROGRAMS = {"openmm": "OpenMM", "lammps": "LAMMPS", "engine": "the engine"}
GSL_ERRORS = {"position_error": "position", "velocity_error": "velocity", "energy_error": "energy",
              "angular_momentum_error": "angular momentum"}
FITTED = (1e-12, 1e-2)  # distances that ljmd fits the growth to [sigma]


@dataclass(frozen=True)
class Growth:
    """d = factor * exp(rate * t) between two times."""

    rate: float
    factor: float
    first: float
    last: float

    def __call__(self, time: np.ndarray) -> np.ndarray:
        return self.factor * np.exp(self.rate * time)


def growth(time: np.ndarray, distance: np.ndarray, rate: Optional[float]) -> Optional[Growth]:
    """The fitted exponential of that rate: through the middle of the rows that ljmd fitted it to."""
    fitted = (distance > FITTED[0]) & (distance < FITTED[1])
    if rate is None or not fitted.any():
        return None
    offset = float(np.mean(np.log(distance[fitted]) - rate * time[fitted]))
    return Growth(rate, math.exp(offset), float(time[fitted][0]), float(time[fitted][-1]))


def allowed(comparison: FluidComparison, pairing: str) -> list[tuple[float, Check]]:
    """The checks of one pairing, each with its time."""
    ours, theirs = pairing.split(" - ", 1)
    found = []
    for check in comparison.checks:
        match = re.fullmatch(r"step (\d+): (.*)", check.name)
        if match and match[2] in (f"{ours} and {theirs}", "positions"):  # the latter of an engine, which has one pairing
            found.append((int(match[1]) * comparison.time_step, check))
    return found


def draw_trajectory(axes: plt.Axes, comparison: FluidComparison) -> None:
    """Distance of the furthest atom; in the colour of its pairing what is allowed, filled where it was exceeded."""
    time = comparison.trajectory["time"]
    for k, pairing in enumerate(comparison.pairings):
        distance = comparison.trajectory[pairing]
        apart = distance > 0.0  # the start is the same, and a logarithm has no place for it
        label = style.plain(pairing.replace(" - ", ", "))
        # Pairings may lie on each other: each is thinner than the one below, and its marks are smaller.
        axes.plot(time[apart], distance[apart], color=style.colour(k), linewidth=max(0.8, 2.6 - 0.9 * k), label=label)
        for at, check in allowed(comparison, pairing):
            face = "none" if check.passed else style.colour(k)
            axes.plot(at, check.tolerance, linestyle="", marker="v", markersize=max(3.5, 9.0 - 2.5 * k),
                      color=style.colour(k), markerfacecolor=face)
    line = growth(time, comparison.trajectory[comparison.pairings[0]], comparison.rate)
    if line is not None:
        ends = np.array([line.first, line.last])
        label = rf"$\propto \exp({line.rate:.2f}\,t/\tau)$"
        axes.plot(ends, line(ends), color=style.BLACK, linewidth=1.0, linestyle="--", label=label)
    judged = [check for pairing in comparison.pairings for _, check in allowed(comparison, pairing)]
    if judged:
        label = "allowed" if all(check.passed for check in judged) else "allowed (filled: exceeded)"
        axes.plot([], [], linestyle="", marker="v", markersize=6.5, color=style.GREY, markerfacecolor="none",
                  label=label)
    axes.set_yscale("log")
    end = time[-1] or 1.0
    axes.set_xlim(-0.03 * end, 1.03 * end)  # marks at the first and the last step are not cut
    axes.set_xlabel(style.LABELS["time"])
    axes.set_ylabel(r"distance of the furthest atom / $\sigma$")
    axes.legend(loc="lower right", title=f"ljmd, {PROGRAMS[comparison.program]}", title_fontsize=9)


def draw_rdf(axes: plt.Axes, below: plt.Axes, comparison: FluidComparison) -> None:
    """g(r) of both programs, and below their difference with a band of its standard error."""
    r, ours, our_error, theirs, their_error = (comparison.rdf[name] for name in RDF_COLUMNS)
    axes.plot(r, ours, color=style.BLUE, linewidth=2.6, label="ljmd")
    axes.plot(r, theirs, color=style.VERMILION, linewidth=0.9, label=PROGRAMS[comparison.program])
    axes.set_ylabel(style.LABELS["g"])
    axes.set_ylim(0.0, None)
    axes.legend(loc="upper right")
    axes.tick_params(labelbottom=False)
    difference, error = ours - theirs, np.hypot(our_error, their_error)
    below.fill_between(r, -error, error, color=style.SKY, alpha=0.6, linewidth=0, label=r"$\pm$ standard error")
    below.plot(r, difference, color=style.BLACK, linewidth=0.6)
    most = 1.5 * max(float(np.nanmax(np.abs(difference), initial=0.0)), float(np.nanmax(error, initial=0.0))) or 1.0
    below.set_ylim(-most, 2.0 * most)  # room for the legend
    below.locator_params(axis="y", nbins=5)
    below.set_xlim(0.0, r[-1])
    below.set_xlabel(style.LABELS["r"])
    below.set_ylabel("difference")
    below.legend(loc="upper right")


def draw_averages(axes: plt.Axes, comparison: FluidComparison) -> None:
    """Differences of averages in units of their standard error, with the numbers; grey is what is allowed."""
    peer = PROGRAMS[comparison.program]
    labels, reach = [], 0.0
    for row, average in enumerate(comparison.averages):
        symbol = style.LABELS.get(average.name, average.name).split(" / ")[0]
        both = [style.with_uncertainty(*side) for side in (average.ours, average.theirs)]
        labels.append(f"{symbol}:  ljmd {both[0]},  {peer} {both[1]}")
        check = comparison.check(f"mean {average.name}, standard errors apart")
        if check is not None:
            axes.barh(row, 2.0 * check.tolerance, left=-check.tolerance, height=1.0, color="#EEEEEE", zorder=0)
            reach = max(reach, check.tolerance)
        if average.error > 0.0 and math.isfinite(average.difference):
            sigmas = average.difference / average.error
            colour = style.BLUE if check is None or check.passed else style.VERMILION
            axes.errorbar(sigmas, row, xerr=1.0, fmt="o", color=colour, markersize=4.5, capsize=3.0)
            reach = max(reach, abs(sigmas) + 1.0)
    axes.set_yticks(range(len(labels)), labels)
    axes.tick_params(axis="y", length=0)
    axes.set_ylim(len(labels) - 0.5, -0.5)
    axes.set_xlim(-1.15 * (reach or 1.0), 1.15 * (reach or 1.0))
    axes.axvline(0.0, color=style.BLACK, linewidth=0.8)
    parts = "averages" if comparison.program == "engine" else "averages without tail"
    axes.set_xlabel(f"{parts}: difference / its standard error")


def plot(comparison: FluidComparison) -> plt.Figure:
    """One picture with a panel for all that was compared."""
    columns = [["trajectory", "trajectory"]] if comparison.trajectory is not None else []
    columns += [["g", "difference"]] if comparison.rdf is not None else []
    heights = ([4.4] if columns else []) + ([0.7 + 0.3 * len(comparison.averages)] if comparison.averages else [])
    figure = plt.figure(figsize=(8.0, 0.5 + sum(heights)), constrained_layout=True)
    # The rows are laid out apart: the numbers beside the averages take no room from the panels above.
    parts = list(figure.subfigures(len(heights), 1, height_ratios=heights, squeeze=False)[:, 0])
    if columns:
        axes = parts.pop(0).subplot_mosaic([list(row) for row in zip(*columns)],
                                           gridspec_kw={"height_ratios": [2.4, 1.0],
                                                        "width_ratios": [1.25, 1.0][: len(columns)]})
        if comparison.trajectory is not None:
            draw_trajectory(axes["trajectory"], comparison)
        if comparison.rdf is not None:
            axes["g"].sharex(axes["difference"])
            draw_rdf(axes["g"], axes["difference"], comparison)
    if comparison.averages:
        draw_averages(parts.pop(0).subplots(), comparison)
    style.head(figure, *caption(comparison))
    return figure


def caption(comparison: FluidComparison) -> tuple[str, str]:
    """Deck, program, its version where the long runs are another's; and whether all is well."""
    peers = dict.fromkeys([
        *([comparison.peer] if comparison.trajectory is not None else []),
        *([comparison.peer_of_long_runs] if comparison.averages else []),
    ])
    failed = sum(not check.passed for check in comparison.checks)
    total = len(comparison.checks)
    verdict = f"{failed} of {total} checks FAILED" if failed else f"all {total} checks passed"
    return f"{Path(comparison.deck).name} against {', long runs '.join(peers)}", verdict


def plot_errors(deck: str, table: Table) -> plt.Figure:
    """Errors of a few-body run against the adaptive solution, and how far two such solutions are apart."""
    figure, axes = plt.subplots(figsize=(7.0, 4.8), constrained_layout=True)
    time = table["time"]
    for k, (name, label) in enumerate(GSL_ERRORS.items()):
        error = np.abs(table[name]) if name in table else np.zeros(time.size)
        seen = error > 0.0  # a logarithm has no place for the start, where there is none
        if seen.any():
            axes.plot(time[seen], error[seen], color=style.colour(k), linewidth=1.0, label=label)
    reference = table["reference_error"]
    if (reference > 0.0).any():
        axes.plot(time[reference > 0.0], reference[reference > 0.0], color=style.GREY, linewidth=1.0, linestyle="--",
                  label="between two\nreferences")
    axes.set_yscale("log")
    axes.set_xlabel("$t$")
    axes.set_ylabel("error, in the units of the deck")
    style.legend_beside(axes)
    style.head(figure, f"{Path(deck).name} against an adaptive Runge-Kutta method of order 8 (GSL)")
    return figure


def draw_gsl(directory: Path) -> plt.Figure:
    return plot_errors(*comparisons.load_gsl(directory))


def pictures(directory: Path) -> dict[str, Callable[[], plt.Figure]]:
    """What draws each comparison in a directory, by its name."""
    figures: dict[str, Callable[[], plt.Figure]] = {}
    for name in ("openmm", "lammps"):
        if is_there(directory / f"compare-{name}.json"):
            figures[f"compare-{name}"] = partial(lambda name: plot(comparisons.load(directory, name)), name)
    if is_there(directory / "judge.json"):
        figures["judge"] = lambda: plot(comparisons.load_judgement(directory))
    if is_there(directory / "compare-gsl.json"):
        figures["compare-gsl"] = partial(draw_gsl, directory)
    return figures
