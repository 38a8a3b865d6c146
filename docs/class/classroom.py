"""What the scripts of the exercises share: stages of a run, means with errors, answers in one form, the look of pictures."""

import matplotlib

import ljmd

matplotlib.use("Agg")
import matplotlib.pyplot as plt  # noqa: E402  (the backend must be chosen first)
import numpy as np  # noqa: E402

ljmd.style()


def columns_of_stages(run, *names) -> dict:
    """{name of the stage: columns of its rows in thermo.csv}, the columns as arrays in the order of `names`."""
    thermo, first = run.thermo, 0
    step = np.asarray(thermo["step"])
    found = {}
    for stage in run.stages:
        rows = (step > first) & (step <= first + stage["steps"])
        found[stage["name"]] = [np.asarray(thermo[name])[rows] for name in names]
        first += stage["steps"]
    return found


def mean(series, blocks: int = 8) -> tuple:
    """Mean and standard error: that of a few long blocks, each taken as independent (exercise 3 shows why).

    Few blocks do not know their scatter well. The error is so much larger that two of it hold the true mean 19 times in 20
    (Student 1908), as those of many blocks do.
    """
    means = [block.mean() for block in np.array_split(np.asarray(series), blocks)]
    freedom = blocks - 1
    student = (1.96 + 2.37 / freedom + 2.82 / freedom**2) / 2
    return np.mean(means), student * np.std(means, ddof=1) / np.sqrt(blocks)


def first_minimum(r, g) -> float:
    """Height of g where it is lowest behind its first peak, before the second one of a liquid."""
    return g[(r > r[np.argmax(g)]) & (r < 1.7)].min()


def answer(name: str, value: float, error: float | None = None) -> None:
    """Print a number; behind +- stands twice its standard error, with two digits, and the number has as many decimals."""
    if error is None:
        print(f"{name:52} {value:.4g}")
        return
    decimals = max(0, 1 - int(np.floor(np.log10(2 * error))))
    print(f"{name:52} {value:.{decimals}f} +- {2 * error:.{decimals}f}")


def save(figure, path) -> None:
    """Write a picture and say where it is."""
    figure.savefig(path)
    print(f"picture: {path}")
