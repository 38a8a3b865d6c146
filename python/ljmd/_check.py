"""Checks of arguments that several functions share."""

from __future__ import annotations

import operator
import os
import pathlib
import warnings

from .errors import InputError, RunWarning


def threads_of(threads) -> int:
    """A number of threads for the engine; 0 for None: OMP_NUM_THREADS, or 1."""
    if threads is None:
        return 0
    return whole(threads, "threads", 1)


def whole(value, name: str, least: int) -> int:
    try:
        number = operator.index(value)
    except TypeError:
        raise InputError(f"{name}: {value!r} is no whole number") from None
    if number < least:
        raise InputError(f"{name}: {number} is not allowed: {least} or more")
    return number


def directory_of(path) -> pathlib.Path:
    if os.fspath(path) == "":  # pathlib would take it for the working directory
        raise InputError("the name of the directory is empty")
    return pathlib.Path(path)


def seconds_of(walltime):
    """Seconds, or a text like "2h"; None: no limit."""
    if walltime is None:
        return None
    if isinstance(walltime, str):
        from . import _core
        return _core.seconds_of(walltime)
    if not (isinstance(walltime, (int, float)) and 0 < walltime < 1e9):
        raise InputError(f"walltime: {walltime!r} is not allowed: seconds above 0, or a text as \"90s\" or \"2h\"")
    return float(walltime)


def warn(text: str) -> None:
    warnings.warn(text.removeprefix("warning: ").rstrip(), RunWarning, stacklevel=3)
