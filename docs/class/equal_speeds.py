"""Exercise 2: gives all atoms of the last configuration of a run the same speed, in random directions.

    tools/python docs/class/equal_speeds.py runs/maxwell equal-speeds.xyz

Positions and kinetic energy stay as they were. Atoms go in pairs, one opposite to the other, so that the momentum is zero.
"""

import pathlib
import re
import sys

import numpy as np

run, result = map(pathlib.Path, sys.argv[1:])
count, comment, *atoms = (run / "final.xyz").read_text(encoding="utf-8").splitlines()
columns = re.search(r"Properties=(\S+)", comment)[1].split(":")
start, column = {}, 0
for name, width in zip(columns[::3], columns[2::3]):
    start[name], column = column, column + int(width)
fields = [line.split() for line in atoms]
v = np.array([row[start["velo"]:start["velo"] + 3] for row in fields], float)
speed = np.sqrt((v**2).sum(axis=1).mean())
direction = np.random.default_rng(1860).normal(size=(len(v) // 2, 3))
direction /= np.linalg.norm(direction, axis=1)[:, None]
v = speed * np.concatenate([direction, -direction])
text = [" ".join(["X", *row[start["pos"]:start["pos"] + 3], *map(repr, map(float, new))]) for row, new in zip(fields, v)]
comment = re.sub(r"Properties=\S+", "Properties=species:S:1:pos:R:3:velo:R:3", comment)
result.write_text("\n".join([count, comment, *text]) + "\n", encoding="utf-8")
print(f"{result}: {count} atoms with the speed {speed:.4f} sigma/tau")
