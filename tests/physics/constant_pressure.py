"""A density found at a pressure, and the pressure found at that density: the barostat against virial, fluctuations and the
equation of state.

Usage: constant_pressure.py --ljmd PROGRAM --examples DIRECTORY

Runs inputs/examples/constant-pressure.toml, longer, then inputs/examples/canonical.toml at the density that it found.
Equation of state: Thol et al. (2016), doi:10.1063/1.4945000.
"""

import argparse
import csv
import json
import pathlib
import subprocess
import sys
import tempfile

sys.path.insert(0, str(pathlib.Path(__file__).resolve().parent.parent))
from figures import check, exit_code  # noqa: E402

PRESSURE = 0.5


def main() -> int:
    parser = argparse.ArgumentParser()
    parser.add_argument("--ljmd", required=True)
    parser.add_argument("--examples", type=pathlib.Path, required=True)
    arguments = parser.parse_args()

    def observables(deck: str, out: pathlib.Path, *settings: str) -> dict:
        command = [arguments.ljmd, "run", str(arguments.examples / deck), "--out", str(out), "--quiet"]
        subprocess.run(command + [word for setting in settings for word in ("--set", setting)], check=True)
        return json.loads((out / "results.json").read_text())["observables"]

    def equation_of_state(density: float) -> dict:
        command = [arguments.ljmd, "eos", "--temperature", "1.0", "--density", str(density), "--json"]
        return json.loads(subprocess.run(command, check=True, capture_output=True, text=True).stdout)

    with tempfile.TemporaryDirectory() as folder:
        out = pathlib.Path(folder)
        held = observables("constant-pressure.toml", out / "npt", "stage.production.steps=400000")
        with open(out / "npt" / "thermo.csv", newline="") as file:
            rows = [row for row in csv.DictReader(file) if int(row["step"]) > 10000]
        density = held["density"]["mean"]
        found = observables("canonical.toml", out / "nvt", f"system.density={density}", "stage.production.steps=200000")

    def mean(of: dict, name: str) -> float:
        return of[name]["mean"]

    def error(of: dict, name: str) -> float:
        return of[name]["standard_error"]

    check("temperature under the barostat", mean(held, "temperature"), 1.0, 4.0 * error(held, "temperature"))
    check("pressure under the barostat", mean(held, "pressure"), PRESSURE, 4.0 * error(held, "pressure"))
    check("its error", error(held, "pressure"), 0.0, 0.01)
    check("temperature at constant volume", mean(found, "temperature"), 1.0, 4.0 * error(found, "temperature"))

    fluid = equation_of_state(density)
    slope = fluid["pressure_density_slope"]
    both = (error(found, "pressure") ** 2 + (slope * error(held, "density")) ** 2) ** 0.5
    check("pressure at the density found", mean(found, "pressure"), PRESSURE, 4.0 * both)
    check("its error", both, 0.0, 0.02)
    # The cutoff of 2.5 with tail costs some of the pressure: the density is that of the full potential within 1 %.
    check("pressure of the equation of state there", fluid["pressure"], PRESSURE, 0.01 * density * slope)

    # (<V^2> - <V>^2)/(<V> T) is the isothermal compressibility, 1/(rho dp/drho).
    volumes = [500.0 / float(row["density"]) for row in rows]
    average = sum(volumes) / len(volumes)
    variance = sum((v - average) ** 2 for v in volumes) / len(volumes)
    check("compressibility from the volume's fluctuations", variance / average, 1.0 / (density * slope),
          0.2 / (density * slope))

    # c_v from the fluctuations of the energy against the equation of state.
    c_v = fluid["heat_capacity_cv"]
    check("heat capacity", mean(found, "heat_capacity_cv"), c_v, 4.0 * error(found, "heat_capacity_cv") + 0.05)
    return exit_code()


if __name__ == "__main__":
    sys.exit(main())
