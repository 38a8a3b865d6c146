#!/usr/bin/env python3
"""Tests of analysis/plot.py on made-up sweeps. Prints "N passed, M failed"."""

from __future__ import annotations

import json
import sys
from pathlib import Path
from typing import Any

import fixtures
import numpy as np
import program
import sweep_pictures
import style
from ljmd.reading import sweeps
from fixtures import check_error, edit, png_size, refused, plot

HEADER = "system.temperature,system.density,pressure,pressure_standard_error,temperature,temperature_standard_error,remarks"
ROWS = ["1,0.1,0.5,0.01,1.1,0.02,", "1,0.9,5.5,0.11,1.2,,pressure: its error bar is a guess", "1,0.5,2.5,0.05,1.15,0.02,",
        "2,0.1,1.5,0.02,2.1,0.03,", "2,0.5,,,,,", "2,0.9,7.5,,2.3,0.03,"]


def write_sweep(directory: Path, header: str = HEADER, rows: list[str] = ROWS) -> Path:
    directory.mkdir(exist_ok=True)
    keys = [name for name in header.split(",") if "." in name]
    (directory / "sweep.json").write_text(json.dumps({"keys": keys, "points": []}))
    (directory / "sweep.csv").write_text("\n".join([header, *rows]) + "\n")
    return directory


def drawn(sweep: sweeps.SweepTable, observable: str, against: str) -> dict[str, np.ndarray]:
    """Label -> (x, y, error) of each line."""
    axes = sweep_pictures.plot(sweep, observable, against).axes[0]
    lines = {}
    for container in axes.containers:
        line, _, (*_, bars) = container.lines  # those of y are the last
        lines[container.get_label()] = np.array([(x, y, 0.5 * (top - bottom)) for (x, y), ((_, bottom), (_, top))
                                                 in zip(line.get_xydata(), bars.get_segments())])
    return lines


def test_picture(tmp: Path) -> None:
    result = plot(write_sweep(tmp / "sweep"))
    assert result.returncode == 0 and result.stderr == "", result
    assert result.stdout.splitlines() == [str(tmp / "sweep" / "pressure.png")], result
    assert png_size(tmp / "sweep" / "pressure.png") == (350, 245)
    result = plot(tmp / "sweep", "temperature", "--against", "temperature", "--out", tmp / "x.svg")
    assert result.returncode == 0 and (tmp / "x.svg").read_text().startswith("<?xml"), result


def test_a_line_for_each_value_of_the_other_key(tmp: Path) -> None:
    style.use()
    sweep = sweeps.load(write_sweep(tmp))
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
    sweep = sweeps.load(write_sweep(tmp))
    axes = sweep_pictures.plot(sweep, "pressure", "system.temperature").axes[0]
    assert axes.get_xlabel().endswith("measured"), axes.get_xlabel()
    _, _, (across, _) = axes.containers[0].lines
    assert np.allclose([segment[:, 0] for segment in across.get_segments()], [(1.08, 1.12), (2.07, 2.13)])
    circles = [line for line in axes.get_lines() if line.get_markerfacecolor() == "white"]
    assert np.allclose(circles[0].get_xydata(), [(1.0, 0.5), (2.0, 1.5)]), circles[0].get_xydata()
    texts = [text.get_text() for text in axes.get_legend().get_texts()]
    assert texts[-2:] == ["filled: temperature measured", "open: temperature asked"], texts
    # The temperature itself is drawn against the one that was asked.
    axes = sweep_pictures.plot(sweep, "temperature", "system.temperature").axes[0]
    assert np.allclose(axes.containers[0].lines[0].get_xydata(), [(1.0, 1.1), (2.0, 2.1)])
    # One that was hit has nothing beside it.
    hit = [row.replace("1.1,0.02", "1.04,0.02").replace("1.2,", "1.03,0.02").replace("1.15,", "0.97,") for row in ROWS[:3]]
    assert list(drawn(sweeps.load(write_sweep(tmp / "hit", rows=hit)), "pressure", "system.density")) == ["temperature = 1"]


def test_one_key_has_one_line(tmp: Path) -> None:
    sweep = sweeps.load(write_sweep(tmp, "system.density,pressure", ["0.5,1", "0.1,2"]))
    axes = sweep_pictures.plot(sweep, "pressure", "system.density").axes[0]
    assert len(axes.containers) == 1 and axes.get_legend() is None
    assert np.allclose(axes.containers[0].lines[0].get_xydata(), [(0.1, 2.0), (0.5, 1.0)])


def test_quantities_and_texts_on_the_axis(tmp: Path) -> None:
    sweep = sweeps.load(write_sweep(tmp, "system.temperature,pressure", ["90 K,1", '"""86.5 K""",2']))
    axes = sweep_pictures.plot(sweep, "pressure", "system.temperature").axes[0]
    assert axes.get_xlabel() == "temperature / K" and np.allclose(axes.containers[0].lines[0].get_xdata(), [86.5, 90.0])
    for rows, ticks in ((["cut,1", "$x$,2"], ["cut", r"\$x\$"]), (["90 K,1", "90,2"], ["90 K", "90"])):
        sweep = sweeps.load(write_sweep(tmp, "potential.truncation,pressure", rows))
        axes = sweep_pictures.plot(sweep, "pressure", "potential.truncation").axes[0]
        assert [tick.get_text() for tick in axes.get_xticklabels()] == ticks
        assert not [line for line in axes.get_lines() if line.get_linestyle() != "None" and len(line.get_xdata()) > 1]
        assert np.allclose(axes.containers[0].lines[0].get_xydata(), [(0.0, 1.0), (1.0, 2.0)])


def test_values_in_the_legend_are_short(_: Path) -> None:
    values = {"0.33333333333333": "0.333333", "1e-7": "1e-07", "86.5 K": "86.5 K", "leapfrog": "leapfrog"}
    assert {value: sweep_pictures.shortened(value) for value in values} == values


def test_numbers_and_units(tmp: Path) -> None:
    for text, expected in (("1.2", (1.2, "")), ("-1e-3", (-1e-3, "")), ("86.5 K", (86.5, "K")), ("86.5K", (86.5, "K")),
                           ('"86.5 K"', (86.5, "K")), ("1.2 g/cm3", (1.2, "g/cm3"))):
        assert sweep_pictures.split_unit(text) == expected, text
    for text in ("cut", "", "1.2.3", "[1.0, 2.0]", "K 86"):
        assert np.isnan(sweep_pictures.split_unit(text)[0]), text


def write_points(directory: Path, equation: str = "thol2016", ended: int = 3) -> Path:
    """A sweep over density. Some points have ended; there is no table yet."""
    points = [{"name": f"density={rho}", "values": [str(rho)]} for rho in (0.1, 0.2, 0.3)]
    (directory / "points").mkdir(parents=True)
    (directory / "sweep.json").write_text(json.dumps({"keys": ["system.density"], "points": points}))
    for point in points[:ended]:
        rho = float(point["values"][0])
        folder = directory / "points" / point["name"]
        folder.mkdir()
        means = {"temperature": (1.0 + rho, 0.01), "pressure": (2.0 * rho, 0.02)}
        (folder / "results.json").write_text(json.dumps({
            "title": "gas", "system": {"density": rho}, "equation_of_state": equation,
            "observables": {name: {"mean": mean, "standard_error": error} for name, (mean, error) in means.items()}}))
    return directory


def test_a_sweep_that_goes_on_is_drawn_as_far_as_it_got(tmp: Path) -> None:
    style.use()
    sweep = sweeps.load(write_points(tmp / "sweep", ended=2))
    assert sweep.title == "gas" and sweep.status == "the sweep has not come to its end: 2 of 3 points", sweep
    assert np.allclose(drawn(sweep, "pressure", "system.density")[""], [(0.1, 0.2, 0.02), (0.2, 0.4, 0.02)])
    assert plot(tmp / "sweep").stdout.splitlines() == [str(tmp / "sweep" / "pressure.png")]
    check_error(plot(write_points(tmp / "none", ended=0)), 3, "no point has come to its end")


def test_the_equation_of_state_stands_beside_the_points(tmp: Path) -> None:
    """At the measured temperature and the density of each point; not where it is not to be relied on."""
    style.use()
    asked = []

    def answer(*arguments: str) -> dict[str, Any]:
        assert arguments[:3] == ("eos", "--model", "thol2016"), arguments
        temperature, density = float(arguments[4]), float(arguments[6])
        asked.append((temperature, density))
        return {"pressure": temperature * density, "warnings": ["no stable phase"] if density < 0.15 else []}

    original, program.answer = program.answer, answer
    try:
        axes = sweep_pictures.plot(sweeps.load(write_points(tmp / "sweep")), "pressure", "system.density").axes[0]
    finally:
        program.answer = original
    assert np.allclose([T for T, _ in asked], [1.0 + rho for _, rho in asked]), asked
    curve = next(line.get_xydata() for line in axes.get_lines() if len(line.get_xdata()) > 10)
    assert np.isnan(curve[0, 1]) and np.allclose(curve[-1], (0.3, 0.39)), curve
    texts = [text.get_text() for text in axes.get_legend().get_texts()]
    assert texts == ["equation of state thol2016,\nwhere one phase is stable"], texts
    # Fluids without one, and programs that are not there, have points joined by a line.
    for directory in (write_points(tmp / "soft", equation=None), tmp / "sweep"):
        program.answer = lambda *_: None
        try:
            axes = sweep_pictures.plot(sweeps.load(directory), "pressure", "system.density").axes[0]
        finally:
            program.answer = original
        assert axes.get_legend() is None and len(axes.get_lines()[0].get_xdata()) == 3


def test_an_isotherm_does_not_follow_the_noise_of_its_temperature(_: Path) -> None:
    assert sweep_pictures.one_temperature(np.array([1.51, 1.48]), np.array([0.02, 0.01])) == (1.51 + 4 * 1.48) / 5
    assert sweep_pictures.one_temperature(np.array([1.6, 1.48]), np.array([0.02, 0.01])) is None
    assert sweep_pictures.one_temperature(np.array([1.5, 1.5]), np.array([0.0, 0.01])) is None


def test_replicas_stand_beside_what_all_of_them_say(tmp: Path) -> None:
    directory = write_points(tmp / "replicas")
    request = json.loads((directory / "sweep.json").read_text()) | {"keys": ["system.seed"], "replicas": 3}
    (directory / "sweep.json").write_text(json.dumps(request))
    (directory / "results.json").write_text(json.dumps({"observables": {"pressure": {"mean": 0.41, "standard_error": 0.03}}}))
    (directory / "rdf.csv").write_text("r,g,g_standard_error\n0.5,0,0\n1.5,1.2,0.01\n2.5,1,0.01\n")
    figure = sweep_pictures.plot(sweeps.load(directory), "pressure", "replica")
    axes = figure.axes[0]
    assert [text.get_text() for text in axes.get_xticklabels()] == ["1", "2", "3"]
    assert [line.get_ydata()[0] for line in axes.get_lines() if line.get_label() == "all replicas"] == [0.41]
    assert not any("one seed" in text.get_text() for text in [*figure.texts, axes.title]), "each has its own"
    assert plot(directory).stdout.splitlines() == [str(directory / "pressure.png"), str(directory / "rdf.png")]
    alike = sweep_pictures.plot(sweeps.load(write_points(tmp / "points")), "pressure", "system.density")
    assert any("one seed" in text.get_text() for text in [*alike.texts, alike.axes[0].title])


def test_many_lines(tmp: Path) -> None:
    rows = [f"{t},{x},{t + x}" for t in range(30) for x in range(2)]
    sweep_pictures.plot(sweeps.load(write_sweep(tmp, "a.t,a.x,pressure", rows)), "pressure", "a.x").savefig(tmp / "x.png")


def test_few_bodies(tmp: Path) -> None:
    sweep = sweeps.load(write_sweep(tmp, "stage.orbits.time_step,potential_energy,total_energy", ["0.1,1,2"]))
    assert sweep_pictures.usual(list(sweep.observables)) == ["total_energy"]


def test_what_cannot_be_drawn(tmp: Path) -> None:
    sweep = write_sweep(tmp / "sweep")
    check_error(plot(sweep, "--out", tmp / "x.txt"), 2, "must end in .png")
    check_error(plot(sweep, "viscosity"), 2, "viscosity", "pressure, temperature")
    check_error(plot(sweep, "presure"), 2, "did you mean 'pressure'?")
    none = write_sweep(tmp / "none", "system.density,pressure,total_energy", ["0.1,,1"])  # a single atom has no pressure
    check_error(plot(none, "pressure"), 2, "no picture 'pressure' (there are: total_energy)")
    check_error(plot(sweep, "--against", "seed"), 2, "no key 'seed'", "system.density")
    both = sweeps.load(write_sweep(tmp / "both", "stage.a.steps,stage.b.steps,pressure", ["1,2,3"]))
    refused(lambda: sweep_pictures.choose_key(both, "steps"), "more than one", exit_code=2)
    refused(lambda: sweeps.load(write_sweep(tmp / "empty", rows=[])), "no rows")
    refused(lambda: sweeps.load(write_sweep(tmp / "short", rows=["1,2"])), "line 2", "2 fields")
    refused(lambda: sweeps.load(write_sweep(tmp / "word", rows=["1,0.1,x,0.1,1,1,"])), "'x'")
    edit(sweep / "sweep.csv", "system.density", "density")
    refused(lambda: sweeps.load(sweep), "does not begin with the keys")
    (sweep / "sweep.csv").unlink()
    refused(lambda: sweeps.load(sweep), "no point has come to its end")
    edit(sweep / "sweep.json", "points", "places")
    refused(lambda: sweeps.load(sweep), "sweep.json", "'points'")


if __name__ == "__main__":
    sys.exit(fixtures.run_tests(globals()))
