"""Writing decks: tables of plain values as TOML."""

from __future__ import annotations

import os

from . import _check
from .errors import InputError


_DEEPEST = 32  # tables and lists within one another, as the reader allows; one that holds itself has no end
_LARGEST = 2**20  # members of an array: the reader allows as many bytes


def literal(value, name: str, depth: int = 0) -> str:
    """The value of a key as TOML. NumPy's numbers and arrays, paths and tuples count as what they hold."""
    if depth > _DEEPEST:
        raise InputError(f"{name}: a deck cannot hold lists and tables more than {_DEEPEST} within one another")
    if callable(getattr(value, "tolist", None)):
        _check.not_masked(value, name)
        if getattr(value, "size", 0) > _LARGEST:
            raise InputError(f"{name}: a deck cannot hold an array of {value.size} members")
        try:
            value = value.tolist()
        except NotImplementedError:  # a view of memory whose members Python does not know
            pass
    if isinstance(value, os.PathLike):
        value = os.fspath(value)
    if isinstance(value, bool):
        return "true" if value else "false"
    if isinstance(value, (int, float)):
        return _number(value, name)
    if isinstance(value, str):
        return _string(value, name)
    if isinstance(value, (list, tuple)):
        return "[" + ", ".join(literal(item, name, depth + 1) for item in value) + "]"
    if isinstance(value, dict):
        return "{ " + ", ".join(f"{key(k, name)} = {literal(v, f'{name}.{k}', depth + 1)}" for k, v in value.items()) + " }" if value else "{}"
    raise InputError(f"{name}: a deck cannot hold {_check.shown(value)} of type {type(value).__name__}: "
                     "allowed are numbers, text, true or false, lists and tables")


def _number(value, name: str) -> str:
    """Digits, also of a type of the user's that shows itself in another way: members of an IntEnum."""
    try:
        return int.__repr__(value) if isinstance(value, int) else float.__repr__(value)
    except ValueError:
        raise InputError(f"{name}: a deck cannot hold an integer of thousands of digits") from None


def _string(text: str, name: str) -> str:
    text = _check.text(text, name)
    escapes = {"\\": "\\\\", '"': '\\"', "\n": "\\n", "\t": "\\t"}
    return '"' + "".join(escapes.get(c) or (c if c >= " " and c != "\x7f" else f"\\u{ord(c):04x}") for c in text) + '"'


def key(name, where: str = "a deck") -> str:
    """A key of the table `where`."""
    if not isinstance(name, str):
        raise InputError(f"{where}: keys of a deck are text, found {_check.shown(name)}")
    plain = name and all(c.isascii() and (c.isalnum() or c in "-_") for c in name)
    return name if plain else _string(name, f"a key of {where}")


def _is_array_of_tables(value) -> bool:
    return isinstance(value, (list, tuple)) and len(value) > 0 and all(isinstance(item, dict) for item in value)


def dumps(tables: dict) -> str:
    """A deck: plain values first, then tables and arrays of tables, each in the order of the dict. Empty tables are left out."""
    lines, rest = [], []
    for name, value in tables.items():
        if value is None or (isinstance(value, dict) and not value):
            continue
        if isinstance(value, dict):
            rest += ["", f"[{key(name)}]", *_lines(value, name)]
        elif _is_array_of_tables(value):
            for item in value:
                rest += ["", f"[[{key(name)}]]", *_lines(item, name)]
        else:
            lines.append(f"{key(name)} = {literal(value, name)}")
    text = "\n".join(lines + rest).lstrip("\n")
    return text + "\n" if text else ""


def _lines(table: dict, where: str) -> list:
    return [f"{key(name, where)} = {literal(value, f'{where}.{name}')}" for name, value in table.items() if value is not None]
