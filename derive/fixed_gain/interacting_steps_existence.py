"""Steps on whether some gain of the position is best in the steady state, for a given trace."""

from __future__ import annotations

from gainproof.derive.derivation import Step
from gainproof.derive.expression import real
from gainproof.derive.fixed_gain.interacting_setting import (
    E1,
    E2,
    K2,
    LIMIT,
    LIMIT22,
    NAME,
    PHI,
    SETTING,
    STATE,
    UNIT,
    F,
    J,
    K,
    T,
)
from gainproof.derive.fixed_gain.interacting_steps_filter import meaning
from gainproof.derive.fixed_gain.interacting_steps_rows import row_steps
from gainproof.derive.fixed_gain.interacting_steps_sharing import EXAMPLE
from gainproof.derive.relation import cited, equal
from gainproof.derive.source import ELEMENTARY
from gainproof.derive.words.expression import ZERO, unit
from gainproof.derive.words.hypotheses import equation, symmetric
from gainproof.derive.words.search import Search
from gainproof.derive.words.statement import prove_equal

A = real("alpha")
SILENT = equation(STATE.T @ PHI @ K, ZERO)
STILL = equation(STATE.T @ PHI, STATE.T)
KEPT = equation(LIMIT, F @ LIMIT @ F.T)
GROWN = [symmetric("limit"), KEPT]


def existence_steps() -> list[Step]:
    """A limit of gains is stable; where covariances stay bounded; an example where they do not."""
    return [
        Step(
            "minimising-sequence",
            "Is there a best `K1` in the steady state? Let `C > 0` weigh the coordinates and `tr "
            "(C W11)` (NP-P) or `tr (C X11)` (NP-S) be asked for; let `B > 0`, `K2` have an "
            "inverse, and some `K1` be stable. Take stable gains whose trace tends to the "
            "infimum. Their `W11`, or `X11`, is bounded, and by step @position-floor so is `K1`. "
            "If all of `W` is, some of these gains tend to a `K1`, and their `W` to a solution `W "
            ">= 0` of its steady equation with the infimum as its trace. So there is a best gain "
            "if this `K1` is stable and `W` is bounded.",
            cited("A bounded sequence of matrices has a part that converges.", ELEMENTARY.text()),
            "Both sides of the steady equation are continuous in `K1` and `W`.",
            NAME,
            heading="Whether some gain is best in the steady state",
        ),
        *row_steps(),
        *_stable(),
        *_bounded(),
        Step(
            "none-at-two",
            "Without that there may be none. For `d = 1` and `T K2 = beta = 2` the stable filters "
            "are those with `0 < alpha < 1`, and by step @axis-updated the variance of the "
            "updated position is, in units of `B`,",
            equal(
                (2 * A**2 + 4 - 6 * A) / (A * (2 - 2 * A)),
                1 + 2 * (1 - A) / A,
                free=("alpha",),
            ),
            "Common denominator. It falls towards 1 as `alpha` rises to 1, where a pole is -1: "
            "no stable gain has the infimum.",
            EXAMPLE,
        ),
    ]


def _stable() -> list[Step]:
    still = prove_equal(
        "only-velocities",
        Search(SETTING, [STILL], taken=[(unit("1"), STILL, E2)]),
        T * (STATE.T @ E1),
        ZERO,
    )
    heard = Search(SETTING, [SILENT], [still])
    return [
        prove_equal("unheard", Search(SETTING, [SILENT]), STATE.T @ F, STATE.T @ PHI).step(
            "The limit is stable: take `F` for `M`, `W` for `X`, `Phi K B K' Phi'` for `Q`. With "
            "an eigenvalue on or outside the unit circle the left side would not be positive and "
            "the right side not negative; both would be 0, and with `B > 0` either row would be a "
            "`y'` with `y' Phi K = 0`. On such rows `F` acts as `Phi` does, whose eigenvalues are "
            "all 1: `y' Phi = y'`. So `y'` holds velocities only, and these are heard, since `K2` "
            "has an inverse: `y' = 0` for both rows, a contradiction.",
            "`H` follows `Phi K` in `F`; the square of `Phi - J` is 0, so it has no eigenvalue but "
            "0; multiply `y' Phi = y'` by `E2`, and insert.",
        ),
        prove_equal("only-once", Search(SETTING), (PHI - J) @ (PHI - J), ZERO).step("", joins=True),
        still.step("", joins=True),
        prove_equal("heard", heard, STATE.T @ E2 @ K2, ZERO).step("", joins=True),
    ]


def _bounded() -> list[Step]:
    """What a limit of growing covariances would be."""
    ahead, back, on = equation(LIMIT @ E1, ZERO), E1 - T * E2, T * E1 + E2
    updated, turned = equation(LIMIT @ back, ZERO), UNIT - T * K2
    return [
        prove_equal(
            "grown-prediction",
            Search(SETTING, [*GROWN, ahead], taken=[(-E1.T, KEPT, E1)]),
            T**2 * LIMIT22,
            ZERO,
        ).step(
            "If `W` were not bounded, some of the matrices `W/tr W` would tend to a `Y >= 0` of "
            "trace 1, and as all else is bounded `Y = F Y F'`. For NP-P `E1' Y E1 = 0`, so `Y E1 "
            "= 0`, and then `Y22 = 0` and `Y = 0`, which has no trace. So for the predicted "
            "position there is always a best gain.",
            "`E1' F E2 = T I`: the equation between `E1'` and `E1`.",
        ),
        meaning("limit22"),
        prove_equal(
            "grown-update",
            Search(SETTING, [symmetric("limit"), updated]),
            LIMIT,
            on @ LIMIT22 @ on.T,
        ).step(
            "For NP-S `X11` is `(E1 - T E2)' W (E1 - T E2)` by step @smoothed-weight, so `Y (E1 - "
            "T E2) = 0`. Again all of `Y` is known from `Y22`; and for this take `I - T K2` for "
            "`M`, 0 for `Q` in step @along-rows: if no eigenvalue of `I - T K2` has the modulus "
            "1, then `p' Y22 p + q' Y22 q = 0`, so `p' Y22 = 0` and `q' Y22 = 0`, for the first "
            "rows of each chain and then for the next; hence `Y22 = 0` and `Y = 0`. So there is a "
            "best gain for the updated position if no eigenvalue `k` of `T K2` has `|1 - k| = 1`: "
            "if `T K2` is symmetric and positive definite, unless 2 is an eigenvalue.",
            "`Y E1 = T Y E2`; the equation of `Y` between `E2'` and `E2`.",
        ),
        prove_equal(
            "grown-turns",
            Search(SETTING, [*GROWN, updated], taken=[(E2.T, KEPT, E2)]),
            LIMIT22,
            turned @ LIMIT22 @ turned.T,
        ).step("", joins=True),
    ]
