"""Simulations step by step: state by id, views of the memory, several at once, nothing that leaks."""

import gc
import os
import pickle
import threading
import unittest
import warnings

import numpy as np

import ljmd
from alarm import Other
from cases import Case, comet, long_deck, small_deck


class Steps(Case):
    def test_steps_give_control_after_each_part_and_the_bits_of_one_run(self):
        whole = small_deck().run(progress=False)
        sim = ljmd.Simulation(small_deck())
        self.assertEqual((sim.step, sim.time, sim.stage), (0, 0.0, "equilibrate"))
        self.assertEqual([s.step for s in sim.steps(25, every=10)], [10, 20, 25])
        self.assertEqual(sim.stage, "production")
        self.assertEqual([s.step for s in sim.steps(every=20)], [45, 60])
        self.assertTrue(sim.finished)
        self.assertEqual(list(sim.steps()), [])
        self.assertEqual(sim.results().stages, whole.stages)
        np.testing.assert_array_equal(sim.thermo["total_energy"], whole.thermo["total_energy"])

    def test_wrong_numbers_of_steps_are_refused(self):
        sim = ljmd.Simulation(small_deck())
        for wrong in (-1, 1.5, "10", None):
            self.assertRaises(ljmd.InputError, sim.advance, wrong)
        for wrong in (0, -1, 2.5):
            self.assertRaises(ljmd.InputError, sim.steps, 10, wrong)
        for wrong in (0, -2, 1.0, 5000, "two"):
            self.assertRaises(ljmd.InputError, ljmd.Simulation, small_deck(), threads=wrong)
        self.assertRaises(ljmd.InputError, ljmd.Simulation, small_deck(), simd="abacus")

    def test_energies_are_known_at_every_step(self):
        every = small_deck()
        every.output.thermo = dict(every=1)
        sampled = ljmd.Simulation(every)
        sampled.advance(7)
        sim = ljmd.Simulation(small_deck())
        sim.advance(7)
        for name in ("temperature", "potential_energy", "kinetic_energy", "total_energy", "pressure"):
            self.assertAlmostEqual(getattr(sim, name), sampled.thermo[name].iloc[-1], 10)
        self.assertAlmostEqual(sim.density, 0.8)

    def test_copies_are_in_the_order_of_ids(self):
        sim = ljmd.Simulation(long_deck(400))
        sim.advance(400)
        with sim.arrays() as a:
            ids = a.ids.copy()
            self.assertFalse(np.array_equal(ids, np.arange(864)), "the atoms have not been sorted: this tests nothing")
            np.testing.assert_array_equal(sim.velocities[ids], a.velocities)
            np.testing.assert_array_equal(sim.forces[ids], a.forces)
            shift = (sim.positions[ids] - a.positions) / sim.edges
            np.testing.assert_allclose(shift, np.round(shift), atol=1e-12)
            np.testing.assert_array_equal(a.masses, np.ones(864))
            del a
        self.assertTrue(np.all((sim.positions >= 0) & (sim.positions < sim.edges)))
        start = ljmd.Simulation(long_deck(400)).positions
        self.assertLess(np.abs(sim.unwrapped - start).max(), 2.0)
        self.assertEqual((sim.positions.shape, sim.masses.shape, sim.edges.shape), ((864, 3), (864,), (3,)))

    def test_a_kick_that_is_due_is_in_the_velocities(self):
        one, other = ljmd.Simulation(small_deck()), ljmd.Simulation(small_deck())
        one.advance(3)
        for _ in other.steps(3):
            other.velocities
        np.testing.assert_array_equal(one.velocities, other.velocities)
        with one.arrays() as a:
            np.testing.assert_array_equal(one.velocities[a.ids], a.velocities)

    def test_checkpoints(self):
        sim = ljmd.Simulation(small_deck())
        sim.advance(33)
        checkpoint = sim.checkpoint()
        sim.advance(27)
        twin = ljmd.Simulation(small_deck())
        twin.restore(checkpoint)
        self.assertEqual(twin.step, 33)
        twin.advance(27)
        np.testing.assert_array_equal(twin.positions, sim.positions)
        self.assertRaises(ljmd.CheckpointError, twin.restore, checkpoint[:-1])
        self.assertRaises(ljmd.InputError, twin.restore, "text")
        self.assertRaises(ljmd.CheckpointError, ljmd.Simulation(small_deck(seed=8)).restore, checkpoint)

    def test_a_run_that_blows_up_can_be_looked_at_but_not_continued(self):
        deck = small_deck()
        deck.stages = [ljmd.Stage("wild", 1000, time_step=0.3)]
        sim = ljmd.Simulation(deck, force=True)
        self.assertRaisesText(ljmd.PhysicsError, "stage 'wild'", of=lambda: sim.advance(1000))
        self.assertEqual(sim.velocities.shape, (108, 3))
        self.assertRaises(ljmd.InputError, sim.advance, 1)

    def test_few_bodies(self):
        sim = ljmd.Simulation(comet())
        energy = sim.total_energy
        track = [sim.positions[0, :2] for _ in sim.steps(every=100)]
        self.assertEqual(len(track), 10)
        self.assertLess(abs(sim.total_energy - energy), 1e-4)
        self.assertIsNone(sim.edges)
        for name in ("temperature", "pressure"):
            self.assertRaises(ljmd.InputError, getattr, sim, name)
        self.assertRaises(ljmd.InputError, sim.checkpoint)
        run = sim.results()
        self.assertEqual(len(run.trajectory()), 101)
        np.testing.assert_array_equal(run.trajectory()["x1"].iloc[::10].iloc[1:], [r[0] for r in track])
        self.assertLess(run["total_energy"].data["largest_deviation"], 1e-4)


class Views(Case):
    def test_no_step_is_taken_while_a_view_lives(self):
        sim = ljmd.Simulation(small_deck())
        with sim.arrays() as a:
            kept = a.positions[3:5]
            self.assertRaisesText(BufferError, "still in use", of=lambda: sim.advance(1))
        self.assertRaises(BufferError, sim.advance, 1)
        self.assertRaises(BufferError, next, sim.steps(3))
        self.assertRaises(BufferError, sim.restore, sim.checkpoint())
        self.assertEqual(sim.step, 0)
        before = kept.copy()
        del kept
        sim.advance(1)
        self.assertEqual(sim.step, 1)
        self.assertEqual(before.shape, (2, 3))

    def test_views_are_read_only_and_end_with_their_block(self):
        sim = ljmd.Simulation(small_deck())
        with sim.arrays() as a:
            for array in (a.positions, a.velocities, a.forces, a.masses, a.ids):
                self.assertFalse(array.flags.writeable)
                self.assertFalse(array.flags.owndata)
                with self.assertRaises(ValueError):
                    array.flags.writeable = True
            del array
        self.assertRaises(ljmd.InputError, getattr, a, "positions")
        sim.advance(1)

    def test_a_view_outlives_its_simulation(self):
        sim = ljmd.Simulation(small_deck())
        expected = sim.velocities
        with sim.arrays() as a:
            ids, velocities = a.ids, a.velocities
        del sim, a
        gc.collect()
        np.testing.assert_array_equal(velocities, expected[ids])


class Several(Case):
    def test_two_simulations_in_two_threads_have_the_bits_that_each_has_alone(self):
        decks = [long_deck(300), small_deck()]
        alone = [deck.run(progress=False).stages for deck in decks]
        together = [None, None]

        def run(k):
            together[k] = decks[k].run(progress=False, threads=k + 1).stages

        threads = [threading.Thread(target=run, args=(k,)) for k in range(2)]
        for thread in threads:
            thread.start()
        for thread in threads:
            thread.join()
        self.assertEqual(together, alone)

    def test_a_simulation_that_runs_in_another_thread_is_left_alone(self):
        sim = ljmd.Simulation(long_deck(15000))
        begun = threading.Event()
        thread = threading.Thread(target=lambda: sim.advance(15000, progress=lambda step: begun.set()))
        thread.start()
        begun.wait()
        for use in (lambda: sim.advance(1), lambda: sim.positions, sim.results, lambda: sim.step):
            self.assertRaisesText(ljmd.InUseError, "takes steps at this moment", of=use)
        thread.join()
        self.assertEqual(sim.step, 15000)

    def test_python_goes_on_while_the_engine_computes(self):
        sim = ljmd.Simulation(long_deck())
        with Other() as other:
            other.goes_on_during(lambda: sim.advance(200))

    @unittest.skipIf("ASAN_OPTIONS" in os.environ, "the address sanitizer keeps freed memory for a while")
    def test_simulations_leave_nothing_behind(self):
        def memory():
            with open("/proc/self/statm", encoding="ascii") as file:
                return int(file.read().split()[1]) * 4096

        def use():
            sim = ljmd.Simulation(small_deck(), observables=[lambda s: s.positions[0, 0]])
            for _ in sim.steps(20, every=10):
                sim.positions
            with sim.arrays() as a:
                a.velocities
            sim.results()

        for _ in range(100):
            use()
        gc.collect()
        before = memory()
        for _ in range(900):
            use()
        gc.collect()
        self.assertLess(memory() - before, 2e6)  # one simulation holds about 1 MB


class Results(Case):
    def test_results_are_pickled(self):
        run = small_deck().run(progress=False)
        again = pickle.loads(pickle.dumps(run))
        self.assertEqual(again.data, run.data)
        self.assertEqual(again["pressure"], run["pressure"])
        np.testing.assert_array_equal(again.thermo, run.thermo)

    def test_they_show_themselves(self):
        sim = ljmd.Simulation(small_deck(title="a test"))
        self.assertIn("step 0 of 60", repr(sim))
        run = sim.run(progress=False)
        self.assertIn("pressure", repr(run))
        self.assertIn("<table>", run._repr_html_())
        self.assertIn("a test", run._repr_html_())


if __name__ == "__main__":
    warnings.simplefilter("ignore", ljmd.RunWarning)
    unittest.main(warnings="ignore")
