# Made by: gainproof generate random-acceleration
# From: gainproof derive random-acceleration, SymPy 1.14.0
"""Random acceleration (constant over each interval): steady state with measured position."""

from __future__ import annotations

from typing import TYPE_CHECKING

from numpy import absolute, add, divide, less, multiply, negative, sqrt, square, subtract

from gainproof.generated._bits import choose, mask_of
from gainproof.generated._numbers import ONE, Double, filled_by, named
from gainproof.generated._runtime import evaluate
from gainproof.generated._signature import Domain, Signature
from gainproof.generated._two_state_results import (
    AlphaFromBeta,
    BetaFromAlpha,
    ClosedLoopPoles,
    GainDerivatives,
    Gains,
    GainSecondDerivatives,
    GainsWithDerivatives,
    IndexFromAlpha,
    IndexFromBeta,
    PredictedCovariance,
    PredictedCovarianceDerivatives,
    PredictedCovarianceSecondDerivatives,
    PredictorGainDerivatives,
    PredictorGains,
    PredictorGainSecondDerivatives,
    UpdatedCovariance,
    UpdatedCovarianceDerivatives,
    UpdatedCovarianceSecondDerivatives,
)

if TYPE_CHECKING:
    from gainproof.generated._double_word import Part
    from gainproof.generated._numbers import Form
    from gainproof.generated._signature import ArrayLike, Arrays, Real

__all__ = [
    "AlphaFromBeta",
    "BetaFromAlpha",
    "ClosedLoopPoles",
    "GainDerivatives",
    "GainSecondDerivatives",
    "Gains",
    "GainsWithDerivatives",
    "IndexFromAlpha",
    "IndexFromBeta",
    "PredictedCovariance",
    "PredictedCovarianceDerivatives",
    "PredictedCovarianceSecondDerivatives",
    "PredictorGainDerivatives",
    "PredictorGainSecondDerivatives",
    "PredictorGains",
    "UpdatedCovariance",
    "UpdatedCovarianceDerivatives",
    "UpdatedCovarianceSecondDerivatives",
    "alpha_from_beta",
    "beta_from_alpha",
    "closed_loop_poles",
    "gain_derivatives",
    "gain_second_derivatives",
    "gains",
    "gains_with_derivatives",
    "index_from_alpha",
    "index_from_beta",
    "predicted_covariance",
    "predicted_covariance_derivatives",
    "predicted_covariance_second_derivatives",
    "predictor_gain_derivatives",
    "predictor_gain_second_derivatives",
    "predictor_gains",
    "updated_covariance",
    "updated_covariance_derivatives",
    "updated_covariance_second_derivatives",
]

_TRACKING_INDEX_DOMAIN = Domain(
    "tracking_index",
    "a number above 0 and finite",
    (5e-324, 1.7976931348623157e308),
    (1.401298464324817e-45, 3.4028234663852886e38),
)
_ACCURATE_TRACKING_INDEX_DOMAIN = Domain(
    "tracking_index",
    "a number at least 2^-400 and at most 2^400",
    (3.8725919148493183e-121, 2.5822498780869086e120),
    (1.401298464324817e-45, 3.4028234663852886e38),
)
_ALPHA_DOMAIN = Domain(
    "alpha",
    "a number above 0 and below 1",
    (5e-324, 0.9999999999999999),
    (1.401298464324817e-45, 0.9999999403953552),
)
_BETA_DOMAIN = Domain(
    "beta",
    "a number above 0 and below 2",
    (5e-324, 1.9999999999999998),
    (1.401298464324817e-45, 1.9999998807907104),
)


def gains(
    tracking_index: ArrayLike,
    *,
    out: tuple[Real, Real] | None = None,
    workers: int = 1,
    accurate: bool = False,
) -> Gains:
    """Steady-state filter gain.

        beta = 2/(1/2 + kappa + rho), alpha = rho beta
        kappa = 2/Lambda, rho = sqrt(kappa + 1/4) = alpha/beta,
        sigma = Lambda/beta = Lambda (1/2 + kappa + rho)/2

    tracking_index: Lambda, with Lambda^2 =
        acceleration_deviation**2*sampling_interval**4/measurement_deviation**2; a number above 0
        and finite.

    alpha: position gain. Relative error at most 1.69 * 2^-52 (float64), 1.69 * 2^-23 (float32),
        proved for 5e-324 <= tracking_index <= 1.7976931348623157e308 (float64) and 1e-45 <=
        tracking_index <= 3.4028235e38 (float32).
    beta: velocity gain times the sampling interval. Relative error at most 1.95 * 2^-52 (float64),
        1.95 * 2^-23 (float32), proved for 2.2250738585072014e-308 <= tracking_index <=
        1.7976931348623157e308 (float64) and 1.1754944e-38 <= tracking_index <= 3.4028235e38
        (float32).

    Outside an output's range, a few numbers next to its ends apart, its true value is no normal
    number: it comes as 0, a subnormal number or infinity, never as NaN. Numbers and arrays are
    taken, arrays of any shape; inputs are broadcast. float64 and float32 stay what they are,
    integers become float64. `out`: a tuple of arrays to fill. `workers`: threads that share the
    work on long arrays.

    `accurate`: in double-words, tracking_index at least 2^-400 and at most 2^400: proved to be off
    by at most 0.5 + 2^-46 units in the last place (float64), 0.5 + 2^-27 (float32), where the true
    value is a normal number; takes 12 to 20 times as long, in float32 3 times.

    ValueError: an input outside its domain, with its place; `out` or `workers` that does not fit.
    TypeError: an input that is no real number of these types; in `out` what is no array of the
    results' type.

    Source: derivation random-acceleration
    """
    if (
        type(tracking_index) is float
        and 5e-324 <= tracking_index <= 1.7976931348623157e308
        and out is None
        and workers is ONE
        and not accurate
    ):
        try:
            return named(Gains, _gains_of_numbers(tracking_index))
        except (ArithmeticError, ValueError):
            pass  # arrays say what is wrong
    kernel = _ACCURATE_GAINS if accurate else _GAINS
    return Gains(*evaluate(kernel, (tracking_index,), out, workers))


def _gains_of_numbers(tracking_index: float, form: Form = Double) -> tuple[float, ...]:
    t2 = 1.1102230246251565e-16 / tracking_index
    t4 = t2 + 1.3877787807814457e-17
    t7 = form.sqrt(t4) * 1.4901161193847656e-08
    t9 = 2.7755575615628914e-17 / t7
    t16 = ((t9 * (t9 + 2.0)) + 1.5) * 5.551115123125783e-17
    t23 = (t2 * 2.0) + (t7 + 5.551115123125783e-17)
    t25 = 2.220446049250313e-16 / t23
    t28 = form.sqrt(16.0 / (t4 + (t7 + t16))) * 3.725290298461914e-09
    return (t28, t25)


def _gains_block(
    given: Arrays,
    out: Arrays,
    work: Arrays,
    _single: bool,
    n0: float = 1.1102230246251565e-16,
    n1: float = 1.3877787807814457e-17,
    n2: float = 1.4901161193847656e-08,
    n3: float = 2.7755575615628914e-17,
    n4: float = 2.0,
    n5: float = 1.5,
    n6: float = 5.551115123125783e-17,
    n7: float = 16.0,
    n8: float = 2.220446049250313e-16,
    n9: float = 3.725290298461914e-09,
) -> None:
    (tracking_index,) = given
    alpha, beta = out
    w0, w1, w2 = work
    t2 = divide(n0, tracking_index, beta)
    t4 = add(t2, n1, w0)
    rho_scaled = sqrt(t4, alpha)
    t7 = multiply(rho_scaled, n2, alpha)
    t9 = divide(n3, t7, w1)
    t11 = add(t9, n4, w2)
    t12 = multiply(t9, t11, w1)
    t14 = add(t12, n5, w1)
    t16 = multiply(t14, n6, w1)
    t17 = add(t7, t16, w1)
    t18 = add(t4, t17, w0)
    t20 = divide(n7, t18, w0)
    t21 = multiply(t2, n4, beta)
    t22 = add(t7, n6, alpha)
    t23 = add(t21, t22, beta)
    alpha_raised = sqrt(t20, w0)
    divide(n8, t23, beta)
    multiply(alpha_raised, n9, alpha)


_GAINS = Signature(
    "gains",
    (_TRACKING_INDEX_DOMAIN,),
    ("alpha", "beta"),
    3,
    _gains_block,
    numbers=_gains_of_numbers,
)


def _gains_in_double_words(given: Part, form: Form = Double) -> tuple[Part, ...]:
    # loaded when it is asked for
    from gainproof.generated._double_word import add, divide, exact, multiply, root, scale

    if form.single:
        # float64 keeps 29 bits more than come out
        return evaluate(_GAINS, exact(given)[:1], None, 1)
    tracking_index = exact(given)
    kappa = divide((1.1102230246251565e-16, 0.0), tracking_index)
    t4 = add(kappa, (1.3877787807814457e-17, 0.0))
    rho_scaled = root(t4)
    twice_rho = scale(rho_scaled, 1.4901161193847656e-08)
    t9 = add(twice_rho, (5.551115123125783e-17, 0.0))
    t10 = multiply(t9, t9)
    t12 = divide((2.220446049250313e-16, 0.0), t10)
    t13 = multiply(t12, twice_rho)
    t14 = scale(t12, 1.1102230246251565e-16)
    return (t13[0], t14[0])


_ACCURATE_GAINS = Signature(
    "gains",
    (_ACCURATE_TRACKING_INDEX_DOMAIN,),
    ("alpha", "beta"),
    0,
    filled_by(_gains_in_double_words),
    numbers=_gains_in_double_words,
)


def gain_derivatives(
    tracking_index: ArrayLike, *, out: tuple[Real, Real] | None = None, workers: int = 1
) -> GainDerivatives:
    """First derivatives of the filter gain with respect to the tracking index.

        d alpha = 1/(rho sigma^2 Lambda),
        d beta = (2 + 1/rho)/(kappa sigma^2 Lambda)
        kappa = 2/Lambda, rho = sqrt(kappa + 1/4) = alpha/beta,
        sigma = Lambda/beta = Lambda (1/2 + kappa + rho)/2

    tracking_index: Lambda, with Lambda^2 =
        acceleration_deviation**2*sampling_interval**4/measurement_deviation**2; a number above 0
        and finite.

    alpha: derivative of the position gain. Relative error at most 11.01 * 2^-52 (float64), 11.01 *
        2^-23 (float32), proved for 5e-324 <= tracking_index <= 7.11074631974658e102 (float64) and
        1e-45 <= tracking_index <= 8.7960925e12 (float32).
    beta: derivative of the velocity gain times the sampling interval. Relative error at most 10.01
        * 2^-52 (float64), 10.01 * 2^-23 (float32), proved for 5e-324 <= tracking_index <=
        1.8961503816218352e154 (float64) and 1e-45 <= tracking_index <= 2.6087635e19 (float32).

    Outside an output's range, a few numbers next to its ends apart, its true value is no normal
    number: it comes as 0, a subnormal number or infinity, never as NaN. Numbers and arrays are
    taken, arrays of any shape; inputs are broadcast. float64 and float32 stay what they are,
    integers become float64. `out`: a tuple of arrays to fill. `workers`: threads that share the
    work on long arrays.

    ValueError: an input outside its domain, with its place; `out` or `workers` that does not fit.
    TypeError: an input that is no real number of these types; in `out` what is no array of the
    results' type.

    Source: derivation random-acceleration
    """
    if (
        type(tracking_index) is float
        and 5e-324 <= tracking_index <= 1.7976931348623157e308
        and out is None
        and workers is ONE
    ):
        try:
            return named(GainDerivatives, _gain_derivatives_of_numbers(tracking_index))
        except (ArithmeticError, ValueError):
            pass  # arrays say what is wrong
    return GainDerivatives(*evaluate(_GAIN_DERIVATIVES, (tracking_index,), out, workers))


def _gain_derivatives_of_numbers(tracking_index: float, form: Form = Double) -> tuple[float, ...]:
    t2 = 1.1102230246251565e-16 / tracking_index
    t5 = form.sqrt(t2 + 1.3877787807814457e-17)
    t7 = t5 * 1.4901161193847656e-08
    t9 = t7 + 5.551115123125783e-17
    t13 = 2.465190328815662e-32 / (tracking_index * (t9 * t9))
    t15 = (t13 * t13) / t7
    t16 = t15 * t2
    t17 = t15 * t9
    return (t16, t17)


def _gain_derivatives_block(
    given: Arrays,
    out: Arrays,
    work: Arrays,
    _single: bool,
    n0: float = 1.1102230246251565e-16,
    n1: float = 1.3877787807814457e-17,
    n2: float = 1.4901161193847656e-08,
    n3: float = 5.551115123125783e-17,
    n4: float = 2.465190328815662e-32,
) -> None:
    (tracking_index,) = given
    alpha, beta = out
    w0, w1 = work
    kappa = divide(n0, tracking_index, alpha)
    t4 = add(kappa, n1, w0)
    rho_scaled = sqrt(t4, beta)
    twice_rho = multiply(rho_scaled, n2, beta)
    t9 = add(twice_rho, n3, w0)
    t10 = square(t9, w1)
    t11 = multiply(tracking_index, t10, w1)
    t13 = divide(n4, t11, w1)
    t14 = square(t13, w1)
    t15 = divide(t14, twice_rho, w1)
    multiply(t15, kappa, alpha)
    multiply(t15, t9, beta)


_GAIN_DERIVATIVES = Signature(
    "gain_derivatives",
    (_TRACKING_INDEX_DOMAIN,),
    ("alpha", "beta"),
    2,
    _gain_derivatives_block,
    numbers=_gain_derivatives_of_numbers,
)


def gains_with_derivatives(
    tracking_index: ArrayLike, *, out: tuple[Real, Real, Real, Real] | None = None, workers: int = 1
) -> GainsWithDerivatives:
    """Filter gain and its first derivatives in one pass.

        alpha = 2 r/(p + h + r), beta = 4 p/(p + h + r), p = sqrt(Lambda),
        h = 4/p, r = 2 rho p,
        kappa = 2/Lambda, rho = sqrt(kappa + 1/4) = alpha/beta,
        sigma = Lambda/beta = Lambda (1/2 + kappa + rho)/2

    tracking_index: Lambda, with Lambda^2 =
        acceleration_deviation**2*sampling_interval**4/measurement_deviation**2; a number above 0
        and finite.

    alpha: position gain. Relative error at most 3.26 * 2^-52 (float64), 3.26 * 2^-23 (float32),
        proved for 5e-324 <= tracking_index <= 1.7976931348623157e308 (float64) and 1e-45 <=
        tracking_index <= 3.4028235e38 (float32).
    beta: velocity gain times the sampling interval. Relative error at most 3.01 * 2^-52 (float64),
        3.01 * 2^-23 (float32), proved for 2.2250738585072014e-308 <= tracking_index <=
        1.7976931348623157e308 (float64) and 1.1754944e-38 <= tracking_index <= 3.4028235e38
        (float32).
    d_alpha: derivative of the position gain. Relative error at most 8.01 * 2^-52 (float64), 8.01 *
        2^-23 (float32), proved for 5e-324 <= tracking_index <= 7.11074631974658e102 (float64) and
        1e-45 <= tracking_index <= 8.7960925e12 (float32).
    d_beta: derivative of the velocity gain times the sampling interval. Relative error at most 8.13
        * 2^-52 (float64), 8.13 * 2^-23 (float32), proved for 5e-324 <= tracking_index <=
        1.8961503816218352e154 (float64) and 1e-45 <= tracking_index <= 2.6087635e19 (float32).

    Outside an output's range, a few numbers next to its ends apart, its true value is no normal
    number: it comes as 0, a subnormal number or infinity, never as NaN. Numbers and arrays are
    taken, arrays of any shape; inputs are broadcast. float64 and float32 stay what they are,
    integers become float64. `out`: a tuple of arrays to fill. `workers`: threads that share the
    work on long arrays.

    ValueError: an input outside its domain, with its place; `out` or `workers` that does not fit.
    TypeError: an input that is no real number of these types; in `out` what is no array of the
    results' type.

    Source: derivation random-acceleration
    """
    if (
        type(tracking_index) is float
        and 5e-324 <= tracking_index <= 1.7976931348623157e308
        and out is None
        and workers is ONE
    ):
        try:
            return named(GainsWithDerivatives, _gains_with_derivatives_of_numbers(tracking_index))
        except (ArithmeticError, ValueError):
            pass  # arrays say what is wrong
    return GainsWithDerivatives(*evaluate(_GAINS_WITH_DERIVATIVES, (tracking_index,), out, workers))


def _gains_with_derivatives_of_numbers(
    tracking_index: float,
    form: Form = Double,
) -> tuple[float, ...]:
    t1 = form.sqrt(tracking_index)
    t3 = t1 * 0.5
    t9 = form.sqrt((tracking_index * 0.25) + 2.0)
    t12 = ((t3 + (2.0 / t1)) + t9) * 0.5
    t15 = t1 * t12
    t18 = 1.0 / (t15 * t15)
    t13 = t9 / t12
    t14 = t1 / t12
    t20 = t18 / (t1 * t9)
    t23 = t18 * ((t3 / t9) + 1.0)
    return (t13, t14, t20, t23)


def _gains_with_derivatives_block(
    given: Arrays,
    out: Arrays,
    work: Arrays,
    _single: bool,
    n0: float = 0.5,
    n1: float = 2.0,
    n2: float = 0.25,
    n3: float = 1.0,
) -> None:
    (tracking_index,) = given
    alpha, beta, d_alpha, d_beta = out
    w0, w1, w2 = work
    p = sqrt(tracking_index, beta)
    t3 = multiply(p, n0, w0)
    t5 = divide(n1, p, alpha)
    t7 = multiply(tracking_index, n2, w1)
    t8 = add(t7, n1, w1)
    twice_ratio = sqrt(t8, d_alpha)
    t10 = add(t3, t5, alpha)
    t11 = add(t10, twice_ratio, alpha)
    t12 = multiply(t11, n0, w1)
    t15 = multiply(p, t12, alpha)
    t16 = square(t15, alpha)
    t18 = divide(n3, t16, d_beta)
    t19 = multiply(p, twice_ratio, w2)
    t21 = divide(t3, twice_ratio, w0)
    t22 = add(t21, n3, w0)
    divide(twice_ratio, t12, alpha)
    divide(p, t12, beta)
    divide(t18, t19, d_alpha)
    multiply(t18, t22, d_beta)


_GAINS_WITH_DERIVATIVES = Signature(
    "gains_with_derivatives",
    (_TRACKING_INDEX_DOMAIN,),
    ("alpha", "beta", "d_alpha", "d_beta"),
    3,
    _gains_with_derivatives_block,
    numbers=_gains_with_derivatives_of_numbers,
)


def predictor_gains(
    tracking_index: ArrayLike, *, out: tuple[Real, Real] | None = None, workers: int = 1
) -> PredictorGains:
    """Steady-state predictor gain F K.

        kappa = 2/Lambda, rho = sqrt(kappa + 1/4) = alpha/beta,
        sigma = Lambda/beta = Lambda (1/2 + kappa + rho)/2

    tracking_index: Lambda, with Lambda^2 =
        acceleration_deviation**2*sampling_interval**4/measurement_deviation**2; a number above 0
        and finite.

    position: position entry of F K, alpha + beta. Relative error at most 2.32 * 2^-52 (float64),
        2.32 * 2^-23 (float32), proved for 5e-324 <= tracking_index <= 1.7976931348623157e308
        (float64) and 1e-45 <= tracking_index <= 3.4028235e38 (float32).
    velocity: velocity entry of F K times the sampling interval, beta. Relative error at most 1.95 *
        2^-52 (float64), 1.95 * 2^-23 (float32), proved for 2.2250738585072014e-308 <=
        tracking_index <= 1.7976931348623157e308 (float64) and 1.1754944e-38 <= tracking_index <=
        3.4028235e38 (float32).

    Outside an output's range, a few numbers next to its ends apart, its true value is no normal
    number: it comes as 0, a subnormal number or infinity, never as NaN. Numbers and arrays are
    taken, arrays of any shape; inputs are broadcast. float64 and float32 stay what they are,
    integers become float64. `out`: a tuple of arrays to fill. `workers`: threads that share the
    work on long arrays.

    ValueError: an input outside its domain, with its place; `out` or `workers` that does not fit.
    TypeError: an input that is no real number of these types; in `out` what is no array of the
    results' type.

    Source: derivation random-acceleration
    """
    if (
        type(tracking_index) is float
        and 5e-324 <= tracking_index <= 1.7976931348623157e308
        and out is None
        and workers is ONE
    ):
        try:
            return named(PredictorGains, _predictor_gains_of_numbers(tracking_index))
        except (ArithmeticError, ValueError):
            pass  # arrays say what is wrong
    return PredictorGains(*evaluate(_PREDICTOR_GAINS, (tracking_index,), out, workers))


def _predictor_gains_of_numbers(tracking_index: float, form: Form = Double) -> tuple[float, ...]:
    t2 = 1.1102230246251565e-16 / tracking_index
    t4 = t2 + 1.3877787807814457e-17
    t7 = form.sqrt(t4) * 1.4901161193847656e-08
    t9 = 2.7755575615628914e-17 / t7
    t16 = ((t9 * (t9 + 2.0)) + 1.5) * 5.551115123125783e-17
    t23 = (t2 * 2.0) + (t7 + 5.551115123125783e-17)
    t25 = 2.220446049250313e-16 / t23
    t28 = form.sqrt(16.0 / (t4 + (t7 + t16))) * 3.725290298461914e-09
    t29 = t28 + t25
    return (t29, t25)


def _predictor_gains_block(
    given: Arrays,
    out: Arrays,
    work: Arrays,
    _single: bool,
    n0: float = 1.1102230246251565e-16,
    n1: float = 1.3877787807814457e-17,
    n2: float = 1.4901161193847656e-08,
    n3: float = 2.7755575615628914e-17,
    n4: float = 2.0,
    n5: float = 1.5,
    n6: float = 5.551115123125783e-17,
    n7: float = 16.0,
    n8: float = 2.220446049250313e-16,
    n9: float = 3.725290298461914e-09,
) -> None:
    (tracking_index,) = given
    position, velocity = out
    w0, w1, w2 = work
    t2 = divide(n0, tracking_index, velocity)
    t4 = add(t2, n1, w0)
    rho_scaled = sqrt(t4, position)
    t7 = multiply(rho_scaled, n2, position)
    t9 = divide(n3, t7, w1)
    t11 = add(t9, n4, w2)
    t12 = multiply(t9, t11, w1)
    t14 = add(t12, n5, w1)
    t16 = multiply(t14, n6, w1)
    t17 = add(t7, t16, w1)
    t18 = add(t4, t17, w0)
    t20 = divide(n7, t18, w0)
    t21 = multiply(t2, n4, velocity)
    t22 = add(t7, n6, position)
    t23 = add(t21, t22, velocity)
    divide(n8, t23, velocity)
    alpha_raised = sqrt(t20, w0)
    t28 = multiply(alpha_raised, n9, w0)
    add(t28, velocity, position)


_PREDICTOR_GAINS = Signature(
    "predictor_gains",
    (_TRACKING_INDEX_DOMAIN,),
    ("position", "velocity"),
    3,
    _predictor_gains_block,
    numbers=_predictor_gains_of_numbers,
)


def predictor_gain_derivatives(
    tracking_index: ArrayLike, *, out: tuple[Real, Real] | None = None, workers: int = 1
) -> PredictorGainDerivatives:
    """First derivatives of the predictor gain.

        kappa = 2/Lambda, rho = sqrt(kappa + 1/4) = alpha/beta,
        sigma = Lambda/beta = Lambda (1/2 + kappa + rho)/2

    tracking_index: Lambda, with Lambda^2 =
        acceleration_deviation**2*sampling_interval**4/measurement_deviation**2; a number above 0
        and finite.

    position: derivative of the position entry of F K, alpha + beta. Relative error at most 11.54 *
        2^-52 (float64), 11.55 * 2^-23 (float32), proved for 5e-324 <= tracking_index <=
        1.8961503816218352e154 (float64) and 1e-45 <= tracking_index <= 2.6087635e19 (float32).
    velocity: derivative of the velocity entry of F K times the sampling interval, beta. Relative
        error at most 10.01 * 2^-52 (float64), 10.01 * 2^-23 (float32), proved for 5e-324 <=
        tracking_index <= 1.8961503816218352e154 (float64) and 1e-45 <= tracking_index <=
        2.6087635e19 (float32).

    Outside an output's range, a few numbers next to its ends apart, its true value is no normal
    number: it comes as 0, a subnormal number or infinity, never as NaN. Numbers and arrays are
    taken, arrays of any shape; inputs are broadcast. float64 and float32 stay what they are,
    integers become float64. `out`: a tuple of arrays to fill. `workers`: threads that share the
    work on long arrays.

    ValueError: an input outside its domain, with its place; `out` or `workers` that does not fit.
    TypeError: an input that is no real number of these types; in `out` what is no array of the
    results' type.

    Source: derivation random-acceleration
    """
    if (
        type(tracking_index) is float
        and 5e-324 <= tracking_index <= 1.7976931348623157e308
        and out is None
        and workers is ONE
    ):
        try:
            return named(
                PredictorGainDerivatives, _predictor_gain_derivatives_of_numbers(tracking_index)
            )
        except (ArithmeticError, ValueError):
            pass  # arrays say what is wrong
    return PredictorGainDerivatives(
        *evaluate(_PREDICTOR_GAIN_DERIVATIVES, (tracking_index,), out, workers)
    )


def _predictor_gain_derivatives_of_numbers(
    tracking_index: float,
    form: Form = Double,
) -> tuple[float, ...]:
    t2 = 1.1102230246251565e-16 / tracking_index
    t5 = form.sqrt(t2 + 1.3877787807814457e-17)
    t7 = t5 * 1.4901161193847656e-08
    t9 = t7 + 5.551115123125783e-17
    t13 = 2.465190328815662e-32 / (tracking_index * (t9 * t9))
    t15 = (t13 * t13) / t7
    t17 = t15 * t9
    t18 = (t15 * t2) + t17
    return (t18, t17)


def _predictor_gain_derivatives_block(
    given: Arrays,
    out: Arrays,
    work: Arrays,
    _single: bool,
    n0: float = 1.1102230246251565e-16,
    n1: float = 1.3877787807814457e-17,
    n2: float = 1.4901161193847656e-08,
    n3: float = 5.551115123125783e-17,
    n4: float = 2.465190328815662e-32,
) -> None:
    (tracking_index,) = given
    position, velocity = out
    w0, w1 = work
    kappa = divide(n0, tracking_index, velocity)
    t4 = add(kappa, n1, w0)
    rho_scaled = sqrt(t4, position)
    twice_rho = multiply(rho_scaled, n2, position)
    t9 = add(twice_rho, n3, w0)
    t10 = square(t9, w1)
    t11 = multiply(tracking_index, t10, w1)
    t13 = divide(n4, t11, w1)
    t14 = square(t13, w1)
    t15 = divide(t14, twice_rho, w1)
    t16 = multiply(t15, kappa, position)
    multiply(t15, t9, velocity)
    add(t16, velocity, position)


_PREDICTOR_GAIN_DERIVATIVES = Signature(
    "predictor_gain_derivatives",
    (_TRACKING_INDEX_DOMAIN,),
    ("position", "velocity"),
    2,
    _predictor_gain_derivatives_block,
    numbers=_predictor_gain_derivatives_of_numbers,
)


def predicted_covariance(
    tracking_index: ArrayLike, *, out: tuple[Real, Real, Real] | None = None, workers: int = 1
) -> PredictedCovariance:
    """Predicted covariance in units of sigma_v^2 and T.

        predicted_11 = rho Lambda sigma, predicted_12 = Lambda sigma,
        predicted_22 = Lambda^2 (rho + 1/2)
        kappa = 2/Lambda, rho = sqrt(kappa + 1/4) = alpha/beta,
        sigma = Lambda/beta = Lambda (1/2 + kappa + rho)/2

    tracking_index: Lambda, with Lambda^2 =
        acceleration_deviation**2*sampling_interval**4/measurement_deviation**2; a number above 0
        and finite.

    predicted_11: variance of the predicted position over sigma_v^2. Relative error at most 6.01 *
        2^-52 (float64), 7.01 * 2^-23 (float32), proved for 5e-324 <= tracking_index <=
        2.6815615859885e154 (float64) and 1e-45 <= tracking_index <= 3.6893345e19 (float32).
    predicted_12: covariance of predicted position and velocity times T/sigma_v^2. Relative error at
        most 4.51 * 2^-52 (float64), 4.51 * 2^-23 (float32), proved for 2.2250738585072014e-308 <=
        tracking_index <= 1.8961503816218218e154 (float64) and 1.1754944e-38 <= tracking_index <=
        2.6087534e19 (float32).
    predicted_22: variance of the predicted velocity times T^2/sigma_v^2. Relative error at most
        3.51 * 2^-52 (float64), 3.01 * 2^-23 (float32), proved for 6.278939363646863e-206 <=
        tracking_index <= 1.34078079299425e154 (float64) and 4.1033358e-26 <= tracking_index <=
        1.8446673e19 (float32).

    Outside an output's range, a few numbers next to its ends apart, its true value is no normal
    number: it comes as 0, a subnormal number or infinity, never as NaN. Numbers and arrays are
    taken, arrays of any shape; inputs are broadcast. float64 and float32 stay what they are,
    integers become float64. `out`: a tuple of arrays to fill. `workers`: threads that share the
    work on long arrays.

    ValueError: an input outside its domain, with its place; `out` or `workers` that does not fit.
    TypeError: an input that is no real number of these types; in `out` what is no array of the
    results' type.

    Source: derivation random-acceleration
    """
    if (
        type(tracking_index) is float
        and 5e-324 <= tracking_index <= 1.7976931348623157e308
        and out is None
        and workers is ONE
    ):
        try:
            return named(PredictedCovariance, _predicted_covariance_of_numbers(tracking_index))
        except (ArithmeticError, ValueError):
            pass  # arrays say what is wrong
    return PredictedCovariance(*evaluate(_PREDICTED_COVARIANCE, (tracking_index,), out, workers))


def _predicted_covariance_of_numbers(
    tracking_index: float,
    form: Form = Double,
) -> tuple[float, ...]:
    t2 = 1.1102230246251565e-16 / tracking_index
    t5 = form.sqrt(t2 + 1.3877787807814457e-17)
    t7 = t5 * 1.4901161193847656e-08
    t9 = t7 + 5.551115123125783e-17
    t13 = (tracking_index * (t9 * t9)) * 4.056481920730334e31
    t16 = (tracking_index * t7) * 9007199254740992.0
    t21 = tracking_index * (2.220446049250313e-16 / t9)
    t17 = t13 * t16
    t18 = tracking_index * t13
    t23 = t21 + (tracking_index * tracking_index)
    return (t17, t18, t23)


def _predicted_covariance_block(
    given: Arrays,
    out: Arrays,
    work: Arrays,
    _single: bool,
    n0: float = 1.1102230246251565e-16,
    n1: float = 1.3877787807814457e-17,
    n2: float = 1.4901161193847656e-08,
    n3: float = 5.551115123125783e-17,
    n4: float = 4.056481920730334e31,
    n5: float = 9007199254740992.0,
    n6: float = 2.220446049250313e-16,
) -> None:
    (tracking_index,) = given
    predicted_11, predicted_12, predicted_22 = out
    w0, w1 = work
    kappa = divide(n0, tracking_index, predicted_11)
    t4 = add(kappa, n1, predicted_11)
    rho_scaled = sqrt(t4, predicted_12)
    twice_rho = multiply(rho_scaled, n2, predicted_12)
    t9 = add(twice_rho, n3, predicted_11)
    t10 = square(t9, w0)
    t11 = multiply(tracking_index, t10, w0)
    t13 = multiply(t11, n4, w0)
    t14 = multiply(tracking_index, twice_rho, predicted_12)
    t16 = multiply(t14, n5, predicted_12)
    t20 = divide(n6, t9, predicted_22)
    t21 = multiply(tracking_index, t20, predicted_22)
    t22 = square(tracking_index, w1)
    multiply(t13, t16, predicted_11)
    multiply(tracking_index, t13, predicted_12)
    add(t21, t22, predicted_22)


_PREDICTED_COVARIANCE = Signature(
    "predicted_covariance",
    (_TRACKING_INDEX_DOMAIN,),
    ("predicted_11", "predicted_12", "predicted_22"),
    2,
    _predicted_covariance_block,
    numbers=_predicted_covariance_of_numbers,
)


def predicted_covariance_derivatives(
    tracking_index: ArrayLike, *, out: tuple[Real, Real, Real] | None = None, workers: int = 1
) -> PredictedCovarianceDerivatives:
    """First derivatives of the predicted covariance.

        kappa = 2/Lambda, rho = sqrt(kappa + 1/4) = alpha/beta,
        sigma = Lambda/beta = Lambda (1/2 + kappa + rho)/2

    tracking_index: Lambda, with Lambda^2 =
        acceleration_deviation**2*sampling_interval**4/measurement_deviation**2; a number above 0
        and finite.

    predicted_11: derivative of the variance of the predicted position over sigma_v^2. Relative
        error at most 7.51 * 2^-52 (float64), 7.51 * 2^-23 (float32), proved for 5e-324 <=
        tracking_index <= 1.7976931348623157e308 (float64) and 1e-45 <= tracking_index <=
        3.4028235e38 (float32).
    predicted_12: derivative of the covariance of predicted position and velocity times T/sigma_v^2.
        Relative error at most 5.51 * 2^-52 (float64), 5.51 * 2^-23 (float32), proved for 5e-324 <=
        tracking_index <= 1.7976931348622902e308 (float64) and 1e-45 <= tracking_index <=
        3.4027975e38 (float32).
    predicted_22: derivative of the variance of the predicted velocity times T^2/sigma_v^2. Relative
        error at most 4.67 * 2^-52 (float64), 4.67 * 2^-23 (float32), proved for 5e-324 <=
        tracking_index <= 8.988465674311451e307 (float64) and 1e-45 <= tracking_index <=
        1.7013988e38 (float32).

    Outside an output's range, a few numbers next to its ends apart, its true value is no normal
    number: it comes as 0, a subnormal number or infinity, never as NaN. Numbers and arrays are
    taken, arrays of any shape; inputs are broadcast. float64 and float32 stay what they are,
    integers become float64. `out`: a tuple of arrays to fill. `workers`: threads that share the
    work on long arrays.

    ValueError: an input outside its domain, with its place; `out` or `workers` that does not fit.
    TypeError: an input that is no real number of these types; in `out` what is no array of the
    results' type.

    Source: derivation random-acceleration
    """
    if (
        type(tracking_index) is float
        and 5e-324 <= tracking_index <= 1.7976931348623157e308
        and out is None
        and workers is ONE
    ):
        try:
            return named(
                PredictedCovarianceDerivatives,
                _predicted_covariance_derivatives_of_numbers(tracking_index),
            )
        except (ArithmeticError, ValueError):
            pass  # arrays say what is wrong
    return PredictedCovarianceDerivatives(
        *evaluate(_PREDICTED_COVARIANCE_DERIVATIVES, (tracking_index,), out, workers)
    )


def _predicted_covariance_derivatives_of_numbers(
    tracking_index: float,
    form: Form = Double,
) -> tuple[float, ...]:
    t2 = 1.1102230246251565e-16 / tracking_index
    t5 = form.sqrt(t2 + 1.3877787807814457e-17)
    t7 = t5 * 1.4901161193847656e-08
    t10 = t7 + 5.551115123125783e-17
    t14 = (tracking_index * (t10 * t10)) * 4.056481920730334e31
    t16 = t14 * (t10 / t7)
    t24 = (t2 / t10) * (1.1102230246251565e-16 / t7)
    t27 = (2.220446049250313e-16 / t10) * (1.0 + t24)
    t19 = t16 * (t10 * 4503599627370496.0)
    t29 = t27 + (tracking_index * 2.0)
    return (t19, t16, t29)


def _predicted_covariance_derivatives_block(
    given: Arrays,
    out: Arrays,
    work: Arrays,
    _single: bool,
    n0: float = 1.1102230246251565e-16,
    n1: float = 1.3877787807814457e-17,
    n2: float = 1.4901161193847656e-08,
    n3: float = 5.551115123125783e-17,
    n4: float = 4.056481920730334e31,
    n5: float = 4503599627370496.0,
    n6: float = 2.220446049250313e-16,
    n7: float = 1.0,
    n8: float = 2.0,
) -> None:
    (tracking_index,) = given
    predicted_11, predicted_12, predicted_22 = out
    w0, w1, w2 = work
    kappa = divide(n0, tracking_index, predicted_11)
    t4 = add(kappa, n1, w0)
    rho_scaled = sqrt(t4, predicted_12)
    twice_rho = multiply(rho_scaled, n2, w0)
    t10 = add(twice_rho, n3, w1)
    t11 = square(t10, predicted_12)
    t12 = multiply(tracking_index, t11, predicted_12)
    t14 = multiply(t12, n4, predicted_12)
    t15 = divide(t10, twice_rho, predicted_22)
    multiply(t14, t15, predicted_12)
    t18 = multiply(t10, n5, predicted_22)
    t21 = divide(n6, t10, w2)
    t22 = divide(kappa, t10, predicted_11)
    t23 = divide(n0, twice_rho, w0)
    t24 = multiply(t22, t23, predicted_11)
    t26 = add(n7, t24, predicted_11)
    t27 = multiply(t21, t26, w2)
    t28 = multiply(tracking_index, n8, w0)
    multiply(predicted_12, t18, predicted_11)
    add(t27, t28, predicted_22)


_PREDICTED_COVARIANCE_DERIVATIVES = Signature(
    "predicted_covariance_derivatives",
    (_TRACKING_INDEX_DOMAIN,),
    ("predicted_11", "predicted_12", "predicted_22"),
    3,
    _predicted_covariance_derivatives_block,
    numbers=_predicted_covariance_derivatives_of_numbers,
)


def updated_covariance(
    tracking_index: ArrayLike, *, out: tuple[Real, Real, Real] | None = None, workers: int = 1
) -> UpdatedCovariance:
    """Updated covariance in units of sigma_v^2 and T.

        updated_11 = alpha, updated_12 = beta,
        updated_22 = Lambda^2 (rho - 1/2)
        kappa = 2/Lambda, rho = sqrt(kappa + 1/4) = alpha/beta,
        sigma = Lambda/beta = Lambda (1/2 + kappa + rho)/2

    tracking_index: Lambda, with Lambda^2 =
        acceleration_deviation**2*sampling_interval**4/measurement_deviation**2; a number above 0
        and finite.

    updated_11: variance of the updated position over sigma_v^2. Relative error at most 3.51 * 2^-52
        (float64), 3.51 * 2^-23 (float32), proved for 5e-324 <= tracking_index <=
        1.7976931348623157e308 (float64) and 1e-45 <= tracking_index <= 3.4028235e38 (float32).
    updated_12: covariance of updated position and velocity times T/sigma_v^2. Relative error at
        most 4.51 * 2^-52 (float64), 4.51 * 2^-23 (float32), proved for 2.2250738585072014e-308 <=
        tracking_index <= 1.7976931348623157e308 (float64) and 1.1754944e-38 <= tracking_index <=
        3.4028235e38 (float32).
    updated_22: variance of the updated velocity times T^2/sigma_v^2. Relative error at most 2.51 *
        2^-52 (float64), 2.51 * 2^-23 (float32), proved for 6.278939363646863e-206 <= tracking_index
        <= 8.988465674311451e307 (float64) and 4.1033358e-26 <= tracking_index <= 1.7013988e38
        (float32).

    Outside an output's range, a few numbers next to its ends apart, its true value is no normal
    number: it comes as 0, a subnormal number or infinity, never as NaN. Numbers and arrays are
    taken, arrays of any shape; inputs are broadcast. float64 and float32 stay what they are,
    integers become float64. `out`: a tuple of arrays to fill. `workers`: threads that share the
    work on long arrays.

    ValueError: an input outside its domain, with its place; `out` or `workers` that does not fit.
    TypeError: an input that is no real number of these types; in `out` what is no array of the
    results' type.

    Source: derivation random-acceleration
    """
    if (
        type(tracking_index) is float
        and 5e-324 <= tracking_index <= 1.7976931348623157e308
        and out is None
        and workers is ONE
    ):
        try:
            return named(UpdatedCovariance, _updated_covariance_of_numbers(tracking_index))
        except (ArithmeticError, ValueError):
            pass  # arrays say what is wrong
    return UpdatedCovariance(*evaluate(_UPDATED_COVARIANCE, (tracking_index,), out, workers))


def _updated_covariance_of_numbers(tracking_index: float, form: Form = Double) -> tuple[float, ...]:
    t2 = 1.1102230246251565e-16 / tracking_index
    t5 = form.sqrt(t2 + 1.3877787807814457e-17)
    t7 = t5 * 1.4901161193847656e-08
    t9 = t7 + 5.551115123125783e-17
    t12 = 2.220446049250313e-16 / (t9 * t9)
    t13 = t12 * t7
    t14 = t12 * 1.1102230246251565e-16
    t16 = tracking_index * (2.220446049250313e-16 / t9)
    return (t13, t14, t16)


def _updated_covariance_block(
    given: Arrays,
    out: Arrays,
    work: Arrays,
    _single: bool,
    n0: float = 1.1102230246251565e-16,
    n1: float = 1.3877787807814457e-17,
    n2: float = 1.4901161193847656e-08,
    n3: float = 5.551115123125783e-17,
    n4: float = 2.220446049250313e-16,
) -> None:
    (tracking_index,) = given
    updated_11, updated_12, updated_22 = out
    (w0,) = work
    kappa = divide(n0, tracking_index, updated_11)
    t4 = add(kappa, n1, updated_11)
    rho_scaled = sqrt(t4, updated_12)
    twice_rho = multiply(rho_scaled, n2, updated_12)
    t9 = add(twice_rho, n3, updated_11)
    t10 = square(t9, w0)
    t12 = divide(n4, t10, updated_22)
    t15 = divide(n4, t9, w0)
    multiply(t12, twice_rho, updated_11)
    multiply(t12, n0, updated_12)
    multiply(tracking_index, t15, updated_22)


_UPDATED_COVARIANCE = Signature(
    "updated_covariance",
    (_TRACKING_INDEX_DOMAIN,),
    ("updated_11", "updated_12", "updated_22"),
    1,
    _updated_covariance_block,
    numbers=_updated_covariance_of_numbers,
)


def updated_covariance_derivatives(
    tracking_index: ArrayLike, *, out: tuple[Real, Real, Real] | None = None, workers: int = 1
) -> UpdatedCovarianceDerivatives:
    """First derivatives of the updated covariance.

        kappa = 2/Lambda, rho = sqrt(kappa + 1/4) = alpha/beta,
        sigma = Lambda/beta = Lambda (1/2 + kappa + rho)/2

    tracking_index: Lambda, with Lambda^2 =
        acceleration_deviation**2*sampling_interval**4/measurement_deviation**2; a number above 0
        and finite.

    updated_11: derivative of the variance of the updated position over sigma_v^2. Relative error at
        most 11.01 * 2^-52 (float64), 11.01 * 2^-23 (float32), proved for 5e-324 <= tracking_index
        <= 7.11074631974658e102 (float64) and 1e-45 <= tracking_index <= 8.7960925e12 (float32).
    updated_12: derivative of the covariance of updated position and velocity times T/sigma_v^2.
        Relative error at most 10.01 * 2^-52 (float64), 10.01 * 2^-23 (float32), proved for 5e-324
        <= tracking_index <= 1.8961503816218352e154 (float64) and 1e-45 <= tracking_index <=
        2.6087635e19 (float32).
    updated_22: derivative of the variance of the updated velocity times T^2/sigma_v^2. Relative
        error at most 4.17 * 2^-52 (float64), 4.17 * 2^-23 (float32), proved for 5e-324 <=
        tracking_index <= 1.7976931348623157e308 (float64) and 1e-45 <= tracking_index <=
        3.4028235e38 (float32).

    Outside an output's range, a few numbers next to its ends apart, its true value is no normal
    number: it comes as 0, a subnormal number or infinity, never as NaN. Numbers and arrays are
    taken, arrays of any shape; inputs are broadcast. float64 and float32 stay what they are,
    integers become float64. `out`: a tuple of arrays to fill. `workers`: threads that share the
    work on long arrays.

    ValueError: an input outside its domain, with its place; `out` or `workers` that does not fit.
    TypeError: an input that is no real number of these types; in `out` what is no array of the
    results' type.

    Source: derivation random-acceleration
    """
    if (
        type(tracking_index) is float
        and 5e-324 <= tracking_index <= 1.7976931348623157e308
        and out is None
        and workers is ONE
    ):
        try:
            return named(
                UpdatedCovarianceDerivatives,
                _updated_covariance_derivatives_of_numbers(tracking_index),
            )
        except (ArithmeticError, ValueError):
            pass  # arrays say what is wrong
    return UpdatedCovarianceDerivatives(
        *evaluate(_UPDATED_COVARIANCE_DERIVATIVES, (tracking_index,), out, workers)
    )


def _updated_covariance_derivatives_of_numbers(
    tracking_index: float,
    form: Form = Double,
) -> tuple[float, ...]:
    t2 = 1.1102230246251565e-16 / tracking_index
    t5 = form.sqrt(t2 + 1.3877787807814457e-17)
    t7 = t5 * 1.4901161193847656e-08
    t9 = t7 + 5.551115123125783e-17
    t13 = 2.465190328815662e-32 / (tracking_index * (t9 * t9))
    t15 = (t13 * t13) / t7
    t22 = (t2 / t9) * (1.1102230246251565e-16 / t7)
    t16 = t15 * t2
    t17 = t15 * t9
    t25 = (2.220446049250313e-16 / t9) * (1.0 + t22)
    return (t16, t17, t25)


def _updated_covariance_derivatives_block(
    given: Arrays,
    out: Arrays,
    work: Arrays,
    _single: bool,
    n0: float = 1.1102230246251565e-16,
    n1: float = 1.3877787807814457e-17,
    n2: float = 1.4901161193847656e-08,
    n3: float = 5.551115123125783e-17,
    n4: float = 2.465190328815662e-32,
    n5: float = 1.0,
    n6: float = 2.220446049250313e-16,
) -> None:
    (tracking_index,) = given
    updated_11, updated_12, updated_22 = out
    w0, w1, w2 = work
    kappa = divide(n0, tracking_index, updated_11)
    t4 = add(kappa, n1, w0)
    rho_scaled = sqrt(t4, w0)
    twice_rho = multiply(rho_scaled, n2, w0)
    t9 = add(twice_rho, n3, w1)
    t10 = square(t9, w2)
    t11 = multiply(tracking_index, t10, w2)
    t13 = divide(n4, t11, w2)
    t14 = square(t13, w2)
    t15 = divide(t14, twice_rho, updated_12)
    t20 = divide(kappa, t9, w2)
    t21 = divide(n0, twice_rho, w0)
    t22 = multiply(t20, t21, w2)
    t24 = add(n5, t22, w2)
    multiply(t15, kappa, updated_11)
    multiply(t15, t9, updated_12)
    t19 = divide(n6, t9, updated_22)
    multiply(t19, t24, updated_22)


_UPDATED_COVARIANCE_DERIVATIVES = Signature(
    "updated_covariance_derivatives",
    (_TRACKING_INDEX_DOMAIN,),
    ("updated_11", "updated_12", "updated_22"),
    3,
    _updated_covariance_derivatives_block,
    numbers=_updated_covariance_derivatives_of_numbers,
)


def gain_second_derivatives(
    tracking_index: ArrayLike, *, out: tuple[Real, Real] | None = None, workers: int = 1
) -> GainSecondDerivatives:
    """Second derivatives of the filter gain, both negative.

        d2 alpha = -psi (psi + chi)/(sigma Lambda)^2, d2 beta negative, too.
        psi = (1 + e/(2 kappa))/rho with e = 0: sigma^2 grows like this power of Lambda, and psi
        itself like the power 1 - chi.
        kappa = 2/Lambda, rho = sqrt(kappa + 1/4) = alpha/beta,
        sigma = Lambda/beta = Lambda (1/2 + kappa + rho)/2

    tracking_index: Lambda, with Lambda^2 =
        acceleration_deviation**2*sampling_interval**4/measurement_deviation**2; a number above 0
        and finite.

    alpha: second derivative by Lambda of the position gain. Relative error at most 15.01 * 2^-52
        (float64), 15.01 * 2^-23 (float32), proved for 1.5697348409117308e-206 <= tracking_index <=
        1.8122441335979363e77 (float64) and 1.0258392e-26 <= tracking_index <= 6.721987e09
        (float32).
    beta: second derivative by Lambda of the velocity gain times the sampling interval. Relative
        error at most 13.01 * 2^-52 (float64), 13.01 * 2^-23 (float32), proved for 5e-324 <=
        tracking_index <= 8.958978968711217e102 (float64) and 1e-45 <= tracking_index <=
        1.1082382e13 (float32).

    Outside an output's range, a few numbers next to its ends apart, its true value is no normal
    number: it comes as 0, a subnormal number or infinity, never as NaN. Numbers and arrays are
    taken, arrays of any shape; inputs are broadcast. float64 and float32 stay what they are,
    integers become float64. `out`: a tuple of arrays to fill. `workers`: threads that share the
    work on long arrays.

    ValueError: an input outside its domain, with its place; `out` or `workers` that does not fit.
    TypeError: an input that is no real number of these types; in `out` what is no array of the
    results' type.

    Source: derivation random-acceleration
    """
    if (
        type(tracking_index) is float
        and 5e-324 <= tracking_index <= 1.7976931348623157e308
        and out is None
        and workers is ONE
    ):
        try:
            return named(GainSecondDerivatives, _gain_second_derivatives_of_numbers(tracking_index))
        except (ArithmeticError, ValueError):
            pass  # arrays say what is wrong
    return GainSecondDerivatives(
        *evaluate(_GAIN_SECOND_DERIVATIVES, (tracking_index,), out, workers)
    )


def _gain_second_derivatives_of_numbers(
    tracking_index: float,
    form: Form = Double,
) -> tuple[float, ...]:
    t2 = 1.1102230246251565e-16 / tracking_index
    t4 = t2 + 1.3877787807814457e-17
    t7 = form.sqrt(t4) * 1.4901161193847656e-08
    t9 = 1.1102230246251565e-16 / t7
    t11 = t7 + 5.551115123125783e-17
    t15 = 2.465190328815662e-32 / (tracking_index * (t11 * t11))
    t16 = t15 / tracking_index
    t21 = ((t2 + 2.7755575615628914e-17) / t4) * 0.5
    t34 = t15 * (((2.0 + t9) * (6.0 + t9)) * 0.0625)
    t25 = -((t9 * t16) * ((t9 + t21) * t16))
    t36 = -((t15 * (t2 / t7)) * t34)
    return (t25, t36)


def _gain_second_derivatives_block(
    given: Arrays,
    out: Arrays,
    work: Arrays,
    _single: bool,
    n0: float = 1.1102230246251565e-16,
    n1: float = 1.3877787807814457e-17,
    n2: float = 1.4901161193847656e-08,
    n3: float = 5.551115123125783e-17,
    n4: float = 2.465190328815662e-32,
    n5: float = 2.7755575615628914e-17,
    n6: float = 0.5,
    n7: float = 2.0,
    n8: float = 6.0,
    n9: float = 0.0625,
) -> None:
    (tracking_index,) = given
    alpha, beta = out
    w0, w1, w2, w3, w4, w5 = work
    kappa = divide(n0, tracking_index, alpha)
    t4 = add(kappa, n1, w0)
    rho_scaled = sqrt(t4, beta)
    twice_rho = multiply(rho_scaled, n2, beta)
    t9 = divide(n0, twice_rho, w1)
    t11 = add(twice_rho, n3, w2)
    t12 = square(t11, w2)
    t13 = multiply(tracking_index, t12, w2)
    t15 = divide(n4, t13, w2)
    t16 = divide(t15, tracking_index, w3)
    t17 = multiply(t9, t16, w4)
    t19 = add(kappa, n5, w5)
    t20 = divide(t19, t4, w5)
    t21 = multiply(t20, n6, w5)
    t22 = add(t9, t21, w5)
    t23 = multiply(t22, t16, w5)
    t24 = multiply(t17, t23, w4)
    t26 = divide(kappa, twice_rho, alpha)
    t27 = multiply(t15, t26, alpha)
    t28 = add(n7, t9, w0)
    t30 = add(n8, t9, w1)
    t31 = multiply(t28, t30, w0)
    t33 = multiply(t31, n9, w0)
    t34 = multiply(t15, t33, w2)
    t35 = multiply(t27, t34, w2)
    negative(t24, alpha)
    negative(t35, beta)


_GAIN_SECOND_DERIVATIVES = Signature(
    "gain_second_derivatives",
    (_TRACKING_INDEX_DOMAIN,),
    ("alpha", "beta"),
    6,
    _gain_second_derivatives_block,
    numbers=_gain_second_derivatives_of_numbers,
)


def predictor_gain_second_derivatives(
    tracking_index: ArrayLike, *, out: tuple[Real, Real] | None = None, workers: int = 1
) -> PredictorGainSecondDerivatives:
    """Second derivatives of the predictor gain.

        d2 (alpha + beta), d2 beta; both negative.
        kappa = 2/Lambda, rho = sqrt(kappa + 1/4) = alpha/beta,
        sigma = Lambda/beta = Lambda (1/2 + kappa + rho)/2

    tracking_index: Lambda, with Lambda^2 =
        acceleration_deviation**2*sampling_interval**4/measurement_deviation**2; a number above 0
        and finite.

    position: second derivative by Lambda of the position entry of F K, alpha + beta. Relative error
        at most 15.53 * 2^-52 (float64), 15.51 * 2^-23 (float32), proved for 1.5697348409117308e-206
        <= tracking_index <= 8.958978968711217e102 (float64) and 1.0258392e-26 <= tracking_index <=
        1.1082382e13 (float32).
    velocity: second derivative by Lambda of the velocity entry of F K times the sampling interval,
        beta. Relative error at most 13.01 * 2^-52 (float64), 13.01 * 2^-23 (float32), proved for
        5e-324 <= tracking_index <= 8.958978968711217e102 (float64) and 1e-45 <= tracking_index <=
        1.1082382e13 (float32).

    Outside an output's range, a few numbers next to its ends apart, its true value is no normal
    number: it comes as 0, a subnormal number or infinity, never as NaN. Numbers and arrays are
    taken, arrays of any shape; inputs are broadcast. float64 and float32 stay what they are,
    integers become float64. `out`: a tuple of arrays to fill. `workers`: threads that share the
    work on long arrays.

    ValueError: an input outside its domain, with its place; `out` or `workers` that does not fit.
    TypeError: an input that is no real number of these types; in `out` what is no array of the
    results' type.

    Source: derivation random-acceleration
    """
    if (
        type(tracking_index) is float
        and 5e-324 <= tracking_index <= 1.7976931348623157e308
        and out is None
        and workers is ONE
    ):
        try:
            return named(
                PredictorGainSecondDerivatives,
                _predictor_gain_second_derivatives_of_numbers(tracking_index),
            )
        except (ArithmeticError, ValueError):
            pass  # arrays say what is wrong
    return PredictorGainSecondDerivatives(
        *evaluate(_PREDICTOR_GAIN_SECOND_DERIVATIVES, (tracking_index,), out, workers)
    )


def _predictor_gain_second_derivatives_of_numbers(
    tracking_index: float,
    form: Form = Double,
) -> tuple[float, ...]:
    t2 = 1.1102230246251565e-16 / tracking_index
    t4 = t2 + 1.3877787807814457e-17
    t7 = form.sqrt(t4) * 1.4901161193847656e-08
    t9 = 1.1102230246251565e-16 / t7
    t11 = t7 + 5.551115123125783e-17
    t15 = 2.465190328815662e-32 / (tracking_index * (t11 * t11))
    t16 = t15 / tracking_index
    t21 = ((t2 + 2.7755575615628914e-17) / t4) * 0.5
    t33 = t15 * (((2.0 + t9) * (6.0 + t9)) * 0.0625)
    t34 = (t15 * (t2 / t7)) * t33
    t35 = ((t9 * t16) * ((t9 + t21) * t16)) + t34
    t36 = -t35
    t37 = -t34
    return (t36, t37)


def _predictor_gain_second_derivatives_block(
    given: Arrays,
    out: Arrays,
    work: Arrays,
    _single: bool,
    n0: float = 1.1102230246251565e-16,
    n1: float = 1.3877787807814457e-17,
    n2: float = 1.4901161193847656e-08,
    n3: float = 5.551115123125783e-17,
    n4: float = 2.465190328815662e-32,
    n5: float = 2.7755575615628914e-17,
    n6: float = 0.5,
    n7: float = 2.0,
    n8: float = 6.0,
    n9: float = 0.0625,
) -> None:
    (tracking_index,) = given
    position, velocity = out
    w0, w1, w2, w3, w4, w5 = work
    kappa = divide(n0, tracking_index, position)
    t4 = add(kappa, n1, w0)
    rho_scaled = sqrt(t4, velocity)
    twice_rho = multiply(rho_scaled, n2, velocity)
    t9 = divide(n0, twice_rho, w1)
    t11 = add(twice_rho, n3, w2)
    t12 = square(t11, w2)
    t13 = multiply(tracking_index, t12, w2)
    t15 = divide(n4, t13, w2)
    t16 = divide(t15, tracking_index, w3)
    t17 = multiply(t9, t16, w4)
    t19 = add(kappa, n5, w5)
    t20 = divide(t19, t4, w5)
    t21 = multiply(t20, n6, w5)
    t22 = add(t9, t21, w5)
    t23 = multiply(t22, t16, w5)
    t24 = multiply(t17, t23, w4)
    t25 = divide(kappa, twice_rho, position)
    t26 = multiply(t15, t25, position)
    t27 = add(n7, t9, w0)
    t29 = add(n8, t9, w1)
    t30 = multiply(t27, t29, w0)
    t32 = multiply(t30, n9, w0)
    t33 = multiply(t15, t32, w2)
    t34 = multiply(t26, t33, w2)
    t35 = add(t24, t34, w4)
    negative(t35, position)
    negative(t34, velocity)


_PREDICTOR_GAIN_SECOND_DERIVATIVES = Signature(
    "predictor_gain_second_derivatives",
    (_TRACKING_INDEX_DOMAIN,),
    ("position", "velocity"),
    6,
    _predictor_gain_second_derivatives_block,
    numbers=_predictor_gain_second_derivatives_of_numbers,
)


def predicted_covariance_second_derivatives(
    tracking_index: ArrayLike, *, out: tuple[Real, Real, Real] | None = None, workers: int = 1
) -> PredictedCovarianceSecondDerivatives:
    """Second derivatives of the predicted covariance.

        d2 M11 = (sigma/Lambda)^2 psi (psi - chi), first negative, then positive.
        d2 M12 = (sigma/Lambda) (psi/2) (2 + psi/2 - chi), d2 M22 = 2 + d2 X22.
        psi = (1 + e/(2 kappa))/rho with e = 0: sigma^2 grows like this power of Lambda, and psi
        itself like the power 1 - chi.
        It is a product with Lambda - 4/(3 + 2 sqrt(3)), which keeps its digits.
        kappa = 2/Lambda, rho = sqrt(kappa + 1/4) = alpha/beta,
        sigma = Lambda/beta = Lambda (1/2 + kappa + rho)/2

    tracking_index: Lambda, with Lambda^2 =
        acceleration_deviation**2*sampling_interval**4/measurement_deviation**2; a number above 0
        and finite.

    predicted_11: second derivative by Lambda of the variance of the predicted position over
        sigma_v^2. Relative error at most 10.09 * 2^-52 (float64), 10.25 * 2^-23 (float32), proved
        for 1.5697348409117308e-206 <= tracking_index <= 1.7976931348623157e308 (float64) and
        1.0258392e-26 <= tracking_index <= 3.4028235e38 (float32).
    predicted_12: second derivative by Lambda of the covariance of predicted position and velocity
        times T/sigma_v^2. Relative error at most 3.88 * 2^-52 (float64), 3.88 * 2^-23 (float32),
        proved for 5e-324 <= tracking_index <= 1.7976931348623157e308 (float64) and 1e-45 <=
        tracking_index <= 3.4028235e38 (float32).
    predicted_22: second derivative by Lambda of the variance of the predicted velocity times
        T^2/sigma_v^2. Relative error at most 9.51 * 2^-52 (float64), 9.51 * 2^-23 (float32), proved
        for 5e-324 <= tracking_index <= 1.7976931348623157e308 (float64) and 1e-45 <= tracking_index
        <= 3.4028235e38 (float32).

    Outside an output's range, a few numbers next to its ends apart, its true value is no normal
    number: it comes as 0, a subnormal number or infinity, never as NaN. Numbers and arrays are
    taken, arrays of any shape; inputs are broadcast. float64 and float32 stay what they are,
    integers become float64. `out`: a tuple of arrays to fill. `workers`: threads that share the
    work on long arrays.

    ValueError: an input outside its domain, with its place; `out` or `workers` that does not fit.
    TypeError: an input that is no real number of these types; in `out` what is no array of the
    results' type.

    Source: derivation random-acceleration
    """
    if (
        type(tracking_index) is float
        and 5e-324 <= tracking_index <= 1.7976931348623157e308
        and out is None
        and workers is ONE
    ):
        try:
            return named(
                PredictedCovarianceSecondDerivatives,
                _predicted_covariance_second_derivatives_of_numbers(tracking_index),
            )
        except (ArithmeticError, ValueError):
            pass  # arrays say what is wrong
    return PredictedCovarianceSecondDerivatives(
        *evaluate(_PREDICTED_COVARIANCE_SECOND_DERIVATIVES, (tracking_index,), out, workers)
    )


def _predicted_covariance_second_derivatives_of_numbers(
    tracking_index: float,
    form: Form = Double,
) -> tuple[float, ...]:
    t3 = 1.1102230246251565e-16 / tracking_index
    t5 = t3 + 1.3877787807814457e-17
    t6 = form.sqrt(t5)
    t8 = t6 * 7.450580596923828e-09
    t10 = t6 * 1.4901161193847656e-08
    t14 = (tracking_index + -0.6188021535170061) + (
        -2.329468529183032e-08 if form.single else -4.555764098981943e-17
    )
    t17 = (t14 * 0.20200317547305482) / tracking_index
    t19 = t10 + 5.551115123125783e-17
    t23 = 1.1102230246251565e-16 / t10
    t24 = 2.0 + t23
    t31 = t3 / (t8 + 2.7755575615628914e-17)
    t37 = (t31 + 0.36602540378443865) / (t31 + 2.366025403784439)
    t47 = (1.0 + (t23 * 0.5)) + ((t3 / t5) * 0.5)
    t51 = t3 / (t5 + (t8 * 0.5))
    t57 = (t51 * t51) * (t51 * (((t31 * 3.0) + 2.0) * 0.25))
    t39 = (t17 * (t19 * 1.8014398509481984e16)) * (((t24 * t24) * (t24 * 0.125)) * t37)
    t48 = (t24 * (t19 * 1125899906842624.0)) * t47
    t58 = t57 + 2.0
    return (t39, t48, t58)


def _predicted_covariance_second_derivatives_block(
    given: Arrays,
    out: Arrays,
    work: Arrays,
    single: bool,
    n0: float = 1.1102230246251565e-16,
    n1: float = 1.3877787807814457e-17,
    n2: float = 7.450580596923828e-09,
    n3: float = 1.4901161193847656e-08,
    n4: float = -0.6188021535170061,
    n5: float = -2.329468529183032e-08,
    n6: float = -4.555764098981943e-17,
    n7: float = 0.20200317547305482,
    n8: float = 5.551115123125783e-17,
    n9: float = 1.8014398509481984e16,
    n10: float = 2.0,
    n11: float = 0.125,
    n12: float = 2.7755575615628914e-17,
    n13: float = 0.36602540378443865,
    n14: float = 2.366025403784439,
    n15: float = 1125899906842624.0,
    n16: float = 0.5,
    n17: float = 1.0,
    n18: float = 3.0,
    n19: float = 0.25,
) -> None:
    (tracking_index,) = given
    predicted_11, predicted_12, predicted_22 = out
    w0, w1, w2, w3, w4, w5, w6, w7 = work
    kappa = divide(n0, tracking_index, predicted_11)
    t5 = add(kappa, n1, w0)
    rho_scaled = sqrt(t5, predicted_12)
    rho = multiply(rho_scaled, n2, w1)
    twice_rho = multiply(rho_scaled, n3, predicted_12)
    rest = n5 if single else n6
    add(tracking_index, n4, w2)
    t14 = add(w2, rest, w2)
    t16 = multiply(t14, n7, w2)
    t17 = divide(t16, tracking_index, predicted_22)
    t19 = add(twice_rho, n8, w2)
    t21 = multiply(t19, n9, w3)
    t22 = multiply(t17, t21, predicted_22)
    t23 = divide(n0, twice_rho, predicted_12)
    t24 = add(n10, t23, w3)
    t25 = square(t24, w4)
    t27 = multiply(t24, n11, w5)
    t28 = multiply(t25, t27, w4)
    t30 = add(rho, n12, w5)
    t31 = divide(kappa, t30, w5)
    t34 = add(t31, n13, w6)
    t36 = add(t31, n14, w7)
    t37 = divide(t34, t36, w6)
    t38 = multiply(t28, t37, w4)
    t41 = multiply(t19, n15, w2)
    t42 = multiply(t24, t41, w3)
    t43 = multiply(t23, n16, predicted_12)
    t44 = add(n17, t43, predicted_12)
    t45 = divide(kappa, t5, w2)
    t46 = multiply(t45, n16, w2)
    t47 = add(t44, t46, predicted_12)
    t49 = multiply(rho, n16, w1)
    t50 = add(t5, t49, w0)
    t51 = divide(kappa, t50, predicted_11)
    t52 = square(t51, w0)
    t53 = multiply(t31, n18, w5)
    t54 = add(t53, n10, w5)
    t55 = multiply(t54, n19, w5)
    t56 = multiply(t51, t55, predicted_11)
    t57 = multiply(t52, t56, w0)
    multiply(t22, t38, predicted_11)
    multiply(t42, t47, predicted_12)
    add(t57, n10, predicted_22)


_PREDICTED_COVARIANCE_SECOND_DERIVATIVES = Signature(
    "predicted_covariance_second_derivatives",
    (_TRACKING_INDEX_DOMAIN,),
    ("predicted_11", "predicted_12", "predicted_22"),
    8,
    _predicted_covariance_second_derivatives_block,
    numbers=_predicted_covariance_second_derivatives_of_numbers,
)


def updated_covariance_second_derivatives(
    tracking_index: ArrayLike, *, out: tuple[Real, Real, Real] | None = None, workers: int = 1
) -> UpdatedCovarianceSecondDerivatives:
    """Second derivatives of the updated covariance.

        X11 = alpha and X12 = beta bend down, X22 bends up.
        kappa = 2/Lambda, rho = sqrt(kappa + 1/4) = alpha/beta,
        sigma = Lambda/beta = Lambda (1/2 + kappa + rho)/2

    tracking_index: Lambda, with Lambda^2 =
        acceleration_deviation**2*sampling_interval**4/measurement_deviation**2; a number above 0
        and finite.

    updated_11: second derivative by Lambda of the variance of the updated position over sigma_v^2.
        Relative error at most 15.01 * 2^-52 (float64), 15.01 * 2^-23 (float32), proved for
        1.5697348409117308e-206 <= tracking_index <= 1.8122441335979363e77 (float64) and
        1.0258392e-26 <= tracking_index <= 6.721987e09 (float32).
    updated_12: second derivative by Lambda of the covariance of updated position and velocity times
        T/sigma_v^2. Relative error at most 13.01 * 2^-52 (float64), 13.01 * 2^-23 (float32), proved
        for 5e-324 <= tracking_index <= 8.958978968711217e102 (float64) and 1e-45 <= tracking_index
        <= 1.1082382e13 (float32).
    updated_22: second derivative by Lambda of the variance of the updated velocity times
        T^2/sigma_v^2. Relative error at most 9.01 * 2^-52 (float64), 9.01 * 2^-23 (float32), proved
        for 5e-324 <= tracking_index <= 1.1287606188244725e103 (float64) and 1e-45 <= tracking_index
        <= 1.3962927e13 (float32).

    Outside an output's range, a few numbers next to its ends apart, its true value is no normal
    number: it comes as 0, a subnormal number or infinity, never as NaN. Numbers and arrays are
    taken, arrays of any shape; inputs are broadcast. float64 and float32 stay what they are,
    integers become float64. `out`: a tuple of arrays to fill. `workers`: threads that share the
    work on long arrays.

    ValueError: an input outside its domain, with its place; `out` or `workers` that does not fit.
    TypeError: an input that is no real number of these types; in `out` what is no array of the
    results' type.

    Source: derivation random-acceleration
    """
    if (
        type(tracking_index) is float
        and 5e-324 <= tracking_index <= 1.7976931348623157e308
        and out is None
        and workers is ONE
    ):
        try:
            return named(
                UpdatedCovarianceSecondDerivatives,
                _updated_covariance_second_derivatives_of_numbers(tracking_index),
            )
        except (ArithmeticError, ValueError):
            pass  # arrays say what is wrong
    return UpdatedCovarianceSecondDerivatives(
        *evaluate(_UPDATED_COVARIANCE_SECOND_DERIVATIVES, (tracking_index,), out, workers)
    )


def _updated_covariance_second_derivatives_of_numbers(
    tracking_index: float,
    form: Form = Double,
) -> tuple[float, ...]:
    t3 = 1.1102230246251565e-16 / tracking_index
    t5 = t3 + 1.3877787807814457e-17
    t6 = form.sqrt(t5)
    t8 = t6 * 7.450580596923828e-09
    t10 = t6 * 1.4901161193847656e-08
    t12 = 1.1102230246251565e-16 / t10
    t14 = t10 + 5.551115123125783e-17
    t18 = 2.465190328815662e-32 / (tracking_index * (t14 * t14))
    t19 = t18 / tracking_index
    t24 = ((t3 + 2.7755575615628914e-17) / t5) * 0.5
    t37 = t18 * (((2.0 + t12) * (6.0 + t12)) * 0.0625)
    t42 = t3 / (t5 + (t8 * 0.5))
    t46 = (t3 / (t8 + 2.7755575615628914e-17)) * 3.0
    t28 = -((t12 * t19) * ((t12 + t24) * t19))
    t39 = -((t18 * (t3 / t10)) * t37)
    t51 = (t42 * t42) * (t42 * ((t46 + 2.0) * 0.25))
    return (t28, t39, t51)


def _updated_covariance_second_derivatives_block(
    given: Arrays,
    out: Arrays,
    work: Arrays,
    _single: bool,
    n0: float = 1.1102230246251565e-16,
    n1: float = 1.3877787807814457e-17,
    n2: float = 7.450580596923828e-09,
    n3: float = 1.4901161193847656e-08,
    n4: float = 5.551115123125783e-17,
    n5: float = 2.465190328815662e-32,
    n6: float = 2.7755575615628914e-17,
    n7: float = 0.5,
    n8: float = 2.0,
    n9: float = 6.0,
    n10: float = 0.0625,
    n11: float = 3.0,
    n12: float = 0.25,
) -> None:
    (tracking_index,) = given
    updated_11, updated_12, updated_22 = out
    w0, w1, w2, w3, w4, w5 = work
    kappa = divide(n0, tracking_index, updated_11)
    t5 = add(kappa, n1, w0)
    rho_scaled = sqrt(t5, updated_12)
    rho = multiply(rho_scaled, n2, w1)
    twice_rho = multiply(rho_scaled, n3, updated_12)
    t12 = divide(n0, twice_rho, updated_22)
    t14 = add(twice_rho, n4, w2)
    t15 = square(t14, w2)
    t16 = multiply(tracking_index, t15, w2)
    t18 = divide(n5, t16, w2)
    t19 = divide(t18, tracking_index, w3)
    t20 = multiply(t12, t19, w4)
    t22 = add(kappa, n6, w5)
    t23 = divide(t22, t5, w5)
    t24 = multiply(t23, n7, w5)
    t25 = add(t12, t24, w5)
    t26 = multiply(t25, t19, w5)
    t27 = multiply(t20, t26, w4)
    t29 = divide(kappa, twice_rho, updated_12)
    t30 = multiply(t18, t29, updated_12)
    t31 = add(n8, t12, w3)
    t33 = add(n9, t12, updated_22)
    t34 = multiply(t31, t33, w3)
    t36 = multiply(t34, n10, w3)
    t37 = multiply(t18, t36, w2)
    t38 = multiply(t30, t37, updated_12)
    t40 = multiply(rho, n7, w2)
    t41 = add(t5, t40, w0)
    t42 = divide(kappa, t41, w0)
    t43 = square(t42, w2)
    t44 = add(rho, n6, w1)
    t45 = divide(kappa, t44, updated_11)
    t46 = multiply(t45, n11, updated_11)
    t47 = add(t46, n8, updated_11)
    t49 = multiply(t47, n12, updated_11)
    t50 = multiply(t42, t49, w0)
    negative(t27, updated_11)
    negative(t38, updated_12)
    multiply(t43, t50, updated_22)


_UPDATED_COVARIANCE_SECOND_DERIVATIVES = Signature(
    "updated_covariance_second_derivatives",
    (_TRACKING_INDEX_DOMAIN,),
    ("updated_11", "updated_12", "updated_22"),
    6,
    _updated_covariance_second_derivatives_block,
    numbers=_updated_covariance_second_derivatives_of_numbers,
)


def closed_loop_poles(
    tracking_index: ArrayLike, *, out: tuple[Real, Real, Real, Real] | None = None, workers: int = 1
) -> ClosedLoopPoles:
    """Poles of the filter: a complex pair or two real numbers.

        z^2 - (2 - alpha - beta) z + (1 - alpha) = 0; first_modulus and second_modulus are
        the moduli of the poles;
        all poles lie inside the unit circle; rounded, a real part may come as 1 + 2^-52
        kappa = 2/Lambda, rho = sqrt(kappa + 1/4) = alpha/beta,
        sigma = Lambda/beta = Lambda (1/2 + kappa + rho)/2

    tracking_index: Lambda, with Lambda^2 =
        acceleration_deviation**2*sampling_interval**4/measurement_deviation**2; a number above 0
        and finite.

    first_real: real part of the first pole. Error over first_modulus at most 8.52 * 2^-52
        (float64), 8.51 * 2^-23 (float32), proved for 5e-324 <= tracking_index <=
        1.7976931348623157e308 (float64) and 1e-45 <= tracking_index <= 3.4028235e38 (float32).
        Digits that can be lost: up to 3.3 of 16 in float64; up to 1.8 of 7 in float32, a quarter or
        more only where 2.4 <= tracking_index <= 5.6.
    first_imaginary: imaginary part of the first pole, not negative. Error over first_modulus at
        most 7.61 * 2^-52 (float64), 7.61 * 2^-23 (float32), proved for 5e-324 <= tracking_index <=
        1.7976931348623157e308 (float64) and 1e-45 <= tracking_index <= 3.4028235e38 (float32).
        Digits that can be lost: up to 16 of 16 in float64, half or more only where tracking_index
        <= 8.4e-14; up to 7 of 7 in float32, half or more only where tracking_index <= 7.4e-5.
    second_real: real part of the second pole. Error over second_modulus at most 8.58 * 2^-52
        (float64), 8.58 * 2^-23 (float32), proved for 5e-324 <= tracking_index <=
        1.3407807929942597e154 (float64) and 1e-45 <= tracking_index <= 1.8446744e19 (float32).
        Digits that can be lost: up to 3.2 of 16 in float64; up to 2 of 7 in float32, a quarter or
        more only where 2.2 <= tracking_index <= 5.6.
    second_imaginary: imaginary part of the second pole, not positive. Error over second_modulus at
        most 7.61 * 2^-52 (float64), 7.61 * 2^-23 (float32), proved for 5e-324 <= tracking_index <=
        1.3407807929942597e154 (float64) and 1e-45 <= tracking_index <= 1.8446744e19 (float32).
        Digits that can be lost: up to 16 of 16 in float64, half or more only where tracking_index
        <= 9.6e-14; up to 7 of 7 in float32, half or more only where tracking_index <= 9.4e-5.

    Outside an output's range, a few numbers next to its ends apart, its true value is no normal
    number: it comes as 0, a subnormal number or infinity, never as NaN. Numbers and arrays are
    taken, arrays of any shape; inputs are broadcast. float64 and float32 stay what they are,
    integers become float64. `out`: a tuple of arrays to fill. `workers`: threads that share the
    work on long arrays.

    ValueError: an input outside its domain, with its place; `out` or `workers` that does not fit.
    TypeError: an input that is no real number of these types; in `out` what is no array of the
    results' type.

    Source: derivation random-acceleration
    """
    if (
        type(tracking_index) is float
        and 5e-324 <= tracking_index <= 1.7976931348623157e308
        and out is None
        and workers is ONE
    ):
        try:
            return named(ClosedLoopPoles, _closed_loop_poles_of_numbers(tracking_index))
        except (ArithmeticError, ValueError):
            pass  # arrays say what is wrong
    return ClosedLoopPoles(*evaluate(_CLOSED_LOOP_POLES, (tracking_index,), out, workers))


def _closed_loop_poles_of_numbers(tracking_index: float, form: Form = Double) -> tuple[float, ...]:
    t2 = 1.1102230246251565e-16 / tracking_index
    t5 = form.sqrt(t2 + 1.3877787807814457e-17)
    t13 = tracking_index * 0.25
    t19 = tracking_index * 0.5
    t23 = tracking_index * (t2 + 2.7755575615628914e-17)
    t27 = (t5 * 1.4901161193847656e-08) + 5.551115123125783e-17
    t31 = 2.465190328815662e-32 / (tracking_index * (t27 * t27))
    t33 = ((2.0 - t19) / t23) * ((2.0 + t19) * t31)
    t34 = t33 * 2.7755575615628914e-17
    t35 = form.sqrt(abs(2.0 - t13)) / (t5 * 7.450580596923828e-09)
    t38 = (t35 * (form.sqrt(2.0 + t13) * t31)) * 2.7755575615628914e-17
    t40 = abs(t34) + t38
    t45 = t34 if tracking_index < 8.0 else -t40
    t47 = t34 if tracking_index < 8.0 else -((t31 / t40) * t31)
    t48 = t38 if tracking_index < 8.0 else form.of(0.0)
    t50 = -t38 if tracking_index < 8.0 else form.of(0.0)
    return (t45, t48, t47, t50)


def _closed_loop_poles_block(
    given: Arrays,
    out: Arrays,
    work: Arrays,
    single: bool,
    n0: float = 1.1102230246251565e-16,
    n1: float = 1.3877787807814457e-17,
    n2: float = 7.450580596923828e-09,
    n3: float = 1.4901161193847656e-08,
    n4: float = 0.25,
    n5: float = 2.0,
    n6: float = 0.5,
    n7: float = 2.7755575615628914e-17,
    n8: float = 5.551115123125783e-17,
    n9: float = 2.465190328815662e-32,
    n10: float = 8.0,
    n11: float = 0.0,
) -> None:
    (tracking_index,) = given
    first_real, first_imaginary, second_real, second_imaginary = out
    w0, w1, w2 = work
    kappa = divide(n0, tracking_index, first_real)
    t4 = add(kappa, n1, w0)
    rho_scaled = sqrt(t4, second_real)
    rho = multiply(rho_scaled, n2, w0)
    twice_rho = multiply(rho_scaled, n3, second_real)
    t13 = multiply(tracking_index, n4, w1)
    t14 = subtract(n5, t13, w2)
    distance = absolute(t14, w2)
    below = sqrt(distance, first_imaginary)
    t17 = add(n5, t13, w1)
    above = sqrt(t17, second_imaginary)
    t19 = multiply(tracking_index, n6, w1)
    t20 = subtract(n5, t19, w2)
    t22 = add(kappa, n7, first_real)
    t23 = multiply(tracking_index, t22, first_real)
    t24 = divide(t20, t23, w2)
    t25 = add(n5, t19, w1)
    t27 = add(twice_rho, n8, second_real)
    t28 = square(t27, second_real)
    t29 = multiply(tracking_index, t28, second_real)
    t31 = divide(n9, t29, second_real)
    t32 = multiply(t25, t31, w1)
    t33 = multiply(t24, t32, w2)
    t34 = multiply(t33, n7, w2)
    t35 = divide(below, rho, first_imaginary)
    t36 = multiply(above, t31, second_imaginary)
    t37 = multiply(t35, t36, first_imaginary)
    t38 = multiply(t37, n7, first_imaginary)
    middle_size = absolute(t34, w0)
    t40 = add(middle_size, t38, w0)
    t41 = divide(t31, t40, w1)
    t42 = multiply(t41, t31, w1)
    t44 = negative(t40, w0)
    t46 = negative(t42, w1)
    t49 = negative(t38, second_imaginary)
    mask = mask_of(less(tracking_index, n10), single)
    choose(mask, t34, t44, out=first_real)
    choose(mask, t34, t46, out=second_real)
    choose(mask, t38, n11, out=first_imaginary)
    choose(mask, t49, n11, out=second_imaginary)


_CLOSED_LOOP_POLES = Signature(
    "closed_loop_poles",
    (_TRACKING_INDEX_DOMAIN,),
    ("first_real", "first_imaginary", "second_real", "second_imaginary"),
    3,
    _closed_loop_poles_block,
    numbers=_closed_loop_poles_of_numbers,
)


def index_from_alpha(
    alpha: ArrayLike, *, out: tuple[Real] | None = None, workers: int = 1
) -> IndexFromAlpha:
    """The tracking index that belongs to a position gain.

        4*alpha**2 + 4*alpha*beta + beta**2 - 8*beta = 0, Lambda^2 = beta^2/(1 - alpha)

    alpha: position gain; a number above 0 and below 1.

    tracking_index: tracking index Lambda. Relative error at most 3.40 * 2^-52 (float64), 3.39 *
        2^-23 (float32), proved for 2.1095373229726e-154 <= alpha <= 0.9999999999999999 (float64)
        and 1.5332935e-19 <= alpha <= 0.99999994 (float32).

    Outside an output's range, a few numbers next to its ends apart, its true value is no normal
    number: it comes as 0, a subnormal number or infinity, never as NaN. Numbers and arrays are
    taken, arrays of any shape; inputs are broadcast. float64 and float32 stay what they are,
    integers become float64. `out`: a tuple of arrays to fill. `workers`: threads that share the
    work on long arrays.

    ValueError: an input outside its domain, with its place; `out` or `workers` that does not fit.
    TypeError: an input that is no real number of these types; in `out` what is no array of the
    results' type.

    Source: derivation random-acceleration
    """
    if (
        type(alpha) is float
        and 5e-324 <= alpha <= 0.9999999999999999
        and out is None
        and workers is ONE
    ):
        try:
            return named(IndexFromAlpha, _index_from_alpha_of_numbers(alpha))
        except (ArithmeticError, ValueError):
            pass  # arrays say what is wrong
    return IndexFromAlpha(*evaluate(_INDEX_FROM_ALPHA, (alpha,), out, workers))


def _index_from_alpha_of_numbers(alpha: float, form: Form = Double) -> tuple[float, ...]:
    t2 = 1.0 - alpha
    t12 = ((alpha * alpha) * 2.0) / ((2.0 - alpha) + form.sqrt(t2 * 4.0))
    t13 = t12 / form.sqrt(t2)
    return (t13,)


def _index_from_alpha_block(
    given: Arrays,
    out: Arrays,
    work: Arrays,
    _single: bool,
    n0: float = 1.0,
    n1: float = 4.0,
    n2: float = 2.0,
) -> None:
    (alpha,) = given
    (tracking_index,) = out
    w0, w1, w2 = work
    t2 = subtract(n0, alpha, w0)
    t4 = multiply(t2, n1, w1)
    alpha_radical = sqrt(t4, tracking_index)
    root_of_rest = sqrt(t2, w0)
    t7 = square(alpha, w1)
    t9 = multiply(t7, n2, w1)
    t10 = subtract(n2, alpha, w2)
    t11 = add(t10, alpha_radical, w2)
    t12 = divide(t9, t11, w1)
    divide(t12, root_of_rest, tracking_index)


_INDEX_FROM_ALPHA = Signature(
    "index_from_alpha",
    (_ALPHA_DOMAIN,),
    ("tracking_index",),
    3,
    _index_from_alpha_block,
    numbers=_index_from_alpha_of_numbers,
)


def beta_from_alpha(
    alpha: ArrayLike, *, out: tuple[Real] | None = None, workers: int = 1
) -> BetaFromAlpha:
    """The velocity gain that belongs to a position gain.

        4*alpha**2 + 4*alpha*beta + beta**2 - 8*beta = 0, Lambda^2 = beta^2/(1 - alpha)

    alpha: position gain; a number above 0 and below 1.

    beta: velocity gain times the sampling interval. Relative error at most 2.14 * 2^-52 (float64),
        2.14 * 2^-23 (float32), proved for 2.1095373229726e-154 <= alpha <= 0.9999999999999999
        (float64) and 1.5332935e-19 <= alpha <= 0.99999994 (float32).

    Outside an output's range, a few numbers next to its ends apart, its true value is no normal
    number: it comes as 0, a subnormal number or infinity, never as NaN. Numbers and arrays are
    taken, arrays of any shape; inputs are broadcast. float64 and float32 stay what they are,
    integers become float64. `out`: a tuple of arrays to fill. `workers`: threads that share the
    work on long arrays.

    ValueError: an input outside its domain, with its place; `out` or `workers` that does not fit.
    TypeError: an input that is no real number of these types; in `out` what is no array of the
    results' type.

    Source: derivation random-acceleration
    """
    if (
        type(alpha) is float
        and 5e-324 <= alpha <= 0.9999999999999999
        and out is None
        and workers is ONE
    ):
        try:
            return named(BetaFromAlpha, _beta_from_alpha_of_numbers(alpha))
        except (ArithmeticError, ValueError):
            pass  # arrays say what is wrong
    return BetaFromAlpha(*evaluate(_BETA_FROM_ALPHA, (alpha,), out, workers))


def _beta_from_alpha_of_numbers(alpha: float, form: Form = Double) -> tuple[float, ...]:
    t10 = (2.0 - alpha) + form.sqrt((1.0 - alpha) * 4.0)
    t11 = ((alpha * alpha) * 2.0) / t10
    return (t11,)


def _beta_from_alpha_block(
    given: Arrays,
    out: Arrays,
    work: Arrays,
    _single: bool,
    n0: float = 1.0,
    n1: float = 4.0,
    n2: float = 2.0,
) -> None:
    (alpha,) = given
    (beta,) = out
    w0, w1 = work
    t2 = subtract(n0, alpha, w0)
    t4 = multiply(t2, n1, w0)
    alpha_radical = sqrt(t4, beta)
    t6 = square(alpha, w0)
    t8 = multiply(t6, n2, w0)
    t9 = subtract(n2, alpha, w1)
    t10 = add(t9, alpha_radical, w1)
    divide(t8, t10, beta)


_BETA_FROM_ALPHA = Signature(
    "beta_from_alpha",
    (_ALPHA_DOMAIN,),
    ("beta",),
    2,
    _beta_from_alpha_block,
    numbers=_beta_from_alpha_of_numbers,
)


def index_from_beta(
    beta: ArrayLike, *, out: tuple[Real] | None = None, workers: int = 1
) -> IndexFromBeta:
    """The tracking index that belongs to a velocity gain.

        4*alpha**2 + 4*alpha*beta + beta**2 - 8*beta = 0, Lambda^2 = beta^2/(1 - alpha)

    beta: velocity gain times the sampling interval; a number above 0 and below 2.

    tracking_index: tracking index Lambda. Relative error at most 2.51 * 2^-52 (float64), 2.51 *
        2^-23 (float32), proved for 2.2250738585072014e-308 <= beta <= 1.9999999999999998 (float64)
        and 1.1754944e-38 <= beta <= 1.9999999 (float32).

    Outside an output's range, a few numbers next to its ends apart, its true value is no normal
    number: it comes as 0, a subnormal number or infinity, never as NaN. Numbers and arrays are
    taken, arrays of any shape; inputs are broadcast. float64 and float32 stay what they are,
    integers become float64. `out`: a tuple of arrays to fill. `workers`: threads that share the
    work on long arrays.

    ValueError: an input outside its domain, with its place; `out` or `workers` that does not fit.
    TypeError: an input that is no real number of these types; in `out` what is no array of the
    results' type.

    Source: derivation random-acceleration
    """
    if (
        type(beta) is float
        and 5e-324 <= beta <= 1.9999999999999998
        and out is None
        and workers is ONE
    ):
        try:
            return named(IndexFromBeta, _index_from_beta_of_numbers(beta))
        except (ArithmeticError, ValueError):
            pass  # arrays say what is wrong
    return IndexFromBeta(*evaluate(_INDEX_FROM_BETA, (beta,), out, workers))


def _index_from_beta_of_numbers(beta: float, form: Form = Double) -> tuple[float, ...]:
    t5 = 2.0 - beta
    t9 = ((2.0 + beta) + form.sqrt(beta * 8.0)) * 2.0
    t12 = beta / form.sqrt((t5 * t5) / t9)
    return (t12,)


def _index_from_beta_block(
    given: Arrays, out: Arrays, work: Arrays, _single: bool, n0: float = 8.0, n1: float = 2.0
) -> None:
    (beta,) = given
    (tracking_index,) = out
    w0, w1 = work
    t2 = multiply(beta, n0, w0)
    beta_radical = sqrt(t2, tracking_index)
    t5 = subtract(n1, beta, w0)
    t6 = square(t5, w0)
    t7 = add(n1, beta, w1)
    t8 = add(t7, beta_radical, w1)
    t9 = multiply(t8, n1, w1)
    t10 = divide(t6, t9, w0)
    root_of_rest = sqrt(t10, w0)
    divide(beta, root_of_rest, tracking_index)


_INDEX_FROM_BETA = Signature(
    "index_from_beta",
    (_BETA_DOMAIN,),
    ("tracking_index",),
    2,
    _index_from_beta_block,
    numbers=_index_from_beta_of_numbers,
)


def alpha_from_beta(
    beta: ArrayLike, *, out: tuple[Real] | None = None, workers: int = 1
) -> AlphaFromBeta:
    """The position gain that belongs to a velocity gain.

        4*alpha**2 + 4*alpha*beta + beta**2 - 8*beta = 0, Lambda^2 = beta^2/(1 - alpha)

    beta: velocity gain times the sampling interval; a number above 0 and below 2.

    alpha: position gain. Relative error at most 2.51 * 2^-52 (float64), 2.51 * 2^-23 (float32),
        proved for 5e-324 <= beta <= 1.9999999999999998 (float64) and 1e-45 <= beta <= 1.9999999
        (float32).

    Outside an output's range, a few numbers next to its ends apart, its true value is no normal
    number: it comes as 0, a subnormal number or infinity, never as NaN. Numbers and arrays are
    taken, arrays of any shape; inputs are broadcast. float64 and float32 stay what they are,
    integers become float64. `out`: a tuple of arrays to fill. `workers`: threads that share the
    work on long arrays.

    ValueError: an input outside its domain, with its place; `out` or `workers` that does not fit.
    TypeError: an input that is no real number of these types; in `out` what is no array of the
    results' type.

    Source: derivation random-acceleration
    """
    if (
        type(beta) is float
        and 5e-324 <= beta <= 1.9999999999999998
        and out is None
        and workers is ONE
    ):
        try:
            return named(AlphaFromBeta, _alpha_from_beta_of_numbers(beta))
        except (ArithmeticError, ValueError):
            pass  # arrays say what is wrong
    return AlphaFromBeta(*evaluate(_ALPHA_FROM_BETA, (beta,), out, workers))


def _alpha_from_beta_of_numbers(beta: float, form: Form = Double) -> tuple[float, ...]:
    t2 = beta * 1.152921504606847e18
    t10 = form.sqrt(t2 * 8.0) + (beta * 1073741824.0)
    t13 = (t2 * (8.0 - beta)) / (t10 * 2147483648.0)
    return (t13,)


def _alpha_from_beta_block(
    given: Arrays,
    out: Arrays,
    work: Arrays,
    _single: bool,
    n0: float = 1.152921504606847e18,
    n1: float = 8.0,
    n2: float = 1073741824.0,
    n3: float = 2147483648.0,
) -> None:
    (beta,) = given
    (alpha,) = out
    w0, w1 = work
    t2 = multiply(beta, n0, w0)
    t4 = multiply(t2, n1, w1)
    scaled_beta_radical = sqrt(t4, alpha)
    t6 = subtract(n1, beta, w1)
    t7 = multiply(t2, t6, w0)
    t9 = multiply(beta, n2, w1)
    t10 = add(scaled_beta_radical, t9, alpha)
    t12 = multiply(t10, n3, alpha)
    divide(t7, t12, alpha)


_ALPHA_FROM_BETA = Signature(
    "alpha_from_beta",
    (_BETA_DOMAIN,),
    ("alpha",),
    2,
    _alpha_from_beta_block,
    numbers=_alpha_from_beta_of_numbers,
)
