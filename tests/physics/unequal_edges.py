"""A crystal whose edges were made unequal on purpose becomes a cube again at p = 0, under the barostat of each edge.

Usage: unequal_edges.py --ljmd PROGRAM

500 atoms start in a box that is 3 % longer along x than along y, and 2 % along z. The crystal resists the change of its shape, and the
barostat lets the three edges find the lengths at which the pressure along each is zero. A barostat that holds only the mean pressure
would keep the shape; one that confuses two edges would exchange them. Errors are from 16 blocks of the sampled rows.
"""

import argparse
import csv
import math
import pathlib
import subprocess
import sys
import tempfile

import numpy as np

sys.path.insert(0, str(pathlib.Path(__file__).resolve().parent.parent))
from figures import check, exit_code  # noqa: E402

CELLS, STRETCH = 5, (1.03, 1.0, 1.02)
EDGE = 8.15  # near that of the crystal at p = 0
RELAX, STEPS, EVERY = 6000, 50_000, 10
BLOCKS, SIGMAS = 16, 4.5

DECK = """
[system]
file = "start.xyz"
velocities = "maxwell"
temperature = 0.3
seed = 5

[potential]
type = "lennard-jones"
cutoff = 2.5
truncation = "shifted"

[[stage]]
name = "warm"
time_step = 0.005
steps = 500
thermostat = {{ type = "langevin", time = 0.2 }}

[[stage]]
name = "relax"
time_step = 0.005
steps = {relax}
thermostat = {{ type = "langevin", time = 1.0 }}
barostat = {{ type = "anisotropic-cell-rescaling", pressure = 0.0, time = 0.5, compressibility = 0.02, every = 5 }}

[[stage]]
name = "production"
time_step = 0.005
steps = {steps}
sample = true
thermostat = {{ type = "langevin", time = 1.0 }}
barostat = {{ type = "anisotropic-cell-rescaling", pressure = 0.0, time = 0.5, compressibility = 0.02, every = 5 }}

[output]
thermo = {{ every = {every} }}
"""


def write_start(path: pathlib.Path) -> None:
    edges = EDGE * np.array(STRETCH)
    basis = np.array([[0, 0, 0], [0, 1, 1], [1, 0, 1], [1, 1, 0]]) / 2.0
    corners = np.array([[x, y, z] for x in range(CELLS) for y in range(CELLS) for z in range(CELLS)])
    sites = ((corners[:, None] + basis).reshape(-1, 3)) / CELLS * edges
    lines = [str(len(sites)), 'Lattice="{} 0 0 0 {} 0 0 0 {}" Properties=species:S:1:pos:R:3'.format(*edges)]
    lines += ["Ar {} {} {}".format(*r) for r in sites]
    path.write_text("\n".join(lines) + "\n")


def mean_and_error(series: np.ndarray) -> tuple[float, float]:
    means = series[: len(series) // BLOCKS * BLOCKS].reshape(BLOCKS, -1).mean(axis=1)
    return float(means.mean()), float(means.std(ddof=1)) / math.sqrt(BLOCKS)


def main() -> int:
    parser = argparse.ArgumentParser()
    parser.add_argument("--ljmd", required=True)
    arguments = parser.parse_args()
    ljmd = str(pathlib.Path(arguments.ljmd).resolve())
    with tempfile.TemporaryDirectory() as name:
        folder = pathlib.Path(name)
        write_start(folder / "start.xyz")
        (folder / "deck.toml").write_text(DECK.format(relax=RELAX, steps=STEPS, every=EVERY))
        subprocess.run([ljmd, "run", "deck.toml", "--out", "run", "--quiet"], cwd=folder, check=True, capture_output=True)
        with open(folder / "run/thermo.csv", newline="") as file:
            rows = list(csv.DictReader(file))
        report = subprocess.run([ljmd, "analyze", "run"], cwd=folder, check=True, capture_output=True, text=True).stdout
        page = subprocess.run([ljmd, "report", "run", "--json"], cwd=folder, check=True, capture_output=True, text=True).stdout
    columns = {key: np.array([float(row[key]) for row in rows]) for key in ("step", "density", "edge_x", "edge_y", "edge_z",
                                                                            "pressure_xx", "pressure_yy", "pressure_zz")}
    start = [columns[f"edge_{a}"][0] for a in "xyz"]
    for a, edge, stretch in zip("xyz", start, STRETCH):
        check(f"edge_{a} at the start", edge, EDGE * stretch, 1e-12)
    product = columns["edge_x"] * columns["edge_y"] * columns["edge_z"] * columns["density"]
    check("edges and density of each row belong together", float(np.abs(product / (4 * CELLS**3) - 1.0).max()), 0.0, 1e-12)
    sampled = columns["step"] > 500 + RELAX
    for a, b in (("x", "y"), ("y", "z"), ("z", "x")):
        difference, error = mean_and_error((columns[f"edge_{a}"] - columns[f"edge_{b}"])[sampled])
        check(f"edge_{a} - edge_{b}", difference, 0.0, SIGMAS * error)
        check("its error", error, 0.0, 0.01)  # a tenth of the smallest difference at the start is 0.008
    for a in "xyz":
        pressure, error = mean_and_error(columns[f"pressure_{a}{a}"][sampled])
        check(f"pressure_{a}{a}", pressure, 0.0, SIGMAS * error)
        check("its error", error, 0.0, 0.02)
        check(f"`ljmd analyze` and the page have edge_{a}", float(f"edge_{a}" in report and f'"edge_{a}"' in page), 1.0, 0.0)
    return exit_code()


if __name__ == "__main__":
    sys.exit(main())
