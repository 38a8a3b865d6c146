"""Sound, viscosity and diffusion from time correlations of a liquid near its triple point (T 0.722, density 0.8442, cut and shifted at
2.5), extrapolated to wave number 0, beside what the same runs say otherwise.

Usage: hydrodynamic_modes.py --ljmd PROGRAM [--jobs N] [--folder DIR]

By hand: a quarter of an hour of two cores. Expected, each within three errors of both sides:

- the speed of sound of 4000 atoms, c(k) = c + a k^2, beside the adiabatic one by fluctuations (`response_functions`);
- the viscosity of 864 atoms, eta(k) = eta + a k^2, beside Green and Kubo's;
- the coefficient of diffusion of 864 atoms, D(k) = D + a k^2, beside Einstein's.
"""

import argparse
import concurrent.futures
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

DECK = """
[system]
lattice = {{ type = "fcc", cells = {cells} }}
density = 0.8442
temperature = 0.722
seed = {seed}

[potential]
type = "lennard-jones"
cutoff = 2.5
truncation = "shifted"

[[stage]]
name = "melt"
time_step = 0.004
steps = 2000
temperature = 1.5
thermostat = {{ type = "stochastic-rescaling" }}

[[stage]]
name = "cool"
time_step = 0.004
steps = 5000
thermostat = {{ type = "stochastic-rescaling" }}

[[stage]]
name = "production"
time_step = 0.004
steps = {steps}
sample = true

[analysis]
{analyses}
"""
LARGE = {"cells": 10, "steps": 120000, "analyses": """scattering = { every = 10, max_time = 10.0, k_max = 0.75, shells = 4, vectors = 6 }
response_functions = { every = 20 }"""}
SMALL = {"cells": 6, "steps": 150000, "analyses": """scattering = { every = 10, max_time = 6.0, k_max = 1.6, shells = 7, vectors = 6 }
viscosity = { every = 2, max_time = 4.0 }
msd = { every = 25, max_time = 10.0 }"""}
SEEDS = {"large": 2, "small": 6}


def run(options: argparse.Namespace, kind: str, seed: int) -> tuple[dict, list[dict]]:
    """Observables and the rows of modes.csv."""
    settings = LARGE if kind == "large" else SMALL
    out = options.folder / f"{kind}-{seed}"
    if not (out / "results.json").exists():
        deck = options.folder / f"{kind}-{seed}.toml"
        deck.write_text(DECK.format(seed=seed, **settings))
        subprocess.run([options.ljmd, "run", str(deck), "--out", str(out), "--quiet"], check=True, capture_output=True)
    with open(out / "modes.csv", encoding="utf-8", newline="") as file:
        return json.loads((out / "results.json").read_text())["observables"], list(csv.DictReader(file))


def mean(values: list[tuple[float, float]]) -> tuple[float, float]:
    """Of values with errors, weighted by them."""
    weights = [1.0 / error ** 2 for _, error in values]
    return sum(w * value for w, (value, _) in zip(weights, values)) / sum(weights), 1.0 / math.sqrt(sum(weights))


def at_zero(runs: list[list[dict]], name: str, most: float) -> tuple[float, float]:
    """The value at k = 0 of y = y_0 + a k^2, through all values up to a wave number."""
    points = [(float(row["k"]), float(row[name]), float(row[f"{name}_standard_error"]))
              for rows in runs for row in rows if row[name] and float(row["k"]) < most]
    k, y, error = np.array(points).T
    design = np.stack([1.0 / error, k ** 2 / error], axis=1)
    covariance = np.linalg.inv(design.T @ design)
    found = covariance @ design.T @ (y / error)
    chi2 = float(np.sum((design @ found - y / error) ** 2))
    print(f"# {name}: {len(points)} values, chi^2 {chi2:.1f}, slope {found[1]:.3g} +- {math.sqrt(covariance[1, 1]):.2g}")
    for place in sorted(set(k)):
        print(f"#   k = {place:.3f}: {mean([(b, c) for a, b, c in points if a == place])}")
    return float(found[0]), math.sqrt(covariance[0, 0])


def beside(name: str, value: tuple[float, float], other: tuple[float, float]) -> None:
    print(f"# {name}: {value[0]:.5g} +- {value[1]:.2g} at k = 0, {other[0]:.5g} +- {other[1]:.2g} otherwise")
    check(name, value[0], other[0], 3.0 * math.hypot(value[1], other[1]))


def main() -> int:
    parser = argparse.ArgumentParser(description=__doc__.splitlines()[0])
    parser.add_argument("--ljmd", required=True)
    parser.add_argument("--jobs", type=int, default=2)
    parser.add_argument("--folder", type=pathlib.Path, help="where runs are kept")
    options = parser.parse_args()
    with tempfile.TemporaryDirectory() as scratch, concurrent.futures.ThreadPoolExecutor(options.jobs) as pool:
        options.folder = options.folder or pathlib.Path(scratch)
        options.folder.mkdir(parents=True, exist_ok=True)
        found = {kind: list(pool.map(lambda seed, of=kind: run(options, of, seed), range(1, seeds + 1))) for kind, seeds in SEEDS.items()}

    def known(kind: str, name: str) -> tuple[float, float]:
        return mean([(each[name]["mean"], each[name]["standard_error"]) for each, _ in found[kind]])

    modes = {kind: [rows for _, rows in runs] for kind, runs in found.items()}
    beside("speed of sound", at_zero(modes["large"], "sound_velocity", 0.7), known("large", "speed_of_sound"))
    beside("viscosity", at_zero(modes["small"], "transverse_viscosity", 1.6), known("small", "viscosity"))
    beside("diffusion", at_zero(modes["small"], "self_diffusion", 1.6), known("small", "diffusion"))
    return exit_code()


if __name__ == "__main__":
    sys.exit(main())
