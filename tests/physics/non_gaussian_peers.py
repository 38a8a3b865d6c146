"""The non-Gaussian parameter of Rahman's argon by this program and from trajectories of other programs, each from starts of its own.

Usage: non_gaussian_peers.py --ljmd PROGRAM [--lammps PROGRAM] [--seeds N]

By hand: ten minutes of a core. LAMMPS and OpenMM integrate, NumPy computes alpha_2 from their positions; errors are of blocks of 66 ps, five a
run. Rahman (1964, doi:10.1103/PhysRev.136.A405) found the maximum at 3.0 ps. Expected of each program: at all times within four errors of ours,
and its value at our largest within two errors of its own largest.
"""

import argparse
import csv
import math
import pathlib
import subprocess
import sys
import tempfile

import numpy as np

ROOT = pathlib.Path(__file__).resolve().parents[2]
sys.path.insert(0, str(ROOT / "tests"))
from figures import check, exit_code  # noqa: E402

PICOSECONDS = 2.1555  # of tau, for argon as the deck has it: 3.405 angstrom, 119.8 K, 39.948 u
ATOMS, DENSITY, TEMPERATURE, CUTOFF = 864, 0.8177, 0.788, 2.25
EVERY, STEP, LAGS = 20, 0.01 / PICOSECONDS, 22
BLOCKS, FRAMES = 5, 330  # of a run; of a block

LAMMPS = f"""
units lj
atom_style atomic
lattice fcc {DENSITY}
region box block 0 6 0 6 0 6
create_box 1 box
create_atoms 1 box
mass 1 1.0
velocity all create 2.0 {{seed}} mom yes
pair_style lj/cut {CUTOFF}
pair_coeff 1 1 1.0 1.0
neigh_modify delay 0 every 1
timestep {STEP}
fix motion all nve
fix melt all temp/rescale 20 2.0 2.0 0.0 1.0
run 1000
unfix melt
fix cool all temp/rescale 20 {TEMPERATURE} {TEMPERATURE} 0.0 1.0
run 4000
unfix cool
dump positions all custom {EVERY} positions.{{seed}} xu yu zu
dump_modify positions sort id format line "%.7g %.7g %.7g"
thermo_style custom step temp
thermo {EVERY}
run {EVERY * BLOCKS * FRAMES}
"""


def by_lammps(options: argparse.Namespace, seed: int, folder: pathlib.Path) -> tuple[float, np.ndarray]:
    """Mean temperature; unwrapped positions: frame, atom, axis."""
    script, dump = folder / f"in.{seed}", folder / f"positions.{seed}"
    script.write_text(LAMMPS.format(seed=seed))
    run = subprocess.run([options.lammps, "-in", script.name, "-log", "none"], check=True, capture_output=True, text=True, cwd=folder)
    thermo = run.stdout[run.stdout.rindex("Step Temp"):run.stdout.rindex("Loop time")].splitlines()[1:]
    with open(dump, encoding="ascii") as file:
        numbers = [line for line in file if not line.startswith("ITEM") and line.count(" ") == 2]
    dump.unlink()
    return float(np.mean([float(line.split()[1]) for line in thermo])), np.loadtxt(numbers).reshape(-1, ATOMS, 3)[1:]


def by_openmm(_options: argparse.Namespace, seed: int, _folder: pathlib.Path) -> tuple[float, np.ndarray]:
    """As by_lammps(). sigma = 1 nm, epsilon = 1 kJ/mol, m = 1 u, so that tau = 1 ps."""
    import openmm
    from openmm import unit

    edge = (ATOMS / DENSITY) ** (1 / 3)
    system, pairs = openmm.System(), openmm.NonbondedForce()
    system.setDefaultPeriodicBoxVectors(*(openmm.Vec3(*row) for row in np.diag([edge] * 3)))
    pairs.setNonbondedMethod(openmm.NonbondedForce.CutoffPeriodic)
    pairs.setCutoffDistance(CUTOFF)
    pairs.setUseDispersionCorrection(False)
    for _ in range(ATOMS):
        system.addParticle(1.0)
        pairs.addParticle(0.0, 1.0, 1.0)
    system.addForce(pairs)
    context = openmm.Context(system, openmm.VerletIntegrator(STEP), openmm.Platform.getPlatformByName("CPU"), {"Threads": "1"})
    corners = np.array([[0, 0, 0], [0, 1, 1], [1, 0, 1], [1, 1, 0]]) / 2
    context.setPositions([edge / 6 * (np.array([a, b, c]) + corner) for a in range(6) for b in range(6) for c in range(6) for corner in corners])
    degrees = 3 * ATOMS - 3

    def temperature() -> float:
        return 2.0 * context.getState(getEnergy=True).getKineticEnergy()._value / degrees

    def hold(wanted: float, steps: int) -> None:
        for _ in range(steps // EVERY):
            velocities = context.getState(getVelocities=True).getVelocities(asNumpy=True)._value
            context.setVelocities(velocities * math.sqrt(wanted / temperature()))
            context.getIntegrator().step(EVERY)

    start = np.random.default_rng(seed).normal(size=(ATOMS, 3))
    context.setVelocities(start - start.mean(axis=0))
    hold(2.0, 1000)
    hold(TEMPERATURE, 4000)
    temperatures, frames = [], []
    for _ in range(BLOCKS * FRAMES):
        context.getIntegrator().step(EVERY)
        temperatures.append(temperature())
        frames.append(context.getState(getPositions=True).getPositions(asNumpy=True).value_in_unit(unit.nanometer))  # not wrapped
    return float(np.mean(temperatures)), np.array(frames)


PEERS = {"LAMMPS": by_lammps, "OpenMM": by_openmm}


def alpha_2(frames: np.ndarray) -> np.ndarray:
    """At 1 to LAGS frames, over all origins."""
    found = []
    for lag in range(1, LAGS + 1):
        moved = frames[lag:] - frames[:-lag]
        squares = ((moved - moved.mean(axis=1, keepdims=True)) ** 2).sum(axis=2)
        found.append(0.6 * (squares**2).mean() / squares.mean() ** 2 - 1.0)
    return np.array(found)


def by_ljmd(program: str, folder: pathlib.Path) -> tuple[float, dict[float, tuple[float, float]]]:
    deck = (ROOT / "inputs/verlet1967/rahman-1964.toml").read_text()
    deck = deck[:deck.index("[output]")].replace("steps = 10000", "steps = 60000") + \
        f'[analysis]\nvan_hove = {{ every = {EVERY}, max_time = "4.4 ps" }}\n'
    (folder / "deck.toml").write_text(deck)
    subprocess.run([program, "run", "deck.toml", "--out", "run", "--quiet"], check=True, capture_output=True, cwd=folder)
    with open(folder / "run/alpha2.csv", encoding="utf-8", newline="") as file:
        rows = {float(row["time"]): (float(row["alpha_2"]), float(row["alpha_2_standard_error"])) for row in csv.DictReader(file)}
    with open(folder / "run/thermo.csv", encoding="utf-8", newline="") as file:
        temperatures = [float(row["temperature"]) for row in csv.DictReader(file) if int(row["step"]) > 4000]
    return float(np.mean(temperatures)), rows


def main() -> int:
    parser = argparse.ArgumentParser(description=__doc__, formatter_class=argparse.RawDescriptionHelpFormatter)
    parser.add_argument("--ljmd", required=True, type=lambda name: str(pathlib.Path(name).resolve()))
    parser.add_argument("--lammps", default="lmp")
    parser.add_argument("--seeds", type=int, default=4)
    options = parser.parse_args()
    with tempfile.TemporaryDirectory() as scratch:
        folder = pathlib.Path(scratch)
        temperature, ours = by_ljmd(options.ljmd, folder)
        values = [ours[time] for time in sorted(ours)][-LAGS:]
        at = [lag * EVERY * STEP * PICOSECONDS for lag in range(1, LAGS + 1)]
        largest = max(range(LAGS), key=lambda k: values[k][0])
        print(f"T {temperature:.4f}; largest alpha_2 {values[largest][0]:.4f} +- {values[largest][1]:.4f} at {at[largest]:.1f} ps; by Rahman at 3.0 ps")
        for name, peer in PEERS.items():
            runs = [peer(options, 1000 + seed, folder) for seed in range(options.seeds)]
            blocks = np.array([alpha_2(frames[k * FRAMES:(k + 1) * FRAMES]) for _, frames in runs for k in range(BLOCKS)])
            means, errors = blocks.mean(axis=0), blocks.std(axis=0, ddof=1) / math.sqrt(len(blocks))
            top = int(np.argmax(means))
            print(f"{name}: T {np.mean([one for one, _ in runs]):.4f}; largest alpha_2 {means[top]:.4f} +- {errors[top]:.4f} at {at[top]:.1f} ps")
            for k, (value, error) in enumerate(values):
                check(f"{name}, alpha_2 at {at[k]:.1f} ps", means[k], value, 4.0 * math.hypot(error, errors[k]))
            check(f"{name} where ours is largest", means[largest], means[top], 2.0 * errors[top])
    return exit_code()


if __name__ == "__main__":
    sys.exit(main())
