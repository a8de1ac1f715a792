"""Steps on the closed-loop poles: their sum and product, and where they turn real."""

from __future__ import annotations

import sympy as sp

from gainproof.derive.derivation import Step
from gainproof.derive.expression import real
from gainproof.derive.relation import equal, positive, same_sign
from gainproof.derive.vector_measurement import poles
from gainproof.derive.vector_measurement.context import Context
from gainproof.derive.vector_measurement.names import (
    DELTA,
    ETA,
    INDEX,
    MEAN,
    RATIO,
    SIGMA,
    Z,
    row,
)
from gainproof.derive.vector_measurement.pole_kernels import NEGATIVE, POSITIVE, turning_index
from gainproof.derive.vector_measurement.pole_towers import TURNING, spread_root
from gainproof.derive.vector_measurement.steps_limits import times_text
from gainproof.derive.vector_measurement.steps_spectrum import one_end_text
from gainproof.derive.vector_measurement.towers import rational


def pole_steps(c: Context) -> list[Step]:
    """Sum and product, discriminant, sign of the real part, and the two curves."""
    return [*_quadratic(c), *_signs(c), *_curves(c)]


def _coefficients(c: Context) -> tuple[sp.Expr, sp.Expr]:
    """Sum and product of the poles over the gains."""
    poly = sp.Poly(c.closed_loop, Z)
    return -poly.coeff_monomial(Z), poly.coeff_monomial(1)


def _discriminant(c: Context) -> sp.Expr:
    both, product = _coefficients(c)
    return both**2 - 4 * product


def _shape(c: Context) -> sp.Expr:
    """(1/S^2 - g)^2 - 4 d (d + f) - 4/Lambda^2, whose sign is the discriminant's."""
    centre, spread = rational(poles.centre(c.noise)), rational(poles.spread(c.noise))
    return (1 / RATIO**2 - centre) ** 2 - 4 * spread - 4 / INDEX**2


def _quadratic(c: Context) -> list[Step]:
    both, product = _coefficients(c)
    linear, constant = c.spectrum.linear, c.spectrum.constant
    one_end = INDEX * c.level
    return [
        Step(
            "poles",
            "How fast does the filter forget? Its poles have this sum and this product: the "
            f"product is `1/sigma^2`, and the sum is the difference of `eta` and "
            f"`{one_end_text(c)}` over `2 sigma`.",
            equal(
                row(both, both, product),
                row(
                    (ETA - one_end) / (2 * SIGMA),
                    (4 + linear) / (MEAN * SIGMA),
                    1 / SIGMA**2,
                ),
            ),
            "The sum is `(c(-1) - c(1))/2`, the product `c(0)`: steps @at-one, @at-minus-one, "
            "@at-zero. In the second form the numerator is a quarter of the difference of both "
            "squares, which holds the linear coefficient of step @spectrum.",
            heading="The poles of the filter",
        ),
        Step(
            "pole-discriminant",
            "So the discriminant, the square of the poles' difference, is that of the spectrum as "
            "a quadratic in `v`, times a positive factor. A pair of complex poles has the modulus "
            "`1/sigma`.",
            equal(_discriminant(c), (linear**2 - 4 * constant) / (SIGMA * DELTA) ** 2),
            "The spectrum vanishes where `z` or `1/z` is a pole; both poles are real exactly "
            "where both its roots `v` are. Insert step @poles, with `delta^2 = m^2 - 4`.",
        ),
    ]


def _signs(c: Context) -> list[Step]:
    squared = 1 / RATIO**2
    slope = poles.slope(c.noise)
    both, _ = _coefficients(c)
    steps = [
        Step(
            "real-poles",
            "The poles are real where this is not negative, and complex elsewhere.",
            same_sign(_discriminant(c), _shape(c)),
            "Step @pole-discriminant divided by `Lambda^4`, a square completed in `1/S^2`.",
            hint={"form": INDEX**4 / (SIGMA * DELTA) ** 2},
        )
    ]
    if not slope:
        steps.append(
            Step(
                "pole-sum",
                "Their sum is positive everywhere: real poles are positive, and the error of the "
                "filter never changes its sign from sample to sample.",
                positive(both),
                "Step @poles; the linear coefficient is `Lambda^2/S^2`.",
                hint={"form": (4 + c.spectrum.linear) / (MEAN * SIGMA)},
            )
        )
        return steps
    steps.append(
        Step(
            "pole-sum",
            f"Where `Lambda^2` is above {4 / slope} their sum turns negative as `S` grows. Real "
            "poles have one sign, that of the sum.",
            same_sign(both, squared - rational(slope) + 4 / INDEX**2),
            "Step @poles divided by `Lambda^2`; the product of the poles is positive.",
            hint={"form": INDEX**2 / (MEAN * SIGMA)},
        )
    )
    return steps


def _curves(c: Context) -> list[Step]:
    noise = c.noise
    positive_from, negative_up_to = real(POSITIVE), real(NEGATIVE)
    root = spread_root(noise)
    centre, spread = rational(poles.centre(noise)), poles.spread(noise)
    named = f"; here `r^2 = 1 + {times_text(rational(spread), 'Lambda^2')}`" if spread else ""
    steps = [
        Step(
            "real-poles-between",
            f"It vanishes at two values of `1/S^2`, `y_+` and `y_-`{named}. From the larger on "
            "the poles are real and positive, between the two they are complex.",
            equal(
                row(positive_from, negative_up_to, _shape(c)),
                row(
                    centre + 2 * root / INDEX,
                    centre - 2 * root / INDEX,
                    (1 / RATIO**2 - positive_from) * (1 / RATIO**2 - negative_up_to),
                ),
            ),
            "Factor the square. Near such an `S` the discriminant is a difference of two rounded "
            "numbers. The poles differ by its root, and so have half the digits there: the last "
            "digit of `S` moves them as far. Kernels give half the sum, the modulus, the "
            "discriminant and these values of `1/S^2` with all digits.",
            tower=TURNING,
        )
    ]
    if noise.e == 1:
        return steps
    limit = turning_index(noise)
    bound = rational(limit)
    return [
        *steps,
        Step(
            "negative-poles",
            f"Only for an index above {limit} the smaller value is positive. Up to it the poles "
            f"are real and negative, which needs a large `S`: {limit} is where the filter with "
            "position alone turns.",
            same_sign(negative_up_to, INDEX - bound),
            "Multiply by the larger value: the product is `f^2 - 4/Lambda^2` with "
            f"`f = {poles.slope(noise)}`.",
            tower=TURNING,
            hint={
                "form": rational(poles.slope(noise)) ** 2
                * (INDEX + bound)
                / (INDEX**2 * positive_from)
            },
        ),
    ]
