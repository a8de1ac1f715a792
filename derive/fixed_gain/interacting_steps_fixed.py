"""Steps on the best gain of the position where that of the velocity is given: one step."""

from __future__ import annotations

from gainproof.derive.derivation import Step
from gainproof.derive.fixed_gain.interacting_setting import (
    AHEAD,
    BEST,
    CHANGE,
    E1,
    E2,
    FOLLOWED,
    K1,
    K2,
    LEAST,
    NEAR,
    P11,
    P21,
    PHI,
    SETTING,
    UNIT,
    UPDATE,
    B,
    S,
    T,
)
from gainproof.derive.fixed_gain.interacting_steps_best import innovation
from gainproof.derive.fixed_gain.interacting_steps_filter import meaning
from gainproof.derive.words.expression import Expression
from gainproof.derive.words.hypotheses import definite, equation, semidefinite
from gainproof.derive.words.search import Search
from gainproof.derive.words.statement import (
    Square,
    Statement,
    prove_equal,
    prove_equal_by_definite,
    prove_order,
)

GIVEN = [semidefinite("P"), definite("B")]


def smoothed(covariance: Expression) -> Expression:
    """The block of the position of an updated covariance."""
    return E1.T @ covariance @ E1


def predicted(covariance: Expression) -> Expression:
    """The covariance of the position predicted from an updated one."""
    return E1.T @ PHI @ covariance @ PHI.T @ E1


def fixed_steps() -> list[Step]:
    """NP-S and NP-P filters, read as a choice of K1 in each step."""
    known = innovation(SETTING, "position-", B, E1.T)
    positive = known[0]
    return [
        positive.step(
            "The lecture's NP-S and NP-P filters have no process noise and a given gain `K2` of "
            "the velocity; the gain `K1` of the position is to make the covariance of the update "
            "(NP-S) or of the prediction (NP-P) least. That leaves open of which covariance, and "
            "in which step. First reading: in every step, of the position's. With the covariance "
            "`P` of the last prediction the innovation has",
            "As in step @innovation-definite.",
            heading="A given velocity gain: NP-S and NP-P in one step",
        ),
        meaning("S"),
        meaning("P11"),
        meaning("P21"),
        *(statement.step("", joins=True) for statement in known[1:]),
        *_smoothing(known),
        *_prediction(known),
        *_whole_covariance(known),
    ]


def _smoothing(known: list[Statement]) -> list[Step]:
    positive = known[0]
    least = P11 @ S.inverse
    same = equation(smoothed(UPDATE), smoothed(LEAST))
    return [
        prove_order(
            "smoothed-least",
            Search(SETTING, GIVEN, known),
            smoothed(UPDATE),
            smoothed(LEAST),
            [Square((K1 - least).T, positive)],
        ).step(
            "The update's position depends on `K1` alone. It is least, in the order of matrices, "
            "for `K1 = P11 S^-1`, whatever `K2`, and for no other:",
            "Step @completed-square for the position: the difference is `(K1 - P11 S^-1) S (K1 - "
            "P11 S^-1)'`.",
        ),
        meaning("update"),
        meaning("smoothed_gain"),
        meaning("smoothed_update"),
        prove_equal_by_definite(
            "smoothed-only", Search(SETTING, [*GIVEN, same], known), K1, least, positive, "right"
        ).step("", joins=True),
        prove_equal(
            "smoothed-position",
            Search(SETTING, GIVEN),
            smoothed(UPDATE),
            (UNIT - K1) @ P11 @ (UNIT - K1).T + K1 @ B @ K1.T,
        ).step("", joins=True),
        prove_equal("own-gain", Search(SETTING, GIVEN, known), E1.T @ BEST, least).step(
            "That is the position block of Kalman's gain `K_o`; what it leaves of the prediction "
            "is the other share. In one dimension they are `P/(P + B)` and `B/(P + B)`.",
            "`P11 + B` times its inverse.",
        ),
        meaning("best"),
        prove_equal(
            "share-of-noise", Search(SETTING, GIVEN, known), UNIT - least, B @ S.inverse
        ).step("", joins=True),
    ]


def _prediction(known: list[Statement]) -> list[Step]:
    positive = known[0]
    same = equation(predicted(UPDATE), predicted(AHEAD))
    return [
        prove_equal(
            "followed-gain",
            Search(SETTING, GIVEN, known),
            FOLLOWED + T * K2,
            (P11 + T * P21) @ S.inverse,
        ).step(
            "The next prediction's position takes the velocity along, whose gain is given: `K1 + "
            "T K2` is its gain. It is least, again in the order of matrices, for `K1 = K_f` and "
            "for no other, where",
            "The difference is `(K1 - K_f) S (K1 - K_f)'`.",
        ),
        meaning("followed"),
        prove_order(
            "predicted-least",
            Search(SETTING, GIVEN, known),
            predicted(UPDATE),
            predicted(AHEAD),
            [Square((K1 - FOLLOWED).T, positive)],
        ).step("", joins=True),
        meaning("followed_gain"),
        meaning("followed_update"),
        prove_equal_by_definite(
            "predicted-only",
            Search(SETTING, [*GIVEN, same], known),
            K1,
            FOLLOWED,
            positive,
            "right",
        ).step("", joins=True),
        prove_equal(
            "readings-differ",
            Search(SETTING, GIVEN, known),
            E1.T @ BEST - FOLLOWED,
            T * (K2 - E2.T @ BEST),
        ).step(
            "The two gains agree exactly if the given `K2` is Kalman's own, `P21 S^-1`:",
            "Subtract.",
        ),
    ]


def _whole_covariance(known: list[Statement]) -> list[Step]:
    cross = E1 @ CHANGE @ (S @ K2.T - P21.T) @ E2.T
    return [
        prove_equal(
            "whole-covariance",
            Search(SETTING, GIVEN, known),
            NEAR,
            LEAST + E1 @ CHANGE @ S @ CHANGE.T @ E1.T + cross + cross.T,
        ).step(
            "For the covariance of the whole state there is no least one in the order of matrices "
            "unless `K2` is Kalman's: from `K1 = P11 S^-1` a change `D` adds",
            "The velocity block does not change. Where a symmetric matrix has a zero block on its "
            "diagonal, it is only >= 0 if the blocks beside it vanish, that is `D (S K2' - P21') "
            "= 0`; and any other `K1` has a larger position block. In the trace the mixed terms "
            "do not count: `P11 S^-1` is best.",
        ),
        meaning("near_gain"),
        meaning("near_update"),
    ]
