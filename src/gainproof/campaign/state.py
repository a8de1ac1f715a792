"""The state file of a campaign: a line of JSON for each block that is done.

Lines are added at the end, each by one write. What an interrupt leaves of a line is no line of
JSON: it is passed over, and so are the lines of other campaigns and of blocks that are none any
more. A line of a block with what cannot be its result is an error. Files of several machines are
joined by writing one after the other.
"""

from __future__ import annotations

import json
import os
from collections.abc import Callable, Iterator
from contextlib import contextmanager
from math import inf
from pathlib import Path
from typing import Any

from gainproof.bad_input import BadInputError
from gainproof.campaign.campaign import Arguments, Campaign, Done
from gainproof.files import places

Keep = Callable[[Done], None]


def read(path: Path, campaign: Campaign) -> dict[int, Done]:
    """The blocks of the campaign that the file has as done, by number; none if there is no file.

    Raises BadInputError where it cannot be read or is no file, as a device is, and with its line
    where a block has what cannot be its result, or two results.
    """
    numbers = {_key(arguments): number for number, arguments in enumerate(campaign.blocks)}
    found: dict[int, Done] = {}
    lines: dict[int, int] = {}
    places.require_file(path)
    try:
        content = path.read_bytes()
    except FileNotFoundError:
        return found
    except OSError as error:
        raise BadInputError(f"{path}: cannot be read: {error.strerror}") from None
    for line, text in enumerate(content.split(b"\n"), 1):
        entry = _entry(text)
        if entry.get("campaign") != campaign.name:
            continue
        number = numbers.get(_key(entry.get("block")))
        if number is None:
            continue
        arguments = campaign.blocks[number]
        fault = _fault(entry, arguments, campaign)
        done = Done(arguments, entry.get("result"), entry.get("seconds", 0.0))
        if fault is None and _key(found.setdefault(number, done).result) != _key(done.result):
            fault = f"another result than that of line {lines[number]}"
        if fault is not None:
            raise BadInputError(f"{path}, line {line}: block {number} of {campaign.name}: {fault}")
        lines.setdefault(number, line)
    return found


def _entry(line: bytes) -> dict[str, Any]:
    """What a line says; nothing where it is none of ours, nor whole."""
    try:
        entry = json.loads(line)
    except (ValueError, RecursionError):
        return {}
    return entry if isinstance(entry, dict) else {}


def _fault(entry: dict[str, Any], arguments: Arguments, campaign: Campaign) -> str | None:
    """What is wrong with a line of a block."""
    missing = sorted({"result", "seconds"} - entry.keys())
    if missing:
        return f"no {' and no '.join(missing)}"
    seconds = entry["seconds"]
    if isinstance(seconds, bool) or not isinstance(seconds, int | float) or not 0 <= seconds < inf:
        return f"seconds must be a number from 0, got {seconds!r}"
    return campaign.fault(arguments, entry["result"])


def _key(data: Any) -> str:
    return json.dumps(data, sort_keys=True)


@contextmanager
def appended(path: Path, campaign: Campaign) -> Iterator[Keep]:
    """Gives what adds a block to the file.

    Raises BadInputError where the file cannot be opened, OSError where a line cannot be written.
    """
    try:
        path.parent.mkdir(parents=True, exist_ok=True)
        handle = os.open(path, os.O_RDWR | os.O_APPEND | os.O_CREAT, 0o666)
    except OSError as error:
        raise BadInputError(f"{path}: cannot be written: {error.strerror}") from None

    def write(text: str) -> None:
        content = text.encode("utf-8")
        if os.write(handle, content) != len(content):
            raise OSError(f"{path}: a line could not be written whole")

    def keep(done: Done) -> None:
        entry = {
            "campaign": campaign.name,
            "block": done.arguments,
            "result": done.result,
            "seconds": round(done.seconds, 3),
        }
        write(json.dumps(entry) + "\n")

    try:
        size = os.fstat(handle).st_size
        if size and os.pread(handle, 1, size - 1) != b"\n":
            write("\n")  # ends what an interrupt left of a line
        yield keep
    finally:
        os.close(handle)
