"""What the tests of analysis/ share: made-up run directories, scripts run as a person runs them, a test runner."""

from __future__ import annotations

import contextlib
import io
import json
import os
import struct
import subprocess
import sys
import tempfile
import traceback
from pathlib import Path
from typing import Any, Callable, Optional
from unittest import mock

ANALYSIS = Path(__file__).resolve().parents[2] / "analysis"
sys.path[:0] = [str(ANALYSIS), str(Path(__file__).resolve().parents[1])]

import numpy as np  # noqa: E402
import script  # noqa: E402  (it finds the package ljmd)
from ljmd.errors import Error  # noqa: E402

EIGHT = {  # Chenciner and Montgomery's figure eight: three equal masses with G = 1, positions and velocities
    "positions": [[0.97000436, -0.24308753], [-0.97000436, 0.24308753], [0.0, 0.0]],
    "velocities": [[0.46620368, 0.43236573], [0.46620368, 0.43236573], [-0.93240737, -0.86473146]],
}


class Skipped(Exception):
    """Raised by a test that this machine cannot run, with the reason."""


def run_script(script: str, *arguments: Any, path: Optional[Path] = None) -> subprocess.CompletedProcess[str]:
    """Run a script of analysis/; `path` replaces PATH."""
    environment = os.environ if path is None else {**os.environ, "PATH": str(path)}
    command = [sys.executable, str(ANALYSIS / script), *map(str, arguments)]
    return subprocess.run(command, capture_output=True, text=True, check=False, env=environment)


def plot(*arguments: Any) -> subprocess.CompletedProcess[str]:
    """plot.py in this process, with coarse pictures (50 dots an inch): a process of its own takes a second, and so do fine ones."""
    import plot as script

    out, err = io.StringIO(), io.StringIO()
    coarse = mock.patch.object(script.style, "use", lambda: script.style.plt.style.use([script.style.STYLE, {"savefig.dpi": 50}]))
    with contextlib.redirect_stdout(out), contextlib.redirect_stderr(err), coarse:
        try:
            code = script.main([str(argument) for argument in arguments])
        except SystemExit as end:  # of argparse
            code = end.code
    return subprocess.CompletedProcess(list(arguments), code, out.getvalue(), err.getvalue())


def check_error(result: subprocess.CompletedProcess[str], exit_code: int, *words: str) -> None:
    """The script ended with that code and one line on stderr that holds all words."""
    assert result.returncode == exit_code, result
    assert result.stdout == "", result.stdout
    lines = result.stderr.splitlines()
    assert len(lines) == 1 and lines[0].startswith("error: "), result.stderr
    for word in words:
        assert word in lines[0], (word, lines[0])


def refused(action: Callable[[], Any], *words: str, exit_code: int = 3) -> None:
    """The action raises that error, with all words in its message."""
    try:
        action()
    except Error as error:
        assert script.EXIT_CODES[type(error)] == exit_code, repr(error)
        assert all(word in str(error) for word in words), error
    else:
        raise AssertionError(f"accepted; {words} expected")


def edit(path: Path, old: str, new: str) -> None:
    text = path.read_text()
    assert old in text, (old, path)
    path.write_text(text.replace(old, new, 1))


def png_size(path: Path) -> tuple[int, int]:
    data = path.read_bytes()
    assert data[:8] == b"\x89PNG\r\n\x1a\n", path
    return struct.unpack(">II", data[16:24])


def gravity(positions: np.ndarray, masses: np.ndarray, softening: float = 0.0) -> np.ndarray:
    """Accelerations of bodies (N, d) that attract each other, with G = 1."""
    separation = positions[np.newaxis] - positions[:, np.newaxis]
    square = (separation**2).sum(axis=2) + softening**2
    square[square == 0.0] = 1.0  # of a body with itself, where the separation is 0 as well
    return (masses[np.newaxis, :, np.newaxis] * separation / square[:, :, np.newaxis] ** 1.5).sum(axis=1)


def write_gravity(directory: Path, positions: Any, velocities: Any, masses: Any, steps: int = 400, **more: Any) -> Path:
    """A run of bodies under their own gravity by velocity Verlet, every row written."""
    r, v, m = np.array(positions, float), np.array(velocities, float), np.array(masses, float)
    softening, time_step = more.get("softening", 0.0), more.get("time_step", 0.016)
    frames = []
    a = gravity(r, m, softening)
    for _ in range(steps + 1):
        frames.append((r, v, a))
        half = v + 0.5 * time_step * a
        r = r + time_step * half
        a = gravity(r, m, softening)
        v = half + 0.5 * time_step * a
    r, v, a = (np.array([frame[k] for frame in frames]) for k in range(3))
    separation = np.linalg.norm(r[:, :, np.newaxis] - r[:, np.newaxis], axis=3)
    i, j = np.triu_indices(len(m), 1)
    thermo = {
        "potential_energy": -(m[i] * m[j] / np.sqrt(separation[:, i, j] ** 2 + softening**2)).sum(axis=1),
        "kinetic_energy": 0.5 * (m * (v**2).sum(axis=2)).sum(axis=1),
    }
    for k, axis in enumerate("xyz"[: r.shape[2]]):
        thermo[f"momentum_{axis}"] = (m * v[:, :, k]).sum(axis=1)
    if r.shape[2] == 2:
        thermo["angular_momentum_z"] = (m * (r[:, :, 0] * v[:, :, 1] - r[:, :, 1] * v[:, :, 0])).sum(axis=1)
    force = f'[force]\ntype = "newtonian-gravity"\ngravitational_constant = 1.0\nsoftening = {softening}\n'
    deck = force + "".join(
        f"[[body]]\nmass = {float(mass)!r}\nposition = {list(map(float, place))}\n" for mass, place in zip(m, r[0])
    )
    return write_few_body(directory, time_step * np.arange(steps + 1), r, v, a, thermo=thermo, deck=deck)


def write_few_body(directory: Path, time: np.ndarray, r: np.ndarray, v: np.ndarray, a: Optional[np.ndarray] = None,
                   **more: Any) -> Path:
    """A run directory from arrays (frame, body, axis); `more`: force, thermo, angle, deck."""
    directory.mkdir(parents=True)
    bodies, dimensions = r.shape[1:]
    columns = {"step": np.arange(len(time)), "time": time}
    for body in range(bodies):
        for prefix, values in (("", r), ("v", v), ("a", a)):
            for k, axis in enumerate("xyz"[:dimensions] if values is not None else ""):
                columns[f"{prefix}{axis}{body + 1}"] = values[:, body, k]
    if "angle" in more:
        columns["angle"] = more["angle"]
    write_csv(directory / "trajectory.csv", columns)
    zero = np.zeros(len(time))
    thermo = more.get("thermo", {"potential_energy": zero, "kinetic_energy": zero, "momentum_x": zero})
    energies = {**thermo, "total_energy": thermo["potential_energy"] + thermo["kinetic_energy"]}
    write_csv(directory / "thermo.csv", {"step": columns["step"], "time": time, **energies})
    system = {"kind": "few-body", "bodies": bodies, "dimensions": dimensions,
              "force": more.get("force", "newtonian-gravity")}
    stages = [{"name": "run", "integrator": "velocity-verlet", "time_step": 0.01, "steps": len(time) - 1}]
    (directory / "results.json").write_text(json.dumps({"system": system, "observables": {}, "stages": stages}))
    record = {"kind": "few-body", "title": "made-up bodies", "deck": more.get("deck", ""), "settings": []}
    (directory / "run.json").write_text(json.dumps(record))
    return directory


def write_h5md(path: Path, positions: np.ndarray, edges: Any, unit: str) -> None:
    """The groups of the H5MD file of ljmd that are read, every tenth step of 0.05; v = 2 r."""
    import h5py

    frames = len(positions)
    with h5py.File(path, "w") as file:
        group = file.create_group("particles/trajectory")
        group["position/step"] = 10 * np.arange(frames)
        group["position/time"] = 0.5 * np.arange(frames)
        group["position/value"] = positions
        group["velocity/value"] = 2.0 * positions
        group.create_group("box")
        if edges is not None:
            group["box/edges/value"] = np.array([np.diag(edges)] * frames, dtype=float)
        file.create_group("parameters/units").attrs["length"] = unit


def write_fluid(directory: Path, positions: np.ndarray, edge: float, unit: str = "sigma") -> Path:
    """What the film of a fluid needs: the trajectory in a cubic box, and the title."""
    directory.mkdir(parents=True)
    write_h5md(directory / "trajectory.h5md", positions, [edge] * 3, unit)
    (directory / "run.json").write_text(json.dumps({"title": "made-up fluid", "argon": None}))
    return directory


def write_csv(path: Path, columns: dict[str, np.ndarray]) -> None:
    lines = [",".join(columns)]
    lines += [",".join(repr(value) for value in row) for row in zip(*(column.tolist() for column in columns.values()))]
    path.write_text("\n".join(lines) + "\n")


def run_tests(tests: dict[str, Any]) -> int:
    """Run what is named test_*, each with a folder of its own. Returns the exit code."""
    passed = failed = 0
    for name, test in sorted(tests.items()):
        if name.startswith("test_"):
            outcome = run_test(name, test)
            passed += outcome == "passed"
            failed += outcome == "failed"
    print(f"{passed} passed, {failed} failed")
    return 1 if failed else 0


def run_test(name: str, test: Callable[[Path], None]) -> str:
    with tempfile.TemporaryDirectory() as folder:
        try:
            test(Path(folder))
            return "passed"
        except Skipped as reason:
            print(f"skipped {name}: {reason}")
            return "skipped"
        except Exception:  # a test that breaks down has failed; the others still count
            print(f"FAILED {name}")
            traceback.print_exc()
            return "failed"
