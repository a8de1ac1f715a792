"""Double-words: each algorithm against exact fractions, and the bound of a graph made of them."""

from __future__ import annotations

from collections.abc import Callable
from dataclasses import replace
from fractions import Fraction
from math import isqrt
from typing import Any

import numpy as np
import pytest
from samples import samples

from gainproof.derive.printer.bound import prove
from gainproof.derive.printer.double_word.bound import (
    PRODUCT,
    QUOTIENT,
    ROOT,
    SUM,
    DoubleWordError,
    U,
    errors,
    units,
)
from gainproof.derive.printer.double_word.float32_results import single_units
from gainproof.derive.printer.formats import FLOAT32, FLOAT64
from gainproof.derive.printer.graph import GraphBuilder, Node
from gainproof.derive.printer.kernel import Kernel, Output, closed
from gainproof.derive.printer.shipped import _double_word as pair
from gainproof.derive.printer.step_ranges import PrintingError


def drawn(count: int, seed: int) -> Any:
    """Positive double-words of many sizes; some low words are next to half a unit."""
    rng = np.random.default_rng(seed)
    high = rng.uniform(1, 2, count) * 2.0 ** rng.integers(-30, 31, count)
    high[: count // 3] = 2.0 ** rng.integers(-3, 4, count // 3)
    low = np.spacing(high) / 2 * rng.choice([-0.5, 0.0, 0.999, *rng.uniform(-0.5, 1, 4)], count)
    return pair._short(high, low)


def exact(value: Any) -> list[Fraction]:
    return [Fraction(float(x)) + Fraction(float(y)) for x, y in zip(*value, strict=True)]


def off(found: Any, true: list[Fraction]) -> Fraction:
    """Largest relative error."""
    pairs = zip(exact(found), true, strict=True)
    return max(abs(x - y) / y for x, y in pairs)


def root(x: Fraction) -> Fraction:
    """To 300 bits."""
    return Fraction(isqrt(x.numerator * x.denominator << 600), x.denominator << 300)


@pytest.mark.sampled
@pytest.mark.parametrize(
    ("operation", "true", "bound"),
    [
        (pair.add, lambda a, b: a + b, SUM),
        (pair.multiply, lambda a, b: a * b, PRODUCT),
        (pair.divide, lambda a, b: a / b, QUOTIENT),
        (lambda a, _b: pair.root(a), lambda a, _b: root(a), ROOT),
    ],
)
def test_algorithms_keep_their_bounds(
    operation: Callable[[Any, Any], Any], true: Callable[..., Fraction], bound: Fraction
) -> None:
    a, b = drawn(samples(600), 1), drawn(samples(600), 2)
    wanted = [true(x, y) for x, y in zip(exact(a), exact(b), strict=True)]
    found = operation(a, b)
    assert off(found, wanted) <= bound
    assert off(found, wanted) > bound / 50  # the bound is of this size
    assert (np.abs(found[1]) <= np.spacing(found[0]) / 2).all()
    assert off((found[0], found[1] * 0), wanted) > 1000 * bound


def kernel(make: Callable[[GraphBuilder, Node], Node], low: str, high: str) -> Kernel:
    builder = GraphBuilder()
    graph = builder.graph({"y": make(builder, builder.symbol("x"))})
    given = closed("x", "a number", low, high)
    return Kernel("f", "F", "F.", (), (given,), (Output("y", "y"),), graph, "none", accurate=given)


def test_errors_of_a_graph_add_up() -> None:
    found = kernel(lambda b, x: b.sqrt(x * x + 3) / x * 4, "1/8", "8")
    (error,) = errors(found, Fraction(1, 8), Fraction(8))
    # x x: 7; 3: 1; their sum: 3 more than the larger; root: 25/8, radicand counted whole; x exact
    assert U**2 * (7 + 3 + Fraction(25, 8) + 15) < error < U**2 * Fraction(282, 10)
    assert units(found) == pytest.approx(float(error / U))


@pytest.mark.parametrize(
    ("make", "low", "high", "told"),
    [
        (lambda _b, x: (x + 1) - x, "2", "4", "operation sub"),
        (lambda _b, x: -x, "2", "4", "operation neg"),
        (lambda _b, x: x * -3, "2", "4", "operation constant"),
        (lambda b, x: b.call("exp", x), "2", "4", "operation exp"),
        (lambda _b, x: x * x * x, "1e-100", "1e100", "size from 2"),
        (lambda _b, x: 1 / x, "1e-280", "1", "size from 2"),
    ],
)
def test_what_has_no_bound_is_refused(
    make: Callable[[GraphBuilder, Node], Node], low: str, high: str, told: str
) -> None:
    with pytest.raises(DoubleWordError, match=told):
        units(kernel(make, low, high))


def test_sizes_hold_at_both_ends() -> None:
    """2^900 is taken, what may be beyond is not."""
    square = kernel(lambda _b, x: x * x, "1", str(2**450))
    assert units(square) > 0
    wider = replace(square, accurate=closed("x", "a number", "1", str(2**450 + 1)))
    with pytest.raises(DoubleWordError, match=r"f: .* has a size"):
        units(wider)


def test_float32_takes_float64_that_is_bounded_well_enough() -> None:
    plain = kernel(lambda b, x: b.sqrt(x * x + 3) / x * 4, "1/8", "8")
    bound = prove(plain, FLOAT64)
    (output,) = bound.outputs
    assert single_units(plain, bound) == pytest.approx(float(output.bound) * 2**-28)
    for changed, form in (
        (replace(output, bound=Fraction(2**22)), FLOAT64),
        (replace(output, domain=((0.126, 8.0),)), FLOAT64),
        (replace(output, domain=((0.125, 7.99),)), FLOAT64),
        (output, FLOAT32),
    ):
        worse = replace(bound, format=form, outputs=(changed,))
        with pytest.raises(PrintingError, match="f: float64 errs by too much"):
            single_units(plain, worse)
