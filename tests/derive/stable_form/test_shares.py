"""Roots of sums of squares whose squares would overflow: by shares, proved and measured."""

from __future__ import annotations

import warnings
from fractions import Fraction

import mpmath
import numpy as np
import pytest
import sympy as sp
from graph_kernels import function_of

from gainproof.derive.expression import real
from gainproof.derive.printer.bound import prove
from gainproof.derive.printer.formats import FLOAT64
from gainproof.derive.printer.graph import Graph
from gainproof.derive.printer.kernel import Kernel, Output, closed
from gainproof.derive.stable_form import stable
from gainproof.derive.stable_form.candidates import BY_SHARES, _candidates, _orders
from gainproof.derive.stable_form.coordinates import coordinates
from gainproof.derive.stable_form.graph_nodes import Emission
from gainproof.verify.certificate import check

X, Y = real("x"), real("y")
WIDE = {name: closed(name, "a number", "1e-300", "1e300", ("1e-36", "1e36")) for name in "xy"}


def kernel(graph: Graph, names: str) -> Kernel:
    words = ("kernel", "Result", "A kernel under test.", ("y = f(x)",))
    inputs = tuple(WIDE[name] for name in names)
    return Kernel(*words, inputs, (Output("value", "a value"),), graph, "none")


def written(expression: sp.Expr, names: str) -> list[Graph]:
    """What is written by shares, in every order."""
    inputs = [WIDE[name] for name in names]
    (domain, *_) = coordinates(inputs)
    every = _candidates(expression, domain, domain, "y", Fraction(1), _orders(True))
    return [each.graph for each in every]


@pytest.mark.parametrize(
    ("expression", "names"),
    [
        (sp.sqrt(X**2 + Y**2), "xy"),
        pytest.param(sp.sqrt(4 * X**2 + Y**2 / 9), "xy", marks=pytest.mark.thorough),
    ],
)
def test_the_error_is_within_the_bound_where_squares_overflow(
    expression: sp.Expr, names: str
) -> None:
    (graph, *_) = written(expression, names)
    found = kernel(graph, names)
    bound = prove(found, FLOAT64).outputs[0].bound
    assert 1 < bound < 6
    rng = np.random.default_rng(3)
    exponents = rng.uniform(-300, 300, (len(names), 400))
    exponents[1:, ::2] = exponents[0, ::2] + rng.uniform(-3, 3, (len(names) - 1, 200))
    given = [np.clip(10.0**each, 1e-300, 1e300) for each in exponents]
    with warnings.catch_warnings():
        warnings.simplefilter("error")
        (values,) = function_of(found)(*given)
    with mpmath.workdps(60):
        exact = sp.lambdify([real(name) for name in names], expression, "mpmath")
        for place, value in enumerate(values):
            true = exact(*(mpmath.mpf(float(each[place])) for each in given))
            assert abs(mpmath.mpf(float(value)) / true - 1) <= float(bound) * 2.0**-52


def test_what_is_no_sum_of_squares_is_written_as_ever() -> None:
    for expression in (sp.sqrt(X + Y), sp.sqrt(X**2 + X * Y), sp.sqrt(X**3 + Y**2)):
        graphs = written(expression, "xy")
        domain = next(iter(coordinates([WIDE["x"], WIDE["y"]])))
        plain = _candidates(expression, domain, domain, "y", Fraction(1), _orders(False))
        assert all(graph in [each.graph for each in plain] for graph in graphs[:1])


@pytest.mark.thorough
def test_it_is_found_where_nothing_else_has_a_bound() -> None:
    form = stable({"y": sp.sqrt(X**2 + Y**2)}, [WIDE["x"], WIDE["y"]])
    bound = form.bounds["y"]
    assert bound is not None
    assert bound.bound <= 3.1
    assert not form.refusals
    assert BY_SHARES in form.rules["y"]
    assert check(form.certificate, claims=form.claims).accepted
    near = [closed(name, "a number", "1e-100", "1e100") for name in "xy"]
    assert BY_SHARES not in stable({"y": sp.sqrt(X**2 + Y**2)}, near).rules["y"]


@pytest.mark.thorough
def test_another_sum_in_its_place_is_not_shown(monkeypatch: pytest.MonkeyPatch) -> None:
    """The proof is of what is written: with half of each share it does not come about."""
    right = Emission._by_shares

    def wrong(self: Emission, terms: object) -> object:
        found = right(self, terms)  # type: ignore[arg-type]
        return None if found is None else found * 2

    monkeypatch.setattr(Emission, "_by_shares", wrong)
    form = stable({"y": sp.sqrt(X**2 + Y**2)}, [WIDE["x"], WIDE["y"]])
    assert not check(form.certificate, claims=form.claims).accepted
