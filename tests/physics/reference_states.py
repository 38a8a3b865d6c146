"""ljmd reference against published simulations and equations of state, and the scatter of its values over their errors.

Usage: reference_states.py --ljmd PROGRAM [--folder DIR] [--jobs N] [--scatter SEEDS [--first-seed SEED] [--replicas N]]

By hand. Without --scatter (a quarter of an hour of two cores): twelve states with their default errors. Six have Monte Carlo values of 500
atoms with a cutoff of 3 and tail corrections, which a run of the same system corrects (cutoff_correction; at T 0.85, rho 0.82 by -0.003 in the
energy and -0.013 in the pressure): energies of FEASST (with its errors), pressures of the NIST Standard Reference Simulation
Website (https://mmlapps.nist.gov/srs/LJ_PURE/mc.htm; errors where they are known, else 1 % of the pressure and at least 0.005). The other
six have equations of state, Thol et al. (2016), doi:10.1063/1.4945000, and Kolafa and Nezbeda (1994), doi:10.1016/0378-3812(94)80001-4: their
difference counts as the error of both, and at least what Thol et al. state for theirs. Each value must lie within 3 errors, those of both
sides together.

--scatter 200 (an hour of one core): so many references of 108 atoms at each of three states, which differ in their seed. The scatter of energy
and pressure over the median of the statistical errors stated must lie between 0.83 and 1.17. The root mean square of the errors is told beside it:
where replicas happen to disagree, the error is that of their difference, with the factor of Student's distribution, which is large for two.

--folder keeps the runs: the same command goes on with what is there.
"""

import argparse
import json
import math
import pathlib
import statistics
import subprocess
import sys
import tempfile

sys.path.insert(0, str(pathlib.Path(__file__).resolve().parent.parent))
from figures import check, exit_code  # noqa: E402

# T, rho: energy with error, pressure with error, of Monte Carlo simulations.
PUBLISHED = {
    (0.85, 0.005): (-0.051854, 2.0e-5, 0.0041003, 5.05e-7),
    (0.85, 0.82): (-5.795079, 3.55e-4, 0.55355, None),
    (0.85, 0.86): (-6.03003, 5.49e-4, 1.266, 0.0136),
    (0.9, 0.009): (-0.089971, 3.9e-5, 0.0076363, None),
    (0.9, 0.776): (-5.468437, 3.0e-4, 0.24056, 0.00274),
    (0.9, 0.86): (-5.975214, 5.05e-4, 1.5781, None),
}
EQUATIONS = ((1.2, 0.7), (1.5, 0.1), (1.5, 0.6), (2.5, 0.4), (4.0, 0.8), (6.0, 0.3))
OF_ENERGY, OF_PRESSURE = 0.001, 0.005  # relative, of rho T for the pressure: what the authors of the equation state
SCATTERED = {(1.2, 0.7): 0.0168, (2.5, 0.4): 0.0096, (2.0, 0.1): 0.008}  # the error of the energy asked for
LARGEST_DIFFERENCE = 0.17


def reference(options, temperature, density, out, *arguments):
    command = [options.ljmd, "reference", "--temperature", str(temperature), "--density", str(density), "--out", str(out), "--json", "--quiet",
               "--jobs", str(options.jobs), *arguments]
    return json.loads(subprocess.run(command, check=True, capture_output=True, text=True).stdout)


MONTE_CARLO = """
[system]
lattice = {{ type = "fcc", cells = 5 }}
density = {density}
temperature = {temperature}

[potential]
type = "lennard-jones"
cutoff = 3.0
truncation = "cut"
tail = true

[[stage]]
name = "melt"
time_step = 0.004
steps = 1500
temperature = 3.0
thermostat = {{ type = "langevin", time = 0.2 }}

[[stage]]
name = "equilibrate"
time_step = 0.005
steps = 4000
thermostat = {{ type = "langevin" }}

[[stage]]
name = "production"
time_step = 0.005
steps = 100000
sample = true
thermostat = {{ type = "langevin" }}

[output]
directory = "{out}"

[analysis]
cutoff_correction = {{ every = 50 }}
"""


def cutoff_of_three(options, temperature, density, out):
    """What a cutoff of 3 with tail corrections does to 500 atoms: to be added to energy and pressure, with errors."""
    results = out / "results.json"
    if not results.exists():
        deck = out.parent / f"{out.name}.toml"
        deck.write_text(MONTE_CARLO.format(temperature=temperature, density=density, out=out), encoding="utf-8")
        subprocess.run([options.ljmd, "run", deck, "--quiet", "--force"], check=True, capture_output=True)
    found = json.loads(results.read_text(encoding="utf-8"))["observables"]
    return [found[name][key] for name in ("cutoff_energy", "cutoff_pressure") for key in ("mean", "standard_error")]


def judge(state, name, value, other, error):
    mean, total = value["mean"], value["total_error"]
    off = (mean - other) / math.hypot(total, error)
    print(f"  T {state[0]:<5} rho {state[1]:<6} {name:<17} {mean:12.6f}  statistical {value['statistical_error']:.2g}"
          f"  systematic {value['systematic_error']:.2g}  other {other:.6f} +- {error:.2g}: {off:+.2f}", flush=True)
    check(f"{name} at T {state[0]}, rho {state[1]}, in errors", abs(off), 0.0, 3.0)


def states(options, folder):
    for state in (*PUBLISHED, *EQUATIONS):
        found = reference(options, *state, folder / f"T{state[0]}-rho{state[1]}")
        energy, pressure = found["potential_energy"], found["pressure"]
        if state in PUBLISHED:
            u, u_error, p, p_error = PUBLISHED[state]
            du, du_error, dp, dp_error = cutoff_of_three(options, *state, folder / f"cutoff-3-T{state[0]}-rho{state[1]}")
            judge(state, "energy", energy, u + du, math.hypot(u_error, du_error))
            p_error = p_error if p_error is not None else max(0.01 * p, 0.005 * state[0] * state[1])
            judge(state, "pressure", pressure, p + dp, math.hypot(p_error, dp_error))
            continue
        for name, value, least in (("energy", energy, OF_ENERGY * abs(energy["equation_of_state"])),
                                   ("pressure", pressure, OF_PRESSURE * state[0] * state[1])):
            thol, kolafa = (value["equations_of_state"][each] for each in ("thol2016", "kolafa-nezbeda1994"))
            judge(state, name, value, thol, max(abs(thol - kolafa), least))


def scatter(options, folder):
    for state, error in SCATTERED.items():
        errors = {"potential_energy": [], "pressure": []}
        for seed in range(options.first_seed, options.first_seed + options.scatter):
            found = reference(options, *state, folder / f"scatter-T{state[0]}-rho{state[1]}-{seed}", "--atoms", "108",
                              "--replicas", str(options.replicas), "--seed", str(seed), "--error", f"energy={error:g}")
            for name, values in errors.items():
                values.append((found[name]["mean"], found[name]["statistical_error"]))
        for name, values in errors.items():
            mean = sum(value for value, _ in values) / len(values)
            scatter_of = statistics.stdev(value for value, _ in values)
            stated = statistics.median(error for _, error in values)
            root_mean_square = math.sqrt(statistics.fmean(error**2 for _, error in values))
            covered = sum(abs(value - mean) < error for value, error in values) / len(values)
            print(f"  T {state[0]:<5} rho {state[1]:<6} {name:<17} mean {mean:.5f}  scatter {scatter_of:.3g}  over the median error "
                  f"{scatter_of / stated:.2f}, over the root mean square {scatter_of / root_mean_square:.2f}  covers {covered:.0%}", flush=True)
            check(f"scatter over error of {name} at T {state[0]}, rho {state[1]}", scatter_of / stated, 1.0, LARGEST_DIFFERENCE)


def main():
    parser = argparse.ArgumentParser(description=__doc__.splitlines()[0])
    parser.add_argument("--ljmd", required=True)
    parser.add_argument("--folder", type=pathlib.Path)
    parser.add_argument("--jobs", type=int, default=2)
    parser.add_argument("--scatter", type=int, default=0, metavar="SEEDS")
    parser.add_argument("--first-seed", type=int, default=1, metavar="SEED")
    parser.add_argument("--replicas", type=int, default=4, help="of each reference of --scatter")
    options = parser.parse_args()
    with tempfile.TemporaryDirectory() as temporary:
        folder = options.folder or pathlib.Path(temporary)
        if options.scatter > 0:
            scatter(options, folder)
        else:
            states(options, folder)
    return exit_code()


if __name__ == "__main__":
    sys.exit(main())
