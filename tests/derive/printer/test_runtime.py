"""Guards, types, shapes and output arrays of printed kernels."""

from __future__ import annotations

import array
import warnings
from concurrent.futures import ThreadPoolExecutor
from fractions import Fraction
from functools import cache
from importlib import import_module
from typing import Any

import numpy as np
import pytest
from graph_kernels import function_of, kernel_of
from numpy.lib.stride_tricks import as_strided

from gainproof.derive.printer.graph import GraphBuilder
from gainproof.derive.printer.shipped._bits import choose, mask_of
from gainproof.derive.printer.shipped._blocks import BLOCK
from gainproof.generated._runtime import with_arrays


@cache
def two() -> Any:
    """root = sqrt(x), square = x x for positive x."""
    b = GraphBuilder()
    x = b.symbol("x")
    return function_of(kernel_of(b.graph({"root": b.sqrt(x), "square": x * x})))


@cache
def counted() -> Any:
    """6/(k (k + 1)) for whole numbers from 1."""
    b = GraphBuilder()
    k = b.symbol("x")
    graph = b.graph({"y": 6 / (k * (k + 1))})
    return function_of(kernel_of(graph, lower=1, lower_open=False, integer=True, upper=10**9))


def test_numbers_give_numbers() -> None:
    for given, kind in (
        (4.0, float),
        (4, float),
        (np.float64(4), np.float64),
        (np.uint8(4), np.float64),
        (np.float32(4), np.float32),
    ):
        found = two()(given)
        assert [type(each) for each in found] == [kind, kind]
        assert found == (2, 16)
        assert found.root == 2


def test_arrays_keep_shape_and_type() -> None:
    for shape in ((), (0,), (3,), (2, 0), (2, 3, 4), (BLOCK + 1,), (3, BLOCK)):
        for kind in (np.float32, np.float64):
            x = np.full(shape, 4, kind)
            root, square = two()(x)
            assert root.shape == square.shape == shape
            assert root.dtype == square.dtype == kind
            assert np.all(root == 2)
            assert np.all(square == 16)
    assert two()([1, 4]).root.dtype == np.float64
    assert two()(np.arange(1, 5, dtype=np.uint8)).square.tolist() == [1, 4, 9, 16]
    assert two()(np.array([4.0], ">f8")).root.tolist() == [2]


@pytest.mark.parametrize("kind", [np.float32, np.float64])
@pytest.mark.parametrize("name", ["random_jerk", "random_velocity"])
def test_numbers_of_a_block_are_arrays_of_the_type(kind: Any, name: str) -> None:
    """The same bits as with Python numbers; the function that was printed stays as it is."""
    signature = import_module(f"gainproof.generated.{name}")._GAINS
    printed: Any = signature.block.__defaults__
    own: Any = with_arrays(signature.block, np.dtype(kind))
    assert len(printed) > 5
    assert all(each.dtype == kind and each.shape == () for each in own.__defaults__)
    assert signature.block.__defaults__ is printed
    assert all(isinstance(each, float) for each in printed)
    assert with_arrays(signature.block, np.dtype(kind)) is own
    x = np.geomspace(1e-20, 1e20, 999).astype(kind)
    found = []
    for block in (signature.block, own):
        out, work = (np.empty((count, x.size), kind) for count in (3, signature.work))
        with np.errstate(all="ignore"):
            block([x], [*out[: len(signature.outputs)]], [*work], kind is np.float32)
        found.append(out[: len(signature.outputs)])
    assert np.array_equal(found[0], found[1])


def test_every_layout_gives_the_same() -> None:
    x = np.linspace(1, 2, 6 * BLOCK).reshape(3, 2 * BLOCK)
    plain = two()(x)
    for view, back in ((x.T, (1, 0)), (np.asfortranarray(x), (0, 1))):
        for found, wanted in zip(two()(view), plain, strict=True):
            assert np.array_equal(found.transpose(back), wanted)
    assert np.array_equal(two()(x[::-1, ::3]).root, plain.root[::-1, ::3])


@pytest.mark.parametrize("bad", [np.nan, np.inf, -np.inf, -1.0, 0.0, -0.0])
@pytest.mark.parametrize("kind", [np.float32, np.float64])
def test_inputs_outside_the_domain(bad: float, kind: type[Any]) -> None:
    with pytest.raises(ValueError, match="x must be a number above 0 and finite, got") as caught:
        two()(kind(bad))
    assert "index" not in str(caught.value)
    for place in (0, 5, BLOCK, 2 * BLOCK + 3):
        x = np.ones(2 * BLOCK + 4, kind)
        x[place] = bad
        with pytest.raises(ValueError, match=rf"got {kind(bad)!s} at index {place}$"):
            two()(x)
    x = np.ones((4, 5), kind)
    x[2, 3] = bad
    with pytest.raises(ValueError, match=r"at index \(2, 3\)$"):
        two()(x.T.copy().T)


def test_no_output_is_touched_by_bad_input() -> None:
    x = np.ones(3 * BLOCK)
    x[-1] = np.nan
    out = (np.full(x.shape, 7.0), np.full(x.shape, 7.0))
    with pytest.raises(ValueError, match="got nan"):
        two()(x, out=out)
    assert all(np.all(each == 7) for each in out)


@pytest.mark.parametrize(
    "bad",
    [
        1j,
        True,
        "1",
        None,
        [1, "2"],
        np.float16(1),
        np.longdouble(1),
        np.array([1], object),
        np.array(["2020"], "M8[Y]"),
        10**30,
    ],
)
def test_wrong_types(bad: Any) -> None:
    with pytest.raises(TypeError, match="x must be real numbers of type float64 or float32"):
        two()(bad)


@pytest.mark.parametrize(
    ("bad", "told"),
    [
        ("1", "text"),
        (b"1", "text"),
        ([1, "2"], "text"),
        (None, "None"),
        ([1.5, None], "None"),
        ({}, "dict"),
        ([Fraction(1, 2)], "Fraction"),
        (10**400, "a larger one"),
        ([0.5, -(10**30)], "a larger one"),
        (np.array([1, 2.5], object), "an array of objects"),
        (1j, "complex128"),
        (True, "bool"),
        (np.float16(1), "float16"),
    ],
)
def test_what_came_is_told_in_words(bad: Any, told: str) -> None:
    with pytest.raises(TypeError, match=rf"or integers of at most 64 bits, got {told}$"):
        two()(bad)


def test_masked_elements_are_refused() -> None:
    """What lies under a mask is no number that was meant."""
    table = np.ma.array([[0.5, 0.7], [0.8, 0.9]], mask=[[False, False], [True, False]])
    with pytest.raises(ValueError, match=r"got a masked element at index \(1, 0\)$"):
        two()(table)
    with pytest.raises(ValueError, match=r"got a masked element at index 1$"):
        two()(table[:, 0])
    with pytest.raises(ValueError, match=r"got a masked element$"):
        two()(np.ma.masked)
    whole = two()(table[0])
    assert [y.tolist() for y in whole] == [y.tolist() for y in two()([0.5, 0.7])]


def never(*_: Any, **__: Any) -> Any:
    raise AssertionError("asked of its type alone")


@pytest.mark.parametrize(
    ("module", "name", "way"),
    [
        ("pandas.core.series", "Series", "__array__"),
        ("xarray.core.dataarray", "DataArray", "__array__"),
        ("torch", "Tensor", "__array__"),
        ("dask.array.core", "Array", "__array__"),
        ("jaxlib._jax", "ArrayImpl", "__array__"),
        ("cupy", "ndarray", "__cuda_array_interface__"),
        ("of_tomorrow.arrays", "Cube", "__dlpack__"),
    ],
)
def test_arrays_of_other_libraries_are_refused_by_name(module: str, name: str, way: str) -> None:
    """Alone, in lists of lists, in an output's place; and nothing of theirs is computed."""
    kind = type(name, (), {"__module__": module, way: never, "__getattr__": never})
    told = f"{name} of {module.partition('.')[0]}"
    wanted = f"x must be a number, an array of NumPy or a list, got {told}: arrays of other"
    for given in (kind(), [1.0, kind()], [[1, 2], (3.0, kind())]):
        with pytest.raises(TypeError, match=wanted):
            two()(given)
        with pytest.raises(TypeError, match=wanted):
            two()(given, workers=2)
    with pytest.raises(TypeError, match=f"out root must be an array of NumPy, got {told}$"):
        two()(np.ones(3), out=(kind(), np.ones(3)))


def test_a_subclass_of_arrays_that_is_no_numpys_is_refused() -> None:
    """It may hold units, which would be lost."""
    kind = type("Quantity", (np.ndarray,), {"__module__": "astropy.units.quantity"})
    with pytest.raises(TypeError, match="got Quantity of astropy"):
        two()(np.ones(3).view(kind))
    with pytest.raises(TypeError, match="out square must be an array of NumPy, got Quantity of"):
        two()(np.ones(3), out=(np.ones(3), np.ones(3).view(kind)))


@pytest.mark.parametrize(
    "given",
    [(4.0, 4), [4, np.float64(4)], [[4.0], [4.0]], range(4, 6), memoryview(array.array("d", [4.0])),
     array.array("d", [4.0, 4.0]), [array.array("d", [4.0])] * 2],
)  # fmt: skip
def test_lists_and_buffers_of_numbers_are_taken(given: Any) -> None:
    assert two()(given).square.flat[0] == 16


def test_whole_numbers() -> None:
    assert counted()([1, 2]).y.tolist() == [3, 1]
    assert counted()(3.0).y == 0.5
    with pytest.raises(
        ValueError, match=r"a whole number at least 1 and below 1000000000, got 1.5"
    ):
        counted()([1, 1.5])
    with pytest.raises(ValueError, match=r"got 0.0 at index 1"):
        counted()([1, 0])


def test_given_outputs() -> None:
    x = np.linspace(1, 3, 2 * BLOCK + 5)
    plain = two()(x)
    out = (np.empty_like(x), np.empty((x.size, 2))[:, 0])
    found = two()(x, out=out)
    assert found.root is out[0]
    assert found.square is out[1]
    assert np.array_equal(out[0], plain.root)
    assert np.array_equal(out[1], plain.square)
    again = two()(x, out=found)
    assert again.root is out[0]
    columns = np.empty((x.size, 2))
    two()(x, out=(columns[:, 0], columns[:, 1]))
    assert np.array_equal(columns[:, 1], plain.square)
    nought = (np.empty(()), np.empty(()))
    assert two()(4.0, out=nought).root is nought[0]
    assert nought[0] == 2


def test_an_output_may_be_the_input() -> None:
    x = np.linspace(1, 3, 2 * BLOCK + 5)
    plain = two()(x)
    for shift in (0, 3):
        whole = np.concatenate([x, np.ones(shift)])
        given = whole[: x.size]
        target = whole[shift : shift + x.size]
        found = two()(given, out=(target, np.empty_like(x)))
        assert np.array_equal(found.root, plain.root)
        assert np.array_equal(found.square, plain.square)


def test_outputs_that_do_not_fit() -> None:
    x = np.ones(3)
    fine = np.empty(3)
    frozen = np.empty(3)
    frozen.flags.writeable = False
    for out, kind, text in (
        (fine, ValueError, r"out must be a tuple of 2 arrays \(root, square\), got ndarray"),
        ((fine,), ValueError, "got tuple of 1"),
        ((fine, [0.0] * 3), TypeError, "out square must be an array of NumPy, got list"),
        ((fine, np.empty(3, np.float32)), TypeError, "of type float64, got float32"),
        ((np.empty(4), fine), ValueError, r"out root must have shape \(3,\), got \(4,\)"),
        ((np.empty((1, 3)), fine), ValueError, r"must have shape \(3,\), got \(1, 3\)"),
        ((fine, frozen), ValueError, "out square must be writable"),
        ((fine, fine), ValueError, "out root and square share memory"),
        ((fine, as_strided(np.empty(1), (3,), (0,))), ValueError, "square must not hold its"),
        ((as_strided(np.empty(2), (3,), (4,)), fine), ValueError, "root must not hold its"),
    ):
        with pytest.raises(kind, match=text):
            two()(x, out=out)


def test_outputs_in_any_order_with_gaps_and_of_a_subclass() -> None:
    """A matrix and a masked array are arrays; their own ways are not what fills them."""
    x = np.linspace(1, 3, 6 * BLOCK).reshape(6, BLOCK)
    plain = two()(x)
    swapped = np.empty((BLOCK, 6)).T
    gaps = np.empty((12, 2 * BLOCK))[::-2, ::2]
    masked: Any = np.ma.masked_array(np.zeros(x.shape), mask=x > 2)
    with warnings.catch_warnings():
        warnings.simplefilter("ignore", PendingDeprecationWarning)
        matrix: Any = np.asmatrix(np.zeros(x.shape))
    for target in (swapped, gaps, masked, matrix):
        found = two()(x, out=(target, np.empty_like(x)))
        assert found.root is target
        assert np.array_equal(np.asarray(target), plain.root)
    assert np.array_equal(masked.mask, x > 2)


@pytest.mark.parametrize("kind", [np.float32, np.float64])
def test_choosing_between_arrays_numbers_and_the_result_itself(kind: type[Any]) -> None:
    rng = np.random.default_rng(3)
    condition = rng.random(50) < 0.5
    mask = mask_of(condition, kind is np.float32)
    x, y = (rng.normal(size=50).astype(kind) for _ in range(2))
    x[::5], y[::7] = np.nan, np.inf
    for first in (x, y, 0.0, -2.5):
        for second in (x, y, 0.0):
            wanted = np.where(condition, first, second).astype(kind)
            for target in (first, second, np.empty(50, kind)):
                if isinstance(target, np.ndarray):
                    kept = target.copy()
                    choose(mask, first, second, target)
                    assert np.array_equal(target, wanted, equal_nan=True)
                    target[:] = kept


def test_no_warning_escapes() -> None:
    with warnings.catch_warnings(), np.errstate(all="raise"):
        warnings.simplefilter("error")
        found = two()(np.array([5e-324, 1e-200, 1e200, 1.7e308]))
        assert found.square.tolist() == [0, 0, np.inf, np.inf]
        for out in (None, (np.empty(2), np.empty(2))):
            with pytest.raises(ValueError, match="got nan at index 1"):
                two()([1.0, np.nan], out=out)


def test_threads_do_not_meet() -> None:
    def run(seed: int) -> bool:
        x = np.random.default_rng(seed).uniform(1, 2, 5 * BLOCK)
        return np.array_equal(two()(x).root, np.sqrt(x))

    with ThreadPoolExecutor(4) as pool:
        assert all(pool.map(run, range(16)))
