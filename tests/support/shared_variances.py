"""The gain of one coordinate: two values of one quantity, weighed by their information.

Information is what independent values add (1/variance each), which is no formula of the kernels.
"""

from __future__ import annotations

from collections.abc import Mapping
from dataclasses import dataclass
from fractions import Fraction

import flint

from gainproof.verify.oracles.true_values import Truth

BITS = 300


@dataclass(frozen=True)
class PositionGainTruth:
    """A prediction of that variance and a measurement of variance 1."""

    def at(self, argument: str, value: float) -> Mapping[str, Truth]:
        """The shares of the two in the sum of their informations."""
        assert argument == "variance_ratio"
        old, new = 1 / Fraction(value), Fraction(1)
        return {"gain": _truth(new / (old + new)), "rest": _truth(old / (old + new))}


def _truth(value: Fraction) -> Truth:
    with flint.ctx.workprec(BITS):
        ball = flint.arb(flint.fmpq(value.numerator, value.denominator))
        return Truth(ball, ball)
