#!/usr/bin/env python3
"""Tests of the pictures of time correlations on made-up runs. Prints "N passed, M failed"; exit code 1 if any failed."""

from __future__ import annotations

import sys
from pathlib import Path

import fixtures
import numpy as np
import structure_pictures
import time_pictures
from fixtures import plot, png_size
from fluid_pictures_test import write_run
from ljmd.reading import fluids

TIME = np.linspace(0.0, 2.0, 21)


def stacked(group: str, values: list[float], x: str, at: np.ndarray, names: tuple[str, ...]) -> dict[str, np.ndarray]:
    """One curve below the other, that of value v decaying like exp(-v x)."""
    table = {group: np.repeat(values, at.size), x: np.tile(at, len(values))}
    for name in names:
        table[name] = np.concatenate([3.0 * np.exp(-value * at) for value in values])
        table[f"{name}_standard_error"] = np.full(table[x].size, 0.02)
    return table


def write_tables(run: Path, curves: int = 7) -> Path:
    k = list(np.linspace(0.6, 7.0, curves))
    fixtures.write_csv(run / "fkt.csv", stacked("k", k, "time", TIME, ("F", "C_L", "C_T")))
    fixtures.write_csv(run / "fskt.csv", stacked("k", k, "time", TIME, ("F_s",)))
    fixtures.write_csv(run / "skw.csv", stacked("k", k, "angular_frequency", 10.0 * TIME, ("S_kw",)))
    fixtures.write_csv(run / "gs.csv", stacked("time", [0.5, 1.0], "r", TIME, ("G_s",)))
    fixtures.write_csv(run / "gd.csv", stacked("time", [0.0, 0.5, 1.0], "r", TIME, ("G_d",)))
    values = {name: np.where(np.array(k) < 2.0, 1.0 + np.array(k), np.nan) for name in time_pictures.MODES}   # none at large k
    errors = {f"{name}_standard_error": 0.1 * value for name, value in values.items()}
    fixtures.write_csv(run / "modes.csv", {"k": np.array(k), **values, **errors})
    time = TIME[1:]
    fixtures.write_csv(run / "alpha2.csv", {"time": time, "alpha_2": 0.13 * np.exp(-((time - 1.2) ** 2)), "alpha_2_standard_error": 0.01 * time})
    return run


def figures(run: Path) -> dict:
    return {name: draw() for name, draw in structure_pictures.pictures(fluids.load(run)).items()}


def test_every_table_has_its_picture(tmp: Path) -> None:
    run = write_tables(write_run(tmp / "run"))
    result = plot(run)
    assert result.returncode == 0, result.stderr
    for name in time_pictures.PICTURES:
        width, height = png_size(run / f"{name}.png")
        assert width == (420 if name == "modes" else 350) and height >= 225, (name, width, height)


def test_modes_are_drawn_where_there_are_any(tmp: Path) -> None:
    run = write_tables(write_run(tmp / "run"))
    assert len([axes for axes in figures(run)["modes"].axes if axes.get_visible()]) == 4
    text = (run / "modes.csv").read_text(encoding="utf-8").splitlines()
    first = text[0].split(",").index("sound_velocity")
    rows = [line.split(",") for line in text[1:]]
    fixtures.write_csv(run / "modes.csv", {name: np.array([float(row[place] or "nan") if place != first else np.nan for row in rows])
                                           for place, name in enumerate(text[0].split(","))})
    assert len([axes for axes in figures(run)["modes"].axes if axes.get_visible()]) == 3
    fixtures.write_csv(run / "modes.csv", {name: np.array([float(row[place]) if name == "k" else np.nan for row in rows])
                                           for place, name in enumerate(text[0].split(","))})
    assert "modes" not in figures(run)


def test_long_times_have_a_logarithmic_axis(tmp: Path) -> None:
    run = write_tables(write_run(tmp / "run"))
    assert figures(run)["fskt"].axes[0].get_xscale() == "linear"
    long = np.concatenate([TIME, [2.4, 3.2, 4.0, 5.6, 8.0]])
    fixtures.write_csv(run / "fskt.csv", stacked("k", [0.6, 3.0], "time", long, ("F_s",)))
    axes = figures(run)["fskt"].axes[0]
    assert axes.get_xscale() == "log" and axes.get_xlim() == (TIME[1], 8.0), axes.get_xlim()


def test_each_wave_number_is_a_curve_of_its_own(tmp: Path) -> None:
    drawn = figures(write_tables(write_run(tmp / "run")))
    panels = drawn["fkt"].axes
    assert len(panels) == 3
    for axes in panels:
        lines = [line for line in axes.get_lines() if not line.get_label().startswith("_")]
        assert [line.get_label() for line in lines] == ["0.6", "1.67", "2.73", "3.8", "4.87", "5.93", "7"]
        for line, value in zip(lines, np.linspace(0.6, 7.0, 7)):
            # As a part of its value at t = 0.
            assert np.allclose(line.get_ydata(), np.exp(-value * TIME), atol=1e-6)


def test_of_many_curves_some_are_drawn(tmp: Path) -> None:
    axes = figures(write_tables(write_run(tmp / "run"), curves=20))["fskt"].axes[0]
    lines = [line for line in axes.get_lines() if not line.get_label().startswith("_")]
    assert 6 <= len(lines) <= time_pictures.MOST_CURVES


def test_the_largest_alpha_is_named(tmp: Path) -> None:
    axes = figures(write_tables(write_run(tmp / "run")))["alpha2"].axes[0]
    assert [text.get_text() for text in axes.texts] == ["0.130(12) at 1.20 $\\tau$"]


if __name__ == "__main__":
    sys.exit(fixtures.run_tests(globals()))
