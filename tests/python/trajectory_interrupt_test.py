"""Analyses of trajectories stop at Ctrl-C, and leave the interpreter free while they compute."""

import os
import signal
import threading
import unittest
import warnings

import ljmd
from alarm import Other, is_within, waiting
from cases import Case, long_deck


class Analyses(Case):
    def setUp(self):
        super().setUp()
        self.addCleanup(signal.signal, signal.SIGINT, signal.signal(signal.SIGINT, signal.default_int_handler))
        deck = long_deck(800)
        deck.output.trajectory = dict(every=1, format="xyz")
        self.trajectory = deck.run(self.folder / "run", progress=False).trajectory()

    def test_ctrl_c_ends_an_analysis_and_the_next_one_is_whole(self):
        file = self.folder / "run/trajectory.xyz"
        for work in (lambda: self.trajectory.rdf(bins=100), self.trajectory.arrays, lambda: ljmd.trajectory(file)):
            def send(work=work):
                waiting.until(lambda: is_within(threading.main_thread(), work), "the analysis has begun")
                os.kill(os.getpid(), signal.SIGINT)

            thread = threading.Thread(target=send, daemon=True)
            with self.assertRaises(KeyboardInterrupt):
                thread.start()
                while True:
                    work()
            thread.join()
        self.assertEqual(len(self.trajectory.rdf(bins=100).table()), 100)

    def test_other_threads_go_on_meanwhile(self):
        with Other() as other:
            other.goes_on_during(lambda: self.trajectory.rdf(bins=100))

    def test_two_threads_analyse_one_trajectory(self):
        expected = self.trajectory.rdf(bins=50, every=8).table()["g"].sum()
        found = []
        threads = [threading.Thread(target=lambda: found.append(self.trajectory.rdf(bins=50, every=8).table()["g"].sum()))
                   for _ in range(3)]
        for thread in threads:
            thread.start()
        for thread in threads:
            thread.join()
        self.assertEqual(found, [expected] * 3)


if __name__ == "__main__":
    warnings.simplefilter("ignore", ljmd.RunWarning)
    unittest.main(warnings="ignore")
