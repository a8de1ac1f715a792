# Made by: gainproof generate multipath-location
# From: gainproof derive multipath-location, SymPy 1.14.0
"""Location from range and Doppler in multipath: the deviation of an estimated bias."""

from __future__ import annotations

from typing import TYPE_CHECKING

from numpy import add, divide, sqrt

from gainproof.generated._numbers import ONE, Double, named
from gainproof.generated._runtime import evaluate
from gainproof.generated._signature import Domain, Signature

if TYPE_CHECKING:
    from typing import NamedTuple

    from gainproof.generated._numbers import Form
    from gainproof.generated._signature import ArrayLike, Arrays, Real
else:
    from gainproof.generated._result import NamedTuple

__all__ = ["BiasDeviation", "bias_deviation"]

_VARIANCE_RATIO_DOMAIN = Domain(
    "variance_ratio",
    "a number at least 1e-300 and at most 1e300, in float32 at least 1e-30 and at most 1e30",
    (1e-300, 1e300),
    (1.0000000031710769e-30, 1.0000000150474662e30),
)


class BiasDeviation(NamedTuple):
    """Result of `bias_deviation`."""

    deviation: Real
    """Standard deviation of the bias over that of the range."""
    share: Real
    """Share of the range's own noise in the variance of the bias."""


def bias_deviation(
    variance_ratio: ArrayLike, *, out: tuple[Real, Real] | None = None, workers: int = 1
) -> BiasDeviation:
    """Deviation of an estimated bias over that of its range.

        deviation = sqrt(1 + r)
        share = 1/(1 + r)

    variance_ratio: variance of the range to the estimated position over that of the range's noise,
        r; a number at least 1e-300 and at most 1e300, in float32 at least 1e-30 and at most 1e30.

    deviation: standard deviation of the bias over that of the range. Relative error at most 0.76 *
        2^-52 (float64), 0.76 * 2^-23 (float32), proved for 1e-300 <= variance_ratio <= 1e300
        (float64) and 1e-30 <= variance_ratio <= 1e30 (float32).
    share: share of the range's own noise in the variance of the bias. Relative error at most 1.01 *
        2^-52 (float64), 1.01 * 2^-23 (float32), proved for 1e-300 <= variance_ratio <= 1e300
        (float64) and 1e-30 <= variance_ratio <= 1e30 (float32).

    Outside an output's range, a few numbers next to its ends apart, its true value is no normal
    number: it comes as 0, a subnormal number or infinity, never as NaN. Numbers and arrays are
    taken, arrays of any shape; inputs are broadcast. float64 and float32 stay what they are,
    integers become float64. `out`: a tuple of arrays to fill. `workers`: threads that share the
    work on long arrays.

    ValueError: an input outside its domain, with its place; `out` or `workers` that does not fit.
    TypeError: an input that is no real number of these types; in `out` what is no array of the
    results' type.

    Source: derivation multipath-location
    """
    if (
        type(variance_ratio) is float
        and 1e-300 <= variance_ratio <= 1e300
        and out is None
        and workers is ONE
    ):
        try:
            return named(BiasDeviation, _bias_deviation_of_numbers(variance_ratio))
        except (ArithmeticError, ValueError):
            pass  # arrays say what is wrong
    return BiasDeviation(*evaluate(_BIAS_DEVIATION, (variance_ratio,), out, workers))


def _bias_deviation_of_numbers(variance_ratio: float, form: Form = Double) -> tuple[float, ...]:
    t2 = 1.0 + variance_ratio
    t3 = form.sqrt(t2)
    t4 = 1.0 / t2
    return (t3, t4)


def _bias_deviation_block(
    given: Arrays, out: Arrays, work: Arrays, _single: bool, n0: float = 1.0
) -> None:
    (variance_ratio,) = given
    deviation, share = out
    (w0,) = work
    t2 = add(n0, variance_ratio, w0)
    sqrt(t2, deviation)
    divide(n0, t2, share)


_BIAS_DEVIATION = Signature(
    "bias_deviation",
    (_VARIANCE_RATIO_DOMAIN,),
    ("deviation", "share"),
    1,
    _bias_deviation_block,
    numbers=_bias_deviation_of_numbers,
)
