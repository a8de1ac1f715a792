"""Steps on the steady covariance, under measurement noise and with process noise, and on lags."""

from __future__ import annotations

import sympy as sp
from sympy.polys.matrices import DomainMatrix

from gainproof.derive.derivation import Step, joined
from gainproof.derive.expression import real
from gainproof.derive.fixed_gain.loop import (
    Loop,
    listed,
    lyapunov,
    lyapunov_map,
    pairs,
    product,
    row,
    rows,
    symmetric,
    tidy,
    total,
)
from gainproof.derive.relation import Relation, described, equal

NOISE = "q"


def variance_steps(loop: Loop, lecture: sp.Expr, minors: tuple[sp.Expr, ...] = ()) -> list[Step]:
    """The Lyapunov equation, its one solution, the smoothed covariance.

    `lecture`: its P11. `minors`: forms that show the signs of the leading minors of P.
    """
    above, below = _inverse(loop)
    size = loop.size
    p, x = symmetric("predicted", size), symmetric("updated", size)
    carried = product(loop.closed, p, loop.closed.T)
    seen = product(loop.transition, loop.column, loop.column.T, loop.transition.T)
    return [
        Step(
            "lyapunov",
            "A target that moves as predicted leaves the noise of the measurements alone, of "
            "variance 1 here (`B` in general, which multiplies all entries). Then `e`, the error "
            "of the prediction, becomes `F (I - K H) e` less `F K` times the next noise, and its "
            "steady covariance `P` is that for which",
            equal(p, total(carried, seen)),
            "The noise is white: it does not know the error before it.",
            heading="Variance under measurement noise",
        ),
        Step(
            "unique",
            "There is no other: `P - A P A'` is linear in the entries of `P`, by a matrix whose "
            "determinant is not 0 on the region of stability.",
            equal(
                product(lyapunov_map(loop), above),
                (below * sp.eye(len(pairs(size)))).as_immutable(),
            ),
            "Multiply out. (No product of two roots of `c(z)` is 1.)",
            shown=size == 2,
        ),
        Step(
            "entries",
            "In the gains:",
            equal(row(*listed(p)), row(*listed(_solution(loop)))),
            "Solve step @lyapunov.",
        ),
        Step(
            "lecture-variance",
            "The smoothing index of the lecture, the variance of the predicted position:",
            equal(p[0, 0], lecture),
            "The first entry, in other words.",
        ),
        Step(
            "innovation-variance",
            "The variance of the innovation is `S = P11 + 1`:",
            equal(real("innovation_variance"), p[0, 0] + 1),
            "Innovation is error of the prediction and noise, which are independent.",
        ),
        Step(
            "smoothed",
            "The covariance `X` after the update:",
            equal(
                x,
                total(product(loop.rest, p, loop.rest.T), product(loop.column, loop.column.T)),
            ),
            "Joseph's form, which holds for any gain.",
        ),
        joined("smoothed-ahead", equal(p, product(loop.transition, x, loop.transition.T))),
        Step(
            "predicted-definite",
            "`P` is positive definite, and with it `X`, as `F` has an inverse.",
            Relation("positive_definite", {"matrix": rows("predicted", size)}),
            "Its leading minors can be written without a minus sign.",
            hint={"minors": minors},
        ),
        *_with_noise(loop, above, below),
    ]


def _solution(loop: Loop) -> sp.ImmutableDenseMatrix:
    seen = loop.transition * loop.column * loop.column.T * loop.transition.T
    return lyapunov(loop, seen)


STABLE = {"alpha": "1/2", "beta": "1/4", "gamma": "1/16"}
"""Gains inside, where a sign is looked up."""


def _inverse(loop: Loop) -> tuple[sp.ImmutableDenseMatrix, sp.Expr]:
    """The inverse of the map as numerators over one denominator, which is positive inside."""
    found = DomainMatrix.from_Matrix(lyapunov_map(loop))
    domain = found.domain
    numerators, denominator = found.inv_den()
    shared = denominator
    for line in numerators.to_list():
        for entry in line:
            shared = domain.gcd(shared, entry)
    common = sp.factor(domain.to_sympy(domain.quo(denominator, shared)))
    at = {real(name): sp.Rational(value) for name, value in STABLE.items()}
    sign = sp.sign(common.subs(at))
    above = numerators.to_Matrix().applyfunc(
        lambda x: sign * sp.factor(sp.cancel(x / domain.to_sympy(shared)))
    )
    return above.as_immutable(), 1 / tidy(1 / (sign * common))


Shares = dict[str, dict[tuple[str, str], sp.Expr]]


def noise_shares(loop: Loop) -> Shares:
    """What each entry of Q counts in each entry of D, after prediction and update, in the gains."""
    above, below = _inverse(loop)
    names = pairs(loop.size)
    found: Shares = {"predicted": {}, "updated": {}}
    for j, kl in enumerate(names):
        matrix = _matrix(loop.size, [above[i, j] / below for i in range(len(names))])
        after = loop.rest * matrix * loop.rest.T
        for i, ij in enumerate(names):
            row_, column = int(ij[0]) - 1, int(ij[1]) - 1
            found["predicted"][ij, kl] = above[i, j] / below
            found["updated"][ij, kl] = sp.factor(after[row_, column])
    return found


def _with_noise(loop: Loop, above: sp.MatrixBase, below: sp.Expr) -> list[Step]:
    """Any process noise of covariance Q beside."""
    size = loop.size
    noise = symmetric(NOISE, size)
    names = tuple(f"{NOISE}_{ij}" for ij in pairs(size))
    column = sp.ImmutableDenseMatrix([real(name) for name in names])
    entries = [sp.collect(sp.expand(x), list(column)) for x in above * column]
    matrix = _matrix(size, [x / below for x in entries])
    last = (
        "The entries of `D`, row by row, are those of the vector here over the factor on the right."
        if size == 2
        else "The certificate holds them; each is a sum of the six entries of `Q`."
    )
    return [
        Step(
            "superposition",
            "A process noise of covariance `Q` adds to `P` a matrix `D` with `D = A D A' + Q`, "
            "whatever the gains: the equation is linear.",
            described("P = A P A' + F K K' F' + Q is solved by the sum of both parts"),
            "Add both equations.",
            heading="Variance with process noise",
        ),
        Step(
            "process-noise",
            f"There is just one such `D`. {last}",
            equal(
                product(lyapunov_map(loop), sp.ImmutableDenseMatrix(entries)),
                product(below, column),
                free=names,
            ),
            "Step @unique, applied to `Q`." if size == 2 else "",
            shown=size == 2,
        ),
        Step(
            "process-noise-solves",
            "The same as matrices.",
            equal(matrix, total(product(loop.closed, matrix, loop.closed.T), noise), free=names),
            "Insert.",
            shown=False,
        ),
    ]


def _matrix(size: int, entries: list[sp.Expr]) -> sp.ImmutableDenseMatrix:
    named = dict(zip(pairs(size), entries, strict=True))
    return sp.ImmutableDenseMatrix(
        size, size, lambda i, j: named[f"{min(i, j) + 1}{max(i, j) + 1}"]
    )
