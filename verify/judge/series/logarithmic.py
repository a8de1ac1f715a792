"""Expansions with the logarithm of the small number in their coefficients.

log u tends to minus infinity more slowly than any power of u: what is O(u^a log^k u) is smaller
than u^b for every b < a, so that orders mean what they mean without logarithms. Coefficients may
hold bounded functions of it and logarithms of it too, of which nothing is said: of what is looked
at, a sum of powers of it, positive and negative, the highest is what counts.
"""

from __future__ import annotations

from fractions import Fraction

from gainproof.verify.judge.exact.expression import Expr, number, symbol, symbols_of
from gainproof.verify.judge.exact.work_limits import Undecided
from gainproof.verify.judge.series.series import Oracle, neat
from gainproof.verify.judge.transcendental.monomials import monomial_expr, monomials

LOGARITHM = symbol("logarithm of the distance to the limit")
"""No symbol of a claim is called so."""


def by_powers(coefficient: Expr) -> dict[int, Expr]:
    """The factors of powers of the logarithm, those left out that are written as zero. Raises
    Undecided where it stands in anything else than a sum of its powers.
    """
    if LOGARITHM.name not in symbols_of(coefficient):
        return {0: coefficient} if coefficient != number(0) else {}
    found: dict[int, Expr] = {}
    for monomial, c in monomials(coefficient).items():
        times = sum(n for base, n in monomial if base == LOGARITHM)
        others = frozenset((base, n) for base, n in monomial if base != LOGARITHM)
        if any(LOGARITHM.name in symbols_of(base) for base, _ in others):
            raise Undecided("a logarithm of something that tends to zero, inside of a quotient")
        found[times] = found.get(times, number(0)) + number(c) * monomial_expr(others)
    tidy = {times: neat(factor) for times, factor in found.items()}
    return {times: factor for times, factor in tidy.items() if factor != number(0)}


class WithLogarithms:
    """What an oracle knows, of coefficients close to the limit."""

    logarithm: Expr | None = LOGARITHM

    def __init__(self, oracle: Oracle) -> None:
        self._oracle = oracle

    def is_zero(self, coefficient: Expr) -> bool:
        """True: zero always; False: never, close to the limit. Raises Undecided."""
        return self.first(coefficient) is None

    def is_positive(self, coefficient: Expr) -> bool:
        """Whether it is positive close to the limit; False where that is not known."""
        found = self.first(coefficient)
        if found is None:
            return False
        times, factor = found
        return self._oracle.is_positive(factor if times % 2 == 0 else -factor)

    def first(self, coefficient: Expr) -> tuple[int, Expr] | None:
        """The highest power of the logarithm and its factor, which is nowhere zero; None if there
        is none. Raises Undecided.
        """
        powers = by_powers(coefficient)
        for times in sorted(powers, reverse=True):
            if not self._oracle.is_zero(powers[times]):
                return times, powers[times]
        return None


def power_of_small(start: Expr) -> tuple[Fraction, Expr] | None:
    """Of a constant term n log u + c with a rational number n, both; None if it has no logarithm.
    Raises Undecided for other ones.
    """
    powers = by_powers(start)
    if set(powers) <= {0}:
        return None
    factor = powers.get(1, number(0))
    if not set(powers) <= {0, 1} or factor.kind != "number":
        raise Undecided("an exponential of a logarithm that is no power")
    return factor.fraction, powers.get(0, number(0))
