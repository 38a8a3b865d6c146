"""Directories that are there: opened, resumed."""

from __future__ import annotations

from typing import TYPE_CHECKING, Any

from . import _check, _functions as functions, _progress
from .external import described_force
from .observables import described
from .reading.files import is_there
from .reading.sweeps import read_request
from .runs import Run

if TYPE_CHECKING:
    from ._types import Function, Functions, Path, Progress, Walltime


def open_run(directory: Path) -> Any:
    """The run in a directory, of Python or of the command line. It may be unfinished: then it has no results yet. Of a sweep: see
    `ljmd.open_sweep`. Of reference values: what `ljmd.reference` found.

    Raises DataError when it is not the directory of a run.
    """
    if is_there(_check.directory_of(directory) / "reference.json"):
        from .reference_values import Reference
        return Reference.open(directory)
    if is_there(_check.directory_of(directory) / "sweep.json"):
        from .replicas import Replicas
        from .sweeps import Sweep
        return Replicas.open(directory) if read_request(_check.directory_of(directory)).replicas else Sweep.open(directory)
    return Run.open(directory)


open = open_run  # noqa: A001, ljmd.open


def resume(directory: Path, *, steps: int = 0, observables: Functions | None = None, external: Function | None = None,
           threads: int | None = None, progress: Progress = True, walltime: Walltime = None) -> Run:
    """Resume the run in a directory from its last checkpoint. It ends with the bits of a run that was not interrupted.

    steps: to add to the last stage
    observables: those that it was begun with, in the same order; the pair potential is in the directory
    external: the external force that it was begun with
    threads: as many as before by default

    The Python process that began the run still has its observables and its external force: there they need not be given.

    Raises DataError, CheckpointError, InUseError; Interrupted and KeyboardInterrupt as `Deck.run`.
    """
    from . import _core
    directory = _check.directory_of(directory)
    about, _ = _core.describe(directory)
    steps = _check.whole(steps, "steps", 0)
    observables, external = functions.of_run(directory, observables, external)
    options = (_check.threads_of(threads), _check.seconds_of(walltime), described(observables),
               described_force(external))
    first = about["checkpoint"]["step"] if about["checkpoint"] else 0
    with _progress.shown(progress, about["total_steps"] + steps, first) as tell, functions.remembered(directory, observables, external):
        _core.resume(directory, steps, *options, tell, _check.warn)
    return Run.open(directory)
