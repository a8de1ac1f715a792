"""Riccati equation, stability and positive definiteness of named quantities, as statements to be
decided.
"""

from __future__ import annotations

from collections.abc import Mapping, Sequence
from typing import Any

from gainproof.verify.judge.exact.expression import Expr, number, power
from gainproof.verify.judge.exact.statement import Rel, Statement
from gainproof.verify.judge.setting.matrices import (
    Exprs,
    exprs,
    minus,
    model_matrices,
    plus,
    scaled,
    times,
    transposed,
)
from gainproof.verify.judge.setting.stability_conditions import circle_moved, left_half_plane
from gainproof.verify.judge.setting.steady_state_conditions import characteristic
from judged_derivations.surroundings import Surroundings


def _named(where: Surroundings, names: Sequence[Sequence[str]]) -> Exprs:
    return tuple(tuple(where.value(name) for name in row) for row in names)


def _zero(matrix: Exprs) -> list[Rel]:
    return [Rel("=", entry, number(0)) for row in matrix for entry in row]


def riccati_statement(where: Surroundings, claim: Mapping[str, Any]) -> Statement:
    """M = F X F' + index^2 Q, X = M - K H M and K (H M H' + R) = M H'."""
    f, q, h, r = (exprs(m) for m in model_matrices(claim["model"]))
    m, x = _named(where, claim["predicted"]), _named(where, claim["updated"])
    gain = tuple((where.value(name),) for name in claim["gain"])
    index2 = power(where.value(claim["index"]), 2)
    forward = plus(times(times(f, x), transposed(f)), scaled(q, index2))
    innovation = plus(times(times(h, m), transposed(h)), r)
    relations = _zero(minus(m, forward))
    relations += _zero(minus(x, minus(m, times(times(gain, h), m))))
    relations += _zero(minus(times(gain, innovation), times(m, transposed(h))))
    return Statement(tuple(relations))


def stable_statement(where: Surroundings, claim: Mapping[str, Any]) -> Statement:
    """Jury's conditions for the characteristic polynomial of F (I - K H) of two states; Hurwitz's
    for other numbers of them, the unit circle mapped to a half plane.
    """
    f, _, h, _ = (exprs(m) for m in model_matrices(claim["model"]))
    gain = tuple((where.value(name),) for name in claim["gain"])
    loop = minus(f, times(times(f, gain), h))
    if len(f) != 2:
        return Statement(tuple(left_half_plane(circle_moved([*characteristic(loop), number(1)]))))
    c1 = -(loop[0][0] + loop[1][1])
    c0 = loop[0][0] * loop[1][1] - loop[0][1] * loop[1][0]
    one = number(1)
    quantities: tuple[Expr, ...] = (one + c1 + c0, one - c1 + c0, one - c0, one + c0)
    return Statement(tuple(Rel(">", e, number(0)) for e in quantities))


def definite_statement(where: Surroundings, claim: Mapping[str, Any]) -> Statement:
    """All leading minors are positive."""
    matrix = _named(where, claim["matrix"])
    minors = [determinant([row[:n] for row in matrix[:n]]) for n in range(1, len(matrix) + 1)]
    return Statement(tuple(Rel(">", minor, number(0)) for minor in minors))


def determinant(rows: Sequence[Sequence[Expr]]) -> Expr:
    """Determinant by the first row."""
    if len(rows) == 1:
        return rows[0][0]
    total: Expr | None = None
    for column, entry in enumerate(rows[0]):
        rest = [[x for j, x in enumerate(row) if j != column] for row in rows[1:]]
        term = entry * determinant(rest) * (-1) ** column
        total = term if total is None else total + term
    assert total is not None
    return total
