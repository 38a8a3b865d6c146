"""What type checkers find: misspelt names are errors, right ones are not, and the names are those of the engine."""

import json
import os
import pathlib
import re
import subprocess
import sys
import unittest

import ljmd
from cases import ROOT, Case, command_line

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
deck.stages[0].steps * deck.stages[0].time_step
bath = {"type": "langevin", "time": 0.2}
deck.stages[0].thermostat = bath
deck.stages[0].thermostat.time = "0.1 ps"
deck.stages[-1].until.pressure = 0.02
deck.system.density = 0.7
deck.system.lattice.atoms = 108
deck.potential.cutoff = 2.0
deck.potential = ljmd.pair(lambda r: np.exp(-r), cutoff=2.0, truncation="shifted")
deck.potential = {"type": "lennard-jones", "cutoff": 2.5, "truncation": "shifted"}
deck.neighbors.skin = 0.4
del deck.neighbors.skin
deck.neighbors.every = None
deck.performance.precision = "mixed"
deck.output.trajectory = dict(every=10, velocities=True)
deck.output.trajectory.every = 20
deck.output.checkpoint.every = "1 min"
deck.output = {"thermo": {"every": 5}}
deck.analysis.rdf(bins=200)
deck.analysis.structure_factor(k_max=8, width=0.3)
deck.analysis.closest_approach()
del deck.analysis["rdf"]
few = ljmd.Deck.few_body("pendulum", [], gravity=1.0, length=1.0)
few.force.gravity = 9.8
few.bodies[0].position = np.array([0.1])
few.bodies = [{"mass": 1.0, "position": [1.0], "velocity": [0.0]}]
few.analysis.orbit(body=1)


@ljmd.observable(every=5, energy=True)
def half(s):
    return 0.5 * s.temperature


run = deck.run(observables=[half])
mean: float = run["pressure"].mean
rows = run.thermo["pressure"]
run.stages[0]["name"]
several = deck.run("runs/several", replicas=4, jobs=2)
several.runs[0]["pressure"].error
sweep = deck.sweep({"system.temperature": [1.0, 1.5], "system.density": np.linspace(0.1, 0.2, 3)}, jobs=2)
sweep[0].run.stages[0]["name"].upper()
ljmd.Simulation(deck, observables=[half]).run(progress=print).frames().positions.shape


@ljmd.pair(cutoff=2.0, truncation="cut")
def gauss(r):
    return np.exp(-r**2)


gauss.force([1.0]).sum()
soft: ljmd.PotentialTable = {"type": "morse", "cutoff": 2.5, "truncation": "cut", "well_depth": 1.0, "steepness": 6.0, "minimum": 1.1}
found = ljmd.evaluate([[0, 0, 0]], [5, 5, 5], potential=soft)
ljmd.evaluate([[0, 0, 0]], 5, potential={"cutoff": 2.5}).forces.sum()
ljmd.evaluate([[0, 0, 0]], 5, potential=ljmd.pair(lambda r: r, cutoff=2.0, truncation="cut")).pairs_too_near
state = ljmd.eos(1.5, 0.5)
state.pressure + ljmd.eos(0.9).liquid.density
ljmd.trajectory("a.xyz").rdf(bins=20).table("rdf")
ljmd.open("runs/argon")["pressure"].mean
ljmd.open_sweep("runs/gas")[0].run["pressure"].mean
for name, observable in run.items():
    name.upper(), observable.si
with ljmd.Simulation(deck).arrays() as arrays:
    arrays.positions.sum()
for simulation in ljmd.Simulation(deck).steps(3):
    simulation.time


@ljmd.observable
def third(s: object) -> float:
    return 1.0


ljmd.resume("runs/argon", steps=2, observables=third, walltime="2h").stages
'''

WRONG = [("deck.system.densty = 3", '"System" has no attribute "densty"'), ("deck.stages[0].stepz = 4", '"Stage" has no attribute "stepz"'),
         ("deck.potential.cutof = 3", '"Potential" has no attribute "cutof"'), ("deck.sytem", '"Deck" has no attribute "sytem"'),
         ("deck.neighbors.skim = 3", '"Neighbors" has no attribute'), ("deck.performance.precison = 3", '"Performance" has no attribute'),
         ("deck.output.thermos = 3", '"Output" has no attribute'), ("deck.analysis.rdff()", '"Analyses" has no attribute "rdff"'),
         ("deck.analysis.rdf(bin=200)", 'Unexpected keyword argument "bin" for "rdf"'), ("deck.analysis.orbit(about=2)", 'Missing named argument "body"'),
         ("deck.system.lattice.atom = 3", '"SystemLattice" has no attribute "atom"'), ("deck.output.thermo.evry = 3", '"OutputThermo" has no attribute'),
         ("deck.stages[0].thermostat.tme = 3", '"StageThermostat" has no attribute'), ("deck.stages[-1].until.presure = 3", '"StageUntil" has no attribute'),
         ('deck.neighbors.every = "often"', "Incompatible types in assignment"), ("deck.system.density = [0.8]", "Incompatible types in assignment"),
         ("few.bodies[0].velocty", '"Body" has no attribute'), ("deck.run(observables=3)", "No overload variant"),
         ("deck.run(replicas=2)", "No overload variant"), ("sweep[0].rnu", '"Point" has no attribute'), ("gauss.forse", '"Pair" has no attribute'),
         ("deck.substance.sigm", '"Substance" has no attribute'), ("few.force.gravty", '"Force" has no attribute'),
         ('run["pressure"].eror', '"Observable" has no attribute "eror"'), ("run.termo", '"Run" has no attribute "termo"'),
         ("several.directry", '"Replicas" has no attribute'), ("ljmd.eos(1.5, dens=0.5)", "Unexpected keyword argument"),
         ("state.presure", '"Properties" has no attribute "presure"'), ("found.force", '"Evaluation" has no attribute "force"'),
         ('ljmd.evaluate([[0, 0, 0]], 5, potential={"type": "lennard-jones", "cutof": 2.5})', "incompatible type"),
         ('ljmd.trajectory("a.xyz").rdff()', '"Trajectory" has no attribute "rdff"'),
         ('ljmd.trajectory("a.xyz").rdf(bin=20)', 'Unexpected keyword argument "bin"'), ('text: str = run["pressure"].mean', "Incompatible types"),
         ("ljmd.Stage('a', 3).sampl", '"Stage" has no attribute "sampl"'),
         ("ljmd.Stage('a', 3, smaple=True)", 'Unexpected keyword argument "smaple" for "Stage"'), ("ljmd.evalute", "Module has no attribute")]


PACKAGE = pathlib.Path(ljmd.__file__).parent.parent


class Checked(Case):
    def mypy(self, paths: list, *options, **environment) -> list:
        """The errors that mypy finds."""
        clean = {name: value for name, value in os.environ.items() if name not in ("PYTHONPATH", "MYPYPATH")}
        done = subprocess.run([sys.executable, "-m", "mypy", "--ignore-missing-imports", "--no-error-summary", "--hide-error-context",
                               "--cache-dir", self.folder / "cache", *options, *paths], capture_output=True, text=True,
                              env={**clean, **environment}, check=False)
        self.needs("No module named mypy" not in done.stderr, "mypy")
        self.assertEqual(done.stderr, "")
        return [line for line in done.stdout.splitlines() if ": note:" not in line]

    def test_misspelt_names_are_errors_and_nothing_else_is(self):
        script = self.folder / "script.py"
        script.write_text(RIGHT + "".join(f"{line}\n" for line, _ in WRONG), encoding="utf-8")
        # On MYPYPATH the annotations of the package itself are checked, too.
        errors = self.mypy([script], MYPYPATH=str(PACKAGE))
        first = RIGHT.count("\n") + 1
        for k, (line, text) in enumerate(WRONG):
            of_line = [error for error in errors if error.startswith(f"{script}:{first + k}: error:")]
            self.assertEqual([text in error for error in of_line], [True], f"{line}: {of_line}")
        self.assertEqual(len(errors), len(WRONG), "\n".join(errors))

    def test_the_lines_of_the_pages_have_no_errors(self):
        """As strict as mypy can be; only functions of a page need no annotations."""
        scripts = [self.folder / "right.py"]
        scripts[0].write_text(RIGHT, encoding="utf-8")
        for page in [ROOT / "README.md", *sorted((ROOT / "docs").rglob("*.md"))]:
            blocks = re.findall(r"^```python\n(.*?)^```$", page.read_text(encoding="utf-8"), re.M | re.S)
            apart = [block for block in blocks if block.startswith("# file: ")]  # scripts of their own; the others are one program
            for text in filter(None, ["".join(block for block in blocks if block not in apart), *apart]):
                scripts.append(self.folder / f"{page.stem.replace('-', '_')}_{len(scripts)}.py")
                scripts[-1].write_text(text, encoding="utf-8")
        self.assertGreater(len(scripts), 4)
        self.assertEqual(self.mypy(scripts, "--strict", "--allow-untyped-defs", PYTHONPATH=str(PACKAGE)), [])


class Declared(Case):
    def test_the_keys_are_those_of_the_schema(self):
        schema = command_line("info", "--schema").stdout
        made = subprocess.run([sys.executable, ROOT / "tools/python-keys"], input=schema, capture_output=True, text=True, check=True).stdout
        self.assertEqual(made, (ROOT / "python/ljmd/_keys.pyi").read_text(encoding="utf-8"),
                         "python/ljmd/_keys.pyi: tools/python-keys writes it anew, and says how")

    def test_every_table_is_an_attribute_of_decks(self):
        schema = json.loads(command_line("info", "--schema").stdout)
        names = {"stage": "stages", "body": "bodies", "argon": "substance"}
        for key in {*schema["else"]["properties"], *schema["then"]["properties"]} - {"units"}:
            self.assertTrue(hasattr(ljmd.Deck, names.get(key, key)), key)

    def test_the_names_of_properties_are_those_of_equations_of_state(self):
        found = set()
        for each in (ljmd.eos(1.5, 0.5), ljmd.eos(0.9), ljmd.eos(0.9).liquid, ljmd.eos(1.5, pressure=0.3), *ljmd.equations()):
            found |= set(each.data)
        self.assertEqual(set(ljmd.eos(1.5, 0.5).__annotations__), found)


if __name__ == "__main__":
    unittest.main()
