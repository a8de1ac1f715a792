"""The gains in forms chosen for few roundings, each of which counts little.

The root comes last: an error of what stands below it counts half, and the last operation alone
half a unit in the last place. So alpha is the root of its square, from 4/alpha^2 =
(rho + 1 + c/rho)^2 multiplied out, c = (1 - e)/4, where rho^2 = kappa + (1 + e)/4 needs no root.

For e = 0 kappa = 2/Lambda has one rounding. For other families kappa = eta/(2 Lambda), and eta^2 =
16 + e Lambda^2 would overflow. All forms are homogeneous in Lambda and 4, so that any pair a, b
with a : b = Lambda : 4 serves: `Pair` takes Lambda and 4 themselves, which are exact, below
`SWITCH`, and from there on SWITCH and 4 SWITCH/Lambda, all times `UNIT`. SWITCH is no power of two:
where beta comes close to one from below, sums then do not come close to one from above, where
their rounding weighs most.

Like `forms`, these work on anything with the operators + * /.
"""

from __future__ import annotations

from dataclasses import dataclass
from fractions import Fraction
from typing import Any

from gainproof.derive.steady_state.forms import Basis, times

SWITCH = Fraction(3, 4)
"""The index from which `Pair` is scaled by it."""

UNIT = 2**54
"""Times this the least positive number is a normal one, and so are its products."""
RAISED = 2**30
"""Squares are those of numbers so many times as large: the least alpha has none that is normal."""


@dataclass(frozen=True)
class Pair:
    """a : b = Lambda : 4, with eta and 2 rho Lambda scaled alike, for e > 0."""

    a: Any
    eta: Any
    ratio: Any
    e: Fraction

    @property
    def beta(self) -> Any:
        """4 Lambda/(Lambda + eta + 2 rho Lambda)."""
        return (self.a * 4) / (self.eta + (self.a + self.ratio))

    @property
    def alpha_square(self) -> Any:
        """(RAISED alpha/4)^2."""
        # of the sum 4 rho^2 a + 8 rho a + 4 (1 + 2 c) a + 16 a (z + z^2) with z = c/(2 rho)
        rest = times(7 - self.e, self.a)
        if self.e != 1:
            z = times((1 - self.e) / 4, self.a) / self.ratio
            rest = rest + (self.a * 16) * (z * (z + 1))
        return (self.a * RAISED**2) / (self.eta * 2 + (self.ratio * 4 + rest))

    @property
    def position_square(self) -> Any:
        """(RAISED (alpha + beta)/4)^2 for e = 1, where alpha + beta is 2/rho."""
        return (self.a * RAISED**2) / square_of_ratio(self.a, self.eta, self.e)


def square_of_ratio(a: Any, eta: Any, e: Fraction) -> Any:
    """4 rho^2 a = 2 eta + (1 + e) a: times a it is the square of 2 rho a."""
    return eta * 2 + times(1 + e, a)


def undamped_alpha_square(x: Basis, square: Any) -> Any:
    """(RAISED alpha/4)^2 for e = 0, from `square` = rho^2 times the unit."""
    z = (x.unit / 2) / x.twice
    return (x.unit * RAISED**2 / 4) / (square + (x.twice + (z * (z + 2) + Fraction(3, 2)) * x.unit))


def undamped_beta(x: Basis) -> Any:
    """2/(1/2 + kappa + rho) for e = 0."""
    return (x.unit * 4) / (x.kappa * 2 + (x.twice + x.unit))
