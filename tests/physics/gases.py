"""Gases under each canonical thermostat: pressure against the virial series, volume against the ensemble that a barostat makes.

Usage: gases.py --ljmd PROGRAM [--long]

Without --long: two of the thermostats, one that draws random numbers and one that knows none.

Pressure: force-shifted Lennard-Jones at 2.5, density 0.01, temperature 0.75, 500 atoms. Second to fourth virial coefficients are
-5.76210, 1.3164 (quadrature) and -4.6 +- 1.4 (Monte Carlo integration); with the terms of the order 1/N of a canonical gas,

    Z = 1 + (1 - 1/N) B2 rho + [(1 - 1/N) (1 - 2/N) B3 + (2/N) (1 - 1/N) B2^2] rho^2 + B4 rho^3 = 0.94263

NIST Standard Reference Simulation Website, doi:10.18434/T4M88Q: 0.9424.

Volume: 32 atoms that hardly feel each other have V^N exp(-p V/T), so <rho> T/p = 1 and <V> p/T = N + 1. The barostat's relaxation
time is as short as changes of the volume allow; its noise depends on the seed alone, so each thermostat has another one.
"""

import argparse
import csv
import json
import math
import pathlib
import subprocess
import sys
import tempfile

sys.path.insert(0, str(pathlib.Path(__file__).resolve().parent.parent))
from figures import check, exit_code  # noqa: E402

DILUTE = """
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
IDEAL = """
[system]
lattice = {{ type = "fcc", cells = 2 }}
density = 0.384615384615
temperature = 1.3
seed = {seed}

[potential]
type = "morse"
well_depth = 1e-12
steepness = 1.0
minimum = 1.0
cutoff = 1.0
truncation = "force-shifted"

[neighbors]
skin = 0.1

[[stage]]
name = "production"
time_step = 0.01
steps = 1400000
sample = true
thermostat = {{ type = "{thermostat}", time = 0.1 }}
barostat = {{ type = "stochastic-cell-rescaling", pressure = 0.5, time = 2.4, compressibility = 2.0, every = 1 }}

[output]
thermo = {{ every = 20 }}
"""
SEEDS = {"andersen": 3, "langevin": 4, "nose-hoover-chain": 5, "stochastic-rescaling": 6}
QUICK = ("langevin", "nose-hoover-chain")
ATOMS, DENSITY = 500, 0.01
B2, B3, B4 = -5.76210, 1.3164, -4.6
SIGMAS = 4.0  # the runs are the same on every processor


def compressibility_factor() -> float:
    """Of the canonical gas of so many atoms."""
    n = ATOMS
    second = (1 - 1 / n) * (1 - 2 / n) * B3 + 2 / n * (1 - 1 / n) * B2**2
    return 1 + (1 - 1 / n) * B2 * DENSITY + second * DENSITY**2 + B4 * DENSITY**3


def run(ljmd: str, folder: str, deck_text: str) -> tuple[dict, pathlib.Path]:
    """The observables of a run of a deck, and its directory."""
    deck = pathlib.Path(folder) / "deck.toml"
    deck.write_text(deck_text)
    out = pathlib.Path(folder) / "run"
    subprocess.run([ljmd, "run", str(deck), "--out", str(out), "--quiet", "--force"], check=True, capture_output=True)
    return json.loads((out / "results.json").read_text())["observables"], out


def check_pressure(ljmd: str, folder: str, thermostats: tuple[str, ...]) -> None:
    expected = compressibility_factor()
    check("the virial series", expected, 0.94263, 5e-6)
    found = [run(ljmd, folder, DILUTE.format(thermostat=thermostat))[0]["compressibility_factor"] for thermostat in thermostats]
    for thermostat, z in zip(thermostats, found):
        check(f"Z, {thermostat}", z["mean"], expected, SIGMAS * z["standard_error"])
        check(f"its error, {thermostat}", z["standard_error"], 0.0, 0.0015)
    mean = sum(z["mean"] for z in found) / len(found)
    error = math.sqrt(sum(z["standard_error"] ** 2 for z in found)) / len(found)
    check("Z, mean of all", mean, expected, SIGMAS * error)
    check("its error", error, 0.0, 0.0012 / math.sqrt(len(found)))


def check_volume(ljmd: str, folder: str, thermostat: str, seed: int) -> None:
    pressure, temperature, atoms = 0.5, 1.3, 32
    found, out = run(ljmd, folder, IDEAL.format(thermostat=thermostat, seed=seed))
    density = found["density"]
    error = density["standard_error"] * temperature / pressure
    check(f"<rho> T/p, {thermostat}", density["mean"] * temperature / pressure, 1.0, SIGMAS * error)
    check("its error", error, 0.0, 0.004)
    with open(out / "thermo.csv", newline="") as file:
        volumes = [atoms / float(row["density"]) for row in csv.DictReader(file)][1:]
    mean = sum(volumes) / len(volumes)
    variance = sum((volume - mean) ** 2 for volume in volumes) / len(volumes)
    error = math.sqrt(variance / density["independent_samples"]) / mean  # volume and density are forgotten together
    check(f"<V> p/T/(N + 1), {thermostat}", mean * pressure / (temperature * (atoms + 1)), 1.0, SIGMAS * error)
    check("its error", error, 0.0, 0.004)


def main() -> int:
    parser = argparse.ArgumentParser()
    parser.add_argument("--ljmd", required=True)
    parser.add_argument("--long", action="store_true")
    arguments = parser.parse_args()
    thermostats = tuple(SEEDS) if arguments.long else QUICK
    with tempfile.TemporaryDirectory() as folder:
        check_pressure(arguments.ljmd, folder, thermostats)
        for thermostat in thermostats:
            check_volume(arguments.ljmd, folder, thermostat, SEEDS[thermostat])
    return exit_code()


if __name__ == "__main__":
    sys.exit(main())
