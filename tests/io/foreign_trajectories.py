"""Does `ljmd analyze` read the trajectories of other tools? H5MD by h5py in all its variety and by MDAnalysis, extended XYZ
by ASE, DCD and XTC by way of the converter in the documentation, all made from the frames of one run, give what that run has found itself.

usage: foreign_trajectories.py LJMD
"""

import csv
import math
import os
import pathlib
import re
import subprocess
import sys
import tempfile
import traceback
import warnings

import h5py
import numpy as np

warnings.filterwarnings("ignore")  # other people's deprecations
import ase  # noqa: E402
import ase.io  # noqa: E402
import ase.units  # noqa: E402
import MDAnalysis  # noqa: E402

sys.path.insert(0, str(pathlib.Path(__file__).resolve().parent.parent))

DECK = """
[argon]
sigma = "3.405 angstrom"
epsilon = "119.8 K"
mass = "39.948 u"

[system]
lattice = { type = "fcc", cells = 3 }
density = 0.8442
temperature = 1.0

[potential]
type = "lennard-jones"
cutoff = 2.5
truncation = "shifted"

[[stage]]
name = "production"
time_step = 0.004
steps = 300
sample = true

[output]
directory = "out"
trajectory = { format = "h5md", every = 5, velocities = true }

[analysis]
rdf = { every = 10, bins = 40 }
structure_factor = { every = 20, k_max = 6.0 }
msd = { every = 10, max_time = 0.2 }
vacf = { every = 5, max_time = 0.1 }
"""
TABLES = {"rdf": ["rdf", "sk_from_rdf"], "structure_factor": ["sk"], "msd": ["msd"], "vacf": ["vacf"]}
EXACT = 1e-9  # of the largest number in a column


class Run:
    """Frames of a run of ljmd, in reduced units."""

    def __init__(self):
        with h5py.File("out/trajectory.h5md") as file:
            group = file["particles/trajectory"]
            self.positions = group["position/value"][:]
            self.velocities = group["velocity/value"][:]
            self.steps = group["position/step"][:]
            self.times = group["position/time"][:]
            self.edges = np.diag(group["box/edges/value"][0])
        self.images = np.floor(self.positions / self.edges).astype(int)
        self.wrapped = self.positions - self.images * self.edges


def call(ljmd, *arguments):
    """@return what ljmd prints"""
    done = subprocess.run([ljmd, *arguments], capture_output=True, text=True, check=False)
    assert done.returncode == 0, f"ljmd {' '.join(arguments)}: {done.stderr}"
    return done.stderr + done.stdout


def table(path):
    with open(path, encoding="utf-8") as file:
        header, *rows = csv.reader(file)
    return header, np.array([[float(field or "nan") for field in row] for row in rows])


def as_the_run(ljmd, name, tolerances, *options):
    """Analyze the file; the tables must be those of the run. Its first frame, the start, was not sampled there.

    tolerances: analysis -> of the largest number in a column
    """
    said = call(ljmd, "analyze", name, *tolerances, "--deck", "deck.toml", "--from", "0.01", "--out", "of-" + name, *options)
    for analysis, tolerance in tolerances.items():
        for stem in TABLES[analysis]:
            (header, found), (expected_header, expected) = table(f"of-{name}/{stem}.csv"), table(f"out/{stem}.csv")
            assert header == expected_header and found.shape == expected.shape, f"{name}: {stem}.csv"
            assert (np.isnan(found) == np.isnan(expected)).all(), f"{name}: {stem}.csv"
            off = np.nanmax(np.abs(found - expected) / np.nanmax(np.abs(expected), axis=0), axis=0)
            print(f"{name}: {stem}.csv is off by {np.nanmax(off):.2g}")
            assert np.nanmax(off) <= tolerance, f"{name}: {stem}.csv is off by {dict(zip(header, off))}"
    return said


ALL = {"rdf": EXACT, "structure_factor": EXACT, "msd": EXACT, "vacf": EXACT}


def write_h5md(name, positions, velocities, edges, steps, times, *, image=None, rows=None, ids=False, units=()):
    """H5MD as pyh5md and others write it. steps and times are arrays or increments, edges fixed or of each frame.

    rows: of each frame, which atom stands where; ids: say so
    """
    with h5py.File(name, "w") as file:
        file.create_group("h5md").attrs["version"] = [1, 1]
        group = file.create_group("particles/atoms")

        def element(where, values, unit=None):
            at = group.create_group(where)
            at["value"], at["step"] = values, steps
            if times is not None:
                at["time"] = times
            if units:
                at["value"].attrs["unit"] = unit
                at["time"].attrs["unit"] = units[1]

        rows = np.tile(np.arange(positions.shape[1]), (len(positions), 1)) if rows is None else rows
        frames = np.arange(len(positions))[:, None]
        element("position", positions[frames, rows], units and units[0])
        element("velocity", velocities[frames, rows], units and units[2])
        if image is not None:
            element("image", image[frames, rows])
        if ids:
            element("id", rows + 1)
        group["species"] = np.zeros(positions.shape[1], dtype=h5py.enum_dtype({"Ar": 0, "Kr": 1}, basetype="u1"))
        box = group.create_group("box")
        box.attrs["dimension"] = 3
        box.attrs["boundary"] = ["periodic"] * 3
        if len(edges) == len(positions):
            element("box/edges", edges, units and units[0])
        else:
            box["edges"] = edges
            if units:
                box["edges"].attrs["unit"] = units[0]


def h5md_with_images_ids_and_increments(ljmd, run):
    """Another order of the atoms in each frame, the box as a fixed vector, steps as increments."""
    random = np.random.default_rng(5)
    rows = np.array([random.permutation(run.positions.shape[1]) for _ in run.steps])
    write_h5md("images.h5", run.wrapped, run.velocities, run.edges, run.steps[1], run.times[1], image=run.images, rows=rows,
               ids=True)
    assert "positions: unwrapped (told by the file)" in as_the_run(ljmd, "images.h5", ALL)


def h5md_with_a_matrix_in_each_frame(ljmd, run):
    """Wrapped positions without images, steps as arrays, no times: the deck tells the time step."""
    edges = np.tile(np.diag(run.edges), (len(run.steps), 1, 1))
    write_h5md("matrix.h5", run.wrapped - run.edges / 2, run.velocities, edges, run.steps, None)
    assert as_the_run(ljmd, "matrix.h5", ALL).count("nearest images") == 1


def h5md_in_other_units(ljmd, run):
    """Angstrom and femtoseconds, the box as a vector in each frame."""
    sigma, tau = 3.405, math.sqrt(39.948 * 1.66053906660e-27 / (119.8 * 1.380649e-23)) * 3.405e-10 / 1e-15
    edges = np.tile(run.edges * sigma, (len(run.steps), 1))
    write_h5md("units.h5", run.positions * sigma, run.velocities * sigma / tau, edges, run.steps, run.times * tau,
               units=("Angstrom", "fs", "Angstrom fs-1"))
    as_the_run(ljmd, "units.h5", ALL)


def h5md_by_mdanalysis(ljmd, run):
    """In single precision, angstrom and picoseconds."""
    sigma, tau = 3.405, math.sqrt(39.948 * 1.66053906660e-27 / (119.8 * 1.380649e-23)) * 3.405e-10 / 1e-12
    atoms = run.positions.shape[1]
    universe = MDAnalysis.Universe.empty(atoms, trajectory=True, velocities=True)
    universe.add_TopologyAttr("types", ["Ar"] * atoms)
    with MDAnalysis.Writer("mdanalysis.h5md", atoms, velocities=True, lengthunit="Angstrom", timeunit="ps",
                           velocityunit="Angstrom/ps") as writer:
        for frame, (r, v, time) in enumerate(zip(run.positions, run.velocities, run.times)):
            ts = universe.trajectory.ts
            ts.frame, ts.time = frame, time * tau
            ts.positions, ts.velocities = r * sigma, v * sigma / tau
            ts.dimensions = [*(run.edges * sigma), 90, 90, 90]
            ts.data["step"] = int(run.steps[frame])
            writer.write(universe.atoms)
        writer.h5md_file.close()  # which MDAnalysis 2.4 forgets
    # A distance may fall into the bin beside its own.
    as_the_run(ljmd, "mdanalysis.h5md", {"rdf": 0.05, "structure_factor": 1e-4, "msd": 1e-4, "vacf": 1e-4})


def extended_xyz_by_ase(ljmd, run):
    """Positions with eight decimals, no velocities; neither steps nor times, so that `every` counts frames."""
    symbols = "X" * run.positions.shape[1]
    frames = [ase.Atoms(symbols, positions=r, cell=run.edges, pbc=True) for r in run.positions]
    ase.io.write("ase.xyz", frames, format="extxyz")
    every = {"rdf": 2, "structure_factor": 4, "msd": 2}
    settings = [part for name, count in every.items() for part in ("--set", f"analysis.{name}.every={count}")]
    as_the_run(ljmd, "ase.xyz", {"rdf": 0.05, "structure_factor": 1e-6, "msd": 1e-6}, "--time-step", "0.02", *settings)


def extended_xyz_by_ase_with_momenta(ljmd, run):
    """Velocities that were set in ASE are those that are read: of argon in its units, and of argon in reduced ones."""
    sigma, tau = 3.405, math.sqrt(39.948 * 1.66053906660e-27 / (119.8 * 1.380649e-23)) * 3.405e-10 / 1e-12
    for name, length, velocity, info in (("ase-si.xyz", sigma, sigma / tau / (1000 * ase.units.fs), {"units": "si"}),
                                         ("ase-reduced.xyz", 1.0, 1.0, {})):
        frames = []
        for r, v in zip(run.positions, run.velocities):
            atoms = ase.Atoms(["Ar"] * len(r), positions=length * r, cell=length * run.edges, pbc=True, info=info)
            atoms.set_velocities(velocity * v)
            frames.append(atoms)
        ase.io.write(name, frames, format="extxyz")
        settings = ("--set", "analysis.msd.every=2", "--set", "analysis.vacf.every=1")
        as_the_run(ljmd, name, {"msd": 1e-6, "vacf": 1e-6}, "--time-step", "0.02", *settings)


def converted_dcd_and_xtc(ljmd, run):
    """By the script that docs/trajectories.md shows, of files by MDAnalysis: in single precision, XTC with 0.01 angstrom."""
    page = (pathlib.Path(__file__).resolve().parents[2] / "docs/trajectories.md").read_text(encoding="utf-8")
    script = re.search(r"^```python\n(# file: to_xyz.py\n.*?)^```$", page, re.M | re.S).group(1)
    pathlib.Path("to_xyz.py").write_text(script, encoding="utf-8")
    sigma, tau = 3.405, math.sqrt(39.948 * 1.66053906660e-27 / (119.8 * 1.380649e-23)) * 3.405e-10 / 1e-12
    atoms = run.positions.shape[1]
    for name, positions, same_bins, tolerance in (("a.dcd", run.positions, 0.05, 1e-4), ("a.xtc", run.wrapped, 0.2, 0.02)):
        universe = MDAnalysis.Universe.empty(atoms, trajectory=True)
        with MDAnalysis.Writer(name, atoms, dt=0.02 * tau) as writer:
            for frame, (r, time) in enumerate(zip(positions, run.times)):
                ts = universe.trajectory.ts
                ts.frame, ts.time = frame, time * tau
                ts.positions, ts.dimensions = r * sigma, [*(run.edges * sigma), 90, 90, 90]
                writer.write(universe.atoms)
        xyz = name.replace(".", "-") + ".xyz"
        done = subprocess.run([sys.executable, "to_xyz.py", name, xyz, "si"], capture_output=True, text=True, check=False)
        assert done.returncode == 0, done.stderr
        # A distance may fall into the bin beside its own.
        every = {"rdf": 2, "structure_factor": 4, "msd": 2}  # frames, because there are no steps
        settings = [part for key, count in every.items() for part in ("--set", f"analysis.{key}.every={count}")]
        settings += ["--set", "analysis.msd.max_time=0.201"]  # times in single precision: 0.2 may be more than 0.2
        as_the_run(ljmd, xyz, {"rdf": same_bins, "structure_factor": tolerance, "msd": tolerance}, *settings)
    with MDAnalysis.Writer("tilted.dcd", atoms) as writer:
        universe.trajectory.ts.dimensions = [20, 20, 20, 90, 90, 80]
        writer.write(universe.atoms)
    done = subprocess.run([sys.executable, "to_xyz.py", "tilted.dcd", "tilted.xyz", "si"], capture_output=True, text=True, check=False)
    assert done.returncode == 1 and "right angles" in done.stderr, done.stderr


def main():
    ljmd = pathlib.Path(sys.argv[1]).resolve()
    tests = (h5md_with_images_ids_and_increments, h5md_with_a_matrix_in_each_frame, h5md_in_other_units, h5md_by_mdanalysis,
             extended_xyz_by_ase, extended_xyz_by_ase_with_momenta, converted_dcd_and_xtc)
    failed = 0
    with tempfile.TemporaryDirectory(prefix="ljmd-foreign-") as folder:
        os.chdir(folder)
        pathlib.Path("deck.toml").write_text(DECK, encoding="utf-8")
        call(ljmd, "run", "deck.toml", "--quiet")
        run = Run()
        assert (run.images != 0).any(), "no atom leaves the box: unwrapping is not tested"
        for test in tests:
            try:
                test(ljmd, run)
            except Exception:  # noqa: BLE001: every test is to be tried
                failed += 1
                print(f"FAILED {test.__name__}")
                traceback.print_exc(file=sys.stdout)
        os.chdir("/")
    print(f"{len(tests) - failed} passed, {failed} failed")
    return 1 if failed else 0


if __name__ == "__main__":
    sys.exit(main())
