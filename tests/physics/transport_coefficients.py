"""Thermal conductivity and bulk viscosity of the truncated and shifted fluid against the literature, from the deck
inputs/examples/transport.toml, with 256 atoms or, with --long, 500 atoms, seven times as long and at three states.

Usage: transport_coefficients.py --ljmd PROGRAM --deck TRANSPORT.TOML [--long]

The long form takes a quarter of an hour on one processor. Values elsewhere and their errors, all with the forces of the shifted
potential, with r_c = 2.5 but for the last:

- (rho 0.8442, T 0.722) thermal conductivity 6.946 +- 0.12 by Helfand's moments, 1372 atoms (Viscardy, Servantie and Gaspard
  2007, doi:10.1063/1.2724821); 6.934 +- 0.028 by LAMMPS and STACIE (molmod.github.io/stacie). Bulk viscosity 1.186 +- 0.084
  (Meier, Laesecke and Kabelac 2005, doi:10.1063/1.1828040); 1.190 +- 0.021 by LAMMPS and STACIE.
- (rho 0.6, T 1.35) thermal conductivity 3.41, 3.39 and 3.45 by three non-equilibrium methods, 8000 atoms (LAMMPS,
  examples/KAPPA), so 3.42 +- 0.05.
- (rho 0.6061, T 1.512), r_c = 3: bulk viscosity 1.338 +- 0.535, in the reference results of the program ms2, version 5.020
  (github.com/moltherm-computation/ms2, examples/Transport/reference/NVE_MD_GK_1.res). One run of 100 tau: it shows gross errors
  only.
"""

import argparse
import json
import math
import pathlib
import subprocess
import sys
import tempfile
from typing import NamedTuple

sys.path.insert(0, str(pathlib.Path(__file__).resolve().parent.parent))
from figures import check, exit_code  # noqa: E402


class State(NamedTuple):
    density: float
    temperature: float
    expected: dict[str, tuple[float, float]]  # names of quantities: value and its error
    cutoff: float = 2.5


TRIPLE_POINT = State(0.8442, 0.722, {"thermal_conductivity": (6.946, 0.12), "bulk_viscosity": (1.186, 0.084)})
SUPERCRITICAL = State(0.6, 1.35, {"thermal_conductivity": (3.42, 0.05)})
WIDER_CUTOFF = State(0.6061, 1.512, {"bulk_viscosity": (1.338, 0.535)}, cutoff=3.0)
LARGEST_ERROR = {"thermal_conductivity": 0.05, "bulk_viscosity": 0.15}  # as a fraction, in the long form


def check_state(ljmd: str, deck: pathlib.Path, state: State, cells: int, steps: int, is_long: bool) -> None:
    settings = {"system.density": state.density, "system.temperature": state.temperature, "system.lattice.cells": cells,
                "potential.cutoff": state.cutoff, "stage.equilibrate.temperature": state.temperature,
                "stage.melt.temperature": max(1.5, state.temperature), "stage.production.steps": steps}
    with tempfile.TemporaryDirectory() as folder:
        out = pathlib.Path(folder) / "run"
        changes = [word for key, value in settings.items() for word in ("--set", f"{key}={value}")]
        subprocess.run([ljmd, "run", str(deck), "--out", str(out), "--quiet", *changes], check=True)
        found = json.loads((out / "results.json").read_text())["observables"]
    print(f"rho = {state.density}, T = {found['temperature']['mean']:.4f}, {4 * cells ** 3} atoms, {steps} steps")
    for name, (value, error) in state.expected.items():
        mean, own = found[name]["mean"], found[name]["standard_error"]
        check(f"{name}, error {own:.3g}", mean, value, 3.0 * math.hypot(error, own))
        if is_long:
            check(f"{name}, error as a fraction", own / mean, 0.0, LARGEST_ERROR[name])


def main() -> int:
    parser = argparse.ArgumentParser()
    parser.add_argument("--ljmd", required=True)
    parser.add_argument("--deck", required=True, type=pathlib.Path)
    parser.add_argument("--long", action="store_true")
    arguments = parser.parse_args()
    for state in [TRIPLE_POINT, SUPERCRITICAL, WIDER_CUTOFF] if arguments.long else [TRIPLE_POINT]:
        check_state(arguments.ljmd, arguments.deck, state, 5 if arguments.long else 4,
                    700_000 if arguments.long else 100_000, arguments.long)
    return exit_code()


if __name__ == "__main__":
    sys.exit(main())
