"""Layout of printed source: on one line where it fits, else one entry a line.

It is the layout that formatters give, so that a printed file needs no formatting.
"""

from __future__ import annotations

from collections.abc import Sequence

WIDTH = 100


def listed(head: str, entries: Sequence[str], tail: str) -> list[str]:
    """`head`, the entries and `tail`; the entries one a line, indented, where one line is short."""
    line = f"{head}{', '.join(entries)}{tail}"
    if len(line) <= WIDTH:
        return [line]
    indent = " " * (len(head) - len(head.lstrip()))
    return [head, *(f"{indent}    {entry}," for entry in entries), f"{indent}{tail}"]


def row(indent: str, entries: Sequence[str], tail: str = "") -> list[str]:
    """A tuple; of one entry with the comma that it needs."""
    if len(entries) == 1:
        return [f"{indent}({entries[0]},){tail}"]
    return listed(f"{indent}(", entries, f"){tail}")


def call(result: str, signature: str, names: Sequence[str]) -> list[str]:
    """`return result(*evaluate(signature, (names), out, workers))`, in a function."""
    given = row("", names)
    inner = f"*evaluate({signature}, {given[0]}, out, workers)"
    if len(given) == 1 and len(line := f"    return {result}({inner})") <= WIDTH:
        return [line]
    if len(given) == 1 and len(line := f"        {inner}") <= WIDTH:
        return [f"    return {result}(", line, "    )"]
    return [
        f"    return {result}(",
        "        *evaluate(",
        f"            {signature},",
        *row(" " * 12, names, ","),
        "            out,",
        "            workers,",
        "        )",
        "    )",
    ]
