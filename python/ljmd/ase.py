"""ljmd and ASE: a calculator, and conversion of atoms in both directions. Import it as `ljmd.ase`; it imports ASE.

    import ase.build, ljmd.ase
    sigma, epsilon, mass = ljmd.ase.units(ljmd.ARGON)                        # angstrom, eV, u
    atoms = ase.build.bulk("Ar", "fcc", a=5.3, cubic=True).repeat(6)
    atoms.calc = ljmd.ase.Calculator(sigma=sigma, epsilon=epsilon, cutoff=8.5)
    atoms.get_potential_energy(), atoms.get_forces(), atoms.get_stress()

ASE has angstrom, eV and u; `sigma`, `epsilon` and `mass` say what one reduced unit of length, energy and mass is there. With 1
for each, atoms are in reduced units.
"""

from __future__ import annotations

from typing import Any

import numpy as np
from ase import Atoms
from ase.calculators.calculator import Calculator as _AseCalculator
from ase.calculators.calculator import all_changes
from ase.data import atomic_numbers

from . import _check, _core, _output
from .deck import Deck
from .errors import DataError, InputError
from .evaluation import Evaluator, edges_of
from .potentials import Pair
from .runs import Run
from .simulation import Simulation
from .tables import ARGON, Stage
from .trajectories import Trajectory

_MARK = "creator=ljmd"  # in the comment of files of to_deck()


def units(substance: dict = ARGON) -> tuple:
    """sigma [angstrom], epsilon [eV] and mass [u] of a substance as decks have it. Raises InputError for a wrong one."""
    deck = Deck.fluid(32, 0.1, 1.0, substance=substance, cutoff=1.0)
    deck.stages = [Stage("none", 0)]
    found = _core.substance(deck._loaded())
    if found is None:
        raise InputError("a substance is a table with sigma, epsilon and mass")
    return found


def _require_atoms(atoms) -> None:
    if not isinstance(atoms, Atoms):
        raise InputError(f"atoms: {_check.shown(atoms)} are no ase.Atoms")


def _edges(atoms) -> np.ndarray:
    """Edges of the box [angstrom]. Raises InputError for atoms that ljmd cannot move."""
    _require_atoms(atoms)
    if len(atoms) == 0:
        raise InputError("there are no atoms")
    kinds = sorted(set(atoms.get_chemical_symbols()))
    if len(kinds) > 1:
        raise InputError(f"the atoms are of several kinds, {', '.join(kinds)}: ljmd has one kind of atom")
    if not all(atoms.pbc):
        raise InputError(f"pbc is {tuple(bool(p) for p in atoms.pbc)}: ljmd's boxes are periodic in all three directions; set "
                         "atoms.pbc = True")
    cell = np.asarray(atoms.cell)
    edges = np.diag(cell)
    rounding = 1e-12 * edges.min()  # as readers of files have it
    if not (edges > 0).all() or abs(cell - np.diag(edges)).max() > rounding:
        raise InputError(f"the cell {cell.tolist()} is not orthorhombic: ljmd has boxes with edges along x, y and z")
    return edges


class Calculator(_AseCalculator):
    """Pair forces of ljmd for ASE: energy, energies, free_energy, forces, stress of one kind of atom in a periodic orthorhombic cell.

    sigma: [angstrom]
    epsilon: [eV]
    cutoff: [angstrom]; 3 sigma by default, as ASE's LennardJones; at most half the shortest edge of the cell
    truncation: "shifted" as ASE's LennardJones, "cut", "force-shifted" or "switched" (with switch_start [angstrom])
    tail: whether energy and stress are corrected for what the truncation removes, with g(r) = 1; for "cut" and "switched"
    potential: one of `ljmd.build()["potentials"]`, with its parameters in reduced units; or an `ljmd.Pair`, which brings its
        cutoff and truncation, in reduced units
    threads, simd, precision: as in `Deck.run`

    With sigma = epsilon = 1, the first forces are those of a run of ljmd from the same positions, to the last bit; later ones
    differ by rounding, because the neighbour list is kept. The stress has ASE's sign and order (xx, yy, zz, yz, xz, xy):

        stress_ab = (dU/d strain_ab)/V = -W_ab/V,  W_ab = sum over pairs of r_a f_b

    The energies of the atoms are half of those of their pairs, without tail. They are computed only where they are asked for.
    The tail adds -p_tail to its diagonal, which corrects towards the pressure of the full potential (docs/physics.md). Atoms that
    ljmd cannot move (several kinds, a tilted cell, open boundaries, a cell below two cutoffs) are an InputError.
    """

    implemented_properties = ["energy", "energies", "free_energy", "forces", "stress"]
    default_parameters: dict = {"sigma": 1.0, "epsilon": 1.0, "cutoff": None, "truncation": "shifted", "switch_start": None,
                          "tail": False, "potential": "lennard-jones", "parameters_of_potential": {}, "threads": None,
                          "simd": None, "precision": "double"}
    nolabel = True
    _evaluator: Evaluator | None = None

    def __init__(self, sigma: float = 1.0, epsilon: float = 1.0, cutoff: float | None = None, truncation: str = "shifted", *,
                 switch_start: float | None = None, tail: bool = False, potential="lennard-jones",
                 threads: int | None = None, simd: str | None = None, precision: str = "double", atoms=None, **parameters):
        if atoms is not None:
            _require_atoms(atoms)
        super().__init__(atoms=atoms, sigma=sigma, epsilon=epsilon, cutoff=cutoff, truncation=truncation,
                         switch_start=switch_start, tail=tail, potential=potential, threads=threads, simd=simd,
                         precision=precision, parameters_of_potential=parameters)

    @staticmethod
    def _made(p) -> Evaluator:
        sigma = _check.positive(p["sigma"], "sigma")
        _check.positive(p["epsilon"], "epsilon")
        options = {key: p[key] for key in ("threads", "simd", "precision")}
        if isinstance(p["potential"], Pair):
            if p["cutoff"] is not None or p["parameters_of_potential"]:
                raise InputError("an ljmd.Pair brings its own cutoff, truncation and parameters")
            return Evaluator(p["potential"], **options)
        cutoff = 3 * sigma if p["cutoff"] is None else _check.positive(p["cutoff"], "cutoff")
        table: Any = {"type": p["potential"], "truncation": p["truncation"], "tail": p["tail"], "cutoff": cutoff / sigma,
                      **_check.table(p["parameters_of_potential"], "parameters_of_potential")}
        if p["switch_start"] is not None:
            table["switch_start"] = _check.positive(p["switch_start"], "switch_start") / sigma
        return Evaluator(table, **options)

    def set(self, **changes):
        """Change parameters, and forget results."""
        unknown = set(changes) - set(self.default_parameters)
        if unknown:
            raise InputError(f"no parameter {', '.join(sorted(unknown))}; there are {', '.join(self.default_parameters)}")
        evaluator = self._made({**self.parameters, **changes})  # before ASE compares values, which takes those of any kind
        changed = super().set(**changes)
        if changed or self._evaluator is None:
            self.reset()
            self._evaluator = evaluator
        return changed

    def calculate(self, atoms=None, properties=None, system_changes=all_changes):
        """Called by ASE. Raises InputError for atoms that ljmd cannot move."""
        super().calculate(atoms, properties or self.implemented_properties, system_changes)
        sigma, epsilon = float(self.parameters["sigma"]), float(self.parameters["epsilon"])
        edges = _edges(self.atoms)
        wants_energies = properties is not None and "energies" in properties
        found = self._evaluator(self.atoms.positions / sigma, edges / sigma, energies=wants_energies)
        volume = np.prod(edges) / sigma**3
        tail = found.virial_pressure - found.virial / (3 * volume)
        stress = -found.virial_tensor / volume - (tail * np.eye(3) if self.parameters["tail"] else 0.0)
        energy = epsilon * len(self.atoms) * found.potential_energy
        stress *= epsilon / sigma**3
        self.results = {"energy": energy, "free_energy": energy, "forces": found.forces * (epsilon / sigma),
                        "stress": stress[[0, 1, 2, 1, 0, 0], [0, 1, 2, 2, 2, 1]]}
        if wants_energies:
            self.results["energies"] = epsilon * found.energies


def _atoms_of(positions, velocities, edges, masses, sigma, epsilon, mass, symbol, info) -> Atoms:
    if _check.text(symbol, "symbol") not in atomic_numbers:
        raise InputError(f"symbol: {_check.shown(symbol)} is that of no element")
    atoms = Atoms([symbol] * len(positions), positions=positions * sigma, cell=np.asarray(edges) * sigma, pbc=True, info=info)
    atoms.set_masses(masses * mass)
    if velocities is not None:
        atoms.set_velocities(velocities * np.sqrt(epsilon / mass))
    return atoms


def to_atoms(what, *, frame: int = -1, sigma: float = 1.0, epsilon: float = 1.0, mass: float = 1.0, symbol: str = "X") -> Atoms:
    """ASE atoms with positions, velocities, masses and cell, by id.

    what: an `ljmd.Simulation`, the snapshot of an observable, an `ljmd.Run` with a directory (its last configuration), or an
        `ljmd.Trajectory`
    frame: of a trajectory
    sigma, epsilon, mass: one reduced unit in angstrom, eV and u, see `units`; 1 leaves numbers as they are
    symbol: of the atoms

    Positions are unwrapped where they are known so; a trajectory's are those of its file. `atoms.info` has the time [tau] where it
    is known. Raises InputError for few bodies, which have no box, and DataError for a run in memory, which keeps no configuration.
    """
    sigma, epsilon, mass = _check.positive(sigma, "sigma"), _check.positive(epsilon, "epsilon"), _check.positive(mass, "mass")
    frame = _check.whole(frame, "frame", -(2**63))
    velocities: Any
    time: float | None
    if isinstance(what, Run):
        if what.directory is None:
            raise DataError("a run in memory keeps no configuration: take it from its ljmd.Simulation")
        positions, velocities, edges, time = _core.last_configuration(what.directory)
    elif isinstance(what, Trajectory):
        arrays = what.arrays()
        frame = _check.whole(frame, "frame", -len(arrays), len(arrays) - 1)
        positions, edges = arrays.positions[frame], arrays.edges[frame]
        velocities = None if arrays.velocities is None else arrays.velocities[frame]
        time = None if arrays.times is None else float(arrays.times[frame])
    elif isinstance(what, (Simulation, _core.Snapshot)):
        if what.edges is None:
            raise InputError("few bodies have no box: they are no atoms of a fluid")
        positions, velocities, edges, time = what.unwrapped, what.velocities, what.edges, what.time
    else:
        raise InputError(f"what: a simulation, a snapshot, a run or a trajectory is needed, found {type(what).__name__}")
    info = {} if time is None else {"time": time}
    return _atoms_of(positions, velocities, edges, np.ones(len(positions)), sigma, epsilon, mass, symbol, info)


def to_deck(atoms, file, *, sigma: float = 1.0, epsilon: float = 1.0, cutoff: float | None = None, truncation: str = "shifted",
            temperature: float | None = None, force: bool = False, **options) -> Deck:
    """A deck that starts from ASE atoms: their positions, cell and velocities, in reduced units.

    file: extended XYZ that is written, and that the deck then starts from; another run may be in memory, or have a directory. One
        that was written so before is replaced
    force: replace any other file, too; a link is replaced itself, never what it leads to
    sigma, epsilon: one reduced unit in angstrom and eV
    cutoff: [angstrom]; 3 sigma by default
    temperature: [epsilon/k_B]; from the velocities by default. Atoms at rest have their velocities drawn at this temperature
    options: as in `Deck.fluid`, in reduced units (switch_start, tail, seed, title, ...)

    The mass of the atoms is the unit of mass. The motion of the centre of mass is removed when a run begins. Raises InputError
    as the calculator, and for atoms of several masses.
    """
    sigma, epsilon = _check.positive(sigma, "sigma"), _check.positive(epsilon, "epsilon")
    edges = edges_of(_edges(atoms) / sigma)
    masses = atoms.get_masses()
    if not (masses == masses[0]).all() or not masses[0] > 0:
        raise InputError("the atoms have several masses, or none: in ljmd all atoms have one mass")
    velocities = atoms.get_velocities() * np.sqrt(masses[0] / epsilon)
    moving = bool(velocities.any())
    if not moving and temperature is None:
        raise InputError("the atoms are at rest: give a temperature, at which velocities are drawn")
    deck = Deck.fluid(file=_written(file, atoms.positions / sigma, velocities if moving else None, edges, force),
                      temperature=temperature, truncation=truncation,  # type: ignore[arg-type]
                      cutoff=3.0 if cutoff is None else _check.positive(cutoff, "cutoff") / sigma, **options)
    if temperature is None:
        del deck.system["temperature"]
    return deck


def _written(file, positions, velocities, edges, force) -> str:
    """Write a configuration as extended XYZ in reduced units, with all digits. Returns its path."""
    if not np.isfinite(positions).all() or (velocities is not None and not np.isfinite(velocities).all()):
        raise InputError("positions and velocities must be finite")
    path = _check.directory_of(file, "file")
    columns = "species:S:1:pos:R:3" + ("" if velocities is None else ":velo:R:3") + ":id:I:1"
    lines = [str(len(positions)),
             f'Lattice="{edges[0]!r} 0 0 0 {edges[1]!r} 0 0 0 {edges[2]!r}" Properties={columns} pbc="T T T" units=reduced {_MARK}']
    numbers = positions if velocities is None else np.hstack([positions, velocities])
    lines += [f"X {' '.join(map(repr, row))} {k + 1}" for k, row in enumerate(numbers.tolist())]
    _output.write_text(path, "\n".join(lines) + "\n", force=_check.truth(force, "force"), mark=_MARK.encode())
    return str(path)
