"""Characters that a claim file may not hold, as they are or as escapes of TOML."""

from __future__ import annotations

import re
import unicodedata
from collections.abc import Mapping

from gainproof.verify.judge.claim.errors import ClaimFileError

MOST_LINE = 8000
"""Characters of one line, which holds one formula at most."""
MOST_DOTS = 200
"""Dots in one line: the keys of TOML nest at dots, and reading them takes time that grows with the
square.
"""
ESCAPED = re.compile(
    r"""\s*(latex|plain|domain|definition|given|hint|invertible|recursion)\s*=\s*\[?\s*"""
    r""""[^"\\]*(\\\\[^"\\]*)*(?P<escape>\\[btnfr])(?=[A-Za-z])"""
)
"""A formula in double quotes with an escape that begins the name of a command."""


def refuse_characters(text: str, path: str) -> None:
    """Invisible and directional characters could make a file look like another."""
    for number, line in enumerate(text.split("\n"), start=1):
        if len(line) > MOST_LINE:
            raise ClaimFileError(path, "", f"more than {MOST_LINE} characters in a line", number)
        if line.count(".") > MOST_DOTS:
            raise ClaimFileError(path, "", f"more than {MOST_DOTS} dots in a line", number)
        for column, character in enumerate(line, start=1):
            problem = _invisible(character)
            if problem is not None:
                raise ClaimFileError(path, "", problem, number, column)


def refuse_escaped_latex(text: str, path: str) -> None:
    """LaTeX in double quotes, of which TOML makes something else without a word: \\beta is a
    backspace and `eta`.
    """
    for number, line in enumerate(text.split("\n"), start=1):
        found = ESCAPED.match(line)
        if found is not None:
            escape = found.group("escape")
            problem = (
                f"in double quotes {escape} is an escape of TOML; LaTeX stands in single quotes"
            )
            raise ClaimFileError(path, "", problem, number, found.start("escape") + 1)


def refuse_escapes(value: object, path: str) -> None:
    """The same characters as escapes of TOML: they would reach a terminal as they are."""
    if isinstance(value, str):
        problem = next((p for c in value if c != "\n" and (p := _invisible(c))), None)
        if problem is not None:
            raise ClaimFileError(path, "", f"{problem}, written as an escape")
    elif isinstance(value, Mapping):
        for key, inner in value.items():
            refuse_escapes(key, path)
            refuse_escapes(inner, path)
    elif isinstance(value, list):
        for inner in value:
            refuse_escapes(inner, path)


def _invisible(character: str) -> str | None:
    """What is wrong with a character, if it cannot be seen."""
    if character.isascii() and (character.isprintable() or character == "\t"):
        return None
    if unicodedata.category(character) not in ("Cc", "Cf", "Cn", "Co", "Cs", "Zl", "Zp"):
        return None
    name = unicodedata.name(character, "no name")
    return f"the invisible character U+{ord(character):04X} ({name})"
