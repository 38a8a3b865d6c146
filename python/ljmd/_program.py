"""The program `ljmd`: what needs processes of its own, sweeps and comparisons, is done by its commands."""

from __future__ import annotations

import functools
import json
import os
import pathlib
import shutil
import signal
import subprocess
import sys
import threading

from . import _check
from .errors import (CheckpointError, DataError, Error, FileError, InputError, InternalError, InUseError, PhysicsError,
                     ThreadsError)

# Exit codes of the program, docs/files.md.
_ERRORS = {1: InternalError, 2: InputError, 3: DataError, 4: FileError, 5: PhysicsError, 6: CheckpointError, 7: ThreadsError,
           9: InUseError}


def _candidates():
    if os.environ.get("LJMD_PROGRAM"):
        yield os.environ["LJMD_PROGRAM"]
        return
    from . import _core
    package = pathlib.Path(_core.__file__).resolve().parent
    yield package / "bin" / "ljmd"  # of a wheel
    yield package.parents[1] / "ljmd"  # of the build tree
    yield from (folder / "bin" / "ljmd" for folder in package.parents[1:6])  # of an installation
    if shutil.which("ljmd"):
        yield shutil.which("ljmd")


def _environment() -> dict:
    """Without the variables of mpirun: the program is no rank, also where this process was started as one."""
    return {name: value for name, value in os.environ.items() if not name.startswith(("OMPI_", "PMI_", "PMIX_"))}


def _require_one_process() -> None:
    from . import _core
    started = _core.launched_processes()
    if started > 1:
        raise InputError(f"{started} processes were started together, by mpirun or the like, and each would do the same: sweeps, "
                         "replicas, reference values and comparisons are for one process, which starts others itself")


@functools.lru_cache(maxsize=8)
def _is_ours(path: str) -> bool:
    from . import _core
    found = subprocess.run([path, "info", "--json"], capture_output=True, text=True, check=False, env=_environment())
    try:
        about = json.loads(found.stdout)
    except ValueError:
        return False
    ours = _core.build()
    return all(about.get(key) == ours[key] for key in ("version", "commit"))


def program() -> str:
    """Path of the program of the same version. Raises InputError if there is none."""
    tried = []
    for path in _candidates():
        if os.path.isfile(path) and os.access(path, os.X_OK):
            if _is_ours(os.fspath(path)):
                return os.fspath(path)
            tried.append(f"{path} is of another version or commit")
    found = f" ({'; '.join(tried)})" if tried else ""
    raise InputError(f"sweeps and comparisons are done by the program `ljmd` of this version, which is not found{found}: build and "
                     "install it with the package, or set LJMD_PROGRAM to its path")


def call(arguments, *, told=None, allowed=(0,), note: str = "", stop=signal.SIGUSR1) -> tuple:
    """Run a command of the program. Returns its exit code and what it prints.

    told: called with each line that the program says while it works, in this thread
    allowed: exit codes that are no error
    note: added to KeyboardInterrupt
    stop: signal that Ctrl-C sends to the program, which has then time to end; a second Ctrl-C does not wait

    The interpreter is free meanwhile. Raises the error of ljmd that belongs to the exit code, with the program's text.
    """
    _require_one_process()
    words = [str(argument) for argument in arguments]
    for word in words:
        if "\0" in word:
            raise InputError("a text for the program `ljmd` has the character NUL in it")
        try:
            os.fsencode(word)  # names of files are bytes, which need not be UTF-8
        except UnicodeEncodeError:
            raise InputError(f"{_check.shown(word)} cannot be given to the program `ljmd`: half of a surrogate pair is no character") from None
    with subprocess.Popen([program(), *words], stdin=subprocess.DEVNULL, stdout=subprocess.PIPE, stderr=subprocess.PIPE,
                          text=True, encoding="utf-8", errors="replace", env=_environment()) as process:
        assert process.stdout is not None and process.stderr is not None
        output = process.stdout
        printed: list = []
        reader = threading.Thread(target=lambda: printed.append(output.read()), daemon=True)
        reader.start()
        said = []
        try:
            for line in process.stderr:
                said.append(line.rstrip("\n"))
                if told is not None:
                    told(said[-1])
            code = process.wait()
        except BaseException as error:
            _stop(process, stop)
            if isinstance(error, KeyboardInterrupt) and note and sys.version_info >= (3, 11):
                error.add_note(note)  # type: ignore[attr-defined]
            raise
        reader.join()
    if code not in allowed:
        raise_error(code, said)
    return code, printed[0], said


def _stop(process, number) -> None:
    """Ask the program to stop, and wait until it has; another exception meanwhile kills it."""
    try:
        process.send_signal(number)
        for _ in process.stderr:
            pass
        process.wait()
    except BaseException:
        process.kill()
        raise


def raise_error(code: int, said: list) -> None:
    """The error of ljmd that belongs to an exit code, with what the program has said."""
    first = next((k for k, line in enumerate(said) if line.startswith(("error:", "internal error:"))), None)
    text = "\n".join(said[first:] if first is not None else said[-5:])
    if code in (-signal.SIGINT, 128 + signal.SIGINT):
        raise KeyboardInterrupt(text)
    if code < 0 or code > 128:
        raise Error(text or f"the program was ended by signal {-code if code < 0 else code - 128}")
    raise _ERRORS.get(code, Error)(text.removeprefix("error: ") if "\n" not in text else text)


def warned(said) -> None:
    """The program's warnings as warnings of Python."""
    text: list = []
    for line in [*said, "warning: "]:
        if line.startswith("warning: "):
            if text:
                _check.warn("\n".join(text))
            text = [line] if line != "warning: " else []
        elif text and line.startswith("  "):
            text.append(line)
