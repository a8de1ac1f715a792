"""Least squares over all samples 0..k with a polynomial of degree 0 to 3, symbolic in the sample
number k.

With phi(j)' = H F^j, j = i - k <= 0, the normal matrix is J(k) = sum of phi phi'. Its closed form
comes from power sums fitted through points; what makes it the normal matrix is J(0) = H'H and J(k)
= F^-T J(k-1) F^-1 + H'H, shown identically in k. The batch solution then obeys J(k) x = F^-T J(k-1)
x_before + H' y, and the recursion with gain K = J^-1 H' solves exactly that equation, shown
identically in k, the previous state and the new measurement.
"""

from __future__ import annotations

from collections.abc import Callable, Mapping, Sequence
from dataclasses import dataclass
from fractions import Fraction
from itertools import pairwise
from math import factorial

import flint

from gainproof.verify.judge.exact.box import Box
from gainproof.verify.judge.exact.calculus import substituted
from gainproof.verify.judge.exact.decision import decide
from gainproof.verify.judge.exact.expression import (
    Expr,
    number,
    symbol,
    weighted,
    whole_power,
)
from gainproof.verify.judge.exact.polynomial import fraction, rational
from gainproof.verify.judge.exact.statement import Rel, Statement
from gainproof.verify.judge.exact.work_limits import Undecided
from gainproof.verify.judge.setting.environment import ANY_REAL, SAMPLE, Fact, NotEstablished
from gainproof.verify.judge.setting.matrices import (
    Exprs,
    Numbers,
    exprs,
    minus,
    plus,
    times,
    transposed,
)

Polynomial = list[Fraction]
Shown = Callable[[str, Exprs, str], Fact]
"""That all entries of a matrix compare so with 0. Raises NotEstablished."""
MOST_DEGREE = 3


@dataclass(frozen=True)
class GrowingMemory:
    """In units T = 1, measurement noise variance 1; expressions of the sample number."""

    degree: int
    transition: Exprs
    gain: tuple[Expr, ...]
    continued_gain: tuple[Expr, ...]
    updated: Exprs
    information: Exprs
    facts: tuple[Fact, ...]


def power_sum(m: int) -> Polynomial:
    """Coefficients of sum of j^m for j = 0..k as a polynomial in k, by interpolation."""
    points = [Fraction(sum(j**m for j in range(k + 1))) for k in range(m + 2)]
    found: Polynomial = [Fraction(0)]
    basis: Polynomial = [Fraction(1)]
    table = list(points)
    for order in range(m + 2):
        found = _add(found, [table[0] * c for c in basis])
        table = [b - a for a, b in pairwise(table)]
        basis = [c / (order + 1) for c in _mul(basis, [Fraction(-order), Fraction(1)])]
    return found


def _add(a: Polynomial, b: Polynomial) -> Polynomial:
    size = max(len(a), len(b))
    return [
        (a[k] if k < len(a) else Fraction(0)) + (b[k] if k < len(b) else Fraction(0))
        for k in range(size)
    ]


def _mul(a: Polynomial, b: Polynomial) -> Polynomial:
    made = [Fraction(0)] * (len(a) + len(b) - 1)
    for i, x in enumerate(a):
        for j, y in enumerate(b):
            made[i + j] += x * y
    return made


def _determinant(rows: Sequence[Sequence[Polynomial]]) -> Polynomial:
    if not rows:
        return [Fraction(1)]
    total: Polynomial = [Fraction(0)]
    for column, entry in enumerate(rows[0]):
        rest = [[x for j, x in enumerate(row) if j != column] for row in rows[1:]]
        total = _add(total, [c * (-1) ** column for c in _mul(entry, _determinant(rest))])
    return total


def _expr(p: Polynomial) -> Expr:
    k = symbol(SAMPLE)
    return weighted(p, [whole_power(k, e) for e in range(len(p))])


def growing_memory(degree: int) -> GrowingMemory:
    """Gain and covariance, established. Raises Undecided beyond degree 3."""
    if not 0 <= degree <= MOST_DEGREE:
        raise Undecided(f"least squares of degree {degree} is not covered")
    size = degree + 1
    normal = [
        [
            [c * (-1) ** (a + b) / (factorial(a) * factorial(b)) for c in power_sum(a + b)]
            for b in range(size)
        ]
        for a in range(size)
    ]
    determinant = _determinant(normal)
    inverse = tuple(
        tuple(
            _expr([c * (-1) ** (a + b) for c in _minor(normal, b, a)]) / _expr(determinant)
            for b in range(size)
        )
        for a in range(size)
    )
    j = tuple(tuple(_expr(p) for p in row) for row in normal)
    f = exprs(taylor(size, 1))
    gain = tuple(row[0] for row in inverse)
    continued = tuple(_cancelled(_minor(normal, 0, a), determinant, (-1) ** a) for a in range(size))
    boxes = {SAMPLE: Box(lower=Fraction(degree), lower_open=False)}

    def shown(sentence: str, entries: Exprs, operator: str = "=") -> Fact:
        return shown_of(SAMPLE, boxes, sentence, entries, operator)

    start = tuple(tuple(substituted(e, {SAMPLE: number(0)}) for e in row) for row in j)
    before = tuple(tuple(substituted(e, {SAMPLE: symbol(SAMPLE) - 1}) for e in row) for row in j)
    facts = (
        shown("J(0) = H'H", minus(start, times(transposed(first(size)), first(size)))),
        *of_recursion("J(k) = F^-T J(k-1) F^-1 + H'H for every k", j, before, inverse, shown),
        shown(f"det J(k) > 0 for k >= {degree}", ((_expr(determinant),),), ">"),
        shown("the gains with common factors cancelled", minus((gain,), (continued,))),
    )
    return GrowingMemory(degree, f, gain, continued, inverse, j, facts)


def _cancelled(top: Polynomial, bottom: Polynomial, sign: int) -> Expr:
    """The quotient without common factors."""
    a, b = (flint.fmpq_poly([rational(c) for c in p]) for p in (top, bottom))
    common = a.gcd(b)
    first, second = ([fraction(c) for c in (p / common).coeffs()] for p in (a, b))
    return _expr([sign * c for c in first]) / _expr(second)


def _minor(rows: Sequence[Sequence[Polynomial]], i: int, j: int) -> Polynomial:
    return _determinant(
        [[x for c, x in enumerate(row) if c != j] for r, row in enumerate(rows) if r != i]
    )


def taylor(size: int, step: int) -> Numbers:
    """The transition of a position and its derivatives over so many intervals."""
    return tuple(
        tuple(
            Fraction(step ** (c - r), factorial(c - r)) if c >= r else Fraction(0)
            for c in range(size)
        )
        for r in range(size)
    )


def first(size: int) -> Exprs:
    """The position is measured."""
    return (tuple(number(int(c == 0)) for c in range(size)),)


def of_recursion(
    sentence: str, j: Exprs, before: Exprs, inverse: Exprs, shown: Shown
) -> tuple[Fact, ...]:
    """That J = F^-T before F^-1 + H'H, as the `sentence` has it, and that the recursion with the
    gain J^-1 H' solves J x = F^-T before x_before + H'y, whatever the state before and the new
    measurement. Raises NotEstablished, Undecided.
    """
    size = len(j)
    f, back, h = exprs(taylor(size, 1)), exprs(taylor(size, -1)), first(size)
    moved = times(times(transposed(back), before), back)
    state = tuple((symbol(f"state {i}"),) for i in range(size))
    y = symbol("measured")
    forward = times(f, state)
    innovation = y - forward[0][0]
    new = tuple((p[0] + row[0] * innovation,) for p, row in zip(forward, inverse, strict=True))
    left = times(j, new)
    right = plus(
        times(times(transposed(back), before), state), tuple((e[0] * y,) for e in transposed(h))
    )
    unit = exprs(taylor(size, 0))
    return (
        shown("F F^-1 = I", minus(times(f, back), unit), "="),
        shown(sentence, minus(j, plus(moved, times(transposed(h), h))), "="),
        shown("J J^-1 = I", minus(times(j, inverse), unit), "="),
        shown("the recursion solves the normal equations of the batch", minus(left, right), "="),
    )


def shown_of(
    parameter: str, boxes: Mapping[str, Box], sentence: str, entries: Exprs, operator: str
) -> Fact:
    """The fact that all entries compare so with 0, for all values of the parameter in its box.
    Raises NotEstablished, Undecided.
    """
    free = ("measured", *(f"state {i}" for i in range(MOST_DEGREE + 1)))
    outcome = None
    for entry in (e for row in entries for e in row):
        statement = Statement((Rel(operator, entry, number(0)),))
        outcome = decide(statement, {**dict.fromkeys(free, ANY_REAL), **boxes}, parameter)
        if outcome.verdict != "proved":
            raise NotEstablished(f"{sentence}: {outcome.reason}")
    return Fact(sentence, f"identity in {parameter}", outcome.certificate if outcome else {})
