#!/usr/bin/env python3
"""Tests of ljmd.reading.few_bodies and of analysis/few_body_points.py on made-up runs. Prints "N passed, M failed"; exit code 1 if any failed."""

from __future__ import annotations

import sys
from pathlib import Path

import fixtures  # noqa: I001  (it says where the modules of analysis/ are)
import few_body_points
import numpy as np
from ljmd.reading import few_bodies, fluids
from fixtures import EIGHT, edit, refused, write_few_body, write_gravity

TIME = np.linspace(0.0, 1.0, 5)
ONE = np.arange(5.0)[:, np.newaxis, np.newaxis]


def test_what_a_run_holds(tmp: Path) -> None:
    run = few_bodies.load(write_gravity(tmp / "run", **EIGHT, masses=[1, 1, 1], steps=10))
    assert (run.bodies, run.dimensions, run.force, run.title) == (3, 2, "newtonian-gravity", "made-up bodies")
    assert run.trajectory.positions.shape == (11, 3, 2) and len(run.thermo["total_energy"]) == 11
    assert np.allclose(run.trajectory.positions[0], EIGHT["positions"])
    assert few_body_points.plane_points(run).shape == few_body_points.phase_points(run).shape == (11, 3, 2)
    assert np.array_equal(few_body_points.phase_points(run)[:, 1, 1], run.trajectory.velocities[:, 1, 0])


def test_trajectory_with_three_components(tmp: Path) -> None:
    path = write_gravity(tmp / "run", **EIGHT, masses=[1, 1, 1], steps=3)
    (path / "trajectory.csv").unlink()
    positions = np.random.default_rng(1).normal(size=(4, 3, 3))
    fixtures.write_h5md(path / "trajectory.h5md", positions, None, "unit of the deck")
    frames = few_bodies.load(path).trajectory
    assert np.array_equal(frames.positions, positions[:, :, :2])
    assert np.array_equal(frames.velocities, 2.0 * positions[:, :, :2])


def test_points_in_the_plane(tmp: Path) -> None:
    angle = np.pi / 2.0 * np.arange(5)
    run = few_bodies.load(write_few_body(tmp / "radial", TIME, ONE, ONE, force="radial-kepler", angle=angle))
    expected = [[0, 0], [0, 1], [-2, 0], [0, -3], [4, 0]]
    assert np.allclose(few_body_points.plane_points(run)[:, 0], expected), few_body_points.plane_points(run)
    turns = angle[:, np.newaxis, np.newaxis]
    run = few_bodies.load(write_few_body(tmp / "pendulum", TIME, turns, turns, force="pendulum"))
    expected = [[0, -1], [1, 0], [0, 1], [-1, 0], [0, -1]]
    assert np.allclose(few_body_points.plane_points(run)[:, 0], expected), few_body_points.plane_points(run)
    two = np.concatenate([turns, -turns], axis=1)
    run = few_bodies.load(write_few_body(tmp / "pendulums", TIME, two, two, force="pendulum"))
    assert np.allclose(few_body_points.plane_points(run)[1], [[1, 0], [-1, 0]]), few_body_points.plane_points(run)
    run = few_bodies.load(write_few_body(tmp / "line", TIME, ONE, ONE, force="harmonic"))
    assert few_body_points.plane_points(run) is None
    (tmp / "line" / "trajectory.csv").unlink()
    run = few_bodies.load(tmp / "line")
    assert run.trajectory is None and few_body_points.plane_points(run) is few_body_points.phase_points(run) is None


def test_relative_to_a_body(tmp: Path) -> None:
    points = np.random.default_rng(1).normal(size=(4, 3, 2))
    seen = few_body_points.relative(points, 1)
    assert np.array_equal(seen[:, 1], np.zeros((4, 2)))
    assert np.array_equal(seen[:, 2], points[:, 2] - points[:, 1])


def test_runs_that_are_refused(tmp: Path) -> None:
    path = write_gravity(tmp / "run", **EIGHT, masses=[1, 1, 1], steps=3)
    run = few_bodies.load(path)
    assert few_body_points.body_index(run, 3) == 2
    for number in (0, 4, -1):
        refused(lambda: few_body_points.body_index(run, number), f"no body {number}", exit_code=2)
    refused(lambda: fluids.load(path), "few-body", exit_code=2)
    edit(path / "results.json", '"bodies": 3', '"bodies": 2')
    refused(lambda: few_bodies.load(path), "3 bodies", "has 2 in 2")
    edit(path / "run.json", "few-body", "fluid")
    refused(lambda: few_bodies.load(path), "fluid", exit_code=2)
    edit(path / "run.json", "fluid", "plasma")
    refused(lambda: few_bodies.load(path), "run.json", "'plasma'")
    refused(lambda: few_bodies.load(tmp / "none"), "no such directory", exit_code=2)


if __name__ == "__main__":
    sys.exit(fixtures.run_tests(globals()))
