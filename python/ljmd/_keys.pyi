"""The keys of decks, for type checkers alone. Generated from the schema of decks by tools/python-keys, which says how."""

from collections.abc import Callable, Iterable, Mapping
from typing import Any, Generic, TypedDict, TypeVar

from .results import Results

_Got = TypeVar("_Got")
_Given = TypeVar("_Given")

class Attribute(Generic[_Got, _Given]):
    """A property to which more can be assigned than it returns, a dict for a table, None for the default."""
    def __init__(self, get: Callable[[Any], _Got], give: Callable[[Any, _Given], None], drop: None = ..., meaning: str = ...) -> None: ...
    def __get__(self, owner: Any, kind: Any = ...) -> _Got: ...
    def __set__(self, owner: Any, value: _Given) -> None: ...
    def __delete__(self, owner: Any) -> None: ...

class Substance(dict[str, Any]):
    """A real substance: adds SI units to the deck and SI columns to the results."""
    sigma: Attribute[str, str | None]
    epsilon: Attribute[str, str | None]
    mass: Attribute[str, str | None]

class SystemLattice(dict[str, Any]):
    """Positions to start from."""
    type: Attribute[str, str | None]
    cells: Attribute[int, int | None]
    atoms: Attribute[int, int | None]
    layers: Attribute[int, int | None]
    height: Attribute[Any, float | str | None]

class System(dict[str, Any]):
    """Atoms and box."""
    lattice: Attribute[SystemLattice, Mapping[str, Any] | None]
    file: Attribute[str, str | None]
    xyz_comment: Attribute[str, str | None]
    density: Attribute[Any, float | str | None]
    temperature: Attribute[Any, float | str | None]
    velocities: Attribute[str, str | None]
    seed: Attribute[int, int | None]

class Potential(dict[str, Any]):
    """Forces."""
    type: Attribute[str, str | None]
    cutoff: Attribute[Any, float | str | None]
    truncation: Attribute[str, str | None]
    tail: Attribute[bool, bool | None]
    minimum: Attribute[Any, float | str | None]
    steepness: Attribute[float, float | None]
    well_depth: Attribute[Any, float | str | None]
    switch_start: Attribute[Any, float | str | None]

class Neighbors(dict[str, Any]):
    """Pair search."""
    method: Attribute[str, str | None]
    skin: Attribute[Any, float | str | None]
    every: Attribute[int, int | None]
    tile: Attribute[int, int | None]

class Performance(dict[str, Any]):
    """How forces are computed."""
    precision: Attribute[str, str | None]

class StageUntil(dict[str, Any]):
    """In place of `steps` in the last stage, which is sampled: it ends as soon as the averages have these standard errors, `{ pressure = 0.005,
    max_steps = 1000000 }`."""
    temperature: Attribute[Any, float | str | None]
    potential_energy: Attribute[Any, float | str | None]
    kinetic_energy: Attribute[Any, float | str | None]
    total_energy: Attribute[Any, float | str | None]
    pressure: Attribute[Any, float | str | None]
    density: Attribute[float, float | None]
    compressibility_factor: Attribute[float, float | None]
    heat_capacity_cv: Attribute[float, float | None]
    max_steps: Attribute[int, int | None]

class StageThermostat(dict[str, Any]):
    """Holds the temperature; all but `rescale` go with velocity-verlet only."""
    type: Attribute[str, str | None]
    every: Attribute[int, int | None]
    length: Attribute[int, int | None]
    time: Attribute[Any, float | str | None]

class StageBarostat(dict[str, Any]):
    """Holds the pressure, beside a canonical thermostat."""
    type: Attribute[str, str | None]
    compressibility: Attribute[float, float | None]
    edges: Attribute[str, str | None]
    every: Attribute[int, int | None]
    pressure: Attribute[Any, float | str | None]
    time: Attribute[Any, float | str | None]

class Stage(dict[str, Any]):
    """What is done, one stage after the other."""
    name: Attribute[str, str | None]
    integrator: Attribute[str, str | None]
    time_step: Attribute[Any, float | str | None]
    steps: Attribute[int, int | None]
    until: Attribute[StageUntil, Mapping[str, Any] | None]
    reverse: Attribute[bool, bool | None]
    temperature: Attribute[Any, float | str | None]
    total_energy: Attribute[Any, float | str | None]
    thermostat: Attribute[StageThermostat, str | Mapping[str, Any] | None]
    barostat: Attribute[StageBarostat, str | Mapping[str, Any] | None]
    sample: Attribute[bool, bool | None]
    start: Attribute[str, str | None]
    def __init__(self, name: str, steps: int | None = ..., *, integrator: str | None = ..., time_step: float | str | None = ...,
            until: Mapping[str, Any] | None = ..., reverse: bool | None = ..., temperature: float | str | None = ...,
            total_energy: float | str | None = ..., thermostat: str | Mapping[str, Any] | None = ..., barostat: str | Mapping[str, Any] | None = ...,
            sample: bool | None = ..., start: str | None = ...) -> None: ...

class OutputThermo(dict[str, Any]):
    """History of energies, thermo.csv."""
    every: Attribute[int, int | None]

class OutputTrajectory(dict[str, Any]):
    """Positions against time."""
    format: Attribute[str, str | None]
    every: Attribute[int, int | None]
    velocities: Attribute[bool, bool | None]
    forces: Attribute[bool, bool | None]
    energies: Attribute[bool, bool | None]
    units: Attribute[str, str | None]
    accelerations: Attribute[bool, bool | None]

class OutputCheckpoint(dict[str, Any]):
    """What `ljmd resume` continues from; also written at the start, at the ends of stages, and when the run is stopped."""
    every: Attribute[Any, int | str | None]
    keep: Attribute[int, int | None]

class Output(dict[str, Any]):
    """Files."""
    directory: Attribute[str, str | None]
    thermo: Attribute[OutputThermo, Mapping[str, Any] | None]
    trajectory: Attribute[OutputTrajectory, Mapping[str, Any] | None]
    checkpoint: Attribute[OutputCheckpoint, Mapping[str, Any] | None]
    report: Attribute[bool, bool | None]

class Analyses(dict[str, Any]):
    """What is measured in the sampled stages: deck.analysis.rdf(bins=200)."""
    def bulk_viscosity(self, *, every: int | None = ..., max_time: float | str | None = ...) -> None:
        """Bulk viscosity by Green and Kubo, written with the autocorrelation of the pressure to pressure_autocorrelation.csv; only at constant
        energy, and not with truncation = "cut"."""
    def chemical_potential(self, *, every: int | None = ..., insertions: int | None = ...) -> None:
        """Excess chemical potential by Widom's insertion of test particles."""
    def configurational_temperature(self, *, every: int | None = ...) -> None:
        """Temperature from forces and the curvature of the potential, without velocities."""
    def crystal(self, *, lattice: str | None = ..., cells: int | None = ..., layers: int | None = ..., families: int | None = ...,
            every: int | None = ...) -> None:
        """Displacements from the sites of a crystal that fills the box, Lindemann ratio, Bragg peaks and Debye-Waller factors, written to
        bragg.csv."""
    def cutoff_correction(self, *, radius: float | str | None = ..., every: int | None = ...) -> None:
        """What to add to energy and pressure for those of the potential without cutoff."""
    def film(self, *, axis: str | None = ..., layers: int | None = ..., every: int | None = ...) -> None:
        """Surface tension of a film of liquid in its vapour, with the profiles of density and pressure across the box, written to film.csv."""
    def msd(self, *, every: int | None = ..., max_time: float | str | None = ..., origins: int | None = ..., fit_start: float | str | None = ...,
            long_time: float | str | None = ...) -> None:
        """Mean-square displacement and diffusion by Einstein's relation, written to msd.csv."""
    def rdf(self, *, bins: int | None = ..., radius: float | str | None = ..., every: int | None = ...) -> None:
        """Radial distribution function g(r), written to rdf.csv, and the structure factor that follows from it, to sk_from_rdf.csv."""
    def response_functions(self, *, every: int | None = ...) -> None:
        """Compressibility, thermal expansion, c_p, speed of sound and others from fluctuations, in every ensemble."""
    def scattering(self, *, every: int | None = ..., max_time: float | str | None = ..., k_min: float | None = ..., k_max: float | None = ...,
            shells: int | None = ..., vectors: int | None = ..., origins: int | None = ..., long_time: float | str | None = ...) -> None:
        """Intermediate scattering functions F(k, t) and F_s(k, t), longitudinal and transverse currents, dynamic structure factor S(k, omega), sound,
        viscosity and diffusion at these wave numbers, written to fkt.csv, fskt.csv, skw.csv and modes.csv."""
    def structure_factor(self, *, k_max: float | None = ..., width: float | None = ..., method: str | None = ..., every: int | None = ...) -> None:
        """Structure factor S(k), written to sk.csv."""
    def thermal_conductivity(self, *, every: int | None = ..., max_time: float | str | None = ...) -> None:
        """Thermal conductivity by Green and Kubo, written with the autocorrelation of the heat flux to heat_flux_autocorrelation.csv; not with
        truncation = "cut"."""
    def vacf(self, *, every: int | None = ..., max_time: float | str | None = ..., long_time: float | str | None = ...) -> None:
        """Velocity autocorrelation, diffusion by Green and Kubo and vibrational spectrum, written to vacf.csv and vibrational_spectrum.csv."""
    def van_hove(self, *, every: int | None = ..., max_time: float | str | None = ..., origins: int | None = ..., times: int | None = ...,
            bins: int | None = ..., radius: float | str | None = ...) -> None:
        """Distribution of the displacements of single atoms, van Hove's G_s(r, t), written to gs.csv, and the non-Gaussian parameter alpha_2(t), to
        alpha2.csv."""
    def van_hove_distinct(self, *, every: int | None = ..., max_time: float | str | None = ..., between: float | str | None = ...,
            bins: int | None = ..., radius: float | str | None = ...) -> None:
        """Where other atoms are a time after an atom was at the origin, van Hove's G_d(r, t), written to gd.csv."""
    def viscosity(self, *, every: int | None = ..., max_time: float | str | None = ...) -> None:
        """Shear viscosity by Green and Kubo, written with the stress autocorrelation to stress_autocorrelation.csv."""
    def closest_approach(self) -> None:
        """The smallest distance between any two bodies, when, and which; fixed steps must resolve the encounter."""
    def orbit(self, *, body: int, about: int | None = ...) -> None:
        """Apsides of one body's path, with period and precession, and its orbital elements: orbit.csv."""
    def oscillation(self, *, body: int | None = ..., component: int | None = ...) -> None:
        """Passages of a coordinate through zero, with period and amplitude: oscillation.csv."""

class Force(dict[str, Any]):
    """The law of motion."""
    type: Attribute[str, str | None]
    angular_momentum: Attribute[float, float | None]
    central_mass: Attribute[float, float | None]
    gravitational_constant: Attribute[float, float | None]
    gravitational_parameter: Attribute[float, float | None]
    gravity: Attribute[float, float | None]
    length: Attribute[float, float | None]
    softening: Attribute[float, float | None]
    stiffness: Attribute[float, float | None]

class Body(dict[str, Any]):
    """The bodies, counted from 1; `--set body.2.mass=0.5` changes the second."""
    mass: Attribute[float, float | None]
    position: Attribute[list[float], Iterable[float] | None]
    velocity: Attribute[list[float], Iterable[float] | None]

class PotentialTable(TypedDict, total=False):
    """Forces, in reduced units."""
    type: str
    cutoff: float
    truncation: str
    tail: bool
    minimum: float
    steepness: float
    well_depth: float
    switch_start: float

class TrajectoryAnalyses:
    """Analyses of the frames of a file."""
    def bulk_viscosity(self, *, every: int | None = ..., max_time: float | str | None = ...) -> Results:
        """Bulk viscosity by Green and Kubo, written with the autocorrelation of the pressure to pressure_autocorrelation.csv; only at constant
        energy, and not with truncation = "cut"."""
    def chemical_potential(self, *, every: int | None = ..., insertions: int | None = ...) -> Results:
        """Excess chemical potential by Widom's insertion of test particles."""
    def configurational_temperature(self, *, every: int | None = ...) -> Results:
        """Temperature from forces and the curvature of the potential, without velocities."""
    def crystal(self, *, lattice: str | None = ..., cells: int | None = ..., layers: int | None = ..., families: int | None = ...,
            every: int | None = ...) -> Results:
        """Displacements from the sites of a crystal that fills the box, Lindemann ratio, Bragg peaks and Debye-Waller factors, written to
        bragg.csv."""
    def cutoff_correction(self, *, radius: float | str | None = ..., every: int | None = ...) -> Results:
        """What to add to energy and pressure for those of the potential without cutoff."""
    def film(self, *, axis: str | None = ..., layers: int | None = ..., every: int | None = ...) -> Results:
        """Surface tension of a film of liquid in its vapour, with the profiles of density and pressure across the box, written to film.csv."""
    def msd(self, *, every: int | None = ..., max_time: float | str | None = ..., origins: int | None = ..., fit_start: float | str | None = ...,
            long_time: float | str | None = ...) -> Results:
        """Mean-square displacement and diffusion by Einstein's relation, written to msd.csv."""
    def rdf(self, *, bins: int | None = ..., radius: float | str | None = ..., every: int | None = ...) -> Results:
        """Radial distribution function g(r), written to rdf.csv, and the structure factor that follows from it, to sk_from_rdf.csv."""
    def response_functions(self, *, every: int | None = ...) -> Results:
        """Compressibility, thermal expansion, c_p, speed of sound and others from fluctuations, in every ensemble."""
    def scattering(self, *, every: int | None = ..., max_time: float | str | None = ..., k_min: float | None = ..., k_max: float | None = ...,
            shells: int | None = ..., vectors: int | None = ..., origins: int | None = ..., long_time: float | str | None = ...) -> Results:
        """Intermediate scattering functions F(k, t) and F_s(k, t), longitudinal and transverse currents, dynamic structure factor S(k, omega), sound,
        viscosity and diffusion at these wave numbers, written to fkt.csv, fskt.csv, skw.csv and modes.csv."""
    def structure_factor(self, *, k_max: float | None = ..., width: float | None = ..., method: str | None = ..., every: int | None = ...) -> Results:
        """Structure factor S(k), written to sk.csv."""
    def thermal_conductivity(self, *, every: int | None = ..., max_time: float | str | None = ...) -> Results:
        """Thermal conductivity by Green and Kubo, written with the autocorrelation of the heat flux to heat_flux_autocorrelation.csv; not with
        truncation = "cut"."""
    def vacf(self, *, every: int | None = ..., max_time: float | str | None = ..., long_time: float | str | None = ...) -> Results:
        """Velocity autocorrelation, diffusion by Green and Kubo and vibrational spectrum, written to vacf.csv and vibrational_spectrum.csv."""
    def van_hove(self, *, every: int | None = ..., max_time: float | str | None = ..., origins: int | None = ..., times: int | None = ...,
            bins: int | None = ..., radius: float | str | None = ...) -> Results:
        """Distribution of the displacements of single atoms, van Hove's G_s(r, t), written to gs.csv, and the non-Gaussian parameter alpha_2(t), to
        alpha2.csv."""
    def van_hove_distinct(self, *, every: int | None = ..., max_time: float | str | None = ..., between: float | str | None = ...,
            bins: int | None = ..., radius: float | str | None = ...) -> Results:
        """Where other atoms are a time after an atom was at the origin, van Hove's G_d(r, t), written to gd.csv."""
    def viscosity(self, *, every: int | None = ..., max_time: float | str | None = ...) -> Results:
        """Shear viscosity by Green and Kubo, written with the stress autocorrelation to stress_autocorrelation.csv."""
