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
    for (before, _), (token, following) in pairwise(inner):
        if before.kind not in _ENDS or token.start == before.end:
            continue
        signed = token.kind in ("PLUS", "MINUS") and following == token.end
        if signed or token.kind in _BEGINS:
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


def rows_of_lists(
    text: str, tokens: Sequence[FormulaToken], opening: int
) -> list[FormulaToken] | None:
    """The tokens of `[[a, b], [c, d]` as those of `[a, b; c, d`; None where the bracket `opening`
    does not hold brackets alone, several of them with commas between. ReaderError for lists beside
    other entries.
    """
    parts: list[list[FormulaToken]] = [[]]
    depth = 0
    for token in tokens[opening + 1 :]:
        depth += (token.kind in _OPENING) - (token.kind in _CLOSING)
        if token.kind == "COMMA" and depth == 0:
            parts.append([])
        else:
            parts[-1].append(
                replace(token, kind="CELL") if token.kind == "COMMA" and depth == 1 else token
            )
    lists = [_is_list(part) for part in parts]
    if len(parts) == 1 or not any(lists):
        return None
    if not all(lists):
        if any(
            each and any(t.kind == "CELL" for t in part)
            for each, part in zip(lists, parts, strict=True)
        ):
            problem = "lists beside other entries: rows of a matrix are all lists"
            raise ReaderError(problem, text, tokens[opening].start, "[")
        return None
    found = [replace(tokens[opening], kind="MATRIX_OPEN", value="matrix")]
    for part in parts:
        if len(found) > 1:
            found.append(replace(part[0], kind="LINE", value=";", end=part[0].start))
        found += part[1:-1]
    return found


def _is_list(part: Sequence[FormulaToken]) -> bool:
    """Whether it is one pair of square brackets with what is between."""
    if len(part) < 3 or part[0].kind != "OPEN" or part[0].value != "[" or part[-1].kind != "CLOSE":
        return False
    depth = 0
    for number, token in enumerate(part):
        depth += (token.kind in _OPENING) - (token.kind in _CLOSING)
        if depth == 0:
            return number == len(part) - 1
    return False
