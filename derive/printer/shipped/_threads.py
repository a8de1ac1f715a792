"""Threads for one call of a kernel; imported only where they are asked for."""

from __future__ import annotations

from _thread import LockType, allocate_lock, start_new_thread
from collections.abc import Callable, Sequence
from itertools import repeat
from typing import TYPE_CHECKING

import numpy as np

if TYPE_CHECKING:
    from gainproof.derive.printer.shipped._blocks import Span


def in_threads(job: Callable[[Sequence[Span]], None], shares: Sequence[Sequence[Span]]) -> None:
    """Do a job for every share at once, the first in this thread; raise what the first raised.

    An interrupt is raised when the other threads are done with their shares, however many come
    meanwhile: what they write belongs to the caller again as soon as this returns. They are waited
    for by plain locks: conditions, on which `threading` and `concurrent.futures` rest, may stay
    taken where an interrupt meets them, and then they are waited for without end.
    """
    raised: dict[int, Exception] = {}
    done: set[int] = set()
    busy = [allocate_lock() for _ in shares[1:]]

    def do(place: int) -> None:
        try:
            # of what NumPy warns is each thread's own
            with np.errstate(all="ignore"):
                job(shares[place])
        except Exception as error:  # noqa: BLE001 (raised below, for the caller)
            raised[place] = error

    def do_and_tell(place: int) -> None:
        try:
            do(place)
        finally:
            done.add(place)
            busy[place - 1].release()

    for lock in busy:
        lock.acquire()
    started: list[int] = []
    try:
        # one call: an interrupt comes before it or after it, so that every thread that was started
        # is counted, and no other
        places = [(place,) for place in range(1, len(shares))]
        started.extend(map(start_new_thread, repeat(do_and_tell), places))
        do(0)
    finally:
        _wait(done, busy[: len(started)])
    if raised:
        raise raised[min(raised)]


def _wait(done: set[int], busy: Sequence[LockType]) -> None:
    """Until the threads that hold these locks are done; raise the last interrupt met meanwhile.

    A lock may be taken already when an interrupt ends its `acquire`: it is `done` that tells, and
    it is written before the lock is given back.
    """
    met: BaseException | None = None
    waiting = True
    while waiting:
        try:
            for place, lock in enumerate(busy, 1):
                while place not in done:
                    lock.acquire()
            waiting = False
        except BaseException as error:  # noqa: BLE001 (raised below)
            met = error
    if met is not None:
        try:
            raise met
        finally:
            del met  # it holds this frame, which would hold it
