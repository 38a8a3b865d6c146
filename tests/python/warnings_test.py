"""Warnings point at the line of the user's that has called the package, from every place that warns."""

import ast
import json
import linecache
import pathlib
import unittest
import warnings
from unittest import mock

import ljmd
from cases import Case, small_deck

try:
    from ase.build import bulk
    import ljmd.ase
except ImportError:
    bulk = None

PACKAGE = pathlib.Path(ljmd.__file__).parent
WARNS = ("_check.warn", "_program.warned")


def hasty() -> ljmd.Deck:
    """A deck with a time step that is remarked on."""
    deck = small_deck()
    deck.stages = [ljmd.Stage("production", 40, time_step=0.03, sample=True)]
    return deck


def nearer_than_the_table() -> tuple:
    """Atoms, a box and a potential whose table begins beyond their distance."""
    return [[1, 1, 1], [1.85, 1, 1], [4, 4, 4]], 8.0, ljmd.pair(lambda r: 4 * (r**-12 - r**-6), cutoff=2.5, truncation="shifted", start=0.9)


class Warned(Case):
    """Each test is named after the function that warns; `# here` marks the line of the user's."""

    def points_here(self, call) -> None:
        with warnings.catch_warnings(record=True) as found:
            warnings.simplefilter("always")
            call()
        found = [each for each in found if issubclass(each.category, ljmd.RunWarning)]
        self.assertTrue(found)
        for each in found:
            self.assertEqual(each.filename, __file__, each.message)
            self.assertIn("# here", linecache.getline(each.filename, each.lineno), each.message)

    def program_that_says(self, text: str, code: int = 0):
        """Instead of the program `ljmd`."""
        fake = self.folder / "ljmd"
        fake.write_text(f"#!/bin/sh\ncat <<'END'\n{text}\nEND\necho 'warning: the moon is full' >&2\nexit {code}\n", encoding="utf-8")
        fake.chmod(0o755)
        return mock.patch.object(ljmd._program, "program", lambda: str(fake))

    def test_evaluation_Evaluator___call__(self):
        positions, edges, potential = nearer_than_the_table()
        self.points_here(lambda: ljmd.evaluate(positions, edges, potential=potential))  # here
        self.points_here(lambda: ljmd.Evaluator(potential)(positions, edges))  # here

    @unittest.skipUnless(bulk, "there is no ASE")
    def test_evaluation_by_ASE(self):
        atoms = bulk("Ar", "fcc", a=1.0, cubic=True).repeat(6)
        atoms.calc = ljmd.ase.Calculator(potential=nearer_than_the_table()[2])
        self.points_here(lambda: atoms.get_potential_energy())  # here

    def test_simulation_Simulation___init__(self):
        self.points_here(lambda: ljmd.Simulation(hasty(), force=True))  # here

    def test_simulation_Simulation_run(self):
        sim = ljmd.Simulation(small_deck())
        with mock.patch.object(ljmd.Run, "warnings", ["the moon is full"]):
            self.points_here(lambda: sim.run(progress=False))  # here
            self.points_here(lambda: small_deck().run(progress=False))  # here

    def test_runs_Run_in_directory(self):
        self.points_here(lambda: hasty().run(self.folder / "run", progress=False, force=True))  # here

    def test_opening_resume(self):
        hasty().run(self.folder / "run", progress=False, force=True)
        self.points_here(lambda: ljmd.resume(self.folder / "run", steps=10, progress=False))  # here

    def test_runs_Run_report(self):
        run = small_deck().run(self.folder / "run", progress=False)
        with mock.patch.object(ljmd._core, "write_report", mock.Mock(return_value=["the moon is full"])):
            self.points_here(lambda: run.report())  # here

    def test_replicas_run_replicas(self):
        with self.program_that_says("{}"), mock.patch.object(ljmd.Replicas, "open"):
            self.points_here(lambda: small_deck().run(self.folder / "replicas", replicas=2, progress=False))  # here

    def test_sweeps_sweep(self):
        with self.program_that_says('{"points": []}'), mock.patch.object(ljmd.Sweep, "open"):
            self.points_here(lambda: small_deck().sweep({"system.density": [0.7, 0.8]}, directory=self.folder / "sweep", progress=False))  # here

    def test_comparisons_compare(self):
        with self.program_that_says('{"passed": true, "checks": []}'):
            self.points_here(lambda: small_deck().compare())  # here

    def test_reference_values_reference(self):
        found = {"phase": "liquid", "warnings": ["the moon is full"], "citation": "", "temperature": 1.0, "density": 0.8}
        with self.program_that_says(json.dumps(found)):
            self.points_here(lambda: ljmd.reference(1.0, 0.8, progress=None))  # here

    def test_equation_of_state__document(self):
        self.points_here(lambda: ljmd.eos(0.9, 0.3))  # here
        self.points_here(lambda: ljmd.eos(0.9, [0.3, 0.4]))  # here

    def test_all_places_are_tried(self):
        self.assertEqual([name for name in places() if not hasattr(self, f"test_{name.replace('.', '_')}")], [])


def places() -> list:
    """The functions of the package that warn, or hand the function that does to the engine: "runs.Run.report"."""
    found = []

    def visit(node, name):
        for child in ast.iter_child_nodes(node):
            if isinstance(child, (ast.FunctionDef, ast.ClassDef)):
                visit(child, f"{name}.{child.name}")
            else:
                if isinstance(child, ast.Attribute) and ast.unparse(child) in WARNS:
                    found.append(name)
                visit(child, name)

    for path in sorted(PACKAGE.rglob("*.py")):
        if path.name not in ("_check.py", "_program.py"):
            visit(ast.parse(path.read_text(encoding="utf-8")), path.stem)
    assert len(found) > 8, found
    return found


if __name__ == "__main__":
    warnings.simplefilter("ignore", ljmd.RunWarning)
    unittest.main()
