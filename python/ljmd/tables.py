"""Tables of decks: dicts whose keys are attributes. Type checkers know the keys of each, and no others, from _keys.pyi."""

from __future__ import annotations

import copy
from collections.abc import Mapping
from typing import TYPE_CHECKING, Any

from . import _check, _core
from .errors import InputError


class Table(dict):
    """A table of a deck: a dict whose keys are attributes, too. `del` or None leaves a key to its default."""

    def __getattr__(self, name) -> Any:
        try:
            return self[name]
        except KeyError:
            raise AttributeError(f"no key {name!r} is set here; set are: {', '.join(map(str, self)) or 'none'}") from None

    def __setattr__(self, name, value):
        self[name] = value

    def __delattr__(self, name):
        self.pop(name, None)

    def __dir__(self):
        return [*super().__dir__(), *self]


if TYPE_CHECKING:
    from ._keys import Analyses as _AnalysesKeys
    from ._keys import Attribute, PotentialTable
    from ._keys import Stage as _StageKeys
else:
    _AnalysesKeys = _StageKeys = Table
    Attribute, PotentialTable = property, dict


class Stage(_StageKeys):
    """Steps of one integrator, with at most one thermostat and one barostat: a [[stage]] of a deck.

    name: for results and messages
    steps: their number; None with `until`
    time_step: in tau
    temperature: that the thermostat holds [epsilon/k_B]; the deck's by default
    total_energy: (U + K)/N, tail included, to which velocities are scaled before the first step [epsilon]
    thermostat, barostat: a name, or a table with its options: {"type": "langevin", "time": 0.5}
    sample: whether observables are measured
    reverse: whether the motion is reversed before the first step
    until: ends the last stage, which is sampled, when the averages have these standard errors:
        {"pressure": 0.005, "max_steps": 1_000_000}, in place of `steps`
    options: of the integrator

        Stage("production", 20000, sample=True)
        Stage("production", until={"pressure": 0.005, "max_steps": 1_000_000}, sample=True)
    """

    if not TYPE_CHECKING:  # for them its keywords are among the keys
        def __init__(self, name: str, steps: int | None = None, *, until: Mapping | None = None, time_step: float | str = 0.004,
                     integrator: str = "velocity-verlet", temperature=None, thermostat=None, barostat=None, sample: bool = False,
                     reverse: bool = False, total_energy=None, **options):
            if (steps is None) == (until is None):
                raise InputError(f"stage {_check.shown(name)}: it takes a number of steps, or `until` with errors, one of the two")
            super().__init__()
            for key, value in {"name": name, "integrator": integrator, **options, "time_step": time_step, "steps": steps,
                               "until": None if until is None else Table(until), "temperature": temperature, "total_energy": total_energy,
                               "thermostat": thermostat, "barostat": barostat}.items():
                if value is not None:
                    self[key] = value
            if _check.truth(sample, f"stage {_check.shown(name)}: sample"):
                self["sample"] = True
            if _check.truth(reverse, f"stage {_check.shown(name)}: reverse"):
                self["reverse"] = True

    def __setitem__(self, key, value):
        if key in ("thermostat", "barostat") and isinstance(value, str):
            value = Table(type=value)
        super().__setitem__(key, value)

    def __reduce__(self):
        return stage_of, (dict(self),)

    def __deepcopy__(self, memo):
        return stage_of(copy.deepcopy(dict(self), memo))

    def __repr__(self) -> str:
        rest = "".join(f", {key}={dict(value) if isinstance(value, dict) else value!r}" for key, value in self.items()
                       if key not in ("name", "steps"))
        steps = f", {self['steps']}" if "steps" in self else ""
        return f"Stage({self.get('name')!r}{steps}{rest})"


def stage_of(table: Mapping) -> Stage:
    stage = Stage.__new__(Stage)
    stage.update(table)
    return stage


class Analyses(_AnalysesKeys):
    """What is measured in the sampled stages: `deck.analysis.rdf(bins=200)` asks for it, `del deck.analysis["rdf"]` does not."""

    if not TYPE_CHECKING:
        def __getattr__(self, name):
            if name.startswith("_"):
                raise AttributeError(name)

            def ask(**options):
                self[name] = Table(options)

            ask.__doc__ = f"Ask for the analysis {name!r}; its options are those of [analysis] in decks."
            return ask

    def __dir__(self):
        return [*super().__dir__(), *_core.build()["analyses"]]


ARGON = Table(sigma="3.405 angstrom", epsilon="119.8 K", mass="39.948 u")
"""Argon as Verlet had it in 1967: with it results are given in SI units, too."""
