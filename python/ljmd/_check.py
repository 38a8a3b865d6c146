"""Checks of arguments that several functions share."""

from __future__ import annotations

import io
import itertools
import math
import numbers
import operator
import os
import pathlib
import sys
import warnings
from collections.abc import Iterable, Mapping

from .errors import InputError, RunWarning

_SHOWN = 80  # characters of a value in a message
_LISTED = 10**6  # members of a list; one of range(10**12) would fill the memory
_THREADS = 4096  # as of the program


def shown(value) -> str:
    """A value in a message: as Python shows it, but short, and whatever it is."""
    try:
        text = repr(value)
    except Exception:  # lists within lists without end, integers of thousands of digits, classes of the user's
        text = f"<{type(value).__name__}>"
    text = text.encode(errors="backslashreplace").decode()
    return text if len(text) <= _SHOWN else f"{text[:_SHOWN - 3]}..."


class Loadable:
    """What a run is made of: a Deck. Who takes one need not know how it is made."""

    __slots__ = ()

    def _loaded(self, force: bool = False):
        raise NotImplementedError


def deck(value, name: str):
    if not isinstance(value, Loadable):
        raise InputError(f"{name}: {shown(value)} is no ljmd.Deck")
    return value


def threads_of(threads) -> int:
    """A number of threads for the engine; 0 for None: OMP_NUM_THREADS, or 1."""
    if threads is None:
        return 0
    return whole(threads, "threads", 1, _THREADS)


def whole(value, name: str, least: int, most: int = 2**63 - 1) -> int:
    try:
        found = operator.index(value)
    except TypeError:
        found = None
    if found is None or isinstance(value, bool):
        raise InputError(f"{name}: {shown(value)} is no whole number")
    if not least <= found <= most:
        raise InputError(f"{name}: {shown(found)} is not allowed: {least} or more" + ("" if found < least else f", at most {most}"))
    return found


def number(value, name: str, least: float = -math.inf, above: float = -math.inf) -> float:
    """A finite real number, of Python or NumPy; neither a truth value nor text."""
    if not isinstance(value, numbers.Real) or isinstance(value, bool):
        raise InputError(f"{name}: {shown(value)} is no number")
    try:
        found = float(value)
    except OverflowError:
        found = math.inf
    except TypeError:  # NumPy takes a span of time for an integer
        found = math.nan
    if not (math.isfinite(found) and found >= least and found > above):
        wanted = f" above {above:g}" if above > -math.inf else f", {least:g} or more" if least > -math.inf else ""
        raise InputError(f"{name}: {shown(value)} is not allowed: a finite number{wanted}")
    return found


def positive(value, name: str) -> float:
    return number(value, name, above=0.0)


def truth(value, name: str) -> bool:
    """True or False, also NumPy's: no text, of which any but the empty one counts as true."""
    if isinstance(value, bool) or (str(getattr(value, "dtype", "")) == "bool" and getattr(value, "shape", None) == ()):
        return bool(value)
    raise InputError(f"{name}: {shown(value)} is neither True nor False")


def text(value, name: str) -> str:
    if not isinstance(value, str):
        raise InputError(f"{name}: {shown(value)} is no text")
    try:
        value.encode()
    except UnicodeEncodeError:
        raise InputError(f"{name}: {shown(value)} is no text: half of a surrogate pair is no character") from None
    return value


def table(value, name: str) -> dict:
    """A mapping with names; None: an empty one."""
    if value is None:
        return {}
    if not isinstance(value, Mapping) or not all(isinstance(key, str) for key in value):
        raise InputError(f"{name}: {shown(value)}: a table is needed, with texts as keys")
    return dict(value)


def listed(value, name: str) -> list:
    """The members of a list or of anything else that has some, but for texts, tables and files."""
    if not isinstance(value, (str, bytes, Mapping, io.IOBase)) and isinstance(value, Iterable):
        try:
            found = list(itertools.islice(value, _LISTED + 1))
        except (TypeError, NotImplementedError):  # an array of NumPy without dimensions, a view of memory with several
            found = None
        if found is not None and len(found) <= _LISTED:
            return found
        if found is not None:
            raise InputError(f"{name}: {shown(value)}: more than {_LISTED} members")
    raise InputError(f"{name}: {shown(value)}: a list is needed")


def path(value, name: str) -> str:
    """Of a file or directory, as text."""
    try:
        found = os.fspath(value)
    except TypeError:
        found = None
    if isinstance(found, bytes):
        found = os.fsdecode(found)
    if not isinstance(found, str) or "\0" in found:
        raise InputError(f"{name}: {shown(value)} is no path")
    try:
        os.fsencode(found)
    except UnicodeEncodeError:
        raise InputError(f"{name}: {shown(value)} is no path that this system can write") from None
    if found == "":  # pathlib would take it for the working directory
        raise InputError(f"{name}: the name is empty")
    return found


def progress_of(value):
    """True, False or a function."""
    return value if callable(value) else value is not None and truth(value, "progress")


def simd_of(simd) -> str:
    """An instruction set for the engine; empty for None: its default."""
    return "" if simd is None else text(simd, "simd")


def real_array(array, name: str):
    """An array of real numbers as doubles, none of them masked. Text is none, whatever it spells."""
    found = array_of(array, name)
    if found.dtype.kind in "fiu" or (found.dtype.kind == "O" and all(isinstance(each, numbers.Real) for each in found.flat)):
        try:
            return found.astype(float, copy=False)
        except OverflowError:
            raise InputError(f"{name}: a number is too large for double precision") from None
        except TypeError:  # spans of time
            pass
    raise InputError(f"{name}: an array of real numbers is needed")


def array_of(value, name: str, kind=None):
    """An array of NumPy, none of it masked, with members of that kind."""
    import numpy as np

    not_masked(value, name)
    try:
        return np.asarray(value, dtype=kind)
    except (ValueError, MemoryError):  # rows of several lengths; range(10**15)
        raise InputError(f"{name}: an array of real numbers is needed, not {shown(value)}") from None


def not_masked(array, name: str) -> None:
    import numpy as np

    if isinstance(array, np.ma.MaskedArray) and array.dtype.names is None and np.ma.is_masked(array):
        raise InputError(f"{name}: some of its numbers are masked, which stands for none: leave them out, or fill them")


def directory_of(value, name: str = "directory") -> pathlib.Path:
    """Absolute from here on: a function of the user's may go to another working directory."""
    return pathlib.Path(path(value, name)).absolute()


def seconds_of(walltime):
    """Seconds, or a text like "2h"; None: no limit."""
    if walltime is None:
        return None
    if isinstance(walltime, str):
        from . import _core
        return _core.seconds_of(text(walltime, "walltime"))
    try:
        seconds = positive(walltime, "walltime")
    except InputError:
        seconds = math.inf
    if not seconds < 1e9:
        raise InputError(f"walltime: {shown(walltime)} is not allowed: seconds above 0, or a text as \"90s\" or \"2h\"")
    return seconds


def warn(text: str) -> None:
    """A warning at the line of the user's that has called the package, itself or by ASE."""
    frame, level = sys._getframe(), 1
    while frame.f_back is not None and frame.f_globals.get("__name__", "").partition(".")[0] in (__package__, "ase"):
        frame, level = frame.f_back, level + 1
    warnings.warn(text.removeprefix("warning: ").rstrip(), RunWarning, stacklevel=level)
