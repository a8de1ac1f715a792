"""First derivatives by the index, over the named quantities, no difference of computed numbers.

With L = Lambda d/dLambda the three equations give L delta = -psi, L xi = -psi xi/tau and
L eta = -psi xi^2/tau, where psi = (delta^2 - e)/delta = 64/(Lambda^2 delta). What looks like a
difference becomes a sum by 2 delta xi = eta^2 - a2 and xi^2 = a1 + 2 eta:

tau - delta = (eta^2 + a1 eta + a2)/xi,
2 tau eta - delta xi^2 = (4 eta^3 + 3 a1 eta^2 + 4 a2 eta + a1 a2)/(2 xi), and
2 tau^2 - delta^2 - delta xi^3, a polynomial in eta over 4 xi^2.
"""

from __future__ import annotations

from dataclasses import dataclass

import sympy as sp

from gainproof.derive.model import ScaledModel
from gainproof.derive.steady_state.towers import rational
from gainproof.derive.three_state.names import (
    DELTA,
    DEVIATION,
    ETA,
    INDEX,
    TAU,
    XI,
)
from gainproof.derive.three_state.spectrum import Spectrum

Forms = dict[str, sp.Expr]


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


def deviation_rate(n: Numbers) -> sp.Expr:
    """(Lambda/sigma) d sigma/d Lambda."""
    return (ETA + n.a1 - 1 + n.e * XI / DELTA) / TAU


def gain_derivatives(n: Numbers) -> Forms:
    """The gains' derivatives by the index."""
    below = DELTA * TAU * DEVIATION**2 * INDEX
    rise = ETA + n.a1 - 1
    return {
        "alpha": 2 * (DELTA * rise + n.e * XI) / below,
        "beta": 4 * (ETA**2 + n.a1 * ETA + n.a2 + XI * rise) / below,
        "gamma": 8 * (TAU + XI + XI**2) / below,
    }


def predicted_derivatives(n: Numbers) -> Forms:
    """The derivatives of the predicted covariance."""
    rate = deviation_rate(n)
    wide = (ETA**2 + n.a1 * ETA + n.a2) / XI  # tau - delta
    first = TAU + wide  # 2 tau - delta
    second = 4 * ETA**3 + 3 * n.a1 * ETA**2 + 4 * n.a2 * ETA + n.a1 * n.a2
    third = (
        9 * ETA**4
        + 16 * n.a1 * ETA**3
        + (6 * n.a1**2 + 22 * n.a2) * ETA**2
        + 16 * n.a1 * n.a2 * ETA
        + n.a2**2
        + 2 * n.a1**2 * n.a2
    )
    share = n.e / DELTA
    return {
        "predicted_11": 2 * DEVIATION**2 * rate / INDEX,
        "predicted_12": XI * DEVIATION / 2 * (wide + ETA + n.a1 - 1 + share * (1 + XI)) / TAU,
        "predicted_13": DEVIATION * (1 + rate),
        "predicted_22": INDEX
        * (
            (
                third / (4 * XI**2)
                + XI * first
                + second / XI
                + share * (DELTA + XI + 2 * XI**2 + XI**3)
            )
            / (8 * TAU)
            + sp.Rational(1, 2)
            + 2 * n.noise_22
        ),
        "predicted_23": INDEX
        * (
            (XI * first + second / (2 * XI) + share * (XI + XI**2)) / (4 * TAU)
            + sp.Rational(1, 2)
            + n.noise_23
            - 2 * n.noise_13
        ),
        "predicted_33": INDEX * (XI * (first + share) / (2 * TAU) + 2 * (1 - n.noise_23)),
    }


def predictor_derivatives(n: Numbers) -> Forms:
    """The derivatives of the predictor gain's first two entries."""
    gains = gain_derivatives(n)
    return {
        "predictor_position": gains["alpha"] + gains["beta"] + gains["gamma"] / 2,
        "predictor_velocity": gains["beta"] + gains["gamma"],
    }
