"""How far the pair sum is from what one thread of the machine can do: peaks, useful operations, and bytes moved.

Operations: FLOPS_PER_PAIR for each pair within the cutoff, counted once. Full lists compute each pair twice; the second
time is not counted as useful.

Bytes are not measured but estimated, for an atom and a step of a program with full lists:
- list: (4/3) pi (rc + skin)^3 rho indices of four bytes;
- arrays: eight vectors move, at least. The pair sum reads positions and writes forces (2); velocity Verlet reads forces
  twice and reads and writes velocities twice (6 vectors) as it reads and writes positions once (2): ten in all;
- gathers: for each index of the list the position of that neighbour.
From memory come list and arrays, when they do not fit into a cache. From the second-level cache come, at most, list,
arrays and gathers: many gathers hit the first level, as neighbours of neighbours are neighbours.
"""

from __future__ import annotations

import json
import math
import shutil
import tempfile
from pathlib import Path
from typing import Any, Optional

import workload
from programs import ProgramFailed, execute

SOURCE = Path(__file__).resolve().with_name("peaks.cpp")
COMPILER = "g++"
FLAGS = ("-std=c++20", "-O3", "-march=native")

# separation 3, its square 5, reciprocal 1, sixth power 2, force over distance 4, its components 3, adding these to both
# atoms 6, energy 3
FLOPS_PER_PAIR = 27
INDEX_BYTES = 4
VECTORS_PER_STEP = 10
REAL_BYTES = {"double": 8, "mixed": 4}


def peaks() -> Optional[dict[str, Any]]:
    """Compile and run peaks.cpp; None without a compiler. Raises ProgramFailed when that goes wrong."""
    if not shutil.which(COMPILER):
        return None
    with tempfile.TemporaryDirectory() as folder:
        execute([COMPILER, *FLAGS, SOURCE, "-o", "peaks"], Path(folder))
        return {"compiler": execute([COMPILER, "--version"], Path(folder)).splitlines()[0], "flags": " ".join(FLAGS),
                **json.loads(execute([Path(folder) / "peaks"], Path(folder)))}


def neighbours(density: float, radius: float) -> float:
    """Mean number of atoms within `radius` of an atom, if atoms were spread evenly."""
    return 4.0 / 3.0 * math.pi * radius**3 * density


def useful_flops(density: float = workload.DENSITY, cutoff: float = workload.CUTOFF) -> float:
    """Useful operations for an atom and a step: 27 for each of 27.6 half pairs in the melt."""
    return FLOPS_PER_PAIR * neighbours(density, cutoff) / 2.0


def traffic(precision: str) -> dict[str, float]:
    """Estimated bytes for an atom and a step of the melt, from memory and from the second-level cache."""
    listed = neighbours(workload.DENSITY, workload.CUTOFF + workload.SKIN)
    vector = 3 * REAL_BYTES[precision]
    streamed = INDEX_BYTES * listed + VECTORS_PER_STEP * vector
    return {"memory": streamed, "l2": streamed + listed * vector}
