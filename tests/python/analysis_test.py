"""Equations of state, and analyses of trajectories."""

import json
import unittest
import warnings

import numpy as np

import ljmd
from cases import Case, command_line, small_deck


class Equations(Case):
    def test_states_and_coexistence_are_those_of_the_command_line(self):
        state = ljmd.eos(1.5, 0.5)
        expected = json.loads(command_line("eos", "--temperature", 1.5, "--density", 0.5, "--json").stdout)
        self.assertEqual(state.data, expected)
        self.assertEqual(state.pressure, expected["pressure"])
        self.assertIn("epsilon/sigma^3", repr(state))
        both = ljmd.eos(0.9)
        self.assertEqual(both.data, json.loads(command_line("eos", "--temperature", 0.9, "--json").stdout))
        self.assertGreater(both.liquid.density, both.vapour.density)
        self.assertEqual(ljmd.eos(1.5, 0.5, model="kolafa-nezbeda1994").model, "kolafa-nezbeda1994")
        self.assertTrue(all(each.critical_temperature > 1.2 for each in ljmd.equations() if "2015" not in each.model))

    def test_arrays_give_arrays(self):
        densities = np.linspace(0.1, 0.5, 5).reshape(5, 1)
        isotherms = ljmd.eos([1.5, 2.0], densities)
        self.assertEqual(isotherms.pressure.shape, (5, 2))
        self.assertEqual(isotherms.pressure[2, 1], ljmd.eos(2.0, densities[2, 0]).pressure)

    def test_a_pressure_stands_in_for_a_density(self):
        state = ljmd.eos(1.5, 0.5)
        found = ljmd.eos(1.5, pressure=state.pressure)
        self.assertEqual(found.data, json.loads(command_line("eos", "--temperature", 1.5, "--pressure", repr(state.pressure), "--json").stdout))
        self.assertAlmostEqual(found.density, 0.5, places=10)
        self.assertAlmostEqual(found.joule_thomson_coefficient, state.joule_thomson_coefficient, places=9)
        self.assertEqual((found.phase, found.metastable), ("fluid", []))
        both = ljmd.eos(pressure=ljmd.eos(0.9).pressure)
        self.assertAlmostEqual(both.temperature, 0.9, places=9)
        isobar = ljmd.eos([0.8, 1.5, 3.0], pressure=0.5)
        self.assertEqual(isobar.phase.tolist(), ["liquid", "fluid", "fluid"])
        self.assertTrue(np.all(np.diff(isobar.density) < 0))
        self.assertEqual(isobar.thermal_expansion[1], ljmd.eos(1.5, pressure=0.5).thermal_expansion)
        self.assertEqual(ljmd.eos([0.8, 0.9]).liquid.density[1], ljmd.eos(0.9).liquid.density)

    def test_wrong_states_are_refused_and_doubtful_ones_warned_of(self):
        for arguments in ((0,), (-1, 0.5), (np.nan, 0.5), (1.0, -0.1), ("hot", 0.5), (1.4,), (1.0, np.inf)):
            self.assertRaises(ljmd.InputError, ljmd.eos, *arguments)
        for wrong in (dict(), dict(density=0.5), dict(temperature=1, density=0.5, pressure=1), dict(pressure=0), dict(pressure=0.2)):
            self.assertRaises(ljmd.InputError, ljmd.eos, **wrong)
        self.assertRaisesText(ljmd.InputError, "thol2016", of=lambda: ljmd.eos(1.0, 0.5, model="ideal"))
        with self.assertWarnsRegex(ljmd.RunWarning, "coexist"):
            ljmd.eos(0.9, 0.5)


class Trajectories(Case):
    def setUp(self):
        super().setUp()
        deck = small_deck()
        deck.output.trajectory = dict(every=10, velocities=True)
        deck.analysis.rdf(bins=40, every=10)
        self.run_ = deck.run(self.folder / "run", progress=False)

    def test_an_analysis_of_the_frames_of_a_run_is_that_of_the_run(self):
        found = self.run_.trajectory().rdf(bins=40)
        np.testing.assert_allclose(found.table()["g"], self.run_.table("rdf")["g"], rtol=1e-12)

    def test_a_file_is_read_without_its_run(self):
        traj = ljmd.trajectory(self.folder / "run/trajectory.h5md")
        self.assertEqual((traj.frames, traj.atoms, traj.has_velocities), (7, 108, True))
        self.assertEqual(traj.times.shape, (7,))
        self.assertAlmostEqual(traj.spacing, 0.04)
        self.assertIn("7 frames of 108 atoms", repr(traj))
        both = traj.analyze("rdf", "msd", rdf=dict(bins=30))
        self.assertEqual(len(both.table("rdf")), 30)
        self.assertIn("msd", both.tables)
        self.assertTrue(traj.analyze().tables)
        self.assertEqual(len(ljmd.trajectory(self.folder / "run/trajectory.h5md", start=0.1).rdf().data["observables"]) > 0, True)
        with_energies = ljmd.trajectory(self.folder / "run/trajectory.h5md", deck=small_deck(), energies=True)
        self.assertAlmostEqual(with_energies.analyze("rdf")["potential_energy"].mean,
                               self.run_.thermo["potential_energy"].mean(), 8)

    def test_what_cannot_be_done_is_said(self):
        traj = ljmd.trajectory(self.folder / "run/trajectory.h5md")
        self.assertRaises(AttributeError, getattr, traj, "rdff")
        self.assertRaises(ljmd.InputError, traj.analyze, "rdff")
        self.assertRaises(ljmd.InputError, traj.rdf, binss=3)
        self.assertRaises(ljmd.InputError, ljmd.trajectory, self.folder / "run/trajectory.h5md", positions="folded")
        self.assertRaises(ljmd.DataError, ljmd.trajectory, self.folder / "run/results.json")
        self.assertRaises(ljmd.Error, ljmd.trajectory, self.folder / "nothing.h5md")
        self.assertRaises(ljmd.DataError, small_deck().run(progress=False).trajectory)


if __name__ == "__main__":
    warnings.simplefilter("ignore", ljmd.RunWarning)
    unittest.main(warnings="ignore")
