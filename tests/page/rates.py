"""How fast the engine of the page is, in node, beside the program at its portable level: interleaved runs, medians of the pairs.

    rates.py --ljmd PROGRAM --engine FOLDER [--pairs 9]

Nothing here is a test: it prints a table for docs/page.md.
"""

import argparse
import json
import pathlib
import statistics
import subprocess
import sys
import tempfile

HERE = pathlib.Path(__file__).resolve().parent
DECK = """[system]
lattice = {{ type = "fcc", cells = {cells} }}
density = 0.8442
temperature = 0.9
seed = 1
[potential]
type = "lennard-jones"
cutoff = 2.5
truncation = "cut"
tail = true
[[stage]]
name = "all"
time_step = 0.004
steps = {steps}
[output]
thermo = {{ every = 1000 }}
"""


def main() -> int:
    parser = argparse.ArgumentParser()
    parser.add_argument("--ljmd", required=True, type=pathlib.Path)
    parser.add_argument("--engine", required=True, type=pathlib.Path)
    parser.add_argument("--pairs", type=int, default=9)
    options = parser.parse_args()
    with tempfile.TemporaryDirectory() as name:
        folder = pathlib.Path(name)
        for cells, steps in ((4, 12000), (6, 4000), (10, 800), (20, 80)):
            deck = folder / "deck.toml"
            deck.write_text(DECK.format(cells=cells, steps=steps), encoding="utf-8")
            rates = []
            for _ in range(options.pairs):
                subprocess.run([options.ljmd.resolve(), "run", deck, "--quiet", "--simd", "portable", "--out", folder / "run", "--force"], check=True,
                               capture_output=True)
                native = json.loads((folder / "run/run.json").read_text(encoding="utf-8"))["seconds_in_time_loop"]
                page = subprocess.run(["node", HERE / "rate.mjs", options.engine, deck], check=True, capture_output=True, text=True).stdout
                rates.append((steps / native, steps / float(page)))
            program, engine = (statistics.median(column) for column in zip(*rates, strict=True))
            share = statistics.median(b / a for a, b in rates)
            print(f"{4 * cells**3:6} atoms: program {program:8.0f} steps/s, page {engine:8.0f} steps/s, ratio {share:.2f}")
    return 0


if __name__ == "__main__":
    sys.exit(main())
