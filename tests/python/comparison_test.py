"""Comparisons with independent programs."""

import json
import os
import pathlib
import pickle
import shlex
import signal
import subprocess
import sys
import threading
import unittest
import warnings
from unittest import mock

import numpy as np

import ljmd
from alarm import is_within, waiting
from cases import Case, comet, command_line, long_deck, program, small_deck

os.environ.setdefault("LJMD_PROGRAM", program())
HAS_OPENMM = bool(json.loads(command_line("info", "--json").stdout).get("openmm"))


class Comparisons(Case):
    @unittest.skipUnless(HAS_OPENMM, "built without OpenMM")
    def test_a_fluid_agrees_with_openmm(self):
        deck = small_deck()
        deck.stages[1].steps = 200
        found = deck.compare("openmm", steps=20, frames=[1, 20], parts=["point", "trajectory", "averages"],
                             directory=self.folder / "found")
        self.assertTrue(found.passed, found)
        self.assertEqual(found.failures, [])
        checks = found.checks
        self.assertIn("potential energy", list(checks["name"]))
        self.assertIn("step 20: kinetic energy", list(checks["name"]))
        self.assertTrue((checks["value"] <= checks["tolerance"]).all() and checks["passed"].all())
        self.assertEqual(found.tables, ["trajectory", "rdf"])
        self.assertEqual(list(found.table("trajectory")["step"])[-1], 20)
        self.assertGreater(found.table("rdf")["g_peer"].max(), 1)
        averages = found.averages
        self.assertIn("temperature", list(averages["name"]))
        np.testing.assert_allclose(averages["ljmd"], averages["peer"], rtol=0.1)
        self.assertIn("checks passed", repr(found))
        self.assertIn("<table>", found._repr_html_())
        self.assertTrue((self.folder / "found/compare-openmm.json").exists())
        self.assertRaises(KeyError, found.table, "rdff")
        self.assertRaises(ljmd.InputError, bool, found)
        self.assertEqual(pickle.loads(pickle.dumps(found)).data, found.data)
        self.assertRaisesText(ljmd.InputError, "compare-openmm.json", of=lambda: deck.compare(directory=self.folder / "found"))

    def test_an_engine_is_judged_by_its_files_and_by_a_command(self):
        deck, place = small_deck(), self.folder / "mine"
        handed = deck.compare(f"files:{place}", steps=20)
        self.assertFalse(handed.passed)
        self.assertIn("nothing was judged", repr(handed))
        engine = pathlib.Path(__file__).resolve().parents[2] / "docs/examples/engine.py"
        subprocess.run([sys.executable, engine, place, place], check=True)
        found = deck.compare(f"files:{place}", steps=20)
        self.assertTrue(found.passed, found)
        self.assertIn("step 10: positions", list(found.checks["name"]))
        wrong_engine = self.folder / "it's wrong.py"
        wrong_engine.write_text(engine.read_text(encoding="utf-8").replace("    d -= edges * np.round(d / edges)\n", ""), encoding="utf-8")
        wrong = deck.compare(f"command:'{sys.executable}' {shlex.quote(str(wrong_engine))} {{input}} {{output}}", steps=20, timeout="5min")
        self.assertFalse(wrong.passed)
        self.assertIn("virial", wrong.failures)
        self.assertIn("missing image", wrong.diagnoses[0])
        self.assertIn("diagnosis: missing image", repr(wrong))
        self.assertRaisesText(ljmd.InputError, "{output} is missing", of=lambda: deck.compare("command:./engine {input}"))
        cut = "command:echo '{' > {output}/point.json; : {input}"
        with self.assertRaises(ljmd.DataError) as raised:
            deck.compare(cut)
        self.assertIn("{output}/point.json is not a point", str(raised.exception))
        self.assertNotIn("ljmd-", str(raised.exception))
        with self.assertRaises(ljmd.DataError) as raised:
            deck.compare(cut, directory=self.folder / "cut")
        self.assertIn(str(self.folder / "cut/exchange/answer/point.json"), str(raised.exception))

    def test_a_check_that_fails_is_no_exception(self):
        told = {"deck": "deck.toml", "with": "openmm", "peer": "OpenMM 0", "passed": False,
                "checks": [{"name": "pressure", "value": 1e-3, "tolerance": 1e-12, "passed": False},
                           {"name": "g(r)", "value": None, "tolerance": 1.0, "passed": False},
                           {"name": "potential energy", "value": 0.0, "tolerance": 1e-13, "passed": True}]}
        fake = self.folder / "ljmd"
        fake.write_text("#!/bin/sh\ncat <<'END'\n" + json.dumps(told) + "\nEND\necho 'warning: the moon is full' >&2\n"
                        "echo 'error: ljmd and OpenMM 0 differ: 2 of 3 checks failed' >&2\nexit 5\n", encoding="utf-8")
        fake.chmod(0o755)
        with mock.patch.object(ljmd._program, "program", lambda: str(fake)), self.assertWarnsRegex(ljmd.RunWarning, "moon"):
            found = small_deck().compare()
        self.assertFalse(found.passed)
        self.assertEqual(found.failures, ["pressure", "g(r)"])
        self.assertIn("2 of 3 checks FAILED", repr(found))
        self.assertTrue(np.isnan(found.checks["value"][1]))
        for code, error in ((3, ljmd.DataError), (5, ljmd.PhysicsError), (7, ljmd.ThreadsError), (1, ljmd.InternalError)):
            fake.write_text(f"#!/bin/sh\necho 'error: no luck' >&2\nexit {code}\n", encoding="utf-8")
            with mock.patch.object(ljmd._program, "program", lambda: str(fake)):
                self.assertRaisesText(error, "no luck", of=small_deck().compare)
        fake.write_text("#!/bin/sh\nkill -9 $$\n", encoding="utf-8")
        with mock.patch.object(ljmd._program, "program", lambda: str(fake)):
            self.assertRaisesText(ljmd.Error, "signal 9", of=small_deck().compare)

    @unittest.skipIf(HAS_OPENMM, "built with OpenMM")
    def test_without_openmm_it_is_said(self):
        self.assertRaisesText(ljmd.InputError, "built without OpenMM", of=small_deck().compare)

    def test_few_bodies_are_compared_with_the_adaptive_solution(self):
        found = comet(200).compare()
        self.assertTrue(found.passed)
        self.assertEqual(found.tables, ["errors"])
        errors = found.table("errors")
        self.assertEqual(len(errors), 201)
        self.assertAlmostEqual(errors["position_error"].max(), found.data["largest_position_error"], 15)
        self.assertIn("largest_energy_error", repr(found))
        self.assertIsNone(found.directory)

    def test_wrong_input_is_one_clear_message(self):
        deck = small_deck()
        for text, options in (("unknown program", dict(program="gromacs")), ("gsl", dict(program="gsl")),
                              ("parts", dict(program="openmm", parts="everything")), ("frames", dict(program="openmm", frames=[0.5])),
                              ("steps", dict(program="openmm", steps=-1)), ("platform", dict(program="lammps", platform="CPU"))):
            self.assertRaisesText(ljmd.InputError, text, of=lambda: deck.compare(**options))
        deck.system.sed = 1
        self.assertRaisesText(ljmd.InputError, "Deck:", "unknown key 'sed'", of=lambda: deck.compare("openmm"))
        self.assertRaisesText(ljmd.InputError, "few-body", of=lambda: comet().compare("openmm"))

    @unittest.skipUnless(HAS_OPENMM, "built without OpenMM")
    def test_ctrl_c_ends_it_at_once(self):
        deck = long_deck(100)

        def interrupt():
            waiting.until(lambda: is_within(threading.main_thread(), ljmd.Deck.compare), "the comparison has begun")
            os.kill(os.getpid(), signal.SIGINT)

        thread = threading.Thread(target=interrupt, daemon=True)
        with self.assertRaises(KeyboardInterrupt):
            thread.start()
            deck.compare("openmm", steps=10**9, parts="trajectory")
        thread.join()


if __name__ == "__main__":
    warnings.simplefilter("ignore", ljmd.RunWarning)
    unittest.main(warnings="ignore")
