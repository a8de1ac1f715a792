"""Steps on partial derivatives: sums of two squares, one for each end of the unit circle."""

from __future__ import annotations

import sympy as sp

from gainproof.derive.derivation import Step, joined
from gainproof.derive.relation import Relation, equal
from gainproof.derive.vector_measurement.context import Context
from gainproof.derive.vector_measurement.names import (
    CROSS,
    DELTA,
    ETA,
    INDEX,
    RATIO,
    REST,
    SIGMA,
    gain_matrix,
)
from gainproof.derive.vector_measurement.steps_entries import P11, P12, P22, U22
from gainproof.derive.vector_measurement.steps_spectrum import one_end_text
from gainproof.derive.vector_measurement.towers import rational

K12, K22 = gain_matrix()[0, 1], gain_matrix()[1, 1]


def derivative_steps(c: Context) -> list[Step]:
    """Derivatives of the predicted covariance with respect to S, of the velocity's to Lambda."""
    n, d = rational(c.noise.n), rational(c.noise.determinant)
    fast, slow = SIGMA * (2 * K12 + K22), REST + 2 * P22 / (RATIO**2 * SIGMA)
    rate, lead = SIGMA * K22, P11 - n * P12
    one_end = one_end_text(c)
    second = (
        " `Q0` is `c c'` with its second column `c`, and beyond that "
        f"{d} in entry 11: that adds the terms with {d}."
        if d
        else ""
    )
    return [
        Step(
            "derivative-predicted-22-velocity-ratio",
            "With the velocity's error the predicted covariance changes like this.",
            _by(c, P22, RATIO, REST**2, slow**2),
            "A small change of `R` or `Q` spreads over all later samples by powers of the closed "
            "loop. Summed up, it is taken at `z = 1` and `z = -1` only, over "
            f"`sigma c(1) = {one_end}` and `sigma c(-1) = eta`, times `1/(1 - c(0)) = sigma/delta`."
            " The checker differentiates the entries themselves.",
            heading="Derivatives",
        ),
        joined(
            "derivative-predicted-12-velocity-ratio",
            _by(c, P12, RATIO, rate * REST, fast * slow),
        ),
        joined(
            "derivative-predicted-11-velocity-ratio",
            _by(c, P11, RATIO, rate**2, fast**2),
        ),
        Step(
            "derivative-updated-22-tracking-index",
            "And with the index the velocity's variances like this.",
            _by(
                c,
                U22,
                INDEX,
                (lead / SIGMA) ** 2 + d * CROSS**2,
                ((lead + 2) / SIGMA) ** 2 + d * CROSS**2,
            ),
            f"In the same way, for a change of `Q`.{second} `P22 = U22 + Lambda^2` by step "
            "@prediction.",
        ),
        joined(
            "derivative-predicted-22-tracking-index",
            equal(sp.Derivative(P22, INDEX), sp.Derivative(U22, INDEX) + 2 * INDEX),
        ),
    ]


def _by(
    c: Context, entry: sp.Expr, variable: sp.Expr, at_one: sp.Expr, at_minus_one: sp.Expr
) -> Relation:
    """The derivative of an entry as the sum of both ends."""
    both = at_one / (INDEX * c.level) + at_minus_one / ETA
    return equal(sp.Derivative(entry, variable), variable / DELTA * both)
