"""The functions of the user's that this process has run in directories, for `ljmd.resume`."""

from __future__ import annotations

import contextlib
import pathlib

from .errors import DataError
from .reading import records

_known: dict[pathlib.Path, tuple] = {}  # of a directory: when its run began, observables, external force


def _written(directory: pathlib.Path):
    """Changes whenever run.json is written; None before."""
    try:
        found = (directory / "run.json").stat()
    except OSError:
        return None
    return found.st_ino, found.st_mtime_ns


@contextlib.contextmanager
def remembered(directory: pathlib.Path, observables, external):
    """Keep the functions of the run that is made inside, also if it ends with an exception; not if it was refused."""
    before = _written(directory)
    try:
        yield
    finally:
        if _written(directory) != before:
            _known.pop(directory.resolve(), None)
            if observables or external is not None:
                with contextlib.suppress(DataError):
                    _known[directory.resolve()] = records.read(directory).data.get("began"), observables, external


def of_run(directory: pathlib.Path, observables, external) -> tuple:
    """The observables and the external force to resume a run with: those given, else those that this process knows to be
    the run's own. What is still missing is told by the engine."""
    began, own, force = _known.get(directory.resolve(), (None, (), None))
    if began is None or records.read(directory).data.get("began") != began:
        own, force = (), None  # another process has begun another run there
    return own if observables is None else observables, force if external is None else external
