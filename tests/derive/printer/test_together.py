"""Kernels proved together have the bounds that they have alone, or better ones."""

from __future__ import annotations

from collections.abc import Callable
from dataclasses import replace
from fractions import Fraction

import pytest
from graph_kernels import kernel_of

from gainproof.derive.printer.bound import prove
from gainproof.derive.printer.fixed_point import fixed_point, near_cbrt
from gainproof.derive.printer.formats import FORMATS
from gainproof.derive.printer.graph import Graph, GraphBuilder, Node
from gainproof.derive.printer.kernel import Kernel, Output
from gainproof.derive.printer.module_bounds import prove_all
from gainproof.derive.printer.step_ranges import PrintingError

ROUNDED_UP = Fraction(1, 100)
"""Bounds are stated in hundredths."""


def graphs() -> dict[str, Graph]:
    b = GraphBuilder()
    x = b.symbol("x")
    root = b.sqrt(x) + 3
    share = 4 / (1 + root)
    c = GraphBuilder()
    y = c.symbol("x")
    again = c.sqrt(y) + 3
    return {
        "roots": b.graph({"y": root, "w": share}),
        "sums": c.graph({"y": again / 3, "w": again / (1 + again)}),
        "small": b.graph({"y": b.sqrt(x) / 3 / 7}),
    }


def kernels(changed: dict[str, Graph]) -> list[Kernel]:
    found = []
    for name, graph in changed.items():
        outputs = tuple(Output(key, "a value") for key in graph["outputs"])
        found.append(replace(kernel_of(graph), name=name, outputs=outputs))
    return found


def test_each_has_the_bounds_that_it_has_alone_or_better_ones() -> None:
    made = kernels(graphs())
    for kernel, bounds in zip(made, prove_all(made), strict=True):
        for form, bound in zip(FORMATS, bounds, strict=True):
            alone = prove(kernel, form)
            assert bound.format is form
            assert bound.inputs == alone.inputs
            for mine, own in zip(bound.outputs, alone.outputs, strict=True):
                assert (mine.name, mine.domain) == (own.name, own.domain)
                assert own.bound * Fraction(9, 10) <= mine.bound <= own.bound + ROUNDED_UP


def test_an_output_of_the_same_name_is_another_in_another_kernel() -> None:
    made = kernels(graphs())
    roots, _, small = prove_all(made)
    assert roots[0].outputs[0].bound != small[0].outputs[0].bound


def test_the_kernel_that_cannot_be_proved_is_named() -> None:
    b = GraphBuilder()
    x = b.symbol("x")
    bad = b.graph({"y": (b.sqrt(x) + 1) - b.sqrt(x)})
    with pytest.raises(
        PrintingError, match=r"worse \(float64\): sqrt\(x\) \+ 1 - sqrt\(x\): .*loses digits"
    ):
        prove_all(kernels({**graphs(), "worse": bad}))


def test_kernels_of_one_name_are_two() -> None:
    b = GraphBuilder()
    x = b.symbol("x")
    both = kernels({"a": b.graph({"y": b.sqrt(x) * 3 * x}), "b": b.graph({"y": 1 / x})})
    joined = prove_all([replace(kernel, name="same") for kernel in both])
    assert [bounds[0].outputs for bounds in joined] == [b[0].outputs for b in prove_all(both)]
    assert joined[0][0].outputs[0].bound > joined[1][0].outputs[0].bound


def test_one_start_of_two_maps() -> None:
    """Neither kernel knows of the other, whose map has a node of its start."""
    b = GraphBuilder()
    x = b.symbol("x")
    start = near_cbrt(2 * x)

    def fourth_power(n: int) -> Callable[[Node], Node]:
        return lambda y: b.sqrt(b.sqrt(n * x * y))

    roots = [fixed_point(start, fourth_power(n), "1/2") for n in (2, 3)]
    made = kernels({f"k{n}": b.graph({"y": root}) for n, root in enumerate(roots)})
    narrow = [
        replace(k, inputs=(replace(k.inputs[0], lower="1", upper="9", lower_open=False),))
        for k in made
    ]
    first, second = prove_all(narrow)
    assert first[0].outputs == prove(narrow[0], FORMATS[0]).outputs
    assert second[1].outputs == prove(narrow[1], FORMATS[1]).outputs
