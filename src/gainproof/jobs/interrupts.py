"""Interrupts while a loop of asyncio runs: its work is cancelled, at a place where it waits.

An exception raised by a signal's handler comes between any two instructions, inside of asyncio's
own too: there it left processes unasked and unended, and a loop that waited for ever.
"""

from __future__ import annotations

import asyncio
import signal
import threading
from collections.abc import Callable, Coroutine, Iterator
from contextlib import contextmanager
from types import FrameType
from typing import Any, TypeVar

from gainproof.ending_signals import SIGNALS

Result = TypeVar("Result")


def run(work: Coroutine[Any, Any, Result]) -> Result:
    """`asyncio.run`, in which each of the signals that somebody here handles cancels the work.

    Raises KeyboardInterrupt once the work has ended if one came, also if it came too late to cancel
    anything. A second one does what it would do without this. In a thread signals are not seen, and
    the main thread keeps what it does with them.
    """
    breaking_off = _BreakingOff()
    with _handled(breaking_off):
        try:
            result = asyncio.run(breaking_off.known(work))
        except asyncio.CancelledError:
            if breaking_off.asked:
                raise KeyboardInterrupt from None
            raise
    if breaking_off.asked:
        raise KeyboardInterrupt
    return result


@contextmanager
def held() -> Iterator[None]:
    """What comes here waits until the end, for processes that are started here too: these have to
    `release` it once they handle it, so that none breaks off the imports of a new interpreter.
    """
    if not hasattr(signal, "pthread_sigmask"):
        yield
        return
    from multiprocessing import resource_tracker

    # it is a process too, and as it is started it lets through what is held
    resource_tracker.ensure_running()
    before = signal.pthread_sigmask(signal.SIG_BLOCK, numbers())
    try:
        yield
    finally:
        signal.pthread_sigmask(signal.SIG_SETMASK, before)


def release() -> None:
    """Let through what was held when this process was started."""
    if hasattr(signal, "pthread_sigmask"):
        signal.pthread_sigmask(signal.SIG_UNBLOCK, numbers())


def numbers() -> list[int]:
    """Of the signals, those that there are here."""
    return [getattr(signal, name) for name in SIGNALS if hasattr(signal, name)]


@contextmanager
def _handled(breaking_off: _BreakingOff) -> Iterator[None]:
    """In the main thread the signals that are not ignored or left to the system are handed over."""
    found: dict[int, Callable[[int, FrameType | None], object]] = {}
    if threading.current_thread() is threading.main_thread():
        for number in numbers():
            before = signal.getsignal(number)
            if callable(before):
                found[number] = before
    try:
        for number, before in found.items():
            signal.signal(number, breaking_off.handler(before))
        yield
    finally:
        for number, before in found.items():
            signal.signal(number, before)


class _BreakingOff:
    """The work that is cancelled at the first signal."""

    def __init__(self) -> None:
        self.asked = False
        self._cancel: Callable[[], object] | None = None

    async def known(self, work: Coroutine[Any, Any, Result]) -> Result:
        """The work, from now on to be cancelled. What was asked for before comes at once."""
        task, loop = asyncio.current_task(), asyncio.get_running_loop()
        assert task is not None
        self._cancel = lambda: loop.call_soon_threadsafe(task.cancel)
        if self.asked:
            task.cancel()
        return await work

    def handler(
        self, before: Callable[[int, FrameType | None], object]
    ) -> Callable[[int, FrameType | None], object]:
        """Cancels the work at the first signal, and is what was `before` at others."""

        def handle(number: int, frame: FrameType | None) -> None:
            if self.asked:
                before(number, frame)
            self.asked = True
            if self._cancel is not None:
                self._cancel()

        return handle
