"""Real algebraic numbers: an irreducible polynomial and an interval that holds one of its roots."""

from __future__ import annotations

from dataclasses import dataclass
from fractions import Fraction
from itertools import pairwise
from math import floor
from typing import Any

import flint

from gainproof.verify.judge.exact.polynomial import Ball, exact_value, rational


@dataclass(frozen=True)
class Algebraic:
    """The root of an irreducible integer polynomial (coefficients from power 0 up) in [low, high].

    A rational number has degree 1 and low = high. Otherwise the polynomial changes sign between the
    ends.
    """

    coefficients: tuple[int, ...]
    low: Fraction
    high: Fraction

    @property
    def is_rational(self) -> bool:
        """Whether it is a rational number."""
        return len(self.coefficients) == 2

    def value_at(self, x: Fraction) -> Fraction:
        """The polynomial at a rational point."""
        total = Fraction(0)
        for c in reversed(self.coefficients):
            total = total * x + c
        return total

    def refined(self, width: Fraction) -> Algebraic:
        """The same number in an interval no wider than `width`, by bisection."""
        low, high = self.low, self.high
        if self.is_rational or high - low <= width:
            return self
        rising = self.value_at(low) < 0
        while high - low > width:
            middle = (low + high) / 2
            if (self.value_at(middle) < 0) == rising:
                low = middle
            else:
                high = middle
        return Algebraic(self.coefficients, low, high)

    def ball(self, precision: int) -> Ball:
        """A ball that holds the number, to about `precision` bits, at that working precision."""
        with flint.ctx.workprec(precision + 10):
            if self.is_rational:
                return flint.arb(rational(self.low))
            start = self.refined(Fraction(1, 1 << 20))
            ball = flint.arb(rational(start.low)).union(flint.arb(rational(start.high)))
            return self._newton(start, ball, precision)

    def _newton(self, start: Algebraic, ball: Ball, precision: int) -> Ball:
        """Interval Newton steps; each result encloses the root, and bisection helps where the slope
        is unclear.
        """
        f: Any = flint.arb_poly(list(self.coefficients))
        slope = f.derivative()
        while ball.rad() > abs(ball.mid()) * flint.arb(2) ** -precision:
            steep = slope(ball)
            if steep.contains(0):
                start = start.refined((start.high - start.low) / 1024)
                ball = flint.arb(rational(start.low)).union(flint.arb(rational(start.high)))
                continue
            middle = ball.mid()
            narrow = (middle - f(middle) / steep).intersection(ball)
            if narrow.rad() * 2 > ball.rad():
                return narrow  # as tight as the working precision allows
            ball = narrow
        return ball

    def text(self) -> str:
        """Readable, in closed form up to degree two."""
        if self.is_rational:
            return str(self.low)
        if len(self.coefficients) == 3:
            return self._quadratic_text()
        near = self.refined(Fraction(1, 10**8))
        return f"the root of {self._polynomial_text()} near {_six_digits(near.low)}"

    def _polynomial_text(self) -> str:
        found = ""
        for k, c in reversed(list(enumerate(self.coefficients))):
            if c:
                size = "" if abs(c) == 1 and k else f"{abs(c)}"
                power = "" if k == 0 else "x" if k == 1 else f"x^{k}"
                sign = (" - " if c < 0 else " + ") if found else ("-" if c < 0 else "")
                found += sign + f"{size} {power}".strip()
        return found

    def _quadratic_text(self) -> str:
        c, b, a = self.coefficients
        upper = (self.low + self.high) / 2 > Fraction(-b, 2 * a)
        inside, square = b * b - 4 * a * c, 1
        for factor in range(2, 1000):
            while inside % (factor * factor) == 0:
                inside, square = inside // (factor * factor), square * factor
        centre, spread = Fraction(-b, 2 * a), abs(Fraction(square, 2 * a))
        scale = f"sqrt({inside})" if spread == 1 else f"{spread}*sqrt({inside})"
        sign = "+" if upper else "-"
        return (f"{centre} {sign} {scale}") if centre else (scale if upper else f"-{scale}")


def rational_point(value: Fraction) -> Algebraic:
    """A rational number as an algebraic one."""
    return Algebraic((-value.numerator, value.denominator), value, value)


def real_roots(factor: Any) -> list[Algebraic]:
    """All real roots of an irreducible flint.fmpz_poly."""
    coefficients = tuple(int(c) for c in factor.coeffs())
    if coefficients[-1] < 0:
        coefficients = tuple(-c for c in coefficients)
    if len(coefficients) == 2:
        return [rational_point(Fraction(-coefficients[0], coefficients[1]))]
    found = []
    for root, _ in factor.complex_roots():
        if not root.imag.is_zero():
            continue
        # exact: lower() and upper() would round to the working precision
        middle, radius = exact_value(root.real.mid()), exact_value(root.real.rad())
        low, high = middle - radius, middle + radius
        number = Algebraic(coefficients, low, high)
        if number.value_at(low) * number.value_at(high) >= 0:
            raise ArithmeticError("an isolating interval without a change of sign")
        found.append(number)
    return found


def apart(numbers: list[Algebraic]) -> list[Algebraic]:
    """The numbers in increasing order, in intervals that do not touch; they must be distinct."""
    distinct = list(numbers)
    width = Fraction(1, 1 << 20)
    while True:
        distinct.sort(key=lambda n: n.low)
        if all(a.high < b.low for a, b in pairwise(distinct)):
            return distinct
        width /= 1 << 20
        distinct = [n.refined(width) for n in distinct]


def compare(number: Algebraic, value: Fraction) -> int:
    """Sign of number - value."""
    if number.is_rational:
        return (number.low > value) - (number.low < value)
    while number.low <= value <= number.high:
        number = number.refined((number.high - number.low) / 1024)
    return 1 if number.low > value else -1


def simplest_between(low: Fraction | None, high: Fraction | None) -> Fraction:
    """The rational with the smallest denominator, then the smallest size, strictly between; None is
    unbounded.
    """
    if low is None and high is None:
        return Fraction(0)
    if low is None or (high is not None and high <= 0):
        return -simplest_between(None if high is None else -high, None if low is None else -low)
    if low < 0:
        return Fraction(0)
    whole = floor(low)
    if high is None or whole + 1 < high:
        return Fraction(whole + 1)
    upper = None if low == whole else 1 / (low - whole)
    return whole + 1 / simplest_between(1 / (high - whole), upper)


def rationals_between(low: Fraction | None, high: Fraction | None, count: int) -> list[Fraction]:
    """Rationals strictly between, spread over the interval and simple, the simplest first."""
    gaps = [(low, high)]
    found: list[Fraction] = []
    while len(found) < count:
        left, right = gaps.pop(0)
        middle = simplest_between(left, right)
        found.append(middle)
        gaps += [(left, middle), (middle, right)]
    return sorted(found, key=lambda q: (q.denominator, abs(q)))


def _six_digits(value: Fraction) -> str:
    """Decimal digits of any size."""
    try:
        return f"{float(value):.6g}"
    except OverflowError:
        return str(flint.arb(rational(value)).str(6, radius=False))
