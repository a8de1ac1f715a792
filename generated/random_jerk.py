# Made by: gainproof generate random-jerk
# From: gainproof derive random-jerk, SymPy 1.14.0
"""Random jerk (constant over each interval): steady state with measured position."""

from __future__ import annotations

from typing import TYPE_CHECKING, NamedTuple

import numpy as np

from gainproof.generated._runtime import Domain, Signature, evaluate, near_cbrt

if TYPE_CHECKING:
    from numpy.typing import ArrayLike

    from gainproof.generated._runtime import Arrays, Real

__all__ = [
    "GainDerivatives",
    "Gains",
    "GainsWithDerivatives",
    "InnovationDeviation",
    "PredictedCovariance",
    "PredictedCovarianceDerivatives",
    "PredictorGainDerivatives",
    "PredictorGains",
    "UpdatedCovariance",
    "gain_derivatives",
    "gains",
    "gains_with_derivatives",
    "innovation_deviation",
    "predicted_covariance",
    "predicted_covariance_derivatives",
    "predictor_gain_derivatives",
    "predictor_gains",
    "updated_covariance",
]

_TRACKING_INDEX_DOMAIN = Domain(
    "tracking_index",
    "a number above 0 and finite",
    (5e-324, 1.7976931348623157e308),
    (1.401298464324817e-45, 3.4028234663852886e38),
)
_TRACKING_INDEX_DOMAIN_2 = Domain(
    "tracking_index",
    "a number above 0 and at most 2^511, in float32 above 0 and at most 2^63",
    (5e-324, 6.703903964971299e153),
    (1.401298464324817e-45, 9.223372036854776e18),
)
_TRACKING_INDEX_DOMAIN_3 = Domain(
    "tracking_index",
    "a number above 0 and at most 2^1000, in float32 above 0 and at most 2^120",
    (5e-324, 1.0715086071862673e301),
    (1.401298464324817e-45, 1.329227995784916e36),
)


class Gains(NamedTuple):
    """Result of `gains`."""

    alpha: Real
    """Position gain."""
    beta: Real
    """Velocity gain times the sampling interval."""
    gamma: Real
    """Acceleration gain times the square of the sampling interval."""


def gains(tracking_index: ArrayLike, *, out: tuple[Real, Real, Real] | None = None) -> Gains:
    """Steady-state filter gain.

        alpha = 2 (1 + eta)/nu, beta = 4 xi/nu, gamma = 8/nu,
        delta = sqrt(64/Lambda^2 + 1/9),
        xi = sqrt(5/3 + 2 eta), eta = sqrt(7/9 + 2 delta xi), nu = 1 + xi + eta + delta

    tracking_index: Lambda, with Lambda^2 =
        jerk_deviation**2*sampling_interval**6/measurement_deviation**2; a number above 0 and
        finite.

    alpha: position gain. Relative error at most 6.19 * 2^-52 (float64), 6.19 * 2^-23 (float32),
        proved for 5e-324 <= tracking_index <= 1.7976931348623157e308 (float64) and 1e-45 <=
        tracking_index <= 3.4028235e38 (float32).
    beta: velocity gain times the sampling interval. Relative error at most 6.11 * 2^-52 (float64),
        6.11 * 2^-23 (float32), proved for 5e-324 <= tracking_index <= 1.7976931348623157e308
        (float64) and 1e-45 <= tracking_index <= 3.4028235e38 (float32).
    gamma: acceleration gain times the square of the sampling interval. Relative error at most 4.61
        * 2^-52 (float64), 4.61 * 2^-23 (float32), proved for 2.2250738585072014e-308 <=
        tracking_index <= 1.7976931348623157e308 (float64) and 1.1754945e-38 <= tracking_index <=
        3.4028235e38 (float32).

    Outside an output's range, a few numbers next to its ends apart, its true value is no normal
    number: it comes as 0, a subnormal number or infinity, never as NaN. Numbers and arrays are
    taken, arrays of any shape; inputs are broadcast. float64 and float32 stay what they are,
    integers become float64. `out`: a tuple of arrays to fill.

    ValueError: an input outside its domain, with its place; `out` that does not fit. TypeError: an
    input that is no real number of these types.

    Source: derivation random-jerk
    """
    return Gains(*evaluate(_GAINS, (tracking_index,), out))


def _gains_block(given: Arrays, out: Arrays, work: Arrays, single: bool) -> None:
    (tracking_index,) = given
    alpha, beta, gamma = out
    w0, w1, w2, w3, w4, w5, w6 = work
    p = np.sqrt(tracking_index, gamma)
    r = np.sqrt(p, alpha)
    t4 = np.divide(2.220446049250313e-16, tracking_index, beta)
    t6 = np.multiply(tracking_index, 3.854941057726238e-19, w0)
    t7 = np.add(t4, t6, beta)
    c_scaled = np.sqrt(t7, beta)
    t10 = np.multiply(c_scaled, 67108864.0, beta)
    t11 = np.multiply(t10, r, w0)
    t13 = np.multiply(t11, 2.0, w0)
    t15 = np.multiply(p, 0.4166666666666667, w1)
    t17 = np.multiply(tracking_index, 0.04861111111111111, w2)
    t18 = np.multiply(p, r, w3)
    t21 = np.multiply(t18, 1.2504627916220945, w3)
    t23 = np.divide(8.0, r, w4)
    t24 = np.add(t21, t23, w3)
    t25 = near_cbrt(t24, w3, single)
    t27 = np.multiply(t13, t25, w4)
    t28 = np.add(t27, t17, w4)
    t29 = np.sqrt(t28, w4)
    t30 = np.multiply(t29, 2.0, w5)
    t31 = np.add(t30, t15, w5)
    t32 = np.sqrt(t31, w5)
    t34 = np.multiply(t13, 0.5, w6)
    t35 = np.multiply(t29, t32, w4)
    t36 = np.multiply(t32, t35, w5)
    t37 = np.multiply(t34, t25, w3)
    t38 = np.subtract(t36, t37, w5)
    t39 = np.subtract(t35, t34, w4)
    t40 = np.divide(t38, t39, w5)
    t42 = np.multiply(t13, t40, w3)
    t43 = np.add(t42, t17, w3)
    t44 = np.sqrt(t43, w3)
    t45 = np.multiply(t44, 2.0, w4)
    t46 = np.add(t45, t15, w4)
    t47 = np.sqrt(t46, w4)
    t48 = np.multiply(t44, t47, w3)
    t49 = np.multiply(t47, t48, w4)
    t50 = np.multiply(t34, t40, w5)
    t51 = np.subtract(t49, t50, w4)
    t52 = np.subtract(t48, t34, w3)
    t53 = np.divide(t51, t52, w4)
    t55 = np.multiply(t13, t53, w3)
    t56 = np.add(t55, t17, w3)
    t57 = np.sqrt(t56, w3)
    t58 = np.multiply(t57, 2.0, w5)
    t59 = np.add(t58, t15, w5)
    t60 = np.sqrt(t59, w5)
    t61 = np.multiply(t57, t60, w3)
    t62 = np.multiply(t60, t61, w5)
    t63 = np.multiply(t34, t53, w4)
    t64 = np.subtract(t62, t63, w5)
    t65 = np.subtract(t61, t34, w3)
    t66 = np.divide(t64, t65, w5)
    t68 = np.multiply(t13, t66, w3)
    t69 = np.add(t68, t17, w3)
    t70 = np.sqrt(t69, w3)
    t71 = np.multiply(t70, 2.0, w4)
    t72 = np.add(t71, t15, w4)
    t73 = np.sqrt(t72, w4)
    t74 = np.multiply(t70, t73, w3)
    t75 = np.multiply(t73, t74, w4)
    t76 = np.multiply(t34, t66, w5)
    t77 = np.subtract(t75, t76, w4)
    t78 = np.subtract(t74, t34, w3)
    t79 = np.divide(t77, t78, w4)
    t81 = np.multiply(t13, t79, w0)
    t82 = np.add(t81, t17, w0)
    e = np.sqrt(t82, w0)
    t84 = np.multiply(e, 2.0, w2)
    t85 = np.add(t84, t15, w2)
    x = np.sqrt(t85, w2)
    t87 = np.multiply(e, 0.5, w1)
    t88 = np.add(t10, t87, beta)
    t89 = np.multiply(x, r, w2)
    t91 = np.multiply(t89, 0.25, w1)
    t92 = np.multiply(p, 0.125, w3)
    t93 = np.add(t91, t92, w1)
    t94 = np.add(t88, t93, w1)
    t95 = np.multiply(p, 0.25, w3)
    t96 = np.add(e, t95, w0)
    np.divide(t96, t94, alpha)
    np.divide(t89, t94, beta)
    np.divide(p, t94, gamma)


_GAINS = Signature(
    "gains",
    (_TRACKING_INDEX_DOMAIN,),
    ("alpha", "beta", "gamma"),
    7,
    _gains_block,
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
    tracking_index: ArrayLike, *, out: tuple[Real, Real, Real] | None = None
) -> GainDerivatives:
    """First derivatives of the filter gain with respect to the tracking index.

        delta = sqrt(64/Lambda^2 + 1/9),
        xi = sqrt(5/3 + 2 eta), eta = sqrt(7/9 + 2 delta xi), nu = 1 + xi + eta + delta

    tracking_index: Lambda, with Lambda^2 =
        jerk_deviation**2*sampling_interval**6/measurement_deviation**2; a number above 0 and
        finite.

    alpha: derivative of the position gain. Relative error at most 17.11 * 2^-52 (float64), 17.11 *
        2^-23 (float32), proved for 5e-324 <= tracking_index <= 6.147487532734931e102 (float64) and
        1e-45 <= tracking_index <= 7.604528e12 (float32).
    beta: derivative of the velocity gain times the sampling interval. Relative error at most 18.09
        * 2^-52 (float64), 18.08 * 2^-23 (float32), proved for 5e-324 <= tracking_index <=
        1.6993864335471447e103 (float64) and 1e-45 <= tracking_index <= 2.1021648e13 (float32).
    gamma: derivative of the acceleration gain times the square of the sampling interval. Relative
        error at most 17.14 * 2^-52 (float64), 17.14 * 2^-23 (float32), proved for 5e-324 <=
        tracking_index <= 2.109262031745273e103 (float64) and 1e-45 <= tracking_index <=
        2.6091866e13 (float32).

    Outside an output's range, a few numbers next to its ends apart, its true value is no normal
    number: it comes as 0, a subnormal number or infinity, never as NaN. Numbers and arrays are
    taken, arrays of any shape; inputs are broadcast. float64 and float32 stay what they are,
    integers become float64. `out`: a tuple of arrays to fill.

    ValueError: an input outside its domain, with its place; `out` that does not fit. TypeError: an
    input that is no real number of these types.

    Source: derivation random-jerk
    """
    return GainDerivatives(*evaluate(_GAIN_DERIVATIVES, (tracking_index,), out))


def _gain_derivatives_block(given: Arrays, out: Arrays, work: Arrays, single: bool) -> None:
    (tracking_index,) = given
    alpha, beta, gamma = out
    w0, w1, w2, w3, w4, w5, w6, w7, w8 = work
    p = np.sqrt(tracking_index, alpha)
    r = np.sqrt(p, beta)
    t4 = np.divide(2.220446049250313e-16, tracking_index, gamma)
    t6 = np.multiply(tracking_index, 3.854941057726238e-19, w0)
    t7 = np.add(t4, t6, gamma)
    c_scaled = np.sqrt(t7, gamma)
    t10 = np.multiply(c_scaled, 67108864.0, gamma)
    t12 = np.multiply(t10, r, w0)
    t14 = np.multiply(t12, 2.0, w0)
    t16 = np.multiply(p, 0.4166666666666667, w1)
    t18 = np.multiply(tracking_index, 0.04861111111111111, w2)
    t19 = np.multiply(p, r, w3)
    t22 = np.multiply(t19, 1.2504627916220945, w4)
    t24 = np.divide(8.0, r, w5)
    t25 = np.add(t22, t24, w4)
    t26 = near_cbrt(t25, w4, single)
    t28 = np.multiply(t14, t26, w5)
    t29 = np.add(t28, t18, w5)
    t30 = np.sqrt(t29, w5)
    t31 = np.multiply(t30, 2.0, w6)
    t32 = np.add(t31, t16, w6)
    t33 = np.sqrt(t32, w6)
    t35 = np.multiply(t14, 0.5, w7)
    t36 = np.multiply(t30, t33, w5)
    t37 = np.multiply(t33, t36, w6)
    t38 = np.multiply(t35, t26, w4)
    t39 = np.subtract(t37, t38, w6)
    t40 = np.subtract(t36, t35, w5)
    t41 = np.divide(t39, t40, w6)
    t43 = np.multiply(t14, t41, w4)
    t44 = np.add(t43, t18, w4)
    t45 = np.sqrt(t44, w4)
    t46 = np.multiply(t45, 2.0, w5)
    t47 = np.add(t46, t16, w5)
    t48 = np.sqrt(t47, w5)
    t49 = np.multiply(t45, t48, w4)
    t50 = np.multiply(t48, t49, w5)
    t51 = np.multiply(t35, t41, w6)
    t52 = np.subtract(t50, t51, w5)
    t53 = np.subtract(t49, t35, w4)
    t54 = np.divide(t52, t53, w5)
    t56 = np.multiply(t14, t54, w4)
    t57 = np.add(t56, t18, w4)
    t58 = np.sqrt(t57, w4)
    t59 = np.multiply(t58, 2.0, w6)
    t60 = np.add(t59, t16, w6)
    t61 = np.sqrt(t60, w6)
    t62 = np.multiply(t58, t61, w4)
    t63 = np.multiply(t61, t62, w6)
    t64 = np.multiply(t35, t54, w5)
    t65 = np.subtract(t63, t64, w6)
    t66 = np.subtract(t62, t35, w4)
    t67 = np.divide(t65, t66, w6)
    t69 = np.multiply(t14, t67, w4)
    t70 = np.add(t69, t18, w4)
    t71 = np.sqrt(t70, w4)
    t72 = np.multiply(t71, 2.0, w5)
    t73 = np.add(t72, t16, w5)
    t74 = np.sqrt(t73, w5)
    t75 = np.multiply(t71, t74, w4)
    t76 = np.multiply(t74, t75, w5)
    t77 = np.multiply(t35, t67, w6)
    t78 = np.subtract(t76, t77, w5)
    t79 = np.subtract(t75, t35, w4)
    t80 = np.divide(t78, t79, w5)
    t82 = np.multiply(t14, t80, w0)
    t83 = np.add(t82, t18, w0)
    e = np.sqrt(t83, w0)
    t85 = np.multiply(e, 2.0, w2)
    t86 = np.add(t85, t16, w2)
    x = np.sqrt(t86, w2)
    t88 = np.square(e, w1)
    t90 = np.multiply(t88, 0.75, w4)
    t91 = np.multiply(p, e, w5)
    t93 = np.multiply(t91, 0.20833333333333334, w6)
    t95 = np.multiply(tracking_index, 0.012152777777777778, w7)
    t96 = np.add(t90, t93, w4)
    t97 = np.add(t96, t95, w4)
    t99 = np.multiply(t88, 0.25, w1)
    t101 = np.multiply(t91, 0.10416666666666667, w5)
    t102 = np.add(t99, t101, w1)
    t103 = np.add(t102, t95, w1)
    t104 = np.multiply(x, r, w5)
    t105 = np.divide(t104, t10, w6)
    t106 = np.multiply(t105, p, w6)
    t108 = np.multiply(t106, 0.006944444444444444, w6)
    t110 = np.multiply(p, 0.16666666666666666, w7)
    t111 = np.add(e, t110, w7)
    t112 = np.add(t111, t108, w6)
    t113 = np.divide(t112, t97, w6)
    t114 = np.multiply(t104, 0.25, w8)
    t115 = np.multiply(t113, t114, w6)
    t116 = np.divide(x, t19, w3)
    t117 = np.multiply(t111, 0.125, w7)
    t118 = np.multiply(t104, t117, w7)
    t119 = np.add(t103, t118, w1)
    t120 = np.divide(t104, t97, w5)
    t121 = np.multiply(x, 0.25, w7)
    t122 = np.multiply(r, 0.5, beta)
    t123 = np.add(x, t122, w2)
    t124 = np.multiply(t121, t123, w7)
    t125 = np.multiply(t120, t124, w5)
    t126 = np.add(t125, 1.0, w5)
    t127 = np.divide(t115, tracking_index, w6)
    t128 = np.multiply(t127, 2.0, w6)
    t129 = np.divide(t119, t97, w1)
    t130 = np.divide(t116, t10, w3)
    t131 = np.multiply(t129, t130, w1)
    t132 = np.multiply(t131, 2.0, w1)
    t133 = np.multiply(t10, p, w2)
    t134 = np.divide(t126, t133, w5)
    t135 = np.multiply(e, 0.5, w0)
    t136 = np.add(t10, t135, gamma)
    t137 = np.multiply(p, 0.125, w0)
    t138 = np.add(t114, t137, w8)
    t139 = np.add(t136, t138, gamma)
    t140 = np.multiply(p, t139, gamma)
    t141 = np.divide(t128, t140, w6)
    t143 = np.divide(t132, t140, w1)
    t145 = np.divide(t134, t140, w5)
    np.divide(t141, t140, alpha)
    np.divide(t143, t140, beta)
    np.divide(t145, t140, gamma)


_GAIN_DERIVATIVES = Signature(
    "gain_derivatives",
    (_TRACKING_INDEX_DOMAIN,),
    ("alpha", "beta", "gamma"),
    9,
    _gain_derivatives_block,
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
    tracking_index: ArrayLike, *, out: tuple[Real, Real, Real, Real, Real, Real] | None = None
) -> GainsWithDerivatives:
    """Filter gain and its first derivatives in one pass.

        delta = sqrt(64/Lambda^2 + 1/9),
        xi = sqrt(5/3 + 2 eta), eta = sqrt(7/9 + 2 delta xi), nu = 1 + xi + eta + delta

    tracking_index: Lambda, with Lambda^2 =
        jerk_deviation**2*sampling_interval**6/measurement_deviation**2; a number above 0 and
        finite.

    alpha: position gain. Relative error at most 6.19 * 2^-52 (float64), 6.19 * 2^-23 (float32),
        proved for 5e-324 <= tracking_index <= 1.7976931348623157e308 (float64) and 1e-45 <=
        tracking_index <= 3.4028235e38 (float32).
    beta: velocity gain times the sampling interval. Relative error at most 6.11 * 2^-52 (float64),
        6.11 * 2^-23 (float32), proved for 5e-324 <= tracking_index <= 1.7976931348623157e308
        (float64) and 1e-45 <= tracking_index <= 3.4028235e38 (float32).
    gamma: acceleration gain times the square of the sampling interval. Relative error at most 4.61
        * 2^-52 (float64), 4.61 * 2^-23 (float32), proved for 2.2250738585072014e-308 <=
        tracking_index <= 1.7976931348623157e308 (float64) and 1.1754945e-38 <= tracking_index <=
        3.4028235e38 (float32).
    d_alpha: derivative of the position gain. Relative error at most 17.11 * 2^-52 (float64), 17.11
        * 2^-23 (float32), proved for 5e-324 <= tracking_index <= 6.147487532734931e102 (float64)
        and 1e-45 <= tracking_index <= 7.604528e12 (float32).
    d_beta: derivative of the velocity gain times the sampling interval. Relative error at most
        18.09 * 2^-52 (float64), 18.08 * 2^-23 (float32), proved for 5e-324 <= tracking_index <=
        1.6993864335471447e103 (float64) and 1e-45 <= tracking_index <= 2.1021648e13 (float32).
    d_gamma: derivative of the acceleration gain times the square of the sampling interval. Relative
        error at most 17.14 * 2^-52 (float64), 17.14 * 2^-23 (float32), proved for 5e-324 <=
        tracking_index <= 2.109262031745273e103 (float64) and 1e-45 <= tracking_index <=
        2.6091866e13 (float32).

    Outside an output's range, a few numbers next to its ends apart, its true value is no normal
    number: it comes as 0, a subnormal number or infinity, never as NaN. Numbers and arrays are
    taken, arrays of any shape; inputs are broadcast. float64 and float32 stay what they are,
    integers become float64. `out`: a tuple of arrays to fill.

    ValueError: an input outside its domain, with its place; `out` that does not fit. TypeError: an
    input that is no real number of these types.

    Source: derivation random-jerk
    """
    return GainsWithDerivatives(*evaluate(_GAINS_WITH_DERIVATIVES, (tracking_index,), out))


def _gains_with_derivatives_block(given: Arrays, out: Arrays, work: Arrays, single: bool) -> None:
    (tracking_index,) = given
    alpha, beta, gamma, d_alpha, d_beta, d_gamma = out
    w0, w1, w2, w3, w4, w5, w6, w7, w8 = work
    p = np.sqrt(tracking_index, gamma)
    r = np.sqrt(p, alpha)
    t4 = np.divide(2.220446049250313e-16, tracking_index, beta)
    t6 = np.multiply(tracking_index, 3.854941057726238e-19, w0)
    t7 = np.add(t4, t6, beta)
    c_scaled = np.sqrt(t7, d_alpha)
    t10 = np.multiply(c_scaled, 67108864.0, d_alpha)
    t12 = np.multiply(t10, r, w0)
    t14 = np.multiply(t12, 2.0, w0)
    t16 = np.multiply(p, 0.4166666666666667, beta)
    t18 = np.multiply(tracking_index, 0.04861111111111111, w1)
    t19 = np.multiply(p, r, w2)
    t22 = np.multiply(t19, 1.2504627916220945, w3)
    t24 = np.divide(8.0, r, d_beta)
    t25 = np.add(t22, t24, w3)
    t26 = near_cbrt(t25, w3, single)
    t28 = np.multiply(t14, t26, d_beta)
    t29 = np.add(t28, t18, d_beta)
    t30 = np.sqrt(t29, d_gamma)
    t31 = np.multiply(t30, 2.0, d_beta)
    t32 = np.add(t31, t16, d_beta)
    t33 = np.sqrt(t32, d_beta)
    t35 = np.multiply(t14, 0.5, w4)
    t36 = np.multiply(t30, t33, d_gamma)
    t37 = np.multiply(t33, t36, d_beta)
    t38 = np.multiply(t35, t26, w3)
    t39 = np.subtract(t37, t38, d_beta)
    t40 = np.subtract(t36, t35, d_gamma)
    t41 = np.divide(t39, t40, d_beta)
    t43 = np.multiply(t14, t41, w3)
    t44 = np.add(t43, t18, w3)
    t45 = np.sqrt(t44, w3)
    t46 = np.multiply(t45, 2.0, d_gamma)
    t47 = np.add(t46, t16, d_gamma)
    t48 = np.sqrt(t47, d_gamma)
    t49 = np.multiply(t45, t48, w3)
    t50 = np.multiply(t48, t49, d_gamma)
    t51 = np.multiply(t35, t41, d_beta)
    t52 = np.subtract(t50, t51, d_gamma)
    t53 = np.subtract(t49, t35, w3)
    t54 = np.divide(t52, t53, d_gamma)
    t56 = np.multiply(t14, t54, w3)
    t57 = np.add(t56, t18, w3)
    t58 = np.sqrt(t57, w3)
    t59 = np.multiply(t58, 2.0, d_beta)
    t60 = np.add(t59, t16, d_beta)
    t61 = np.sqrt(t60, d_beta)
    t62 = np.multiply(t58, t61, w3)
    t63 = np.multiply(t61, t62, d_beta)
    t64 = np.multiply(t35, t54, d_gamma)
    t65 = np.subtract(t63, t64, d_beta)
    t66 = np.subtract(t62, t35, w3)
    t67 = np.divide(t65, t66, d_beta)
    t69 = np.multiply(t14, t67, w3)
    t70 = np.add(t69, t18, w3)
    t71 = np.sqrt(t70, w3)
    t72 = np.multiply(t71, 2.0, d_gamma)
    t73 = np.add(t72, t16, d_gamma)
    t74 = np.sqrt(t73, d_gamma)
    t75 = np.multiply(t71, t74, w3)
    t76 = np.multiply(t74, t75, d_gamma)
    t77 = np.multiply(t35, t67, d_beta)
    t78 = np.subtract(t76, t77, d_gamma)
    t79 = np.subtract(t75, t35, w3)
    t80 = np.divide(t78, t79, d_gamma)
    t82 = np.multiply(t14, t80, w0)
    t83 = np.add(t82, t18, w0)
    e = np.sqrt(t83, w0)
    t85 = np.multiply(e, 2.0, w1)
    t86 = np.add(t85, t16, w1)
    x = np.sqrt(t86, w1)
    t88 = np.multiply(e, 0.5, w3)
    t89 = np.add(t10, t88, w3)
    t90 = np.multiply(x, r, w4)
    t92 = np.multiply(t90, 0.25, beta)
    t93 = np.multiply(p, 0.125, d_beta)
    t94 = np.add(t92, t93, d_beta)
    t95 = np.add(t89, t94, w3)
    t96 = np.multiply(p, 0.25, d_beta)
    t97 = np.add(e, t96, d_beta)
    t101 = np.square(e, d_gamma)
    t103 = np.multiply(t101, 0.75, w5)
    t104 = np.multiply(p, e, w6)
    t106 = np.multiply(t104, 0.20833333333333334, w7)
    t108 = np.multiply(tracking_index, 0.012152777777777778, w8)
    t109 = np.add(t103, t106, w5)
    t110 = np.add(t109, t108, w5)
    t111 = np.multiply(t101, 0.25, d_gamma)
    t113 = np.multiply(t104, 0.10416666666666667, w6)
    t114 = np.add(t111, t113, d_gamma)
    t115 = np.add(t114, t108, d_gamma)
    t116 = np.divide(t90, t10, w6)
    t117 = np.multiply(t116, p, w6)
    t119 = np.multiply(t117, 0.006944444444444444, w6)
    t121 = np.multiply(p, 0.16666666666666666, w7)
    t122 = np.add(e, t121, w0)
    t123 = np.add(t122, t119, w6)
    t124 = np.divide(t123, t110, w6)
    t125 = np.multiply(t124, t92, w6)
    t126 = np.divide(x, t19, w2)
    t127 = np.multiply(t122, 0.125, w0)
    t128 = np.multiply(t90, t127, w0)
    t129 = np.add(t115, t128, d_gamma)
    t130 = np.divide(t90, t110, w0)
    t131 = np.multiply(x, 0.25, w7)
    t132 = np.multiply(r, 0.5, alpha)
    t133 = np.add(x, t132, w1)
    t134 = np.multiply(t131, t133, w7)
    t135 = np.multiply(t130, t134, w0)
    t136 = np.add(t135, 1.0, w0)
    t137 = np.divide(t125, tracking_index, w6)
    t138 = np.multiply(t137, 2.0, w6)
    t139 = np.divide(t129, t110, d_gamma)
    t140 = np.divide(t126, t10, w2)
    t141 = np.multiply(t139, t140, d_gamma)
    t142 = np.multiply(t141, 2.0, d_gamma)
    t143 = np.multiply(t10, p, d_alpha)
    t144 = np.divide(t136, t143, w0)
    t145 = np.multiply(p, t95, w1)
    t146 = np.divide(t138, t145, w6)
    t148 = np.divide(t142, t145, d_gamma)
    t150 = np.divide(t144, t145, w0)
    np.divide(t97, t95, alpha)
    np.divide(t90, t95, beta)
    np.divide(p, t95, gamma)
    np.divide(t146, t145, d_alpha)
    np.divide(t148, t145, d_beta)
    np.divide(t150, t145, d_gamma)


_GAINS_WITH_DERIVATIVES = Signature(
    "gains_with_derivatives",
    (_TRACKING_INDEX_DOMAIN,),
    ("alpha", "beta", "gamma", "d_alpha", "d_beta", "d_gamma"),
    9,
    _gains_with_derivatives_block,
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
    tracking_index: ArrayLike, *, out: tuple[Real, Real, Real] | None = None
) -> PredictorGains:
    """Steady-state predictor gain F K.

        delta = sqrt(64/Lambda^2 + 1/9),
        xi = sqrt(5/3 + 2 eta), eta = sqrt(7/9 + 2 delta xi), nu = 1 + xi + eta + delta

    tracking_index: Lambda, with Lambda^2 =
        jerk_deviation**2*sampling_interval**6/measurement_deviation**2; a number above 0 and
        finite.

    position: position entry of F K, alpha + beta + gamma/2. Relative error at most 6.22 * 2^-52
        (float64), 6.22 * 2^-23 (float32), proved for 5e-324 <= tracking_index <=
        1.7976931348623157e308 (float64) and 1e-45 <= tracking_index <= 3.4028235e38 (float32).
    velocity: velocity entry of F K times the sampling interval, beta + gamma. Relative error at
        most 6.59 * 2^-52 (float64), 6.59 * 2^-23 (float32), proved for 5e-324 <= tracking_index <=
        1.7976931348623157e308 (float64) and 1e-45 <= tracking_index <= 3.4028235e38 (float32).
    acceleration: acceleration entry of F K times the square of the sampling interval, gamma.
        Relative error at most 4.61 * 2^-52 (float64), 4.61 * 2^-23 (float32), proved for
        2.2250738585072014e-308 <= tracking_index <= 1.7976931348623157e308 (float64) and
        1.1754945e-38 <= tracking_index <= 3.4028235e38 (float32).

    Outside an output's range, a few numbers next to its ends apart, its true value is no normal
    number: it comes as 0, a subnormal number or infinity, never as NaN. Numbers and arrays are
    taken, arrays of any shape; inputs are broadcast. float64 and float32 stay what they are,
    integers become float64. `out`: a tuple of arrays to fill.

    ValueError: an input outside its domain, with its place; `out` that does not fit. TypeError: an
    input that is no real number of these types.

    Source: derivation random-jerk
    """
    return PredictorGains(*evaluate(_PREDICTOR_GAINS, (tracking_index,), out))


def _predictor_gains_block(given: Arrays, out: Arrays, work: Arrays, single: bool) -> None:
    (tracking_index,) = given
    position, velocity, acceleration = out
    w0, w1, w2, w3, w4, w5, w6 = work
    p = np.sqrt(tracking_index, acceleration)
    r = np.sqrt(p, position)
    t4 = np.divide(2.220446049250313e-16, tracking_index, velocity)
    t6 = np.multiply(tracking_index, 3.854941057726238e-19, w0)
    t7 = np.add(t4, t6, velocity)
    c_scaled = np.sqrt(t7, velocity)
    t10 = np.multiply(c_scaled, 67108864.0, velocity)
    t11 = np.multiply(t10, r, w0)
    t13 = np.multiply(t11, 2.0, w0)
    t15 = np.multiply(p, 0.4166666666666667, w1)
    t17 = np.multiply(tracking_index, 0.04861111111111111, w2)
    t18 = np.multiply(p, r, w3)
    t21 = np.multiply(t18, 1.2504627916220945, w3)
    t23 = np.divide(8.0, r, w4)
    t24 = np.add(t21, t23, w3)
    t25 = near_cbrt(t24, w3, single)
    t27 = np.multiply(t13, t25, w4)
    t28 = np.add(t27, t17, w4)
    t29 = np.sqrt(t28, w4)
    t30 = np.multiply(t29, 2.0, w5)
    t31 = np.add(t30, t15, w5)
    t32 = np.sqrt(t31, w5)
    t34 = np.multiply(t13, 0.5, w6)
    t35 = np.multiply(t29, t32, w4)
    t36 = np.multiply(t32, t35, w5)
    t37 = np.multiply(t34, t25, w3)
    t38 = np.subtract(t36, t37, w5)
    t39 = np.subtract(t35, t34, w4)
    t40 = np.divide(t38, t39, w5)
    t42 = np.multiply(t13, t40, w3)
    t43 = np.add(t42, t17, w3)
    t44 = np.sqrt(t43, w3)
    t45 = np.multiply(t44, 2.0, w4)
    t46 = np.add(t45, t15, w4)
    t47 = np.sqrt(t46, w4)
    t48 = np.multiply(t44, t47, w3)
    t49 = np.multiply(t47, t48, w4)
    t50 = np.multiply(t34, t40, w5)
    t51 = np.subtract(t49, t50, w4)
    t52 = np.subtract(t48, t34, w3)
    t53 = np.divide(t51, t52, w4)
    t55 = np.multiply(t13, t53, w3)
    t56 = np.add(t55, t17, w3)
    t57 = np.sqrt(t56, w3)
    t58 = np.multiply(t57, 2.0, w5)
    t59 = np.add(t58, t15, w5)
    t60 = np.sqrt(t59, w5)
    t61 = np.multiply(t57, t60, w3)
    t62 = np.multiply(t60, t61, w5)
    t63 = np.multiply(t34, t53, w4)
    t64 = np.subtract(t62, t63, w5)
    t65 = np.subtract(t61, t34, w3)
    t66 = np.divide(t64, t65, w5)
    t68 = np.multiply(t13, t66, w3)
    t69 = np.add(t68, t17, w3)
    t70 = np.sqrt(t69, w3)
    t71 = np.multiply(t70, 2.0, w4)
    t72 = np.add(t71, t15, w4)
    t73 = np.sqrt(t72, w4)
    t74 = np.multiply(t70, t73, w3)
    t75 = np.multiply(t73, t74, w4)
    t76 = np.multiply(t34, t66, w5)
    t77 = np.subtract(t75, t76, w4)
    t78 = np.subtract(t74, t34, w3)
    t79 = np.divide(t77, t78, w4)
    t81 = np.multiply(t13, t79, w0)
    t82 = np.add(t81, t17, w0)
    e = np.sqrt(t82, w0)
    t84 = np.multiply(e, 2.0, w2)
    t85 = np.add(t84, t15, w2)
    x = np.sqrt(t85, w2)
    t87 = np.multiply(e, 0.5, w1)
    t88 = np.add(t10, t87, velocity)
    t89 = np.multiply(x, r, w2)
    t91 = np.multiply(t89, 0.25, w1)
    t92 = np.multiply(p, 0.125, w3)
    t93 = np.add(t91, t92, w1)
    t94 = np.add(t88, t93, w1)
    t96 = np.multiply(p, 0.75, w3)
    t97 = np.add(t89, t96, w3)
    t98 = np.add(e, t97, w0)
    t100 = np.add(t89, p, w2)
    np.divide(t98, t94, position)
    np.divide(t100, t94, velocity)
    np.divide(p, t94, acceleration)


_PREDICTOR_GAINS = Signature(
    "predictor_gains",
    (_TRACKING_INDEX_DOMAIN,),
    ("position", "velocity", "acceleration"),
    7,
    _predictor_gains_block,
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
    tracking_index: ArrayLike, *, out: tuple[Real, Real, Real] | None = None
) -> PredictorGainDerivatives:
    """First derivatives of the predictor gain.

        delta = sqrt(64/Lambda^2 + 1/9),
        xi = sqrt(5/3 + 2 eta), eta = sqrt(7/9 + 2 delta xi), nu = 1 + xi + eta + delta

    tracking_index: Lambda, with Lambda^2 =
        jerk_deviation**2*sampling_interval**6/measurement_deviation**2; a number above 0 and
        finite.

    position: derivative of the position entry of F K, alpha + beta + gamma/2. Relative error at
        most 18.57 * 2^-52 (float64), 18.57 * 2^-23 (float32), proved for 5e-324 <= tracking_index
        <= 2.1423048991561227e103 (float64) and 1e-45 <= tracking_index <= 2.650061e13 (float32).
    velocity: derivative of the velocity entry of F K times the sampling interval, beta + gamma.
        Relative error at most 18.06 * 2^-52 (float64), 18.06 * 2^-23 (float32), proved for 5e-324
        <= tracking_index <= 2.426769755425277e103 (float64) and 1e-45 <= tracking_index <=
        3.001948e13 (float32).
    acceleration: derivative of the acceleration entry of F K times the square of the sampling
        interval, gamma. Relative error at most 17.13 * 2^-52 (float64), 17.13 * 2^-23 (float32),
        proved for 5e-324 <= tracking_index <= 2.109262031745273e103 (float64) and 1e-45 <=
        tracking_index <= 2.6091866e13 (float32).

    Outside an output's range, a few numbers next to its ends apart, its true value is no normal
    number: it comes as 0, a subnormal number or infinity, never as NaN. Numbers and arrays are
    taken, arrays of any shape; inputs are broadcast. float64 and float32 stay what they are,
    integers become float64. `out`: a tuple of arrays to fill.

    ValueError: an input outside its domain, with its place; `out` that does not fit. TypeError: an
    input that is no real number of these types.

    Source: derivation random-jerk
    """
    return PredictorGainDerivatives(*evaluate(_PREDICTOR_GAIN_DERIVATIVES, (tracking_index,), out))


def _predictor_gain_derivatives_block(
    given: Arrays, out: Arrays, work: Arrays, single: bool
) -> None:
    (tracking_index,) = given
    position, velocity, acceleration = out
    w0, w1, w2, w3, w4, w5, w6, w7, w8 = work
    p = np.sqrt(tracking_index, position)
    r = np.sqrt(p, velocity)
    t4 = np.divide(2.220446049250313e-16, tracking_index, acceleration)
    t6 = np.multiply(tracking_index, 3.854941057726238e-19, w0)
    t7 = np.add(t4, t6, acceleration)
    c_scaled = np.sqrt(t7, acceleration)
    t10 = np.multiply(c_scaled, 67108864.0, acceleration)
    t12 = np.multiply(t10, r, w0)
    t14 = np.multiply(t12, 2.0, w0)
    t16 = np.multiply(p, 0.4166666666666667, w1)
    t18 = np.multiply(tracking_index, 0.04861111111111111, w2)
    t19 = np.multiply(p, r, w3)
    t22 = np.multiply(t19, 1.2504627916220945, w4)
    t24 = np.divide(8.0, r, w5)
    t25 = np.add(t22, t24, w4)
    t26 = near_cbrt(t25, w4, single)
    t28 = np.multiply(t14, t26, w5)
    t29 = np.add(t28, t18, w5)
    t30 = np.sqrt(t29, w5)
    t31 = np.multiply(t30, 2.0, w6)
    t32 = np.add(t31, t16, w6)
    t33 = np.sqrt(t32, w6)
    t35 = np.multiply(t14, 0.5, w7)
    t36 = np.multiply(t30, t33, w5)
    t37 = np.multiply(t33, t36, w6)
    t38 = np.multiply(t35, t26, w4)
    t39 = np.subtract(t37, t38, w6)
    t40 = np.subtract(t36, t35, w5)
    t41 = np.divide(t39, t40, w6)
    t43 = np.multiply(t14, t41, w4)
    t44 = np.add(t43, t18, w4)
    t45 = np.sqrt(t44, w4)
    t46 = np.multiply(t45, 2.0, w5)
    t47 = np.add(t46, t16, w5)
    t48 = np.sqrt(t47, w5)
    t49 = np.multiply(t45, t48, w4)
    t50 = np.multiply(t48, t49, w5)
    t51 = np.multiply(t35, t41, w6)
    t52 = np.subtract(t50, t51, w5)
    t53 = np.subtract(t49, t35, w4)
    t54 = np.divide(t52, t53, w5)
    t56 = np.multiply(t14, t54, w4)
    t57 = np.add(t56, t18, w4)
    t58 = np.sqrt(t57, w4)
    t59 = np.multiply(t58, 2.0, w6)
    t60 = np.add(t59, t16, w6)
    t61 = np.sqrt(t60, w6)
    t62 = np.multiply(t58, t61, w4)
    t63 = np.multiply(t61, t62, w6)
    t64 = np.multiply(t35, t54, w5)
    t65 = np.subtract(t63, t64, w6)
    t66 = np.subtract(t62, t35, w4)
    t67 = np.divide(t65, t66, w6)
    t69 = np.multiply(t14, t67, w4)
    t70 = np.add(t69, t18, w4)
    t71 = np.sqrt(t70, w4)
    t72 = np.multiply(t71, 2.0, w5)
    t73 = np.add(t72, t16, w5)
    t74 = np.sqrt(t73, w5)
    t75 = np.multiply(t71, t74, w4)
    t76 = np.multiply(t74, t75, w5)
    t77 = np.multiply(t35, t67, w6)
    t78 = np.subtract(t76, t77, w5)
    t79 = np.subtract(t75, t35, w4)
    t80 = np.divide(t78, t79, w5)
    t82 = np.multiply(t14, t80, w0)
    t83 = np.add(t82, t18, w0)
    e = np.sqrt(t83, w0)
    t85 = np.multiply(e, 2.0, w2)
    t86 = np.add(t85, t16, w2)
    x = np.sqrt(t86, w2)
    t88 = np.square(e, w1)
    t90 = np.multiply(t88, 0.75, w4)
    t91 = np.multiply(p, e, w5)
    t93 = np.multiply(t91, 0.20833333333333334, w6)
    t95 = np.multiply(tracking_index, 0.012152777777777778, w7)
    t96 = np.add(t90, t93, w4)
    t97 = np.add(t96, t95, w4)
    t99 = np.multiply(t88, 0.25, w1)
    t101 = np.multiply(t91, 0.10416666666666667, w5)
    t102 = np.add(t99, t101, w1)
    t103 = np.add(t102, t95, w1)
    t104 = np.multiply(x, r, w5)
    t105 = np.divide(t104, t10, w6)
    t106 = np.multiply(t105, p, w6)
    t108 = np.multiply(t106, 0.006944444444444444, w6)
    t110 = np.multiply(p, 0.16666666666666666, w7)
    t111 = np.add(e, t110, w7)
    t112 = np.add(t111, t108, w6)
    t113 = np.divide(t112, t97, w6)
    t114 = np.multiply(t104, 0.25, w8)
    t115 = np.multiply(t113, t114, w6)
    t116 = np.divide(x, t19, w3)
    t117 = np.multiply(t111, 0.125, w7)
    t118 = np.multiply(t104, t117, w7)
    t119 = np.add(t103, t118, w1)
    t120 = np.divide(t104, t97, w5)
    t121 = np.multiply(x, 0.25, w7)
    t122 = np.multiply(r, 0.5, velocity)
    t123 = np.add(x, t122, w2)
    t124 = np.multiply(t121, t123, w7)
    t125 = np.multiply(t120, t124, w5)
    t126 = np.add(t125, 1.0, w5)
    t127 = np.divide(t115, tracking_index, w6)
    t128 = np.multiply(t127, 2.0, w6)
    t129 = np.divide(t119, t97, w1)
    t130 = np.divide(t116, t10, w3)
    t131 = np.multiply(t129, t130, w1)
    t132 = np.multiply(t131, 2.0, w1)
    t133 = np.multiply(t10, p, w2)
    t134 = np.divide(t126, t133, w5)
    t135 = np.multiply(t134, 0.5, w2)
    t136 = np.add(t132, t135, w2)
    t137 = np.add(t128, t136, w6)
    t138 = np.add(t132, t134, w1)
    t139 = np.multiply(e, 0.5, w0)
    t140 = np.add(t10, t139, acceleration)
    t141 = np.multiply(p, 0.125, w0)
    t142 = np.add(t114, t141, w8)
    t143 = np.add(t140, t142, acceleration)
    t144 = np.multiply(p, t143, acceleration)
    t145 = np.divide(t137, t144, w6)
    t147 = np.divide(t138, t144, w1)
    t149 = np.divide(t134, t144, w5)
    np.divide(t145, t144, position)
    np.divide(t147, t144, velocity)
    np.divide(t149, t144, acceleration)


_PREDICTOR_GAIN_DERIVATIVES = Signature(
    "predictor_gain_derivatives",
    (_TRACKING_INDEX_DOMAIN,),
    ("position", "velocity", "acceleration"),
    9,
    _predictor_gain_derivatives_block,
)


class InnovationDeviation(NamedTuple):
    """Result of `innovation_deviation`."""

    innovation_deviation: Real
    """Standard deviation of an innovation over sigma_v."""


def innovation_deviation(
    tracking_index: ArrayLike, *, out: tuple[Real] | None = None
) -> InnovationDeviation:
    """Standard deviation of an innovation in units of sigma_v.

        sigma = Lambda nu/8,
        delta = sqrt(64/Lambda^2 + 1/9),
        xi = sqrt(5/3 + 2 eta), eta = sqrt(7/9 + 2 delta xi), nu = 1 + xi + eta + delta

    tracking_index: Lambda, with Lambda^2 =
        jerk_deviation**2*sampling_interval**6/measurement_deviation**2; a number above 0 and
        finite.

    innovation_deviation: standard deviation of an innovation over sigma_v. Relative error at most
        5.01 * 2^-52 (float64), 5.01 * 2^-23 (float32), proved for 5e-324 <= tracking_index <=
        1.7976931348623157e308 (float64) and 1e-45 <= tracking_index <= 3.4028235e38 (float32).

    Outside an output's range, a few numbers next to its ends apart, its true value is no normal
    number: it comes as 0, a subnormal number or infinity, never as NaN. Numbers and arrays are
    taken, arrays of any shape; inputs are broadcast. float64 and float32 stay what they are,
    integers become float64. `out`: a tuple of arrays to fill.

    ValueError: an input outside its domain, with its place; `out` that does not fit. TypeError: an
    input that is no real number of these types.

    Source: derivation random-jerk
    """
    return InnovationDeviation(*evaluate(_INNOVATION_DEVIATION, (tracking_index,), out))


def _innovation_deviation_block(given: Arrays, out: Arrays, work: Arrays, single: bool) -> None:
    (tracking_index,) = given
    (innovation_deviation,) = out
    w0, w1, w2, w3, w4, w5, w6, w7, w8 = work
    p = np.sqrt(tracking_index, innovation_deviation)
    r = np.sqrt(p, w0)
    t4 = np.divide(2.220446049250313e-16, tracking_index, w1)
    t6 = np.multiply(tracking_index, 3.854941057726238e-19, w2)
    t7 = np.add(t4, t6, w1)
    c_scaled = np.sqrt(t7, w1)
    t10 = np.multiply(c_scaled, 67108864.0, w1)
    t11 = np.multiply(t10, r, w2)
    t13 = np.multiply(t11, 2.0, w2)
    t15 = np.multiply(p, 0.4166666666666667, w3)
    t17 = np.multiply(tracking_index, 0.04861111111111111, w4)
    t18 = np.multiply(p, r, w5)
    t21 = np.multiply(t18, 1.2504627916220945, w5)
    t23 = np.divide(8.0, r, w6)
    t24 = np.add(t21, t23, w5)
    t25 = near_cbrt(t24, w5, single)
    t27 = np.multiply(t13, t25, w6)
    t28 = np.add(t27, t17, w6)
    t29 = np.sqrt(t28, w6)
    t30 = np.multiply(t29, 2.0, w7)
    t31 = np.add(t30, t15, w7)
    t32 = np.sqrt(t31, w7)
    t34 = np.multiply(t13, 0.5, w8)
    t35 = np.multiply(t29, t32, w6)
    t36 = np.multiply(t32, t35, w7)
    t37 = np.multiply(t34, t25, w5)
    t38 = np.subtract(t36, t37, w7)
    t39 = np.subtract(t35, t34, w6)
    t40 = np.divide(t38, t39, w7)
    t42 = np.multiply(t13, t40, w5)
    t43 = np.add(t42, t17, w5)
    t44 = np.sqrt(t43, w5)
    t45 = np.multiply(t44, 2.0, w6)
    t46 = np.add(t45, t15, w6)
    t47 = np.sqrt(t46, w6)
    t48 = np.multiply(t44, t47, w5)
    t49 = np.multiply(t47, t48, w6)
    t50 = np.multiply(t34, t40, w7)
    t51 = np.subtract(t49, t50, w6)
    t52 = np.subtract(t48, t34, w5)
    t53 = np.divide(t51, t52, w6)
    t55 = np.multiply(t13, t53, w5)
    t56 = np.add(t55, t17, w5)
    t57 = np.sqrt(t56, w5)
    t58 = np.multiply(t57, 2.0, w7)
    t59 = np.add(t58, t15, w7)
    t60 = np.sqrt(t59, w7)
    t61 = np.multiply(t57, t60, w5)
    t62 = np.multiply(t60, t61, w7)
    t63 = np.multiply(t34, t53, w6)
    t64 = np.subtract(t62, t63, w7)
    t65 = np.subtract(t61, t34, w5)
    t66 = np.divide(t64, t65, w7)
    t68 = np.multiply(t13, t66, w5)
    t69 = np.add(t68, t17, w5)
    t70 = np.sqrt(t69, w5)
    t71 = np.multiply(t70, 2.0, w6)
    t72 = np.add(t71, t15, w6)
    t73 = np.sqrt(t72, w6)
    t74 = np.multiply(t70, t73, w5)
    t75 = np.multiply(t73, t74, w6)
    t76 = np.multiply(t34, t66, w7)
    t77 = np.subtract(t75, t76, w6)
    t78 = np.subtract(t74, t34, w5)
    t79 = np.divide(t77, t78, w6)
    t81 = np.multiply(t13, t79, w2)
    t82 = np.add(t81, t17, w2)
    e = np.sqrt(t82, w2)
    t84 = np.multiply(e, 2.0, w4)
    t85 = np.add(t84, t15, w4)
    x = np.sqrt(t85, w4)
    t87 = np.multiply(e, 0.5, w2)
    t88 = np.add(t10, t87, w1)
    t89 = np.multiply(x, r, w4)
    t91 = np.multiply(t89, 0.25, w4)
    t92 = np.multiply(p, 0.125, w0)
    t93 = np.add(t91, t92, w4)
    t94 = np.add(t88, t93, w1)
    np.multiply(p, t94, innovation_deviation)


_INNOVATION_DEVIATION = Signature(
    "innovation_deviation",
    (_TRACKING_INDEX_DOMAIN,),
    ("innovation_deviation",),
    9,
    _innovation_deviation_block,
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
    tracking_index: ArrayLike, *, out: tuple[Real, Real, Real, Real, Real, Real] | None = None
) -> PredictedCovariance:
    """Predicted covariance in units of sigma_v^2 and T.

        predicted_1j = sigma^2 (alpha, beta, gamma), sigma = Lambda nu/8,
        delta = sqrt(64/Lambda^2 + 1/9),
        xi = sqrt(5/3 + 2 eta), eta = sqrt(7/9 + 2 delta xi), nu = 1 + xi + eta + delta

    tracking_index: Lambda, with Lambda^2 =
        jerk_deviation**2*sampling_interval**6/measurement_deviation**2; a number above 0 and at
        most 2^511, in float32 above 0 and at most 2^63.

    predicted_11: variance of the predicted position over sigma_v^2. Relative error at most 10.92 *
        2^-52 (float64), 10.91 * 2^-23 (float32), proved for 5e-324 <= tracking_index <=
        6.703903964971299e153 (float64) and 1e-45 <= tracking_index <= 9.223372e18 (float32).
    predicted_12: covariance of predicted position and velocity times T/sigma_v^2. Relative error at
        most 10.48 * 2^-52 (float64), 10.48 * 2^-23 (float32), proved for 5e-324 <= tracking_index
        <= 6.703903964971299e153 (float64) and 1e-45 <= tracking_index <= 9.223372e18 (float32).
    predicted_13: covariance of predicted position and acceleration times T^2/sigma_v^2. Relative
        error at most 5.52 * 2^-52 (float64), 5.52 * 2^-23 (float32), proved for
        2.2250738585072014e-308 <= tracking_index <= 6.703903964971299e153 (float64) and
        1.1754944e-38 <= tracking_index <= 9.223372e18 (float32).
    predicted_22: variance of the predicted velocity times T^2/sigma_v^2. Relative error at most
        13.32 * 2^-52 (float64), 13.36 * 2^-23 (float32), proved for 7.416912861690675e-309 <=
        tracking_index <= 6.703903964971299e153 (float64) and 3.918315e-39 <= tracking_index <=
        9.223372e18 (float32).
    predicted_23: covariance of predicted velocity and acceleration times T^3/sigma_v^2. Relative
        error at most 7.07 * 2^-52 (float64), 7.07 * 2^-23 (float32), proved for
        1.0832677820940206e-231 <= tracking_index <= 6.703903964971299e153 (float64) and
        2.122721e-29 <= tracking_index <= 9.223372e18 (float32).
    predicted_33: variance of the predicted acceleration times T^4/sigma_v^2. Relative error at most
        6.26 * 2^-52 (float64), 6.26 * 2^-23 (float32), proved for 1.6896185209462645e-185 <=
        tracking_index <= 6.703903964971299e153 (float64) and 1.1521641e-23 <= tracking_index <=
        9.223372e18 (float32).

    Outside an output's range, a few numbers next to its ends apart, its true value is no normal
    number: it comes as 0, a subnormal number or infinity, never as NaN. Numbers and arrays are
    taken, arrays of any shape; inputs are broadcast. float64 and float32 stay what they are,
    integers become float64. `out`: a tuple of arrays to fill.

    ValueError: an input outside its domain, with its place; `out` that does not fit. TypeError: an
    input that is no real number of these types.

    Source: derivation random-jerk
    """
    return PredictedCovariance(*evaluate(_PREDICTED_COVARIANCE, (tracking_index,), out))


def _predicted_covariance_block(given: Arrays, out: Arrays, work: Arrays, single: bool) -> None:
    (tracking_index,) = given
    predicted_11, predicted_12, predicted_13, predicted_22, predicted_23, predicted_33 = out
    w0, w1, w2, w3, w4 = work
    p = np.sqrt(tracking_index, predicted_11)
    r = np.sqrt(p, predicted_12)
    t4 = np.divide(2.220446049250313e-16, tracking_index, predicted_13)
    t6 = np.multiply(tracking_index, 3.854941057726238e-19, w0)
    t7 = np.add(t4, t6, predicted_13)
    c_scaled = np.sqrt(t7, predicted_22)
    t10 = np.multiply(c_scaled, 67108864.0, predicted_22)
    t11 = np.multiply(t10, r, w0)
    t13 = np.multiply(t11, 2.0, w0)
    t15 = np.multiply(p, 0.4166666666666667, predicted_13)
    t17 = np.multiply(tracking_index, 0.04861111111111111, w1)
    t18 = np.multiply(p, r, w2)
    t21 = np.multiply(t18, 1.2504627916220945, w3)
    t23 = np.divide(8.0, r, predicted_23)
    t24 = np.add(t21, t23, w3)
    t25 = near_cbrt(t24, w3, single)
    t27 = np.multiply(t13, t25, predicted_23)
    t28 = np.add(t27, t17, predicted_23)
    t29 = np.sqrt(t28, predicted_33)
    t30 = np.multiply(t29, 2.0, predicted_23)
    t31 = np.add(t30, t15, predicted_23)
    t32 = np.sqrt(t31, predicted_23)
    t34 = np.multiply(t13, 0.5, w4)
    t35 = np.multiply(t29, t32, predicted_33)
    t36 = np.multiply(t32, t35, predicted_23)
    t37 = np.multiply(t34, t25, w3)
    t38 = np.subtract(t36, t37, predicted_23)
    t39 = np.subtract(t35, t34, predicted_33)
    t40 = np.divide(t38, t39, predicted_23)
    t42 = np.multiply(t13, t40, w3)
    t43 = np.add(t42, t17, w3)
    t44 = np.sqrt(t43, w3)
    t45 = np.multiply(t44, 2.0, predicted_33)
    t46 = np.add(t45, t15, predicted_33)
    t47 = np.sqrt(t46, predicted_33)
    t48 = np.multiply(t44, t47, w3)
    t49 = np.multiply(t47, t48, predicted_33)
    t50 = np.multiply(t34, t40, predicted_23)
    t51 = np.subtract(t49, t50, predicted_33)
    t52 = np.subtract(t48, t34, w3)
    t53 = np.divide(t51, t52, predicted_33)
    t55 = np.multiply(t13, t53, w3)
    t56 = np.add(t55, t17, w3)
    t57 = np.sqrt(t56, w3)
    t58 = np.multiply(t57, 2.0, predicted_23)
    t59 = np.add(t58, t15, predicted_23)
    t60 = np.sqrt(t59, predicted_23)
    t61 = np.multiply(t57, t60, w3)
    t62 = np.multiply(t60, t61, predicted_23)
    t63 = np.multiply(t34, t53, predicted_33)
    t64 = np.subtract(t62, t63, predicted_23)
    t65 = np.subtract(t61, t34, w3)
    t66 = np.divide(t64, t65, predicted_23)
    t68 = np.multiply(t13, t66, w3)
    t69 = np.add(t68, t17, w3)
    t70 = np.sqrt(t69, w3)
    t71 = np.multiply(t70, 2.0, predicted_33)
    t72 = np.add(t71, t15, predicted_33)
    t73 = np.sqrt(t72, predicted_33)
    t74 = np.multiply(t70, t73, w3)
    t75 = np.multiply(t73, t74, predicted_33)
    t76 = np.multiply(t34, t66, predicted_23)
    t77 = np.subtract(t75, t76, predicted_33)
    t78 = np.subtract(t74, t34, w3)
    t79 = np.divide(t77, t78, predicted_33)
    t81 = np.multiply(t13, t79, w0)
    t82 = np.add(t81, t17, w0)
    e = np.sqrt(t82, w0)
    t84 = np.multiply(e, 2.0, w1)
    t85 = np.add(t84, t15, w1)
    x = np.sqrt(t85, w1)
    t87 = np.multiply(e, 0.5, w3)
    t88 = np.add(t10, t87, predicted_22)
    t89 = np.multiply(x, r, w3)
    t91 = np.multiply(t89, 0.25, w3)
    t92 = np.multiply(p, 0.125, w4)
    t93 = np.add(t91, t92, w3)
    t94 = np.add(t88, t93, predicted_22)
    t95 = np.multiply(p, t94, predicted_22)
    t96 = np.multiply(t18, x, w2)
    t97 = np.multiply(p, e, w3)
    t98 = np.multiply(p, 0.25, w4)
    t99 = np.add(e, t98, w4)
    t100 = np.multiply(t99, p, w4)
    t104 = np.square(e, w0)
    t106 = np.multiply(t104, 0.75, w0)
    t108 = np.multiply(t97, 0.20833333333333334, predicted_11)
    t110 = np.multiply(tracking_index, 0.012152777777777778, predicted_13)
    t111 = np.add(t106, t108, w0)
    t112 = np.add(t111, t110, w0)
    t113 = np.divide(t112, x, w0)
    t114 = np.multiply(r, 2.0, predicted_12)
    t115 = np.multiply(t113, t114, w0)
    t116 = np.multiply(t96, 0.25, w1)
    t117 = np.multiply(tracking_index, 0.20833333333333334, predicted_11)
    t118 = np.add(t115, t116, w0)
    t119 = np.add(t118, t97, w0)
    t120 = np.add(t119, t117, w0)
    t122 = np.multiply(t96, 0.5, w1)
    t124 = np.multiply(tracking_index, 0.3333333333333333, predicted_11)
    t125 = np.add(t97, t122, w3)
    t126 = np.add(t125, t124, w3)
    t128 = np.multiply(tracking_index, 0.5, w1)
    t129 = np.add(t96, t128, w1)
    np.multiply(t100, t95, predicted_11)
    np.multiply(t96, t95, predicted_12)
    np.multiply(tracking_index, t95, predicted_13)
    np.multiply(tracking_index, t120, predicted_22)
    np.multiply(tracking_index, t126, predicted_23)
    np.multiply(tracking_index, t129, predicted_33)


_PREDICTED_COVARIANCE = Signature(
    "predicted_covariance",
    (_TRACKING_INDEX_DOMAIN_2,),
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
    tracking_index: ArrayLike, *, out: tuple[Real, Real, Real, Real, Real, Real] | None = None
) -> PredictedCovarianceDerivatives:
    """First derivatives of the predicted covariance.

        delta = sqrt(64/Lambda^2 + 1/9),
        xi = sqrt(5/3 + 2 eta), eta = sqrt(7/9 + 2 delta xi), nu = 1 + xi + eta + delta

    tracking_index: Lambda, with Lambda^2 =
        jerk_deviation**2*sampling_interval**6/measurement_deviation**2; a number above 0 and at
        most 2^1000, in float32 above 0 and at most 2^120.

    predicted_11: derivative of the variance of the predicted position over sigma_v^2. Relative
        error at most 14.42 * 2^-52 (float64), 14.38 * 2^-23 (float32), proved for 5e-324 <=
        tracking_index <= 1.0715086071862673e301 (float64) and 1e-45 <= tracking_index <=
        1.329228e36 (float32).
    predicted_12: derivative of the covariance of predicted position and velocity times T/sigma_v^2.
        Relative error at most 12.74 * 2^-52 (float64), 12.74 * 2^-23 (float32), proved for 5e-324
        <= tracking_index <= 1.0715086071862673e301 (float64) and 1e-45 <= tracking_index <=
        1.329228e36 (float32).
    predicted_13: derivative of the covariance of predicted position and acceleration times
        T^2/sigma_v^2. Relative error at most 8.16 * 2^-52 (float64), 8.14 * 2^-23 (float32), proved
        for 5e-324 <= tracking_index <= 1.0715086071862673e301 (float64) and 1e-45 <= tracking_index
        <= 1.329228e36 (float32).
    predicted_22: derivative of the variance of the predicted velocity times T^2/sigma_v^2. Relative
        error at most 16.38 * 2^-52 (float64), 16.41 * 2^-23 (float32), proved for 5e-324 <=
        tracking_index <= 1.0715086071862673e301 (float64) and 1e-45 <= tracking_index <=
        1.329228e36 (float32).
    predicted_23: derivative of the covariance of predicted velocity and acceleration times
        T^3/sigma_v^2. Relative error at most 10.60 * 2^-52 (float64), 10.60 * 2^-23 (float32),
        proved for 5e-324 <= tracking_index <= 1.0715086071862673e301 (float64) and 1e-45 <=
        tracking_index <= 1.329228e36 (float32).
    predicted_33: derivative of the variance of the predicted acceleration times T^4/sigma_v^2.
        Relative error at most 8.47 * 2^-52 (float64), 8.46 * 2^-23 (float32), proved for 5e-324 <=
        tracking_index <= 1.0715086071862673e301 (float64) and 1e-45 <= tracking_index <=
        1.329228e36 (float32).

    Outside an output's range, a few numbers next to its ends apart, its true value is no normal
    number: it comes as 0, a subnormal number or infinity, never as NaN. Numbers and arrays are
    taken, arrays of any shape; inputs are broadcast. float64 and float32 stay what they are,
    integers become float64. `out`: a tuple of arrays to fill.

    ValueError: an input outside its domain, with its place; `out` that does not fit. TypeError: an
    input that is no real number of these types.

    Source: derivation random-jerk
    """
    return PredictedCovarianceDerivatives(
        *evaluate(_PREDICTED_COVARIANCE_DERIVATIVES, (tracking_index,), out)
    )


def _predicted_covariance_derivatives_block(
    given: Arrays, out: Arrays, work: Arrays, single: bool
) -> None:
    (tracking_index,) = given
    predicted_11, predicted_12, predicted_13, predicted_22, predicted_23, predicted_33 = out
    w0, w1, w2, w3, w4, w5, w6, w7, w8, w9, w10, w11, w12, w13, w14, w15, w16 = work
    p = np.sqrt(tracking_index, predicted_11)
    r = np.sqrt(p, predicted_12)
    t4 = np.divide(2.220446049250313e-16, tracking_index, predicted_13)
    t6 = np.multiply(tracking_index, 3.854941057726238e-19, w0)
    t7 = np.add(t4, t6, predicted_13)
    c_scaled = np.sqrt(t7, predicted_22)
    t10 = np.multiply(c_scaled, 67108864.0, predicted_22)
    t12 = np.multiply(t10, r, w0)
    t14 = np.multiply(t12, 2.0, w0)
    t16 = np.multiply(p, 0.4166666666666667, predicted_13)
    t18 = np.multiply(tracking_index, 0.04861111111111111, w1)
    t19 = np.multiply(p, r, w2)
    t22 = np.multiply(t19, 1.2504627916220945, w3)
    t24 = np.divide(8.0, r, predicted_23)
    t25 = np.add(t22, t24, w3)
    t26 = near_cbrt(t25, w3, single)
    t28 = np.multiply(t14, t26, predicted_23)
    t29 = np.add(t28, t18, predicted_23)
    t30 = np.sqrt(t29, predicted_33)
    t31 = np.multiply(t30, 2.0, predicted_23)
    t32 = np.add(t31, t16, predicted_23)
    t33 = np.sqrt(t32, predicted_23)
    t35 = np.multiply(t14, 0.5, w4)
    t36 = np.multiply(t30, t33, predicted_33)
    t37 = np.multiply(t33, t36, predicted_23)
    t38 = np.multiply(t35, t26, w3)
    t39 = np.subtract(t37, t38, predicted_23)
    t40 = np.subtract(t36, t35, predicted_33)
    t41 = np.divide(t39, t40, predicted_23)
    t43 = np.multiply(t14, t41, w3)
    t44 = np.add(t43, t18, w3)
    t45 = np.sqrt(t44, w3)
    t46 = np.multiply(t45, 2.0, predicted_33)
    t47 = np.add(t46, t16, predicted_33)
    t48 = np.sqrt(t47, predicted_33)
    t49 = np.multiply(t45, t48, w3)
    t50 = np.multiply(t48, t49, predicted_33)
    t51 = np.multiply(t35, t41, predicted_23)
    t52 = np.subtract(t50, t51, predicted_33)
    t53 = np.subtract(t49, t35, w3)
    t54 = np.divide(t52, t53, predicted_33)
    t56 = np.multiply(t14, t54, w3)
    t57 = np.add(t56, t18, w3)
    t58 = np.sqrt(t57, w3)
    t59 = np.multiply(t58, 2.0, predicted_23)
    t60 = np.add(t59, t16, predicted_23)
    t61 = np.sqrt(t60, predicted_23)
    t62 = np.multiply(t58, t61, w3)
    t63 = np.multiply(t61, t62, predicted_23)
    t64 = np.multiply(t35, t54, predicted_33)
    t65 = np.subtract(t63, t64, predicted_23)
    t66 = np.subtract(t62, t35, w3)
    t67 = np.divide(t65, t66, predicted_23)
    t69 = np.multiply(t14, t67, w3)
    t70 = np.add(t69, t18, w3)
    t71 = np.sqrt(t70, w3)
    t72 = np.multiply(t71, 2.0, predicted_33)
    t73 = np.add(t72, t16, predicted_33)
    t74 = np.sqrt(t73, predicted_33)
    t75 = np.multiply(t71, t74, w3)
    t76 = np.multiply(t74, t75, predicted_33)
    t77 = np.multiply(t35, t67, predicted_23)
    t78 = np.subtract(t76, t77, predicted_33)
    t79 = np.subtract(t75, t35, w3)
    t80 = np.divide(t78, t79, predicted_33)
    t82 = np.multiply(t14, t80, w0)
    t83 = np.add(t82, t18, w0)
    e = np.sqrt(t83, w0)
    t85 = np.multiply(e, 2.0, w1)
    t86 = np.add(t85, t16, w1)
    x = np.sqrt(t86, w1)
    t88 = np.square(e, w3)
    t90 = np.multiply(t88, 0.75, w4)
    t91 = np.multiply(p, e, predicted_13)
    t93 = np.multiply(t91, 0.20833333333333334, predicted_23)
    t95 = np.multiply(tracking_index, 0.012152777777777778, predicted_33)
    t96 = np.add(t90, t93, w4)
    t97 = np.add(t96, t95, w4)
    t99 = np.multiply(t88, 0.25, predicted_23)
    t101 = np.multiply(t91, 0.10416666666666667, w5)
    t102 = np.add(t99, t101, w5)
    t103 = np.add(t102, t95, w5)
    t104 = np.multiply(x, r, w6)
    t105 = np.divide(t104, t10, w7)
    t106 = np.multiply(t105, p, w8)
    t108 = np.multiply(t106, 0.006944444444444444, w8)
    t110 = np.multiply(p, 0.16666666666666666, w9)
    t111 = np.add(e, t110, w9)
    t112 = np.add(t111, t108, w9)
    t113 = np.divide(tracking_index, t97, w8)
    t114 = np.multiply(t113, t105, w7)
    t116 = np.multiply(t114, 0.0008680555555555555, w7)
    t117 = np.divide(t103, t97, w5)
    t118 = np.multiply(t117, 2.0, w5)
    t119 = np.divide(t112, t97, w9)
    t120 = np.multiply(t104, 0.25, w6)
    t121 = np.multiply(t119, t120, w9)
    t122 = np.add(t118, 1.0, w10)
    t123 = np.multiply(e, 0.5, w11)
    t124 = np.add(t10, t123, w11)
    t125 = np.multiply(p, 0.125, w12)
    t126 = np.add(t120, t125, w6)
    t127 = np.add(t124, t126, w11)
    t128 = np.multiply(p, t127, w6)
    t129 = np.multiply(t19, x, w2)
    t130 = np.divide(x, r, w12)
    t131 = np.multiply(t130, 2.0, w13)
    t132 = np.add(t122, t116, w14)
    t133 = np.multiply(e, p, w15)
    t135 = np.multiply(t91, 0.078125, w16)
    t136 = np.add(t99, t135, predicted_23)
    t137 = np.add(t136, t95, predicted_23)
    t138 = np.divide(t137, t97, predicted_23)
    t140 = np.multiply(t138, 4.0, predicted_23)
    t141 = np.multiply(t133, t140, predicted_23)
    t142 = np.multiply(t113, tracking_index, w8)
    t144 = np.multiply(t142, 0.005063657407407407, w8)
    t145 = np.add(t141, t144, predicted_23)
    t146 = np.divide(t121, p, w8)
    t147 = np.multiply(t146, t127, w8)
    t148 = np.multiply(t128, 2.0, w11)
    t150 = np.add(t118, t121, w5)
    t151 = np.add(t150, t116, w5)
    t152 = np.multiply(t130, t151, w12)
    t154 = np.add(t121, 1.0, w9)
    t157 = np.multiply(t88, 0.5625, w3)
    t158 = np.multiply(t91, 0.4166666666666667, predicted_13)
    t160 = np.multiply(tracking_index, 0.13194444444444445, w5)
    t161 = np.add(t157, t158, w3)
    t162 = np.add(t161, t160, w3)
    t164 = np.multiply(t133, 0.32407407407407407, w15)
    t166 = np.multiply(tracking_index, 0.019241898148148147, w5)
    t167 = np.add(t164, t166, w15)
    t168 = np.divide(t162, t97, w3)
    t169 = np.multiply(e, t168, w3)
    t170 = np.divide(e, x, w0)
    t171 = np.multiply(t169, t170, w3)
    t172 = np.multiply(r, 2.0, w0)
    t173 = np.multiply(t171, t172, w3)
    t174 = np.divide(t167, t97, w15)
    t175 = np.divide(tracking_index, x, w1)
    t176 = np.multiply(t174, t175, w15)
    t177 = np.multiply(r, 0.125, predicted_12)
    t178 = np.multiply(t176, t177, w15)
    t179 = np.add(t173, t178, w3)
    t180 = np.multiply(t129, 0.5, w0)
    t181 = np.multiply(t122, 0.5, w1)
    t182 = np.multiply(t180, t181, w1)
    t183 = np.multiply(t10, p, predicted_22)
    t184 = np.multiply(t183, 8.0, predicted_22)
    t185 = np.multiply(t129, 2.0, w4)
    t186 = np.add(t131, 2.0, w5)
    t187 = np.multiply(t131, t186, w5)
    t188 = np.add(t187, 1.0, w5)
    t189 = np.multiply(t185, t188, w4)
    t190 = np.add(t184, t189, predicted_22)
    t191 = np.multiply(t190, 0.125, predicted_22)
    t192 = np.multiply(t116, t191, predicted_22)
    t193 = np.multiply(tracking_index, 0.4166666666666667, w4)
    t194 = np.add(t179, t182, w3)
    t195 = np.add(t194, t145, w3)
    t196 = np.add(t195, t192, w3)
    t198 = np.add(t131, 1.0, w13)
    t199 = np.multiply(t116, t198, w7)
    t200 = np.add(t122, t199, w10)
    t201 = np.multiply(t180, t200, w0)
    t203 = np.multiply(tracking_index, 0.6666666666666666, w1)
    t204 = np.add(t201, t145, w0)
    t206 = np.multiply(t129, t132, w2)
    np.multiply(t147, t148, predicted_11)
    np.multiply(t152, t128, predicted_12)
    np.multiply(t128, t154, predicted_13)
    np.add(t196, t193, predicted_22)
    np.add(t204, t203, predicted_23)
    np.add(t206, tracking_index, predicted_33)


_PREDICTED_COVARIANCE_DERIVATIVES = Signature(
    "predicted_covariance_derivatives",
    (_TRACKING_INDEX_DOMAIN_3,),
    (
        "predicted_11",
        "predicted_12",
        "predicted_13",
        "predicted_22",
        "predicted_23",
        "predicted_33",
    ),
    17,
    _predicted_covariance_derivatives_block,
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
    tracking_index: ArrayLike, *, out: tuple[Real, Real, Real, Real, Real, Real] | None = None
) -> UpdatedCovariance:
    """Updated covariance in units of sigma_v^2 and T.

        updated_1j = (alpha, beta, gamma),
        delta = sqrt(64/Lambda^2 + 1/9),
        xi = sqrt(5/3 + 2 eta), eta = sqrt(7/9 + 2 delta xi), nu = 1 + xi + eta + delta

    tracking_index: Lambda, with Lambda^2 =
        jerk_deviation**2*sampling_interval**6/measurement_deviation**2; a number above 0 and at
        most 2^511, in float32 above 0 and at most 2^63.

    updated_11: variance of the updated position over sigma_v^2. Relative error at most 6.19 * 2^-52
        (float64), 6.20 * 2^-23 (float32), proved for 5e-324 <= tracking_index <=
        6.703903964971299e153 (float64) and 1e-45 <= tracking_index <= 9.223372e18 (float32).
    updated_12: covariance of updated position and velocity times T/sigma_v^2. Relative error at
        most 6.11 * 2^-52 (float64), 6.12 * 2^-23 (float32), proved for 5e-324 <= tracking_index <=
        6.703903964971299e153 (float64) and 1e-45 <= tracking_index <= 9.223372e18 (float32).
    updated_13: covariance of updated position and acceleration times T^2/sigma_v^2. Relative error
        at most 4.61 * 2^-52 (float64), 4.62 * 2^-23 (float32), proved for 2.2250738585072014e-308
        <= tracking_index <= 6.703903964971299e153 (float64) and 1.1754945e-38 <= tracking_index <=
        9.223372e18 (float32).
    updated_22: variance of the updated velocity times T^2/sigma_v^2. Relative error at most 46.34 *
        2^-52 (float64), 45.79 * 2^-23 (float32), proved for 7.416912861690675e-309 <=
        tracking_index <= 6.703903964971299e153 (float64) and 3.918315e-39 <= tracking_index <=
        9.223372e18 (float32).
    updated_23: covariance of updated velocity and acceleration times T^3/sigma_v^2. Relative error
        at most 20.69 * 2^-52 (float64), 20.68 * 2^-23 (float32), proved for 1.0832677820940206e-231
        <= tracking_index <= 6.703903964971299e153 (float64) and 2.122721e-29 <= tracking_index <=
        9.223372e18 (float32).
    updated_33: variance of the updated acceleration times T^4/sigma_v^2. Relative error at most
        10.11 * 2^-52 (float64), 10.10 * 2^-23 (float32), proved for 1.6896185209462645e-185 <=
        tracking_index <= 6.703903964971299e153 (float64) and 1.1521641e-23 <= tracking_index <=
        9.223372e18 (float32).

    Outside an output's range, a few numbers next to its ends apart, its true value is no normal
    number: it comes as 0, a subnormal number or infinity, never as NaN. Numbers and arrays are
    taken, arrays of any shape; inputs are broadcast. float64 and float32 stay what they are,
    integers become float64. `out`: a tuple of arrays to fill.

    ValueError: an input outside its domain, with its place; `out` that does not fit. TypeError: an
    input that is no real number of these types.

    Source: derivation random-jerk
    """
    return UpdatedCovariance(*evaluate(_UPDATED_COVARIANCE, (tracking_index,), out))


def _updated_covariance_block(given: Arrays, out: Arrays, work: Arrays, single: bool) -> None:
    (tracking_index,) = given
    updated_11, updated_12, updated_13, updated_22, updated_23, updated_33 = out
    w0, w1, w2, w3, w4, w5 = work
    p = np.sqrt(tracking_index, updated_13)
    r = np.sqrt(p, updated_11)
    t4 = np.divide(2.220446049250313e-16, tracking_index, updated_12)
    t6 = np.multiply(tracking_index, 3.854941057726238e-19, w0)
    t7 = np.add(t4, t6, updated_12)
    c_scaled = np.sqrt(t7, updated_22)
    t10 = np.multiply(c_scaled, 67108864.0, updated_22)
    t11 = np.multiply(t10, r, w0)
    t13 = np.multiply(t11, 2.0, w0)
    t15 = np.multiply(p, 0.4166666666666667, updated_12)
    t17 = np.multiply(tracking_index, 0.04861111111111111, w1)
    t18 = np.multiply(p, r, w2)
    t21 = np.multiply(t18, 1.2504627916220945, w3)
    t23 = np.divide(8.0, r, updated_23)
    t24 = np.add(t21, t23, w3)
    t25 = near_cbrt(t24, w3, single)
    t27 = np.multiply(t13, t25, updated_23)
    t28 = np.add(t27, t17, updated_23)
    t29 = np.sqrt(t28, updated_33)
    t30 = np.multiply(t29, 2.0, updated_23)
    t31 = np.add(t30, t15, updated_23)
    t32 = np.sqrt(t31, updated_23)
    t34 = np.multiply(t13, 0.5, w4)
    t35 = np.multiply(t29, t32, updated_33)
    t36 = np.multiply(t32, t35, updated_23)
    t37 = np.multiply(t34, t25, w3)
    t38 = np.subtract(t36, t37, updated_23)
    t39 = np.subtract(t35, t34, updated_33)
    t40 = np.divide(t38, t39, updated_23)
    t42 = np.multiply(t13, t40, w3)
    t43 = np.add(t42, t17, w3)
    t44 = np.sqrt(t43, w3)
    t45 = np.multiply(t44, 2.0, updated_33)
    t46 = np.add(t45, t15, updated_33)
    t47 = np.sqrt(t46, updated_33)
    t48 = np.multiply(t44, t47, w3)
    t49 = np.multiply(t47, t48, updated_33)
    t50 = np.multiply(t34, t40, updated_23)
    t51 = np.subtract(t49, t50, updated_33)
    t52 = np.subtract(t48, t34, w3)
    t53 = np.divide(t51, t52, updated_33)
    t55 = np.multiply(t13, t53, w3)
    t56 = np.add(t55, t17, w3)
    t57 = np.sqrt(t56, w3)
    t58 = np.multiply(t57, 2.0, updated_23)
    t59 = np.add(t58, t15, updated_23)
    t60 = np.sqrt(t59, updated_23)
    t61 = np.multiply(t57, t60, w3)
    t62 = np.multiply(t60, t61, updated_23)
    t63 = np.multiply(t34, t53, updated_33)
    t64 = np.subtract(t62, t63, updated_23)
    t65 = np.subtract(t61, t34, w3)
    t66 = np.divide(t64, t65, updated_23)
    t68 = np.multiply(t13, t66, w3)
    t69 = np.add(t68, t17, w3)
    t70 = np.sqrt(t69, w3)
    t71 = np.multiply(t70, 2.0, updated_33)
    t72 = np.add(t71, t15, updated_33)
    t73 = np.sqrt(t72, updated_33)
    t74 = np.multiply(t70, t73, w3)
    t75 = np.multiply(t73, t74, updated_33)
    t76 = np.multiply(t34, t66, updated_23)
    t77 = np.subtract(t75, t76, updated_33)
    t78 = np.subtract(t74, t34, w3)
    t79 = np.divide(t77, t78, updated_33)
    t81 = np.multiply(t13, t79, w0)
    t82 = np.add(t81, t17, w0)
    e = np.sqrt(t82, w0)
    t84 = np.multiply(e, 2.0, w1)
    t85 = np.add(t84, t15, w1)
    x = np.sqrt(t85, w1)
    t87 = np.multiply(e, x, w3)
    t88 = np.multiply(x, p, w4)
    t91 = np.multiply(t88, 0.37200846792814624, w4)
    t92 = np.multiply(e, r, updated_12)
    t94 = np.multiply(t92, 1.0773502691896257, updated_12)
    t96 = np.multiply(t18, 0.23411675639654192, w2)
    t97 = np.add(t87, t91, w3)
    t98 = np.add(t97, t94, w3)
    t99 = np.add(t98, t96, w3)
    t101 = np.multiply(p, 0.041666666666666664, w2)
    t102 = np.add(t10, t101, w2)
    t103 = np.multiply(x, 8.0, w4)
    t104 = np.divide(t103, t102, w4)
    t105 = np.divide(t104, t99, w4)
    t106 = np.divide(t105, tracking_index, w2)
    t107 = np.multiply(t105, 0.5, w3)
    t109 = np.multiply(tracking_index, 0.5773502691896257, updated_12)
    t110 = np.add(t107, t109, w3)
    t111 = np.multiply(t106, 0.125, updated_12)
    t113 = np.add(t111, 0.28867513459481287, updated_12)
    t114 = np.multiply(t105, t113, updated_12)
    t116 = np.multiply(tracking_index, 0.16666666666666666, updated_23)
    t117 = np.add(t114, t116, updated_23)
    t118 = np.multiply(e, 0.5, updated_12)
    t119 = np.add(t10, t118, updated_22)
    t120 = np.multiply(x, r, updated_12)
    t121 = np.multiply(t120, 0.25, updated_33)
    t122 = np.multiply(p, 0.125, w5)
    t123 = np.add(t121, t122, updated_33)
    t124 = np.add(t119, t123, updated_22)
    t125 = np.multiply(p, 0.25, w5)
    t126 = np.add(e, t125, w0)
    t135 = np.multiply(t106, 0.046875, w5)
    t136 = np.add(t135, 0.27900635094610965, w5)
    t137 = np.multiply(t106, t136, w2)
    t138 = np.add(t137, 0.5706730176127763, w2)
    t139 = np.multiply(r, 0.5, updated_11)
    t140 = np.divide(t139, x, updated_11)
    t141 = np.multiply(t105, t140, w1)
    t142 = np.multiply(t105, t138, w4)
    t143 = np.multiply(tracking_index, 0.4488959454956774, w2)
    t144 = np.add(t142, t143, w4)
    t145 = np.multiply(t141, t144, w1)
    t146 = np.multiply(tracking_index, t140, updated_11)
    t147 = np.multiply(tracking_index, t146, updated_11)
    t148 = np.multiply(t147, 0.10366807798802437, w2)
    np.divide(t126, t124, updated_11)
    np.divide(t120, t124, updated_12)
    np.divide(p, t124, updated_13)
    np.add(t145, t148, updated_22)
    np.multiply(tracking_index, t117, updated_23)
    np.multiply(tracking_index, t110, updated_33)


_UPDATED_COVARIANCE = Signature(
    "updated_covariance",
    (_TRACKING_INDEX_DOMAIN_2,),
    ("updated_11", "updated_12", "updated_13", "updated_22", "updated_23", "updated_33"),
    6,
    _updated_covariance_block,
)
