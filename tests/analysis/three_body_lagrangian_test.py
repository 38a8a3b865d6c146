#!/usr/bin/env python3
"""Tests of analysis/three_body_lagrangian.py on made-up runs. Prints "N passed, M failed"."""

from __future__ import annotations

import re
import sys
from pathlib import Path

import fixtures  # noqa: I001  (it says where the modules of analysis/ are)
import numpy as np
from fixtures import EIGHT, check_error, edit, run_script, write_few_body, write_gravity

SCRIPT = "three_body_lagrangian.py"
PLACES = np.random.default_rng(1).normal(size=(3, 3))
MASSES = np.array([1.0, 0.3, 2e-6])


def write_apart(directory: Path, dimensions: int = 3, **more: float) -> Path:
    """Three unequal masses, the third close to the second."""
    places = PLACES[:, :dimensions].copy()
    places[2] = places[1] + 1e-3
    return write_gravity(directory, places, 0.1 * places, MASSES, steps=20, time_step=1e-4, **more)


def change_acceleration(path: Path, column: str, factor: float) -> None:
    lines = [line.split(",") for line in (path / "trajectory.csv").read_text().splitlines()]
    k = lines[0].index(column)
    lines[3][k] = repr(float(lines[3][k]) * factor)
    (path / "trajectory.csv").write_text("\n".join(",".join(line) for line in lines) + "\n")


def test_equations_are_shown(tmp: Path) -> None:
    result = run_script(SCRIPT, "--print")
    assert result.returncode == 0 and result.stderr == "", result
    lines = result.stdout.splitlines()
    assert lines[0].startswith("L = ") and len(lines) == 7, lines
    assert lines[1] == "x1'' = G*m2*(-x1 + x2)/r12**3 + G*m3*(-x1 + x3)/r13**3", lines[1]
    assert lines[6] == "y3'' = G*m1*(y1 - y3)/r13**3 + G*m2*(y2 - y3)/r23**3", lines[6]
    latex = run_script(SCRIPT, "--print", "latex").stdout.splitlines()
    assert latex[0].startswith("L = ") and latex[1].startswith(r"\ddot{x}_1 = ") and r"{r_{12}^{3}}" in latex[1], latex


def test_right_accelerations(tmp: Path) -> None:
    eight = write_gravity(tmp / "eight", **EIGHT, masses=[1, 1, 1], steps=50)
    runs = [eight, write_apart(tmp / "3d"), write_apart(tmp / "2d", 2), write_apart(tmp / "soft", softening=0.3)]
    result = run_script(SCRIPT, *runs)
    assert result.returncode == 0 and result.stderr == "", result
    lines = result.stdout.splitlines()
    assert len(lines) == 4, lines
    for run, line in zip(runs, lines):
        match = re.fullmatch(rf"{re.escape(str(run))}: largest relative difference (\S+) ok", line)
        assert match and 0.0 <= float(match[1]) < 1e-14, line


def test_central_mass_and_settings(tmp: Path) -> None:
    run = write_apart(tmp / "run")
    assert run_script(SCRIPT, run).returncode == 0
    edit(run / "run.json", '"settings": []', '"settings": ["force.central_mass=1e-3"]')
    result = run_script(SCRIPT, run)
    assert result.returncode == 1 and "FAILED" in result.stdout, result
    columns = np.genfromtxt(run / "trajectory.csv", delimiter=",", names=True)
    table = {name: columns[name] for name in columns.dtype.names}
    for body in "123":
        distance = np.sqrt(sum(table[f"{axis}{body}"] ** 2 for axis in "xyz"))
        for axis in "xyz":
            table[f"a{axis}{body}"] = table[f"a{axis}{body}"] - 1e-3 * table[f"{axis}{body}"] / distance**3
    fixtures.write_csv(run / "trajectory.csv", table)
    result = run_script(SCRIPT, run)
    assert result.returncode == 0, result


def test_wrong_accelerations(tmp: Path) -> None:
    slightly, round_off, missing = 1.0 + 1e-10, 1.0 + 1e-14, float("nan")
    changes = [  # also of the heavy body, which hardly feels the light one
        ("ax1", slightly, "FAILED"), ("ay2", slightly, "FAILED"), ("az3", slightly, "FAILED"),
        ("ax2", missing, "FAILED"),
        ("ay1", round_off, "ok"),
    ]
    runs = []
    for column, factor, _ in changes:
        runs.append(write_apart(tmp / column))
        change_acceleration(runs[-1], column, factor)
    runs.append(write_apart(tmp / "mass"))
    edit(runs[-1] / "run.json", "mass = 0.3", "mass = 0.30000001")
    result = run_script(SCRIPT, *runs)
    assert result.returncode == 1, result
    for line, verdict in zip(result.stdout.splitlines(), [change[2] for change in changes] + ["FAILED"]):
        assert verdict in line, line
    assert run_script(SCRIPT, runs[0], runs[4]).returncode == 1  # a good one after a bad one does not hide it


def test_runs_that_are_refused(tmp: Path) -> None:
    assert run_script(SCRIPT).returncode == 2
    two = write_gravity(tmp / "two", PLACES[:2], PLACES[:2], MASSES[:2], steps=3)
    check_error(run_script(SCRIPT, two), 2, "2 bodies")
    time = np.arange(3.0)
    still = np.zeros((3, 3, 2))
    springs = write_few_body(tmp / "springs", time, still, still, force="harmonic")
    check_error(run_script(SCRIPT, springs), 2, "harmonic")
    check_error(run_script(SCRIPT, write_few_body(tmp / "no-a", time, still, still)), 3, "accelerations = true")
    run = write_apart(tmp / "no-g")
    edit(run / "run.json", "gravitational_constant", "gravity")
    check_error(run_script(SCRIPT, run), 3, "run.json", "'gravitational_constant'")
    edit(run / "run.json", "mass = 0.3", "weight = 0.3")
    edit(run / "run.json", "gravity = ", "gravitational_constant = ")
    check_error(run_script(SCRIPT, run), 3, "run.json", "'mass'")


if __name__ == "__main__":
    sys.exit(fixtures.run_tests(globals()))
