"""Steps on the best gain of the position in the steady state, that of the velocity being given."""

from __future__ import annotations

from gainproof.derive.derivation import Step
from gainproof.derive.fixed_gain.interacting_setting import (
    ADJOINT,
    CHANGE,
    CHANGED,
    E1,
    E2,
    MISFIT,
    OTHER,
    PHI,
    SETTING,
    STEADY,
    SYMMETRIC,
    W11,
    WEIGHT,
    B,
    H,
    K,
    T,
    W,
    closed,
    noisy,
    updated_covariance,
)
from gainproof.derive.fixed_gain.interacting_steps_filter import meaning
from gainproof.derive.words.expression import unit
from gainproof.derive.words.hypotheses import equation, symmetric
from gainproof.derive.words.search import Search
from gainproof.derive.words.statement import Statement, prove_equal
from gainproof.derive.words.traces import prove_traces_equal

LOOP = closed(CHANGED)
OTHER_STEADY = equation(OTHER, noisy(CHANGED, OTHER))
ADJOINT_STEADY = equation(ADJOINT, LOOP.T @ ADJOINT @ LOOP + WEIGHT)
BACK = E1 - T * E2
LINEAR = E1 @ CHANGE @ MISFIT.T
SQUARE = E1 @ CHANGE @ (W11 + B) @ CHANGE.T @ E1.T


def difference() -> Statement:
    """What a change of K1 makes of the steady covariance, exactly."""
    added = LINEAR + LINEAR.T + SQUARE
    return prove_equal(
        "steady-change",
        Search(SETTING, [SYMMETRIC, STEADY, symmetric("B"), OTHER_STEADY]),
        OTHER - W,
        LOOP @ (OTHER - W) @ LOOP.T + added,
    )


def stationary_steps() -> list[Step]:
    """The exact change of the steady covariance, and when it has no part of first order."""
    change = difference()
    return [
        prove_equal(
            "misfit-zero",
            Search(SETTING),
            MISFIT,
            PHI @ (K @ (H @ W @ H.T + B) - W @ H.T),
        ).step(
            "Second reading: in the steady state. There `K1` also changes the `W` that it is to "
            "fit. Let `N` say by how much the gain is not Kalman's own for the steady `W`:",
            "`H = E1'`.",
            heading="A given velocity gain: NP-S and NP-P in the steady state",
        ),
        meaning("misfit"),
        change.step(
            "Let `V` be the steady covariance for `K_D`, which has `K1 + D` in the place of `K1`. "
            "It is known exactly, for changes of any size:",
            "Subtract the two equations; `Phi E1 = E1`.",
        ),
        meaning("changed"),
        prove_traces_equal(
            "trace-change",
            Search(
                SETTING, [SYMMETRIC, STEADY, symmetric("B"), OTHER_STEADY, ADJOINT_STEADY], [change]
            ),
            WEIGHT @ (OTHER - W),
            ADJOINT @ (LINEAR + LINEAR.T + SQUARE),
            [
                (-unit("s"), ADJOINT_STEADY, OTHER - W),
                (ADJOINT, change, unit("s")),
            ],
        ).step(
            "In a trace with any symmetric weight `C`, `C = E1 E1'` for the predicted position, "
            "the sum over all intervals is one matrix `Lambda`, the solution of the transposed "
            "equation:",
            "`tr(A B) = tr(B A)`, and the equation of `Lambda` between the two.",
        ),
        prove_equal(
            "smoothed-weight",
            Search(SETTING, [STEADY], taken=[(-BACK.T, STEADY, BACK)]),
            E1.T @ updated_covariance(K, W) @ E1,
            BACK.T @ W @ BACK,
        ).step(
            "The updated position (NP-S) is another weight of the same `W`, `C = (E1 - T E2) (E1 "
            "- T E2)'`, since without process noise the prediction is the update moved on:",
            "`W = Phi X Phi'` with the update's `X`, and `(E1 - T E2)' Phi = E1'`.",
        ),
        prove_traces_equal(
            "first-order",
            Search(SETTING, [symmetric("adjoint")]),
            ADJOINT @ (LINEAR + LINEAR.T),
            2 * (CHANGE.T @ E1.T @ ADJOINT @ MISFIT),
            [
                (
                    MISFIT @ CHANGE.T @ E1.T,
                    symmetric("adjoint"),
                    unit("s"),
                )
            ],
        ).step(
            "For small `D` the square is of second order and `Lambda` is that of `F`. So a gain "
            "whose trace is stationary obeys the equation of size `d`",
            "The trace of `D' M` vanishes for every `D` only if `M = E1' Lambda N` is zero: `E1' "
            "Lambda Phi (K (W11 + B) - W E1) = 0` with `Lambda = F' Lambda F + C`.",
        ),
    ]
