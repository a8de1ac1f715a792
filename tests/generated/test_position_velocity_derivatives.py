"""Kernels of partial derivatives against differences of the doubling, which has no formula.

The tolerance is the bound that the docstring states, over the scale that it names; a scale is read
from the certificate's graph.
"""

from __future__ import annotations

import dataclasses
from collections.abc import Iterator
from fractions import Fraction

import numpy as np
import pytest
from graph_kernels import balls
from hypothesis import example, given, settings
from hypothesis import strategies as st
from one_of_each import cases
from position_velocity_slopes import slopes
from printed_kernels import DTYPES, EPSILON
from printed_pairs import PrintedPair, printed_pairs
from samples import samples

KERNELS = tuple(kernel for kernel in printed_pairs() if "_by_" in kernel.name)
NOISES = {
    "position_velocity": "continuous_white_acceleration",
    "position_velocity_random_acceleration": "random_acceleration",
    "position_velocity_random_velocity": "random_velocity",
}
CHANGING = {
    "gains_by_tracking_index": {"gain_12", "gain_21"},
    "gains_by_velocity_ratio": {"gain_12"},
    "updated_covariance_by_tracking_index": {"updated_12"},
}
Point = tuple[float, float]
ROOM = Fraction(1, 10**20)  # of the differences, over the scale


def broken(kernel: PrintedPair, noise: str, point: Point, dtype: str) -> Iterator[str]:
    """What is further from the derivative than the docstring allows, in words."""
    kind = np.dtype(dtype).type
    index, ratio = (Fraction(float(kind(x))) for x in point)
    reference = slopes(noise, index, ratio, kernel.name.partition("_by_")[2])
    inputs = dict(zip(kernel.arguments, (float(index), float(ratio)), strict=True))
    enclosed = balls(kernel.graph, inputs)
    columns = kernel.function(*(kind(x) for x in point))
    for (output, said), value in zip(kernel.outputs.items(), columns, strict=True):
        scale = abs(Fraction(float(enclosed[said.scale].mid())))
        allowed = said.bound[dtype] * EPSILON[dtype] + ROOM
        if not abs(Fraction(float(value)) - reference[output]) <= allowed * scale:
            yield f"{kernel.id}.{output} ({dtype}) at {point}"


@pytest.mark.parametrize("family", cases(NOISES, lambda family: family == "position_velocity"))
@settings(max_examples=samples(3), deadline=None)
@given(st.floats(-3, 3), st.floats(-3, 3))
@example(-1.2, -1.2)
@example(0.0, 3.0)
def test_kernels_give_the_derivatives(family: str, first: float, second: float) -> None:
    point = float(np.float32(10.0**first)), float(np.float32(10.0**second))
    kernels = [kernel for kernel in KERNELS if kernel.family == family]
    assert len(kernels) == 6
    for kernel in kernels:
        for dtype in DTYPES:
            assert not list(broken(kernel, NOISES[family], point, dtype))


def test_another_noise_is_noticed() -> None:
    for kernel in KERNELS:
        for family, noise in NOISES.items():
            found = list(broken(kernel, noise, (2.0, 0.5), "float64"))
            assert bool(found) == (family != kernel.family)


@pytest.mark.parametrize("dtype", cases(DTYPES, lambda dtype: dtype == "float64"))
def test_an_error_just_above_the_bound_is_noticed(dtype: str) -> None:
    """An honest error of up to one bound cannot hide an added one of more than two."""
    for kernel in KERNELS:
        most = max(float(said.bound[dtype] * EPSILON[dtype]) for said in kernel.outputs.values())
        spoiled = dataclasses.replace(
            kernel,
            function=lambda *given, k=kernel, f=1 + 3 * most: [
                (column.astype(float) * f).astype(dtype) for column in k.function(*given)
            ],
        )
        found = list(broken(spoiled, NOISES[kernel.family], (3.0, 0.25), dtype))
        steady = [name for name, said in kernel.outputs.items() if said.scale == name]
        assert len(found) >= len(steady)


@pytest.mark.parametrize("kernel", KERNELS, ids=lambda kernel: kernel.id)
def test_what_each_kernel_promises(kernel: PrintedPair) -> None:
    changing = {name for name, said in kernel.outputs.items() if said.scale != name}
    assert changing == CHANGING.get(kernel.name, set())
    for low, high in kernel.domain["float64"]:
        assert low <= 1e-30
        assert high >= 1e30
    for low, high in kernel.domain["float32"]:
        assert low <= 1.0001e-4
        assert high >= 1e4
    for said in kernel.outputs.values():
        assert all(bound <= 90 for bound in said.bound.values())


@pytest.mark.parametrize("kernel", KERNELS, ids=lambda kernel: kernel.id)
def test_a_scale_is_larger_than_its_output(kernel: PrintedPair) -> None:
    for point in ((1e-3, 1e-3), (1.0, 1.0), (1e3, 1e-3), (1e-3, 1e3)):
        enclosed = balls(kernel.graph, dict(zip(kernel.arguments, point, strict=True)))
        for output, said in kernel.outputs.items():
            if said.scale != output:
                assert abs(enclosed[output]) < enclosed[said.scale]
