"""Small kernels printed for single numbers: their text, and what each operation gives."""

from __future__ import annotations

from collections.abc import Callable
from fractions import Fraction
from typing import Any

import numpy as np
import pytest
from graph_kernels import module_of, simple

from gainproof.derive.printer import one_number
from gainproof.derive.printer.graph import Graph, GraphBuilder
from gainproof.derive.printer.kernel import Input, Kernel, Module, Output, Requirement, signed
from gainproof.derive.printer.module_bounds import prove_all
from gainproof.derive.printer.numpy_source import printed
from gainproof.derive.printer.package import HERE, PLACE
from gainproof.derive.printer.shipped._numbers import Double, Single, of_numbers

FORMS = [(np.float64, Double), (np.float32, Single)]


def kernel(graph: Graph, *names: str, **options: Any) -> Kernel:
    inputs = tuple(Input(name, "a number", "1/1000", "5", False, False) for name in names)
    outputs = tuple(Output(name, "a number") for name in graph["outputs"] if name != "size")
    return Kernel("some", "Some", "Some.", (), inputs, outputs, graph, "a test", **options)


def lines(made: Kernel) -> list[str]:
    return [line.strip() for line in one_number.function(made)]


def function(made: Kernel) -> Callable[..., tuple[Any, ...]]:
    text = "from __future__ import annotations\nfrom numpy import errstate\n"
    space: dict[str, Any] = {"Double": Double}
    exec(text + "\n".join(one_number.function(made)), space)  # noqa: S102  # our printer's text
    found: Callable[..., tuple[Any, ...]] = space["_some_of_numbers"]
    return found


def test_what_is_used_once_stands_where_it_is_used() -> None:
    b = GraphBuilder()
    x, y = b.symbol("x"), b.symbol("y")
    twice = b.sqrt(x + y * 3)
    made = kernel(b.graph({"a": (x - y) / (twice + 5), "b": -(twice * y)}), "x", "y")
    head, root, first, second, back = lines(made)
    assert (
        head
        == "def _some_of_numbers(x: float, y: float, form: Form = Double) -> tuple[float, ...]:"
    )
    assert root.endswith(" = form.sqrt(x + (y * 3.0))")
    name = root.split(" = ")[0]
    assert first.endswith(f" = (x - y) / ({name} + 5.0)")
    assert second.endswith(f" = -({name} * y)")
    assert back == f"return ({first.split(' = ')[0]}, {second.split(' = ')[0]})"


def test_names_of_inputs_that_are_taken() -> None:
    b = GraphBuilder()
    names = ("form", "lambda", "abs", "t3")
    total = sum((b.sqrt(b.symbol(name)) for name in names[1:]), b.sqrt(b.symbol(names[0])))
    found = function(kernel(b.graph({"total": total}), *names))
    assert found(4.0, 9.0, 16.0, 25.0) == (14.0,)


@pytest.mark.parametrize(("kind", "form"), FORMS)
def test_functions_of_the_library_have_numpys_bits(kind: type[Any], form: Any) -> None:
    b = GraphBuilder()
    x, y = b.symbol("x"), b.symbol("y")
    alone, both = ("sin", "cos", "exp", "expm1", "log1p"), ("atan2", "hypot")
    ends = {name: b.call(name, x) * y for name in alone} | {n: b.call(n, x, y) for n in both}
    made = kernel(b.graph(ends), "x", "y")
    assert lines(made)[0] == '@errstate(all="ignore")'
    found = function(made)
    for place in np.random.default_rng(5).uniform(0.001, 5.0, (300, 2)):
        u, v = map(kind, place)
        given = (u, v) if form is Single else map(float, (u, v))
        with np.errstate(all="raise"):
            values = found(*given, form)
        wanted = [getattr(np, name)(u) * v for name in alone] + [np.arctan2(u, v), np.hypot(u, v)]
        assert [type(each) for each in values] == [kind if form is Single else float] * 7
        assert np.array(values, kind).tobytes() == np.array(wanted, kind).tobytes()


@pytest.mark.parametrize("swapped", [False, True])
def test_a_chosen_literal_is_rounded_to_the_format(swapped: bool) -> None:
    """Else 0.1 * 0.3 would be a product of float64 numbers in a kernel of float32."""
    b = GraphBuilder()
    x = b.symbol("x")
    sides = (Fraction(1, 10), x) if not swapped else (x, Fraction(1, 10))
    chosen = b.select(x, Fraction(1, 3), *sides)
    found = function(kernel(b.graph({"y": chosen * Fraction(3, 10)}), "x"))
    inside, beyond = (0.2, 0.4) if not swapped else (0.4, 0.2)
    f = np.float32
    assert found(f(inside), Single) == (f(0.1) * f(0.3),)
    assert type(found(f(inside), Single)[0]) is f
    assert found(f(beyond), Single) == (f(beyond) * f(0.3),)
    assert found(inside) == (0.1 * 0.3,)


def test_the_border_of_a_choice_in_either_format() -> None:
    """1/3 lies above the float64 number nearest to it, and below that of float32."""
    b = GraphBuilder()
    x = b.symbol("x")
    below = function(kernel(b.graph({"y": b.select(x, Fraction(1, 3), x * 3, x * 5)}), "x"))
    above = function(kernel(b.graph({"y": b.select(Fraction(1, 3), x, x * 3, x * 5)}), "x"))
    third, single = 1 / 3, np.float32(1 / 3)
    assert below(third) == (third * 3,)
    assert below(np.nextafter(third, 1)) == (float(np.nextafter(third, 1)) * 5,)
    assert below(single, Single) == (single * np.float32(5),)
    assert above(third) == (third * 5,)
    assert above(single, Single) == (single * np.float32(3),)


@pytest.mark.parametrize(("kind", "form"), FORMS)
def test_a_difference_with_a_constant_in_two_parts(kind: type[Any], form: Any) -> None:
    """sqrt(2) - x next to sqrt(2) keeps the digits that its nearest number has not."""
    b = GraphBuilder()
    x = b.symbol("x")
    made = kernel(b.graph({"y": b.sqrt(b.number(2)) - x}), "x")
    near = kind(1.4142135623730951)
    rest = {np.float64: -9.667293313452913e-17, np.float32: 2.420323420895794e-08}[
        kind
    ]  # by mpmath
    (found,) = function(made)(near, form)
    assert found == kind(rest)


@pytest.mark.parametrize(("kind", "form"), FORMS)
def test_what_inputs_must_be_together(kind: type[Any], form: Any) -> None:
    """The size is computed once, for the guard and for the result."""
    b = GraphBuilder()
    x, y = b.symbol("x"), b.symbol("y")
    size = b.sqrt(x * x + y * y)
    made = kernel(
        b.graph({"y": x / size, "size": size}),
        *("x", "y"),
        requirements=(Requirement("size", "the size", "1/8", "2"),),
    )
    assert sum("sqrt" in line for line in lines(made)) == 1
    found = function(made)
    assert found(kind(3), kind(4), form) == (kind(3) / kind(5),)
    small = [0.05, float("nan"), *([1.0] if form is Single else [])]
    for each in map(kind if form is Single else float, small):
        with pytest.raises(ValueError, match=r"^$"):
            found(each, each, form)


def module(only: str) -> dict[str, Any]:
    b = GraphBuilder()
    x, y = b.symbol("x"), b.symbol("y")
    inputs = tuple(signed(name, "a number", "1e-3", "10") for name in ("x", "y"))
    graph = b.graph({"z": x * y})
    some = Kernel("some", "Some", "S.", (), inputs, (Output("z", "z"),), graph, "a test")
    made = Module("made", "Made", "a command", "a derivation", (some,))
    text = printed(made, prove_all(made.kernels), only).replace(f"{PLACE}._", f"{HERE}._")
    space: dict[str, Any] = {"__name__": "made"}
    exec(compile(text, "made.py", "exec"), space)  # noqa: S102  # our printer's text
    return space


def test_kernels_of_one_format_keep_to_it() -> None:
    f = np.float32
    double, single = module("float64")["some"], module("float32")["some"]
    assert double(3.0, 2.0) == (6.0,)
    assert type(double(3.0, 2.0)[0]) is float
    assert type(single(f(3), f(2)).z) is f
    with pytest.raises(TypeError, match=r"only float32 is here, .* got x float64, y float64"):
        single(3.0, 2.0)
    with pytest.raises(TypeError, match=r"only float64 is here, .* got x float32, y float32"):
        double(f(3), f(2))


def test_magnitudes_and_zeros_of_signed_inputs() -> None:
    some = module("")["some"]
    for fine in (0.0, -0.0, 0.001, -0.001, 10.0, -10.0):
        assert type(some(fine, 1.0).z) is float
    for wrong in (0.0009, -0.0009, 10.1, -10.1, float("nan")):
        with pytest.raises(
            ValueError, match=f"x must be 0 or of magnitude 1e-3 to 10, got {wrong}"
        ):
            some(wrong, 1.0)


def test_what_python_refuses_is_for_arrays() -> None:
    whole = module_of(simple(lambda b, x: 1 / (b.number(2) + x), lower="0", upper="4"))
    signature = whole["_KERNEL"]
    assert whole["kernel"](2.0).y == 0.25
    assert of_numbers(signature, (2.0,)) == (0.25,)
    with pytest.raises(ZeroDivisionError):
        signature.numbers(-2.0)
    ends = signature.inputs[0]._replace(double=(-4.0, 4.0))
    assert of_numbers(signature._replace(inputs=(ends,)), (-2.0,)) is None
