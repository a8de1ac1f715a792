"""Steps on straight courses, on what Doppler shifts are, and on bearing and elevation."""

from __future__ import annotations

from gainproof.derive.algebra.tower import Parameter, Tower
from gainproof.derive.derivation import Step
from gainproof.derive.expression import real
from gainproof.derive.relation import described, equal, positive
from gainproof.derive.sensors.range_doppler_setting import (
    COURSE,
    NAME,
    NEW_RANGE,
    ONE,
    RANGE,
    RATE,
    SETTING,
    F,
    G,
    H,
    Q,
    R,
    T,
    W,
)
from gainproof.derive.words.expression import ZERO
from gainproof.derive.words.search import Search
from gainproof.derive.words.statement import Square, prove_equal, prove_order

NUMBERS = (R.T @ W,)
CARRIER, LIGHT, RATED = real("carrier_frequency"), real("speed_of_light"), real("rate")
RECEIVED = CARRIER / (1 + RATED / LIGHT)


def doppler_tower() -> Tower:
    """A carrier, the speed of its waves, and any range rate above minus that."""
    parameters = tuple(map(Parameter, ("carrier_frequency", "speed_of_light", "above_minus_light")))
    return Tower("doppler", parameters, (), {"rate": real("above_minus_light") - LIGHT})


def course_steps() -> list[Step]:
    """Position and velocity relative to the station, the velocity constant."""
    given = [RANGE, RATE]
    return [
        prove_equal(
            "course",
            Search(SETTING, [*given, COURSE, NEW_RANGE], heavy=("displacement",), numbers=NUMBERS),
            Q**2 * ONE,
            (F**2 + 2 * (T * F * G)) * ONE + T**2 * (W.T @ W),
        ).step(
            "While target and station keep their velocities, the range after the time `t` is:",
            "`a = t w`.",
            heading="A straight course",
        ),
        prove_equal(
            "range-acceleration",
            Search(SETTING, given, numbers=NUMBERS),
            G**2 * ONE + F * (W.T @ H),
            W.T @ W,
        ).step(
            "The range rate changes with `h'w`, by step @rate-gradient: with `R = f`, `R' = g` and "
            "`R'' = h'w` this is `R'^2 + R R'' = |w|^2`.",
            "Step @parts-of-velocity, with `w = g u + f h`.",
        ),
        prove_equal(
            "acceleration-across",
            Search(SETTING, given, numbers=NUMBERS),
            W.T @ H,
            F * (H.T @ H),
        ).step(
            "It never falls, and is constant on a radial course alone:",
            "`u'h = 0`.",
        ),
        prove_order(
            "acceleration-positive",
            Search(SETTING, given, numbers=NUMBERS),
            W.T @ H,
            ZERO,
            [Square(H, ("unit", "d"), weight=F)],
        ).step("", joins=True),
    ]


def doppler_steps() -> list[Step]:
    """Hz, and what is left out."""
    first = -RATED * CARRIER / LIGHT
    return [
        Step(
            "arrival",
            "A target sends with the carrier frequency `f_c`, and waves run at `c`. What is sent "
            "at `t` arrives at `t + f(t)/c` at a station that stands still, so that a wave that is "
            "sent in the time 1 arrives in `1 + g/c`.",
            described("received frequency f_c/(1 + g/c), g > -c, by one clock for both"),
            "This is the classical Doppler effect, `g` being taken when the wave was sent. That a "
            "station moves while the wave is under way, and that moving clocks run slower "
            "(relativity), are matters of the second order in speeds over `c`, and left out.",
            "doppler",
            heading="Doppler in hertz",
        ),
        Step(
            "shift",
            "The shift against the carrier is `-g f_c/c`, down where the target goes away, but for "
            "the second term:",
            equal(RECEIVED - CARRIER, first + CARRIER * RATED**2 / (LIGHT * (LIGHT + RATED))),
            "Common denominator. Kernels compute the first term, the narrow-band shift of one way; "
            "an echo has twice as much, a transmitter and a receiver apart the sum of their two.",
            "doppler",
        ),
        Step(
            "shift-sure",
            "The wave arrives as long as the target is slower than waves are.",
            positive(RECEIVED),
            "`c + g` is above 0.",
            "doppler",
        ),
        Step(
            "bearing-and-elevation",
            "Bearing and elevation of the target as seen from the station are those of polar "
            "coordinates at `r = L - B`, and their rates on a straight course those at `r`, `w`.",
            described(
                "derivatives by the target's position: `polar_derivatives` at r, by the station's "
                "the same with the other sign; none by velocities"
            ),
            "As in step @target-moves; they are derived in polar-coordinates.",
            NAME,
        ),
    ]
