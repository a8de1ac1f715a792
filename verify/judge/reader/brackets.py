"""Brackets paired before parsing: kinds must match, depth is counted, parentheses that hold a
relation are marked.
"""

from __future__ import annotations

from collections.abc import Sequence
from dataclasses import replace

from gainproof.verify.judge.reader.errors import ReaderError
from gainproof.verify.judge.reader.limits import MOST_DEPTH
from gainproof.verify.judge.reader.tokens import FormulaToken

_OPENING = {
    "OPEN": "CLOSE",
    "LEFT_BRACE": "RIGHT_BRACE",
    "BAR_OPEN": "BAR_CLOSE",
    "ROOT_OPEN": "ROOT_CLOSE",
}
_CLOSING = frozenset(_OPENING.values())
_PARTNER = {"(": ")", "[": "]", "{": "}", "|": "|"}
_RELATIONS = frozenset(("EQUAL", "RELATION"))


def pair_brackets(text: str, tokens: Sequence[FormulaToken]) -> tuple[FormulaToken, ...]:
    """The tokens again, `OPEN` and `CLOSE` become `CONDITION_OPEN` and `CONDITION_CLOSE` where a
    relation stands directly between them.
    """
    result = list(tokens)
    stack: list[int] = []
    holds_relation: set[int] = set()
    prefixes = 0
    for number, token in enumerate(tokens):
        prefixes += token.kind in ("SUM", "PARTIAL_OPERATOR")
        if prefixes > MOST_DEPTH:
            problem = f"more than {MOST_DEPTH} sums and derivatives, which nest"
            raise ReaderError(problem, text, token.start, token.value)
        if token.kind in _OPENING:
            stack.append(number)
            if len(stack) > MOST_DEPTH:
                raise ReaderError(
                    f"brackets more than {MOST_DEPTH} deep", text, token.start, token.value
                )
        elif token.kind in _CLOSING:
            if not stack:
                raise ReaderError(
                    f"the bracket {token.value} was never opened", text, token.start, token.value
                )
            opening = stack.pop()
            _check_pair(text, tokens[opening], token)
            if opening in holds_relation and token.kind == "CLOSE":
                result[opening] = replace(tokens[opening], kind="CONDITION_OPEN")
                result[number] = replace(token, kind="CONDITION_CLOSE")
        elif token.kind in _RELATIONS and stack:
            holds_relation.add(stack[-1])
    if stack:
        token = tokens[stack[-1]]
        raise ReaderError(
            f"the bracket {token.value} is never closed", text, token.start, token.value
        )
    return tuple(result)


def _check_pair(text: str, opening: FormulaToken, closing: FormulaToken) -> None:
    if _OPENING[opening.kind] != closing.kind or _PARTNER[opening.value] != closing.value:
        column = opening.start - (text.rfind("\n", 0, opening.start) + 1) + 1
        problem = (
            f"the bracket {opening.value} of column {column} cannot be closed by {closing.value}"
        )
        raise ReaderError(problem, text, closing.start, closing.value)
