"""Pictures of time correlations: scattering functions by wave number, displacements by time.

Each function draws one table of a run of a fluid, in which one curve stands below the other.
"""

from __future__ import annotations

from functools import partial

import numpy as np
import style
from ljmd.reading.fluids import FluidRun
from ljmd.reading.tables import Table
from style import plt

MOST_CURVES = 8     # of a table that has more every second one is drawn, or every third
SIZE = (7.0, 4.5)
OF_FIRST = ("F", "C_L", "C_T")      # drawn as parts of their values at t = 0, which differ by powers of ten
OF_NOTHING = 0.01                   # of the largest value of a spectrum: beyond there is nothing to see
MODES = {                           # each may be missing at any wave number
    "sound_velocity": r"$c$ / ($\sigma/\tau$)",
    "sound_attenuation": r"$\Gamma$ / ($\sigma^2/\tau$)",
    "transverse_viscosity": r"$\eta$ / ($\epsilon \tau/\sigma^3$)",
    "self_diffusion": r"$D$ / ($\sigma^2/\tau$)",
}


def curves(table: Table, group: str) -> list[tuple[float, np.ndarray]]:
    """The value of each curve that is drawn, and its rows."""
    values = np.unique(table[group])
    drawn = values[::-(-values.size // MOST_CURVES)]
    return [(float(value), np.flatnonzero(table[group] == value)) for value in drawn]


def grouped(run: FluidRun, table: Table, *, group: str, x: str, names: tuple[str, ...], labels: tuple[str, ...], along: str, of: str) -> plt.Figure:
    """A panel for each column of `names`, with a curve for each value of `group`."""
    figure, grid = plt.subplots(len(names), 1, sharex=True, squeeze=False, constrained_layout=True, figsize=(SIZE[0], 1.5 + 3.0 * len(names)))
    for axes, name, label in zip(grid.flat, names, labels):
        axes.axhline(0.0, color=style.GREY, linewidth=0.8)
        for k, (value, rows) in enumerate(curves(table, group)):
            size = table[name][rows[0]] if name in OF_FIRST else 1.0
            at, y = table[x][rows], table[name][rows] / size
            error = np.nan_to_num(table[f"{name}_standard_error"][rows]) / size
            axes.fill_between(at, y - error, y + error, color=style.colour(k), alpha=0.3, linewidth=0)
            axes.plot(at, y, color=style.colour(k), linewidth=1.2, label=f"{value:.3g}")
        axes.set_ylabel(label)
        style.time_axis(axes, table[x])
        if name == "S_kw":
            there = table[x][table[name] > OF_NOTHING * float(np.max(table[name]))]
            axes.set_xlim(0.0, min(1.2 * float(there.max()), float(table[x].max())))
    grid.flat[0].legend(title=of, loc="upper right", fontsize=8)
    grid.flat[-1].set_xlabel(along)
    style.head(figure, run.title)
    return figure


def non_gaussian(run: FluidRun, table: Table) -> plt.Figure:
    """alpha_2, with its largest value."""
    figure, axes = plt.subplots(figsize=SIZE, constrained_layout=True)
    time, alpha, error = table["time"], table["alpha_2"], np.nan_to_num(table["alpha_2_standard_error"])
    axes.axhline(0.0, color=style.GREY, linewidth=0.8, linestyle="--", label="normal distribution")
    axes.fill_between(time, alpha - error, alpha + error, color=style.BLUE, alpha=0.3, linewidth=0)
    axes.plot(time, alpha, color=style.BLUE, linewidth=1.3)
    top = int(np.argmax(alpha))
    axes.annotate(rf"{style.with_uncertainty(float(alpha[top]), float(error[top]))} at {time[top]:.2f} $\tau$", (time[top], alpha[top]),
                  xytext=(0, 16), ha="center", textcoords="offset points", fontsize=9)
    axes.set_xlim(0.0, time[-1])
    axes.margins(y=0.12)
    axes.set_xlabel(r"$t$ / $\tau$")
    axes.set_ylabel(r"$\alpha_2(t)$")
    axes.legend(loc="upper right")
    style.head(figure, run.title)
    return figure


def modes(run: FluidRun, table: Table) -> plt.Figure:
    """Speed and attenuation of sound, viscosity and diffusion at each wave number, where there are values."""
    drawn = [(name, label) for name, label in MODES.items() if np.isfinite(table[name]).any()]
    columns = 2 if len(drawn) > 1 else 1
    figure, grid = plt.subplots(-(-len(drawn) // columns), columns, sharex=True, squeeze=False, constrained_layout=True,
                                figsize=(4.2 * columns, 1.0 + 2.8 * -(-len(drawn) // columns)))
    for axes, (name, label) in zip(grid.flat, drawn):
        known = np.isfinite(table[name])
        axes.errorbar(table["k"][known], table[name][known], table[f"{name}_standard_error"][known], fmt="o", color=style.BLUE,
                      markersize=4, elinewidth=1.0, capsize=2)
        axes.set_ylabel(label)
        axes.set_xlim(0.0, 1.05 * float(table["k"].max()))
        axes.margins(y=0.15)
        axes.xaxis.set_tick_params(labelbottom=True)
        axes.set_xlabel(r"$k \sigma$")
    for axes in grid.flat[len(drawn):]:
        axes.set_visible(False)
    style.head(figure, run.title)
    return figure


def _of(group: str, x: str, names: tuple[str, ...], labels: tuple[str, ...]):
    """An entry of PICTURES: first column, the others, how."""
    along = {"time": r"$t$ / $\tau$", "r": r"$r$ / $\sigma$", "angular_frequency": r"$\omega \tau$"}[x]
    of = {"k": r"$k \sigma$", "time": r"$t/\tau$"}[group]
    errors = tuple(f"{name}_standard_error" for name in names)
    return group, (x, *names, *errors), partial(grouped, group=group, x=x, names=names, labels=labels, along=along, of=of)


# table -> its first column, the others that are drawn, how
PICTURES = {
    "fkt": _of("k", "time", ("F", "C_L", "C_T"), (r"$F(k, t)/F(k, 0)$", r"$C_L(k, t)/C_L(k, 0)$", r"$C_T(k, t)/C_T(k, 0)$")),
    "fskt": _of("k", "time", ("F_s",), (r"$F_s(k, t)$",)),
    "skw": _of("k", "angular_frequency", ("S_kw",), (r"$S(k, \omega)$ / $\tau$",)),
    "gs": _of("time", "r", ("G_s",), (r"$G_s(r, t)$ / $\sigma^{-3}$",)),
    "gd": _of("time", "r", ("G_d",), (r"$G_d(r, t)$ / $\sigma^{-3}$",)),
    "modes": ("k", tuple(name + end for name in MODES for end in ("", "_standard_error")), modes),
    "alpha2": ("time", ("alpha_2", "alpha_2_standard_error"), non_gaussian),
}
REPEATING = ("fkt", "fskt", "skw", "gs", "gd", "modes")   # whose first column has a value for each row of a curve
