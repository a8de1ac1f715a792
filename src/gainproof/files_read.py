"""The files that a user's code reads: modules that it imports and data that it opens.

What is derived from the code is known only as long as these are as they were.
"""

from __future__ import annotations

import hashlib
import importlib.util
import sys
import sysconfig
from collections.abc import Iterator, Mapping
from contextlib import contextmanager
from pathlib import Path
from typing import Any

from gainproof.places import package_folder

INSTALLED = ("stdlib", "platstdlib", "purelib", "platlib")
"""Folders of Python and of packages, whose versions belong to every key."""


@contextmanager
def recorded(folder: Path) -> Iterator[dict[str, str]]:
    """Digests of the files opened within, by path, which are there at the end. Modules are found in
    `folder` too, after all others, and those found outside of what is installed are forgotten at
    the end: the next file may mean another one by the same name.
    """
    opened: list[str] = []
    listening = True

    def heard(event: str, arguments: Any) -> None:
        if listening and event == "open" and isinstance(arguments[0], str):
            opened.append(arguments[0])

    sys.addaudithook(heard)  # cannot be taken back
    before = set(sys.modules)
    sys.path.append(str(folder))
    found: dict[str, str] = {}
    try:
        yield found
    finally:
        listening = False
        sys.path.remove(str(folder))
        for name in set(sys.modules) - before:
            place = getattr(sys.modules[name], "__file__", None)
            if place is not None and not _is_installed(Path(place)):
                del sys.modules[name]
    for path in {_source(Path(name).absolute()) for name in opened}:
        if path.is_file() and not _is_installed(path):
            found[str(path)] = _digest(path)


def unchanged(read: Mapping[str, str]) -> bool:
    """Whether all files are as they were when they were read."""
    return all(_digest(Path(name)) == digest for name, digest in read.items())


def _digest(path: Path) -> str:
    """That of the content; of no file where it cannot be read."""
    try:
        return hashlib.sha256(path.read_bytes()).hexdigest()
    except OSError:
        return ""


def _source(path: Path) -> Path:
    """The file of a module, of which a compiled copy was opened."""
    if path.suffix != ".pyc":
        return path
    try:
        return Path(importlib.util.source_from_cache(str(path)))
    except ValueError:
        return path


def _is_installed(path: Path) -> bool:
    ours = (package_folder(name) for name in ("", "derive", "verify", "generated"))
    homes = (*(Path(sysconfig.get_path(name)) for name in INSTALLED), *ours)
    return any(path.is_relative_to(home) for home in homes)
