# Made by: gainproof generate wiener-acceleration
# From: gainproof derive wiener-acceleration, SymPy 1.14.0
"""Discrete Wiener process acceleration: steady state with measured position."""

from __future__ import annotations

from typing import TYPE_CHECKING

from numpy import add, divide, multiply, negative, sqrt, square, subtract

from gainproof.generated._bits import near_cbrt
from gainproof.generated._numbers import ONE, Double, filled_by, named
from gainproof.generated._runtime import evaluate
from gainproof.generated._signature import Domain, Signature

if TYPE_CHECKING:
    from typing import NamedTuple

    from gainproof.generated._double_word import Part
    from gainproof.generated._numbers import Form
    from gainproof.generated._signature import ArrayLike, Arrays, Real
else:
    from gainproof.generated._result import NamedTuple

__all__ = [
    "ClosedLoopPoles",
    "GainDerivatives",
    "GainSecondDerivatives",
    "Gains",
    "GainsFromAlpha",
    "GainsWithDerivatives",
    "IndexFromAlpha",
    "InnovationDeviation",
    "PoleProduct",
    "PredictedCovariance",
    "PredictedCovarianceDerivatives",
    "PredictedCovarianceSecondDerivatives",
    "PredictedPositionSecondDerivatives",
    "PredictorGainDerivatives",
    "PredictorGainSecondDerivatives",
    "PredictorGains",
    "UpdatedCovariance",
    "UpdatedCovarianceDerivatives",
    "UpdatedCovarianceSecondDerivatives",
    "closed_loop_poles",
    "gain_derivatives",
    "gain_second_derivatives",
    "gains",
    "gains_from_alpha",
    "gains_with_derivatives",
    "index_from_alpha",
    "innovation_deviation",
    "pole_product",
    "predicted_covariance",
    "predicted_covariance_derivatives",
    "predicted_covariance_second_derivatives",
    "predicted_position_second_derivatives",
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
_TRACKING_INDEX_DOMAIN_2 = Domain(
    "tracking_index",
    "a number above 0 and at most 2^1000, in float32 above 0 and at most 2^120",
    (5e-324, 1.0715086071862673e301),
    (1.401298464324817e-45, 1.329227995784916e36),
)
_TRACKING_INDEX_DOMAIN_3 = Domain(
    "tracking_index",
    "a number at least 2^-750 and at most 2^1000, in float32 at least 2^-80 and at most 2^120",
    (1.688508503057271e-226, 1.0715086071862673e301),
    (8.271806125530277e-25, 1.329227995784916e36),
)
_ALPHA_DOMAIN = Domain(
    "alpha",
    "a number at least 2^-330 and below 1, in float32 at least 2^-40 and below 1",
    (4.5719495651291e-100, 0.9999999999999999),
    (9.094947017729282e-13, 0.9999999403953552),
)


class Gains(NamedTuple):
    """Result of `gains`."""

    alpha: Real
    """Position gain."""
    beta: Real
    """Velocity gain times the sampling interval."""
    gamma: Real
    """Acceleration gain times the square of the sampling interval."""


def gains(
    tracking_index: ArrayLike,
    *,
    out: tuple[Real, Real, Real] | None = None,
    workers: int = 1,
    accurate: bool = False,
) -> Gains:
    """Steady-state filter gain.

        alpha = 2 (1 + eta)/nu, beta = 4 xi/nu, gamma = 8/nu,
        delta = 8/Lambda,
        xi = sqrt(2 + 2 eta), eta = sqrt(1 + 2 delta xi), nu = 1 + xi + eta + delta

    tracking_index: Lambda, with Lambda^2 =
        increment_deviation**2*sampling_interval**4/measurement_deviation**2; a number above 0 and
        finite.

    alpha: position gain. Relative error at most 6.18 * 2^-52 (float64), 6.18 * 2^-23 (float32),
        proved for 5e-324 <= tracking_index <= 1.7976931348623157e308 (float64) and 1e-45 <=
        tracking_index <= 3.4028235e38 (float32).
    beta: velocity gain times the sampling interval. Relative error at most 6.09 * 2^-52 (float64),
        6.09 * 2^-23 (float32), proved for 5e-324 <= tracking_index <= 1.7976931348623157e308
        (float64) and 1e-45 <= tracking_index <= 3.4028235e38 (float32).
    gamma: acceleration gain times the square of the sampling interval. Relative error at most 4.55
        * 2^-52 (float64), 4.55 * 2^-23 (float32), proved for 2.2250738585072014e-308 <=
        tracking_index <= 1.7976931348623157e308 (float64) and 1.1754945e-38 <= tracking_index <=
        3.4028235e38 (float32).

    Outside an output's range, a few numbers next to its ends apart, its true value is no normal
    number: it comes as 0, a subnormal number or infinity, never as NaN. Numbers and arrays are
    taken, arrays of any shape; inputs are broadcast. float64 and float32 stay what they are,
    integers become float64. `out`: a tuple of arrays to fill. `workers`: threads that share the
    work on long arrays.

    `accurate`: in double-words, tracking_index at least 2^-400 and at most 2^400: proved to be off
    by at most 0.5 + 2^-38 units in the last place (float64), 0.5 + 2^-25 (float32), where the true
    value is a normal number; takes 12 to 20 times as long, in float32 3 times.

    ValueError: an input outside its domain, with its place; `out` or `workers` that does not fit.
    TypeError: an input that is no real number of these types; in `out` what is no array of the
    results' type.

    Source: derivation wiener-acceleration
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
    t1 = form.sqrt(tracking_index)
    t2 = form.sqrt(t1)
    t4 = 1.0 / t1
    t7 = (t4 * t2) * 2.0
    t9 = t1 * 0.5
    t11 = tracking_index * 0.0625
    t17 = form.near_cbrt(((t1 * t2) * 1.0) + (8.0 / t2))
    t22 = form.sqrt((t7 * t17) + t11)
    t25 = form.sqrt((t22 * 2.0) + t9)
    t26 = t7 * 0.5
    t27 = t22 * t25
    t32 = ((t25 * t27) - (t26 * t17)) / (t27 - t26)
    t36 = form.sqrt((t7 * t32) + t11)
    t39 = form.sqrt((t36 * 2.0) + t9)
    t40 = t36 * t39
    t45 = ((t39 * t40) - (t26 * t32)) / (t40 - t26)
    t49 = form.sqrt((t7 * t45) + t11)
    t52 = form.sqrt((t49 * 2.0) + t9)
    t53 = t49 * t52
    t58 = ((t52 * t53) - (t26 * t45)) / (t53 - t26)
    t62 = form.sqrt((t7 * t58) + t11)
    t65 = form.sqrt((t62 * 2.0) + t9)
    t66 = t62 * t65
    t71 = ((t65 * t66) - (t26 * t58)) / (t66 - t26)
    t75 = form.sqrt((t7 * t71) + t11)
    t84 = form.sqrt((t75 * 2.0) + t9) * t2
    t88 = (t4 + (t75 * 0.5)) + ((t84 * 0.25) + (t1 * 0.125))
    t89 = (t75 + (t1 * 0.25)) / t88
    t90 = t84 / t88
    t91 = t1 / t88
    return (t89, t90, t91)


def _gains_block(
    given: Arrays,
    out: Arrays,
    work: Arrays,
    single: bool,
    n0: float = 1.0,
    n1: float = 2.0,
    n2: float = 0.5,
    n3: float = 0.0625,
    n4: float = 8.0,
    n5: float = 0.25,
    n6: float = 0.125,
) -> None:
    (tracking_index,) = given
    alpha, beta, gamma = out
    w0, w1, w2, w3, w4, w5, w6 = work
    p = sqrt(tracking_index, gamma)
    r = sqrt(p, alpha)
    t4 = divide(n0, p, beta)
    t5 = multiply(t4, r, w0)
    t7 = multiply(t5, n1, w0)
    t9 = multiply(p, n2, w1)
    t11 = multiply(tracking_index, n3, w2)
    t12 = multiply(p, r, w3)
    t13 = multiply(t12, n0, w3)
    t15 = divide(n4, r, w4)
    t16 = add(t13, t15, w3)
    t17 = near_cbrt(t16, w3, single)
    t20 = multiply(t7, t17, w4)
    t21 = add(t20, t11, w4)
    t22 = sqrt(t21, w4)
    t23 = multiply(t22, n1, w5)
    t24 = add(t23, t9, w5)
    t25 = sqrt(t24, w5)
    t26 = multiply(t7, n2, w6)
    t27 = multiply(t22, t25, w4)
    t28 = multiply(t25, t27, w5)
    t29 = multiply(t26, t17, w3)
    t30 = subtract(t28, t29, w5)
    t31 = subtract(t27, t26, w4)
    t32 = divide(t30, t31, w5)
    t34 = multiply(t7, t32, w3)
    t35 = add(t34, t11, w3)
    t36 = sqrt(t35, w3)
    t37 = multiply(t36, n1, w4)
    t38 = add(t37, t9, w4)
    t39 = sqrt(t38, w4)
    t40 = multiply(t36, t39, w3)
    t41 = multiply(t39, t40, w4)
    t42 = multiply(t26, t32, w5)
    t43 = subtract(t41, t42, w4)
    t44 = subtract(t40, t26, w3)
    t45 = divide(t43, t44, w4)
    t47 = multiply(t7, t45, w3)
    t48 = add(t47, t11, w3)
    t49 = sqrt(t48, w3)
    t50 = multiply(t49, n1, w5)
    t51 = add(t50, t9, w5)
    t52 = sqrt(t51, w5)
    t53 = multiply(t49, t52, w3)
    t54 = multiply(t52, t53, w5)
    t55 = multiply(t26, t45, w4)
    t56 = subtract(t54, t55, w5)
    t57 = subtract(t53, t26, w3)
    t58 = divide(t56, t57, w5)
    t60 = multiply(t7, t58, w3)
    t61 = add(t60, t11, w3)
    t62 = sqrt(t61, w3)
    t63 = multiply(t62, n1, w4)
    t64 = add(t63, t9, w4)
    t65 = sqrt(t64, w4)
    t66 = multiply(t62, t65, w3)
    t67 = multiply(t65, t66, w4)
    t68 = multiply(t26, t58, w5)
    t69 = subtract(t67, t68, w4)
    t70 = subtract(t66, t26, w3)
    t71 = divide(t69, t70, w4)
    t73 = multiply(t7, t71, w0)
    t74 = add(t73, t11, w0)
    e = sqrt(t74, w0)
    t76 = multiply(e, n1, w2)
    t77 = add(t76, t9, w2)
    x = sqrt(t77, w2)
    t80 = multiply(p, n5, w1)
    t81 = add(e, t80, w1)
    t82 = multiply(e, n2, w0)
    t83 = add(t4, t82, beta)
    t84 = multiply(x, r, w2)
    t85 = multiply(t84, n5, w0)
    t86 = multiply(p, n6, w3)
    t87 = add(t85, t86, w0)
    t88 = add(t83, t87, w0)
    divide(t81, t88, alpha)
    divide(t84, t88, beta)
    divide(p, t88, gamma)


_GAINS = Signature(
    "gains",
    (_TRACKING_INDEX_DOMAIN,),
    ("alpha", "beta", "gamma"),
    7,
    _gains_block,
    numbers=_gains_of_numbers,
)


def _gains_in_double_words(given: Part, form: Form = Double) -> tuple[Part, ...]:
    # loaded when it is asked for
    from gainproof.generated._double_word import add, divide, exact, multiply, refined, root, scale

    if form.single:
        # float64 keeps 29 bits more than come out
        return evaluate(_GAINS, exact(given)[:1], None, 1)
    tracking_index = exact(given)
    delta = divide((8.0, 0.0), tracking_index)
    # what the plain kernel gives is near the root
    near = evaluate(_GAINS, exact(given)[:1], None, 1)
    near_xi = exact(2.0 * near[1] / near[2])
    t4 = multiply(delta, near_xi)
    t6 = scale(t4, 2.0)
    t8 = add(t6, (1.0, 0.0))
    near_eta = root(t8)
    t10 = scale(near_eta, 2.0)
    t11 = add(t10, (2.0, 0.0))
    image = root(t11)
    t13 = multiply(near_xi, near_eta)
    t14 = divide(delta, t13)
    xi = refined(near_xi, image, t14)
    t16 = multiply(delta, xi)
    t17 = scale(t16, 2.0)
    t18 = add(t17, (1.0, 0.0))
    eta = root(t18)
    t20 = add(xi, eta)
    t21 = add(t20, (1.0, 0.0))
    nu = add(delta, t21)
    t23 = add(eta, (1.0, 0.0))
    t24 = scale(t23, 2.0)
    t25 = divide(t24, nu)
    t27 = scale(xi, 4.0)
    t28 = divide(t27, nu)
    t29 = divide((8.0, 0.0), nu)
    return (t25[0], t28[0], t29[0])


_ACCURATE_GAINS = Signature(
    "gains",
    (_ACCURATE_TRACKING_INDEX_DOMAIN,),
    ("alpha", "beta", "gamma"),
    0,
    filled_by(_gains_in_double_words),
    numbers=_gains_in_double_words,
)


class GainDerivatives(NamedTuple):
    """Result of `gain_derivatives`."""

    alpha: Real
    """Derivative of the position gain."""
    beta: Real
    """Derivative of the velocity gain times the sampling interval."""
    gamma: Real
    """Derivative of the acceleration gain times the square of the sampling interval."""


def gain_derivatives(
    tracking_index: ArrayLike, *, out: tuple[Real, Real, Real] | None = None, workers: int = 1
) -> GainDerivatives:
    """First derivatives of the filter gain with respect to the tracking index.

        delta = 8/Lambda,
        xi = sqrt(2 + 2 eta), eta = sqrt(1 + 2 delta xi), nu = 1 + xi + eta + delta

    tracking_index: Lambda, with Lambda^2 =
        increment_deviation**2*sampling_interval**4/measurement_deviation**2; a number above 0 and
        finite.

    alpha: derivative of the position gain. Relative error at most 14.69 * 2^-52 (float64), 14.69 *
        2^-23 (float32), proved for 5e-324 <= tracking_index <= 7.11074631974658e102 (float64) and
        1e-45 <= tracking_index <= 8.7960925e12 (float32).
    beta: derivative of the velocity gain times the sampling interval. Relative error at most 14.26
        * 2^-52 (float64), 14.25 * 2^-23 (float32), proved for 5e-324 <= tracking_index <=
        1.8961503816218352e154 (float64) and 1e-45 <= tracking_index <= 2.6087635e19 (float32).
    gamma: derivative of the acceleration gain times the square of the sampling interval. Relative
        error at most 12.43 * 2^-52 (float64), 12.42 * 2^-23 (float32), proved for 5e-324 <=
        tracking_index <= 2.6815615859885194e154 (float64) and 1e-45 <= tracking_index <=
        3.689349e19 (float32).

    Outside an output's range, a few numbers next to its ends apart, its true value is no normal
    number: it comes as 0, a subnormal number or infinity, never as NaN. Numbers and arrays are
    taken, arrays of any shape; inputs are broadcast. float64 and float32 stay what they are,
    integers become float64. `out`: a tuple of arrays to fill. `workers`: threads that share the
    work on long arrays.

    ValueError: an input outside its domain, with its place; `out` or `workers` that does not fit.
    TypeError: an input that is no real number of these types; in `out` what is no array of the
    results' type.

    Source: derivation wiener-acceleration
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
    t2 = form.sqrt(t1)
    t4 = 1.0 / t1
    t7 = (t4 * t2) * 2.0
    t9 = t1 * 0.5
    t11 = tracking_index * 0.0625
    t17 = form.near_cbrt(((t1 * t2) * 1.0) + (8.0 / t2))
    t22 = form.sqrt((t7 * t17) + t11)
    t25 = form.sqrt((t22 * 2.0) + t9)
    t26 = t7 * 0.5
    t27 = t22 * t25
    t32 = ((t25 * t27) - (t26 * t17)) / (t27 - t26)
    t36 = form.sqrt((t7 * t32) + t11)
    t39 = form.sqrt((t36 * 2.0) + t9)
    t40 = t36 * t39
    t45 = ((t39 * t40) - (t26 * t32)) / (t40 - t26)
    t49 = form.sqrt((t7 * t45) + t11)
    t52 = form.sqrt((t49 * 2.0) + t9)
    t53 = t49 * t52
    t58 = ((t52 * t53) - (t26 * t45)) / (t53 - t26)
    t62 = form.sqrt((t7 * t58) + t11)
    t65 = form.sqrt((t62 * 2.0) + t9)
    t66 = t62 * t65
    t71 = ((t65 * t66) - (t26 * t58)) / (t66 - t26)
    t75 = form.sqrt((t7 * t71) + t11)
    t78 = form.sqrt((t75 * 2.0) + t9)
    t81 = t75 + (t1 * 0.25)
    t82 = t78 * t2
    t83 = t75 * t75
    t86 = t1 * t75
    t90 = tracking_index * 0.015625
    t91 = ((t83 * 0.75) + (t86 * 0.25)) + t90
    t93 = t82 * 0.25
    t96 = (((t81 / t91) * t93) / tracking_index) * 2.0
    t101 = (t4 + (t75 * 0.5)) + (t93 + (t1 * 0.125))
    t102 = t1 * t101
    t111 = (((t83 * 0.25) + (t86 * 0.125)) + t90) + (t82 * (t81 * 0.125))
    t116 = (((t111 / t91) * 2.0) * (t78 / t2)) / t102
    t122 = ((t82 / t91) * ((t81 + t93) * 0.5)) + 1.0
    t104 = (t96 / t102) / t102
    t117 = t116 / t102
    t124 = (t122 / t102) / t102
    return (t104, t117, t124)


def _gain_derivatives_block(
    given: Arrays,
    out: Arrays,
    work: Arrays,
    single: bool,
    n0: float = 1.0,
    n1: float = 2.0,
    n2: float = 0.5,
    n3: float = 0.0625,
    n4: float = 8.0,
    n5: float = 0.25,
    n6: float = 0.75,
    n7: float = 0.015625,
    n8: float = 0.125,
) -> None:
    (tracking_index,) = given
    alpha, beta, gamma = out
    w0, w1, w2, w3, w4, w5, w6, w7, w8, w9 = work
    p = sqrt(tracking_index, alpha)
    r = sqrt(p, beta)
    t4 = divide(n0, p, gamma)
    t5 = multiply(t4, r, w0)
    t7 = multiply(t5, n1, w0)
    t9 = multiply(p, n2, w1)
    t11 = multiply(tracking_index, n3, w2)
    t12 = multiply(p, r, w3)
    t13 = multiply(t12, n0, w3)
    t15 = divide(n4, r, w4)
    t16 = add(t13, t15, w3)
    t17 = near_cbrt(t16, w3, single)
    t20 = multiply(t7, t17, w4)
    t21 = add(t20, t11, w4)
    t22 = sqrt(t21, w4)
    t23 = multiply(t22, n1, w5)
    t24 = add(t23, t9, w5)
    t25 = sqrt(t24, w5)
    t26 = multiply(t7, n2, w6)
    t27 = multiply(t22, t25, w4)
    t28 = multiply(t25, t27, w5)
    t29 = multiply(t26, t17, w3)
    t30 = subtract(t28, t29, w5)
    t31 = subtract(t27, t26, w4)
    t32 = divide(t30, t31, w5)
    t34 = multiply(t7, t32, w3)
    t35 = add(t34, t11, w3)
    t36 = sqrt(t35, w3)
    t37 = multiply(t36, n1, w4)
    t38 = add(t37, t9, w4)
    t39 = sqrt(t38, w4)
    t40 = multiply(t36, t39, w3)
    t41 = multiply(t39, t40, w4)
    t42 = multiply(t26, t32, w5)
    t43 = subtract(t41, t42, w4)
    t44 = subtract(t40, t26, w3)
    t45 = divide(t43, t44, w4)
    t47 = multiply(t7, t45, w3)
    t48 = add(t47, t11, w3)
    t49 = sqrt(t48, w3)
    t50 = multiply(t49, n1, w5)
    t51 = add(t50, t9, w5)
    t52 = sqrt(t51, w5)
    t53 = multiply(t49, t52, w3)
    t54 = multiply(t52, t53, w5)
    t55 = multiply(t26, t45, w4)
    t56 = subtract(t54, t55, w5)
    t57 = subtract(t53, t26, w3)
    t58 = divide(t56, t57, w5)
    t60 = multiply(t7, t58, w3)
    t61 = add(t60, t11, w3)
    t62 = sqrt(t61, w3)
    t63 = multiply(t62, n1, w4)
    t64 = add(t63, t9, w4)
    t65 = sqrt(t64, w4)
    t66 = multiply(t62, t65, w3)
    t67 = multiply(t65, t66, w4)
    t68 = multiply(t26, t58, w5)
    t69 = subtract(t67, t68, w4)
    t70 = subtract(t66, t26, w3)
    t71 = divide(t69, t70, w4)
    t73 = multiply(t7, t71, w0)
    t74 = add(t73, t11, w0)
    e = sqrt(t74, w0)
    t76 = multiply(e, n1, w2)
    t77 = add(t76, t9, w2)
    x = sqrt(t77, w2)
    t80 = multiply(p, n5, w1)
    t81 = add(e, t80, w1)
    t82 = multiply(x, r, w3)
    t83 = square(e, w4)
    t85 = multiply(t83, n6, w5)
    t86 = multiply(p, e, w6)
    t87 = multiply(t86, n5, w7)
    t88 = add(t85, t87, w5)
    t90 = multiply(tracking_index, n7, w7)
    t91 = add(t88, t90, w5)
    t92 = divide(t81, t91, w8)
    t93 = multiply(t82, n5, w9)
    t94 = multiply(t92, t93, w8)
    t95 = divide(t94, tracking_index, w8)
    t96 = multiply(t95, n1, w8)
    t97 = multiply(e, n2, w0)
    t98 = add(t4, t97, gamma)
    t99 = multiply(p, n8, w0)
    t100 = add(t93, t99, w0)
    t101 = add(t98, t100, gamma)
    t102 = multiply(p, t101, gamma)
    t103 = divide(t96, t102, w8)
    t105 = multiply(t83, n5, w4)
    t106 = multiply(t86, n8, w6)
    t107 = add(t105, t106, w4)
    t108 = add(t107, t90, w4)
    t109 = multiply(t81, n8, w0)
    t110 = multiply(t82, t109, w0)
    t111 = add(t108, t110, w4)
    t112 = divide(t111, t91, w4)
    t113 = multiply(t112, n1, w4)
    t114 = divide(x, r, w2)
    t115 = multiply(t113, t114, w4)
    t116 = divide(t115, t102, w4)
    t118 = divide(t82, t91, w3)
    t119 = add(t81, t93, w1)
    t120 = multiply(t119, n2, w1)
    t121 = multiply(t118, t120, w3)
    t122 = add(t121, n0, w3)
    t123 = divide(t122, t102, w3)
    divide(t103, t102, alpha)
    divide(t116, t102, beta)
    divide(t123, t102, gamma)


_GAIN_DERIVATIVES = Signature(
    "gain_derivatives",
    (_TRACKING_INDEX_DOMAIN,),
    ("alpha", "beta", "gamma"),
    10,
    _gain_derivatives_block,
    numbers=_gain_derivatives_of_numbers,
)


class GainsWithDerivatives(NamedTuple):
    """Result of `gains_with_derivatives`."""

    alpha: Real
    """Position gain."""
    beta: Real
    """Velocity gain times the sampling interval."""
    gamma: Real
    """Acceleration gain times the square of the sampling interval."""
    d_alpha: Real
    """Derivative of the position gain."""
    d_beta: Real
    """Derivative of the velocity gain times the sampling interval."""
    d_gamma: Real
    """Derivative of the acceleration gain times the square of the sampling interval."""


def gains_with_derivatives(
    tracking_index: ArrayLike,
    *,
    out: tuple[Real, Real, Real, Real, Real, Real] | None = None,
    workers: int = 1,
) -> GainsWithDerivatives:
    """Filter gain and its first derivatives in one pass.

        delta = 8/Lambda,
        xi = sqrt(2 + 2 eta), eta = sqrt(1 + 2 delta xi), nu = 1 + xi + eta + delta

    tracking_index: Lambda, with Lambda^2 =
        increment_deviation**2*sampling_interval**4/measurement_deviation**2; a number above 0 and
        finite.

    alpha: position gain. Relative error at most 6.18 * 2^-52 (float64), 6.18 * 2^-23 (float32),
        proved for 5e-324 <= tracking_index <= 1.7976931348623157e308 (float64) and 1e-45 <=
        tracking_index <= 3.4028235e38 (float32).
    beta: velocity gain times the sampling interval. Relative error at most 6.09 * 2^-52 (float64),
        6.09 * 2^-23 (float32), proved for 5e-324 <= tracking_index <= 1.7976931348623157e308
        (float64) and 1e-45 <= tracking_index <= 3.4028235e38 (float32).
    gamma: acceleration gain times the square of the sampling interval. Relative error at most 4.55
        * 2^-52 (float64), 4.55 * 2^-23 (float32), proved for 2.2250738585072014e-308 <=
        tracking_index <= 1.7976931348623157e308 (float64) and 1.1754945e-38 <= tracking_index <=
        3.4028235e38 (float32).
    d_alpha: derivative of the position gain. Relative error at most 14.69 * 2^-52 (float64), 14.69
        * 2^-23 (float32), proved for 5e-324 <= tracking_index <= 7.11074631974658e102 (float64) and
        1e-45 <= tracking_index <= 8.7960925e12 (float32).
    d_beta: derivative of the velocity gain times the sampling interval. Relative error at most
        14.26 * 2^-52 (float64), 14.25 * 2^-23 (float32), proved for 5e-324 <= tracking_index <=
        1.8961503816218352e154 (float64) and 1e-45 <= tracking_index <= 2.6087635e19 (float32).
    d_gamma: derivative of the acceleration gain times the square of the sampling interval. Relative
        error at most 12.43 * 2^-52 (float64), 12.42 * 2^-23 (float32), proved for 5e-324 <=
        tracking_index <= 2.6815615859885194e154 (float64) and 1e-45 <= tracking_index <=
        3.689349e19 (float32).

    Outside an output's range, a few numbers next to its ends apart, its true value is no normal
    number: it comes as 0, a subnormal number or infinity, never as NaN. Numbers and arrays are
    taken, arrays of any shape; inputs are broadcast. float64 and float32 stay what they are,
    integers become float64. `out`: a tuple of arrays to fill. `workers`: threads that share the
    work on long arrays.

    ValueError: an input outside its domain, with its place; `out` or `workers` that does not fit.
    TypeError: an input that is no real number of these types; in `out` what is no array of the
    results' type.

    Source: derivation wiener-acceleration
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
    t2 = form.sqrt(t1)
    t4 = 1.0 / t1
    t7 = (t4 * t2) * 2.0
    t9 = t1 * 0.5
    t11 = tracking_index * 0.0625
    t17 = form.near_cbrt(((t1 * t2) * 1.0) + (8.0 / t2))
    t22 = form.sqrt((t7 * t17) + t11)
    t25 = form.sqrt((t22 * 2.0) + t9)
    t26 = t7 * 0.5
    t27 = t22 * t25
    t32 = ((t25 * t27) - (t26 * t17)) / (t27 - t26)
    t36 = form.sqrt((t7 * t32) + t11)
    t39 = form.sqrt((t36 * 2.0) + t9)
    t40 = t36 * t39
    t45 = ((t39 * t40) - (t26 * t32)) / (t40 - t26)
    t49 = form.sqrt((t7 * t45) + t11)
    t52 = form.sqrt((t49 * 2.0) + t9)
    t53 = t49 * t52
    t58 = ((t52 * t53) - (t26 * t45)) / (t53 - t26)
    t62 = form.sqrt((t7 * t58) + t11)
    t65 = form.sqrt((t62 * 2.0) + t9)
    t66 = t62 * t65
    t71 = ((t65 * t66) - (t26 * t58)) / (t66 - t26)
    t75 = form.sqrt((t7 * t71) + t11)
    t78 = form.sqrt((t75 * 2.0) + t9)
    t81 = t75 + (t1 * 0.25)
    t84 = t78 * t2
    t85 = t84 * 0.25
    t88 = (t4 + (t75 * 0.5)) + (t85 + (t1 * 0.125))
    t92 = t75 * t75
    t95 = t1 * t75
    t99 = tracking_index * 0.015625
    t100 = ((t92 * 0.75) + (t95 * 0.25)) + t99
    t103 = ((t81 / t100) * t85) / tracking_index
    t105 = t1 * t88
    t114 = (((t92 * 0.25) + (t95 * 0.125)) + t99) + (t84 * (t81 * 0.125))
    t119 = (((t114 / t100) * 2.0) * (t78 / t2)) / t105
    t125 = ((t84 / t100) * ((t81 + t85) * 0.5)) + 1.0
    t89 = t81 / t88
    t90 = t84 / t88
    t91 = t1 / t88
    t107 = ((t103 * 2.0) / t105) / t105
    t120 = t119 / t105
    t127 = (t125 / t105) / t105
    return (t89, t90, t91, t107, t120, t127)


def _gains_with_derivatives_block(
    given: Arrays,
    out: Arrays,
    work: Arrays,
    single: bool,
    n0: float = 1.0,
    n1: float = 2.0,
    n2: float = 0.5,
    n3: float = 0.0625,
    n4: float = 8.0,
    n5: float = 0.25,
    n6: float = 0.125,
    n7: float = 0.75,
    n8: float = 0.015625,
) -> None:
    (tracking_index,) = given
    alpha, beta, gamma, d_alpha, d_beta, d_gamma = out
    w0, w1, w2, w3, w4, w5, w6 = work
    p = sqrt(tracking_index, gamma)
    r = sqrt(p, alpha)
    t4 = divide(n0, p, beta)
    t5 = multiply(t4, r, w0)
    t7 = multiply(t5, n1, w0)
    t9 = multiply(p, n2, w1)
    t11 = multiply(tracking_index, n3, w2)
    t12 = multiply(p, r, w3)
    t13 = multiply(t12, n0, w3)
    t15 = divide(n4, r, d_alpha)
    t16 = add(t13, t15, w3)
    t17 = near_cbrt(t16, w3, single)
    t20 = multiply(t7, t17, d_alpha)
    t21 = add(t20, t11, d_alpha)
    t22 = sqrt(t21, d_beta)
    t23 = multiply(t22, n1, d_alpha)
    t24 = add(t23, t9, d_alpha)
    t25 = sqrt(t24, d_gamma)
    t26 = multiply(t7, n2, d_alpha)
    t27 = multiply(t22, t25, d_beta)
    t28 = multiply(t25, t27, d_gamma)
    t29 = multiply(t26, t17, w3)
    t30 = subtract(t28, t29, d_gamma)
    t31 = subtract(t27, t26, d_beta)
    t32 = divide(t30, t31, d_gamma)
    t34 = multiply(t7, t32, w3)
    t35 = add(t34, t11, w3)
    t36 = sqrt(t35, w3)
    t37 = multiply(t36, n1, d_beta)
    t38 = add(t37, t9, d_beta)
    t39 = sqrt(t38, d_beta)
    t40 = multiply(t36, t39, w3)
    t41 = multiply(t39, t40, d_beta)
    t42 = multiply(t26, t32, d_gamma)
    t43 = subtract(t41, t42, d_beta)
    t44 = subtract(t40, t26, w3)
    t45 = divide(t43, t44, d_beta)
    t47 = multiply(t7, t45, w3)
    t48 = add(t47, t11, w3)
    t49 = sqrt(t48, w3)
    t50 = multiply(t49, n1, d_gamma)
    t51 = add(t50, t9, d_gamma)
    t52 = sqrt(t51, d_gamma)
    t53 = multiply(t49, t52, w3)
    t54 = multiply(t52, t53, d_gamma)
    t55 = multiply(t26, t45, d_beta)
    t56 = subtract(t54, t55, d_gamma)
    t57 = subtract(t53, t26, w3)
    t58 = divide(t56, t57, d_gamma)
    t60 = multiply(t7, t58, w3)
    t61 = add(t60, t11, w3)
    t62 = sqrt(t61, w3)
    t63 = multiply(t62, n1, d_beta)
    t64 = add(t63, t9, d_beta)
    t65 = sqrt(t64, d_beta)
    t66 = multiply(t62, t65, w3)
    t67 = multiply(t65, t66, d_beta)
    t68 = multiply(t26, t58, d_gamma)
    t69 = subtract(t67, t68, d_beta)
    t70 = subtract(t66, t26, w3)
    t71 = divide(t69, t70, d_beta)
    t73 = multiply(t7, t71, w0)
    t74 = add(t73, t11, w0)
    e = sqrt(t74, w0)
    t76 = multiply(e, n1, w2)
    t77 = add(t76, t9, w2)
    x = sqrt(t77, w2)
    t80 = multiply(p, n5, w1)
    t81 = add(e, t80, w1)
    t82 = multiply(e, n2, w3)
    t83 = add(t4, t82, beta)
    t84 = multiply(x, r, w3)
    t85 = multiply(t84, n5, d_alpha)
    t86 = multiply(p, n6, d_beta)
    t87 = add(t85, t86, d_beta)
    t88 = add(t83, t87, d_beta)
    t92 = square(e, beta)
    t94 = multiply(t92, n7, d_gamma)
    t95 = multiply(p, e, w0)
    t96 = multiply(t95, n5, w4)
    t97 = add(t94, t96, d_gamma)
    t99 = multiply(tracking_index, n8, w4)
    t100 = add(t97, t99, d_gamma)
    t101 = divide(t81, t100, w5)
    t102 = multiply(t101, t85, w5)
    t103 = divide(t102, tracking_index, w5)
    t104 = multiply(t103, n1, w5)
    t105 = multiply(p, t88, w6)
    t106 = divide(t104, t105, w5)
    t108 = multiply(t92, n5, beta)
    t109 = multiply(t95, n6, w0)
    t110 = add(t108, t109, beta)
    t111 = add(t110, t99, beta)
    t112 = multiply(t81, n6, w0)
    t113 = multiply(t84, t112, w0)
    t114 = add(t111, t113, beta)
    t115 = divide(t114, t100, beta)
    t116 = multiply(t115, n1, beta)
    t117 = divide(x, r, w2)
    t118 = multiply(t116, t117, beta)
    t119 = divide(t118, t105, w0)
    t121 = divide(t84, t100, d_gamma)
    t122 = add(t81, t85, d_alpha)
    t123 = multiply(t122, n2, d_alpha)
    t124 = multiply(t121, t123, d_gamma)
    t125 = add(t124, n0, d_gamma)
    t126 = divide(t125, t105, d_gamma)
    divide(t81, t88, alpha)
    divide(t84, t88, beta)
    divide(p, t88, gamma)
    divide(t106, t105, d_alpha)
    divide(t119, t105, d_beta)
    divide(t126, t105, d_gamma)


_GAINS_WITH_DERIVATIVES = Signature(
    "gains_with_derivatives",
    (_TRACKING_INDEX_DOMAIN,),
    ("alpha", "beta", "gamma", "d_alpha", "d_beta", "d_gamma"),
    7,
    _gains_with_derivatives_block,
    numbers=_gains_with_derivatives_of_numbers,
)


class PredictorGains(NamedTuple):
    """Result of `predictor_gains`."""

    position: Real
    """Position entry of F K, alpha + beta + gamma/2."""
    velocity: Real
    """Velocity entry of F K times the sampling interval, beta + gamma."""
    acceleration: Real
    """Acceleration entry of F K times the square of the sampling interval, gamma."""


def predictor_gains(
    tracking_index: ArrayLike, *, out: tuple[Real, Real, Real] | None = None, workers: int = 1
) -> PredictorGains:
    """Steady-state predictor gain F K.

        delta = 8/Lambda,
        xi = sqrt(2 + 2 eta), eta = sqrt(1 + 2 delta xi), nu = 1 + xi + eta + delta

    tracking_index: Lambda, with Lambda^2 =
        increment_deviation**2*sampling_interval**4/measurement_deviation**2; a number above 0 and
        finite.

    position: position entry of F K, alpha + beta + gamma/2. Relative error at most 6.18 * 2^-52
        (float64), 6.19 * 2^-23 (float32), proved for 5e-324 <= tracking_index <=
        1.7976931348623157e308 (float64) and 1e-45 <= tracking_index <= 3.4028235e38 (float32).
    velocity: velocity entry of F K times the sampling interval, beta + gamma. Relative error at
        most 6.59 * 2^-52 (float64), 6.59 * 2^-23 (float32), proved for 5e-324 <= tracking_index <=
        1.7976931348623157e308 (float64) and 1e-45 <= tracking_index <= 3.4028235e38 (float32).
    acceleration: acceleration entry of F K times the square of the sampling interval, gamma.
        Relative error at most 4.55 * 2^-52 (float64), 4.55 * 2^-23 (float32), proved for
        2.2250738585072014e-308 <= tracking_index <= 1.7976931348623157e308 (float64) and
        1.1754945e-38 <= tracking_index <= 3.4028235e38 (float32).

    Outside an output's range, a few numbers next to its ends apart, its true value is no normal
    number: it comes as 0, a subnormal number or infinity, never as NaN. Numbers and arrays are
    taken, arrays of any shape; inputs are broadcast. float64 and float32 stay what they are,
    integers become float64. `out`: a tuple of arrays to fill. `workers`: threads that share the
    work on long arrays.

    ValueError: an input outside its domain, with its place; `out` or `workers` that does not fit.
    TypeError: an input that is no real number of these types; in `out` what is no array of the
    results' type.

    Source: derivation wiener-acceleration
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
    t1 = form.sqrt(tracking_index)
    t2 = form.sqrt(t1)
    t4 = 1.0 / t1
    t7 = (t4 * t2) * 2.0
    t9 = t1 * 0.5
    t11 = tracking_index * 0.0625
    t17 = form.near_cbrt(((t1 * t2) * 1.0) + (8.0 / t2))
    t22 = form.sqrt((t7 * t17) + t11)
    t25 = form.sqrt((t22 * 2.0) + t9)
    t26 = t7 * 0.5
    t27 = t22 * t25
    t32 = ((t25 * t27) - (t26 * t17)) / (t27 - t26)
    t36 = form.sqrt((t7 * t32) + t11)
    t39 = form.sqrt((t36 * 2.0) + t9)
    t40 = t36 * t39
    t45 = ((t39 * t40) - (t26 * t32)) / (t40 - t26)
    t49 = form.sqrt((t7 * t45) + t11)
    t52 = form.sqrt((t49 * 2.0) + t9)
    t53 = t49 * t52
    t58 = ((t52 * t53) - (t26 * t45)) / (t53 - t26)
    t62 = form.sqrt((t7 * t58) + t11)
    t65 = form.sqrt((t62 * 2.0) + t9)
    t66 = t62 * t65
    t71 = ((t65 * t66) - (t26 * t58)) / (t66 - t26)
    t75 = form.sqrt((t7 * t71) + t11)
    t79 = form.sqrt((t75 * 2.0) + t9) * t2
    t90 = (t4 + (t75 * 0.5)) + ((t79 * 0.25) + (t1 * 0.125))
    t91 = (t75 + (t79 + (t1 * 0.75))) / t90
    t93 = (t79 + t1) / t90
    t94 = t1 / t90
    return (t91, t93, t94)


def _predictor_gains_block(
    given: Arrays,
    out: Arrays,
    work: Arrays,
    single: bool,
    n0: float = 1.0,
    n1: float = 2.0,
    n2: float = 0.5,
    n3: float = 0.0625,
    n4: float = 8.0,
    n5: float = 0.75,
    n6: float = 0.25,
    n7: float = 0.125,
) -> None:
    (tracking_index,) = given
    position, velocity, acceleration = out
    w0, w1, w2, w3, w4, w5, w6 = work
    p = sqrt(tracking_index, acceleration)
    r = sqrt(p, position)
    t4 = divide(n0, p, velocity)
    t5 = multiply(t4, r, w0)
    t7 = multiply(t5, n1, w0)
    t9 = multiply(p, n2, w1)
    t11 = multiply(tracking_index, n3, w2)
    t12 = multiply(p, r, w3)
    t13 = multiply(t12, n0, w3)
    t15 = divide(n4, r, w4)
    t16 = add(t13, t15, w3)
    t17 = near_cbrt(t16, w3, single)
    t20 = multiply(t7, t17, w4)
    t21 = add(t20, t11, w4)
    t22 = sqrt(t21, w4)
    t23 = multiply(t22, n1, w5)
    t24 = add(t23, t9, w5)
    t25 = sqrt(t24, w5)
    t26 = multiply(t7, n2, w6)
    t27 = multiply(t22, t25, w4)
    t28 = multiply(t25, t27, w5)
    t29 = multiply(t26, t17, w3)
    t30 = subtract(t28, t29, w5)
    t31 = subtract(t27, t26, w4)
    t32 = divide(t30, t31, w5)
    t34 = multiply(t7, t32, w3)
    t35 = add(t34, t11, w3)
    t36 = sqrt(t35, w3)
    t37 = multiply(t36, n1, w4)
    t38 = add(t37, t9, w4)
    t39 = sqrt(t38, w4)
    t40 = multiply(t36, t39, w3)
    t41 = multiply(t39, t40, w4)
    t42 = multiply(t26, t32, w5)
    t43 = subtract(t41, t42, w4)
    t44 = subtract(t40, t26, w3)
    t45 = divide(t43, t44, w4)
    t47 = multiply(t7, t45, w3)
    t48 = add(t47, t11, w3)
    t49 = sqrt(t48, w3)
    t50 = multiply(t49, n1, w5)
    t51 = add(t50, t9, w5)
    t52 = sqrt(t51, w5)
    t53 = multiply(t49, t52, w3)
    t54 = multiply(t52, t53, w5)
    t55 = multiply(t26, t45, w4)
    t56 = subtract(t54, t55, w5)
    t57 = subtract(t53, t26, w3)
    t58 = divide(t56, t57, w5)
    t60 = multiply(t7, t58, w3)
    t61 = add(t60, t11, w3)
    t62 = sqrt(t61, w3)
    t63 = multiply(t62, n1, w4)
    t64 = add(t63, t9, w4)
    t65 = sqrt(t64, w4)
    t66 = multiply(t62, t65, w3)
    t67 = multiply(t65, t66, w4)
    t68 = multiply(t26, t58, w5)
    t69 = subtract(t67, t68, w4)
    t70 = subtract(t66, t26, w3)
    t71 = divide(t69, t70, w4)
    t73 = multiply(t7, t71, w0)
    t74 = add(t73, t11, w0)
    e = sqrt(t74, w0)
    t76 = multiply(e, n1, w2)
    t77 = add(t76, t9, w2)
    x = sqrt(t77, w2)
    t79 = multiply(x, r, w2)
    t81 = multiply(p, n5, w1)
    t82 = add(t79, t81, w1)
    t83 = add(e, t82, w1)
    t84 = multiply(e, n2, w0)
    t85 = add(t4, t84, velocity)
    t87 = multiply(t79, n6, w0)
    t88 = multiply(p, n7, w3)
    t89 = add(t87, t88, w0)
    t90 = add(t85, t89, w0)
    t92 = add(t79, p, w2)
    divide(t83, t90, position)
    divide(t92, t90, velocity)
    divide(p, t90, acceleration)


_PREDICTOR_GAINS = Signature(
    "predictor_gains",
    (_TRACKING_INDEX_DOMAIN,),
    ("position", "velocity", "acceleration"),
    7,
    _predictor_gains_block,
    numbers=_predictor_gains_of_numbers,
)


class PredictorGainDerivatives(NamedTuple):
    """Result of `predictor_gain_derivatives`."""

    position: Real
    """Derivative of the position entry of F K, alpha + beta + gamma/2."""
    velocity: Real
    """Derivative of the velocity entry of F K times the sampling interval, beta + gamma."""
    acceleration: Real
    """Derivative of the acceleration entry of F K times the square of the sampling interval,
    gamma."""


def predictor_gain_derivatives(
    tracking_index: ArrayLike, *, out: tuple[Real, Real, Real] | None = None, workers: int = 1
) -> PredictorGainDerivatives:
    """First derivatives of the predictor gain.

        delta = 8/Lambda,
        xi = sqrt(2 + 2 eta), eta = sqrt(1 + 2 delta xi), nu = 1 + xi + eta + delta

    tracking_index: Lambda, with Lambda^2 =
        increment_deviation**2*sampling_interval**4/measurement_deviation**2; a number above 0 and
        finite.

    position: derivative of the position entry of F K, alpha + beta + gamma/2. Relative error at
        most 11.59 * 2^-52 (float64), 11.59 * 2^-23 (float32), proved for 5e-324 <= tracking_index
        <= 2.6815615859885194e154 (float64) and 1e-45 <= tracking_index <= 3.689349e19 (float32).
    velocity: derivative of the velocity entry of F K times the sampling interval, beta + gamma.
        Relative error at most 12.06 * 2^-52 (float64), 12.06 * 2^-23 (float32), proved for 5e-324
        <= tracking_index <= 3.2842287997601345e154 (float64) and 1e-45 <= tracking_index <=
        4.5185108e19 (float32).
    acceleration: derivative of the acceleration entry of F K times the square of the sampling
        interval, gamma. Relative error at most 12.37 * 2^-52 (float64), 12.36 * 2^-23 (float32),
        proved for 5e-324 <= tracking_index <= 2.6815615859885194e154 (float64) and 1e-45 <=
        tracking_index <= 3.689349e19 (float32).

    Outside an output's range, a few numbers next to its ends apart, its true value is no normal
    number: it comes as 0, a subnormal number or infinity, never as NaN. Numbers and arrays are
    taken, arrays of any shape; inputs are broadcast. float64 and float32 stay what they are,
    integers become float64. `out`: a tuple of arrays to fill. `workers`: threads that share the
    work on long arrays.

    ValueError: an input outside its domain, with its place; `out` or `workers` that does not fit.
    TypeError: an input that is no real number of these types; in `out` what is no array of the
    results' type.

    Source: derivation wiener-acceleration
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
    t2 = form.sqrt(t1)
    t4 = 1.0 / t1
    t7 = (t4 * t2) * 2.0
    t9 = t1 * 0.5
    t11 = tracking_index * 0.0625
    t17 = form.near_cbrt(((t1 * t2) * 1.0) + (8.0 / t2))
    t22 = form.sqrt((t7 * t17) + t11)
    t25 = form.sqrt((t22 * 2.0) + t9)
    t26 = t7 * 0.5
    t27 = t22 * t25
    t32 = ((t25 * t27) - (t26 * t17)) / (t27 - t26)
    t36 = form.sqrt((t7 * t32) + t11)
    t39 = form.sqrt((t36 * 2.0) + t9)
    t40 = t36 * t39
    t45 = ((t39 * t40) - (t26 * t32)) / (t40 - t26)
    t49 = form.sqrt((t7 * t45) + t11)
    t52 = form.sqrt((t49 * 2.0) + t9)
    t53 = t49 * t52
    t58 = ((t52 * t53) - (t26 * t45)) / (t53 - t26)
    t62 = form.sqrt((t7 * t58) + t11)
    t65 = form.sqrt((t62 * 2.0) + t9)
    t66 = t62 * t65
    t71 = ((t65 * t66) - (t26 * t58)) / (t66 - t26)
    t75 = form.sqrt((t7 * t71) + t11)
    t78 = form.sqrt((t75 * 2.0) + t9)
    t83 = (tracking_index / t2) * 0.020833333333333332
    t87 = t83 + ((t2 * t75) * 0.3333333333333333)
    t90 = t87 + ((t75 / t2) * t75)
    t95 = t75 * 0.5
    t97 = (t78 * 0.6666666666666666) * (t95 + t4)
    t108 = (t4 + t95) + (((t78 * t2) * 0.25) + (t1 * 0.125))
    t109 = ((((t97 / t90) + 1.0) * 2.0) / t75) / t108
    t115 = ((t2 * 0.5) + t78) * ((t1 * 0.25) + t75)
    t118 = ((t115 * 0.6666666666666666) / t90) + 1.0
    t92 = ((2.6666666666666665 / t2) / t90) / tracking_index
    t110 = t109 / tracking_index
    t121 = ((t118 / t108) / tracking_index) / t108
    return (t92, t110, t121)


def _predictor_gain_derivatives_block(
    given: Arrays,
    out: Arrays,
    work: Arrays,
    single: bool,
    n0: float = 1.0,
    n1: float = 2.0,
    n2: float = 0.5,
    n3: float = 0.0625,
    n4: float = 8.0,
    n5: float = 2.6666666666666665,
    n6: float = 0.020833333333333332,
    n7: float = 0.3333333333333333,
    n8: float = 0.6666666666666666,
    n9: float = 0.25,
    n10: float = 0.125,
) -> None:
    (tracking_index,) = given
    position, velocity, acceleration = out
    w0, w1, w2, w3, w4, w5, w6 = work
    p = sqrt(tracking_index, position)
    r = sqrt(p, velocity)
    t4 = divide(n0, p, acceleration)
    t5 = multiply(t4, r, w0)
    t7 = multiply(t5, n1, w0)
    t9 = multiply(p, n2, w1)
    t11 = multiply(tracking_index, n3, w2)
    t12 = multiply(p, r, w3)
    t13 = multiply(t12, n0, w3)
    t15 = divide(n4, r, w4)
    t16 = add(t13, t15, w3)
    t17 = near_cbrt(t16, w3, single)
    t20 = multiply(t7, t17, w4)
    t21 = add(t20, t11, w4)
    t22 = sqrt(t21, w4)
    t23 = multiply(t22, n1, w5)
    t24 = add(t23, t9, w5)
    t25 = sqrt(t24, w5)
    t26 = multiply(t7, n2, w6)
    t27 = multiply(t22, t25, w4)
    t28 = multiply(t25, t27, w5)
    t29 = multiply(t26, t17, w3)
    t30 = subtract(t28, t29, w5)
    t31 = subtract(t27, t26, w4)
    t32 = divide(t30, t31, w5)
    t34 = multiply(t7, t32, w3)
    t35 = add(t34, t11, w3)
    t36 = sqrt(t35, w3)
    t37 = multiply(t36, n1, w4)
    t38 = add(t37, t9, w4)
    t39 = sqrt(t38, w4)
    t40 = multiply(t36, t39, w3)
    t41 = multiply(t39, t40, w4)
    t42 = multiply(t26, t32, w5)
    t43 = subtract(t41, t42, w4)
    t44 = subtract(t40, t26, w3)
    t45 = divide(t43, t44, w4)
    t47 = multiply(t7, t45, w3)
    t48 = add(t47, t11, w3)
    t49 = sqrt(t48, w3)
    t50 = multiply(t49, n1, w5)
    t51 = add(t50, t9, w5)
    t52 = sqrt(t51, w5)
    t53 = multiply(t49, t52, w3)
    t54 = multiply(t52, t53, w5)
    t55 = multiply(t26, t45, w4)
    t56 = subtract(t54, t55, w5)
    t57 = subtract(t53, t26, w3)
    t58 = divide(t56, t57, w5)
    t60 = multiply(t7, t58, w3)
    t61 = add(t60, t11, w3)
    t62 = sqrt(t61, w3)
    t63 = multiply(t62, n1, w4)
    t64 = add(t63, t9, w4)
    t65 = sqrt(t64, w4)
    t66 = multiply(t62, t65, w3)
    t67 = multiply(t65, t66, w4)
    t68 = multiply(t26, t58, w5)
    t69 = subtract(t67, t68, w4)
    t70 = subtract(t66, t26, w3)
    t71 = divide(t69, t70, w4)
    t73 = multiply(t7, t71, w0)
    t74 = add(t73, t11, w0)
    e = sqrt(t74, w0)
    t76 = multiply(e, n1, w2)
    t77 = add(t76, t9, w2)
    x = sqrt(t77, w2)
    t80 = divide(n5, r, w1)
    t81 = divide(tracking_index, r, w3)
    t83 = multiply(t81, n6, w3)
    t84 = multiply(r, e, w4)
    t86 = multiply(t84, n7, w4)
    t87 = add(t83, t86, w3)
    t88 = divide(e, r, w4)
    t89 = multiply(t88, e, w4)
    t90 = add(t87, t89, w3)
    t91 = divide(t80, t90, w1)
    t94 = multiply(x, n8, w4)
    t95 = multiply(e, n2, w5)
    t96 = add(t95, t4, w6)
    t97 = multiply(t94, t96, w4)
    t98 = divide(t97, t90, w4)
    t99 = add(t98, n0, w4)
    t100 = multiply(t99, n1, w4)
    t101 = divide(t100, e, w4)
    t102 = add(t4, t95, acceleration)
    t103 = multiply(x, r, w5)
    t105 = multiply(t103, n9, w5)
    t106 = multiply(p, n10, w6)
    t107 = add(t105, t106, w5)
    t108 = add(t102, t107, acceleration)
    t109 = divide(t101, t108, w4)
    t111 = multiply(r, n2, velocity)
    t112 = add(t111, x, velocity)
    t113 = multiply(p, n9, position)
    t114 = add(t113, e, position)
    t115 = multiply(t112, t114, velocity)
    t116 = multiply(t115, n8, velocity)
    t117 = divide(t116, t90, velocity)
    t118 = add(t117, n0, velocity)
    t119 = divide(t118, t108, velocity)
    t120 = divide(t119, tracking_index, w0)
    divide(t91, tracking_index, position)
    divide(t109, tracking_index, velocity)
    divide(t120, t108, acceleration)


_PREDICTOR_GAIN_DERIVATIVES = Signature(
    "predictor_gain_derivatives",
    (_TRACKING_INDEX_DOMAIN,),
    ("position", "velocity", "acceleration"),
    7,
    _predictor_gain_derivatives_block,
    numbers=_predictor_gain_derivatives_of_numbers,
)


class InnovationDeviation(NamedTuple):
    """Result of `innovation_deviation`."""

    innovation_deviation: Real
    """Standard deviation of an innovation over sigma_v."""


def innovation_deviation(
    tracking_index: ArrayLike, *, out: tuple[Real] | None = None, workers: int = 1
) -> InnovationDeviation:
    """Standard deviation of an innovation in units of sigma_v.

        sigma = Lambda nu/8,
        delta = 8/Lambda,
        xi = sqrt(2 + 2 eta), eta = sqrt(1 + 2 delta xi), nu = 1 + xi + eta + delta

    tracking_index: Lambda, with Lambda^2 =
        increment_deviation**2*sampling_interval**4/measurement_deviation**2; a number above 0 and
        finite.

    innovation_deviation: standard deviation of an innovation over sigma_v. Relative error at most
        4.40 * 2^-52 (float64), 4.39 * 2^-23 (float32), proved for 5e-324 <= tracking_index <=
        1.7976931348623157e308 (float64) and 1e-45 <= tracking_index <= 3.4028235e38 (float32).

    Outside an output's range, a few numbers next to its ends apart, its true value is no normal
    number: it comes as 0, a subnormal number or infinity, never as NaN. Numbers and arrays are
    taken, arrays of any shape; inputs are broadcast. float64 and float32 stay what they are,
    integers become float64. `out`: a tuple of arrays to fill. `workers`: threads that share the
    work on long arrays.

    ValueError: an input outside its domain, with its place; `out` or `workers` that does not fit.
    TypeError: an input that is no real number of these types; in `out` what is no array of the
    results' type.

    Source: derivation wiener-acceleration
    """
    if (
        type(tracking_index) is float
        and 5e-324 <= tracking_index <= 1.7976931348623157e308
        and out is None
        and workers is ONE
    ):
        try:
            return named(InnovationDeviation, _innovation_deviation_of_numbers(tracking_index))
        except (ArithmeticError, ValueError):
            pass  # arrays say what is wrong
    return InnovationDeviation(*evaluate(_INNOVATION_DEVIATION, (tracking_index,), out, workers))


def _innovation_deviation_of_numbers(
    tracking_index: float,
    form: Form = Double,
) -> tuple[float, ...]:
    t1 = form.sqrt(tracking_index)
    t2 = form.sqrt(t1)
    t4 = 1.0 / t1
    t7 = (t4 * t2) * 2.0
    t9 = t1 * 0.5
    t11 = tracking_index * 0.0625
    t17 = form.near_cbrt(((t1 * t2) * 1.0) + (8.0 / t2))
    t22 = form.sqrt((t7 * t17) + t11)
    t25 = form.sqrt((t22 * 2.0) + t9)
    t26 = t7 * 0.5
    t27 = t22 * t25
    t32 = ((t25 * t27) - (t26 * t17)) / (t27 - t26)
    t36 = form.sqrt((t7 * t32) + t11)
    t39 = form.sqrt((t36 * 2.0) + t9)
    t40 = t36 * t39
    t45 = ((t39 * t40) - (t26 * t32)) / (t40 - t26)
    t49 = form.sqrt((t7 * t45) + t11)
    t52 = form.sqrt((t49 * 2.0) + t9)
    t53 = t49 * t52
    t58 = ((t52 * t53) - (t26 * t45)) / (t53 - t26)
    t62 = form.sqrt((t7 * t58) + t11)
    t65 = form.sqrt((t62 * 2.0) + t9)
    t66 = t62 * t65
    t71 = ((t65 * t66) - (t26 * t58)) / (t66 - t26)
    t75 = form.sqrt((t7 * t71) + t11)
    t83 = (form.sqrt((t75 * 2.0) + t9) * t2) * 0.25
    t86 = (t4 + (t75 * 0.5)) + (t83 + (t1 * 0.125))
    t87 = t1 * t86
    return (t87,)


def _innovation_deviation_block(
    given: Arrays,
    out: Arrays,
    work: Arrays,
    single: bool,
    n0: float = 1.0,
    n1: float = 2.0,
    n2: float = 0.5,
    n3: float = 0.0625,
    n4: float = 8.0,
    n5: float = 0.25,
    n6: float = 0.125,
) -> None:
    (tracking_index,) = given
    (innovation_deviation,) = out
    w0, w1, w2, w3, w4, w5, w6, w7, w8 = work
    p = sqrt(tracking_index, innovation_deviation)
    r = sqrt(p, w0)
    t4 = divide(n0, p, w1)
    t5 = multiply(t4, r, w2)
    t7 = multiply(t5, n1, w2)
    t9 = multiply(p, n2, w3)
    t11 = multiply(tracking_index, n3, w4)
    t12 = multiply(p, r, w5)
    t13 = multiply(t12, n0, w5)
    t15 = divide(n4, r, w6)
    t16 = add(t13, t15, w5)
    t17 = near_cbrt(t16, w5, single)
    t20 = multiply(t7, t17, w6)
    t21 = add(t20, t11, w6)
    t22 = sqrt(t21, w6)
    t23 = multiply(t22, n1, w7)
    t24 = add(t23, t9, w7)
    t25 = sqrt(t24, w7)
    t26 = multiply(t7, n2, w8)
    t27 = multiply(t22, t25, w6)
    t28 = multiply(t25, t27, w7)
    t29 = multiply(t26, t17, w5)
    t30 = subtract(t28, t29, w7)
    t31 = subtract(t27, t26, w6)
    t32 = divide(t30, t31, w7)
    t34 = multiply(t7, t32, w5)
    t35 = add(t34, t11, w5)
    t36 = sqrt(t35, w5)
    t37 = multiply(t36, n1, w6)
    t38 = add(t37, t9, w6)
    t39 = sqrt(t38, w6)
    t40 = multiply(t36, t39, w5)
    t41 = multiply(t39, t40, w6)
    t42 = multiply(t26, t32, w7)
    t43 = subtract(t41, t42, w6)
    t44 = subtract(t40, t26, w5)
    t45 = divide(t43, t44, w6)
    t47 = multiply(t7, t45, w5)
    t48 = add(t47, t11, w5)
    t49 = sqrt(t48, w5)
    t50 = multiply(t49, n1, w7)
    t51 = add(t50, t9, w7)
    t52 = sqrt(t51, w7)
    t53 = multiply(t49, t52, w5)
    t54 = multiply(t52, t53, w7)
    t55 = multiply(t26, t45, w6)
    t56 = subtract(t54, t55, w7)
    t57 = subtract(t53, t26, w5)
    t58 = divide(t56, t57, w7)
    t60 = multiply(t7, t58, w5)
    t61 = add(t60, t11, w5)
    t62 = sqrt(t61, w5)
    t63 = multiply(t62, n1, w6)
    t64 = add(t63, t9, w6)
    t65 = sqrt(t64, w6)
    t66 = multiply(t62, t65, w5)
    t67 = multiply(t65, t66, w6)
    t68 = multiply(t26, t58, w7)
    t69 = subtract(t67, t68, w6)
    t70 = subtract(t66, t26, w5)
    t71 = divide(t69, t70, w6)
    t73 = multiply(t7, t71, w2)
    t74 = add(t73, t11, w2)
    e = sqrt(t74, w2)
    t76 = multiply(e, n1, w4)
    t77 = add(t76, t9, w4)
    x = sqrt(t77, w4)
    t79 = multiply(e, n2, w2)
    t80 = add(t4, t79, w1)
    t81 = multiply(x, r, w4)
    t83 = multiply(t81, n5, w4)
    t84 = multiply(p, n6, w0)
    t85 = add(t83, t84, w4)
    t86 = add(t80, t85, w1)
    multiply(p, t86, innovation_deviation)


_INNOVATION_DEVIATION = Signature(
    "innovation_deviation",
    (_TRACKING_INDEX_DOMAIN,),
    ("innovation_deviation",),
    9,
    _innovation_deviation_block,
    numbers=_innovation_deviation_of_numbers,
)


class PoleProduct(NamedTuple):
    """Result of `pole_product`."""

    pole_product: Real
    """Product of the poles, and what is left of 1 beside the position gain."""


def pole_product(
    tracking_index: ArrayLike, *, out: tuple[Real] | None = None, workers: int = 1
) -> PoleProduct:
    """Product of the three poles of the filter, which is 1 - alpha.

        pole_product = 1/sigma^2, sigma = Lambda nu/8,
        one pole is w = 1/sigma, the others solve z^2 - 2 m z + w = 0, m = (xi^2 - 8)/(xi^2 + 2 xi),
        delta = 8/Lambda,
        xi = sqrt(2 + 2 eta), eta = sqrt(1 + 2 delta xi), nu = 1 + xi + eta + delta

    tracking_index: Lambda, with Lambda^2 =
        increment_deviation**2*sampling_interval**4/measurement_deviation**2; a number above 0 and
        finite.

    pole_product: product of the poles, and what is left of 1 beside the position gain. Relative
        error at most 8.59 * 2^-52 (float64), 8.59 * 2^-23 (float32), proved for 5e-324 <=
        tracking_index <= 1.3407807929942597e154 (float64) and 1e-45 <= tracking_index <=
        1.8446744e19 (float32).

    Outside an output's range, a few numbers next to its ends apart, its true value is no normal
    number: it comes as 0, a subnormal number or infinity, never as NaN. Numbers and arrays are
    taken, arrays of any shape; inputs are broadcast. float64 and float32 stay what they are,
    integers become float64. `out`: a tuple of arrays to fill. `workers`: threads that share the
    work on long arrays.

    ValueError: an input outside its domain, with its place; `out` or `workers` that does not fit.
    TypeError: an input that is no real number of these types; in `out` what is no array of the
    results' type.

    Source: derivation wiener-acceleration
    """
    if (
        type(tracking_index) is float
        and 5e-324 <= tracking_index <= 1.7976931348623157e308
        and out is None
        and workers is ONE
    ):
        try:
            return named(PoleProduct, _pole_product_of_numbers(tracking_index))
        except (ArithmeticError, ValueError):
            pass  # arrays say what is wrong
    return PoleProduct(*evaluate(_POLE_PRODUCT, (tracking_index,), out, workers))


def _pole_product_of_numbers(tracking_index: float, form: Form = Double) -> tuple[float, ...]:
    t1 = form.sqrt(tracking_index)
    t2 = form.sqrt(t1)
    t4 = 1.0 / t1
    t7 = (t4 * t2) * 2.0
    t9 = t1 * 0.5
    t11 = tracking_index * 0.0625
    t17 = form.near_cbrt(((t1 * t2) * 1.0) + (8.0 / t2))
    t22 = form.sqrt((t7 * t17) + t11)
    t25 = form.sqrt((t22 * 2.0) + t9)
    t26 = t7 * 0.5
    t27 = t22 * t25
    t32 = ((t25 * t27) - (t26 * t17)) / (t27 - t26)
    t36 = form.sqrt((t7 * t32) + t11)
    t39 = form.sqrt((t36 * 2.0) + t9)
    t40 = t36 * t39
    t45 = ((t39 * t40) - (t26 * t32)) / (t40 - t26)
    t49 = form.sqrt((t7 * t45) + t11)
    t52 = form.sqrt((t49 * 2.0) + t9)
    t53 = t49 * t52
    t58 = ((t52 * t53) - (t26 * t45)) / (t53 - t26)
    t62 = form.sqrt((t7 * t58) + t11)
    t65 = form.sqrt((t62 * 2.0) + t9)
    t66 = t62 * t65
    t71 = ((t65 * t66) - (t26 * t58)) / (t66 - t26)
    t75 = form.sqrt((t7 * t71) + t11)
    t83 = (form.sqrt((t75 * 2.0) + t9) * t2) * 0.25
    t86 = (t4 + (t75 * 0.5)) + (t83 + (t1 * 0.125))
    t89 = ((1.0 / t86) / tracking_index) / t86
    return (t89,)


def _pole_product_block(
    given: Arrays,
    out: Arrays,
    work: Arrays,
    single: bool,
    n0: float = 1.0,
    n1: float = 2.0,
    n2: float = 0.5,
    n3: float = 0.0625,
    n4: float = 8.0,
    n5: float = 0.25,
    n6: float = 0.125,
) -> None:
    (tracking_index,) = given
    (pole_product,) = out
    w0, w1, w2, w3, w4, w5, w6, w7, w8 = work
    p = sqrt(tracking_index, pole_product)
    r = sqrt(p, w0)
    t4 = divide(n0, p, w1)
    t5 = multiply(t4, r, w2)
    t7 = multiply(t5, n1, w2)
    t9 = multiply(p, n2, w3)
    t11 = multiply(tracking_index, n3, w4)
    t12 = multiply(p, r, w5)
    t13 = multiply(t12, n0, w5)
    t15 = divide(n4, r, w6)
    t16 = add(t13, t15, w5)
    t17 = near_cbrt(t16, w5, single)
    t20 = multiply(t7, t17, w6)
    t21 = add(t20, t11, w6)
    t22 = sqrt(t21, w6)
    t23 = multiply(t22, n1, w7)
    t24 = add(t23, t9, w7)
    t25 = sqrt(t24, w7)
    t26 = multiply(t7, n2, w8)
    t27 = multiply(t22, t25, w6)
    t28 = multiply(t25, t27, w7)
    t29 = multiply(t26, t17, w5)
    t30 = subtract(t28, t29, w7)
    t31 = subtract(t27, t26, w6)
    t32 = divide(t30, t31, w7)
    t34 = multiply(t7, t32, w5)
    t35 = add(t34, t11, w5)
    t36 = sqrt(t35, w5)
    t37 = multiply(t36, n1, w6)
    t38 = add(t37, t9, w6)
    t39 = sqrt(t38, w6)
    t40 = multiply(t36, t39, w5)
    t41 = multiply(t39, t40, w6)
    t42 = multiply(t26, t32, w7)
    t43 = subtract(t41, t42, w6)
    t44 = subtract(t40, t26, w5)
    t45 = divide(t43, t44, w6)
    t47 = multiply(t7, t45, w5)
    t48 = add(t47, t11, w5)
    t49 = sqrt(t48, w5)
    t50 = multiply(t49, n1, w7)
    t51 = add(t50, t9, w7)
    t52 = sqrt(t51, w7)
    t53 = multiply(t49, t52, w5)
    t54 = multiply(t52, t53, w7)
    t55 = multiply(t26, t45, w6)
    t56 = subtract(t54, t55, w7)
    t57 = subtract(t53, t26, w5)
    t58 = divide(t56, t57, w7)
    t60 = multiply(t7, t58, w5)
    t61 = add(t60, t11, w5)
    t62 = sqrt(t61, w5)
    t63 = multiply(t62, n1, w6)
    t64 = add(t63, t9, w6)
    t65 = sqrt(t64, w6)
    t66 = multiply(t62, t65, w5)
    t67 = multiply(t65, t66, w6)
    t68 = multiply(t26, t58, w7)
    t69 = subtract(t67, t68, w6)
    t70 = subtract(t66, t26, w5)
    t71 = divide(t69, t70, w6)
    t73 = multiply(t7, t71, w2)
    t74 = add(t73, t11, w2)
    e = sqrt(t74, w2)
    t76 = multiply(e, n1, w4)
    t77 = add(t76, t9, w4)
    x = sqrt(t77, w4)
    t79 = multiply(e, n2, w2)
    t80 = add(t4, t79, w1)
    t81 = multiply(x, r, w4)
    t83 = multiply(t81, n5, w4)
    t84 = multiply(p, n6, pole_product)
    t85 = add(t83, t84, w4)
    t86 = add(t80, t85, w1)
    t87 = divide(n0, t86, w0)
    t88 = divide(t87, tracking_index, w0)
    divide(t88, t86, pole_product)


_POLE_PRODUCT = Signature(
    "pole_product",
    (_TRACKING_INDEX_DOMAIN,),
    ("pole_product",),
    9,
    _pole_product_block,
    numbers=_pole_product_of_numbers,
)


class PredictedCovariance(NamedTuple):
    """Result of `predicted_covariance`."""

    predicted_11: Real
    """Variance of the predicted position over sigma_v^2."""
    predicted_12: Real
    """Covariance of predicted position and velocity times T/sigma_v^2."""
    predicted_13: Real
    """Covariance of predicted position and acceleration times T^2/sigma_v^2."""
    predicted_22: Real
    """Variance of the predicted velocity times T^2/sigma_v^2."""
    predicted_23: Real
    """Covariance of predicted velocity and acceleration times T^3/sigma_v^2."""
    predicted_33: Real
    """Variance of the predicted acceleration times T^4/sigma_v^2."""


def predicted_covariance(
    tracking_index: ArrayLike,
    *,
    out: tuple[Real, Real, Real, Real, Real, Real] | None = None,
    workers: int = 1,
) -> PredictedCovariance:
    """Predicted covariance in units of sigma_v^2 and T.

        predicted_1j = sigma^2 (alpha, beta, gamma), sigma = Lambda nu/8,
        delta = 8/Lambda,
        xi = sqrt(2 + 2 eta), eta = sqrt(1 + 2 delta xi), nu = 1 + xi + eta + delta

    tracking_index: Lambda, with Lambda^2 =
        increment_deviation**2*sampling_interval**4/measurement_deviation**2; a number above 0 and
        finite.

    predicted_11: variance of the predicted position over sigma_v^2. Relative error at most 8.71 *
        2^-52 (float64), 8.73 * 2^-23 (float32), proved for 5e-324 <= tracking_index <=
        2.6815615859884855e154 (float64) and 1e-45 <= tracking_index <= 3.6893255e19 (float32).
    predicted_12: covariance of predicted position and velocity times T/sigma_v^2. Relative error at
        most 7.90 * 2^-52 (float64), 7.89 * 2^-23 (float32), proved for 5e-324 <= tracking_index <=
        1.8961503816218105e154 (float64) and 1e-45 <= tracking_index <= 2.6087464e19 (float32).
    predicted_13: covariance of predicted position and acceleration times T^2/sigma_v^2. Relative
        error at most 4.90 * 2^-52 (float64), 4.89 * 2^-23 (float32), proved for
        2.2250738585072014e-308 <= tracking_index <= 1.8961503816218218e154 (float64) and
        1.1754944e-38 <= tracking_index <= 2.6087534e19 (float32).
    predicted_22: variance of the predicted velocity times T^2/sigma_v^2. Relative error at most
        5.27 * 2^-52 (float64), 5.27 * 2^-23 (float32), proved for 7.416912861690675e-309 <=
        tracking_index <= 1.3407807929942426e154 (float64) and 3.918315e-39 <= tracking_index <=
        1.8446626e19 (float32).
    predicted_23: covariance of predicted velocity and acceleration times T^3/sigma_v^2. Relative
        error at most 6.40 * 2^-52 (float64), 6.40 * 2^-23 (float32), proved for
        1.0832677820940206e-231 <= tracking_index <= 1.3407807929942502e154 (float64) and
        2.122721e-29 <= tracking_index <= 1.8446673e19 (float32).
    predicted_33: variance of the predicted acceleration times T^4/sigma_v^2. Relative error at most
        5.42 * 2^-52 (float64), 5.42 * 2^-23 (float32), proved for 1.6896185209462645e-185 <=
        tracking_index <= 1.3407807929942502e154 (float64) and 1.1521641e-23 <= tracking_index <=
        1.8446673e19 (float32).

    Outside an output's range, a few numbers next to its ends apart, its true value is no normal
    number: it comes as 0, a subnormal number or infinity, never as NaN. Numbers and arrays are
    taken, arrays of any shape; inputs are broadcast. float64 and float32 stay what they are,
    integers become float64. `out`: a tuple of arrays to fill. `workers`: threads that share the
    work on long arrays.

    ValueError: an input outside its domain, with its place; `out` or `workers` that does not fit.
    TypeError: an input that is no real number of these types; in `out` what is no array of the
    results' type.

    Source: derivation wiener-acceleration
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
    t1 = form.sqrt(tracking_index)
    t2 = form.sqrt(t1)
    t4 = 1.0 / t1
    t7 = (t4 * t2) * 2.0
    t9 = t1 * 0.5
    t11 = tracking_index * 0.0625
    t12 = t1 * t2
    t17 = form.near_cbrt((t12 * 1.0) + (8.0 / t2))
    t22 = form.sqrt((t7 * t17) + t11)
    t25 = form.sqrt((t22 * 2.0) + t9)
    t26 = t7 * 0.5
    t27 = t22 * t25
    t32 = ((t25 * t27) - (t26 * t17)) / (t27 - t26)
    t36 = form.sqrt((t7 * t32) + t11)
    t39 = form.sqrt((t36 * 2.0) + t9)
    t40 = t36 * t39
    t45 = ((t39 * t40) - (t26 * t32)) / (t40 - t26)
    t49 = form.sqrt((t7 * t45) + t11)
    t52 = form.sqrt((t49 * 2.0) + t9)
    t53 = t49 * t52
    t58 = ((t52 * t53) - (t26 * t45)) / (t53 - t26)
    t62 = form.sqrt((t7 * t58) + t11)
    t65 = form.sqrt((t62 * 2.0) + t9)
    t66 = t62 * t65
    t71 = ((t65 * t66) - (t26 * t58)) / (t66 - t26)
    t75 = form.sqrt((t7 * t71) + t11)
    t78 = form.sqrt((t75 * 2.0) + t9)
    t80 = t1 * 0.25
    t84 = t78 * t2
    t88 = (t4 + (t75 * 0.5)) + ((t84 * 0.25) + (t1 * 0.125))
    t102 = (((t4 * 3.0) + t75) + t80) + ((t2 / t78) * (t75 + t80))
    t106 = t12 * t78
    t110 = ((t1 * t75) + (t106 * 0.5)) + (tracking_index * 0.25)
    t90 = ((t80 + t75) * t88) * tracking_index
    t92 = (t84 * t88) * tracking_index
    t94 = tracking_index * (t1 * t88)
    t104 = (t102 * t1) * tracking_index
    t111 = tracking_index * t110
    t112 = tracking_index * t106
    return (t90, t92, t94, t104, t111, t112)


def _predicted_covariance_block(
    given: Arrays,
    out: Arrays,
    work: Arrays,
    single: bool,
    n0: float = 1.0,
    n1: float = 2.0,
    n2: float = 0.5,
    n3: float = 0.0625,
    n4: float = 8.0,
    n5: float = 0.25,
    n6: float = 0.125,
    n7: float = 3.0,
) -> None:
    (tracking_index,) = given
    predicted_11, predicted_12, predicted_13, predicted_22, predicted_23, predicted_33 = out
    w0, w1, w2, w3, w4, w5 = work
    p = sqrt(tracking_index, predicted_11)
    r = sqrt(p, predicted_12)
    t4 = divide(n0, p, predicted_13)
    t5 = multiply(t4, r, w0)
    t7 = multiply(t5, n1, w0)
    t9 = multiply(p, n2, w1)
    t11 = multiply(tracking_index, n3, w2)
    t12 = multiply(p, r, w3)
    t13 = multiply(t12, n0, w4)
    t15 = divide(n4, r, predicted_22)
    t16 = add(t13, t15, w4)
    t17 = near_cbrt(t16, w4, single)
    t20 = multiply(t7, t17, predicted_22)
    t21 = add(t20, t11, predicted_22)
    t22 = sqrt(t21, predicted_23)
    t23 = multiply(t22, n1, predicted_22)
    t24 = add(t23, t9, predicted_22)
    t25 = sqrt(t24, predicted_33)
    t26 = multiply(t7, n2, predicted_22)
    t27 = multiply(t22, t25, predicted_23)
    t28 = multiply(t25, t27, predicted_33)
    t29 = multiply(t26, t17, w4)
    t30 = subtract(t28, t29, predicted_33)
    t31 = subtract(t27, t26, predicted_23)
    t32 = divide(t30, t31, predicted_33)
    t34 = multiply(t7, t32, w4)
    t35 = add(t34, t11, w4)
    t36 = sqrt(t35, w4)
    t37 = multiply(t36, n1, predicted_23)
    t38 = add(t37, t9, predicted_23)
    t39 = sqrt(t38, predicted_23)
    t40 = multiply(t36, t39, w4)
    t41 = multiply(t39, t40, predicted_23)
    t42 = multiply(t26, t32, predicted_33)
    t43 = subtract(t41, t42, predicted_23)
    t44 = subtract(t40, t26, w4)
    t45 = divide(t43, t44, predicted_23)
    t47 = multiply(t7, t45, w4)
    t48 = add(t47, t11, w4)
    t49 = sqrt(t48, w4)
    t50 = multiply(t49, n1, predicted_33)
    t51 = add(t50, t9, predicted_33)
    t52 = sqrt(t51, predicted_33)
    t53 = multiply(t49, t52, w4)
    t54 = multiply(t52, t53, predicted_33)
    t55 = multiply(t26, t45, predicted_23)
    t56 = subtract(t54, t55, predicted_33)
    t57 = subtract(t53, t26, w4)
    t58 = divide(t56, t57, predicted_33)
    t60 = multiply(t7, t58, w4)
    t61 = add(t60, t11, w4)
    t62 = sqrt(t61, w4)
    t63 = multiply(t62, n1, predicted_23)
    t64 = add(t63, t9, predicted_23)
    t65 = sqrt(t64, predicted_23)
    t66 = multiply(t62, t65, w4)
    t67 = multiply(t65, t66, predicted_23)
    t68 = multiply(t26, t58, predicted_33)
    t69 = subtract(t67, t68, predicted_23)
    t70 = subtract(t66, t26, w4)
    t71 = divide(t69, t70, predicted_23)
    t73 = multiply(t7, t71, w0)
    t74 = add(t73, t11, w0)
    e = sqrt(t74, w0)
    t76 = multiply(e, n1, w2)
    t77 = add(t76, t9, w2)
    x = sqrt(t77, w2)
    t80 = multiply(p, n5, w1)
    t81 = add(t80, e, w4)
    t82 = multiply(e, n2, predicted_22)
    t83 = add(t4, t82, predicted_22)
    t84 = multiply(x, r, predicted_23)
    t85 = multiply(t84, n5, predicted_33)
    t86 = multiply(p, n6, w5)
    t87 = add(t85, t86, predicted_33)
    t88 = add(t83, t87, predicted_22)
    t89 = multiply(t81, t88, w4)
    t91 = multiply(t84, t88, predicted_23)
    t93 = multiply(p, t88, predicted_22)
    t96 = multiply(t4, n7, predicted_13)
    t97 = add(t96, e, predicted_13)
    t98 = add(t97, t80, predicted_13)
    t99 = divide(r, x, predicted_12)
    t100 = add(e, t80, w1)
    t101 = multiply(t99, t100, predicted_12)
    t102 = add(t98, t101, predicted_13)
    t103 = multiply(t102, p, w1)
    t105 = multiply(p, e, predicted_11)
    t106 = multiply(t12, x, w3)
    t107 = multiply(t106, n2, w0)
    t108 = add(t105, t107, predicted_11)
    t109 = multiply(tracking_index, n5, w0)
    t110 = add(t108, t109, w0)
    multiply(t89, tracking_index, predicted_11)
    multiply(t91, tracking_index, predicted_12)
    multiply(tracking_index, t93, predicted_13)
    multiply(t103, tracking_index, predicted_22)
    multiply(tracking_index, t110, predicted_23)
    multiply(tracking_index, t106, predicted_33)


_PREDICTED_COVARIANCE = Signature(
    "predicted_covariance",
    (_TRACKING_INDEX_DOMAIN,),
    (
        "predicted_11",
        "predicted_12",
        "predicted_13",
        "predicted_22",
        "predicted_23",
        "predicted_33",
    ),
    6,
    _predicted_covariance_block,
    numbers=_predicted_covariance_of_numbers,
)


class PredictedCovarianceDerivatives(NamedTuple):
    """Result of `predicted_covariance_derivatives`."""

    predicted_11: Real
    """Derivative of the variance of the predicted position over sigma_v^2."""
    predicted_12: Real
    """Derivative of the covariance of predicted position and velocity times T/sigma_v^2."""
    predicted_13: Real
    """Derivative of the covariance of predicted position and acceleration times T^2/sigma_v^2."""
    predicted_22: Real
    """Derivative of the variance of the predicted velocity times T^2/sigma_v^2."""
    predicted_23: Real
    """Derivative of the covariance of predicted velocity and acceleration times T^3/sigma_v^2."""
    predicted_33: Real
    """Derivative of the variance of the predicted acceleration times T^4/sigma_v^2."""


def predicted_covariance_derivatives(
    tracking_index: ArrayLike,
    *,
    out: tuple[Real, Real, Real, Real, Real, Real] | None = None,
    workers: int = 1,
) -> PredictedCovarianceDerivatives:
    """First derivatives of the predicted covariance.

        delta = 8/Lambda,
        xi = sqrt(2 + 2 eta), eta = sqrt(1 + 2 delta xi), nu = 1 + xi + eta + delta

    tracking_index: Lambda, with Lambda^2 =
        increment_deviation**2*sampling_interval**4/measurement_deviation**2; a number above 0 and
        at most 2^1000, in float32 above 0 and at most 2^120.

    predicted_11: derivative of the variance of the predicted position over sigma_v^2. Relative
        error at most 11.42 * 2^-52 (float64), 11.42 * 2^-23 (float32), proved for 5e-324 <=
        tracking_index <= 1.0715086071862673e301 (float64) and 1e-45 <= tracking_index <=
        1.329228e36 (float32).
    predicted_12: derivative of the covariance of predicted position and velocity times T/sigma_v^2.
        Relative error at most 10.91 * 2^-52 (float64), 10.91 * 2^-23 (float32), proved for 5e-324
        <= tracking_index <= 1.0715086071862673e301 (float64) and 1e-45 <= tracking_index <=
        1.329228e36 (float32).
    predicted_13: derivative of the covariance of predicted position and acceleration times
        T^2/sigma_v^2. Relative error at most 6.93 * 2^-52 (float64), 6.92 * 2^-23 (float32), proved
        for 5e-324 <= tracking_index <= 1.0715086071862673e301 (float64) and 1e-45 <= tracking_index
        <= 1.329228e36 (float32).
    predicted_22: derivative of the variance of the predicted velocity times T^2/sigma_v^2. Relative
        error at most 6.04 * 2^-52 (float64), 6.04 * 2^-23 (float32), proved for 5e-324 <=
        tracking_index <= 1.0715086071862673e301 (float64) and 1e-45 <= tracking_index <=
        1.329228e36 (float32).
    predicted_23: derivative of the covariance of predicted velocity and acceleration times
        T^3/sigma_v^2. Relative error at most 7.79 * 2^-52 (float64), 7.79 * 2^-23 (float32), proved
        for 5e-324 <= tracking_index <= 1.0715086071862673e301 (float64) and 1e-45 <= tracking_index
        <= 1.329228e36 (float32).
    predicted_33: derivative of the variance of the predicted acceleration times T^4/sigma_v^2.
        Relative error at most 7.13 * 2^-52 (float64), 7.12 * 2^-23 (float32), proved for 5e-324 <=
        tracking_index <= 1.0715086071862673e301 (float64) and 1e-45 <= tracking_index <=
        1.329228e36 (float32).

    Outside an output's range, a few numbers next to its ends apart, its true value is no normal
    number: it comes as 0, a subnormal number or infinity, never as NaN. Numbers and arrays are
    taken, arrays of any shape; inputs are broadcast. float64 and float32 stay what they are,
    integers become float64. `out`: a tuple of arrays to fill. `workers`: threads that share the
    work on long arrays.

    ValueError: an input outside its domain, with its place; `out` or `workers` that does not fit.
    TypeError: an input that is no real number of these types; in `out` what is no array of the
    results' type.

    Source: derivation wiener-acceleration
    """
    if (
        type(tracking_index) is float
        and 5e-324 <= tracking_index <= 1.0715086071862673e301
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
    t1 = form.sqrt(tracking_index)
    t2 = form.sqrt(t1)
    t4 = 1.0 / t1
    t7 = (t4 * t2) * 2.0
    t9 = t1 * 0.5
    t11 = tracking_index * 0.0625
    t12 = t1 * t2
    t17 = form.near_cbrt((t12 * 1.0) + (8.0 / t2))
    t22 = form.sqrt((t7 * t17) + t11)
    t25 = form.sqrt((t22 * 2.0) + t9)
    t26 = t7 * 0.5
    t27 = t22 * t25
    t32 = ((t25 * t27) - (t26 * t17)) / (t27 - t26)
    t36 = form.sqrt((t7 * t32) + t11)
    t39 = form.sqrt((t36 * 2.0) + t9)
    t40 = t36 * t39
    t45 = ((t39 * t40) - (t26 * t32)) / (t40 - t26)
    t49 = form.sqrt((t7 * t45) + t11)
    t52 = form.sqrt((t49 * 2.0) + t9)
    t53 = t49 * t52
    t58 = ((t52 * t53) - (t26 * t45)) / (t53 - t26)
    t62 = form.sqrt((t7 * t58) + t11)
    t65 = form.sqrt((t62 * 2.0) + t9)
    t66 = t62 * t65
    t71 = ((t65 * t66) - (t26 * t58)) / (t66 - t26)
    t75 = form.sqrt((t7 * t71) + t11)
    t78 = form.sqrt((t75 * 2.0) + t9)
    t80 = t1 * 0.25
    t82 = t78 * t2
    t83 = t75 * t75
    t86 = t1 * t75
    t90 = tracking_index * 0.015625
    t91 = ((t83 * 0.75) + (t86 * 0.25)) + t90
    t93 = t82 * 0.25
    t94 = ((t75 + t80) / t91) * t93
    t100 = (t4 + (t75 * 0.5)) + (t93 + (t1 * 0.125))
    t107 = ((t83 * 0.25) + (t86 * 0.125)) + t90
    t109 = (t107 / t91) * 2.0
    t112 = t1 * t100
    t121 = tracking_index * (((t80 / t75) * 2.0) + 2.0)
    t125 = 1.0 + ((t107 + (t121 * 0.015625)) / t91)
    t126 = t125 * t75
    t133 = (((t82 / t91) / tracking_index) / t4) * 0.5
    t139 = ((t125 + t133) * t75) + (((2.0 + t133) * t1) * 0.25)
    t141 = (((t4 * 3.0) + t126) + t9) + ((t2 / t78) * t139)
    t143 = 1.0 + t109
    t102 = ((t94 * 2.0) * t100) * t100
    t113 = ((t78 / t2) * (t109 + t94)) * t112
    t115 = t112 * (t94 + 1.0)
    t142 = t141 * t1
    t148 = ((((t143 * t82) * 0.5) + t126) + t9) * t1
    t150 = (t12 * t78) * t143
    return (t102, t113, t115, t142, t148, t150)


def _predicted_covariance_derivatives_block(
    given: Arrays,
    out: Arrays,
    work: Arrays,
    single: bool,
    n0: float = 1.0,
    n1: float = 2.0,
    n2: float = 0.5,
    n3: float = 0.0625,
    n4: float = 8.0,
    n5: float = 0.25,
    n6: float = 0.75,
    n7: float = 0.015625,
    n8: float = 0.125,
    n9: float = 3.0,
) -> None:
    (tracking_index,) = given
    predicted_11, predicted_12, predicted_13, predicted_22, predicted_23, predicted_33 = out
    w0, w1, w2, w3, w4, w5, w6, w7, w8, w9, w10, w11 = work
    p = sqrt(tracking_index, predicted_23)
    r = sqrt(p, predicted_11)
    t4 = divide(n0, p, predicted_12)
    t5 = multiply(t4, r, w0)
    t7 = multiply(t5, n1, w0)
    t9 = multiply(p, n2, w1)
    t11 = multiply(tracking_index, n3, w2)
    t12 = multiply(p, r, w3)
    t13 = multiply(t12, n0, w4)
    t15 = divide(n4, r, predicted_13)
    t16 = add(t13, t15, w4)
    t17 = near_cbrt(t16, w4, single)
    t20 = multiply(t7, t17, predicted_13)
    t21 = add(t20, t11, predicted_13)
    t22 = sqrt(t21, predicted_22)
    t23 = multiply(t22, n1, predicted_13)
    t24 = add(t23, t9, predicted_13)
    t25 = sqrt(t24, predicted_33)
    t26 = multiply(t7, n2, predicted_13)
    t27 = multiply(t22, t25, predicted_22)
    t28 = multiply(t25, t27, predicted_33)
    t29 = multiply(t26, t17, w4)
    t30 = subtract(t28, t29, predicted_33)
    t31 = subtract(t27, t26, predicted_22)
    t32 = divide(t30, t31, predicted_33)
    t34 = multiply(t7, t32, w4)
    t35 = add(t34, t11, w4)
    t36 = sqrt(t35, w4)
    t37 = multiply(t36, n1, predicted_22)
    t38 = add(t37, t9, predicted_22)
    t39 = sqrt(t38, predicted_22)
    t40 = multiply(t36, t39, w4)
    t41 = multiply(t39, t40, predicted_22)
    t42 = multiply(t26, t32, predicted_33)
    t43 = subtract(t41, t42, predicted_22)
    t44 = subtract(t40, t26, w4)
    t45 = divide(t43, t44, predicted_22)
    t47 = multiply(t7, t45, w4)
    t48 = add(t47, t11, w4)
    t49 = sqrt(t48, w4)
    t50 = multiply(t49, n1, predicted_33)
    t51 = add(t50, t9, predicted_33)
    t52 = sqrt(t51, predicted_33)
    t53 = multiply(t49, t52, w4)
    t54 = multiply(t52, t53, predicted_33)
    t55 = multiply(t26, t45, predicted_22)
    t56 = subtract(t54, t55, predicted_33)
    t57 = subtract(t53, t26, w4)
    t58 = divide(t56, t57, predicted_33)
    t60 = multiply(t7, t58, w4)
    t61 = add(t60, t11, w4)
    t62 = sqrt(t61, w4)
    t63 = multiply(t62, n1, predicted_22)
    t64 = add(t63, t9, predicted_22)
    t65 = sqrt(t64, predicted_22)
    t66 = multiply(t62, t65, w4)
    t67 = multiply(t65, t66, predicted_22)
    t68 = multiply(t26, t58, predicted_33)
    t69 = subtract(t67, t68, predicted_22)
    t70 = subtract(t66, t26, w4)
    t71 = divide(t69, t70, predicted_22)
    t73 = multiply(t7, t71, w0)
    t74 = add(t73, t11, w0)
    e = sqrt(t74, w0)
    t76 = multiply(e, n1, w2)
    t77 = add(t76, t9, w2)
    x = sqrt(t77, w2)
    t80 = multiply(p, n5, w4)
    t81 = add(e, t80, predicted_13)
    t82 = multiply(x, r, predicted_22)
    t83 = square(e, predicted_33)
    t85 = multiply(t83, n6, w5)
    t86 = multiply(p, e, w6)
    t87 = multiply(t86, n5, w7)
    t88 = add(t85, t87, w5)
    t90 = multiply(tracking_index, n7, w7)
    t91 = add(t88, t90, w5)
    t92 = divide(t81, t91, predicted_13)
    t93 = multiply(t82, n5, w8)
    t94 = multiply(t92, t93, predicted_13)
    t95 = multiply(t94, n1, w9)
    t96 = multiply(e, n2, w10)
    t97 = add(t4, t96, w10)
    t98 = multiply(p, n8, w11)
    t99 = add(t93, t98, w8)
    t100 = add(t97, t99, w10)
    t101 = multiply(t95, t100, w9)
    t103 = divide(x, r, w8)
    t104 = multiply(t83, n5, predicted_33)
    t105 = multiply(t86, n8, w6)
    t106 = add(t104, t105, predicted_33)
    t107 = add(t106, t90, predicted_33)
    t108 = divide(t107, t91, w6)
    t109 = multiply(t108, n1, w6)
    t110 = add(t109, t94, w7)
    t111 = multiply(t103, t110, w8)
    t112 = multiply(p, t100, w7)
    t114 = add(t94, n0, predicted_13)
    t117 = multiply(t4, n9, w11)
    t118 = divide(t80, e, w4)
    t119 = multiply(t118, n1, w4)
    t120 = add(t119, n1, w4)
    t121 = multiply(tracking_index, t120, w4)
    t122 = multiply(t121, n7, w4)
    t123 = add(t107, t122, predicted_33)
    t124 = divide(t123, t91, predicted_33)
    t125 = add(n0, t124, predicted_33)
    t126 = multiply(t125, e, w4)
    t127 = add(t117, t126, w11)
    t128 = add(t127, t9, w11)
    t129 = divide(r, x, predicted_11)
    t130 = divide(t82, t91, w5)
    t131 = divide(t130, tracking_index, w5)
    t132 = divide(t131, t4, w5)
    t133 = multiply(t132, n2, w5)
    t134 = add(t125, t133, predicted_33)
    t135 = multiply(t134, e, predicted_33)
    t136 = add(n1, t133, w5)
    t137 = multiply(t136, p, w5)
    t138 = multiply(t137, n5, w5)
    t139 = add(t135, t138, predicted_33)
    t140 = multiply(t129, t139, predicted_11)
    t141 = add(t128, t140, w11)
    t143 = add(n0, t109, w6)
    t144 = multiply(t143, t82, predicted_22)
    t145 = multiply(t144, n2, predicted_22)
    t146 = add(t145, t126, predicted_22)
    t147 = add(t146, t9, w1)
    t149 = multiply(t12, x, w3)
    multiply(t101, t100, predicted_11)
    multiply(t111, t112, predicted_12)
    multiply(t112, t114, predicted_13)
    multiply(t141, p, predicted_22)
    multiply(t147, p, predicted_23)
    multiply(t149, t143, predicted_33)


_PREDICTED_COVARIANCE_DERIVATIVES = Signature(
    "predicted_covariance_derivatives",
    (_TRACKING_INDEX_DOMAIN_2,),
    (
        "predicted_11",
        "predicted_12",
        "predicted_13",
        "predicted_22",
        "predicted_23",
        "predicted_33",
    ),
    12,
    _predicted_covariance_derivatives_block,
    numbers=_predicted_covariance_derivatives_of_numbers,
)


class UpdatedCovariance(NamedTuple):
    """Result of `updated_covariance`."""

    updated_11: Real
    """Variance of the updated position over sigma_v^2."""
    updated_12: Real
    """Covariance of updated position and velocity times T/sigma_v^2."""
    updated_13: Real
    """Covariance of updated position and acceleration times T^2/sigma_v^2."""
    updated_22: Real
    """Variance of the updated velocity times T^2/sigma_v^2."""
    updated_23: Real
    """Covariance of updated velocity and acceleration times T^3/sigma_v^2."""
    updated_33: Real
    """Variance of the updated acceleration times T^4/sigma_v^2."""


def updated_covariance(
    tracking_index: ArrayLike,
    *,
    out: tuple[Real, Real, Real, Real, Real, Real] | None = None,
    workers: int = 1,
) -> UpdatedCovariance:
    """Updated covariance in units of sigma_v^2 and T.

        updated_1j = (alpha, beta, gamma),
        delta = 8/Lambda,
        xi = sqrt(2 + 2 eta), eta = sqrt(1 + 2 delta xi), nu = 1 + xi + eta + delta

    tracking_index: Lambda, with Lambda^2 =
        increment_deviation**2*sampling_interval**4/measurement_deviation**2; a number above 0 and
        finite.

    updated_11: variance of the updated position over sigma_v^2. Relative error at most 6.18 * 2^-52
        (float64), 6.18 * 2^-23 (float32), proved for 5e-324 <= tracking_index <=
        1.7976931348623157e308 (float64) and 1e-45 <= tracking_index <= 3.4028235e38 (float32).
    updated_12: covariance of updated position and velocity times T/sigma_v^2. Relative error at
        most 6.09 * 2^-52 (float64), 6.09 * 2^-23 (float32), proved for 5e-324 <= tracking_index <=
        1.7976931348623157e308 (float64) and 1e-45 <= tracking_index <= 3.4028235e38 (float32).
    updated_13: covariance of updated position and acceleration times T^2/sigma_v^2. Relative error
        at most 4.55 * 2^-52 (float64), 4.55 * 2^-23 (float32), proved for 2.2250738585072014e-308
        <= tracking_index <= 1.7976931348623157e308 (float64) and 1.1754945e-38 <= tracking_index <=
        3.4028235e38 (float32).
    updated_22: variance of the updated velocity times T^2/sigma_v^2. Relative error at most 6.26 *
        2^-52 (float64), 6.26 * 2^-23 (float32), proved for 7.416912861690675e-309 <= tracking_index
        <= 1.7976931348622031e308 (float64) and 3.918315e-39 <= tracking_index <= 3.4027178e38
        (float32).
    updated_23: covariance of updated velocity and acceleration times T^3/sigma_v^2. Relative error
        at most 4.76 * 2^-52 (float64), 4.76 * 2^-23 (float32), proved for 1.0832677820940206e-231
        <= tracking_index <= 8.988465674311451e307 (float64) and 2.122721e-29 <= tracking_index <=
        1.7013988e38 (float32).
    updated_33: variance of the updated acceleration times T^4/sigma_v^2. Relative error at most
        9.01 * 2^-52 (float64), 9.01 * 2^-23 (float32), proved for 1.6896185209462645e-185 <=
        tracking_index <= 4.4942328371556725e307 (float64) and 1.1521641e-23 <= tracking_index <=
        8.5069486e37 (float32).

    Outside an output's range, a few numbers next to its ends apart, its true value is no normal
    number: it comes as 0, a subnormal number or infinity, never as NaN. Numbers and arrays are
    taken, arrays of any shape; inputs are broadcast. float64 and float32 stay what they are,
    integers become float64. `out`: a tuple of arrays to fill. `workers`: threads that share the
    work on long arrays.

    ValueError: an input outside its domain, with its place; `out` or `workers` that does not fit.
    TypeError: an input that is no real number of these types; in `out` what is no array of the
    results' type.

    Source: derivation wiener-acceleration
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
    t1 = form.sqrt(tracking_index)
    t2 = form.sqrt(t1)
    t4 = 1.0 / t1
    t7 = (t4 * t2) * 2.0
    t9 = t1 * 0.5
    t11 = tracking_index * 0.0625
    t17 = form.near_cbrt(((t1 * t2) * 1.0) + (8.0 / t2))
    t22 = form.sqrt((t7 * t17) + t11)
    t25 = form.sqrt((t22 * 2.0) + t9)
    t26 = t7 * 0.5
    t27 = t22 * t25
    t32 = ((t25 * t27) - (t26 * t17)) / (t27 - t26)
    t36 = form.sqrt((t7 * t32) + t11)
    t39 = form.sqrt((t36 * 2.0) + t9)
    t40 = t36 * t39
    t45 = ((t39 * t40) - (t26 * t32)) / (t40 - t26)
    t49 = form.sqrt((t7 * t45) + t11)
    t52 = form.sqrt((t49 * 2.0) + t9)
    t53 = t49 * t52
    t58 = ((t52 * t53) - (t26 * t45)) / (t53 - t26)
    t62 = form.sqrt((t7 * t58) + t11)
    t65 = form.sqrt((t62 * 2.0) + t9)
    t66 = t62 * t65
    t71 = ((t65 * t66) - (t26 * t58)) / (t66 - t26)
    t75 = form.sqrt((t7 * t71) + t11)
    t78 = form.sqrt((t75 * 2.0) + t9)
    t84 = t78 * t2
    t88 = (t4 + (t75 * 0.5)) + ((t84 * 0.25) + (t1 * 0.125))
    t92 = t78 + t2
    t98 = ((((8.0 / t92) / t78) / t84) + 2.0) * (t78 / t92)
    t102 = (t2 / t92) * 4.0
    t89 = (t75 + (t1 * 0.25)) / t88
    t90 = t84 / t88
    t91 = t1 / t88
    t99 = tracking_index * t98
    t103 = tracking_index * t102
    t107 = tracking_index * (t102 * ((t2 / t78) * 2.0))
    return (t89, t90, t91, t99, t103, t107)


def _updated_covariance_block(
    given: Arrays,
    out: Arrays,
    work: Arrays,
    single: bool,
    n0: float = 1.0,
    n1: float = 2.0,
    n2: float = 0.5,
    n3: float = 0.0625,
    n4: float = 8.0,
    n5: float = 0.25,
    n6: float = 0.125,
    n7: float = 4.0,
) -> None:
    (tracking_index,) = given
    updated_11, updated_12, updated_13, updated_22, updated_23, updated_33 = out
    w0, w1, w2, w3 = work
    p = sqrt(tracking_index, updated_13)
    r = sqrt(p, updated_11)
    t4 = divide(n0, p, updated_12)
    t5 = multiply(t4, r, w0)
    t7 = multiply(t5, n1, w0)
    t9 = multiply(p, n2, w1)
    t11 = multiply(tracking_index, n3, w2)
    t12 = multiply(p, r, w3)
    t13 = multiply(t12, n0, w3)
    t15 = divide(n4, r, updated_22)
    t16 = add(t13, t15, w3)
    t17 = near_cbrt(t16, w3, single)
    t20 = multiply(t7, t17, updated_22)
    t21 = add(t20, t11, updated_22)
    t22 = sqrt(t21, updated_23)
    t23 = multiply(t22, n1, updated_22)
    t24 = add(t23, t9, updated_22)
    t25 = sqrt(t24, updated_33)
    t26 = multiply(t7, n2, updated_22)
    t27 = multiply(t22, t25, updated_23)
    t28 = multiply(t25, t27, updated_33)
    t29 = multiply(t26, t17, w3)
    t30 = subtract(t28, t29, updated_33)
    t31 = subtract(t27, t26, updated_23)
    t32 = divide(t30, t31, updated_33)
    t34 = multiply(t7, t32, w3)
    t35 = add(t34, t11, w3)
    t36 = sqrt(t35, w3)
    t37 = multiply(t36, n1, updated_23)
    t38 = add(t37, t9, updated_23)
    t39 = sqrt(t38, updated_23)
    t40 = multiply(t36, t39, w3)
    t41 = multiply(t39, t40, updated_23)
    t42 = multiply(t26, t32, updated_33)
    t43 = subtract(t41, t42, updated_23)
    t44 = subtract(t40, t26, w3)
    t45 = divide(t43, t44, updated_23)
    t47 = multiply(t7, t45, w3)
    t48 = add(t47, t11, w3)
    t49 = sqrt(t48, w3)
    t50 = multiply(t49, n1, updated_33)
    t51 = add(t50, t9, updated_33)
    t52 = sqrt(t51, updated_33)
    t53 = multiply(t49, t52, w3)
    t54 = multiply(t52, t53, updated_33)
    t55 = multiply(t26, t45, updated_23)
    t56 = subtract(t54, t55, updated_33)
    t57 = subtract(t53, t26, w3)
    t58 = divide(t56, t57, updated_33)
    t60 = multiply(t7, t58, w3)
    t61 = add(t60, t11, w3)
    t62 = sqrt(t61, w3)
    t63 = multiply(t62, n1, updated_23)
    t64 = add(t63, t9, updated_23)
    t65 = sqrt(t64, updated_23)
    t66 = multiply(t62, t65, w3)
    t67 = multiply(t65, t66, updated_23)
    t68 = multiply(t26, t58, updated_33)
    t69 = subtract(t67, t68, updated_23)
    t70 = subtract(t66, t26, w3)
    t71 = divide(t69, t70, updated_23)
    t73 = multiply(t7, t71, w0)
    t74 = add(t73, t11, w0)
    e = sqrt(t74, w0)
    t76 = multiply(e, n1, w2)
    t77 = add(t76, t9, w2)
    x = sqrt(t77, w2)
    t80 = multiply(p, n5, w1)
    t81 = add(e, t80, w1)
    t82 = multiply(e, n2, w0)
    t83 = add(t4, t82, updated_12)
    t84 = multiply(x, r, w0)
    t85 = multiply(t84, n5, w3)
    t86 = multiply(p, n6, updated_22)
    t87 = add(t85, t86, w3)
    t88 = add(t83, t87, w3)
    t92 = add(x, r, updated_12)
    t93 = divide(n4, t92, updated_22)
    t94 = divide(t93, x, updated_22)
    t95 = divide(t94, t84, updated_22)
    t96 = add(t95, n1, updated_22)
    t97 = divide(x, t92, updated_23)
    t98 = multiply(t96, t97, updated_22)
    t100 = divide(r, t92, updated_12)
    t102 = multiply(t100, n7, updated_23)
    t104 = divide(r, x, updated_11)
    t105 = multiply(t104, n1, updated_11)
    t106 = multiply(t102, t105, w2)
    divide(t81, t88, updated_11)
    divide(t84, t88, updated_12)
    divide(p, t88, updated_13)
    multiply(tracking_index, t98, updated_22)
    multiply(tracking_index, t102, updated_23)
    multiply(tracking_index, t106, updated_33)


_UPDATED_COVARIANCE = Signature(
    "updated_covariance",
    (_TRACKING_INDEX_DOMAIN,),
    ("updated_11", "updated_12", "updated_13", "updated_22", "updated_23", "updated_33"),
    4,
    _updated_covariance_block,
    numbers=_updated_covariance_of_numbers,
)


class UpdatedCovarianceDerivatives(NamedTuple):
    """Result of `updated_covariance_derivatives`."""

    updated_11: Real
    """Derivative of the variance of the updated position over sigma_v^2."""
    updated_12: Real
    """Derivative of the covariance of updated position and velocity times T/sigma_v^2."""
    updated_13: Real
    """Derivative of the covariance of updated position and acceleration times T^2/sigma_v^2."""
    updated_22: Real
    """Derivative of the variance of the updated velocity times T^2/sigma_v^2."""
    updated_23: Real
    """Derivative of the covariance of updated velocity and acceleration times T^3/sigma_v^2."""
    updated_33: Real
    """Derivative of the variance of the updated acceleration times T^4/sigma_v^2."""


def updated_covariance_derivatives(
    tracking_index: ArrayLike,
    *,
    out: tuple[Real, Real, Real, Real, Real, Real] | None = None,
    workers: int = 1,
) -> UpdatedCovarianceDerivatives:
    """First derivatives of the updated covariance.

        delta = 8/Lambda,
        xi = sqrt(2 + 2 eta), eta = sqrt(1 + 2 delta xi), nu = 1 + xi + eta + delta

    tracking_index: Lambda, with Lambda^2 =
        increment_deviation**2*sampling_interval**4/measurement_deviation**2; a number above 0 and
        at most 2^1000, in float32 above 0 and at most 2^120.

    updated_11: derivative of the variance of the updated position over sigma_v^2. Relative error at
        most 14.16 * 2^-52 (float64), 14.16 * 2^-23 (float32), proved for 5e-324 <= tracking_index
        <= 7.11074631974658e102 (float64) and 1e-45 <= tracking_index <= 8.7960925e12 (float32).
    updated_12: derivative of the covariance of updated position and velocity times T/sigma_v^2.
        Relative error at most 10.46 * 2^-52 (float64), 10.45 * 2^-23 (float32), proved for 5e-324
        <= tracking_index <= 1.8961503816218352e154 (float64) and 1e-45 <= tracking_index <=
        2.6087635e19 (float32).
    updated_13: derivative of the covariance of updated position and acceleration times
        T^2/sigma_v^2. Relative error at most 12.38 * 2^-52 (float64), 12.38 * 2^-23 (float32),
        proved for 5e-324 <= tracking_index <= 2.6815615859885194e154 (float64) and 1e-45 <=
        tracking_index <= 3.689349e19 (float32).
    updated_22: derivative of the variance of the updated velocity times T^2/sigma_v^2. Relative
        error at most 9.24 * 2^-52 (float64), 9.23 * 2^-23 (float32), proved for 5e-324 <=
        tracking_index <= 1.0715086071862673e301 (float64) and 1e-45 <= tracking_index <=
        1.329228e36 (float32).
    updated_23: derivative of the covariance of updated velocity and acceleration times
        T^3/sigma_v^2. Relative error at most 8.64 * 2^-52 (float64), 8.64 * 2^-23 (float32), proved
        for 5e-324 <= tracking_index <= 1.0715086071862673e301 (float64) and 1e-45 <= tracking_index
        <= 1.329228e36 (float32).
    updated_33: derivative of the variance of the updated acceleration times T^4/sigma_v^2. Relative
        error at most 13.92 * 2^-52 (float64), 13.92 * 2^-23 (float32), proved for 5e-324 <=
        tracking_index <= 1.0715086071862673e301 (float64) and 1e-45 <= tracking_index <=
        1.329228e36 (float32).

    Outside an output's range, a few numbers next to its ends apart, its true value is no normal
    number: it comes as 0, a subnormal number or infinity, never as NaN. Numbers and arrays are
    taken, arrays of any shape; inputs are broadcast. float64 and float32 stay what they are,
    integers become float64. `out`: a tuple of arrays to fill. `workers`: threads that share the
    work on long arrays.

    ValueError: an input outside its domain, with its place; `out` or `workers` that does not fit.
    TypeError: an input that is no real number of these types; in `out` what is no array of the
    results' type.

    Source: derivation wiener-acceleration
    """
    if (
        type(tracking_index) is float
        and 5e-324 <= tracking_index <= 1.0715086071862673e301
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
    t2 = form.sqrt(t1)
    t4 = 1.0 / t1
    t7 = (t4 * t2) * 2.0
    t9 = t1 * 0.5
    t11 = tracking_index * 0.0625
    t17 = form.near_cbrt(((t1 * t2) * 1.0) + (8.0 / t2))
    t22 = form.sqrt((t7 * t17) + t11)
    t25 = form.sqrt((t22 * 2.0) + t9)
    t26 = t7 * 0.5
    t27 = t22 * t25
    t32 = ((t25 * t27) - (t26 * t17)) / (t27 - t26)
    t36 = form.sqrt((t7 * t32) + t11)
    t39 = form.sqrt((t36 * 2.0) + t9)
    t40 = t36 * t39
    t45 = ((t39 * t40) - (t26 * t32)) / (t40 - t26)
    t49 = form.sqrt((t7 * t45) + t11)
    t52 = form.sqrt((t49 * 2.0) + t9)
    t53 = t49 * t52
    t58 = ((t52 * t53) - (t26 * t45)) / (t53 - t26)
    t62 = form.sqrt((t7 * t58) + t11)
    t65 = form.sqrt((t62 * 2.0) + t9)
    t66 = t62 * t65
    t71 = ((t65 * t66) - (t26 * t58)) / (t66 - t26)
    t75 = form.sqrt((t7 * t71) + t11)
    t78 = form.sqrt((t75 * 2.0) + t9)
    t81 = (t1 * 0.25) + t75
    t85 = (tracking_index / t2) * 0.020833333333333332
    t89 = t85 + ((t2 * t75) * 0.3333333333333333)
    t92 = t89 + ((t75 / t2) * t75)
    t95 = ((t2 * t81) / t92) * 0.16666666666666666
    t99 = t2 / t78
    t100 = ((t95 + 1.0) * 1.3333333333333333) * t99
    t104 = t78 * t2
    t108 = (t4 + (t75 * 0.5)) + ((t104 * 0.25) + (t1 * 0.125))
    t110 = ((t100 / tracking_index) / t108) / t108
    t115 = (((t2 + t78) * t81) / t92) * 0.16666666666666666
    t120 = ((t115 + 1.0) + (t78 / t2)) * 0.6666666666666666
    t127 = (((t2 * 0.5) + t78) * t81) * 0.6666666666666666
    t131 = (((t127 / t92) + 1.0) / t108) / tracking_index
    t133 = t99 * 0.5
    t139 = t78 + t2
    t142 = ((8.0 / t139) / t78) / t104
    t146 = ((t133 * t133) * ((t133 * 8.0) + 4.0)) + ((t142 * 7.0) + 2.0)
    t150 = (t142 * ((t133 * 2.0) + 1.0)) + 2.0
    t158 = (((t142 * (t133 + 1.0)) + 1.0) / t150) * 2.0
    t160 = (t2 / t139) * 4.0
    t169 = ((t142 * ((t133 * 4.0) + 3.0)) + 2.0) / t150
    t111 = t110 / tracking_index
    t123 = ((t120 / t108) / t108) / tracking_index
    t132 = t131 / t108
    t153 = (t146 / t150) * (t78 / t139)
    t161 = t158 * t160
    t170 = (t160 * (t99 * 2.0)) * t169
    return (t111, t123, t132, t153, t161, t170)


def _updated_covariance_derivatives_block(
    given: Arrays,
    out: Arrays,
    work: Arrays,
    single: bool,
    n0: float = 1.0,
    n1: float = 2.0,
    n2: float = 0.5,
    n3: float = 0.0625,
    n4: float = 8.0,
    n5: float = 0.25,
    n6: float = 0.020833333333333332,
    n7: float = 0.3333333333333333,
    n8: float = 0.16666666666666666,
    n9: float = 1.3333333333333333,
    n10: float = 0.125,
    n11: float = 0.6666666666666666,
    n12: float = 4.0,
    n13: float = 7.0,
    n14: float = 3.0,
) -> None:
    (tracking_index,) = given
    updated_11, updated_12, updated_13, updated_22, updated_23, updated_33 = out
    w0, w1, w2, w3, w4, w5, w6, w7 = work
    p = sqrt(tracking_index, updated_11)
    r = sqrt(p, updated_12)
    t4 = divide(n0, p, updated_13)
    t5 = multiply(t4, r, w0)
    t7 = multiply(t5, n1, w0)
    t9 = multiply(p, n2, w1)
    t11 = multiply(tracking_index, n3, w2)
    t12 = multiply(p, r, w3)
    t13 = multiply(t12, n0, w3)
    t15 = divide(n4, r, updated_22)
    t16 = add(t13, t15, w3)
    t17 = near_cbrt(t16, w3, single)
    t20 = multiply(t7, t17, updated_22)
    t21 = add(t20, t11, updated_22)
    t22 = sqrt(t21, updated_23)
    t23 = multiply(t22, n1, updated_22)
    t24 = add(t23, t9, updated_22)
    t25 = sqrt(t24, updated_33)
    t26 = multiply(t7, n2, updated_22)
    t27 = multiply(t22, t25, updated_23)
    t28 = multiply(t25, t27, updated_33)
    t29 = multiply(t26, t17, w3)
    t30 = subtract(t28, t29, updated_33)
    t31 = subtract(t27, t26, updated_23)
    t32 = divide(t30, t31, updated_33)
    t34 = multiply(t7, t32, w3)
    t35 = add(t34, t11, w3)
    t36 = sqrt(t35, w3)
    t37 = multiply(t36, n1, updated_23)
    t38 = add(t37, t9, updated_23)
    t39 = sqrt(t38, updated_23)
    t40 = multiply(t36, t39, w3)
    t41 = multiply(t39, t40, updated_23)
    t42 = multiply(t26, t32, updated_33)
    t43 = subtract(t41, t42, updated_23)
    t44 = subtract(t40, t26, w3)
    t45 = divide(t43, t44, updated_23)
    t47 = multiply(t7, t45, w3)
    t48 = add(t47, t11, w3)
    t49 = sqrt(t48, w3)
    t50 = multiply(t49, n1, updated_33)
    t51 = add(t50, t9, updated_33)
    t52 = sqrt(t51, updated_33)
    t53 = multiply(t49, t52, w3)
    t54 = multiply(t52, t53, updated_33)
    t55 = multiply(t26, t45, updated_23)
    t56 = subtract(t54, t55, updated_33)
    t57 = subtract(t53, t26, w3)
    t58 = divide(t56, t57, updated_33)
    t60 = multiply(t7, t58, w3)
    t61 = add(t60, t11, w3)
    t62 = sqrt(t61, w3)
    t63 = multiply(t62, n1, updated_23)
    t64 = add(t63, t9, updated_23)
    t65 = sqrt(t64, updated_23)
    t66 = multiply(t62, t65, w3)
    t67 = multiply(t65, t66, updated_23)
    t68 = multiply(t26, t58, updated_33)
    t69 = subtract(t67, t68, updated_23)
    t70 = subtract(t66, t26, w3)
    t71 = divide(t69, t70, updated_23)
    t73 = multiply(t7, t71, w0)
    t74 = add(t73, t11, w0)
    e = sqrt(t74, w0)
    t76 = multiply(e, n1, w2)
    t77 = add(t76, t9, w2)
    x = sqrt(t77, w2)
    t80 = multiply(p, n5, w1)
    t81 = add(t80, e, w1)
    t82 = multiply(r, t81, w3)
    t83 = divide(tracking_index, r, updated_22)
    t85 = multiply(t83, n6, updated_22)
    t86 = multiply(r, e, updated_23)
    t88 = multiply(t86, n7, updated_23)
    t89 = add(t85, t88, updated_22)
    t90 = divide(e, r, updated_23)
    t91 = multiply(t90, e, updated_23)
    t92 = add(t89, t91, updated_22)
    t93 = divide(t82, t92, w3)
    t95 = multiply(t93, n8, w3)
    t96 = add(t95, n0, w3)
    t98 = multiply(t96, n9, w3)
    t99 = divide(r, x, updated_23)
    t100 = multiply(t98, t99, w3)
    t101 = divide(t100, tracking_index, w3)
    t102 = multiply(e, n2, w0)
    t103 = add(t4, t102, updated_13)
    t104 = multiply(x, r, w0)
    t105 = multiply(t104, n5, updated_33)
    t106 = multiply(p, n10, updated_11)
    t107 = add(t105, t106, updated_33)
    t108 = add(t103, t107, updated_13)
    t109 = divide(t101, t108, w3)
    t110 = divide(t109, t108, w3)
    t112 = add(r, x, updated_11)
    t113 = multiply(t112, t81, updated_11)
    t114 = divide(t113, t92, updated_11)
    t115 = multiply(t114, n8, updated_11)
    t116 = add(t115, n0, updated_11)
    t117 = divide(x, r, updated_33)
    t118 = add(t116, t117, updated_11)
    t120 = multiply(t118, n11, updated_11)
    t121 = divide(t120, t108, updated_11)
    t122 = divide(t121, t108, updated_33)
    t124 = multiply(r, n2, updated_11)
    t125 = add(t124, x, updated_11)
    t126 = multiply(t125, t81, updated_11)
    t127 = multiply(t126, n11, updated_11)
    t128 = divide(t127, t92, updated_11)
    t129 = add(t128, n0, updated_11)
    t130 = divide(t129, t108, updated_11)
    t131 = divide(t130, tracking_index, w1)
    t133 = multiply(t99, n2, updated_11)
    t134 = square(t133, updated_22)
    t135 = multiply(t133, n4, w4)
    t137 = add(t135, n12, w4)
    t138 = multiply(t134, t137, updated_22)
    t139 = add(x, r, w4)
    t140 = divide(n4, t139, w5)
    t141 = divide(t140, x, w5)
    t142 = divide(t141, t104, w5)
    t144 = multiply(t142, n13, w0)
    t145 = add(t144, n1, w0)
    t146 = add(t138, t145, updated_22)
    t147 = multiply(t133, n1, w0)
    t148 = add(t147, n0, w0)
    t149 = multiply(t142, t148, w0)
    t150 = add(t149, n1, w0)
    t151 = divide(t146, t150, updated_22)
    t152 = divide(x, t139, w2)
    t154 = add(t133, n0, w6)
    t155 = multiply(t142, t154, w6)
    t156 = add(t155, n0, w6)
    t157 = divide(t156, t150, w6)
    t158 = multiply(t157, n1, w6)
    t159 = divide(r, t139, updated_12)
    t160 = multiply(t159, n12, w4)
    t162 = multiply(t99, n1, updated_23)
    t163 = multiply(t160, t162, w7)
    t164 = multiply(t133, n12, updated_11)
    t166 = add(t164, n14, updated_11)
    t167 = multiply(t142, t166, w5)
    t168 = add(t167, n1, w5)
    t169 = divide(t168, t150, w5)
    divide(t110, tracking_index, updated_11)
    divide(t122, tracking_index, updated_12)
    divide(t131, t108, updated_13)
    multiply(t151, t152, updated_22)
    multiply(t158, t160, updated_23)
    multiply(t163, t169, updated_33)


_UPDATED_COVARIANCE_DERIVATIVES = Signature(
    "updated_covariance_derivatives",
    (_TRACKING_INDEX_DOMAIN_2,),
    ("updated_11", "updated_12", "updated_13", "updated_22", "updated_23", "updated_33"),
    8,
    _updated_covariance_derivatives_block,
    numbers=_updated_covariance_derivatives_of_numbers,
)


class GainSecondDerivatives(NamedTuple):
    """Result of `gain_second_derivatives`."""

    alpha: Real
    """Second derivative by Lambda of the position gain."""
    beta: Real
    """Second derivative by Lambda of the velocity gain times the sampling interval."""
    gamma: Real
    """Second derivative by Lambda of the acceleration gain times the square of the sampling
    interval."""


def gain_second_derivatives(
    tracking_index: ArrayLike, *, out: tuple[Real, Real, Real] | None = None, workers: int = 1
) -> GainSecondDerivatives:
    """Second derivatives of the filter gain, all negative.

        delta = 8/Lambda,
        xi = sqrt(2 + 2 eta), eta = sqrt(1 + 2 delta xi), nu = 1 + xi + eta + delta

    tracking_index: Lambda, with Lambda^2 =
        increment_deviation**2*sampling_interval**4/measurement_deviation**2; a number above 0 and
        finite.

    alpha: second derivative by Lambda of the position gain. Relative error at most 22.92 * 2^-52
        (float64), 22.92 * 2^-23 (float32), proved for 6.8526910636410875e-186 <= tracking_index <=
        1.8122441335979363e77 (float64) and 4.6731686e-24 <= tracking_index <= 6.721987e09
        (float32).
    beta: second derivative by Lambda of the velocity gain times the sampling interval. Relative
        error at most 28.96 * 2^-52 (float64), 28.98 * 2^-23 (float32), proved for
        3.506117298415883e-232 <= tracking_index <= 8.958978968711217e102 (float64) and 6.87103e-30
        <= tracking_index <= 1.1082382e13 (float32).
    gamma: second derivative by Lambda of the acceleration gain times the square of the sampling
        interval. Relative error at most 26.42 * 2^-52 (float64), 26.43 * 2^-23 (float32), proved
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

    Source: derivation wiener-acceleration
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
    t2 = form.sqrt(t1)
    t4 = 1.0 / t1
    t7 = (t4 * t2) * 2.0
    t9 = t1 * 0.5
    t11 = tracking_index * 0.0625
    t17 = form.near_cbrt(((t1 * t2) * 1.0) + (8.0 / t2))
    t22 = form.sqrt((t7 * t17) + t11)
    t25 = form.sqrt((t22 * 2.0) + t9)
    t26 = t7 * 0.5
    t27 = t22 * t25
    t32 = ((t25 * t27) - (t26 * t17)) / (t27 - t26)
    t36 = form.sqrt((t7 * t32) + t11)
    t39 = form.sqrt((t36 * 2.0) + t9)
    t40 = t36 * t39
    t45 = ((t39 * t40) - (t26 * t32)) / (t40 - t26)
    t49 = form.sqrt((t7 * t45) + t11)
    t52 = form.sqrt((t49 * 2.0) + t9)
    t53 = t49 * t52
    t58 = ((t52 * t53) - (t26 * t45)) / (t53 - t26)
    t62 = form.sqrt((t7 * t58) + t11)
    t65 = form.sqrt((t62 * 2.0) + t9)
    t66 = t62 * t65
    t71 = ((t65 * t66) - (t26 * t58)) / (t66 - t26)
    t75 = form.sqrt((t7 * t71) + t11)
    t78 = form.sqrt((t75 * 2.0) + t9)
    t80 = (t78 / t2) * 2.0
    t83 = (t1 * 0.25) / t75
    t84 = t83 + 1.0
    t90 = (t83 * (t83 + 4.0)) + 3.0
    t92 = ((t84 * t83) / t90) * 2.0
    t93 = t92 * t80
    t98 = (t83 * 2.0) + 2.0
    t108 = t83 * ((t83 * ((t83 * 0.75) + 2.0)) + 2.5)
    t113 = (((t83 / t90) * (t98 / t90)) / t90) * (((t83 * (t108 + 2.0)) + 0.75) * 8.0)
    t118 = (((t78 / t75) / (t75 * t90)) / t2) * 2.0
    t123 = (t80 * (((t92 * t93) * 2.0) + t113)) * 2.0
    t127 = t78 * t2
    t131 = (t4 + (t75 * 0.5)) + ((t127 * 0.25) + (t1 * 0.125))
    t132 = t1 * t131
    t134 = ((t123 / tracking_index) / t132) / t132
    t137 = t127 / t131
    t151 = t83 * ((t83 * ((t83 * 2.5) + 9.0)) + 12.0)
    t158 = (t84 / t90) * (((t83 * (t151 + 7.0)) + 1.5) / t90)
    t168 = ((t83 * ((t83 * 3.0) + 6.0)) + 3.0) / t90
    t171 = t98 + (((t4 / t75) * 2.0) * (t168 * 2.0))
    t173 = (((t93 * t84) * 2.0) + (t158 * 4.0)) + (t118 * t171)
    t177 = ((t137 / tracking_index) * 0.5) * ((t118 * (t75 / t131)) * t173)
    t183 = (((t75 / t1) * 4.0) * (t90 * 0.5)) / t98
    t187 = t92 * ((t137 * 0.25) * ((t183 + 1.0) + t80))
    t192 = (((t118 * t83) * (t84 + t98)) / t90) * 2.0
    t193 = ((t98 * t83) / t90) * 2.0
    t197 = t80 * (t187 + (t192 + (t193 * t193)))
    t200 = ((t118 * t197) / t132) / tracking_index
    t136 = -(t134 / tracking_index)
    t179 = -(t177 / tracking_index)
    t201 = -t200
    return (t136, t179, t201)


def _gain_second_derivatives_block(
    given: Arrays,
    out: Arrays,
    work: Arrays,
    single: bool,
    n0: float = 1.0,
    n1: float = 2.0,
    n2: float = 0.5,
    n3: float = 0.0625,
    n4: float = 8.0,
    n5: float = 0.25,
    n6: float = 4.0,
    n7: float = 3.0,
    n8: float = 0.75,
    n9: float = 2.5,
    n10: float = 0.125,
    n11: float = 9.0,
    n12: float = 12.0,
    n13: float = 7.0,
    n14: float = 1.5,
    n15: float = 6.0,
) -> None:
    (tracking_index,) = given
    alpha, beta, gamma = out
    w0, w1, w2, w3, w4, w5, w6, w7, w8, w9, w10, w11, w12, w13, w14, w15 = work
    p = sqrt(tracking_index, alpha)
    r = sqrt(p, beta)
    t4 = divide(n0, p, gamma)
    t5 = multiply(t4, r, w0)
    t7 = multiply(t5, n1, w0)
    t9 = multiply(p, n2, w1)
    t11 = multiply(tracking_index, n3, w2)
    t12 = multiply(p, r, w3)
    t13 = multiply(t12, n0, w3)
    t15 = divide(n4, r, w4)
    t16 = add(t13, t15, w3)
    t17 = near_cbrt(t16, w3, single)
    t20 = multiply(t7, t17, w4)
    t21 = add(t20, t11, w4)
    t22 = sqrt(t21, w4)
    t23 = multiply(t22, n1, w5)
    t24 = add(t23, t9, w5)
    t25 = sqrt(t24, w5)
    t26 = multiply(t7, n2, w6)
    t27 = multiply(t22, t25, w4)
    t28 = multiply(t25, t27, w5)
    t29 = multiply(t26, t17, w3)
    t30 = subtract(t28, t29, w5)
    t31 = subtract(t27, t26, w4)
    t32 = divide(t30, t31, w5)
    t34 = multiply(t7, t32, w3)
    t35 = add(t34, t11, w3)
    t36 = sqrt(t35, w3)
    t37 = multiply(t36, n1, w4)
    t38 = add(t37, t9, w4)
    t39 = sqrt(t38, w4)
    t40 = multiply(t36, t39, w3)
    t41 = multiply(t39, t40, w4)
    t42 = multiply(t26, t32, w5)
    t43 = subtract(t41, t42, w4)
    t44 = subtract(t40, t26, w3)
    t45 = divide(t43, t44, w4)
    t47 = multiply(t7, t45, w3)
    t48 = add(t47, t11, w3)
    t49 = sqrt(t48, w3)
    t50 = multiply(t49, n1, w5)
    t51 = add(t50, t9, w5)
    t52 = sqrt(t51, w5)
    t53 = multiply(t49, t52, w3)
    t54 = multiply(t52, t53, w5)
    t55 = multiply(t26, t45, w4)
    t56 = subtract(t54, t55, w5)
    t57 = subtract(t53, t26, w3)
    t58 = divide(t56, t57, w5)
    t60 = multiply(t7, t58, w3)
    t61 = add(t60, t11, w3)
    t62 = sqrt(t61, w3)
    t63 = multiply(t62, n1, w4)
    t64 = add(t63, t9, w4)
    t65 = sqrt(t64, w4)
    t66 = multiply(t62, t65, w3)
    t67 = multiply(t65, t66, w4)
    t68 = multiply(t26, t58, w5)
    t69 = subtract(t67, t68, w4)
    t70 = subtract(t66, t26, w3)
    t71 = divide(t69, t70, w4)
    t73 = multiply(t7, t71, w0)
    t74 = add(t73, t11, w0)
    e = sqrt(t74, w0)
    t76 = multiply(e, n1, w2)
    t77 = add(t76, t9, w2)
    x = sqrt(t77, w2)
    t79 = divide(x, r, w1)
    t80 = multiply(t79, n1, w1)
    t82 = multiply(p, n5, w3)
    t83 = divide(t82, e, w3)
    t84 = add(t83, n0, w4)
    t85 = multiply(t84, t83, w5)
    t87 = add(t83, n6, w6)
    t88 = multiply(t83, t87, w6)
    t90 = add(t88, n7, w6)
    t91 = divide(t85, t90, w5)
    t92 = multiply(t91, n1, w5)
    t93 = multiply(t92, t80, w7)
    t94 = multiply(t92, t93, w8)
    t95 = multiply(t94, n1, w8)
    t96 = divide(t83, t90, w9)
    t97 = multiply(t83, n1, w10)
    t98 = add(t97, n1, w10)
    t99 = divide(t98, t90, w11)
    t100 = multiply(t96, t99, w9)
    t101 = divide(t100, t90, w9)
    t103 = multiply(t83, n8, w11)
    t104 = add(t103, n1, w11)
    t105 = multiply(t83, t104, w11)
    t107 = add(t105, n9, w11)
    t108 = multiply(t83, t107, w11)
    t109 = add(t108, n1, w11)
    t110 = multiply(t83, t109, w11)
    t111 = add(t110, n8, w11)
    t112 = multiply(t111, n4, w11)
    t113 = multiply(t101, t112, w9)
    t114 = divide(x, e, w11)
    t115 = multiply(e, t90, w12)
    t116 = divide(t114, t115, w11)
    t117 = divide(t116, r, w11)
    t118 = multiply(t117, n1, w11)
    t119 = multiply(t98, t83, w12)
    t120 = divide(t119, t90, w12)
    t121 = add(t95, t113, w8)
    t122 = multiply(t80, t121, w8)
    t123 = multiply(t122, n1, w8)
    t124 = divide(t123, tracking_index, w8)
    t125 = multiply(e, n2, w9)
    t126 = add(t4, t125, w9)
    t127 = multiply(x, r, w2)
    t128 = multiply(t127, n5, beta)
    t129 = multiply(p, n10, w13)
    t130 = add(t128, t129, beta)
    t131 = add(t126, t130, w9)
    t132 = multiply(p, t131, w13)
    t133 = divide(t124, t132, w8)
    t134 = divide(t133, t132, w8)
    t135 = divide(t134, tracking_index, w8)
    t137 = divide(t127, t131, w2)
    t138 = divide(t137, tracking_index, beta)
    t139 = multiply(t138, n2, beta)
    t140 = divide(e, t131, w9)
    t141 = multiply(t118, t140, w9)
    t142 = multiply(t93, t84, w7)
    t143 = multiply(t142, n1, w7)
    t144 = divide(t84, t90, w14)
    t145 = multiply(t83, n9, w15)
    t147 = add(t145, n11, w15)
    t148 = multiply(t83, t147, w15)
    t150 = add(t148, n12, w15)
    t151 = multiply(t83, t150, w15)
    t153 = add(t151, n13, w15)
    t154 = multiply(t83, t153, w15)
    t156 = add(t154, n14, w15)
    t157 = divide(t156, t90, w15)
    t158 = multiply(t144, t157, w14)
    t159 = multiply(t158, n6, w14)
    t160 = add(t143, t159, w7)
    t161 = divide(t4, e, gamma)
    t162 = multiply(t161, n1, gamma)
    t163 = multiply(t83, n7, w14)
    t165 = add(t163, n15, w14)
    t166 = multiply(t83, t165, w14)
    t167 = add(t166, n7, w14)
    t168 = divide(t167, t90, w14)
    t169 = multiply(t168, n1, w14)
    t170 = multiply(t162, t169, gamma)
    t171 = add(t98, t170, gamma)
    t172 = multiply(t118, t171, gamma)
    t173 = add(t160, t172, w7)
    t174 = divide(e, p, w0)
    t175 = multiply(t174, n6, w0)
    t176 = multiply(t141, t173, w9)
    t177 = multiply(t139, t176, beta)
    t178 = divide(t177, tracking_index, beta)
    t180 = multiply(t137, n5, w2)
    t181 = multiply(t90, n2, w7)
    t182 = multiply(t175, t181, w0)
    t183 = divide(t182, t98, w0)
    t184 = add(t183, n0, w0)
    t185 = add(t184, t80, w0)
    t186 = multiply(t180, t185, w2)
    t187 = multiply(t92, t186, w5)
    t188 = multiply(t118, t83, w3)
    t189 = add(t84, t98, w4)
    t190 = multiply(t188, t189, w3)
    t191 = divide(t190, t90, w3)
    t192 = multiply(t191, n1, w3)
    t193 = multiply(t120, n1, w12)
    t194 = square(t193, w12)
    t195 = add(t192, t194, w3)
    t196 = add(t187, t195, w5)
    t197 = multiply(t80, t196, w1)
    t198 = multiply(t118, t197, w11)
    t199 = divide(t198, t132, w11)
    t200 = divide(t199, tracking_index, w11)
    negative(t135, alpha)
    negative(t178, beta)
    negative(t200, gamma)


_GAIN_SECOND_DERIVATIVES = Signature(
    "gain_second_derivatives",
    (_TRACKING_INDEX_DOMAIN,),
    ("alpha", "beta", "gamma"),
    16,
    _gain_second_derivatives_block,
    numbers=_gain_second_derivatives_of_numbers,
)


class PredictorGainSecondDerivatives(NamedTuple):
    """Result of `predictor_gain_second_derivatives`."""

    position: Real
    """Second derivative by Lambda of the position entry of F K, alpha + beta + gamma/2."""
    velocity: Real
    """Second derivative by Lambda of the velocity entry of F K times the sampling interval, beta +
    gamma."""
    acceleration: Real
    """Second derivative by Lambda of the acceleration entry of F K times the square of the sampling
    interval, gamma."""


def predictor_gain_second_derivatives(
    tracking_index: ArrayLike, *, out: tuple[Real, Real, Real] | None = None, workers: int = 1
) -> PredictorGainSecondDerivatives:
    """Second derivatives of the predictor gain.

        delta = 8/Lambda,
        xi = sqrt(2 + 2 eta), eta = sqrt(1 + 2 delta xi), nu = 1 + xi + eta + delta

    tracking_index: Lambda, with Lambda^2 =
        increment_deviation**2*sampling_interval**4/measurement_deviation**2; a number above 0 and
        finite.

    position: second derivative by Lambda of the position entry of F K, alpha + beta + gamma/2.
        Relative error at most 24.90 * 2^-52 (float64), 24.89 * 2^-23 (float32), proved for
        6.852691063641282e-186 <= tracking_index <= 1.1287606188244725e103 (float64) and
        4.673234e-24 <= tracking_index <= 1.3962927e13 (float32).
    velocity: second derivative by Lambda of the velocity entry of F K times the sampling interval,
        beta + gamma. Relative error at most 29.46 * 2^-52 (float64), 29.48 * 2^-23 (float32),
        proved for 3.5061172984158834e-232 <= tracking_index <= 1.292108356801686e103 (float64) and
        6.8710304e-30 <= tracking_index <= 1.5983561e13 (float32).
    acceleration: second derivative by Lambda of the acceleration entry of F K times the square of
        the sampling interval, gamma. Relative error at most 26.42 * 2^-52 (float64), 26.43 * 2^-23
        (float32), proved for 5e-324 <= tracking_index <= 1.1287606188244725e103 (float64) and 1e-45
        <= tracking_index <= 1.3962927e13 (float32).

    Outside an output's range, a few numbers next to its ends apart, its true value is no normal
    number: it comes as 0, a subnormal number or infinity, never as NaN. Numbers and arrays are
    taken, arrays of any shape; inputs are broadcast. float64 and float32 stay what they are,
    integers become float64. `out`: a tuple of arrays to fill. `workers`: threads that share the
    work on long arrays.

    ValueError: an input outside its domain, with its place; `out` or `workers` that does not fit.
    TypeError: an input that is no real number of these types; in `out` what is no array of the
    results' type.

    Source: derivation wiener-acceleration
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
    t2 = form.sqrt(t1)
    t4 = 1.0 / t1
    t7 = (t4 * t2) * 2.0
    t9 = t1 * 0.5
    t11 = tracking_index * 0.0625
    t17 = form.near_cbrt(((t1 * t2) * 1.0) + (8.0 / t2))
    t22 = form.sqrt((t7 * t17) + t11)
    t25 = form.sqrt((t22 * 2.0) + t9)
    t26 = t7 * 0.5
    t27 = t22 * t25
    t32 = ((t25 * t27) - (t26 * t17)) / (t27 - t26)
    t36 = form.sqrt((t7 * t32) + t11)
    t39 = form.sqrt((t36 * 2.0) + t9)
    t40 = t36 * t39
    t45 = ((t39 * t40) - (t26 * t32)) / (t40 - t26)
    t49 = form.sqrt((t7 * t45) + t11)
    t52 = form.sqrt((t49 * 2.0) + t9)
    t53 = t49 * t52
    t58 = ((t52 * t53) - (t26 * t45)) / (t53 - t26)
    t62 = form.sqrt((t7 * t58) + t11)
    t65 = form.sqrt((t62 * 2.0) + t9)
    t66 = t62 * t65
    t71 = ((t65 * t66) - (t26 * t58)) / (t66 - t26)
    t75 = form.sqrt((t7 * t71) + t11)
    t78 = form.sqrt((t75 * 2.0) + t9)
    t80 = (t78 / t2) * 2.0
    t83 = (t1 * 0.25) / t75
    t84 = t83 + 1.0
    t90 = (t83 * (t83 + 4.0)) + 3.0
    t92 = ((t84 * t83) / t90) * 2.0
    t93 = t92 * t80
    t98 = (t83 * 2.0) + 2.0
    t108 = t83 * ((t83 * ((t83 * 0.75) + 2.0)) + 2.5)
    t113 = (((t83 / t90) * (t98 / t90)) / t90) * (((t83 * (t108 + 2.0)) + 0.75) * 8.0)
    t118 = (((t78 / t75) / (t75 * t90)) / t2) * 2.0
    t123 = (t80 * (((t92 * t93) * 2.0) + t113)) * 2.0
    t127 = t78 * t2
    t131 = (t4 + (t75 * 0.5)) + ((t127 * 0.25) + (t1 * 0.125))
    t132 = t1 * t131
    t134 = ((t123 / tracking_index) / t132) / t132
    t136 = t127 / t131
    t150 = t83 * ((t83 * ((t83 * 2.5) + 9.0)) + 12.0)
    t157 = (t84 / t90) * (((t83 * (t150 + 7.0)) + 1.5) / t90)
    t167 = ((t83 * ((t83 * 3.0) + 6.0)) + 3.0) / t90
    t170 = t98 + (((t4 / t75) * 2.0) * (t167 * 2.0))
    t172 = (((t93 * t84) * 2.0) + (t157 * 4.0)) + (t118 * t170)
    t176 = ((t136 / tracking_index) * 0.5) * ((t118 * (t75 / t131)) * t172)
    t177 = t176 / tracking_index
    t181 = (((t75 / t1) * 4.0) * (t90 * 0.5)) / t98
    t185 = t92 * ((t136 * 0.25) * ((t181 + 1.0) + t80))
    t190 = (((t118 * t83) * (t84 + t98)) / t90) * 2.0
    t191 = ((t98 * t83) / t90) * 2.0
    t195 = t80 * (t185 + (t190 + (t191 * t191)))
    t198 = ((t118 * t195) / t132) / tracking_index
    t201 = (t134 / tracking_index) + (t177 + (t198 * 0.5))
    t202 = -t201
    t204 = -(t177 + t198)
    t205 = -t198
    return (t202, t204, t205)


def _predictor_gain_second_derivatives_block(
    given: Arrays,
    out: Arrays,
    work: Arrays,
    single: bool,
    n0: float = 1.0,
    n1: float = 2.0,
    n2: float = 0.5,
    n3: float = 0.0625,
    n4: float = 8.0,
    n5: float = 0.25,
    n6: float = 4.0,
    n7: float = 3.0,
    n8: float = 0.75,
    n9: float = 2.5,
    n10: float = 0.125,
    n11: float = 9.0,
    n12: float = 12.0,
    n13: float = 7.0,
    n14: float = 1.5,
    n15: float = 6.0,
) -> None:
    (tracking_index,) = given
    position, velocity, acceleration = out
    w0, w1, w2, w3, w4, w5, w6, w7, w8, w9, w10, w11, w12, w13, w14, w15 = work
    p = sqrt(tracking_index, position)
    r = sqrt(p, velocity)
    t4 = divide(n0, p, acceleration)
    t5 = multiply(t4, r, w0)
    t7 = multiply(t5, n1, w0)
    t9 = multiply(p, n2, w1)
    t11 = multiply(tracking_index, n3, w2)
    t12 = multiply(p, r, w3)
    t13 = multiply(t12, n0, w3)
    t15 = divide(n4, r, w4)
    t16 = add(t13, t15, w3)
    t17 = near_cbrt(t16, w3, single)
    t20 = multiply(t7, t17, w4)
    t21 = add(t20, t11, w4)
    t22 = sqrt(t21, w4)
    t23 = multiply(t22, n1, w5)
    t24 = add(t23, t9, w5)
    t25 = sqrt(t24, w5)
    t26 = multiply(t7, n2, w6)
    t27 = multiply(t22, t25, w4)
    t28 = multiply(t25, t27, w5)
    t29 = multiply(t26, t17, w3)
    t30 = subtract(t28, t29, w5)
    t31 = subtract(t27, t26, w4)
    t32 = divide(t30, t31, w5)
    t34 = multiply(t7, t32, w3)
    t35 = add(t34, t11, w3)
    t36 = sqrt(t35, w3)
    t37 = multiply(t36, n1, w4)
    t38 = add(t37, t9, w4)
    t39 = sqrt(t38, w4)
    t40 = multiply(t36, t39, w3)
    t41 = multiply(t39, t40, w4)
    t42 = multiply(t26, t32, w5)
    t43 = subtract(t41, t42, w4)
    t44 = subtract(t40, t26, w3)
    t45 = divide(t43, t44, w4)
    t47 = multiply(t7, t45, w3)
    t48 = add(t47, t11, w3)
    t49 = sqrt(t48, w3)
    t50 = multiply(t49, n1, w5)
    t51 = add(t50, t9, w5)
    t52 = sqrt(t51, w5)
    t53 = multiply(t49, t52, w3)
    t54 = multiply(t52, t53, w5)
    t55 = multiply(t26, t45, w4)
    t56 = subtract(t54, t55, w5)
    t57 = subtract(t53, t26, w3)
    t58 = divide(t56, t57, w5)
    t60 = multiply(t7, t58, w3)
    t61 = add(t60, t11, w3)
    t62 = sqrt(t61, w3)
    t63 = multiply(t62, n1, w4)
    t64 = add(t63, t9, w4)
    t65 = sqrt(t64, w4)
    t66 = multiply(t62, t65, w3)
    t67 = multiply(t65, t66, w4)
    t68 = multiply(t26, t58, w5)
    t69 = subtract(t67, t68, w4)
    t70 = subtract(t66, t26, w3)
    t71 = divide(t69, t70, w4)
    t73 = multiply(t7, t71, w0)
    t74 = add(t73, t11, w0)
    e = sqrt(t74, w0)
    t76 = multiply(e, n1, w2)
    t77 = add(t76, t9, w2)
    x = sqrt(t77, w2)
    t79 = divide(x, r, w1)
    t80 = multiply(t79, n1, w1)
    t82 = multiply(p, n5, w3)
    t83 = divide(t82, e, w3)
    t84 = add(t83, n0, w4)
    t85 = multiply(t84, t83, w5)
    t87 = add(t83, n6, w6)
    t88 = multiply(t83, t87, w6)
    t90 = add(t88, n7, w6)
    t91 = divide(t85, t90, w5)
    t92 = multiply(t91, n1, w5)
    t93 = multiply(t92, t80, w7)
    t94 = multiply(t92, t93, w8)
    t95 = multiply(t94, n1, w8)
    t96 = divide(t83, t90, w9)
    t97 = multiply(t83, n1, w10)
    t98 = add(t97, n1, w10)
    t99 = divide(t98, t90, w11)
    t100 = multiply(t96, t99, w9)
    t101 = divide(t100, t90, w9)
    t103 = multiply(t83, n8, w11)
    t104 = add(t103, n1, w11)
    t105 = multiply(t83, t104, w11)
    t107 = add(t105, n9, w11)
    t108 = multiply(t83, t107, w11)
    t109 = add(t108, n1, w11)
    t110 = multiply(t83, t109, w11)
    t111 = add(t110, n8, w11)
    t112 = multiply(t111, n4, w11)
    t113 = multiply(t101, t112, w9)
    t114 = divide(x, e, w11)
    t115 = multiply(e, t90, w12)
    t116 = divide(t114, t115, w11)
    t117 = divide(t116, r, w11)
    t118 = multiply(t117, n1, w11)
    t119 = multiply(t98, t83, w12)
    t120 = divide(t119, t90, w12)
    t121 = add(t95, t113, w8)
    t122 = multiply(t80, t121, w8)
    t123 = multiply(t122, n1, w8)
    t124 = divide(t123, tracking_index, w8)
    t125 = multiply(e, n2, w9)
    t126 = add(t4, t125, w9)
    t127 = multiply(x, r, w2)
    t128 = multiply(t127, n5, velocity)
    t129 = multiply(p, n10, w13)
    t130 = add(t128, t129, velocity)
    t131 = add(t126, t130, w9)
    t132 = multiply(p, t131, w13)
    t133 = divide(t124, t132, w8)
    t134 = divide(t133, t132, w8)
    t135 = divide(t134, tracking_index, w8)
    t136 = divide(t127, t131, w2)
    t137 = divide(t136, tracking_index, velocity)
    t138 = multiply(t137, n2, velocity)
    t139 = divide(e, t131, w9)
    t140 = multiply(t118, t139, w9)
    t141 = multiply(t93, t84, w7)
    t142 = multiply(t141, n1, w7)
    t143 = divide(t84, t90, w14)
    t144 = multiply(t83, n9, w15)
    t146 = add(t144, n11, w15)
    t147 = multiply(t83, t146, w15)
    t149 = add(t147, n12, w15)
    t150 = multiply(t83, t149, w15)
    t152 = add(t150, n13, w15)
    t153 = multiply(t83, t152, w15)
    t155 = add(t153, n14, w15)
    t156 = divide(t155, t90, w15)
    t157 = multiply(t143, t156, w14)
    t158 = multiply(t157, n6, w14)
    t159 = add(t142, t158, w7)
    t160 = divide(t4, e, acceleration)
    t161 = multiply(t160, n1, acceleration)
    t162 = multiply(t83, n7, w14)
    t164 = add(t162, n15, w14)
    t165 = multiply(t83, t164, w14)
    t166 = add(t165, n7, w14)
    t167 = divide(t166, t90, w14)
    t168 = multiply(t167, n1, w14)
    t169 = multiply(t161, t168, acceleration)
    t170 = add(t98, t169, acceleration)
    t171 = multiply(t118, t170, acceleration)
    t172 = add(t159, t171, w7)
    t173 = divide(e, p, w0)
    t174 = multiply(t173, n6, w0)
    t175 = multiply(t140, t172, w9)
    t176 = multiply(t138, t175, velocity)
    t177 = divide(t176, tracking_index, velocity)
    t178 = multiply(t136, n5, w2)
    t179 = multiply(t90, n2, w7)
    t180 = multiply(t174, t179, w0)
    t181 = divide(t180, t98, w0)
    t182 = add(t181, n0, w0)
    t183 = add(t182, t80, w0)
    t184 = multiply(t178, t183, w2)
    t185 = multiply(t92, t184, w5)
    t186 = multiply(t118, t83, w3)
    t187 = add(t84, t98, w4)
    t188 = multiply(t186, t187, w3)
    t189 = divide(t188, t90, w3)
    t190 = multiply(t189, n1, w3)
    t191 = multiply(t120, n1, w12)
    t192 = square(t191, w12)
    t193 = add(t190, t192, w3)
    t194 = add(t185, t193, w5)
    t195 = multiply(t80, t194, w1)
    t196 = multiply(t118, t195, w11)
    t197 = divide(t196, t132, w11)
    t198 = divide(t197, tracking_index, w11)
    t199 = multiply(t198, n2, w0)
    t200 = add(t177, t199, w0)
    t201 = add(t135, t200, w8)
    t203 = add(t177, t198, velocity)
    negative(t201, position)
    negative(t203, velocity)
    negative(t198, acceleration)


_PREDICTOR_GAIN_SECOND_DERIVATIVES = Signature(
    "predictor_gain_second_derivatives",
    (_TRACKING_INDEX_DOMAIN,),
    ("position", "velocity", "acceleration"),
    16,
    _predictor_gain_second_derivatives_block,
    numbers=_predictor_gain_second_derivatives_of_numbers,
)


class PredictedCovarianceSecondDerivatives(NamedTuple):
    """Result of `predicted_covariance_second_derivatives`."""

    predicted_13: Real
    """Second derivative by Lambda of the covariance of predicted position and acceleration times
    T^2/sigma_v^2."""
    predicted_22: Real
    """Second derivative by Lambda of the variance of the predicted velocity times T^2/sigma_v^2."""
    predicted_23: Real
    """Second derivative by Lambda of the covariance of predicted velocity and acceleration times
    T^3/sigma_v^2."""
    predicted_33: Real
    """Second derivative by Lambda of the variance of the predicted acceleration times
    T^4/sigma_v^2."""


def predicted_covariance_second_derivatives(
    tracking_index: ArrayLike, *, out: tuple[Real, Real, Real, Real] | None = None, workers: int = 1
) -> PredictedCovarianceSecondDerivatives:
    """Second derivatives of the predicted covariance but for M11 and M12.

        delta = 8/Lambda,
        xi = sqrt(2 + 2 eta), eta = sqrt(1 + 2 delta xi), nu = 1 + xi + eta + delta

    tracking_index: Lambda, with Lambda^2 =
        increment_deviation**2*sampling_interval**4/measurement_deviation**2; a number above 0 and
        at most 2^1000, in float32 above 0 and at most 2^120.

    predicted_13: second derivative by Lambda of the covariance of predicted position and
        acceleration times T^2/sigma_v^2. Relative error at most 15.90 * 2^-52 (float64), 15.90 *
        2^-23 (float32), proved for 5e-324 <= tracking_index <= 1.0715086071862673e301 (float64) and
        1e-45 <= tracking_index <= 1.329228e36 (float32).
    predicted_22: second derivative by Lambda of the variance of the predicted velocity times
        T^2/sigma_v^2. Relative error at most 9.75 * 2^-52 (float64), 9.71 * 2^-23 (float32), proved
        for 5e-324 <= tracking_index <= 1.0715086071862673e301 (float64) and 1e-45 <= tracking_index
        <= 1.329228e36 (float32).
    predicted_23: second derivative by Lambda of the covariance of predicted velocity and
        acceleration times T^3/sigma_v^2. Relative error at most 9.71 * 2^-52 (float64), 9.69 *
        2^-23 (float32), proved for 5e-324 <= tracking_index <= 1.0715086071862673e301 (float64) and
        1e-45 <= tracking_index <= 1.329228e36 (float32).
    predicted_33: second derivative by Lambda of the variance of the predicted acceleration times
        T^4/sigma_v^2. Relative error at most 8.50 * 2^-52 (float64), 8.48 * 2^-23 (float32), proved
        for 5e-324 <= tracking_index <= 1.0715086071862673e301 (float64) and 1e-45 <= tracking_index
        <= 1.329228e36 (float32).

    Outside an output's range, a few numbers next to its ends apart, its true value is no normal
    number: it comes as 0, a subnormal number or infinity, never as NaN. Numbers and arrays are
    taken, arrays of any shape; inputs are broadcast. float64 and float32 stay what they are,
    integers become float64. `out`: a tuple of arrays to fill. `workers`: threads that share the
    work on long arrays.

    ValueError: an input outside its domain, with its place; `out` or `workers` that does not fit.
    TypeError: an input that is no real number of these types; in `out` what is no array of the
    results' type.

    Source: derivation wiener-acceleration
    """
    if (
        type(tracking_index) is float
        and 5e-324 <= tracking_index <= 1.0715086071862673e301
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
    t2 = form.sqrt(t1)
    t4 = 1.0 / t1
    t7 = (t4 * t2) * 2.0
    t9 = t1 * 0.5
    t11 = tracking_index * 0.0625
    t17 = form.near_cbrt(((t1 * t2) * 1.0) + (8.0 / t2))
    t22 = form.sqrt((t7 * t17) + t11)
    t25 = form.sqrt((t22 * 2.0) + t9)
    t26 = t7 * 0.5
    t27 = t22 * t25
    t32 = ((t25 * t27) - (t26 * t17)) / (t27 - t26)
    t36 = form.sqrt((t7 * t32) + t11)
    t39 = form.sqrt((t36 * 2.0) + t9)
    t40 = t36 * t39
    t45 = ((t39 * t40) - (t26 * t32)) / (t40 - t26)
    t49 = form.sqrt((t7 * t45) + t11)
    t52 = form.sqrt((t49 * 2.0) + t9)
    t53 = t49 * t52
    t58 = ((t52 * t53) - (t26 * t45)) / (t53 - t26)
    t62 = form.sqrt((t7 * t58) + t11)
    t65 = form.sqrt((t62 * 2.0) + t9)
    t66 = t62 * t65
    t71 = ((t65 * t66) - (t26 * t58)) / (t66 - t26)
    t75 = form.sqrt((t7 * t71) + t11)
    t78 = form.sqrt((t75 * 2.0) + t9)
    t81 = (t1 * 0.25) / t75
    t82 = t81 + 1.0
    t88 = (t81 * (t81 + 4.0)) + 3.0
    t92 = (t78 / t2) * 2.0
    t93 = (((t82 * t81) / t88) * 2.0) * t92
    t100 = (((t78 / t75) / (t75 * t88)) / t2) * 2.0
    t103 = (t81 * 2.0) + 2.0
    t107 = (((t100 * t81) * (t82 + t103)) / t88) * 2.0
    t110 = ((t103 * t81) / t88) * 2.0
    t121 = (((t81 * (t81 + 2.0)) + 1.0) / t88) * 2.0
    t123 = (t100 * (t107 + (t110 * t110))) * t92
    t131 = (t4 + (t75 * 0.5)) + (((t78 * t2) * 0.25) + (t1 * 0.125))
    t133 = ((t93 * (t93 + 1.0)) + t123) * (t1 * t131)
    t136 = t75 / t1
    t147 = t81 * ((t81 * ((t81 * 6.0) + 14.0)) + 10.0)
    t152 = ((t81 / t88) * ((t147 + 2.0) / t88)) * (t121 * 4.0)
    t157 = ((t81 * ((t81 * 4.0) + 8.0)) + 4.0) * t81
    t161 = t100 * ((t157 / t88) * (t103 / t88))
    t162 = t161 * (t100 + (((t103 * t103) / t88) * 2.0))
    t165 = ((t136 * (t88 * 4.0)) * (t152 + t162)) / t2
    t170 = t92 * ((t121 * (t121 + 1.0)) + t161)
    t172 = (((t75 / t78) * t165) + t170) * 0.125
    t180 = t81 * ((t81 * ((t81 * 10.0) + 36.0)) + 44.0)
    t186 = (t81 * ((t81 * (t180 + 24.0)) + 10.0)) + 4.0
    t191 = (t136 * 4.0) * (((t186 / t88) / t88) + (t161 * t103))
    t134 = t133 / tracking_index
    t194 = t172 + ((t191 * 0.25) + 0.5)
    t197 = ((t191 + t170) * 0.25) + 0.5
    t198 = t170 * 0.5
    return (t134, t194, t197, t198)


def _predicted_covariance_second_derivatives_block(
    given: Arrays,
    out: Arrays,
    work: Arrays,
    single: bool,
    n0: float = 1.0,
    n1: float = 2.0,
    n2: float = 0.5,
    n3: float = 0.0625,
    n4: float = 8.0,
    n5: float = 0.25,
    n6: float = 4.0,
    n7: float = 3.0,
    n8: float = 0.125,
    n9: float = 6.0,
    n10: float = 14.0,
    n11: float = 10.0,
    n12: float = 36.0,
    n13: float = 44.0,
    n14: float = 24.0,
) -> None:
    (tracking_index,) = given
    predicted_13, predicted_22, predicted_23, predicted_33 = out
    w0, w1, w2, w3, w4, w5, w6, w7, w8, w9, w10 = work
    p = sqrt(tracking_index, predicted_13)
    r = sqrt(p, predicted_22)
    t4 = divide(n0, p, predicted_23)
    t5 = multiply(t4, r, w0)
    t7 = multiply(t5, n1, w0)
    t9 = multiply(p, n2, w1)
    t11 = multiply(tracking_index, n3, w2)
    t12 = multiply(p, r, w3)
    t13 = multiply(t12, n0, w3)
    t15 = divide(n4, r, predicted_33)
    t16 = add(t13, t15, w3)
    t17 = near_cbrt(t16, w3, single)
    t20 = multiply(t7, t17, predicted_33)
    t21 = add(t20, t11, predicted_33)
    t22 = sqrt(t21, predicted_33)
    t23 = multiply(t22, n1, w4)
    t24 = add(t23, t9, w4)
    t25 = sqrt(t24, w4)
    t26 = multiply(t7, n2, w5)
    t27 = multiply(t22, t25, predicted_33)
    t28 = multiply(t25, t27, w4)
    t29 = multiply(t26, t17, w3)
    t30 = subtract(t28, t29, w4)
    t31 = subtract(t27, t26, predicted_33)
    t32 = divide(t30, t31, w4)
    t34 = multiply(t7, t32, w3)
    t35 = add(t34, t11, w3)
    t36 = sqrt(t35, w3)
    t37 = multiply(t36, n1, predicted_33)
    t38 = add(t37, t9, predicted_33)
    t39 = sqrt(t38, predicted_33)
    t40 = multiply(t36, t39, w3)
    t41 = multiply(t39, t40, predicted_33)
    t42 = multiply(t26, t32, w4)
    t43 = subtract(t41, t42, predicted_33)
    t44 = subtract(t40, t26, w3)
    t45 = divide(t43, t44, predicted_33)
    t47 = multiply(t7, t45, w3)
    t48 = add(t47, t11, w3)
    t49 = sqrt(t48, w3)
    t50 = multiply(t49, n1, w4)
    t51 = add(t50, t9, w4)
    t52 = sqrt(t51, w4)
    t53 = multiply(t49, t52, w3)
    t54 = multiply(t52, t53, w4)
    t55 = multiply(t26, t45, predicted_33)
    t56 = subtract(t54, t55, w4)
    t57 = subtract(t53, t26, w3)
    t58 = divide(t56, t57, w4)
    t60 = multiply(t7, t58, w3)
    t61 = add(t60, t11, w3)
    t62 = sqrt(t61, w3)
    t63 = multiply(t62, n1, predicted_33)
    t64 = add(t63, t9, predicted_33)
    t65 = sqrt(t64, predicted_33)
    t66 = multiply(t62, t65, w3)
    t67 = multiply(t65, t66, predicted_33)
    t68 = multiply(t26, t58, w4)
    t69 = subtract(t67, t68, predicted_33)
    t70 = subtract(t66, t26, w3)
    t71 = divide(t69, t70, predicted_33)
    t73 = multiply(t7, t71, w0)
    t74 = add(t73, t11, w0)
    e = sqrt(t74, w0)
    t76 = multiply(e, n1, w2)
    t77 = add(t76, t9, w2)
    x = sqrt(t77, w2)
    t80 = multiply(p, n5, w1)
    t81 = divide(t80, e, w1)
    t82 = add(t81, n0, w3)
    t83 = multiply(t82, t81, w4)
    t85 = add(t81, n6, w5)
    t86 = multiply(t81, t85, w5)
    t88 = add(t86, n7, w5)
    t89 = divide(t83, t88, w4)
    t90 = multiply(t89, n1, w4)
    t91 = divide(x, r, predicted_33)
    t92 = multiply(t91, n1, predicted_33)
    t93 = multiply(t90, t92, w4)
    t94 = add(t93, n0, w6)
    t95 = multiply(t93, t94, w4)
    t96 = divide(x, e, w6)
    t97 = multiply(e, t88, w7)
    t98 = divide(t96, t97, w6)
    t99 = divide(t98, r, w6)
    t100 = multiply(t99, n1, w6)
    t101 = multiply(t100, t81, w7)
    t102 = multiply(t81, n1, w8)
    t103 = add(t102, n1, w8)
    t104 = add(t82, t103, w3)
    t105 = multiply(t101, t104, w7)
    t106 = divide(t105, t88, w7)
    t107 = multiply(t106, n1, w7)
    t108 = multiply(t103, t81, w3)
    t109 = divide(t108, t88, w3)
    t110 = multiply(t109, n1, w3)
    t111 = square(t110, w3)
    t112 = add(t107, t111, w7)
    t113 = square(t103, w3)
    t114 = divide(t113, t88, w3)
    t115 = multiply(t114, n1, w3)
    t116 = add(t100, t115, w3)
    t117 = add(t81, n1, w9)
    t118 = multiply(t81, t117, w9)
    t119 = add(t118, n0, w9)
    t120 = divide(t119, t88, w9)
    t121 = multiply(t120, n1, w9)
    t122 = multiply(t100, t112, w7)
    t123 = multiply(t122, t92, w7)
    t124 = add(t95, t123, w4)
    t125 = multiply(e, n2, w7)
    t126 = add(t4, t125, predicted_23)
    t127 = multiply(x, r, w7)
    t128 = multiply(t127, n5, w7)
    t129 = multiply(p, n8, w10)
    t130 = add(t128, t129, w7)
    t131 = add(t126, t130, predicted_23)
    t132 = multiply(p, t131, predicted_23)
    t133 = multiply(t124, t132, w4)
    t135 = divide(e, x, w2)
    t136 = divide(e, p, w0)
    t137 = multiply(t88, n6, w7)
    t138 = multiply(t136, t137, w7)
    t139 = divide(t81, t88, w10)
    t141 = multiply(t81, n9, predicted_13)
    t143 = add(t141, n10, predicted_13)
    t144 = multiply(t81, t143, predicted_13)
    t146 = add(t144, n11, predicted_13)
    t147 = multiply(t81, t146, predicted_13)
    t148 = add(t147, n1, predicted_13)
    t149 = divide(t148, t88, predicted_13)
    t150 = multiply(t139, t149, w10)
    t151 = multiply(t121, n6, predicted_13)
    t152 = multiply(t150, t151, w10)
    t153 = multiply(t81, n6, predicted_13)
    t154 = add(t153, n4, predicted_13)
    t155 = multiply(t81, t154, predicted_13)
    t156 = add(t155, n6, predicted_13)
    t157 = multiply(t156, t81, predicted_13)
    t158 = divide(t157, t88, predicted_13)
    t159 = divide(t103, t88, predicted_23)
    t160 = multiply(t158, t159, predicted_13)
    t161 = multiply(t100, t160, w6)
    t162 = multiply(t161, t116, w3)
    t163 = add(t152, t162, w10)
    t164 = multiply(t138, t163, w7)
    t165 = divide(t164, r, w7)
    t166 = multiply(t135, t165, w2)
    t167 = add(t121, n0, w3)
    t168 = multiply(t121, t167, w9)
    t169 = add(t168, t161, w9)
    t170 = multiply(t92, t169, predicted_33)
    t171 = add(t166, t170, w2)
    t172 = multiply(t171, n8, w2)
    t173 = multiply(t136, n6, w0)
    t174 = multiply(t81, n11, w3)
    t176 = add(t174, n12, w3)
    t177 = multiply(t81, t176, w3)
    t179 = add(t177, n13, w3)
    t180 = multiply(t81, t179, w3)
    t182 = add(t180, n14, w3)
    t183 = multiply(t81, t182, w3)
    t184 = add(t183, n11, w3)
    t185 = multiply(t81, t184, w1)
    t186 = add(t185, n6, w1)
    t187 = divide(t186, t88, w1)
    t188 = divide(t187, t88, w1)
    t189 = multiply(t161, t103, w6)
    t190 = add(t188, t189, w1)
    t191 = multiply(t173, t190, w0)
    t192 = multiply(t191, n5, w1)
    t193 = add(t192, n2, w1)
    t195 = add(t191, t170, w0)
    t196 = multiply(t195, n5, w0)
    divide(t133, tracking_index, predicted_13)
    add(t172, t193, predicted_22)
    add(t196, n2, predicted_23)
    multiply(t170, n2, predicted_33)


_PREDICTED_COVARIANCE_SECOND_DERIVATIVES = Signature(
    "predicted_covariance_second_derivatives",
    (_TRACKING_INDEX_DOMAIN_2,),
    ("predicted_13", "predicted_22", "predicted_23", "predicted_33"),
    11,
    _predicted_covariance_second_derivatives_block,
    numbers=_predicted_covariance_second_derivatives_of_numbers,
)


class PredictedPositionSecondDerivatives(NamedTuple):
    """Result of `predicted_position_second_derivatives`."""

    predicted_11: Real
    """Second derivative by Lambda of the variance of the predicted position over sigma_v^2."""
    predicted_12: Real
    """Second derivative by Lambda of the covariance of predicted position and velocity times
    T/sigma_v^2."""


def predicted_position_second_derivatives(
    tracking_index: ArrayLike, *, out: tuple[Real, Real] | None = None, workers: int = 1
) -> PredictedPositionSecondDerivatives:
    """Second derivatives of M11 and M12.

        delta = 8/Lambda,
        xi = sqrt(2 + 2 eta), eta = sqrt(1 + 2 delta xi), nu = 1 + xi + eta + delta

    tracking_index: Lambda, with Lambda^2 =
        increment_deviation**2*sampling_interval**4/measurement_deviation**2; a number at least
        2^-750 and at most 2^1000, in float32 at least 2^-80 and at most 2^120.

    predicted_11: second derivative by Lambda of the variance of the predicted position over
        sigma_v^2. Error over the sum of its terms' sizes at most 62.86 * 2^-52 (float64), 65.02 *
        2^-23 (float32), proved for 6.852691063641087e-186 <= tracking_index <=
        1.0715086071862673e301 (float64) and 4.6731686e-24 <= tracking_index <= 1.329228e36
        (float32). Cancellation, condition number 1: it bends down for a small index and up for a
        large one, so that it vanishes between. Digits that can be lost: up to 16 of 16 in float64,
        half or more only where 0.95 <= tracking_index <= 1.2; up to 7 of 7 in float32, half or more
        only where 0.75 <= tracking_index <= 1.6.
    predicted_12: second derivative by Lambda of the covariance of predicted position and velocity
        times T/sigma_v^2. Error over the sum of its terms' sizes at most 64.09 * 2^-52 (float64),
        66.76 * 2^-23 (float32), proved for 1.688508503057271e-226 <= tracking_index <=
        1.0715086071862673e301 (float64) and 8.271806e-25 <= tracking_index <= 1.329228e36
        (float32). Cancellation, condition number 1: it bends down for a small index and up for a
        large one, so that it vanishes between. Digits that can be lost: up to 16 of 16 in float64,
        half or more only where 0.27198 <= tracking_index <= 0.272099; up to 7 of 7 in float32, half
        or more only where 0.2 <= tracking_index <= 0.37.

    Outside an output's range, a few numbers next to its ends apart, its true value is no normal
    number: it comes as 0, a subnormal number or infinity, never as NaN. Numbers and arrays are
    taken, arrays of any shape; inputs are broadcast. float64 and float32 stay what they are,
    integers become float64. `out`: a tuple of arrays to fill. `workers`: threads that share the
    work on long arrays.

    ValueError: an input outside its domain, with its place; `out` or `workers` that does not fit.
    TypeError: an input that is no real number of these types; in `out` what is no array of the
    results' type.

    Source: derivation wiener-acceleration
    """
    if (
        type(tracking_index) is float
        and 1.688508503057271e-226 <= tracking_index <= 1.0715086071862673e301
        and out is None
        and workers is ONE
    ):
        try:
            return named(
                PredictedPositionSecondDerivatives,
                _predicted_position_second_derivatives_of_numbers(tracking_index),
            )
        except (ArithmeticError, ValueError):
            pass  # arrays say what is wrong
    return PredictedPositionSecondDerivatives(
        *evaluate(_PREDICTED_POSITION_SECOND_DERIVATIVES, (tracking_index,), out, workers)
    )


def _predicted_position_second_derivatives_of_numbers(
    tracking_index: float,
    form: Form = Double,
) -> tuple[float, ...]:
    t1 = form.sqrt(tracking_index)
    t2 = form.sqrt(t1)
    t4 = 1.0 / t1
    t7 = (t4 * t2) * 2.0
    t9 = t1 * 0.5
    t11 = tracking_index * 0.0625
    t17 = form.near_cbrt(((t1 * t2) * 1.0) + (8.0 / t2))
    t22 = form.sqrt((t7 * t17) + t11)
    t25 = form.sqrt((t22 * 2.0) + t9)
    t26 = t7 * 0.5
    t27 = t22 * t25
    t32 = ((t25 * t27) - (t26 * t17)) / (t27 - t26)
    t36 = form.sqrt((t7 * t32) + t11)
    t39 = form.sqrt((t36 * 2.0) + t9)
    t40 = t36 * t39
    t45 = ((t39 * t40) - (t26 * t32)) / (t40 - t26)
    t49 = form.sqrt((t7 * t45) + t11)
    t52 = form.sqrt((t49 * 2.0) + t9)
    t53 = t49 * t52
    t58 = ((t52 * t53) - (t26 * t45)) / (t53 - t26)
    t62 = form.sqrt((t7 * t58) + t11)
    t65 = form.sqrt((t62 * 2.0) + t9)
    t66 = t62 * t65
    t71 = ((t65 * t66) - (t26 * t58)) / (t66 - t26)
    t75 = form.sqrt((t7 * t71) + t11)
    t78 = form.sqrt((t75 * 2.0) + t9)
    t81 = (t1 * 0.25) / t75
    t82 = t81 + 1.0
    t88 = (t81 * (t81 + 4.0)) + 3.0
    t91 = t78 / t2
    t92 = t91 * 2.0
    t93 = (((t82 * t81) / t88) * 2.0) * t92
    t101 = (t4 + (t75 * 0.5)) + (((t78 * t2) * 0.25) + (t1 * 0.125))
    t103 = (t1 * t101) / tracking_index
    t109 = (t81 * 2.0) + 2.0
    t110 = t109 / t88
    t119 = t81 * ((t81 * ((t81 * 0.75) + 2.0)) + 2.5)
    t124 = (((t81 / t88) * t110) / t88) * (((t81 * (t119 + 2.0)) + 0.75) * 8.0)
    t129 = (((t78 / t75) / (t75 * t88)) / t2) * 2.0
    t138 = t91 * t103
    t143 = (((t81 * (t81 + 2.0)) + 1.0) / t88) * 2.0
    t144 = t143 + t93
    t150 = (((t129 * t81) * (t82 + t109)) / t88) * 2.0
    t151 = ((t109 * t81) / t88) * 2.0
    t155 = (t129 * (t150 + (t151 * t151))) * t92
    t161 = ((t81 * ((t81 * 4.0) + 8.0)) + 4.0) * t81
    t165 = ((t144 * t93) + t155) + (t129 * ((t161 / t88) * t110))
    t136 = (((t93 * t93) * t103) * (t103 * 4.0)) - (((t124 * t92) * t103) * (t103 * 2.0))
    t169 = (t138 * t165) - (t138 * (t144 * t129))
    return (t136, t169)


def _predicted_position_second_derivatives_block(
    given: Arrays,
    out: Arrays,
    work: Arrays,
    single: bool,
    n0: float = 1.0,
    n1: float = 2.0,
    n2: float = 0.5,
    n3: float = 0.0625,
    n4: float = 8.0,
    n5: float = 0.25,
    n6: float = 4.0,
    n7: float = 3.0,
    n8: float = 0.125,
    n9: float = 0.75,
    n10: float = 2.5,
) -> None:
    (tracking_index,) = given
    predicted_11, predicted_12 = out
    w0, w1, w2, w3, w4, w5, w6, w7, w8, w9, w10, w11, w12 = work
    p = sqrt(tracking_index, predicted_11)
    r = sqrt(p, predicted_12)
    t4 = divide(n0, p, w0)
    t5 = multiply(t4, r, w1)
    t7 = multiply(t5, n1, w1)
    t9 = multiply(p, n2, w2)
    t11 = multiply(tracking_index, n3, w3)
    t12 = multiply(p, r, w4)
    t13 = multiply(t12, n0, w4)
    t15 = divide(n4, r, w5)
    t16 = add(t13, t15, w4)
    t17 = near_cbrt(t16, w4, single)
    t20 = multiply(t7, t17, w5)
    t21 = add(t20, t11, w5)
    t22 = sqrt(t21, w5)
    t23 = multiply(t22, n1, w6)
    t24 = add(t23, t9, w6)
    t25 = sqrt(t24, w6)
    t26 = multiply(t7, n2, w7)
    t27 = multiply(t22, t25, w5)
    t28 = multiply(t25, t27, w6)
    t29 = multiply(t26, t17, w4)
    t30 = subtract(t28, t29, w6)
    t31 = subtract(t27, t26, w5)
    t32 = divide(t30, t31, w6)
    t34 = multiply(t7, t32, w4)
    t35 = add(t34, t11, w4)
    t36 = sqrt(t35, w4)
    t37 = multiply(t36, n1, w5)
    t38 = add(t37, t9, w5)
    t39 = sqrt(t38, w5)
    t40 = multiply(t36, t39, w4)
    t41 = multiply(t39, t40, w5)
    t42 = multiply(t26, t32, w6)
    t43 = subtract(t41, t42, w5)
    t44 = subtract(t40, t26, w4)
    t45 = divide(t43, t44, w5)
    t47 = multiply(t7, t45, w4)
    t48 = add(t47, t11, w4)
    t49 = sqrt(t48, w4)
    t50 = multiply(t49, n1, w6)
    t51 = add(t50, t9, w6)
    t52 = sqrt(t51, w6)
    t53 = multiply(t49, t52, w4)
    t54 = multiply(t52, t53, w6)
    t55 = multiply(t26, t45, w5)
    t56 = subtract(t54, t55, w6)
    t57 = subtract(t53, t26, w4)
    t58 = divide(t56, t57, w6)
    t60 = multiply(t7, t58, w4)
    t61 = add(t60, t11, w4)
    t62 = sqrt(t61, w4)
    t63 = multiply(t62, n1, w5)
    t64 = add(t63, t9, w5)
    t65 = sqrt(t64, w5)
    t66 = multiply(t62, t65, w4)
    t67 = multiply(t65, t66, w5)
    t68 = multiply(t26, t58, w6)
    t69 = subtract(t67, t68, w5)
    t70 = subtract(t66, t26, w4)
    t71 = divide(t69, t70, w5)
    t73 = multiply(t7, t71, w1)
    t74 = add(t73, t11, w1)
    e = sqrt(t74, w1)
    t76 = multiply(e, n1, w3)
    t77 = add(t76, t9, w3)
    x = sqrt(t77, w3)
    t80 = multiply(p, n5, w2)
    t81 = divide(t80, e, w2)
    t82 = add(t81, n0, w4)
    t83 = multiply(t82, t81, w5)
    t85 = add(t81, n6, w6)
    t86 = multiply(t81, t85, w6)
    t88 = add(t86, n7, w6)
    t89 = divide(t83, t88, w5)
    t90 = multiply(t89, n1, w5)
    t91 = divide(x, r, w7)
    t92 = multiply(t91, n1, w8)
    t93 = multiply(t90, t92, w5)
    t94 = square(t93, w9)
    t95 = multiply(e, n2, w10)
    t96 = add(t4, t95, w0)
    t97 = multiply(x, r, w10)
    t98 = multiply(t97, n5, w10)
    t99 = multiply(p, n8, w11)
    t100 = add(t98, t99, w10)
    t101 = add(t96, t100, w0)
    t102 = multiply(p, t101, predicted_11)
    t103 = divide(t102, tracking_index, predicted_11)
    t104 = multiply(t94, t103, w9)
    t105 = multiply(t103, n6, w0)
    t106 = multiply(t104, t105, w9)
    t107 = divide(t81, t88, w0)
    t108 = multiply(t81, n1, w10)
    t109 = add(t108, n1, w10)
    t110 = divide(t109, t88, w11)
    t111 = multiply(t107, t110, w0)
    t112 = divide(t111, t88, w0)
    t114 = multiply(t81, n9, w12)
    t115 = add(t114, n1, w12)
    t116 = multiply(t81, t115, w12)
    t118 = add(t116, n10, w12)
    t119 = multiply(t81, t118, w12)
    t120 = add(t119, n1, w12)
    t121 = multiply(t81, t120, w12)
    t122 = add(t121, n9, w12)
    t123 = multiply(t122, n4, w12)
    t124 = multiply(t112, t123, w0)
    t125 = divide(x, e, w3)
    t126 = multiply(e, t88, w1)
    t127 = divide(t125, t126, w3)
    t128 = divide(t127, r, w3)
    t129 = multiply(t128, n1, w3)
    t130 = multiply(t109, t81, w1)
    t131 = divide(t130, t88, w1)
    t132 = multiply(t124, t92, w0)
    t133 = multiply(t132, t103, w0)
    t134 = multiply(t103, n1, w12)
    t135 = multiply(t133, t134, w0)
    t138 = multiply(t91, t103, w7)
    t139 = add(t81, n1, w12)
    t140 = multiply(t81, t139, w12)
    t141 = add(t140, n0, w12)
    t142 = divide(t141, t88, w12)
    t143 = multiply(t142, n1, w12)
    t144 = add(t143, t93, w12)
    t145 = multiply(t144, t93, w5)
    t146 = multiply(t129, t81, predicted_11)
    t147 = add(t82, t109, w4)
    t148 = multiply(t146, t147, predicted_11)
    t149 = divide(t148, t88, predicted_11)
    t150 = multiply(t149, n1, predicted_11)
    t151 = multiply(t131, n1, w1)
    t152 = square(t151, w1)
    t153 = add(t150, t152, predicted_11)
    t154 = multiply(t129, t153, predicted_11)
    t155 = multiply(t154, t92, predicted_11)
    t156 = add(t145, t155, w5)
    t157 = multiply(t81, n6, w1)
    t158 = add(t157, n4, w1)
    t159 = multiply(t81, t158, w1)
    t160 = add(t159, n6, w1)
    t161 = multiply(t160, t81, w1)
    t162 = divide(t161, t88, w1)
    t163 = multiply(t162, t110, w1)
    t164 = multiply(t129, t163, w1)
    t165 = add(t156, t164, w5)
    t166 = multiply(t138, t165, w5)
    t167 = multiply(t144, t129, w12)
    t168 = multiply(t138, t167, w7)
    subtract(t106, t135, predicted_11)
    subtract(t166, t168, predicted_12)


_PREDICTED_POSITION_SECOND_DERIVATIVES = Signature(
    "predicted_position_second_derivatives",
    (_TRACKING_INDEX_DOMAIN_3,),
    ("predicted_11", "predicted_12"),
    13,
    _predicted_position_second_derivatives_block,
    numbers=_predicted_position_second_derivatives_of_numbers,
)


class UpdatedCovarianceSecondDerivatives(NamedTuple):
    """Result of `updated_covariance_second_derivatives`."""

    updated_22: Real
    """Second derivative by Lambda of the variance of the updated velocity times T^2/sigma_v^2."""
    updated_23: Real
    """Second derivative by Lambda of the covariance of updated velocity and acceleration times
    T^3/sigma_v^2."""
    updated_33: Real
    """Second derivative by Lambda of the variance of the updated acceleration times
    T^4/sigma_v^2."""


def updated_covariance_second_derivatives(
    tracking_index: ArrayLike, *, out: tuple[Real, Real, Real] | None = None, workers: int = 1
) -> UpdatedCovarianceSecondDerivatives:
    """Second derivatives of the updated covariance but for its first row.

        delta = 8/Lambda,
        xi = sqrt(2 + 2 eta), eta = sqrt(1 + 2 delta xi), nu = 1 + xi + eta + delta

    tracking_index: Lambda, with Lambda^2 =
        increment_deviation**2*sampling_interval**4/measurement_deviation**2; a number above 0 and
        finite.

    updated_22: second derivative by Lambda of the variance of the updated velocity times
        T^2/sigma_v^2. Relative error at most 21.35 * 2^-52 (float64), 21.36 * 2^-23 (float32),
        proved for 5e-324 <= tracking_index <= 1.422149263949316e103 (float64) and 1e-45 <=
        tracking_index <= 1.7592185e13 (float32).
    updated_23: second derivative by Lambda of the covariance of updated velocity and acceleration
        times T^3/sigma_v^2. Relative error at most 21.35 * 2^-52 (float64), 21.36 * 2^-23
        (float32), proved for 5e-324 <= tracking_index <= 1.422149263949316e103 (float64) and 1e-45
        <= tracking_index <= 1.7592185e13 (float32).
    updated_33: second derivative by Lambda of the variance of the updated acceleration times
        T^4/sigma_v^2. Relative error at most 25.44 * 2^-52 (float64), 25.45 * 2^-23 (float32),
        proved for 5e-324 <= tracking_index <= 2.844298527898632e103 (float64) and 1e-45 <=
        tracking_index <= 3.518437e13 (float32).

    Outside an output's range, a few numbers next to its ends apart, its true value is no normal
    number: it comes as 0, a subnormal number or infinity, never as NaN. Numbers and arrays are
    taken, arrays of any shape; inputs are broadcast. float64 and float32 stay what they are,
    integers become float64. `out`: a tuple of arrays to fill. `workers`: threads that share the
    work on long arrays.

    ValueError: an input outside its domain, with its place; `out` or `workers` that does not fit.
    TypeError: an input that is no real number of these types; in `out` what is no array of the
    results' type.

    Source: derivation wiener-acceleration
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
    t2 = form.sqrt(t1)
    t7 = ((1.0 / t1) * t2) * 2.0
    t9 = t1 * 0.5
    t11 = tracking_index * 0.0625
    t17 = form.near_cbrt(((t1 * t2) * 1.0) + (8.0 / t2))
    t21 = form.sqrt((t7 * t17) + t11)
    t24 = form.sqrt((t21 * 2.0) + t9)
    t25 = t7 * 0.5
    t26 = t21 * t24
    t31 = ((t24 * t26) - (t25 * t17)) / (t26 - t25)
    t35 = form.sqrt((t7 * t31) + t11)
    t38 = form.sqrt((t35 * 2.0) + t9)
    t39 = t35 * t38
    t44 = ((t38 * t39) - (t25 * t31)) / (t39 - t25)
    t48 = form.sqrt((t7 * t44) + t11)
    t51 = form.sqrt((t48 * 2.0) + t9)
    t52 = t48 * t51
    t57 = ((t51 * t52) - (t25 * t44)) / (t52 - t25)
    t61 = form.sqrt((t7 * t57) + t11)
    t64 = form.sqrt((t61 * 2.0) + t9)
    t65 = t61 * t64
    t70 = ((t64 * t65) - (t25 * t57)) / (t65 - t25)
    t76 = (form.sqrt((t7 * t70) + t11) * 2.0) + t9
    t77 = form.sqrt(t76)
    t78 = t77 + t2
    t82 = ((8.0 / t78) / t77) / (t77 * t2)
    t83 = t2 / t77
    t84 = t83 * 0.5
    t88 = (t82 * ((t84 * 2.0) + 1.0)) + 2.0
    t89 = t82 / t88
    t90 = t89 * t89
    t96 = t90 * ((((t82 + 2.0) * t84) + 3.0) / t88)
    t99 = (t2 / t78) * 4.0
    t102 = (t96 * (t99 * 4.0)) / tracking_index
    t113 = (t82 * t84) * ((((t84 * 4.0) + 2.0) * t84) + 1.0)
    t115 = ((t82 * (t84 * t84)) * 12.0) + (t113 * 2.0)
    t122 = t90 * ((t115 + ((t84 * 34.0) + 15.0)) / t88)
    t103 = -t102
    t127 = (t122 * ((t99 * (t83 * 2.0)) * 2.0)) / tracking_index
    return (t103, t102, t127)


def _updated_covariance_second_derivatives_block(
    given: Arrays,
    out: Arrays,
    work: Arrays,
    single: bool,
    n0: float = 1.0,
    n1: float = 2.0,
    n2: float = 0.5,
    n3: float = 0.0625,
    n4: float = 8.0,
    n5: float = 3.0,
    n6: float = 4.0,
    n7: float = 12.0,
    n8: float = 34.0,
    n9: float = 15.0,
) -> None:
    (tracking_index,) = given
    updated_22, updated_23, updated_33 = out
    w0, w1, w2, w3, w4, w5 = work
    p = sqrt(tracking_index, updated_23)
    r = sqrt(p, updated_22)
    t4 = divide(n0, p, updated_33)
    t5 = multiply(t4, r, updated_33)
    t7 = multiply(t5, n1, updated_33)
    t9 = multiply(p, n2, w0)
    t11 = multiply(tracking_index, n3, w1)
    t12 = multiply(p, r, updated_23)
    t13 = multiply(t12, n0, updated_23)
    t15 = divide(n4, r, w2)
    t16 = add(t13, t15, updated_23)
    t17 = near_cbrt(t16, updated_23, single)
    t19 = multiply(t7, t17, w2)
    t20 = add(t19, t11, w2)
    t21 = sqrt(t20, w2)
    t22 = multiply(t21, n1, w3)
    t23 = add(t22, t9, w3)
    t24 = sqrt(t23, w3)
    t25 = multiply(t7, n2, w4)
    t26 = multiply(t21, t24, w2)
    t27 = multiply(t24, t26, w3)
    t28 = multiply(t25, t17, updated_23)
    t29 = subtract(t27, t28, w3)
    t30 = subtract(t26, t25, w2)
    t31 = divide(t29, t30, w3)
    t33 = multiply(t7, t31, w2)
    t34 = add(t33, t11, w2)
    t35 = sqrt(t34, w2)
    t36 = multiply(t35, n1, updated_23)
    t37 = add(t36, t9, updated_23)
    t38 = sqrt(t37, updated_23)
    t39 = multiply(t35, t38, w2)
    t40 = multiply(t38, t39, updated_23)
    t41 = multiply(t25, t31, w3)
    t42 = subtract(t40, t41, updated_23)
    t43 = subtract(t39, t25, w2)
    t44 = divide(t42, t43, updated_23)
    t46 = multiply(t7, t44, w2)
    t47 = add(t46, t11, w2)
    t48 = sqrt(t47, w2)
    t49 = multiply(t48, n1, w3)
    t50 = add(t49, t9, w3)
    t51 = sqrt(t50, w3)
    t52 = multiply(t48, t51, w2)
    t53 = multiply(t51, t52, w3)
    t54 = multiply(t25, t44, updated_23)
    t55 = subtract(t53, t54, w3)
    t56 = subtract(t52, t25, w2)
    t57 = divide(t55, t56, w3)
    t59 = multiply(t7, t57, w2)
    t60 = add(t59, t11, w2)
    t61 = sqrt(t60, w2)
    t62 = multiply(t61, n1, updated_23)
    t63 = add(t62, t9, updated_23)
    t64 = sqrt(t63, updated_23)
    t65 = multiply(t61, t64, w2)
    t66 = multiply(t64, t65, updated_23)
    t67 = multiply(t25, t57, w3)
    t68 = subtract(t66, t67, updated_23)
    t69 = subtract(t65, t25, w2)
    t70 = divide(t68, t69, updated_23)
    t72 = multiply(t7, t70, updated_33)
    t73 = add(t72, t11, updated_33)
    eta_of_map = sqrt(t73, updated_33)
    t75 = multiply(eta_of_map, n1, updated_33)
    t76 = add(t75, t9, updated_33)
    x = sqrt(t76, updated_33)
    t78 = add(x, r, w0)
    t79 = divide(n4, t78, w1)
    t80 = divide(t79, x, w1)
    t81 = multiply(x, r, w2)
    t82 = divide(t80, t81, w1)
    t83 = divide(r, x, updated_33)
    t84 = multiply(t83, n2, w2)
    t85 = multiply(t84, n1, w3)
    t86 = add(t85, n0, w3)
    t87 = multiply(t82, t86, w3)
    t88 = add(t87, n1, w3)
    t89 = divide(t82, t88, w4)
    t90 = square(t89, w4)
    t91 = add(t82, n1, updated_23)
    t92 = multiply(t91, t84, updated_23)
    t94 = add(t92, n5, updated_23)
    t95 = divide(t94, t88, updated_23)
    t96 = multiply(t90, t95, updated_23)
    t97 = divide(r, t78, updated_22)
    t99 = multiply(t97, n6, updated_22)
    t100 = multiply(t99, n6, w0)
    t101 = multiply(t96, t100, updated_23)
    divide(t101, tracking_index, updated_23)
    t104 = square(t84, w0)
    t105 = multiply(t82, t104, w0)
    t107 = multiply(t105, n7, w0)
    t108 = multiply(t82, t84, w1)
    t109 = multiply(t84, n6, w5)
    t110 = add(t109, n1, w5)
    t111 = multiply(t110, t84, w5)
    t112 = add(t111, n0, w5)
    t113 = multiply(t108, t112, w1)
    t114 = multiply(t113, n1, w1)
    t115 = add(t107, t114, w0)
    t117 = multiply(t84, n8, w2)
    t119 = add(t117, n9, w2)
    t120 = add(t115, t119, w0)
    t121 = divide(t120, t88, w0)
    t122 = multiply(t90, t121, w4)
    t123 = multiply(t83, n1, updated_33)
    t124 = multiply(t99, t123, updated_22)
    t125 = multiply(t124, n1, updated_22)
    t126 = multiply(t122, t125, w4)
    negative(updated_23, updated_22)
    divide(t126, tracking_index, updated_33)


_UPDATED_COVARIANCE_SECOND_DERIVATIVES = Signature(
    "updated_covariance_second_derivatives",
    (_TRACKING_INDEX_DOMAIN,),
    ("updated_22", "updated_23", "updated_33"),
    6,
    _updated_covariance_second_derivatives_block,
    numbers=_updated_covariance_second_derivatives_of_numbers,
)


class ClosedLoopPoles(NamedTuple):
    """Result of `closed_loop_poles`."""

    real_pole: Real
    """Positive pole, the one that is real for every index."""
    modulus: Real
    """Geometric mean of the moduli of the other two, that of each while they are complex."""
    half_sum: Real
    """Half the sum of these two, the real part of each while they are complex."""
    quarter_discriminant: Real
    """Square of half their difference, negative while they are complex."""


def closed_loop_poles(
    tracking_index: ArrayLike, *, out: tuple[Real, Real, Real, Real] | None = None, workers: int = 1
) -> ClosedLoopPoles:
    """Poles: the real one; of the other two modulus, half sum, half the distance squared.

        c(z) = (z - real_pole) (z^2 - 2 half_sum z + modulus^2),
        quarter_discriminant = half_sum^2 - modulus^2,
        real_pole = w = 1/sigma, modulus = sqrt(w), half_sum = (xi^2 - 8)/(xi^2 + 2 xi),
        xi^3 - 4 xi = 64/Lambda

    tracking_index: Lambda, with Lambda^2 =
        increment_deviation**2*sampling_interval**4/measurement_deviation**2; a number above 0 and
        finite.

    real_pole: positive pole, the one that is real for every index. Relative error at most 4.90 *
        2^-52 (float64), 4.89 * 2^-23 (float32), proved for 5e-324 <= tracking_index <=
        8.98846567431158e307 (float64) and 1e-45 <= tracking_index <= 1.7014118e38 (float32).
    modulus: geometric mean of the moduli of the other two, that of each while they are complex.
        Relative error at most 3.20 * 2^-52 (float64), 3.20 * 2^-23 (float32), proved for 5e-324 <=
        tracking_index <= 1.7976931348623157e308 (float64) and 1e-45 <= tracking_index <=
        3.4028235e38 (float32).
    half_sum: half the sum of these two, the real part of each while they are complex. Relative
        error at most 17.07 * 2^-52 (float64), 16.90 * 2^-23 (float32), proved for 5e-324 <=
        tracking_index <= 1.7976931348623157e308 (float64) and 1e-45 <= tracking_index <=
        3.4028235e38 (float32).
    quarter_discriminant: square of half their difference, negative while they are complex. Relative
        error at most 26.43 * 2^-52 (float64), 26.33 * 2^-23 (float32), proved for 5e-324 <=
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

    Source: derivation wiener-acceleration
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
    t1 = form.sqrt(tracking_index)
    t2 = form.sqrt(t1)
    t4 = 1.0 / t1
    t7 = (t4 * t2) * 2.0
    t9 = t1 * 0.5
    t11 = tracking_index * 0.0625
    t17 = form.near_cbrt(((t1 * t2) * 1.0) + (8.0 / t2))
    t22 = form.sqrt((t7 * t17) + t11)
    t25 = form.sqrt((t22 * 2.0) + t9)
    t26 = t7 * 0.5
    t27 = t22 * t25
    t32 = ((t25 * t27) - (t26 * t17)) / (t27 - t26)
    t36 = form.sqrt((t7 * t32) + t11)
    t39 = form.sqrt((t36 * 2.0) + t9)
    t40 = t36 * t39
    t45 = ((t39 * t40) - (t26 * t32)) / (t40 - t26)
    t49 = form.sqrt((t7 * t45) + t11)
    t52 = form.sqrt((t49 * 2.0) + t9)
    t53 = t49 * t52
    t58 = ((t52 * t53) - (t26 * t45)) / (t53 - t26)
    t62 = form.sqrt((t7 * t58) + t11)
    t65 = form.sqrt((t62 * 2.0) + t9)
    t66 = t62 * t65
    t71 = ((t65 * t66) - (t26 * t58)) / (t66 - t26)
    t75 = form.sqrt((t7 * t71) + t11)
    t78 = form.sqrt((t75 * 2.0) + t9)
    t80 = (t78 / t2) * 2.0
    t88 = (t4 + (t75 * 0.5)) + (((t78 * t2) * 0.25) + (t1 * 0.125))
    t89 = t1 * t88
    t96 = t80 + 2.8284271247461903
    t99 = (5.656854249492381 - tracking_index) + (
        9.681293988705875e-08 if form.single else -3.8669173253811654e-16
    )
    t101 = (t99 / ((t80 * t96) + 4.0)) / tracking_index
    t106 = t80 + 2.309401076758503
    t109 = (20.784609690826528 - tracking_index) + (
        8.498841452819761e-07 if form.single else -5.721467327834222e-16
    )
    t110 = t109 / ((t80 * t106) + 1.3333333333333333)
    t113 = (t110 / tracking_index) * 3.079201435678004
    t115 = t80 + 2.0
    t123 = (((t113 / t80) / t115) * (t106 / t80)) / t115
    t116 = 1.0 / t89
    t117 = 1.0 / form.sqrt(t89)
    t119 = ((t101 * 11.313708498984761) / t80) * (t96 / t115)
    t125 = t123 * -12.0
    return (t116, t117, t119, t125)


def _closed_loop_poles_block(
    given: Arrays,
    out: Arrays,
    work: Arrays,
    single: bool,
    n0: float = 1.0,
    n1: float = 2.0,
    n2: float = 0.5,
    n3: float = 0.0625,
    n4: float = 8.0,
    n5: float = 0.25,
    n6: float = 0.125,
    n7: float = 2.8284271247461903,
    n8: float = 4.0,
    n9: float = 5.656854249492381,
    n10: float = 9.681293988705875e-08,
    n11: float = -3.8669173253811654e-16,
    n12: float = 11.313708498984761,
    n13: float = 2.309401076758503,
    n14: float = 1.3333333333333333,
    n15: float = 20.784609690826528,
    n16: float = 8.498841452819761e-07,
    n17: float = -5.721467327834222e-16,
    n18: float = 3.079201435678004,
    n19: float = -12.0,
) -> None:
    (tracking_index,) = given
    real_pole, modulus, half_sum, quarter_discriminant = out
    w0, w1, w2, w3, w4, w5 = work
    p = sqrt(tracking_index, real_pole)
    r = sqrt(p, modulus)
    t4 = divide(n0, p, half_sum)
    t5 = multiply(t4, r, w0)
    t7 = multiply(t5, n1, w0)
    t9 = multiply(p, n2, w1)
    t11 = multiply(tracking_index, n3, w2)
    t12 = multiply(p, r, w3)
    t13 = multiply(t12, n0, w3)
    t15 = divide(n4, r, quarter_discriminant)
    t16 = add(t13, t15, w3)
    t17 = near_cbrt(t16, w3, single)
    t20 = multiply(t7, t17, quarter_discriminant)
    t21 = add(t20, t11, quarter_discriminant)
    t22 = sqrt(t21, quarter_discriminant)
    t23 = multiply(t22, n1, w4)
    t24 = add(t23, t9, w4)
    t25 = sqrt(t24, w4)
    t26 = multiply(t7, n2, w5)
    t27 = multiply(t22, t25, quarter_discriminant)
    t28 = multiply(t25, t27, w4)
    t29 = multiply(t26, t17, w3)
    t30 = subtract(t28, t29, w4)
    t31 = subtract(t27, t26, quarter_discriminant)
    t32 = divide(t30, t31, w4)
    t34 = multiply(t7, t32, w3)
    t35 = add(t34, t11, w3)
    t36 = sqrt(t35, w3)
    t37 = multiply(t36, n1, quarter_discriminant)
    t38 = add(t37, t9, quarter_discriminant)
    t39 = sqrt(t38, quarter_discriminant)
    t40 = multiply(t36, t39, w3)
    t41 = multiply(t39, t40, quarter_discriminant)
    t42 = multiply(t26, t32, w4)
    t43 = subtract(t41, t42, quarter_discriminant)
    t44 = subtract(t40, t26, w3)
    t45 = divide(t43, t44, quarter_discriminant)
    t47 = multiply(t7, t45, w3)
    t48 = add(t47, t11, w3)
    t49 = sqrt(t48, w3)
    t50 = multiply(t49, n1, w4)
    t51 = add(t50, t9, w4)
    t52 = sqrt(t51, w4)
    t53 = multiply(t49, t52, w3)
    t54 = multiply(t52, t53, w4)
    t55 = multiply(t26, t45, quarter_discriminant)
    t56 = subtract(t54, t55, w4)
    t57 = subtract(t53, t26, w3)
    t58 = divide(t56, t57, w4)
    t60 = multiply(t7, t58, w3)
    t61 = add(t60, t11, w3)
    t62 = sqrt(t61, w3)
    t63 = multiply(t62, n1, quarter_discriminant)
    t64 = add(t63, t9, quarter_discriminant)
    t65 = sqrt(t64, quarter_discriminant)
    t66 = multiply(t62, t65, w3)
    t67 = multiply(t65, t66, quarter_discriminant)
    t68 = multiply(t26, t58, w4)
    t69 = subtract(t67, t68, quarter_discriminant)
    t70 = subtract(t66, t26, w3)
    t71 = divide(t69, t70, quarter_discriminant)
    t73 = multiply(t7, t71, w0)
    t74 = add(t73, t11, w0)
    e = sqrt(t74, w0)
    t76 = multiply(e, n1, w2)
    t77 = add(t76, t9, w2)
    x = sqrt(t77, w2)
    t79 = divide(x, r, w1)
    t80 = multiply(t79, n1, w1)
    t81 = multiply(e, n2, w0)
    t82 = add(t4, t81, half_sum)
    t83 = multiply(x, r, w2)
    t85 = multiply(t83, n5, w2)
    t86 = multiply(p, n6, w0)
    t87 = add(t85, t86, w2)
    t88 = add(t82, t87, half_sum)
    t89 = multiply(p, t88, real_pole)
    modulus_inverse = sqrt(t89, w0)
    t96 = add(t80, n7, w2)
    t97 = multiply(t80, t96, w3)
    t98 = add(t97, n8, w3)
    rest = n10 if single else n11
    subtract(n9, tracking_index, w4)
    t99 = add(w4, rest, w4)
    t100 = divide(t99, t98, w4)
    t101 = divide(t100, tracking_index, w4)
    t103 = multiply(t101, n12, w4)
    t104 = divide(t103, t80, w4)
    t106 = add(t80, n13, w3)
    t107 = multiply(t80, t106, w5)
    t108 = add(t107, n14, w5)
    rest_ = n16 if single else n17
    subtract(n15, tracking_index, modulus)
    t109 = add(modulus, rest_, modulus)
    t110 = divide(t109, t108, modulus)
    t111 = divide(t110, tracking_index, modulus)
    t113 = multiply(t111, n18, modulus)
    t114 = divide(t113, t80, modulus)
    t115 = add(t80, n1, w5)
    t118 = divide(t96, t115, w2)
    t120 = divide(t114, t115, modulus)
    t121 = divide(t106, t80, w3)
    t122 = multiply(t120, t121, modulus)
    t123 = divide(t122, t115, w5)
    divide(n0, t89, real_pole)
    divide(n0, modulus_inverse, modulus)
    multiply(t104, t118, half_sum)
    multiply(t123, n19, quarter_discriminant)


_CLOSED_LOOP_POLES = Signature(
    "closed_loop_poles",
    (_TRACKING_INDEX_DOMAIN,),
    ("real_pole", "modulus", "half_sum", "quarter_discriminant"),
    6,
    _closed_loop_poles_block,
    numbers=_closed_loop_poles_of_numbers,
)


class IndexFromAlpha(NamedTuple):
    """Result of `index_from_alpha`."""

    tracking_index: Real
    """Tracking index Lambda."""


def index_from_alpha(
    alpha: ArrayLike, *, out: tuple[Real] | None = None, workers: int = 1
) -> IndexFromAlpha:
    """The tracking index that belongs to a position gain.

        beta = 2 (1 - w)^2, gamma = 2 (1 - w)^3/(1 + w),
        Lambda = gamma/w, w = sqrt(1 - alpha)

    alpha: position gain; a number at least 2^-330 and below 1, in float32 at least 2^-40 and below
        1.

    tracking_index: tracking index Lambda. Relative error at most 7.76 * 2^-52 (float64), 7.76 *
        2^-23 (float32), proved for 4.5719495651291e-100 <= alpha <= 0.9999999999999999 (float64)
        and 9.094947e-13 <= alpha <= 0.99999994 (float32).

    Outside an output's range, a few numbers next to its ends apart, its true value is no normal
    number: it comes as 0, a subnormal number or infinity, never as NaN. Numbers and arrays are
    taken, arrays of any shape; inputs are broadcast. float64 and float32 stay what they are,
    integers become float64. `out`: a tuple of arrays to fill. `workers`: threads that share the
    work on long arrays.

    ValueError: an input outside its domain, with its place; `out` or `workers` that does not fit.
    TypeError: an input that is no real number of these types; in `out` what is no array of the
    results' type.

    Source: derivation wiener-acceleration
    """
    if (
        type(alpha) is float
        and 4.5719495651291e-100 <= alpha <= 0.9999999999999999
        and out is None
        and workers is ONE
    ):
        try:
            return named(IndexFromAlpha, _index_from_alpha_of_numbers(alpha))
        except (ArithmeticError, ValueError):
            pass  # arrays say what is wrong
    return IndexFromAlpha(*evaluate(_INDEX_FROM_ALPHA, (alpha,), out, workers))


def _index_from_alpha_of_numbers(alpha: float, form: Form = Double) -> tuple[float, ...]:
    t3 = form.sqrt(1.0 - alpha)
    t4 = t3 + 1.0
    t5 = alpha / t4
    t11 = (((t5 * t5) * 2.0) * (t5 / t4)) / t3
    return (t11,)


def _index_from_alpha_block(
    given: Arrays, out: Arrays, work: Arrays, _single: bool, n0: float = 1.0, n1: float = 2.0
) -> None:
    (alpha,) = given
    (tracking_index,) = out
    w0, w1, w2 = work
    t2 = subtract(n0, alpha, w0)
    w = sqrt(t2, tracking_index)
    t4 = add(w, n0, w0)
    t5 = divide(alpha, t4, w1)
    t6 = square(t5, w2)
    t8 = multiply(t6, n1, w2)
    t9 = divide(t5, t4, w1)
    t10 = multiply(t8, t9, w2)
    divide(t10, w, tracking_index)


_INDEX_FROM_ALPHA = Signature(
    "index_from_alpha",
    (_ALPHA_DOMAIN,),
    ("tracking_index",),
    3,
    _index_from_alpha_block,
    numbers=_index_from_alpha_of_numbers,
)


class GainsFromAlpha(NamedTuple):
    """Result of `gains_from_alpha`."""

    beta: Real
    """Velocity gain times the sampling interval."""
    gamma: Real
    """Acceleration gain times the square of the sampling interval."""


def gains_from_alpha(
    alpha: ArrayLike, *, out: tuple[Real, Real] | None = None, workers: int = 1
) -> GainsFromAlpha:
    """The velocity and acceleration gain that belong to a position gain.

        beta = 2 (1 - w)^2, gamma = 2 (1 - w)^3/(1 + w),
        Lambda = gamma/w, w = sqrt(1 - alpha)

    alpha: position gain; a number at least 2^-330 and below 1, in float32 at least 2^-40 and below
        1.

    beta: velocity gain times the sampling interval. Relative error at most 3.26 * 2^-52 (float64),
        3.26 * 2^-23 (float32), proved for 4.5719495651291e-100 <= alpha <= 0.9999999999999999
        (float64) and 9.094947e-13 <= alpha <= 0.99999994 (float32).
    gamma: acceleration gain times the square of the sampling interval. Relative error at most 6.51
        * 2^-52 (float64), 6.51 * 2^-23 (float32), proved for 4.5719495651291e-100 <= alpha <=
        0.9999999999999999 (float64) and 9.094947e-13 <= alpha <= 0.99999994 (float32).

    Outside an output's range, a few numbers next to its ends apart, its true value is no normal
    number: it comes as 0, a subnormal number or infinity, never as NaN. Numbers and arrays are
    taken, arrays of any shape; inputs are broadcast. float64 and float32 stay what they are,
    integers become float64. `out`: a tuple of arrays to fill. `workers`: threads that share the
    work on long arrays.

    ValueError: an input outside its domain, with its place; `out` or `workers` that does not fit.
    TypeError: an input that is no real number of these types; in `out` what is no array of the
    results' type.

    Source: derivation wiener-acceleration
    """
    if (
        type(alpha) is float
        and 4.5719495651291e-100 <= alpha <= 0.9999999999999999
        and out is None
        and workers is ONE
    ):
        try:
            return named(GainsFromAlpha, _gains_from_alpha_of_numbers(alpha))
        except (ArithmeticError, ValueError):
            pass  # arrays say what is wrong
    return GainsFromAlpha(*evaluate(_GAINS_FROM_ALPHA, (alpha,), out, workers))


def _gains_from_alpha_of_numbers(alpha: float, form: Form = Double) -> tuple[float, ...]:
    t4 = form.sqrt(1.0 - alpha) + 1.0
    t5 = alpha / t4
    t8 = (t5 * t5) * 2.0
    t10 = t8 * (t5 / t4)
    return (t8, t10)


def _gains_from_alpha_block(
    given: Arrays, out: Arrays, work: Arrays, _single: bool, n0: float = 1.0, n1: float = 2.0
) -> None:
    (alpha,) = given
    beta, gamma = out
    (w0,) = work
    t2 = subtract(n0, alpha, w0)
    w = sqrt(t2, beta)
    t4 = add(w, n0, w0)
    t5 = divide(alpha, t4, gamma)
    t6 = square(t5, beta)
    multiply(t6, n1, beta)
    t9 = divide(t5, t4, gamma)
    multiply(beta, t9, gamma)


_GAINS_FROM_ALPHA = Signature(
    "gains_from_alpha",
    (_ALPHA_DOMAIN,),
    ("beta", "gamma"),
    1,
    _gains_from_alpha_block,
    numbers=_gains_from_alpha_of_numbers,
)
