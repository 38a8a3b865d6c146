#!/usr/bin/env python3
"""Error against time step of every integrator, for one few-body deck.

    convergence.py DECK [--set KEY=VALUE] [--integrators a,b,...] [--time-steps h,h,...] [--output DIR] [--ljmd PATH] [--force]

Runs `ljmd compare DECK --with gsl` for each integrator (by default all that take fixed steps) and each time step (by default the deck's, and
2, 4, 8 times as much and as little). Time steps are changed so little that a whole number of them takes the time of the
deck, which must have one stage. Errors are the largest distance of a body from the reference, and the largest change of
the total energy.

Writes convergence.png and convergence.csv (integrator, time_step, position_error, energy_error) into DIR
(runs/NAME-convergence by default; earlier ones are replaced, other files only with --force), and prints the slopes of log(error) against log(time step). A point is fitted where
its error is above round-off (1e-11) and the position error is below a tenth of the size of the orbit at its start.
Exit codes: 0 ok, 2 usage, or a deck or integrator that ljmd refuses, 4 a file cannot be written.
"""

from __future__ import annotations

import argparse
import json
import math
import subprocess
import sys
from dataclasses import dataclass
from pathlib import Path
from typing import Any, Optional, Sequence

import numpy as np

sys.path.insert(0, str(Path(__file__).resolve().parent))
from script import reports_errors  # noqa: E402  (it finds the package ljmd)
import fitting  # noqa: E402
import program  # noqa: E402
import style  # noqa: E402
from fitting import PowerLaw  # noqa: E402
from ljmd.errors import InputError  # noqa: E402
from ljmd.reading import decks  # noqa: E402
from style import plt  # noqa: E402

ROUND_OFF = 1e-11
LARGE = 0.1  # of the size of the orbit
FACTORS = (8.0, 4.0, 2.0, 1.0, 0.5, 0.25, 0.125)  # of the deck's time step
BLOWN_UP = 5  # exit code of ljmd
ERRORS = {"position_error": "largest distance from the reference", "energy_error": "largest $|E - E(0)|$"}
HEADER = "integrator,time_step," + ",".join(ERRORS)
MARKERS = "os^vD<>Phd*"


@dataclass(frozen=True)
class Study:
    """The one stage of a deck that is repeated with other integrators and time steps."""

    path: Path
    settings: tuple[str, ...]  # as options of ljmd
    title: str
    stage: str
    time_step: float
    steps: int
    size: float  # of the orbit at its start

    def divide(self, time_step: float) -> tuple[int, float]:
        """The number of steps nearest to `time_step` in the time of the deck, and their exact length."""
        steps = max(1, round(self.steps * self.time_step / time_step))
        return steps, self.steps * self.time_step / steps


@dataclass(frozen=True)
class Series:
    """The errors of one integrator, by time step; those at which the motion blew up are not there."""

    integrator: str
    order: Optional[int]
    time_steps: np.ndarray
    errors: dict[str, np.ndarray]  # by the names in ERRORS
    fits: dict[str, PowerLaw]


def read_study(path: Path, settings: Sequence[str]) -> Study:
    """What is needed of a deck that ljmd has found good."""
    table = decks.read(path, settings)
    stages = table.get("stage", [])
    if len(stages) != 1:
        raise InputError(f"{path}: has {len(stages)} stages, must have one")
    stage = stages[0]
    if stage["steps"] < 1:
        raise InputError(f"{path}: steps must be above 0")
    return Study(
        path=path,
        settings=tuple(text for setting in settings for text in ("--set", setting)),
        title=table.get("title", ""),
        stage=stage["name"],
        time_step=float(stage["time_step"]),
        steps=stage["steps"],
        size=orbit_size(table),
    )


def orbit_size(table: dict[str, Any]) -> float:
    """The largest distance at the start between bodies, or of a body from the origin."""
    places = [np.array(body["position"], float) for body in table.get("body", []) if "position" in body]
    distances = [float(np.linalg.norm(one - other)) for one in places for other in [*places, np.zeros_like(one)]]
    return max(distances, default=0.0) or 1.0


def run_ljmd(ljmd: Path, *arguments: Any) -> Optional[dict[str, Any]]:
    """The JSON that ljmd prints; None when the motion blew up."""
    try:
        done = subprocess.run([str(ljmd), *map(str, arguments)], capture_output=True, text=True, check=False)
    except OSError as error:
        raise InputError(f"{ljmd}: cannot be run: {error.strerror}; say where ljmd is with --ljmd") from None
    if done.returncode == BLOWN_UP:
        return None
    if done.returncode != 0:
        raise InputError(f"ljmd {' '.join(map(str, arguments))}: {(done.stderr.strip() or 'failed').splitlines()[0]}")
    try:
        return json.loads(done.stdout)
    except json.JSONDecodeError as error:
        raise InputError(f"ljmd {' '.join(map(str, arguments))}: did not print JSON: {error}") from None


def measure(study: Study, ljmd: Path, integrator: str, order: Optional[int], time_steps: Sequence[float]) -> Series:
    """Run one integrator at all time steps."""
    rows = []
    stage = f'"{study.stage}"' if "." in study.stage else study.stage
    for steps, time_step in sorted({study.divide(time_step) for time_step in time_steps}):
        settings = {"integrator": integrator, "time_step": repr(time_step), "steps": steps}
        changes = [text for key, value in settings.items() for text in ("--set", f"stage.{stage}.{key}={value}")]
        found = run_ljmd(ljmd, "compare", study.path, "--with", "gsl", "--json", "--quiet", *study.settings, *changes)
        errors = [math.nan if found is None else found.get(f"largest_{name}", math.nan) for name in ERRORS]
        if np.all(np.isfinite(errors)):
            rows.append((time_step, *errors))
        else:
            print(f"{integrator} at {time_step:.4g}: no finite errors, left out", file=sys.stderr)
    columns = np.array(rows, float).reshape(-1, 1 + len(ERRORS)).T
    errors = dict(zip(ERRORS, columns[1:]))
    followed = errors["position_error"] < LARGE * study.size
    fits = {}
    for name, values in errors.items():
        fitted = followed & (values > ROUND_OFF)
        fits[name] = fitting.power_law(columns[0][fitted], values[fitted])
    return Series(integrator, order, columns[0], errors, fits)


def plot(study: Study, series: Sequence[Series]) -> plt.Figure:
    """Error against time step, a panel for each kind of error, with the fitted lines; dashed: what limits the fit."""
    figure, panels = plt.subplots(len(ERRORS), 1, sharex=True, figsize=(8.5, 9.0), constrained_layout=True)
    for axes, (name, label) in zip(panels, ERRORS.items()):
        for k, one in enumerate(series):
            look = {"color": style.colour(k), "marker": MARKERS[k % len(MARKERS)], "markerfacecolor": "none"}
            text = f"{one.integrator}: {written(one.fits[name].slope)}"
            axes.loglog(one.time_steps, one.errors[name], linestyle="", markersize=6, label=text, **look)
            axes.loglog(one.time_steps, one.fits[name](one.time_steps), color=look["color"], linewidth=0.8)
        drawn = np.concatenate([one.errors[name] for one in series])
        limits = (ROUND_OFF, LARGE * study.size) if name == "position_error" else (ROUND_OFF,)
        for limit in limits:
            if drawn.min(initial=np.inf) < limit < drawn.max(initial=0.0):
                axes.axhline(limit, color=style.GREY, linewidth=0.8, linestyle="--")
        axes.set_ylabel(label)
        axes.legend(loc="upper left", bbox_to_anchor=(1.0, 1.0), title="slope")
    panels[-1].set_xlabel("time step")
    style.head(figure, study.title)
    return figure


def written(slope: float) -> str:
    return f"{slope:.2f}" if math.isfinite(slope) else "-"


def save_table(series: Sequence[Series], path: Path, force: bool) -> None:
    """convergence.csv."""
    lines = [HEADER]
    for one in series:
        for row in zip(one.time_steps.tolist(), *(one.errors[name].tolist() for name in ERRORS)):
            lines.append(",".join([one.integrator, *map(repr, row)]))
    style.save_text("\n".join(lines) + "\n", path, HEADER, force)
    print(path)


def print_slopes(series: Sequence[Series]) -> None:
    width = max(len("integrator"), *(len(one.integrator) for one in series))
    print(f"{'integrator':<{width}}  order  position  energy")
    for one in series:
        slopes = [written(one.fits[name].slope) for name in ERRORS]
        order = "-" if one.order is None else one.order
        print(f"{one.integrator:<{width}}  {order:>5}  {slopes[0]:>8}  {slopes[1]:>6}")


def time_steps_from(text: str) -> list[float]:
    values = [float(part) for part in text.split(",")]
    if not all(0.0 < value < math.inf for value in values):
        raise argparse.ArgumentTypeError("time steps must be above 0")
    return values


@reports_errors
def main(arguments: Optional[Sequence[str]] = None) -> int:
    parser = argparse.ArgumentParser(description="Measure the order of integrators on one few-body deck.")
    parser.add_argument("deck", type=Path, help="a few-body deck with one stage")
    parser.add_argument("--set", dest="settings", action="append", default=[], metavar="KEY=VALUE", help="as of ljmd")
    parser.add_argument("--integrators", metavar="A,B,...", help="names as in `ljmd info` (all of fixed steps)")
    parser.add_argument("--time-steps", type=time_steps_from, metavar="H,H,...", help="(the deck's, times 1/8 ... 8)")
    parser.add_argument("--output", type=Path, metavar="DIR", help="where to write (runs/NAME-convergence)")
    parser.add_argument("--force", action="store_true", help="replace files that are none of an earlier study")
    parser.add_argument("--ljmd", type=Path, metavar="PATH", help="the program (build/release/ljmd, else on PATH)")
    options = parser.parse_args(arguments)
    ljmd = options.ljmd or Path(program.path())
    output = options.output or Path("runs") / f"{options.deck.stem}-convergence"
    table, picture = output / "convergence.csv", output / "convergence.png"
    style.require_writable(table, options.force, HEADER.encode())
    style.require_writable(picture, options.force)
    style.use()
    changes = [text for setting in options.settings for text in ("--set", setting)]
    run_ljmd(ljmd, "check", options.deck, "--json", "--quiet", *changes)  # what is wrong with a deck, ljmd says best
    study = read_study(options.deck, options.settings)
    methods = run_ljmd(ljmd, "info", "--json")["integrators"]
    known = {one["name"]: one.get("order") for one in methods}
    fixed = [one["name"] for one in methods if not one.get("adaptive", False)]
    names = options.integrators.split(",") if options.integrators else fixed
    unknown = [name for name in names if name not in known]
    if unknown:
        raise InputError(f"there is no integrator '{unknown[0]}', only {', '.join(known)}")
    time_steps = options.time_steps or [factor * study.time_step for factor in FACTORS]
    series = [measure(study, ljmd, name, known[name], time_steps) for name in names]
    print_slopes(series)
    save_table(series, table, options.force)
    style.save(plot(study, series), picture, options.force)
    return 0


if __name__ == "__main__":
    sys.exit(main())
