"""Elements that a printed kernel takes and those beyond it, computed apart and put together."""

from __future__ import annotations

from collections.abc import Callable, Sequence
from fractions import Fraction
from typing import Any

import numpy as np
from numpy.typing import NDArray

from gainproof.fixed_gain.arguments import Real, Reals, place_of
from gainproof.fixed_gain.stability import GAINS, Condition
from gainproof.fixed_gain.twofold import Twofold

PLAIN = 0.25
"""A difference that is at least this share of its terms loses no more than two bits."""
TWOFOLD = 2.0**-45
"""One that is at least this share of them keeps more than float64 holds of twice its digits."""


class UnreachedError(ValueError):
    """Gains that are stable and yet beyond what the kernels compute; `first`: which of them."""

    def __init__(self, text: str, first: int) -> None:
        super().__init__(text)
        self.first = first


def within(signature: Any, given: Sequence[Reals]) -> NDArray[np.bool_]:
    """Where every input lies in the domain that a kernel's bounds are proved for."""
    fine = np.ones(given[0].shape, np.bool_)
    for domain, values in zip(signature.inputs, given, strict=True):
        low, high = domain.double
        fine &= (values >= low) & (values <= high)
    return fine


def put_together(
    fine: NDArray[np.bool_],
    given: Sequence[Reals],
    inside: Callable[..., Sequence[Any]],
    beyond: Callable[..., Sequence[Any]],
) -> list[Real]:
    """The outputs of `inside` where `fine`, else those of `beyond`; numbers for numbers.

    ValueError with the place where `beyond` does not reach.
    """
    if fine.all():
        return [np.asarray(y)[()] for y in inside(*given)]
    flat = [values.reshape(-1) for values in given]
    mask = fine.reshape(-1)
    try:
        with np.errstate(all="ignore"):
            others = beyond(*(values[~mask] for values in flat))
    except UnreachedError as error:
        first = int(np.flatnonzero(~mask)[error.first])
        raise ValueError(f"{error}{place_of(first, fine.shape)}") from None
    results = [np.empty(mask.shape) for _ in others]
    for y, part in zip(results, others, strict=True):
        y[~mask] = part
    if mask.any():
        for y, part in zip(results, inside(*(values[mask] for values in flat)), strict=True):
            y[mask] = part
    return [y.reshape(fine.shape)[()] for y in results]


def require_reach(signature: Any, given: Sequence[Reals], gains: Sequence[Reals]) -> None:
    """UnreachedError with the first gains whose coordinates no kernel takes."""
    fine = within(signature, given)
    if fine.all():
        return
    first = int(np.argmin(fine))
    came = ", ".join(
        f"{name} = {gain.flat[first]!s}" for name, gain in zip(GAINS, gains, strict=False)
    )
    beyond = next(
        f"{domain.name.replace('_', ' ')} is {values.flat[first]:.6g}, the kernels take "
        f"{domain.double[0]:g} to {domain.double[1]:g}"
        for domain, values in zip(signature.inputs, given, strict=True)
        if not domain.double[0] <= values.flat[first] <= domain.double[1]
    )
    text = f"stable gains, yet beyond the reach of the kernels: {came}, whose {beyond}"
    raise UnreachedError(text, first)


def gap(condition: Condition, gains: Sequence[Reals]) -> Reals:
    """greater - less of an inequality, within 4 * 2^-52 of itself: where floats would cancel with
    twice their digits, and by exact fractions where these would.
    """
    left, right = condition.less(*gains), condition.greater(*gains)
    found = np.array(np.broadcast_to(right - left, gains[0].shape))
    size = np.broadcast_to(np.abs(left) + np.abs(right), found.shape)
    lost = ~(np.abs(found) > PLAIN * size)
    if lost.any():
        pairs = [Twofold.of(gain[lost]) for gain in gains]
        found[lost] = (condition.greater(*pairs) - condition.less(*pairs)).high
        lost &= ~((np.abs(found) > TWOFOLD * size) & (size > 1e-100) & (size < 1e100))
    for place in np.flatnonzero(lost):
        exact = [Fraction(float(gain.flat[place])) for gain in gains]
        found.flat[place] = float(condition.greater(*exact) - condition.less(*exact))
    return found
