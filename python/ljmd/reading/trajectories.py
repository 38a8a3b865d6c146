"""The trajectory of a run in the units of its file: trajectory.csv of few bodies, trajectory.h5md and trajectory.xyz of any
system.

The analyses of fluids, `ljmd.Trajectory`, take a periodic box and reduced units, and read by the compiled part. Few bodies
have no box.
"""

from __future__ import annotations

import itertools
import re
from dataclasses import dataclass
from pathlib import Path
from typing import Iterator, Optional

import numpy as np

from .files import damaged, is_there, require_file
from .tables import Table, read_table

H5MD_GROUP = "particles/trajectory"
LATTICE = re.compile(r'\bLattice="([^"]*)"')
PROPERTIES = re.compile(r"\bProperties=(\S+)")


@dataclass(frozen=True)
class Trajectory:
    """Frames of one run: F frames of N bodies in d dimensions. Positions are unwrapped, as ljmd writes them."""

    step: np.ndarray  # (F,)
    time: np.ndarray  # (F,)
    positions: np.ndarray  # (F, N, d)
    velocities: Optional[np.ndarray] = None  # (F, N, d)
    accelerations: Optional[np.ndarray] = None  # (F, N, d)
    angle: Optional[np.ndarray] = None  # (F,), the polar angle that goes with a distance
    edges: Optional[np.ndarray] = None  # (F, 3), of the periodic box
    length_unit: str = ""  # sigma, nm or angstrom; empty where the deck chose the unit


def read(directory: Path, most: Optional[int] = None, growing: bool = False) -> Optional[Trajectory]:
    """The trajectory of a run, None without one; `most` takes only so many frames, evenly spread. Of a `growing` text
    file, which was being written, a last frame that is cut off does not count.

    Raises DataError when the file is damaged.
    """
    if is_there(directory / "trajectory.csv"):
        return read_csv(directory / "trajectory.csv", most, growing)
    if is_there(directory / "trajectory.h5md"):
        return read_h5md(directory / "trajectory.h5md", most)
    if is_there(directory / "trajectory.xyz"):
        return read_xyz(directory / "trajectory.xyz", most, growing)
    return None


def spread(count: int, most: Optional[int]) -> np.ndarray:
    """At most `most` of the indices 0 ... count - 1, evenly spread, with the first and the last."""
    if most is None or count <= most:
        return np.arange(count)
    return np.linspace(0, count - 1, most).round().astype(int) if most > 1 else np.array([count - 1])


def read_csv(path: Path, most: Optional[int] = None, growing: bool = False) -> Trajectory:
    """Columns step, time, then x1, y1, ..., vx1, ..., ax1, ..., x2, ...; angle where there is one."""
    table = read_table(path, ("step", "time", "x1"), increasing=("step",), growing=growing)
    table = {name: column[spread(column.size, most)] for name, column in table.items()}
    bodies = 1
    while f"x{bodies + 1}" in table:
        bodies += 1
    axes = [axis for axis in "xyz" if f"{axis}1" in table]
    return Trajectory(
        step=table["step"],
        time=table["time"],
        positions=columns_of(path, table, [f"{axis}{{}}" for axis in axes], bodies),
        velocities=columns_of(path, table, [f"v{axis}{{}}" for axis in axes], bodies) if "vx1" in table else None,
        accelerations=columns_of(path, table, [f"a{axis}{{}}" for axis in axes], bodies) if "ax1" in table else None,
        angle=table.get("angle"),
    )


def columns_of(path: Path, table: Table, names: list[str], bodies: int) -> np.ndarray:
    """The columns `names`, with the number of the body for {}, as an array (frame, body, axis)."""
    wanted = [[name.format(body) for name in names] for body in range(1, bodies + 1)]
    missing = [name for row in wanted for name in row if name not in table]
    if missing:
        raise damaged(path, f"line 1: no column '{missing[0]}'")
    return np.array([[table[name] for name in row] for row in wanted]).transpose(2, 0, 1)


def read_h5md(path: Path, most: Optional[int] = None) -> Trajectory:
    """H5MD as ljmd writes it: one particle group, with the box as edges of a cuboid."""
    try:
        import h5py  # type: ignore  # here, so that runs without such a file need no h5py
    except ImportError:
        raise damaged(path, "is HDF5, which takes h5py: this Python does not have it") from None
    require_file(path)
    try:
        with h5py.File(path) as file:
            group = file[H5MD_GROUP]
            frames = spread(len(group["position/step"]), most)
            if not frames.size:
                raise ValueError("no frames")
            has_box = "edges" in group["box"]
            positions = group["position/value"][frames]
            if positions.ndim != 3:
                raise ValueError("positions are no array of vectors in each frame")
            return Trajectory(
                step=group["position/step"][frames],
                time=group["position/time"][frames],
                positions=positions,
                velocities=group["velocity/value"][frames] if "velocity" in group else None,
                edges=np.diagonal(group["box/edges/value"][frames], axis1=1, axis2=2) if has_box else None,
                length_unit=length_unit(file["parameters/units"].attrs["length"], has_box),
            )
    except Exception as error:  # of whatever kind: where a data set was expected, h5py may find anything
        raise damaged(path, f"not a trajectory of ljmd: {error}") from None


def length_unit(found: str, has_box: bool) -> str:
    """The unit that a file names; a file of few bodies says that its deck chose it."""
    return found if found in ("sigma", "nm", "angstrom") and has_box else ""


def read_xyz(path: Path, most: Optional[int] = None, growing: bool = False) -> Trajectory:
    """Extended XYZ as ljmd writes it."""
    try:
        count = sum(1 for _ in xyz_frames(path, growing))
        chosen = set(spread(count, most).tolist())
        frames = [parse_frame(*frame) for number, frame in enumerate(xyz_frames(path, growing)) if number in chosen]
        if not frames:
            raise ValueError("no frames")
        comments, values = [frame[0] for frame in frames], np.array([frame[1] for frame in frames])
        columns = property_columns(comments[0])
        lattices = [LATTICE.search(comment) for comment in comments]
        edges = [[float(text) for text in match[1].split()[::4]] for match in lattices if match]
        position, velocity = columns["pos"], columns.get("velo")
        return Trajectory(
            step=np.array([comment_number(comment, "step") for comment in comments]),
            time=np.array([comment_number(comment, "Time") for comment in comments]),
            positions=values[:, :, position : position + 3],
            velocities=None if velocity is None else values[:, :, velocity : velocity + 3],
            edges=np.array(edges) if len(edges) == len(frames) else None,
            length_unit=length_unit("angstrom" if "units=si" in comments[0] else "sigma", bool(edges)),
        )
    except (OSError, ValueError) as error:
        raise damaged(path, f"not a trajectory of ljmd: {error}") from None


def xyz_frames(path: Path, growing: bool) -> Iterator[tuple[str, list[str]]]:
    """The comment and the lines of atoms of each frame; of a growing file without the last one, where it is cut off."""
    require_file(path)
    with path.open(encoding="utf-8") as file:
        for first in file:
            if growing and not first.endswith("\n"):
                return
            comment = file.readline()
            atoms = int(first)
            if not 0 < atoms < 2**63:
                raise ValueError("a frame does not begin with a number of atoms")
            lines = list(itertools.islice(file, atoms))
            if len(lines) < atoms or not lines[-1].endswith("\n"):
                if growing:
                    return
                raise ValueError("the last frame is cut off")
            yield comment, lines


def parse_frame(comment: str, lines: list[str]) -> tuple[str, list[list[float]]]:
    """The numbers of a frame: all columns but the species."""
    return comment, [[float(text) for text in line.split()[1:]] for line in lines]


def property_columns(comment: str) -> dict[str, int]:
    """Where each property starts, counted behind the species."""
    match = PROPERTIES.search(comment)
    parts = match[1].split(":") if match else []
    columns, start = {}, -1
    for name, width in zip(parts[::3], parts[2::3]):
        columns[name] = start
        start += int(width)
    if columns.get("species") != -1 or "pos" not in columns:
        raise ValueError("no Properties=species:S:1:pos:R:3... in line 2")
    return columns


def comment_number(comment: str, key: str) -> float:
    match = re.search(rf"\b{key}=(\S+)", comment)
    if not match:
        raise ValueError(f"a frame without {key}=")
    return float(match[1])
