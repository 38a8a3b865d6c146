#!/usr/bin/env python3
"""Tests of analysis/animation_scenes.py on made-up runs. Prints "N passed, M failed"; exit code 1 if any failed."""

from __future__ import annotations

import json
import sys
from pathlib import Path

import fixtures  # noqa: I001  (it says where the modules of analysis/ are)
import numpy as np
import spheres
from ljmd.reading import few_bodies
from animation_scenes import BoxScene, PathScene
from fixtures import EIGHT, edit, refused, write_few_body, write_fluid, write_gravity

TIME = np.linspace(0.0, 6.0, 40)
WAVE = np.cos(TIME)[:, np.newaxis, np.newaxis]


def dots(scene: PathScene) -> np.ndarray:
    return np.array([dot.get_xydata()[0] for dot in scene.dots])


def test_bodies_and_their_trails(tmp: Path) -> None:
    run = few_bodies.load(write_gravity(tmp / "run", **EIGHT, masses=[1, 1, 1], steps=80))
    scene = PathScene(run, 5, None)
    assert scene.rows.tolist() == [0, 20, 40, 60, 80], scene.rows
    scene.draw(0)
    assert np.allclose(dots(scene), EIGHT["positions"])
    assert len(scene.trails[0].get_segments()) == 0
    scene.draw(3)
    r = run.trajectory.positions
    assert np.array_equal(dots(scene), r[60])
    segments, colours = np.array(scene.trails[2].get_segments()), scene.trails[2].get_color()
    assert np.array_equal(segments[-1], r[59:61, 2]) and np.array_equal(segments[0], r[50:52, 2]), segments
    assert colours[0, 3] == 0.0 and colours[-1, 3] == 1.0 and np.all(np.diff(colours[:, 3]) > 0.0), colours
    assert f"{run.trajectory.time[60]:.6g}" in scene.axes.get_title()
    assert scene.axes.get_aspect() == 1.0


def test_seen_from_a_body(tmp: Path) -> None:
    run = few_bodies.load(write_gravity(tmp / "run", **EIGHT, masses=[1, 1, 1], steps=10))
    scene = PathScene(run, 5, 2)
    scene.draw(4)
    r = run.trajectory.positions[10]
    assert np.array_equal(dots(scene), r - r[2]) and "body 3" in scene.axes.get_xlabel()
    one = few_bodies.load(write_few_body(tmp / "one", TIME, WAVE, WAVE, force="pendulum"))
    refused(lambda: PathScene(one, 5, 0), "one body", exit_code=2)


def test_limits_hold_all_points(tmp: Path) -> None:
    run = few_bodies.load(write_gravity(tmp / "run", **EIGHT, masses=[1, 1, 1]))
    scene = PathScene(run, 5, None)
    for k, (low, high) in enumerate((scene.axes.get_xlim(), scene.axes.get_ylim())):
        assert low < scene.points[:, :, k].min() and high > scene.points[:, :, k].max()
    still = few_bodies.load(write_few_body(tmp / "still", TIME, 0.0 * WAVE, 0.0 * WAVE, force="pendulum"))
    scene = PathScene(still, 3, None)
    scene.draw(1)
    assert np.all(np.isfinite(scene.axes.get_xlim()))


def test_one_dimension(tmp: Path) -> None:
    scene = PathScene(few_bodies.load(write_few_body(tmp / "line", TIME, WAVE, -WAVE, force="harmonic")), 40, None)
    scene.draw(7)
    assert np.array_equal(dots(scene), [[WAVE[7, 0, 0], -WAVE[7, 0, 0]]]) and not scene.rods
    assert scene.axes.get_ylabel() == "$v_x$"
    scene = PathScene(few_bodies.load(write_few_body(tmp / "rod", TIME, WAVE, WAVE, force="pendulum")), 40, None)
    scene.draw(7)
    angle = WAVE[7, 0, 0]
    rod = scene.rods[0].get_xydata()
    assert np.allclose(rod, [[0.0, 0.0], [np.sin(angle), -np.cos(angle)]]), rod


def test_atoms_in_their_box(tmp: Path) -> None:
    positions = np.array([[[0.5, 1.0, 3.0], [5.0, -1.0, 1.0], [1.0, 1.0, 2.0]]] * 3)
    scene = BoxScene(write_fluid(tmp / "run", positions, edge=4.0), 2)
    assert len(scene.rows) == 2
    scene.draw(1)
    inside = scene.view.atoms.seen @ spheres.view()  # the rotation undone
    assert np.allclose(inside[1], [[0.5, 1.0, 3.0], [1.0, 3.0, 1.0], [1.0, 1.0, 2.0]]), inside[1]
    assert np.allclose(scene.view.atoms.speeds[0], 2.0 * np.linalg.norm(positions[0], axis=1))  # v = 2 r there
    assert "t = 1" in scene.axes.get_title("center"), scene.axes.get_title("center")
    assert scene.view.atoms.diameter == 1.0
    directory = write_fluid(tmp / "si", 0.34 * positions, edge=1.36, unit="nm")
    edit(directory / "run.json", "null", json.dumps({"sigma_nm": 0.34}))
    assert BoxScene(directory, 2).view.atoms.diameter == 0.34
    (directory / "trajectory.h5md").unlink()
    refused(lambda: BoxScene(directory, 2), "no trajectory")


if __name__ == "__main__":
    sys.exit(fixtures.run_tests(globals()))
