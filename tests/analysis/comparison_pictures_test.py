#!/usr/bin/env python3
"""Tests of analysis/plot.py on made-up comparisons. Prints "N passed, M failed"."""

from __future__ import annotations

import json
import math
import sys
from pathlib import Path
from typing import Any

import fixtures
import numpy as np
import comparison_pictures
import style
from ljmd.reading import comparisons
from fixtures import check_error, edit, png_size, refused, plot

TIME_STEP = 0.005
RATE = 3.5
PAIRINGS = ["leapfrog - VerletIntegrator", "velocity-verlet - kick-drift-kick"]
ALL = ("trajectory", "averages", "rdf")


def distances(time: np.ndarray) -> np.ndarray:
    """Of the first pairing: exp(RATE t) from rounding to more than is fitted, with a little noise; 0 at the start."""
    noise = np.cos(1000.0 * time)
    return np.where(time > 0.0, 3e-14 * np.exp(RATE * time + 0.1 * noise), 0.0)


def check_record(name: str, value: float, tolerance: float) -> dict[str, Any]:
    return {"name": name, "value": value, "tolerance": tolerance, "passed": value <= tolerance}


def write_comparison(directory: Path, program: str = "openmm", parts: tuple[str, ...] = ALL) -> Path:
    """A comparison of some parts, in which the second pairing is too far off at step 100, and the pressure."""
    directory.mkdir(exist_ok=True)
    step = np.arange(0, 2001, 20)
    time = TIME_STEP * step
    checks = [check_record("potential energy", 1e-15, 1e-13), check_record("step 100: kinetic energy", 1e-15, 1e-12)]
    record = {"deck": "some/where/cost $5 $.toml", "with": program, "peer": "Peer 1 (slow)",
              "peer_of_long_runs": "Peer 1 (fast)"}
    if "trajectory" in parts:
        columns = {"step": step, "time": time, PAIRINGS[0]: distances(time), PAIRINGS[1]: 1e-3 * distances(time),
                   "potential_energy_difference": 0.0 * time, "kinetic_energy_difference": 0.0 * time}
        fixtures.write_csv(directory / f"compare-{program}-trajectory.csv", columns)
        checks += [check_record("step 100: leapfrog and VerletIntegrator", 2e-13, 1e-11),
                   check_record("step 1000: leapfrog and VerletIntegrator", 2e-9, 1e-5),
                   check_record("step 100: velocity-verlet and kick-drift-kick", 2e-13, 1e-14)]
        record["trajectory"] = {"time_step": TIME_STEP, "divergence_rate": RATE}
    if "averages" in parts:
        found = {"temperature": (0.72, 0.003, 0.725, 0.004), "pressure": (1.1, 0.03, 0.9, 0.04)}
        observables = {name: {"ljmd": {"mean": row[0], "standard_error": row[1]},
                              "peer": {"mean": row[2], "standard_error": row[3]}} for name, row in found.items()}
        record["averages"] = {"rdf_configurations": 100 if "rdf" in parts else 0, "observables": observables}
        checks += [check_record("mean temperature, standard errors apart", 1.0, 3.0),
                   check_record("mean pressure, standard errors apart", 4.0, 3.0)]
    if "rdf" in parts:
        r = np.arange(0.01, 3.0, 0.02)
        g = 1.0 + 2.0 * np.exp(-(((r - 1.09) / 0.1) ** 2))
        columns = {"r": r, "g_ljmd": g + 0.02, "g_ljmd_standard_error": 0.03 + 0.0 * r, "g_peer": g,
                   "g_peer_standard_error": 0.04 + 0.0 * r}
        fixtures.write_csv(directory / f"compare-{program}-rdf.csv", columns)
    record["checks"] = checks
    (directory / f"compare-{program}.json").write_text(json.dumps(record, indent=1))
    return directory


def draw(directory: Path, program: str = "openmm") -> dict[str, Any]:
    """The panels, by their vertical labels or, of averages, the horizontal one."""
    figure = comparison_pictures.plot(comparisons.load(directory, program))
    figure.canvas.draw()
    panels = {axes.get_ylabel() or axes.get_xlabel(): axes for axes in figure.axes}
    assert len(panels) == len(figure.axes), [axes.get_ylabel() for axes in figure.axes]
    return {"figure": figure, "panels": panels}


def texts(axes: Any) -> list[str]:
    return [text.get_text() for text in axes.get_legend().get_texts()]


DISTANCE = r"distance of the furthest atom / $\sigma$"
AVERAGES = "averages without tail: difference / its standard error"


def test_pictures(tmp: Path) -> None:
    write_comparison(tmp / "both")
    write_comparison(tmp / "both", "lammps")
    result = plot(tmp / "both")
    assert result.returncode == 0 and result.stderr == "", result
    pictures = [tmp / "both" / "compare-openmm.png", tmp / "both" / "compare-lammps.png"]
    assert result.stdout.splitlines() == list(map(str, pictures)), result
    for picture in pictures:
        assert png_size(picture)[0] == 400, picture
    result = plot(tmp / "both", "compare-lammps", "--out", tmp / "new" / "x.svg")
    assert result.returncode == 0 and result.stdout.splitlines() == [str(tmp / "new" / "x.svg")], result
    assert (tmp / "new" / "x.svg").read_text().startswith("<?xml")


def test_what_was_not_compared_is_left_out(tmp: Path) -> None:
    three = [DISTANCE, style.LABELS["g"], "difference", AVERAGES]
    for parts, panels in ((ALL, three), (("trajectory",), three[:1]), (("averages",), three[3:]),
                          (("averages", "rdf"), three[1:]), (("trajectory", "averages"), [three[0], three[3]])):
        write_comparison(tmp, parts=parts)  # over the tables of the first, of which nothing may be drawn
        assert list(draw(tmp)["panels"]) == panels, (parts, panels)


def test_caption(tmp: Path) -> None:
    def caption() -> list[str]:
        figure = draw(tmp)["figure"]
        return [figure._suptitle.get_text(), figure.axes[0].get_title("center")]

    write_comparison(tmp)
    assert caption() == [r"cost \$5 \$.toml against Peer 1 (slow), long runs Peer 1 (fast)", "2 of 7 checks FAILED"]
    edit(tmp / "compare-openmm.json", "Peer 1 (fast)", "Peer 1 (slow)")
    assert caption()[0].endswith("against Peer 1 (slow)"), caption()
    write_comparison(tmp, parts=("averages",))
    assert caption()[0].endswith("against Peer 1 (fast)"), caption()
    text = (tmp / "compare-openmm.json").read_text().replace("false", "true")
    (tmp / "compare-openmm.json").write_text(text)
    assert caption()[1] == "all 4 checks passed", caption()


def test_distances_and_what_is_allowed(tmp: Path) -> None:
    axes = draw(write_comparison(tmp))["panels"][DISTANCE]
    assert axes.get_yscale() == "log"
    time = TIME_STEP * np.arange(20, 2001, 20)  # a logarithm has no place for the start
    lines = {line.get_label(): line for line in axes.lines}
    for k, label in enumerate(("leapfrog, VerletIntegrator", "velocity-verlet, kick-drift-kick")):
        x, y = lines[label].get_data()
        assert np.array_equal(x, time) and np.allclose(y, 1e-3**k * distances(time), rtol=1e-12), label
    marks = [(line.get_xdata(), line.get_ydata(), line.get_color(), line.get_markerfacecolor())
             for line in axes.lines if line.get_marker() == "v" and len(np.atleast_1d(line.get_xdata()))]
    found = [(round(float(np.squeeze(x)), 12), float(np.squeeze(y)), colour, face) for x, y, colour, face in marks]
    assert found == [(0.5, 1e-11, style.BLUE, "none"), (5.0, 1e-5, style.BLUE, "none"),
                     (0.5, 1e-14, style.VERMILION, style.VERMILION)], found
    assert texts(axes) == ["leapfrog, VerletIntegrator", "velocity-verlet, kick-drift-kick",
                           r"$\propto \exp(3.50\,t/\tau)$", "allowed (filled: exceeded)"], texts(axes)
    low, high = axes.get_xlim()
    assert low < 0.0 and high > 10.0, (low, high)


def test_growth_is_drawn_where_it_was_fitted(tmp: Path) -> None:
    axes = draw(write_comparison(tmp))["panels"][DISTANCE]
    line = next(line for line in axes.lines if line.get_linestyle() == "--")
    (first, last), (low, high) = line.get_data()
    time = TIME_STEP * np.arange(20, 2001, 20)
    fitted = time[(distances(time) > 1e-12) & (distances(time) < 1e-2)]
    assert np.allclose([first, last], [fitted[0], fitted[-1]]) and 0.9 < first < last < 9.0, (first, last)
    assert abs(math.log(high / low) / (last - first) - RATE) < 1e-9, line.get_data()
    assert abs(math.log(low / (3e-14 * math.exp(RATE * first)))) < 0.02, low  # noise averages out
    edit(tmp / "compare-openmm.json", f'"divergence_rate": {RATE}', '"divergence_rate": null')
    axes = draw(tmp)["panels"][DISTANCE]
    assert not any(line.get_linestyle() == "--" for line in axes.lines)


def test_equal_trajectories(tmp: Path) -> None:
    """Nothing but zeros, or a single frame: no line, and no complaint."""
    write_comparison(tmp, parts=("trajectory",))
    path = tmp / "compare-openmm-trajectory.csv"
    header, *rows = path.read_text().splitlines()
    path.write_text("\n".join([header, *(",".join([*row.split(",")[:2], "0", "", "0", "0"]) for row in rows)]) + "\n")
    result = plot(tmp)
    assert result.returncode == 0 and result.stderr == "", result
    path.write_text(f"{header}\n0,0,0,0,0,0\n")
    result = plot(tmp)
    assert result.returncode == 0 and result.stderr == "", result


def test_rdf(tmp: Path) -> None:
    panels = draw(write_comparison(tmp))["panels"]
    above, below = panels[style.LABELS["g"]], panels["difference"]
    assert texts(above) == ["ljmd", "OpenMM"], texts(above)
    theirs_r = above.lines[1].get_xdata()
    ours, theirs = (line.get_ydata() for line in above.lines)
    assert np.allclose(ours - theirs, 0.02, rtol=1e-9)
    assert np.allclose(below.lines[0].get_ydata(), 0.02, rtol=1e-9)
    band = below.collections[0].get_paths()[0].vertices[:, 1]
    assert abs(band.max() - 0.05) < 1e-12 and abs(band.min() + 0.05) < 1e-12, band  # of 0.03 and 0.04
    assert below.get_xlim() == above.get_xlim() == (0.0, theirs_r[-1]), below.get_xlim()


def test_averages(tmp: Path) -> None:
    axes = draw(write_comparison(tmp))["panels"][AVERAGES]
    labels = [label.get_text() for label in axes.get_yticklabels()]
    assert labels == ["$T$:  ljmd 0.7200(30),  OpenMM 0.7250(40)", "$p$:  ljmd 1.100(30),  OpenMM 0.900(40)"], labels
    points = [(bars.lines[0].get_xdata()[0], bars.lines[0].get_ydata()[0], bars.lines[0].get_color())
              for bars in axes.containers if hasattr(bars, "has_xerr")]
    assert np.allclose([point[:2] for point in points], [(-1.0, 0), (4.0, 1)]), points
    assert [point[2] for point in points] == [style.BLUE, style.VERMILION], points
    bars = [bars.lines[2][0].get_segments()[0] for bars in axes.containers if hasattr(bars, "has_xerr")]
    assert np.allclose(bars, [[(-2.0, 0), (0.0, 0)], [(3.0, 1), (5.0, 1)]]), bars  # one standard error to each side
    widths = [(patch.get_x(), patch.get_width()) for patch in axes.patches]
    assert widths == [(-3.0, 6.0)] * 2, widths
    low, high = axes.get_xlim()
    assert low < -5.0 and high > 5.0, (low, high)


def test_averages_without_errors(tmp: Path) -> None:
    write_comparison(tmp, parts=("averages",))
    edit(tmp / "compare-openmm.json", '"standard_error": 0.003', '"standard_error": null')
    axes = draw(tmp)["panels"][AVERAGES]
    assert axes.get_yticklabels()[0].get_text() == "$T$:  ljmd 0.72,  OpenMM 0.7250(40)"
    assert len([bars for bars in axes.containers if hasattr(bars, "has_xerr")]) == 1


def test_mistakes(tmp: Path) -> None:
    (tmp / "file").write_text("")
    write_comparison(tmp / "one")
    check_error(plot(tmp / "one", "compare-lammps"), 2, "no picture 'compare-lammps'", "compare-openmm")
    check_error(plot(tmp / "one", "--out", tmp / "file" / "x.png"), 4, "cannot be written")
    write_comparison(tmp / "point", parts=())
    check_error(plot(tmp / "point"), 2, "compare-openmm.json: neither", "nothing to draw")


def test_few_bodies_against_the_adaptive_solution(tmp: Path) -> None:
    time = np.linspace(0.0, 10.0, 50)
    columns = {"step": np.arange(50), "time": time, "position_error": 1e-4 * time, "velocity_error": 2e-4 * time,
               "energy_error": -1e-6 * time, "angular_momentum_error": 0.0 * time, "reference_error": 1e-12 * time}
    fixtures.write_csv(tmp / "compare-gsl.csv", columns)
    (tmp / "compare-gsl.json").write_text(json.dumps({"deck": "inputs/comet.toml"}))
    result = plot(tmp)
    assert result.returncode == 0 and result.stdout.splitlines() == [str(tmp / "compare-gsl.png")], result
    axes = comparison_pictures.draw_gsl(tmp).axes[0]
    lines = {line.get_label(): line.get_xydata() for line in axes.get_lines()}
    assert list(lines) == ["position", "velocity", "energy", "between two\nreferences"], lines  # none of zeros
    assert np.allclose(lines["energy"][:, 1], 1e-6 * time[1:])


def test_damaged_files(tmp: Path) -> None:
    def load() -> None:
        comparisons.load(tmp, "openmm")

    for name in ("compare-openmm-trajectory.csv", "compare-openmm-rdf.csv"):
        (write_comparison(tmp) / name).unlink()
        refused(load, name, "no such file")
    for old, new, words in (('"checks": [', '"checks": [3, ', "an object with 'name'"),
                            ('"tolerance": 1e-13', '"tolerance": "x"', "'tolerance'"),
                            ('"mean": 0.72,', '"mean": [],', "'mean'"),
                            ('"deck"', '"dick"', "'deck' is missing"), ("{", "", "Extra data")):
        edit(write_comparison(tmp) / "compare-openmm.json", old, new)
        refused(load, "compare-openmm.json", words)
    edit(write_comparison(tmp) / "compare-openmm-rdf.csv", "g_peer,", "h,")
    refused(load, "compare-openmm-rdf.csv", "no column 'g_peer'")
    (write_comparison(tmp) / "compare-openmm-trajectory.csv").write_text(
        "step,time,potential_energy_difference,kinetic_energy_difference\n0,0,0,0\n")
    refused(load, "no column with distances")
    edit(write_comparison(tmp) / "compare-openmm-trajectory.csv", PAIRINGS[0], "leapfrog")
    refused(load, "'leapfrog'")


if __name__ == "__main__":
    sys.exit(fixtures.run_tests(globals()))
