"""Steps on the spectrum of the measurements: on the unit circle, and on a half line."""

from __future__ import annotations

import sympy as sp

from gainproof.derive.derivation import Step, joined
from gainproof.derive.relation import equal
from gainproof.derive.steady_state.spectrum import V
from gainproof.derive.steady_state.towers import rational
from gainproof.derive.three_state.context import Context
from gainproof.derive.three_state.names import DELTA, DEVIATION, ETA, INDEX, XI, S, U, Z
from gainproof.derive.three_state.spectrum import closed_loop_matrix, noise_factors

D_OF_S = 1 + XI * S + ETA * S**2 + DELTA * S**3
D_OF_MINUS_S = 1 - XI * S + ETA * S**2 - DELTA * S**3


def spectrum_steps(c: Context) -> list[Step]:
    """The spectrum from the model and from the filter, then without the circle."""
    return [*_on_the_circle(c), *_on_the_line(c)]


def by_powers(polynomial: sp.Expr, at: sp.Expr) -> sp.Expr:
    """A polynomial in z at a place, its highest power first."""
    terms = [
        sp.Mul(coefficient, at**power) for (power,), coefficient in sp.Poly(polynomial, Z).terms()
    ]
    return sp.Add(*terms, evaluate=False)


def in_place(polynomial: sp.Expr, v: sp.Expr) -> sp.Expr:
    """A polynomial in v with v written out and not multiplied out."""
    terms = sorted(sp.Poly(polynomial, V).terms())
    parts = [
        sp.Mul(coefficient, sp.Pow(v, power, evaluate=False), evaluate=False) if power else number
        for (power,), coefficient in terms
        for number in (coefficient,)
    ]
    return sp.Add(*parts, evaluate=False)


def _determinant(matrix: sp.MatrixBase) -> sp.Expr:
    """A 3 x 3 determinant by its first column, not multiplied out."""
    return sp.Add(
        *(
            sp.Mul((-1) ** i * matrix[i, 0], sp.factor(matrix.minor(i, 0)), evaluate=False)
            for i in range(3)
        ),
        evaluate=False,
    )


def _on_the_circle(c: Context) -> list[Step]:
    v = 2 - Z - 1 / Z
    inner = Z * sp.eye(3) - closed_loop_matrix(c.model)
    open_loop = sp.factor((Z * sp.eye(3) - c.model.transition).det())
    noise = c.spectrum.noise
    closed = by_powers(c.spectrum.closed_loop, Z)
    mirrored = by_powers(c.spectrum.closed_loop, 1 / Z)
    row, shape, column = noise_factors(c.model)
    return [
        Step(
            "closed-loop",
            "In the steady state the gain `K = (alpha, beta, gamma)'` of the filter no longer "
            "changes: `alpha` is the position gain, `beta` the velocity gain, `gamma` the "
            "acceleration gain (written without a factor 1/2). The error of a prediction is "
            "carried to the next by `F (I - K H)`. The roots of `c(z) = det(z I - F (I - K H))` "
            "are the poles of the filter.",
            equal(_determinant(inner), closed, free=("z",)),
            "The error of an update is `I - K H` times that of the prediction, plus noise; `F` "
            "leads to the next prediction. Write out the determinant by its first column.",
            heading="The spectrum of the measurements",
        ),
        Step(
            "open-loop",
            "The model without a filter has the polynomial `det(z I - F)`. Its product with "
            "`det(I/z - F)` is a cube in `v = 2 - z - 1/z`; from here on `v` is this number, "
            "which runs from 0 at `z = 1` to 4 at `z = -1`.",
            equal(open_loop * open_loop.subs(Z, 1 / Z), v**3, free=("z",)),
            "`F` has ones on its diagonal (step @scaled-transition): `det(z I - F) = (z - 1)^3`.",
        ),
        Step(
            "noise-spectrum",
            "What the process noise adds to the spectrum of the measurements has the numerator "
            f"`noise(v) = H adj(z I - F) Q0 adj(I/z - F)' H'`; here `noise(v) = "
            f"{polynomial_text(noise, V)}`.",
            equal(
                sp.MatMul(row, shape, column, evaluate=False),
                sp.ImmutableDenseMatrix([[in_place(noise, v)]]),
                free=("z",),
            ),
            "The inverse of `z I - F` is its adjugate `adj(z I - F)` over its determinant. "
            "Multiply out and collect powers of `v`.",
        ),
        Step(
            "factorisation",
            "Spectral factorisation: this spectrum is also that of the innovations, which in the "
            "steady state are white, seen through the filter; `sigma` is the standard deviation "
            "of an innovation. So `v^3 + Lambda^2 noise(v) = sigma^2 c(z) c(1/z)` for every `z`.",
            equal(
                v**3 + sp.Mul(INDEX**2, in_place(noise, v), evaluate=False),
                sp.Mul(DEVIATION**2, closed, mirrored, evaluate=False),
                free=("z",),
            ),
            "Both sides are the spectrum times the cube `v^3` of step @open-loop: on the left "
            "the measurement noise, of variance 1, and the process noise of step "
            "@noise-spectrum. Three unknown gains stand on the right; what follows solves for "
            "them. That they then satisfy it is what is proved.",
        ),
    ]


def _on_the_line(c: Context) -> list[Step]:
    v_of_u = 4 * U / (1 + U)
    m1, m2 = rational(c.spectrum.m1), rational(c.spectrum.m2)
    second = 1 + m1 * U + m2 * U**2
    a1, a2, e = c.numbers
    left = (1 + U) ** 3 * (v_of_u**3 + INDEX**2 * c.spectrum.noise.subs(V, v_of_u))
    expanded = 1 + a1 * U + a2 * U**2 + (64 / INDEX**2 + e) * U**3
    return [
        Step(
            "half-plane",
            "Put `z = (1 + s)/(1 - s)`. Then `z` lies inside the unit circle exactly where `s` has "
            "a negative real part, on the circle where `s` is imaginary; there `u = -s^2` runs "
            "through the positive numbers, and `v` is a quotient of them.",
            equal(
                2 - (1 + S) / (1 - S) - (1 - S) / (1 + S),
                v_of_u.subs(U, -(S**2)),
                free=("s",),
            ),
            "`|1 + s| < |1 - s|` says that `s` is nearer to -1 than to 1. Insert `z` in "
            "`v = 2 - z - 1/z`.",
            heading="From the unit circle to a line",
        ),
        Step(
            "line-spectrum",
            "The left side of step @factorisation becomes a polynomial in `u` without a negative "
            "coefficient.",
            equal(left, 64 * U**3 + INDEX**2 * (1 + U) * second, free=("u",)),
            "Insert `v = 4 u/(1 + u)` and multiply by `(1 + u)^3`.",
        ),
        Step(
            "line-factorisation",
            "Divided by `Lambda^2` it is the product of `d(s) = 1 + xi s + eta s^2 + delta s^3` "
            "and its mirror image, with three positive numbers `xi`, `eta` and `delta`.",
            equal(
                expanded.subs(U, -(S**2)),
                sp.Mul(D_OF_S, D_OF_MINUS_S, evaluate=False),
                free=("s",),
            ),
            "A polynomial in `s^2` that is positive for imaginary `s` is `d(s) d(-s)` with the "
            "roots of `d` in the left half plane. Then all coefficients of `d` have one sign.",
        ),
        Step(
            "three-equations",
            "Compared power by power this is three equations, each a square equal to a sum of "
            "positive terms.",
            equal(DELTA**2, 64 / INDEX**2 + e),
            "The coefficients of `u^3`, `u` and `u^2` in step @line-factorisation.",
        ),
        joined("equation-xi", equal(XI**2, a1 + 2 * ETA)),
        joined("equation-eta", equal(ETA**2, a2 + 2 * DELTA * XI)),
    ]


def polynomial_text(expression: sp.Expr, variable: sp.Symbol) -> str:
    """A polynomial as text, lowest power first: `1 - v/4 + v^2/120`."""
    parts: list[str] = []
    terms = sorted(sp.Poly(expression, variable).terms(), key=lambda term: term[0])
    for (power,), coefficient in terms:
        top, below = abs(int(coefficient.p)), int(coefficient.q)
        name = "" if power == 0 else str(variable) if power == 1 else f"{variable}^{power}"
        number = "" if top == 1 and name else str(top)
        text = " ".join(part for part in (number, name) if part) + (
            f"/{below}" if below > 1 else ""
        )
        sign = "-" if coefficient < 0 else "+"
        parts.append(f" {sign} {text}" if parts else text if coefficient > 0 else f"-{text}")
    return "".join(parts)
