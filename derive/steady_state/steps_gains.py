"""Steps that solve the spectral factorisation for the gains."""

from __future__ import annotations

from fractions import Fraction

import sympy as sp

from gainproof.derive.derivation import Step
from gainproof.derive.expression import real
from gainproof.derive.relation import equal, increasing_onto
from gainproof.derive.steady_state.context import Context
from gainproof.derive.steady_state.names import ALPHA, BETA, DEVIATION, INDEX, ROOT, Z
from gainproof.derive.steady_state.spectrum import V, index_equation
from gainproof.derive.steady_state.towers import KAPPA, RHO, ROOT_S, rational, root_of_16


def _ratio_text(number: Fraction) -> str:
    return "Lambda" if number == 1 else f"({number}) Lambda"


def _high_text(c: Context) -> str:
    if c.e == 0:
        return "eta = 4"
    return "eta^2 = 16 + Lambda^2" if c.e == 1 else f"eta^2 = 16 + ({c.e}) Lambda^2"


def gain_steps(c: Context) -> list[Step]:
    """Spectral factorisation solved for the gains."""
    v = 2 - Z - 1 / Z
    noise = c.spectrum.noise
    closed = c.spectrum.closed_loop
    high, ratio = root_of_16(c.e), rational(c.e)
    total = sp.Rational(1, 2) + KAPPA + RHO
    return [
        Step(
            "parameter",
            "Every positive index is the square of exactly one positive p.",
            increasing_onto(INDEX, sp.Integer(0), "infinity", variable="p"),
            "The square is increasing and unbounded.",
            hint={"form": 2 * ROOT, "ends": c.ends},
        ),
        Step(
            "variance",
            "Spectral factorisation: v^2 + q noise(v) = sigma^2 c(z) c(1/z), with sigma^2 the "
            "innovation variance. Its coefficient at v^2 gives sigma^2.",
            equal(DEVIATION**2, c.spectrum.variance),
            "Compare coefficients of v^2 on both sides.",
        ),
        Step(
            "velocity-gain",
            "At z = 1, where v = 0, the factorisation ties the velocity gain to the index.",
            equal(DEVIATION * BETA, INDEX),
            "The positive square root of q noise(0) = sigma^2 c(1)^2, with q = Lambda^2.",
        ),
        Step(
            "other-end",
            "At z = -1, where v = 4, it gives an equation for sigma alone.",
            equal(index_equation(c.spectrum), high),
            f"The positive square root of 16 + q noise(4) = sigma^2 c(-1)^2, with {_high_text(c)}.",
        ),
        Step(
            "deviation",
            "Its root above 1 is sigma; s is a root of positive terms only.",
            equal(DEVIATION, (ROOT**2 + high + 2 * ROOT * ROOT_S) / 4),
            "The quadratic sigma + 1/sigma = (Lambda + eta)/2, with 4 s^2 = "
            f"{_ratio_text(1 + c.e)} + 2 eta and {_high_text(c)}.",
        ),
        Step(
            "roots",
            "The radicals are the positive roots of positive expressions.",
            equal(
                sp.ImmutableDenseMatrix([[high**2, 4 * ROOT_S**2]]),
                sp.ImmutableDenseMatrix([[16 + ratio * INDEX**2, (1 + ratio) * INDEX + 2 * high]]),
            ),
            f"The defining equations of the tower; {_high_text(c)}.",
        ),
        Step(
            "position-gain",
            "The position gain follows from the variance.",
            equal(ALPHA, ROOT * ROOT_S / DEVIATION),
            "alpha = 1 - 1/sigma^2 and sigma - 1/sigma = p s.",
        ),
        Step(
            "kappa-and-rho",
            "Two quantities carry everything that follows: kappa, and the ratio rho of the gains.",
            equal(
                sp.ImmutableDenseMatrix([[KAPPA, RHO]]),
                sp.ImmutableDenseMatrix([[high / (2 * INDEX), ALPHA / BETA]]),
            ),
            "kappa = eta/(2 Lambda) and rho = s/p.",
        ),
        Step(
            "roots-in-the-index",
            "Both are roots of positive terms in the index.",
            equal(
                sp.ImmutableDenseMatrix([[KAPPA**2, RHO**2]]),
                sp.ImmutableDenseMatrix([[4 / INDEX**2 + ratio / 4, KAPPA + (1 + ratio) / 4]]),
            ),
            "Divide eta^2 by 4 Lambda^2, and s^2 by Lambda.",
        ),
        Step(
            "stable-gains",
            "The innovation's deviation and both gains without a subtraction.",
            equal(
                sp.ImmutableDenseMatrix([[DEVIATION, BETA, ALPHA]]),
                sp.ImmutableDenseMatrix(
                    [[INDEX * total / 2, 2 / total, 2 * RHO / total]],
                ),
            ),
            "sigma is Lambda/4 + eta/4 + p s/2; then beta = Lambda/sigma and alpha = rho beta.",
        ),
        Step(
            "factorisation",
            "With these gains the innovation spectrum factors through the closed-loop polynomial.",
            equal(
                v**2 + INDEX**2 * noise.subs(V, v),
                DEVIATION**2 * closed * closed.subs(Z, 1 / Z),
                free=("z",),
            ),
            "Both sides agree for every z.",
        ),
        Step(
            "gain-relation",
            "Free of the index, the two gains lie on one curve.",
            equal(c.spectrum.relation, sp.Integer(0)),
            "Eliminate q and S from the three coefficients.",
        ),
        Step(
            "predictor-gain",
            "The predictor gain F K adds the velocity gain to the position gain.",
            equal(
                c.model.transition * sp.ImmutableDenseMatrix([[ALPHA], [BETA]]),
                sp.ImmutableDenseMatrix([[real("predictor_position")], [BETA]]),
            ),
            "Multiply out.",
        ),
    ]
