#!/usr/bin/env python3
"""Tests of the engine in a page, in Chromium.

    run_page_tests.py --ljmd PROGRAM --page FOLDER --work FOLDER [--short]

FOLDER of --page: ljmd.html and ljmd.mjs, see tools/page; its packages of npm lie in src/report/web. What the page says that the
program must show at home is tried with the program. Pictures of the page are left in the folder of --work.
"""

import argparse
import json
import re
import shlex
import shutil
import subprocess
import sys
from pathlib import Path

HERE = Path(__file__).resolve().parent
sys.path.insert(0, str(HERE.parent))

import keeper  # noqa: E402

EXAMPLE = HERE.parents[1] / "docs/examples/page/index.html"
WEB = HERE.parents[1] / "src/report/web"


def home(program: Path, said: dict, folder: Path) -> list:
    """What is wrong with the command that the page gave for home: its run must end with the page's checksum."""
    (folder / "page.toml").write_text(said["deck"], encoding="utf-8")
    command = [str(program), *shlex.split(said["command"])[1:], "--quiet", "--json", "--force"]
    done = subprocess.run(command, cwd=folder, capture_output=True, text=True, check=False)
    if done.returncode != 0:
        return [f"the command of the page fails: {done.stderr}"]
    found = json.loads(done.stdout)["stages"][-1]["checksum_at_end"]
    return [] if found == said["checksum"] else [f"{shlex.join(command)}: {found}, on the page {said['checksum']}"]


def main() -> int:
    parser = argparse.ArgumentParser()
    parser.add_argument("--ljmd", required=True, type=Path)
    parser.add_argument("--page", required=True, type=Path)
    parser.add_argument("--work", required=True, type=Path)
    parser.add_argument("--short", action="store_true")
    options = parser.parse_args()
    shutil.rmtree(options.work, ignore_errors=True)
    options.work.mkdir(parents=True)
    plan = options.work / "plan.json"
    plan.write_text(json.dumps({"page": str((options.page / "ljmd.html").resolve()), "packages": str(WEB), "browser": shutil.which("chromium"),
                                "pictures": str(options.work.resolve()), "example": str(EXAMPLE), "short": options.short}), encoding="utf-8")
    failed = subprocess.run(["node", HERE / "page_test.mjs", plan], check=False).returncode != 0
    said = json.loads((options.work / "home.json").read_text(encoding="utf-8"))
    example = json.loads((options.work / "example.json").read_text(encoding="utf-8"))
    deck = re.search(r"const deck = `\n(.*?)`", EXAMPLE.read_text(encoding="utf-8"), re.DOTALL)[1]
    wrong = home(options.ljmd.resolve(), said, options.work)
    wrong += home(options.ljmd.resolve(), {"deck": deck, "command": "ljmd run page.toml", **example}, options.work)
    print("\n".join(f"FAIL {words}" for words in wrong))
    return 1 if failed or wrong else 0


if __name__ == "__main__":
    sys.exit(keeper.kept(main))
