"""Steps on the width of the step for a small index, where it grows without bound."""

from __future__ import annotations

import sympy as sp

from gainproof.derive.algebra.tower import Generator, Parameter, Tower
from gainproof.derive.derivation import Step
from gainproof.derive.expression import real
from gainproof.derive.relation import equal, monotone
from gainproof.derive.vector_measurement.context import Context
from gainproof.derive.vector_measurement.corners import T, W, X
from gainproof.derive.vector_measurement.steps_limits import times_text
from gainproof.derive.vector_measurement.towers import rational

MORE = sp.Rational(11, 10)
"""The factor that bounds the step."""
OUTER = real("outer")
LATEX = {"outer": "u"}


def outer_tower() -> Tower:
    """x and sqrt(1 + 2 x^2): the shape of P11 where a small index forgets the velocity."""
    generators = (Generator("outer", 1 + 2 * X**2),)
    return Tower("outer", (Parameter("x"),), generators, {})


def small_index_steps(c: Context) -> list[Step]:
    """Where S1 and S2 go as the index falls to 0."""
    d = rational(c.noise.determinant)
    first = d * (MORE**2 - 1)
    outer = X * OUTER / (1 + X**2)
    return [
        Step(
            "width-start-small-trend",
            "Where is `S1` for a small index (large `r`)? There, `t` held, `P11/Lambda` tends to "
            "`w/t`, which falls as `t` grows.",
            monotone(W / T, "decreasing", "t"),
            "Step @small-velocity-index-predicted-11; the derivative is `-1/(w t^2)`.",
            tower="fixed_velocity_index",
        ),
        Step(
            "width-start-small",
            f"It is 1.1 times its limit for large `t` where `1/t^2 = {first}`. So `S1/Lambda` "
            f"tends to the root of {first}, and `r S1` to `{sp.sqrt(16 * first)}`, about "
            f"{float(sp.sqrt(16 * first)):.6f}.",
            equal((W / T) ** 2 - MORE**2 * d, 1 / T**2 - first),
            f"`w^2 = 1 + {times_text(d, 't^2')}` (step @level), so the limit of `w^2/t^2` is {d}; "
            "square `w/t`. `S1/Lambda` is `1/t`, and `r = 4/Lambda`.",
            tower="fixed_velocity_index",
        ),
        Step(
            "width-end-small-trend",
            "And `S2`? For a small index, `x = S/sqrt(Lambda)` held, `P11/sqrt(Lambda)` tends to a "
            "function that grows with `x`; here `u = sqrt(1 + 2 x^2)`.",
            monotone(outer, "increasing", "x"),
            "Step @small-narrow-predicted-11; differentiate.",
            tower="outer",
        ),
        Step(
            "width-end-small",
            "It is its limit `sqrt(2)` over 1.1 where `42 x^4 - 279 x^2 - 200 = 0`. So "
            f"`S2/sqrt(Lambda)` tends to {_narrow_root():.6f}, `sqrt(r) S2` to twice that, and the "
            "width `S2/S1` of the step grows like `sqrt(r)`.",
            equal(
                MORE**2 * outer**2 - 2,
                (42 * X**4 - 279 * X**2 - 200) / (100 * (1 + X**2) ** 2),
            ),
            "Square 1.1 times the function and compare with 2. The quadratic in `x^2` has one "
            "positive root.",
            tower="outer",
        ),
    ]


def _narrow_root() -> float:
    z = sp.Symbol("z", positive=True)
    return float(sp.sqrt(max(sp.solve(42 * z**2 - 279 * z - 200, z))))
