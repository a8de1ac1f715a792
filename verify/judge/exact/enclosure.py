"""Balls as decimal text that encloses them."""

from __future__ import annotations

from fractions import Fraction

from gainproof.verify.judge.exact.poly import Ball
from gainproof.verify.judge.exact.statement import Enclosure


def enclosure(ball: Ball, digits: int) -> Enclosure:
    """The ball as decimal text that encloses it."""
    middle, radius, exponent = (int(n) for n in ball.mid_rad_10exp(digits))
    while middle % 10 == 0 and radius % 10 == 0 and (middle or radius):
        middle, radius, exponent = middle // 10, radius // 10, exponent + 1
    return Enclosure(_decimal(middle, exponent), _decimal(radius, exponent))


def _decimal(mantissa: int, exponent: int) -> str:
    if mantissa == 0 or 0 <= exponent <= 6:
        return str(mantissa * 10 ** max(exponent, 0))
    digits = str(abs(mantissa))
    sign = "-" if mantissa < 0 else ""
    if exponent < 0 and len(digits) > -exponent - 6:
        digits = digits.rjust(1 - exponent, "0")
        return f"{sign}{digits[:exponent]}.{digits[exponent:]}"
    return f"{sign}{digits}e{exponent}"


def _as_fraction(text: str) -> Fraction:
    return Fraction(text)


def separated(a: Ball, b: Ball) -> tuple[Enclosure, Enclosure] | None:
    """Both balls as text that still does not overlap, or None if the balls overlap."""
    if a.overlaps(b):
        return None
    for digits in (8, 16, 32, 64, 128, 300, 800, 1500):
        left, right = enclosure(a, digits), enclosure(b, digits)
        gap = abs(_as_fraction(left.midpoint) - _as_fraction(right.midpoint))
        if gap > _as_fraction(left.radius) + _as_fraction(right.radius):
            return left, right
    return None
