"""Reference values in Python are those of the command."""

import json
import subprocess
import unittest

import ljmd
from cases import Case

QUICK = dict(atoms=108, replicas=2, errors={"energy": 0.02})


class ReferenceValues(Case):
    def test_values_are_those_of_the_command(self):
        said = []
        found = ljmd.reference(2.0, 0.5, **QUICK, properties=["g", "c_v"], max_steps=10000, directory=self.folder / "runs", progress=said.append)
        self.assertIsInstance(found, ljmd.Reference)
        self.assertEqual(found.data, json.loads((self.folder / "runs" / "results.json").read_text()))
        energy = found["potential_energy"]
        self.assertEqual((energy.mean, energy.total_error), (found.data["potential_energy"]["mean"], found.data["potential_energy"]["total_error"]))
        self.assertLessEqual(energy.statistical_error, 0.02)
        self.assertEqual(energy.equation_of_state, ljmd.eos(2.0, 0.5).potential_energy)
        self.assertEqual(found.phase, "supercritical fluid")
        self.assertIn("pilot: 2 runs of 4000 steps", said)
        self.assertEqual(list(found.keys()), ["potential_energy", "pressure", "compressibility_factor", "heat_capacity_cv"])
        self.assertEqual((list(found), len(found)), (list(found.keys()), 4))
        self.assertTrue("pressure" in found and "volume" not in found)
        self.assertEqual(list(found.values["name"]), list(found.keys()))
        self.assertEqual(found.tables, ["rdf"])
        self.assertAlmostEqual(float(list(found.table("rdf")["g"])[-1]), 1.0, delta=0.2)
        for text in (repr(found), found._repr_html_()):
            self.assertIn("potential_energy", text)
        again = ljmd.open(self.folder / "runs")
        self.assertEqual((repr(again), again.tables, again.directory), (repr(found), found.tables, found.directory))
        (self.folder / "runs" / "results.json").rename(self.folder / "aside")
        self.assertRaisesText(ljmd.DataError, "have not been found yet", of=lambda: ljmd.open(self.folder / "runs"))
        # the command goes on with what is there, and finds the same
        command = [ljmd._program.program(), "reference", "--temperature", "2", "--density", "0.5", "--atoms", "108", "--replicas", "2", "--error",
                   "energy=0.02", "--properties", "g,c_v", "--max-steps", "10000", "--out", self.folder / "runs", "--json", "--quiet"]
        self.assertEqual(json.loads(subprocess.run(command, check=True, capture_output=True).stdout), found.data)
        self.damaged(self.folder / "runs" / "results.json")

    def damaged(self, file):
        """Each damage of the results is said, with their file."""
        whole = json.loads(file.read_text())

        def read():
            repr(ljmd.open(file.parent))

        read()
        file.write_text("{}")
        self.assertRaisesText(ljmd.DataError, str(file), "'phase' is missing", of=read)
        for key in ("phase", "warnings", "citation", "temperature", "density"):
            file.write_text(json.dumps({name: value for name, value in whole.items() if name != key}))
            self.assertRaisesText(ljmd.DataError, str(file), f"'{key}' is missing", of=read)
        for key in ("mean", "unit", "total_error"):
            file.write_text(json.dumps({**whole, "pressure": {**whole["pressure"], key: []}}))
            self.assertRaisesText(ljmd.DataError, str(file), f"'{key}' is []", of=read)

    def test_mistakes_and_refusals(self):
        self.assertRaisesText(ljmd.PhysicsError, "separates into vapour and liquid", of=lambda: ljmd.reference(1.0, 0.3))
        self.assertRaisesText(ljmd.InputError, "a density or a pressure", of=lambda: ljmd.reference(1.0))
        self.assertRaisesText(ljmd.InputError, "unknown property 'entropy'", of=lambda: ljmd.reference(1.0, 0.8, properties="entropy"))
        self.assertRaisesText(ljmd.InputError, "cannot be called", of=lambda: ljmd.reference(1.0, 0.8, progress=True))


if __name__ == "__main__":
    unittest.main()
