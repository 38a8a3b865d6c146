"""Runs that end when an error is reached, and replicas, in Python."""

import unittest

import ljmd
from cases import Case, small_deck


def quick_deck():
    """A gas under friction and noise: hundreds of steps have an error of its temperature."""
    deck = small_deck()
    deck.system.density = 0.05
    deck.output.thermo = {"every": 1}
    deck.stages = [ljmd.Stage("production", until={"temperature": 0.03, "max_steps": 20000}, sample=True, temperature=1.0,
                              thermostat={"type": "langevin", "time": 0.01})]
    return deck


class Until(Case):
    def test_a_stage_takes_steps_or_errors(self):
        self.assertRaisesText(ljmd.InputError, "a number of steps, or `until`", of=lambda: ljmd.Stage("a"))
        self.assertRaisesText(ljmd.InputError, "one of the two", of=lambda: ljmd.Stage("a", 10, until={"pressure": 1, "max_steps": 10}))
        stage = ljmd.Stage("a", until={"pressure": 0.1, "max_steps": 10})
        self.assertEqual(stage.until.max_steps, 10)
        self.assertEqual(eval(repr(stage), {"Stage": ljmd.Stage}), stage)

    def test_a_run_in_memory_ends_like_one_with_a_directory(self):
        run = quick_deck().run(self.folder / "run", progress=False)
        stage = run.stages[-1]
        self.assertTrue(stage["until"]["reached"])
        self.assertLessEqual(run["temperature"].error, 0.03)
        in_memory = quick_deck().run(progress=False)
        self.assertEqual(in_memory["temperature"].mean, run["temperature"].mean)
        self.assertEqual(in_memory.stages[-1]["steps"], stage["steps"])
        simulation = ljmd.Simulation(quick_deck())
        simulation.advance(10**9, progress=False)
        self.assertEqual(simulation.step, stage["steps"])

    def test_mistakes_are_told_with_the_key(self):
        deck = quick_deck()
        deck.stages[0].until = {"presure": 0.1, "max_steps": 10}
        self.assertRaisesText(ljmd.InputError, "unknown key 'presure'", "did you mean 'pressure'?", of=deck.check)


class Replicas(Case):
    def test_replicas_are_merged(self):
        deck = small_deck()
        replicas = deck.run(self.folder / "replicas", replicas=2, jobs=2, progress=False)
        self.assertIsInstance(replicas, ljmd.Replicas)
        means = [run["pressure"].mean for run in replicas.runs]
        self.assertEqual(len(set(means)), 2)
        self.assertAlmostEqual(replicas["pressure"].mean, sum(means) / 2)
        again = ljmd.open(self.folder / "replicas")
        self.assertEqual(again.data, replicas.data)
        self.assertIn("2 replicas", repr(again))
        file = self.folder / "replicas" / "results.json"
        file.write_text("{}")
        self.assertRaisesText(ljmd.DataError, str(file), "'observables' is missing", of=lambda: ljmd.open(self.folder / "replicas"))

    def test_what_replicas_do_not_take_is_refused(self):
        deck = small_deck()
        self.assertRaisesText(ljmd.InputError, "give a directory", of=lambda: deck.run(replicas=2))
        self.assertRaisesText(ljmd.InputError, "processes of their own", of=lambda: deck.run(self.folder / "r", replicas=2, threads=2))
        self.assertRaisesText(ljmd.InputError, "jobs is for replicas", of=lambda: deck.run(jobs=2))
        self.assertRaises(ljmd.DataError, ljmd.Replicas.open, self.folder)


if __name__ == "__main__":
    unittest.main()
