"""The picture of any table of ljmd: its columns against one of them, each with its band of one standard error."""

from __future__ import annotations

import math
from pathlib import Path

import numpy as np
import style
from ljmd.reading.files import damaged
from ljmd.reading.tables import read_mixed
from style import plt

ERROR = "_standard_error"
ALONG = ("time", "r", "k", "angular_frequency", "time_step", "rho", "step")  # what a table goes along, if it is there
MOST_PANELS = 12
STEEP = 1e3  # what is above 0 and spans more is drawn on a logarithmic scale


def series(texts: dict[str, list[str]], rows: int) -> dict[str, np.ndarray]:
    """The rows that belong together: those with the same texts, by these; all of them where there are no texts."""
    if not texts:
        return {"": np.arange(rows)}
    found: dict[str, list[int]] = {}
    for row, words in enumerate(zip(*texts.values())):
        found.setdefault(", ".join(words), []).append(row)
    return {words: np.array(kept) for words, kept in found.items()}


def is_steep(values: np.ndarray) -> bool:
    positive = values[np.isfinite(values)]
    return positive.size > 2 and positive.min() > 0.0 and positive.max() > STEEP * positive.min()


def plot_table(path: Path, title: str) -> plt.Figure:
    """A panel for each column, against time, distance or what else the table goes along."""
    table, texts = read_mixed(path)
    if len(table) < 2:
        raise damaged(path, "has fewer than two columns of numbers, there is nothing to draw")
    along = next((name for name in ALONG if name in table), next(iter(table)))
    drawn = [name for name in table if name not in (along, "step") and not name.endswith(ERROR)
             and np.isfinite(table[name]).any()]
    shown = drawn[:MOST_PANELS]
    if not shown:
        raise damaged(path, f"no numbers beside '{along}', there is nothing to draw")
    groups = series(texts, table[along].size)
    columns = 1 if len(shown) <= 3 else 2
    rows = math.ceil(len(shown) / columns)
    figure, grid = plt.subplots(rows, columns, sharex=True, squeeze=False, constrained_layout=True,
                                figsize=(7.0 if columns == 1 else 9.5, 1.2 + 2.1 * rows))
    for axes in grid.flat[len(shown):]:
        axes.set_visible(False)
    for axes, name in zip(grid.flat, shown):
        for k, (words, kept) in enumerate(groups.items()):
            kept = kept[np.argsort(table[along][kept], kind="stable")]
            x, y = table[along][kept], table[name][kept]
            error = np.nan_to_num(table.get(name + ERROR, np.zeros(table[name].size))[kept])
            axes.fill_between(x, y - error, y + error, color=style.colour(k), alpha=0.3, linewidth=0)
            axes.plot(x, y, color=style.colour(k), marker="." if len(kept) < 60 else "", label=style.plain(words))
        axes.set_ylabel(style.LABELS.get(name, style.plain(name.replace("_", " "))))
        axes.set_yscale("log" if is_steep(table[name]) else "linear")
        axes.set_xscale("log" if is_steep(table[along]) else "linear")
    for axes in grid.flat[max(0, len(shown) - columns):len(shown)]:
        axes.tick_params(labelbottom=True)
        axes.set_xlabel(style.LABELS.get(along, style.plain(along.replace("_", " "))))
    if len(groups) > 1:
        style.legend_beside(grid[0, -1])
    left_out = f"{len(shown)} of {len(drawn)} columns" if len(shown) < len(drawn) else ""
    style.head(figure, title, left_out)
    return figure
