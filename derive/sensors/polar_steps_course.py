"""Steps on a straight uniform course: range rate, Doppler shift, rates of angles, and theirs."""

from __future__ import annotations

import sympy as sp

from gainproof.derive.derivation import Step, joined
from gainproof.derive.expression import column, real
from gainproof.derive.relation import described, equal
from gainproof.derive.sensors.polar_motion import (
    POLAR,
    RATES,
    SECOND,
    TANGENT,
    acceleration,
    outwards,
    turning,
    uniform_second_rates,
)
from gainproof.derive.sensors.polar_names import CROSSING, RADIAL, RISING, VELOCITY, H, R, X, Y, Z
from gainproof.derive.sensors.polar_steps_jacobian import frame

FREE = ("w_R", "w_E", "w_B")
T = real("t")
PLACE = (X, Y, Z)
V = tuple(VELOCITY.values())
BENT = RISING**2 + CROSSING**2


def course_steps() -> list[Step]:
    """First derivatives, second ones, the third of the range."""
    r, e, b = RATES
    rr, ee, bb = SECOND
    return [
        Step(
            "velocity",
            "A target moves with velocity `v`; `w_R` is its component along the line of sight, "
            "`w_E` and `w_B` are those across it.",
            equal(
                sp.MatMul(frame().T.as_immutable(), column(*V), evaluate=False),
                column(RADIAL, RISING, CROSSING),
            ),
            "Components along the directions of step @frame. Every velocity has them, and they "
            "give it back.",
            tower="course",
            heading="A straight uniform course",
        ),
        joined(
            "velocity-back",
            equal(sp.MatMul(frame(), column(RADIAL, RISING, CROSSING), evaluate=False), column(*V)),
            "course",
        ),
        Step(
            "rates",
            "Range, elevation and bearing change at these rates.",
            equal(column(r, e, b), column(RADIAL, RISING / R, CROSSING / H)),
            "Chain rule with step @inverse-jacobian. The range rate is the velocity's part along "
            "the line of sight.",
            tower="course",
        ),
        joined("range-rate", equal(r, _dot(PLACE, V) / R), "course"),
        Step(
            "doppler",
            "The range rate is what Doppler measures: the echo of a carrier is shifted down when "
            "the target goes away.",
            described("Doppler shift = -2 range rate/wavelength, to first order in speed over c"),
            "The way there and back grows by twice the range.",
        ),
        Step(
            "range-acceleration",
            "Though the velocity is constant these rates are not. The range rate grows by what of "
            "the velocity is across the line of sight:",
            equal(rr, BENT / R),
            "`w_R` is the product of `u_R` with the velocity, and `u_R` turns (steps @frame-turns "
            "and @frame-turns-too).",
            tower="course",
        ),
        joined("range-acceleration-speed", equal(rr, (_dot(V, V) - r**2) / R), "course"),
        Step(
            "never-falls",
            "It never falls; it is constant exactly if `w_E` and `w_B` vanish, that is, if place "
            "and velocity are parallel: a radial course.",
            equal(R**3 * (BENT / R), _dot(*[_cross(PLACE, velocity())] * 2), free=FREE),
            "A sum of squares over `R`. On the right stands the square of the vector product of "
            "place and velocity, written in `w_R`, `w_E`, `w_B`.",
        ),
        Step(
            "angle-accelerations",
            "The rates of the angles change too; `c_E w_R - s_E w_E` is the rate of `h`.",
            equal(
                column(ee, bb),
                column(
                    -(2 * RADIAL * RISING + TANGENT * CROSSING**2) / R**2,
                    -2 * CROSSING * outwards() / H**2,
                ),
            ),
            "Differentiate `w_E/R` and `w_B/h` in the same way.",
            tower="course",
        ),
        Step(
            "second-rates",
            "In the rates themselves, with `h = R c_E`:",
            equal(column(rr, ee, bb), column(*uniform_second_rates().values())),
            "Insert step @rates. With these the second derivatives of `x`, `y` and `z` by time "
            "vanish, whatever the rates are; and only with these, since `J` has an inverse.",
            tower="course",
        ),
        *_hidden(),
        Step(
            "third",
            "And so on: `R''' = -3 R' R''/R`, so that the range rate changes fastest where the "
            "target passes.",
            equal(
                2 * (RISING * turned(1) + CROSSING * turned(2)) / R - BENT * RADIAL / R**2,
                -3 * RADIAL * BENT / R**2,
                free=FREE,
            ),
            "Differentiate step @range-acceleration.",
        ),
        Step(
            "closed-form",
            "The range after time `t`, all at once:",
            equal(
                sp.Add(*((p + v * T) ** 2 for p, v in zip(PLACE, V, strict=True))),
                (R + r * T) ** 2 + R * rr * T**2,
                free=("t",),
            ),
            "Steps @range-rate and @range-acceleration.",
            tower="course",
        ),
        Step(
            "plane",
            "In the plane `E = 0`, `w_E = 0` and `h = R`: then `R'' = w_B^2/R` and "
            "`B'' = -2 B' R'/R`.",
            described("a = 1: c_E = 1, s_E = 0"),
            "Steps @range-acceleration and @angle-accelerations; the kernels of the plane are "
            "proved by themselves.",
        ),
    ]


def turned(which: int) -> sp.Expr:
    """The rates of w_R, w_E and w_B."""
    return (
        BENT / R,
        -RISING * RADIAL / R - TANGENT * CROSSING**2 / R,
        -CROSSING * outwards() / H,
    )[which]


def _hidden() -> list[Step]:
    """Long but without surprise: how components change, and that the place does not accelerate."""
    name = ("along", "upwards", "across")
    found = [
        Step(
            f"turning-{name[which]}",
            "How a component of the velocity changes as its direction turns.",
            equal(turning(which), turned(which), free=FREE),
            "The product rule, with the velocity held.",
            shown=False,
        )
        for which in range(3)
    ]
    uniform = Step(
        "uniform",
        "With the second rates of step @second-rates the place does not accelerate.",
        equal(
            column(*(acceleration(each, POLAR, uniform_second_rates()) for each in PLACE)),
            column(0, 0, 0),
            free=tuple(map(str, RATES)),
        ),
        "The chain rule, twice.",
        shown=False,
    )
    return [*found, uniform]


def velocity() -> tuple[sp.Expr, ...]:
    """x', y', z' from the components along the frame, written out."""
    u, parts = frame(), (RADIAL, RISING, CROSSING)
    return tuple(sp.Add(*(u[i, n] * parts[n] for n in range(3))) for i in range(3))


def _dot(p: tuple[sp.Expr, ...], v: tuple[sp.Expr, ...]) -> sp.Expr:
    return sp.Add(*(a * b for a, b in zip(p, v, strict=True)))


def _cross(p: tuple[sp.Expr, ...], v: tuple[sp.Expr, ...]) -> tuple[sp.Expr, ...]:
    return p[1] * v[2] - p[2] * v[1], p[2] * v[0] - p[0] * v[2], p[0] * v[1] - p[1] * v[0]
