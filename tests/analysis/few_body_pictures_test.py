#!/usr/bin/env python3
"""Tests of the pictures of few-body runs, through plot.py. Prints "N passed, M failed"."""

from __future__ import annotations

import sys
from pathlib import Path
from typing import Any

import fixtures  # noqa: I001  (it says where the modules of analysis/ are)
import few_body_pictures
import numpy as np
from fixtures import EIGHT, edit, png_size, plot, write_few_body, write_gravity
from ljmd.reading import few_bodies
from style import plt

TIME = np.linspace(0.0, 6.0, 40)
WAVE = np.cos(TIME)[:, np.newaxis, np.newaxis]


def pictures(path: Path, relative_to: int = 0) -> dict[str, plt.Figure]:
    plt.close("all")
    return {name: draw() for name, draw in few_body_pictures.pictures(path, relative_to + 1).items()}


def lines(figure: plt.Figure, panel: int = 0) -> list[np.ndarray]:
    """The points of all lines of a panel that are more than a marker."""
    found = [line.get_xydata() for line in figure.axes[panel].get_lines()]
    return [points for points in found if len(points) > 1]


def test_pictures_are_made(tmp: Path) -> None:
    run = write_gravity(tmp / "run", **EIGHT, masses=[1, 1, 1], steps=30)
    result = plot(run, "--relative-to", 2)
    names = ["energy", "orbit", "phase", "momentum", "relative"]
    assert result.returncode == 0 and result.stderr == "", result.stderr
    assert result.stdout.splitlines() == [str(run / f"{name}.png") for name in names], result.stdout
    for name in names:
        assert min(png_size(run / f"{name}.png")) >= 150, name
        ink = np.mean(plt.imread(run / f"{name}.png")[..., :3].min(axis=2) < 0.9)
        assert 0.01 < ink < 0.4, (name, ink)
    result = plot(run, "--out", tmp / "new" / "a.svg")
    assert sorted(path.name for path in (tmp / "new").iterdir()) == sorted(f"a-{name}.svg" for name in names), result


def test_what_suits_a_run(tmp: Path) -> None:
    cases: dict[str, tuple[dict[str, Any], list[str]]] = {
        "radial": ({"force": "radial-kepler", "angle": TIME}, ["energy", "orbit", "phase"]),
        "pendulum": ({"force": "pendulum"}, ["energy", "phase"]),
        "line": ({"force": "harmonic"}, ["energy", "phase"]),
    }
    for name, (more, expected) in cases.items():
        assert list(pictures(write_few_body(tmp / name, TIME, WAVE, WAVE, **more))) == expected, name
    two = write_gravity(tmp / "two", [[0], [1]], [[0], [0]], [1, 2], steps=9, softening=0.5)
    assert list(pictures(two)) == ["energy", "phase", "momentum", "relative"]
    many = np.broadcast_to(WAVE, (40, 18, 1))
    figure = pictures(write_few_body(tmp / "many", TIME, many, many))["phase"]
    assert "1 to 16 of 18" in figure.axes[12].get_xlabel(), figure.axes[12].get_xlabel()


def test_what_the_pictures_show(tmp: Path) -> None:
    path = write_gravity(tmp / "run", **EIGHT, masses=[1, 1, 1], steps=50)
    run = few_bodies.load(path)
    made = pictures(path, relative_to=1)
    frames = run.trajectory
    for body in range(3):
        assert np.array_equal(lines(made["orbit"])[body], frames.positions[:, body])
        seen = frames.positions[:, body] - frames.positions[:, 1]
        assert np.array_equal(lines(made["relative"])[body], seen)
        assert np.array_equal(lines(made["phase"], body)[0][:, 1], frames.velocities[:, body, 0])
    for name in ("orbit", "relative"):
        assert made[name].axes[0].get_aspect() == 1.0, name
    energy = run.thermo["total_energy"]
    assert np.array_equal(lines(made["energy"])[0][:, 1], energy - energy[0])
    legend = made["energy"].axes[1].get_legend()
    assert [text.get_text() for text in legend.get_texts()] == ["kinetic", "potential", "total"]
    assert len(lines(made["momentum"], 0)) == 2 and len(lines(made["momentum"], 1)) == 1
    spin = run.thermo["angular_momentum_z"]
    assert np.array_equal(lines(made["momentum"], 1)[0][:, 1], spin - spin[0])


def test_tracks_that_coincide_are_all_seen(tmp: Path) -> None:
    figure = pictures(write_gravity(tmp / "eight", **EIGHT, masses=[1, 1, 1], steps=400))["orbit"]
    drawn = [line.get_linewidth() for line in figure.axes[0].get_lines() if len(line.get_xydata()) > 1]
    assert drawn[0] > 1.5 * drawn[1] > 3.0 * drawn[2], drawn  # each thinner than the one below
    texts = [text.get_text() for text in figure.axes[0].get_legend().get_texts()]
    assert texts == ["body 1", "body 2", "body 3", "start", "end"], texts
    apart = write_gravity(tmp / "two", [[0.0, 0.0], [1.0, 0.0]], [[0.0, 0.0], [0.0, 1.0]], [1.0, 1e-3], steps=300)
    drawn = [line.get_linewidth() for line in pictures(apart)["orbit"].axes[0].get_lines() if len(line.get_xydata()) > 1]
    assert drawn[0] == drawn[1], drawn
    still = np.zeros((40, 2, 2))
    pictures(write_few_body(tmp / "still", TIME, still, still))  # a path without a size


def test_one_row_and_no_trajectory(tmp: Path) -> None:
    run = write_gravity(tmp / "run", **EIGHT, masses=[1, 1, 1], steps=0)
    assert plot(run).returncode == 0
    (run / "trajectory.csv").unlink()
    edit(run / "run.json", "made-up bodies", r"50 $ and \\unknown 60 $")
    result = plot(run)
    assert result.returncode == 0 and len(result.stdout.splitlines()) == 2, result
    assert len(result.stderr.splitlines()) == 1 and "trajectory.csv" in result.stderr, result.stderr


def test_mistakes(tmp: Path) -> None:
    run = write_gravity(tmp / "run", **EIGHT, masses=[1, 1, 1], steps=5)
    fixtures.check_error(plot(run, "--relative-to", 4), 2, "no body 4", "has 3")
    (tmp / "run" / "results.json").unlink()
    fixtures.check_error(plot(run), 3, "results.json", "no such file")


if __name__ == "__main__":
    sys.exit(fixtures.run_tests(globals()))
