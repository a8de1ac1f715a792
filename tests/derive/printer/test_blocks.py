"""Inputs of any shape and layout give what they would give written out in full."""

from __future__ import annotations

import math
import tracemalloc
from functools import cache
from typing import Any

import numpy as np
import pytest
from graph_kernels import function_of, several_of
from hypothesis import given, settings
from hypothesis import strategies as st
from numpy.typing import NDArray
from samples import samples

from gainproof.derive.printer.graph import GraphBuilder
from gainproof.derive.printer.shipped import _runtime
from gainproof.derive.printer.shipped._blocks import FEW, Parts, cut, rows
from gainproof.generated import range_doppler
from gainproof.generated._blocks import BLOCK

Reals = NDArray[np.float64]
LENGTHS = (1, 2, 7, 24, 1000)


@cache
def pair() -> Any:
    """total = x + z z, share = sqrt(x)/z."""
    b = GraphBuilder()
    x, z = b.symbol("x"), b.symbol("z")
    graph = b.graph({"total": x + z * z, "share": b.sqrt(x) / z})
    return function_of(several_of(graph, "1e-9", "1e9"))


@st.composite
def layouts(draw: st.DrawFn, shape: tuple[int, ...]) -> Reals:
    """An array that broadcasts to the shape, its numbers unlike, in some order in memory."""
    kept = draw(st.integers(0, len(shape)))
    own = tuple(draw(st.sampled_from([1, n])) for n in shape[len(shape) - kept :])
    wide = tuple(2 * n for n in own)
    order = draw(st.permutations(range(len(own))))
    turned = [wide[axis] for axis in order]
    numbers = 1 + np.arange(math.prod(wide), dtype=float).reshape(turned)
    steps = [
        draw(st.sampled_from([slice(None, None, 2), slice(1, n + 1), slice(None, n)])) for n in own
    ]
    x: Reals = numbers.transpose(np.argsort(order))[tuple(steps)]
    if draw(st.booleans()):
        x = x.copy()
    if draw(st.booleans()):
        x = np.broadcast_to(x, shape)
    return x[::-1] if x.ndim and draw(st.booleans()) else x


SHAPES = st.lists(st.integers(0, FEW + 2), max_size=4).map(tuple)


@settings(max_examples=samples(100), deadline=None)
@given(data=st.data(), shape=SHAPES, length=st.sampled_from(LENGTHS))
def test_every_block_has_what_broadcasting_gives(
    data: st.DataObject, shape: tuple[int, ...], length: int
) -> None:
    inputs = [data.draw(layouts(shape)) for _ in range(3)]
    result = np.empty((*shape, 2))[..., 0] if data.draw(st.booleans()) else np.empty(shape)
    blocks = cut(inputs, shape, length, results=[result])
    ends = [0, *(stop for _, stop in blocks.spans)]
    assert [start for start, _ in blocks.spans] == ends[:-1]
    assert ends[-1] == math.prod(shape)
    assert all(0 < stop - start <= length for start, stop in blocks.spans)
    parts = Parts(blocks)
    spans = blocks.spans if data.draw(st.booleans()) else blocks.spans[::-1]
    for start, stop in spans:
        for x, found in zip(inputs, parts.all(start, stop), strict=True):
            expected = np.broadcast_to(x, shape).reshape(-1)[start:stop]
            assert found.shape in {(1,), expected.shape}
            assert np.array_equal(np.broadcast_to(found, expected.shape), expected)


@st.composite
def results(draw: st.DrawFn, shape: tuple[int, ...]) -> Reals:
    """An array of that shape to be filled, in some order in memory."""
    order = draw(st.permutations(range(len(shape))))
    made = np.full([shape[axis] for axis in order], -7.0).transpose(np.argsort(order))
    return made if draw(st.booleans()) else np.repeat(made[..., None], 2, -1)[..., 1]


@settings(max_examples=samples(50), deadline=None)
@given(data=st.data(), shape=SHAPES, length=st.sampled_from(LENGTHS), workers=st.integers(1, 3))
def test_calls_give_what_numpy_gives(
    data: st.DataObject, shape: tuple[int, ...], length: int, workers: int
) -> None:
    x, z = (data.draw(layouts(shape)) for _ in range(2))
    out = tuple(data.draw(results(np.broadcast_shapes(x.shape, z.shape))) for _ in range(2))
    with pytest.MonkeyPatch.context() as patch:
        patch.setattr(_runtime, "BLOCK", length)
        fresh = pair()(x, z, workers=workers)
        pair()(x, z, out=out, workers=workers)
    for found in (fresh, out):
        for mine, reference in zip(found, (x + z * z, np.sqrt(x) / z), strict=True):
            assert np.array_equal(mine, reference)


@settings(max_examples=samples(50), deadline=None)
@given(data=st.data(), length=st.sampled_from(LENGTHS), workers=st.integers(1, 3))
def test_the_first_wrong_element_is_told_by_its_own_place(
    data: st.DataObject, length: int, workers: int
) -> None:
    """One of either input, in arrays that are the same along one axis each, or in full."""
    x, z = np.ones(data.draw(st.sampled_from([(5, 1), (5, 9), (1, 9)]))), np.ones((5, 9))
    places = {}
    for name, each in (("x", x), ("z", z)):
        place = tuple(data.draw(st.integers(0, n - 1)) for n in each.shape)
        each[place] = data.draw(st.sampled_from([1.0, np.nan, 0.0]))
        if each[place] != 1:
            places[name] = place
    if data.draw(st.booleans()):
        x = np.asfortranarray(x)
    out = tuple(np.full((5, 9), -7.0) for _ in range(2))
    with pytest.MonkeyPatch.context() as patch:
        patch.setattr(_runtime, "BLOCK", length)
        for options in ({}, {"out": out}):
            told = None
            try:
                pair()(x, z, workers=workers, **options)
            except ValueError as error:
                told = str(error)
            if not places:
                assert told is None
            else:
                assert told is not None
                name = told.split()[1]
                assert told.endswith(f"at index {places[name]}")
    assert places or ((out[0] == 2).all() and (out[1] == 1).all())
    assert not places or all((y == -7).all() for y in out)


@pytest.mark.parametrize("shape", [((4, 1), (3,)), ((4,), (3, 1))])
def test_an_output_may_share_memory_with_a_smaller_input(
    shape: tuple[tuple[int, ...], tuple[int, ...]],
) -> None:
    together = np.broadcast_shapes(*shape)
    z = 1.0 + np.arange(math.prod(shape[1])).reshape(shape[1])
    expected = None
    for shift in range(9):
        pool = 2.0 + np.arange(24.0)
        x = pool[shift : shift + 4].reshape(shape[0])
        x[...] = [[5], [6], [7], [8]] if x.ndim == 2 else [5, 6, 7, 8]
        total = pool[4 : 4 + math.prod(together)].reshape(together)
        expected = x + z * z
        pair()(x, z, out=(total, np.empty(together)))
        assert np.array_equal(total, expected)


@pytest.mark.parametrize("shape", [(3, 4), (3, 3)])
def test_an_output_may_be_an_input_read_in_another_order(shape: tuple[int, int]) -> None:
    pool = np.arange(1.0, 1 + math.prod(shape))
    x, total = pool.reshape(shape[::-1]).T, pool.reshape(shape)
    expected = x + 1
    with pytest.MonkeyPatch.context() as patch:
        patch.setattr(_runtime, "BLOCK", shape[1])
        pair()(x, 1.0, out=(total, np.empty(shape)))
    assert np.array_equal(total, expected)


@pytest.mark.parametrize("kind", [np.float64, np.float32])
@pytest.mark.parametrize("length", [1, 7, 16, 1000])
def test_buffers_begin_at_lines_of_the_cache(kind: Any, length: int) -> None:
    buffers = rows(5, length, np.dtype(kind))
    assert [(y.shape, y.dtype, y.ctypes.data % 64) for y in buffers] == [((length,), kind, 0)] * 5
    for number, y in enumerate(buffers):
        y[:] = number
    assert all((y == number).all() for number, y in enumerate(buffers))


@pytest.mark.parametrize("kind", [np.float64, np.float32])
@pytest.mark.parametrize("shift", [0, 1, 3, 7, 8, 15])
def test_blocks_begin_at_lines_of_the_cache(kind: Any, shift: int) -> None:
    """All but the first, in the first of the results; a call of one block is not cut in two."""
    pool = np.empty(1100, kind)
    x = np.ones(1000, kind)
    result = pool[shift : shift + 1000]
    for length in (100, 128, 999):
        (first, *others) = cut([x], x.shape, length, results=[result]).spans
        assert first[0] == 0
        assert length - 16 < first[1] <= length
        assert others
        assert all(result[start:].ctypes.data % 64 == 0 for start, _ in others if length == 128)
        assert result[others[0][0] :].ctypes.data % 64 == 0
    assert cut([x], x.shape, 1000, results=[result]).spans == [(0, 1000)]


def test_of_nothing_nothing_is_asked() -> None:
    for none in ((0,), (3, 0, 2)):
        assert pair()(np.nan, np.ones(none)).total.shape == none
        assert pair()(np.full((2, 1), np.nan), np.ones((1, 0))).share.shape == (2, 0)


@pytest.mark.parametrize("each_its_own", [False, True])
def test_no_input_is_written_out(each_its_own: bool) -> None:
    """Beside given outputs a call takes a few blocks; one array in full would take more."""
    count, stations = 400_000, 3
    states = np.ones((count, 6)) + np.arange(count)[:, None]
    sites = -np.ones((stations, 6)) * np.arange(1, 1 + stations)[:, None]
    out: Any = tuple(np.empty((count, stations)) for _ in range(8))
    targets = [states[:, None, axis] for axis in range(6)]
    if each_its_own:
        sites = np.repeat(sites[None], count, 0)[:, ::-1]
    tracemalloc.start()
    range_doppler.range_doppler(*targets, *(sites[..., axis] for axis in range(6)), out=out)
    _, most = tracemalloc.get_traced_memory()
    tracemalloc.stop()
    # work, what is spread, and what the guards take
    assert most < 8 * BLOCK * (9 + 12 + 4) < 2 * out[0].nbytes
    sites = sites.reshape(-1, stations, 6)[0]
    alone = range_doppler.range_doppler(*states[7], *sites[2])
    assert [y[7, 2] for y in out] == list(alone)


@pytest.mark.parametrize("far", [0, 1, 399])
@pytest.mark.parametrize("first", [True, False])
def test_points_that_meet_are_found_on_a_grid(far: int, first: bool) -> None:
    """Of stations and targets as rows and columns; where they stand along x at one place all of
    the distance is asked for.
    """
    targets = np.ones((400, 6)) * np.arange(1.0, 401)[:, None]
    stations = np.ones((3, 6)) * np.array([[-1.0], [-2.0], [-3.0]])
    stations[1] = targets[far]
    stations[2, 0] = targets[0, 0]
    rows, columns = (targets, stations) if first else (stations, targets)
    one, other = rows.T[:, :, None], columns.T[:, None, :]
    place = (far, 1) if first else (1, far)
    out: Any = tuple(np.full((len(rows), len(columns)), -7.0) for _ in range(8))
    given_ = (*one, *other) if first else (*other, *one)
    with pytest.raises(
        ValueError, match=rf"distance .* got 0.0 at index \({place[0]}, {place[1]}\)$"
    ):
        range_doppler.range_doppler(*given_, out=out)
    assert all((y == -7).all() for y in out)
    stations[1] = -2.0
    range_doppler.range_doppler(*given_, out=out)
    assert out[0][(0, 2) if first else (2, 0)] == np.hypot(4.0, 4.0)
