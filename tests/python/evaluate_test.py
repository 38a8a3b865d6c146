"""Energy, forces and virial of configurations without a run."""

import copy
import pickle
import threading
import unittest
import warnings

import numpy as np

import ljmd
from cases import Case, long_deck, small_deck

LIQUID = {"type": "lennard-jones", "cutoff": 2.0, "truncation": "shifted"}


def moved(deck=None, steps=20):
    sim = ljmd.Simulation(deck or small_deck())
    sim.advance(steps)
    return sim


class Evaluations(Case):
    def test_the_bits_are_those_of_a_run_from_the_same_start(self):
        for precision in ("double", "mixed"):
            for atoms in (108, 864):
                deck = small_deck(atoms=atoms, tail=True, truncation="cut")
                deck.performance.precision = precision
                sim = ljmd.Simulation(deck)
                found = ljmd.evaluate(sim.positions, sim.edges, precision=precision,
                                      potential={**LIQUID, "truncation": "cut", "tail": True})
                np.testing.assert_array_equal(found.forces, sim.forces)
                self.assertEqual(found.potential_energy, sim.potential_energy)
                pressure = found.virial_pressure + sim.density * sim.temperature
                self.assertAlmostEqual(pressure, sim.pressure, 12)
                self.assertEqual(found.virial, np.trace(found.virial_tensor))

    def test_threads_and_images_change_nothing(self):
        sim = moved()
        expected = ljmd.evaluate(sim.positions, sim.edges, potential=LIQUID)
        far = sim.positions + sim.edges * np.random.default_rng(1).integers(-3, 4, (108, 3))
        for found in (ljmd.evaluate(sim.positions, sim.edges, potential=LIQUID, threads=2),
                      ljmd.evaluate(sim.positions, float(sim.edges[0]), potential=LIQUID)):
            np.testing.assert_array_equal(found.forces, expected.forces)
        np.testing.assert_allclose(ljmd.evaluate(far, sim.edges, potential=LIQUID).forces, expected.forces, atol=1e-11)

    def test_an_evaluator_follows_atoms_through_walls_and_to_other_boxes(self):
        sim = ljmd.Simulation(long_deck(2000, atoms=500))
        evaluator = ljmd.Evaluator({"cutoff": 2.5, "truncation": "cut"})
        for _ in sim.steps(300, every=7):
            found = evaluator(sim.positions, sim.edges)  # atoms jump where they are wrapped
            fresh = ljmd.evaluate(sim.unwrapped, sim.edges, potential={"cutoff": 2.5, "truncation": "cut"})
            np.testing.assert_allclose(found.forces, fresh.forces, atol=2e-11)
            self.assertAlmostEqual(found.potential_energy, fresh.potential_energy, 12)
        drift = np.array([0.4, 0.0, 0.0])
        for k in range(80):  # all atoms together, three boxes far
            found = evaluator(sim.positions + k * drift, sim.edges)
            np.testing.assert_allclose(found.forces, fresh.forces, atol=1e-9)
        bigger = evaluator(1.1 * sim.positions, 1.1 * sim.edges)
        again = ljmd.evaluate(1.1 * sim.positions, 1.1 * sim.edges, potential={"cutoff": 2.5, "truncation": "cut"})
        np.testing.assert_array_equal(bigger.forces, again.forces)
        self.assertEqual(len(evaluator(sim.positions[:17], sim.edges).forces), 17)
        shuffled = np.random.default_rng(2).uniform(0, 1, (500, 3)) * sim.edges
        again = ljmd.evaluate(shuffled, sim.edges, potential={"cutoff": 2.5, "truncation": "cut"})
        np.testing.assert_allclose(evaluator(shuffled, sim.edges).forces / np.abs(again.forces).max(),
                                   again.forces / np.abs(again.forces).max(), atol=1e-12)

    def test_two_atoms_have_the_closed_form(self):
        found = ljmd.evaluate([[1, 1, 1], [1, 2.2, 1]], 8)
        r = 1.2
        shift = 4 * (2.5**-12 - 2.5**-6)
        self.assertAlmostEqual(found.potential_energy, (4 * (r**-12 - r**-6) - shift) / 2, 14)
        force = 24 * (2 * r**-13 - r**-7)
        np.testing.assert_allclose(found.forces, [[0, -force, 0], [0, force, 0]], atol=1e-13)
        self.assertAlmostEqual(found.virial_tensor[1, 1], r * force, 13)
        self.assertAlmostEqual(found.virial_pressure, r * force / (3 * 8**3), 15)
        self.assertIn("2 atoms", repr(found))

    def test_energies_of_atoms_sum_to_the_energy_and_stand_by_atom(self):
        sim = moved()
        plain = ljmd.evaluate(sim.positions, sim.edges, potential=LIQUID)
        found = ljmd.evaluate(sim.positions, sim.edges, potential=LIQUID, energies=True)
        self.assertIsNone(plain.energies)
        np.testing.assert_array_equal(found.forces, plain.forces)
        self.assertEqual(found.energies.shape, (108,))
        self.assertAlmostEqual(found.energies.sum(), 108 * found.potential_energy, 10)
        for other in (2, 5):
            again = ljmd.evaluate(sim.positions, sim.edges, potential=LIQUID, energies=True, threads=other)
            np.testing.assert_array_equal(again.energies, found.energies)
        order = np.random.default_rng(3).permutation(108)
        np.testing.assert_allclose(ljmd.evaluate(sim.positions[order], sim.edges, potential=LIQUID, energies=True).energies,
                                   found.energies[order], rtol=1e-12)
        with_tail = ljmd.evaluate(sim.positions, sim.edges, energies=True, potential={**LIQUID, "truncation": "cut", "tail": True})
        without = ljmd.evaluate(sim.positions, sim.edges, energies=True, potential={**LIQUID, "truncation": "cut"})
        np.testing.assert_array_equal(with_tail.energies, without.energies)
        table = ljmd.pair(lambda r: 4 * (r**-12 - r**-6), cutoff=2.0, truncation="shifted")
        np.testing.assert_allclose(ljmd.evaluate(sim.positions, sim.edges, potential=table, energies=True).energies,
                                   found.energies, atol=1e-6)

    def test_other_potentials(self):
        sim = moved()
        morse = {"type": "morse", "cutoff": 2.0, "truncation": "force-shifted", "well_depth": 1.0, "steepness": 6.0,
                 "minimum": 1.12}
        deck = ljmd.Deck.fluid(108, 0.8, 1.0, potential="morse", cutoff=2.0, truncation="force-shifted", well_depth=1.0,
                               steepness=6.0, minimum=1.12)
        deck.stages = [ljmd.Stage("all", 1)]
        start = ljmd.Simulation(deck)
        np.testing.assert_array_equal(ljmd.evaluate(start.positions, start.edges, potential=morse).forces, start.forces)
        table = ljmd.pair(lambda r: 4 * (r**-12 - r**-6), cutoff=2.0, truncation="shifted")
        np.testing.assert_allclose(ljmd.evaluate(sim.positions, sim.edges, potential=table).forces,
                                   ljmd.evaluate(sim.positions, sim.edges, potential=LIQUID).forces, atol=1e-6)

    def test_wrong_input_is_one_clear_message(self):
        r = np.random.default_rng(0).uniform(0, 6, (10, 3))
        for text, arguments, options in (
                ("shape", (r.T, 6), {}), ("(N, 3)", (r.ravel(), 6), {}), ("numbers", ([["a", "b", "c"]], 6), {}),
                ("not finite", (np.where(r == r[3, 1], np.nan, r), 6), {}), ("million", (r + 1e9, 6), {}),
                ("edges", (r, (6, 6)), {}), ("edges", (r, "six"), {}), ("above 0", (r, (6, 6, 0)), {}),
                ("above 0", (r, np.nan), {}), ("half the box", (r, 4.9), {}), ("1 to", (np.empty((0, 3)), 6), {}),
                ("unknown", (r, 6), dict(potential={"type": "lenard-jones"})),
                ("truncation", (r, 6), dict(potential={"truncation": "chopped"})),
                ("cutoff", (r, 6), dict(potential={"cutoff": -1})), ("number", (r, 6), dict(potential={"cutoff": "2.5"})),
                ("switch", (r, 6), dict(potential={"truncation": "switched"})), ("tail", (r, 6), dict(potential={"tail": True})),
                ("sigma", (r, 6), dict(potential={"sigma": 1.0})), ("table", (r, 6), dict(potential="lennard-jones")),
                ("precision", (r, 6), dict(precision="half")), ("threads", (r, 6), dict(threads=0)),
                ("abacus", (r, 6), dict(simd="abacus"))):
            self.assertRaisesText(ljmd.InputError, text, of=lambda: ljmd.evaluate(*arguments, **options))

    def test_atoms_that_overlap_are_named_and_the_next_configuration_is_evaluated(self):
        evaluator = ljmd.Evaluator()
        for there in ([1, 1, 1], [9, 1, -7]):
            self.assertRaisesText(ljmd.InputError, "atoms 0 and 2, counted from 0, are 0 apart: they overlap",
                                  of=lambda: evaluator([[1, 1, 1], [4, 4, 4], there], 8.0))
        found = evaluator([[1, 1, 1], [4, 4, 4], [1, 1, 1 + 2**-42]], 8.0)  # whose forces are numbers
        np.testing.assert_allclose(found.forces[2, 2], 48 * 2.0**(42 * 13), rtol=1e-12)
        self.assertIn("largest force 1.106e+166", repr(found))

    def test_pairs_nearer_than_the_start_of_a_table_are_counted_and_warned_of(self):
        table = ljmd.pair(lambda r: 4 * (r**-12 - r**-6), cutoff=2.5, truncation="shifted", start=0.9)
        for near, count in ((0.95, 0), (0.85, 1), (7.15, 1)):  # the last across a wall
            with warnings.catch_warnings(record=True) as caught:
                warnings.simplefilter("always")
                found = ljmd.evaluate([[1, 1, 1], [1 + near, 1, 1], [4, 4, 4]], 8.0, potential=table)
            self.assertEqual(found.pairs_too_near, count)
            self.assertEqual([str(each.message)[:41] for each in caught], ["1 pair of atoms is nearer than 0.9, where"] * count)
            self.assertEqual([each.category for each in caught], [ljmd.RunWarning] * count)
        self.assertEqual(ljmd.evaluate([[1, 1, 1], [1.1, 1, 1]], 8.0).pairs_too_near, 0)

    def test_arrays_of_any_kind_are_taken_and_not_changed(self):
        sim = moved()
        expected = ljmd.evaluate(sim.positions, sim.edges, potential=LIQUID).forces
        positions = np.asfortranarray(sim.positions)
        positions.flags.writeable = False
        for array in (positions, sim.positions.tolist(), np.repeat(sim.positions, 2, axis=0)[::2]):
            np.testing.assert_array_equal(ljmd.evaluate(array, sim.edges, potential=LIQUID).forces, expected)

    def test_copies_pickles_and_threads(self):
        sim = moved()
        evaluator = ljmd.Evaluator(LIQUID)
        expected = evaluator(sim.positions, sim.edges)
        for twin in (copy.deepcopy(evaluator), pickle.loads(pickle.dumps(evaluator))):
            np.testing.assert_array_equal(twin(sim.positions, sim.edges).forces, expected.forces)
        np.testing.assert_array_equal(pickle.loads(pickle.dumps(expected)).forces, expected.forces)
        wrong = []

        def work():
            for _ in range(50):
                if not np.allclose(evaluator(sim.positions, sim.edges).forces, expected.forces):
                    wrong.append(True)

        threads = [threading.Thread(target=work) for _ in range(4)]
        for thread in threads:
            thread.start()
        for thread in threads:
            thread.join()
        self.assertEqual(wrong, [])


if __name__ == "__main__":
    warnings.simplefilter("ignore", ljmd.RunWarning)
    unittest.main(warnings="ignore")
