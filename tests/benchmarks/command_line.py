"""The options that the benchmarks have in common."""

from __future__ import annotations

import argparse
from pathlib import Path

import workload

LJMD = Path(__file__).resolve().parents[2] / "build" / "release" / "ljmd"


def parser(description: str, *, policy: str, repeats: int, seconds: float, out: str) -> argparse.ArgumentParser:
    """A parser of the common options, with the defaults that differ between benchmarks."""
    made = argparse.ArgumentParser(description=description)
    made.add_argument("--ljmd", type=Path, default=LJMD)
    made.add_argument("--simd", help="instructions that ljmd may use (default: the best it finds)")
    made.add_argument("--policy", choices=workload.POLICIES, default=policy, help="when lists are made anew")
    made.add_argument("--repeats", type=int, default=repeats, help="rounds")
    made.add_argument("--seconds", type=float, default=seconds, help="that a run is to take, about")
    made.add_argument("--out", type=Path, default=Path(out))
    made.add_argument("--share", action="store_true",
                      help="for a machine with other work: whoever waits for another thread gives up its core")
    made.add_argument("--redraw", type=Path, metavar="DIR", help="only make page and figures anew")
    return made
