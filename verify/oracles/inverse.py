"""From a gain back to the tracking index: a rigorous bracket by evaluating forward.

Independent because it knows no inverse formula: it evaluates the enclosed steady state at two
indices, one certainly giving less than the given value and one certainly more. A continuous
quantity takes the value in between; that it does so nowhere else is the monotonicity that the
caller claims (the slope's sign at the bracket is checked).
"""

from __future__ import annotations

from collections.abc import Callable
from dataclasses import dataclass
from fractions import Fraction

import flint

from gainproof.verify.oracles import distance
from gainproof.verify.oracles.ball import Enclosure, enclose
from gainproof.verify.oracles.spectrum import Spectrum
from gainproof.verify.oracles.state_space import NotConverged

KEPT_BITS = 160
Quantity = Callable[[Enclosure], tuple[flint.arb, flint.arb]]


@dataclass(frozen=True)
class Bracket:
    """Enclosures of the steady state just below and just above the index that was sought."""

    below: Enclosure
    above: Enclosure

    def ball(self, quantity: Callable[[Enclosure], flint.arb]) -> flint.arb:
        """A ball that holds a monotone quantity at the index that was sought."""
        with flint.ctx.workprec(4 * KEPT_BITS):
            return flint.arb(quantity(self.below).union(quantity(self.above)))

    @property
    def index(self) -> flint.arb:
        """A ball that holds the index."""
        with flint.ctx.workprec(4 * KEPT_BITS):
            return flint.arb(_ball(self.below.index).union(_ball(self.above.index)))


def bracket(
    spectrum: Spectrum,
    quantity: Quantity,
    value: Fraction,
    near: Fraction | None = None,
    width: Fraction = Fraction(1, 10**34),
) -> Bracket:
    """The index at which an increasing quantity takes ``value``, to a relative ``width``.

    ``quantity`` returns the ball and its slope. ``near`` is a guess, used to save time and
    not trusted. Raises NotConverged when no index between 2^-2300 and 2^2300 gives the value.
    """
    found = (
        _newton(spectrum, quantity, value, near, width) if near is not None and near > 0 else None
    )
    if found is None:
        found = _newton(spectrum, quantity, value, _search(spectrum, quantity, value), width)
    if found is None:
        raise NotConverged(f"no index found that gives {float(value)!r}")
    return found


def _newton(
    spectrum: Spectrum, quantity: Quantity, value: Fraction, start: Fraction, width: Fraction
) -> Bracket | None:
    at = start
    with flint.ctx.workprec(4 * KEPT_BITS):
        wanted = _ball(value)
    for _ in range(12):
        ball, slope = quantity(enclose(spectrum, at))
        step = (value - distance.middle(ball)) / distance.middle(slope)
        if at + step <= 0:
            return None
        # quadratic convergence: what remains after a relative step d is of order d^2
        near = (step / at) ** 2 < width / 16
        at = _shortened(at + step)
        if not near:
            continue
        low, high = enclose(spectrum, at * (1 - width)), enclose(spectrum, at * (1 + width))
        below, above = quantity(low), quantity(high)
        if below[0] < wanted < above[0] and below[1] > 0 and above[1] > 0:
            return Bracket(low, high)
    return None


def _search(spectrum: Spectrum, quantity: Quantity, value: Fraction) -> Fraction:
    """An index within a part in a thousand, by halving the interval of exponents."""
    low, high = Fraction(-2300), Fraction(2300)
    with flint.ctx.workprec(4 * KEPT_BITS):
        wanted = _ball(value)
    at = Fraction(1)
    for _ in range(23):
        middle = (low + high) / 2
        whole = middle.numerator // middle.denominator
        # between powers of two the halving is by straight lines
        at = Fraction(2) ** whole * (1 + middle - whole)
        if quantity(enclose(spectrum, at))[0] < wanted:
            low = middle
        else:
            high = middle
    return at


def _shortened(value: Fraction) -> Fraction:
    """The value to KEPT_BITS bits."""
    shift = KEPT_BITS - (value.numerator.bit_length() - value.denominator.bit_length())
    return Fraction(int(value * Fraction(2) ** shift)) / Fraction(2) ** shift


def _ball(value: Fraction) -> flint.arb:
    return flint.arb(flint.fmpq(value.numerator, value.denominator))
