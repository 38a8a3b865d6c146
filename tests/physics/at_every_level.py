#!/usr/bin/env python3
"""Runs tests of the whole system on every SIMD level that this processor has.

    at_every_level.py --ljmd PROGRAM --tests EXECUTABLE --threads N [--only last|ends] [FILTER ...]

EXECUTABLE is one of Catch2 whose kernels obey LJMD_SIMD and OMP_NUM_THREADS; FILTER selects tests as Catch2 does. --only last: on the
last level, which may have digits of its own; all others have those of the common set. --only ends: on the first and the last. Ends with an error when a level fails, when a run executes no test, or when only one level is there to be tried on an x86-64.
"""

import argparse
import json
import os
import platform
import re
import subprocess
import sys


def main():
    parser = argparse.ArgumentParser(description=__doc__, formatter_class=argparse.RawDescriptionHelpFormatter)
    parser.add_argument("--ljmd", required=True)
    parser.add_argument("--tests", required=True)
    parser.add_argument("--threads", required=True)
    parser.add_argument("--only", choices=["last", "ends"])
    parser.add_argument("filters", nargs="*")
    options = parser.parse_args()
    info = json.loads(subprocess.run([options.ljmd, "info", "--json"], capture_output=True, check=True, text=True).stdout)
    levels = info["simd_levels"]
    failures = []
    if platform.machine() == "x86_64" and len(levels) < 2:
        failures.append(f"only {levels} can be used on an x86-64")
    if options.only == "last":
        levels = levels[-1:]
    elif options.only == "ends":
        levels = [levels[0], *levels[1:][-1:]]
    for level in levels:
        environment = {**os.environ, "LJMD_SIMD": level, "OMP_NUM_THREADS": options.threads}
        result = subprocess.run([options.tests, *options.filters], capture_output=True, text=True, env=environment)
        summary = result.stdout.strip().splitlines()[-1] if result.stdout.strip() else "no output"
        passed = result.returncode == 0 and re.search(r"passed \(\d+ assertions in \d+ test cases?\)", summary)
        print(f"{level}: {summary}")
        if not passed:
            failures.append(f"{level} failed:\n{result.stdout[-3000:]}{result.stderr[-1000:]}")
    print("\n".join(failures) or f"{len(levels)} passed, 0 failed")
    return 1 if failures else 0


if __name__ == "__main__":
    sys.exit(main())
