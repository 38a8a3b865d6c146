"""Ctrl-C and other signals: a run stops after a step, with a checkpoint where it has a directory."""

import signal
import unittest
import warnings

import numpy as np

import ljmd
from alarm import Alarm, a_while
from cases import Case, comet, long_deck


class Interrupts(Case):
    def setUp(self):
        super().setUp()
        self.addCleanup(signal.signal, signal.SIGINT, signal.signal(signal.SIGINT, signal.default_int_handler))

    def test_in_a_directory_the_checkpoint_is_written_and_resuming_gives_the_bits_of_one_run(self):
        deck = long_deck(20000, atoms=256)
        whole = deck.run(self.folder / "whole", progress=False)
        parts = self.folder / "parts"
        with Alarm() as alarm:
            deck.run(parts, progress=alarm.tell)
        if hasattr(BaseException, "add_note"):
            self.assertIn("ljmd.resume", alarm.note)
        run = ljmd.open(parts)
        self.assertFalse(run.finished)
        self.assertLess(len(run.thermo), len(whole.thermo))
        self.assertEqual(dict(run), {})
        again = ljmd.resume(parts, progress=False)
        self.assertTrue(again.finished)
        self.assertEqual(again.stages, whole.stages)
        self.assertEqual(again["pressure"], whole["pressure"])
        self.assertEqual((parts / "thermo.csv").read_bytes(), (self.folder / "whole/thermo.csv").read_bytes())

    def test_in_memory_the_simulation_goes_on_with_the_bits_of_one_run(self):
        deck = long_deck(20000, atoms=256)
        whole = deck.run(progress=False)
        sim = ljmd.Simulation(deck)
        with Alarm() as alarm:
            sim.run(progress=alarm.tell)
        self.assertLess(sim.step, 20000)
        self.assertTrue(np.all(np.isfinite(sim.positions)))
        self.assertEqual(sim.run(progress=False).stages, whole.stages)

    def test_few_bodies_stop_too(self):
        for directory in (None, self.folder / "comet"):
            with Alarm() as alarm:
                comet(10**9).run(directory, progress=alarm.tell)

    def test_a_quick_observable_that_is_interrupted_loses_no_sample(self):
        calls = []

        @ljmd.observable(every=1)
        def slow(s):
            calls.append(s.step)
            a_while()
            return s.velocities[0, 0]

        deck = long_deck(300, atoms=108)
        deck.potential.cutoff = 2.0
        parts = self.folder / "parts"
        with Alarm() as alarm:
            deck.run(parts, observables=[slow], progress=alarm.tell)
        self.assertGreater(ljmd._core.describe(parts)[0]["checkpoint"]["step"], 0)
        whole = deck.run(observables=[slow], progress=False)
        again = ljmd.resume(parts, observables=[slow], progress=False)
        self.assertEqual(again["slow"], whole["slow"])

    def test_an_observable_that_never_returns_is_interrupted(self):
        for directory in (None, self.folder / "endless"):
            with Alarm() as alarm:
                long_deck().run(directory, observables=[alarm.never_returns], progress=False)

    def test_what_a_signal_handler_raises_is_raised(self):
        class TooLate(Exception):
            pass

        def too_late(*_):
            raise TooLate

        self.addCleanup(signal.signal, signal.SIGALRM, signal.signal(signal.SIGALRM, too_late))
        for directory in (None, self.folder / "late"):
            with self.assertRaises(TooLate), Alarm(signal.SIGALRM) as alarm:
                long_deck().run(directory, progress=alarm.tell)
        self.assertGreater(ljmd.open(self.folder / "late").thermo["step"].max(), 0)

    def test_a_handler_that_raises_nothing_lets_the_run_go_on(self):
        seen = []
        signal.signal(signal.SIGINT, lambda *_: seen.append(1))
        with Alarm() as alarm:
            long_deck(20000, atoms=256).run(progress=alarm.tell)
        self.assertEqual(seen, [1])

    def test_progress_is_told_while_the_engine_computes(self):
        for directory in (None, self.folder / "told"):
            told = []
            long_deck(20000, atoms=256).run(directory, progress=told.append)
            self.assertTrue(told)
            self.assertEqual(told, sorted(told))

        def broken(step):
            raise ZeroDivisionError

        self.assertRaises(ZeroDivisionError, long_deck().run, progress=broken)

    def test_wall_time_ends_a_run_with_a_checkpoint(self):
        directory = self.folder / "short"
        self.assertRaisesText(ljmd.Interrupted, "wall time", of=lambda: long_deck().run(directory, walltime=0.3, progress=False))
        self.assertRaises(ljmd.Interrupted, ljmd.resume, directory, walltime="0.2s", progress=False)
        for wrong in (0, -1, "soon", [1]):
            self.assertRaises(ljmd.InputError, ljmd.resume, directory, walltime=wrong)


if __name__ == "__main__":
    warnings.simplefilter("ignore", ljmd.RunWarning)
    unittest.main(warnings="ignore")
