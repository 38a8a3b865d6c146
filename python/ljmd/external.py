"""Forces from outside on the atoms, computed in Python at each evaluation of the forces."""

from __future__ import annotations

from typing import TYPE_CHECKING

from ._check import truth
from ._decorated import Decorated

if TYPE_CHECKING:
    from ._types import Function


class external_force(Decorated):
    """A force of your own on each atom, in addition to the pair forces: a trap, a field, a wall, a drive.

    A function of the positions that returns an array of forces of shape (N, 3), in the order of the atoms' ids
    [epsilon/sigma]. It gets `positions` (in the box) and `unwrapped` (continuous in time), both of shape (N, 3), `edges`,
    `atoms` and `time`, during its call. It is called once for each evaluation of the forces, for most integrators once a
    step, and must depend on nothing else: no memory, no random numbers.

        @ljmd.external_force(energy=True)
        def trap(s):
            d = s.positions - 0.5 * s.edges
            return -0.2 * d, 0.1 * (d**2).sum()

        run = deck.run(external=trap)
        run["external_energy"]

    energy: the force has a potential energy, f = -grad U(r), which does not depend on time, and the function returns it
        after the forces: one number for all atoms together, or one for each [epsilon]. Then `total_energy` includes it and
        is conserved, and `external_energy` is an observable, per atom.
    virial: the function also returns W_ab = -dU/d(eps_ab), shape (3, 3), for box and positions stretched by 1 + eps
        together [epsilon]. It is part of the pressure; a barostat needs it. For a field that scales with the box it is 0.
    name: in messages and in the record of a run; that of the function by default

    Raises InputError when the function returns anything else, PhysicsError with the atom for a force that is not finite;
    what the function raises ends the run.
    """

    _kind, _argument, _usual_name = "an external force", "the positions", "external force"

    def __init__(self, function: Function | None = None, *, energy: bool = False, virial: bool = False, name: str = ""):
        self.energy, self.virial = truth(energy, "energy"), truth(virial, "virial")
        super().__init__(function, name)

    def __repr__(self) -> str:
        parts = [part for part, there in (("energy", self.energy), ("virial", self.virial)) if there]
        return f"<ljmd.external_force {self.name!r}{': with ' if parts else ''}{' and '.join(parts)}>"


def described_force(force):
    """For the engine: (name, function, energy, virial), or None. A plain function gets the defaults."""
    if force is None:
        return None
    force = external_force.of(force)
    return force.name, force.function, force.energy, force.virial
