"""Runs with a directory: results, tables, resuming, observables of one's own."""

import json
import sys
import unittest
import warnings
from unittest import mock

import numpy as np

import ljmd
from cases import Case, comet, command_line, long_deck, small_deck


@ljmd.observable(every=5, unit="sigma/tau")
def fastest(s):
    """The largest speed."""
    return np.linalg.norm(s.velocities, axis=1).max()


class Runs(Case):
    def run_of(self, name="run", deck=None, **options):
        return (deck or small_deck()).run(self.folder / name, progress=False, **options)

    def test_a_run_has_observables_with_errors_tables_and_samples(self):
        deck = small_deck(substance=ljmd.ARGON)
        deck.analysis.rdf(bins=50, every=10)
        for run in (deck.run(progress=False), self.run_of(deck=deck)):
            pressure = run["pressure"]
            self.assertEqual((pressure.unit, pressure.si.unit, pressure.samples), ("epsilon/sigma^3", "bar", 4))
            self.assertAlmostEqual(pressure.si.mean / pressure.mean, 418.9, 0)
            self.assertGreater(pressure.error, 0)
            self.assertEqual(float(pressure), pressure.mean)
            self.assertIn("±", str(pressure))
            self.assertEqual(len(run.thermo), 7)
            self.assertEqual(run.thermo["step"].dtype, np.int64)
            self.assertIn("rdf", run.tables)
            self.assertEqual(len(run.table("rdf")["g"]), 50)
            self.assertRaisesText(KeyError, "did you mean 'pressure'?", of=lambda: run["presure"])
            self.assertRaisesText(KeyError, "rdf", of=lambda: run.table("rdff"))
            self.assertNotIn("presure", run)
            self.assertIn("pressure", run)
            self.assertEqual([stage["steps"] for stage in run.stages], [20, 40])

    def test_a_crystal_under_the_barostat_of_each_edge_has_its_structure_and_its_edges(self):
        deck = ljmd.Deck.fluid(atoms=256, density=1.0, temperature=0.1, cutoff=2.5, truncation="shifted", seed=3)
        hold = {"type": "anisotropic-cell-rescaling", "pressure": 0.0, "time": 5.0, "compressibility": 0.02}
        deck.stages = [ljmd.Stage("production", 100, sample=True, thermostat="langevin", barostat=hold)]
        deck.analysis.crystal(every=10, families=3)
        for run in (deck.run(progress=False), self.run_of(deck=deck)):
            self.assertEqual(len(run.table("bragg")), 3)
            self.assertGreater(run["bragg_peak"].mean, 0.9)
            self.assertAlmostEqual(run["site_displacement_debye_waller"].mean / run["site_displacement"].mean, 1.0, 2)
            nearest = (4 / run["density"].mean) ** (1 / 3) / 2**0.5
            self.assertAlmostEqual(run["lindemann_ratio"].mean * nearest / run["site_displacement"].mean ** 0.5, 1.0, 2)
            edges = [run.thermo[f"edge_{a}"] for a in "xyz"]
            np.testing.assert_allclose(edges[0] * edges[1] * edges[2] * run.thermo["density"], 256, rtol=1e-12)

    def test_without_pandas_tables_are_structured_arrays(self):
        run = small_deck().run(progress=False)
        with mock.patch.dict(sys.modules, pandas=None):
            thermo = run.thermo
        self.assertIsInstance(thermo, np.ndarray)
        self.assertEqual(thermo.dtype["step"], np.int64)
        np.testing.assert_array_equal(thermo["pressure"], run.thermo["pressure"])

    def test_a_line_that_is_being_written_is_left_out(self):
        run = self.run_of()
        thermo = self.folder / "run" / "thermo.csv"
        whole = thermo.read_text()
        header, last = whole.index("\n"), whole[:-1].rindex("\n") + 1
        for cut in range(last, len(whole)):  # the last digits of a number may be missing, and it still reads as one
            thermo.write_text(whole[:cut])
            self.assertEqual(len(run.thermo), 6, whole[last:cut])
        thermo.write_text(whole[:header + 1])
        self.assertEqual(len(run.thermo), 0)
        for text in ("", whole[:header]):
            thermo.write_text(text)
            self.assertRaisesText(ljmd.DataError, "without even a header row", of=lambda: run.thermo)
        thermo.write_text(whole.replace("\n10,", "\nten,"))
        self.assertRaisesText(ljmd.DataError, "thermo.csv: line 3: 'ten' in column 'step' is not a number", of=lambda: run.thermo)

    def test_a_directory_is_opened_again(self):
        run = self.run_of()
        again = ljmd.open(self.folder / "run")
        self.assertEqual(again.data, run.data)
        self.assertTrue(again.finished)
        done = command_line("run", self.saved(), "--quiet", "--out", self.folder / "other")
        self.assertEqual(done.returncode, 0, done.stderr)
        self.assertEqual(ljmd.open(self.folder / "other").stages, run.stages)
        self.assertRaisesText(ljmd.DataError, "not the directory of a run", of=lambda: ljmd.open(self.folder))

    def test_damaged_results_are_said_with_their_file(self):
        self.run_of()
        file = self.folder / "run" / "results.json"
        whole = json.loads(file.read_text())

        def read():
            run = ljmd.open(self.folder / "run")
            return repr(run), run.warnings, run.stages, run._repr_html_()

        read()
        file.write_text("{}")
        self.assertRaisesText(ljmd.DataError, str(file), "'observables' is missing", of=read)
        for key in ("title", "system", "observables", "stages", "warnings"):
            file.write_text(json.dumps({**whole, key: 3}))
            self.assertRaisesText(ljmd.DataError, str(file), f"'{key}' is 3", of=read)
        file.write_text(json.dumps({**whole, "system": {"atoms": 108}}))
        self.assertRaisesText(ljmd.DataError, str(file), "'density' is missing", of=read)

    def saved(self):
        small_deck().save(self.folder / "small.toml")
        return self.folder / "small.toml"

    def test_a_run_is_not_replaced_unless_that_is_asked_for(self):
        self.run_of()
        self.assertRaisesText(ljmd.InputError, "already holds a run", of=self.run_of)
        self.assertTrue(self.run_of(replace=True).finished)
        self.assertRaises(ljmd.InputError, small_deck().run, replace=True)
        self.assertRaises(ljmd.InputError, small_deck().run, walltime=3)

    def test_a_page_is_written_when_it_is_asked_for(self):
        run = self.run_of()
        self.assertFalse((self.folder / "run/report.html").exists())
        self.assertEqual(run.report(), self.folder / "run/report.html")
        page = run.report(self.folder / "page.html").read_text()
        self.assertEqual(page, (self.folder / "run/report.html").read_text())
        self.assertIn('"kind":"run"', page)
        self.assertRaisesText(ljmd.DataError, "give it a directory", of=small_deck().run(progress=False).report)
        self.assertRaises(ljmd.FileError, run.report, self.folder / "nowhere/page.html")
        deck = small_deck()
        deck.output.report = True
        self.assertTrue((self.run_of("asked", deck).directory / "report.html").exists())
        (self.folder / "asked/report.html").unlink()
        ljmd.resume(self.folder / "asked", steps=20, progress=False)
        self.assertTrue((self.folder / "asked/report.html").exists())

    def test_a_finished_run_is_made_longer_as_one_long_run(self):
        self.run_of()
        longer = ljmd.resume(self.folder / "run", steps=20, progress=False)
        deck = small_deck()
        deck.stages[1].steps = 60
        self.assertEqual(longer.stages, self.run_of("long", deck).stages)
        for wrong in (-1, 1.5, "20"):
            self.assertRaises(ljmd.InputError, ljmd.resume, self.folder / "run", steps=wrong)
        self.assertRaises(ljmd.DataError, ljmd.resume, self.folder / "none")

    def test_few_bodies(self):
        run = self.run_of("comet", comet())
        deck = comet()
        deck.analysis.orbit(body=1)
        self.assertLess(run["total_energy"].data["largest_deviation"], 1e-4)
        self.assertTrue(np.isnan(run["total_energy"].error))
        found = deck.run(progress=False)
        self.assertGreater(found.findings["orbit"]["eccentricity_at_end"].mean, 0.4)
        self.assertIn("orbit: eccentricity", repr(found))
        np.testing.assert_array_equal(run.trajectory(), found.trajectory())
        self.assertEqual(len(run.trajectory()), 101)
        self.assertRaises(ljmd.InputError, comet().run, observables=[fastest])

    def test_errors_are_pythons_too(self):
        self.assertTrue(issubclass(ljmd.InputError, ValueError) and issubclass(ljmd.FileError, OSError))
        self.assertRaises(ljmd.FileError, small_deck().run, "/proc/nothing/here", progress=False)
        self.assertRaises(ljmd.InputError, small_deck().run, "", progress=False)
        (self.folder / "file").write_text("")
        self.assertRaises(ljmd.Error, small_deck().run, self.folder / "file", progress=False)

    def test_warnings_are_pythons(self):
        deck = small_deck()
        deck.stages[0].temperature = 1.0
        deck.stages[0].time_step = 0.03
        with warnings.catch_warnings(record=True) as seen:
            warnings.simplefilter("always")
            deck.run(progress=False, force=True)
        self.assertTrue(any(issubclass(each.category, ljmd.RunWarning) for each in seen))
        with warnings.catch_warnings():
            warnings.simplefilter("error")
            self.assertRaises(ljmd.RunWarning, deck.run, progress=False, force=True)


class Observables(Case):
    def test_their_means_have_errors_and_do_not_change_the_run(self):
        deck = long_deck(400, atoms=256)
        plain = deck.run(progress=False)
        speeds = []

        @ljmd.observable(every=5, unit="sigma/tau", name="keeps")
        def keeps(s):
            speeds.append(np.linalg.norm(s.velocities, axis=1).max())
            return speeds[-1]

        run = deck.run(progress=False, observables=[fastest, keeps])
        self.assertEqual(run.stages, plain.stages)
        self.assertEqual(run["pressure"], plain["pressure"])
        self.assertEqual(len(speeds), 80)
        self.assertAlmostEqual(run["fastest"].mean, np.mean(speeds), 12)
        self.assertEqual((run["fastest"].unit, run["fastest"].samples), ("sigma/tau", 80))
        self.assertGreater(run["fastest"].error, np.std(speeds) / np.sqrt(80) * 0.9)
        self.assertEqual((run["keeps"].mean, run["keeps"].error), (run["fastest"].mean, run["fastest"].error))

    def test_a_snapshot_is_by_id_and_has_energies_on_request(self):
        seen = {}

        @ljmd.observable(every=40, energy=True)
        def look(s):
            seen.update(step=s.step, time=s.time, positions=s.positions, unwrapped=s.unwrapped, velocities=s.velocities,
                        forces=s.forces, edges=s.edges, energy=s.total_energy, pressure=s.pressure, snapshot=s)
            return s.temperature

        sim = ljmd.Simulation(small_deck(), observables=[look])
        run = sim.run(progress=False)
        self.assertEqual(seen["step"], 40)
        again = ljmd.Simulation(small_deck())
        again.advance(40)
        for name in ("positions", "unwrapped", "velocities", "forces", "edges", "time"):
            np.testing.assert_array_equal(seen[name], getattr(again, name), name)
        self.assertEqual((seen["energy"], seen["pressure"]), (again.total_energy, again.pressure))
        self.assertEqual(run["look"].mean, again.temperature)
        self.assertRaisesText(ljmd.InputError, "has ended", of=lambda: seen["snapshot"].positions)

    def test_what_is_wrong_with_one_is_said(self):
        @ljmd.observable(every=7)
        def without_energy(s):
            return s.pressure

        for wrong, text in [(lambda s: "3", "returned str at step"), (lambda s: s.positions, "returned ndarray"),
                            (lambda s: None, "returned NoneType"), (lambda s: float("nan"), "is nan at step"),
                            (without_energy, "energy=True")]:
            self.assertRaisesText(ljmd.InputError, text, of=lambda: small_deck().run(observables=[wrong], progress=False))
        self.assertRaises(ZeroDivisionError, small_deck().run, observables=[lambda s: 1 / 0], progress=False)
        for wrong in ([fastest, fastest], [3], ["fastest"], [ljmd.observable()], [ljmd.observable(len, name="pressure")]):
            self.assertRaises(ljmd.InputError, small_deck().run, observables=wrong)
        self.assertRaises(ljmd.InputError, ljmd.observable, every=0)

    def test_its_simulation_cannot_be_used_in_it(self):
        sims = []
        sims.append(ljmd.Simulation(small_deck(), observables=[lambda s: sims[0].temperature]))
        self.assertRaisesText(ljmd.InUseError, "takes steps at this moment", of=lambda: sims[0].run(progress=False))
        sims.clear()

    def test_a_run_with_them_is_resumed_by_python_alone(self):
        directory = self.folder / "run"
        whole = small_deck().run(observables=[fastest], progress=False)
        deck = small_deck()
        deck.output.checkpoint = dict(every=25)

        @ljmd.observable(every=5, unit="sigma/tau", name="fastest")
        def fails(s):
            if s.step == 55:
                raise RuntimeError("enough")
            return fastest(s)

        self.assertRaises(RuntimeError, deck.run, directory, observables=[fails], progress=False)
        self.assertEqual(command_line("resume", directory).returncode, 6)
        self.assertRaises(ljmd.CheckpointError, ljmd.resume, directory, observables=[], progress=False)
        run = ljmd.resume(directory, observables=[fastest], progress=False)
        self.assertEqual(run["fastest"], whole["fastest"])
        self.assertEqual(run.stages, whole.stages)
        self.assertEqual(json.loads((directory / "results.json").read_text())["stages"], whole.stages)


if __name__ == "__main__":
    warnings.simplefilter("ignore", ljmd.RunWarning)
    unittest.main(warnings="ignore")
