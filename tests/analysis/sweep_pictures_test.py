#!/usr/bin/env python3
"""Tests of analysis/plot_sweep.py on made-up sweeps. Prints "N passed, M failed"."""

from __future__ import annotations

import json
import sys
from pathlib import Path

import fixtures
import numpy as np
import plot_sweep
import style
from fixtures import check_error, edit, png_size, refused, run_script

HEADER = "system.temperature,system.density,pressure,pressure_standard_error,temperature,temperature_standard_error,remarks"
ROWS = ["1,0.1,0.5,0.01,1.1,0.02,", "1,0.9,5.5,0.11,1.2,,pressure: its error bar is a guess", "1,0.5,2.5,0.05,1.15,0.02,",
        "2,0.1,1.5,0.02,2.1,0.03,", "2,0.5,,,,,", "2,0.9,7.5,,2.3,0.03,"]


def write_sweep(directory: Path, header: str = HEADER, rows: list[str] = ROWS) -> Path:
    directory.mkdir(exist_ok=True)
    keys = [name for name in header.split(",") if "." in name]
    (directory / "sweep.json").write_text(json.dumps({"keys": keys}))
    (directory / "sweep.csv").write_text("\n".join([header, *rows]) + "\n")
    return directory


def drawn(sweep: plot_sweep.Sweep, observable: str, against: str) -> dict[str, np.ndarray]:
    """Label -> (x, y, error) of each line."""
    axes = plot_sweep.plot(sweep, observable, against).axes[0]
    lines = {}
    for container in axes.containers:
        line, _, (*_, bars) = container.lines  # those of y are the last
        lines[container.get_label()] = np.array([(x, y, 0.5 * (top - bottom)) for (x, y), ((_, bottom), (_, top))
                                                 in zip(line.get_xydata(), bars.get_segments())])
    return lines


def test_picture(tmp: Path) -> None:
    result = run_script("plot_sweep.py", write_sweep(tmp / "sweep"))
    assert result.returncode == 0 and result.stderr == "", result
    assert result.stdout.splitlines() == [str(tmp / "sweep" / "pressure.png")], result
    assert png_size(tmp / "sweep" / "pressure.png") == (1400, 960)
    result = run_script("plot_sweep.py", tmp / "sweep", "--observable", "temperature", "--against", "temperature", "--out",
                        tmp / "x.svg")
    assert result.returncode == 0 and (tmp / "x.svg").read_text().startswith("<?xml"), result


def test_a_line_for_each_value_of_the_other_key(tmp: Path) -> None:
    style.use()
    sweep = plot_sweep.load(write_sweep(tmp))
    lines = drawn(sweep, "pressure", "system.density")
    cold, hot = "temperature = 1 (found 1.1 to 1.2)", "temperature = 2 (found 2.1 to 2.3)"
    assert list(lines) == [cold, hot], lines
    assert np.allclose(lines[cold], [(0.1, 0.5, 0.01), (0.5, 2.5, 0.05), (0.9, 5.5, 0.11)]), lines
    assert np.allclose(lines[hot], [(0.1, 1.5, 0.02), (0.9, 7.5, 0.0)]), lines  # one failed, one without error
    lines = drawn(sweep, "pressure", "system.temperature")
    assert list(lines) == ["density = 0.1", "density = 0.9", "density = 0.5"], lines
    assert np.allclose(lines["density = 0.1"], [(1.1, 0.5, 0.01), (2.1, 1.5, 0.02)]), lines


def test_temperatures_are_those_that_were_measured(tmp: Path) -> None:
    """Against a temperature points stand where it was measured, open circles where it was asked."""
    style.use()
    sweep = plot_sweep.load(write_sweep(tmp))
    axes = plot_sweep.plot(sweep, "pressure", "system.temperature").axes[0]
    assert axes.get_xlabel().endswith("measured"), axes.get_xlabel()
    _, _, (across, _) = axes.containers[0].lines
    assert np.allclose([segment[:, 0] for segment in across.get_segments()], [(1.08, 1.12), (2.07, 2.13)])
    circles = [line for line in axes.get_lines() if line.get_fillstyle() == "none"]
    assert np.allclose(circles[0].get_xydata(), [(1.0, 0.5), (2.0, 1.5)]), circles[0].get_xydata()
    assert [text.get_text() for text in axes.get_legend().get_texts()].count("open: temperature asked") == 1
    # The temperature itself is drawn against the one that was asked.
    axes = plot_sweep.plot(sweep, "temperature", "system.temperature").axes[0]
    assert np.allclose(axes.containers[0].lines[0].get_xydata(), [(1.0, 1.1), (2.0, 2.1)])
    # One that was hit has nothing beside it.
    hit = [row.replace("1.1,0.02", "1.04,0.02").replace("1.2,", "1.03,0.02").replace("1.15,", "0.97,") for row in ROWS[:3]]
    assert list(drawn(plot_sweep.load(write_sweep(tmp / "hit", rows=hit)), "pressure", "system.density")) == ["temperature = 1"]


def test_one_key_has_one_line(tmp: Path) -> None:
    sweep = plot_sweep.load(write_sweep(tmp, "system.density,pressure", ["0.5,1", "0.1,2"]))
    axes = plot_sweep.plot(sweep, "pressure", "system.density").axes[0]
    assert len(axes.containers) == 1 and axes.get_legend() is None
    assert np.allclose(axes.containers[0].lines[0].get_xydata(), [(0.1, 2.0), (0.5, 1.0)])


def test_quantities_and_texts_on_the_axis(tmp: Path) -> None:
    sweep = plot_sweep.load(write_sweep(tmp, "system.temperature,pressure", ["90 K,1", '"""86.5 K""",2']))
    axes = plot_sweep.plot(sweep, "pressure", "system.temperature").axes[0]
    assert axes.get_xlabel() == "temperature / K" and np.allclose(axes.containers[0].lines[0].get_xdata(), [86.5, 90.0])
    for rows, ticks in ((["cut,1", "$x$,2"], ["cut", r"\$x\$"]), (["90 K,1", "90,2"], ["90 K", "90"])):
        sweep = plot_sweep.load(write_sweep(tmp, "potential.truncation,pressure", rows))
        axes = plot_sweep.plot(sweep, "pressure", "potential.truncation").axes[0]
        assert [tick.get_text() for tick in axes.get_xticklabels()] == ticks
        assert np.allclose(axes.containers[0].lines[0].get_xydata(), [(0.0, 1.0), (1.0, 2.0)])


def test_values_in_the_legend_are_short(_: Path) -> None:
    values = {"0.33333333333333": "0.333333", "1e-7": "1e-07", "86.5 K": "86.5 K", "leapfrog": "leapfrog"}
    assert {value: plot_sweep.shortened(value) for value in values} == values


def test_numbers_and_units(tmp: Path) -> None:
    for text, expected in (("1.2", (1.2, "")), ("-1e-3", (-1e-3, "")), ("86.5 K", (86.5, "K")), ("86.5K", (86.5, "K")),
                           ('"86.5 K"', (86.5, "K")), ("1.2 g/cm3", (1.2, "g/cm3"))):
        assert plot_sweep.split_unit(text) == expected, text
    for text in ("cut", "", "1.2.3", "[1.0, 2.0]", "K 86"):
        assert np.isnan(plot_sweep.split_unit(text)[0]), text


def test_many_lines(tmp: Path) -> None:
    rows = [f"{t},{x},{t + x}" for t in range(30) for x in range(2)]
    plot_sweep.plot(plot_sweep.load(write_sweep(tmp, "a.t,a.x,pressure", rows)), "pressure", "a.x").savefig(tmp / "x.png")


def test_few_bodies(tmp: Path) -> None:
    sweep = plot_sweep.load(write_sweep(tmp, "stage.orbits.time_step,potential_energy,total_energy", ["0.1,1,2"]))
    assert plot_sweep.choose_observable(sweep, None) == "total_energy"


def test_what_cannot_be_drawn(tmp: Path) -> None:
    check_error(run_script("plot_sweep.py", tmp / "none"), 3, "sweep.json")
    sweep = write_sweep(tmp / "sweep")
    check_error(run_script("plot_sweep.py", sweep, "--out", tmp / "x.txt"), 2, "must end in .png")
    check_error(run_script("plot_sweep.py", sweep, "--observable", "viscosity"), 2, "viscosity", "pressure, temperature")
    none = write_sweep(tmp / "none", "system.density,pressure,total_energy", ["0.1,,1"])  # a single atom has no pressure
    check_error(run_script("plot_sweep.py", none), 2, "no point has a value of 'pressure' (values: total_energy)")
    check_error(run_script("plot_sweep.py", sweep, "--against", "seed"), 2, "no key 'seed'", "system.density")
    both = plot_sweep.load(write_sweep(tmp / "both", "stage.a.steps,stage.b.steps,pressure", ["1,2,3"]))
    refused(lambda: plot_sweep.choose_key(both, "steps"), "more than one", exit_code=2)
    refused(lambda: plot_sweep.load(write_sweep(tmp / "empty", rows=[])), "no rows")
    refused(lambda: plot_sweep.load(write_sweep(tmp / "short", rows=["1,2"])), "line 2", "2 fields")
    refused(lambda: plot_sweep.load(write_sweep(tmp / "word", rows=["1,0.1,x,0.1,1,1,"])), "'x'")
    edit(sweep / "sweep.csv", "system.density", "density")
    refused(lambda: plot_sweep.load(sweep), "does not begin with the keys")
    (sweep / "sweep.csv").unlink()
    refused(lambda: plot_sweep.load(sweep), "no such file")


if __name__ == "__main__":
    sys.exit(fixtures.run_tests(globals()))
