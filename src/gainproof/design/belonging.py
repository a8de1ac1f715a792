"""Which named filters given gains belong to, within the digits that they are printed with."""

from __future__ import annotations

import math
from dataclasses import dataclass
from decimal import Decimal, InvalidOperation

import numpy as np

from gainproof.design.named_filter import NamedFilter, missing, out_of_reach
from gainproof.design.named_filters import named_filters

POINTS = 33
"""Places between the ends of the last printed gain where a filter's other gains are looked at."""


@dataclass(frozen=True)
class Printed:
    """A number as it is printed: its value, and half a unit of its last digit."""

    text: str
    value: float
    half: float

    @property
    def ends(self) -> tuple[float, float]:
        return self.value - self.half, self.value + self.half


@dataclass(frozen=True)
class Belonging:
    """A filter with these gains or not: its gains where the last one is as it is printed, and how
    far the others are from what is printed. `not_compared`: why it could not be looked at.
    """

    name: str
    title: str
    fits: bool
    gains: tuple[float, ...]
    off: tuple[float, ...]
    not_compared: str = ""


def printed(text: str) -> Printed:
    """A decimal number with its digits. ValueError for anything else."""
    try:
        number = Decimal(text)
    except InvalidOperation:
        raise ValueError(f"a gain is a number, got {text!r}") from None
    exponent = number.as_tuple().exponent
    if not isinstance(exponent, int):
        raise ValueError(f"a gain must be finite, got {text!r}")
    value = float(number)
    if not math.isfinite(value) or (number and not value):
        raise ValueError(f"a gain must be a number that float64 holds, got {text!r}")
    return Printed(text, value, float(f"5e{exponent - 1}"))


def belonging(gains: tuple[Printed, ...]) -> tuple[Belonging, ...]:
    """Every named filter, and whether a point of its curve rounds to all the digits.

    The last gain is 1/lag. Over the numbers that are printed as it, the filter's other gains are
    followed: they have to come within half a unit of the last digit, all at one point (a curve is
    looked at in 33 places and taken to be between neighbours what lies between their values).
    """
    *others, last = gains
    found = []
    for each in named_filters(len(gains)):
        if missing(each, "lag", 1 / last.value) is None:
            beyond = out_of_reach(each, 1 / last.value)
            if beyond is not None:
                reason = f"{beyond}, here it is {1 / last.value!s}"
                found.append(Belonging(each.name, each.title, False, (), (), reason))
                continue
            middle = each.by_lag(np.asarray(1 / last.value))
            shown = tuple(float(gain) for gain in middle)
            off = tuple(abs(x - given.value) for x, given in zip(shown, others, strict=False))
            fits = _fits(each, others, last)
            found.append(Belonging(each.name, each.title, fits, shown, off))
    return tuple(found)


def _fits(each: NamedFilter, others: list[Printed], last: Printed) -> bool:
    low, high = last.ends
    limit = each.lag_above[0]
    points = np.linspace(max(low, last.value / 2), high, POINTS)
    lags = 1 / points[points * limit < 1]
    lags = lags[(lags >= each.reach[0]) & (lags <= each.reach[1])]
    curve = each.by_lag(lags if lags.size else 1 / np.array([last.value]))
    inside = np.ones(max(len(curve[0]) - 1, 1), np.bool_)
    for gain, values in zip(others, curve, strict=False):
        bottom, top = gain.ends
        before, after = (values[:-1], values[1:]) if len(values) > 1 else (values, values)
        inside &= (np.minimum(before, after) <= top) & (np.maximum(before, after) >= bottom)
    return bool(inside.any())
