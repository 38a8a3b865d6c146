"""Frames as an MDAnalysis Universe. Imported only where one is asked for."""

from __future__ import annotations

import MDAnalysis  # type: ignore
import numpy as np
from MDAnalysis.coordinates.memory import MemoryReader  # type: ignore

from .errors import DataError


class FrameReader(MemoryReader):
    """Frames in memory with times and steps of their own: MDAnalysis' reader has equal times between frames."""

    def __init__(self, coordinates, times=None, steps=None, **options):
        self._times, self._steps = times, steps
        super().__init__(coordinates, **options)
        self._kwargs.update(times=times, steps=steps)  # for copies

    def _read_next_timestep(self, ts=None):
        ts = super()._read_next_timestep(ts)
        ts.time = np.nan if self._times is None else float(self._times[ts.frame])
        if self._steps is not None:
            ts.data["step"] = int(self._steps[ts.frame])
        return ts


def universe(frames):
    """See `Frames.universe`."""
    count, atoms, _ = frames.positions.shape
    if count == 0:
        raise DataError("there is no frame")
    found = MDAnalysis.Universe.empty(atoms, trajectory=False)
    for name, values in (("masses", np.ones(atoms)), ("ids", np.arange(atoms)), ("names", ["X"] * atoms),
                         ("types", ["X"] * atoms)):
        found.add_TopologyAttr(name, values)
    right_angles = np.full((count, 3), 90.0)
    spacing = np.nan if frames.times is None or count < 2 else float(frames.times[1] - frames.times[0])
    velocities = None if frames.velocities is None else frames.velocities.astype(np.float32)
    found.load_new(frames.positions.astype(np.float32), format=FrameReader, order="fac", dt=spacing, times=frames.times,
                   steps=frames.steps, velocities=velocities,
                   dimensions=np.hstack([frames.edges, right_angles]).astype(np.float32))
    return found
