#!/usr/bin/env python3
"""Plants each mistake of tests/cli/judges.py in each of several systems: is it found, and called by its name, and by no other?

    planted_mistakes.py --ljmd PATH [NAME ...]

Prints a table: "named" says the name alone, "and more" other names beside it, "OTHER" only other names, "found" no name, "MISSED" that all
checks passed, "-" that the mistake is none in this system. Exit code 1 with OTHER or MISSED.
"""

import argparse
import json
import shlex
import subprocess
import sys
import tempfile
from pathlib import Path

HERE = Path(__file__).resolve().parent
sys.path[:0] = [str(HERE.parent / "cli"), str(HERE.parent)]
import keeper  # noqa: E402
from judges import ENGINE, MISTAKES  # noqa: E402

# name -> cells, density, temperature, cutoff, truncation, tail
SYSTEMS = {
    "liquid": (3, 0.8442, 1.0, 2.5, "cut", True),
    "few": (2, 0.8442, 1.0, 1.6, "cut", True),
    "gas": (3, 0.3, 2.0, 2.5, "cut", True),
    "crystal": (4, 1.0, 0.4, 2.0, "shifted", False),
    "many": (4, 0.8, 1.2, 2.2, "cut", True),
}
NONE_OF_SHIFTED = ("tail", "shifted energy")  # mistakes that a shifted potential without tail cannot have


def deck_of(cells, density, temperature, cutoff, truncation, tail):
    return f"""\
title = "planted"

[system]
lattice = {{ type = "fcc", cells = {cells} }}
density = {density}
temperature = {temperature}
seed = 11

[potential]
type = "lennard-jones"
cutoff = {cutoff}
truncation = "{truncation}"
tail = {str(tail).lower()}

[[stage]]
name = "melt"
time_step = 0.004
steps = 200
temperature = {temperature}
thermostat = {{ type = "rescale", every = 5 }}

[[stage]]
name = "production"
time_step = 0.004
steps = 40
sample = true

[output]
thermo = {{ every = 5 }}
"""


def outcome(ljmd, deck, replacements, words):
    """How one engine fares, and the diagnoses."""
    text = ENGINE.read_text(encoding="utf-8")
    for old, new in replacements:
        text = text.replace(old, new)
    with tempfile.TemporaryDirectory() as place:
        Path(place, "deck.toml").write_text(deck, encoding="utf-8")
        Path(place, "engine.py").write_text(text, encoding="utf-8")
        command = f"command:{shlex.quote(sys.executable)} engine.py {{input}} {{output}}"
        done = subprocess.run([ljmd, "compare", "deck.toml", "--with", command, "--steps", "100", "--quiet", "--json", "--threads", "1"],
                              cwd=place, capture_output=True, text=True, check=False)
    if not done.stdout:
        raise SystemExit(done.stderr)
    found = json.loads(done.stdout)
    names = found["diagnoses"]
    said = words.split("step 0: ")[-1].split(":")[0]
    right = [name for name in names if words in name or name.split("step 0: ")[-1].split(":")[0] == said]
    if found["passed"]:
        return "MISSED", names
    if not names:
        return "found", names
    if not right:
        return "OTHER", names
    return ("named" if len(right) == len(names) else "and more"), names


def main():
    parser = argparse.ArgumentParser(description=__doc__.splitlines()[0])
    parser.add_argument("--ljmd", required=True, type=Path)
    parser.add_argument("names", nargs="*")
    options = parser.parse_args()
    print("| mistake | " + " | ".join(SYSTEMS) + " |\n|---|" + "---|" * len(SYSTEMS), flush=True)
    counts, remarks = {}, []
    for name, (replacements, words, _) in MISTAKES.items():
        if options.names and name not in options.names:
            continue
        row = []
        for system, values in SYSTEMS.items():
            if values[-2] == "shifted" and any(word in name for word in NONE_OF_SHIFTED):
                row.append("-")
                continue
            how, names = outcome(options.ljmd.resolve(), deck_of(*values), replacements, words)
            row.append(how)
            counts[how] = counts.get(how, 0) + 1
            if how != "named":
                remarks.append(f"{name}, {system}: {how}: {names}")
        print(f"| {name} | " + " | ".join(row) + " |", flush=True)
    print()
    print("\n".join(remarks))
    print(", ".join(f"{how}: {count}" for how, count in sorted(counts.items())))
    return 1 if "OTHER" in counts or "MISSED" in counts else 0


if __name__ == "__main__":
    sys.exit(keeper.kept(main))
