"""Steps that tie what kernels take of the named curves to the gains; they are not shown."""

from __future__ import annotations

from gainproof.derive.derivation import Step
from gainproof.derive.expression import real
from gainproof.derive.fixed_gain.loop import row
from gainproof.derive.fixed_gain.two_steps_order import lecture_variance
from gainproof.derive.fixed_gain.two_steps_stability import ALPHA, BETA
from gainproof.derive.fixed_gain.two_towers import X
from gainproof.derive.relation import equal


def curve_steps() -> list[Step]:
    """Lag and variance along the stable parts of the curves, for kernels."""
    lag, p11 = real("lag"), real("predicted_11")
    g, modulus = real("g"), real("modulus")
    slow, fast, slower, faster = map(
        real, ("slow_beta", "fast_beta", "slow_variance", "fast_variance")
    )
    return [
        Step(
            "curve-acceleration",
            "Random acceleration with `x = 1 + e`: lag and variance.",
            equal(row(lag, p11), row(1 / BETA, lecture_variance(ALPHA, BETA))),
            "Insert in step @lecture-variance.",
            tower="stable_acceleration",
            shown=False,
        ),
        Step(
            "curve-acceleration-relation",
            "",
            equal((ALPHA + BETA / 2) ** 2, 2 * BETA),
            "",
            tower="stable_acceleration",
            shown=False,
        ),
        Step(
            "curve-velocity",
            "Random velocity with `y` as parameter: lag and variance.",
            equal(row(lag, p11), row(1 / BETA, lecture_variance(ALPHA, BETA))),
            "Insert in step @lecture-variance.",
            tower="stable_velocity",
            shown=False,
        ),
        Step(
            "curve-velocity-relation",
            "",
            equal(row(ALPHA * (ALPHA + BETA), g), row(2 * BETA, 2 * ALPHA / BETA)),
            "",
            tower="stable_velocity",
            shown=False,
        ),
        Step(
            "curve-two-minima",
            "Both filters of minimum variance with one `alpha`: relation and variance.",
            equal(
                row((ALPHA + slow / 2) ** 2, (ALPHA + fast / 2) ** 2),
                row(slow, fast),
            ),
            "Insert.",
            tower="two_minima",
            shown=False,
        ),
        Step(
            "curve-two-minima-variance",
            "",
            equal(
                row(slower, faster),
                row(lecture_variance(ALPHA, slow), lecture_variance(ALPHA, fast)),
            ),
            "",
            tower="two_minima",
            shown=False,
        ),
        Step(
            "curve-modulus",
            "The modulus of a complex pair.",
            equal(row(modulus**2, BETA), row(1 - ALPHA, 2 / (1 + X))),
            "Step @modulus.",
            tower="poles",
            shown=False,
        ),
    ]
