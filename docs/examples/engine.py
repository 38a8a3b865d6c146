"""A Lennard-Jones engine of one page: ljmd compare DECK --with command:'python3 engine.py {input} {output}'"""
import json
import sys

import numpy as np

problem_directory, answer_directory = sys.argv[1:3]
with open(f"{problem_directory}/problem.json", encoding="utf-8") as file:
    problem = json.load(file)
start = np.loadtxt(f"{problem_directory}/start.xyz", skiprows=2, usecols=range(1, 7))  # positions, velocities
potential, n, edges = problem["potential"], problem["atoms"], np.array(problem["box_edges"])
cutoff, volume, (first, second) = potential["cutoff"], np.prod(edges), np.triu_indices(n, 1)
lattice = " 0 0 0 ".join(map(str, edges))


def evaluate(r):
    """U with its tail, W = sum of r . f over pairs, and the forces."""
    d = r[first] - r[second]
    d -= edges * np.round(d / edges)
    near = np.sum(d * d, axis=1) < cutoff**2
    d, i, j = d[near], first[near], second[near]
    s2 = 1 / np.sum(d * d, axis=1)
    f = (24 * (2 * s2**6 - s2**3) * s2)[:, None] * d
    forces = np.stack([np.bincount(i, f[:, k], n) - np.bincount(j, f[:, k], n) for k in range(3)], axis=1)
    shift = 4 * (cutoff**-12 - cutoff**-6) if potential["truncation"] == "shifted" else 0
    u = np.sum(4 * (s2**6 - s2**3) - shift)
    return u + n * potential["tail_energy_per_atom"], np.sum(f * d), forces


def thermodynamics(u, w, v):
    k = 0.5 * np.sum(v**2)
    return {"potential_energy": u, "kinetic_energy": k, "temperature": 2 * k / (3 * n - 3),
            "pressure": (2 * k + w) / (3 * volume) + potential["tail_pressure"]}


def velocity_verlet(steps, dt):
    """Yields step, U, W, positions, velocities and forces; those of the start first."""
    r, v = start[:, :3], start[:, 3:]
    u, w, f = evaluate(r)
    for step in range(steps + 1):
        yield step, u, w, r, v, f
        v = v + 0.5 * dt * f
        r = r + dt * v
        u, w, f = evaluate(r)
        v = v + 0.5 * dt * f


frames, run = problem["trajectory"]["frames"], problem["run"]
thermo, xyz = (open(f"{answer_directory}/{name}", "w", encoding="utf-8") for name in ("thermo.csv", "frames.xyz"))
for step, u, w, r, v, f in velocity_verlet(max(run["steps"], *frames), run["time_step"]):
    row = thermodynamics(u, w, v)
    if step == 0:
        with open(f"{answer_directory}/point.json", "w", encoding="utf-8") as file:
            json.dump({"engine": "one page of Python", **row, "virial": w, "forces": f.tolist()}, file)
        print("step", *row, sep=",", file=thermo)
    if step % run["thermo_every"] == 0 and step <= run["steps"]:
        print(step, *row.values(), sep=",", file=thermo)
    if step in frames:
        print(f'{n}\nLattice="{lattice}" Properties=species:S:1:pos:R:3:velo:R:3:forces:R:3 step={step}', file=xyz)
        np.savetxt(xyz, np.hstack([r, v, f]), fmt="X" + 9 * " %.17g")
