"""What a run that was stopped or has failed says of itself: its stages and its system, by the deck in run.json.

Only a run that has come to its end writes results.json.
"""

from __future__ import annotations

from dataclasses import dataclass
from pathlib import Path
from typing import Any

import deck
from checked_files import damaged, field
from stage import Stage


@dataclass(frozen=True)
class System:
    """The system of a few-body run."""

    force: str
    bodies: int
    dimensions: int


def stages(directory: Path) -> list[Stage]:
    """The stages of the deck, one after the other, with the steps that they are to have."""
    record = directory / "run.json"
    found, step = [], 0
    for entry in field(record, deck.of_run(directory), "stage", list):
        last = step + field(record, entry, "steps", int)
        found.append(Stage(
            name=field(record, entry, "name", str, default=""),
            first_step=step,
            last_step=last,
            sampled=field(record, entry, "sample", bool, default=False),
            energy_drift=None,
        ))
        step = last
    return found


def system(directory: Path) -> System:
    """Force, bodies and coordinates of each body of a few-body deck."""
    record = directory / "run.json"
    tables: dict[str, Any] = deck.of_run(directory)
    bodies = field(record, tables, "body", list)
    if not bodies:
        raise damaged(record, "the deck has no bodies")
    return System(
        force=field(record, field(record, tables, "force", dict), "type", str),
        bodies=len(bodies),
        dimensions=len(field(record, bodies[0], "position", list)),
    )
