"""Types of arguments that several functions take, for type checkers alone."""

import os
from collections.abc import Callable, Iterable, Mapping
from typing import Any

import numpy as np

from .deck import Deck as Deck

Path = str | bytes | os.PathLike[str] | os.PathLike[bytes]
Progress = bool | Callable[[int], object] | None
Function = Callable[[Any], Any]  # of the user's, that the engine calls
Functions = Function | Iterable[Function]
Points = Mapping[str, Any] | Iterable[Mapping[str, Any]]
Walltime = float | str | None
Array = np.ndarray[Any, Any]
