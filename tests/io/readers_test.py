"""Do the tools of our users read our files? MDAnalysis, ASE and h5py open what write_sample_trajectories wrote.

usage: readers_test.py PROGRAM FOLDER     runs PROGRAM FOLDER, then reads what it wrote there
"""

import math
import pathlib
import re
import subprocess
import sys
import traceback
import warnings

import h5py
import numpy as np

warnings.filterwarnings("ignore")  # other people's deprecations
import ase.io  # noqa: E402
import ase.units  # noqa: E402
import MDAnalysis  # noqa: E402

ATOMS, FRAMES = 5, 4
BOLTZMANN, DALTON = 1.380649e-23, 1.66053906660e-27  # CODATA 2018
SIGMA, EPSILON, MASS = 3.405e-10, 119.8 * BOLTZMANN, 39.948 * DALTON
NANOMETRE = SIGMA / 1e-9  # of one sigma
PICOSECOND = math.sqrt(MASS * SIGMA**2 / EPSILON) / 1e-12  # of one tau
TIMES = 0.25 * np.arange(FRAMES)
STEPS = 50 * np.arange(FRAMES)

folder = pathlib.Path(".")


# The formulas of write_sample_trajectories.cpp, (atoms, 3), in reduced units.
def positions(f):
    k = np.arange(ATOMS)
    return np.stack([0.5 + 0.75 * k + 1.25 * f, 1.0 + 0.25 * k * k - 2.0 * f, 0.125 * k - 0.5 * f * f], axis=1)


def velocities(f):
    k = np.arange(ATOMS)
    return np.stack([k - 2.0, 0.5 * f - 0.25 * k, -0.125 * k * f], axis=1)


def forces(f):
    k = np.arange(ATOMS)
    return np.stack([0.25 * k - f, 1.0 * k, 0.0 * k - 0.5 * f], axis=1)


def energies(f):
    return 0.25 * f - 0.5 * np.arange(ATOMS)


def edges(f):
    return np.array([4.0 + 0.5 * f, 5.0, 6.0 - 0.25 * f])


def close(found, expected, tolerance=1e-14):
    np.testing.assert_allclose(found, expected, rtol=tolerance, atol=tolerance)


def same(found, expected):
    np.testing.assert_array_equal(found, expected)


def some_atoms_left_the_box():
    outside = [((positions(f) < 0) | (positions(f) >= edges(f))).any() for f in range(FRAMES)]
    assert any(outside), "the samples do not cross the box: unwrapping is not tested"


# ---- h5py: the file itself


def h5py_reads_exact_numbers_in_id_order():
    with h5py.File(folder / "reduced.h5md", "r") as file:
        group = file["particles/trajectory"]
        assert group["position/value"].shape == (FRAMES, ATOMS, 3)
        assert group["position/value"].dtype == np.float64
        assert group["position/step"].dtype == np.int64 and group["position/time"].dtype == np.float64
        same(group["position/step"][:], STEPS)
        same(group["position/time"][:], TIMES)
        for f in range(FRAMES):
            same(group["position/value"][f], positions(f))
            same(group["velocity/value"][f], velocities(f))
            same(group["box/edges/value"][f], np.diag(edges(f)))
        same(group["id"][:], 1 + np.arange(ATOMS))
        same(group["species"][:], np.zeros(ATOMS))
        same(group["mass"][:], np.ones(ATOMS))
        assert "image" not in group and "observables" not in file


def h5py_finds_the_metadata_of_the_standard():
    with h5py.File(folder / "si.h5md", "r") as file:
        same(file["h5md"].attrs["version"], [1, 1])
        assert file["h5md/author"].attrs["name"].decode() == "Loup Verlet"
        assert file["h5md/creator"].attrs["name"].decode() == "ljmd"
        assert file["h5md/creator"].attrs["version"].decode() == "1.2.3"
        box = file["particles/trajectory/box"]
        assert box.attrs["dimension"] == 3 and np.issubdtype(box.attrs["dimension"].dtype, np.integer)
        assert list(box.attrs["boundary"]) == [b"periodic"] * 3  # bytes: of fixed length
        assert file["parameters"].attrs["title"] == "known formulas"


def h5py_finds_step_and_time_shared_by_hard_links():
    with h5py.File(folder / "si.h5md", "r") as file:
        group = file["particles/trajectory"]
        for name in ("step", "time"):
            for other in ("box/edges", "velocity"):
                assert group[f"{other}/{name}"] == group[f"position/{name}"], (other, name)
                assert isinstance(group[other].get(name, getlink=True), h5py.HardLink)


def h5py_finds_units_in_si_files_only():
    found = {}

    def collect(units):
        def visit(name, item):
            if "unit" in item.attrs:
                units[name] = item.attrs["unit"]

        return visit

    for name in ("si", "reduced", "unbounded"):
        with h5py.File(folder / f"{name}.h5md", "r") as file:
            found[name] = {}
            file.visititems(collect(found[name]))
            found[name + " stated"] = dict(file["parameters/units"].attrs)
    assert set(found["si"].values()) == {"nm", "ps", "nm ps-1"}, found["si"]
    with h5py.File(folder / "si.h5md", "r") as file:
        group = file["particles/trajectory"]
        assert group["position/value"].attrs["unit"] == "nm"  # a str, not bytes: of variable length
        assert group["position/time"].attrs["unit"] == "ps"
        assert group["velocity/value"].attrs["unit"] == "nm ps-1"
        assert group["box/edges/value"].attrs["unit"] == "nm"
    assert found["reduced"] == {} and found["unbounded"] == {}
    assert found["reduced stated"] == {"length": "sigma", "time": "tau", "velocity": "sigma/tau"}


def h5py_finds_what_vmd_needs_for_colours():
    for name, species, number, mass, radius in (
        ("si", b"Ar", 18, MASS / DALTON, 0.5 * NANOMETRE),
        ("reduced", b"X", 0, 1.0, 0.5),
    ):
        with h5py.File(folder / f"{name}.h5md", "r") as file:
            vmd = file["parameters/vmd_structure"]
            # VMD counts the species in use and wants exactly that many entries.
            same(vmd["indexOfSpecies"][:], np.unique(file["particles/trajectory/species"][:]))
            assert list(vmd["name"][:]) == [species] and list(vmd["type"][:]) == [species]
            assert list(vmd["atomicnumber"][:]) == [number]
            close(vmd["mass"][:], [mass])
            close(vmd["radius"][:], [radius])


def h5py_reads_an_unbounded_system():
    with h5py.File(folder / "unbounded.h5md", "r") as file:
        group = file["particles/trajectory"]
        assert list(group["box"].attrs["boundary"]) == [b"none"] * 3 and "edges" not in group["box"]
        for f in range(FRAMES):
            same(group["position/value"][f], positions(f))


def h5py_reads_forces_and_energies_of_the_atoms():
    kilojoule = EPSILON * 6.02214076e23 / 1e3  # of one epsilon, per mole
    for name, length, energy, tolerance in (("forces", 1.0, 1.0, 0.0), ("forces-si", NANOMETRE, kilojoule, 1e-14)):
        with h5py.File(folder / f"{name}.h5md", "r") as file:
            group = file["particles/trajectory"]
            for f in range(FRAMES):
                close(group["force/value"][f], energy / length * forces(f), tolerance)
                close(group["potential_energy/value"][f], energy * energies(f), tolerance)
            for element in ("force", "potential_energy"):
                for shared in ("step", "time"):
                    assert group[f"{element}/{shared}"] == group[f"position/{shared}"], (element, shared)
            units = [group[element].attrs.get("unit") for element in ("force/value", "potential_energy/value")]
            assert units == (["kJ mol-1 nm-1", "kJ mol-1"] if name == "forces-si" else [None, None]), units
            stated = dict(file["parameters/units"].attrs)
            assert (stated["force"], stated["energy"]) == (("kJ mol-1 nm-1", "kJ mol-1") if name == "forces-si"
                                                           else ("epsilon/sigma", "epsilon"))


def h5py_follows_a_file_that_is_still_written():
    with h5py.File(folder / "reduced.h5md", "r", swmr=True) as file:
        assert file["particles/trajectory/position/value"].shape[0] == FRAMES


# ---- MDAnalysis: angstrom, ps; single precision


def universe(name, **options):
    topology = MDAnalysis.Universe.empty(ATOMS, trajectory=False)
    return topology.load_new(str(folder / name), **options)


def mdanalysis_reads_si_h5md():
    system = universe("si.h5md")
    assert system.trajectory.n_frames == FRAMES and system.atoms.n_atoms == ATOMS
    assert system.trajectory.units == {"length": "nm", "time": "ps", "velocity": "nm/ps", "force": None}
    for f, frame in enumerate(system.trajectory):
        close(frame.positions, 10 * NANOMETRE * positions(f), 1e-6)
        close(frame.velocities, 10 * NANOMETRE / PICOSECOND * velocities(f), 1e-6)
        close(frame.dimensions, [*(10 * NANOMETRE * edges(f)), 90, 90, 90], 1e-6)
        close(frame.time, PICOSECOND * TIMES[f])
        assert frame.data["step"] == STEPS[f] and frame.frame == f


def mdanalysis_reads_reduced_h5md_without_units():
    for name in ("reduced.h5md", "unbounded.h5md"):
        system = universe(name, convert_units=False)
        for f, frame in enumerate(system.trajectory):
            close(frame.positions, positions(f), 1e-6)
            close(frame.velocities, velocities(f), 1e-6)
            close(frame.time, TIMES[f])
            if name == "reduced.h5md":
                close(frame.dimensions, [*edges(f), 90, 90, 90], 1e-6)
            else:
                assert frame.dimensions is None


def mdanalysis_reads_h5md_without_velocities_and_at_random():
    system = universe("positions.h5md")
    assert not system.trajectory.ts.has_velocities
    for f in (2, 0, 3, 1):
        close(system.trajectory[f].positions, 10 * NANOMETRE * positions(f), 1e-6)


def mdanalysis_reads_forces():
    """In kJ/(mol angstrom), its unit; of a reduced file as they stand."""
    kilojoule = EPSILON * 6.02214076e23 / 1e3
    for name, unit, options in (("forces-si.h5md", kilojoule / (10 * NANOMETRE), {}), ("forces.h5md", 1.0, {"convert_units": False})):
        for f, frame in enumerate(universe(name, **options).trajectory):
            close(frame.forces, unit * forces(f), 1e-6)


def mdanalysis_gets_the_displacements_right():
    """Its MSD believes the positions: they must be unwrapped."""
    from MDAnalysis.analysis.msd import EinsteinMSD

    msd = EinsteinMSD(universe("si.h5md"), select="all", fft=False).run().results.timeseries
    for lag in range(FRAMES):
        moves = [positions(f + lag) - positions(f) for f in range(FRAMES - lag)]
        expected = np.mean([(move**2).sum(axis=1).mean() for move in moves])
        close(msd[lag], (10 * NANOMETRE) ** 2 * expected, 1e-5)


def mdanalysis_reads_xyz():
    for name, scale, species in (("si.xyz", 10 * NANOMETRE, "Ar"), ("reduced.xyz", 1.0, "X"), ("final.xyz", 1.0, "X")):
        system = MDAnalysis.Universe(str(folder / name))
        assert list(system.atoms.names) == [species] * ATOMS
        first = FRAMES - 1 if name == "final.xyz" else 0
        assert system.trajectory.n_frames == FRAMES - first
        for f, frame in enumerate(system.trajectory):
            close(frame.positions, scale * positions(first + f), 1e-6)


def from_the_documentation(first_words, name, sample):
    """The universe that a block of Python in docs/files.md makes of a sample, under the name that stands there."""
    text = (pathlib.Path(__file__).resolve().parents[2] / "docs/files.md").read_text(encoding="utf-8")
    blocks = [block for block in re.findall(r"^```python\n(.*?)^```$", text, re.M | re.S) if block.startswith(first_words)]
    assert len(blocks) == 1, f"docs/files.md has {len(blocks)} blocks that begin with {first_words!r}"
    names = {}
    exec(blocks[0].replace(f'"{name}"', repr(str(folder / sample))), names)
    return names["universe"]


def mdanalysis_opens_reduced_files_by_the_lines_of_the_documentation():
    h5md = from_the_documentation("import h5py\n", "trajectory.h5md", "reduced.h5md")
    xyz = from_the_documentation("import MDAnalysis\n", "trajectory.xyz", "reduced.xyz")
    for system in (h5md, xyz):
        assert system.trajectory.n_frames == FRAMES
        for f in (*range(FRAMES), 1):  # also back
            frame = system.trajectory[f]
            close(frame.positions, positions(f), 1e-6)
            close(frame.dimensions, [*edges(f), 90, 90, 90], 1e-6)
            close(frame.time, TIMES[f])
    close(h5md.trajectory[2].velocities, velocities(2), 1e-6)


# ---- ASE: extended XYZ with all its keys; double precision


def ase_reads_every_frame():
    cases = (("si", 10 * NANOMETRE, PICOSECOND, 1e-14), ("reduced", 1.0, 1.0, 0.0))
    for units, length, time, tolerance in cases:
        read = ase.io.read(folder / f"{units}.xyz", index=":")
        assert len(read) == FRAMES
        for f, atoms in enumerate(read):
            assert atoms.get_chemical_symbols() == ["Ar" if units == "si" else "X"] * ATOMS
            close(atoms.positions, length * positions(f), tolerance)
            close(atoms.arrays["velo"], length / time * velocities(f), tolerance)
            # In a reduced file sigma/tau; else in ASE's unit, from which ASE's fs leads to angstrom/ps.
            unit = 1000 * ase.units.fs if units == "si" else 1.0
            close(atoms.get_velocities() * unit, length / time * velocities(f), 1e-8 if units == "si" else 0.0)
            same(atoms.arrays["id"], 1 + np.arange(ATOMS))
            close(atoms.cell.array, length * np.diag(edges(f)), tolerance)
            assert atoms.pbc.all()
            close(atoms.info["Time"], time * TIMES[f], tolerance)
            assert atoms.info["step"] == STEPS[f] and atoms.info["units"] == units


def ase_reads_files_without_velocities_and_without_a_box():
    atoms = ase.io.read(folder / "positions.xyz", index=1)
    assert "velo" not in atoms.arrays and not atoms.has("momenta")
    close(atoms.positions, 10 * NANOMETRE * positions(1))
    atoms = ase.io.read(folder / "unbounded.xyz", index=1)
    assert not atoms.pbc.any() and atoms.cell.rank == 0
    same(atoms.positions, positions(1))


def ase_takes_forces_and_energies_as_results_of_a_calculator():
    """In its units, eV and angstrom, from a file in SI units; of a reduced file as they stand."""
    volt = EPSILON / 1.602176634e-19  # of one epsilon
    for name, length, energy, tolerance in (("forces", 1.0, 1.0, 0.0), ("forces-si", 10 * NANOMETRE, volt, 1e-14)):
        for f, atoms in enumerate(ase.io.read(folder / f"{name}.xyz", index=":")):
            close(atoms.get_forces(), energy / length * forces(f), tolerance)
            close(atoms.get_potential_energies(), energy * energies(f), tolerance)
            close(atoms.positions, length * positions(f), tolerance)
            same(atoms.arrays["id"], 1 + np.arange(ATOMS))


def a_dump_is_read_by_mdanalysis_and_ase():
    """MDAnalysis has positions in single precision and box, ASE also forces."""
    system = universe("forces.lammpsdump", format="LAMMPSDUMP", lammps_coordinate_convention="unscaled")
    read = ase.io.read(folder / "forces.lammpsdump", index=":", format="lammps-dump-text")
    assert len(read) == system.trajectory.n_frames == FRAMES
    for f, (frame, atoms) in enumerate(zip(system.trajectory, read)):
        inside = positions(f) - np.floor(positions(f) / edges(f)) * edges(f)
        close(frame.positions, inside, 1e-6)
        close(frame.dimensions, [*edges(f), 90, 90, 90], 1e-6)
        close(atoms.positions % edges(f), inside)
        close(atoms.get_forces(), forces(f))
        close(atoms.cell.array, np.diag(edges(f)))


def ase_reads_the_final_configuration_exactly():
    atoms = ase.io.read(folder / "final.xyz")
    same(atoms.positions, positions(FRAMES - 1))
    same(atoms.arrays["velo"], velocities(FRAMES - 1))
    same(atoms.get_velocities(), velocities(FRAMES - 1))
    same(atoms.cell.array, np.diag(edges(FRAMES - 1)))
    assert atoms.info["units"] == "reduced" and atoms.info["step"] == STEPS[-1]


TESTS = [
    some_atoms_left_the_box,
    h5py_reads_exact_numbers_in_id_order,
    h5py_finds_the_metadata_of_the_standard,
    h5py_finds_step_and_time_shared_by_hard_links,
    h5py_finds_units_in_si_files_only,
    h5py_finds_what_vmd_needs_for_colours,
    h5py_reads_an_unbounded_system,
    h5py_reads_forces_and_energies_of_the_atoms,
    h5py_follows_a_file_that_is_still_written,
    mdanalysis_reads_si_h5md,
    mdanalysis_reads_reduced_h5md_without_units,
    mdanalysis_reads_h5md_without_velocities_and_at_random,
    mdanalysis_reads_forces,
    mdanalysis_gets_the_displacements_right,
    mdanalysis_reads_xyz,
    mdanalysis_opens_reduced_files_by_the_lines_of_the_documentation,
    ase_reads_every_frame,
    ase_reads_files_without_velocities_and_without_a_box,
    ase_takes_forces_and_energies_as_results_of_a_calculator,
    a_dump_is_read_by_mdanalysis_and_ase,
    ase_reads_the_final_configuration_exactly,
]


def main():
    global folder
    program, folder = sys.argv[1], pathlib.Path(sys.argv[2])
    subprocess.run([program, str(folder)], check=True)
    failed = 0
    for test in TESTS:
        try:
            test()
        except Exception:
            failed += 1
            print(f"FAILED {test.__name__}")
            traceback.print_exc(file=sys.stdout)
    print(f"{len(TESTS) - failed} passed, {failed} failed")
    return 1 if failed else 0


if __name__ == "__main__":
    sys.exit(main())
