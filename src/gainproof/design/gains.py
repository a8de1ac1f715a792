"""Gains of a named filter for arrays of lags, alphas or tracking indices."""

from __future__ import annotations

import numpy as np
from numpy.typing import ArrayLike

from gainproof.design.named_filter import NamedFilter, Reals, missing
from gainproof.design.named_filters import named_filters
from gainproof.fixed_gain.arguments import Real, place_of, real


def gains_of(
    name: str,
    states: int = 2,
    *,
    lag: ArrayLike | None = None,
    alpha: ArrayLike | None = None,
    tracking_index: ArrayLike | None = None,
    fast: bool = False,
) -> tuple[Real, ...]:
    """alpha, beta and, of three states, gamma of the filter called `name` ("RV", "MV", ...).

    One of: lag, e_fin over a_c T^2 (of three states over j T^3); alpha, the gain of the position;
    tracking_index, that of the filter's own noise. Numbers or arrays. `fast`: of two filters with
    one alpha the one of smaller lag.

    ValueError for another name, for not exactly one argument, for NaN, and where there is no such
    filter: with the bound, why, and the place. TypeError for what is no real number.
    """
    known = {each.name: each for each in named_filters(states)}
    if name not in known:
        names = ", ".join(known) or "none"
        raise ValueError(f"no filter of {states} states is called {name!r}; known: {names}")
    given = {"lag": lag, "alpha": alpha, "tracking_index": tracking_index}
    stated = {kind: value for kind, value in given.items() if value is not None}
    if len(stated) != 1:
        raise ValueError(f"one of lag, alpha, tracking_index is wanted, got {len(stated)}")
    ((kind, value),) = stated.items()
    each, wanted = known[name], real(kind, value)
    if kind == "tracking_index":
        if each.by_index is None:
            raise ValueError(f"{name}, {each.title}, has no tracking index: give a lag or an alpha")
        return _plain(each.by_index(wanted))
    _require(each, kind, wanted)
    if kind == "lag":
        return _plain(each.by_lag(wanted))
    several = each.by_alpha(wanted)
    return _plain(several[-1 if fast else 0])


def _plain(gains: tuple[Reals, ...]) -> tuple[Real, ...]:
    """Numbers for numbers."""
    return tuple(np.asarray(gain)[()] for gain in gains)


def _require(each: NamedFilter, kind: str, wanted: Reals) -> None:
    for place, value in enumerate(wanted.reshape(-1).tolist()):
        reason = missing(each, kind, value)
        if reason is not None:
            where = place_of(place, np.shape(wanted))
            raise ValueError(
                f"{each.name}, {each.title}, does not exist{where}: {reason}; got {value!s}"
            )
