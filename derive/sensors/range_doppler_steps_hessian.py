"""Steps on second derivatives, each with what is left beyond it, exactly."""

from __future__ import annotations

from gainproof.derive.derivation import Step
from gainproof.derive.relation import described
from gainproof.derive.sensors.range_doppler_setting import (
    BEND,
    DG,
    EXCESS,
    NAME,
    NEW_H,
    NEW_RANGE,
    NEW_RATE,
    RANGE,
    RATE,
    REST,
    SETTING,
    UNIT,
    A,
    B,
    F,
    G,
    H,
    P,
    Q,
    R,
    U,
    V,
    W,
    meaning,
)
from gainproof.derive.words.expression import ZERO, number
from gainproof.derive.words.search import Search
from gainproof.derive.words.statement import Square, prove_equal, prove_order

NUMBERS = (R.T @ A, R.T @ W, A.T @ W, R.T @ B, A.T @ B)
OVER = number(1) / F
EVERY = (RANGE, RATE, NEW_RANGE, NEW_RATE)


def hessian_steps() -> list[Step]:
    """Of the range, then of the range rate."""
    return [
        prove_equal(
            "unit-remainder",
            Search(SETTING, [RANGE, NEW_RANGE], numbers=NUMBERS),
            Q * (V - U - P @ A / F),
            -(((Q - F) / F) * (P @ A)) - U @ EXCESS,
        ).step(
            "The unit vector after a displacement, exactly:",
            "`r + a = f_+ u_+` and `a = P a + u u'a`.",
            heading="Second derivatives",
        ),
        Step(
            "range-hessian",
            "On the right stand products of two changes. So the second derivative of the range by "
            "the target's position is `P/f`; by target and station, or by station and target, it "
            "is `-P/f`, by the station twice `P/f` again.",
            described("du = P (dL - dB)/f, P = I - u u'"),
            "Steps @range-change and @range-remainder: the right side is at most "
            "`(3/2) |a|^2/f` long.",
            NAME,
        ),
        prove_equal("null-direction", Search(SETTING, [RANGE]), P @ U, ZERO).step(
            "It vanishes along the line of sight only, is a projection over `f`, and so is never "
            "below zero.",
            "`u'u = 1`.",
        ),
        prove_equal("projection", Search(SETTING, [RANGE]), P @ P, P).step("", joins=True),
        prove_order(
            "hessian-semidefinite",
            Search(SETTING, [RANGE]),
            P / F,
            ZERO,
            [Square(P, ("unit", "d"), weight=OVER)],
        ).step("", joins=True),
        prove_order(
            "hessian-largest", Search(SETTING), UNIT / F, P / F, [Square(U.T, ("unit", "1"), OVER)]
        ).step("No direction bends it by more than `1/f`:", "The difference is `u u'/f`."),
        prove_equal(
            "turning-remainder",
            Search(SETTING, EVERY, numbers=NUMBERS),
            Q * (NEW_H - H - BEND @ A - P @ B / F),
            -(V @ REST)
            - (V - U) @ DG
            - G * (V - U - P @ A / F)
            - H @ EXCESS
            - (Q - F) * (BEND @ A + P @ B / F),
        ).step(
            "The derivative `h` of the range rate after both changes, exactly; "
            "`f_+ h_+ = w + b - g_+ u_+`:",
            "Steps @rate-remainder and @unit-remainder.",
        ),
        meaning("bend"),
        meaning("new_turning"),
        Step(
            "rate-hessian",
            "Again each term on the right is of second order. So the second derivative of the "
            "range rate by the position is `M`, by position and velocity `P/f`, and by the "
            "velocity it is zero, as `u` does not depend on the velocity. For each of the two that "
            "is taken by the station instead, the sign changes.",
            described("dh = M (dL - dB) + P (dv_L - dv_B)/f"),
            "Steps @rate-remainder-size and @range-hessian.",
            NAME,
        ),
        prove_equal(
            "bend-along", Search(SETTING, [RANGE, RATE], numbers=NUMBERS), BEND @ U, -(H / F)
        ).step(
            "In unit vectors, `h` and `1/f` nothing is larger than the result: no power of the "
            "range is formed, where the quotient rule would print `f^5`. Along the line of sight "
            "`h` falls as `1/f`:",
            "`h'u = 0` and `P u = 0`.",
        ),
    ]
