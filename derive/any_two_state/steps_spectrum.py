"""Steps on the spectrum of the measurements and its factor d(s)."""

from __future__ import annotations

from collections.abc import Iterable

import sympy as sp

from gainproof.derive.any_two_state.context import Context
from gainproof.derive.any_two_state.names import (
    ALPHA,
    BETA,
    D0,
    D1,
    D2,
    DEVIATION,
    INDEX,
    S,
    Z,
    row,
)
from gainproof.derive.any_two_state.towers import AREA, starts_with_half_powers
from gainproof.derive.derivation import Step, joined
from gainproof.derive.expression import real
from gainproof.derive.relation import definition, equal, increasing_onto, positive

PLACE = (1 + S) / (1 - S)


def spectrum_steps(c: Context) -> list[Step]:
    """From the model to d0, d1, d2 and the gains."""
    return [*_open_loop(c), *_factor(c), *_closed_loop(c)]


def _determinant(matrix: sp.MatrixBase) -> sp.Expr:
    products = sp.Mul(matrix[0, 0], matrix[1, 1]), sp.Mul(-1, matrix[0, 1], matrix[1, 0])
    return sp.Add(*(entry for entry in products if entry != 0), evaluate=False)


def _open_loop(c: Context) -> list[Step]:
    f0, f1, f2 = c.shape.open_loop
    n0, n1 = c.shape.noise_ends
    inner = PLACE * sp.eye(2) - c.model.transition
    other = inner.subs(S, -S)
    forward, backward = inner.adjugate(), other.adjugate()
    noise = sp.MatMul(
        sp.ImmutableDenseMatrix(c.model.measurement * forward),
        c.model.process_noise,
        sp.ImmutableDenseMatrix((c.model.measurement * backward).T),
        evaluate=False,
    )
    return [
        Step(
            "open-loop",
            "Write `z = (1 + s)/(1 - s)`: the unit circle is the imaginary axis of `s`, its inside "
            "the left half plane, and `1/z` belongs to `-s`. The model without a filter has the "
            "polynomial `f(s) = (1 - s)^2 det(z I - F)`.",
            equal((1 - S) ** 2 * _determinant(inner), f2 * S**2 + f1 * S + f0, free=("s",)),
            "Insert and collect powers of `s`. The coefficients are `det(I + F)`, `2 (1 - det F)` "
            "and `det(I - F)`.",
            heading="The spectrum of the measurements",
        ),
        Step(
            "noise-spectrum",
            "What the process noise adds to the spectrum of the measurements has the numerator "
            "`H adj(z I - F) Q0 adj(I/z - F)' H'`. As a function of `s`:",
            equal(
                noise,
                sp.ImmutableDenseMatrix([[(n0 - n1 * S**2) / ((1 - S) * (1 + S))]]),
                free=("s",),
            ),
            "The inverse of `z I - F` is its adjugate over its determinant. `n0` and `n1` are the "
            "numerator at `z = 1` and at `z = -1`; with them it is `(n0 - n1 s^2)/(1 - s^2)`.",
        ),
        *named_numbers("n", (n0, n1)),
    ]


def named_numbers(letter: str, values: Iterable[sp.Expr]) -> list[Step]:
    """Numbers of the model with their names, shown with the step before."""
    return [
        joined(f"number-{letter}{k}", definition(real(f"{letter}{k}"), value))
        for k, value in enumerate(values)
    ]


def _factor(c: Context) -> list[Step]:
    f0, f1, f2 = c.shape.open_loop
    n0, n1 = c.shape.noise_ends
    known = f2 * S**2 + f1 * S + f0
    factor = D2 * S**2 + D1 * S + D0
    half = [_range(c)] if starts_with_half_powers(c.shape) else []
    return [
        *half,
        Step(
            "roots",
            "Three roots carry all that follows: `d0` and `d2` of sums without a minus sign, `d1` "
            "of one that has a form without.",
            equal(
                row(D0**2, D2**2, D1**2),
                row(
                    f0**2 + AREA * n0,
                    f2**2 + AREA * n1,
                    f1**2 - 2 * f0 * f2 + AREA * (n0 + n1) + 2 * D0 * D2,
                ),
            ),
            "They are what comparing coefficients in step @factorisation gives; `d0` and `d2` are "
            "the positive roots of the spectrum at `z = 1` and at `z = -1`.",
        ),
        joined("first-root-positive", positive(D0)),
        joined("second-root-positive", positive(D1)),
        joined("third-root-positive", positive(D2)),
        Step(
            "factorisation",
            "With them the spectrum of the measurements, times `(1 - s^2)^2`, is `d(s) d(-s)` with "
            "`d(s) = d2 s^2 + d1 s + d0`. Its coefficients are positive: all roots of `d` lie in "
            "the left half plane.",
            equal(
                sp.Mul(known, known.subs(S, -S), evaluate=False)
                + AREA * (1 - S) * (1 + S) * (n0 - n1 * S**2),
                sp.Mul(factor, factor.subs(S, -S), evaluate=False),
                free=("s",),
            ),
            "On the left the measurement noise, of variance 1, and the process noise. Compare "
            "the coefficients of `s^0`, `s^2` and `s^4`.",
        ),
    ]


def _range(c: Context) -> Step:
    end = c.edges
    return Step(
        "parameter-range",
        "Here half powers of the index occur: `p` is its root. What holds for all positive `p` "
        "holds for all positive `Lambda`.",
        increasing_onto(INDEX, sp.Integer(0), "infinity", variable="p"),
        "Every positive index is the square of one positive `p`.",
        hint={"form": 2 * real("p"), "ends": {"0": end[0].end, "infinity": end[1].end}},
    )


def _closed_loop(c: Context) -> list[Step]:
    gain = sp.ImmutableDenseMatrix([[ALPHA], [BETA]])
    closed = Z * sp.eye(2) - c.model.transition * (sp.eye(2) - gain * c.model.measurement)
    polynomial = sp.collect(sp.expand(closed.det()), Z)
    factor = D2 * S**2 + D1 * S + D0
    return [
        Step(
            "deviation",
            "The innovations have the standard deviation `sigma`.",
            equal(DEVIATION, (D0 + D1 + D2) / 4),
            "As `z` grows without bound, at `s = 1`, the spectrum is that of the innovations: "
            "`d(1) = 4 sigma`.",
            heading="The gains",
        ),
        Step(
            "closed-loop",
            "In the steady state the error of a prediction is carried to the next by "
            "`F (I - K H)` with the gain `K = (alpha, beta)'`. The roots of "
            "`c(z) = det(z I - F (I - K H))` are the poles of the filter.",
            equal(_determinant(closed), polynomial, free=("z",)),
            "Write out the determinant.",
        ),
        Step(
            "gains",
            "The gains for which this polynomial is the factor of the spectrum: "
            "`sigma (1 - s)^2 c(z) = d(s)`.",
            equal(
                sp.Mul(DEVIATION, (1 - S) ** 2, polynomial.subs(Z, PLACE), evaluate=False),
                factor,
                free=("s",),
            ),
            "Spectral factorisation: the innovations are white, and seen through the filter they "
            "have the spectrum of the measurements. `c(z)` is linear in `K`: two equations for "
            "the two gains. That these gains are the steady state is proved below.",
        ),
    ]
