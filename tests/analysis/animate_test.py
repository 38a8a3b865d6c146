#!/usr/bin/env python3
"""Tests of analysis/animate.py on made-up runs. Prints "N passed, M failed"; exit code 1 if any failed."""

from __future__ import annotations

import shutil
import sys
from pathlib import Path

import fixtures  # noqa: I001  (it says where the modules of analysis/ are)
import numpy as np
from fixtures import EIGHT, Skipped, check_error, run_script, write_fluid, write_gravity
from PIL import Image


def write_eight(directory: Path) -> Path:
    return write_gravity(directory, **EIGHT, masses=[1, 1, 1], steps=40)


def folder_with(tmp: Path, script: str = "") -> Path:
    """A folder to be the whole PATH: empty, or with an ffmpeg that is a shell script."""
    tmp.mkdir()
    if script:
        (tmp / "ffmpeg").write_text(f"#!/bin/sh\n{script}\n")
        (tmp / "ffmpeg").chmod(0o755)
    return tmp


def test_gif(tmp: Path) -> None:
    run = write_eight(tmp / "run")
    result = run_script("animate.py", run, "--frames", 4, "--fps", 10, "--formats", "gif")
    assert result.returncode == 0 and result.stderr == "", result
    assert result.stdout.splitlines() == [str(run / "animation.gif")], result.stdout
    with Image.open(run / "animation.gif") as film:
        assert film.n_frames == 4 and film.size == (600, 600) and film.info["duration"] == 100, film.info
        first = np.array(film.convert("L"))
        film.seek(3)
        assert np.mean(first != np.array(film.convert("L"))) > 1e-3
    assert sorted(path.name for path in run.iterdir() if "animation" in path.name) == ["animation.gif"]


def test_fluid_and_other_names(tmp: Path) -> None:
    positions = np.random.default_rng(1).uniform(0.0, 4.0, size=(3, 20, 3))
    run = write_fluid(tmp / "run", positions, edge=4.0)
    result = run_script("animate.py", run, "--formats", "gif", "--output", tmp / "new" / "film.of.atoms")
    assert result.returncode == 0 and result.stdout.splitlines() == [str(tmp / "new" / "film.of.atoms.gif")], result
    check_error(run_script("animate.py", run, "--relative-to", 1), 2, "few bodies")


def test_mp4(tmp: Path) -> None:
    if shutil.which("ffmpeg") is None:
        raise Skipped("ffmpeg is not there")
    run = write_eight(tmp / "run")
    result = run_script("animate.py", run, "--frames", 3, "--relative-to", 2)
    assert result.returncode == 0 and result.stderr == "", result
    assert result.stdout.splitlines() == [str(run / "animation.gif"), str(run / "animation.mp4")], result.stdout
    data = (run / "animation.mp4").read_bytes()
    assert data[4:8] == b"ftyp" and b"avc1" in data and b"moov" in data, data[:64]


def test_without_ffmpeg(tmp: Path) -> None:
    run = write_eight(tmp / "run")
    path = folder_with(tmp / "empty")
    result = run_script("animate.py", run, "--frames", 2, "--formats", "mp4,gif", path=path)
    assert result.returncode == 4 and result.stdout.splitlines() == [str(run / "animation.gif")], result
    assert len(result.stderr.splitlines()) == 1 and "ffmpeg was not found" in result.stderr, result.stderr
    assert (run / "animation.gif").exists() and not (run / "animation.mp4").exists()
    assert run_script("animate.py", run, "--frames", 2, "--formats", "gif", path=path).returncode == 0


def test_ffmpeg_that_fails(tmp: Path) -> None:
    run = write_eight(tmp / "run")
    path = folder_with(tmp / "path", 'for last; do :; done; echo half > "$last"; /bin/cat > /dev/null; exit 3')
    result = run_script("animate.py", run, "--frames", 2, "--formats", "mp4", path=path)
    check_error(result, 4, "animation.mp4", "cannot be written")
    assert not list(run.glob("*.mp4")) and not list(run.glob(".ljmd-*")), list(run.iterdir())


def test_mistakes(tmp: Path) -> None:
    run = write_eight(tmp / "run")
    check_error(run_script("animate.py", run, "--relative-to", 4), 2, "no body 4")
    check_error(run_script("animate.py", tmp / "none"), 2, "no such directory")
    for wrong in (("--formats", "gif,avi"), ("--frames", "0"), ("--fps", "nan"), ("--output", "film.gif")):
        result = run_script("animate.py", run, *wrong)
        assert result.returncode == 2 and "error: " in result.stderr, (wrong, result)
    (tmp / "file").write_text("")
    check_error(run_script("animate.py", run, "--output", tmp / "file" / "film"), 4, "cannot be written")
    (run / "trajectory.csv").unlink()
    check_error(run_script("animate.py", run), 3, "no trajectory")


if __name__ == "__main__":
    sys.exit(fixtures.run_tests(globals()))
