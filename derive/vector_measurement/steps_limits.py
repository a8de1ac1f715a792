"""Steps on both ends of S: the velocity known exactly, and not measured at all."""

from __future__ import annotations

from dataclasses import replace

import sympy as sp

from gainproof.derive.derivation import Step, joined
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
)
from gainproof.derive.vector_measurement.steps_ties import tie_steps
from gainproof.derive.vector_measurement.towers import rational

AREA = INDEX**2


def limit_steps(c: Context) -> list[Step]:
    """Limits of every entry and gain as S falls to 0 and as it grows without bound."""
    return [*tie_steps(c, "ends"), *_without_velocity(c), *_velocity_known(c)]


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
    first, *others = (_step(c, "infinity", name, claim) for name, claim in claims.items())
    return [
        replace(
            first,
            sentence="As the velocity's error grows without bound, the steady state with measured "
            "position alone returns, which a page of its own derives: its `sigma^o`, its "
            "covariances `P11^o`, `P12^o`, `P22^o` and `U11^o`, `U12^o`, `U22^o`, and its gains "
            "`alpha` and `beta`.",
            reason=f"With `Lambda` held, {_far_text(c)}. Insert this in step "
            "@result; the quotients tend to the other page's formulas.",
            heading="A useless and a perfect measurement of the velocity",
            joins=False,
        ),
        *others,
    ]


def _far_text(c: Context) -> str:
    """What the roots do as S grows without bound, in a sentence."""
    level = "`w` tends to 1, " if c.noise.determinant else ""
    eta = f"`sqrt(16 + {times_text(rational(c.noise.e), 'Lambda^2')})`" if c.noise.e else "4"
    return f"`t` and `kappa` tend to 0, {level}`eta` to {eta}"


def times_text(number: sp.Rational, text: str) -> str:
    """A product with a positive number in a sentence: t^2/12."""
    if number.p == 1:
        return text if number.q == 1 else f"{text}/{number.q}"
    return f"({number}) {text}"


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
    first, *others = (_step(c, "0", name, claim) for name, claim in claims.items())
    named = f"; here `phi = sqrt(Lambda^2 + {16 / noise.e})`" if noise.determinant else ""
    left = (
        "What is left of the position's variance comes from the motion within one interval that "
        "the velocities at its ends do not tell."
        if noise.determinant
        else "The velocities at both ends of an interval tell all of the motion between: nothing "
        "is left of the updated position's variance."
    )
    steps = [
        replace(
            first,
            sentence=f"Now let the velocity's error fall to zero{named}. {left}",
            reason="With `Lambda` held, `t` grows without bound; the leading terms of the roots "
            "grow like powers of `t`. Insert them in step @result.",
            joins=False,
        ),
        *others,
    ]
    if not noise.determinant:
        step = _step(c, "0", "leading_11", (real("updated_11") / RATIO, sp.Integer(1)))
        steps.append(
            replace(
                step,
                sentence="More exactly, `U11` vanishes like `S`.",
                reason="The same leading terms, divided by `S`.",
                joins=False,
            )
        )
    return steps


def _step(c: Context, point: str, name: str, claim: tuple[sp.Expr, sp.Expr]) -> Step:
    expression, value = claim
    hint: dict[str, object] = {"ends": ratio_ends(c.noise)}
    if not _shows(c, point, name):
        stable = stable_forms(c)["updated_11" if name == "leading_11" else name]
        hint["limit_form"] = expression.subs(real(name.replace("leading", "updated")), stable)
    label = {"0": "velocity-known", "infinity": "velocity-absent"}[point]
    step = joined(
        f"{label}-{name.replace('_', '-')}",
        limit(expression, point, value, "velocity_ratio"),
        tower="ends",
        hint=hint,
    )
    # K11 and K21 are U11 and U12
    return replace(step, shown=point == "infinity" or name not in ("gain_11", "gain_21"))


def _shows(c: Context, point: str, name: str) -> bool:
    """Whether the short form of the tower, which subtracts, shows its leading term."""
    if name.startswith(("predicted", "innovation")):
        return True
    if name.endswith("_22") and not c.noise.interval:
        return True
    return point == "0" and name.endswith("_11") and not (c.noise.interval and c.noise.e == 0)
