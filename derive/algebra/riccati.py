"""Evidence for a steady state: Riccati residuals, Schur-Cohn quantities, leading minors."""

from __future__ import annotations

from typing import Any

import sympy as sp
from sympy.polys.matrices import DomainMatrix

from gainproof.derive.algebra.cofactors import cofactors
from gainproof.derive.algebra.model_entries import matrix_of
from gainproof.derive.algebra.plain import fraction_data, poly_data
from gainproof.derive.algebra.signs import shown
from gainproof.derive.algebra.tower import Poly, Tower
from gainproof.derive.algebra.vector_riccati import vector_riccati_evidence
from gainproof.derive.derivation import Step
from gainproof.derive.expression import real


def _named(rows: Any) -> sp.ImmutableDenseMatrix:
    return sp.ImmutableDenseMatrix([[real(name) for name in row] for row in rows])


def riccati_evidence(step: Step, tower: Tower) -> dict[str, Any]:
    """d, A and cofactors of D^2 (s (F A F' - A) - F a a' F') + s d N^2 Q0.

    M = A/d, a = A H', and the index is N/D as the tower writes it. A gain given by rows (a vector
    measurement) has evidence of its own.
    """
    parts = step.relation.parts
    if not isinstance(parts["gain"][0], str):
        return vector_riccati_evidence(step, tower)
    model, names = parts["model"], parts["predicted"]
    entries = [[tower.elements[name] for name in row] for row in names]
    denominator: Poly = tower.ring.one
    for row in entries:
        for entry in row:
            denominator = denominator.lcm(entry.den)
    numerators = [[entry.num * denominator.quo(entry.den) for entry in row] for row in entries]
    size = len(names)

    def matrix(rows: list[list[Any]]) -> DomainMatrix:
        domain = tower.ring.to_domain()
        wrapped = [[domain.convert(entry) for entry in row] for row in rows]
        return DomainMatrix(wrapped, (len(rows), len(rows[0])), domain)

    def given(key: str) -> list[list[Any]]:
        return [[tower.ring(sp.QQ(*_ratio(entry))) for entry in row] for row in model[key]]

    covariance = matrix(numerators)
    transition, measured = matrix(given("transition")), matrix(given("measurement"))
    index = tower.elements[parts["index"]]
    strength, outside = index.num**2 * denominator, index.den**2
    noise = matrix([[entry * strength for entry in row] for row in given("process_noise")])
    column = covariance * measured.transpose()
    variance = (measured * column).to_Matrix()[0, 0]
    scale = tower.ring.from_expr(sp.expand(variance)) + (
        tower.ring(sp.QQ(*_ratio(model["measurement_noise"][0][0]))) * denominator
    )
    moved = transition * column
    domain = tower.ring.to_domain()
    moving = transition * covariance * transition.transpose() - covariance
    residual = (moving * domain.convert(outside) + noise) * domain.convert(scale)
    residual -= moved * moved.transpose() * domain.convert(outside)
    found = {
        f"{i + 1},{j + 1}": [poly_data(part) for part in cofactors(tower, residual[i, j].element)]
        for i in range(size)
        for j in range(i, size)
    }
    return {
        "denominator": poly_data(denominator),
        "numerators": [[poly_data(entry) for entry in row] for row in numerators],
        "cofactors": found,
    }


def _ratio(text: str) -> tuple[int, int]:
    value = sp.Rational(text)
    return int(value.p), int(value.q)


def stable_evidence(step: Step, tower: Tower) -> dict[str, Any]:
    """Positive forms of the Schur-Cohn quantities of det(zI - F(I - K H)).

    The hint may hold them as "values"; else they are expanded and their signs looked for. For a
    gain given by rows it may hold the "coefficients" a_0, ..., a_(n-1) as short forms.
    """
    gain = step.relation.parts["gain"]
    # long where entries have names, and not needed where the hint says all
    hinted = {"coefficients", "values"} <= set(step.hint)
    coefficients = [] if hinted else _closed_loop_coefficients(step, tower)
    stated: dict[str, Any] = {}
    if not isinstance(gain[0], str):
        forms = step.hint.get("coefficients", coefficients[:-1])
        stated["coefficients"] = [fraction_data(tower.fraction(form)) for form in forms]
        coefficients = [*forms, sp.Integer(1)]
    values = step.hint.get("values") or _schur_cohn(coefficients)
    return {**stated, "values": [shown(tower, value) for value in values]}


def _closed_loop_coefficients(step: Step, tower: Tower) -> list[sp.Expr]:
    """a_0, ..., a_n of det(zI - F(I - K H)) over the names of the gain; numbers have no name."""
    model, gain = step.relation.parts["model"], step.relation.parts["gain"]
    transition, measured = matrix_of(model["transition"]), matrix_of(model["measurement"])
    rows = _named([[name] if isinstance(name, str) else name for name in gain])
    numbers = {x: tower.expressions[x.name] for x in rows if x.name in tower.expressions}
    rows = rows.subs({x: value for x, value in numbers.items() if value.is_Rational})
    size = transition.rows
    z = sp.Symbol("z")
    closed = z * sp.eye(size) - transition * (sp.eye(size) - rows * measured)
    return [sp.expand(entry) for entry in reversed(sp.Poly(closed.det(), z).all_coeffs())]


def _schur_cohn(coefficients: list[sp.Expr]) -> list[sp.Expr]:
    """a_n - a_0 and a_n + a_0 for each degree from n down to 1."""
    values = []
    while len(coefficients) > 1:
        low, high = coefficients[0], coefficients[-1]
        values += [high - low, high + low]
        degree = len(coefficients) - 1
        coefficients = [
            sp.expand(high * coefficients[k + 1] - low * coefficients[degree - k - 1])
            for k in range(degree)
        ]
    return values


def definite_evidence(step: Step, tower: Tower) -> dict[str, Any]:
    """Positive forms of the leading minors, which the hint may hold as "minors"."""
    matrix = _named(step.relation.parts["matrix"])
    minors = step.hint.get("minors") or [
        sp.expand(matrix[:n, :n].det()) for n in range(1, matrix.rows + 1)
    ]
    return {"minors": [shown(tower, minor) for minor in minors]}
