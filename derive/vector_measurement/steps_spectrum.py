"""Steps that factor the innovation spectrum: from the model to sigma."""

from __future__ import annotations

import sympy as sp

from gainproof.derive.derivation import Step
from gainproof.derive.relation import equal
from gainproof.derive.vector_measurement import forms
from gainproof.derive.vector_measurement.context import Context
from gainproof.derive.vector_measurement.names import (
    DELTA,
    ETA,
    INDEX,
    LEVEL,
    MEAN,
    RATIO,
    SIGMA,
    SPEED,
    Z,
    gain_matrix,
)
from gainproof.derive.vector_measurement.spectrum import V, spectral_matrix
from gainproof.derive.vector_measurement.towers import symbolic_noise


def spectrum_steps(c: Context) -> list[Step]:
    """The spectrum, its factor c(z), and the values of both at z = 1, z = -1 and z = 0."""
    v = 2 - Z - 1 / Z
    matrix = spectral_matrix(c.model)
    (a, b), (d, e) = matrix.tolist()
    one, other = c.closed_loop.subs(Z, 1), c.closed_loop.subs(Z, -1)
    return [
        Step(
            "spectrum",
            "Put D = zI - F. The determinant of the innovation spectrum D R D* + Lambda^2 Q0, over "
            "det R, depends on z through v = 2 - z - 1/z alone: it is a square polynomial in v.",
            equal(
                sp.Add(sp.Mul(a, e, evaluate=False), -sp.Mul(b, d, evaluate=False), evaluate=False)
                / c.model.measurement_noise.det(),
                c.spectrum.polynomial.subs(V, v),
                free=("z",),
            ),
            "Write out the determinant; D* is the transpose of D with 1/z for z.",
        ),
        Step(
            "closed-loop",
            "The errors of the filter die out like powers of the roots of c(z) = det(zI - F(I-K)).",
            equal(
                (Z * sp.eye(2) - c.model.transition * (sp.eye(2) - gain_matrix())).det(),
                c.closed_loop,
                free=("z",),
            ),
            "The error of the update is (I - K) F times the one before, and new noise.",
        ),
        *_level_steps(c, one),
        *_eta_steps(c, other),
        Step(
            "at-zero",
            "The constant coefficient of c is det(I - K) = det U/det P = 1/sigma^2.",
            equal(c.closed_loop.subs(Z, 0), 1 / SIGMA**2),
            "I - K = U P^-1 and det U/det P = det R/det(P + R).",
        ),
        Step(
            "mean-root",
            "A quadratic c with leading coefficient 1 has c(1) + c(-1) = 2 + 2 c(0). Times sigma/2 "
            "this is one equation for sigma alone; m is the mean of both ends.",
            equal(
                sp.ImmutableDenseMatrix([[MEAN, MEAN]]),
                sp.ImmutableDenseMatrix([[(INDEX * c.level + ETA) / 2, SIGMA + 1 / SIGMA]]),
            ),
            "Insert the values at z = 1, -1 and 0.",
        ),
        Step(
            "delta",
            "So sigma is the larger root of a quadratic. Let delta be sigma - 1/sigma; its square "
            "m^2 - 4 is a sum of positive terms.",
            equal(
                sp.ImmutableDenseMatrix([[DELTA, DELTA**2, DELTA**2]]),
                sp.ImmutableDenseMatrix([[SIGMA - 1 / SIGMA, MEAN**2 - 4, _delta_squared(c)]]),
            ),
            "Square m, insert the squares of its terms: the 4 cancels.",
        ),
        Step(
            "sigma",
            "That gives sigma, and with it the innovation's determinant, without a subtraction.",
            equal(SIGMA, (MEAN + DELTA) / 2),
            "Add m = sigma + 1/sigma and delta = sigma - 1/sigma.",
        ),
    ]


def _level_steps(c: Context, one: sp.Expr) -> list[Step]:
    text = (
        "Spectral factorisation: the spectrum is sigma^2 c(z) c(1/z), sigma^2 = det(P + R)/det R. "
        "At z = 1 v is 0, and the positive root of what is left is sigma c(1)"
    )
    steps = [
        Step(
            "at-one",
            text
            + (
                ", Lambda times a number w."
                if c.noise.determinant
                else ": Lambda itself, so that w is 1 below."
            ),
            equal(
                sp.ImmutableDenseMatrix([[SIGMA * one, INDEX**2 * c.level**2]]),
                sp.ImmutableDenseMatrix([[INDEX * c.level, c.spectrum.constant]]),
            ),
            "Put v = 0 and take the positive root on both sides.",
        )
    ]
    if c.noise.determinant:
        noise = symbolic_noise(c.noise)
        steps.append(
            Step(
                "level",
                "w is near 1 while the velocity is measured badly, S > Lambda, and grows when it "
                "is measured well.",
                equal(LEVEL**2, _over_square(forms.level_squared(noise, INDEX, RATIO))),
                "Divide by Lambda^2.",
            )
        )
    return steps


def _eta_steps(c: Context, other: sp.Expr) -> list[Step]:
    form = _over_square(forms.eta_squared(symbolic_noise(c.noise), INDEX, RATIO))
    form = sp.factor(form) if c.noise.interval else form
    shape = "a product" if c.noise.interval else "a sum of positive terms"
    return [
        Step(
            "at-minus-one",
            "At z = -1 v is 4; eta is sigma c(-1), and its square is " + shape + ".",
            equal(
                sp.ImmutableDenseMatrix([[SIGMA * other, ETA**2, ETA**2]]),
                sp.ImmutableDenseMatrix([[ETA, c.spectrum.at_minus_one, form]]),
            ),
            "Put v = 4 and take the positive root on both sides.",
        )
    ]


def _delta_squared(c: Context) -> sp.Expr:
    form = forms.delta_squared(symbolic_noise(c.noise), INDEX, RATIO, RATIO * c.level, RATIO * ETA)
    return _over_square(form)


def _over_square(form: sp.Expr) -> sp.Expr:
    """A form that is S^2 times a quantity, as this quantity over Lambda and t."""
    return sp.expand(sp.expand(form).subs(RATIO, INDEX / SPEED) * SPEED**2 / INDEX**2)
