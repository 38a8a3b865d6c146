#!/usr/bin/env python3
"""Runs the program as a person would and looks at what it says and writes.

    run_cli_tests.py --ljmd PATH [MODULE ...]            run these test modules, or all of them
    run_cli_tests.py --ljmd PATH --update [MODULE ...]   write the golden files anew; read the difference before you commit

Needs nothing but Python 3.9. Prints a line for each failing case, and "N passed, M failed" at the end.
"""

import argparse
import importlib
import signal
import sys
from pathlib import Path

HERE = Path(__file__).resolve().parent
sys.path[:0] = [str(HERE), str(HERE.parent)]

import harness  # noqa: E402
import keeper  # noqa: E402

MODULES = ["commands", "pages", "terminals", "analyzes", "trajectories", "evaluates", "compares", "judges", "equations", "deck_errors", "few_body_errors", "effects", "exports", "edge_cases", "hostile_input", "outputs", "starts", "streams", "faults", "resumes", "processes", "not_files", "foreign_files", "taken_names", "every_taken_name", "reproduces", "sweeps", "workers", "until", "references", "reports", "decks", "plots"]


def take_usual_signals():
    """A shell that starts these tests in the background has the first two ignored, nohup the third, and so would the programs
    under test."""
    signal.signal(signal.SIGINT, signal.default_int_handler)
    signal.signal(signal.SIGQUIT, signal.SIG_DFL)
    signal.signal(signal.SIGHUP, signal.SIG_DFL)


def main():
    take_usual_signals()
    parser = argparse.ArgumentParser(description=__doc__.splitlines()[0])
    parser.add_argument("--ljmd", required=True, type=Path, help="the program")
    parser.add_argument("--update", action="store_true", help="write the golden files anew")
    parser.add_argument("modules", nargs="*", metavar="MODULE", help=", ".join(MODULES))
    options = parser.parse_args()
    unknown = set(options.modules) - set(MODULES)
    if unknown:
        parser.error(f"no test module is called {', '.join(sorted(unknown))}")
    passed = failed = 0
    for name in options.modules or MODULES:
        cases = importlib.import_module(name).cases()
        golden = HERE / "golden" / f"{name}.txt"
        good, bad = harness.run_cases(name, cases, options.ljmd.resolve(), golden, options.update)
        passed += good
        failed += bad
    print(f"{passed} passed, {failed} failed")
    return 1 if failed else 0


if __name__ == "__main__":
    sys.exit(keeper.kept(main))
