"""Steps on the filter: scalar and matrix form, pseudo-velocity, units."""

from __future__ import annotations

import sympy as sp

from gainproof.derive.derivation import Step
from gainproof.derive.expression import real
from gainproof.derive.fixed_gain.loop import (
    Loop,
    product,
    row,
    shift,
    total,
)
from gainproof.derive.relation import described, equal

T = real("t")
SEEN = real("observed")
STATE = tuple(real(name) for name in ("s1", "s2", "s3"))
EQUATIONS = "equations"


def filter_steps(loop: Loop) -> list[Step]:
    """What the filter does in one sample."""
    return [
        *_equations(loop),
        *_pseudo_velocity(loop),
        *_units(loop),
    ]


def given(loop: Loop, *others: sp.Symbol) -> tuple[str, ...]:
    return tuple(str(x) for x in (*STATE[: loop.size], *others, *loop.gains))


def _equations(loop: Loop) -> list[Step]:
    size = loop.size
    state = sp.ImmutableDenseMatrix(STATE[:size])
    predicted = shift(size, T) * state
    innovation = SEEN - predicted[0]
    updated = [predicted[n] + gain / T**n * innovation for n, gain in enumerate(loop.gains)]
    gain = sp.ImmutableDenseMatrix([x / T**n for n, x in enumerate(loop.gains)])
    ahead = product(shift(size, T), state)
    residual = total(row(SEEN), product(-1, loop.row, shift(size, T), state))
    words = "position and velocity" if size == 2 else "position, velocity and acceleration"
    return [
        Step(
            "model",
            f"The filter keeps {words} of one target and is given its position at intervals `t`. "
            "It predicts as if the last of them stayed what it is, and corrects each by a fixed "
            f"part of the innovation: {_listed(loop)}. Whatever the target does, nothing is "
            "assumed of the gains.",
            described("prediction by a Taylor shift, correction by fixed gains"),
            "These are the definitions; no gain is said to be optimal.",
            tower=EQUATIONS,
            heading="The filter",
        ),
        Step(
            "matrix-form",
            f"The scalar equations are `x = F s + K (z - H F s)` with `s = ({_state(size)})` the "
            "state smoothed before, `z` what is observed.",
            equal(
                sp.ImmutableDenseMatrix(updated),
                total(ahead, product(gain, residual)),
                free=given(loop, SEEN),
            ),
            "Multiply out, row by row.",
            tower=EQUATIONS,
        ),
    ]


def _listed(loop: Loop) -> str:
    parts = ["`alpha`", "`beta/t`", "`gamma/t^2`"][: loop.size]
    return ", ".join(parts)


def _state(size: int) -> str:
    return ", ".join(str(x) for x in STATE[:size])


def _pseudo_velocity(loop: Loop) -> list[Step]:
    first, speed = STATE[:2]
    ahead = (shift(loop.size, T) * sp.ImmutableDenseMatrix(STATE[: loop.size]))[0]
    seen, predicted = (SEEN - first) / T, (ahead - first) / T
    turn = speed if loop.size == 2 else speed + T * STATE[2] / 2
    return [
        Step(
            "pseudo-velocity",
            "Call `(z - s1)/t` the observed velocity, from the position smoothed before. The "
            "predicted position gives in the same way "
            + ("the predicted velocity" if loop.size == 2 else "the mean velocity of the interval")
            + ", and the velocities differ by the innovation over `t`: `beta` weighs observed and "
            "predicted velocity as `alpha` weighs the positions. A gain 0 keeps what is "
            "predicted, a gain 1 takes what is observed.",
            equal(
                row(predicted, seen - predicted),
                row(turn, (SEEN - ahead) / T),
                free=tuple(str(x) for x in (*STATE[: loop.size], SEEN)),
            ),
            "Insert the prediction.",
            tower=EQUATIONS,
        ),
    ]


def _units(loop: Loop) -> list[Step]:
    units = sp.diag(*(T**-n for n in range(loop.size))).as_immutable()
    return [
        Step(
            "units",
            "With velocities in units of a length over `t` the interval is 1: from here on "
            f"`t = 1`, `K = ({', '.join(loop.gain_names)})`.",
            equal(
                product(units.inv().as_immutable(), shift(loop.size, T), units),
                loop.transition,
            ),
            "Multiply out.",
            tower=EQUATIONS,
        ),
    ]
