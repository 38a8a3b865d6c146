"""Reading files of ljmd, checked as they are read: a damaged file is one error, which names it."""

from __future__ import annotations

import csv
import functools
import json
import math
import sys
from pathlib import Path
from typing import Any, Callable, Optional, Sequence

import numpy as np

Table = dict[str, np.ndarray]


class RunDirectoryError(Exception):
    """A run directory that cannot be used: one line, and the exit code of ljmd that it stands for."""

    def __init__(self, message: str, exit_code: int):
        super().__init__(message)
        self.exit_code = exit_code


def reports_errors(main: Callable[[Optional[Sequence[str]]], int]) -> Callable[..., int]:
    """The main() of a script, which ends a RunDirectoryError as one line on stderr and its exit code."""

    @functools.wraps(main)
    def guarded(arguments: Optional[Sequence[str]] = None) -> int:
        try:
            return main(arguments)
        except RunDirectoryError as error:
            # Names of files reach a terminal without what commands it.
            text = "".join(one if one.isprintable() or "\udc80" <= one <= "\udcff" else "?" for one in str(error))
            print(f"error: {text}", file=sys.stderr)
            return error.exit_code

    return guarded


def damaged(path: Path, what: str) -> RunDirectoryError:
    """The error for a file whose content cannot be used (exit code 3)."""
    return RunDirectoryError(f"{path}: {what}", exit_code=3)


def read_text(path: Path) -> str:
    """The text of a file; a byte-order mark is dropped."""
    try:
        return path.read_text(encoding="utf-8-sig")
    except FileNotFoundError:
        raise damaged(path, "no such file") from None
    except UnicodeDecodeError:
        raise damaged(path, "not a text file") from None
    except OSError as error:
        raise damaged(path, f"cannot be read: {error.strerror}") from None


def read_table(path: Path, required: tuple[str, ...], increasing: tuple[str, ...], growing: bool = False) -> Table:
    """A CSV file with one header row as columns of numbers; empty fields become NaN.

    The columns `required` must be there; those named `increasing` must have a number in every row, each above the last.
    Of a `growing` file, which was being written, a last line without an end does not count.
    """
    text = read_text(path)
    if growing:
        text = text[: text.rfind("\n") + 1]
    try:
        rows = list(csv.reader(text.splitlines()))
    except csv.Error as error:
        raise damaged(path, str(error)) from None
    if not rows:
        raise damaged(path, "empty, without even a header row")
    header, body = rows[0], rows[1:]
    missing = [name for name in required if name not in header]
    if missing:
        raise damaged(path, f"line 1: no column '{missing[0]}' (found: {', '.join(header)})")
    if not body:
        raise damaged(path, "no rows below the header")
    values = np.empty((len(body), len(header)))
    for row, fields in enumerate(body):
        where = f"line {row + 2}"
        if len(fields) != len(header):
            raise damaged(path, f"{where}: {len(fields)} fields, the header has {len(header)}")
        for column, text in enumerate(fields):
            try:
                values[row, column] = float(text) if text else math.nan
            except ValueError:
                raise damaged(path, f"{where}: '{text}' in column '{header[column]}' is not a number") from None
    table = {name: values[:, column] for column, name in enumerate(header)}
    for name in increasing:
        steps = np.diff(table[name], prepend=-math.inf)
        disorder = np.flatnonzero(~((steps > 0.0) & np.isfinite(table[name])))
        if disorder.size:
            raise damaged(path, f"line {disorder[0] + 2}: column '{name}' has no number above the one before")
    return table


def has_values(path: Path, table: Table, names: Sequence[str]) -> bool:
    """Whether the columns `names` of a table have a number in every row. One without any is of a quantity that has no value
    in this run (g(r) of a single atom, viscosity at zero temperature): there is nothing to draw then, which is said.

    Raises RunDirectoryError (exit code 3) for a column with some numbers.
    """
    for name in names:
        gaps = np.flatnonzero(~np.isfinite(table[name]))
        if gaps.size == table[name].size:
            print(f"{path}: '{name}' has no value in this run, no picture of it", file=sys.stderr)
            return False
        if gaps.size:
            raise damaged(path, f"line {gaps[0] + 2}: column '{name}' has no number")
    return True


def read_json(path: Path) -> dict[str, Any]:
    """A JSON file that holds one object."""
    try:
        content = json.loads(read_text(path))
    except json.JSONDecodeError as error:
        raise damaged(path, f"line {error.lineno}: {error.msg}") from None
    except RecursionError:
        raise damaged(path, "nested too deeply") from None
    if not isinstance(content, dict):
        raise damaged(path, "must hold a JSON object")
    return content


def field(path: Path, record: Any, name: str, kind: Any, **fallback: Any) -> Any:
    """record[name], which must be of `kind`; `default=` makes it optional, and null counts as absent then."""
    if not isinstance(record, dict):
        raise damaged(path, f"an object with '{name}' was expected, found {json.dumps(record)[:40]}")
    value = record.get(name)
    if value is None and "default" in fallback:
        return fallback["default"]
    allowed = (int, float) if kind is float else kind
    if not isinstance(value, allowed) or (isinstance(value, bool) and kind is not bool):
        found = f"is {json.dumps(value)[:40]}" if name in record else "is missing"
        raise damaged(path, f"'{name}' {found}, must be of type {kind.__name__}")
    return value
