"""Displayed equations of a LaTeX text, in their order."""

from __future__ import annotations

from collections.abc import Iterator
from dataclasses import dataclass

from gainproof.claims.tex_text import body_start

ONE_ROW = ("equation", "displaymath", "multline", "math")
ROWS = ("align", "gather", "eqnarray", "alignat", "flalign")
_NUMBERED_LESS = ("displaymath", "math")
_SUBEQUATIONS = "subequations"


@dataclass(frozen=True)
class Display:
    """The inside of one display: `environment` without its star (`[` and `$$` for the short
    forms), whether its rows are numbered, and the offset of `content` in the text.
    """

    environment: str
    numbered: bool
    content: str
    offset: int


@dataclass(frozen=True)
class Mark:
    """`\\begin{subequations}` (`opens`) or its end."""

    opens: bool


def displays(text: str) -> Iterator[Display | Mark]:
    """All displays of the body. `text` is without comments. A display without an end is left out,
    with what follows it.
    """
    position = body_start(text)
    dollars = text.find("$$", position)
    while True:
        backslash = text.find("\\", position)
        if 0 <= dollars < position:
            dollars = text.find("$$", position)
        if backslash < 0 and dollars < 0:
            return
        if backslash < 0 or 0 <= dollars < backslash:
            end = text.find("$$", dollars + 2)
            if end < 0:
                return
            yield Display("$$", False, text[dollars + 2 : end], dollars + 2)
            position = end + 2
            continue
        found = _at_backslash(text, backslash)
        if found is None:
            position = backslash + 2
            continue
        display, position = found
        if display is None:
            return
        yield display


def _at_backslash(text: str, place: int) -> tuple[Display | Mark | None, int] | None:
    """What begins at a backslash and where it ends; None if no display does."""
    if text.startswith("\\[", place):
        return _until(text, "[", False, place + 2, "\\]")
    for opens, word in ((True, "\\begin{"), (False, "\\end{")):
        mark = f"{word}{_SUBEQUATIONS}}}"
        if text.startswith(mark, place):
            return Mark(opens), place + len(mark)
    if not text.startswith("\\begin{", place):
        return None
    start = place + len("\\begin{")
    close = text.find("}", start, start + 20)
    name = text[start:close] if close >= 0 else ""
    bare = name.removesuffix("*")
    if bare not in (*ONE_ROW, *ROWS):
        return None
    numbered = bare == name and bare not in _NUMBERED_LESS
    return _until(text, bare, numbered, close + 1, f"\\end{{{name}}}")


def _until(
    text: str, environment: str, numbered: bool, start: int, closing: str
) -> tuple[Display | None, int]:
    end = text.find(closing, start)
    if end < 0:
        return None, len(text)
    return Display(environment, numbered, text[start:end], start), end + len(closing)
