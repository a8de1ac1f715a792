"""Steps on derivatives: what is left of range and range rate beyond the linear part, exactly."""

from __future__ import annotations

from gainproof.derive.derivation import Step
from gainproof.derive.relation import cited, described
from gainproof.derive.sensors.range_doppler_setting import (
    DG,
    EXCESS,
    NAME,
    NEW_RANGE,
    NEW_RATE,
    ONE,
    RANGE,
    RATE,
    REST,
    SEEN,
    SETTING,
    STATION,
    TARGET,
    A,
    B,
    F,
    G,
    P,
    Q,
    R,
    U,
    V,
    W,
    meaning,
)
from gainproof.derive.source import ELEMENTARY
from gainproof.derive.words.expression import ZERO, number
from gainproof.derive.words.search import Search
from gainproof.derive.words.statement import Square, Statement, prove_equal, prove_order

LENGTHS = ("unit", "1")
NUMBERS = (R.T @ A, R.T @ W, A.T @ W, R.T @ B, A.T @ B)
MOVED = (RANGE, NEW_RANGE)
EVERY = (RANGE, RATE, NEW_RANGE, NEW_RATE)


def never_below() -> Statement:
    """The range is convex."""
    return prove_order(
        "range-convex",
        Search(SETTING, MOVED, numbers=NUMBERS),
        EXCESS,
        ZERO,
        [Square(V - U, ("unit", "d"), weight=Q / 2)],
    )


def range_steps() -> list[Step]:
    """The range after a displacement."""
    convex = never_below()
    return [
        Step(
            "displaced",
            "Let the target move by `a`, to a place that is not the station: the range becomes "
            "`f_+`, the unit vector `u_+`. What `u'a` does not say of the change is `e`:",
            described("f_+ > 0 with f_+^2 = (r + a)'(r + a)"),
            "These are the definitions.",
            NAME,
            heading="Derivative of the range",
        ),
        meaning("excess"),
        convex.step(
            "It is never below zero: the range is convex.",
            "It is half of `f_+ |u_+ - u|^2`.",
        ),
        meaning("new_unit"),
        prove_order(
            "range-remainder",
            Search(SETTING, MOVED, numbers=NUMBERS),
            A.T @ A / (2 * F),
            EXCESS,
            [Square((Q - F) * ONE, LENGTHS, weight=number(1) / (2 * F))],
        ).step(
            "And it is at most `|a|^2/(2 f)`, however far the target moves.",
            "The difference is `(f_+ - f)^2/(2 f)`.",
        ),
        prove_equal(
            "range-remainder-across",
            Search(SETTING, MOVED, numbers=NUMBERS),
            (F + Q) * EXCESS + EXCESS @ (U.T @ A),
            A.T @ P @ A,
        ).step(
            "Exactly, it is what is across the line of sight that counts: `e (f + f_+ + u'a) = "
            "|P a|^2`, with `P = I - u u'`. As `f_+` is at least `f + u'a`, `e` is at most "
            "`|P a|^2/(2 (f + u'a))` wherever `f + u'a` is above zero.",
            "`f_+^2 = (f + u'a)^2 + |P a|^2`.",
        ),
        meaning("across"),
        Step(
            "range-gradient",
            "So `f_+ - f - u'a` is of second order in `a`: by definition the derivative of the "
            "range by the target's position is `u'`, equations (9) and (10) of the source. By the "
            "station's position it is `-u'`, since `r` changes by the opposite:",
            described("df = u'(dL - dB); the range does not depend on the velocities"),
            "Steps @range-convex and @range-remainder.",
            NAME,
        ),
        prove_equal("target-moves", Search(SETTING, [SEEN]), (TARGET + A) - STATION, R + A).step(
            "", joins=True
        ),
        prove_equal("station-moves", Search(SETTING, [SEEN]), TARGET - (STATION + A), R - A).step(
            "", joins=True
        ),
        prove_order(
            "range-change",
            Search(SETTING, MOVED, [convex], numbers=NUMBERS),
            A.T @ A,
            (Q**2 - 2 * (F * Q) + F**2) * ONE,
            [Square(ONE, convex, weight=2 * F)],
        ).step(
            "The range never changes by more than `|a|`.",
            "The difference is `2 f e`.",
        ),
    ]


def rate_steps() -> list[Step]:
    """The range rate after a displacement and a change of velocity."""
    return [
        Step(
            "changed",
            "Let the velocity change too, by `b`: the range rate becomes `g_+`. What the linear "
            "part `m` does not say of the change is `c`:",
            described("f_+ g_+ = (r + a)'(w + b)"),
            "These are the definitions.",
            NAME,
            heading="Derivative of the range rate",
        ),
        meaning("first_order"),
        meaning("rest"),
        prove_equal(
            "rate-remainder",
            Search(SETTING, EVERY, numbers=NUMBERS),
            Q * REST,
            A.T @ B - G * EXCESS - (Q - F) * DG,
        ).step(
            "Exactly:",
            "Multiply out `f_+ g_+`, with `r = f u` and `w = g u + f h`.",
        ),
        prove_order(
            "inner-product-size",
            Search(SETTING, [RANGE], numbers=NUMBERS),
            A.T @ A,
            A.T @ U @ U.T @ A,
            [Square(P @ A, ("unit", "d"))],
        ).step(
            "No product with `u` is longer than the other factor (Cauchy and Schwarz):",
            "The difference is `|P a|^2`.",
        ),
        Step(
            "rate-remainder-size",
            "Each term is a product of two changes: with `|g| <= |w|`, `|h| <= |w|/f` and the "
            "steps on the range, `f_+ |c| <= 2 |a| |b| + (3/2) |w| |a|^2/f`. Where `|a| < f`, "
            "`f_+` is at least `f - |a|`.",
            cited("|x'y| <= |x| |y| and |x + y| <= |x| + |y| for vectors x, y.", ELEMENTARY.text()),
            "`|a'b| <= |a| |b|`, `|g| e <= |w| |a|^2/(2 f)`, `|f_+ - f| |m| <= |a| (|w| |a|/f + "
            "|b|)`.",
            NAME,
        ),
        Step(
            "rate-gradient",
            "So `c` is of second order: the derivative of the range rate by the target's position "
            "is `h'`, equations (24) and (25) of the source, and by its velocity `u'`. By the "
            "station's they have the other sign (step @target-moves).",
            described("dg = h'(dL - dB) + u'(dv_L - dv_B)"),
            "Step @rate-remainder-size.",
            NAME,
        ),
    ]
