"""A Lennard-Jones engine of one page, for ljmd compare --with command:'python3 engine.py {input} {output}'."""
import json
import sys

import numpy as np

problem_directory, answer_directory = sys.argv[1:3]
with open(f"{problem_directory}/problem.json", encoding="utf-8") as file:
    problem = json.load(file)
start = np.loadtxt(f"{problem_directory}/start.xyz", skiprows=2, usecols=range(1, 7))
edges, potential = np.array(problem["box_edges"]), problem["potential"]
cutoff, n, volume = potential["cutoff"], problem["atoms"], np.prod(edges)
first, second = np.triu_indices(n, 1)


def evaluate(r):
    """U with its tail, W = sum of r . f, and the forces."""
    d = r[first] - r[second]
    d -= edges * np.round(d / edges)
    near = np.einsum("ij,ij->i", d, d) < cutoff**2
    d, i, j = d[near], first[near], second[near]
    s6 = np.einsum("ij,ij->i", d, d) ** -3
    f = (24 * (2 * s6**2 - s6) * np.cbrt(s6))[:, None] * d
    forces = np.stack([np.bincount(i, f[:, k], n) - np.bincount(j, f[:, k], n) for k in range(3)], axis=1)
    u = 4 * np.sum(s6**2 - s6)
    if potential["truncation"] == "shifted":
        u -= len(i) * 4 * (cutoff**-12 - cutoff**-6)
    return u + n * potential["tail_energy_per_atom"], np.sum(f * d), forces


def kinetic(v):
    return 0.5 * np.sum(v**2)


def pressure(v, w):
    return (2 * kinetic(v) + w) / (3 * volume) + potential["tail_pressure"]


def velocity_verlet(steps):
    """Yields step, U, W, positions, velocities, forces; the start first."""
    r, v, dt = start[:, :3].copy(), start[:, 3:].copy(), problem["trajectory"]["time_step"]
    u, w, f = evaluate(r)
    for step in range(steps + 1):
        yield step, u, w, r, v, f
        v = v + 0.5 * dt * f
        r = r + dt * v
        u, w, f = evaluate(r)
        v = v + 0.5 * dt * f


u, w, f = evaluate(start[:, :3])
k = kinetic(start[:, 3:])
with open(f"{answer_directory}/point.json", "w", encoding="utf-8") as file:
    json.dump({"engine": "one page of Python", "potential_energy": u, "kinetic_energy": k, "virial": w,
               "temperature": 2 * k / (3 * n - 3), "pressure": pressure(start[:, 3:], w), "forces": f.tolist()}, file)
frames, run = set(problem["trajectory"]["frames"]), problem["run"]
with open(f"{answer_directory}/frames.xyz", "w", encoding="utf-8") as xyz, \
        open(f"{answer_directory}/thermo.csv", "w", encoding="utf-8") as thermo:
    thermo.write("step,potential_energy,kinetic_energy,temperature,pressure\n")
    for step, u, w, r, v, f in velocity_verlet(max(run["steps"], *frames)):
        if step in frames:
            xyz.write(f'{n}\nLattice="{edges[0]} 0 0 0 {edges[1]} 0 0 0 {edges[2]}" step={step} '
                      "Properties=species:S:1:pos:R:3:velo:R:3:forces:R:3\n")
            np.savetxt(xyz, np.hstack([r, v, f]), fmt="X" + 9 * " %.17g")
        if step % run["thermo_every"] == 0 and step <= run["steps"]:
            k = kinetic(v)
            thermo.write(f"{step},{u},{k},{2 * k / (3 * n - 3)},{pressure(v, w)}\n")
