"""Inputs that may be 0: bounds that hold there too, what is refused, and the guard."""

from __future__ import annotations

from collections.abc import Callable
from dataclasses import replace
from itertools import product
from typing import Any

import numpy as np
import pytest
from graph_kernels import function_of, simple, text_of, two_inputs, worst_error
from numpy.typing import NDArray

from gainproof.derive.printer.bound import prove
from gainproof.derive.printer.formats import FLOAT64, FORMATS
from gainproof.derive.printer.graph import GraphBuilder, Node
from gainproof.derive.printer.kernel import Kernel, Output
from gainproof.derive.printer.step_ranges import PrintingError
from gainproof.derive.printer.zero_inputs import zero_cases

Write = Callable[[GraphBuilder, Node, Node], Node]


def admitting(write: Write, *names: str) -> Kernel:
    """A kernel of x and z where the named inputs may be 0."""
    kernel = two_inputs(write)
    inputs = tuple(replace(given, zero=given.name in names) for given in kernel.inputs)
    return replace(kernel, inputs=inputs)


SUMS: tuple[Write, ...] = (
    lambda _, x, z: x * (1 + z) + z,
    lambda _, x, z: (x * x + z) / (x + 3) + 1,
    lambda b, x, z: b.sqrt(x + z * z) * (2 + x * z) + x / (1 + z),
    lambda b, x, z: (b.sqrt(x) * z + x + "1/3") / (z + 1),
    lambda _, x, z: z * (x + 2) + -(x * -(z + 2)),
)


@pytest.mark.alike
@pytest.mark.parametrize("name", ["x", "z"])
@pytest.mark.parametrize("write", SUMS)
def test_bounds_hold_where_an_input_is_zero(write: Write, name: str) -> None:
    kernel = admitting(write, name)
    function = function_of(kernel)
    spread = [*(10.0 ** np.linspace(-5, 5, 41))]
    for form in FORMATS:
        proved = prove(kernel, form)
        pairs = [*product(spread, spread), *((0.0, y) for y in spread)]
        columns = np.array(pairs, form.name).T[:: 1 if name == "x" else -1]
        points = [{"x": float(a), "z": float(b)} for a, b in columns.T]
        worst, place = worst_error(kernel, function(*columns), 0, points)
        assert worst <= float(proved.outputs[0].bound) * form.epsilon, place


def test_a_case_is_what_is_left() -> None:
    b = GraphBuilder()
    x, z = b.symbol("x"), b.symbol("z")
    kernel = admitting(lambda _, x, _z: x, "x")
    graph = b.graph({"y": (x * (z * z) + z) / (1 + x), "w": x * z, "v": x + z})
    outputs = tuple(Output(name, "a value") for name in "ywv")
    (case,) = zero_cases(replace(kernel, graph=graph, outputs=outputs))
    assert case.rows == (0, 2), "w is 0"
    assert [output.name for output in case.kernel.outputs] == ["y", "v", "_finite_0"]
    assert case.kernel.graph["outputs"]["v"] == case.kernel.graph["nodes"].index(["symbol", "z"])
    assert [given.name for given in case.kernel.inputs] == ["z"]


def test_the_larger_bound_is_stated() -> None:
    """x + z z z: the roundings of the product weigh all the more where there is no x."""
    plain = two_inputs(lambda _, x, z: x + z * z * z, lower=1, upper="3/2")
    inputs = tuple(replace(given, zero=given.name == "x") for given in plain.inputs)
    kernel = replace(plain, inputs=inputs)
    (case,) = zero_cases(kernel)
    stated = [prove(each, FLOAT64).outputs[0].bound for each in (kernel, plain, case.kernel)]
    assert stated[0] == max(stated[1:])
    assert case.greater(np.array([1.0]), np.array([9.0])).tolist() == [9.0]
    assert case.of(np.array([3.0])).tolist() == [3.0]


@pytest.mark.parametrize(
    ("write", "reason"),
    [
        (lambda _b, x, z: z / x, "div has no value where"),
        (lambda b, x, z: b.select(x, "1/2", x + z, z), "call has no value where"),
        (lambda _b, x, _z: x, "nothing is left"),
        # 0 times what is beyond the largest number
        (lambda _b, x, z: x * (1 / (x + _power(z, 60))) + z, "_finite_0"),
    ],
)
def test_what_has_no_bound_is_refused(write: Write, reason: str) -> None:
    plain = two_inputs(write, lower="1e-6", upper=1)
    assert prove(plain, FLOAT64)
    inputs = tuple(replace(given, zero=given.name == "x") for given in plain.inputs)
    with pytest.raises(PrintingError, match=reason):
        prove(replace(plain, inputs=inputs), FLOAT64)


def _power(z: Node, count: int) -> Node:
    result = z
    for _ in range(count - 1):
        result = result * z
    return result


def test_one_input_admits_no_zero() -> None:
    with pytest.raises(PrintingError, match="several inputs only"):
        prove(simple(lambda _, x: x + 1, lower="1", upper="2", zero=True), FLOAT64)


@pytest.mark.parametrize("kind", [np.float64, np.float32])
def test_the_guard(kind: type[np.floating[Any]]) -> None:
    kernel = admitting(lambda _, x, z: x * z + z, "x")
    assert "x: an argument; 0 or a number at least 1e-6 and at most 1e6." in text_of(kernel)
    assert "zero=True," in text_of(kernel)
    function = function_of(kernel)
    assert function(np.array([0.0, -0.0, 1.0], kind), kind(2))[0].tolist() == [2.0, 2.0, 4.0]
    for bad in (1e-7, -1e-7, np.nan, 1e7):
        with pytest.raises(ValueError, match="x must be 0 or a number at least 1e-6"):
            function(np.array([0.0, bad], kind), kind(2))
    with pytest.raises(ValueError, match="z must be a number at least 1e-6"):
        function(kind(1), kind(0))


def test_exactness_is_what_the_proof_takes_it_for() -> None:
    """0 + y = y, 0 y = 0 and 0/y = 0, bit for bit, in both formats."""
    for name in ("float64", "float32"):
        y: NDArray[Any] = np.array([np.finfo(name).tiny, 1 / 3, np.finfo(name).max], name)
        zero: NDArray[Any] = np.zeros(3, name)
        assert (y + zero).tobytes() == y.tobytes() == (zero + y).tobytes()
        assert not (y * zero).any()
        assert not (zero / y).any()
