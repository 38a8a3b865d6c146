"""The package loads what is used, when it is used: its names, their types, and pickles are those of a package that loads all at once."""

import ast
import importlib.util
import pathlib
import pickle
import subprocess
import sys
import unittest

import ljmd
from cases import Case, small_deck


def python(code: str, *arguments) -> str:
    done = subprocess.run([sys.executable, "-c", code, *map(str, arguments)], capture_output=True, text=True, check=False)
    assert done.returncode == 0, done.stderr
    return done.stdout


class Lazy(Case):
    def test_the_import_loads_neither_engine_nor_numpy(self):
        loaded = python("import sys, ljmd; print(*sorted(m for m in sys.modules if m.split('.')[0] in ('ljmd', 'numpy', 'pandas')))")
        self.assertEqual(loaded, "ljmd\n")
        loaded = python("import sys, ljmd; ljmd.open; print('ljmd._core' in sys.modules)")
        self.assertEqual(loaded, "False\n")

    def test_every_name_is_there(self):
        for name in ljmd.__all__:
            self.assertIn(name, dir(ljmd))
            self.assertIsNotNone(getattr(ljmd, name))
        self.assertEqual(ljmd.__version__, ljmd.build()["version"])
        self.assertRaisesText(AttributeError, "has no attribute 'nothing'", of=lambda: ljmd.nothing)
        with self.assertRaises(ImportError):
            exec("from ljmd import nothing")
        names: dict = {}
        exec("from ljmd import *", names)
        self.assertEqual(set(ljmd.__all__), set(names) - {"__builtins__"})

    def test_modules_are_attributes(self):
        self.assertEqual(python("import ljmd; print(ljmd.ase.Calculator.__name__, ljmd.errors.DataError is ljmd.DataError)"),
                         "Calculator True\n")
        # A module that is imported hides no function.
        code = "import pkgutil, ljmd, importlib\n[importlib.import_module(f'ljmd.{m.name}') for m in pkgutil.iter_modules(ljmd.__path__)" \
               " if m.name != '_mdanalysis']\nprint(*[n for n in ljmd.__all__ if type(getattr(ljmd, n)) is type(ljmd)])"
        self.assertEqual(python(code), "\n")

    def test_the_style_of_pictures_needs_no_engine(self):
        self.needs(importlib.util.find_spec("matplotlib"), "matplotlib")
        code = "import sys, ljmd; ljmd.style(); import matplotlib; print(matplotlib.rcParams['svg.hashsalt'], 'ljmd._core' in sys.modules)"
        self.assertEqual(python(code), "ljmd False\n")

    def test_type_checkers_see_the_same(self):
        found = {}
        source = pathlib.Path(ljmd.__file__).read_text()
        branch = next(node for node in ast.parse(source).body if isinstance(node, ast.If))
        for node in branch.body:
            if isinstance(node, ast.ImportFrom):
                found[node.module] = sorted(one.name for one in node.names)
        self.assertEqual(found, {place: sorted(names) for place, names in ljmd._PLACES.items()})

    def test_pickles_are_read_where_nothing_is_loaded(self):
        run = small_deck().run(progress=False)
        (self.folder / "run.pickle").write_bytes(pickle.dumps((run, run["pressure"])))
        code = "import pickle, sys\nrun, p = pickle.load(open(sys.argv[1], 'rb'))\nprint(repr(run['pressure'].mean), repr(p.error), len(run.thermo))"
        expected = f"{run['pressure'].mean!r} {run['pressure'].error!r} {len(run.thermo)}\n"
        self.assertEqual(python(code, self.folder / "run.pickle"), expected)


if __name__ == "__main__":
    unittest.main()
