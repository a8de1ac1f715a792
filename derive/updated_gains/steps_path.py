"""Steps on the recursive update: errors add up along a path, and a cycle does not close."""

from __future__ import annotations

from gainproof.derive.derivation import Step, joined
from gainproof.derive.expression import real
from gainproof.derive.fixed_gain.loop import row
from gainproof.derive.relation import equal, positive, same_sign
from gainproof.derive.updated_gains.forms import drifts, excesses
from gainproof.derive.updated_gains.names import (
    ALPHA,
    ALPHA_EXCESS,
    ALPHA_SLOPE,
    BETA,
    BETA_EXCESS,
    BETA_SLOPE,
    FIRST_ALPHA,
    FIRST_BETA,
    FOLLOWING,
    FOLLOWING_ALPHA,
    FOLLOWING_BETA,
    INDEX,
    NEXT_ALPHA_SLOPE,
    NEXT_BETA_SLOPE,
    NOMINAL,
    NOMINAL_ALPHA,
    NOMINAL_BETA,
    E,
    G,
    N,
)

THERE = INDEX - NOMINAL
ON = FOLLOWING - INDEX
BACK_ALPHA, BACK_BETA = real("backward_alpha_excess"), real("backward_beta_excess")
DRIFT_ALPHA = (ALPHA_SLOPE - NEXT_ALPHA_SLOPE) * THERE
DRIFT_BETA = (BETA_SLOPE - NEXT_BETA_SLOPE) * THERE


def path_steps() -> list[Step]:
    """Accumulated errors, the drift of a cycle, bounds, and the two forms against each other."""
    return [*_sum(), *_cycle(), *_bound(), *_compared()]


def _sum() -> list[Step]:
    second = excesses(E, G)
    return [
        Step(
            "path",
            "The recursive update takes the slopes at the last index each time. Its errors add "
            "up: after a second step, to `Lambda_2`, its gains are too large by the error of the "
            "first tangent and that of the second.",
            equal(
                row(
                    FIRST_ALPHA + NEXT_ALPHA_SLOPE * ON - FOLLOWING_ALPHA,
                    FIRST_BETA + NEXT_BETA_SLOPE * ON - FOLLOWING_BETA,
                ),
                row(ALPHA_EXCESS + second[0], BETA_EXCESS + second[1]),
            ),
            "Insert. The exact gains between cancel, for any number of steps: the error after `k` "
            "steps is the sum of `k` tangent errors, none of them negative (step @never-below).",
            heading="Derivatives taken anew at each step",
        )
    ]


def _cycle() -> list[Step]:
    return [
        Step(
            "cycle",
            "So the gains do not come back with the index. From the nominal index to `Lambda` and "
            "back they have grown by",
            equal(
                row(
                    FIRST_ALPHA + NEXT_ALPHA_SLOPE * (NOMINAL - INDEX) - NOMINAL_ALPHA,
                    FIRST_BETA + NEXT_BETA_SLOPE * (NOMINAL - INDEX) - NOMINAL_BETA,
                ),
                row(DRIFT_ALPHA, DRIFT_BETA),
            ),
            "Both steps are inserted.",
            heading="What a cycle leaves behind",
        ),
        joined("cycle-value", equal(row(DRIFT_ALPHA, DRIFT_BETA), row(*drifts(N, E)))),
        Step(
            "cycle-grows",
            "That is positive whatever the two indices are, and the same every time. After `k` "
            "cycles the gains are too large by `k` times that: however small the changes of the "
            "index, if they go on the gains leave the region of "
            "stability.",
            same_sign(DRIFT_ALPHA, THERE**2),
            "Slopes fall with the index.",
        ),
        joined("cycle-grows-beta", same_sign(DRIFT_BETA, THERE**2)),
        Step(
            "cycle-margin",
            "Each cycle takes `2` and `1` of these from `4 - 2 alpha - beta`, which is `4/(1 + "
            "n)` at the start.",
            equal(4 - 2 * NOMINAL_ALPHA - NOMINAL_BETA, 4 / (1 + N)),
            "Step @margin.",
        ),
    ]


def _bound() -> list[Step]:
    return [
        Step(
            "backward",
            "The error of the tangent at `Lambda` when it is used at the nominal index is that of "
            "step @excess with `e` and `n` exchanged,",
            equal(
                row(BACK_ALPHA, BACK_BETA),
                row(
                    ALPHA + NEXT_ALPHA_SLOPE * (NOMINAL - INDEX) - NOMINAL_ALPHA,
                    BETA + NEXT_BETA_SLOPE * (NOMINAL - INDEX) - NOMINAL_BETA,
                ),
            ),
            "Insert.",
            heading="A bound on the error",
        ),
        joined("backward-value", equal(row(BACK_ALPHA, BACK_BETA), row(*excesses(E, N)))),
        Step(
            "halves",
            "and the two errors of there and back make the drift.",
            equal(
                row(ALPHA_EXCESS + BACK_ALPHA, BETA_EXCESS + BACK_BETA),
                row(DRIFT_ALPHA, DRIFT_BETA),
            ),
            "Insert.",
        ),
        Step(
            "bound",
            "So one step of the index by `h` leaves an error of at most `h` times the change of "
            "the slope. Along a path on which the index only grows or only falls, in steps of at "
            "most `h`, these changes add up to that between its ends: the error of the recursive "
            "update is at most `h` times it, and vanishes with `h`.",
            same_sign(DRIFT_ALPHA - ALPHA_EXCESS, THERE**2),
            "Step @halves: what is left is the other error, which is not negative.",
        ),
        joined("bound-beta", same_sign(DRIFT_BETA - BETA_EXCESS, THERE**2)),
    ]


def _compared() -> list[Step]:
    constant = (NOMINAL_ALPHA + ALPHA_SLOPE * (FOLLOWING - NOMINAL)) - (
        FIRST_ALPHA + NEXT_ALPHA_SLOPE * ON
    )
    other = (NOMINAL_BETA + BETA_SLOPE * (FOLLOWING - NOMINAL)) - (
        FIRST_BETA + NEXT_BETA_SLOPE * ON
    )
    return [
        Step(
            "constant-against-recursive",
            "The update with constant derivatives, which never forgets the nominal index, closes "
            "every cycle. After two steps it is larger than the recursive one where both go the "
            "same way, and smaller where the index turns back.",
            same_sign(constant, THERE * ON),
            "The difference is that of the slopes times the second step.",
            heading="Constant or recursive",
        ),
        joined("constant-against-recursive-beta", same_sign(other, THERE * ON)),
        joined("slopes-positive", positive(NEXT_ALPHA_SLOPE)),
        joined("slopes-positive-beta", positive(NEXT_BETA_SLOPE)),
    ]
