"""Variance against lag of every named filter, with the chosen filters as points."""

from __future__ import annotations

import numpy as np
from numpy.typing import NDArray

from gainproof.design.named_filter import NamedFilter
from gainproof.design.named_filters import named_filters
from gainproof.design.sheet import Sheet
from gainproof.fixed_gain import three_states, two_states
from gainproof.plots.table import Column, Table

Reals = NDArray[np.float64]
POINTS = 241
FACTOR = 30.0
"""The lags drawn reach from the least chosen one over this to the largest times this."""
LARGEST = 1e30
"""The end of the kernels' domain."""


def curves(sheet: Sheet) -> Table:
    """Columns lag, one variance for each filter, and for each choice its variance where its lag is.

    Variance is that of the predicted position over B. Empty where a filter does not exist.
    ValueError where no filter of the sheet does.
    """
    rows = sheet.found
    if not rows:
        raise ValueError("no named filter exists there: nothing can be drawn")
    filters = named_filters(sheet.states)
    least = min(each.lag_above[0] for each in filters)
    low = max(min(row.lag for row in rows) / FACTOR, least * 1.02)
    high = max(min(max(row.lag for row in rows) * FACTOR, LARGEST), low)
    chosen = [row.lag for row in rows]
    # the last point of a geometric row may round beyond its end
    sampled = np.clip(np.geomspace(low, high, POINTS), low, high)
    lags = np.unique(np.concatenate([sampled, chosen]))
    columns = [Column("lag", "e_fin over a_c T^2, of three states over j T^3", lags)]
    for each in filters:
        meaning = f"variance of the predicted position over B, {each.title}"
        curve = _variance(each, lags)
        for row in rows:
            if row.name == each.name:
                curve[lags == row.lag] = row.predicted
        columns.append(Column(each.name, meaning, curve))
    marks: dict[str, Reals] = {}
    for row in rows:
        mark = marks.setdefault(f"chosen_{row.name}", np.full(lags.shape, np.nan))
        mark[lags == row.lag] = row.predicted
    for name, values in marks.items():
        told = f"the choice, {name.removeprefix('chosen_')}"
        columns.append(Column(name, told, values))
    return Table(f"variance against lag, {sheet.states} states", tuple(columns))


def _variance(each: NamedFilter, lags: Reals) -> Reals:
    found = np.full(lags.shape, np.nan)
    # a shade off the end, where a variance is beyond all paper
    fine = (lags > each.lag_above[0] * 1.0005) & (lags >= each.reach[0]) & (lags <= each.reach[1])
    if each.variance_by_lag is not None:
        found[fine] = each.variance_by_lag(lags[fine])
        return found
    gains = each.by_lag(lags[fine])
    if each.states == 2:
        found[fine] = two_states.variances(*gains).predicted_11
    else:
        found[fine] = three_states.variances(*gains).predicted_11
    return found
