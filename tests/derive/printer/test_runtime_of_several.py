"""Guards, types, shapes and output arrays of printed kernels with two inputs."""

from __future__ import annotations

import warnings
from dataclasses import replace
from functools import cache
from typing import Any

import numpy as np
import pytest
from graph_kernels import function_of, several_of

from gainproof.derive.printer.bound import prove
from gainproof.derive.printer.formats import FLOAT64
from gainproof.derive.printer.graph import GraphBuilder
from gainproof.derive.printer.kernel import closed
from gainproof.derive.printer.shipped._blocks import BLOCK


@cache
def pair() -> Any:
    """total = x + z z, share = sqrt(x)/z for x and z from 1e-9 to 1e9, 1e-3 to 1e3 in float32."""
    b = GraphBuilder()
    x, z = b.symbol("x"), b.symbol("z")
    graph = b.graph({"total": x + z * z, "share": b.sqrt(x) / z})
    return function_of(several_of(graph, "1e-9", "1e9", single=("1e-3", "1e3")))


def wanted(x: Any, z: Any) -> tuple[Any, Any]:
    """The same operations on whole arrays."""
    return x + z * z, np.sqrt(x) / z


def test_numbers_give_numbers() -> None:
    for x, z, kind in (
        (4.0, 2.0, float),
        (4, 2.0, float),
        (np.float64(4), 2.0, np.float64),
        (4, np.int8(2), np.float64),
        (np.float32(4), np.float32(2), np.float32),
        (np.float32(4), 2.0, np.float64),
        (4, np.float32(2), np.float64),
    ):
        found = pair()(x, z)
        assert [type(each) for each in found] == [kind, kind]
        assert found == (8, 1)
        assert found.share == 1


@pytest.mark.parametrize(
    ("first", "second", "shape"),
    [
        ((), (3,), (3,)),
        ((3,), (), (3,)),
        ((4, 1), (3,), (4, 3)),
        ((1, 3), (4, 1), (4, 3)),
        ((2, 1, 3), (4, 1), (2, 4, 3)),
        ((0,), (1,), (0,)),
        ((), (2, 0), (2, 0)),
        ((3, BLOCK), (3, 1), (3, BLOCK)),
    ],
)
def test_shapes_are_broadcast(
    first: tuple[int, ...], second: tuple[int, ...], shape: tuple[int, ...]
) -> None:
    generator = np.random.default_rng(1)
    x, z = generator.uniform(1, 9, first), generator.uniform(1, 9, second)
    for kind in (np.float64, np.float32):
        found = pair()(x.astype(kind), z.astype(kind))
        for mine, reference in zip(found, wanted(x.astype(kind), z.astype(kind)), strict=True):
            assert mine.shape == shape
            assert mine.dtype == kind
            np.testing.assert_array_equal(mine, reference)


def test_types_mix_to_float64() -> None:
    """Exactly what the numbers give after they have become float64."""
    x = np.array([0.1, 0.2], np.float32)
    for z in (0.3, [3, 4], np.array([3, 4], np.uint8), np.array([0.1, 0.2]), (1, 2)):
        found = pair()(x, z)
        for mine, reference in zip(
            found, wanted(x.astype(float), np.asarray(z, float)), strict=True
        ):
            assert mine.dtype == np.float64
            np.testing.assert_array_equal(mine, reference)
    for bad in (np.float16(1), "1", None, 1j, True):
        for given in ((bad, x), (x, bad)):
            with pytest.raises(TypeError, match=r"kernel: [xz] must be real numbers"):
                pair()(*given)


def test_shapes_that_do_not_fit() -> None:
    out = tuple(np.full(3, -7.0) for _ in range(2))
    with pytest.raises(ValueError, match=r"kernel: inputs .* broadcast, got x \(3,\), z \(4,\)$"):
        pair()(np.ones(3), np.ones(4), out=out)
    with pytest.raises(ValueError, match=r"out total must have shape \(2, 3\), got \(3,\)"):
        pair()(np.ones(3), np.ones((2, 1)), out=out)
    with pytest.raises(TypeError, match="out total must be of type float32"):
        pair()(np.ones(3, np.float32), np.float32(1), out=out)
    assert all((y == -7).all() for y in out)


@pytest.mark.parametrize("bad", [np.nan, 0.0, -1.0, np.inf, 1e-10, 1e10])
@pytest.mark.parametrize("name", ["x", "z"])
def test_either_input_is_guarded_before_an_output_is_touched(name: str, bad: float) -> None:
    count = 2 * BLOCK + 5
    given = {"x": np.ones(count), "z": np.ones(count)}
    place = count - 2
    given[name][place] = bad
    out = tuple(np.full(count, -7.0) for _ in range(2))
    message = rf"kernel: {name} must be a number at least 1e-9 .* got .* at index {place}$"
    for options in ({}, {"out": out}):
        with pytest.raises(ValueError, match=message):
            pair()(given["x"], given["z"], **options)
    assert all((y == -7).all() for y in out)


def test_a_bad_element_is_placed_in_its_own_array() -> None:
    x, z = np.ones((4, 1)), np.ones(3)
    z[1] = np.nan
    with pytest.raises(ValueError, match=r"z must be .* got nan at index 1$"):
        pair()(x, z)
    x[2, 0] = -1
    with pytest.raises(ValueError, match=r"x must be .* got -1.0 at index \(2, 0\)$"):
        pair()(x, np.ones(3))
    with pytest.raises(ValueError, match=r"z must be .* got 0.0$"):
        pair()(np.ones(3), 0.0)


def test_float32_has_its_own_domain() -> None:
    low = np.float32(1e-3)
    assert pair()(low, np.float32(1e3)).total == np.float32(1e6) + low
    for bad in (np.nextafter(low, np.float32(0)), np.float32(1001)):
        with pytest.raises(ValueError, match=r"z must be .* in float32 at least 1e-3 and at most"):
            pair()(low, bad)
        assert pair()(float(low), bad).total > 0  # float64 then


def test_outputs_may_be_the_inputs() -> None:
    generator = np.random.default_rng(2)
    x, z = (generator.uniform(1, 9, BLOCK + 7) for _ in range(2))
    expected = wanted(x, z)
    for order in (0, 1):
        own = [x.copy(), z.copy()]
        out = (own[order], own[1 - order])
        found = pair()(*own, out=out)
        for mine, returned, reference in zip(out, found, expected, strict=True):
            assert returned is mine
            np.testing.assert_array_equal(mine, reference)
    grid = np.full((5, 7), -7.0), np.full((7, 5), -7.0).T
    pair()(x[:5, None], z[:7], out=grid)
    for mine, reference in zip(grid, wanted(x[:5, None], z[:7]), strict=True):
        np.testing.assert_array_equal(mine, reference)


def test_no_warning_on_the_whole_domain() -> None:
    ends = np.array([1e-9, 1.0, 1e9])
    with warnings.catch_warnings(), np.errstate(all="raise"):
        warnings.simplefilter("error")
        found = pair()(ends[:, None], ends)
        assert all(np.isfinite(y).all() for y in found)


def test_three_inputs_are_taken() -> None:
    """sqrt(x y + z): the product weighs half where it is large, the sum half, the root one."""
    b = GraphBuilder()
    x, y, z = (b.symbol(name) for name in "xyz")
    graph = b.graph({"root": b.sqrt(x * y + z)})
    inputs = tuple(closed(name, "an argument", "1e-3", "1e3") for name in "xyz")
    kernel = replace(several_of(graph, 1, 2), inputs=inputs)
    assert 0.96 <= prove(kernel, FLOAT64).outputs[0].bound <= 1.04
    found = function_of(kernel)(np.ones((2, 1, 1)), np.ones((3, 1)), [3.0, 8.0])
    assert found[0].shape == (2, 3, 2)
    assert found[0][1, 2].tolist() == [2, 3]


def test_no_warning_of_a_number_that_signals() -> None:
    """float32 beside float64 is widened, where a signalling NaN is an invalid operation."""
    signals = np.array([0x7F800001], np.uint32).view(np.float32)
    with warnings.catch_warnings(), np.errstate(all="raise"):
        warnings.simplefilter("error")
        for bad in (signals, signals[0], [signals[0], 1.0]):
            with pytest.raises(ValueError, match=r"x must be .*got nan"):
                pair()(bad, 1.0)
