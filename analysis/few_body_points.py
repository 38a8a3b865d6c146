"""Where the bodies of a few-body run are in a plane, and in a plane of coordinate and velocity."""

from __future__ import annotations

from typing import Optional

import numpy as np
from ljmd.errors import InputError
from ljmd.reading.few_bodies import FewBodyRun


def coordinate(run: FewBodyRun) -> tuple[str, str]:
    """Symbols of the first coordinate and of its velocity."""
    symbols = {"radial-kepler": (r"$\rho$", r"$v_\rho$"), "pendulum": (r"$\theta$", r"$\omega$")}
    return symbols.get(run.force, ("$x$", "$v_x$"))


def plane_points(run: FewBodyRun) -> Optional[np.ndarray]:
    """Where the bodies are in the x-y plane (F, N, 2); None where the coordinates do not lie in a plane.

    Three dimensions are projected along z. The distance and the angle of one body become a point, and so do the angles
    of pendulums of length 1, which hang down at 0.
    """
    frames = run.trajectory
    if frames is None:
        return None
    if frames.positions.shape[2] >= 2:
        return frames.positions[:, :, :2]
    first = frames.positions[:, :, 0]
    if run.force == "radial-kepler" and frames.angle is not None and run.bodies == 1:
        angle = frames.angle[:, np.newaxis]
        return np.stack([first * np.cos(angle), first * np.sin(angle)], axis=2)
    if run.force == "pendulum":
        return np.stack([np.sin(first), -np.cos(first)], axis=2)
    return None


def phase_points(run: FewBodyRun) -> Optional[np.ndarray]:
    """First coordinate and its velocity, for each body (F, N, 2); None without velocities."""
    frames = run.trajectory
    if frames is None or frames.velocities is None:
        return None
    return np.stack([frames.positions[:, :, 0], frames.velocities[:, :, 0]], axis=2)


def body_index(run: FewBodyRun, number: int) -> int:
    """The index of body `number`, counted from 1. Raises InputError when there is no such body."""
    if not 1 <= number <= run.bodies:
        raise InputError(f"there is no body {number}: {run.path} has {run.bodies}")
    return number - 1


def relative(points: np.ndarray, body: int) -> np.ndarray:
    """Points of all bodies (F, N, ...) as seen from one of them."""
    return points - points[:, body : body + 1]
