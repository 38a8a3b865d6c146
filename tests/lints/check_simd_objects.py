#!/usr/bin/env python3
"""Checks that objects compiled for one SIMD level share no function with the rest of the program.

    check_simd_objects.py .../ljmd_simd_LEVEL.dir/.../x.o ...

A function that several objects may define (an inline function or a template, weak in the object) is taken by the linker from
any one of them: compiled for AVX-512 it would then be called on processors that lack it. So a weak function must carry the name of
its level. Needs `nm`; sanitizers and coverage add functions of their own, for such builds the check says nothing.
"""

import re
import subprocess
import sys


def weak_functions(path):
    """Demangled names of the weak functions that an object defines."""
    answer = subprocess.run(["nm", "-C", "--defined-only", path], capture_output=True, check=True, text=True).stdout
    return [line[19:] for line in answer.splitlines() if line[17:18] == "W"]


def main(arguments):
    complaints = []
    for path in arguments:
        level = re.search(r"ljmd_simd_(\w+)\.dir", path).group(1)
        complaints += [f"{level}: {name}" for name in weak_functions(path) if level not in name]
    if not arguments:
        complaints.append("no object given")
    print("\n".join(complaints) or f"{len(arguments)} objects, no shared function")
    return 1 if complaints else 0


if __name__ == "__main__":
    sys.exit(main(sys.argv[1:]))
