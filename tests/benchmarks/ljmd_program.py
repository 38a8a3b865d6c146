"""ljmd itself, by its command `bench`."""

from __future__ import annotations

import json
from dataclasses import dataclass
from pathlib import Path
from typing import Any, Optional

import workload
from programs import Measurement, Program, ProgramFailed, execute
from workload import Case

DECK = """title = "The Lennard-Jones melt"

[system]
{system}

[potential]
{potential}
cutoff = {cutoff!r}

[neighbors]
skin = {skin!r}
{every}
[performance]
precision = "{precision}"

[[stage]]
name = "melt"
time_step = {time_step!r}
steps = {steps}

[output]
thermo = {{ every = {thermo_every} }}
"""

MELT_POTENTIAL = 'type = "lennard-jones"\ntruncation = "cut"\ntail = false'

DETAILS = ("simd", "threads", "lists", "list_rebuilds", "seconds_per_phase", "bytes_per_atom")


@dataclass(frozen=True)
class Variant:
    """A way of running ljmd: its precision, and the instructions it may use (None: the best it finds)."""

    precision: str
    simd: Optional[str] = None

    @property
    def name(self) -> str:
        return " ".join(["ljmd", self.precision, *([self.simd] if self.simd else [])])


def deck(system: str, precision: str, policy: str, steps: int, cutoff: float = workload.CUTOFF,
         potential: str = MELT_POTENTIAL) -> str:
    """A deck that does the work of workload.py on the `system` and with the `potential`, the lines of these sections."""
    every = f"every = {workload.REBUILD_EVERY}\n" if policy == "fixed" else ""
    return DECK.format(system=system, potential=potential, cutoff=cutoff, skin=workload.SKIN, every=every, precision=precision, steps=steps,
                       time_step=workload.TIME_STEP, thermo_every=workload.THERMO_EVERY)


def from_file(path: Path) -> str:
    """The lines of [system] that start from a file, as it is."""
    return f"file = {json.dumps(str(path.resolve()))}"


def bench(ljmd: Path, deck_file: Path, variant: Variant, threads: int, *settings: str) -> dict[str, Any]:
    """What `ljmd bench` says of a deck. Raises ProgramFailed when it fails or something is missing."""
    simd = ["--simd", variant.simd] if variant.simd else []
    changes = [word for setting in settings for word in ("--set", setting)]
    command = [ljmd.resolve(), "bench", deck_file, *changes, "--threads", threads, *simd, "--json"]
    return parse_bench(execute(command, deck_file.parent))


def parse_bench(text: str) -> dict[str, Any]:
    """The object that `ljmd bench --json` prints, with the keys that are needed here."""
    try:
        found = json.loads(text)
        for key in ("atoms", "steps", "atom_steps_per_second", "potential_energy_initial", "potential_energy_final",
                    "total_energy_final"):
            if not isinstance(found[key], (int, float)):
                raise ProgramFailed(f"ljmd bench: '{key}' is {found[key]!r}")
        return found
    except (json.JSONDecodeError, KeyError, TypeError) as error:
        raise ProgramFailed(f"ljmd bench: cannot read its answer: {error!r}") from None


class Ljmd(Program):
    def __init__(self, path: Path, variant: Variant):
        self.path = path
        self.variant = variant
        self.name = variant.name
        self.precision = variant.precision

    def identify(self) -> Optional[dict[str, Any]]:
        try:
            info = json.loads(execute([self.path.resolve(), "info", "--json"], Path.cwd()))
        except (ProgramFailed, json.JSONDecodeError):
            return None
        return {key: info.get(key) for key in ("version", "commit", "compiler", "build_type", "flags", "simd")}

    def deck_file(self, case: Case) -> Path:
        return case.folder / f"{self.name.replace(' ', '-')}.toml"

    def prepare(self, case: Case) -> None:
        start = case.file("start.data", workload.write_lammps_data)
        self.deck_file(case).write_text(deck(from_file(start), self.precision, case.policy, steps=0))

    def run(self, case: Case, steps: int, threads: int) -> Measurement:
        found = bench(self.path, self.deck_file(case), self.variant, threads, f"stage.melt.steps={steps}")
        rate = found["atom_steps_per_second"]
        return Measurement(
            steps=steps,
            seconds=case.atoms * steps / rate,
            rate=rate,
            potential_energy_initial=found["potential_energy_initial"],
            potential_energy_final=found["potential_energy_final"],
            total_energy_final=found["total_energy_final"],
            details={key: found.get(key) for key in DETAILS},
        )
