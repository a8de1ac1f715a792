"""How the printed kernels treat arrays: shapes, types, blocks, given outputs, no warnings."""

from __future__ import annotations

import warnings
from typing import Any

import numpy as np
import pytest
from every_kernel import KERNELS, every_kernel
from hypothesis import given, settings
from hypothesis import strategies as st
from hypothesis.extra import numpy as arrays
from kernel_errors import log_uniform
from one_of_each import cases
from printed_kernels import DTYPES, PrintedKernel
from samples import samples

from gainproof.generated._blocks import BLOCK


def sample(kernel: PrintedKernel, count: int, dtype: Any = np.float64) -> Any:
    """Arguments inside the domain."""
    low, high = kernel.domain[np.dtype(dtype).name]
    if kernel.whole:
        return (low + np.arange(count) % 1000).astype(dtype)
    top = min(high, 1e3)
    return (low + (top - low) * (np.arange(count) + 1) / (count + 1)).astype(dtype)


@every_kernel
@pytest.mark.parametrize("dtype", DTYPES)
def test_type_and_shape_are_those_of_the_argument(kernel: PrintedKernel, dtype: str) -> None:
    for shape in ((), (0,), (1,), (5,), (2, 3), (3, 0, 2), (2, 1, 2)):
        x = sample(kernel, int(np.prod(shape)), dtype).reshape(shape)
        result = kernel.function(x)
        assert type(result)._fields == kernel.outputs
        for output in result:
            assert output.shape == shape
            assert output.dtype == dtype


@every_kernel
def test_numbers_give_numbers(kernel: PrintedKernel) -> None:
    x = float(sample(kernel, 3)[1])
    for kind in (float, np.float32, np.float64):
        for output in kernel.function(kind(x)):
            assert type(output) is kind


@every_kernel
def test_integers_and_lists_become_float64(kernel: PrintedKernel) -> None:
    if kernel.argument in {"alpha", "beta"}:
        assert kernel.function([0.25, 0.375])[0].dtype == np.float64
        return
    expected = kernel.function(np.array([3.0, 7.0]))
    for given_ in ([3, 7], (3, 7), np.array([3, 7]), np.array([3, 7], np.uint8)):
        for found, reference in zip(kernel.function(given_), expected, strict=True):
            assert found.dtype == np.float64
            np.testing.assert_array_equal(found, reference)
    assert kernel.function(3)[0] == expected[0][0]


@pytest.mark.alike
@every_kernel
@pytest.mark.parametrize("dtype", cases(DTYPES, lambda dtype: dtype == "float32"))
def test_every_element_is_what_it_would_be_alone(kernel: PrintedKernel, dtype: str) -> None:
    for count in (BLOCK - 1, BLOCK, BLOCK + 1, 2 * BLOCK + 3):
        x = sample(kernel, count, dtype)
        result = kernel.function(x)
        for place in (0, 1, BLOCK - 2, BLOCK - 1, BLOCK, count - 1):
            if place < count:
                for whole, alone in zip(result, kernel.function(x[place]), strict=True):
                    np.testing.assert_array_equal(whole[place], alone)


@every_kernel
def test_any_layout_gives_the_same_numbers(kernel: PrintedKernel) -> None:
    x = sample(kernel, 240).reshape(12, 20)
    expected = kernel.function(x)
    swapped = x.astype(x.dtype.newbyteorder())
    wide = np.repeat(x, 2, axis=1)[:, ::2]
    read_only = x.copy()
    read_only.flags.writeable = False
    for same in (np.asfortranarray(x), wide, swapped, read_only, x[::-1][::-1]):
        for found, reference in zip(kernel.function(same), expected, strict=True):
            np.testing.assert_array_equal(found, reference)
    for found, reference in zip(kernel.function(x.T), expected, strict=True):
        np.testing.assert_array_equal(found, reference.T)
    spread = np.broadcast_to(x[0], (7, 20))
    for found, reference in zip(kernel.function(spread), expected, strict=True):
        np.testing.assert_array_equal(found, np.broadcast_to(reference[0], (7, 20)))


@every_kernel
@pytest.mark.parametrize("dtype", DTYPES)
def test_given_outputs_are_filled_and_returned(kernel: PrintedKernel, dtype: str) -> None:
    x = sample(kernel, 60, dtype).reshape(3, 20)
    expected = kernel.function(x)
    many = len(kernel.outputs)
    plain = tuple(np.full(x.shape, -7, dtype) for _ in range(many))
    strided = tuple(np.full((3, 40), -7, dtype)[:, ::2] for _ in range(many))
    turned = tuple(np.full((20, 3), -7, dtype).T for _ in range(many))
    for out in (plain, strided, turned):
        result = kernel.function(x, out=out)
        for mine, returned, reference in zip(out, result, expected, strict=True):
            assert returned is mine
            np.testing.assert_array_equal(mine, reference)


@pytest.mark.alike
@every_kernel
def test_an_output_may_be_the_argument_itself(kernel: PrintedKernel) -> None:
    x = sample(kernel, BLOCK + 100)
    expected = kernel.function(x)
    for place in range(len(kernel.outputs)):
        own = x.copy()
        out = [np.empty_like(x) for _ in kernel.outputs]
        out[place] = own
        kernel.function(own, out=tuple(out))
        for found, reference in zip(out, expected, strict=True):
            np.testing.assert_array_equal(found, reference)
    # and a part of it, moved by one element
    long = np.concatenate([x, x[-1:]])
    out = [np.empty_like(x) for _ in kernel.outputs]
    out[0] = long[1:]
    kernel.function(long[:-1], out=tuple(out))
    for found, reference in zip(out, expected, strict=True):
        np.testing.assert_array_equal(found, reference)


@every_kernel
def test_the_argument_is_left_alone(kernel: PrintedKernel) -> None:
    x = sample(kernel, 100)
    before = x.copy()
    kernel.function(x)
    np.testing.assert_array_equal(x, before)


@every_kernel
@pytest.mark.parametrize("dtype", DTYPES)
def test_no_warning_and_no_nan_anywhere_in_the_domain(kernel: PrintedKernel, dtype: str) -> None:
    low, high = kernel.domain[dtype]
    kind = np.dtype(dtype).type
    spread = np.array(
        log_uniform(max(low, 5e-324 if dtype == "float64" else 1.5e-45), high, 3000, seed=4)
    )
    x = np.clip(np.append(spread, [low, high]).astype(dtype), kind(low), kind(high))
    if kernel.whole:
        x = np.floor(x)
    with warnings.catch_warnings(), np.errstate(all="raise"):
        warnings.simplefilter("error")
        for output in kernel.function(x):
            assert not np.isnan(output).any()


@pytest.mark.parametrize("dtype", DTYPES)
@settings(max_examples=samples(10), deadline=None)
@given(data=st.data())
def test_any_array_inside_the_domain_is_taken(dtype: str, data: st.DataObject) -> None:
    kernel = data.draw(st.sampled_from([k for k in KERNELS if not k.whole]))
    low, high = kernel.domain[dtype]
    elements = st.floats(low, high, width=64 if dtype == "float64" else 32)
    x = data.draw(arrays.arrays(dtype, arrays.array_shapes(max_dims=4), elements=elements))
    for output in kernel.function(x):
        assert output.shape == x.shape
        assert output.dtype == x.dtype
        assert not np.isnan(output).any()
