# Made by: gainproof generate interacting-gains
# From: gainproof derive interacting-gains, SymPy 1.14.0
"""Filters with matrix gains: the gain of one coordinate."""

from __future__ import annotations

from typing import TYPE_CHECKING

from numpy import add, divide

from gainproof.generated._numbers import ONE, Double, named
from gainproof.generated._runtime import evaluate
from gainproof.generated._signature import Domain, Signature

if TYPE_CHECKING:
    from typing import NamedTuple

    from gainproof.generated._numbers import Form
    from gainproof.generated._signature import ArrayLike, Arrays, Real
else:
    from gainproof.generated._result import NamedTuple

__all__ = ["PositionGain", "position_gain"]

_VARIANCE_RATIO_DOMAIN = Domain(
    "variance_ratio",
    "a number at least 1e-300 and at most 1e300, in float32 at least 1e-30 and at most 1e30",
    (1e-300, 1e300),
    (1.0000000031710769e-30, 1.0000000150474662e30),
)


class PositionGain(NamedTuple):
    """Result of `position_gain`."""

    gain: Real
    """Gain of the position."""
    rest: Real
    """The updated variance over the predicted one, 1 - gain."""


def position_gain(
    variance_ratio: ArrayLike, *, out: tuple[Real, Real] | None = None, workers: int = 1
) -> PositionGain:
    """Kalman's gain of the position from the variances of prediction and measurement.

        gain = P/(P + B)
        rest = B/(P + B), the share left of P after the update

    variance_ratio: variance P of the predicted position over that of its measurement, B; a number
        at least 1e-300 and at most 1e300, in float32 at least 1e-30 and at most 1e30.

    gain: gain of the position. Relative error at most 1.01 * 2^-52 (float64), 1.01 * 2^-23
        (float32), proved for 1e-300 <= variance_ratio <= 1e300 (float64) and 1e-30 <=
        variance_ratio <= 1e30 (float32).
    rest: the updated variance over the predicted one, 1 - gain. Relative error at most 1.01 * 2^-52
        (float64), 1.01 * 2^-23 (float32), proved for 1e-300 <= variance_ratio <= 1e300 (float64)
        and 1e-30 <= variance_ratio <= 1e30 (float32).

    Outside an output's range, a few numbers next to its ends apart, its true value is no normal
    number: it comes as 0, a subnormal number or infinity, never as NaN. Numbers and arrays are
    taken, arrays of any shape; inputs are broadcast. float64 and float32 stay what they are,
    integers become float64. `out`: a tuple of arrays to fill. `workers`: threads that share the
    work on long arrays.

    ValueError: an input outside its domain, with its place; `out` or `workers` that does not fit.
    TypeError: an input that is no real number of these types; in `out` what is no array of the
    results' type.

    Source: derivation interacting-gains
    """
    if (
        type(variance_ratio) is float
        and 1e-300 <= variance_ratio <= 1e300
        and out is None
        and workers is ONE
    ):
        try:
            return named(PositionGain, _position_gain_of_numbers(variance_ratio))
        except (ArithmeticError, ValueError):
            pass  # arrays say what is wrong
    return PositionGain(*evaluate(_POSITION_GAIN, (variance_ratio,), out, workers))


def _position_gain_of_numbers(variance_ratio: float, _form: Form = Double) -> tuple[float, ...]:
    t2 = 1.0 + variance_ratio
    t3 = variance_ratio / t2
    t4 = 1.0 / t2
    return (t3, t4)


def _position_gain_block(
    given: Arrays, out: Arrays, work: Arrays, _single: bool, n0: float = 1.0
) -> None:
    (variance_ratio,) = given
    gain, rest = out
    (w0,) = work
    t2 = add(n0, variance_ratio, w0)
    divide(variance_ratio, t2, gain)
    divide(n0, t2, rest)


_POSITION_GAIN = Signature(
    "position_gain",
    (_VARIANCE_RATIO_DOMAIN,),
    ("gain", "rest"),
    1,
    _position_gain_block,
    numbers=_position_gain_of_numbers,
)
