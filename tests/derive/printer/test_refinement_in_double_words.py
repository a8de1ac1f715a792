"""What a refined root errs by, measured at a root known exactly, and starts that are too far."""

from __future__ import annotations

from dataclasses import replace
from fractions import Fraction

import flint
import numpy as np
import pytest

from gainproof.derive.printer.bound import prove
from gainproof.derive.printer.double_word.refinement import NEAR_UNITS, refined, start_is_near
from gainproof.derive.printer.formats import FLOAT32, FLOAT64
from gainproof.derive.printer.graph import GraphBuilder
from gainproof.derive.printer.kernel import Input, Kernel, Output, Refinement, closed
from gainproof.derive.printer.shipped import _double_word
from gainproof.derive.printer.step_ranges import PrintingError

U = Fraction(1, 2**53)
EXACT_IMAGE = 2 * U**2


@pytest.mark.parametrize("slope", [1 / 4, 1 / 8, 1 / 1024])
@pytest.mark.parametrize("off", [-NEAR_UNITS, -7, 0, 1, NEAR_UNITS])
def test_a_refined_root_keeps_its_bound(slope: float, off: int) -> None:
    """x = c x^l, whose root is c^(1/(1 - l)); c is made of the root 3."""
    near = 3.0 * (1 + off * 2.0**-53)
    with flint.ctx.workprec(300):
        root = flint.arb(3)
        image = root * (flint.arb(near) / root) ** flint.arb(slope)
        high = float(image.mid())
        pair = np.float64(high), np.float64(float((image - high).mid()))
        found = _double_word.refined((np.float64(near), 0.0), pair, (np.float64(slope), 0.0))
        error = abs((flint.arb(float(found[0])) + float(found[1])) / root - 1)
        bound = refined(EXACT_IMAGE, U)
        assert error <= flint.arb(flint.fmpq(bound.numerator, bound.denominator))
        if abs(off) == NEAR_UNITS:
            assert error < flint.arb(2) ** -92
            assert abs(image / root - 1) > flint.arb(2) ** -58  # what it was before


def test_a_start_that_may_be_too_far_is_refused() -> None:
    builder = GraphBuilder()
    x = builder.symbol("x")
    graph = builder.graph({"over": x * 3, "under": x + 1})
    accurate = closed("x", "", 1, 2)
    wanted = Refinement("near", "root", "image", "slope", "over", "under", 1)
    outputs = (Output("over", ""), Output("under", ""))
    kernel = Kernel("k", "K", "", (), (Input("x", ""),), outputs, graph, "")
    kernel = replace(kernel, accurate=accurate, refinement=wanted)
    bound = prove(kernel, FLOAT64)
    start_is_near(kernel, bound)
    worse = tuple(replace(output, bound=output.bound * 40) for output in bound.outputs)
    with pytest.raises(PrintingError, match="the start of its root errs by"):
        start_is_near(kernel, replace(bound, outputs=worse))
    narrow = tuple(replace(output, domain=((1.5, 2.0),)) for output in bound.outputs)
    with pytest.raises(PrintingError, match="the start of its root errs by"):
        start_is_near(kernel, replace(bound, outputs=narrow))
    with pytest.raises(PrintingError, match="the start of its root errs by"):
        start_is_near(kernel, prove(kernel, FLOAT32))
