"""The systems whose cost scaling.py compares: sizes, densities, cutoffs, small boxes, shapes and potentials.

All are fcc crystals at the melt's temperature. `neighbours` is the number of atoms that the list of an atom holds, if
they are spread evenly over the part of the box that has any: what cost should follow, whatever the rest.
"""

from __future__ import annotations

from dataclasses import dataclass
from pathlib import Path
from typing import Any, Optional

import numpy as np
import roofline
import workload
from ljmd_program import MELT_POTENTIAL, from_file
from workload import Configuration

# Cubic cells along an edge: 864 atoms to 10 million, each about three times the last.
SIZES = (6, 9, 14, 20, 29, 43, 63, 93, 136)
DENSITIES = (0.01, 0.03, 0.1, 0.2, 0.4, 0.6, workload.DENSITY, 1.0)
CUTOFFS = (1.12, 1.5, 2.0, 2.5, 3.0, 4.0, 5.0)
SMALL = (3, 4, 5, 6)
CUBE = 20  # cells along an edge where the size is not what varies: 32000 atoms
LEAST_EDGE = 2.02  # cutoffs, of the small boxes

FAMILIES = ("size", "density", "cutoff", "small box", "shape", "potential")

# Name, lines of [potential], cutoff. The last but one has the minimum and the curvature there of Lennard-Jones.
POTENTIALS = (
    ("Lennard-Jones, cut", MELT_POTENTIAL, workload.CUTOFF),
    ("Lennard-Jones, shifted", 'type = "lennard-jones"\ntruncation = "shifted"', workload.CUTOFF),
    ("Lennard-Jones, force-shifted", 'type = "lennard-jones"\ntruncation = "force-shifted"', workload.CUTOFF),
    ("Lennard-Jones, switched from 2",
     'type = "lennard-jones"\ntruncation = "switched"\nswitch_start = 2.0\ntail = false', workload.CUTOFF),
    ("Morse, force-shifted",
     'type = "morse"\nwell_depth = 1.0\nsteepness = 6.0\nminimum = 1.122462048309373\ntruncation = "force-shifted"',
     workload.CUTOFF),
    ("Weeks-Chandler-Andersen", 'type = "lennard-jones"\ntruncation = "shifted"', 1.122462048309373),
)


@dataclass(frozen=True)
class System:
    """One point of a family. `x` is what varies in it; the box is `stretch` times as long as the crystal in it."""

    family: str
    label: str
    x: float
    cells: tuple[int, int, int]
    density: float = workload.DENSITY
    cutoff: float = workload.CUTOFF
    stretch: tuple[int, int, int] = (1, 1, 1)
    potential: str = MELT_POTENTIAL

    @property
    def atoms(self) -> int:
        return 4 * int(np.prod(self.cells))

    @property
    def neighbours(self) -> float:
        return roofline.neighbours(self.density, self.cutoff + workload.SKIN)

    def configuration(self) -> Configuration:
        positions, edges = workload.fcc(self.cells, self.density)
        velocities = workload.maxwell(self.atoms, workload.TEMPERATURE)
        return Configuration(positions, velocities, edges * np.array(self.stretch))

    def section(self, folder: Path) -> str:
        """The lines of [system]: a lattice of ljmd's own where it can make it, else a file that is written here."""
        if self.stretch == (1, 1, 1) and len(set(self.cells)) == 1:
            return (f'lattice = {{ type = "fcc", cells = {self.cells[0]} }}\ndensity = {self.density!r}\n'
                    f"temperature = {workload.TEMPERATURE!r}\nseed = {workload.SEED}")
        path = folder / f"{self.label.replace(' ', '-').replace(':', '-')}.data"
        workload.write_lammps_data(self.configuration(), path)
        return from_file(path)


def cube(family: str, label: str, x: float, cells: int, **more: Any) -> System:
    return System(family, label, x, (cells, cells, cells), **more)


def small_box(cells: int) -> System:
    """A cube whose edge is just above two cutoffs."""
    edge = cells * (4 / workload.DENSITY) ** (1.0 / 3.0)
    cutoff = edge / LEAST_EDGE
    return cube("small box", f"{4 * cells**3} atoms, L = {LEAST_EDGE} rc", cutoff, cells, cutoff=cutoff)


def systems(largest: Optional[int] = None) -> list[System]:
    """All systems, those of the family `size` up to `largest` atoms."""
    found = [cube("size", f"{4 * cells**3} atoms", 4 * cells**3, cells) for cells in SIZES]
    found = [system for system in found if largest is None or system.atoms <= largest]
    found += [cube("density", f"density {density}", density, CUBE, density=density) for density in DENSITIES]
    found += [cube("cutoff", f"cutoff {cutoff}", cutoff, CUBE, cutoff=cutoff) for cutoff in CUTOFFS]
    found += [small_box(cells) for cells in SMALL]
    full = (CUBE, CUBE, CUBE)
    shapes = [
        ("cube", full, (1, 1, 1)),
        ("box 1:1:20", (7, 7, 140), (1, 1, 1)),
        ("box 20:1:1", (140, 7, 7), (1, 1, 1)),
        ("half empty along z", full, (1, 1, 2)),
        ("half empty along x", full, (2, 1, 1)),
        ("an eighth filled", full, (2, 2, 2)),
    ]
    found += [System("shape", label, k, cells, stretch=stretch) for k, (label, cells, stretch) in enumerate(shapes)]
    found += [cube("potential", label, k, CUBE, cutoff=cutoff, potential=lines)
              for k, (label, lines, cutoff) in enumerate(POTENTIALS)]
    return found
