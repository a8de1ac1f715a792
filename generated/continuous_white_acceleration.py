# Made by: gainproof generate continuous-white-acceleration
# From: gainproof derive continuous-white-acceleration, SymPy 1.14.0
"""Continuous white acceleration: steady state with measured position."""

from __future__ import annotations

from typing import TYPE_CHECKING

from numpy import absolute, add, divide, less, minimum, multiply, negative, sqrt, square, subtract

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
    "a number above 0 and below 1.2679491924311228",
    (5e-324, 1.2679491924311226),
    (1.401298464324817e-45, 1.267949104309082),
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
        kappa = sqrt(4/Lambda^2 + 1/12), rho = sqrt(kappa + 1/3) = alpha/beta,
        sigma = Lambda/beta = Lambda (1/2 + kappa + rho)/2

    tracking_index: Lambda, with Lambda^2 =
        acceleration_density*sampling_interval**3/measurement_deviation**2; a number above 0 and
        finite.

    alpha: position gain. Relative error at most 1.95 * 2^-52 (float64), 1.95 * 2^-23 (float32),
        proved for 5e-324 <= tracking_index <= 1.7976931348623157e308 (float64) and 1e-45 <=
        tracking_index <= 3.4028235e38 (float32).
    beta: velocity gain times the sampling interval. Relative error at most 2.67 * 2^-52 (float64),
        2.67 * 2^-23 (float32), proved for 2.2250738585072014e-308 <= tracking_index <=
        1.7976931348623157e308 (float64) and 1.1754944e-38 <= tracking_index <= 3.4028235e38
        (float32).

    Outside an output's range, a few numbers next to its ends apart, its true value is no normal
    number: it comes as 0, a subnormal number or infinity, never as NaN. Numbers and arrays are
    taken, arrays of any shape; inputs are broadcast. float64 and float32 stay what they are,
    integers become float64. `out`: a tuple of arrays to fill. `workers`: threads that share the
    work on long arrays.

    `accurate`: in double-words, tracking_index at least 2^-400 and at most 2^400: proved to be off
    by at most 0.5 + 2^-46 units in the last place (float64), 0.5 + 2^-26 (float32), where the true
    value is a normal number; takes 12 to 20 times as long, in float32 3 times.

    ValueError: an input outside its domain, with its place; `out` or `workers` that does not fit.
    TypeError: an input that is no real number of these types; in `out` what is no array of the
    results' type.

    Source: derivation continuous-white-acceleration
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
    t2 = tracking_index * 1.8014398509481984e16
    t5 = t2 if tracking_index < 0.75 else form.of(1.3510798882111488e16)
    t7 = 5.404319552844595e16 / tracking_index
    t9 = form.of(7.205759403792794e16) if tracking_index < 0.75 else t7
    t15 = form.sqrt((t9 * t9) + ((t5 * t5) / 3.0))
    t17 = t15 * 2.0
    t21 = t5 * (t17 + (t5 * 1.3333333333333333))
    t22 = form.sqrt(t21)
    t32 = (t5 / 6.0) / t22
    t39 = (t5 * 6.666666666666667) + ((t5 * 16.0) * (t32 * (t32 + 1.0)))
    t45 = (t5 * 1.152921504606847e18) / (t17 + ((t22 * 4.0) + t39))
    t27 = (t5 * 4.0) / (t15 + (t5 + t22))
    t48 = form.sqrt(t45) * 3.725290298461914e-09
    return (t48, t27)


def _gains_block(
    given: Arrays,
    out: Arrays,
    work: Arrays,
    _single: bool,
    n0: float = 1.8014398509481984e16,
    n1: float = 1.3510798882111488e16,
    n2: float = 5.404319552844595e16,
    n3: float = 7.205759403792794e16,
    n4: float = 3.0,
    n5: float = 2.0,
    n6: float = 1.3333333333333333,
    n7: float = 4.0,
    n8: float = 6.666666666666667,
    n9: float = 6.0,
    n10: float = 16.0,
    n11: float = 1.0,
    n12: float = 1.152921504606847e18,
    n13: float = 3.725290298461914e-09,
) -> None:
    (tracking_index,) = given
    alpha, beta = out
    w0, w1, w2, w3, w4, w5, w6 = work
    t2 = multiply(tracking_index, n0, w0)
    index_or_switch = minimum(t2, n1, out=w0)
    t7 = divide(n2, tracking_index, beta)
    four_or_less = minimum(n3, t7, out=beta)
    t10 = square(four_or_less, beta)
    t11 = square(index_or_switch, w1)
    t13 = divide(t11, n4, alpha)
    t14 = add(t10, t13, beta)
    eta_scaled = sqrt(t14, beta)
    t17 = multiply(eta_scaled, n5, w1)
    t19 = multiply(index_or_switch, n6, alpha)
    t20 = add(t17, t19, alpha)
    t21 = multiply(index_or_switch, t20, alpha)
    ratio_scaled = sqrt(t21, alpha)
    t24 = multiply(index_or_switch, n7, w2)
    t25 = add(index_or_switch, ratio_scaled, w3)
    t26 = add(eta_scaled, t25, beta)
    t29 = multiply(index_or_switch, n8, w3)
    t31 = divide(index_or_switch, n9, w4)
    t32 = divide(t31, ratio_scaled, w4)
    t34 = multiply(index_or_switch, n10, w5)
    t36 = add(t32, n11, w6)
    t37 = multiply(t32, t36, w4)
    t38 = multiply(t34, t37, w5)
    t39 = add(t29, t38, w3)
    t41 = multiply(index_or_switch, n12, w0)
    t42 = multiply(ratio_scaled, n7, alpha)
    t43 = add(t42, t39, alpha)
    t44 = add(t17, t43, w1)
    t45 = divide(t41, t44, w0)
    alpha_raised = sqrt(t45, w0)
    divide(t24, t26, beta)
    multiply(alpha_raised, n13, alpha)


_GAINS = Signature(
    "gains",
    (_TRACKING_INDEX_DOMAIN,),
    ("alpha", "beta"),
    7,
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
    p = root(tracking_index)
    t3 = divide((1.9721522630525295e-31, 0.0), tracking_index)
    t5 = multiply(tracking_index, (4.108650548026103e-33, 2.2807592192786735e-49))
    t6 = add(t3, t5)
    h_scaled = root(t6)
    kappa = divide(h_scaled, p)
    t10 = add(kappa, (7.401486830834377e-17, 4.108650548026103e-33))
    rho_scaled = root(t10)
    rho = scale(rho_scaled, 1.4901161193847656e-08)
    t15 = add(rho, (1.1102230246251565e-16, 0.0))
    t16 = add(kappa, t15)
    t18 = divide((2.0, 0.0), t16)
    t19 = multiply(t18, rho)
    t21 = scale(t18, 2.220446049250313e-16)
    return (t19[0], t21[0])


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

        d alpha = (1 + 1/6/kappa)/(rho sigma^2 Lambda),
        d beta = (2 + 1/rho)/(kappa sigma^2 Lambda)
        kappa = sqrt(4/Lambda^2 + 1/12), rho = sqrt(kappa + 1/3) = alpha/beta,
        sigma = Lambda/beta = Lambda (1/2 + kappa + rho)/2

    tracking_index: Lambda, with Lambda^2 =
        acceleration_density*sampling_interval**3/measurement_deviation**2; a number above 0 and
        finite.

    alpha: derivative of the position gain. Relative error at most 10.42 * 2^-52 (float64), 10.42 *
        2^-23 (float32), proved for 5e-324 <= tracking_index <= 5.247628584236248e102 (float64) and
        1e-45 <= tracking_index <= 6.49139e12 (float32).
    beta: derivative of the velocity gain times the sampling interval. Relative error at most 10.99
        * 2^-52 (float64), 10.99 * 2^-23 (float32), proved for 5e-324 <= tracking_index <=
        9.352083952218625e102 (float64) and 1e-45 <= tracking_index <= 1.1568659e13 (float32).

    Outside an output's range, a few numbers next to its ends apart, its true value is no normal
    number: it comes as 0, a subnormal number or infinity, never as NaN. Numbers and arrays are
    taken, arrays of any shape; inputs are broadcast. float64 and float32 stay what they are,
    integers become float64. `out`: a tuple of arrays to fill. `workers`: threads that share the
    work on long arrays.

    ValueError: an input outside its domain, with its place; `out` or `workers` that does not fit.
    TypeError: an input that is no real number of these types; in `out` what is no array of the
    results' type.

    Source: derivation continuous-white-acceleration
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
    t1 = form.sqrt(tracking_index)
    t3 = 1.9721522630525295e-31 / tracking_index
    t5 = tracking_index * 4.108650548026103e-33
    t7 = form.sqrt(t3 + t5)
    t8 = t7 / t1
    t12 = form.sqrt(t8 + 7.401486830834377e-17)
    t14 = t12 * 1.4901161193847656e-08
    t16 = t14 + 1.1102230246251565e-16
    t20 = 6.617444900424222e-24 / (tracking_index * (t8 + t16))
    t23 = ((t20 / (t1 * t7)) * t20) / t14
    t26 = t23 * (t8 + 3.700743415417188e-17)
    t29 = (t23 * 2.0) * t16
    return (t26, t29)


def _gain_derivatives_block(
    given: Arrays,
    out: Arrays,
    work: Arrays,
    _single: bool,
    n0: float = 1.9721522630525295e-31,
    n1: float = 4.108650548026103e-33,
    n2: float = 7.401486830834377e-17,
    n3: float = 1.4901161193847656e-08,
    n4: float = 1.1102230246251565e-16,
    n5: float = 6.617444900424222e-24,
    n6: float = 3.700743415417188e-17,
    n7: float = 2.0,
) -> None:
    (tracking_index,) = given
    alpha, beta = out
    w0, w1, w2 = work
    p = sqrt(tracking_index, alpha)
    t3 = divide(n0, tracking_index, beta)
    t5 = multiply(tracking_index, n1, w0)
    t6 = add(t3, t5, beta)
    h_scaled = sqrt(t6, beta)
    kappa = divide(h_scaled, p, w0)
    half_eta = multiply(p, h_scaled, alpha)
    t11 = add(kappa, n2, beta)
    rho_scaled = sqrt(t11, beta)
    rho = multiply(rho_scaled, n3, beta)
    t16 = add(rho, n4, w1)
    t17 = add(kappa, t16, w2)
    t18 = multiply(tracking_index, t17, w2)
    t20 = divide(n5, t18, w2)
    t21 = divide(t20, half_eta, alpha)
    t22 = multiply(t21, t20, alpha)
    t23 = divide(t22, rho, alpha)
    t25 = add(kappa, n6, w0)
    t28 = multiply(t23, n7, w2)
    multiply(t23, t25, alpha)
    multiply(t28, t16, beta)


_GAIN_DERIVATIVES = Signature(
    "gain_derivatives",
    (_TRACKING_INDEX_DOMAIN,),
    ("alpha", "beta"),
    3,
    _gain_derivatives_block,
    numbers=_gain_derivatives_of_numbers,
)


def gains_with_derivatives(
    tracking_index: ArrayLike, *, out: tuple[Real, Real, Real, Real] | None = None, workers: int = 1
) -> GainsWithDerivatives:
    """Filter gain and its first derivatives in one pass.

        alpha = 2 r/(p + h + r), beta = 4 p/(p + h + r), p = sqrt(Lambda),
        h = sqrt(16/Lambda + 1/3 Lambda), r = 2 rho p,
        kappa = sqrt(4/Lambda^2 + 1/12), rho = sqrt(kappa + 1/3) = alpha/beta,
        sigma = Lambda/beta = Lambda (1/2 + kappa + rho)/2

    tracking_index: Lambda, with Lambda^2 =
        acceleration_density*sampling_interval**3/measurement_deviation**2; a number above 0 and
        finite.

    alpha: position gain. Relative error at most 3.26 * 2^-52 (float64), 3.26 * 2^-23 (float32),
        proved for 5e-324 <= tracking_index <= 1.7976931348623157e308 (float64) and 1e-45 <=
        tracking_index <= 3.4028235e38 (float32).
    beta: velocity gain times the sampling interval. Relative error at most 3.01 * 2^-52 (float64),
        3.01 * 2^-23 (float32), proved for 2.2250738585072014e-308 <= tracking_index <=
        1.7976931348623157e308 (float64) and 1.1754944e-38 <= tracking_index <= 3.4028235e38
        (float32).
    d_alpha: derivative of the position gain. Relative error at most 12.02 * 2^-52 (float64), 12.02
        * 2^-23 (float32), proved for 5e-324 <= tracking_index <= 5.247628584236248e102 (float64)
        and 1e-45 <= tracking_index <= 6.49139e12 (float32).
    d_beta: derivative of the velocity gain times the sampling interval. Relative error at most
        13.17 * 2^-52 (float64), 13.17 * 2^-23 (float32), proved for 5e-324 <= tracking_index <=
        9.352083952218625e102 (float64) and 1e-45 <= tracking_index <= 1.1568659e13 (float32).

    Outside an output's range, a few numbers next to its ends apart, its true value is no normal
    number: it comes as 0, a subnormal number or infinity, never as NaN. Numbers and arrays are
    taken, arrays of any shape; inputs are broadcast. float64 and float32 stay what they are,
    integers become float64. `out`: a tuple of arrays to fill. `workers`: threads that share the
    work on long arrays.

    ValueError: an input outside its domain, with its place; `out` or `workers` that does not fit.
    TypeError: an input that is no real number of these types; in `out` what is no array of the
    results' type.

    Source: derivation continuous-white-acceleration
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
    t4 = t1 * 9.094947017729282e-13
    t6 = 1.3234889800848443e-23 / tracking_index
    t8 = tracking_index * 2.757268708510092e-25
    t10 = form.sqrt(t6 + t8)
    t12 = (t4 / 3.0) + t10
    t13 = t4 + t10
    t16 = form.sqrt(t4 * (t13 + t12))
    t19 = (t13 + t16) * 0.5
    t21 = t4 * 2.0
    t23 = t1 * t19
    t28 = 6.018531076210112e-36 / ((t23 * t23) * (t1 * t10))
    t20 = t16 / t19
    t22 = t21 / t19
    t30 = t28 * (t12 / t16)
    t33 = t28 * ((t21 / t16) + 2.0)
    return (t20, t22, t30, t33)


def _gains_with_derivatives_block(
    given: Arrays,
    out: Arrays,
    work: Arrays,
    _single: bool,
    n0: float = 9.094947017729282e-13,
    n1: float = 1.3234889800848443e-23,
    n2: float = 2.757268708510092e-25,
    n3: float = 3.0,
    n4: float = 0.5,
    n5: float = 2.0,
    n6: float = 6.018531076210112e-36,
) -> None:
    (tracking_index,) = given
    alpha, beta, d_alpha, d_beta = out
    w0, w1, w2, w3 = work
    p = sqrt(tracking_index, alpha)
    t4 = multiply(p, n0, w0)
    t6 = divide(n1, tracking_index, w1)
    t8 = multiply(tracking_index, n2, w2)
    t9 = add(t6, t8, w1)
    h_at_once = sqrt(t9, beta)
    t11 = divide(t4, n3, w1)
    t12 = add(t11, h_at_once, w1)
    t13 = add(t4, h_at_once, w2)
    t14 = add(t13, t12, w3)
    t15 = multiply(t4, t14, w3)
    twice_ratio = sqrt(t15, d_beta)
    t17 = add(t13, twice_ratio, w2)
    t19 = multiply(t17, n4, w2)
    t21 = multiply(t4, n5, w0)
    t23 = multiply(p, t19, w3)
    t24 = square(t23, w3)
    t25 = multiply(p, h_at_once, alpha)
    t26 = multiply(t24, t25, w3)
    t28 = divide(n6, t26, w3)
    divide(twice_ratio, t19, alpha)
    divide(t21, t19, beta)
    t29 = divide(t12, twice_ratio, d_alpha)
    multiply(t28, t29, d_alpha)
    t31 = divide(t21, twice_ratio, d_beta)
    t32 = add(t31, n5, d_beta)
    multiply(t28, t32, d_beta)


_GAINS_WITH_DERIVATIVES = Signature(
    "gains_with_derivatives",
    (_TRACKING_INDEX_DOMAIN,),
    ("alpha", "beta", "d_alpha", "d_beta"),
    4,
    _gains_with_derivatives_block,
    numbers=_gains_with_derivatives_of_numbers,
)


def predictor_gains(
    tracking_index: ArrayLike, *, out: tuple[Real, Real] | None = None, workers: int = 1
) -> PredictorGains:
    """Steady-state predictor gain F K.

        kappa = sqrt(4/Lambda^2 + 1/12), rho = sqrt(kappa + 1/3) = alpha/beta,
        sigma = Lambda/beta = Lambda (1/2 + kappa + rho)/2

    tracking_index: Lambda, with Lambda^2 =
        acceleration_density*sampling_interval**3/measurement_deviation**2; a number above 0 and
        finite.

    position: position entry of F K, alpha + beta. Relative error at most 2.76 * 2^-52 (float64),
        2.76 * 2^-23 (float32), proved for 5e-324 <= tracking_index <= 1.7976931348623157e308
        (float64) and 1e-45 <= tracking_index <= 3.4028235e38 (float32).
    velocity: velocity entry of F K times the sampling interval, beta. Relative error at most 2.67 *
        2^-52 (float64), 2.67 * 2^-23 (float32), proved for 2.2250738585072014e-308 <=
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

    Source: derivation continuous-white-acceleration
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
    t2 = tracking_index * 1.8014398509481984e16
    t5 = t2 if tracking_index < 0.75 else form.of(1.3510798882111488e16)
    t7 = 5.404319552844595e16 / tracking_index
    t9 = form.of(7.205759403792794e16) if tracking_index < 0.75 else t7
    t15 = form.sqrt((t9 * t9) + ((t5 * t5) / 3.0))
    t17 = t15 * 2.0
    t21 = t5 * (t17 + (t5 * 1.3333333333333333))
    t22 = form.sqrt(t21)
    t27 = (t5 * 4.0) / (t15 + (t5 + t22))
    t32 = (t5 / 6.0) / t22
    t39 = (t5 * 6.666666666666667) + ((t5 * 16.0) * (t32 * (t32 + 1.0)))
    t45 = (t5 * 1.152921504606847e18) / (t17 + ((t22 * 4.0) + t39))
    t48 = form.sqrt(t45) * 3.725290298461914e-09
    t49 = t48 + t27
    return (t49, t27)


def _predictor_gains_block(
    given: Arrays,
    out: Arrays,
    work: Arrays,
    _single: bool,
    n0: float = 1.8014398509481984e16,
    n1: float = 1.3510798882111488e16,
    n2: float = 5.404319552844595e16,
    n3: float = 7.205759403792794e16,
    n4: float = 3.0,
    n5: float = 2.0,
    n6: float = 1.3333333333333333,
    n7: float = 4.0,
    n8: float = 6.666666666666667,
    n9: float = 6.0,
    n10: float = 16.0,
    n11: float = 1.0,
    n12: float = 1.152921504606847e18,
    n13: float = 3.725290298461914e-09,
) -> None:
    (tracking_index,) = given
    position, velocity = out
    w0, w1, w2, w3, w4, w5 = work
    t2 = multiply(tracking_index, n0, w0)
    index_or_switch = minimum(t2, n1, out=w0)
    t7 = divide(n2, tracking_index, velocity)
    four_or_less = minimum(n3, t7, out=velocity)
    t10 = square(four_or_less, velocity)
    t11 = square(index_or_switch, w1)
    t13 = divide(t11, n4, position)
    t14 = add(t10, t13, velocity)
    eta_scaled = sqrt(t14, velocity)
    t17 = multiply(eta_scaled, n5, w1)
    t19 = multiply(index_or_switch, n6, position)
    t20 = add(t17, t19, position)
    t21 = multiply(index_or_switch, t20, position)
    ratio_scaled = sqrt(t21, position)
    t24 = multiply(index_or_switch, n7, w2)
    t25 = add(index_or_switch, ratio_scaled, w3)
    t26 = add(eta_scaled, t25, velocity)
    divide(t24, t26, velocity)
    t29 = multiply(index_or_switch, n8, w2)
    t31 = divide(index_or_switch, n9, w3)
    t32 = divide(t31, ratio_scaled, w3)
    t34 = multiply(index_or_switch, n10, w4)
    t36 = add(t32, n11, w5)
    t37 = multiply(t32, t36, w3)
    t38 = multiply(t34, t37, w4)
    t39 = add(t29, t38, w2)
    t41 = multiply(index_or_switch, n12, w0)
    t42 = multiply(ratio_scaled, n7, position)
    t43 = add(t42, t39, position)
    t44 = add(t17, t43, w1)
    t45 = divide(t41, t44, w0)
    alpha_raised = sqrt(t45, w0)
    t48 = multiply(alpha_raised, n13, w0)
    add(t48, velocity, position)


_PREDICTOR_GAINS = Signature(
    "predictor_gains",
    (_TRACKING_INDEX_DOMAIN,),
    ("position", "velocity"),
    6,
    _predictor_gains_block,
    numbers=_predictor_gains_of_numbers,
)


def predictor_gain_derivatives(
    tracking_index: ArrayLike, *, out: tuple[Real, Real] | None = None, workers: int = 1
) -> PredictorGainDerivatives:
    """First derivatives of the predictor gain.

        kappa = sqrt(4/Lambda^2 + 1/12), rho = sqrt(kappa + 1/3) = alpha/beta,
        sigma = Lambda/beta = Lambda (1/2 + kappa + rho)/2

    tracking_index: Lambda, with Lambda^2 =
        acceleration_density*sampling_interval**3/measurement_deviation**2; a number above 0 and
        finite.

    position: derivative of the position entry of F K, alpha + beta. Relative error at most 12.94 *
        2^-52 (float64), 12.94 * 2^-23 (float32), proved for 5e-324 <= tracking_index <=
        9.873247422805948e102 (float64) and 1e-45 <= tracking_index <= 1.2213346e13 (float32).
    velocity: derivative of the velocity entry of F K times the sampling interval, beta. Relative
        error at most 10.99 * 2^-52 (float64), 10.99 * 2^-23 (float32), proved for 5e-324 <=
        tracking_index <= 9.352083952218625e102 (float64) and 1e-45 <= tracking_index <=
        1.1568659e13 (float32).

    Outside an output's range, a few numbers next to its ends apart, its true value is no normal
    number: it comes as 0, a subnormal number or infinity, never as NaN. Numbers and arrays are
    taken, arrays of any shape; inputs are broadcast. float64 and float32 stay what they are,
    integers become float64. `out`: a tuple of arrays to fill. `workers`: threads that share the
    work on long arrays.

    ValueError: an input outside its domain, with its place; `out` or `workers` that does not fit.
    TypeError: an input that is no real number of these types; in `out` what is no array of the
    results' type.

    Source: derivation continuous-white-acceleration
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
    t1 = form.sqrt(tracking_index)
    t3 = 1.9721522630525295e-31 / tracking_index
    t5 = tracking_index * 4.108650548026103e-33
    t7 = form.sqrt(t3 + t5)
    t8 = t7 / t1
    t12 = form.sqrt(t8 + 7.401486830834377e-17)
    t14 = t12 * 1.4901161193847656e-08
    t16 = t14 + 1.1102230246251565e-16
    t20 = 6.617444900424222e-24 / (tracking_index * (t8 + t16))
    t23 = ((t20 / (t1 * t7)) * t20) / t14
    t29 = (t23 * 2.0) * t16
    t30 = (t23 * (t8 + 3.700743415417188e-17)) + t29
    return (t30, t29)


def _predictor_gain_derivatives_block(
    given: Arrays,
    out: Arrays,
    work: Arrays,
    _single: bool,
    n0: float = 1.9721522630525295e-31,
    n1: float = 4.108650548026103e-33,
    n2: float = 7.401486830834377e-17,
    n3: float = 1.4901161193847656e-08,
    n4: float = 1.1102230246251565e-16,
    n5: float = 6.617444900424222e-24,
    n6: float = 3.700743415417188e-17,
    n7: float = 2.0,
) -> None:
    (tracking_index,) = given
    position, velocity = out
    w0, w1, w2 = work
    p = sqrt(tracking_index, velocity)
    t3 = divide(n0, tracking_index, position)
    t5 = multiply(tracking_index, n1, w0)
    t6 = add(t3, t5, position)
    h_scaled = sqrt(t6, position)
    kappa = divide(h_scaled, p, w0)
    half_eta = multiply(p, h_scaled, velocity)
    t11 = add(kappa, n2, position)
    rho_scaled = sqrt(t11, position)
    rho = multiply(rho_scaled, n3, position)
    t16 = add(rho, n4, w1)
    t17 = add(kappa, t16, w2)
    t18 = multiply(tracking_index, t17, w2)
    t20 = divide(n5, t18, w2)
    t21 = divide(t20, half_eta, velocity)
    t22 = multiply(t21, t20, velocity)
    t23 = divide(t22, rho, velocity)
    t25 = add(kappa, n6, w0)
    t26 = multiply(t23, t25, w0)
    t28 = multiply(t23, n7, velocity)
    multiply(t28, t16, velocity)
    add(t26, velocity, position)


_PREDICTOR_GAIN_DERIVATIVES = Signature(
    "predictor_gain_derivatives",
    (_TRACKING_INDEX_DOMAIN,),
    ("position", "velocity"),
    3,
    _predictor_gain_derivatives_block,
    numbers=_predictor_gain_derivatives_of_numbers,
)


def predicted_covariance(
    tracking_index: ArrayLike, *, out: tuple[Real, Real, Real] | None = None, workers: int = 1
) -> PredictedCovariance:
    """Predicted covariance in units of sigma_v^2 and T.

        predicted_11 = rho Lambda sigma, predicted_12 = Lambda sigma,
        predicted_22 = Lambda^2 (rho + 1/2)
        kappa = sqrt(4/Lambda^2 + 1/12), rho = sqrt(kappa + 1/3) = alpha/beta,
        sigma = Lambda/beta = Lambda (1/2 + kappa + rho)/2

    tracking_index: Lambda, with Lambda^2 =
        acceleration_density*sampling_interval**3/measurement_deviation**2; a number above 0 and
        finite.

    predicted_11: variance of the predicted position over sigma_v^2. Relative error at most 5.78 *
        2^-52 (float64), 5.78 * 2^-23 (float32), proved for 5e-324 <= tracking_index <=
        1.7000419237042198e154 (float64) and 1e-45 <= tracking_index <= 2.3389442e19 (float32).
    predicted_12: covariance of predicted position and velocity times T/sigma_v^2. Relative error at
        most 3.53 * 2^-52 (float64), 3.53 * 2^-23 (float32), proved for 2.2250738585072014e-308 <=
        tracking_index <= 1.5097627491058368e154 (float64) and 1.1754944e-38 <= tracking_index <=
        2.0771551e19 (float32).
    predicted_22: variance of the predicted velocity times T^2/sigma_v^2. Relative error at most
        5.26 * 2^-52 (float64), 4.76 * 2^-23 (float32), proved for 6.278939363646863e-206 <=
        tracking_index <= 1.181098330382244e154 (float64) and 4.1033358e-26 <= tracking_index <=
        1.6249736e19 (float32).

    Outside an output's range, a few numbers next to its ends apart, its true value is no normal
    number: it comes as 0, a subnormal number or infinity, never as NaN. Numbers and arrays are
    taken, arrays of any shape; inputs are broadcast. float64 and float32 stay what they are,
    integers become float64. `out`: a tuple of arrays to fill. `workers`: threads that share the
    work on long arrays.

    ValueError: an input outside its domain, with its place; `out` or `workers` that does not fit.
    TypeError: an input that is no real number of these types; in `out` what is no array of the
    results' type.

    Source: derivation continuous-white-acceleration
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
    t3 = 1.9721522630525295e-31 / tracking_index
    t5 = tracking_index * 4.108650548026103e-33
    t8 = form.sqrt(t3 + t5) / form.sqrt(tracking_index)
    t11 = form.sqrt(t8 + 7.401486830834377e-17)
    t13 = t11 * 1.4901161193847656e-08
    t15 = t13 + 1.1102230246251565e-16
    t19 = (tracking_index * (t8 + t15)) * 2251799813685248.0
    t22 = (tracking_index * t13) * 4503599627370496.0
    t28 = tracking_index * ((t8 + 1.850371707708594e-17) / t15)
    t23 = t19 * t22
    t24 = tracking_index * t19
    t31 = (tracking_index * t28) + (tracking_index * tracking_index)
    return (t23, t24, t31)


def _predicted_covariance_block(
    given: Arrays,
    out: Arrays,
    work: Arrays,
    _single: bool,
    n0: float = 1.9721522630525295e-31,
    n1: float = 4.108650548026103e-33,
    n2: float = 7.401486830834377e-17,
    n3: float = 1.4901161193847656e-08,
    n4: float = 1.1102230246251565e-16,
    n5: float = 2251799813685248.0,
    n6: float = 4503599627370496.0,
    n7: float = 1.850371707708594e-17,
) -> None:
    (tracking_index,) = given
    predicted_11, predicted_12, predicted_22 = out
    w0, w1 = work
    p = sqrt(tracking_index, predicted_11)
    t3 = divide(n0, tracking_index, predicted_12)
    t5 = multiply(tracking_index, n1, w0)
    t6 = add(t3, t5, predicted_12)
    h_scaled = sqrt(t6, predicted_22)
    kappa = divide(h_scaled, p, predicted_22)
    t10 = add(kappa, n2, w0)
    rho_scaled = sqrt(t10, w0)
    rho = multiply(rho_scaled, n3, w0)
    t15 = add(rho, n4, predicted_11)
    t16 = add(kappa, t15, predicted_12)
    t17 = multiply(tracking_index, t16, predicted_12)
    t19 = multiply(t17, n5, predicted_12)
    t20 = multiply(tracking_index, rho, w0)
    t22 = multiply(t20, n6, w0)
    t26 = add(kappa, n7, predicted_22)
    t27 = divide(t26, t15, predicted_22)
    t28 = multiply(tracking_index, t27, predicted_22)
    t29 = multiply(tracking_index, t28, predicted_22)
    t30 = square(tracking_index, w1)
    multiply(t19, t22, predicted_11)
    multiply(tracking_index, t19, predicted_12)
    add(t29, t30, predicted_22)


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

        kappa = sqrt(4/Lambda^2 + 1/12), rho = sqrt(kappa + 1/3) = alpha/beta,
        sigma = Lambda/beta = Lambda (1/2 + kappa + rho)/2

    tracking_index: Lambda, with Lambda^2 =
        acceleration_density*sampling_interval**3/measurement_deviation**2; a number above 0 and
        finite.

    predicted_11: derivative of the variance of the predicted position over sigma_v^2. Relative
        error at most 7.76 * 2^-52 (float64), 7.76 * 2^-23 (float32), proved for 5e-324 <=
        tracking_index <= 1.4450712711759723e308 (float64) and 1e-45 <= tracking_index <=
        2.7353304e38 (float32).
    predicted_12: derivative of the covariance of predicted position and velocity times T/sigma_v^2.
        Relative error at most 4.07 * 2^-52 (float64), 4.06 * 2^-23 (float32), proved for 5e-324 <=
        tracking_index <= 1.1396917792938073e308 (float64) and 1e-45 <= tracking_index <=
        2.157287e38 (float32).
    predicted_22: derivative of the variance of the predicted velocity times T^2/sigma_v^2. Relative
        error at most 6.93 * 2^-52 (float64), 6.92 * 2^-23 (float32), proved for 5e-324 <=
        tracking_index <= 6.974966330158624e307 (float64) and 1e-45 <= tracking_index <=
        1.3202697e38 (float32).

    Outside an output's range, a few numbers next to its ends apart, its true value is no normal
    number: it comes as 0, a subnormal number or infinity, never as NaN. Numbers and arrays are
    taken, arrays of any shape; inputs are broadcast. float64 and float32 stay what they are,
    integers become float64. `out`: a tuple of arrays to fill. `workers`: threads that share the
    work on long arrays.

    ValueError: an input outside its domain, with its place; `out` or `workers` that does not fit.
    TypeError: an input that is no real number of these types; in `out` what is no array of the
    results' type.

    Source: derivation continuous-white-acceleration
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
    t3 = 1.9721522630525295e-31 / tracking_index
    t5 = tracking_index * 4.108650548026103e-33
    t8 = form.sqrt(t3 + t5) / form.sqrt(tracking_index)
    t11 = form.sqrt(t8 + 7.401486830834377e-17)
    t13 = t11 * 1.4901161193847656e-08
    t15 = t13 + 1.1102230246251565e-16
    t16 = t8 + t15
    t19 = (tracking_index * t16) * 2251799813685248.0
    t22 = (t8 + 3.700743415417188e-17) / t8
    t31 = 1.0 + (t22 * (1.1102230246251565e-16 / t13))
    t35 = (t8 + 1.850371707708594e-17) / t15
    t38 = 1.0 + ((t35 * 1.1102230246251565e-16) / t13)
    t45 = ((t8 + 2.220446049250313e-16) / t8) * (9.25185853854297e-18 / t13)
    t27 = t19 * (t22 * ((t16 / t13) * 0.5))
    t32 = t19 * t31
    t49 = (tracking_index * ((t35 * t38) + t45)) + (tracking_index * 2.0)
    return (t27, t32, t49)


def _predicted_covariance_derivatives_block(
    given: Arrays,
    out: Arrays,
    work: Arrays,
    _single: bool,
    n0: float = 1.9721522630525295e-31,
    n1: float = 4.108650548026103e-33,
    n2: float = 7.401486830834377e-17,
    n3: float = 1.4901161193847656e-08,
    n4: float = 1.1102230246251565e-16,
    n5: float = 2251799813685248.0,
    n6: float = 3.700743415417188e-17,
    n7: float = 0.5,
    n8: float = 1.0,
    n9: float = 1.850371707708594e-17,
    n10: float = 2.220446049250313e-16,
    n11: float = 9.25185853854297e-18,
    n12: float = 2.0,
) -> None:
    (tracking_index,) = given
    predicted_11, predicted_12, predicted_22 = out
    w0, w1, w2, w3 = work
    p = sqrt(tracking_index, predicted_11)
    t3 = divide(n0, tracking_index, predicted_12)
    t5 = multiply(tracking_index, n1, w0)
    t6 = add(t3, t5, predicted_12)
    h_scaled = sqrt(t6, predicted_22)
    kappa = divide(h_scaled, p, predicted_22)
    t10 = add(kappa, n2, w0)
    rho_scaled = sqrt(t10, w0)
    rho = multiply(rho_scaled, n3, w0)
    t15 = add(rho, n4, predicted_11)
    t16 = add(kappa, t15, predicted_12)
    t17 = multiply(tracking_index, t16, w1)
    t19 = multiply(t17, n5, w1)
    t21 = add(kappa, n6, w2)
    t22 = divide(t21, kappa, w2)
    t23 = divide(t16, rho, predicted_12)
    t25 = multiply(t23, n7, predicted_12)
    t26 = multiply(t22, t25, predicted_12)
    t28 = divide(n4, rho, w3)
    t29 = multiply(t22, t28, w2)
    t31 = add(n8, t29, w2)
    t34 = add(kappa, n9, w3)
    t35 = divide(t34, t15, w3)
    t36 = multiply(t35, n4, predicted_11)
    t37 = divide(t36, rho, predicted_11)
    t38 = add(n8, t37, predicted_11)
    t39 = multiply(t35, t38, w3)
    t41 = add(kappa, n10, predicted_11)
    t42 = divide(t41, kappa, predicted_11)
    t44 = divide(n11, rho, w0)
    t45 = multiply(t42, t44, predicted_11)
    t46 = add(t39, t45, w3)
    t47 = multiply(tracking_index, t46, w3)
    t48 = multiply(tracking_index, n12, w0)
    multiply(t19, t26, predicted_11)
    multiply(t19, t31, predicted_12)
    add(t47, t48, predicted_22)


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
        kappa = sqrt(4/Lambda^2 + 1/12), rho = sqrt(kappa + 1/3) = alpha/beta,
        sigma = Lambda/beta = Lambda (1/2 + kappa + rho)/2

    tracking_index: Lambda, with Lambda^2 =
        acceleration_density*sampling_interval**3/measurement_deviation**2; a number above 0 and
        finite.

    updated_11: variance of the updated position over sigma_v^2. Relative error at most 3.26 * 2^-52
        (float64), 3.26 * 2^-23 (float32), proved for 5e-324 <= tracking_index <=
        1.7976931348623157e308 (float64) and 1e-45 <= tracking_index <= 3.4028235e38 (float32).
    updated_12: covariance of updated position and velocity times T/sigma_v^2. Relative error at
        most 3.51 * 2^-52 (float64), 3.51 * 2^-23 (float32), proved for 2.2250738585072014e-308 <=
        tracking_index <= 1.7976931348623157e308 (float64) and 1.1754944e-38 <= tracking_index <=
        3.4028235e38 (float32).
    updated_22: variance of the updated velocity times T^2/sigma_v^2. Relative error at most 4.44 *
        2^-52 (float64), 4.44 * 2^-23 (float32), proved for 6.278939363646863e-206 <= tracking_index
        <= 2.4954742419024312e154 (float64) and 4.1033358e-26 <= tracking_index <= 3.4333126e19
        (float32).

    Outside an output's range, a few numbers next to its ends apart, its true value is no normal
    number: it comes as 0, a subnormal number or infinity, never as NaN. Numbers and arrays are
    taken, arrays of any shape; inputs are broadcast. float64 and float32 stay what they are,
    integers become float64. `out`: a tuple of arrays to fill. `workers`: threads that share the
    work on long arrays.

    ValueError: an input outside its domain, with its place; `out` or `workers` that does not fit.
    TypeError: an input that is no real number of these types; in `out` what is no array of the
    results' type.

    Source: derivation continuous-white-acceleration
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
    t3 = 1.9721522630525295e-31 / tracking_index
    t5 = tracking_index * 4.108650548026103e-33
    t8 = form.sqrt(t3 + t5) / form.sqrt(tracking_index)
    t11 = form.sqrt(t8 + 7.401486830834377e-17)
    t13 = t11 * 1.4901161193847656e-08
    t15 = t13 + 1.1102230246251565e-16
    t18 = 2.0 / (t8 + t15)
    t25 = tracking_index * ((t8 + 1.850371707708594e-17) / t15)
    t19 = t18 * t13
    t21 = t18 * 2.220446049250313e-16
    t26 = tracking_index * t25
    return (t19, t21, t26)


def _updated_covariance_block(
    given: Arrays,
    out: Arrays,
    work: Arrays,
    _single: bool,
    n0: float = 1.9721522630525295e-31,
    n1: float = 4.108650548026103e-33,
    n2: float = 7.401486830834377e-17,
    n3: float = 1.4901161193847656e-08,
    n4: float = 1.1102230246251565e-16,
    n5: float = 2.0,
    n6: float = 1.850371707708594e-17,
    n7: float = 2.220446049250313e-16,
) -> None:
    (tracking_index,) = given
    updated_11, updated_12, updated_22 = out
    (w0,) = work
    p = sqrt(tracking_index, updated_11)
    t3 = divide(n0, tracking_index, updated_12)
    t5 = multiply(tracking_index, n1, w0)
    t6 = add(t3, t5, updated_12)
    h_scaled = sqrt(t6, updated_22)
    kappa = divide(h_scaled, p, updated_22)
    t10 = add(kappa, n2, w0)
    rho_scaled = sqrt(t10, w0)
    rho = multiply(rho_scaled, n3, w0)
    t15 = add(rho, n4, updated_11)
    t16 = add(kappa, t15, updated_12)
    t18 = divide(n5, t16, updated_12)
    t23 = add(kappa, n6, updated_22)
    t24 = divide(t23, t15, updated_22)
    t25 = multiply(tracking_index, t24, updated_22)
    multiply(t18, rho, updated_11)
    multiply(t18, n7, updated_12)
    multiply(tracking_index, t25, updated_22)


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

        kappa = sqrt(4/Lambda^2 + 1/12), rho = sqrt(kappa + 1/3) = alpha/beta,
        sigma = Lambda/beta = Lambda (1/2 + kappa + rho)/2

    tracking_index: Lambda, with Lambda^2 =
        acceleration_density*sampling_interval**3/measurement_deviation**2; a number above 0 and
        finite.

    updated_11: derivative of the variance of the updated position over sigma_v^2. Relative error at
        most 10.42 * 2^-52 (float64), 10.42 * 2^-23 (float32), proved for 5e-324 <= tracking_index
        <= 5.247628584236248e102 (float64) and 1e-45 <= tracking_index <= 6.49139e12 (float32).
    updated_12: derivative of the covariance of updated position and velocity times T/sigma_v^2.
        Relative error at most 10.99 * 2^-52 (float64), 10.99 * 2^-23 (float32), proved for 5e-324
        <= tracking_index <= 9.352083952218625e102 (float64) and 1e-45 <= tracking_index <=
        1.1568659e13 (float32).
    updated_22: derivative of the variance of the updated velocity times T^2/sigma_v^2. Relative
        error at most 6.42 * 2^-52 (float64), 6.42 * 2^-23 (float32), proved for 5e-324 <=
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

    Source: derivation continuous-white-acceleration
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
    t1 = form.sqrt(tracking_index)
    t3 = 1.9721522630525295e-31 / tracking_index
    t5 = tracking_index * 4.108650548026103e-33
    t7 = form.sqrt(t3 + t5)
    t8 = t7 / t1
    t12 = form.sqrt(t8 + 7.401486830834377e-17)
    t14 = t12 * 1.4901161193847656e-08
    t16 = t14 + 1.1102230246251565e-16
    t20 = 6.617444900424222e-24 / (tracking_index * (t8 + t16))
    t23 = ((t20 / (t1 * t7)) * t20) / t14
    t32 = (t8 + 1.850371707708594e-17) / t16
    t36 = 1.0 + ((t32 * 1.1102230246251565e-16) / t14)
    t43 = ((t8 + 2.220446049250313e-16) / t8) * (9.25185853854297e-18 / t14)
    t26 = t23 * (t8 + 3.700743415417188e-17)
    t29 = (t23 * 2.0) * t16
    t45 = tracking_index * ((t32 * t36) + t43)
    return (t26, t29, t45)


def _updated_covariance_derivatives_block(
    given: Arrays,
    out: Arrays,
    work: Arrays,
    _single: bool,
    n0: float = 1.9721522630525295e-31,
    n1: float = 4.108650548026103e-33,
    n2: float = 7.401486830834377e-17,
    n3: float = 1.4901161193847656e-08,
    n4: float = 1.1102230246251565e-16,
    n5: float = 6.617444900424222e-24,
    n6: float = 3.700743415417188e-17,
    n7: float = 2.0,
    n8: float = 1.850371707708594e-17,
    n9: float = 1.0,
    n10: float = 2.220446049250313e-16,
    n11: float = 9.25185853854297e-18,
) -> None:
    (tracking_index,) = given
    updated_11, updated_12, updated_22 = out
    w0, w1, w2, w3, w4 = work
    p = sqrt(tracking_index, updated_11)
    t3 = divide(n0, tracking_index, updated_12)
    t5 = multiply(tracking_index, n1, w0)
    t6 = add(t3, t5, updated_12)
    h_scaled = sqrt(t6, updated_22)
    kappa = divide(h_scaled, p, w0)
    half_eta = multiply(p, h_scaled, updated_11)
    t11 = add(kappa, n2, updated_12)
    rho_scaled = sqrt(t11, updated_12)
    rho = multiply(rho_scaled, n3, updated_12)
    t16 = add(rho, n4, updated_22)
    t17 = add(kappa, t16, w1)
    t18 = multiply(tracking_index, t17, w1)
    t20 = divide(n5, t18, w1)
    t21 = divide(t20, half_eta, updated_11)
    t22 = multiply(t21, t20, updated_11)
    t23 = divide(t22, rho, updated_11)
    t25 = add(kappa, n6, w1)
    t28 = multiply(t23, n7, w2)
    t31 = add(kappa, n8, w3)
    t32 = divide(t31, t16, w3)
    t33 = multiply(t32, n4, w4)
    t34 = divide(t33, rho, w4)
    t36 = add(n9, t34, w4)
    t37 = multiply(t32, t36, w3)
    t39 = add(kappa, n10, w4)
    t40 = divide(t39, kappa, w4)
    t42 = divide(n11, rho, updated_12)
    t43 = multiply(t40, t42, w4)
    t44 = add(t37, t43, w3)
    multiply(t23, t25, updated_11)
    multiply(t28, t16, updated_12)
    multiply(tracking_index, t44, updated_22)


_UPDATED_COVARIANCE_DERIVATIVES = Signature(
    "updated_covariance_derivatives",
    (_TRACKING_INDEX_DOMAIN,),
    ("updated_11", "updated_12", "updated_22"),
    5,
    _updated_covariance_derivatives_block,
    numbers=_updated_covariance_derivatives_of_numbers,
)


def gain_second_derivatives(
    tracking_index: ArrayLike, *, out: tuple[Real, Real] | None = None, workers: int = 1
) -> GainSecondDerivatives:
    """Second derivatives of the filter gain, both negative.

        d2 alpha = -psi (psi + chi)/(sigma Lambda)^2, d2 beta negative, too.
        psi = (1 + e/(2 kappa))/rho with e = 1/3: sigma^2 grows like this power of Lambda, and psi
        itself like the power 1 - chi.
        kappa = sqrt(4/Lambda^2 + 1/12), rho = sqrt(kappa + 1/3) = alpha/beta,
        sigma = Lambda/beta = Lambda (1/2 + kappa + rho)/2

    tracking_index: Lambda, with Lambda^2 =
        acceleration_density*sampling_interval**3/measurement_deviation**2; a number above 0 and
        finite.

    alpha: second derivative by Lambda of the position gain. Relative error at most 17.20 * 2^-52
        (float64), 17.19 * 2^-23 (float32), proved for 1.5697348409117346e-206 <= tracking_index <=
        1.442954478563842e77 (float64) and 1.0258406e-26 <= tracking_index <= 5.3522156e09
        (float32).
    beta: second derivative by Lambda of the velocity gain times the sampling interval. Relative
        error at most 15.92 * 2^-52 (float64), 15.91 * 2^-23 (float32), proved for 5e-324 <=
        tracking_index <= 2.225674301282913e77 (float64) and 1e-45 <= tracking_index <= 8.2554844e09
        (float32).

    Outside an output's range, a few numbers next to its ends apart, its true value is no normal
    number: it comes as 0, a subnormal number or infinity, never as NaN. Numbers and arrays are
    taken, arrays of any shape; inputs are broadcast. float64 and float32 stay what they are,
    integers become float64. `out`: a tuple of arrays to fill. `workers`: threads that share the
    work on long arrays.

    ValueError: an input outside its domain, with its place; `out` or `workers` that does not fit.
    TypeError: an input that is no real number of these types; in `out` what is no array of the
    results' type.

    Source: derivation continuous-white-acceleration
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
    t1 = form.sqrt(tracking_index)
    t3 = 1.9721522630525295e-31 / tracking_index
    t5 = tracking_index * 4.108650548026103e-33
    t7 = form.sqrt(t3 + t5)
    t8 = t7 / t1
    t12 = form.sqrt(t8 + 7.401486830834377e-17)
    t14 = t12 * 1.4901161193847656e-08
    t18 = tracking_index * (t8 + (t14 + 1.1102230246251565e-16))
    t20 = 4.440892098500626e-16 / t18
    t23 = (t20 / tracking_index) * 2.220446049250313e-16
    t24 = t23 / t14
    t25 = 2.220446049250313e-16 / t8
    t29 = 1.0 + (t25 * 0.16666666666666666)
    t31 = 2.220446049250313e-16 / t14
    t35 = (t25 * 0.009259259259259259) + 0.041666666666666664
    t39 = t25 * ((t25 * t35) + 0.08333333333333333)
    t43 = t8 + ((t39 + 0.5) * 2.220446049250313e-16)
    t47 = (t29 * t29) + (t31 * (t43 * 2251799813685248.0))
    t52 = (t20 * 2.220446049250313e-16) / (t1 * t7)
    t56 = (t25 * 0.10185185185185185) + 0.6666666666666666
    t59 = (t8 + (t56 * 2.220446049250313e-16)) / t14
    t66 = ((t59 * 1.5) + t29) / (1.0 + (t25 * 0.3333333333333333))
    t70 = (2.0 + t31) * (t25 * 0.08333333333333333)
    t50 = -(t24 * (t24 * t47))
    t74 = -(t52 * (t52 * (t66 + t70)))
    return (t50, t74)


def _gain_second_derivatives_block(
    given: Arrays,
    out: Arrays,
    work: Arrays,
    _single: bool,
    n0: float = 1.9721522630525295e-31,
    n1: float = 4.108650548026103e-33,
    n2: float = 7.401486830834377e-17,
    n3: float = 1.4901161193847656e-08,
    n4: float = 1.1102230246251565e-16,
    n5: float = 4.440892098500626e-16,
    n6: float = 2.220446049250313e-16,
    n7: float = 0.16666666666666666,
    n8: float = 1.0,
    n9: float = 0.009259259259259259,
    n10: float = 0.041666666666666664,
    n11: float = 0.08333333333333333,
    n12: float = 0.5,
    n13: float = 2251799813685248.0,
    n14: float = 0.10185185185185185,
    n15: float = 0.6666666666666666,
    n16: float = 1.5,
    n17: float = 0.3333333333333333,
    n18: float = 2.0,
) -> None:
    (tracking_index,) = given
    alpha, beta = out
    w0, w1, w2, w3, w4, w5, w6, w7 = work
    p = sqrt(tracking_index, alpha)
    t3 = divide(n0, tracking_index, beta)
    t5 = multiply(tracking_index, n1, w0)
    t6 = add(t3, t5, beta)
    h_scaled = sqrt(t6, beta)
    kappa = divide(h_scaled, p, w0)
    half_eta = multiply(p, h_scaled, alpha)
    t11 = add(kappa, n2, beta)
    rho_scaled = sqrt(t11, beta)
    rho = multiply(rho_scaled, n3, beta)
    t16 = add(rho, n4, w1)
    t17 = add(kappa, t16, w1)
    t18 = multiply(tracking_index, t17, w1)
    t20 = divide(n5, t18, w1)
    t21 = divide(t20, tracking_index, w2)
    t23 = multiply(t21, n6, w2)
    t24 = divide(t23, rho, w2)
    t25 = divide(n6, kappa, w3)
    t27 = multiply(t25, n7, w4)
    t29 = add(n8, t27, w4)
    t30 = square(t29, w5)
    t31 = divide(n6, rho, w6)
    t33 = multiply(t25, n9, w7)
    t35 = add(t33, n10, w7)
    t36 = multiply(t25, t35, w7)
    t38 = add(t36, n11, w7)
    t39 = multiply(t25, t38, w7)
    t41 = add(t39, n12, w7)
    t42 = multiply(t41, n6, w7)
    t43 = add(kappa, t42, w7)
    t45 = multiply(t43, n13, w7)
    t46 = multiply(t31, t45, w7)
    t47 = add(t30, t46, w5)
    t48 = multiply(t24, t47, w5)
    t49 = multiply(t24, t48, w2)
    t51 = multiply(t20, n6, w1)
    t52 = divide(t51, half_eta, w1)
    t54 = multiply(t25, n14, w5)
    t56 = add(t54, n15, w5)
    t57 = multiply(t56, n6, w5)
    t58 = add(kappa, t57, w0)
    t59 = divide(t58, rho, w0)
    t61 = multiply(t59, n16, w0)
    t62 = add(t61, t29, w0)
    t64 = multiply(t25, n17, w4)
    t65 = add(n8, t64, w4)
    t66 = divide(t62, t65, w0)
    t68 = add(n18, t31, w6)
    t69 = multiply(t25, n11, w3)
    t70 = multiply(t68, t69, w6)
    t71 = add(t66, t70, w0)
    t72 = multiply(t52, t71, w0)
    t73 = multiply(t52, t72, w1)
    negative(t49, alpha)
    negative(t73, beta)


_GAIN_SECOND_DERIVATIVES = Signature(
    "gain_second_derivatives",
    (_TRACKING_INDEX_DOMAIN,),
    ("alpha", "beta"),
    8,
    _gain_second_derivatives_block,
    numbers=_gain_second_derivatives_of_numbers,
)


def predictor_gain_second_derivatives(
    tracking_index: ArrayLike, *, out: tuple[Real, Real] | None = None, workers: int = 1
) -> PredictorGainSecondDerivatives:
    """Second derivatives of the predictor gain.

        d2 (alpha + beta), d2 beta; both negative.
        kappa = sqrt(4/Lambda^2 + 1/12), rho = sqrt(kappa + 1/3) = alpha/beta,
        sigma = Lambda/beta = Lambda (1/2 + kappa + rho)/2

    tracking_index: Lambda, with Lambda^2 =
        acceleration_density*sampling_interval**3/measurement_deviation**2; a number above 0 and
        finite.

    position: second derivative by Lambda of the position entry of F K, alpha + beta. Relative error
        at most 19.21 * 2^-52 (float64), 19.20 * 2^-23 (float32), proved for 1.5697348409117355e-206
        <= tracking_index <= 2.318063502250569e77 (float64) and 1.0258408e-26 <= tracking_index <=
        8.598175e09 (float32).
    velocity: second derivative by Lambda of the velocity entry of F K times the sampling interval,
        beta. Relative error at most 15.92 * 2^-52 (float64), 15.91 * 2^-23 (float32), proved for
        5e-324 <= tracking_index <= 2.225674301282913e77 (float64) and 1e-45 <= tracking_index <=
        8.2554844e09 (float32).

    Outside an output's range, a few numbers next to its ends apart, its true value is no normal
    number: it comes as 0, a subnormal number or infinity, never as NaN. Numbers and arrays are
    taken, arrays of any shape; inputs are broadcast. float64 and float32 stay what they are,
    integers become float64. `out`: a tuple of arrays to fill. `workers`: threads that share the
    work on long arrays.

    ValueError: an input outside its domain, with its place; `out` or `workers` that does not fit.
    TypeError: an input that is no real number of these types; in `out` what is no array of the
    results' type.

    Source: derivation continuous-white-acceleration
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
    t1 = form.sqrt(tracking_index)
    t3 = 1.9721522630525295e-31 / tracking_index
    t5 = tracking_index * 4.108650548026103e-33
    t7 = form.sqrt(t3 + t5)
    t8 = t7 / t1
    t12 = form.sqrt(t8 + 7.401486830834377e-17)
    t14 = t12 * 1.4901161193847656e-08
    t18 = tracking_index * (t8 + (t14 + 1.1102230246251565e-16))
    t20 = 4.440892098500626e-16 / t18
    t21 = t20 / tracking_index
    t23 = 2.220446049250313e-16 / t14
    t24 = 2.220446049250313e-16 / t8
    t28 = 1.0 + (t24 * 0.16666666666666666)
    t33 = (t24 * 0.009259259259259259) + 0.041666666666666664
    t37 = t24 * ((t24 * t33) + 0.08333333333333333)
    t41 = t8 + ((t37 + 0.5) * 2.220446049250313e-16)
    t45 = (t28 * t28) + (t23 * (t41 * 2251799813685248.0))
    t51 = (t24 * 0.10185185185185185) + 0.6666666666666666
    t54 = (t8 + (t51 * 2.220446049250313e-16)) / t14
    t61 = ((t54 * 1.5) + t28) / (1.0 + (t24 * 0.3333333333333333))
    t65 = (2.0 + t23) * (t24 * 0.08333333333333333)
    t66 = t61 + t65
    t69 = (t23 * (t23 * t45)) + (t24 * (t24 * t66))
    t74 = (t20 * 2.220446049250313e-16) / (t1 * t7)
    t72 = -(t21 * (t21 * t69))
    t77 = -(t74 * (t74 * t66))
    return (t72, t77)


def _predictor_gain_second_derivatives_block(
    given: Arrays,
    out: Arrays,
    work: Arrays,
    _single: bool,
    n0: float = 1.9721522630525295e-31,
    n1: float = 4.108650548026103e-33,
    n2: float = 7.401486830834377e-17,
    n3: float = 1.4901161193847656e-08,
    n4: float = 1.1102230246251565e-16,
    n5: float = 4.440892098500626e-16,
    n6: float = 2.220446049250313e-16,
    n7: float = 0.16666666666666666,
    n8: float = 1.0,
    n9: float = 0.009259259259259259,
    n10: float = 0.041666666666666664,
    n11: float = 0.08333333333333333,
    n12: float = 0.5,
    n13: float = 2251799813685248.0,
    n14: float = 0.10185185185185185,
    n15: float = 0.6666666666666666,
    n16: float = 1.5,
    n17: float = 0.3333333333333333,
    n18: float = 2.0,
) -> None:
    (tracking_index,) = given
    position, velocity = out
    w0, w1, w2, w3, w4, w5, w6, w7 = work
    p = sqrt(tracking_index, position)
    t3 = divide(n0, tracking_index, velocity)
    t5 = multiply(tracking_index, n1, w0)
    t6 = add(t3, t5, velocity)
    h_scaled = sqrt(t6, velocity)
    kappa = divide(h_scaled, p, w0)
    half_eta = multiply(p, h_scaled, position)
    t11 = add(kappa, n2, velocity)
    rho_scaled = sqrt(t11, velocity)
    rho = multiply(rho_scaled, n3, velocity)
    t16 = add(rho, n4, w1)
    t17 = add(kappa, t16, w1)
    t18 = multiply(tracking_index, t17, w1)
    t20 = divide(n5, t18, w1)
    t21 = divide(t20, tracking_index, w2)
    t23 = divide(n6, rho, w3)
    t24 = divide(n6, kappa, w4)
    t26 = multiply(t24, n7, w5)
    t28 = add(n8, t26, w5)
    t29 = square(t28, w6)
    t31 = multiply(t24, n9, w7)
    t33 = add(t31, n10, w7)
    t34 = multiply(t24, t33, w7)
    t36 = add(t34, n11, w7)
    t37 = multiply(t24, t36, w7)
    t39 = add(t37, n12, w7)
    t40 = multiply(t39, n6, w7)
    t41 = add(kappa, t40, w7)
    t43 = multiply(t41, n13, w7)
    t44 = multiply(t23, t43, w7)
    t45 = add(t29, t44, w6)
    t46 = multiply(t23, t45, w6)
    t47 = multiply(t23, t46, w6)
    t49 = multiply(t24, n14, w7)
    t51 = add(t49, n15, w7)
    t52 = multiply(t51, n6, w7)
    t53 = add(kappa, t52, w0)
    t54 = divide(t53, rho, w0)
    t56 = multiply(t54, n16, w0)
    t57 = add(t56, t28, w0)
    t59 = multiply(t24, n17, w5)
    t60 = add(n8, t59, w5)
    t61 = divide(t57, t60, w0)
    t63 = add(n18, t23, w3)
    t64 = multiply(t24, n11, w5)
    t65 = multiply(t63, t64, w3)
    t66 = add(t61, t65, w0)
    t67 = multiply(t24, t66, w3)
    t68 = multiply(t24, t67, w4)
    t69 = add(t47, t68, w6)
    t70 = multiply(t21, t69, w6)
    t71 = multiply(t21, t70, w2)
    t73 = multiply(t20, n6, w1)
    t74 = divide(t73, half_eta, w1)
    t75 = multiply(t74, t66, w0)
    t76 = multiply(t74, t75, w1)
    negative(t71, position)
    negative(t76, velocity)


_PREDICTOR_GAIN_SECOND_DERIVATIVES = Signature(
    "predictor_gain_second_derivatives",
    (_TRACKING_INDEX_DOMAIN,),
    ("position", "velocity"),
    8,
    _predictor_gain_second_derivatives_block,
    numbers=_predictor_gain_second_derivatives_of_numbers,
)


def predicted_covariance_second_derivatives(
    tracking_index: ArrayLike, *, out: tuple[Real, Real, Real] | None = None, workers: int = 1
) -> PredictedCovarianceSecondDerivatives:
    """Second derivatives of the predicted covariance.

        d2 M11 = (sigma/Lambda)^2 psi (psi - chi), first negative, then positive.
        d2 M12 = (sigma/Lambda) (psi/2) (2 + psi/2 - chi), d2 M22 = 2 + d2 X22.
        psi = (1 + e/(2 kappa))/rho with e = 1/3: sigma^2 grows like this power of Lambda, and psi
        itself like the power 1 - chi.
        kappa = sqrt(4/Lambda^2 + 1/12), rho = sqrt(kappa + 1/3) = alpha/beta,
        sigma = Lambda/beta = Lambda (1/2 + kappa + rho)/2

    tracking_index: Lambda, with Lambda^2 =
        acceleration_density*sampling_interval**3/measurement_deviation**2; a number above 0 and
        finite.

    predicted_11: second derivative by Lambda of the variance of the predicted position over
        sigma_v^2. Error over the sum of its terms' sizes at most 14.28 * 2^-52 (float64), 14.41 *
        2^-23 (float32), proved for 1.569734840911731e-206 <= tracking_index <=
        1.7976931348623157e308 (float64) and 1.0258393e-26 <= tracking_index <= 3.4028235e38
        (float32). Cancellation, condition number 1: the variance bends down for a small index and
        up for a large one, so that it vanishes between. Digits that can be lost: up to 16 of 16 in
        float64, half or more only where 0.502633 <= tracking_index <= 0.50274; up to 7 of 7 in
        float32, half or more only where 0.47 <= tracking_index <= 0.53.
    predicted_12: second derivative by Lambda of the covariance of predicted position and velocity
        times T/sigma_v^2. Relative error at most 7.54 * 2^-52 (float64), 7.54 * 2^-23 (float32),
        proved for 5e-324 <= tracking_index <= 1.7976931348623157e308 (float64) and 1e-45 <=
        tracking_index <= 3.4028235e38 (float32).
    predicted_22: second derivative by Lambda of the variance of the predicted velocity times
        T^2/sigma_v^2. Relative error at most 13.77 * 2^-52 (float64), 13.85 * 2^-23 (float32),
        proved for 5e-324 <= tracking_index <= 1.7976931348623157e308 (float64) and 1e-45 <=
        tracking_index <= 3.4028235e38 (float32).

    Outside an output's range, a few numbers next to its ends apart, its true value is no normal
    number: it comes as 0, a subnormal number or infinity, never as NaN. Numbers and arrays are
    taken, arrays of any shape; inputs are broadcast. float64 and float32 stay what they are,
    integers become float64. `out`: a tuple of arrays to fill. `workers`: threads that share the
    work on long arrays.

    ValueError: an input outside its domain, with its place; `out` or `workers` that does not fit.
    TypeError: an input that is no real number of these types; in `out` what is no array of the
    results' type.

    Source: derivation continuous-white-acceleration
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
    t1 = form.sqrt(tracking_index)
    t3 = 1.9721522630525295e-31 / tracking_index
    t5 = tracking_index * 4.108650548026103e-33
    t7 = form.sqrt(t3 + t5)
    t8 = t7 / t1
    t11 = t8 + 7.401486830834377e-17
    t14 = form.sqrt(t11) * 1.4901161193847656e-08
    t16 = t14 + 1.1102230246251565e-16
    t17 = t8 + t16
    t18 = t17 / t14
    t20 = t18 * 0.5
    t22 = 2.220446049250313e-16 / t8
    t26 = 1.0 + (t22 * 0.16666666666666666)
    t27 = t20 * t26
    t36 = (t22 * 0.009259259259259259) + 0.041666666666666664
    t40 = t22 * ((t22 * t36) + 0.08333333333333333)
    t44 = t8 + ((t40 + 0.5) * 2.220446049250313e-16)
    t47 = (t17 * 2251799813685248.0) * ((t44 / t11) * 0.5)
    t49 = ((t27 * 2.220446049250313e-16) * t27) - ((t20 * 2.220446049250313e-16) * t47)
    t55 = 2.220446049250313e-16 / t14
    t60 = (1.9721522630525295e-31 / (t1 * t7)) / tracking_index
    t63 = t60 / t8
    t66 = 3.700743415417188e-17 / (t8 + 3.700743415417188e-17)
    t69 = (1.0 + ((t26 * t55) * 0.5)) + (((t60 / t11) * 0.5) + (t63 * t66))
    t75 = (t8 + 1.850371707708594e-17) / t16
    t78 = 1.0 + t22
    t80 = ((t75 * 2.220446049250313e-16) * t75) + (t78 * 1.850371707708594e-17)
    t85 = (t80 / t11) * ((t60 + (t80 * 0.5)) / t14)
    t90 = (t78 + (t63 * (t22 * 0.5))) * 0.08333333333333333
    t51 = t49 * 4503599627370496.0
    t72 = (t18 * t26) * (t69 * 0.25)
    t93 = ((t85 * 0.5) + (t55 * t90)) + 2.0
    return (t51, t72, t93)


def _predicted_covariance_second_derivatives_block(
    given: Arrays,
    out: Arrays,
    work: Arrays,
    _single: bool,
    n0: float = 1.9721522630525295e-31,
    n1: float = 4.108650548026103e-33,
    n2: float = 7.401486830834377e-17,
    n3: float = 1.4901161193847656e-08,
    n4: float = 1.1102230246251565e-16,
    n5: float = 0.5,
    n6: float = 2.220446049250313e-16,
    n7: float = 0.16666666666666666,
    n8: float = 1.0,
    n9: float = 2251799813685248.0,
    n10: float = 0.009259259259259259,
    n11: float = 0.041666666666666664,
    n12: float = 0.08333333333333333,
    n13: float = 3.700743415417188e-17,
    n14: float = 0.25,
    n15: float = 1.850371707708594e-17,
    n16: float = 4503599627370496.0,
    n17: float = 2.0,
) -> None:
    (tracking_index,) = given
    predicted_11, predicted_12, predicted_22 = out
    w0, w1, w2, w3, w4, w5, w6, w7, w8, w9 = work
    p = sqrt(tracking_index, predicted_11)
    t3 = divide(n0, tracking_index, predicted_12)
    t5 = multiply(tracking_index, n1, w0)
    t6 = add(t3, t5, predicted_12)
    h_scaled = sqrt(t6, predicted_22)
    kappa = divide(h_scaled, p, w0)
    half_eta = multiply(p, h_scaled, predicted_11)
    t11 = add(kappa, n2, predicted_12)
    rho_scaled = sqrt(t11, predicted_22)
    rho = multiply(rho_scaled, n3, predicted_22)
    t16 = add(rho, n4, w1)
    t17 = add(kappa, t16, w2)
    t18 = divide(t17, rho, w3)
    t20 = multiply(t18, n5, w4)
    t22 = divide(n6, kappa, w5)
    t24 = multiply(t22, n7, w6)
    t26 = add(n8, t24, w6)
    t27 = multiply(t20, t26, w7)
    t28 = multiply(t27, n6, w8)
    t29 = multiply(t28, t27, w8)
    t30 = multiply(t20, n6, w4)
    t32 = multiply(t17, n9, w2)
    t34 = multiply(t22, n10, w7)
    t36 = add(t34, n11, w7)
    t37 = multiply(t22, t36, w7)
    t39 = add(t37, n12, w7)
    t40 = multiply(t22, t39, w7)
    t42 = add(t40, n5, w7)
    t43 = multiply(t42, n6, w7)
    t44 = add(kappa, t43, w7)
    t45 = divide(t44, t11, w7)
    t46 = multiply(t45, n5, w7)
    t47 = multiply(t32, t46, w2)
    t48 = multiply(t30, t47, w4)
    predicted_11_turn = subtract(t29, t48, w8)
    t54 = multiply(t18, t26, w3)
    t55 = divide(n6, rho, w2)
    t56 = multiply(t26, t55, w6)
    t57 = multiply(t56, n5, w6)
    t58 = add(n8, t57, w6)
    t59 = divide(n0, half_eta, predicted_11)
    t60 = divide(t59, tracking_index, predicted_11)
    t61 = divide(t60, t11, w4)
    t62 = multiply(t61, n5, w4)
    t63 = divide(t60, kappa, w7)
    t65 = add(kappa, n13, w9)
    t66 = divide(n13, t65, w9)
    t67 = multiply(t63, t66, w9)
    t68 = add(t62, t67, w4)
    t69 = add(t58, t68, w6)
    t71 = multiply(t69, n14, w6)
    t74 = add(kappa, n15, w0)
    t75 = divide(t74, t16, w0)
    t76 = multiply(t75, n6, w1)
    t77 = multiply(t76, t75, w1)
    t78 = add(n8, t22, w0)
    t79 = multiply(t78, n15, w4)
    t80 = add(t77, t79, w1)
    t81 = divide(t80, t11, predicted_12)
    t82 = multiply(t80, n5, w1)
    t83 = add(t60, t82, predicted_11)
    t84 = divide(t83, rho, predicted_11)
    t85 = multiply(t81, t84, predicted_12)
    t86 = multiply(t85, n5, predicted_12)
    t87 = multiply(t22, n5, w5)
    t88 = multiply(t63, t87, w7)
    t89 = add(t78, t88, w0)
    t90 = multiply(t89, n12, w0)
    t91 = multiply(t55, t90, w2)
    t92 = add(t86, t91, w2)
    multiply(predicted_11_turn, n16, predicted_11)
    multiply(t54, t71, predicted_12)
    add(t92, n17, predicted_22)


_PREDICTED_COVARIANCE_SECOND_DERIVATIVES = Signature(
    "predicted_covariance_second_derivatives",
    (_TRACKING_INDEX_DOMAIN,),
    ("predicted_11", "predicted_12", "predicted_22"),
    10,
    _predicted_covariance_second_derivatives_block,
    numbers=_predicted_covariance_second_derivatives_of_numbers,
)


def updated_covariance_second_derivatives(
    tracking_index: ArrayLike, *, out: tuple[Real, Real, Real] | None = None, workers: int = 1
) -> UpdatedCovarianceSecondDerivatives:
    """Second derivatives of the updated covariance.

        X11 = alpha and X12 = beta bend down, X22 bends up.
        kappa = sqrt(4/Lambda^2 + 1/12), rho = sqrt(kappa + 1/3) = alpha/beta,
        sigma = Lambda/beta = Lambda (1/2 + kappa + rho)/2

    tracking_index: Lambda, with Lambda^2 =
        acceleration_density*sampling_interval**3/measurement_deviation**2; a number above 0 and
        finite.

    updated_11: second derivative by Lambda of the variance of the updated position over sigma_v^2.
        Relative error at most 17.20 * 2^-52 (float64), 17.19 * 2^-23 (float32), proved for
        1.5697348409117346e-206 <= tracking_index <= 1.442954478563842e77 (float64) and
        1.0258406e-26 <= tracking_index <= 5.3522156e09 (float32).
    updated_12: second derivative by Lambda of the covariance of updated position and velocity times
        T/sigma_v^2. Relative error at most 15.92 * 2^-52 (float64), 15.91 * 2^-23 (float32), proved
        for 5e-324 <= tracking_index <= 2.225674301282913e77 (float64) and 1e-45 <= tracking_index
        <= 8.2554844e09 (float32).
    updated_22: second derivative by Lambda of the variance of the updated velocity times
        T^2/sigma_v^2. Relative error at most 13.26 * 2^-52 (float64), 13.26 * 2^-23 (float32),
        proved for 5e-324 <= tracking_index <= 1.7976931348623157e308 (float64) and 1e-45 <=
        tracking_index <= 3.4028235e38 (float32).

    Outside an output's range, a few numbers next to its ends apart, its true value is no normal
    number: it comes as 0, a subnormal number or infinity, never as NaN. Numbers and arrays are
    taken, arrays of any shape; inputs are broadcast. float64 and float32 stay what they are,
    integers become float64. `out`: a tuple of arrays to fill. `workers`: threads that share the
    work on long arrays.

    ValueError: an input outside its domain, with its place; `out` or `workers` that does not fit.
    TypeError: an input that is no real number of these types; in `out` what is no array of the
    results' type.

    Source: derivation continuous-white-acceleration
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
    t1 = form.sqrt(tracking_index)
    t3 = 1.9721522630525295e-31 / tracking_index
    t5 = tracking_index * 4.108650548026103e-33
    t7 = form.sqrt(t3 + t5)
    t8 = t7 / t1
    t9 = t1 * t7
    t11 = t8 + 7.401486830834377e-17
    t14 = form.sqrt(t11) * 1.4901161193847656e-08
    t16 = t14 + 1.1102230246251565e-16
    t20 = 4.440892098500626e-16 / (tracking_index * (t8 + t16))
    t23 = (t20 / tracking_index) * 2.220446049250313e-16
    t24 = t23 / t14
    t25 = 2.220446049250313e-16 / t8
    t29 = 1.0 + (t25 * 0.16666666666666666)
    t31 = 2.220446049250313e-16 / t14
    t35 = (t25 * 0.009259259259259259) + 0.041666666666666664
    t39 = t25 * ((t25 * t35) + 0.08333333333333333)
    t43 = t8 + ((t39 + 0.5) * 2.220446049250313e-16)
    t47 = (t29 * t29) + (t31 * (t43 * 2251799813685248.0))
    t52 = (t20 * 2.220446049250313e-16) / t9
    t56 = (t25 * 0.10185185185185185) + 0.6666666666666666
    t59 = (t8 + (t56 * 2.220446049250313e-16)) / t14
    t66 = ((t59 * 1.5) + t29) / (1.0 + (t25 * 0.3333333333333333))
    t70 = (2.0 + t31) * (t25 * 0.08333333333333333)
    t76 = (1.9721522630525295e-31 / t9) / tracking_index
    t80 = (t8 + 1.850371707708594e-17) / t16
    t83 = 1.0 + t25
    t85 = ((t80 * 2.220446049250313e-16) * t80) + (t83 * 1.850371707708594e-17)
    t90 = (t85 / t11) * ((t76 + (t85 * 0.5)) / t14)
    t95 = (t83 + ((t76 / t8) * (t25 * 0.5))) * 0.08333333333333333
    t50 = -(t24 * (t24 * t47))
    t74 = -(t52 * (t52 * (t66 + t70)))
    t97 = (t90 * 0.5) + (t31 * t95)
    return (t50, t74, t97)


def _updated_covariance_second_derivatives_block(
    given: Arrays,
    out: Arrays,
    work: Arrays,
    _single: bool,
    n0: float = 1.9721522630525295e-31,
    n1: float = 4.108650548026103e-33,
    n2: float = 7.401486830834377e-17,
    n3: float = 1.4901161193847656e-08,
    n4: float = 1.1102230246251565e-16,
    n5: float = 4.440892098500626e-16,
    n6: float = 2.220446049250313e-16,
    n7: float = 0.16666666666666666,
    n8: float = 1.0,
    n9: float = 0.009259259259259259,
    n10: float = 0.041666666666666664,
    n11: float = 0.08333333333333333,
    n12: float = 0.5,
    n13: float = 2251799813685248.0,
    n14: float = 0.10185185185185185,
    n15: float = 0.6666666666666666,
    n16: float = 1.5,
    n17: float = 0.3333333333333333,
    n18: float = 2.0,
    n19: float = 1.850371707708594e-17,
) -> None:
    (tracking_index,) = given
    updated_11, updated_12, updated_22 = out
    w0, w1, w2, w3, w4, w5, w6, w7, w8 = work
    p = sqrt(tracking_index, updated_11)
    t3 = divide(n0, tracking_index, updated_12)
    t5 = multiply(tracking_index, n1, w0)
    t6 = add(t3, t5, updated_12)
    h_scaled = sqrt(t6, updated_22)
    kappa = divide(h_scaled, p, w0)
    half_eta = multiply(p, h_scaled, updated_11)
    t11 = add(kappa, n2, updated_12)
    rho_scaled = sqrt(t11, updated_22)
    rho = multiply(rho_scaled, n3, updated_22)
    t16 = add(rho, n4, w1)
    t17 = add(kappa, t16, w2)
    t18 = multiply(tracking_index, t17, w2)
    t20 = divide(n5, t18, w2)
    t21 = divide(t20, tracking_index, w3)
    t23 = multiply(t21, n6, w3)
    t24 = divide(t23, rho, w3)
    t25 = divide(n6, kappa, w4)
    t27 = multiply(t25, n7, w5)
    t29 = add(n8, t27, w5)
    t30 = square(t29, w6)
    t31 = divide(n6, rho, w7)
    t33 = multiply(t25, n9, w8)
    t35 = add(t33, n10, w8)
    t36 = multiply(t25, t35, w8)
    t38 = add(t36, n11, w8)
    t39 = multiply(t25, t38, w8)
    t41 = add(t39, n12, w8)
    t42 = multiply(t41, n6, w8)
    t43 = add(kappa, t42, w8)
    t45 = multiply(t43, n13, w8)
    t46 = multiply(t31, t45, w8)
    t47 = add(t30, t46, w6)
    t48 = multiply(t24, t47, w6)
    t49 = multiply(t24, t48, w3)
    t51 = multiply(t20, n6, w2)
    t52 = divide(t51, half_eta, w2)
    t54 = multiply(t25, n14, w6)
    t56 = add(t54, n15, w6)
    t57 = multiply(t56, n6, w6)
    t58 = add(kappa, t57, w6)
    t59 = divide(t58, rho, w6)
    t61 = multiply(t59, n16, w6)
    t62 = add(t61, t29, w6)
    t64 = multiply(t25, n17, w5)
    t65 = add(n8, t64, w5)
    t66 = divide(t62, t65, w6)
    t68 = add(n18, t31, w5)
    t69 = multiply(t25, n11, w8)
    t70 = multiply(t68, t69, w5)
    t71 = add(t66, t70, w6)
    t72 = multiply(t52, t71, w6)
    t73 = multiply(t52, t72, w2)
    t75 = divide(n0, half_eta, updated_11)
    t76 = divide(t75, tracking_index, updated_11)
    t77 = divide(t76, kappa, w5)
    t79 = add(kappa, n19, w0)
    t80 = divide(t79, t16, w0)
    t81 = multiply(t80, n6, w1)
    t82 = multiply(t81, t80, w1)
    t83 = add(n8, t25, w0)
    t84 = multiply(t83, n19, w6)
    t85 = add(t82, t84, w1)
    t86 = divide(t85, t11, updated_12)
    t87 = multiply(t85, n12, w1)
    t88 = add(t76, t87, updated_11)
    t89 = divide(t88, rho, updated_11)
    t90 = multiply(t86, t89, updated_12)
    t91 = multiply(t90, n12, w1)
    t92 = multiply(t25, n12, w4)
    t93 = multiply(t77, t92, w5)
    t94 = add(t83, t93, w0)
    t95 = multiply(t94, n11, w0)
    t96 = multiply(t31, t95, w7)
    negative(t49, updated_11)
    negative(t73, updated_12)
    add(t91, t96, updated_22)


_UPDATED_COVARIANCE_SECOND_DERIVATIVES = Signature(
    "updated_covariance_second_derivatives",
    (_TRACKING_INDEX_DOMAIN,),
    ("updated_11", "updated_12", "updated_22"),
    9,
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
        kappa = sqrt(4/Lambda^2 + 1/12), rho = sqrt(kappa + 1/3) = alpha/beta,
        sigma = Lambda/beta = Lambda (1/2 + kappa + rho)/2

    tracking_index: Lambda, with Lambda^2 =
        acceleration_density*sampling_interval**3/measurement_deviation**2; a number above 0 and
        finite.

    first_real: real part of the first pole. Error over first_modulus at most 10.67 * 2^-52
        (float64), 10.58 * 2^-23 (float32), proved for 5e-324 <= tracking_index <=
        1.7976931348623157e308 (float64) and 1e-45 <= tracking_index <= 3.4028235e38 (float32).
        Digits that can be lost: up to 3.8 of 16 in float64; up to 2.3 of 7 in float32, a quarter or
        more only where 2.1 <= tracking_index <= 8.2.
    first_imaginary: imaginary part of the first pole, not negative. Error over first_modulus at
        most 8.13 * 2^-52 (float64), 8.13 * 2^-23 (float32), proved for 5e-324 <= tracking_index <=
        1.7976931348623157e308 (float64) and 1e-45 <= tracking_index <= 3.4028235e38 (float32).
        Digits that can be lost: up to 16 of 16 in float64, half or more only where tracking_index
        <= 8.4e-14; up to 7 of 7 in float32, half or more only where tracking_index <= 8.8e-5.
    second_real: real part of the second pole. Error over second_modulus at most 10.67 * 2^-52
        (float64), 10.58 * 2^-23 (float32), proved for 5e-324 <= tracking_index <=
        1.6421143998800672e154 (float64) and 1e-45 <= tracking_index <= 2.2592554e19 (float32).
        Digits that can be lost: up to 3.4 of 16 in float64; up to 2.1 of 7 in float32, a quarter or
        more only where 1.9 <= tracking_index <= 8.4.
    second_imaginary: imaginary part of the second pole, not positive. Error over second_modulus at
        most 8.13 * 2^-52 (float64), 8.13 * 2^-23 (float32), proved for 5e-324 <= tracking_index <=
        1.6421143998800672e154 (float64) and 1e-45 <= tracking_index <= 2.2592554e19 (float32).
        Digits that can be lost: up to 16 of 16 in float64, half or more only where tracking_index
        <= 1.1e-13; up to 7 of 7 in float32, half or more only where tracking_index <= 0.00011.

    Outside an output's range, a few numbers next to its ends apart, its true value is no normal
    number: it comes as 0, a subnormal number or infinity, never as NaN. Numbers and arrays are
    taken, arrays of any shape; inputs are broadcast. float64 and float32 stay what they are,
    integers become float64. `out`: a tuple of arrays to fill. `workers`: threads that share the
    work on long arrays.

    ValueError: an input outside its domain, with its place; `out` or `workers` that does not fit.
    TypeError: an input that is no real number of these types; in `out` what is no array of the
    results' type.

    Source: derivation continuous-white-acceleration
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
    t3 = 1.9721522630525295e-31 / tracking_index
    t5 = tracking_index * 4.108650548026103e-33
    t8 = form.sqrt(t3 + t5) / form.sqrt(tracking_index)
    t11 = form.sqrt(t8 + 7.401486830834377e-17)
    t13 = t11 * 1.4901161193847656e-08
    t17 = tracking_index * 0.25
    t25 = tracking_index * 0.5
    t26 = (2.449489742783178 - t25) + (
        -8.914125970704845e-08 if form.single else 2.168616518103246e-16
    )
    t29 = tracking_index * (t8 + 1.1102230246251565e-16)
    t34 = tracking_index * (t8 + (t13 + 1.1102230246251565e-16))
    t36 = 4.440892098500626e-16 / t34
    t38 = (t26 / t29) * ((2.449489742783178 + t25) * t36)
    t39 = t38 * 7.401486830834377e-17
    t42 = (form.sqrt(abs(3.0 - t17)) / t13) * (form.sqrt(3.0 + t17) * t36)
    t43 = t42 * 7.401486830834377e-17
    t45 = abs(t39) + t43
    t50 = t39 if tracking_index < 12.0 else -t45
    t52 = t39 if tracking_index < 12.0 else -((t36 / t45) * t36)
    t53 = t43 if tracking_index < 12.0 else form.of(0.0)
    t55 = -t43 if tracking_index < 12.0 else form.of(0.0)
    return (t50, t53, t52, t55)


def _closed_loop_poles_block(
    given: Arrays,
    out: Arrays,
    work: Arrays,
    single: bool,
    n0: float = 1.9721522630525295e-31,
    n1: float = 4.108650548026103e-33,
    n2: float = 7.401486830834377e-17,
    n3: float = 1.4901161193847656e-08,
    n4: float = 0.25,
    n5: float = 3.0,
    n6: float = 0.5,
    n7: float = 2.449489742783178,
    n8: float = -8.914125970704845e-08,
    n9: float = 2.168616518103246e-16,
    n10: float = 1.1102230246251565e-16,
    n11: float = 4.440892098500626e-16,
    n12: float = 12.0,
    n13: float = 0.0,
) -> None:
    (tracking_index,) = given
    first_real, first_imaginary, second_real, second_imaginary = out
    w0, w1, w2 = work
    p = sqrt(tracking_index, first_real)
    t3 = divide(n0, tracking_index, second_real)
    t5 = multiply(tracking_index, n1, w0)
    t6 = add(t3, t5, second_real)
    h_scaled = sqrt(t6, first_imaginary)
    kappa = divide(h_scaled, p, second_imaginary)
    t10 = add(kappa, n2, w0)
    rho_scaled = sqrt(t10, w0)
    rho = multiply(rho_scaled, n3, w0)
    t17 = multiply(tracking_index, n4, first_real)
    t18 = subtract(n5, t17, first_imaginary)
    distance = absolute(t18, first_imaginary)
    below = sqrt(distance, first_imaginary)
    t21 = add(n5, t17, first_real)
    above = sqrt(t21, first_real)
    t25 = multiply(tracking_index, n6, second_real)
    rest = n8 if single else n9
    subtract(n7, t25, w1)
    t26 = add(w1, rest, w1)
    t28 = add(kappa, n10, w2)
    t29 = multiply(tracking_index, t28, w2)
    t30 = divide(t26, t29, w1)
    t31 = add(n7, t25, second_real)
    t32 = add(rho, n10, w2)
    t33 = add(kappa, t32, second_imaginary)
    t34 = multiply(tracking_index, t33, second_imaginary)
    t36 = divide(n11, t34, second_imaginary)
    t37 = multiply(t31, t36, second_real)
    t38 = multiply(t30, t37, w1)
    t39 = multiply(t38, n2, w1)
    t40 = divide(below, rho, first_imaginary)
    t41 = multiply(above, t36, first_real)
    t42 = multiply(t40, t41, first_imaginary)
    t43 = multiply(t42, n2, first_imaginary)
    middle_size = absolute(t39, w0)
    t45 = add(middle_size, t43, w0)
    t46 = divide(t36, t45, w2)
    t47 = multiply(t46, t36, w2)
    t49 = negative(t45, w0)
    t51 = negative(t47, w2)
    t54 = negative(t43, second_imaginary)
    mask = mask_of(less(tracking_index, n12), single)
    choose(mask, t39, t49, out=first_real)
    choose(mask, t39, t51, out=second_real)
    choose(mask, t43, n13, out=first_imaginary)
    choose(mask, t54, n13, out=second_imaginary)


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

        6*alpha**2 + 6*alpha*beta + beta**2 - 12*beta = 0, Lambda^2 = beta^2/(1 - alpha)

    alpha: position gain; a number above 0 and below 1.

    tracking_index: tracking index Lambda. Relative error at most 3.51 * 2^-52 (float64), 3.51 *
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

    Source: derivation continuous-white-acceleration
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
    t5 = alpha * alpha
    t14 = (2.0 - alpha) + form.sqrt((t2 * 4.0) + (t5 / 3.0))
    t16 = ((t5 * 2.0) / t14) / form.sqrt(t2)
    return (t16,)


def _index_from_alpha_block(
    given: Arrays,
    out: Arrays,
    work: Arrays,
    _single: bool,
    n0: float = 1.0,
    n1: float = 4.0,
    n2: float = 3.0,
    n3: float = 2.0,
) -> None:
    (alpha,) = given
    (tracking_index,) = out
    w0, w1, w2 = work
    t2 = subtract(n0, alpha, w0)
    t4 = multiply(t2, n1, w1)
    t5 = square(alpha, w2)
    t7 = divide(t5, n2, tracking_index)
    t8 = add(t4, t7, w1)
    alpha_radical = sqrt(t8, w1)
    root_of_rest = sqrt(t2, w0)
    t12 = multiply(t5, n3, w2)
    t13 = subtract(n3, alpha, tracking_index)
    t14 = add(t13, alpha_radical, tracking_index)
    t15 = divide(t12, t14, w2)
    divide(t15, root_of_rest, tracking_index)


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

        6*alpha**2 + 6*alpha*beta + beta**2 - 12*beta = 0, Lambda^2 = beta^2/(1 - alpha)

    alpha: position gain; a number above 0 and below 1.

    beta: velocity gain times the sampling interval. Relative error at most 2.26 * 2^-52 (float64),
        2.26 * 2^-23 (float32), proved for 2.1095373229726e-154 <= alpha <= 0.9999999999999999
        (float64) and 1.5332935e-19 <= alpha <= 0.99999994 (float32).

    Outside an output's range, a few numbers next to its ends apart, its true value is no normal
    number: it comes as 0, a subnormal number or infinity, never as NaN. Numbers and arrays are
    taken, arrays of any shape; inputs are broadcast. float64 and float32 stay what they are,
    integers become float64. `out`: a tuple of arrays to fill. `workers`: threads that share the
    work on long arrays.

    ValueError: an input outside its domain, with its place; `out` or `workers` that does not fit.
    TypeError: an input that is no real number of these types; in `out` what is no array of the
    results' type.

    Source: derivation continuous-white-acceleration
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
    t5 = alpha * alpha
    t9 = form.sqrt(((1.0 - alpha) * 4.0) + (t5 / 3.0))
    t14 = (t5 * 2.0) / ((2.0 - alpha) + t9)
    return (t14,)


def _beta_from_alpha_block(
    given: Arrays,
    out: Arrays,
    work: Arrays,
    _single: bool,
    n0: float = 1.0,
    n1: float = 4.0,
    n2: float = 3.0,
    n3: float = 2.0,
) -> None:
    (alpha,) = given
    (beta,) = out
    w0, w1 = work
    t2 = subtract(n0, alpha, w0)
    t4 = multiply(t2, n1, w0)
    t5 = square(alpha, w1)
    t7 = divide(t5, n2, beta)
    t8 = add(t4, t7, w0)
    alpha_radical = sqrt(t8, w0)
    t11 = multiply(t5, n3, w1)
    t12 = subtract(n3, alpha, beta)
    t13 = add(t12, alpha_radical, beta)
    divide(t11, t13, beta)


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

        6*alpha**2 + 6*alpha*beta + beta**2 - 12*beta = 0, Lambda^2 = beta^2/(1 - alpha)

    beta: velocity gain times the sampling interval; a number above 0 and below 1.2679491924311228.

    tracking_index: tracking index Lambda. Relative error at most 3.51 * 2^-52 (float64), 3.51 *
        2^-23 (float32), proved for 2.2250738585072014e-308 <= beta <= 1.2679491924311226 (float64)
        and 1.1754944e-38 <= beta <= 1.2679491 (float32).

    Outside an output's range, a few numbers next to its ends apart, its true value is no normal
    number: it comes as 0, a subnormal number or infinity, never as NaN. Numbers and arrays are
    taken, arrays of any shape; inputs are broadcast. float64 and float32 stay what they are,
    integers become float64. `out`: a tuple of arrays to fill. `workers`: threads that share the
    work on long arrays.

    ValueError: an input outside its domain, with its place; `out` or `workers` that does not fit.
    TypeError: an input that is no real number of these types; in `out` what is no array of the
    results' type.

    Source: derivation continuous-white-acceleration
    """
    if (
        type(beta) is float
        and 5e-324 <= beta <= 1.2679491924311226
        and out is None
        and workers is ONE
    ):
        try:
            return named(IndexFromBeta, _index_from_beta_of_numbers(beta))
        except (ArithmeticError, ValueError):
            pass  # arrays say what is wrong
    return IndexFromBeta(*evaluate(_INDEX_FROM_BETA, (beta,), out, workers))


def _index_from_beta_of_numbers(beta: float, form: Form = Double) -> tuple[float, ...]:
    t6 = form.sqrt(beta * (8.0 + (beta / 3.0)))
    t10 = (1.2679491924311228 - beta) + (
        -3.1087250107475484e-08 if form.single else -1.0035084221806903e-16
    )
    t12 = (4.732050807568878 - beta) + (
        -8.812204299601945e-08 if form.single else -3.437383676319936e-16
    )
    t18 = ((t10 * t12) * 0.6666666666666666) / (((2.0 + beta) + t6) * 2.0)
    t20 = beta / form.sqrt(t18)
    return (t20,)


def _index_from_beta_block(
    given: Arrays,
    out: Arrays,
    work: Arrays,
    single: bool,
    n0: float = 3.0,
    n1: float = 8.0,
    n2: float = 1.2679491924311228,
    n3: float = -3.1087250107475484e-08,
    n4: float = -1.0035084221806903e-16,
    n5: float = 4.732050807568878,
    n6: float = -8.812204299601945e-08,
    n7: float = -3.437383676319936e-16,
    n8: float = 0.6666666666666666,
    n9: float = 2.0,
) -> None:
    (beta,) = given
    (tracking_index,) = out
    w0, w1 = work
    t2 = divide(beta, n0, tracking_index)
    t4 = add(n1, t2, tracking_index)
    t5 = multiply(beta, t4, tracking_index)
    beta_radical = sqrt(t5, tracking_index)
    rest = n3 if single else n4
    subtract(n2, beta, w0)
    t10 = add(w0, rest, w0)
    rest_ = n6 if single else n7
    subtract(n5, beta, w1)
    t12 = add(w1, rest_, w1)
    t13 = multiply(t10, t12, w0)
    t14 = multiply(t13, n8, w0)
    t15 = add(n9, beta, w1)
    t16 = add(t15, beta_radical, w1)
    t17 = multiply(t16, n9, w1)
    t18 = divide(t14, t17, w0)
    root_of_rest = sqrt(t18, w0)
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

        6*alpha**2 + 6*alpha*beta + beta**2 - 12*beta = 0, Lambda^2 = beta^2/(1 - alpha)

    beta: velocity gain times the sampling interval; a number above 0 and below 1.2679491924311228.

    alpha: position gain. Relative error at most 3.76 * 2^-52 (float64), 3.76 * 2^-23 (float32),
        proved for 5e-324 <= beta <= 1.2679491924311226 (float64) and 1e-45 <= beta <= 1.2679491
        (float32).

    Outside an output's range, a few numbers next to its ends apart, its true value is no normal
    number: it comes as 0, a subnormal number or infinity, never as NaN. Numbers and arrays are
    taken, arrays of any shape; inputs are broadcast. float64 and float32 stay what they are,
    integers become float64. `out`: a tuple of arrays to fill. `workers`: threads that share the
    work on long arrays.

    ValueError: an input outside its domain, with its place; `out` or `workers` that does not fit.
    TypeError: an input that is no real number of these types; in `out` what is no array of the
    results' type.

    Source: derivation continuous-white-acceleration
    """
    if (
        type(beta) is float
        and 5e-324 <= beta <= 1.2679491924311226
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
    t13 = t2 * ((12.0 - beta) * 0.6666666666666666)
    t16 = form.sqrt(t2 * (8.0 + (beta / 3.0))) + (beta * 1073741824.0)
    t19 = t13 / (t16 * 2147483648.0)
    return (t19,)


def _alpha_from_beta_block(
    given: Arrays,
    out: Arrays,
    work: Arrays,
    _single: bool,
    n0: float = 1.152921504606847e18,
    n1: float = 3.0,
    n2: float = 8.0,
    n3: float = 12.0,
    n4: float = 0.6666666666666666,
    n5: float = 1073741824.0,
    n6: float = 2147483648.0,
) -> None:
    (beta,) = given
    (alpha,) = out
    w0, w1 = work
    t2 = multiply(beta, n0, w0)
    t4 = divide(beta, n1, alpha)
    t6 = add(n2, t4, alpha)
    t7 = multiply(t2, t6, alpha)
    scaled_beta_radical = sqrt(t7, alpha)
    t10 = subtract(n3, beta, w1)
    t12 = multiply(t10, n4, w1)
    t13 = multiply(t2, t12, w0)
    t15 = multiply(beta, n5, w1)
    t16 = add(scaled_beta_radical, t15, alpha)
    t18 = multiply(t16, n6, alpha)
    divide(t13, t18, alpha)


_ALPHA_FROM_BETA = Signature(
    "alpha_from_beta",
    (_BETA_DOMAIN,),
    ("alpha",),
    2,
    _alpha_from_beta_block,
    numbers=_alpha_from_beta_of_numbers,
)
