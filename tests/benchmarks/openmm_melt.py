#!/usr/bin/env python3
"""The melt of workload.py in OpenMM, for openmm_program.py.

    openmm_melt.py START.npz STEPS THREADS     run it and print times and energies per atom, as JSON
    openmm_melt.py --identify                  print version and platform; fails where there is none

With sigma = 1 nm, epsilon = 1 kJ/mol and m = 1 u OpenMM's units are the reduced ones. The force is a NonbondedForce
without charges: for a Lennard-Jones fluid the CPU platform runs it several times faster than a CustomNonbondedForce.
"""

from __future__ import annotations

import json
import sys
import time

import numpy as np
import openmm
import workload
from openmm import unit

PLATFORM = "CPU"


def energies(context: openmm.Context, atoms: int) -> tuple[float, float]:
    """Potential and total energy per atom."""
    state = context.getState(getEnergy=True)
    potential = state.getPotentialEnergy().value_in_unit(unit.kilojoule_per_mole)
    kinetic = state.getKineticEnergy().value_in_unit(unit.kilojoule_per_mole)
    return potential / atoms, (potential + kinetic) / atoms


def make_context(start: dict[str, np.ndarray], threads: int) -> openmm.Context:
    system = openmm.System()
    force = openmm.NonbondedForce()
    force.setNonbondedMethod(openmm.NonbondedForce.CutoffPeriodic)
    force.setCutoffDistance(workload.CUTOFF)
    force.setUseSwitchingFunction(False)
    force.setUseDispersionCorrection(False)
    for _ in start["positions"]:
        system.addParticle(1.0)
        force.addParticle(0.0, 1.0, 1.0)
    system.addForce(force)
    system.setDefaultPeriodicBoxVectors(*np.diag(start["edges"]).tolist())
    integrator = openmm.VerletIntegrator(workload.TIME_STEP)
    platform = openmm.Platform.getPlatformByName(PLATFORM)
    context = openmm.Context(system, integrator, platform, {"Threads": str(threads)})
    context.setPositions(start["positions"])
    context.setVelocities(start["velocities"])
    return context


def run(start: dict[str, np.ndarray], steps: int, threads: int) -> dict[str, float]:
    atoms = len(start["positions"])
    context = make_context(start, threads)
    initial, _ = energies(context, atoms)
    began = time.perf_counter()
    for first in range(0, steps, workload.THERMO_EVERY):
        context.getIntegrator().step(min(workload.THERMO_EVERY, steps - first))
        potential, total = energies(context, atoms)
    seconds = time.perf_counter() - began
    return {"seconds": seconds, "potential_energy_initial": initial, "potential_energy_final": potential,
            "total_energy_final": total}


def main(arguments: list[str]) -> int:
    if arguments == ["--identify"]:
        openmm.Platform.getPlatformByName(PLATFORM)
        print(json.dumps({"version": openmm.version.version, "platform": PLATFORM}))
        return 0
    if len(arguments) != 3:
        print(__doc__)
        return 2
    print(json.dumps(run(dict(np.load(arguments[0])), int(arguments[1]), int(arguments[2]))))
    return 0


if __name__ == "__main__":
    sys.exit(main(sys.argv[1:]))
