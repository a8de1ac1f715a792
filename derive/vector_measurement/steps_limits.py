"""Steps on both ends of S: the velocity known exactly, and not measured at all."""

from __future__ import annotations

import sympy as sp

from gainproof.derive.derivation import Step
from gainproof.derive.expression import real
from gainproof.derive.relation import limit
from gainproof.derive.vector_measurement import forms
from gainproof.derive.vector_measurement.context import Context
from gainproof.derive.vector_measurement.ends import FAR, known_updated, ratio_ends
from gainproof.derive.vector_measurement.names import (
    INDEX,
    PREDICTED,
    RATIO,
    SIGMA,
    UPDATED,
    titled,
)
from gainproof.derive.vector_measurement.towers import rational

AREA = INDEX**2


def limit_steps(c: Context) -> list[Step]:
    """Limits of every entry and gain as S falls to 0 and as it grows without bound."""
    return [*_without_velocity(c), *_velocity_known(c)]


def stable_forms(c: Context) -> dict[str, sp.Expr]:
    """Every entry and gain in its form without a subtraction."""
    x = c.basis
    return {**forms.gains(x), **forms.predicted_covariance(x), **forms.updated_covariance(x)}


def _without_velocity(c: Context) -> list[Step]:
    claims = {
        "innovation_ratio": (SIGMA, real("only_innovation_deviation")),
        **{name: (real(name), real(f"only_{name}")) for name in (*PREDICTED, *UPDATED)},
        "gain_11": (real("gain_11"), real("only_alpha")),
        "gain_21": (real("gain_21"), real("only_beta")),
        "gain_12": (RATIO**2 * real("gain_12"), real("only_beta")),
        "gain_22": (RATIO**2 * real("gain_22"), real("only_updated_22")),
    }
    lead = (
        "As the velocity's error grows without bound the steady state with measured position alone "
        "returns (superscript o; its own page derives it)"
    )
    return [
        _step(c, "infinity", name, claim, titled(lead, name, number))
        for number, (name, claim) in enumerate(claims.items())
    ]


def _velocity_known(c: Context) -> list[Step]:
    noise = c.noise
    zero = sp.Integer(0)
    known = known_updated(noise)
    cross: sp.Expr = rational(noise.n)
    if noise.determinant:
        cross = 8 / (rational(noise.e) * (INDEX + FAR) ** 2)
    claims = {
        "updated_11": (real("updated_11"), known),
        "predicted_11": (real("predicted_11"), known + rational(noise.first) * AREA),
        "predicted_12": (real("predicted_12"), rational(noise.n) * AREA),
        "predicted_22": (real("predicted_22"), AREA),
        "updated_12": (real("updated_12"), zero),
        "updated_22": (real("updated_22"), zero),
        "gain_11": (real("gain_11"), known),
        "gain_12": (real("gain_12"), cross),
        "gain_21": (real("gain_21"), zero),
        "gain_22": (real("gain_22"), sp.Integer(1)),
    }
    lead = (
        f"As the velocity's error falls to zero, with phi = sqrt(Lambda^2 + {16 / noise.e})"
        if noise.determinant
        else "As the velocity's error falls to zero"
    )
    steps = [
        _step(c, "0", name, claim, titled(lead, name, number))
        for number, (name, claim) in enumerate(claims.items())
    ]
    if not noise.determinant:
        claim = (real("updated_11") / RATIO, sp.Integer(1))
        text = "The position's variance vanishes like S."
        steps.append(_step(c, "0", "leading_11", claim, text))
    return steps


def _step(c: Context, point: str, name: str, claim: tuple[sp.Expr, sp.Expr], sentence: str) -> Step:
    expression, value = claim
    hint: dict[str, object] = {"ends": ratio_ends(c.noise)}
    if not _shows(c, point, name):
        stable = stable_forms(c)["updated_11" if name == "leading_11" else name]
        hint["limit_form"] = expression.subs(real(name.replace("leading", "updated")), stable)
    label = {"0": "velocity-known", "infinity": "velocity-absent"}[point]
    return Step(
        f"{label}-{name.replace('_', '-')}",
        sentence,
        limit(expression, point, value, "velocity_ratio"),
        "Put the end values of the roots; Lambda is held.",
        tower="ends",
        hint=hint,
        shown=point == "infinity" or name not in ("gain_11", "gain_21"),
    )


def _shows(c: Context, point: str, name: str) -> bool:
    """Whether the short form of the tower, which subtracts, shows its leading term."""
    if name.startswith(("predicted", "innovation")):
        return True
    if name.endswith("_22") and not c.noise.interval:
        return True
    return point == "0" and name.endswith("_11") and not (c.noise.interval and c.noise.e == 0)
