"""What makes a solution the steady state: Riccati equation, stability and positive covariance, each
shown for all values of the parameter, and the uniqueness that is cited.
"""

from __future__ import annotations

from collections.abc import Mapping
from fractions import Fraction
from typing import Any

from gainproof.verify.judge.exact.calculus import differentiated
from gainproof.verify.judge.exact.decision import decide
from gainproof.verify.judge.exact.expression import Expr, number, power, symbol
from gainproof.verify.judge.exact.limit import decide_limit
from gainproof.verify.judge.exact.statement import Rel, Statement
from gainproof.verify.judge.meaning.square_matrices import determinant
from gainproof.verify.judge.setting.environment import Fact, NotEstablished
from gainproof.verify.judge.setting.matrices import (
    Exprs,
    exprs,
    minus,
    plus,
    scaled,
    times,
    transposed,
)
from gainproof.verify.judge.setting.spectral_factor import Factor
from gainproof.verify.judge.setting.stability_conditions import circle_moved, left_half_plane

UNIQUENESS = (
    "the Riccati equation has at most one stabilising solution",
    "P. Lancaster, L. Rodman, Algebraic Riccati Equations, Oxford 1995, chapters 13 and 17",
)
METHOD = "tower of radicals, cells of one parameter"


def established(
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
    """The facts that make the solution the steady state. Raises NotEstablished, Undecided."""
    size = len(f)
    variance = times(times(h, m), transposed(h))[0][0] + number(r)
    column = times(m, transposed(h))
    again = plus(times(times(f, x), transposed(f)), scaled(q, factor.squared_index))
    residuals = [a - b for i in range(size) for a, b in zip(again[i], m[i], strict=True)]
    residuals += [variance * g - c[0] for g, c in zip(gain, column, strict=True)]
    residuals += [variance - factor.innovation, power(factor.index, 2) - factor.squared_index]
    residuals += [
        a[0] - b for a, b in zip(times(f, tuple((g,) for g in gain)), predictor, strict=True)
    ]
    # the closed loop of the gains themselves, not of the factor they came from
    loop = minus(f, times(tuple((g,) for g in predictor), h))
    residuals += [a - b for a, b in zip(characteristic(loop), factor.coefficients, strict=True)]
    positive = left_half_plane(circle_moved([*factor.coefficients, number(1)]))
    facts = [
        shown(
            "the Riccati equation, gain and innovation variance hold identically: "
            "M = F X F' + Q, S K = M H', S = H M H' + R",
            [Rel("=", e, number(0)) for e in residuals],
            factor,
        ),
        shown(
            "the closed loop F - L H is stable (Hurwitz, unit circle mapped to a half plane)",
            positive,
            factor,
        ),
        *_covariance(m, factor),
        *_have_values([*gain, *predictor, *[e for row in (*m, *x) for e in row]], factor),
        *_all_indices(factor.in_parameter()),
        Fact(f"cited: {UNIQUENESS[0]}", UNIQUENESS[1]),
    ]
    return tuple(facts)


def _covariance(m: Exprs, factor: Factor) -> tuple[Fact, ...]:
    """That the innovation has a variance and the prediction a covariance: with a stable closed loop
    A it is the sum of A^k (Q + L R L') A'^k, which is never indefinite.
    """
    minors = [determinant(tuple(row[:n] for row in m[:n])) for n in range(1, len(m) + 1)]
    positive = Rel(">", factor.innovation, number(0))
    sentence = "the predicted covariance is positive definite"
    try:
        return (shown(sentence, [*[Rel(">", e, number(0)) for e in minors], positive], factor),)
    except NotEstablished:
        sentence = "the predicted covariance is positive semidefinite, as the closed loop is stable"
        return (shown(sentence, [positive], factor),)


def characteristic(matrix: Exprs) -> list[Expr]:
    """Coefficients of det(zI - A) from power 0 up, without the leading 1: Faddeev, LeVerrier."""
    size = len(matrix)
    found: list[Expr] = []
    current = exprs(tuple(tuple(Fraction(int(i == j)) for j in range(size)) for i in range(size)))
    for k in range(1, size + 1):
        moved = times(matrix, current)
        total = moved[0][0]
        for i in range(1, size):
            total = total + moved[i][i]
        c = number(Fraction(-1, k)) * total
        found.append(c)
        current = tuple(
            tuple(e + c if i == j else e for j, e in enumerate(row)) for i, row in enumerate(moved)
        )
    return found[::-1]


def _have_values(entries: list[Expr], factor: Factor) -> tuple[Fact, ...]:
    """That what is cancelled has a value everywhere: then what is shown of it is true of it."""
    if not factor.put_in:
        return ()
    known = factor.in_parameter()
    needed = [*map(factor.placed, entries), *known.coefficients, known.innovation, known.index]
    nothing = Statement((Rel("=", number(0), number(0)),), needed=tuple(needed))
    outcome = decide(nothing, factor.boxes(), factor.parameter)
    sentence = "gains and covariances have a value everywhere"
    if outcome.verdict != "proved":
        raise NotEstablished(f"{sentence}: {outcome.reason}")
    return (Fact(sentence, METHOD, outcome.certificate),)


def _all_indices(factor: Factor) -> tuple[Fact, ...]:
    """That the index falls from infinity to zero while its parameter rises through its box."""
    if factor.parameter is None or factor.conditions:
        return ()  # a single index
    if factor.index == symbol(factor.parameter):
        return ()
    falling = Rel("<", differentiated(factor.index, factor.parameter), number(0))
    fact = shown("each positive index belongs to one value of the parameter", [falling], factor)
    if factor.box.lower is None:
        raise NotEstablished("a parameter without a least value")
    last = "infinity" if factor.box.upper is None else factor.box.upper
    for end, value in ((factor.box.lower, "infinity"), (last, number(0))):
        found = decide_limit(factor.index, factor.parameter, factor.box, end, value, "parameter")
        if found.verdict != "proved":
            raise NotEstablished(f"{fact.sentence}: {found.reason}")
    return (fact,)


def shown(sentence: str, relations: list[Rel], factor: Factor) -> Fact:
    """The fact that these relations hold for all values of the parameter. Raises NotEstablished."""
    certificate: Mapping[str, Any] = {}
    for rel in relations:
        if factor.put_in:
            rel = Rel(rel.operator, factor.placed(rel.left - rel.right), number(0))
        statement = Statement((rel,), factor.conditions)
        outcome = decide(statement, factor.boxes(), factor.parameter)
        if outcome.verdict != "proved":
            raise NotEstablished(f"{sentence}: {outcome.reason}")
        certificate = outcome.certificate
    return Fact(sentence, METHOD, certificate)
