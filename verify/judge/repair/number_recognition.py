"""Numbers recognised from balls: one rational, or a monomial of symbols, at all points."""

from __future__ import annotations

from collections.abc import Sequence
from fractions import Fraction
from itertools import combinations

from gainproof.verify.judge.exact.expression import Expr, number, symbol
from gainproof.verify.judge.exact.polynomial import Ball, exact_value, rational
from gainproof.verify.judge.repair.tree_construction import opposite, product, quotient, raised

MOST_DENOMINATOR = 720
MOST_HEIGHT = 5000
MOST_SYMBOLS = 12
LEAST = Fraction(1, 10**200)
"""Sizes below it are taken for 0."""
EXPONENTS = {Fraction(n, 2) for n in range(-8, 9) if n}


def as_fraction(ball: Ball) -> Fraction:
    """The midpoint, exactly."""
    return exact_value(ball.mid())


def common_rational(values: Sequence[Ball]) -> Fraction | None:
    """The small rational number that all these are, to 60 bits."""
    found: Fraction | None = None
    for value in values:
        exact = as_fraction(value)
        near = exact.limit_denominator(MOST_DENOMINATOR)
        if abs(near.numerator) > MOST_HEIGHT or (found is not None and near != found):
            return None
        if abs(exact - near) > max(abs(near), Fraction(1)) / 2**60:
            return None
        found = near
    return found


def monomial(
    values: Sequence[Ball], names: Sequence[str], at: Sequence[Sequence[Ball]]
) -> Expr | None:
    """c * product of powers of up to two symbols, equal to `values` at every point; `at[n]` are the
    values of symbol n.
    """
    plain = common_rational(values)
    if plain is not None:
        return _scaled(plain, [])
    logs = [_log(v) for v in values]
    if None in logs or len(values) < 4:
        return None
    usable = [(n, [_log(v) for v in at[k]]) for k, n in enumerate(names[:MOST_SYMBOLS])]
    good = [(n, column) for n, column in usable if None not in column]
    for count in (1, 2):
        for chosen in combinations(good, count):
            exponents = _slopes(logs, [column for _, column in chosen])
            if exponents is None:
                continue
            pairs = list(zip([n for n, _ in chosen], exponents, strict=True))
            rest = _divided(values, pairs, names, at)
            constant = None if rest is None else common_rational(rest)
            if constant:
                return _scaled(constant, pairs)
    return None


def _log(ball: Ball) -> float | None:
    size = abs(ball)
    return float(size.log().mid()) if size.is_finite() and size > rational(LEAST) else None


def _slopes(
    logs: Sequence[float | None], columns: list[list[float | None]]
) -> list[Fraction] | None:
    """Exponents from differences between points, if they are whole or half numbers."""
    y = [(b or 0.0) - (logs[0] or 0.0) for b in logs[1:]]
    rows = [[(c[i] or 0.0) - (c[0] or 0.0) for c in columns] for i in range(1, len(logs))]
    if len(columns) == 1:
        if abs(rows[0][0]) < 1e-9:
            return None
        found = [y[0] / rows[0][0]]
    else:
        (a, b), (c, d) = rows[0], rows[1]
        determinant = a * d - b * c
        if abs(determinant) < 1e-9:
            return None
        found = [(y[0] * d - b * y[1]) / determinant, (a * y[1] - c * y[0]) / determinant]
    exact = [Fraction(x).limit_denominator(2) for x in found]
    close = all(abs(float(e) - x) < 1e-6 for e, x in zip(exact, found, strict=True))
    return exact if close and set(exact) <= EXPONENTS else None


def _divided(
    values: Sequence[Ball],
    pairs: Sequence[tuple[str, Fraction]],
    names: Sequence[str],
    at: Sequence[Sequence[Ball]],
) -> list[Ball] | None:
    rest = []
    for point, value in enumerate(values):
        for name, exponent in pairs:
            base = at[names.index(name)][point]
            if exponent.denominator == 2:
                if not base > 0:
                    return None
                base = base.sqrt()
            value = value / base ** int(exponent * exponent.denominator)
        if not value.is_finite():
            return None
        rest.append(value)
    return rest


def _scaled(constant: Fraction, pairs: Sequence[tuple[str, Fraction]]) -> Expr:
    above = [raised(symbol(n), e) for n, e in pairs if e > 0]
    below = [raised(symbol(n), -e) for n, e in pairs if e < 0]
    size = abs(constant)
    top = product(number(size.numerator), *above)
    made = quotient(top, product(number(size.denominator), *below))
    return made if constant > 0 else opposite(made)
