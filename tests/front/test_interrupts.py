"""An interrupt breaks off what a loop waits for, and nothing in between."""

from __future__ import annotations

import asyncio
import signal
import threading
from collections.abc import Iterator
from types import FrameType
from typing import NoReturn

import pytest

from gainproof.jobs import interrupts


def raising(_number: int, _frame: FrameType | None) -> NoReturn:
    raise KeyboardInterrupt


@pytest.fixture(autouse=True)
def _handled() -> Iterator[None]:
    before = signal.signal(signal.SIGTERM, raising)
    yield
    signal.signal(signal.SIGTERM, before)


async def signalled(seen: list[str], times: int = 1) -> str:
    """Says where it was when the signals came and what came of them."""
    for _ in range(times):
        signal.raise_signal(signal.SIGTERM)
        seen.append("went on")
    try:
        await asyncio.sleep(600)
    except asyncio.CancelledError:
        seen.append("cancelled")
        await asyncio.sleep(0.001)
        seen.append("ended")
        raise
    return "unseen"


def test_work_is_cancelled_where_it_waits() -> None:
    seen: list[str] = []
    with pytest.raises(KeyboardInterrupt):
        interrupts.run(signalled(seen))
    assert seen == ["went on", "cancelled", "ended"]
    assert signal.getsignal(signal.SIGTERM) is raising


def test_a_second_signal_is_as_it_was_before() -> None:
    seen: list[str] = []
    with pytest.raises(KeyboardInterrupt):
        interrupts.run(signalled(seen, times=2))
    assert seen == ["went on"]


def test_a_signal_in_the_last_moment_is_not_lost() -> None:
    async def work() -> int:
        signal.raise_signal(signal.SIGTERM)
        return 1

    with pytest.raises(KeyboardInterrupt):
        interrupts.run(work())


def test_a_signal_that_comes_while_the_loop_is_made(monkeypatch: pytest.MonkeyPatch) -> None:
    make, seen = asyncio.new_event_loop, list[str]()

    def made() -> asyncio.AbstractEventLoop:
        signal.raise_signal(signal.SIGTERM)
        return make()

    async def work() -> None:
        await asyncio.sleep(0)
        seen.append("worked")

    monkeypatch.setattr(asyncio.events, "new_event_loop", made)
    with pytest.raises(KeyboardInterrupt):
        interrupts.run(work())
    assert seen == []


def test_ignored_signals_stay_ignored() -> None:
    async def work() -> int:
        signal.raise_signal(signal.SIGTERM)
        await asyncio.sleep(0)
        return 1

    signal.signal(signal.SIGTERM, signal.SIG_IGN)
    assert interrupts.run(work()) == 1
    assert signal.getsignal(signal.SIGTERM) is signal.SIG_IGN


def test_work_that_cancels_itself_is_no_interrupt() -> None:
    async def work() -> None:
        raise asyncio.CancelledError

    with pytest.raises(asyncio.CancelledError):
        interrupts.run(work())


def test_in_a_thread_signals_are_those_of_the_main_thread() -> None:
    found: list[int] = []

    async def work() -> int:
        assert signal.getsignal(signal.SIGTERM) is raising
        return 1

    thread = threading.Thread(target=lambda: found.append(interrupts.run(work())))
    thread.start()
    thread.join()
    assert found == [1]
