"""A dilute gas under each canonical thermostat against its virial series.

Usage: dilute_gas.py --ljmd PROGRAM

Force-shifted Lennard-Jones at 2.5, density 0.01, temperature 0.75, 500 atoms. Second to fourth virial coefficients are
-5.76210, 1.3164 (quadrature) and -4.6 +- 1.4 (Monte Carlo integration); with the terms of the order 1/N of a canonical gas,

    Z = 1 + (1 - 1/N) B2 rho + [(1 - 1/N) (1 - 2/N) B3 + (2/N) (1 - 1/N) B2^2] rho^2 + B4 rho^3 = 0.94263

NIST Standard Reference Simulation Website, doi:10.18434/T4M88Q: 0.9424.
"""

import argparse
import json
import math
import pathlib
import subprocess
import sys
import tempfile

sys.path.insert(0, str(pathlib.Path(__file__).resolve().parent.parent))
from figures import check, exit_code  # noqa: E402
from same_bits import compute_same_bits_everywhere  # noqa: E402

DECK = """
[system]
lattice = {{ type = "fcc", cells = 5 }}
density = 0.01
temperature = 0.75
seed = 1

[potential]
type = "lennard-jones"
cutoff = 2.5
truncation = "force-shifted"

[neighbors]
skin = 1.0

[[stage]]
name = "mix"
time_step = 0.008
steps = 25000
thermostat = {{ type = "langevin", time = 1.0 }}

[[stage]]
name = "production"
time_step = 0.008
steps = 200000
sample = true
thermostat = {{ type = "{thermostat}", time = 1.0 }}
"""
THERMOSTATS = ("andersen", "langevin", "nose-hoover-chain", "stochastic-rescaling")
ATOMS, DENSITY = 500, 0.01
B2, B3, B4 = -5.76210, 1.3164, -4.6
SIGMAS = 4.0  # the runs are the same on every processor


def compressibility_factor() -> float:
    """Of the canonical gas of so many atoms."""
    n = ATOMS
    second = (1 - 1 / n) * (1 - 2 / n) * B3 + 2 / n * (1 - 1 / n) * B2**2
    return 1 + (1 - 1 / n) * B2 * DENSITY + second * DENSITY**2 + B4 * DENSITY**3


def main() -> int:
    parser = argparse.ArgumentParser()
    parser.add_argument("--ljmd", required=True)
    arguments = parser.parse_args()
    compute_same_bits_everywhere()
    expected = compressibility_factor()
    check("the virial series", expected, 0.94263, 5e-6)
    found = []
    with tempfile.TemporaryDirectory() as folder:
        for thermostat in THERMOSTATS:
            deck = pathlib.Path(folder) / f"{thermostat}.toml"
            deck.write_text(DECK.format(thermostat=thermostat))
            out = pathlib.Path(folder) / thermostat
            subprocess.run([arguments.ljmd, "run", str(deck), "--out", str(out), "--quiet"], check=True, capture_output=True)
            found.append(json.loads((out / "results.json").read_text())["observables"]["compressibility_factor"])
    for thermostat, z in zip(THERMOSTATS, found):
        check(f"Z, {thermostat}", z["mean"], expected, SIGMAS * z["standard_error"])
        check(f"its error, {thermostat}", z["standard_error"], 0.0, 0.0005)
    mean = sum(z["mean"] for z in found) / len(found)
    error = math.sqrt(sum(z["standard_error"] ** 2 for z in found)) / len(found)
    check("Z, mean of all", mean, expected, SIGMAS * error)
    check("its error", error, 0.0, 0.00025)
    return exit_code()


if __name__ == "__main__":
    sys.exit(main())
