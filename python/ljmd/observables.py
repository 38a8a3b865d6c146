"""Observables of one's own, measured while a run goes on."""

from __future__ import annotations

from typing import TYPE_CHECKING

from ._check import listed, text, truth, whole
from ._decorated import Decorated
from .errors import InputError

if TYPE_CHECKING:
    from ._types import Function


class observable(Decorated):
    """A measurement of your own: a function of a snapshot that returns one number.

    It is called in the sampled stages, at steps that `every` divides, and its mean gets an error by blocking, as the
    built-in ones. The snapshot has `step`, `time`, `atoms`, `edges`, and `positions`, `unwrapped`, `velocities`,
    `forces` of shape (N, 3) in the order of the atoms' ids. With `energy=True` it also has `temperature`,
    `potential_energy`, `kinetic_energy`, `total_energy`, `external_energy` (per atom) and `pressure`. It is valid during
    the call.

        @ljmd.observable(every=50, unit="sigma/tau")
        def fastest(s):
            return np.linalg.norm(s.velocities, axis=1).max()

        run = deck.run(observables=[fastest])
        run["fastest"]

    Raises InputError when the function returns anything but a finite number; what the function raises ends the run.
    """

    _kind, _argument, _usual_name = "an observable", "a snapshot", "observable"

    def __init__(self, function: Function | None = None, *, every: int = 10, unit: str = "", energy: bool = False, name: str = ""):
        self.every = whole(every, "every", 1)
        self.unit, self.energy = text(unit, "unit"), truth(energy, "energy")
        super().__init__(function, name)

    def __repr__(self) -> str:
        return f"<ljmd.observable {self.name!r}: every {self.every} steps{', ' + self.unit if self.unit else ''}>"


def described(observables) -> list:
    """For the engine: (name, unit, function, every, energy) of each. Plain functions get the defaults."""
    if callable(observables):
        observables = [observables]
    all_of = [observable.of(each) for each in listed(observables, "observables")]
    names = [each.name for each in all_of]
    for each in all_of:
        if names.count(each.name) > 1:
            raise InputError(f"two observables have the name {each.name!r}: give one of them another, name=...")
        if each.name in BUILT_IN:
            raise InputError(f"{each.name!r} is the name of a built-in observable: give yours another, name=...")
    return [(each.name, each.unit, each.function, each.every, each.energy) for each in all_of]


# docs/files.md has what they are.
BUILT_IN = {"temperature", "potential_energy", "kinetic_energy", "total_energy", "external_energy", "pressure",
            "compressibility_factor",
            *(f"pressure_{k}" for k in ("xx", "yy", "zz", "xy", "xz", "yz")), "virial", "heat_capacity_cv", "density",
            "coordination_number", "diffusion", "diffusion_green_kubo", "viscosity", "bulk_viscosity",
            "thermal_conductivity", "diffusion_infinite_system", "excess_chemical_potential",
            "configurational_temperature", "isothermal_compressibility", "adiabatic_compressibility",
            "thermal_expansion", "thermal_pressure_coefficient", "heat_capacity_cp", "speed_of_sound",
            "joule_thomson_coefficient", "surface_tension", "normal_pressure", "liquid_density", "vapour_density",
            "cutoff_energy", "cutoff_pressure", "cutoff_energy_response", "cutoff_pressure_response",
            "site_displacement", "site_displacement_debye_waller", "lindemann_ratio", "bragg_peak", "vacant_sites"}
