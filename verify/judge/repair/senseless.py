"""Parts that no source prints: a factor zero, a term against itself, a divisor that cancels. A
change that makes one is no misprint undone, however true the formula then is.
"""

from __future__ import annotations

from collections.abc import Iterator
from functools import lru_cache

from gainproof.verify.judge.exact.expression import Expr
from gainproof.verify.judge.repair.construct import ONE, places
from gainproof.verify.judge.repair.printed import Printed
from gainproof.verify.judge.repair.trivial import sorted_key

_NUMBER = b"a number"


def is_more_senseless(formula: Printed, than: Printed) -> bool:
    """Whether it has more such parts than the formula as printed."""
    return senseless_parts(formula) > senseless_parts(than)


def senseless_parts(formula: Printed) -> int:
    """How many parts of a formula nobody prints; a term on both sides of an equation is one."""
    inside = sum(_at_node(node) for side in formula.sides for _, node in places(side))
    across = sum(
        len(set(_terms(formula.sides[link.left])) & set(_terms(formula.sides[link.right])))
        for link in formula.links
        if link.operator == "=" and _is_sum(formula, link.left, link.right)
    )
    return inside + across


def _is_sum(formula: Printed, *sides: int) -> bool:
    return any(formula.sides[n].kind == "add" for n in sides)


@lru_cache(maxsize=1 << 15)  # the changes of one formula share nearly all of their parts
def _at_node(node: Expr) -> int:
    match node.kind:
        case "add":
            terms = list(_terms(node))
            return len(terms) - len(set(terms))
        case "mul":
            return sum(_is_zero(part) for part in node.parts)
        case "neg":
            return int(_is_zero(node.parts[0]))
        case "div":
            top, bottom = ({sorted_key(f) for f in _factors(part)} for part in node.parts)
            return int(_is_zero(node.parts[0])) + len(top & bottom)
        case "pow":
            (base,) = node.parts
            undone = base.kind == "pow" and base.fraction * node.fraction == 1
            return int(node.fraction == 0 or undone or _is_zero(base) or base == ONE)
        case "call" if node.name == "power":
            base, exponent = node.parts
            return int(_is_zero(base) or base == ONE or _is_zero(exponent))
        case "derivative" | "at":
            last = node.parts[-1]
            return int(last.kind == "symbol" and last.name == node.name)
        case _:
            return 0


def _is_zero(expr: Expr) -> bool:
    return expr.kind == "number" and expr.value == 0


def _terms(side: Expr) -> Iterator[bytes]:
    """Keys of the terms without their numbers: those of x and -2 x/3 are the same."""
    for term in side.parts if side.kind == "add" else (side,):
        yield _without_number(term)


def _without_number(term: Expr) -> bytes:
    if term.kind == "number":
        return _NUMBER
    if term.kind == "neg":
        return _without_number(term.parts[0])
    if term.kind == "div" and term.parts[1].kind == "number":
        return _without_number(term.parts[0])
    if term.kind == "mul":
        kept = [part for part in term.parts if part.kind != "number"]
        if len(kept) == 1:
            return _without_number(kept[0])
        if not kept:
            return _NUMBER
        return sorted_key(Expr("mul", None, tuple(kept)))
    return sorted_key(term)


def _factors(expr: Expr) -> Iterator[Expr]:
    if expr.kind == "neg":
        yield from _factors(expr.parts[0])
    elif expr.kind == "mul":
        for part in expr.parts:
            yield from _factors(part)
    elif expr != ONE:
        yield expr
