#!/usr/bin/env python3
"""The table of tools/argon, as the documentation shows it, is what the program finds.

    argon_table.py --ljmd PROGRAM [--update]

docs/argon.md has the whole table, README.md, docs/index.md and docs/paper/paper.md some of its lines. --update writes them
anew, where numbers are meant to change. tools/claims compares the same lines.
"""

from __future__ import annotations

import argparse
import re
import subprocess
import sys
import tempfile
from pathlib import Path

ROOT = Path(__file__).resolve().parents[2]
BLOCK = re.compile(r"(?<=```text\n).*?(?=```)", re.S)
PAGES = ("docs/argon.md", "README.md", "docs/index.md", "docs/paper/paper.md")
EXCERPT = re.compile(r"^  observable +mean \+- error +unit +n\*?\n(?:  \w+ .*\n)+$")


def found(ljmd: Path) -> list[str]:
    """The lines that the run prints, without its last ones, which name the files."""
    with tempfile.TemporaryDirectory(prefix="ljmd-argon-") as folder:
        said = subprocess.run([ljmd, "run", ROOT / "inputs/verlet1967/argon-864.toml", "--quiet",
                               "--out", Path(folder) / "run"], capture_output=True, text=True, check=True).stdout
    return said.split("\nfiles: ")[0].splitlines()


def shown(page: str, text: str, lines: list[str]) -> str:
    """What a page should say: the whole table, or those lines of it that it names."""
    def right(match: re.Match[str]) -> str:
        block = match.group(0)
        if page == "docs/argon.md" and "in SI units" in block:
            return "\n".join(lines) + "\n"
        if not EXCERPT.match(block):
            return block
        names = [line.split()[0] for line in block.splitlines()]
        table = {line.split()[0]: line for line in reversed(lines) if line.split()}  # the first of several counts
        return "".join(table[name] + "\n" for name in names)
    return BLOCK.sub(right, text)


def main() -> int:
    parser = argparse.ArgumentParser(description=__doc__, formatter_class=argparse.RawDescriptionHelpFormatter)
    parser.add_argument("--ljmd", type=Path, required=True)
    parser.add_argument("--update", action="store_true")
    options = parser.parse_args()
    lines = found(options.ljmd)
    wrong = 0
    for page in PAGES:
        path = ROOT / page
        text = path.read_text(encoding="utf-8")
        wanted = shown(page, text, lines)
        assert sum(name in wanted for name in ("temperature", "coordination_number")) == 2, page
        if text == wanted:
            continue
        if options.update:
            path.write_text(wanted, encoding="utf-8")
            print(f"{page}: written")
            continue
        wrong += 1
        for old, new in zip(text.splitlines(), wanted.splitlines()):
            if old != new:
                print(f"{page} shows\n{old}\nbut the program finds\n{new}")
    return 1 if wrong else 0


if __name__ == "__main__":
    sys.exit(main())
