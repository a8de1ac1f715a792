"""Best-of-many times of several calls, taken in turn so that a slow moment hits all alike."""

from __future__ import annotations

from collections.abc import Callable, Mapping
from time import perf_counter

ROUNDS = 15


def best_times(calls: Mapping[str, Callable[[], object]], rounds: int = ROUNDS) -> dict[str, float]:
    """Seconds of the best of `rounds` runs of each call, after one that does not count."""
    best = {name: float("inf") for name in calls}
    for number in range(rounds + 1):
        for name, call in calls.items():
            start = perf_counter()
            call()
            taken = perf_counter() - start
            if number:
                best[name] = min(best[name], taken)
    return best
