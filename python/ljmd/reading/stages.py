"""The stages of a run: of one that has ended as results.json has them, of another as its deck asks for them."""

from __future__ import annotations

from dataclasses import dataclass
from pathlib import Path
from typing import Any, Optional

from . import decks
from .files import field
from .records import Record


@dataclass(frozen=True)
class Stage:
    """One stage of the run. Its rows in thermo.csv are those with first_step <= step <= last_step."""

    name: str
    first_step: int
    last_step: int
    sampled: bool
    energy_drift: Optional[float]  # slope of the total energy per atom [epsilon/tau]


def in_results(path: Path, results: dict[str, Any]) -> list[Stage]:
    """The stages of results.json, which is at `path`."""
    return [
        Stage(
            name=field(path, entry, "name", str),
            first_step=field(path, entry, "first_step", int),
            last_step=field(path, entry, "last_step", int),
            sampled=field(path, entry, "sampled", bool),
            energy_drift=field(path, entry, "energy_drift", float, default=None),
        )
        for entry in field(path, results, "stages", list)
    ]


def in_deck(record: Record) -> list[Stage]:
    """The stages of the deck of a run, one after the other, with the steps that they are to have."""
    found, step = [], 0
    for entry in field(record.file, decks.of_run(record), "stage", list):
        last = step + field(record.file, entry, "steps", int)
        found.append(Stage(
            name=field(record.file, entry, "name", str, default=""),
            first_step=step,
            last_step=last,
            sampled=field(record.file, entry, "sample", bool, default=False),
            energy_drift=None,
        ))
        step = last
    return found


def last_step(stages: list[Stage]) -> Optional[int]:
    return stages[-1].last_step if stages else None
