"""Inputs of any magnitude from 0 on: domain in words, guard, bounds with what underflows."""

from __future__ import annotations

from typing import Any

import numpy as np
import pytest

from gainproof.derive.printer.bound import prove
from gainproof.derive.printer.docstring import wanted_text
from gainproof.derive.printer.domain import product
from gainproof.derive.printer.formats import FLOAT32, FLOAT64
from gainproof.derive.printer.graph import GraphBuilder
from gainproof.derive.printer.kernel import Kernel, Output, closed, signed
from gainproof.derive.printer.step_ranges import PrintingError
from gainproof.generated import filter_step

SINGLE = ("0", "1e8")
X, Y = (signed(name, "a number", "0", "1e40", SINGLE) for name in "xy")


def kernel(by_terms: bool) -> Kernel:
    builder = GraphBuilder()
    x, y = builder.symbol("x"), builder.symbol("y")
    graph = builder.graph({"z": x * y + x})
    return Kernel("f", "F", "", (), (X, Y), (Output("z", "", by_terms=by_terms),), graph, "")


def test_the_domain_reaches_from_0() -> None:
    assert wanted_text(X) == "of magnitude at most 1e40, in float32 1e8"
    assert product((X, Y), FLOAT64) == ((0.0, 1e40), (0.0, 1e40))
    with pytest.raises(PrintingError, match="positive normal numbers"):
        product((X, closed("y", "", "0", "1")), FLOAT64)
    # the lower end of one format alone is not that of both
    assert wanted_text(signed("x", "", "1e-9", "1", ("0", "1"))).startswith("0 or of magnitude")


@pytest.mark.parametrize("form", [FLOAT64, FLOAT32])
def test_what_underflows_stands_beside_the_bound(form: Any) -> None:
    found = prove(kernel(True), form)
    (bound,) = found.outputs
    assert bound.bound <= 2
    small = np.array([form.least], np.float64 if form is FLOAT64 else np.float32)
    # x y is half a unit of the subnormals at most, and comes as 0: x + x y is off by x y
    assert float(small[0]) * 0.5 <= bound.beside


def test_terms_that_cancel_are_measured_by_them() -> None:
    with pytest.raises(PrintingError, match="may cancel"):
        prove(kernel(False), FLOAT64)


NUMBERS = [0.0, -0.0, 5e-324, -5e-324, 1e-310, 1e40, -1e40, np.nextafter(1e40, 0)]


@pytest.mark.parametrize("count", [1, 3, 70_000])
def test_the_guard_admits_what_the_domain_says_and_nothing_else(count: int) -> None:
    """Its quick look at a sum of squares decides nothing that the exact one would not."""
    for value in NUMBERS:
        x = np.full(count, 1.0)
        x[-1] = value
        filter_step.step_two_states(x, 1.0, 1.0, 1.0, 0.5, 0.1)
    for value in (np.nextafter(1e40, np.inf), -1.1e40, 1e300, np.inf, -np.inf, np.nan):
        x = np.full(count, 1.0)
        x[-1] = value
        place = f" at index {count - 1}"
        told = rf"position must be of magnitude at most 1e40, .*, got .*{place}$"
        with pytest.raises(ValueError, match=told):
            filter_step.step_two_states(x, 1.0, 1.0, 1.0, 0.5, 0.1)


def test_many_numbers_of_the_largest_magnitude_are_admitted() -> None:
    """Where the sum of squares is beyond the quick limit, number by number."""
    x = np.full(70_000, -1e40)
    found = filter_step.step_two_states(x, 0.0, 1.0, 0.0, 0.5, 0.1)
    assert (np.asarray(found.updated_position) == -5e39).all()
