"""Exercise 5: g(r) and S(k) of a gas, a liquid and a crystal, and where a liquid freezes.

    tools/python docs/class/structure.py runs/gas runs/liquid runs/crystal runs/freezing
"""

import pathlib
import sys

import numpy as np
from classroom import answer, first_minimum, plt, save

import ljmd


def table(run, name, *columns) -> list:
    return [np.asarray(run.table(name)[column]) for column in columns]


def g_peak(r, g) -> tuple:
    """Place and height of the highest point of g, by a parabola through it and its neighbours."""
    k = int(np.argmax(g))
    a, b, c = np.polyfit(r[k - 1:k + 2] - r[k], g[k - 1:k + 2], 2)
    return r[k] - b / (2 * a), c - b**2 / (4 * a)


def S_peak(k, S, vectors) -> tuple:
    """Height of the first peak of S and its standard error, by a parabola through the shells near its highest point.

    Shells with many wave vectors count for more.
    """
    top = k[np.argmax(np.where(vectors > 20, S, 0))]
    near = np.abs(k - top) < 0.6
    (a, b, c), covariance = np.polyfit(k[near] - top, S[near], 2, w=np.sqrt(vectors[near]), cov=True)
    return c - b**2 / (4 * a), np.sqrt(covariance[2, 2])


def compressibility(T: float, rho: float, cutoff: float | None = None) -> float:
    """T/(dp/drho) by the equation of state: of the full fluid, or of one whose forces end at the cutoff.

    Forces beyond it add p = (16 pi/3) rho^2 [(2/3)/cutoff^9 - 1/cutoff^3] to the pressure, where g = 1, and 2 p/rho to its slope.
    """
    slope = ljmd.eos(T, rho).pressure_density_slope
    if cutoff is not None:
        slope -= 2 * 16 * np.pi / 3 * rho * (2 / 3 / cutoff**9 - 1 / cutoff**3)
    return T / slope


def u(r):
    return 4 * (r**-12.0 - r**-6.0)


def fall(k, T: float, rho: float, cutoff: float) -> float:
    """1/S(k) - 1/S(0) of a dilute gas, rho [f(0) - f(k)] with the Fourier transform f(k) of exp(-u/T) - 1.

    Forces that end at the cutoff have a potential that is 0 there.
    """
    r = np.linspace(0.5, cutoff, 4001)
    f = np.exp(-(u(r) - u(cutoff)) / T) - 1
    return rho * 4 * np.pi * (f * r**2 * (1 - np.sinc(k * r / np.pi))).sum() * (r[1] - r[0])


gas, liquid, crystal, freezing = map(pathlib.Path, sys.argv[1:])
figure, (left, right) = plt.subplots(1, 2, figsize=(9, 4), constrained_layout=True)
for name, directory in ("gas", gas), ("liquid", liquid), ("crystal", crystal):
    run = ljmd.open(directory)
    r, g = table(run, "rdf", "r", "g")
    k, S, error, vectors = table(run, "sk", "k", "S", "S_standard_error", "vectors")
    place, height = g_peak(r, g)
    answer(f"{name}: g(r) is highest at", place)
    answer(f"{name}: height of g(r)", height)
    if name == "gas":
        answer("gas: neighbours nearer than 1.5", np.interp(1.5, *table(run, "rdf", "r", "coordination_number")))
        answer("hard spheres of that density", 4 * np.pi / 3 * (1.5**3 - 1) * 0.05)
    else:
        answer(f"{name}: coordination number", run["coordination_number"].mean, run["coordination_number"].error)
        answer(f"{name}: height of the first minimum of g(r)", first_minimum(r, g))
    long = k < 0.7
    answer(f"{name}: S of the waves with k < 0.7", np.average(S[long], weights=vectors[long]),
           np.sqrt(((vectors * error)[long]**2).sum()) / vectors[long].sum())
    left.plot(r, g, label=name)
    right.plot(k, S, label=name)
    if name == "gas":
        T = run["temperature"].mean
        left.plot(r, np.exp(-u(r) / T), color="k", lw=0.8, ls="--", label="exp(-u/T)")
        answer("gas: exp(1/T)", np.exp(1 / T))
        answer("gas: T/(dp/drho) by equation of state", compressibility(T, 0.05))
        answer("gas: the same with the cutoff", compressibility(T, 0.05, 2.5))
        there = [1 / (1 / compressibility(T, 0.05, 2.5) + fall(each, T, 0.05, 2.5)) for each in k[long]]
        answer("gas: the same with the cutoff, at these k", np.average(there, weights=vectors[long]))
    elif name == "liquid":
        answer("liquid: height of S(k)", *S_peak(k, S, vectors))
        T = run["temperature"].mean
        answer("liquid: T/(dp/drho) by equation of state", compressibility(T, 0.8442))
        answer("liquid: the same with the cutoff", compressibility(T, 0.8442, 2.5))
    else:
        sites = (4 / 1.0)**(1 / 3)  # edge of the cube with four atoms
        answer("crystal: distance of neighbouring sites", sites / np.sqrt(2))
        answer("crystal: height of S(k)", S.max())
        answer("crystal: S(k) is highest at", k[S.argmax()])
        answer("crystal: 2 pi sqrt(3)/a", 2 * np.pi * np.sqrt(3) / sites)
left.set(xlabel=r"$r$ / $\sigma$", ylabel=r"$g(r)$", ylim=(0, 5), xlim=(0, 4))
right.set(xlabel=r"$k$ / $\sigma^{-1}$", ylabel=r"$S(k)$", ylim=(0, 4), xlim=(0, 12))
left.legend()
save(figure, gas / "structure.png")

rows = []
for point in ljmd.open_sweep(freezing):
    density = point.values["system.density"]
    height, error = S_peak(*table(point.run, "sk", "k", "S", "vectors"))
    answer(f"T = 1, density {density:.2f}: height of S(k)", height, error)
    rows.append((density, height, error))
density, height, error = np.array(rows).T
slope, start = np.polyfit(density, height, 1, w=1 / error)
answer("density at which the height is 2.85", (2.85 - start) / slope, np.sqrt((error**2).mean()) / slope / np.sqrt(len(error)))
answer("density at which the liquid freezes", 0.9186)  # Mastny and de Pablo (2007), doi:10.1063/1.2753149
