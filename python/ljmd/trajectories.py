"""Analyses of trajectories, of ljmd and of other programs."""

from __future__ import annotations

from functools import partial
from typing import TYPE_CHECKING, Any

from . import _check, _core
from .errors import InputError
from .frames import Frames
from .results import Results


if TYPE_CHECKING:
    from ._keys import TrajectoryAnalyses as _Analyses
    from ._types import Deck, Path
else:
    _Analyses = object


class Trajectory(_Analyses):
    """The frames of a file, on which all analyses of ljmd work: `traj.rdf(bins=200).table()`.

    Each analysis is a method, whose keywords are its options in decks; `every` counts frames. `analyze` does several.
    """

    def __init__(self, open_again):
        self._open_again = open_again
        self._frames = open_again()
        self._about = self._frames.summary()

    path = property(lambda self: self._about["path"], doc="Of the file.")
    frames = property(lambda self: self._about["frames"], doc="Number of frames.")
    atoms = property(lambda self: self._about["atoms"], doc="Number of atoms, N.")
    edges = property(lambda self: self._about["edges"], doc="Of the box of the first frame [sigma].")
    has_velocities = property(lambda self: self._about["has_velocities"], doc="Whether all frames have velocities.")
    spacing = property(lambda self: self._about["spacing"], doc="Time between frames, if it is the same for all [tau].")
    times = property(lambda self: self._frames.times(), doc="Of the frames, shape (F,) [tau]; empty if the file has none.")

    def analyze(self, *names: str, **options: Any) -> Results:
        """Several analyses in one pass: traj.analyze("rdf", "msd", rdf=dict(bins=200)). Without names those that fit."""
        wanted = [_check.text(name, "names") for name in names] or self._frames.default_names()
        settings = [f"analysis.{name}.{key}={_core.value_text(value, key)}"
                    for name, each in options.items() for key, value in _check.table(each, name).items()]
        data, _, tables = self._frames.analyze(wanted, settings)
        return Results({"title": f"{self.path}: {', '.join(wanted)}", **data}, tables, wanted[0] if len(wanted) == 1 else "")

    def arrays(self) -> Frames:
        """All frames in memory, see `Frames`. Raises DataError if the file has changed."""
        return Frames(*self._frames.arrays())

    def universe(self) -> Any:
        """An MDAnalysis Universe of all frames, see `Frames.universe`."""
        return self.arrays().universe()

    def __reduce__(self):
        return Trajectory, (self._open_again,)  # reads the file once more

    def __copy__(self):
        return self  # nothing of it changes

    def __deepcopy__(self, memo):
        return self

    if not TYPE_CHECKING:
        def __getattr__(self, name):
            if name.startswith("__"):
                raise AttributeError(name)
            if name not in _core.build()["analyses"]:
                raise AttributeError(f"no analysis {name!r}; there are {', '.join(_core.build()['analyses'])}")
            return lambda **options: self.analyze(name, **{name: options})

    def __dir__(self):
        return [*super().__dir__(), *_core.build()["analyses"]]

    def __repr__(self) -> str:
        return f"<ljmd.Trajectory {self.path!r}: {self.frames} frames of {self.atoms} atoms>"


def trajectory(path: Path, *, deck: Deck | None = None, start: float | None = None, time_step: float | None = None, positions: str | None = None, group: str = "",
               xyz_comment: str = "", energies: bool = False) -> Trajectory:
    """The trajectory in a file: H5MD, extended XYZ or LAMMPS dump, known by its content.

    deck: for interaction and SI units
    start: frames before this time are left out [tau]
    time_step: between steps, for files that do not tell [tau]
    positions: "wrapped" or "unwrapped", where neither the file nor the motion of the atoms tells
    group: of an H5MD file with several groups of particles
    xyz_comment: what the comment lines of an XYZ file lack: 'Lattice="20 0 0 0 20 0 0 0 20"'
    energies: compute energies and pressures of the frames, too; takes a deck and velocities

    Raises DataError for a file that cannot be used.
    """
    deck = _check.deck(deck, "deck").copy() if deck is not None else None
    positions = None if positions is None else _check.text(positions, "positions")
    group, xyz_comment = _check.text(group, "group"), _check.text(xyz_comment, "xyz_comment")
    energies = _check.truth(energies, "energies")
    start, time_step = (None if value is None else _check.number(value, name) for value, name in ((start, "start"), (time_step, "time_step")))
    return Trajectory(partial(_frames_of_file, _check.path(path, "path"), deck, energies, start, time_step, group, positions, xyz_comment))


def trajectory_of_run(directory, start, positions) -> Trajectory:
    """See `Run.trajectory`."""
    start = None if start is None else _check.number(start, "start")
    positions = None if positions is None else _check.text(positions, "positions")
    return Trajectory(partial(_frames_of_run, directory, start, positions))


def _frames_of_run(*options):
    return _core.frames_of_run(*options)


def _frames_of_file(path, deck, *options):
    return _core.frames_of_file(path, deck._loaded(True) if deck is not None else None, *options)
