#!/usr/bin/env python3
"""Tests of analysis/plot.py, the door to all pictures: what it knows, what it draws of it, what it says."""

from __future__ import annotations

import os
import signal
import subprocess
import sys
from pathlib import Path

import fixtures  # noqa: I001  (it says where the modules of analysis/ are)
import atoms_picture
import fonts
import numpy as np
import sources
import table_pictures
import waiting
from comparison_pictures_test import write_comparison
from fixtures import ANALYSIS, EIGHT, check_error, edit, plot, png_size, refused, write_gravity
from fluid_pictures_test import DECK, stop, write_run
from plain_text_test import HOSTILE
from reproduction_pictures_test import write_table
from sources import Choice
from sweep_pictures_test import write_sweep

XYZ = '2\nLattice="4 0 0 0 4 0 0 0 4" Properties=species:S:1:pos:R:3:velo:R:3 Time=5 step=10 units=reduced\n'
XYZ += "X 0.5 1 3 1 0 0\nX 5 -1 1 0 2 0\n"


def write_analysis(directory: Path) -> Path:
    directory.mkdir()
    write_run(directory / "run")
    (directory / "run" / "rdf.csv").rename(directory / "rdf.csv")
    return directory


def kind(path: Path) -> tuple[str, list[str]]:
    source = sources.recognize(path, Choice())
    return source.kind, list(source.pictures)


def test_kinds_of_directories(tmp: Path) -> None:
    assert kind(write_run(tmp / "fluid")) == ("fluid", ["thermo", "rdf"])
    assert kind(write_gravity(tmp / "bodies", **EIGHT, masses=[1, 1, 1], steps=9)) == (
        "few-body", ["energy", "orbit", "phase", "momentum", "relative"])
    assert kind(write_sweep(tmp / "sweep")) == ("sweep", ["pressure", "temperature"])
    assert kind(write_table(tmp / "table")) == ("reproduction", ["isotherms"])
    assert kind(write_comparison(tmp / "comparison")) == ("comparison", ["compare-openmm"])
    assert kind(write_analysis(tmp / "analysis")) == ("analysis", ["rdf"])
    (tmp / "study").mkdir()
    (tmp / "study" / "convergence.csv").write_text("integrator,time_step,energy_error\na,1,2\na,2,3\n")
    assert kind(tmp / "study") == ("tables", ["convergence"])
    (tmp / "nothing").mkdir()
    refused(lambda: kind(tmp / "nothing"), "holds no run")
    refused(lambda: kind(tmp / ("x" * 300)), "cannot be read: File name too long")


def test_kinds_of_files(tmp: Path) -> None:
    """A file is part of its directory; a table that was copied elsewhere is known by its columns."""
    run = write_run(tmp / "fluid")
    assert kind(run / "thermo.csv") == ("fluid", ["thermo"])
    assert kind(run / "rdf.csv") == ("table", ["rdf"])
    assert kind(run / "run.json") == kind(run / "results.json") == kind(run)
    bodies = write_gravity(tmp / "bodies", **EIGHT, masses=[1, 1, 1], steps=9)
    assert kind(bodies / "thermo.csv") == ("few-body", ["energy", "momentum"])
    assert kind(bodies / "trajectory.csv") == ("few-body", ["orbit", "phase", "relative"])
    assert kind(write_sweep(tmp / "sweep") / "sweep.csv")[0] == "sweep"
    assert kind(write_table(tmp / "table") / "isotherms.csv")[0] == "reproduction"
    both = write_comparison(write_comparison(tmp / "comparison"), "lammps")
    assert kind(both / "compare-lammps-rdf.csv") == ("comparison", ["compare-lammps"])
    (tmp / "mine.csv").write_bytes((run / "rdf.csv").read_bytes())
    result = plot(tmp / "mine.csv", "--out", tmp / "g.png")
    assert result.returncode == 0 and png_size(tmp / "g.png") == (350, 225), result
    assert plot(tmp / "mine.csv").stdout.splitlines() == [str(tmp / "mine.png")]
    (tmp / "notes.txt").write_text("")
    refused(lambda: kind(tmp / "notes.txt"), "no table of ljmd")


def test_names_choose(tmp: Path) -> None:
    run = write_run(tmp / "run")
    assert plot(run, "rdf", "thermo", "rdf").stdout.splitlines() == [str(run / "rdf.png"), str(run / "thermo.png")]
    check_error(plot(run, "rdff"), 2, "no picture 'rdff'", "thermo, rdf", "did you mean 'rdf'?")
    check_error(plot(run, "--against", "density"), 2, "--against is for a sweep")
    check_error(plot(write_sweep(tmp / "sweep"), "--relative-to", 1), 2, "--relative-to is for a run of few bodies")
    assert plot(run, "--nonsense").returncode == 2


def test_endings(tmp: Path) -> None:
    run = write_run(tmp / "run")
    for ending, magic in ((".png", b"\x89PNG"), (".svg", b"<?xml"), (".pdf", b"%PDF")):
        assert plot(run, "rdf", "--out", tmp / f"x{ending}").stdout.splitlines() == [str(tmp / f"x{ending}")]
        assert (tmp / f"x{ending}").read_bytes().startswith(magic), ending
    first = (tmp / "x.svg").read_bytes()
    plot(run, "rdf", "--out", tmp / "x.svg")
    assert (tmp / "x.svg").read_bytes() == first  # the same picture is the same file
    check_error(plot(run, "--out", tmp / "x.gif"), 2, "must end in .png, .pdf, .svg, or be a directory")
    (tmp / "dotted.d").mkdir()
    assert plot(run, "rdf", "--out", tmp / "dotted.d").stdout.splitlines() == [str(tmp / "dotted.d" / "rdf.png")]


def test_runs_that_have_not_ended(tmp: Path) -> None:
    run = write_run(tmp / "stopped")
    stop(run, DECK, [])
    (run / "failed.xyz").write_text(XYZ)
    assert plot(run).stdout.splitlines() == [str(run / f"{name}.png") for name in ("thermo", "atoms", "rdf")]
    bodies = write_gravity(tmp / "bodies", **EIGHT, masses=[1, 1, 1], steps=30)
    record = '{"kind": "few-body", "title": "t", "finished": false, "settings": [], "deck": "%s"}'
    deck = ["[force]", "type = 'newtonian-gravity'", *3 * ["[[body]]", "position = [0, 0]"], "[[stage]]", "steps = 90"]
    (bodies / "run.json").write_text(record % "\\n".join(deck))
    (bodies / "results.json").unlink()
    figure = sources.recognize(bodies, Choice()).pictures["energy"]()
    assert "drawn up to step 30 of 90" in figure.axes[0].get_title("center"), figure.axes[0].get_title("center")
    (run / "thermo.csv").write_text((run / "thermo.csv").read_text().splitlines()[0] + "\n")
    check_error(plot(run), 3, "thermo.csv: no rows below the header")


def test_atoms(tmp: Path) -> None:
    run = write_run(tmp / "run")
    (run / "final.xyz").write_text(XYZ)
    figure = atoms_picture.plot_atoms(run, run / "final.xyz")
    title = figure.axes[0].get_title("center")
    assert title == r"last configuration: 2 atoms; box 4 $\times$ 4 $\times$ 4 $\sigma$$^3$", title
    assert figure.axes[1].get_ylabel() == r"speed / ($\sigma/\tau$)"
    edit(run / "final.xyz", "X 0.5 1 3", "X nan 1 3")
    check_error(plot(run, "atoms"), 3, "final.xyz", "no numbers")


def test_hostile_titles_are_shown_as_text(tmp: Path) -> None:
    run = write_run(tmp / "$\\alpha <b>", title=HOSTILE)
    (run / "final.xyz").write_text(XYZ)
    result = plot(run)
    assert result.returncode == 0 and len(result.stdout.splitlines()) == 3, result
    assert result.stderr in ("", fonts.remark(set("\u65e5\u672c")) + "\n"), result  # none where a font has them
    analysis = write_analysis(tmp / "x$^{2$ y$")
    assert plot(analysis).returncode == 0
    sweep = write_sweep(tmp / "sweep", "potential.truncation,system.density,pressure", ['"a $x^{ b",0.1,1', '"<\u05d0\u05d1>",0.2,2'])
    for key in ("truncation", "density"):
        result = plot(sweep, "--against", key)
        assert result.returncode == 0 and result.stderr == "", result


def test_names_of_files_are_bytes(tmp: Path) -> None:
    """A name that is not UTF-8 is printed as it is; what commands a terminal never reaches one."""
    run = os.fsencode(tmp) + b"/run \xff\x1b[31m"
    write_run(tmp / "run").rename(os.fsdecode(run))
    command = [sys.executable, ANALYSIS / "plot.py", run]
    environment = {**os.environ, "LC_ALL": "C.UTF-8"}
    result = subprocess.run([*command, "rdf"], capture_output=True, check=False, env=environment)
    assert result.stdout == run + b"/rdf.png\n" and result.stderr == b"", result
    result = subprocess.run([*command, "nothing"], capture_output=True, check=False, env=environment)
    assert result.returncode == 2 and b"\x1b" not in result.stderr and b"?[31m" in result.stderr, result


def test_any_table(tmp: Path) -> None:
    """Columns against the one that the table goes along, with bands, a line for each text, steep ones on a log scale."""
    path = tmp / "convergence.csv"
    path.write_text("integrator,time_step,energy_error,energy_error_standard_error\na,1,1e-8,1e-9\na,2,1e-2,1e-9\nb,1,3,0\nb,2,,\n")
    axes = table_pictures.plot_table(path, "errors").axes[0]
    lines = axes.get_lines()
    assert [line.get_label() for line in lines] == ["a", "b"] and axes.get_yscale() == "log"
    assert np.array_equal(lines[0].get_xydata(), [(1.0, 1e-8), (2.0, 1e-2)]) and len(axes.collections) == 2
    assert axes.get_xlabel() == "time step" and axes.get_ylabel() == "energy error"
    path.write_text("apocentre,time,distance\n1,0.5,2\n0,1.5,1\n1,2")  # the last line is being written
    figure = table_pictures.plot_table(path, "orbit")
    assert [axes.get_ylabel() for axes in figure.axes] == ["apocentre", "distance"]
    for text, words in (("", "empty"), ("a,b\n", "no rows"), ("a\n1\n", "fewer than two columns"), ("a,b\n1,2\n1\n1,3\n", "line 3: 1 fields"),
                        ("a,b\n1,\n", "no numbers")):
        path.write_text(text)
        refused(lambda: table_pictures.plot_table(path, ""), "convergence.csv", words)


def test_a_python_without_modules_says_what_to_install(tmp: Path) -> None:
    (tmp / "site").mkdir()
    (tmp / "site" / "sitecustomize.py").write_text(
        "import importlib.util\nold = importlib.util.find_spec\n"
        "importlib.util.find_spec = lambda name, *rest: None if name == 'matplotlib' else old(name, *rest)\n")
    environment = {**os.environ, "PYTHONPATH": str(tmp / "site")}
    result = subprocess.run([sys.executable, str(ANALYSIS / "plot.py"), str(tmp)], capture_output=True, text=True, check=False,
                            env=environment)
    check_error(result, 2, "pictures need matplotlib", "apt-get install python3-matplotlib", "pip install matplotlib")


def test_ctrl_c_ends_it_without_a_word(tmp: Path) -> None:
    run = write_run(tmp / "run")
    os.mkfifo(tmp / "pipe")
    (tmp / "site").mkdir()
    (tmp / "site" / "sitecustomize.py").write_text(  # reading a table waits for ever
        "import pathlib\nread = pathlib.Path.read_text\n\n\ndef waiting(path, **how):\n"
        f"    if path.suffix == '.csv':\n        open({str(tmp / 'pipe')!r}).read()\n    return read(path, **how)\n\n\n"
        "pathlib.Path.read_text = waiting\n")
    with subprocess.Popen([sys.executable, str(ANALYSIS / "plot.py"), str(run)], stderr=subprocess.PIPE, text=True,
                          env={**os.environ, "PYTHONPATH": str(tmp / "site")}) as process:
        with open(tmp / "pipe", "w", encoding="utf-8"):  # waits until it is read
            process.send_signal(signal.SIGINT)
        assert process.wait(timeout=waiting.PATIENCE) == -signal.SIGINT
        assert process.stderr.read() == ""
    assert [path.name for path in run.iterdir() if path.suffix == ".png" or path.name.startswith(".half")] == []


if __name__ == "__main__":
    sys.exit(fixtures.run_tests(globals()))
