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
"""

from ._core import build
from .comparisons import Comparison
from .deck import ARGON, Check, Deck, Stage, Table
from .equations import Properties, eos, equations
from .errors import (CheckpointError, DataError, Error, FileError, InputError, InternalError, Interrupted, InUseError,
                     PhysicsError, RunWarning, ThreadsError)
from .evaluation import Evaluation, Evaluator, evaluate
from .external import external_force
from .frames import Frames
from .observables import observable
from .potentials import Pair, pair
from .replicas import Replicas
from .results import Observable, Quantity, Results, Run, resume
from .results import open_run as open  # noqa: A001, ljmd.open
from .simulation import Arrays, Simulation
from .sweeps import Point, Sweep, open_sweep
from .trajectories import Trajectory, trajectory

__version__ = build()["version"]

__all__ = ["ARGON", "Arrays", "Check", "CheckpointError", "Comparison", "DataError", "Deck", "Error", "Evaluation", "Evaluator",
           "FileError", "Frames", "InUseError", "InputError", "InternalError", "Interrupted", "Observable", "Pair",
           "PhysicsError", "Point", "Properties", "Quantity", "Replicas", "Results", "Run", "RunWarning", "Simulation", "Stage", "Sweep", "Table",
           "ThreadsError", "Trajectory", "build", "eos", "equations", "evaluate", "external_force", "observable", "open",
           "open_sweep", "pair", "resume", "trajectory"]
