"""Tests that judge by statistics run ljmd in an environment in which it computes the same bits on every processor (same_bits.env).

A trajectory of a fluid amplifies the last bit to another trajectory, so that every kind of processor would throw the dice anew. See
docs/architecture.md, "Tests that judge by statistics".
"""

import os
import pathlib

VARIABLES = dict(line.split("=", 1)
                 for line in (pathlib.Path(__file__).resolve().parent / "same_bits.env").read_text(encoding="utf-8").splitlines()
                 if not line.startswith("#"))


def compute_same_bits_everywhere() -> None:
    """All that this process starts from now on computes the same bits on every processor."""
    os.environ.update(VARIABLES)
