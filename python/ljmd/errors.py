"""Exceptions of ljmd. Their texts are those of the command line."""


class Error(Exception):
    """Base of what ljmd raises."""


class InputError(Error, ValueError):
    """A deck, an argument or a callback is wrong. The text has every mistake with its place and what is allowed."""


class DataError(Error, ValueError):
    """A data file, such as a start configuration or a trajectory, cannot be used."""


class FileError(Error, OSError):
    """An output could not be written."""


class CheckpointError(Error):
    """A checkpoint is damaged, or belongs to another run or another version of ljmd."""


class InUseError(Error, RuntimeError):
    """Another run is writing to the directory, or another thread is stepping the simulation."""


class PhysicsError(Error, ArithmeticError):
    """The run has left the domain of physics: positions that are not finite, a time step that is too large."""


class ThreadsError(Error, RuntimeError):
    """The system refuses that many threads."""


class Interrupted(Error):
    """The wall time of a run is over. Its checkpoint is written: `ljmd.resume()` continues it."""


class InternalError(RuntimeError):
    """A mistake in ljmd itself. Please report it."""


class RunWarning(UserWarning):
    """A remark on a deck or on the results of a run."""
