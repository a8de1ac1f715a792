"""Roots of increasing functions by bracketing, many at once, down to neighbouring floats.

Positive floats are ordered like their bit patterns read as integers. Halving the integer distance
halves, nearly, the distance of the logarithms, and ends at two neighbours after at most 63 steps,
whatever the function: that is the safeguard. A step of its own, where the caller knows a good
one, makes it fast.
"""

from __future__ import annotations

from collections.abc import Callable
from typing import TypeAlias

import numpy as np
from numpy.typing import NDArray

Reals: TypeAlias = NDArray[np.float64]
Places: TypeAlias = NDArray[np.intp]
Point: TypeAlias = tuple[Reals, Reals]

# rounds in which a suggestion is always taken; from then on every other round halves
FREE_ROUNDS = 8
# the free rounds, and two for each of the 63 halvings that part any two positive floats
MOST_ROUNDS = FREE_ROUNDS + 2 * 64


def increasing_root(
    value_at: Callable[[Reals, Places], Reals],
    wanted: Reals,
    low: float,
    high: float,
    start: Reals,
    enough: float,
    suggest: Callable[[Point, Point, Places], Reals],
) -> Reals:
    """An x for each wanted value: computed value within ``enough`` of it, or next to the step.

    ``value_at(x, places)`` computes the function for the elements at ``places`` of the flat
    arrays; ``suggest(last, before, places)`` says where to try next, given the two points
    (x, value) that were tried last, the earlier one NaN in the first round; ``start`` is tried
    first. ``low`` and ``high`` are normal positive floats with computed values below and not
    below the wanted ones, which is taken on trust. What is returned satisfies one of

        |value(x)/wanted - 1| <= enough, as computed,
        value(x) < wanted <= value(x+), as computed, with x+ the next float above x.

    No property of the computed function is used but the signs at the two ends, so that it need
    not be monotone in its last places.
    """
    below_it, above_it = np.full(wanted.shape, low), np.full(wanted.shape, high)
    answer = np.array(start)
    places: Places = np.arange(wanted.size)
    tried = answer.copy()
    before = np.full(wanted.shape, np.nan), np.full(wanted.shape, np.nan)
    for step in range(MOST_ROUNDS):
        value, goal = value_at(tried, places), wanted[places]
        below = value < goal
        below_it[places[below]] = tried[below]
        above_it[places[~below]] = tried[~below]
        left, right = below_it[places], above_it[places]
        near = np.abs(value / goal - 1) <= enough
        answer[places] = np.where(near, tried, left)
        unsettled = ~near & (_bits(right) - _bits(left) > 1)
        if not unsettled.any():
            return answer
        places, left, right = places[unsettled], left[unsettled], right[unsettled]
        last = tried[unsettled], value[unsettled]
        wish = suggest(last, (before[0][unsettled], before[1][unsettled]), places)
        before = last
        halved = _between(left, right)
        # a comparison with NaN is false: then the middle is taken
        good = (wish > left) & (wish < right)
        if step >= FREE_ROUNDS and step % 2:
            good[:] = False
        tried = np.where(good, wish, halved)
    raise AssertionError("two floats are never more than 64 halvings apart")


def _bits(x: Reals) -> NDArray[np.int64]:
    return x.view(np.int64)


def _between(low: Reals, high: Reals) -> Reals:
    """The float in the middle of two, counted in floats."""
    first, last = _bits(low), _bits(high)
    middle: NDArray[np.int64] = first + (last - first) // 2
    return middle.view(np.float64)
