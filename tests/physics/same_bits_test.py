"""The environment of the tests that judge by statistics (same_bits.env) makes a run the same bits on every processor.

Usage: same_bits_test.py --ljmd PROGRAM

A fluid under every thermostat and the barostat, long enough for the last bit of a random number to be seen in where the atoms
are at the end. Another processor is one whose features are hidden from the C library; the kernels ignore that.
"""

import argparse
import json
import os
import pathlib
import subprocess
import sys
import tempfile

sys.path.insert(0, str(pathlib.Path(__file__).resolve().parent.parent))
import same_bits  # noqa: E402

DECK = """
[system]
lattice = { type = "fcc", cells = 3 }
density = 0.7
temperature = 1.0
seed = 11

[potential]
type = "lennard-jones"
cutoff = 2.0
truncation = "force-shifted"
"""
STAGE = """
[[stage]]
name = "{thermostat}"
time_step = 0.004
steps = 300
sample = true
thermostat = {{ type = "{thermostat}", time = 0.1 }}
"""
BAROSTAT = 'barostat = { type = "stochastic-cell-rescaling", pressure = 0.5, every = 5 }\n'
THERMOSTATS = ("andersen", "langevin", "nose-hoover-chain", "stochastic-rescaling")
TUNABLES = same_bits.VARIABLES["GLIBC_TUNABLES"]
HIDDEN = "-AVX512F,-AVX2,-AVX,-SSE4_2,-SSE4_1,-SSSE3,-BMI2,-POPCNT"


def end_of_run(ljmd: str, folder: pathlib.Path, **environment: str) -> bytes:
    """Where the atoms are at the end, and the averages."""
    variables = {name: value for name, value in os.environ.items() if name not in same_bits.VARIABLES}
    subprocess.run([ljmd, "run", "deck.toml", "--out", "out", "--quiet", "--force"], cwd=folder, check=True, capture_output=True,
                   env={**variables, **environment})
    averages = json.loads((folder / "out" / "results.json").read_text())["observables"]
    return (folder / "out" / "final.xyz").read_bytes() + json.dumps(averages).encode()


def main() -> int:
    parser = argparse.ArgumentParser()
    parser.add_argument("--ljmd", required=True)
    arguments = parser.parse_args()
    ljmd = str(pathlib.Path(arguments.ljmd).resolve())
    levels = json.loads(subprocess.run([ljmd, "info", "--json"], capture_output=True, check=True, text=True).stdout)["simd_levels"]
    failures = []
    with tempfile.TemporaryDirectory() as temporary:
        folder = pathlib.Path(temporary)
        (folder / "deck.toml").write_text(DECK + "".join(STAGE.format(thermostat=name) for name in THERMOSTATS) + BAROSTAT)
        expected = end_of_run(ljmd, folder, **same_bits.VARIABLES)
        poorer = {**same_bits.VARIABLES, "GLIBC_TUNABLES": f"{TUNABLES},{HIDDEN}"}
        if end_of_run(ljmd, folder, **poorer) != expected:
            failures.append("on a processor with fewer features the run is another one")
        # The comparison can tell: with other numbers of lanes (x86-64-v2 has those of portable) it is another run.
        for level in set(levels) & {"x86-64-v3"}:
            if end_of_run(ljmd, folder, **{**same_bits.VARIABLES, "LJMD_SIMD": level}) == expected:
                failures.append(f"{level} gives the bits of {levels[0]}: the run is too short to tell")
        chosen = end_of_run(ljmd, folder, LJMD_SIMD=same_bits.VARIABLES["LJMD_SIMD"])
        print(f"without GLIBC_TUNABLES this processor gives {'the same' if chosen == expected else 'other'} bits")
    print("\n".join(failures) or "the same bits")
    return 1 if failures else 0


if __name__ == "__main__":
    sys.exit(main())
