# Made by: gainproof generate updated-gains
# From: gainproof derive updated-gains, SymPy 1.14.0
"""Gains that follow the tracking index to first order."""

from __future__ import annotations

from typing import TYPE_CHECKING

from numpy import add, divide, multiply, sqrt, square, subtract

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
    "CycleDrift",
    "FirstOrderErrors",
    "FirstOrderGains",
    "LineOfSightGains",
    "MismatchVariances",
    "RecursiveGains",
    "TrackingIndex",
    "UpdateLimits",
    "cycle_drift",
    "first_order_errors",
    "first_order_gains",
    "line_of_sight_gains",
    "mismatch_variances",
    "recursive_gains",
    "tracking_index",
    "update_limits",
]

_ACCELERATION_DEVIATION_DOMAIN = Domain(
    "acceleration_deviation",
    "a number at least 1e-30 and at most 1e30, in float32 at least 1e-6 and at most 1e6",
    (1e-30, 1e30),
    (9.999999974752427e-07, 1000000.0),
)
_INTERVAL_DOMAIN = Domain(
    "interval",
    "a number at least 1e-15 and at most 1e15, in float32 at least 1e-6 and at most 1e6",
    (1e-15, 1000000000000000.0),
    (9.999999974752427e-07, 1000000.0),
)
_VARIANCE_DOMAIN = Domain(
    "variance",
    "a number at least 1e-60 and at most 1e60, in float32 at least 1e-12 and at most 1e12",
    (1e-60, 1e60),
    (9.999999960041972e-13, 999999995904.0),
)
_NOMINAL_INDEX_DOMAIN = Domain(
    "nominal_index",
    "a number at least 1e-12 and at most 1e12, in float32 at least 1e-5 and at most 1e5",
    (1e-12, 1000000000000.0),
    (9.999999747378752e-06, 100000.0),
)
_TRACKING_INDEX_DOMAIN = Domain(
    "tracking_index",
    "a number at least 1e-12 and at most 1e12, in float32 at least 1e-5 and at most 1e5",
    (1e-12, 1000000000000.0),
    (9.999999747378752e-06, 100000.0),
)
_ALPHA_DOMAIN = Domain(
    "alpha",
    "0 or of magnitude 1e-30 to 1e30, in float32 1e-9 to 1e9",
    (1e-30, 1e30),
    (9.999999717180685e-10, 1000000000.0),
    zero=True,
    signed=True,
)
_BETA_DOMAIN = Domain(
    "beta",
    "0 or of magnitude 1e-30 to 1e30, in float32 1e-9 to 1e9",
    (1e-30, 1e30),
    (9.999999717180685e-10, 1000000000.0),
    zero=True,
    signed=True,
)
_NEXT_INDEX_DOMAIN = Domain(
    "next_index",
    "a number at least 1e-12 and at most 1e12, in float32 at least 1e-5 and at most 1e5",
    (1e-12, 1000000000000.0),
    (9.999999747378752e-06, 100000.0),
)
_ALONG_DOMAIN = Domain(
    "along",
    "a number at least 1e-30 and at most 1e30, in float32 at least 1e-9 and at most 1e9",
    (1e-30, 1e30),
    (9.999999717180685e-10, 1000000000.0),
)
_ACROSS_DOMAIN = Domain(
    "across",
    "a number at least 1e-30 and at most 1e30, in float32 at least 1e-9 and at most 1e9",
    (1e-30, 1e30),
    (9.999999717180685e-10, 1000000000.0),
)
_COSINE_DOMAIN = Domain(
    "cosine",
    "of magnitude at most 2, in float32 2",
    (0.0, 2.0),
    (0.0, 2.0),
    zero=True,
    signed=True,
)
_SINE_DOMAIN = Domain(
    "sine",
    "of magnitude at most 2, in float32 2",
    (0.0, 2.0),
    (0.0, 2.0),
    zero=True,
    signed=True,
)


class TrackingIndex(NamedTuple):
    """Result of `tracking_index`."""

    tracking_index: Real
    """Tracking index Lambda."""


def tracking_index(
    acceleration_deviation: ArrayLike,
    interval: ArrayLike,
    variance: ArrayLike,
    *,
    out: tuple[Real] | None = None,
    workers: int = 1,
) -> TrackingIndex:
    """The tracking index of an axis from the variance of its measurement.

        Lambda = sigma_w T^2/sqrt(R)

    acceleration_deviation: standard deviation of the acceleration, m/s^2; a number at least 1e-30
        and at most 1e30, in float32 at least 1e-6 and at most 1e6.
    interval: time between two scans, s; a number at least 1e-15 and at most 1e15, in float32 at
        least 1e-6 and at most 1e6.
    variance: variance of the measurement along the axis, m^2; a number at least 1e-60 and at most
        1e60, in float32 at least 1e-12 and at most 1e12.

    tracking_index: tracking index Lambda. Relative error at most 2.01 * 2^-52 (float64), 2.01 *
        2^-23 (float32), proved for every input.

    Every true value that an error is relative to is a normal number. Numbers and arrays are taken,
    arrays of any shapes that broadcast. Where all inputs are float32 so are the results; otherwise
    everything becomes float64, integers too. `out`: a tuple of arrays to fill. `workers`: threads
    that share the work on long arrays.

    ValueError: an input outside its domain, with its place; `out` or `workers` that does not fit.
    TypeError: an input that is no real number of these types; in `out` what is no array of the
    results' type.

    Source: derivation updated-gains
    """
    if (
        type(acceleration_deviation) is float
        and type(interval) is float
        and type(variance) is float
        and 1e-30 <= acceleration_deviation <= 1e30
        and 1e-15 <= interval <= 1000000000000000.0
        and 1e-60 <= variance <= 1e60
        and out is None
        and workers is ONE
    ):
        try:
            return named(
                TrackingIndex,
                _tracking_index_of_numbers(acceleration_deviation, interval, variance),
            )
        except (ArithmeticError, ValueError):
            pass  # arrays say what is wrong
    return TrackingIndex(
        *evaluate(_TRACKING_INDEX, (acceleration_deviation, interval, variance), out, workers)
    )


def _tracking_index_of_numbers(
    acceleration_deviation: float,
    interval: float,
    variance: float,
    form: Form = Double,
) -> tuple[float, ...]:
    t5 = acceleration_deviation * (interval * interval)
    t6 = t5 / form.sqrt(variance)
    return (t6,)


def _tracking_index_block(given: Arrays, out: Arrays, work: Arrays, _single: bool) -> None:
    acceleration_deviation, interval, variance = given
    (tracking_index,) = out
    (w0,) = work
    deviation = sqrt(variance, tracking_index)
    t4 = square(interval, w0)
    t5 = multiply(acceleration_deviation, t4, w0)
    divide(t5, deviation, tracking_index)


_TRACKING_INDEX = Signature(
    "tracking_index",
    (_ACCELERATION_DEVIATION_DOMAIN, _INTERVAL_DOMAIN, _VARIANCE_DOMAIN),
    ("tracking_index",),
    1,
    _tracking_index_block,
    numbers=_tracking_index_of_numbers,
)


class FirstOrderGains(NamedTuple):
    """Result of `first_order_gains`."""

    alpha: Real
    """Position gain."""
    beta: Real
    """Velocity gain times the sampling interval."""


def first_order_gains(
    nominal_index: ArrayLike,
    tracking_index: ArrayLike,
    *,
    out: tuple[Real, Real] | None = None,
    workers: int = 1,
) -> FirstOrderGains:
    """Gains updated to first order from a nominal index, constant derivatives.

        alpha(L) + alpha'(L) (Lambda - L), beta likewise, as sums of positive terms:
        alpha = (n (n^2 + 4 n + 2)/(1 + n) + Lambda/n)/((1 + n) (2 + n)),
        beta = 2 (n^3/(1 + n) + Lambda)/((1 + n) (2 + n)), n = L (1 + sqrt(1 + 8/L))/4;
        never below the exact gains; alpha > 1 and unstable filters as `update_limits` has it

    nominal_index: nominal index L, at which the gains are exact; a number at least 1e-12 and at
        most 1e12, in float32 at least 1e-5 and at most 1e5.
    tracking_index: tracking index Lambda; a number at least 1e-12 and at most 1e12, in float32 at
        least 1e-5 and at most 1e5.

    alpha: position gain. Relative error at most 7.18 * 2^-52 (float64), 7.02 * 2^-23 (float32),
        proved for every input.
    beta: velocity gain times the sampling interval. Relative error at most 10.50 * 2^-52 (float64),
        9.89 * 2^-23 (float32), proved for every input.

    Every true value that an error is relative to is a normal number. Numbers and arrays are taken,
    arrays of any shapes that broadcast. Where all inputs are float32 so are the results; otherwise
    everything becomes float64, integers too. `out`: a tuple of arrays to fill. `workers`: threads
    that share the work on long arrays.

    ValueError: an input outside its domain, with its place; `out` or `workers` that does not fit.
    TypeError: an input that is no real number of these types; in `out` what is no array of the
    results' type.

    Source: derivation updated-gains
    """
    if (
        type(nominal_index) is float
        and type(tracking_index) is float
        and 1e-12 <= nominal_index <= 1000000000000.0
        and 1e-12 <= tracking_index <= 1000000000000.0
        and out is None
        and workers is ONE
    ):
        try:
            return named(
                FirstOrderGains, _first_order_gains_of_numbers(nominal_index, tracking_index)
            )
        except (ArithmeticError, ValueError):
            pass  # arrays say what is wrong
    return FirstOrderGains(
        *evaluate(_FIRST_ORDER_GAINS, (nominal_index, tracking_index), out, workers)
    )


def _first_order_gains_of_numbers(
    nominal_index: float,
    tracking_index: float,
    form: Form = Double,
) -> tuple[float, ...]:
    t6 = form.sqrt((8.0 / nominal_index) + 1.0)
    t10 = (nominal_index * (t6 + 1.0)) * 0.25
    t11 = t10 + 1.0
    t14 = t11 * (t10 + 2.0)
    t19 = (t10 * (((t10 + 4.0) * t10) + 2.0)) / t11
    t26 = ((t10 * t10) * (t10 / t11)) + tracking_index
    t22 = (t19 + (tracking_index / t10)) / t14
    t28 = (t26 * 2.0) / t14
    return (t22, t28)


def _first_order_gains_block(
    given: Arrays,
    out: Arrays,
    work: Arrays,
    _single: bool,
    n0: float = 8.0,
    n1: float = 1.0,
    n2: float = 0.25,
    n3: float = 2.0,
    n4: float = 4.0,
) -> None:
    nominal_index, tracking_index = given
    alpha, beta = out
    w0, w1, w2 = work
    t3 = divide(n0, nominal_index, alpha)
    t5 = add(t3, n1, alpha)
    nominal_root = sqrt(t5, beta)
    t7 = add(nominal_root, n1, beta)
    t8 = multiply(nominal_index, t7, beta)
    t10 = multiply(t8, n2, beta)
    t11 = add(t10, n1, alpha)
    t13 = add(t10, n3, w0)
    t14 = multiply(t11, t13, w0)
    t15 = add(t10, n4, w1)
    t16 = multiply(t15, t10, w1)
    t17 = add(t16, n3, w1)
    t18 = multiply(t10, t17, w1)
    t19 = divide(t18, t11, w1)
    t20 = divide(tracking_index, t10, w2)
    t21 = add(t19, t20, w1)
    t23 = square(t10, w2)
    t24 = divide(t10, t11, beta)
    t25 = multiply(t23, t24, w2)
    t26 = add(t25, tracking_index, w2)
    t27 = multiply(t26, n3, w2)
    divide(t21, t14, alpha)
    divide(t27, t14, beta)


_FIRST_ORDER_GAINS = Signature(
    "first_order_gains",
    (_NOMINAL_INDEX_DOMAIN, _TRACKING_INDEX_DOMAIN),
    ("alpha", "beta"),
    3,
    _first_order_gains_block,
    numbers=_first_order_gains_of_numbers,
)


class RecursiveGains(NamedTuple):
    """Result of `recursive_gains`."""

    next_alpha: Real
    """Position gain for the next index."""
    next_beta: Real
    """Velocity gain times the sampling interval for the next index."""


def recursive_gains(
    alpha: ArrayLike,
    beta: ArrayLike,
    tracking_index: ArrayLike,
    next_index: ArrayLike,
    *,
    out: tuple[Real, Real] | None = None,
    workers: int = 1,
) -> RecursiveGains:
    """Gains updated to first order from those of the last scan.

        next_alpha = alpha + alpha'(Lambda) (next_index - Lambda), next_beta likewise, with
        alpha' = 1/(e (1 + e) (2 + e)), beta' = 2/((1 + e) (2 + e)),
        e = Lambda (1 + sqrt(1 + 8/Lambda))/4; errors of all steps add up (`cycle_drift`)

    alpha: position gain; 0 or of magnitude 1e-30 to 1e30, in float32 1e-9 to 1e9.
    beta: velocity gain times the sampling interval; 0 or of magnitude 1e-30 to 1e30, in float32
        1e-9 to 1e9.
    tracking_index: tracking index Lambda; a number at least 1e-12 and at most 1e12, in float32 at
        least 1e-5 and at most 1e5.
    next_index: tracking index of the next scan; a number at least 1e-12 and at most 1e12, in
        float32 at least 1e-5 and at most 1e5.

    next_alpha: position gain for the next index. Error over the sum of its terms taken positive at
        most 9.51 * 2^-52 (float64), 9.51 * 2^-23 (float32), proved for every input. Digits that can
        be lost: up to 16 of 16 in float64 and 7 of 7 in float32; half or more only where the value
        is below 3e-7 in float64 and 0.008 in float32 of what its error is relative to; what
        cancels: alpha + (next_index - tracking_index)/((tracking_index*(sqrt(8/tracking_index + 1)
        + 1)/4 + 1)*(tracking_index*(sqrt(8/tracking_index + 1) + 1)/4 +
        2))/(tracking_index*(sqrt(8/tracking_index + 1) + 1)/4).
    next_beta: velocity gain times the sampling interval for the next index. Error over the sum of
        its terms taken positive at most 7.01 * 2^-52 (float64), 7.01 * 2^-23 (float32), proved for
        every input. Digits that can be lost: up to 16 of 16 in float64 and 7 of 7 in float32; half
        or more only where the value is below 2e-7 in float64 and 0.006 in float32 of what its error
        is relative to; what cancels: beta + 2*(next_index -
        tracking_index)/((tracking_index*(sqrt(8/tracking_index + 1) + 1)/4 +
        1)*(tracking_index*(sqrt(8/tracking_index + 1) + 1)/4 + 2)).

    Numbers and arrays are taken, arrays of any shapes that broadcast. Where all inputs are float32
    so are the results; otherwise everything becomes float64, integers too. `out`: a tuple of arrays
    to fill. `workers`: threads that share the work on long arrays.

    ValueError: an input outside its domain, with its place; `out` or `workers` that does not fit.
    TypeError: an input that is no real number of these types; in `out` what is no array of the
    results' type.

    Source: derivation updated-gains
    """
    if (
        type(alpha) is float
        and type(beta) is float
        and type(tracking_index) is float
        and type(next_index) is float
        and -1e30 <= alpha <= 1e30
        and (abs(alpha) >= 1e-30 or alpha == 0)
        and -1e30 <= beta <= 1e30
        and (abs(beta) >= 1e-30 or beta == 0)
        and 1e-12 <= tracking_index <= 1000000000000.0
        and 1e-12 <= next_index <= 1000000000000.0
        and out is None
        and workers is ONE
    ):
        try:
            return named(
                RecursiveGains, _recursive_gains_of_numbers(alpha, beta, tracking_index, next_index)
            )
        except (ArithmeticError, ValueError):
            pass  # arrays say what is wrong
    return RecursiveGains(
        *evaluate(_RECURSIVE_GAINS, (alpha, beta, tracking_index, next_index), out, workers)
    )


def _recursive_gains_of_numbers(
    alpha: float,
    beta: float,
    tracking_index: float,
    next_index: float,
    form: Form = Double,
) -> tuple[float, ...]:
    t8 = form.sqrt((8.0 / tracking_index) + 1.0)
    t12 = (tracking_index * (t8 + 1.0)) * 0.25
    t18 = (next_index - tracking_index) / ((t12 + 1.0) * (t12 + 2.0))
    t20 = alpha + (t18 / t12)
    t22 = beta + (t18 * 2.0)
    return (t20, t22)


def _recursive_gains_block(
    given: Arrays,
    out: Arrays,
    work: Arrays,
    _single: bool,
    n0: float = 8.0,
    n1: float = 1.0,
    n2: float = 0.25,
    n3: float = 2.0,
) -> None:
    alpha, beta, tracking_index, next_index = given
    next_alpha, next_beta = out
    w0, w1 = work
    t5 = divide(n0, tracking_index, next_alpha)
    t7 = add(t5, n1, next_alpha)
    root = sqrt(t7, next_beta)
    t9 = add(root, n1, next_beta)
    t10 = multiply(tracking_index, t9, next_beta)
    t12 = multiply(t10, n2, next_beta)
    t13 = subtract(next_index, tracking_index, next_alpha)
    t14 = add(t12, n1, w0)
    t16 = add(t12, n3, w1)
    t17 = multiply(t14, t16, w0)
    t18 = divide(t13, t17, next_alpha)
    t19 = divide(t18, t12, next_beta)
    t21 = multiply(t18, n3, w0)
    add(alpha, t19, next_alpha)
    add(beta, t21, next_beta)


_RECURSIVE_GAINS = Signature(
    "recursive_gains",
    (_ALPHA_DOMAIN, _BETA_DOMAIN, _TRACKING_INDEX_DOMAIN, _NEXT_INDEX_DOMAIN),
    ("next_alpha", "next_beta"),
    2,
    _recursive_gains_block,
    numbers=_recursive_gains_of_numbers,
)


class UpdateLimits(NamedTuple):
    """Result of `update_limits`."""

    alpha_one_ratio: Real
    """Lambda/L beyond which the position gain exceeds 1."""
    unstable_ratio: Real
    """Lambda/L from which on the filter is not stable."""
    variance_ratio: Real
    """Lambda/L up to which the update lowers all variances, over those of L."""
    alpha_gain_ratio: Real
    """Lambda/L beyond which alpha is farther from the exact one than that of L."""
    beta_gain_ratio: Real
    """Lambda/L beyond which beta is farther from the exact one than that of L."""


def update_limits(
    nominal_index: ArrayLike,
    *,
    out: tuple[Real, Real, Real, Real, Real] | None = None,
    workers: int = 1,
) -> UpdateLimits:
    """How far from its nominal index a first-order update is of use.

        of `first_order_gains`: alpha_one_ratio = 3/2 + 1/n, unstable_ratio = 2 + 2/n,
        variance_ratio = (n + 2 + sqrt(5 n^2 + 4 n + 4))/(2 n), the c with c - 1/c = 1 + 2/n,
        alpha_gain_ratio: Lambda/L at e = (s + n - 1)/2, s = sqrt(5 n^2 + 10 n + 1),
        beta_gain_ratio: at e = (u + 2 n + 1)/2, u = sqrt(4 n^2 + 8 n + 1);
        n = L (1 + sqrt(1 + 8/L))/4, Lambda = 2 e^2/(1 + e).
        Below L the update is always nearer than the gains of L

    nominal_index: nominal index L, at which the gains are exact; a number at least 1e-12 and at
        most 1e12, in float32 at least 1e-5 and at most 1e5.

    alpha_one_ratio: Lambda/L beyond which the position gain exceeds 1. Relative error at most 3.01
        * 2^-52 (float64), 3.00 * 2^-23 (float32), proved for 1e-12 <= nominal_index <=
        1000000000000.0 (float64) and 1e-05 <= nominal_index <= 100000.0 (float32).
    unstable_ratio: Lambda/L from which on the filter is not stable. Relative error at most 3.01 *
        2^-52 (float64), 3.00 * 2^-23 (float32), proved for 1e-12 <= nominal_index <=
        1000000000000.0 (float64) and 1e-05 <= nominal_index <= 100000.0 (float32).
    variance_ratio: Lambda/L up to which the update lowers all variances, over those of L. Relative
        error at most 4.13 * 2^-52 (float64), 4.13 * 2^-23 (float32), proved for 1e-12 <=
        nominal_index <= 1000000000000.0 (float64) and 1e-05 <= nominal_index <= 100000.0 (float32).
    alpha_gain_ratio: Lambda/L beyond which alpha is farther from the exact one than that of L.
        Relative error at most 8.36 * 2^-52 (float64), 8.36 * 2^-23 (float32), proved for 1e-12 <=
        nominal_index <= 1000000000000.0 (float64) and 1e-05 <= nominal_index <= 100000.0 (float32).
    beta_gain_ratio: Lambda/L beyond which beta is farther from the exact one than that of L.
        Relative error at most 11.58 * 2^-52 (float64), 11.54 * 2^-23 (float32), proved for 1e-12 <=
        nominal_index <= 1000000000000.0 (float64) and 1e-05 <= nominal_index <= 100000.0 (float32).

    Outside an output's range, a few numbers next to its ends apart, its true value is no normal
    number: it comes as 0, a subnormal number or infinity, never as NaN. Numbers and arrays are
    taken, arrays of any shape; inputs are broadcast. float64 and float32 stay what they are,
    integers become float64. `out`: a tuple of arrays to fill. `workers`: threads that share the
    work on long arrays.

    ValueError: an input outside its domain, with its place; `out` or `workers` that does not fit.
    TypeError: an input that is no real number of these types; in `out` what is no array of the
    results' type.

    Source: derivation updated-gains
    """
    if (
        type(nominal_index) is float
        and 1e-12 <= nominal_index <= 1000000000000.0
        and out is None
        and workers is ONE
    ):
        try:
            return named(UpdateLimits, _update_limits_of_numbers(nominal_index))
        except (ArithmeticError, ValueError):
            pass  # arrays say what is wrong
    return UpdateLimits(*evaluate(_UPDATE_LIMITS, (nominal_index,), out, workers))


def _update_limits_of_numbers(nominal_index: float, form: Form = Double) -> tuple[float, ...]:
    t5 = form.sqrt((8.0 / nominal_index) + 1.0)
    t9 = (nominal_index * (t5 + 1.0)) * 0.25
    t10 = 1.0 / t9
    t12 = t9 * 5.0
    t14 = t12 + 10.0
    t17 = form.sqrt((t14 * t9) + 1.0)
    t22 = form.sqrt((((t9 * 4.0) + 8.0) * t9) + 1.0)
    t31 = ((t14 / (t17 + 1.0)) + 1.0) * 0.5
    t34 = (t9 + 1.0) * 2.0
    t42 = (((t22 + 1.0) * t10) * 0.5) + 1.0
    t54 = form.sqrt(((t12 + 4.0) * t9) + 4.0) + t9
    t38 = (t31 * t31) * (t34 / ((t17 + t9) + 1.0))
    t49 = (t42 * t42) * (t34 / ((t22 + 3.0) + (t9 * 2.0)))
    t51 = t10 + 1.5
    t53 = (t10 * 2.0) + 2.0
    t57 = (t54 + 2.0) * (t10 * 0.5)
    return (t51, t53, t57, t38, t49)


def _update_limits_block(
    given: Arrays,
    out: Arrays,
    work: Arrays,
    _single: bool,
    n0: float = 8.0,
    n1: float = 1.0,
    n2: float = 0.25,
    n3: float = 5.0,
    n4: float = 10.0,
    n5: float = 4.0,
    n6: float = 0.5,
    n7: float = 2.0,
    n8: float = 3.0,
    n9: float = 1.5,
) -> None:
    (nominal_index,) = given
    alpha_one_ratio, unstable_ratio, variance_ratio, alpha_gain_ratio, beta_gain_ratio = out
    w0, w1, w2, w3, w4 = work
    t2 = divide(n0, nominal_index, alpha_gain_ratio)
    t4 = add(t2, n1, alpha_gain_ratio)
    nominal_root = sqrt(t4, beta_gain_ratio)
    t6 = add(nominal_root, n1, beta_gain_ratio)
    t7 = multiply(nominal_index, t6, beta_gain_ratio)
    t9 = multiply(t7, n2, beta_gain_ratio)
    t10 = divide(n1, t9, alpha_one_ratio)
    t12 = multiply(t9, n3, alpha_gain_ratio)
    t14 = add(t12, n4, w0)
    t15 = multiply(t14, t9, w1)
    t16 = add(t15, n1, w1)
    s = sqrt(t16, unstable_ratio)
    t18 = multiply(t9, n5, w1)
    t19 = add(t18, n0, w1)
    t20 = multiply(t19, t9, w1)
    t21 = add(t20, n1, w1)
    u = sqrt(t21, variance_ratio)
    t23 = add(t12, n5, alpha_gain_ratio)
    t24 = multiply(t23, t9, alpha_gain_ratio)
    t25 = add(t24, n5, alpha_gain_ratio)
    v = sqrt(t25, alpha_gain_ratio)
    t27 = add(s, n1, w1)
    t28 = divide(t14, t27, w0)
    t29 = add(t28, n1, w0)
    t31 = multiply(t29, n6, w0)
    t32 = square(t31, w0)
    t33 = add(t9, n1, w1)
    t34 = multiply(t33, n7, w1)
    t35 = add(s, t9, unstable_ratio)
    t36 = add(t35, n1, unstable_ratio)
    t37 = divide(t34, t36, unstable_ratio)
    t39 = add(u, n1, w2)
    t40 = multiply(t39, t10, w2)
    t41 = multiply(t40, n6, w2)
    t42 = add(t41, n1, w2)
    t43 = square(t42, w2)
    t45 = add(u, n8, variance_ratio)
    t46 = multiply(t9, n7, w3)
    t47 = add(t45, t46, variance_ratio)
    t48 = divide(t34, t47, w1)
    t52 = multiply(t10, n7, w3)
    t54 = add(v, t9, alpha_gain_ratio)
    t55 = add(t54, n7, variance_ratio)
    t56 = multiply(t10, n6, w4)
    multiply(t32, t37, alpha_gain_ratio)
    multiply(t43, t48, beta_gain_ratio)
    add(t10, n9, alpha_one_ratio)
    add(t52, n7, unstable_ratio)
    multiply(t55, t56, variance_ratio)


_UPDATE_LIMITS = Signature(
    "update_limits",
    (_NOMINAL_INDEX_DOMAIN,),
    ("alpha_one_ratio", "unstable_ratio", "variance_ratio", "alpha_gain_ratio", "beta_gain_ratio"),
    5,
    _update_limits_block,
    numbers=_update_limits_of_numbers,
)


class FirstOrderErrors(NamedTuple):
    """Result of `first_order_errors`."""

    alpha_excess_over_square: Real
    """First-order position gain less the exact one, over (Lambda - L)^2."""
    beta_excess_over_square: Real
    """First-order velocity gain times T less the exact one, over (Lambda - L)^2."""


def first_order_errors(
    nominal_index: ArrayLike,
    tracking_index: ArrayLike,
    *,
    out: tuple[Real, Real] | None = None,
    workers: int = 1,
) -> FirstOrderErrors:
    """By how much first-order gains are too large.

        Gains of `first_order_gains` less the exact ones, over the square of the step: with
        n = L (1 + sqrt(1 + 8/L))/4, e the same of Lambda, b = 2 (n + e + n e):
        alpha: (2 (1 + n) (1 + e) + n (2 + n))/(n (2 + n) b^2),
        beta: 2 (n + 2 e + 2 n e)/((2 + n) b^2). Never negative

    nominal_index: nominal index L, at which the gains are exact; a number at least 1e-12 and at
        most 1e12, in float32 at least 1e-5 and at most 1e5.
    tracking_index: tracking index Lambda; a number at least 1e-12 and at most 1e12, in float32 at
        least 1e-5 and at most 1e5.

    alpha_excess_over_square: first-order position gain less the exact one, over (Lambda - L)^2.
        Relative error at most 12.62 * 2^-52 (float64), 12.57 * 2^-23 (float32), proved for every
        input.
    beta_excess_over_square: first-order velocity gain times T less the exact one, over (Lambda -
        L)^2. Relative error at most 8.72 * 2^-52 (float64), 8.72 * 2^-23 (float32), proved for
        every input.

    Every true value that an error is relative to is a normal number. Numbers and arrays are taken,
    arrays of any shapes that broadcast. Where all inputs are float32 so are the results; otherwise
    everything becomes float64, integers too. `out`: a tuple of arrays to fill. `workers`: threads
    that share the work on long arrays.

    ValueError: an input outside its domain, with its place; `out` or `workers` that does not fit.
    TypeError: an input that is no real number of these types; in `out` what is no array of the
    results' type.

    Source: derivation updated-gains
    """
    if (
        type(nominal_index) is float
        and type(tracking_index) is float
        and 1e-12 <= nominal_index <= 1000000000000.0
        and 1e-12 <= tracking_index <= 1000000000000.0
        and out is None
        and workers is ONE
    ):
        try:
            return named(
                FirstOrderErrors, _first_order_errors_of_numbers(nominal_index, tracking_index)
            )
        except (ArithmeticError, ValueError):
            pass  # arrays say what is wrong
    return FirstOrderErrors(
        *evaluate(_FIRST_ORDER_ERRORS, (nominal_index, tracking_index), out, workers)
    )


def _first_order_errors_of_numbers(
    nominal_index: float,
    tracking_index: float,
    form: Form = Double,
) -> tuple[float, ...]:
    t6 = form.sqrt((8.0 / nominal_index) + 1.0)
    t10 = (nominal_index * (t6 + 1.0)) * 0.25
    t13 = form.sqrt((8.0 / tracking_index) + 1.0)
    t16 = (tracking_index * (t13 + 1.0)) * 0.25
    t18 = t10 * t16
    t21 = ((t10 + t16) + t18) * 2.0
    t26 = t10 + 2.0
    t27 = t10 * t26
    t28 = (((t10 + 1.0) * (t16 + 1.0)) * 2.0) + t27
    t34 = ((((t18 + t16) * 2.0) + t10) * 2.0) / t26
    t36 = ((t28 / t27) / t21) / t21
    t38 = (t34 / t21) / t21
    return (t36, t38)


def _first_order_errors_block(
    given: Arrays,
    out: Arrays,
    work: Arrays,
    _single: bool,
    n0: float = 8.0,
    n1: float = 1.0,
    n2: float = 0.25,
    n3: float = 2.0,
) -> None:
    nominal_index, tracking_index = given
    alpha_excess_over_square, beta_excess_over_square = out
    w0, w1, w2, w3, w4 = work
    t3 = divide(n0, nominal_index, alpha_excess_over_square)
    t5 = add(t3, n1, alpha_excess_over_square)
    nominal_root = sqrt(t5, beta_excess_over_square)
    t7 = add(nominal_root, n1, beta_excess_over_square)
    t8 = multiply(nominal_index, t7, beta_excess_over_square)
    t10 = multiply(t8, n2, beta_excess_over_square)
    t11 = divide(n0, tracking_index, alpha_excess_over_square)
    t12 = add(t11, n1, alpha_excess_over_square)
    root = sqrt(t12, alpha_excess_over_square)
    t14 = add(root, n1, alpha_excess_over_square)
    t15 = multiply(tracking_index, t14, alpha_excess_over_square)
    t16 = multiply(t15, n2, alpha_excess_over_square)
    t17 = add(t10, t16, w0)
    t18 = multiply(t10, t16, w1)
    t19 = add(t17, t18, w0)
    t21 = multiply(t19, n3, w0)
    t22 = add(t10, n1, w2)
    t23 = add(t16, n1, w3)
    t24 = multiply(t22, t23, w2)
    t25 = multiply(t24, n3, w2)
    t26 = add(t10, n3, w3)
    t27 = multiply(t10, t26, w4)
    t28 = add(t25, t27, w2)
    t29 = divide(t28, t27, w2)
    t30 = add(t18, t16, w1)
    t31 = multiply(t30, n3, w1)
    t32 = add(t31, t10, w1)
    t33 = multiply(t32, n3, w1)
    t34 = divide(t33, t26, w1)
    t35 = divide(t29, t21, w2)
    t37 = divide(t34, t21, w1)
    divide(t35, t21, alpha_excess_over_square)
    divide(t37, t21, beta_excess_over_square)


_FIRST_ORDER_ERRORS = Signature(
    "first_order_errors",
    (_NOMINAL_INDEX_DOMAIN, _TRACKING_INDEX_DOMAIN),
    ("alpha_excess_over_square", "beta_excess_over_square"),
    5,
    _first_order_errors_block,
    numbers=_first_order_errors_of_numbers,
)


class CycleDrift(NamedTuple):
    """Result of `cycle_drift`."""

    alpha_drift_over_square: Real
    """What the cycle adds to the position gain, over (Lambda - L)^2."""
    beta_drift_over_square: Real
    """What the cycle adds to the velocity gain times T, over (Lambda - L)^2."""


def cycle_drift(
    nominal_index: ArrayLike,
    tracking_index: ArrayLike,
    *,
    out: tuple[Real, Real] | None = None,
    workers: int = 1,
) -> CycleDrift:
    """What recursive updates add to gains from L to Lambda and back.

        (alpha'(L) - alpha'(Lambda)) (Lambda - L) and its like of beta, over the square of the
        step: with n = L (1 + sqrt(1 + 8/L))/4, e the same of Lambda, b = 2 (n + e + n e):
        alpha: (n^2 + n e + e^2 + 3 n + 3 e + 2)/(n (2 + n) e (2 + e) b),
        beta: 2 (n + e + 3)/((2 + n) (2 + e) b). Never negative, and the same every cycle

    nominal_index: nominal index L, at which the gains are exact; a number at least 1e-12 and at
        most 1e12, in float32 at least 1e-5 and at most 1e5.
    tracking_index: tracking index Lambda; a number at least 1e-12 and at most 1e12, in float32 at
        least 1e-5 and at most 1e5.

    alpha_drift_over_square: what the cycle adds to the position gain, over (Lambda - L)^2. Relative
        error at most 13.29 * 2^-52 (float64), 13.08 * 2^-23 (float32), proved for every input.
    beta_drift_over_square: what the cycle adds to the velocity gain times T, over (Lambda - L)^2.
        Relative error at most 9.32 * 2^-52 (float64), 9.20 * 2^-23 (float32), proved for every
        input.

    Every true value that an error is relative to is a normal number. Numbers and arrays are taken,
    arrays of any shapes that broadcast. Where all inputs are float32 so are the results; otherwise
    everything becomes float64, integers too. `out`: a tuple of arrays to fill. `workers`: threads
    that share the work on long arrays.

    ValueError: an input outside its domain, with its place; `out` or `workers` that does not fit.
    TypeError: an input that is no real number of these types; in `out` what is no array of the
    results' type.

    Source: derivation updated-gains
    """
    if (
        type(nominal_index) is float
        and type(tracking_index) is float
        and 1e-12 <= nominal_index <= 1000000000000.0
        and 1e-12 <= tracking_index <= 1000000000000.0
        and out is None
        and workers is ONE
    ):
        try:
            return named(CycleDrift, _cycle_drift_of_numbers(nominal_index, tracking_index))
        except (ArithmeticError, ValueError):
            pass  # arrays say what is wrong
    return CycleDrift(*evaluate(_CYCLE_DRIFT, (nominal_index, tracking_index), out, workers))


def _cycle_drift_of_numbers(
    nominal_index: float,
    tracking_index: float,
    form: Form = Double,
) -> tuple[float, ...]:
    t6 = form.sqrt((8.0 / nominal_index) + 1.0)
    t10 = (nominal_index * (t6 + 1.0)) * 0.25
    t13 = form.sqrt((8.0 / tracking_index) + 1.0)
    t16 = (tracking_index * (t13 + 1.0)) * 0.25
    t17 = t10 + t16
    t18 = t10 * t16
    t21 = (t17 + t18) * 2.0
    t28 = (((t10 * t10) + t18) + (t16 * t16)) + (t17 * 3.0)
    t30 = t10 + 2.0
    t33 = t16 + 2.0
    t36 = ((t28 + 2.0) / (t10 * t30)) * (1.0 / (t16 * t33))
    t41 = t36 / t21
    t42 = (((t17 + 3.0) / t30) * (2.0 / t33)) / t21
    return (t41, t42)


def _cycle_drift_block(
    given: Arrays,
    out: Arrays,
    work: Arrays,
    _single: bool,
    n0: float = 8.0,
    n1: float = 1.0,
    n2: float = 0.25,
    n3: float = 2.0,
    n4: float = 3.0,
) -> None:
    nominal_index, tracking_index = given
    alpha_drift_over_square, beta_drift_over_square = out
    w0, w1, w2, w3 = work
    t3 = divide(n0, nominal_index, alpha_drift_over_square)
    t5 = add(t3, n1, alpha_drift_over_square)
    nominal_root = sqrt(t5, beta_drift_over_square)
    t7 = add(nominal_root, n1, beta_drift_over_square)
    t8 = multiply(nominal_index, t7, beta_drift_over_square)
    t10 = multiply(t8, n2, beta_drift_over_square)
    t11 = divide(n0, tracking_index, alpha_drift_over_square)
    t12 = add(t11, n1, alpha_drift_over_square)
    root = sqrt(t12, alpha_drift_over_square)
    t14 = add(root, n1, alpha_drift_over_square)
    t15 = multiply(tracking_index, t14, alpha_drift_over_square)
    t16 = multiply(t15, n2, alpha_drift_over_square)
    t17 = add(t10, t16, w0)
    t18 = multiply(t10, t16, w1)
    t19 = add(t17, t18, w2)
    t21 = multiply(t19, n3, w2)
    t22 = square(t10, w3)
    t23 = add(t22, t18, w3)
    t24 = square(t16, w1)
    t25 = add(t23, t24, w3)
    t27 = multiply(t17, n4, w1)
    t28 = add(t25, t27, w3)
    t29 = add(t28, n3, w3)
    t30 = add(t10, n3, w1)
    t31 = multiply(t10, t30, beta_drift_over_square)
    t32 = divide(t29, t31, w3)
    t33 = add(t16, n3, beta_drift_over_square)
    t34 = multiply(t16, t33, alpha_drift_over_square)
    t35 = divide(n1, t34, alpha_drift_over_square)
    t36 = multiply(t32, t35, w3)
    t37 = add(t17, n4, w0)
    t38 = divide(t37, t30, w0)
    t39 = divide(n3, t33, beta_drift_over_square)
    t40 = multiply(t38, t39, w0)
    divide(t36, t21, alpha_drift_over_square)
    divide(t40, t21, beta_drift_over_square)


_CYCLE_DRIFT = Signature(
    "cycle_drift",
    (_NOMINAL_INDEX_DOMAIN, _TRACKING_INDEX_DOMAIN),
    ("alpha_drift_over_square", "beta_drift_over_square"),
    4,
    _cycle_drift_block,
    numbers=_cycle_drift_of_numbers,
)


class MismatchVariances(NamedTuple):
    """Result of `mismatch_variances`."""

    predicted_11: Real
    """Variance of the predicted position over sigma_v^2."""
    updated_11: Real
    """Variance of the updated position over sigma_v^2."""
    updated_22: Real
    """Variance of the updated velocity times T^2/sigma_v^2."""
    predicted_22: Real
    """Variance of the predicted velocity times T^2/sigma_v^2."""
    predicted_11_ratio: Real
    """Variance of the predicted position over the least one, at least 1."""
    updated_11_ratio: Real
    """Variance of the updated position over the least one, at least 1."""
    updated_22_ratio: Real
    """Variance of the updated velocity over the least one, at least 1."""
    predicted_22_ratio: Real
    """Variance of the predicted velocity over the least one, at least 1."""


def mismatch_variances(
    nominal_index: ArrayLike,
    tracking_index: ArrayLike,
    *,
    out: tuple[Real, Real, Real, Real, Real, Real, Real, Real] | None = None,
    workers: int = 1,
) -> MismatchVariances:
    """Steady variances with the gains of a nominal index.

        n = L (1 + sqrt(1 + 8/L))/4, e the same of Lambda, c = Lambda/L:
        predicted_11 = n (2 n + 3 + c^2 (1 + n)^2)/(2 + n),
        updated_11 = n ((3 + n) (1 + n) + c^2)/((1 + n)^2 (2 + n)),
        updated_22 = 2 n^3 (1 + n + c^2 (3 + n))/((1 + n)^2 (2 + n)),
        predicted_22 = updated_22 + Lambda^2; terms without c are the measurement's noise.
        The least variances are those of the gains of Lambda

    nominal_index: nominal index L, at which the gains are exact; a number at least 1e-12 and at
        most 1e12, in float32 at least 1e-5 and at most 1e5.
    tracking_index: tracking index Lambda; a number at least 1e-12 and at most 1e12, in float32 at
        least 1e-5 and at most 1e5.

    predicted_11: variance of the predicted position over sigma_v^2. Relative error at most 8.63 *
        2^-52 (float64), 8.55 * 2^-23 (float32), proved for every input.
    updated_11: variance of the updated position over sigma_v^2. Relative error at most 8.33 * 2^-52
        (float64), 8.20 * 2^-23 (float32), proved for every input.
    updated_22: variance of the updated velocity times T^2/sigma_v^2. Relative error at most 13.52 *
        2^-52 (float64), 13.50 * 2^-23 (float32), proved for every input.
    predicted_22: variance of the predicted velocity times T^2/sigma_v^2. Relative error at most
        14.02 * 2^-52 (float64), 13.96 * 2^-23 (float32), proved for every input.
    predicted_11_ratio: variance of the predicted position over the least one, at least 1. Relative
        error at most 12.88 * 2^-52 (float64), 12.80 * 2^-23 (float32), proved for every input.
    updated_11_ratio: variance of the updated position over the least one, at least 1. Relative
        error at most 13.06 * 2^-52 (float64), 13.02 * 2^-23 (float32), proved for every input.
    updated_22_ratio: variance of the updated velocity over the least one, at least 1. Relative
        error at most 23.01 * 2^-52 (float64), 22.95 * 2^-23 (float32), proved for every input.
    predicted_22_ratio: variance of the predicted velocity over the least one, at least 1. Relative
        error at most 22.53 * 2^-52 (float64), 22.43 * 2^-23 (float32), proved for every input.

    Every true value that an error is relative to is a normal number. Numbers and arrays are taken,
    arrays of any shapes that broadcast. Where all inputs are float32 so are the results; otherwise
    everything becomes float64, integers too. `out`: a tuple of arrays to fill. `workers`: threads
    that share the work on long arrays.

    ValueError: an input outside its domain, with its place; `out` or `workers` that does not fit.
    TypeError: an input that is no real number of these types; in `out` what is no array of the
    results' type.

    Source: derivation updated-gains
    """
    if (
        type(nominal_index) is float
        and type(tracking_index) is float
        and 1e-12 <= nominal_index <= 1000000000000.0
        and 1e-12 <= tracking_index <= 1000000000000.0
        and out is None
        and workers is ONE
    ):
        try:
            return named(
                MismatchVariances, _mismatch_variances_of_numbers(nominal_index, tracking_index)
            )
        except (ArithmeticError, ValueError):
            pass  # arrays say what is wrong
    return MismatchVariances(
        *evaluate(_MISMATCH_VARIANCES, (nominal_index, tracking_index), out, workers)
    )


def _mismatch_variances_of_numbers(
    nominal_index: float,
    tracking_index: float,
    form: Form = Double,
) -> tuple[float, ...]:
    t6 = form.sqrt((8.0 / nominal_index) + 1.0)
    t10 = (nominal_index * (t6 + 1.0)) * 0.25
    t13 = form.sqrt((8.0 / tracking_index) + 1.0)
    t16 = (tracking_index * (t13 + 1.0)) * 0.25
    t17 = tracking_index / nominal_index
    t18 = t17 * t17
    t19 = t10 + 1.0
    t20 = t16 + 1.0
    t23 = t10 / (t10 + 2.0)
    t24 = t23 / t19
    t30 = ((t10 * 2.0) + 3.0) + (t18 * (t19 * t19))
    t31 = t23 * t30
    t32 = t10 + 3.0
    t35 = t24 * (t32 + (t18 / t19))
    t42 = (t24 * ((t10 * t10) * 2.0)) * ((t18 * (t32 / t19)) + 1.0)
    t43 = t16 + 2.0
    t45 = t16 / t20
    t52 = t42 + (tracking_index * tracking_index)
    t56 = t31 / (t16 * t43)
    t57 = t35 / (t45 * (t43 / t20))
    t58 = t42 / ((t45 * t45) * (t16 * 4.0))
    t59 = t52 / (((t16 * t16) * t45) * 4.0)
    return (t31, t35, t42, t52, t56, t57, t58, t59)


def _mismatch_variances_block(
    given: Arrays,
    out: Arrays,
    work: Arrays,
    _single: bool,
    n0: float = 8.0,
    n1: float = 1.0,
    n2: float = 0.25,
    n3: float = 2.0,
    n4: float = 3.0,
    n5: float = 4.0,
) -> None:
    nominal_index, tracking_index = given
    (
        predicted_11,
        updated_11,
        updated_22,
        predicted_22,
        predicted_11_ratio,
        updated_11_ratio,
        updated_22_ratio,
        predicted_22_ratio,
    ) = out
    w0, w1 = work
    t3 = divide(n0, nominal_index, predicted_11)
    t5 = add(t3, n1, predicted_11)
    nominal_root = sqrt(t5, updated_11)
    t7 = add(nominal_root, n1, updated_11)
    t8 = multiply(nominal_index, t7, updated_11)
    t10 = multiply(t8, n2, w0)
    t11 = divide(n0, tracking_index, updated_22)
    t12 = add(t11, n1, updated_22)
    root = sqrt(t12, predicted_22)
    t14 = add(root, n1, predicted_22)
    t15 = multiply(tracking_index, t14, predicted_22)
    t16 = multiply(t15, n2, w1)
    t17 = divide(tracking_index, nominal_index, predicted_11_ratio)
    t18 = square(t17, predicted_11_ratio)
    t19 = add(t10, n1, updated_22)
    t20 = add(t16, n1, predicted_22)
    t22 = add(t10, n3, predicted_11)
    t23 = divide(t10, t22, updated_11_ratio)
    t24 = divide(t23, t19, updated_22_ratio)
    t25 = multiply(t10, n3, predicted_11)
    t27 = add(t25, n4, predicted_11)
    t28 = square(t19, updated_11)
    t29 = multiply(t18, t28, updated_11)
    t30 = add(t27, t29, predicted_11)
    multiply(t23, t30, predicted_11)
    t32 = add(t10, n4, updated_11_ratio)
    t33 = divide(t18, t19, predicted_22_ratio)
    t34 = add(t32, t33, predicted_22_ratio)
    multiply(t24, t34, updated_11)
    t36 = square(t10, w0)
    t37 = multiply(t36, n3, w0)
    t38 = multiply(t24, t37, updated_22_ratio)
    t39 = divide(t32, t19, updated_11_ratio)
    t40 = multiply(t18, t39, predicted_11_ratio)
    t41 = add(t40, n1, predicted_11_ratio)
    multiply(t38, t41, updated_22)
    t43 = add(t16, n3, w0)
    t44 = multiply(t16, t43, predicted_11_ratio)
    t45 = divide(t16, t20, updated_11_ratio)
    t46 = divide(t43, t20, w0)
    t47 = multiply(t45, t46, w0)
    t48 = square(t45, predicted_22)
    t49 = multiply(t16, n5, updated_22_ratio)
    t50 = multiply(t48, t49, updated_22_ratio)
    t51 = square(tracking_index, predicted_22)
    add(updated_22, t51, predicted_22)
    t53 = square(t16, w1)
    t54 = multiply(t53, t45, w1)
    t55 = multiply(t54, n5, w1)
    divide(predicted_11, t44, predicted_11_ratio)
    divide(updated_11, t47, updated_11_ratio)
    divide(updated_22, t50, updated_22_ratio)
    divide(predicted_22, t55, predicted_22_ratio)


_MISMATCH_VARIANCES = Signature(
    "mismatch_variances",
    (_NOMINAL_INDEX_DOMAIN, _TRACKING_INDEX_DOMAIN),
    (
        "predicted_11",
        "updated_11",
        "updated_22",
        "predicted_22",
        "predicted_11_ratio",
        "updated_11_ratio",
        "updated_22_ratio",
        "predicted_22_ratio",
    ),
    2,
    _mismatch_variances_block,
    numbers=_mismatch_variances_of_numbers,
)


class LineOfSightGains(NamedTuple):
    """Result of `line_of_sight_gains`."""

    gain_xx: Real
    """Gain of x by the innovation of x."""
    gain_xy: Real
    """Gain of x by the innovation of y, and of y by that of x."""
    gain_yy: Real
    """Gain of y by the innovation of y."""


def line_of_sight_gains(
    along: ArrayLike,
    across: ArrayLike,
    cosine: ArrayLike,
    sine: ArrayLike,
    *,
    out: tuple[Real, Real, Real] | None = None,
    workers: int = 1,
) -> LineOfSightGains:
    """Gains along and across the line of sight, turned into x and y.

        gain_xx = along cosine^2 + across sine^2, gain_xy = (along - across) cosine sine,
        gain_yy = along sine^2 + across cosine^2: once with both alpha, once with both beta

    along: gain along the line of sight; a number at least 1e-30 and at most 1e30, in float32 at
        least 1e-9 and at most 1e9.
    across: gain across it; a number at least 1e-30 and at most 1e30, in float32 at least 1e-9 and
        at most 1e9.
    cosine: cosine of the angle from the x axis to the line of sight; of magnitude at most 2, in
        float32 2.
    sine: its sine; of magnitude at most 2, in float32 2.

    gain_xx: gain of x by the innovation of x. Relative error at most 1.51 * 2^-52 (float64), 1.51 *
        2^-23 (float32), proved for every input, and 5e-293 (float64) and 2e-35 (float32) beside it
        where a product underflows.
    gain_xy: gain of x by the innovation of y, and of y by that of x. Relative error at most 1.51 *
        2^-52 (float64), 1.51 * 2^-23 (float32), proved for every input, and 5e-293 (float64) and
        2e-35 (float32) beside it where a product underflows.
    gain_yy: gain of y by the innovation of y. Relative error at most 1.51 * 2^-52 (float64), 1.51 *
        2^-23 (float32), proved for every input, and 5e-293 (float64) and 2e-35 (float32) beside it
        where a product underflows.

    Numbers and arrays are taken, arrays of any shapes that broadcast. Where all inputs are float32
    so are the results; otherwise everything becomes float64, integers too. `out`: a tuple of arrays
    to fill. `workers`: threads that share the work on long arrays.

    ValueError: an input outside its domain, with its place; `out` or `workers` that does not fit.
    TypeError: an input that is no real number of these types; in `out` what is no array of the
    results' type.

    Source: derivation updated-gains
    """
    if (
        type(along) is float
        and type(across) is float
        and type(cosine) is float
        and type(sine) is float
        and 1e-30 <= along <= 1e30
        and 1e-30 <= across <= 1e30
        and -2.0 <= cosine <= 2.0
        and -2.0 <= sine <= 2.0
        and out is None
        and workers is ONE
    ):
        try:
            return named(
                LineOfSightGains, _line_of_sight_gains_of_numbers(along, across, cosine, sine)
            )
        except (ArithmeticError, ValueError):
            pass  # arrays say what is wrong
    return LineOfSightGains(
        *evaluate(_LINE_OF_SIGHT_GAINS, (along, across, cosine, sine), out, workers)
    )


def _line_of_sight_gains_of_numbers(
    along: float,
    across: float,
    cosine: float,
    sine: float,
    _form: Form = Double,
) -> tuple[float, ...]:
    t4 = cosine * cosine
    t5 = sine * sine
    t8 = (along * t4) + (across * t5)
    t11 = (along - across) * (cosine * sine)
    t14 = (along * t5) + (across * t4)
    return (t8, t11, t14)


def _line_of_sight_gains_block(given: Arrays, out: Arrays, work: Arrays, _single: bool) -> None:
    along, across, cosine, sine = given
    gain_xx, gain_xy, gain_yy = out
    w0, w1, w2, w3, w4, w5 = work
    t4 = square(cosine, w0)
    t5 = square(sine, w1)
    t6 = multiply(along, t4, w2)
    t7 = multiply(across, t5, w3)
    t9 = subtract(along, across, w4)
    t10 = multiply(cosine, sine, w5)
    t12 = multiply(along, t5, w1)
    t13 = multiply(across, t4, w0)
    add(t6, t7, gain_xx)
    multiply(t9, t10, gain_xy)
    add(t12, t13, gain_yy)


_LINE_OF_SIGHT_GAINS = Signature(
    "line_of_sight_gains",
    (_ALONG_DOMAIN, _ACROSS_DOMAIN, _COSINE_DOMAIN, _SINE_DOMAIN),
    ("gain_xx", "gain_xy", "gain_yy"),
    6,
    _line_of_sight_gains_block,
    numbers=_line_of_sight_gains_of_numbers,
)
