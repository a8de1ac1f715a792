"""The files that arguments name: what is read is not written; all are written, or none."""

from __future__ import annotations

import os
import stat
from collections.abc import Iterable, Mapping, Sequence
from pathlib import Path, PurePosixPath

from gainproof.bad_input import BadInputError
from gainproof.files import atomic_file, places


def require_apart(read: Mapping[str, str | None], written: Mapping[str, str | None]) -> None:
    """That no file to be written is one that is read, nor another that is written.

    Both: the names of arguments with the paths given, None where there is none. Links and second
    names are the file itself. Raises BadInputError.
    """
    known = [(what, path) for what, path in read.items() if path]
    for what, path in written.items():
        if not path:
            continue
        for other, taken in known:
            if _are_one(path, taken):
                raise BadInputError(
                    f"{what} and {other} name one file, {places.shown(path)}; wanted: another "
                    f"name for {what}"
                )
        known.append((what, path))


def require_new(paths: Sequence[Path]) -> None:
    """That nothing stands there, not even a link that leads nowhere. Raises BadInputError."""
    for path in paths:
        if os.path.lexists(path):
            raise BadInputError(f"{places.shown(path)}: exists already; it is left as it is")


def is_within(name: str) -> bool:
    """Whether a name that is given in a folder lies in it, on every system."""
    parts = PurePosixPath(name).parts
    elsewhere = name.startswith("/") or ".." in parts or "\\" in name or ":" in name
    return bool(parts) and not elsewhere


def require_within(folder: Path, names: Iterable[str]) -> None:
    """That these files lie in the folder, and what is in it on the way to them are files and
    folders: what a link leads to, or a device, would be written or deleted. Raises BadInputError.
    """
    for name in sorted(names):
        if not is_within(name):
            raise BadInputError(f"{places.shown(folder)}: {name!r} would lie outside of it")
        for path in (folder / name, *(folder / name).parents):
            if path == folder:
                break
            mode = os.lstat(path).st_mode if os.path.lexists(path) else stat.S_IFREG
            if not (stat.S_ISREG(mode) or stat.S_ISDIR(mode)):
                what = "a link, which leads elsewhere" if stat.S_ISLNK(mode) else "no file"
                raise BadInputError(
                    f"{places.shown(folder)}: {path.relative_to(folder)} in it is {what}; it is "
                    "left as it is, and nothing is written"
                )


def write(contents: Mapping[Path, bytes]) -> list[str]:
    """All of them, or none where one cannot be written; their names as shown.

    Raises BadInputError.
    """
    try:
        atomic_file.write_together(contents)
    except OSError as error:
        shown = places.shown(error.filename)
        raise BadInputError(f"{shown}: cannot be written: {error.strerror or error}") from None
    return [places.shown(path) for path in contents]


def _are_one(first: str, second: str) -> bool:
    try:
        one, other = os.stat(first), os.stat(second)
    except OSError:
        return os.path.realpath(first) == os.path.realpath(second)
    # a terminal may be read and written; nothing of it is lost
    return os.path.samestat(one, other) and not stat.S_ISCHR(one.st_mode)
