"""The engine of the page, in node: the digits of the program in every deck and every plug-in, and its words about every
mistake in a deck.

    engine_test.py --ljmd PROGRAM --engine FOLDER --work FOLDER [--short]     --short: few decks, for a minute

ENGINE: folder of ljmd_page.js and ljmd_page.wasm, see tools/page. A run is compared by its last configuration with the
velocities, which both write as text with all digits.
"""

import argparse
import json
import pathlib
import shutil
import subprocess
import sys

ROOT = pathlib.Path(__file__).resolve().parents[2]
sys.path[:0] = [str(ROOT / "tests"), str(ROOT / "tests/cli"), str(ROOT / "tests/physics")]
import deck_errors  # noqa: E402
import digits_test  # noqa: E402
import few_body_errors  # noqa: E402
import harness  # noqa: E402

SHORT = ("examples/first.toml", "examples/there-and-back.toml", "verlet1967/argon-864.toml", "fewbody/pythagorean.toml",
         "barostat stochastic-cell-rescaling", "mixed, switched", "a gas")


def values_of(settings: list) -> list:
    """What stands behind each --set."""
    return settings[1::2]


def plan_of_runs(program: str, folder: pathlib.Path, short: bool) -> list:
    plugins = digits_test.plugins_in(subprocess.run([program, "info"], capture_output=True, text=True, check=True).stdout)
    plan = []
    for case in digits_test.cases(program, plugins, folder):
        if short and case.name not in SHORT:
            continue
        out = folder / "out"
        shutil.rmtree(out, ignore_errors=True)
        subprocess.run([program, "run", case.deck, "--quiet", "--simd", "portable", "--out", out, *case.settings], check=True, cwd=folder,
                       capture_output=True)
        settings, files = values_of(case.settings), {}
        for place, setting in enumerate(settings):
            if setting.startswith("system.file="):
                start = pathlib.Path(setting.removeprefix("system.file=")) / "final.xyz"
                files["start.xyz"] = start.read_text(encoding="utf-8")
                settings[place] = "system.file=start.xyz"
        plan.append({"name": case.name, "deck": case.deck.read_text(encoding="utf-8"), "settings": settings, "files": files,
                     "wanted": (out / "final.xyz").read_text(encoding="utf-8")})
    return plan


def plan_of_mistakes(program: str, folder: pathlib.Path, short: bool) -> list:
    """Decks with a mistake, with what `ljmd check` says of them."""
    plan = []
    substance = harness.DECK.replace("[system]", harness.ARGON + "\n[system]")
    kinds = [(harness.DECK, deck_errors.VALUES + deck_errors.STRUCTURE + deck_errors.SENSE), (substance, deck_errors.SUBSTANCE),
             (harness.STARS, few_body_errors.VALUES + few_body_errors.STRUCTURE + few_body_errors.SENSE)]
    decks = {name: harness.replaced(deck, *edits) for deck, mistakes in kinds for name, *edits in mistakes}
    corpus = ROOT / "tests/fuzz/corpus/deck"
    decks |= {f"corpus {path.name}": path.read_text(encoding="utf-8", errors="replace") for path in sorted(corpus.iterdir())
              if path.name in ("many-mistakes", "syntax-error")}
    for name, text in decks.items():
        if short and len(plan) == 12:
            break
        deck = folder / "deck.toml"
        deck.write_text(text, encoding="utf-8")
        done = subprocess.run([program, "run", "deck.toml", "--quiet", "--out", "never"], capture_output=True, text=True, check=False, cwd=folder)
        if done.returncode == 2:
            plan.append({"name": "deck.toml", "deck": text, "open_only": True, "wanted": done.stderr.rstrip("\n"), "mistake": name})
    return plan


def main() -> int:
    parser = argparse.ArgumentParser()
    parser.add_argument("--ljmd", required=True)
    parser.add_argument("--engine", required=True)
    parser.add_argument("--work", required=True, type=pathlib.Path)
    parser.add_argument("--short", action="store_true")
    options = parser.parse_args()
    shutil.rmtree(options.work, ignore_errors=True)
    options.work.mkdir(parents=True)
    program = str(pathlib.Path(options.ljmd).resolve())

    runs = plan_of_runs(program, options.work.resolve(), options.short)
    mistakes = plan_of_mistakes(program, options.work.resolve(), options.short)
    plan, answers = options.work / "plan.json", options.work / "answers.json"
    plan.write_text(json.dumps(runs + mistakes), encoding="utf-8")
    subprocess.run(["node", pathlib.Path(__file__).with_name("engine_runs.mjs"), options.engine, plan, answers], check=True)
    found = json.loads(answers.read_text(encoding="utf-8"))

    failed = []
    for entry, answer in zip(runs + mistakes, found["answers"], strict=True):
        got = answer.get("configuration", answer.get("error", "it was opened without complaint"))
        if got.rstrip("\n") != entry["wanted"].rstrip("\n"):
            name = entry.get("mistake", entry["name"])
            failed.append(f"{name}\n  wanted: {entry['wanted'][:300]}\n  found:  {got[:300]}")
    failed += [f"{one['problem']}: {one['found']}" for one in found["digits"] if not one["right"]]
    print("\n".join(f"FAIL {words}" for words in failed))
    print(f"{len(runs)} runs, {len(mistakes)} mistakes, {len(failed)} differ")
    return 1 if failed or not runs or not mistakes else 0


if __name__ == "__main__":
    sys.exit(main())
