"""What is read from the files of a run are the numbers that the engine holds in memory, bit for bit."""

import json
import os
import pathlib
import unittest

import numpy as np

import ljmd
from cases import Case, comet, program, small_deck
from ljmd.reading import decks, few_bodies, files, fluids, sweeps, tables, trajectories

os.environ.setdefault("LJMD_PROGRAM", program())


class Readers(Case):
    def same_table(self, read, table):
        self.assertEqual(list(read), list(table.dtype.names if isinstance(table, np.ndarray) else table.columns))
        for name, values in read.items():
            np.testing.assert_array_equal(values, np.asarray(table[name], float), name)

    def test_runs_of_fluids(self):
        for form in ("h5md", "xyz"):
            deck = small_deck()
            deck.analysis.rdf(bins=50, every=10)
            deck.output.trajectory = dict(format=form, every=10, velocities=True)
            in_memory, run = deck.run(progress=False), deck.run(self.folder / form, progress=False)
            read = fluids.load(self.folder / form)
            self.same_table(read.thermo, in_memory.thermo)
            self.assertEqual(list(read.observables), list(in_memory))
            for name, observable in read.observables.items():
                self.assertEqual((observable.unit, observable.samples), (in_memory[name].unit, in_memory[name].samples), name)
                for key in ("mean", "error", "independent_samples"):
                    np.testing.assert_array_equal(getattr(observable, key), getattr(in_memory[name], key), name)
            for name in ("r", "g", "g_standard_error"):
                np.testing.assert_array_equal(run.table("rdf")[name], in_memory.table("rdf")[name], name)
            # The engine has a reader of its own for frames, which all analyses use.
            frames, ours = run.frames(), trajectories.read(self.folder / form)
            for found, expected in ((ours.positions, frames.positions), (ours.velocities, frames.velocities),
                                    (ours.edges, frames.edges), (ours.time, frames.times), (ours.step, frames.steps)):
                np.testing.assert_array_equal(found, expected)

    def test_runs_of_few_bodies(self):
        in_memory = comet(200).run(progress=False)
        comet(200).run(self.folder / "comet", progress=False)
        read = few_bodies.load(self.folder / "comet")
        self.same_table(read.thermo, in_memory.thermo)
        frames = in_memory.trajectory()
        np.testing.assert_array_equal(read.trajectory.positions[:, 0], np.stack([frames["x1"], frames["y1"]], axis=1))
        np.testing.assert_array_equal(read.trajectory.velocities[:, 0], np.stack([frames["vx1"], frames["vy1"]], axis=1))

    def test_sweeps(self):
        sweep = small_deck().sweep({"system.density": [0.6, 0.8]}, directory=self.folder / "sweep", progress=False, jobs=2)
        read = sweeps.load(pathlib.Path(self.folder / "sweep"))
        for name in ("pressure", "temperature"):
            np.testing.assert_array_equal(read.observables[name], [point.run[name].mean for point in sweep])
            np.testing.assert_array_equal(read.observables[f"{name}_standard_error"], [point.run[name].error for point in sweep])
        # Before it has come to its end there is no table: the points say the same.
        (self.folder / "sweep" / "sweep.csv").unlink()
        unfinished = sweeps.load(pathlib.Path(self.folder / "sweep"))
        self.assertEqual(unfinished.keys, read.keys)
        for name in unfinished.observables:
            np.testing.assert_array_equal(unfinished.observables[name], read.observables[name], name)

    def test_what_is_no_file_is_refused_and_not_waited_for(self):
        """Whoever opens a pipe waits for one who fills it."""
        pipe = self.folder / "pipe"
        os.mkfifo(pipe)
        for read in (files.read_json, tables.read_table, trajectories.read_xyz, trajectories.read_h5md):
            with self.subTest(read.__name__), self.assertRaisesRegex(ljmd.DataError, "pipe: is a pipe, not a regular file"):
                read(pipe)

    def test_what_cannot_be_looked_at_is_one_error(self):
        for name, words in (("x" * 300, "cannot be read: File name too long"), ("\ud800", "is no name of a file")):
            for read in (ljmd.open, sweeps.load, files.read_text, trajectories.read, few_bodies.load):
                if read is not ljmd.open or name.isascii():
                    with self.subTest(read.__module__, name=name), self.assertRaisesRegex(ljmd.DataError, words):
                        read(self.folder / name)
        (self.folder / "points").mkdir()
        (self.folder / "sweep.json").write_text(json.dumps({"keys": [], "points": [{"name": "x" * 300, "values": []}]}))
        with self.assertRaisesRegex(ljmd.DataError, "File name too long"):
            sweeps.load(self.folder)

    def test_damaged_files_are_one_error(self):
        """Each was an error of Python, or took all memory."""
        path = self.folder / "file"
        digits, nested = "9" * 5000, "[" * 10**5
        frame = 'Lattice="1 0 0 0 1 0 0 0 1" Properties=species:S:1:pos:R:3 Time=0 step=0\n'
        for text, read, words in ((f'{{"a": {digits}}}', files.read_json, "too many digits"), (f'{{"a": {nested}}}', files.read_json, "too deeply"),
                                  (f"99999999999999999999\n{frame}X 0 0 0\n", trajectories.read_xyz, "number of atoms"),
                                  (f"999999999999\n{frame}X 0 0 0\n", trajectories.read_xyz, "cut off"), (f"-1\n{frame}", trajectories.read_xyz, "number of atoms"),
                                  (f"0\n{frame}", trajectories.read_xyz, "number of atoms"),
                                  ("step,step\n1,2\n", tables.read_table, "column 'step' is there twice"),
                                  (f"a = {digits}\n", lambda path: decks.parse(path, path.read_text()), "no.* valid TOML"),
                                  (f"a = {nested}\n", lambda path: decks.parse(path, path.read_text()), "no.* valid TOML"),
                                  ("a = 1\n", lambda path: decks.parse(path, path.read_text(), [5]), "KEY=VALUE")):
            path.write_text(text)
            with self.subTest(text[:30]), self.assertRaisesRegex(ljmd.DataError, words):
                read(path)
        with self.assertRaisesRegex(ljmd.DataError, "'a' is too large a number"):
            files.field(path, {"a": 10**400}, "a", float)

    def test_damaged_frames_in_hdf5_are_one_error(self):
        import h5py

        deck = small_deck()
        deck.output.trajectory = dict(format="h5md", every=10)
        deck.run(self.folder / "run", progress=False)
        path = self.folder / "run/trajectory.h5md"
        whole = path.read_bytes()
        group = trajectories.H5MD_GROUP
        for name, value in (("position/step", None), ("position/step", 5), ("position", 5), ("position/value", np.zeros((5, 3))), ("box", 5)):
            path.write_bytes(whole)
            with h5py.File(path, "a") as file:
                del file[f"{group}/{name}"]
                if value is None:
                    file.create_group(f"{group}/{name}")
                else:
                    file[f"{group}/{name}"] = value
            with self.subTest(name), self.assertRaises(ljmd.DataError):
                trajectories.read_h5md(path)

    def test_a_record_with_a_damaged_potential_is_one_error(self):
        small_deck().run(self.folder / "run", progress=False)
        record = self.folder / "run/run.json"
        for given in ({"potential": [1]}, {"potential": {"name": 5}}):
            record.write_text(json.dumps({**json.loads(record.read_text()), "given": given}))
            with self.assertRaisesRegex(ljmd.DataError, "run.json: '(potential|name)' is"):
                repr(ljmd.open(self.folder / "run"))


if __name__ == "__main__":
    unittest.main()
