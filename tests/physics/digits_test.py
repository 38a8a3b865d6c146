"""One set of digits: every deck, and every plug-in, has the same bytes on every SIMD level, with and without the fused
multiply-adds of the C library, and those of digits.txt on every machine.

    digits_test.py --ljmd PROGRAM [--all] [--update]      --all: every level of this machine, not the lowest and the default alone
"""

import argparse
import hashlib
import os
import pathlib
import shutil
import subprocess
import sys
import tempfile

ROOT = pathlib.Path(__file__).resolve().parents[2]
sys.path.insert(0, str(ROOT / "tests"))
sys.path.insert(0, str(ROOT / "tests/cli"))
import decks  # noqa: E402, the settings that make a deck short

KNOWN = pathlib.Path(__file__).with_name("digits.txt")
WITH_OTHER_DIGITS = "x86-64-v4-intel"  # says so itself, see docs/digits.md
WITHOUT_FUSED_PRODUCTS = ("portable", "x86-64-v2")  # where pairs in single precision are rounded twice
OF_FEW_BODIES = "prince-dormand"  # which decks of inputs/ have
FILES = ("final.xyz", "thermo.csv", "trajectory.xyz", "trajectory.csv")
LIBM_WITHOUT_FMA = "glibc.cpu.hwcaps=-FMA,-FMA4,-FMA_Usable,-FMA4_Usable"

FLUID = """[system]
lattice = {{ type = "fcc", cells = 4 }}
density = {density}
temperature = 1.2
seed = 7
[potential]
type = "{potential}"
{parameters}cutoff = 2.2
truncation = "{truncation}"
{more}[neighbors]
method = "{method}"
[performance]
precision = "{precision}"
[[stage]]
name = "all"
integrator = "{integrator}"
time_step = {time_step}
steps = 60
{stage}[output]
thermo = {{ every = 5 }}
trajectory = {{ format = "xyz", every = 20, velocities = true }}
"""


def fluid(integrator="velocity-verlet", thermostat="", barostat="", potential="lennard-jones", truncation="shifted", method="verlet-list",
          precision="double", density=0.8, time_step=0.003) -> str:
    stage = f"thermostat = {{ {thermostat} }}\n" if thermostat else ""
    stage += f"barostat = {{ {barostat} }}\n" if barostat else ""
    more = {"cut": "tail = true\n", "switched": "tail = true\nswitch_start = 1.8\n"}.get(truncation, "")
    parameters = "well_depth = 1.1\nsteepness = 5.5\nminimum = 1.13\n" if potential == "morse" else ""
    return FLUID.format(**{**locals()})


def made_decks(plugins: dict) -> dict:
    """One for each plug-in of the engine. @param plugins  see plugins_in()"""
    made = {f"truncation {name}": fluid(truncation=name) for name in plugins["truncations"]}
    made |= {f"morse {name}": fluid(potential="morse", truncation=name) for name in ("cut", "switched")}
    made |= {f"search {name}": fluid(method=name) for name in ("cells", "all-pairs")}
    made |= {f"morse, search {name}": fluid(potential="morse", method=name, truncation="force-shifted") for name in ("cells",)}
    made |= {f"integrator {name}": fluid(integrator=name, time_step=0.0003) for name in plugins["integrators"] if name != OF_FEW_BODIES}
    baths = {"rescale": 'type = "rescale", every = 7', "langevin": 'type = "langevin", time = 0.3', "andersen": 'type = "andersen", time = 0.2',
             "stochastic-rescaling": 'type = "stochastic-rescaling", time = 0.1', "nose-hoover-chain": 'type = "nose-hoover-chain", time = 0.1'}
    made |= {f"thermostat {name}": fluid(thermostat=baths[name]) for name in plugins["thermostats"]}
    for name in plugins["barostats"]:
        made[f"barostat {name}"] = fluid(thermostat=baths["stochastic-rescaling"], barostat=f'type = "{name}", pressure = 1.0, time = 0.5')
    made |= {f"mixed, {name}": fluid(precision="mixed", truncation=name) for name in ("cut", "force-shifted", "switched")}
    made["mixed, morse"] = fluid(precision="mixed", potential="morse")
    made["a gas"] = fluid(density=0.02)
    return made


class Case:
    def __init__(self, name: str, deck: pathlib.Path, settings: list):
        self.name, self.deck, self.settings = name, deck, settings
        self.mixed = "mixed" in name or 'precision = "mixed"' in deck.read_text(encoding="utf-8")

    def digits(self, program: str, level: str, folder: pathlib.Path, threads: int = 1, environment: "dict | None" = None) -> str:
        out = folder / "out"
        shutil.rmtree(out, ignore_errors=True)
        done = subprocess.run([program, "run", self.deck, "--quiet", "--simd", level, "--threads", str(threads), "--out", out, *self.settings],
                              capture_output=True, text=True, check=False, env={**os.environ, **(environment or {})}, cwd=folder)
        if done.returncode != 0:
            raise SystemExit(f"FAIL {self.name} at {level}: exit code {done.returncode}\n{done.stderr}")
        found = hashlib.sha256()
        for name in FILES:
            if (out / name).exists():
                found.update((out / name).read_bytes())
        return found.hexdigest()[:16]


def plugins_in(info: str) -> dict:
    """Names by their kind, from what `ljmd info` prints."""
    return {kind: names.strip().split(", ") for kind, _, names in (line.partition(" ") for line in info.splitlines())}


def cases(program: str, plugins: dict, folder: pathlib.Path):
    start = next(deck for deck in decks.decks() if deck.stem == "canonical")
    begun = folder / "start"
    subprocess.run([program, "run", start, "--quiet", "--simd", "portable", "--out", begun, *decks.shortened(start.read_text(encoding="utf-8"))],
                   capture_output=True, check=True)
    for deck in decks.decks():
        text = deck.read_text(encoding="utf-8")
        settings = decks.shortened(text)
        if "\nfile = " in text:
            settings += ["--set", f"system.file={begun}"]
        if "format = \"h5md\"" in text or "trajectory = " in text and "format" not in text:
            settings += ["--set", f"output.trajectory.format={'csv' if decks.is_few_body(deck) else 'xyz'}"]
        yield Case(str(deck.relative_to(ROOT / "inputs")), deck, settings)
    for number, (name, text) in enumerate(made_decks(plugins).items()):
        deck = folder / f"made-{number}.toml"
        deck.write_text(text, encoding="utf-8")
        yield Case(name, deck, [])


def main() -> int:
    parser = argparse.ArgumentParser()
    parser.add_argument("--ljmd", required=True)
    parser.add_argument("--all", action="store_true")
    parser.add_argument("--update", action="store_true")
    arguments = parser.parse_args()
    arguments.ljmd = os.path.abspath(arguments.ljmd)
    usable = subprocess.run([arguments.ljmd, "info"], capture_output=True, text=True, check=True).stdout
    plugins = plugins_in(usable)
    levels = [level.strip() for level in usable.split("usable here:")[1].split(")")[0].split(",") if WITH_OTHER_DIGITS not in level]
    fused = [level for level in levels if level not in WITHOUT_FUSED_PRODUCTS]
    if not arguments.all:
        levels = sorted({levels[0], *fused[:1], levels[-1]})
    known = {line[:-17]: line[-16:] for line in KNOWN.read_text(encoding="utf-8").splitlines()} if KNOWN.exists() else {}
    found, failures = {}, []
    with tempfile.TemporaryDirectory(prefix="ljmd-digits-") as name:
        folder = pathlib.Path(name)
        for case in cases(arguments.ljmd, plugins, folder):
            for kind in ("fused", "unfused") if case.mixed else ("",):
                those = [level for level in levels if not kind or (level not in WITHOUT_FUSED_PRODUCTS) == (kind == "fused")]
                key = f"{case.name} ({kind})" if kind else case.name
                digits = {f"{level}": case.digits(arguments.ljmd, level, folder) for level in those}
                if those:
                    digits["two threads"] = case.digits(arguments.ljmd, those[0], folder, threads=2)
                    digits["a C library without FMA"] = case.digits(arguments.ljmd, those[0], folder, environment={"GLIBC_TUNABLES": LIBM_WITHOUT_FMA})
                    found[key] = next(iter(digits.values()))
                    if len(set(digits.values())) > 1 or not arguments.update and known.get(key) != found[key]:
                        failures.append(f"{key}: {digits}, known: {known.get(key)}")
    for failure in failures:
        print("FAIL", failure)
    if arguments.update and not failures:
        KNOWN.write_text("".join(f"{key} {digits}\n" for key, digits in sorted({**known, **found}.items())), encoding="utf-8")
    print(f"{len(found)} decks at {', '.join(levels)}; {len(failures)} with other digits")
    return 1 if failures else 0


if __name__ == "__main__":
    sys.exit(main())
