"""same_bits_test.py once more, on every SIMD level of this machine."""

import os
import pathlib
import subprocess
import sys

import ljmd

failed = []
for level in ljmd.build()["simd_levels"]:
    script = pathlib.Path(__file__).with_name("same_bits_test.py")
    done = subprocess.run([sys.executable, str(script)], env={**os.environ, "LJMD_SIMD": level}, capture_output=True, text=True,
                          check=False)
    print(f"{level}: {done.stderr.strip().splitlines()[-1]}")
    if done.returncode != 0:
        failed.append(level)
        print(done.stderr[-3000:])
sys.exit(1 if failed else 0)
