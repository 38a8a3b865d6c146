#!/usr/bin/env python3
"""What a frame of a trajectory costs, from short runs to long ones: writing, reading, and resuming its run.

    trajectory_cost.py --ljmd PATH [--few 1000000] [--fluid 100000] [--repeats 3] [--out DIR]

Two bodies and 108 atoms, a frame at every step, in each format. All times are of the processor, of the program and of
the system for it, so that other work on the machine matters little. Writing: a run less the same run without a
trajectory. Resuming: `ljmd resume RUN --steps +1` of the finished run, less the same without a trajectory. Reading:
`ljmd analyze TRAJECTORY rdf`, as a whole; it reads no trajectories of few bodies. Medians of the repeats.

Writes DIR/trajectory-cost.json and DIR/trajectory-cost.png (DIR: runs/trajectory-cost by default). Give a DIR on the
disk that is to be measured: the trajectories lie there while they are measured, up to 3 GB.
Exit codes: 0 ok, 1 a run failed, 2 usage.
"""

from __future__ import annotations

import argparse
import json
import resource
import subprocess
import sys
import tempfile
from pathlib import Path
from statistics import median
from typing import Any, Optional

ROOT = Path(__file__).resolve().parents[2]
sys.path.insert(0, str(ROOT / "analysis"))
import machine  # noqa: E402
import style  # noqa: E402
from style import plt  # noqa: E402

SCHEMA = "ljmd-trajectory-cost"
SYSTEMS = {
    "2 bodies": """\
[force]
type = "newtonian-gravity"
gravitational_constant = 1.0

[[body]]
mass = 3.0
position = [-1.0, 0.0]
velocity = [0.0, -0.5]

[[body]]
mass = 1.5
position = [2.0, 0.0]
velocity = [0.0, 1.0]
""",
    "108 atoms": """\
[system]
lattice = { type = "fcc", cells = 3 }
density = 0.8442
temperature = 1.0
seed = 7

[potential]
type = "lennard-jones"
cutoff = 2.0
truncation = "cut"
tail = true
""",
}
FORMATS = {"2 bodies": ("h5md", "xyz", "csv"), "108 atoms": ("h5md", "xyz")}
NOISE = 0.01  # seconds
FIGURES = ("writing", "resuming", "reading")


def deck(system: str, form: Optional[str], frames: int) -> str:
    """@param form  of the trajectory; none: there is none"""
    trajectory = f'trajectory = {{ format = "{form}", every = 1 }}' if form else ""
    return f"""{SYSTEMS[system]}
[[stage]]
name = "all"
time_step = 0.002
steps = {frames - 1}

[output]
thermo = {{ every = {frames} }}
{trajectory}
"""


def processor_seconds() -> float:
    """Of all child processes that have ended."""
    usage = resource.getrusage(resource.RUSAGE_CHILDREN)
    return usage.ru_utime + usage.ru_stime


def seconds(program: Path, *arguments: object) -> float:
    begin = processor_seconds()
    done = subprocess.run([str(program), *map(str, arguments)], capture_output=True, text=True)
    if done.returncode != 0:
        sys.exit(f"ljmd {' '.join(map(str, arguments))} failed: {done.stderr.strip()}")
    return processor_seconds() - begin


def measure(program: Path, folder: Path, system: str, form: Optional[str], frames: int) -> dict[str, float]:
    path = folder / "deck.toml"
    path.write_text(deck(system, form, frames))
    run = folder / "run"
    found = {"writing": seconds(program, "run", path, "--out", run, "--force"),
             "resuming": seconds(program, "resume", run, "--steps", "+1")}
    if form and system == "108 atoms":
        found["reading"] = seconds(program, "analyze", run / f"trajectory.{form}", "rdf", "--force", "--out",
                                    folder / "tables")
    return found


def lengths(most: int) -> list[int]:
    """Powers of ten, up to the most."""
    return [n for n in (10**power for power in range(3, 10)) if n <= most]


def measure_all(options: argparse.Namespace, folder: Path) -> list[dict[str, Any]]:
    series = []
    for system, most in (("2 bodies", options.few), ("108 atoms", options.fluid)):
        for frames in lengths(most):
            forms = (None, *FORMATS[system])
            rounds = {form: [measure(options.ljmd, folder, system, form, frames) for _ in range(options.repeats)]
                      for form in forms}
            without = {name: median(one[name] for one in rounds[None]) for name in rounds[None][0]}
            for form in FORMATS[system]:
                cost = {name: median(one[name] for one in rounds[form]) - without.get(name, 0.0)
                        for name in rounds[form][0]}
                series.append({"system": system, "format": form, "frames": frames, "seconds": cost})
                print(system, form, frames, {name: f"{value:.3f} s" for name, value in cost.items()}, flush=True)
    return series


def draw(record: dict[str, Any]) -> plt.Figure:
    style.use()
    figure, panels = plt.subplots(1, len(FIGURES), figsize=(12.0, 4.2), constrained_layout=True)
    for axes, what in zip(panels, FIGURES):
        for system, marker, line in (("2 bodies", "o", "-"), ("108 atoms", "s", "--")):
            for k, form in enumerate(("h5md", "xyz", "csv")):
                points = [(one["frames"], one["seconds"][what]) for one in record["series"]
                          if one["system"] == system and one["format"] == form and what in one["seconds"]]
                if what != "resuming":  # the cost of a frame, where the difference of two runs is more than noise
                    points = [(frames, 1e6 * value / frames) for frames, value in points if value > NOISE]
                if points:
                    axes.plot(*zip(*points), marker + line, color=style.CYCLE[k], markersize=4,
                              label=f"{form}, {system}")
        axes.set(xscale="log", xlabel="frames", title=what)
        if what == "resuming":
            axes.set(ylabel="s, the whole resume", ylim=(-0.05, 0.5))
        else:
            axes.set(ylabel=r"$\mu$s a frame", yscale="log", ylim=(1.0, 1000.0))
    panels[0].legend(fontsize=8)
    figure.suptitle(style.plain(f"Processor time for a frame; {record['host']['cpu']}"), fontsize=10)
    return figure


def main() -> int:
    parser = argparse.ArgumentParser(description="Cost of a frame of a trajectory, from short runs to long ones.")
    parser.add_argument("--ljmd", type=Path, required=True)
    parser.add_argument("--few", type=int, default=1_000_000, help="frames of two bodies, at most")
    parser.add_argument("--fluid", type=int, default=100_000, help="frames of 108 atoms, at most")
    parser.add_argument("--repeats", type=int, default=3)
    parser.add_argument("--out", type=Path, default=Path("runs/trajectory-cost"))
    options = parser.parse_args()
    if options.repeats < 1:
        parser.error("--repeats must be above 0")
    options.ljmd = options.ljmd.resolve()
    options.out.mkdir(parents=True, exist_ok=True)
    with tempfile.TemporaryDirectory(dir=options.out) as folder:
        record = {"schema": SCHEMA, "host": machine.describe(), "series": measure_all(options, Path(folder))}
    style.save_text(json.dumps(record, indent=1) + "\n", options.out / "trajectory-cost.json", f'"schema": "{SCHEMA}"')
    style.save(draw(record), options.out / "trajectory-cost.png")
    return 0


if __name__ == "__main__":
    sys.exit(main())
