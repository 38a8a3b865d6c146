#!/usr/bin/env python3
"""Tests of analysis/plain_text.py. Prints "N passed, M failed"."""

from __future__ import annotations

import sys
from pathlib import Path

import fixtures  # noqa: I001  (it says where the modules of analysis/ are)
import plain_text
import style

HOSTILE = "\"quotes\" & 'apostrophes' <b>bold</b> $x^2$ \\frac{1}{2} \u05e9\u05dc\u05d5\u05dd\nnew line\t\x00\u202e \u65e5\u672c " + "long " * 40


def test_what_has_a_meaning_for_matplotlib_has_none(_: Path) -> None:
    assert plain_text.plain("50 $ and 60 $") == r"50 \$ and 60 \$"
    assert plain_text.plain("a\n b\tc\x00d\u202ee") == "a b c de"
    assert plain_text.plain("<b>&amp;</b> \"'") == "<b>&amp;</b> \"'"


def test_long_titles_are_cut(_: Path) -> None:
    found = plain_text.lines("word " * 100, 40).split("\n")
    assert len(found) == 2 and all(len(line) <= 40 for line in found) and found[1].endswith(" ..."), found
    assert plain_text.lines("x" * 100, 30).count("\n") == 1  # one word, which is broken
    assert plain_text.lines("", 30) == ""


def test_text_from_right_to_left_is_read_as_such(_: Path) -> None:
    """The examples of UAX #9 with Hebrew for its capitals: what is logical, and what is seen."""
    alef, bet, gimel = "\u05d0\u05d1\u05d2"
    assert plain_text.visual_order("abc") == "abc"
    assert plain_text.visual_order(alef + bet + gimel) == gimel + bet + alef
    assert plain_text.visual_order(f"ab {alef}{bet} cd") == f"ab {bet}{alef} cd"
    assert plain_text.visual_order(f"a {alef} {bet} c") == f"a {bet} {alef} c"
    assert plain_text.visual_order(f"{alef}{bet} 12 {gimel}") == f"{gimel} 12 {bet}{alef}"  # numbers keep their order
    assert plain_text.visual_order(f"{alef} ab {bet}") == f"{bet} ab {alef}"
    assert plain_text.visual_order(f"{alef}({bet})") == f"({bet}){alef}"
    assert plain_text.visual_order(f"T = 5 {alef}") == f"T = 5 {alef}"
    assert plain_text.visual_order("12 () ...") == "12 () ..."


def test_a_hostile_title_is_drawn_as_text(tmp: Path) -> None:
    style.use()
    for ending in style.FORMATS:
        figure, axes = style.plt.subplots()
        style.head(figure, HOSTILE, "a note")
        axes.set_xlabel(style.plain(HOSTILE))
        style.save(figure, tmp / f"x{ending}")
        assert (tmp / f"x{ending}").stat().st_size > 1000
        assert "$" in figure._suptitle.get_text() and "\x00" not in figure._suptitle.get_text()
        assert [path.name for path in tmp.glob(".half*")] == []


if __name__ == "__main__":
    sys.exit(fixtures.run_tests(globals()))
