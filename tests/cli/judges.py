"""ljmd compare --with command:... and files:...: the engine of docs/judge.md is right, and each mistake made in it on purpose is
found and called by its name; engines that fail in other ways get one message each."""

import os
import random
import shutil
import signal
import subprocess
import sys
from pathlib import Path

from compares import needs
from harness import DECK, STARS, Case, compare_refused
import waiting

ENGINE = Path(__file__).resolve().parents[2] / "docs/examples/engine.py"
STEPS = ("--steps", "100", "--quiet")
POINT = ("--parts", "point", "--quiet")


def engine(t, *replacements, name="engine.py"):
    """The engine of the docs with (old, new) replaced in its text; returns the option that runs it."""
    text = ENGINE.read_text(encoding="utf-8")
    for old, new in replacements:
        t.equal(text.count(old), 1, f"places of {old!r} in the engine")
        text = text.replace(old, new)
    (t.dir / name).write_text(text, encoding="utf-8")
    return f"command:'{sys.executable}' '{name}' {{input}} {{output}}"


def script(t, text):
    """An engine that is a script in Python: `into` is the answer's directory."""
    (t.dir / "script.py").write_text(f"import sys\ninto = sys.argv[2]\n{text}\n", encoding="utf-8")
    return f"command:'{sys.executable}' script.py {{input}} {{output}}"


def checks(found):
    return {check["name"]: check["passed"] for check in found["checks"]}


def good_engine(t):
    t.deck(("steps = 40", "steps = 4000"))
    result = t.run_well("compare", "deck.toml", "--with", engine(t), *STEPS, "--out", "out")
    for words in ("one page of Python", "all 36 checks passed", "mean pressure", "step 100: positions"):
        t.contains(result.out, words)
    t.check("not judged" not in result.out and "diagnosis" not in result.out, f"too much is said:\n{result.out}")
    found = t.json("out/judge.json")
    t.equal(found["passed"], True, "passed")
    t.equal(found["diagnoses"], [], "diagnoses")
    t.equal(found["peer"], "one page of Python", "engine")
    t.check({"exchange/problem/problem.json", "exchange/problem/start.xyz", "exchange/problem/start.data",
             "exchange/answer/thermo.csv", "exchange/engine.log"} <= set(t.files("out")), t.files("out"))
    t.equal(t.json("out/exchange/problem/problem.json")["run"]["ensemble"], "NVE", "ensemble")


KICKS = ("v = v + 0.5 * dt * f\n        r", "evaluate(r)\n        v = v + 0.5 * dt * f")  # of a step, each once


def kicked(by):
    """Replaces the acceleration of both kicks."""
    return [(old, old.replace("* f", f"* ({by})")) for old in KICKS]


STEP = """v = v + 0.5 * dt * f
        r = r + dt * v
        u, w, f = evaluate(r)
        v = v + 0.5 * dt * f"""


def moved_by(change_of_r, change_of_v):
    """Another method: of v, of the forces a before the step, and of those f after it."""
    return [(STEP, f"a = f\n        r = r + {change_of_r}\n        u, w, f = evaluate(r)\n        v = v + {change_of_v}")]


def force_of(formula):
    """Forces by another formula of s2 = r^-2, and the virial with them."""
    return [("24 * (2 * s2**6 - s2**3) * s2", formula)]


def pairs_with(factor):
    """Each pair counts with a factor, which is an expression of the indices i and j."""
    return [("f = (24 *", f"odd = {factor}\n    f = (24 * odd *"), ("np.sum(4 * (s2**6 - s2**3) - shift)", "np.sum(odd * (4 * (s2**6 - s2**3) - shift))")]


START = "usecols=range(1, 7))"
FRAME_ROWS = "np.hstack([r, v, f])"
EDGES = [('np.array(problem["box_edges"])', 'np.array(problem["box_edges"]).round(3)'), ("map(str, edges)", 'map(str, problem["box_edges"])')]
TAIL = (' + n * potential["tail_energy_per_atom"]', "")
# name of the mistake -> what is replaced in the engine, words of the diagnosis, a check that fails
MISTAKES = {
    "shifted energy": ([(' if potential["truncation"] == "shifted" else 0', "")], "shifted energy: the potential is shifted",
                       "potential energy"),
    "missing tail": ([TAIL], "missing tail: the tail correction is left out", "potential energy"),
    "missing tail of the pressure": ([(' + potential["tail_pressure"]', "")], "missing tail: the pressure", "pressure"),
    "epsilon off": ([("f = (24", "f = (24 * 1.003"), ("u = np.sum(4 *", "u = 1.003 * np.sum(4 *")], "epsilon off",
                    "largest force difference"),
    "sigma off": ([("s2 = 1 /", "s2 = 1.01**2 /"), ("* s2)[:, None]", "* s2 / 1.01**2)[:, None]")],
                  "sigma off: energy, virial and forces are those of a sigma of 1.01,", "largest force difference"),
    "other cutoff": ([('= potential["cutoff"]', '= 0.92 * potential["cutoff"]')], "other cutoff", "largest force difference"),
    "missing image": ([("    d -= edges * np.round(d / edges)\n", "")], "missing image", "largest force difference"),
    "missing image along one direction": ([("np.round(d / edges)", "np.round(d / edges) * [1, 1, 0]")],
                                          "missing image: pairs that are near each other through a wall of the box are left out along z",
                                          "largest force difference"),
    "missing image on one side": ([("np.round(d / edges)", "(d > edges / 2)")],
                                  "left out where r_i - r_j < -L/2 for i < j, all others are right", "largest force difference"),
    "constant force": ([("np.sum(f * d), forces", "np.sum(f * d), forces + [0.01, 0.02, 0]")],
                       "constant force: the same force of (0.01, 0.02, 0) is added on every atom", "largest force difference"),
    "small constant force in one direction": ([("np.sum(f * d), forces", "np.sum(f * d), forces + [0, 0, -1e-8]")],
                                              "constant force: the same force of -1e-08 along z", "largest force difference"),
    "constant force in the frames alone": ([("np.hstack([r, v, f])", "np.hstack([r, v, f + [0, 0, 1e-8]])")],
                                           "frame of step 0: constant force: the same force of 1e-08 along z",
                                           "step 10: forces at the engine's positions"),
    "field in a half of the box": ([('"forces": f.tolist()',
                                     '"forces": (f + np.outer(start[:, 0] > edges[0] / 2, [0.1, 0, 0])).tolist()')],
                                   "net force: forces do not sum to zero", "largest force difference"),
    "3N against 3N-3": ([("(3 * n - 3)", "(3 * n)")], "3N against 3N-3: the temperature", "temperature"),
    "velocities of the wrong sign": ([("np.hstack([r, v, f])", "np.hstack([r, -v, f])")],
                                     "velocities: in the frame of step 0 they have the wrong sign", "step 10: velocities"),
    "velocities of other atoms": ([("np.hstack([r, v, f])", "np.hstack([r, np.roll(v, 1, axis=0), f])")],
                                  "another order: in the frame of step 0, velocities of 108 of 108 atoms", "step 10: velocities"),
    "velocities in other columns": ([("np.hstack([r, v, f])", "np.hstack([r, v[:, [1, 0, 2]], f])")],
                                    "velocities: in the frame of step 0 they stand in other columns, as (vy, vx, vz)", "step 10: velocities"),
    "energy of one step before": ([("    row = thermodynamics(u, w, v)", "    row = thermodynamics(last if step else u, w, v)\n    last = u")],
                                  "one step late: the potential energy of thermo.csv", "thermo.csv, steps 5 to 40: potential energy"),
    "doubled velocities": ([(FRAME_ROWS, "np.hstack([r, 2 * v, f])")], "velocities: in the frame of step 0 they are 2 times", "step 10: velocities"),
    "velocities of a moving whole": ([(FRAME_ROWS, "np.hstack([r, v + [0.1, 0, 0], f])")], "velocities: in the frame of step 0 they have (0.1, ",
                                     "step 10: velocities"),
    "velocity of one atom": ([(FRAME_ROWS, "np.hstack([r, v * np.where(np.arange(n) == 4, 1.5, 1)[:, None], f])")],
                             "are right but for one atom, the one of id 5", "step 10: velocities"),
    "velocities of one step before": ([(FRAME_ROWS, "np.hstack([r, v if step == 0 else before, f])"), ("    row = thermo", "    before, now = (v, v) if step == 0 else (now, v)\n    row = thermo")],
                                      "one step late: velocities in the frame of step 1 are those of step 0", "step 10: velocities"),
    "rows of other atoms": ([(FRAME_ROWS, "np.roll(np.hstack([r, v, f]), 1, axis=0)")], "another order: at step 0, ", "step 1: positions"),
    "pressure of one step before": ([("    row = thermodynamics(u, w, v)",
                                      '    row = thermodynamics(u, w, v)\n    p, row["pressure"] = row["pressure"], p if step else row["pressure"]')],
                                    "one step late: the pressure of thermo.csv", "thermo.csv, steps 5 to 40: pressure"),
    "kinetic energy of half steps": ([("    row = thermodynamics(u, w, v)", "    row = thermodynamics(u, w, v - 0.5 * run[\"time_step\"] * f * (step > 0))")],
                                     "half-step velocities: the kinetic energy of thermo.csv", "thermo.csv, steps 5 to 40: kinetic energy"),
    "mass": (kicked("f / 1.3"), "mass: at step 1 the atoms are where forces take them if their mass is 1.3,", "step 1: positions"),
    "mass of a half": (kicked("f / 0.5"), "their mass is 0.5,", "step 1: positions"),
    "mass of one atom": (kicked("f / np.where(np.arange(n) == 4, 3, 1)[:, None]"), "one atom: at step 1 the one of id 5 alone is elsewhere, where "
                         "forces take it if its mass is 3", "step 1: positions"),
    "start of six decimals": ([(START, START + ".round(6)")], "digits of the start: ", "step 1: positions"),
    "start of ten decimals": ([(START, START + ".round(10)")], "digits of the start: ", "step 1: positions"),
    "start in single precision": ([(START, START + ".astype(np.float32).astype(float)")], "with single precision", "step 1: positions"),
    "start with one atom elsewhere": ([(START, START + "\nstart[4, 0] += 1e-3")], "one atom: at step 0 the one of id 5 alone is elsewhere, by (0.001, ", "step 1: positions"),
    "edges of three decimals": (EDGES, "edges of the box: energy, virial and forces are those of edges with 3 decimals", "largest force difference"),
    "single precision": ([("    near = np", "    d = d.astype(np.float32).astype(float)\n    near = np")], "single precision: ", "largest force difference"),
    "excluded pair": ([("< cutoff**2\n", "< cutoff**2\n    near &= ~((first == 0) & (second == 1))\n")], "missing pair: 1 pair within the cutoff is left out, of the ids 1 and 2",
                      "largest force difference"),
    "pairs of one atom": (pairs_with("np.where((i == 4) | (j == 4), 1.2, 1)"), "one atom: all pairs of the one of id 5 are 1.2 times", "largest force difference"),
    "force on one atom": ([('"forces": f.tolist()', '"forces": (f * np.where(np.arange(n) == 4, 1.01, 1)[:, None]).tolist()')],
                          "one atom: the force on the one of id 5 alone is wrong", "largest force difference"),
    "tail of N - 1": ([(TAIL[0], TAIL[0].replace("n *", "(n - 1) *"))], "tail of N - 1: the tail correction is that of N - 1 atoms, or", "potential energy"),
    "tail of one atom": ([(TAIL[0], TAIL[0].replace("n * ", ""))], "tail of one atom", "potential energy"),
    "tail twice": ([(TAIL[0], TAIL[0].replace("n *", "2 * n *"))], "tail twice", "potential energy"),
    "energy of pairs twice": ([("u = np.sum(4 *", "u = 2 * np.sum(4 *")], "pairs twice: every pair is counted twice", "potential energy"),
    "energy of the wrong sign": ([("return u + n", "return -u - n")], "sign: the energy has the wrong sign", "potential energy"),
    "total energy": ([('"potential_energy": u,', '"potential_energy": u + k,')], "total energy: the kinetic energy", "potential energy"),
    "temperature of half": ([("2 * k / (3 * n - 3)", "k / (3 * n - 3)")], "temperature: it is K/(3 N - 3)", "temperature"),
    "pressure without motion": ([("(2 * k + w) / (3", "w / (3")], "pressure: the kinetic part is left out", "pressure"),
    "twice the virial": ([("np.sum(f * d)", "2 * np.sum(f * d)")], "virial: twice of it", "virial"),
    "a third of the virial": ([("np.sum(f * d)", "np.sum(f * d) / 3")], "virial: a third of it", "virial"),
    "half-step velocities": ([("yield step, u, w, r, v, f", "yield step, u, w, r, v - 0.5 * dt * f, f")],
                             "half-step velocities", "step 10: kinetic energy"),
    "half-step start": ([("v = v + 0.5 * dt * f\n        r", "v = v + dt * f\n        r"),
                         ("evaluate(r)\n        v = v + 0.5 * dt * f", "evaluate(r)")], "half-step start", "step 1: positions"),
    "another time step": ([('run["time_step"])', '1.01 * run["time_step"])')], "another time step", "step 1: positions"),
    "stale list": ([("near = np.sum(d * d, axis=1) < cutoff**2",
                     'old = globals().setdefault("old", np.sum(d * d, axis=1) < (cutoff + 0.05)**2)\n'
                     "    near = old & (np.sum(d * d, axis=1) < cutoff**2)")], "stale list: forces are right at step",
                   "step 100: forces at the engine's positions"),
    "virial of the wrong sign": ([("np.sum(f * d)", "-np.sum(f * d)")], "virial: the sign is wrong", "virial"),
    "half the virial": ([("np.sum(f * d)", "0.5 * np.sum(f * d)")], "virial: half of it", "virial"),
    "forces of the wrong sign": ([('"forces": f.tolist()', '"forces": (-f).tolist()')], "forces: all have the wrong sign",
                                 "largest force difference"),
    "energy of one atom": ([("return u + n", "return (u + n"), ('per_atom"],', 'per_atom"]) / n,')], "energy of one atom",
                           "potential energy"),
    "few digits": ([('"X" + 9 * " %.17g"', '"X" + 9 * " %.9f"')], "few digits: positions of the frames have 9 decimals", "step 1: positions"),
    "explicit Euler": (moved_by("dt * v", "dt * a"), "explicit Euler", "step 10: positions"),
    "second half kick missing": (moved_by("dt * v + 0.5 * dt**2 * a", "0.5 * dt * a"), "second half kick: it is missing", "step 10: positions"),
    "second kick of a whole step": (moved_by("dt * v + 0.5 * dt**2 * a", "dt * (0.5 * a + f)"), "second half kick: it is a whole one", "step 10: positions"),
    "first half kick missing": (moved_by("dt * v", "0.5 * dt * f"), "first half kick: it is missing", "step 1: positions"),
    "a dt^2 without its half": (moved_by("dt * v + dt**2 * a", "0.5 * dt * (a + f)"), "half of a dt^2: the atoms move by r += v dt + a dt^2,", "step 1: positions"),
    "no a dt^2/2": (moved_by("dt * v", "0.5 * dt * (a + f)"), "half of a dt^2: the atoms move by r += v dt alone", "step 1: positions"),
    "old forces": (moved_by("dt * v + 0.5 * dt**2 * a", "dt * a"), "old forces: velocities change by a(t) dt", "step 10: positions"),
    "new forces": (moved_by("dt * v + 0.5 * dt**2 * a", "dt * f"), "new forces: velocities change by a(t + dt) dt", "step 10: positions"),
    "velocities of its own": ([(START, START + "\nstart[:, 3:] = np.random.default_rng(3).normal(size=start[:, 3:].shape)")],
                              "other velocities at the start", "step 1: positions"),
    "twice the kinetic energy": ([("k = 0.5 * np.sum(v**2)", "k = np.sum(v**2)")], "kinetic energy: twice as large", "kinetic energy"),
    "energy without its 4": ([("u = np.sum(4 * (s2**6 - s2**3)", "u = np.sum(1 * (s2**6 - s2**3)")], "quarter of the energy", "potential energy"),
    "forces without their 2": (force_of("24 * (s2**6 - s2**3) * s2"), "forces: a 2 is forgotten", "largest force difference"),
    "forces that are not divided by r": (force_of("24 * (2 * s2**6 - s2**3) * s2**0.5"), "forces: r_ij is not divided by r", "largest force difference"),
    "forces that are divided by r twice": (force_of("24 * (2 * s2**6 - s2**3) * s2**1.5"), "forces: they are divided by r once too often", "largest force difference"),
    "virial of atoms": ([("np.sum(f * d), forces", "np.sum(np.mod(r, edges) * forces), forces")], "virial: it is the sum of r_i . f_i", "virial"),
    "pressure with K": ([("(2 * k + w) / (3", "(k + w) / (3")], "pressure: it has K, where it is to have 2 K", "pressure"),
    "pressure without its 3": ([("(2 * k + w) / (3 * volume)", "(2 * k + w) / volume")], "pressure: it is (2 K + W)/V", "pressure"),
    "edges 0.1 % too long": ([("np.round(d / edges)", "np.round(d / edges) * 1.001")], "edges of the box: energy, virial and forces are those of a box whose edges are 1.001 times",
                             "largest force difference"),
    "neighbouring ids left out": ([("np.triu_indices(n, 1)", "np.triu_indices(n, 2)")], "neighbouring ids", "largest force difference"),
    "temperature of 3N-6": ([("(3 * n - 3)", "(3 * n - 6)")], "3N-6 against 3N-3: the temperature", "temperature"),
    "tail of the wrong sign": ([(TAIL[0], TAIL[0].replace("+", "-"))], "tail of the wrong sign", "potential energy"),
    "tail of the pressure with 1/3": ([('potential["tail_pressure"]', '16 / 3 * np.pi * (n / volume)**2 * (cutoff**-9 / 3 - cutoff**-3)')],
                                      "formula of the tail: rc^-9 has 1/3 in the pressure", "pressure"),
    "tail without its 1/3": ([('potential["tail_energy_per_atom"]', '8 / 3 * np.pi * n / volume * (cutoff**-9 - cutoff**-3)')],
                             "formula of the tail: rc^-9 has no factor", "potential energy"),
    "row numbers": ([("print(step, *row.values()", "print(step // run['thermo_every'], *row.values()")], "row numbers: the column step", "thermo.csv, steps 1 to 8: potential energy"),
    "pressure of one temperature": ([('"pressure": (2 * k + w) / (3 * volume)', '"pressure": n / volume + w / (3 * volume)')],
                                    "constant temperature: the pressure of thermo.csv", "thermo.csv, steps 5 to 40: pressure"),
    "pressure of rho T": ([('"pressure": (2 * k + w) / (3 * volume)', '"pressure": n / volume * 2 * k / (3 * n - 3) + w / (3 * volume)')],
                          "3N against 3N-3: the pressure of thermo.csv is rho T + W/(3 V) in all rows", "thermo.csv, steps 5 to 40: pressure"),
    "another integrator": ([("r = r + dt * v", "r = r + dt * v + 1e-3 * dt**2 * np.sin(v)")], "integration: at step 1",
                           "step 1: positions"),
}


def mistake(replacements, words, failing):
    def test(t):
        t.deck()
        result = t.expect(5, t.run("compare", "deck.toml", "--with", engine(t, *replacements), *STEPS, "--json"))
        (t.dir / "found.json").write_text(result.out)
        found = t.json("found.json")
        t.check(any(words in diagnosis for diagnosis in found["diagnoses"]), f"{words!r} is not in {found['diagnoses']}")
        t.check(words.startswith("few digits") or not any("few digits" in diagnosis for diagnosis in found["diagnoses"]), found["diagnoses"])
        t.check(any(name.startswith(failing) and not passed for name, passed in checks(found).items()), f"{failing} is passed in {checks(found)}")
        t.contains(result.err, "differ")
    return test


def blows_up(t):
    """What an engine has written before it has lost its atoms is judged, and it is said where that ends."""
    t.deck()
    result = t.expect(5, t.run("compare", "deck.toml", "--with", engine(t, ("np.sum(f * d), forces", "np.sum(f * d), -forces")), *STEPS))
    told = " ".join(result.out.split())
    for words in ("forces: all have the wrong sign", "the engine blew up: frame 4 (step 100): ", "; the frames before it are judged",
                  "step 10: positions", "frames.xyz: frame 4 (step 100): finite, and near the box nan"):
        t.contains(told, words)
    t.contains(result.err, "differ")


def rows_elsewhere(t):
    """Rows that are not at multiples of thermo_every are compared one by one, and no false reason is given why averages are not judged."""
    t.deck()
    rows = ('step % run["thermo_every"] == 0 and', 'step % run["thermo_every"] == 1 and')
    told = " ".join(t.run_well("compare", "deck.toml", "--with", engine(t, rows), *STEPS).out.split())
    for words in ("no row of thermo.csv is at a multiple of thermo_every, 5: its steps begin with 1", "thermo.csv, steps 1 to 36: potential energy"):
        t.contains(told, words)
    t.check("no such column" not in told and "not both" not in told, told)


def unknown_mistake(t):
    t.deck()
    result = t.expect(5, t.run("compare", "deck.toml", *POINT, "--with", engine(t, ("s2**6 - s2**3) - shift", "s2**6 - s2**3 + 0.1) - shift"))))
    t.contains(result.out, "no mistake that is known explains it")


def missing_parts_are_named(t):
    """What is missing is no failure."""
    t.deck()
    result = t.run_well("compare", "deck.toml", *STEPS, "--with", script(t, """
import json
problem = json.load(open(sys.argv[1] + "/problem.json"))
rows = [line.split() for line in open(sys.argv[1] + "/start.xyz")][2:]
k = sum(0.5 * float(x)**2 for row in rows for x in row[4:7])
json.dump({"kinetic_energy": k}, open(into + "/point.json", "w"))
"""))
    for words in ("all 1 checks passed", "potential energy: missing in point.json", "virial: missing", "forces of the start: missing",
                  "trajectory: there are no frames", "averages: there is no thermo.csv"):
        t.contains(" ".join(result.out.split()), words)


FRAME = "open(into + '/point.xyz', 'w').write('107\\nLattice=\"5 0 0 0 5 0 0 0 5\"\\n' + 107 * 'X 0 0 0\\n')"
FAILURES = {  # name -> script, words of the message
    "crashes": ("print('no licence'); sys.exit(3)", ["the engine failed: exit status 3", "no licence"]),
    "is killed": ("import os, signal; os.kill(os.getppid(), signal.SIGKILL)", ["the engine failed: signal 9"]),
    "writes nothing": ("", ["the engine has written none of point.json"]),
    "writes half a file": ("open(into + '/point.json', 'w').write('{\"virial\": 1.')", ["point.json is not a point"]),
    "writes half a frame": ("open(into + '/frames.xyz', 'w').write('108\\nLattice=\"5 0 0 0 5 0 0 0 5\"\\nX 0 0 0\\n')",
                            ["frames.xyz", "the file announces 108 atoms, but only 2 lines follow"]),
    "writes half a row": ("open(into + '/thermo.csv', 'w').write('step,kinetic_energy\\n0,1\\n5\\n')", ["thermo.csv:3", "1 fields, but 2 columns"]),
    "writes no row": ("open(into + '/thermo.csv', 'w').write('step,kinetic_energy\\n')", ["thermo.csv has no row"]),
    "writes NaN": ("open(into + '/point.json', 'w').write('{\"virial\": NaN}')", ["point.json is not a point"]),
    "writes NaN in a table": ("open(into + '/thermo.csv', 'w').write('step,kinetic_energy\\n0,nan\\n')", ["thermo.csv:2", "nan"]),
    "writes null": ("open(into + '/point.json', 'w').write('{\"virial\": null}')", ["'virial' is no finite number"]),
    "writes too few forces": ("open(into + '/point.json', 'w').write('{\"forces\": [[0, 0, 0]]}')", ["'forces' holds 1 vectors, the problem has 108 atoms"]),
    "has other atoms": (FRAME, ["frame 1 has 107 atoms, the problem has 108"]),
    "has another box": (FRAME.replace("107", "108"), ["the edges of the box are 5, 5, 5"]),
    "hangs": ("import signal; signal.pause()", ["the engine was stopped after 1 s"]),
    "prints much": ("for k in range(1100): print('x' * 65536)\nimport signal; signal.pause()", ["prints more than 64 MiB"]),
}


def failure(text, words):
    def test(t):
        t.deck()
        timeout = "1s" if "pause" in text and "print" not in text else "10min"
        result = t.expect(3, t.run("compare", "deck.toml", "--quiet", "--timeout", timeout, "--with", script(t, text)))
        t.equal(result.out, "", "stdout")
        t.equal(result.err.count("error: "), 1, "number of errors")
        for part in words:
            t.contains(result.err, part)
        t.contains(result.err, "--out DIR keeps the files of the engine")
        t.check("/ljmd-" not in result.err, f"a temporary directory is named:\n{result.err}")
    return test


def files_are_named_as_the_user_does(t):
    """By {output} where the directory is temporary, by --out where it stays."""
    t.deck()
    half = script(t, "print('see', into)\nopen(into + '/thermo.csv', 'w').write('step,kinetic_energy\\n0,1\\n5\\n')")
    t.contains(t.expect(3, t.run("compare", "deck.toml", "--quiet", "--with", half)).err, "error: {output}/thermo.csv:3: ")
    t.contains(t.expect(3, t.run("compare", "deck.toml", "--quiet", "--with", half, "--out", "out")).err,
               "error: out/exchange/answer/thermo.csv:3: ")
    crash = script(t, "print('see', into, 'and', sys.argv[1], sep='\\n')\nsys.exit(3)")
    t.contains(t.expect(3, t.run("compare", "deck.toml", "--quiet", "--with", crash)).err, "  see\n  {output}\n  and\n  {input}")
    unknown = script(t, "open(into + '/point.json', 'w').write('{\"kinetic_energy\": 1, \"flux\": 2}')")
    t.contains(t.expect(5, t.run("compare", "deck.toml", "--quiet", "--with", unknown)).err,
               "warning: {output}/point.json: the key 'flux' is not known")


# An engine whose child waits until somebody writes to `gate`, and ljmd until both have ended.
WAITS = "command:setsid sh -c 'echo $$ >began; mv began pid; read word <gate' & wait # {input} {output}"


def child_is_stopped(t):
    waiting.until(lambda: not waiting.is_alive(int(t.read("pid"))), "the child of the engine has ended")


def children_are_stopped(t):
    """Nothing that the engine has started goes on after it was stopped."""
    t.deck()
    os.mkfifo(t.dir / "gate")
    t.expect(3, t.run("compare", "deck.toml", "--quiet", "--timeout", "0.3s", "--with", WAITS))
    if "pid" in t.files():  # its child had begun
        child_is_stopped(t)


def interrupted(t):
    """Ctrl-C, which does not reach the engine's own group, and what ljmd cannot handle end ljmd, the engine and what it has
    started, in a session of its own, too."""
    t.deck()
    os.mkfifo(t.dir / "gate")
    for number, words, code in ((signal.SIGINT, "stopped", 130), (signal.SIGQUIT, "", -signal.SIGQUIT), (signal.SIGKILL, "", -signal.SIGKILL)):
        (t.dir / "pid").unlink(missing_ok=True)
        process = subprocess.Popen([t.ljmd, "compare", "deck.toml", "--quiet", "--with", WAITS], cwd=t.dir,
                                   stdin=subprocess.DEVNULL, stdout=subprocess.DEVNULL, stderr=subprocess.PIPE)
        waiting.until((t.dir / "pid").exists, "the child of the engine has begun", process)
        process.send_signal(number)
        t.contains(process.communicate(timeout=waiting.PATIENCE)[1].decode(), words)
        t.equal(process.returncode, code, "exit code")
        child_is_stopped(t)


def paths_are_quoted(t):
    """The names of the directories are one word each, whatever is in them; the rest is the shell's."""
    t.deck()
    out = "it's \"here\" $(touch gone) `touch gone`; touch gone"
    result = t.expect(3, t.run("compare", "deck.toml", "--quiet", "--out", out, "--with",
                               "command:FIRST=1 && for each in {input} {output}; do test -d \"$each\" && echo $FIRST is; done"))
    t.contains(result.err, "the engine has written none")
    t.equal(t.read(f"{out}/exchange/engine.log"), "1 is\n1 is\n", "what the engine printed")
    t.check("gone" not in t.files(), "a name was run")


def existing_files_are_refused(t):
    t.deck()
    command = engine(t)
    t.run_well("compare", "deck.toml", *POINT, "--with", script(t, ENGINE_OF_NOTHING), "--out", "out")
    t.golden(t.expect(2, t.run("compare", "deck.toml", *POINT, "--with", command, "--out", "out")).err)
    # With --force nothing of an earlier answer is judged.
    t.expect(3, t.run("compare", "deck.toml", *POINT, "--with", "command:true {input} {output}", "--out", "out", "--force"))
    t.check("exchange/answer/point.json" not in t.files("out"), "the earlier answer is still there")


ENGINE_OF_NOTHING = """
rows = [line.split() for line in open(sys.argv[1] + "/start.xyz")][2:]
open(into + "/point.json", "w").write('{"kinetic_energy": %r}' % sum(0.5 * float(x)**2 for row in rows for x in row[4:7]))
"""


def files_by_hand(t):
    """Without a command: the problem is handed out, the answer put beside it, and the same command judges."""
    t.deck()
    command = ("compare", "deck.toml", *STEPS, "--with", "files:place")
    result = t.run_well(*command)
    for words in ("the problem is in place", "nothing was judged", "give the same command again"):
        t.contains(" ".join(result.out.split()), words)
    t.equal(t.files("place"), ["problem.json", "start.data", "start.xyz"], "files")
    t.contains(t.expect(3, t.run(*command)).err, "there is no answer yet in place")
    t.expect(0, t.command([sys.executable, str(ENGINE), "place", "place"]))
    t.contains(t.run_well(*command).out, "checks passed")
    other = t.expect(2, t.run(*command, "--set", "potential.cutoff=2.4"))
    t.contains(other.err, "is the problem of another deck")
    (t.dir / "place/problem.json").unlink()
    t.contains(t.expect(2, t.run(*command)).err, "it is not known what they answer")


def samples(t, deck, rows, columns="step,kinetic_energy", more="", parts="averages"):
    """The judgement of a made-up table: the result of the command, and what it prints as JSON."""
    t.deck(*deck)
    (t.dir / "made.csv").write_text(columns + "\n" + "".join(",".join(map(repr, row)) + "\n" for row in rows))
    result = t.run("compare", "deck.toml", "--parts", parts, "--quiet", "--json", "--with",
                   script(t, "import shutil; shutil.copy('made.csv', into + '/thermo.csv')" + more))
    (t.dir / "found.json").write_text(result.out)
    return result, t.json("found.json")


CANONICAL = [("steps = 40\nsample = true", 'steps = 4000\nsample = true\ntemperature = 1.0\nthermostat = { type = "stochastic-rescaling" }')]


def gamma_rows(freedom, temperature, narrow=1.0, rows=4000, correlation=0.0):
    """Kinetic energies of a canonical ensemble; narrow < 1: with less fluctuation. Correlated samples repeat the last one."""
    source = random.Random(5)
    mean = 0.5 * freedom * temperature
    last = source.gammavariate(0.5 * freedom, temperature)
    result = []
    for row in range(rows):
        if source.random() >= correlation:
            last = source.gammavariate(0.5 * freedom, temperature)
        result.append((row + 1, mean + narrow * (last - mean)))
    return result


def canonical(freedom, temperature, words, **how):
    """A made-up thermostat; words of its diagnosis, or none if it is right."""
    def test(t):
        result, found = samples(t, CANONICAL, gamma_rows(freedom, temperature, **how))
        judged = {name: passed for name, passed in checks(found).items() if "mean temperature" not in name}
        t.equal(len(judged), 3, f"number of checks of the distribution in {judged}")
        if words:
            t.equal(result.code, 5, "exit code")
            t.check(any(words in diagnosis for diagnosis in found["diagnoses"]), f"{words!r} is not in {found['diagnoses']}")
        else:
            t.equal([name for name, passed in judged.items() if not passed], [], "failed checks")
    return test


def openmm(t):
    """OpenMM's Reference platform, driven from Python."""
    here = t.command([sys.executable, "-c", "import openmm"]).code == 0
    needs(here, "OpenMM in this Python")
    t.deck(("steps = 40", "steps = 400"))
    program = ENGINE.parents[2] / "tests/parity/openmm_engine.py"
    result = t.run_well("compare", "deck.toml", *STEPS, "--with", f"command:'{sys.executable}' '{program}' {{input}} {{output}}")
    for words in ("against OpenMM 7", "virial", "step 100: forces at the engine's positions", "checks passed"):
        t.contains(result.out, words)
    t.check("diagnosis" not in result.out, result.out)


LAMMPS = """\
units lj
atom_style atomic
read_data start.data
pair_style lj/cut {cutoff!r}
pair_coeff 1 1 1.0 1.0
pair_modify tail yes
neighbor 0.3 bin
neigh_modify every 1 delay 0 check yes
timestep {time_step!r}
compute virial all pressure NULL virial
compute kinetic all ke
variable u equal pe
variable k equal c_kinetic
variable p equal press
variable t equal temp
variable tail equal {tail!r}
variable w equal 3*vol*(c_virial-v_tail)
thermo_style custom step pe press temp c_virial c_kinetic
thermo_modify norm no
fix move all nve
run 0
print '{{"engine": "LAMMPS", "potential_energy": $(v_u:%.17g), "kinetic_energy": $(v_k:%.17g), "temperature": $(v_t:%.17g), "pressure": $(v_p:%.17g), "virial": $(v_w:%.17g)}}' file point.json screen no
"""
DUMP = "write_dump all custom frames.dump id x y z vx vy vz fx fy fz modify sort id format float %.17g append yes\n"
ROW = "print '$(step),$(v_u:%.17g),$(v_k:%.17g),$(v_t:%.17g),$(v_p:%.17g)' append thermo.csv screen no\n"


def lammps_through_files(t):
    """A user runs LAMMPS by hand with the data file, and puts dumps, a table and a few numbers beside it."""
    needs(shutil.which("lmp"), "program 'lmp'")
    t.deck()
    command = ("compare", "deck.toml", "--quiet", "--steps", "40", "--frames", "1,10,40", "--with", "files:place")
    t.run_well(*command)
    problem = t.json("place/problem.json")
    text = LAMMPS.format(cutoff=problem["potential"]["cutoff"], time_step=problem["run"]["time_step"],
                         tail=problem["potential"]["tail_pressure"])
    frames, every, done = problem["trajectory"]["frames"], problem["run"]["thermo_every"], 0
    for step in sorted({*frames, *range(0, 41, every)}):
        text += f"run {step - done}\n" + DUMP * (step in frames) + ROW * (step % every == 0)
        done = step
    (t.dir / "place/thermo.csv").write_text("step,potential_energy,kinetic_energy,temperature,pressure\n")
    (t.dir / "place/in.lammps").write_text(text)
    t.expect(0, t.command(["lmp", "-in", "in.lammps", "-log", "none"], cwd=t.dir / "place"))
    result = t.run_well(*command)
    for words in ("against LAMMPS", "step 40: positions", "step 40: forces", "temperature", "pressure", "checks passed"):
        t.contains(result.out, words)
    dump = t.read("place/frames.dump")
    (t.dir / "place/frames.dump").write_text(dump[:len(dump) // 2])
    t.contains(t.expect(3, t.run(*command)).err, "the file is cut off")


ISOBARIC = [("steps = 20\nthermostat = { type = \"rescale\", every = 5 }",
             'steps = 1000\ntemperature = 1.0\nthermostat = { type = "langevin", time = 0.2 }'),
            ("steps = 40\nsample = true",
             'steps = 40000\nsample = true\ntemperature = 1.0\nthermostat = { type = "langevin", time = 0.2 }\n'
             'barostat = { type = "stochastic-cell-rescaling", pressure = 1.5, time = 1.0 }'),
            ("cutoff = 2.5", "cutoff = 2.2")]


def isobaric(t):
    """ljmd with other random numbers is an engine at constant pressure; with less fluctuation of the volume it is none."""
    t.deck(*ISOBARIC)
    t.run_well("run", "deck.toml", "--out", "other", "--set", "system.seed=8", "--quiet")
    table = t.columns("other/thermo.csv")
    rows = [(int(step) - 1000, 108.0 * u, 108.0 * k, 108.0 / density)
            for step, u, k, density in zip(table["step"], table["potential_energy"], table["kinetic_energy"], table["density"])
            if step > 1000]
    columns = "step,potential_energy,kinetic_energy,volume"
    result, found = samples(t, ISOBARIC, rows, columns)
    t.equal(result.code, 0, f"exit code, with {found}")
    names = checks(found)
    for name in ("mean volume", "mean enthalpy", "variance of volume", "variance of enthalpy", "mean temperature"):
        t.check(any(check.startswith(name) for check in names), f"{name} in {sorted(names)}")
    middle = sum(row[3] for row in rows) / len(rows)
    (t.dir / "deck.toml").unlink()
    result, found = samples(t, ISOBARIC, [(*row[:3], middle + 0.4 * (row[3] - middle)) for row in rows], columns)
    t.equal(result.code, 5, "exit code")
    t.check(any("the variance of the volume is" in words for words in found["diagnoses"]), found["diagnoses"])


def own_run_fails(t):
    """A deck whose run fails in ljmd, because the barostat makes the box too small, is no mistake of the engine: what can be
    judged is judged, and the message says whose run it is."""
    rows = [(step, 150.0, 128.0) for step in range(1, 201)]
    squeezed = [*ISOBARIC[:1], (ISOBARIC[1][0], ISOBARIC[1][1].replace("pressure = 1.5", "pressure = 12.0"))]
    result, found = samples(t, squeezed, rows, "step,kinetic_energy,volume", more="""
rows = [line.split() for line in open(sys.argv[1] + "/start.xyz")][2:]
k = sum(0.5 * float(x)**2 for row in rows for x in row[4:7])
open(into + "/point.json", "w").write('{"kinetic_energy": %r}' % k)""", parts="point,averages")
    t.equal(result.code, 5, "exit code")
    t.contains(result.err, "ljmd's own run of deck.toml failed")
    t.contains(result.err, "the barostat would make the box")
    t.equal(found["passed"], None, "passed")
    t.equal(checks(found), {"kinetic energy": True}, "checks")
    t.check(any("averages: ljmd's own run of the deck failed" in words for words in found["not_judged"]), found["not_judged"])


def its_directory_is_known(t):
    """info, report and plot know the directory that a judgement leaves; resume and analyze say what it is."""
    t.deck()
    wrong = engine(t, ("np.sum(f * d), forces", "-np.sum(f * d), forces"))
    t.expect(5, t.run("compare", "deck.toml", "--with", wrong, *STEPS, "--out", "out"))
    told = t.run_well("info", "out").out
    for words in ("deck.toml against one page of Python", "checks FAILED", "failed        virial", "diagnosis     virial: the sign is wrong"):
        t.contains(told, words)
    t.run_well("report", "out/judge.json")
    (t.dir / "page.json").write_text(t.run_well("report", "out", "--json").out)
    page = t.json("page.json")
    t.check("report.html" in t.files("out"), t.files("out"))
    t.equal((page["kind"], page["title"]), ("comparison", "deck.toml against one page of Python"), "kind and title")
    t.equal([chart["id"] for chart in page["charts"]], ["checks", "distance", "force_difference"], "charts")
    t.check(any(entry["subject"] == "diagnosis" and "sign is wrong" in entry["words"] for entry in page["verdict"]), page["verdict"])
    t.run_well("plot", "out")
    t.run_well("plot", "out/judge.json", "--out", "one.png")
    t.check({"out/judge.png", "one.png"} <= set(t.files()), t.files())
    for command in ("resume", "analyze"):
        t.contains(t.expect(3, t.run(command, "out")).err, "it holds a comparison, which `ljmd compare --out out` has made")


def speed_of_an_engine(t):
    """Told, and not judged; where the machine is so busy that more steps take no longer, that is said."""
    t.deck(("steps = 40", "steps = 400"))
    result = t.run("compare", "deck.toml", "--parts", "speed", "--quiet", "--with", engine(t), "--out", "out")
    found = t.json("out/judge.json")
    t.equal(found["checks"], [], "checks")
    if found["speed"] is None:
        t.equal(result.code, 3, "exit code")
        t.contains(result.out, "too short to be told from its start-up")
    else:
        t.equal(result.code, 0, "exit code")
        t.equal(found["speed"]["steps"], 400, "steps")
        t.check(found["speed"]["peer_steps_per_second"] > 0 and found["speed"]["peer_start_up_seconds"] >= 0, found["speed"])
        t.contains(result.out, "the engine's start-up, not in its speed")


def cases():
    return [Case("good engine", good_engine)] + \
           [Case(f"mistake: {name}", mistake(*how)) for name, how in MISTAKES.items()] + \
           [Case(f"an engine that {name}", failure(*how)) for name, how in FAILURES.items()] + \
           [Case("mistake that is not known", unknown_mistake), Case("an engine that blows up", blows_up), Case("rows elsewhere", rows_elsewhere), Case("missing parts are named", missing_parts_are_named),
            Case("children are stopped", children_are_stopped), Case("interrupted", interrupted), Case("files are named as the user does", files_are_named_as_the_user_does),
            Case("paths are quoted", paths_are_quoted),
            Case("existing files are refused", existing_files_are_refused), Case("files by hand", files_by_hand),
            Case("canonical kinetic energies", canonical(321, 1.0, "")),
            Case("canonical kinetic energies, correlated", canonical(321, 1.0, "", rows=20000, correlation=0.8)),
            Case("openmm", openmm), Case("lammps through files", lammps_through_files), Case("isobaric", isobaric), Case("own run fails", own_run_fails), Case("its directory is known", its_directory_is_known),
            Case("thermostat of 3N", canonical(321, 324 / 321, "3N against 3N-3: the mean kinetic energy")),
            Case("thermostat of another temperature", canonical(321, 1.05, "other temperature: the mean kinetic energy is that of T = 1.05")),
            Case("thermostat that rescales", canonical(321, 1.0, "too little fluctuation", narrow=0.5)),
            Case("command without output", compare_refused(DECK, "--with", "command:./engine {input}")),
            Case("command that quotes", compare_refused(DECK, "--with", "command:./engine '{input}' {output}")),
            Case("files without a name", compare_refused(DECK, "--with", "files:")),
            Case("wrong timeout", compare_refused(DECK, "--with", "command:./engine {input} {output}", "--timeout", "soon")),
            Case("speed of an engine", speed_of_an_engine),
            Case("speed of files", compare_refused(DECK, "--with", "files:answers", "--parts", "speed")),
            Case("few bodies", compare_refused(STARS, "--with", "command:./engine {input} {output}"))]
