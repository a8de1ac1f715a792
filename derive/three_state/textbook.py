"""The steady state by Cardano's formula, over the index alone: what kernels are compared with.

Where all is rational in s = sqrt(1 - alpha), as in the literature on filters of three states:
s^3 + (Lambda/2 - 3) s^2 + (Lambda/2 + 3) s - 1 = 0, alpha = 1 - s^2, beta = 2 (1 - s)^2 and
gamma = beta^2/(2 alpha). Elsewhere no closed form is in print; G = -4/v, with the negative root v
of v^3 + Lambda^2 noise(v), solves a cubic too, and d(s) has the factors 1 + t s and 1 + a s + g s^2
with t^2 = 1 + G, g^2 = G^2 + (1 - m1) G + m2 and a^2 = m1 + 2 g - G. Both forms subtract computed
values, lose digits and give no number for some large index (the first beyond 18), where the number
under a root of theirs is negative; nothing is printed from them.
"""

from __future__ import annotations

from collections.abc import Mapping

import sympy as sp

from gainproof.derive.algebra.derivative import by
from gainproof.derive.steady_state.towers import rational
from gainproof.derive.three_state.context import Context
from gainproof.derive.three_state.curvature import numbers
from gainproof.derive.three_state.names import INDEX

Forms = Mapping[str, sp.Expr]


def _root(second: sp.Expr, first: sp.Expr, constant: sp.Expr, sign: int) -> sp.Expr:
    """The real root of x^3 + second x^2 + first x + constant where there is one; the sign is that
    of the cube root taken.
    """
    p = first - second**2 / 3
    q = 2 * second**3 / 27 - second * first / 3 + constant
    outside = sp.sqrt(q**2 / 4 + p**3 / 27)
    z = sign * sp.cbrt(-sign * q / 2 + outside)
    return z - p / (3 * z) - second / 3


def textbook_gains(c: Context) -> tuple[sp.Expr, sp.Expr, sp.Expr]:
    """alpha, beta and gamma."""
    if c.spectrum.rational_in_root:
        s = _root(INDEX / 2 - 3, INDEX / 2 + 3, sp.Integer(-1), -1)
        beta = 2 * (1 - s) ** 2
        return 1 - s**2, beta, beta**2 / (2 * (1 - s**2))
    m1, m2 = rational(c.spectrum.m1), rational(c.spectrum.m2)
    level = _root(2 - m1, 1 - m1 + m2, -64 / INDEX**2, 1)
    t, g = sp.sqrt(1 + level), sp.sqrt(level**2 + (1 - m1) * level + m2)
    a = sp.sqrt(m1 + 2 * g - level)
    below = (1 + t) * (1 + a + g)
    return 2 * (1 + t * a + g) / below, 4 * (t + a) / below, 8 / below


def textbook_forms(c: Context) -> Mapping[str, Forms]:
    """Expressions by kernel and output; only kernels of the index."""
    alpha, beta, gamma = textbook_gains(c)
    values = {
        "alpha": alpha,
        "beta": beta,
        "gamma": gamma,
        "position": alpha + beta + gamma / 2,
        "velocity": beta + gamma,
        "acceleration": gamma,
        "innovation_deviation": 1 / sp.sqrt(1 - alpha),
        **_covariances(c, alpha, beta, gamma),
    }
    kernels: dict[str, tuple[str, ...]] = {
        "gains": ("alpha", "beta", "gamma"),
        "predictor_gains": ("position", "velocity", "acceleration"),
        "predicted_covariance": tuple(name for name in values if name.startswith("predicted")),
        "updated_covariance": tuple(name for name in values if name.startswith("updated")),
    }
    forms: dict[str, Forms] = {
        "innovation_deviation": {"innovation_deviation": values["innovation_deviation"]}
    }
    for name, outputs in kernels.items():
        forms[name] = {output: values[output] for output in outputs}
        own = name.removesuffix("s") if name.endswith("gains") else name
        forms[f"{own}_derivatives"] = {output: by(values[output], INDEX) for output in outputs}
    forms["gains_with_derivatives"] = {
        **forms["gains"],
        **{f"d_{output}": value for output, value in forms["gain_derivatives"].items()},
    }
    return forms


def _covariances(c: Context, alpha: sp.Expr, beta: sp.Expr, gamma: sp.Expr) -> dict[str, sp.Expr]:
    """From the gains, entry by entry of M = F X F' + Q and X = M - K K' sigma^2."""
    n, area, variance = numbers(c.model, c.spectrum), INDEX**2, 1 / (1 - alpha)
    third = beta * gamma * variance - area * n.noise_23
    second = (alpha * gamma + beta * gamma / 2) * variance
    cross = second + area * (n.noise_23 / 2 - n.noise_13) - beta * gamma * variance
    rate = (alpha * beta - gamma + 3 * alpha * gamma / 2 + beta * gamma / 4) * variance
    rate += area * n.noise_22 - beta**2 * variance
    return {
        "predicted_11": alpha * variance,
        "predicted_12": beta * variance,
        "predicted_13": gamma * variance,
        "predicted_22": rate + beta**2 * variance,
        "predicted_23": cross + beta * gamma * variance,
        "predicted_33": third + gamma**2 * variance,
        "updated_11": alpha,
        "updated_12": beta,
        "updated_13": gamma,
        "updated_22": rate,
        "updated_23": cross,
        "updated_33": third,
    }
