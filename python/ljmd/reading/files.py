"""Texts and JSON of ljmd, checked as they are read: a damaged file is one error, which names it."""

from __future__ import annotations

import json
import stat
import sys
from pathlib import Path
from typing import Any

from ..errors import DataError


def damaged(path: Path, what: str) -> DataError:
    """The error for a file whose content cannot be used."""
    return DataError(f"{path}: {what}")


def is_there(path: Path) -> bool:
    """Whether a path leads to a file or directory. Raises DataError where that cannot be known: a folder that nobody may enter."""
    try:
        path.stat()
    except (FileNotFoundError, NotADirectoryError):
        return False
    except OSError as error:
        raise damaged(path, f"cannot be read: {error.strerror}") from None
    except ValueError:
        raise damaged(path, "is no name of a file") from None
    return True


def require_file(path: Path) -> None:
    """Refuse what is no regular file, in the words of the engine: whoever opens a pipe waits for one who fills it."""
    if not is_there(path):
        raise damaged(path, "no such file")
    mode = path.stat().st_mode
    if not stat.S_ISREG(mode):
        found = "directory" if stat.S_ISDIR(mode) else "pipe" if stat.S_ISFIFO(mode) else "device or a socket"
        raise damaged(path, f"is a {found}, not a regular file")


def read_text(path: Path) -> str:
    """The text of a file; a byte-order mark is dropped."""
    require_file(path)
    try:
        return path.read_text(encoding="utf-8-sig")
    except UnicodeDecodeError:
        raise damaged(path, "not a text file") from None
    except MemoryError:
        raise damaged(path, "too large for the memory of this computer") from None
    except OSError as error:
        raise damaged(path, f"cannot be read: {error.strerror}") from None


def read_json(path: Path) -> dict[str, Any]:
    """A JSON file that holds one object."""
    text = read_text(path)
    try:
        content = json.loads(text)
    except json.JSONDecodeError as error:
        raise damaged(path, f"line {error.lineno}: {error.msg}") from None
    except RecursionError:
        raise damaged(path, "nested too deeply") from None
    except ValueError:
        raise damaged(path, "an integer in it has too many digits") from None
    if not isinstance(content, dict):
        raise damaged(path, "must hold a JSON object")
    return content


def field(path: Path, record: Any, name: str, kind: Any, **fallback: Any) -> Any:
    """record[name], which must be of `kind`; `default=` makes it optional, and null counts as absent then."""
    if not isinstance(record, dict):
        raise damaged(path, f"an object with '{name}' was expected, found {json.dumps(record)[:40]}")
    value = record.get(name)
    if value is None and "default" in fallback:
        return fallback["default"]
    allowed = (int, float) if kind is float else kind
    if not isinstance(value, allowed) or (isinstance(value, bool) and kind is not bool):
        found = f"is {json.dumps(value)[:40]}" if name in record else "is missing"
        raise damaged(path, f"'{name}' {found}, must be of type {kind.__name__}")
    if kind is float and isinstance(value, int) and abs(value) > sys.float_info.max:
        raise damaged(path, f"'{name}' is too large a number")
    return value
