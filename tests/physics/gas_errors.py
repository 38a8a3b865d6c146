"""The scatter of energy and compressibility factor over many runs of a gas near saturation, over the errors that the runs report.

Usage: gas_errors.py --ljmd PROGRAM [--folder DIR] [--jobs N]

By hand (ten minutes of two cores). Sixteen runs of 500 atoms and 1600 tau at T = 0.75 and density 0.01, force-shifted at 2.5: each of four
canonical thermostats, steps of 0.004 and 0.008, two seeds. Collisions are fast, and pairs that are bound are formed and parted slowly, which is
hidden below them. Z is known, 0.94263 (docs/equations-of-state.md). The root mean square deviation from it, and the scatter of the energy, must be 0.6
to 1.5 times the errors (16 runs know them to 18 %).
"""

import argparse
import concurrent.futures
import json
import math
import pathlib
import subprocess
import sys
import tempfile

sys.path.insert(0, str(pathlib.Path(__file__).resolve().parent.parent))
from figures import check, exit_code  # noqa: E402
from gases import THERMOSTATS, compressibility_factor  # noqa: E402

LEAST, LARGEST = 0.6, 1.5

DECK = """
[system]
lattice = {{ type = "fcc", cells = 5 }}
density = 0.01
temperature = 0.75
seed = {seed}

[potential]
type = "lennard-jones"
cutoff = 2.5
truncation = "force-shifted"

[[stage]]
name = "mix"
time_step = {dt}
steps = {mix}
thermostat = {{ type = "andersen", time = 1.0 }}

[[stage]]
name = "production"
time_step = {dt}
steps = {steps}
sample = true
thermostat = {{ type = "{thermostat}" }}

[output]
thermo = {{ every = 10 }}
"""


def run(options, folder, name, **values):
    results = folder / name / "results.json"
    if not results.exists():
        deck = folder / f"{name}.toml"
        deck.write_text(DECK.format(**values), encoding="utf-8")
        subprocess.run([options.ljmd, "run", deck, "--out", folder / name, "--quiet", "--force"], check=True, capture_output=True)
    return json.loads(results.read_text(encoding="utf-8"))["observables"]


def measure(options, folder):
    with concurrent.futures.ThreadPoolExecutor(options.jobs) as pool:
        runs = [pool.submit(run, options, folder, f"{thermostat}-{dt}-{seed}", seed=seed, dt=dt, mix=round(400 / dt), steps=round(1600 / dt),
                            thermostat=thermostat)
                for thermostat in THERMOSTATS for dt in (0.004, 0.008) for seed in (1, 2)]
        found = [each.result() for each in runs]
    for name in ("compressibility_factor", "potential_energy"):
        means = [each[name]["mean"] for each in found]
        errors = [each[name]["standard_error"] for each in found]
        centre = compressibility_factor() if name == "compressibility_factor" else sum(means) / len(means)
        freedom = len(means) - (0 if name == "compressibility_factor" else 1)
        scatter = math.sqrt(sum((mean - centre) ** 2 for mean in means) / freedom)
        stated = math.sqrt(sum(error ** 2 for error in errors) / len(errors))
        print(f"  {name}: mean {sum(means) / len(means):.6f}, scatter {scatter:.6f}, errors {min(errors):.6f} to {max(errors):.6f}")
        check(f"scatter over error of {name}", scatter / stated, (LEAST + LARGEST) / 2, (LARGEST - LEAST) / 2)


def main():
    parser = argparse.ArgumentParser(description=__doc__.splitlines()[0])
    parser.add_argument("--ljmd", required=True)
    parser.add_argument("--folder", type=pathlib.Path)
    parser.add_argument("--jobs", type=int, default=2)
    options = parser.parse_args()
    with tempfile.TemporaryDirectory() as temporary:
        measure(options, options.folder or pathlib.Path(temporary))
    return exit_code()


if __name__ == "__main__":
    sys.exit(main())
