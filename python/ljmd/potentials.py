"""Pair potentials of one's own, computed in Python once and then by a table in C++."""

from __future__ import annotations

from collections.abc import Callable
from typing import TYPE_CHECKING, Any, overload

import numpy as np

from . import _check, _core
from .errors import InputError

if TYPE_CHECKING:
    from ._types import Array, Function, Path

_MOST_PIECES = 4096


class Pair:
    """A pair potential u(r) of your own, as a table: polynomials of degree 7 through its energies, whose derivative is
    the force. Made by `ljmd.pair`.

    error: largest error of the energy found between the points of the table, in units of 1 + |u|
    force_error: an estimate from above of that of -du/dr, in units of 1 + |du/dr|
    """

    def __init__(self, name, first, cutoff, energies, truncation, switch_start, error, force_error):
        self.name, self.truncation = _check.text(name, "name"), _check.text(truncation, "truncation")
        first, self.cutoff = _check.number(first, "first", 0.0), _check.positive(cutoff, "cutoff")
        self.switch_start = None if switch_start is None else _check.positive(switch_start, "switch_start")
        self.error, self.force_error = _check.number(error, "error", 0.0), _check.number(force_error, "force_error", 0.0)
        energies = _check.real_array(energies, "energies")
        if energies.ndim != 1:
            raise InputError(f"energies: shape {energies.shape}, one dimension is needed")
        self._table = (first, energies)
        self._core = _core.Pair(self.name, first, self.cutoff, energies, self.truncation, self.switch_start or 0.0, self.error,
                                self.force_error)

    def __reduce__(self):
        first, energies = self._table
        return type(self), (self.name, first, self.cutoff, energies, self.truncation, self.switch_start, self.error,
                            self.force_error)

    @classmethod
    def of_run(cls, directory: Path) -> "Pair | None":
        """The one that the run in a directory was given, from the table there; None if it was given none."""
        found = _core.pair_of_run(_check.directory_of(directory))
        if found is None:
            return None
        name, first, cutoff, energies, truncation, switch_start, error, force_error = found
        return cls(name, first, cutoff, energies, truncation, switch_start or None, error, force_error)

    def __deepcopy__(self, memo):
        return self  # nothing of it changes

    @property
    def stand_in(self) -> dict[str, Any]:
        """A table [potential] with this cutoff and truncation, for the reader of decks."""
        table = {"type": "lennard-jones", "cutoff": self.cutoff, "truncation": self.truncation}
        if self.truncation in ("cut", "switched"):
            table["tail"] = False
        if self.switch_start is not None:
            table["switch_start"] = self.switch_start
        return table

    def _values(self, r, which):
        r = _check.real_array(r, "distances")
        return self._core.values(r.ravel(), True)[which].reshape(r.shape)

    def __call__(self, r: Any) -> Array:
        """u at distances r [sigma], truncated, in the shape of r [epsilon]."""
        return self._values(r, 0)

    def force(self, r: Any) -> Array:
        """-du/dr at distances r [sigma], in the shape of r [epsilon/sigma]."""
        return self._values(r, 1)

    def second_virial(self, temperature: float) -> float:
        """B2(T) = -2 pi int (exp(-u/T) - 1) r^2 dr up to the cutoff [sigma^3]."""
        return self._core.second_virial(_check.positive(temperature, "temperature"))

    def __repr__(self) -> str:
        first, energies = self._table
        return (f"<ljmd.Pair {self.name!r}: {self.truncation} at {self.cutoff:g}; table of {len(energies) // 7} pieces from "
                f"r = {first:g}, error of u {self.error:.0e}, of the force {self.force_error:.0e}>")


@overload
def pair(function: Function, *, cutoff: float, truncation: str, name: str = ..., switch_start: float | None = ..., start: float | None = ...,
         error: float = ...) -> Pair: ...


@overload
def pair(function: None = ..., *, cutoff: float, truncation: str, name: str = ..., switch_start: float | None = ..., start: float | None = ...,
         error: float = ...) -> Callable[[Function], Pair]: ...


def pair(function: Function | None = None, *, cutoff: float, truncation: str, name: str = "", switch_start: float | None = None, start: float | None = None,
         error: float = 1e-9) -> Pair | Callable[[Function], Pair]:
    """A pair potential of your own: `deck.potential = ljmd.pair(lambda r: 4*(r**-9 - r**-6), cutoff=2.5, truncation="shifted")`.

    function: u(r) of an array of distances [epsilon]; called when the pair is made, never in a run
    cutoff: [sigma]
    truncation: "cut", "shifted", "force-shifted" or "switched" (with switch_start)
    start: where the table begins, 0 if u is finite there, else 0.3 [sigma]; below it the force is constant. Samples in which pairs
        were nearer are counted, and make a warning
    error: that the table may have, in units of 1 + |u|; a function with a kink takes a larger one

    Energies, pressures, errors, analyses and threads work as with the built-in potentials; a step takes about ten times
    as long. Without a function: a decorator. Raises InputError unless u is finite and smooth enough for the error.
    """
    if function is None:
        return lambda each: pair(each, cutoff=cutoff, truncation=truncation, name=name, switch_start=switch_start,
                                 start=start, error=error)
    if not callable(function):
        raise InputError(f"a pair potential is a function u(r), found {_check.shown(function)}")
    name = _check.text(name, "name") or getattr(function, "__name__", "pair").replace("<lambda>", "pair")
    cutoff, error = _check.positive(cutoff, "cutoff"), _check.positive(error, "error")
    switch_start = None if switch_start is None else _check.positive(switch_start, "switch_start")
    first = _start(function, name, cutoff) if start is None else _check.number(start, "start", 0.0)
    pieces = 64
    coarse = _Table(function, name, first, cutoff, pieces // 2)
    while True:
        fine = _Table(function, name, first, cutoff, pieces)
        found, where = fine.error_of_energy()
        if found <= error:
            break
        if pieces >= _MOST_PIECES:
            raise InputError(f"pair potential {name!r}: with {pieces} pieces its table has an error of {found:.1e} at "
                             f"r = {where:.4g}, more than {error:.1e}: it has a kink or a jump there, or a larger `start` or "
                             "`error` is to be given")
        coarse, pieces = fine, 2 * pieces
    return Pair(name, first, cutoff, fine.energies, _check.text(truncation, "truncation"), switch_start, found, fine.error_of_force(coarse))


def _evaluated(function, name, r):
    """u at all distances: one call, or one for each where the function takes numbers alone. May be infinite."""
    with np.errstate(all="ignore"):
        try:
            u = function(r)
        except (TypeError, ValueError):
            u = [function(float(x)) for x in r]
        try:
            u = np.broadcast_to(_check.real_array(u, name), r.shape)
        except ValueError:  # an InputError is one
            raise InputError(f"pair potential {name!r}: of an array of {len(r)} distances it returned {_check.shown(u)}, not an "
                             "energy for each") from None
    return np.array(u)


def _start(function, name, cutoff) -> float:
    try:
        at_zero = _evaluated(function, name, np.array([0.0, 1e-3 * cutoff]))
    except ZeroDivisionError:
        return min(0.3, 0.5 * cutoff)
    return 0.0 if np.all(np.isfinite(at_zero)) else min(0.3, 0.5 * cutoff)


class _Table:
    def __init__(self, function, name, first, last, pieces):
        self.function, self.name = function, name
        self.r = np.array(_core.pair_distances(first, last, pieces))
        self.energies = _evaluated(function, name, self.r)
        if not np.all(np.isfinite(self.energies)):
            k = np.flatnonzero(~np.isfinite(self.energies))[0]
            raise InputError(f"pair potential {name!r}: u({self.r[k]:.4g}) = {self.energies[k]}; a table has finite energies: "
                             "give a larger `start`")
        self._core = _core.Pair("a table", first, last, self.energies, "cut", 0.0, 0.0, 0.0)

    def error_of_energy(self):
        between = 0.5 * (self.r[1:] + self.r[:-1])
        exact = _evaluated(self.function, self.name, between)
        errors = np.abs(self._core.values(between, False)[0] - exact) / (1 + np.abs(exact))
        errors = np.where(np.isfinite(errors), errors, np.inf)
        k = int(np.argmax(errors))
        return float(errors[k]), float(between[k])

    def error_of_force(self, coarse) -> float:
        between = 0.5 * (self.r[1:] + self.r[:-1])
        force = self._core.values(between, False)[1]
        return float(np.max(np.abs(force - coarse._core.values(between, False)[1]) / (1 + np.abs(force))))
