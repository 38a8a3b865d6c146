#!/usr/bin/env python3
"""Runs that MPI processes share: their rate beside that of independent runs, and a model of many ranks.

    ranks.py --ljmd PATH [--cells 40] [--ranks 2] [--steps 500] [--repeats 5] [--decomposition PATH] [--simulate RANKS]
             [--cost NANOSECONDS] [--out DIR] [--quick]
    ranks.py --redraw DIR        page and figure anew from DIR/ranks.json

Measured, interleaved in every round: one process; P processes that share a run; P independent runs, each of a P-th of
the atoms, at once; the same two of LAMMPS (lj/cut/opt) where it is installed. The ratio of the shared rate to that of
the independent runs says what sharing costs, whatever the machine's cores do to each other. Files are left out.

The model is that of rank_model.py, on paper, with the cost of an atom as measured here, in a box that no cache holds, or
as given by --cost, which measures nothing. --simulate has SimGrid simulate steps of up to so many ranks (replay.py).

Writes DIR/ranks.json, DIR/ranks.md and DIR/ranks.png (DIR: runs/ranks by default).
Exit codes: 0 ok, 1 a program failed, 2 usage, 3 a record cannot be read, 4 a file cannot be written.
"""

from __future__ import annotations

import argparse
import datetime
import json
import os
import re
import shutil
import subprocess
import sys
import tempfile
from pathlib import Path
from statistics import median
from typing import Any, Optional, Sequence

ROOT = Path(__file__).resolve().parents[2]
sys.path.insert(0, str(ROOT / "analysis"))
from script import reports_errors  # noqa: E402  (it finds the package ljmd)
import command_line  # noqa: E402
import ljmd_program  # noqa: E402
import machine  # noqa: E402
import report  # noqa: E402
import replay  # noqa: E402
import style  # noqa: E402
import workload  # noqa: E402
from programs import ProgramFailed  # noqa: E402
from rank_model import BANDWIDTH, LATENCY, RANKS, SIZES, counted, modelled  # noqa: E402
from ljmd.reading.files import damaged, read_json  # noqa: E402
from style import plt  # noqa: E402

SCHEMA = "ljmd-ranks"
MARK = f'"schema": "{SCHEMA}"'
HEADING = "# Runs that ranks share"
VERSION = 3
LAMMPS_INPUT = """units lj
atom_style atomic
lattice fcc {density}
region box block 0 {x} 0 {y} 0 {z}
create_box 1 box
create_atoms 1 box
mass 1 1.0
velocity all create {temperature} {seed}
pair_style lj/cut {cutoff}
pair_coeff 1 1 1.0 1.0
neighbor {skin} bin
neigh_modify delay 0 every {every} check no
fix 1 all nve
timestep {time_step}
thermo {thermo}
run {steps}
"""


def parse(arguments: Optional[Sequence[str]]) -> argparse.Namespace:
    parser = command_line.parser("Runs that MPI processes share, measured and modelled.", policy="fixed", out="runs/ranks",
                                 quick="a small box, one round, few steps")
    parser.add_argument("--cells", type=int, help="cubic cells of fcc along each edge, a multiple of the ranks")
    parser.add_argument("--ranks", type=int, default=2)
    parser.add_argument("--steps", type=int)
    parser.add_argument("--decomposition", type=Path, help="the program that asks the grid (build/dev/tests/benchmarks/decomposition); "
                                                           "none: no model")
    parser.add_argument("--simulate", type=int, default=0, metavar="RANKS", help="simulate runs of up to so many ranks, by SimGrid")
    parser.add_argument("--cost", type=float, metavar="NANOSECONDS", help="of an atom and step, for the model; then nothing is measured")
    options = command_line.parse(parser, arguments, full={"cells": 40, "steps": 500, "repeats": 5, "seconds": 0.0},
                                 quick={"cells": 20, "steps": 40, "repeats": 1, "seconds": 0.0})
    if options.simulate and (not options.decomposition or not replay.installed()):
        parser.error("--simulate needs --decomposition, and SimGrid's smpirun (Debian: libsimgrid-dev)")
    if options.ranks < 2 or options.cells < 6 or options.cells % options.ranks != 0 or options.steps < 1 or options.repeats < 1:
        parser.error("--ranks must be above 1, --cells a multiple of it and at least 6, --steps and --repeats above 0")
    return options


def environment() -> dict[str, str]:
    """mpirun works for root, too, and takes more processes than cores."""
    return {**os.environ, "OMPI_ALLOW_RUN_AS_ROOT": "1", "OMPI_ALLOW_RUN_AS_ROOT_CONFIRM": "1", "OMP_NUM_THREADS": "1"}


def at_once(commands: Sequence[Sequence[Any]], folder: Path) -> None:
    """Run programs at the same time. Raises ProgramFailed when one of them fails."""
    running = [subprocess.Popen([str(word) for word in command], cwd=folder, env=environment(), stdin=subprocess.DEVNULL,
                                stdout=subprocess.DEVNULL, stderr=subprocess.PIPE, text=True) for command in commands]
    for command, process in zip(commands, running):
        _, said = process.communicate()
        if process.returncode != 0:
            raise ProgramFailed(f"{Path(str(command[0])).name}: exit code {process.returncode}: {said.strip()[-300:]}")


def launcher(ranks: int) -> list[str]:
    return [] if ranks == 1 else ["mpirun", "--oversubscribe", "--bind-to", "none", "-n", str(ranks)]


class Ours:
    """ljmd, with the work of workload.py."""

    name = "ljmd"

    def __init__(self, program: Path, folder: Path, options: argparse.Namespace):
        self.program, self.folder, self.steps = program.resolve(), folder, options.steps
        for label, layers in (("whole", options.cells), ("part", options.cells // options.ranks)):
            system = (f'lattice = {{ type = "fcc", cells = {options.cells}, layers = {layers} }}\n'
                      f"density = {workload.DENSITY}\ntemperature = {workload.TEMPERATURE}\nseed = {workload.SEED}")
            (folder / f"{label}.toml").write_text(ljmd_program.deck(system, "double", options.policy, options.steps))

    def command(self, label: str, ranks: int, number: int) -> list[Any]:
        return [*launcher(ranks), self.program, "run", f"{label}.toml", "--quiet", "--force", "--out", f"out-{number}"]

    def rate(self, atoms: int, number: int) -> float:
        record = json.loads((self.folder / f"out-{number}" / "run.json").read_text())
        return atoms * self.steps / (record["seconds_in_time_loop"] - record["seconds_per_phase"]["write"])


class Lammps:
    name = "lammps-opt"

    def __init__(self, folder: Path, options: argparse.Namespace):
        self.folder, self.steps = folder, options.steps
        for label, layers in (("whole", options.cells), ("part", options.cells // options.ranks)):
            (folder / f"{label}.in").write_text(LAMMPS_INPUT.format(
                density=workload.DENSITY, temperature=workload.TEMPERATURE, seed=workload.SEED, cutoff=workload.CUTOFF,
                skin=workload.SKIN, every=workload.REBUILD_EVERY, time_step=workload.TIME_STEP, thermo=workload.THERMO_EVERY,
                steps=options.steps, x=options.cells, y=options.cells, z=layers))

    def command(self, label: str, ranks: int, number: int) -> list[Any]:
        return [*launcher(ranks), "lmp", "-sf", "opt", "-in", f"{label}.in", "-log", f"log-{number}", "-screen", "none"]

    def rate(self, atoms: int, number: int) -> float:
        found = re.search(r"Loop time of (\S+)", (self.folder / f"log-{number}").read_text())
        if not found:
            raise ProgramFailed("lmp: no time of the loop in its log")
        return atoms * self.steps / float(found.group(1))


def measure(options: argparse.Namespace, folder: Path) -> list[dict[str, Any]]:
    """Rates [atom-steps/s] of every round: alone, shared, parts."""
    atoms = 4 * options.cells**3
    programs: list[Any] = [Ours(options.ljmd, folder, options)]
    if shutil.which("lmp"):
        programs.append(Lammps(folder, options))
    found = []
    for turn in range(options.repeats):
        for program in programs:
            rates = {}
            at_once([program.command("whole", 1, 0)], folder)
            rates["alone"] = program.rate(atoms, 0)
            at_once([program.command("whole", options.ranks, 0)], folder)
            rates["shared"] = program.rate(atoms, 0)
            parts = range(options.ranks)
            at_once([program.command("part", 1, k) for k in parts], folder)
            rates["parts"] = sum(program.rate(atoms // options.ranks, k) for k in parts)
            found.append({"program": program.name, "round": turn + 1, **rates})
            print(f"round {turn + 1}: {program.name:10}  alone {rates['alone'] / 1e6:6.2f}  shared {rates['shared'] / 1e6:6.2f}  "
                  f"parts {rates['parts'] / 1e6:6.2f} M atom-steps/s", file=sys.stderr, flush=True)
    return found


def simulations(program: Path, cost: float, largest: int) -> list[dict[str, Any]]:
    """Simulated steps on each network, with the model's result for the same ranks."""
    found = []
    for atoms, ranks in replay.RUNS:
        if ranks > largest:
            continue
        decomposition = counted(program, atoms, [ranks], "--messages")[0]
        on_paper = modelled(decomposition, cost)["efficiency"]
        for network in replay.NETWORKS:
            if ranks > replay.LARGEST[network]:
                continue
            with tempfile.TemporaryDirectory() as folder:
                found.append({**replay.simulated(decomposition, cost, network, Path(folder)), "on_paper": on_paper})
            print(f"simulated: {atoms:.0e} atoms, {ranks} ranks, {network}: {found[-1]['efficiency']:.3f}, {found[-1]['simulator']}",
                  file=sys.stderr, flush=True)
    return found


def cost_of(record: dict[str, Any]) -> float:
    """Seconds for an atom and step of one process."""
    if record["options"]["cost"] is not None:
        return 1e-9 * record["options"]["cost"]
    return 1.0 / median(one["alone"] for one in record["rounds"] if one["program"] == "ljmd")


def markdown(record: dict[str, Any]) -> str:
    host, options = record["host"], record["options"]
    rows = []
    for name in dict.fromkeys(one["program"] for one in record["rounds"]):
        rounds = [one for one in record["rounds"] if one["program"] == name]
        ratios = sorted(one["shared"] / one["parts"] for one in rounds)
        rows.append([name, *(f"{median(one[key] for one in rounds) / 1e6:.2f}" for key in ("alone", "shared", "parts")),
                     f"{median(ratios):.3f} ({ratios[0]:.3f} .. {ratios[-1]:.3f})",
                     f"{median(one['shared'] / one['alone'] for one in rounds):.2f}"])
    lines = [HEADING]
    if rows:
        lines += ["", f"{record['date']}, {host['cpu']}, {host['cores']} cores. {4 * options['cells']**3} atoms, {options['ranks']} ranks, "
                  f"{options['steps']} steps, lists {options['policy']}, medians of {options['repeats']} rounds, M atom-steps/s.", "",
                  *report.table(["program", "one process", "shared", "independent parts", "shared / parts", "shared / one process"], rows)]
    if record["decompositions"]:
        cost = cost_of(record)
        rows = []
        for decomposition in record["decompositions"]:
            one = modelled(decomposition, cost)
            terms = one["terms"]
            rows.append([f"{one['atoms']:.0e}", one["ranks"], f"{one['slowest']['atoms']:.0f}", f"{one['slowest']['ghosts']:.0f}",
                         f"{one['slowest']['forces']:.0f}", one["slowest"]["messages"], *(f"{1e6 * terms[key]:.1f}" for key in terms), f"{one['efficiency']:.2f}"])
        lines += ["", f"The model, with {1e9 * cost:.0f} ns an atom and step, messages of {1e6 * LATENCY:.1f} us and {BANDWIDTH / 1e9:.0f} GB/s:", "",
                  *report.table(["atoms", "ranks", "atoms of a rank", "ghosts", "forces", "other ranks", "computing [us]", "positions [us]",
                                 "forces [us]", "decisions [us]", "efficiency"], [[str(cell) for cell in row] for row in rows])]
    if record["simulations"]:
        rows = [[f"{one['atoms']:.2g}", one["ranks"], one["network"], f"{1e6 * one['step']:.0f}", f"{one['efficiency']:.3f}",
                 f"{one['on_paper']:.3f}", f"{one['simulator']['seconds']:.1f}", f"{one['simulator']['mebibytes']:.0f}"]
                for one in record["simulations"]]
        lines += ["", "Simulated:", "", *report.table(["atoms", "ranks", "network", "a step [us]", "efficiency", "on paper", "simulator [s]",
                                                     "simulator [MiB]"], [[str(cell) for cell in row] for row in rows])]
    return "\n".join(lines) + "\n"


def draw(record: dict[str, Any]) -> plt.Figure:
    """Efficiency against ranks for each size, and the parts of a step of the largest."""
    style.use()
    figure, (efficiency, parts) = plt.subplots(1, 2, figsize=(10.5, 4.0), constrained_layout=True)
    cost = cost_of(record)
    for k, atoms in enumerate(SIZES):
        found = [modelled(one, cost) for one in record["decompositions"] if one["atoms"] == atoms]
        efficiency.plot([one["ranks"] for one in found], [one["efficiency"] for one in found], "os"[k] + "-", markersize=4, color=style.colour(k),
                        label=f"{atoms:,}".replace(",", " ") + " atoms, on paper")
        for network, marker in zip(replay.NETWORKS, "xD"):
            places = [(one["ranks"], one["efficiency"]) for one in record["simulations"] if (one["atoms"], one["network"]) == (atoms, network)]
            if places:
                efficiency.plot(*zip(*places), marker, markersize=7, fillstyle="none", color=style.colour(k), label=f"simulated, {network}")
    efficiency.set(xscale="log", xlabel="ranks", ylabel="part of the ideal rate", ylim=(0.0, 1.05))
    efficiency.legend()
    for k, (name, label) in enumerate({"computing": "computing", "positions": "waiting for positions", "forces": "waiting for forces",
                                       "decisions": "decisions"}.items()):
        places = [(one["ranks"], 1e6 * one["terms"][name]) for one in found if one["terms"][name] > 0.0]
        if places:
            parts.plot(*zip(*places), "os^v"[k] + "-", markersize=4, color=style.colour(k), label=label)
    parts.set(xscale="log", yscale="log", xlabel="ranks", ylabel=f"microseconds a step, {SIZES[-1]:.0e} atoms")
    parts.legend()
    return figure


def write(record: dict[str, Any], folder: Path) -> None:
    style.save_text(json.dumps(record, indent=1) + "\n", folder / "ranks.json", MARK)
    style.save_text(markdown(record), folder / "ranks.md", HEADING)
    if record["decompositions"]:
        style.save(draw(record), folder / "ranks.png")


def read(path: Path) -> dict[str, Any]:
    record = read_json(path)
    if record.get("schema") != SCHEMA or record.get("version") != VERSION:
        raise damaged(path, f"it is no {SCHEMA} of version {VERSION}")
    return record


@reports_errors
def main(arguments: Optional[Sequence[str]] = None) -> int:
    options = parse(arguments)
    if options.redraw:
        record = read(options.redraw / "ranks.json")
        write(record, options.redraw)
        return 0
    style.require_writable(options.out / "ranks.json", mark=MARK.encode())
    try:
        record: dict[str, Any] = {
            "schema": SCHEMA, "version": VERSION, "date": datetime.datetime.now(datetime.timezone.utc).isoformat(timespec="seconds"),
            "host": machine.describe(), "rounds": [], "decompositions": [], "simulations": [],
            "options": {key: getattr(options, key) for key in ("cells", "ranks", "steps", "repeats", "policy", "cost")}}
        if options.cost is None:
            with tempfile.TemporaryDirectory() as folder:
                record["rounds"] = measure(options, Path(folder))
        if options.decomposition:
            program = options.decomposition.resolve()
            record["decompositions"] = [one for atoms in SIZES for one in counted(program, atoms, RANKS)]
            record["simulations"] = simulations(program, cost_of(record), options.simulate)
    except (ProgramFailed, OSError) as error:
        print(f"error: {error}", file=sys.stderr)
        return 1
    write(record, options.out)
    print(markdown(read(options.out / "ranks.json")))
    return 0


if __name__ == "__main__":
    sys.exit(main())
