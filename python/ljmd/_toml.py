"""Writing decks: tables of plain values as TOML."""

from __future__ import annotations

import os

from . import _check
from .errors import InputError


_DEEPEST = 32  # tables and lists within one another, as the reader allows; one that holds itself has no end


def literal(value, depth: int = 0) -> str:
    """A value as TOML. NumPy's numbers and arrays, paths and tuples count as what they hold."""
    if depth > _DEEPEST:
        raise InputError(f"a deck cannot hold lists and tables more than {_DEEPEST} within one another")
    if depth == 0:
        _check.not_masked(value, "a value of a deck")
    if hasattr(value, "tolist"):
        value = value.tolist()
    if isinstance(value, os.PathLike):
        value = os.fspath(value)
    if isinstance(value, bool):
        return "true" if value else "false"
    if isinstance(value, (int, float)):
        return repr(value)
    if isinstance(value, str):
        return _string(value)
    if isinstance(value, (list, tuple)):
        return "[" + ", ".join(literal(item, depth + 1) for item in value) + "]"
    if isinstance(value, dict):
        return "{ " + ", ".join(f"{key(k)} = {literal(v, depth + 1)}" for k, v in value.items()) + " }" if value else "{}"
    raise InputError(f"a deck cannot hold {value!r} of type {type(value).__name__}: "
                     "allowed are numbers, text, true or false, lists and tables")


def _string(text: str) -> str:
    _check.text(text, "a deck")
    escapes = {"\\": "\\\\", '"': '\\"', "\n": "\\n", "\t": "\\t"}
    return '"' + "".join(escapes.get(c) or (c if c >= " " and c != "\x7f" else f"\\u{ord(c):04x}") for c in text) + '"'


def key(name) -> str:
    if not isinstance(name, str):
        raise InputError(f"keys of a deck are text, found {name!r}")
    plain = name and all(c.isascii() and (c.isalnum() or c in "-_") for c in name)
    return name if plain else _string(name)


def _is_array_of_tables(value) -> bool:
    return isinstance(value, (list, tuple)) and len(value) > 0 and all(isinstance(item, dict) for item in value)


def dumps(tables: dict) -> str:
    """A deck: plain values first, then tables and arrays of tables, each in the order of the dict. Empty tables are left out."""
    lines, rest = [], []
    for name, value in tables.items():
        if value is None or (isinstance(value, dict) and not value):
            continue
        if isinstance(value, dict):
            rest += ["", f"[{key(name)}]", *_lines(value)]
        elif _is_array_of_tables(value):
            for item in value:
                rest += ["", f"[[{key(name)}]]", *_lines(item)]
        else:
            lines.append(f"{key(name)} = {literal(value)}")
    text = "\n".join(lines + rest).lstrip("\n")
    return text + "\n" if text else ""


def _lines(table: dict) -> list:
    return [f"{key(name)} = {literal(value)}" for name, value in table.items() if value is not None]
