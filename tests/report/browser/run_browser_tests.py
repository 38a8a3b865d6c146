#!/usr/bin/env python3
"""Tests of the page that `ljmd report` writes, in a real browser.

    run_browser_tests.py --ljmd PROGRAM --work FOLDER [--short] the page in Chromium; --short: of one run, on a screen
    run_browser_tests.py --ljmd PROGRAM --work FOLDER --print   pages on paper: how many sheets, and how much of them is white
    run_browser_tests.py --bundle --work FOLDER                 the committed bundle is what its sources give

Runs are made by the program, and their pages by `ljmd report`; kinds that take long to compute (sweeps, reproductions,
comparisons) are shown from made payloads. The checks are in page_test.mjs, those of paper here.

Needs chromium, nodejs and npm, for paper also pdftoppm, and at the first call in a build folder the network, for `npm ci` from the lock file in
src/report/web. Exit codes: 0 all is well, 1 it is not, 77 something is missing here (1 with LJMD_REQUIRE_PEERS=1 in the
environment).
"""

import argparse
import json
import os
import shutil
import subprocess
import sys
from pathlib import Path

HERE = Path(__file__).resolve().parent
sys.path.insert(0, str(HERE.parents[1]))

import keeper  # noqa: E402
import waiting  # noqa: E402

WEB = HERE.parents[2] / "src/report/web"
SKIPPED = 77

HOSTILE = """<img src=x onerror="window.broken=1"></script><script>window.broken=1</script> "quotes' & \u202egnp.exe"""

FLUID = """
title = {title}
units = "reduced"
[argon]
sigma = "3.405 angstrom"
epsilon = "119.8 K"
mass = "39.948 u"
[system]
lattice = {{ type = "fcc", cells = 4 }}
density = 0.8
temperature = 1.0
seed = {seed}
[potential]
type = "lennard-jones"
cutoff = 2.5
truncation = "cut"
tail = true
[neighbors]
method = "verlet-list"
skin = 0.3
[[stage]]
name = "melt"
time_step = 0.004
steps = 500
temperature = 1.0
thermostat = {{ type = "rescale", every = 20 }}
[[stage]]
name = "production"
time_step = 0.004
steps = 2000
sample = true
[output]
directory = "unused"
thermo = {{ every = 10 }}
trajectory = {{ format = "h5md", every = 100, velocities = true }}
[analysis]
rdf = {{ bins = 100, every = 50 }}
"""

MANY_ANALYSES = FLUID + """structure_factor = {{ every = 50 }}
msd = {{}}
vacf = {{ max_time = 1.0 }}
viscosity = {{ max_time = 0.5 }}
van_hove = {{}}
van_hove_distinct = {{}}
"""

# Sheets of A4 and of US letter that a page takes at most. A run of many analyses takes 4 and 5; the others may be as long
# as is said here, or have the room of a row of charts left.
SHEETS = {"fluid": 6, "bodies": 2, "sweep": 3, "reproduction": 3, "comparison": 1}
# White at the end of a sheet that is not the last, of the height between the margins: a row of charts with the heading
# above it may be left over (0.2 and 0.05), and 0.03 is for fonts.
MOST_WHITE = 0.28
MARGIN = 12  # mm


class Missing(Exception):
    """Something that the tests need and this computer lacks."""


def tool(*names: str) -> str:
    for name in names:
        found = shutil.which(name)
        if found:
            return found
    raise Missing(f"no {names[0]} (tools/setup --tests installs it)")


def install(work: Path) -> Path:
    """The packages of the lock file, installed once in a build folder; the folder with a copy of the page's sources."""
    node, npm = tool("node", "nodejs"), tool("npm")
    home = work / "web"
    lock = (WEB / "package-lock.json").read_bytes()
    stamp = home / "installed.json"
    if not stamp.exists() or stamp.read_bytes() != lock:
        shutil.rmtree(home, ignore_errors=True)
        home.mkdir(parents=True)
        for name in ("package.json", "package-lock.json"):
            shutil.copy(WEB / name, home)
        done = subprocess.run([npm, "ci", "--ignore-scripts", "--no-audit", "--no-fund"], cwd=home, capture_output=True,
                              text=True, timeout=waiting.PATIENCE)
        if done.returncode != 0:
            raise Missing(f"npm ci failed, so there are no packages to test with (is there a network?):\n{done.stderr[-1500:]}")
        stamp.write_bytes(lock)
    version = subprocess.run([node, "--version"], capture_output=True, text=True, check=True).stdout.strip()
    if int(version.lstrip("v").split(".")[0]) < 18:
        raise Missing(f"node {version}; 18 or newer is needed")
    return home


def check_bundle(work: Path) -> int:
    """Builds the bundle again and compares it, byte by byte, with what is committed."""
    home = install(work)
    for path in sorted(WEB.iterdir()):  # all that is there, so that a new source is not forgotten
        if path.name in ("node_modules", "dist"):
            continue
        if path.is_dir():
            shutil.rmtree(home / path.name, ignore_errors=True)
            shutil.copytree(path, home / path.name)
        else:
            shutil.copy(path, home)
    built = home / "built"
    shutil.rmtree(built, ignore_errors=True)
    subprocess.run([tool("node", "nodejs"), "build.mjs", str(built)], cwd=home, check=True, timeout=waiting.PATIENCE)
    committed = WEB / "dist"
    names = sorted({path.name for folder in (built, committed) for path in folder.iterdir()})
    other = [name for name in names if not (built / name).exists() or not (committed / name).exists()
             or (built / name).read_bytes() != (committed / name).read_bytes()]
    for name in other:
        print(f"FAIL {name}: dist/ is not what the sources give; run `npm ci && node build.mjs` in src/report/web")
    print(f"{len(names) - len(other)} passed, {len(other)} failed")
    return 1 if other else 0


def run(program: str, *arguments: str) -> str:
    done = subprocess.run([program, *arguments], capture_output=True, text=True, timeout=waiting.PATIENCE, check=False)
    if done.returncode != 0:
        raise RuntimeError(f"{' '.join([program, *arguments])}: exit code {done.returncode}\n{done.stderr[-1500:]}")
    return done.stdout


def make_pages(program: str, folder: Path, short: bool) -> list[dict]:
    """Runs, and the pages about them: [{name, page, payload, results}]."""
    seeds = {"fluid": 1} if short else {"fluid": 1, "other": 2}
    for name, seed in seeds.items():
        deck = folder / f"{name}.toml"
        deck.write_text(FLUID.format(title=json.dumps(HOSTILE + name), seed=seed), encoding="utf-8")
        run(program, "run", str(deck), "--out", str(folder / name))
    wanted = {"fluid": ["fluid"]} if short else {"fluid": ["fluid"], "bodies": ["bodies"], "both": ["fluid", "other"]}
    figure_eight = HERE.parents[2] / "inputs/fewbody/figure-eight.toml"
    if not short:
        run(program, "run", str(figure_eight), "--out", str(folder / "bodies"))
    pages = []
    for name, directories in wanted.items():
        paths = [str(folder / directory) for directory in directories]
        page, payload = folder / f"{name}.html", folder / f"{name}.json"
        run(program, "report", *paths, "--out", str(page))
        payload.write_text(run(program, "report", *paths, "--json"), encoding="utf-8")
        results = folder / name / "results.json"
        pages.append({"name": name, "page": str(page), "payload": str(payload),
                      "results": str(results) if results.exists() else None})
    return pages


def check_pages(program: str, work: Path, short: bool) -> int:
    browser = os.environ.get("LJMD_CHROMIUM") or tool("chromium", "chromium-browser", "google-chrome")
    home = install(work)
    folder = work / ("short" if short else "pages")
    shutil.rmtree(folder, ignore_errors=True)
    folder.mkdir(parents=True)
    plan = {"browser": browser, "packages": str(home / "node_modules"), "folder": str(folder), "hostile": HOSTILE,
            "short": short, "pages": make_pages(program, folder, short)}
    (folder / "plan.json").write_text(json.dumps(plan), encoding="utf-8")
    return subprocess.run([tool("node", "nodejs"), str(HERE / "page_test.mjs"), str(folder / "plan.json")], check=False,
                          timeout=waiting.PATIENCE).returncode


def white_ends(pdf: Path) -> list[float]:
    """The white part at the end of each sheet, of the height between the margins."""
    pictures = pdf.parent / f"{pdf.stem}-sheets"
    shutil.rmtree(pictures, ignore_errors=True)
    pictures.mkdir()
    subprocess.run([tool("pdftoppm"), "-gray", "-r", "40", str(pdf), str(pictures / "sheet")], check=True,
                   timeout=waiting.PATIENCE)
    ends = []
    for picture in sorted(pictures.iterdir()):
        _, size, _, pixels = picture.read_bytes().split(b"\n", 3)
        width, height = map(int, size.split())
        margin = round(MARGIN / 25.4 * 40)
        inked = [row for row in range(height) if min(pixels[row * width:(row + 1) * width]) < 250]
        ends.append(max(0.0, 1.0 - (max(inked, default=margin) - margin) / (height - 2 * margin)))
    return ends


def check_paper(program: str, work: Path) -> int:
    tool("pdftoppm")
    browser = os.environ.get("LJMD_CHROMIUM") or tool("chromium", "chromium-browser", "google-chrome")
    home = install(work)
    folder = work / "paper"
    shutil.rmtree(folder, ignore_errors=True)
    folder.mkdir(parents=True)
    for name, text in {"fluid": MANY_ANALYSES, "deck": FLUID}.items():
        (folder / f"{name}.toml").write_text(text.format(title=json.dumps("Argon"), seed=1), encoding="utf-8")
    deck, small = str(folder / "deck.toml"), ["--set", "stage.melt.steps=100", "--set", "stage.production.steps=200"]
    run(program, "run", str(folder / "fluid.toml"), "--out", str(folder / "fluid"))
    run(program, "run", str(HERE.parents[2] / "inputs/fewbody/figure-eight.toml"), "--out", str(folder / "bodies"))
    run(program, "sweep", deck, *small, "--grid", "system.density=0.6|0.8,system.temperature=1|2", "--out",
        str(folder / "sweep"))
    pages = []
    for name in ("fluid", "bodies", "sweep"):
        payload = folder / f"{name}.json"
        payload.write_text(run(program, "report", str(folder / name), "--json"), encoding="utf-8")
        pages.append({"name": name, "payload": str(payload)})
    plan = {"browser": browser, "packages": str(home / "node_modules"), "folder": str(folder), "pages": pages}
    (folder / "plan.json").write_text(json.dumps(plan), encoding="utf-8")
    failed = subprocess.run([tool("node", "nodejs"), str(HERE / "print_test.mjs"), str(folder / "plan.json")],
                            check=False, timeout=waiting.PATIENCE).returncode
    for name, most in SHEETS.items():
        for size in ("A4", "Letter"):
            ends = white_ends(folder / f"{name}-{size}.pdf")
            worst = max(ends[:-1], default=0.0)
            sound = len(ends) <= most and worst <= MOST_WHITE
            failed += not sound
            print(f"{'  ok' if sound else 'FAIL'} {name} on {size}: {len(ends)} sheets (at most {most}), white at their ends "
                  f"{' '.join(f'{end:.2f}' for end in ends)} (at most {MOST_WHITE} but on the last)")
    return 1 if failed else 0


def main() -> int:
    parser = argparse.ArgumentParser()
    parser.add_argument("--ljmd")
    parser.add_argument("--work", required=True, type=Path)
    parser.add_argument("--bundle", action="store_true")
    parser.add_argument("--short", action="store_true")
    parser.add_argument("--print", action="store_true")
    arguments = parser.parse_args()
    work = arguments.work.resolve()
    try:
        if arguments.bundle:
            return check_bundle(work)
        program = str(Path(arguments.ljmd).resolve())
        return check_paper(program, work) if arguments.print else check_pages(program, work, arguments.short)
    except Missing as missing:
        required = os.environ.get("LJMD_REQUIRE_PEERS") == "1"
        print(f"{'FAIL, as LJMD_REQUIRE_PEERS=1' if required else 'skipped'}: {missing}")
        return 1 if required else SKIPPED


if __name__ == "__main__":
    sys.exit(keeper.kept(main))
