"""Subscripts: a letter, a digit, a Greek letter, or what stands in braces, without its blanks."""

from __future__ import annotations

from gainproof.verify.judge.reader.alphabet import (
    ACCENTS,
    BLANKS,
    GREEK,
    command_at,
    is_letter,
    skip_space,
)
from gainproof.verify.judge.reader.errors import ReaderError
from gainproof.verify.judge.reader.formula_limits import MOST_NAME_CHARACTERS

_CHARACTERS = frozenset("+-,()'*.=/_|:")
_SAME = {"\\mid": "|", "\\vert": "|", "\\prime": "'", "\\ast": "*", "\\star": "*"}
"""Commands that print a character which may also be typed."""
_NOTHING = frozenset(("\\,", "\\;", "\\:", "\\!", "\\ "))


def scan_subscript(text: str, position: int) -> tuple[str, int]:
    """The argument of `_` as (canonical text with the underscore, end)."""
    position = skip_space(text, position)
    character = text[position : position + 1]
    if character.isascii() and character.isalnum():
        return f"_{character}", position + 1
    if character == "\\":
        command = command_at(text, position)
        if command in GREEK or command == "\\infty":
            return f"_{{{command}}}", position + len(command)
    if character != "{":
        raise ReaderError(
            "a subscript must be a letter, a digit or {...}", text, position, character
        )
    inner, end = scan_braced(text, position)
    if not inner:
        raise ReaderError("an empty subscript", text, position, "{}")
    return (f"_{inner}" if len(inner) == 1 else f"_{{{inner}}}"), end


def scan_braced(text: str, opening: int) -> tuple[str, int]:
    """What stands between the brace at `opening` and its partner, without blanks, and the end."""
    depth, position, pieces = 0, opening, [""]
    while position < len(text):
        character = text[position]
        if position - opening > MOST_NAME_CHARACTERS:
            raise ReaderError(
                f"a subscript of more than {MOST_NAME_CHARACTERS} characters", text, opening, "_"
            )
        if character == "{":
            depth += 1
        elif character == "}":
            depth -= 1
            if depth == 0:
                return "".join(pieces)[1:], position + 1
        elif character == "\\":
            command = command_at(text, position)
            position += len(command)
            if command in _NOTHING:
                continue
            if command not in GREEK | ACCENTS | {"\\infty"} | _SAME.keys():
                problem = f"{command} cannot stand in a subscript"
                raise ReaderError(problem, text, position - len(command), command)
            pieces.append(_SAME.get(command, command))
            continue
        elif character in BLANKS:
            position += 1
            continue
        elif not (character.isascii() and (character.isalnum() or character in _CHARACTERS)):
            raise ReaderError(
                f"{character!r} cannot stand in a subscript", text, position, character
            )
        # a command and a letter after it stay two words
        blank = " " if pieces[-1].startswith("\\") and is_letter(character) else ""
        pieces.append(blank + character)
        position += 1
    raise ReaderError("a brace is never closed", text, opening, "{")
