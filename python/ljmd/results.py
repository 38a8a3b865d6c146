"""Results: observables with errors, and tables."""

from __future__ import annotations

import difflib
import pathlib
from collections.abc import Iterator, Mapping
from typing import Any

from . import _check
from ._text import as_table, html_lines, html_table, with_error
from .reading import observables as entries
from .reading.files import field
from .reading.observables import Observable


def _is_component(name: str, data: dict) -> bool:
    """Whether only `data` has it, and no table: components of the pressure, the virial."""
    return name.startswith(("pressure_", "virial")) and not data.get("own")


class Results(Mapping[str, Observable]):
    """Observables by name, `results["pressure"].mean`, and tables, `results.table("rdf")`."""

    def __init__(self, data: dict, tables: Mapping, main: str = ""):
        self._data, self._tables, self._main = data, tables, main

    @property
    def _file(self) -> pathlib.Path:
        """What holds the numbers, for messages."""
        return pathlib.Path("results")

    @property
    def data(self) -> dict[str, Any]:
        """Everything but the tables, as in results.json."""
        return self._data

    @property
    def warnings(self) -> list[str]:
        """Remarks on the results."""
        return field(self._file, self.data, "warnings", list, default=[])

    @property
    def _observables(self) -> dict:
        return field(self._file, self.data, "observables", dict, default={})

    def __getitem__(self, name: str) -> Observable:
        observables = self._observables
        if not isinstance(name, str) or name not in observables:
            near = difflib.get_close_matches(name, observables, 1) if isinstance(name, str) else []
            raise KeyError(f"no observable {_check.shown(name)}; " + (f"did you mean {near[0]!r}?" if near else
                                                          f"there are {', '.join(observables) or 'none'}"))
        return entries.observable(self._file, name, observables[name])

    def __iter__(self) -> Iterator[str]:
        return iter(self._observables)

    def __len__(self) -> int:
        return len(self._observables)

    @property
    def tables(self) -> list[str]:
        """Names of the tables."""
        return list(self._tables)

    def table(self, name: str | None = None) -> Any:
        """A table as a pandas DataFrame, or as a NumPy structured array where there is no pandas.

        Without a name: that of the one analysis that was asked for. Raises KeyError naming all.
        """
        name = self._main if name is None else name
        if not isinstance(name, str) or name not in self._tables:
            raise KeyError(f"no table {_check.shown(name)}; there are {', '.join(self._tables) or 'none'}")
        return as_table(*self._tables[name])

    def _heading(self) -> str:
        return self._title or type(self).__name__

    @property
    def _title(self) -> str:
        return field(self._file, self.data, "title", str, default="")

    def _rows(self) -> list:
        rows = []
        for name, each in self.items():
            if not _is_component(name, each.data):
                mark = "" if each.converged and not each.remark else " *"
                rows.append((name, with_error(each.mean, each.error) + mark, each.unit, str(each.si or "")))
        return rows

    def _remarks(self) -> list:
        return [f"* {name}: {each.remark}" for name, each in self.items() if each.remark and not _is_component(name, each.data)] + \
               [f"warning: {warning}" for warning in self.warnings]

    def __repr__(self) -> str:
        rows = self._rows()
        widths = [max((len(row[k]) for row in rows), default=0) for k in range(4)]
        lines = ["  " + "  ".join(cell.ljust(width) for cell, width in zip(row, widths)).rstrip() for row in rows]
        tables = [f"  tables: {', '.join(self._tables)}"] if self._tables else []
        return "\n".join([self._heading(), *lines, *tables, *(f"  {remark}" for remark in self._remarks())])

    def _repr_html_(self) -> str:
        rows = self._rows()
        header = ("", "mean ± standard error", "unit", "SI" if any(row[3] for row in rows) else "")
        tables = [f"tables: {', '.join(self._tables)}"] if self._tables else []
        return html_table(header, rows, self._heading()) + html_lines(tables + self._remarks())
