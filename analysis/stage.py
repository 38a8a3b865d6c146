"""A stage of a run, as results.json or the deck describes it."""

from __future__ import annotations

from dataclasses import dataclass
from typing import Optional


@dataclass(frozen=True)
class Stage:
    """One stage of the run. Its rows in thermo.csv are those with first_step <= step <= last_step."""

    name: str
    first_step: int
    last_step: int
    sampled: bool
    energy_drift: Optional[float]  # slope of the total energy per atom [epsilon/tau]
