"""Second derivatives by the index, over the named quantities.

With L = Lambda d/dLambda four powers carry them: -L xi = omega xi, -L omega = mu omega,
L sigma^2 = psi sigma^2 and L psi = (1 - chi) psi. So L eta = -omega xi^2 and
L tau = -omega (delta + xi^3), and for a quantity f that is q times a function of xi, q = Lambda^2,
(q f)'' = 2 f + 3 L f + L L f. What is left of minus signs goes by 2 delta xi = eta^2 - a2 and
xi^2 = a1 + 2 eta. With E = e/delta:

W = delta (eta + m1 + xi^2) + m1 xi^3 + E xi (delta + xi^3 + tau (tau - delta)/delta) gives
1 - chi = omega W/(G tau), G = eta + m1 + E xi; and chi G tau^2 is a polynomial in eta and terms
with E.
"""

from __future__ import annotations

from collections.abc import Mapping

import sympy as sp

from gainproof.derive.three_state.forms import Forms, Numbers
from gainproof.derive.three_state.names import (
    BEND,
    BETA,
    DELTA,
    DEVIATION,
    ETA,
    FALL,
    GAMMA,
    GROWTH,
    INDEX,
    NU,
    SLOWING,
    TAU,
    XI,
)

HALF, QUARTER = sp.Rational(1, 2), sp.Rational(1, 4)


def polynomial(coefficients: Mapping[int, sp.Expr]) -> sp.Expr:
    """A polynomial in eta from its coefficients by powers."""
    return sp.Add(*(value * ETA**power for power, value in coefficients.items()))


def unbent(n: Numbers) -> Mapping[int, sp.Expr]:
    """The coefficients of the polynomial part of chi (eta + m1 + e xi/delta) tau^2."""
    a1, a2, e, m1 = n.a1, n.a2, n.e, n.a1 - 1
    return {
        4: 3 * QUARTER,
        3: a1,
        2: 3 * HALF * a2 + a1 * m1 / 2 - 9 * HALF * e,
        1: 2 * a2 * m1 - (4 * a1 - 3) * e,
        0: a1 * a2 * m1 / 2 - a2**2 / 4 - e * (a1**2 - a2 / 2 - a1 - m1),
    }


def wide(n: Numbers) -> sp.Expr:
    """tau - delta."""
    return (ETA**2 + n.a1 * ETA + n.a2) / XI


def fall(n: Numbers) -> sp.Expr:
    """omega."""
    return (DELTA**2 - n.e) / (DELTA * TAU)


def slowing(n: Numbers) -> sp.Expr:
    """mu."""
    first = polynomial({2: n.a1 / 2, 1: 2 * n.a2, 0: n.a1 * n.a2 / 2}) / TAU**2
    return first + n.e / DELTA**2 + n.e * (DELTA + XI**3) / (DELTA * TAU**2)


def growth(n: Numbers) -> sp.Expr:
    """psi."""
    return 2 * (ETA + n.a1 - 1 + n.e * XI / DELTA) / TAU


def bend(n: Numbers) -> sp.Expr:
    """chi, over omega and psi as well."""
    m1, share = n.a1 - 1, n.e / DELTA
    rest = (
        share**2 / n.e * share * XI * TAU**2 + share * (FALL * TAU**2 * XI + m1 * XI**3)
        if n.e
        else sp.Integer(0)
    )
    rest += share**2 * XI * (DELTA + XI**3)
    return 2 * (polynomial(unbent(n)) + rest) / (GROWTH * TAU**3)


def powers(n: Numbers) -> Forms:
    """The four by name, each over quantities before it."""
    return {"omega": fall(n), "mu": slowing(n), "psi": growth(n), "chi": bend(n)}


def _bulk(n: Numbers) -> sp.Expr:
    """(1 - chi) psi/(2 omega)."""
    m1, share = n.a1 - 1, n.e / DELTA
    rest = share * XI * (DELTA + XI**3 + TAU * wide(n) / DELTA)
    return (DELTA * (ETA + m1 + XI**2) + m1 * XI**3 + rest) / TAU**2


def straightening(n: Numbers) -> sp.Expr:
    """1 - chi."""
    return 2 * FALL * _bulk(n) / GROWTH


def gain_second_derivatives(n: Numbers) -> Forms:
    """The gains' second derivatives, all negative."""
    scale = FALL / INDEX**2
    inner = GROWTH / 2 * (TAU + XI + XI**2) / NU + _bulk(n)
    return {
        "alpha": -GROWTH * (GROWTH + BEND) / (DEVIATION * INDEX) ** 2,
        "beta": -scale * BETA * _second_gain(n) / NU,
        "gamma": -scale * GAMMA * inner,
    }


def _second_gain(n: Numbers) -> sp.Expr:
    """-beta'' nu Lambda^2/(beta omega)."""
    a1, a2, m1, share = n.a1, n.a2, n.a1 - 1, n.e / DELTA
    quartic = polynomial(
        {
            4: 3 * HALF,
            3: 7 * HALF * a1,
            2: 6 * a2 + 3 * HALF * a1**2,
            1: 9 * HALF * a1 * a2,
            0: (a2**2 + a1**2 * a2) / 2,
        }
    )
    square = (3 * ETA**2 + 3 * a1 * ETA + a1**2 - a2) / (XI * TAU**2)
    terms = GROWTH * (ETA + m1) + (ETA + m1) * quartic / (XI * TAU) ** 2
    terms += FALL * XI**2 + FALL * DELTA * TAU * square
    if n.e:
        rest = 2 * share * XI * wide(n) / TAU + (ETA + m1) * share * square
        terms += rest + share / DELTA * (wide(n) + ETA + m1)
    return terms


def of_xi() -> sp.Expr:
    """(q xi)''."""
    return XI * ((1 - FALL) * (2 - FALL) + FALL * SLOWING)


def of_eta() -> sp.Expr:
    """(q eta)''."""
    return 2 * ETA - 3 * FALL * XI**2 + FALL * XI**2 * (SLOWING + 2 * FALL)


def of_tau() -> sp.Expr:
    """(q tau)''."""
    slope = DELTA + XI**3
    return 2 * TAU - 3 * FALL * slope + FALL**2 * (TAU + 3 * XI**3) + FALL * SLOWING * slope


def cross() -> sp.Expr:
    """M12'' over sigma xi/(2 Lambda)."""
    share = GROWTH / 2
    return (1 + share - FALL) * (share - FALL) + share * (1 - BEND) + FALL * SLOWING


def covariance_second_derivatives(n: Numbers) -> Forms:
    """Of both covariances, but for the first row of the updated one, which is the gain."""
    rate, other = of_tau() + of_xi(), of_eta()
    share, sigma = GROWTH / 2, DEVIATION / INDEX
    return {
        "predicted_11": DEVIATION**2 * GROWTH * (GROWTH - BEND) / INDEX**2,
        "predicted_12": sigma * XI / 2 * cross(),
        "predicted_13": sigma * share * (2 + share - BEND),
        "predicted_22": (rate + 2 * other) / 8 + HALF + 2 * n.noise_22,
        "predicted_23": (other + of_xi()) / 4 + HALF + n.noise_23 - 2 * n.noise_13,
        "predicted_33": of_xi() / 2 + 2 * (1 - n.noise_23),
        "updated_22": (rate - 2 * other) / 8 + HALF * (1 - n.a1) + 2 * n.noise_22,
        "updated_23": (other - of_xi()) / 4 + HALF + n.noise_23 - 2 * n.noise_13,
        "updated_33": of_xi() / 2 - 2 * n.noise_23,
    }
