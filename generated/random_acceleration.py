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
    beta: velocity gain times the sampling interval. Relative error at most 1.94 * 2^-52 (float64),
        1.94 * 2^-23 (float32), proved for 2.2250738585072014e-308 <= tracking_index <=
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
    t26 = (t2 * 2.0) + (t7 + 5.551115123125783e-17)
    t23 = form.sqrt(16.0 / (t4 + (t7 + t16))) * 3.725290298461914e-09
    t28 = 2.220446049250313e-16 / t26
    return (t23, t28)


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
    n8: float = 3.725290298461914e-09,
    n9: float = 2.220446049250313e-16,
) -> None:
    (tracking_index,) = given
    alpha, beta = out
    w0, w1, w2 = work
    t2 = divide(n0, tracking_index, alpha)
    t4 = add(t2, n1, w0)
    rho_scaled = sqrt(t4, beta)
    t7 = multiply(rho_scaled, n2, beta)
    t9 = divide(n3, t7, w1)
    t11 = add(t9, n4, w2)
    t12 = multiply(t9, t11, w1)
    t14 = add(t12, n5, w1)
    t16 = multiply(t14, n6, w1)
    t17 = add(t7, t16, w1)
    t18 = add(t4, t17, w0)
    t20 = divide(n7, t18, w0)
    alpha_raised = sqrt(t20, w0)
    t24 = multiply(t2, n4, alpha)
    t25 = add(t7, n6, beta)
    t26 = add(t24, t25, beta)
    multiply(alpha_raised, n8, alpha)
    divide(n9, t26, beta)


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
    rho = scale(rho_scaled, 7.450580596923828e-09)
    t10 = add(rho, (2.7755575615628914e-17, 0.0))
    t11 = add(kappa, t10)
    t12 = divide((2.0, 0.0), t11)
    t13 = multiply(t12, rho)
    t15 = scale(t12, 5.551115123125783e-17)
    return (t13[0], t15[0])


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

    alpha: derivative of the position gain. Relative error at most 7.01 * 2^-52 (float64), 7.01 *
        2^-23 (float32), proved for 5e-324 <= tracking_index <= 7.11074631974658e102 (float64) and
        1e-45 <= tracking_index <= 8.7960925e12 (float32).
    beta: derivative of the velocity gain times the sampling interval. Relative error at most 6.63 *
        2^-52 (float64), 6.63 * 2^-23 (float32), proved for 5e-324 <= tracking_index <=
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
    t7 = t5 * 7.450580596923828e-09
    t10 = t7 + 2.7755575615628914e-17
    t12 = tracking_index * (t2 + t10)
    t16 = (1.232595164407831e-32 / (t12 * t12)) / t7
    t18 = t16 * (t2 * 0.5)
    t19 = t16 * t10
    return (t18, t19)


def _gain_derivatives_block(
    given: Arrays,
    out: Arrays,
    work: Arrays,
    _single: bool,
    n0: float = 1.1102230246251565e-16,
    n1: float = 1.3877787807814457e-17,
    n2: float = 7.450580596923828e-09,
    n3: float = 2.7755575615628914e-17,
    n4: float = 1.232595164407831e-32,
    n5: float = 0.5,
) -> None:
    (tracking_index,) = given
    alpha, beta = out
    w0, w1 = work
    kappa = divide(n0, tracking_index, alpha)
    t4 = add(kappa, n1, w0)
    rho_scaled = sqrt(t4, beta)
    rho = multiply(rho_scaled, n2, beta)
    t10 = add(rho, n3, w0)
    t11 = add(kappa, t10, w1)
    t12 = multiply(tracking_index, t11, w1)
    t13 = square(t12, w1)
    t15 = divide(n4, t13, w1)
    t16 = divide(t15, rho, w1)
    t17 = multiply(kappa, n5, alpha)
    multiply(t16, t17, alpha)
    multiply(t16, t10, beta)


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
    d_alpha: derivative of the position gain. Relative error at most 6.76 * 2^-52 (float64), 6.77 *
        2^-23 (float32), proved for 5e-324 <= tracking_index <= 7.11074631974658e102 (float64) and
        1e-45 <= tracking_index <= 8.7960925e12 (float32).
    d_beta: derivative of the velocity gain times the sampling interval. Relative error at most 6.63
        * 2^-52 (float64), 6.63 * 2^-23 (float32), proved for 5e-324 <= tracking_index <=
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
    t10 = form.sqrt((tracking_index * 0.25) + 2.0)
    t13 = ((t3 + (2.0 / t1)) + t10) * 0.5
    t18 = 1.0 / ((tracking_index * t13) * t13)
    t14 = t10 / t13
    t15 = t1 / t13
    t20 = t18 / (t1 * t10)
    t23 = t18 * ((t3 / t10) + 1.0)
    return (t14, t15, t20, t23)


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
    t6 = divide(n1, p, alpha)
    t8 = multiply(tracking_index, n2, w1)
    t9 = add(t8, n1, w1)
    twice_ratio = sqrt(t9, d_alpha)
    t11 = add(t3, t6, alpha)
    t12 = add(t11, twice_ratio, alpha)
    t13 = multiply(t12, n0, w1)
    t16 = multiply(tracking_index, t13, alpha)
    t17 = multiply(t16, t13, alpha)
    t18 = divide(n3, t17, d_beta)
    t19 = multiply(p, twice_ratio, w2)
    t21 = divide(t3, twice_ratio, w0)
    t22 = add(t21, n3, w0)
    divide(twice_ratio, t13, alpha)
    divide(p, t13, beta)
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

    position: position entry of F K, alpha + beta. Relative error at most 2.31 * 2^-52 (float64),
        2.31 * 2^-23 (float32), proved for 5e-324 <= tracking_index <= 1.7976931348623157e308
        (float64) and 1e-45 <= tracking_index <= 3.4028235e38 (float32).
    velocity: velocity entry of F K times the sampling interval, beta. Relative error at most 1.94 *
        2^-52 (float64), 1.94 * 2^-23 (float32), proved for 2.2250738585072014e-308 <=
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
    t23 = form.sqrt(16.0 / (t4 + (t7 + t16))) * 3.725290298461914e-09
    t26 = (t2 * 2.0) + (t7 + 5.551115123125783e-17)
    t28 = 2.220446049250313e-16 / t26
    t29 = t23 + t28
    return (t29, t28)


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
    n8: float = 3.725290298461914e-09,
    n9: float = 2.220446049250313e-16,
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
    alpha_raised = sqrt(t20, w0)
    t23 = multiply(alpha_raised, n8, w0)
    t24 = multiply(t2, n4, velocity)
    t25 = add(t7, n6, position)
    t26 = add(t24, t25, velocity)
    divide(n9, t26, velocity)
    add(t23, velocity, position)


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

    position: derivative of the position entry of F K, alpha + beta. Relative error at most 7.63 *
        2^-52 (float64), 7.13 * 2^-23 (float32), proved for 5e-324 <= tracking_index <=
        1.8961503816218352e154 (float64) and 1e-45 <= tracking_index <= 2.6087635e19 (float32).
    velocity: derivative of the velocity entry of F K times the sampling interval, beta. Relative
        error at most 6.63 * 2^-52 (float64), 6.63 * 2^-23 (float32), proved for 5e-324 <=
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
    t7 = t5 * 7.450580596923828e-09
    t10 = t7 + 2.7755575615628914e-17
    t12 = tracking_index * (t2 + t10)
    t16 = (1.232595164407831e-32 / (t12 * t12)) / t7
    t19 = t16 * t10
    t20 = (t16 * (t2 * 0.5)) + t19
    return (t20, t19)


def _predictor_gain_derivatives_block(
    given: Arrays,
    out: Arrays,
    work: Arrays,
    _single: bool,
    n0: float = 1.1102230246251565e-16,
    n1: float = 1.3877787807814457e-17,
    n2: float = 7.450580596923828e-09,
    n3: float = 2.7755575615628914e-17,
    n4: float = 1.232595164407831e-32,
    n5: float = 0.5,
) -> None:
    (tracking_index,) = given
    position, velocity = out
    w0, w1 = work
    kappa = divide(n0, tracking_index, velocity)
    t4 = add(kappa, n1, w0)
    rho_scaled = sqrt(t4, position)
    rho = multiply(rho_scaled, n2, position)
    t10 = add(rho, n3, w0)
    t11 = add(kappa, t10, w1)
    t12 = multiply(tracking_index, t11, w1)
    t13 = square(t12, w1)
    t15 = divide(n4, t13, w1)
    t16 = divide(t15, rho, w1)
    t17 = multiply(kappa, n5, velocity)
    t18 = multiply(t16, t17, position)
    multiply(t16, t10, velocity)
    add(t18, velocity, position)


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

    predicted_11: variance of the predicted position over sigma_v^2. Relative error at most 3.87 *
        2^-52 (float64), 5.51 * 2^-23 (float32), proved for 5e-324 <= tracking_index <=
        2.6815615859885e154 (float64) and 1e-45 <= tracking_index <= 3.6893345e19 (float32).
    predicted_12: covariance of predicted position and velocity times T/sigma_v^2. Relative error at
        most 2.44 * 2^-52 (float64), 2.44 * 2^-23 (float32), proved for 2.2250738585072014e-308 <=
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
    t7 = t5 * 7.450580596923828e-09
    t9 = t7 + 2.7755575615628914e-17
    t13 = (tracking_index * (t2 + t9)) * 9007199254740992.0
    t16 = (tracking_index * t7) * 1.8014398509481984e16
    t20 = tracking_index * (1.1102230246251565e-16 / t9)
    t17 = t13 * t16
    t18 = tracking_index * t13
    t22 = t20 + (tracking_index * tracking_index)
    return (t17, t18, t22)


def _predicted_covariance_block(
    given: Arrays,
    out: Arrays,
    work: Arrays,
    _single: bool,
    n0: float = 1.1102230246251565e-16,
    n1: float = 1.3877787807814457e-17,
    n2: float = 7.450580596923828e-09,
    n3: float = 2.7755575615628914e-17,
    n4: float = 9007199254740992.0,
    n5: float = 1.8014398509481984e16,
) -> None:
    (tracking_index,) = given
    predicted_11, predicted_12, predicted_22 = out
    w0, w1 = work
    kappa = divide(n0, tracking_index, predicted_11)
    t4 = add(kappa, n1, w0)
    rho_scaled = sqrt(t4, predicted_12)
    rho = multiply(rho_scaled, n2, predicted_12)
    t9 = add(rho, n3, w0)
    t10 = add(kappa, t9, predicted_11)
    t11 = multiply(tracking_index, t10, predicted_11)
    t13 = multiply(t11, n4, w1)
    t14 = multiply(tracking_index, rho, predicted_12)
    t16 = multiply(t14, n5, predicted_12)
    t19 = divide(n0, t9, predicted_22)
    t20 = multiply(tracking_index, t19, predicted_22)
    t21 = square(tracking_index, w0)
    multiply(t13, t16, predicted_11)
    multiply(tracking_index, t13, predicted_12)
    add(t20, t21, predicted_22)


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
        error at most 4.01 * 2^-52 (float64), 4.02 * 2^-23 (float32), proved for 5e-324 <=
        tracking_index <= 1.7976931348623157e308 (float64) and 1e-45 <= tracking_index <=
        3.4028235e38 (float32).
    predicted_12: derivative of the covariance of predicted position and velocity times T/sigma_v^2.
        Relative error at most 3.14 * 2^-52 (float64), 3.14 * 2^-23 (float32), proved for 5e-324 <=
        tracking_index <= 1.7976931348622902e308 (float64) and 1e-45 <= tracking_index <=
        3.4027975e38 (float32).
    predicted_22: derivative of the variance of the predicted velocity times T^2/sigma_v^2. Relative
        error at most 4.51 * 2^-52 (float64), 4.51 * 2^-23 (float32), proved for 5e-324 <=
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
    t7 = t5 * 7.450580596923828e-09
    t11 = t7 + 2.7755575615628914e-17
    t12 = t2 + t11
    t15 = (tracking_index * t12) * 9007199254740992.0
    t24 = ((t2 / t11) * 2.7755575615628914e-17) / t7
    t26 = (1.1102230246251565e-16 / t11) * (1.0 + t24)
    t18 = t15 * ((t12 / t7) * 0.5)
    t20 = t15 * (t11 / t7)
    t28 = t26 + (tracking_index * 2.0)
    return (t18, t20, t28)


def _predicted_covariance_derivatives_block(
    given: Arrays,
    out: Arrays,
    work: Arrays,
    _single: bool,
    n0: float = 1.1102230246251565e-16,
    n1: float = 1.3877787807814457e-17,
    n2: float = 7.450580596923828e-09,
    n3: float = 2.7755575615628914e-17,
    n4: float = 9007199254740992.0,
    n5: float = 0.5,
    n6: float = 1.0,
    n7: float = 2.0,
) -> None:
    (tracking_index,) = given
    predicted_11, predicted_12, predicted_22 = out
    w0, w1, w2, w3 = work
    kappa = divide(n0, tracking_index, predicted_11)
    t4 = add(kappa, n1, w0)
    rho_scaled = sqrt(t4, predicted_12)
    rho = multiply(rho_scaled, n2, predicted_12)
    t11 = add(rho, n3, w0)
    t12 = add(kappa, t11, w1)
    t13 = multiply(tracking_index, t12, w2)
    t15 = multiply(t13, n4, w2)
    t16 = divide(t12, rho, predicted_22)
    t17 = multiply(t16, n5, predicted_22)
    t19 = divide(t11, rho, w1)
    t21 = divide(n0, t11, w3)
    t22 = divide(kappa, t11, predicted_11)
    t23 = multiply(t22, n3, predicted_11)
    t24 = divide(t23, rho, predicted_11)
    t25 = add(n6, t24, predicted_11)
    t26 = multiply(t21, t25, w3)
    t27 = multiply(tracking_index, n7, w0)
    multiply(t15, t17, predicted_11)
    multiply(t15, t19, predicted_12)
    add(t26, t27, predicted_22)


_PREDICTED_COVARIANCE_DERIVATIVES = Signature(
    "predicted_covariance_derivatives",
    (_TRACKING_INDEX_DOMAIN,),
    ("predicted_11", "predicted_12", "predicted_22"),
    4,
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

    updated_11: variance of the updated position over sigma_v^2. Relative error at most 2.51 * 2^-52
        (float64), 2.51 * 2^-23 (float32), proved for 5e-324 <= tracking_index <=
        1.7976931348623157e308 (float64) and 1e-45 <= tracking_index <= 3.4028235e38 (float32).
    updated_12: covariance of updated position and velocity times T/sigma_v^2. Relative error at
        most 2.01 * 2^-52 (float64), 2.01 * 2^-23 (float32), proved for 2.2250738585072014e-308 <=
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
    t7 = t5 * 7.450580596923828e-09
    t10 = t7 + 2.7755575615628914e-17
    t12 = 2.0 / (t2 + t10)
    t13 = t12 * t7
    t15 = t12 * 5.551115123125783e-17
    t17 = tracking_index * (1.1102230246251565e-16 / t10)
    return (t13, t15, t17)


def _updated_covariance_block(
    given: Arrays,
    out: Arrays,
    work: Arrays,
    _single: bool,
    n0: float = 1.1102230246251565e-16,
    n1: float = 1.3877787807814457e-17,
    n2: float = 7.450580596923828e-09,
    n3: float = 2.7755575615628914e-17,
    n4: float = 2.0,
    n5: float = 5.551115123125783e-17,
) -> None:
    (tracking_index,) = given
    updated_11, updated_12, updated_22 = out
    (w0,) = work
    kappa = divide(n0, tracking_index, updated_11)
    t4 = add(kappa, n1, w0)
    rho_scaled = sqrt(t4, updated_12)
    rho = multiply(rho_scaled, n2, updated_12)
    t10 = add(rho, n3, w0)
    t11 = add(kappa, t10, updated_11)
    t12 = divide(n4, t11, updated_22)
    t16 = divide(n0, t10, w0)
    multiply(t12, rho, updated_11)
    multiply(t12, n5, updated_12)
    multiply(tracking_index, t16, updated_22)


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
        most 7.01 * 2^-52 (float64), 7.01 * 2^-23 (float32), proved for 5e-324 <= tracking_index <=
        7.11074631974658e102 (float64) and 1e-45 <= tracking_index <= 8.7960925e12 (float32).
    updated_12: derivative of the covariance of updated position and velocity times T/sigma_v^2.
        Relative error at most 6.63 * 2^-52 (float64), 6.63 * 2^-23 (float32), proved for 5e-324 <=
        tracking_index <= 1.8961503816218352e154 (float64) and 1e-45 <= tracking_index <=
        2.6087635e19 (float32).
    updated_22: derivative of the variance of the updated velocity times T^2/sigma_v^2. Relative
        error at most 4.01 * 2^-52 (float64), 4.01 * 2^-23 (float32), proved for 5e-324 <=
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
    t7 = t5 * 7.450580596923828e-09
    t11 = t7 + 2.7755575615628914e-17
    t13 = tracking_index * (t2 + t11)
    t17 = (1.232595164407831e-32 / (t13 * t13)) / t7
    t24 = ((t2 / t11) * 2.7755575615628914e-17) / t7
    t19 = t17 * (t2 * 0.5)
    t20 = t17 * t11
    t26 = (1.1102230246251565e-16 / t11) * (1.0 + t24)
    return (t19, t20, t26)


def _updated_covariance_derivatives_block(
    given: Arrays,
    out: Arrays,
    work: Arrays,
    _single: bool,
    n0: float = 1.1102230246251565e-16,
    n1: float = 1.3877787807814457e-17,
    n2: float = 7.450580596923828e-09,
    n3: float = 2.7755575615628914e-17,
    n4: float = 1.232595164407831e-32,
    n5: float = 0.5,
    n6: float = 1.0,
) -> None:
    (tracking_index,) = given
    updated_11, updated_12, updated_22 = out
    w0, w1, w2 = work
    kappa = divide(n0, tracking_index, updated_11)
    t4 = add(kappa, n1, w0)
    rho_scaled = sqrt(t4, w0)
    rho = multiply(rho_scaled, n2, w0)
    t11 = add(rho, n3, w1)
    t12 = add(kappa, t11, w2)
    t13 = multiply(tracking_index, t12, w2)
    t14 = square(t13, w2)
    t16 = divide(n4, t14, w2)
    t17 = divide(t16, rho, updated_12)
    t18 = multiply(kappa, n5, w2)
    t22 = divide(kappa, t11, updated_11)
    t23 = multiply(t22, n3, updated_11)
    t24 = divide(t23, rho, updated_11)
    t25 = add(n6, t24, w0)
    multiply(t17, t18, updated_11)
    multiply(t17, t11, updated_12)
    t21 = divide(n0, t11, updated_22)
    multiply(t21, t25, updated_22)


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

    alpha: second derivative by Lambda of the position gain. Relative error at most 10.30 * 2^-52
        (float64), 10.30 * 2^-23 (float32), proved for 1.5697348409117308e-206 <= tracking_index <=
        1.8122441335979363e77 (float64) and 1.0258392e-26 <= tracking_index <= 6.721987e09
        (float32).
    beta: second derivative by Lambda of the velocity gain times the sampling interval. Relative
        error at most 9.94 * 2^-52 (float64), 9.94 * 2^-23 (float32), proved for 5e-324 <=
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
    t7 = form.sqrt(t4) * 7.450580596923828e-09
    t12 = tracking_index * (t2 + (t7 + 2.7755575615628914e-17))
    t15 = 1.232595164407831e-32 / (t12 * t12)
    t17 = 5.551115123125783e-17 / t7
    t20 = ((t2 + 2.7755575615628914e-17) / t4) * 0.5
    t24 = (t15 * (t17 * (t17 + t20))) / tracking_index
    t33 = ((2.0 + t17) * (6.0 + t17)) * 0.03125
    t26 = -(t24 / tracking_index)
    t36 = -(t15 * ((t2 / t7) * t33))
    return (t26, t36)


def _gain_second_derivatives_block(
    given: Arrays,
    out: Arrays,
    work: Arrays,
    _single: bool,
    n0: float = 1.1102230246251565e-16,
    n1: float = 1.3877787807814457e-17,
    n2: float = 7.450580596923828e-09,
    n3: float = 2.7755575615628914e-17,
    n4: float = 1.232595164407831e-32,
    n5: float = 5.551115123125783e-17,
    n6: float = 0.5,
    n7: float = 2.0,
    n8: float = 6.0,
    n9: float = 0.03125,
) -> None:
    (tracking_index,) = given
    alpha, beta = out
    w0, w1, w2, w3 = work
    kappa = divide(n0, tracking_index, beta)
    t4 = add(kappa, n1, w0)
    rho_scaled = sqrt(t4, w1)
    rho = multiply(rho_scaled, n2, w1)
    t10 = add(rho, n3, w2)
    t11 = add(kappa, t10, w2)
    t12 = multiply(tracking_index, t11, w2)
    t13 = square(t12, w2)
    t15 = divide(n4, t13, w2)
    t17 = divide(n5, rho, alpha)
    t18 = add(kappa, n3, w3)
    t19 = divide(t18, t4, w3)
    t20 = multiply(t19, n6, w3)
    t21 = add(t17, t20, w3)
    t22 = multiply(t17, t21, w3)
    t23 = multiply(t15, t22, w3)
    t24 = divide(t23, tracking_index, w3)
    t28 = add(n7, t17, w0)
    t30 = add(n8, t17, alpha)
    t31 = multiply(t28, t30, w0)
    t33 = multiply(t31, n9, w0)
    t25 = divide(t24, tracking_index, alpha)
    negative(t25, alpha)
    t27 = divide(kappa, rho, beta)
    t34 = multiply(t27, t33, beta)
    t35 = multiply(t15, t34, beta)
    negative(t35, beta)


_GAIN_SECOND_DERIVATIVES = Signature(
    "gain_second_derivatives",
    (_TRACKING_INDEX_DOMAIN,),
    ("alpha", "beta"),
    4,
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
        at most 10.94 * 2^-52 (float64), 10.50 * 2^-23 (float32), proved for 1.5697348409117308e-206
        <= tracking_index <= 8.958978968711217e102 (float64) and 1.0258392e-26 <= tracking_index <=
        1.1082382e13 (float32).
    velocity: second derivative by Lambda of the velocity entry of F K times the sampling interval,
        beta. Relative error at most 9.94 * 2^-52 (float64), 9.94 * 2^-23 (float32), proved for
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
    t7 = form.sqrt(t4) * 7.450580596923828e-09
    t12 = tracking_index * (t2 + (t7 + 2.7755575615628914e-17))
    t15 = 1.232595164407831e-32 / (t12 * t12)
    t17 = 5.551115123125783e-17 / t7
    t20 = ((t2 + 2.7755575615628914e-17) / t4) * 0.5
    t24 = (t15 * (t17 * (t17 + t20))) / tracking_index
    t32 = ((2.0 + t17) * (6.0 + t17)) * 0.03125
    t34 = t15 * ((t2 / t7) * t32)
    t36 = -((t24 / tracking_index) + t34)
    t37 = -t34
    return (t36, t37)


def _predictor_gain_second_derivatives_block(
    given: Arrays,
    out: Arrays,
    work: Arrays,
    _single: bool,
    n0: float = 1.1102230246251565e-16,
    n1: float = 1.3877787807814457e-17,
    n2: float = 7.450580596923828e-09,
    n3: float = 2.7755575615628914e-17,
    n4: float = 1.232595164407831e-32,
    n5: float = 5.551115123125783e-17,
    n6: float = 0.5,
    n7: float = 2.0,
    n8: float = 6.0,
    n9: float = 0.03125,
) -> None:
    (tracking_index,) = given
    position, velocity = out
    w0, w1, w2, w3 = work
    kappa = divide(n0, tracking_index, position)
    t4 = add(kappa, n1, w0)
    rho_scaled = sqrt(t4, velocity)
    rho = multiply(rho_scaled, n2, velocity)
    t10 = add(rho, n3, w1)
    t11 = add(kappa, t10, w1)
    t12 = multiply(tracking_index, t11, w1)
    t13 = square(t12, w1)
    t15 = divide(n4, t13, w1)
    t17 = divide(n5, rho, w2)
    t18 = add(kappa, n3, w3)
    t19 = divide(t18, t4, w3)
    t20 = multiply(t19, n6, w3)
    t21 = add(t17, t20, w3)
    t22 = multiply(t17, t21, w3)
    t23 = multiply(t15, t22, w3)
    t24 = divide(t23, tracking_index, w3)
    t25 = divide(t24, tracking_index, w3)
    t26 = divide(kappa, rho, position)
    t27 = add(n7, t17, w0)
    t29 = add(n8, t17, w2)
    t30 = multiply(t27, t29, w0)
    t32 = multiply(t30, n9, w0)
    t33 = multiply(t26, t32, position)
    t34 = multiply(t15, t33, w1)
    t35 = add(t25, t34, w3)
    negative(t35, position)
    negative(t34, velocity)


_PREDICTOR_GAIN_SECOND_DERIVATIVES = Signature(
    "predictor_gain_second_derivatives",
    (_TRACKING_INDEX_DOMAIN,),
    ("position", "velocity"),
    4,
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
        sigma_v^2. Relative error at most 10.05 * 2^-52 (float64), 10.22 * 2^-23 (float32), proved
        for 1.5697348409117308e-206 <= tracking_index <= 1.7976931348623157e308 (float64) and
        1.0258392e-26 <= tracking_index <= 3.4028235e38 (float32).
    predicted_12: second derivative by Lambda of the covariance of predicted position and velocity
        times T/sigma_v^2. Relative error at most 3.88 * 2^-52 (float64), 3.88 * 2^-23 (float32),
        proved for 5e-324 <= tracking_index <= 1.7976931348623157e308 (float64) and 1e-45 <=
        tracking_index <= 3.4028235e38 (float32).
    predicted_22: second derivative by Lambda of the variance of the predicted velocity times
        T^2/sigma_v^2. Relative error at most 9.51 * 2^-52 (float64), 9.55 * 2^-23 (float32), proved
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
    t8 = form.sqrt(t5) * 7.450580596923828e-09
    t13 = (tracking_index + -0.6188021535170061) + (
        -2.329468529183032e-08 if form.single else -4.555764098981943e-17
    )
    t16 = (t13 * 0.20200317547305482) / tracking_index
    t18 = t8 + 2.7755575615628914e-17
    t23 = 5.551115123125783e-17 / t8
    t24 = 2.0 + t23
    t29 = t3 / t18
    t34 = (t29 + 0.36602540378443865) / (t29 + 2.366025403784439)
    t44 = (1.0 + (t23 * 0.5)) + ((t3 / t5) * 0.5)
    t48 = t3 / (t5 + (t8 * 0.5))
    t54 = (t48 * t48) * (t48 * (((t29 * 3.0) + 2.0) * 0.25))
    t36 = (t16 * (t18 * 3.602879701896397e16)) * (((t24 * t24) * (t24 * 0.125)) * t34)
    t45 = (t24 * (t18 * 2251799813685248.0)) * t44
    t55 = t54 + 2.0
    return (t36, t45, t55)


def _predicted_covariance_second_derivatives_block(
    given: Arrays,
    out: Arrays,
    work: Arrays,
    single: bool,
    n0: float = 1.1102230246251565e-16,
    n1: float = 1.3877787807814457e-17,
    n2: float = 7.450580596923828e-09,
    n3: float = -0.6188021535170061,
    n4: float = -2.329468529183032e-08,
    n5: float = -4.555764098981943e-17,
    n6: float = 0.20200317547305482,
    n7: float = 2.7755575615628914e-17,
    n8: float = 3.602879701896397e16,
    n9: float = 5.551115123125783e-17,
    n10: float = 2.0,
    n11: float = 0.125,
    n12: float = 0.36602540378443865,
    n13: float = 2.366025403784439,
    n14: float = 2251799813685248.0,
    n15: float = 0.5,
    n16: float = 1.0,
    n17: float = 3.0,
    n18: float = 0.25,
) -> None:
    (tracking_index,) = given
    predicted_11, predicted_12, predicted_22 = out
    w0, w1, w2, w3, w4, w5, w6, w7 = work
    kappa = divide(n0, tracking_index, predicted_11)
    t5 = add(kappa, n1, w0)
    rho_scaled = sqrt(t5, predicted_12)
    rho = multiply(rho_scaled, n2, predicted_12)
    rest = n4 if single else n5
    add(tracking_index, n3, w1)
    t13 = add(w1, rest, w1)
    t15 = multiply(t13, n6, w1)
    t16 = divide(t15, tracking_index, predicted_22)
    t18 = add(rho, n7, w1)
    t20 = multiply(t18, n8, w2)
    t21 = multiply(t16, t20, predicted_22)
    t23 = divide(n9, rho, w2)
    t24 = add(n10, t23, w3)
    t25 = square(t24, w4)
    t27 = multiply(t24, n11, w5)
    t28 = multiply(t25, t27, w4)
    t29 = divide(kappa, t18, w5)
    t31 = add(t29, n12, w6)
    t33 = add(t29, n13, w7)
    t34 = divide(t31, t33, w6)
    t35 = multiply(t28, t34, w4)
    t38 = multiply(t18, n14, w1)
    t39 = multiply(t24, t38, w3)
    t40 = multiply(t23, n15, w2)
    t41 = add(n16, t40, w2)
    t42 = divide(kappa, t5, w1)
    t43 = multiply(t42, n15, w1)
    t44 = add(t41, t43, w2)
    t46 = multiply(rho, n15, predicted_12)
    t47 = add(t5, t46, w0)
    t48 = divide(kappa, t47, predicted_11)
    t49 = square(t48, w0)
    t50 = multiply(t29, n17, w5)
    t51 = add(t50, n10, w5)
    t52 = multiply(t51, n18, w5)
    t53 = multiply(t48, t52, predicted_11)
    t54 = multiply(t49, t53, w0)
    multiply(t21, t35, predicted_11)
    multiply(t39, t44, predicted_12)
    add(t54, n10, predicted_22)


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
        Relative error at most 10.30 * 2^-52 (float64), 10.30 * 2^-23 (float32), proved for
        1.5697348409117308e-206 <= tracking_index <= 1.8122441335979363e77 (float64) and
        1.0258392e-26 <= tracking_index <= 6.721987e09 (float32).
    updated_12: second derivative by Lambda of the covariance of updated position and velocity times
        T/sigma_v^2. Relative error at most 9.94 * 2^-52 (float64), 9.94 * 2^-23 (float32), proved
        for 5e-324 <= tracking_index <= 8.958978968711217e102 (float64) and 1e-45 <= tracking_index
        <= 1.1082382e13 (float32).
    updated_22: second derivative by Lambda of the variance of the updated velocity times
        T^2/sigma_v^2. Relative error at most 9.01 * 2^-52 (float64), 9.03 * 2^-23 (float32), proved
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
    t8 = form.sqrt(t5) * 7.450580596923828e-09
    t11 = t8 + 2.7755575615628914e-17
    t13 = tracking_index * (t3 + t11)
    t16 = 1.232595164407831e-32 / (t13 * t13)
    t18 = 5.551115123125783e-17 / t8
    t21 = ((t3 + 2.7755575615628914e-17) / t5) * 0.5
    t25 = (t16 * (t18 * (t18 + t21))) / tracking_index
    t34 = ((2.0 + t18) * (6.0 + t18)) * 0.03125
    t40 = t3 / (t5 + (t8 * 0.5))
    t47 = t40 * ((((t3 / t11) * 3.0) + 2.0) * 0.25)
    t27 = -(t25 / tracking_index)
    t37 = -(t16 * ((t3 / t8) * t34))
    t48 = (t40 * t40) * t47
    return (t27, t37, t48)


def _updated_covariance_second_derivatives_block(
    given: Arrays,
    out: Arrays,
    work: Arrays,
    _single: bool,
    n0: float = 1.1102230246251565e-16,
    n1: float = 1.3877787807814457e-17,
    n2: float = 7.450580596923828e-09,
    n3: float = 2.7755575615628914e-17,
    n4: float = 1.232595164407831e-32,
    n5: float = 5.551115123125783e-17,
    n6: float = 0.5,
    n7: float = 2.0,
    n8: float = 6.0,
    n9: float = 0.03125,
    n10: float = 3.0,
    n11: float = 0.25,
) -> None:
    (tracking_index,) = given
    updated_11, updated_12, updated_22 = out
    w0, w1, w2, w3, w4, w5 = work
    kappa = divide(n0, tracking_index, updated_11)
    t5 = add(kappa, n1, w0)
    rho_scaled = sqrt(t5, updated_12)
    rho = multiply(rho_scaled, n2, updated_12)
    t11 = add(rho, n3, w1)
    t12 = add(kappa, t11, w2)
    t13 = multiply(tracking_index, t12, w2)
    t14 = square(t13, w2)
    t16 = divide(n4, t14, updated_22)
    t18 = divide(n5, rho, w2)
    t19 = add(kappa, n3, w3)
    t20 = divide(t19, t5, w3)
    t21 = multiply(t20, n6, w3)
    t22 = add(t18, t21, w3)
    t23 = multiply(t18, t22, w3)
    t24 = multiply(t16, t23, w3)
    t25 = divide(t24, tracking_index, w3)
    t26 = divide(t25, tracking_index, w3)
    t28 = divide(kappa, rho, w4)
    t29 = add(n7, t18, w5)
    t31 = add(n8, t18, w2)
    t32 = multiply(t29, t31, w5)
    t34 = multiply(t32, n9, w5)
    t35 = multiply(t28, t34, w4)
    t36 = multiply(t16, t35, updated_22)
    t38 = multiply(rho, n6, updated_12)
    t39 = add(t5, t38, w0)
    t40 = divide(kappa, t39, w0)
    t41 = square(t40, w2)
    t42 = divide(kappa, t11, updated_11)
    t43 = multiply(t42, n10, updated_11)
    t44 = add(t43, n7, updated_11)
    t46 = multiply(t44, n11, updated_11)
    t47 = multiply(t40, t46, w0)
    negative(t26, updated_11)
    negative(t36, updated_12)
    multiply(t41, t47, updated_22)


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

    first_real: real part of the first pole. Error over first_modulus at most 7.51 * 2^-52
        (float64), 7.51 * 2^-23 (float32), proved for 5e-324 <= tracking_index <=
        1.7976931348623157e308 (float64) and 1e-45 <= tracking_index <= 3.4028235e38 (float32).
        Digits that can be lost: up to 3.7 of 16 in float64; up to 1.7 of 7 in float32.
    first_imaginary: imaginary part of the first pole, not negative. Error over first_modulus at
        most 6.35 * 2^-52 (float64), 6.35 * 2^-23 (float32), proved for 5e-324 <= tracking_index <=
        1.7976931348623157e308 (float64) and 1e-45 <= tracking_index <= 3.4028235e38 (float32).
        Digits that can be lost: up to 16 of 16 in float64, half or more only where tracking_index
        <= 5.9e-14; up to 7 of 7 in float32, half or more only where tracking_index <= 7.3e-5.
    second_real: real part of the second pole. Error over second_modulus at most 7.37 * 2^-52
        (float64), 7.37 * 2^-23 (float32), proved for 5e-324 <= tracking_index <=
        1.3407807929942597e154 (float64) and 1e-45 <= tracking_index <= 1.8446744e19 (float32).
        Digits that can be lost: up to 3.9 of 16 in float64; up to 1.9 of 7 in float32, a quarter or
        more only where 2.6 <= tracking_index <= 5.4.
    second_imaginary: imaginary part of the second pole, not positive. Error over second_modulus at
        most 6.35 * 2^-52 (float64), 6.35 * 2^-23 (float32), proved for 5e-324 <= tracking_index <=
        1.3407807929942597e154 (float64) and 1e-45 <= tracking_index <= 1.8446744e19 (float32).
        Digits that can be lost: up to 16 of 16 in float64, half or more only where tracking_index
        <= 5.6e-14; up to 7 of 7 in float32, half or more only where tracking_index <= 5.3e-5.

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
    t7 = t5 * 7.450580596923828e-09
    t11 = tracking_index * 0.25
    t17 = tracking_index * 0.5
    t21 = tracking_index * (t2 + 2.7755575615628914e-17)
    t26 = tracking_index * (t2 + (t7 + 2.7755575615628914e-17))
    t27 = 1.1102230246251565e-16 / t26
    t29 = ((2.0 - t17) / t21) * ((2.0 + t17) * t27)
    t30 = t29 * 2.7755575615628914e-17
    t33 = (form.sqrt(abs(2.0 - t11)) / t7) * (form.sqrt(2.0 + t11) * t27)
    t34 = t33 * 2.7755575615628914e-17
    t36 = abs(t30) + t34
    t41 = t30 if tracking_index < 8.0 else -t36
    t43 = t30 if tracking_index < 8.0 else -((t27 / t36) * t27)
    t44 = t34 if tracking_index < 8.0 else form.of(0.0)
    t46 = -t34 if tracking_index < 8.0 else form.of(0.0)
    return (t41, t44, t43, t46)


def _closed_loop_poles_block(
    given: Arrays,
    out: Arrays,
    work: Arrays,
    single: bool,
    n0: float = 1.1102230246251565e-16,
    n1: float = 1.3877787807814457e-17,
    n2: float = 7.450580596923828e-09,
    n3: float = 0.25,
    n4: float = 2.0,
    n5: float = 0.5,
    n6: float = 2.7755575615628914e-17,
    n7: float = 8.0,
    n8: float = 0.0,
) -> None:
    (tracking_index,) = given
    first_real, first_imaginary, second_real, second_imaginary = out
    w0, w1, w2 = work
    kappa = divide(n0, tracking_index, first_real)
    t4 = add(kappa, n1, w0)
    rho_scaled = sqrt(t4, second_real)
    rho = multiply(rho_scaled, n2, second_real)
    t11 = multiply(tracking_index, n3, w0)
    t12 = subtract(n4, t11, w1)
    distance = absolute(t12, w1)
    below = sqrt(distance, first_imaginary)
    t15 = add(n4, t11, w0)
    above = sqrt(t15, second_imaginary)
    t17 = multiply(tracking_index, n5, w0)
    t18 = subtract(n4, t17, w1)
    t20 = add(kappa, n6, w2)
    t21 = multiply(tracking_index, t20, w2)
    t22 = divide(t18, t21, w1)
    t23 = add(n4, t17, w0)
    t24 = add(rho, n6, w2)
    t25 = add(kappa, t24, first_real)
    t26 = multiply(tracking_index, t25, first_real)
    t27 = divide(n0, t26, first_real)
    t28 = multiply(t23, t27, w0)
    t29 = multiply(t22, t28, w1)
    t30 = multiply(t29, n6, w1)
    t31 = divide(below, rho, first_imaginary)
    t32 = multiply(above, t27, second_imaginary)
    t33 = multiply(t31, t32, first_imaginary)
    t34 = multiply(t33, n6, first_imaginary)
    middle_size = absolute(t30, w0)
    t36 = add(middle_size, t34, w0)
    t37 = divide(t27, t36, w2)
    t38 = multiply(t37, t27, w2)
    t40 = negative(t36, w0)
    t42 = negative(t38, w2)
    t45 = negative(t34, second_imaginary)
    mask = mask_of(less(tracking_index, n7), single)
    choose(mask, t30, t40, out=first_real)
    choose(mask, t30, t42, out=second_real)
    choose(mask, t34, n8, out=first_imaginary)
    choose(mask, t45, n8, out=second_imaginary)


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
