"""Python's OpenMM loads what `ljmd export RUNDIR --to openmm` writes, and continues it as ljmd does.

Usage: openmm_python.py --ljmd PROGRAM

A liquid is exported and loaded as the program's message says. Energies must be those of ljmd at once, positions after
100 steps those of ljmd's leapfrog. Velocities of a VerletIntegrator belong to half a step earlier: a control starts
with those of the same time and must be seen to go elsewhere.

Exit codes: 0 all is well, 1 it is not, 77 this Python has no OpenMM (1 with LJMD_REQUIRE_PEERS=1 in the environment).
"""

import argparse
import json
import os
import pathlib
import subprocess
import sys
import tempfile

import numpy as np

try:
    import openmm
    from openmm import unit
    MISSING = None
except ImportError:
    try:  # 7.5 and older
        from simtk import openmm, unit
        MISSING = None
    except ImportError as error:
        MISSING = error

SKIPPED = 77
TIME_STEP = 0.004
STEPS = 100
# Measured: 6e-15, 1e-15, 3e-13; control 2e-2.
POTENTIAL_ENERGY, KINETIC_ENERGY = 1e-13, 1e-12  # relative
DISTANCE = 1e-11  # [sigma]
CONTROL = 1e-5


def at_temperature(temperature: float) -> str:
    return f"""
[[stage]]
name = "at {temperature}"
time_step = {TIME_STEP}
steps = 1000
temperature = {temperature}
thermostat = {{ type = "rescale", every = 20 }}
"""


LIQUID = """
[system]
lattice = { type = "fcc", cells = 4 }
density = 0.8442
temperature = 0.722
seed = 12
""" + at_temperature(1.5) + at_temperature(0.722) + f"""
[[stage]]
name = "production"
time_step = {TIME_STEP}
steps = 100
"""
NEXT = f"""
[system]
file = "liquid"
[[stage]]
name = "next"
integrator = "leapfrog"
time_step = {TIME_STEP}
steps = {STEPS}
"""
POTENTIALS = {
    "cut with tail": """
[potential]
type = "lennard-jones"
cutoff = 2.5
truncation = "cut"
tail = true
""",
    "force-shifted": """
[potential]
type = "lennard-jones"
cutoff = 2.5
truncation = "force-shifted"
""",
}

passed = 0
failures = 0


def check(name: str, good: bool, detail: str) -> None:
    global passed, failures
    print(f"{'ok  ' if good else 'FAIL'} {name}: {detail}")
    passed += good
    failures += not good


def at_most(name: str, value: float, limit: float) -> None:
    check(name, value <= limit, f"{value:.2e}, at most {limit:.0e}")


class Folder:
    """Where ljmd runs."""

    def __init__(self, path: pathlib.Path, ljmd: str) -> None:
        self.path = path
        self.ljmd = ljmd

    def run(self, deck: str, name: str, *settings: str) -> None:
        (self.path / f"{name}.toml").write_text(deck)
        self.call("run", f"{name}.toml", "--out", name, *settings)

    def call(self, *arguments: str) -> None:
        done = subprocess.run([self.ljmd, *arguments, "--quiet"], cwd=self.path, capture_output=True, text=True)
        if done.returncode != 0:  # what else it says on stderr is that such short runs have no error bars
            raise RuntimeError(f"ljmd {' '.join(arguments)}: exit code {done.returncode}\n{done.stderr}")

    def energies(self, name: str) -> tuple[float, float]:
        """Potential and kinetic energy an atom, tail included."""
        found = json.loads((self.path / name / "results.json").read_text())["observables"]
        return found["potential_energy"]["mean"], found["kinetic_energy"]["mean"]

    def final(self, name: str) -> tuple[np.ndarray, np.ndarray]:
        """Positions and velocities at the end of a run, by id."""
        lines = (self.path / name / "final.xyz").read_text().splitlines()
        if "pos:R:3:velo:R:3:momenta:R:3:id:I:1" not in lines[1]:
            raise ValueError(f"final.xyz of {name} has other columns: {lines[1]}")
        rows = np.array([line.split()[1:] for line in lines[2:]], float)
        rows = rows[np.argsort(rows[:, 9])]
        return rows[:, :3], rows[:, 3:6]


def load(folder: pathlib.Path) -> "openmm.Context":
    """As the message of `ljmd export` says, on the platform that computes in double precision."""
    system, state, integrator = (openmm.XmlSerializer.deserialize((folder / f"{name}.xml").read_text())
                                 for name in ("system", "state", "integrator"))
    context = openmm.Context(system, integrator, openmm.Platform.getPlatformByName("Reference"))
    context.setState(state)
    return context


def energies(context: "openmm.Context") -> tuple[float, float]:
    state = context.getState(getEnergy=True)
    atoms = context.getSystem().getNumParticles()
    return (state.getPotentialEnergy().value_in_unit(unit.kilojoule_per_mole) / atoms,
            state.getKineticEnergy().value_in_unit(unit.kilojoule_per_mole) / atoms)


def furthest(context: "openmm.Context", positions: np.ndarray) -> float:
    """The largest distance of an atom from where ljmd has it, as periodic images: what is exported is wrapped."""
    state = context.getState(getPositions=True)
    edges = np.diag(state.getPeriodicBoxVectors(asNumpy=True).value_in_unit(unit.nanometer))
    difference = state.getPositions(asNumpy=True).value_in_unit(unit.nanometer) - positions
    return float(np.linalg.norm(difference - edges * np.round(difference / edges), axis=1).max())


def compare(name: str, potential: str, folder: Folder) -> None:
    folder.run(LIQUID + potential, "liquid")
    folder.run(NEXT + potential, "at-once", "--set", "stage.next.steps=0")
    folder.run(NEXT + potential, "continued")
    folder.call("export", "liquid", "--to", "openmm", "--out", "exported")

    start, velocities = folder.final("liquid")
    end, _ = folder.final("continued")
    moved = np.linalg.norm(end - start, axis=1).max()
    check(f"{name}: atoms move", moved > 0.1, f"up to {moved:.2f}, above 0.1")

    context = load(folder.path / "exported")
    at_most(f"{name}: positions that are loaded", furthest(context, start), 1e-14)
    for kind, ours, theirs, limit in zip(("potential", "kinetic"), folder.energies("at-once"), energies(context),
                                         (POTENTIAL_ENERGY, KINETIC_ENERGY)):
        at_most(f"{name}: {kind} energy", abs(theirs / ours - 1.0), limit)
    context.getIntegrator().step(STEPS)
    at_most(f"{name}: positions after {STEPS} steps", furthest(context, end), DISTANCE)

    control = load(folder.path / "exported")
    control.setVelocities(velocities)
    control.getIntegrator().step(STEPS)
    apart = furthest(control, end)
    check(f"{name}: velocities not shifted are seen", apart > CONTROL, f"{apart:.2e}, above {CONTROL:.0e}")


def main() -> int:
    parser = argparse.ArgumentParser()
    parser.add_argument("--ljmd", required=True)
    arguments = parser.parse_args()
    if MISSING is not None:
        required = os.environ.get("LJMD_REQUIRE_PEERS") == "1"
        verdict = "FAIL, as LJMD_REQUIRE_PEERS=1" if required else "skipped"
        print(f"{verdict}: {sys.executable} has no OpenMM: {MISSING}")
        return 1 if required else SKIPPED
    for name, potential in POTENTIALS.items():
        with tempfile.TemporaryDirectory() as temporary:
            compare(name, potential, Folder(pathlib.Path(temporary), str(pathlib.Path(arguments.ljmd).resolve())))
    print(f"{passed} passed, {failures} failed")
    return 1 if failures else 0


if __name__ == "__main__":
    sys.exit(main())
