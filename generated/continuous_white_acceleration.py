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
    t27 = (t5 / 6.0) / t22
    t34 = (t5 * 6.666666666666667) + ((t5 * 16.0) * (t27 * (t27 + 1.0)))
    t41 = (t5 * 1.152921504606847e18) / (t17 + ((t22 * 4.0) + t34))
    t44 = form.sqrt(t41) * 3.725290298461914e-09
    t48 = (t5 * 4.0) / (t15 + (t5 + t22))
    return (t44, t48)


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
    n7: float = 6.666666666666667,
    n8: float = 6.0,
    n9: float = 16.0,
    n10: float = 1.0,
    n11: float = 1.152921504606847e18,
    n12: float = 4.0,
    n13: float = 3.725290298461914e-09,
) -> None:
    (tracking_index,) = given
    alpha, beta = out
    w0, w1, w2, w3, w4, w5 = work
    t2 = multiply(tracking_index, n0, w0)
    index_or_switch = minimum(t2, n1, out=w0)
    t7 = divide(n2, tracking_index, alpha)
    four_or_less = minimum(n3, t7, out=alpha)
    t10 = square(four_or_less, alpha)
    t11 = square(index_or_switch, w1)
    t13 = divide(t11, n4, beta)
    t14 = add(t10, t13, alpha)
    eta_scaled = sqrt(t14, alpha)
    t17 = multiply(eta_scaled, n5, w1)
    t19 = multiply(index_or_switch, n6, beta)
    t20 = add(t17, t19, beta)
    t21 = multiply(index_or_switch, t20, beta)
    ratio_scaled = sqrt(t21, beta)
    t24 = multiply(index_or_switch, n7, w2)
    t26 = divide(index_or_switch, n8, w3)
    t27 = divide(t26, ratio_scaled, w3)
    t29 = multiply(index_or_switch, n9, w4)
    t31 = add(t27, n10, w5)
    t32 = multiply(t27, t31, w3)
    t33 = multiply(t29, t32, w4)
    t34 = add(t24, t33, w2)
    t36 = multiply(index_or_switch, n11, w3)
    t38 = multiply(ratio_scaled, n12, w4)
    t39 = add(t38, t34, w4)
    t40 = add(t17, t39, w1)
    t41 = divide(t36, t40, w3)
    alpha_raised = sqrt(t41, w3)
    t45 = multiply(index_or_switch, n12, w1)
    t46 = add(index_or_switch, ratio_scaled, w0)
    t47 = add(eta_scaled, t46, w0)
    multiply(alpha_raised, n13, alpha)
    divide(t45, t47, beta)


_GAINS = Signature(
    "gains",
    (_TRACKING_INDEX_DOMAIN,),
    ("alpha", "beta"),
    6,
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

    alpha: derivative of the position gain. Relative error at most 9.92 * 2^-52 (float64), 9.92 *
        2^-23 (float32), proved for 5e-324 <= tracking_index <= 5.247628584236248e102 (float64) and
        1e-45 <= tracking_index <= 6.49139e12 (float32).
    beta: derivative of the velocity gain times the sampling interval. Relative error at most 10.01
        * 2^-52 (float64), 10.01 * 2^-23 (float32), proved for 5e-324 <= tracking_index <=
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
    t20 = (tracking_index * (t8 + t16)) * 2251799813685248.0
    t25 = 2.220446049250313e-16 / ((t20 * t20) * ((t1 * t7) * t14))
    t28 = t25 * (t8 + 3.700743415417188e-17)
    t31 = (t25 * 2.0) * t16
    return (t28, t31)


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
    n5: float = 2251799813685248.0,
    n6: float = 2.220446049250313e-16,
    n7: float = 3.700743415417188e-17,
    n8: float = 2.0,
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
    t20 = multiply(t18, n5, w2)
    t21 = square(t20, w2)
    t22 = multiply(half_eta, rho, alpha)
    t23 = multiply(t21, t22, w2)
    t25 = divide(n6, t23, w2)
    t27 = add(kappa, n7, w0)
    t30 = multiply(t25, n8, beta)
    multiply(t25, t27, alpha)
    multiply(t30, t16, beta)


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
    d_alpha: derivative of the position gain. Relative error at most 10.52 * 2^-52 (float64), 10.52
        * 2^-23 (float32), proved for 5e-324 <= tracking_index <= 5.247628584236248e102 (float64)
        and 1e-45 <= tracking_index <= 6.49139e12 (float32).
    d_beta: derivative of the velocity gain times the sampling interval. Relative error at most
        11.67 * 2^-52 (float64), 11.67 * 2^-23 (float32), proved for 5e-324 <= tracking_index <=
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
    t6 = t1 * 1.8189894035458565e-12
    t8 = 1.3234889800848443e-23 / tracking_index
    t10 = tracking_index * 2.757268708510092e-25
    t12 = form.sqrt(t8 + t10)
    t14 = (t4 / 3.0) + t12
    t15 = t4 + t12
    t18 = form.sqrt(t4 * (t15 + t14))
    t21 = (t15 + t18) * 0.5
    t27 = ((tracking_index * t21) * t21) * (t1 * t12)
    t29 = 6.018531076210112e-36 / t27
    t22 = t18 / t21
    t23 = t6 / t21
    t31 = t29 * (t14 / t18)
    t34 = t29 * ((t6 / t18) + 2.0)
    return (t22, t23, t31, t34)


def _gains_with_derivatives_block(
    given: Arrays,
    out: Arrays,
    work: Arrays,
    _single: bool,
    n0: float = 9.094947017729282e-13,
    n1: float = 1.8189894035458565e-12,
    n2: float = 1.3234889800848443e-23,
    n3: float = 2.757268708510092e-25,
    n4: float = 3.0,
    n5: float = 0.5,
    n6: float = 6.018531076210112e-36,
    n7: float = 2.0,
) -> None:
    (tracking_index,) = given
    alpha, beta, d_alpha, d_beta = out
    w0, w1, w2, w3, w4 = work
    p = sqrt(tracking_index, alpha)
    t4 = multiply(p, n0, w0)
    t6 = multiply(p, n1, w1)
    t8 = divide(n2, tracking_index, w2)
    t10 = multiply(tracking_index, n3, w3)
    t11 = add(t8, t10, w2)
    h_at_once = sqrt(t11, beta)
    t13 = divide(t4, n4, w2)
    t14 = add(t13, h_at_once, w2)
    t15 = add(t4, h_at_once, w3)
    t16 = add(t15, t14, w4)
    t17 = multiply(t4, t16, w0)
    twice_ratio = sqrt(t17, d_beta)
    t19 = add(t15, twice_ratio, w3)
    t21 = multiply(t19, n5, w3)
    t24 = multiply(tracking_index, t21, w0)
    t25 = multiply(t24, t21, w0)
    t26 = multiply(p, h_at_once, alpha)
    t27 = multiply(t25, t26, w0)
    t29 = divide(n6, t27, w0)
    divide(twice_ratio, t21, alpha)
    divide(t6, t21, beta)
    t30 = divide(t14, twice_ratio, d_alpha)
    multiply(t29, t30, d_alpha)
    t32 = divide(t6, twice_ratio, d_beta)
    t33 = add(t32, n7, d_beta)
    multiply(t29, t33, d_beta)


_GAINS_WITH_DERIVATIVES = Signature(
    "gains_with_derivatives",
    (_TRACKING_INDEX_DOMAIN,),
    ("alpha", "beta", "d_alpha", "d_beta"),
    5,
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
    t27 = (t5 / 6.0) / t22
    t34 = (t5 * 6.666666666666667) + ((t5 * 16.0) * (t27 * (t27 + 1.0)))
    t41 = (t5 * 1.152921504606847e18) / (t17 + ((t22 * 4.0) + t34))
    t44 = form.sqrt(t41) * 3.725290298461914e-09
    t48 = (t5 * 4.0) / (t15 + (t5 + t22))
    t49 = t44 + t48
    return (t49, t48)


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
    n7: float = 6.666666666666667,
    n8: float = 6.0,
    n9: float = 16.0,
    n10: float = 1.0,
    n11: float = 1.152921504606847e18,
    n12: float = 4.0,
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
    t26 = divide(index_or_switch, n8, w3)
    t27 = divide(t26, ratio_scaled, w3)
    t29 = multiply(index_or_switch, n9, w4)
    t31 = add(t27, n10, w5)
    t32 = multiply(t27, t31, w3)
    t33 = multiply(t29, t32, w4)
    t34 = add(t24, t33, w2)
    t36 = multiply(index_or_switch, n11, w3)
    t38 = multiply(ratio_scaled, n12, w4)
    t39 = add(t38, t34, w4)
    t40 = add(t17, t39, w1)
    t41 = divide(t36, t40, w3)
    alpha_raised = sqrt(t41, w3)
    t44 = multiply(alpha_raised, n13, w3)
    t45 = multiply(index_or_switch, n12, w1)
    t46 = add(index_or_switch, ratio_scaled, w0)
    t47 = add(eta_scaled, t46, velocity)
    divide(t45, t47, velocity)
    add(t44, velocity, position)


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

    position: derivative of the position entry of F K, alpha + beta. Relative error at most 10.51 *
        2^-52 (float64), 10.51 * 2^-23 (float32), proved for 5e-324 <= tracking_index <=
        9.873247422805948e102 (float64) and 1e-45 <= tracking_index <= 1.2213346e13 (float32).
    velocity: derivative of the velocity entry of F K times the sampling interval, beta. Relative
        error at most 10.01 * 2^-52 (float64), 10.01 * 2^-23 (float32), proved for 5e-324 <=
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
    t20 = (tracking_index * (t8 + t16)) * 2251799813685248.0
    t25 = 2.220446049250313e-16 / ((t20 * t20) * ((t1 * t7) * t14))
    t31 = (t25 * 2.0) * t16
    t32 = (t25 * (t8 + 3.700743415417188e-17)) + t31
    return (t32, t31)


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
    n5: float = 2251799813685248.0,
    n6: float = 2.220446049250313e-16,
    n7: float = 3.700743415417188e-17,
    n8: float = 2.0,
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
    t20 = multiply(t18, n5, w2)
    t21 = square(t20, w2)
    t22 = multiply(half_eta, rho, velocity)
    t23 = multiply(t21, t22, w2)
    t25 = divide(n6, t23, w2)
    t27 = add(kappa, n7, w0)
    t28 = multiply(t25, t27, w0)
    t30 = multiply(t25, n8, w2)
    multiply(t30, t16, velocity)
    add(t28, velocity, position)


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
        most 9.92 * 2^-52 (float64), 9.92 * 2^-23 (float32), proved for 5e-324 <= tracking_index <=
        5.247628584236248e102 (float64) and 1e-45 <= tracking_index <= 6.49139e12 (float32).
    updated_12: derivative of the covariance of updated position and velocity times T/sigma_v^2.
        Relative error at most 10.01 * 2^-52 (float64), 10.01 * 2^-23 (float32), proved for 5e-324
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
    t20 = (tracking_index * (t8 + t16)) * 2251799813685248.0
    t25 = 2.220446049250313e-16 / ((t20 * t20) * ((t1 * t7) * t14))
    t34 = (t8 + 1.850371707708594e-17) / t16
    t38 = 1.0 + ((t34 * 1.1102230246251565e-16) / t14)
    t44 = ((t8 + 2.220446049250313e-16) / t8) * (9.25185853854297e-18 / t14)
    t28 = t25 * (t8 + 3.700743415417188e-17)
    t31 = (t25 * 2.0) * t16
    t46 = tracking_index * ((t34 * t38) + t44)
    return (t28, t31, t46)


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
    n5: float = 2251799813685248.0,
    n6: float = 2.220446049250313e-16,
    n7: float = 3.700743415417188e-17,
    n8: float = 2.0,
    n9: float = 1.850371707708594e-17,
    n10: float = 1.0,
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
    t20 = multiply(t18, n5, w1)
    t21 = square(t20, w1)
    t22 = multiply(half_eta, rho, updated_11)
    t23 = multiply(t21, t22, w1)
    t25 = divide(n6, t23, w1)
    t27 = add(kappa, n7, updated_11)
    t30 = multiply(t25, n8, w2)
    t33 = add(kappa, n9, w3)
    t34 = divide(t33, t16, w3)
    t35 = multiply(t34, n4, w4)
    t36 = divide(t35, rho, w4)
    t38 = add(n10, t36, w4)
    t39 = multiply(t34, t38, w3)
    t40 = add(kappa, n6, w4)
    t41 = divide(t40, kappa, w4)
    t43 = divide(n11, rho, updated_12)
    t44 = multiply(t41, t43, w4)
    t45 = add(t39, t44, w3)
    multiply(t25, t27, updated_11)
    multiply(t30, t16, updated_12)
    multiply(tracking_index, t45, updated_22)


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

    alpha: second derivative by Lambda of the position gain. Relative error at most 15.70 * 2^-52
        (float64), 15.69 * 2^-23 (float32), proved for 1.5697348409117324e-206 <= tracking_index <=
        1.442954478563842e77 (float64) and 1.0258398e-26 <= tracking_index <= 5.3522156e09
        (float32).
    beta: second derivative by Lambda of the velocity gain times the sampling interval. Relative
        error at most 15.42 * 2^-52 (float64), 15.41 * 2^-23 (float32), proved for 5e-324 <=
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
    t11 = t8 + 7.401486830834377e-17
    t14 = form.sqrt(t11) * 1.4901161193847656e-08
    t18 = tracking_index * (t8 + (t14 + 1.1102230246251565e-16))
    t21 = (4.440892098500626e-16 / t18) / tracking_index
    t23 = 2.220446049250313e-16 / t8
    t27 = 1.0 + (t23 * 0.16666666666666666)
    t29 = 2.220446049250313e-16 / t14
    t33 = (t23 * 0.009259259259259259) + 0.041666666666666664
    t37 = t23 * ((t23 * t33) + 0.08333333333333333)
    t41 = t8 + ((t37 + 0.5) * 2.220446049250313e-16)
    t45 = (t27 * t27) + (t29 * (t41 * 2251799813685248.0))
    t48 = t21 * ((t45 * 2.220446049250313e-16) / t11)
    t56 = (t23 * 0.10185185185185185) + 0.6666666666666666
    t59 = (t8 + (t56 * 2.220446049250313e-16)) / t14
    t66 = ((t59 * 1.5) + t27) / (1.0 + (t23 * 0.3333333333333333))
    t70 = (2.0 + t29) * (t23 * 0.08333333333333333)
    t72 = (1.9721522630525295e-31 / (t18 * t18)) * (t66 + t70)
    t74 = (t1 * t7) * 4503599627370496.0
    t50 = -(t21 * t48)
    t77 = -((t72 / t74) / t74)
    return (t50, t77)


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
    n19: float = 4503599627370496.0,
) -> None:
    (tracking_index,) = given
    alpha, beta = out
    w0, w1, w2, w3, w4, w5, w6, w7, w8 = work
    p = sqrt(tracking_index, alpha)
    t3 = divide(n0, tracking_index, beta)
    t5 = multiply(tracking_index, n1, w0)
    t6 = add(t3, t5, beta)
    h_scaled = sqrt(t6, beta)
    kappa = divide(h_scaled, p, w0)
    half_eta = multiply(p, h_scaled, alpha)
    t11 = add(kappa, n2, beta)
    rho_scaled = sqrt(t11, w1)
    rho = multiply(rho_scaled, n3, w1)
    t16 = add(rho, n4, w2)
    t17 = add(kappa, t16, w2)
    t18 = multiply(tracking_index, t17, w2)
    t20 = divide(n5, t18, w3)
    t21 = divide(t20, tracking_index, w3)
    t23 = divide(n6, kappa, w4)
    t25 = multiply(t23, n7, w5)
    t27 = add(n8, t25, w5)
    t28 = square(t27, w6)
    t29 = divide(n6, rho, w7)
    t31 = multiply(t23, n9, w8)
    t33 = add(t31, n10, w8)
    t34 = multiply(t23, t33, w8)
    t36 = add(t34, n11, w8)
    t37 = multiply(t23, t36, w8)
    t39 = add(t37, n12, w8)
    t40 = multiply(t39, n6, w8)
    t41 = add(kappa, t40, w8)
    t43 = multiply(t41, n13, w8)
    t44 = multiply(t29, t43, w8)
    t45 = add(t28, t44, w6)
    t46 = multiply(t45, n6, w6)
    t47 = divide(t46, t11, w6)
    t48 = multiply(t21, t47, w6)
    t49 = multiply(t21, t48, w3)
    t51 = square(t18, w2)
    t52 = divide(n0, t51, w2)
    t54 = multiply(t23, n14, w6)
    t56 = add(t54, n15, w6)
    t57 = multiply(t56, n6, w6)
    t58 = add(kappa, t57, w0)
    t59 = divide(t58, rho, w0)
    t61 = multiply(t59, n16, w0)
    t62 = add(t61, t27, w0)
    t64 = multiply(t23, n17, w1)
    t65 = add(n8, t64, w1)
    t66 = divide(t62, t65, w0)
    t68 = add(n18, t29, w7)
    t69 = multiply(t23, n11, w4)
    t70 = multiply(t68, t69, w7)
    t71 = add(t66, t70, w0)
    t72 = multiply(t52, t71, w2)
    t74 = multiply(half_eta, n19, alpha)
    t75 = divide(t72, t74, w2)
    t76 = divide(t75, t74, w2)
    negative(t49, alpha)
    negative(t76, beta)


_GAIN_SECOND_DERIVATIVES = Signature(
    "gain_second_derivatives",
    (_TRACKING_INDEX_DOMAIN,),
    ("alpha", "beta"),
    9,
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
        at most 18.82 * 2^-52 (float64), 18.80 * 2^-23 (float32), proved for 1.5697348409117332e-206
        <= tracking_index <= 2.318063502250569e77 (float64) and 1.02584e-26 <= tracking_index <=
        8.598175e09 (float32).
    velocity: second derivative by Lambda of the velocity entry of F K times the sampling interval,
        beta. Relative error at most 15.42 * 2^-52 (float64), 15.41 * 2^-23 (float32), proved for
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
    t11 = t8 + 7.401486830834377e-17
    t14 = form.sqrt(t11) * 1.4901161193847656e-08
    t18 = tracking_index * (t8 + (t14 + 1.1102230246251565e-16))
    t21 = (4.440892098500626e-16 / t18) / tracking_index
    t23 = 2.220446049250313e-16 / t8
    t27 = 1.0 + (t23 * 0.16666666666666666)
    t29 = 2.220446049250313e-16 / t14
    t33 = (t23 * 0.009259259259259259) + 0.041666666666666664
    t37 = t23 * ((t23 * t33) + 0.08333333333333333)
    t41 = t8 + ((t37 + 0.5) * 2.220446049250313e-16)
    t45 = (t27 * t27) + (t29 * (t41 * 2251799813685248.0))
    t51 = (t23 * 0.10185185185185185) + 0.6666666666666666
    t54 = (t8 + (t51 * 2.220446049250313e-16)) / t14
    t61 = ((t54 * 1.5) + t27) / (1.0 + (t23 * 0.3333333333333333))
    t65 = (2.0 + t29) * (t23 * 0.08333333333333333)
    t66 = t61 + t65
    t69 = ((t45 * 2.220446049250313e-16) / t11) + (t23 * (t23 * t66))
    t75 = (1.9721522630525295e-31 / (t18 * t18)) * t66
    t77 = (t1 * t7) * 4503599627370496.0
    t72 = -(t21 * (t21 * t69))
    t80 = -((t75 / t77) / t77)
    return (t72, t80)


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
    n19: float = 4503599627370496.0,
) -> None:
    (tracking_index,) = given
    position, velocity = out
    w0, w1, w2, w3, w4, w5, w6, w7, w8 = work
    p = sqrt(tracking_index, position)
    t3 = divide(n0, tracking_index, velocity)
    t5 = multiply(tracking_index, n1, w0)
    t6 = add(t3, t5, velocity)
    h_scaled = sqrt(t6, velocity)
    kappa = divide(h_scaled, p, w0)
    half_eta = multiply(p, h_scaled, position)
    t11 = add(kappa, n2, velocity)
    rho_scaled = sqrt(t11, w1)
    rho = multiply(rho_scaled, n3, w1)
    t16 = add(rho, n4, w2)
    t17 = add(kappa, t16, w2)
    t18 = multiply(tracking_index, t17, w2)
    t20 = divide(n5, t18, w3)
    t21 = divide(t20, tracking_index, w3)
    t23 = divide(n6, kappa, w4)
    t25 = multiply(t23, n7, w5)
    t27 = add(n8, t25, w5)
    t28 = square(t27, w6)
    t29 = divide(n6, rho, w7)
    t31 = multiply(t23, n9, w8)
    t33 = add(t31, n10, w8)
    t34 = multiply(t23, t33, w8)
    t36 = add(t34, n11, w8)
    t37 = multiply(t23, t36, w8)
    t39 = add(t37, n12, w8)
    t40 = multiply(t39, n6, w8)
    t41 = add(kappa, t40, w8)
    t43 = multiply(t41, n13, w8)
    t44 = multiply(t29, t43, w8)
    t45 = add(t28, t44, w6)
    t46 = multiply(t45, n6, w6)
    t47 = divide(t46, t11, w6)
    t49 = multiply(t23, n14, w8)
    t51 = add(t49, n15, w8)
    t52 = multiply(t51, n6, w8)
    t53 = add(kappa, t52, w0)
    t54 = divide(t53, rho, w0)
    t56 = multiply(t54, n16, w0)
    t57 = add(t56, t27, w0)
    t59 = multiply(t23, n17, w1)
    t60 = add(n8, t59, w1)
    t61 = divide(t57, t60, w0)
    t63 = add(n18, t29, w7)
    t64 = multiply(t23, n11, w1)
    t65 = multiply(t63, t64, w7)
    t66 = add(t61, t65, w0)
    t67 = multiply(t23, t66, w1)
    t68 = multiply(t23, t67, w4)
    t69 = add(t47, t68, w6)
    t70 = multiply(t21, t69, w6)
    t71 = multiply(t21, t70, w3)
    t73 = square(t18, w2)
    t74 = divide(n0, t73, w2)
    t75 = multiply(t74, t66, w2)
    t77 = multiply(half_eta, n19, position)
    t78 = divide(t75, t77, w2)
    t79 = divide(t78, t77, w2)
    negative(t71, position)
    negative(t79, velocity)


_PREDICTOR_GAIN_SECOND_DERIVATIVES = Signature(
    "predictor_gain_second_derivatives",
    (_TRACKING_INDEX_DOMAIN,),
    ("position", "velocity"),
    9,
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
        Relative error at most 15.70 * 2^-52 (float64), 15.69 * 2^-23 (float32), proved for
        1.5697348409117324e-206 <= tracking_index <= 1.442954478563842e77 (float64) and
        1.0258398e-26 <= tracking_index <= 5.3522156e09 (float32).
    updated_12: second derivative by Lambda of the covariance of updated position and velocity times
        T/sigma_v^2. Relative error at most 15.42 * 2^-52 (float64), 15.41 * 2^-23 (float32), proved
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
    t18 = tracking_index * (t8 + t16)
    t21 = (4.440892098500626e-16 / t18) / tracking_index
    t23 = 2.220446049250313e-16 / t8
    t27 = 1.0 + (t23 * 0.16666666666666666)
    t29 = 2.220446049250313e-16 / t14
    t33 = (t23 * 0.009259259259259259) + 0.041666666666666664
    t37 = t23 * ((t23 * t33) + 0.08333333333333333)
    t41 = t8 + ((t37 + 0.5) * 2.220446049250313e-16)
    t45 = (t27 * t27) + (t29 * (t41 * 2251799813685248.0))
    t48 = t21 * ((t45 * 2.220446049250313e-16) / t11)
    t56 = (t23 * 0.10185185185185185) + 0.6666666666666666
    t59 = (t8 + (t56 * 2.220446049250313e-16)) / t14
    t66 = ((t59 * 1.5) + t27) / (1.0 + (t23 * 0.3333333333333333))
    t70 = (2.0 + t29) * (t23 * 0.08333333333333333)
    t72 = (1.9721522630525295e-31 / (t18 * t18)) * (t66 + t70)
    t74 = t9 * 4503599627370496.0
    t79 = (1.9721522630525295e-31 / t9) / tracking_index
    t83 = (t8 + 1.850371707708594e-17) / t16
    t86 = 1.0 + t23
    t88 = ((t83 * 2.220446049250313e-16) * t83) + (t86 * 1.850371707708594e-17)
    t93 = (t88 / t11) * ((t79 + (t88 * 0.5)) / t14)
    t98 = (t86 + ((t79 / t8) * (t23 * 0.5))) * 0.08333333333333333
    t50 = -(t21 * t48)
    t77 = -((t72 / t74) / t74)
    t100 = (t93 * 0.5) + (t29 * t98)
    return (t50, t77, t100)


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
    n19: float = 4503599627370496.0,
    n20: float = 1.850371707708594e-17,
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
    t20 = divide(n5, t18, w3)
    t21 = divide(t20, tracking_index, w3)
    t23 = divide(n6, kappa, w4)
    t25 = multiply(t23, n7, w5)
    t27 = add(n8, t25, w5)
    t28 = square(t27, w6)
    t29 = divide(n6, rho, w7)
    t31 = multiply(t23, n9, w8)
    t33 = add(t31, n10, w8)
    t34 = multiply(t23, t33, w8)
    t36 = add(t34, n11, w8)
    t37 = multiply(t23, t36, w8)
    t39 = add(t37, n12, w8)
    t40 = multiply(t39, n6, w8)
    t41 = add(kappa, t40, w8)
    t43 = multiply(t41, n13, w8)
    t44 = multiply(t29, t43, w8)
    t45 = add(t28, t44, w6)
    t46 = multiply(t45, n6, w6)
    t47 = divide(t46, t11, w6)
    t48 = multiply(t21, t47, w6)
    t49 = multiply(t21, t48, w3)
    t51 = square(t18, w2)
    t52 = divide(n0, t51, w2)
    t54 = multiply(t23, n14, w6)
    t56 = add(t54, n15, w6)
    t57 = multiply(t56, n6, w6)
    t58 = add(kappa, t57, w6)
    t59 = divide(t58, rho, w6)
    t61 = multiply(t59, n16, w6)
    t62 = add(t61, t27, w6)
    t64 = multiply(t23, n17, w5)
    t65 = add(n8, t64, w5)
    t66 = divide(t62, t65, w6)
    t68 = add(n18, t29, w5)
    t69 = multiply(t23, n11, w8)
    t70 = multiply(t68, t69, w5)
    t71 = add(t66, t70, w6)
    t72 = multiply(t52, t71, w2)
    t74 = multiply(half_eta, n19, w5)
    t75 = divide(t72, t74, w2)
    t76 = divide(t75, t74, w2)
    t78 = divide(n0, half_eta, updated_11)
    t79 = divide(t78, tracking_index, updated_11)
    t80 = divide(t79, kappa, w5)
    t82 = add(kappa, n20, w0)
    t83 = divide(t82, t16, w0)
    t84 = multiply(t83, n6, w1)
    t85 = multiply(t84, t83, w1)
    t86 = add(n8, t23, w0)
    t87 = multiply(t86, n20, w6)
    t88 = add(t85, t87, w1)
    t89 = divide(t88, t11, updated_12)
    t90 = multiply(t88, n12, w1)
    t91 = add(t79, t90, updated_11)
    t92 = divide(t91, rho, updated_11)
    t93 = multiply(t89, t92, updated_12)
    t94 = multiply(t93, n12, w1)
    t95 = multiply(t23, n12, w4)
    t96 = multiply(t80, t95, w5)
    t97 = add(t86, t96, w0)
    t98 = multiply(t97, n11, w0)
    t99 = multiply(t29, t98, w7)
    negative(t49, updated_11)
    negative(t76, updated_12)
    add(t94, t99, updated_22)


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
