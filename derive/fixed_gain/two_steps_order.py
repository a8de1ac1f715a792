"""Steps on who is better: orderings at equal lag and at equal alpha."""

from __future__ import annotations

import sympy as sp

from gainproof.derive.derivation import Step, joined
from gainproof.derive.expression import real
from gainproof.derive.fixed_gain.loop import row
from gainproof.derive.fixed_gain.two_steps_stability import ALPHA, BETA
from gainproof.derive.fixed_gain.two_towers import X, Y
from gainproof.derive.relation import equal, positive


def ordering_steps() -> list[Step]:
    """Who is better at equal lag, and at equal alpha."""
    return [*_same_lag(), *_same_gain()]


def _same_lag() -> list[Step]:
    tower = "same_lag"
    velocity, acceleration, least = (
        real(f"{name}_alpha") for name in ("velocity", "acceleration", "minimum")
    )
    first, second, third = map(
        real, ("velocity_variance", "acceleration_variance", "minimum_variance")
    )
    g, r, n = map(real, ("g", "r", "n"))
    x, rest = (1 + 2 * Y + 2 * g) / (r + 1), r * (Y + (1 + 2 * Y) / (g + 1)) / (r + 2)
    size = 1 + Y + g
    apart = size * (1 / (g + 1 + r)) / (g * Y * x * rest)
    return [
        Step(
            "same-lag",
            "The three named filters of one `beta`. All three are stable where random velocity is, "
            "`y > 0` of its curve being the parameter; `g` is its `x`.",
            equal(
                row(
                    velocity * (velocity + BETA),
                    (acceleration + BETA / 2) ** 2,
                    (least + BETA / 2) ** 2,
                ),
                row(2 * BETA, 2 * BETA, BETA),
            ),
            "`r = 1 + x` of random acceleration's, `n = 1 + x` of minimum variance's.",
            tower=tower,
            heading="Orderings",
        ),
        joined(
            "same-lag-variances",
            equal(
                row(
                    first * _below(velocity, BETA),
                    second * _below(acceleration, BETA),
                    third * _below(least, BETA),
                ),
                row(*(_above(alpha, BETA) for alpha in (velocity, acceleration, least))),
            ),
            tower=tower,
        ),
        Step(
            "order-at-equal-lag",
            "At equal lag the variance of the predicted position is least for minimum variance, "
            "larger for random acceleration, largest for random velocity, strictly.",
            positive(first - second),
            "The differences, brought to forms without a minus sign.",
            tower=tower,
            hint={"form": apart * _bracket(Y, g, r, x)},
        ),
        joined(
            "order-at-equal-lag-best",
            positive(second - third),
            tower=tower,
            hint={"form": size * (size / (r + n) / ((Y + g) / (n + 1))) ** 2 / (x * rest)},
        ),
    ]


def _bracket(y: sp.Expr, g: sp.Expr, r: sp.Expr, x: sp.Expr) -> sp.Expr:
    """x (1 + x) - y + h x, h = 1/(g + 1 + r), with x (1 + x) - y = 2 + y + 2 g - r."""
    larger = 2 + y + 2 * g
    return (larger**2 - (2 + 2 * y + 2 * g)) / (larger + r) + x / (g + 1 + r)


def _same_gain() -> list[Step]:
    small, large = "same_gain", "same_larger_gain"
    betas = tuple(real(f"{name}_beta") for name in ("velocity", "acceleration", "minimum"))
    velocity, acceleration, least = betas
    first, second, third = map(
        real, ("velocity_variance", "acceleration_variance", "minimum_variance")
    )
    return [
        Step(
            "same-gain",
            "Random velocity and random acceleration of one `alpha` below 1, with `x = 1 + e` that "
            "of the second:",
            equal(
                row(ALPHA * (ALPHA + velocity), (ALPHA + acceleration / 2) ** 2),
                row(2 * velocity, 2 * acceleration),
            ),
            "As steps @random-velocity and @random-acceleration.",
            tower=large,
        ),
        Step(
            "order-at-equal-alpha",
            "At equal `alpha` the order is the other way round: random velocity has the smaller "
            "variance, and pays for it with the larger lag `1/beta`.",
            positive(lecture_variance(ALPHA, acceleration) - lecture_variance(ALPHA, velocity)),
            "Forms without a minus sign.",
            tower=large,
        ),
        joined("order-at-equal-alpha-lag", positive(1 / velocity - 1 / acceleration), tower=large),
        Step(
            "same-smaller-gain",
            "Minimum variance exists for `alpha` up to `1/2`, twice below it. With its `x` as "
            "parameter, above or below 1, all three of one `alpha` are:",
            equal(
                row(
                    ALPHA * (ALPHA + velocity),
                    (ALPHA + acceleration / 2) ** 2,
                    (ALPHA + least / 2) ** 2,
                ),
                row(2 * velocity, 2 * acceleration, least),
            ),
            "`v` is the root of `1 + x^2`.",
            tower=small,
        ),
        joined(
            "same-smaller-gain-variances",
            equal(
                row(
                    *(
                        each * _below(ALPHA, beta)
                        for each, beta in zip((first, second, third), betas, strict=True)
                    )
                ),
                row(*(_above(ALPHA, beta) for beta in betas)),
            ),
            tower=small,
        ),
        Step(
            "order-at-equal-smaller-alpha",
            "There the variance of minimum variance, of either, is the largest of the three. So at "
            "equal `alpha` the order is that at equal lag reversed, without a crossing; it says "
            "which filter follows more closely, not which is better.",
            positive(third - second),
            "Forms without a minus sign.",
            tower=small,
            hint={
                "form": (1 + X) ** 3
                * 2
                * (1 + real("v"))
                / (X**2 * real("v") * (1 + X + real("v")) ** 2)
            },
        ),
        joined("order-at-equal-smaller-alpha-rest", positive(second - first), tower=small),
    ]


def lecture_variance(alpha: sp.Expr, beta: sp.Expr) -> sp.Expr:
    """The lecture's index."""
    return _above(alpha, beta) / _below(alpha, beta)


def _above(alpha: sp.Expr, beta: sp.Expr) -> sp.Expr:
    return 2 * alpha**2 + 2 * beta + alpha * beta


def _below(alpha: sp.Expr, beta: sp.Expr) -> sp.Expr:
    return alpha * (4 - 2 * alpha - beta)
