"""Values of the wrong kind for each argument: an error of ljmd, never one of the binding, of Python's stack or of NumPy."""

import enum
import inspect
import io
import os
import unittest
import warnings

import numpy as np

import ljmd
from cases import Case

class Unshown:
    """What messages cannot show."""

    def __repr__(self):
        raise ValueError("no words for it")


class OddKind:
    """As a tensor of a library that is not NumPy: it has a dtype, which has no kind."""

    dtype = "float32"


class Count(enum.IntEnum):
    FEW = 32


ENDLESS: list = []
ENDLESS.append(ENDLESS)
DEEP: list = []
for _ in range(3000):
    DEEP = [DEEP]
CLOSED = io.StringIO("1")
CLOSED.close()
ODD = (None, "text", "", b"x", [], {}, (), object(), float("nan"), float("inf"), -1, 10**400, 2**63, 1j, np.complex128(1 + 2j),
       np.ma.array([1.0, 2.0, 3.0], mask=[0, 1, 0]), np.array([1.0, 2.0]), np.float32(2.5), np.bool_(True), True, ENDLESS, {"a": ENDLESS},
       "\0", "\ud800", ..., int, len, np.datetime64("2020"), [None], [[1]], {1: 2}, set(), range(3), slice(1), np.array("x"), memoryview(b"abc"),
       np.timedelta64(3, "s"), memoryview(np.zeros((2, 2), np.float16)), 10**5000, DEEP, Unshown(), OddKind(), range(10**15), "--help", "x" * 10**5, CLOSED, io.StringIO("1"), np.ma.array([(1, 2)], [("a", int), ("b", int)], mask=True))
# What a function of the user's raises, or a type that is called as one, is none of ours.
CALLABLE = ("observables", "external", "progress", "function")


def fluid(**changes):
    deck = ljmd.Deck.fluid(**{"atoms": 32, "density": 0.5, "temperature": 1.0, "cutoff": 1.9, **changes})
    deck.stages = [ljmd.Stage("p", 4, sample=True)]
    return deck


def looked_at(deck):
    return str(deck), repr(deck), deck._repr_html_(), deck.check()


def assigned(name, value):
    deck = fluid()
    setattr(deck, name, value)
    return looked_at(deck)


def staged(**changes):
    deck = fluid()
    deck.stages = [ljmd.Stage(**{"name": "p", "steps": 4, **changes})]
    return looked_at(deck)


class OddValues(Case):
    def setUp(self):
        super().setUp()
        self.addCleanup(os.chdir, os.getcwd())
        os.chdir(self.folder)
        warnings.simplefilter("ignore")
        self.addCleanup(warnings.resetwarnings)

    def refused(self, name, call):
        """Each value is taken, or refused by an error of ljmd, or by a TypeError that names the argument."""
        for value in ODD:
            if name in CALLABLE and callable(value):
                continue
            with self.subTest(name, value=type(value).__name__):
                try:
                    call(value)
                except ljmd.InternalError:
                    raise
                except ljmd.Error as error:
                    self.assertLess(len(str(error)), 10_000 + (len(value) if isinstance(value, str) else 0))
                except TypeError as error:
                    self.assertIn(name, str(error))
                    self.assertNotIn("incompatible", str(error))

    def test_decks(self):
        for name in inspect.signature(ljmd.Deck.fluid).parameters:
            if name not in ("parameters", "substance"):
                self.refused(name, lambda value, name=name: looked_at(fluid(**{name: value})))
        for name in ("steps", "time_step", "integrator", "temperature", "thermostat", "barostat", "sample", "until", "bogus"):
            self.refused(name, lambda value, name=name: staged(**{name: value}))
        for name in ("system", "potential", "neighbors", "performance", "output", "analysis", "substance", "force", "stages", "title", "bodies"):
            self.refused(name, lambda value, name=name: assigned(name, value))
        self.refused("tables", lambda value: str(ljmd.Deck(value)))
        self.refused("value", lambda value: looked_at(fluid().set("system.density", value)))
        self.refused("key", lambda value: looked_at(fluid().set(value, 1)))
        self.refused("bins", lambda value: fluid().analysis.rdf(bins=value) or None)
        for name in ("text", "set", "name"):
            self.refused(name, lambda value, name=name: ljmd.Deck.parse(**{"text": "title = 'a'", name: value}))
        self.refused("path", ljmd.Deck.load)
        self.refused("directory", ljmd.Pair.of_run)

    def test_a_deck_names_the_key_whose_value_it_cannot_hold(self):
        deck = fluid()
        deck.system.lattice = {"type": "fcc", "atoms": {"a": None}}
        for name, call in (("stage.temperature", lambda: staged(temperature=b"1")), ("force.central_mass", lambda: str(ljmd.Deck({"force": {"central_mass": 10**5000}}))),
                           ("system.lattice.atoms.a", lambda: str(deck)), ("force", lambda: str(ljmd.Deck({"force": {1: 2}}))),
                           ("substance", lambda: fluid(substance=5)), ("system.seed", lambda: fluid().set("system.seed", np.zeros(2**21)))):
            with self.assertRaisesRegex(ljmd.InputError, name):
                call()
        self.assertIn("atoms = 32", str(fluid(atoms=Count.FEW)))

    def test_a_setting_of_a_stage_that_is_not_there(self):
        with self.assertRaisesRegex(ljmd.InputError, "stages: "):
            ljmd.Deck.parse("title = 'a'", set={"stage.p.steps": 5})

    def test_a_deck_too_deep_to_be_copied(self):
        deck = fluid()
        deck.system.file = DEEP
        with self.assertRaisesRegex(ljmd.InputError, "too deep"):
            deck.copy()

    def test_runs(self):
        fluid().run("done", progress=False)
        for name in ("observables", "external", "simd", "progress", "replace", "force", "walltime", "jobs"):
            self.refused(name, lambda value, name=name: fluid().run(**{"progress": False, name: value}))
        for name in ("steps", "observables", "external", "simd"):
            if name in inspect.signature(ljmd.resume).parameters:
                self.refused(name, lambda value, name=name: ljmd.resume("done", **{"progress": False, name: value} if value is not True else {}))
        for name in ("points", "directory", "force"):
            self.refused(name, lambda value, name=name: fluid().sweep(**{"points": {"system.temperature": []}, "progress": False, name: value}))
        self.refused("values", lambda value: fluid().sweep({"system.temperature": value, "system.density": []}, progress=False))
        for name in ("program", "parts", "steps", "frames", "platform", "threads", "simd", "precision", "timeout"):
            self.refused(name, lambda value, name=name: fluid().compare(**{"parts": "point", name: value}))
        run = ljmd.open("done")
        for value in ODD:
            with self.subTest("table", value=type(value).__name__), self.assertRaises((KeyError, TypeError)):
                run["no such " + value if isinstance(value, str) else value]
            with self.subTest("table", value=type(value).__name__), self.assertRaises(KeyError):
                run.table(value)
        self.refused("deck", ljmd.Simulation)
        self.refused("steps", lambda value: ljmd.Simulation(fluid()).advance(value))
        self.refused("path", ljmd.trajectory)
        deck = fluid()
        deck.output.trajectory = {"every": 1}
        deck.run("frames", progress=False)
        self.refused("names", ljmd.trajectory("frames/trajectory.h5md").analyze)
        self.refused("directory", ljmd.open)

    def test_functions(self):
        positions = np.random.default_rng(0).random((8, 3)) * 7
        for name in ("positions", "edges", "potential", "energies", "simd", "precision"):
            self.refused(name, lambda value, name=name: ljmd.evaluate(**{"positions": positions, "edges": 7.0, name: value}))
        for name in ("type", "cutoff", "truncation", "tail", "switch_start", "bogus"):
            self.refused(name, lambda value, name=name: ljmd.evaluate(positions, 7.0, potential={name: value}))
        for name in ("temperature", "density", "model"):
            self.refused(name, lambda value, name=name: ljmd.eos(**{"temperature": 1.5, "density": 0.5, name: value}))
        for name in ("every", "unit", "energy", "name"):
            self.refused(name, lambda value, name=name: fluid().run(observables=[ljmd.observable(lambda s: 1.0, **{name: value})], progress=False))
        self.refused("returned", lambda value: fluid().run(observables=[ljmd.observable(lambda s: value)], progress=False))
        self.refused("returned", lambda value: fluid().run(external=lambda s: value, progress=False))
        table = {"name": "a", "first": 0.3, "cutoff": 2.5, "energies": np.ones(7 * 64 + 1), "truncation": "cut", "switch_start": None,
                 "error": 0.0, "force_error": 0.0}
        for name in table:
            self.refused(name, lambda value, name=name: ljmd.Pair(**{**table, name: value}))
        for name in inspect.signature(ljmd.pair).parameters:
            self.refused(name, lambda value, name=name: ljmd.pair(**{"function": lambda r: r**-12.0, "cutoff": 2.5, "truncation": "cut", name: value}))


class WorkingDirectory(Case):
    def test_a_function_that_goes_elsewhere_does_not_take_the_run_along(self):
        self.addCleanup(os.chdir, os.getcwd())
        os.chdir(self.folder)
        (self.folder / "elsewhere").mkdir()
        run = fluid().run("out", observables=[ljmd.observable(lambda s: os.chdir(self.folder / "elsewhere") or 1.0, every=1)], progress=False)
        self.assertTrue(run.finished)
        self.assertEqual(run.directory, self.folder / "out")
        self.assertEqual(list((self.folder / "elsewhere").iterdir()), [])
        self.assertEqual(len(run.thermo), len(ljmd.open(self.folder / "out").thermo))


if __name__ == "__main__":
    unittest.main()
