"""Frames as arrays, and MDAnalysis universes."""

import pickle
import unittest
import warnings

import numpy as np

import ljmd
from cases import Case, comet, small_deck

warnings.simplefilter("ignore", DeprecationWarning)
try:
    import MDAnalysis
    from MDAnalysis.analysis.rdf import InterRDF
except ImportError:
    raise SystemExit("skipped: there is no MDAnalysis")


def recorded(every=10, format="h5md", **changes):
    deck = small_deck(**changes)
    deck.output.trajectory = dict(every=every, velocities=True, format=format)
    return deck


class Frames(Case):
    def test_frames_in_memory_are_those_of_a_directory(self):
        kept = recorded().run(progress=False).frames()
        for format in ("h5md", "xyz"):
            written = recorded(format=format).run(self.folder / format, progress=False).frames()
            self.assertEqual(written.positions.shape, (7, 108, 3))
            np.testing.assert_array_equal(kept.steps, np.arange(0, 61, 10))
            for name in ("positions", "velocities", "edges", "times", "steps"):
                np.testing.assert_allclose(getattr(written, name), getattr(kept, name), rtol=0, atol=1e-12, err_msg=name)
        self.assertEqual(len(kept), 7)
        self.assertIn("7 frames of 108 atoms, with velocities", repr(kept))
        np.testing.assert_array_equal(pickle.loads(pickle.dumps(kept)).positions, kept.positions)

    def test_frames_change_no_bit_and_are_kept_step_by_step(self):
        plain = small_deck().run(progress=False)
        sim = ljmd.Simulation(recorded(every=7))
        sim.advance(3)
        middle = sim.checkpoint()
        list(sim.steps(20, every=2))
        self.assertEqual(list(sim.results().frames().steps), [0, 7, 14, 21])
        sim.restore(middle)
        self.assertEqual(list(sim.results().frames().steps), [0])
        sim.advance(4)
        run = sim.run(progress=False)
        self.assertEqual(list(run.frames().steps), list(range(0, 61, 7)))
        self.assertEqual(run.stages, plain.stages)
        deck = small_deck()
        deck.output.trajectory = dict(every=30)
        self.assertIsNone(deck.run(progress=False).frames().velocities)

    def test_what_has_no_frames_says_so(self):
        self.assertRaisesText(ljmd.DataError, "output.trajectory", of=small_deck().run(progress=False).frames)
        for run in (comet(20).run(progress=False), comet(20).run(self.folder / "comet", progress=False)):
            self.assertRaisesText(ljmd.DataError, "no box", of=run.universe)
        deck = comet(20)
        del deck.output.trajectory
        self.assertRaisesText(ljmd.DataError, "no box", of=deck.run(progress=False).universe)


class Universes(Case):
    def test_without_a_trajectory_it_is_the_last_configuration(self):
        sim = ljmd.Simulation(small_deck())
        in_memory = sim.run(progress=False)
        in_directory = small_deck().run(self.folder / "run", progress=False)
        for run in (in_memory, in_directory, ljmd.open(self.folder / "run"), pickle.loads(pickle.dumps(in_memory))):
            universe = run.universe()
            self.assertEqual((len(universe.trajectory), len(universe.atoms)), (1, 108))
            np.testing.assert_allclose(universe.atoms.positions, sim.unwrapped, atol=1e-6)
            np.testing.assert_allclose(universe.atoms.velocities, sim.velocities, atol=1e-6)
            np.testing.assert_allclose(universe.dimensions[:3], sim.edges, rtol=1e-6)
            self.assertAlmostEqual(universe.trajectory.ts.time, sim.time, 12)
            self.assertEqual(universe.trajectory.ts.data["step"], 60)
        longer = ljmd.resume(self.folder / "run", steps=5, progress=False).universe()
        self.assertEqual(longer.trajectory.ts.data["step"], 65)
        middle = ljmd.Simulation(small_deck())
        middle.advance(7)
        self.assertEqual(middle.results().universe().trajectory.ts.data["step"], 7)

    def test_an_unfinished_run_without_a_trajectory_says_so(self):
        def fails(s):
            raise RuntimeError("enough")

        with self.assertRaises(RuntimeError):
            small_deck().run(self.folder / "run", observables=ljmd.observable(fails, every=50), progress=False)
        self.assertRaisesText(ljmd.DataError, "has not come to its end", of=ljmd.open(self.folder / "run").universe)

    def test_a_universe_has_box_times_velocities_masses_and_ids(self):
        run = recorded().run(progress=False)
        for universe in (run.universe(), recorded().run(self.folder / "run", progress=False).universe(),
                         ljmd.trajectory(self.folder / "run/trajectory.h5md").universe()):
            frames = run.frames()
            self.assertEqual((len(universe.trajectory), len(universe.atoms)), (7, 108))
            for k, ts in enumerate(universe.trajectory):
                self.assertAlmostEqual(ts.time, 0.04 * k, 12)
                self.assertEqual(ts.data["step"], 10 * k)
                np.testing.assert_allclose(ts.dimensions, [*frames.edges[k], 90, 90, 90], rtol=1e-6)
                np.testing.assert_allclose(universe.atoms.positions, frames.positions[k], atol=1e-6)
                np.testing.assert_allclose(universe.atoms.velocities, frames.velocities[k], atol=1e-6)
            self.assertAlmostEqual(universe.trajectory[3].time, 0.12, 12)
            self.assertAlmostEqual(universe.trajectory.dt, 0.04, 6)
            self.assertEqual(universe.atoms.total_mass(), 108)
            np.testing.assert_array_equal(universe.atoms.ids, np.arange(108))
            twin = universe.copy()
            self.assertAlmostEqual(twin.trajectory[2].time, 0.08, 12)
            self.assertEqual(len(universe.select_atoms("name X and around 1.5 (id 3)")) > 3, True)

    def test_times_need_not_be_equally_apart(self):
        deck = recorded()
        deck.stages[1].time_step = 0.002
        universe = deck.run(progress=False).universe()
        np.testing.assert_allclose([ts.time for ts in universe.trajectory], [0, 0.04, 0.08, 0.1, 0.12, 0.14, 0.16], atol=1e-12)

    def test_the_box_is_that_of_each_frame(self):
        deck = recorded(temperature=1.5)
        deck.stages = [ljmd.Stage("all", 40, temperature=1.5, thermostat="stochastic-rescaling",
                                  barostat={"type": "stochastic-cell-rescaling", "pressure": 0.1, "time": 0.2})]
        run = deck.run(progress=False)
        edges = [ts.dimensions[0] for ts in run.universe().trajectory]
        np.testing.assert_allclose(edges, run.frames().edges[:, 0], rtol=1e-6)
        self.assertGreater(np.ptp(edges), 1e-3)

    def test_the_rdf_of_mdanalysis_is_ours(self):
        deck = recorded(atoms=256)
        deck.stages = [ljmd.Stage("melt", 300, temperature=2.0, thermostat="rescale"), ljmd.Stage("production", 200, sample=True)]
        deck.output.trajectory = dict(every=20)
        deck.analysis.rdf(bins=60, every=20)
        run = deck.run(progress=False)
        universe = run.universe()
        half = run.table("rdf")["r"].iloc[-1] + 0.5 * (run.table("rdf")["r"][1] - run.table("rdf")["r"][0])
        theirs = InterRDF(universe.atoms, universe.atoms, nbins=60, range=(0.0, half), exclusion_block=(1, 1))
        first = int(np.argmax(run.frames().steps > 300))  # what the run has sampled
        theirs.run(start=first)
        ours = run.table("rdf")["g"].to_numpy()
        # MDAnalysis keeps positions in single precision: a pair may change its bin.
        np.testing.assert_allclose(theirs.results.rdf, ours, rtol=1e-6, atol=2e-3)
        self.assertGreater(ours.max(), 2)


if __name__ == "__main__":
    warnings.simplefilter("ignore", ljmd.RunWarning)
    unittest.main(warnings="ignore")
