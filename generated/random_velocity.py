# Made by: gainproof generate random-velocity
# From: gainproof derive random-velocity, SymPy 1.14.0
"""Random velocity (velocity random walk): steady state with measured position."""

from __future__ import annotations

from typing import TYPE_CHECKING

from numpy import add, copyto, divide, minimum, multiply, negative, sqrt, square, subtract

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
    "a number above 0 and below 1",
    (5e-324, 0.9999999999999999),
    (1.401298464324817e-45, 0.9999999403953552),
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
        kappa = sqrt(4/Lambda^2 + 1/4), rho = sqrt(kappa + 1/2) = alpha/beta,
        sigma = Lambda/beta = Lambda (1/2 + kappa + rho)/2

    tracking_index: Lambda, with Lambda^2 =
        sampling_interval**2*velocity_deviation**2/measurement_deviation**2; a number above 0 and
        finite.

    alpha: position gain. Relative error at most 1.85 * 2^-52 (float64), 1.85 * 2^-23 (float32),
        proved for 5e-324 <= tracking_index <= 1.7976931348623157e308 (float64) and 1e-45 <=
        tracking_index <= 3.4028235e38 (float32).
    beta: velocity gain times the sampling interval. Relative error at most 2.63 * 2^-52 (float64),
        2.63 * 2^-23 (float32), proved for 2.2250738585072014e-308 <= tracking_index <=
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

    Source: derivation random-velocity
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
    t13 = form.sqrt((t9 * t9) + (t5 * t5))
    t15 = t13 * 2.0
    t19 = form.sqrt(t5 * (t15 + (t5 * 2.0)))
    t28 = (t5 * 1.152921504606847e18) / (t15 + ((t19 * 4.0) + (t5 * 6.0)))
    t31 = form.sqrt(t28) * 3.725290298461914e-09
    t35 = (t5 * 4.0) / (t13 + (t5 + t19))
    return (t31, t35)


def _gains_block(
    given: Arrays,
    out: Arrays,
    work: Arrays,
    _single: bool,
    n0: float = 1.8014398509481984e16,
    n1: float = 1.3510798882111488e16,
    n2: float = 5.404319552844595e16,
    n3: float = 7.205759403792794e16,
    n4: float = 2.0,
    n5: float = 6.0,
    n6: float = 1.152921504606847e18,
    n7: float = 4.0,
    n8: float = 3.725290298461914e-09,
) -> None:
    (tracking_index,) = given
    alpha, beta = out
    w0, w1, w2, w3, w4 = work
    t2 = multiply(tracking_index, n0, w0)
    index_or_switch = minimum(t2, n1, out=w0)
    t7 = divide(n2, tracking_index, alpha)
    four_or_less = minimum(n3, t7, out=alpha)
    t10 = square(four_or_less, alpha)
    t11 = square(index_or_switch, w1)
    t12 = add(t10, t11, alpha)
    eta_scaled = sqrt(t12, beta)
    t15 = multiply(eta_scaled, n4, w1)
    t16 = multiply(index_or_switch, n4, alpha)
    t17 = add(t15, t16, alpha)
    t18 = multiply(index_or_switch, t17, alpha)
    ratio_scaled = sqrt(t18, alpha)
    t21 = multiply(index_or_switch, n5, w2)
    t23 = multiply(index_or_switch, n6, w3)
    t25 = multiply(ratio_scaled, n7, w4)
    t26 = add(t25, t21, w4)
    t27 = add(t15, t26, w1)
    t28 = divide(t23, t27, w3)
    alpha_raised = sqrt(t28, w3)
    t32 = multiply(index_or_switch, n7, w1)
    t33 = add(index_or_switch, ratio_scaled, w0)
    t34 = add(eta_scaled, t33, beta)
    multiply(alpha_raised, n8, alpha)
    divide(t32, t34, beta)


_GAINS = Signature(
    "gains",
    (_TRACKING_INDEX_DOMAIN,),
    ("alpha", "beta"),
    5,
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
    t5 = scale(tracking_index, 1.232595164407831e-32)
    t6 = add(t3, t5)
    h_scaled = root(t6)
    kappa = divide(h_scaled, p)
    t10 = add(kappa, (1.1102230246251565e-16, 0.0))
    rho_scaled = root(t10)
    rho = scale(rho_scaled, 1.4901161193847656e-08)
    t14 = add(rho, (1.1102230246251565e-16, 0.0))
    t15 = add(kappa, t14)
    t17 = divide((2.0, 0.0), t15)
    t18 = multiply(t17, rho)
    t20 = scale(t17, 2.220446049250313e-16)
    return (t18[0], t20[0])


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

        d alpha = (1 + 1/2/kappa)/(rho sigma^2 Lambda),
        d beta = (2 + 1/rho)/(kappa sigma^2 Lambda)
        kappa = sqrt(4/Lambda^2 + 1/4), rho = sqrt(kappa + 1/2) = alpha/beta,
        sigma = Lambda/beta = Lambda (1/2 + kappa + rho)/2

    tracking_index: Lambda, with Lambda^2 =
        sampling_interval**2*velocity_deviation**2/measurement_deviation**2; a number above 0 and
        finite.

    alpha: derivative of the position gain. Relative error at most 8.76 * 2^-52 (float64), 8.76 *
        2^-23 (float32), proved for 5e-324 <= tracking_index <= 4.4794894843556084e102 (float64) and
        1e-45 <= tracking_index <= 5.541191e12 (float32).
    beta: derivative of the velocity gain times the sampling interval. Relative error at most 9.81 *
        2^-52 (float64), 9.81 * 2^-23 (float32), proved for 5e-324 <= tracking_index <=
        6.46054178400843e102 (float64) and 1e-45 <= tracking_index <= 7.9917807e12 (float32).

    Outside an output's range, a few numbers next to its ends apart, its true value is no normal
    number: it comes as 0, a subnormal number or infinity, never as NaN. Numbers and arrays are
    taken, arrays of any shape; inputs are broadcast. float64 and float32 stay what they are,
    integers become float64. `out`: a tuple of arrays to fill. `workers`: threads that share the
    work on long arrays.

    ValueError: an input outside its domain, with its place; `out` or `workers` that does not fit.
    TypeError: an input that is no real number of these types; in `out` what is no array of the
    results' type.

    Source: derivation random-velocity
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
    t5 = tracking_index * 1.232595164407831e-32
    t7 = form.sqrt(t3 + t5)
    t8 = t7 / t1
    t12 = form.sqrt(t8 + 1.1102230246251565e-16)
    t14 = t12 * 1.4901161193847656e-08
    t17 = tracking_index * (t8 + (t14 + 1.1102230246251565e-16))
    t20 = (1.9721522630525295e-31 / (t17 * t17)) / (t1 * t7)
    t25 = (4.930380657631324e-32 / t14) + 4.440892098500626e-16
    t21 = t20 * t14
    t26 = t20 * t25
    return (t21, t26)


def _gain_derivatives_block(
    given: Arrays,
    out: Arrays,
    work: Arrays,
    _single: bool,
    n0: float = 1.9721522630525295e-31,
    n1: float = 1.232595164407831e-32,
    n2: float = 1.1102230246251565e-16,
    n3: float = 1.4901161193847656e-08,
    n4: float = 4.930380657631324e-32,
    n5: float = 4.440892098500626e-16,
) -> None:
    (tracking_index,) = given
    alpha, beta = out
    w0, w1 = work
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
    t15 = add(rho, n2, w1)
    t16 = add(kappa, t15, w0)
    t17 = multiply(tracking_index, t16, w0)
    t18 = square(t17, w0)
    t19 = divide(n0, t18, w0)
    t20 = divide(t19, half_eta, w0)
    t23 = divide(n4, rho, w1)
    t25 = add(t23, n5, w1)
    multiply(t20, rho, alpha)
    multiply(t20, t25, beta)


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
        h = sqrt(16/Lambda + Lambda), r = 2 rho p,
        kappa = sqrt(4/Lambda^2 + 1/4), rho = sqrt(kappa + 1/2) = alpha/beta,
        sigma = Lambda/beta = Lambda (1/2 + kappa + rho)/2

    tracking_index: Lambda, with Lambda^2 =
        sampling_interval**2*velocity_deviation**2/measurement_deviation**2; a number above 0 and
        finite.

    alpha: position gain. Relative error at most 2.76 * 2^-52 (float64), 2.76 * 2^-23 (float32),
        proved for 5e-324 <= tracking_index <= 1.7976931348623157e308 (float64) and 1e-45 <=
        tracking_index <= 3.4028235e38 (float32).
    beta: velocity gain times the sampling interval. Relative error at most 3.01 * 2^-52 (float64),
        3.01 * 2^-23 (float32), proved for 2.2250738585072014e-308 <= tracking_index <=
        1.7976931348623157e308 (float64) and 1.1754944e-38 <= tracking_index <= 3.4028235e38
        (float32).
    d_alpha: derivative of the position gain. Relative error at most 10.76 * 2^-52 (float64), 10.76
        * 2^-23 (float32), proved for 5e-324 <= tracking_index <= 4.4794894843556084e102 (float64)
        and 1e-45 <= tracking_index <= 5.541191e12 (float32).
    d_beta: derivative of the velocity gain times the sampling interval. Relative error at most
        11.97 * 2^-52 (float64), 11.97 * 2^-23 (float32), proved for 5e-324 <= tracking_index <=
        6.46054178400843e102 (float64) and 1e-45 <= tracking_index <= 7.9917807e12 (float32).

    Outside an output's range, a few numbers next to its ends apart, its true value is no normal
    number: it comes as 0, a subnormal number or infinity, never as NaN. Numbers and arrays are
    taken, arrays of any shape; inputs are broadcast. float64 and float32 stay what they are,
    integers become float64. `out`: a tuple of arrays to fill. `workers`: threads that share the
    work on long arrays.

    ValueError: an input outside its domain, with its place; `out` or `workers` that does not fit.
    TypeError: an input that is no real number of these types; in `out` what is no array of the
    results' type.

    Source: derivation random-velocity
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
    t5 = t1 * 1.8189894035458565e-12
    t7 = 1.3234889800848443e-23 / tracking_index
    t9 = tracking_index * 8.271806125530277e-25
    t11 = form.sqrt(t7 + t9)
    t12 = (t1 * 9.094947017729282e-13) + t11
    t14 = form.sqrt(t5 * t12)
    t17 = (t12 + t14) * 0.5
    t20 = t1 * t17
    t25 = 6.018531076210112e-36 / ((t20 * t20) * (t1 * t11))
    t26 = t5 / t14
    t18 = t14 / t17
    t19 = t5 / t17
    t27 = t25 / t26
    t29 = t25 * (t26 + 2.0)
    return (t18, t19, t27, t29)


def _gains_with_derivatives_block(
    given: Arrays,
    out: Arrays,
    work: Arrays,
    _single: bool,
    n0: float = 9.094947017729282e-13,
    n1: float = 1.8189894035458565e-12,
    n2: float = 1.3234889800848443e-23,
    n3: float = 8.271806125530277e-25,
    n4: float = 0.5,
    n5: float = 6.018531076210112e-36,
    n6: float = 2.0,
) -> None:
    (tracking_index,) = given
    alpha, beta, d_alpha, d_beta = out
    w0, w1, w2, w3 = work
    p = sqrt(tracking_index, alpha)
    t3 = multiply(p, n0, w0)
    t5 = multiply(p, n1, w1)
    t7 = divide(n2, tracking_index, beta)
    t9 = multiply(tracking_index, n3, w2)
    t10 = add(t7, t9, beta)
    h_at_once = sqrt(t10, d_alpha)
    t12 = add(t3, h_at_once, w0)
    t13 = multiply(t5, t12, w2)
    twice_ratio = sqrt(t13, d_beta)
    t15 = add(t12, twice_ratio, w0)
    t17 = multiply(t15, n4, w0)
    t20 = multiply(p, t17, w2)
    t21 = square(t20, w2)
    t22 = multiply(p, h_at_once, alpha)
    t23 = multiply(t21, t22, w2)
    t25 = divide(n5, t23, w2)
    t26 = divide(t5, twice_ratio, d_alpha)
    t28 = add(t26, n6, w3)
    divide(twice_ratio, t17, alpha)
    divide(t5, t17, beta)
    divide(t25, t26, d_alpha)
    multiply(t25, t28, d_beta)


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

        kappa = sqrt(4/Lambda^2 + 1/4), rho = sqrt(kappa + 1/2) = alpha/beta,
        sigma = Lambda/beta = Lambda (1/2 + kappa + rho)/2

    tracking_index: Lambda, with Lambda^2 =
        sampling_interval**2*velocity_deviation**2/measurement_deviation**2; a number above 0 and
        finite.

    position: position entry of F K, alpha + beta. Relative error at most 1.63 * 2^-52 (float64),
        1.63 * 2^-23 (float32), proved for 5e-324 <= tracking_index <= 1.7976931348623157e308
        (float64) and 1e-45 <= tracking_index <= 3.4028235e38 (float32).
    velocity: velocity entry of F K times the sampling interval, beta. Relative error at most 2.63 *
        2^-52 (float64), 2.63 * 2^-23 (float32), proved for 2.2250738585072014e-308 <=
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

    Source: derivation random-velocity
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
    t13 = form.sqrt((t9 * t9) + (t5 * t5))
    t17 = (t13 * 2.0) + (t5 * 2.0)
    t23 = form.sqrt((t5 * 1.152921504606847e18) / t17)
    t25 = t23 * 3.725290298461914e-09
    t30 = (t5 * 4.0) / (t13 + (t5 + form.sqrt(t5 * t17)))
    return (t25, t30)


def _predictor_gains_block(
    given: Arrays,
    out: Arrays,
    work: Arrays,
    _single: bool,
    n0: float = 1.8014398509481984e16,
    n1: float = 1.3510798882111488e16,
    n2: float = 5.404319552844595e16,
    n3: float = 7.205759403792794e16,
    n4: float = 2.0,
    n5: float = 1.152921504606847e18,
    n6: float = 4.0,
    n7: float = 3.725290298461914e-09,
) -> None:
    (tracking_index,) = given
    position, velocity = out
    w0, w1, w2 = work
    t2 = multiply(tracking_index, n0, w0)
    index_or_switch = minimum(t2, n1, out=w0)
    t7 = divide(n2, tracking_index, position)
    four_or_less = minimum(n3, t7, out=position)
    t10 = square(four_or_less, position)
    t11 = square(index_or_switch, w1)
    t12 = add(t10, t11, position)
    eta_scaled = sqrt(t12, velocity)
    t15 = multiply(eta_scaled, n4, w1)
    t16 = multiply(index_or_switch, n4, position)
    t17 = add(t15, t16, w1)
    t18 = multiply(index_or_switch, t17, position)
    ratio_scaled = sqrt(t18, position)
    t21 = multiply(index_or_switch, n5, w2)
    t22 = divide(t21, t17, w2)
    position_raised = sqrt(t22, w2)
    t27 = multiply(index_or_switch, n6, w1)
    t28 = add(index_or_switch, ratio_scaled, w0)
    t29 = add(eta_scaled, t28, velocity)
    multiply(position_raised, n7, position)
    divide(t27, t29, velocity)


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

        kappa = sqrt(4/Lambda^2 + 1/4), rho = sqrt(kappa + 1/2) = alpha/beta,
        sigma = Lambda/beta = Lambda (1/2 + kappa + rho)/2

    tracking_index: Lambda, with Lambda^2 =
        sampling_interval**2*velocity_deviation**2/measurement_deviation**2; a number above 0 and
        finite.

    position: derivative of the position entry of F K, alpha + beta. Relative error at most 9.82 *
        2^-52 (float64), 9.82 * 2^-23 (float32), proved for 5e-324 <= tracking_index <=
        7.11074631974658e102 (float64) and 1e-45 <= tracking_index <= 8.796093e12 (float32).
    velocity: derivative of the velocity entry of F K times the sampling interval, beta. Relative
        error at most 9.81 * 2^-52 (float64), 9.81 * 2^-23 (float32), proved for 5e-324 <=
        tracking_index <= 6.46054178400843e102 (float64) and 1e-45 <= tracking_index <= 7.9917807e12
        (float32).

    Outside an output's range, a few numbers next to its ends apart, its true value is no normal
    number: it comes as 0, a subnormal number or infinity, never as NaN. Numbers and arrays are
    taken, arrays of any shape; inputs are broadcast. float64 and float32 stay what they are,
    integers become float64. `out`: a tuple of arrays to fill. `workers`: threads that share the
    work on long arrays.

    ValueError: an input outside its domain, with its place; `out` or `workers` that does not fit.
    TypeError: an input that is no real number of these types; in `out` what is no array of the
    results' type.

    Source: derivation random-velocity
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
    t5 = tracking_index * 1.232595164407831e-32
    t7 = form.sqrt(t3 + t5)
    t8 = t7 / t1
    t12 = form.sqrt(t8 + 1.1102230246251565e-16)
    t14 = t12 * 1.4901161193847656e-08
    t17 = tracking_index * (t8 + (t14 + 1.1102230246251565e-16))
    t20 = (1.9721522630525295e-31 / (t17 * t17)) / (t1 * t7)
    t25 = (4.930380657631324e-32 / t14) + 4.440892098500626e-16
    t26 = t20 * t25
    t27 = (t20 * t14) + t26
    return (t27, t26)


def _predictor_gain_derivatives_block(
    given: Arrays,
    out: Arrays,
    work: Arrays,
    _single: bool,
    n0: float = 1.9721522630525295e-31,
    n1: float = 1.232595164407831e-32,
    n2: float = 1.1102230246251565e-16,
    n3: float = 1.4901161193847656e-08,
    n4: float = 4.930380657631324e-32,
    n5: float = 4.440892098500626e-16,
) -> None:
    (tracking_index,) = given
    position, velocity = out
    w0, w1 = work
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
    t15 = add(rho, n2, w1)
    t16 = add(kappa, t15, w0)
    t17 = multiply(tracking_index, t16, w0)
    t18 = square(t17, w0)
    t19 = divide(n0, t18, w0)
    t20 = divide(t19, half_eta, w0)
    t21 = multiply(t20, rho, w1)
    t23 = divide(n4, rho, position)
    t25 = add(t23, n5, position)
    multiply(t20, t25, velocity)
    add(t21, velocity, position)


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
        predicted_22 = Lambda^2 (rho + 1)
        kappa = sqrt(4/Lambda^2 + 1/4), rho = sqrt(kappa + 1/2) = alpha/beta,
        sigma = Lambda/beta = Lambda (1/2 + kappa + rho)/2

    tracking_index: Lambda, with Lambda^2 =
        sampling_interval**2*velocity_deviation**2/measurement_deviation**2; a number above 0 and
        finite.

    predicted_11: variance of the predicted position over sigma_v^2. Relative error at most 5.78 *
        2^-52 (float64), 5.78 * 2^-23 (float32), proved for 5e-324 <= tracking_index <=
        1.34078079299425e154 (float64) and 1e-45 <= tracking_index <= 1.8446673e19 (float32).
    predicted_12: covariance of predicted position and velocity times T/sigma_v^2. Relative error at
        most 3.53 * 2^-52 (float64), 3.53 * 2^-23 (float32), proved for 2.2250738585072014e-308 <=
        tracking_index <= 1.34078079299425e154 (float64) and 1.1754944e-38 <= tracking_index <=
        1.8446673e19 (float32).
    predicted_22: variance of the predicted velocity times T^2/sigma_v^2. Relative error at most
        3.76 * 2^-52 (float64), 3.26 * 2^-23 (float32), proved for 6.278939363646863e-206 <=
        tracking_index <= 9.480751908109109e153 (float64) and 4.1033358e-26 <= tracking_index <=
        1.3043767e19 (float32).

    Outside an output's range, a few numbers next to its ends apart, its true value is no normal
    number: it comes as 0, a subnormal number or infinity, never as NaN. Numbers and arrays are
    taken, arrays of any shape; inputs are broadcast. float64 and float32 stay what they are,
    integers become float64. `out`: a tuple of arrays to fill. `workers`: threads that share the
    work on long arrays.

    ValueError: an input outside its domain, with its place; `out` or `workers` that does not fit.
    TypeError: an input that is no real number of these types; in `out` what is no array of the
    results' type.

    Source: derivation random-velocity
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
    t5 = tracking_index * 1.232595164407831e-32
    t8 = form.sqrt(t3 + t5) / form.sqrt(tracking_index)
    t11 = form.sqrt(t8 + 1.1102230246251565e-16)
    t13 = t11 * 1.4901161193847656e-08
    t16 = tracking_index * (t8 + (t13 + 1.1102230246251565e-16))
    t18 = t16 * 2251799813685248.0
    t21 = (tracking_index * t13) * 4503599627370496.0
    t22 = t18 * t21
    t23 = tracking_index * t18
    t26 = (tracking_index * t21) + (tracking_index * tracking_index)
    return (t22, t23, t26)


def _predicted_covariance_block(
    given: Arrays,
    out: Arrays,
    work: Arrays,
    _single: bool,
    n0: float = 1.9721522630525295e-31,
    n1: float = 1.232595164407831e-32,
    n2: float = 1.1102230246251565e-16,
    n3: float = 1.4901161193847656e-08,
    n4: float = 2251799813685248.0,
    n5: float = 4503599627370496.0,
) -> None:
    (tracking_index,) = given
    predicted_11, predicted_12, predicted_22 = out
    w0, w1, w2 = work
    p = sqrt(tracking_index, predicted_11)
    t3 = divide(n0, tracking_index, predicted_12)
    t5 = multiply(tracking_index, n1, w0)
    t6 = add(t3, t5, predicted_12)
    h_scaled = sqrt(t6, predicted_22)
    kappa = divide(h_scaled, p, predicted_22)
    t10 = add(kappa, n2, w0)
    rho_scaled = sqrt(t10, w0)
    rho = multiply(rho_scaled, n3, w0)
    t14 = add(rho, n2, predicted_11)
    t15 = add(kappa, t14, predicted_22)
    t16 = multiply(tracking_index, t15, predicted_22)
    t18 = multiply(t16, n4, predicted_22)
    t19 = multiply(tracking_index, rho, w0)
    t21 = multiply(t19, n5, w0)
    t24 = multiply(tracking_index, t21, w1)
    t25 = square(tracking_index, w2)
    multiply(t18, t21, predicted_11)
    multiply(tracking_index, t18, predicted_12)
    add(t24, t25, predicted_22)


_PREDICTED_COVARIANCE = Signature(
    "predicted_covariance",
    (_TRACKING_INDEX_DOMAIN,),
    ("predicted_11", "predicted_12", "predicted_22"),
    3,
    _predicted_covariance_block,
    numbers=_predicted_covariance_of_numbers,
)


def predicted_covariance_derivatives(
    tracking_index: ArrayLike, *, out: tuple[Real, Real, Real] | None = None, workers: int = 1
) -> PredictedCovarianceDerivatives:
    """First derivatives of the predicted covariance.

        kappa = sqrt(4/Lambda^2 + 1/4), rho = sqrt(kappa + 1/2) = alpha/beta,
        sigma = Lambda/beta = Lambda (1/2 + kappa + rho)/2

    tracking_index: Lambda, with Lambda^2 =
        sampling_interval**2*velocity_deviation**2/measurement_deviation**2; a number above 0 and
        finite.

    predicted_11: derivative of the variance of the predicted position over sigma_v^2. Relative
        error at most 7.26 * 2^-52 (float64), 7.26 * 2^-23 (float32), proved for 5e-324 <=
        tracking_index <= 8.988465674311451e307 (float64) and 1e-45 <= tracking_index <=
        1.7013988e38 (float32).
    predicted_12: derivative of the covariance of predicted position and velocity times T/sigma_v^2.
        Relative error at most 4.06 * 2^-52 (float64), 4.06 * 2^-23 (float32), proved for 5e-324 <=
        tracking_index <= 8.988465674311451e307 (float64) and 1e-45 <= tracking_index <=
        1.7013988e38 (float32).
    predicted_22: derivative of the variance of the predicted velocity times T^2/sigma_v^2. Relative
        error at most 3.59 * 2^-52 (float64), 3.59 * 2^-23 (float32), proved for 5e-324 <=
        tracking_index <= 4.4942328371557254e307 (float64) and 1e-45 <= tracking_index <=
        8.506994e37 (float32).

    Outside an output's range, a few numbers next to its ends apart, its true value is no normal
    number: it comes as 0, a subnormal number or infinity, never as NaN. Numbers and arrays are
    taken, arrays of any shape; inputs are broadcast. float64 and float32 stay what they are,
    integers become float64. `out`: a tuple of arrays to fill. `workers`: threads that share the
    work on long arrays.

    ValueError: an input outside its domain, with its place; `out` or `workers` that does not fit.
    TypeError: an input that is no real number of these types; in `out` what is no array of the
    results' type.

    Source: derivation random-velocity
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
    t5 = tracking_index * 1.232595164407831e-32
    t8 = form.sqrt(t3 + t5) / form.sqrt(tracking_index)
    t10 = t8 + 1.1102230246251565e-16
    t13 = form.sqrt(t10) * 1.4901161193847656e-08
    t15 = t8 + (t13 + 1.1102230246251565e-16)
    t18 = (tracking_index * t15) * 2251799813685248.0
    t19 = t10 / t8
    t28 = 1.0 + (t19 * (1.1102230246251565e-16 / t13))
    t35 = (t13 * 4503599627370496.0) + (((t10 / t13) * t19) * 0.5)
    t24 = t18 * (t19 * ((t15 / t13) * 0.5))
    t29 = t18 * t28
    t38 = (tracking_index * t35) + (tracking_index * 2.0)
    return (t24, t29, t38)


def _predicted_covariance_derivatives_block(
    given: Arrays,
    out: Arrays,
    work: Arrays,
    _single: bool,
    n0: float = 1.9721522630525295e-31,
    n1: float = 1.232595164407831e-32,
    n2: float = 1.1102230246251565e-16,
    n3: float = 1.4901161193847656e-08,
    n4: float = 2251799813685248.0,
    n5: float = 0.5,
    n6: float = 1.0,
    n7: float = 4503599627370496.0,
    n8: float = 2.0,
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
    rho_scaled = sqrt(t10, predicted_11)
    rho = multiply(rho_scaled, n3, predicted_11)
    t14 = add(rho, n2, predicted_12)
    t15 = add(kappa, t14, predicted_12)
    t16 = multiply(tracking_index, t15, w1)
    t18 = multiply(t16, n4, w1)
    t19 = divide(t10, kappa, predicted_22)
    t20 = divide(t15, rho, predicted_12)
    t22 = multiply(t20, n5, predicted_12)
    t23 = multiply(t19, t22, predicted_12)
    t25 = divide(n2, rho, w2)
    t26 = multiply(t19, t25, w2)
    t28 = add(n6, t26, w2)
    t31 = multiply(rho, n7, w3)
    t32 = divide(t10, rho, w0)
    t33 = multiply(t32, t19, w0)
    t34 = multiply(t33, n5, w0)
    t35 = add(t31, t34, w3)
    t36 = multiply(tracking_index, t35, w3)
    t37 = multiply(tracking_index, n8, w0)
    multiply(t18, t23, predicted_11)
    multiply(t18, t28, predicted_12)
    add(t36, t37, predicted_22)


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
        updated_22 = Lambda^2 rho
        kappa = sqrt(4/Lambda^2 + 1/4), rho = sqrt(kappa + 1/2) = alpha/beta,
        sigma = Lambda/beta = Lambda (1/2 + kappa + rho)/2

    tracking_index: Lambda, with Lambda^2 =
        sampling_interval**2*velocity_deviation**2/measurement_deviation**2; a number above 0 and
        finite.

    updated_11: variance of the updated position over sigma_v^2. Relative error at most 3.26 * 2^-52
        (float64), 3.26 * 2^-23 (float32), proved for 5e-324 <= tracking_index <=
        1.7976931348623157e308 (float64) and 1e-45 <= tracking_index <= 3.4028235e38 (float32).
    updated_12: covariance of updated position and velocity times T/sigma_v^2. Relative error at
        most 3.51 * 2^-52 (float64), 3.51 * 2^-23 (float32), proved for 2.2250738585072014e-308 <=
        tracking_index <= 1.7976931348623157e308 (float64) and 1.1754944e-38 <= tracking_index <=
        3.4028235e38 (float32).
    updated_22: variance of the updated velocity times T^2/sigma_v^2. Relative error at most 2.76 *
        2^-52 (float64), 2.76 * 2^-23 (float32), proved for 6.278939363646863e-206 <= tracking_index
        <= 1.34078079299425e154 (float64) and 4.1033358e-26 <= tracking_index <= 1.8446673e19
        (float32).

    Outside an output's range, a few numbers next to its ends apart, its true value is no normal
    number: it comes as 0, a subnormal number or infinity, never as NaN. Numbers and arrays are
    taken, arrays of any shape; inputs are broadcast. float64 and float32 stay what they are,
    integers become float64. `out`: a tuple of arrays to fill. `workers`: threads that share the
    work on long arrays.

    ValueError: an input outside its domain, with its place; `out` or `workers` that does not fit.
    TypeError: an input that is no real number of these types; in `out` what is no array of the
    results' type.

    Source: derivation random-velocity
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
    t5 = tracking_index * 1.232595164407831e-32
    t8 = form.sqrt(t3 + t5) / form.sqrt(tracking_index)
    t11 = form.sqrt(t8 + 1.1102230246251565e-16)
    t13 = t11 * 1.4901161193847656e-08
    t17 = 2.0 / (t8 + (t13 + 1.1102230246251565e-16))
    t23 = (tracking_index * t13) * 4503599627370496.0
    t18 = t17 * t13
    t20 = t17 * 2.220446049250313e-16
    t24 = tracking_index * t23
    return (t18, t20, t24)


def _updated_covariance_block(
    given: Arrays,
    out: Arrays,
    work: Arrays,
    _single: bool,
    n0: float = 1.9721522630525295e-31,
    n1: float = 1.232595164407831e-32,
    n2: float = 1.1102230246251565e-16,
    n3: float = 1.4901161193847656e-08,
    n4: float = 2.0,
    n5: float = 4503599627370496.0,
    n6: float = 2.220446049250313e-16,
) -> None:
    (tracking_index,) = given
    updated_11, updated_12, updated_22 = out
    w0, w1 = work
    p = sqrt(tracking_index, updated_11)
    t3 = divide(n0, tracking_index, updated_12)
    t5 = multiply(tracking_index, n1, w0)
    t6 = add(t3, t5, updated_12)
    h_scaled = sqrt(t6, updated_22)
    kappa = divide(h_scaled, p, updated_22)
    t10 = add(kappa, n2, w0)
    rho_scaled = sqrt(t10, w0)
    rho = multiply(rho_scaled, n3, w0)
    t14 = add(rho, n2, updated_11)
    t15 = add(kappa, t14, updated_22)
    t17 = divide(n4, t15, updated_22)
    t21 = multiply(tracking_index, rho, updated_11)
    t23 = multiply(t21, n5, w1)
    multiply(t17, rho, updated_11)
    multiply(t17, n6, updated_12)
    multiply(tracking_index, t23, updated_22)


_UPDATED_COVARIANCE = Signature(
    "updated_covariance",
    (_TRACKING_INDEX_DOMAIN,),
    ("updated_11", "updated_12", "updated_22"),
    2,
    _updated_covariance_block,
    numbers=_updated_covariance_of_numbers,
)


def updated_covariance_derivatives(
    tracking_index: ArrayLike, *, out: tuple[Real, Real, Real] | None = None, workers: int = 1
) -> UpdatedCovarianceDerivatives:
    """First derivatives of the updated covariance.

        kappa = sqrt(4/Lambda^2 + 1/4), rho = sqrt(kappa + 1/2) = alpha/beta,
        sigma = Lambda/beta = Lambda (1/2 + kappa + rho)/2

    tracking_index: Lambda, with Lambda^2 =
        sampling_interval**2*velocity_deviation**2/measurement_deviation**2; a number above 0 and
        finite.

    updated_11: derivative of the variance of the updated position over sigma_v^2. Relative error at
        most 8.76 * 2^-52 (float64), 8.76 * 2^-23 (float32), proved for 5e-324 <= tracking_index <=
        4.4794894843556084e102 (float64) and 1e-45 <= tracking_index <= 5.541191e12 (float32).
    updated_12: derivative of the covariance of updated position and velocity times T/sigma_v^2.
        Relative error at most 9.81 * 2^-52 (float64), 9.81 * 2^-23 (float32), proved for 5e-324 <=
        tracking_index <= 6.46054178400843e102 (float64) and 1e-45 <= tracking_index <= 7.9917807e12
        (float32).
    updated_22: derivative of the variance of the updated velocity times T^2/sigma_v^2. Relative
        error at most 3.09 * 2^-52 (float64), 3.09 * 2^-23 (float32), proved for 5e-324 <=
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

    Source: derivation random-velocity
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
    t5 = tracking_index * 1.232595164407831e-32
    t7 = form.sqrt(t3 + t5)
    t8 = t7 / t1
    t11 = t8 + 1.1102230246251565e-16
    t14 = form.sqrt(t11) * 1.4901161193847656e-08
    t17 = tracking_index * (t8 + (t14 + 1.1102230246251565e-16))
    t20 = (1.9721522630525295e-31 / (t17 * t17)) / (t1 * t7)
    t25 = (4.930380657631324e-32 / t14) + 4.440892098500626e-16
    t34 = (t14 * 4503599627370496.0) + (((t11 / t14) * (t11 / t8)) * 0.5)
    t21 = t20 * t14
    t26 = t20 * t25
    t35 = tracking_index * t34
    return (t21, t26, t35)


def _updated_covariance_derivatives_block(
    given: Arrays,
    out: Arrays,
    work: Arrays,
    _single: bool,
    n0: float = 1.9721522630525295e-31,
    n1: float = 1.232595164407831e-32,
    n2: float = 1.1102230246251565e-16,
    n3: float = 1.4901161193847656e-08,
    n4: float = 4.930380657631324e-32,
    n5: float = 4.440892098500626e-16,
    n6: float = 4503599627370496.0,
    n7: float = 0.5,
) -> None:
    (tracking_index,) = given
    updated_11, updated_12, updated_22 = out
    w0, w1, w2, w3 = work
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
    t15 = add(rho, n2, w1)
    t16 = add(kappa, t15, w1)
    t17 = multiply(tracking_index, t16, w1)
    t18 = square(t17, w1)
    t19 = divide(n0, t18, w1)
    t20 = divide(t19, half_eta, w1)
    t23 = divide(n4, rho, updated_11)
    t25 = add(t23, n5, w2)
    t28 = multiply(rho, n6, updated_11)
    t29 = divide(t11, rho, w3)
    t30 = divide(t11, kappa, updated_12)
    t31 = multiply(t29, t30, w3)
    t33 = multiply(t31, n7, w3)
    t34 = add(t28, t33, w3)
    multiply(t20, rho, updated_11)
    multiply(t20, t25, updated_12)
    multiply(tracking_index, t34, updated_22)


_UPDATED_COVARIANCE_DERIVATIVES = Signature(
    "updated_covariance_derivatives",
    (_TRACKING_INDEX_DOMAIN,),
    ("updated_11", "updated_12", "updated_22"),
    4,
    _updated_covariance_derivatives_block,
    numbers=_updated_covariance_derivatives_of_numbers,
)


def gain_second_derivatives(
    tracking_index: ArrayLike, *, out: tuple[Real, Real] | None = None, workers: int = 1
) -> GainSecondDerivatives:
    """Second derivatives of the filter gain, both negative.

        d2 alpha = -psi (psi + chi)/(sigma Lambda)^2, d2 beta negative, too.
        psi = (1 + e/(2 kappa))/rho with e = 1: sigma^2 grows like this power of Lambda, and psi
        itself like the power 1 - chi.
        kappa = sqrt(4/Lambda^2 + 1/4), rho = sqrt(kappa + 1/2) = alpha/beta,
        sigma = Lambda/beta = Lambda (1/2 + kappa + rho)/2

    tracking_index: Lambda, with Lambda^2 =
        sampling_interval**2*velocity_deviation**2/measurement_deviation**2; a number above 0 and
        finite.

    alpha: second derivative by Lambda of the position gain. Relative error at most 12.81 * 2^-52
        (float64), 12.79 * 2^-23 (float32), proved for 1.5697348409117313e-206 <= tracking_index <=
        1.2814501160326402e77 (float64) and 1.0258394e-26 <= tracking_index <= 4.753162e09
        (float32).
    beta: second derivative by Lambda of the velocity gain times the sampling interval. Relative
        error at most 12.33 * 2^-52 (float64), 12.26 * 2^-23 (float32), proved for 5e-324 <=
        tracking_index <= 1.686483196605514e77 (float64) and 1e-45 <= tracking_index <= 6.2555136e09
        (float32).

    Outside an output's range, a few numbers next to its ends apart, its true value is no normal
    number: it comes as 0, a subnormal number or infinity, never as NaN. Numbers and arrays are
    taken, arrays of any shape; inputs are broadcast. float64 and float32 stay what they are,
    integers become float64. `out`: a tuple of arrays to fill. `workers`: threads that share the
    work on long arrays.

    ValueError: an input outside its domain, with its place; `out` or `workers` that does not fit.
    TypeError: an input that is no real number of these types; in `out` what is no array of the
    results' type.

    Source: derivation random-velocity
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
    t4 = 1.9721522630525295e-31 / tracking_index
    t6 = tracking_index * 1.232595164407831e-32
    t8 = form.sqrt(t4 + t6)
    t9 = t8 / t1
    t12 = t9 + 1.1102230246251565e-16
    t13 = form.sqrt(t12)
    t15 = t13 * 1.4901161193847656e-08
    t20 = tracking_index * (t9 + (t15 + 1.1102230246251565e-16))
    t22 = 1.9721522630525295e-31 / (t20 * t20)
    t23 = t15 / t9
    t27 = 2.220446049250313e-16 / t9
    t30 = ((t9 + 2.220446049250313e-16) / t9) * (t27 * 5.551115123125783e-17)
    t36 = t23 * (t23 + (((t9 + t30) / t12) * 0.5))
    t39 = ((t22 * t36) / tracking_index) / tracking_index
    t42 = (t13 * 2.9802322387695312e-08) * 2251799813685248.0
    t44 = 2.220446049250313e-16 / t15
    t52 = 1.0 + ((1.0 + (t44 * 0.5)) * (t27 * 0.5))
    t54 = t22 * ((((t42 * 3.0) + t44) * 0.5) + t52)
    t56 = (t1 * t8) * 4503599627370496.0
    t40 = -t39
    t59 = -((t54 / t56) / t56)
    return (t40, t59)


def _gain_second_derivatives_block(
    given: Arrays,
    out: Arrays,
    work: Arrays,
    _single: bool,
    n0: float = 1.9721522630525295e-31,
    n1: float = 1.232595164407831e-32,
    n2: float = 1.1102230246251565e-16,
    n3: float = 1.4901161193847656e-08,
    n4: float = 2.9802322387695312e-08,
    n5: float = 2.220446049250313e-16,
    n6: float = 5.551115123125783e-17,
    n7: float = 0.5,
    n8: float = 2251799813685248.0,
    n9: float = 3.0,
    n10: float = 1.0,
    n11: float = 4503599627370496.0,
) -> None:
    (tracking_index,) = given
    alpha, beta = out
    w0, w1, w2, w3, w4, w5, w6, w7 = work
    p = sqrt(tracking_index, alpha)
    t4 = divide(n0, tracking_index, beta)
    t6 = multiply(tracking_index, n1, w0)
    t7 = add(t4, t6, beta)
    h_scaled = sqrt(t7, beta)
    kappa = divide(h_scaled, p, w0)
    half_eta = multiply(p, h_scaled, alpha)
    t12 = add(kappa, n2, beta)
    rho_scaled = sqrt(t12, w1)
    rho = multiply(rho_scaled, n3, w2)
    twice_rho = multiply(rho_scaled, n4, w1)
    t18 = add(rho, n2, w3)
    t19 = add(kappa, t18, w3)
    t20 = multiply(tracking_index, t19, w3)
    t21 = square(t20, w3)
    t22 = divide(n0, t21, w3)
    t23 = divide(rho, kappa, w4)
    t25 = add(kappa, n5, w5)
    t26 = divide(t25, kappa, w5)
    t27 = divide(n5, kappa, w6)
    t29 = multiply(t27, n6, w7)
    t30 = multiply(t26, t29, w5)
    t31 = add(kappa, t30, w0)
    t32 = divide(t31, t12, w0)
    t34 = multiply(t32, n7, w0)
    t35 = add(t23, t34, w0)
    t36 = multiply(t23, t35, w4)
    t37 = multiply(t22, t36, w4)
    t38 = divide(t37, tracking_index, w4)
    t39 = divide(t38, tracking_index, w4)
    t42 = multiply(twice_rho, n8, w1)
    t43 = multiply(t42, n9, w1)
    t44 = divide(n5, rho, w2)
    t45 = add(t43, t44, w1)
    t46 = multiply(t45, n7, w1)
    t47 = multiply(t44, n7, w2)
    t49 = add(n10, t47, w2)
    t50 = multiply(t27, n7, w6)
    t51 = multiply(t49, t50, w2)
    t52 = add(n10, t51, w2)
    t53 = add(t46, t52, w1)
    t54 = multiply(t22, t53, w3)
    t56 = multiply(half_eta, n11, alpha)
    t57 = divide(t54, t56, w3)
    t58 = divide(t57, t56, w3)
    negative(t39, alpha)
    negative(t58, beta)


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
        kappa = sqrt(4/Lambda^2 + 1/4), rho = sqrt(kappa + 1/2) = alpha/beta,
        sigma = Lambda/beta = Lambda (1/2 + kappa + rho)/2

    tracking_index: Lambda, with Lambda^2 =
        sampling_interval**2*velocity_deviation**2/measurement_deviation**2; a number above 0 and
        finite.

    position: second derivative by Lambda of the position entry of F K, alpha + beta. Relative error
        at most 13.29 * 2^-52 (float64), 13.30 * 2^-23 (float32), proved for 1.5697348409117316e-206
        <= tracking_index <= 1.8122441335979363e77 (float64) and 1.0258395e-26 <= tracking_index <=
        6.721987e09 (float32).
    velocity: second derivative by Lambda of the velocity entry of F K times the sampling interval,
        beta. Relative error at most 12.33 * 2^-52 (float64), 12.26 * 2^-23 (float32), proved for
        5e-324 <= tracking_index <= 1.686483196605514e77 (float64) and 1e-45 <= tracking_index <=
        6.2555136e09 (float32).

    Outside an output's range, a few numbers next to its ends apart, its true value is no normal
    number: it comes as 0, a subnormal number or infinity, never as NaN. Numbers and arrays are
    taken, arrays of any shape; inputs are broadcast. float64 and float32 stay what they are,
    integers become float64. `out`: a tuple of arrays to fill. `workers`: threads that share the
    work on long arrays.

    ValueError: an input outside its domain, with its place; `out` or `workers` that does not fit.
    TypeError: an input that is no real number of these types; in `out` what is no array of the
    results' type.

    Source: derivation random-velocity
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
    t4 = 1.9721522630525295e-31 / tracking_index
    t6 = tracking_index * 1.232595164407831e-32
    t8 = form.sqrt(t4 + t6)
    t9 = t8 / t1
    t12 = t9 + 1.1102230246251565e-16
    t13 = form.sqrt(t12)
    t15 = t13 * 1.4901161193847656e-08
    t20 = tracking_index * (t9 + (t15 + 1.1102230246251565e-16))
    t22 = 1.9721522630525295e-31 / (t20 * t20)
    t23 = t15 / t9
    t27 = 2.220446049250313e-16 / t9
    t30 = ((t9 + 2.220446049250313e-16) / t9) * (t27 * 5.551115123125783e-17)
    t36 = t23 * (t23 + (((t9 + t30) / t12) * 0.5))
    t39 = ((t22 * t36) / tracking_index) / tracking_index
    t41 = (t13 * 2.9802322387695312e-08) * 2251799813685248.0
    t43 = 2.220446049250313e-16 / t15
    t51 = 1.0 + ((1.0 + (t43 * 0.5)) * (t27 * 0.5))
    t53 = t22 * ((((t41 * 3.0) + t43) * 0.5) + t51)
    t55 = (t1 * t8) * 4503599627370496.0
    t57 = (t53 / t55) / t55
    t59 = -(t39 + t57)
    t60 = -t57
    return (t59, t60)


def _predictor_gain_second_derivatives_block(
    given: Arrays,
    out: Arrays,
    work: Arrays,
    _single: bool,
    n0: float = 1.9721522630525295e-31,
    n1: float = 1.232595164407831e-32,
    n2: float = 1.1102230246251565e-16,
    n3: float = 1.4901161193847656e-08,
    n4: float = 2.9802322387695312e-08,
    n5: float = 2.220446049250313e-16,
    n6: float = 5.551115123125783e-17,
    n7: float = 0.5,
    n8: float = 2251799813685248.0,
    n9: float = 3.0,
    n10: float = 1.0,
    n11: float = 4503599627370496.0,
) -> None:
    (tracking_index,) = given
    position, velocity = out
    w0, w1, w2, w3, w4, w5, w6, w7 = work
    p = sqrt(tracking_index, position)
    t4 = divide(n0, tracking_index, velocity)
    t6 = multiply(tracking_index, n1, w0)
    t7 = add(t4, t6, velocity)
    h_scaled = sqrt(t7, velocity)
    kappa = divide(h_scaled, p, w0)
    half_eta = multiply(p, h_scaled, position)
    t12 = add(kappa, n2, velocity)
    rho_scaled = sqrt(t12, w1)
    rho = multiply(rho_scaled, n3, w2)
    twice_rho = multiply(rho_scaled, n4, w1)
    t18 = add(rho, n2, w3)
    t19 = add(kappa, t18, w3)
    t20 = multiply(tracking_index, t19, w3)
    t21 = square(t20, w3)
    t22 = divide(n0, t21, w3)
    t23 = divide(rho, kappa, w4)
    t25 = add(kappa, n5, w5)
    t26 = divide(t25, kappa, w5)
    t27 = divide(n5, kappa, w6)
    t29 = multiply(t27, n6, w7)
    t30 = multiply(t26, t29, w5)
    t31 = add(kappa, t30, w0)
    t32 = divide(t31, t12, w0)
    t34 = multiply(t32, n7, w0)
    t35 = add(t23, t34, w0)
    t36 = multiply(t23, t35, w4)
    t37 = multiply(t22, t36, w4)
    t38 = divide(t37, tracking_index, w4)
    t39 = divide(t38, tracking_index, w4)
    t41 = multiply(twice_rho, n8, w1)
    t42 = multiply(t41, n9, w1)
    t43 = divide(n5, rho, w2)
    t44 = add(t42, t43, w1)
    t45 = multiply(t44, n7, w1)
    t46 = multiply(t43, n7, w2)
    t48 = add(n10, t46, w2)
    t49 = multiply(t27, n7, w6)
    t50 = multiply(t48, t49, w2)
    t51 = add(n10, t50, w2)
    t52 = add(t45, t51, w1)
    t53 = multiply(t22, t52, w3)
    t55 = multiply(half_eta, n11, position)
    t56 = divide(t53, t55, w3)
    t57 = divide(t56, t55, w3)
    t58 = add(t39, t57, w4)
    negative(t58, position)
    negative(t57, velocity)


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
        psi = (1 + e/(2 kappa))/rho with e = 1: sigma^2 grows like this power of Lambda, and psi
        itself like the power 1 - chi.
        kappa = sqrt(4/Lambda^2 + 1/4), rho = sqrt(kappa + 1/2) = alpha/beta,
        sigma = Lambda/beta = Lambda (1/2 + kappa + rho)/2

    tracking_index: Lambda, with Lambda^2 =
        sampling_interval**2*velocity_deviation**2/measurement_deviation**2; a number above 0 and
        finite.

    predicted_11: second derivative by Lambda of the variance of the predicted position over
        sigma_v^2. Error over the sum of its terms' sizes at most 10.67 * 2^-52 (float64), 10.68 *
        2^-23 (float32), proved for 1.5697348409117308e-206 <= tracking_index <=
        1.7976931348623157e308 (float64) and 1.0258392e-26 <= tracking_index <= 3.4028235e38
        (float32). Cancellation, condition number 1: the variance bends down for a small index and
        up for a large one, so that it vanishes between. Digits that can be lost: up to 16 of 16 in
        float64, half or more only where 0.389234 <= tracking_index <= 0.38929; up to 7 of 7 in
        float32, half or more only where 0.37 <= tracking_index <= 0.41.
    predicted_12: second derivative by Lambda of the covariance of predicted position and velocity
        times T/sigma_v^2. Relative error at most 6.75 * 2^-52 (float64), 6.77 * 2^-23 (float32),
        proved for 5e-324 <= tracking_index <= 1.7976931348623157e308 (float64) and 1e-45 <=
        tracking_index <= 3.4028235e38 (float32).
    predicted_22: second derivative by Lambda of the variance of the predicted velocity times
        T^2/sigma_v^2. Relative error at most 3.26 * 2^-52 (float64), 3.26 * 2^-23 (float32), proved
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

    Source: derivation random-velocity
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
    t5 = tracking_index * 1.232595164407831e-32
    t7 = form.sqrt(t3 + t5)
    t8 = t7 / t1
    t11 = t8 + 1.1102230246251565e-16
    t12 = form.sqrt(t11)
    t14 = t12 * 1.4901161193847656e-08
    t18 = t8 + (t14 + 1.1102230246251565e-16)
    t19 = t18 / t8
    t21 = 2.220446049250313e-16 / t8
    t29 = (t19 * (t18 * (1.0 + (t21 * 0.5)))) * 0.25
    t30 = 2.220446049250313e-16 / t14
    t34 = 1.0 + t21
    t39 = (t18 * 4503599627370496.0) * (1.0 + (t34 * ((t21 * t21) * 0.25)))
    t48 = (t12 * 2.9802322387695312e-08) * 2251799813685248.0
    t55 = (1.9721522630525295e-31 / (t1 * t7)) / tracking_index
    t56 = t55 / t11
    t59 = (1.0 + ((t14 / t8) * 0.5)) + ((t56 * 0.5) * t34)
    t69 = (0.125 + (t21 * 0.0625)) * (5.0 + t56)
    t74 = t30 * (t69 + ((t55 / t8) * (t21 * 0.125)))
    t44 = (t29 - (((t18 * t30) * t39) * 0.125)) * 4503599627370496.0
    t60 = (t19 * (t48 * 0.25)) * t59
    t76 = ((t48 * 0.75) + t74) + 2.0
    return (t44, t60, t76)


def _predicted_covariance_second_derivatives_block(
    given: Arrays,
    out: Arrays,
    work: Arrays,
    _single: bool,
    n0: float = 1.9721522630525295e-31,
    n1: float = 1.232595164407831e-32,
    n2: float = 1.1102230246251565e-16,
    n3: float = 1.4901161193847656e-08,
    n4: float = 2.9802322387695312e-08,
    n5: float = 2.220446049250313e-16,
    n6: float = 0.5,
    n7: float = 1.0,
    n8: float = 0.25,
    n9: float = 4503599627370496.0,
    n10: float = 0.125,
    n11: float = 2251799813685248.0,
    n12: float = 0.75,
    n13: float = 0.0625,
    n14: float = 5.0,
    n15: float = 2.0,
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
    rho = multiply(rho_scaled, n3, w1)
    twice_rho = multiply(rho_scaled, n4, predicted_22)
    t17 = add(rho, n2, w2)
    t18 = add(kappa, t17, w2)
    t19 = divide(t18, kappa, w3)
    t21 = divide(n5, kappa, w4)
    t23 = multiply(t21, n6, w5)
    t25 = add(n7, t23, w5)
    t26 = multiply(t18, t25, w5)
    t27 = multiply(t19, t26, w5)
    t29 = multiply(t27, n8, w5)
    t30 = divide(n5, rho, w6)
    t31 = multiply(t18, t30, w7)
    t33 = multiply(t18, n9, w2)
    t34 = add(n7, t21, w8)
    t35 = square(t21, w9)
    t36 = multiply(t35, n8, w9)
    t37 = multiply(t34, t36, w9)
    t38 = add(n7, t37, w9)
    t39 = multiply(t33, t38, w2)
    t40 = multiply(t31, t39, w7)
    t42 = multiply(t40, n10, w7)
    predicted_11_turn = subtract(t29, t42, w5)
    t48 = multiply(twice_rho, n11, predicted_22)
    t49 = multiply(t48, n8, w2)
    t50 = multiply(t19, t49, w3)
    t51 = divide(rho, kappa, w1)
    t52 = multiply(t51, n6, w1)
    t53 = add(n7, t52, w1)
    t54 = divide(n0, half_eta, predicted_11)
    t55 = divide(t54, tracking_index, predicted_11)
    t56 = divide(t55, t11, predicted_12)
    t57 = multiply(t56, n6, w2)
    t58 = multiply(t57, t34, w2)
    t59 = add(t53, t58, w1)
    t62 = multiply(t48, n12, predicted_22)
    t64 = multiply(t21, n13, w2)
    t66 = add(n10, t64, w2)
    t68 = add(n14, t56, predicted_12)
    t69 = multiply(t66, t68, w2)
    t70 = divide(t55, kappa, predicted_11)
    t71 = multiply(t21, n10, w4)
    t72 = multiply(t70, t71, predicted_11)
    t73 = add(t69, t72, w2)
    t74 = multiply(t30, t73, w6)
    t75 = add(t62, t74, predicted_22)
    multiply(predicted_11_turn, n9, predicted_11)
    multiply(t50, t59, predicted_12)
    add(t75, n15, predicted_22)


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
        kappa = sqrt(4/Lambda^2 + 1/4), rho = sqrt(kappa + 1/2) = alpha/beta,
        sigma = Lambda/beta = Lambda (1/2 + kappa + rho)/2

    tracking_index: Lambda, with Lambda^2 =
        sampling_interval**2*velocity_deviation**2/measurement_deviation**2; a number above 0 and
        finite.

    updated_11: second derivative by Lambda of the variance of the updated position over sigma_v^2.
        Relative error at most 12.81 * 2^-52 (float64), 12.79 * 2^-23 (float32), proved for
        1.5697348409117313e-206 <= tracking_index <= 1.2814501160326402e77 (float64) and
        1.0258394e-26 <= tracking_index <= 4.753162e09 (float32).
    updated_12: second derivative by Lambda of the covariance of updated position and velocity times
        T/sigma_v^2. Relative error at most 12.33 * 2^-52 (float64), 12.26 * 2^-23 (float32), proved
        for 5e-324 <= tracking_index <= 1.686483196605514e77 (float64) and 1e-45 <= tracking_index
        <= 6.2555136e09 (float32).
    updated_22: second derivative by Lambda of the variance of the updated velocity times
        T^2/sigma_v^2. Relative error at most 3.64 * 2^-52 (float64), 3.63 * 2^-23 (float32), proved
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

    Source: derivation random-velocity
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
    t4 = 1.9721522630525295e-31 / tracking_index
    t6 = tracking_index * 1.232595164407831e-32
    t8 = form.sqrt(t4 + t6)
    t9 = t8 / t1
    t10 = t1 * t8
    t12 = t9 + 1.1102230246251565e-16
    t13 = form.sqrt(t12)
    t15 = t13 * 1.4901161193847656e-08
    t20 = tracking_index * (t9 + (t15 + 1.1102230246251565e-16))
    t22 = 1.9721522630525295e-31 / (t20 * t20)
    t23 = t15 / t9
    t27 = 2.220446049250313e-16 / t9
    t30 = ((t9 + 2.220446049250313e-16) / t9) * (t27 * 5.551115123125783e-17)
    t36 = t23 * (t23 + (((t9 + t30) / t12) * 0.5))
    t39 = ((t22 * t36) / tracking_index) / tracking_index
    t42 = (t13 * 2.9802322387695312e-08) * 2251799813685248.0
    t44 = 2.220446049250313e-16 / t15
    t52 = 1.0 + ((1.0 + (t44 * 0.5)) * (t27 * 0.5))
    t54 = t22 * ((((t42 * 3.0) + t44) * 0.5) + t52)
    t56 = t10 * 4503599627370496.0
    t67 = (1.9721522630525295e-31 / t10) / tracking_index
    t71 = (0.125 + (t27 * 0.0625)) * (5.0 + (t67 / t12))
    t76 = t44 * (t71 + ((t67 / t9) * (t27 * 0.125)))
    t40 = -t39
    t59 = -((t54 / t56) / t56)
    t77 = (t42 * 0.75) + t76
    return (t40, t59, t77)


def _updated_covariance_second_derivatives_block(
    given: Arrays,
    out: Arrays,
    work: Arrays,
    _single: bool,
    n0: float = 1.9721522630525295e-31,
    n1: float = 1.232595164407831e-32,
    n2: float = 1.1102230246251565e-16,
    n3: float = 1.4901161193847656e-08,
    n4: float = 2.9802322387695312e-08,
    n5: float = 2.220446049250313e-16,
    n6: float = 5.551115123125783e-17,
    n7: float = 0.5,
    n8: float = 2251799813685248.0,
    n9: float = 3.0,
    n10: float = 1.0,
    n11: float = 4503599627370496.0,
    n12: float = 0.75,
    n13: float = 0.0625,
    n14: float = 0.125,
    n15: float = 5.0,
) -> None:
    (tracking_index,) = given
    updated_11, updated_12, updated_22 = out
    w0, w1, w2, w3, w4, w5, w6, w7 = work
    p = sqrt(tracking_index, updated_11)
    t4 = divide(n0, tracking_index, updated_12)
    t6 = multiply(tracking_index, n1, w0)
    t7 = add(t4, t6, updated_12)
    h_scaled = sqrt(t7, updated_22)
    kappa = divide(h_scaled, p, w0)
    half_eta = multiply(p, h_scaled, updated_11)
    t12 = add(kappa, n2, updated_12)
    rho_scaled = sqrt(t12, updated_22)
    rho = multiply(rho_scaled, n3, w1)
    twice_rho = multiply(rho_scaled, n4, updated_22)
    t18 = add(rho, n2, w2)
    t19 = add(kappa, t18, w2)
    t20 = multiply(tracking_index, t19, w2)
    t21 = square(t20, w2)
    t22 = divide(n0, t21, w2)
    t23 = divide(rho, kappa, w3)
    t25 = add(kappa, n5, w4)
    t26 = divide(t25, kappa, w4)
    t27 = divide(n5, kappa, w5)
    t29 = multiply(t27, n6, w6)
    t30 = multiply(t26, t29, w4)
    t31 = add(kappa, t30, w4)
    t32 = divide(t31, t12, w4)
    t34 = multiply(t32, n7, w4)
    t35 = add(t23, t34, w4)
    t36 = multiply(t23, t35, w3)
    t37 = multiply(t22, t36, w3)
    t38 = divide(t37, tracking_index, w3)
    t39 = divide(t38, tracking_index, w3)
    t42 = multiply(twice_rho, n8, updated_22)
    t43 = multiply(t42, n9, w4)
    t44 = divide(n5, rho, w1)
    t45 = add(t43, t44, w4)
    t46 = multiply(t45, n7, w4)
    t47 = multiply(t44, n7, w6)
    t49 = add(n10, t47, w6)
    t50 = multiply(t27, n7, w7)
    t51 = multiply(t49, t50, w6)
    t52 = add(n10, t51, w6)
    t53 = add(t46, t52, w4)
    t54 = multiply(t22, t53, w2)
    t56 = multiply(half_eta, n11, w4)
    t57 = divide(t54, t56, w2)
    t58 = divide(t57, t56, w2)
    t61 = multiply(t42, n12, updated_22)
    t63 = multiply(t27, n13, w4)
    t65 = add(n14, t63, w4)
    t66 = divide(n0, half_eta, updated_11)
    t67 = divide(t66, tracking_index, updated_11)
    t68 = divide(t67, t12, updated_12)
    t70 = add(n15, t68, updated_12)
    t71 = multiply(t65, t70, w4)
    t72 = divide(t67, kappa, updated_11)
    t73 = multiply(t27, n14, w5)
    t74 = multiply(t72, t73, updated_11)
    t75 = add(t71, t74, w4)
    t76 = multiply(t44, t75, w1)
    negative(t39, updated_11)
    negative(t58, updated_12)
    add(t61, t76, updated_22)


_UPDATED_COVARIANCE_SECOND_DERIVATIVES = Signature(
    "updated_covariance_second_derivatives",
    (_TRACKING_INDEX_DOMAIN,),
    ("updated_11", "updated_12", "updated_22"),
    8,
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
        kappa = sqrt(4/Lambda^2 + 1/4), rho = sqrt(kappa + 1/2) = alpha/beta,
        sigma = Lambda/beta = Lambda (1/2 + kappa + rho)/2

    tracking_index: Lambda, with Lambda^2 =
        sampling_interval**2*velocity_deviation**2/measurement_deviation**2; a number above 0 and
        finite.

    first_real: real part of the first pole. Error over first_modulus at most 7.02 * 2^-52
        (float64), 7.03 * 2^-23 (float32), proved for 5e-324 <= tracking_index <=
        4.49423283715579e307 (float64) and 1e-45 <= tracking_index <= 8.507059e37 (float32). Digits
        that can be lost: up to 16 of 16 in float64, half or more only where tracking_index >=
        9.1e6; up to 7 of 7 in float32, half or more only where tracking_index >= 330.
    first_imaginary: imaginary part of the first pole, not negative. Error over first_modulus at
        most 5.10 * 2^-52 (float64), 5.10 * 2^-23 (float32), proved for 5e-324 <= tracking_index <=
        4.49423283715579e307 (float64) and 1e-45 <= tracking_index <= 8.507059e37 (float32). Digits
        that can be lost: up to 16 of 16 in float64, half or more only where tracking_index <=
        4.3e-14; up to 7 of 7 in float32, half or more only where tracking_index <= 3.7e-5.
    second_real: real part of the second pole. Error over second_modulus at most 7.02 * 2^-52
        (float64), 7.03 * 2^-23 (float32), proved for 5e-324 <= tracking_index <=
        4.49423283715579e307 (float64) and 1e-45 <= tracking_index <= 8.507059e37 (float32). Digits
        that can be lost: up to 16 of 16 in float64, half or more only where tracking_index >=
        9.1e6; up to 7 of 7 in float32, half or more only where tracking_index >= 330.
    second_imaginary: imaginary part of the second pole, not positive. Error over second_modulus at
        most 5.10 * 2^-52 (float64), 5.10 * 2^-23 (float32), proved for 5e-324 <= tracking_index <=
        4.49423283715579e307 (float64) and 1e-45 <= tracking_index <= 8.507059e37 (float32). Digits
        that can be lost: up to 16 of 16 in float64, half or more only where tracking_index <=
        4.3e-14; up to 7 of 7 in float32, half or more only where tracking_index <= 3.7e-5.

    Outside an output's range, a few numbers next to its ends apart, its true value is no normal
    number: it comes as 0, a subnormal number or infinity, never as NaN. Numbers and arrays are
    taken, arrays of any shape; inputs are broadcast. float64 and float32 stay what they are,
    integers become float64. `out`: a tuple of arrays to fill. `workers`: threads that share the
    work on long arrays.

    ValueError: an input outside its domain, with its place; `out` or `workers` that does not fit.
    TypeError: an input that is no real number of these types; in `out` what is no array of the
    results' type.

    Source: derivation random-velocity
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
    t5 = tracking_index * 1.232595164407831e-32
    t8 = form.sqrt(t3 + t5) / form.sqrt(tracking_index)
    t10 = t8 + 1.1102230246251565e-16
    t13 = form.sqrt(t10) * 1.4901161193847656e-08
    t16 = tracking_index * (t8 + (t13 + 1.1102230246251565e-16))
    t18 = 4.440892098500626e-16 / t16
    t21 = (tracking_index * t10) * 2251799813685248.0
    t25 = (t18 / t13) * 2.220446049250313e-16
    t22 = t18 / t21
    t26 = -t25
    return (t22, t25, t22, t26)


def _closed_loop_poles_block(
    given: Arrays,
    out: Arrays,
    work: Arrays,
    _single: bool,
    n0: float = 1.9721522630525295e-31,
    n1: float = 1.232595164407831e-32,
    n2: float = 1.1102230246251565e-16,
    n3: float = 1.4901161193847656e-08,
    n4: float = 4.440892098500626e-16,
    n5: float = 2251799813685248.0,
    n6: float = 2.220446049250313e-16,
) -> None:
    (tracking_index,) = given
    first_real, first_imaginary, second_real, second_imaginary = out
    (w0,) = work
    p = sqrt(tracking_index, first_imaginary)
    t3 = divide(n0, tracking_index, first_real)
    t5 = multiply(tracking_index, n1, w0)
    t6 = add(t3, t5, first_real)
    h_scaled = sqrt(t6, second_imaginary)
    kappa = divide(h_scaled, p, second_imaginary)
    t10 = add(kappa, n2, w0)
    rho_scaled = sqrt(t10, first_real)
    rho = multiply(rho_scaled, n3, first_real)
    t14 = add(rho, n2, first_imaginary)
    t15 = add(kappa, t14, second_imaginary)
    t16 = multiply(tracking_index, t15, second_imaginary)
    t18 = divide(n4, t16, second_imaginary)
    t19 = multiply(tracking_index, t10, w0)
    t21 = multiply(t19, n5, w0)
    t23 = divide(t18, rho, first_real)
    multiply(t23, n6, first_imaginary)
    divide(t18, t21, first_real)
    negative(first_imaginary, second_imaginary)
    copyto(second_real, first_real)


_CLOSED_LOOP_POLES = Signature(
    "closed_loop_poles",
    (_TRACKING_INDEX_DOMAIN,),
    ("first_real", "first_imaginary", "second_real", "second_imaginary"),
    1,
    _closed_loop_poles_block,
    numbers=_closed_loop_poles_of_numbers,
)


def index_from_alpha(
    alpha: ArrayLike, *, out: tuple[Real] | None = None, workers: int = 1
) -> IndexFromAlpha:
    """The tracking index that belongs to a position gain.

        alpha**2 + alpha*beta - 2*beta = 0, Lambda^2 = beta^2/(1 - alpha)

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

    Source: derivation random-velocity
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
    t12 = (2.0 - alpha) + form.sqrt((t2 * 4.0) + t5)
    t14 = ((t5 * 2.0) / t12) / form.sqrt(t2)
    return (t14,)


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
    t5 = square(alpha, w2)
    t6 = add(t4, t5, w1)
    alpha_radical = sqrt(t6, tracking_index)
    root_of_rest = sqrt(t2, w0)
    t10 = multiply(t5, n2, w2)
    t11 = subtract(n2, alpha, w1)
    t12 = add(t11, alpha_radical, w1)
    t13 = divide(t10, t12, w2)
    divide(t13, root_of_rest, tracking_index)


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

        alpha**2 + alpha*beta - 2*beta = 0, Lambda^2 = beta^2/(1 - alpha)

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

    Source: derivation random-velocity
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
    t7 = form.sqrt(((1.0 - alpha) * 4.0) + t5)
    t12 = (t5 * 2.0) / ((2.0 - alpha) + t7)
    return (t12,)


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
    t5 = square(alpha, w1)
    t6 = add(t4, t5, w0)
    alpha_radical = sqrt(t6, beta)
    t9 = multiply(t5, n2, w1)
    t10 = subtract(n2, alpha, w0)
    t11 = add(t10, alpha_radical, w0)
    divide(t9, t11, beta)


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

        alpha**2 + alpha*beta - 2*beta = 0, Lambda^2 = beta^2/(1 - alpha)

    beta: velocity gain times the sampling interval; a number above 0 and below 1.

    tracking_index: tracking index Lambda. Relative error at most 2.13 * 2^-52 (float64), 2.13 *
        2^-23 (float32), proved for 2.2250738585072014e-308 <= beta <= 0.9999999999999999 (float64)
        and 1.1754944e-38 <= beta <= 0.99999994 (float32).

    Outside an output's range, a few numbers next to its ends apart, its true value is no normal
    number: it comes as 0, a subnormal number or infinity, never as NaN. Numbers and arrays are
    taken, arrays of any shape; inputs are broadcast. float64 and float32 stay what they are,
    integers become float64. `out`: a tuple of arrays to fill. `workers`: threads that share the
    work on long arrays.

    ValueError: an input outside its domain, with its place; `out` or `workers` that does not fit.
    TypeError: an input that is no real number of these types; in `out` what is no array of the
    results' type.

    Source: derivation random-velocity
    """
    if (
        type(beta) is float
        and 5e-324 <= beta <= 0.9999999999999999
        and out is None
        and workers is ONE
    ):
        try:
            return named(IndexFromBeta, _index_from_beta_of_numbers(beta))
        except (ArithmeticError, ValueError):
            pass  # arrays say what is wrong
    return IndexFromBeta(*evaluate(_INDEX_FROM_BETA, (beta,), out, workers))


def _index_from_beta_of_numbers(beta: float, form: Form = Double) -> tuple[float, ...]:
    t11 = (2.0 + beta) + form.sqrt(beta * (8.0 + beta))
    t14 = form.sqrt(((1.0 - beta) * 4.0) / (t11 * 2.0))
    t15 = beta / t14
    return (t15,)


def _index_from_beta_block(
    given: Arrays,
    out: Arrays,
    work: Arrays,
    _single: bool,
    n0: float = 8.0,
    n1: float = 1.0,
    n2: float = 4.0,
    n3: float = 2.0,
) -> None:
    (beta,) = given
    (tracking_index,) = out
    w0, w1 = work
    t2 = add(n0, beta, w0)
    t3 = multiply(beta, t2, w0)
    beta_radical = sqrt(t3, tracking_index)
    t6 = subtract(n1, beta, w0)
    t8 = multiply(t6, n2, w0)
    t10 = add(n3, beta, w1)
    t11 = add(t10, beta_radical, w1)
    t12 = multiply(t11, n3, w1)
    t13 = divide(t8, t12, w0)
    root_of_rest = sqrt(t13, w0)
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

        alpha**2 + alpha*beta - 2*beta = 0, Lambda^2 = beta^2/(1 - alpha)

    beta: velocity gain times the sampling interval; a number above 0 and below 1.

    alpha: position gain. Relative error at most 2.01 * 2^-52 (float64), 2.01 * 2^-23 (float32),
        proved for 5e-324 <= beta <= 0.9999999999999999 (float64) and 1e-45 <= beta <= 0.99999994
        (float32).

    Outside an output's range, a few numbers next to its ends apart, its true value is no normal
    number: it comes as 0, a subnormal number or infinity, never as NaN. Numbers and arrays are
    taken, arrays of any shape; inputs are broadcast. float64 and float32 stay what they are,
    integers become float64. `out`: a tuple of arrays to fill. `workers`: threads that share the
    work on long arrays.

    ValueError: an input outside its domain, with its place; `out` or `workers` that does not fit.
    TypeError: an input that is no real number of these types; in `out` what is no array of the
    results' type.

    Source: derivation random-velocity
    """
    if (
        type(beta) is float
        and 5e-324 <= beta <= 0.9999999999999999
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
    t10 = form.sqrt(t2 * (8.0 + beta)) + (beta * 1073741824.0)
    t13 = (t2 * 8.0) / (t10 * 2147483648.0)
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
    t4 = add(n1, beta, w1)
    t5 = multiply(t2, t4, w1)
    scaled_beta_radical = sqrt(t5, alpha)
    t7 = multiply(t2, n1, w0)
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
