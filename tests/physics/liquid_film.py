"""Surface tension and coexisting densities of the film of inputs/examples/liquid-film.toml against published values.

Usage: liquid_film.py --ljmd PROGRAM --deck DECK [--long]

The fluid truncated and shifted at 2.5: surface tension by Vrabec, Kedia, Fuchs and Hasse (2006), doi:10.1080/00268970600556774, equation
15, 2.08 (1 - T/1.0779)^1.21, which describes their molecular dynamics to 1 to 2 %; densities and vapour pressure by the equation of
state of Thol et al. (2015) (`ljmd eos`). One run at T = 0.8 with an error of 5 %, half a minute of one core.

--long (by hand, ten minutes of one core): T = 0.7, 0.8 and 0.9, so long that the error of the tension is below 3 % at each.
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

SHORT = ((0.8, 100_000, 0.065),)  # temperature, steps, largest relative error of the tension
LONG = ((0.7, 400_000, 0.03), (0.8, 400_000, 0.03), (0.9, 900_000, 0.03))
OF_FIT = 0.02  # relative, of the published tension
OF_EQUATION = {"liquid_density": 0.003, "vapour_density": 0.03, "normal_pressure": 0.03}  # and of a film of finite width
SIGMAS = 3.0


def check_film(ljmd: str, deck: pathlib.Path, temperature: float, steps: int, largest: float) -> None:
    with tempfile.TemporaryDirectory() as folder:
        out = pathlib.Path(folder) / "run"
        settings = [f"system.temperature={temperature}", "system.seed=12", f"stage.production.steps={steps}"]
        options = [part for setting in settings for part in ("--set", setting)]
        subprocess.run([ljmd, "run", str(deck), "--out", str(out), "--quiet", *options], check=True, capture_output=True)
        found = json.loads((out / "results.json").read_text())["observables"]
    command = [ljmd, "eos", "--model", "thol2015", "--temperature", str(temperature), "--json"]
    phases = json.loads(subprocess.run(command, check=True, capture_output=True, text=True).stdout)
    expected = {"liquid_density": phases["liquid"]["density"], "vapour_density": phases["vapour"]["density"],
                "normal_pressure": phases["pressure"]}
    published = 2.08 * (1.0 - temperature / 1.0779) ** 1.21
    tension = found["surface_tension"]
    check(f"surface tension at {temperature}", tension["mean"], published,
          SIGMAS * math.hypot(tension["standard_error"], OF_FIT * published))
    check("its relative error", tension["standard_error"] / published, 0.0, largest)
    for name, value in expected.items():
        # Over seeds the vapour of so short a run scatters by 2.5 of its errors, and all of them say that they are guesses.
        error = math.hypot((2.0 if "remark" in found[name] else 1.0) * found[name]["standard_error"], OF_EQUATION[name] * value)
        check(f"{name} at {temperature}", found[name]["mean"], value, SIGMAS * error)


def main() -> int:
    parser = argparse.ArgumentParser()
    parser.add_argument("--ljmd", required=True)
    parser.add_argument("--deck", required=True, type=pathlib.Path)
    parser.add_argument("--long", action="store_true")
    arguments = parser.parse_args()
    for run in LONG if arguments.long else SHORT:
        check_film(arguments.ljmd, arguments.deck, *run)
    return exit_code()


if __name__ == "__main__":
    sys.exit(main())
