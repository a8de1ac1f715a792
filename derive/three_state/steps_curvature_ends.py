"""Steps on the second derivatives at both ends of the index."""

from __future__ import annotations

from collections.abc import Mapping
from dataclasses import replace

import sympy as sp

from gainproof.derive.algebra.derivative import derivative
from gainproof.derive.algebra.tower import Fraction, Tower
from gainproof.derive.derivation import Step, joined
from gainproof.derive.expression import real
from gainproof.derive.relation import limit
from gainproof.derive.three_state import bending, kernel_tower
from gainproof.derive.three_state.context import Context
from gainproof.derive.three_state.names import ALPHA, INDEX, label, second
from gainproof.derive.three_state.steps_ends import entries_over_square
from gainproof.derive.three_state.surds import plain_number

Limits = Mapping[str, tuple[sp.Expr, sp.Expr]]

SMALL = {
    "alpha": (2, 1, "-2/9"),
    "beta": (2, 2, "-1/9"),
    "gamma": (1, 1, "-2/9"),
    "predicted_11": (2, 1, "-2/9"),
    "predicted_12": (2, 2, "-1/9"),
    "predicted_13": (1, 1, "2/9"),
    "predicted_22": (1, 1, "4/9"),
    "predicted_23": (1, 1, "4/9"),
    "predicted_33": (1, 2, "5/9"),
    "updated_22": (1, 1, "-4/9"),
    "updated_23": (1, 1, "4/9"),
    "updated_33": (1, 2, "5/9"),
}
"""The powers of Lambda and 1/alpha by which a second derivative tends to a number, and that number.

For a small index alpha is like 2 Lambda^(1/3), and what grows like c Lambda^n bends like
c n (n - 1) Lambda^(n - 2); gamma, M13, M22 and X22, for which n is 1, bend by their next terms.
"""


def curvature_end_steps(c: Context, plain: Tower) -> list[Step]:
    """Leading behaviour of the second derivatives; `plain` is the tower of second derivatives."""
    small, large = _small(), _far_rational(c, plain) if c.spectrum.rational_in_root else _far(c)
    found = [
        *_limits(
            c,
            "small-second",
            "0",
            small,
            "The second derivatives grow beyond all bounds near a vanishing index, like products "
            "of negative powers of the index and powers of `alpha`, which is like twice its cube "
            "root.",
            "`Lambda^n` bends like `n (n - 1) Lambda^(n - 2)`: insert the powers of step "
            "@small-alpha and the steps after it. Where `n` is 1 there, in `gamma`, `M13`, `M22` "
            "and `X22`, the next terms bend, which are like `Lambda^(4/3)`.",
        ),
        *_limits(
            c,
            "large-second",
            "infinity",
            large,
            "With a large index those of the gains vanish, and the predicted covariance bends "
            "like the process noise.",
            "Differentiate the leading terms of step @large-alpha and the steps after it; for what "
            "tends to a number or grows like the index, the next term.",
        ),
    ]
    name = bending.NAME if c.spectrum.rational_in_root else kernel_tower.NAME
    return [replace(step, tower=name) for step in found]


def _limits(
    c: Context, word: str, point: str, entries: Limits, sentence: str, reason: str
) -> list[Step]:
    own = c.spectrum.rational_in_root
    ends = c.ends if own else kernel_tower.ends(c)
    steps = [
        joined(label(word, name), limit(expression, point, value), hint={"ends": ends})
        for name, (expression, value) in entries.items()
    ]
    if not steps:
        return []
    first, *others = steps
    return [replace(first, sentence=sentence, reason=reason, joins=False), *others]


def _small() -> Limits:
    return {
        name: (second(name) * INDEX**power / ALPHA**other, sp.Rational(value))
        for name, (power, other, value) in SMALL.items()
    }


def _far(c: Context) -> Limits:
    """Where e > 0 all approach their limits like 1/Lambda^2; where e = 0 like 1/Lambda.

    Nothing where b = 0: there they have other powers.
    """
    b, root_e, xi = c.constants.b, c.constants.c, c.constants.least
    if b == 0:
        return {}
    tau, nu = xi * (b + root_e) - root_e, 2 * (xi + root_e)
    rise = tau + xi + xi**2
    power = 4 if c.spectrum.e else 3
    per = 192 / root_e if c.spectrum.e else sp.Integer(16)
    below = tau * nu**2
    found = {
        "alpha": (second("alpha") * INDEX**4, -96 / (xi + root_e) ** 2),
        "beta": (
            second("beta") * INDEX**power,
            -4 * per * xi * (rise - nu) / below,
        ),
        "gamma": (second("gamma") * INDEX**power, -8 * per * rise / below),
    }
    for name, value in entries_over_square(c).items():
        if not c.tower.is_zero(value):
            found[name] = second(name), 2 * value
    return {name: (left, _number(c, value)) for name, (left, value) in found.items()}


def _number(c: Context, value: sp.Expr) -> sp.Expr:
    """A number of the family, the squares of its roots put in."""
    return c.tower.expression(c.tower.fraction(plain_number(value)))


def _far_rational(c: Context, tower: Tower) -> Limits:
    """Where all is rational in the parameter, from the leading powers of it."""
    index = tower.elements[INDEX.name]
    rate, size = _leading(index)
    found = {}
    for name in ("alpha", "beta", "gamma", *entries_over_square(c)):
        slope = tower.expression(derivative(tower, real(name), INDEX.name))
        power, factor = _leading(derivative(tower, slope, INDEX.name))
        whole = sp.Rational(power, rate)
        found[name] = second(name) * INDEX ** (-whole), factor / size**whole
    return found


def _leading(value: Fraction) -> tuple[int, sp.Rational]:
    """The power of p that a fraction goes like for large p, and the factor."""
    above, below = value.num, value.den
    return above.degree() - below.degree(), sp.Rational(str(above.LC / below.LC))
