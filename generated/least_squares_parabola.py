# Made by: gainproof generate least-squares-parabola
# From: gainproof derive least-squares-parabola, SymPy 1.14.0
"""Least-squares parabola (growing memory): gains by sample number."""

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
    "a whole number at least 2 and at most 9007199254740992",
    (2.0, 9007199254740992.0),
    (2.0, 9007199254740992.0),
    whole=True,
)
_SAMPLE_NUMBER_DOMAIN_2 = Domain(
    "sample_number",
    "a whole number at least 3 and at most 9007199254740992",
    (3.0, 9007199254740992.0),
    (3.0, 9007199254740992.0),
    whole=True,
)


class Gains(NamedTuple):
    """Result of `gains`."""

    alpha: Real
    """Position gain."""
    beta: Real
    """Velocity gain times T^1."""
    gamma: Real
    """Acceleration gain times T^2."""


def gains(
    sample_number: ArrayLike, *, out: tuple[Real, Real, Real] | None = None, workers: int = 1
) -> Gains:
    """Gain of the newest sample in a least-squares fit to samples 0..k.

        alpha = 3*(3*k**2 + 3*k + 2)/((k + 1)*(k + 2)*(k + 3))
        beta = 18*(2*k + 1)/((k + 1)*(k + 2)*(k + 3))
        gamma = 60/((k + 1)*(k + 2)*(k + 3))

    sample_number: number k of the newest sample, counted from 0; a whole number at least 2 and at
        most 9007199254740992.

    alpha: position gain. Relative error at most 5.51 * 2^-52 (float64), 5.51 * 2^-23 (float32),
        proved for 2.0 <= sample_number <= 9007199254740992.0 (float64) and 2.0 <= sample_number <=
        9.007199e15 (float32).
    beta: velocity gain times T^1. Relative error at most 4.01 * 2^-52 (float64), 4.01 * 2^-23
        (float32), proved for 2.0 <= sample_number <= 9007199254740992.0 (float64) and 2.0 <=
        sample_number <= 9.007199e15 (float32).
    gamma: acceleration gain times T^2. Relative error at most 3.01 * 2^-52 (float64), 3.01 * 2^-23
        (float32), proved for 2.0 <= sample_number <= 9007199254740992.0 (float64) and 2.0 <=
        sample_number <= 1.721777e13 (float32).

    Outside an output's range, a few numbers next to its ends apart, its true value is no normal
    number: it comes as 0, a subnormal number or infinity, never as NaN. Numbers and arrays are
    taken, arrays of any shape; inputs are broadcast. float64 and float32 stay what they are,
    integers become float64. `out`: a tuple of arrays to fill. `workers`: threads that share the
    work on long arrays.

    ValueError: an input outside its domain, with its place; `out` or `workers` that does not fit.
    TypeError: an input that is no real number of these types; in `out` what is no array of the
    results' type.

    Source: derivation least-squares-parabola
    """
    if (
        type(sample_number) is float
        and 2.0 <= sample_number <= 9007199254740992.0
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
    t4 = ((sample_number * 3.0) + 3.0) * sample_number
    t10 = sample_number + 3.0
    t12 = (sample_number + 1.0) * (sample_number + 2.0)
    t19 = (((sample_number * 2.0) + 1.0) * 18.0) / t12
    t14 = (((t4 + 2.0) * 3.0) / t12) / t10
    t20 = t19 / t10
    t23 = (60.0 / t12) / t10
    return (t14, t20, t23)


def _gains_block(
    given: Arrays,
    out: Arrays,
    work: Arrays,
    _single: bool,
    n0: float = 3.0,
    n1: float = 2.0,
    n2: float = 1.0,
    n3: float = 18.0,
    n4: float = 60.0,
) -> None:
    (sample_number,) = given
    alpha, beta, gamma = out
    w0, w1, w2, w3 = work
    t2 = multiply(sample_number, n0, w0)
    t3 = add(t2, n0, w0)
    t4 = multiply(t3, sample_number, w0)
    t6 = add(t4, n1, w0)
    t8 = add(sample_number, n2, w1)
    t9 = add(sample_number, n1, w2)
    t10 = add(sample_number, n0, w3)
    t11 = multiply(t6, n0, w0)
    t12 = multiply(t8, t9, w1)
    t13 = divide(t11, t12, alpha)
    t15 = multiply(sample_number, n1, w0)
    t16 = add(t15, n2, w0)
    t18 = multiply(t16, n3, w0)
    t19 = divide(t18, t12, beta)
    t22 = divide(n4, t12, gamma)
    divide(t13, t10, alpha)
    divide(t19, t10, beta)
    divide(t22, t10, gamma)


_GAINS = Signature(
    "gains",
    (_SAMPLE_NUMBER_DOMAIN,),
    ("alpha", "beta", "gamma"),
    4,
    _gains_block,
    numbers=_gains_of_numbers,
)


class UpdatedCovariance(NamedTuple):
    """Result of `updated_covariance`."""

    updated_11: Real
    """Variance of the updated position over sigma_v^2."""
    updated_12: Real
    """Covariance of updated position and velocity times T^1/sigma_v^2."""
    updated_13: Real
    """Covariance of updated position and acceleration times T^2/sigma_v^2."""
    updated_22: Real
    """Variance of the updated velocity times T^2/sigma_v^2."""
    updated_23: Real
    """Covariance of updated velocity and acceleration times T^3/sigma_v^2."""
    updated_33: Real
    """Variance of the updated acceleration times T^4/sigma_v^2."""


def updated_covariance(
    sample_number: ArrayLike,
    *,
    out: tuple[Real, Real, Real, Real, Real, Real] | None = None,
    workers: int = 1,
) -> UpdatedCovariance:
    """Covariance of the fit at sample k, in units of sigma_v^2 and T.

        inverse of the sum of the squared rows (1, -j, j^2/2, ...)

    sample_number: number k of the newest sample, counted from 0; a whole number at least 2 and at
        most 9007199254740992.

    updated_11: variance of the updated position over sigma_v^2. Relative error at most 5.51 * 2^-52
        (float64), 5.51 * 2^-23 (float32), proved for 2.0 <= sample_number <= 9007199254740992.0
        (float64) and 2.0 <= sample_number <= 9.007199e15 (float32).
    updated_12: covariance of updated position and velocity times T^1/sigma_v^2. Relative error at
        most 4.01 * 2^-52 (float64), 4.01 * 2^-23 (float32), proved for 2.0 <= sample_number <=
        9007199254740992.0 (float64) and 2.0 <= sample_number <= 9.007199e15 (float32).
    updated_13: covariance of updated position and acceleration times T^2/sigma_v^2. Relative error
        at most 3.01 * 2^-52 (float64), 3.01 * 2^-23 (float32), proved for 2.0 <= sample_number <=
        9007199254740992.0 (float64) and 2.0 <= sample_number <= 1.721777e13 (float32).
    updated_22: variance of the updated velocity times T^2/sigma_v^2. Relative error at most 6.51 *
        2^-52 (float64), 6.51 * 2^-23 (float32), proved for 2.0 <= sample_number <=
        9007199254740992.0 (float64) and 2.0 <= sample_number <= 2.5372322e13 (float32).
    updated_23: covariance of updated velocity and acceleration times T^3/sigma_v^2. Relative error
        at most 4.01 * 2^-52 (float64), 4.01 * 2^-23 (float32), proved for 2.0 <= sample_number <=
        9007199254740992.0 (float64) and 2.0 <= sample_number <= 1.3228801e10 (float32).
    updated_33: variance of the updated acceleration times T^4/sigma_v^2. Relative error at most
        4.51 * 2^-52 (float64), 4.51 * 2^-23 (float32), proved for 2.0 <= sample_number <=
        9007199254740992.0 (float64) and 2.0 <= sample_number <= 1.4368862e08 (float32).

    Outside an output's range, a few numbers next to its ends apart, its true value is no normal
    number: it comes as 0, a subnormal number or infinity, never as NaN. Numbers and arrays are
    taken, arrays of any shape; inputs are broadcast. float64 and float32 stay what they are,
    integers become float64. `out`: a tuple of arrays to fill. `workers`: threads that share the
    work on long arrays.

    ValueError: an input outside its domain, with its place; `out` or `workers` that does not fit.
    TypeError: an input that is no real number of these types; in `out` what is no array of the
    results' type.

    Source: derivation least-squares-parabola
    """
    if (
        type(sample_number) is float
        and 2.0 <= sample_number <= 9007199254740992.0
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
    t4 = ((sample_number * 3.0) + 3.0) * sample_number
    t8 = sample_number + 1.0
    t9 = sample_number + 2.0
    t10 = sample_number + 3.0
    t12 = t8 * t9
    t16 = (sample_number * 2.0) + 1.0
    t29 = sample_number + -1.0
    t32 = (t16 * ((sample_number * 8.0) + -3.0)) * 12.0
    t33 = t29 * sample_number
    t14 = (((t4 + 2.0) * 3.0) / t12) / t10
    t20 = ((t16 * 18.0) / t12) / t10
    t23 = (60.0 / t12) / t10
    t36 = ((t32 / t33) / t12) / t10
    t41 = (360.0 / (t29 * t8)) / (t9 * t10)
    t45 = ((720.0 / t33) / t12) / t10
    return (t14, t20, t23, t36, t41, t45)


def _updated_covariance_block(
    given: Arrays,
    out: Arrays,
    work: Arrays,
    _single: bool,
    n0: float = 3.0,
    n1: float = 2.0,
    n2: float = 1.0,
    n3: float = 18.0,
    n4: float = 60.0,
    n5: float = 8.0,
    n6: float = -3.0,
    n7: float = -1.0,
    n8: float = 12.0,
    n9: float = 360.0,
    n10: float = 720.0,
) -> None:
    (sample_number,) = given
    updated_11, updated_12, updated_13, updated_22, updated_23, updated_33 = out
    w0, w1, w2, w3, w4, w5, w6 = work
    t2 = multiply(sample_number, n0, w0)
    t3 = add(t2, n0, w0)
    t4 = multiply(t3, sample_number, w0)
    t6 = add(t4, n1, w0)
    t8 = add(sample_number, n2, w1)
    t9 = add(sample_number, n1, w2)
    t10 = add(sample_number, n0, w3)
    t11 = multiply(t6, n0, w0)
    t12 = multiply(t8, t9, w4)
    t13 = divide(t11, t12, updated_11)
    t15 = multiply(sample_number, n1, w0)
    t16 = add(t15, n2, w0)
    t18 = multiply(t16, n3, w5)
    t19 = divide(t18, t12, updated_12)
    t22 = divide(n4, t12, updated_13)
    t25 = multiply(sample_number, n5, w5)
    t27 = add(t25, n6, w5)
    t29 = add(sample_number, n7, w6)
    t31 = multiply(t16, t27, w0)
    t32 = multiply(t31, n8, w0)
    t33 = multiply(t29, sample_number, w5)
    t34 = divide(t32, t33, updated_22)
    t35 = divide(t34, t12, updated_23)
    t38 = multiply(t29, t8, w6)
    t39 = divide(n9, t38, updated_33)
    t40 = multiply(t9, t10, w2)
    t43 = divide(n10, t33, w5)
    t44 = divide(t43, t12, w5)
    divide(t13, t10, updated_11)
    divide(t19, t10, updated_12)
    divide(t22, t10, updated_13)
    divide(t35, t10, updated_22)
    divide(t39, t40, updated_23)
    divide(t44, t10, updated_33)


_UPDATED_COVARIANCE = Signature(
    "updated_covariance",
    (_SAMPLE_NUMBER_DOMAIN,),
    ("updated_11", "updated_12", "updated_13", "updated_22", "updated_23", "updated_33"),
    7,
    _updated_covariance_block,
    numbers=_updated_covariance_of_numbers,
)


class PredictedCovariance(NamedTuple):
    """Result of `predicted_covariance`."""

    predicted_11: Real
    """Variance of the predicted position over sigma_v^2."""
    predicted_12: Real
    """Covariance of predicted position and velocity times T^1/sigma_v^2."""
    predicted_13: Real
    """Covariance of predicted position and acceleration times T^2/sigma_v^2."""
    predicted_22: Real
    """Variance of the predicted velocity times T^2/sigma_v^2."""
    predicted_23: Real
    """Covariance of predicted velocity and acceleration times T^3/sigma_v^2."""
    predicted_33: Real
    """Variance of the predicted acceleration times T^4/sigma_v^2."""


def predicted_covariance(
    sample_number: ArrayLike,
    *,
    out: tuple[Real, Real, Real, Real, Real, Real] | None = None,
    workers: int = 1,
) -> PredictedCovariance:
    """Covariance of the fit to samples 0..k-1, predicted to sample k.

        inverse of the sum of the squared rows (1, -j, j^2/2, ...)

    sample_number: number k of the newest sample, counted from 0; a whole number at least 3 and at
        most 9007199254740992.

    predicted_11: variance of the predicted position over sigma_v^2. Relative error at most 5.01 *
        2^-52 (float64), 5.01 * 2^-23 (float32), proved for 3.0 <= sample_number <=
        9007199254740992.0 (float64) and 3.0 <= sample_number <= 9.007199e15 (float32).
    predicted_12: covariance of predicted position and velocity times T^1/sigma_v^2. Relative error
        at most 3.51 * 2^-52 (float64), 3.51 * 2^-23 (float32), proved for 3.0 <= sample_number <=
        9007199254740992.0 (float64) and 3.0 <= sample_number <= 9.007199e15 (float32).
    predicted_13: covariance of predicted position and acceleration times T^2/sigma_v^2. Relative
        error at most 2.51 * 2^-52 (float64), 2.51 * 2^-23 (float32), proved for 3.0 <=
        sample_number <= 9007199254740992.0 (float64) and 3.0 <= sample_number <= 1.721777e13
        (float32).
    predicted_22: variance of the predicted velocity times T^2/sigma_v^2. Relative error at most
        6.51 * 2^-52 (float64), 6.51 * 2^-23 (float32), proved for 3.0 <= sample_number <=
        9007199254740992.0 (float64) and 3.0 <= sample_number <= 2.5372322e13 (float32).
    predicted_23: covariance of predicted velocity and acceleration times T^3/sigma_v^2. Relative
        error at most 3.51 * 2^-52 (float64), 3.51 * 2^-23 (float32), proved for 3.0 <=
        sample_number <= 9007199254740992.0 (float64) and 3.0 <= sample_number <= 1.3228801e10
        (float32).
    predicted_33: variance of the predicted acceleration times T^4/sigma_v^2. Relative error at most
        4.51 * 2^-52 (float64), 4.51 * 2^-23 (float32), proved for 3.0 <= sample_number <=
        9007199254740992.0 (float64) and 3.0 <= sample_number <= 1.4368862e08 (float32).

    Outside an output's range, a few numbers next to its ends apart, its true value is no normal
    number: it comes as 0, a subnormal number or infinity, never as NaN. Numbers and arrays are
    taken, arrays of any shape; inputs are broadcast. float64 and float32 stay what they are,
    integers become float64. `out`: a tuple of arrays to fill. `workers`: threads that share the
    work on long arrays.

    ValueError: an input outside its domain, with its place; `out` or `workers` that does not fit.
    TypeError: an input that is no real number of these types; in `out` what is no array of the
    results' type.

    Source: derivation least-squares-parabola
    """
    if (
        type(sample_number) is float
        and 3.0 <= sample_number <= 9007199254740992.0
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
    t4 = ((sample_number * 3.0) + 3.0) * sample_number
    t13 = (sample_number + -2.0) * (sample_number + -1.0)
    t17 = (sample_number * 2.0) + 1.0
    t30 = sample_number + 2.0
    t33 = (t17 * ((sample_number * 8.0) + 11.0)) * 12.0
    t35 = sample_number * (sample_number + 1.0)
    t15 = (((t4 + 2.0) * 3.0) / t13) / sample_number
    t21 = ((t17 * 18.0) / t13) / sample_number
    t24 = (60.0 / t13) / sample_number
    t37 = ((t33 / t13) / t35) / t30
    t41 = (360.0 / t13) / (sample_number * t30)
    t45 = ((720.0 / t13) / t35) / t30
    return (t15, t21, t24, t37, t41, t45)


def _predicted_covariance_block(
    given: Arrays,
    out: Arrays,
    work: Arrays,
    _single: bool,
    n0: float = 3.0,
    n1: float = 2.0,
    n2: float = -2.0,
    n3: float = -1.0,
    n4: float = 1.0,
    n5: float = 18.0,
    n6: float = 60.0,
    n7: float = 8.0,
    n8: float = 11.0,
    n9: float = 12.0,
    n10: float = 360.0,
    n11: float = 720.0,
) -> None:
    (sample_number,) = given
    predicted_11, predicted_12, predicted_13, predicted_22, predicted_23, predicted_33 = out
    w0, w1, w2, w3, w4 = work
    t2 = multiply(sample_number, n0, w0)
    t3 = add(t2, n0, w0)
    t4 = multiply(t3, sample_number, w0)
    t6 = add(t4, n1, w0)
    t8 = add(sample_number, n2, w1)
    t11 = add(sample_number, n3, w2)
    t12 = multiply(t6, n0, w0)
    t13 = multiply(t8, t11, w1)
    t14 = divide(t12, t13, predicted_11)
    t16 = multiply(sample_number, n1, w0)
    t17 = add(t16, n4, w0)
    t19 = multiply(t17, n5, w2)
    t20 = divide(t19, t13, predicted_12)
    t23 = divide(n6, t13, predicted_13)
    t26 = multiply(sample_number, n7, w2)
    t28 = add(t26, n8, w2)
    t29 = add(sample_number, n4, w3)
    t30 = add(sample_number, n1, w4)
    t32 = multiply(t17, t28, w0)
    t33 = multiply(t32, n9, w0)
    t34 = divide(t33, t13, predicted_22)
    t35 = multiply(sample_number, t29, w3)
    t36 = divide(t34, t35, predicted_23)
    t39 = divide(n10, t13, predicted_33)
    t40 = multiply(sample_number, t30, w0)
    t43 = divide(n11, t13, w1)
    t44 = divide(t43, t35, w1)
    divide(t14, sample_number, predicted_11)
    divide(t20, sample_number, predicted_12)
    divide(t23, sample_number, predicted_13)
    divide(t36, t30, predicted_22)
    divide(t39, t40, predicted_23)
    divide(t44, t30, predicted_33)


_PREDICTED_COVARIANCE = Signature(
    "predicted_covariance",
    (_SAMPLE_NUMBER_DOMAIN_2,),
    (
        "predicted_11",
        "predicted_12",
        "predicted_13",
        "predicted_22",
        "predicted_23",
        "predicted_33",
    ),
    5,
    _predicted_covariance_block,
    numbers=_predicted_covariance_of_numbers,
)
