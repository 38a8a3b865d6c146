"""Means with standard errors, as results.json has them."""

from __future__ import annotations

import math
from dataclasses import dataclass, field as member
from pathlib import Path
from typing import Any

from .._text import with_error
from .files import field


@dataclass(frozen=True)
class Quantity:
    """A mean with its standard error and its unit. NaN stands for what is not known."""

    mean: float
    error: float
    unit: str

    def __float__(self) -> float:
        return self.mean

    def __str__(self) -> str:
        return f"{with_error(self.mean, self.error)} {self.unit}".rstrip()


@dataclass(frozen=True)
class Observable(Quantity):
    """An observable of a run, in reduced units; `si` has it in SI units where the deck has a substance.

    samples: of the series
    independent_samples: its variance over the squared error
    converged: False: the series is too short for its correlations, and the error is a guess
    remark: why there is no value, or why to doubt it
    own: measured by an observable of your own
    data: all of it, as in results.json
    """

    name: str = ""
    samples: int = 0
    independent_samples: float = math.nan
    converged: bool = True
    remark: str = ""
    own: bool = False
    si: Quantity | None = None
    data: dict = member(default_factory=dict, repr=False, compare=False)

    def __repr__(self) -> str:
        return f"<{self.name} = {self}{f' = {self.si}' if self.si else ''}>"


def observable(path: Path, name: str, data: Any) -> Observable:
    """An entry of results.json, which is at `path`. Raises DataError for one that is damaged."""

    def number(record: Any, key: str) -> float:
        return float(field(path, record, key, float, default=math.nan))

    mean = number(data, "value" if isinstance(data, dict) and "mean" not in data else "mean")
    si = field(path, data, "si", dict, default=None)
    return Observable(
        mean=mean,
        error=number(data, "standard_error"),
        unit=field(path, data, "unit", str, default=""),
        name=name,
        samples=field(path, data, "samples", int, default=0),
        independent_samples=number(data, "independent_samples"),
        converged=field(path, data, "error_is_converged", bool, default=True),
        remark=field(path, data, "remark", str, default=""),
        own=field(path, data, "own", bool, default=False),
        si=None if si is None else Quantity(number(si, "mean"), number(si, "standard_error"), field(path, si, "unit", str, default="")),
        data=data,
    )


def observables(path: Path, results: dict[str, Any]) -> dict[str, Observable]:
    """The observables of results.json, by name."""
    return {name: observable(path, name, entry) for name, entry in field(path, results, "observables", dict, default={}).items()}


def findings(path: Path, results: dict[str, Any]) -> dict[str, dict[str, Observable]]:
    """Of few bodies: what each analysis found, by its name."""
    return {analysis: {name: observable(path, name, entry) for name, entry in field(path, found, analysis, dict).items()}
            for found in [field(path, results, "analysis", dict, default={})] for analysis in found}


def all_of(path: Path, results: dict[str, Any]) -> dict[str, Observable]:
    """Observables and findings by the names of the columns of sweep.csv: a finding is called "orbit_period"."""
    found = observables(path, results)
    for analysis, each in findings(path, results).items():
        found.update({f"{analysis}_{name}": value for name, value in each.items()})
    return found
