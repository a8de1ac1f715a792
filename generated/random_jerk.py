# Made by: gainproof generate random-jerk
# From: gainproof derive random-jerk, SymPy 1.14.0
"""Random jerk (constant over each interval): steady state with measured position."""

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
        delta = sqrt(64/Lambda^2 + 1/9),
        xi = sqrt(5/3 + 2 eta), eta = sqrt(7/9 + 2 delta xi), nu = 1 + xi + eta + delta

    tracking_index: Lambda, with Lambda^2 =
        jerk_deviation**2*sampling_interval**6/measurement_deviation**2; a number above 0 and
        finite.

    alpha: position gain. Relative error at most 6.18 * 2^-52 (float64), 6.18 * 2^-23 (float32),
        proved for 5e-324 <= tracking_index <= 1.7976931348623157e308 (float64) and 1e-45 <=
        tracking_index <= 3.4028235e38 (float32).
    beta: velocity gain times the sampling interval. Relative error at most 6.09 * 2^-52 (float64),
        6.09 * 2^-23 (float32), proved for 5e-324 <= tracking_index <= 1.7976931348623157e308
        (float64) and 1e-45 <= tracking_index <= 3.4028235e38 (float32).
    gamma: acceleration gain times the square of the sampling interval. Relative error at most 4.60
        * 2^-52 (float64), 4.60 * 2^-23 (float32), proved for 2.2250738585072014e-308 <=
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

    Source: derivation random-jerk
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
    t4 = 2.220446049250313e-16 / tracking_index
    t6 = tracking_index * 3.854941057726238e-19
    t10 = form.sqrt(t4 + t6) * 67108864.0
    t13 = (t10 * t2) * 2.0
    t15 = t1 * 0.4166666666666667
    t17 = tracking_index * 0.04861111111111111
    t24 = ((t1 * t2) * 1.2504627916220945) + (8.0 / t2)
    t25 = form.near_cbrt(t24)
    t29 = form.sqrt((t13 * t25) + t17)
    t32 = form.sqrt((t29 * 2.0) + t15)
    t34 = t13 * 0.5
    t35 = t29 * t32
    t40 = ((t32 * t35) - (t34 * t25)) / (t35 - t34)
    t44 = form.sqrt((t13 * t40) + t17)
    t47 = form.sqrt((t44 * 2.0) + t15)
    t48 = t44 * t47
    t53 = ((t47 * t48) - (t34 * t40)) / (t48 - t34)
    t57 = form.sqrt((t13 * t53) + t17)
    t60 = form.sqrt((t57 * 2.0) + t15)
    t61 = t57 * t60
    t66 = ((t60 * t61) - (t34 * t53)) / (t61 - t34)
    t70 = form.sqrt((t13 * t66) + t17)
    t73 = form.sqrt((t70 * 2.0) + t15)
    t74 = t70 * t73
    t79 = ((t73 * t74) - (t34 * t66)) / (t74 - t34)
    t83 = form.sqrt((t13 * t79) + t17)
    t92 = form.sqrt((t83 * 2.0) + t15) * t2
    t96 = (t10 + (t83 * 0.5)) + ((t92 * 0.25) + (t1 * 0.125))
    t97 = (t83 + (t1 * 0.25)) / t96
    t98 = t92 / t96
    t99 = t1 / t96
    return (t97, t98, t99)


def _gains_block(
    given: Arrays,
    out: Arrays,
    work: Arrays,
    single: bool,
    n0: float = 2.220446049250313e-16,
    n1: float = 3.854941057726238e-19,
    n2: float = 67108864.0,
    n3: float = 2.0,
    n4: float = 0.4166666666666667,
    n5: float = 0.04861111111111111,
    n6: float = 1.2504627916220945,
    n7: float = 8.0,
    n8: float = 0.5,
    n9: float = 0.25,
    n10: float = 0.125,
) -> None:
    (tracking_index,) = given
    alpha, beta, gamma = out
    w0, w1, w2, w3, w4, w5, w6 = work
    p = sqrt(tracking_index, gamma)
    r = sqrt(p, alpha)
    t4 = divide(n0, tracking_index, beta)
    t6 = multiply(tracking_index, n1, w0)
    t7 = add(t4, t6, beta)
    c_scaled = sqrt(t7, beta)
    t10 = multiply(c_scaled, n2, beta)
    t11 = multiply(t10, r, w0)
    t13 = multiply(t11, n3, w0)
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
    t34 = multiply(t13, n8, w6)
    t35 = multiply(t29, t32, w4)
    t36 = multiply(t32, t35, w5)
    t37 = multiply(t34, t25, w3)
    t38 = subtract(t36, t37, w5)
    t39 = subtract(t35, t34, w4)
    t40 = divide(t38, t39, w5)
    t42 = multiply(t13, t40, w3)
    t43 = add(t42, t17, w3)
    t44 = sqrt(t43, w3)
    t45 = multiply(t44, n3, w4)
    t46 = add(t45, t15, w4)
    t47 = sqrt(t46, w4)
    t48 = multiply(t44, t47, w3)
    t49 = multiply(t47, t48, w4)
    t50 = multiply(t34, t40, w5)
    t51 = subtract(t49, t50, w4)
    t52 = subtract(t48, t34, w3)
    t53 = divide(t51, t52, w4)
    t55 = multiply(t13, t53, w3)
    t56 = add(t55, t17, w3)
    t57 = sqrt(t56, w3)
    t58 = multiply(t57, n3, w5)
    t59 = add(t58, t15, w5)
    t60 = sqrt(t59, w5)
    t61 = multiply(t57, t60, w3)
    t62 = multiply(t60, t61, w5)
    t63 = multiply(t34, t53, w4)
    t64 = subtract(t62, t63, w5)
    t65 = subtract(t61, t34, w3)
    t66 = divide(t64, t65, w5)
    t68 = multiply(t13, t66, w3)
    t69 = add(t68, t17, w3)
    t70 = sqrt(t69, w3)
    t71 = multiply(t70, n3, w4)
    t72 = add(t71, t15, w4)
    t73 = sqrt(t72, w4)
    t74 = multiply(t70, t73, w3)
    t75 = multiply(t73, t74, w4)
    t76 = multiply(t34, t66, w5)
    t77 = subtract(t75, t76, w4)
    t78 = subtract(t74, t34, w3)
    t79 = divide(t77, t78, w4)
    t81 = multiply(t13, t79, w0)
    t82 = add(t81, t17, w0)
    e = sqrt(t82, w0)
    t84 = multiply(e, n3, w2)
    t85 = add(t84, t15, w2)
    x = sqrt(t85, w2)
    t88 = multiply(p, n9, w1)
    t89 = add(e, t88, w1)
    t90 = multiply(e, n8, w0)
    t91 = add(t10, t90, beta)
    t92 = multiply(x, r, w2)
    t93 = multiply(t92, n9, w0)
    t94 = multiply(p, n10, w3)
    t95 = add(t93, t94, w0)
    t96 = add(t91, t95, w0)
    divide(t89, t96, alpha)
    divide(t92, t96, beta)
    divide(p, t96, gamma)


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
    t5 = add(t3, (0.1111111111111111, 6.1679056923619804e-18))
    delta = root(t5)
    # what the plain kernel gives is near the root
    near = evaluate(_GAINS, exact(given)[:1], None, 1)
    near_xi = exact(2.0 * near[1] / near[2])
    t8 = multiply(delta, near_xi)
    t10 = scale(t8, 2.0)
    t12 = add(t10, (0.7777777777777778, -1.2335811384723961e-17))
    near_eta = root(t12)
    t14 = scale(near_eta, 2.0)
    t16 = add(t14, (1.6666666666666667, -7.401486830834377e-17))
    image = root(t16)
    t18 = multiply(near_xi, near_eta)
    t19 = divide(delta, t18)
    xi = refined(near_xi, image, t19)
    t21 = multiply(delta, xi)
    t22 = scale(t21, 2.0)
    t23 = add(t22, (0.7777777777777778, -1.2335811384723961e-17))
    eta = root(t23)
    t25 = add(xi, eta)
    t27 = add(t25, (1.0, 0.0))
    nu = add(delta, t27)
    t29 = add(eta, (1.0, 0.0))
    t30 = scale(t29, 2.0)
    t31 = divide(t30, nu)
    t33 = scale(xi, 4.0)
    t34 = divide(t33, nu)
    t36 = divide((8.0, 0.0), nu)
    return (t31[0], t34[0], t36[0])


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

        delta = sqrt(64/Lambda^2 + 1/9),
        xi = sqrt(5/3 + 2 eta), eta = sqrt(7/9 + 2 delta xi), nu = 1 + xi + eta + delta

    tracking_index: Lambda, with Lambda^2 =
        jerk_deviation**2*sampling_interval**6/measurement_deviation**2; a number above 0 and
        finite.

    alpha: derivative of the position gain. Relative error at most 15.53 * 2^-52 (float64), 15.60 *
        2^-23 (float32), proved for 5e-324 <= tracking_index <= 6.147487532734931e102 (float64) and
        1e-45 <= tracking_index <= 7.604528e12 (float32).
    beta: derivative of the velocity gain times the sampling interval. Relative error at most 16.15
        * 2^-52 (float64), 16.16 * 2^-23 (float32), proved for 5e-324 <= tracking_index <=
        1.6993864335471447e103 (float64) and 1e-45 <= tracking_index <= 2.1021648e13 (float32).
    gamma: derivative of the acceleration gain times the square of the sampling interval. Relative
        error at most 16.48 * 2^-52 (float64), 16.47 * 2^-23 (float32), proved for 5e-324 <=
        tracking_index <= 2.109262031745273e103 (float64) and 1e-45 <= tracking_index <=
        2.6091866e13 (float32).

    Outside an output's range, a few numbers next to its ends apart, its true value is no normal
    number: it comes as 0, a subnormal number or infinity, never as NaN. Numbers and arrays are
    taken, arrays of any shape; inputs are broadcast. float64 and float32 stay what they are,
    integers become float64. `out`: a tuple of arrays to fill. `workers`: threads that share the
    work on long arrays.

    ValueError: an input outside its domain, with its place; `out` or `workers` that does not fit.
    TypeError: an input that is no real number of these types; in `out` what is no array of the
    results' type.

    Source: derivation random-jerk
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
    t4 = 2.220446049250313e-16 / tracking_index
    t6 = tracking_index * 3.854941057726238e-19
    t10 = form.sqrt(t4 + t6) * 67108864.0
    t14 = (t10 * t2) * 2.0
    t16 = t1 * 0.4166666666666667
    t18 = tracking_index * 0.04861111111111111
    t25 = ((t1 * t2) * 1.2504627916220945) + (8.0 / t2)
    t26 = form.near_cbrt(t25)
    t30 = form.sqrt((t14 * t26) + t18)
    t33 = form.sqrt((t30 * 2.0) + t16)
    t35 = t14 * 0.5
    t36 = t30 * t33
    t41 = ((t33 * t36) - (t35 * t26)) / (t36 - t35)
    t45 = form.sqrt((t14 * t41) + t18)
    t48 = form.sqrt((t45 * 2.0) + t16)
    t49 = t45 * t48
    t54 = ((t48 * t49) - (t35 * t41)) / (t49 - t35)
    t58 = form.sqrt((t14 * t54) + t18)
    t61 = form.sqrt((t58 * 2.0) + t16)
    t62 = t58 * t61
    t67 = ((t61 * t62) - (t35 * t54)) / (t62 - t35)
    t71 = form.sqrt((t14 * t67) + t18)
    t74 = form.sqrt((t71 * 2.0) + t16)
    t75 = t71 * t74
    t80 = ((t74 * t75) - (t35 * t67)) / (t75 - t35)
    t84 = form.sqrt((t14 * t80) + t18)
    t90 = t84 + (t1 * 0.16666666666666666)
    t91 = form.sqrt((t84 * 2.0) + t16) * t2
    t92 = t91 / t10
    t96 = t90 + ((t92 * t1) * 0.006944444444444444)
    t97 = t84 * t84
    t100 = t1 * t84
    t103 = (t97 * 0.75) + (t100 * 0.20833333333333334)
    t105 = tracking_index * 0.012152777777777778
    t106 = t103 + t105
    t109 = t91 * 0.25
    t111 = ((t96 / t106) * t109) / tracking_index
    t117 = (t10 + (t84 * 0.5)) + (t109 + (t1 * 0.125))
    t124 = (t97 * 0.25) + (t100 * 0.10416666666666667)
    t128 = (t124 + t105) + (t91 * (t90 * 0.125))
    t132 = ((t128 / t106) * 2.0) * (t92 / tracking_index)
    t133 = t1 * t117
    t139 = (t84 + (t1 * 0.20833333333333334)) + t109
    t144 = (((t91 / t106) * (t139 * 0.5)) + 1.0) / (t10 * t1)
    t120 = (((t111 * 2.0) / t117) / t117) / tracking_index
    t135 = (t132 / t133) / t133
    t146 = (t144 / t133) / t133
    return (t120, t135, t146)


def _gain_derivatives_block(
    given: Arrays,
    out: Arrays,
    work: Arrays,
    single: bool,
    n0: float = 2.220446049250313e-16,
    n1: float = 3.854941057726238e-19,
    n2: float = 67108864.0,
    n3: float = 2.0,
    n4: float = 0.4166666666666667,
    n5: float = 0.04861111111111111,
    n6: float = 1.2504627916220945,
    n7: float = 8.0,
    n8: float = 0.5,
    n9: float = 0.16666666666666666,
    n10: float = 0.006944444444444444,
    n11: float = 0.75,
    n12: float = 0.20833333333333334,
    n13: float = 0.012152777777777778,
    n14: float = 0.25,
    n15: float = 0.125,
    n16: float = 0.10416666666666667,
    n17: float = 1.0,
) -> None:
    (tracking_index,) = given
    alpha, beta, gamma = out
    w0, w1, w2, w3, w4, w5, w6, w7, w8, w9, w10 = work
    p = sqrt(tracking_index, alpha)
    r = sqrt(p, beta)
    t4 = divide(n0, tracking_index, gamma)
    t6 = multiply(tracking_index, n1, w0)
    t7 = add(t4, t6, gamma)
    c_scaled = sqrt(t7, gamma)
    t10 = multiply(c_scaled, n2, gamma)
    t12 = multiply(t10, r, w0)
    t14 = multiply(t12, n3, w0)
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
    t35 = multiply(t14, n8, w6)
    t36 = multiply(t30, t33, w4)
    t37 = multiply(t33, t36, w5)
    t38 = multiply(t35, t26, w3)
    t39 = subtract(t37, t38, w5)
    t40 = subtract(t36, t35, w4)
    t41 = divide(t39, t40, w5)
    t43 = multiply(t14, t41, w3)
    t44 = add(t43, t18, w3)
    t45 = sqrt(t44, w3)
    t46 = multiply(t45, n3, w4)
    t47 = add(t46, t16, w4)
    t48 = sqrt(t47, w4)
    t49 = multiply(t45, t48, w3)
    t50 = multiply(t48, t49, w4)
    t51 = multiply(t35, t41, w5)
    t52 = subtract(t50, t51, w4)
    t53 = subtract(t49, t35, w3)
    t54 = divide(t52, t53, w4)
    t56 = multiply(t14, t54, w3)
    t57 = add(t56, t18, w3)
    t58 = sqrt(t57, w3)
    t59 = multiply(t58, n3, w5)
    t60 = add(t59, t16, w5)
    t61 = sqrt(t60, w5)
    t62 = multiply(t58, t61, w3)
    t63 = multiply(t61, t62, w5)
    t64 = multiply(t35, t54, w4)
    t65 = subtract(t63, t64, w5)
    t66 = subtract(t62, t35, w3)
    t67 = divide(t65, t66, w5)
    t69 = multiply(t14, t67, w3)
    t70 = add(t69, t18, w3)
    t71 = sqrt(t70, w3)
    t72 = multiply(t71, n3, w4)
    t73 = add(t72, t16, w4)
    t74 = sqrt(t73, w4)
    t75 = multiply(t71, t74, w3)
    t76 = multiply(t74, t75, w4)
    t77 = multiply(t35, t67, w5)
    t78 = subtract(t76, t77, w4)
    t79 = subtract(t75, t35, w3)
    t80 = divide(t78, t79, w4)
    t82 = multiply(t14, t80, w0)
    t83 = add(t82, t18, w0)
    e = sqrt(t83, w0)
    t85 = multiply(e, n3, w2)
    t86 = add(t85, t16, w2)
    x = sqrt(t86, w2)
    t89 = multiply(p, n9, w1)
    t90 = add(e, t89, w1)
    t91 = multiply(x, r, w2)
    t92 = divide(t91, t10, w3)
    t93 = multiply(t92, p, w4)
    t95 = multiply(t93, n10, w4)
    t96 = add(t90, t95, w4)
    t97 = square(e, w5)
    t99 = multiply(t97, n11, w6)
    t100 = multiply(p, e, beta)
    t102 = multiply(t100, n12, w7)
    t103 = add(t99, t102, w6)
    t105 = multiply(tracking_index, n13, w7)
    t106 = add(t103, t105, w6)
    t107 = divide(t96, t106, w4)
    t109 = multiply(t91, n14, w8)
    t110 = multiply(t107, t109, w4)
    t111 = divide(t110, tracking_index, w4)
    t112 = multiply(t111, n3, w4)
    t113 = multiply(e, n8, w9)
    t114 = add(t10, t113, w9)
    t115 = multiply(p, n15, w10)
    t116 = add(t109, t115, w10)
    t117 = add(t114, t116, w9)
    t118 = divide(t112, t117, w4)
    t119 = divide(t118, t117, w4)
    t121 = multiply(t97, n14, w5)
    t123 = multiply(t100, n16, beta)
    t124 = add(t121, t123, w5)
    t125 = add(t124, t105, w5)
    t126 = multiply(t90, n15, w1)
    t127 = multiply(t91, t126, w1)
    t128 = add(t125, t127, w5)
    t129 = divide(t128, t106, w5)
    t130 = multiply(t129, n3, w5)
    t131 = divide(t92, tracking_index, w3)
    t132 = multiply(t130, t131, w5)
    t133 = multiply(p, t117, w9)
    t134 = divide(t132, t133, w5)
    t136 = divide(t91, t106, w2)
    t137 = multiply(p, n12, w1)
    t138 = add(e, t137, w0)
    t139 = add(t138, t109, w0)
    t140 = multiply(t139, n8, w0)
    t141 = multiply(t136, t140, w2)
    t142 = add(t141, n17, w2)
    t143 = multiply(t10, p, gamma)
    t144 = divide(t142, t143, w2)
    t145 = divide(t144, t133, w2)
    divide(t119, tracking_index, alpha)
    divide(t134, t133, beta)
    divide(t145, t133, gamma)


_GAIN_DERIVATIVES = Signature(
    "gain_derivatives",
    (_TRACKING_INDEX_DOMAIN,),
    ("alpha", "beta", "gamma"),
    11,
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

        delta = sqrt(64/Lambda^2 + 1/9),
        xi = sqrt(5/3 + 2 eta), eta = sqrt(7/9 + 2 delta xi), nu = 1 + xi + eta + delta

    tracking_index: Lambda, with Lambda^2 =
        jerk_deviation**2*sampling_interval**6/measurement_deviation**2; a number above 0 and
        finite.

    alpha: position gain. Relative error at most 6.18 * 2^-52 (float64), 6.18 * 2^-23 (float32),
        proved for 5e-324 <= tracking_index <= 1.7976931348623157e308 (float64) and 1e-45 <=
        tracking_index <= 3.4028235e38 (float32).
    beta: velocity gain times the sampling interval. Relative error at most 6.09 * 2^-52 (float64),
        6.09 * 2^-23 (float32), proved for 5e-324 <= tracking_index <= 1.7976931348623157e308
        (float64) and 1e-45 <= tracking_index <= 3.4028235e38 (float32).
    gamma: acceleration gain times the square of the sampling interval. Relative error at most 4.60
        * 2^-52 (float64), 4.60 * 2^-23 (float32), proved for 2.2250738585072014e-308 <=
        tracking_index <= 1.7976931348623157e308 (float64) and 1.1754945e-38 <= tracking_index <=
        3.4028235e38 (float32).
    d_alpha: derivative of the position gain. Relative error at most 15.53 * 2^-52 (float64), 15.60
        * 2^-23 (float32), proved for 5e-324 <= tracking_index <= 6.147487532734931e102 (float64)
        and 1e-45 <= tracking_index <= 7.604528e12 (float32).
    d_beta: derivative of the velocity gain times the sampling interval. Relative error at most
        16.15 * 2^-52 (float64), 16.16 * 2^-23 (float32), proved for 5e-324 <= tracking_index <=
        1.6993864335471447e103 (float64) and 1e-45 <= tracking_index <= 2.1021648e13 (float32).
    d_gamma: derivative of the acceleration gain times the square of the sampling interval. Relative
        error at most 16.48 * 2^-52 (float64), 16.47 * 2^-23 (float32), proved for 5e-324 <=
        tracking_index <= 2.109262031745273e103 (float64) and 1e-45 <= tracking_index <=
        2.6091866e13 (float32).

    Outside an output's range, a few numbers next to its ends apart, its true value is no normal
    number: it comes as 0, a subnormal number or infinity, never as NaN. Numbers and arrays are
    taken, arrays of any shape; inputs are broadcast. float64 and float32 stay what they are,
    integers become float64. `out`: a tuple of arrays to fill. `workers`: threads that share the
    work on long arrays.

    ValueError: an input outside its domain, with its place; `out` or `workers` that does not fit.
    TypeError: an input that is no real number of these types; in `out` what is no array of the
    results' type.

    Source: derivation random-jerk
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
    t4 = 2.220446049250313e-16 / tracking_index
    t6 = tracking_index * 3.854941057726238e-19
    t10 = form.sqrt(t4 + t6) * 67108864.0
    t14 = (t10 * t2) * 2.0
    t16 = t1 * 0.4166666666666667
    t18 = tracking_index * 0.04861111111111111
    t25 = ((t1 * t2) * 1.2504627916220945) + (8.0 / t2)
    t26 = form.near_cbrt(t25)
    t30 = form.sqrt((t14 * t26) + t18)
    t33 = form.sqrt((t30 * 2.0) + t16)
    t35 = t14 * 0.5
    t36 = t30 * t33
    t41 = ((t33 * t36) - (t35 * t26)) / (t36 - t35)
    t45 = form.sqrt((t14 * t41) + t18)
    t48 = form.sqrt((t45 * 2.0) + t16)
    t49 = t45 * t48
    t54 = ((t48 * t49) - (t35 * t41)) / (t49 - t35)
    t58 = form.sqrt((t14 * t54) + t18)
    t61 = form.sqrt((t58 * 2.0) + t16)
    t62 = t58 * t61
    t67 = ((t61 * t62) - (t35 * t54)) / (t62 - t35)
    t71 = form.sqrt((t14 * t67) + t18)
    t74 = form.sqrt((t71 * 2.0) + t16)
    t75 = t71 * t74
    t80 = ((t74 * t75) - (t35 * t67)) / (t75 - t35)
    t84 = form.sqrt((t14 * t80) + t18)
    t93 = form.sqrt((t84 * 2.0) + t16) * t2
    t94 = t93 * 0.25
    t97 = (t10 + (t84 * 0.5)) + (t94 + (t1 * 0.125))
    t103 = t84 + (t1 * 0.16666666666666666)
    t104 = t93 / t10
    t108 = t103 + ((t104 * t1) * 0.006944444444444444)
    t109 = t84 * t84
    t112 = t1 * t84
    t115 = (t109 * 0.75) + (t112 * 0.20833333333333334)
    t117 = tracking_index * 0.012152777777777778
    t118 = t115 + t117
    t121 = ((t108 / t118) * t94) / tracking_index
    t129 = (t109 * 0.25) + (t112 * 0.10416666666666667)
    t133 = (t129 + t117) + (t93 * (t103 * 0.125))
    t137 = ((t133 / t118) * 2.0) * (t104 / tracking_index)
    t138 = t1 * t97
    t144 = (t84 + (t1 * 0.20833333333333334)) + t94
    t149 = (((t93 / t118) * (t144 * 0.5)) + 1.0) / (t10 * t1)
    t98 = (t84 + (t1 * 0.25)) / t97
    t99 = t93 / t97
    t100 = t1 / t97
    t125 = (((t121 * 2.0) / t97) / t97) / tracking_index
    t140 = (t137 / t138) / t138
    t151 = (t149 / t138) / t138
    return (t98, t99, t100, t125, t140, t151)


def _gains_with_derivatives_block(
    given: Arrays,
    out: Arrays,
    work: Arrays,
    single: bool,
    n0: float = 2.220446049250313e-16,
    n1: float = 3.854941057726238e-19,
    n2: float = 67108864.0,
    n3: float = 2.0,
    n4: float = 0.4166666666666667,
    n5: float = 0.04861111111111111,
    n6: float = 1.2504627916220945,
    n7: float = 8.0,
    n8: float = 0.5,
    n9: float = 0.25,
    n10: float = 0.125,
    n11: float = 0.16666666666666666,
    n12: float = 0.006944444444444444,
    n13: float = 0.75,
    n14: float = 0.20833333333333334,
    n15: float = 0.012152777777777778,
    n16: float = 0.10416666666666667,
    n17: float = 1.0,
) -> None:
    (tracking_index,) = given
    alpha, beta, gamma, d_alpha, d_beta, d_gamma = out
    w0, w1, w2, w3, w4, w5, w6, w7 = work
    p = sqrt(tracking_index, gamma)
    r = sqrt(p, alpha)
    t4 = divide(n0, tracking_index, beta)
    t6 = multiply(tracking_index, n1, w0)
    t7 = add(t4, t6, beta)
    c_scaled = sqrt(t7, d_alpha)
    t10 = multiply(c_scaled, n2, d_alpha)
    t12 = multiply(t10, r, w0)
    t14 = multiply(t12, n3, w0)
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
    t35 = multiply(t14, n8, w3)
    t36 = multiply(t30, t33, d_gamma)
    t37 = multiply(t33, t36, d_beta)
    t38 = multiply(t35, t26, w2)
    t39 = subtract(t37, t38, d_beta)
    t40 = subtract(t36, t35, d_gamma)
    t41 = divide(t39, t40, d_beta)
    t43 = multiply(t14, t41, w2)
    t44 = add(t43, t18, w2)
    t45 = sqrt(t44, w2)
    t46 = multiply(t45, n3, d_gamma)
    t47 = add(t46, t16, d_gamma)
    t48 = sqrt(t47, d_gamma)
    t49 = multiply(t45, t48, w2)
    t50 = multiply(t48, t49, d_gamma)
    t51 = multiply(t35, t41, d_beta)
    t52 = subtract(t50, t51, d_gamma)
    t53 = subtract(t49, t35, w2)
    t54 = divide(t52, t53, d_gamma)
    t56 = multiply(t14, t54, w2)
    t57 = add(t56, t18, w2)
    t58 = sqrt(t57, w2)
    t59 = multiply(t58, n3, d_beta)
    t60 = add(t59, t16, d_beta)
    t61 = sqrt(t60, d_beta)
    t62 = multiply(t58, t61, w2)
    t63 = multiply(t61, t62, d_beta)
    t64 = multiply(t35, t54, d_gamma)
    t65 = subtract(t63, t64, d_beta)
    t66 = subtract(t62, t35, w2)
    t67 = divide(t65, t66, d_beta)
    t69 = multiply(t14, t67, w2)
    t70 = add(t69, t18, w2)
    t71 = sqrt(t70, w2)
    t72 = multiply(t71, n3, d_gamma)
    t73 = add(t72, t16, d_gamma)
    t74 = sqrt(t73, d_gamma)
    t75 = multiply(t71, t74, w2)
    t76 = multiply(t74, t75, d_gamma)
    t77 = multiply(t35, t67, d_beta)
    t78 = subtract(t76, t77, d_gamma)
    t79 = subtract(t75, t35, w2)
    t80 = divide(t78, t79, d_gamma)
    t82 = multiply(t14, t80, w0)
    t83 = add(t82, t18, w0)
    e = sqrt(t83, w0)
    t85 = multiply(e, n3, w1)
    t86 = add(t85, t16, w1)
    x = sqrt(t86, w1)
    t89 = multiply(p, n9, w2)
    t90 = add(e, t89, w2)
    t91 = multiply(e, n8, w3)
    t92 = add(t10, t91, w3)
    t93 = multiply(x, r, w1)
    t94 = multiply(t93, n9, alpha)
    t95 = multiply(p, n10, beta)
    t96 = add(t94, t95, beta)
    t97 = add(t92, t96, w3)
    t102 = multiply(p, n11, beta)
    t103 = add(e, t102, beta)
    t104 = divide(t93, t10, d_beta)
    t105 = multiply(t104, p, d_gamma)
    t107 = multiply(t105, n12, d_gamma)
    t108 = add(t103, t107, d_gamma)
    t109 = square(e, w4)
    t111 = multiply(t109, n13, w5)
    t112 = multiply(p, e, w6)
    t114 = multiply(t112, n14, w7)
    t115 = add(t111, t114, w5)
    t117 = multiply(tracking_index, n15, w7)
    t118 = add(t115, t117, w5)
    t119 = divide(t108, t118, d_gamma)
    t120 = multiply(t119, t94, d_gamma)
    t121 = divide(t120, tracking_index, d_gamma)
    t122 = multiply(t121, n3, d_gamma)
    t123 = divide(t122, t97, d_gamma)
    t124 = divide(t123, t97, d_gamma)
    t126 = multiply(t109, n9, w4)
    t128 = multiply(t112, n16, w6)
    t129 = add(t126, t128, w4)
    t130 = add(t129, t117, w4)
    t131 = multiply(t103, n10, beta)
    t132 = multiply(t93, t131, beta)
    t133 = add(t130, t132, w4)
    t134 = divide(t133, t118, w4)
    t135 = multiply(t134, n3, w4)
    t136 = divide(t104, tracking_index, d_beta)
    t137 = multiply(t135, t136, w4)
    t138 = multiply(p, t97, w6)
    t139 = divide(t137, t138, w4)
    t141 = divide(t93, t118, w5)
    t142 = multiply(p, n14, w7)
    t143 = add(e, t142, w0)
    t144 = add(t143, t94, w0)
    t145 = multiply(t144, n8, w0)
    t146 = multiply(t141, t145, w5)
    t147 = add(t146, n17, w5)
    t148 = multiply(t10, p, d_alpha)
    t149 = divide(t147, t148, w5)
    t150 = divide(t149, t138, w5)
    divide(t90, t97, alpha)
    divide(t93, t97, beta)
    divide(p, t97, gamma)
    divide(t124, tracking_index, d_alpha)
    divide(t139, t138, d_beta)
    divide(t150, t138, d_gamma)


_GAINS_WITH_DERIVATIVES = Signature(
    "gains_with_derivatives",
    (_TRACKING_INDEX_DOMAIN,),
    ("alpha", "beta", "gamma", "d_alpha", "d_beta", "d_gamma"),
    8,
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

        delta = sqrt(64/Lambda^2 + 1/9),
        xi = sqrt(5/3 + 2 eta), eta = sqrt(7/9 + 2 delta xi), nu = 1 + xi + eta + delta

    tracking_index: Lambda, with Lambda^2 =
        jerk_deviation**2*sampling_interval**6/measurement_deviation**2; a number above 0 and
        finite.

    position: position entry of F K, alpha + beta + gamma/2. Relative error at most 6.18 * 2^-52
        (float64), 6.19 * 2^-23 (float32), proved for 5e-324 <= tracking_index <=
        1.7976931348623157e308 (float64) and 1e-45 <= tracking_index <= 3.4028235e38 (float32).
    velocity: velocity entry of F K times the sampling interval, beta + gamma. Relative error at
        most 6.59 * 2^-52 (float64), 6.59 * 2^-23 (float32), proved for 5e-324 <= tracking_index <=
        1.7976931348623157e308 (float64) and 1e-45 <= tracking_index <= 3.4028235e38 (float32).
    acceleration: acceleration entry of F K times the square of the sampling interval, gamma.
        Relative error at most 4.60 * 2^-52 (float64), 4.60 * 2^-23 (float32), proved for
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

    Source: derivation random-jerk
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
    t4 = 2.220446049250313e-16 / tracking_index
    t6 = tracking_index * 3.854941057726238e-19
    t10 = form.sqrt(t4 + t6) * 67108864.0
    t13 = (t10 * t2) * 2.0
    t15 = t1 * 0.4166666666666667
    t17 = tracking_index * 0.04861111111111111
    t24 = ((t1 * t2) * 1.2504627916220945) + (8.0 / t2)
    t25 = form.near_cbrt(t24)
    t29 = form.sqrt((t13 * t25) + t17)
    t32 = form.sqrt((t29 * 2.0) + t15)
    t34 = t13 * 0.5
    t35 = t29 * t32
    t40 = ((t32 * t35) - (t34 * t25)) / (t35 - t34)
    t44 = form.sqrt((t13 * t40) + t17)
    t47 = form.sqrt((t44 * 2.0) + t15)
    t48 = t44 * t47
    t53 = ((t47 * t48) - (t34 * t40)) / (t48 - t34)
    t57 = form.sqrt((t13 * t53) + t17)
    t60 = form.sqrt((t57 * 2.0) + t15)
    t61 = t57 * t60
    t66 = ((t60 * t61) - (t34 * t53)) / (t61 - t34)
    t70 = form.sqrt((t13 * t66) + t17)
    t73 = form.sqrt((t70 * 2.0) + t15)
    t74 = t70 * t73
    t79 = ((t73 * t74) - (t34 * t66)) / (t74 - t34)
    t83 = form.sqrt((t13 * t79) + t17)
    t87 = form.sqrt((t83 * 2.0) + t15) * t2
    t98 = (t10 + (t83 * 0.5)) + ((t87 * 0.25) + (t1 * 0.125))
    t99 = (t83 + (t87 + (t1 * 0.75))) / t98
    t101 = (t87 + t1) / t98
    t102 = t1 / t98
    return (t99, t101, t102)


def _predictor_gains_block(
    given: Arrays,
    out: Arrays,
    work: Arrays,
    single: bool,
    n0: float = 2.220446049250313e-16,
    n1: float = 3.854941057726238e-19,
    n2: float = 67108864.0,
    n3: float = 2.0,
    n4: float = 0.4166666666666667,
    n5: float = 0.04861111111111111,
    n6: float = 1.2504627916220945,
    n7: float = 8.0,
    n8: float = 0.5,
    n9: float = 0.75,
    n10: float = 0.25,
    n11: float = 0.125,
) -> None:
    (tracking_index,) = given
    position, velocity, acceleration = out
    w0, w1, w2, w3, w4, w5, w6 = work
    p = sqrt(tracking_index, acceleration)
    r = sqrt(p, position)
    t4 = divide(n0, tracking_index, velocity)
    t6 = multiply(tracking_index, n1, w0)
    t7 = add(t4, t6, velocity)
    c_scaled = sqrt(t7, velocity)
    t10 = multiply(c_scaled, n2, velocity)
    t11 = multiply(t10, r, w0)
    t13 = multiply(t11, n3, w0)
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
    t34 = multiply(t13, n8, w6)
    t35 = multiply(t29, t32, w4)
    t36 = multiply(t32, t35, w5)
    t37 = multiply(t34, t25, w3)
    t38 = subtract(t36, t37, w5)
    t39 = subtract(t35, t34, w4)
    t40 = divide(t38, t39, w5)
    t42 = multiply(t13, t40, w3)
    t43 = add(t42, t17, w3)
    t44 = sqrt(t43, w3)
    t45 = multiply(t44, n3, w4)
    t46 = add(t45, t15, w4)
    t47 = sqrt(t46, w4)
    t48 = multiply(t44, t47, w3)
    t49 = multiply(t47, t48, w4)
    t50 = multiply(t34, t40, w5)
    t51 = subtract(t49, t50, w4)
    t52 = subtract(t48, t34, w3)
    t53 = divide(t51, t52, w4)
    t55 = multiply(t13, t53, w3)
    t56 = add(t55, t17, w3)
    t57 = sqrt(t56, w3)
    t58 = multiply(t57, n3, w5)
    t59 = add(t58, t15, w5)
    t60 = sqrt(t59, w5)
    t61 = multiply(t57, t60, w3)
    t62 = multiply(t60, t61, w5)
    t63 = multiply(t34, t53, w4)
    t64 = subtract(t62, t63, w5)
    t65 = subtract(t61, t34, w3)
    t66 = divide(t64, t65, w5)
    t68 = multiply(t13, t66, w3)
    t69 = add(t68, t17, w3)
    t70 = sqrt(t69, w3)
    t71 = multiply(t70, n3, w4)
    t72 = add(t71, t15, w4)
    t73 = sqrt(t72, w4)
    t74 = multiply(t70, t73, w3)
    t75 = multiply(t73, t74, w4)
    t76 = multiply(t34, t66, w5)
    t77 = subtract(t75, t76, w4)
    t78 = subtract(t74, t34, w3)
    t79 = divide(t77, t78, w4)
    t81 = multiply(t13, t79, w0)
    t82 = add(t81, t17, w0)
    e = sqrt(t82, w0)
    t84 = multiply(e, n3, w2)
    t85 = add(t84, t15, w2)
    x = sqrt(t85, w2)
    t87 = multiply(x, r, w2)
    t89 = multiply(p, n9, w1)
    t90 = add(t87, t89, w1)
    t91 = add(e, t90, w1)
    t92 = multiply(e, n8, w0)
    t93 = add(t10, t92, velocity)
    t95 = multiply(t87, n10, w0)
    t96 = multiply(p, n11, w3)
    t97 = add(t95, t96, w0)
    t98 = add(t93, t97, w0)
    t100 = add(t87, p, w2)
    divide(t91, t98, position)
    divide(t100, t98, velocity)
    divide(p, t98, acceleration)


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

        delta = sqrt(64/Lambda^2 + 1/9),
        xi = sqrt(5/3 + 2 eta), eta = sqrt(7/9 + 2 delta xi), nu = 1 + xi + eta + delta

    tracking_index: Lambda, with Lambda^2 =
        jerk_deviation**2*sampling_interval**6/measurement_deviation**2; a number above 0 and
        finite.

    position: derivative of the position entry of F K, alpha + beta + gamma/2. Relative error at
        most 17.09 * 2^-52 (float64), 17.12 * 2^-23 (float32), proved for 5e-324 <= tracking_index
        <= 2.1423048991561227e103 (float64) and 1e-45 <= tracking_index <= 2.650061e13 (float32).
    velocity: derivative of the velocity entry of F K times the sampling interval, beta + gamma.
        Relative error at most 16.70 * 2^-52 (float64), 16.68 * 2^-23 (float32), proved for 5e-324
        <= tracking_index <= 2.426769755425277e103 (float64) and 1e-45 <= tracking_index <=
        3.001948e13 (float32).
    acceleration: derivative of the acceleration entry of F K times the square of the sampling
        interval, gamma. Relative error at most 16.48 * 2^-52 (float64), 16.47 * 2^-23 (float32),
        proved for 5e-324 <= tracking_index <= 2.109262031745273e103 (float64) and 1e-45 <=
        tracking_index <= 2.6091866e13 (float32).

    Outside an output's range, a few numbers next to its ends apart, its true value is no normal
    number: it comes as 0, a subnormal number or infinity, never as NaN. Numbers and arrays are
    taken, arrays of any shape; inputs are broadcast. float64 and float32 stay what they are,
    integers become float64. `out`: a tuple of arrays to fill. `workers`: threads that share the
    work on long arrays.

    ValueError: an input outside its domain, with its place; `out` or `workers` that does not fit.
    TypeError: an input that is no real number of these types; in `out` what is no array of the
    results' type.

    Source: derivation random-jerk
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
    t4 = 2.220446049250313e-16 / tracking_index
    t6 = tracking_index * 3.854941057726238e-19
    t10 = form.sqrt(t4 + t6) * 67108864.0
    t14 = (t10 * t2) * 2.0
    t16 = t1 * 0.4166666666666667
    t18 = tracking_index * 0.04861111111111111
    t25 = ((t1 * t2) * 1.2504627916220945) + (8.0 / t2)
    t26 = form.near_cbrt(t25)
    t30 = form.sqrt((t14 * t26) + t18)
    t33 = form.sqrt((t30 * 2.0) + t16)
    t35 = t14 * 0.5
    t36 = t30 * t33
    t41 = ((t33 * t36) - (t35 * t26)) / (t36 - t35)
    t45 = form.sqrt((t14 * t41) + t18)
    t48 = form.sqrt((t45 * 2.0) + t16)
    t49 = t45 * t48
    t54 = ((t48 * t49) - (t35 * t41)) / (t49 - t35)
    t58 = form.sqrt((t14 * t54) + t18)
    t61 = form.sqrt((t58 * 2.0) + t16)
    t62 = t58 * t61
    t67 = ((t61 * t62) - (t35 * t54)) / (t62 - t35)
    t71 = form.sqrt((t14 * t67) + t18)
    t74 = form.sqrt((t71 * 2.0) + t16)
    t75 = t71 * t74
    t80 = ((t74 * t75) - (t35 * t67)) / (t75 - t35)
    t84 = form.sqrt((t14 * t80) + t18)
    t90 = t84 + (t1 * 0.16666666666666666)
    t91 = form.sqrt((t84 * 2.0) + t16) * t2
    t92 = t91 / t10
    t96 = t90 + ((t92 * t1) * 0.006944444444444444)
    t97 = t84 * t84
    t100 = t1 * t84
    t103 = (t97 * 0.75) + (t100 * 0.20833333333333334)
    t105 = tracking_index * 0.012152777777777778
    t106 = t103 + t105
    t109 = t91 * 0.25
    t111 = ((t96 / t106) * t109) / tracking_index
    t116 = (t97 * 0.25) + (t100 * 0.10416666666666667)
    t120 = (t116 + t105) + (t91 * (t90 * 0.125))
    t124 = ((t120 / t106) * 2.0) * (t92 / tracking_index)
    t128 = (t84 + (t1 * 0.20833333333333334)) + t109
    t133 = (((t91 / t106) * (t128 * 0.5)) + 1.0) / (t10 * t1)
    t141 = (t10 + (t84 * 0.5)) + (t109 + (t1 * 0.125))
    t142 = t1 * t141
    t143 = ((t111 * 2.0) + (t124 + (t133 * 0.5))) / t142
    t144 = t143 / t142
    t147 = ((t124 + t133) / t142) / t142
    t149 = (t133 / t142) / t142
    return (t144, t147, t149)


def _predictor_gain_derivatives_block(
    given: Arrays,
    out: Arrays,
    work: Arrays,
    single: bool,
    n0: float = 2.220446049250313e-16,
    n1: float = 3.854941057726238e-19,
    n2: float = 67108864.0,
    n3: float = 2.0,
    n4: float = 0.4166666666666667,
    n5: float = 0.04861111111111111,
    n6: float = 1.2504627916220945,
    n7: float = 8.0,
    n8: float = 0.5,
    n9: float = 0.16666666666666666,
    n10: float = 0.006944444444444444,
    n11: float = 0.75,
    n12: float = 0.20833333333333334,
    n13: float = 0.012152777777777778,
    n14: float = 0.25,
    n15: float = 0.10416666666666667,
    n16: float = 0.125,
    n17: float = 1.0,
) -> None:
    (tracking_index,) = given
    position, velocity, acceleration = out
    w0, w1, w2, w3, w4, w5, w6, w7, w8 = work
    p = sqrt(tracking_index, position)
    r = sqrt(p, velocity)
    t4 = divide(n0, tracking_index, acceleration)
    t6 = multiply(tracking_index, n1, w0)
    t7 = add(t4, t6, acceleration)
    c_scaled = sqrt(t7, acceleration)
    t10 = multiply(c_scaled, n2, acceleration)
    t12 = multiply(t10, r, w0)
    t14 = multiply(t12, n3, w0)
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
    t35 = multiply(t14, n8, w6)
    t36 = multiply(t30, t33, w4)
    t37 = multiply(t33, t36, w5)
    t38 = multiply(t35, t26, w3)
    t39 = subtract(t37, t38, w5)
    t40 = subtract(t36, t35, w4)
    t41 = divide(t39, t40, w5)
    t43 = multiply(t14, t41, w3)
    t44 = add(t43, t18, w3)
    t45 = sqrt(t44, w3)
    t46 = multiply(t45, n3, w4)
    t47 = add(t46, t16, w4)
    t48 = sqrt(t47, w4)
    t49 = multiply(t45, t48, w3)
    t50 = multiply(t48, t49, w4)
    t51 = multiply(t35, t41, w5)
    t52 = subtract(t50, t51, w4)
    t53 = subtract(t49, t35, w3)
    t54 = divide(t52, t53, w4)
    t56 = multiply(t14, t54, w3)
    t57 = add(t56, t18, w3)
    t58 = sqrt(t57, w3)
    t59 = multiply(t58, n3, w5)
    t60 = add(t59, t16, w5)
    t61 = sqrt(t60, w5)
    t62 = multiply(t58, t61, w3)
    t63 = multiply(t61, t62, w5)
    t64 = multiply(t35, t54, w4)
    t65 = subtract(t63, t64, w5)
    t66 = subtract(t62, t35, w3)
    t67 = divide(t65, t66, w5)
    t69 = multiply(t14, t67, w3)
    t70 = add(t69, t18, w3)
    t71 = sqrt(t70, w3)
    t72 = multiply(t71, n3, w4)
    t73 = add(t72, t16, w4)
    t74 = sqrt(t73, w4)
    t75 = multiply(t71, t74, w3)
    t76 = multiply(t74, t75, w4)
    t77 = multiply(t35, t67, w5)
    t78 = subtract(t76, t77, w4)
    t79 = subtract(t75, t35, w3)
    t80 = divide(t78, t79, w4)
    t82 = multiply(t14, t80, w0)
    t83 = add(t82, t18, w0)
    e = sqrt(t83, w0)
    t85 = multiply(e, n3, w2)
    t86 = add(t85, t16, w2)
    x = sqrt(t86, w2)
    t89 = multiply(p, n9, w1)
    t90 = add(e, t89, w1)
    t91 = multiply(x, r, w2)
    t92 = divide(t91, t10, w3)
    t93 = multiply(t92, p, w4)
    t95 = multiply(t93, n10, w4)
    t96 = add(t90, t95, w4)
    t97 = square(e, w5)
    t99 = multiply(t97, n11, w6)
    t100 = multiply(p, e, velocity)
    t102 = multiply(t100, n12, w7)
    t103 = add(t99, t102, w6)
    t105 = multiply(tracking_index, n13, w7)
    t106 = add(t103, t105, w6)
    t107 = divide(t96, t106, w4)
    t109 = multiply(t91, n14, w8)
    t110 = multiply(t107, t109, w4)
    t111 = divide(t110, tracking_index, w4)
    t112 = multiply(t111, n3, w4)
    t113 = multiply(t97, n14, w5)
    t115 = multiply(t100, n15, velocity)
    t116 = add(t113, t115, w5)
    t117 = add(t116, t105, w5)
    t118 = multiply(t90, n16, w1)
    t119 = multiply(t91, t118, w1)
    t120 = add(t117, t119, w5)
    t121 = divide(t120, t106, w5)
    t122 = multiply(t121, n3, w5)
    t123 = divide(t92, tracking_index, w3)
    t124 = multiply(t122, t123, w5)
    t125 = divide(t91, t106, w2)
    t126 = multiply(p, n12, w1)
    t127 = add(e, t126, w1)
    t128 = add(t127, t109, w1)
    t129 = multiply(t128, n8, w1)
    t130 = multiply(t125, t129, w2)
    t131 = add(t130, n17, w2)
    t132 = multiply(t10, p, w1)
    t133 = divide(t131, t132, w2)
    t134 = multiply(t133, n8, w1)
    t135 = add(t124, t134, w1)
    t136 = add(t112, t135, w4)
    t137 = multiply(e, n8, w0)
    t138 = add(t10, t137, acceleration)
    t139 = multiply(p, n16, w0)
    t140 = add(t109, t139, w8)
    t141 = add(t138, t140, acceleration)
    t142 = multiply(p, t141, acceleration)
    t143 = divide(t136, t142, w4)
    t145 = add(t124, t133, w5)
    t146 = divide(t145, t142, w5)
    t148 = divide(t133, t142, w2)
    divide(t143, t142, position)
    divide(t146, t142, velocity)
    divide(t148, t142, acceleration)


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
        delta = sqrt(64/Lambda^2 + 1/9),
        xi = sqrt(5/3 + 2 eta), eta = sqrt(7/9 + 2 delta xi), nu = 1 + xi + eta + delta

    tracking_index: Lambda, with Lambda^2 =
        jerk_deviation**2*sampling_interval**6/measurement_deviation**2; a number above 0 and
        finite.

    innovation_deviation: standard deviation of an innovation over sigma_v. Relative error at most
        5.00 * 2^-52 (float64), 4.99 * 2^-23 (float32), proved for 5e-324 <= tracking_index <=
        1.7976931348623157e308 (float64) and 1e-45 <= tracking_index <= 3.4028235e38 (float32).

    Outside an output's range, a few numbers next to its ends apart, its true value is no normal
    number: it comes as 0, a subnormal number or infinity, never as NaN. Numbers and arrays are
    taken, arrays of any shape; inputs are broadcast. float64 and float32 stay what they are,
    integers become float64. `out`: a tuple of arrays to fill. `workers`: threads that share the
    work on long arrays.

    ValueError: an input outside its domain, with its place; `out` or `workers` that does not fit.
    TypeError: an input that is no real number of these types; in `out` what is no array of the
    results' type.

    Source: derivation random-jerk
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
    t4 = 2.220446049250313e-16 / tracking_index
    t6 = tracking_index * 3.854941057726238e-19
    t10 = form.sqrt(t4 + t6) * 67108864.0
    t13 = (t10 * t2) * 2.0
    t15 = t1 * 0.4166666666666667
    t17 = tracking_index * 0.04861111111111111
    t24 = ((t1 * t2) * 1.2504627916220945) + (8.0 / t2)
    t25 = form.near_cbrt(t24)
    t29 = form.sqrt((t13 * t25) + t17)
    t32 = form.sqrt((t29 * 2.0) + t15)
    t34 = t13 * 0.5
    t35 = t29 * t32
    t40 = ((t32 * t35) - (t34 * t25)) / (t35 - t34)
    t44 = form.sqrt((t13 * t40) + t17)
    t47 = form.sqrt((t44 * 2.0) + t15)
    t48 = t44 * t47
    t53 = ((t47 * t48) - (t34 * t40)) / (t48 - t34)
    t57 = form.sqrt((t13 * t53) + t17)
    t60 = form.sqrt((t57 * 2.0) + t15)
    t61 = t57 * t60
    t66 = ((t60 * t61) - (t34 * t53)) / (t61 - t34)
    t70 = form.sqrt((t13 * t66) + t17)
    t73 = form.sqrt((t70 * 2.0) + t15)
    t74 = t70 * t73
    t79 = ((t73 * t74) - (t34 * t66)) / (t74 - t34)
    t83 = form.sqrt((t13 * t79) + t17)
    t91 = (form.sqrt((t83 * 2.0) + t15) * t2) * 0.25
    t94 = (t10 + (t83 * 0.5)) + (t91 + (t1 * 0.125))
    t95 = t1 * t94
    return (t95,)


def _innovation_deviation_block(
    given: Arrays,
    out: Arrays,
    work: Arrays,
    single: bool,
    n0: float = 2.220446049250313e-16,
    n1: float = 3.854941057726238e-19,
    n2: float = 67108864.0,
    n3: float = 2.0,
    n4: float = 0.4166666666666667,
    n5: float = 0.04861111111111111,
    n6: float = 1.2504627916220945,
    n7: float = 8.0,
    n8: float = 0.5,
    n9: float = 0.25,
    n10: float = 0.125,
) -> None:
    (tracking_index,) = given
    (innovation_deviation,) = out
    w0, w1, w2, w3, w4, w5, w6, w7, w8 = work
    p = sqrt(tracking_index, innovation_deviation)
    r = sqrt(p, w0)
    t4 = divide(n0, tracking_index, w1)
    t6 = multiply(tracking_index, n1, w2)
    t7 = add(t4, t6, w1)
    c_scaled = sqrt(t7, w1)
    t10 = multiply(c_scaled, n2, w1)
    t11 = multiply(t10, r, w2)
    t13 = multiply(t11, n3, w2)
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
    t34 = multiply(t13, n8, w8)
    t35 = multiply(t29, t32, w6)
    t36 = multiply(t32, t35, w7)
    t37 = multiply(t34, t25, w5)
    t38 = subtract(t36, t37, w7)
    t39 = subtract(t35, t34, w6)
    t40 = divide(t38, t39, w7)
    t42 = multiply(t13, t40, w5)
    t43 = add(t42, t17, w5)
    t44 = sqrt(t43, w5)
    t45 = multiply(t44, n3, w6)
    t46 = add(t45, t15, w6)
    t47 = sqrt(t46, w6)
    t48 = multiply(t44, t47, w5)
    t49 = multiply(t47, t48, w6)
    t50 = multiply(t34, t40, w7)
    t51 = subtract(t49, t50, w6)
    t52 = subtract(t48, t34, w5)
    t53 = divide(t51, t52, w6)
    t55 = multiply(t13, t53, w5)
    t56 = add(t55, t17, w5)
    t57 = sqrt(t56, w5)
    t58 = multiply(t57, n3, w7)
    t59 = add(t58, t15, w7)
    t60 = sqrt(t59, w7)
    t61 = multiply(t57, t60, w5)
    t62 = multiply(t60, t61, w7)
    t63 = multiply(t34, t53, w6)
    t64 = subtract(t62, t63, w7)
    t65 = subtract(t61, t34, w5)
    t66 = divide(t64, t65, w7)
    t68 = multiply(t13, t66, w5)
    t69 = add(t68, t17, w5)
    t70 = sqrt(t69, w5)
    t71 = multiply(t70, n3, w6)
    t72 = add(t71, t15, w6)
    t73 = sqrt(t72, w6)
    t74 = multiply(t70, t73, w5)
    t75 = multiply(t73, t74, w6)
    t76 = multiply(t34, t66, w7)
    t77 = subtract(t75, t76, w6)
    t78 = subtract(t74, t34, w5)
    t79 = divide(t77, t78, w6)
    t81 = multiply(t13, t79, w2)
    t82 = add(t81, t17, w2)
    e = sqrt(t82, w2)
    t84 = multiply(e, n3, w4)
    t85 = add(t84, t15, w4)
    x = sqrt(t85, w4)
    t87 = multiply(e, n8, w2)
    t88 = add(t10, t87, w1)
    t89 = multiply(x, r, w4)
    t91 = multiply(t89, n9, w4)
    t92 = multiply(p, n10, w0)
    t93 = add(t91, t92, w4)
    t94 = add(t88, t93, w1)
    multiply(p, t94, innovation_deviation)


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
        delta = sqrt(64/Lambda^2 + 1/9),
        xi = sqrt(5/3 + 2 eta), eta = sqrt(7/9 + 2 delta xi), nu = 1 + xi + eta + delta

    tracking_index: Lambda, with Lambda^2 =
        jerk_deviation**2*sampling_interval**6/measurement_deviation**2; a number above 0 and
        finite.

    pole_product: product of the poles, and what is left of 1 beside the position gain. Relative
        error at most 9.49 * 2^-52 (float64), 9.49 * 2^-23 (float32), proved for 5e-324 <=
        tracking_index <= 1.0777833921299165e154 (float64) and 1e-45 <= tracking_index <=
        1.482837e19 (float32).

    Outside an output's range, a few numbers next to its ends apart, its true value is no normal
    number: it comes as 0, a subnormal number or infinity, never as NaN. Numbers and arrays are
    taken, arrays of any shape; inputs are broadcast. float64 and float32 stay what they are,
    integers become float64. `out`: a tuple of arrays to fill. `workers`: threads that share the
    work on long arrays.

    ValueError: an input outside its domain, with its place; `out` or `workers` that does not fit.
    TypeError: an input that is no real number of these types; in `out` what is no array of the
    results' type.

    Source: derivation random-jerk
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
    t4 = 2.220446049250313e-16 / tracking_index
    t6 = tracking_index * 3.854941057726238e-19
    t10 = form.sqrt(t4 + t6) * 67108864.0
    t14 = (t10 * t2) * 2.0
    t16 = t1 * 0.4166666666666667
    t18 = tracking_index * 0.04861111111111111
    t25 = ((t1 * t2) * 1.2504627916220945) + (8.0 / t2)
    t26 = form.near_cbrt(t25)
    t30 = form.sqrt((t14 * t26) + t18)
    t33 = form.sqrt((t30 * 2.0) + t16)
    t35 = t14 * 0.5
    t36 = t30 * t33
    t41 = ((t33 * t36) - (t35 * t26)) / (t36 - t35)
    t45 = form.sqrt((t14 * t41) + t18)
    t48 = form.sqrt((t45 * 2.0) + t16)
    t49 = t45 * t48
    t54 = ((t48 * t49) - (t35 * t41)) / (t49 - t35)
    t58 = form.sqrt((t14 * t54) + t18)
    t61 = form.sqrt((t58 * 2.0) + t16)
    t62 = t58 * t61
    t67 = ((t61 * t62) - (t35 * t54)) / (t62 - t35)
    t71 = form.sqrt((t14 * t67) + t18)
    t74 = form.sqrt((t71 * 2.0) + t16)
    t75 = t71 * t74
    t80 = ((t74 * t75) - (t35 * t67)) / (t75 - t35)
    t84 = form.sqrt((t14 * t80) + t18)
    t92 = (form.sqrt((t84 * 2.0) + t16) * t2) * 0.25
    t95 = (t10 + (t84 * 0.5)) + (t92 + (t1 * 0.125))
    t98 = ((1.0 / t95) / tracking_index) / t95
    return (t98,)


def _pole_product_block(
    given: Arrays,
    out: Arrays,
    work: Arrays,
    single: bool,
    n0: float = 2.220446049250313e-16,
    n1: float = 3.854941057726238e-19,
    n2: float = 67108864.0,
    n3: float = 2.0,
    n4: float = 0.4166666666666667,
    n5: float = 0.04861111111111111,
    n6: float = 1.2504627916220945,
    n7: float = 8.0,
    n8: float = 0.5,
    n9: float = 0.25,
    n10: float = 0.125,
    n11: float = 1.0,
) -> None:
    (tracking_index,) = given
    (pole_product,) = out
    w0, w1, w2, w3, w4, w5, w6, w7, w8 = work
    p = sqrt(tracking_index, pole_product)
    r = sqrt(p, w0)
    t4 = divide(n0, tracking_index, w1)
    t6 = multiply(tracking_index, n1, w2)
    t7 = add(t4, t6, w1)
    c_scaled = sqrt(t7, w1)
    t10 = multiply(c_scaled, n2, w1)
    t12 = multiply(t10, r, w2)
    t14 = multiply(t12, n3, w2)
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
    t35 = multiply(t14, n8, w8)
    t36 = multiply(t30, t33, w6)
    t37 = multiply(t33, t36, w7)
    t38 = multiply(t35, t26, w5)
    t39 = subtract(t37, t38, w7)
    t40 = subtract(t36, t35, w6)
    t41 = divide(t39, t40, w7)
    t43 = multiply(t14, t41, w5)
    t44 = add(t43, t18, w5)
    t45 = sqrt(t44, w5)
    t46 = multiply(t45, n3, w6)
    t47 = add(t46, t16, w6)
    t48 = sqrt(t47, w6)
    t49 = multiply(t45, t48, w5)
    t50 = multiply(t48, t49, w6)
    t51 = multiply(t35, t41, w7)
    t52 = subtract(t50, t51, w6)
    t53 = subtract(t49, t35, w5)
    t54 = divide(t52, t53, w6)
    t56 = multiply(t14, t54, w5)
    t57 = add(t56, t18, w5)
    t58 = sqrt(t57, w5)
    t59 = multiply(t58, n3, w7)
    t60 = add(t59, t16, w7)
    t61 = sqrt(t60, w7)
    t62 = multiply(t58, t61, w5)
    t63 = multiply(t61, t62, w7)
    t64 = multiply(t35, t54, w6)
    t65 = subtract(t63, t64, w7)
    t66 = subtract(t62, t35, w5)
    t67 = divide(t65, t66, w7)
    t69 = multiply(t14, t67, w5)
    t70 = add(t69, t18, w5)
    t71 = sqrt(t70, w5)
    t72 = multiply(t71, n3, w6)
    t73 = add(t72, t16, w6)
    t74 = sqrt(t73, w6)
    t75 = multiply(t71, t74, w5)
    t76 = multiply(t74, t75, w6)
    t77 = multiply(t35, t67, w7)
    t78 = subtract(t76, t77, w6)
    t79 = subtract(t75, t35, w5)
    t80 = divide(t78, t79, w6)
    t82 = multiply(t14, t80, w2)
    t83 = add(t82, t18, w2)
    e = sqrt(t83, w2)
    t85 = multiply(e, n3, w4)
    t86 = add(t85, t16, w4)
    x = sqrt(t86, w4)
    t88 = multiply(e, n8, w2)
    t89 = add(t10, t88, w1)
    t90 = multiply(x, r, w4)
    t92 = multiply(t90, n9, w4)
    t93 = multiply(p, n10, pole_product)
    t94 = add(t92, t93, w4)
    t95 = add(t89, t94, w1)
    t96 = divide(n11, t95, w0)
    t97 = divide(t96, tracking_index, w0)
    divide(t97, t95, pole_product)


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
        delta = sqrt(64/Lambda^2 + 1/9),
        xi = sqrt(5/3 + 2 eta), eta = sqrt(7/9 + 2 delta xi), nu = 1 + xi + eta + delta

    tracking_index: Lambda, with Lambda^2 =
        jerk_deviation**2*sampling_interval**6/measurement_deviation**2; a number above 0 and
        finite.

    predicted_11: variance of the predicted position over sigma_v^2. Relative error at most 9.40 *
        2^-52 (float64), 9.40 * 2^-23 (float32), proved for 5e-324 <= tracking_index <=
        2.1555667842597914e154 (float64) and 1e-45 <= tracking_index <= 2.9656443e19 (float32).
    predicted_12: covariance of predicted position and velocity times T/sigma_v^2. Relative error at
        most 8.94 * 2^-52 (float64), 8.96 * 2^-23 (float32), proved for 5e-324 <= tracking_index <=
        1.6378765654858363e154 (float64) and 1e-45 <= tracking_index <= 2.2534018e19 (float32).
    predicted_13: covariance of predicted position and acceleration times T^2/sigma_v^2. Relative
        error at most 5.50 * 2^-52 (float64), 5.50 * 2^-23 (float32), proved for
        2.2250738585072014e-308 <= tracking_index <= 1.7000419237042145e154 (float64) and
        1.1754944e-38 <= tracking_index <= 2.338941e19 (float32).
    predicted_22: variance of the predicted velocity times T^2/sigma_v^2. Relative error at most
        6.12 * 2^-52 (float64), 6.12 * 2^-23 (float32), proved for 7.416912861690675e-309 <=
        tracking_index <= 1.2194984436716381e154 (float64) and 3.918315e-39 <= tracking_index <=
        1.6777945e19 (float32).
    predicted_23: covariance of predicted velocity and acceleration times T^3/sigma_v^2. Relative
        error at most 6.57 * 2^-52 (float64), 6.56 * 2^-23 (float32), proved for
        1.0832677820940206e-231 <= tracking_index <= 1.2021111725526733e154 (float64) and
        2.122721e-29 <= tracking_index <= 1.653881e19 (float32).
    predicted_33: variance of the predicted acceleration times T^4/sigma_v^2. Relative error at most
        6.26 * 2^-52 (float64), 6.26 * 2^-23 (float32), proved for 1.6896185209462645e-185 <=
        tracking_index <= 1.0675634778755782e154 (float64) and 1.1521641e-23 <= tracking_index <=
        1.4687685e19 (float32).

    Outside an output's range, a few numbers next to its ends apart, its true value is no normal
    number: it comes as 0, a subnormal number or infinity, never as NaN. Numbers and arrays are
    taken, arrays of any shape; inputs are broadcast. float64 and float32 stay what they are,
    integers become float64. `out`: a tuple of arrays to fill. `workers`: threads that share the
    work on long arrays.

    ValueError: an input outside its domain, with its place; `out` or `workers` that does not fit.
    TypeError: an input that is no real number of these types; in `out` what is no array of the
    results' type.

    Source: derivation random-jerk
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
    t4 = 2.220446049250313e-16 / tracking_index
    t6 = tracking_index * 3.854941057726238e-19
    t10 = form.sqrt(t4 + t6) * 67108864.0
    t13 = (t10 * t2) * 2.0
    t15 = t1 * 0.4166666666666667
    t17 = tracking_index * 0.04861111111111111
    t18 = t1 * t2
    t24 = (t18 * 1.2504627916220945) + (8.0 / t2)
    t25 = form.near_cbrt(t24)
    t29 = form.sqrt((t13 * t25) + t17)
    t32 = form.sqrt((t29 * 2.0) + t15)
    t34 = t13 * 0.5
    t35 = t29 * t32
    t40 = ((t32 * t35) - (t34 * t25)) / (t35 - t34)
    t44 = form.sqrt((t13 * t40) + t17)
    t47 = form.sqrt((t44 * 2.0) + t15)
    t48 = t44 * t47
    t53 = ((t47 * t48) - (t34 * t40)) / (t48 - t34)
    t57 = form.sqrt((t13 * t53) + t17)
    t60 = form.sqrt((t57 * 2.0) + t15)
    t61 = t57 * t60
    t66 = ((t60 * t61) - (t34 * t53)) / (t61 - t34)
    t70 = form.sqrt((t13 * t66) + t17)
    t73 = form.sqrt((t70 * 2.0) + t15)
    t74 = t70 * t73
    t79 = ((t73 * t74) - (t34 * t66)) / (t74 - t34)
    t83 = form.sqrt((t13 * t79) + t17)
    t86 = form.sqrt((t83 * 2.0) + t15)
    t92 = t86 * t2
    t96 = (t10 + (t83 * 0.5)) + ((t92 * 0.25) + (t1 * 0.125))
    t108 = ((t10 * 3.0) + t83) + (t1 * 0.20833333333333334)
    t114 = (t83 * 0.9166666666666666) + (t1 * 0.2013888888888889)
    t122 = (t1 * 0.3333333333333333) + (t92 * 0.5)
    t98 = (((t1 * 0.25) + t83) * t96) * tracking_index
    t100 = (t92 * t96) * tracking_index
    t102 = tracking_index * (t1 * t96)
    t118 = ((t108 + ((t2 / t86) * t114)) * t1) * tracking_index
    t125 = ((t122 + t83) * t1) * tracking_index
    t129 = tracking_index * ((t18 * t86) + (tracking_index * 0.5))
    return (t98, t100, t102, t118, t125, t129)


def _predicted_covariance_block(
    given: Arrays,
    out: Arrays,
    work: Arrays,
    single: bool,
    n0: float = 2.220446049250313e-16,
    n1: float = 3.854941057726238e-19,
    n2: float = 67108864.0,
    n3: float = 2.0,
    n4: float = 0.4166666666666667,
    n5: float = 0.04861111111111111,
    n6: float = 1.2504627916220945,
    n7: float = 8.0,
    n8: float = 0.5,
    n9: float = 0.25,
    n10: float = 0.125,
    n11: float = 3.0,
    n12: float = 0.20833333333333334,
    n13: float = 0.9166666666666666,
    n14: float = 0.2013888888888889,
    n15: float = 0.3333333333333333,
) -> None:
    (tracking_index,) = given
    predicted_11, predicted_12, predicted_13, predicted_22, predicted_23, predicted_33 = out
    w0, w1, w2, w3, w4, w5 = work
    p = sqrt(tracking_index, predicted_11)
    r = sqrt(p, predicted_12)
    t4 = divide(n0, tracking_index, predicted_13)
    t6 = multiply(tracking_index, n1, w0)
    t7 = add(t4, t6, predicted_13)
    c_scaled = sqrt(t7, predicted_22)
    t10 = multiply(c_scaled, n2, predicted_22)
    t11 = multiply(t10, r, w0)
    t13 = multiply(t11, n3, w0)
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
    t34 = multiply(t13, n8, w4)
    t35 = multiply(t29, t32, predicted_33)
    t36 = multiply(t32, t35, predicted_23)
    t37 = multiply(t34, t25, w3)
    t38 = subtract(t36, t37, predicted_23)
    t39 = subtract(t35, t34, predicted_33)
    t40 = divide(t38, t39, predicted_23)
    t42 = multiply(t13, t40, w3)
    t43 = add(t42, t17, w3)
    t44 = sqrt(t43, w3)
    t45 = multiply(t44, n3, predicted_33)
    t46 = add(t45, t15, predicted_33)
    t47 = sqrt(t46, predicted_33)
    t48 = multiply(t44, t47, w3)
    t49 = multiply(t47, t48, predicted_33)
    t50 = multiply(t34, t40, predicted_23)
    t51 = subtract(t49, t50, predicted_33)
    t52 = subtract(t48, t34, w3)
    t53 = divide(t51, t52, predicted_33)
    t55 = multiply(t13, t53, w3)
    t56 = add(t55, t17, w3)
    t57 = sqrt(t56, w3)
    t58 = multiply(t57, n3, predicted_23)
    t59 = add(t58, t15, predicted_23)
    t60 = sqrt(t59, predicted_23)
    t61 = multiply(t57, t60, w3)
    t62 = multiply(t60, t61, predicted_23)
    t63 = multiply(t34, t53, predicted_33)
    t64 = subtract(t62, t63, predicted_23)
    t65 = subtract(t61, t34, w3)
    t66 = divide(t64, t65, predicted_23)
    t68 = multiply(t13, t66, w3)
    t69 = add(t68, t17, w3)
    t70 = sqrt(t69, w3)
    t71 = multiply(t70, n3, predicted_33)
    t72 = add(t71, t15, predicted_33)
    t73 = sqrt(t72, predicted_33)
    t74 = multiply(t70, t73, w3)
    t75 = multiply(t73, t74, predicted_33)
    t76 = multiply(t34, t66, predicted_23)
    t77 = subtract(t75, t76, predicted_33)
    t78 = subtract(t74, t34, w3)
    t79 = divide(t77, t78, predicted_33)
    t81 = multiply(t13, t79, w0)
    t82 = add(t81, t17, w0)
    e = sqrt(t82, w0)
    t84 = multiply(e, n3, w1)
    t85 = add(t84, t15, w1)
    x = sqrt(t85, w1)
    t88 = multiply(p, n9, w3)
    t89 = add(t88, e, w3)
    t90 = multiply(e, n8, w4)
    t91 = add(t10, t90, w4)
    t92 = multiply(x, r, predicted_13)
    t93 = multiply(t92, n9, predicted_23)
    t94 = multiply(p, n10, predicted_33)
    t95 = add(t93, t94, predicted_23)
    t96 = add(t91, t95, w4)
    t97 = multiply(t89, t96, w3)
    t99 = multiply(t92, t96, predicted_23)
    t101 = multiply(p, t96, w4)
    t104 = multiply(t10, n11, predicted_22)
    t105 = add(t104, e, predicted_22)
    t107 = multiply(p, n12, predicted_33)
    t108 = add(t105, t107, predicted_22)
    t109 = divide(r, x, predicted_12)
    t111 = multiply(e, n13, predicted_33)
    t113 = multiply(p, n14, w5)
    t114 = add(t111, t113, predicted_33)
    t115 = multiply(t109, t114, predicted_12)
    t116 = add(t108, t115, predicted_22)
    t117 = multiply(t116, p, predicted_22)
    t120 = multiply(p, n15, w5)
    t121 = multiply(t92, n8, predicted_13)
    t122 = add(t120, t121, w5)
    t123 = add(t122, e, w5)
    t124 = multiply(t123, p, w5)
    t126 = multiply(t18, x, w2)
    t127 = multiply(tracking_index, n8, w0)
    t128 = add(t126, t127, w2)
    multiply(t97, tracking_index, predicted_11)
    multiply(t99, tracking_index, predicted_12)
    multiply(tracking_index, t101, predicted_13)
    multiply(t117, tracking_index, predicted_22)
    multiply(t124, tracking_index, predicted_23)
    multiply(tracking_index, t128, predicted_33)


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

        delta = sqrt(64/Lambda^2 + 1/9),
        xi = sqrt(5/3 + 2 eta), eta = sqrt(7/9 + 2 delta xi), nu = 1 + xi + eta + delta

    tracking_index: Lambda, with Lambda^2 =
        jerk_deviation**2*sampling_interval**6/measurement_deviation**2; a number above 0 and at
        most 2^1000, in float32 above 0 and at most 2^120.

    predicted_11: derivative of the variance of the predicted position over sigma_v^2. Relative
        error at most 13.42 * 2^-52 (float64), 13.31 * 2^-23 (float32), proved for 5e-324 <=
        tracking_index <= 1.0715086071862673e301 (float64) and 1e-45 <= tracking_index <=
        1.329228e36 (float32).
    predicted_12: derivative of the covariance of predicted position and velocity times T/sigma_v^2.
        Relative error at most 12.56 * 2^-52 (float64), 12.54 * 2^-23 (float32), proved for 5e-324
        <= tracking_index <= 1.0715086071862673e301 (float64) and 1e-45 <= tracking_index <=
        1.329228e36 (float32).
    predicted_13: derivative of the covariance of predicted position and acceleration times
        T^2/sigma_v^2. Relative error at most 8.15 * 2^-52 (float64), 8.13 * 2^-23 (float32), proved
        for 5e-324 <= tracking_index <= 1.0715086071862673e301 (float64) and 1e-45 <= tracking_index
        <= 1.329228e36 (float32).
    predicted_22: derivative of the variance of the predicted velocity times T^2/sigma_v^2. Relative
        error at most 7.17 * 2^-52 (float64), 7.17 * 2^-23 (float32), proved for 5e-324 <=
        tracking_index <= 1.0715086071862673e301 (float64) and 1e-45 <= tracking_index <=
        1.329228e36 (float32).
    predicted_23: derivative of the covariance of predicted velocity and acceleration times
        T^3/sigma_v^2. Relative error at most 8.59 * 2^-52 (float64), 8.59 * 2^-23 (float32), proved
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

    Source: derivation random-jerk
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
    t4 = 2.220446049250313e-16 / tracking_index
    t6 = tracking_index * 3.854941057726238e-19
    t10 = form.sqrt(t4 + t6) * 67108864.0
    t14 = (t10 * t2) * 2.0
    t16 = t1 * 0.4166666666666667
    t18 = tracking_index * 0.04861111111111111
    t19 = t1 * t2
    t25 = (t19 * 1.2504627916220945) + (8.0 / t2)
    t26 = form.near_cbrt(t25)
    t30 = form.sqrt((t14 * t26) + t18)
    t33 = form.sqrt((t30 * 2.0) + t16)
    t35 = t14 * 0.5
    t36 = t30 * t33
    t41 = ((t33 * t36) - (t35 * t26)) / (t36 - t35)
    t45 = form.sqrt((t14 * t41) + t18)
    t48 = form.sqrt((t45 * 2.0) + t16)
    t49 = t45 * t48
    t54 = ((t48 * t49) - (t35 * t41)) / (t49 - t35)
    t58 = form.sqrt((t14 * t54) + t18)
    t61 = form.sqrt((t58 * 2.0) + t16)
    t62 = t58 * t61
    t67 = ((t61 * t62) - (t35 * t54)) / (t62 - t35)
    t71 = form.sqrt((t14 * t67) + t18)
    t74 = form.sqrt((t71 * 2.0) + t16)
    t75 = t71 * t74
    t80 = ((t74 * t75) - (t35 * t67)) / (t75 - t35)
    t84 = form.sqrt((t14 * t80) + t18)
    t87 = form.sqrt((t84 * 2.0) + t16)
    t91 = t87 * t2
    t92 = t91 / t10
    t96 = (t84 + (t1 * 0.16666666666666666)) + ((t92 * t1) * 0.006944444444444444)
    t97 = t84 * t84
    t100 = t1 * t84
    t103 = (t97 * 0.75) + (t100 * 0.20833333333333334)
    t105 = tracking_index * 0.012152777777777778
    t106 = t103 + t105
    t109 = t91 * 0.25
    t110 = (t96 / t106) * t109
    t116 = (t10 + (t84 * 0.5)) + (t109 + (t1 * 0.125))
    t123 = (t97 * 0.25) + (t100 * 0.10416666666666667)
    t124 = t123 + t105
    t130 = ((tracking_index / t106) * t92) * 0.0008680555555555555
    t131 = ((t124 / t106) * 2.0) + t130
    t134 = t1 * t116
    t141 = ((tracking_index / t10) / t10) * 0.001736111111111111
    t149 = ((t1 * 0.25) / t84) * 1.6666666666666667
    t150 = t149 + 2.0
    t152 = (tracking_index * t150) * 0.012152777777777778
    t156 = ((t124 + t152) / t106) + (t130 * t150)
    t157 = 1.0 + t156
    t158 = t157 * t84
    t160 = ((((1.0 + t141) * t10) * 3.0) + t158) + t16
    t164 = ((t91 / t106) / tracking_index) / t10
    t165 = t164 * 0.5
    t169 = ((t157 + t165) * t84) * 0.9166666666666666
    t173 = ((2.0 + t165) * t1) * 0.2013888888888889
    t178 = 1.0 + t131
    t184 = (((t178 * t91) * 0.5) + t158) + (t1 * 0.6666666666666666)
    t118 = ((t110 * 2.0) * t116) * t116
    t135 = ((t87 / t2) * (t131 + t110)) * t134
    t137 = t134 * (t110 + 1.0)
    t177 = (t160 + ((t2 / t87) * (t169 + t173))) * t1
    t185 = t184 * t1
    t188 = ((t19 * t87) * t178) + tracking_index
    return (t118, t135, t137, t177, t185, t188)


def _predicted_covariance_derivatives_block(
    given: Arrays,
    out: Arrays,
    work: Arrays,
    single: bool,
    n0: float = 2.220446049250313e-16,
    n1: float = 3.854941057726238e-19,
    n2: float = 67108864.0,
    n3: float = 2.0,
    n4: float = 0.4166666666666667,
    n5: float = 0.04861111111111111,
    n6: float = 1.2504627916220945,
    n7: float = 8.0,
    n8: float = 0.5,
    n9: float = 0.16666666666666666,
    n10: float = 0.006944444444444444,
    n11: float = 0.75,
    n12: float = 0.20833333333333334,
    n13: float = 0.012152777777777778,
    n14: float = 0.25,
    n15: float = 0.125,
    n16: float = 0.10416666666666667,
    n17: float = 0.0008680555555555555,
    n18: float = 1.0,
    n19: float = 0.001736111111111111,
    n20: float = 3.0,
    n21: float = 1.6666666666666667,
    n22: float = 0.9166666666666666,
    n23: float = 0.2013888888888889,
    n24: float = 0.6666666666666666,
) -> None:
    (tracking_index,) = given
    predicted_11, predicted_12, predicted_13, predicted_22, predicted_23, predicted_33 = out
    w0, w1, w2, w3, w4, w5, w6, w7, w8, w9, w10, w11, w12, w13 = work
    p = sqrt(tracking_index, predicted_23)
    r = sqrt(p, predicted_11)
    t4 = divide(n0, tracking_index, predicted_12)
    t6 = multiply(tracking_index, n1, w0)
    t7 = add(t4, t6, predicted_12)
    c_scaled = sqrt(t7, predicted_13)
    t10 = multiply(c_scaled, n2, predicted_13)
    t12 = multiply(t10, r, w0)
    t14 = multiply(t12, n3, w0)
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
    t35 = multiply(t14, n8, w4)
    t36 = multiply(t30, t33, predicted_33)
    t37 = multiply(t33, t36, predicted_22)
    t38 = multiply(t35, t26, w3)
    t39 = subtract(t37, t38, predicted_22)
    t40 = subtract(t36, t35, predicted_33)
    t41 = divide(t39, t40, predicted_22)
    t43 = multiply(t14, t41, w3)
    t44 = add(t43, t18, w3)
    t45 = sqrt(t44, w3)
    t46 = multiply(t45, n3, predicted_33)
    t47 = add(t46, t16, predicted_33)
    t48 = sqrt(t47, predicted_33)
    t49 = multiply(t45, t48, w3)
    t50 = multiply(t48, t49, predicted_33)
    t51 = multiply(t35, t41, predicted_22)
    t52 = subtract(t50, t51, predicted_33)
    t53 = subtract(t49, t35, w3)
    t54 = divide(t52, t53, predicted_33)
    t56 = multiply(t14, t54, w3)
    t57 = add(t56, t18, w3)
    t58 = sqrt(t57, w3)
    t59 = multiply(t58, n3, predicted_22)
    t60 = add(t59, t16, predicted_22)
    t61 = sqrt(t60, predicted_22)
    t62 = multiply(t58, t61, w3)
    t63 = multiply(t61, t62, predicted_22)
    t64 = multiply(t35, t54, predicted_33)
    t65 = subtract(t63, t64, predicted_22)
    t66 = subtract(t62, t35, w3)
    t67 = divide(t65, t66, predicted_22)
    t69 = multiply(t14, t67, w3)
    t70 = add(t69, t18, w3)
    t71 = sqrt(t70, w3)
    t72 = multiply(t71, n3, predicted_33)
    t73 = add(t72, t16, predicted_33)
    t74 = sqrt(t73, predicted_33)
    t75 = multiply(t71, t74, w3)
    t76 = multiply(t74, t75, predicted_33)
    t77 = multiply(t35, t67, predicted_22)
    t78 = subtract(t76, t77, predicted_33)
    t79 = subtract(t75, t35, w3)
    t80 = divide(t78, t79, predicted_33)
    t82 = multiply(t14, t80, w0)
    t83 = add(t82, t18, w0)
    e = sqrt(t83, w0)
    t85 = multiply(e, n3, w1)
    t86 = add(t85, t16, w1)
    x = sqrt(t86, w1)
    t89 = multiply(p, n9, w3)
    t90 = add(e, t89, w3)
    t91 = multiply(x, r, w4)
    t92 = divide(t91, t10, predicted_22)
    t93 = multiply(t92, p, predicted_33)
    t95 = multiply(t93, n10, predicted_33)
    t96 = add(t90, t95, w3)
    t97 = square(e, predicted_33)
    t99 = multiply(t97, n11, w5)
    t100 = multiply(p, e, w6)
    t102 = multiply(t100, n12, w7)
    t103 = add(t99, t102, w5)
    t105 = multiply(tracking_index, n13, w7)
    t106 = add(t103, t105, w5)
    t107 = divide(t96, t106, w3)
    t109 = multiply(t91, n14, w8)
    t110 = multiply(t107, t109, w3)
    t111 = multiply(t110, n3, w9)
    t112 = multiply(e, n8, w10)
    t113 = add(t10, t112, w10)
    t114 = multiply(p, n15, w11)
    t115 = add(t109, t114, w8)
    t116 = add(t113, t115, w10)
    t117 = multiply(t111, t116, w9)
    t119 = divide(x, r, w8)
    t120 = multiply(t97, n14, predicted_33)
    t122 = multiply(t100, n16, w6)
    t123 = add(t120, t122, predicted_33)
    t124 = add(t123, t105, predicted_33)
    t125 = divide(t124, t106, w6)
    t126 = multiply(t125, n3, w6)
    t127 = divide(tracking_index, t106, w7)
    t128 = multiply(t127, t92, w7)
    t130 = multiply(t128, n17, w7)
    t131 = add(t126, t130, w6)
    t132 = add(t131, t110, w11)
    t133 = multiply(t119, t132, w8)
    t134 = multiply(p, t116, w11)
    t136 = add(t110, n18, w3)
    t138 = divide(tracking_index, t10, predicted_22)
    t139 = divide(t138, t10, predicted_22)
    t141 = multiply(t139, n19, predicted_22)
    t142 = add(n18, t141, predicted_22)
    t143 = multiply(t142, t10, predicted_22)
    t145 = multiply(t143, n20, predicted_22)
    t146 = multiply(p, n14, w12)
    t147 = divide(t146, e, w12)
    t149 = multiply(t147, n21, w12)
    t150 = add(t149, n3, w12)
    t151 = multiply(tracking_index, t150, w13)
    t152 = multiply(t151, n13, w13)
    t153 = add(t124, t152, predicted_33)
    t154 = divide(t153, t106, predicted_33)
    t155 = multiply(t130, t150, w7)
    t156 = add(t154, t155, predicted_33)
    t157 = add(n18, t156, predicted_33)
    t158 = multiply(t157, e, w7)
    t159 = add(t145, t158, predicted_22)
    t160 = add(t159, t16, predicted_22)
    t161 = divide(r, x, predicted_11)
    t162 = divide(t91, t106, w5)
    t163 = divide(t162, tracking_index, w5)
    t164 = divide(t163, t10, w5)
    t165 = multiply(t164, n8, w5)
    t166 = add(t157, t165, predicted_33)
    t167 = multiply(t166, e, predicted_33)
    t169 = multiply(t167, n22, predicted_33)
    t170 = add(n3, t165, w5)
    t171 = multiply(t170, p, w5)
    t173 = multiply(t171, n23, w5)
    t174 = add(t169, t173, predicted_33)
    t175 = multiply(t161, t174, predicted_11)
    t176 = add(t160, t175, predicted_22)
    t178 = add(n18, t131, w6)
    t179 = multiply(t178, t91, w4)
    t180 = multiply(t179, n8, w4)
    t181 = add(t180, t158, w4)
    t183 = multiply(p, n24, w0)
    t184 = add(t181, t183, w4)
    t186 = multiply(t19, x, w2)
    t187 = multiply(t186, t178, w2)
    multiply(t117, t116, predicted_11)
    multiply(t133, t134, predicted_12)
    multiply(t134, t136, predicted_13)
    multiply(t176, p, predicted_22)
    multiply(t184, p, predicted_23)
    add(t187, tracking_index, predicted_33)


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
        delta = sqrt(64/Lambda^2 + 1/9),
        xi = sqrt(5/3 + 2 eta), eta = sqrt(7/9 + 2 delta xi), nu = 1 + xi + eta + delta

    tracking_index: Lambda, with Lambda^2 =
        jerk_deviation**2*sampling_interval**6/measurement_deviation**2; a number above 0 and
        finite.

    updated_11: variance of the updated position over sigma_v^2. Relative error at most 6.18 * 2^-52
        (float64), 6.18 * 2^-23 (float32), proved for 5e-324 <= tracking_index <=
        1.7976931348623157e308 (float64) and 1e-45 <= tracking_index <= 3.4028235e38 (float32).
    updated_12: covariance of updated position and velocity times T/sigma_v^2. Relative error at
        most 6.09 * 2^-52 (float64), 6.09 * 2^-23 (float32), proved for 5e-324 <= tracking_index <=
        1.7976931348623157e308 (float64) and 1e-45 <= tracking_index <= 3.4028235e38 (float32).
    updated_13: covariance of updated position and acceleration times T^2/sigma_v^2. Relative error
        at most 4.60 * 2^-52 (float64), 4.60 * 2^-23 (float32), proved for 2.2250738585072014e-308
        <= tracking_index <= 1.7976931348623157e308 (float64) and 1.1754945e-38 <= tracking_index <=
        3.4028235e38 (float32).
    updated_22: variance of the updated velocity times T^2/sigma_v^2. Relative error at most 8.38 *
        2^-52 (float64), 8.32 * 2^-23 (float32), proved for 7.416912861690675e-309 <= tracking_index
        <= 6.11263855891949e154 (float64) and 3.918315e-39 <= tracking_index <= 8.409764e19
        (float32).
    updated_23: covariance of updated velocity and acceleration times T^3/sigma_v^2. Relative error
        at most 9.01 * 2^-52 (float64), 9.02 * 2^-23 (float32), proved for 1.0832677820940206e-231
        <= tracking_index <= 3.284228799760066e154 (float64) and 2.122721e-29 <= tracking_index <=
        4.518462e19 (float32).
    updated_33: variance of the updated acceleration times T^4/sigma_v^2. Relative error at most
        6.55 * 2^-52 (float64), 6.56 * 2^-23 (float32), proved for 1.6896185209462645e-185 <=
        tracking_index <= 1.764566758725546e154 (float64) and 1.1521641e-23 <= tracking_index <=
        2.4277036e19 (float32).

    Outside an output's range, a few numbers next to its ends apart, its true value is no normal
    number: it comes as 0, a subnormal number or infinity, never as NaN. Numbers and arrays are
    taken, arrays of any shape; inputs are broadcast. float64 and float32 stay what they are,
    integers become float64. `out`: a tuple of arrays to fill. `workers`: threads that share the
    work on long arrays.

    ValueError: an input outside its domain, with its place; `out` or `workers` that does not fit.
    TypeError: an input that is no real number of these types; in `out` what is no array of the
    results' type.

    Source: derivation random-jerk
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
    t4 = 2.220446049250313e-16 / tracking_index
    t6 = tracking_index * 3.854941057726238e-19
    t10 = form.sqrt(t4 + t6) * 67108864.0
    t13 = (t10 * t2) * 2.0
    t15 = t1 * 0.4166666666666667
    t17 = tracking_index * 0.04861111111111111
    t24 = ((t1 * t2) * 1.2504627916220945) + (8.0 / t2)
    t25 = form.near_cbrt(t24)
    t29 = form.sqrt((t13 * t25) + t17)
    t32 = form.sqrt((t29 * 2.0) + t15)
    t34 = t13 * 0.5
    t35 = t29 * t32
    t40 = ((t32 * t35) - (t34 * t25)) / (t35 - t34)
    t44 = form.sqrt((t13 * t40) + t17)
    t47 = form.sqrt((t44 * 2.0) + t15)
    t48 = t44 * t47
    t53 = ((t47 * t48) - (t34 * t40)) / (t48 - t34)
    t57 = form.sqrt((t13 * t53) + t17)
    t60 = form.sqrt((t57 * 2.0) + t15)
    t61 = t57 * t60
    t66 = ((t60 * t61) - (t34 * t53)) / (t61 - t34)
    t70 = form.sqrt((t13 * t66) + t17)
    t73 = form.sqrt((t70 * 2.0) + t15)
    t74 = t70 * t73
    t79 = ((t73 * t74) - (t34 * t66)) / (t74 - t34)
    t83 = form.sqrt((t13 * t79) + t17)
    t84 = t83 * 2.0
    t86 = form.sqrt(t84 + t15)
    t92 = t86 * t2
    t96 = (t10 + (t83 * 0.5)) + ((t92 * 0.25) + (t1 * 0.125))
    t105 = t1 * 0.16666666666666666
    t107 = t2 / t86
    t111 = (t83 + t105) + (t107 * (t83 * 0.8333333333333334))
    t119 = (t10 * 0.19444444444444445) + (t83 * 0.013888888888888888)
    t123 = t107 * (t119 + (t1 * 0.0028935185185185184))
    t125 = t1 * ((t1 * 0.010416666666666666) + t123)
    t128 = ((6.0 / t96) / tracking_index) + (((t10 * t111) + t125) / t96)
    t138 = (t10 * 0.3333333333333333) + (t83 * 0.041666666666666664)
    t143 = (t138 + (t92 * 0.020833333333333332)) + (t1 * 0.013888888888888888)
    t145 = (t10 * ((t92 * 0.5) + t83)) + (t1 * t143)
    t153 = ((t105 + t84) * tracking_index) / ((t2 * 0.5) + t86)
    t97 = (t83 + (t1 * 0.25)) / t96
    t98 = t92 / t96
    t99 = t1 / t96
    t130 = ((t1 * 0.5) * t128) * tracking_index
    t148 = ((t145 / t96) * t1) * tracking_index
    t155 = (t153 / t2) * tracking_index
    return (t97, t98, t99, t130, t148, t155)


def _updated_covariance_block(
    given: Arrays,
    out: Arrays,
    work: Arrays,
    single: bool,
    n0: float = 2.220446049250313e-16,
    n1: float = 3.854941057726238e-19,
    n2: float = 67108864.0,
    n3: float = 2.0,
    n4: float = 0.4166666666666667,
    n5: float = 0.04861111111111111,
    n6: float = 1.2504627916220945,
    n7: float = 8.0,
    n8: float = 0.5,
    n9: float = 0.25,
    n10: float = 0.125,
    n11: float = 6.0,
    n12: float = 0.16666666666666666,
    n13: float = 0.8333333333333334,
    n14: float = 0.010416666666666666,
    n15: float = 0.19444444444444445,
    n16: float = 0.013888888888888888,
    n17: float = 0.0028935185185185184,
    n18: float = 0.3333333333333333,
    n19: float = 0.041666666666666664,
    n20: float = 0.020833333333333332,
) -> None:
    (tracking_index,) = given
    updated_11, updated_12, updated_13, updated_22, updated_23, updated_33 = out
    w0, w1, w2, w3, w4, w5, w6, w7, w8, w9, w10 = work
    p = sqrt(tracking_index, updated_13)
    r = sqrt(p, updated_11)
    t4 = divide(n0, tracking_index, updated_12)
    t6 = multiply(tracking_index, n1, w0)
    t7 = add(t4, t6, updated_12)
    c_scaled = sqrt(t7, updated_22)
    t10 = multiply(c_scaled, n2, updated_22)
    t11 = multiply(t10, r, w0)
    t13 = multiply(t11, n3, w0)
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
    t34 = multiply(t13, n8, w3)
    t35 = multiply(t29, t32, updated_33)
    t36 = multiply(t32, t35, updated_23)
    t37 = multiply(t34, t25, w2)
    t38 = subtract(t36, t37, updated_23)
    t39 = subtract(t35, t34, updated_33)
    t40 = divide(t38, t39, updated_23)
    t42 = multiply(t13, t40, w2)
    t43 = add(t42, t17, w2)
    t44 = sqrt(t43, w2)
    t45 = multiply(t44, n3, updated_33)
    t46 = add(t45, t15, updated_33)
    t47 = sqrt(t46, updated_33)
    t48 = multiply(t44, t47, w2)
    t49 = multiply(t47, t48, updated_33)
    t50 = multiply(t34, t40, updated_23)
    t51 = subtract(t49, t50, updated_33)
    t52 = subtract(t48, t34, w2)
    t53 = divide(t51, t52, updated_33)
    t55 = multiply(t13, t53, w2)
    t56 = add(t55, t17, w2)
    t57 = sqrt(t56, w2)
    t58 = multiply(t57, n3, updated_23)
    t59 = add(t58, t15, updated_23)
    t60 = sqrt(t59, updated_23)
    t61 = multiply(t57, t60, w2)
    t62 = multiply(t60, t61, updated_23)
    t63 = multiply(t34, t53, updated_33)
    t64 = subtract(t62, t63, updated_23)
    t65 = subtract(t61, t34, w2)
    t66 = divide(t64, t65, updated_23)
    t68 = multiply(t13, t66, w2)
    t69 = add(t68, t17, w2)
    t70 = sqrt(t69, w2)
    t71 = multiply(t70, n3, updated_33)
    t72 = add(t71, t15, updated_33)
    t73 = sqrt(t72, updated_33)
    t74 = multiply(t70, t73, w2)
    t75 = multiply(t73, t74, updated_33)
    t76 = multiply(t34, t66, updated_23)
    t77 = subtract(t75, t76, updated_33)
    t78 = subtract(t74, t34, w2)
    t79 = divide(t77, t78, updated_33)
    t81 = multiply(t13, t79, w0)
    t82 = add(t81, t17, w0)
    e = sqrt(t82, w0)
    t84 = multiply(e, n3, w1)
    t85 = add(t84, t15, updated_12)
    x = sqrt(t85, updated_12)
    t88 = multiply(p, n9, w2)
    t89 = add(e, t88, w2)
    t90 = multiply(e, n8, w3)
    t91 = add(t10, t90, w3)
    t92 = multiply(x, r, updated_23)
    t93 = multiply(t92, n9, updated_33)
    t94 = multiply(p, n10, w4)
    t95 = add(t93, t94, updated_33)
    t96 = add(t91, t95, w3)
    t100 = multiply(p, n8, w4)
    t102 = divide(n11, t96, updated_33)
    t103 = divide(t102, tracking_index, updated_33)
    t105 = multiply(p, n12, w5)
    t106 = add(e, t105, w6)
    t107 = divide(r, x, w7)
    t109 = multiply(e, n13, w8)
    t110 = multiply(t107, t109, w8)
    t111 = add(t106, t110, w6)
    t112 = multiply(t10, t111, w6)
    t114 = multiply(p, n14, w8)
    t116 = multiply(t10, n15, w9)
    t118 = multiply(e, n16, w10)
    t119 = add(t116, t118, w9)
    t121 = multiply(p, n17, w10)
    t122 = add(t119, t121, w9)
    t123 = multiply(t107, t122, w7)
    t124 = add(t114, t123, w8)
    t125 = multiply(p, t124, w8)
    t126 = add(t112, t125, w6)
    t127 = divide(t126, t96, w6)
    t128 = add(t103, t127, updated_33)
    t129 = multiply(t100, t128, w4)
    t131 = multiply(t92, n8, w6)
    t132 = add(t131, e, w6)
    t133 = multiply(t10, t132, w6)
    t135 = multiply(t10, n18, updated_22)
    t137 = multiply(e, n19, w0)
    t138 = add(t135, t137, updated_22)
    t140 = multiply(t92, n20, w0)
    t141 = add(t138, t140, updated_22)
    t142 = multiply(p, n16, w0)
    t143 = add(t141, t142, updated_22)
    t144 = multiply(p, t143, updated_22)
    t145 = add(t133, t144, w6)
    t146 = divide(t145, t96, w6)
    t147 = multiply(t146, p, w6)
    t149 = add(t105, t84, w5)
    t150 = multiply(t149, tracking_index, w5)
    t151 = multiply(r, n8, w0)
    t152 = add(t151, x, w0)
    t153 = divide(t150, t152, w5)
    t154 = divide(t153, r, w5)
    divide(t89, t96, updated_11)
    divide(t92, t96, updated_12)
    divide(p, t96, updated_13)
    multiply(t129, tracking_index, updated_22)
    multiply(t147, tracking_index, updated_23)
    multiply(t154, tracking_index, updated_33)


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

        delta = sqrt(64/Lambda^2 + 1/9),
        xi = sqrt(5/3 + 2 eta), eta = sqrt(7/9 + 2 delta xi), nu = 1 + xi + eta + delta

    tracking_index: Lambda, with Lambda^2 =
        jerk_deviation**2*sampling_interval**6/measurement_deviation**2; a number above 0 and at
        most 2^1000, in float32 above 0 and at most 2^120.

    updated_11: derivative of the variance of the updated position over sigma_v^2. Relative error at
        most 15.53 * 2^-52 (float64), 15.53 * 2^-23 (float32), proved for 5e-324 <= tracking_index
        <= 6.147487532734931e102 (float64) and 1e-45 <= tracking_index <= 7.604528e12 (float32).
    updated_12: derivative of the covariance of updated position and velocity times T/sigma_v^2.
        Relative error at most 16.17 * 2^-52 (float64), 16.15 * 2^-23 (float32), proved for 5e-324
        <= tracking_index <= 1.6993864335471447e103 (float64) and 1e-45 <= tracking_index <=
        2.1021648e13 (float32).
    updated_13: derivative of the covariance of updated position and acceleration times
        T^2/sigma_v^2. Relative error at most 16.50 * 2^-52 (float64), 16.53 * 2^-23 (float32),
        proved for 5e-324 <= tracking_index <= 2.109262031745273e103 (float64) and 1e-45 <=
        tracking_index <= 2.6091866e13 (float32).
    updated_22: derivative of the variance of the updated velocity times T^2/sigma_v^2. Relative
        error at most 14.76 * 2^-52 (float64), 14.74 * 2^-23 (float32), proved for 5e-324 <=
        tracking_index <= 1.0715086071862673e301 (float64) and 1e-45 <= tracking_index <=
        1.329228e36 (float32).
    updated_23: derivative of the covariance of updated velocity and acceleration times
        T^3/sigma_v^2. Relative error at most 13.10 * 2^-52 (float64), 13.07 * 2^-23 (float32),
        proved for 5e-324 <= tracking_index <= 1.0715086071862673e301 (float64) and 1e-45 <=
        tracking_index <= 1.329228e36 (float32).
    updated_33: derivative of the variance of the updated acceleration times T^4/sigma_v^2. Relative
        error at most 8.79 * 2^-52 (float64), 8.79 * 2^-23 (float32), proved for 5e-324 <=
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

    Source: derivation random-jerk
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
    t4 = 2.220446049250313e-16 / tracking_index
    t6 = tracking_index * 3.854941057726238e-19
    t10 = form.sqrt(t4 + t6) * 67108864.0
    t14 = (t10 * t2) * 2.0
    t16 = t1 * 0.4166666666666667
    t18 = tracking_index * 0.04861111111111111
    t19 = t1 * t2
    t25 = (t19 * 1.2504627916220945) + (8.0 / t2)
    t26 = form.near_cbrt(t25)
    t30 = form.sqrt((t14 * t26) + t18)
    t33 = form.sqrt((t30 * 2.0) + t16)
    t35 = t14 * 0.5
    t36 = t30 * t33
    t41 = ((t33 * t36) - (t35 * t26)) / (t36 - t35)
    t45 = form.sqrt((t14 * t41) + t18)
    t48 = form.sqrt((t45 * 2.0) + t16)
    t49 = t45 * t48
    t54 = ((t48 * t49) - (t35 * t41)) / (t49 - t35)
    t58 = form.sqrt((t14 * t54) + t18)
    t61 = form.sqrt((t58 * 2.0) + t16)
    t62 = t58 * t61
    t67 = ((t61 * t62) - (t35 * t54)) / (t62 - t35)
    t71 = form.sqrt((t14 * t67) + t18)
    t74 = form.sqrt((t71 * 2.0) + t16)
    t75 = t71 * t74
    t80 = ((t74 * t75) - (t35 * t67)) / (t75 - t35)
    t84 = form.sqrt((t14 * t80) + t18)
    t87 = form.sqrt((t84 * 2.0) + t16)
    t90 = t84 + (t1 * 0.16666666666666666)
    t91 = t87 * t2
    t92 = t91 / t10
    t96 = t90 + ((t92 * t1) * 0.006944444444444444)
    t97 = t84 * t84
    t100 = t1 * t84
    t103 = (t97 * 0.75) + (t100 * 0.20833333333333334)
    t105 = tracking_index * 0.012152777777777778
    t106 = t103 + t105
    t109 = t91 * 0.25
    t111 = ((t96 / t106) * t109) / tracking_index
    t117 = (t10 + (t84 * 0.5)) + (t109 + (t1 * 0.125))
    t124 = (t97 * 0.25) + (t100 * 0.10416666666666667)
    t125 = t124 + t105
    t129 = (t125 + (t91 * (t90 * 0.125))) / t106
    t132 = (t129 * 2.0) * (t92 / tracking_index)
    t133 = t1 * t117
    t136 = t91 / t106
    t139 = (t84 + (t1 * 0.20833333333333334)) + t109
    t144 = ((t136 * (t139 * 0.5)) + 1.0) / (t10 * t1)
    t152 = ((t136 / tracking_index) / t10) * 0.5
    t157 = t152 * (t109 * (1.0 + ((t87 / t2) * 2.0)))
    t158 = ((1.0 / t10) / tracking_index) + t157
    t159 = t158 / t117
    t163 = t159 * ((6.0 / t117) / tracking_index)
    t167 = ((t1 * 0.25) / t84) * 1.6666666666666667
    t168 = t167 + 2.0
    t170 = (tracking_index * t168) * 0.012152777777777778
    t176 = ((tracking_index / t106) * t92) * 0.0008680555555555555
    t178 = ((t125 + t170) / t106) + (t176 * t168)
    t182 = ((tracking_index / t10) / t10) * 0.001736111111111111
    t184 = (t178 + t182) + t159
    t185 = t184 * t84
    t186 = 1.0 + t159
    t187 = t186 + t182
    t190 = t185 + ((t187 * t1) * 0.16666666666666666)
    t191 = t2 / t87
    t195 = ((t184 + t152) * t84) * 0.8333333333333334
    t199 = t186 + t178
    t201 = t186 + 1.0
    t202 = t201 * t1
    t208 = ((t187 + t152) * t10) * 0.19444444444444445
    t212 = ((t199 + t152) * t84) * 0.013888888888888888
    t217 = ((t201 + t152) * t1) * 0.0028935185185185184
    t220 = (t202 * 0.010416666666666666) + (t191 * ((t208 + t212) + t217))
    t222 = (t10 * (t190 + (t191 * t195))) + (t1 * t220)
    t228 = ((t125 / t106) * 2.0) + t176
    t233 = ((((t228 + t182) + t159) * t91) * 0.5) + t185
    t240 = ((t187 * t10) * 0.3333333333333333) + ((t199 * t84) * 0.041666666666666664)
    t244 = ((t186 + t228) * t91) * 0.020833333333333332
    t247 = (t240 + t244) + (t202 * 0.013888888888888888)
    t254 = (t2 * 0.5) + t87
    t256 = t152 * (t87 / t254)
    t262 = ((2.0 + t256) * t1) * 0.16666666666666666
    t263 = ((((1.0 + t178) + t256) * t84) * 2.0) + t262
    t120 = (((t111 * 2.0) / t117) / t117) / tracking_index
    t135 = (t132 / t133) / t133
    t146 = (t144 / t133) / t133
    t225 = (t1 * 0.5) * (t163 + (t222 / t117))
    t251 = (((t10 * t233) + (t1 * t247)) / t117) * t1
    t265 = (t263 / t254) * t19
    return (t120, t135, t146, t225, t251, t265)


def _updated_covariance_derivatives_block(
    given: Arrays,
    out: Arrays,
    work: Arrays,
    single: bool,
    n0: float = 2.220446049250313e-16,
    n1: float = 3.854941057726238e-19,
    n2: float = 67108864.0,
    n3: float = 2.0,
    n4: float = 0.4166666666666667,
    n5: float = 0.04861111111111111,
    n6: float = 1.2504627916220945,
    n7: float = 8.0,
    n8: float = 0.5,
    n9: float = 0.16666666666666666,
    n10: float = 0.006944444444444444,
    n11: float = 0.75,
    n12: float = 0.20833333333333334,
    n13: float = 0.012152777777777778,
    n14: float = 0.25,
    n15: float = 0.125,
    n16: float = 0.10416666666666667,
    n17: float = 1.0,
    n18: float = 6.0,
    n19: float = 1.6666666666666667,
    n20: float = 0.0008680555555555555,
    n21: float = 0.001736111111111111,
    n22: float = 0.8333333333333334,
    n23: float = 0.010416666666666666,
    n24: float = 0.19444444444444445,
    n25: float = 0.013888888888888888,
    n26: float = 0.0028935185185185184,
    n27: float = 0.3333333333333333,
    n28: float = 0.041666666666666664,
    n29: float = 0.020833333333333332,
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
    t4 = divide(n0, tracking_index, updated_12)
    t6 = multiply(tracking_index, n1, w0)
    t7 = add(t4, t6, updated_12)
    c_scaled = sqrt(t7, updated_13)
    t10 = multiply(c_scaled, n2, updated_13)
    t12 = multiply(t10, r, w0)
    t14 = multiply(t12, n3, w0)
    t16 = multiply(p, n4, updated_12)
    t18 = multiply(tracking_index, n5, w1)
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
    t35 = multiply(t14, n8, w4)
    t36 = multiply(t30, t33, updated_33)
    t37 = multiply(t33, t36, updated_22)
    t38 = multiply(t35, t26, w3)
    t39 = subtract(t37, t38, updated_22)
    t40 = subtract(t36, t35, updated_33)
    t41 = divide(t39, t40, updated_22)
    t43 = multiply(t14, t41, w3)
    t44 = add(t43, t18, w3)
    t45 = sqrt(t44, w3)
    t46 = multiply(t45, n3, updated_33)
    t47 = add(t46, t16, updated_33)
    t48 = sqrt(t47, updated_33)
    t49 = multiply(t45, t48, w3)
    t50 = multiply(t48, t49, updated_33)
    t51 = multiply(t35, t41, updated_22)
    t52 = subtract(t50, t51, updated_33)
    t53 = subtract(t49, t35, w3)
    t54 = divide(t52, t53, updated_33)
    t56 = multiply(t14, t54, w3)
    t57 = add(t56, t18, w3)
    t58 = sqrt(t57, w3)
    t59 = multiply(t58, n3, updated_22)
    t60 = add(t59, t16, updated_22)
    t61 = sqrt(t60, updated_22)
    t62 = multiply(t58, t61, w3)
    t63 = multiply(t61, t62, updated_22)
    t64 = multiply(t35, t54, updated_33)
    t65 = subtract(t63, t64, updated_22)
    t66 = subtract(t62, t35, w3)
    t67 = divide(t65, t66, updated_22)
    t69 = multiply(t14, t67, w3)
    t70 = add(t69, t18, w3)
    t71 = sqrt(t70, w3)
    t72 = multiply(t71, n3, updated_33)
    t73 = add(t72, t16, updated_33)
    t74 = sqrt(t73, updated_33)
    t75 = multiply(t71, t74, w3)
    t76 = multiply(t74, t75, updated_33)
    t77 = multiply(t35, t67, updated_22)
    t78 = subtract(t76, t77, updated_33)
    t79 = subtract(t75, t35, w3)
    t80 = divide(t78, t79, updated_33)
    t82 = multiply(t14, t80, w0)
    t83 = add(t82, t18, w0)
    e = sqrt(t83, w0)
    t85 = multiply(e, n3, w1)
    t86 = add(t85, t16, w1)
    x = sqrt(t86, w1)
    t89 = multiply(p, n9, w3)
    t90 = add(e, t89, w3)
    t91 = multiply(x, r, w4)
    t92 = divide(t91, t10, updated_12)
    t93 = multiply(t92, p, updated_22)
    t95 = multiply(t93, n10, updated_22)
    t96 = add(t90, t95, updated_22)
    t97 = square(e, updated_33)
    t99 = multiply(t97, n11, w5)
    t100 = multiply(p, e, w6)
    t102 = multiply(t100, n12, w7)
    t103 = add(t99, t102, w5)
    t105 = multiply(tracking_index, n13, w7)
    t106 = add(t103, t105, w5)
    t107 = divide(t96, t106, updated_22)
    t109 = multiply(t91, n14, w8)
    t110 = multiply(t107, t109, updated_22)
    t111 = divide(t110, tracking_index, updated_22)
    t112 = multiply(t111, n3, updated_22)
    t113 = multiply(e, n8, w9)
    t114 = add(t10, t113, w9)
    t115 = multiply(p, n15, w10)
    t116 = add(t109, t115, w10)
    t117 = add(t114, t116, w9)
    t118 = divide(t112, t117, updated_22)
    t119 = divide(t118, t117, updated_22)
    t121 = multiply(t97, n14, updated_33)
    t123 = multiply(t100, n16, w6)
    t124 = add(t121, t123, updated_33)
    t125 = add(t124, t105, updated_33)
    t126 = multiply(t90, n15, w3)
    t127 = multiply(t91, t126, w3)
    t128 = add(t125, t127, w3)
    t129 = divide(t128, t106, w3)
    t130 = multiply(t129, n3, w3)
    t131 = divide(t92, tracking_index, w6)
    t132 = multiply(t130, t131, w3)
    t133 = multiply(p, t117, w6)
    t134 = divide(t132, t133, w3)
    t136 = divide(t91, t106, w7)
    t137 = multiply(p, n12, w10)
    t138 = add(e, t137, w10)
    t139 = add(t138, t109, w10)
    t140 = multiply(t139, n8, w10)
    t141 = multiply(t136, t140, w10)
    t142 = add(t141, n17, w10)
    t143 = multiply(t10, p, w11)
    t144 = divide(t142, t143, w10)
    t145 = divide(t144, t133, w10)
    t147 = multiply(p, n8, w11)
    t148 = divide(n17, t10, w12)
    t149 = divide(t148, tracking_index, w12)
    t150 = divide(t136, tracking_index, w7)
    t151 = divide(t150, t10, w7)
    t152 = multiply(t151, n8, w7)
    t153 = divide(x, r, w13)
    t154 = multiply(t153, n3, w13)
    t155 = add(n17, t154, w13)
    t156 = multiply(t109, t155, w8)
    t157 = multiply(t152, t156, w8)
    t158 = add(t149, t157, w12)
    t159 = divide(t158, t117, w12)
    t161 = divide(n18, t117, w8)
    t162 = divide(t161, tracking_index, w8)
    t163 = multiply(t159, t162, w8)
    t164 = multiply(p, n14, w13)
    t165 = divide(t164, e, w13)
    t167 = multiply(t165, n19, w13)
    t168 = add(t167, n3, w13)
    t169 = multiply(tracking_index, t168, w14)
    t170 = multiply(t169, n13, w14)
    t171 = add(t125, t170, w14)
    t172 = divide(t171, t106, w14)
    t173 = divide(tracking_index, t106, w15)
    t174 = multiply(t173, t92, w15)
    t176 = multiply(t174, n20, w15)
    t177 = multiply(t176, t168, w13)
    t178 = add(t172, t177, w14)
    t179 = divide(tracking_index, t10, w13)
    t180 = divide(t179, t10, w13)
    t182 = multiply(t180, n21, w13)
    t183 = add(t178, t182, updated_12)
    t184 = add(t183, t159, updated_12)
    t185 = multiply(t184, e, w16)
    t186 = add(n17, t159, w17)
    t187 = add(t186, t182, w18)
    t188 = multiply(t187, p, w19)
    t189 = multiply(t188, n9, w19)
    t190 = add(t185, t189, w19)
    t191 = divide(r, x, w20)
    t192 = add(t184, t152, updated_12)
    t193 = multiply(t192, e, updated_12)
    t195 = multiply(t193, n22, updated_12)
    t196 = multiply(t191, t195, updated_12)
    t197 = add(t190, t196, w19)
    t198 = multiply(t10, t197, w19)
    t199 = add(t186, t178, updated_12)
    t200 = multiply(t199, e, w21)
    t201 = add(t186, n17, w22)
    t202 = multiply(t201, p, w23)
    t204 = multiply(t202, n23, w24)
    t205 = add(t187, t152, w25)
    t206 = multiply(t205, t10, w25)
    t208 = multiply(t206, n24, w25)
    t209 = add(t199, t152, updated_12)
    t210 = multiply(t209, e, updated_12)
    t212 = multiply(t210, n25, updated_12)
    t213 = add(t208, t212, w25)
    t214 = add(t201, t152, w22)
    t215 = multiply(t214, p, w22)
    t217 = multiply(t215, n26, w22)
    t218 = add(t213, t217, w25)
    t219 = multiply(t191, t218, w20)
    t220 = add(t204, t219, w24)
    t221 = multiply(p, t220, w24)
    t222 = add(t198, t221, w19)
    t223 = divide(t222, t117, w19)
    t224 = add(t163, t223, w8)
    t226 = divide(t125, t106, updated_33)
    t227 = multiply(t226, n3, updated_33)
    t228 = add(t227, t176, updated_33)
    t229 = add(t228, t182, w13)
    t230 = add(t229, t159, w13)
    t231 = multiply(t230, t91, w13)
    t232 = multiply(t231, n8, w13)
    t233 = add(t232, t185, w13)
    t234 = multiply(t10, t233, w13)
    t235 = multiply(t187, t10, w18)
    t237 = multiply(t235, n27, w18)
    t239 = multiply(t200, n28, w21)
    t240 = add(t237, t239, w18)
    t241 = add(t186, t228, w17)
    t242 = multiply(t241, t91, w17)
    t244 = multiply(t242, n29, w17)
    t245 = add(t240, t244, w18)
    t246 = multiply(t202, n25, w23)
    t247 = add(t245, t246, w18)
    t248 = multiply(p, t247, w18)
    t249 = add(t234, t248, w13)
    t250 = divide(t249, t117, w13)
    t252 = add(n17, t178, w14)
    t253 = multiply(r, n8, updated_11)
    t254 = add(t253, x, updated_11)
    t255 = divide(x, t254, w1)
    t256 = multiply(t152, t255, w7)
    t257 = add(t252, t256, w14)
    t258 = multiply(t257, e, w14)
    t259 = multiply(t258, n3, w14)
    t260 = add(n3, t256, w7)
    t261 = multiply(t260, p, w7)
    t262 = multiply(t261, n9, w7)
    t263 = add(t259, t262, w14)
    t264 = divide(t263, t254, w14)
    divide(t119, tracking_index, updated_11)
    divide(t134, t133, updated_12)
    divide(t145, t133, updated_13)
    multiply(t147, t224, updated_22)
    multiply(t250, p, updated_23)
    multiply(t264, t19, updated_33)


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

        delta = sqrt(64/Lambda^2 + 1/9),
        xi = sqrt(5/3 + 2 eta), eta = sqrt(7/9 + 2 delta xi), nu = 1 + xi + eta + delta

    tracking_index: Lambda, with Lambda^2 =
        jerk_deviation**2*sampling_interval**6/measurement_deviation**2; a number above 0 and
        finite.

    alpha: second derivative by Lambda of the position gain. Relative error at most 27.34 * 2^-52
        (float64), 27.57 * 2^-23 (float32), proved for 6.852691063641772e-186 <= tracking_index <=
        1.6248136397643547e77 (float64) and 4.6734187e-24 <= tracking_index <= 6.0267684e09
        (float32).
    beta: second derivative by Lambda of the velocity gain times the sampling interval. Relative
        error at most 36.29 * 2^-52 (float64), 36.32 * 2^-23 (float32), proved for
        3.506117298416336e-232 <= tracking_index <= 3.483368529203275e77 (float64) and 6.871511e-30
        <= tracking_index <= 1.2920532e10 (float32).
    gamma: second derivative by Lambda of the acceleration gain times the square of the sampling
        interval. Relative error at most 32.78 * 2^-52 (float64), 32.90 * 2^-23 (float32), proved
        for 5e-324 <= tracking_index <= 4.0961722872046457e77 (float64) and 1e-45 <= tracking_index
        <= 1.5193547e10 (float32).

    Outside an output's range, a few numbers next to its ends apart, its true value is no normal
    number: it comes as 0, a subnormal number or infinity, never as NaN. Numbers and arrays are
    taken, arrays of any shape; inputs are broadcast. float64 and float32 stay what they are,
    integers become float64. `out`: a tuple of arrays to fill. `workers`: threads that share the
    work on long arrays.

    ValueError: an input outside its domain, with its place; `out` or `workers` that does not fit.
    TypeError: an input that is no real number of these types; in `out` what is no array of the
    results' type.

    Source: derivation random-jerk
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
    t4 = 2.220446049250313e-16 / tracking_index
    t6 = tracking_index * 3.854941057726238e-19
    t10 = form.sqrt(t4 + t6) * 67108864.0
    t14 = (t10 * t2) * 2.0
    t16 = t1 * 0.4166666666666667
    t18 = tracking_index * 0.04861111111111111
    t25 = ((t1 * t2) * 1.2504627916220945) + (8.0 / t2)
    t26 = form.near_cbrt(t25)
    t30 = form.sqrt((t14 * t26) + t18)
    t33 = form.sqrt((t30 * 2.0) + t16)
    t35 = t14 * 0.5
    t36 = t30 * t33
    t41 = ((t33 * t36) - (t35 * t26)) / (t36 - t35)
    t45 = form.sqrt((t14 * t41) + t18)
    t48 = form.sqrt((t45 * 2.0) + t16)
    t49 = t45 * t48
    t54 = ((t48 * t49) - (t35 * t41)) / (t49 - t35)
    t58 = form.sqrt((t14 * t54) + t18)
    t61 = form.sqrt((t58 * 2.0) + t16)
    t62 = t58 * t61
    t67 = ((t61 * t62) - (t35 * t54)) / (t62 - t35)
    t71 = form.sqrt((t14 * t67) + t18)
    t74 = form.sqrt((t71 * 2.0) + t16)
    t75 = t71 * t74
    t80 = ((t74 * t75) - (t35 * t67)) / (t75 - t35)
    t84 = form.sqrt((t14 * t80) + t18)
    t87 = form.sqrt((t84 * 2.0) + t16)
    t88 = t87 / t2
    t89 = t88 * 2.0
    t92 = (t1 * 0.25) / t84
    t95 = (t92 * 0.6666666666666666) + 1.0
    t98 = t92 * 0.7777777777777778
    t103 = (t92 * (t98 + 3.3333333333333335)) + 3.0
    t106 = t1 / t84
    t111 = ((t106 / t103) * t106) * (t88 * (t1 / t10))
    t113 = t111 * 0.003472222222222222
    t114 = (((t95 * t92) / t103) * 2.0) + t113
    t115 = t114 * t89
    t121 = (t92 * 1.6666666666666667) + 2.0
    t124 = ((t92 / t103) * (t121 / t103)) / t103
    t128 = (t92 * 0.27469135802469136) + 0.6296296296296297
    t132 = t92 * ((t92 * t128) + 1.2222222222222223)
    t136 = (t92 * (t132 + 1.6666666666666667)) + 0.75
    t142 = ((tracking_index / t10) / t10) * 0.001736111111111111
    t147 = (((t87 / t84) / (t84 * t103)) / t2) / t10
    t149 = (t147 / t1) * 2.0
    t152 = (t121 * t92) / t103
    t156 = (t142 + t149) + ((t152 * t152) * 2.6666666666666665)
    t157 = t149 + t113
    t161 = t157 + (((t121 * t121) / t103) * 2.0)
    t162 = t113 * t161
    t165 = (t124 * (t136 * 8.0)) + (t113 * (t156 + t162))
    t168 = (t89 * (((t114 * t115) * 2.0) + t165)) * 2.0
    t172 = t87 * t2
    t176 = (t10 + (t84 * 0.5)) + ((t172 * 0.25) + (t1 * 0.125))
    t177 = t1 * t176
    t179 = ((t168 / tracking_index) / t177) / t177
    t182 = t172 / t176
    t193 = (t92 * 1.382716049382716) + 5.833333333333333
    t197 = t92 * ((t92 * t193) + 8.833333333333334)
    t201 = (t92 * (t197 + 5.833333333333333)) + 1.5
    t206 = ((t115 * t95) * 2.0) + (((t95 / t103) * (t201 / t103)) * 4.0)
    t214 = ((t92 * ((t92 * 2.0) + 5.0)) + 3.0) / t103
    t215 = t214 * 2.0
    t218 = t149 * (t121 + (((t10 / t84) * 2.0) * t215))
    t222 = (t92 * (t98 + 1.6666666666666667)) + 1.0
    t224 = (t222 / t103) * 2.0
    t225 = t224 * t103
    t227 = (t84 / t1) * 4.0
    t231 = t113 * ((t225 * t227) + (t95 * t215))
    t237 = t142 * (((t227 / t89) * (t225 * 0.5)) + t95)
    t239 = (t149 * (t84 / t176)) * (((t206 + t218) + t231) + t237)
    t240 = ((t182 / tracking_index) * 0.5) * t239
    t248 = (((t227 * (t103 * 0.5)) / t121) + 1.0) + t89
    t255 = (((t157 * t92) * (t95 + t121)) / t103) * 2.0
    t256 = t152 * 2.0
    t259 = t255 + ((t256 * t256) * 0.6666666666666666)
    t263 = (t114 * ((t182 * 0.25) * t248)) + ((t259 + t162) + (t142 * t224))
    t267 = ((t149 * (t89 * t263)) / t177) / tracking_index
    t181 = -(t179 / tracking_index)
    t242 = -(t240 / tracking_index)
    t268 = -t267
    return (t181, t242, t268)


def _gain_second_derivatives_block(
    given: Arrays,
    out: Arrays,
    work: Arrays,
    single: bool,
    n0: float = 2.220446049250313e-16,
    n1: float = 3.854941057726238e-19,
    n2: float = 67108864.0,
    n3: float = 2.0,
    n4: float = 0.4166666666666667,
    n5: float = 0.04861111111111111,
    n6: float = 1.2504627916220945,
    n7: float = 8.0,
    n8: float = 0.5,
    n9: float = 0.25,
    n10: float = 0.6666666666666666,
    n11: float = 1.0,
    n12: float = 0.7777777777777778,
    n13: float = 3.3333333333333335,
    n14: float = 3.0,
    n15: float = 0.003472222222222222,
    n16: float = 1.6666666666666667,
    n17: float = 0.27469135802469136,
    n18: float = 0.6296296296296297,
    n19: float = 1.2222222222222223,
    n20: float = 0.75,
    n21: float = 0.001736111111111111,
    n22: float = 2.6666666666666665,
    n23: float = 0.125,
    n24: float = 1.382716049382716,
    n25: float = 5.833333333333333,
    n26: float = 8.833333333333334,
    n27: float = 1.5,
    n28: float = 4.0,
    n29: float = 5.0,
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
    t4 = divide(n0, tracking_index, gamma)
    t6 = multiply(tracking_index, n1, w0)
    t7 = add(t4, t6, gamma)
    c_scaled = sqrt(t7, gamma)
    t10 = multiply(c_scaled, n2, gamma)
    t12 = multiply(t10, r, w0)
    t14 = multiply(t12, n3, w0)
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
    t35 = multiply(t14, n8, w6)
    t36 = multiply(t30, t33, w4)
    t37 = multiply(t33, t36, w5)
    t38 = multiply(t35, t26, w3)
    t39 = subtract(t37, t38, w5)
    t40 = subtract(t36, t35, w4)
    t41 = divide(t39, t40, w5)
    t43 = multiply(t14, t41, w3)
    t44 = add(t43, t18, w3)
    t45 = sqrt(t44, w3)
    t46 = multiply(t45, n3, w4)
    t47 = add(t46, t16, w4)
    t48 = sqrt(t47, w4)
    t49 = multiply(t45, t48, w3)
    t50 = multiply(t48, t49, w4)
    t51 = multiply(t35, t41, w5)
    t52 = subtract(t50, t51, w4)
    t53 = subtract(t49, t35, w3)
    t54 = divide(t52, t53, w4)
    t56 = multiply(t14, t54, w3)
    t57 = add(t56, t18, w3)
    t58 = sqrt(t57, w3)
    t59 = multiply(t58, n3, w5)
    t60 = add(t59, t16, w5)
    t61 = sqrt(t60, w5)
    t62 = multiply(t58, t61, w3)
    t63 = multiply(t61, t62, w5)
    t64 = multiply(t35, t54, w4)
    t65 = subtract(t63, t64, w5)
    t66 = subtract(t62, t35, w3)
    t67 = divide(t65, t66, w5)
    t69 = multiply(t14, t67, w3)
    t70 = add(t69, t18, w3)
    t71 = sqrt(t70, w3)
    t72 = multiply(t71, n3, w4)
    t73 = add(t72, t16, w4)
    t74 = sqrt(t73, w4)
    t75 = multiply(t71, t74, w3)
    t76 = multiply(t74, t75, w4)
    t77 = multiply(t35, t67, w5)
    t78 = subtract(t76, t77, w4)
    t79 = subtract(t75, t35, w3)
    t80 = divide(t78, t79, w4)
    t82 = multiply(t14, t80, w0)
    t83 = add(t82, t18, w0)
    e = sqrt(t83, w0)
    t85 = multiply(e, n3, w2)
    t86 = add(t85, t16, w2)
    x = sqrt(t86, w2)
    t88 = divide(x, r, w1)
    t89 = multiply(t88, n3, w3)
    t91 = multiply(p, n9, w4)
    t92 = divide(t91, e, w4)
    t94 = multiply(t92, n10, w5)
    t95 = add(t94, n11, w5)
    t96 = multiply(t95, t92, w6)
    t98 = multiply(t92, n12, w7)
    t100 = add(t98, n13, w8)
    t101 = multiply(t92, t100, w8)
    t103 = add(t101, n14, w8)
    t104 = divide(t96, t103, w6)
    t105 = multiply(t104, n3, w6)
    t106 = divide(p, e, w9)
    t107 = divide(t106, t103, w10)
    t108 = multiply(t107, t106, w10)
    t109 = divide(p, t10, w9)
    t110 = multiply(t88, t109, w1)
    t111 = multiply(t108, t110, w10)
    t113 = multiply(t111, n15, w10)
    t114 = add(t105, t113, w6)
    t115 = multiply(t114, t89, w1)
    t116 = multiply(t114, t115, w9)
    t117 = multiply(t116, n3, w9)
    t118 = divide(t92, t103, w11)
    t120 = multiply(t92, n16, w12)
    t121 = add(t120, n3, w12)
    t122 = divide(t121, t103, w13)
    t123 = multiply(t118, t122, w11)
    t124 = divide(t123, t103, w11)
    t126 = multiply(t92, n17, w13)
    t128 = add(t126, n18, w13)
    t129 = multiply(t92, t128, w13)
    t131 = add(t129, n19, w13)
    t132 = multiply(t92, t131, w13)
    t133 = add(t132, n16, w13)
    t134 = multiply(t92, t133, w13)
    t136 = add(t134, n20, w13)
    t137 = multiply(t136, n7, w13)
    t138 = multiply(t124, t137, w11)
    t139 = divide(tracking_index, t10, w13)
    t140 = divide(t139, t10, w13)
    t142 = multiply(t140, n21, w13)
    t143 = divide(x, e, w14)
    t144 = multiply(e, t103, w15)
    t145 = divide(t143, t144, w14)
    t146 = divide(t145, r, w14)
    t147 = divide(t146, t10, w14)
    t148 = divide(t147, p, w14)
    t149 = multiply(t148, n3, w14)
    t150 = add(t142, t149, w15)
    t151 = multiply(t121, t92, w16)
    t152 = divide(t151, t103, w16)
    t153 = square(t152, w17)
    t155 = multiply(t153, n22, w17)
    t156 = add(t150, t155, w15)
    t157 = add(t149, t113, w17)
    t158 = square(t121, w18)
    t159 = divide(t158, t103, w18)
    t160 = multiply(t159, n3, w18)
    t161 = add(t157, t160, w18)
    t162 = multiply(t113, t161, w18)
    t163 = add(t156, t162, w15)
    t164 = multiply(t113, t163, w15)
    t165 = add(t138, t164, w11)
    t166 = add(t117, t165, w9)
    t167 = multiply(t89, t166, w9)
    t168 = multiply(t167, n3, w9)
    t169 = divide(t168, tracking_index, w9)
    t170 = multiply(e, n8, w11)
    t171 = add(t10, t170, w11)
    t172 = multiply(x, r, w2)
    t173 = multiply(t172, n9, w15)
    t174 = multiply(p, n23, beta)
    t175 = add(t173, t174, w15)
    t176 = add(t171, t175, w11)
    t177 = multiply(p, t176, w15)
    t178 = divide(t169, t177, w9)
    t179 = divide(t178, t177, w9)
    t180 = divide(t179, tracking_index, w9)
    t182 = divide(t172, t176, w2)
    t183 = divide(t182, tracking_index, beta)
    t184 = multiply(t183, n8, beta)
    t185 = divide(e, t176, w11)
    t186 = multiply(t149, t185, w11)
    t187 = multiply(t115, t95, w1)
    t188 = multiply(t187, n3, w1)
    t189 = divide(t95, t103, w19)
    t191 = multiply(t92, n24, w20)
    t193 = add(t191, n25, w20)
    t194 = multiply(t92, t193, w20)
    t196 = add(t194, n26, w20)
    t197 = multiply(t92, t196, w20)
    t198 = add(t197, n25, w20)
    t199 = multiply(t92, t198, w20)
    t201 = add(t199, n27, w20)
    t202 = divide(t201, t103, w20)
    t203 = multiply(t189, t202, w19)
    t205 = multiply(t203, n28, w19)
    t206 = add(t188, t205, w1)
    t207 = divide(t10, e, gamma)
    t208 = multiply(t207, n3, gamma)
    t209 = multiply(t92, n3, w19)
    t211 = add(t209, n29, w19)
    t212 = multiply(t92, t211, w19)
    t213 = add(t212, n14, w19)
    t214 = divide(t213, t103, w19)
    t215 = multiply(t214, n3, w19)
    t216 = multiply(t208, t215, gamma)
    t217 = add(t121, t216, gamma)
    t218 = multiply(t149, t217, gamma)
    t219 = add(t206, t218, w1)
    t220 = add(t98, n16, w7)
    t221 = multiply(t92, t220, w7)
    t222 = add(t221, n11, w7)
    t223 = divide(t222, t103, w7)
    t224 = multiply(t223, n3, w7)
    t225 = multiply(t224, t103, w20)
    t226 = divide(e, p, w0)
    t227 = multiply(t226, n28, w0)
    t228 = multiply(t225, t227, alpha)
    t229 = multiply(t95, t215, w19)
    t230 = add(t228, t229, alpha)
    t231 = multiply(t113, t230, w10)
    t232 = add(t219, t231, w1)
    t233 = divide(t227, t89, w10)
    t234 = multiply(t225, n8, w20)
    t235 = multiply(t233, t234, w10)
    t236 = add(t235, t95, w10)
    t237 = multiply(t142, t236, w10)
    t238 = add(t232, t237, w1)
    t239 = multiply(t186, t238, w11)
    t240 = multiply(t184, t239, beta)
    t241 = divide(t240, tracking_index, beta)
    t243 = multiply(t182, n9, w2)
    t244 = multiply(t103, n8, w1)
    t245 = multiply(t227, t244, w0)
    t246 = divide(t245, t121, w0)
    t247 = add(t246, n11, w0)
    t248 = add(t247, t89, w0)
    t249 = multiply(t243, t248, w2)
    t250 = multiply(t114, t249, w6)
    t251 = multiply(t157, t92, w17)
    t252 = add(t95, t121, w5)
    t253 = multiply(t251, t252, w17)
    t254 = divide(t253, t103, w17)
    t255 = multiply(t254, n3, w17)
    t256 = multiply(t152, n3, w16)
    t257 = square(t256, w16)
    t258 = multiply(t257, n10, w16)
    t259 = add(t255, t258, w17)
    t260 = add(t259, t162, w17)
    t261 = multiply(t142, t224, w13)
    t262 = add(t260, t261, w17)
    t263 = add(t250, t262, w6)
    t264 = multiply(t89, t263, w3)
    t265 = multiply(t149, t264, w14)
    t266 = divide(t265, t177, w14)
    t267 = divide(t266, tracking_index, w14)
    negative(t180, alpha)
    negative(t241, beta)
    negative(t267, gamma)


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

        delta = sqrt(64/Lambda^2 + 1/9),
        xi = sqrt(5/3 + 2 eta), eta = sqrt(7/9 + 2 delta xi), nu = 1 + xi + eta + delta

    tracking_index: Lambda, with Lambda^2 =
        jerk_deviation**2*sampling_interval**6/measurement_deviation**2; a number above 0 and
        finite.

    position: second derivative by Lambda of the position entry of F K, alpha + beta + gamma/2.
        Relative error at most 30.61 * 2^-52 (float64), 30.59 * 2^-23 (float32), proved for
        6.852691063641991e-186 <= tracking_index <= 4.1442054202196843e77 (float64) and 4.673496e-24
        <= tracking_index <= 1.5371711e10 (float32).
    velocity: second derivative by Lambda of the velocity entry of F K times the sampling interval,
        beta + gamma. Relative error at most 36.79 * 2^-52 (float64), 36.82 * 2^-23 (float32),
        proved for 3.506117298416337e-232 <= tracking_index <= 4.5504227289903544e77 (float64) and
        6.871512e-30 <= tracking_index <= 1.6878456e10 (float32).
    acceleration: second derivative by Lambda of the acceleration entry of F K times the square of
        the sampling interval, gamma. Relative error at most 32.78 * 2^-52 (float64), 32.90 * 2^-23
        (float32), proved for 5e-324 <= tracking_index <= 4.0961722872046457e77 (float64) and 1e-45
        <= tracking_index <= 1.5193547e10 (float32).

    Outside an output's range, a few numbers next to its ends apart, its true value is no normal
    number: it comes as 0, a subnormal number or infinity, never as NaN. Numbers and arrays are
    taken, arrays of any shape; inputs are broadcast. float64 and float32 stay what they are,
    integers become float64. `out`: a tuple of arrays to fill. `workers`: threads that share the
    work on long arrays.

    ValueError: an input outside its domain, with its place; `out` or `workers` that does not fit.
    TypeError: an input that is no real number of these types; in `out` what is no array of the
    results' type.

    Source: derivation random-jerk
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
    t4 = 2.220446049250313e-16 / tracking_index
    t6 = tracking_index * 3.854941057726238e-19
    t10 = form.sqrt(t4 + t6) * 67108864.0
    t14 = (t10 * t2) * 2.0
    t16 = t1 * 0.4166666666666667
    t18 = tracking_index * 0.04861111111111111
    t25 = ((t1 * t2) * 1.2504627916220945) + (8.0 / t2)
    t26 = form.near_cbrt(t25)
    t30 = form.sqrt((t14 * t26) + t18)
    t33 = form.sqrt((t30 * 2.0) + t16)
    t35 = t14 * 0.5
    t36 = t30 * t33
    t41 = ((t33 * t36) - (t35 * t26)) / (t36 - t35)
    t45 = form.sqrt((t14 * t41) + t18)
    t48 = form.sqrt((t45 * 2.0) + t16)
    t49 = t45 * t48
    t54 = ((t48 * t49) - (t35 * t41)) / (t49 - t35)
    t58 = form.sqrt((t14 * t54) + t18)
    t61 = form.sqrt((t58 * 2.0) + t16)
    t62 = t58 * t61
    t67 = ((t61 * t62) - (t35 * t54)) / (t62 - t35)
    t71 = form.sqrt((t14 * t67) + t18)
    t74 = form.sqrt((t71 * 2.0) + t16)
    t75 = t71 * t74
    t80 = ((t74 * t75) - (t35 * t67)) / (t75 - t35)
    t84 = form.sqrt((t14 * t80) + t18)
    t87 = form.sqrt((t84 * 2.0) + t16)
    t88 = t87 / t2
    t89 = t88 * 2.0
    t92 = (t1 * 0.25) / t84
    t95 = (t92 * 0.6666666666666666) + 1.0
    t98 = t92 * 0.7777777777777778
    t103 = (t92 * (t98 + 3.3333333333333335)) + 3.0
    t106 = t1 / t84
    t111 = ((t106 / t103) * t106) * (t88 * (t1 / t10))
    t113 = t111 * 0.003472222222222222
    t114 = (((t95 * t92) / t103) * 2.0) + t113
    t115 = t114 * t89
    t121 = (t92 * 1.6666666666666667) + 2.0
    t124 = ((t92 / t103) * (t121 / t103)) / t103
    t128 = (t92 * 0.27469135802469136) + 0.6296296296296297
    t132 = t92 * ((t92 * t128) + 1.2222222222222223)
    t136 = (t92 * (t132 + 1.6666666666666667)) + 0.75
    t142 = ((tracking_index / t10) / t10) * 0.001736111111111111
    t147 = (((t87 / t84) / (t84 * t103)) / t2) / t10
    t149 = (t147 / t1) * 2.0
    t152 = (t121 * t92) / t103
    t156 = (t142 + t149) + ((t152 * t152) * 2.6666666666666665)
    t157 = t149 + t113
    t161 = t157 + (((t121 * t121) / t103) * 2.0)
    t162 = t113 * t161
    t165 = (t124 * (t136 * 8.0)) + (t113 * (t156 + t162))
    t168 = (t89 * (((t114 * t115) * 2.0) + t165)) * 2.0
    t172 = t87 * t2
    t176 = (t10 + (t84 * 0.5)) + ((t172 * 0.25) + (t1 * 0.125))
    t177 = t1 * t176
    t179 = ((t168 / tracking_index) / t177) / t177
    t181 = t172 / t176
    t192 = (t92 * 1.382716049382716) + 5.833333333333333
    t196 = t92 * ((t92 * t192) + 8.833333333333334)
    t200 = (t92 * (t196 + 5.833333333333333)) + 1.5
    t205 = ((t115 * t95) * 2.0) + (((t95 / t103) * (t200 / t103)) * 4.0)
    t213 = ((t92 * ((t92 * 2.0) + 5.0)) + 3.0) / t103
    t214 = t213 * 2.0
    t217 = t149 * (t121 + (((t10 / t84) * 2.0) * t214))
    t221 = (t92 * (t98 + 1.6666666666666667)) + 1.0
    t223 = (t221 / t103) * 2.0
    t224 = t223 * t103
    t226 = (t84 / t1) * 4.0
    t230 = t113 * ((t224 * t226) + (t95 * t214))
    t236 = t142 * (((t226 / t89) * (t224 * 0.5)) + t95)
    t238 = (t149 * (t84 / t176)) * (((t205 + t217) + t230) + t236)
    t239 = ((t181 / tracking_index) * 0.5) * t238
    t240 = t239 / tracking_index
    t246 = (((t226 * (t103 * 0.5)) / t121) + 1.0) + t89
    t253 = (((t157 * t92) * (t95 + t121)) / t103) * 2.0
    t254 = t152 * 2.0
    t257 = t253 + ((t254 * t254) * 0.6666666666666666)
    t261 = (t114 * ((t181 * 0.25) * t246)) + ((t257 + t162) + (t142 * t223))
    t265 = ((t149 * (t89 * t261)) / t177) / tracking_index
    t268 = (t179 / tracking_index) + (t240 + (t265 * 0.5))
    t269 = -t268
    t271 = -(t240 + t265)
    t272 = -t265
    return (t269, t271, t272)


def _predictor_gain_second_derivatives_block(
    given: Arrays,
    out: Arrays,
    work: Arrays,
    single: bool,
    n0: float = 2.220446049250313e-16,
    n1: float = 3.854941057726238e-19,
    n2: float = 67108864.0,
    n3: float = 2.0,
    n4: float = 0.4166666666666667,
    n5: float = 0.04861111111111111,
    n6: float = 1.2504627916220945,
    n7: float = 8.0,
    n8: float = 0.5,
    n9: float = 0.25,
    n10: float = 0.6666666666666666,
    n11: float = 1.0,
    n12: float = 0.7777777777777778,
    n13: float = 3.3333333333333335,
    n14: float = 3.0,
    n15: float = 0.003472222222222222,
    n16: float = 1.6666666666666667,
    n17: float = 0.27469135802469136,
    n18: float = 0.6296296296296297,
    n19: float = 1.2222222222222223,
    n20: float = 0.75,
    n21: float = 0.001736111111111111,
    n22: float = 2.6666666666666665,
    n23: float = 0.125,
    n24: float = 1.382716049382716,
    n25: float = 5.833333333333333,
    n26: float = 8.833333333333334,
    n27: float = 1.5,
    n28: float = 4.0,
    n29: float = 5.0,
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
    t4 = divide(n0, tracking_index, acceleration)
    t6 = multiply(tracking_index, n1, w0)
    t7 = add(t4, t6, acceleration)
    c_scaled = sqrt(t7, acceleration)
    t10 = multiply(c_scaled, n2, acceleration)
    t12 = multiply(t10, r, w0)
    t14 = multiply(t12, n3, w0)
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
    t35 = multiply(t14, n8, w6)
    t36 = multiply(t30, t33, w4)
    t37 = multiply(t33, t36, w5)
    t38 = multiply(t35, t26, w3)
    t39 = subtract(t37, t38, w5)
    t40 = subtract(t36, t35, w4)
    t41 = divide(t39, t40, w5)
    t43 = multiply(t14, t41, w3)
    t44 = add(t43, t18, w3)
    t45 = sqrt(t44, w3)
    t46 = multiply(t45, n3, w4)
    t47 = add(t46, t16, w4)
    t48 = sqrt(t47, w4)
    t49 = multiply(t45, t48, w3)
    t50 = multiply(t48, t49, w4)
    t51 = multiply(t35, t41, w5)
    t52 = subtract(t50, t51, w4)
    t53 = subtract(t49, t35, w3)
    t54 = divide(t52, t53, w4)
    t56 = multiply(t14, t54, w3)
    t57 = add(t56, t18, w3)
    t58 = sqrt(t57, w3)
    t59 = multiply(t58, n3, w5)
    t60 = add(t59, t16, w5)
    t61 = sqrt(t60, w5)
    t62 = multiply(t58, t61, w3)
    t63 = multiply(t61, t62, w5)
    t64 = multiply(t35, t54, w4)
    t65 = subtract(t63, t64, w5)
    t66 = subtract(t62, t35, w3)
    t67 = divide(t65, t66, w5)
    t69 = multiply(t14, t67, w3)
    t70 = add(t69, t18, w3)
    t71 = sqrt(t70, w3)
    t72 = multiply(t71, n3, w4)
    t73 = add(t72, t16, w4)
    t74 = sqrt(t73, w4)
    t75 = multiply(t71, t74, w3)
    t76 = multiply(t74, t75, w4)
    t77 = multiply(t35, t67, w5)
    t78 = subtract(t76, t77, w4)
    t79 = subtract(t75, t35, w3)
    t80 = divide(t78, t79, w4)
    t82 = multiply(t14, t80, w0)
    t83 = add(t82, t18, w0)
    e = sqrt(t83, w0)
    t85 = multiply(e, n3, w2)
    t86 = add(t85, t16, w2)
    x = sqrt(t86, w2)
    t88 = divide(x, r, w1)
    t89 = multiply(t88, n3, w3)
    t91 = multiply(p, n9, w4)
    t92 = divide(t91, e, w4)
    t94 = multiply(t92, n10, w5)
    t95 = add(t94, n11, w5)
    t96 = multiply(t95, t92, w6)
    t98 = multiply(t92, n12, w7)
    t100 = add(t98, n13, w8)
    t101 = multiply(t92, t100, w8)
    t103 = add(t101, n14, w8)
    t104 = divide(t96, t103, w6)
    t105 = multiply(t104, n3, w6)
    t106 = divide(p, e, w9)
    t107 = divide(t106, t103, w10)
    t108 = multiply(t107, t106, w10)
    t109 = divide(p, t10, w9)
    t110 = multiply(t88, t109, w1)
    t111 = multiply(t108, t110, w10)
    t113 = multiply(t111, n15, w10)
    t114 = add(t105, t113, w6)
    t115 = multiply(t114, t89, w1)
    t116 = multiply(t114, t115, w9)
    t117 = multiply(t116, n3, w9)
    t118 = divide(t92, t103, w11)
    t120 = multiply(t92, n16, w12)
    t121 = add(t120, n3, w12)
    t122 = divide(t121, t103, w13)
    t123 = multiply(t118, t122, w11)
    t124 = divide(t123, t103, w11)
    t126 = multiply(t92, n17, w13)
    t128 = add(t126, n18, w13)
    t129 = multiply(t92, t128, w13)
    t131 = add(t129, n19, w13)
    t132 = multiply(t92, t131, w13)
    t133 = add(t132, n16, w13)
    t134 = multiply(t92, t133, w13)
    t136 = add(t134, n20, w13)
    t137 = multiply(t136, n7, w13)
    t138 = multiply(t124, t137, w11)
    t139 = divide(tracking_index, t10, w13)
    t140 = divide(t139, t10, w13)
    t142 = multiply(t140, n21, w13)
    t143 = divide(x, e, w14)
    t144 = multiply(e, t103, w15)
    t145 = divide(t143, t144, w14)
    t146 = divide(t145, r, w14)
    t147 = divide(t146, t10, w14)
    t148 = divide(t147, p, w14)
    t149 = multiply(t148, n3, w14)
    t150 = add(t142, t149, w15)
    t151 = multiply(t121, t92, w16)
    t152 = divide(t151, t103, w16)
    t153 = square(t152, w17)
    t155 = multiply(t153, n22, w17)
    t156 = add(t150, t155, w15)
    t157 = add(t149, t113, w17)
    t158 = square(t121, w18)
    t159 = divide(t158, t103, w18)
    t160 = multiply(t159, n3, w18)
    t161 = add(t157, t160, w18)
    t162 = multiply(t113, t161, w18)
    t163 = add(t156, t162, w15)
    t164 = multiply(t113, t163, w15)
    t165 = add(t138, t164, w11)
    t166 = add(t117, t165, w9)
    t167 = multiply(t89, t166, w9)
    t168 = multiply(t167, n3, w9)
    t169 = divide(t168, tracking_index, w9)
    t170 = multiply(e, n8, w11)
    t171 = add(t10, t170, w11)
    t172 = multiply(x, r, w2)
    t173 = multiply(t172, n9, w15)
    t174 = multiply(p, n23, velocity)
    t175 = add(t173, t174, w15)
    t176 = add(t171, t175, w11)
    t177 = multiply(p, t176, w15)
    t178 = divide(t169, t177, w9)
    t179 = divide(t178, t177, w9)
    t180 = divide(t179, tracking_index, w9)
    t181 = divide(t172, t176, w2)
    t182 = divide(t181, tracking_index, velocity)
    t183 = multiply(t182, n8, velocity)
    t184 = divide(e, t176, w11)
    t185 = multiply(t149, t184, w11)
    t186 = multiply(t115, t95, w1)
    t187 = multiply(t186, n3, w1)
    t188 = divide(t95, t103, w19)
    t190 = multiply(t92, n24, w20)
    t192 = add(t190, n25, w20)
    t193 = multiply(t92, t192, w20)
    t195 = add(t193, n26, w20)
    t196 = multiply(t92, t195, w20)
    t197 = add(t196, n25, w20)
    t198 = multiply(t92, t197, w20)
    t200 = add(t198, n27, w20)
    t201 = divide(t200, t103, w20)
    t202 = multiply(t188, t201, w19)
    t204 = multiply(t202, n28, w19)
    t205 = add(t187, t204, w1)
    t206 = divide(t10, e, acceleration)
    t207 = multiply(t206, n3, acceleration)
    t208 = multiply(t92, n3, w19)
    t210 = add(t208, n29, w19)
    t211 = multiply(t92, t210, w19)
    t212 = add(t211, n14, w19)
    t213 = divide(t212, t103, w19)
    t214 = multiply(t213, n3, w19)
    t215 = multiply(t207, t214, acceleration)
    t216 = add(t121, t215, acceleration)
    t217 = multiply(t149, t216, acceleration)
    t218 = add(t205, t217, w1)
    t219 = add(t98, n16, w7)
    t220 = multiply(t92, t219, w7)
    t221 = add(t220, n11, w7)
    t222 = divide(t221, t103, w7)
    t223 = multiply(t222, n3, w7)
    t224 = multiply(t223, t103, w20)
    t225 = divide(e, p, w0)
    t226 = multiply(t225, n28, w0)
    t227 = multiply(t224, t226, position)
    t228 = multiply(t95, t214, w19)
    t229 = add(t227, t228, position)
    t230 = multiply(t113, t229, w10)
    t231 = add(t218, t230, w1)
    t232 = divide(t226, t89, w10)
    t233 = multiply(t224, n8, w20)
    t234 = multiply(t232, t233, w10)
    t235 = add(t234, t95, w10)
    t236 = multiply(t142, t235, w10)
    t237 = add(t231, t236, w1)
    t238 = multiply(t185, t237, w11)
    t239 = multiply(t183, t238, velocity)
    t240 = divide(t239, tracking_index, velocity)
    t241 = multiply(t181, n9, w2)
    t242 = multiply(t103, n8, w1)
    t243 = multiply(t226, t242, w0)
    t244 = divide(t243, t121, w0)
    t245 = add(t244, n11, w0)
    t246 = add(t245, t89, w0)
    t247 = multiply(t241, t246, w2)
    t248 = multiply(t114, t247, w6)
    t249 = multiply(t157, t92, w17)
    t250 = add(t95, t121, w5)
    t251 = multiply(t249, t250, w17)
    t252 = divide(t251, t103, w17)
    t253 = multiply(t252, n3, w17)
    t254 = multiply(t152, n3, w16)
    t255 = square(t254, w16)
    t256 = multiply(t255, n10, w16)
    t257 = add(t253, t256, w17)
    t258 = add(t257, t162, w17)
    t259 = multiply(t142, t223, w13)
    t260 = add(t258, t259, w17)
    t261 = add(t248, t260, w6)
    t262 = multiply(t89, t261, w3)
    t263 = multiply(t149, t262, w14)
    t264 = divide(t263, t177, w14)
    t265 = divide(t264, tracking_index, w14)
    t266 = multiply(t265, n8, w0)
    t267 = add(t240, t266, w0)
    t268 = add(t180, t267, w9)
    t270 = add(t240, t265, velocity)
    negative(t268, position)
    negative(t270, velocity)
    negative(t265, acceleration)


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

        delta = sqrt(64/Lambda^2 + 1/9),
        xi = sqrt(5/3 + 2 eta), eta = sqrt(7/9 + 2 delta xi), nu = 1 + xi + eta + delta

    tracking_index: Lambda, with Lambda^2 =
        jerk_deviation**2*sampling_interval**6/measurement_deviation**2; a number above 0 and at
        most 2^1000, in float32 above 0 and at most 2^120.

    predicted_13: second derivative by Lambda of the covariance of predicted position and
        acceleration times T^2/sigma_v^2. Relative error at most 17.84 * 2^-52 (float64), 17.73 *
        2^-23 (float32), proved for 5e-324 <= tracking_index <= 1.0715086071862673e301 (float64) and
        1e-45 <= tracking_index <= 1.329228e36 (float32).
    predicted_22: second derivative by Lambda of the variance of the predicted velocity times
        T^2/sigma_v^2. Relative error at most 13.20 * 2^-52 (float64), 13.06 * 2^-23 (float32),
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

    Source: derivation random-jerk
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
    t4 = 2.220446049250313e-16 / tracking_index
    t6 = tracking_index * 3.854941057726238e-19
    t10 = form.sqrt(t4 + t6) * 67108864.0
    t14 = (t10 * t2) * 2.0
    t16 = t1 * 0.4166666666666667
    t18 = tracking_index * 0.04861111111111111
    t25 = ((t1 * t2) * 1.2504627916220945) + (8.0 / t2)
    t26 = form.near_cbrt(t25)
    t30 = form.sqrt((t14 * t26) + t18)
    t33 = form.sqrt((t30 * 2.0) + t16)
    t35 = t14 * 0.5
    t36 = t30 * t33
    t41 = ((t33 * t36) - (t35 * t26)) / (t36 - t35)
    t45 = form.sqrt((t14 * t41) + t18)
    t48 = form.sqrt((t45 * 2.0) + t16)
    t49 = t45 * t48
    t54 = ((t48 * t49) - (t35 * t41)) / (t49 - t35)
    t58 = form.sqrt((t14 * t54) + t18)
    t61 = form.sqrt((t58 * 2.0) + t16)
    t62 = t58 * t61
    t67 = ((t61 * t62) - (t35 * t54)) / (t62 - t35)
    t71 = form.sqrt((t14 * t67) + t18)
    t74 = form.sqrt((t71 * 2.0) + t16)
    t75 = t71 * t74
    t80 = ((t74 * t75) - (t35 * t67)) / (t75 - t35)
    t84 = form.sqrt((t14 * t80) + t18)
    t87 = form.sqrt((t84 * 2.0) + t16)
    t90 = (t1 * 0.25) / t84
    t93 = (t90 * 0.6666666666666666) + 1.0
    t96 = t90 * 0.7777777777777778
    t101 = (t90 * (t96 + 3.3333333333333335)) + 3.0
    t104 = t1 / t84
    t107 = t87 / t2
    t110 = ((t104 / t101) * t104) * (t107 * (t1 / t10))
    t112 = t110 * 0.003472222222222222
    t114 = t107 * 2.0
    t115 = ((((t93 * t90) / t101) * 2.0) + t112) * t114
    t122 = (((t87 / t84) / (t84 * t101)) / t2) / t10
    t124 = (t122 / t1) * 2.0
    t125 = t124 + t112
    t129 = (t90 * 1.6666666666666667) + 2.0
    t133 = (((t125 * t90) * (t93 + t129)) / t101) * 2.0
    t135 = (t129 * t90) / t101
    t136 = t135 * 2.0
    t139 = t133 + ((t136 * t136) * 0.6666666666666666)
    t143 = t125 + (((t129 * t129) / t101) * 2.0)
    t144 = t112 * t143
    t149 = ((tracking_index / t10) / t10) * 0.001736111111111111
    t152 = (t90 * (t96 + 1.6666666666666667)) + 1.0
    t154 = (t152 / t101) * 2.0
    t157 = t124 * ((t139 + t144) + (t149 * t154))
    t159 = (t115 * (t115 + 1.0)) + (t157 * t114)
    t166 = (t10 + (t84 * 0.5)) + (((t87 * t2) * 0.25) + (t1 * 0.125))
    t171 = t84 / t1
    t179 = (t90 * 3.240740740740741) + 9.074074074074074
    t183 = t90 * ((t90 * t179) + 7.611111111111111)
    t186 = (t90 / t101) * ((t183 + 1.6666666666666667) / t101)
    t187 = t154 + t112
    t193 = (t90 * 2.5925925925925926) + 6.222222222222222
    t196 = ((t90 * t193) + 3.3333333333333335) * t90
    t200 = ((t196 / t101) * (t129 / t101)) + t149
    t202 = t124 * (t200 + t144)
    t204 = (t186 * (t187 * 4.0)) + (t202 * t143)
    t210 = t187 * ((t135 * 10.0) + (t125 * 6.0))
    t213 = (t90 * 2.3333333333333335) + 3.3333333333333335
    t218 = (((t90 * t213) + 1.0) / t101) + (t112 * 2.0)
    t222 = t112 * ((t210 + (t218 * 4.0)) + t124)
    t224 = (t171 * (t101 * 4.0)) * (t204 + t222)
    t230 = t114 * ((t187 * (t187 + 1.0)) + t202)
    t232 = (((t84 / t87) * (t224 / t2)) + t230) * 0.125
    t237 = (t90 * 5.041152263374485) + 20.22222222222222
    t241 = t90 * ((t90 * t237) + 28.51851851851852)
    t246 = (t90 * (t241 + 18.0)) + 8.333333333333334
    t252 = ((((t90 * t246) + 4.0) / t101) / t101) + (t202 * t129)
    t256 = (t90 * 1.2962962962962963) + 3.111111111111111
    t262 = ((t90 * ((t90 * t256) + 5.0)) + 4.0) / t101
    t267 = ((t262 * 2.0) + (t129 * t218)) + (t90 * 3.3333333333333335)
    t270 = (t171 * 4.0) * (t252 + (t112 * t267))
    t169 = (t159 * (t1 * t166)) / tracking_index
    t273 = t232 + ((t270 * 0.25) + 0.4166666666666667)
    t276 = ((t270 + t230) * 0.25) + 0.6666666666666666
    t278 = (t230 * 0.5) + 1.0
    return (t169, t273, t276, t278)


def _predicted_covariance_second_derivatives_block(
    given: Arrays,
    out: Arrays,
    work: Arrays,
    single: bool,
    n0: float = 2.220446049250313e-16,
    n1: float = 3.854941057726238e-19,
    n2: float = 67108864.0,
    n3: float = 2.0,
    n4: float = 0.4166666666666667,
    n5: float = 0.04861111111111111,
    n6: float = 1.2504627916220945,
    n7: float = 8.0,
    n8: float = 0.5,
    n9: float = 0.25,
    n10: float = 0.6666666666666666,
    n11: float = 1.0,
    n12: float = 0.7777777777777778,
    n13: float = 3.3333333333333335,
    n14: float = 3.0,
    n15: float = 0.003472222222222222,
    n16: float = 1.6666666666666667,
    n17: float = 0.001736111111111111,
    n18: float = 0.125,
    n19: float = 4.0,
    n20: float = 3.240740740740741,
    n21: float = 9.074074074074074,
    n22: float = 7.611111111111111,
    n23: float = 2.5925925925925926,
    n24: float = 6.222222222222222,
    n25: float = 10.0,
    n26: float = 6.0,
    n27: float = 2.3333333333333335,
    n28: float = 5.041152263374485,
    n29: float = 20.22222222222222,
    n30: float = 28.51851851851852,
    n31: float = 18.0,
    n32: float = 8.333333333333334,
    n33: float = 1.2962962962962963,
    n34: float = 3.111111111111111,
    n35: float = 5.0,
) -> None:
    (tracking_index,) = given
    predicted_13, predicted_22, predicted_23, predicted_33 = out
    w0, w1, w2, w3, w4, w5, w6, w7, w8, w9, w10, w11, w12, w13, w14, w15 = work
    p = sqrt(tracking_index, predicted_13)
    r = sqrt(p, predicted_22)
    t4 = divide(n0, tracking_index, predicted_23)
    t6 = multiply(tracking_index, n1, w0)
    t7 = add(t4, t6, predicted_23)
    c_scaled = sqrt(t7, predicted_33)
    t10 = multiply(c_scaled, n2, predicted_33)
    t12 = multiply(t10, r, w0)
    t14 = multiply(t12, n3, w0)
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
    t35 = multiply(t14, n8, w5)
    t36 = multiply(t30, t33, w3)
    t37 = multiply(t33, t36, w4)
    t38 = multiply(t35, t26, w2)
    t39 = subtract(t37, t38, w4)
    t40 = subtract(t36, t35, w3)
    t41 = divide(t39, t40, w4)
    t43 = multiply(t14, t41, w2)
    t44 = add(t43, t18, w2)
    t45 = sqrt(t44, w2)
    t46 = multiply(t45, n3, w3)
    t47 = add(t46, t16, w3)
    t48 = sqrt(t47, w3)
    t49 = multiply(t45, t48, w2)
    t50 = multiply(t48, t49, w3)
    t51 = multiply(t35, t41, w4)
    t52 = subtract(t50, t51, w3)
    t53 = subtract(t49, t35, w2)
    t54 = divide(t52, t53, w3)
    t56 = multiply(t14, t54, w2)
    t57 = add(t56, t18, w2)
    t58 = sqrt(t57, w2)
    t59 = multiply(t58, n3, w4)
    t60 = add(t59, t16, w4)
    t61 = sqrt(t60, w4)
    t62 = multiply(t58, t61, w2)
    t63 = multiply(t61, t62, w4)
    t64 = multiply(t35, t54, w3)
    t65 = subtract(t63, t64, w4)
    t66 = subtract(t62, t35, w2)
    t67 = divide(t65, t66, w4)
    t69 = multiply(t14, t67, w2)
    t70 = add(t69, t18, w2)
    t71 = sqrt(t70, w2)
    t72 = multiply(t71, n3, w3)
    t73 = add(t72, t16, w3)
    t74 = sqrt(t73, w3)
    t75 = multiply(t71, t74, w2)
    t76 = multiply(t74, t75, w3)
    t77 = multiply(t35, t67, w4)
    t78 = subtract(t76, t77, w3)
    t79 = subtract(t75, t35, w2)
    t80 = divide(t78, t79, w3)
    t82 = multiply(t14, t80, w0)
    t83 = add(t82, t18, w0)
    e = sqrt(t83, w0)
    t85 = multiply(e, n3, w1)
    t86 = add(t85, t16, w1)
    x = sqrt(t86, w1)
    t89 = multiply(p, n9, w2)
    t90 = divide(t89, e, w2)
    t92 = multiply(t90, n10, w3)
    t93 = add(t92, n11, w3)
    t94 = multiply(t93, t90, w4)
    t96 = multiply(t90, n12, w5)
    t98 = add(t96, n13, predicted_23)
    t99 = multiply(t90, t98, predicted_23)
    t101 = add(t99, n14, predicted_23)
    t102 = divide(t94, t101, w4)
    t103 = multiply(t102, n3, w4)
    t104 = divide(p, e, w6)
    t105 = divide(t104, t101, w7)
    t106 = multiply(t105, t104, w7)
    t107 = divide(x, r, w6)
    t108 = divide(p, t10, w8)
    t109 = multiply(t107, t108, w8)
    t110 = multiply(t106, t109, w7)
    t112 = multiply(t110, n15, w7)
    t113 = add(t103, t112, w4)
    t114 = multiply(t107, n3, w6)
    t115 = multiply(t113, t114, w4)
    t116 = add(t115, n11, w8)
    t117 = multiply(t115, t116, w4)
    t118 = divide(x, e, w8)
    t119 = multiply(e, t101, w9)
    t120 = divide(t118, t119, w8)
    t121 = divide(t120, r, w8)
    t122 = divide(t121, t10, w8)
    t123 = divide(t122, p, w8)
    t124 = multiply(t123, n3, w8)
    t125 = add(t124, t112, w9)
    t126 = multiply(t125, t90, w10)
    t128 = multiply(t90, n16, w11)
    t129 = add(t128, n3, w11)
    t130 = add(t93, t129, w3)
    t131 = multiply(t126, t130, w10)
    t132 = divide(t131, t101, w10)
    t133 = multiply(t132, n3, w10)
    t134 = multiply(t129, t90, w3)
    t135 = divide(t134, t101, w3)
    t136 = multiply(t135, n3, w12)
    t137 = square(t136, w12)
    t138 = multiply(t137, n10, w12)
    t139 = add(t133, t138, w10)
    t140 = square(t129, w12)
    t141 = divide(t140, t101, w12)
    t142 = multiply(t141, n3, w12)
    t143 = add(t125, t142, w12)
    t144 = multiply(t112, t143, w13)
    t145 = add(t139, t144, w10)
    t146 = divide(tracking_index, t10, w14)
    t147 = divide(t146, t10, w14)
    t149 = multiply(t147, n17, w14)
    t150 = add(t96, n16, w5)
    t151 = multiply(t90, t150, w5)
    t152 = add(t151, n11, w5)
    t153 = divide(t152, t101, w5)
    t154 = multiply(t153, n3, w5)
    t155 = multiply(t149, t154, w15)
    t156 = add(t145, t155, w10)
    t157 = multiply(t124, t156, w10)
    t158 = multiply(t157, t114, w10)
    t159 = add(t117, t158, w4)
    t160 = multiply(e, n8, w10)
    t161 = add(t10, t160, predicted_33)
    t162 = multiply(x, r, w10)
    t163 = multiply(t162, n9, w10)
    t164 = multiply(p, n18, w15)
    t165 = add(t163, t164, w10)
    t166 = add(t161, t165, predicted_33)
    t167 = multiply(p, t166, predicted_33)
    t168 = multiply(t159, t167, w4)
    t170 = divide(e, x, w1)
    t171 = divide(e, p, w0)
    t173 = multiply(t101, n19, w10)
    t174 = multiply(t171, t173, w10)
    t175 = divide(t90, t101, w15)
    t177 = multiply(t90, n20, predicted_13)
    t179 = add(t177, n21, predicted_13)
    t180 = multiply(t90, t179, predicted_13)
    t182 = add(t180, n22, predicted_13)
    t183 = multiply(t90, t182, predicted_13)
    t184 = add(t183, n16, predicted_13)
    t185 = divide(t184, t101, predicted_13)
    t186 = multiply(t175, t185, w15)
    t187 = add(t154, t112, w5)
    t188 = multiply(t187, n19, predicted_13)
    t189 = multiply(t186, t188, w15)
    t191 = multiply(t90, n23, predicted_13)
    t193 = add(t191, n24, predicted_13)
    t194 = multiply(t90, t193, predicted_13)
    t195 = add(t194, n13, predicted_13)
    t196 = multiply(t195, t90, predicted_13)
    t197 = divide(t196, t101, predicted_13)
    t198 = divide(t129, t101, predicted_33)
    t199 = multiply(t197, t198, predicted_13)
    t200 = add(t199, t149, predicted_13)
    t201 = add(t200, t144, predicted_13)
    t202 = multiply(t124, t201, predicted_13)
    t203 = multiply(t202, t143, w12)
    t204 = add(t189, t203, w15)
    t206 = multiply(t135, n25, w3)
    t208 = multiply(t125, n26, w9)
    t209 = add(t206, t208, w3)
    t210 = multiply(t187, t209, w3)
    t212 = multiply(t90, n27, w9)
    t213 = add(t212, n13, w9)
    t214 = multiply(t90, t213, w9)
    t215 = add(t214, n11, w9)
    t216 = divide(t215, t101, w9)
    t217 = multiply(t112, n3, w12)
    t218 = add(t216, t217, w9)
    t219 = multiply(t218, n19, w12)
    t220 = add(t210, t219, w3)
    t221 = add(t220, t124, w3)
    t222 = multiply(t112, t221, w3)
    t223 = add(t204, t222, w15)
    t224 = multiply(t174, t223, w10)
    t225 = divide(t224, r, w10)
    t226 = multiply(t170, t225, w1)
    t227 = add(t187, n11, w3)
    t228 = multiply(t187, t227, w5)
    t229 = add(t228, t202, w5)
    t230 = multiply(t114, t229, w6)
    t231 = add(t226, t230, w1)
    t232 = multiply(t231, n18, w1)
    t233 = multiply(t171, n19, w0)
    t235 = multiply(t90, n28, w3)
    t237 = add(t235, n29, w3)
    t238 = multiply(t90, t237, w3)
    t240 = add(t238, n30, w3)
    t241 = multiply(t90, t240, w3)
    t243 = add(t241, n31, w3)
    t244 = multiply(t90, t243, w3)
    t246 = add(t244, n32, w3)
    t247 = multiply(t90, t246, w3)
    t248 = add(t247, n19, w3)
    t249 = divide(t248, t101, w3)
    t250 = divide(t249, t101, w3)
    t251 = multiply(t202, t129, predicted_13)
    t252 = add(t250, t251, w3)
    t254 = multiply(t90, n33, w5)
    t256 = add(t254, n34, w5)
    t257 = multiply(t90, t256, w5)
    t259 = add(t257, n35, w5)
    t260 = multiply(t90, t259, w5)
    t261 = add(t260, n19, w5)
    t262 = divide(t261, t101, w5)
    t263 = multiply(t262, n3, w5)
    t264 = multiply(t129, t218, w11)
    t265 = add(t263, t264, w5)
    t266 = multiply(t90, n13, w2)
    t267 = add(t265, t266, w5)
    t268 = multiply(t112, t267, w7)
    t269 = add(t252, t268, w3)
    t270 = multiply(t233, t269, w0)
    t271 = multiply(t270, n9, w2)
    t272 = add(t271, n4, w2)
    t274 = add(t270, t230, w0)
    t275 = multiply(t274, n9, w0)
    t277 = multiply(t230, n8, w6)
    divide(t168, tracking_index, predicted_13)
    add(t232, t272, predicted_22)
    add(t275, n10, predicted_23)
    add(t277, n11, predicted_33)


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

        delta = sqrt(64/Lambda^2 + 1/9),
        xi = sqrt(5/3 + 2 eta), eta = sqrt(7/9 + 2 delta xi), nu = 1 + xi + eta + delta

    tracking_index: Lambda, with Lambda^2 =
        jerk_deviation**2*sampling_interval**6/measurement_deviation**2; a number at least 2^-750
        and at most 2^1000, in float32 at least 2^-80 and at most 2^120.

    predicted_11: second derivative by Lambda of the variance of the predicted position over
        sigma_v^2. Error over the sum of its terms' sizes at most 65.59 * 2^-52 (float64), 69.44 *
        2^-23 (float32), proved for 6.85269106364131e-186 <= tracking_index <=
        1.0715086071862673e301 (float64) and 4.6732578e-24 <= tracking_index <= 1.329228e36
        (float32). Cancellation, condition number 1: it bends down for a small index and up for a
        large one, so that it vanishes between. Digits that can be lost: up to 16 of 16 in float64,
        half or more only where 0.88 <= tracking_index <= 1.4; up to 7 of 7 in float32, half or more
        only where 0.77 <= tracking_index <= 1.6.
    predicted_12: second derivative by Lambda of the covariance of predicted position and velocity
        times T/sigma_v^2. Error over the sum of its terms' sizes at most 67.93 * 2^-52 (float64),
        71.60 * 2^-23 (float32), proved for 1.688508503057271e-226 <= tracking_index <=
        1.0715086071862673e301 (float64) and 8.271806e-25 <= tracking_index <= 1.329228e36
        (float32). Cancellation, condition number 1: it bends down for a small index and up for a
        large one, so that it vanishes between. Digits that can be lost: up to 16 of 16 in float64,
        half or more only where 0.292965 <= tracking_index <= 0.293093; up to 7 of 7 in float32,
        half or more only where 0.2 <= tracking_index <= 0.41.

    Outside an output's range, a few numbers next to its ends apart, its true value is no normal
    number: it comes as 0, a subnormal number or infinity, never as NaN. Numbers and arrays are
    taken, arrays of any shape; inputs are broadcast. float64 and float32 stay what they are,
    integers become float64. `out`: a tuple of arrays to fill. `workers`: threads that share the
    work on long arrays.

    ValueError: an input outside its domain, with its place; `out` or `workers` that does not fit.
    TypeError: an input that is no real number of these types; in `out` what is no array of the
    results' type.

    Source: derivation random-jerk
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
    t4 = 2.220446049250313e-16 / tracking_index
    t6 = tracking_index * 3.854941057726238e-19
    t10 = form.sqrt(t4 + t6) * 67108864.0
    t14 = (t10 * t2) * 2.0
    t16 = t1 * 0.4166666666666667
    t18 = tracking_index * 0.04861111111111111
    t25 = ((t1 * t2) * 1.2504627916220945) + (8.0 / t2)
    t26 = form.near_cbrt(t25)
    t30 = form.sqrt((t14 * t26) + t18)
    t33 = form.sqrt((t30 * 2.0) + t16)
    t35 = t14 * 0.5
    t36 = t30 * t33
    t41 = ((t33 * t36) - (t35 * t26)) / (t36 - t35)
    t45 = form.sqrt((t14 * t41) + t18)
    t48 = form.sqrt((t45 * 2.0) + t16)
    t49 = t45 * t48
    t54 = ((t48 * t49) - (t35 * t41)) / (t49 - t35)
    t58 = form.sqrt((t14 * t54) + t18)
    t61 = form.sqrt((t58 * 2.0) + t16)
    t62 = t58 * t61
    t67 = ((t61 * t62) - (t35 * t54)) / (t62 - t35)
    t71 = form.sqrt((t14 * t67) + t18)
    t74 = form.sqrt((t71 * 2.0) + t16)
    t75 = t71 * t74
    t80 = ((t74 * t75) - (t35 * t67)) / (t75 - t35)
    t84 = form.sqrt((t14 * t80) + t18)
    t87 = form.sqrt((t84 * 2.0) + t16)
    t90 = (t1 * 0.25) / t84
    t93 = (t90 * 0.6666666666666666) + 1.0
    t96 = t90 * 0.7777777777777778
    t101 = (t90 * (t96 + 3.3333333333333335)) + 3.0
    t104 = t1 / t84
    t107 = t87 / t2
    t110 = ((t104 / t101) * t104) * (t107 * (t1 / t10))
    t112 = t110 * 0.003472222222222222
    t114 = t107 * 2.0
    t115 = ((((t93 * t90) / t101) * 2.0) + t112) * t114
    t123 = (t10 + (t84 * 0.5)) + (((t87 * t2) * 0.25) + (t1 * 0.125))
    t125 = (t1 * t123) / tracking_index
    t129 = ((t115 * t115) * t125) * (t125 * 4.0)
    t133 = (t90 * 1.6666666666666667) + 2.0
    t134 = t133 / t101
    t140 = (t90 * 0.27469135802469136) + 0.6296296296296297
    t144 = t90 * ((t90 * t140) + 1.2222222222222223)
    t148 = (t90 * (t144 + 1.6666666666666667)) + 0.75
    t150 = (((t90 / t101) * t134) / t101) * (t148 * 8.0)
    t154 = ((tracking_index / t10) / t10) * 0.001736111111111111
    t159 = (((t87 / t84) / (t84 * t101)) / t2) / t10
    t161 = (t159 / t1) * 2.0
    t164 = (t133 * t90) / t101
    t168 = (t154 + t161) + ((t164 * t164) * 2.6666666666666665)
    t169 = t161 + t112
    t173 = t169 + (((t133 * t133) / t101) * 2.0)
    t174 = t112 * t173
    t178 = (t150 + (t112 * (t168 + t174))) * t114
    t184 = t107 * t125
    t187 = (t90 * (t96 + 1.6666666666666667)) + 1.0
    t189 = (t187 / t101) * 2.0
    t191 = (t189 + t112) + t115
    t197 = (((t169 * t90) * (t93 + t133)) / t101) * 2.0
    t198 = t164 * 2.0
    t201 = t197 + ((t198 * t198) * 0.6666666666666666)
    t205 = t161 * ((t201 + t174) + (t154 * t189))
    t211 = (t90 * 2.5925925925925926) + 6.222222222222222
    t214 = ((t90 * t211) + 3.3333333333333335) * t90
    t218 = (((t214 / t101) * t134) + t154) + t174
    t220 = ((t191 * t115) + (t205 * t114)) + (t161 * t218)
    t182 = t129 - ((t178 * t125) * (t125 * 2.0))
    t224 = (t184 * t220) - (t184 * (t191 * t161))
    return (t182, t224)


def _predicted_position_second_derivatives_block(
    given: Arrays,
    out: Arrays,
    work: Arrays,
    single: bool,
    n0: float = 2.220446049250313e-16,
    n1: float = 3.854941057726238e-19,
    n2: float = 67108864.0,
    n3: float = 2.0,
    n4: float = 0.4166666666666667,
    n5: float = 0.04861111111111111,
    n6: float = 1.2504627916220945,
    n7: float = 8.0,
    n8: float = 0.5,
    n9: float = 0.25,
    n10: float = 0.6666666666666666,
    n11: float = 1.0,
    n12: float = 0.7777777777777778,
    n13: float = 3.3333333333333335,
    n14: float = 3.0,
    n15: float = 0.003472222222222222,
    n16: float = 0.125,
    n17: float = 4.0,
    n18: float = 1.6666666666666667,
    n19: float = 0.27469135802469136,
    n20: float = 0.6296296296296297,
    n21: float = 1.2222222222222223,
    n22: float = 0.75,
    n23: float = 0.001736111111111111,
    n24: float = 2.6666666666666665,
    n25: float = 2.5925925925925926,
    n26: float = 6.222222222222222,
) -> None:
    (tracking_index,) = given
    predicted_11, predicted_12 = out
    w0, w1, w2, w3, w4, w5, w6, w7, w8, w9, w10, w11, w12, w13, w14, w15, w16 = work
    p = sqrt(tracking_index, predicted_11)
    r = sqrt(p, predicted_12)
    t4 = divide(n0, tracking_index, w0)
    t6 = multiply(tracking_index, n1, w1)
    t7 = add(t4, t6, w0)
    c_scaled = sqrt(t7, w0)
    t10 = multiply(c_scaled, n2, w0)
    t12 = multiply(t10, r, w1)
    t14 = multiply(t12, n3, w1)
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
    t35 = multiply(t14, n8, w7)
    t36 = multiply(t30, t33, w5)
    t37 = multiply(t33, t36, w6)
    t38 = multiply(t35, t26, w4)
    t39 = subtract(t37, t38, w6)
    t40 = subtract(t36, t35, w5)
    t41 = divide(t39, t40, w6)
    t43 = multiply(t14, t41, w4)
    t44 = add(t43, t18, w4)
    t45 = sqrt(t44, w4)
    t46 = multiply(t45, n3, w5)
    t47 = add(t46, t16, w5)
    t48 = sqrt(t47, w5)
    t49 = multiply(t45, t48, w4)
    t50 = multiply(t48, t49, w5)
    t51 = multiply(t35, t41, w6)
    t52 = subtract(t50, t51, w5)
    t53 = subtract(t49, t35, w4)
    t54 = divide(t52, t53, w5)
    t56 = multiply(t14, t54, w4)
    t57 = add(t56, t18, w4)
    t58 = sqrt(t57, w4)
    t59 = multiply(t58, n3, w6)
    t60 = add(t59, t16, w6)
    t61 = sqrt(t60, w6)
    t62 = multiply(t58, t61, w4)
    t63 = multiply(t61, t62, w6)
    t64 = multiply(t35, t54, w5)
    t65 = subtract(t63, t64, w6)
    t66 = subtract(t62, t35, w4)
    t67 = divide(t65, t66, w6)
    t69 = multiply(t14, t67, w4)
    t70 = add(t69, t18, w4)
    t71 = sqrt(t70, w4)
    t72 = multiply(t71, n3, w5)
    t73 = add(t72, t16, w5)
    t74 = sqrt(t73, w5)
    t75 = multiply(t71, t74, w4)
    t76 = multiply(t74, t75, w5)
    t77 = multiply(t35, t67, w6)
    t78 = subtract(t76, t77, w5)
    t79 = subtract(t75, t35, w4)
    t80 = divide(t78, t79, w5)
    t82 = multiply(t14, t80, w1)
    t83 = add(t82, t18, w1)
    e = sqrt(t83, w1)
    t85 = multiply(e, n3, w3)
    t86 = add(t85, t16, w3)
    x = sqrt(t86, w3)
    t89 = multiply(p, n9, w2)
    t90 = divide(t89, e, w2)
    t92 = multiply(t90, n10, w4)
    t93 = add(t92, n11, w4)
    t94 = multiply(t93, t90, w5)
    t96 = multiply(t90, n12, w6)
    t98 = add(t96, n13, w7)
    t99 = multiply(t90, t98, w7)
    t101 = add(t99, n14, w7)
    t102 = divide(t94, t101, w5)
    t103 = multiply(t102, n3, w5)
    t104 = divide(p, e, w8)
    t105 = divide(t104, t101, w9)
    t106 = multiply(t105, t104, w9)
    t107 = divide(x, r, w8)
    t108 = divide(p, t10, w10)
    t109 = multiply(t107, t108, w10)
    t110 = multiply(t106, t109, w9)
    t112 = multiply(t110, n15, w9)
    t113 = add(t103, t112, w5)
    t114 = multiply(t107, n3, w10)
    t115 = multiply(t113, t114, w5)
    t116 = square(t115, w11)
    t117 = multiply(e, n8, w12)
    t118 = add(t10, t117, w12)
    t119 = multiply(x, r, w13)
    t120 = multiply(t119, n9, w13)
    t121 = multiply(p, n16, w14)
    t122 = add(t120, t121, w13)
    t123 = add(t118, t122, w12)
    t124 = multiply(p, t123, w12)
    t125 = divide(t124, tracking_index, w12)
    t126 = multiply(t116, t125, w11)
    t128 = multiply(t125, n17, w13)
    t129 = multiply(t126, t128, w11)
    t130 = divide(t90, t101, w13)
    t132 = multiply(t90, n18, w14)
    t133 = add(t132, n3, w14)
    t134 = divide(t133, t101, w15)
    t135 = multiply(t130, t134, w13)
    t136 = divide(t135, t101, w13)
    t138 = multiply(t90, n19, w16)
    t140 = add(t138, n20, w16)
    t141 = multiply(t90, t140, w16)
    t143 = add(t141, n21, w16)
    t144 = multiply(t90, t143, w16)
    t145 = add(t144, n18, w16)
    t146 = multiply(t90, t145, w16)
    t148 = add(t146, n22, w16)
    t149 = multiply(t148, n7, w16)
    t150 = multiply(t136, t149, w13)
    t151 = divide(tracking_index, t10, w16)
    t152 = divide(t151, t10, w16)
    t154 = multiply(t152, n23, w16)
    t155 = divide(x, e, w3)
    t156 = multiply(e, t101, w1)
    t157 = divide(t155, t156, w3)
    t158 = divide(t157, r, w3)
    t159 = divide(t158, t10, w3)
    t160 = divide(t159, p, w3)
    t161 = multiply(t160, n3, w3)
    t162 = add(t154, t161, w0)
    t163 = multiply(t133, t90, w1)
    t164 = divide(t163, t101, w1)
    t165 = square(t164, predicted_11)
    t167 = multiply(t165, n24, predicted_11)
    t168 = add(t162, t167, w0)
    t169 = add(t161, t112, predicted_11)
    t170 = square(t133, predicted_12)
    t171 = divide(t170, t101, predicted_12)
    t172 = multiply(t171, n3, predicted_12)
    t173 = add(t169, t172, predicted_12)
    t174 = multiply(t112, t173, predicted_12)
    t175 = add(t168, t174, w0)
    t176 = multiply(t112, t175, w0)
    t177 = add(t150, t176, w13)
    t178 = multiply(t177, t114, w13)
    t179 = multiply(t178, t125, w13)
    t180 = multiply(t125, n3, w0)
    t181 = multiply(t179, t180, w13)
    t184 = multiply(t107, t125, w8)
    t185 = add(t96, n18, w6)
    t186 = multiply(t90, t185, w6)
    t187 = add(t186, n11, w6)
    t188 = divide(t187, t101, w6)
    t189 = multiply(t188, n3, w6)
    t190 = add(t189, t112, w9)
    t191 = add(t190, t115, w9)
    t192 = multiply(t191, t115, w5)
    t193 = multiply(t169, t90, predicted_11)
    t194 = add(t93, t133, w4)
    t195 = multiply(t193, t194, predicted_11)
    t196 = divide(t195, t101, predicted_11)
    t197 = multiply(t196, n3, predicted_11)
    t198 = multiply(t164, n3, w1)
    t199 = square(t198, w1)
    t200 = multiply(t199, n10, w1)
    t201 = add(t197, t200, predicted_11)
    t202 = add(t201, t174, predicted_11)
    t203 = multiply(t154, t189, w6)
    t204 = add(t202, t203, predicted_11)
    t205 = multiply(t161, t204, predicted_11)
    t206 = multiply(t205, t114, predicted_11)
    t207 = add(t192, t206, w5)
    t209 = multiply(t90, n25, w0)
    t211 = add(t209, n26, w0)
    t212 = multiply(t90, t211, w0)
    t213 = add(t212, n13, w0)
    t214 = multiply(t213, t90, w0)
    t215 = divide(t214, t101, w0)
    t216 = multiply(t215, t134, w0)
    t217 = add(t216, t154, w0)
    t218 = add(t217, t174, w0)
    t219 = multiply(t161, t218, w0)
    t220 = add(t207, t219, w5)
    t221 = multiply(t184, t220, w5)
    t222 = multiply(t191, t161, w9)
    t223 = multiply(t184, t222, w8)
    subtract(t129, t181, predicted_11)
    subtract(t221, t223, predicted_12)


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

        delta = sqrt(64/Lambda^2 + 1/9),
        xi = sqrt(5/3 + 2 eta), eta = sqrt(7/9 + 2 delta xi), nu = 1 + xi + eta + delta

    tracking_index: Lambda, with Lambda^2 =
        jerk_deviation**2*sampling_interval**6/measurement_deviation**2; a number above 0 and
        finite.

    updated_22: second derivative by Lambda of the variance of the updated velocity times
        T^2/sigma_v^2. Error over the sum of its terms' sizes at most 38.70 * 2^-52 (float64), 41.94
        * 2^-23 (float32), proved for 5e-324 <= tracking_index <= 1.7976931348623157e308 (float64)
        and 1e-45 <= tracking_index <= 3.4028235e38 (float32). Cancellation, condition number 1: it
        bends down for a small index and up for a large one, so that it vanishes between. Digits
        that can be lost: up to 16 of 16 in float64, half or more only where 4 <= tracking_index <=
        4.9 or 6.3 <= tracking_index <= 6.7 or tracking_index >= 91000; up to 7 of 7 in float32,
        half or more only where tracking_index >= 1.2.
    updated_23: second derivative by Lambda of the covariance of updated velocity and acceleration
        times T^3/sigma_v^2. Error over the sum of its terms' sizes at most 28.14 * 2^-52 (float64),
        30.53 * 2^-23 (float32), proved for 5e-324 <= tracking_index <= 1.7976931348623157e308
        (float64) and 1e-45 <= tracking_index <= 3.4028235e38 (float32). Cancellation, condition
        number 1: what the update takes from M'' stays less than it. Digits that can be lost: up to
        3.9 of 16 in float64; up to 3.4 of 7 in float32.
    updated_33: second derivative by Lambda of the variance of the updated acceleration times
        T^4/sigma_v^2. Error over the sum of its terms' sizes at most 16.31 * 2^-52 (float64), 17.75
        * 2^-23 (float32), proved for 5e-324 <= tracking_index <= 1.7976931348623157e308 (float64)
        and 1e-45 <= tracking_index <= 3.4028235e38 (float32). Cancellation, condition number 1:
        what the update takes from M'' stays less than it. Digits that can be lost: up to 3.3 of 16
        in float64; up to 3 of 7 in float32, a quarter or more only where tracking_index >= 0.0021.

    Outside an output's range, a few numbers next to its ends apart, its true value is no normal
    number: it comes as 0, a subnormal number or infinity, never as NaN. Numbers and arrays are
    taken, arrays of any shape; inputs are broadcast. float64 and float32 stay what they are,
    integers become float64. `out`: a tuple of arrays to fill. `workers`: threads that share the
    work on long arrays.

    ValueError: an input outside its domain, with its place; `out` or `workers` that does not fit.
    TypeError: an input that is no real number of these types; in `out` what is no array of the
    results' type.

    Source: derivation random-jerk
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
    t4 = 2.220446049250313e-16 / tracking_index
    t6 = tracking_index * 3.854941057726238e-19
    t10 = form.sqrt(t4 + t6) * 67108864.0
    t14 = (t10 * t2) * 2.0
    t16 = t1 * 0.4166666666666667
    t18 = tracking_index * 0.04861111111111111
    t25 = ((t1 * t2) * 1.2504627916220945) + (8.0 / t2)
    t26 = form.near_cbrt(t25)
    t30 = form.sqrt((t14 * t26) + t18)
    t33 = form.sqrt((t30 * 2.0) + t16)
    t35 = t14 * 0.5
    t36 = t30 * t33
    t41 = ((t33 * t36) - (t35 * t26)) / (t36 - t35)
    t45 = form.sqrt((t14 * t41) + t18)
    t48 = form.sqrt((t45 * 2.0) + t16)
    t49 = t45 * t48
    t54 = ((t48 * t49) - (t35 * t41)) / (t49 - t35)
    t58 = form.sqrt((t14 * t54) + t18)
    t61 = form.sqrt((t58 * 2.0) + t16)
    t62 = t58 * t61
    t67 = ((t61 * t62) - (t35 * t54)) / (t62 - t35)
    t71 = form.sqrt((t14 * t67) + t18)
    t74 = form.sqrt((t71 * 2.0) + t16)
    t75 = t71 * t74
    t80 = ((t74 * t75) - (t35 * t67)) / (t75 - t35)
    t84 = form.sqrt((t14 * t80) + t18)
    t87 = form.sqrt((t84 * 2.0) + t16)
    t89 = t84 / t1
    t92 = (t1 * 0.25) / t84
    t94 = t92 * 0.7777777777777778
    t99 = (t92 * (t94 + 3.3333333333333335)) + 3.0
    t107 = (t92 * 3.240740740740741) + 9.074074074074074
    t111 = t92 * ((t92 * t107) + 7.611111111111111)
    t115 = (t92 / t99) * ((t111 + 1.6666666666666667) / t99)
    t118 = (t92 * (t94 + 1.6666666666666667)) + 1.0
    t121 = t1 / t84
    t124 = t87 / t2
    t127 = ((t121 / t99) * t121) * (t124 * (t1 / t10))
    t129 = t127 * 0.003472222222222222
    t130 = ((t118 / t99) * 2.0) + t129
    t137 = (((t87 / t84) / (t84 * t99)) / t2) / t10
    t139 = (t137 / t1) * 2.0
    t143 = (t92 * 2.5925925925925926) + 6.222222222222222
    t146 = ((t92 * t143) + 3.3333333333333335) * t92
    t149 = (t92 * 1.6666666666666667) + 2.0
    t155 = ((tracking_index / t10) / t10) * 0.001736111111111111
    t157 = t139 + t129
    t161 = t157 + (((t149 * t149) / t99) * 2.0)
    t163 = (((t146 / t99) * (t149 / t99)) + t155) + (t129 * t161)
    t164 = t139 * t163
    t166 = (t115 * (t130 * 4.0)) + (t164 * t161)
    t173 = (((t149 * t92) / t99) * 10.0) + (t157 * 6.0)
    t177 = (t92 * 2.3333333333333335) + 3.3333333333333335
    t182 = (((t92 * t177) + 1.0) / t99) + (t129 * 2.0)
    t185 = ((t130 * t173) + (t182 * 4.0)) + t139
    t188 = (t89 * (t99 * 4.0)) * (t166 + (t129 * t185))
    t191 = t124 * 2.0
    t195 = t191 * ((t130 * (t130 + 1.0)) + t164)
    t197 = (((t84 / t87) * (t188 / t2)) + t195) * 0.125
    t202 = (t92 * 5.041152263374485) + 20.22222222222222
    t206 = t92 * ((t92 * t202) + 28.51851851851852)
    t211 = (t92 * (t206 + 18.0)) + 8.333333333333334
    t217 = ((((t92 * t211) + 4.0) / t99) / t99) + (t164 * t149)
    t221 = (t92 * 1.2962962962962963) + 3.111111111111111
    t227 = ((t92 * ((t92 * t221) + 5.0)) + 4.0) / t99
    t232 = ((t227 * 2.0) + (t149 * t182)) + (t92 * 3.3333333333333335)
    t235 = (t89 * 4.0) * (t217 + (t129 * t232))
    t238 = t197 + ((t235 * 0.25) + 0.4166666666666667)
    t247 = ((t235 + t195) * 0.25) + 0.6666666666666666
    t248 = t195 * 0.5
    t242 = t238 - ((t235 * 0.5) + 0.8333333333333334)
    t249 = t247 - t248
    t256 = (t248 + 1.0) - (t191 * (((t2 / t87) * 0.5) * 2.0))
    return (t242, t249, t256)


def _updated_covariance_second_derivatives_block(
    given: Arrays,
    out: Arrays,
    work: Arrays,
    single: bool,
    n0: float = 2.220446049250313e-16,
    n1: float = 3.854941057726238e-19,
    n2: float = 67108864.0,
    n3: float = 2.0,
    n4: float = 0.4166666666666667,
    n5: float = 0.04861111111111111,
    n6: float = 1.2504627916220945,
    n7: float = 8.0,
    n8: float = 0.5,
    n9: float = 0.25,
    n10: float = 0.7777777777777778,
    n11: float = 3.3333333333333335,
    n12: float = 3.0,
    n13: float = 4.0,
    n14: float = 3.240740740740741,
    n15: float = 9.074074074074074,
    n16: float = 7.611111111111111,
    n17: float = 1.6666666666666667,
    n18: float = 1.0,
    n19: float = 0.003472222222222222,
    n20: float = 2.5925925925925926,
    n21: float = 6.222222222222222,
    n22: float = 0.001736111111111111,
    n23: float = 10.0,
    n24: float = 6.0,
    n25: float = 2.3333333333333335,
    n26: float = 0.125,
    n27: float = 5.041152263374485,
    n28: float = 20.22222222222222,
    n29: float = 28.51851851851852,
    n30: float = 18.0,
    n31: float = 8.333333333333334,
    n32: float = 1.2962962962962963,
    n33: float = 3.111111111111111,
    n34: float = 5.0,
    n35: float = 0.8333333333333334,
    n36: float = 0.6666666666666666,
) -> None:
    (tracking_index,) = given
    updated_22, updated_23, updated_33 = out
    w0, w1, w2, w3, w4, w5, w6, w7, w8, w9, w10, w11, w12, w13 = work
    p = sqrt(tracking_index, updated_22)
    r = sqrt(p, updated_23)
    t4 = divide(n0, tracking_index, updated_33)
    t6 = multiply(tracking_index, n1, w0)
    t7 = add(t4, t6, updated_33)
    c_scaled = sqrt(t7, updated_33)
    t10 = multiply(c_scaled, n2, updated_33)
    t12 = multiply(t10, r, w0)
    t14 = multiply(t12, n3, w0)
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
    t35 = multiply(t14, n8, w6)
    t36 = multiply(t30, t33, w4)
    t37 = multiply(t33, t36, w5)
    t38 = multiply(t35, t26, w3)
    t39 = subtract(t37, t38, w5)
    t40 = subtract(t36, t35, w4)
    t41 = divide(t39, t40, w5)
    t43 = multiply(t14, t41, w3)
    t44 = add(t43, t18, w3)
    t45 = sqrt(t44, w3)
    t46 = multiply(t45, n3, w4)
    t47 = add(t46, t16, w4)
    t48 = sqrt(t47, w4)
    t49 = multiply(t45, t48, w3)
    t50 = multiply(t48, t49, w4)
    t51 = multiply(t35, t41, w5)
    t52 = subtract(t50, t51, w4)
    t53 = subtract(t49, t35, w3)
    t54 = divide(t52, t53, w4)
    t56 = multiply(t14, t54, w3)
    t57 = add(t56, t18, w3)
    t58 = sqrt(t57, w3)
    t59 = multiply(t58, n3, w5)
    t60 = add(t59, t16, w5)
    t61 = sqrt(t60, w5)
    t62 = multiply(t58, t61, w3)
    t63 = multiply(t61, t62, w5)
    t64 = multiply(t35, t54, w4)
    t65 = subtract(t63, t64, w5)
    t66 = subtract(t62, t35, w3)
    t67 = divide(t65, t66, w5)
    t69 = multiply(t14, t67, w3)
    t70 = add(t69, t18, w3)
    t71 = sqrt(t70, w3)
    t72 = multiply(t71, n3, w4)
    t73 = add(t72, t16, w4)
    t74 = sqrt(t73, w4)
    t75 = multiply(t71, t74, w3)
    t76 = multiply(t74, t75, w4)
    t77 = multiply(t35, t67, w5)
    t78 = subtract(t76, t77, w4)
    t79 = subtract(t75, t35, w3)
    t80 = divide(t78, t79, w4)
    t82 = multiply(t14, t80, w0)
    t83 = add(t82, t18, w0)
    e = sqrt(t83, w0)
    t85 = multiply(e, n3, w2)
    t86 = add(t85, t16, w2)
    x = sqrt(t86, w2)
    t88 = divide(e, x, w1)
    t89 = divide(e, p, w3)
    t91 = multiply(p, n9, w4)
    t92 = divide(t91, e, w4)
    t94 = multiply(t92, n10, w5)
    t96 = add(t94, n11, w6)
    t97 = multiply(t92, t96, w6)
    t99 = add(t97, n12, w6)
    t101 = multiply(t99, n13, w7)
    t102 = multiply(t89, t101, w7)
    t103 = divide(t92, t99, w8)
    t105 = multiply(t92, n14, w9)
    t107 = add(t105, n15, w9)
    t108 = multiply(t92, t107, w9)
    t110 = add(t108, n16, w9)
    t111 = multiply(t92, t110, w9)
    t113 = add(t111, n17, w9)
    t114 = divide(t113, t99, w9)
    t115 = multiply(t103, t114, w8)
    t116 = add(t94, n17, w5)
    t117 = multiply(t92, t116, w5)
    t118 = add(t117, n18, w5)
    t119 = divide(t118, t99, w5)
    t120 = multiply(t119, n3, w5)
    t121 = divide(p, e, w9)
    t122 = divide(t121, t99, w10)
    t123 = multiply(t122, t121, w10)
    t124 = divide(x, r, w9)
    t125 = divide(p, t10, w11)
    t126 = multiply(t124, t125, w11)
    t127 = multiply(t123, t126, w10)
    t129 = multiply(t127, n19, w10)
    t130 = add(t120, t129, w5)
    t131 = multiply(t130, n13, w11)
    t132 = multiply(t115, t131, w8)
    t133 = divide(x, e, w11)
    t134 = multiply(e, t99, w0)
    t135 = divide(t133, t134, w11)
    t136 = divide(t135, r, w11)
    t137 = divide(t136, t10, w11)
    t138 = divide(t137, p, w11)
    t139 = multiply(t138, n3, w11)
    t141 = multiply(t92, n20, w0)
    t143 = add(t141, n21, w0)
    t144 = multiply(t92, t143, w0)
    t145 = add(t144, n11, w0)
    t146 = multiply(t145, t92, w0)
    t147 = divide(t146, t99, w0)
    t148 = multiply(t92, n17, updated_22)
    t149 = add(t148, n3, updated_22)
    t150 = divide(t149, t99, w12)
    t151 = multiply(t147, t150, w0)
    t152 = divide(tracking_index, t10, w12)
    t153 = divide(t152, t10, w12)
    t155 = multiply(t153, n22, w12)
    t156 = add(t151, t155, w0)
    t157 = add(t139, t129, w12)
    t158 = square(t149, updated_33)
    t159 = divide(t158, t99, updated_33)
    t160 = multiply(t159, n3, updated_33)
    t161 = add(t157, t160, updated_33)
    t162 = multiply(t129, t161, w13)
    t163 = add(t156, t162, w0)
    t164 = multiply(t139, t163, w0)
    t165 = multiply(t164, t161, updated_33)
    t166 = add(t132, t165, w8)
    t167 = multiply(t149, t92, w13)
    t168 = divide(t167, t99, w13)
    t170 = multiply(t168, n23, w13)
    t172 = multiply(t157, n24, w12)
    t173 = add(t170, t172, w13)
    t174 = multiply(t130, t173, w13)
    t176 = multiply(t92, n25, w12)
    t177 = add(t176, n11, w12)
    t178 = multiply(t92, t177, w12)
    t179 = add(t178, n18, w12)
    t180 = divide(t179, t99, w12)
    t181 = multiply(t129, n3, updated_33)
    t182 = add(t180, t181, w12)
    t183 = multiply(t182, n13, updated_33)
    t184 = add(t174, t183, w13)
    t185 = add(t184, t139, w13)
    t186 = multiply(t129, t185, w13)
    t187 = add(t166, t186, w8)
    t188 = multiply(t102, t187, w7)
    t189 = divide(t188, r, w7)
    t190 = multiply(t88, t189, w1)
    t191 = multiply(t124, n3, w9)
    t192 = add(t130, n18, w7)
    t193 = multiply(t130, t192, w5)
    t194 = add(t193, t164, w5)
    t195 = multiply(t191, t194, w5)
    t196 = add(t190, t195, w1)
    t197 = multiply(t196, n26, w1)
    t198 = multiply(t89, n13, w3)
    t200 = multiply(t92, n27, w7)
    t202 = add(t200, n28, w7)
    t203 = multiply(t92, t202, w7)
    t205 = add(t203, n29, w7)
    t206 = multiply(t92, t205, w7)
    t208 = add(t206, n30, w7)
    t209 = multiply(t92, t208, w7)
    t211 = add(t209, n31, w7)
    t212 = multiply(t92, t211, w7)
    t213 = add(t212, n13, w7)
    t214 = divide(t213, t99, w7)
    t215 = divide(t214, t99, w7)
    t216 = multiply(t164, t149, w0)
    t217 = add(t215, t216, w7)
    t219 = multiply(t92, n32, w0)
    t221 = add(t219, n33, w0)
    t222 = multiply(t92, t221, w0)
    t224 = add(t222, n34, w0)
    t225 = multiply(t92, t224, w0)
    t226 = add(t225, n13, w0)
    t227 = divide(t226, t99, w0)
    t228 = multiply(t227, n3, w0)
    t229 = multiply(t149, t182, updated_22)
    t230 = add(t228, t229, w0)
    t231 = multiply(t92, n11, w4)
    t232 = add(t230, t231, w0)
    t233 = multiply(t129, t232, w10)
    t234 = add(t217, t233, w7)
    t235 = multiply(t198, t234, w3)
    t236 = multiply(t235, n9, w0)
    t237 = add(t236, n4, w0)
    t238 = add(t197, t237, w1)
    t239 = multiply(t235, n8, w0)
    t241 = add(t239, n35, w0)
    t244 = add(t235, t195, w3)
    t245 = multiply(t244, n9, w3)
    t247 = add(t245, n36, w3)
    t248 = multiply(t195, n8, w5)
    t251 = add(t248, n18, w4)
    t252 = divide(r, x, updated_23)
    t253 = multiply(t252, n8, updated_23)
    t254 = multiply(t253, n3, updated_23)
    t255 = multiply(t191, t254, w9)
    subtract(t238, t241, updated_22)
    subtract(t247, t248, updated_23)
    subtract(t251, t255, updated_33)


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
        G (G^2 + 4/3 G + 4/9) = 64/Lambda^2, t = sqrt(1 + G), g = sqrt(G^2 + 1/3 G + 1/9),
        a = sqrt(2/3 + 2 g - G), real_pole = (t - 1)/(t + 1), half_sum = (g - 1)/(1 + a + g)

    tracking_index: Lambda, with Lambda^2 =
        jerk_deviation**2*sampling_interval**6/measurement_deviation**2; a number above 0 and
        finite.

    real_pole: positive pole, the one that is real for every index. Relative error at most 8.17 *
        2^-52 (float64), 8.41 * 2^-23 (float32), proved for 5e-324 <= tracking_index <=
        4.022342378982779e154 (float64) and 1e-45 <= tracking_index <= 5.5340232e19 (float32).
    modulus: geometric mean of the moduli of the other two, that of each while they are complex.
        Relative error at most 6.63 * 2^-52 (float64), 6.62 * 2^-23 (float32), proved for 5e-324 <=
        tracking_index <= 1.7976931348623157e308 (float64) and 1e-45 <= tracking_index <=
        3.4028235e38 (float32).
    half_sum: half the sum of these two, the real part of each while they are complex. Relative
        error at most 32.21 * 2^-52 (float64), 32.08 * 2^-23 (float32), proved for 5e-324 <=
        tracking_index <= 1.7976931348623157e308 (float64) and 1e-45 <= tracking_index <=
        3.4028235e38 (float32).
    quarter_discriminant: square of half their difference, negative while they are complex. Relative
        error at most 36.65 * 2^-52 (float64), 36.68 * 2^-23 (float32), proved for 5e-324 <=
        tracking_index <= 4.5726476713518234e154 (float64) and 1e-45 <= tracking_index <=
        6.2911447e19 (float32).

    Outside an output's range, a few numbers next to its ends apart, its true value is no normal
    number: it comes as 0, a subnormal number or infinity, never as NaN. Numbers and arrays are
    taken, arrays of any shape; inputs are broadcast. float64 and float32 stay what they are,
    integers become float64. `out`: a tuple of arrays to fill. `workers`: threads that share the
    work on long arrays.

    ValueError: an input outside its domain, with its place; `out` or `workers` that does not fit.
    TypeError: an input that is no real number of these types; in `out` what is no array of the
    results' type.

    Source: derivation random-jerk
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
    t17 = (tracking_index * t8) * 0.0023148148148148147
    t19 = t14 * 0.020833333333333332
    t20 = t17 * t17
    t21 = t20 * t17
    t26 = t13 + ((t17 * t19) + (t21 * 2.0))
    t29 = (t20 * 3.0) + t19
    t33 = t13 + ((t14 * t8) * 0.003608439117670059)
    t39 = t33 + ((t17 * (t19 * 2.0)) + (t21 * 8.0))
    t40 = form.near_cbrt(t39)
    t42 = t29 * t40
    t43 = t42 + t26
    t45 = form.sqrt(t40 * t43)
    t46 = form.sqrt(t45)
    t50 = (t43 * 0.25) + (t42 * 0.25)
    t51 = t45 * t46
    t56 = ((t46 * t51) - (t50 * t40)) / (t51 - t50)
    t58 = t29 * t56
    t59 = t58 + t26
    t61 = form.sqrt(t56 * t59)
    t62 = form.sqrt(t61)
    t65 = (t59 * 0.25) + (t58 * 0.25)
    t66 = t61 * t62
    t71 = ((t62 * t66) - (t65 * t56)) / (t66 - t65)
    t73 = t29 * t71
    t74 = t73 + t26
    t76 = form.sqrt(t71 * t74)
    t77 = form.sqrt(t76)
    t80 = (t74 * 0.25) + (t73 * 0.25)
    t81 = t76 * t77
    t86 = ((t77 * t81) - (t80 * t71)) / (t81 - t80)
    t88 = t29 * t86
    t89 = t88 + t26
    t91 = form.sqrt(t86 * t89)
    t92 = form.sqrt(t91)
    t95 = (t89 * 0.25) + (t88 * 0.25)
    t96 = t91 * t92
    t101 = ((t92 * t96) - (t95 * t86)) / (t96 - t95)
    t106 = form.sqrt(t101 * ((t29 * t101) + t26))
    t108 = form.sqrt(t106) + t17
    t109 = t108 / t8
    t110 = t8 / t108
    t112 = t110 / tracking_index
    t114 = form.sqrt(t112 + 1.0)
    t116 = 2.220446049250313e-16 / tracking_index
    t118 = tracking_index * 3.854941057726238e-19
    t123 = (form.sqrt(t116 + t118) * 67108864.0) * 8.0
    t125 = (t123 / t114) / t1
    t129 = (t112 * 0.3333333333333333) + 0.1111111111111111
    t134 = (t125 + 0.6666666666666666) + (t129 / (t112 + t125))
    t137 = (form.sqrt(t134) + 1.0) + t125
    t138 = t114 + 1.0
    t144 = tracking_index * 0.026244520780915007
    t146 = t109 + ((t110 * 0.012355631892026117) + t144)
    t147 = (6.172778260761257 - tracking_index) + (
        1.3118362574005005e-07 if form.single else 2.6682135546293653e-16
    )
    t151 = ((t147 / t146) / tracking_index) * (6.172778260761257 + tracking_index)
    t162 = (t112 + 1.1240937744230048) / (t125 + 1.0)
    t167 = t112 * ((t112 + 0.8888888888888888) / t134)
    t155 = (t112 / t138) / t138
    t158 = ((form.sqrt(t109) / t1) * 8.0) / t137
    t164 = ((t151 * 0.026244520780915007) * t162) / t137
    t171 = ((t167 / t137) / t137) * -3.0
    return (t155, t158, t164, t171)


def _closed_loop_poles_block(
    given: Arrays,
    out: Arrays,
    work: Arrays,
    single: bool,
    n0: float = 1.0,
    n1: float = 0.015625,
    n2: float = 0.0023148148148148147,
    n3: float = 0.020833333333333332,
    n4: float = 2.0,
    n5: float = 3.0,
    n6: float = 0.003608439117670059,
    n7: float = 8.0,
    n8: float = 0.25,
    n9: float = 2.220446049250313e-16,
    n10: float = 3.854941057726238e-19,
    n11: float = 67108864.0,
    n12: float = 0.3333333333333333,
    n13: float = 0.1111111111111111,
    n14: float = 0.6666666666666666,
    n15: float = 0.012355631892026117,
    n16: float = 0.026244520780915007,
    n17: float = 6.172778260761257,
    n18: float = 1.3118362574005005e-07,
    n19: float = 2.6682135546293653e-16,
    n20: float = 1.1240937744230048,
    n21: float = 0.8888888888888888,
    n22: float = -3.0,
) -> None:
    (tracking_index,) = given
    real_pole, modulus, half_sum, quarter_discriminant = out
    w0, w1, w2, w3, w4, w5 = work
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
    t19 = multiply(t14, n3, w1)
    t20 = square(t17, w2)
    t21 = multiply(t20, t17, w3)
    t22 = multiply(t17, t19, w4)
    t24 = multiply(t21, n4, w5)
    t25 = add(t22, t24, w4)
    t26 = add(t13, t25, w4)
    t28 = multiply(t20, n5, w2)
    t29 = add(t28, t19, w2)
    t30 = multiply(t14, t8, modulus)
    t32 = multiply(t30, n6, modulus)
    t33 = add(t13, t32, w0)
    t34 = multiply(t19, n4, w1)
    t35 = multiply(t17, t34, w1)
    t37 = multiply(t21, n7, w3)
    t38 = add(t35, t37, w1)
    t39 = add(t33, t38, w0)
    t40 = near_cbrt(t39, w0, single)
    t42 = multiply(t29, t40, w1)
    t43 = add(t42, t26, w3)
    t44 = multiply(t40, t43, w5)
    t45 = sqrt(t44, w5)
    t46 = sqrt(t45, modulus)
    t48 = multiply(t43, n8, w3)
    t49 = multiply(t42, n8, w1)
    t50 = add(t48, t49, w3)
    t51 = multiply(t45, t46, w5)
    t52 = multiply(t46, t51, modulus)
    t53 = multiply(t50, t40, w0)
    t54 = subtract(t52, t53, modulus)
    t55 = subtract(t51, t50, w5)
    t56 = divide(t54, t55, modulus)
    t58 = multiply(t29, t56, w0)
    t59 = add(t58, t26, w1)
    t60 = multiply(t56, t59, w3)
    t61 = sqrt(t60, w3)
    t62 = sqrt(t61, w5)
    t63 = multiply(t59, n8, w1)
    t64 = multiply(t58, n8, w0)
    t65 = add(t63, t64, w1)
    t66 = multiply(t61, t62, w3)
    t67 = multiply(t62, t66, w5)
    t68 = multiply(t65, t56, modulus)
    t69 = subtract(t67, t68, w5)
    t70 = subtract(t66, t65, w3)
    t71 = divide(t69, t70, w5)
    t73 = multiply(t29, t71, w0)
    t74 = add(t73, t26, w1)
    t75 = multiply(t71, t74, w3)
    t76 = sqrt(t75, w3)
    t77 = sqrt(t76, modulus)
    t78 = multiply(t74, n8, w1)
    t79 = multiply(t73, n8, w0)
    t80 = add(t78, t79, w1)
    t81 = multiply(t76, t77, w3)
    t82 = multiply(t77, t81, modulus)
    t83 = multiply(t80, t71, w5)
    t84 = subtract(t82, t83, modulus)
    t85 = subtract(t81, t80, w3)
    t86 = divide(t84, t85, modulus)
    t88 = multiply(t29, t86, w0)
    t89 = add(t88, t26, w1)
    t90 = multiply(t86, t89, w3)
    t91 = sqrt(t90, w3)
    t92 = sqrt(t91, w5)
    t93 = multiply(t89, n8, w1)
    t94 = multiply(t88, n8, w0)
    t95 = add(t93, t94, w1)
    t96 = multiply(t91, t92, w3)
    t97 = multiply(t92, t96, w5)
    t98 = multiply(t95, t86, modulus)
    t99 = subtract(t97, t98, w5)
    t100 = subtract(t96, t95, w3)
    t101 = divide(t99, t100, w5)
    t103 = multiply(t29, t101, w2)
    t104 = add(t103, t26, w2)
    t105 = multiply(t101, t104, w5)
    inner = sqrt(t105, w5)
    z = sqrt(inner, w5)
    t108 = add(z, t17, w5)
    t109 = divide(t108, t8, w0)
    t110 = divide(t8, t108, quarter_discriminant)
    v_root = sqrt(t109, w1)
    t112 = divide(t110, tracking_index, w2)
    t113 = add(t112, n0, w3)
    t = sqrt(t113, w3)
    t116 = divide(n9, tracking_index, w4)
    t118 = multiply(tracking_index, n10, w5)
    t119 = add(t116, t118, w4)
    c_scaled = sqrt(t119, w4)
    t122 = multiply(c_scaled, n11, w4)
    t123 = multiply(t122, n7, w4)
    t124 = divide(t123, t, w4)
    t125 = divide(t124, p, w4)
    t127 = multiply(t112, n12, w5)
    t129 = add(t127, n13, w5)
    t130 = add(t112, t125, modulus)
    t131 = divide(t129, t130, w5)
    t133 = add(t125, n14, modulus)
    t134 = add(t133, t131, modulus)
    a = sqrt(t134, w5)
    t136 = add(a, n0, w5)
    t137 = add(t136, t125, w5)
    t138 = add(t, n0, w3)
    t142 = multiply(t110, n15, quarter_discriminant)
    t144 = multiply(tracking_index, n16, half_sum)
    t145 = add(t142, t144, quarter_discriminant)
    t146 = add(t109, t145, w0)
    rest = n18 if single else n19
    subtract(n17, tracking_index, half_sum)
    t147 = add(half_sum, rest, half_sum)
    t148 = divide(t147, t146, half_sum)
    t149 = divide(t148, tracking_index, half_sum)
    t150 = add(n17, tracking_index, w0)
    t151 = multiply(t149, t150, half_sum)
    t153 = multiply(t151, n16, half_sum)
    t154 = divide(t112, t138, w0)
    t156 = divide(v_root, p, w1)
    t157 = multiply(t156, n7, w1)
    t160 = add(t112, n20, real_pole)
    t161 = add(t125, n0, w4)
    t162 = divide(t160, t161, real_pole)
    t163 = multiply(t153, t162, half_sum)
    t165 = add(t112, n21, w4)
    t166 = divide(t165, t134, w4)
    t167 = multiply(t112, t166, w2)
    t168 = divide(t167, t137, w2)
    t169 = divide(t168, t137, w2)
    divide(t154, t138, real_pole)
    divide(t157, t137, modulus)
    divide(t163, t137, half_sum)
    multiply(t169, n22, quarter_discriminant)


_CLOSED_LOOP_POLES = Signature(
    "closed_loop_poles",
    (_TRACKING_INDEX_DOMAIN,),
    ("real_pole", "modulus", "half_sum", "quarter_discriminant"),
    6,
    _closed_loop_poles_block,
    numbers=_closed_loop_poles_of_numbers,
)
