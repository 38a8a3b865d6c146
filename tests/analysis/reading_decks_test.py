#!/usr/bin/env python3
"""Tests of ljmd.reading.decks. Prints "N passed, M failed"; exit code 1 if any failed."""

from __future__ import annotations

import sys
from pathlib import Path

import fixtures  # noqa: I001  (it says where the modules of analysis/ are)
from ljmd.reading import decks, records
from fixtures import refused


def test_settings_change_a_deck(tmp: Path) -> None:
    text = '[force]\ntype = "gravity"\n[[body]]\nname = "sun"\nmass = 1.0\n[[body]]\nname = "e.x"\nmass = 2.0\n'
    settings = ["force.softening=0.5", "body.sun.mass=3", 'body."e.x".mass=4', "force.type=newtonian-gravity"]
    settings.append("new.a=[1]")
    found = decks.parse(tmp, text, settings)
    assert found == {
        "force": {"type": "newtonian-gravity", "softening": 0.5},
        "body": [{"name": "sun", "mass": 3}, {"name": "e.x", "mass": 4}],
        "new": {"a": [1]},
    }, found
    for setting in ("body.moon.mass=3", "body.1.mass=3", "force.type.x=3"):
        refused(lambda: decks.parse(tmp, text, [setting]), setting)
    nameless = decks.parse(tmp, "[[body]]\n[[body]]\n", ["body.2.position=[1.0, 0.5]"])
    assert nameless == {"body": [{}, {"position": [1.0, 0.5]}]}, nameless
    refused(lambda: decks.parse(tmp, "[[body]]\n", ["body.2.mass=1"]), "body.2.mass=1")
    refused(lambda: decks.parse(tmp, text, ["body"]), "KEY=VALUE")
    refused(lambda: decks.parse(tmp, "a ="), "not valid TOML")
    refused(lambda: decks.read(tmp / "none.toml"), "none.toml", "no such file", exit_code=2)


def test_deck_of_a_run(tmp: Path) -> None:
    run = fixtures.write_gravity(tmp / "run", **fixtures.EIGHT, masses=[1, 2, 3], steps=1)
    fixtures.edit(run / "run.json", '"settings": []', '"settings": ["body.2.mass=5.0", "force.softening=0.1"]')
    found = decks.of_run(records.read(run))
    assert [body["mass"] for body in found["body"]] == [1.0, 5.0, 3.0], found
    assert found["force"]["softening"] == 0.1, found
    fixtures.edit(run / "run.json", '"deck"', '"deck_text"')
    refused(lambda: decks.of_run(records.read(run)), "run.json", "'deck' is missing")


if __name__ == "__main__":
    sys.exit(fixtures.run_tests(globals()))
