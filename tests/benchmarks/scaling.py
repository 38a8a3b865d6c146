#!/usr/bin/env python3
"""Cost of ljmd for an atom and a step, and its memory, over sizes, densities, cutoffs, small boxes, shapes and
potentials.

    scaling.py --ljmd PATH [--families a,b] [--largest 1100000] [--threads 1] [--precision double] [--simd LEVEL]
               [--policy strict|fixed] [--repeats 3] [--seconds 1] [--share] [--out DIR] [--quick]
    scaling.py --redraw DIR        page and figure anew from DIR/scaling.json

Families: size, density, cutoff, small box, shape, potential. Every round runs each system once; reported are medians, minima and
maxima over the rounds. The cost should follow the number of neighbours n on the list, c = a + b n; a and b are fitted
to all systems (least squares of relative deviations), and the last column of the page says how far each is from that
line: a cliff would stand out there. The files that end a run are left out: of a large system they take longer than the
few steps that are timed.

Writes DIR/scaling.json, DIR/scaling.md and DIR/scaling.png (DIR: runs/scaling by default). The record has `schema`
"ljmd-scaling", `version` 1, date, host, ljmd, options, `systems` (family, label, x, atoms, density, cutoff, neighbours,
steps, nanoseconds: all rounds, bytes_per_atom) and `failures`.
Exit codes: 0 ok, 1 a system failed, 2 usage, 3 a record cannot be read, 4 a file cannot be written.
"""

from __future__ import annotations

import argparse
import datetime
import json
import sys
import tempfile
from pathlib import Path
from statistics import median
from typing import Any, Optional, Sequence

import numpy as np

ROOT = Path(__file__).resolve().parents[2]
sys.path.insert(0, str(ROOT / "analysis"))
from script import reports_errors  # noqa: E402  (it finds the package ljmd)
import command_line  # noqa: E402
import ljmd_program  # noqa: E402
import machine  # noqa: E402
import report  # noqa: E402
import scaling_cases  # noqa: E402
import style  # noqa: E402
import workload  # noqa: E402
from ljmd_program import Ljmd, Variant  # noqa: E402
from programs import ProgramFailed  # noqa: E402
from ljmd.errors import InputError  # noqa: E402
from ljmd.reading.files import damaged, read_json  # noqa: E402
from scaling_cases import System  # noqa: E402
from style import plt  # noqa: E402

SCHEMA = "ljmd-scaling"
MARK = f'"schema": "{SCHEMA}"'
HEADING = "# Cost and memory of ljmd"
VERSION = 1
OPTIONS = ("threads", "precision", "simd", "policy", "repeats", "share")  # of the record
# seconds for an atom and a step, without and for each neighbour, from which numbers of steps are chosen
NOMINAL_COST = (50e-9, 3e-9)


def parse(arguments: Optional[Sequence[str]]) -> argparse.Namespace:
    parser = command_line.parser("Cost and memory of ljmd over sizes, densities, cutoffs, shapes and potentials.", policy="strict",
                                 out="runs/scaling", quick="small sizes, one round, short runs")
    parser.add_argument("--families", type=lambda text: text.split(","), default=list(scaling_cases.FAMILIES))
    parser.add_argument("--largest", type=int, help="atoms in the family 'size', at most 10061824")
    parser.add_argument("--threads", type=int, default=1)
    parser.add_argument("--precision", choices=("double", "mixed"), default="double")
    options = command_line.parse(parser, arguments, full={"largest": 1_100_000, "repeats": 3, "seconds": 1.0},
                                 quick={"largest": 40_000, "repeats": 1, "seconds": 0.2})
    unknown = [name for name in options.families if name not in scaling_cases.FAMILIES]
    if unknown:
        parser.error(f"no family '{unknown[0]}', only {', '.join(scaling_cases.FAMILIES)}")
    if options.repeats < 1 or options.threads < 1 or not options.seconds > 0.0:
        parser.error("--repeats, --threads and --seconds must be above 0")
    return options


def steps_for(system: System, seconds: float) -> int:
    """Steps that take about `seconds` at NOMINAL_COST, at least one period of the fixed policy."""
    fixed, each = NOMINAL_COST
    periods = seconds / (system.atoms * (fixed + each * system.neighbours)) / workload.REBUILD_EVERY
    return max(1, round(periods)) * workload.REBUILD_EVERY


def measure(options: argparse.Namespace, systems: Sequence[System], folder: Path) -> dict[str, Any]:
    """The record: every round runs each system once. A system that fails is left out of the rounds that follow."""
    variant = Variant(options.precision, options.simd)
    identity = Ljmd(options.ljmd, variant).identify()
    if identity is None:
        raise InputError(f"{options.ljmd}: cannot be run; say where ljmd is with --ljmd")
    record: dict[str, Any] = {
        "schema": SCHEMA,
        "version": VERSION,
        "date": datetime.datetime.now(datetime.timezone.utc).isoformat(timespec="seconds"),
        "host": machine.describe(),
        "ljmd": identity,
        "options": {key: getattr(options, key) for key in OPTIONS},
        "systems": [],
        "failures": [],
    }
    decks = {}
    for system in systems:
        decks[system] = folder / f"{len(decks)}.toml"
        decks[system].write_text(ljmd_program.deck(system.section(folder), options.precision, options.policy,
                                                   steps_for(system, options.seconds), system.cutoff,
                                                   system.potential))
    found: dict[System, list[dict[str, Any]]] = {system: [] for system in systems}
    for turn in range(options.repeats):
        for system in list(decks):
            try:
                found[system].append(ljmd_program.bench(options.ljmd, decks[system], variant, options.threads))
                cost = nanoseconds(found[system][-1])
                say(f"round {turn + 1}: {system.family:10} {system.label:28} {cost:9.1f} ns an atom and step")
            except ProgramFailed as error:
                say(f"{system.label}: {error}")
                record["failures"].append({"label": system.label, "words": str(error)})
                del decks[system]
    record["systems"] = [entry(system, found[system], steps_for(system, options.seconds))
                         for system in systems if found[system]]
    return record


def nanoseconds(answer: dict[str, Any]) -> float:
    """What an atom and a step cost, files left out. `answer` is of `ljmd bench`."""
    writing = answer.get("seconds_per_phase", {}).get("write", 0.0)
    return 1e9 * (1 / answer["atom_steps_per_second"] - writing / (answer["atoms"] * answer["steps"]))


def entry(system: System, answers: Sequence[dict[str, Any]], steps: int) -> dict[str, Any]:
    return {
        "family": system.family, "label": system.label, "x": system.x, "atoms": system.atoms,
        "density": system.density, "cutoff": system.cutoff, "neighbours": system.neighbours, "steps": steps,
        "nanoseconds": [nanoseconds(answer) for answer in answers],
        "bytes_per_atom": answers[-1].get("bytes_per_atom"),
    }


def fit(systems: Sequence[dict[str, Any]]) -> tuple[float, float]:
    """a and b of the cost a + b n [ns], with the least sum of squared relative deviations."""
    cost = np.array([median(one["nanoseconds"]) for one in systems])
    count = np.array([one["neighbours"] for one in systems])
    if len(set(count)) < 2:
        return float(cost.mean()), 0.0
    solution, *_ = np.linalg.lstsq(np.stack((1.0 / cost, count / cost), axis=1), np.ones(len(cost)), rcond=None)
    return float(solution[0]), float(solution[1])


def markdown(record: dict[str, Any]) -> str:
    fixed, each = fit(record["systems"])
    rows = []
    for one in record["systems"]:
        cost = median(one["nanoseconds"])
        memory = one["bytes_per_atom"]
        rows.append([one["family"], one["label"], f"{one['atoms']}", f"{one['neighbours']:.1f}", f"{cost:.1f}",
                     f"{min(one['nanoseconds']):.1f} .. {max(one['nanoseconds']):.1f}",
                     "-" if memory is None else f"{memory:.0f}",
                     f"{cost / (fixed + each * one['neighbours']):.2f}"])
    header = ["family", "system", "atoms", "neighbours", "ns an atom and step", "range", "bytes an atom", "cost / line"]
    options, host = record["options"], record["host"]
    lines = [
        HEADING,
        "",
        f"{record['date']}, {host['cpu']}, {host['cores']} cores, load {host['load_average']:.1f} at the start; "
        f"{options['threads']} of them used, {options['precision']} precision, lists {options['policy']}. Medians of "
        f"{options['repeats']} rounds. The line is {fixed:.1f} ns + {each:.2f} ns for each neighbour.",
        "",
        *report.table(header, rows),
    ]
    lines += [f"\n{one['label']} failed: {one['words']}" for one in record["failures"]]
    return "\n".join(lines) + "\n"


def draw_points(axes: plt.Axes, found: Sequence[dict[str, Any]], x: str, k: int, label: Optional[str] = None) -> None:
    """Medians against `x`, with bars from minimum to maximum."""
    if found:
        middle = np.array([median(one["nanoseconds"]) for one in found])
        low = middle - [min(one["nanoseconds"]) for one in found]
        high = [max(one["nanoseconds"]) for one in found] - middle
        axes.errorbar([one[x] for one in found], middle, yerr=(low, high), fmt="os^v"[k], markersize=4.5, capsize=2.5,
                      color=style.colour(k), label=label)


def from_zero(axes: plt.Axes) -> None:
    """Start the vertical axis at 0, with some room at the top."""
    axes.set_ylim(0.0, 1.1 * axes.get_ylim()[1])


def draw(record: dict[str, Any]) -> plt.Figure:
    """Cost against size, against neighbours, and over shapes and potentials; memory against size."""
    style.use()
    family = {name: [one for one in record["systems"] if one["family"] == name] for name in scaling_cases.FAMILIES}
    figure, grid = plt.subplots(2, 2, figsize=(10.5, 7.5), constrained_layout=True)
    size, cost, shape, memory = grid.flat
    draw_points(size, family["size"], "atoms", 0)
    size.set(xscale="log", xlabel="atoms $N$", ylabel="ns an atom and step")
    from_zero(size)
    for k, name in enumerate(("density", "cutoff", "small box")):
        draw_points(cost, family[name], "neighbours", k, name)
    fixed, each = fit(record["systems"])
    most = max(one["neighbours"] for one in record["systems"])
    line = np.array([0.0, 1.02 * most])
    cost.plot(line, fixed + each * line, "--", color=style.GREY, label=f"{fixed:.0f} ns + {each:.2f} ns $n$")
    cost.set(xlabel="neighbours $n$ on the list of an atom", ylabel="ns an atom and step")
    cost.legend()
    bars = family["shape"] + family["potential"]
    for k, one in enumerate(bars):
        middle = median(one["nanoseconds"])
        reach = ([middle - min(one["nanoseconds"])], [max(one["nanoseconds"]) - middle])
        shape.barh(k, middle, xerr=reach, color=style.SKY, capsize=2.5)
    shape.set_yticks(range(len(bars)), [one["label"] for one in bars])
    shape.invert_yaxis()
    shape.set_xlabel("ns an atom and step")
    known = [one for one in family["size"] if one["bytes_per_atom"] is not None]
    memory.plot([one["atoms"] for one in known], [one["bytes_per_atom"] for one in known], "o", color=style.BLUE)
    memory.set(xscale="log", xlabel="atoms $N$", ylabel="bytes an atom")
    from_zero(memory)
    options = record["options"]
    title = f"ljmd, {options['precision']} precision, lists {options['policy']}; {record['host']['cpu']}"
    figure.suptitle(style.plain(title), fontsize=10)
    return figure


def say(line: str) -> None:
    print(line, file=sys.stderr, flush=True)


def read(path: Path) -> dict[str, Any]:
    record = read_json(path)
    if record.get("schema") != SCHEMA or record.get("version") != VERSION:
        raise damaged(path, f"not a record of schema {SCHEMA}, version {VERSION}")
    return record


def publish(record: dict[str, Any], out: Path) -> None:
    """The record, the page and the figure; their paths are printed."""
    style.save_text(json.dumps(record, indent=1) + "\n", out / "scaling.json", MARK)
    print(out / "scaling.json")
    if record["systems"]:
        style.save_text(markdown(record), out / "scaling.md", HEADING)
        print(out / "scaling.md")
        style.save(draw(record), out / "scaling.png")


@reports_errors
def main(arguments: Optional[Sequence[str]] = None) -> int:
    options = parse(arguments)
    if options.redraw:
        publish(read(options.redraw / "scaling.json"), options.redraw)
        return 0
    if options.share:
        machine.share_cores()
    style.require_writable(options.out / "scaling.json", mark=MARK.encode())
    systems = [one for one in scaling_cases.systems(options.largest) if one.family in options.families]
    with tempfile.TemporaryDirectory(prefix="ljmd-scaling-") as folder:
        record = measure(options, systems, Path(folder))
    publish(record, options.out)
    return 1 if record["failures"] else 0


if __name__ == "__main__":
    sys.exit(main())
