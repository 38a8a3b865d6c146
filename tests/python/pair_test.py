"""Pair potentials of one's own: the error of their tables is as small as stated, and a run with one is right."""

import math
import pickle
import unittest
import warnings

import numpy as np

import ljmd
from cases import Case, small_deck

R = np.linspace(0.8, 2.499, 7001)


def lennard_jones(r):
    return 4 * (r**-12 - r**-6)


def cut(function, **options):
    return ljmd.pair(function, **{"cutoff": 2.5, "truncation": "cut", **options})


class Tables(Case):
    def test_the_error_of_energy_and_force_is_no_larger_than_stated(self):
        cases = [(lennard_jones, lambda r: 24 * (2 * r**-13 - r**-7)),
                 (lambda r: 4 * (r**-9 - r**-6), lambda r: 4 * (9 * r**-10 - 6 * r**-7)),
                 (lambda r: np.exp(-r * r), lambda r: 2 * r * np.exp(-r * r)),
                 (lambda r: np.cos(20 * r) / r, lambda r: 20 * np.sin(20 * r) / r + np.cos(20 * r) / r**2)]
        for energy, force in cases:
            for error in (1e-4, 1e-9):
                made = cut(energy, error=error)
                self.assertLessEqual(made.error, error)
                of_energy = np.max(np.abs(made(R) - energy(R)) / (1 + np.abs(energy(R))))
                of_force = np.max(np.abs(made.force(R) - force(R)) / (1 + np.abs(force(R))))
                self.assertLessEqual(of_energy, 1.5 * made.error + 1e-14)
                self.assertLessEqual(of_force, made.force_error + 1e-12)
        self.assertLess(cut(lennard_jones).force_error, 1e-5)

    def test_truncations_are_the_engines(self):
        u = lennard_jones(R)
        shift, force = lennard_jones(2.5), 24 * (2 * 2.5**-13 - 2.5**-7)
        np.testing.assert_allclose(cut(lennard_jones, truncation="shifted")(R), u - shift, atol=1e-9)
        np.testing.assert_allclose(cut(lennard_jones, truncation="force-shifted")(R), u - shift + (R - 2.5) * force,
                                   atol=1e-8)
        switched = cut(lennard_jones, truncation="switched", switch_start=2.0)
        np.testing.assert_allclose(switched(R[R < 2.0]), u[R < 2.0], atol=1e-9)
        self.assertEqual(switched(3.0), 0.0)
        self.assertAlmostEqual(float(cut(lambda r: 0 * r).second_virial(1.0)), 0.0)

    def test_any_function_of_a_number_will_do(self):
        made = cut(lambda r: math.exp(-r))
        self.assertAlmostEqual(float(made(1.0)), math.exp(-1), 9)
        self.assertEqual(made(np.ones((2, 3))).shape, (2, 3))

        @ljmd.pair(cutoff=2.0, truncation="shifted")
        def core(r):
            return (1 - r / 2)**2

        self.assertEqual((core.name, core.cutoff), ("core", 2.0))
        self.assertIn("shifted at 2", repr(core))
        np.testing.assert_array_equal(pickle.loads(pickle.dumps(core))(R), core(R))

    def test_what_is_wrong_with_one_is_said(self):
        for wrong, text in [(lambda: cut(lambda r: np.where(r < 1.5, 0.0, 1.0)), "a kink or a jump"),
                            (lambda: cut(lambda r: np.log(r - 1)), "a larger `start`"),
                            (lambda: cut(lambda r: "u"), "not an energy for each"),
                            (lambda: cut(lambda r: np.ones(3)), "not an energy for each"),
                            (lambda: cut(3), "a function u(r)"),
                            (lambda: cut(lennard_jones, cutoff=-1), "cutoff"),
                            (lambda: cut(lennard_jones, cutoff="2.5"), "cutoff"),
                            (lambda: cut(lennard_jones, start=3.0), "from 3 to 2.5"),
                            (lambda: cut(lennard_jones, truncation="cud"), "unknown truncation 'cud'"),
                            (lambda: cut(lennard_jones, truncation="switched", switch_start=3.0), "switch_start"),
                            (lambda: cut(lennard_jones, name="morse"), "a name of its own")]:
            self.assertRaisesText(ljmd.InputError, text, of=wrong)
        self.assertRaises(TypeError, ljmd.pair, lennard_jones)
        self.assertRaises(ZeroDivisionError, cut, lambda r: 1 / 0)


class Runs(Case):
    def test_a_table_of_lennard_jones_runs_as_lennard_jones(self):
        built_in = small_deck(truncation="force-shifted")
        own = built_in.copy()
        own.potential = ljmd.pair(lennard_jones, cutoff=2.0, truncation="force-shifted")
        expected, found = built_in.run(progress=False), own.run(progress=False, threads=2)
        for name in ("potential_energy", "pressure", "temperature"):
            self.assertAlmostEqual(found[name].mean, expected[name].mean, 7)
        self.assertEqual(own.run(progress=False).stages, found.stages, "threads change bits")

    def test_pairs_nearer_than_the_start_of_the_table_are_counted_in_the_results(self):
        def warnings_of(start, directory=None):
            deck = small_deck(density=0.7, temperature=40.0)
            deck.potential = ljmd.pair(lennard_jones, cutoff=2.0, truncation="shifted", start=start, name="twelve-six")
            deck.stages = [ljmd.Stage("production", 200, time_step=0.0005, thermostat="stochastic-rescaling", sample=True)]
            run = deck.run(directory, progress=False)
            return [text for text in run.warnings if "where the table of the pair potential 'twelve-six' begins" in text]

        self.assertEqual(warnings_of(None), [])
        found = warnings_of(0.95)
        self.assertEqual(len(found), 1)
        self.assertRegex(found[0], r"in \d+ of 20 samples pairs of atoms were nearer than 0.95, .*: [\d.]+ pairs a sample, the nearest 0.\d+")
        self.assertEqual(warnings_of(0.95, self.folder / "run"), found)

    def test_energy_is_conserved(self):
        deck = small_deck()
        deck.potential = ljmd.pair(lambda r: 4 * (r**-9 - r**-6), cutoff=2.0, truncation="force-shifted")
        deck.stages = [ljmd.Stage("drift", 2000, time_step=0.002, sample=True)]
        energies = deck.run(progress=False).thermo["total_energy"]
        self.assertLess(np.ptp(energies), 2e-3)

    def test_a_deck_shows_it_and_refuses_what_it_cannot_do(self):
        deck = small_deck()
        deck.potential = soft = ljmd.pair(lambda r: r**-9, cutoff=2.0, truncation="cut", name="soft")
        self.assertIs(deck.potential, soft)
        self.assertIn("pair potential 'soft' of Python", repr(deck))
        self.assertIs(deck.copy().potential, soft)
        self.assertRaises(ljmd.InputError, deck.save, self.folder / "deck.toml")
        deck["potential"]["cutoff"] = 1.5
        self.assertRaisesText(ljmd.InputError, "was changed", of=deck.run)
        deck.potential = dict(type="lennard-jones", cutoff=2.0, truncation="shifted")
        self.assertEqual(deck.run(progress=False).stages, small_deck().run(progress=False).stages)


if __name__ == "__main__":
    warnings.simplefilter("ignore", ljmd.RunWarning)
    unittest.main(warnings="ignore")
