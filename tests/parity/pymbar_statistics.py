"""Statistical inefficiency against pymbar, on the rows of a run that begins far from equilibrium; its start is found.

Usage: pymbar_statistics.py --ljmd PROGRAM

Exit code 77 where this Python has no pymbar.
"""

import argparse
import csv
import json
import pathlib
import subprocess
import sys
import tempfile

sys.path.insert(0, str(pathlib.Path(__file__).resolve().parent.parent))
from figures import check, exit_code  # noqa: E402

DECK = """
[system]
lattice = { type = "simple-cubic", cells = 6 }
density = 0.4
temperature = 1.0
seed = 5

[potential]
type = "lennard-jones"
cutoff = 2.0
truncation = "force-shifted"

[[stage]]
name = "melting"
time_step = 0.004
steps = 3000
sample = true

[output]
thermo = { every = 3 }
"""


def main() -> int:
    parser = argparse.ArgumentParser()
    parser.add_argument("--ljmd", required=True)
    arguments = parser.parse_args()
    try:
        import numpy as np
        from pymbar.timeseries import statisticalInefficiency
    except ImportError as error:
        print(f"skipped: {error}")
        return 77
    with tempfile.TemporaryDirectory() as folder:
        deck, out = pathlib.Path(folder) / "deck.toml", pathlib.Path(folder) / "out"
        deck.write_text(DECK)
        subprocess.run([arguments.ljmd, "run", str(deck), "--out", str(out), "--quiet"], check=True, capture_output=True)
        answer = subprocess.run([arguments.ljmd, "analyze", str(out), "--json"], check=True, capture_output=True, text=True)
        report = json.loads(answer.stdout)
        with open(out / "thermo.csv", newline="") as file:
            rows = [row for row in csv.DictReader(file) if int(row["step"]) > 0]

    check("rows", report["rows"], len(rows), 0)
    for name, found in report["observables"].items():
        series = np.array([float(row[name]) for row in rows])
        whole = statisticalInefficiency(series)
        check(f"{name}: inefficiency of all rows", found["statistical_inefficiency_of_all"], whole, 1e-8 * whole)
        start = found["equilibrated_at_row"] or 0
        check(f"{name}: mean from row {start} on", found["mean"], series[start:].mean(), 1e-12 * abs(series).max())
    latest = max(found["equilibrated_at_row"] or 0 for found in report["observables"].values())
    check("rows that a start from a lattice costs", latest, 250, 245)
    return exit_code()


if __name__ == "__main__":
    sys.exit(main())
