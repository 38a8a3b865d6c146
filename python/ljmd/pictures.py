"""The look of pictures. Needs no compiled part."""

from __future__ import annotations

import pathlib

STYLE = pathlib.Path(__file__).with_name("ljmd.mplstyle")


def style() -> None:
    """Give the pictures that matplotlib draws from here on the look of ljmd's own: fonts, grid, colours that all can tell apart."""
    from matplotlib import style as styles
    styles.use(STYLE)
