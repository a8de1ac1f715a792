"""Threads for one call of a kernel; imported only where they are asked for."""

from __future__ import annotations

from _thread import LockType, allocate_lock, start_new_thread
from collections.abc import Callable, Sequence

import numpy as np


def in_threads(job: Callable[[range], None], shares: Sequence[range]) -> None:
    """Do a job for every share at once, the first in this thread; raise what the first raised.

    An interrupt is raised when the other threads are done with their shares. They are waited for
    by plain locks: conditions, on which `threading` and `concurrent.futures` rest, may stay taken
    where an interrupt meets them, and then they are waited for without end.
    """
    raised: dict[int, Exception] = {}

    def do(place: int) -> None:
        try:
            # of what NumPy warns is each thread's own
            with np.errstate(all="ignore"):
                job(shares[place])
        except Exception as error:  # noqa: BLE001 (raised below, for the caller)
            raised[place] = error

    def do_and_tell(place: int, busy: LockType) -> None:
        try:
            do(place)
        finally:
            busy.release()

    others: list[LockType] = []
    try:
        for place in range(1, len(shares)):
            busy = allocate_lock()
            busy.acquire()
            start_new_thread(do_and_tell, (place, busy))
            others.append(busy)
        do(0)
    finally:
        for busy in others:
            busy.acquire()
    if raised:
        raise raised[min(raised)]
