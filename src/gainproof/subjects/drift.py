"""Generated files against a fresh derivation, byte for byte; files nobody makes are drift too."""

from __future__ import annotations

import os
from collections.abc import Mapping
from dataclasses import dataclass
from pathlib import Path

from gainproof.bad_input import BadInputError
from gainproof.files import places
from gainproof.subjects import bounds_ledger

CURE = "run `gainproof generate` and commit what it writes"


@dataclass(frozen=True)
class Difference:
    """One file that is not as it should be; `kind` is missing, different or stale."""

    name: str
    kind: str
    detail: str

    def text(self) -> str:
        """One line for people."""
        return f"{self.name}: {self.kind}{', ' + self.detail if self.detail else ''}"


def compare(
    fresh: Mapping[str, bytes], folder: Path, *, only: bool = False, exactly: bool = False
) -> list[Difference]:
    """How `folder` differs from the files it should hold (names relative to it).

    `only`: other files in the folder are none of our business. With which versions bounds were
    proved is a difference only if that is asked `exactly`.
    """
    found = []
    for name, wanted in sorted(fresh.items()):
        content = _content(folder / name)
        if content is None:
            found.append(Difference(name, "missing", ""))
        elif content != wanted and (exactly or not _alike(name, content, wanted)):
            found.append(Difference(name, "different", first_difference(content, wanted)))
    if not only:
        stale = sorted(set(files_in(folder)) - set(fresh))
        found += [Difference(name, "stale", "no derivation makes this file") for name in stale]
    return found


def _alike(name: str, content: bytes, wanted: bytes) -> bool:
    """Whether two files of this name differ in nothing that two machines must agree on."""
    if name != bounds_ledger.NAME:
        return False
    first, second = map(bounds_ledger.without_versions, (content, wanted))
    return first == second


def _content(path: Path) -> bytes | None:
    """What the file holds, if it is one. Raises BadInputError where it cannot be read."""
    if not os.path.isfile(path):
        return None
    try:
        return path.read_bytes()
    except OSError as error:
        reason = error.strerror or error
        raise BadInputError(f"{places.shown(path)}: cannot be read: {reason}") from None


def files_in(folder: Path) -> list[str]:
    """Every file below the folder but Python's own caches, relative, with forward slashes."""
    if not folder.is_dir():
        return []
    return [
        path.relative_to(folder).as_posix()
        for path in sorted(folder.rglob("*"))
        if path.is_file() and "__pycache__" not in path.parts
    ]


def first_difference(content: bytes, wanted: bytes) -> str:
    """The first line that differs."""
    old, new = content.split(b"\n"), wanted.split(b"\n")
    for number, (left, right) in enumerate(zip(old, new, strict=False), start=1):
        if left != right:
            return f"first in line {number}: {_shown(left)} instead of {_shown(right)}"
    return f"{len(old)} lines instead of {len(new)}"


def _shown(line: bytes) -> str:
    text = line.decode("utf-8", errors="replace")
    return repr(text if len(text) <= 60 else text[:57] + "...")
