"""Checks of arguments that several functions share."""

from __future__ import annotations

import math
import numbers
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
        found = operator.index(value)
    except TypeError:
        found = None
    if found is None or isinstance(value, bool):
        raise InputError(f"{name}: {value!r} is no whole number")
    if found < least:
        raise InputError(f"{name}: {found} is not allowed: {least} or more")
    return found


def number(value, name: str, least: float = -math.inf, above: float = -math.inf) -> float:
    """A finite real number, of Python or NumPy; neither a truth value nor text."""
    if not isinstance(value, numbers.Real) or isinstance(value, bool):
        raise InputError(f"{name}: {value!r} is no number")
    found = float(value)
    if not (math.isfinite(found) and found >= least and found > above):
        wanted = f" above {above:g}" if above > -math.inf else f", {least:g} or more" if least > -math.inf else ""
        raise InputError(f"{name}: {value!r} is not allowed: a finite number{wanted}")
    return found


def positive(value, name: str) -> float:
    return number(value, name, above=0.0)


def truth(value, name: str) -> bool:
    """True or False, also NumPy's: no text, of which any but the empty one counts as true."""
    if isinstance(value, bool) or (str(getattr(value, "dtype", "")) == "bool" and getattr(value, "shape", None) == ()):
        return bool(value)
    raise InputError(f"{name}: {value!r} is neither True nor False")


def text(value, name: str) -> str:
    if not isinstance(value, str):
        raise InputError(f"{name}: {value!r} is no text")
    return value


def simd_of(simd) -> str:
    """An instruction set for the engine; empty for None: its default."""
    return "" if simd is None else text(simd, "simd")


def real_array(array, name: str):
    """An array of real numbers as doubles, none of them masked. Text is none, whatever it spells."""
    import numpy as np

    not_masked(array, name)
    try:
        found = np.asarray(array)
    except ValueError:  # rows of several lengths
        found = np.array(None)
    if found.dtype.kind in "fiu" or (found.dtype.kind == "O" and all(isinstance(each, numbers.Real) for each in found.flat)):
        return found.astype(float, copy=False)
    raise InputError(f"{name}: an array of real numbers is needed")


def not_masked(array, name: str) -> None:
    import numpy as np

    if np.ma.is_masked(array):
        raise InputError(f"{name}: some of its numbers are masked, which stands for none: leave them out, or fill them")


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
    if not (isinstance(walltime, numbers.Real) and not isinstance(walltime, bool) and 0 < walltime < 1e9):
        raise InputError(f"walltime: {walltime!r} is not allowed: seconds above 0, or a text as \"90s\" or \"2h\"")
    return float(walltime)


def warn(text: str) -> None:
    warnings.warn(text.removeprefix("warning: ").rstrip(), RunWarning, stacklevel=3)
