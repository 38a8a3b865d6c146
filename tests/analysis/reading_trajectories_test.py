#!/usr/bin/env python3
"""Tests of ljmd.reading.trajectories on files made here. Prints "N passed, M failed"."""

from __future__ import annotations

import sys
from pathlib import Path
from typing import Any

import fixtures  # noqa: I001  (it says where the modules of analysis/ are)
import numpy as np
from ljmd.reading import trajectories
from fixtures import refused

FRAMES = 7
POSITIONS = np.random.default_rng(1).normal(size=(FRAMES, 3, 3))


def write_h5md(path: Path, box: bool = True) -> Path:
    fixtures.write_h5md(path, POSITIONS, [4.0, 5.0, 6.0] if box else None, "sigma" if box else "unit of the deck")
    return path


def write_xyz(path: Path, box: bool = True) -> Path:
    text = ""
    for frame, positions in enumerate(POSITIONS):
        lattice = 'Lattice="4 0 0 0 5 0 0 0 6" ' if box else ""
        when = f"Time={0.5 * frame} step={10 * frame}"
        text += f'3\n{lattice}Properties=species:S:1:pos:R:3:velo:R:3:id:I:1 pbc="T T T" {when} units=reduced\n'
        for number, r in enumerate(positions.tolist(), 1):
            text += " ".join(["X", *(repr(x) for x in r), *(repr(2.0 * x) for x in r), str(number)]) + "\n"
    path.write_text(text)
    return path


def check_frames(found: trajectories.Trajectory, rows: Any = slice(None)) -> None:
    assert np.array_equal(found.step, 10 * np.arange(FRAMES)[rows]), found.step
    assert np.array_equal(found.time, 0.5 * np.arange(FRAMES)[rows]), found.time
    assert np.array_equal(found.positions, POSITIONS[rows])
    assert np.array_equal(found.velocities, 2.0 * POSITIONS[rows])


def test_h5md_and_xyz(tmp: Path) -> None:
    for name, write in (("trajectory.h5md", write_h5md), ("trajectory.xyz", write_xyz)):
        write(tmp / name)
        found = trajectories.read(tmp)
        check_frames(found)
        assert found.length_unit == "sigma" and np.array_equal(found.edges, [[4.0, 5.0, 6.0]] * FRAMES), found.edges
        check_frames(trajectories.read(tmp, most=3), [0, 3, 6])
        check_frames(trajectories.read(tmp, most=1), [6])
        write(tmp / name, box=False)
        found = trajectories.read(tmp)
        assert found.edges is None and found.length_unit == ""
        (tmp / name).unlink()
    assert trajectories.read(tmp) is None


def test_csv(tmp: Path) -> None:
    header = "step,time,x1,y1,vx1,vy1,ax1,ay1,x2,y2,vx2,vy2,ax2,ay2"
    (tmp / "trajectory.csv").write_text(f"{header}\n0,0,1,2,3,4,5,6,7,8,9,10,11,12\n3,-1" + 12 * ",0" + "\n")
    found = trajectories.read(tmp)
    assert np.array_equal(found.positions[0], [[1, 2], [7, 8]]), found.positions
    assert np.array_equal(found.velocities[0], [[3, 4], [9, 10]])
    assert np.array_equal(found.accelerations[0], [[5, 6], [11, 12]])
    assert np.array_equal(found.time, [0, -1]) and found.angle is None
    (tmp / "trajectory.csv").write_text("step,time,x1,vx1,angle\n0,0,1,2,3\n")
    found = trajectories.read(tmp)
    assert found.positions.shape == (1, 1, 1) and found.angle[0] == 3 and found.accelerations is None


def test_damaged_files(tmp: Path) -> None:
    (tmp / "trajectory.csv").write_text("step,time,x1,y1,vx1,vy1,x2,vx2,vy2\n" + "0," * 8 + "0\n")
    refused(lambda: trajectories.read(tmp), "trajectory.csv: line 1: no column 'y2'")
    (tmp / "trajectory.csv").unlink()
    whole = write_xyz(tmp / "trajectory.xyz").read_text()
    damages = {
        "": "no frames",
        whole[:-100]: "cut off",
        whole.replace("step=", "row="): "without step=",
        whole.replace("3\n", "three\n", 1): "three",
        whole.replace("pos:R", "place:R"): "no Properties",
    }
    for text, message in damages.items():
        (tmp / "trajectory.xyz").write_text(text)
        refused(lambda: trajectories.read(tmp), "trajectory.xyz", message)
    (tmp / "trajectory.h5md").write_text("no HDF5")
    refused(lambda: trajectories.read(tmp), "trajectory.h5md", "not a trajectory")


if __name__ == "__main__":
    sys.exit(fixtures.run_tests(globals()))
