#!/usr/bin/env python3
"""Tests of analysis/derivatives.py and fitting.py on made-up runs. Prints "N passed, M failed"."""

from __future__ import annotations

import math
import re
import sys
from pathlib import Path

import fixtures  # noqa: I001  (it says where the modules of analysis/ are)
import derivatives
import fitting
import numpy as np
from fixtures import EIGHT, check_error, png_size, run_script, write_few_body, write_gravity


def write_oscillator(directory: Path, time: np.ndarray, wrong: float = 0.0) -> Path:
    """x = cos(2 t), exact; `wrong` is added to velocity and acceleration."""
    columns = [np.cos(2.0 * time), -2.0 * np.sin(2.0 * time) + wrong, -4.0 * np.cos(2.0 * time) + wrong]
    return write_few_body(directory, time, *(column[:, np.newaxis, np.newaxis] for column in columns), force="harmonic")


def slopes(output: str) -> dict[str, float]:
    return {name: float(value) for name, value in re.findall(r"^slope (\S+) (-?\d\.\d{3})$", output, re.MULTILINE)}


def test_slopes_of_an_oscillator(tmp: Path) -> None:
    run = write_oscillator(tmp / "run", 0.005 * np.arange(2001))
    result = run_script("derivatives.py", run)
    assert result.returncode == 0 and result.stderr == "", result
    found = slopes(result.stdout)
    assert list(found) == ["one-sided", "first", "second"], result.stdout
    assert abs(found["one-sided"] - 1.0) < 0.0015, found
    assert abs(found["first"] - 2.0) < 0.001 and abs(found["second"] - 2.0) < 0.001, found
    assert result.stdout.splitlines()[-1] == str(run / "derivatives.png")
    assert png_size(run / "derivatives.png") == (1400, 1000)


def test_short_runs_have_the_same_slopes(tmp: Path) -> None:
    result = run_script("derivatives.py", write_oscillator(tmp / "run", 0.005 * np.arange(130)))  # a fifth of a period
    assert result.returncode == 0, result
    found = slopes(result.stdout)
    assert abs(found["first"] - 2.0) < 0.001 and abs(found["second"] - 2.0) < 0.001, found


def test_wrong_derivatives_show(tmp: Path) -> None:
    result = run_script("derivatives.py", write_oscillator(tmp / "run", 0.005 * np.arange(2001), wrong=1e-3))
    assert result.returncode == 0, result
    assert slopes(result.stdout)["first"] < 1.7 and slopes(result.stdout)["second"] < 1.8, result


def test_errors_of_a_cubic(tmp: Path) -> None:
    time, h = 0.01 * np.arange(64), 0.03
    expected = {  # of x = t^3, whose second difference is exact
        "one-sided": 3.0 * time[3:-3] * h + h**2,
        "first": np.full(58, h**2),
        "second": np.zeros(58),
    }
    for kind, errors in expected.items():
        found = derivatives.errors_of(kind, 3, 0.01, time**3, 3.0 * time**2, 6.0 * time)
        assert np.allclose(found, errors, rtol=0.0, atol=1e-11), (kind, found)


def test_power_law(tmp: Path) -> None:
    step = np.array([0.1, 0.2, 0.5])
    law = fitting.power_law(step, 3.0 * step**4)
    assert math.isclose(law.slope, 4.0) and math.isclose(law.factor, 3.0), law
    assert np.allclose(law(step), 3.0 * step**4)
    assert math.isnan(fitting.power_law(step[:1], step[:1]).slope)


def test_runs_that_are_refused(tmp: Path) -> None:
    time = 0.005 * np.arange(200)
    eight = write_gravity(tmp / "eight", **EIGHT, masses=[1, 1, 1], steps=9)
    check_error(run_script("derivatives.py", eight), 2, "3 bodies")
    uneven = np.where(time < 0.5, time, time + 0.001)
    check_error(run_script("derivatives.py", write_oscillator(tmp / "uneven", uneven)), 3, "not equally spaced")
    check_error(run_script("derivatives.py", write_oscillator(tmp / "coarse", 400.0 * time)), 3, "closer in time")
    check_error(run_script("derivatives.py", write_oscillator(tmp / "short", time[:5])), 3, "5 rows")
    one = np.zeros((200, 1, 1))
    check_error(run_script("derivatives.py", write_few_body(tmp / "no-a", time, one, one)), 3, "accelerations = true")


if __name__ == "__main__":
    sys.exit(fixtures.run_tests(globals()))
