"""Three states: characteristic polynomials, Schur-Cohn rows, a steady state with rational index."""

from __future__ import annotations

from fractions import Fraction
from typing import Any

import mpmath as mp
import numpy as np
import pytest
import sympy as sp
from hypothesis import given, settings
from hypothesis import strategies as st
from samples import samples
from tests.verify.certificate.toy_writer import fraction, poly, statement

from gainproof.verify.certificate import check_statement
from gainproof.verify.certificate.field import Field
from gainproof.verify.certificate.matrix import (
    Matrix,
    characteristic_polynomial,
    determinant,
    principal_coefficients,
)
from gainproof.verify.certificate.polynomial import Ring
from gainproof.verify.certificate.ratio import number
from gainproof.verify.certificate.rejection import Meter

Data = dict[str, Any]

x = sp.Symbol("x")
STEP = sp.Matrix([[1, 1, sp.Rational(1, 2)], [0, 1, 1], [0, 0, 1]])
MODEL: Data = {
    "name": "acceleration-increments",
    "title": "Acceleration increments, three states",
    "transition": [["1", "1", "1/2"], ["0", "1", "1"], ["0", "0", "1"]],
    "process_noise": [["0", "0", "0"], ["0", "0", "0"], ["0", "0", "1"]],
    "measurement": [["1", "0", "0"]],
    "measurement_noise": [["1"]],
}
small = st.fractions(-2, 2, max_denominator=4)


@settings(deadline=None, max_examples=samples(12))
@given(
    st.integers(1, 4).flatmap(
        lambda n: st.lists(st.lists(small, min_size=n, max_size=n), min_size=n, max_size=n)
    )
)
def test_characteristic_polynomial(rows: list[list[Fraction]]) -> None:
    field = Field(Ring(0, Meter()), (), (), ())
    entries = tuple(tuple(number(field, value) for value in row) for row in rows)
    matrix = sp.Matrix([[sp.Rational(v.numerator, v.denominator) for v in row] for row in rows])
    found = [c.constant_value() for c in characteristic_polynomial(Matrix(entries))]
    wanted = matrix.charpoly(x).all_coeffs()[::-1]
    assert [sp.Rational(c.numerator, c.denominator) for c in found if c is not None] == wanted
    same = [c.constant_value() for c in principal_coefficients(Matrix(entries))]
    assert same == found
    value = determinant(entries).constant_value()
    assert value is not None
    assert sp.Rational(value.numerator, value.denominator) == matrix.det()


def _rows(gain: list[Fraction]) -> list[Fraction]:
    """The quantities of Schur and Cohn from SymPy's characteristic polynomial."""
    column = sp.Matrix([sp.Rational(g.numerator, g.denominator) for g in gain])
    loop = STEP * (sp.eye(3) - column * sp.Matrix([[1, 0, 0]]))
    row = [Fraction(int(c.p), int(c.q)) for c in loop.charpoly(x).all_coeffs()[::-1]]
    found = []
    while len(row) > 1:
        low, high, degree = row[0], row[-1], len(row) - 1
        found += [high - low, high + low]
        row = [high * row[k + 1] - low * row[degree - k - 1] for k in range(degree)]
    return found


@settings(deadline=None, max_examples=samples(24))
@given(st.lists(st.fractions(Fraction(1, 20), 1, max_denominator=20), min_size=3, max_size=3))
def test_stable_exactly_if_inside_the_circle(gain: list[Fraction]) -> None:
    elements = {
        f"k{i}": fraction(sp.Rational(g.numerator, g.denominator), 1, [x])
        for i, g in enumerate(gain)
    }
    values = [fraction(sp.Rational(v.numerator, v.denominator), 1, [x]) for v in _rows(gain)]
    certificate = {
        "format": "gainproof certificate 1",
        "subject": "gains",
        "programs": {},
        "towers": {
            "main": {
                "parameters": [{"symbol": "x", "above": "0"}],
                "generators": [],
                "elements": elements,
            }
        },
        "statements": [
            statement(
                "loop", "stable", {"model": MODEL, "gain": ["k0", "k1", "k2"]}, {"values": values}
            )
        ],
    }
    loop = np.array(STEP.tolist(), dtype=float) @ (
        np.eye(3) - np.outer([float(g) for g in gain], [1.0, 0.0, 0.0])
    )
    radius = float(max(abs(np.linalg.eigvals(loop))))
    if abs(radius - 1) > 1e-6:
        accepted = check_statement(certificate, "loop").status == "proved"
        assert accepted == (radius < 1)


def _steady_state() -> Data:
    """w = 1/(1 + x), alpha = 1 - w^2, beta = 2 (1 - w)^2, gamma = 2 (1 - w)^3/(1 + w)."""
    w = 1 / (1 + x)
    gain = sp.Matrix([1 - w**2, 2 * (1 - w) ** 2, 2 * (1 - w) ** 3 / (1 + w)])
    index = sp.cancel(2 * (1 - w) ** 3 / (w * (1 + w)))
    noise = sp.diag(0, 0, index**2)
    names = sp.symbols("m:6")
    predicted = sp.Matrix(
        [
            [names[0], names[1], names[2]],
            [names[1], names[3], names[4]],
            [names[2], names[4], names[5]],
        ]
    )
    updated = (sp.eye(3) - gain * sp.Matrix([[1, 0, 0]])) * predicted
    equations = list(predicted - STEP * updated * STEP.T - noise)
    (solution,) = sp.linsolve([*equations, names[0] * w**2 - gain[0]], names)
    m = predicted.subs(dict(zip(names, solution, strict=True))).applyfunc(sp.cancel)
    below = sp.lcm([sp.denom(entry) for entry in m])
    above = (m * below).applyfunc(sp.cancel)
    after = (m - gain * m[0, :]).applyfunc(sp.cancel)
    elements = {"tracking_index": index} | {f"k{i}": gain[i] for i in range(3)}
    for i in range(3):
        for j in range(i, 3):
            elements |= {f"m{i}{j}": m[i, j], f"x{i}{j}": after[i, j]}
    written = {}
    for name, value in elements.items():
        top, bottom = sp.fraction(sp.cancel(value))
        written[name] = fraction(top, bottom, [x])

    def square(letter: str) -> list[list[str]]:
        return [[f"{letter}{min(i, j)}{max(i, j)}" for j in range(3)] for i in range(3)]

    return {
        "format": "gainproof certificate 1",
        "subject": "three",
        "programs": {},
        "towers": {
            "main": {
                "parameters": [{"symbol": "x", "above": "0"}],
                "generators": [],
                "elements": written,
            }
        },
        "statements": [
            statement(
                "steady",
                "riccati",
                {
                    "model": MODEL,
                    "predicted": square("m"),
                    "updated": square("x"),
                    "gain": ["k0", "k1", "k2"],
                    "index": "tracking_index",
                },
                {
                    "denominator": poly(below, [x]),
                    "numerators": [[poly(above[i, j], [x]) for j in range(3)] for i in range(3)],
                    "cofactors": {f"{i + 1},{j + 1}": [] for i in range(3) for j in range(i, 3)},
                },
            )
        ],
    }


@pytest.fixture(scope="module")
def steady() -> Data:
    return _steady_state()


def test_rational_index(steady: Data) -> None:
    result = check_statement(steady, "steady")
    assert result.status == "proved", result.reason


@pytest.mark.parametrize("change", ["noise", "index", "scale"])
def test_rational_index_is_checked(steady: Data, change: str) -> None:
    tower = steady["towers"]["main"]
    elements = tower["elements"]
    claim = steady["statements"][0]["claim"]
    if change == "noise":
        model = {
            **MODEL,
            "process_noise": [["1/4", "1/2", "1/2"], ["1/2", "1", "1"], ["1/2", "1", "1"]],
        }
        claim = {**claim, "model": model}
    elif change == "index":
        index = {**elements["tracking_index"], "den": poly(x + 1, [x])}
        elements = {**elements, "tracking_index": index}
    else:
        index = {
            key: [[c[0] + "0", c[1]] for c in terms] if key == "num" else terms
            for key, terms in elements["tracking_index"].items()
        }
        elements = {**elements, "tracking_index": index}
    altered = {
        **steady,
        "towers": {"main": {**tower, "elements": elements}},
        "statements": [{**steady["statements"][0], "claim": claim}],
    }
    assert "combination" in check_statement(altered, "steady").reason


def test_the_steady_state_by_iteration(steady: Data) -> None:
    """The toy itself, against the recursion, so that its acceptance means something."""
    del steady
    place = mp.mpf("0.7")
    w = 1 / (1 + place)
    index = 2 * (1 - w) ** 3 / (w * (1 + w))
    step = np.array(STEP.tolist(), dtype=float)
    covariance = np.eye(3)
    for _ in range(500):
        gain = covariance[:, :1] / (covariance[0, 0] + 1)
        covariance = step @ (covariance - gain @ covariance[:1]) @ step.T
        covariance[2, 2] += float(index) ** 2
    gain = covariance[:, 0] / (covariance[0, 0] + 1)
    assert np.allclose(
        gain, [float(1 - w**2), float(2 * (1 - w) ** 2), float(2 * (1 - w) ** 3 / (1 + w))]
    )
