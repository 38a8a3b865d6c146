#!/usr/bin/env python3
"""Judges engines that are right, in many systems: no check may fail.

    right_systems.py --ljmd PATH [--some N] [--first K]     all systems, or every so many-th of them, from the K-th on

An engine is ljmd itself, with its atoms in another order, another pair search and other random numbers, or the page of Python of docs/judge.md.
Prints a line for each system, with the check that came nearest to its limit. Exit code 1 if a check failed.
"""

import argparse
import itertools
import json
import shlex
import subprocess
import sys
import tempfile
from pathlib import Path

HERE = Path(__file__).resolve().parent
sys.path.insert(0, str(HERE.parent))
import keeper  # noqa: E402

PAGE = HERE.parents[1] / "docs/examples/engine.py"
EDGE_CELLS = {32: 2, 108: 3, 256: 4, 500: 5}
CANONICAL = ["langevin", "andersen", "stochastic-rescaling", "nose-hoover-chain"]


def deck_of(system):
    stage = system.get("stage", "")
    truncation = f'cutoff = {system["cutoff"]}\ntruncation = "{system["truncation"]}"\n'
    if system["truncation"] == "switched":
        truncation += f'switch_start = {0.8 * system["cutoff"]}\ntail = false\n'
    if system["truncation"] == "cut":
        truncation += "tail = true\n"
    return f"""\
title = "{system["name"]}"

[system]
lattice = {{ type = "fcc", cells = {EDGE_CELLS[system["atoms"]]} }}
density = {system["density"]}
temperature = {system["temperature"]}
seed = {system["seed"]}

[potential]
type = "lennard-jones"
{truncation}
[[stage]]
name = "melt"
time_step = 0.004
steps = 2000
temperature = {system["temperature"]}
thermostat = {{ type = "langevin", time = 0.2 }}

[[stage]]
name = "production"
time_step = {system.get("time_step", 0.004)}
steps = {system["steps"]}
sample = true
{stage}

[output]
thermo = {{ every = 5 }}
"""


def systems():
    """Every truncation, number of atoms and ensemble that the judge is to be right about."""
    number = itertools.count(1)

    def made(name, **more):
        seed = next(number)
        return {"name": f"{seed} {name}", "seed": seed, "density": 0.8442, "temperature": 1.0, "steps": 10000, "engine": "ljmd", **more}

    # Constant energy, with a step of the force at the cutoff: the energy walks.
    for _ in range(12):
        yield made("32 shifted at 1.4", atoms=32, cutoff=1.4, truncation="shifted")
    for _ in range(3):
        yield made("108 cut at 2.0, long", atoms=108, cutoff=2.0, truncation="cut", steps=200000)
    for atoms, cutoff in ((32, 1.6), (108, 2.2), (256, 2.5), (500, 2.5)):
        for truncation in ("cut", "shifted", "force-shifted", "switched"):
            for density, temperature in ((0.8442, 0.8), (0.8442, 1.5), (0.5, 1.4)):
                yield made(f"{atoms} {truncation}", atoms=atoms, cutoff=cutoff, truncation=truncation, density=density, temperature=temperature,
                           steps=20000 if atoms < 200 else 5000)
    for truncation in ("cut", "shifted"):
        for _ in range(4):
            yield made(f"page, 108 {truncation}", atoms=108, cutoff=2.2, truncation=truncation, steps=3000, engine="page")
        yield made(f"page, 32 {truncation}", atoms=32, cutoff=1.5, truncation=truncation, steps=10000, engine="page")
    # Canonical: the engine has another thermostat than ljmd.
    for k, (atoms, cutoff) in enumerate(((32, 1.6), (108, 2.2), (256, 2.5), (500, 2.5))):
        for j, thermostat in enumerate(CANONICAL):
            other = CANONICAL[(j + k) % len(CANONICAL)]
            if (thermostat in CANONICAL[:2]) != (other in CANONICAL[:2]):
                other = thermostat  # other degrees of freedom
            for temperature in (0.9, 1.6):
                yield made(f"{atoms} {thermostat}, engine {other}", atoms=atoms, cutoff=cutoff, truncation="cut", temperature=temperature,
                           steps=20000 if atoms < 200 else 8000, stage=bath(thermostat, temperature), theirs=bath(other, temperature))
    for atoms, cutoff in ((108, 2.2), (256, 2.5)):
        for thermostat in ("langevin", "stochastic-rescaling"):
            for temperature in (1.0, 1.4):
                lines = bath(thermostat, temperature) + '\nbarostat = { type = "stochastic-cell-rescaling", pressure = 2.0, time = 1.0 }'
                yield made(f"{atoms} NPT {thermostat}", atoms=atoms, cutoff=cutoff, truncation="cut", temperature=temperature, steps=30000, stage=lines,
                           theirs=lines)


def bath(name, temperature):
    return f'temperature = {temperature}\nthermostat = {{ type = "{name}", time = 0.4 }}'


def judged(ljmd, system):
    """The judgement of the system's engine, as judge.json has it."""
    with tempfile.TemporaryDirectory() as place:
        Path(place, "deck.toml").write_text(deck_of(system), encoding="utf-8")
        if system["engine"] == "page":
            command = f"{shlex.quote(sys.executable)} {shlex.quote(str(PAGE))} {{input}} {{output}}"
            parts = "point,trajectory,averages"
        else:
            words = [sys.executable, str(HERE / "ljmd_engine.py"), str(ljmd), str(1000 + system["seed"]), system.get("theirs", "")]
            command = " ".join(map(shlex.quote, words)) + " {input} {output}"
            parts = "averages"
        done = subprocess.run([ljmd, "compare", "deck.toml", "--with", f"command:{command}", "--parts", parts, "--quiet", "--json", "--threads", "1"],
                              cwd=place, capture_output=True, text=True, check=False)
    if not done.stdout:
        raise SystemExit(f"{system['name']}: {done.stderr}")
    return json.loads(done.stdout)


def main():
    parser = argparse.ArgumentParser(description=__doc__.splitlines()[0])
    parser.add_argument("--ljmd", required=True, type=Path)
    parser.add_argument("--some", type=int, default=1)
    parser.add_argument("--first", type=int, default=1)
    options = parser.parse_args()
    chosen = list(systems())[options.first - 1::options.some]
    alarms = checks = 0
    for system in chosen:
        found = judged(options.ljmd.resolve(), system)
        failed = [check["name"] for check in found["checks"] if not check["passed"]]
        # a ratio to ljmd's is near 1 where all is well
        nearest = max((check for check in found["checks"] if "over that of" not in check["name"] and check["tolerance"]),
                      key=lambda check: check["value"] / check["tolerance"], default=None)
        alarms += bool(failed)
        checks += len(found["checks"])
        near = f'{nearest["value"]:.3g} of {nearest["tolerance"]:.3g}: {nearest["name"]}' if nearest else "nothing judged"
        print(f'{system["name"]}: {len(found["checks"])} checks, {len(failed)} failed {failed or ""}; nearest {near}', flush=True)
    print(f"{len(chosen)} right systems, {checks} checks, {alarms} false alarms")
    return 1 if alarms else 0


if __name__ == "__main__":
    sys.exit(keeper.kept(main))
