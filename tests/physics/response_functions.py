"""Response functions at three states, and in three ensembles, against equations of state; and the configurational temperature.

Usage: response_functions.py --ljmd PROGRAM [--scatter]

Three states, a liquid, a dense supercritical fluid and a gas, under a thermostat: the full fluid of Thol et al. (2016),
doi:10.1063/1.4945000, by a potential that goes smoothly to zero between 3.5 and 4, with tail corrections; it has no step at the cutoff,
whose term in u'' would have to be extrapolated. The formulas at constant energy and at constant pressure: the fluid truncated and shifted
at 2.5, which has an equation of its own, Thol et al. (2015), doi:10.1007/s10765-014-1764-4. An equation's derivatives are known to 1 to
2 %. Five runs, two to three minutes of one core.

--scatter (by hand, ten minutes of one core): 60 runs of each ensemble that differ in their seed. At constant energy they have the same
total energy, and so the same state. The scatter of each quantity over its reported error must lie between 0.7 and 1.32.
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

SEEDS = 60
LEAST, MOST = 0.7, 1.32
OF_EQUATION = 0.02  # relative error of a derivative of an equation of state

DECK = """
[system]
lattice = {{ type = "fcc", cells = {cells} }}
density = {density}
temperature = {temperature}
seed = {seed}

[potential]
type = "lennard-jones"
{potential}

[[stage]]
name = "melt"
time_step = 0.004
steps = 2000
temperature = {hot}
thermostat = {{ type = "stochastic-rescaling", time = 0.2 }}

[[stage]]
name = "equilibrate"
time_step = 0.004
steps = 4000
thermostat = {{ type = "stochastic-rescaling", time = 0.2 }}

[[stage]]
name = "production"
time_step = 0.004
steps = {steps}
sample = true
{ensemble}

[analysis]
response_functions = {{ every = {every} }}
configurational_temperature = {{ every = {every} }}
"""
SHIFTED = 'cutoff = 2.5\ntruncation = "shifted"'
SMOOTH = 'cutoff = 4.0\ntruncation = "switched"\nswitch_start = 3.5\ntail = true'
HELD = 'thermostat = { type = "stochastic-rescaling", time = 0.2 }'
# potential, equation, density, temperature, ensemble, steps, steps between looks
RUNS = ((SMOOTH, "thol2016", 0.8, 1.0, "constant temperature", 60_000, 25),
        (SMOOTH, "thol2016", 0.6, 2.0, "constant temperature", 100_000, 25),
        (SMOOTH, "thol2016", 0.1, 1.5, "constant temperature", 200_000, 50),
        (SHIFTED, "thol2015", 0.75, 1.2, "constant energy", 80_000, 20),
        (SHIFTED, "thol2015", 0.75, 1.2, "constant pressure", 80_000, 20))


def ensemble_of(name: str, equation: dict) -> str:
    """The lines of a stage in an ensemble at the state of an equation."""
    if name == "constant energy":
        return f"total_energy = {equation['potential_energy'] + 1.5 * equation['temperature']}"
    if name == "constant pressure":
        barostat = ('barostat = {{ type = "stochastic-cell-rescaling", pressure = {}, time = 1.0, compressibility = {}, every = 5 }}')
        return HELD + "\n" + barostat.format(equation["pressure"], 1.0 / (equation["density"] * equation["pressure_density_slope"]))
    return HELD


def observables(ljmd: str, **values) -> dict:
    """What a run finds."""
    with tempfile.TemporaryDirectory() as folder:
        deck = pathlib.Path(folder) / "deck.toml"
        deck.write_text(DECK.format(hot=2.0 * values["temperature"], **values))
        out = pathlib.Path(folder) / "run"
        subprocess.run([ljmd, "run", str(deck), "--out", str(out), "--quiet"], check=True, capture_output=True)
        return json.loads((out / "results.json").read_text())["observables"]


def equation_of_state(ljmd: str, model: str, density: float, temperature: float) -> dict:
    command = [ljmd, "eos", "--model", model, "--temperature", str(temperature), "--density", str(density), "--json"]
    return json.loads(subprocess.run(command, check=True, capture_output=True, text=True).stdout)


def responses_of(equation: dict) -> dict[str, float]:
    """By the names of the observables."""
    density, temperature = equation["density"], equation["temperature"]
    modulus = density * equation["pressure_density_slope"]
    slope = equation["pressure_temperature_slope"]
    sound = equation["speed_of_sound"]
    expansion = slope / modulus
    return {"isothermal_compressibility": 1.0 / modulus, "thermal_expansion": expansion, "thermal_pressure_coefficient": slope,
            "heat_capacity_cv": equation["heat_capacity_cv"], "heat_capacity_cp": equation["heat_capacity_cp"],
            "adiabatic_compressibility": 1.0 / (density * sound**2), "speed_of_sound": sound,
            "joule_thomson_coefficient": (temperature * expansion - 1.0) / (density * equation["heat_capacity_cp"])}


def check_state(ljmd: str, potential: str, model: str, density: float, temperature: float, ensemble: str, steps: int, every: int) -> None:
    """One run of 500 atoms beside the equation at its mean temperature and density."""
    target = equation_of_state(ljmd, model, density, temperature)
    found = observables(ljmd, cells=5, density=density, temperature=temperature, seed=1978, potential=potential, steps=steps, every=every,
                        ensemble=ensemble_of(ensemble, target))
    t = found["temperature"]["mean"]
    equation = equation_of_state(ljmd, model, found["density"]["mean"] if "density" in found else density, t)
    for name, expected in responses_of(equation).items():
        value = found[name]
        where = f"{ensemble}, rho {density}, T {temperature}: {name}"
        if value["mean"] is None:
            check(f"{where} has a value", 0, 1, 0)
            continue
        of_equation = OF_EQUATION * (abs(expected) if name != "joule_thomson_coefficient" else 1.0 / (density * equation["heat_capacity_cp"]))
        check(where, value["mean"], expected, 3.0 * math.hypot(value["standard_error"], of_equation))
        if name in ("isothermal_compressibility", "thermal_pressure_coefficient", "heat_capacity_cv", "speed_of_sound"):
            check(f"{where}, own error", value["standard_error"] / expected, 0.0, 0.2 if name == "isothermal_compressibility" else 0.05)
    conf = found["configurational_temperature"]
    check(f"{ensemble}, rho {density}, T {temperature}: T_conf", conf["mean"], t,
          5.0 * math.hypot(conf["standard_error"], found["temperature"]["standard_error"]) + 0.005 * t)


def check_scatter(ljmd: str, ensemble: str) -> None:
    """Every response function of 60 runs of 108 atoms."""
    target = equation_of_state(ljmd, "thol2015", 0.75, 1.2)
    runs = [observables(ljmd, cells=3, density=0.75, temperature=1.2, seed=seed, potential=SHIFTED, steps=50_000, every=10,
                        ensemble=ensemble_of(ensemble, target)) for seed in range(1, SEEDS + 1)]
    for name in (*responses_of(target), "configurational_temperature"):
        found = [run[name] for run in runs if run[name]["standard_error"] is not None]
        check(f"{ensemble}: runs with a value, in 60: {name}", len(found), SEEDS, SEEDS / 3)
        centre = sum(one["mean"] for one in found) / len(found)
        scatter = math.sqrt(sum((one["mean"] - centre) ** 2 for one in found) / (len(found) - 1))
        reported = math.sqrt(sum(one["standard_error"] ** 2 for one in found) / len(found))
        print(f"     mean {centre:.6g} +- {scatter / math.sqrt(len(found)):.2g}, error of one run {reported:.2g}")
        check(f"{ensemble}: scatter over the reported error: {name}", scatter / reported, 0.5 * (LEAST + MOST), 0.5 * (MOST - LEAST))


def main() -> int:
    parser = argparse.ArgumentParser()
    parser.add_argument("--ljmd", required=True)
    parser.add_argument("--scatter", action="store_true")
    arguments = parser.parse_args()
    if arguments.scatter:
        for ensemble in ("constant temperature", "constant energy", "constant pressure"):
            check_scatter(arguments.ljmd, ensemble)
    else:
        for run in RUNS:
            check_state(arguments.ljmd, *run)
    return exit_code()


if __name__ == "__main__":
    sys.exit(main())
