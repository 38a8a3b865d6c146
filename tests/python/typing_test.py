"""What type checkers find: misspelt names are errors, right ones are not, and the names are those of the engine."""

import json
import os
import pathlib
import subprocess
import sys
import unittest

import ljmd
import ljmd.tables
from cases import Case, command_line

RIGHT = '''
import numpy as np

import ljmd

deck = ljmd.Deck.fluid(atoms=256, density=0.8, temperature=1.0, substance=ljmd.ARGON)
deck.stages = [ljmd.Stage("melt", 10, thermostat={"type": "rescale", "every": 5}), ljmd.Stage("production", 1000, sample=True)]
deck.stages = ljmd.Stage("production", 1000, sample=True)
deck.stages[0].steps = 4
deck.stages[0].thermostat = "langevin"
deck.stages[0]["steps"] = 5
deck.stages.append(ljmd.Stage("more", until={"pressure": 0.01, "max_steps": 1000}, sample=True))
deck.system.density = 0.7
deck.system.lattice.atoms = 108
deck.potential.cutoff = 2.0
deck.potential = ljmd.pair(lambda r: np.exp(-r), cutoff=2.0, truncation="shifted")
deck.potential = {"type": "lennard-jones", "cutoff": 2.5, "truncation": "shifted"}
deck.neighbors.skin = 0.4
del deck.neighbors.skin
deck.performance.precision = "mixed"
deck.output.trajectory = dict(every=10, velocities=True)
deck.output = {"thermo": {"every": 5}}
deck.analysis.rdf(bins=200)
del deck.analysis["rdf"]
few = ljmd.Deck.few_body("pendulum", [], gravity=1.0, length=1.0)
few.force.gravity = 9.8


@ljmd.observable(every=5, energy=True)
def half(s):
    return 0.5 * s.temperature


run = deck.run(observables=[half])
mean: float = run["pressure"].mean
rows = run.thermo["pressure"]
run.stages[0]["name"]
several = deck.run("runs/several", replicas=4, jobs=2)
several.runs[0]["pressure"].error
soft: ljmd.PotentialTable = {"type": "morse", "cutoff": 2.5, "truncation": "cut", "well_depth": 1.0, "steepness": 6.0, "minimum": 1.1}
found = ljmd.evaluate([[0, 0, 0]], [5, 5, 5], potential=soft)
ljmd.evaluate([[0, 0, 0]], 5, potential={"cutoff": 2.5}).forces.sum()
ljmd.evaluate([[0, 0, 0]], 5, potential=ljmd.pair(lambda r: r, cutoff=2.0, truncation="cut")).pairs_too_near
state = ljmd.eos(1.5, 0.5)
state.pressure + ljmd.eos(0.9).liquid.density
ljmd.trajectory("a.xyz").rdf(bins=20).table("rdf")
ljmd.open("runs/argon")["pressure"].mean
'''

WRONG = [("deck.system.densty = 3", '"System" has no attribute "densty"'), ("deck.stages[0].stepz = 4", '"Stage" has no attribute "stepz"'),
         ("deck.potential.cutof = 3", '"Potential" has no attribute "cutof"'), ("deck.sytem", '"Deck" has no attribute "sytem"'),
         ("deck.neighbors.skim = 3", '"Neighbors" has no attribute'), ("deck.performance.precison = 3", '"Performance" has no attribute'),
         ("deck.output.thermos = 3", '"Output" has no attribute'), ("deck.analysis.rdff()", '"Analyses" has no attribute "rdff"'),
         ("deck.substance.sigm", '"Substance" has no attribute'), ("few.force.gravty", '"Force" has no attribute'),
         ('run["pressure"].eror', '"Observable" has no attribute "eror"'), ("run.termo", '"Run" has no attribute "termo"'),
         ("several.directry", '"Replicas" has no attribute'), ("ljmd.eos(1.5, dens=0.5)", "Unexpected keyword argument"),
         ("state.presure", '"Properties" has no attribute "presure"'), ("found.force", '"Evaluation" has no attribute "force"'),
         ('ljmd.evaluate([[0, 0, 0]], 5, potential={"type": "lennard-jones", "cutof": 2.5})', "incompatible type"),
         ('ljmd.trajectory("a.xyz").rdff()', '"Trajectory" has no attribute "rdff"'), ('text: str = run["pressure"].mean', "Incompatible types"),
         ("ljmd.Stage('a', 3, smaple=True).sampl", '"Stage" has no attribute "sampl"'), ("ljmd.evalute", "Module has no attribute")]


def keys_of(schema: dict) -> set:
    return set(schema.get("properties", {}))


class Checked(Case):
    def test_misspelt_names_are_errors_and_nothing_else_is(self):
        script = self.folder / "script.py"
        script.write_text(RIGHT + "".join(f"{line}\n" for line, _ in WRONG), encoding="utf-8")
        # On MYPYPATH alone the annotations of the package itself are checked, too.
        environment = {**os.environ, "MYPYPATH": str(pathlib.Path(ljmd.__file__).parent.parent)}
        environment.pop("PYTHONPATH", None)
        done = subprocess.run([sys.executable, "-m", "mypy", "--ignore-missing-imports", "--no-error-summary", "--hide-error-context",
                               "--cache-dir", self.folder / "cache", script], capture_output=True, text=True, env=environment, check=False)
        if "No module named mypy" in done.stderr:
            self.skipTest("there is no mypy")
        self.assertEqual(done.stderr, "")
        errors = [line for line in done.stdout.splitlines() if ": note:" not in line]
        first = RIGHT.count("\n") + 1
        for k, (line, text) in enumerate(WRONG):
            of_line = [error for error in errors if error.startswith(f"{script}:{first + k}: error:")]
            self.assertEqual([text in error for error in of_line], [True], f"{line}: {of_line}")
        self.assertEqual(len(errors), len(WRONG), "\n".join(errors))


class Declared(Case):
    def test_the_keys_of_tables_are_those_of_decks(self):
        schema = json.loads(command_line("info", "--schema").stdout)
        fluid, few = schema["else"]["properties"], schema["then"]["properties"]
        for table, expected in ((ljmd.Stage, keys_of(fluid["stage"]["items"]) | keys_of(few["stage"]["items"])),
                                (ljmd.tables.System, keys_of(fluid["system"])), (ljmd.tables.Potential, keys_of(fluid["potential"])),
                                (ljmd.PotentialTable, keys_of(fluid["potential"])), (ljmd.tables.Neighbors, keys_of(fluid["neighbors"])),
                                (ljmd.tables.Performance, keys_of(fluid["performance"])),
                                (ljmd.tables.Output, keys_of(fluid["output"]) | keys_of(few["output"])),
                                (ljmd.tables.Substance, keys_of(fluid["argon"])), (ljmd.tables.Force, keys_of(few["force"])),
                                (ljmd.tables.Analyses, keys_of(fluid["analysis"]) | keys_of(few["analysis"]))):
            self.assertTrue(expected)
            self.assertEqual(set(table.__annotations__), expected, table.__name__)
        self.assertEqual(set(ljmd.Trajectory.__annotations__), set(ljmd.build()["analyses"]))

    def test_the_names_of_properties_are_those_of_equations_of_state(self):
        found = set()
        for each in (ljmd.eos(1.5, 0.5), ljmd.eos(0.9), ljmd.eos(0.9).liquid, ljmd.eos(1.5, pressure=0.3), *ljmd.equations()):
            found |= set(each.data)
        self.assertEqual(set(ljmd.eos(1.5, 0.5).__annotations__), found)


if __name__ == "__main__":
    unittest.main()
