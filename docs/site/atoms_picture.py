#!/usr/bin/env python3
"""Draws the last configuration of a run as shaded spheres, coloured by speed, on a transparent ground.

    docs/site/atoms_picture.py runs/argon-864 docs/images/liquid.png [WIDTH]

tools/docs-figures calls it for the first page of the documentation.
"""

import re
import sys

import matplotlib
import numpy as np
from PIL import Image

# From the slowest atoms to the fastest: the blues, the green and the yellow of the pictures' palette.
COLOURS = matplotlib.colors.LinearSegmentedColormap.from_list("speed", ["#0a3d62", "#0072b2", "#56b4e9", "#7fd1ae", "#f0c94a", "#e8743b"])
LIGHT = np.array([-0.45, 0.65, 0.61])
RADIUS = 0.48  # sigma: neighbours in a liquid are 1.09 apart


def read(path) -> tuple:
    """Positions in the box, about its centre, in units of its shortest edge; speeds; the radius in the same unit."""
    count, comment, *rows = open(path, encoding="utf-8").read().splitlines()
    edges = np.array(re.search(r'Lattice="([^"]*)"', comment)[1].split()[::4], float)
    columns = re.search(r"Properties=(\S+)", comment)[1].split(":")
    starts = dict(zip(columns[::3], np.cumsum([0, *map(int, columns[2::3])])))
    table = np.array([row.split()[1:] for row in rows[:int(count)]], float)
    r, v = (table[:, starts[name] - 1:starts[name] + 2] for name in ("pos", "velo"))
    return ((r / edges) % 1 - 0.5) * edges / edges.min(), np.linalg.norm(v, axis=1), RADIUS / edges.min()


def rotated(r, turn: float, tilt: float):
    c, s = np.cos(turn), np.sin(turn)
    r = r @ np.array([[c, 0, s], [0, 1, 0], [-s, 0, c]]).T
    c, s = np.cos(tilt), np.sin(tilt)
    return r @ np.array([[1, 0, 0], [0, c, -s], [0, s, c]]).T


def draw(r, colours, radius: float, size: int):
    """An RGBA picture of size x size: the nearest sphere at each point, lit from the upper left, darker where it lies deep."""
    distance = 3.2
    scale = size * 0.5
    depth = np.full((size, size), -np.inf)
    picture = np.zeros((size, size, 4))
    light = LIGHT / np.linalg.norm(LIGHT)
    for (x, y, z), colour in zip(r, colours):
        nearer = distance / (distance - z)
        R, cx, cy = radius * nearer * scale, size / 2 + x * nearer * scale, size / 2 - y * nearer * scale
        left, right, top, bottom = int(cx - R), int(cx + R) + 2, int(cy - R), int(cy + R) + 2
        if left < 0 or top < 0 or right > size or bottom > size:
            continue
        u, v = np.meshgrid((np.arange(left, right) - cx) / R, (cy - np.arange(top, bottom)) / R)
        inside = u**2 + v**2 <= 1
        w = np.sqrt(np.where(inside, 1 - u**2 - v**2, 0))
        here = z + radius * w
        window = (slice(top, bottom), slice(left, right))
        seen = inside & (here > depth[window])
        depth[window][seen] = here[seen]
        diffuse = np.clip(u * light[0] + v * light[1] + w * light[2], 0, 1)
        gloss = np.clip(2 * diffuse * w - light[2], 0, 1)**24
        shade = (0.34 + 0.66 * diffuse) * (0.62 + 0.38 * np.clip((z + 0.9) / 1.5, 0, 1))
        lit = np.clip(np.asarray(colour[:3]) * shade[..., None] + 0.45 * gloss[..., None], 0, 1)
        picture[window][seen] = np.concatenate([lit, np.ones((*lit.shape[:2], 1))], axis=-1)[seen]
    return picture


def main() -> None:
    directory, result, width = sys.argv[1], sys.argv[2], int(sys.argv[3]) if len(sys.argv) > 3 else 720
    r, speed, radius = read(f"{directory}/final.xyz")
    order = np.argsort(np.argsort(speed)) / (len(speed) - 1)
    colours = COLOURS(0.15 + 0.85 * order**1.5)
    picture = draw(rotated(r, 0.55, 0.42), colours, radius, 2 * width)
    image = Image.fromarray((255 * picture).round().astype(np.uint8), "RGBA").resize((width, width), Image.Resampling.LANCZOS)
    image = image.crop(image.getbbox())
    image.quantize(200, Image.Quantize.FASTOCTREE).save(result, optimize=True)
    print(result)


if __name__ == "__main__":
    main()
