"""What `ljmd reproduce` has left: the rows of a published table, computed anew, beside two equations of state."""

from __future__ import annotations

import math
from dataclasses import dataclass
from pathlib import Path
from typing import Any

from .files import damaged, field, is_there, read_json
from .tables import Table, read_table

ISOTHERM_COLUMNS = ("T", "rho", "Z_thol2016", "Z_kolafa_nezbeda1994")


@dataclass(frozen=True)
class Row:
    """Compressibility factors at one density and temperature; NaN where Verlet has none."""

    rho: float
    temperature: float
    found: float
    error: float
    beyond_cutoff: float
    verlet: float
    sound: bool
    thol: float
    kolafa: float


def read_row(path: Path, entry: Any) -> Row:
    if not isinstance(entry, dict):
        raise damaged(path, "a row is not an object")

    def number(name: str) -> float:
        return float(field(path, entry, name, float))

    verlet = field(path, entry, "Z_verlet", dict, default={}) or {}
    return Row(
        rho=number("rho"), temperature=number("T"), found=number("Z"), error=number("Z_standard_error"),
        beyond_cutoff=number("Z_beyond_cutoff"), verlet=float(field(path, verlet, "value", float, default=math.nan)),
        sound=field(path, verlet, "soundness", str, default="") == "sound", thol=number("Z_thol2016"), kolafa=number("Z_kolafa_nezbeda1994"),
    )


def load(directory: Path) -> tuple[list[Row], Table]:
    """The rows of the table, and the isotherms."""
    path = directory / "results.json"
    if not is_there(path):
        raise damaged(directory, "the table has not come to its end: `ljmd reproduce` resumes it")
    rows = [read_row(path, entry) for entry in field(path, read_json(path), "rows", list)]
    if not rows:
        raise damaged(path, "no rows")
    return rows, read_table(directory / "isotherms.csv", ISOTHERM_COLUMNS, increasing=())
