"""The end of the interpreter, other interpreters, and objects that were not made by calling their class."""

import subprocess
import sys
import textwrap
import unittest

import ljmd
from alarm import waiting
from ljmd import _core

ENDLESS = """
    import threading
    import numpy as np
    import ljmd

    deck = ljmd.Deck.fluid(atoms=256, density=0.8, temperature=1.0)
    deck.stages = [ljmd.Stage("p", 10**8, sample=True)]
    begun = threading.Event()
    def tell(*_):
        begun.set()
        return 1.0
    def force(s):
        begun.set()
        return np.zeros((256, 3))
    def evaluate():
        evaluator, positions = ljmd.Evaluator(), np.random.default_rng(0).random((500, 3)) * 20
        while True:
            evaluator(positions, 20.0)
            begun.set()
"""
RUNS = {"observables": "deck.run(observables=[ljmd.observable(tell, every=1, name='mine')], progress=False)",
        "progress": "deck.run(progress=tell)",
        "external": "deck.run(external=force, progress=False)",
        "evaluations": "evaluate()",
        "steps": "[begun.set() or sim.advance(10) for sim in [ljmd.Simulation(deck)] for _ in range(10**8)]"}


def python(text):
    return subprocess.run([sys.executable, "-c", textwrap.dedent(text)], capture_output=True, text=True, timeout=waiting.PATIENCE, check=False)


class Ending(unittest.TestCase):
    def test_a_daemon_thread_that_computes_does_not_disturb_the_end(self):
        for name, run in RUNS.items():
            for turn in range(3):
                with self.subTest(name, turn=turn):
                    done = python(ENDLESS + f"""
    def work():
        {run}
    threading.Thread(target=work, daemon=True).start()
    begun.wait()
    print("here")
""")
                    self.assertEqual((done.returncode, done.stdout, done.stderr), (0, "here\n", ""))

    def test_another_interpreter_is_refused(self):
        try:
            import _xxsubinterpreters  # noqa: F401
        except ImportError:
            self.skipTest("this Python has no other interpreters, or hides them")
        for before in ("", "import ljmd; ljmd.build()"):
            inside = f"import sys\nsys.path[:] = {sys.path!r}\ntry:\n    import ljmd\n    ljmd.build()\n" \
                     "except ImportError as error:\n    print(error, flush=True)\n"
            done = python(f"""
                import _xxsubinterpreters as others
                {before}
                others.run_string(others.create(), {inside!r})
                print("end")
            """)
            self.assertEqual(done.returncode, 0, done.stderr)
            self.assertIn("ljmd works in the main interpreter of a process alone", done.stdout)
            self.assertTrue(done.stdout.endswith("end\n"), done.stdout)


class BareObjects(unittest.TestCase):
    def test_no_class_makes_an_object_without_its_constructor(self):
        classes = [each for each in vars(_core).values() if isinstance(each, type)]
        self.assertGreater(len(classes), 5)
        for each in classes:
            for make in (each.__new__, each.__mro__[1].__new__, object.__new__):
                with self.subTest(f"{each.__name__}, {make!r}"), self.assertRaises(TypeError):
                    make(each)
        self.assertIsInstance(ljmd.Evaluator()._core, _core.Evaluator)


if __name__ == "__main__":
    unittest.main()
