"""Steps on range and range rate, their signs, and how large their parts are."""

from __future__ import annotations

from gainproof.derive.derivation import Step
from gainproof.derive.relation import described
from gainproof.derive.sensors.range_doppler_setting import (
    MOVING,
    NAME,
    ONE,
    RANGE,
    RATE,
    SEEN,
    SETTING,
    STATION,
    STATION_VELOCITY,
    TARGET,
    TARGET_VELOCITY,
    A,
    F,
    G,
    H,
    R,
    U,
    W,
    meaning,
)
from gainproof.derive.words.expression import ZERO, number
from gainproof.derive.words.search import Search
from gainproof.derive.words.statement import Square, prove_equal, prove_order

LENGTHS = ("unit", "1")
"""Inner products are compared as matrices of one row and column, whose unit is positive."""
SYMMETRIC = (R.T @ W, R.T @ A, A.T @ W)


def value_steps() -> list[Step]:
    """What range and range rate are."""
    return [
        Step(
            "sight",
            "A target at `L`, moving with `v_L`, is seen from a station at `B` that moves with "
            "`v_B`, in two, three or any number of dimensions. With `r = L - B` and "
            "`w = v_L - v_B` its range `f` is the length of `r`, and the range rate `g` "
            "is how fast it grows. Inner products "
            "are matrices of one row and one column, whose unit is `I_1`.",
            described("f > 0 with f^2 = r'r, g with f g = r'w: the target is not on the station"),
            "On the station itself the range has no derivative.",
            NAME,
            heading="Range and range rate",
        ),
        prove_equal("unit-length", Search(SETTING, [RANGE]), U.T @ U, ONE).step(
            "The unit vector from the station to the target is called `u`.",
            "Divide by `f`.",
        ),
        meaning("unit"),
        prove_equal("rate", Search(SETTING, [RATE]), U.T @ W, G * ONE).step(
            "So the range rate is the velocity's part along the line of sight, above zero where "
            "the target goes away.",
            "Insert `u`.",
        ),
        prove_equal(
            "printed-rate",
            Search(SETTING, [SEEN, MOVING, RATE]),
            (STATION - TARGET).T @ (STATION_VELOCITY - TARGET_VELOCITY) / F,
            G * ONE,
        ).step(
            "The source prints it with both differences the other way round, which is the same:",
            "Two changes of sign; its equation (19).",
        ),
        prove_equal("across-sight", Search(SETTING, [RANGE, RATE]), U.T @ H, ZERO).step(
            "What of the velocity is across the line of sight, over the range, is called `h`:",
            "`u` takes `g` out of `w`, and `u'u = 1`.",
        ),
        meaning("turning"),
        prove_equal(
            "parts-of-velocity",
            Search(SETTING, [RANGE, RATE], numbers=SYMMETRIC),
            W.T @ W,
            G**2 * ONE + F**2 * (H.T @ H),
        ).step(
            "The two parts of the velocity are perpendicular, so that squares add:",
            "Step @across-sight.",
        ),
        prove_order(
            "turning-size",
            Search(SETTING, [RANGE, RATE], numbers=SYMMETRIC),
            W.T @ W / F**2,
            H.T @ H,
            [Square(G * ONE, LENGTHS, weight=number(1) / F**2)],
        ).step(
            "Hence `|g| <= |w|` and `|h| <= |w|/f`. Where the motion is nearly radial, `w` and "
            "`g u` nearly agree: `h` is a difference that cancels, of condition `|w|/(f |h|)`.",
            "What is left is `g^2/f^2`.",
        ),
        prove_order(
            "rate-size",
            Search(SETTING, [RANGE, RATE], numbers=SYMMETRIC),
            W.T @ W,
            G**2 * ONE,
            [Square(H, ("unit", "d"), weight=F**2)],
        ).step("", joins=True),
    ]
