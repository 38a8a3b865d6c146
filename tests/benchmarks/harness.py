#!/usr/bin/env python3
"""Times ljmd beside other programs on exactly the same work, the melt of workload.py.

    harness.py --ljmd PATH [--sizes N,N] [--threads n,n] [--peers a,b] [--precision double,mixed] [--simd LEVEL]
               [--policy fixed|strict] [--repeats 5] [--seconds 3] [--wait 0] [--share] [--engine FILE]... [--out DIR]
               [--quick]
    harness.py --redraw DIR        page and figures anew from DIR/benchmark.json

All programs start from the same positions and velocities, and must find the same potential energy for them. For each
size and number of threads, every round runs each program once, one after the other; what is reported of ljmd and a peer
is the median over the rounds of the ratio of their rates, with minimum and maximum. A peer that is not installed is
reported as absent; one that fails is reported, too, and the others go on. Every run is recorded with the number of
cores that other work kept busy meanwhile, and with its processor and wall time, start-up included. A run that did not
have the cores that it wanted is named, and the page says so. Engines of others enter with an adapter, see
foreign_program.py.

Writes DIR/benchmark.json (see report.py), DIR/benchmark.md and the figures rates.png, ratios.png and roofline.png
(DIR: runs/benchmark by default).
Exit codes: 0 ok, 1 a program failed, 2 usage, 3 a record cannot be read, 4 a file cannot be written.
"""

from __future__ import annotations

import argparse
import datetime
import sys
import tempfile
from dataclasses import asdict
from pathlib import Path
from typing import Any, Callable, Optional, Sequence

ROOT = Path(__file__).resolve().parents[2]
sys.path.insert(0, str(ROOT / "analysis"))
from script import reports_errors  # noqa: E402  (it finds the package ljmd)
import command_line  # noqa: E402
import figures  # noqa: E402
import machine  # noqa: E402
import report  # noqa: E402
import roofline  # noqa: E402
import style  # noqa: E402
import workload  # noqa: E402
from foreign_program import Foreign  # noqa: E402
from gromacs_program import Gromacs  # noqa: E402
from lammps_program import Lammps  # noqa: E402
from ljmd_program import Ljmd, Variant  # noqa: E402
from openmm_program import OpenMM  # noqa: E402
from programs import Measurement, Program, ProgramFailed  # noqa: E402
from report import Record  # noqa: E402
from ljmd.errors import Error, InputError  # noqa: E402
from workload import Case  # noqa: E402

PEERS: dict[str, Callable[[], Program]] = {
    "lammps": Lammps,
    "lammps-opt": lambda: Lammps("opt"),
    "gromacs": Gromacs,
    "gromacs-double": lambda: Gromacs(double=True),
    "openmm": OpenMM,
}
DEFAULT_PEERS = "lammps,lammps-opt,gromacs,openmm"
CHECK_STEPS = 100
LARGEST_CHECKED = 40_000  # atoms: a check of more would say nothing new


def numbers(text: str) -> list[int]:
    """Whole numbers above 0 between commas."""
    found = [int(word) for word in text.split(",")]
    if min(found) < 1:
        raise ValueError(text)
    return found


def words(text: str) -> list[str]:
    return [word for word in text.split(",") if word]


def parse(arguments: Optional[Sequence[str]]) -> argparse.Namespace:
    parser = command_line.parser("Time ljmd beside other programs on exactly the same work.", policy="fixed",
                                 out="runs/benchmark", quick="two small sizes, two rounds, short runs")
    parser.add_argument("--sizes", type=numbers, metavar="N,N", help="4 n^3 atoms each")
    parser.add_argument("--threads", type=numbers, metavar="n,n",
                        default=[count for count in (1, 2) if count <= machine.cores()])
    parser.add_argument("--peers", type=words, metavar="a,b", default=words(DEFAULT_PEERS),
                        help=f"of {', '.join(PEERS)}; '' for none")
    parser.add_argument("--precision", type=words, metavar="a,b", default=["double"], help="of double, mixed")
    parser.add_argument("--engine", type=Path, metavar="FILE", action="append", default=[],
                        help="an adapter for a program of yours; more than once for several")
    parser.add_argument("--wait", type=float, default=0.0, metavar="SECONDS",
                        help="wait at most so long before a run until other work leaves its cores idle")
    options = command_line.parse(parser, arguments,
                                 full={"sizes": list(workload.SIZES), "repeats": 5, "seconds": 3.0},
                                 quick={"sizes": [864, 4000], "repeats": 2, "seconds": 0.5})
    unknown = [name for name in options.peers if name not in PEERS]
    unknown += [name for name in options.precision if name not in roofline.REAL_BYTES]
    if unknown:
        parser.error(f"'{unknown[0]}' is not known")
    try:
        for atoms in options.sizes:
            workload.cells_of(atoms)
    except ValueError as error:
        parser.error(str(error))
    if max(options.threads) > machine.cores():
        parser.error(f"{max(options.threads)} threads, but {machine.cores()} cores")
    if options.repeats < 1 or not options.seconds > 0.0:
        parser.error("--repeats and --seconds must be above 0")
    return options


class Benchmark:
    """The programs, and the record that grows as they run."""

    def __init__(self, options: argparse.Namespace):
        self.options = options
        own = [Ljmd(options.ljmd, Variant(precision, options.simd)) for precision in options.precision]
        self.programs: list[Program] = [*own, *(PEERS[name]() for name in options.peers),
                                        *(Foreign(file) for file in options.engine)]
        names = [program.name for program in self.programs]
        for name in names:
            if names.count(name) > 1 or (name.split()[0] == "ljmd" and name not in [one.name for one in own]):
                raise InputError(f"two programs would be called '{name}'")
        identities = {program.name: program.identify() for program in self.programs}
        if identities[own[0].name] is None:
            raise InputError(f"{options.ljmd}: cannot be run; say where ljmd is with --ljmd")
        for name, identity in identities.items():
            if identity is None:
                say(f"{name}: absent")
        self.record = report.begin(
            date=datetime.datetime.now(datetime.timezone.utc).isoformat(timespec="seconds"),
            host=machine.describe(),
            ljmd=identities[own[0].name],
            options={"repeats": options.repeats, "seconds": options.seconds, "simd": options.simd,
                     "share": options.share},
            programs={program.name: {"precision": program.precision, "note": program.note,
                                     "identity": identities[program.name]} for program in self.programs},
            peaks=roofline.peaks(),
            policy=options.policy,
        )
        self.programs = [program for program in self.programs if identities[program.name] is not None]

    def run(self) -> None:
        for atoms in self.options.sizes:
            with tempfile.TemporaryDirectory(prefix="ljmd-benchmark-") as folder:
                self.run_size(Case(workload.melt(atoms), self.options.policy, Path(folder)))

    def run_size(self, case: Case) -> None:
        """Check the programs against each other, then time them in rounds; the record is written after each group."""
        ready = [program for program in self.programs if self.attempt(program, case, 0, 0, lambda p: p.prepare(case))]
        if case.atoms <= LARGEST_CHECKED:
            ready = [program for program in ready if self.check(program, case)]
        steps = workload.steps_for(case.atoms, self.options.seconds)
        for threads in self.options.threads:
            for turn in range(self.options.repeats):
                for program in ready:
                    self.attempt(program, case, threads, turn, lambda p: self.time(p, case, steps, threads, turn))
            report.summarise(self.record)
            report.write(self.record, self.options.out / "benchmark.json")

    def attempt(self, program: Program, case: Case, threads: int, turn: int, action: Callable[[Program], None]) -> bool:
        """Do it; what goes wrong is kept in the record."""
        try:
            action(program)
            return True
        except ProgramFailed as error:
            say(f"{program.name}: {error}")
            self.record["failures"].append({"program": program.name, "atoms": case.atoms, "threads": threads,
                                            "round": turn, "words": str(error)})
            return False

    def check(self, program: Program, case: Case) -> bool:
        return self.attempt(program, case, 1, 0, lambda p: self.keep(p, case, p.check(case, CHECK_STEPS), "checks"))

    def time(self, program: Program, case: Case, steps: int, threads: int, turn: int) -> None:
        machine.wait_for_idle(threads, self.options.wait)
        watch = machine.Watch()
        measurement = program.run(case, steps, threads)
        use = watch.use()
        self.keep(program, case, measurement, "runs", threads=threads, round=turn, **asdict(use))
        say(f"{case.atoms} atoms, threads {threads}, round {turn + 1}: {program.name:16} "
            f"{measurement.rate / 1e6:8.3f} million atom-steps/s")
        if use.is_crowded(threads, machine.cores()):
            say(f"warning: other work kept {use.other_work:.1f} of {machine.cores()} cores busy meanwhile: "
                "this run says little")

    def keep(self, program: Program, case: Case, measurement: Measurement, place: str, **more: Any) -> None:
        """Put a measurement into the record, if it has the energy that all other runs of the case started with."""
        known = [one for one in [*self.record["checks"], *self.record["runs"]] if one["atoms"] == case.atoms]
        if known:
            reference = known[0]["potential_energy_initial"]
            found = measurement.potential_energy_initial
            both = [one for one in self.programs if one.name in (program.name, known[0]["program"])]
            if not abs(found - reference) <= max(one.tolerance(case.atoms) for one in both) * abs(reference):
                raise ProgramFailed(f"the start has U/N = {found!r}, but {known[0]['program']} found {reference!r}")
        self.record[place].append({"program": program.name, "atoms": case.atoms, **more, **asdict(measurement)})


def say(line: str) -> None:
    print(line, file=sys.stderr, flush=True)


def publish(record: Record, out: Path) -> None:
    """Page and figures; their paths are printed."""
    style.save_text(report.markdown(record), out / "benchmark.md", "interleaved rounds (minimum .. maximum); time loops alone")
    print(out / "benchmark.md")
    for name, figure in figures.draw(record).items():
        style.save(figure, out / f"{name}.png")


@reports_errors
def main(arguments: Optional[Sequence[str]] = None) -> int:
    options = parse(arguments)
    if options.redraw:
        record = report.read(options.redraw / "benchmark.json")
        report.summarise(record)
        publish(record, options.redraw)
        return 0
    if options.share:
        machine.share_cores()
    try:
        benchmark = Benchmark(options)
    except ProgramFailed as error:
        raise Error(str(error)) from None
    report.write(benchmark.record, options.out / "benchmark.json")  # a folder that cannot be written is found out now
    benchmark.run()
    publish(benchmark.record, options.out)
    return 1 if benchmark.record["failures"] else 0


if __name__ == "__main__":
    sys.exit(main())
