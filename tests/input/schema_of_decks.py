#!/usr/bin/env python3
"""Does `ljmd info --schema` describe decks? An editor's validator must accept every deck of the project, and find the mistakes that are made
in one of each kind.

Usage: schema_of_decks.py LJMD
"""

import copy
import json
import pathlib
import subprocess
import sys
import tomllib

import jsonschema

ROOT = pathlib.Path(__file__).resolve().parents[2]
sys.path.insert(0, str(ROOT / "tests"))
from figures import check, exit_code  # noqa: E402


def changed(deck, path, value):
    """The deck with a value at a path of keys; None: without that key."""
    deck = copy.deepcopy(deck)
    table = deck
    for key in path[:-1]:
        table = table[key]
    if value is None:
        del table[path[-1]]
    else:
        table[path[-1]] = value
    return deck


def expect(name, good):
    check(name, good, True, 0)


def load(name):
    return tomllib.loads((ROOT / "inputs" / name).read_text(encoding="utf-8"))


def main(ljmd):
    schema = json.loads(subprocess.run([ljmd, "info", "--schema"], capture_output=True, text=True, check=True).stdout)
    jsonschema.Draft7Validator.check_schema(schema)
    validator = jsonschema.Draft7Validator(schema)
    decks = sorted((ROOT / "inputs").rglob("*.toml"))
    expect("decks found", len(decks) > 20)
    for deck in decks:
        found = [error.message for error in validator.iter_errors(tomllib.loads(deck.read_text(encoding="utf-8")))]
        expect(f"{deck.relative_to(ROOT)} is accepted {found[:1]}", not found)

    fluid, bodies = load("examples/constant-pressure.toml"), load("fewbody/kepler-leapfrog.toml")
    thermostat = next(k for k, stage in enumerate(fluid["stage"]) if "barostat" in stage)
    mistakes = [
        ("a key that does not exist", fluid, ("system", "densty"), 0.8),
        ("a table that does not exist", fluid, ("sytem",), {}),
        ("a missing table", fluid, ("potential",), None),
        ("a missing key", fluid, ("stage", 0, "time_step"), None),
        ("a text for an integer", fluid, ("stage", 0, "steps"), "many"),
        ("a number out of range", fluid, ("stage", 0, "steps"), -1),
        ("an unknown choice", fluid, ("potential", "truncation"), "cutt"),
        ("a missing key of a choice", fluid, ("stage", thermostat, "barostat", "pressure"), None),
        ("a key of another choice", fluid, ("stage", thermostat, "thermostat"), {"type": "langevin", "length": 3}),
        ("an integrator of few bodies", fluid, ("stage", 0, "integrator"), "prince-dormand"),
        ("a body of a fluid", fluid, ("body",), [{"mass": 1.0, "position": [0.0]}]),
        ("too many components", bodies, ("body", 0, "position"), [0.0, 0.0, 0.0, 0.0]),
        ("a key of another force", bodies, ("force", "stiffness"), 1.0),
    ]
    for name, deck, path, value in mistakes:
        expect(f"found: {name}", validator.is_valid(deck) and not validator.is_valid(changed(deck, path, value)))


if __name__ == "__main__":
    main(sys.argv[1])
    sys.exit(exit_code())
