# Made by: gainproof generate least-squares-mean
# From: gainproof derive least-squares-mean, SymPy 1.14.0
"""Least-squares mean (growing memory): gains by sample number."""

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

__all__ = [
    "Gains",
    "PredictedCovariance",
    "UpdatedCovariance",
    "gains",
    "predicted_covariance",
    "updated_covariance",
]

_SAMPLE_NUMBER_DOMAIN = Domain(
    "sample_number",
    "a whole number at least 0 and at most 9007199254740992",
    (0.0, 9007199254740992.0),
    (0.0, 9007199254740992.0),
    whole=True,
)
_SAMPLE_NUMBER_DOMAIN_2 = Domain(
    "sample_number",
    "a whole number at least 1 and at most 9007199254740992",
    (1.0, 9007199254740992.0),
    (1.0, 9007199254740992.0),
    whole=True,
)


class Gains(NamedTuple):
    """Result of `gains`."""

    alpha: Real
    """Position gain."""


def gains(sample_number: ArrayLike, *, out: tuple[Real] | None = None, workers: int = 1) -> Gains:
    """Gain of the newest sample in a least-squares fit to samples 0..k.

        alpha = 1/(k + 1)

    sample_number: number k of the newest sample, counted from 0; a whole number at least 0 and at
        most 9007199254740992.

    alpha: position gain. Relative error at most 1.01 * 2^-52 (float64), 1.01 * 2^-23 (float32),
        proved for 0.0 <= sample_number <= 9007199254740992.0 (float64) and 0.0 <= sample_number <=
        9.007199e15 (float32).

    Outside an output's range, a few numbers next to its ends apart, its true value is no normal
    number: it comes as 0, a subnormal number or infinity, never as NaN. Numbers and arrays are
    taken, arrays of any shape; inputs are broadcast. float64 and float32 stay what they are,
    integers become float64. `out`: a tuple of arrays to fill. `workers`: threads that share the
    work on long arrays.

    ValueError: an input outside its domain, with its place; `out` or `workers` that does not fit.
    TypeError: an input that is no real number of these types; in `out` what is no array of the
    results' type.

    Source: derivation least-squares-mean
    """
    if (
        type(sample_number) is float
        and 0.0 <= sample_number <= 9007199254740992.0
        and sample_number.is_integer()
        and out is None
        and workers is ONE
    ):
        try:
            return named(Gains, _gains_of_numbers(sample_number))
        except (ArithmeticError, ValueError):
            pass  # arrays say what is wrong
    return Gains(*evaluate(_GAINS, (sample_number,), out, workers))


def _gains_of_numbers(sample_number: float, _form: Form = Double) -> tuple[float, ...]:
    t3 = 1.0 / (sample_number + 1.0)
    return (t3,)


def _gains_block(given: Arrays, out: Arrays, work: Arrays, _single: bool, n0: float = 1.0) -> None:
    (sample_number,) = given
    (alpha,) = out
    (w0,) = work
    t2 = add(sample_number, n0, w0)
    divide(n0, t2, alpha)


_GAINS = Signature(
    "gains",
    (_SAMPLE_NUMBER_DOMAIN,),
    ("alpha",),
    1,
    _gains_block,
    numbers=_gains_of_numbers,
)


class UpdatedCovariance(NamedTuple):
    """Result of `updated_covariance`."""

    updated_11: Real
    """Variance of the updated position over sigma_v^2."""


def updated_covariance(
    sample_number: ArrayLike, *, out: tuple[Real] | None = None, workers: int = 1
) -> UpdatedCovariance:
    """Covariance of the fit at sample k, in units of sigma_v^2 and T.

        inverse of the sum of the squared rows (1, -j, j^2/2, ...)

    sample_number: number k of the newest sample, counted from 0; a whole number at least 0 and at
        most 9007199254740992.

    updated_11: variance of the updated position over sigma_v^2. Relative error at most 1.01 * 2^-52
        (float64), 1.01 * 2^-23 (float32), proved for 0.0 <= sample_number <= 9007199254740992.0
        (float64) and 0.0 <= sample_number <= 9.007199e15 (float32).

    Outside an output's range, a few numbers next to its ends apart, its true value is no normal
    number: it comes as 0, a subnormal number or infinity, never as NaN. Numbers and arrays are
    taken, arrays of any shape; inputs are broadcast. float64 and float32 stay what they are,
    integers become float64. `out`: a tuple of arrays to fill. `workers`: threads that share the
    work on long arrays.

    ValueError: an input outside its domain, with its place; `out` or `workers` that does not fit.
    TypeError: an input that is no real number of these types; in `out` what is no array of the
    results' type.

    Source: derivation least-squares-mean
    """
    if (
        type(sample_number) is float
        and 0.0 <= sample_number <= 9007199254740992.0
        and sample_number.is_integer()
        and out is None
        and workers is ONE
    ):
        try:
            return named(UpdatedCovariance, _updated_covariance_of_numbers(sample_number))
        except (ArithmeticError, ValueError):
            pass  # arrays say what is wrong
    return UpdatedCovariance(*evaluate(_UPDATED_COVARIANCE, (sample_number,), out, workers))


def _updated_covariance_of_numbers(sample_number: float, _form: Form = Double) -> tuple[float, ...]:
    t3 = 1.0 / (sample_number + 1.0)
    return (t3,)


def _updated_covariance_block(
    given: Arrays, out: Arrays, work: Arrays, _single: bool, n0: float = 1.0
) -> None:
    (sample_number,) = given
    (updated_11,) = out
    (w0,) = work
    t2 = add(sample_number, n0, w0)
    divide(n0, t2, updated_11)


_UPDATED_COVARIANCE = Signature(
    "updated_covariance",
    (_SAMPLE_NUMBER_DOMAIN,),
    ("updated_11",),
    1,
    _updated_covariance_block,
    numbers=_updated_covariance_of_numbers,
)


class PredictedCovariance(NamedTuple):
    """Result of `predicted_covariance`."""

    predicted_11: Real
    """Variance of the predicted position over sigma_v^2."""


def predicted_covariance(
    sample_number: ArrayLike, *, out: tuple[Real] | None = None, workers: int = 1
) -> PredictedCovariance:
    """Covariance of the fit to samples 0..k-1, predicted to sample k.

        inverse of the sum of the squared rows (1, -j, j^2/2, ...)

    sample_number: number k of the newest sample, counted from 0; a whole number at least 1 and at
        most 9007199254740992.

    predicted_11: variance of the predicted position over sigma_v^2. Relative error at most 0.51 *
        2^-52 (float64), 0.51 * 2^-23 (float32), proved for 1.0 <= sample_number <=
        9007199254740992.0 (float64) and 1.0 <= sample_number <= 9.007199e15 (float32).

    Outside an output's range, a few numbers next to its ends apart, its true value is no normal
    number: it comes as 0, a subnormal number or infinity, never as NaN. Numbers and arrays are
    taken, arrays of any shape; inputs are broadcast. float64 and float32 stay what they are,
    integers become float64. `out`: a tuple of arrays to fill. `workers`: threads that share the
    work on long arrays.

    ValueError: an input outside its domain, with its place; `out` or `workers` that does not fit.
    TypeError: an input that is no real number of these types; in `out` what is no array of the
    results' type.

    Source: derivation least-squares-mean
    """
    if (
        type(sample_number) is float
        and 1.0 <= sample_number <= 9007199254740992.0
        and sample_number.is_integer()
        and out is None
        and workers is ONE
    ):
        try:
            return named(PredictedCovariance, _predicted_covariance_of_numbers(sample_number))
        except (ArithmeticError, ValueError):
            pass  # arrays say what is wrong
    return PredictedCovariance(*evaluate(_PREDICTED_COVARIANCE, (sample_number,), out, workers))


def _predicted_covariance_of_numbers(
    sample_number: float,
    _form: Form = Double,
) -> tuple[float, ...]:
    t2 = 1.0 / sample_number
    return (t2,)


def _predicted_covariance_block(
    given: Arrays, out: Arrays, _work: Arrays, _single: bool, n0: float = 1.0
) -> None:
    (sample_number,) = given
    (predicted_11,) = out
    divide(n0, sample_number, predicted_11)


_PREDICTED_COVARIANCE = Signature(
    "predicted_covariance",
    (_SAMPLE_NUMBER_DOMAIN_2,),
    ("predicted_11",),
    0,
    _predicted_covariance_block,
    numbers=_predicted_covariance_of_numbers,
)
