"""Truncated expansions: sums of coefficient * u^exponent for u -> 0 from above, and an order.

Exponents are fractions, coefficients are expressions without u, the error is O(u^order) for each
value of the other symbols. What an expansion needs to know of a coefficient it asks an oracle.
"""

from __future__ import annotations

from collections.abc import Iterable, Mapping
from dataclasses import dataclass
from fractions import Fraction
from typing import Protocol

from gainproof.verify.judge.exact.constant_value import constant_value
from gainproof.verify.judge.exact.expression import Expr, add, mul, neg, number, power
from gainproof.verify.judge.exact.simplification import tidied
from gainproof.verify.judge.exact.work_limits import Undecided

EXACT = Fraction(1000)
"""Order of a finite expansion, and of what is smaller than every power."""
MOST_STEPS = 64


class Oracle(Protocol):
    """What is known of coefficients on the whole domain of the other symbols; what stands in them
    for the logarithm of the small number, where it may stand there.
    """

    @property
    def logarithm(self) -> Expr | None: ...

    def is_zero(self, coefficient: Expr) -> bool:
        """True: zero always; False: zero never. Raises Undecided for anything else."""
        ...

    def is_positive(self, coefficient: Expr) -> bool:
        """Whether it is positive always; False where that is not known."""
        ...


class ProvingOracle:
    """An oracle by proofs of what `holds` of a coefficient beside zero."""

    logarithm: Expr | None = None
    unknown = "a coefficient of the expansion may be zero for some values of the other symbols"

    def holds(self, operator: str, coefficient: Expr) -> bool:
        """Whether it is proved."""
        raise NotImplementedError

    def is_zero(self, coefficient: Expr) -> bool:
        """Zero always, or never. Raises Undecided."""
        value = constant_value(coefficient)
        if value is not None:
            return value == 0
        if self.holds("=", coefficient):
            return True
        if self.holds("!=", coefficient):
            return False
        raise Undecided(self.unknown)

    def is_positive(self, coefficient: Expr) -> bool:
        """Positive always; False also where that is not known."""
        value = constant_value(coefficient)
        return self.holds(">", coefficient) if value is None else value > 0


@dataclass(frozen=True)
class Series:
    """Terms by exponent, and the order of the error."""

    terms: Mapping[Fraction, Expr]
    order: Fraction = EXACT

    def exponents(self) -> list[Fraction]:
        """The exponents, lowest first."""
        return sorted(self.terms)


def constant(expr: Expr) -> Series:
    """An expression without u."""
    return Series({Fraction(0): expr})


def neat(expr: Expr) -> Expr:
    """The same coefficient, shorter."""
    value = constant_value(expr)
    return tidied(expr) if value is None else number(value)


def made(pairs: Iterable[tuple[Fraction, Expr]], order: Fraction) -> Series:
    """The expansion with these terms, those of one exponent added, those beyond the order left
    out.
    """
    found: dict[Fraction, list[Expr]] = {}
    for exponent, c in pairs:
        if exponent < order:
            found.setdefault(exponent, []).append(c)
    sums = {e: neat(add(*cs)) for e, cs in found.items()}
    return Series({e: c for e, c in sums.items() if c != number(0)}, order)


def plus(*parts: Series) -> Series:
    """The sum."""
    order = min(p.order for p in parts)
    return made([item for p in parts for item in p.terms.items()], order)


def opposite(s: Series) -> Series:
    """-s."""
    return Series({e: neg(c) for e, c in s.terms.items()}, s.order)


def times(a: Series, b: Series) -> Series:
    """The product."""
    lows = [min(s.terms, default=s.order) for s in (a, b)]
    order = min(lows[0] + b.order, lows[1] + a.order, EXACT)
    pairs = [(i + j, mul(x, y)) for i, x in a.terms.items() for j, y in b.terms.items()]
    return made(pairs, order)


def leading(s: Series, oracle: Oracle) -> tuple[Fraction, Expr] | None:
    """Exponent and coefficient of the first term that is not zero; None if all known terms are.

    Raises Undecided if a coefficient is zero for some values of its symbols only.
    """
    for exponent in s.exponents():
        if not oracle.is_zero(s.terms[exponent]):
            return exponent, s.terms[exponent]
    return None


def split(s: Series, oracle: Oracle) -> tuple[Fraction, Expr, Series]:
    """s = c u^e (1 + rest) as e, c, rest. Raises Undecided where the first term is not known."""
    found = leading(s, oracle)
    if found is None:
        raise Undecided("an expansion that cancels to the order reached")
    e, c = found
    rest = [(i - e, x / c) for i, x in s.terms.items() if i > e]
    return e, c, made(rest, s.order - e if s.order < EXACT else EXACT)


def powered(s: Series, exponent: Fraction, oracle: Oracle, depth: Fraction) -> Series:
    """s^exponent, to a relative order of `depth`."""
    if exponent.denominator == 1 and exponent >= 0:
        result = constant(number(1))
        for _ in range(int(exponent)):
            result = times(result, s)
        return result
    if not s.terms and s.order == EXACT and exponent > 0 and exponent.denominator % 2:
        # zero, or smaller than every power: then an even root asks for a sign that is not known
        return s
    e, c, rest = split(s, oracle)
    if exponent.denominator % 2 == 0 and not oracle.is_positive(c):
        raise Undecided("an even root of something not known to be positive near the limit")
    weights = [Fraction(1)]
    while len(weights) < MOST_STEPS:
        k = len(weights)
        weights.append(weights[-1] * (exponent - k + 1) / k)
    body = composed(rest, weights, depth)
    factor = power(c, exponent)
    shift = e * exponent
    order = body.order + shift if body.order < EXACT else EXACT
    return made([(i + shift, mul(factor, x)) for i, x in body.terms.items()], order)


def composed(s: Series, weights: list[Fraction], depth: Fraction) -> Series:
    """Sum of weights[k] s^k for an s without constant or negative powers, to order `depth`."""
    low = min(s.terms, default=s.order)
    if low <= 0:
        raise Undecided("an expansion about a point that is not known")
    cut = min(depth, s.order)
    total, current = constant(number(weights[0])), constant(number(1))
    for weight in weights[1:]:
        current = times(current, s)
        current = made(current.terms.items(), min(cut, current.order))
        if not current.terms:
            break
        if weight:
            scaled = {e: mul(number(weight), c) for e, c in current.terms.items()}
            total = plus(total, Series(scaled, current.order))
    else:
        cut = min(cut, low * len(weights))
    exact = not s.terms and s.order == EXACT
    return made(total.terms.items(), EXACT if exact else min(cut, total.order))
