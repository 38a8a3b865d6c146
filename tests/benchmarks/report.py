"""The record of a benchmark: a versioned JSON object, and a Markdown page made from it.

    schema        "ljmd-benchmark"
    version       1; higher when a reader of lower versions would go wrong
    date, host, ljmd, options
    workload      of workload.py, with the list policy
    programs      name -> precision, note, identity (version and build; null: not installed)
    peaks         of peaks.cpp; null without a compiler
    checks        runs of a fixed number of steps on one thread: energies per atom
    runs          every timed run: program, atoms, threads, round, steps, seconds, rate [atom-steps/s], energies per
                  atom, details; of the whole process, start-up included: wall_seconds, processor_seconds of its threads,
                  other_work (mean number of cores busy with something else)
    failures      program, atoms, threads, round and words of every run that went wrong
    rates         program, atoms, threads: median, minimum, maximum, rounds
    ratios        program, peer, atoms, threads: of rate(program)/rate(peer) within a round
"""

from __future__ import annotations

import json
from pathlib import Path
from typing import Any, Iterable, Sequence

import machine
import ratios
import style
from ljmd.reading.files import damaged, read_json
import workload

SCHEMA = "ljmd-benchmark"
VERSION = 1
WORDS = ("program", "family", "system")

Record = dict[str, Any]


def begin(**parts: Any) -> Record:
    """A record without runs. `parts`: date, host, ljmd, options, programs, peaks, policy."""
    work = {"name": "Lennard-Jones melt", "density": workload.DENSITY, "temperature": workload.TEMPERATURE,
            "cutoff": workload.CUTOFF, "skin": workload.SKIN, "time_step": workload.TIME_STEP,
            "thermo_every": workload.THERMO_EVERY, "rebuild_every": workload.REBUILD_EVERY, "seed": workload.SEED,
            "policy": parts.pop("policy")}
    return {"schema": SCHEMA, "version": VERSION, **parts, "workload": work, "checks": [], "runs": [], "failures": [],
            "rates": [], "ratios": []}


def ours(record: Record) -> list[str]:
    """Names of the variants of ljmd."""
    return [name for name in record["programs"] if name.split()[0] == "ljmd"]


def peers(record: Record) -> list[str]:
    """Names of the peers that are installed."""
    return [name for name, program in record["programs"].items()
            if name not in ours(record) and program["identity"] is not None]


def summarise(record: Record) -> None:
    """Work out rates and ratios anew from the runs."""
    record["rates"] = ratios.rates(record["runs"], [*ours(record), *peers(record)])
    record["ratios"] = ratios.ratios(record["runs"], ours(record), peers(record))


def write(record: Record, path: Path) -> None:
    style.save_text(json.dumps(record, indent=1) + "\n", path, f'"schema": "{SCHEMA}"')


def read(path: Path) -> Record:
    """A record that `write` wrote. Raises DataError for anything else."""
    record = read_json(path)
    if record.get("schema") != SCHEMA or record.get("version") != VERSION:
        raise damaged(path, f"not a record of schema {SCHEMA}, version {VERSION}")
    return record


def table(header: Sequence[str], rows: Iterable[Sequence[str]]) -> list[str]:
    """Lines of a Markdown table; columns are of numbers but for those named in WORDS."""
    lines = [header, ["---" if name in WORDS else "---:" for name in header], *rows]
    return ["| " + " | ".join(line) + " |" for line in lines]


def cell(found: Sequence[Record], scale: float, digits: int) -> str:
    """Median with its extremes, of the one summary that was found; a dash for none."""
    if not found:
        return "-"
    one = found[0]
    numbers = [f"{one[key] * scale:.{digits}f}" for key in ("median", "minimum", "maximum")]
    return f"{numbers[0]} ({numbers[1]} .. {numbers[2]})"


def ratio_tables(record: Record) -> list[str]:
    names = peers(record)
    lines = []
    for program in ours(record) if names else []:
        rows = []
        for atoms, threads in ratios.groups(record["runs"]):
            found = [ratios.select(record["ratios"], program=program, peer=peer, atoms=atoms, threads=threads)
                     for peer in names]
            rows.append([f"{atoms}", f"{threads}", *(cell(one, 1.0, 2) for one in found)])
        lines += [f"## {program} / peer", "", *table(["atoms", "threads", *names], rows), ""]
    return lines


def rate_table(record: Record) -> list[str]:
    names = [*ours(record), *peers(record)]
    rows = []
    for atoms, threads in ratios.groups(record["runs"]):
        found = [ratios.select(record["rates"], program=name, atoms=atoms, threads=threads) for name in names]
        others = ratios.summary(run["other_work"] for run in record["runs"]
                                if (run["atoms"], run["threads"]) == (atoms, threads))
        busy = cell([others] if others else [], 1.0, 1)
        rows.append([f"{atoms}", f"{threads}", *(cell(one, 1e-6, 2) for one in found), busy])
    header = ["atoms", "threads", *names, "cores busy with other work"]
    return ["## Million atom-steps a second", "", *table(header, rows), "", *crowded(record)]


def crowded(record: Record) -> list[str]:
    """A warning, where other work took cores from runs."""
    runs = record["runs"]
    lacking = sum(lacked_cores(run, record) for run in runs)
    if lacking == 0:
        return []
    return [f"**{lacking} of {len(runs)} runs did not have the cores that they wanted: other work was running. Ratios "
            "within a round suffer less than rates, but repeat the measurement when the machine is quiet.**", ""]


def lacked_cores(run: dict[str, Any], record: Record) -> bool:
    return machine.Use(0.0, 0.0, run["other_work"]).is_crowded(run["threads"], record["host"]["cores"])


def processor_table(record: Record) -> list[str]:
    """Cores that each program had on the mean: fewer than its threads where these waited, or others had the cores."""
    names = [*ours(record), *peers(record)]
    rows = []
    for atoms, threads in ratios.groups(record["runs"]):
        used = [ratios.summary(run["processor_seconds"] / run["wall_seconds"] for run in record["runs"]
                               if (run["program"], run["atoms"], run["threads"]) == (name, atoms, threads)
                               and "wall_seconds" in run)  # older records have none
                for name in names]
        rows.append([f"{atoms}", f"{threads}", *(cell([one] if one else [], 1.0, 2) for one in used)])
    return ["## Processor time over wall time, start-up included", "", *table(["atoms", "threads", *names], rows), ""]


def check_table(record: Record) -> list[str]:
    if not record["checks"]:
        return []
    rows = [[str(one["atoms"]), one["program"], f"{one['potential_energy_initial']:.9f}",
             f"{one['potential_energy_final']:.9f}", f"{one['total_energy_final']:.9f}"] for one in record["checks"]]
    steps = record["checks"][0]["steps"]
    header = ["atoms", "program", "U/N at the start", f"U/N after {steps} steps", f"E/N after {steps} steps"]
    return ["## The same start, the same motion", "", *table(header, rows), ""]


def program_list(record: Record) -> list[str]:
    lines = ["## Programs", ""]
    for name, program in record["programs"].items():
        identity = program["identity"]
        known = [f"{key} {value}" for key, value in (identity or {}).items() if value]
        words = "absent" if identity is None else ", ".join(known)
        note = f"; {program['note']}" if program["note"] else ""
        lines.append(f"- {name}: {program['precision']} precision{note}; {words}")
    return [*lines, ""]


def failure_list(record: Record) -> list[str]:
    if not record["failures"]:
        return []
    lines = [f"- {one['program']}, {one['atoms']} atoms, threads {one['threads']}: {one['words']}"
             for one in record["failures"]]
    return ["## What went wrong", "", *lines, ""]


def markdown(record: Record) -> str:
    """The page: ratios first, as rates alone say more of the machine than of the program."""
    host, work = record["host"], record["workload"]
    shared = " Threads and processes that wait give up their core." if record["options"]["share"] else ""
    lines = [
        f"# {work['name']}, lists {work['policy']}",
        "",
        f"{record['date']}, {host['cpu']}, {host['cores']} cores, load {host['load_average']:.1f} at the start. "
        f"Medians of {record['options']['repeats']} interleaved rounds (minimum .. maximum); time loops alone, without "
        f"start-up.{shared}",
        "",
        *ratio_tables(record), *rate_table(record), *processor_table(record), *check_table(record), *program_list(record), *failure_list(record),
    ]
    return "\n".join(lines).rstrip() + "\n"
