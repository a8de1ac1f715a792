"""Steps on second derivatives: which entries of the steady state bend down, and which up."""

from __future__ import annotations

from dataclasses import replace
from fractions import Fraction

import sympy as sp

from gainproof.derive.derivation import Step, joined
from gainproof.derive.expression import real
from gainproof.derive.relation import equal, positive
from gainproof.derive.steady_state.context import Context
from gainproof.derive.steady_state.curvature import Curvature
from gainproof.derive.steady_state.curvature_covariances import (
    cross_second_derivative,
    rate_second_derivative,
)
from gainproof.derive.steady_state.curvature_gains import (
    falling_gain_slopes,
    predictor_gain_second_derivatives,
)
from gainproof.derive.steady_state.names import BEND, DEVIATION, GROWTH, INDEX
from gainproof.derive.steady_state.towers import KAPPA, RHO, rational

GAINS = ("alpha", "beta", "predictor_position")


def second(name: str) -> sp.Expr:
    """The second derivative of a named quantity by the index."""
    return sp.Derivative(real(name), (INDEX, 2))


def curvature_steps(c: Context) -> list[Step]:
    """Second derivatives with respect to the index and their signs, but for that of M11."""
    return [*_shares(c), *_gains(c), *_covariances(c)]


def label(prefix: str, name: str) -> str:
    """The id of a step about a named quantity."""
    return f"{prefix}-{name.replace('_', '-')}"


def _shares(c: Context) -> list[Step]:
    named = sp.ImmutableDenseMatrix([[GROWTH * DEVIATION**2, (1 - BEND) * GROWTH]])
    changes = [sp.Derivative(value, INDEX) for value in (DEVIATION**2, GROWTH)]
    rates = sp.ImmutableDenseMatrix([[INDEX * change for change in changes]])
    e = rational(c.e)
    return [
        Step(
            "growth-and-bend",
            "The second derivatives of the first entries need two numbers: near each index "
            "`sigma^2` grows like the power `psi` of the index, and `psi` itself like the power "
            "`1 - chi`.",
            equal(named, rates),
            "Their names.",
            heading="How the steady state bends",
        ),
        Step(
            "growth-by-ratios",
            "Both are quotients of sums without a minus sign.",
            equal(GROWTH, (1 + e / (2 * KAPPA)) / RHO),
            "Insert `sigma` from step @stable-gains, differentiate `kappa` and `rho` in step "
            "@roots-in-the-index, and gather by powers of `kappa`.",
        ),
        joined("bend-by-ratios", equal(BEND, _bend(c.e))),
    ]


def _bend(number: Fraction) -> sp.Expr:
    """chi over kappa and rho."""
    if number == 0:
        return (KAPPA + sp.Rational(1, 2)) / (2 * RHO**2)
    if number == 1:
        return (KAPPA**3 + KAPPA / 4 + sp.Rational(1, 4)) / (2 * KAPPA**2 * RHO**2)
    e = rational(number)
    top = KAPPA**4 + KAPPA**3 / 2 + e * KAPPA**2 / 4 + 3 * e**2 * KAPPA / 8 + (1 + e) * e**2 / 16
    return top / (2 * KAPPA**2 * RHO**2 * (KAPPA + e / 2))


def _gains(c: Context) -> list[Step]:
    """alpha = 1 - 1/sigma^2 and beta bend down."""
    forms = falling_gain_slopes(c.basis)
    forms["predictor_position"] = -predictor_gain_second_derivatives(c.basis)["position"]
    alpha = -GROWTH * (GROWTH + BEND) / (DEVIATION * INDEX) ** 2
    first, *others = (
        joined(label("concave", name), positive(-second(name)), hint={"form": forms[name]})
        for name in GAINS
    )
    return [
        Step(
            "second-derivative-alpha",
            "The second derivatives of the gains.",
            equal(second("alpha"), alpha),
            "Differentiate `alpha = 1 - 1/sigma^2` (step @variance) twice, with step "
            "@growth-and-bend; differentiate `beta` in step @derivative-alpha once more.",
        ),
        joined("second-derivative-beta", equal(second("beta"), -_beta(c.e))),
        _hidden(
            joined(
                "second-derivative-predictor-position",
                equal(second("predictor_position"), second("alpha") + second("beta")),
            )
        ),
        replace(
            first,
            sentence="Both bend down everywhere: the same step of the index adds less and less to "
            "them.",
            reason="But for the minus before them, both forms in step @second-derivative-alpha are "
            "sums, products and quotients of positive terms.",
            joins=False,
        ),
        *(_hidden(step) if step.id.endswith("position") else step for step in others),
    ]


def _hidden(step: Step) -> Step:
    return replace(step, shown=False)


def _beta(number: Fraction) -> sp.Expr:
    """The negative of the second derivative of beta."""
    if number == 0:
        return (2 * RHO + 1) * (6 * RHO + 1) / (16 * RHO**3 * DEVIATION**2 * INDEX)
    scale = (KAPPA * DEVIATION * INDEX) ** 2
    if number == 1:
        top = 3 * RHO**2 + 2 * RHO + 1 + (2 * RHO + 1) / (2 * KAPPA)
        return top / (2 * RHO * scale)
    e = rational(number)
    top = 3 * KAPPA**2 + (1 + 3 * e) * KAPPA + e * (3 + 2 * e) / 4 + 2 * RHO * (KAPPA + e / 2)
    return ((2 * RHO + 1) * e / (4 * KAPPA) + top / (2 * RHO**2)) / (RHO * scale)


def _covariances(c: Context) -> list[Step]:
    """The cross covariance and the velocity's variances bend up."""
    rate = rate_second_derivative(c.basis)
    cross = DEVIATION * GROWTH / (2 * INDEX) * (1 + GROWTH / 2 + (1 - BEND))
    forms = {
        "predicted_12": cross_second_derivative(c.basis),
        "predicted_22": rate + 2,
        "updated_22": rate,
    }
    first, *others = (
        joined(label("convex", name), positive(second(name)), hint={"form": form})
        for name, form in forms.items()
    )
    return [
        Step(
            "second-derivative-predicted-12",
            "And of the covariances.",
            equal(second("predicted_12"), cross),
            "`M12 = Lambda sigma` (step @stable-predicted-11) with step @growth-and-bend; "
            "`M22 = X22 + Lambda^2`, and `X22` as in step @derivative-predicted-11.",
        ),
        joined("second-derivative-predicted-22", equal(second("predicted_22"), rate + 2)),
        joined("second-derivative-updated-22", equal(second("updated_22"), rate)),
        replace(
            first,
            sentence="These bend up everywhere.",
            reason="No minus sign is left but that of `1 - chi`, which is positive: `psi` grows.",
            joins=False,
        ),
        *others,
        joined("growth-grows", positive(1 - BEND), hint={"form": Curvature(c.basis).unbent}),
    ]
