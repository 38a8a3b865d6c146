"""Orders of convergence: the slope of log(error) against log(step)."""

from __future__ import annotations

import math
from dataclasses import dataclass

import numpy as np


@dataclass(frozen=True)
class PowerLaw:
    """error = factor * step**slope; NaN where there were too few points."""

    slope: float
    factor: float

    def __call__(self, step: np.ndarray) -> np.ndarray:
        return self.factor * step**self.slope


def power_law(step: np.ndarray, error: np.ndarray) -> PowerLaw:
    """The least-squares line through the logarithms of at least two points, all positive and finite."""
    if len(step) < 2:
        return PowerLaw(math.nan, math.nan)
    slope, offset = np.polyfit(np.log(step), np.log(error), 1)
    return PowerLaw(float(slope), float(np.exp(offset)))
