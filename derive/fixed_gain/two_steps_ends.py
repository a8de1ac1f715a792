"""Steps on the variance of the predicted position where gains get small or reach a border."""

from __future__ import annotations

import sympy as sp

from gainproof.derive.algebra.limits import End
from gainproof.derive.algebra.tower import Tower
from gainproof.derive.algebra.variables import above_zero
from gainproof.derive.derivation import Step, joined
from gainproof.derive.expression import real
from gainproof.derive.fixed_gain.loop import row
from gainproof.derive.fixed_gain.two_steps_order import lecture_variance
from gainproof.derive.fixed_gain.two_steps_stability import ALPHA, BETA
from gainproof.derive.fixed_gain.two_towers import E, gain_elements, variance_of
from gainproof.derive.relation import equal, limit

P11, M = real("predicted_11"), real("m")
HELD, KALMAN = "held_beta", "kalman_velocity"
RA, MV = "stable_acceleration", "minimum_variance"
ENDS = {"0": End(), "infinity": End()}


def end_towers() -> tuple[Tower, ...]:
    """All stable filters of one beta = 4/(1 + m), and random velocity with x = 2 + e."""
    x, y = M / (1 + E), M * E / (1 + E)
    held = {**gain_elements(x, y), "predicted_11": variance_of(x, y)}
    x, y = 2 + E, (E**2 + 4 * E + 2) / 2
    velocity = {"alpha": 4 / (x + 2), "beta": 8 / (x * (x + 2)), "predicted_11": variance_of(x, y)}
    return (
        Tower(HELD, above_zero("m", "e"), (), held),
        Tower(KALMAN, above_zero("e"), (), velocity),
    )


def end_steps() -> list[Step]:
    """One gain held, then along the named curves."""
    return [*_held(), *_small(), *_border()]


def _tends(
    name: str, expression: sp.Expr, point: str, value: sp.Expr | int | str, tower: str, by: str
) -> Step:
    at = value if isinstance(value, str) else sp.sympify(value)
    return joined(name, limit(expression, point, at, variable=by), tower=tower, hint={"ends": ENDS})


def _held() -> list[Step]:
    return [
        Step(
            "ends-held",
            "With `beta` held, `m = 4/beta - 1`, the filters run from `alpha = 2 - beta/2` at `e = "
            "0` to `alpha = 0` at `e = infinity`. Towards both ends the variance of the predicted "
            "position grows without limit: a small `alpha` alone does not smooth.",
            equal(row(ALPHA, BETA), row(2 * M / ((1 + E) * (1 + M)), 4 / (1 + M))),
            "`x + y = m`.",
            tower=HELD,
            heading="Small gains and borders",
        ),
        joined("ends-held-variance", equal(P11, lecture_variance(ALPHA, BETA)), tower=HELD),
        _tends("ends-held-small", P11, "infinity", "infinity", HELD, "e"),
        _tends("ends-held-border", P11, "0", "infinity", HELD, "e"),
    ]


def _small() -> list[Step]:
    return [
        Step(
            "ends-velocity",
            "Along the named curves it goes to 0 with `alpha`: that of random velocity, with `x = "
            "2 + e`, as `3/4 alpha`.",
            equal(row(ALPHA * (ALPHA + BETA), P11), row(2 * BETA, lecture_variance(ALPHA, BETA))),
            "Insert; highest powers of `e`.",
            tower=KALMAN,
        ),
        _tends("ends-velocity-alpha", ALPHA, "infinity", 0, KALMAN, "e"),
        _tends("ends-velocity-variance", P11, "infinity", 0, KALMAN, "e"),
        _tends("ends-velocity-ratio", P11 / ALPHA, "infinity", sp.Rational(3, 4), KALMAN, "e"),
        Step(
            "ends-acceleration",
            "That of random acceleration, with `x = 1 + e`, goes as `3/4 alpha` too.",
            limit(P11 / ALPHA, "infinity", sp.Rational(3, 4), variable="e"),
            "As before.",
            tower=RA,
            hint={"ends": ENDS},
        ),
        _tends("ends-acceleration-alpha", ALPHA, "infinity", 0, RA, "e"),
        _tends("ends-acceleration-variance", P11, "infinity", 0, RA, "e"),
        Step(
            "ends-minimum",
            "That of the slow minimum variance filter goes as `alpha`. That of the fast one, `x` "
            "towards 0, grows without limit as its `alpha` gets small.",
            limit(P11 / ALPHA, "infinity", sp.Integer(1), variable="x"),
            "As before.",
            tower=MV,
            hint={"ends": ENDS},
        ),
        _tends("ends-minimum-alpha", ALPHA, "infinity", 0, MV, "x"),
        _tends("ends-fast-alpha", ALPHA, "0", 0, MV, "x"),
        _tends("ends-fast-variance", P11, "0", "infinity", MV, "x"),
    ]


def _border() -> list[Step]:
    return [
        Step(
            "ends-border-acceleration",
            "Towards `alpha = 1` random acceleration loses its stability and its variance grows "
            "without limit.",
            limit(P11, "0", "infinity", variable="e"),
            "`e` towards 0.",
            tower=RA,
            hint={"ends": ENDS},
        ),
        _tends("ends-border-acceleration-alpha", ALPHA, "0", 1, RA, "e"),
        Step(
            "ends-border-velocity",
            "Random velocity stays stable there and reaches 5.",
            limit(P11, "0", sp.Integer(5), variable="e"),
            "`e` towards 0: `alpha = beta = 1`.",
            tower=KALMAN,
            hint={"ends": ENDS},
        ),
        _tends("ends-border-velocity-alpha", ALPHA, "0", 1, KALMAN, "e"),
    ]
