"""A chart of all pairs (index, S) for position and velocity measured, continuous white noise of the
acceleration: in it the squares of index and S and all covariances are rational.

With A = index^2 and y = S^2 let m = 1/sqrt(1 + 4 y/A) and m' = (p12 - u12)/(p12 + u12), where p12
and u12 are the predicted and updated cross terms. Both curves n^2 + 2 m^2 = 3 have the rational
point (-1, -1), and m = (3 - w^2)/(w^2 + 2 w + 3), m' = the same of v are the lines through it. The
triangle 0 < v < w < sqrt(3) is mapped onto all positive pairs, which is shown, and so is that the
entries solve the Riccati equation, are positive and come with a stable closed loop.
"""

from __future__ import annotations

from fractions import Fraction

from gainproof.verify.judge.exact.expression import Expr, number, power, symbol
from gainproof.verify.judge.exact.polynomial import Poly, coefficients_in, degree
from gainproof.verify.judge.setting.chart_field import HIGH, LOW, ChartField, Quotient
from gainproof.verify.judge.setting.environment import NotEstablished
from gainproof.verify.judge.setting.triangle_signs import sign_on_triangle
from gainproof.verify.judge.setting.two_measurements import Entries, Noise

V, W = symbol(LOW), symbol(HIGH)
COVERED = Noise(Fraction(1, 3), Fraction(1, 2))


def _cubic(x: Expr) -> Expr:
    return x * (x + 1) * (x + 3)


def _slope(x: Expr) -> Expr:
    """m, falling from 1 to 0 on the side of the triangle."""
    return (3 - power(x, 2)) / _quadratic(x)


def _quadratic(x: Expr) -> Expr:
    return power(x, 2) + 2 * x + 3


def squares() -> tuple[Expr, Expr]:
    """A = index^2 and y = S^2."""
    top = 12 * power(W - V, 2) * power(3 - V * W, 2)
    index2 = top / (_cubic(W) * _cubic(V))
    return index2, top / (_cubic(V) * power(3 - power(W, 2), 2))


def charted_entries() -> Entries:
    """The covariances in units T = 1 and measured position deviation 1, as they are guessed."""
    index2, ratio2 = squares()
    half = number(Fraction(1, 2))
    spread = 2 * (power(3 - V * W, 2) + 3 * power(W - V, 2))
    common = index2 * half * _quadratic(V) * _quadratic(W) / spread
    predicted_12 = common * (1 + _slope(V))
    updated_12 = common * (1 - _slope(V))
    gap = predicted_12 - updated_12
    predicted_22, updated_22 = gap + half * index2, gap - half * index2
    updated_11 = (gap - updated_12 * predicted_22 / ratio2) / predicted_12
    predicted_11 = updated_11 + 2 * updated_12 + updated_22 + index2 * Fraction(1, 3)
    return Entries((predicted_11, predicted_12, predicted_22), (updated_11, updated_12, updated_22))


def refuse_unless_onto(field: ChartField) -> dict[str, str]:
    """That every pair of positive numbers is (A, y) somewhere in the triangle. Raises
    NotEstablished.

    m(w) takes every value between 0 and 1, since it is continuous with 1 and 0 at the ends of the
    side; it is 1/sqrt(1 + 4 y/A) for all v. Along each line of one w, A goes from infinity at
    v = 0 to 0 at v = w, hence takes every positive value.
    """
    index2, ratio2 = squares()
    slope = _slope(W)
    told = {
        "slope": field.element(slope),
        "ratio": field.element(power(slope, 2) * (1 + 4 * ratio2 / index2)),
        "A": field.element(index2),
    }
    side = told["slope"]
    at_zero = _value(side.num, field.high), _value(side.den, field.high)
    three = field.ring.gen(field.high) ** 2 - 3
    checks = {
        "m is 1 for w = 0": at_zero[0] == at_zero[1] and not at_zero[0].is_zero(),
        "m is 0 for w^2 = 3": divmod(side.num, three)[1].is_zero(),
        "m has a value on the side": _signed(field, side.den),
        "m^2 (1 + 4 y/A) = 1": told["ratio"] == Quotient(field.one, field.one),
        "A is infinite for v = 0": _value(told["A"].den, field.low).is_zero()
        and _signed(field, _value(told["A"].num, field.low)),
        "A is 0 for v = w": _on_diagonal(field, told["A"].num).is_zero()
        and _signed(field, _on_diagonal(field, told["A"].den)),
        "A has a value inside": _signed(field, told["A"].den),
    }
    for words, holds in checks.items():
        if not holds:
            raise NotEstablished(f"the chart is not onto: {words}")
    return dict.fromkeys(checks, "shown")


def _value(p: Poly, index: int) -> Poly:
    """The polynomial where one variable is zero."""
    return coefficients_in(p, index)[0]


def _on_diagonal(field: ChartField, p: Poly) -> Poly:
    """The polynomial for v = w."""
    total, w = p - p, field.ring.gen(field.high)
    for power_of_v, part in enumerate(coefficients_in(p, field.low)):
        total = total + part * w**power_of_v
    return total


def _signed(field: ChartField, p: Poly) -> bool:
    """Whether a polynomial has one sign on the open triangle, and so on 0 < w < sqrt(3) if it holds
    w alone.
    """
    only = all(degree(p, i) <= 0 for i in range(field.low))
    factors = p.factor()[1]
    return only and all(sign_on_triangle(f, field.low, field.high) for f, _ in factors)
