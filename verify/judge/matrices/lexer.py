"""Tokens of a formula of matrices."""

from __future__ import annotations

import re
from collections.abc import Collection
from dataclasses import dataclass, replace
from fractions import Fraction

from gainproof.verify.judge.matrices.notation import (
    ARROWS,
    COVERED,
    MATRICES,
    POWERS,
    RELATIONS,
    SILENT,
    TIMES,
    WIDE,
    WORD,
)
from gainproof.verify.judge.matrices.printed_names import (
    SQUARE,
    scan_subscript,
    scan_symbol,
    skip_blanks,
    square_at,
    with_subscript,
)
from gainproof.verify.judge.matrices.size import Shape, Sizes
from gainproof.verify.judge.matrices.size_text import read_size
from gainproof.verify.judge.reader.alphabet import command_at
from gainproof.verify.judge.reader.errors import ReaderError, nearest_names
from gainproof.verify.judge.reader.formula_limits import MOST_CHARACTERS, MOST_DIGITS

MOST_TOKENS = 1500
# 0 with accents and no more: what has a subscript besides is a letter of its own
_ZERO = re.compile(r"(?:\\[a-z]+\{)+0\}+", re.ASCII)


@dataclass(frozen=True)
class Token:
    """`kind`: name, number, unit, zero, power, relation, arrow, begin, end, expect, wide, or the
    character itself. `value` is its text; sizes of units and zeros are in `shape`. It ends before
    the place `end`.
    """

    kind: str
    position: int
    value: str = ""
    number: Fraction = Fraction(0)
    shape: Shape | None = None
    end: int = 0


def tokens_of(text: str, letters: Collection[str], sizes: Sizes) -> list[Token]:
    """All tokens. Raises ReaderError for what is not known."""
    if len(text) > MOST_CHARACTERS:
        raise ReaderError(f"more than {MOST_CHARACTERS} characters", text[:100], 0)
    found: list[Token] = []
    position = skip_blanks(text, 0)
    while position < len(text):
        token, position = _token(text, position, letters, sizes)
        if token is not None:
            found.append(replace(token, end=position))
        if len(found) > MOST_TOKENS:
            raise ReaderError(f"more than {MOST_TOKENS} signs", text, position)
        position = skip_blanks(text, position)
    return found


def _token(
    text: str, position: int, letters: Collection[str], sizes: Sizes
) -> tuple[Token | None, int]:
    character = text[position]
    command = command_at(text, position) if character == "\\" else character
    after = position + len(command)
    if command in RELATIONS:
        return Token("relation", position, RELATIONS[command]), after
    if command in ("\\ne", "\\neq"):
        return Token("unequal", position), after
    if command == "\\det":
        return Token("det", position), after
    if command in ARROWS:
        return Token("arrow", position, ARROWS[command]), after
    if command in WIDE:
        return Token("wide", position), after
    if command in SILENT or command in TIMES:
        return None, after
    if command == "\\\\":
        return Token("row", position), after
    if command in ("\\begin", "\\end"):
        return _environment(text, position, command)
    if command == "\\frac":
        return _fraction(text, position)
    if command in ("\\text", "\\mbox") and text[after : after + 1] == "{":
        end = text.find("}", after)
        if text[after + 1 : end].strip() in ("and", ","):
            return Token(",", position), end + 1
    if character == "^":
        return _power(text, position)
    if character.isascii() and character.isdigit():
        return _number(text, position)
    if character in "+-()[],&{}":
        return Token(character, position), after
    return _symbol(text, position, letters, sizes)


def _environment(text: str, position: int, command: str) -> tuple[Token, int]:
    place = skip_blanks(text, position + len(command))
    for name in MATRICES:
        if text.startswith(name, place):
            end = place + len(name)
            if command == "\\begin" and name == "{array}":
                start = skip_blanks(text, end)
                end = text.find("}", start) + 1
                if text[start : start + 1] != "{" or not end:
                    raise ReaderError("an array says how its columns stand", text, start)
            return Token(command[1:], position, name), end
    raise ReaderError("a matrix is wanted: pmatrix, bmatrix, matrix or array", text, place)


def _fraction(text: str, position: int) -> tuple[Token, int]:
    place, values = position + len("\\frac"), []
    for _ in range(2):
        place = skip_blanks(text, place)
        end = text.find("}", place)
        inner = text[place + 1 : end] if text[place : place + 1] == "{" and end > 0 else ""
        if not (inner.isascii() and inner.isdigit() and len(inner) <= MOST_DIGITS):
            return Token("frac", position), position + len("\\frac")
        values.append(int(inner))
        place = end + 1
    if values[1] == 0:
        raise ReaderError("division by zero", text, position)
    return Token("number", position, number=Fraction(*values)), place


def _number(text: str, position: int) -> tuple[Token, int]:
    end = position
    while text[end : end + 1].isascii() and (text[end : end + 1].isdigit() or text[end] == "."):
        end += 1
        if end >= len(text):
            break
    digits = text[position:end]
    if digits.count(".") > 1 or digits.endswith(".") or len(digits) > MOST_DIGITS:
        raise ReaderError("not a number", text, position, digits[:20])
    return Token("number", position, number=Fraction(digits)), end


def _power(text: str, position: int) -> tuple[Token, int]:
    place = skip_blanks(text, position + 1)
    end = place + 1
    if text[place : place + 1] == "{":
        depth = 0
        for end in range(place, min(len(text), place + 20)):
            depth += {"{": 1, "}": -1}.get(text[end], 0)
            if depth == 0:
                break
        end += 1
    elif text[place : place + 1] == "\\":
        end = place + len(command := command_at(text, place))
        if command in ("\\mathsf", "\\mathrm") and text.startswith("{T}", end):
            end += len("{T}")
    inner = "".join(text[place:end].split())
    whole = inner.strip("{}")
    if whole in ("2", "3", "4"):
        return Token("power", position, whole), end
    if inner not in POWERS:
        raise ReaderError("a power of a matrix is ^T, ^{-1}, ^2, ^3 or ^4", text, place, inner)
    return Token("power", position, POWERS[inner]), end


def _symbol(text: str, position: int, letters: Collection[str], sizes: Sizes) -> tuple[Token, int]:
    word = WORD.match(text, position)
    if word is not None:
        name = word[1] or word[2]
        problem = f"{name} of a matrix is not covered: {COVERED}"
        raise ReaderError(problem, text, position, word[0])
    if text[position] == "|" or text.startswith("\\|", position):
        raise ReaderError(f"bars of a matrix are not covered: {COVERED}", text, position)
    found = scan_symbol(text, position)
    if found is None:
        raise ReaderError("this is not read here", text, position, text[position : position + 10])
    base, place = found
    subscript, end = scan_subscript(text, place)
    # X^T_l is the same letter as X_l^T
    powers = ""
    if not subscript and text[place : place + 1] == "^":
        token, after = _power(text, place)
        subscript, stop = scan_subscript(text, after)
        if subscript:
            powers, end = token.value, stop
    name = with_subscript(base, subscript) if subscript else base
    if powers:
        raise ReaderError(f"write {name}^{{{powers}}}, the subscript first", text, position, name)
    after = square_at(text, end)
    if after > end and name + SQUARE in letters:
        return Token("name", position, name + SQUARE), after
    if name in letters:
        return Token("name", position, name), end
    if base == "I" and subscript:
        size = read_size(subscript, sizes)
        return Token("unit", position, shape=(size, size)), end
    if base == "O" and "," in subscript:
        rows, _, columns = subscript.partition(",")
        shape = (read_size(rows, sizes), read_size(columns, sizes))
        return Token("zero", position, shape=shape), end
    if _ZERO.fullmatch(name):
        return Token("number", position), end
    if name == "E":
        return Token("expect", position), end
    if base in ("I", "\\mathbf{I}", "\\mathrm{I}", "\\boldsymbol{I}") and base == name:
        problem = f"the matrix {name} is not declared; the unit matrix has its size, as I_{{n}}"
        raise ReaderError(problem, text, position, name)
    near = nearest_names(name, letters)
    raise ReaderError(f"the matrix {name} is not declared", text, position, name, near)
