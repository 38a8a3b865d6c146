"""OpenMM's CPU platform, in a Python process of its own (openmm_melt.py)."""

from __future__ import annotations

import json
import sys
from pathlib import Path
from typing import Any, Optional

import workload
from programs import Measurement, Program, ProgramFailed, execute
from workload import Case

SCRIPT = Path(__file__).resolve().with_name("openmm_melt.py")


class OpenMM(Program):
    """Leapfrog, which is velocity Verlet here as with GROMACS; its reported kinetic energy is that of the full step."""

    name = "openmm"
    precision = "mixed"
    note = "leapfrog; list policy always strict, with a skin of its own choice"

    def identify(self) -> Optional[dict[str, Any]]:
        try:
            return json.loads(execute([sys.executable, SCRIPT, "--identify"], Path.cwd()))
        except (ProgramFailed, json.JSONDecodeError):
            return None

    def prepare(self, case: Case) -> None:
        case.file("start.npz", workload.write_numpy)

    def run(self, case: Case, steps: int, threads: int) -> Measurement:
        said = execute([sys.executable, SCRIPT, "start.npz", steps, threads], case.folder)
        found = json.loads(said)
        return Measurement(steps, found["seconds"], case.atoms * steps / found["seconds"],
                           found["potential_energy_initial"], found["potential_energy_final"],
                           found["total_energy_final"])
