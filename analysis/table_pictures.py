"""The picture of any table of ljmd: its columns against one of them, each with its band of one standard error."""

from __future__ import annotations

import csv
import math
from pathlib import Path

import numpy as np
import style
from checked_files import Table, damaged, read_text
from style import plt

ERROR = "_standard_error"
ALONG = ("time", "r", "k", "angular_frequency", "time_step", "rho", "step")  # what a table goes along, if it is there
MOST_PANELS = 12
STEEP = 1e3  # what is above 0 and spans more is drawn on a logarithmic scale


def read(path: Path) -> tuple[Table, dict[str, list[str]]]:
    """Columns of numbers, NaN where a field is empty, and columns of texts."""
    try:
        rows = list(csv.reader(read_text(path).splitlines()))
    except csv.Error as error:
        raise damaged(path, str(error)) from None
    if len(rows) < 2:
        raise damaged(path, "no rows below the header")
    header, body = rows[0], rows[1:]
    if body and len(body[-1]) != len(header):  # being written
        body = body[:-1]
    for number, row in enumerate(body, 2):
        if len(row) != len(header):
            raise damaged(path, f"line {number}: {len(row)} fields, the header has {len(header)}")
    numbers, texts = {}, {}
    for k, name in enumerate(header):
        column = [row[k] for row in body]
        try:
            numbers[name] = np.array([float(text) if text else math.nan for text in column])
        except ValueError:
            texts[name] = column
    if len(numbers) < 2:
        raise damaged(path, "has fewer than two columns of numbers, there is nothing to draw")
    return numbers, texts


def header(path: Path) -> list[str]:
    """The names of a table's columns."""
    return next(csv.reader(read_text(path).splitlines()[:1]), [])


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
    table, texts = read(path)
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
