"""What every script here begins with: the package `ljmd`, which reads the files, is found, and errors end as one line.

The package that belongs to these scripts lies beside them, in ../python: in the source tree its sources, in an installation
a link to where Python has it, or its own place where it was built for no Python. Only what needs no compiled part is used.
"""

from __future__ import annotations

import functools
import sys
from pathlib import Path
from typing import Callable, Optional, Sequence

BESIDE = Path(__file__).resolve().parents[1] / "python"
if (BESIDE / "ljmd").is_dir():  # not another version that this Python has
    sys.path.insert(0, str(BESIDE))
try:
    import ljmd.reading  # noqa: F401  (one of an earlier version has none)
    from ljmd.errors import DataError, Error, FileError, InputError
except ImportError as missing:
    print(f"error: files are read by the Python package ljmd, which is not in {BESIDE} ({missing}): `cmake --install` puts it there",
          file=sys.stderr)
    sys.exit(2)

EXIT_CODES = {InputError: 2, DataError: 3, FileError: 4}  # as of ljmd


def reports_errors(main: Callable[[Optional[Sequence[str]]], int]) -> Callable[..., int]:
    """The main() of a script, which ends an error of ljmd as one line on stderr and its exit code."""

    @functools.wraps(main)
    def guarded(arguments: Optional[Sequence[str]] = None) -> int:
        try:
            return main(arguments)
        except Error as error:
            # Names of files reach a terminal without what commands it.
            text = "".join(one if one.isprintable() or "\udc80" <= one <= "\udcff" else "?" for one in str(error))
            print(f"error: {text}", file=sys.stderr)
            return EXIT_CODES.get(type(error), 1)

    return guarded
