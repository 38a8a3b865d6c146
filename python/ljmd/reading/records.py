"""run.json: what the directory of a run holds, written when the run begins and again when it ends."""

from __future__ import annotations

from dataclasses import dataclass, field as member
from pathlib import Path
from typing import Any

from ..errors import InputError
from .files import damaged, field, is_there, read_json

KINDS = ("fluid", "few-body")


@dataclass(frozen=True)
class Record:
    """What run.json says of a run."""

    path: Path  # the directory
    title: str
    kind: str  # of KINDS
    finished: bool  # else the run goes on, was stopped or has failed
    data: dict[str, Any] = member(repr=False, default_factory=dict)  # all of it

    @property
    def file(self) -> Path:
        return self.path / "run.json"

    @property
    def given(self) -> dict[str, Any]:
        """The parts of a program that the run was made with; empty for one of a deck alone."""
        return field(self.file, self.data, "given", dict, default={})


def read(path: Path) -> Record:
    """The record of the run in a directory.

    Raises InputError when `path` is no directory, DataError when run.json is missing or damaged.
    """
    if not (is_there(path) and path.is_dir()):
        raise InputError(f"{path}: {'not a directory' if is_there(path) else 'no such directory'}")
    file = path / "run.json"
    data = read_json(file)
    if field(file, data, "program", str, default="ljmd") != "ljmd":
        raise damaged(file, "it is that of another program")
    kind = field(file, data, "kind", str, default="fluid")
    if kind not in KINDS:
        raise damaged(file, f"'kind' is '{kind}', must be one of {', '.join(KINDS)}")
    return Record(path, field(file, data, "title", str, default=""), kind, field(file, data, "finished", bool, default=True), data)


def read_results(record: Record) -> dict[str, Any]:
    """results.json of a run that has come to its end."""
    return read_json(record.path / "results.json")


def status_of(record: Record, last_step: float, total_steps: int | None) -> str:
    """How far a run has come that has not ended, in words."""
    what = "blew up" if is_there(record.path / "failed.xyz") else "has not come to its end"
    steps = "" if total_steps is None else f" of {total_steps}"
    return f"the run {what}: drawn up to step {last_step:.0f}{steps}"
