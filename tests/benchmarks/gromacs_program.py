"""GROMACS, in mixed or in double precision, with threads of OpenMP."""

from __future__ import annotations

import re
import shutil
from pathlib import Path
from typing import Any, Optional

import workload
from programs import Measurement, Program, ProgramFailed, execute
from workload import Case

# GROMACS never looks how far atoms have moved: of our policies it knows the fixed one alone. Its buffer is set as that
# of the others; by default GROMACS would choose one from the temperature.
PARAMETERS = f"""integrator = md
dt = {workload.TIME_STEP!r}
nsteps = -1
cutoff-scheme = Verlet
nstlist = {workload.REBUILD_EVERY}
verlet-buffer-tolerance = -1
rlist = {workload.CUTOFF + workload.SKIN!r}
rvdw = {workload.CUTOFF!r}
rcoulomb = {workload.CUTOFF!r}
vdwtype = Cut-off
vdw-modifier = None
coulombtype = Cut-off
coulomb-modifier = None
DispCorr = no
comm-mode = None
tcoupl = no
pcoupl = no
gen-vel = no
constraints = none
nstcalcenergy = {workload.THERMO_EVERY}
nstenergy = {workload.THERMO_EVERY}
nstlog = {workload.THERMO_EVERY}
"""
TOPOLOGY = """[ defaults ]
1 2 no 1.0 1.0
[ atomtypes ]
LJ 1.0 0.0 A 1.0 1.0
[ moleculetype ]
LJ 1
[ atoms ]
1 LJ 1 LJ LJ 1 0.0 1.0
[ system ]
Lennard-Jones fluid
[ molecules ]
LJ {atoms}
"""


def parse_log(text: str) -> float:
    """Wall seconds of the time loop from md.log. Raises ProgramFailed without them."""
    found = re.search(r"^ +Core t \(s\) +Wall t \(s\) +\(%\)\s*\n +Time: +\S+ +(\S+)", text, re.M)
    if not found:
        raise ProgramFailed("gmx mdrun: no accounting of time in its log")
    return float(found.group(1))


def parse_energies(text: str) -> list[tuple[float, float, float]]:
    """Rows (time, U, E) of the whole system from a file of `gmx energy`. Raises ProgramFailed without two."""
    lines = [line.split() for line in text.splitlines() if line.strip() and line[0] not in "#@"]
    if len(lines) < 2 or any(len(line) != 3 for line in lines):
        raise ProgramFailed("gmx energy: no energies in its answer")
    return [(float(time), float(potential), float(total)) for time, potential, total in lines]


class Gromacs(Program):
    """Leapfrog from the same velocities is velocity Verlet here: forces on a perfect crystal vanish.

    So the velocities half a step before the start, which leapfrog begins with, are those of the start. The total energy
    that GROMACS reports has the mean kinetic energy of two half steps in it, which is higher than that of the full step
    by (dt^2/8) a^2 an atom, about 0.002.
    """

    note = "leapfrog; list policy always fixed"

    def __init__(self, double: bool = False):
        self.executable = "gmx_d" if double else "gmx"
        self.name = "gromacs-double" if double else "gromacs"
        self.precision = "double" if double else "mixed"

    def tolerance(self, atoms: int) -> float:
        """In mixed precision N/4 terms, one a cluster, are added up in single precision: in a crystal they are alike,
        and may all be rounded the same way."""
        return super().tolerance(atoms) if self.precision == "double" else max(1e-6, atoms / 4 * 2.0**-24)

    def identify(self) -> Optional[dict[str, Any]]:
        if not shutil.which(self.executable):
            return None
        try:
            said = execute([self.executable, "-quiet", "--version"], Path.cwd())
        except ProgramFailed:
            return None
        names = {"version": "GROMACS version", "simd": "SIMD instructions", "compiler": "C\\+\\+ compiler",
                 "flags": "C\\+\\+ compiler flags", "precision": "Precision"}
        found = {key: re.search(rf"^{name}: +(.*)", said, re.M) for key, name in names.items()}
        return {key: match.group(1) if match else "" for key, match in found.items()}

    def gmx(self, folder: Path, *words: Any, typed: str = "") -> str:
        return execute([self.executable, "-quiet", *words], folder, typed, GMX_MAXBACKUP="-1")

    def prepare(self, case: Case) -> None:
        case.file("start.gro", workload.write_gro)
        (case.folder / "melt.mdp").write_text(PARAMETERS)
        (case.folder / "melt.top").write_text(TOPOLOGY.format(atoms=case.atoms))
        # One warning is known: that the motion of the centre of mass is left alone, as in the other programs.
        self.gmx(case.folder, "grompp", "-f", "melt.mdp", "-c", "start.gro", "-p", "melt.top", "-o", f"{self.name}.tpr",
                 "-po", "all.mdp", "-maxwarn", "1")

    def run(self, case: Case, steps: int, threads: int) -> Measurement:
        """One step less: the loop evaluates the forces of the start, too, and builds the first list; the others do so
        before theirs. So all evaluate forces `steps` times and build a list every 20 evaluations."""
        return self.mdrun(case, steps - 1, threads)

    def check(self, case: Case, steps: int) -> Measurement:
        return self.mdrun(case, steps, 1)

    def mdrun(self, case: Case, steps: int, threads: int) -> Measurement:
        for left in case.folder.glob(f"{self.name}.run.*"):
            left.unlink()
        self.gmx(case.folder, "mdrun", "-s", f"{self.name}.tpr", "-deffnm", f"{self.name}.run", "-nsteps", steps,
                 "-ntmpi", 1, "-ntomp", threads, "-pin", "off", "-noconfout", "-cpt", -1)
        seconds = parse_log((case.folder / f"{self.name}.run.log").read_text(errors="replace"))
        self.gmx(case.folder, "energy", "-f", f"{self.name}.run.edr", "-o", f"{self.name}.run.xvg", "-dp",
                 typed="Potential\nTotal-Energy\n\n")
        rows = parse_energies((case.folder / f"{self.name}.run.xvg").read_text())
        evaluations = steps + 1
        return Measurement(evaluations, seconds, case.atoms * evaluations / seconds, rows[0][1] / case.atoms,
                           rows[-1][1] / case.atoms, rows[-1][2] / case.atoms)
