"""What `ljmd analyze` and the verdict of a report say of runs in equilibrium, and of runs that were not when sampling began.

Usage: equilibrium.py --ljmd PROGRAM [--quick | --long]

100 runs each that differ in their seed, at constant temperature, energy and pressure, short ones and slow ones, and of a thin gas. No more of them may have a value
without a remark that lies more than three errors off than Student's distribution of six degrees of freedom lets expect (blocks are seven or
more): 2.4 %. No verdict may say that a run was not in equilibrium. Everything must be what results.json has. Of 40 runs each that melt, cool down or warm up while
they are sampled, 95 % must be told from those in equilibrium. --quick: a fifth of the runs, for the short set; --long:
300 and 100 runs, for those who change what is tested.
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

BEYOND = 0.024  # of Student's distribution of six degrees of freedom, beyond three

SYSTEM = """
[system]
lattice = {{ type = "fcc", cells = 3 }}
density = {density}
temperature = {start}
seed = {seed}

[potential]
type = "lennard-jones"
cutoff = 2.0
truncation = "force-shifted"
"""
EQUILIBRATION = """
[[stage]]
name = "melt"
time_step = 0.004
steps = 1000
temperature = 2.5
thermostat = {{ type = "stochastic-rescaling" }}

[[stage]]
name = "equilibrate"
time_step = 0.004
steps = {before}
thermostat = {{ type = "stochastic-rescaling" }}
{barostat}
"""
SAMPLED = """
[[stage]]
name = "production"
time_step = 0.004
steps = {steps}
sample = true
{ensemble}
"""
CANONICAL = 'thermostat = { type = "stochastic-rescaling" }'
BAROSTAT = 'barostat = { type = "stochastic-cell-rescaling", pressure = 1.0, time = %g }'

# Density, steps before, steps, ensemble, barostat before sampling; what is right.
SETTLED = {
    "canonical": (0.75, 3000, 5000, CANONICAL, "", {"temperature": 1.0}),
    "slow thermostat": (0.75, 3000, 10000, 'thermostat = { type = "stochastic-rescaling", time = 5.0 }', "", {"temperature": 1.0}),
    "constant energy": (0.75, 3000, 5000, "total_energy = -1.22", "", {"total_energy": -1.22}),
    "constant pressure": (0.61, 3000, 5000, CANONICAL + "\n" + BAROSTAT % 1.0, BAROSTAT % 1.0, {}),
    "slow barostat": (0.61, 3000, 12000, CANONICAL + "\n" + BAROSTAT % 4.0, BAROSTAT % 1.0, {}),
    "thin gas": (0.02, 10000, 20000, CANONICAL, "", {"temperature": 1.0}),  # its bound pairs are few, and live long
}
# Temperature of the start, steps before, steps, ensemble.
UNSETTLED = {
    "melting": (1.8, 0, 5000, "temperature = 1.2\n" + CANONICAL),
    "quench": (3.0, 1000, 5000, 'temperature = 1.0\nthermostat = { type = "langevin", time = 2.0 }'),
    "drift": (3.0, 1000, 5000, 'temperature = 1.0\nthermostat = { type = "langevin", time = 8.0 }'),
}


class Program:
    def __init__(self, ljmd: str, folder: pathlib.Path) -> None:
        self.ljmd, self.folder = ljmd, folder

    def json(self, *arguments: str) -> dict:
        found = subprocess.run([self.ljmd, *arguments, "--json"], check=True, capture_output=True, text=True)
        return json.loads(found.stdout)

    def run(self, text: str) -> tuple[dict, dict, str]:
        """What analyze, results.json and the verdict on equilibrium say of a deck."""
        deck, out = self.folder / "deck.toml", self.folder / "run"
        deck.write_text(text)
        subprocess.run([self.ljmd, "run", str(deck), "--out", str(out), "--quiet", "--force", "--threads", "1"], check=True,
                       capture_output=True)
        verdicts = self.json("report", str(out))["verdict"]
        verdict = next(one["words"] for one in verdicts if one["subject"] == "equilibrium")
        results = json.loads((out / "results.json").read_text())["observables"]
        return self.json("analyze", str(out))["observables"], results, verdict


def check_settled(program: Program, name: str, count: int) -> None:
    density, before, steps, ensemble, barostat, right = SETTLED[name]
    text = SYSTEM + EQUILIBRATION + SAMPLED
    runs = [program.run(text.format(density=density, start=1.0, seed=seed, before=before, barostat=barostat, steps=steps, ensemble=ensemble))
            for seed in range(1, count + 1)]
    alarms = [verdict for _, _, verdict in runs if verdict.startswith("Not in equilibrium")]
    check(f"{name}: runs that are called not in equilibrium", len(alarms), 0, 0)
    unlike = sum(abs(one[key] - results[quantity][key]) > 1e-9 * abs(one[key])
                 for found, results, _ in runs for quantity, one in found.items() for key in ("mean", "standard_error", "error_is_converged"))
    check(f"{name}: values that are not those of results.json", unlike, 0, 0)
    for quantity in runs[0][0]:
        found = [one[quantity] for one, _, _ in runs]
        mean = right.get(quantity, sum(one["mean"] for one in found) / count)
        off = [(one["mean"] - mean) / one["standard_error"] for one in found if "remark" not in one]
        rms = math.sqrt(sum(one * one for one in off) / len(off)) if off else math.nan
        print(f"{name}: {quantity} {sum(one['mean'] for one in found) / count:.5f}; {len(off)} of {count} without a remark, "
              f"scatter over error {rms:.2f}")
        # No more often than chance: what it leads to expect, and two standard deviations of such a number.
        check(f"{name}: {quantity} more than three errors off without a remark", sum(abs(one) > 3 for one in off), 0,
              max(BEYOND * count + 2.0 * math.sqrt(BEYOND * count), 2))


def check_unsettled(program: Program, name: str, count: int) -> None:
    start, before, steps, ensemble = UNSETTLED[name]
    text = SYSTEM + (EQUILIBRATION if before else "") + SAMPLED
    runs = [program.run(text.format(density=0.75, start=start, seed=seed, before=before, barostat="", steps=steps, ensemble=ensemble))
            for seed in range(1, count + 1)]
    told = sum(verdict.startswith("Not in equilibrium") for _, _, verdict in runs)
    started = sum(any((one["equilibrated_at_row"] or 0) > 0 or one["equilibrium"] == "still changing" for one in found.values())
                  for found, _, _ in runs)
    print(f"{name}: {told} verdicts, {started} starts in {count}")
    check(f"{name}: runs that are called not in equilibrium, in a hundred", 100 * told / count, 100, 5)


def main() -> int:
    parser = argparse.ArgumentParser()
    parser.add_argument("--ljmd", required=True)
    parser.add_argument("--quick", action="store_true")
    parser.add_argument("--long", action="store_true")
    options = parser.parse_args()
    with tempfile.TemporaryDirectory() as folder:
        program = Program(options.ljmd, pathlib.Path(folder))
        for name in SETTLED:
            check_settled(program, name, 20 if options.quick else 300 if options.long else 100)
        for name in UNSETTLED:
            check_unsettled(program, name, 10 if options.quick else 100 if options.long else 40)
    return exit_code()


if __name__ == "__main__":
    sys.exit(main())
