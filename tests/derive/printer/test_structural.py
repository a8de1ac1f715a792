"""Bounds from a program's shape: against brute force, without the help of the other pass."""

from __future__ import annotations

from collections.abc import Callable
from contextlib import suppress
from fractions import Fraction
from typing import Any

import numpy as np
import pytest
from graph_kernels import several_of, two_inputs
from hypothesis import given, settings
from hypothesis import strategies as st
from pair_points import outside_bounds
from positive_graphs import positive_graphs
from samples import samples

from gainproof.derive.printer import box_search, proof
from gainproof.derive.printer.adjoint import Adjoint
from gainproof.derive.printer.bound import prove
from gainproof.derive.printer.formats import FLOAT32, FLOAT64, FORMATS, Format
from gainproof.derive.printer.graph import GraphBuilder, Node
from gainproof.derive.printer.kernel import Kernel
from gainproof.derive.printer.program import program
from gainproof.derive.printer.step_ranges import PrintingError
from gainproof.derive.printer.structural import Structural, measured_by_parts

SLACK = Fraction(2, 100)


class Blind(Adjoint):
    """The other pass, proving nothing."""

    def __init__(self, *given: Any) -> None:
        super().__init__(*given)
        self.upper[:] = np.inf


@pytest.fixture
def alone(monkeypatch: pytest.MonkeyPatch) -> None:
    """Only the shape is looked at, in the first boxes."""
    monkeypatch.setattr(proof, "Adjoint", Blind)
    monkeypatch.setattr(box_search, "WORK", 0)


def roundings(kernel: Kernel, form: Format = FLOAT64) -> Fraction:
    """The bound of the first output in units of u."""
    return 2 * prove(kernel, form).outputs[0].bound


@pytest.mark.usefixtures("alone")
@pytest.mark.parametrize("form", FORMATS, ids=lambda form: form.name)
@pytest.mark.parametrize(
    ("expected", "write"),
    [
        (0, lambda _, x, _z: x / 4),
        (1, lambda _, x, z: x * z),
        (2, lambda _, x, z: x + 3 * z),
        (3, lambda _, x, z: (x + z) * (x + z)),
        (Fraction(5, 2), lambda b, x, z: b.sqrt(x * z * z + x) / 4),
        (4, lambda b, x, z: b.sqrt(x + z) / b.sqrt(x + z)),  # never taken for 1
        (4, lambda _, x, z: (x + z) / ((x + z) * z)),
    ],
)
def test_known_bounds(expected: Fraction, form: Format, write: Any) -> None:
    """Of sums the larger and one more, of products and quotients the sum, of roots half."""
    assert expected <= roundings(two_inputs(write), form) <= expected + SLACK


@pytest.mark.usefixtures("alone")
def test_a_planted_rounding_raises_the_bound() -> None:
    def planted(extra: int) -> Fraction:
        return roundings(two_inputs(lambda b, x, z: b.sqrt(x * 3**extra + z) * z))

    assert planted(1) >= planted(0) + Fraction(1, 2) - SLACK


@pytest.mark.usefixtures("alone")
@given(positive_graphs(), st.integers(0, 2**32))
@settings(max_examples=samples(8), deadline=None)
def test_random_positive_graphs(kernel: Kernel, seed: int) -> None:
    with suppress(PrintingError):  # refused: an over- or underflow, mostly of float32
        assert not outside_bounds(kernel, 40, seed)


def changing(scale: Callable[[Node, Node, Node], Node], name: str = "gap") -> Kernel:
    """x z 3 less the root of x + z, over a scale; they are equal on a curve."""
    b = GraphBuilder()
    x, z = b.symbol("x"), b.symbol("z")
    grows, falls = x * z * 3, b.sqrt(x + z)
    gap = grows - falls
    graph = b.graph({"y": gap, "_s": scale(grows, falls, x)}, {name: gap})
    return several_of(graph, "1e-6", "1e6", {"y": "_s"}, {"gap": "a test"})


@pytest.mark.usefixtures("alone")
@pytest.mark.parametrize("form", FORMATS, ids=lambda form: form.name)
def test_a_difference_over_the_sum_of_its_operands(form: Format) -> None:
    """The larger error of both and one more; in whatever order they are added."""
    for kernel in (changing(lambda p, q, _: p + q), changing(lambda p, q, _: q + p)):
        assert 3 <= roundings(kernel, form) <= 3 + SLACK
        assert not outside_bounds(kernel, 300, 3)


def test_the_other_pass_proves_such_a_difference_too(monkeypatch: pytest.MonkeyPatch) -> None:
    monkeypatch.setattr(Structural, "bounds", lambda _, _ends: np.inf)
    kernel = changing(lambda p, q, _: p + q)
    assert roundings(kernel) <= 4
    assert not outside_bounds(kernel, 300, 4)
    (found,) = prove(kernel, FLOAT64).outputs
    assert found.amplification["gap"] < 1.01


@pytest.mark.parametrize(
    "scale", [lambda p, _q, x: p + x, lambda p, _q, _: p, lambda p, q, _: (p + q) * 3 / 3]
)
def test_a_difference_over_something_else_gets_nothing(scale: Any) -> None:
    """Over what may be smaller than its operands a difference has no bound."""
    with pytest.MonkeyPatch.context() as patch:
        patch.setattr(proof, "Adjoint", Blind)
        with pytest.raises(PrintingError):
            prove(changing(scale), FLOAT64)


def test_what_boxes_do_not_prove_is_refused() -> None:
    with pytest.raises(PrintingError, match=r"not below .* epsilon: .*gap.* cancels"):
        prove(changing(lambda p, _q, _: p), FLOAT64)


def test_an_unnamed_difference_is_refused() -> None:
    with pytest.raises(PrintingError, match=r"a subtraction of computed values"):
        prove(changing(lambda p, q, _: p + q, "other"), FLOAT64)


@pytest.mark.usefixtures("alone")
def test_nothing_is_proved_where_a_step_leaves_the_normal_range() -> None:
    inner = two_inputs(lambda _, x, z: x * z / 10**30 * 10**30)
    assert roundings(inner) < 4
    with pytest.raises(PrintingError, match="subnormal"):
        prove(inner, FLOAT32)
    vast = two_inputs(lambda _, x, z: x * z * 10**30 / 10**30)
    assert roundings(vast) < 4
    with pytest.raises(PrintingError, match="overflow"):
        prove(vast, FLOAT32)


@pytest.mark.usefixtures("alone")
@pytest.mark.parametrize("fault", ["smaller", "other share", "no rounding"])
def test_the_comparison_can_fail(fault: str, monkeypatch: pytest.MonkeyPatch) -> None:
    """A prover that errs in one place is found out by measuring."""
    kernel = two_inputs(lambda _, x, z: x * x * x * x + z, lower=64, upper=1024)
    assert not outside_bounds(kernel, 500, 1)
    right = Structural._weighed

    def wrong(self: Structural, value: Any, first: Any, second: Any) -> Any:
        match fault:
            case "smaller":
                return np.minimum(first, second) + 1.0
            case "other share":
                return right(self, value, second, first)
        return right(self, value, first, second) - 2.0

    monkeypatch.setattr(Structural, "_weighed", wrong)
    assert outside_bounds(kernel, 500, 1)


def turned(divisor: int) -> Kernel:
    """z less a term that changes its sign at x = 2, over z and its size or a part."""
    b = GraphBuilder()
    x, z = b.symbol("x"), b.symbol("z")
    other = (x - 2) * z
    gap = z - other
    graph = b.graph(
        {"y": gap, "_s": z + b.absolute(other / divisor if divisor > 1 else other)}, {"gap": gap}
    )
    return several_of(graph, "1e-4", "1e4", {"y": "_s"}, {"gap": "a test"})


@pytest.mark.parametrize("form", FORMATS, ids=lambda form: form.name)
def test_a_difference_is_measured_by_the_magnitudes_of_its_terms(form: Format) -> None:
    assert 1 < roundings(turned(1), form) <= 3 + SLACK
    assert roundings(turned(3), form) > 4


def test_only_the_terms_themselves_measure_a_difference() -> None:
    for divisor in (1, 3):
        steps = program(turned(divisor).graph)
        places = steps.outputs["y"], steps.outputs["_s"]
        assert measured_by_parts(steps, *places) == (divisor == 1)


@pytest.mark.usefixtures("alone")
@pytest.mark.parametrize("form", FORMATS, ids=lambda form: form.name)
def test_a_constant_of_two_parts_costs_two_roundings(form: Format) -> None:
    kernel = two_inputs(lambda b, x, z: b.absolute(x - b.sqrt(b.number(3))) * z)
    assert 3 <= roundings(kernel, form) <= 3 + SLACK
