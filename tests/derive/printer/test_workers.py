"""Threads that share the blocks of a kernel: the same results, refusals and silence as without."""

from __future__ import annotations

import signal
import threading
import time
import tracemalloc
import warnings
from _thread import start_new_thread
from collections.abc import Sequence
from functools import cache
from typing import Any

import numpy as np
import pytest
from graph_kernels import function_of, kernel_of, several_of

from gainproof.derive.printer.graph import GraphBuilder
from gainproof.derive.printer.shipped import _threads
from gainproof.derive.printer.shipped._blocks import BLOCK, Span

COUNT = 7 * BLOCK + 5
"""Elements of five blocks."""
WORKERS = (2, 3, 4, 9)


@cache
def pair() -> Any:
    """total = x + z z, share = sqrt(x)/z for x and z from 1e-9 to 1e9."""
    b = GraphBuilder()
    x, z = b.symbol("x"), b.symbol("z")
    graph = b.graph({"total": x + z * z, "share": b.sqrt(x) / z})
    return function_of(several_of(graph, "1e-9", "1e9", single=("1e-3", "1e3")))


@cache
def far() -> Any:
    """square = x x for every positive x: it over- and underflows."""
    b = GraphBuilder()
    x = b.symbol("x")
    return function_of(kernel_of(b.graph({"square": x * x})))


def drawn(kind: type[Any], seed: int = 1) -> tuple[Any, Any]:
    generator = np.random.default_rng(seed)
    x, z = generator.uniform(1, 9, (2, COUNT)).astype(kind)
    return x, z


def bits(found: Any) -> list[bytes]:
    return [np.asarray(each).tobytes() for each in found]


@pytest.mark.parametrize("kind", [np.float32, np.float64])
def test_results_are_the_same_bit_for_bit(kind: type[Any]) -> None:
    x, z = drawn(kind)
    wanted = bits(pair()(x, z))
    alone = bits(pair()(x, z[0]))
    turned = bits(pair()(x[::-1], z))
    for workers in WORKERS:
        assert bits(pair()(x, z, workers=workers)) == wanted
        assert bits(pair()(x, z[0], workers=workers)) == alone
        assert bits(pair()(x[::-1], z, workers=workers)) == turned
        out = (np.empty_like(x), np.empty((COUNT, 2), kind)[:, 1])
        found = pair()(x, z, out=out, workers=workers)
        assert found.total is out[0]
        assert bits(found) == wanted


@pytest.mark.parametrize("workers", WORKERS)
def test_an_output_may_take_the_place_of_an_input(workers: int) -> None:
    """Where it begins, or shifted by a few elements: then every thread would read what another has
    written.
    """
    x, z = drawn(np.float64)
    wanted = bits(pair()(x, z))
    for shift in (0, 3, BLOCK):
        whole = np.concatenate([x, np.ones(shift)])
        out = (whole[shift:], np.empty_like(x))
        assert bits(pair()(whole[:COUNT], z, out=out, workers=workers)) == wanted
    one = z.copy()
    wanted = bits(pair()(x, one[:1]))
    assert bits(pair()(x, one[:1], out=(one, np.empty_like(x)), workers=workers)) == wanted


@pytest.mark.parametrize("workers", WORKERS)
@pytest.mark.parametrize("given", [False, True])
def test_the_same_input_is_refused_and_no_output_touched(workers: int, given: bool) -> None:
    """The first block that holds one decides, and in it the first input."""
    for seed in range(4):
        generator = np.random.default_rng(seed)
        x, z = drawn(np.float64)
        places = np.sort(generator.integers(COUNT, size=4))
        for place in places:
            (x, z)[generator.integers(2)][place] = generator.choice([np.nan, np.inf, -1.0, 0.0])
        out = tuple(np.full(COUNT, -7.0) for _ in range(2)) if given else None
        with pytest.raises(ValueError, match=" at index ") as alone:
            pair()(x, z, out=out)
        with pytest.raises(ValueError, match=" at index ") as shared:
            pair()(x, z, out=out, workers=workers)
        assert str(shared.value) == str(alone.value)
        assert out is None or all((y == -7).all() for y in out)


def test_no_warning_escapes_a_thread() -> None:
    x = np.ones(COUNT)
    x[::1000], x[1::1000] = 1e-200, 1e200
    with warnings.catch_warnings(), np.errstate(all="raise"):
        warnings.simplefilter("error")
        (square,) = far()(x, workers=3)
    assert set(square) == {0.0, 1.0, np.inf}


def test_no_thread_is_started_for_one_block(monkeypatch: pytest.MonkeyPatch) -> None:
    x, z = drawn(np.float64)
    monkeypatch.setattr(_threads, "start_new_thread", None)
    for count in (0, 1, BLOCK):
        assert bits(pair()(x[:count], z[:count], workers=4)) == bits(pair()(x[:count], z[:count]))
    pair()(x, z, workers=np.int64(1))
    assert pair()(4.0, 2.0, workers=8) == (8, 1)
    with pytest.raises(TypeError):
        pair()(x, z, workers=2)


def test_an_interrupt_ends_the_call_and_its_threads() -> None:
    """It comes while the others are at work, which finish their shares first."""
    done: list[int] = []

    def job(share: Sequence[Span]) -> None:
        if share[0][0] == 0:
            raise KeyboardInterrupt
        time.sleep(0.05)
        done.append(share[0][0])

    with pytest.raises(KeyboardInterrupt):
        _threads.in_threads(job, [[(0, 1)], [(1, 2)], [(2, 3)]])
    assert sorted(done) == [1, 2]


@pytest.mark.skipif(not hasattr(signal, "pthread_kill"), reason="nothing interrupts a lock here")
@pytest.mark.parametrize("times", [1, 2, 3])
def test_however_many_interrupts_come_no_thread_is_left_at_work(times: int) -> None:
    """The second meets the waiting for the others, the third what the second has begun."""
    done: list[int] = []
    inside = [True]
    main = threading.get_ident()
    assert threading.main_thread().ident == main

    def job(share: Sequence[Span]) -> None:
        if share[0][0] == 1:
            for _ in range(times):
                time.sleep(0.03)
                # to this thread, as from a keyboard: a signal is what ends its waiting
                signal.pthread_kill(main, signal.SIGINT)
            time.sleep(0.03)
        if share[0][0]:
            done.append(share[0][0])

    def interrupt(*_: object) -> None:
        if inside:  # what comes too late would meet the tests' own process
            raise KeyboardInterrupt

    before = signal.signal(signal.SIGINT, interrupt)
    try:
        with pytest.raises(KeyboardInterrupt):
            _threads.in_threads(job, [[(0, 1)], [(1, 2)], [(2, 3)]])
        inside.clear()
        found = sorted(done)
        time.sleep(0.03 * (times + 2))
    finally:
        signal.signal(signal.SIGINT, before)
    assert found == [1, 2]


def test_what_has_started_is_waited_for_where_another_cannot_start(
    monkeypatch: pytest.MonkeyPatch,
) -> None:
    done: list[int] = []

    def job(share: Sequence[Span]) -> None:
        time.sleep(0.03)
        done.append(share[0][0])

    def start(function: Any, given: tuple[Any, ...]) -> int:
        if given[0] == 2:
            raise RuntimeError("can't start new thread")
        return start_new_thread(function, given)

    monkeypatch.setattr(_threads, "start_new_thread", start)
    with pytest.raises(RuntimeError, match="can't start"):
        _threads.in_threads(job, [[(0, 1)], [(1, 2)], [(2, 3)]])
    assert done == [1]


@pytest.mark.parametrize("workers", [0, -1, 1.5, "2", None])
def test_what_is_no_number_of_threads(workers: Any) -> None:
    with pytest.raises(ValueError, match="kernel: workers must be a whole number of threads, 1"):
        pair()(1.0, 1.0, workers=workers)


@pytest.mark.parametrize("workers", [1, 2])
def test_memory_beside_inputs_and_outputs_does_not_grow(workers: int) -> None:
    """Sixteen blocks: one buffer of a block for each thread, and what lists take."""

    def beside(size: int, given: bool) -> int:
        x, z = np.full((2, size), 2.0)
        out = tuple(np.empty((2, size))) if given else None
        pair()(x, z, out=out, workers=workers)
        tracemalloc.start()
        try:
            pair()(x, z, out=out, workers=workers)
            _, peak = tracemalloc.get_traced_memory()
        finally:
            tracemalloc.stop()
        return peak - (0 if given else 2 * x.nbytes)

    for given in (False, True):
        assert beside(24 * BLOCK, given) < workers * 12 * BLOCK + 50_000
