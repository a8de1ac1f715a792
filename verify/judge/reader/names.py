"""Symbols as printed: accents, letters, primes and subscripts, scanned by hand into one canonical
spelling.

No regular expression: one with nested optional parts can take minutes on a few thousand accents.
`\\dot x_{s k-1}`, `\\dot{x}_{sk-1}` and `\\dot{{x}}_{sk-1}` are one name, canonically
`\\dot{x}_{sk-1}`.
"""

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
from gainproof.verify.judge.reader.limits import MOST_NAME_CHARACTERS

_SUBSCRIPT_CHARACTERS = frozenset("+-,()'*.=/_")
_MOST_ACCENTS = 6


def scan_base(text: str, position: int, accents: int = 0) -> tuple[str, int] | None:
    """One accented or plain letter at `position` as (canonical text, end), or None where no symbol
    begins.
    """
    if position < len(text) and is_letter(text[position]):
        return text[position], position + 1
    if position >= len(text) or text[position] != "\\":
        return None
    command = command_at(text, position)
    end = position + len(command)
    if command in GREEK:
        return command, end
    if command not in ACCENTS:
        return None
    if accents >= _MOST_ACCENTS:
        raise ReaderError(
            f"more than {_MOST_ACCENTS} accents on one symbol", text, position, command
        )
    inner, end = _accent_argument(text, skip_space(text, end), command, accents)
    return f"{command}{{{inner}}}", end


def _accent_argument(text: str, position: int, command: str, accents: int) -> tuple[str, int]:
    if text[position : position + 1] != "{":
        found = scan_base(text, position, accents + 1)
        if found is None:
            raise ReaderError(
                f"{command} needs a letter", text, position, text[position : position + 1]
            )
        return found
    opening = position
    while text[position : position + 1] == "{":
        position = skip_space(text, position + 1)
        if position - opening > MOST_NAME_CHARACTERS:
            raise ReaderError("a name is too long", text, opening, command)
    braces = text[opening:position].count("{")
    found = scan_word(text, position) or scan_base(text, position, accents + 1)
    if found is None:
        raise ReaderError(
            f"{command} needs a letter", text, position, text[position : position + 1]
        )
    inner, position = scan_decorations(text, *found)
    for _ in range(braces):
        position = skip_space(text, position)
        if text[position : position + 1] != "}":
            raise ReaderError(
                f"{command}{{...}} must hold one symbol",
                text,
                position,
                text[position : position + 1],
            )
        position += 1
    return inner, position


def scan_word(text: str, position: int) -> tuple[str, int] | None:
    """A run of Latin letters at `position`, or None."""
    end = position
    while end < len(text) and is_letter(text[end]):
        end += 1
    return (text[position:end], end) if end > position else None


def scan_decorations(text: str, base: str, position: int) -> tuple[str, int]:
    """Primes and a subscript after `base`, which ends at `position`, as (canonical name, end)."""
    primes, subscript, start = "", "", position
    while True:
        following = skip_space(text, position)
        character = text[following : following + 1]
        if character == "'":
            primes += "'"
            position = following + 1
        elif character == "_" and not subscript:
            subscript, position = scan_subscript(text, following + 1)
        else:
            break
        if position - start > MOST_NAME_CHARACTERS:
            raise ReaderError(f"a name of more than {MOST_NAME_CHARACTERS} characters", text, start)
    return base + primes + subscript, position


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
    inner, end = _braced(text, position)
    if not inner:
        raise ReaderError("an empty subscript", text, position, "{}")
    return (f"_{inner}" if len(inner) == 1 else f"_{{{inner}}}"), end


def _braced(text: str, opening: int) -> tuple[str, int]:
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
            if command not in GREEK | ACCENTS | {"\\infty", "\\text"}:
                raise ReaderError(f"{command} cannot stand in a subscript", text, position, command)
            pieces.append(command)
            position += len(command)
            continue
        elif character in BLANKS:
            position += 1
            continue
        elif not (
            character.isascii() and (character.isalnum() or character in _SUBSCRIPT_CHARACTERS)
        ):
            raise ReaderError(
                f"{character!r} cannot stand in a subscript", text, position, character
            )
        # a command and a letter after it stay two words
        blank = " " if pieces[-1].startswith("\\") and is_letter(character) else ""
        pieces.append(blank + character)
        position += 1
    raise ReaderError("a brace is never closed", text, opening, "{")


def canonical_token(text: str) -> str:
    """The canonical spelling of one declared symbol; ReaderError if `text` is not one symbol."""
    start = skip_space(text, 0)
    found = scan_word(text, start) or scan_base(text, start)
    if found is None:
        raise ReaderError(
            "a symbol begins with a letter, a Greek letter or an accent",
            text,
            start,
            text[start : start + 1],
        )
    name, end = scan_decorations(text, *found)
    end = skip_space(text, end)
    if end != len(text):
        raise ReaderError("more follows after the symbol", text, end, text[end : end + 1])
    if len(name) > MOST_NAME_CHARACTERS:
        raise ReaderError(f"a name of more than {MOST_NAME_CHARACTERS} characters", text, start)
    return name
