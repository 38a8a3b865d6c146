#!/usr/bin/env python3
"""Tests of ljmd.reading.tables on files made here. Prints "N passed, M failed"."""

from __future__ import annotations

import sys
from pathlib import Path
from unittest import mock

import fixtures  # noqa: I001  (it finds the package ljmd)
import numpy as np
from fixtures import refused
from ljmd.reading import tables

# With NumPy's reader and, quoted, without.
PLAIN = "step,t,x\n0,0.1,-1e-3\n1,,+2.5E10\n,,\n3,4,\n"
QUOTED = PLAIN.replace("0.1", '"0.1"')
EXPECTED = [[0, 0.1, -1e-3], [1, np.nan, 2.5e10], [np.nan] * 3, [3, 4, np.nan]]


def test_both_ways_give_the_same(tmp: Path) -> None:
    for text in (PLAIN, QUOTED, PLAIN[:-1], PLAIN.replace("\n", "\r\n"), "\ufeff" + PLAIN):
        (tmp / "a.csv").write_text(text, encoding="utf-8", newline="")
        header, numbers = tables.read_numbers(tmp / "a.csv")
        assert header == ["step", "t", "x"] and np.array_equal(numbers, EXPECTED, equal_nan=True), (text, numbers)
    header, numbers = tables.read_numbers(tmp / "a.csv")
    (tmp / "b.csv").write_text("step,t,x\n")
    assert tables.read_numbers(tmp / "b.csv")[1].shape == (0, 3)
    refused(lambda: tables.read_table(tmp / "b.csv"), "b.csv: no rows below the header")


def test_numbers_keep_every_bit(tmp: Path) -> None:
    values = np.random.default_rng(1).normal(size=(500, 3)) * 10.0 ** np.arange(-300, 300, 200)
    (tmp / "a.csv").write_text("a,b,c\n" + "".join(",".join(map(repr, row)) + "\n" for row in values.tolist()))
    assert np.array_equal(tables.read_numbers(tmp / "a.csv")[1], values)
    with mock.patch.object(tables, "checked_numbers", side_effect=AssertionError("the slow way")):
        tables.read_numbers(tmp / "a.csv")


def test_a_last_line_that_is_half_written(tmp: Path) -> None:
    for end in ("5,0.", "5", "5,1,2"):
        for text in (PLAIN, QUOTED):
            (tmp / "a.csv").write_text(text + end)
            assert len(tables.read_numbers(tmp / "a.csv", growing=True)[1]) == 4
    (tmp / "a.csv").write_text(PLAIN + "5,0.")
    refused(lambda: tables.read_numbers(tmp / "a.csv"), "a.csv: line 6: 2 fields, the header has 3")
    (tmp / "a.csv").write_text("step,")
    refused(lambda: tables.read_numbers(tmp / "a.csv", growing=True), "empty, without even a header row")
    (tmp / "a.csv").write_text("name,x,y\none,1,2\ntwo,3")
    numbers, texts = tables.read_mixed(tmp / "a.csv")
    assert texts == {"name": ["one"]} and list(numbers) == ["x", "y"] and numbers["y"] == [2.0]


def test_damage_is_told_with_its_place(tmp: Path) -> None:
    cases = {
        PLAIN.replace("0.1", "0.1.2"): "line 2: '0.1.2' in column 't' is not a number",
        PLAIN.replace("3,4,", "3,4"): "line 5: 2 fields, the header has 3",
        PLAIN.replace("3,4,", "3,4,,"): "line 5: 4 fields, the header has 3",
        PLAIN.replace("1,,", "\n1,,"): "line 3: 0 fields",
        PLAIN.replace("x\n", "x\n\n"): "line 2: 0 fields",
        PLAIN.replace("0.1", "#"): "line 2: '#' in column 't'",
        PLAIN.replace("step", "steps"): "line 1: no column 'step' (found: steps, t, x)",
        "step,t\n0,1\n1,1\n": "line 3: column 't' has no number above the one before",
        "step,t\n0,1\n1,\n": "line 3: column 't' has no number above the one before",
        "": "empty, without even a header row",
        "\n": "no column 'step'",
    }
    for text, message in cases.items():
        (tmp / "a.csv").write_text(text)
        refused(lambda: tables.read_table(tmp / "a.csv", required=("step",), increasing=("t",)), "a.csv: ", message)
    refused(lambda: tables.read_table(tmp / "none.csv"), "none.csv: no such file")


if __name__ == "__main__":
    sys.exit(fixtures.run_tests(globals()))
