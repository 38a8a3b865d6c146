"""What is read from the files of a run are the numbers that the engine holds in memory, bit for bit."""

import os
import pathlib
import unittest

import numpy as np

from cases import Case, comet, program, small_deck
from ljmd.reading import few_bodies, fluids, sweeps, trajectories

os.environ.setdefault("LJMD_PROGRAM", program())


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
            in_memory, run = deck.run(progress=False), deck.run(self.folder / form, progress=False)
            read = fluids.load(self.folder / form)
            self.same_table(read.thermo, in_memory.thermo)
            self.assertEqual(list(read.observables), list(in_memory))
            for name, observable in read.observables.items():
                self.assertEqual((observable.unit, observable.samples), (in_memory[name].unit, in_memory[name].samples), name)
                for key in ("mean", "error", "independent_samples"):
                    np.testing.assert_array_equal(getattr(observable, key), getattr(in_memory[name], key), name)
            for name in ("r", "g", "g_standard_error"):
                np.testing.assert_array_equal(run.table("rdf")[name], in_memory.table("rdf")[name], name)
            # The engine has a reader of its own for frames, which all analyses use.
            frames, ours = run.frames(), trajectories.read(self.folder / form)
            for found, expected in ((ours.positions, frames.positions), (ours.velocities, frames.velocities),
                                    (ours.edges, frames.edges), (ours.time, frames.times), (ours.step, frames.steps)):
                np.testing.assert_array_equal(found, expected)

    def test_runs_of_few_bodies(self):
        in_memory = comet(200).run(progress=False)
        comet(200).run(self.folder / "comet", progress=False)
        read = few_bodies.load(self.folder / "comet")
        self.same_table(read.thermo, in_memory.thermo)
        frames = in_memory.trajectory()
        np.testing.assert_array_equal(read.trajectory.positions[:, 0], np.stack([frames["x1"], frames["y1"]], axis=1))
        np.testing.assert_array_equal(read.trajectory.velocities[:, 0], np.stack([frames["vx1"], frames["vy1"]], axis=1))

    def test_sweeps(self):
        sweep = small_deck().sweep({"system.density": [0.6, 0.8]}, directory=self.folder / "sweep", progress=False, jobs=2)
        read = sweeps.load(pathlib.Path(self.folder / "sweep"))
        for name in ("pressure", "temperature"):
            np.testing.assert_array_equal(read.observables[name], [point.run[name].mean for point in sweep])
            np.testing.assert_array_equal(read.observables[f"{name}_standard_error"], [point.run[name].error for point in sweep])
        # Before it has come to its end there is no table: the points say the same.
        (self.folder / "sweep" / "sweep.csv").unlink()
        unfinished = sweeps.load(pathlib.Path(self.folder / "sweep"))
        self.assertEqual(unfinished.keys, read.keys)
        for name in unfinished.observables:
            np.testing.assert_array_equal(unfinished.observables[name], read.observables[name], name)


if __name__ == "__main__":
    unittest.main()
