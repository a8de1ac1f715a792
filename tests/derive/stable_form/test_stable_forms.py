"""Forms without cancellation that are found: proved equal by the checker, with a proved bound."""

from __future__ import annotations

from copy import deepcopy
from fractions import Fraction

import numpy as np
import pytest
import sympy as sp

from gainproof.derive.expression import real
from gainproof.derive.printer.kernel import Input, closed
from gainproof.derive.stable_form import NoReading, StableForm, stable
from gainproof.derive.stable_form.coordinates import coordinates
from gainproof.verify.certificate import check

X, Z = real("x"), real("z")
ROOT = sp.sqrt(X**2 + 8 * X)
LONG = pytest.mark.thorough
POSITIVE = (Input("x", "a number"),)
BELOW_ONE = (Input("x", "a number", "0", "1"),)
PAIR = (closed("x", "a number", "1e-7", "1e7"), closed("z", "a number", "1e-7", "1e7"))


def accepted(form: StableForm) -> bool:
    """What the checker says of the certificate, which must claim what is expected."""
    return check(form.certificate, claims=form.claims).accepted


@pytest.mark.alike
@pytest.mark.parametrize(
    ("expression", "inputs", "most"),
    [
        pytest.param(((X + 4) * ROOT - X**2 - 8 * X) / 8, POSITIVE, 2.6, marks=LONG),
        pytest.param((X**2 + 4 * X - X * ROOT) / 4, POSITIVE, 2, marks=LONG),
        (sp.sqrt(X + 1) - sp.sqrt(X), POSITIVE, 2.6),
        (2 * (2 - X) - 4 * sp.sqrt(1 - X), BELOW_ONE, 2.6),
        (X**2 - X + 1, BELOW_ONE, 2.6),
        (1 / (X + 1) - 2 / X + 1 / (X - 1), (Input("x", "a number", "2"),), 3.1),
        (sp.sqrt(X + 1) - 2 * sp.sqrt(X) + sp.sqrt(X - 1), (Input("x", "", "2"),), 4.1),
        (sp.sqrt(X**2 + Z**2) - X, PAIR, 2.6),
        (sp.sqrt(sp.sqrt(X) / (X + 3)), PAIR[:1], 3.1),
        (X / sp.sqrt(1 + X / 2 - sp.sqrt(2 * X)), (Input("x", "a number", "0", "2"),), 3.6),
    ],
)
def test_no_subtraction_is_left(
    expression: sp.Expr, inputs: tuple[Input, ...], most: float
) -> None:
    form = stable({"y": expression}, inputs)
    assert not form.cancellations
    bound = form.bounds["y"]
    assert bound is not None
    assert bound.bound <= most
    assert accepted(form)


def test_ends_are_numbers_of_both_formats() -> None:
    """1e-1 as a number of either format lies above one tenth, 3e-1 as one of float64 below."""
    for end in ("1/10", "3/10"):
        (_, shifted) = coordinates((Input("x", "a number", end, lower_open=False),))
        assert shifted[0].low <= min(Fraction(end), Fraction(float(Fraction(end))))
        assert shifted[0].low <= Fraction(float(np.float32(float(Fraction(end)))))


def test_a_subtraction_that_is_left_is_named() -> None:
    """x^3 - 3 x + 1 changes its sign where x is no rational number."""
    form = stable({"y": X**3 - 3 * X + 1}, (Input("x", "a number", "0", "10"),))
    assert list(form.cancellations) == ["y_difference_1"]
    assert form.scales == {"y": "y_scale_"}
    assert accepted(form)


def test_another_graph_is_rejected() -> None:
    """A certificate of the same claims with one node altered."""
    form = stable({"y": sp.sqrt(X + 1) - sp.sqrt(X)}, POSITIVE)
    altered = deepcopy(form.certificate)
    nodes = altered["programs"]["stable_y"]["graph"]["nodes"]
    numbers = [node for node in nodes if node[0] == "number"]
    for node in numbers:
        value, node[1] = node[1], "3"
        assert not check(altered, claims=form.claims).accepted
        node[1] = value
    assert check(altered, claims=form.claims).accepted


@pytest.mark.parametrize(
    "expression",
    [sp.sqrt(X - 1), 1 / (X - 1), sp.sin(X), sp.gamma(X), X ** sp.Rational(1, 3), Z, X - X],
)
def test_what_cannot_be_read_is_refused(expression: sp.Expr) -> None:
    with pytest.raises(NoReading):
        stable({"y": expression}, POSITIVE)


def test_a_budget_ends_the_search_with_the_best_so_far() -> None:
    """More ways of writing never make the bound larger, and one is enough for a form."""
    value = ((X + 4) * ROOT - X**2 - 8 * X) / 8
    bounds = []
    for budget in (1, 2, 20, 400):
        form = stable({"y": value}, POSITIVE, budget)
        found = form.bounds["y"]
        assert found is not None
        assert form.tried <= budget
        assert not form.cancellations
        assert accepted(form)
        bounds.append(found.bound)
    assert bounds == sorted(bounds, reverse=True)
    assert bounds[0] > bounds[-1]
    with pytest.raises(ValueError, match="a budget of 1 or more is wanted, 0 came"):
        stable({"y": value}, POSITIVE, 0)
