"""Exercise 3: correlated samples, blocking, and what an error bar is worth.

    tools/python docs/class/errors.py runs/errors runs/errors-sweep runs/errors-short
"""

import pathlib
import sys

import numpy as np
from classroom import answer, columns_of_stages, plt, save

import ljmd


def correlation(x) -> np.ndarray:
    """C(t) = <dx(0) dx(t)>/<dx^2> for all t, by Fourier transforms (Wiener and Khinchin)."""
    dx = x - x.mean()
    spectrum = np.abs(np.fft.rfft(dx, 2 * len(dx)))**2
    c = np.fft.irfft(spectrum)[:len(dx)] / np.arange(len(dx), 0, -1)
    return c / c[0]


def inefficiency(c) -> float:
    """g = 1 + 2 sum of C(t), up to where C first falls below zero: so many samples are worth one independent one."""
    end = np.argmax(c < 0)
    return 1 + 2 * c[1:end].sum()


def blocking(x) -> list:
    """(length, error, uncertainty of the error) for blocks of 1, 2, 4, ... samples (Flyvbjerg and Petersen 1989)."""
    found, length = [], 1
    while len(x) >= 4:
        error = x.std(ddof=1) / np.sqrt(len(x))
        found.append((length, error, error / np.sqrt(2 * (len(x) - 1))))
        x = x[:len(x) // 2 * 2].reshape(-1, 2).mean(axis=1)
        length *= 2
    return found


directory, *sweeps = map(pathlib.Path, sys.argv[1:])
run = ljmd.open(directory)
series = dict(zip(("potential_energy", "pressure_xy"), columns_of_stages(run, "potential_energy", "pressure_xy")["production"]))
every = np.diff(np.asarray(run.thermo["time"])[-2:])[0]
figure, (left, right) = plt.subplots(1, 2, figsize=(9, 4), constrained_layout=True)
for name, x in series.items():
    c, found = correlation(x), run[name]
    g = inefficiency(c)
    answer(f"{name}: samples", len(x))
    answer(f"{name}: naive error", x.std(ddof=1) / np.sqrt(len(x)))
    answer(f"{name}: naive error with every 10th sample", x[::10].std(ddof=1) / np.sqrt(len(x[::10])))
    answer(f"{name}: error by the correlation time", x.std(ddof=1) * np.sqrt(g / len(x)))
    answer(f"{name}: error by ljmd", found.error)
    answer(f"{name}: inefficiency g", g)
    answer(f"{name}: correlation time / tau", (g - 1) / 2 * every)
    answer(f"{name}: independent samples", found.independent_samples)
    t = np.arange(400) * every
    left.plot(t, c[:400], label=name)
    length, error, uncertainty = np.array(blocking(x)).T
    right.errorbar(length * every, error / error[0], uncertainty / error[0], fmt="o-", ms=3.5, label=name)
left.axhline(0, color="0.6", lw=0.8)
left.set(xlabel=r"$t$ / $\tau$", ylabel=r"$C(t)$", xlim=(0, t[-1]))
left.legend()
right.set(xlabel=r"length of a block / $\tau$", ylabel="error / naive error", xscale="log", yscale="log")
right.legend()
save(figure, directory / "errors.png")

for sweep in map(ljmd.open_sweep, sweeps):
    time = sweep[0].run.stages[-1]["steps"] * 0.005
    found = [point.run["potential_energy"] for point in sweep]
    means, errors = np.array([each.mean for each in found]), np.array([each.error for each in found])
    z = (means - means.mean()) / errors
    ratio = means.std(ddof=1) / np.sqrt((errors**2).mean())
    answer(f"runs of {time:.0f} tau: scatter of the means / error bar", ratio, ratio / np.sqrt(2 * (len(z) - 1)))
    for width in 1, 2:
        part = (np.abs(z) < width).mean()
        answer(f"runs of {time:.0f} tau: means within {width} error bar{'s'[:width - 1]}, per cent", 100 * part,
               100 * np.sqrt(part * (1 - part) / len(z)))
    answer(f"runs of {time:.0f} tau: error bars marked as guesses, per cent", 100 * np.mean([not each.converged for each in found]))
