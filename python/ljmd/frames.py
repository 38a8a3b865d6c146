"""Frames of a trajectory in memory."""

from __future__ import annotations

from dataclasses import dataclass
from typing import TYPE_CHECKING, Any

import numpy as np

if TYPE_CHECKING:
    from ._types import Array


@dataclass(frozen=True)
class Frames:
    """Frames of a trajectory as arrays, atoms by id, F frames of N atoms.

    positions: as in the file, wrapped into the box or not, shape (F, N, 3) [sigma]
    velocities: shape (F, N, 3) [sigma/tau]; None unless all frames have them
    edges: of the box, shape (F, 3) [sigma]
    times: shape (F,) [tau]; None where they are not known
    steps: shape (F,); None where they are not known
    """

    positions: Array
    velocities: Array | None
    edges: Array
    times: Array | None
    steps: Array | None

    @classmethod
    def of_one(cls, positions, velocities, edges, time: float, step: int) -> "Frames":
        """A single frame: positions and velocities of shape (N, 3), edges of shape (3,)."""
        return cls(positions[None], velocities[None], np.asarray(edges)[None], np.array([time]), np.array([step]))

    def __repr__(self) -> str:
        frames, atoms, _ = self.positions.shape
        return f"<ljmd.Frames: {frames} frames of {atoms} atoms{'' if self.velocities is None else ', with velocities'}>"

    def __len__(self) -> int:
        return len(self.positions)

    def universe(self) -> Any:
        """An MDAnalysis Universe: positions, box, times [tau] and steps, velocities where there are any; atoms with mass 1, name
        and type "X", ids from 0. Times that are not known are NaN, and so is the spacing dt of a single frame; steps that are
        not known are missing. Numbers stay in reduced units, in single precision, as MDAnalysis keeps them.

        Raises ImportError without MDAnalysis.
        """
        from ._mdanalysis import universe
        return universe(self)


class Recorder:
    """Takes frames of a simulation at its start and at each step that `every` divides."""

    def __init__(self, every: int, velocities: bool):
        self.every, self.velocities = every, velocities
        self._taken: list = []

    def steps_to_next(self, step: int) -> int:
        return self.every - step % self.every

    def take(self, core) -> None:
        step = core.step()
        if step % self.every == 0 and (not self._taken or self._taken[-1][0] < step):
            self._taken.append((step, core.time(), core.unwrapped(), core.edges(), core.velocities() if self.velocities else None))

    def go_back_to(self, step: int) -> None:
        self._taken = [each for each in self._taken if each[0] <= step]

    def frames(self) -> Frames:
        steps, times, positions, edges, velocities = zip(*self._taken)
        return Frames(np.array(positions), np.array(velocities) if self.velocities else None, np.array(edges), np.array(times),
                      np.array(steps))
