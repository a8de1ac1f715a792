"""Files that are either whole or not there: written beside their place, then moved into it."""

from __future__ import annotations

import contextlib
import errno
import os
import stat
import sys
import tempfile
from collections.abc import Mapping
from pathlib import Path
from typing import TextIO


def write_bytes(path: Path, content: bytes) -> None:
    """Put `content` at `path`, folders made as needed.

    An interrupt at any moment leaves the old file or the new one, never a part of it. A link stays
    and what it leads to is written. What is there and no regular file (a device, a FIFO) stays as
    it is and the content goes through it; so does the file that standard output or error goes to
    (/dev/stdout, redirected). Raises OSError when the place cannot be written.
    """
    write_together({path: content})


def write_together(contents: Mapping[Path, bytes]) -> None:
    """`write_bytes` of several: every one is written beside its place before the first is moved.

    Raises OSError, whose `filename` is the path that cannot be written.
    """
    partials: dict[Path, str] = {}
    through: list[Path] = []
    path = Path()
    try:
        for path, content in contents.items():
            if _goes_through(path):
                through.append(path)
            else:
                _write_beside(path, content, partials)
        for path in through:
            with os.fdopen(_opened(path), "wb") as stream:
                stream.write(contents[path])
        for path, partial in partials.items():
            os.replace(partial, os.path.realpath(path))
    except OSError as error:
        raise OSError(error.errno, error.strerror or str(error), str(path)) from error
    finally:
        for partial in partials.values():
            with contextlib.suppress(OSError):
                os.unlink(partial)


def _goes_through(path: Path) -> bool:
    """Whether something is there, links followed, that is neither a file nor a folder, or the file
    of a standard stream.
    """
    try:
        mode = path.stat().st_mode
    except (FileNotFoundError, NotADirectoryError):
        return False
    if stat.S_ISDIR(mode):
        raise IsADirectoryError(errno.EISDIR, os.strerror(errno.EISDIR))
    return not stat.S_ISREG(mode) or _standard_stream(path) is not None


def _opened(path: Path) -> int:
    """A descriptor that writes through what is there."""
    standard = _standard_stream(path)
    if standard is None:
        # no O_CREAT and no O_TRUNC: should it be gone by now, nothing takes its place
        return os.open(path, os.O_WRONLY)
    # opened again a file would be written from its beginning, over what the stream writes
    standard.flush()
    return os.dup(standard.fileno())


def _standard_stream(path: Path) -> TextIO | None:
    """The standard stream that goes to this file."""
    for stream in (sys.stdout, sys.stderr):
        with contextlib.suppress(OSError, ValueError, AttributeError):
            if os.path.samestat(path.stat(), os.fstat(stream.fileno())):
                return stream
    return None


def _write_beside(path: Path, content: bytes, partials: dict[Path, str]) -> None:
    """Into a new file of the folder where `path` leads, which is noted in `partials` at once."""
    place = Path(os.path.realpath(path))
    place.parent.mkdir(parents=True, exist_ok=True)
    handle, partial = tempfile.mkstemp(
        prefix=f".{place.name}.", suffix=".partial", dir=place.parent
    )
    partials[path] = partial
    with os.fdopen(handle, "wb") as stream:
        stream.write(content)
    # mkstemp makes files for the owner alone; these are as readable as any other
    os.chmod(partial, 0o666 & ~_umask())


def write_text(path: Path, content: str) -> None:
    """`write_bytes` of the text as UTF-8 with plain line ends on every system."""
    write_bytes(path, content.encode("utf-8"))


def _umask() -> int:
    mask = os.umask(0)
    os.umask(mask)
    return mask
