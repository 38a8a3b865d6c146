#!/usr/bin/env python3
"""Tests of what the benchmarks do besides timing: starts, parsers, ratios, records. Prints "N passed, M failed".

Programs are scripts in the place of ljmd and its peers; no test depends on how fast anything is.
"""

from __future__ import annotations

import json
import os
import shutil
import subprocess
import sys
from pathlib import Path
from typing import Any, Callable

HERE = Path(__file__).resolve().parent
sys.path.insert(0, str(HERE.parent / "analysis"))
import fixtures  # noqa: E402  (it says where the modules of analysis/ are)

sys.path.insert(0, str(HERE))
import gromacs_program  # noqa: E402
import harness  # noqa: E402
import lammps_program  # noqa: E402
import ljmd_program  # noqa: E402
import machine  # noqa: E402
import numpy as np  # noqa: E402
import rank_model  # noqa: E402
import ranks  # noqa: E402
import ratios  # noqa: E402
import replay  # noqa: E402
import report  # noqa: E402
import roofline  # noqa: E402
import scaling  # noqa: E402
import scaling_cases  # noqa: E402
import workload  # noqa: E402
from fixtures import png_size, refused  # noqa: E402
from gromacs_program import Gromacs  # noqa: E402
from programs import ProgramFailed, execute  # noqa: E402
from workload import Configuration  # noqa: E402

SAMPLES = HERE / "samples"

# An ljmd that finds the energy of the crystal, and is as fast as its precision says.
LJMD = """#!{python}
import json, re, sys
if sys.argv[1:] == ["info", "--json"]:
    print(json.dumps({{"version": "1.2.3", "compiler": "GNU 1"}}))
    sys.exit()
assert sys.argv[1] == "bench" and "--json" in sys.argv, sys.argv
deck = open(sys.argv[2]).read()
precision = re.search('precision = "(.*)"', deck).group(1)
if "cutoff = 1.5" in deck:
    print("error: no such cutoff", file=sys.stderr)
    sys.exit(2)
print(json.dumps({{"atoms": 864, "threads": int(sys.argv[sys.argv.index("--threads") + 1]), "steps": 100,
    "atom_steps_per_second": 4e6 if precision == "mixed" else 2e6, "bytes_per_atom": 700.0,
    "potential_energy_initial": -6.773368053, "potential_energy_final": -5.7, "total_energy_final": -4.6}}))
"""
# A LAMMPS without the package OPT; it writes the log that lies beside it.
LMP = """#!{python}
import sys
if sys.argv[1] == "-h":
    print("Massively Parallel Simulator - 1 Apr 2020\\n\\nInstalled packages:\\n\\nKSPACE MC\\n")
    sys.exit()
print(open({log!r}).read())
"""


def failed(action: Callable[[], Any], *words: str) -> None:
    try:
        action()
    except ProgramFailed as error:
        assert all(word in str(error) for word in words), error
    else:
        raise AssertionError(f"accepted; {words} expected")


def write_program(path: Path, text: str, **values: str) -> Path:
    path.write_text(text.format(python=sys.executable, **values))
    path.chmod(0o755)
    return path


def run(script: str, path: Path, *arguments: Any) -> subprocess.CompletedProcess[str]:
    """A script of this folder, with nothing but `path` to find programs in."""
    command = [sys.executable, str(HERE / script), *map(str, arguments)]
    return subprocess.run(command, capture_output=True, text=True, check=False, env={**os.environ, "PATH": str(path)})


def test_crystal(tmp: Path) -> None:
    positions, edges = workload.fcc((3, 4, 5), 0.8442)
    assert len(positions) == 240 and abs(240 / np.prod(edges) - 0.8442) < 1e-12
    assert (positions >= 0.0).all() and (positions < edges).all()
    separation = positions[:, np.newaxis] - positions
    separation -= edges * np.rint(separation / edges)
    distance = np.linalg.norm(separation, axis=2) + 9.0 * np.eye(240)
    nearest = (4 / 0.8442) ** (1 / 3) / np.sqrt(2)
    assert abs(distance.min() - nearest) < 1e-12 and ((distance < nearest + 1e-9).sum(axis=1) == 12).all()


def test_start_has_no_momentum_and_the_right_temperature(tmp: Path) -> None:
    start = workload.melt(864)
    assert start.atoms == 864 and start.velocities.shape == (864, 3)
    assert np.abs(start.velocities.sum(axis=0)).max() < 1e-11
    assert abs((start.velocities**2).sum() / (3 * 863) - 1.44) < 1e-13
    assert (workload.melt(864).velocities == start.velocities).all()
    assert (workload.maxwell(864, 1.44, seed=1) != start.velocities).all()


def test_sizes(tmp: Path) -> None:
    assert [workload.cells_of(atoms) for atoms in workload.SIZES] == [6, 10, 20, 40, 80]
    for atoms in (1, 32, 865):
        try:
            workload.cells_of(atoms)
        except ValueError as error:
            assert str(atoms) in str(error)
        else:
            raise AssertionError(atoms)


def test_numbers_of_steps(tmp: Path) -> None:
    assert workload.steps_for(864, 3.0) == 17400
    assert workload.steps_for(256_000, 3.0) == 60
    assert workload.steps_for(2_048_000, 3.0) == workload.FEWEST_STEPS


def test_files_hold_the_start(tmp: Path) -> None:
    start = workload.melt(500)
    workload.write_lammps_data(start, tmp / "start.data")
    text = (tmp / "start.data").read_text()
    rows = [line.split() for line in text.splitlines()[1:]]
    assert ["500", "atoms"] in rows
    bounds = [float(row[1]) for row in rows if len(row) == 4 and row[2].endswith("lo")]
    assert bounds == start.edges.tolist()
    positions = [list(map(float, row[2:])) for row in rows if len(row) == 5]
    velocities = [list(map(float, row[1:])) for row in rows if len(row) == 4 and not row[2].endswith("lo")]
    assert positions == start.positions.tolist() and velocities == start.velocities.tolist()
    workload.write_numpy(start, tmp / "start.npz")
    assert (np.load(tmp / "start.npz")["velocities"] == start.velocities).all()


def test_gro_has_fixed_columns(tmp: Path) -> None:
    positions = np.arange(300_003, dtype=float).reshape(-1, 3) / 3000.0
    workload.write_gro(Configuration(positions, 0.1 - positions, np.array([101.0, 102.0, 103.0])), tmp / "start.gro")
    lines = (tmp / "start.gro").read_text().splitlines()
    assert lines[1] == "100001" and len(lines) == 100_004 and len({len(line) for line in lines[2:-1]}) == 1
    assert lines[2][:20] == "    1LJ      LJ    1" and lines[100_001][:20] == "    0LJ      LJ    0"
    for line, place in ((lines[2], positions[0]), (lines[-2], positions[-1])):
        values = [float(line[k : k + 14]) for k in range(20, 104, 14)]
        assert np.allclose(values, np.concatenate((place, 0.1 - place)), rtol=0.0, atol=1e-9)
    assert [float(word) for word in lines[-1].split()] == [101.0, 102.0, 103.0]


def test_log_of_lammps(tmp: Path) -> None:
    text = (SAMPLES / "lammps.log").read_text()
    steps, seconds, rows = lammps_program.parse_log(text)
    assert (steps, seconds) == (200, 0.010234)
    assert rows[0] == (0, -6.7733680532529, -4.6333680532529)
    assert rows[-1] == (200, -5.75987581283086, -4.64322454916219)
    newer = text.replace("Step PotEng TotEng", "   Step         PotEng         TotEng    ")
    assert lammps_program.parse_log(newer) == (steps, seconds, rows)
    failed(lambda: lammps_program.parse_log("ERROR: Lost atoms"), "lmp")
    failed(lambda: lammps_program.parse_log(text.replace("     100", "  abc").replace("     200", "  abc")), "energies")


def test_log_of_gromacs(tmp: Path) -> None:
    text = (SAMPLES / "gromacs.log").read_text()
    assert gromacs_program.parse_log(text) == 0.925
    failed(lambda: gromacs_program.parse_log(text.replace("Wall t", "Wall")), "gmx mdrun")
    rows = gromacs_program.parse_energies((SAMPLES / "gromacs-energy.xvg").read_text())
    assert rows == [(0.0, -216750.671875, -147633.125), (0.5, -184070.03125, -147856.828125)]
    failed(lambda: gromacs_program.parse_energies("# nothing\n"), "gmx energy")


def test_answer_of_ljmd(tmp: Path) -> None:
    answer = {"atoms": 4, "steps": 1, "atom_steps_per_second": 1e6, "potential_energy_initial": -1.0,
              "potential_energy_final": -1.0, "total_energy_final": -0.5}
    assert ljmd_program.parse_bench(json.dumps(answer)) == answer
    failed(lambda: ljmd_program.parse_bench(json.dumps({**answer, "steps": None})), "steps")
    failed(lambda: ljmd_program.parse_bench(json.dumps({"atoms": 4})), "ljmd bench")
    failed(lambda: ljmd_program.parse_bench("3 atoms"), "ljmd bench")


def test_decks(tmp: Path) -> None:
    fixed = ljmd_program.deck('file = "a"', "mixed", "fixed", 100)
    assert "every = 20\n" in fixed and 'precision = "mixed"' in fixed and "cutoff = 2.5" in fixed
    assert "every = 20" not in ljmd_program.deck('file = "a"', "double", "strict", 100)
    assert ljmd_program.from_file(Path('/a "b"/c')) == 'file = "/a \\"b\\"/c"'


def test_programs_that_fail(tmp: Path) -> None:
    failed(lambda: execute(["no-such-program"], tmp), "no-such-program: cannot be run")
    script = "import sys; print('one\\ntwo\\n', file=sys.stderr); sys.exit(3)"
    failed(lambda: execute([sys.executable, "-c", script], tmp), "exit code 3: two")
    frame = script.replace("two\\n", "Fatal error:\\nNo such\\nthing.\\n\\nRead more\\n-----\\n")
    failed(lambda: execute([sys.executable, "-c", frame], tmp), "exit code 3: Fatal error: No such thing.")
    failed(lambda: execute([sys.executable, "-c", script.replace("two", "two\\n---")], tmp), "exit code 3: two")
    said = execute([sys.executable, "-c", "import os; print(os.environ['X'], input())"], tmp, "y", X="x")
    assert said == "x y\n", said


def test_tolerance_of_single_precision(tmp: Path) -> None:
    assert Gromacs(double=True).tolerance(256_000) == 1e-9
    assert Gromacs().tolerance(4) == 1e-6 and 1e-5 < Gromacs().tolerance(32_000) < 1e-3


def made_run(program: str, turn: int, rate: float, atoms: int = 864, threads: int = 1) -> dict[str, Any]:
    return {"program": program, "round": turn, "rate": rate, "atoms": atoms, "threads": threads}


def test_ratios_are_taken_within_rounds(tmp: Path) -> None:
    rates = {"ljmd double": (2.0, 1.0, 6.0), "peer": (4.0, 1.0, 2.0)}  # the second round was slow for both
    runs = [made_run(name, k, rate) for name, values in rates.items() for k, rate in enumerate(values)]
    runs += [made_run("ljmd double", 3, 100.0), made_run("peer", 0, 1.0, threads=2)]  # without a counterpart
    found = ratios.ratios(runs, ["ljmd double"], ["peer", "absent"])
    assert found == [{"program": "ljmd double", "peer": "peer", "atoms": 864, "threads": 1, "median": 1.0,
                      "minimum": 0.5, "maximum": 3.0, "rounds": 3}], found
    middle = ratios.select(ratios.rates(runs, ["ljmd double"]), program="ljmd double")[0]
    assert (middle["median"], middle["minimum"], middle["maximum"], middle["rounds"]) == (4.0, 1.0, 100.0, 4), middle
    assert ratios.summary([]) is None and ratios.groups(runs) == [(864, 1), (864, 2)]


def test_roofline(tmp: Path) -> None:
    assert abs(roofline.neighbours(0.8442, 2.5) / 2.0 - 27.6) < 0.05
    assert abs(roofline.useful_flops() - 745.9) < 0.1
    assert abs(roofline.traffic("double")["memory"] - (4 * 77.63 + 240)) < 0.1
    assert roofline.traffic("mixed")["l2"] < roofline.traffic("double")["l2"]


def test_peaks_compile(tmp: Path) -> None:
    if not shutil.which(roofline.COMPILER):
        raise fixtures.Skipped(f"no {roofline.COMPILER}")
    execute([roofline.COMPILER, *roofline.FLAGS, "-Wall", "-Wextra", "-Werror", "-fsyntax-only", roofline.SOURCE], tmp)


def test_processor(tmp: Path) -> None:
    text = "processor\t: 0\nmodel name\t: Some CPU @ 3 GHz\nflags\t\t: fpu sse2 avx avx2 fma\n"
    assert machine.cpu(text) == {"cpu": "Some CPU @ 3 GHz", "simd": ["sse2", "avx", "avx2", "fma"]}
    assert machine.cpu("")["simd"] == []


def test_other_work(tmp: Path) -> None:
    tick = os.sysconf("SC_CLK_TCK")
    text = f"cpu  {3 * tick} {tick} {2 * tick} {900 * tick} {50 * tick} {tick} 0 {4 * tick} 0 0\ncpu0 1 1 1 1 1 1 1 1\n"
    assert machine.busy_seconds(text) == 11.0 and machine.busy_seconds("") == 0.0
    watch = machine.Watch()
    subprocess.run([sys.executable, "-c", "sum(range(2_000_000))"], check=True)
    use = watch.use()
    assert 0.0 < use.processor_seconds and 0.0 < use.wall_seconds and 0.0 <= use.other_work < float("inf"), use
    assert machine.Use(1.0, 1.0, 0.9).is_crowded(2, 2) and not machine.Use(1.0, 1.0, 0.9).is_crowded(1, 2)
    assert not machine.Use(1.0, 2.0, 0.1).is_crowded(2, 2)
    machine.wait_for_idle(1000, limit=0.0)  # does not wait


def prepare(tmp: Path, log: str) -> tuple[Path, Path]:
    """The made-up ljmd, and a folder with the made-up LAMMPS."""
    (tmp / "bin").mkdir()
    (tmp / "log").write_text(log)
    write_program(tmp / "bin" / "lmp", LMP, log=str(tmp / "log"))
    return write_program(tmp / "ljmd", LJMD), tmp / "bin"


def test_benchmark(tmp: Path) -> None:
    ljmd, path = prepare(tmp, (SAMPLES / "lammps.log").read_text().replace("-6.7733680532529", "-6.773368053"))
    result = run("harness.py", path, "--ljmd", ljmd, "--sizes", "864,4000", "--threads", "1", "--repeats", "2",
                 "--precision", "double,mixed", "--peers", "lammps,lammps-opt,gromacs", "--out", tmp / "out")
    assert result.returncode == 0, result
    assert "lammps-opt: absent" in result.stderr and "gromacs: absent" in result.stderr, result.stderr
    assert result.stdout.splitlines() == [str(tmp / "out" / name) for name in
                                          ("benchmark.md", "rates.png", "ratios.png")], result.stdout
    record = report.read(tmp / "out" / "benchmark.json")
    assert [run["program"] for run in record["runs"]] == 4 * ["ljmd double", "ljmd mixed", "lammps"]
    assert [one["atoms"] for one in record["checks"]] == 3 * [864] + 3 * [4000] and record["failures"] == []
    assert record["programs"]["gromacs"]["identity"] is None and record["peaks"] is None
    rate = 864 * 200 / 0.010234
    found = ratios.select(record["ratios"], program="ljmd mixed", peer="lammps", atoms=864)
    assert len(found) == 1 and found[0]["rounds"] == 2 and abs(found[0]["median"] - 4e6 / rate) < 1e-12, found
    page = (tmp / "out" / "benchmark.md").read_text()
    assert "| 864 | 1 | 0.24 (0.24 .. 0.24) |" in page and "gromacs: mixed precision; leapfrog" in page, page
    before = png_size(tmp / "out" / "ratios.png")
    (tmp / "out" / "benchmark.md").unlink()
    assert run("harness.py", path, "--redraw", tmp / "out").returncode == 0
    assert (tmp / "out" / "benchmark.md").read_text() == page and png_size(tmp / "out" / "ratios.png") == before


ENGINE = """#!{python}
import sys
if sys.argv[1] == "--version":
    print("Engine 7, by hand")
    sys.exit()
start, atoms, cells, steps, threads, every = sys.argv[1:]
assert "Velocities" in open(start).read() and int(atoms) == 4 * int(cells) ** 3 and every == "20"
print(f"step 0 U -6.773368053\\nstep {{steps}} U -5.7 E -4.6 rate 3.5 M")
"""
ADAPTER = r"""name = "engine"
precision = "double"
command = "./engine {start} {atoms} {cells} {steps} {threads} {every}"
version = "./engine --version"
rate = 'rate (\S+) M'
unit = 1e6
potential_energy_initial = '^step 0 U (\S+)'
potential_energy_final = '^step [1-9]\d* U (\S+)'
total_energy_final = ' E (\S+)'
note = "a test"
policies = ["fixed"]
"""


def test_a_foreign_engine(tmp: Path) -> None:
    """It enters with an adapter, and stands beside ljmd in the ratios."""
    ljmd, path = prepare(tmp, "")
    write_program(tmp / "engine", ENGINE)
    (tmp / "engine.toml").write_text(ADAPTER)
    asked = ("--ljmd", ljmd, "--sizes", "864", "--threads", "1", "--repeats", "2", "--peers", "",
             "--engine", tmp / "engine.toml", "--out", tmp / "out")
    result = run("harness.py", path, *asked)
    assert result.returncode == 0, result
    record = report.read(tmp / "out" / "benchmark.json")
    assert record["programs"]["engine"] == {"precision": "double", "note": "a test",
                                            "identity": {"version": "Engine 7, by hand"}}
    assert [one["rate"] for one in record["runs"] if one["program"] == "engine"] == [3.5e6, 3.5e6], record
    assert all(one["wall_seconds"] > 0.0 and one["processor_seconds"] > 0.0 for one in record["runs"]), record
    found = ratios.select(record["ratios"], program="ljmd double", peer="engine", atoms=864)
    assert abs(found[0]["median"] - 2.0 / 3.5) < 1e-12, found
    page = (tmp / "out" / "benchmark.md").read_text()
    assert "Processor time over wall time" in page and "| 864 | 1 | 0.57 (0.57 .. 0.57) |" in page, page
    result = run("harness.py", path, *asked, "--policy", "strict")
    assert result.returncode == 1 and "engine: it has no lists of the policy strict" in result.stderr, result


def test_crowded_runs_are_told_of(tmp: Path) -> None:
    one = {"program": "ljmd double", "atoms": 864, "threads": 2, "round": 0, "rate": 1e6, "wall_seconds": 2.0,
           "processor_seconds": 3.0, "other_work": 0.1}
    record = {"programs": {"ljmd double": {"identity": {}}}, "host": {"cores": 2},
              "runs": [one, {**one, "other_work": 0.9}], "rates": [], "ratios": []}
    assert "**1 of 2 runs did not have the cores" in "\n".join(report.rate_table(record))
    assert "| 864 | 2 | 1.50 (1.50 .. 1.50) |" in report.processor_table(record)
    assert report.crowded({**record, "runs": [one]}) == []


def test_adapters_that_make_no_sense(tmp: Path) -> None:
    ljmd, path = prepare(tmp, "")
    for old, new, complaint in (("precision =", "precison =", "unknown key 'precison'"),
                                ('"double"', '"half"', "double or mixed"),
                                ("rate = 'rate (\\S+) M'", "rate = 'rate'", "rate needs one group"),
                                ("(\\S+) M", "(\\S+ M", "no regular expression"),
                                ("{cells}", "{shells}", "shells"),
                                ('note = "a test"', "note = 3", "note has the wrong type"),
                                ('["fixed"]', '["loose"]', "policies are fixed, strict"),
                                ('name = "engine"', "", "'name' is missing"),
                                ('name = "engine"', 'name = "ljmd double"', "two programs would be called"),
                                ("unit", "=", "not valid TOML")):
        assert old in ADAPTER, old
        (tmp / "engine.toml").write_text(ADAPTER.replace(old, new))
        result = run("harness.py", path, "--ljmd", ljmd, "--sizes", "864", "--engine", tmp / "engine.toml",
                     "--out", tmp / "out")
        assert result.returncode == 2 and complaint in result.stderr and "Traceback" not in result.stderr, result
    assert run("harness.py", path, "--ljmd", ljmd, "--engine", tmp / "none.toml").returncode == 2


def test_a_peer_that_does_something_else(tmp: Path) -> None:
    ljmd, path = prepare(tmp, (SAMPLES / "lammps.log").read_text().replace("-6.77336", "-6.77337"))
    result = run("harness.py", path, "--ljmd", ljmd, "--sizes", "864", "--threads", "1", "--repeats", "1", "--peers",
                 "lammps", "--out", tmp / "out")
    assert result.returncode == 1 and "but ljmd double found -6.773368053" in result.stderr, result
    record = report.read(tmp / "out" / "benchmark.json")
    assert {run["program"] for run in record["runs"]} == {"ljmd double"} and len(record["failures"]) == 1, record


def test_mistakes_on_the_command_line(tmp: Path) -> None:
    ljmd, path = prepare(tmp, "")
    for words, complaint in ((("--sizes", "865"), "4 n^3"), (("--peers", "nobody"), "'nobody' is not known"),
                             (("--threads", "9999"), "cores"), (("--ljmd", tmp / "none"), "cannot be run"),
                             (("--sizes", "0"), "--sizes"), (("--repeats", "0"), "--repeats")):
        result = run("harness.py", path, "--ljmd", ljmd, *words)
        assert result.returncode == 2 and complaint in result.stderr, result
    assert run("scaling.py", path, "--families", "sizes").returncode == 2
    (tmp / "benchmark.json").write_text('{"schema": "something"}')
    refused(lambda: report.read(tmp / "benchmark.json"), "ljmd-benchmark")
    assert run("harness.py", path, "--redraw", tmp).returncode == 3


def test_what_is_asked_for_is_run(tmp: Path) -> None:
    """--quick is a set of defaults: it takes nothing away that was asked for."""
    options = harness.parse(["--quick", "--sizes", "2048", "--seconds", "0.1"])
    assert (options.sizes, options.repeats, options.seconds) == ([2048], 2, 0.1)
    options = harness.parse(["--repeats", "7"])
    assert (options.sizes, options.repeats, options.seconds) == (list(workload.SIZES), 7, 3.0)
    assert scaling.parse(["--quick", "--largest", "5000"]).largest == 5000
    assert scaling.parse(["--quick"]).largest == 40_000


def test_systems_of_scaling(tmp: Path) -> None:
    systems = scaling_cases.systems(1_100_000)
    assert {system.family for system in systems} == set(scaling_cases.FAMILIES)
    assert max(system.atoms for system in systems) == 1_000_188
    assert len(scaling_cases.systems()) == len(systems) + 2
    for system in systems:
        if system.family == "small box":
            edge = (system.atoms / system.density) ** (1 / 3)
            assert 2.0 < edge / system.cutoff < 2.05
    slab = next(system for system in systems if system.label == "half empty along z")
    start = slab.configuration()
    assert start.edges[2] == 2.0 * start.edges[0] and start.positions[:, 2].max() < start.edges[0]
    assert 'lattice = { type = "fcc", cells = 6 }' in systems[0].section(tmp)
    assert slab.section(tmp) == ljmd_program.from_file(tmp / "half-empty-along-z.data")
    assert f"0.0 {start.edges.tolist()[2]!r} zlo zhi" in (tmp / "half-empty-along-z.data").read_text()


def rank_of(number: int, atoms: float, ghosts: float = 0.0, messages: int = 0, forces: float = 0.0, force_messages: int = 0,
            inner: float = 0.0, **more: Any) -> dict[str, Any]:
    """As the program `decomposition` tells it."""
    return {"rank": number, "atoms": atoms, "inner": inner, "ghosts": ghosts, "messages": messages, "forces": forces,
            "force_messages": force_messages, **more}


def test_model_of_ranks(tmp: Path) -> None:
    """The slowest rank counts; one rank alone has nothing but its atoms."""
    alone = rank_model.modelled({"atoms": 1000, "ranks": 1, "asked": [rank_of(0, 1000.0)], "tiles": 2}, 1e-7)
    assert alone["efficiency"] == 1.0 and abs(alone["terms"]["computing"] - 1e-4) < 1e-18, alone
    asked = [rank_of(0, 500.0, 1000.0, 3, 700.0, 3, 20.0), rank_of(9, 600.0, 2000.0, 5, 900.0, 2, 100.0)]
    many = rank_model.modelled({"atoms": 8000, "ranks": 16, "asked": asked, "tiles": 16}, 1e-7)
    step = 6e-5 + (5 + 2) * rank_model.LATENCY + (32 * 2000 + 24 * 900) / rank_model.BANDWIDTH - 1e-7 * 100 + 2 * rank_model.LATENCY * 4
    assert many["slowest"]["rank"] == 9 and abs(many["efficiency"] - 1e-7 * 500 / step) < 1e-12, many
    hidden = rank_model.seconds(rank_of(0, 600.0, 2000.0, 5, 900.0, 2, 590.0), 16, 1e-7)
    assert abs(hidden["positions"] - (39.5e-6 - 29.5e-6)) < 1e-12 and hidden["forces"] == 0.0, hidden
    rounds = [{"program": "ljmd", "round": k, "alone": 1e7, "shared": 1.8e7 + k, "parts": 2e7} for k in range(3)]
    simulated = {"atoms": rank_model.SIZES[0], "ranks": 16, "network": "tree", "steps": 3, "step": 1e-3, "efficiency": 0.777, "on_paper": 0.7,
                 "simulator": {"seconds": 1.0, "mebibytes": 30.0}}
    record = {"schema": ranks.SCHEMA, "version": ranks.VERSION, "date": "2026", "host": machine.describe(), "rounds": rounds,
              "options": {"cells": 8, "ranks": 2, "steps": 10, "repeats": 3, "policy": "fixed", "cost": None}, "simulations": [simulated],
              "decompositions": [{"atoms": atoms, "ranks": 16, "asked": asked, "tiles": 16} for atoms in rank_model.SIZES]}
    (tmp / "ranks.json").write_text(json.dumps(record))
    assert run("ranks.py", os.environ["PATH"], "--redraw", tmp).returncode == 0
    page = (tmp / "ranks.md").read_text()
    assert png_size(tmp / "ranks.png") > (500, 200) and "0.900 (0.900 .. 0.900)" in page and "with 100 ns" in page and "0.777" in page
    record["rounds"], record["options"]["cost"] = [], 50.0
    (tmp / "ranks.json").write_text(json.dumps(record))
    assert run("ranks.py", os.environ["PATH"], "--redraw", tmp).returncode == 0
    assert "with 50 ns" in (tmp / "ranks.md").read_text()
    (tmp / "ranks.json").write_text('{"schema": "something"}')
    assert run("ranks.py", os.environ["PATH"], "--redraw", tmp).returncode == 3
    assert run("ranks.py", os.environ["PATH"], "--cells", "7").returncode == 2
    missing = run("ranks.py", tmp, "--simulate", "8", "--decomposition", tmp)
    assert missing.returncode == 2 and "libsimgrid-dev" in missing.stderr


def test_traces_of_ranks(tmp: Path) -> None:
    """What one rank sends, another one expects, as many bytes; positions go out before the forces, which come back."""
    asked = [rank_of(0, 500.0, inner=200.0, parts=[[1, 100.0, 40.0]]), rank_of(1, 300.0, parts=[[0, 90.0, 0.0], [2, 10.0, 5.0]]),
             rank_of(2, 200.0, parts=[[1, 20.0, 0.0]])]
    traces = replay.write_traces({"atoms": 1000, "ranks": 3, "asked": asked}, 1e-7, 2, tmp)
    texts = [Path(name).read_text().splitlines() for name in traces.read_text().split()]
    step = ["0 irecv 1 0 3200 6", "0 isend 1 0 2880 6", "0 allreduce 1 0 0", "0 compute 10000", "0 waitall", "0 compute 30000",
            "0 isend 1 0 960 6", "0 compute 10000", "0 waitall", "0 allreduce 1 0 0"]
    assert texts[0] == ["0 init", *step, *step, "0 finalize"], texts[0]
    words = [line.split() for text in texts for line in text]
    sent = sorted((word[0], *word[2:]) for word in words if word[1] == "isend")
    received = sorted((word[2], word[0], *word[3:]) for word in words if word[1] == "irecv")
    assert sent == received and len(sent) == 2 * 6, sent


def test_simulated_networks(tmp: Path) -> None:
    """A host for each rank, or for 16 with a tree of switches above them that has room for all."""
    platform, hosts = replay.write_platform("links", 40, tmp)
    assert 'radical="0-39"' in platform.read_text() and hosts.read_text().split()[-1] == "host39"
    platform, hosts = replay.write_platform("tree", 300, tmp)
    assert 'radical="0-31"' in platform.read_text() and 'topo_parameters="2;16,2;1,8;1,1"' in platform.read_text()
    places = hosts.read_text().split()
    assert len(places) == 300 and places[15] == "host0" and places[16] == "host1" and places[-1] == "host18"
    smpirun = write_program(tmp / "smpirun", "#!{python}\nprint('[host2:2:(3) 0.000600] [smpi_replay/INFO] Simulation time 0.000600')\n")
    before, os.environ["PATH"] = os.environ["PATH"], str(smpirun.parent)
    try:
        one = replay.simulated({"atoms": 1000, "ranks": 2, "asked": [rank_of(k, 500.0, parts=[]) for k in range(2)]}, 1e-7, "links", tmp)
        write_program(smpirun, "#!{python}\nraise SystemExit('no such thing')\n")
        failed(lambda: replay.simulated({"atoms": 1, "ranks": 1, "asked": [rank_of(0, 1.0, parts=[])]}, 1e-7, "links", tmp), "no such thing")
    finally:
        os.environ["PATH"] = before
    assert abs(one["step"] - 2e-4) < 1e-12 and abs(one["efficiency"] - 0.25) < 1e-12, one


def test_line_of_cost(tmp: Path) -> None:
    systems = [{"nanoseconds": [40.0 + 3.0 * n], "neighbours": n} for n in (1.0, 10.0, 80.0, 400.0)]
    fixed, each = scaling.fit(systems)
    assert abs(fixed - 40.0) < 1e-9 and abs(each - 3.0) < 1e-11, (fixed, each)
    assert scaling.fit(systems[:1]) == (43.0, 0.0)


def test_cost_without_files(tmp: Path) -> None:
    answer = {"atoms": 1000, "steps": 100, "atom_steps_per_second": 1e7}
    assert abs(scaling.nanoseconds(answer) - 100.0) < 1e-9
    assert abs(scaling.nanoseconds({**answer, "seconds_per_phase": {"force": 1.0, "write": 0.002}}) - 80.0) < 1e-9


def test_scaling(tmp: Path) -> None:
    ljmd, path = prepare(tmp, "")
    result = run("scaling.py", path, "--ljmd", ljmd, "--quick", "--out", tmp / "out", "--families", "density,cutoff")
    assert result.returncode == 1 and "no such cutoff" in result.stderr, result
    record = scaling.read(tmp / "out" / "scaling.json")
    assert len(record["systems"]) == 14 and record["failures"][0]["label"] == "cutoff 1.5", record
    assert record["systems"][0]["nanoseconds"] == [500.0] and record["systems"][0]["bytes_per_atom"] == 700.0
    page = (tmp / "out" / "scaling.md").read_text()
    assert "| density | density 0.01 | 32000 |" in page and "cutoff 1.5 failed" in page, page
    assert run("scaling.py", path, "--redraw", tmp / "out").returncode == 0
    assert png_size(tmp / "out" / "scaling.png") == (2100, 1500)


if __name__ == "__main__":
    sys.exit(fixtures.run_tests(globals()))
