"""Tokens that need a look ahead: numbers, sized brackets, what ends a line, words in text."""

from __future__ import annotations

from collections.abc import Sequence
from typing import NamedTuple

from gainproof.verify.judge.reader.alphabet import DIGITS, command_at, skip_space
from gainproof.verify.judge.reader.errors import ReaderError
from gainproof.verify.judge.reader.formula_limits import MOST_DIGITS
from gainproof.verify.judge.reader.line_end import ends_line
from gainproof.verify.judge.reader.tokens import COMMANDS, MARKS, NORM, FormulaToken
from gainproof.verify.judge.reader.words import JOINING_WORDS

MOST_SHOWN = 40
"""Characters of a number or word that a message repeats."""
_BARS = frozenset(("|", "\\mid", "\\vert", "\\rvert"))
NORM_BARS = frozenset(("\\|", "\\Vert"))


NO_ALTERNATIVES = "conditions hold together; `or` is not read: make a claim for each"


def unread(word: str) -> str:
    """What is said of a function that is known and not read."""
    return f"{word}(...) is no function that is read: write its formula, or {word}*(...)"


class Scanned(NamedTuple):
    """Kind, canonical text and end of a token."""

    kind: str
    value: str
    end: int


def scan_number(text: str, start: int, single: bool) -> Scanned:
    """Digits with at most one point between them; one digit if `single`, as TeX takes it. A point
    that ends the formula or the line is none of the number.
    """
    if single and text[start] in DIGITS:
        return Scanned("NUMBER", text[start], start + 1)
    end = start
    while end < len(text) and (text[end] in DIGITS or text[end] == "."):
        if text[end] == "." and text[end + 1 : end + 2] not in DIGITS and ends_line(text, end):
            break
        end += 1
    value = text[start:end]
    if not value or value.count(".") > 1 or value[0] == "." or value[-1] == ".":
        problem = "a number needs digits on both sides of its one point"
        whole, point, decimals = value.partition(".")
        if point and (whole or decimals) and "." not in decimals and len(value) <= MOST_SHOWN:
            problem += f": write {whole or '0'}{point + decimals if decimals else ''}"
        raise ReaderError(problem, text, start, value[:MOST_SHOWN])
    if len(value) > MOST_DIGITS:
        problem = f"a number of {len(value)} digits, but at most {MOST_DIGITS} are read"
        raise ReaderError(problem, text, start, value[:MOST_SHOWN])
    return Scanned("NUMBER", value, end)


def scan_sized(text: str, start: int, command: str) -> Scanned:
    """`\\left(` and the like: the size says nothing, except that bars get a direction."""
    bracket = skip_space(text, start + len(command))
    mark = text[bracket : bracket + 1]
    mark = command_at(text, bracket) if mark == "\\" else mark
    end = bracket + len(mark)
    sides = {"\\left": "OPEN", "\\right": "CLOSE"}
    if mark == "." and command == "\\left":
        return Scanned("EMPTY_OPEN", ".", end)
    if mark in (*_BARS, *NORM_BARS) and command in sides:
        return Scanned(f"BAR_{sides[command]}", "|" if mark in _BARS else NORM, end)
    if mark in _BARS and (under := evaluation_end(text, bracket, mark)) is not None:
        return Scanned("AT", "|_", under)
    kind, value = MARKS.get(mark) or COMMANDS.get(mark) or ("", "")
    if kind not in ("OPEN", "CLOSE", "BAR_OPEN", "BAR_CLOSE"):
        raise ReaderError(f"{command} needs a bracket after it", text, start, command + mark)
    if command in sides and not kind.endswith(sides[command]):
        problem = f"{command} stands before the wrong side of a bracket"
        raise ReaderError(problem, text, start, command + mark)
    return Scanned(kind, value, end)


def evaluation_end(text: str, position: int, mark: str) -> int | None:
    """The end of the `_` after the bar `mark` at `position`, or None where none follows."""
    under = skip_space(text, position + len(mark))
    return under + 1 if text[under : under + 1] == "_" else None


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
    if character == "|":
        end = evaluation_end(text, start, "|")
        if end is not None:
            return Scanned("AT", "|_", end)
        problem = "a bar may mean two things: write \\left| x \\right| or \\lvert x \\rvert"
        raise ReaderError(problem, text, start, character)
    raise ReaderError(f"the character {character!r} has no meaning here", text, start, character)


def scan_norm(end: int, before: Sequence[FormulaToken]) -> Scanned:
    """A bar of a norm without direction, by turns the first and the last one."""
    bars = [token.kind for token in before if token.value == NORM]
    is_open = bars.count("BAR_OPEN") > bars.count("BAR_CLOSE")
    return Scanned("BAR_CLOSE" if is_open else "BAR_OPEN", NORM, end)


def scan_bar(text: str, start: int, command: str) -> Scanned:
    """`\\mid_{x=0}` and the like. ReaderError where no subscript says where."""
    end = evaluation_end(text, start, command)
    if end is None:
        problem = f"{command} needs a subscript that says where"
        raise ReaderError(problem, text, start, command)
    return Scanned("AT", "|_", end)


def is_or(text: str, start: int) -> bool:
    """Whether `{or}` stands at `start`."""
    closing = text.find("}", start, start + 20)
    return text[start : start + 1] == "{" and text[start + 1 : closing].strip(" ~,.") == "or"


def joining_word(text: str, start: int) -> Scanned | None:
    """What joins statements in `{and}` at `start`, or None if something else stands there."""
    closing = text.find("}", start, start + 20)
    word = text[start + 1 : max(closing, start + 1)].strip(" ~,.")
    if text[start : start + 1] != "{" or word not in JOINING_WORDS:
        return None
    return Scanned(*JOINING_WORDS[word], closing + 1)
