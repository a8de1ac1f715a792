"""The steady-state Kalman filter of a two-state model with one scalar measurement: solved here,
then established.

Solved from the model's matrices alone: spectral factor, gains by matching the closed-loop
polynomial, covariance from linear equations. None of this is trusted: what makes the result the
steady state is that the Riccati residual vanishes identically, that the closed loop is stable
(Jury) and that the covariance is positive, each shown with the exact tools for all positive
indices; a stabilising solution is unique (a textbook theorem, cited).
"""

from __future__ import annotations

from collections.abc import Mapping
from dataclasses import dataclass
from fractions import Fraction
from typing import Any

from gainproof.verify.judge.exact.decision import decide
from gainproof.verify.judge.exact.expression import Expr, number, power, symbol
from gainproof.verify.judge.exact.limits import Undecided
from gainproof.verify.judge.exact.statement import Rel, Statement
from gainproof.verify.judge.setting.environment import INDEX, POSITIVE, Fact, NotEstablished
from gainproof.verify.judge.setting.matrix import (
    Exprs,
    Numbers,
    exprs,
    minus,
    model_matrices,
    plus,
    scaled,
    solve_rows,
    times,
    transposed,
)
from gainproof.verify.judge.setting.spectrum import Factor, stable_factor

UNIQUENESS = (
    "the Riccati equation has at most one stabilising solution",
    "P. Lancaster, L. Rodman, Algebraic Riccati Equations, Oxford 1995, chapters 13 and 17",
)


@dataclass(frozen=True)
class SteadyState:
    """All in units T = 1, measurement noise variance of the model; expressions of the tracking
    index.
    """

    filter_gain: tuple[Expr, ...]
    predictor_gain: tuple[Expr, ...]
    predicted: Exprs
    updated: Exprs
    innovation: Expr
    closed_loop: tuple[Expr, Expr]  # c1, c0 of z^2 + c1 z + c0
    facts: tuple[Fact, ...]


def solve(model: Mapping[str, Any]) -> SteadyState:
    """The established steady state of a model. Raises Malformed, Undecided, NotEstablished."""
    f, q, h, r = model_matrices(model)
    if len(f) != 2 or len(h) != 1:
        raise Undecided(
            f"a steady state with {len(f)} states and {len(h)} measurements is not covered"
        )
    factor = stable_factor(f, q, h, r[0][0])
    predictor = _predictor_gain(f, h, factor)
    gain = solve_rows(f, predictor)
    if gain is None:
        raise Undecided("the transition matrix is singular")
    predicted = _predicted(f, q, h, gain, predictor, factor.innovation)
    big = exprs(f)
    observed = times(exprs(h), predicted)
    updated = minus(predicted, times(tuple((g,) for g in gain), observed))
    facts = _establish(
        big, exprs(q), exprs(h), r[0][0], predicted, updated, gain, predictor, factor
    )
    closed = (factor.c1, factor.c0)
    return SteadyState(
        tuple(gain), tuple(predictor), predicted, updated, factor.innovation, closed, facts
    )


def _predictor_gain(f: Numbers, h: Numbers, factor: Factor) -> list[Expr]:
    """L with det(zI - F + L H) = c(z): two linear equations."""
    (a, b), (c, d) = f
    h1, h2 = h[0]
    # det(zI - F + L H) = det(zI - F) + H adj(zI - F) L
    rows = [[h1, h2], [-h1 * d + h2 * c, h1 * b - h2 * a]]
    right = [factor.c1 + number(a + d), factor.c0 + number(b * c - a * d)]
    solved = solve_rows(rows, right)
    if solved is None:
        raise Undecided("the state is not observable")
    return solved


def _predicted(
    f: Numbers, q: Numbers, h: Numbers, gain: list[Expr], predictor: list[Expr], innovation: Expr
) -> Exprs:
    """M from M H' = S K and M - F M F' = index^2 Q - S L L', linear in the entries 11, 12, 22."""
    rows: list[list[Fraction]] = []
    right: list[Expr] = []
    h1, h2 = h[0]
    rows += [[h1, h2, Fraction(0)], [Fraction(0), h1, h2]]
    right += [innovation * g for g in gain]
    index2 = power(symbol(INDEX), 2)
    for i, j in ((0, 0), (0, 1), (1, 1)):
        row = []
        for p, s in ((0, 0), (0, 1), (1, 1)):
            whole = Fraction(int((i, j) == (p, s)))
            moved = f[i][p] * f[j][s] + (f[i][s] * f[j][p] if p != s else 0)
            row.append(whole - moved)
        rows.append(row)
        right.append(number(q[i][j]) * index2 - innovation * predictor[i] * predictor[j])
    solved = solve_rows(rows, right)
    if solved is None:
        raise Undecided("the covariance is not fixed by gain and Riccati equation")
    m11, m12, m22 = solved
    return ((m11, m12), (m12, m22))


def _establish(
    f: Exprs,
    q: Exprs,
    h: Exprs,
    r: Fraction,
    m: Exprs,
    x: Exprs,
    gain: list[Expr],
    predictor: list[Expr],
    factor: Factor,
) -> tuple[Fact, ...]:
    index2 = power(symbol(INDEX), 2)
    variance = times(times(h, m), transposed(h))[0][0] + number(r)
    column = times(m, transposed(h))
    again = plus(times(times(f, x), transposed(f)), scaled(q, index2))
    residuals = [a - b for i in range(2) for a, b in zip(again[i], m[i], strict=True)]
    residuals += [variance * g - c[0] for g, c in zip(gain, column, strict=True)]
    residuals += [variance - factor.innovation]
    one = number(1)
    c1, c0 = factor.c1, factor.c0
    # the closed loop of the gains themselves, not of the factor they came from
    loop = minus(f, times(tuple((g,) for g in predictor), h))
    residuals += [
        loop[0][0] + loop[1][1] + c1,
        loop[0][0] * loop[1][1] - loop[0][1] * loop[1][0] - c0,
    ]
    residuals += [
        a[0] - b for a, b in zip(times(f, tuple((g,) for g in gain)), predictor, strict=True)
    ]
    facts = [
        shown(
            "the Riccati equation, gain and innovation variance hold identically: "
            "M = F X F' + Q, S K = M H', S = H M H' + R",
            [Rel("=", e, number(0)) for e in residuals],
        ),
        shown(
            "the closed loop F - L H is stable (Jury): "
            "1 + c1 + c0 > 0, 1 - c1 + c0 > 0, 1 - c0 > 0, 1 + c0 > 0",
            [Rel(">", e, number(0)) for e in (one + c1 + c0, one - c1 + c0, one - c0, one + c0)],
        ),
        shown(
            "the predicted covariance is positive definite",
            [
                Rel(">", e, number(0))
                for e in (m[0][0], m[0][0] * m[1][1] - m[0][1] * m[0][1], factor.innovation)
            ],
        ),
        Fact(f"cited: {UNIQUENESS[0]}", UNIQUENESS[1]),
    ]
    return tuple(facts)


def shown(sentence: str, relations: list[Rel]) -> Fact:
    """The fact that these relations hold for all positive indices. Raises NotEstablished."""
    certificate: Mapping[str, Any] = {}
    for rel in relations:
        outcome = decide(Statement((rel,)), {INDEX: POSITIVE}, INDEX)
        if outcome.verdict != "proved":
            raise NotEstablished(f"{sentence}: {outcome.reason}")
        certificate = outcome.certificate
    return Fact(sentence, "tower of radicals, cells of the tracking index", certificate)
