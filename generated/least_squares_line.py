# Made by: gainproof generate least-squares-line
# From: gainproof derive least-squares-line, SymPy 1.14.0
"""Least-squares line (growing memory): gains by sample number."""

from __future__ import annotations

from typing import TYPE_CHECKING

from numpy import add, divide, multiply

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
    "a whole number at least 1 and at most 9007199254740992",
    (1.0, 9007199254740992.0),
    (1.0, 9007199254740992.0),
    whole=True,
)
_SAMPLE_NUMBER_DOMAIN_2 = Domain(
    "sample_number",
    "a whole number at least 2 and at most 9007199254740992",
    (2.0, 9007199254740992.0),
    (2.0, 9007199254740992.0),
    whole=True,
)


class Gains(NamedTuple):
    """Result of `gains`."""

    alpha: Real
    """Position gain."""
    beta: Real
    """Velocity gain times T^1."""


def gains(
    sample_number: ArrayLike, *, out: tuple[Real, Real] | None = None, workers: int = 1
) -> Gains:
    """Gain of the newest sample in a least-squares fit to samples 0..k.

        alpha = 2*(2*k + 1)/((k + 1)*(k + 2))
        beta = 6/((k + 1)*(k + 2))

    sample_number: number k of the newest sample, counted from 0; a whole number at least 1 and at
        most 9007199254740992.

    alpha: position gain. Relative error at most 2.51 * 2^-52 (float64), 2.51 * 2^-23 (float32),
        proved for 1.0 <= sample_number <= 9007199254740992.0 (float64) and 1.0 <= sample_number <=
        9.007199e15 (float32).
    beta: velocity gain times T^1. Relative error at most 2.01 * 2^-52 (float64), 2.01 * 2^-23
        (float32), proved for 1.0 <= sample_number <= 9007199254740992.0 (float64) and 1.0 <=
        sample_number <= 9.007199e15 (float32).

    Outside an output's range, a few numbers next to its ends apart, its true value is no normal
    number: it comes as 0, a subnormal number or infinity, never as NaN. Numbers and arrays are
    taken, arrays of any shape; inputs are broadcast. float64 and float32 stay what they are,
    integers become float64. `out`: a tuple of arrays to fill. `workers`: threads that share the
    work on long arrays.

    ValueError: an input outside its domain, with its place; `out` or `workers` that does not fit.
    TypeError: an input that is no real number of these types; in `out` what is no array of the
    results' type.

    Source: derivation least-squares-line
    """
    if (
        type(sample_number) is float
        and 1.0 <= sample_number <= 9007199254740992.0
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
    t8 = (sample_number + 1.0) * (sample_number + 2.0)
    t9 = (((sample_number * 2.0) + 1.0) * 2.0) / t8
    t11 = 6.0 / t8
    return (t9, t11)


def _gains_block(
    given: Arrays,
    out: Arrays,
    work: Arrays,
    _single: bool,
    n0: float = 2.0,
    n1: float = 1.0,
    n2: float = 6.0,
) -> None:
    (sample_number,) = given
    alpha, beta = out
    w0, w1, w2 = work
    t2 = multiply(sample_number, n0, w0)
    t4 = add(t2, n1, w0)
    t5 = add(sample_number, n1, w1)
    t6 = add(sample_number, n0, w2)
    t7 = multiply(t4, n0, w0)
    t8 = multiply(t5, t6, w1)
    divide(t7, t8, alpha)
    divide(n2, t8, beta)


_GAINS = Signature(
    "gains",
    (_SAMPLE_NUMBER_DOMAIN,),
    ("alpha", "beta"),
    3,
    _gains_block,
    numbers=_gains_of_numbers,
)


class UpdatedCovariance(NamedTuple):
    """Result of `updated_covariance`."""

    updated_11: Real
    """Variance of the updated position over sigma_v^2."""
    updated_12: Real
    """Covariance of updated position and velocity times T^1/sigma_v^2."""
    updated_22: Real
    """Variance of the updated velocity times T^2/sigma_v^2."""


def updated_covariance(
    sample_number: ArrayLike, *, out: tuple[Real, Real, Real] | None = None, workers: int = 1
) -> UpdatedCovariance:
    """Covariance of the fit at sample k, in units of sigma_v^2 and T.

        inverse of the sum of the squared rows (1, -j, j^2/2, ...)

    sample_number: number k of the newest sample, counted from 0; a whole number at least 1 and at
        most 9007199254740992.

    updated_11: variance of the updated position over sigma_v^2. Relative error at most 2.51 * 2^-52
        (float64), 2.51 * 2^-23 (float32), proved for 1.0 <= sample_number <= 9007199254740992.0
        (float64) and 1.0 <= sample_number <= 9.007199e15 (float32).
    updated_12: covariance of updated position and velocity times T^1/sigma_v^2. Relative error at
        most 2.01 * 2^-52 (float64), 2.01 * 2^-23 (float32), proved for 1.0 <= sample_number <=
        9007199254740992.0 (float64) and 1.0 <= sample_number <= 9.007199e15 (float32).
    updated_22: variance of the updated velocity times T^2/sigma_v^2. Relative error at most 2.51 *
        2^-52 (float64), 2.51 * 2^-23 (float32), proved for 1.0 <= sample_number <=
        9007199254740992.0 (float64) and 1.0 <= sample_number <= 1.0069013e13 (float32).

    Outside an output's range, a few numbers next to its ends apart, its true value is no normal
    number: it comes as 0, a subnormal number or infinity, never as NaN. Numbers and arrays are
    taken, arrays of any shape; inputs are broadcast. float64 and float32 stay what they are,
    integers become float64. `out`: a tuple of arrays to fill. `workers`: threads that share the
    work on long arrays.

    ValueError: an input outside its domain, with its place; `out` or `workers` that does not fit.
    TypeError: an input that is no real number of these types; in `out` what is no array of the
    results' type.

    Source: derivation least-squares-line
    """
    if (
        type(sample_number) is float
        and 1.0 <= sample_number <= 9007199254740992.0
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
    t5 = sample_number + 1.0
    t6 = sample_number + 2.0
    t8 = t5 * t6
    t9 = (((sample_number * 2.0) + 1.0) * 2.0) / t8
    t11 = 6.0 / t8
    t15 = (12.0 / (sample_number * t5)) / t6
    return (t9, t11, t15)


def _updated_covariance_block(
    given: Arrays,
    out: Arrays,
    work: Arrays,
    _single: bool,
    n0: float = 2.0,
    n1: float = 1.0,
    n2: float = 12.0,
    n3: float = 6.0,
) -> None:
    (sample_number,) = given
    updated_11, updated_12, updated_22 = out
    w0, w1, w2, w3 = work
    t2 = multiply(sample_number, n0, w0)
    t4 = add(t2, n1, w0)
    t5 = add(sample_number, n1, w1)
    t6 = add(sample_number, n0, w2)
    t7 = multiply(t4, n0, w0)
    t8 = multiply(t5, t6, w3)
    t13 = multiply(sample_number, t5, w1)
    t14 = divide(n2, t13, updated_22)
    divide(t7, t8, updated_11)
    divide(n3, t8, updated_12)
    divide(t14, t6, updated_22)


_UPDATED_COVARIANCE = Signature(
    "updated_covariance",
    (_SAMPLE_NUMBER_DOMAIN,),
    ("updated_11", "updated_12", "updated_22"),
    4,
    _updated_covariance_block,
    numbers=_updated_covariance_of_numbers,
)


class PredictedCovariance(NamedTuple):
    """Result of `predicted_covariance`."""

    predicted_11: Real
    """Variance of the predicted position over sigma_v^2."""
    predicted_12: Real
    """Covariance of predicted position and velocity times T^1/sigma_v^2."""
    predicted_22: Real
    """Variance of the predicted velocity times T^2/sigma_v^2."""


def predicted_covariance(
    sample_number: ArrayLike, *, out: tuple[Real, Real, Real] | None = None, workers: int = 1
) -> PredictedCovariance:
    """Covariance of the fit to samples 0..k-1, predicted to sample k.

        inverse of the sum of the squared rows (1, -j, j^2/2, ...)

    sample_number: number k of the newest sample, counted from 0; a whole number at least 2 and at
        most 9007199254740992.

    predicted_11: variance of the predicted position over sigma_v^2. Relative error at most 2.01 *
        2^-52 (float64), 2.01 * 2^-23 (float32), proved for 2.0 <= sample_number <=
        9007199254740992.0 (float64) and 2.0 <= sample_number <= 9.007199e15 (float32).
    predicted_12: covariance of predicted position and velocity times T^1/sigma_v^2. Relative error
        at most 1.51 * 2^-52 (float64), 1.51 * 2^-23 (float32), proved for 2.0 <= sample_number <=
        9007199254740992.0 (float64) and 2.0 <= sample_number <= 9.007199e15 (float32).
    predicted_22: variance of the predicted velocity times T^2/sigma_v^2. Relative error at most
        2.51 * 2^-52 (float64), 2.51 * 2^-23 (float32), proved for 2.0 <= sample_number <=
        9007199254740992.0 (float64) and 2.0 <= sample_number <= 1.0069013e13 (float32).

    Outside an output's range, a few numbers next to its ends apart, its true value is no normal
    number: it comes as 0, a subnormal number or infinity, never as NaN. Numbers and arrays are
    taken, arrays of any shape; inputs are broadcast. float64 and float32 stay what they are,
    integers become float64. `out`: a tuple of arrays to fill. `workers`: threads that share the
    work on long arrays.

    ValueError: an input outside its domain, with its place; `out` or `workers` that does not fit.
    TypeError: an input that is no real number of these types; in `out` what is no array of the
    results' type.

    Source: derivation least-squares-line
    """
    if (
        type(sample_number) is float
        and 2.0 <= sample_number <= 9007199254740992.0
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
    t8 = (sample_number + -1.0) * sample_number
    t9 = (((sample_number * 2.0) + 1.0) * 2.0) / t8
    t11 = 6.0 / t8
    t15 = (12.0 / t8) / (sample_number + 1.0)
    return (t9, t11, t15)


def _predicted_covariance_block(
    given: Arrays,
    out: Arrays,
    work: Arrays,
    _single: bool,
    n0: float = 2.0,
    n1: float = 1.0,
    n2: float = -1.0,
    n3: float = 12.0,
    n4: float = 6.0,
) -> None:
    (sample_number,) = given
    predicted_11, predicted_12, predicted_22 = out
    w0, w1, w2 = work
    t2 = multiply(sample_number, n0, w0)
    t4 = add(t2, n1, w0)
    t6 = add(sample_number, n2, w1)
    t7 = multiply(t4, n0, w0)
    t8 = multiply(t6, sample_number, w1)
    t12 = add(sample_number, n1, w2)
    t14 = divide(n3, t8, predicted_22)
    divide(t7, t8, predicted_11)
    divide(n4, t8, predicted_12)
    divide(t14, t12, predicted_22)


_PREDICTED_COVARIANCE = Signature(
    "predicted_covariance",
    (_SAMPLE_NUMBER_DOMAIN_2,),
    ("predicted_11", "predicted_12", "predicted_22"),
    3,
    _predicted_covariance_block,
    numbers=_predicted_covariance_of_numbers,
)
