"""Exercise 1: what a crystal does when it is heated, and the liquid when it is cooled.

    tools/python docs/class/melting.py runs/melting
"""

import pathlib
import sys
import warnings

import numpy as np
from classroom import answer, columns_of_stages, mean, plt, save

import ljmd


def lindemann(order: float) -> float:
    """Root mean square displacement from the sites over the distance of neighbours, from the order parameter of an fcc crystal.

    Displacements that are normally distributed give lambda = exp(-(4 pi^2/3) L^2).
    """
    return np.sqrt(-3 * np.log(order) / (4 * np.pi**2))


def freezing_density(T: float) -> float:
    """Of the liquid beside the crystal: Mastny and de Pablo (2007), doi:10.1063/1.2753149, equation 20."""
    return T**0.25 * np.polyval([-0.15284, 0.68012, -1.16270, 0.91784, -0.27120, 0.90735], 1 / T)


def melting_temperature(pressure: float) -> float:
    """At which the equation of state has this pressure on the freezing line: by bisection."""
    low, high = 0.7, 1.2
    while high - low > 1e-6:
        middle = (low + high) / 2
        if ljmd.eos(middle, freezing_density(middle)).pressure < pressure:
            low = middle
        else:
            high = middle
    return low


warnings.simplefilter("ignore", ljmd.RunWarning)  # that crystals exist at these densities is what this is about
directory = pathlib.Path(sys.argv[1])
run = ljmd.open(directory)
up, down = [], []
for name, (order, density, energy) in columns_of_stages(run, "order_parameter", "density", "potential_energy").items():
    half = len(order) // 2  # the first half of each stage is left out: the system gets used to its temperature
    way, T = name.split()
    row = (float(T), *mean(order[half:]), *mean(density[half:]), *mean(energy[half:]))
    (up if way == "up" else down).append(row)
up, down = np.array(up), np.array(down)

solid = up[:, 1] > 0.3
last, first = up[solid][-1], up[~solid][0]
T_m = melting_temperature(1.0)
for row in up[solid]:
    answer(f"order parameter at T = {row[0]:.2f}", row[1], row[2])
for row in up[solid]:
    L = lindemann(row[1])
    answer(f"Lindemann ratio at T = {row[0]:.2f}", L, row[2] / row[1] * 3 / (8 * np.pi**2 * L))
answer("Lindemann ratio at the melting temperature", np.interp(T_m, up[solid][:, 0], lindemann(up[solid][:, 1])))
answer("harmonic crystal at T = 0.80, from T = 0.40", up[0, 1]**2)
answer("highest temperature of the crystal", last[0])
answer("lowest temperature of the melt on heating", first[0])
answer("melting temperature by equations", T_m)
for row in down:
    answer(f"cooled: order parameter at T = {row[0]:.2f}", row[1], row[2])
answer("crystal at T = 0.40: density", up[0, 3], up[0, 4])
answer("cooled: density at T = 0.40", down[-1, 3], down[-1, 4])

# Both at T = 0.8, the crystal on its way up, the liquid on its way down.
(crystal,), (liquid,) = up[up[:, 0] == 0.8], down[down[:, 0] == 0.8]
volume = 1 / liquid[3] - 1 / crystal[3]
volume_error = np.hypot(liquid[4] / liquid[3]**2, crystal[4] / crystal[3]**2)
heat = liquid[5] - crystal[5] + volume  # of enthalpy, U + p V, at p = 1
heat_error = np.hypot(liquid[6], crystal[6])
answer("crystal at T = 0.80: density", crystal[3], crystal[4])
answer("liquid at T = 0.80: density", liquid[3], liquid[4])
answer("heat of melting", heat, heat_error)
answer("entropy of melting", heat / T_m, heat_error / T_m)
answer("entropy of melting of argon", 1180 / 83.8 / 8.314)
slope = volume * T_m / heat
answer("dT_m/dp by Clausius and Clapeyron", slope, slope * np.hypot(volume_error / volume, heat_error / heat))
answer("dT_m/dp by equations", (melting_temperature(1.2) - melting_temperature(0.8)) / 0.4)

figure, (left, right) = plt.subplots(1, 2, figsize=(9, 4), constrained_layout=True)
for axes, k, label in ((left, 1, r"order parameter $\lambda$"), (right, 3, r"density / $\sigma^{-3}$")):
    axes.errorbar(up[:, 0], up[:, k], 2 * up[:, k + 1], fmt="o-", ms=4, label="heated")
    axes.errorbar(down[:, 0], down[:, k], 2 * down[:, k + 1], fmt="s-", ms=4, mfc="w", label="cooled")
    axes.axvline(T_m, color="0.6", ls="--", lw=1)
    axes.set(xlabel=r"$T$ / ($\epsilon/k_\mathrm{B}$)", ylabel=label)
T = np.linspace(up[0, 0], last[0], 50)
left.plot(T, np.exp(np.log(up[0, 1]) * T / up[0, 0]), color="0.4", lw=1, label="harmonic crystal")
left.legend()
save(figure, directory / "melting.png")
