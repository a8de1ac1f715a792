"""Which gains are stable, decided exactly, and errors that name the inequality that fails.

Two states: 0 < alpha and 0 < beta < 4 - 2 alpha. Three: besides, 0 < gamma and
gamma (1 - alpha/2) < alpha beta. That these are all is proved in the derivations alpha-beta and
alpha-beta-gamma.
"""

from __future__ import annotations

from collections.abc import Callable, Sequence
from dataclasses import dataclass
from fractions import Fraction
from typing import Any

import numpy as np
from numpy.typing import ArrayLike, NDArray

from gainproof.fixed_gain.arguments import Reals, finite, place_of

GAINS = ("alpha", "beta", "gamma")
NEAR = 2.0**-40
"""Sides that differ by less than this share are compared in exact fractions."""

LARGEST = 1e100
"""Magnitude of gains whose squares and cubes are far from overflow."""


@dataclass(frozen=True)
class Condition:
    """less < greater. Each side is a function of the gains, over floats or fractions alike."""

    less: Callable[..., Any]
    greater: Callable[..., Any]
    words: tuple[str, str]

    @property
    def text(self) -> str:
        return f"{self.words[0]} < {self.words[1]}"

    def holds(self, gains: Sequence[Reals]) -> NDArray[np.bool_]:
        """Where it holds: by floats where they differ clearly, else by exact fractions."""
        if self.less is _zero:
            return np.asarray(self.greater(*gains) > 0)
        with np.errstate(over="ignore", under="ignore", invalid="ignore"):
            left, right = (np.asarray(side(*gains), float) for side in (self.less, self.greater))
            gap, size = right - left, sum(np.abs(gain) for gain in gains)
        fine = np.array(np.broadcast_to(gap > 0, np.shape(gains[0])))
        # products of gains that underflow, overflow or nearly agree are no matter for floats
        clear = np.isfinite(gap) & (np.abs(gap) > NEAR * (np.abs(left) + np.abs(right)))
        clear &= (np.abs(gap) > 1e-280) & (size < 1e140)
        for place in np.flatnonzero(~clear):
            exact = [Fraction(float(gain.flat[place])) for gain in gains]
            fine.flat[place] = self.less(*exact) < self.greater(*exact)
        return fine

    def failure(self, gains: Sequence[float]) -> str:
        """The inequality with its values."""
        sides = [
            f"{words} = {_number(side(*(Fraction(gain) for gain in gains)))}"
            for words, side in zip(self.words, (self.less, self.greater), strict=True)
            if words != "0"
        ]
        return f"{self.text} fails: {', '.join(sides)}"


def _zero(*_gains: Any) -> int:
    return 0


CONDITIONS = {
    2: (
        Condition(_zero, lambda a, _b: a, ("0", "alpha")),
        Condition(_zero, lambda _a, b: b, ("0", "beta")),
        Condition(lambda _a, b: b, lambda a, _b: 4 - 2 * a, ("beta", "4 - 2 alpha")),
    ),
    3: (
        Condition(_zero, lambda a, _b, _c: a, ("0", "alpha")),
        Condition(_zero, lambda _a, b, _c: b, ("0", "beta")),
        Condition(lambda _a, b, _c: b, lambda a, _b, _c: 4 - 2 * a, ("beta", "4 - 2 alpha")),
        Condition(_zero, lambda _a, _b, c: c, ("0", "gamma")),
        Condition(
            lambda a, _b, c: c * (1 - a / 2),
            lambda a, b, _c: a * b,
            ("gamma (1 - alpha/2)", "alpha beta"),
        ),
    ),
}
DOMAINS = {
    2: "stable filters have 0 < alpha and 0 < beta < 4 - 2 alpha",
    3: "stable filters have 0 < alpha, 0 < beta < 4 - 2 alpha, 0 < gamma and "
    "gamma (1 - alpha/2) < alpha beta",
}


def is_stable(*gains: ArrayLike) -> np.bool_ | NDArray[np.bool_]:
    """Whether gains (alpha, beta) or (alpha, beta, gamma) are stable: a bool or an array of them.

    All poles inside the unit circle; on the border it is not stable. Decided exactly for the floats
    given. ValueError for NaN, infinity and shapes that do not fit, TypeError for no real number.
    """
    arrays = checked(gains)
    fine = np.ones(arrays[0].shape, np.bool_)
    for condition in CONDITIONS[len(arrays)]:
        fine &= condition.holds(arrays)
    return fine[()]


def stable_gains(*gains: ArrayLike) -> tuple[Reals, ...]:
    """The gains as float64 arrays of one shape, all of them stable.

    ValueError that names the first inequality that fails, with its values, the index of the first
    element that is not stable, and the domain; otherwise as `is_stable`.
    """
    arrays = checked(gains)
    conditions = CONDITIONS[len(arrays)]
    held = [condition.holds(arrays) for condition in conditions]
    fine = np.logical_and.reduce(held)
    if not fine.all():
        first = int(np.argmin(fine))
        place = place_of(first, arrays[0].shape)
        broken = next(c for c, holds in zip(conditions, held, strict=True) if not holds.flat[first])
        values = [float(gain.flat[first]) for gain in arrays]
        told = broken.failure(values)
        raise ValueError(f"not a stable filter{place}: {told}; {DOMAINS[len(arrays)]}")
    return arrays


def checked(gains: Sequence[ArrayLike]) -> tuple[Reals, ...]:
    """Two or three gains as arrays of one shape. TypeError for another number of them."""
    if len(gains) not in CONDITIONS:
        raise TypeError(f"two or three gains are wanted (alpha, beta, gamma), got {len(gains)}")
    return finite(dict(zip(GAINS, gains, strict=False)))


def moderate(gains: Sequence[ArrayLike]) -> tuple[Reals, ...]:
    """Any gains up to 1e100 in magnitude. ValueError with the first that is beyond."""
    arrays = checked(gains)
    for name, values in zip(GAINS, arrays, strict=False):
        fine = np.abs(values) <= LARGEST
        if not fine.all():
            first = int(np.argmin(fine))
            where = place_of(first, values.shape)
            raise ValueError(
                f"poles are computed for gains from -1e100 to 1e100, got {name} = "
                f"{float(values.flat[first])!s}{where}"
            )
    return arrays


def _number(value: Any) -> str:
    """The shortest text that gives the nearest float back."""
    return repr(float(value)).removesuffix(".0") if abs(value) < 10**300 else "beyond float64"
