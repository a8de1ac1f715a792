"""Parts that no source prints: a factor zero, a term against itself, a divisor that cancels, one
factor on both sides. A change that makes one is no misprint undone, however true the formula then
is.
"""

from __future__ import annotations

from collections.abc import Iterator
from fractions import Fraction
from functools import lru_cache

from gainproof.verify.judge.exact.expression import Expr, symbols_of, walk
from gainproof.verify.judge.repair.expansion import Terms, added, expanded
from gainproof.verify.judge.repair.printed_formula import Printed
from gainproof.verify.judge.repair.tree_construction import ONE, places
from gainproof.verify.judge.repair.trivial_formulas import sorted_key

_NUMBER = b"a number"


def is_more_senseless(formula: Printed, than: Printed) -> bool:
    """Whether it has more such parts than the formula as printed, or something put in that cancels
    a term, or a factor that stands on both sides.
    """
    if senseless_parts(formula) > senseless_parts(than):
        return True
    if _solved_for(formula) - _solved_for(than):
        return True
    # a sign changed in (a + b)^2 + (a - b)^2 cancels terms too, and may well be meant
    if _leaves(formula) > _leaves(than) and _undone(formula) > _undone(than):
        return True
    if _shared_factors(formula) <= _shared_factors(than):
        return False
    # a factor that another one was exchanged for may well stand on both sides
    return _number_of_factors(formula) > _number_of_factors(than)


def _solved_for(formula: Printed) -> frozenset[str]:
    """Symbols that are the left side of an equation and stand on the right too: what is said of a
    symbol does not hold it.
    """
    pairs = [
        (formula.sides[x.left], formula.sides[x.right]) for x in formula.links if x.operator == "="
    ]
    lone = [(a.name, b) for a, b in pairs if a.kind == "symbol" and b.kind != "symbol"]
    return frozenset(name for name, other in lone if name in symbols_of(other))


def senseless_parts(formula: Printed) -> int:
    """How many parts of a formula nobody prints; a term on both sides of an equation is one."""
    inside = sum(_at_node(node) for side in formula.sides for _, node in places(side))
    across = sum(
        _shared_terms(formula.sides[link.left], formula.sides[link.right])
        for link in formula.links
        if link.operator == "="
    )
    return inside + across


def lacks_more(formula: Printed, than: Printed) -> bool:
    """Whether something stands under a fraction bar, an even root or a logarithm that does not in
    the other: the values that one part lacks are no better lacking in another.
    """
    return not _may_lack(formula) <= _may_lack(than)


def _may_lack(formula: Printed) -> frozenset[bytes]:
    found = set()
    for node in walk(*formula.sides):
        if node.kind == "div":
            found |= {key for key, above in powers_of(node.parts[1]) if above}
            continue
        is_root = node.kind == "pow" and (node.fraction < 0 or node.fraction.denominator % 2 == 0)
        if is_root or (node.kind == "call" and node.name in ("log", "ln")):
            found.add(sorted_key(node.parts[0]))
    return frozenset(found)


def _undone(formula: Printed) -> int:
    """How many terms of sums the other terms take away again, when multiplied out."""
    return sum(
        _is_undone(expanded(term), added(expanded(t) for j, t in enumerate(node.parts) if j != k))
        for side in formula.sides
        for _, node in places(side)
        if node.kind == "add"
        for k, term in enumerate(node.parts)
    )


def _is_undone(term: Terms, others: Terms) -> bool:
    """Whether each part of a term stands in the others with the other sign, of any size."""
    return all(size * others.get(monomial, 0) < 0 for monomial, size in term.items())


def _leaves(formula: Printed) -> int:
    return sum(not node.parts for side in formula.sides for _, node in places(side))


def _shared_factors(formula: Printed) -> int:
    """How many factors both sides of an equation have above or both below their fraction bars."""
    return sum(
        len(set(powers_of(formula.sides[link.left])) & set(powers_of(formula.sides[link.right])))
        for link in formula.links
        if link.operator == "="
    )


def _number_of_factors(formula: Printed) -> int:
    return sum(len(list(powers_of(formula.sides[n]))) for n in formula.claimed())


def powers_of(expr: Expr, above: bool = True) -> Iterator[tuple[bytes, bool]]:
    """The bases of a product or quotient that are no numbers, each with whether it stands above."""
    match expr.kind:
        case "number":
            return
        case "neg" | "mul":
            for part in expr.parts:
                yield from powers_of(part, above)
        case "div":
            yield from powers_of(expr.parts[0], above)
            yield from powers_of(expr.parts[1], not above)
        case "pow" if expr.fraction.denominator == 1:
            yield from powers_of(expr.parts[0], above == (expr.fraction > 0))
        case _:
            yield sorted_key(expr), above


def _shared_terms(left: Expr, right: Expr) -> int:
    """How many terms both sides have, of which one is a sum; one divisor of both left out."""
    if left.kind == right.kind == "div" and left.parts[1] == right.parts[1]:
        left, right = left.parts[0], right.parts[0]
    if "add" not in (left.kind, right.kind):
        return 0
    return len(set(_terms(left)) & set(_terms(right)))


@lru_cache(maxsize=1 << 15)  # the changes of one formula share nearly all of their parts
def _at_node(node: Expr) -> int:
    match node.kind:
        case "add":
            terms = list(_terms(node))
            return len(terms) - len(set(terms))
        case "mul":
            return sum(_is_zero(part) for part in node.parts) + _cancelling(node)
        case "neg":
            return int(_is_zero(node.parts[0]))
        case "div":
            top, bottom = (set(_numbers(part)) for part in node.parts)
            return int(_is_zero(node.parts[0])) + len(top & bottom) + _cancelling(node)
        case "pow":
            (base,) = node.parts
            inner = base.fraction if base.kind == "pow" else Fraction(0)
            both_whole = inner != 0 and inner.denominator == node.fraction.denominator == 1
            undone = both_whole or inner * node.fraction == 1
            return int(node.fraction == 0 or undone or _is_zero(base) or base == ONE)
        case "call" if node.name == "power":
            base, exponent = node.parts
            return int(_is_zero(base) or ONE in (base, exponent) or _is_zero(exponent))
        case "derivative" | "at":
            last = node.parts[-1]
            return int(last.kind == "symbol" and last.name == node.name)
        case _:
            return 0


def _cancelling(node: Expr) -> int:
    """How many bases stand both above and below."""
    found = set(powers_of(node))
    return sum((key, False) in found for key, above in found if above)


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


def _numbers(expr: Expr) -> Iterator[Fraction]:
    """The factors that are numbers, 1 apart."""
    if expr.kind in ("neg", "mul"):
        for part in expr.parts:
            yield from _numbers(part)
    elif expr.kind == "number" and expr != ONE:
        yield expr.fraction
