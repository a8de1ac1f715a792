"""Best-of-many times of several calls, taken in turn so that a slow moment hits all alike."""

from __future__ import annotations

import math
import time
from collections.abc import Callable, Collection, Mapping

ROUNDS = 15
LEAST = 2
FINE = 1e-6


def one_thread_clock() -> Callable[[], float]:
    """The processor time of this thread where it is told finely, else the time of the day's clock.

    For work of one thread both are the same on an idle machine. On a loaded one others' work lies
    between, which made ratios of wall times wrong by a factor of up to four.
    """
    try:
        fine = time.get_clock_info("thread_time").resolution <= FINE
    except ValueError:
        return time.perf_counter
    return time.thread_time if fine else time.perf_counter


def best_times(
    calls: Mapping[str, Callable[[], object]],
    rounds: int = ROUNDS,
    seconds: float = math.inf,
    threaded: Collection[str] = (),
) -> dict[str, float]:
    """Seconds of the best of `rounds` runs of each call, after one that does not count.

    Of calls named in `threaded`, which others work for, it is the time that passes, of all others
    that of `one_thread_clock`. A call during which `seconds` have passed in all, the first run
    included, stays out of further rounds once it has had `LEAST`: a slow one among fast ones would
    take nearly all of the time.
    """
    best = dict.fromkeys(calls, math.inf)
    spent = dict.fromkeys(calls, 0.0)
    one_thread = one_thread_clock()
    for number in range(rounds + 1):
        for name, call in calls.items():
            if number > LEAST and spent[name] >= seconds:
                continue
            clock = time.perf_counter if name in threaded else one_thread
            begun, start = time.perf_counter(), clock()
            call()
            taken = clock() - start
            spent[name] += time.perf_counter() - begun
            if number:
                best[name] = min(best[name], taken)
    return best
