"""Brackets paired before parsing: kinds must match and depth is counted."""

from __future__ import annotations

from collections.abc import Sequence
from dataclasses import dataclass

from gainproof.verify.judge.reader.errors import ReaderError
from gainproof.verify.judge.reader.formula_limits import MOST_DEPTH
from gainproof.verify.judge.reader.tokens import FormulaToken

_OPENING = {
    "OPEN": ("CLOSE",),
    "LEFT_BRACE": ("RIGHT_BRACE",),
    "BAR_OPEN": ("BAR_CLOSE",),
    "EMPTY_OPEN": ("BAR_CLOSE",),
    "ROOT_OPEN": ("ROOT_CLOSE",),
    "MATRIX_OPEN": ("MATRIX_CLOSE",),
    "CASES_OPEN": ("CASES_CLOSE",),
}
_CLOSING = frozenset(kind for kinds in _OPENING.values() for kind in kinds)
_PARTNER = {"(": ")", "[": "]", "{": "}", "|": "|", ".": "|"}
_PREFIXES = frozenset(("SUM", "PARTIAL_OPERATOR", "LIM", "INTEGRAL", "NAMED"))


@dataclass(frozen=True)
class Pairing:
    """`closing` maps the number of each opening token to that of its partner; `inside` says for
    each token the number of the innermost bracket round it, -1 for none (a bracket is not inside
    itself); `directly` says for each bracket, and for -1, the kinds of tokens that stand in it
    and in no bracket within.
    """

    closing: dict[int, int]
    inside: tuple[int, ...]
    directly: dict[int, frozenset[str]]


def pair_brackets(text: str, tokens: Sequence[FormulaToken]) -> Pairing:
    """The pairs of brackets. ReaderError where they do not match or are too deep."""
    stack: list[int] = []
    closing: dict[int, int] = {}
    inside: list[int] = []
    directly: dict[int, set[str]] = {-1: set()}
    prefixes = 0
    for number, token in enumerate(tokens):
        prefixes += token.kind in _PREFIXES
        if prefixes > MOST_DEPTH:
            problem = f"more than {MOST_DEPTH} sums, derivatives and functions, which nest"
            raise ReaderError(problem, text, token.start, token.value)
        if token.kind in _CLOSING:
            if not stack:
                problem = f"the bracket {token.value} was never opened"
                raise ReaderError(problem, text, token.start, token.value)
            opening = stack.pop()
            _check_pair(text, tokens[opening], token)
            closing[opening] = number
        inside.append(stack[-1] if stack else -1)
        directly[inside[-1]].add(token.kind)
        if token.kind in _OPENING:
            stack.append(number)
            directly[number] = set()
            if len(stack) > MOST_DEPTH:
                problem = f"brackets more than {MOST_DEPTH} deep"
                raise ReaderError(problem, text, token.start, token.value)
    if stack:
        token = tokens[stack[-1]]
        problem = f"the bracket {token.value} is never closed"
        raise ReaderError(problem, text, token.start, token.value)
    kinds = {number: frozenset(found) for number, found in directly.items()}
    return Pairing(closing, tuple(inside), kinds)


def _check_pair(text: str, opening: FormulaToken, closing: FormulaToken) -> None:
    wanted = _PARTNER.get(opening.value, opening.value)
    if closing.kind not in _OPENING[opening.kind] or wanted != closing.value:
        column = opening.start - (text.rfind("\n", 0, opening.start) + 1) + 1
        problem = (
            f"the bracket {opening.value} of column {column} cannot be closed by {closing.value}"
        )
        raise ReaderError(problem, text, closing.start, closing.value)
