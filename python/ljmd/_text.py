"""Numbers with errors, tables of numbers, and HTML for notebooks."""

from __future__ import annotations

import html
import math

import numpy as np

from ._check import shown


def with_error(mean: float, error: float) -> str:
    """'-6.0871 ± 0.0012': the error with two digits, the mean with as many decimals."""
    if not math.isfinite(mean):
        return "no value"
    if not math.isfinite(error) or error <= 0:
        return f"{mean:.6g}"
    decimals = 1 - math.floor(math.log10(error))
    if decimals > 12 or decimals < -12:
        return f"{mean:.6g} ± {error:.1e}"
    return f"{mean:.{max(decimals, 0)}f} ± {error:.{max(decimals, 0)}f}"


def as_table(columns, numbers: np.ndarray):
    """A pandas DataFrame; without pandas a NumPy structured array. Both give a column by its name."""
    kinds = [np.int64 if name == "step" else np.float64 for name in columns]
    try:
        import pandas  # type: ignore
    except ImportError:
        table = np.empty(len(numbers), dtype=list(zip(columns, kinds)))
        for k, name in enumerate(columns):
            table[name] = numbers[:, k]
        return table
    return pandas.DataFrame({name: numbers[:, k].astype(kind) for k, (name, kind) in enumerate(zip(columns, kinds))})


class NamedTables:
    """What has tables of numbers by name: `_tables` holds columns and rows of each."""

    _tables: dict

    @property
    def tables(self) -> list:
        """Names of the tables."""
        return list(self._tables)

    def table(self, name: str):
        """The table of that name, see `tables`. Raises KeyError naming all."""
        if not isinstance(name, str) or name not in self._tables:
            raise KeyError(f"no table {shown(name)}; there are {', '.join(self._tables) or 'none'}")
        return as_table(*self._tables[name])


def mixed_table(columns: dict):
    """The same from columns by name, which may hold text and truth values."""
    try:
        import pandas  # type: ignore
    except ImportError:
        arrays = {name: np.array(values) for name, values in columns.items()}
        table = np.empty(len(next(iter(arrays.values()))), dtype=[(name, array.dtype) for name, array in arrays.items()])
        for name, array in arrays.items():
            table[name] = array
        return table
    return pandas.DataFrame(columns)


def html_table(header, rows, caption: str = "") -> str:
    """Cells are escaped; the first column is on the left, the others on the right."""

    def row(tag, cells):
        return "<tr>" + "".join(f'<{tag} style="text-align:{"left" if k == 0 else "right"}">{html.escape(str(cell))}</{tag}>'
                                for k, cell in enumerate(cells)) + "</tr>"

    title = f"<caption>{html.escape(caption)}</caption>" if caption else ""
    return f"<table>{title}{row('th', header) if header else ''}{''.join(row('td', cells) for cells in rows)}</table>"


def html_lines(lines) -> str:
    return "".join(f"<div>{html.escape(str(line))}</div>" for line in lines)


def html_pre(text: str) -> str:
    return f"<pre>{html.escape(text)}</pre>"
