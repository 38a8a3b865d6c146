"""Every deck of the project: good as it stands, and it runs when its stages are made short."""

import json
import math
import re
from pathlib import Path

from harness import Case

INPUTS = Path(__file__).resolve().parents[2] / "inputs"
MOST_CELLS = 6  # 864 atoms are enough to see whether a deck runs
STEPS = 12


def decks():
    return sorted(INPUTS.rglob("*.toml"))


def shortened(text):
    """The --set that make a deck quick: few steps, few atoms, and still every output that it asks for."""
    stages = re.findall(r"^\[\[stage\]\][^\[]*?^name = \"([^\"]+)\"([^\[]*)", text, flags=re.M)
    # A stage that runs until an error is reached has its largest number of steps instead.
    settings = [f"stage.{name}.{'until.max_steps' if re.search(r'^until = ', rest, flags=re.M) else 'steps'}={STEPS}" for name, rest in stages]
    cells = re.search(r"cells = (\d+)", text)
    if cells and int(cells.group(1)) > MOST_CELLS:
        settings.append(f"system.lattice.cells={MOST_CELLS}")
    settings.append("output.thermo.every=2")
    if re.search(r"^trajectory = ", text, flags=re.M):
        settings.append("output.trajectory.every=4")
    fluid = re.search(r"^\[system\]", text, flags=re.M)
    analysis = re.search(r"^\[analysis\]\n(.*?)(?=^\[|\Z)", text, flags=re.M | re.S)
    for key, values in re.findall(r"^(\w+) = (\{.*\})", analysis.group(1) if fluid and analysis else "", flags=re.M):
        settings.append(f"analysis.{key}.every=2")
        if "max_time" in values:
            settings.append(f"analysis.{key}.max_time=0.05")
    return [part for setting in settings for part in ("--set", setting)]


def provide_start(t, text):
    """A deck that starts from the run of another deck needs that run first."""
    start = re.search(r'^file = "([^"]+)"', text, flags=re.M)
    if start:
        other = next((deck for deck in decks() if deck.stem == Path(start.group(1)).name), None)
        t.check(other is not None, f"no deck of the project makes {start.group(1)}")
        t.run_well("run", other, "--quiet", "--out", start.group(1), *shortened(other.read_text(encoding="utf-8")))


def is_few_body(deck):
    return "[[body]]" in deck.read_text(encoding="utf-8")


def compare(deck):
    """A few-body deck, shortened, is near its adaptive solution, which conserves its energy."""
    def test(t):
        text = deck.read_text(encoding="utf-8")
        found = json.loads(t.run_well("compare", deck, "--with", "gsl", "--json", *shortened(text)).out)
        t.check(found["passed"], f"checks: {found['checks']}")
        t.equal(found["rows"][-1]["step"], STEPS, "last step")
        t.check(found["largest_position_error"] < 0.01, f"position error {found['largest_position_error']}")
        t.equal(t.files(), [], "files")
    return test


def check(deck):
    def test(t):
        provide_start(t, deck.read_text(encoding="utf-8"))
        before = t.files()
        result = t.run_well("check", deck, "--json")
        t.equal(result.err, "", "warnings about the deck")
        t.check(json.loads(result.out)["steps"] > 0, "no steps")
        t.equal(t.files(), before, "files")
    return test


def run(deck):
    def test(t):
        text = deck.read_text(encoding="utf-8")
        provide_start(t, text)
        result = t.run_well("run", deck, "--out", "out", "--json", *shortened(text))
        found = json.loads(result.out)
        t.check(all(stage["steps"] == STEPS for stage in found["stages"]), f"stages: {found['stages']}")
        t.check(found["observables"], "nothing was measured: no stage is sampled")
        for name, values in found["observables"].items():
            has_value = isinstance(values["mean"], float) and math.isfinite(values["mean"])
            t.check(has_value or (values["mean"] is None and values.get("remark")), f"{name}: {values}")
        for name, column in t.columns("out/thermo.csv").items():
            known = [x for x in column if x is not None or name != "conserved_energy"]  # none under a barostat
            t.check(known and all(map(math.isfinite, known)), f"{name} in thermo.csv")
        if "rdf = " in text:
            t.check(all(map(math.isfinite, t.columns("out/rdf.csv")["g"])), "g in rdf.csv")
        for table in re.findall(r"^(orbit|oscillation) = ", text, flags=re.M):
            t.check((t.dir / f"out/{table}.csv").exists(), f"no {table}.csv")
        if "[[body]]" in text and "trajectory = " in text:
            columns = t.columns("out/trajectory.csv")
            t.equal(columns["step"], [0.0, 4.0, 8.0, 12.0], "frames")
            t.check(all(map(math.isfinite, sum(columns.values(), []))), "numbers in trajectory.csv")
    return test


def every_deck_has_a_title(t):
    for deck in decks():
        t.check(deck.read_text(encoding="utf-8").startswith('title = "'), f"{deck.relative_to(INPUTS)} begins with no title")


def there_are_decks(t):
    t.check(len(decks()) >= 19, f"only {len(decks())} decks under {INPUTS}")
    t.check(sum(map(is_few_body, decks())) >= 10, "only a few of them are of few bodies")


def cases():
    result = [Case("there are decks", there_are_decks), Case("every deck has a title", every_deck_has_a_title)]
    for deck in decks():
        name = deck.relative_to(INPUTS).as_posix()
        result += [Case(f"check {name}", check(deck)), Case(f"run {name}", run(deck))]
        if is_few_body(deck):
            result.append(Case(f"compare {name}", compare(deck)))
    return result
