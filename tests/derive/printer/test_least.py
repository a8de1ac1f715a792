"""Choices that are printed as the smaller of two numbers."""

from __future__ import annotations

from fractions import Fraction

import numpy as np
import pytest

from gainproof.derive.printer.arithmetic import Arithmetic
from gainproof.derive.printer.graph import GraphBuilder, Node
from gainproof.derive.printer.kernel import Input, Kernel, Output
from gainproof.derive.printer.minimum_choices import is_least

PLACE = Fraction(3, 4)


def kernel(limit: Fraction, below: str, above: str) -> Kernel:
    b = GraphBuilder()
    x = b.symbol("x")
    branches: dict[str, Node] = {
        "x": x,
        "4x": x * 4,
        "3x": x * 3,
        "3/4": b.number(PLACE),
        "3": b.number(3),
        "4": b.number(4),
        "3/x": 3 / x,
        "1/3": b.number(Fraction(1, 3)),
    }
    graph = b.graph({"y": b.select(x, limit, branches[below], branches[above])})
    return Kernel("k", "K", "", (), (Input("x", ""),), (Output("y", ""),), graph, "")


def found(limit: Fraction, below: str, above: str) -> bool:
    program = kernel(limit, below, above).program
    (step,) = (step for step in program.steps if step.operation == "select")
    return is_least(program, step)


@np.errstate(all="ignore")
@pytest.mark.parametrize(("below", "above"), [("x", "3/4"), ("4x", "3"), ("4", "3/x")])
def test_the_smaller_number_is_what_is_chosen(below: str, above: str) -> None:
    assert found(PLACE, below, above)
    made = kernel(PLACE, below, above)
    (block,) = (line for line in Arithmetic(made).lines if "minimum" in line)
    x = np.concatenate([np.nextafter(0.75, [0, 2]), [0.75, 5e-324, 1e308], np.logspace(-5, 5, 999)])
    for dtype in (np.float64, np.float32):
        given = x.astype(dtype)
        values = {
            "x": given,
            "4x": given * 4,
            "3/4": 0.75,
            "3": 3.0,
            "4": 4.0,
            "3/x": np.divide(3, given),
        }
        first, second = (np.asarray(values[each], dtype) for each in (below, above))
        chosen = np.where(given < dtype(0.75), first, second)
        assert np.array_equal(np.minimum(first, second), chosen), block


@pytest.mark.parametrize(
    ("limit", "below", "above"),
    [
        (PLACE, "3/4", "x"),  # the larger
        (PLACE, "3/x", "4"),
        (PLACE, "4x", "4"),  # not the same at 3/4
        (PLACE, "3", "3/x"),
        (PLACE, "3x", "3"),  # a product that is rounded
        (Fraction(1, 3), "x", "1/3"),  # a number that is rounded
    ],
)
def test_other_choices_are_not(limit: Fraction, below: str, above: str) -> None:
    assert not found(limit, below, above)
    assert not any("minimum" in line for line in Arithmetic(kernel(limit, below, above)).lines)
