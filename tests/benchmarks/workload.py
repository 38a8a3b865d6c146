"""The work that is timed, and the files from which all programs start it.

The Lennard-Jones melt of LAMMPS (bench/in.lj, https://www.lammps.org/bench.html#lj): an fcc crystal at density 0.8442
and temperature 1.44 that melts; plain cutoff at 2.5 without tail, neighbours listed within 2.8, velocity Verlet with
time step 0.005 at constant energy, thermodynamics every 100 steps. All in reduced units, sigma = epsilon = m = k_B = 1.

Two policies say when lists of neighbours are made anew: `fixed`, every 20 steps without asking whether that is often
enough, as bench/in.lj does; `strict`, as soon as an atom may have come in from beyond the list.

Positions and velocities are made once, here, and written with as many digits as read back to the same double.
"""

from __future__ import annotations

from dataclasses import dataclass
from pathlib import Path
from typing import Callable, Iterable

import numpy as np

DENSITY = 0.8442  # sigma^-3
TEMPERATURE = 1.44  # epsilon/k_B
CUTOFF = 2.5  # sigma
SKIN = 0.3  # sigma
TIME_STEP = 0.005  # tau
REBUILD_EVERY = 20  # steps, of the fixed policy
THERMO_EVERY = 100  # steps
SEED = 87287

POLICIES = ("fixed", "strict")
SIZES = (864, 4000, 32000, 256000, 2048000)  # 4 * 6^3 ... 4 * 80^3

NOMINAL_RATE = 5e6  # atom-steps a second and core, from which numbers of steps are chosen
FEWEST_STEPS = 40
LINES = 100_000  # atoms formatted at a time: bounds the memory that text takes

FCC = np.array([[0.0, 0.0, 0.0], [0.5, 0.5, 0.0], [0.5, 0.0, 0.5], [0.0, 0.5, 0.5]])


@dataclass(frozen=True)
class Configuration:
    """Where atoms are (N, 3), how they move (N, 3), and the edges of their periodic box (3)."""

    positions: np.ndarray
    velocities: np.ndarray
    edges: np.ndarray

    @property
    def atoms(self) -> int:
        return len(self.positions)


def fcc(cells: Iterable[int], density: float) -> tuple[np.ndarray, np.ndarray]:
    """Positions of a face-centred cubic crystal, from the origin, and the edges of its box.

    `cells`: cubic cells of four atoms along each axis."""
    counts = np.array(list(cells))
    edge = (len(FCC) / density) ** (1.0 / 3.0)
    corners = np.stack(np.meshgrid(*map(np.arange, counts), indexing="ij"), axis=-1).reshape(-1, 1, 3)
    return ((corners + FCC) * edge).reshape(-1, 3), counts * edge


def maxwell(atoms: int, temperature: float, seed: int = SEED) -> np.ndarray:
    """Velocities from Maxwell's distribution, with zero momentum and exactly this temperature.

    The temperature is that of 3 (N - 1) degrees of freedom: T = sum v^2 / (3 (N - 1)). There must be two atoms or more.
    """
    velocities = np.random.default_rng(seed).standard_normal((atoms, 3))
    velocities -= velocities.mean(axis=0)
    return velocities * np.sqrt(3 * (atoms - 1) * temperature / (velocities**2).sum())


def cells_of(atoms: int) -> int:
    """The n of N = 4 n^3. Raises ValueError for other N, and below 108, whose box is smaller than two cutoffs."""
    cells = round((atoms / 4) ** (1.0 / 3.0))
    if 4 * cells**3 != atoms or cells < 3:
        raise ValueError(f"{atoms} atoms: sizes are 4 n^3 with n above 2, such as {', '.join(map(str, SIZES))}")
    return cells


def melt(atoms: int) -> Configuration:
    """The start of the melt in a cube. Raises ValueError as `cells_of` does."""
    positions, edges = fcc([cells_of(atoms)] * 3, DENSITY)
    return Configuration(positions, maxwell(atoms, TEMPERATURE), edges)


def steps_for(atoms: int, seconds: float) -> int:
    """Steps that take about `seconds` at NOMINAL_RATE: whole periods of thermodynamics or, if few, of lists."""
    steps = seconds * NOMINAL_RATE / atoms
    period = THERMO_EVERY if steps >= THERMO_EVERY else REBUILD_EVERY
    return max(FEWEST_STEPS, round(steps / period) * period)


def write_lammps_data(configuration: Configuration, path: Path) -> None:
    """A data file of LAMMPS in atom style atomic, which ljmd reads, too."""
    with path.open("w") as file:
        file.write(f"Lennard-Jones fluid, units = lj\n\n{configuration.atoms} atoms\n1 atom types\n\n")
        for axis, edge in zip("xyz", configuration.edges.tolist()):
            file.write(f"0.0 {edge!r} {axis}lo {axis}hi\n")
        file.write("\nMasses\n\n1 1.0\n\nAtoms # atomic\n\n")
        write_rows(file.write, configuration.positions, "%d 1 %r %r %r\n")
        file.write("\nVelocities\n\n")
        write_rows(file.write, configuration.velocities, "%d %r %r %r\n")


def write_rows(write: Callable[[str], object], vectors: np.ndarray, row: str) -> None:
    for first in range(0, len(vectors), LINES):
        block = vectors[first : first + LINES].tolist()
        write("".join([row % (number, *vector) for number, vector in enumerate(block, first + 1)]))


def write_gro(configuration: Configuration, path: Path) -> None:
    """A .gro file of GROMACS with nine decimals, finer than the single precision that GROMACS keeps of them.

    Lengths are in nm, velocities in nm/ps: with sigma = 1 nm, epsilon = 1 kJ/mol and m = 1 u, GROMACS' units are the
    reduced ones, as 1 u nm^2/ps^2 is 1 kJ/mol. Numbers of atoms have five digits and start again at 0.
    """
    row = "%5dLJ      LJ%5d" + 3 * "%14.9f" + 3 * "%14.10f" + "\n"
    with path.open("w") as file:
        file.write(f"Lennard-Jones fluid\n{configuration.atoms}\n")
        for first in range(0, configuration.atoms, LINES):
            block = np.hstack((configuration.positions[first : first + LINES],
                               configuration.velocities[first : first + LINES])).tolist()
            lines = [row % (k % 100000, k % 100000, *values) for k, values in enumerate(block, first + 1)]
            file.write("".join(lines))
        file.write("%.9f %.9f %.9f\n" % tuple(configuration.edges))


def write_numpy(configuration: Configuration, path: Path) -> None:
    """The three arrays in numpy's .npz, for programs that are Python modules."""
    np.savez(path, positions=configuration.positions, velocities=configuration.velocities, edges=configuration.edges)


@dataclass(frozen=True)
class Case:
    """One start and policy, and the folder where programs keep their files of it."""

    configuration: Configuration
    policy: str
    folder: Path

    @property
    def atoms(self) -> int:
        return self.configuration.atoms

    def file(self, name: str, write: Callable[[Configuration, Path], None]) -> Path:
        """The start as a file in `folder`; written by whoever first asks for it."""
        path = self.folder / name
        if not path.exists():
            write(self.configuration, path)
        return path
