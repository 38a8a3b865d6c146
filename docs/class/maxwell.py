"""Exercise 2: Maxwell's distribution in a gas and in a liquid, and how a gas comes to it.

    tools/python docs/class/maxwell.py runs/maxwell runs/maxwell-liquid runs/equal-speeds runs/equal-speeds-liquid
"""

import math
import pathlib
import sys

import numpy as np
from classroom import answer, mean, plt, save

import ljmd


def speeds_of(directory) -> tuple:
    """Speeds in units of the most probable one, sqrt(2 T), an array for each frame; and the times of the frames."""
    run = ljmd.open(directory)
    frames = run.frames()
    sampled = frames.steps > sum(stage["steps"] for stage in run.stages[:-1])
    v = np.linalg.norm(frames.velocities[sampled], axis=2)
    return v / np.sqrt(2 * run["temperature"].mean), frames.times[sampled]


def excess(v) -> np.ndarray:
    """a = (3/5) <v^4>/<v^2>^2 - 1 of each frame: 0 for Maxwell's distribution, -2/5 for equal speeds."""
    return 0.6 * (v**4).mean(axis=-1) / (v**2).mean(axis=-1)**2 - 1


def maxwell(x):
    """Probability density of the speed in units of sqrt(2 T)."""
    return 4 / np.sqrt(np.pi) * x**2 * np.exp(-x**2)


def relaxation_time(t, a, atoms: int) -> tuple:
    """tau of the curve -(2/5) exp(-t/tau) that is nearest to a(t), and its standard error.

    a fluctuates by s = (8/15/atoms)^(1/2) and forgets its fluctuations in about tau, too.
    """
    tried = np.geomspace(0.01, 20, 4000)
    tau = tried[np.argmin([((a + 0.4 * np.exp(-t / each))**2).sum() for each in tried])]
    return tau, tau * np.sqrt(8 / 15 / atoms) / 0.4 * 2


gas, liquid, equal, equal_liquid = map(pathlib.Path, sys.argv[1:])
answer("Maxwell: mean speed / sqrt(2 T)", 2 / math.sqrt(math.pi))
answer("Maxwell: faster than 2 sqrt(2 T), per cent", 100 * (math.erfc(2) + 4 / math.sqrt(math.pi) * math.exp(-4)))
figure, (left, right) = plt.subplots(1, 2, figsize=(9, 4), constrained_layout=True)
x = np.linspace(0, 3, 200)
left.plot(x, maxwell(x), color="k", label="Maxwell")
for name, directory in ("gas", gas), ("liquid", liquid):
    v, _ = speeds_of(directory)
    answer(f"{name}: mean speed / sqrt(2 T)", *mean(v.mean(axis=1), len(v)))
    answer(f"{name}: faster than 2 sqrt(2 T), per cent", *mean(100 * (v > 2).mean(axis=1), len(v)))
    answer(f"{name}: excess a", *mean(excess(v), len(v)))
    histogram, edges = np.histogram(v, bins=60, range=(0, 3), density=True)
    left.plot((edges[1:] + edges[:-1]) / 2, histogram, ".", label=name)
left.set(xlabel=r"$v / \sqrt{2T}$", ylabel="probability density", xlim=(0, 3), ylim=(0, None))
left.legend()

T, rho = ljmd.open(gas)["temperature"].mean, 0.05
viscosity = 5 / 16 * math.sqrt(T / math.pi) / 1.314  # Chapman and Enskog; 1.314 is their collision integral at T = 1.5
expected = 1.5 * viscosity / (rho * T)
answer("gas: most probable speed / (sigma/tau)", math.sqrt(2 * T))
answer("the same of argon, m/s", 157.9 * math.sqrt(2 * T))
answer("mean free time of spheres of diameter sigma", 1 / (math.sqrt(2) * math.pi * rho * math.sqrt(8 * T / math.pi)))
answer("Chapman and Enskog: relaxation time 3 eta/(2 p)", expected)
for name, directory, longest in ("gas", equal, 8.0), ("liquid", equal_liquid, 0.25):
    v, t = speeds_of(directory)
    a = excess(v)
    answer(f"{name}: relaxation time of a", *relaxation_time(t[t < longest], a[t < longest], len(v[0])))
    right.plot(t, a, label=name)
t = np.linspace(0, 10, 200)
right.plot(t, -0.4 * np.exp(-t / expected), color="k", lw=1, label="Chapman and Enskog")
right.axhline(0, color="0.6", lw=0.8)
right.set(xlabel=r"$t$ / $\tau$", ylabel=r"$a(t)$", xlim=(0, 10))
right.legend()
save(figure, gas / "maxwell.png")
