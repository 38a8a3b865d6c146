"""What error bars are worth: 60 canonical runs of a liquid that differ in their seed, and every quantity that results.json gives with an error.

Usage: error_bars.py --ljmd PROGRAM

The scatter of the means over the root mean square of the errors is 1 where errors are right; 60 runs know it to 9 %, and the errors of a
short run are themselves known to some 10 to 25 %. It must lie between 0.7 and 1.32.
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

SEEDS = 60
LEAST, MOST = 0.7, 1.32

DECK = """
[system]
lattice = {{ type = "fcc", cells = 3 }}
density = 0.75
temperature = 1.2
seed = {seed}

[potential]
type = "lennard-jones"
cutoff = 2.5
truncation = "cut"
tail = true

[[stage]]
name = "melt"
time_step = 0.004
steps = 1000
temperature = 2.5
thermostat = {{ type = "stochastic-rescaling", time = 0.2 }}

[[stage]]
name = "equilibrate"
time_step = 0.004
steps = 3000
thermostat = {{ type = "stochastic-rescaling", time = 0.2 }}

[[stage]]
name = "production"
time_step = 0.004
steps = 50000
sample = true
thermostat = {{ type = "stochastic-rescaling", time = 0.2 }}

[analysis]
rdf = {{ every = 50 }}
msd = {{ every = 25, max_time = 2.0 }}
vacf = {{ every = 5, max_time = 1.5 }}
viscosity = {{ every = 5, max_time = 1.5 }}
chemical_potential = {{ every = 25, insertions = 300 }}
"""


def main() -> int:
    parser = argparse.ArgumentParser()
    parser.add_argument("--ljmd", required=True)
    arguments = parser.parse_args()
    compute_same_bits_everywhere()
    runs = []
    with tempfile.TemporaryDirectory() as folder:
        for seed in range(1, SEEDS + 1):
            deck = pathlib.Path(folder) / "deck.toml"
            deck.write_text(DECK.format(seed=seed))
            out = pathlib.Path(folder) / "run"
            subprocess.run([arguments.ljmd, "run", str(deck), "--out", str(out), "--quiet", "--force"], check=True,
                           capture_output=True)
            runs.append(json.loads((out / "results.json").read_text())["observables"])
    for name in runs[0]:
        found = [run[name] for run in runs if run[name]["standard_error"] is not None]
        check(f"runs with a value: {name}", len(found), SEEDS, 0)
        centre = sum(one["mean"] for one in found) / len(found)
        scatter = math.sqrt(sum((one["mean"] - centre) ** 2 for one in found) / (len(found) - 1))
        reported = math.sqrt(sum(one["standard_error"] ** 2 for one in found) / len(found))
        check(f"scatter over the reported error: {name}", scatter / reported, 0.5 * (LEAST + MOST), 0.5 * (MOST - LEAST))
        guesses = sum("remark" in one for one in found)
        check(f"errors that are said to be guesses: {name}", guesses, 0, 0.1 * SEEDS)
    return exit_code()


if __name__ == "__main__":
    sys.exit(main())
