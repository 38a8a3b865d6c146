#!/usr/bin/env python3
"""Tests of analysis/convergence.py with a script in place of ljmd. Prints "N passed, M failed"."""

from __future__ import annotations

import csv
import re
import sys
from pathlib import Path
from typing import Any

import fixtures  # noqa: I001  (it says where the modules of analysis/ are)
import convergence
from fixtures import check_error, edit, png_size, run_script

DECK = """title = "made-up orbit"
[[body]]
mass = 1.0
position = [-1.0, 0.0]
[[body]]
mass = 1.0
position = [1.0, 0.0]
[[stage]]
name = "orbit"
integrator = "slow"
time_step = 0.01
steps = 1000
"""
# Errors of order 1 and 4; the fast one has a floor of round-off, the slow one fails at long time steps.
PROGRAM = """#!{python}
import json, sys
open({log!r}, "a").write(" ".join(sys.argv[1:]) + "\\n")
if sys.argv[1:] == ["info", "--json"]:
    print(json.dumps({{"integrators": [{{"name": "slow", "order": 1}}, {{"name": "fast", "order": 4}},
        {{"name": "exact", "order": 8, "adaptive": True}}]}}))
    sys.exit()
if sys.argv[1] == "check":
    print("{{}}")
    sys.exit()
settings = dict(text.split("=") for text in sys.argv[2:] if "=" in text)
h = float(settings["stage.orbit.time_step"])
assert abs(h * int(settings["stage.orbit.steps"]) - 10.0) < 1e-12, settings
order = {{"slow": 1, "fast": 4}}[settings["stage.orbit.integrator"]]
if order == 1 and h > 0.05:
    print("error: blown up", file=sys.stderr)
    sys.exit(5)
noise = 1e-12 if order == 4 else 0.0
position = 30.0 if h > 0.3 else 2.0 * h**order + noise
print(json.dumps({{"largest_position_error": position, "largest_energy_error": 0.1 * h**order + noise}}))
"""


def prepare(tmp: Path) -> tuple[Path, Path, Path]:
    """The deck, the program, and the file into which the program writes how it was called."""
    (tmp / "made.toml").write_text(DECK)
    (tmp / "ljmd").write_text(PROGRAM.format(python=sys.executable, log=str(tmp / "log")))
    (tmp / "ljmd").chmod(0o755)
    return tmp / "made.toml", tmp / "ljmd", tmp / "log"


def run(tmp: Path, *arguments: Any) -> Any:
    return run_script("convergence.py", tmp / "made.toml", "--ljmd", tmp / "ljmd", "--output", tmp / "out", *arguments)


def test_all_integrators(tmp: Path) -> None:
    deck, _, log = prepare(tmp)
    result = run(tmp)
    assert result.returncode == 0, result
    lines = result.stdout.splitlines()
    assert re.split(" +", lines[0]) == ["integrator", "order", "position", "energy"], lines
    assert re.split(" +", lines[1]) == ["slow", "1", "1.00", "1.00"], lines
    assert re.split(" +", lines[2]) == ["fast", "4", "4.00", "4.00"], lines
    assert lines[3:] == [str(tmp / "out" / "convergence.csv"), str(tmp / "out" / "convergence.png")], lines
    assert result.stderr.splitlines() == ["slow at 0.08: no finite errors, left out"], result.stderr
    assert png_size(tmp / "out" / "convergence.png") == (1700, 1800)
    with (tmp / "out" / "convergence.csv").open() as file:
        rows = list(csv.DictReader(file))
    assert list(rows[0]) == ["integrator", "time_step", "position_error", "energy_error"], rows[0]
    assert len(rows) == 6 + 7 and float(rows[0]["time_step"]) == 0.04 and float(rows[-1]["time_step"]) == 0.00125, rows
    assert float(rows[0]["position_error"]) == 0.08
    calls = log.read_text().splitlines()
    assert len(calls) == 2 + 14 and calls[:2] == [f"check {deck} --json --quiet", "info --json"], calls
    stage = "--set stage.orbit.integrator=slow --set stage.orbit.time_step=0.08 --set stage.orbit.steps=125"
    assert calls[2] == f"compare {deck} --with gsl --json --quiet {stage}", calls[2]


def test_chosen_integrators_and_time_steps(tmp: Path) -> None:
    _, _, log = prepare(tmp)
    result = run(tmp, "--integrators", "fast", "--time-steps", "0.4,0.03,0.0101,0.01,0.0001")
    assert result.returncode == 0 and result.stderr == "", result
    assert result.stdout.splitlines()[1].split() == ["fast", "4", "4.00", "4.00"], result.stdout
    steps = re.findall(r"steps=(\d+)", log.read_text())
    assert steps == ["25", "333", "990", "1000", "100000"], steps  # the last is round-off, the first no orbit any more


def test_settings(tmp: Path) -> None:
    deck, _, log = prepare(tmp)
    settings = ["--set", "stage.orbit.time_step=0.02", "--set", "stage.orbit.steps=500"]
    result = run(tmp, "--integrators", "fast", "--time-steps", "0.01", *settings)
    assert result.returncode == 0, result
    calls = log.read_text().splitlines()
    assert calls[0] == f"check {deck} --json --quiet {' '.join(settings)}", calls[0]
    stage = "--set stage.orbit.integrator=fast --set stage.orbit.time_step=0.01 --set stage.orbit.steps=1000"
    assert calls[2] == f"compare {deck} --with gsl --json --quiet {' '.join(settings)} {stage}", calls[2]


def test_size_of_an_orbit(tmp: Path) -> None:
    bodies = [{"position": [3.0, 4.0]}, {"position": [3.0, -2.0]}]
    assert convergence.orbit_size({"body": bodies}) == 6.0
    assert convergence.orbit_size({"body": bodies[:1]}) == 5.0
    assert convergence.orbit_size({"body": [{"position": [0.0]}]}) == convergence.orbit_size({}) == 1.0


def test_nothing_to_fit(tmp: Path) -> None:
    prepare(tmp)
    result = run(tmp, "--integrators", "slow", "--time-steps", "1,0.02")
    assert result.returncode == 0 and result.stdout.splitlines()[1].split() == ["slow", "1", "-", "-"], result
    result = run(tmp, "--integrators", "slow", "--time-steps", "1")
    assert result.returncode == 0 and (tmp / "out" / "convergence.csv").read_text().count("\n") == 1, result


def test_mistakes(tmp: Path) -> None:
    deck, program, _ = prepare(tmp)
    check_error(run(tmp, "--integrators", "fast,quick"), 2, "no integrator 'quick'", "slow, fast, exact")
    assert run(tmp, "--time-steps", "0.1,-1").returncode == 2
    check_error(run_script("convergence.py", deck, "--ljmd", tmp / "none"), 2, "none: cannot be run", "--ljmd")
    edit(program, "sys.exit(5)", "sys.exit(2)")
    check_error(run(tmp), 2, "error: blown up", "integrator=slow")
    edit(deck, 'steps = 1000\n', 'steps = 1000\n[[stage]]\nname = "two"\n')
    check_error(run(tmp), 2, "2 stages")
    edit(deck, 'steps = 1000\n[[stage]]\nname = "two"\n', "steps = 0\n")
    check_error(run(tmp), 2, "above 0")
    deck.unlink()
    check_error(run(tmp), 2, "no such file")


if __name__ == "__main__":
    sys.exit(fixtures.run_tests(globals()))
