"""Kernels for JAX and the array API: the bits of NumPy's, choices, derivatives, and what is NaN."""

from __future__ import annotations

from collections.abc import Callable, Iterator, Sequence
from dataclasses import replace
from typing import Any

import numpy as np
import pytest
from graph_kernels import function_of, kernel_of, simple
from numpy.typing import NDArray

from gainproof.derive.printer.fixed_point import fixed_point, near_cbrt
from gainproof.derive.printer.graph import GraphBuilder, Node
from gainproof.derive.printer.kernel import Kernel, Module, Output, Requirement, closed, signed
from gainproof.derive.printer.module_bounds import prove_all
from gainproof.derive.printer.other_arrays import array_api_files, jax_files
from gainproof.derive.printer.slopes import Slope, slopes

RUNTIME = "gainproof.standalone.in_arrays."
KINDS = ("float64", "float32")


def chosen() -> Kernel:
    """Choices of numbers and values, a sum in two parts, a constant and an input as outputs."""
    b = GraphBuilder()
    x = b.symbol("x")
    part = b.select(2, x, b.absolute(x / 2 - b.sqrt("2/3")) * 3, -b.sqrt(x))
    low = b.select(x, 3, b.number(1), b.number("7/3"))
    graph = b.graph({"y": part * "1/3", "low": low * x, "same": x, "end": b.number("1/3")})
    return kernel_of(graph, upper=10**9)


def words() -> Kernel:
    """Inputs that are called like arguments and words of Python, and like steps."""
    b = GraphBuilder()
    names = ("form", "t2", "abs")
    x, y, z = (b.symbol(name) for name in names)
    made = kernel_of(b.graph({"y": b.sqrt(x + 1) * b.sqrt(y + z), "z": x * y * z}))
    return replace(made, inputs=tuple(closed(name, "it's", "1e-3", "1e3") for name in names))


def together() -> Kernel:
    b = GraphBuilder()
    x, z = b.symbol("x"), b.symbol("z")
    size = b.sqrt(x * x + z * z)
    return replace(
        kernel_of(b.graph({"y": x / size, "root": size})),
        inputs=(signed("x", "an argument", 0, 10**6), signed("z", "an argument", 0, 10**6)),
        outputs=(Output("y", "a value"),),
        requirements=(Requirement("root", "the root", "1e-6", "1e-3"),),
    )


def whole() -> Kernel:
    ends = {"lower_open": False, "upper_open": False}
    return simple(lambda _, n: 1 / (n + 1), upper=1000, integer=True, **ends)


def scaled() -> Kernel:
    """A quotient of a quotient, whose divisors' product is no number of float32."""
    return simple(lambda b, x: b.number("1e-30") / (x * "1e-25") / (x * "1e-25"), upper=1000)


KERNELS = (chosen, words, together, whole, scaled)


def space_of(kernels: Sequence[Kernel], target: Any, formats: Sequence[str] = KINDS) -> Any:
    """The names of the printed module."""
    module = Module("trial", "A trial", "gainproof generate trial", "by hand", tuple(kernels))
    both = prove_all(list(kernels))
    bounds = [tuple(b for b in pair if b.format.name in formats) for pair in both]
    text = target(module, bounds, {})["trial.py"].replace("from ._", f"from {RUNTIME}_")
    assert max(map(len, text.splitlines())) <= 100
    space: dict[str, Any] = {"__name__": "trial"}
    exec(compile(text, "trial.py", "exec"), space)  # noqa: S102  # our own printer's text
    return space


def points(kernel: Kernel, form: str) -> list[NDArray[Any]]:
    random = np.random.default_rng(5)
    found = []
    for given in kernel.inputs:
        low, high = max(float(str(given.lower)), 1e-3), float(str(given.upper or 1e6))
        x = np.exp(random.uniform(np.log(low), np.log(high), (20, 10)))
        x = np.round(x) if given.integer else x
        found.append((x * random.choice([-1, 1], x.shape) if given.signed else x).astype(form))
    return found


@pytest.fixture
def jax() -> Iterator[Any]:
    """JAX with both types."""
    found = pytest.importorskip("jax")
    before = found.config.jax_enable_x64
    found.config.update("jax_enable_x64", True)
    yield found
    found.config.update("jax_enable_x64", before)


@pytest.mark.parametrize("form", KINDS)
@pytest.mark.parametrize("make", KERNELS)
def test_libraries_of_the_standard_have_numpys_bits(make: Callable[[], Kernel], form: str) -> None:
    xp = pytest.importorskip("array_api_strict")
    kernel = make()
    given = points(kernel, form)
    made = space_of([kernel], array_api_files)["kernel"]
    for y, wanted in zip(made(*map(xp.asarray, given)), function_of(kernel)(*given), strict=True):
        assert y.shape == (20, 10)
        assert type(y) is type(xp.asarray(given[0]))
        assert not np.shares_memory(np.asarray(y), given[0])
        np.testing.assert_array_equal(np.asarray(y), wanted)
        assert np.asarray(y).dtype == form


@pytest.mark.parametrize("form", KINDS)
@pytest.mark.parametrize("make", KERNELS)
def test_jax_rounds_each_operation(jax: Any, make: Callable[[], Kernel], form: str) -> None:
    """Up to a product and a sum that a processor rounds once, which no kernel here is made of but
    one: without keeping results XLA gives 0 and infinity for sums in two parts and quotients.
    """
    kernel = make()
    given = points(kernel, form)
    made = space_of([kernel], jax_files)["kernel"]
    for way in (made, jax.jit(made), jax.vmap(made), jax.jit(jax.vmap(jax.vmap(made)))):
        for y, wanted in zip(way(*given), function_of(kernel)(*given), strict=True):
            np.testing.assert_allclose(y, wanted, rtol=2 * float(np.finfo(form).eps))
            assert y.dtype == form


def test_a_cube_root_starts_from_a_power() -> None:
    b = GraphBuilder()
    x = b.symbol("x")
    root = fixed_point(near_cbrt(x), lambda y: b.sqrt(b.sqrt(x * y)), within="1/25")
    made = space_of([kernel_of(b.graph({"y": root}), lower="1e-3", upper="1e3")], array_api_files)
    x64 = np.geomspace(2e-3, 900, 500)
    np.testing.assert_allclose(made["kernel"](x64).y, np.cbrt(x64), rtol=4e-16)


def test_types_shapes_and_numbers() -> None:
    xp = pytest.importorskip("array_api_strict")
    made = space_of([together()], array_api_files)["kernel"]
    single, double = xp.ones((2, 1), dtype=xp.float32), xp.ones(3)
    assert made(single, 2.0).y.dtype == made(2, single).y.dtype == xp.float32
    assert made(single, double).y.dtype == made(xp.asarray([1, 2]), 2).y.dtype == xp.float64
    assert made(single, double).y.shape == (2, 3)
    assert made(double, np.float64(2)).y.shape == (3,)
    for given, told in (
        (
            (double, xp.ones(2)),
            "inputs must have shapes that broadcast, got x \\(3,\\), z \\(2,\\)",
        ),
        (
            (double, np.ones(3)),
            "inputs must be arrays of one library, got x array_api_strict, z nu",
        ),
        ((1.0, 2), "inputs must be arrays of one library, got numbers alone"),
        ((double, [1.0]), "z must be an array of a library of .*, got list of builtins"),
        ((double, True), "z must be an array of a library of .*, got bool of builtins"),
        ((double, xp.ones(3, dtype=xp.bool)), "z must be real numbers of type .*, got .*bool"),
    ):
        with pytest.raises((TypeError, ValueError), match=f"^kernel: {told}"):
            made(*given)


@pytest.mark.parametrize("target", [array_api_files, jax_files])
def test_one_format_refuses_the_other(jax: Any, target: Any) -> None:
    made = space_of([whole()], target, ["float32"])["kernel"]
    assert made(np.ones(2, np.float32)).y.dtype == np.float32
    with pytest.raises(
        TypeError, match=r"only float32 is here, and inputs must be of it, got x float64$"
    ):
        made(np.ones(2))


def test_the_first_that_is_wrong_is_told(jax: Any) -> None:
    """Of several inputs that of the first place; of what is wrong there the first input."""
    numpys = function_of(together())
    ours = [space_of([together()], target)["kernel"] for target in (array_api_files, jax_files)]
    for x, z in (
        ([[1.0], [1e9]], [1.0, 2.0, np.nan]),
        ([[1.0], [np.inf]], [-1e7, 2.0, 3.0]),
        ([[0.0], [1.0]], [1.0, 2.0, 0.0]),
        (np.nan, 2.0),
    ):
        given = [np.array(each) for each in (x, z)]
        with pytest.raises(ValueError, match="must be") as refused:
            numpys(*given)
        for made in ours:
            with pytest.raises(ValueError, match="must be") as again:
                made(*given)
            assert str(again.value) == str(refused.value)


def roots() -> list[Kernel]:
    """Two outputs, a kernel of their derivatives with one sign turned, and one that has none."""
    b, c = GraphBuilder(), GraphBuilder()
    x, z = c.symbol("x"), c.symbol("z")
    p, q = b.symbol("x"), b.symbol("z")
    both = (closed("x", "an argument", "1e-3", "1e3"), closed("z", "an argument", "1e-3", "1e3"))
    base = kernel_of(b.graph({"ratio": p / q, "root": b.sqrt(p * q)}))
    first = kernel_of(c.graph({"by_x": 1 / z, "by_z": x / z / z, "half": c.sqrt(z / x) / 2}))
    other = replace(first, inputs=both, name="slopes", result="Slopes")
    return [replace(base, inputs=both), other]


def test_derivatives_are_found_by_their_values() -> None:
    assert slopes(roots()) == [
        (Slope(0, 0, 1, 0, 1), Slope(0, 1, 1, 1, -1), Slope(1, 0, 1, 2, 1)),
        (),
    ]


@pytest.mark.parametrize(
    "write",
    [
        lambda b, x: b.select(x, 1, x, x * x),
        lambda b, x: b.select(x, 1, x * x, x),
        lambda _, x: x * x * x,
    ],
)
def test_what_is_a_derivative_in_part_is_none(write: Callable[[GraphBuilder, Node], Node]) -> None:
    base, other = simple(lambda _, x: x * x / 2), simple(write)
    assert slopes([base, replace(other, name="other")]) == [(), ()]
    line = simple(lambda _, x: x * 1)
    assert slopes([base, replace(line, name="line")])[0] == (Slope(0, 0, 1, 0, 1),)


def test_derivatives_of_jax(jax: Any) -> None:
    """By kernels where they have them, else by JAX's own, to all orders, against those by hand."""
    made = space_of(roots(), jax_files)
    x, z = 3.0, 7.0
    grad, kernel = jax.grad, made["kernel"]
    by_x, by_z, half = (float(y) for y in made["slopes"](x, z))
    assert grad(lambda x: kernel(x, z).ratio)(x) == by_x
    assert grad(lambda z: kernel(x, z).ratio)(z) == -by_z
    assert grad(lambda x: kernel(x, z).root)(x) == half
    for found, wanted in (
        (grad(lambda z: kernel(x, z).root)(z), (x / z) ** 0.5 / 2),  # no kernel has it
        (grad(grad(lambda x: kernel(x, z).root))(x), -(z**0.5) / 4 / x**1.5),
        (grad(grad(lambda z: kernel(x, z).ratio))(z), 2 * x / z**3),
        (jax.jacfwd(lambda z: kernel(x, z).ratio * z)(z), 0.0),
    ):
        assert float(found) == pytest.approx(wanted, rel=1e-14, abs=1e-16)
    wrong = jax.vmap(grad(lambda z: kernel(x, z).ratio))(np.array([7.0, -1.0, np.nan]))
    np.testing.assert_array_equal(np.isnan(wrong), [False, True, True])


def test_subnormal_numbers_are_outside_of_a_domain_of_jax(jax: Any) -> None:
    """XLA takes them for 0, and 1 over 0 is no number."""
    made = space_of([simple(lambda _, x: 1 / x)], jax_files)["kernel"]
    with pytest.raises(ValueError, match=r"x must be a number above 0 and finite, got 0\.0$"):
        made(0.0)
    assert np.isnan(jax.jit(made)(5e-324).y)
    assert jax.jit(made)(2.0).y == 0.5
