"""Square brackets in plain text: rows as Python writes them, entries that only a blank parts."""

from __future__ import annotations

from collections.abc import Sequence
from dataclasses import replace
from itertools import pairwise

from gainproof.verify.judge.reader.errors import ReaderError
from gainproof.verify.judge.reader.tokens import FormulaToken

_ENDS = ("SYMBOL", "NUMBER", "CONSTANT", "CLOSE", "RIGHT_BRACE", "MATRIX_CLOSE", "TRANSPOSE")
_BEGINS = ("SYMBOL", "NUMBER", "CONSTANT", "OPEN", "MATRIX_OPEN", "WORD", "SQRT")
_CALLS = ("EXPECT", "WORD", "NAMED", "FUNCTION", "SQRT", "ORDER", "EULER")
"""What a bracket behind belongs to: it holds an argument, no entries."""
_OPENING = ("OPEN", "MATRIX_OPEN", "CASES_OPEN", "LEFT_BRACE")
_CLOSING = ("CLOSE", "MATRIX_CLOSE", "CASES_CLOSE", "RIGHT_BRACE")


def require_entries_apart(text: str, tokens: Sequence[FormulaToken], opening: int) -> None:
    """ReaderError where only a blank parts two entries of the bracket that `opening` begins and the
    last of the `tokens` stands in, as in `[1 -2]` and `[a b; c d]`: MATLAB reads two, mathematics
    a difference or a product.
    """
    if opening and tokens[opening - 1].kind in _CALLS:
        return
    inner = _at_top(tokens, opening)
    has_entries = any(token.kind in ("COMMA", "LINE") for token, _ in inner)
    factors = not has_entries and all(token.kind in (*_ENDS, *_BEGINS) for token, _ in inner)
    for (before, _), (token, following) in pairwise(inner):
        if before.kind not in _ENDS or token.start == before.end:
            continue
        signed = token.kind in ("PLUS", "MINUS") and following == token.end
        product = token.kind in _BEGINS and (has_entries or factors)
        if signed or product:
            shown = text[before.start : following]
            asked = f"{token.value} with a blank on both sides" if signed else "a * for a product"
            problem = (
                f"a blank inside [ ] may part two entries: write a comma between them, or {asked}"
            )
            raise ReaderError(problem, text, token.start, shown[:20])


def _at_top(tokens: Sequence[FormulaToken], opening: int) -> list[tuple[FormulaToken, int]]:
    """The tokens behind `opening` that stand in no further bracket, its own marks besides, each
    with the place where the next token begins.
    """
    found: list[tuple[FormulaToken, int]] = []
    depth = 0
    for number in range(opening + 1, len(tokens)):
        token = tokens[number]
        depth -= token.kind in _CLOSING
        if depth == 0:
            after = tokens[number + 1].start if number + 1 < len(tokens) else -1
            found.append((token, after))
        depth += token.kind in _OPENING
    return found


def rows_of_lists(tokens: Sequence[FormulaToken], opening: int) -> list[FormulaToken] | None:
    """The tokens of `[[a, b], [c, d]` as those of `[a, b; c, d`; None where the bracket `opening`
    does not hold brackets alone, several of them with commas between.
    """
    found: list[FormulaToken] = [replace(tokens[opening], kind="MATRIX_OPEN", value="matrix")]
    depth = rows = 0
    for token in tokens[opening + 1 :]:
        if token.value == "[" and token.kind == "OPEN" and depth == 0:
            if rows and found[-1].kind != "LINE":
                return None
            depth, rows = 1, rows + 1
        elif depth == 0:
            if token.kind != "COMMA" or found[-1].kind == "LINE":
                return None
            found.append(replace(token, kind="LINE", value=";"))
        elif token.kind in _CLOSING and depth == 1:
            depth = 0
        else:
            depth += (token.kind in _OPENING) - (token.kind in _CLOSING)
            found.append(
                replace(token, kind="CELL") if token.kind == "COMMA" and depth == 1 else token
            )
    return found if rows > 1 and found[-1].kind != "LINE" else None
