"""The powers of the index that carry second derivatives, and what of these turns.

With L = Lambda d/dLambda: -L xi = omega xi, -L omega = mu omega, L sigma^2 = psi sigma^2 and
L psi = (1 - chi) psi. So L eta = -omega xi^2 and L tau = -omega (delta + xi^3), and for a quantity
f that is q times a function of xi, q = Lambda^2, (q f)'' = 2 f + 3 L f + L L f. What is left of
minus signs goes by 2 delta xi = eta^2 - a2 and xi^2 = a1 + 2 eta.
"""

from __future__ import annotations

from collections.abc import Mapping
from dataclasses import dataclass

import sympy as sp

from gainproof.derive.model import ScaledModel
from gainproof.derive.steady_state.towers import rational
from gainproof.derive.three_state.names import (
    BEND,
    DELTA,
    ETA,
    FALL,
    GROWTH,
    SLOWING,
    TAU,
    XI,
)
from gainproof.derive.three_state.spectrum import Spectrum

HALF, QUARTER = sp.Rational(1, 2), sp.Rational(1, 4)


@dataclass(frozen=True)
class Numbers:
    """a1, a2, e of the family and the entries Q13, Q23 and Q22 - Q12 - Q13/2 - Q23/4."""

    a1: sp.Rational
    a2: sp.Rational
    e: sp.Rational
    noise_13: sp.Rational
    noise_23: sp.Rational
    noise_22: sp.Rational


def numbers(model: ScaledModel, spectrum: Spectrum) -> Numbers:
    """The numbers of a family."""
    noise = model.process_noise
    return Numbers(
        rational(spectrum.a1),
        rational(spectrum.a2),
        rational(spectrum.e),
        noise[0, 2],
        noise[1, 2],
        noise[1, 1] - noise[0, 1] - noise[0, 2] / 2 - noise[1, 2] / 4,
    )


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


def powers(n: Numbers) -> dict[str, sp.Expr]:
    """The four by name, each over quantities before it."""
    return {"omega": fall(n), "mu": slowing(n), "psi": growth(n), "chi": bend(n)}


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


def of_updated_22(n: Numbers) -> sp.Expr:
    """X22''."""
    own = (of_tau() + of_xi() - 2 * of_eta()) / 8
    return own + HALF * (1 - n.a1) + 2 * n.noise_22
