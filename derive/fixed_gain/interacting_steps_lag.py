"""Steps on the steady error of filters with matrix gains behind a constant acceleration."""

from __future__ import annotations

from gainproof.derive.derivation import Step
from gainproof.derive.fixed_gain.interacting_setting import (
    ACCELERATION,
    DRIVE,
    E1,
    E2,
    ERROR,
    HELD,
    K1,
    K2,
    NAME,
    REST,
    SETTING,
    UNIT,
    F,
    H,
    J,
    K,
    T,
)
from gainproof.derive.fixed_gain.interacting_steps_covariance import k2_inverse
from gainproof.derive.fixed_gain.interacting_steps_filter import meaning
from gainproof.derive.relation import cited
from gainproof.derive.source import MATRICES
from gainproof.derive.words.expression import Expression, unit
from gainproof.derive.words.hypotheses import invertible
from gainproof.derive.words.search import Search
from gainproof.derive.words.statement import Statement, prove_equal, prove_invertible

I_ONE = unit("1")
LAG = K2.inverse @ ACCELERATION
NULL = E1 + E2 @ (K1 + T * K2) / T
"""What J - F takes to E2 K2."""


def _of_rest() -> Statement:
    return prove_invertible(
        "rest-inverse", Search(SETTING, [invertible("rest")]), "rest", invertible("rest")
    )


def lag_steps() -> list[Step]:
    """The four steady errors, that they are the only ones, and what K2 has to do with it."""
    k2 = k2_inverse()

    def with_multiple(name: str, left: Expression, right: Expression, row: Expression) -> Statement:
        search = Search(SETTING, [HELD], [k2], multiples=[(row, HELD, I_ONE)])
        return prove_equal(name, search, left, right)

    position = prove_equal(
        "position-lag",
        Search(SETTING, [HELD], [k2], multiples=[(K2.inverse @ E2.T, HELD, I_ONE)]),
        E1.T @ ERROR,
        T * LAG,
    )
    velocity = prove_equal(
        "velocity-lag",
        Search(SETTING, [HELD], [k2, position], multiples=[(E1.T, HELD, I_ONE)]),
        E2.T @ ERROR,
        K1 @ LAG + (T / 2) * ACCELERATION,
    )
    after = (J - K @ H) @ ERROR
    return [
        with_multiple("row-of-velocity", K2 @ E1.T @ ERROR, T * ACCELERATION, E2.T).step(
            "A target of constant acceleration `a` gains `T^2 a/2` in position and `T a` in "
            "velocity in every interval beyond the prediction. An error that stays, `e = F e + "
            "g`, is one whose velocity is corrected by just that:",
            "The velocities of `e = F e + g`: what `K2` takes from the position error is what the "
            "acceleration adds.",
            heading="Steady error behind a constant acceleration",
        ),
        meaning("drive"),
        position.step(
            "So the predicted position is behind by `T K2^-1 a`, as the lecture has it: truth "
            "less prediction, with the sign of `a`, and along another direction than `a` unless "
            "`a` is an eigenvector of `K2`. It needs `K2` to be invertible.",
            "Multiply by `K2^-1`.",
        ),
        velocity.step(
            "The velocity of the same prediction is behind as well:",
            "The positions of `e = F e + g`, and step @position-lag.",
        ),
        prove_equal(
            "updated-position-lag",
            Search(SETTING, [HELD], [k2, position]),
            E1.T @ after,
            T * ((UNIT - K1) @ LAG),
        ).step(
            "The update leaves of both:",
            "Subtract `K E1' e`, and `K2 E1' e = T a`.",
        ),
        prove_equal(
            "updated-velocity-lag",
            Search(SETTING, [HELD], [k2, position, velocity]),
            E2.T @ after,
            K1 @ LAG - (T / 2) * ACCELERATION,
        ).step("", joins=True),
        prove_equal(
            "lag-stays",
            Search(SETTING, [], [k2]),
            E1 @ LAG * T + E2 @ (K1 @ LAG + (T / 2) * ACCELERATION),
            F @ (E1 @ LAG * T + E2 @ (K1 @ LAG + (T / 2) * ACCELERATION)) + DRIVE,
        ).step(
            "Conversely this error stays:",
            "Insert it.",
        ),
        Step(
            "lag-is-reached",
            "Under the eigenvalue criterion every error tends to it.",
            cited(
                "If all eigenvalues of F are smaller than 1 in modulus, then e(k + 1) = F e(k) + "
                "g tends from every start to the only e with e = F e + g.",
                MATRICES.text(),
            ),
            "The mean of step @error-recursion, the noise having mean zero.",
            NAME,
        ),
        prove_equal(
            "velocity-gain-factor",
            Search(SETTING),
            (J - F) @ NULL,
            E2 @ K2,
        ).step(
            "And the criterion gives the inverse of `K2`: it excludes the eigenvalue 1 of `F`, so "
            "`G = J - F` is invertible, and `K2` is then invertible too.",
            "Multiply out; the factor has `I` in its upper block, so `E1' G^-1 E2 K2 = I`, and a "
            "square matrix with a left inverse is invertible.",
        ),
        meaning("rest"),
        _of_rest().step("", joins=True),
        prove_invertible(
            "velocity-gain-invertible",
            Search(
                SETTING,
                [invertible("rest")],
                [_of_rest()],
                multiples=[(E1.T, ("inverse", "rest-inverse", "left"), NULL)],
            ),
            "K2",
            E1.T @ REST.inverse @ E2,
        ).step("", joins=True),
        prove_equal(
            "rest-inverse-blocks",
            Search(SETTING, [], [k2]),
            (J - F)
            @ (E1 @ K2.inverse @ E2.T - E2 @ E1.T / T + E2 @ (K1 + T * K2) @ K2.inverse @ E2.T / T),
            J,
        ).step(
            "Conversely an invertible `K2` makes `J - F` invertible, with the inverse",
            "Multiply out.",
        ),
    ]
