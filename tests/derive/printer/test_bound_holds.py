"""The proved bound against brute force: random graphs, box borders, ends of the domain."""

from __future__ import annotations

from contextlib import suppress
from fractions import Fraction

import numpy as np
import pytest
from graph_kernels import KINDS, function_of, kernel_of, worst_error
from hypothesis import given, settings
from hypothesis import strategies as st
from samples import samples

from gainproof.derive.printer.bound import OutputBound, prove
from gainproof.derive.printer.formats import FORMATS, Format
from gainproof.derive.printer.graph import GraphBuilder, Node
from gainproof.derive.printer.kernel import Kernel
from gainproof.derive.printer.step_ranges import PrintingError

NUMBERS = ["1", "2", "3", "1/3", "5/7", "16", "1/1024", "1000003", "1/1000003"]


def points_of(bound: OutputBound, form: Format, count: int, seed: int) -> list[float]:
    """Inputs over the whole domain of an output, its ends, powers of two and their neighbours."""
    generator = np.random.default_rng(seed)
    first, last = form.ordinal(bound.lowest), form.ordinal(bound.highest)
    places = [first + int((last - first) * part) for part in generator.random(count)]
    places += [first, last, first + 1, last - 1]
    for exponent in range(-1070, 1024, 89):
        at = form.ordinal(min(2.0**exponent, form.largest))
        places += [at - 1, at, at + 1]
    kept = sorted({place for place in places if first <= place <= last})
    return [form.from_ordinal(place) for place in kept]


def check(kernel: Kernel, count: int, seed: int) -> None:
    """Every output in both formats stays within its proved bound."""
    function = function_of(kernel)
    for form in FORMATS:
        for row, bound in enumerate(prove(kernel, form).outputs):
            points = points_of(bound, form, count, seed)
            computed = function(np.array(points, KINDS[form.name]))
            worst, place = worst_error(kernel, computed, row, points)
            assert worst <= bound.bound * Fraction(form.epsilon), (form.name, place)


@st.composite
def positive_graphs(draw: st.DrawFn) -> Kernel:
    """Sums, products, quotients and roots of positive terms, with shared nodes."""
    b = GraphBuilder()
    x = b.symbol("x")
    nodes: list[Node] = [x, b.sqrt(x), b.number(draw(st.sampled_from(NUMBERS)))]
    for _ in range(draw(st.integers(2, 14))):
        kind = draw(st.sampled_from("+++*//r"))
        first, second = (nodes[draw(st.integers(0, len(nodes) - 1))] for _ in range(2))
        match kind:
            case "+":
                nodes.append(first + second)
            case "*":
                nodes.append(first * second)
            case "/":
                nodes.append(first / second)
            case _:
                nodes.append(b.sqrt(first))
    return kernel_of(b.graph({"y": nodes[-1] * x / x, "z": nodes[-2]}))


@given(positive_graphs(), st.integers(0, 2**32))
@settings(max_examples=samples(12), deadline=None)
def test_random_positive_graphs(kernel: Kernel, seed: int) -> None:
    with suppress(PrintingError):  # refused: an over- or underflow inside the domain
        check(kernel, 40, seed)


def differences() -> list[Kernel]:
    """Exact differences next to their zeros, irrational constants, branches, absolute values."""
    b = GraphBuilder()
    x = b.symbol("x")
    root = b.sqrt("2/3")
    gap, other = 4 / root - x, x / 2 - b.sqrt(3)
    size = 1 + x
    first = {"y": gap / size, "_s": (b.absolute(gap) + 1) / size, "w": b.absolute(gap) + x}
    second = {"y": b.select(x, "1/3", gap, other) * (3 + x), "z": b.absolute(other) / gap}
    third = {"y": b.select(8, x, b.sqrt(b.absolute(x - 8)), 1 / x)}
    fourth = {"y": (x - "1/3") * (x - 1) / (x + 5), "_s": (x + 1) * (x + 1) / (x + 5)}
    return [
        kernel_of(b.graph(first), scales={"y": "_s"}, upper=10**37),
        kernel_of(b.graph(second), upper=4, scales={}),
        kernel_of(b.graph(third), upper=10**6),
        kernel_of(b.graph(fourth), scales={"y": "_s"}, upper=100),
    ]


@pytest.mark.parametrize("which", range(4))
def test_exact_differences(which: int) -> None:
    kernel = differences()[which]
    function = function_of(kernel)
    for form in FORMATS:
        for row, bound in enumerate(prove(kernel, form).outputs):
            points = points_of(bound, form, 60, which)
            for zero in (4 / (2 / 3) ** 0.5, 2 * 3**0.5, 1 / 3, 8.0, 1.0):
                at = form.ordinal(form.nearest(Fraction(zero)))
                points += [form.from_ordinal(at + k) for k in range(-30, 31)]
            points = [p for p in points if bound.lowest <= p <= bound.highest]
            computed = function(np.array(points, KINDS[form.name]))
            worst, place = worst_error(kernel, computed, row, points)
            assert worst <= bound.bound * Fraction(form.epsilon), (form.name, row, place)


def test_the_comparison_can_fail() -> None:
    """The measured error comes close to the bound: a tenth less would be seen to be false."""
    b = GraphBuilder()
    x = b.symbol("x")
    kernel = kernel_of(b.graph({"y": b.sqrt(x)}))
    function = function_of(kernel)
    for form in FORMATS:
        (bound,) = prove(kernel, form).outputs
        points = points_of(bound, form, 400, 1)
        worst, _ = worst_error(kernel, function(np.array(points, KINDS[form.name])), 0, points)
        assert worst > bound.bound * Fraction(form.epsilon) * 9 / 10
