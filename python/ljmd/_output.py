"""The one door for files of Python under names that a user gives. Needs no compiled part.

A file that ljmd did not write is not replaced unless that is asked for, and a link is never followed: it is replaced itself. The new
file grows beside its place, and takes it when it is complete: what fails leaves the old file, and no other.
"""

from __future__ import annotations

import contextlib
import errno
import os
import pathlib
import secrets
import stat
from collections.abc import Iterator

from .errors import FileError, InputError

_LOOKED_AT = 65536  # bytes at both ends of a file in which its mark is looked for


def _bears(path: pathlib.Path, mark: bytes) -> bool:
    with path.open("rb") as file:
        beginning = file.read(_LOOKED_AT)
        file.seek(max(0, os.fstat(file.fileno()).st_size - _LOOKED_AT))
        return mark in beginning or mark in file.read()


def require_writable(path: pathlib.Path, *, force: bool = False, mark: bytes = b"", how: str = "force=True") -> None:
    """Refuse a file that must not be written. Changes nothing.

    force: replace whatever file or link is there
    mark: what files of ljmd have in their first or last 64 KiB; those are replaced. Empty: none is
    how: how a user asks for `force`; empty: not at all

    Raises InputError; FileError when it is not known what is there.
    """
    try:
        if not path.name or path.is_dir() or (path.exists() and not path.is_file()):
            raise InputError(f"{path} is in the way: a file of that name is to be written, and this is no file: choose another name")
        there = path.lstat()
        if force or (mark and stat.S_ISREG(there.st_mode) and _bears(path, mark)):
            return
    except (FileNotFoundError, NotADirectoryError):
        return
    except OSError as error:
        if isinstance(error, FileError):
            raise
        raise FileError(f"{path}: cannot be looked at: {error.strerror}") from None
    why = ", a link, which is not followed" if stat.S_ISLNK(there.st_mode) else ", and was not written by ljmd" if mark else ""
    raise InputError(f"{path} is there already{why}: choose another name{f', or replace it with {how}' if how else ''}")


@contextlib.contextmanager
def replacing(path: pathlib.Path, *, force: bool = False, mark: bytes = b"", how: str = "force=True") -> Iterator[pathlib.Path]:
    """The path of an empty file, which takes its place when it was filled. It has the same ending.

    Raises InputError as require_writable(), FileError.
    """
    require_writable(path, force=force, mark=mark, how=how)
    growing = path.with_name(f".ljmd-{secrets.token_hex(8)}{path.suffix}")
    made = False
    try:
        os.close(os.open(growing, os.O_WRONLY | os.O_CREAT | os.O_EXCL | os.O_CLOEXEC, 0o666))
        made = True
        yield growing
        _synchronise(growing)
        require_writable(path, force=force, mark=mark, how=how)  # somebody may have put a file there meanwhile
        growing.replace(path)
        made = False
    except OSError as error:
        if isinstance(error, FileError):
            raise
        raise FileError(f"{path}: cannot be written: {error.strerror or error}") from None
    finally:
        if made:
            growing.unlink(missing_ok=True)


def _synchronise(path: pathlib.Path) -> None:
    """Wait until a file is on the disk, so that after a power cut its name leads to all of it."""
    with path.open("rb") as file:
        try:
            os.fsync(file.fileno())
        except OSError as error:
            if error.errno != errno.EINVAL:  # a file system that cannot
                raise


def write_text(path: pathlib.Path, text: str, *, force: bool = False, mark: bytes = b"", how: str = "force=True") -> None:
    """Write a file in UTF-8. Raises as replacing()."""
    with replacing(path, force=force, mark=mark, how=how) as growing:
        growing.write_text(text, encoding="utf-8")
