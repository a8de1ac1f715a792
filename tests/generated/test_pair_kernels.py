"""Kernels of several inputs against their own graphs in balls, and what finds them wrong.

The graph is that of the certificate; whether it is right is another question, with other tests.
"""

from __future__ import annotations

import dataclasses
from itertools import product
from typing import Any

import numpy as np
import pytest
from graph_kernels import module_of, several_of
from one_of_each import cases
from printed_kernels import DTYPES
from printed_pairs import (
    PrintedPair,
    broken_pairs,
    measure_pairs,
    pair_of,
    points_in,
    printed_pairs,
    stated,
)

from gainproof.derive.printer.graph import GraphBuilder

KERNELS = printed_pairs()


def made() -> PrintedPair:
    """A kernel printed here, so that the measurement itself is tested on any day."""
    b = GraphBuilder()
    x, z = b.symbol("x"), b.symbol("z")
    root = b.sqrt(x * x + z)
    gap = root - z
    graph = b.graph({"y": root / z, "w": gap, "_s": root + z}, {"gap": gap})
    kernel = several_of(graph, "1e-9", "1e9", {"w": "_s"}, {"gap": "a test"}, ("1e-5", "1e5"))
    space = module_of(kernel)
    return pair_of("made", space["kernel"], space["_KERNEL"], graph)


def test_a_docstring_is_read() -> None:
    kernel = made()
    assert kernel.arguments == ("x", "z")
    assert kernel.domain["float64"] == ((1e-9, 1e9), (1e-9, 1e9))
    assert kernel.domain["float32"] == ((float(np.float32(1e-5)), 1e5),) * 2
    assert (kernel.outputs["y"].scale, kernel.outputs["w"].scale) == ("y", "_s")
    assert 1.5 < kernel.outputs["y"].bound["float64"] < 2
    with pytest.raises(LookupError, match="no bound for every input is stated for v"):
        stated("Title. v: value. Relative error at most 2.00 * 2^-52 (float64).", "v")


ALL = [made(), *KERNELS]
SPANS = ["domain", "grid", "near"]
"""By default of every other kernel the first, of the rest the second."""


@pytest.mark.alike
@pytest.mark.parametrize(
    ("kernel", "span", "dtype"),
    cases(
        product(ALL, SPANS, DTYPES),
        lambda case: (
            case[1] == SPANS[ALL.index(case[0]) % 2]
            and (case[2] == "float64" or case[0] in ALL[::4])
        ),
    ),
    ids=lambda part: getattr(part, "id", part),
)
def test_error_is_within_the_stated_bound(kernel: PrintedPair, span: str, dtype: str) -> None:
    points = points_in(kernel, dtype, span, 60, 1)
    assert points.shape[1] > 40
    assert not broken_pairs([kernel], dtype, measure_pairs([kernel], dtype, lambda _: points))


@pytest.mark.alike
@pytest.mark.parametrize("dtype", DTYPES)
@pytest.mark.parametrize("wrong", [np.nan, np.inf, 0.0])
def test_what_is_wrong_is_noticed(dtype: str, wrong: float) -> None:
    kernel = made()
    eps = float(np.finfo(dtype).eps)
    for change in (lambda y: y * 0 + wrong, lambda y: y * (1 + 8 * eps)):
        spoiled = dataclasses.replace(kernel, function=lambda *xs, c=change: altered(kernel, c, xs))
        points = points_in(kernel, dtype, "near", 20, 1)
        table = measure_pairs([spoiled], dtype, lambda _, p=points: p)
        (found,) = broken_pairs([spoiled], dtype, table)
        assert found.startswith(f"kernel.y ({dtype})")


def altered(kernel: PrintedPair, change: Any, given: Any) -> list[Any]:
    columns = list(kernel.function(*given))
    columns[0] = change(columns[0])
    return columns
