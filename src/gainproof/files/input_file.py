"""The content of a file that a user names, read in one place for all commands."""

from __future__ import annotations

import os
import stat
from pathlib import Path

from gainproof.bad_input import BadInputError
from gainproof.files import places

_OPENED = os.O_RDONLY | getattr(os, "O_NONBLOCK", 0) | getattr(os, "O_BINARY", 0)
"""A pipe that takes the file's place meanwhile is opened without a wait for its sender."""


def content(path: Path, most: int) -> bytes:
    """At most `most` bytes, the whole file as it stood while it was read.

    Raises BadInputError, before anything is read, for what is no regular file (a device never ends,
    a pipe waits) or too large; and for a file that was changed or grew meanwhile, of which a part
    would be taken for the whole.
    """
    places.require_file(path)
    shown = places.shown(path)
    try:
        with os.fdopen(os.open(path, _OPENED), "rb") as stream:
            before = os.fstat(stream.fileno())
            if not stat.S_ISREG(before.st_mode):
                raise BadInputError(f"{shown}: a regular file is wanted, this is none")
            if before.st_size > most:
                raise BadInputError(f"{shown}: more than {most} bytes")
            found = stream.read(most + 1)
            after = os.fstat(stream.fileno())
    except OSError as error:
        raise BadInputError(f"{shown}: cannot be read: {error.strerror or error}") from None
    same = (before.st_size, before.st_mtime_ns) == (after.st_size, after.st_mtime_ns)
    if not same or len(found) != before.st_size:
        raise BadInputError(f"{shown}: changes while it is read; wanted: a file that is complete")
    return found


def text(path: Path, most: int) -> str:
    """The same as UTF-8. Raises BadInputError also for other bytes, with their line."""
    found = content(path, most)
    try:
        return found.decode("utf-8")
    except UnicodeDecodeError as error:
        line = found[: error.start].count(b"\n") + 1
        raise BadInputError(
            f"{places.shown(path)}, line {line}: cannot be read: is no UTF-8 text"
        ) from None
