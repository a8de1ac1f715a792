"""What a requirement on several inputs makes sure of, at graphs of the printer itself."""

from __future__ import annotations

from collections.abc import Callable
from dataclasses import replace
from fractions import Fraction

import flint
import pytest

from gainproof.derive.printer.bound import prove
from gainproof.derive.printer.docstring import docstring
from gainproof.derive.printer.formats import FLOAT32, FLOAT64, FORMATS
from gainproof.derive.printer.graph import Graph, GraphBuilder, Node
from gainproof.derive.printer.kernel import (
    Kernel,
    Output,
    Requirement,
    closed,
    least_admitted,
    signed,
)
from gainproof.derive.printer.known_values import known_values
from gainproof.derive.printer.step_ranges import PrintingError

NAMES = "abcd"
INPUTS = tuple(signed(name, "a number", "1e-3", "2") for name in NAMES)
Made = Callable[[GraphBuilder, Node, Node, Node, Node], dict[str, Node]]


def graph(made: Made) -> Graph:
    b = GraphBuilder()
    nodes = [b.symbol(name) for name in NAMES]
    return b.graph(made(b, *nodes))


def kernel(made: Made, least: str = "1/8", by_terms: bool = True) -> Kernel:
    return Kernel(
        "kernel",
        "Result",
        "A kernel.",
        ("y",),
        INPUTS,
        (Output("y", "a value", by_terms=by_terms),),
        graph(made),
        "this test",
        requirements=(Requirement("apart", "what is required", least, least),),
    )


def legs(b: GraphBuilder, *parts: Node) -> tuple[Node, Node, Node]:
    """Two numbers whose terms may cancel, and their angle."""
    one, two, three, four = parts
    over, under = one * two - three * four, one * three + two * four
    return over, under, b.call("atan2", over, under)


def test_an_angle_of_legs_that_cancel_needs_their_distance() -> None:
    def fine(b: GraphBuilder, *parts: Node) -> dict[str, Node]:
        over, under, angle = legs(b, *parts)
        return {"y": angle, "apart": over * over + under * under}

    bound = prove(kernel(fine), FLOAT64).outputs[0].bound
    assert Fraction(5) <= bound <= Fraction(503, 100)  # 4 units of atan2, and 2 roundings of a leg
    for least in ("0", "1e-12"):
        with pytest.raises(PrintingError, match=r"no small part of .*wanted: at least"):
            prove(kernel(fine, least), FLOAT64)


OTHERS: dict[str, Callable[[Node, Node, Node], Node]] = {
    "another number": lambda _, under, one: one * one + under * under,
    "twice a leg": lambda over, under, _: over * 2 + under * under,
    "a half and no square": lambda over, under, _: over / 2 + under * under,
    "a difference": lambda over, under, _: over * over - under * under,
    "one of both": lambda over, _, __: over * over,
    "a third besides": lambda over, under, one: over * over + under * under + one * one,
    "a product": lambda over, under, _: over * under + under * under,
}


@pytest.mark.parametrize("name", OTHERS)
def test_no_other_requirement_will_do(name: str) -> None:
    """Each may hold where both legs are 0 or next to it, or is not about both."""

    def made(b: GraphBuilder, *parts: Node) -> dict[str, Node]:
        over, under, angle = legs(b, *parts)
        return {"y": angle, "apart": OTHERS[name](over, under, parts[0])}

    with pytest.raises(PrintingError, match="atan2 of an uncertain value"):
        prove(kernel(made), FLOAT64)


def test_what_is_required_may_divide() -> None:
    """a b - c d above 1/8 has an error of 8 u beside it: 64 of its roundings and two of its own."""

    def made(b: GraphBuilder, *parts: Node) -> dict[str, Node]:
        one, two, three, four = parts
        value = one * two - three * four
        return {"y": one / value, "apart": value}

    (found,) = prove(kernel(made, by_terms=False), FLOAT64).outputs
    # terms of at most 4 each, 2 roundings of their sum of 8, over 1/8; half a unit more to divide
    assert 64 <= found.bound <= Fraction(65)
    with pytest.raises(PrintingError, match=r"wanted: at least 1\.8e-12 \(float64\)"):
        prove(kernel(made, "1e-12", by_terms=False), FLOAT64)


def test_numbers_whose_ranges_are_apart_differ() -> None:
    """1 - e^2 s^2 for e, s up to 1/2: errors of the product count a fifteenth."""
    b = GraphBuilder()
    e, s = b.symbol("e"), b.symbol("s")
    inputs = tuple(signed(name, "a number", "1e-3", "1/2") for name in "es")
    value = b.sqrt(1 - (e * e) * (s * s))
    words = ("kernel", "Result", "A kernel.", ("y",))
    made = Kernel(*words, inputs, (Output("y", "a value"),), b.graph({"y": value}), "this test")
    for form in FORMATS:
        (found,) = prove(made, form).outputs
        # 3 roundings of the product weigh 1/15 each, one of the difference, half of both, one more
        assert Fraction(80, 100) <= found.bound <= Fraction(82, 100)
    wide = tuple(signed(name, "a number", "1e-3", "1") for name in "es")
    with pytest.raises(PrintingError, match="root of what may be negative"):
        prove(replace(made, inputs=wide), FLOAT64)


def test_above_zero_is_from_the_least_normal_number_on() -> None:
    above = Requirement("apart", "a number", "0", "0")
    assert least_admitted(above, FLOAT64) == 2.0**-1022
    assert least_admitted(above, FLOAT32) == 2.0**-126
    b = GraphBuilder()
    x, y = b.symbol("x"), b.symbol("y")
    inputs = (closed("x", "a number", "1", "2"), closed("y", "a number", "1", "2"))
    graph_ = b.graph({"z": 1 / (x - y), "apart": x - y})
    words = ("kernel", "Result", "A kernel.", ("z",))
    made = Kernel(*words, inputs, (Output("z", "a value"),), graph_, "this test", {}, (above,))
    assert prove(made, FLOAT64).outputs[0].bound <= Fraction(101, 100)
    assert "must be above 0" in docstring(made, [prove(made, form) for form in FORMATS])


def test_points_of_tests_fulfil_what_is_required() -> None:
    """On a narrow shell, where no point that is drawn lies by itself."""
    b = GraphBuilder()
    parts = [b.symbol(name) for name in NAMES]
    norm = (parts[0] * parts[0] + parts[1] * parts[1]) + parts[2] * parts[2]
    outputs = {"y": parts[0] * parts[1], "least": norm, "most": -norm}
    sides = (("least", "999999/1000000"), ("most", "-1000001/1000000"))
    made = Kernel(
        "kernel",
        "Result",
        "A kernel.",
        ("y",),
        tuple(replace(each, lower="1e-6") for each in INPUTS[:3]),
        (Output("y", "a value"),),
        b.graph(outputs),
        "this test",
        requirements=tuple(Requirement(name, "norm", least, least) for name, least in sides),
    )
    points = known_values(made, [prove(made, FLOAT64)], "a seed")["points"]["float64"]
    assert len(points) >= 6
    for point in points:
        total = sum(t * t for t in point["at"])
        assert abs(float(total) - 1) < 1e-6
        assert abs(flint.arb(point["values"]["y"]) - point["at"][0] * point["at"][1]) < 1e-15
