#!/usr/bin/env python3
"""Tests of analysis/fonts.py. Prints "N passed, M failed"."""

from __future__ import annotations

import contextlib
import io
import sys
import warnings
from pathlib import Path

import fixtures  # noqa: I001  (it says where the modules of analysis/ are)
import fonts
import numpy as np
import style
from matplotlib import font_manager
from matplotlib.ft2font import FT2Font

NOWHERE = "\ue4c3"  # for private use: DejaVu has no such letter
CHINESE = "\u7194\u5316"


def said(title: str, path: Path) -> str:
    """What is said on stderr while a picture with this title is saved."""
    style.use()
    figure, _ = style.plt.subplots()
    style.head(figure, title)
    with contextlib.redirect_stderr(io.StringIO()) as said:
        style.save(figure, path)
    return said.getvalue()


@contextlib.contextmanager
def among_others(*names: str):
    """These fonts are those that letters are taken from."""
    before, fonts.OTHERS = fonts.OTHERS, names
    fonts.told.clear()
    try:
        with style.plt.rc_context():
            yield
    finally:
        fonts.OTHERS = before


def test_a_letter_is_taken_from_another_font(tmp: Path) -> None:
    """One that matplotlib brings along and that has a letter more."""
    usual = set(FT2Font(font_manager.findfont(fonts.USUAL)).get_charmap())
    more = set(FT2Font(font_manager.findfont("STIXGeneral")).get_charmap()) - usual
    letter = next(chr(code) for code in sorted(more) if chr(code).isalpha())
    with among_others("no such font"):
        assert f"no font here has {letter}: boxes" in said(letter, tmp / "box.png")
    for ending in ("png", "svg", "pdf"):
        with among_others("no such font", "STIXGeneral"):
            assert said(f"T {letter}", tmp / f"letter.{ending}") == "", ending
    with among_others("no such font", "STIXGeneral"):
        assert said(letter, tmp / "letter.png") == ""
    box, drawn = (style.plt.imread(tmp / name) for name in ("box.png", "letter.png"))
    assert not np.array_equal(box, drawn)


def test_latin_letters_stay_those_of_the_usual_font(tmp: Path) -> None:
    for name, others in (("with", ("STIXGeneral",)), ("without", ())):
        with among_others(*others):
            said("Argon \u03b5 \u0416", tmp / f"{name}.png")
    assert (tmp / "with.png").read_bytes() == (tmp / "without.png").read_bytes()


def test_what_no_font_has_is_told_once(tmp: Path) -> None:
    with among_others():
        assert said(CHINESE + CHINESE, tmp / "one.png") == fonts.remark(set(CHINESE)) + "\n"
        assert said(CHINESE, tmp / "two.png") == ""
        assert said(NOWHERE, tmp / "three.png") == ""  # has no shape, and is left out of titles
    assert "fonts-noto-cjk" in fonts.remark({"\u65e5"}) and "fonts-noto-cjk" not in fonts.remark({"\u0e01"})


def test_other_warnings_are_not_swallowed(_: Path) -> None:
    with warnings.catch_warnings(record=True) as caught:
        warnings.simplefilter("always")
        with fonts.letters_that_lack():
            warnings.warn("a warning of matplotlib")
    assert [str(one.message) for one in caught] == ["a warning of matplotlib"]


if __name__ == "__main__":
    sys.exit(fixtures.run_tests(globals()))
