"""Lennard-Jones molecular dynamics: Verlet's 1967 experiment and beyond.

    import ljmd

    deck = ljmd.Deck.fluid(atoms=864, density=0.8442, temperature=0.722, substance=ljmd.ARGON)
    deck.stages = [ljmd.Stage("melt", 2000, temperature=1.5, thermostat="rescale"),
                   ljmd.Stage("equilibrate", 6000, thermostat="rescale"),
                   ljmd.Stage("production", 20000, sample=True)]
    deck.analysis.rdf(bins=200)
    run = deck.run("runs/argon")
    run["pressure"].mean, run["pressure"].error
    run.table("rdf")

All numbers are in reduced units, sigma = epsilon = m = k_B = 1, energies per atom. docs/python.md is the tutorial.

Names are loaded when they are first used. What reads results (`ljmd.open`, `ljmd.open_sweep`, `ljmd.reading`)
and `ljmd.style` are Python alone; all else takes the compiled part, ljmd._core, and raises ImportError where that is missing.
"""

from __future__ import annotations

import importlib
import sys
from typing import TYPE_CHECKING

if TYPE_CHECKING:  # what type checkers see, `X as X` for those that are strict; tests/python/lazy_test.py holds it against _PLACES
    from ._core import build as build
    from .comparisons import Comparison as Comparison
    from .deck import Check as Check, Deck as Deck
    from .equation_of_state import Properties as Properties, eos as eos, equations as equations
    from .errors import (CheckpointError as CheckpointError, DataError as DataError, Error as Error, FileError as FileError,
                         InputError as InputError, InternalError as InternalError, Interrupted as Interrupted, InUseError as InUseError,
                         PhysicsError as PhysicsError, RunWarning as RunWarning, ThreadsError as ThreadsError)
    from .evaluation import Evaluation as Evaluation, Evaluator as Evaluator, evaluate as evaluate
    from .external import external_force as external_force
    from .frames import Frames as Frames
    from .observables import observable as observable
    from .opening import open as open, resume as resume  # noqa: A004, ljmd.open
    from .pictures import style as style
    from .potentials import Pair as Pair, pair as pair
    from .reading.observables import Observable as Observable, Quantity as Quantity
    from .reference_values import Reference as Reference, ReferenceValue as ReferenceValue, reference as reference
    from .replicas import Replicas as Replicas
    from .results import Results as Results
    from .runs import Run as Run
    from .simulation import Arrays as Arrays, Simulation as Simulation
    from .sweeps import Point as Point, Sweep as Sweep, open_sweep as open_sweep
    from .tables import ARGON as ARGON, PotentialTable as PotentialTable, Stage as Stage, Table as Table
    from .trajectories import Trajectory as Trajectory, trajectory as trajectory

    __version__: str

_PLACES = {
    "_core": ("build",),
    "comparisons": ("Comparison",),
    "deck": ("Check", "Deck"),
    "equation_of_state": ("Properties", "eos", "equations"),
    "errors": ("CheckpointError", "DataError", "Error", "FileError", "InputError", "InternalError", "Interrupted", "InUseError",
               "PhysicsError", "RunWarning", "ThreadsError"),
    "evaluation": ("Evaluation", "Evaluator", "evaluate"),
    "external": ("external_force",),
    "frames": ("Frames",),
    "observables": ("observable",),
    "opening": ("open", "resume"),
    "pictures": ("style",),
    "potentials": ("Pair", "pair"),
    "reading.observables": ("Observable", "Quantity"),
    "reference_values": ("Reference", "ReferenceValue", "reference"),
    "replicas": ("Replicas",),
    "results": ("Results",),
    "runs": ("Run",),
    "simulation": ("Arrays", "Simulation"),
    "sweeps": ("Point", "Sweep", "open_sweep"),
    "tables": ("ARGON", "PotentialTable", "Stage", "Table"),
    "trajectories": ("Trajectory", "trajectory"),
}
_PLACE_OF = {name: place for place, names in _PLACES.items() for name in names}
_MODULES = (*(place for place in _PLACES if place.isidentifier()), "ase", "reading")

__all__ = sorted(_PLACE_OF)


if not TYPE_CHECKING:  # checkers would take any name for one of the package
    def __getattr__(name: str):
        if name == "__version__":
            found = {name: _loaded("_core").build()["version"]}
        elif name in _PLACE_OF:
            module = _loaded(_PLACE_OF[name])
            found = {each: getattr(module, each) for each in _PLACES[_PLACE_OF[name]]}
        elif name in _MODULES:
            found = {name: _loaded(name)}
        else:
            raise AttributeError(f"module 'ljmd' has no attribute {name!r}")
        globals().update(found)
        return found[name]


def __dir__() -> list[str]:
    return sorted({*globals(), *__all__, *_MODULES, "__version__"})


def _loaded(place: str):
    """A module of the package. One that takes the compiled part imports it from here, so that there is one message without it."""
    try:
        module = importlib.import_module(f"{__name__}.{place}")
        if place == "_core":  # a second interpreter gets what the first one has made, without a word to it
            module.require_main_interpreter()
        return module
    except ImportError as error:
        if place != "_core":
            raise
        raise ImportError(_what_is_missing(error), name=f"{__name__}._core") from None


def _what_is_missing(error: ImportError) -> str:
    import pathlib

    folder = pathlib.Path(__file__).parent
    this = f"Python {sys.version_info.major}.{sys.version_info.minor} ({sys.executable})"
    built = [path.name for path in sorted(folder.glob("_core.*")) if path.suffix in (".so", ".pyd")]
    if not built:
        found = f"{folder} has no _core: this is the package without it, for reading results; build it for {this}"
    elif isinstance(error, ModuleNotFoundError):
        found = f"this is {this}, and {folder} has {', '.join(built)}: take the Python that it was built for, or build it for this one"
    else:
        found = f"{folder / built[0]} cannot be loaded by {this}: {error}"
    return f"the compiled part of ljmd is missing: {found}"
