"""Runs: results, samples and frames, in memory or of the directory that holds them."""

from __future__ import annotations

import pathlib
from collections.abc import Mapping
from typing import TYPE_CHECKING, Any

from . import _check, _functions as functions, _progress
from ._text import as_table, with_error
from .errors import DataError
from .external import described_force
from .frames import Frames
from .observables import described
from .reading import observables as entries
from .reading import records
from .reading.files import field, is_there, read_json
from .reading.observables import Observable
from .reading.tables import read_numbers
from .results import Results

if TYPE_CHECKING:
    from ._types import Path
    from .potentials import Pair


class Files(Mapping):
    """The tables in a directory, each read when it is asked for."""

    def __init__(self, directory: pathlib.Path, names):
        self.directory, self.names = directory, names

    def __getitem__(self, name):
        if name not in self.names:
            raise KeyError(name)
        return read_numbers(self.directory / f"{name}.csv", growing=True)

    def __iter__(self):
        return iter(self.names)

    def __len__(self) -> int:
        return len(self.names)


class Run(Results):
    """A run: its results, and the samples of its energies.

    directory: where its files are; None: it was run in memory
    """

    def __init__(self, data: dict, tables: Mapping, thermo=None, directory=None, finished: bool = True, frames=None, last=None):
        super().__init__(data, tables)
        self._frames = frames
        self._last = last  # of a fluid in memory: its last configuration, one frame
        self._thermo, self.directory, self.finished = thermo, directory, finished
        self._given: dict = {}  # as in run.json

    @property
    def _file(self) -> pathlib.Path:
        return super()._file if self.directory is None else self.directory / "results.json"

    @property
    def thermo(self) -> Any:
        """Energies, temperature and pressure of all samples: a row each, with the columns of thermo.csv (docs/files.md)."""
        return as_table(*(self._thermo if self._thermo is not None else read_numbers(self.directory / "thermo.csv", growing=True)))

    @property
    def potential(self) -> Pair | None:
        """The pair potential of your own that a run in a directory was made with, from the table there; None: that of its
        deck.

        Raises DataError when the table cannot be read.
        """
        from .potentials import Pair
        return None if self.directory is None else Pair.of_run(self.directory)

    @property
    def stages(self) -> list[dict[str, Any]]:
        """The stages with their steps, energy drift and checksums."""
        return field(self._file, self.data, "stages", list, default=[])

    @property
    def findings(self) -> dict[str, dict[str, Observable]]:
        """Of few bodies: what each analysis found, by its name."""
        return entries.findings(self._file, self.data)

    def all_observables(self) -> dict[str, Observable]:
        """Observables and findings by the names of the columns of sweep.csv: those of analyses of few bodies as "orbit_period"."""
        return entries.all_of(self._file, self.data)

    def trajectory(self, *, start: float | None = None, positions: str | None = None) -> Any:
        """Of a fluid with a directory: its trajectory, for `ljmd.Trajectory`'s analyses. Of few bodies: the table of it."""
        if "trajectory" in self._tables:
            return self.table("trajectory")
        if self.directory is None:
            raise DataError("a run in memory writes no file to analyse: give it a directory; frames() are there where the deck "
                            "has output.trajectory")
        from .trajectories import trajectory_of_run
        return trajectory_of_run(self.directory, start, positions)

    def frames(self) -> Frames:
        """The frames that the deck's `output.trajectory` asks for, as arrays. Raises DataError if there are none."""
        if "trajectory" in self._tables:
            raise DataError("few bodies have no box: their trajectory is a table, trajectory()")
        if self.directory is not None:
            return self.trajectory().arrays()
        if self._frames is None:
            raise DataError("this run has kept no frames: the deck of a fluid asks for them, "
                            'deck.output.trajectory = {"every": 100, "velocities": True}')
        return self._frames

    def universe(self) -> Any:
        """An MDAnalysis Universe of its frames, see `Frames.universe`; of its last configuration alone where the deck asks for no
        trajectory.

        Raises DataError for few bodies, and for a run in a directory that has not come to its end and has no trajectory.
        """
        if "trajectory" in self._tables or self._has_frames():
            return self.frames().universe()
        last = self._last if self.directory is None else self._last_in_directory()
        if last is None:
            raise DataError("few bodies have no box: they are no atoms of a fluid")
        return last.universe()

    def _has_frames(self) -> bool:
        if self.directory is None:
            return self._frames is not None
        return any(is_there(self.directory / f"trajectory.{format}") for format in ("h5md", "xyz"))

    def _last_in_directory(self) -> Frames:
        from . import _core
        positions, velocities, edges, time = _core.last_configuration(self.directory)
        about, _ = _core.describe(self.directory)
        return Frames.of_one(positions, velocities, edges, time, about["total_steps"])

    def report(self, page: Path | None = None, *, force: bool = False) -> pathlib.Path:
        """Write one HTML page about the run, finished or not, and return its path: verdicts, charts, the atoms in motion.

        page: file to write; report.html in the directory of the run by default. An earlier page is replaced
        force: replace any other file, too; a link is replaced itself, never what it leads to

        It needs no network. Raises DataError for a run in memory, InputError for a name that is taken, FileError.
        """
        if self.directory is None:
            raise DataError("a page is made from the files of a run: give it a directory")
        from . import _core
        page = self.directory / "report.html" if page is None else pathlib.Path(_check.path(page, "page"))
        for text in _core.write_report([self.directory], page, _check.truth(force, "force")):
            _check.warn(text)
        return page

    def _heading(self) -> str:
        what = [self._title, self._system_in_words(), self._potential_in_words(),
                str(self.directory) if self.directory else "in memory", "" if self.finished else "not finished"]
        return "ljmd run: " + "; ".join(filter(None, what))

    def _system_in_words(self) -> str:
        system = field(self._file, self.data, "system", dict, default={})
        if "atoms" in system:
            return f"{system['atoms']} atoms, density {field(self._file, system, 'density', float):.6g}"
        return f"{system.get('bodies', '')} bodies"

    def _potential_in_words(self) -> str:
        file = self._file.with_name("run.json")
        potential = field(file, self._given, "potential", dict, default={})
        return f"pair potential {field(file, potential, 'name', str)!r}" if potential else ""

    def _rows(self) -> list:
        rows = super()._rows()
        return rows + [(f"{analysis}: {name}", with_error(each.mean, each.error), each.unit, "")
                       for analysis, found in self.findings.items() for name, each in found.items()]

    @classmethod
    def open(cls, directory: Path) -> "Run":
        """See `ljmd.open`."""
        directory = _check.directory_of(directory)
        if not is_there(directory / "run.json"):
            raise DataError(f"{directory} is not the directory of a run: it has no run.json")
        record = records.read(directory)
        results = directory / "results.json"
        data = {"title": record.title}
        if record.finished and is_there(results):
            data = read_json(results)
            field(results, data, "observables", dict)
        tables = [path.stem for path in sorted(directory.glob("*.csv")) if path.stem != "thermo" and path.is_file()]
        run = cls(data, Files(directory, tables), None, directory, record.finished)
        run._given = record.given
        return run

    @classmethod
    def in_directory(cls, deck, directory, *, observables, external, threads, simd, progress, replace, walltime) -> "Run":
        """See `Deck.run`."""
        from . import _core
        directory = _check.directory_of(directory)
        options = (_check.threads_of(threads), _check.simd_of(simd), _check.truth(replace, "replace"), _check.seconds_of(walltime), described(observables),
                   described_force(external))
        with _progress.shown(progress, deck.total_steps) as tell, functions.remembered(directory, observables, external):
            _core.run(deck, directory, *options, tell, _check.warn)
        return cls.open(directory)
