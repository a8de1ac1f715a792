"""Steps on the spectrum of the measurements and its factor d(s)."""

from __future__ import annotations

import sympy as sp

from gainproof.derive.any_three_state.context import Context
from gainproof.derive.any_three_state.names import (
    AREA,
    DETERMINANT,
    DEVIATION,
    GAINS,
    ROOTS,
    TOTAL,
    S,
    Z,
)
from gainproof.derive.any_two_state.names import row
from gainproof.derive.derivation import Step, joined
from gainproof.derive.expression import real
from gainproof.derive.relation import definition, equal, positive

PLACE = (1 + S) / (1 - S)
FACTOR = sp.Add(*(root * S**k for k, root in enumerate(ROOTS)))


def spectrum_steps(c: Context) -> list[Step]:
    """From the model to d0, ..., d3 and the gains."""
    return [*_open_loop(c), *_factor(c), *_closed_loop(c)]


def _expanded(matrix: sp.MatrixBase) -> sp.Expr:
    """The determinant by the first row, not multiplied out."""
    minors = [matrix.minor_submatrix(0, k).det(method="berkowitz") for k in range(3)]
    terms = [
        (-1) ** k * matrix[0, k] * minors[k] for k in range(3) if minors[k] * matrix[0, k] != 0
    ]
    return sp.Add(*terms, evaluate=False)


def _known(c: Context) -> sp.Expr:
    return sp.Add(*(own * S**k for k, own in enumerate(c.shape.open_loop)))


def _open_loop(c: Context) -> list[Step]:
    n0, n1, n2 = c.shape.noise_numerator
    inner = PLACE * sp.eye(3) - c.model.transition
    line = c.model.measurement * inner.adjugate()
    other = line.subs(S, -S)
    noise = sp.MatMul(
        sp.ImmutableDenseMatrix(line.applyfunc(sp.factor)),
        c.model.process_noise,
        sp.ImmutableDenseMatrix(other.T.applyfunc(sp.factor)),
        evaluate=False,
    )
    numerator = (n0 - n1 * S**2 + n2 * S**4) / ((1 - S) ** 2 * (1 + S) ** 2)
    return [
        Step(
            "open-loop",
            "Write `z = (1 + s)/(1 - s)`: the unit circle is the imaginary axis of `s`, its inside "
            "the left half plane, and `1/z` belongs to `-s`. The model without a filter has the "
            "polynomial `g(s) = (1 - s)^3 det(z I - F)`.",
            equal((1 - S) ** 3 * _expanded(inner), _known(c), free=("s",)),
            "Insert and collect powers of `s`.",
            heading="The spectrum of the measurements",
        ),
        Step(
            "noise-spectrum",
            "What the process noise adds to the spectrum of the measurements has the numerator "
            "`H adj(z I - F) Q0 adj(I/z - F)' H'`. As a function of `s`:",
            equal(noise, sp.ImmutableDenseMatrix([[numerator]]), free=("s",)),
            "The inverse of `z I - F` is its adjugate over its determinant; the adjugate holds "
            "`z` to the second power. The numerator is `n0 - n1 s^2 + n2 s^4`.",
        ),
        *(
            joined(f"number-n{k}", definition(real(f"n{k}"), value))
            for k, value in enumerate((n0, n1, n2))
        ),
    ]


def _factor(c: Context) -> list[Step]:
    still, shaken = c.shape.still, c.shape.shaken
    n0, n1, n2 = c.shape.noise_numerator
    d0, d1, d2, d3 = ROOTS
    known, other = _known(c), _known(c).subs(S, -S)
    sums = [f + AREA * n for f, n in zip(still, shaken, strict=True)]
    noise = AREA * (1 - S) * (1 + S) * (n0 - n1 * S**2 + n2 * S**4)
    names = ("first", "second", "third", "fourth")
    return [
        Step(
            "roots",
            "Four positive numbers carry all that follows. `d0` and `d3` are roots of sums; `d1` "
            "and `d2` stand in each other's equation.",
            equal(
                row(d0**2, d1**2, d2**2, d3**2),
                row(sums[0], sums[1] + 2 * d0 * d2, sums[2] + 2 * d3 * d1, sums[3]),
            ),
            "They are what comparing coefficients in step @factorisation gives. There is exactly "
            "one such pair: `d1` is a fixed point of a map that grows like the fourth root of its "
            "argument at most, so it crosses the diagonal once.",
        ),
        *(
            joined(f"{name}-root-positive", positive(root))
            for name, root in zip(names, ROOTS, strict=True)
        ),
        Step(
            "factorisation",
            "With them the spectrum of the measurements, times `(1 - s^2)^3`, is `d(s) d(-s)` with "
            "`d(s) = d3 s^3 + d2 s^2 + d1 s + d0`.",
            equal(
                sp.Mul(known, other, evaluate=False) + noise,
                sp.Mul(FACTOR, FACTOR.subs(S, -S), evaluate=False),
                free=("s",),
            ),
            "On the left the measurement noise, of variance 1, and the process noise. Compare "
            "the coefficients of the even powers of `s`.",
        ),
        Step(
            "hurwitz",
            "All roots of `d` lie in the left half plane.",
            positive(DETERMINANT),
            "The coefficients of `d` are positive; by Routh and Hurwitz a cubic needs `d1 d2 > d0 "
            "d3` besides. The product of the equations for `d1` and `d2` gives it.",
            hint={"form": c.basis.determinant},
        ),
    ]


def _closed_loop(c: Context) -> list[Step]:
    gain = sp.ImmutableDenseMatrix(GAINS)
    closed = Z * sp.eye(3) - c.model.transition * (sp.eye(3) - gain * c.model.measurement)
    polynomial = sp.collect(sp.expand(closed.det(method="berkowitz")), Z)
    inserted = sp.collect(sp.expand(polynomial), Z).subs(Z, PLACE)
    return [
        Step(
            "deviation",
            "The innovations have the standard deviation `sigma`.",
            equal(DEVIATION, TOTAL / 8),
            "As `z` grows without bound, at `s = 1`, the spectrum is that of the innovations: "
            "`d(1) = 8 sigma`.",
            heading="The gains",
        ),
        Step(
            "closed-loop",
            "In the steady state the error of a prediction is carried to the next by "
            "`F (I - K H)` with the gain `K = (alpha, beta, gamma)'`. The roots of "
            "`c(z) = det(z I - F (I - K H))` are the poles of the filter.",
            equal(_expanded(closed), polynomial, free=("z",)),
            "Write out the determinant.",
        ),
        Step(
            "gains",
            "The gains for which this polynomial is the factor of the spectrum: "
            "`sigma (1 - s)^3 c(z) = d(s)`.",
            equal(sp.Mul(DEVIATION, (1 - S) ** 3, inserted, evaluate=False), FACTOR, free=("s",)),
            "Spectral factorisation: the innovations are white, and seen through the filter they "
            "have the spectrum of the measurements. `c(z)` is linear in `K`: three equations for "
            "the three gains. That these gains are the steady state is proved below.",
        ),
    ]
