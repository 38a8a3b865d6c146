"""analysis/ reads the files of a run itself, so that it works where the package is not built: both read the same numbers."""

import os
import pathlib
import sys
import unittest

import numpy as np

import ljmd
from cases import ROOT, Case, comet, program, small_deck

os.environ.setdefault("LJMD_PROGRAM", program())
sys.path.insert(0, str(ROOT / "analysis"))
import few_body_run  # noqa: E402
import run_directory  # noqa: E402
import sweep_pictures  # noqa: E402
import trajectory  # noqa: E402


class Readers(Case):
    def same_table(self, read, table):
        self.assertEqual(list(read), list(table.dtype.names if isinstance(table, np.ndarray) else table.columns))
        for name, values in read.items():
            np.testing.assert_array_equal(values, np.asarray(table[name], float), name)

    def test_runs_of_fluids(self):
        for form in ("h5md", "xyz"):
            deck = small_deck()
            deck.analysis.rdf(bins=50, every=10)
            deck.output.trajectory = dict(format=form, every=10, velocities=True)
            run = deck.run(self.folder / form, progress=False)
            read = run_directory.load(self.folder / form)
            self.same_table(read.thermo, run.thermo)
            self.same_table(read.rdf, run.table("rdf"))
            for name, observable in read.observables.items():
                self.assertEqual(observable.unit, run[name].unit, name)
                for one, other in ((observable.mean, run[name].mean), (observable.standard_error, run[name].error)):
                    np.testing.assert_array_equal(np.nan if one is None else one, other, name)
            frames, ours = run.frames(), trajectory.read(self.folder / form)
            for found, expected in ((ours.positions, frames.positions), (ours.velocities, frames.velocities),
                                    (ours.edges, frames.edges), (ours.time, frames.times), (ours.step, frames.steps)):
                np.testing.assert_array_equal(found, expected)

    def test_runs_of_few_bodies(self):
        run = comet(200).run(self.folder / "comet", progress=False)
        read = few_body_run.load(self.folder / "comet")
        self.same_table(read.thermo, run.thermo)
        frames = run.trajectory()
        np.testing.assert_array_equal(read.trajectory.positions[:, 0], np.stack([frames["x1"], frames["y1"]], axis=1))
        np.testing.assert_array_equal(read.trajectory.velocities[:, 0], np.stack([frames["vx1"], frames["vy1"]], axis=1))

    def test_sweeps(self):
        sweep = small_deck().sweep({"system.density": [0.6, 0.8]}, directory=self.folder / "sweep", progress=False, jobs=2)
        read = sweep_pictures.load(pathlib.Path(self.folder / "sweep"))
        for name in ("pressure", "temperature"):
            np.testing.assert_array_equal(read.observables[name], [point.run[name].mean for point in sweep])
            np.testing.assert_array_equal(read.observables[f"{name}_standard_error"], [point.run[name].error for point in sweep])
        # Before it has come to its end there is no table: the points say the same.
        (self.folder / "sweep" / "sweep.csv").unlink()
        unfinished = sweep_pictures.load(pathlib.Path(self.folder / "sweep"))
        self.assertEqual(unfinished.keys, read.keys)
        np.testing.assert_array_equal(unfinished.observables["pressure"], read.observables["pressure"])


if __name__ == "__main__":
    unittest.main()
