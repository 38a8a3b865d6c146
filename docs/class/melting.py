"""Exercise 1: what a crystal does when it is heated, and the liquid when it is cooled.

    tools/python docs/class/melting.py runs/melting
"""

import pathlib
import sys
import warnings

import numpy as np
from classroom import answer, columns_of_stages, first_minimum, mean, plt, save

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


def kept(column):
    """A column of a stage without its first fifth, in which the system gets used to its temperature."""
    return column[len(column) // 5:]


def equilibrium(columns) -> list:
    """Mean and standard error of each column of a stage, then means of their last eighths."""
    columns = [kept(column) for column in columns]
    return [*(number for column in columns for number in mean(column)), *(np.array_split(column, 8)[-1].mean() for column in columns)]


warnings.simplefilter("ignore", ljmd.RunWarning)  # that crystals exist at these densities is what this is about
directory = pathlib.Path(sys.argv[1])
run = ljmd.open(directory)
up, down, both = [], [], {}
change = {}  # of U, from the second eighth of a stage that cools to its last: the change of temperature itself is left out
for name, columns in columns_of_stages(run, "order_parameter", "density", "potential_energy").items():
    way, T = name.split()
    if T == "0.80":
        _, density, U = (kept(column) for column in columns)
        both[way] = density, 1 / density, U + 1.0 / density  # volume, and enthalpy U + p V at p = 1, for each atom
    if way == "up":
        up.append([float(T), *equilibrium(columns)])
    elif way == "down":
        down.append([float(T), *equilibrium(columns)])
        eighths = np.array_split(columns[2], 8)
        change[float(T)] = eighths[-1].mean() - eighths[1].mean()
up, down = np.array(up), np.array(down)

solid = (up[:, 1] > 0.5) & (up[:, 7] > 0.5)  # at the end, too
last, first = up[solid][-1], up[up[:, 7] < 0.3][0]
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

# Both at T = 0.8, the crystal on its way up, the liquid on its way down. U and volume of a phase fluctuate together, so that errors
# are those of the enthalpy, and of what the slope changes by with both.
(crystal, v_crystal, h_crystal), (liquid, v_liquid, h_liquid) = both["up"], both["down"]
heat, volume = h_liquid.mean() - h_crystal.mean(), v_liquid.mean() - v_crystal.mean()
heat_error = np.hypot(mean(h_liquid)[1], mean(h_crystal)[1])
answer("crystal at T = 0.80: density", *mean(crystal))
answer("liquid at T = 0.80: density", *mean(liquid))
answer("heat of melting", heat, heat_error)
answer("entropy of melting", heat / T_m, heat_error / T_m)
answer("entropy of melting of argon", 1180 / 83.8 / 8.314)
slope = volume * T_m / heat
answer("dT_m/dp by Clausius and Clapeyron", slope,
       slope * np.hypot(mean(v_liquid / volume - h_liquid / heat)[1], mean(v_crystal / volume - h_crystal / heat)[1]))
answer("dT_m/dp by equations", (melting_temperature(1.2) - melting_temperature(0.8)) / 0.4)

# What was cooled has no error bars: where it is frozen, it is as chance has frozen it, and another seed gives another number.
answer("cooled: largest order parameter, without its sign", np.abs(down[:, 1]).max())
for T in 0.7, 0.6, 0.5, 0.4:
    (crystal,), (cooled,) = up[up[:, 0] == T], down[down[:, 0] == T]
    answer(f"crystal at T = {T:.2f}: density", crystal[3], crystal[4])
    answer(f"cooled to T = {T:.2f}: density in the end", cooled[8])
    answer(f"crystal at T = {T:.2f}: U", crystal[5], crystal[6])
    answer(f"cooled to T = {T:.2f}: U in the end", cooled[9])
    answer(f"cooled to T = {T:.2f}: change of U in the stage", change[T])
r, g = (np.asarray(run.table("rdf")[column]) for column in ("r", "g"))
answer("cooled to T = 0.40: height of the first minimum of g(r)", first_minimum(r, g))

figure, (left, middle, right) = plt.subplots(1, 3, figsize=(12, 4), constrained_layout=True)
for axes, k, label in ((left, 1, r"order parameter $\lambda$"), (middle, 3, r"density / $\sigma^{-3}$")):
    axes.errorbar(up[:, 0], up[:, k], 2 * up[:, k + 1], fmt="o-", ms=4, label="heated")
    axes.errorbar(down[:, 0], down[:, k], 2 * down[:, k + 1], fmt="s-", ms=4, mfc="w", label="cooled")
    axes.axvline(T_m, color="0.6", ls="--", lw=1)
    axes.set(xlabel=r"$T$ / ($\epsilon/k_\mathrm{B}$)", ylabel=label)
T = np.linspace(up[0, 0], last[0], 50)
left.plot(T, np.exp(np.log(up[0, 1]) * T / up[0, 0]), color="0.4", lw=1, label="harmonic crystal")
left.legend()
right.plot(r, g)
right.set(xlabel=r"$r$ / $\sigma$", ylabel="$g(r)$ of what was cooled to 0.40", xlim=(0, r[-1]), ylim=(0, None))
save(figure, directory / "melting.png")
