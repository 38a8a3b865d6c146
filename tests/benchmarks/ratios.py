"""Rates and ratios of rates from the runs of a benchmark.

A run is a dictionary with at least `program`, `atoms`, `threads`, `round` and `rate` (atom-steps a second). A ratio is
taken between runs of one round, which ran side by side: what slows the whole machine for a while slows both.
"""

from __future__ import annotations

from statistics import median
from typing import Any, Iterable, Optional

Run = dict[str, Any]


def summary(values: Iterable[float]) -> Optional[dict[str, float]]:
    """Median, extremes and number of values; None without values."""
    found = sorted(values)
    if not found:
        return None
    return {"median": median(found), "minimum": found[0], "maximum": found[-1], "rounds": len(found)}


def groups(runs: Iterable[Run]) -> list[tuple[int, int]]:
    """The pairs (atoms, threads) among the runs, in order."""
    return sorted({(run["atoms"], run["threads"]) for run in runs})


def rates_by_round(runs: Iterable[Run], program: str, atoms: int, threads: int) -> dict[int, float]:
    return {run["round"]: run["rate"] for run in runs
            if (run["program"], run["atoms"], run["threads"]) == (program, atoms, threads)}


def rates(runs: list[Run], programs: Iterable[str]) -> list[dict[str, Any]]:
    """Summary of the rates of each program at each size and number of threads."""
    found = []
    for program in programs:
        for atoms, threads in groups(runs):
            values = summary(rates_by_round(runs, program, atoms, threads).values())
            if values:
                found.append({"program": program, "atoms": atoms, "threads": threads, **values})
    return found


def ratios(runs: list[Run], ours: Iterable[str], peers: Iterable[str]) -> list[dict[str, Any]]:
    """Summary over the rounds of rate(program)/rate(peer), of those rounds in which both ran."""
    found = []
    others = list(peers)
    for program in ours:
        for peer in others:
            for atoms, threads in groups(runs):
                own = rates_by_round(runs, program, atoms, threads)
                other = rates_by_round(runs, peer, atoms, threads)
                values = summary(own[k] / other[k] for k in own.keys() & other.keys())
                if values:
                    found.append({"program": program, "peer": peer, "atoms": atoms, "threads": threads, **values})
    return found


def select(summaries: Iterable[dict[str, Any]], **wanted: Any) -> list[dict[str, Any]]:
    """Those summaries that have all the wanted values, by number of atoms."""
    fitting = [one for one in summaries if all(one[key] == value for key, value in wanted.items())]
    return sorted(fitting, key=lambda one: one["atoms"])
