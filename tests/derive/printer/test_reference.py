"""Bounds of kernels whose inputs have signs: what is refused, what is counted, that it holds."""

from __future__ import annotations

from collections.abc import Callable
from dataclasses import replace
from fractions import Fraction
from typing import Any

import flint
import numpy as np
import pytest
from graph_kernels import module_of
from signed_graphs import with_terms

from gainproof.derive.printer.bound import prove
from gainproof.derive.printer.exact import enclosures
from gainproof.derive.printer.formats import FLOAT32, FLOAT64
from gainproof.derive.printer.graph import GraphBuilder, Node
from gainproof.derive.printer.kernel import (
    Input,
    Kernel,
    Output,
    Requirement,
    closed,
    signed,
)
from gainproof.derive.printer.program import program
from gainproof.derive.printer.step_ranges import PrintingError

Write = Callable[[GraphBuilder, Node, Node], Node]
WIDE = ("1e-30", "1e30", ("1e-6", "1e6"))
X, Z = signed("x", "an argument", *WIDE), signed("z", "an argument", *WIDE)
ANGLE = signed("x", "an angle", "1e-30", "3.2", ("1e-9", "3.2"))


def kernel(write: Write, *inputs: Input, by_terms: bool = False) -> Kernel:
    """One output y of x and z."""
    b = GraphBuilder()
    graph = b.graph({"y": write(b, b.symbol("x"), b.symbol("z"))})
    output = Output("y", "a value", by_terms=by_terms)
    return Kernel(
        "kernel", "Result", "Under test.", ("y",), inputs or (X, Z), (output,), graph, "this test"
    )


def bound(made: Kernel, form: Any = FLOAT64) -> Fraction:
    """In units of epsilon."""
    return prove(made, form).outputs[0].bound


@pytest.mark.parametrize(
    ("write", "rounded", "by_terms"),
    [
        (lambda _b, x, z: x * z, 1, False),
        (lambda _b, x, z: x - z, 1, False),  # of exact numbers
        (lambda b, x, z: b.sqrt(x * x + z * z), 2, False),
        (lambda b, x, z: x / b.sqrt(x * x + (z * z + 1)), Fraction(7, 2), False),
        (lambda _b, x, z: x * x - z * z, 2, True),
        (lambda _b, x, z: (x + z) * (x - z), 3, False),
        (lambda _b, x, z: (x * z + x) * (x * z + x), 5, True),
        (lambda _b, x, z: -(x * z) / 4, 1, False),
    ],
)
def test_roundings_are_counted(write: Write, rounded: Fraction, by_terms: bool) -> None:
    for form in (FLOAT64, FLOAT32):
        found = bound(kernel(write, by_terms=by_terms), form)
        assert Fraction(rounded, 2) <= found <= Fraction(rounded, 2) + Fraction(1, 100)


@pytest.mark.parametrize(
    ("write", "words"),
    [
        (lambda _b, x, z: x * x - z * z, "may cancel, and is not"),
        (lambda _b, x, z: x / z, "a division by what may be 0"),
        (lambda _b, x, z: x / (x * x - z * z), "a division by what may be 0"),
        (lambda b, x, _z: b.sqrt(x), "the root of what may be negative"),
        (lambda b, x, z: b.sqrt(x - z), "the root of what may be negative"),
        (lambda b, x, z: b.call("sin", x * z), "sin of a computed number"),
        (lambda b, x, z: b.call("cos", x + z), "cos of a computed number"),
        (lambda b, x, _z: b.call("exp", x), "exp of what may have either sign"),
        (lambda b, x, _z: b.call("expm1", x * x), "expm1 of what may be above 700"),
        (lambda b, x, _z: b.call("log1p", x), "log1p of what may be negative"),
        (lambda b, x, z: b.call("atan2", x * x - z * z, x), "atan2 of an uncertain value"),
        (lambda b, x, z: b.call("hypot", x * x - z * z, x), "hypot of an uncertain value"),
        (lambda b, x, z: b.select(x, 1, x, z), "select is no operation"),
        (lambda _b, x, _z: (((x * x) * (x * x)) * ((x * x) * (x * x))) * x, "may overflow"),
        (lambda _b, x, _z: x - Fraction(1, 3), "a constant that the format does not hold"),
    ],
)
def test_what_has_no_bound_is_refused(write: Write, words: str) -> None:
    wide = signed("x", "an argument", "1e-60", "1e60", ("1e-6", "1e6"))
    with pytest.raises(PrintingError, match=rf"kernel \(float64\): .*{words}"):
        bound(kernel(write, wide, Z))


def test_terms_are_named_only_where_they_may_cancel() -> None:
    with pytest.raises(PrintingError, match="cannot cancel, and is measured by its terms"):
        bound(kernel(lambda _b, x, z: x * z, by_terms=True))


def test_positive_inputs_do_not_cancel_in_sums() -> None:
    inputs = closed("x", "an argument", *WIDE), closed("z", "an argument", *WIDE)
    made = kernel(lambda b, x, z: b.call("hypot", x * z + x, z), *inputs)
    assert Fraction(5) <= bound(made) <= Fraction(501, 100)


def test_a_product_that_underflows_leaves_an_absolute_error() -> None:
    small = signed("x", "an argument", "1e-200", "1e200", ("1e-30", "1e3"))
    for form in (FLOAT64, FLOAT32):
        found = prove(kernel(lambda _b, x, z: (x * z) * z, replace(small), Z), form).outputs[0]
        assert found.beside == 0 if form is FLOAT64 else 0 < found.beside < 1e-30
    tiny = kernel(lambda _b, x, z: (x * x) * z, small, Z)
    with pytest.raises(PrintingError, match="may overflow"):
        prove(tiny, FLOAT64)
    with pytest.raises(PrintingError, match="uncertain value"):
        prove(kernel(lambda _b, x, z: 1 / (x * x * z * z + 0), small, Z), FLOAT32)


def test_a_difference_may_be_as_small_as_the_rounding_of_its_terms() -> None:
    """Its products then underflow, though no product of the terms does."""
    near = signed("x", "an argument", "1", "2"), signed("z", "an argument", "1", "2")

    def power(_b: GraphBuilder, x: Node, z: Node) -> Node:
        found = x - z
        for _ in range(3):
            found = found * found
        return found  # 2^-53 to the eighth power is 2^-424, below the least float32

    assert prove(kernel(power, *near), FLOAT64).outputs[0].beside == 0
    assert prove(kernel(power, *near), FLOAT32).outputs[0].beside > 0


def required_root(least: str) -> Kernel:
    """x over a root of squares that may underflow, of which something is required."""
    b = GraphBuilder()
    x, z = b.symbol("x"), b.symbol("z")
    root = b.sqrt(x * x + z * z)
    anywhere = [signed(name, "an argument", "0", "1e30", ("0", "1e12")) for name in ("x", "z")]
    return Kernel(
        "kernel",
        "Result",
        "Under test.",
        ("y",),
        tuple(anywhere),
        (Output("root", "a root"), Output("y", "a share")),
        b.graph({"root": root, "y": x / root}),
        "this test",
        requirements=(Requirement("root", "the root", least, "1e-6"),),
    )


def test_squares_that_underflow_are_nothing_beside_a_root_that_is_required() -> None:
    """Numbers next to 0 beside others, which the requirement keeps away from 0."""
    made = required_root("1e-20")
    run = module_of(made)["kernel"]
    for form, dtype in ((FLOAT64, np.float64), (FLOAT32, np.float32)):
        root, share = prove(made, form).outputs
        assert root.beside == 0
        assert Fraction(1) <= root.bound <= Fraction(126, 100)
        assert share.beside > 0
        for small in (form.least, 5 * form.least, form.least_normal, 1e-25, 1e-22):
            for large in (3e-20, 1.0) if form is FLOAT64 else (2e-6, 1.0):
                x, z = dtype(small), dtype(large)
                found = run(x, z)
                true = with_terms(made.graph, {"x": float(x), "z": float(z)})
                for name, value, bound in zip(("root", "y"), found, (root, share), strict=True):
                    exact = true[name][0]
                    room = abs(exact) * float(bound.bound) * form.epsilon + bound.beside
                    assert abs(flint.arb(float(value)) - exact) <= room * (1 + 1e-9)


def test_squares_that_underflow_are_something_beside_a_root_next_to_zero() -> None:
    for least in ("0", "1e-300", "1e-155"):
        with pytest.raises(PrintingError, match="uncertain value"):
            prove(required_root(least), FLOAT64)


def test_an_absolute_error_grows_with_what_it_is_multiplied_by() -> None:
    small = signed("x", "an argument", "1e-30", "1e3", ("1e-30", "1e3"))
    large = closed("z", "an argument", "1e-3", "1e25", ("1e-3", "1e25"))
    for write in (lambda _b, x, z: (x * x) * z, lambda _b, x, z: z * (x * x)):
        stated = prove(kernel(write, small, large), FLOAT32).outputs[0]
        assert stated.beside > 1e-45 * 1e25


def test_what_is_required_makes_a_divisor() -> None:
    b = GraphBuilder()
    x, z = b.symbol("x"), b.symbol("z")
    size = b.sqrt(x * x + z * z)
    graph = b.graph({"y": x / size, "size": size})
    made = replace(kernel(lambda _b, x, _z: x), graph=graph)
    with pytest.raises(PrintingError, match="a division by what may be 0"):
        bound(made)
    required = Requirement("size", "distance", "1e-30", "1e-6")
    assert bound(replace(made, requirements=(required,))) == Fraction(151, 100)
    b = GraphBuilder()
    x, z = b.symbol("x"), b.symbol("z")
    graph = b.graph({"y": x, "size": x * x - z * z})
    with pytest.raises(PrintingError, match="a requirement of an uncertain value"):
        bound(replace(made, graph=graph, requirements=(required,)))


def test_a_leg_is_not_longer_than_its_hypotenuse() -> None:
    """Without that the quotient would be taken to be as large as its parts allow."""
    b = GraphBuilder()
    x, z = b.symbol("x"), b.symbol("z")
    size = b.sqrt(x * x + z * z)
    power = x / size
    for _ in range(4):
        power = power * power
    graph = b.graph({"y": power, "size": size})
    required = Requirement("size", "distance", "1e-30", "1e-6")
    made = replace(kernel(lambda _b, x, _z: x), graph=graph, requirements=(required,))
    assert prove(made, FLOAT64).outputs[0].beside > 0  # small powers underflow
    b = GraphBuilder()
    x, z = b.symbol("x"), b.symbol("z")
    other = b.sqrt(z * z + 1)
    power = x / other
    for _ in range(4):
        power = power * power
    with pytest.raises(PrintingError, match="may overflow"):
        bound(replace(made, graph=b.graph({"y": power, "size": other}), requirements=()))


def test_a_difference_of_exact_numbers_that_never_meet_divides() -> None:
    """x - 1 from 2 on is at least 1 and not 0; from 1 on it may be 0."""
    for least, fine in (("2", True), ("1", False)):
        made = kernel(lambda _b, x, z: z / (x - 1), closed("x", "", least, "1e6"), Z)
        if fine:
            assert bound(made) <= 2
            continue
        with pytest.raises(PrintingError, match="a division by what may be 0"):
            bound(made)


CALLED: dict[str, Write] = {
    "sin": lambda b, x, _z: b.call("sin", x),
    "cos": lambda b, x, z: b.call("cos", x) * z,
    "atan2": lambda b, x, z: b.call("atan2", z * z, x),
    "hypot": lambda b, x, z: b.call("hypot", x, z),
    "exp": lambda b, x, _z: b.call("exp", -(x * x)),
    "expm1": lambda b, x, _z: b.call("expm1", -(x * x)),
    "exp of a positive number": lambda b, x, _z: b.call("exp", x * x),
    "expm1 of a positive number": lambda b, x, _z: b.call("expm1", x * x),
    "log1p": lambda b, x, _z: b.call("log1p", x * x),
    "all": lambda b, x, z: (b.call("sin", x) * b.call("cos", x)) / b.call("hypot", x, z * z + 1),
}


@pytest.mark.parametrize("dtype", ["float64", "float32"])
@pytest.mark.parametrize("name", CALLED)
def test_measured_errors_are_within_the_bounds(name: str, dtype: str) -> None:
    made = kernel(CALLED[name], ANGLE, Z)
    form = FLOAT64 if dtype == "float64" else FLOAT32
    stated = prove(made, form).outputs[0]
    generator = np.random.default_rng(2)
    box = prove(made, form).inputs
    given = [
        np.exp(generator.uniform(np.log(low), np.log(high), 300)) * generator.choice([-1, 1], 300)
        for low, high in box
    ]
    points = [
        np.clip(row.astype(dtype), -high, high) for row, (_, high) in zip(given, box, strict=True)
    ]
    (computed,) = module_of(made)["kernel"](*points)
    worst = 0.0
    for at in range(300):
        place = {name: float(row[at]) for name, row in zip("xz", points, strict=True)}
        exact, _ = with_terms(made.graph, place)["y"]
        with flint.ctx.workprec(300):
            error = abs(flint.arb(float(computed[at])) - exact)
            room = abs(exact) * float(stated.bound) * form.epsilon + stated.beside
            assert error <= room, (points[0][at], points[1][at])
            worst = max(worst, float(error / (abs(exact) * form.epsilon)))
    assert worst > 0.1


def test_functions_are_enclosed_at_one_input() -> None:
    b = GraphBuilder()
    used = program(b.graph({"y": b.call("sin", b.symbol("x")) + b.call("cos", b.symbol("x"))}))
    assert abs(enclosures(used, 0.5, FLOAT64, 200)[used.outputs["y"]] - 1.3570081004945758) < 1e-15
