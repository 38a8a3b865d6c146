"""Figures of a benchmark: rates, ratios and roofline, from the record of report.py."""

from __future__ import annotations

import numpy as np
import ratios
import report
import roofline
import style
from matplotlib.ticker import NullLocator
from report import Record
from style import plt

MARKERS = "os^vD<>P"
LINES = ("-", ":", "-.", "--")
RATE_LABEL = "million atom-steps a second"


def draw(record: Record) -> dict[str, plt.Figure]:
    """All figures that the record has the numbers for, by name."""
    style.use()
    figures = {}
    if record["rates"]:
        figures["rates"] = draw_rates(record)
    if record["ratios"]:
        figures["ratios"] = draw_ratios(record)
    if record["peaks"] and ratios.select(record["rates"], threads=1):
        figures["roofline"] = draw_roofline(record)
    return figures


def panels(record: Record) -> tuple[plt.Figure, list[tuple[int, plt.Axes]]]:
    """A row of panels with logarithmic axes of N, one for each number of threads."""
    threads = sorted({run["threads"] for run in record["runs"]})
    figure, grid = plt.subplots(1, len(threads), sharey=True, squeeze=False, constrained_layout=True,
                                figsize=(1.5 + 4.2 * len(threads), 4.2))
    sizes = sorted({run["atoms"] for run in record["runs"]})
    for count, axes in zip(threads, grid[0]):
        axes.set_xscale("log")
        axes.set_xticks(sizes, [f"{size}" for size in sizes], rotation=30)
        axes.xaxis.set_minor_locator(NullLocator())
        axes.set_xlabel("atoms $N$")
        axes.set_title("1 thread" if count == 1 else f"{count} threads")
    return figure, list(zip(threads, grid[0]))


def draw_series(axes: plt.Axes, found: list[Record], scale: float, k: int, label: str, line: str = "-") -> None:
    """Medians with bars from minimum to maximum; series are set apart a little, so that no bar covers another."""
    if not found:
        return
    atoms = np.array([one["atoms"] for one in found]) * 1.03 ** (k - 2)
    middle, low, high = (scale * np.array([one[key] for one in found]) for key in ("median", "minimum", "maximum"))
    axes.errorbar(atoms, middle, yerr=(middle - low, high - middle), color=style.colour(k), capsize=2.5, markersize=4.5,
                  marker=MARKERS[k % len(MARKERS)], linestyle=line, linewidth=1.0, label=label)


def label_of(record: Record, name: str) -> str:
    """Name and precision, which the names of ljmd's variants already say."""
    return name if name in report.ours(record) else f"{name} ({record['programs'][name]['precision']})"


def caption(record: Record) -> str:
    work = record["workload"]
    return f"{work['name']}, lists {work['policy']}; {record['host']['cpu']}"


def draw_rates(record: Record) -> plt.Figure:
    figure, axes_of = panels(record)
    for threads, axes in axes_of:
        for k, name in enumerate([*report.ours(record), *report.peers(record)]):
            draw_series(axes, ratios.select(record["rates"], program=name, threads=threads), 1e-6, k,
                        label_of(record, name))
    axes_of[0][1].set_ylim(bottom=0.0)  # of all panels, which share it
    axes_of[0][1].set_ylabel(RATE_LABEL)
    axes_of[-1][1].legend(loc="upper left", bbox_to_anchor=(1.0, 1.0))
    figure.suptitle(style.plain(caption(record)), fontsize=10)
    return figure


def draw_ratios(record: Record) -> plt.Figure:
    """One series for each variant of ljmd and peer; colours are those of the peer's rates, lines the variant's."""
    figure, axes_of = panels(record)
    names = [*report.ours(record), *report.peers(record)]
    for threads, axes in axes_of:
        for line, own in zip(LINES, report.ours(record)):
            for peer in report.peers(record):
                found = ratios.select(record["ratios"], program=own, peer=peer, threads=threads)
                draw_series(axes, found, 1.0, names.index(peer), f"{own} / {label_of(record, peer)}", line)
        axes.axhline(1.0, color=style.GREY, linewidth=1.0, linestyle="--")
        axes.set_yscale("log")
        axes.yaxis.set_major_formatter("{x:g}")
        axes.yaxis.set_minor_formatter("{x:.1g}")
    axes_of[0][1].set_ylabel("rate of ljmd / rate of the peer")
    axes_of[-1][1].legend(loc="upper left", bbox_to_anchor=(1.0, 1.0))
    figure.suptitle(style.plain(caption(record)), fontsize=10)
    return figure


def draw_roofline(record: Record) -> plt.Figure:
    """Useful operations a second of ljmd on one thread, below the ceilings of the machine.

    Each rate stands twice: at the intensity against memory (filled) and against the level-2 cache (hollow).
    """
    peaks = record["peaks"]
    figure, axes = plt.subplots(figsize=(9.5, 4.6), constrained_layout=True)
    intensity = np.geomspace(0.1, 10.0, 200)
    for words, line in (("double", "-"), ("single", "--")):
        for source, level, colour in (("memory_read", "memory", style.BLACK), ("l2_read", "level-2 cache", style.GREY)):
            most, bandwidth = peaks[f"{words}_flops"], peaks[source]
            label = f"{words}: {most / 1e9:.0f} Gflop/s; {level}: {bandwidth / 1e9:.0f} GB/s"
            axes.plot(intensity, np.minimum(most, bandwidth * intensity) / 1e9, line, color=colour, label=label)
    for k, name in enumerate(report.ours(record)):
        bytes_moved = roofline.traffic(record["programs"][name]["precision"])
        found = ratios.select(record["rates"], program=name, threads=1)
        for j, one in enumerate(found):
            flops = one["median"] * roofline.useful_flops() / 1e9
            for level, face in (("memory", style.colour(k)), ("l2", "white")):
                first = j == 0 and level == "memory"
                axes.plot(roofline.useful_flops() / bytes_moved[level], flops, MARKERS[j % len(MARKERS)], markersize=6,
                          color=style.colour(k), markerfacecolor=face, label=name if first else None)
    for j, atoms in enumerate(sorted({one["atoms"] for one in ratios.select(record["rates"], threads=1)})):
        axes.plot([], [], MARKERS[j % len(MARKERS)], color=style.GREY, markersize=6, label=f"{atoms} atoms")
    axes.set_xscale("log")
    axes.set_yscale("log")
    axes.set_xlabel("useful operations a byte (filled: from memory; hollow: from the level-2 cache)")
    axes.set_ylabel("useful Gflop/s on one thread")
    axes.legend(loc="upper left", bbox_to_anchor=(1.0, 1.0), fontsize=8)
    axes.set_title(style.plain(f"{caption(record)}; {roofline.useful_flops():.0f} useful flop an atom and step"),
                   fontsize=9)
    return figure
