"""LAMMPS, with its plain pair style lj/cut or the faster one of its package OPT."""

from __future__ import annotations

import os
import re
import shutil
from pathlib import Path
from typing import Any, Optional

import workload
from programs import Measurement, Program, ProgramFailed, execute
from workload import Case

EXECUTABLE = "lmp"
NEIGHBOURS = {
    "fixed": f"delay 0 every {workload.REBUILD_EVERY} check no",
    "strict": "delay 0 every 1 check yes",
}
INPUT = """units lj
atom_style atomic
read_data {start}
pair_style lj/cut {cutoff!r}
pair_coeff 1 1 1.0 1.0
pair_modify shift no tail no
neighbor {skin!r} bin
neigh_modify {neighbours}
fix 1 all nve
timestep {time_step!r}
thermo {thermo_every}
thermo_style custom step pe etotal
thermo_modify norm yes format float %.15g
run {steps}
"""


def parse_log(text: str) -> tuple[int, float, list[tuple[int, float, float]]]:
    """Steps, seconds of the time loop, and rows (step, U/N, E/N) of a log. Raises ProgramFailed without them."""
    loop = re.search(r"^Loop time of (\S+) on \d+ procs? for (\d+) steps", text, re.M)
    table = re.search(r"^\s*Step\s+PotEng\s+TotEng\s*\n(.*?)^Loop time", text, re.M | re.S)
    if not loop or not table:
        raise ProgramFailed("lmp: no time of the loop in its log")
    fields = [line.split() for line in table.group(1).splitlines()]
    rows = [(int(row[0]), float(row[1]), float(row[2])) for row in fields if len(row) == 3 and row[0].isdigit()]
    if len(rows) < 2:
        raise ProgramFailed("lmp: no energies in its log")
    return int(loop.group(2)), float(loop.group(1)), rows


class Lammps(Program):
    """On several cores each has a process of MPI: Debian's LAMMPS has no threads in these pair styles."""

    precision = "double"
    note = "n cores by mpirun -np n"

    def __init__(self, suffix: Optional[str] = None):
        self.suffix = suffix
        self.name = f"lammps-{suffix}" if suffix else "lammps"

    def identify(self) -> Optional[dict[str, Any]]:
        if not shutil.which(EXECUTABLE):
            return None
        try:
            said = execute([EXECUTABLE, "-h"], Path.cwd())
        except ProgramFailed:
            return None
        packages = re.search(r"Installed packages:\s*\n\s*\n(.*?)\n\s*\n", said, re.S)
        if self.suffix and (not packages or self.suffix.upper() not in packages.group(1).split()):
            return None
        version = re.search(r"Massively Parallel Simulator - (.*)", said)
        compiler = re.search(r"^Compiler: (.*)", said, re.M)
        return {"version": version.group(1) if version else "", "compiler": compiler.group(1) if compiler else ""}

    def prepare(self, case: Case) -> None:
        case.file("start.data", workload.write_lammps_data)

    def run(self, case: Case, steps: int, threads: int) -> Measurement:
        text = INPUT.format(start="start.data", cutoff=workload.CUTOFF, skin=workload.SKIN, steps=steps,
                            time_step=workload.TIME_STEP, neighbours=NEIGHBOURS[case.policy],
                            thermo_every=workload.THERMO_EVERY)
        (case.folder / "in.lj").write_text(text)
        command = [EXECUTABLE, "-in", "in.lj", "-log", "none", *(["-sf", self.suffix] if self.suffix else [])]
        steps, seconds, rows = parse_log(execute([*mpi(threads), *command], case.folder, OMP_NUM_THREADS="1"))
        return Measurement(steps, seconds, case.atoms * steps / seconds, rows[0][1], rows[-1][1], rows[-1][2])


def mpi(processes: int) -> list[str]:
    """The words before a command that has this many processes. Open MPI must be told that root may do it.

    Processes are not bound to cores, as the threads of the other programs are not."""
    if processes == 1:
        return []
    root = ["--allow-run-as-root"] if os.geteuid() == 0 else []
    return ["mpirun", *root, "--bind-to", "none", "-np", str(processes)]
