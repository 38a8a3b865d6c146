"""Shaded spheres, seen along an oblique direction without perspective: an image, with the edges of the box around it."""

from __future__ import annotations

from dataclasses import dataclass

import numpy as np

TURN, TILT = np.radians(28.0), np.radians(18.0)  # of the box, about its height and towards the eye
LIGHT = np.array([-0.45, 0.55, 0.70])
AMBIENT, DIFFUSE, GLOSS = 0.38, 0.66, 0.45
FADED = 0.42  # how far the colour of the farthest sphere is from its own towards white
FINE = 2  # each pixel is the mean of so many in each direction


def view() -> np.ndarray:
    """The rotation (3, 3) to right, up and towards the eye; the y axis of the box points into the picture."""
    turn = np.array([[np.cos(TURN), np.sin(TURN), 0.0], [-np.sin(TURN), np.cos(TURN), 0.0], [0.0, 0.0, 1.0]])
    upright = np.array([[1.0, 0.0, 0.0], [0.0, 0.0, 1.0], [0.0, -1.0, 0.0]])
    tilt = np.array([[1.0, 0.0, 0.0], [0.0, np.cos(TILT), -np.sin(TILT)], [0.0, np.sin(TILT), np.cos(TILT)]])
    return tilt @ upright @ turn


@dataclass(frozen=True)
class Window:
    """The part of the plane that a picture shows, with equal scales."""

    left: float
    right: float
    bottom: float
    top: float

    @classmethod
    def around(cls, points: np.ndarray, margin: float) -> "Window":
        """It holds points (N, 3) that are seen already, with a margin."""
        low, high = points[:, :2].min(axis=0) - margin, points[:, :2].max(axis=0) + margin
        return cls(low[0], high[0], low[1], high[1])

    @property
    def extent(self) -> tuple[float, float, float, float]:
        return self.left, self.right, self.bottom, self.top


def edges_of_box(edges: np.ndarray) -> tuple[np.ndarray, np.ndarray]:
    """The edges of a box with a corner at the origin, as they are seen, each (2, 3): those behind all that is in the
    box, which meet at its farthest corner, and the others."""
    corners = np.array([[x, y, z] for x in (0, 1) for y in (0, 1) for z in (0, 1)], float)
    seen = corners * edges @ view().T
    farthest = int(np.argmin(seen[:, 2]))
    pairs = [(a, b) for a in range(8) for b in range(a) if np.abs(corners[a] - corners[b]).sum() == 1.0]
    behind = np.array([seen[[a, b]] for a, b in pairs if farthest in (a, b)])
    before = np.array([seen[[a, b]] for a, b in pairs if farthest not in (a, b)])
    return behind, before


def render(seen: np.ndarray, colours: np.ndarray, radius: float, window: Window, width: int) -> np.ndarray:
    """An image (rows, width, 4) of spheres, transparent where there is none.

    seen: centres (N, 3) to right, up and towards the eye; colours: (N, 3), each 0 to 1; radius: in the same unit
    """
    scale = FINE * width / (window.right - window.left)
    rows = FINE * max(1, round((window.top - window.bottom) * width / (window.right - window.left)))
    columns = FINE * width
    image = np.zeros((rows, columns, 4), np.float32)
    depth = np.full((rows, columns), -np.inf, np.float32)
    reach = max(1, int(np.ceil(radius * scale)))
    right, down = np.meshgrid(*2 * [np.arange(-reach, reach + 1) / (radius * scale)])
    towards = np.sqrt(np.clip(1.0 - right**2 - down**2, 0.0, None)).astype(np.float32)
    inside = right**2 + down**2 <= 1.0
    light = LIGHT / np.linalg.norm(LIGHT)
    half = light + [0.0, 0.0, 1.0]
    half /= np.linalg.norm(half)
    shade = (AMBIENT + DIFFUSE * np.clip(right * light[0] - down * light[1] + towards * light[2], 0.0, None))
    gloss = GLOSS * np.clip(right * half[0] - down * half[1] + towards * half[2], 0.0, 1.0) ** 40
    shade, gloss = shade[..., np.newaxis].astype(np.float32), gloss[..., np.newaxis].astype(np.float32)
    far = seen[:, 2].max() - seen[:, 2]
    fade = (FADED * far / (far.max() or 1.0))[:, np.newaxis]
    tints = (colours * (1.0 - fade) + fade).astype(np.float32)
    x = np.round((seen[:, 0] - window.left) * scale).astype(int)
    y = np.round((window.top - seen[:, 1]) * scale).astype(int)
    for k in np.argsort(-seen[:, 2]):  # near ones first: what lies behind them is then not drawn
        top, left = y[k] - reach, x[k] - reach
        here = (slice(max(top, 0), max(min(top + 2 * reach + 1, rows), 0)),
                slice(max(left, 0), max(min(left + 2 * reach + 1, columns), 0)))
        part = (slice(here[0].start - top, here[0].stop - top), slice(here[1].start - left, here[1].stop - left))
        surface = np.float32(seen[k, 2]) + np.float32(radius) * towards[part]
        nearest = inside[part] & (surface > depth[here])
        if nearest.any():
            depth[here][nearest] = surface[nearest]
            image[here][nearest, :3] = (tints[k] * shade[part] + gloss[part])[nearest]
            image[here][nearest, 3] = 1.0
    image[..., :3] *= image[..., 3:]
    coarse = image.reshape(rows // FINE, FINE, width, FINE, 4).mean(axis=(1, 3))
    coarse[..., :3] /= np.maximum(coarse[..., 3:], 1e-6)
    return np.clip(coarse, 0.0, 1.0)
