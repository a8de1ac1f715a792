"""JSON in lines that people can read and compare."""

from __future__ import annotations

import json
from typing import Any


def in_lines(value: Any, depth: int, indent: str = "") -> str:
    """JSON with the entries of so many levels on lines of their own, what is deeper on one line:
    the encoder that indents everything is written in Python and takes twenty times as long.
    """
    if not depth or not value or not isinstance(value, (dict, list)):
        return json.dumps(value, ensure_ascii=False)
    inner = indent + " "
    if isinstance(value, dict):
        entries = [
            f"{json.dumps(key, ensure_ascii=False)}: {in_lines(entry, depth - 1, inner)}"
            for key, entry in value.items()
        ]
        opened, closed = "{", "}"
    else:
        entries = [in_lines(entry, depth - 1, inner) for entry in value]
        opened, closed = "[", "]"
    lines = f",\n{inner}".join(entries)
    return f"{opened}\n{inner}{lines}\n{indent}{closed}"
