"""Exercise 4: what the time step does to the energy, and to what is measured.

    tools/python docs/class/time_step.py runs/time-step-sweep
"""

import pathlib
import sys

import numpy as np
from classroom import answer, columns_of_stages, plt, save

import ljmd


def energies(point) -> tuple:
    """Standard deviation of the total energy per atom about a straight line, and the slope of the line, in the production stage."""
    t, E = columns_of_stages(point.run, "time", "total_energy")["production"]
    slope, start = np.polyfit(t - t[0], E, 1)
    return np.std(E - start - slope * (t - t[0])), slope


directory = pathlib.Path(sys.argv[1])
found = {}
for point in ljmd.open_sweep(directory):
    integrator, dt = point.values["stage.production.integrator"], point.values["stage.production.time_step"]
    found.setdefault(integrator, []).append((dt, *energies(point), point.run.stages[-1].get("time_step_error")))
found = {integrator: np.array(sorted(rows), float) for integrator, rows in found.items()}

for integrator in ("velocity-verlet", "forest-ruth"):
    dt, ripple, slope, _ = found[integrator].T
    small = (dt > 0.0015) & (dt < 0.01)
    order = np.polyfit(np.log(dt[small]), np.log(ripple[small]), 1)[0]
    answer(f"{integrator}: order of the ripple", order)
    for row in found[integrator]:
        answer(f"{integrator}: ripple at dt = {row[0]:.3f}", row[1])
dt, ripple = found["forest-ruth"].T[:2]
answer("forest-ruth: ripple at dt = 0.003 from that at 0.004", 0.75**4 * ripple[dt == 0.004][0])
for row in found["velocity-verlet"]:
    answer(f"velocity-verlet: time_step_error at dt = {row[0]:.3f}, per cent", 100 * row[3])
for row in found["euler"]:
    answer(f"euler: gain of energy per tau at dt = {row[0]:g}", row[2])

for r in 2**(1 / 6), 0.9:
    w = np.sqrt(2 * 4 * (156 * r**-14 - 42 * r**-8))  # two atoms: twice the curvature of the potential, over the mass
    answer(f"w of two atoms at r = {r:.3g}", w)
    answer(f"2/w of two atoms at r = {r:.3g}", 2 / w)

figure, axes = plt.subplots(figsize=(7, 4.5), constrained_layout=True)
for integrator in ("velocity-verlet", "forest-ruth"):
    axes.loglog(*found[integrator].T[:2], "o-", label=integrator)
axes.set(xlabel=r"time step / $\tau$", ylabel=r"standard deviation of $E/N$ / $\epsilon$")
axes.legend()
save(figure, directory / "ripple.png")
