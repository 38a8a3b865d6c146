"""Pictures of what a run found of structure and motion: S(k), displacements, velocities, stresses.

Each function draws one table of a run of a fluid; `pictures` draws those that the run directory holds.
"""

from __future__ import annotations

import math
import sys
from functools import partial
from pathlib import Path
from typing import Callable, Optional, Sequence

import numpy as np
import style
import time_pictures
from ljmd.reading.files import damaged, is_there
from ljmd.reading.fluids import FluidRun
from ljmd.reading.tables import Table, read_table
from style import plt

SIZE = (7.0, 4.5)


def draw_band(axes: plt.Axes, x: np.ndarray, y: np.ndarray, error: np.ndarray, colour: str, label: str = "") -> None:
    """A curve with a band of one standard error, where that is known."""
    error = np.nan_to_num(error)
    axes.fill_between(x, y - error, y + error, color=colour, alpha=0.3, linewidth=0)
    axes.plot(x, y, color=colour, linewidth=1.3, label=label or None)


def caption(run: FluidRun, name: str, symbol: str, unit: str) -> str:
    """A mean of the run with its standard error, for a legend."""
    observable = run.observables.get(name)
    if observable is None or math.isnan(observable.mean):
        return symbol
    return rf"{symbol} = {style.with_uncertainty(observable.mean, observable.error)} {unit}"


def finish(figure: plt.Figure, run: FluidRun) -> plt.Figure:
    style.head(figure, run.title)
    return figure


def structure_factor(run: FluidRun, table: Table) -> plt.Figure:
    """S(k) with the transform of g(r) beside it, where that is there."""
    figure, axes = plt.subplots(figsize=SIZE, constrained_layout=True)
    axes.axhline(1.0, color=style.GREY, linewidth=0.8, linestyle="--")
    k, s = table["k"], table["S"]
    path = run.path / "sk_from_rdf.csv"
    if is_there(path):
        other = read_table(path, ("k", "S"), increasing=("k",))
        near = other["k"] <= k[-1]
        axes.plot(other["k"][near], other["S"][near], color=style.ORANGE, linewidth=1.0, label="from g(r)")
    draw_band(axes, k, s, table["S_standard_error"], style.BLUE, "from the density")
    top = int(np.argmax(s))
    axes.annotate(f"{s[top]:.2f} at {k[top]:.2f}/$\\sigma$", (k[top], s[top]), xytext=(6, 0),
                  textcoords="offset points", va="center", fontsize=9)
    axes.set_xlim(0.0, k[-1])
    axes.set_ylim(0.0, 1.12 * float(np.max(s)))
    axes.set_xlabel(r"$k$ / $\sigma^{-1}$")
    axes.set_ylabel(r"$S(k)$")
    axes.legend(loc="upper right")
    return finish(figure, run)


def displacement(run: FluidRun, table: Table) -> plt.Figure:
    """The mean-square displacement, and a line with the slope of the diffusion found."""
    figure, axes = plt.subplots(figsize=SIZE, constrained_layout=True)
    time, msd = table["time"], table["msd"]
    draw_band(axes, time, msd, table["msd_standard_error"], style.BLUE, "mean-square displacement")
    is_long = style.time_axis(axes, time)
    if is_long:
        axes.set_yscale("log", nonpositive="mask")
    else:
        axes.set_ylim(bottom=0.0)
    diffusion = run.observables.get("diffusion")
    if diffusion is not None and math.isfinite(diffusion.mean):
        # Through the last point; at long times, where both axes are logarithmic, through the origin.
        line = 6.0 * diffusion.mean * time if is_long else msd[-1] + 6.0 * diffusion.mean * (time - time[-1])
        label = caption(run, "diffusion", r"slope $6D$, $D$", r"$\sigma^2/\tau$")
        axes.plot(time[line > 0.0], line[line > 0.0], color=style.ORANGE, linewidth=1.0, linestyle="--", label=label)
    axes.set_xlabel(style.LABELS["time"])
    axes.set_ylabel(r"$\langle |r(t) - r(0)|^2 \rangle$ / $\sigma^2$")
    axes.legend(loc="upper left")
    return finish(figure, run)


def integral_pair(run: FluidRun, time: np.ndarray, above: tuple[np.ndarray, np.ndarray, str],
                  below: tuple[np.ndarray, np.ndarray, str], label: str) -> plt.Figure:
    """A correlation function and, below, the integral of it up to each time."""
    figure, (upper, lower) = plt.subplots(2, 1, sharex=True, figsize=(7.0, 6.0), constrained_layout=True)
    for axes, (values, error, name), colour in ((upper, above, style.BLUE), (lower, below, style.GREEN)):
        axes.axhline(0.0, color=style.GREY, linewidth=0.8, linestyle="--")
        draw_band(axes, time, values, error, colour, label if axes is lower else "")
        axes.set_ylabel(name)
    lower.legend(loc="lower right")
    style.time_axis(lower, time)
    lower.set_xlabel(style.LABELS["time"])
    figure.align_ylabels([upper, lower])
    return finish(figure, run)


def velocity_autocorrelation(run: FluidRun, table: Table) -> plt.Figure:
    """The normalised velocity autocorrelation, and the diffusion that it adds up to."""
    scale = table["vacf"][0]
    above = (table["vacf"] / scale, table["vacf_standard_error"] / scale, r"$\langle v(0) v(t) \rangle / \langle v^2 \rangle$")
    below = (table["diffusion"], table["diffusion_standard_error"], r"$D(t)$ / ($\sigma^2/\tau$)")
    return integral_pair(run, table["time"], above, below,
                         caption(run, "diffusion_green_kubo", r"$D$", r"$\sigma^2/\tau$"))


def vibrational_spectrum(run: FluidRun, table: Table) -> plt.Figure:
    """The spectrum of the velocities, as far as there is anything in it."""
    figure, axes = plt.subplots(figsize=SIZE, constrained_layout=True)
    frequency, spectrum = table["angular_frequency"], table["spectrum"]
    draw_band(axes, frequency, spectrum, table["spectrum_standard_error"], style.PURPLE)
    rest = np.flatnonzero(spectrum > 0.01 * np.max(spectrum))
    axes.set_xlim(0.0, frequency[min(int(1.2 * rest[-1]) + 1, frequency.size - 1)])
    axes.set_ylim(bottom=min(0.0, float(np.min(spectrum))))
    axes.set_xlabel(r"$\omega$ / $\tau^{-1}$")
    axes.set_ylabel(r"$I(\omega)$ / $\tau$")
    return finish(figure, run)


def stress_autocorrelation(run: FluidRun, table: Table) -> plt.Figure:
    """The stress autocorrelation, and the viscosity that it adds up to."""
    name = "stress_autocorrelation"
    above = (table[name], table[f"{name}_standard_error"], r"$\langle P_{xy}(0) P_{xy}(t) \rangle$ / ($\epsilon^2/\sigma^6$)")
    below = (table["viscosity"], table["viscosity_standard_error"], r"$\eta(t)$ / ($\epsilon \tau/\sigma^3$)")
    return integral_pair(run, table["time"], above, below,
                         caption(run, "viscosity", r"$\eta$", r"$\epsilon \tau/\sigma^3$"))


def film(run: FluidRun, table: Table) -> plt.Figure:
    """The density and the two pressures across a film of liquid."""
    figure, (upper, lower) = plt.subplots(2, 1, sharex=True, figsize=(7.0, 6.0), constrained_layout=True)
    z = table["z"]
    draw_band(upper, z, table["density"], table["density_standard_error"], style.BLUE)
    upper.set_ylim(bottom=0.0)
    upper.set_ylabel(r"$\rho$ / $\sigma^{-3}$")
    lower.axhline(0.0, color=style.GREY, linewidth=0.8, linestyle="--")
    for name, colour, label in (("normal", style.GREEN, "normal"), ("tangential", style.ORANGE, "tangential")):
        draw_band(lower, z, table[f"{name}_pressure"], table[f"{name}_pressure_standard_error"], colour, label)
    title = caption(run, "surface_tension", r"$\gamma$", r"$\epsilon/\sigma^2$")
    lower.legend(loc="lower right", title=title if "=" in title else None)
    lower.set_xlim(z[0], z[-1])
    lower.set_xlabel(r"$z$ / $\sigma$")
    lower.set_ylabel(r"$p$ / ($\epsilon/\sigma^3$)")
    figure.align_ylabels([upper, lower])
    return finish(figure, run)


def pressure_autocorrelation(run: FluidRun, table: Table) -> plt.Figure:
    """The autocorrelation of the pressure, and the bulk viscosity that it adds up to."""
    name = "pressure_autocorrelation"
    above = (table[name], table[f"{name}_standard_error"], r"$\langle \delta p(0) \delta p(t) \rangle$ / ($\epsilon^2/\sigma^6$)")
    below = (table["bulk_viscosity"], table["bulk_viscosity_standard_error"], r"$\eta_v(t)$ / ($\epsilon \tau/\sigma^3$)")
    return integral_pair(run, table["time"], above, below,
                         caption(run, "bulk_viscosity", r"$\eta_v$", r"$\epsilon \tau/\sigma^3$"))


def heat_flux_autocorrelation(run: FluidRun, table: Table) -> plt.Figure:
    """The autocorrelation of the heat flux, and the thermal conductivity that it adds up to."""
    name = "heat_flux_autocorrelation"
    above = (table[name], table[f"{name}_standard_error"],
             r"$\langle \mathbf{J}(0) \cdot \mathbf{J}(t) \rangle / 3$ / ($\epsilon^2/\sigma^4\tau^2$)")
    below = (table["thermal_conductivity"], table["thermal_conductivity_standard_error"],
             r"$\lambda(t)$ / ($k_\mathrm{B}/\sigma\tau$)")
    return integral_pair(run, table["time"], above, below,
                         caption(run, "thermal_conductivity", r"$\lambda$", r"$k_\mathrm{B}/\sigma\tau$"))


def bragg(run: FluidRun, table: Table) -> plt.Figure:
    """The Debye-Waller factors of a crystal, and those of Gaussian displacements with the same mean square."""
    figure, axes = plt.subplots(figsize=(7.0, 4.5), constrained_layout=True)
    k, factor = table["k"], table["debye_waller_factor"]
    fine = np.linspace(0.0, 1.05 * k[-1], 200)
    # exp(-k^2 <u^2>/3) of the last family, which is that of all
    mean_square = -np.log(table["debye_waller_gaussian"][-1]) / k[-1] ** 2
    axes.plot(fine, np.exp(-mean_square * fine**2), color=style.ORANGE, label=r"$\exp(-k^2 \langle u^2 \rangle/3)$")
    axes.errorbar(k, factor, yerr=table["debye_waller_factor_standard_error"], fmt="o", color=style.BLUE, capsize=2.0,
                  label=r"$\langle \cos \mathbf{k} \cdot \mathbf{u} \rangle^2$")
    for number, height, *indices in zip(k, factor, table["miller_h"], table["miller_k"], table["miller_l"]):
        axes.annotate("".join(f"{index:.0f}" for index in indices), (number, height), textcoords="offset points", xytext=(6, 5),
                      fontsize=9)
    axes.set_xlim(0.0, fine[-1])
    axes.set_ylim(0.0, 1.05)
    axes.set_xlabel(r"$k \sigma$")
    axes.set_ylabel(r"$\exp(-2W)$")
    title = caption(run, "lindemann_ratio", r"$\langle u^2 \rangle^{1/2}/d$", "")
    axes.legend(loc="upper right", title=title if "=" in title else None)
    return finish(figure, run)


# table -> its first column, the others that are drawn, how
PICTURES = {
    "sk": ("k", ("S", "S_standard_error"), structure_factor),
    "msd": ("time", ("msd", "msd_standard_error"), displacement),
    "vacf": ("time", ("vacf_normalized", "vacf", "vacf_standard_error", "diffusion", "diffusion_standard_error"),
             velocity_autocorrelation),
    "vibrational_spectrum": ("angular_frequency", ("spectrum", "spectrum_standard_error"), vibrational_spectrum),
    "stress_autocorrelation": ("time", ("stress_autocorrelation", "stress_autocorrelation_standard_error", "viscosity",
                                        "viscosity_standard_error"), stress_autocorrelation),
    "film": ("z", ("density", "density_standard_error", "normal_pressure", "normal_pressure_standard_error",
                   "tangential_pressure", "tangential_pressure_standard_error"), film),
    "bragg": ("k", ("miller_h", "miller_k", "miller_l", "debye_waller_factor", "debye_waller_factor_standard_error",
                    "debye_waller_gaussian"), bragg),
    "pressure_autocorrelation": ("time", ("pressure_autocorrelation", "pressure_autocorrelation_standard_error",
                                          "bulk_viscosity", "bulk_viscosity_standard_error"), pressure_autocorrelation),
    "heat_flux_autocorrelation": ("time", ("heat_flux_autocorrelation", "heat_flux_autocorrelation_standard_error",
                                           "thermal_conductivity", "thermal_conductivity_standard_error"),
                                  heat_flux_autocorrelation),
    **time_pictures.PICTURES,
}
ENDING = ("diffusion",)   # an integral up to the last time that is measured one by one; correlations go on to long times


def repeats(first: str, others: tuple[str, ...]) -> bool:
    """Whether the first column may have a value twice: two families of reciprocal lattice vectors can be equally long, and
    tables of time correlations have one curve below the other."""
    return "miller_h" in others or any((first, others) == PICTURES[name][:2] for name in time_pictures.REPEATING)


def read(path: Path, first: str, others: tuple[str, ...]) -> Optional[Table]:
    """A table whose first column increases, unless it repeats itself, and whose other columns have a number in every row,
    errors excepted; None when one of them has no value at all."""
    table = read_table(path, (first, *others), increasing=() if repeats(first, others) else (first,))
    drawn = [name for name in others if not name.endswith("_standard_error")]
    return table if has_values(path, table, drawn) else None


def has_values(path: Path, table: Table, names: Sequence[str]) -> bool:
    """Whether the columns `names` of a table have a number in every row. One without any is of a quantity that has no value
    in this run (g(r) of a single atom, viscosity at zero temperature): there is nothing to draw then, which is said.

    Raises DataError for a column with some numbers, but for those that may end before the others, or be missing at any wave number.
    """
    if names and set(names) <= set(time_pictures.MODES):
        if any(np.isfinite(table[name]).any() for name in names):
            return True
        print(f"{path}: it has no value in this run, no picture of it", file=sys.stderr)
        return False
    for name in names:
        gaps = np.flatnonzero(~np.isfinite(table[name]))
        if gaps.size == table[name].size:
            print(f"{path}: '{name}' has no value in this run, no picture of it", file=sys.stderr)
            return False
        if gaps.size and not (name in ENDING and gaps[0] + gaps.size == table[name].size):
            raise damaged(path, f"line {gaps[0] + 2}: column '{name}' has no number")
    return True


def of_table(run: FluidRun, path: Path, header: Sequence[str]) -> Optional[Callable[[], plt.Figure]]:
    """What draws a table that has the columns of one of PICTURES, whatever its name is; None for another table."""
    for first, others, draw in PICTURES.values():
        if {first, *others} <= set(header):
            table = read(path, first, others)
            return None if table is None else partial(draw, run, table)
    return None


def pictures(run: FluidRun) -> dict[str, Callable[[], plt.Figure]]:
    """What draws the tables that a run has, by their names."""
    figures: dict[str, Callable[[], plt.Figure]] = {}
    for name, (first, others, draw) in PICTURES.items():
        path = run.path / f"{name}.csv"
        table = read(path, first, others) if is_there(path) else None
        if table is not None:
            figures[name] = partial(draw, run, table)
    return figures
