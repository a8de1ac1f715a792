"""Errata sheets in Markdown with formulas between double dollars."""

from __future__ import annotations

from collections.abc import Iterable

from gainproof.errata_entries import Block

_SPECIAL = frozenset("\\`*_{}[]#|<>~$")
_MARKS = {"source": "# ", "part": "## ", "entry": "### ", "text": ""}


def document(blocks: Iterable[Block]) -> str:
    """The whole sheet, a heading for each source."""
    return "\n\n".join(_set(how, text) for how, text in blocks) + "\n"


def _set(how: str, text: str) -> str:
    if how == "formula":
        return f"$$\n{text}\n$$"
    if how == "quote":
        return "\n".join(f"    {line}" for line in text.split("\n"))
    return f"{_MARKS[how]}{_escaped(text)}"


def _escaped(text: str) -> str:
    """Text that Markdown shows as it is."""
    return "".join(f"\\{character}" if character in _SPECIAL else character for character in text)
