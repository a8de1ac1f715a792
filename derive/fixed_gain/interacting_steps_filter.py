"""Steps on the filter with matrix gains: its blocks, its errors, their covariance."""

from __future__ import annotations

from gainproof.derive.derivation import Step, joined
from gainproof.derive.fixed_gain.interacting_setting import (
    DRIVE,
    E1,
    E2,
    K1,
    K2,
    NAME,
    NEXT_PREDICTED,
    NEXT_TRUTH,
    NOISE,
    OBSERVED,
    PHI,
    PREDICTED,
    SETTING,
    TRUTH,
    UNIT,
    UPDATED,
    F,
    H,
    J,
    K,
    T,
)
from gainproof.derive.relation import definition, described
from gainproof.derive.words.expression import Expression, symbol
from gainproof.derive.words.hypotheses import equation
from gainproof.derive.words.search import Search
from gainproof.derive.words.statement import Statement, prove_equal

SEEN = equation(OBSERVED, H @ TRUTH + NOISE)
MOVED = equation(NEXT_TRUTH, PHI @ TRUTH + DRIVE)


def meaning(name: str) -> Step:
    """A definition shown with the step before it: what a letter of the setting stands for."""
    letter = symbol(name)
    relation = definition(letter.graph, SETTING.elements[name].graph)
    return joined(f"means-{name.lower().replace('_', '-')}", relation, NAME)


def said(name: str, sentence: str, text: str, reason: str, heading: str = "") -> Step:
    """A definition in words."""
    return Step(name, sentence, described(text), reason, NAME, heading=heading)


def _equal(name: str, left: Expression, right: Expression, *given: dict[str, object]) -> Statement:
    return prove_equal(name, Search(SETTING, given), left, right)


def filter_steps() -> list[Step]:
    """From the two equations of the filter to the recursion of its errors."""
    innovation = OBSERVED - E1.T @ PREDICTED
    return [
        said(
            "state",
            "Positions and velocities of `d` coordinates, for any `d` (three in space), tracked "
            "together: the state holds the `d` positions and then the `d` velocities, the "
            "positions are measured. Letters are matrices of any size that fits; nothing below "
            "depends on it.",
            "E1, E2: the first d and the last d columns of J, the unit matrix of the state; I: "
            "the unit matrix of size d; T: the sampling interval",
            "`E1'` takes the positions out of a state, `E2'` the velocities.",
            heading="The filter",
        ),
        meaning("Phi"),
        meaning("H"),
        meaning("K"),
        said(
            "update",
            "The update adds the gain times the innovation to the prediction, and the next "
            "prediction moves on at constant velocity. `K1` and `K2` are full `d` by `d` "
            "matrices: each coordinate may use the innovations of all. They are diagonal for a "
            "filter without interaction.",
            "x_p: prediction; z_o: observed position; x_s: update; x_p+: next prediction",
            "The filter as the lecture writes it, with `K = [K1; K2]`.",
        ),
        meaning("updated"),
        meaning("next_predicted"),
        _equal(
            "updated-position",
            E1.T @ UPDATED,
            E1.T @ PREDICTED + K1 @ innovation,
        ).step(
            "In blocks, the updated position, the updated velocity and the predicted position:",
            "`E1' E1 = I`, `E1' E2 = 0`: multiply out.",
        ),
        _equal(
            "updated-velocity",
            E2.T @ UPDATED,
            E2.T @ PREDICTED + K2 @ innovation,
        ).step("", joins=True),
        _equal(
            "next-position",
            E1.T @ NEXT_PREDICTED,
            E1.T @ UPDATED + T * (E2.T @ UPDATED),
        ).step("", joins=True),
        _equal("position-gain", H @ K, K1).step("", joins=True),
        said(
            "truth",
            "The target moves as predicted but for what drives it, and the position is seen with "
            "noise. The error is the truth less the prediction.",
            "x: the true state; x_+: one interval later; v: noise; g: what drives the target; e = "
            "x - x_p",
            "The model in which the filter's errors are judged.",
        ),
        _equal(
            "error-recursion",
            NEXT_TRUTH - NEXT_PREDICTED,
            F @ (TRUTH - PREDICTED) - PHI @ K @ NOISE + DRIVE,
            SEEN,
            MOVED,
        ).step(
            "Then the errors go on by themselves, with the matrix `F` of the closed loop:",
            "Insert the filter; the truth drops out but for its error.",
        ),
        _equal(
            "error-of-update",
            TRUTH - UPDATED,
            (J - K @ H) @ (TRUTH - PREDICTED) - K @ NOISE,
            SEEN,
        ).step("", joins=True),
        meaning("F"),
        _equal(
            "closed-loop-blocks",
            F,
            E1 @ (UNIT - K1 - T * K2) @ E1.T + T * (E1 @ E2.T) - E2 @ K2 @ E1.T + E2 @ E2.T,
        ).step(
            "The blocks of `F`, and those of what noise enters by:",
            "Multiply out `Phi (J - K H)` and `Phi K`.",
        ),
        _equal("noise-blocks", PHI @ K, E1 @ (K1 + T * K2) + E2 @ K2).step("", joins=True),
    ]
