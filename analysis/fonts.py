"""Letters that the usual font of pictures lacks: other fonts that are installed, and a remark where none has them."""

from __future__ import annotations

import contextlib
import re
import sys
import unicodedata
import warnings
from typing import Iterator

from matplotlib import font_manager, rcParams

USUAL = "DejaVu Sans"  # comes with matplotlib; Latin, Greek, Cyrillic, Arabic, Hebrew
# Chinese, Japanese and Korean, then the rest, as Debian, macOS and Windows name them.
OTHERS = ("Noto Sans CJK SC", "Noto Sans CJK JP", "WenQuanYi Zen Hei", "WenQuanYi Micro Hei", "Droid Sans Fallback", "IPAGothic",
          "PingFang SC", "Hiragino Sans", "Apple SD Gothic Neo", "Microsoft YaHei", "Yu Gothic", "Malgun Gothic",
          "Noto Sans Devanagari", "Noto Sans Thai", "Arial Unicode MS", "Unifont")
CJK = ("CJK", "HIRAGANA", "KATAKANA", "HANGUL", "IDEOGRAPHIC")

told: set[str] = set()  # letters that a remark has named


def use() -> None:
    """Let matplotlib (from 3.6 on) take each letter from the first font that has it."""
    installed = {font.name for font in font_manager.fontManager.ttflist}
    found = [name for name in OTHERS if name in installed]
    if found:
        rcParams["font.family"] = [USUAL, *found]


def remark(letters: set[str]) -> str:
    """What is said about letters that no font has."""
    cjk = any(unicodedata.name(one, "").startswith(CJK) for one in letters)
    cure = "the package fonts-noto-cjk has Chinese, Japanese and Korean" if cjk else "install a font that has them"
    return f"remark: no font here has {' '.join(sorted(letters))}: boxes are drawn instead; {cure}"


@contextlib.contextmanager
def letters_that_lack() -> Iterator[None]:
    """While a picture is drawn: one remark on stderr about letters that no font has, once for each letter."""
    with warnings.catch_warnings(record=True) as caught:
        warnings.simplefilter("always")
        yield
    lacking = set()
    for warning in caught:
        glyph = re.match(r"Glyph (\d+) ", str(warning.message))
        if glyph:
            lacking.add(chr(int(glyph[1])))
        else:
            warnings.warn_explicit(warning.message, warning.category, warning.filename, warning.lineno)
    if lacking - told:
        print(remark(lacking - told), file=sys.stderr, flush=True)
        told.update(lacking)
