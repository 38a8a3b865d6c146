"""Everything that the package returns can be copied, pickled and shown; what cannot says why."""

import copy
import pickle
import unittest
import warnings

import numpy as np

import ljmd
from cases import Case, comet, small_deck


class Copies(Case):
    def things(self):
        deck = small_deck(substance=ljmd.ARGON)
        deck.output.trajectory = dict(every=10, velocities=True)
        deck.analysis.rdf(bins=30, every=10)
        kept = deck.run(progress=False)
        written = deck.run(self.folder / "run", progress=False)
        few = comet(50)
        few.analysis.orbit(body=1)
        bodies = few.run(progress=False)
        trajectory = written.trajectory()
        return {"deck": deck, "stage": deck.stages[0], "table": deck.system, "analyses": deck.analysis, "check": deck.check(),
                "run in memory": kept, "run in a directory": written, "few bodies": bodies, "findings": bodies.findings,
                "observable": kept["pressure"], "quantity": kept["pressure"].si, "frames": kept.frames(),
                "trajectory of a run": trajectory, "found": trajectory.rdf(bins=20),
                "trajectory of a file": ljmd.trajectory(self.folder / "run/trajectory.h5md", deck=deck),
                "state": ljmd.eos(1.5, 0.5), "coexistence": ljmd.eos(0.9), "equation": ljmd.equations()[0],
                "pair": ljmd.pair(lambda r: r**-9, cutoff=2.0, truncation="shifted"),
                "evaluation": ljmd.evaluate([[0, 0, 0], [1, 0, 0]], 6), "evaluator": ljmd.Evaluator(),
                "measurement": ljmd.observable(np.mean), "error": ljmd.InputError("wrong")}

    def test_copies_and_pickles_show_the_same(self):
        for name, thing in self.things().items():
            shown = repr(thing)
            self.assertNotIn("object at 0x", shown, name)
            for twin in (copy.copy(thing), copy.deepcopy(thing), pickle.loads(pickle.dumps(thing))):
                self.assertEqual(repr(twin), shown, name)
                self.assertIs(type(twin), type(thing), name)

    def test_tables_and_numbers_survive(self):
        things = self.things()
        for name in ("run in memory", "run in a directory", "found"):
            twin = pickle.loads(pickle.dumps(things[name]))
            np.testing.assert_array_equal(twin.table("rdf")["g"], things[name].table("rdf")["g"])
        twin = pickle.loads(pickle.dumps(things["trajectory of a run"]))
        np.testing.assert_array_equal(twin.rdf(bins=20).table()["g"], things["found"].table()["g"])

    def test_a_simulation_says_how_it_is_continued_elsewhere(self):
        sim = ljmd.Simulation(small_deck())
        for wrong in (copy.copy, copy.deepcopy, pickle.dumps):
            self.assertRaisesText(TypeError, "checkpoint()", of=lambda: wrong(sim))


if __name__ == "__main__":
    warnings.simplefilter("ignore", ljmd.RunWarning)
    unittest.main(warnings="ignore")
