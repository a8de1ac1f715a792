"""Tokens that need a look ahead: numbers, sized brackets, fractions with a partial derivative, the
word `and`.
"""

from __future__ import annotations

from collections.abc import Sequence
from typing import NamedTuple

from gainproof.verify.judge.reader.alphabet import command_at, skip_space
from gainproof.verify.judge.reader.errors import ReaderError
from gainproof.verify.judge.reader.limits import MOST_DIGITS
from gainproof.verify.judge.reader.tokens import COMMANDS, MARKS, FormulaToken

DIGITS = frozenset("0123456789")


class Scanned(NamedTuple):
    """Kind, canonical text and end of a token."""

    kind: str
    value: str
    end: int


def scan_number(text: str, start: int, single: bool) -> Scanned:
    """Digits with at most one point between them; one digit if `single`, as TeX takes it."""
    if single and text[start] in DIGITS:
        return Scanned("NUMBER", text[start], start + 1)
    end = start
    while end < len(text) and (text[end] in DIGITS or text[end] == "."):
        end += 1
    value = text[start:end]
    if value.count(".") > 1 or value[0] == "." or value[-1] == ".":
        problem = "a number needs digits on both sides of its one point"
        raise ReaderError(problem, text, start, value[:40])
    if len(value) > MOST_DIGITS:
        problem = f"a number of {len(value)} digits, but at most {MOST_DIGITS} are read"
        raise ReaderError(problem, text, start, value[:40])
    return Scanned("NUMBER", value, end)


def scan_sized(text: str, start: int, command: str) -> Scanned:
    """`\\left(` and the like: the size says nothing, except that bars get a direction."""
    bracket = skip_space(text, start + len(command))
    mark = text[bracket : bracket + 1]
    mark = command_at(text, bracket) if mark == "\\" else mark
    end = bracket + len(mark)
    sides = {"\\left": "OPEN", "\\right": "CLOSE"}
    if mark == "|" and command in sides:
        return Scanned(f"BAR_{sides[command]}", "|", end)
    kind, value = MARKS.get(mark) or COMMANDS.get(mark) or ("", "")
    if kind not in ("OPEN", "CLOSE", "BAR_OPEN", "BAR_CLOSE"):
        raise ReaderError(f"{command} needs a bracket after it", text, start, command + mark)
    if command in sides and not kind.endswith(sides[command]):
        problem = f"{command} stands before the wrong side of a bracket"
        raise ReaderError(problem, text, start, command + mark)
    return Scanned(kind, value, end)


def scan_mark(text: str, start: int, before: Sequence[FormulaToken]) -> Scanned:
    """An operator or a bracket of one or two characters; square brackets after a root hold its
    index.
    """
    for length in (2, 1):
        mark = text[start : start + length]
        if mark in MARKS:
            kind, value = MARKS[mark]
            if value == "[" and before and before[-1].kind == "SQRT":
                kind = "ROOT_OPEN"
            elif value == "]" and len(before) > 1 and before[-2].kind == "ROOT_OPEN":
                kind = "ROOT_CLOSE"
            return Scanned(kind, value, start + len(mark))
    character = text[start]
    problems = {
        "_": "this subscript belongs to no symbol",
        "|": "a bar may mean two things: write \\left| x \\right| or \\lvert x \\rvert",
    }
    problem = problems.get(character, f"the character {character!r} has no meaning here")
    raise ReaderError(problem, text, start, character)


def fraction_kind(text: str, end: int) -> str:
    """What begins with the `\\frac` that ends at `end`: a quotient, `\\frac{\\partial}{...}`, which
    acts on what follows, or `\\frac{\\partial x}{...}`.
    """
    brace = skip_space(text, end)
    inner = skip_space(text, brace + 1)
    if text[brace : brace + 1] != "{" or command_at(text, inner) != "\\partial":
        return "FRAC"
    closing = skip_space(text, inner + len("\\partial"))
    return "PARTIAL_OPERATOR" if text[closing : closing + 1] == "}" else "FRAC_PARTIAL"


def end_of_and(text: str, start: int) -> int | None:
    """The end of `{and}` at `start`, or None if something else stands there."""
    closing = text.find("}", start, start + 20)
    if closing > 0 and text[start:closing].replace(" ", "") == "{and":
        return closing + 1
    return None
