"""Decks of ljmd as tables, with every `--set` applied. Needs Python 3.11, or the package tomli, for TOML."""

from __future__ import annotations

import re
from pathlib import Path
from typing import Any, Sequence

from ..errors import DataError, InputError
from .files import damaged, field, read_text
from .records import Record

try:
    import tomllib
except ModuleNotFoundError:
    try:
        import tomli as tomllib  # type: ignore
    except ModuleNotFoundError:
        tomllib = None  # type: ignore[assignment]

KEY_PART = re.compile(r'"([^"]*)"|([^."]+)')


def parse(where: Path, text: str, settings: Sequence[str] = ()) -> dict[str, Any]:
    """The tables of a deck; `settings` are applied in their order. Raises DataError, which names `where`."""
    if tomllib is None:
        raise damaged(where, "its deck cannot be read without Python 3.11 or the package tomli")
    try:
        deck = tomllib.loads(text)
    except (ValueError, RecursionError) as error:  # an integer of thousands of digits, tables nested too deeply
        raise damaged(where, f"the deck is not valid TOML: {error}") from None
    for setting in settings:
        if not isinstance(setting, str):
            raise damaged(where, "a setting is no text of the form KEY=VALUE")
        apply(where, deck, setting)
    return deck


def read(path: Path, settings: Sequence[str] = ()) -> dict[str, Any]:
    """The tables of a deck file. Raises InputError for a deck that is missing or is no TOML."""
    try:
        return parse(path, read_text(path), settings)
    except DataError as error:
        raise InputError(str(error)) from None


def of_run(record: Record) -> dict[str, Any]:
    """The deck of a run, as it was used."""
    return parse(record.file, field(record.file, record.data, "deck", str), field(record.file, record.data, "settings", list, default=[]))


def apply(where: Path, deck: dict[str, Any], setting: str) -> None:
    """One `--set KEY=VALUE`: an element of an array of tables goes by its name or number; what is no TOML is text."""
    key, equals, text = setting.partition("=")
    parts = [quoted or bare for quoted, bare in KEY_PART.findall(key)]
    if not equals or not parts:
        raise damaged(where, f"'{setting}' is no setting of the form KEY=VALUE")
    try:
        value = tomllib.loads(f"value = {text}")["value"]
    except (ValueError, RecursionError):
        value = text
    holder: Any = deck
    for part in parts[:-1]:
        if isinstance(holder, list):
            names = [entry.get("name", str(number)) for number, entry in enumerate(holder, 1)]
            holder = holder[names.index(part)] if part in names else None
        elif isinstance(holder, dict):
            holder = holder.setdefault(part, {})
    if not isinstance(holder, dict):
        raise damaged(where, f"the setting '{setting}' does not fit the deck")
    holder[parts[-1]] = value
