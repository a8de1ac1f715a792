"""Definite integrals of polynomials times exponentials, sines and cosines of lines, and of
polynomials times exponentials of squares.

With z = a + i w, t^m e^(z t) has the primitive e^(z t) times the sum over j = 0 to m of
(-1)^j m!/(m-j)! t^(m-j) / z^(j+1); cosines and sines are its real and imaginary parts.

With v = t - m and a > 0, of v^n e^(-a v^2): I_0 = (pi/a)^(1/2)/2 erf(a^(1/2) v) (DLMF 7.2.1),
I_1 = -e^(-a v^2)/(2 a), I_n = -v^(n-1) e^(-a v^2)/(2 a) + (n - 1)/(2 a) I_(n-2), by parts.
"""

from __future__ import annotations

from collections.abc import Iterable, Iterator, Mapping, Sequence
from fractions import Fraction
from math import comb, factorial
from typing import NamedTuple

from gainproof.verify.judge.exact.calculus import substituted
from gainproof.verify.judge.exact.constant_value import constant_value
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
from gainproof.verify.judge.exact.statement import TURNED, Rel
from gainproof.verify.judge.exact.total_expressions import is_total
from gainproof.verify.judge.exact.work_limits import Undecided
from gainproof.verify.judge.meaning.expansion import coefficients, products
from gainproof.verify.judge.meaning.normal_moments import Turn, sums_of_turns
from gainproof.verify.judge.meaning.sums import INFINITE
from gainproof.verify.judge.transcendental.monomials import monomial_expr, monomials, terms_expr

HALF = Fraction(1, 2)


class Wave(NamedTuple):
    """`real`, the real part of a constant times e^(z t), `imaginary` its imaginary part; z is
    growth + i turn, without what is None.
    """

    real: Expr
    imaginary: Expr
    growth: Expr | None
    turn: Expr | None


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
        polynomial, exponent, turns = _split(product, name)
        line = {} if exponent is None else refuse_steeper(coefficients(exponent, name))
        if exponent is not None and 2 in line:
            if turns:
                raise Undecided("an integral of sines or cosines times an exponential of a square")
            found, rel = with_square(polynomial, exponent, line, name, low, high)
            squares.append(found)
            needed.append(_sign(rel.operator, rel.left))
            continue
        growth = line.get(1)
        if growth is not None and not monomials(growth):
            growth = None
        if endless:
            needed.append(_decay(growth, low, high))
        size = number(1) if exponent is None else Expr("call", "exp", (exponent,))
        for wave in _waves(size, growth, turns, name):
            if wave.growth is None and wave.turn is None:
                terms.append(mul(wave.real, _primitive(polynomial, name)))
                continue
            if not endless:
                needed.append(_sign("!=", _size(wave)))
            terms.append(_primitive_of(polynomial, name, wave))
    return add(*squares, _between(add(*terms, number(0)), name, low, high)), tuple(needed)


def _decay(growth: Expr | None, low: Expr, high: Expr) -> Rel:
    """That e^(growth t) falls towards the end that is infinite. Raises Undecided."""
    if growth is None:
        raise Undecided("an integral to infinity of something that does not decay")
    if low != neg(INFINITE):
        return _sign("<", growth)
    if high == INFINITE:
        raise Undecided("an integral over all numbers of something that does not decay")
    return _sign(">", growth)


def _sign(operator: str, expr: Expr) -> Rel:
    """expr operator 0, as simple as can be told."""
    terms = monomials(expr) if is_total(expr) else {}
    if len(terms) > 1:
        expr = terms_expr(terms)
    for monomial, c in terms.items() if len(terms) == 1 else ():
        expr = monomial_expr(monomial)
        operator = operator if c > 0 else TURNED.get(operator, operator)
    return Rel(operator, expr, number(0))


def _split(product: Sequence[Expr], name: str) -> tuple[dict[int, Expr], Expr | None, list[Turn]]:
    """A product as a polynomial, the exponent of the exponentials in it, its sines and cosines."""
    moving = [f for f in product if f.kind == "call" and name in symbols_of(f)]
    rates = [f.parts[0] for f in moving if f.name == "exp"]
    turns = [(f.name, f.parts[0]) for f in moving if f.name in ("sin", "cos")]
    factor = [f for f in product if f not in moving]
    polynomial = coefficients(mul(*factor) if factor else number(1), name)
    if polynomial is None or len(rates) + len(turns) < len(moving):
        raise Undecided("an integral of anything but polynomials, exponentials, sines and cosines")
    return polynomial, add(*rates) if rates else None, turns


def _waves(size: Expr, growth: Expr | None, turns: Sequence[Turn], name: str) -> Iterator[Wave]:
    """An exponential times sines and cosines as a sum. Raises Undecided for what is not linear."""
    if not turns:
        yield Wave(size, number(0), growth, None)
        return
    for c, kind, angle in sums_of_turns(turns):
        line = coefficients(angle, name)
        if line is None or not set(line) <= {0, 1}:
            raise Undecided("an integral of a sine or cosine of something that is not linear")
        rate: Expr | None = line.get(1, number(0))
        if rate is not None and not monomials(rate):
            # what cancels has to have a value
            angle = line.get(0, number(0)) + (number(0) if is_total(rate) else 0 * rate)
            rate = None
        weight = size if c == 1 else mul(number(c), size)
        cosine, sine = (mul(weight, Expr("call", part, (angle,))) for part in ("cos", "sin"))
        yield Wave(*((cosine, sine) if kind == "cos" else (sine, neg(cosine))), growth, rate)


def _size(wave: Wave) -> Expr:
    """What z^n is divided by: z where it is real, w of i w, else |z|^2."""
    if wave.growth is None or wave.turn is None:
        return wave.growth or wave.turn or number(0)
    return power(wave.growth, 2) + power(wave.turn, 2)


def _primitive(known: Mapping[int, Expr], name: str) -> Expr:
    t = symbol(name)
    terms = [mul(c, power(t, m + 1)) / (m + 1) for m, c in known.items()]
    return add(*terms) if terms else number(0)


def _primitive_of(known: Mapping[int, Expr], name: str, wave: Wave) -> Expr:
    """Of a polynomial times the real part of a wave."""
    t, size = symbol(name), _size(wave)
    terms = []
    for m, c in known.items():
        for j in range(m + 1):
            weight = (-1) ** j * factorial(m) // factorial(m - j)
            rest = power(t, m - j) if m > j else number(1)
            for part, value in _conjugate(wave, j + 1):
                terms.append(mul(number(weight), c, rest, part, value) / power(size, j + 1))
    return add(*terms)


def _conjugate(wave: Wave, n: int) -> Iterator[tuple[Expr, Expr]]:
    """z^-n times the wave times `_size` to the power n: the terms of its real part, from those of
    (a - i w)^n. Where z is one of a and i w alone, that stays off.
    """
    for k in range(n + 1):
        if (k and wave.turn is None) or (k < n and wave.growth is None):
            continue
        alone = wave.turn is None or wave.growth is None
        factors = [] if alone else [(wave.growth, n - k), (wave.turn, k)]
        sign = number((1, 1, -1, -1)[k % 4] * comb(n, k))
        coefficient = mul(sign, *[power(x, e) for x, e in factors if x is not None and e])
        # the real part of (-i)^k (x + i y): x, y, -x, -y
        yield coefficient, wave.imaginary if k % 2 else wave.real


def _between(primitive: Expr, name: str, low: Expr, high: Expr) -> Expr:
    """What an end that is infinite has is zero."""
    upper, lower = (
        number(0) if bound in (INFINITE, neg(INFINITE)) else substituted(primitive, {name: bound})
        for bound in (high, low)
    )
    return add(upper, neg(lower))


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
