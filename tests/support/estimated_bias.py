"""The deviation of an estimated bias, from the smallest case there is: one range, its own noise of
variance 1, and a second measurement of the same distance without the bias.

The bias is the difference of the two, whose variances add. The derivation eliminates position and
velocity from a block matrix instead; nothing of it is used.
"""

from __future__ import annotations

from collections.abc import Mapping
from dataclasses import dataclass
from fractions import Fraction

import flint

from gainproof.verify.oracles.true_values import Truth

BITS = 400


@dataclass(frozen=True)
class BiasDeviationTruth:
    """A distance known to that variance, and its range of variance 1."""

    def at(self, argument: str, value: float) -> Mapping[str, Truth]:
        """The deviation of the difference, and the part of its variance that is the range's."""
        assert argument == "variance_ratio"
        total = Fraction(value) + 1
        with flint.ctx.workprec(BITS):
            variance = flint.arb(flint.fmpq(total.numerator, total.denominator))
            deviation, share = variance.sqrt(), 1 / variance
            return {
                "deviation": Truth(deviation, deviation),
                "share": Truth(share, share),
            }
