"""Kernels of the index promise every output from 1e-300 to 1e300 where it is a normal number."""

from __future__ import annotations

import dataclasses

import numpy as np
import pytest
from kernel_truth import STEADY_STATES, THREE_STATES
from printed_kernels import PrintedKernel, printed_kernels

KERNELS = [
    kernel
    for kernel in printed_kernels()
    if kernel.argument == "tracking_index" and kernel.family in {*STEADY_STATES, *THREE_STATES}
]
LEAST, MOST = 1e-300, 1e300


def short(kernel: PrintedKernel, output: str) -> list[float]:
    """Ends of the promised range within 1e-300 to 1e300 where the value is far from both."""
    promise = kernel.promises["float64"][output]
    ends = [promise.lowest] if promise.lowest > LEAST else []
    ends += [promise.highest] if promise.highest < MOST else []
    if not ends:
        return []
    values: list[float] = getattr(kernel.function(np.array(ends)), output).tolist()
    return [end for end, y in zip(ends, values, strict=True) if LEAST < abs(y) < MOST]


@pytest.mark.parametrize("kernel", KERNELS, ids=lambda kernel: kernel.id)
def test_it_ends_where_values_do(kernel: PrintedKernel) -> None:
    assert {output: ends for output in kernel.outputs if (ends := short(kernel, output))} == {}


def test_an_end_before_that_is_noticed() -> None:
    (kernel,) = (k for k in KERNELS if k.id == "random_jerk.gains")
    promise = kernel.promises["float64"]["alpha"]
    shorter = dataclasses.replace(promise, highest=1e154)
    promises = {"float64": {**kernel.promises["float64"], "alpha": shorter}}
    assert short(dataclasses.replace(kernel, promises=promises), "alpha") == [1e154]
