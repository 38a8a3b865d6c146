"""Runs with a directory whose potential or observables are Python's: record, table, resuming, and what else reads them."""

import json
import os
import unittest
import warnings

import numpy as np

import ljmd
from cases import Case, command_line, small_deck

OUTPUTS = ["thermo.csv", "trajectory.xyz", "final.xyz", "rdf.csv", "stress_autocorrelation.csv", "results.json",
           "given-potential.json"]


def soft(r):
    return 4 * (r**-9 - r**-6)


def own_deck(truncation="force-shifted"):
    deck = small_deck()
    deck.potential = ljmd.pair(soft, cutoff=2.0, truncation=truncation, name="9-6",
                               switch_start=1.8 if truncation == "switched" else None)
    deck.output.checkpoint = dict(every=25)
    deck.output.trajectory = dict(format="xyz", every=5, velocities=True)
    deck.analysis.rdf(bins=20, every=5)
    deck.analysis.viscosity(max_time=0.04)
    return deck


@ljmd.observable(every=5, unit="epsilon/k_B", energy=True)
def half_temperature(s):
    return 0.5 * s.temperature


@ljmd.observable(every=4, unit="sigma/tau")
def pressure_of_speeds(s):
    return np.linalg.norm(s.velocities, axis=1).max()


OWN = [half_temperature, pressure_of_speeds]


def fails_at(step):
    """The same observables; the second raises at a step, as a kill would end the run."""
    @ljmd.observable(every=4, unit="sigma/tau", name="pressure_of_speeds")
    def fails(s):
        if s.step >= step:
            raise RuntimeError("enough")
        return pressure_of_speeds(s)

    return [half_temperature, fails]


class InDirectories(Case):
    def outputs(self, directory):
        return {name: (directory / name).read_bytes() for name in OUTPUTS}

    def begun(self, deck=None, step=50, name="run"):
        """The directory of a run that has ended after its checkpoint at step 25."""
        with self.assertRaises(RuntimeError):
            (deck or own_deck()).run(self.folder / name, observables=fails_at(step), progress=False)
        return self.folder / name

    def record(self, directory):
        return json.loads((directory / "run.json").read_text())["given"]


class Potentials(InDirectories):
    def test_a_stopped_run_ends_resumed_as_the_whole_one_without_the_function(self):
        for truncation in ("cut", "shifted", "force-shifted", "switched"):
            with self.subTest(truncation):
                whole = own_deck(truncation).run(self.folder / truncation, observables=OWN, progress=False)
                directory = self.begun(own_deck(truncation), name=f"stopped-{truncation}")
                run = ljmd.resume(directory, observables=OWN, progress=False, threads=2)
                self.assertEqual(self.outputs(directory), self.outputs(self.folder / truncation))
                self.assertEqual(run.data, whole.data)
                memory = own_deck(truncation).run(observables=OWN, progress=False)
                self.assertEqual(memory.data, whole.data)
                self.assertEqual(memory["half_temperature"], whole["half_temperature"])

    def test_the_record_names_it_and_open_shows_it(self):
        deck = own_deck("switched")
        run = deck.run(self.folder / "run", progress=False)
        given = self.record(self.folder / "run")
        self.assertEqual((given["by"], given["observables"]), ("Python", []))
        potential = given["potential"]
        self.assertEqual([potential[key] for key in ("name", "truncation", "cutoff", "switch_start")],
                         ["9-6", "switched", 2.0, 1.8])
        self.assertEqual(potential["table"], {"file": "given-potential.json", "error": deck.potential.error,
                                              "force_error": deck.potential.force_error})
        table = json.loads((self.folder / "run" / "given-potential.json").read_text())
        self.assertEqual((table["format"], table["version"]), ("ljmd pair table", 1))
        self.assertEqual(table["checksum"], potential["checksum"])
        self.assertEqual(len(table["energies"]) % 7, 1)
        again = ljmd.open(self.folder / "run")
        self.assertIn("pair potential '9-6'", repr(again))
        r = np.linspace(0.7, 2.1, 500)
        np.testing.assert_array_equal(again.potential(r), deck.potential(r))
        np.testing.assert_array_equal(again.potential.force(r), deck.potential.force(r))
        self.assertEqual(repr(again.potential), repr(deck.potential))
        deck.potential = again.potential
        self.assertEqual(deck.run(progress=False).stages, run.stages)
        self.assertIn("'9-6', a function of Python", json.loads((self.folder / "run" / "run.json").read_text())["deck"])

    def test_an_earlier_table_goes_with_its_run(self):
        own_deck().run(self.folder / "run", progress=False)
        run = small_deck().run(self.folder / "run", replace=True, progress=False)
        self.assertFalse((self.folder / "run" / "given-potential.json").exists())
        self.assertIsNone(run.potential)
        self.assertIsNone(self.record(self.folder / "run"))

    def test_a_finished_run_is_made_longer(self):
        own_deck().run(self.folder / "run", progress=False)
        longer = ljmd.resume(self.folder / "run", steps=20, progress=False)
        deck = own_deck()
        deck.stages[1].steps = 60
        self.assertEqual(longer.stages, deck.run(progress=False).stages)

    def test_a_damaged_table_is_said_and_not_used(self):
        directory = self.begun()
        path = directory / "given-potential.json"
        text = path.read_text()
        for damage, said in [(text.replace("9-6", "9-7", 1), "it is damaged"), (text[:-300], "parse error"),
                             (text.replace('"version": 1', '"version": 2'), "reads version 1"), (None, "no such file")]:
            path.unlink() if damage is None else path.write_text(damage)
            for refused in (lambda: ljmd.resume(directory, observables=OWN, progress=False),
                            lambda: ljmd.open(directory).potential):
                self.assertRaisesText(ljmd.Error, "the pair potential '9-6' of this run is not known", str(path), said,
                                      of=refused)
            told = command_line("info", directory)
            self.assertEqual(told.returncode, 0, told.stderr)
            self.assertIn("damaged       the pair potential '9-6'", told.stdout)
            self.assertIn("g", ljmd.open(directory).trajectory().rdf(bins=10).table())
            self.assertRaisesText(ljmd.InputError, "needs the interaction", said,
                                  of=lambda: ljmd.open(directory).trajectory().analyze("viscosity"))
        path.write_text(text)
        self.assertTrue(ljmd.resume(directory, observables=OWN, progress=False).finished)

    def test_a_table_of_another_run_is_not_used(self):
        directory = self.begun()
        other = own_deck()
        other.potential = ljmd.pair(lambda r: 1.01 * soft(r), cutoff=2.0, truncation="force-shifted", name="9-6")
        other.run(self.folder / "other", progress=False)
        os.replace(self.folder / "other" / "given-potential.json", directory / "given-potential.json")
        self.assertRaisesText(ljmd.CheckpointError, "it is another one",
                              of=lambda: ljmd.resume(directory, observables=OWN, progress=False))
        record = json.loads((directory / "run.json").read_text())
        record["given"]["potential"] = self.record(self.folder / "other")["potential"]
        (directory / "run.json").write_text(json.dumps(record))
        self.assertRaisesText(ljmd.CheckpointError, "belongs to another deck",
                              of=lambda: ljmd.resume(directory, observables=OWN, progress=False))

    def test_analyses_of_its_trajectory_use_it(self):
        deck = own_deck()
        deck.output.trajectory = dict(every=1, velocities=True)
        deck.stages = [ljmd.Stage("production", 60, sample=True)]
        run = deck.run(self.folder / "run", progress=False)
        of_run = run.table("stress_autocorrelation")
        of_frames = run.trajectory().analyze("viscosity").table("stress_autocorrelation")
        np.testing.assert_allclose(of_frames["stress_autocorrelation"].iloc[0],
                                   of_run["stress_autocorrelation"].iloc[0], rtol=0.05)

    def test_the_command_line_does_what_it_can_without_it(self):
        directory = self.begun()
        said = command_line("resume", directory)
        self.assertEqual((said.returncode, said.stdout), (6, ""))
        for words in ("was run with the pair potential '9-6' and the observables 'half_temperature' (every 5 steps, with "
                      "energy, epsilon/k_B), 'pressure_of_speeds'", "of a program in Python",
                      f'to go on: ljmd.resume("{directory}", observables=[half_temperature, pressure_of_speeds]) in Python'):
            self.assertIn(words, said.stderr)
        told = command_line("info", directory)
        self.assertIn("run with      the pair potential '9-6'", told.stdout)
        self.assertIn("to go on: ljmd.resume(", told.stdout)
        self.assertEqual(json.loads(command_line("info", directory, "--json").stdout)["given"], self.record(directory))
        ljmd.resume(directory, observables=OWN, progress=False)
        self.assertEqual(command_line("analyze", directory, "rdf").returncode, 0)
        self.assertEqual(command_line("export", directory, "--to", "extxyz", "--out", self.folder / "x").returncode, 0)
        for target in ("lammps", *(["openmm"] if "openmm" in command_line("export", "--help").stdout else [])):
            refused = command_line("export", directory, "--to", target, "--out", self.folder / "y")
            self.assertEqual(refused.returncode, 2, refused.stderr)
            self.assertIn("'9-6' is a formula of the program that made the run", refused.stderr)

    def test_what_does_not_go_with_it_is_refused_before_anything_is_written(self):
        mixed = own_deck()
        mixed.performance.precision = "mixed"
        tail = own_deck("cut")
        tail["potential"]["tail"] = True
        for deck, text in [(mixed, "computed in double precision"), (tail, "was changed")]:
            for run in (deck.check, deck.run, lambda deck=deck: deck.run(self.folder / "run")):
                self.assertRaisesText(ljmd.InputError, text, of=run)
        self.assertFalse((self.folder / "run").exists())

    def test_a_deck_gives_no_remark_on_the_potential_that_stands_in_for_it(self):
        deck = small_deck(density=1.1)
        self.assertIn("freezes", repr(deck.check()))
        deck.potential = ljmd.pair(soft, cutoff=2.0, truncation="shifted")
        self.assertNotIn("freezes", repr(deck.check()))


class Observables(InDirectories):
    def test_their_results_are_in_the_files_as_in_memory(self):
        deck = small_deck()
        memory = deck.run(observables=OWN, progress=False)
        run = deck.run(self.folder / "run", observables=OWN, progress=False)
        self.assertEqual(run.data, memory.data)
        again = ljmd.open(self.folder / "run")
        self.assertEqual(again["half_temperature"], memory["half_temperature"])
        self.assertTrue(again["half_temperature"].own)
        self.assertFalse(again["pressure"].own)
        self.assertIn("pressure_of_speeds", repr(again))
        text = (self.folder / "run" / "results.txt").read_text()
        self.assertRegex(text, r"(?m)^  pressure_of_speeds +own +\d")
        self.assertIn("own: measured by the program", text)
        self.assertEqual(self.record(self.folder / "run")["observables"],
                         [{"name": "half_temperature", "unit": "epsilon/k_B", "every": 5, "energy": True},
                          {"name": "pressure_of_speeds", "unit": "sigma/tau", "every": 4, "energy": False}])

    def test_units_of_a_substance(self):
        run = small_deck(substance=ljmd.ARGON).run(self.folder / "run", observables=OWN, progress=False)
        self.assertEqual(run["half_temperature"].si.unit, "K")

    def test_other_ones_are_refused_by_name(self):
        directory = self.begun(small_deck())
        every = ljmd.observable(half_temperature.function, every=6, energy=True, unit="epsilon/k_B", name="half_temperature")
        for wrong, given in [([], "no observables"), ([half_temperature], "the observable 'half_temperature'"),
                             (OWN[::-1], "the observables 'pressure_of_speeds'"),
                             ([every, pressure_of_speeds], "the observables 'half_temperature' (every 6 steps")]:
            self.assertRaisesText(ljmd.CheckpointError, "was begun with the observables 'half_temperature' (every 5 steps",
                                  f"given: {given}", "observables=[half_temperature, pressure_of_speeds]",
                                  of=lambda wrong=wrong: ljmd.resume(directory, observables=wrong, progress=False))
        small_deck().run(self.folder / "plain", progress=False)
        self.assertRaisesText(ljmd.CheckpointError, "was begun with no observables; given: the observables",
                              of=lambda: ljmd.resume(self.folder / "plain", observables=OWN, progress=False))

    def test_the_process_that_began_a_run_need_not_give_them_again(self):
        whole = small_deck().run(self.folder / "whole", observables=OWN, progress=False)
        longer = ljmd.resume(self.folder / "whole", steps=10, progress=False)
        deck = small_deck()
        deck.stages[-1].steps += 10
        self.assertEqual(longer.data, deck.run(self.folder / "longer", observables=OWN, progress=False).data)
        directory = self.begun(small_deck())  # and where a function of the user's raised
        self.assertRaisesText(RuntimeError, "enough", of=lambda: ljmd.resume(directory, progress=False))
        self.assertEqual(ljmd.resume(directory, observables=OWN, progress=False)["half_temperature"], whole["half_temperature"])
        self.assertEqual(ljmd.resume(directory, steps=10, progress=False).data, longer.data)  # as it was given last

    def test_only_those_of_the_run_in_the_directory_are_known(self):
        run = self.folder / "run"
        small_deck().run(run, observables=OWN, progress=False)
        self.assertRaises(ljmd.Error, small_deck().run, run, observables=[half_temperature], progress=False)  # it is there
        self.assertTrue(ljmd.resume(run, steps=1, progress=False).finished)
        small_deck().run(run, replace=True, progress=False)
        self.assertTrue(ljmd.resume(run, steps=1, progress=False).finished)
        small_deck().run(self.folder / "other", observables=OWN, progress=False)
        record = self.folder / "other" / "run.json"
        record.with_name("new").write_text(record.read_text())  # as another process writes it
        record.with_name("new").replace(record)
        self.assertRaisesText(ljmd.CheckpointError, "given: no observables",
                              of=lambda: ljmd.resume(self.folder / "other", steps=1, progress=False))

    def test_names_of_built_in_ones_are_refused(self):
        for name in ("pressure", "pressure_xy", "virial", "diffusion", "viscosity", "coordination_number"):
            own = ljmd.observable(lambda s: 1.0, name=name)
            self.assertRaisesText(ljmd.InputError, "built-in", of=lambda own=own: small_deck().run(observables=[own]))


if __name__ == "__main__":
    warnings.simplefilter("ignore", ljmd.RunWarning)
    unittest.main(warnings="ignore")
