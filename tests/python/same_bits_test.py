"""Every deck of inputs/, made short, has the same bits in Python as on the command line."""

import json
import pathlib
import sys
import unittest

import numpy as np

import ljmd
from cases import Case, INPUTS, ROOT, command_line
from ljmd.reading.tables import read_numbers

sys.path.insert(0, str(ROOT / "tests/cli"))
import decks  # noqa: E402, the settings that make a deck short


def without_times(data: dict) -> dict:
    return {name: value for name, value in data.items() if name != "warnings"}


class SameBits(Case):
    def compare(self, path: pathlib.Path, threads: int):
        text = path.read_text(encoding="utf-8")
        settings = decks.shortened(text)
        changes = {key: json.loads(value) for key, value in (each.split("=", 1) for each in settings[1::2])}
        if "file = " in text:
            start = INPUTS / "examples/canonical.toml"
            name = ljmd.Deck.load(path)["system"]["file"]
            done = command_line("run", start, "--quiet", "--out", self.folder / "start",
                                *decks.shortened(start.read_text(encoding="utf-8")))
            self.assertEqual(done.returncode, 0, done.stderr)
            self.assertTrue(name)
            settings += ["--set", f"system.file={self.folder / 'start'}"]
            changes["system.file"] = str(self.folder / "start")
        there = self.folder / "command-line"
        done = command_line("run", path, "--quiet", "--out", there, "--threads", threads, *settings)
        self.assertEqual(done.returncode, 0, done.stderr)
        expected = json.loads((there / "results.json").read_text(encoding="utf-8"))
        deck = ljmd.Deck.load(path, set=changes)
        runs = [deck.run(threads=threads, progress=False),
                deck.run(self.folder / "python", threads=threads, progress=False)]
        for run in runs:
            self.assertEqual(without_times(run.data), without_times(expected))
            columns, numbers = read_numbers(there / "thermo.csv")
            self.same_table(run.thermo, columns, numbers)
            for table in there.glob("*.csv"):
                if table.name not in ("thermo.csv", "trajectory.csv"):
                    self.same_table(run.table(table.stem), *read_numbers(table))
        trajectory = there / "trajectory.csv"
        if trajectory.exists():
            self.same_table(runs[0].trajectory(), *read_numbers(trajectory))
        for name in ("thermo.csv", "final.xyz"):
            self.assertEqual((there / name).read_bytes(), (self.folder / "python" / name).read_bytes(), name)

    def same_table(self, found, columns, numbers):
        self.assertEqual(list(found.columns), columns)
        for k, column in enumerate(columns):
            np.testing.assert_array_equal(np.asarray(found[column], dtype=float), numbers[:, k], column)


def test_of(path, threads):
    def test(self):
        self.compare(path, threads)
    return test


for _path in sorted(INPUTS.rglob("*.toml")):
    for _threads in (1, 2):
        if _threads == 1 or _path.parent.name != "fewbody":
            setattr(SameBits, f"test_{_path.stem}_{_threads}_threads", test_of(_path, _threads))


if __name__ == "__main__":
    import warnings
    warnings.simplefilter("ignore", ljmd.RunWarning)
    unittest.main(warnings="ignore")
