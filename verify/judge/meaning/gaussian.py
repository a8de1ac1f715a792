"""Integrals of polynomials times an exponential of a square: closed, by the error function or not.

With v = t - m and a > 0, of v^n e^(-a v^2): I_0 = (pi/a)^(1/2)/2 erf(a^(1/2) v) (DLMF 7.2.1),
I_1 = -e^(-a v^2)/(2 a), I_n = -v^(n-1) e^(-a v^2)/(2 a) + (n - 1)/(2 a) I_(n-2), by parts.
"""

from __future__ import annotations

from collections.abc import Iterable, Mapping
from fractions import Fraction
from typing import NamedTuple

from gainproof.verify.judge.exact.calculus import substituted
from gainproof.verify.judge.exact.constant_value import constant_value
from gainproof.verify.judge.exact.expression import Expr, add, mul, neg, number, power, symbol
from gainproof.verify.judge.exact.limits import Undecided
from gainproof.verify.judge.exact.statement import Rel
from gainproof.verify.judge.meaning.expansion import coefficients
from gainproof.verify.judge.meaning.sums import INFINITE

HALF = Fraction(1, 2)


def with_square(
    polynomial: Mapping[int, Expr],
    exponent: Expr,
    line: Mapping[int, Expr],
    name: str,
    low: Expr,
    high: Expr,
) -> tuple[Expr, Rel]:
    """The integral of a polynomial times exp(exponent), which has the coefficients `line`, and that
    the square falls. Raises Undecided.
    """
    falling = constant_value(line[2])
    a = neg(line[2]) if falling is None else number(-falling)
    slope, constant = line.get(1, number(0)), line.get(0, number(0))
    if 1 in line:
        mean = slope / (2 * a)
        peak, by_power = constant + slope * mean / 2, _about(mean, polynomial, name)
    else:
        mean, peak, by_power = number(0), constant, dict(polynomial)
    ends = []
    for end in (high, low):
        if end in (INFINITE, neg(INFINITE)):
            known = _far(a, _exp(peak), 1 if end == INFINITE else -1)
        else:
            known = _at(a, _exp(peak), end - mean, _exp(substituted(exponent, {name: end})))
        ends.append(_sum(mul(c, _moment(m, a, known)) for m, c in by_power.items()))
    return ends[0] - ends[1], Rel("<", line[2], number(0))


def _about(mean: Expr, polynomial: Mapping[int, Expr], name: str) -> dict[int, Expr]:
    """The coefficients of a polynomial in t as one in t - mean."""
    v = mean + symbol(name)
    moved = _sum(mul(c, *[v] * m) if m else c for m, c in polynomial.items())
    found = coefficients(moved, name)
    if found is None:
        raise Undecided("an integral of a polynomial that is none about the middle of its square")
    return found


def _sum(terms: Iterable[Expr]) -> Expr:
    return add(*terms, number(0))


class _End(NamedTuple):
    """What a primitive is made of at one end: I_0 and I_1 there, v and e^(-a v^2)."""

    zeroth: Expr
    first: Expr
    v: Expr
    whole: Expr


def _far(a: Expr, top: Expr, sign: int) -> _End:
    zero = number(0)
    return _End(number(sign) * _half_of_all(a) * top, zero, zero, zero)


def _at(a: Expr, top: Expr, v: Expr, whole: Expr) -> _End:
    middle = constant_value(v) == 0
    error = (
        number(0) if middle else Expr("call", "erf", (v if a == number(1) else power(a, HALF) * v,))
    )
    zeroth = _half_of_all(a) * top * error
    return _End(zeroth, neg(whole) / (2 * a), v, whole)


def _half_of_all(a: Expr) -> Expr:
    """(pi/a)^(1/2)/2."""
    below = number(2) if a == number(1) else 2 * power(a, HALF)
    return power(Expr("call", "pi", ()), HALF) / below


def _moment(n: int, a: Expr, end: _End) -> Expr:
    if n < 2:
        return (end.zeroth, end.first)[n]
    falling = neg(mul(power(end.v, n - 1), end.whole)) / (2 * a)
    return falling + number(n - 1) * _moment(n - 2, a, end) / (2 * a)


def _exp(exponent: Expr) -> Expr:
    return Expr("call", "exp", (exponent,))


def refuse_steeper(line: Mapping[int, Expr] | None) -> Mapping[int, Expr]:
    """The coefficients of an exponent of degree one or two. Raises Undecided."""
    if line is None or not set(line) <= {0, 1, 2} or not set(line) & {1, 2}:
        raise Undecided("an integral of an exponential whose exponent is no line and no square")
    return line
