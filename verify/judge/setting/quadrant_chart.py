"""A chart of all pairs (index, S) for position and velocity measured, noises of one source.

Where the covariance of the noise has the determinant 0 the stable factor has the value index at 1
and E at -1, with E^2 = 16 + e A + 4 A / y, and sigma + 1/sigma = M = (index + E) / 2. With
sigma = 1 + s and index = top t / (1 + t), where top is the greatest index for that sigma, all
positive s and t are mapped onto all positive pairs; that is shown, for e = 0 and e = 1.
"""

from __future__ import annotations

from fractions import Fraction

from gainproof.verify.judge.exact.expression import Expr, number, power, symbol
from gainproof.verify.judge.exact.polynomial import Poly, fraction, terms
from gainproof.verify.judge.setting.chart_field import HIGH, LOW, ChartField
from gainproof.verify.judge.setting.environment import NotEstablished
from gainproof.verify.judge.setting.two_measurements import Entries, Noise

SIGMA, T = 1 + symbol(LOW), symbol(HIGH)
HALF = number(Fraction(1, 2))
MIDDLE = SIGMA + 1 / SIGMA
ROOT = SIGMA - 1 / SIGMA


def is_covered(noise: Noise) -> bool:
    """Random velocity and random acceleration: one source of noise, e = 0 or 1."""
    small = 0 <= noise.mixed <= Fraction(1, 2)
    return noise.determinant == 0 and noise.at_minus_one in (0, 1) and small


def sign_on_quadrant(p: Poly, *_: int) -> int | None:
    """1 or -1 where all coefficients of a polynomial in s and t have that sign, else None."""
    signs = {1 if fraction(c) > 0 else -1 for _, c in terms(p)}
    return signs.pop() if len(signs) == 1 else None


def _top(noise: Noise) -> Expr:
    return MIDDLE - 4 / MIDDLE if noise.at_minus_one else 2 * MIDDLE - 4


def coordinates(noise: Noise) -> tuple[Expr, Expr]:
    """index and y = S^2."""
    index = _top(noise) * T / (1 + T)
    other = 2 * MIDDLE - index
    rest = power(other, 2) - 16 - number(noise.at_minus_one) * power(index, 2)
    return index, 4 * power(index, 2) / rest


def squares(noise: Noise) -> tuple[Expr, Expr]:
    """A = index^2 and y = S^2."""
    index, ratio2 = coordinates(noise)
    return power(index, 2), ratio2


def charted_entries(noise: Noise) -> Entries:
    """The covariances in units T = 1 and measured position deviation 1, as they are guessed."""
    c, y = coordinates(noise)
    other, index2 = 2 * MIDDLE - c, power(c, 2)
    e, n = noise.at_minus_one, noise.mixed
    below = power(ROOT, 2) + y
    cross = (HALF * index2 * (MIDDLE - number(1 - 2 * n) * ROOT) + y * c) / below
    inside = c * index2 * (number(e / 4) + 1 / y) + other * index2 * number(Fraction(1, 4))
    whole = (inside + number((1 - 2 * n) / 2) * index2 * ROOT) / below
    u12 = cross / SIGMA
    u22 = (index2 / SIGMA + y * whole) / ROOT
    step = 2 * u12 + u22 + number(noise.position) * index2
    u11 = (whole + step / SIGMA) / ROOT
    return Entries((u11 + step, cross * SIGMA, u22 + index2), (u11, u12, u22))


def refuse_unless_onto(field: ChartField, noise: Noise) -> dict[str, str]:
    """That every pair of positive numbers is (index, y) for positive s and t. Raises
    NotEstablished.

    The pair gives E > 4 and M = (index + E) / 2 > 2, hence sigma > 1, that is s > 0; and E^2 - 16 -
    e A = positive (top - index) shows index < top, hence t > 0.
    """
    index, ratio2 = coordinates(noise)
    other = 2 * MIDDLE - index
    excess = power(other, 2) - 16 - number(noise.at_minus_one) * power(index, 2)
    share = excess / (_top(noise) - index)
    unit = excess - 4 * power(index, 2) / ratio2
    checks = {
        "E^2 = 16 + e A + 4 A / y": field.element(unit).num.is_zero(),
        "E^2 - 16 - e A has the sign of top - index": _positive(field, share),
        "index is positive": _positive(field, index),
        "E is positive": _positive(field, other),
    }
    for words, holds in checks.items():
        if not holds:
            raise NotEstablished(f"the chart is not onto: {words}")
    return dict.fromkeys(checks, "shown")


def _positive(field: ChartField, expr: Expr) -> bool:
    found = field.element(expr)
    top, bottom = field.sign(found.num), field.sign(found.den)
    return top is not None and bottom is not None and top * bottom > 0
