"""Energy, forces and virial of configurations, without a run."""

from __future__ import annotations

from dataclasses import dataclass
from typing import TYPE_CHECKING, Any

import numpy as np

from . import _check, _core
from .errors import InputError
from .potentials import Pair
from .tables import PotentialTable

if TYPE_CHECKING:
    from ._types import Array

DEFAULT: dict = {"type": "lennard-jones", "cutoff": 2.5, "truncation": "shifted"}


@dataclass(frozen=True, repr=False)
class Evaluation:
    """What `ljmd.evaluate` finds, in reduced units.

    potential_energy: U/N, with the tail if there is one [epsilon]
    forces: by atom, shape (N, 3) [epsilon/sigma]
    virial_tensor: W_ab = sum over pairs of r_a f_b, without tail, shape (3, 3) [epsilon]
    virial_pressure: tr W/(3 V) + p_tail, the pressure of atoms at rest [epsilon/sigma^3]
    energies: by atom, half of its pairs' energies, without tail, shape (N,) [epsilon]; None unless asked for
    pairs_too_near: number of pairs nearer than the start of the table of an `ljmd.Pair`, where the force is constant
    """

    potential_energy: float
    forces: Array
    virial_tensor: Array
    virial_pressure: float
    energies: Array | None = None
    pairs_too_near: int = 0

    @property
    def virial(self) -> float:
        """W = sum over pairs of r . f [epsilon]."""
        return float(np.trace(self.virial_tensor))

    def __repr__(self) -> str:
        return (f"<ljmd.Evaluation: {len(self.forces)} atoms, U/N = {self.potential_energy:.10g}, W = {self.virial:.10g}, "
                f"virial pressure {self.virial_pressure:.10g}, largest force {_longest(self.forces):.4g}>")


def _longest(vectors) -> float:
    """The length of the longest vector, whose squares may be out of the range of numbers."""
    return float(np.hypot(np.hypot(vectors[:, 0], vectors[:, 1]), vectors[:, 2]).max())


class Evaluator:
    """Evaluates configurations one after another: `evaluator(positions, edges)`, see `ljmd.evaluate`.

    Neighbours are kept from call to call, which saves time where atoms move a little between two. Forces then have the
    order of sums of an earlier configuration: they differ in rounding from those of `ljmd.evaluate`.
    """

    def __init__(self, potential: PotentialTable | Pair | None = None, *, skin: float = 0.3, threads: int | None = None, simd: str | None = None,
                 precision: str = "double"):
        if potential is not None and not isinstance(potential, (dict, Pair)):
            raise InputError(f"potential: {_check.shown(potential)} is not allowed: a table as [potential] of decks, or an ljmd.Pair")
        self._potential: dict | Pair = potential if isinstance(potential, Pair) else {**DEFAULT, **_check.table(potential, "potential")}
        self._options = (_check.number(skin, "skin"), _check.threads_of(threads), _check.simd_of(simd),
                         _check.text(precision, "precision"))
        self._core = self._made()

    def _made(self):
        if isinstance(self._potential, Pair):
            if self._options[3] != "double":
                raise InputError("a pair potential in Python is computed in double precision")
            return _core.Evaluator(self._potential._core, *self._options[:3])
        table = dict(self._potential)
        names = [_check.text(table.pop(key), f"potential: {key}") for key in ("type", "truncation")]
        tail = _check.truth(table.pop("tail", False), "potential: tail")
        numbers = {key: _check.number(value, f"potential: {key}") for key, value in table.items()}
        cutoff, switch_start = numbers.pop("cutoff"), numbers.pop("switch_start", 0.0)
        return _core.Evaluator(*names, cutoff, switch_start, list(numbers.items()), tail, *self._options)

    @property
    def cutoff(self) -> float:
        """[sigma]"""
        return float(self._potential.cutoff if isinstance(self._potential, Pair) else self._potential["cutoff"])

    def __call__(self, positions: Any, edges: Any, *, energies: bool = False) -> Evaluation:
        """See `ljmd.evaluate`."""
        energy, virial, pressure, forces, of_atoms, too_near, warning = self._core.evaluate(
            vectors(positions, "positions"), edges_of(edges), _check.truth(energies, "energies"))
        if warning:
            _check.warn(warning)
        return Evaluation(energy, forces, virial, pressure, of_atoms, too_near)

    def __reduce__(self):
        return _evaluator_of, (self._potential, self._options)

    def __repr__(self) -> str:
        what = repr(self._potential) if isinstance(self._potential, Pair) else self._potential
        return f"<ljmd.Evaluator: {what}>"


def _evaluator_of(potential, options) -> Evaluator:
    skin, threads, simd, precision = options
    return Evaluator(potential, skin=skin, threads=threads or None, simd=simd, precision=precision)


def vectors(array, name: str) -> np.ndarray:
    """Vectors of atoms as an array of doubles of shape (N, 3)."""
    found = _check.real_array(array, name)
    if found.ndim != 2 or found.shape[1] != 3:
        raise InputError(f"{name}: shape {found.shape}, (N, 3) is needed")
    return found


def edges_of(edges) -> tuple:
    """Three edges from one number or three."""
    found = _check.real_array(edges, "edges")
    if found.shape not in ((), (1,), (3,)):
        raise InputError(f"edges: {_check.shown(edges)}: one number or three are needed, those of the box")
    return tuple(float(edge) for edge in np.broadcast_to(found, 3))


def evaluate(positions: Any, edges: Any, *, potential: PotentialTable | Pair | None = None, energies: bool = False,
             threads: int | None = None, simd: str | None = None, precision: str = "double") -> Evaluation:
    """Energy, forces and virial of one configuration of a fluid: periodic box, one kind of atom, no run.

        u = 4 (r^-12 - r^-6),  U = sum over pairs with r < cutoff,  f_i = -dU/dr_i,  W_ab = sum over pairs of r_a f_b

    positions: shape (N, 3) [sigma]; may lie outside the box
    edges: of the box, from the origin, three numbers or one [sigma]; each at least twice the cutoff
    potential: a table as [potential] of decks, in reduced units, or an `ljmd.Pair`; by default Lennard-Jones, shifted at 2.5
    energies: also those of the atoms, u_i = half of the energies of its pairs; their sum is U without tail. They take
        about as long as a few evaluations
    threads, simd, precision: as in `Deck.run`

    The bits are those of a run that starts from these positions. For many configurations in a row: `ljmd.Evaluator`.
    Raises InputError for wrong shapes, numbers that are not finite, atoms that overlap so that their forces are not, and a cutoff
    longer than half the box. Pairs nearer than the start of an `ljmd.Pair`'s table are counted, and are an ljmd.RunWarning.
    """
    evaluator = Evaluator(potential, threads=threads, simd=simd, precision=precision)
    return evaluator(positions, edges, energies=energies)
