"""Texts and JSON of ljmd, checked as they are read: a damaged file is one error, which names it."""

from __future__ import annotations

import json
from pathlib import Path
from typing import Any

from ..errors import DataError


def damaged(path: Path, what: str) -> DataError:
    """The error for a file whose content cannot be used."""
    return DataError(f"{path}: {what}")


def read_text(path: Path) -> str:
    """The text of a file; a byte-order mark is dropped."""
    try:
        return path.read_text(encoding="utf-8-sig")
    except FileNotFoundError:
        raise damaged(path, "no such file") from None
    except UnicodeDecodeError:
        raise damaged(path, "not a text file") from None
    except OSError as error:
        raise damaged(path, f"cannot be read: {error.strerror}") from None


def read_json(path: Path) -> dict[str, Any]:
    """A JSON file that holds one object."""
    try:
        content = json.loads(read_text(path))
    except json.JSONDecodeError as error:
        raise damaged(path, f"line {error.lineno}: {error.msg}") from None
    except RecursionError:
        raise damaged(path, "nested too deeply") from None
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
    return value
