"""Balls as decimal text that encloses them."""

from __future__ import annotations

from decimal import MAX_EMAX, MIN_EMIN, ROUND_CEILING, ROUND_FLOOR, Context, Decimal
from fractions import Fraction

import flint

from gainproof.verify.judge.exact.balls import Balls, NoValue, Unresolved
from gainproof.verify.judge.exact.expression import Expr
from gainproof.verify.judge.exact.polynomial import Ball
from gainproof.verify.judge.exact.statement import NOT_EVALUATED, Enclosure
from gainproof.verify.judge.exact.work_limits import Undecided

MOST_BITS = 200_000
"""Before or after the point, of a number that is written digit by digit."""
MOST_POWER = 10**17
"""Of ten, in what is longer: `Decimal` goes a little farther."""
PRECISION = 256
"""Of logarithms, of which the power of ten takes sixty bits."""
FEW = 12
"""Digits of what is longer, and of a side in a witness."""


def enclosure(ball: Ball, digits: int) -> Enclosure:
    """The ball as decimal text that encloses it. Raises Undecided for a number too long for that:
    e^{e^{40}} has 1e17 digits.
    """
    size = _size(ball)
    if size < -4 * MOST_POWER:
        return Enclosure("0", f"1e-{MOST_POWER}")
    if abs(size) > MOST_BITS:
        return _far(ball)
    middle, radius, exponent = (int(n) for n in ball.mid_rad_10exp(digits))
    while middle % 10 == 0 and radius % 10 == 0 and (middle or radius):
        middle, radius, exponent = middle // 10, radius // 10, exponent + 1
    return Enclosure(_decimal(middle, exponent), _decimal(radius, exponent))


def value_shown(expr: Expr, balls: Balls) -> Enclosure:
    """The value of an expression at the point of these balls, or why it has none: NOT_EVALUATED
    where they do not tell.
    """
    try:
        ball = balls.round(expr)
        return enclosure(ball, FEW) if ball.is_finite() else Enclosure("", "", NOT_EVALUATED)
    except NoValue as reason:
        return Enclosure("", "", str(reason))
    except (Unresolved, Undecided):
        return Enclosure("", "", NOT_EVALUATED)


def is_long(number: Enclosure) -> bool:
    """Whether it has so many digits that exact arithmetic with it would not end."""
    _, _, power = number.midpoint.partition("e")
    return abs(int(power or "0")) > MOST_BITS


def _size(ball: Ball) -> int:
    """It is below 2 to the power of that; 0 of 0."""
    mantissa, exponent = ball.abs_upper().man_exp()
    return int(exponent) + int(mantissa).bit_length() if mantissa else 0


def _far(ball: Ball) -> Enclosure:
    """A few digits and the power of ten, by logarithms."""
    with flint.ctx.workprec(PRECISION):
        ten = flint.arb(10)
        logarithm = abs(ball).log() / ten.log()
        power = logarithm.floor().unique_fmpz() if logarithm.is_finite() else None
        if power is None or abs(int(power)) > 2 * MOST_POWER:
            raise Undecided("a number with too many digits to be written")
        rest = ((logarithm - power) * ten.log()).exp()
    middle, radius, exponent = (int(n) for n in rest.mid_rad_10exp(FEW))
    sign = "-" if ball < 0 else ""
    return Enclosure(f"{sign}{middle}e{exponent + power}", f"{radius}e{exponent + power}")


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
    """Both balls as text that still does not overlap, or None if the balls overlap or are not
    written.
    """
    if a.overlaps(b):
        return None
    if max(abs(_size(a)), abs(_size(b))) > MOST_BITS:
        return _far_apart(a, b)
    for digits in (8, 16, 32, 64, 128, 300, 800, 1500):
        left, right = enclosure(a, digits), enclosure(b, digits)
        gap = abs(_as_fraction(left.midpoint) - _as_fraction(right.midpoint))
        if gap > _as_fraction(left.radius) + _as_fraction(right.radius):
            return left, right
    return None


def _far_apart(a: Ball, b: Ball) -> tuple[Enclosure, Enclosure] | None:
    try:
        left, right = enclosure(a, FEW), enclosure(b, FEW)
    except Undecided:
        return None
    down, up = (
        Context(prec=4 * FEW, rounding=rounding, Emax=MAX_EMAX, Emin=MIN_EMIN)
        for rounding in (ROUND_FLOOR, ROUND_CEILING)
    )
    low, high = sorted((Decimal(left.midpoint), Decimal(right.midpoint)))
    gap = down.subtract(high, low)
    return (left, right) if gap > up.add(Decimal(left.radius), Decimal(right.radius)) else None
