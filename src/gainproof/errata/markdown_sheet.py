"""Errata sheets in Markdown with formulas between dollars."""

from __future__ import annotations

from collections.abc import Iterable

from gainproof.errata.errata_entries import Block
from gainproof.formulas.sentence_formulas import written

_SPECIAL = frozenset("\\`*_{}[]#|<>~$")
_MARKS = {"source": "# ", "part": "## ", "entry": "### ", "line": ""}


def document(blocks: Iterable[Block]) -> str:
    """The whole sheet, a heading for each source."""
    return "\n\n".join(map(_set, blocks)) + "\n"


def _set(block: Block) -> str:
    if block.how == "formula":
        return f"$$\n{block.text}\n$$"
    if block.how == "quote":
        return "\n".join(f"    {line}" for line in block.text.split("\n"))
    if block.how == "text":
        return written(block.sentence, block.symbols, _escaped)
    return f"{_MARKS[block.how]}{_escaped(block.text)}"


def _escaped(text: str) -> str:
    """Text that Markdown shows as it is."""
    return "".join(f"\\{character}" if character in _SPECIAL else character for character in text)
