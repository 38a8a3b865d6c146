#!/usr/bin/env python3
"""Tests of analysis/spheres.py. Prints "N passed, M failed"."""

from __future__ import annotations

import sys
from pathlib import Path

import fixtures  # noqa: I001  (it says where the modules of analysis/ are)
import numpy as np
import spheres

RED, BLUE = np.array([1.0, 0.0, 0.0]), np.array([0.0, 0.0, 1.0])
WINDOW = spheres.Window(-2.0, 2.0, -2.0, 2.0)


def test_a_sphere_is_shaded_where_it_is_and_clear_elsewhere(_: Path) -> None:
    image = spheres.render(np.array([[1.0, 1.0, 0.0]]), RED[np.newaxis], 0.5, WINDOW, 80)
    assert image.shape == (80, 80, 4)
    covered = image[..., 3]
    assert abs(covered.sum() / 80**2 - np.pi * 0.5**2 / 16.0) < 0.003, covered.sum()
    rows, columns = np.nonzero(covered > 0.5)
    assert abs(columns.mean() - 59.5) < 1.0 and abs(rows.mean() - 19.5) < 1.0  # to the right and up
    brightest = np.unravel_index(np.argmax(image[..., :3].sum(axis=2) * covered), covered.shape)
    assert brightest[0] < rows.mean() and brightest[1] < columns.mean(), brightest  # where the light comes from
    assert image[..., 0].max() > 0.9 and image[20, 59, 0] > 2.0 * image[20, 59, 2]


def test_near_spheres_hide_far_ones(_: Path) -> None:
    places = np.array([[0.0, 0.0, 0.0], [0.0, 0.0, 3.0]])
    for order in ([0, 1], [1, 0]):
        image = spheres.render(places[order], np.array([RED, BLUE])[order], 0.5, WINDOW, 40)
        assert image[20, 20, 2] > image[20, 20, 0], order
    # Where two spheres cut each other, each is seen on its own side.
    image = spheres.render(np.array([[-0.2, 0.0, 0.0], [0.2, 0.0, 0.0]]), np.array([RED, BLUE]), 0.5, WINDOW, 80)
    assert image[40, 34, 0] > image[40, 34, 2] and image[40, 45, 2] > image[40, 45, 0]


def test_spheres_beyond_the_edge_are_cut(_: Path) -> None:
    image = spheres.render(np.array([[2.0, 0.0, 0.0], [9.0, 0.0, 0.0]]), np.array([RED, RED]), 0.5, WINDOW, 40)
    assert 0.0 < image[..., 3].sum() < 0.6 * np.pi * 0.5**2 * 100


def test_the_box(_: Path) -> None:
    behind, before = spheres.edges_of_box(np.array([1.0, 2.0, 3.0]))
    assert behind.shape == (3, 2, 3) and before.shape == (9, 2, 3)
    lengths = np.linalg.norm(np.concatenate([behind, before])[:, 0] - np.concatenate([behind, before])[:, 1], axis=1)
    assert np.allclose(np.sort(lengths), [1.0] * 4 + [2.0] * 4 + [3.0] * 4)
    corner = behind[0][np.argmin(behind[0][:, 2])]
    assert all(np.any(np.all(np.isclose(edge, corner), axis=1)) for edge in behind)
    assert corner[2] < before[..., 2].min()
    assert np.allclose(spheres.view() @ spheres.view().T, np.eye(3)) and np.linalg.det(spheres.view()) > 0.0


if __name__ == "__main__":
    sys.exit(fixtures.run_tests(globals()))
