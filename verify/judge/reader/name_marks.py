"""Marks that belong to a name: `x^{-}`, `x^*`, `x^{(1)}` above it, `x(+)`, `x(k|k-1)`, `x[k]`
behind it.

A mark is part of a name only where that name is declared with it. Otherwise it means what it always
means: a power, a product with a bracket, the arguments of a function.
"""

from __future__ import annotations

from typing import NamedTuple

from gainproof.verify.judge.reader.alphabet import (
    BLANKS,
    GREEK,
    braced_sign_end,
    command_at,
    is_letter,
    skip_space,
)

_SIGNS = {"+": "+", "-": "-", "*": "*", "\\ast": "*", "\\star": "*", "\\dagger": "\\dagger"}
_BEHIND = frozenset("+-*/,|_{}'.:")
_CLOSING = {"(": ")", "[": "]"}
_MOST_CHARACTERS = 40


class Mark(NamedTuple):
    """Canonical text and end."""

    text: str
    end: int


def scan_mark_above(text: str, position: int) -> Mark | None:
    """A superscript at `position` that is a sign, or anything in parentheses; None for others."""
    position = skip_space(text, position)
    if text[position : position + 1] != "^":
        return None
    position = skip_space(text, position + 1)
    braced = text[position : position + 1] == "{"
    start = skip_space(text, position + 1) if braced else position
    sign = command_at(text, start) if text[start : start + 1] == "\\" else text[start : start + 1]
    inner, end = _SIGNS.get(sign, ""), start + len(sign)
    if braced and sign == "(":
        found = scan_mark_behind(text, start)
        if found is None:
            return None
        inner, end = found
    if not inner:
        return None
    if braced:
        end = skip_space(text, end)
        if text[end : end + 1] != "}":
            return None
        end += 1
    return Mark(f"^{{{inner}}}", end)


def scan_mark_behind(text: str, position: int) -> Mark | None:
    """`(+)`, `(k|k-1)`, `[n]` at `position`, without blanks; None if no mark stands there."""
    start = skip_space(text, position)
    closing = _CLOSING.get(text[start : start + 1])
    if closing is None:
        return None
    pieces = [text[start]]
    position = start + 1
    while position < len(text) and position - start <= _MOST_CHARACTERS:
        character = text[position]
        if character == closing:
            if len(pieces) == 1:
                return None
            return Mark("".join(pieces) + closing, position + 1)
        if character == "\\":
            command = command_at(text, position)
            if command not in GREEK | {"\\mid", "\\infty"}:
                return None
            pieces.append("|" if command == "\\mid" else command)
            position += len(command)
            continue
        if character == "{" and (sign_end := braced_sign_end(text, position)) is not None:
            pieces.append(text[position:sign_end].strip("{} \t\n"))
            position = sign_end
            continue
        if character not in BLANKS:
            if not (character.isascii() and (character.isalnum() or character in _BEHIND)):
                return None
            # a command and a letter after it stay two words
            blank = " " if pieces[-1].startswith("\\") and is_letter(character) else ""
            pieces.append(blank + character)
        position += 1
    return None
