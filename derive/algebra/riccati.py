"""Evidence for a steady state: Riccati residuals, Schur-Cohn quantities, leading minors; with a
vector measurement it is written in the updated covariance.
"""

from __future__ import annotations

from typing import Any

import sympy as sp
from sympy.polys.matrices import DomainMatrix

from gainproof.derive.algebra.cofactors import cofactors
from gainproof.derive.algebra.model_entries import matrix_of
from gainproof.derive.algebra.plain_data import fraction_data, poly_data
from gainproof.derive.algebra.sign_evidence import shown
from gainproof.derive.algebra.tower import Poly, Tower
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


def vector_riccati_evidence(step: Step, tower: Tower) -> dict[str, Any]:
    """Common denominator d of M = A/d and X = B/d, the inverse V/w of R, minors, cofactors.

    Residuals: prediction A - F B F' - d q Q0, update B (w d I + H' V H A) - w d A. They are short
    when the tower writes all entries over one denominator. The hint may hold "innovation": forms
    that show the signs of the leading minors of H M H' + R.
    """
    parts = step.relation.parts
    model = parts["model"]
    below, (before, after) = _common(tower, parts["predicted"], parts["updated"])
    size = len(before)
    transition, noise, measurement = (
        _matrix(tower, model[key]) for key in ("transition", "process_noise", "measurement")
    )
    precision, scale = _precision(tower, model["measurement_noise"])
    first, second = _wrapped(tower, before), _wrapped(tower, after)
    index = tower.fraction(real(parts["index"]))
    one = _scalar(tower, tower.ring.one, size)
    strength = _scalar(tower, below * index.num**2, size)
    moved = first - transition * second * transition.transpose()
    prediction = _scalar(tower, index.den**2, size) * moved - strength * noise
    common = _scalar(tower, scale * below, size)
    information = measurement.transpose() * precision * measurement
    update = second * (common * one + information * first) - common * first
    places = [(i, j) for i in range(size) for j in range(size)]
    return {
        "denominator": poly_data(below),
        "predicted": [[poly_data(entry) for entry in row] for row in before],
        "updated": [[poly_data(entry) for entry in row] for row in after],
        "precision": {
            "numerators": [
                [poly_data(_element(precision, i, j)) for j in range(len(row))]
                for i, row in enumerate(model["measurement_noise"])
            ],
            "denominator": poly_data(scale),
        },
        "innovation": _innovation(step, tower),
        "prediction": {
            f"{i + 1},{j + 1}": _written(tower, _element(prediction, i, j))
            for i, j in places
            if i <= j
        },
        "update": {f"{i + 1},{j + 1}": _written(tower, _element(update, i, j)) for i, j in places},
    }


def _common(tower: Tower, *names: Any) -> tuple[Poly, list[list[list[Poly]]]]:
    """The least common denominator of all named entries, and their numerators over it."""
    squares = [[[tower.elements[name] for name in row] for row in rows] for rows in names]
    below: Poly = tower.ring.one
    for entry in (entry for rows in squares for row in rows for entry in row):
        below = below.lcm(entry.den)
    return below, [
        [[entry.num * below.quo(entry.den) for entry in row] for row in rows] for rows in squares
    ]


def _precision(tower: Tower, rows: list[list[Any]]) -> tuple[DomainMatrix, Poly]:
    """V and w with R V = w I: the adjugate and the determinant, over one denominator."""
    noise = matrix_of(rows)
    inverse = noise.adjugate() / noise.det()
    entries = [[tower.fraction(entry) for entry in row] for row in inverse.tolist()]
    scale: Poly = tower.ring.one
    for entry in (entry for row in entries for entry in row):
        scale = scale.lcm(entry.den)
    return (
        _wrapped(tower, [[entry.num * scale.quo(entry.den) for entry in row] for row in entries]),
        scale,
    )


def _innovation(step: Step, tower: Tower) -> list[dict[str, Any]]:
    """Positive forms of the leading minors of H M H' + R."""
    parts = step.relation.parts
    model = parts["model"]
    predicted = sp.ImmutableDenseMatrix(
        [[real(name) for name in row] for row in parts["predicted"]]
    )
    measurement = matrix_of(model["measurement"])
    rows = measurement * predicted * measurement.T + matrix_of(model["measurement_noise"])
    forms = step.hint.get("innovation") or [
        sp.expand(rows[:n, :n].det()) for n in range(1, rows.rows + 1)
    ]
    return [shown(tower, form) for form in forms]


def _matrix(tower: Tower, rows: list[list[Any]]) -> DomainMatrix:
    """Entries of the model as polynomials of the tower."""
    entries = [[tower.fraction(entry) for entry in row] for row in matrix_of(rows).tolist()]
    if any(entry.den != tower.ring.one for row in entries for entry in row):
        raise ValueError(f"entries that are polynomials in tower {tower.name} are wanted: {rows}")
    return _wrapped(tower, [[entry.num for entry in row] for row in entries])


def _wrapped(tower: Tower, rows: list[list[Poly]]) -> DomainMatrix:
    domain = tower.ring.to_domain()
    converted = [[domain.convert(entry) for entry in row] for row in rows]
    return DomainMatrix(converted, (len(rows), len(rows[0])), domain)


def _scalar(tower: Tower, value: Poly, size: int) -> DomainMatrix:
    zero = tower.ring.zero
    return _wrapped(tower, [[value if i == j else zero for j in range(size)] for i in range(size)])


def _element(matrix: DomainMatrix, row: int, column: int) -> Poly:
    return matrix[row, column].element


def _written(tower: Tower, residual: Poly) -> list[Any]:
    return [poly_data(part) for part in cofactors(tower, residual)]
