"""Lines and wide spaces: whether what follows is another statement or goes on with this one."""

from __future__ import annotations

from collections.abc import Sequence
from dataclasses import replace
from itertools import pairwise

from gainproof.verify.judge.reader.brackets import Pairing
from gainproof.verify.judge.reader.errors import ReaderError
from gainproof.verify.judge.reader.tokens import FormulaToken

_SEPARATES = frozenset(("COMMA", "AND", "CONNECTIVE", "IF"))
_OPENS = frozenset(
    ("OPEN", "CONDITION_OPEN", "LEFT_BRACE", "OVER_OPEN", "BAR_OPEN", "ROOT_OPEN", "EMPTY_OPEN")
)
_CLOSES = frozenset(
    ("CLOSE", "CONDITION_CLOSE", "RIGHT_BRACE", "OVER_CLOSE", "BAR_CLOSE", "ROOT_CLOSE")
)
_RELATIONS = frozenset(("EQUAL", "RELATION"))
_GOES_ON = (
    _RELATIONS
    | {"PLUS", "DOT", "DOT_BEFORE_BIG", "SLASH", "KRON", "CONDITION_OPEN"}
    | (_SEPARATES - {"COMMA"})
)
"""What a line begins or ends with that goes on."""


def settle_lines(text: str, tokens: Sequence[FormulaToken], pairing: Pairing) -> list[FormulaToken]:
    """The tokens again without the marks `&` of aligned lines; the end of a line becomes `AND`
    where a new statement begins, and `NOTHING` where the one before goes on: with a relation, an
    operator or a condition. ReaderError where that is not clear.
    """
    result = list(tokens)
    outside = [number for number in range(len(tokens)) if pairing.inside[number] == -1]
    for place, number in enumerate(outside):
        token = result[number]
        if result[number].kind == "NOTHING":
            continue
        if token.kind == "CELL":
            result[number] = replace(token, kind="NOTHING")
        elif token.kind == "LINE":
            line = outside[place + 1 : _line_end(tokens, outside, place)]
            before = tokens[number - 1].kind if number else ""
            joint = _joint(before, [tokens[inner].kind for inner in line])
            if not joint:
                problem = (
                    "whether this line goes on with the one before is not clear: mark it with &"
                )
                raise ReaderError(problem, text, token.end, token.value)
            result[number] = replace(token, kind=joint)
            for inner in line if joint == "NOTHING" else ():
                if tokens[inner].kind not in ("WIDE", "CELL"):
                    break
                result[inner] = replace(tokens[inner], kind="NOTHING")
    for number, token in enumerate(result):
        if token.kind in ("GAP", "LINE"):
            result[number] = replace(token, kind="NOTHING" if token.kind == "GAP" else "AND")
    return result


def _line_end(tokens: Sequence[FormulaToken], outside: Sequence[int], place: int) -> int:
    """The place among the tokens outside brackets where the line after that place ends."""
    end = place + 1
    while end < len(outside) and tokens[outside[end]].kind != "LINE":
        end += 1
    return end


def _joint(before: str, kinds: Sequence[str]) -> str:
    """`AND` where the line with these tokens is another statement, `NOTHING` where it goes on,
    empty where nobody can tell.
    """
    words = [kind for kind in kinds if kind not in ("CELL", "WIDE", "GAP")]
    if not words or words[0] in _GOES_ON or before in _GOES_ON | {"MINUS"}:
        return "NOTHING"
    is_marked = kinds[0] == "CELL"
    has_relation = any(kind in _RELATIONS for kind in words)
    if words[0] == "MINUS" and (is_marked or not has_relation):
        return "NOTHING"
    marks_relation = any(
        kind == "CELL" and following in _RELATIONS for kind, following in pairwise(kinds)
    )
    return "AND" if has_relation and (words[0] != "MINUS" or marks_relation) else ""


def settle_wide_spaces(tokens: Sequence[FormulaToken]) -> list[FormulaToken]:
    """A wide space beside a separator, before a condition or at an edge says nothing; any other
    joins two statements as `and` does, so that within an expression it is an error.
    """
    result: list[FormulaToken] = []
    pending: FormulaToken | None = None
    for token in tokens:
        if token.kind == "NOTHING":
            continue
        if token.kind == "WIDE":
            pending = token
            continue
        if pending is not None and result and not _is_idle(result[-1].kind, token.kind):
            result.append(replace(pending, kind="AND"))
        pending = None
        if token.kind == "AND" and result and result[-1].kind in ("COMMA", "AND"):
            # `, and` and a comma at the end of a line are one separator
            result.pop()
        result.append(token)
    return result


def _is_idle(before: str, after: str) -> bool:
    return (
        before in _SEPARATES | _OPENS or after in _SEPARATES | _CLOSES or after == "CONDITION_OPEN"
    )
