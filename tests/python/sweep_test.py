"""Sweeps: points as a table, the numbers of the command line, resuming, Ctrl-C, mistakes."""

import itertools
import json
import os
import pickle
import shutil
import signal
import sys
import threading
import unittest
import warnings
from unittest import mock

import numpy as np

import ljmd
from alarm import waiting
from cases import Case, comet, command_line, long_deck, program, small_deck

os.environ.setdefault("LJMD_PROGRAM", program())
GRID = {"system.temperature": [1.0, np.float64(1.5)], "system.density": (0.6, 0.8)}


class Sweeps(Case):
    def sweep(self, points=None, deck=None, **options):
        options = {"directory": self.folder / "sweep", "progress": False, "jobs": 2, **options}
        return (deck or small_deck()).sweep(GRID if points is None else points, **options)

    def test_all_points_are_a_table_with_errors(self):
        counted = []
        sweep = self.sweep(progress=counted.append)
        table = sweep.to_dataframe()
        self.assertEqual(list(table["system.temperature"]), [1.0, 1.0, 1.5, 1.5])
        self.assertEqual(list(table["system.density"]), [0.6, 0.8, 0.6, 0.8])
        self.assertEqual(len(table), len(sweep))
        self.assertEqual(counted[-1], 4)
        for k, point in enumerate(sweep):
            alone = small_deck()
            alone.system.temperature, alone.system.density = point.values.values()
            run = alone.run(progress=False)
            for name in ("temperature", "pressure", "potential_energy"):
                self.assertEqual(table[name][k], run[name].mean)
                self.assertEqual(table[f"{name}_standard_error"][k], run[name].error)
            self.assertEqual(point.run.stages, run.stages)
        self.assertTrue(sweep.finished)
        self.assertEqual(sweep[1].name, "temperature=1.0,density=0.8")
        self.assertIn("finished", repr(sweep[1]))
        self.assertIn("±", repr(sweep))
        self.assertIn("<table>", sweep._repr_html_())
        header = (self.folder / "sweep/sweep.csv").read_text(encoding="utf-8").splitlines()[0].split(",")
        self.assertEqual(list(table), header)

    def test_sweeps_of_the_command_line_and_directories_are_opened(self):
        small_deck().save(self.folder / "small.toml")
        done = command_line("sweep", self.folder / "small.toml", "--grid", "system.temperature=1.0|1.5,system.density=0.6|0.8",
                            "--out", self.folder / "cli")
        self.assertEqual(done.returncode, 0, done.stderr)
        ours = self.sweep()
        for sweep in (ljmd.open_sweep(self.folder / "cli"), ljmd.open(self.folder / "cli"), ljmd.open(self.folder / "sweep"),
                      pickle.loads(pickle.dumps(ours))):
            np.testing.assert_array_equal(sweep.to_dataframe()["pressure"], ours.to_dataframe()["pressure"])
        self.assertRaises(ljmd.DataError, ljmd.open_sweep, self.folder)
        (self.folder / "cli/sweep.json").write_text("{}")
        self.assertRaises(ljmd.DataError, ljmd.open, self.folder / "cli")

    def test_without_a_directory_files_are_temporary(self):
        sweep = self.sweep({"stage.production.steps": [10, 20]}, directory=None)
        kept = sweep.directory
        self.assertTrue(kept.exists())
        self.assertEqual([point.run.stages[-1]["steps"] for point in sweep], [10, 20])
        self.assertRaises(TypeError, pickle.dumps, sweep)
        del sweep
        self.assertFalse(kept.exists())

    def test_points_may_be_listed_and_have_text(self):
        sweep = self.sweep([{"stage.production.integrator": "leapfrog", "potential.truncation": "shifted"},
                            {"stage.production.integrator": "velocity-verlet", "potential.truncation": "force-shifted"}])
        self.assertEqual(list(sweep.to_dataframe()["stage.production.integrator"]), ["leapfrog", "velocity-verlet"])
        deck = comet(100)
        deck.analysis.orbit(body=1)
        sweep = self.sweep({"body.1.velocity": [[0.0, 1.2], [0.0, 1.1]]}, deck=deck, directory=self.folder / "bodies")
        self.assertIn("total_energy_standard_error", sweep.to_dataframe())
        self.assertEqual(len(sweep.to_dataframe()), 2)
        self.assertIn("orbit_", " ".join(sweep.to_dataframe()))

    def test_it_goes_on_and_is_not_mixed_with_another(self):
        self.sweep()
        log = self.folder / "sweep/points/temperature=1.0,density=0.8"
        shutil.rmtree(log)
        partly = ljmd.open_sweep(self.folder / "sweep")
        self.assertFalse(partly.finished)
        self.assertIn("not begun", repr(partly[1]))
        self.assertTrue(np.isnan(partly.to_dataframe()["pressure"][1]))
        times = {point.name: (point.directory / "results.json").stat().st_mtime_ns for point in partly if point.begun}
        again = self.sweep()
        self.assertTrue(again.finished)
        for point in again:
            if point.name in times:
                self.assertEqual((point.directory / "results.json").stat().st_mtime_ns, times[point.name])
        self.assertRaisesText(ljmd.InputError, "other points", of=lambda: self.sweep({"system.temperature": [2.0, 3.0]}))
        wider = self.sweep({**GRID, "system.density": [0.6, 0.8, 0.7]}, force=True)
        self.assertEqual(len(wider), 6)

    def test_a_point_that_fails_is_a_warning(self):
        deck = small_deck()
        with self.assertWarnsRegex(ljmd.RunWarning, "time_step=0.9"):
            sweep = self.sweep({"stage.production.time_step": [0.004, 0.9]}, deck, force=True)
        self.assertEqual(list(sweep.failures), ["time_step=0.9"])
        self.assertTrue(np.isnan(sweep.to_dataframe()["pressure"][1]))
        self.assertIn("failed", sweep.to_dataframe()["remarks"][1])
        self.assertIn("1 failed", repr(sweep))
        self.assertFalse(sweep.finished)

    def test_mistakes_come_before_anything_is_run(self):
        for text, points in (("sweep of system.densty: unknown key 'densty'", {"system.densty": [1, 2]}),
                             ("temperature", {"system.temperature": [-1.0, 1.0]}), ("a list", {"system.temperature": 1.0}),
                             ("a list", {"system.temperature": "hot"}), ("no points", {}), ("no points", {"system.density": []}),
                             ("same keys", [{"system.density": 1.0}, {"system.temperature": 1.0}]), ("same point", {"system.density": [0.5, 0.5]}),
                             ("table", [1, 2]), ("system.density: a deck cannot hold", {"system.density": [object()]}),
                             ("1000000000 points", {"system.density": range(10**5), "system.temperature": range(10**4)}),
                             ("more than 1000000 members", {"system.density": itertools.count()})):
            self.assertRaisesText(ljmd.InputError, text, of=lambda: self.sweep(points))
        wrong = small_deck()
        wrong.system.sed = 3
        self.assertRaisesText(ljmd.InputError, "Deck:", "unknown key 'sed'", of=lambda: self.sweep(deck=wrong))
        self.assertRaises(ljmd.InputError, self.sweep, jobs=0)
        self.assertRaisesText(ljmd.InputError, "no stages", of=lambda: self.sweep(deck=ljmd.Deck.fluid()))
        paired = small_deck()
        paired.potential = ljmd.pair(lambda r: r**-9, cutoff=2.0, truncation="shifted")
        self.assertRaises(ljmd.InputError, self.sweep, deck=paired)
        self.assertFalse((self.folder / "sweep").exists())

    def test_without_pandas_the_table_is_a_structured_array(self):
        sweep = self.sweep({"stage.production.steps": [10, 20]})
        with mock.patch.dict(sys.modules, pandas=None):
            table = sweep.to_dataframe()
        np.testing.assert_array_equal(table["pressure"], sweep.to_dataframe()["pressure"])

    def test_one_process_sweeps_and_several_are_told_that_they_are(self):
        for variables in ({"OMPI_COMM_WORLD_SIZE": "2"}, {"PMI_SIZE": "2"}, {"PMIX_RANK": "1"},
                          {"PMIX_RANK": "0", "SLURM_STEP_NUM_TASKS": "2"}):
            with mock.patch.dict(os.environ, variables):
                for call in (self.sweep, small_deck().compare, lambda: ljmd.reference(1.0, 0.8)):
                    self.assertRaisesText(ljmd.InputError, "2 processes were started together", of=call)
        for variables in ({"OMPI_COMM_WORLD_SIZE": "1"}, {"PMIX_RANK": "0"}, {"SLURM_STEP_NUM_TASKS": "2"}):
            with mock.patch.dict(os.environ, variables):
                self.assertTrue(self.sweep({"stage.production.steps": [10, 20]}).finished)

    def test_the_name_of_a_directory_need_not_be_a_text(self):
        directory = os.fsencode(self.folder / "sweep") + b"\xff"
        self.assertTrue(self.sweep({"system.temperature": [1.0]}, directory=directory).finished)
        self.assertTrue(os.path.exists(directory + b"/sweep.csv"))

    def test_a_missing_program_is_said(self):
        with mock.patch.dict(os.environ, LJMD_PROGRAM=str(self.folder / "none")):
            self.assertRaisesText(ljmd.InputError, "LJMD_PROGRAM", of=self.sweep)
        fake = self.folder / "ljmd"
        fake.write_text("#!/bin/sh\necho '{\"version\": \"0\"}'\n")
        fake.chmod(0o755)
        with mock.patch.dict(os.environ, LJMD_PROGRAM=str(fake)):
            self.assertRaisesText(ljmd.InputError, "another version", of=self.sweep)


class Interrupted(Case):
    def test_ctrl_c_leaves_checkpoints_from_which_the_sweep_goes_on(self):
        deck = long_deck(atoms=108)
        deck.potential.cutoff = 2.0
        folder = self.folder / "sweep"
        points = {"system.temperature": [1.0, 1.2]}

        def interrupt():
            def rows():
                return [path.stat().st_size for path in folder.glob("points/*/thermo.csv")]

            waiting.until(lambda: len(rows()) == 2 and min(rows()) > 2000, "both points have rows")
            os.kill(os.getpid(), signal.SIGINT)

        thread = threading.Thread(target=interrupt, daemon=True)
        thread.start()
        with self.assertRaises(KeyboardInterrupt) as caught:
            deck.sweep(points, jobs=2, directory=folder, progress=False)
        thread.join()
        if sys.version_info >= (3, 11):
            self.assertIn("the same sweep goes on", " ".join(caught.exception.__notes__))
        sweep = ljmd.open_sweep(folder)
        for point in sweep:
            self.assertTrue((point.directory / "checkpoint.1").exists(), os.listdir(point.directory))
            self.assertIn("not finished", repr(point))
            begun = json.loads(json.dumps(ljmd._core.describe(point.directory)[0]["checkpoint"]))
            self.assertGreater(begun["step"], 0)


if __name__ == "__main__":
    warnings.simplefilter("ignore", ljmd.RunWarning)
    unittest.main(warnings="ignore")
