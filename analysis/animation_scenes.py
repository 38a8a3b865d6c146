"""What an animation shows: a scene has a figure and draws any of its frames into it."""

from __future__ import annotations

from pathlib import Path
from typing import Optional

import atoms_picture
import few_body_points
import matplotlib.colors
import numpy as np
import style
from atoms_picture import Atoms, AtomsView
from ljmd.errors import InputError
from ljmd.reading import records, trajectories
from ljmd.reading.few_bodies import FewBodyRun
from ljmd.reading.files import damaged
from matplotlib.collections import LineCollection
from style import plt

INCHES = 6.0
PIXELS = 480  # across the atoms of a fluid
TRAIL = 0.125  # length of a trail, as a part of all frames
TRAIL_POINTS = 200


class PathScene:
    """Points that move in a plane, each with a trail that fades."""

    def __init__(self, run: FewBodyRun, most: int, relative_to: Optional[int]):
        if relative_to is not None and run.bodies == 1:
            raise InputError(f"{run.path}: has one body, nothing moves relative to it")
        points = few_body_points.plane_points(run)
        in_plane = points is not None
        points = points if in_plane else few_body_points.phase_points(run)
        if points is None:
            raise damaged(run.path, "the trajectory has no velocities: a phase portrait needs them")
        if relative_to is not None:
            points = few_body_points.relative(points, relative_to)
        self.points, self.time = points, run.trajectory.time
        self.rows = trajectories.spread(len(points), most)
        self.figure, self.axes = plt.subplots(figsize=(INCHES, INCHES), constrained_layout=True)
        seen_from = "" if relative_to is None else f" from {style.plain(run.name(relative_to))}"
        symbols = ("$x$", "$y$") if in_plane else few_body_points.coordinate(run)
        set_limits(self.axes, points, equal=in_plane)
        self.axes.set_xlabel(symbols[0] + seen_from)
        self.axes.set_ylabel(symbols[1] + seen_from)
        hung = run.bodies if run.force == "pendulum" and relative_to is None else 0
        self.rods = [self.axes.plot([], [], color=style.GREY)[0] for _ in range(hung)]
        if in_plane and run.bodies == 1:
            self.axes.plot(0.0, 0.0, "+", color=style.BLACK, markersize=9)
        self.trails, self.dots = [], []
        for body in range(run.bodies):
            self.trails.append(self.axes.add_collection(LineCollection([], linewidths=1.5)))
            self.dots += self.axes.plot([], [], "o", color=style.colour(body), markersize=6, label=run.name(body))
        if 1 < run.bodies <= 12:
            self.axes.legend(loc="upper right")
        self.title = run.title

    def draw(self, frame: int) -> None:
        """Show the bodies at one of the frames 0 ... len(rows) - 1."""
        row = self.rows[frame]
        start = max(0, row - max(1, round(TRAIL * len(self.points))))
        behind = start + trajectories.spread(row - start + 1, TRAIL_POINTS)
        for body, (trail, dot) in enumerate(zip(self.trails, self.dots)):
            path = self.points[behind, body]
            colours = np.tile(matplotlib.colors.to_rgba(style.colour(body)), (max(len(path) - 1, 0), 1))
            colours[:, 3] = np.linspace(0.0, 1.0, len(colours))
            trail.set_segments(np.stack([path[:-1], path[1:]], axis=1))
            trail.set_color(colours)
            dot.set_data([self.points[row, body, 0]], [self.points[row, body, 1]])
        for rod, (x, y) in zip(self.rods, self.points[row]):
            rod.set_data([0.0, x], [0.0, y])
        style.head(self.figure, self.title, f"t = {self.time[row]:.6g}")


class BoxScene:
    """Atoms of a fluid in their box as shaded spheres, coloured by speed where the trajectory has velocities."""

    def __init__(self, directory: Path, most: int):
        frames = trajectories.read(directory, most)
        if frames is None:
            raise damaged(directory, "no trajectory: ask the deck for one with [output] trajectory")
        record = records.read(directory)
        diameter = atoms_picture.atom_diameter(record, frames.length_unit)
        self.frames = frames
        self.view = AtomsView(Atoms.of(frames, diameter), PIXELS)
        self.figure, self.axes = self.view.figure, self.view.axes
        self.rows = np.arange(len(frames.positions))
        self.title = record.title

    def draw(self, frame: int) -> None:
        """Show the atoms of one of the frames."""
        self.view.show(frame)
        style.head(self.figure, self.title, f"t = {self.frames.time[frame]:.6g}")


def set_limits(axes: plt.Axes, points: np.ndarray, equal: bool) -> None:
    """Limits that hold all points (..., 2) with a margin, the same for every frame."""
    flat = points.reshape(-1, 2)
    low, high = np.nanmin(flat, axis=0), np.nanmax(flat, axis=0)
    span = np.maximum(high - low, 1e-12 * np.maximum(np.abs(low), np.abs(high)))
    if equal:
        span = np.full(2, span.max())
    span = np.where(span > 0.0, span, 1.0)
    middle = 0.5 * (low + high)
    axes.set_xlim(middle[0] - 0.55 * span[0], middle[0] + 0.55 * span[0])
    axes.set_ylim(middle[1] - 0.55 * span[1], middle[1] + 0.55 * span[1])
    if equal:
        axes.set_aspect("equal")
