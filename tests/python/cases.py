"""What the tests of the package share: small decks, the program, a folder for each test."""

import os
import pathlib
import subprocess
import tempfile
import unittest

import ljmd

ROOT = pathlib.Path(__file__).resolve().parents[2]
INPUTS = ROOT / "inputs"


def program() -> str:
    """The command line of the same build."""
    return os.environ.get("LJMD") or str(pathlib.Path(ljmd._core.__file__).resolve().parents[2] / "ljmd")


def command_line(*arguments, cwd=None) -> subprocess.CompletedProcess:
    return subprocess.run([program(), *map(str, arguments)], capture_output=True, text=True, cwd=cwd, check=False)


def small_deck(**changes) -> ljmd.Deck:
    """A liquid of 108 atoms, 20 + 40 steps."""
    wanted = {"atoms": 108, "density": 0.8, "temperature": 1.0, "cutoff": 2.0, "truncation": "shifted", "seed": 7, **changes}
    deck = ljmd.Deck.fluid(**wanted)
    deck.stages = [ljmd.Stage("equilibrate", 20, thermostat={"type": "rescale", "every": 5}),
                   ljmd.Stage("production", 40, sample=True)]
    return deck


def long_deck(steps: int = 10**12, atoms: int = 864) -> ljmd.Deck:
    """A liquid that runs for ever unless it is stopped, or is given its steps."""
    deck = ljmd.Deck.fluid(atoms=atoms, seed=3)
    deck.stages = [ljmd.Stage("production", steps, sample=True)]
    return deck


def comet(steps: int = 1000) -> ljmd.Deck:
    deck = ljmd.Deck.few_body("newtonian-gravity", [dict(mass=1.0, position=[1.0, 0.0], velocity=[0.0, 1.2])],
                              title="a comet", gravitational_constant=1.0, central_mass=1.001)
    deck.stages = [ljmd.Stage("orbit", steps, time_step=0.01, integrator="leapfrog")]
    deck.output.trajectory = dict(every=10)
    return deck


class Case(unittest.TestCase):
    """Each test has an empty folder to write to, and shows no progress."""

    def setUp(self):
        folder = tempfile.TemporaryDirectory()
        self.addCleanup(folder.cleanup)
        self.folder = pathlib.Path(folder.name)

    def needs(self, there, what: str) -> None:
        """Skip a test that needs another program or package; with LJMD_REQUIRE_PEERS=1 in the environment it fails."""
        if not there:
            (self.fail if os.environ.get("LJMD_REQUIRE_PEERS") == "1" else self.skipTest)(f"there is no {what}")

    def assertRaisesText(self, error, *texts, of):
        """`of` raises the error, with all these texts."""
        with self.assertRaises(error) as caught:
            of()
        for text in texts:
            self.assertIn(text, str(caught.exception))
