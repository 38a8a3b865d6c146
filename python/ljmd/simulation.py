"""A run in memory, step by step."""

from __future__ import annotations

import contextlib
from collections.abc import Iterator
from typing import TYPE_CHECKING, Any

from . import _check, _core, _progress
from .errors import InputError
from .external import described_force
from .frames import Frames, Recorder
from .observables import described
from .runs import Run

if TYPE_CHECKING:
    from ._types import Array, Deck, Function, Functions, Progress


class Arrays:
    """The memory of the atoms, without a copy: read-only arrays in the order of memory, which `ids` tells.

    Valid in the block of `with sim.arrays()`. No step can be taken while one of the arrays is in use (BufferError).
    """

    def __init__(self, view):
        self._view = view

    def _get(self, name):
        if self._view is None:
            raise InputError("these arrays were those of a block that has ended")
        return getattr(self._view, name)()

    @property
    def positions(self) -> Array:
        """Shape (N, 3) [sigma]; near the box, not wrapped into it."""
        return self._get("positions")

    @property
    def velocities(self) -> Array:
        """Shape (N, 3) [sigma/tau]."""
        return self._get("velocities")

    @property
    def forces(self) -> Array:
        """Shape (N, 3) [epsilon/sigma]."""
        return self._get("forces")

    @property
    def masses(self) -> Array:
        """Shape (N,) [m]."""
        return self._get("masses")

    @property
    def ids(self) -> Array:
        """Shape (N,): row k of the other arrays is the atom with id ids[k], from 0."""
        return self._get("ids")


def _energy(name: str, meaning: str) -> property:
    def get(self):
        now = self._core.now()
        if name not in now:
            raise InputError(f"{name} is that of a fluid: this deck has few bodies")
        return now[name]

    return property(get, doc=f"{meaning} Known without a cost at the deck's samples (output.thermo.every); else forces are "
                             "evaluated once more.")


class Simulation:
    """A run in memory, step by step, with the bits of `ljmd run` on the same deck.

        sim = ljmd.Simulation(deck, threads=2)
        for _ in sim.steps(1000, every=100):
            print(sim.time, sim.temperature, sim.potential_energy)

    Arrays such as `sim.positions` are copies, shape (N, 3), in the order of the atoms' ids. `with sim.arrays() as a`
    gives the memory itself. Everything is in reduced units, energies per atom.

    observables, external, threads, simd, force: as in `Deck.run`. Raises InputError with all mistakes of the deck.
    """

    def __init__(self, deck: Deck, *, observables: Functions = (), external: Function | None = None, threads: int | None = None,
                 simd: str | None = None, force: bool = False):
        deck = _check.deck(deck, "deck")
        self._core = _core.Simulation(deck._loaded(force), _check.threads_of(threads), _check.simd_of(simd),
                                      described(observables), described_force(external), _check.warn)
        self._title = deck.title
        self._recorder = self._recorder_of(deck)

    def advance(self, steps: int, progress: Progress = False) -> None:
        """Take some steps; fewer if the stages end before.

        Ctrl-C raises KeyboardInterrupt between two steps, and the simulation can go on afterwards.
        Raises PhysicsError when the run blows up, and what an observable or an external force
        raises: it can be looked at then, not continued.
        """
        steps = _check.whole(steps, "steps", 0)
        with _progress.shown(progress, min(self.step + steps, self.total_steps), self.step) as tell:
            self._take(steps, tell)

    def _recorder_of(self, deck):
        """Keeps the frames that the deck asks for; None: it asks for none, or has few bodies, whose trajectory is a table."""
        wanted = (deck._tables.get("output") or {}).get("trajectory")
        if not wanted or self._core.edges() is None:
            return None
        recorder = Recorder(wanted["every"], bool(wanted.get("velocities", False)))
        recorder.take(self._core)
        return recorder

    def _take(self, steps: int, tell) -> None:
        if self._recorder is None:
            self._core.advance(steps, tell)
            return
        steps = min(steps, self.total_steps - self.step)
        while True:
            part = min(steps, self._recorder.steps_to_next(self.step))
            self._core.advance(part, tell)
            self._recorder.take(self._core)
            steps -= part
            if steps <= 0:
                return

    def steps(self, count: int | None = None, every: int = 1) -> Iterator[Simulation]:
        """Take `count` steps, all that are left by default, and give control after each `every` of them.

            for _ in sim.steps(1000, every=10): ...
        """
        every = _check.whole(every, "every", 1)
        left = self.total_steps - self.step
        return self._steps(left if count is None else min(left, _check.whole(count, "count", 0)), every)

    def _steps(self, left, every):
        advance = self._core.advance if self._recorder is None else self._take
        while left > 0:
            part = min(every, left)
            advance(part, None)
            left -= part
            yield self

    def run(self, progress: Progress = True) -> Run:
        """Take all steps that are left, and return the results."""
        with _progress.shown(progress, self.total_steps, self.step) as tell:
            self._take(max(self.total_steps - self.step, 0), tell)
        results = self.results()
        for warning in results.warnings:
            _check.warn(warning)
        return results

    def results(self) -> Run:
        """The results so far."""
        data, _ = self._core.report()
        frames = None if self._recorder is None else self._recorder.frames()
        edges = self._core.edges()
        last = None if edges is None else Frames.of_one(self._core.unwrapped(), self._core.velocities(), edges, self.time, self.step)
        return Run(data, self._core.tables(), self._core.thermo(), None, self.finished, frames, last)

    @contextlib.contextmanager
    def arrays(self) -> Iterator[Arrays]:
        """The memory of the atoms, see `Arrays`."""
        arrays = Arrays(self._core.view())
        try:
            yield arrays
        finally:
            arrays._view = None

    def checkpoint(self) -> bytes:
        """Everything that the rest of the run depends on, observables included. For fluids."""
        return self._core.checkpoint()

    def restore(self, checkpoint: bytes) -> None:
        """Continue from a checkpoint of a simulation of the same deck, observables and external force; the rest has the
        same bits.

        Raises CheckpointError for another deck, and for damaged bytes.
        """
        if not isinstance(checkpoint, (bytes, bytearray)):
            raise InputError(f"a checkpoint is bytes, found {type(checkpoint).__name__}")
        self._core.restore(bytes(checkpoint))
        if self._recorder is not None:
            self._recorder.go_back_to(self.step)

    def __reduce__(self):
        raise TypeError("a simulation cannot be copied or pickled: make another one of the same deck, and let it restore() this one's "
                        "checkpoint()")

    step = property(lambda self: self._core.step(), doc="Steps done since the start.")
    total_steps = property(lambda self: self._core.total_steps(), doc="Steps of all stages.")
    finished = property(lambda self: self._core.finished(), doc="Whether all steps are done.")
    time = property(lambda self: self._core.time(), doc="Time [tau].")
    stage = property(lambda self: self._core.stage(), doc="Name of the stage that the next step belongs to.")
    atoms = property(lambda self: self._core.atoms(), doc="Number of atoms or bodies, N.")
    edges = property(lambda self: self._core.edges(), doc="Edges of the box, shape (3,) [sigma]; None without a box.")
    positions = property(lambda self: self._core.positions(), doc="In the box, by id: shape (N, 3) [sigma]. A copy.")
    unwrapped = property(lambda self: self._core.unwrapped(),
                         doc="Continuous in time, by id: shape (N, 3) [sigma]. A copy.")
    velocities = property(lambda self: self._core.velocities(), doc="By id: shape (N, 3) [sigma/tau]. A copy.")
    forces = property(lambda self: self._core.forces(), doc="By id: shape (N, 3) [epsilon/sigma]. A copy.")
    masses = property(lambda self: self._core.masses(), doc="By id: shape (N,) [m]. A copy.")

    temperature = _energy("temperature", "Of the motion about the centre of mass [epsilon/k_B].")
    potential_energy = _energy("potential_energy", "Per atom, of few bodies in total [epsilon].")
    kinetic_energy = _energy("kinetic_energy", "Per atom, of few bodies in total [epsilon].")
    total_energy = _energy("total_energy", "Per atom, of few bodies in total [epsilon].")
    external_energy = _energy("external_energy", "Of an external force that has one, else None; per atom [epsilon].")
    pressure = _energy("pressure", "[epsilon/sigma^3].")
    density = _energy("density", "N/V [sigma^-3].")

    @property
    def thermo(self) -> Any:
        """The samples so far, see `Run.thermo`."""
        return self.results().thermo

    def __repr__(self) -> str:
        title = f" {self._title!r}" if self._title else ""
        return f"<ljmd.Simulation{title}: {self.atoms} atoms, step {self.step} of {self.total_steps}, stage {self.stage!r}>"
