"""Energy and pressure of the Lennard-Jones fluid, vapour and liquid, against Monte Carlo; and what the error bars are worth.

Usage: equation_of_state.py --ljmd PROGRAM --reference tests/data/nist/lj_mc_eos.csv [--quick]

--quick: of one vapour and one liquid, without the scatter of runs.

Reference: canonical Monte Carlo of 500 atoms with a cutoff of 3 and tail corrections. Pressures: NIST Standard Reference
Simulation Website, doi:10.18434/T4M88Q. Energies, with standard deviations of their means: the same states by FEASST (Hatch and
others 2018, doi:10.6028/jres.123.004).
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

DECK = """
[system]
lattice = {{ type = "fcc", cells = {cells} }}
density = {density}
temperature = {temperature}
seed = {seed}

[potential]
type = "lennard-jones"
cutoff = {cutoff}
truncation = "cut"
tail = true

[[stage]]
name = "melt"
time_step = 0.004
steps = 3000
temperature = 2.0
thermostat = {{ type = "stochastic-rescaling", time = 0.2 }}

[[stage]]
name = "equilibrate"
time_step = 0.004
steps = {equilibration}
thermostat = {{ type = "{thermostat}", time = 0.5 }}

[[stage]]
name = "production"
time_step = 0.004
steps = {steps}
sample = true
thermostat = {{ type = "{thermostat}", time = 0.5 }}
"""

VAPOUR = [(0.85, 0.003), (0.85, 0.007), (0.9, 0.009)]
LIQUID = [(0.85, 0.776), (0.85, 0.82), (0.85, 0.86), (0.9, 0.776), (0.9, 0.86)]

# The runs are the same on every processor; gates are such that a change of the code that only gives other bits fails them by
# chance once in ten thousand times.
SIGMAS = 4.0
CHI_SQUARE = {5: 25.7}  # of so many degrees of freedom
# In a vapour few pairs of atoms hold together, each for long: blocks of one run do not tell the error of its energy well. Over
# seven seeds at (T 0.85, rho 0.007) energies scatter by 1.2 %, which is 1.3 times the errors stated; the gate is four times that.
VAPOUR_ENERGY = 0.05  # relative


def main() -> int:
    parser = argparse.ArgumentParser()
    parser.add_argument("--ljmd", required=True)
    parser.add_argument("--reference", type=pathlib.Path, required=True)
    parser.add_argument("--quick", action="store_true")
    arguments = parser.parse_args()
    with open(arguments.reference, newline="") as file:
        reference = {(float(row["T"]), float(row["rho"])): row for row in csv.DictReader(file)}

    def observables(folder: str, **values: float) -> dict:
        """Means and standard errors of a run: (mean, error) by name."""
        deck = pathlib.Path(folder) / "deck.toml"
        deck.write_text(DECK.format(**values))
        out = pathlib.Path(folder) / "run"
        subprocess.run([arguments.ljmd, "run", str(deck), "--out", str(out), "--quiet", "--force"], check=True,
                       capture_output=True)
        found = json.loads((out / "results.json").read_text())["observables"]
        return {name: (value["mean"], value["standard_error"]) for name, value in found.items()}

    chi_square = 0.0
    with tempfile.TemporaryDirectory() as folder:
        for temperature, density in VAPOUR[1:2] + LIQUID[:1] if arguments.quick else VAPOUR + LIQUID:
            known = reference[temperature, density]
            liquid = density > 0.5
            # In a vapour atoms become pairs, and pairs atoms, when a third one is there: seldom, unless a bath is everywhere.
            found = observables(folder, cells=5, cutoff=3.0, seed=3, temperature=temperature, density=density,
                                thermostat="stochastic-rescaling" if liquid else "langevin",
                                equilibration=10000 if liquid else 40000, steps=100000 if liquid else 250000)
            state = f"(T {temperature}, rho {density})"
            energy, energy_error = found["potential_energy"]
            both = math.hypot(energy_error, float(known["U_standard_deviation"]))
            right = float(known["U"])
            check(f"energy {state}", energy, right, SIGMAS * both if liquid else VAPOUR_ENERGY * abs(right))
            chi_square += ((energy - right) / both) ** 2 if liquid else 0.0
            pressure, pressure_error = found["pressure"]
            wanted = float(known["p"])
            check(f"pressure {state}", pressure, wanted,
                  max(SIGMAS * pressure_error, 0.03) if liquid else 0.01 * wanted)
            check(f"error of the energy {state}", energy_error, 0.0, 0.004)
            check(f"error of the compressibility factor {state}", found["compressibility_factor"][1], 0.0, 0.02)
        if arguments.quick:
            return exit_code()
        limit = CHI_SQUARE[len(LIQUID)]
        check(f"chi-square of {len(LIQUID)} energies of the liquid", chi_square, 0.5 * limit, 0.5 * limit)

        # The scatter of 20 runs against the errors that they report: known to 16 %. Errors that are half or twice what they
        # should be are found; more seeds are a matter for the long set.
        runs = [observables(folder, cells=4, cutoff=2.5, seed=seed, temperature=1.0, density=0.76, equilibration=2000,
                            thermostat="stochastic-rescaling", steps=20000) for seed in range(1, 21)]
    for name in ("potential_energy", "pressure", "compressibility_factor", "temperature"):
        means = [run[name][0] for run in runs]
        centre = sum(means) / len(means)
        scatter = math.sqrt(sum((mean - centre) ** 2 for mean in means) / (len(means) - 1))
        reported = math.sqrt(sum(run[name][1] ** 2 for run in runs) / len(runs))
        check(f"scatter of 20 runs over the reported error: {name}", scatter / reported, 1.05, 0.6)
    return exit_code()


if __name__ == "__main__":
    sys.exit(main())
