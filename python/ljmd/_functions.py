"""The functions of the user's that this process has run in directories, for `ljmd.resume`."""

from __future__ import annotations

import contextlib
import pathlib

_known: dict[pathlib.Path, tuple] = {}  # of a directory: its _record() after the run, observables, external force


def _record(directory: pathlib.Path):
    """Changes whenever run.json is written, by any process; None without one."""
    try:
        found = (directory / "run.json").stat()
    except OSError:
        return None
    return found.st_ino, found.st_mtime_ns


@contextlib.contextmanager
def remembered(directory: pathlib.Path, observables, external):
    """Keep the functions of the run that is made inside, also if it ends with an exception; not if it was refused."""
    before = _record(directory)
    try:
        yield
    finally:
        after = _record(directory)
        if after != before:
            _known.pop(directory.resolve(), None)
            if observables or external is not None:
                _known[directory.resolve()] = after, observables, external


def of_run(directory: pathlib.Path, observables, external) -> tuple:
    """The observables and the external force to resume a run with: those given, else those that this process knows to be
    the run's own. What is still missing is told by the engine."""
    record, own, force = _known.get(directory.resolve(), (None, (), None))
    if record is None or _record(directory) != record:
        own, force = (), None  # another process has begun or resumed a run there
    return own if observables is None else observables, force if external is None else external
