"""Every two-state model within the method's reach has kernels with proved bounds."""

from __future__ import annotations

from fractions import Fraction
from itertools import product

import pytest
from one_of_each import cases

from gainproof.derive.printer.bound import prove
from gainproof.derive.printer.formats import FLOAT32, FLOAT64, Format
from gainproof.derive.printer.kernel import Input, Kernel, Output
from gainproof.derive.steady_state.kernels import index_graph

HALF = Fraction(1, 2)


RATIOS = product((Fraction(0), HALF), (Fraction(0), Fraction(1, 1000), Fraction(2, 3), Fraction(1)))


@pytest.mark.parametrize(
    ("n", "e", "form"),
    cases(
        [(*ratios, form) for ratios in RATIOS for form in (FLOAT64, FLOAT32)],
        lambda case: case[2] is FLOAT64 or case[:2] == (HALF, Fraction(2, 3)),
    ),
    ids=lambda given_: getattr(given_, "name", str(given_)),
)
def test_kernels_have_bounds(e: Fraction, n: Fraction, form: Format) -> None:
    """Noise ratios at the ends, next to one and between: gains and derivatives keep the limits."""
    for name, most in (
        ("gains_with_derivatives", 16),
        ("predicted_covariance", 8),
        ("updated_covariance_derivatives", 16),
    ):
        graph = index_graph(e, n, name)
        outputs = tuple(Output(output, "a value") for output in graph["outputs"])
        index = Input("tracking_index", "the index")
        kernel = Kernel(name, "Result", "Under test.", (), (index,), outputs, graph, "this test")
        bounds = prove(kernel, form).outputs
        assert max(bound.bound for bound in bounds) <= most
        gains = [bound for bound in bounds if bound.name in ("alpha", "beta")]
        assert all(bound.bound <= 8 for bound in gains)
