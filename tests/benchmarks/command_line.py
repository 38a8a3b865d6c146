"""The options that the benchmarks have in common."""

from __future__ import annotations

import argparse
from pathlib import Path
from typing import Any, Optional, Sequence

import workload

LJMD = Path(__file__).resolve().parents[2] / "build" / "release" / "ljmd"


def parser(description: str, *, policy: str, out: str, quick: str) -> argparse.ArgumentParser:
    """A parser of the common options. What `parse` is to give a default has none yet.

    `quick`: what a look is like."""
    made = argparse.ArgumentParser(description=description)
    made.add_argument("--ljmd", type=Path, default=LJMD)
    made.add_argument("--simd", help="instructions that ljmd may use (default: the best it finds)")
    made.add_argument("--policy", choices=workload.POLICIES, default=policy, help="when lists are made anew")
    made.add_argument("--repeats", type=int, help="rounds")
    made.add_argument("--seconds", type=float, help="that a run is to take, about")
    made.add_argument("--out", type=Path, default=Path(out))
    made.add_argument("--share", action="store_true",
                      help="for a machine with other work: whoever waits for another thread gives up its core")
    made.add_argument("--redraw", type=Path, metavar="DIR", help="only make page and figures anew")
    made.add_argument("--quick", action="store_true", help=f"a look: {quick}, unless others are asked for")
    return made


def parse(made: argparse.ArgumentParser, arguments: Optional[Sequence[str]], full: dict[str, Any],
          quick: dict[str, Any]) -> argparse.Namespace:
    """The options; those that were not given are as in `full`, with --quick as in `quick`."""
    options = made.parse_args(arguments)
    for name, value in (quick if options.quick else full).items():
        if getattr(options, name) is None:
            setattr(options, name, value)
    return options
