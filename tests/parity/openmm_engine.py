"""OpenMM's Reference platform as an engine: openmm_engine.py PROBLEM ANSWER. Lennard-Jones, cut or shifted by nothing."""

import json
import sys

import numpy as np
import openmm
from openmm import unit

problem_directory, answer_directory = sys.argv[1:3]
with open(f"{problem_directory}/problem.json", encoding="utf-8") as file:
    problem = json.load(file)
assert problem["potential"]["truncation"] == "cut"
start = np.loadtxt(f"{problem_directory}/start.xyz", skiprows=2, usecols=range(1, 7))
edges, n, cutoff, dt = problem["box_edges"], problem["atoms"], problem["potential"]["cutoff"], problem["run"]["time_step"]
MOVING, VIRIAL = 0, 1  # groups of forces


def system_of(problem):
    """sigma = 1 nm, epsilon = 1 kJ/mol, m = 1 u, so that tau = 1 ps."""
    system = openmm.System()
    system.setDefaultPeriodicBoxVectors(*(openmm.Vec3(*row) for row in np.diag(edges)))
    pairs = openmm.NonbondedForce()
    pairs.setNonbondedMethod(openmm.NonbondedForce.CutoffPeriodic)
    pairs.setCutoffDistance(cutoff)
    pairs.setUseDispersionCorrection(problem["potential"]["tail"])
    # The energy of this force, which moves nothing, is W.
    virial = openmm.CustomNonbondedForce("24*(2*r^-12-r^-6)")
    virial.setNonbondedMethod(openmm.CustomNonbondedForce.CutoffPeriodic)
    virial.setCutoffDistance(cutoff)
    virial.setForceGroup(VIRIAL)
    for _ in range(n):
        system.addParticle(1.0)
        pairs.addParticle(0.0, 1.0, 1.0)
        virial.addParticle([])
    system.addForce(pairs)
    system.addForce(virial)
    return system


integrator = openmm.VerletIntegrator(dt)
integrator.setIntegrationForceGroups({MOVING})
context = openmm.Context(system_of(problem), integrator, openmm.Platform.getPlatformByName("Reference"))
context.setPositions(start[:, :3])


def look():
    """Row of the table, W, positions, velocities at the time of the positions, forces."""
    state = context.getState(getEnergy=True, getForces=True, getPositions=True, getVelocities=True, groups={MOVING})
    kilojoule = unit.kilojoule_per_mole
    u = state.getPotentialEnergy().value_in_unit(kilojoule)
    w = context.getState(getEnergy=True, groups={VIRIAL}).getPotentialEnergy().value_in_unit(kilojoule)
    r = state.getPositions(asNumpy=True).value_in_unit(unit.nanometer)
    f = state.getForces(asNumpy=True).value_in_unit(kilojoule / unit.nanometer)
    v = state.getVelocities(asNumpy=True).value_in_unit(unit.nanometer / unit.picosecond) + 0.5 * dt * f
    k = 0.5 * np.sum(v**2)
    row = {"potential_energy": u, "kinetic_energy": k, "temperature": 2 * k / (3 * n - 3),
           "pressure": (2 * k + w) / (3 * np.prod(edges)) + problem["potential"]["tail_pressure"]}
    return row, w, r, v, f


forces = context.getState(getForces=True, groups={MOVING}).getForces(asNumpy=True)
context.setVelocities(start[:, 3:] - 0.5 * dt * forces.value_in_unit(unit.kilojoule_per_mole / unit.nanometer))
frames, run = problem["trajectory"]["frames"], problem["run"]
lattice = " 0 0 0 ".join(map(str, edges))
with open(f"{answer_directory}/frames.xyz", "w", encoding="utf-8") as xyz, \
        open(f"{answer_directory}/thermo.csv", "w", encoding="utf-8") as thermo:
    for step in range(max(run["steps"], *frames) + 1):
        row, w, r, v, f = look()
        if step == 0:
            print("step", *row, sep=",", file=thermo)
            with open(f"{answer_directory}/point.json", "w", encoding="utf-8") as file:
                json.dump({"engine": f"OpenMM {openmm.version.version}, Reference", **row, "virial": w, "forces": f.tolist()}, file)
        if step % run["thermo_every"] == 0 and step <= run["steps"]:
            print(step, *row.values(), sep=",", file=thermo)
        if step in frames:
            print(f'{n}\nLattice="{lattice}" Properties=species:S:1:pos:R:3:velo:R:3:forces:R:3 step={step}', file=xyz)
            np.savetxt(xyz, np.hstack([r, v, f]), fmt="X" + 9 * " %.17g")
        integrator.step(1)
