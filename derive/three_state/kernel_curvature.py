"""What the kernels of second derivatives have in common: numbers of moderate size, all positive.

See `curvature` for what they mean. With y = 1/eta and t = 3 + 2 a1 y + a2 y^2, so that
2 xi tau = eta^2 t, polynomials in eta become polynomials in y, whose first term leads for a small
index; xi^2 = eta (2 + a1 y), and o = delta/tau, s = e/(delta tau) and d = e/delta^2 carry what is
left. Nothing here over- or underflows where the result does not.
"""

from __future__ import annotations

from collections.abc import Sequence
from dataclasses import dataclass
from fractions import Fraction
from functools import cached_property
from typing import Any

from gainproof.derive.three_state.kernel_basis import KernelBasis
from gainproof.derive.three_state.kernel_forms import HALF, QUARTER, total, weighted


@dataclass(frozen=True)
class Bend:
    """What the second derivatives of one basis share; None stands for what e = 0 makes zero."""

    k: KernelBasis

    @cached_property
    def y(self) -> Any:
        """1/eta."""
        return (self.k.p * QUARTER) / self.k.e

    @cached_property
    def xi(self) -> Any:
        """xi."""
        return (self.k.x / self.k.r) * 2

    @cached_property
    def v(self) -> Any:
        """1/xi."""
        return (self.k.r / self.k.x) * HALF

    @property
    def eta(self) -> Any:
        """eta."""
        return (self.k.e / self.k.p) * 4

    def polynomial(self, *coefficients: Fraction | int) -> Any:
        """A polynomial in y, its lowest coefficient first."""
        return horner(self.y, coefficients)

    @cached_property
    def t(self) -> Any:
        """2 xi tau/eta^2."""
        return self.polynomial(3, 2 * self.k.spectrum.a1, self.k.spectrum.a2)

    @cached_property
    def square(self) -> Any:
        """xi^2/eta."""
        return self.polynomial(2, self.k.spectrum.a1)

    @cached_property
    def cube(self) -> Any:
        """xi^3/tau."""
        return ((self.square * self.square) / self.t) * 2

    @cached_property
    def wide(self) -> Any:
        """(tau - delta)/tau."""
        a1, a2 = self.k.spectrum.a1, self.k.spectrum.a2
        return (self.polynomial(1, a1, a2) / self.t) * 2

    @cached_property
    def low(self) -> Any:
        """(eta + m1)/eta."""
        return self.polynomial(1, self.k.spectrum.m1)

    @cached_property
    def share(self) -> Any:
        """s = e/(delta tau), or None."""
        k = self.k
        if k.spectrum.e == 0:
            return None
        over = ((k.p / k.e) / self.t) * (k.p / k.e)
        return (over * ((k.x / k.r) * (k.p / k.c))) * (k.spectrum.e / 32)

    @cached_property
    def ratio(self) -> Any:
        """d = e/delta^2, or None."""
        k = self.k
        return None if k.spectrum.e == 0 else ((k.index / k.c) / k.c) * (k.spectrum.e / 64)

    @cached_property
    def fall(self) -> Any:
        """omega."""
        k = self.k
        inner = ((k.x / k.e) / (k.e * self.t)) / k.r
        return (inner if k.spectrum.e == 0 else (inner / k.c) / k.p) * 2

    @cached_property
    def part(self) -> Any:
        """o = delta/tau."""
        return self.fall if self.share is None else self.fall + self.share

    @cached_property
    def less(self) -> Any:
        """1 - omega."""
        return total(self.wide, self.share)

    @cached_property
    def much_less(self) -> Any:
        """1 - 2 omega."""
        a1, a2 = self.k.spectrum.a1, self.k.spectrum.a2
        return total(self.polynomial(1, 2 * a1, 3 * a2) / self.t, weighted_or_none(self.share, 2))

    @cached_property
    def slope(self) -> Any:
        """(delta + xi^3)/tau."""
        return self.part + self.cube

    @cached_property
    def slowing(self) -> Any:
        """mu."""
        a1, a2 = self.k.spectrum.a1, self.k.spectrum.a2
        first = self.polynomial(2 * a1, 8 * a2, 2 * a1 * a2) * self.y
        first = (first / self.t) * (self.square / self.t)
        return total(first, self.ratio, times(self.share, self.slope))

    @cached_property
    def growth_over_xi(self) -> Any:
        """psi/(2 xi)."""
        return total(((self.low * self.y) / self.t) * 2, self.share)

    @cached_property
    def growth(self) -> Any:
        """psi/2."""
        return self.growth_over_xi * self.xi

    @cached_property
    def bulk(self) -> Any:
        """(1 - chi) psi/(2 omega xi)."""
        m1 = self.k.spectrum.m1
        first = ((self.part * self.y) * (self.low + self.square)) / self.t * 2
        small = ((self.square * self.y) / self.t) * 2
        second = weighted(small * small, m1)
        return total(first, second, times(self.share, self.slope), times(self.ratio, self.wide))

    @cached_property
    def bent(self) -> Any:
        """chi psi/(2 xi)."""
        s, small = self.k.spectrum, ((self.y / self.t) * (self.square / self.t)) / self.t
        first = small * (self.polynomial(*_unbent(s.a1, s.a2, s.e)) * 8)
        if self.share is None:
            return first
        again = (self.square * self.y) / self.t
        inner = total(
            self.ratio + self.fall,
            weighted(again * again, 4 * s.m1),
            self.share * self.slope,
        )
        return first + self.share * inner


def _unbent(a1: Fraction, a2: Fraction, e: Fraction) -> tuple[Fraction, ...]:
    """The coefficients of `curvature.unbent` from its highest power.

    Raises ArithmeticError where one is negative.
    """
    m1 = a1 - 1
    found = (
        Fraction(3, 4),
        a1,
        3 * a2 / 2 + a1 * m1 / 2 - 9 * e / 2,
        2 * a2 * m1 - (4 * a1 - 3) * e,
        a1 * a2 * m1 / 2 - a2 * a2 / 4 - e * (a1 * a1 - a2 / 2 - a1 - m1),
    )
    if min(found) < 0:
        raise ArithmeticError("no form of chi without subtraction")
    return found


def horner(y: Any, coefficients: Sequence[Any]) -> Any:
    """A polynomial in y, its lowest coefficient first; zeros are left out, one stands for zero."""
    found: Any = None
    for number in reversed(coefficients):
        found = None if found is None else y * found
        if not isinstance(number, (int, Fraction)) or number:
            found = number if found is None else found + number
    return 0 if found is None else found


def weighted_or_none(value: Any, number: Any) -> Any:
    """value times a number, None where either is missing or zero."""
    return None if value is None else weighted(value, number)


def times(value: Any, other: Any) -> Any:
    """The product, or None where the first is None."""
    return None if value is None else value * other
