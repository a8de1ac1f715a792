"""Steps that factor the innovation spectrum: from the model to sigma."""

from __future__ import annotations

import sympy as sp

from gainproof.derive.derivation import Step
from gainproof.derive.relation import equal
from gainproof.derive.vector_measurement import radicands
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
    row,
)
from gainproof.derive.vector_measurement.spectrum import V, spectral_matrix
from gainproof.derive.vector_measurement.towers import symbolic_noise


def one_end_text(c: Context) -> str:
    """sigma c(1) in a sentence."""
    return "Lambda w" if c.noise.determinant else "Lambda"


def spectrum_steps(c: Context) -> list[Step]:
    """The spectrum, its factor c(z), and the values of both at z = 1, z = -1 and z = 0."""
    one, other = c.closed_loop.subs(Z, 1), c.closed_loop.subs(Z, -1)
    return [
        _spectrum(c),
        _closed_loop(c),
        Step(
            "at-zero",
            "Its constant coefficient is `c(0) = det(I - K)`. Let `sigma^2 = det(P + R)/det R`, "
            "`sigma` positive: it says how much wider than the measurement noise the innovations "
            "spread. Then `c(0)` is `1/sigma^2`.",
            equal(c.closed_loop.subs(Z, 0), 1 / SIGMA**2),
            "By step @filter `K = U R^-1`, so `I - K = U P^-1`, and "
            "`det U/det P = det R/det(P + R)`.",
        ),
        *_level_steps(c, one),
        *_eta_steps(c, other),
        *_sigma_steps(c),
    ]


def _spectrum(c: Context) -> Step:
    (a, b), (d, e) = spectral_matrix(c.model).tolist()
    return Step(
        "spectrum",
        "The spectrum of what the radar measures has the numerator `D R D^* + Lambda^2 Q0`, where "
        "`D = z I - F`, and `D^*` is its transpose with `1/z` for `z`. The determinant of this "
        "matrix over `det R` depends on `z` through `v = 2 - z - 1/z` alone, and is a quadratic in "
        "`v`.",
        equal(
            sp.Add(sp.Mul(a, e, evaluate=False), -sp.Mul(b, d, evaluate=False), evaluate=False)
            / c.model.measurement_noise.det(),
            c.spectrum.polynomial.subs(V, 2 - Z - 1 / Z),
            free=("z",),
        ),
        "Write out the determinant, product of the diagonal less the other product, and use "
        "`(z - 1) (1/z - 1) = v`.",
        heading="The spectrum of the measurements",
    )


def _closed_loop(c: Context) -> Step:
    inner = Z * sp.eye(2) - c.model.transition * (sp.eye(2) - gain_matrix())
    determinant = sp.Add(
        sp.Mul(inner[0, 0], inner[1, 1]), sp.Mul(-1, inner[0, 1], inner[1, 0]), evaluate=False
    )
    terms = [
        sp.Mul(coefficient, Z**power) for (power,), coefficient in sp.Poly(c.closed_loop, Z).terms()
    ]
    return Step(
        "closed-loop",
        "The error of a prediction is carried to the next by `F (I - K)`. The roots of "
        "`c(z) = det(z I - F (I - K))` are the poles of the filter.",
        equal(determinant, sp.Add(*terms, evaluate=False), free=("z",)),
        "The error of an update is `I - K` times that of the prediction, plus noise; `F` leads to "
        "the next prediction. Write out the determinant.",
    )


def _level_steps(c: Context, one: sp.Expr) -> list[Step]:
    text = (
        "Spectral factorisation: in the steady state the innovations are white, and the spectrum "
        "of step @spectrum is `sigma^2 c(z) c(1/z)`. At `z = 1` it ties the gains to the index"
    )
    named = "; this names `w`" if c.noise.determinant else ""
    steps = [
        Step(
            "at-one",
            f"{text}{named}.",
            equal(
                row(SIGMA * one, INDEX**2 * c.level**2),
                row(INDEX * c.level, c.spectrum.constant),
            ),
            "There `v = 0`: `sigma^2 c(1)^2` is the last term of step @spectrum. We look for poles "
            "inside the unit circle; then `c(1)` is positive.",
        )
    ]
    if c.noise.determinant:
        noise = symbolic_noise(c.noise)
        steps.append(
            Step(
                "level",
                "`w` is near 1 while the velocity is measured badly, and grows when it is measured "
                "well.",
                equal(LEVEL**2, _over_square(radicands.level_squared(noise, INDEX, RATIO))),
                "Divide the second line of step @at-one by `Lambda^2`; `t = Lambda/S` by step "
                "@ratio.",
            )
        )
    return steps


def _eta_steps(c: Context, other: sp.Expr) -> list[Step]:
    form = _over_square(radicands.eta_squared(symbolic_noise(c.noise), INDEX, RATIO))
    form = sp.factor(form) if c.noise.interval else form
    shape = "a product" if c.noise.interval else "a sum of positive terms"
    return [
        Step(
            "at-minus-one",
            f"At `z = -1` the root of both sides is called `eta`. Its square is {shape}.",
            equal(
                row(SIGMA * other, ETA**2, ETA**2),
                row(ETA, c.spectrum.at_minus_one, form),
            ),
            "There `v = 4`, and `c(-1)` is positive like `c(1)`.",
        )
    ]


def _sigma_steps(c: Context) -> list[Step]:
    return [
        Step(
            "mean-root",
            f"Both values together are an equation for `sigma` alone. Let `m` be the mean of "
            f"`{one_end_text(c)}` and `eta`.",
            equal(row(MEAN, MEAN), row((INDEX * c.level + ETA) / 2, SIGMA + 1 / SIGMA)),
            "A quadratic that starts with `z^2` has `c(1) + c(-1) = 2 + 2 c(0)`. Multiply by "
            "`sigma/2` and insert steps @at-one, @at-minus-one and @at-zero.",
        ),
        Step(
            "delta",
            "So `sigma` and `1/sigma` are the roots of a quadratic with the sum `m` and the "
            "product 1. Let `delta` be their difference; its square is a sum of positive terms.",
            equal(
                row(DELTA, DELTA**2, DELTA**2),
                row(SIGMA - 1 / SIGMA, MEAN**2 - 4, _delta_squared(c)),
            ),
            "Square `m` (step @mean-root) and insert the squares of its terms: the 4 cancels.",
        ),
        Step(
            "sigma",
            "That gives `sigma`, the larger root, without a subtraction.",
            equal(SIGMA, (MEAN + DELTA) / 2),
            "Add steps @mean-root and @delta. The larger root is the one with `c(0)` below 1.",
        ),
    ]


def _delta_squared(c: Context) -> sp.Expr:
    form = radicands.delta_squared(
        symbolic_noise(c.noise), INDEX, RATIO, RATIO * c.level, RATIO * ETA
    )
    return _over_square(form)


def _over_square(form: sp.Expr) -> sp.Expr:
    """A form that is S^2 times a quantity, as this quantity over Lambda and t."""
    return sp.expand(sp.expand(form).subs(RATIO, INDEX / SPEED) * SPEED**2 / INDEX**2)
