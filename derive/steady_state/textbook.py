"""The steady state as textbooks print it, over the index alone: what kernels are compared with.

These forms subtract computed values and lose digits; nothing is printed from them.
"""

from __future__ import annotations

from collections.abc import Mapping

import sympy as sp

from gainproof.derive.algebra.derivative import by
from gainproof.derive.steady_state.context import Context
from gainproof.derive.steady_state.names import ALPHA, BETA, INDEX
from gainproof.derive.steady_state.spectrum import index_equation
from gainproof.derive.steady_state.towers import rational

Forms = Mapping[str, sp.Expr]


def textbook_gains(c: Context) -> tuple[sp.Expr, sp.Expr]:
    """alpha and beta: solve the equation of sigma for its larger root."""
    sigma = sp.Symbol("innovation_deviation", real=True)
    high = sp.sqrt(16 + rational(c.e) * INDEX**2)
    roots = sp.solve(index_equation(c.spectrum) - high, sigma)
    larger = max(roots, key=lambda root: float(root.subs(INDEX, 1)))
    return 1 - 1 / larger**2, INDEX / larger


def textbook_forms(c: Context) -> Mapping[str, Forms]:
    """Expressions by kernel and output; only kernels of the index."""
    alpha, beta = textbook_gains(c)
    n = rational(c.n)
    values: dict[str, sp.Expr] = {
        "alpha": alpha,
        "beta": beta,
        "position": alpha + beta,
        "velocity": beta,
        "predicted_11": alpha / (1 - alpha),
        "predicted_12": beta / (1 - alpha),
        "predicted_22": beta * (alpha + (1 - n) * beta) / (1 - alpha),
        "updated_11": alpha,
        "updated_12": beta,
        "updated_22": beta * (alpha - n * beta) / (1 - alpha),
    }
    kernels = {
        "gains": ("alpha", "beta"),
        "predictor_gains": ("position", "velocity"),
        "predicted_covariance": ("predicted_11", "predicted_12", "predicted_22"),
        "updated_covariance": ("updated_11", "updated_12", "updated_22"),
    }
    forms: dict[str, Forms] = {}
    for name, outputs in kernels.items():
        forms[name] = {output: values[output] for output in outputs}
        derivatives = {output: by(values[output], INDEX) for output in outputs}
        own = name.removesuffix("s") if name.endswith("gains") else name
        forms[f"{own}_derivatives"] = derivatives
        forms[f"{own}_second_derivatives"] = {
            output: by(value, INDEX) for output, value in derivatives.items()
        }
    forms["gains_with_derivatives"] = {
        **forms["gains"],
        **{f"d_{output}": value for output, value in forms["gain_derivatives"].items()},
    }
    return {**forms, **_inverse_forms(c)}


def _inverse_forms(c: Context) -> Mapping[str, Forms]:
    """Solve the gain relation for the other gain, and put it into Lambda = beta/sqrt(1 - alpha)."""
    relation = c.spectrum.relation
    beta = _root(relation, BETA, ALPHA)
    alpha = _root(relation, ALPHA, BETA)
    return {
        "beta_from_alpha": {"beta": beta},
        "index_from_alpha": {"tracking_index": beta / sp.sqrt(1 - ALPHA)},
        "alpha_from_beta": {"alpha": alpha},
        "index_from_beta": {"tracking_index": BETA / sp.sqrt(1 - alpha)},
    }


def _root(relation: sp.Expr, unknown: sp.Symbol, known: sp.Symbol) -> sp.Expr:
    point = {known: sp.Rational(1, 2)}
    candidates = sp.solve(relation, unknown)
    positive = [root for root in candidates if float(sp.re(root.subs(point))) > 0]
    return min(positive, key=lambda root: float(root.subs(point)))
