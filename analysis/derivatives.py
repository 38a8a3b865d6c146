#!/usr/bin/env python3
"""Finite differences of a trajectory against the program's own velocity and acceleration.

    derivatives.py RUNDIR [--out DIR] [--format png|pdf|svg]

RUNDIR is the run of one body whose trajectory.csv has x1, vx1 and, from a deck with accelerations = true, ax1 at
equally spaced times; best a harmonic oscillator, computed so finely that these columns are exact. For h = 1, 2, 4, ...
rows:

    one-sided  (x(t + h) - x(t)) / h                    error of order 1, against v
    first      (x(t + h) - x(t - h)) / 2h               error of order 2, against v
    second     (x(t + h) - 2 x(t) + x(t - h)) / h^2     error of order 2, against a

The error is the root mean square over all rows where the differences can be formed. Prints `slope NAME VALUE` for each,
fitted where the error is well above round-off and small against the derivative, and draws derivatives into DIR (RUNDIR
by default). Exit codes: 0 ok, 2 usage, 3 a file of the run is missing or damaged, 4 the picture cannot be written.
"""

from __future__ import annotations

import argparse
import sys
from pathlib import Path
from typing import Optional, Sequence

import numpy as np

sys.path.insert(0, str(Path(__file__).resolve().parent))
from script import reports_errors  # noqa: E402  (it finds the package ljmd)
import fitting  # noqa: E402
import style  # noqa: E402
from fitting import PowerLaw  # noqa: E402
from ljmd.errors import InputError  # noqa: E402
from ljmd.reading import few_bodies  # noqa: E402
from ljmd.reading.few_bodies import FewBodyRun  # noqa: E402
from ljmd.reading.files import damaged  # noqa: E402
from style import plt  # noqa: E402

ROUND_OFF = 2.2e-16
NOT_ROUND_OFF = 100.0  # errors so many times round-off are fitted
SMALL = 0.04  # errors below SMALL**order of the derivative are fitted: farther out higher orders show


KINDS = {  # name: order of the error, order of the derivative, label, colour
    "one-sided": (1, 1, "$(x(t+h) - x(t))/h$", style.GREEN),
    "first": (2, 1, "$(x(t+h) - x(t-h))/2h$", style.BLUE),
    "second": (2, 2, "$(x(t+h) - 2x(t) + x(t-h))/h^2$", style.VERMILION),
}


def errors_of(kind: str, m: int, interval: float, x: np.ndarray, v: np.ndarray, a: np.ndarray) -> np.ndarray:
    """Errors of one difference over m rows that are `interval` apart, at all rows but the first and the last m."""
    h = m * interval
    before, here, after = x[: -2 * m], x[m:-m], x[2 * m :]
    if kind == "one-sided":
        return (after - here) / h - v[m:-m]
    if kind == "first":
        return (after - before) / (2.0 * h) - v[m:-m]
    return (after - 2.0 * here + before) / h**2 - a[m:-m]


def root_mean_square(values: np.ndarray) -> float:
    return float(np.sqrt(np.mean(values**2)))


def columns(run: FewBodyRun) -> tuple[float, np.ndarray, np.ndarray, np.ndarray]:
    """The time between rows, and x, v and a of the one body."""
    frames = run.trajectory
    path = run.path / "trajectory.csv"
    if run.bodies != 1:
        raise InputError(f"{run.path}: has {run.bodies} bodies, one is needed")
    if frames is None or frames.velocities is None or frames.accelerations is None:
        raise damaged(path, "positions, velocities and accelerations are needed: set accelerations = true in the deck")
    if len(frames.time) < 8:
        raise damaged(path, f"{len(frames.time)} rows, at least 8 are needed")
    intervals = np.diff(frames.time)
    if np.ptp(intervals) > 1e-6 * abs(intervals[0]) or intervals[0] <= 0.0:
        raise damaged(path, "the times are not equally spaced")
    interval = float(frames.time[-1] - frames.time[0]) / len(intervals)
    return interval, frames.positions[:, 0, 0], frames.velocities[:, 0, 0], frames.accelerations[:, 0, 0]


def measure(run: FewBodyRun) -> tuple[np.ndarray, dict[str, tuple[np.ndarray, PowerLaw]]]:
    """The steps h, and for each kind of difference its errors and the fit through those that show its order."""
    interval, x, v, a = columns(run)
    spans = [2**k for k in range((len(x) // 4).bit_length())]
    steps = interval * np.array(spans)
    found = {}
    for kind, (order, derivative, _, _) in KINDS.items():
        # The mean is over the same rows for every h, else it would change with h by itself.
        cut = [errors_of(kind, m, interval, x, v, a)[spans[-1] - m : len(x) - spans[-1] - m] for m in spans]
        errors = np.array([root_mean_square(values) for values in cut])
        size = root_mean_square(v if derivative == 1 else a)
        noise = NOT_ROUND_OFF * ROUND_OFF * float(np.abs(x).max()) / steps**derivative
        fitted = (errors > noise) & (errors < SMALL**order * size)
        if np.count_nonzero(fitted) < 2:
            raise damaged(run.path / "trajectory.csv", f"no slope for '{kind}': rows closer in time are needed")
        found[kind] = (errors, fitting.power_law(steps[fitted], errors[fitted]))
    return steps, found


def plot(run: FewBodyRun, steps: np.ndarray, found: dict[str, tuple[np.ndarray, PowerLaw]]) -> plt.Figure:
    """Error against h, with the fitted lines."""
    figure, axes = plt.subplots(figsize=(7.0, 5.0), constrained_layout=True)
    for kind, (errors, law) in found.items():
        _, _, label, colour = KINDS[kind]
        axes.loglog(steps, errors, "o", color=colour, markersize=5, label=f"{label}: slope {law.slope:.2f}")
        axes.loglog(steps, law(steps), color=colour, linewidth=0.9)
    axes.set_xlabel("$h$")
    axes.set_ylabel("root mean square error")
    axes.legend(loc="upper left")
    style.head(figure, run.title)
    return figure


@reports_errors
def main(arguments: Optional[Sequence[str]] = None) -> int:
    parser = argparse.ArgumentParser(description="Compare finite differences with velocity and acceleration.")
    parser.add_argument("rundir", type=Path, help="directory that `ljmd run` wrote")
    parser.add_argument("--out", type=Path, help="directory for the picture (default: the run directory)")
    parser.add_argument("--format", choices=("png", "pdf", "svg"), default="png")
    options = parser.parse_args(arguments)
    style.use()
    run = few_bodies.load(options.rundir)
    steps, found = measure(run)
    for kind, (_, law) in found.items():
        print(f"slope {kind} {law.slope:.3f}")
    style.save(plot(run, steps, found), (options.out or options.rundir) / f"derivatives.{options.format}")
    return 0


if __name__ == "__main__":
    sys.exit(main())
