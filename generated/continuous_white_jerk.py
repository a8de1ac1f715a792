# Made by: gainproof generate continuous-white-jerk
# From: gainproof derive continuous-white-jerk, SymPy 1.14.0
"""Continuous white jerk: steady state with measured position."""

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
    "GainsWithDerivatives",
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
    "gains_with_derivatives",
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
        delta = sqrt(64/Lambda^2 + 2/15),
        xi = sqrt(2 + 2 eta), eta = sqrt(17/15 + 2 delta xi), nu = 1 + xi + eta + delta

    tracking_index: Lambda, with Lambda^2 =
        jerk_density*sampling_interval**5/measurement_deviation**2; a number above 0 and finite.

    alpha: position gain. Relative error at most 6.18 * 2^-52 (float64), 6.17 * 2^-23 (float32),
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

    Source: derivation continuous-white-jerk
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
    t2 = form.sqrt(tracking_index)
    t3 = form.sqrt(t2)
    t5 = 2.220446049250313e-16 / tracking_index
    t7 = tracking_index * 4.625929269271486e-19
    t11 = form.sqrt(t5 + t7) * 67108864.0
    t13 = (t11 * t3) * 2.0
    t15 = t2 * 0.5
    t17 = tracking_index * 0.07083333333333333
    t24 = ((t2 * t3) * 1.5516447222296765) + (8.0 / t3)
    t25 = form.near_cbrt(t24)
    t29 = form.sqrt((t13 * t25) + t17)
    t32 = form.sqrt((t29 * 2.0) + t15)
    t33 = t13 * 0.5
    t34 = t29 * t32
    t39 = ((t32 * t34) - (t33 * t25)) / (t34 - t33)
    t43 = form.sqrt((t13 * t39) + t17)
    t46 = form.sqrt((t43 * 2.0) + t15)
    t47 = t43 * t46
    t52 = ((t46 * t47) - (t33 * t39)) / (t47 - t33)
    t56 = form.sqrt((t13 * t52) + t17)
    t59 = form.sqrt((t56 * 2.0) + t15)
    t60 = t56 * t59
    t65 = ((t59 * t60) - (t33 * t52)) / (t60 - t33)
    t69 = form.sqrt((t13 * t65) + t17)
    t72 = form.sqrt((t69 * 2.0) + t15)
    t73 = t69 * t72
    t78 = ((t72 * t73) - (t33 * t65)) / (t73 - t33)
    t82 = form.sqrt((t13 * t78) + t17)
    t91 = form.sqrt((t82 * 2.0) + t15) * t3
    t95 = (t11 + (t82 * 0.5)) + ((t91 * 0.25) + (t2 * 0.125))
    t96 = (t82 + (t2 * 0.25)) / t95
    t97 = t91 / t95
    t98 = t2 / t95
    return (t96, t97, t98)


def _gains_block(
    given: Arrays,
    out: Arrays,
    work: Arrays,
    single: bool,
    n0: float = 2.220446049250313e-16,
    n1: float = 4.625929269271486e-19,
    n2: float = 67108864.0,
    n3: float = 2.0,
    n4: float = 0.5,
    n5: float = 0.07083333333333333,
    n6: float = 1.5516447222296765,
    n7: float = 8.0,
    n8: float = 0.25,
    n9: float = 0.125,
) -> None:
    (tracking_index,) = given
    alpha, beta, gamma = out
    w0, w1, w2, w3, w4, w5, w6 = work
    p = sqrt(tracking_index, gamma)
    r = sqrt(p, alpha)
    t5 = divide(n0, tracking_index, beta)
    t7 = multiply(tracking_index, n1, w0)
    t8 = add(t5, t7, beta)
    c_scaled = sqrt(t8, beta)
    t11 = multiply(c_scaled, n2, beta)
    t12 = multiply(t11, r, w0)
    t13 = multiply(t12, n3, w0)
    t15 = multiply(p, n4, w1)
    t17 = multiply(tracking_index, n5, w2)
    t18 = multiply(p, r, w3)
    t21 = multiply(t18, n6, w3)
    t23 = divide(n7, r, w4)
    t24 = add(t21, t23, w3)
    t25 = near_cbrt(t24, w3, single)
    t27 = multiply(t13, t25, w4)
    t28 = add(t27, t17, w4)
    t29 = sqrt(t28, w4)
    t30 = multiply(t29, n3, w5)
    t31 = add(t30, t15, w5)
    t32 = sqrt(t31, w5)
    t33 = multiply(t13, n4, w6)
    t34 = multiply(t29, t32, w4)
    t35 = multiply(t32, t34, w5)
    t36 = multiply(t33, t25, w3)
    t37 = subtract(t35, t36, w5)
    t38 = subtract(t34, t33, w4)
    t39 = divide(t37, t38, w5)
    t41 = multiply(t13, t39, w3)
    t42 = add(t41, t17, w3)
    t43 = sqrt(t42, w3)
    t44 = multiply(t43, n3, w4)
    t45 = add(t44, t15, w4)
    t46 = sqrt(t45, w4)
    t47 = multiply(t43, t46, w3)
    t48 = multiply(t46, t47, w4)
    t49 = multiply(t33, t39, w5)
    t50 = subtract(t48, t49, w4)
    t51 = subtract(t47, t33, w3)
    t52 = divide(t50, t51, w4)
    t54 = multiply(t13, t52, w3)
    t55 = add(t54, t17, w3)
    t56 = sqrt(t55, w3)
    t57 = multiply(t56, n3, w5)
    t58 = add(t57, t15, w5)
    t59 = sqrt(t58, w5)
    t60 = multiply(t56, t59, w3)
    t61 = multiply(t59, t60, w5)
    t62 = multiply(t33, t52, w4)
    t63 = subtract(t61, t62, w5)
    t64 = subtract(t60, t33, w3)
    t65 = divide(t63, t64, w5)
    t67 = multiply(t13, t65, w3)
    t68 = add(t67, t17, w3)
    t69 = sqrt(t68, w3)
    t70 = multiply(t69, n3, w4)
    t71 = add(t70, t15, w4)
    t72 = sqrt(t71, w4)
    t73 = multiply(t69, t72, w3)
    t74 = multiply(t72, t73, w4)
    t75 = multiply(t33, t65, w5)
    t76 = subtract(t74, t75, w4)
    t77 = subtract(t73, t33, w3)
    t78 = divide(t76, t77, w4)
    t80 = multiply(t13, t78, w0)
    t81 = add(t80, t17, w0)
    e = sqrt(t81, w0)
    t83 = multiply(e, n3, w2)
    t84 = add(t83, t15, w2)
    x = sqrt(t84, w2)
    t87 = multiply(p, n8, w1)
    t88 = add(e, t87, w1)
    t89 = multiply(e, n4, w0)
    t90 = add(t11, t89, beta)
    t91 = multiply(x, r, w2)
    t92 = multiply(t91, n8, w0)
    t93 = multiply(p, n9, w3)
    t94 = add(t92, t93, w0)
    t95 = add(t90, t94, w0)
    divide(t88, t95, alpha)
    divide(t91, t95, beta)
    divide(p, t95, gamma)


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
    t1 = multiply(tracking_index, tracking_index)
    t3 = divide((64.0, 0.0), t1)
    t5 = add(t3, (0.13333333333333333, 1.8503717077085942e-18))
    delta = root(t5)
    # what the plain kernel gives is near the root
    near = evaluate(_GAINS, exact(given)[:1], None, 1)
    near_xi = exact(2.0 * near[1] / near[2])
    t8 = multiply(delta, near_xi)
    t10 = scale(t8, 2.0)
    t12 = add(t10, (1.1333333333333333, 2.960594732333751e-17))
    near_eta = root(t12)
    t14 = scale(near_eta, 2.0)
    t15 = add(t14, (2.0, 0.0))
    image = root(t15)
    t17 = multiply(near_xi, near_eta)
    t18 = divide(delta, t17)
    xi = refined(near_xi, image, t18)
    t20 = multiply(delta, xi)
    t21 = scale(t20, 2.0)
    t22 = add(t21, (1.1333333333333333, 2.960594732333751e-17))
    eta = root(t22)
    t24 = add(xi, eta)
    t26 = add(t24, (1.0, 0.0))
    nu = add(delta, t26)
    t28 = add(eta, (1.0, 0.0))
    t29 = scale(t28, 2.0)
    t30 = divide(t29, nu)
    t32 = scale(xi, 4.0)
    t33 = divide(t32, nu)
    t35 = divide((8.0, 0.0), nu)
    return (t30[0], t33[0], t35[0])


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

        delta = sqrt(64/Lambda^2 + 2/15),
        xi = sqrt(2 + 2 eta), eta = sqrt(17/15 + 2 delta xi), nu = 1 + xi + eta + delta

    tracking_index: Lambda, with Lambda^2 =
        jerk_density*sampling_interval**5/measurement_deviation**2; a number above 0 and finite.

    alpha: derivative of the position gain. Relative error at most 15.44 * 2^-52 (float64), 15.46 *
        2^-23 (float32), proved for 5e-324 <= tracking_index <= 5.849498211276313e102 (float64) and
        1e-45 <= tracking_index <= 7.235911e12 (float32).
    beta: derivative of the velocity gain times the sampling interval. Relative error at most 15.94
        * 2^-52 (float64), 15.94 * 2^-23 (float32), proved for 5e-324 <= tracking_index <=
        1.6140834523330185e103 (float64) and 1e-45 <= tracking_index <= 1.9966437e13 (float32).
    gamma: derivative of the acceleration gain times the square of the sampling interval. Relative
        error at most 16.16 * 2^-52 (float64), 16.17 * 2^-23 (float32), proved for 5e-324 <=
        tracking_index <= 1.9098208591277692e103 (float64) and 1e-45 <= tracking_index <=
        2.362475e13 (float32).

    Outside an output's range, a few numbers next to its ends apart, its true value is no normal
    number: it comes as 0, a subnormal number or infinity, never as NaN. Numbers and arrays are
    taken, arrays of any shape; inputs are broadcast. float64 and float32 stay what they are,
    integers become float64. `out`: a tuple of arrays to fill. `workers`: threads that share the
    work on long arrays.

    ValueError: an input outside its domain, with its place; `out` or `workers` that does not fit.
    TypeError: an input that is no real number of these types; in `out` what is no array of the
    results' type.

    Source: derivation continuous-white-jerk
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
    t3 = form.sqrt(tracking_index)
    t4 = form.sqrt(t3)
    t6 = 2.220446049250313e-16 / tracking_index
    t8 = tracking_index * 4.625929269271486e-19
    t12 = form.sqrt(t6 + t8) * 67108864.0
    t14 = (t12 * t4) * 2.0
    t16 = t3 * 0.5
    t18 = tracking_index * 0.07083333333333333
    t25 = ((t3 * t4) * 1.5516447222296765) + (8.0 / t4)
    t26 = form.near_cbrt(t25)
    t30 = form.sqrt((t14 * t26) + t18)
    t33 = form.sqrt((t30 * 2.0) + t16)
    t34 = t14 * 0.5
    t35 = t30 * t33
    t40 = ((t33 * t35) - (t34 * t26)) / (t35 - t34)
    t44 = form.sqrt((t14 * t40) + t18)
    t47 = form.sqrt((t44 * 2.0) + t16)
    t48 = t44 * t47
    t53 = ((t47 * t48) - (t34 * t40)) / (t48 - t34)
    t57 = form.sqrt((t14 * t53) + t18)
    t60 = form.sqrt((t57 * 2.0) + t16)
    t61 = t57 * t60
    t66 = ((t60 * t61) - (t34 * t53)) / (t61 - t34)
    t70 = form.sqrt((t14 * t66) + t18)
    t73 = form.sqrt((t70 * 2.0) + t16)
    t74 = t70 * t73
    t79 = ((t73 * t74) - (t34 * t66)) / (t74 - t34)
    t83 = form.sqrt((t14 * t79) + t18)
    t89 = t83 + (t3 * 0.25)
    t90 = form.sqrt((t83 * 2.0) + t16) * t4
    t91 = t90 / t12
    t95 = t89 + ((t91 * t3) * 0.008333333333333333)
    t96 = t83 * t83
    t99 = t3 * t83
    t103 = tracking_index * 0.017708333333333333
    t104 = ((t96 * 0.75) + (t99 * 0.25)) + t103
    t106 = t90 * 0.25
    t108 = ((t95 / t104) * t106) / tracking_index
    t114 = (t12 + (t83 * 0.5)) + (t106 + (t3 * 0.125))
    t121 = ((t96 * 0.25) + (t99 * 0.125)) + t103
    t125 = (t121 + (t90 * (t89 * 0.125))) / t104
    t128 = (t125 * 2.0) * (t91 / tracking_index)
    t129 = t3 * t114
    t136 = ((t90 / t104) * ((t89 + t106) * 0.5)) + 1.0
    t117 = (((t108 * 2.0) / t114) / t114) / tracking_index
    t131 = (t128 / t129) / t129
    t140 = ((t136 / (t12 * t3)) / t129) / t129
    return (t117, t131, t140)


def _gain_derivatives_block(
    given: Arrays,
    out: Arrays,
    work: Arrays,
    single: bool,
    n0: float = 2.220446049250313e-16,
    n1: float = 4.625929269271486e-19,
    n2: float = 67108864.0,
    n3: float = 2.0,
    n4: float = 0.5,
    n5: float = 0.07083333333333333,
    n6: float = 1.5516447222296765,
    n7: float = 8.0,
    n8: float = 0.25,
    n9: float = 0.008333333333333333,
    n10: float = 0.75,
    n11: float = 0.017708333333333333,
    n12: float = 0.125,
    n13: float = 1.0,
) -> None:
    (tracking_index,) = given
    alpha, beta, gamma = out
    w0, w1, w2, w3, w4, w5, w6, w7, w8, w9 = work
    p = sqrt(tracking_index, alpha)
    r = sqrt(p, beta)
    t6 = divide(n0, tracking_index, gamma)
    t8 = multiply(tracking_index, n1, w0)
    t9 = add(t6, t8, gamma)
    c_scaled = sqrt(t9, gamma)
    t12 = multiply(c_scaled, n2, gamma)
    t13 = multiply(t12, r, w0)
    t14 = multiply(t13, n3, w0)
    t16 = multiply(p, n4, w1)
    t18 = multiply(tracking_index, n5, w2)
    t19 = multiply(p, r, w3)
    t22 = multiply(t19, n6, w3)
    t24 = divide(n7, r, w4)
    t25 = add(t22, t24, w3)
    t26 = near_cbrt(t25, w3, single)
    t28 = multiply(t14, t26, w4)
    t29 = add(t28, t18, w4)
    t30 = sqrt(t29, w4)
    t31 = multiply(t30, n3, w5)
    t32 = add(t31, t16, w5)
    t33 = sqrt(t32, w5)
    t34 = multiply(t14, n4, w6)
    t35 = multiply(t30, t33, w4)
    t36 = multiply(t33, t35, w5)
    t37 = multiply(t34, t26, w3)
    t38 = subtract(t36, t37, w5)
    t39 = subtract(t35, t34, w4)
    t40 = divide(t38, t39, w5)
    t42 = multiply(t14, t40, w3)
    t43 = add(t42, t18, w3)
    t44 = sqrt(t43, w3)
    t45 = multiply(t44, n3, w4)
    t46 = add(t45, t16, w4)
    t47 = sqrt(t46, w4)
    t48 = multiply(t44, t47, w3)
    t49 = multiply(t47, t48, w4)
    t50 = multiply(t34, t40, w5)
    t51 = subtract(t49, t50, w4)
    t52 = subtract(t48, t34, w3)
    t53 = divide(t51, t52, w4)
    t55 = multiply(t14, t53, w3)
    t56 = add(t55, t18, w3)
    t57 = sqrt(t56, w3)
    t58 = multiply(t57, n3, w5)
    t59 = add(t58, t16, w5)
    t60 = sqrt(t59, w5)
    t61 = multiply(t57, t60, w3)
    t62 = multiply(t60, t61, w5)
    t63 = multiply(t34, t53, w4)
    t64 = subtract(t62, t63, w5)
    t65 = subtract(t61, t34, w3)
    t66 = divide(t64, t65, w5)
    t68 = multiply(t14, t66, w3)
    t69 = add(t68, t18, w3)
    t70 = sqrt(t69, w3)
    t71 = multiply(t70, n3, w4)
    t72 = add(t71, t16, w4)
    t73 = sqrt(t72, w4)
    t74 = multiply(t70, t73, w3)
    t75 = multiply(t73, t74, w4)
    t76 = multiply(t34, t66, w5)
    t77 = subtract(t75, t76, w4)
    t78 = subtract(t74, t34, w3)
    t79 = divide(t77, t78, w4)
    t81 = multiply(t14, t79, w0)
    t82 = add(t81, t18, w0)
    e = sqrt(t82, w0)
    t84 = multiply(e, n3, w2)
    t85 = add(t84, t16, w2)
    x = sqrt(t85, w2)
    t88 = multiply(p, n8, w1)
    t89 = add(e, t88, w1)
    t90 = multiply(x, r, w2)
    t91 = divide(t90, t12, w3)
    t92 = multiply(t91, p, w4)
    t94 = multiply(t92, n9, w4)
    t95 = add(t89, t94, w4)
    t96 = square(e, w5)
    t98 = multiply(t96, n10, w6)
    t99 = multiply(p, e, beta)
    t100 = multiply(t99, n8, w7)
    t101 = add(t98, t100, w6)
    t103 = multiply(tracking_index, n11, w7)
    t104 = add(t101, t103, w6)
    t105 = divide(t95, t104, w4)
    t106 = multiply(t90, n8, w8)
    t107 = multiply(t105, t106, w4)
    t108 = divide(t107, tracking_index, w4)
    t109 = multiply(t108, n3, w4)
    t110 = multiply(e, n4, w0)
    t111 = add(t12, t110, w0)
    t112 = multiply(p, n12, w9)
    t113 = add(t106, t112, w9)
    t114 = add(t111, t113, w0)
    t115 = divide(t109, t114, w4)
    t116 = divide(t115, t114, w4)
    t118 = multiply(t96, n8, w5)
    t119 = multiply(t99, n12, beta)
    t120 = add(t118, t119, w5)
    t121 = add(t120, t103, w5)
    t122 = multiply(t89, n12, w7)
    t123 = multiply(t90, t122, w7)
    t124 = add(t121, t123, w5)
    t125 = divide(t124, t104, w5)
    t126 = multiply(t125, n3, w5)
    t127 = divide(t91, tracking_index, w3)
    t128 = multiply(t126, t127, w5)
    t129 = multiply(p, t114, w0)
    t130 = divide(t128, t129, w5)
    t132 = divide(t90, t104, w2)
    t133 = add(t89, t106, w1)
    t134 = multiply(t133, n4, w1)
    t135 = multiply(t132, t134, w2)
    t136 = add(t135, n13, w2)
    t137 = multiply(t12, p, gamma)
    t138 = divide(t136, t137, w2)
    t139 = divide(t138, t129, w2)
    divide(t116, tracking_index, alpha)
    divide(t130, t129, beta)
    divide(t139, t129, gamma)


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

        delta = sqrt(64/Lambda^2 + 2/15),
        xi = sqrt(2 + 2 eta), eta = sqrt(17/15 + 2 delta xi), nu = 1 + xi + eta + delta

    tracking_index: Lambda, with Lambda^2 =
        jerk_density*sampling_interval**5/measurement_deviation**2; a number above 0 and finite.

    alpha: position gain. Relative error at most 6.18 * 2^-52 (float64), 6.17 * 2^-23 (float32),
        proved for 5e-324 <= tracking_index <= 1.7976931348623157e308 (float64) and 1e-45 <=
        tracking_index <= 3.4028235e38 (float32).
    beta: velocity gain times the sampling interval. Relative error at most 6.09 * 2^-52 (float64),
        6.09 * 2^-23 (float32), proved for 5e-324 <= tracking_index <= 1.7976931348623157e308
        (float64) and 1e-45 <= tracking_index <= 3.4028235e38 (float32).
    gamma: acceleration gain times the square of the sampling interval. Relative error at most 4.55
        * 2^-52 (float64), 4.55 * 2^-23 (float32), proved for 2.2250738585072014e-308 <=
        tracking_index <= 1.7976931348623157e308 (float64) and 1.1754945e-38 <= tracking_index <=
        3.4028235e38 (float32).
    d_alpha: derivative of the position gain. Relative error at most 15.44 * 2^-52 (float64), 15.46
        * 2^-23 (float32), proved for 5e-324 <= tracking_index <= 5.849498211276313e102 (float64)
        and 1e-45 <= tracking_index <= 7.235911e12 (float32).
    d_beta: derivative of the velocity gain times the sampling interval. Relative error at most
        15.94 * 2^-52 (float64), 15.94 * 2^-23 (float32), proved for 5e-324 <= tracking_index <=
        1.6140834523330185e103 (float64) and 1e-45 <= tracking_index <= 1.9966437e13 (float32).
    d_gamma: derivative of the acceleration gain times the square of the sampling interval. Relative
        error at most 16.16 * 2^-52 (float64), 16.17 * 2^-23 (float32), proved for 5e-324 <=
        tracking_index <= 1.9098208591277692e103 (float64) and 1e-45 <= tracking_index <=
        2.362475e13 (float32).

    Outside an output's range, a few numbers next to its ends apart, its true value is no normal
    number: it comes as 0, a subnormal number or infinity, never as NaN. Numbers and arrays are
    taken, arrays of any shape; inputs are broadcast. float64 and float32 stay what they are,
    integers become float64. `out`: a tuple of arrays to fill. `workers`: threads that share the
    work on long arrays.

    ValueError: an input outside its domain, with its place; `out` or `workers` that does not fit.
    TypeError: an input that is no real number of these types; in `out` what is no array of the
    results' type.

    Source: derivation continuous-white-jerk
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
    t3 = form.sqrt(tracking_index)
    t4 = form.sqrt(t3)
    t6 = 2.220446049250313e-16 / tracking_index
    t8 = tracking_index * 4.625929269271486e-19
    t12 = form.sqrt(t6 + t8) * 67108864.0
    t14 = (t12 * t4) * 2.0
    t16 = t3 * 0.5
    t18 = tracking_index * 0.07083333333333333
    t25 = ((t3 * t4) * 1.5516447222296765) + (8.0 / t4)
    t26 = form.near_cbrt(t25)
    t30 = form.sqrt((t14 * t26) + t18)
    t33 = form.sqrt((t30 * 2.0) + t16)
    t34 = t14 * 0.5
    t35 = t30 * t33
    t40 = ((t33 * t35) - (t34 * t26)) / (t35 - t34)
    t44 = form.sqrt((t14 * t40) + t18)
    t47 = form.sqrt((t44 * 2.0) + t16)
    t48 = t44 * t47
    t53 = ((t47 * t48) - (t34 * t40)) / (t48 - t34)
    t57 = form.sqrt((t14 * t53) + t18)
    t60 = form.sqrt((t57 * 2.0) + t16)
    t61 = t57 * t60
    t66 = ((t60 * t61) - (t34 * t53)) / (t61 - t34)
    t70 = form.sqrt((t14 * t66) + t18)
    t73 = form.sqrt((t70 * 2.0) + t16)
    t74 = t70 * t73
    t79 = ((t73 * t74) - (t34 * t66)) / (t74 - t34)
    t83 = form.sqrt((t14 * t79) + t18)
    t89 = t83 + (t3 * 0.25)
    t92 = form.sqrt((t83 * 2.0) + t16) * t4
    t93 = t92 * 0.25
    t96 = (t12 + (t83 * 0.5)) + (t93 + (t3 * 0.125))
    t100 = t92 / t12
    t104 = t89 + ((t100 * t3) * 0.008333333333333333)
    t105 = t83 * t83
    t108 = t3 * t83
    t112 = tracking_index * 0.017708333333333333
    t113 = ((t105 * 0.75) + (t108 * 0.25)) + t112
    t116 = ((t104 / t113) * t93) / tracking_index
    t124 = ((t105 * 0.25) + (t108 * 0.125)) + t112
    t128 = (t124 + (t92 * (t89 * 0.125))) / t113
    t131 = (t128 * 2.0) * (t100 / tracking_index)
    t132 = t3 * t96
    t139 = ((t92 / t113) * ((t89 + t93) * 0.5)) + 1.0
    t97 = t89 / t96
    t98 = t92 / t96
    t99 = t3 / t96
    t120 = (((t116 * 2.0) / t96) / t96) / tracking_index
    t134 = (t131 / t132) / t132
    t143 = ((t139 / (t12 * t3)) / t132) / t132
    return (t97, t98, t99, t120, t134, t143)


def _gains_with_derivatives_block(
    given: Arrays,
    out: Arrays,
    work: Arrays,
    single: bool,
    n0: float = 2.220446049250313e-16,
    n1: float = 4.625929269271486e-19,
    n2: float = 67108864.0,
    n3: float = 2.0,
    n4: float = 0.5,
    n5: float = 0.07083333333333333,
    n6: float = 1.5516447222296765,
    n7: float = 8.0,
    n8: float = 0.25,
    n9: float = 0.125,
    n10: float = 0.008333333333333333,
    n11: float = 0.75,
    n12: float = 0.017708333333333333,
    n13: float = 1.0,
) -> None:
    (tracking_index,) = given
    alpha, beta, gamma, d_alpha, d_beta, d_gamma = out
    w0, w1, w2, w3, w4, w5 = work
    p = sqrt(tracking_index, gamma)
    r = sqrt(p, alpha)
    t6 = divide(n0, tracking_index, beta)
    t8 = multiply(tracking_index, n1, w0)
    t9 = add(t6, t8, beta)
    c_scaled = sqrt(t9, d_alpha)
    t12 = multiply(c_scaled, n2, d_alpha)
    t13 = multiply(t12, r, w0)
    t14 = multiply(t13, n3, w0)
    t16 = multiply(p, n4, beta)
    t18 = multiply(tracking_index, n5, w1)
    t19 = multiply(p, r, w2)
    t22 = multiply(t19, n6, w2)
    t24 = divide(n7, r, d_beta)
    t25 = add(t22, t24, w2)
    t26 = near_cbrt(t25, w2, single)
    t28 = multiply(t14, t26, d_beta)
    t29 = add(t28, t18, d_beta)
    t30 = sqrt(t29, d_gamma)
    t31 = multiply(t30, n3, d_beta)
    t32 = add(t31, t16, d_beta)
    t33 = sqrt(t32, d_beta)
    t34 = multiply(t14, n4, w3)
    t35 = multiply(t30, t33, d_gamma)
    t36 = multiply(t33, t35, d_beta)
    t37 = multiply(t34, t26, w2)
    t38 = subtract(t36, t37, d_beta)
    t39 = subtract(t35, t34, d_gamma)
    t40 = divide(t38, t39, d_beta)
    t42 = multiply(t14, t40, w2)
    t43 = add(t42, t18, w2)
    t44 = sqrt(t43, w2)
    t45 = multiply(t44, n3, d_gamma)
    t46 = add(t45, t16, d_gamma)
    t47 = sqrt(t46, d_gamma)
    t48 = multiply(t44, t47, w2)
    t49 = multiply(t47, t48, d_gamma)
    t50 = multiply(t34, t40, d_beta)
    t51 = subtract(t49, t50, d_gamma)
    t52 = subtract(t48, t34, w2)
    t53 = divide(t51, t52, d_gamma)
    t55 = multiply(t14, t53, w2)
    t56 = add(t55, t18, w2)
    t57 = sqrt(t56, w2)
    t58 = multiply(t57, n3, d_beta)
    t59 = add(t58, t16, d_beta)
    t60 = sqrt(t59, d_beta)
    t61 = multiply(t57, t60, w2)
    t62 = multiply(t60, t61, d_beta)
    t63 = multiply(t34, t53, d_gamma)
    t64 = subtract(t62, t63, d_beta)
    t65 = subtract(t61, t34, w2)
    t66 = divide(t64, t65, d_beta)
    t68 = multiply(t14, t66, w2)
    t69 = add(t68, t18, w2)
    t70 = sqrt(t69, w2)
    t71 = multiply(t70, n3, d_gamma)
    t72 = add(t71, t16, d_gamma)
    t73 = sqrt(t72, d_gamma)
    t74 = multiply(t70, t73, w2)
    t75 = multiply(t73, t74, d_gamma)
    t76 = multiply(t34, t66, d_beta)
    t77 = subtract(t75, t76, d_gamma)
    t78 = subtract(t74, t34, w2)
    t79 = divide(t77, t78, d_gamma)
    t81 = multiply(t14, t79, w0)
    t82 = add(t81, t18, w0)
    e = sqrt(t82, w0)
    t84 = multiply(e, n3, w1)
    t85 = add(t84, t16, w1)
    x = sqrt(t85, w1)
    t88 = multiply(p, n8, w2)
    t89 = add(e, t88, w2)
    t90 = multiply(e, n4, w3)
    t91 = add(t12, t90, w3)
    t92 = multiply(x, r, w1)
    t93 = multiply(t92, n8, alpha)
    t94 = multiply(p, n9, beta)
    t95 = add(t93, t94, beta)
    t96 = add(t91, t95, w3)
    t100 = divide(t92, t12, beta)
    t101 = multiply(t100, p, d_beta)
    t103 = multiply(t101, n10, d_beta)
    t104 = add(t89, t103, d_beta)
    t105 = square(e, d_gamma)
    t107 = multiply(t105, n11, w4)
    t108 = multiply(p, e, w0)
    t109 = multiply(t108, n8, w5)
    t110 = add(t107, t109, w4)
    t112 = multiply(tracking_index, n12, w5)
    t113 = add(t110, t112, w4)
    t114 = divide(t104, t113, d_beta)
    t115 = multiply(t114, t93, d_beta)
    t116 = divide(t115, tracking_index, d_beta)
    t117 = multiply(t116, n3, d_beta)
    t118 = divide(t117, t96, d_beta)
    t119 = divide(t118, t96, d_beta)
    t121 = multiply(t105, n8, d_gamma)
    t122 = multiply(t108, n9, w0)
    t123 = add(t121, t122, d_gamma)
    t124 = add(t123, t112, d_gamma)
    t125 = multiply(t89, n9, w0)
    t126 = multiply(t92, t125, w0)
    t127 = add(t124, t126, d_gamma)
    t128 = divide(t127, t113, d_gamma)
    t129 = multiply(t128, n3, d_gamma)
    t130 = divide(t100, tracking_index, beta)
    t131 = multiply(t129, t130, d_gamma)
    t132 = multiply(p, t96, w0)
    t133 = divide(t131, t132, d_gamma)
    t135 = divide(t92, t113, w4)
    t136 = add(t89, t93, alpha)
    t137 = multiply(t136, n4, alpha)
    t138 = multiply(t135, t137, w4)
    t139 = add(t138, n13, w4)
    t140 = multiply(t12, p, d_alpha)
    t141 = divide(t139, t140, w4)
    t142 = divide(t141, t132, w4)
    divide(t89, t96, alpha)
    divide(t92, t96, beta)
    divide(p, t96, gamma)
    divide(t119, tracking_index, d_alpha)
    divide(t133, t132, d_beta)
    divide(t142, t132, d_gamma)


_GAINS_WITH_DERIVATIVES = Signature(
    "gains_with_derivatives",
    (_TRACKING_INDEX_DOMAIN,),
    ("alpha", "beta", "gamma", "d_alpha", "d_beta", "d_gamma"),
    6,
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

        delta = sqrt(64/Lambda^2 + 2/15),
        xi = sqrt(2 + 2 eta), eta = sqrt(17/15 + 2 delta xi), nu = 1 + xi + eta + delta

    tracking_index: Lambda, with Lambda^2 =
        jerk_density*sampling_interval**5/measurement_deviation**2; a number above 0 and finite.

    position: position entry of F K, alpha + beta + gamma/2. Relative error at most 6.18 * 2^-52
        (float64), 6.18 * 2^-23 (float32), proved for 5e-324 <= tracking_index <=
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

    Source: derivation continuous-white-jerk
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
    t2 = form.sqrt(tracking_index)
    t3 = form.sqrt(t2)
    t5 = 2.220446049250313e-16 / tracking_index
    t7 = tracking_index * 4.625929269271486e-19
    t11 = form.sqrt(t5 + t7) * 67108864.0
    t13 = (t11 * t3) * 2.0
    t15 = t2 * 0.5
    t17 = tracking_index * 0.07083333333333333
    t24 = ((t2 * t3) * 1.5516447222296765) + (8.0 / t3)
    t25 = form.near_cbrt(t24)
    t29 = form.sqrt((t13 * t25) + t17)
    t32 = form.sqrt((t29 * 2.0) + t15)
    t33 = t13 * 0.5
    t34 = t29 * t32
    t39 = ((t32 * t34) - (t33 * t25)) / (t34 - t33)
    t43 = form.sqrt((t13 * t39) + t17)
    t46 = form.sqrt((t43 * 2.0) + t15)
    t47 = t43 * t46
    t52 = ((t46 * t47) - (t33 * t39)) / (t47 - t33)
    t56 = form.sqrt((t13 * t52) + t17)
    t59 = form.sqrt((t56 * 2.0) + t15)
    t60 = t56 * t59
    t65 = ((t59 * t60) - (t33 * t52)) / (t60 - t33)
    t69 = form.sqrt((t13 * t65) + t17)
    t72 = form.sqrt((t69 * 2.0) + t15)
    t73 = t69 * t72
    t78 = ((t72 * t73) - (t33 * t65)) / (t73 - t33)
    t82 = form.sqrt((t13 * t78) + t17)
    t86 = form.sqrt((t82 * 2.0) + t15) * t3
    t97 = (t11 + (t82 * 0.5)) + ((t86 * 0.25) + (t2 * 0.125))
    t98 = (t82 + (t86 + (t2 * 0.75))) / t97
    t100 = (t86 + t2) / t97
    t101 = t2 / t97
    return (t98, t100, t101)


def _predictor_gains_block(
    given: Arrays,
    out: Arrays,
    work: Arrays,
    single: bool,
    n0: float = 2.220446049250313e-16,
    n1: float = 4.625929269271486e-19,
    n2: float = 67108864.0,
    n3: float = 2.0,
    n4: float = 0.5,
    n5: float = 0.07083333333333333,
    n6: float = 1.5516447222296765,
    n7: float = 8.0,
    n8: float = 0.75,
    n9: float = 0.25,
    n10: float = 0.125,
) -> None:
    (tracking_index,) = given
    position, velocity, acceleration = out
    w0, w1, w2, w3, w4, w5, w6 = work
    p = sqrt(tracking_index, acceleration)
    r = sqrt(p, position)
    t5 = divide(n0, tracking_index, velocity)
    t7 = multiply(tracking_index, n1, w0)
    t8 = add(t5, t7, velocity)
    c_scaled = sqrt(t8, velocity)
    t11 = multiply(c_scaled, n2, velocity)
    t12 = multiply(t11, r, w0)
    t13 = multiply(t12, n3, w0)
    t15 = multiply(p, n4, w1)
    t17 = multiply(tracking_index, n5, w2)
    t18 = multiply(p, r, w3)
    t21 = multiply(t18, n6, w3)
    t23 = divide(n7, r, w4)
    t24 = add(t21, t23, w3)
    t25 = near_cbrt(t24, w3, single)
    t27 = multiply(t13, t25, w4)
    t28 = add(t27, t17, w4)
    t29 = sqrt(t28, w4)
    t30 = multiply(t29, n3, w5)
    t31 = add(t30, t15, w5)
    t32 = sqrt(t31, w5)
    t33 = multiply(t13, n4, w6)
    t34 = multiply(t29, t32, w4)
    t35 = multiply(t32, t34, w5)
    t36 = multiply(t33, t25, w3)
    t37 = subtract(t35, t36, w5)
    t38 = subtract(t34, t33, w4)
    t39 = divide(t37, t38, w5)
    t41 = multiply(t13, t39, w3)
    t42 = add(t41, t17, w3)
    t43 = sqrt(t42, w3)
    t44 = multiply(t43, n3, w4)
    t45 = add(t44, t15, w4)
    t46 = sqrt(t45, w4)
    t47 = multiply(t43, t46, w3)
    t48 = multiply(t46, t47, w4)
    t49 = multiply(t33, t39, w5)
    t50 = subtract(t48, t49, w4)
    t51 = subtract(t47, t33, w3)
    t52 = divide(t50, t51, w4)
    t54 = multiply(t13, t52, w3)
    t55 = add(t54, t17, w3)
    t56 = sqrt(t55, w3)
    t57 = multiply(t56, n3, w5)
    t58 = add(t57, t15, w5)
    t59 = sqrt(t58, w5)
    t60 = multiply(t56, t59, w3)
    t61 = multiply(t59, t60, w5)
    t62 = multiply(t33, t52, w4)
    t63 = subtract(t61, t62, w5)
    t64 = subtract(t60, t33, w3)
    t65 = divide(t63, t64, w5)
    t67 = multiply(t13, t65, w3)
    t68 = add(t67, t17, w3)
    t69 = sqrt(t68, w3)
    t70 = multiply(t69, n3, w4)
    t71 = add(t70, t15, w4)
    t72 = sqrt(t71, w4)
    t73 = multiply(t69, t72, w3)
    t74 = multiply(t72, t73, w4)
    t75 = multiply(t33, t65, w5)
    t76 = subtract(t74, t75, w4)
    t77 = subtract(t73, t33, w3)
    t78 = divide(t76, t77, w4)
    t80 = multiply(t13, t78, w0)
    t81 = add(t80, t17, w0)
    e = sqrt(t81, w0)
    t83 = multiply(e, n3, w2)
    t84 = add(t83, t15, w2)
    x = sqrt(t84, w2)
    t86 = multiply(x, r, w2)
    t88 = multiply(p, n8, w1)
    t89 = add(t86, t88, w1)
    t90 = add(e, t89, w1)
    t91 = multiply(e, n4, w0)
    t92 = add(t11, t91, velocity)
    t94 = multiply(t86, n9, w0)
    t95 = multiply(p, n10, w3)
    t96 = add(t94, t95, w0)
    t97 = add(t92, t96, w0)
    t99 = add(t86, p, w2)
    divide(t90, t97, position)
    divide(t99, t97, velocity)
    divide(p, t97, acceleration)


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

        delta = sqrt(64/Lambda^2 + 2/15),
        xi = sqrt(2 + 2 eta), eta = sqrt(17/15 + 2 delta xi), nu = 1 + xi + eta + delta

    tracking_index: Lambda, with Lambda^2 =
        jerk_density*sampling_interval**5/measurement_deviation**2; a number above 0 and finite.

    position: derivative of the position entry of F K, alpha + beta + gamma/2. Relative error at
        most 16.86 * 2^-52 (float64), 16.89 * 2^-23 (float32), proved for 5e-324 <= tracking_index
        <= 1.990641374279621e103 (float64) and 1e-45 <= tracking_index <= 2.4624511e13 (float32).
    velocity: derivative of the velocity entry of F K times the sampling interval, beta + gamma.
        Relative error at most 16.46 * 2^-52 (float64), 16.43 * 2^-23 (float32), proved for 5e-324
        <= tracking_index <= 2.235446903786528e103 (float64) and 1e-45 <= tracking_index <=
        2.765279e13 (float32).
    acceleration: derivative of the acceleration entry of F K times the square of the sampling
        interval, gamma. Relative error at most 16.16 * 2^-52 (float64), 16.17 * 2^-23 (float32),
        proved for 5e-324 <= tracking_index <= 1.9098208591277692e103 (float64) and 1e-45 <=
        tracking_index <= 2.362475e13 (float32).

    Outside an output's range, a few numbers next to its ends apart, its true value is no normal
    number: it comes as 0, a subnormal number or infinity, never as NaN. Numbers and arrays are
    taken, arrays of any shape; inputs are broadcast. float64 and float32 stay what they are,
    integers become float64. `out`: a tuple of arrays to fill. `workers`: threads that share the
    work on long arrays.

    ValueError: an input outside its domain, with its place; `out` or `workers` that does not fit.
    TypeError: an input that is no real number of these types; in `out` what is no array of the
    results' type.

    Source: derivation continuous-white-jerk
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
    t3 = form.sqrt(tracking_index)
    t4 = form.sqrt(t3)
    t6 = 2.220446049250313e-16 / tracking_index
    t8 = tracking_index * 4.625929269271486e-19
    t12 = form.sqrt(t6 + t8) * 67108864.0
    t14 = (t12 * t4) * 2.0
    t16 = t3 * 0.5
    t18 = tracking_index * 0.07083333333333333
    t25 = ((t3 * t4) * 1.5516447222296765) + (8.0 / t4)
    t26 = form.near_cbrt(t25)
    t30 = form.sqrt((t14 * t26) + t18)
    t33 = form.sqrt((t30 * 2.0) + t16)
    t34 = t14 * 0.5
    t35 = t30 * t33
    t40 = ((t33 * t35) - (t34 * t26)) / (t35 - t34)
    t44 = form.sqrt((t14 * t40) + t18)
    t47 = form.sqrt((t44 * 2.0) + t16)
    t48 = t44 * t47
    t53 = ((t47 * t48) - (t34 * t40)) / (t48 - t34)
    t57 = form.sqrt((t14 * t53) + t18)
    t60 = form.sqrt((t57 * 2.0) + t16)
    t61 = t57 * t60
    t66 = ((t60 * t61) - (t34 * t53)) / (t61 - t34)
    t70 = form.sqrt((t14 * t66) + t18)
    t73 = form.sqrt((t70 * 2.0) + t16)
    t74 = t70 * t73
    t79 = ((t73 * t74) - (t34 * t66)) / (t74 - t34)
    t83 = form.sqrt((t14 * t79) + t18)
    t89 = t83 + (t3 * 0.25)
    t90 = form.sqrt((t83 * 2.0) + t16) * t4
    t91 = t90 / t12
    t95 = t89 + ((t91 * t3) * 0.008333333333333333)
    t96 = t83 * t83
    t99 = t3 * t83
    t103 = tracking_index * 0.017708333333333333
    t104 = ((t96 * 0.75) + (t99 * 0.25)) + t103
    t106 = t90 * 0.25
    t108 = ((t95 / t104) * t106) / tracking_index
    t113 = ((t96 * 0.25) + (t99 * 0.125)) + t103
    t117 = (t113 + (t90 * (t89 * 0.125))) / t104
    t120 = (t117 * 2.0) * (t91 / tracking_index)
    t125 = ((t90 / t104) * ((t89 + t106) * 0.5)) + 1.0
    t127 = t125 / (t12 * t3)
    t135 = (t12 + (t83 * 0.5)) + (t106 + (t3 * 0.125))
    t136 = t3 * t135
    t137 = ((t108 * 2.0) + (t120 + (t127 * 0.5))) / t136
    t138 = t137 / t136
    t141 = ((t120 + t127) / t136) / t136
    t143 = (t127 / t136) / t136
    return (t138, t141, t143)


def _predictor_gain_derivatives_block(
    given: Arrays,
    out: Arrays,
    work: Arrays,
    single: bool,
    n0: float = 2.220446049250313e-16,
    n1: float = 4.625929269271486e-19,
    n2: float = 67108864.0,
    n3: float = 2.0,
    n4: float = 0.5,
    n5: float = 0.07083333333333333,
    n6: float = 1.5516447222296765,
    n7: float = 8.0,
    n8: float = 0.25,
    n9: float = 0.008333333333333333,
    n10: float = 0.75,
    n11: float = 0.017708333333333333,
    n12: float = 0.125,
    n13: float = 1.0,
) -> None:
    (tracking_index,) = given
    position, velocity, acceleration = out
    w0, w1, w2, w3, w4, w5, w6, w7, w8 = work
    p = sqrt(tracking_index, position)
    r = sqrt(p, velocity)
    t6 = divide(n0, tracking_index, acceleration)
    t8 = multiply(tracking_index, n1, w0)
    t9 = add(t6, t8, acceleration)
    c_scaled = sqrt(t9, acceleration)
    t12 = multiply(c_scaled, n2, acceleration)
    t13 = multiply(t12, r, w0)
    t14 = multiply(t13, n3, w0)
    t16 = multiply(p, n4, w1)
    t18 = multiply(tracking_index, n5, w2)
    t19 = multiply(p, r, w3)
    t22 = multiply(t19, n6, w3)
    t24 = divide(n7, r, w4)
    t25 = add(t22, t24, w3)
    t26 = near_cbrt(t25, w3, single)
    t28 = multiply(t14, t26, w4)
    t29 = add(t28, t18, w4)
    t30 = sqrt(t29, w4)
    t31 = multiply(t30, n3, w5)
    t32 = add(t31, t16, w5)
    t33 = sqrt(t32, w5)
    t34 = multiply(t14, n4, w6)
    t35 = multiply(t30, t33, w4)
    t36 = multiply(t33, t35, w5)
    t37 = multiply(t34, t26, w3)
    t38 = subtract(t36, t37, w5)
    t39 = subtract(t35, t34, w4)
    t40 = divide(t38, t39, w5)
    t42 = multiply(t14, t40, w3)
    t43 = add(t42, t18, w3)
    t44 = sqrt(t43, w3)
    t45 = multiply(t44, n3, w4)
    t46 = add(t45, t16, w4)
    t47 = sqrt(t46, w4)
    t48 = multiply(t44, t47, w3)
    t49 = multiply(t47, t48, w4)
    t50 = multiply(t34, t40, w5)
    t51 = subtract(t49, t50, w4)
    t52 = subtract(t48, t34, w3)
    t53 = divide(t51, t52, w4)
    t55 = multiply(t14, t53, w3)
    t56 = add(t55, t18, w3)
    t57 = sqrt(t56, w3)
    t58 = multiply(t57, n3, w5)
    t59 = add(t58, t16, w5)
    t60 = sqrt(t59, w5)
    t61 = multiply(t57, t60, w3)
    t62 = multiply(t60, t61, w5)
    t63 = multiply(t34, t53, w4)
    t64 = subtract(t62, t63, w5)
    t65 = subtract(t61, t34, w3)
    t66 = divide(t64, t65, w5)
    t68 = multiply(t14, t66, w3)
    t69 = add(t68, t18, w3)
    t70 = sqrt(t69, w3)
    t71 = multiply(t70, n3, w4)
    t72 = add(t71, t16, w4)
    t73 = sqrt(t72, w4)
    t74 = multiply(t70, t73, w3)
    t75 = multiply(t73, t74, w4)
    t76 = multiply(t34, t66, w5)
    t77 = subtract(t75, t76, w4)
    t78 = subtract(t74, t34, w3)
    t79 = divide(t77, t78, w4)
    t81 = multiply(t14, t79, w0)
    t82 = add(t81, t18, w0)
    e = sqrt(t82, w0)
    t84 = multiply(e, n3, w2)
    t85 = add(t84, t16, w2)
    x = sqrt(t85, w2)
    t88 = multiply(p, n8, w1)
    t89 = add(e, t88, w1)
    t90 = multiply(x, r, w2)
    t91 = divide(t90, t12, w3)
    t92 = multiply(t91, p, w4)
    t94 = multiply(t92, n9, w4)
    t95 = add(t89, t94, w4)
    t96 = square(e, w5)
    t98 = multiply(t96, n10, w6)
    t99 = multiply(p, e, velocity)
    t100 = multiply(t99, n8, w7)
    t101 = add(t98, t100, w6)
    t103 = multiply(tracking_index, n11, w7)
    t104 = add(t101, t103, w6)
    t105 = divide(t95, t104, w4)
    t106 = multiply(t90, n8, w8)
    t107 = multiply(t105, t106, w4)
    t108 = divide(t107, tracking_index, w4)
    t109 = multiply(t108, n3, w4)
    t110 = multiply(t96, n8, w5)
    t111 = multiply(t99, n12, velocity)
    t112 = add(t110, t111, w5)
    t113 = add(t112, t103, w5)
    t114 = multiply(t89, n12, w7)
    t115 = multiply(t90, t114, w7)
    t116 = add(t113, t115, w5)
    t117 = divide(t116, t104, w5)
    t118 = multiply(t117, n3, w5)
    t119 = divide(t91, tracking_index, w3)
    t120 = multiply(t118, t119, w5)
    t121 = divide(t90, t104, w2)
    t122 = add(t89, t106, w1)
    t123 = multiply(t122, n4, w1)
    t124 = multiply(t121, t123, w2)
    t125 = add(t124, n13, w2)
    t126 = multiply(t12, p, w1)
    t127 = divide(t125, t126, w2)
    t128 = multiply(t127, n4, w1)
    t129 = add(t120, t128, w1)
    t130 = add(t109, t129, w4)
    t131 = multiply(e, n4, w0)
    t132 = add(t12, t131, acceleration)
    t133 = multiply(p, n12, w0)
    t134 = add(t106, t133, w8)
    t135 = add(t132, t134, acceleration)
    t136 = multiply(p, t135, acceleration)
    t137 = divide(t130, t136, w4)
    t139 = add(t120, t127, w5)
    t140 = divide(t139, t136, w5)
    t142 = divide(t127, t136, w2)
    divide(t137, t136, position)
    divide(t140, t136, velocity)
    divide(t142, t136, acceleration)


_PREDICTOR_GAIN_DERIVATIVES = Signature(
    "predictor_gain_derivatives",
    (_TRACKING_INDEX_DOMAIN,),
    ("position", "velocity", "acceleration"),
    9,
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
        delta = sqrt(64/Lambda^2 + 2/15),
        xi = sqrt(2 + 2 eta), eta = sqrt(17/15 + 2 delta xi), nu = 1 + xi + eta + delta

    tracking_index: Lambda, with Lambda^2 =
        jerk_density*sampling_interval**5/measurement_deviation**2; a number above 0 and finite.

    innovation_deviation: standard deviation of an innovation over sigma_v. Relative error at most
        4.93 * 2^-52 (float64), 4.93 * 2^-23 (float32), proved for 5e-324 <= tracking_index <=
        1.7976931348623157e308 (float64) and 1e-45 <= tracking_index <= 3.4028235e38 (float32).

    Outside an output's range, a few numbers next to its ends apart, its true value is no normal
    number: it comes as 0, a subnormal number or infinity, never as NaN. Numbers and arrays are
    taken, arrays of any shape; inputs are broadcast. float64 and float32 stay what they are,
    integers become float64. `out`: a tuple of arrays to fill. `workers`: threads that share the
    work on long arrays.

    ValueError: an input outside its domain, with its place; `out` or `workers` that does not fit.
    TypeError: an input that is no real number of these types; in `out` what is no array of the
    results' type.

    Source: derivation continuous-white-jerk
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
    t2 = form.sqrt(tracking_index)
    t3 = form.sqrt(t2)
    t5 = 2.220446049250313e-16 / tracking_index
    t7 = tracking_index * 4.625929269271486e-19
    t11 = form.sqrt(t5 + t7) * 67108864.0
    t13 = (t11 * t3) * 2.0
    t15 = t2 * 0.5
    t17 = tracking_index * 0.07083333333333333
    t24 = ((t2 * t3) * 1.5516447222296765) + (8.0 / t3)
    t25 = form.near_cbrt(t24)
    t29 = form.sqrt((t13 * t25) + t17)
    t32 = form.sqrt((t29 * 2.0) + t15)
    t33 = t13 * 0.5
    t34 = t29 * t32
    t39 = ((t32 * t34) - (t33 * t25)) / (t34 - t33)
    t43 = form.sqrt((t13 * t39) + t17)
    t46 = form.sqrt((t43 * 2.0) + t15)
    t47 = t43 * t46
    t52 = ((t46 * t47) - (t33 * t39)) / (t47 - t33)
    t56 = form.sqrt((t13 * t52) + t17)
    t59 = form.sqrt((t56 * 2.0) + t15)
    t60 = t56 * t59
    t65 = ((t59 * t60) - (t33 * t52)) / (t60 - t33)
    t69 = form.sqrt((t13 * t65) + t17)
    t72 = form.sqrt((t69 * 2.0) + t15)
    t73 = t69 * t72
    t78 = ((t72 * t73) - (t33 * t65)) / (t73 - t33)
    t82 = form.sqrt((t13 * t78) + t17)
    t90 = (form.sqrt((t82 * 2.0) + t15) * t3) * 0.25
    t93 = (t11 + (t82 * 0.5)) + (t90 + (t2 * 0.125))
    t94 = t2 * t93
    return (t94,)


def _innovation_deviation_block(
    given: Arrays,
    out: Arrays,
    work: Arrays,
    single: bool,
    n0: float = 2.220446049250313e-16,
    n1: float = 4.625929269271486e-19,
    n2: float = 67108864.0,
    n3: float = 2.0,
    n4: float = 0.5,
    n5: float = 0.07083333333333333,
    n6: float = 1.5516447222296765,
    n7: float = 8.0,
    n8: float = 0.25,
    n9: float = 0.125,
) -> None:
    (tracking_index,) = given
    (innovation_deviation,) = out
    w0, w1, w2, w3, w4, w5, w6, w7, w8 = work
    p = sqrt(tracking_index, innovation_deviation)
    r = sqrt(p, w0)
    t5 = divide(n0, tracking_index, w1)
    t7 = multiply(tracking_index, n1, w2)
    t8 = add(t5, t7, w1)
    c_scaled = sqrt(t8, w1)
    t11 = multiply(c_scaled, n2, w1)
    t12 = multiply(t11, r, w2)
    t13 = multiply(t12, n3, w2)
    t15 = multiply(p, n4, w3)
    t17 = multiply(tracking_index, n5, w4)
    t18 = multiply(p, r, w5)
    t21 = multiply(t18, n6, w5)
    t23 = divide(n7, r, w6)
    t24 = add(t21, t23, w5)
    t25 = near_cbrt(t24, w5, single)
    t27 = multiply(t13, t25, w6)
    t28 = add(t27, t17, w6)
    t29 = sqrt(t28, w6)
    t30 = multiply(t29, n3, w7)
    t31 = add(t30, t15, w7)
    t32 = sqrt(t31, w7)
    t33 = multiply(t13, n4, w8)
    t34 = multiply(t29, t32, w6)
    t35 = multiply(t32, t34, w7)
    t36 = multiply(t33, t25, w5)
    t37 = subtract(t35, t36, w7)
    t38 = subtract(t34, t33, w6)
    t39 = divide(t37, t38, w7)
    t41 = multiply(t13, t39, w5)
    t42 = add(t41, t17, w5)
    t43 = sqrt(t42, w5)
    t44 = multiply(t43, n3, w6)
    t45 = add(t44, t15, w6)
    t46 = sqrt(t45, w6)
    t47 = multiply(t43, t46, w5)
    t48 = multiply(t46, t47, w6)
    t49 = multiply(t33, t39, w7)
    t50 = subtract(t48, t49, w6)
    t51 = subtract(t47, t33, w5)
    t52 = divide(t50, t51, w6)
    t54 = multiply(t13, t52, w5)
    t55 = add(t54, t17, w5)
    t56 = sqrt(t55, w5)
    t57 = multiply(t56, n3, w7)
    t58 = add(t57, t15, w7)
    t59 = sqrt(t58, w7)
    t60 = multiply(t56, t59, w5)
    t61 = multiply(t59, t60, w7)
    t62 = multiply(t33, t52, w6)
    t63 = subtract(t61, t62, w7)
    t64 = subtract(t60, t33, w5)
    t65 = divide(t63, t64, w7)
    t67 = multiply(t13, t65, w5)
    t68 = add(t67, t17, w5)
    t69 = sqrt(t68, w5)
    t70 = multiply(t69, n3, w6)
    t71 = add(t70, t15, w6)
    t72 = sqrt(t71, w6)
    t73 = multiply(t69, t72, w5)
    t74 = multiply(t72, t73, w6)
    t75 = multiply(t33, t65, w7)
    t76 = subtract(t74, t75, w6)
    t77 = subtract(t73, t33, w5)
    t78 = divide(t76, t77, w6)
    t80 = multiply(t13, t78, w2)
    t81 = add(t80, t17, w2)
    e = sqrt(t81, w2)
    t83 = multiply(e, n3, w4)
    t84 = add(t83, t15, w4)
    x = sqrt(t84, w4)
    t86 = multiply(e, n4, w2)
    t87 = add(t11, t86, w1)
    t88 = multiply(x, r, w4)
    t90 = multiply(t88, n8, w4)
    t91 = multiply(p, n9, w0)
    t92 = add(t90, t91, w4)
    t93 = add(t87, t92, w1)
    multiply(p, t93, innovation_deviation)


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
        with d(s) = 1 + xi s + eta s^2 + delta s^3 and z = (1 + s)/(1 - s),
        delta = sqrt(64/Lambda^2 + 2/15),
        xi = sqrt(2 + 2 eta), eta = sqrt(17/15 + 2 delta xi), nu = 1 + xi + eta + delta

    tracking_index: Lambda, with Lambda^2 =
        jerk_density*sampling_interval**5/measurement_deviation**2; a number above 0 and finite.

    pole_product: product of the poles, and what is left of 1 beside the position gain. Relative
        error at most 9.35 * 2^-52 (float64), 9.36 * 2^-23 (float32), proved for 5e-324 <=
        tracking_index <= 1.0003752096714334e154 (float64) and 1e-45 <= tracking_index <=
        1.3763372e19 (float32).

    Outside an output's range, a few numbers next to its ends apart, its true value is no normal
    number: it comes as 0, a subnormal number or infinity, never as NaN. Numbers and arrays are
    taken, arrays of any shape; inputs are broadcast. float64 and float32 stay what they are,
    integers become float64. `out`: a tuple of arrays to fill. `workers`: threads that share the
    work on long arrays.

    ValueError: an input outside its domain, with its place; `out` or `workers` that does not fit.
    TypeError: an input that is no real number of these types; in `out` what is no array of the
    results' type.

    Source: derivation continuous-white-jerk
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
    t3 = form.sqrt(tracking_index)
    t4 = form.sqrt(t3)
    t6 = 2.220446049250313e-16 / tracking_index
    t8 = tracking_index * 4.625929269271486e-19
    t12 = form.sqrt(t6 + t8) * 67108864.0
    t14 = (t12 * t4) * 2.0
    t16 = t3 * 0.5
    t18 = tracking_index * 0.07083333333333333
    t25 = ((t3 * t4) * 1.5516447222296765) + (8.0 / t4)
    t26 = form.near_cbrt(t25)
    t30 = form.sqrt((t14 * t26) + t18)
    t33 = form.sqrt((t30 * 2.0) + t16)
    t34 = t14 * 0.5
    t35 = t30 * t33
    t40 = ((t33 * t35) - (t34 * t26)) / (t35 - t34)
    t44 = form.sqrt((t14 * t40) + t18)
    t47 = form.sqrt((t44 * 2.0) + t16)
    t48 = t44 * t47
    t53 = ((t47 * t48) - (t34 * t40)) / (t48 - t34)
    t57 = form.sqrt((t14 * t53) + t18)
    t60 = form.sqrt((t57 * 2.0) + t16)
    t61 = t57 * t60
    t66 = ((t60 * t61) - (t34 * t53)) / (t61 - t34)
    t70 = form.sqrt((t14 * t66) + t18)
    t73 = form.sqrt((t70 * 2.0) + t16)
    t74 = t70 * t73
    t79 = ((t73 * t74) - (t34 * t66)) / (t74 - t34)
    t83 = form.sqrt((t14 * t79) + t18)
    t91 = (form.sqrt((t83 * 2.0) + t16) * t4) * 0.25
    t94 = (t12 + (t83 * 0.5)) + (t91 + (t3 * 0.125))
    t97 = ((1.0 / t94) / tracking_index) / t94
    return (t97,)


def _pole_product_block(
    given: Arrays,
    out: Arrays,
    work: Arrays,
    single: bool,
    n0: float = 2.220446049250313e-16,
    n1: float = 4.625929269271486e-19,
    n2: float = 67108864.0,
    n3: float = 2.0,
    n4: float = 0.5,
    n5: float = 0.07083333333333333,
    n6: float = 1.5516447222296765,
    n7: float = 8.0,
    n8: float = 0.25,
    n9: float = 0.125,
    n10: float = 1.0,
) -> None:
    (tracking_index,) = given
    (pole_product,) = out
    w0, w1, w2, w3, w4, w5, w6, w7, w8 = work
    p = sqrt(tracking_index, pole_product)
    r = sqrt(p, w0)
    t6 = divide(n0, tracking_index, w1)
    t8 = multiply(tracking_index, n1, w2)
    t9 = add(t6, t8, w1)
    c_scaled = sqrt(t9, w1)
    t12 = multiply(c_scaled, n2, w1)
    t13 = multiply(t12, r, w2)
    t14 = multiply(t13, n3, w2)
    t16 = multiply(p, n4, w3)
    t18 = multiply(tracking_index, n5, w4)
    t19 = multiply(p, r, w5)
    t22 = multiply(t19, n6, w5)
    t24 = divide(n7, r, w6)
    t25 = add(t22, t24, w5)
    t26 = near_cbrt(t25, w5, single)
    t28 = multiply(t14, t26, w6)
    t29 = add(t28, t18, w6)
    t30 = sqrt(t29, w6)
    t31 = multiply(t30, n3, w7)
    t32 = add(t31, t16, w7)
    t33 = sqrt(t32, w7)
    t34 = multiply(t14, n4, w8)
    t35 = multiply(t30, t33, w6)
    t36 = multiply(t33, t35, w7)
    t37 = multiply(t34, t26, w5)
    t38 = subtract(t36, t37, w7)
    t39 = subtract(t35, t34, w6)
    t40 = divide(t38, t39, w7)
    t42 = multiply(t14, t40, w5)
    t43 = add(t42, t18, w5)
    t44 = sqrt(t43, w5)
    t45 = multiply(t44, n3, w6)
    t46 = add(t45, t16, w6)
    t47 = sqrt(t46, w6)
    t48 = multiply(t44, t47, w5)
    t49 = multiply(t47, t48, w6)
    t50 = multiply(t34, t40, w7)
    t51 = subtract(t49, t50, w6)
    t52 = subtract(t48, t34, w5)
    t53 = divide(t51, t52, w6)
    t55 = multiply(t14, t53, w5)
    t56 = add(t55, t18, w5)
    t57 = sqrt(t56, w5)
    t58 = multiply(t57, n3, w7)
    t59 = add(t58, t16, w7)
    t60 = sqrt(t59, w7)
    t61 = multiply(t57, t60, w5)
    t62 = multiply(t60, t61, w7)
    t63 = multiply(t34, t53, w6)
    t64 = subtract(t62, t63, w7)
    t65 = subtract(t61, t34, w5)
    t66 = divide(t64, t65, w7)
    t68 = multiply(t14, t66, w5)
    t69 = add(t68, t18, w5)
    t70 = sqrt(t69, w5)
    t71 = multiply(t70, n3, w6)
    t72 = add(t71, t16, w6)
    t73 = sqrt(t72, w6)
    t74 = multiply(t70, t73, w5)
    t75 = multiply(t73, t74, w6)
    t76 = multiply(t34, t66, w7)
    t77 = subtract(t75, t76, w6)
    t78 = subtract(t74, t34, w5)
    t79 = divide(t77, t78, w6)
    t81 = multiply(t14, t79, w2)
    t82 = add(t81, t18, w2)
    e = sqrt(t82, w2)
    t84 = multiply(e, n3, w4)
    t85 = add(t84, t16, w4)
    x = sqrt(t85, w4)
    t87 = multiply(e, n4, w2)
    t88 = add(t12, t87, w1)
    t89 = multiply(x, r, w4)
    t91 = multiply(t89, n8, w4)
    t92 = multiply(p, n9, pole_product)
    t93 = add(t91, t92, w4)
    t94 = add(t88, t93, w1)
    t95 = divide(n10, t94, w0)
    t96 = divide(t95, tracking_index, w0)
    divide(t96, t94, pole_product)


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
        delta = sqrt(64/Lambda^2 + 2/15),
        xi = sqrt(2 + 2 eta), eta = sqrt(17/15 + 2 delta xi), nu = 1 + xi + eta + delta

    tracking_index: Lambda, with Lambda^2 =
        jerk_density*sampling_interval**5/measurement_deviation**2; a number above 0 and finite.

    predicted_11: variance of the predicted position over sigma_v^2. Relative error at most 9.34 *
        2^-52 (float64), 9.34 * 2^-23 (float32), proved for 5e-324 <= tracking_index <=
        2.0007504193428283e154 (float64) and 1e-45 <= tracking_index <= 2.7526452e19 (float32).
    predicted_12: covariance of predicted position and velocity times T/sigma_v^2. Relative error at
        most 8.83 * 2^-52 (float64), 8.83 * 2^-23 (float32), proved for 5e-324 <= tracking_index <=
        1.522217230342759e154 (float64) and 1e-45 <= tracking_index <= 2.0942756e19 (float32).
    predicted_13: covariance of predicted position and acceleration times T^2/sigma_v^2. Relative
        error at most 5.43 * 2^-52 (float64), 5.43 * 2^-23 (float32), proved for
        2.2250738585072014e-308 <= tracking_index <= 1.637854613154071e154 (float64) and
        1.1754944e-38 <= tracking_index <= 2.253382e19 (float32).
    predicted_22: variance of the predicted velocity times T^2/sigma_v^2. Relative error at most
        5.86 * 2^-52 (float64), 5.88 * 2^-23 (float32), proved for 7.416912861690675e-309 <=
        tracking_index <= 1.1330380120706537e154 (float64) and 3.918315e-39 <= tracking_index <=
        1.5588409e19 (float32).
    predicted_23: covariance of predicted velocity and acceleration times T^3/sigma_v^2. Relative
        error at most 6.56 * 2^-52 (float64), 6.56 * 2^-23 (float32), proved for
        1.0832677820940206e-231 <= tracking_index <= 1.1615899080873361e154 (float64) and
        2.122721e-29 <= tracking_index <= 1.5981308e19 (float32).
    predicted_33: variance of the predicted acceleration times T^4/sigma_v^2. Relative error at most
        6.26 * 2^-52 (float64), 6.26 * 2^-23 (float32), proved for 1.6896185209462645e-185 <=
        tracking_index <= 1.0413682289554346e154 (float64) and 1.1521641e-23 <= tracking_index <=
        1.4327283e19 (float32).

    Outside an output's range, a few numbers next to its ends apart, its true value is no normal
    number: it comes as 0, a subnormal number or infinity, never as NaN. Numbers and arrays are
    taken, arrays of any shape; inputs are broadcast. float64 and float32 stay what they are,
    integers become float64. `out`: a tuple of arrays to fill. `workers`: threads that share the
    work on long arrays.

    ValueError: an input outside its domain, with its place; `out` or `workers` that does not fit.
    TypeError: an input that is no real number of these types; in `out` what is no array of the
    results' type.

    Source: derivation continuous-white-jerk
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
    t2 = form.sqrt(tracking_index)
    t3 = form.sqrt(t2)
    t5 = 2.220446049250313e-16 / tracking_index
    t7 = tracking_index * 4.625929269271486e-19
    t11 = form.sqrt(t5 + t7) * 67108864.0
    t13 = (t11 * t3) * 2.0
    t15 = t2 * 0.5
    t17 = tracking_index * 0.07083333333333333
    t18 = t2 * t3
    t24 = (t18 * 1.5516447222296765) + (8.0 / t3)
    t25 = form.near_cbrt(t24)
    t29 = form.sqrt((t13 * t25) + t17)
    t32 = form.sqrt((t29 * 2.0) + t15)
    t33 = t13 * 0.5
    t34 = t29 * t32
    t39 = ((t32 * t34) - (t33 * t25)) / (t34 - t33)
    t43 = form.sqrt((t13 * t39) + t17)
    t46 = form.sqrt((t43 * 2.0) + t15)
    t47 = t43 * t46
    t52 = ((t46 * t47) - (t33 * t39)) / (t47 - t33)
    t56 = form.sqrt((t13 * t52) + t17)
    t59 = form.sqrt((t56 * 2.0) + t15)
    t60 = t56 * t59
    t65 = ((t59 * t60) - (t33 * t52)) / (t60 - t33)
    t69 = form.sqrt((t13 * t65) + t17)
    t72 = form.sqrt((t69 * 2.0) + t15)
    t73 = t69 * t72
    t78 = ((t72 * t73) - (t33 * t65)) / (t73 - t33)
    t82 = form.sqrt((t13 * t78) + t17)
    t85 = form.sqrt((t82 * 2.0) + t15)
    t87 = t2 * 0.25
    t91 = t85 * t3
    t95 = (t11 + (t82 * 0.5)) + ((t91 * 0.25) + (t2 * 0.125))
    t110 = (t3 / t85) * (t82 + (t2 * 0.26666666666666666))
    t112 = ((((t11 * 3.0) + t82) + t87) + t110) * t2
    t117 = (t2 * 0.3333333333333333) + (t91 * 0.5)
    t97 = ((t87 + t82) * t95) * tracking_index
    t99 = (t91 * t95) * tracking_index
    t101 = tracking_index * (t2 * t95)
    t113 = t112 * tracking_index
    t120 = ((t117 + t82) * t2) * tracking_index
    t124 = tracking_index * ((t18 * t85) + (tracking_index * 0.5))
    return (t97, t99, t101, t113, t120, t124)


def _predicted_covariance_block(
    given: Arrays,
    out: Arrays,
    work: Arrays,
    single: bool,
    n0: float = 2.220446049250313e-16,
    n1: float = 4.625929269271486e-19,
    n2: float = 67108864.0,
    n3: float = 2.0,
    n4: float = 0.5,
    n5: float = 0.07083333333333333,
    n6: float = 1.5516447222296765,
    n7: float = 8.0,
    n8: float = 0.25,
    n9: float = 0.125,
    n10: float = 3.0,
    n11: float = 0.26666666666666666,
    n12: float = 0.3333333333333333,
) -> None:
    (tracking_index,) = given
    predicted_11, predicted_12, predicted_13, predicted_22, predicted_23, predicted_33 = out
    w0, w1, w2, w3, w4, w5 = work
    p = sqrt(tracking_index, predicted_11)
    r = sqrt(p, predicted_12)
    t5 = divide(n0, tracking_index, predicted_13)
    t7 = multiply(tracking_index, n1, w0)
    t8 = add(t5, t7, predicted_13)
    c_scaled = sqrt(t8, predicted_22)
    t11 = multiply(c_scaled, n2, predicted_22)
    t12 = multiply(t11, r, w0)
    t13 = multiply(t12, n3, w0)
    t15 = multiply(p, n4, predicted_13)
    t17 = multiply(tracking_index, n5, w1)
    t18 = multiply(p, r, w2)
    t21 = multiply(t18, n6, w3)
    t23 = divide(n7, r, predicted_23)
    t24 = add(t21, t23, w3)
    t25 = near_cbrt(t24, w3, single)
    t27 = multiply(t13, t25, predicted_23)
    t28 = add(t27, t17, predicted_23)
    t29 = sqrt(t28, predicted_33)
    t30 = multiply(t29, n3, predicted_23)
    t31 = add(t30, t15, predicted_23)
    t32 = sqrt(t31, predicted_23)
    t33 = multiply(t13, n4, w4)
    t34 = multiply(t29, t32, predicted_33)
    t35 = multiply(t32, t34, predicted_23)
    t36 = multiply(t33, t25, w3)
    t37 = subtract(t35, t36, predicted_23)
    t38 = subtract(t34, t33, predicted_33)
    t39 = divide(t37, t38, predicted_23)
    t41 = multiply(t13, t39, w3)
    t42 = add(t41, t17, w3)
    t43 = sqrt(t42, w3)
    t44 = multiply(t43, n3, predicted_33)
    t45 = add(t44, t15, predicted_33)
    t46 = sqrt(t45, predicted_33)
    t47 = multiply(t43, t46, w3)
    t48 = multiply(t46, t47, predicted_33)
    t49 = multiply(t33, t39, predicted_23)
    t50 = subtract(t48, t49, predicted_33)
    t51 = subtract(t47, t33, w3)
    t52 = divide(t50, t51, predicted_33)
    t54 = multiply(t13, t52, w3)
    t55 = add(t54, t17, w3)
    t56 = sqrt(t55, w3)
    t57 = multiply(t56, n3, predicted_23)
    t58 = add(t57, t15, predicted_23)
    t59 = sqrt(t58, predicted_23)
    t60 = multiply(t56, t59, w3)
    t61 = multiply(t59, t60, predicted_23)
    t62 = multiply(t33, t52, predicted_33)
    t63 = subtract(t61, t62, predicted_23)
    t64 = subtract(t60, t33, w3)
    t65 = divide(t63, t64, predicted_23)
    t67 = multiply(t13, t65, w3)
    t68 = add(t67, t17, w3)
    t69 = sqrt(t68, w3)
    t70 = multiply(t69, n3, predicted_33)
    t71 = add(t70, t15, predicted_33)
    t72 = sqrt(t71, predicted_33)
    t73 = multiply(t69, t72, w3)
    t74 = multiply(t72, t73, predicted_33)
    t75 = multiply(t33, t65, predicted_23)
    t76 = subtract(t74, t75, predicted_33)
    t77 = subtract(t73, t33, w3)
    t78 = divide(t76, t77, predicted_33)
    t80 = multiply(t13, t78, w0)
    t81 = add(t80, t17, w0)
    e = sqrt(t81, w0)
    t83 = multiply(e, n3, w1)
    t84 = add(t83, t15, w1)
    x = sqrt(t84, w1)
    t87 = multiply(p, n8, w3)
    t88 = add(t87, e, w4)
    t89 = multiply(e, n4, predicted_13)
    t90 = add(t11, t89, predicted_13)
    t91 = multiply(x, r, predicted_23)
    t92 = multiply(t91, n8, predicted_33)
    t93 = multiply(p, n9, w5)
    t94 = add(t92, t93, predicted_33)
    t95 = add(t90, t94, predicted_13)
    t96 = multiply(t88, t95, w4)
    t98 = multiply(t91, t95, w5)
    t100 = multiply(p, t95, predicted_13)
    t103 = multiply(t11, n10, predicted_22)
    t104 = add(t103, e, predicted_22)
    t105 = add(t104, t87, predicted_22)
    t106 = divide(r, x, predicted_12)
    t108 = multiply(p, n11, w3)
    t109 = add(e, t108, w3)
    t110 = multiply(t106, t109, predicted_12)
    t111 = add(t105, t110, predicted_22)
    t112 = multiply(t111, p, predicted_22)
    t115 = multiply(p, n12, w3)
    t116 = multiply(t91, n4, predicted_23)
    t117 = add(t115, t116, w3)
    t118 = add(t117, e, w3)
    t119 = multiply(t118, p, w3)
    t121 = multiply(t18, x, w2)
    t122 = multiply(tracking_index, n4, w0)
    t123 = add(t121, t122, w2)
    multiply(t96, tracking_index, predicted_11)
    multiply(t98, tracking_index, predicted_12)
    multiply(tracking_index, t100, predicted_13)
    multiply(t112, tracking_index, predicted_22)
    multiply(t119, tracking_index, predicted_23)
    multiply(tracking_index, t123, predicted_33)


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

        delta = sqrt(64/Lambda^2 + 2/15),
        xi = sqrt(2 + 2 eta), eta = sqrt(17/15 + 2 delta xi), nu = 1 + xi + eta + delta

    tracking_index: Lambda, with Lambda^2 =
        jerk_density*sampling_interval**5/measurement_deviation**2; a number above 0 and at most
        2^1000, in float32 above 0 and at most 2^120.

    predicted_11: derivative of the variance of the predicted position over sigma_v^2. Relative
        error at most 12.67 * 2^-52 (float64), 12.73 * 2^-23 (float32), proved for 5e-324 <=
        tracking_index <= 1.0715086071862673e301 (float64) and 1e-45 <= tracking_index <=
        1.329228e36 (float32).
    predicted_12: derivative of the covariance of predicted position and velocity times T/sigma_v^2.
        Relative error at most 12.30 * 2^-52 (float64), 12.34 * 2^-23 (float32), proved for 5e-324
        <= tracking_index <= 1.0715086071862673e301 (float64) and 1e-45 <= tracking_index <=
        1.329228e36 (float32).
    predicted_13: derivative of the covariance of predicted position and acceleration times
        T^2/sigma_v^2. Relative error at most 7.71 * 2^-52 (float64), 7.75 * 2^-23 (float32), proved
        for 5e-324 <= tracking_index <= 1.0715086071862673e301 (float64) and 1e-45 <= tracking_index
        <= 1.329228e36 (float32).
    predicted_22: derivative of the variance of the predicted velocity times T^2/sigma_v^2. Relative
        error at most 6.85 * 2^-52 (float64), 6.86 * 2^-23 (float32), proved for 5e-324 <=
        tracking_index <= 1.0715086071862673e301 (float64) and 1e-45 <= tracking_index <=
        1.329228e36 (float32).
    predicted_23: derivative of the covariance of predicted velocity and acceleration times
        T^3/sigma_v^2. Relative error at most 8.58 * 2^-52 (float64), 8.59 * 2^-23 (float32), proved
        for 5e-324 <= tracking_index <= 1.0715086071862673e301 (float64) and 1e-45 <= tracking_index
        <= 1.329228e36 (float32).
    predicted_33: derivative of the variance of the predicted acceleration times T^4/sigma_v^2.
        Relative error at most 8.16 * 2^-52 (float64), 8.16 * 2^-23 (float32), proved for 5e-324 <=
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

    Source: derivation continuous-white-jerk
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
    t3 = form.sqrt(tracking_index)
    t4 = form.sqrt(t3)
    t6 = 2.220446049250313e-16 / tracking_index
    t8 = tracking_index * 4.625929269271486e-19
    t12 = form.sqrt(t6 + t8) * 67108864.0
    t14 = (t12 * t4) * 2.0
    t16 = t3 * 0.5
    t18 = tracking_index * 0.07083333333333333
    t19 = t3 * t4
    t25 = (t19 * 1.5516447222296765) + (8.0 / t4)
    t26 = form.near_cbrt(t25)
    t30 = form.sqrt((t14 * t26) + t18)
    t33 = form.sqrt((t30 * 2.0) + t16)
    t34 = t14 * 0.5
    t35 = t30 * t33
    t40 = ((t33 * t35) - (t34 * t26)) / (t35 - t34)
    t44 = form.sqrt((t14 * t40) + t18)
    t47 = form.sqrt((t44 * 2.0) + t16)
    t48 = t44 * t47
    t53 = ((t47 * t48) - (t34 * t40)) / (t48 - t34)
    t57 = form.sqrt((t14 * t53) + t18)
    t60 = form.sqrt((t57 * 2.0) + t16)
    t61 = t57 * t60
    t66 = ((t60 * t61) - (t34 * t53)) / (t61 - t34)
    t70 = form.sqrt((t14 * t66) + t18)
    t73 = form.sqrt((t70 * 2.0) + t16)
    t74 = t70 * t73
    t79 = ((t73 * t74) - (t34 * t66)) / (t74 - t34)
    t83 = form.sqrt((t14 * t79) + t18)
    t86 = form.sqrt((t83 * 2.0) + t16)
    t88 = t3 * 0.25
    t90 = t86 * t4
    t91 = t90 / t12
    t95 = (t83 + t88) + ((t91 * t3) * 0.008333333333333333)
    t96 = t83 * t83
    t99 = t3 * t83
    t103 = tracking_index * 0.017708333333333333
    t104 = ((t96 * 0.75) + (t99 * 0.25)) + t103
    t106 = t90 * 0.25
    t107 = (t95 / t104) * t106
    t113 = (t12 + (t83 * 0.5)) + (t106 + (t3 * 0.125))
    t120 = ((t96 * 0.25) + (t99 * 0.125)) + t103
    t126 = ((tracking_index / t104) * t91) * 0.0010416666666666667
    t127 = ((t120 / t104) * 2.0) + t126
    t130 = t3 * t113
    t137 = ((tracking_index / t12) / t12) * 0.0020833333333333333
    t144 = ((t88 / t83) * 2.0) + 2.0
    t146 = (tracking_index * t144) * 0.017708333333333333
    t150 = ((t120 + t146) / t104) + (t126 * t144)
    t151 = 1.0 + t150
    t152 = t151 * t83
    t154 = ((((1.0 + t137) * t12) * 3.0) + t152) + t16
    t158 = ((t90 / t104) / tracking_index) / t12
    t159 = t158 * 0.5
    t165 = ((2.0 + t159) * t3) * 0.26666666666666666
    t167 = (t4 / t86) * (((t151 + t159) * t83) + t165)
    t170 = 1.0 + t127
    t176 = (((t170 * t90) * 0.5) + t152) + (t3 * 0.6666666666666666)
    t115 = ((t107 * 2.0) * t113) * t113
    t131 = ((t86 / t4) * (t127 + t107)) * t130
    t133 = t130 * (t107 + 1.0)
    t169 = (t154 + t167) * t3
    t177 = t176 * t3
    t180 = ((t19 * t86) * t170) + tracking_index
    return (t115, t131, t133, t169, t177, t180)


def _predicted_covariance_derivatives_block(
    given: Arrays,
    out: Arrays,
    work: Arrays,
    single: bool,
    n0: float = 2.220446049250313e-16,
    n1: float = 4.625929269271486e-19,
    n2: float = 67108864.0,
    n3: float = 2.0,
    n4: float = 0.5,
    n5: float = 0.07083333333333333,
    n6: float = 1.5516447222296765,
    n7: float = 8.0,
    n8: float = 0.25,
    n9: float = 0.008333333333333333,
    n10: float = 0.75,
    n11: float = 0.017708333333333333,
    n12: float = 0.125,
    n13: float = 0.0010416666666666667,
    n14: float = 1.0,
    n15: float = 0.0020833333333333333,
    n16: float = 3.0,
    n17: float = 0.26666666666666666,
    n18: float = 0.6666666666666666,
) -> None:
    (tracking_index,) = given
    predicted_11, predicted_12, predicted_13, predicted_22, predicted_23, predicted_33 = out
    w0, w1, w2, w3, w4, w5, w6, w7, w8, w9, w10, w11, w12, w13 = work
    p = sqrt(tracking_index, predicted_23)
    r = sqrt(p, predicted_11)
    t6 = divide(n0, tracking_index, predicted_12)
    t8 = multiply(tracking_index, n1, w0)
    t9 = add(t6, t8, predicted_12)
    c_scaled = sqrt(t9, predicted_13)
    t12 = multiply(c_scaled, n2, predicted_13)
    t13 = multiply(t12, r, w0)
    t14 = multiply(t13, n3, w0)
    t16 = multiply(p, n4, predicted_12)
    t18 = multiply(tracking_index, n5, w1)
    t19 = multiply(p, r, w2)
    t22 = multiply(t19, n6, w3)
    t24 = divide(n7, r, predicted_22)
    t25 = add(t22, t24, w3)
    t26 = near_cbrt(t25, w3, single)
    t28 = multiply(t14, t26, predicted_22)
    t29 = add(t28, t18, predicted_22)
    t30 = sqrt(t29, predicted_33)
    t31 = multiply(t30, n3, predicted_22)
    t32 = add(t31, t16, predicted_22)
    t33 = sqrt(t32, predicted_22)
    t34 = multiply(t14, n4, w4)
    t35 = multiply(t30, t33, predicted_33)
    t36 = multiply(t33, t35, predicted_22)
    t37 = multiply(t34, t26, w3)
    t38 = subtract(t36, t37, predicted_22)
    t39 = subtract(t35, t34, predicted_33)
    t40 = divide(t38, t39, predicted_22)
    t42 = multiply(t14, t40, w3)
    t43 = add(t42, t18, w3)
    t44 = sqrt(t43, w3)
    t45 = multiply(t44, n3, predicted_33)
    t46 = add(t45, t16, predicted_33)
    t47 = sqrt(t46, predicted_33)
    t48 = multiply(t44, t47, w3)
    t49 = multiply(t47, t48, predicted_33)
    t50 = multiply(t34, t40, predicted_22)
    t51 = subtract(t49, t50, predicted_33)
    t52 = subtract(t48, t34, w3)
    t53 = divide(t51, t52, predicted_33)
    t55 = multiply(t14, t53, w3)
    t56 = add(t55, t18, w3)
    t57 = sqrt(t56, w3)
    t58 = multiply(t57, n3, predicted_22)
    t59 = add(t58, t16, predicted_22)
    t60 = sqrt(t59, predicted_22)
    t61 = multiply(t57, t60, w3)
    t62 = multiply(t60, t61, predicted_22)
    t63 = multiply(t34, t53, predicted_33)
    t64 = subtract(t62, t63, predicted_22)
    t65 = subtract(t61, t34, w3)
    t66 = divide(t64, t65, predicted_22)
    t68 = multiply(t14, t66, w3)
    t69 = add(t68, t18, w3)
    t70 = sqrt(t69, w3)
    t71 = multiply(t70, n3, predicted_33)
    t72 = add(t71, t16, predicted_33)
    t73 = sqrt(t72, predicted_33)
    t74 = multiply(t70, t73, w3)
    t75 = multiply(t73, t74, predicted_33)
    t76 = multiply(t34, t66, predicted_22)
    t77 = subtract(t75, t76, predicted_33)
    t78 = subtract(t74, t34, w3)
    t79 = divide(t77, t78, predicted_33)
    t81 = multiply(t14, t79, w0)
    t82 = add(t81, t18, w0)
    e = sqrt(t82, w0)
    t84 = multiply(e, n3, w1)
    t85 = add(t84, t16, w1)
    x = sqrt(t85, w1)
    t88 = multiply(p, n8, w3)
    t89 = add(e, t88, w4)
    t90 = multiply(x, r, predicted_22)
    t91 = divide(t90, t12, predicted_33)
    t92 = multiply(t91, p, w5)
    t94 = multiply(t92, n9, w5)
    t95 = add(t89, t94, w4)
    t96 = square(e, w5)
    t98 = multiply(t96, n10, w6)
    t99 = multiply(p, e, w7)
    t100 = multiply(t99, n8, w8)
    t101 = add(t98, t100, w6)
    t103 = multiply(tracking_index, n11, w8)
    t104 = add(t101, t103, w6)
    t105 = divide(t95, t104, w4)
    t106 = multiply(t90, n8, w9)
    t107 = multiply(t105, t106, w4)
    t108 = multiply(t107, n3, w10)
    t109 = multiply(e, n4, w11)
    t110 = add(t12, t109, w11)
    t111 = multiply(p, n12, w12)
    t112 = add(t106, t111, w9)
    t113 = add(t110, t112, w11)
    t114 = multiply(t108, t113, w10)
    t116 = divide(x, r, w9)
    t117 = multiply(t96, n8, w5)
    t118 = multiply(t99, n12, w7)
    t119 = add(t117, t118, w5)
    t120 = add(t119, t103, w5)
    t121 = divide(t120, t104, w7)
    t122 = multiply(t121, n3, w7)
    t123 = divide(tracking_index, t104, w8)
    t124 = multiply(t123, t91, w8)
    t126 = multiply(t124, n13, w8)
    t127 = add(t122, t126, w7)
    t128 = add(t127, t107, w12)
    t129 = multiply(t116, t128, w9)
    t130 = multiply(p, t113, w12)
    t132 = add(t107, n14, w4)
    t134 = divide(tracking_index, t12, predicted_33)
    t135 = divide(t134, t12, predicted_33)
    t137 = multiply(t135, n15, predicted_33)
    t138 = add(n14, t137, predicted_33)
    t139 = multiply(t138, t12, predicted_33)
    t141 = multiply(t139, n16, predicted_33)
    t142 = divide(t88, e, w3)
    t143 = multiply(t142, n3, w3)
    t144 = add(t143, n3, w3)
    t145 = multiply(tracking_index, t144, w13)
    t146 = multiply(t145, n11, w13)
    t147 = add(t120, t146, w5)
    t148 = divide(t147, t104, w5)
    t149 = multiply(t126, t144, w8)
    t150 = add(t148, t149, w5)
    t151 = add(n14, t150, w5)
    t152 = multiply(t151, e, w3)
    t153 = add(t141, t152, predicted_33)
    t154 = add(t153, t16, predicted_33)
    t155 = divide(r, x, predicted_11)
    t156 = divide(t90, t104, w6)
    t157 = divide(t156, tracking_index, w6)
    t158 = divide(t157, t12, w6)
    t159 = multiply(t158, n4, w6)
    t160 = add(t151, t159, w5)
    t161 = multiply(t160, e, w5)
    t162 = add(n3, t159, w6)
    t163 = multiply(t162, p, w6)
    t165 = multiply(t163, n17, w6)
    t166 = add(t161, t165, w5)
    t167 = multiply(t155, t166, predicted_11)
    t168 = add(t154, t167, predicted_33)
    t170 = add(n14, t127, w7)
    t171 = multiply(t170, t90, predicted_22)
    t172 = multiply(t171, n4, predicted_22)
    t173 = add(t172, t152, predicted_22)
    t175 = multiply(p, n18, w0)
    t176 = add(t173, t175, w0)
    t178 = multiply(t19, x, w2)
    t179 = multiply(t178, t170, w2)
    multiply(t114, t113, predicted_11)
    multiply(t129, t130, predicted_12)
    multiply(t130, t132, predicted_13)
    multiply(t168, p, predicted_22)
    multiply(t176, p, predicted_23)
    add(t179, tracking_index, predicted_33)


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
    14,
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
        delta = sqrt(64/Lambda^2 + 2/15),
        xi = sqrt(2 + 2 eta), eta = sqrt(17/15 + 2 delta xi), nu = 1 + xi + eta + delta

    tracking_index: Lambda, with Lambda^2 =
        jerk_density*sampling_interval**5/measurement_deviation**2; a number above 0 and finite.

    updated_11: variance of the updated position over sigma_v^2. Relative error at most 6.18 * 2^-52
        (float64), 6.17 * 2^-23 (float32), proved for 5e-324 <= tracking_index <=
        1.7976931348623157e308 (float64) and 1e-45 <= tracking_index <= 3.4028235e38 (float32).
    updated_12: covariance of updated position and velocity times T/sigma_v^2. Relative error at
        most 6.09 * 2^-52 (float64), 6.09 * 2^-23 (float32), proved for 5e-324 <= tracking_index <=
        1.7976931348623157e308 (float64) and 1e-45 <= tracking_index <= 3.4028235e38 (float32).
    updated_13: covariance of updated position and acceleration times T^2/sigma_v^2. Relative error
        at most 4.55 * 2^-52 (float64), 4.55 * 2^-23 (float32), proved for 2.2250738585072014e-308
        <= tracking_index <= 1.7976931348623157e308 (float64) and 1.1754945e-38 <= tracking_index <=
        3.4028235e38 (float32).
    updated_22: variance of the updated velocity times T^2/sigma_v^2. Relative error at most 8.09 *
        2^-52 (float64), 8.22 * 2^-23 (float32), proved for 7.416912861690675e-309 <= tracking_index
        <= 5.471897350776219e154 (float64) and 3.918315e-39 <= tracking_index <= 7.528226e19
        (float32).
    updated_23: covariance of updated velocity and acceleration times T^3/sigma_v^2. Relative error
        at most 9.01 * 2^-52 (float64), 9.01 * 2^-23 (float32), proved for 1.0832677820940206e-231
        <= tracking_index <= 3.2085606867585784e154 (float64) and 2.122721e-29 <= tracking_index <=
        4.414355e19 (float32).
    updated_33: variance of the updated acceleration times T^4/sigma_v^2. Relative error at most
        6.45 * 2^-52 (float64), 6.46 * 2^-23 (float32), proved for 1.6896185209462645e-185 <=
        tracking_index <= 1.6532656032497123e154 (float64) and 1.1521641e-23 <= tracking_index <=
        2.2745733e19 (float32).

    Outside an output's range, a few numbers next to its ends apart, its true value is no normal
    number: it comes as 0, a subnormal number or infinity, never as NaN. Numbers and arrays are
    taken, arrays of any shape; inputs are broadcast. float64 and float32 stay what they are,
    integers become float64. `out`: a tuple of arrays to fill. `workers`: threads that share the
    work on long arrays.

    ValueError: an input outside its domain, with its place; `out` or `workers` that does not fit.
    TypeError: an input that is no real number of these types; in `out` what is no array of the
    results' type.

    Source: derivation continuous-white-jerk
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
    t2 = form.sqrt(tracking_index)
    t3 = form.sqrt(t2)
    t5 = 2.220446049250313e-16 / tracking_index
    t7 = tracking_index * 4.625929269271486e-19
    t11 = form.sqrt(t5 + t7) * 67108864.0
    t13 = (t11 * t3) * 2.0
    t15 = t2 * 0.5
    t17 = tracking_index * 0.07083333333333333
    t24 = ((t2 * t3) * 1.5516447222296765) + (8.0 / t3)
    t25 = form.near_cbrt(t24)
    t29 = form.sqrt((t13 * t25) + t17)
    t32 = form.sqrt((t29 * 2.0) + t15)
    t33 = t13 * 0.5
    t34 = t29 * t32
    t39 = ((t32 * t34) - (t33 * t25)) / (t34 - t33)
    t43 = form.sqrt((t13 * t39) + t17)
    t46 = form.sqrt((t43 * 2.0) + t15)
    t47 = t43 * t46
    t52 = ((t46 * t47) - (t33 * t39)) / (t47 - t33)
    t56 = form.sqrt((t13 * t52) + t17)
    t59 = form.sqrt((t56 * 2.0) + t15)
    t60 = t56 * t59
    t65 = ((t59 * t60) - (t33 * t52)) / (t60 - t33)
    t69 = form.sqrt((t13 * t65) + t17)
    t72 = form.sqrt((t69 * 2.0) + t15)
    t73 = t69 * t72
    t78 = ((t72 * t73) - (t33 * t65)) / (t73 - t33)
    t82 = form.sqrt((t13 * t78) + t17)
    t83 = t82 * 2.0
    t85 = form.sqrt(t83 + t15)
    t87 = t2 * 0.25
    t88 = t82 + t87
    t91 = t85 * t3
    t95 = (t11 + (t82 * 0.5)) + ((t91 * 0.25) + (t2 * 0.125))
    t102 = t3 / t85
    t112 = (t11 * 0.2833333333333333) + (t82 * 0.016666666666666666)
    t116 = t102 * (t112 + (t2 * 0.004166666666666667))
    t119 = (t11 * (t88 + (t102 * t82))) + (t2 * ((t2 * 0.0125) + t116))
    t121 = ((6.0 / t95) / tracking_index) + (t119 / t95)
    t131 = (t11 * 0.3333333333333333) + (t82 * 0.041666666666666664)
    t137 = (t131 + (t91 * 0.020833333333333332)) + (t2 * 0.014583333333333334)
    t139 = (t11 * ((t91 * 0.5) + t82)) + (t2 * t137)
    t147 = ((t87 + t83) * tracking_index) / ((t3 * 0.5) + t85)
    t96 = t88 / t95
    t97 = t91 / t95
    t98 = t2 / t95
    t123 = (t15 * t121) * tracking_index
    t142 = ((t139 / t95) * t2) * tracking_index
    t149 = (t147 / t3) * tracking_index
    return (t96, t97, t98, t123, t142, t149)


def _updated_covariance_block(
    given: Arrays,
    out: Arrays,
    work: Arrays,
    single: bool,
    n0: float = 2.220446049250313e-16,
    n1: float = 4.625929269271486e-19,
    n2: float = 67108864.0,
    n3: float = 2.0,
    n4: float = 0.5,
    n5: float = 0.07083333333333333,
    n6: float = 1.5516447222296765,
    n7: float = 8.0,
    n8: float = 0.25,
    n9: float = 0.125,
    n10: float = 6.0,
    n11: float = 0.0125,
    n12: float = 0.2833333333333333,
    n13: float = 0.016666666666666666,
    n14: float = 0.004166666666666667,
    n15: float = 0.3333333333333333,
    n16: float = 0.041666666666666664,
    n17: float = 0.020833333333333332,
    n18: float = 0.014583333333333334,
) -> None:
    (tracking_index,) = given
    updated_11, updated_12, updated_13, updated_22, updated_23, updated_33 = out
    w0, w1, w2, w3, w4, w5, w6, w7, w8, w9, w10 = work
    p = sqrt(tracking_index, updated_13)
    r = sqrt(p, updated_11)
    t5 = divide(n0, tracking_index, updated_12)
    t7 = multiply(tracking_index, n1, w0)
    t8 = add(t5, t7, updated_12)
    c_scaled = sqrt(t8, updated_22)
    t11 = multiply(c_scaled, n2, updated_22)
    t12 = multiply(t11, r, w0)
    t13 = multiply(t12, n3, w0)
    t15 = multiply(p, n4, updated_12)
    t17 = multiply(tracking_index, n5, w1)
    t18 = multiply(p, r, w2)
    t21 = multiply(t18, n6, w2)
    t23 = divide(n7, r, updated_23)
    t24 = add(t21, t23, w2)
    t25 = near_cbrt(t24, w2, single)
    t27 = multiply(t13, t25, updated_23)
    t28 = add(t27, t17, updated_23)
    t29 = sqrt(t28, updated_33)
    t30 = multiply(t29, n3, updated_23)
    t31 = add(t30, t15, updated_23)
    t32 = sqrt(t31, updated_23)
    t33 = multiply(t13, n4, w3)
    t34 = multiply(t29, t32, updated_33)
    t35 = multiply(t32, t34, updated_23)
    t36 = multiply(t33, t25, w2)
    t37 = subtract(t35, t36, updated_23)
    t38 = subtract(t34, t33, updated_33)
    t39 = divide(t37, t38, updated_23)
    t41 = multiply(t13, t39, w2)
    t42 = add(t41, t17, w2)
    t43 = sqrt(t42, w2)
    t44 = multiply(t43, n3, updated_33)
    t45 = add(t44, t15, updated_33)
    t46 = sqrt(t45, updated_33)
    t47 = multiply(t43, t46, w2)
    t48 = multiply(t46, t47, updated_33)
    t49 = multiply(t33, t39, updated_23)
    t50 = subtract(t48, t49, updated_33)
    t51 = subtract(t47, t33, w2)
    t52 = divide(t50, t51, updated_33)
    t54 = multiply(t13, t52, w2)
    t55 = add(t54, t17, w2)
    t56 = sqrt(t55, w2)
    t57 = multiply(t56, n3, updated_23)
    t58 = add(t57, t15, updated_23)
    t59 = sqrt(t58, updated_23)
    t60 = multiply(t56, t59, w2)
    t61 = multiply(t59, t60, updated_23)
    t62 = multiply(t33, t52, updated_33)
    t63 = subtract(t61, t62, updated_23)
    t64 = subtract(t60, t33, w2)
    t65 = divide(t63, t64, updated_23)
    t67 = multiply(t13, t65, w2)
    t68 = add(t67, t17, w2)
    t69 = sqrt(t68, w2)
    t70 = multiply(t69, n3, updated_33)
    t71 = add(t70, t15, updated_33)
    t72 = sqrt(t71, updated_33)
    t73 = multiply(t69, t72, w2)
    t74 = multiply(t72, t73, updated_33)
    t75 = multiply(t33, t65, updated_23)
    t76 = subtract(t74, t75, updated_33)
    t77 = subtract(t73, t33, w2)
    t78 = divide(t76, t77, updated_33)
    t80 = multiply(t13, t78, w0)
    t81 = add(t80, t17, w0)
    e = sqrt(t81, w0)
    t83 = multiply(e, n3, w1)
    t84 = add(t83, t15, w2)
    x = sqrt(t84, w2)
    t87 = multiply(p, n8, w3)
    t88 = add(e, t87, updated_23)
    t89 = multiply(e, n4, updated_33)
    t90 = add(t11, t89, updated_33)
    t91 = multiply(x, r, w4)
    t92 = multiply(t91, n8, w5)
    t93 = multiply(p, n9, w6)
    t94 = add(t92, t93, w5)
    t95 = add(t90, t94, updated_33)
    t100 = divide(n10, t95, w5)
    t101 = divide(t100, tracking_index, w5)
    t102 = divide(r, x, w6)
    t103 = multiply(t102, e, w7)
    t104 = add(t88, t103, w7)
    t105 = multiply(t11, t104, w7)
    t107 = multiply(p, n11, w8)
    t109 = multiply(t11, n12, w9)
    t111 = multiply(e, n13, w10)
    t112 = add(t109, t111, w9)
    t114 = multiply(p, n14, w10)
    t115 = add(t112, t114, w9)
    t116 = multiply(t102, t115, w6)
    t117 = add(t107, t116, w8)
    t118 = multiply(p, t117, w8)
    t119 = add(t105, t118, w7)
    t120 = divide(t119, t95, w7)
    t121 = add(t101, t120, w5)
    t122 = multiply(t15, t121, w5)
    t124 = multiply(t91, n4, w6)
    t125 = add(t124, e, w6)
    t126 = multiply(t11, t125, w6)
    t128 = multiply(t11, n15, updated_22)
    t130 = multiply(e, n16, w0)
    t131 = add(t128, t130, updated_22)
    t133 = multiply(t91, n17, w0)
    t134 = add(t131, t133, updated_22)
    t136 = multiply(p, n18, w0)
    t137 = add(t134, t136, updated_22)
    t138 = multiply(p, t137, updated_22)
    t139 = add(t126, t138, w6)
    t140 = divide(t139, t95, w6)
    t141 = multiply(t140, p, w6)
    t143 = add(t87, t83, w3)
    t144 = multiply(t143, tracking_index, w3)
    t145 = multiply(r, n4, w0)
    t146 = add(t145, x, w0)
    t147 = divide(t144, t146, w3)
    t148 = divide(t147, r, w3)
    divide(t88, t95, updated_11)
    divide(t91, t95, updated_12)
    divide(p, t95, updated_13)
    multiply(t122, tracking_index, updated_22)
    multiply(t141, tracking_index, updated_23)
    multiply(t148, tracking_index, updated_33)


_UPDATED_COVARIANCE = Signature(
    "updated_covariance",
    (_TRACKING_INDEX_DOMAIN,),
    ("updated_11", "updated_12", "updated_13", "updated_22", "updated_23", "updated_33"),
    11,
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

        delta = sqrt(64/Lambda^2 + 2/15),
        xi = sqrt(2 + 2 eta), eta = sqrt(17/15 + 2 delta xi), nu = 1 + xi + eta + delta

    tracking_index: Lambda, with Lambda^2 =
        jerk_density*sampling_interval**5/measurement_deviation**2; a number above 0 and at most
        2^1000, in float32 above 0 and at most 2^120.

    updated_11: derivative of the variance of the updated position over sigma_v^2. Relative error at
        most 15.40 * 2^-52 (float64), 15.40 * 2^-23 (float32), proved for 5e-324 <= tracking_index
        <= 5.849498211276313e102 (float64) and 1e-45 <= tracking_index <= 7.235911e12 (float32).
    updated_12: derivative of the covariance of updated position and velocity times T/sigma_v^2.
        Relative error at most 15.92 * 2^-52 (float64), 15.93 * 2^-23 (float32), proved for 5e-324
        <= tracking_index <= 1.6140834523330185e103 (float64) and 1e-45 <= tracking_index <=
        1.9966437e13 (float32).
    updated_13: derivative of the covariance of updated position and acceleration times
        T^2/sigma_v^2. Relative error at most 16.18 * 2^-52 (float64), 16.22 * 2^-23 (float32),
        proved for 5e-324 <= tracking_index <= 1.9098208591277692e103 (float64) and 1e-45 <=
        tracking_index <= 2.362475e13 (float32).
    updated_22: derivative of the variance of the updated velocity times T^2/sigma_v^2. Relative
        error at most 14.47 * 2^-52 (float64), 14.44 * 2^-23 (float32), proved for 5e-324 <=
        tracking_index <= 1.0715086071862673e301 (float64) and 1e-45 <= tracking_index <=
        1.329228e36 (float32).
    updated_23: derivative of the covariance of updated velocity and acceleration times
        T^3/sigma_v^2. Relative error at most 13.10 * 2^-52 (float64), 13.07 * 2^-23 (float32),
        proved for 5e-324 <= tracking_index <= 1.0715086071862673e301 (float64) and 1e-45 <=
        tracking_index <= 1.329228e36 (float32).
    updated_33: derivative of the variance of the updated acceleration times T^4/sigma_v^2. Relative
        error at most 8.67 * 2^-52 (float64), 8.66 * 2^-23 (float32), proved for 5e-324 <=
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

    Source: derivation continuous-white-jerk
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
    t3 = form.sqrt(tracking_index)
    t4 = form.sqrt(t3)
    t6 = 2.220446049250313e-16 / tracking_index
    t8 = tracking_index * 4.625929269271486e-19
    t12 = form.sqrt(t6 + t8) * 67108864.0
    t14 = (t12 * t4) * 2.0
    t16 = t3 * 0.5
    t18 = tracking_index * 0.07083333333333333
    t19 = t3 * t4
    t25 = (t19 * 1.5516447222296765) + (8.0 / t4)
    t26 = form.near_cbrt(t25)
    t30 = form.sqrt((t14 * t26) + t18)
    t33 = form.sqrt((t30 * 2.0) + t16)
    t34 = t14 * 0.5
    t35 = t30 * t33
    t40 = ((t33 * t35) - (t34 * t26)) / (t35 - t34)
    t44 = form.sqrt((t14 * t40) + t18)
    t47 = form.sqrt((t44 * 2.0) + t16)
    t48 = t44 * t47
    t53 = ((t47 * t48) - (t34 * t40)) / (t48 - t34)
    t57 = form.sqrt((t14 * t53) + t18)
    t60 = form.sqrt((t57 * 2.0) + t16)
    t61 = t57 * t60
    t66 = ((t60 * t61) - (t34 * t53)) / (t61 - t34)
    t70 = form.sqrt((t14 * t66) + t18)
    t73 = form.sqrt((t70 * 2.0) + t16)
    t74 = t70 * t73
    t79 = ((t73 * t74) - (t34 * t66)) / (t74 - t34)
    t83 = form.sqrt((t14 * t79) + t18)
    t86 = form.sqrt((t83 * 2.0) + t16)
    t88 = t3 * 0.25
    t89 = t83 + t88
    t90 = t86 * t4
    t91 = t90 / t12
    t95 = t89 + ((t91 * t3) * 0.008333333333333333)
    t96 = t83 * t83
    t99 = t3 * t83
    t103 = tracking_index * 0.017708333333333333
    t104 = ((t96 * 0.75) + (t99 * 0.25)) + t103
    t106 = t90 * 0.25
    t108 = ((t95 / t104) * t106) / tracking_index
    t114 = (t12 + (t83 * 0.5)) + (t106 + (t3 * 0.125))
    t121 = ((t96 * 0.25) + (t99 * 0.125)) + t103
    t125 = (t121 + (t90 * (t89 * 0.125))) / t104
    t128 = (t125 * 2.0) * (t91 / tracking_index)
    t129 = t3 * t114
    t132 = t90 / t104
    t138 = ((t132 * ((t89 + t106) * 0.5)) + 1.0) / (t12 * t3)
    t145 = ((t132 / tracking_index) / t12) * 0.5
    t150 = t145 * (t106 * (1.0 + ((t86 / t4) * 2.0)))
    t151 = ((1.0 / t12) / tracking_index) + t150
    t152 = t151 / t114
    t156 = t152 * ((6.0 / t114) / tracking_index)
    t159 = ((t88 / t83) * 2.0) + 2.0
    t161 = (tracking_index * t159) * 0.017708333333333333
    t167 = ((tracking_index / t104) * t91) * 0.0010416666666666667
    t169 = ((t121 + t161) / t104) + (t167 * t159)
    t173 = ((tracking_index / t12) / t12) * 0.0020833333333333333
    t175 = (t169 + t173) + t152
    t176 = t175 * t83
    t177 = 1.0 + t152
    t178 = t177 + t173
    t182 = t4 / t86
    t186 = (t176 + ((t178 * t3) * 0.25)) + (t182 * ((t175 + t145) * t83))
    t188 = t177 + t169
    t190 = t177 + 1.0
    t191 = t190 * t3
    t197 = ((t178 + t145) * t12) * 0.2833333333333333
    t201 = ((t188 + t145) * t83) * 0.016666666666666666
    t206 = ((t190 + t145) * t3) * 0.004166666666666667
    t209 = (t191 * 0.0125) + (t182 * ((t197 + t201) + t206))
    t213 = t156 + (((t12 * t186) + (t3 * t209)) / t114)
    t217 = ((t121 / t104) * 2.0) + t167
    t222 = ((((t217 + t173) + t152) * t90) * 0.5) + t176
    t229 = ((t178 * t12) * 0.3333333333333333) + ((t188 * t83) * 0.041666666666666664)
    t233 = ((t177 + t217) * t90) * 0.020833333333333332
    t237 = (t229 + t233) + (t191 * 0.014583333333333334)
    t244 = (t4 * 0.5) + t86
    t246 = t145 * (t86 / t244)
    t253 = ((((1.0 + t169) + t246) * t83) * 2.0) + (((2.0 + t246) * t3) * 0.25)
    t117 = (((t108 * 2.0) / t114) / t114) / tracking_index
    t131 = (t128 / t129) / t129
    t140 = (t138 / t129) / t129
    t214 = t16 * t213
    t241 = (((t12 * t222) + (t3 * t237)) / t114) * t3
    t255 = (t253 / t244) * t19
    return (t117, t131, t140, t214, t241, t255)


def _updated_covariance_derivatives_block(
    given: Arrays,
    out: Arrays,
    work: Arrays,
    single: bool,
    n0: float = 2.220446049250313e-16,
    n1: float = 4.625929269271486e-19,
    n2: float = 67108864.0,
    n3: float = 2.0,
    n4: float = 0.5,
    n5: float = 0.07083333333333333,
    n6: float = 1.5516447222296765,
    n7: float = 8.0,
    n8: float = 0.25,
    n9: float = 0.008333333333333333,
    n10: float = 0.75,
    n11: float = 0.017708333333333333,
    n12: float = 0.125,
    n13: float = 1.0,
    n14: float = 6.0,
    n15: float = 0.0010416666666666667,
    n16: float = 0.0020833333333333333,
    n17: float = 0.0125,
    n18: float = 0.2833333333333333,
    n19: float = 0.016666666666666666,
    n20: float = 0.004166666666666667,
    n21: float = 0.3333333333333333,
    n22: float = 0.041666666666666664,
    n23: float = 0.020833333333333332,
    n24: float = 0.014583333333333334,
) -> None:
    (tracking_index,) = given
    updated_11, updated_12, updated_13, updated_22, updated_23, updated_33 = out
    (
        w0,
        w1,
        w2,
        w3,
        w4,
        w5,
        w6,
        w7,
        w8,
        w9,
        w10,
        w11,
        w12,
        w13,
        w14,
        w15,
        w16,
        w17,
        w18,
        w19,
        w20,
        w21,
        w22,
        w23,
        w24,
        w25,
    ) = work
    p = sqrt(tracking_index, updated_23)
    r = sqrt(p, updated_11)
    t6 = divide(n0, tracking_index, updated_12)
    t8 = multiply(tracking_index, n1, w0)
    t9 = add(t6, t8, updated_12)
    c_scaled = sqrt(t9, updated_13)
    t12 = multiply(c_scaled, n2, updated_13)
    t13 = multiply(t12, r, w0)
    t14 = multiply(t13, n3, w0)
    t16 = multiply(p, n4, w1)
    t18 = multiply(tracking_index, n5, updated_12)
    t19 = multiply(p, r, w2)
    t22 = multiply(t19, n6, w3)
    t24 = divide(n7, r, updated_22)
    t25 = add(t22, t24, w3)
    t26 = near_cbrt(t25, w3, single)
    t28 = multiply(t14, t26, updated_22)
    t29 = add(t28, t18, updated_22)
    t30 = sqrt(t29, updated_33)
    t31 = multiply(t30, n3, updated_22)
    t32 = add(t31, t16, updated_22)
    t33 = sqrt(t32, updated_22)
    t34 = multiply(t14, n4, w4)
    t35 = multiply(t30, t33, updated_33)
    t36 = multiply(t33, t35, updated_22)
    t37 = multiply(t34, t26, w3)
    t38 = subtract(t36, t37, updated_22)
    t39 = subtract(t35, t34, updated_33)
    t40 = divide(t38, t39, updated_22)
    t42 = multiply(t14, t40, w3)
    t43 = add(t42, t18, w3)
    t44 = sqrt(t43, w3)
    t45 = multiply(t44, n3, updated_33)
    t46 = add(t45, t16, updated_33)
    t47 = sqrt(t46, updated_33)
    t48 = multiply(t44, t47, w3)
    t49 = multiply(t47, t48, updated_33)
    t50 = multiply(t34, t40, updated_22)
    t51 = subtract(t49, t50, updated_33)
    t52 = subtract(t48, t34, w3)
    t53 = divide(t51, t52, updated_33)
    t55 = multiply(t14, t53, w3)
    t56 = add(t55, t18, w3)
    t57 = sqrt(t56, w3)
    t58 = multiply(t57, n3, updated_22)
    t59 = add(t58, t16, updated_22)
    t60 = sqrt(t59, updated_22)
    t61 = multiply(t57, t60, w3)
    t62 = multiply(t60, t61, updated_22)
    t63 = multiply(t34, t53, updated_33)
    t64 = subtract(t62, t63, updated_22)
    t65 = subtract(t61, t34, w3)
    t66 = divide(t64, t65, updated_22)
    t68 = multiply(t14, t66, w3)
    t69 = add(t68, t18, w3)
    t70 = sqrt(t69, w3)
    t71 = multiply(t70, n3, updated_33)
    t72 = add(t71, t16, updated_33)
    t73 = sqrt(t72, updated_33)
    t74 = multiply(t70, t73, w3)
    t75 = multiply(t73, t74, updated_33)
    t76 = multiply(t34, t66, updated_22)
    t77 = subtract(t75, t76, updated_33)
    t78 = subtract(t74, t34, w3)
    t79 = divide(t77, t78, updated_33)
    t81 = multiply(t14, t79, w0)
    t82 = add(t81, t18, w0)
    e = sqrt(t82, w0)
    t84 = multiply(e, n3, w3)
    t85 = add(t84, t16, w3)
    x = sqrt(t85, w3)
    t88 = multiply(p, n8, w4)
    t89 = add(e, t88, updated_12)
    t90 = multiply(x, r, updated_22)
    t91 = divide(t90, t12, updated_33)
    t92 = multiply(t91, p, w5)
    t94 = multiply(t92, n9, w5)
    t95 = add(t89, t94, w5)
    t96 = square(e, w6)
    t98 = multiply(t96, n10, w7)
    t99 = multiply(p, e, w8)
    t100 = multiply(t99, n8, w9)
    t101 = add(t98, t100, w7)
    t103 = multiply(tracking_index, n11, w9)
    t104 = add(t101, t103, w7)
    t105 = divide(t95, t104, w5)
    t106 = multiply(t90, n8, w10)
    t107 = multiply(t105, t106, w5)
    t108 = divide(t107, tracking_index, w5)
    t109 = multiply(t108, n3, w5)
    t110 = multiply(e, n4, w11)
    t111 = add(t12, t110, w11)
    t112 = multiply(p, n12, w12)
    t113 = add(t106, t112, w12)
    t114 = add(t111, t113, w11)
    t115 = divide(t109, t114, w5)
    t116 = divide(t115, t114, w5)
    t118 = multiply(t96, n8, w6)
    t119 = multiply(t99, n12, w8)
    t120 = add(t118, t119, w6)
    t121 = add(t120, t103, w6)
    t122 = multiply(t89, n12, w8)
    t123 = multiply(t90, t122, w8)
    t124 = add(t121, t123, w8)
    t125 = divide(t124, t104, w8)
    t126 = multiply(t125, n3, w8)
    t127 = divide(t91, tracking_index, w9)
    t128 = multiply(t126, t127, w8)
    t129 = multiply(p, t114, w9)
    t130 = divide(t128, t129, w8)
    t132 = divide(t90, t104, w12)
    t133 = add(t89, t106, updated_12)
    t134 = multiply(t133, n4, updated_12)
    t135 = multiply(t132, t134, updated_12)
    t136 = add(t135, n13, updated_12)
    t137 = multiply(t12, p, w13)
    t138 = divide(t136, t137, updated_12)
    t139 = divide(t138, t129, w13)
    t141 = divide(n13, t12, updated_12)
    t142 = divide(t141, tracking_index, updated_12)
    t143 = divide(t132, tracking_index, w12)
    t144 = divide(t143, t12, w12)
    t145 = multiply(t144, n4, w12)
    t146 = divide(x, r, w14)
    t147 = multiply(t146, n3, w14)
    t148 = add(n13, t147, w14)
    t149 = multiply(t106, t148, w10)
    t150 = multiply(t145, t149, w10)
    t151 = add(t142, t150, updated_12)
    t152 = divide(t151, t114, updated_12)
    t154 = divide(n14, t114, w10)
    t155 = divide(t154, tracking_index, w10)
    t156 = multiply(t152, t155, w10)
    t157 = divide(t88, e, w4)
    t158 = multiply(t157, n3, w4)
    t159 = add(t158, n3, w4)
    t160 = multiply(tracking_index, t159, w14)
    t161 = multiply(t160, n11, w14)
    t162 = add(t121, t161, w14)
    t163 = divide(t162, t104, w14)
    t164 = divide(tracking_index, t104, w15)
    t165 = multiply(t164, t91, w15)
    t167 = multiply(t165, n15, w15)
    t168 = multiply(t167, t159, w4)
    t169 = add(t163, t168, w14)
    t170 = divide(tracking_index, t12, w4)
    t171 = divide(t170, t12, w4)
    t173 = multiply(t171, n16, w4)
    t174 = add(t169, t173, updated_33)
    t175 = add(t174, t152, updated_33)
    t176 = multiply(t175, e, w16)
    t177 = add(n13, t152, w17)
    t178 = add(t177, t173, w18)
    t179 = multiply(t178, p, w19)
    t180 = multiply(t179, n8, w19)
    t181 = add(t176, t180, w19)
    t182 = divide(r, x, w20)
    t183 = add(t175, t145, updated_33)
    t184 = multiply(t183, e, updated_33)
    t185 = multiply(t182, t184, updated_33)
    t186 = add(t181, t185, w19)
    t187 = multiply(t12, t186, w19)
    t188 = add(t177, t169, updated_33)
    t189 = multiply(t188, e, w21)
    t190 = add(t177, n13, w22)
    t191 = multiply(t190, p, w23)
    t193 = multiply(t191, n17, w24)
    t194 = add(t178, t145, w25)
    t195 = multiply(t194, t12, w25)
    t197 = multiply(t195, n18, w25)
    t198 = add(t188, t145, updated_33)
    t199 = multiply(t198, e, updated_33)
    t201 = multiply(t199, n19, updated_33)
    t202 = add(t197, t201, w25)
    t203 = add(t190, t145, w22)
    t204 = multiply(t203, p, w22)
    t206 = multiply(t204, n20, w22)
    t207 = add(t202, t206, w25)
    t208 = multiply(t182, t207, w20)
    t209 = add(t193, t208, w24)
    t210 = multiply(p, t209, w24)
    t211 = add(t187, t210, w19)
    t212 = divide(t211, t114, w19)
    t213 = add(t156, t212, w10)
    t215 = divide(t121, t104, w6)
    t216 = multiply(t215, n3, w6)
    t217 = add(t216, t167, w6)
    t218 = add(t217, t173, w4)
    t219 = add(t218, t152, w4)
    t220 = multiply(t219, t90, w4)
    t221 = multiply(t220, n4, w4)
    t222 = add(t221, t176, w4)
    t223 = multiply(t12, t222, w4)
    t224 = multiply(t178, t12, w18)
    t226 = multiply(t224, n21, w18)
    t228 = multiply(t189, n22, w21)
    t229 = add(t226, t228, w18)
    t230 = add(t177, t217, w17)
    t231 = multiply(t230, t90, w17)
    t233 = multiply(t231, n23, w17)
    t234 = add(t229, t233, w18)
    t236 = multiply(t191, n24, w23)
    t237 = add(t234, t236, w18)
    t238 = multiply(p, t237, w18)
    t239 = add(t223, t238, w4)
    t240 = divide(t239, t114, w4)
    t242 = add(n13, t169, w14)
    t243 = multiply(r, n4, updated_11)
    t244 = add(t243, x, updated_11)
    t245 = divide(x, t244, w3)
    t246 = multiply(t145, t245, w12)
    t247 = add(t242, t246, w14)
    t248 = multiply(t247, e, w14)
    t249 = multiply(t248, n3, w14)
    t250 = add(n3, t246, w12)
    t251 = multiply(t250, p, w12)
    t252 = multiply(t251, n8, w12)
    t253 = add(t249, t252, w14)
    t254 = divide(t253, t244, w14)
    divide(t116, tracking_index, updated_11)
    divide(t130, t129, updated_12)
    divide(t139, t129, updated_13)
    multiply(t16, t213, updated_22)
    multiply(t240, p, updated_23)
    multiply(t254, t19, updated_33)


_UPDATED_COVARIANCE_DERIVATIVES = Signature(
    "updated_covariance_derivatives",
    (_TRACKING_INDEX_DOMAIN_2,),
    ("updated_11", "updated_12", "updated_13", "updated_22", "updated_23", "updated_33"),
    26,
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

        delta = sqrt(64/Lambda^2 + 2/15),
        xi = sqrt(2 + 2 eta), eta = sqrt(17/15 + 2 delta xi), nu = 1 + xi + eta + delta

    tracking_index: Lambda, with Lambda^2 =
        jerk_density*sampling_interval**5/measurement_deviation**2; a number above 0 and finite.

    alpha: second derivative by Lambda of the position gain. Relative error at most 26.51 * 2^-52
        (float64), 27.29 * 2^-23 (float32), proved for 6.852691063641751e-186 <= tracking_index <=
        1.565378169971955e77 (float64) and 4.6734494e-24 <= tracking_index <= 5.80631e09 (float32).
    beta: second derivative by Lambda of the velocity gain times the sampling interval. Relative
        error at most 36.29 * 2^-52 (float64), 36.28 * 2^-23 (float32), proved for
        3.506117298416322e-232 <= tracking_index <= 3.351388711764904e77 (float64) and 6.871575e-30
        <= tracking_index <= 1.2430991e10 (float32).
    gamma: second derivative by Lambda of the acceleration gain times the square of the sampling
        interval. Relative error at most 32.53 * 2^-52 (float64), 32.58 * 2^-23 (float32), proved
        for 5e-324 <= tracking_index <= 3.8021109680071646e77 (float64) and 1e-45 <= tracking_index
        <= 1.4102813e10 (float32).

    Outside an output's range, a few numbers next to its ends apart, its true value is no normal
    number: it comes as 0, a subnormal number or infinity, never as NaN. Numbers and arrays are
    taken, arrays of any shape; inputs are broadcast. float64 and float32 stay what they are,
    integers become float64. `out`: a tuple of arrays to fill. `workers`: threads that share the
    work on long arrays.

    ValueError: an input outside its domain, with its place; `out` or `workers` that does not fit.
    TypeError: an input that is no real number of these types; in `out` what is no array of the
    results' type.

    Source: derivation continuous-white-jerk
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
    t3 = form.sqrt(tracking_index)
    t4 = form.sqrt(t3)
    t6 = 2.220446049250313e-16 / tracking_index
    t8 = tracking_index * 4.625929269271486e-19
    t12 = form.sqrt(t6 + t8) * 67108864.0
    t14 = (t12 * t4) * 2.0
    t16 = t3 * 0.5
    t18 = tracking_index * 0.07083333333333333
    t25 = ((t3 * t4) * 1.5516447222296765) + (8.0 / t4)
    t26 = form.near_cbrt(t25)
    t30 = form.sqrt((t14 * t26) + t18)
    t33 = form.sqrt((t30 * 2.0) + t16)
    t34 = t14 * 0.5
    t35 = t30 * t33
    t40 = ((t33 * t35) - (t34 * t26)) / (t35 - t34)
    t44 = form.sqrt((t14 * t40) + t18)
    t47 = form.sqrt((t44 * 2.0) + t16)
    t48 = t44 * t47
    t53 = ((t47 * t48) - (t34 * t40)) / (t48 - t34)
    t57 = form.sqrt((t14 * t53) + t18)
    t60 = form.sqrt((t57 * 2.0) + t16)
    t61 = t57 * t60
    t66 = ((t60 * t61) - (t34 * t53)) / (t61 - t34)
    t70 = form.sqrt((t14 * t66) + t18)
    t73 = form.sqrt((t70 * 2.0) + t16)
    t74 = t70 * t73
    t79 = ((t73 * t74) - (t34 * t66)) / (t74 - t34)
    t83 = form.sqrt((t14 * t79) + t18)
    t86 = form.sqrt((t83 * 2.0) + t16)
    t87 = t86 / t4
    t88 = t87 * 2.0
    t91 = (t3 * 0.25) / t83
    t92 = t91 + 1.0
    t95 = t91 * 1.1333333333333333
    t100 = (t91 * (t95 + 4.0)) + 3.0
    t103 = t3 / t83
    t108 = ((t103 / t100) * t103) * (t87 * (t3 / t12))
    t110 = t108 * 0.004166666666666667
    t111 = (((t92 * t91) / t100) * 2.0) + t110
    t112 = t111 * t88
    t117 = (t91 * 2.0) + 2.0
    t120 = ((t91 / t100) * (t117 / t100)) / t100
    t125 = t91 * ((t91 * 0.7544444444444445) + 1.6)
    t132 = (t91 * ((t91 * (t125 + 2.1)) + 2.0)) + 0.75
    t138 = ((tracking_index / t12) / t12) * 0.0020833333333333333
    t143 = (((t86 / t83) / (t83 * t100)) / t4) / t12
    t145 = (t143 / t3) * 2.0
    t148 = (t117 * t91) / t100
    t151 = (t138 + t145) + ((t148 * t148) * 4.0)
    t152 = t145 + t110
    t156 = t152 + (((t117 * t117) / t100) * 2.0)
    t157 = t110 * t156
    t160 = (t120 * (t132 * 8.0)) + (t110 * (t151 + t157))
    t163 = (t88 * (((t111 * t112) * 2.0) + t160)) * 2.0
    t167 = t86 * t4
    t171 = (t12 + (t83 * 0.5)) + ((t167 * 0.25) + (t3 * 0.125))
    t172 = t3 * t171
    t174 = ((t163 / tracking_index) / t172) / t172
    t177 = t167 / t171
    t189 = t91 * ((t91 * 2.908888888888889) + 10.2)
    t197 = (t91 * ((t91 * (t189 + 12.8)) + 7.0)) + 1.5
    t201 = ((t112 * t92) * 2.0) + (((t92 / t100) * (t197 / t100)) * 4.0)
    t208 = t91 * ((t91 * 2.8666666666666667) + 6.0)
    t211 = ((t208 + 3.0) / t100) * 2.0
    t214 = t145 * (t117 + (((t12 / t83) * 2.0) * t211))
    t220 = (((t91 * (t95 + 2.0)) + 1.0) / t100) * 2.0
    t221 = t220 * t100
    t223 = (t83 / t3) * 4.0
    t227 = t110 * ((t221 * t223) + (t92 * t211))
    t233 = t138 * (((t223 / t88) * (t221 * 0.5)) + t92)
    t235 = (t145 * (t83 / t171)) * (((t201 + t214) + t227) + t233)
    t236 = ((t177 / tracking_index) * 0.5) * t235
    t244 = (((t223 * (t100 * 0.5)) / t117) + 1.0) + t88
    t251 = (((t152 * t91) * (t92 + t117)) / t100) * 2.0
    t252 = t148 * 2.0
    t257 = ((t251 + (t252 * t252)) + t157) + (t138 * t220)
    t258 = (t111 * ((t177 * 0.25) * t244)) + t257
    t262 = ((t145 * (t88 * t258)) / t172) / tracking_index
    t176 = -(t174 / tracking_index)
    t238 = -(t236 / tracking_index)
    t263 = -t262
    return (t176, t238, t263)


def _gain_second_derivatives_block(
    given: Arrays,
    out: Arrays,
    work: Arrays,
    single: bool,
    n0: float = 2.220446049250313e-16,
    n1: float = 4.625929269271486e-19,
    n2: float = 67108864.0,
    n3: float = 2.0,
    n4: float = 0.5,
    n5: float = 0.07083333333333333,
    n6: float = 1.5516447222296765,
    n7: float = 8.0,
    n8: float = 0.25,
    n9: float = 1.0,
    n10: float = 1.1333333333333333,
    n11: float = 4.0,
    n12: float = 3.0,
    n13: float = 0.004166666666666667,
    n14: float = 0.7544444444444445,
    n15: float = 1.6,
    n16: float = 2.1,
    n17: float = 0.75,
    n18: float = 0.0020833333333333333,
    n19: float = 0.125,
    n20: float = 2.908888888888889,
    n21: float = 10.2,
    n22: float = 12.8,
    n23: float = 7.0,
    n24: float = 1.5,
    n25: float = 2.8666666666666667,
    n26: float = 6.0,
) -> None:
    (tracking_index,) = given
    alpha, beta, gamma = out
    (
        w0,
        w1,
        w2,
        w3,
        w4,
        w5,
        w6,
        w7,
        w8,
        w9,
        w10,
        w11,
        w12,
        w13,
        w14,
        w15,
        w16,
        w17,
        w18,
        w19,
        w20,
    ) = work
    p = sqrt(tracking_index, alpha)
    r = sqrt(p, beta)
    t6 = divide(n0, tracking_index, gamma)
    t8 = multiply(tracking_index, n1, w0)
    t9 = add(t6, t8, gamma)
    c_scaled = sqrt(t9, gamma)
    t12 = multiply(c_scaled, n2, gamma)
    t13 = multiply(t12, r, w0)
    t14 = multiply(t13, n3, w0)
    t16 = multiply(p, n4, w1)
    t18 = multiply(tracking_index, n5, w2)
    t19 = multiply(p, r, w3)
    t22 = multiply(t19, n6, w3)
    t24 = divide(n7, r, w4)
    t25 = add(t22, t24, w3)
    t26 = near_cbrt(t25, w3, single)
    t28 = multiply(t14, t26, w4)
    t29 = add(t28, t18, w4)
    t30 = sqrt(t29, w4)
    t31 = multiply(t30, n3, w5)
    t32 = add(t31, t16, w5)
    t33 = sqrt(t32, w5)
    t34 = multiply(t14, n4, w6)
    t35 = multiply(t30, t33, w4)
    t36 = multiply(t33, t35, w5)
    t37 = multiply(t34, t26, w3)
    t38 = subtract(t36, t37, w5)
    t39 = subtract(t35, t34, w4)
    t40 = divide(t38, t39, w5)
    t42 = multiply(t14, t40, w3)
    t43 = add(t42, t18, w3)
    t44 = sqrt(t43, w3)
    t45 = multiply(t44, n3, w4)
    t46 = add(t45, t16, w4)
    t47 = sqrt(t46, w4)
    t48 = multiply(t44, t47, w3)
    t49 = multiply(t47, t48, w4)
    t50 = multiply(t34, t40, w5)
    t51 = subtract(t49, t50, w4)
    t52 = subtract(t48, t34, w3)
    t53 = divide(t51, t52, w4)
    t55 = multiply(t14, t53, w3)
    t56 = add(t55, t18, w3)
    t57 = sqrt(t56, w3)
    t58 = multiply(t57, n3, w5)
    t59 = add(t58, t16, w5)
    t60 = sqrt(t59, w5)
    t61 = multiply(t57, t60, w3)
    t62 = multiply(t60, t61, w5)
    t63 = multiply(t34, t53, w4)
    t64 = subtract(t62, t63, w5)
    t65 = subtract(t61, t34, w3)
    t66 = divide(t64, t65, w5)
    t68 = multiply(t14, t66, w3)
    t69 = add(t68, t18, w3)
    t70 = sqrt(t69, w3)
    t71 = multiply(t70, n3, w4)
    t72 = add(t71, t16, w4)
    t73 = sqrt(t72, w4)
    t74 = multiply(t70, t73, w3)
    t75 = multiply(t73, t74, w4)
    t76 = multiply(t34, t66, w5)
    t77 = subtract(t75, t76, w4)
    t78 = subtract(t74, t34, w3)
    t79 = divide(t77, t78, w4)
    t81 = multiply(t14, t79, w0)
    t82 = add(t81, t18, w0)
    e = sqrt(t82, w0)
    t84 = multiply(e, n3, w2)
    t85 = add(t84, t16, w2)
    x = sqrt(t85, w2)
    t87 = divide(x, r, w1)
    t88 = multiply(t87, n3, w3)
    t90 = multiply(p, n8, w4)
    t91 = divide(t90, e, w4)
    t92 = add(t91, n9, w5)
    t93 = multiply(t92, t91, w6)
    t95 = multiply(t91, n10, w7)
    t97 = add(t95, n11, w8)
    t98 = multiply(t91, t97, w8)
    t100 = add(t98, n12, w8)
    t101 = divide(t93, t100, w6)
    t102 = multiply(t101, n3, w6)
    t103 = divide(p, e, w9)
    t104 = divide(t103, t100, w10)
    t105 = multiply(t104, t103, w10)
    t106 = divide(p, t12, w9)
    t107 = multiply(t87, t106, w1)
    t108 = multiply(t105, t107, w10)
    t110 = multiply(t108, n13, w10)
    t111 = add(t102, t110, w6)
    t112 = multiply(t111, t88, w1)
    t113 = multiply(t111, t112, w9)
    t114 = multiply(t113, n3, w9)
    t115 = divide(t91, t100, w11)
    t116 = multiply(t91, n3, w12)
    t117 = add(t116, n3, w12)
    t118 = divide(t117, t100, w13)
    t119 = multiply(t115, t118, w11)
    t120 = divide(t119, t100, w11)
    t122 = multiply(t91, n14, w13)
    t124 = add(t122, n15, w13)
    t125 = multiply(t91, t124, w13)
    t127 = add(t125, n16, w13)
    t128 = multiply(t91, t127, w13)
    t129 = add(t128, n3, w13)
    t130 = multiply(t91, t129, w13)
    t132 = add(t130, n17, w13)
    t133 = multiply(t132, n7, w13)
    t134 = multiply(t120, t133, w11)
    t135 = divide(tracking_index, t12, w13)
    t136 = divide(t135, t12, w13)
    t138 = multiply(t136, n18, w13)
    t139 = divide(x, e, w14)
    t140 = multiply(e, t100, w15)
    t141 = divide(t139, t140, w14)
    t142 = divide(t141, r, w14)
    t143 = divide(t142, t12, w14)
    t144 = divide(t143, p, w14)
    t145 = multiply(t144, n3, w14)
    t146 = add(t138, t145, w15)
    t147 = multiply(t117, t91, w16)
    t148 = divide(t147, t100, w16)
    t149 = square(t148, w17)
    t150 = multiply(t149, n11, w17)
    t151 = add(t146, t150, w15)
    t152 = add(t145, t110, w17)
    t153 = square(t117, w18)
    t154 = divide(t153, t100, w18)
    t155 = multiply(t154, n3, w18)
    t156 = add(t152, t155, w18)
    t157 = multiply(t110, t156, w18)
    t158 = add(t151, t157, w15)
    t159 = multiply(t110, t158, w15)
    t160 = add(t134, t159, w11)
    t161 = add(t114, t160, w9)
    t162 = multiply(t88, t161, w9)
    t163 = multiply(t162, n3, w9)
    t164 = divide(t163, tracking_index, w9)
    t165 = multiply(e, n4, w11)
    t166 = add(t12, t165, w11)
    t167 = multiply(x, r, w2)
    t168 = multiply(t167, n8, w15)
    t169 = multiply(p, n19, beta)
    t170 = add(t168, t169, w15)
    t171 = add(t166, t170, w11)
    t172 = multiply(p, t171, w15)
    t173 = divide(t164, t172, w9)
    t174 = divide(t173, t172, w9)
    t175 = divide(t174, tracking_index, w9)
    t177 = divide(t167, t171, w2)
    t178 = divide(t177, tracking_index, beta)
    t179 = multiply(t178, n4, beta)
    t180 = divide(e, t171, w11)
    t181 = multiply(t145, t180, w11)
    t182 = multiply(t112, t92, w1)
    t183 = multiply(t182, n3, w1)
    t184 = divide(t92, t100, w19)
    t186 = multiply(t91, n20, w20)
    t188 = add(t186, n21, w20)
    t189 = multiply(t91, t188, w20)
    t191 = add(t189, n22, w20)
    t192 = multiply(t91, t191, w20)
    t194 = add(t192, n23, w20)
    t195 = multiply(t91, t194, w20)
    t197 = add(t195, n24, w20)
    t198 = divide(t197, t100, w20)
    t199 = multiply(t184, t198, w19)
    t200 = multiply(t199, n11, w19)
    t201 = add(t183, t200, w1)
    t202 = divide(t12, e, gamma)
    t203 = multiply(t202, n3, gamma)
    t205 = multiply(t91, n25, w19)
    t207 = add(t205, n26, w19)
    t208 = multiply(t91, t207, w19)
    t209 = add(t208, n12, w19)
    t210 = divide(t209, t100, w19)
    t211 = multiply(t210, n3, w19)
    t212 = multiply(t203, t211, gamma)
    t213 = add(t117, t212, gamma)
    t214 = multiply(t145, t213, gamma)
    t215 = add(t201, t214, w1)
    t216 = add(t95, n3, w7)
    t217 = multiply(t91, t216, w7)
    t218 = add(t217, n9, w7)
    t219 = divide(t218, t100, w7)
    t220 = multiply(t219, n3, w7)
    t221 = multiply(t220, t100, w20)
    t222 = divide(e, p, w0)
    t223 = multiply(t222, n11, w0)
    t224 = multiply(t221, t223, alpha)
    t225 = multiply(t92, t211, w19)
    t226 = add(t224, t225, alpha)
    t227 = multiply(t110, t226, w10)
    t228 = add(t215, t227, w1)
    t229 = divide(t223, t88, w10)
    t230 = multiply(t221, n4, w20)
    t231 = multiply(t229, t230, w10)
    t232 = add(t231, t92, w10)
    t233 = multiply(t138, t232, w10)
    t234 = add(t228, t233, w1)
    t235 = multiply(t181, t234, w11)
    t236 = multiply(t179, t235, beta)
    t237 = divide(t236, tracking_index, beta)
    t239 = multiply(t177, n8, w2)
    t240 = multiply(t100, n4, w1)
    t241 = multiply(t223, t240, w0)
    t242 = divide(t241, t117, w0)
    t243 = add(t242, n9, w0)
    t244 = add(t243, t88, w0)
    t245 = multiply(t239, t244, w2)
    t246 = multiply(t111, t245, w6)
    t247 = multiply(t152, t91, w17)
    t248 = add(t92, t117, w5)
    t249 = multiply(t247, t248, w17)
    t250 = divide(t249, t100, w17)
    t251 = multiply(t250, n3, w17)
    t252 = multiply(t148, n3, w16)
    t253 = square(t252, w16)
    t254 = add(t251, t253, w17)
    t255 = add(t254, t157, w17)
    t256 = multiply(t138, t220, w13)
    t257 = add(t255, t256, w17)
    t258 = add(t246, t257, w6)
    t259 = multiply(t88, t258, w3)
    t260 = multiply(t145, t259, w14)
    t261 = divide(t260, t172, w14)
    t262 = divide(t261, tracking_index, w14)
    negative(t175, alpha)
    negative(t237, beta)
    negative(t262, gamma)


_GAIN_SECOND_DERIVATIVES = Signature(
    "gain_second_derivatives",
    (_TRACKING_INDEX_DOMAIN,),
    ("alpha", "beta", "gamma"),
    21,
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

        delta = sqrt(64/Lambda^2 + 2/15),
        xi = sqrt(2 + 2 eta), eta = sqrt(17/15 + 2 delta xi), nu = 1 + xi + eta + delta

    tracking_index: Lambda, with Lambda^2 =
        jerk_density*sampling_interval**5/measurement_deviation**2; a number above 0 and finite.

    position: second derivative by Lambda of the position entry of F K, alpha + beta + gamma/2.
        Relative error at most 30.13 * 2^-52 (float64), 30.16 * 2^-23 (float32), proved for
        6.8526910636419685e-186 <= tracking_index <= 3.922157988100115e77 (float64) and 4.673531e-24
        <= tracking_index <= 1.4548092e10 (float32).
    velocity: second derivative by Lambda of the velocity entry of F K times the sampling interval,
        beta + gamma. Relative error at most 36.79 * 2^-52 (float64), 36.78 * 2^-23 (float32),
        proved for 3.5061172984163225e-232 <= tracking_index <= 4.2786186800086156e77 (float64) and
        6.871576e-30 <= tracking_index <= 1.5870279e10 (float32).
    acceleration: second derivative by Lambda of the acceleration entry of F K times the square of
        the sampling interval, gamma. Relative error at most 32.53 * 2^-52 (float64), 32.58 * 2^-23
        (float32), proved for 5e-324 <= tracking_index <= 3.8021109680071646e77 (float64) and 1e-45
        <= tracking_index <= 1.4102813e10 (float32).

    Outside an output's range, a few numbers next to its ends apart, its true value is no normal
    number: it comes as 0, a subnormal number or infinity, never as NaN. Numbers and arrays are
    taken, arrays of any shape; inputs are broadcast. float64 and float32 stay what they are,
    integers become float64. `out`: a tuple of arrays to fill. `workers`: threads that share the
    work on long arrays.

    ValueError: an input outside its domain, with its place; `out` or `workers` that does not fit.
    TypeError: an input that is no real number of these types; in `out` what is no array of the
    results' type.

    Source: derivation continuous-white-jerk
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
    t3 = form.sqrt(tracking_index)
    t4 = form.sqrt(t3)
    t6 = 2.220446049250313e-16 / tracking_index
    t8 = tracking_index * 4.625929269271486e-19
    t12 = form.sqrt(t6 + t8) * 67108864.0
    t14 = (t12 * t4) * 2.0
    t16 = t3 * 0.5
    t18 = tracking_index * 0.07083333333333333
    t25 = ((t3 * t4) * 1.5516447222296765) + (8.0 / t4)
    t26 = form.near_cbrt(t25)
    t30 = form.sqrt((t14 * t26) + t18)
    t33 = form.sqrt((t30 * 2.0) + t16)
    t34 = t14 * 0.5
    t35 = t30 * t33
    t40 = ((t33 * t35) - (t34 * t26)) / (t35 - t34)
    t44 = form.sqrt((t14 * t40) + t18)
    t47 = form.sqrt((t44 * 2.0) + t16)
    t48 = t44 * t47
    t53 = ((t47 * t48) - (t34 * t40)) / (t48 - t34)
    t57 = form.sqrt((t14 * t53) + t18)
    t60 = form.sqrt((t57 * 2.0) + t16)
    t61 = t57 * t60
    t66 = ((t60 * t61) - (t34 * t53)) / (t61 - t34)
    t70 = form.sqrt((t14 * t66) + t18)
    t73 = form.sqrt((t70 * 2.0) + t16)
    t74 = t70 * t73
    t79 = ((t73 * t74) - (t34 * t66)) / (t74 - t34)
    t83 = form.sqrt((t14 * t79) + t18)
    t86 = form.sqrt((t83 * 2.0) + t16)
    t87 = t86 / t4
    t88 = t87 * 2.0
    t91 = (t3 * 0.25) / t83
    t92 = t91 + 1.0
    t95 = t91 * 1.1333333333333333
    t100 = (t91 * (t95 + 4.0)) + 3.0
    t103 = t3 / t83
    t108 = ((t103 / t100) * t103) * (t87 * (t3 / t12))
    t110 = t108 * 0.004166666666666667
    t111 = (((t92 * t91) / t100) * 2.0) + t110
    t112 = t111 * t88
    t117 = (t91 * 2.0) + 2.0
    t120 = ((t91 / t100) * (t117 / t100)) / t100
    t125 = t91 * ((t91 * 0.7544444444444445) + 1.6)
    t132 = (t91 * ((t91 * (t125 + 2.1)) + 2.0)) + 0.75
    t138 = ((tracking_index / t12) / t12) * 0.0020833333333333333
    t143 = (((t86 / t83) / (t83 * t100)) / t4) / t12
    t145 = (t143 / t3) * 2.0
    t148 = (t117 * t91) / t100
    t151 = (t138 + t145) + ((t148 * t148) * 4.0)
    t152 = t145 + t110
    t156 = t152 + (((t117 * t117) / t100) * 2.0)
    t157 = t110 * t156
    t160 = (t120 * (t132 * 8.0)) + (t110 * (t151 + t157))
    t163 = (t88 * (((t111 * t112) * 2.0) + t160)) * 2.0
    t167 = t86 * t4
    t171 = (t12 + (t83 * 0.5)) + ((t167 * 0.25) + (t3 * 0.125))
    t172 = t3 * t171
    t174 = ((t163 / tracking_index) / t172) / t172
    t176 = t167 / t171
    t188 = t91 * ((t91 * 2.908888888888889) + 10.2)
    t196 = (t91 * ((t91 * (t188 + 12.8)) + 7.0)) + 1.5
    t200 = ((t112 * t92) * 2.0) + (((t92 / t100) * (t196 / t100)) * 4.0)
    t207 = t91 * ((t91 * 2.8666666666666667) + 6.0)
    t210 = ((t207 + 3.0) / t100) * 2.0
    t213 = t145 * (t117 + (((t12 / t83) * 2.0) * t210))
    t219 = (((t91 * (t95 + 2.0)) + 1.0) / t100) * 2.0
    t220 = t219 * t100
    t222 = (t83 / t3) * 4.0
    t226 = t110 * ((t220 * t222) + (t92 * t210))
    t232 = t138 * (((t222 / t88) * (t220 * 0.5)) + t92)
    t234 = (t145 * (t83 / t171)) * (((t200 + t213) + t226) + t232)
    t235 = ((t176 / tracking_index) * 0.5) * t234
    t236 = t235 / tracking_index
    t242 = (((t222 * (t100 * 0.5)) / t117) + 1.0) + t88
    t249 = (((t152 * t91) * (t92 + t117)) / t100) * 2.0
    t250 = t148 * 2.0
    t255 = ((t249 + (t250 * t250)) + t157) + (t138 * t219)
    t256 = (t111 * ((t176 * 0.25) * t242)) + t255
    t260 = ((t145 * (t88 * t256)) / t172) / tracking_index
    t263 = (t174 / tracking_index) + (t236 + (t260 * 0.5))
    t264 = -t263
    t266 = -(t236 + t260)
    t267 = -t260
    return (t264, t266, t267)


def _predictor_gain_second_derivatives_block(
    given: Arrays,
    out: Arrays,
    work: Arrays,
    single: bool,
    n0: float = 2.220446049250313e-16,
    n1: float = 4.625929269271486e-19,
    n2: float = 67108864.0,
    n3: float = 2.0,
    n4: float = 0.5,
    n5: float = 0.07083333333333333,
    n6: float = 1.5516447222296765,
    n7: float = 8.0,
    n8: float = 0.25,
    n9: float = 1.0,
    n10: float = 1.1333333333333333,
    n11: float = 4.0,
    n12: float = 3.0,
    n13: float = 0.004166666666666667,
    n14: float = 0.7544444444444445,
    n15: float = 1.6,
    n16: float = 2.1,
    n17: float = 0.75,
    n18: float = 0.0020833333333333333,
    n19: float = 0.125,
    n20: float = 2.908888888888889,
    n21: float = 10.2,
    n22: float = 12.8,
    n23: float = 7.0,
    n24: float = 1.5,
    n25: float = 2.8666666666666667,
    n26: float = 6.0,
) -> None:
    (tracking_index,) = given
    position, velocity, acceleration = out
    (
        w0,
        w1,
        w2,
        w3,
        w4,
        w5,
        w6,
        w7,
        w8,
        w9,
        w10,
        w11,
        w12,
        w13,
        w14,
        w15,
        w16,
        w17,
        w18,
        w19,
        w20,
    ) = work
    p = sqrt(tracking_index, position)
    r = sqrt(p, velocity)
    t6 = divide(n0, tracking_index, acceleration)
    t8 = multiply(tracking_index, n1, w0)
    t9 = add(t6, t8, acceleration)
    c_scaled = sqrt(t9, acceleration)
    t12 = multiply(c_scaled, n2, acceleration)
    t13 = multiply(t12, r, w0)
    t14 = multiply(t13, n3, w0)
    t16 = multiply(p, n4, w1)
    t18 = multiply(tracking_index, n5, w2)
    t19 = multiply(p, r, w3)
    t22 = multiply(t19, n6, w3)
    t24 = divide(n7, r, w4)
    t25 = add(t22, t24, w3)
    t26 = near_cbrt(t25, w3, single)
    t28 = multiply(t14, t26, w4)
    t29 = add(t28, t18, w4)
    t30 = sqrt(t29, w4)
    t31 = multiply(t30, n3, w5)
    t32 = add(t31, t16, w5)
    t33 = sqrt(t32, w5)
    t34 = multiply(t14, n4, w6)
    t35 = multiply(t30, t33, w4)
    t36 = multiply(t33, t35, w5)
    t37 = multiply(t34, t26, w3)
    t38 = subtract(t36, t37, w5)
    t39 = subtract(t35, t34, w4)
    t40 = divide(t38, t39, w5)
    t42 = multiply(t14, t40, w3)
    t43 = add(t42, t18, w3)
    t44 = sqrt(t43, w3)
    t45 = multiply(t44, n3, w4)
    t46 = add(t45, t16, w4)
    t47 = sqrt(t46, w4)
    t48 = multiply(t44, t47, w3)
    t49 = multiply(t47, t48, w4)
    t50 = multiply(t34, t40, w5)
    t51 = subtract(t49, t50, w4)
    t52 = subtract(t48, t34, w3)
    t53 = divide(t51, t52, w4)
    t55 = multiply(t14, t53, w3)
    t56 = add(t55, t18, w3)
    t57 = sqrt(t56, w3)
    t58 = multiply(t57, n3, w5)
    t59 = add(t58, t16, w5)
    t60 = sqrt(t59, w5)
    t61 = multiply(t57, t60, w3)
    t62 = multiply(t60, t61, w5)
    t63 = multiply(t34, t53, w4)
    t64 = subtract(t62, t63, w5)
    t65 = subtract(t61, t34, w3)
    t66 = divide(t64, t65, w5)
    t68 = multiply(t14, t66, w3)
    t69 = add(t68, t18, w3)
    t70 = sqrt(t69, w3)
    t71 = multiply(t70, n3, w4)
    t72 = add(t71, t16, w4)
    t73 = sqrt(t72, w4)
    t74 = multiply(t70, t73, w3)
    t75 = multiply(t73, t74, w4)
    t76 = multiply(t34, t66, w5)
    t77 = subtract(t75, t76, w4)
    t78 = subtract(t74, t34, w3)
    t79 = divide(t77, t78, w4)
    t81 = multiply(t14, t79, w0)
    t82 = add(t81, t18, w0)
    e = sqrt(t82, w0)
    t84 = multiply(e, n3, w2)
    t85 = add(t84, t16, w2)
    x = sqrt(t85, w2)
    t87 = divide(x, r, w1)
    t88 = multiply(t87, n3, w3)
    t90 = multiply(p, n8, w4)
    t91 = divide(t90, e, w4)
    t92 = add(t91, n9, w5)
    t93 = multiply(t92, t91, w6)
    t95 = multiply(t91, n10, w7)
    t97 = add(t95, n11, w8)
    t98 = multiply(t91, t97, w8)
    t100 = add(t98, n12, w8)
    t101 = divide(t93, t100, w6)
    t102 = multiply(t101, n3, w6)
    t103 = divide(p, e, w9)
    t104 = divide(t103, t100, w10)
    t105 = multiply(t104, t103, w10)
    t106 = divide(p, t12, w9)
    t107 = multiply(t87, t106, w1)
    t108 = multiply(t105, t107, w10)
    t110 = multiply(t108, n13, w10)
    t111 = add(t102, t110, w6)
    t112 = multiply(t111, t88, w1)
    t113 = multiply(t111, t112, w9)
    t114 = multiply(t113, n3, w9)
    t115 = divide(t91, t100, w11)
    t116 = multiply(t91, n3, w12)
    t117 = add(t116, n3, w12)
    t118 = divide(t117, t100, w13)
    t119 = multiply(t115, t118, w11)
    t120 = divide(t119, t100, w11)
    t122 = multiply(t91, n14, w13)
    t124 = add(t122, n15, w13)
    t125 = multiply(t91, t124, w13)
    t127 = add(t125, n16, w13)
    t128 = multiply(t91, t127, w13)
    t129 = add(t128, n3, w13)
    t130 = multiply(t91, t129, w13)
    t132 = add(t130, n17, w13)
    t133 = multiply(t132, n7, w13)
    t134 = multiply(t120, t133, w11)
    t135 = divide(tracking_index, t12, w13)
    t136 = divide(t135, t12, w13)
    t138 = multiply(t136, n18, w13)
    t139 = divide(x, e, w14)
    t140 = multiply(e, t100, w15)
    t141 = divide(t139, t140, w14)
    t142 = divide(t141, r, w14)
    t143 = divide(t142, t12, w14)
    t144 = divide(t143, p, w14)
    t145 = multiply(t144, n3, w14)
    t146 = add(t138, t145, w15)
    t147 = multiply(t117, t91, w16)
    t148 = divide(t147, t100, w16)
    t149 = square(t148, w17)
    t150 = multiply(t149, n11, w17)
    t151 = add(t146, t150, w15)
    t152 = add(t145, t110, w17)
    t153 = square(t117, w18)
    t154 = divide(t153, t100, w18)
    t155 = multiply(t154, n3, w18)
    t156 = add(t152, t155, w18)
    t157 = multiply(t110, t156, w18)
    t158 = add(t151, t157, w15)
    t159 = multiply(t110, t158, w15)
    t160 = add(t134, t159, w11)
    t161 = add(t114, t160, w9)
    t162 = multiply(t88, t161, w9)
    t163 = multiply(t162, n3, w9)
    t164 = divide(t163, tracking_index, w9)
    t165 = multiply(e, n4, w11)
    t166 = add(t12, t165, w11)
    t167 = multiply(x, r, w2)
    t168 = multiply(t167, n8, w15)
    t169 = multiply(p, n19, velocity)
    t170 = add(t168, t169, w15)
    t171 = add(t166, t170, w11)
    t172 = multiply(p, t171, w15)
    t173 = divide(t164, t172, w9)
    t174 = divide(t173, t172, w9)
    t175 = divide(t174, tracking_index, w9)
    t176 = divide(t167, t171, w2)
    t177 = divide(t176, tracking_index, velocity)
    t178 = multiply(t177, n4, velocity)
    t179 = divide(e, t171, w11)
    t180 = multiply(t145, t179, w11)
    t181 = multiply(t112, t92, w1)
    t182 = multiply(t181, n3, w1)
    t183 = divide(t92, t100, w19)
    t185 = multiply(t91, n20, w20)
    t187 = add(t185, n21, w20)
    t188 = multiply(t91, t187, w20)
    t190 = add(t188, n22, w20)
    t191 = multiply(t91, t190, w20)
    t193 = add(t191, n23, w20)
    t194 = multiply(t91, t193, w20)
    t196 = add(t194, n24, w20)
    t197 = divide(t196, t100, w20)
    t198 = multiply(t183, t197, w19)
    t199 = multiply(t198, n11, w19)
    t200 = add(t182, t199, w1)
    t201 = divide(t12, e, acceleration)
    t202 = multiply(t201, n3, acceleration)
    t204 = multiply(t91, n25, w19)
    t206 = add(t204, n26, w19)
    t207 = multiply(t91, t206, w19)
    t208 = add(t207, n12, w19)
    t209 = divide(t208, t100, w19)
    t210 = multiply(t209, n3, w19)
    t211 = multiply(t202, t210, acceleration)
    t212 = add(t117, t211, acceleration)
    t213 = multiply(t145, t212, acceleration)
    t214 = add(t200, t213, w1)
    t215 = add(t95, n3, w7)
    t216 = multiply(t91, t215, w7)
    t217 = add(t216, n9, w7)
    t218 = divide(t217, t100, w7)
    t219 = multiply(t218, n3, w7)
    t220 = multiply(t219, t100, w20)
    t221 = divide(e, p, w0)
    t222 = multiply(t221, n11, w0)
    t223 = multiply(t220, t222, position)
    t224 = multiply(t92, t210, w19)
    t225 = add(t223, t224, position)
    t226 = multiply(t110, t225, w10)
    t227 = add(t214, t226, w1)
    t228 = divide(t222, t88, w10)
    t229 = multiply(t220, n4, w20)
    t230 = multiply(t228, t229, w10)
    t231 = add(t230, t92, w10)
    t232 = multiply(t138, t231, w10)
    t233 = add(t227, t232, w1)
    t234 = multiply(t180, t233, w11)
    t235 = multiply(t178, t234, velocity)
    t236 = divide(t235, tracking_index, velocity)
    t237 = multiply(t176, n8, w2)
    t238 = multiply(t100, n4, w1)
    t239 = multiply(t222, t238, w0)
    t240 = divide(t239, t117, w0)
    t241 = add(t240, n9, w0)
    t242 = add(t241, t88, w0)
    t243 = multiply(t237, t242, w2)
    t244 = multiply(t111, t243, w6)
    t245 = multiply(t152, t91, w17)
    t246 = add(t92, t117, w5)
    t247 = multiply(t245, t246, w17)
    t248 = divide(t247, t100, w17)
    t249 = multiply(t248, n3, w17)
    t250 = multiply(t148, n3, w16)
    t251 = square(t250, w16)
    t252 = add(t249, t251, w17)
    t253 = add(t252, t157, w17)
    t254 = multiply(t138, t219, w13)
    t255 = add(t253, t254, w17)
    t256 = add(t244, t255, w6)
    t257 = multiply(t88, t256, w3)
    t258 = multiply(t145, t257, w14)
    t259 = divide(t258, t172, w14)
    t260 = divide(t259, tracking_index, w14)
    t261 = multiply(t260, n4, w0)
    t262 = add(t236, t261, w0)
    t263 = add(t175, t262, w9)
    t265 = add(t236, t260, velocity)
    negative(t263, position)
    negative(t265, velocity)
    negative(t260, acceleration)


_PREDICTOR_GAIN_SECOND_DERIVATIVES = Signature(
    "predictor_gain_second_derivatives",
    (_TRACKING_INDEX_DOMAIN,),
    ("position", "velocity", "acceleration"),
    21,
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

        delta = sqrt(64/Lambda^2 + 2/15),
        xi = sqrt(2 + 2 eta), eta = sqrt(17/15 + 2 delta xi), nu = 1 + xi + eta + delta

    tracking_index: Lambda, with Lambda^2 =
        jerk_density*sampling_interval**5/measurement_deviation**2; a number above 0 and at most
        2^1000, in float32 above 0 and at most 2^120.

    predicted_13: second derivative by Lambda of the covariance of predicted position and
        acceleration times T^2/sigma_v^2. Relative error at most 17.22 * 2^-52 (float64), 17.25 *
        2^-23 (float32), proved for 5e-324 <= tracking_index <= 1.0715086071862673e301 (float64) and
        1e-45 <= tracking_index <= 1.329228e36 (float32).
    predicted_22: second derivative by Lambda of the variance of the predicted velocity times
        T^2/sigma_v^2. Relative error at most 12.64 * 2^-52 (float64), 12.86 * 2^-23 (float32),
        proved for 5e-324 <= tracking_index <= 1.0715086071862673e301 (float64) and 1e-45 <=
        tracking_index <= 1.329228e36 (float32).
    predicted_23: second derivative by Lambda of the covariance of predicted velocity and
        acceleration times T^3/sigma_v^2. Relative error at most 10.17 * 2^-52 (float64), 10.17 *
        2^-23 (float32), proved for 5e-324 <= tracking_index <= 1.0715086071862673e301 (float64) and
        1e-45 <= tracking_index <= 1.329228e36 (float32).
    predicted_33: second derivative by Lambda of the variance of the predicted acceleration times
        T^4/sigma_v^2. Relative error at most 9.06 * 2^-52 (float64), 9.06 * 2^-23 (float32), proved
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

    Source: derivation continuous-white-jerk
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
    t3 = form.sqrt(tracking_index)
    t4 = form.sqrt(t3)
    t6 = 2.220446049250313e-16 / tracking_index
    t8 = tracking_index * 4.625929269271486e-19
    t12 = form.sqrt(t6 + t8) * 67108864.0
    t14 = (t12 * t4) * 2.0
    t16 = t3 * 0.5
    t18 = tracking_index * 0.07083333333333333
    t25 = ((t3 * t4) * 1.5516447222296765) + (8.0 / t4)
    t26 = form.near_cbrt(t25)
    t30 = form.sqrt((t14 * t26) + t18)
    t33 = form.sqrt((t30 * 2.0) + t16)
    t34 = t14 * 0.5
    t35 = t30 * t33
    t40 = ((t33 * t35) - (t34 * t26)) / (t35 - t34)
    t44 = form.sqrt((t14 * t40) + t18)
    t47 = form.sqrt((t44 * 2.0) + t16)
    t48 = t44 * t47
    t53 = ((t47 * t48) - (t34 * t40)) / (t48 - t34)
    t57 = form.sqrt((t14 * t53) + t18)
    t60 = form.sqrt((t57 * 2.0) + t16)
    t61 = t57 * t60
    t66 = ((t60 * t61) - (t34 * t53)) / (t61 - t34)
    t70 = form.sqrt((t14 * t66) + t18)
    t73 = form.sqrt((t70 * 2.0) + t16)
    t74 = t70 * t73
    t79 = ((t73 * t74) - (t34 * t66)) / (t74 - t34)
    t83 = form.sqrt((t14 * t79) + t18)
    t86 = form.sqrt((t83 * 2.0) + t16)
    t89 = (t3 * 0.25) / t83
    t90 = t89 + 1.0
    t93 = t89 * 1.1333333333333333
    t98 = (t89 * (t93 + 4.0)) + 3.0
    t101 = t3 / t83
    t104 = t86 / t4
    t107 = ((t101 / t98) * t101) * (t104 * (t3 / t12))
    t109 = t107 * 0.004166666666666667
    t111 = t104 * 2.0
    t112 = ((((t90 * t89) / t98) * 2.0) + t109) * t111
    t119 = (((t86 / t83) / (t83 * t98)) / t4) / t12
    t121 = (t119 / t3) * 2.0
    t122 = t121 + t109
    t125 = (t89 * 2.0) + 2.0
    t129 = (((t122 * t89) * (t90 + t125)) / t98) * 2.0
    t131 = (t125 * t89) / t98
    t132 = t131 * 2.0
    t138 = t122 + (((t125 * t125) / t98) * 2.0)
    t139 = t109 * t138
    t144 = ((tracking_index / t12) / t12) * 0.0020833333333333333
    t149 = (((t89 * (t93 + 2.0)) + 1.0) / t98) * 2.0
    t151 = ((t129 + (t132 * t132)) + t139) + (t144 * t149)
    t154 = (t112 * (t112 + 1.0)) + ((t121 * t151) * t111)
    t161 = (t12 + (t83 * 0.5)) + (((t86 * t4) * 0.25) + (t3 * 0.125))
    t166 = t83 / t3
    t174 = t89 * ((t89 * 6.8) + 15.866666666666667)
    t178 = (t89 * (t174 + 11.066666666666666)) + 2.0
    t181 = t149 + t109
    t183 = ((t89 / t98) * (t178 / t98)) * (t181 * 4.0)
    t187 = (t89 * 4.533333333333333) + 9.066666666666666
    t193 = ((((t89 * t187) + 4.0) * t89) / t98) * (t125 / t98)
    t196 = t121 * ((t193 + t144) + t139)
    t204 = t181 * ((t131 * 12.0) + (t122 * 6.0))
    t210 = ((t89 * ((t89 * 3.4) + 4.0)) + 1.0) / t98
    t212 = t210 + (t109 * 2.0)
    t216 = t109 * ((t204 + (t212 * 4.0)) + t121)
    t218 = (t166 * (t98 * 4.0)) * ((t183 + (t196 * t138)) + t216)
    t224 = t111 * ((t181 * (t181 + 1.0)) + t196)
    t226 = (((t83 / t86) * (t218 / t4)) + t224) * 0.125
    t231 = (t89 * 12.844444444444445) + 42.61333333333334
    t235 = t89 * ((t89 * t231) + 49.86666666666667)
    t240 = (t89 * (t235 + 26.133333333333333)) + 10.0
    t246 = ((((t89 * t240) + 4.0) / t98) / t98) + (t196 * t125)
    t249 = (t89 * 2.2666666666666666) + 4.533333333333333
    t254 = ((t89 * ((t89 * t249) + 6.0)) + 4.0) / t98
    t259 = ((t254 * 2.0) + (t125 * t212)) + (t89 * 4.0)
    t262 = (t166 * 4.0) * (t246 + (t109 * t259))
    t164 = (t154 * (t3 * t161)) / tracking_index
    t265 = t226 + ((t262 * 0.25) + 0.5)
    t269 = ((t262 + t224) * 0.25) + 0.6666666666666666
    t271 = (t224 * 0.5) + 1.0
    return (t164, t265, t269, t271)


def _predicted_covariance_second_derivatives_block(
    given: Arrays,
    out: Arrays,
    work: Arrays,
    single: bool,
    n0: float = 2.220446049250313e-16,
    n1: float = 4.625929269271486e-19,
    n2: float = 67108864.0,
    n3: float = 2.0,
    n4: float = 0.5,
    n5: float = 0.07083333333333333,
    n6: float = 1.5516447222296765,
    n7: float = 8.0,
    n8: float = 0.25,
    n9: float = 1.0,
    n10: float = 1.1333333333333333,
    n11: float = 4.0,
    n12: float = 3.0,
    n13: float = 0.004166666666666667,
    n14: float = 0.0020833333333333333,
    n15: float = 0.125,
    n16: float = 6.8,
    n17: float = 15.866666666666667,
    n18: float = 11.066666666666666,
    n19: float = 4.533333333333333,
    n20: float = 9.066666666666666,
    n21: float = 12.0,
    n22: float = 6.0,
    n23: float = 3.4,
    n24: float = 12.844444444444445,
    n25: float = 42.61333333333334,
    n26: float = 49.86666666666667,
    n27: float = 26.133333333333333,
    n28: float = 10.0,
    n29: float = 2.2666666666666666,
    n30: float = 0.6666666666666666,
) -> None:
    (tracking_index,) = given
    predicted_13, predicted_22, predicted_23, predicted_33 = out
    w0, w1, w2, w3, w4, w5, w6, w7, w8, w9, w10, w11, w12, w13, w14, w15 = work
    p = sqrt(tracking_index, predicted_13)
    r = sqrt(p, predicted_22)
    t6 = divide(n0, tracking_index, predicted_23)
    t8 = multiply(tracking_index, n1, w0)
    t9 = add(t6, t8, predicted_23)
    c_scaled = sqrt(t9, predicted_33)
    t12 = multiply(c_scaled, n2, predicted_33)
    t13 = multiply(t12, r, w0)
    t14 = multiply(t13, n3, w0)
    t16 = multiply(p, n4, predicted_23)
    t18 = multiply(tracking_index, n5, w1)
    t19 = multiply(p, r, w2)
    t22 = multiply(t19, n6, w2)
    t24 = divide(n7, r, w3)
    t25 = add(t22, t24, w2)
    t26 = near_cbrt(t25, w2, single)
    t28 = multiply(t14, t26, w3)
    t29 = add(t28, t18, w3)
    t30 = sqrt(t29, w3)
    t31 = multiply(t30, n3, w4)
    t32 = add(t31, t16, w4)
    t33 = sqrt(t32, w4)
    t34 = multiply(t14, n4, w5)
    t35 = multiply(t30, t33, w3)
    t36 = multiply(t33, t35, w4)
    t37 = multiply(t34, t26, w2)
    t38 = subtract(t36, t37, w4)
    t39 = subtract(t35, t34, w3)
    t40 = divide(t38, t39, w4)
    t42 = multiply(t14, t40, w2)
    t43 = add(t42, t18, w2)
    t44 = sqrt(t43, w2)
    t45 = multiply(t44, n3, w3)
    t46 = add(t45, t16, w3)
    t47 = sqrt(t46, w3)
    t48 = multiply(t44, t47, w2)
    t49 = multiply(t47, t48, w3)
    t50 = multiply(t34, t40, w4)
    t51 = subtract(t49, t50, w3)
    t52 = subtract(t48, t34, w2)
    t53 = divide(t51, t52, w3)
    t55 = multiply(t14, t53, w2)
    t56 = add(t55, t18, w2)
    t57 = sqrt(t56, w2)
    t58 = multiply(t57, n3, w4)
    t59 = add(t58, t16, w4)
    t60 = sqrt(t59, w4)
    t61 = multiply(t57, t60, w2)
    t62 = multiply(t60, t61, w4)
    t63 = multiply(t34, t53, w3)
    t64 = subtract(t62, t63, w4)
    t65 = subtract(t61, t34, w2)
    t66 = divide(t64, t65, w4)
    t68 = multiply(t14, t66, w2)
    t69 = add(t68, t18, w2)
    t70 = sqrt(t69, w2)
    t71 = multiply(t70, n3, w3)
    t72 = add(t71, t16, w3)
    t73 = sqrt(t72, w3)
    t74 = multiply(t70, t73, w2)
    t75 = multiply(t73, t74, w3)
    t76 = multiply(t34, t66, w4)
    t77 = subtract(t75, t76, w3)
    t78 = subtract(t74, t34, w2)
    t79 = divide(t77, t78, w3)
    t81 = multiply(t14, t79, w0)
    t82 = add(t81, t18, w0)
    e = sqrt(t82, w0)
    t84 = multiply(e, n3, w1)
    t85 = add(t84, t16, w1)
    x = sqrt(t85, w1)
    t88 = multiply(p, n8, w2)
    t89 = divide(t88, e, w2)
    t90 = add(t89, n9, w3)
    t91 = multiply(t90, t89, w4)
    t93 = multiply(t89, n10, w5)
    t95 = add(t93, n11, predicted_23)
    t96 = multiply(t89, t95, predicted_23)
    t98 = add(t96, n12, predicted_23)
    t99 = divide(t91, t98, w4)
    t100 = multiply(t99, n3, w4)
    t101 = divide(p, e, w6)
    t102 = divide(t101, t98, w7)
    t103 = multiply(t102, t101, w7)
    t104 = divide(x, r, w6)
    t105 = divide(p, t12, w8)
    t106 = multiply(t104, t105, w8)
    t107 = multiply(t103, t106, w7)
    t109 = multiply(t107, n13, w7)
    t110 = add(t100, t109, w4)
    t111 = multiply(t104, n3, w6)
    t112 = multiply(t110, t111, w4)
    t113 = add(t112, n9, w8)
    t114 = multiply(t112, t113, w4)
    t115 = divide(x, e, w8)
    t116 = multiply(e, t98, w9)
    t117 = divide(t115, t116, w8)
    t118 = divide(t117, r, w8)
    t119 = divide(t118, t12, w8)
    t120 = divide(t119, p, w8)
    t121 = multiply(t120, n3, w8)
    t122 = add(t121, t109, w9)
    t123 = multiply(t122, t89, w10)
    t124 = multiply(t89, n3, w11)
    t125 = add(t124, n3, w11)
    t126 = add(t90, t125, w3)
    t127 = multiply(t123, t126, w10)
    t128 = divide(t127, t98, w10)
    t129 = multiply(t128, n3, w10)
    t130 = multiply(t125, t89, w3)
    t131 = divide(t130, t98, w3)
    t132 = multiply(t131, n3, w12)
    t133 = square(t132, w12)
    t134 = add(t129, t133, w10)
    t135 = square(t125, w12)
    t136 = divide(t135, t98, w12)
    t137 = multiply(t136, n3, w12)
    t138 = add(t122, t137, w12)
    t139 = multiply(t109, t138, w13)
    t140 = add(t134, t139, w10)
    t141 = divide(tracking_index, t12, w14)
    t142 = divide(t141, t12, w14)
    t144 = multiply(t142, n14, w14)
    t145 = add(t93, n3, w5)
    t146 = multiply(t89, t145, w5)
    t147 = add(t146, n9, w5)
    t148 = divide(t147, t98, w5)
    t149 = multiply(t148, n3, w5)
    t150 = multiply(t144, t149, w15)
    t151 = add(t140, t150, w10)
    t152 = multiply(t121, t151, w10)
    t153 = multiply(t152, t111, w10)
    t154 = add(t114, t153, w4)
    t155 = multiply(e, n4, w10)
    t156 = add(t12, t155, predicted_33)
    t157 = multiply(x, r, w10)
    t158 = multiply(t157, n8, w10)
    t159 = multiply(p, n15, w15)
    t160 = add(t158, t159, w10)
    t161 = add(t156, t160, predicted_33)
    t162 = multiply(p, t161, predicted_33)
    t163 = multiply(t154, t162, w4)
    t165 = divide(e, x, w1)
    t166 = divide(e, p, w0)
    t167 = multiply(t98, n11, w10)
    t168 = multiply(t166, t167, w10)
    t169 = divide(t89, t98, w15)
    t171 = multiply(t89, n16, predicted_13)
    t173 = add(t171, n17, predicted_13)
    t174 = multiply(t89, t173, predicted_13)
    t176 = add(t174, n18, predicted_13)
    t177 = multiply(t89, t176, predicted_13)
    t178 = add(t177, n3, predicted_13)
    t179 = divide(t178, t98, predicted_13)
    t180 = multiply(t169, t179, w15)
    t181 = add(t149, t109, w5)
    t182 = multiply(t181, n11, predicted_13)
    t183 = multiply(t180, t182, w15)
    t185 = multiply(t89, n19, predicted_13)
    t187 = add(t185, n20, predicted_13)
    t188 = multiply(t89, t187, predicted_13)
    t189 = add(t188, n11, predicted_13)
    t190 = multiply(t189, t89, predicted_13)
    t191 = divide(t190, t98, predicted_13)
    t192 = divide(t125, t98, predicted_33)
    t193 = multiply(t191, t192, predicted_13)
    t194 = add(t193, t144, predicted_13)
    t195 = add(t194, t139, predicted_13)
    t196 = multiply(t121, t195, predicted_13)
    t197 = multiply(t196, t138, w12)
    t198 = add(t183, t197, w15)
    t200 = multiply(t131, n21, w3)
    t202 = multiply(t122, n22, w9)
    t203 = add(t200, t202, w3)
    t204 = multiply(t181, t203, w3)
    t206 = multiply(t89, n23, w9)
    t207 = add(t206, n11, w9)
    t208 = multiply(t89, t207, w9)
    t209 = add(t208, n9, w9)
    t210 = divide(t209, t98, w9)
    t211 = multiply(t109, n3, w12)
    t212 = add(t210, t211, w9)
    t213 = multiply(t212, n11, w12)
    t214 = add(t204, t213, w3)
    t215 = add(t214, t121, w3)
    t216 = multiply(t109, t215, w3)
    t217 = add(t198, t216, w15)
    t218 = multiply(t168, t217, w10)
    t219 = divide(t218, r, w10)
    t220 = multiply(t165, t219, w1)
    t221 = add(t181, n9, w3)
    t222 = multiply(t181, t221, w5)
    t223 = add(t222, t196, w5)
    t224 = multiply(t111, t223, w6)
    t225 = add(t220, t224, w1)
    t226 = multiply(t225, n15, w1)
    t227 = multiply(t166, n11, w0)
    t229 = multiply(t89, n24, w3)
    t231 = add(t229, n25, w3)
    t232 = multiply(t89, t231, w3)
    t234 = add(t232, n26, w3)
    t235 = multiply(t89, t234, w3)
    t237 = add(t235, n27, w3)
    t238 = multiply(t89, t237, w3)
    t240 = add(t238, n28, w3)
    t241 = multiply(t89, t240, w3)
    t242 = add(t241, n11, w3)
    t243 = divide(t242, t98, w3)
    t244 = divide(t243, t98, w3)
    t245 = multiply(t196, t125, predicted_13)
    t246 = add(t244, t245, w3)
    t248 = multiply(t89, n29, w5)
    t249 = add(t248, n19, w5)
    t250 = multiply(t89, t249, w5)
    t251 = add(t250, n22, w5)
    t252 = multiply(t89, t251, w5)
    t253 = add(t252, n11, w5)
    t254 = divide(t253, t98, w5)
    t255 = multiply(t254, n3, w5)
    t256 = multiply(t125, t212, w11)
    t257 = add(t255, t256, w5)
    t258 = multiply(t89, n11, w2)
    t259 = add(t257, t258, w5)
    t260 = multiply(t109, t259, w7)
    t261 = add(t246, t260, w3)
    t262 = multiply(t227, t261, w0)
    t263 = multiply(t262, n8, w2)
    t264 = add(t263, n4, w2)
    t266 = add(t262, t224, w0)
    t267 = multiply(t266, n8, w0)
    t270 = multiply(t224, n4, w6)
    divide(t163, tracking_index, predicted_13)
    add(t226, t264, predicted_22)
    add(t267, n30, predicted_23)
    add(t270, n9, predicted_33)


_PREDICTED_COVARIANCE_SECOND_DERIVATIVES = Signature(
    "predicted_covariance_second_derivatives",
    (_TRACKING_INDEX_DOMAIN_2,),
    ("predicted_13", "predicted_22", "predicted_23", "predicted_33"),
    16,
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

        delta = sqrt(64/Lambda^2 + 2/15),
        xi = sqrt(2 + 2 eta), eta = sqrt(17/15 + 2 delta xi), nu = 1 + xi + eta + delta

    tracking_index: Lambda, with Lambda^2 =
        jerk_density*sampling_interval**5/measurement_deviation**2; a number at least 2^-750 and at
        most 2^1000, in float32 at least 2^-80 and at most 2^120.

    predicted_11: second derivative by Lambda of the variance of the predicted position over
        sigma_v^2. Error over the sum of its terms' sizes at most 64.84 * 2^-52 (float64), 68.57 *
        2^-23 (float32), proved for 6.852691063641298e-186 <= tracking_index <=
        1.0715086071862673e301 (float64) and 4.6732775e-24 <= tracking_index <= 1.329228e36
        (float32). Cancellation, condition number 1: it bends down for a small index and up for a
        large one, so that it vanishes between. Digits that can be lost: up to 16 of 16 in float64,
        half or more only where 0.82 <= tracking_index <= 1.2; up to 7 of 7 in float32, half or more
        only where 0.72 <= tracking_index <= 1.5.
    predicted_12: second derivative by Lambda of the covariance of predicted position and velocity
        times T/sigma_v^2. Error over the sum of its terms' sizes at most 66.86 * 2^-52 (float64),
        71.17 * 2^-23 (float32), proved for 1.688508503057271e-226 <= tracking_index <=
        1.0715086071862673e301 (float64) and 8.271806e-25 <= tracking_index <= 1.329228e36
        (float32). Cancellation, condition number 1: it bends down for a small index and up for a
        large one, so that it vanishes between. Digits that can be lost: up to 16 of 16 in float64,
        half or more only where 0.269299 <= tracking_index <= 0.269398; up to 7 of 7 in float32,
        half or more only where 0.19 <= tracking_index <= 0.37.

    Outside an output's range, a few numbers next to its ends apart, its true value is no normal
    number: it comes as 0, a subnormal number or infinity, never as NaN. Numbers and arrays are
    taken, arrays of any shape; inputs are broadcast. float64 and float32 stay what they are,
    integers become float64. `out`: a tuple of arrays to fill. `workers`: threads that share the
    work on long arrays.

    ValueError: an input outside its domain, with its place; `out` or `workers` that does not fit.
    TypeError: an input that is no real number of these types; in `out` what is no array of the
    results' type.

    Source: derivation continuous-white-jerk
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
    t3 = form.sqrt(tracking_index)
    t4 = form.sqrt(t3)
    t6 = 2.220446049250313e-16 / tracking_index
    t8 = tracking_index * 4.625929269271486e-19
    t12 = form.sqrt(t6 + t8) * 67108864.0
    t14 = (t12 * t4) * 2.0
    t16 = t3 * 0.5
    t18 = tracking_index * 0.07083333333333333
    t25 = ((t3 * t4) * 1.5516447222296765) + (8.0 / t4)
    t26 = form.near_cbrt(t25)
    t30 = form.sqrt((t14 * t26) + t18)
    t33 = form.sqrt((t30 * 2.0) + t16)
    t34 = t14 * 0.5
    t35 = t30 * t33
    t40 = ((t33 * t35) - (t34 * t26)) / (t35 - t34)
    t44 = form.sqrt((t14 * t40) + t18)
    t47 = form.sqrt((t44 * 2.0) + t16)
    t48 = t44 * t47
    t53 = ((t47 * t48) - (t34 * t40)) / (t48 - t34)
    t57 = form.sqrt((t14 * t53) + t18)
    t60 = form.sqrt((t57 * 2.0) + t16)
    t61 = t57 * t60
    t66 = ((t60 * t61) - (t34 * t53)) / (t61 - t34)
    t70 = form.sqrt((t14 * t66) + t18)
    t73 = form.sqrt((t70 * 2.0) + t16)
    t74 = t70 * t73
    t79 = ((t73 * t74) - (t34 * t66)) / (t74 - t34)
    t83 = form.sqrt((t14 * t79) + t18)
    t86 = form.sqrt((t83 * 2.0) + t16)
    t89 = (t3 * 0.25) / t83
    t90 = t89 + 1.0
    t93 = t89 * 1.1333333333333333
    t98 = (t89 * (t93 + 4.0)) + 3.0
    t101 = t3 / t83
    t104 = t86 / t4
    t107 = ((t101 / t98) * t101) * (t104 * (t3 / t12))
    t109 = t107 * 0.004166666666666667
    t111 = t104 * 2.0
    t112 = ((((t90 * t89) / t98) * 2.0) + t109) * t111
    t120 = (t12 + (t83 * 0.5)) + (((t86 * t4) * 0.25) + (t3 * 0.125))
    t122 = (t3 * t120) / tracking_index
    t125 = ((t112 * t112) * t122) * (t122 * 4.0)
    t128 = (t89 * 2.0) + 2.0
    t129 = t128 / t98
    t136 = t89 * ((t89 * 0.7544444444444445) + 1.6)
    t143 = (t89 * ((t89 * (t136 + 2.1)) + 2.0)) + 0.75
    t145 = (((t89 / t98) * t129) / t98) * (t143 * 8.0)
    t149 = ((tracking_index / t12) / t12) * 0.0020833333333333333
    t154 = (((t86 / t83) / (t83 * t98)) / t4) / t12
    t156 = (t154 / t3) * 2.0
    t159 = (t128 * t89) / t98
    t162 = (t149 + t156) + ((t159 * t159) * 4.0)
    t163 = t156 + t109
    t168 = t109 * (t163 + (((t128 * t128) / t98) * 2.0))
    t172 = (t145 + (t109 * (t162 + t168))) * t111
    t178 = t104 * t122
    t183 = (((t89 * (t93 + 2.0)) + 1.0) / t98) * 2.0
    t185 = (t183 + t109) + t112
    t191 = (((t163 * t89) * (t90 + t128)) / t98) * 2.0
    t192 = t159 * 2.0
    t197 = ((t191 + (t192 * t192)) + t168) + (t149 * t183)
    t200 = (t185 * t112) + ((t156 * t197) * t111)
    t204 = (t89 * 4.533333333333333) + 9.066666666666666
    t209 = ((((t89 * t204) + 4.0) * t89) / t98) * t129
    t213 = t200 + (t156 * ((t209 + t149) + t168))
    t176 = t125 - ((t172 * t122) * (t122 * 2.0))
    t217 = (t178 * t213) - (t178 * (t185 * t156))
    return (t176, t217)


def _predicted_position_second_derivatives_block(
    given: Arrays,
    out: Arrays,
    work: Arrays,
    single: bool,
    n0: float = 2.220446049250313e-16,
    n1: float = 4.625929269271486e-19,
    n2: float = 67108864.0,
    n3: float = 2.0,
    n4: float = 0.5,
    n5: float = 0.07083333333333333,
    n6: float = 1.5516447222296765,
    n7: float = 8.0,
    n8: float = 0.25,
    n9: float = 1.0,
    n10: float = 1.1333333333333333,
    n11: float = 4.0,
    n12: float = 3.0,
    n13: float = 0.004166666666666667,
    n14: float = 0.125,
    n15: float = 0.7544444444444445,
    n16: float = 1.6,
    n17: float = 2.1,
    n18: float = 0.75,
    n19: float = 0.0020833333333333333,
    n20: float = 4.533333333333333,
    n21: float = 9.066666666666666,
) -> None:
    (tracking_index,) = given
    predicted_11, predicted_12 = out
    w0, w1, w2, w3, w4, w5, w6, w7, w8, w9, w10, w11, w12, w13, w14, w15, w16 = work
    p = sqrt(tracking_index, predicted_11)
    r = sqrt(p, predicted_12)
    t6 = divide(n0, tracking_index, w0)
    t8 = multiply(tracking_index, n1, w1)
    t9 = add(t6, t8, w0)
    c_scaled = sqrt(t9, w0)
    t12 = multiply(c_scaled, n2, w0)
    t13 = multiply(t12, r, w1)
    t14 = multiply(t13, n3, w1)
    t16 = multiply(p, n4, w2)
    t18 = multiply(tracking_index, n5, w3)
    t19 = multiply(p, r, w4)
    t22 = multiply(t19, n6, w4)
    t24 = divide(n7, r, w5)
    t25 = add(t22, t24, w4)
    t26 = near_cbrt(t25, w4, single)
    t28 = multiply(t14, t26, w5)
    t29 = add(t28, t18, w5)
    t30 = sqrt(t29, w5)
    t31 = multiply(t30, n3, w6)
    t32 = add(t31, t16, w6)
    t33 = sqrt(t32, w6)
    t34 = multiply(t14, n4, w7)
    t35 = multiply(t30, t33, w5)
    t36 = multiply(t33, t35, w6)
    t37 = multiply(t34, t26, w4)
    t38 = subtract(t36, t37, w6)
    t39 = subtract(t35, t34, w5)
    t40 = divide(t38, t39, w6)
    t42 = multiply(t14, t40, w4)
    t43 = add(t42, t18, w4)
    t44 = sqrt(t43, w4)
    t45 = multiply(t44, n3, w5)
    t46 = add(t45, t16, w5)
    t47 = sqrt(t46, w5)
    t48 = multiply(t44, t47, w4)
    t49 = multiply(t47, t48, w5)
    t50 = multiply(t34, t40, w6)
    t51 = subtract(t49, t50, w5)
    t52 = subtract(t48, t34, w4)
    t53 = divide(t51, t52, w5)
    t55 = multiply(t14, t53, w4)
    t56 = add(t55, t18, w4)
    t57 = sqrt(t56, w4)
    t58 = multiply(t57, n3, w6)
    t59 = add(t58, t16, w6)
    t60 = sqrt(t59, w6)
    t61 = multiply(t57, t60, w4)
    t62 = multiply(t60, t61, w6)
    t63 = multiply(t34, t53, w5)
    t64 = subtract(t62, t63, w6)
    t65 = subtract(t61, t34, w4)
    t66 = divide(t64, t65, w6)
    t68 = multiply(t14, t66, w4)
    t69 = add(t68, t18, w4)
    t70 = sqrt(t69, w4)
    t71 = multiply(t70, n3, w5)
    t72 = add(t71, t16, w5)
    t73 = sqrt(t72, w5)
    t74 = multiply(t70, t73, w4)
    t75 = multiply(t73, t74, w5)
    t76 = multiply(t34, t66, w6)
    t77 = subtract(t75, t76, w5)
    t78 = subtract(t74, t34, w4)
    t79 = divide(t77, t78, w5)
    t81 = multiply(t14, t79, w1)
    t82 = add(t81, t18, w1)
    e = sqrt(t82, w1)
    t84 = multiply(e, n3, w3)
    t85 = add(t84, t16, w3)
    x = sqrt(t85, w3)
    t88 = multiply(p, n8, w2)
    t89 = divide(t88, e, w2)
    t90 = add(t89, n9, w4)
    t91 = multiply(t90, t89, w5)
    t93 = multiply(t89, n10, w6)
    t95 = add(t93, n11, w7)
    t96 = multiply(t89, t95, w7)
    t98 = add(t96, n12, w7)
    t99 = divide(t91, t98, w5)
    t100 = multiply(t99, n3, w5)
    t101 = divide(p, e, w8)
    t102 = divide(t101, t98, w9)
    t103 = multiply(t102, t101, w9)
    t104 = divide(x, r, w8)
    t105 = divide(p, t12, w10)
    t106 = multiply(t104, t105, w10)
    t107 = multiply(t103, t106, w9)
    t109 = multiply(t107, n13, w9)
    t110 = add(t100, t109, w5)
    t111 = multiply(t104, n3, w10)
    t112 = multiply(t110, t111, w5)
    t113 = square(t112, w11)
    t114 = multiply(e, n4, w12)
    t115 = add(t12, t114, w12)
    t116 = multiply(x, r, w13)
    t117 = multiply(t116, n8, w13)
    t118 = multiply(p, n14, w14)
    t119 = add(t117, t118, w13)
    t120 = add(t115, t119, w12)
    t121 = multiply(p, t120, w12)
    t122 = divide(t121, tracking_index, w12)
    t123 = multiply(t113, t122, w11)
    t124 = multiply(t122, n11, w13)
    t125 = multiply(t123, t124, w11)
    t126 = divide(t89, t98, w13)
    t127 = multiply(t89, n3, w14)
    t128 = add(t127, n3, w14)
    t129 = divide(t128, t98, w15)
    t130 = multiply(t126, t129, w13)
    t131 = divide(t130, t98, w13)
    t133 = multiply(t89, n15, w16)
    t135 = add(t133, n16, w16)
    t136 = multiply(t89, t135, w16)
    t138 = add(t136, n17, w16)
    t139 = multiply(t89, t138, w16)
    t140 = add(t139, n3, w16)
    t141 = multiply(t89, t140, w16)
    t143 = add(t141, n18, w16)
    t144 = multiply(t143, n7, w16)
    t145 = multiply(t131, t144, w13)
    t146 = divide(tracking_index, t12, w16)
    t147 = divide(t146, t12, w16)
    t149 = multiply(t147, n19, w16)
    t150 = divide(x, e, w3)
    t151 = multiply(e, t98, w1)
    t152 = divide(t150, t151, w3)
    t153 = divide(t152, r, w3)
    t154 = divide(t153, t12, w3)
    t155 = divide(t154, p, w3)
    t156 = multiply(t155, n3, w3)
    t157 = add(t149, t156, w0)
    t158 = multiply(t128, t89, w1)
    t159 = divide(t158, t98, w1)
    t160 = square(t159, predicted_11)
    t161 = multiply(t160, n11, predicted_11)
    t162 = add(t157, t161, w0)
    t163 = add(t156, t109, predicted_11)
    t164 = square(t128, predicted_12)
    t165 = divide(t164, t98, predicted_12)
    t166 = multiply(t165, n3, predicted_12)
    t167 = add(t163, t166, predicted_12)
    t168 = multiply(t109, t167, predicted_12)
    t169 = add(t162, t168, w0)
    t170 = multiply(t109, t169, w0)
    t171 = add(t145, t170, w13)
    t172 = multiply(t171, t111, w13)
    t173 = multiply(t172, t122, w13)
    t174 = multiply(t122, n3, w0)
    t175 = multiply(t173, t174, w13)
    t178 = multiply(t104, t122, w8)
    t179 = add(t93, n3, w6)
    t180 = multiply(t89, t179, w6)
    t181 = add(t180, n9, w6)
    t182 = divide(t181, t98, w6)
    t183 = multiply(t182, n3, w6)
    t184 = add(t183, t109, w9)
    t185 = add(t184, t112, w9)
    t186 = multiply(t185, t112, w5)
    t187 = multiply(t163, t89, predicted_11)
    t188 = add(t90, t128, w4)
    t189 = multiply(t187, t188, predicted_11)
    t190 = divide(t189, t98, predicted_11)
    t191 = multiply(t190, n3, predicted_11)
    t192 = multiply(t159, n3, w1)
    t193 = square(t192, w1)
    t194 = add(t191, t193, predicted_11)
    t195 = add(t194, t168, predicted_11)
    t196 = multiply(t149, t183, w6)
    t197 = add(t195, t196, predicted_11)
    t198 = multiply(t156, t197, predicted_11)
    t199 = multiply(t198, t111, predicted_11)
    t200 = add(t186, t199, w5)
    t202 = multiply(t89, n20, w0)
    t204 = add(t202, n21, w0)
    t205 = multiply(t89, t204, w0)
    t206 = add(t205, n11, w0)
    t207 = multiply(t206, t89, w0)
    t208 = divide(t207, t98, w0)
    t209 = multiply(t208, t129, w0)
    t210 = add(t209, t149, w0)
    t211 = add(t210, t168, w0)
    t212 = multiply(t156, t211, w0)
    t213 = add(t200, t212, w5)
    t214 = multiply(t178, t213, w5)
    t215 = multiply(t185, t156, w9)
    t216 = multiply(t178, t215, w8)
    subtract(t125, t175, predicted_11)
    subtract(t214, t216, predicted_12)


_PREDICTED_POSITION_SECOND_DERIVATIVES = Signature(
    "predicted_position_second_derivatives",
    (_TRACKING_INDEX_DOMAIN_3,),
    ("predicted_11", "predicted_12"),
    17,
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

        delta = sqrt(64/Lambda^2 + 2/15),
        xi = sqrt(2 + 2 eta), eta = sqrt(17/15 + 2 delta xi), nu = 1 + xi + eta + delta

    tracking_index: Lambda, with Lambda^2 =
        jerk_density*sampling_interval**5/measurement_deviation**2; a number above 0 and finite.

    updated_22: second derivative by Lambda of the variance of the updated velocity times
        T^2/sigma_v^2. Error over the sum of its terms' sizes at most 36.67 * 2^-52 (float64), 40.40
        * 2^-23 (float32), proved for 5e-324 <= tracking_index <= 1.7976931348623157e308 (float64)
        and 1e-45 <= tracking_index <= 3.4028235e38 (float32). Cancellation, condition number 1: it
        bends down for a small index and up for a large one, so that it vanishes between. Digits
        that can be lost: up to 16 of 16 in float64, half or more only where 3.2 <= tracking_index
        <= 3.9 or 5.5 <= tracking_index <= 5.8 or tracking_index >= 120000; up to 7 of 7 in float32,
        half or more only where tracking_index >= 1.
    updated_23: second derivative by Lambda of the covariance of updated velocity and acceleration
        times T^3/sigma_v^2. Error over the sum of its terms' sizes at most 27.19 * 2^-52 (float64),
        29.86 * 2^-23 (float32), proved for 5e-324 <= tracking_index <= 1.7976931348623157e308
        (float64) and 1e-45 <= tracking_index <= 3.4028235e38 (float32). Cancellation, condition
        number 1: what the update takes from M'' stays less than it. Digits that can be lost: up to
        4.1 of 16 in float64, a quarter or more only where tracking_index >= 3.5e8; up to 3.4 of 7
        in float32.
    updated_33: second derivative by Lambda of the variance of the updated acceleration times
        T^4/sigma_v^2. Error over the sum of its terms' sizes at most 16.01 * 2^-52 (float64), 17.50
        * 2^-23 (float32), proved for 5e-324 <= tracking_index <= 1.7976931348623157e308 (float64)
        and 1e-45 <= tracking_index <= 3.4028235e38 (float32). Cancellation, condition number 1:
        what the update takes from M'' stays less than it. Digits that can be lost: up to 3.7 of 16
        in float64; up to 2.9 of 7 in float32, a quarter or more only where tracking_index >=
        0.0029.

    Outside an output's range, a few numbers next to its ends apart, its true value is no normal
    number: it comes as 0, a subnormal number or infinity, never as NaN. Numbers and arrays are
    taken, arrays of any shape; inputs are broadcast. float64 and float32 stay what they are,
    integers become float64. `out`: a tuple of arrays to fill. `workers`: threads that share the
    work on long arrays.

    ValueError: an input outside its domain, with its place; `out` or `workers` that does not fit.
    TypeError: an input that is no real number of these types; in `out` what is no array of the
    results' type.

    Source: derivation continuous-white-jerk
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
    t3 = form.sqrt(tracking_index)
    t4 = form.sqrt(t3)
    t6 = 2.220446049250313e-16 / tracking_index
    t8 = tracking_index * 4.625929269271486e-19
    t12 = form.sqrt(t6 + t8) * 67108864.0
    t14 = (t12 * t4) * 2.0
    t16 = t3 * 0.5
    t18 = tracking_index * 0.07083333333333333
    t25 = ((t3 * t4) * 1.5516447222296765) + (8.0 / t4)
    t26 = form.near_cbrt(t25)
    t30 = form.sqrt((t14 * t26) + t18)
    t33 = form.sqrt((t30 * 2.0) + t16)
    t34 = t14 * 0.5
    t35 = t30 * t33
    t40 = ((t33 * t35) - (t34 * t26)) / (t35 - t34)
    t44 = form.sqrt((t14 * t40) + t18)
    t47 = form.sqrt((t44 * 2.0) + t16)
    t48 = t44 * t47
    t53 = ((t47 * t48) - (t34 * t40)) / (t48 - t34)
    t57 = form.sqrt((t14 * t53) + t18)
    t60 = form.sqrt((t57 * 2.0) + t16)
    t61 = t57 * t60
    t66 = ((t60 * t61) - (t34 * t53)) / (t61 - t34)
    t70 = form.sqrt((t14 * t66) + t18)
    t73 = form.sqrt((t70 * 2.0) + t16)
    t74 = t70 * t73
    t79 = ((t73 * t74) - (t34 * t66)) / (t74 - t34)
    t83 = form.sqrt((t14 * t79) + t18)
    t86 = form.sqrt((t83 * 2.0) + t16)
    t88 = t83 / t3
    t91 = (t3 * 0.25) / t83
    t93 = t91 * 1.1333333333333333
    t98 = (t91 * (t93 + 4.0)) + 3.0
    t106 = t91 * ((t91 * 6.8) + 15.866666666666667)
    t110 = (t91 * (t106 + 11.066666666666666)) + 2.0
    t117 = (((t91 * (t93 + 2.0)) + 1.0) / t98) * 2.0
    t118 = t3 / t83
    t121 = t86 / t4
    t124 = ((t118 / t98) * t118) * (t121 * (t3 / t12))
    t126 = t124 * 0.004166666666666667
    t127 = t117 + t126
    t129 = ((t91 / t98) * (t110 / t98)) * (t127 * 4.0)
    t134 = (((t86 / t83) / (t83 * t98)) / t4) / t12
    t136 = (t134 / t3) * 2.0
    t140 = (t91 * 4.533333333333333) + 9.066666666666666
    t146 = (t91 * 2.0) + 2.0
    t148 = ((((t91 * t140) + 4.0) * t91) / t98) * (t146 / t98)
    t152 = ((tracking_index / t12) / t12) * 0.0020833333333333333
    t154 = t136 + t126
    t158 = t154 + (((t146 * t146) / t98) * 2.0)
    t161 = t136 * ((t148 + t152) + (t126 * t158))
    t170 = (((t146 * t91) / t98) * 12.0) + (t154 * 6.0)
    t177 = ((t91 * ((t91 * 3.4) + 4.0)) + 1.0) / t98
    t179 = t177 + (t126 * 2.0)
    t182 = ((t127 * t170) + (t179 * 4.0)) + t136
    t184 = (t129 + (t161 * t158)) + (t126 * t182)
    t187 = (t83 / t86) * (((t88 * (t98 * 4.0)) * t184) / t4)
    t188 = t121 * 2.0
    t192 = t188 * ((t127 * (t127 + 1.0)) + t161)
    t199 = (t91 * 12.844444444444445) + 42.61333333333334
    t203 = t91 * ((t91 * t199) + 49.86666666666667)
    t208 = (t91 * (t203 + 26.133333333333333)) + 10.0
    t214 = ((((t91 * t208) + 4.0) / t98) / t98) + (t161 * t146)
    t217 = (t91 * 2.2666666666666666) + 4.533333333333333
    t222 = ((t91 * ((t91 * t217) + 6.0)) + 4.0) / t98
    t227 = ((t222 * 2.0) + (t146 * t179)) + (t91 * 4.0)
    t230 = (t88 * 4.0) * (t214 + (t126 * t227))
    t233 = ((t187 + t192) * 0.125) + ((t230 * 0.25) + 0.5)
    t241 = ((t230 + t192) * 0.25) + 0.6666666666666666
    t242 = t192 * 0.5
    t236 = t233 - ((t230 * 0.5) + 1.0)
    t243 = t241 - t242
    t250 = (t242 + 1.0) - (t188 * (((t4 / t86) * 0.5) * 2.0))
    return (t236, t243, t250)


def _updated_covariance_second_derivatives_block(
    given: Arrays,
    out: Arrays,
    work: Arrays,
    single: bool,
    n0: float = 2.220446049250313e-16,
    n1: float = 4.625929269271486e-19,
    n2: float = 67108864.0,
    n3: float = 2.0,
    n4: float = 0.5,
    n5: float = 0.07083333333333333,
    n6: float = 1.5516447222296765,
    n7: float = 8.0,
    n8: float = 0.25,
    n9: float = 1.1333333333333333,
    n10: float = 4.0,
    n11: float = 3.0,
    n12: float = 6.8,
    n13: float = 15.866666666666667,
    n14: float = 11.066666666666666,
    n15: float = 1.0,
    n16: float = 0.004166666666666667,
    n17: float = 4.533333333333333,
    n18: float = 9.066666666666666,
    n19: float = 0.0020833333333333333,
    n20: float = 12.0,
    n21: float = 6.0,
    n22: float = 3.4,
    n23: float = 0.125,
    n24: float = 12.844444444444445,
    n25: float = 42.61333333333334,
    n26: float = 49.86666666666667,
    n27: float = 26.133333333333333,
    n28: float = 10.0,
    n29: float = 2.2666666666666666,
    n30: float = 0.6666666666666666,
) -> None:
    (tracking_index,) = given
    updated_22, updated_23, updated_33 = out
    w0, w1, w2, w3, w4, w5, w6, w7, w8, w9, w10, w11, w12, w13 = work
    p = sqrt(tracking_index, updated_22)
    r = sqrt(p, updated_23)
    t6 = divide(n0, tracking_index, updated_33)
    t8 = multiply(tracking_index, n1, w0)
    t9 = add(t6, t8, updated_33)
    c_scaled = sqrt(t9, updated_33)
    t12 = multiply(c_scaled, n2, updated_33)
    t13 = multiply(t12, r, w0)
    t14 = multiply(t13, n3, w0)
    t16 = multiply(p, n4, w1)
    t18 = multiply(tracking_index, n5, w2)
    t19 = multiply(p, r, w3)
    t22 = multiply(t19, n6, w3)
    t24 = divide(n7, r, w4)
    t25 = add(t22, t24, w3)
    t26 = near_cbrt(t25, w3, single)
    t28 = multiply(t14, t26, w4)
    t29 = add(t28, t18, w4)
    t30 = sqrt(t29, w4)
    t31 = multiply(t30, n3, w5)
    t32 = add(t31, t16, w5)
    t33 = sqrt(t32, w5)
    t34 = multiply(t14, n4, w6)
    t35 = multiply(t30, t33, w4)
    t36 = multiply(t33, t35, w5)
    t37 = multiply(t34, t26, w3)
    t38 = subtract(t36, t37, w5)
    t39 = subtract(t35, t34, w4)
    t40 = divide(t38, t39, w5)
    t42 = multiply(t14, t40, w3)
    t43 = add(t42, t18, w3)
    t44 = sqrt(t43, w3)
    t45 = multiply(t44, n3, w4)
    t46 = add(t45, t16, w4)
    t47 = sqrt(t46, w4)
    t48 = multiply(t44, t47, w3)
    t49 = multiply(t47, t48, w4)
    t50 = multiply(t34, t40, w5)
    t51 = subtract(t49, t50, w4)
    t52 = subtract(t48, t34, w3)
    t53 = divide(t51, t52, w4)
    t55 = multiply(t14, t53, w3)
    t56 = add(t55, t18, w3)
    t57 = sqrt(t56, w3)
    t58 = multiply(t57, n3, w5)
    t59 = add(t58, t16, w5)
    t60 = sqrt(t59, w5)
    t61 = multiply(t57, t60, w3)
    t62 = multiply(t60, t61, w5)
    t63 = multiply(t34, t53, w4)
    t64 = subtract(t62, t63, w5)
    t65 = subtract(t61, t34, w3)
    t66 = divide(t64, t65, w5)
    t68 = multiply(t14, t66, w3)
    t69 = add(t68, t18, w3)
    t70 = sqrt(t69, w3)
    t71 = multiply(t70, n3, w4)
    t72 = add(t71, t16, w4)
    t73 = sqrt(t72, w4)
    t74 = multiply(t70, t73, w3)
    t75 = multiply(t73, t74, w4)
    t76 = multiply(t34, t66, w5)
    t77 = subtract(t75, t76, w4)
    t78 = subtract(t74, t34, w3)
    t79 = divide(t77, t78, w4)
    t81 = multiply(t14, t79, w0)
    t82 = add(t81, t18, w0)
    e = sqrt(t82, w0)
    t84 = multiply(e, n3, w2)
    t85 = add(t84, t16, w2)
    x = sqrt(t85, w2)
    t87 = divide(e, x, w1)
    t88 = divide(e, p, w3)
    t90 = multiply(p, n8, w4)
    t91 = divide(t90, e, w4)
    t93 = multiply(t91, n9, w5)
    t95 = add(t93, n10, w6)
    t96 = multiply(t91, t95, w6)
    t98 = add(t96, n11, w6)
    t99 = multiply(t98, n10, w7)
    t100 = multiply(t88, t99, w7)
    t101 = divide(t91, t98, w8)
    t103 = multiply(t91, n12, w9)
    t105 = add(t103, n13, w9)
    t106 = multiply(t91, t105, w9)
    t108 = add(t106, n14, w9)
    t109 = multiply(t91, t108, w9)
    t110 = add(t109, n3, w9)
    t111 = divide(t110, t98, w9)
    t112 = multiply(t101, t111, w8)
    t113 = add(t93, n3, w5)
    t114 = multiply(t91, t113, w5)
    t115 = add(t114, n15, w5)
    t116 = divide(t115, t98, w5)
    t117 = multiply(t116, n3, w5)
    t118 = divide(p, e, w9)
    t119 = divide(t118, t98, w10)
    t120 = multiply(t119, t118, w10)
    t121 = divide(x, r, w9)
    t122 = divide(p, t12, w11)
    t123 = multiply(t121, t122, w11)
    t124 = multiply(t120, t123, w10)
    t126 = multiply(t124, n16, w10)
    t127 = add(t117, t126, w5)
    t128 = multiply(t127, n10, w11)
    t129 = multiply(t112, t128, w8)
    t130 = divide(x, e, w11)
    t131 = multiply(e, t98, w0)
    t132 = divide(t130, t131, w11)
    t133 = divide(t132, r, w11)
    t134 = divide(t133, t12, w11)
    t135 = divide(t134, p, w11)
    t136 = multiply(t135, n3, w11)
    t138 = multiply(t91, n17, w0)
    t140 = add(t138, n18, w0)
    t141 = multiply(t91, t140, w0)
    t142 = add(t141, n10, w0)
    t143 = multiply(t142, t91, w0)
    t144 = divide(t143, t98, w0)
    t145 = multiply(t91, n3, updated_22)
    t146 = add(t145, n3, updated_22)
    t147 = divide(t146, t98, w12)
    t148 = multiply(t144, t147, w0)
    t149 = divide(tracking_index, t12, w12)
    t150 = divide(t149, t12, w12)
    t152 = multiply(t150, n19, w12)
    t153 = add(t148, t152, w0)
    t154 = add(t136, t126, w12)
    t155 = square(t146, updated_33)
    t156 = divide(t155, t98, updated_33)
    t157 = multiply(t156, n3, updated_33)
    t158 = add(t154, t157, updated_33)
    t159 = multiply(t126, t158, w13)
    t160 = add(t153, t159, w0)
    t161 = multiply(t136, t160, w0)
    t162 = multiply(t161, t158, updated_33)
    t163 = add(t129, t162, w8)
    t164 = multiply(t146, t91, w13)
    t165 = divide(t164, t98, w13)
    t167 = multiply(t165, n20, w13)
    t169 = multiply(t154, n21, w12)
    t170 = add(t167, t169, w13)
    t171 = multiply(t127, t170, w13)
    t173 = multiply(t91, n22, w12)
    t174 = add(t173, n10, w12)
    t175 = multiply(t91, t174, w12)
    t176 = add(t175, n15, w12)
    t177 = divide(t176, t98, w12)
    t178 = multiply(t126, n3, updated_33)
    t179 = add(t177, t178, w12)
    t180 = multiply(t179, n10, updated_33)
    t181 = add(t171, t180, w13)
    t182 = add(t181, t136, w13)
    t183 = multiply(t126, t182, w13)
    t184 = add(t163, t183, w8)
    t185 = multiply(t100, t184, w7)
    t186 = divide(t185, r, w7)
    t187 = multiply(t87, t186, w1)
    t188 = multiply(t121, n3, w9)
    t189 = add(t127, n15, w7)
    t190 = multiply(t127, t189, w5)
    t191 = add(t190, t161, w5)
    t192 = multiply(t188, t191, w5)
    t193 = add(t187, t192, w1)
    t194 = multiply(t193, n23, w1)
    t195 = multiply(t88, n10, w3)
    t197 = multiply(t91, n24, w7)
    t199 = add(t197, n25, w7)
    t200 = multiply(t91, t199, w7)
    t202 = add(t200, n26, w7)
    t203 = multiply(t91, t202, w7)
    t205 = add(t203, n27, w7)
    t206 = multiply(t91, t205, w7)
    t208 = add(t206, n28, w7)
    t209 = multiply(t91, t208, w7)
    t210 = add(t209, n10, w7)
    t211 = divide(t210, t98, w7)
    t212 = divide(t211, t98, w7)
    t213 = multiply(t161, t146, w0)
    t214 = add(t212, t213, w7)
    t216 = multiply(t91, n29, w0)
    t217 = add(t216, n17, w0)
    t218 = multiply(t91, t217, w0)
    t219 = add(t218, n21, w0)
    t220 = multiply(t91, t219, w0)
    t221 = add(t220, n10, w0)
    t222 = divide(t221, t98, w0)
    t223 = multiply(t222, n3, w0)
    t224 = multiply(t146, t179, updated_22)
    t225 = add(t223, t224, w0)
    t226 = multiply(t91, n10, w4)
    t227 = add(t225, t226, w0)
    t228 = multiply(t126, t227, w10)
    t229 = add(t214, t228, w7)
    t230 = multiply(t195, t229, w3)
    t231 = multiply(t230, n8, w0)
    t232 = add(t231, n4, w0)
    t233 = add(t194, t232, w1)
    t234 = multiply(t230, n4, w0)
    t235 = add(t234, n15, w0)
    t238 = add(t230, t192, w3)
    t239 = multiply(t238, n8, w3)
    t241 = add(t239, n30, w3)
    t242 = multiply(t192, n4, w5)
    t245 = add(t242, n15, w4)
    t246 = divide(r, x, updated_23)
    t247 = multiply(t246, n4, updated_23)
    t248 = multiply(t247, n3, updated_23)
    t249 = multiply(t188, t248, w9)
    subtract(t233, t235, updated_22)
    subtract(t241, t242, updated_23)
    subtract(t245, t249, updated_33)


_UPDATED_COVARIANCE_SECOND_DERIVATIVES = Signature(
    "updated_covariance_second_derivatives",
    (_TRACKING_INDEX_DOMAIN,),
    ("updated_22", "updated_23", "updated_33"),
    14,
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
        G (G^2 + G + 2/15) = 64/Lambda^2, t = sqrt(1 + G), g = sqrt(G^2 + 2/15),
        a = sqrt(1 + 2 g - G), real_pole = (t - 1)/(t + 1), half_sum = (g - 1)/(1 + a + g)

    tracking_index: Lambda, with Lambda^2 =
        jerk_density*sampling_interval**5/measurement_deviation**2; a number above 0 and finite.

    real_pole: positive pole, the one that is real for every index. Relative error at most 8.08 *
        2^-52 (float64), 8.55 * 2^-23 (float32), proved for 5e-324 <= tracking_index <=
        7.343758849926206e154 (float64) and 1e-45 <= tracking_index <= 1.0103697e20 (float32).
    modulus: geometric mean of the moduli of the other two, that of each while they are complex.
        Relative error at most 6.56 * 2^-52 (float64), 6.54 * 2^-23 (float32), proved for 5e-324 <=
        tracking_index <= 1.7976931348623157e308 (float64) and 1e-45 <= tracking_index <=
        3.4028235e38 (float32).
    half_sum: half the sum of these two, the real part of each while they are complex. Relative
        error at most 32.24 * 2^-52 (float64), 31.92 * 2^-23 (float32), proved for 5e-324 <=
        tracking_index <= 1.7976931348623157e308 (float64) and 1e-45 <= tracking_index <=
        3.4028235e38 (float32).
    quarter_discriminant: square of half their difference, negative while they are complex. Relative
        error at most 40.45 * 2^-52 (float64), 40.65 * 2^-23 (float32), proved for 5e-324 <=
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

    Source: derivation continuous-white-jerk
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
    t4 = 1.0 / form.sqrt(t1)
    t8 = 1.0 / (t4 + (tracking_index * 0.015625))
    t9 = t8 * t4
    t13 = (t9 * t9) * ((t9 * t4) * 0.015625)
    t14 = t8 * t8
    t17 = (tracking_index * t8) * 0.0006944444444444445
    t18 = t14 * 0.015625
    t19 = t17 * t17
    t20 = t19 * t17
    t25 = t13 + ((t17 * t18) + (t20 * 2.0))
    t28 = (t19 * 3.0) + t18
    t32 = t13 + ((t14 * t8) * 0.00234374962747097)
    t38 = t32 + ((t17 * (t18 * 2.0)) + (t20 * 8.0))
    t39 = form.near_cbrt(t38)
    t41 = t28 * t39
    t42 = t41 + t25
    t44 = form.sqrt(t39 * t42)
    t45 = form.sqrt(t44)
    t49 = (t42 * 0.25) + (t41 * 0.25)
    t50 = t44 * t45
    t55 = ((t45 * t50) - (t49 * t39)) / (t50 - t49)
    t57 = t28 * t55
    t58 = t57 + t25
    t60 = form.sqrt(t55 * t58)
    t61 = form.sqrt(t60)
    t64 = (t58 * 0.25) + (t57 * 0.25)
    t65 = t60 * t61
    t70 = ((t61 * t65) - (t64 * t55)) / (t65 - t64)
    t72 = t28 * t70
    t73 = t72 + t25
    t75 = form.sqrt(t70 * t73)
    t76 = form.sqrt(t75)
    t79 = (t73 * 0.25) + (t72 * 0.25)
    t80 = t75 * t76
    t85 = ((t76 * t80) - (t79 * t70)) / (t80 - t79)
    t87 = t28 * t85
    t88 = t87 + t25
    t90 = form.sqrt(t85 * t88)
    t91 = form.sqrt(t90)
    t94 = (t88 * 0.25) + (t87 * 0.25)
    t95 = t90 * t91
    t100 = ((t91 * t95) - (t94 * t85)) / (t95 - t94)
    t105 = form.sqrt(t100 * ((t28 * t100) + t25))
    t107 = form.sqrt(t105) + t17
    t108 = t107 / t8
    t109 = t8 / t107
    t111 = t109 / tracking_index
    t113 = form.sqrt(t111 + 1.0)
    t115 = 2.220446049250313e-16 / tracking_index
    t117 = tracking_index * 4.625929269271486e-19
    t122 = (form.sqrt(t115 + t117) * 67108864.0) * 8.0
    t124 = (t122 / t113) / t1
    t128 = t124 + 1.0
    t129 = t128 + (0.13333333333333333 / (t111 + t124))
    t132 = (form.sqrt(t129) + 1.0) + t124
    t133 = t113 + 1.0
    t138 = tracking_index * 0.028087750045592646
    t140 = t108 + ((t109 * 0.01454608337892598) + t138)
    t141 = (5.966800592310059 - tracking_index) + (
        -9.738720763152742e-08 if form.single else 3.740420498507711e-16
    )
    t145 = ((t141 / t140) / tracking_index) * (5.966800592310059 + tracking_index)
    t156 = (t145 * 0.028087750045592646) * ((t111 + 0.9309493362512627) / t128)
    t162 = tracking_index * 0.0033840162126440396
    t163 = (t109 * 0.0028603819712654517) + t162
    t165 = (31.608914128879448 - tracking_index) + (
        7.072486027936975e-07 if form.single else -1.5829239487703273e-15
    )
    t167 = (t165 / (t108 + t163)) / tracking_index
    t169 = t167 * (31.608914128879448 + tracking_index)
    t176 = ((t169 * 0.001000877316602882) / t132) * ((t111 + 0.8497311128276556) / t129)
    t149 = (t111 / t133) / t133
    t152 = ((form.sqrt(t108) / t1) * 8.0) / t132
    t157 = t156 / t132
    t179 = (t176 / t132) * -3.0
    return (t149, t152, t157, t179)


def _closed_loop_poles_block(
    given: Arrays,
    out: Arrays,
    work: Arrays,
    single: bool,
    n0: float = 1.0,
    n1: float = 0.015625,
    n2: float = 0.0006944444444444445,
    n3: float = 2.0,
    n4: float = 3.0,
    n5: float = 0.00234374962747097,
    n6: float = 8.0,
    n7: float = 0.25,
    n8: float = 2.220446049250313e-16,
    n9: float = 4.625929269271486e-19,
    n10: float = 67108864.0,
    n11: float = 0.13333333333333333,
    n12: float = 0.01454608337892598,
    n13: float = 0.028087750045592646,
    n14: float = 5.966800592310059,
    n15: float = -9.738720763152742e-08,
    n16: float = 3.740420498507711e-16,
    n17: float = 0.9309493362512627,
    n18: float = 0.0028603819712654517,
    n19: float = 0.0033840162126440396,
    n20: float = 31.608914128879448,
    n21: float = 7.072486027936975e-07,
    n22: float = -1.5829239487703273e-15,
    n23: float = 0.001000877316602882,
    n24: float = 0.8497311128276556,
    n25: float = -3.0,
) -> None:
    (tracking_index,) = given
    real_pole, modulus, half_sum, quarter_discriminant = out
    w0, w1, w2, w3, w4, w5, w6 = work
    p = sqrt(tracking_index, real_pole)
    r = sqrt(p, modulus)
    t4 = divide(n0, r, half_sum)
    t6 = multiply(tracking_index, n1, modulus)
    t7 = add(t4, t6, modulus)
    t8 = divide(n0, t7, quarter_discriminant)
    t9 = multiply(t8, t4, modulus)
    t10 = square(t9, w0)
    t11 = multiply(t9, t4, modulus)
    t12 = multiply(t11, n1, modulus)
    t13 = multiply(t10, t12, w0)
    t14 = square(t8, modulus)
    t15 = multiply(tracking_index, t8, half_sum)
    t17 = multiply(t15, n2, half_sum)
    t18 = multiply(t14, n1, w1)
    t19 = square(t17, w2)
    t20 = multiply(t19, t17, w3)
    t21 = multiply(t17, t18, w4)
    t23 = multiply(t20, n3, w5)
    t24 = add(t21, t23, w4)
    t25 = add(t13, t24, w4)
    t27 = multiply(t19, n4, w2)
    t28 = add(t27, t18, w2)
    t29 = multiply(t14, t8, modulus)
    t31 = multiply(t29, n5, modulus)
    t32 = add(t13, t31, w0)
    t33 = multiply(t18, n3, w1)
    t34 = multiply(t17, t33, w1)
    t36 = multiply(t20, n6, w3)
    t37 = add(t34, t36, w1)
    t38 = add(t32, t37, w0)
    t39 = near_cbrt(t38, w0, single)
    t41 = multiply(t28, t39, w1)
    t42 = add(t41, t25, w3)
    t43 = multiply(t39, t42, w5)
    t44 = sqrt(t43, w5)
    t45 = sqrt(t44, modulus)
    t47 = multiply(t42, n7, w3)
    t48 = multiply(t41, n7, w1)
    t49 = add(t47, t48, w3)
    t50 = multiply(t44, t45, w5)
    t51 = multiply(t45, t50, modulus)
    t52 = multiply(t49, t39, w0)
    t53 = subtract(t51, t52, modulus)
    t54 = subtract(t50, t49, w5)
    t55 = divide(t53, t54, modulus)
    t57 = multiply(t28, t55, w0)
    t58 = add(t57, t25, w1)
    t59 = multiply(t55, t58, w3)
    t60 = sqrt(t59, w3)
    t61 = sqrt(t60, w5)
    t62 = multiply(t58, n7, w1)
    t63 = multiply(t57, n7, w0)
    t64 = add(t62, t63, w1)
    t65 = multiply(t60, t61, w3)
    t66 = multiply(t61, t65, w5)
    t67 = multiply(t64, t55, modulus)
    t68 = subtract(t66, t67, w5)
    t69 = subtract(t65, t64, w3)
    t70 = divide(t68, t69, w5)
    t72 = multiply(t28, t70, w0)
    t73 = add(t72, t25, w1)
    t74 = multiply(t70, t73, w3)
    t75 = sqrt(t74, w3)
    t76 = sqrt(t75, modulus)
    t77 = multiply(t73, n7, w1)
    t78 = multiply(t72, n7, w0)
    t79 = add(t77, t78, w1)
    t80 = multiply(t75, t76, w3)
    t81 = multiply(t76, t80, modulus)
    t82 = multiply(t79, t70, w5)
    t83 = subtract(t81, t82, modulus)
    t84 = subtract(t80, t79, w3)
    t85 = divide(t83, t84, modulus)
    t87 = multiply(t28, t85, w0)
    t88 = add(t87, t25, w1)
    t89 = multiply(t85, t88, w3)
    t90 = sqrt(t89, w3)
    t91 = sqrt(t90, w5)
    t92 = multiply(t88, n7, w1)
    t93 = multiply(t87, n7, w0)
    t94 = add(t92, t93, w1)
    t95 = multiply(t90, t91, w3)
    t96 = multiply(t91, t95, w5)
    t97 = multiply(t94, t85, modulus)
    t98 = subtract(t96, t97, w5)
    t99 = subtract(t95, t94, w3)
    t100 = divide(t98, t99, w5)
    t102 = multiply(t28, t100, w2)
    t103 = add(t102, t25, w2)
    t104 = multiply(t100, t103, w5)
    inner = sqrt(t104, w5)
    z = sqrt(inner, w5)
    t107 = add(z, t17, w5)
    t108 = divide(t107, t8, w0)
    t109 = divide(t8, t107, quarter_discriminant)
    v_root = sqrt(t108, w1)
    t111 = divide(t109, tracking_index, w2)
    t112 = add(t111, n0, w3)
    t = sqrt(t112, w3)
    t115 = divide(n8, tracking_index, w4)
    t117 = multiply(tracking_index, n9, w5)
    t118 = add(t115, t117, w4)
    c_scaled = sqrt(t118, w4)
    t121 = multiply(c_scaled, n10, w4)
    t122 = multiply(t121, n6, w4)
    t123 = divide(t122, t, w4)
    t124 = divide(t123, p, w4)
    t125 = add(t111, t124, w5)
    t127 = divide(n11, t125, w5)
    t128 = add(t124, n0, modulus)
    t129 = add(t128, t127, w5)
    a = sqrt(t129, half_sum)
    t131 = add(a, n0, half_sum)
    t132 = add(t131, t124, half_sum)
    t133 = add(t, n0, w3)
    t136 = multiply(t109, n12, w4)
    t138 = multiply(tracking_index, n13, w6)
    t139 = add(t136, t138, w4)
    t140 = add(t108, t139, w4)
    rest = n15 if single else n16
    subtract(n14, tracking_index, w6)
    t141 = add(w6, rest, w6)
    t142 = divide(t141, t140, w6)
    t143 = divide(t142, tracking_index, w6)
    t144 = add(n14, tracking_index, w4)
    t145 = multiply(t143, t144, w6)
    t147 = multiply(t145, n13, w6)
    t148 = divide(t111, t133, w4)
    t150 = divide(v_root, p, w1)
    t151 = multiply(t150, n6, w1)
    t154 = add(t111, n17, real_pole)
    t155 = divide(t154, t128, real_pole)
    t156 = multiply(t147, t155, w6)
    t160 = multiply(t109, n18, quarter_discriminant)
    t162 = multiply(tracking_index, n19, real_pole)
    t163 = add(t160, t162, quarter_discriminant)
    t164 = add(t108, t163, w0)
    rest_ = n21 if single else n22
    subtract(n20, tracking_index, real_pole)
    t165 = add(real_pole, rest_, real_pole)
    t166 = divide(t165, t164, real_pole)
    t167 = divide(t166, tracking_index, real_pole)
    t168 = add(n20, tracking_index, w0)
    t169 = multiply(t167, t168, real_pole)
    t171 = multiply(t169, n23, real_pole)
    t172 = divide(t171, t132, real_pole)
    t174 = add(t111, n24, w2)
    t175 = divide(t174, t129, w2)
    t176 = multiply(t172, t175, real_pole)
    t177 = divide(t176, t132, w0)
    divide(t148, t133, real_pole)
    divide(t151, t132, modulus)
    divide(t156, t132, half_sum)
    multiply(t177, n25, quarter_discriminant)


_CLOSED_LOOP_POLES = Signature(
    "closed_loop_poles",
    (_TRACKING_INDEX_DOMAIN,),
    ("real_pole", "modulus", "half_sum", "quarter_discriminant"),
    7,
    _closed_loop_poles_block,
    numbers=_closed_loop_poles_of_numbers,
)
