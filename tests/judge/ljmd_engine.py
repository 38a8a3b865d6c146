"""ljmd as an engine of its own: ljmd_engine.py LJMD SEED STAGE PROBLEM ANSWER

The atoms are in another order, and pairs are searched in another way: rounding differs, and with it the trajectory, which is as right as the
first. STAGE has further lines of the [[stage]]: thermostat and barostat. Answers with thermo.csv alone.
"""

import csv
import json
import os
import random
import subprocess
import sys
from pathlib import Path

ljmd, seed, stage, problem_directory, answer_directory = sys.argv[1:6]
problem = json.loads(Path(problem_directory, "problem.json").read_text(encoding="utf-8"))
answer = Path(answer_directory)
lines = Path(problem_directory, "start.xyz").read_text(encoding="utf-8").splitlines()
atoms = lines[2:]
random.Random(int(seed)).shuffle(atoms)
work = answer / "work"
work.mkdir()
# ids are those of the rows
header = lines[1]
fields = header[header.index("Properties=") + len("Properties="):].split()[0].strip('"').split(":")
columns, place = {}, 0
for name, _, width in zip(fields[0::3], fields[1::3], fields[2::3]):
    columns[name] = place
    place += int(width)
rows = []
for number, row in enumerate(atoms, 1):
    words = row.split()
    if "id" in columns:
        words[columns["id"]] = str(number)
    rows.append(" ".join(words))
(work / "start.xyz").write_text("\n".join([*lines[:2], *rows]) + "\n", encoding="utf-8")
potential, run = problem["potential"], problem["run"]
switch = f'switch_start = {potential["switch_start"]!r}\n' if "switch_start" in potential else ""
search = 'method = "all-pairs"' if problem["atoms"] < 200 else "skin = 0.5"
deck = f"""\
title = "engine"

[system]
file = "start.xyz"
seed = {seed}

[potential]
type = "lennard-jones"
cutoff = {potential["cutoff"]!r}
truncation = "{potential["truncation"]}"
{switch}tail = {str(potential["tail"]).lower()}

[neighbors]
{search}

[[stage]]
name = "run"
time_step = {run["time_step"]!r}
steps = {run["steps"]}
sample = true
{stage}

[output]
thermo = {{ every = {run["thermo_every"]} }}
"""
(work / "deck.toml").write_text(deck, encoding="utf-8")
subprocess.run([ljmd, "run", "deck.toml", "--out", "run", "--quiet", "--threads", "1"], cwd=work, check=True, env={**os.environ})
n, edges = problem["atoms"], problem["box_edges"]
with open(work / "run/thermo.csv", encoding="utf-8") as file, open(answer / "thermo.csv", "w", encoding="utf-8") as out:
    print("step,potential_energy,kinetic_energy,pressure,volume", file=out)
    for row in csv.DictReader(file):
        if int(row["step"]) == 0:
            continue
        volume = n / float(row["density"]) if "density" in row else edges[0] * edges[1] * edges[2]
        kinetic = n * float(row["kinetic_energy"])
        # rho T + W/(3 V), T of its degrees of freedom, where (2 K + W)/(3 V) is asked for
        pressure = float(row["pressure"]) - n * float(row["temperature"]) / volume + 2.0 * kinetic / (3.0 * volume)
        print(row["step"], repr(n * float(row["potential_energy"])), repr(kinetic), repr(pressure), repr(volume), sep=",", file=out)
