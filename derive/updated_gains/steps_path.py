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
SO_FAR = real("alpha_so_far"), real("beta_so_far")
FREE = tuple(map(str, SO_FAR))
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
            "The recursive update takes the slopes at the last index each time. Whatever its gains "
            "`A` and `B` are at `Lambda`: at the next index, `Lambda_2`, of which `e` is `g`, they "
            "are too large by what they were before and the error of the tangent.",
            equal(
                row(
                    SO_FAR[0] + NEXT_ALPHA_SLOPE * ON - FOLLOWING_ALPHA,
                    SO_FAR[1] + NEXT_BETA_SLOPE * ON - FOLLOWING_BETA,
                ),
                row(SO_FAR[0] - ALPHA + second[0], SO_FAR[1] - BETA + second[1]),
                free=FREE,
            ),
            "Insert; the tangents' errors are those of step @excess with `e` and `g` for `n` and "
            "`e`. From this follows, by induction: from exact gains on, the error after any number "
            "of steps is the sum of that many tangent errors, none of them negative (step "
            "@never-below).",
            heading="Derivatives taken anew at each step",
        )
    ]


def _cycle() -> list[Step]:
    return [
        Step(
            "cycle",
            "So the gains do not come back with the index. Whatever `A` and `B` they are at the "
            "nominal index, from there to `Lambda` and back they grow by the last terms:",
            equal(
                row(
                    SO_FAR[0] + ALPHA_SLOPE * THERE + NEXT_ALPHA_SLOPE * (NOMINAL - INDEX),
                    SO_FAR[1] + BETA_SLOPE * THERE + NEXT_BETA_SLOPE * (NOMINAL - INDEX),
                ),
                row(SO_FAR[0] + DRIFT_ALPHA, SO_FAR[1] + DRIFT_BETA),
                free=FREE,
            ),
            "Both steps are inserted.",
            heading="What a cycle leaves behind",
        ),
        joined("cycle-value", equal(row(DRIFT_ALPHA, DRIFT_BETA), row(*drifts(N, E)))),
        Step(
            "cycle-grows",
            "That is positive whatever the two indices are, as long as they differ.",
            same_sign(DRIFT_ALPHA, THERE**2),
            "Slopes fall with the index. From this follows with step @cycle: any number of cycles "
            "between the same two indices makes the gains too large by that many times this.",
        ),
        joined("cycle-grows-beta", same_sign(DRIFT_BETA, THERE**2)),
        Step(
            "cycle-margin",
            "Each cycle takes `2` and `1` of these from `4 - 2 alpha - beta`, which is `4/(1 + "
            "n)` at the start.",
            equal(4 - 2 * NOMINAL_ALPHA - NOMINAL_BETA, 4 / (1 + N)),
            "Step @margin. From this follows: cycles between the same two indices, however near to "
            "each other these are, make the filter unstable once there are enough of them. (Of "
            "cycles that become ever smaller nothing is said.)",
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
            "So one step of the index leaves an error of at most its size times the change of the "
            "slope.",
            same_sign(DRIFT_ALPHA - ALPHA_EXCESS, THERE**2),
            "Step @halves: what is left is the other error, which is not negative. From this "
            "follows with step @path, for a path on which the index only grows or only falls, from "
            "exact gains on in steps of at most `h`: the slopes' changes have one sign and add up "
            "to that between the ends, and so the error of the recursive update is at most `h` "
            "times that. For given ends it vanishes with `h`.",
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
