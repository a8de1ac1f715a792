"""Nodes of cases: values with the conditions under which each counts."""

from __future__ import annotations

from typing import TYPE_CHECKING

from lark import Token

from gainproof.verify.judge.reader.tree import Branch, children, tokens
from gainproof.verify.judge.reader.words import OF_CASES

if TYPE_CHECKING:
    from gainproof.verify.judge.reader.build import Builder

MOST_CASES = 16
COMPARED = ("=", "!=", "<", "<=", ">", ">=")


def cases(builder: Builder, tree: Branch) -> int:
    """A call whose name says how its parts are compared: `cases >,<= -` has a value under two
    conditions, then one for all else; its parts are a value, four sides, a value.
    """
    lines = children(tree)
    if len(lines) > MOST_CASES:
        raise builder.error(f"more than {MOST_CASES} cases", tree)
    words: list[str] = []
    parts: list[int] = []
    for line in lines:
        value, *conditions = children(line)
        if not conditions and line is not lines[-1]:
            raise builder.error("a value for all else, before the last one", value)
        if not conditions and tokens(line, "CELL") and not tokens(line, "OTHERWISE"):
            raise builder.error("a condition is missing: write \\text{otherwise}", value)
        parts.append(builder.value(value))
        operators: list[str] = []
        for chain in children(conditions[0]) if conditions else ():
            sides = children(chain)
            signs = [child for child in chain.children if isinstance(child, Token)]
            for left, sign, right in zip(sides, signs, sides[1:], strict=False):
                inner = [children(side)[0] for side in (left, right)]
                if str(sign) not in COMPARED or any(
                    side.data in ("infinity", "limit") for side in inner
                ):
                    raise builder.error("a condition of a case is to compare numbers", chain)
                operators.append(str(sign))
                parts += map(builder.value, inner)
        words.append(",".join(operators) or "-")
    if words == ["-"]:
        raise builder.error("cases without a condition", tree)
    return builder.nodes.add("call", f"{OF_CASES}{' '.join(words)}", *parts)
