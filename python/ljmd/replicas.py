"""Replicas: independent runs of one deck, and their merged results."""

from __future__ import annotations

import pathlib
import re
import tempfile
from typing import TYPE_CHECKING

from . import _check, _program, _progress
from .errors import DataError, Error, InputError
from .reading.files import field, is_there, read_json
from .reading.sweeps import Request, read_request
from .results import Results
from .runs import Files, Run

if TYPE_CHECKING:
    from ._types import Path


class Replicas(Results):
    """The merged results of independent runs of one deck, as those of one run: `replicas["pressure"].mean`, `.error`, `.table("rdf")`.

    directory: where they are
    """

    def __init__(self, data: dict, tables, request: Request):
        super().__init__(data, tables)
        self.directory, self._folders = request.directory, [request.folder(name) for name in request.names]

    @classmethod
    def open(cls, directory: Path) -> "Replicas":
        """The replicas in a directory, of Python or of `ljmd run --replicas`; without observables until all have ended.

        Raises DataError if there are none.
        """
        directory = _check.directory_of(directory)
        request = read_request(directory)
        if not request.replicas:
            raise DataError(f"{directory} holds no replicas: it is that of a sweep")
        path = directory / "results.json"
        data = {}
        if is_there(path):
            data = read_json(path)
            field(path, data, "observables", dict)
        return cls(data, Files(directory, [each for each in ("rdf", "sk") if is_there(directory / f"{each}.csv")]), request)

    @property
    def _file(self) -> pathlib.Path:
        return self.directory / "results.json"

    @property
    def runs(self) -> list[Run]:
        """Each replica that has begun, as a Run."""
        return [Run.open(folder) for folder in self._folders if is_there(folder / "run.json")]

    def _heading(self) -> str:
        return f"{super()._heading()}: {len(self._folders)} replicas in {self.directory}"


def run_replicas(deck, directory, replicas: int, *, jobs=None, progress=True, replace: bool = False, force: bool = False) -> Replicas:
    """See `Deck.run`."""
    if directory is None:
        raise InputError("replicas have files: give a directory")
    directory = _check.directory_of(directory)
    replicas = _check.whole(replicas, "replicas", 1)
    options = ["--jobs", _check.whole(jobs, "jobs", 1)] if jobs is not None else []
    options += ["--force"] if any([_check.truth(force, "force"), _check.truth(replace, "replace")]) else []
    with tempfile.TemporaryDirectory(prefix="ljmd-") as folder:
        deck_file, settings = deck._in_file(pathlib.Path(folder))
        with _progress.shown(progress, replicas, unit="replica") as tell:
            done = re.compile(r"\[(\d+)/\d+\] ")

            def told(line):
                found = done.match(line)
                if tell is not None and found:
                    tell(int(found[1]))

            try:
                _, _, said = _program.call(["run", deck_file, "--replicas", replicas, "--out", directory, "--json", *options, *settings],
                                           told=told, note="replicas that had begun have checkpoints: the same call resumes them")
            except Error as error:
                raise type(error)(str(error).replace(str(deck_file), "Deck").replace("--force", "force=True")) from None
    _program.warned(line.replace(str(deck_file), "Deck") for line in said if not line.startswith("["))
    return Replicas.open(directory)
