"""The picture of a reproduced table: compressibility factor against density.

Above, Z along isotherms by two equations of state (Thol 2016, Kolafa and Nezbeda 1994), with the rows of the table as
this program and as Verlet found them; colour is temperature. Below, what program, paper and second equation of state
differ by from Thol's at each row.
"""

from __future__ import annotations

from functools import partial
from pathlib import Path
from typing import Callable

import numpy as np
import style
from ljmd.reading import reproductions
from ljmd.reading.reproductions import Row
from ljmd.reading.tables import Table
from matplotlib.colors import LogNorm
from style import plt

COLOURS = "viridis_r"


def plot(rows: list[Row], isotherms: Table) -> plt.Figure:
    temperatures = np.unique(isotherms["T"])
    norm = LogNorm(min(temperatures.min(), min(row.temperature for row in rows)),
                   max(temperatures.max(), max(row.temperature for row in rows)))
    colour = plt.get_cmap(COLOURS)
    figure, (above, below) = plt.subplots(2, 1, sharex=True, figsize=(7.5, 8.0), constrained_layout=True,
                                          gridspec_kw={"height_ratios": [2.2, 1.0]})
    for temperature in temperatures:
        on = isotherms["T"] == temperature
        for name, line in (("Z_thol2016", "-"), ("Z_kolafa_nezbeda1994", "--")):
            above.plot(isotherms["rho"][on], isotherms[name][on], line, color=colour(norm(temperature)), linewidth=0.9)
    rho = np.array([row.rho for row in rows])
    shade = colour(norm([row.temperature for row in rows]))
    above.scatter(rho, [row.found for row in rows], c=shade, s=26, zorder=3, edgecolors=style.BLACK, linewidths=0.4)
    above.scatter(rho, [row.verlet for row in rows], marker="s", s=44, facecolors="none", edgecolors=style.VERMILION,
                  linewidths=0.9, zorder=4)
    above.axhline(0.0, color=style.GREY, linewidth=0.8)
    found = [row.found for row in rows]
    above.set_ylim(min(found) - 0.5, max(found) + 1.0)
    above.set_ylabel(style.LABELS["compressibility_factor"])
    handles = [plt.Line2D([], [], marker="o", linestyle="", color=style.GREY, markeredgecolor=style.BLACK, label="ljmd"),
               plt.Line2D([], [], marker="s", linestyle="", markerfacecolor="none", color=style.VERMILION,
                          label="Verlet 1967"),
               plt.Line2D([], [], color=style.GREY, label="Thol 2016"),
               plt.Line2D([], [], color=style.GREY, linestyle="--", label="Kolafa, Nezbeda 1994")]
    above.legend(handles=handles, loc="upper left")
    scale = figure.colorbar(plt.cm.ScalarMappable(norm, COLOURS), ax=above, label=style.LABELS["temperature"],
                            ticks=temperatures, format="%g")
    scale.ax.minorticks_off()
    draw_differences(below, rows, rho)
    style.head(figure, "Verlet, Phys. Rev. 159, 98 (1967), computed anew")
    return figure


def draw_differences(axes: plt.Axes, rows: list[Row], rho: np.ndarray) -> None:
    """What each source differs by from Thol's equation; the rows of one density stand side by side."""
    place = rho.copy()
    for density in np.unique(rho):
        here = np.flatnonzero(rho == density)
        place[here] += 0.0016 * (np.arange(here.size) - 0.5 * (here.size - 1))
    thol = np.array([row.thol for row in rows])
    axes.axhline(0.0, color=style.GREY, linewidth=0.8)
    axes.errorbar(place, [row.found + row.beyond_cutoff for row in rows] - thol, yerr=[row.error for row in rows], fmt="o",
                  markersize=3.5, color=style.BLUE, elinewidth=0.8, label="ljmd, with what its cutoff misses")
    for sound, marker, label in ((True, "s", "Verlet"), (False, "x", "Verlet, suspect or metastable")):
        chosen = [row.sound is sound for row in rows]
        axes.plot(place[chosen], (np.array([row.verlet for row in rows]) - thol)[chosen], marker, linestyle="", markersize=4.5,
                  markerfacecolor="none", color=style.VERMILION, label=label)
    axes.plot(place, np.array([row.kolafa for row in rows]) - thol, "_", markersize=6, color=style.BLACK,
              label="Kolafa, Nezbeda")
    axes.set_xlabel(r"$\rho \sigma^3$")
    axes.set_ylabel(r"$Z - Z_\mathrm{Thol}$")
    axes.legend(ncol=2, fontsize=8)


def pictures(directory: Path) -> dict[str, Callable[[], plt.Figure]]:
    """What draws the picture, by its name."""
    return {"isotherms": partial(plot, *reproductions.load(directory))}
