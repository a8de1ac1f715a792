"""Steps on two stations: sums and differences of ranges and of range rates."""

from __future__ import annotations

from gainproof.derive.derivation import Step
from gainproof.derive.relation import described
from gainproof.derive.sensors.range_doppler_setting import (
    DRIFT,
    NAME,
    ONE,
    OTHER_F,
    OTHER_G,
    OTHER_H,
    OTHER_R,
    OTHER_RANGE,
    OTHER_RATE,
    OTHER_U,
    OTHER_W,
    RANGE,
    RATE,
    SETTING,
    F,
    G,
    H,
    R,
    S,
    U,
    W,
    meaning,
)
from gainproof.derive.words.search import Search
from gainproof.derive.words.statement import Square, prove_equal, prove_order

RANGES = (RANGE, OTHER_RANGE)
NUMBERS = (R.T @ OTHER_R, R.T @ W, OTHER_R.T @ OTHER_W)
PLANE = ("unit", "d")


def station_steps() -> list[Step]:
    """The sum, then the difference."""
    apart, rate_apart = F - OTHER_F, G - OTHER_G
    return [
        Step(
            "second-station",
            "A second station, at `B_2`, has all of this too, with the index 2; `s = r - r_2` is "
            "the way from the first station to it, and `s_v` its velocity relative to the first.",
            described("f_2 > 0 with f_2^2 = r_2'r_2, g_2 with f_2 g_2 = r_2'w_2"),
            "These are the definitions.",
            NAME,
            heading="Two stations",
        ),
        meaning("baseline"),
        meaning("drift"),
        prove_order(
            "bistatic-least",
            Search(SETTING, RANGES, numbers=NUMBERS),
            (F**2 + 2 * (F * OTHER_F) + OTHER_F**2) * ONE,
            S.T @ S,
            [Square(U + OTHER_U, PLANE, weight=F * OTHER_F)],
        ).step(
            "A transmitter and a receiver apart measure the bistatic range `f + f_2` and its rate "
            "`g + g_2`. Derivatives of sums are sums: `u + u_2` and `h + h_2` by the target's "
            "position. The bistatic range is at least the distance of the two, `|s|`:",
            "The difference is `f f_2 |u + u_2|^2`.",
        ),
        meaning("other_unit"),
        meaning("other_turning"),
        prove_order(
            "difference-most",
            Search(SETTING, RANGES, numbers=NUMBERS),
            S.T @ S,
            (F**2 - 2 * (F * OTHER_F) + OTHER_F**2) * ONE,
            [Square(U - OTHER_U, PLANE, weight=F * OTHER_F)],
        ).step(
            "Differences of arrival in time and in frequency (TDOA, FDOA) measure `f - f_2` and "
            "`g - g_2`. The first is at most `|s|`:",
            "The difference is `f f_2 |u - u_2|^2`.",
        ),
        prove_equal(
            "range-difference",
            Search(SETTING, RANGES, numbers=NUMBERS),
            apart * F * ONE + apart * OTHER_F * ONE,
            S.T @ (R + OTHER_R),
        ).step(
            "Far from both stations the two ranges nearly agree. The kernels subtract what is "
            "given, the stations' positions, and no computed range: divided by `f + f_2`, the "
            "right side here errs by parts of `|s|`, not of `f`.",
            "`f^2 - f_2^2 = (r - r_2)'(r + r_2)`.",
        ),
        prove_equal(
            "unit-difference",
            Search(SETTING, RANGES),
            U - OTHER_U,
            (S - apart * OTHER_U) / F,
        ).step(
            "The derivatives likewise, by the position and, of the rates, by the velocity:",
            "`f u = r` and `f_2 u_2 = r_2`.",
        ),
        prove_equal(
            "rate-difference",
            Search(SETTING, [RATE, OTHER_RATE]),
            rate_apart * ONE,
            U.T @ DRIFT + (U - OTHER_U).T @ OTHER_W,
        ).step("The difference of the rates:", "`w = w_2 + s_v`."),
        prove_equal(
            "turning-difference",
            Search(SETTING),
            F * (H - OTHER_H),
            DRIFT - rate_apart * U - OTHER_G * (U - OTHER_U) - apart * OTHER_H,
        ).step(
            "And its derivative by the position:",
            "Subtract `f_2 h_2 = w_2 - g_2 u_2` from `f h = w - g u`.",
        ),
    ]
