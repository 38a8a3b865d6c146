"""A model of the time of a step of many ranks, on paper. A step of a rank takes

    T = c n + [m L + 32 g/B - c i/2] + [k L + 24 f/B - c i/2] + 2 L log2 P,    [x] = max(x, 0)

for n atoms, g ghosts of m other ranks, and forces on f atoms of k other ranks (an atom counts once for each tile that
has found one). c, the seconds for an atom, is measured; L, the latency of a message, and B, the bandwidth of a rank, are
assumed (LATENCY, BANDWIDTH). Messages wait for each other. Half of the i atoms in tiles without ghosts of other ranks
are computed while positions are on their way, with 32 bytes for each ghost, and half while forces are, with 24. Two
numbers are agreed on: whether the list is still good, and whether a checkpoint is due. n, i, g, m, f and k are those of
the program's own grid (the program `decomposition`), for the rank of those asked whose step takes longest: a run waits
for it.
"""

from __future__ import annotations

import json
import math
import os
import subprocess
from pathlib import Path
from typing import Any, Iterable

import workload
from programs import ProgramFailed

LATENCY = 1.5e-6  # seconds, of a message between computers on InfiniBand or the like
BANDWIDTH = 2e9  # bytes/s of a rank, when all ranks of a computer share its link
BYTES_OF_POSITION = 32
BYTES_OF_FORCE = 24
RANKS = (1, 2, 4, 8, 16, 32, 64, 128, 256, 512, 1024, 4096, 10_000, 30_000, 100_000)
SIZES = (1_000_000, 100_000_000)  # atoms of runs that are shared by ever more ranks


def counted(program: Path, atoms: int, ranks: Iterable[int], *options: str) -> list[dict[str, Any]]:
    """Decompositions that give a rank a tile at least. `options`: --messages for the messages of all ranks."""
    words = [atoms, workload.DENSITY, workload.CUTOFF, workload.SKIN, *ranks]
    # glibc keeps what a grid has freed for the next one: a quarter of the time with 1e8 atoms.
    keeping = {**os.environ, "MALLOC_MMAP_THRESHOLD_": str(1 << 32), "MALLOC_TRIM_THRESHOLD_": str(1 << 32)}
    done = subprocess.run([str(program), *options, *map(str, words)], capture_output=True, text=True, check=False, env=keeping)
    if done.returncode != 0:
        raise ProgramFailed(f"{program.name}: exit code {done.returncode}: {done.stderr.strip()}")
    return [one for one in map(json.loads, done.stdout.splitlines()) if one["tiles"] >= one["ranks"]]


def seconds(rank: dict[str, float], ranks: int, cost: float) -> dict[str, float]:
    """The terms of the model."""
    hidden = 0.5 * cost * rank["inner"]
    positions = rank["messages"] * LATENCY + BYTES_OF_POSITION * rank["ghosts"] / BANDWIDTH
    forces = rank["force_messages"] * LATENCY + BYTES_OF_FORCE * rank["forces"] / BANDWIDTH
    return {"computing": cost * rank["atoms"], "positions": max(0.0, positions - hidden), "forces": max(0.0, forces - hidden),
            "decisions": 2 * LATENCY * math.log2(ranks)}


def modelled(decomposition: dict[str, Any], cost: float) -> dict[str, Any]:
    """The slowest rank, and which part of the ideal rate it leaves."""
    ranks = decomposition["ranks"]
    slowest = max(decomposition["asked"], key=lambda rank: sum(seconds(rank, ranks, cost).values()))
    terms = seconds(slowest, ranks, cost)
    return {"atoms": decomposition["atoms"], "ranks": ranks, "slowest": {key: slowest[key] for key in slowest if key != "parts"},
            "terms": terms, "efficiency": cost * decomposition["atoms"] / ranks / sum(terms.values())}
