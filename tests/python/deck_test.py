"""Decks: the same reader and the same messages as on the command line, also for what was made in Python."""

import copy
import pickle
import unittest
import warnings

import numpy as np

import ljmd
from cases import Case, INPUTS, ROOT, comet, command_line, small_deck


class Decks(Case):
    def test_mistakes_have_the_text_of_the_command_line_with_their_places(self):
        text = (INPUTS / "verlet1967/argon-864.toml").read_text(encoding="utf-8")
        for wrong in (text.replace("density", "densty"), text.replace('"cut"', '"cud"').replace("skin = 0.3", "skin = 30"),
                      text.replace("steps = 6000", "steps = -1"), text.replace("[neighbors]", "[neighbors"), "", "a = \x00"):
            path = self.folder / "wrong.toml"
            path.write_text(wrong, encoding="utf-8")
            said = command_line("check", path).stderr
            self.assertTrue(said)
            with self.assertRaises(ljmd.InputError) as caught:
                ljmd.Deck.load(path).check()
            self.assertEqual(said.strip(), str(caught.exception).strip())

    def test_all_mistakes_are_told_at_once(self):
        deck = small_deck()
        deck.system.densty = 0.7
        deck.potential.cutoff = -1
        deck.stages[1].thermostat = "langvin"
        self.assertRaisesText(ljmd.InputError, "unknown key 'densty'", "did you mean 'density'?", "'cutoff'", "langvin",
                              "3 errors", of=deck.check)
        self.assertRaises(ValueError, deck.run)

    def test_a_deck_without_stages_is_told_how_to_get_some(self):
        self.assertRaisesText(ljmd.InputError, "deck.stages = [", of=ljmd.Deck.fluid().run)
        self.assertRaises(ljmd.InputError, ljmd.Deck().check)

    def test_the_defaults_are_those_of_a_specification_in_cpp_and_of_a_deck(self):
        known = ljmd.build()["defaults"]
        fluid = ljmd.Deck.fluid()
        lattice = known["system"].pop("lattice")
        self.assertEqual({**fluid.system.pop("lattice")}, {"type": lattice["type"], "atoms": 4 * lattice["cells"]**3})
        self.assertEqual(({**fluid.system}, {**fluid.potential}), (known["system"], known["potential"]))
        # What the keywords of Deck.fluid and Stage leave out has its default in the deck, and so in C++.
        stage = {**ljmd.Stage("production", known["stage"][0]["steps"])}
        self.assertEqual(stage, {key: known["stage"][0][key] for key in stage})
        fluid = ljmd.Deck.fluid()
        fluid.stages = [ljmd.Stage("production", 0)]
        every = ljmd.Deck({**ljmd.build()["defaults"], "title": "all defaults are said"})
        few, all_of_them = ljmd.Simulation(fluid), ljmd.Simulation(every)
        self.assertTrue(np.array_equal(few.positions, all_of_them.positions) and np.array_equal(few.velocities, all_of_them.velocities))
        few.restore(all_of_them.checkpoint())  # which is refused for another specification

    def test_a_missing_file_is_an_input_error(self):
        self.assertRaisesText(ljmd.InputError, "nowhere.toml", of=lambda: ljmd.Deck.load("nowhere.toml"))

    def test_settings_are_those_of_the_command_line(self):
        path = INPUTS / "examples/force-shifted-256.toml"
        deck = ljmd.Deck.load(path, set={"stage.production.steps": 11, "system.density": np.float64(0.7)})
        self.assertEqual(deck.stages[-1].steps, 11)
        self.assertEqual(deck.system.density, 0.7)
        self.assertRaisesText(ljmd.InputError, "--set system.densty=0.7: unknown key 'densty'",
                              of=ljmd.Deck.load(path, set={"system.densty": 0.7}).check)
        deck.set("stage.production.steps", 12)
        self.assertEqual(deck.stages[-1].steps, 12)
        self.assertEqual(deck.check().data["steps"], sum(stage.steps for stage in deck.stages))

    def test_a_deck_that_was_only_looked_at_keeps_its_text(self):
        path = INPUTS / "examples/morse.toml"
        deck = ljmd.Deck.load(path)
        self.assertTrue(repr(deck) and deck._repr_html_() and deck.neighbors is not None and deck.analysis is not None)
        self.assertEqual(deck.text, path.read_text(encoding="utf-8"))

    def test_what_is_written_is_what_was_read(self):
        for path in sorted(INPUTS.rglob("*.toml")):
            deck = ljmd.Deck.load(path)
            deck.title = deck.title + " "
            again = ljmd.Deck.parse(deck.text)
            self.assertEqual(again._tables, deck._tables, path)

    def test_tables_are_dicts_with_attributes(self):
        deck = small_deck()
        deck.system.density = 0.75
        deck.neighbors.skin = 0.4
        deck.analysis.rdf(bins=50)
        deck.output = {"thermo": {"every": 5}}
        self.assertEqual(deck["system"]["density"], 0.75)
        text = str(deck)
        for line in ("density = 0.75", "skin = 0.4", "rdf = { bins = 50 }", "thermo = { every = 5 }",
                     'thermostat = { type = "rescale", every = 5 }'):
            self.assertIn(line, text)
        del deck.analysis["rdf"]
        del deck.neighbors.skin
        self.assertNotIn("rdf", str(deck))
        with self.assertRaises(AttributeError):
            deck.temprature = 1.0
        with self.assertRaises(AttributeError):
            print(deck.system.seeed)
        deck.analysis.rdff()
        self.assertRaisesText(ljmd.InputError, "rdff", "did you mean 'rdf'?", of=deck.check)

    def test_text_and_numbers_of_all_kinds_are_written(self):
        deck = small_deck(title='A "quoted" \\ title: α, tab\t')
        deck.system.seed = np.int64(12)
        deck.system.density = np.float32(0.5)
        again = ljmd.Deck.parse(str(deck))
        self.assertEqual(again.title, deck.title)
        self.assertEqual((again.system.seed, again.system.density), (12, 0.5))
        deck.system.seed = object()
        self.assertRaisesText(ljmd.InputError, "cannot hold", of=deck.check)

    def test_copies_are_independent_and_pickles_equal(self):
        deck = small_deck()
        for twin in (deck.copy(), copy.copy(deck), copy.deepcopy(deck), pickle.loads(pickle.dumps(deck))):
            self.assertEqual(twin, deck)
            twin.system.density = 0.1
            twin.stages[0].steps = 1
            self.assertNotEqual(twin, deck)
        self.assertEqual(deck.stages[0].steps, 20)

    def test_a_saved_deck_runs_on_the_command_line(self):
        path = self.folder / "small.toml"
        small_deck().save(path)
        self.assertEqual(command_line("check", path).returncode, 0)
        self.assertEqual(ljmd.Deck.load(path), small_deck())

    def test_a_check_tells_cost_and_warnings(self):
        check = small_deck().check(threads=2)
        self.assertEqual((check.data["atoms"], check.data["steps"]), (108, 60))
        self.assertIn("with 2 threads", repr(check))
        self.assertIn("the deck is good", check._repr_html_())
        deck = small_deck()
        deck.stages[0].temperature = 60.0
        self.assertRaisesText(ljmd.InputError, "temperature", of=deck.check)
        self.assertTrue(deck.check(force=True).warnings)

    def test_few_bodies(self):
        self.assertEqual(comet().check().data["bodies"], 1)
        self.assertIn("1 body, newtonian-gravity", repr(comet()))
        deck = comet()
        deck.bodies[0].position = [1.0]
        self.assertRaises(ljmd.InputError, deck.check)

    def test_stages_show_what_they_are(self):
        stage = ljmd.Stage("melt", 2000, temperature=1.5, thermostat="rescale")
        self.assertEqual(eval(repr(stage), {"Stage": ljmd.Stage}), stage)
        self.assertEqual(small_deck().stages[1].sample, True)
        deck = small_deck()
        with self.assertRaises(ljmd.InputError):
            deck.stages = ["melt"]


if __name__ == "__main__":
    warnings.simplefilter("ignore", ljmd.RunWarning)
    unittest.main(warnings="ignore")
