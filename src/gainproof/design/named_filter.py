"""What a named filter is, and how kernels of one input make its gains."""

from __future__ import annotations

from collections.abc import Callable, Sequence
from dataclasses import dataclass
from typing import Any

import numpy as np
from numpy.typing import NDArray

Reals = NDArray[np.float64]
Gains = tuple[Reals, ...]
"""alpha, beta and, of three states, gamma."""


@dataclass(frozen=True)
class NamedFilter:
    """One named filter of two or three states.

    by_lag: gains of lags (e_fin over a T^2, of three states over j T^3). by_alpha: gains of alphas,
    a tuple for each filter with that gain. by_index: gains of tracking indices, None for a filter
    that is no steady state of a Kalman filter; `family` is the derivation that it belongs to.
    variance_by_lag: variance of the predicted position over B where a kernel gives it, which keeps
    its digits next to a border where those of the gains are lost; variances_by_alpha the same, for
    each filter of an alpha, and variance_by_index, of a filter that comes to a border as its index
    grows. reach: least and largest lag that by_lag takes. It is the steady state of a Kalman filter
    for lags above `kalman_above`.
    It exists for lags above `lag_above` and for 0 < alpha < `alpha_below`, or, `closed`, up to
    that; `lag_reason` and `alpha_reason` say why.
    """

    name: str
    title: str
    states: int
    by_lag: Callable[[Reals], Gains]
    by_alpha: Callable[[Reals], Sequence[Gains]]
    by_index: Callable[[Reals], Gains] | None
    lag_above: tuple[float, str]
    lag_reason: str
    alpha_below: tuple[float, str]
    alpha_reason: str
    family: str = ""
    closed: bool = False
    variance_by_lag: Callable[[Reals], Reals] | None = None
    variances_by_alpha: Callable[[Reals], Sequence[Reals]] | None = None
    variance_by_index: Callable[[Reals], Reals] | None = None
    reach: tuple[float, float] = (0.0, np.inf)
    kalman_above: float = 0.0


def first_outputs(kernel: Callable[..., Any], count: int) -> Callable[[Reals], Gains]:
    """The first outputs of a kernel of one input."""
    return lambda given: tuple(np.asarray(each) for each in kernel(given)[:count])


def output(kernel: Callable[..., Any], place: int) -> Callable[[Reals], Reals]:
    """One output of a kernel of one input."""
    return lambda given: np.asarray(kernel(given)[place])


def only(function: Callable[[Reals], Reals]) -> Callable[[Reals], Sequence[Reals]]:
    """One filter for each alpha."""
    return lambda alpha: (function(alpha),)


def with_alpha(kernel: Callable[..., Any], count: int) -> Callable[[Reals], Sequence[Gains]]:
    """alpha itself and the first outputs of a kernel that takes it."""
    gains = first_outputs(kernel, count)
    return lambda alpha: ((np.asarray(alpha), *gains(alpha)),)


def inverse(
    gains: Callable[[Reals], Gains], place: int, low: float, high: float
) -> Callable[[Reals], Gains]:
    """Gains whose one (at `place`) is wanted, over a kernel's argument between `low` and `high`."""

    def find(wanted: Reals) -> Gains:
        argument, fine = _solved(lambda x: gains(x)[place], np.asarray(wanted), low, high)
        if not np.all(fine):
            first = np.asarray(wanted)[~fine].flat[0]
            raise ValueError(f"no lag in reach gives {first!s}")
        return gains(argument)

    return find


def as_one(gains: Callable[[Reals], Gains]) -> Callable[[Reals], Sequence[Gains]]:
    return lambda alpha: (gains(alpha),)


def out_of_reach(each: NamedFilter, lag: float) -> str | None:
    """Why no kernel computes a filter of this lag that there is; None where one does."""
    low, high = each.reach
    if low <= lag <= high:
        return None
    return f"lags are computed from {low:.6g} to {high:.6g}"


def missing(each: NamedFilter, kind: str, value: float) -> str | None:
    """Why there is no such filter of this "lag" or "alpha"; None where there is one."""
    if kind == "lag":
        limit, words = each.lag_above
        return None if value > limit else f"lag must be above {words}: {each.lag_reason}"
    limit, words = each.alpha_below
    if 0 < value < limit or (each.closed and value == limit):
        return None
    most = "at most" if each.closed else "below"
    return f"alpha must be above 0 and {most} {words}: {each.alpha_reason}"


_HALVINGS = 64
"""Bisections of an interval that no more than 2^1100 or so separate in floats: the exponent
first, then 52 bits."""


def _solved(
    value: Callable[[Reals], Any], wanted: Reals, low: float, high: float
) -> tuple[Reals, NDArray[np.bool_]]:
    """Parameters between `low` and `high`, both positive, where a monotone function of arrays has
    the wanted values; and whether it takes them on the interval at all.

    The parameter is within a few numbers of the true one; where it is not taken it is an end.
    """
    wanted = np.asarray(wanted, np.float64)
    below, above = np.full(wanted.shape, low), np.full(wanted.shape, high)
    first, last = (np.asarray(value(end)) for end in (below, above))
    rising = last > first
    found = (wanted >= np.minimum(first, last)) & (wanted <= np.maximum(first, last))
    for step in range(2 * _HALVINGS):
        # the geometric mean halves exponents, the arithmetic mean bits
        middle = np.sqrt(below) * np.sqrt(above) if step < _HALVINGS // 4 else (below + above) / 2
        middle = np.clip(middle, below, above)
        up = (np.asarray(value(middle)) < wanted) == rising
        below, above = np.where(up, middle, below), np.where(up, above, middle)
        if np.all(np.nextafter(below, above) >= above):
            break
    return above, found
