"""Wide spaces: `a = b \\quad c = d` is two relations, not one with a product in its middle."""

from __future__ import annotations

from collections.abc import Sequence
from dataclasses import replace

from gainproof.verify.judge.reader.tokens import FormulaToken

_SEPARATES = frozenset(("COMMA", "AND", "CONNECTIVE"))
_OPENS = frozenset(("OPEN", "CONDITION_OPEN", "LEFT_BRACE", "BAR_OPEN", "ROOT_OPEN"))
_CLOSES = frozenset(("CLOSE", "CONDITION_CLOSE", "RIGHT_BRACE", "BAR_CLOSE", "ROOT_CLOSE"))


def settle_wide_spaces(tokens: Sequence[FormulaToken]) -> tuple[FormulaToken, ...]:
    """A wide space beside a separator, before a condition or at an edge says nothing; any other
    joins two statements as `and` does, so that within an expression it is an error.
    """
    result: list[FormulaToken] = []
    pending: FormulaToken | None = None
    for token in tokens:
        if token.kind == "WIDE":
            pending = token
            continue
        if pending is not None and result and not _is_idle(result[-1].kind, token.kind):
            result.append(replace(pending, kind="AND"))
        pending = None
        result.append(token)
    return tuple(result)


def _is_idle(before: str, after: str) -> bool:
    return (
        before in _SEPARATES | _OPENS or after in _SEPARATES | _CLOSES or after == "CONDITION_OPEN"
    )
