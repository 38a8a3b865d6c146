"""A cold crystal beside its normal modes, which this script computes from the Lennard-Jones formula alone.

Usage: harmonic_crystal.py --ljmd PROGRAM [--seeds N]

N atoms in a periodic box have 3 N - 3 modes of eigenvalue s = omega^2 about the sites (masses are 1). In the harmonic crystal of
classical mechanics

    <u^2> = (T/N) sum over modes of 1/s,   exp(-2 W) = exp(-G^2 <u^2>/3)   (cubic symmetry)

Born and Huang (1954), Dynamical Theory of Crystal Lattices; Ashcroft and Mermin (1976), chapters 22 and appendix N. The forces are
those of the potential cut at 2.4 sigma, between the fourth and the fifth shell of neighbours, so that no pair crosses the cutoff.
At T = 0.002 the terms that are not harmonic are a few thousandths. Langevin's thermostat with the splitting BAOAB samples positions
of harmonic oscillators exactly with any stable step (Leimkuhler and Matthews 2013), so the time step is no source of error.

The displacement depends on the size of the box, whose longest waves are missing: with the modes of 500 atoms, whose <u^2> is larger by
3.6 %, the test fails.
"""

import argparse
import csv
import json
import math
import pathlib
import subprocess
import sys
import tempfile

import numpy as np

sys.path.insert(0, str(pathlib.Path(__file__).resolve().parent.parent))
from figures import check, exit_code  # noqa: E402

CELLS, DENSITY, TEMPERATURE, CUTOFF = 4, 1.0, 0.002, 2.4
NOT_HARMONIC = 0.003  # of <u^2>, relative

DECK = f"""
[system]
lattice = {{{{ type = "fcc", cells = {CELLS} }}}}
density = {DENSITY}
temperature = {TEMPERATURE}
seed = {{seed}}

[potential]
type = "lennard-jones"
cutoff = {CUTOFF}
truncation = "shifted"

[[stage]]
name = "equilibrate"
time_step = 0.008
steps = 5000
thermostat = {{{{ type = "langevin", time = 1.0 }}}}

[[stage]]
name = "production"
time_step = 0.008
steps = 120000
sample = true
thermostat = {{{{ type = "langevin", time = 1.0 }}}}

[output]
trajectory = {{{{ format = "xyz", every = 600 }}}}

[analysis]
crystal = {{{{ every = 20 }}}}
"""


def hessian_eigenvalues() -> np.ndarray:
    """Of the potential energy of all atoms at their sites, in the periodic box."""
    atoms = 4 * CELLS**3
    edge = (atoms / DENSITY) ** (1.0 / 3.0)
    basis = np.array([[0, 0, 0], [0, 1, 1], [1, 0, 1], [1, 1, 0]]) / 2.0
    corners = np.array([[x, y, z] for x in range(CELLS) for y in range(CELLS) for z in range(CELLS)])
    sites = (corners[:, None] + basis).reshape(-1, 3) * edge / CELLS
    hessian = np.zeros((atoms, 3, atoms, 3))
    for i in range(atoms):
        d = sites - sites[i]
        d -= edge * np.round(d / edge)
        r = np.linalg.norm(d, axis=1)
        for j in np.flatnonzero((r > 0.0) & (r < CUTOFF)):
            first = -48.0 * r[j] ** -13 + 24.0 * r[j] ** -7  # u'
            second = 624.0 * r[j] ** -14 - 168.0 * r[j] ** -8  # u''
            n = d[j] / r[j]
            block = second * np.outer(n, n) + first / r[j] * (np.eye(3) - np.outer(n, n))
            hessian[i, :, j, :] -= block
            hessian[i, :, i, :] += block
    return np.linalg.eigvalsh(hessian.reshape(3 * atoms, 3 * atoms))


def check_run(ljmd: str, seed: int, expected: float) -> None:
    with tempfile.TemporaryDirectory() as folder:
        deck = pathlib.Path(folder) / "deck.toml"
        deck.write_text(DECK.format(seed=seed))
        out = pathlib.Path(folder) / "run"
        subprocess.run([ljmd, "run", str(deck), "--out", str(out), "--quiet"], check=True, capture_output=True)
        found = json.loads((out / "results.json").read_text())["observables"]
        with open(out / "bragg.csv", newline="") as file:
            rows = [{key: float(value) for key, value in row.items()} for row in csv.DictReader(file)]
        analyzed = json.loads(subprocess.run([ljmd, "analyze", str(out), "crystal", "--json"], check=True, capture_output=True,
                                             text=True).stdout)["observables"]
    u2 = found["site_displacement"]
    by_peak = found["site_displacement_debye_waller"]
    not_harmonic = NOT_HARMONIC * expected
    check("<u^2>", u2["mean"], expected, 4.0 * u2["standard_error"] + not_harmonic)
    check("its error", u2["standard_error"], 0.0, 0.008 * expected)
    check("<u^2> by the Debye-Waller factor", by_peak["mean"], expected, 4.0 * by_peak["standard_error"] + not_harmonic)
    check("the two, which fluctuate together", by_peak["mean"] / u2["mean"], 1.0, 1e-3)
    nearest = (4.0 / DENSITY) ** (1.0 / 3.0) / math.sqrt(2.0)
    ratio = found["lindemann_ratio"]
    check("Lindemann's ratio", ratio["mean"], math.sqrt(expected) / nearest, 4.0 * ratio["standard_error"] + 0.5 * NOT_HARMONIC * ratio["mean"])
    check("vacant sites", found["vacant_sites"]["mean"], 0.0, 0.0)
    for row in rows:
        name = "".join(f"{row[f'miller_{index}']:.0f}" for index in "hkl")
        exponent = row["k"] ** 2 * expected / 3.0
        tolerance = NOT_HARMONIC * exponent
        check(f"exp(-2 W) at {name}", row["debye_waller_factor"], math.exp(-exponent), 4.0 * row["debye_waller_factor_standard_error"] + tolerance)
        check(f"the same of <u^2> at {name}", row["debye_waller_gaussian"], math.exp(-exponent), 4.0 * row["debye_waller_gaussian_standard_error"] + tolerance)
    of_frames = analyzed["site_displacement"]
    check("<u^2> of the frames", of_frames["mean"], expected, 4.0 * of_frames["standard_error"] + not_harmonic)


def main() -> int:
    parser = argparse.ArgumentParser()
    parser.add_argument("--ljmd", required=True)
    parser.add_argument("--seeds", type=int, default=1)
    arguments = parser.parse_args()
    ljmd = str(pathlib.Path(arguments.ljmd).resolve())
    eigenvalues = hessian_eigenvalues()
    check("three modes of the whole crystal", float(np.abs(eigenvalues[:3]).max()), 0.0, 1e-8)
    check("the others are stable", float(eigenvalues[3] > 1.0), 1.0, 0.0)
    expected = TEMPERATURE * float((1.0 / eigenvalues[3:]).sum()) * 3.0 / len(eigenvalues)
    for seed in range(1, arguments.seeds + 1):
        check_run(ljmd, seed, expected)
    return exit_code()


if __name__ == "__main__":
    sys.exit(main())
