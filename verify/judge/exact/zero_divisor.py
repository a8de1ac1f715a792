"""Exact rational points at which a divisor of an expression is zero."""

from __future__ import annotations

from collections.abc import Iterator, Mapping
from fractions import Fraction
from itertools import permutations

from gainproof.verify.judge.exact.box import Box
from gainproof.verify.judge.exact.expression import Expr, symbol, symbols_of, walk
from gainproof.verify.judge.exact.limits import Undecided
from gainproof.verify.judge.exact.poly import Poly, fraction, rational, univariate
from gainproof.verify.judge.exact.tidy import expression_of
from gainproof.verify.judge.exact.total import divisors
from gainproof.verify.judge.exact.tower_building import build_tower

TRIED = tuple(
    sorted(
        {Fraction(p, q) for q in range(1, 5) for p in range(1, 13)},
        key=lambda x: (x.numerator + x.denominator, x),
    )
)


def divisor_factors(*exprs: Expr) -> Iterator[Expr]:
    """Irreducible factors, polynomials in two symbols, of the divisors without roots."""
    seen: set[str] = set()
    for divisor in divisors(*exprs):
        if any(n.kind == "pow" and n.fraction.denominator != 1 for n in walk(divisor)):
            continue
        names = tuple(sorted(symbols_of(divisor)))
        try:
            element = build_tower([divisor], None, names, frozenset()).element(divisor)
        except Undecided:
            continue
        for factor, _ in element.num.factor()[1]:
            found = expression_of(factor, names)
            if len(symbols_of(found)) == 2 and str(factor) not in seen:
                seen.add(str(factor))
                yield found


def rational_zero(factor: Expr, boxes: Mapping[str, Box]) -> dict[str, Fraction] | None:
    """A point of the boxes with small numbers at which a polynomial in two symbols is zero."""
    for fixed, other in permutations(sorted(symbols_of(factor))):
        names = (fixed, other)
        p: Poly = build_tower([factor], None, names, frozenset()).element(factor).num
        for value in TRIED:
            if not boxes.get(fixed, Box()).holds(value):
                continue
            here = univariate(p.subs({p.context().names()[0]: rational(value)}), 1)
            for part, _ in here.factor()[1]:
                if part.degree() != 1:
                    continue
                root = -fraction(part[0]) / fraction(part[1])
                if boxes.get(other, Box()).holds(root):
                    return {fixed: value, other: root}
    return None


def is_zero_where(value: Expr, factor: Expr, boxes: Mapping[str, Box]) -> bool:
    """Whether an expression without roots is known to be zero where an irreducible factor is, and
    nowhere else in the boxes.
    """
    names = tuple(sorted(symbols_of(value, factor)))
    if any(n.kind == "pow" and n.fraction.denominator != 1 for n in walk(value)):
        return False
    try:
        tower = build_tower([value, factor], None, names, frozenset())
        factors = [part for part, _ in tower.element(value).num.factor()[1]]
        (wanted,) = (part for part, _ in tower.element(factor).num.factor()[1])
    except (Undecided, ValueError):
        return False
    others = [expression_of(part, names) for part in factors if part != wanted]
    own = [name for name in names if not boxes.get(name, Box()).holds(Fraction(0))]
    return len(others) < len(factors) and all(other in map(symbol, own) for other in others)
