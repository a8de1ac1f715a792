"""What the printed kernels refuse, what they say, and that nothing is touched before."""

from __future__ import annotations

import math
from decimal import Decimal
from fractions import Fraction
from itertools import product
from typing import Any

import numpy as np
import pytest
from every_kernel import every_kernel
from one_of_each import cases
from printed_kernels import DTYPES, PrintedKernel


def inside(kernel: PrintedKernel) -> float:
    low, high = kernel.domain["float64"]
    return low + 5 if kernel.whole else min(max(0.5, 2 * low), high / 2)


def outputs(kernel: PrintedKernel, shape: tuple[int, ...], dtype: str) -> tuple[Any, ...]:
    return tuple(np.full(shape, -7, dtype) for _ in kernel.outputs)


def untouched(out: tuple[Any, ...]) -> bool:
    return all((y == -7).all() for y in out)


def outside(kernel: PrintedKernel, dtype: str) -> list[float]:
    low, high = (np.dtype(dtype).type(x) for x in kernel.domain[dtype])
    with np.errstate(all="ignore"):  # the next number may be subnormal or infinite
        below = float(low - 1 if kernel.whole else np.nextafter(low, low.dtype.type(-1)))
        above = float(np.nextafter(high, high.dtype.type(np.inf)))
    bad = [math.nan, math.inf, -math.inf, -1.0, below, above]
    if low > 0:
        bad += [0.0, -0.0]
    return [*bad, 2.5, float(low) + 0.5] if kernel.whole else bad


@every_kernel
@pytest.mark.parametrize("dtype", DTYPES)
def test_numbers_outside_the_domain(kernel: PrintedKernel, dtype: str) -> None:
    kind = np.dtype(dtype).type
    for bad in outside(kernel, dtype):
        value = kind(bad)
        with pytest.raises(ValueError, match=f"{kernel.name}: {kernel.argument} must be") as error:
            kernel.function(value)
        assert str(value) in str(error.value), "the message says what came"


@pytest.mark.alike
@every_kernel
@pytest.mark.parametrize(
    ("count", "dtype"),
    cases(product((40, 40_000), DTYPES), lambda case: (case[0] == 40) == (case[1] == "float32")),
)
def test_one_bad_element_leaves_given_outputs_untouched(
    kernel: PrintedKernel, dtype: str, count: int
) -> None:
    for bad in (math.nan, -1.0, math.inf):
        for place in (0, count // 2, count - 1):
            x = np.full(count, inside(kernel), dtype)
            x[place] = bad
            out = outputs(kernel, x.shape, dtype)
            with pytest.raises(ValueError, match=f"got .* at index {place}$"):
                kernel.function(x, out=out)
            assert untouched(out)
            with pytest.raises(ValueError, match=f"at index {place}$"):
                kernel.function(x)


@every_kernel
def test_the_place_of_a_bad_element_is_named_in_any_shape(kernel: PrintedKernel) -> None:
    x = np.full((4, 5, 6), inside(kernel))
    x[2, 3, 4] = math.nan
    with pytest.raises(ValueError, match=r"got nan at index \(2, 3, 4\)$"):
        kernel.function(x)
    with pytest.raises(ValueError, match=r"got nan at index \(4, 3, 2\)$"):
        kernel.function(x.T)


@every_kernel
def test_wrong_types(kernel: PrintedKernel) -> None:
    x = inside(kernel)
    wrong: list[Any] = [
        np.float16(x),
        np.longdouble(x),
        complex(x),
        np.array([x], np.complex64),
        True,
        np.array([True]),
        str(x),
        [str(x)],
        None,
        [None],
        Fraction(x),
        Decimal(x),
        np.array([x], object),
        np.datetime64("2000-01-01"),
        {"x": x},
        10**30,
    ]
    for bad in wrong:
        out = outputs(kernel, np.shape(bad) if not isinstance(bad, dict) else (), "float64")
        with pytest.raises(TypeError, match=f"{kernel.name}: {kernel.argument} must be"):
            kernel.function(bad, out=out)
        assert untouched(out)
        with pytest.raises(TypeError, match=f"{kernel.name}: {kernel.argument} must be"):
            kernel.function(bad)
    with pytest.raises(ValueError, match=f"{kernel.argument} must be .* rows of one length"):
        kernel.function([[1.0, 2.0], [3.0]])


@every_kernel
def test_outputs_that_do_not_fit(kernel: PrintedKernel) -> None:
    x = np.full(4, inside(kernel))
    good = outputs(kernel, (4,), "float64")
    read_only = np.full(4, -7.0)
    read_only.flags.writeable = False
    cases: list[tuple[type[Exception], str, Any]] = [
        (ValueError, "out must be a tuple", good[:-1]),
        (ValueError, "out must be a tuple", (*good, np.empty(4))),
        (ValueError, "out must be a tuple", np.empty((len(good), 4))),
        (TypeError, "must be an array", ([0.0] * 4, *good[1:])),
        (TypeError, "must be of type float64", (np.empty(4, np.float32), *good[1:])),
        (ValueError, "must have shape", (np.empty(5), *good[1:])),
        (ValueError, "must have shape", (np.empty((4, 1)), *good[1:])),
        (ValueError, "writable", (read_only, *good[1:])),
    ]
    if len(good) > 1:
        cases.append((ValueError, "share memory", (good[0], good[0], *good[2:])))
        long = np.full(5, -7.0)
        cases.append((ValueError, "share memory", (long[:4], long[1:], *good[2:])))
    for kind, message, out in cases:
        with pytest.raises(kind, match=message):
            kernel.function(x, out=out)
        assert untouched(good)
    assert untouched((read_only,))


@every_kernel
def test_outputs_are_a_keyword_and_ragged_lists_are_refused(kernel: PrintedKernel) -> None:
    x = inside(kernel)
    with pytest.raises(TypeError, match="positional"):
        kernel.function(x, outputs(kernel, (), "float64"))
    with pytest.raises((TypeError, ValueError)):
        kernel.function([[x], [x, x]])
