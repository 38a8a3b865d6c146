"""CSV of ljmd, one header row above rows of numbers. A damaged table is one error, which names line and column."""

from __future__ import annotations

import csv
import io
import math
from pathlib import Path
from typing import Sequence

import numpy as np

from .files import damaged, read_text

Table = dict[str, np.ndarray]
TextColumns = dict[str, list[str]]

# A table of these characters alone has no quotes, no words and no other line ends: NumPy reads it as float() does, and faster.
PLAIN = str.maketrans("", "", "0123456789+-.eE,\n")


def read_numbers(path: Path, growing: bool = False) -> tuple[list[str], np.ndarray]:
    """The names of the columns, and the rows below them, shape (rows, columns); empty fields are NaN.

    Of a `growing` file, which was being written, a last line without an end does not count.
    """
    text = read_text(path)
    if growing:
        text = text[: text.rfind("\n") + 1]
    head, _, body = text.partition("\n")
    if len(head.splitlines()) == 1 and '"' not in head and not body.translate(PLAIN) and "\n\n" not in f"\n{body}":
        header = head.split(",")
        numbers = plain_numbers(body, len(header))
        if numbers is not None and len(set(header)) == len(header):
            return header, numbers
    header, rows = rows_of(path, text)
    return header, checked_numbers(path, header, rows)


def plain_numbers(body: str, columns: int) -> np.ndarray | None:
    """The numbers of PLAIN text; None where these are not so many columns of numbers."""
    if not body:
        return np.empty((0, columns))
    while ",," in body:
        body = body.replace(",,", ",nan,")
    body = body.replace(",\n", ",nan\n").replace("\n,", "\nnan,")
    body = "nan" * body.startswith(",") + body + "nan" * body.endswith(",")
    try:
        numbers = np.loadtxt(io.StringIO(body), delimiter=",", ndmin=2, comments=None)
    except ValueError:
        return None
    return numbers if numbers.shape[1] == columns else None


def rows_of(path: Path, text: str, growing: bool = False) -> tuple[list[str], list[list[str]]]:
    """The header, and the fields of each row below it; of a `growing` file without a last row that lacks some."""
    try:
        rows = list(csv.reader(text.splitlines()))
    except csv.Error as error:
        raise damaged(path, str(error)) from None
    if not rows:
        raise damaged(path, "empty, without even a header row")
    header, body = rows[0], rows[1:]
    twice = next((name for k, name in enumerate(header) if name in header[:k]), None)
    if twice is not None:
        raise damaged(path, f"line 1: column '{twice}' is there twice")
    if growing and body and len(body[-1]) != len(header):
        body.pop()
    for number, fields in enumerate(body, 2):
        if len(fields) != len(header):
            raise damaged(path, f"line {number}: {len(fields)} fields, the header has {len(header)}")
    return header, body


def checked_numbers(path: Path, header: Sequence[str], rows: list[list[str]]) -> np.ndarray:
    """The fields as numbers, shape (rows, columns)."""
    values = np.empty((len(rows), len(header)))
    for row, fields in enumerate(rows):
        for column, text in enumerate(fields):
            try:
                values[row, column] = float(text) if text else math.nan
            except ValueError:
                raise damaged(path, f"line {row + 2}: '{text}' in column '{header[column]}' is not a number") from None
    return values


def read_table(path: Path, required: tuple[str, ...] = (), increasing: tuple[str, ...] = (), growing: bool = False) -> Table:
    """The columns of a table of numbers by name; empty fields are NaN. There must be a row.

    The columns `required` must be there; those named `increasing` must have a number in every row, each above the last.
    `growing` as in read_numbers().
    """
    header, values = read_numbers(path, growing)
    missing = [name for name in required if name not in header]
    if missing:
        raise damaged(path, f"line 1: no column '{missing[0]}' (found: {', '.join(header)})")
    if not len(values):
        raise damaged(path, "no rows below the header")
    table = {name: values[:, column] for column, name in enumerate(header)}
    for name in increasing:
        steps = np.diff(table[name], prepend=-math.inf)
        disorder = np.flatnonzero(~((steps > 0.0) & np.isfinite(table[name])))
        if disorder.size:
            raise damaged(path, f"line {disorder[0] + 2}: column '{name}' has no number above the one before")
    return table


def read_mixed(path: Path) -> tuple[Table, TextColumns]:
    """Columns of numbers, NaN where a field is empty, and columns of texts. A last row that is cut off does not count."""
    header, rows = rows_of(path, read_text(path), growing=True)
    if not rows:
        raise damaged(path, "no rows below the header")
    numbers, texts = {}, {}
    for k, name in enumerate(header):
        column = [row[k] for row in rows]
        try:
            numbers[name] = np.array([float(each) if each else math.nan for each in column])
        except ValueError:
            texts[name] = column
    return numbers, texts


def header_of(path: Path) -> list[str]:
    """The names of a table's columns."""
    return next(csv.reader(read_text(path).splitlines()[:1]), [])
