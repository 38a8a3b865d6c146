#!/usr/bin/env python3
"""Pictures, films and tables under names at which something is. Prints "N passed, M failed"."""

from __future__ import annotations

import os
import resource
import stat
import subprocess
import sys
from pathlib import Path
from typing import Any, Iterator

import fixtures
from convergence_test import prepare as prepare_convergence
from fixtures import ANALYSIS, Skipped, write_gravity
import style


def commands(tmp: Path) -> Iterator[tuple[Path, list[Any]]]:
    """The file of each output, and the command that writes it."""
    run = write_gravity(tmp / "few", **fixtures.EIGHT, masses=[1, 1, 1], steps=20)
    for ending in style.FORMATS:
        yield tmp / f"x{ending}", ["plot.py", run, "orbit", "--out", tmp / f"x{ending}"]
    for kind in ("gif", "mp4"):
        yield tmp / f"x.{kind}", ["animate.py", run, "--frames", 2, "--output", tmp / "x", "--formats", kind]
    deck, program, _ = prepare_convergence(tmp)
    for name in ("convergence.csv", "convergence.png"):
        yield tmp / "out" / name, ["convergence.py", deck, "--ljmd", program, "--output", tmp / "out"]


def run(command: list[Any], *more: Any, **options: Any) -> subprocess.CompletedProcess[str]:
    words = [sys.executable, str(ANALYSIS / command[0]), *map(str, [*command[1:], *more])]
    return subprocess.run(words, capture_output=True, text=True, check=False, **options)


def tree(folder: Path) -> dict[str, Any]:
    found: dict[str, Any] = {}
    for path in sorted(folder.rglob("*")):
        kind = path.lstat().st_mode
        found[str(path)] = os.readlink(path) if stat.S_ISLNK(kind) else path.read_bytes() if stat.S_ISREG(kind) else kind
    return found


def refused(tmp: Path, path: Path, command: list[Any], code: int, *more: Any, **options: Any) -> None:
    before = tree(tmp)
    result = run(command, *more, **options)
    assert result.returncode == code and path.name in result.stderr and result.stderr.count("error: ") == 1, (path, result)
    assert tree(tmp) == before, (path, set(tree(tmp)) ^ set(before))


def each(tmp: Path) -> Iterator[tuple[Path, list[Any]]]:
    for path, command in commands(tmp):
        path.parent.mkdir(exist_ok=True)
        yield path, command
        for name in (path.name, "convergence.csv", "convergence.png"):
            (path.parent / name).unlink(missing_ok=True)


def test_foreign_files_links_directories_and_pipes(tmp: Path) -> None:
    (tmp / "precious").write_text("mine")
    for path, command in each(tmp):
        path.write_text("mine")
        refused(tmp, path, command, 2)
        path.unlink()
        path.symlink_to(tmp / "precious")
        refused(tmp, path, command, 2)
        path.unlink()
        for make, take_away in ((os.mkdir, os.rmdir), (os.mkfifo, os.unlink)):
            make(path)
            refused(tmp, path, command, 2, "--force")
            take_away(path)


def test_force_replaces_a_link_itself_and_older_ones_are_replaced_without(tmp: Path) -> None:
    (tmp / "precious").write_text("mine")
    for path, command in each(tmp):
        path.symlink_to(tmp / "precious")
        for more in (("--force",), ()):
            result = run(command, *more)
            if "ffmpeg" in result.stderr:
                raise Skipped("no ffmpeg")
            assert result.returncode == 0 and not path.is_symlink() and path.stat().st_size > 4, (path, result)
            assert (tmp / "precious").read_text() == "mine" and not list(tmp.rglob(".ljmd-*")), path


def test_full_disks_leave_the_older_one(tmp: Path) -> None:
    for path, command in each(tmp):
        result = run(command)
        if "ffmpeg" in result.stderr:
            raise Skipped("no ffmpeg")
        assert result.returncode == 0, (path, result)
        # The table of a convergence comes first, and has to find room.
        table = path.with_name("convergence.csv")
        least = table.stat().st_size if path.name == "convergence.png" else 100
        assert path.stat().st_size > least, path
        refused(tmp, path, command, 4, preexec_fn=lambda room=least: resource.setrlimit(resource.RLIMIT_FSIZE, (room, room)))


if __name__ == "__main__":
    sys.exit(fixtures.run_tests(globals()))
