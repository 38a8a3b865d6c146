#!/usr/bin/env python3
"""Tests of the pictures of fluids, through plot.py, on made-up run directories. Prints "N passed, M failed"; exit code 1 if any failed."""

from __future__ import annotations

import json
import math
import sys
from pathlib import Path
from typing import Any

import fixtures
import numpy as np
import fluid_pictures
import style
from ljmd.reading import fluids
from fixtures import edit, plot, png_size

HEADER = "step,time,temperature,potential_energy,kinetic_energy,total_energy,pressure"
TIME_STEP = 0.005


def write_run(directory: Path, rows: int = 301, title: str = "made-up argon", argon: bool = False) -> Path:
    """A run of two stages, of which the second, from step 1000 on, is sampled."""
    directory.mkdir()
    generator = np.random.default_rng(1)
    lines = [HEADER + (",time_ps,temperature_K,pressure_bar" if argon else "")]
    for row in range(rows):
        time = 10 * row * TIME_STEP
        temperature, pressure = generator.normal((0.72, 0.1), (0.01, 0.1))
        kinetic = 1.5 * temperature
        values = [10 * row, time, temperature, -4.9 - kinetic, kinetic, -4.9 + generator.normal(0.0, 1e-5), pressure]
        values += [2.15 * time, 119.8 * temperature, 419.0 * pressure] if argon else []
        lines.append(",".join(repr(float(value)) if k else str(value) for k, value in enumerate(values)))
    (directory / "thermo.csv").write_text("\n".join(lines) + "\n")

    lines = ["r,g,g_standard_error"]
    for r in np.arange(0.01, 3.0, 0.02):
        lines.append(f"{r},{1.0 + 2.0 * math.exp(-(((r - 1.09) / 0.1) ** 2))},{0.01}")
    (directory / "rdf.csv").write_text("\n".join(lines) + "\n")

    means = {"temperature": 0.72, "potential_energy": -5.98, "total_energy": -4.9, "pressure": 0.1}
    results = {
        "observables": {
            name: {"mean": mean, "standard_error": 0.001, "independent_samples": 40.0, "unit": ""}
            for name, mean in means.items()
        },
        "stages": [
            stage("equilibrate", 0, 1000, sampled=False),
            stage("production", 1000, 3000, sampled=True),
        ],
    }
    (directory / "results.json").write_text(json.dumps(results))
    (directory / "run.json").write_text(json.dumps({"title": title, "argon": {"sigma": 3.4e-10} if argon else None}))
    return directory


def stage(name: str, first: int, last: int, sampled: bool) -> dict[str, Any]:
    steps = {"steps": last - first, "time_step": TIME_STEP, "energy_drift": 1e-8}
    return {"name": name, "first_step": first, "last_step": last, "sampled": sampled, **steps}


def check_error(directory: Path, exit_code: int, *words: str) -> None:
    fixtures.check_error(plot(directory), exit_code, *words)


def test_pictures_are_made(tmp: Path) -> None:
    run = write_run(tmp / "run", argon=True)
    result = plot(run)
    assert result.returncode == 0, result.stderr
    assert result.stderr == "", result.stderr
    assert result.stdout.splitlines() == [str(run / "thermo.png"), str(run / "rdf.png")], result.stdout
    assert png_size(run / "thermo.png") == (350, 475), png_size(run / "thermo.png")
    assert png_size(run / "rdf.png") == (350, 225), png_size(run / "rdf.png")
    for name in ("thermo.png", "rdf.png"):
        picture = fluid_pictures.plt.imread(run / name)[..., :3]
        ink = np.mean(picture.min(axis=2) < 0.9)
        assert 0.01 < ink < 0.6, (name, ink)


def test_other_directory_and_formats(tmp: Path) -> None:
    run = write_run(tmp / "run")
    before = sorted(run.iterdir())
    for suffix, magic in (("pdf", b"%PDF"), ("svg", b"<?xml")):
        result = plot(run, "--out", tmp / "new" / f"x.{suffix}")
        assert result.returncode == 0, result.stderr
        for name in ("thermo", "rdf"):
            assert (tmp / "new" / f"x-{name}.{suffix}").read_bytes().startswith(magic)
        result = plot(run, "rdf", "--out", tmp / f"one.{suffix}")
        assert result.stdout.splitlines() == [str(tmp / f"one.{suffix}")], result
        assert (tmp / f"one.{suffix}").read_bytes().startswith(magic)
    assert plot(run, "--out", tmp / "pictures").stdout.splitlines() == [
        str(tmp / "pictures" / "thermo.png"), str(tmp / "pictures" / "rdf.png")]
    assert sorted(run.iterdir()) == before
    fixtures.check_error(plot(run, "--out", tmp / "x.gif"), 2, "must end in .png")


def test_edges_that_change_have_panels(tmp: Path) -> None:
    run = write_run(tmp / "run")
    assert plot(run, "thermo").returncode == 0
    height = png_size(run / "thermo.png")[1]
    lines = (run / "thermo.csv").read_text().splitlines()
    edges = [",edge_x,edge_y,edge_z"] + [f",{8 + 0.01 * math.sin(k)},8.1,{8.2 - 0.001 * k}" for k in range(len(lines) - 1)]
    (run / "thermo.csv").write_text("".join(line + end + "\n" for line, end in zip(lines, edges)))
    result = plot(run, "thermo")
    assert result.returncode == 0, result
    assert png_size(run / "thermo.png")[1] > 1.4 * height, height  # eight panels in place of five


def test_block_averages(tmp: Path) -> None:
    time = np.arange(43.0)
    values = np.where(time < 3, 1e6, np.floor((time - 3) / 2))  # the odd rows at the start are left out
    times, means, error = fluid_pictures.block_averages(time, values)
    assert np.array_equal(means, np.arange(20.0)), means
    assert np.array_equal(times, 3.5 + 2.0 * np.arange(20.0)), times
    assert math.isclose(error, math.sqrt(35.0)), error  # variance of 0 ... 19: 20 * 21 / 12
    times, means, error = fluid_pictures.block_averages(time[:7], time[:7])
    assert np.array_equal(means, [1.5, 3.5, 5.5]), means
    for rows in range(4):
        times, means, error = fluid_pictures.block_averages(time[:rows], values[:rows])
        assert times.size == means.size == 0 and math.isnan(error)


def test_rows_of_a_stage(tmp: Path) -> None:
    run = fluids.load(write_run(tmp / "run"))
    steps = run.thermo["step"][run.rows_of(run.stages[1])]
    assert (steps[0], steps[-1], steps.size) == (1000, 3000, 201), steps


def test_peaks(tmp: Path) -> None:
    r = np.arange(0.01, 3.0, 0.02)
    g = 1.0 + 2.0 * np.exp(-(((r - 1.09) / 0.1) ** 2)) + 0.3 * np.exp(-(((r - 2.05) / 0.2) ** 2))
    places = [r[i] for i in fluid_pictures.peaks(r, g, np.zeros_like(r))]
    assert np.allclose(places, [1.09, 2.05]), places
    places = [r[i] for i in fluid_pictures.peaks(r, g, np.full_like(r, 0.1))]  # the second is three errors high
    assert np.allclose(places, [1.09]), places
    assert fluid_pictures.peaks(r, np.ones_like(r), np.zeros_like(r)) == []
    near_end = 1.0 + np.exp(-(((r - 2.85) / 0.1) ** 2))  # the whole peak is not to be seen
    assert fluid_pictures.peaks(r, near_end, np.zeros_like(r)) == []


def test_summit(tmp: Path) -> None:
    """The middle of a peak, whatever row its noise makes the highest."""
    r = np.arange(0.005, 5.0, 0.01)
    error = np.full_like(r, 0.004)
    farthest = 0.0
    for seed in range(50):
        noise = error * np.random.default_rng(seed).standard_normal(r.size)
        for middle, height, width in ((1.083, 2.0, 0.1), (3.912, 0.05, 0.2)):
            g = 1.0 + height * np.exp(-(((r - middle) / width) ** 2)) + noise
            top = int(np.argmax(g))
            farthest = max(farthest, abs(r[top] - middle))
            place, found = fluid_pictures.summit(r, g, error, top)
            assert abs(place - middle) < 0.02, (seed, place, middle)
            assert abs(found - 1.0 - height) < 0.01, (seed, found)
    assert farthest > 0.05, farthest  # the highest row itself would not have passed
    two = 1.0 + np.exp(-(((r - 1.9) / 0.03) ** 2)) + np.exp(-(((r - 2.1) / 0.03) ** 2))
    top = int(np.argmax(two))
    assert fluid_pictures.summit(r, two, np.full_like(r, 1.0), top) == (r[top], two[top])
    few = np.array([0.0, 1.0, 3.0, 1.0, 0.0])
    assert fluid_pictures.summit(np.arange(5.0), few, np.zeros(5), 2) == (2.0, 3.0)


def test_si_factor(tmp: Path) -> None:
    table = {"time": np.array([0.0, 1.0, 2.0]), "time_ps": np.array([0.0, 2.15, 4.3])}
    assert math.isclose(fluid_pictures.si_factor(table, "time"), 2.15)
    assert fluid_pictures.si_factor({"time": table["time"]}, "time") is None
    assert fluid_pictures.si_factor({"time": np.zeros(3), "time_ps": np.zeros(3)}, "time") is None


def test_number_with_uncertainty(tmp: Path) -> None:
    expected = {
        (0.72184, 0.00123): "0.7218(12)",
        (-5.6, 0.0996): "-5.60(10)",
        (123.4, 5.6): "123.4(56)",
        (1234.0, 56.0): "1234(56)",
        (12345.0, 678.0): "12340(680)",
        (1.5, 0.0): "1.5",
        (1.5, math.nan): "1.5",
    }
    for (mean, error), text in expected.items():
        assert style.with_uncertainty(mean, error) == text, (style.with_uncertainty(mean, error), text)


def test_runs_without_rdf_temperature_or_samples(tmp: Path) -> None:
    run = write_run(tmp / "no-rdf")
    (run / "rdf.csv").unlink()
    result = plot(run)
    assert result.returncode == 0 and result.stdout.splitlines() == [str(run / "thermo.png")], result
    assert result.stderr == "", result.stderr

    run = write_run(tmp / "one-row", rows=1, title=r"50 $ and \unknown 60 $")
    edit(run / "thermo.csv", (run / "thermo.csv").read_text().splitlines()[1].split(",")[2], "")  # no temperature
    result = plot(run)
    assert result.returncode == 0 and result.stderr == "", result
    assert png_size(run / "thermo.png")[1] < 475  # one panel less

    run = write_run(tmp / "not-sampled")
    edit(run / "results.json", '"sampled": true', '"sampled": false')
    edit(run / "results.json", '"mean": 0.72', '"mean": null')
    result = plot(run)
    assert result.returncode == 0 and result.stderr == "", result


DECK = """
[[stage]]
name = "equilibrate"
steps = 1000

[[stage]]
name = "production"
steps = 3000
sample = true
"""


def stop(run: Path, deck: str, settings: list[str]) -> None:
    """Make a run one that was killed: no results, and the last line of each table half written."""
    (run / "results.json").unlink()
    record = json.loads((run / "run.json").read_text())
    (run / "run.json").write_text(json.dumps({**record, "finished": False, "deck": deck, "settings": settings}))
    for path in run.glob("*.csv"):
        path.write_text(path.read_text()[:-5])


def test_runs_that_have_not_ended(tmp: Path) -> None:
    run = write_run(tmp / "run")
    (run / "rdf.csv").unlink()
    stop(run, DECK, ["stage.production.steps=2500"])
    result = plot(run)
    assert result.returncode == 0 and result.stdout.splitlines() == [str(run / "thermo.png")], result
    assert result.stderr == "", result.stderr
    found = fluids.load(run)
    assert found.thermo["step"].size == 300 and found.observables == {}
    assert found.status == "the run has not come to its end: drawn up to step 2990 of 3500", found.status
    (run / "failed.xyz").write_text("")
    assert "blew up" in fluids.load(run).status
    assert [(one.name, one.first_step, one.last_step, one.sampled) for one in found.stages] == [
        ("equilibrate", 0, 1000, False), ("production", 1000, 3500, True)]


def test_tables_of_analyze(tmp: Path) -> None:
    run = write_run(tmp / "run")
    tables = run / "analysis"
    tables.mkdir()
    (run / "rdf.csv").rename(tables / "rdf.csv")
    (tables / "msd.csv").write_text("time,msd,msd_standard_error\n0,0,0\n1,0.5,0.01\n2,1.0,0.02\n")
    result = plot(tables)
    assert result.returncode == 0 and result.stderr == "", result
    assert result.stdout.splitlines() == [str(tables / "rdf.png"), str(tables / "msd.png")], result.stdout
    assert fluids.tables_of_analysis(tables).title == "run"


def test_line_ends_and_byte_order_mark(tmp: Path) -> None:
    run = write_run(tmp / "run")
    text = (run / "thermo.csv").read_text()
    (run / "thermo.csv").write_bytes(b"\xef\xbb\xbf" + text.replace("\n", "\r\n").rstrip().encode())
    assert fluids.load(run).thermo["step"].size == 301


def test_missing_files(tmp: Path) -> None:
    check_error(tmp / "nowhere", 2, "nowhere", "no such file or directory")
    (tmp / "file").write_text("")
    check_error(tmp / "file", 3, "no table of ljmd")
    for name in ("thermo.csv", "results.json"):
        run = write_run(tmp / f"no-{name}")
        (run / name).unlink()
        check_error(run, 3, name, "no such file")


def test_damaged_tables(tmp: Path) -> None:
    cases = {
        "empty": (lambda text: "", "empty"),
        "header-only": (lambda text: HEADER + "\n", "no rows"),
        "column": (lambda text: text.replace("pressure", "presure"), "no column 'pressure'"),
        "cut": (lambda text: text[: text.rindex(",")], "line 302: 6 fields, the header has 7"),
        "word": (lambda text: text.replace("\n10,", "\nten,"), "line 3: 'ten' in column 'step' is not a number"),
        "order": (lambda text: text.replace("\n20,", "\n10,"), "line 4: column 'step'"),
        "time": (lambda text: text.replace("\n10,0.05,", "\n10,,"), "line 3: column 'time'"),
        "nothing": (lambda text: HEADER + "\n0,0.0,,,,,\n", "no numbers"),
    }
    for name, (damage, message) in cases.items():
        run = write_run(tmp / name)
        path = run / "thermo.csv"
        path.write_text(damage(path.read_text()))
        check_error(run, 3, "thermo.csv", message)
    run = write_run(tmp / "binary")
    (run / "thermo.csv").write_bytes(bytes(range(256)))
    check_error(run, 3, "thermo.csv", "not a text file")


def test_damaged_rdf(tmp: Path) -> None:
    run = write_run(tmp / "gap")
    lines = (run / "rdf.csv").read_text().splitlines()
    (run / "rdf.csv").write_text("\n".join([*lines[:5], "0.09,,0.01", *lines[6:]]))
    check_error(run, 3, "rdf.csv: line 6: column 'g'")


def test_damaged_results(tmp: Path) -> None:
    cases = {
        "cut": ('"stages": [', '"stages"', "line 1"),
        "list": ('"stages": [', '"stages": 5, "old": [', "'stages' is 5, must be of type list"),
        "key": ('"first_step": 1000', '"first": 1000', "'first_step' is missing"),
        "text": ('"mean": 0.72', '"mean": "cold"', "'mean' is \"cold\", must be of type float"),
        "number": ('"mean": 0.72', '"mean": true', "'mean' is true, must be of type float"),
        "flag": ('"sampled": true', '"sampled": 1', "'sampled' is 1, must be of type bool"),
        "observable": ('"observables": {', '"observables": {"temperature": 5, ', "'mean'"),
    }
    for name, (old, new, message) in cases.items():
        run = write_run(tmp / name)
        edit(run / "results.json", old, new)
        if name == "observable":
            edit(run / "results.json", '"temperature": {"mean"', '"other": {"mean"')
        check_error(run, 3, "results.json", message)
    run = write_run(tmp / "array")
    (run / "run.json").write_text("[]")
    check_error(run, 3, "run.json", "JSON object")
    (run / "run.json").write_text("[" * 100000)
    check_error(run, 3, "run.json", "nested too deeply")


def test_output_that_cannot_be_written(tmp: Path) -> None:
    run = write_run(tmp / "run")
    (tmp / "file").write_text("")
    result = plot(run, "--out", tmp / "file")
    assert result.returncode == 4 and result.stdout == "", result
    assert len(result.stderr.splitlines()) == 1 and "cannot be written" in result.stderr, result.stderr


if __name__ == "__main__":
    sys.exit(fixtures.run_tests(globals()))
