"""The main job against the literature: runs inputs/verlet1967/argon-864.toml as it stands and checks what it finds.

Usage: argon_864.py --ljmd PROGRAM --deck DECK

Reference figures at (rho 0.8442, T 0.722): U/N = -6.088 with tail, Z = 0.25; slopes for the correction from the measured
temperature, dU/dT = 1.13 and dZ/dT = 10.05, from the equation of state of Thol et al. (2016), doi:10.1063/1.4945000. g(r):
peaks and minimum of an independent simulation of the same state (N = 864, rc = 2.5).
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

TEMPERATURE = 0.722


def extremum(curve: list[tuple[float, float]], low: float, high: float, sign: int) -> tuple[float, float]:
    """(r, g) of the maximum (sign 1) or minimum (sign -1) of g between two radii."""
    return max(((r, g) for r, g in curve if low < r < high), key=lambda point: sign * point[1])


def main() -> int:
    parser = argparse.ArgumentParser()
    parser.add_argument("--ljmd", required=True)
    parser.add_argument("--deck", required=True)
    arguments = parser.parse_args()
    with tempfile.TemporaryDirectory() as folder:
        out = pathlib.Path(folder) / "argon"
        subprocess.run([arguments.ljmd, "run", arguments.deck, "--out", str(out)], check=True)
        results = json.loads((out / "results.json").read_text())
        with open(out / "rdf.csv", newline="") as file:
            curve = [(float(row["r"]), float(row["g"])) for row in csv.DictReader(file)]

    found = results["observables"]
    correction = TEMPERATURE - found["temperature"]["mean"]
    energy, factor = found["potential_energy"], found["compressibility_factor"]
    check("U/N at T = 0.722", energy["mean"] + 1.13 * correction, -6.088, 0.01)
    check("Z at T = 0.722", factor["mean"] + 10.05 * correction, 0.25, 0.05)
    check("standard error of U/N", energy["standard_error"], 0.002, 0.002)
    check("standard error of Z", factor["standard_error"], 0.01, 0.01)
    check("temperature", found["temperature"]["mean"], TEMPERATURE, 0.02)
    check("translational order when sampling begins", results["translational_order_at_sampling"], 0.0, 0.1)
    # Where g is flat, the lowest or highest of a hundred bins is found by chance within these.
    for name, low, high, sign, radius, place, height, margin in (
        ("first peak", 0.9, 1.4, 1, 1.085, 0.0201, 3.04, 0.06),
        ("first minimum", 1.3, 1.9, -1, 1.545, 0.0601, 0.578, 0.02),
        ("second peak", 1.8, 2.4, 1, 2.085, 0.0401, 1.28, 0.03),
    ):
        r, g = extremum(curve, low, high, sign)
        check(f"g(r), {name}: r", r, radius, place)
        check(f"g(r), {name}: height", g, height, margin)
    return exit_code()


if __name__ == "__main__":
    sys.exit(main())
