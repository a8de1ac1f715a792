"""The record of a package: the files that were written, so that no others are touched."""

from __future__ import annotations

import os
from collections.abc import Iterable, Mapping
from pathlib import Path

from gainproof.bad_input import BadInputError
from gainproof.files import input_file, named_files, places
from gainproof.subjects import drift
from gainproof.subjects.drift import Difference

RECORD = "FILES.txt"
MOST_BYTES = 10**6
FIRST = "# written by gainproof generate, which replaces and deletes these files and no others"


def record_of(names: Iterable[str]) -> bytes:
    """The text of the record."""
    return "\n".join([FIRST, *sorted(names), ""]).encode("utf-8")


def recorded(folder: Path) -> frozenset[str]:
    """The files of a former run, by name; none in a folder without a record.

    Raises BadInputError for a record that cannot be one, or that names a file elsewhere.
    """
    path = folder / RECORD
    if not os.path.lexists(path):
        return frozenset()
    try:
        first, *names = input_file.text(path, MOST_BYTES).splitlines()
    except BadInputError:
        first, names = "", []
    if first != FIRST:
        raise BadInputError(f"{places.shown(path)}: not a record of gainproof; it is left as it is")
    for name in names:
        if not named_files.is_within(name):
            raise BadInputError(f"{places.shown(path)}: names {name!r}, which lies elsewhere")
    return frozenset((*names, RECORD))


def differences(files: Mapping[str, bytes], folder: Path) -> list[Difference]:
    """How a folder differs from the package; what no run has written there is not looked at."""
    wanted = {**files, RECORD: record_of(files)}
    former = recorded(folder)
    found = drift.compare(wanted, folder, only=True)
    for name in sorted(former - set(wanted)):
        if os.path.isfile(folder / name):
            found.append(Difference(name, "stale", "no longer part of the package"))
    return found


def put(files: Mapping[str, bytes], folder: Path) -> int:
    """Make the folder the package: write what is missing or different, all or none, and delete what
    a former run has written and this one does not. How many files.

    Raises BadInputError, and changes nothing, where a file stands that no run has written.
    """
    former = recorded(folder)
    named_files.require_within(folder, {*files, *former, RECORD})
    found = differences(files, folder)
    for each in found:
        path = folder / each.name
        if each.kind != "stale" and each.name not in former and os.path.lexists(path):
            raise BadInputError(
                f"{places.shown(path)}: no file that gainproof has written; it is left as it is, "
                "and nothing is written"
            )
    # the record comes first and names the files of both runs: an interrupt leaves none unknown
    changed = [each.name for each in found if each.kind != "stale" and each.name != RECORD]
    stale = [each.name for each in found if each.kind == "stale"]
    contents = {RECORD: record_of({*files, *stale}), **{name: files[name] for name in changed}}
    if found:
        named_files.write({folder / name: content for name, content in contents.items()})
    for name in stale:
        _delete(folder / name)
    if stale:
        named_files.write({folder / RECORD: record_of(files)})
    return len(found)


def _delete(path: Path) -> None:
    try:
        path.unlink(missing_ok=True)
    except OSError as error:
        reason = error.strerror or error
        raise BadInputError(f"{places.shown(path)}: cannot be deleted: {reason}") from None
