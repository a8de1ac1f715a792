"""Definite integrals of polynomials, and of polynomials times exponentials of lines or squares."""

from __future__ import annotations

from collections.abc import Sequence
from math import factorial

from gainproof.verify.judge.exact.calculus import substituted
from gainproof.verify.judge.exact.expression import (
    Expr,
    add,
    mul,
    neg,
    number,
    power,
    symbol,
    symbols_of,
)
from gainproof.verify.judge.exact.limits import Undecided
from gainproof.verify.judge.exact.statement import Rel
from gainproof.verify.judge.meaning.expansion import coefficients, products
from gainproof.verify.judge.meaning.gaussian import refuse_steeper, with_square
from gainproof.verify.judge.meaning.sums import INFINITE


def integral_of(integrand: Expr, name: str, low: Expr, high: Expr) -> tuple[Expr, tuple[Rel, ...]]:
    """The integral over the bound symbol `name`, and what must not vanish. Raises Undecided."""
    known = coefficients(integrand, name)
    endless = high == INFINITE or low == neg(INFINITE)
    if low == INFINITE or high == neg(INFINITE) or (endless and known is not None):
        raise Undecided("an integral to infinity of something that does not decay")
    if known is not None:
        return _between(_primitive(known, name), name, low, high), ()
    terms: list[Expr] = []
    squares: list[Expr] = []
    needed: list[Rel] = []
    for product in products(integrand, [name]):
        polynomial, exponent = _split(product, name)
        if exponent is None:
            if endless:
                raise Undecided("an integral to infinity of something that does not decay")
            terms.append(_primitive(polynomial, name))
            continue
        line = refuse_steeper(coefficients(exponent, name))
        if 2 in line:
            found, rel = with_square(polynomial, exponent, line, name, low, high)
            squares.append(found)
            needed.append(rel)
            continue
        if low == neg(INFINITE):
            if high == INFINITE:
                raise Undecided("an integral over all numbers of something that does not decay")
            needed.append(Rel(">", line[1], number(0)))
        else:
            needed.append(Rel("<" if endless else "!=", line[1], number(0)))
        terms.append(_with_exponential(polynomial, name, exponent, line[1]))
    return add(*squares, _between(add(*terms, number(0)), name, low, high)), tuple(needed)


def _split(product: Sequence[Expr], name: str) -> tuple[dict[int, Expr], Expr | None]:
    """A product as a polynomial, and the exponent of the exponentials in it."""
    rates = [f for f in product if f.kind == "call" and f.name == "exp" and name in symbols_of(f)]
    factor = [f for f in product if f not in rates]
    polynomial = coefficients(mul(*factor) if factor else number(1), name)
    if polynomial is None:
        raise Undecided("an integral of anything but polynomials and exponentials of them")
    return polynomial, add(*[f.parts[0] for f in rates]) if rates else None


def _primitive(known: dict[int, Expr], name: str) -> Expr:
    t = symbol(name)
    terms = [mul(c, power(t, m + 1)) / (m + 1) for m, c in known.items()]
    return add(*terms) if terms else number(0)


def _with_exponential(known: dict[int, Expr], name: str, exponent: Expr, rate: Expr) -> Expr:
    """Of t^m exp(rate t): exp(rate t) times the sum of (-1)^j m!/(m-j)! t^(m-j) / rate^(j+1)."""
    t = symbol(name)
    whole = Expr("call", "exp", (exponent,))
    terms = []
    for m, c in known.items():
        for j in range(m + 1):
            weight = (-1) ** j * factorial(m) // factorial(m - j)
            rest = power(t, m - j) if m > j else number(1)
            terms.append(mul(number(weight), c, rest, whole) / power(rate, j + 1))
    return add(*terms)


def _between(primitive: Expr, name: str, low: Expr, high: Expr) -> Expr:
    """What an end that is infinite has is zero."""
    upper, lower = (
        number(0) if bound in (INFINITE, neg(INFINITE)) else substituted(primitive, {name: bound})
        for bound in (high, low)
    )
    return add(upper, neg(lower))
