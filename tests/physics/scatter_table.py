"""The scatter of means over many seeds, over the errors that the runs report, for each kind of run: a table.

Usage: scatter_table.py --ljmd PROGRAM [--jobs N] [--seeds N] [KIND...]

By hand (each kind takes some minutes of two cores). Long runs: 60 seeds; ratios must lie within 0.75 and 1.27 (60 runs know them to 9 %), and no
more of them outside 0.8 to 1.2 than chance gives (3 %, and two standard deviations of such a number). Short ones: 200 seeds; values without a
remark alone, and how many have none. Of these no more may be off by three errors than Student's distribution of six degrees of freedom lets
expect (2.4 %), and two standard deviations of such a number; what is right is the mean over all seeds, with its own error.
"""

import argparse
import concurrent.futures
import csv
import json
import math
import pathlib
import subprocess
import sys
import tempfile

sys.path.insert(0, str(pathlib.Path(__file__).resolve().parent.parent))
from figures import check, exit_code  # noqa: E402

BEYOND = 0.024

LIQUID = """
[system]
lattice = {{ type = "fcc", cells = 3 }}
density = {density}
temperature = 1.0
seed = {seed}

[potential]
type = "lennard-jones"
cutoff = 2.0
truncation = "force-shifted"

[[stage]]
name = "melt"
time_step = 0.004
steps = 1000
temperature = 2.0
thermostat = {{ type = "stochastic-rescaling" }}

[[stage]]
name = "equilibrate"
time_step = 0.004
steps = {before}
thermostat = {{ type = "stochastic-rescaling" }}
{barostat}

[[stage]]
name = "production"
time_step = 0.004
{length}
sample = true
thermostat = {{ type = "stochastic-rescaling" }}
{barostat}

[analysis]
{analyses}
"""

FILM = """
[system]
lattice = {{ type = "fcc", cells = 4, layers = 6, height = 26.0 }}
density = 0.75
temperature = 0.85
seed = {seed}

[potential]
type = "lennard-jones"
cutoff = 2.5
truncation = "shifted"

[[stage]]
name = "melt"
time_step = 0.005
steps = 4000
temperature = 1.0
thermostat = {{ type = "langevin", time = 0.5 }}

[[stage]]
name = "equilibrate"
time_step = 0.005
steps = 30000
thermostat = {{ type = "stochastic-rescaling" }}

[[stage]]
name = "production"
time_step = 0.005
{length}
thermostat = {{ type = "stochastic-rescaling" }}
sample = true

[output]
thermo = {{ every = 25 }}

[analysis]
film = {{ layers = 100, every = 25 }}
"""

# In a direction in which the atoms stay within bounds, the virial is a derivative in time, sum z f_x = d/dt sum z p_x - sum p_z p_x: its mean over
# a run falls as 1/t, faster than any error from its variance, which is then too large.
OF_BOUNDED_MOTION = {("film", "pressure_xz"), ("film", "pressure_yz")}

CORRELATIONS = """
scattering = { every = 10, max_time = 2.0, shells = 3, vectors = 3 }
van_hove = { every = 10, max_time = 2.0, times = 3, bins = 30, radius = 2.0 }
van_hove_distinct = { every = 50, max_time = 1.0, between = 4.0, bins = 30, radius = 2.4 }
"""
POINTS = 5  # of each function of a table

BAROSTAT = 'barostat = { type = "stochastic-cell-rescaling", pressure = 1.0, time = 1.0 }'
FLUCTUATIONS = "response_functions = { every = 20 }"


def liquid(seed: int, length: str, before: int = 3000, barostat: str = "", analyses: str = FLUCTUATIONS) -> str:
    return LIQUID.format(seed=seed, density=0.61 if barostat else 0.75, before=before, barostat=barostat, length=length, analyses=analyses)


# Kind -> whether its runs are long, the deck of a seed, further options of `ljmd run`.
KINDS = {
    "constant pressure": (True, lambda seed: liquid(seed, "steps = 160000", barostat=BAROSTAT), []),
    "film": (True, lambda seed: FILM.format(seed=seed, length="steps = 250000"), []),
    "short": (False, lambda seed: liquid(seed, "steps = 12000"), []),
    "short, constant pressure": (False, lambda seed: liquid(seed, "steps = 40000", barostat=BAROSTAT), []),
    "short film": (False, lambda seed: FILM.format(seed=seed, length="steps = 20000"), []),
    "four replicas": (False, lambda seed: liquid(100 * seed, "steps = 24000"), ["--replicas", "4", "--jobs", "1"]),
    "time correlations": (True, lambda seed: liquid(seed, "steps = 300000", analyses=CORRELATIONS), []),
    "until the pressure": (False, lambda seed: liquid(seed, "until = { pressure = 0.03, max_steps = 200000 }"), []),
    "until the heat capacity": (False, lambda seed: liquid(seed, "until = { heat_capacity_cv = 0.1, max_steps = 200000 }"), []),
}


def observables(options: argparse.Namespace, name: str, seed: int) -> dict[str, dict]:
    """What a run finds; of one that was made before, what it found."""
    _, deck, more = KINDS[name]
    folder = options.folder / name.replace(" ", "-").replace(",", "")
    kept = folder / f"{seed}.json"
    if not kept.exists():
        folder.mkdir(parents=True, exist_ok=True)
        with tempfile.TemporaryDirectory() as scratch:
            file, out = pathlib.Path(scratch) / "deck.toml", pathlib.Path(scratch) / "run"
            file.write_text(deck(seed))
            subprocess.run([options.ljmd, "run", str(file), "--out", str(out), "--quiet", *more], check=True, capture_output=True)
            results = json.loads((out / "results.json").read_text())["observables"]
            kept.write_text(json.dumps({"observables": points(out) if name == "time correlations" else results}))
    return json.loads(kept.read_text())["observables"]


def points(out: pathlib.Path) -> dict[str, dict]:
    """Some rows of each function in the tables of a run, as results.json has observables."""
    found = {}
    for path in sorted(out.glob("*.csv")):
        with open(path, encoding="utf-8", newline="") as file:
            rows = list(csv.DictReader(file))
        for name in rows[0]:
            error = f"{name}_standard_error"
            if error not in rows[0]:
                continue
            for point in range(min(POINTS, len(rows))):
                row = rows[int((point + 0.37) / min(POINTS, len(rows)) * len(rows))]
                at = ", ".join(f"{key} {float(value):.3g}" for key, value in list(row.items())[:2] if key in ("k", "time", "r", "angular_frequency"))
                found[f"{name} at {at}"] = {"mean": float(row[name] or "nan"), "standard_error": float(row[error] or 0.0)}
    return found


def look_at(name: str, is_long: bool, runs: list[dict[str, dict]]) -> list[float]:
    """Print and check the lines of one kind. @return the ratios"""
    ratios = []
    for quantity in runs[0]:
        given = [one[quantity] for one in runs if quantity in one and one[quantity]["standard_error"]]
        sure = [one for one in given if "remark" not in one]
        unmarked = f"{len(sure)} of {len(runs)}"
        if len(sure) < 20:
            print(f"| {name} | {quantity} | | {unmarked} | |")
            continue
        centre = sum(one["mean"] for one in given) / len(given)
        scatter = math.sqrt(sum((one["mean"] - centre) ** 2 for one in sure) / (len(sure) - 1))
        ratio = scatter / math.sqrt(sum(one["standard_error"] ** 2 for one in sure) / len(sure))
        beyond = sum(abs(one["mean"] - centre) > 3 * one["standard_error"] for one in sure)
        print(f"| {name} | {quantity} | {ratio:.2f} | {unmarked} | {beyond} |")
        if (name, quantity) in OF_BOUNDED_MOTION:
            check(f"{name}: scatter over error of {quantity}, at most", ratio, 0.0, 1.27)
        elif is_long:
            ratios.append(ratio)
            check(f"{name}: scatter over error of {quantity}", ratio, 1.01, 0.26 * math.sqrt(len(runs) / len(sure)))
        else:
            expected = BEYOND * len(sure)
            check(f"{name}: {quantity} more than three errors off", beyond, 0, expected + 2 * math.sqrt(expected))
    return ratios


def main() -> int:
    parser = argparse.ArgumentParser(description=__doc__.splitlines()[0])
    parser.add_argument("kinds", nargs="*", choices=[[], *KINDS], metavar="KIND", help=", ".join(KINDS))
    parser.add_argument("--ljmd", required=True)
    parser.add_argument("--jobs", type=int, default=2)
    parser.add_argument("--seeds", type=int, help="instead of 60 and 200")
    parser.add_argument("--first", type=int, default=1, help="the first seed")
    parser.add_argument("--folder", type=pathlib.Path, help="where results are kept")
    options = parser.parse_args()
    with tempfile.TemporaryDirectory() as folder, concurrent.futures.ThreadPoolExecutor(options.jobs) as pool:
        options.folder = options.folder or pathlib.Path(folder)
        print("| runs | quantity | scatter / error | without a remark | beyond 3 errors |\n|---|---|---|---|---|")
        ratios = []
        for name in options.kinds or KINDS:
            seeds = range(options.first, options.first + (options.seeds or (60 if KINDS[name][0] else 200)))
            runs = list(pool.map(lambda seed, of=name: observables(options, of, seed), seeds))
            ratios += look_at(name, KINDS[name][0], runs)
    if ratios:
        expected = 0.03 * len(ratios)
        check("ratios of long runs outside 0.8 to 1.2", sum(not 0.8 <= one <= 1.2 for one in ratios), 0, expected + 2 * math.sqrt(expected))
    return exit_code()


if __name__ == "__main__":
    sys.exit(main())
