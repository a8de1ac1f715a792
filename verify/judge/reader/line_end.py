"""What may stand between a formula and the end of its line: punctuation, tags, its number."""

from __future__ import annotations

from gainproof.verify.judge.reader.alphabet import (
    BLANKS,
    DIGITS,
    command_at,
    is_letter,
    skip_space,
)
from gainproof.verify.judge.reader.errors import ReaderError
from gainproof.verify.judge.reader.tokens import SPACES, WIDE_SPACES

_NUMBER_MOST = 30
"""Characters of an equation number with the commands in it."""


class LineEnds:
    """Where lines of one text end. Punctuation that was seen to end none is not looked at again: a
    thousand commas are scanned once.
    """

    def __init__(self, text: str) -> None:
        self.text = text
        self._goes_on_until = -1

    def end_at(self, position: int) -> int | None:
        """The end of the punctuation at `position`, if it ends a line; else None."""
        if position < self._goes_on_until:
            return None
        number = equation_number_end(self.text, position)
        end = skip_idle(self.text, position) if number is None else number
        if end == len(self.text) or self.text.startswith(("\\end", "\\\\"), end):
            return end
        self._goes_on_until = end
        return None


def ends_line(text: str, position: int) -> bool:
    """Whether only punctuation and blanks stand from `position` to the end of the formula or of a
    line of it.
    """
    end = skip_idle(text, position)
    return end == len(text) or text.startswith(("\\end", "\\\\"), end)


def skip_idle(text: str, position: int) -> int:
    """The first position from `position` on where something other than blanks, punctuation and tags
    stands.
    """
    while position < len(text):
        character = text[position]
        if text.startswith("...", position):
            break
        if character in BLANKS or character in ".,;~":
            position += 1
        elif character == "\\":
            command = command_at(text, position)
            if command in ("\\tag", "\\label", "\\tag*"):
                position = end_of_tag(text, position + len(command))
            elif command in SPACES or command in WIDE_SPACES or command == "\\ ":
                position += len(command)
            else:
                break
        else:
            break
    return position


def end_of_tag(text: str, position: int) -> int:
    """The end of the `{...}` after `\\tag` or `\\label`. ReaderError where none stands."""
    opening = skip_space(text, position + (text[position : position + 1] == "*"))
    closing = text.find("}", opening, opening + 40)
    if text[opening : opening + 1] != "{" or closing < 0:
        raise ReaderError("a tag needs {...} of at most 40 characters", text, opening, "\\tag")
    return closing + 1


def equation_number_end(text: str, position: int) -> int | None:
    """The end of an equation number such as `(16a)`, `(A.4)` or `(\\text{A } 4)`, if nothing else
    stands from `position` to the end of the formula.
    """
    start = skip_idle(text, position)
    closing = text.find(")", start, start + _NUMBER_MOST)
    inner = text[start + 1 : closing].replace(" ", "")
    for mark in ("\\text{", "\\mathrm{", "}"):
        inner = inner.replace(mark, "")
    if text[start : start + 1] != "(" or closing < 0 or skip_idle(text, closing + 1) != len(text):
        return None
    known = all(c in DIGITS or is_letter(c) or c == "." for c in inner)
    return len(text) if known and any(c in DIGITS for c in inner) else None
