"""A solution recognised as a polynomial of two of the source's symbols, from its values."""

from __future__ import annotations

from collections.abc import Iterator, Sequence
from fractions import Fraction
from itertools import combinations

import flint

from gainproof.verify.judge.claim.record import Claim, Setting
from gainproof.verify.judge.claim_symbols import closure
from gainproof.verify.judge.convention import Convention
from gainproof.verify.judge.dimensions.dimension import ONE
from gainproof.verify.judge.dimensions.formula import dimension_of
from gainproof.verify.judge.exact.expression import (
    Expr,
    mul,
    number,
    symbol,
    symbols_of,
    weighted,
    whole_power,
)
from gainproof.verify.judge.exact.graph_writing import graph_of
from gainproof.verify.judge.exact.polynomial import Ball
from gainproof.verify.judge.repair.formula_values import Values
from gainproof.verify.judge.repair.generic_points import generic_points
from gainproof.verify.judge.repair.number_recognition import as_fraction
from gainproof.verify.judge.scope import Scope

DEGREES = ((2, 2), (4, 4))
"""Highest powers tried of the first and the second symbol."""
MORE = 3
"""Points beyond those that fix the coefficients."""
BITS = 512
MOST_DENOMINATOR = 720
MOST_TERMS = 6


def as_polynomial(claim: Claim, value: Expr, convention: Convention) -> Expr | None:
    """A polynomial in up to two symbols without dimension that has the value's values at many
    points, the one with fewest terms, or None. Raises Undecided, UndefinedSymbol.
    """
    setting = convention.setting
    names = sorted(closure(symbols_of(value), setting.symbols))
    names = [n for n in names if _is_plain(n, setting)]
    scope = Scope(setting, convention.environment)
    for name in symbols_of(value):
        scope.symbol(name)
    assert claim.formula is not None
    most = max((a + 1) * (b + 1) for a, b in DEGREES) + MORE
    conditions = claim.formula.readings[0].conditions
    points, put_in = generic_points(claim, conditions, scope, most)
    known = [Values(scope, point, put_in, BITS) for point in points]
    wanted = [values.ball(value) for values in known]
    columns = {name: [values.symbol(name) for values in known] for name in names}
    usable = {n: c for n, c in columns.items() if all(x is not None for x in c)}
    if len(points) < most or any(w is None for w in wanted):
        return None
    for degrees in DEGREES:
        found = [
            made
            for pair in combinations(usable, 2)
            for ordered in {degrees, degrees[::-1]}
            if (made := _fitted(pair, [usable[n] for n in pair], wanted, ordered)) is not None
        ]
        if found:
            return min(found, key=lambda item: item[0])[1]
    return None


def _is_plain(name: str, setting: Setting) -> bool:
    entry = setting.symbols[name]
    if entry.shape is not None or entry.arguments or entry.role == "undefined":
        return False
    return dimension_of(graph_of(symbol(name)), setting) == ONE


def _exponents(degrees: tuple[int, int]) -> Iterator[tuple[int, int]]:
    for i in range(degrees[0] + 1):
        for j in range(degrees[1] + 1):
            yield i, j


def _fitted(
    names: Sequence[str],
    columns: Sequence[Sequence[Ball]],
    wanted: Sequence[Ball],
    degrees: tuple[int, int],
) -> tuple[int, Expr] | None:
    """The number of terms, and the polynomial with small rational coefficients."""
    exponents = list(_exponents(degrees))
    count = len(exponents)
    with flint.ctx.workprec(BITS):
        rows = [[a**i * b**j for i, j in exponents] for a, b in zip(*columns, strict=True)]
        try:
            solved = flint.arb_mat(rows[:count]).solve(flint.arb_mat([[w] for w in wanted[:count]]))
        except ZeroDivisionError:
            return None
        coefficients = [_near(solved[k, 0]) for k in range(count)]
        if None in coefficients:
            return None
        sizes = [c for c in coefficients if c is not None]
        for row, w in list(zip(rows, wanted, strict=True))[count : count + MORE]:
            total: Ball = -w
            for c, x in zip(sizes, row, strict=True):
                total = total + flint.arb(_q(c)) * x
            if not total.contains(0):
                return None
    kept = [(c, e) for c, e in zip(sizes, exponents, strict=True) if c]
    if not kept or len(kept) > MOST_TERMS:
        return None
    terms = [_monomial(names, e) for _, e in kept][::-1]
    return len(kept), weighted([c for c, _ in kept][::-1], terms)


def _monomial(names: Sequence[str], exponents: Sequence[int]) -> Expr:
    powers = [whole_power(symbol(n), e) for n, e in zip(names, exponents, strict=True) if e]
    return mul(*powers) if powers else number(1)


def _near(ball: Ball) -> Fraction | None:
    """The small rational number in a ball."""
    near = as_fraction(ball).limit_denominator(MOST_DENOMINATOR)
    return near if ball.contains(_q(near)) else None


def _q(value: Fraction) -> flint.fmpq:
    return flint.fmpq(value.numerator, value.denominator)
