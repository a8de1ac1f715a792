"""Every output of every printed kernel against a ball round the Riccati solution.

The ball comes from the model's matrices, not from any formula of ours; the bound that is held
against the measured error is the one that the kernel's docstring states.
"""

from __future__ import annotations

import dataclasses
import math
from collections.abc import Callable
from fractions import Fraction
from functools import partial
from itertools import product
from typing import Any

import numpy as np
import pytest
from hypothesis import given, settings
from hypothesis import strategies as st
from kernel_errors import broken_promises, log_uniform, measure, near_supremum
from kernel_truth import truth_at
from one_of_each import cases
from printed_kernels import DTYPES, PrintedKernel, common_domain, groups, printed_kernels, promise
from samples import samples

GROUPS = groups(printed_kernels())
CASES = [
    pytest.param(
        *(*key, dtype),
        id=f"{'-'.join(key)}-{dtype}",
        marks=[] if dtype == "float64" or "random_velocity" in key else pytest.mark.thorough,
    )
    for key in GROUPS
    for dtype in DTYPES
]
ONE_OF_EACH = {
    "random_velocity",
    "random_acceleration",
    "acceleration_increments",
    "random_jerk",
    "least_squares_line",
    "recursion_two_states",
    "alpha_beta",
    "updated_gains",
    "interacting_gains",
    "multipath_location",
    "position_velocity_random_velocity",
}
"""Families of printed kernels: one of each kind of derivation."""
# where a pole turns real, a centre changes sign, and their neighbours
THREE_STATES = (
    "acceleration_increments",
    "wiener_acceleration",
    "random_jerk",
    "continuous_white_jerk",
)
SLOWLY_KNOWN = {"alpha_beta", "recursion_two_states", "updated_gains"}
"""Whose truth takes a hundredth of a second at each place."""
SPECIAL = [
    x for y in (4.0, 24**0.5, 8.0, 12.0) for x in (y, np.nextafter(y, 0), np.nextafter(y, 99))
]


def places(argument: str, low: float, high: float) -> st.SearchStrategy[float]:
    """Arguments between ``low`` and ``high``, spread over all orders and dense where it matters."""
    if argument == "sample_number":
        small = st.integers(int(low), int(low) + 60)
        return st.one_of(small, st.integers(int(low), int(high))).map(float)
    # log2 of the largest float64 rounds to 1024, whose power is no float
    exponents = st.floats(math.log2(low), min(math.log2(high), 1023.999999))
    spread = exponents.map(lambda e: math.ldexp(2.0 ** (e - math.floor(e)), math.floor(e)))
    if argument == "tracking_index":
        return st.one_of(spread, st.floats(1e-6, 1e6), st.sampled_from([*SPECIAL, low, high]))
    gaps = st.floats(-54, -1).map(lambda e: high * (1 - 2.0**e))
    return st.one_of(spread, gaps, st.sampled_from([low, high]))


@pytest.mark.parametrize(("family", "argument", "dtype"), CASES)
@settings(max_examples=samples(3), deadline=None)
@given(data=st.data())
def test_error_is_within_the_stated_bound(
    family: str, argument: str, dtype: str, data: st.DataObject
) -> None:
    kernels = GROUPS[family, argument]
    low, high = common_domain(kernels, dtype)
    points = data.draw(st.lists(places(argument, low, high), min_size=1, max_size=8))
    assert not broken_promises(kernels, dtype, measure(kernels, dtype, points))


@pytest.mark.sampled
@pytest.mark.parametrize(
    ("family", "argument", "dtype"),
    cases(
        [(*key, dtype) for key, dtype in product(GROUPS, DTYPES)],
        lambda case: case[0] in ONE_OF_EACH and ("float64" in case or "random_velocity" in case),
    ),
)
def test_error_is_within_the_stated_bound_over_the_whole_domain(
    family: str, argument: str, dtype: str
) -> None:
    kernels = GROUPS[family, argument]
    low, high = common_domain(kernels, dtype)
    usual = 15 if dtype == "float64" else 30  # of which fewer lie in the range of an output
    few = samples(10 if family in SLOWLY_KNOWN else usual)
    points = log_uniform(low, high, few, seed=1)
    if argument == "tracking_index":
        points += log_uniform(1e-6, 1e6, samples(10), seed=2) + SPECIAL
    elif argument == "sample_number":
        points = [*map(round, points), *range(int(low), 60)]
    else:
        points += near_supremum(high, few, seed=3)
    points += edges(kernels, dtype)
    table = measure(kernels, dtype, points)
    assert not broken_promises(kernels, dtype, table)
    for (name, output), worst in table.items():
        assert worst.points > 20, f"{name}.{output}: hardly any point lies in its range"


def edges(kernels: list[PrintedKernel], dtype: str) -> list[float]:
    """Both ends of every output's range, and the numbers just outside."""
    kind = np.dtype(dtype).type
    found = []
    for kernel in kernels:
        for stated in kernel.promises[dtype].values():
            with np.errstate(all="ignore"):  # a neighbour may be subnormal or infinite
                below = np.nextafter(kind(stated.lowest), kind(0))
                above = np.nextafter(kind(stated.highest), kind(math.inf))
            found += [stated.lowest, stated.highest]
            if not kernel.whole:
                found += [float(below), float(above)]
    return found


@pytest.mark.parametrize(
    ("kernel", "dtype"),
    cases(
        product(printed_kernels(), DTYPES),
        lambda case: (
            case[0].family in ONE_OF_EACH
            and (case[1] == "float64" or case[0].family == "random_velocity")
        ),
    ),
    ids=lambda given_: getattr(given_, "id", given_),
)
def test_an_error_just_above_the_bound_is_noticed(kernel: PrintedKernel, dtype: str) -> None:
    low, high = kernel.domain[dtype]
    point = low + 7 if kernel.whole else min(max(0.6, 2 * low), high)
    if kernel.by_terms:
        point = 3.0  # where the difference is not small
    assert not broken_promises([kernel], dtype, measure([kernel], dtype, [point]))
    for output in kernel.outputs:
        # an honest error of up to one bound cannot hide an added one of more than two
        times = 3
        if output in kernel.by_terms:
            true = truth_at(kernel.family, kernel.argument, point)[kernel.truth_name(output)]
            times *= math.ceil(abs(float(true.scale / true.value)))
        factor = 1 + times * kernel.promises[dtype][output].error(dtype)
        spoiled = altered(kernel, output, partial(multiplied, factor), dtype)
        found = broken_promises([spoiled], dtype, measure([spoiled], dtype, [point]))
        assert len(found) == 1, output
        assert f".{output} " in found[0]


@pytest.mark.parametrize("wrong", [math.nan, math.inf, 0.0])
def test_a_value_that_is_none_is_noticed(wrong: float) -> None:
    kernels = GROUPS["random_acceleration", "tracking_index"]
    for kernel in kernels:
        if kernel.name != "closed_loop_poles":
            spoiled = altered(kernel, kernel.outputs[-1], lambda _: wrong, "float64")
            assert broken_promises([spoiled], "float64", measure([spoiled], "float64", [2.0]))


def test_nan_outside_the_range_is_noticed() -> None:
    (kernel,) = (k for k in GROUPS["random_velocity", "tracking_index"] if k.name == "gains")
    spoiled = altered(kernel, "beta", lambda _: math.nan, "float64")
    with pytest.raises(AssertionError, match="outside the promised range"):
        measure([spoiled], "float64", [5e-324])


def multiplied(factor: Fraction, x: float) -> Fraction:
    return Fraction(x) * factor


def altered(
    kernel: PrintedKernel, output: str, change: Callable[[float], Any], dtype: str
) -> PrintedKernel:
    """The kernel with every value of one output changed."""
    place = kernel.outputs.index(output)

    def function(x: Any) -> list[Any]:
        columns = list(kernel.function(x))
        columns[place] = np.array([float(change(float(y))) for y in columns[place]], dtype)
        return columns

    return dataclasses.replace(kernel, function=function)


def test_every_promise_is_read_and_a_missing_one_is_an_error() -> None:
    for kernel in printed_kernels():
        for dtype in DTYPES:
            for output in kernel.outputs:
                read = kernel.promises[dtype][output]
                low, high = kernel.domain[dtype]
                assert 0 < read.bound < 100
                assert low <= read.lowest < read.highest <= high
    text = "Title. alpha: gain. beta: gain. Relative error at most 2.00 * 2^-52 (float64)."
    with pytest.raises(LookupError):
        promise(text, "gamma", "float64")
    with pytest.raises(LookupError):
        promise(text, "beta", "float64")


def most_of(kernel: PrintedKernel) -> int | None:
    """What the bound of a derivative may be; None where nothing but the stated bound is promised.

    Second ones, and those over a root that is iterated, have more operations than first ones in
    closed form. Of three states no more is promised than of the first derivatives of gains and
    predicted covariances.
    """
    second = "second" in kernel.name
    if not kernel.id.startswith(THREE_STATES):
        return 20 if second else 16
    return None if second or kernel.name == "updated_covariance_derivatives" else 20


def test_bounds_keep_what_the_project_promises() -> None:
    for kernel in printed_kernels():
        for dtype in DTYPES:
            for output, read in kernel.promises[dtype].items():
                if kernel.name in {"gains", "predictor_gains"}:
                    assert read.bound <= 8, f"{kernel.id}.{output}"
                if kernel.name.endswith("derivatives"):
                    most = most_of(kernel)
                    assert most is None or read.bound <= most, f"{kernel.id}.{output}"
                if kernel.name == "gains" and dtype == "float64" and not kernel.whole:
                    assert read.lowest <= 1e-300
                    assert read.highest >= 1e300
