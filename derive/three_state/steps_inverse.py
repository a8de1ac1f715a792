"""Steps on the way back from gains, and on a twin with the same spectrum."""

from __future__ import annotations

import sympy as sp

from gainproof.derive.derivation import Step, joined
from gainproof.derive.expression import real
from gainproof.derive.model import ScaledModel
from gainproof.derive.relation import equal
from gainproof.derive.three_state.context import Context
from gainproof.derive.three_state.names import (
    ALPHA,
    BETA,
    DELTA,
    DEVIATION,
    GAMMA,
    INDEX,
    NU,
    REST,
    XI,
)
from gainproof.derive.three_state.spectrum import noise_factors

W = real("w")


def inverse_steps(c: Context) -> list[Step]:
    """From the ratio of two gains, or where it is closed from alpha, to all others."""
    e = c.numbers[2]
    steps = [
        Step(
            "from-ratio",
            "The ratio of velocity and acceleration gain gives everything: it is `xi/2` (step "
            "@ratios), and steps @eta-and-delta and @gains have the rest. The position gain gives "
            "`xi` as the root of an equation whose right side rises with `xi`.",
            equal(REST, (DELTA**2 - e) / NU**2),
            "Insert `Lambda` of step @three-equations in step @deviation; `1 - alpha = 1/sigma^2`.",
            heading="From gains back to the index",
        )
    ]
    if not c.spectrum.rational_in_root:
        return steps
    return [
        *steps,
        Step(
            "root-of-rest",
            "Here that equation can be solved. Write `w` for the root of `1 - alpha`, a number "
            "between 0 and 1.",
            equal(W**2, 1 - ALPHA),
            "Its name: `w = 1/sigma`.",
        ),
        Step(
            "rational-in-w",
            "All gains and the index are rational in it.",
            equal(
                sp.ImmutableDenseMatrix([[XI, BETA, GAMMA]]),
                sp.ImmutableDenseMatrix(
                    [
                        [
                            2 * (1 + W) / (1 - W),
                            2 * (1 - W) ** 2,
                            2 * (1 - W) ** 3 / (1 + W),
                        ]
                    ]
                ),
            ),
            "Here `delta = xi (xi^2 - 4)/8` and `nu = xi (xi + 2)^2/8`, so the root of the right "
            "side of step @from-ratio is `delta/nu = (xi - 2)/(xi + 2)`.",
        ),
        joined("index-in-w", equal(INDEX, 2 * (1 - W) ** 3 / (W * (1 + W)))),
        joined("deviation-in-w", equal(DEVIATION, 1 / W)),
    ]


def twin_steps(c: Context, twin: ScaledModel | None) -> list[Step]:
    """That another process noise leads to the same gains, and in what its covariances differ."""
    if twin is None:
        return []
    row, noise, column = noise_factors(c.model)
    transition = c.model.transition
    shift = sp.ImmutableDenseMatrix(sp.diag(0, 0, 1))
    changed = sp.MatMul(transition, shift, transition.T, evaluate=False)
    return [
        Step(
            "twin-spectrum",
            f"The family `{twin.name}` has another process noise, but the same spectrum of the "
            "measurements, and so the same gains, poles and innovation variance for every index.",
            equal(
                sp.MatMul(row, twin.process_noise, column, evaluate=False),
                sp.MatMul(row, noise, column, evaluate=False),
                free=("z",),
            ),
            "On the left its matrix, on the right that of step @noise-spectrum. Everything up to "
            "step @gains rests on the spectrum alone.",
            heading="Another process noise with the same gains",
        ),
        Step(
            "twin-covariance",
            "Its covariances differ in one entry: `M33` and `X33` are larger by `Lambda^2`. If `M` "
            "and `X` satisfy the equations of step @riccati with `Q0`, then with this matrix `E` "
            "`M + Lambda^2 E` and `X + Lambda^2 E` satisfy them with `Q0 - F E F' + E`, which is "
            "the left side here and the other family's matrix.",
            equal(
                sp.MatAdd(noise, sp.Mul(-1, 1) * changed.doit(), shift, evaluate=False),
                twin.process_noise,
            ),
            "`H E = 0`, so `E` changes no gain and passes through the update as it is; the "
            "prediction carries it to `F E F'`. Here `E` has the entry 1 at place 33 and is zero "
            "elsewhere.",
        ),
    ]
