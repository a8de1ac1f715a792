"""JSON in one canonical layout: what fits on a line is on a line, so that differences are readable.

Keys keep their order; separators, indentation and the newline at the end are fixed.
"""

from __future__ import annotations

import json
from collections.abc import Iterator, Mapping, Sequence
from typing import Any

WIDTH = 120
INDENT = 2
# made once: `json.dumps` would make one for each of the many short texts
_ENCODER = json.JSONEncoder(ensure_ascii=False, allow_nan=False, separators=(", ", ": "))


def canonical_json(value: Any) -> str:
    """The text of plain data. TypeError or ValueError for what JSON cannot hold, NaN included."""
    return "\n".join(_lines(value, 0, 0)) + "\n"


def _compact(value: Any) -> str:
    return _ENCODER.encode(value)


def _is_long(value: Mapping[str, Any] | Sequence[Any]) -> bool:
    """Whether the text is surely longer than a line, told without writing it all."""
    room, left = WIDTH, [value]
    while left and room >= 0:
        entry = left.pop()
        if isinstance(entry, str):
            room -= len(entry) + 2
        elif isinstance(entry, dict):
            room -= 6 * len(entry)
            left += entry.values()
        elif isinstance(entry, (list, tuple)):
            room -= 2 * len(entry)
            left += entry[: WIDTH // 2]
        else:
            room -= 1
    return room < 0


def _lines(value: Any, indent: int, used: int) -> list[str]:
    """The lines of a value that starts after `used` characters of a line indented by `indent`."""
    if not isinstance(value, (Mapping, list, tuple)):
        return [_compact(value)]
    if not _is_long(value):
        text = _compact(value)
        if indent + used + len(text) < WIDTH:
            return [text]
    inner = indent + INDENT
    if isinstance(value, Mapping):
        blocks = list(_members(value, inner))
        opened, closed = "{", "}"
    else:
        blocks = list(_entries(value, inner))
        opened, closed = "[", "]"
    lines = [opened]
    for at, block in enumerate(blocks):
        comma = "" if at == len(blocks) - 1 else ","
        lines += [" " * INDENT + line for line in block]
        lines[-1] += comma
    return [*lines, closed]


def _members(value: Mapping[str, Any], indent: int) -> Iterator[list[str]]:
    for key, entry in value.items():
        head = f"{_compact(key)}: "
        first, *rest = _lines(entry, indent, len(head))
        yield [head + first, *rest]


def _entries(value: Sequence[Any], indent: int) -> Iterator[list[str]]:
    """Entries that take a line each, or as many to a line as fit."""
    row = ""
    for entry in value:
        block = _lines(entry, indent, 0)
        if len(block) > 1:
            if row:
                yield [row]
            row = ""
            yield block
        elif row and indent + len(row) + len(block[0]) + 2 < WIDTH:
            row = f"{row}, {block[0]}"
        else:
            if row:
                yield [row]
            row = block[0]
    if row:
        yield [row]
