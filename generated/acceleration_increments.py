# Made by: gainproof generate acceleration-increments
# From: gainproof derive acceleration-increments, SymPy 1.14.0
"""Acceleration increments (acceleration random walk): steady state with measured position."""

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
    "GainsFromAlpha",
    "GainsWithDerivatives",
    "IndexFromAlpha",
    "InnovationDeviation",
    "PredictedCovariance",
    "PredictedCovarianceDerivatives",
    "PredictorGainDerivatives",
    "PredictorGains",
    "UpdatedCovariance",
    "gain_derivatives",
    "gains",
    "gains_from_alpha",
    "gains_with_derivatives",
    "index_from_alpha",
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


def gains(tracking_index: ArrayLike, *, out: tuple[Real, Real, Real] | None = None) -> Gains:
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
    gamma: acceleration gain times the square of the sampling interval. Relative error at most 4.56
        * 2^-52 (float64), 4.56 * 2^-23 (float32), proved for 2.2250738585072014e-308 <=
        tracking_index <= 1.7976931348623157e308 (float64) and 1.1754945e-38 <= tracking_index <=
        3.4028235e38 (float32).

    Outside an output's range, a few numbers next to its ends apart, its true value is no normal
    number: it comes as 0, a subnormal number or infinity, never as NaN. Numbers and arrays are
    taken, arrays of any shape; inputs are broadcast. float64 and float32 stay what they are,
    integers become float64. `out`: a tuple of arrays to fill.

    ValueError: an input outside its domain, with its place; `out` that does not fit. TypeError: an
    input that is no real number of these types.

    Source: derivation acceleration-increments
    """
    return Gains(*evaluate(_GAINS, (tracking_index,), out))


def _gains_block(given: Arrays, out: Arrays, work: Arrays, single: bool) -> None:
    (tracking_index,) = given
    alpha, beta, gamma = out
    w0, w1, w2, w3, w4, w5, w6 = work
    p = np.sqrt(tracking_index, gamma)
    r = np.sqrt(p, alpha)
    t4 = np.divide(1.0, p, beta)
    t5 = np.multiply(t4, r, w0)
    t7 = np.multiply(t5, 2.0, w0)
    t9 = np.multiply(p, 0.5, w1)
    t11 = np.multiply(tracking_index, 0.0625, w2)
    t12 = np.multiply(p, r, w3)
    t13 = np.multiply(t12, 1.0, w3)
    t15 = np.divide(8.0, r, w4)
    t16 = np.add(t13, t15, w3)
    t17 = near_cbrt(t16, w3, single)
    t20 = np.multiply(t7, t17, w4)
    t21 = np.add(t20, t11, w4)
    t22 = np.sqrt(t21, w4)
    t23 = np.multiply(t22, 2.0, w5)
    t24 = np.add(t23, t9, w5)
    t25 = np.sqrt(t24, w5)
    t26 = np.multiply(t7, 0.5, w6)
    t27 = np.multiply(t22, t25, w4)
    t28 = np.multiply(t25, t27, w5)
    t29 = np.multiply(t26, t17, w3)
    t30 = np.subtract(t28, t29, w5)
    t31 = np.subtract(t27, t26, w4)
    t32 = np.divide(t30, t31, w5)
    t34 = np.multiply(t7, t32, w3)
    t35 = np.add(t34, t11, w3)
    t36 = np.sqrt(t35, w3)
    t37 = np.multiply(t36, 2.0, w4)
    t38 = np.add(t37, t9, w4)
    t39 = np.sqrt(t38, w4)
    t40 = np.multiply(t36, t39, w3)
    t41 = np.multiply(t39, t40, w4)
    t42 = np.multiply(t26, t32, w5)
    t43 = np.subtract(t41, t42, w4)
    t44 = np.subtract(t40, t26, w3)
    t45 = np.divide(t43, t44, w4)
    t47 = np.multiply(t7, t45, w3)
    t48 = np.add(t47, t11, w3)
    t49 = np.sqrt(t48, w3)
    t50 = np.multiply(t49, 2.0, w5)
    t51 = np.add(t50, t9, w5)
    t52 = np.sqrt(t51, w5)
    t53 = np.multiply(t49, t52, w3)
    t54 = np.multiply(t52, t53, w5)
    t55 = np.multiply(t26, t45, w4)
    t56 = np.subtract(t54, t55, w5)
    t57 = np.subtract(t53, t26, w3)
    t58 = np.divide(t56, t57, w5)
    t60 = np.multiply(t7, t58, w3)
    t61 = np.add(t60, t11, w3)
    t62 = np.sqrt(t61, w3)
    t63 = np.multiply(t62, 2.0, w4)
    t64 = np.add(t63, t9, w4)
    t65 = np.sqrt(t64, w4)
    t66 = np.multiply(t62, t65, w3)
    t67 = np.multiply(t65, t66, w4)
    t68 = np.multiply(t26, t58, w5)
    t69 = np.subtract(t67, t68, w4)
    t70 = np.subtract(t66, t26, w3)
    t71 = np.divide(t69, t70, w4)
    t73 = np.multiply(t7, t71, w0)
    t74 = np.add(t73, t11, w0)
    e = np.sqrt(t74, w0)
    t76 = np.multiply(e, 2.0, w2)
    t77 = np.add(t76, t9, w2)
    x = np.sqrt(t77, w2)
    t79 = np.multiply(e, 0.5, w1)
    t80 = np.add(t4, t79, beta)
    t81 = np.multiply(x, r, w2)
    t83 = np.multiply(t81, 0.25, w1)
    t84 = np.multiply(p, 0.125, w3)
    t85 = np.add(t83, t84, w1)
    t86 = np.add(t80, t85, w1)
    t87 = np.multiply(p, 0.25, w3)
    t88 = np.add(e, t87, w0)
    np.divide(t88, t86, alpha)
    np.divide(t81, t86, beta)
    np.divide(p, t86, gamma)


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

        delta = 8/Lambda,
        xi = sqrt(2 + 2 eta), eta = sqrt(1 + 2 delta xi), nu = 1 + xi + eta + delta

    tracking_index: Lambda, with Lambda^2 =
        increment_deviation**2*sampling_interval**4/measurement_deviation**2; a number above 0 and
        finite.

    alpha: derivative of the position gain. Relative error at most 14.76 * 2^-52 (float64), 14.75 *
        2^-23 (float32), proved for 5e-324 <= tracking_index <= 7.11074631974658e102 (float64) and
        1e-45 <= tracking_index <= 8.7960925e12 (float32).
    beta: derivative of the velocity gain times the sampling interval. Relative error at most 15.78
        * 2^-52 (float64), 15.79 * 2^-23 (float32), proved for 5e-324 <= tracking_index <=
        1.8961503816218352e154 (float64) and 1e-45 <= tracking_index <= 2.6087635e19 (float32).
    gamma: derivative of the acceleration gain times the square of the sampling interval. Relative
        error at most 13.16 * 2^-52 (float64), 13.16 * 2^-23 (float32), proved for 5e-324 <=
        tracking_index <= 2.6815615859885194e154 (float64) and 1e-45 <= tracking_index <=
        3.689349e19 (float32).

    Outside an output's range, a few numbers next to its ends apart, its true value is no normal
    number: it comes as 0, a subnormal number or infinity, never as NaN. Numbers and arrays are
    taken, arrays of any shape; inputs are broadcast. float64 and float32 stay what they are,
    integers become float64. `out`: a tuple of arrays to fill.

    ValueError: an input outside its domain, with its place; `out` that does not fit. TypeError: an
    input that is no real number of these types.

    Source: derivation acceleration-increments
    """
    return GainDerivatives(*evaluate(_GAIN_DERIVATIVES, (tracking_index,), out))


def _gain_derivatives_block(given: Arrays, out: Arrays, work: Arrays, single: bool) -> None:
    (tracking_index,) = given
    alpha, beta, gamma = out
    w0, w1, w2, w3, w4, w5, w6, w7, w8 = work
    p = np.sqrt(tracking_index, alpha)
    r = np.sqrt(p, beta)
    t4 = np.divide(1.0, p, gamma)
    t5 = np.multiply(t4, r, w0)
    t7 = np.multiply(t5, 2.0, w0)
    t9 = np.multiply(p, 0.5, w1)
    t11 = np.multiply(tracking_index, 0.0625, w2)
    t12 = np.multiply(p, r, w3)
    t13 = np.multiply(t12, 1.0, w4)
    t15 = np.divide(8.0, r, w5)
    t16 = np.add(t13, t15, w4)
    t17 = near_cbrt(t16, w4, single)
    t20 = np.multiply(t7, t17, w5)
    t21 = np.add(t20, t11, w5)
    t22 = np.sqrt(t21, w5)
    t23 = np.multiply(t22, 2.0, w6)
    t24 = np.add(t23, t9, w6)
    t25 = np.sqrt(t24, w6)
    t26 = np.multiply(t7, 0.5, w7)
    t27 = np.multiply(t22, t25, w5)
    t28 = np.multiply(t25, t27, w6)
    t29 = np.multiply(t26, t17, w4)
    t30 = np.subtract(t28, t29, w6)
    t31 = np.subtract(t27, t26, w5)
    t32 = np.divide(t30, t31, w6)
    t34 = np.multiply(t7, t32, w4)
    t35 = np.add(t34, t11, w4)
    t36 = np.sqrt(t35, w4)
    t37 = np.multiply(t36, 2.0, w5)
    t38 = np.add(t37, t9, w5)
    t39 = np.sqrt(t38, w5)
    t40 = np.multiply(t36, t39, w4)
    t41 = np.multiply(t39, t40, w5)
    t42 = np.multiply(t26, t32, w6)
    t43 = np.subtract(t41, t42, w5)
    t44 = np.subtract(t40, t26, w4)
    t45 = np.divide(t43, t44, w5)
    t47 = np.multiply(t7, t45, w4)
    t48 = np.add(t47, t11, w4)
    t49 = np.sqrt(t48, w4)
    t50 = np.multiply(t49, 2.0, w6)
    t51 = np.add(t50, t9, w6)
    t52 = np.sqrt(t51, w6)
    t53 = np.multiply(t49, t52, w4)
    t54 = np.multiply(t52, t53, w6)
    t55 = np.multiply(t26, t45, w5)
    t56 = np.subtract(t54, t55, w6)
    t57 = np.subtract(t53, t26, w4)
    t58 = np.divide(t56, t57, w6)
    t60 = np.multiply(t7, t58, w4)
    t61 = np.add(t60, t11, w4)
    t62 = np.sqrt(t61, w4)
    t63 = np.multiply(t62, 2.0, w5)
    t64 = np.add(t63, t9, w5)
    t65 = np.sqrt(t64, w5)
    t66 = np.multiply(t62, t65, w4)
    t67 = np.multiply(t65, t66, w5)
    t68 = np.multiply(t26, t58, w6)
    t69 = np.subtract(t67, t68, w5)
    t70 = np.subtract(t66, t26, w4)
    t71 = np.divide(t69, t70, w5)
    t73 = np.multiply(t7, t71, w0)
    t74 = np.add(t73, t11, w0)
    e = np.sqrt(t74, w0)
    t76 = np.multiply(e, 2.0, w2)
    t77 = np.add(t76, t9, w2)
    x = np.sqrt(t77, w2)
    t79 = np.square(e, w1)
    t81 = np.multiply(t79, 0.75, w4)
    t82 = np.multiply(p, e, w5)
    t84 = np.multiply(t82, 0.25, w6)
    t86 = np.multiply(tracking_index, 0.015625, w7)
    t87 = np.add(t81, t84, w4)
    t88 = np.add(t87, t86, w4)
    t89 = np.multiply(t79, 0.25, w1)
    t90 = np.multiply(t82, 0.125, w5)
    t91 = np.add(t89, t90, w1)
    t92 = np.add(t91, t86, w1)
    t93 = np.multiply(x, r, w5)
    t94 = np.multiply(p, 0.25, w6)
    t95 = np.add(e, t94, w6)
    t96 = np.divide(t95, t88, w7)
    t97 = np.multiply(t93, 0.25, w8)
    t98 = np.multiply(t96, t97, w7)
    t99 = np.divide(x, t12, w3)
    t100 = np.multiply(t95, 0.125, w6)
    t101 = np.multiply(t93, t100, w6)
    t102 = np.add(t92, t101, w1)
    t103 = np.divide(t93, t88, w5)
    t104 = np.multiply(x, 0.25, w6)
    t105 = np.multiply(r, 0.5, beta)
    t106 = np.add(x, t105, w2)
    t107 = np.multiply(t104, t106, w6)
    t108 = np.multiply(t103, t107, w5)
    t109 = np.add(t108, 1.0, w5)
    t110 = np.divide(t98, tracking_index, w7)
    t111 = np.multiply(t110, 2.0, w7)
    t112 = np.divide(t102, t88, w1)
    t113 = np.divide(t99, t4, w3)
    t114 = np.multiply(t112, t113, w1)
    t115 = np.multiply(t114, 2.0, w1)
    t116 = np.multiply(e, 0.5, w0)
    t117 = np.add(t4, t116, gamma)
    t118 = np.multiply(p, 0.125, w0)
    t119 = np.add(t97, t118, w8)
    t120 = np.add(t117, t119, gamma)
    t121 = np.multiply(p, t120, gamma)
    t122 = np.divide(t111, t121, w7)
    t124 = np.divide(t115, t121, w1)
    t126 = np.divide(t109, t121, w5)
    np.divide(t122, t121, alpha)
    np.divide(t124, t121, beta)
    np.divide(t126, t121, gamma)


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
    gamma: acceleration gain times the square of the sampling interval. Relative error at most 4.56
        * 2^-52 (float64), 4.56 * 2^-23 (float32), proved for 2.2250738585072014e-308 <=
        tracking_index <= 1.7976931348623157e308 (float64) and 1.1754945e-38 <= tracking_index <=
        3.4028235e38 (float32).
    d_alpha: derivative of the position gain. Relative error at most 14.74 * 2^-52 (float64), 14.74
        * 2^-23 (float32), proved for 5e-324 <= tracking_index <= 7.11074631974658e102 (float64) and
        1e-45 <= tracking_index <= 8.7960925e12 (float32).
    d_beta: derivative of the velocity gain times the sampling interval. Relative error at most
        15.78 * 2^-52 (float64), 15.79 * 2^-23 (float32), proved for 5e-324 <= tracking_index <=
        1.8961503816218352e154 (float64) and 1e-45 <= tracking_index <= 2.6087635e19 (float32).
    d_gamma: derivative of the acceleration gain times the square of the sampling interval. Relative
        error at most 13.16 * 2^-52 (float64), 13.16 * 2^-23 (float32), proved for 5e-324 <=
        tracking_index <= 2.6815615859885194e154 (float64) and 1e-45 <= tracking_index <=
        3.689349e19 (float32).

    Outside an output's range, a few numbers next to its ends apart, its true value is no normal
    number: it comes as 0, a subnormal number or infinity, never as NaN. Numbers and arrays are
    taken, arrays of any shape; inputs are broadcast. float64 and float32 stay what they are,
    integers become float64. `out`: a tuple of arrays to fill.

    ValueError: an input outside its domain, with its place; `out` that does not fit. TypeError: an
    input that is no real number of these types.

    Source: derivation acceleration-increments
    """
    return GainsWithDerivatives(*evaluate(_GAINS_WITH_DERIVATIVES, (tracking_index,), out))


def _gains_with_derivatives_block(given: Arrays, out: Arrays, work: Arrays, single: bool) -> None:
    (tracking_index,) = given
    alpha, beta, gamma, d_alpha, d_beta, d_gamma = out
    w0, w1, w2, w3, w4, w5, w6, w7 = work
    p = np.sqrt(tracking_index, gamma)
    r = np.sqrt(p, alpha)
    t4 = np.divide(1.0, p, beta)
    t5 = np.multiply(t4, r, w0)
    t7 = np.multiply(t5, 2.0, w0)
    t9 = np.multiply(p, 0.5, w1)
    t11 = np.multiply(tracking_index, 0.0625, w2)
    t12 = np.multiply(p, r, w3)
    t13 = np.multiply(t12, 1.0, w4)
    t15 = np.divide(8.0, r, d_alpha)
    t16 = np.add(t13, t15, w4)
    t17 = near_cbrt(t16, w4, single)
    t20 = np.multiply(t7, t17, d_alpha)
    t21 = np.add(t20, t11, d_alpha)
    t22 = np.sqrt(t21, d_beta)
    t23 = np.multiply(t22, 2.0, d_alpha)
    t24 = np.add(t23, t9, d_alpha)
    t25 = np.sqrt(t24, d_gamma)
    t26 = np.multiply(t7, 0.5, d_alpha)
    t27 = np.multiply(t22, t25, d_beta)
    t28 = np.multiply(t25, t27, d_gamma)
    t29 = np.multiply(t26, t17, w4)
    t30 = np.subtract(t28, t29, d_gamma)
    t31 = np.subtract(t27, t26, d_beta)
    t32 = np.divide(t30, t31, d_gamma)
    t34 = np.multiply(t7, t32, w4)
    t35 = np.add(t34, t11, w4)
    t36 = np.sqrt(t35, w4)
    t37 = np.multiply(t36, 2.0, d_beta)
    t38 = np.add(t37, t9, d_beta)
    t39 = np.sqrt(t38, d_beta)
    t40 = np.multiply(t36, t39, w4)
    t41 = np.multiply(t39, t40, d_beta)
    t42 = np.multiply(t26, t32, d_gamma)
    t43 = np.subtract(t41, t42, d_beta)
    t44 = np.subtract(t40, t26, w4)
    t45 = np.divide(t43, t44, d_beta)
    t47 = np.multiply(t7, t45, w4)
    t48 = np.add(t47, t11, w4)
    t49 = np.sqrt(t48, w4)
    t50 = np.multiply(t49, 2.0, d_gamma)
    t51 = np.add(t50, t9, d_gamma)
    t52 = np.sqrt(t51, d_gamma)
    t53 = np.multiply(t49, t52, w4)
    t54 = np.multiply(t52, t53, d_gamma)
    t55 = np.multiply(t26, t45, d_beta)
    t56 = np.subtract(t54, t55, d_gamma)
    t57 = np.subtract(t53, t26, w4)
    t58 = np.divide(t56, t57, d_gamma)
    t60 = np.multiply(t7, t58, w4)
    t61 = np.add(t60, t11, w4)
    t62 = np.sqrt(t61, w4)
    t63 = np.multiply(t62, 2.0, d_beta)
    t64 = np.add(t63, t9, d_beta)
    t65 = np.sqrt(t64, d_beta)
    t66 = np.multiply(t62, t65, w4)
    t67 = np.multiply(t65, t66, d_beta)
    t68 = np.multiply(t26, t58, d_gamma)
    t69 = np.subtract(t67, t68, d_beta)
    t70 = np.subtract(t66, t26, w4)
    t71 = np.divide(t69, t70, d_beta)
    t73 = np.multiply(t7, t71, w0)
    t74 = np.add(t73, t11, w0)
    e = np.sqrt(t74, w0)
    t76 = np.multiply(e, 2.0, w2)
    t77 = np.add(t76, t9, w2)
    x = np.sqrt(t77, w2)
    t79 = np.multiply(e, 0.5, w1)
    t80 = np.add(t4, t79, w1)
    t81 = np.multiply(x, r, w4)
    t83 = np.multiply(t81, 0.25, d_alpha)
    t84 = np.multiply(p, 0.125, d_beta)
    t85 = np.add(t83, t84, d_beta)
    t86 = np.add(t80, t85, w1)
    t87 = np.multiply(p, 0.25, d_beta)
    t88 = np.add(e, t87, d_beta)
    t92 = np.square(e, d_gamma)
    t94 = np.multiply(t92, 0.75, w5)
    t95 = np.multiply(p, e, w0)
    t96 = np.multiply(t95, 0.25, w6)
    t98 = np.multiply(tracking_index, 0.015625, w7)
    t99 = np.add(t94, t96, w5)
    t100 = np.add(t99, t98, w5)
    t101 = np.multiply(t92, 0.25, d_gamma)
    t102 = np.multiply(t95, 0.125, w0)
    t103 = np.add(t101, t102, d_gamma)
    t104 = np.add(t103, t98, d_gamma)
    t105 = np.divide(t88, t100, w0)
    t106 = np.multiply(t105, t83, w0)
    t107 = np.divide(x, t12, w3)
    t108 = np.multiply(t88, 0.125, w6)
    t109 = np.multiply(t81, t108, w6)
    t110 = np.add(t104, t109, d_gamma)
    t111 = np.divide(t81, t100, w6)
    t112 = np.multiply(x, 0.25, w7)
    t113 = np.multiply(r, 0.5, alpha)
    t114 = np.add(x, t113, w2)
    t115 = np.multiply(t112, t114, w7)
    t116 = np.multiply(t111, t115, w6)
    t117 = np.add(t116, 1.0, w6)
    t118 = np.divide(t106, tracking_index, w0)
    t119 = np.multiply(t118, 2.0, w0)
    t120 = np.divide(t110, t100, d_gamma)
    t121 = np.divide(t107, t4, w3)
    t122 = np.multiply(t120, t121, d_gamma)
    t123 = np.multiply(t122, 2.0, d_gamma)
    t124 = np.multiply(p, t86, w2)
    t125 = np.divide(t119, t124, w0)
    t127 = np.divide(t123, t124, d_gamma)
    t129 = np.divide(t117, t124, w6)
    np.divide(t88, t86, alpha)
    np.divide(t81, t86, beta)
    np.divide(p, t86, gamma)
    np.divide(t125, t124, d_alpha)
    np.divide(t127, t124, d_beta)
    np.divide(t129, t124, d_gamma)


_GAINS_WITH_DERIVATIVES = Signature(
    "gains_with_derivatives",
    (_TRACKING_INDEX_DOMAIN,),
    ("alpha", "beta", "gamma", "d_alpha", "d_beta", "d_gamma"),
    8,
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

        delta = 8/Lambda,
        xi = sqrt(2 + 2 eta), eta = sqrt(1 + 2 delta xi), nu = 1 + xi + eta + delta

    tracking_index: Lambda, with Lambda^2 =
        increment_deviation**2*sampling_interval**4/measurement_deviation**2; a number above 0 and
        finite.

    position: position entry of F K, alpha + beta + gamma/2. Relative error at most 6.22 * 2^-52
        (float64), 6.22 * 2^-23 (float32), proved for 5e-324 <= tracking_index <=
        1.7976931348623157e308 (float64) and 1e-45 <= tracking_index <= 3.4028235e38 (float32).
    velocity: velocity entry of F K times the sampling interval, beta + gamma. Relative error at
        most 6.59 * 2^-52 (float64), 6.59 * 2^-23 (float32), proved for 5e-324 <= tracking_index <=
        1.7976931348623157e308 (float64) and 1e-45 <= tracking_index <= 3.4028235e38 (float32).
    acceleration: acceleration entry of F K times the square of the sampling interval, gamma.
        Relative error at most 4.56 * 2^-52 (float64), 4.56 * 2^-23 (float32), proved for
        2.2250738585072014e-308 <= tracking_index <= 1.7976931348623157e308 (float64) and
        1.1754945e-38 <= tracking_index <= 3.4028235e38 (float32).

    Outside an output's range, a few numbers next to its ends apart, its true value is no normal
    number: it comes as 0, a subnormal number or infinity, never as NaN. Numbers and arrays are
    taken, arrays of any shape; inputs are broadcast. float64 and float32 stay what they are,
    integers become float64. `out`: a tuple of arrays to fill.

    ValueError: an input outside its domain, with its place; `out` that does not fit. TypeError: an
    input that is no real number of these types.

    Source: derivation acceleration-increments
    """
    return PredictorGains(*evaluate(_PREDICTOR_GAINS, (tracking_index,), out))


def _predictor_gains_block(given: Arrays, out: Arrays, work: Arrays, single: bool) -> None:
    (tracking_index,) = given
    position, velocity, acceleration = out
    w0, w1, w2, w3, w4, w5, w6 = work
    p = np.sqrt(tracking_index, acceleration)
    r = np.sqrt(p, position)
    t4 = np.divide(1.0, p, velocity)
    t5 = np.multiply(t4, r, w0)
    t7 = np.multiply(t5, 2.0, w0)
    t9 = np.multiply(p, 0.5, w1)
    t11 = np.multiply(tracking_index, 0.0625, w2)
    t12 = np.multiply(p, r, w3)
    t13 = np.multiply(t12, 1.0, w3)
    t15 = np.divide(8.0, r, w4)
    t16 = np.add(t13, t15, w3)
    t17 = near_cbrt(t16, w3, single)
    t20 = np.multiply(t7, t17, w4)
    t21 = np.add(t20, t11, w4)
    t22 = np.sqrt(t21, w4)
    t23 = np.multiply(t22, 2.0, w5)
    t24 = np.add(t23, t9, w5)
    t25 = np.sqrt(t24, w5)
    t26 = np.multiply(t7, 0.5, w6)
    t27 = np.multiply(t22, t25, w4)
    t28 = np.multiply(t25, t27, w5)
    t29 = np.multiply(t26, t17, w3)
    t30 = np.subtract(t28, t29, w5)
    t31 = np.subtract(t27, t26, w4)
    t32 = np.divide(t30, t31, w5)
    t34 = np.multiply(t7, t32, w3)
    t35 = np.add(t34, t11, w3)
    t36 = np.sqrt(t35, w3)
    t37 = np.multiply(t36, 2.0, w4)
    t38 = np.add(t37, t9, w4)
    t39 = np.sqrt(t38, w4)
    t40 = np.multiply(t36, t39, w3)
    t41 = np.multiply(t39, t40, w4)
    t42 = np.multiply(t26, t32, w5)
    t43 = np.subtract(t41, t42, w4)
    t44 = np.subtract(t40, t26, w3)
    t45 = np.divide(t43, t44, w4)
    t47 = np.multiply(t7, t45, w3)
    t48 = np.add(t47, t11, w3)
    t49 = np.sqrt(t48, w3)
    t50 = np.multiply(t49, 2.0, w5)
    t51 = np.add(t50, t9, w5)
    t52 = np.sqrt(t51, w5)
    t53 = np.multiply(t49, t52, w3)
    t54 = np.multiply(t52, t53, w5)
    t55 = np.multiply(t26, t45, w4)
    t56 = np.subtract(t54, t55, w5)
    t57 = np.subtract(t53, t26, w3)
    t58 = np.divide(t56, t57, w5)
    t60 = np.multiply(t7, t58, w3)
    t61 = np.add(t60, t11, w3)
    t62 = np.sqrt(t61, w3)
    t63 = np.multiply(t62, 2.0, w4)
    t64 = np.add(t63, t9, w4)
    t65 = np.sqrt(t64, w4)
    t66 = np.multiply(t62, t65, w3)
    t67 = np.multiply(t65, t66, w4)
    t68 = np.multiply(t26, t58, w5)
    t69 = np.subtract(t67, t68, w4)
    t70 = np.subtract(t66, t26, w3)
    t71 = np.divide(t69, t70, w4)
    t73 = np.multiply(t7, t71, w0)
    t74 = np.add(t73, t11, w0)
    e = np.sqrt(t74, w0)
    t76 = np.multiply(e, 2.0, w2)
    t77 = np.add(t76, t9, w2)
    x = np.sqrt(t77, w2)
    t79 = np.multiply(e, 0.5, w1)
    t80 = np.add(t4, t79, velocity)
    t81 = np.multiply(x, r, w2)
    t83 = np.multiply(t81, 0.25, w1)
    t84 = np.multiply(p, 0.125, w3)
    t85 = np.add(t83, t84, w1)
    t86 = np.add(t80, t85, w1)
    t88 = np.multiply(p, 0.75, w3)
    t89 = np.add(t81, t88, w3)
    t90 = np.add(e, t89, w0)
    t92 = np.add(t81, p, w2)
    np.divide(t90, t86, position)
    np.divide(t92, t86, velocity)
    np.divide(p, t86, acceleration)


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

        delta = 8/Lambda,
        xi = sqrt(2 + 2 eta), eta = sqrt(1 + 2 delta xi), nu = 1 + xi + eta + delta

    tracking_index: Lambda, with Lambda^2 =
        increment_deviation**2*sampling_interval**4/measurement_deviation**2; a number above 0 and
        finite.

    position: derivative of the position entry of F K, alpha + beta + gamma/2. Relative error at
        most 15.72 * 2^-52 (float64), 15.72 * 2^-23 (float32), proved for 5e-324 <= tracking_index
        <= 2.6815615859885194e154 (float64) and 1e-45 <= tracking_index <= 3.689349e19 (float32).
    velocity: derivative of the velocity entry of F K times the sampling interval, beta + gamma.
        Relative error at most 14.86 * 2^-52 (float64), 14.87 * 2^-23 (float32), proved for 5e-324
        <= tracking_index <= 3.2842287997601345e154 (float64) and 1e-45 <= tracking_index <=
        4.5185108e19 (float32).
    acceleration: derivative of the acceleration entry of F K times the square of the sampling
        interval, gamma. Relative error at most 13.16 * 2^-52 (float64), 13.16 * 2^-23 (float32),
        proved for 5e-324 <= tracking_index <= 2.6815615859885194e154 (float64) and 1e-45 <=
        tracking_index <= 3.689349e19 (float32).

    Outside an output's range, a few numbers next to its ends apart, its true value is no normal
    number: it comes as 0, a subnormal number or infinity, never as NaN. Numbers and arrays are
    taken, arrays of any shape; inputs are broadcast. float64 and float32 stay what they are,
    integers become float64. `out`: a tuple of arrays to fill.

    ValueError: an input outside its domain, with its place; `out` that does not fit. TypeError: an
    input that is no real number of these types.

    Source: derivation acceleration-increments
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
    t4 = np.divide(1.0, p, acceleration)
    t5 = np.multiply(t4, r, w0)
    t7 = np.multiply(t5, 2.0, w0)
    t9 = np.multiply(p, 0.5, w1)
    t11 = np.multiply(tracking_index, 0.0625, w2)
    t12 = np.multiply(p, r, w3)
    t13 = np.multiply(t12, 1.0, w4)
    t15 = np.divide(8.0, r, w5)
    t16 = np.add(t13, t15, w4)
    t17 = near_cbrt(t16, w4, single)
    t20 = np.multiply(t7, t17, w5)
    t21 = np.add(t20, t11, w5)
    t22 = np.sqrt(t21, w5)
    t23 = np.multiply(t22, 2.0, w6)
    t24 = np.add(t23, t9, w6)
    t25 = np.sqrt(t24, w6)
    t26 = np.multiply(t7, 0.5, w7)
    t27 = np.multiply(t22, t25, w5)
    t28 = np.multiply(t25, t27, w6)
    t29 = np.multiply(t26, t17, w4)
    t30 = np.subtract(t28, t29, w6)
    t31 = np.subtract(t27, t26, w5)
    t32 = np.divide(t30, t31, w6)
    t34 = np.multiply(t7, t32, w4)
    t35 = np.add(t34, t11, w4)
    t36 = np.sqrt(t35, w4)
    t37 = np.multiply(t36, 2.0, w5)
    t38 = np.add(t37, t9, w5)
    t39 = np.sqrt(t38, w5)
    t40 = np.multiply(t36, t39, w4)
    t41 = np.multiply(t39, t40, w5)
    t42 = np.multiply(t26, t32, w6)
    t43 = np.subtract(t41, t42, w5)
    t44 = np.subtract(t40, t26, w4)
    t45 = np.divide(t43, t44, w5)
    t47 = np.multiply(t7, t45, w4)
    t48 = np.add(t47, t11, w4)
    t49 = np.sqrt(t48, w4)
    t50 = np.multiply(t49, 2.0, w6)
    t51 = np.add(t50, t9, w6)
    t52 = np.sqrt(t51, w6)
    t53 = np.multiply(t49, t52, w4)
    t54 = np.multiply(t52, t53, w6)
    t55 = np.multiply(t26, t45, w5)
    t56 = np.subtract(t54, t55, w6)
    t57 = np.subtract(t53, t26, w4)
    t58 = np.divide(t56, t57, w6)
    t60 = np.multiply(t7, t58, w4)
    t61 = np.add(t60, t11, w4)
    t62 = np.sqrt(t61, w4)
    t63 = np.multiply(t62, 2.0, w5)
    t64 = np.add(t63, t9, w5)
    t65 = np.sqrt(t64, w5)
    t66 = np.multiply(t62, t65, w4)
    t67 = np.multiply(t65, t66, w5)
    t68 = np.multiply(t26, t58, w6)
    t69 = np.subtract(t67, t68, w5)
    t70 = np.subtract(t66, t26, w4)
    t71 = np.divide(t69, t70, w5)
    t73 = np.multiply(t7, t71, w0)
    t74 = np.add(t73, t11, w0)
    e = np.sqrt(t74, w0)
    t76 = np.multiply(e, 2.0, w2)
    t77 = np.add(t76, t9, w2)
    x = np.sqrt(t77, w2)
    t79 = np.square(e, w1)
    t81 = np.multiply(t79, 0.75, w4)
    t82 = np.multiply(p, e, w5)
    t84 = np.multiply(t82, 0.25, w6)
    t86 = np.multiply(tracking_index, 0.015625, w7)
    t87 = np.add(t81, t84, w4)
    t88 = np.add(t87, t86, w4)
    t89 = np.multiply(t79, 0.25, w1)
    t90 = np.multiply(t82, 0.125, w5)
    t91 = np.add(t89, t90, w1)
    t92 = np.add(t91, t86, w1)
    t93 = np.multiply(x, r, w5)
    t94 = np.multiply(p, 0.25, w6)
    t95 = np.add(e, t94, w6)
    t96 = np.divide(t95, t88, w7)
    t97 = np.multiply(t93, 0.25, w8)
    t98 = np.multiply(t96, t97, w7)
    t99 = np.divide(x, t12, w3)
    t100 = np.multiply(t95, 0.125, w6)
    t101 = np.multiply(t93, t100, w6)
    t102 = np.add(t92, t101, w1)
    t103 = np.divide(t93, t88, w5)
    t104 = np.multiply(x, 0.25, w6)
    t105 = np.multiply(r, 0.5, velocity)
    t106 = np.add(x, t105, w2)
    t107 = np.multiply(t104, t106, w6)
    t108 = np.multiply(t103, t107, w5)
    t109 = np.add(t108, 1.0, w5)
    t110 = np.divide(t98, tracking_index, w7)
    t111 = np.multiply(t110, 2.0, w7)
    t112 = np.divide(t102, t88, w1)
    t113 = np.divide(t99, t4, w3)
    t114 = np.multiply(t112, t113, w1)
    t115 = np.multiply(t114, 2.0, w1)
    t116 = np.multiply(t109, 0.5, w2)
    t117 = np.add(t115, t116, w2)
    t118 = np.add(t111, t117, w7)
    t119 = np.add(t115, t109, w1)
    t120 = np.multiply(e, 0.5, w0)
    t121 = np.add(t4, t120, acceleration)
    t122 = np.multiply(p, 0.125, w0)
    t123 = np.add(t97, t122, w8)
    t124 = np.add(t121, t123, acceleration)
    t125 = np.multiply(p, t124, acceleration)
    t126 = np.divide(t118, t125, w7)
    t128 = np.divide(t119, t125, w1)
    t130 = np.divide(t109, t125, w5)
    np.divide(t126, t125, position)
    np.divide(t128, t125, velocity)
    np.divide(t130, t125, acceleration)


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
        delta = 8/Lambda,
        xi = sqrt(2 + 2 eta), eta = sqrt(1 + 2 delta xi), nu = 1 + xi + eta + delta

    tracking_index: Lambda, with Lambda^2 =
        increment_deviation**2*sampling_interval**4/measurement_deviation**2; a number above 0 and
        finite.

    innovation_deviation: standard deviation of an innovation over sigma_v. Relative error at most
        4.41 * 2^-52 (float64), 4.41 * 2^-23 (float32), proved for 5e-324 <= tracking_index <=
        1.7976931348623157e308 (float64) and 1e-45 <= tracking_index <= 3.4028235e38 (float32).

    Outside an output's range, a few numbers next to its ends apart, its true value is no normal
    number: it comes as 0, a subnormal number or infinity, never as NaN. Numbers and arrays are
    taken, arrays of any shape; inputs are broadcast. float64 and float32 stay what they are,
    integers become float64. `out`: a tuple of arrays to fill.

    ValueError: an input outside its domain, with its place; `out` that does not fit. TypeError: an
    input that is no real number of these types.

    Source: derivation acceleration-increments
    """
    return InnovationDeviation(*evaluate(_INNOVATION_DEVIATION, (tracking_index,), out))


def _innovation_deviation_block(given: Arrays, out: Arrays, work: Arrays, single: bool) -> None:
    (tracking_index,) = given
    (innovation_deviation,) = out
    w0, w1, w2, w3, w4, w5, w6, w7, w8 = work
    p = np.sqrt(tracking_index, innovation_deviation)
    r = np.sqrt(p, w0)
    t4 = np.divide(1.0, p, w1)
    t5 = np.multiply(t4, r, w2)
    t7 = np.multiply(t5, 2.0, w2)
    t9 = np.multiply(p, 0.5, w3)
    t11 = np.multiply(tracking_index, 0.0625, w4)
    t12 = np.multiply(p, r, w5)
    t13 = np.multiply(t12, 1.0, w5)
    t15 = np.divide(8.0, r, w6)
    t16 = np.add(t13, t15, w5)
    t17 = near_cbrt(t16, w5, single)
    t20 = np.multiply(t7, t17, w6)
    t21 = np.add(t20, t11, w6)
    t22 = np.sqrt(t21, w6)
    t23 = np.multiply(t22, 2.0, w7)
    t24 = np.add(t23, t9, w7)
    t25 = np.sqrt(t24, w7)
    t26 = np.multiply(t7, 0.5, w8)
    t27 = np.multiply(t22, t25, w6)
    t28 = np.multiply(t25, t27, w7)
    t29 = np.multiply(t26, t17, w5)
    t30 = np.subtract(t28, t29, w7)
    t31 = np.subtract(t27, t26, w6)
    t32 = np.divide(t30, t31, w7)
    t34 = np.multiply(t7, t32, w5)
    t35 = np.add(t34, t11, w5)
    t36 = np.sqrt(t35, w5)
    t37 = np.multiply(t36, 2.0, w6)
    t38 = np.add(t37, t9, w6)
    t39 = np.sqrt(t38, w6)
    t40 = np.multiply(t36, t39, w5)
    t41 = np.multiply(t39, t40, w6)
    t42 = np.multiply(t26, t32, w7)
    t43 = np.subtract(t41, t42, w6)
    t44 = np.subtract(t40, t26, w5)
    t45 = np.divide(t43, t44, w6)
    t47 = np.multiply(t7, t45, w5)
    t48 = np.add(t47, t11, w5)
    t49 = np.sqrt(t48, w5)
    t50 = np.multiply(t49, 2.0, w7)
    t51 = np.add(t50, t9, w7)
    t52 = np.sqrt(t51, w7)
    t53 = np.multiply(t49, t52, w5)
    t54 = np.multiply(t52, t53, w7)
    t55 = np.multiply(t26, t45, w6)
    t56 = np.subtract(t54, t55, w7)
    t57 = np.subtract(t53, t26, w5)
    t58 = np.divide(t56, t57, w7)
    t60 = np.multiply(t7, t58, w5)
    t61 = np.add(t60, t11, w5)
    t62 = np.sqrt(t61, w5)
    t63 = np.multiply(t62, 2.0, w6)
    t64 = np.add(t63, t9, w6)
    t65 = np.sqrt(t64, w6)
    t66 = np.multiply(t62, t65, w5)
    t67 = np.multiply(t65, t66, w6)
    t68 = np.multiply(t26, t58, w7)
    t69 = np.subtract(t67, t68, w6)
    t70 = np.subtract(t66, t26, w5)
    t71 = np.divide(t69, t70, w6)
    t73 = np.multiply(t7, t71, w2)
    t74 = np.add(t73, t11, w2)
    e = np.sqrt(t74, w2)
    t76 = np.multiply(e, 2.0, w4)
    t77 = np.add(t76, t9, w4)
    x = np.sqrt(t77, w4)
    t79 = np.multiply(e, 0.5, w2)
    t80 = np.add(t4, t79, w1)
    t81 = np.multiply(x, r, w4)
    t83 = np.multiply(t81, 0.25, w4)
    t84 = np.multiply(p, 0.125, w0)
    t85 = np.add(t83, t84, w4)
    t86 = np.add(t80, t85, w1)
    np.multiply(p, t86, innovation_deviation)


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
        delta = 8/Lambda,
        xi = sqrt(2 + 2 eta), eta = sqrt(1 + 2 delta xi), nu = 1 + xi + eta + delta

    tracking_index: Lambda, with Lambda^2 =
        increment_deviation**2*sampling_interval**4/measurement_deviation**2; a number above 0 and
        at most 2^511, in float32 above 0 and at most 2^63.

    predicted_11: variance of the predicted position over sigma_v^2. Relative error at most 9.58 *
        2^-52 (float64), 9.58 * 2^-23 (float32), proved for 5e-324 <= tracking_index <=
        6.703903964971299e153 (float64) and 1e-45 <= tracking_index <= 9.223372e18 (float32).
    predicted_12: covariance of predicted position and velocity times T/sigma_v^2. Relative error at
        most 9.43 * 2^-52 (float64), 9.44 * 2^-23 (float32), proved for 5e-324 <= tracking_index <=
        6.703903964971299e153 (float64) and 1e-45 <= tracking_index <= 9.223372e18 (float32).
    predicted_13: covariance of predicted position and acceleration times T^2/sigma_v^2. Relative
        error at most 4.91 * 2^-52 (float64), 4.91 * 2^-23 (float32), proved for
        2.2250738585072014e-308 <= tracking_index <= 6.703903964971299e153 (float64) and
        1.1754944e-38 <= tracking_index <= 9.223372e18 (float32).
    predicted_22: variance of the predicted velocity times T^2/sigma_v^2. Relative error at most
        12.33 * 2^-52 (float64), 12.36 * 2^-23 (float32), proved for 7.416912861690675e-309 <=
        tracking_index <= 6.703903964971299e153 (float64) and 3.918315e-39 <= tracking_index <=
        9.223372e18 (float32).
    predicted_23: covariance of predicted velocity and acceleration times T^3/sigma_v^2. Relative
        error at most 6.40 * 2^-52 (float64), 6.40 * 2^-23 (float32), proved for
        1.0832677820940206e-231 <= tracking_index <= 6.703903964971299e153 (float64) and
        2.122721e-29 <= tracking_index <= 9.223372e18 (float32).
    predicted_33: variance of the predicted acceleration times T^4/sigma_v^2. Relative error at most
        5.93 * 2^-52 (float64), 5.93 * 2^-23 (float32), proved for 1.6896185209462645e-185 <=
        tracking_index <= 6.703903964971299e153 (float64) and 1.1521641e-23 <= tracking_index <=
        9.223372e18 (float32).

    Outside an output's range, a few numbers next to its ends apart, its true value is no normal
    number: it comes as 0, a subnormal number or infinity, never as NaN. Numbers and arrays are
    taken, arrays of any shape; inputs are broadcast. float64 and float32 stay what they are,
    integers become float64. `out`: a tuple of arrays to fill.

    ValueError: an input outside its domain, with its place; `out` that does not fit. TypeError: an
    input that is no real number of these types.

    Source: derivation acceleration-increments
    """
    return PredictedCovariance(*evaluate(_PREDICTED_COVARIANCE, (tracking_index,), out))


def _predicted_covariance_block(given: Arrays, out: Arrays, work: Arrays, single: bool) -> None:
    (tracking_index,) = given
    predicted_11, predicted_12, predicted_13, predicted_22, predicted_23, predicted_33 = out
    w0, w1, w2, w3, w4 = work
    p = np.sqrt(tracking_index, predicted_11)
    r = np.sqrt(p, predicted_12)
    t4 = np.divide(1.0, p, predicted_13)
    t5 = np.multiply(t4, r, w0)
    t7 = np.multiply(t5, 2.0, w0)
    t9 = np.multiply(p, 0.5, w1)
    t11 = np.multiply(tracking_index, 0.0625, w2)
    t12 = np.multiply(p, r, w3)
    t13 = np.multiply(t12, 1.0, w4)
    t15 = np.divide(8.0, r, predicted_22)
    t16 = np.add(t13, t15, w4)
    t17 = near_cbrt(t16, w4, single)
    t20 = np.multiply(t7, t17, predicted_22)
    t21 = np.add(t20, t11, predicted_22)
    t22 = np.sqrt(t21, predicted_23)
    t23 = np.multiply(t22, 2.0, predicted_22)
    t24 = np.add(t23, t9, predicted_22)
    t25 = np.sqrt(t24, predicted_33)
    t26 = np.multiply(t7, 0.5, predicted_22)
    t27 = np.multiply(t22, t25, predicted_23)
    t28 = np.multiply(t25, t27, predicted_33)
    t29 = np.multiply(t26, t17, w4)
    t30 = np.subtract(t28, t29, predicted_33)
    t31 = np.subtract(t27, t26, predicted_23)
    t32 = np.divide(t30, t31, predicted_33)
    t34 = np.multiply(t7, t32, w4)
    t35 = np.add(t34, t11, w4)
    t36 = np.sqrt(t35, w4)
    t37 = np.multiply(t36, 2.0, predicted_23)
    t38 = np.add(t37, t9, predicted_23)
    t39 = np.sqrt(t38, predicted_23)
    t40 = np.multiply(t36, t39, w4)
    t41 = np.multiply(t39, t40, predicted_23)
    t42 = np.multiply(t26, t32, predicted_33)
    t43 = np.subtract(t41, t42, predicted_23)
    t44 = np.subtract(t40, t26, w4)
    t45 = np.divide(t43, t44, predicted_23)
    t47 = np.multiply(t7, t45, w4)
    t48 = np.add(t47, t11, w4)
    t49 = np.sqrt(t48, w4)
    t50 = np.multiply(t49, 2.0, predicted_33)
    t51 = np.add(t50, t9, predicted_33)
    t52 = np.sqrt(t51, predicted_33)
    t53 = np.multiply(t49, t52, w4)
    t54 = np.multiply(t52, t53, predicted_33)
    t55 = np.multiply(t26, t45, predicted_23)
    t56 = np.subtract(t54, t55, predicted_33)
    t57 = np.subtract(t53, t26, w4)
    t58 = np.divide(t56, t57, predicted_33)
    t60 = np.multiply(t7, t58, w4)
    t61 = np.add(t60, t11, w4)
    t62 = np.sqrt(t61, w4)
    t63 = np.multiply(t62, 2.0, predicted_23)
    t64 = np.add(t63, t9, predicted_23)
    t65 = np.sqrt(t64, predicted_23)
    t66 = np.multiply(t62, t65, w4)
    t67 = np.multiply(t65, t66, predicted_23)
    t68 = np.multiply(t26, t58, predicted_33)
    t69 = np.subtract(t67, t68, predicted_23)
    t70 = np.subtract(t66, t26, w4)
    t71 = np.divide(t69, t70, predicted_23)
    t73 = np.multiply(t7, t71, w0)
    t74 = np.add(t73, t11, w0)
    e = np.sqrt(t74, w0)
    t76 = np.multiply(e, 2.0, w2)
    t77 = np.add(t76, t9, w2)
    x = np.sqrt(t77, w2)
    t79 = np.multiply(e, 0.5, w1)
    t80 = np.add(t4, t79, predicted_13)
    t81 = np.multiply(x, r, w1)
    t83 = np.multiply(t81, 0.25, w1)
    t84 = np.multiply(p, 0.125, w4)
    t85 = np.add(t83, t84, w1)
    t86 = np.add(t80, t85, predicted_13)
    t87 = np.multiply(p, t86, predicted_13)
    t88 = np.multiply(t12, x, w3)
    t89 = np.multiply(p, e, w1)
    t90 = np.multiply(p, 0.25, w4)
    t91 = np.add(e, t90, w4)
    t92 = np.multiply(t91, p, w4)
    t96 = np.square(e, w0)
    t98 = np.multiply(t96, 0.75, w0)
    t99 = np.multiply(t89, 0.25, predicted_11)
    t101 = np.multiply(tracking_index, 0.015625, predicted_22)
    t102 = np.add(t98, t99, w0)
    t103 = np.add(t102, t101, w0)
    t104 = np.divide(t103, x, w0)
    t105 = np.multiply(r, 2.0, predicted_12)
    t106 = np.multiply(t104, t105, w0)
    t107 = np.multiply(t88, 0.25, w2)
    t108 = np.multiply(tracking_index, 0.25, predicted_11)
    t109 = np.add(t106, t107, w0)
    t110 = np.add(t109, t89, w0)
    t111 = np.add(t110, t108, w0)
    t113 = np.multiply(t88, 0.5, w2)
    t114 = np.add(t89, t113, w1)
    t115 = np.add(t114, t108, w1)
    t117 = np.add(t88, tracking_index, w2)
    np.multiply(t92, t87, predicted_11)
    np.multiply(t88, t87, predicted_12)
    np.multiply(tracking_index, t87, predicted_13)
    np.multiply(tracking_index, t111, predicted_22)
    np.multiply(tracking_index, t115, predicted_23)
    np.multiply(tracking_index, t117, predicted_33)


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

        delta = 8/Lambda,
        xi = sqrt(2 + 2 eta), eta = sqrt(1 + 2 delta xi), nu = 1 + xi + eta + delta

    tracking_index: Lambda, with Lambda^2 =
        increment_deviation**2*sampling_interval**4/measurement_deviation**2; a number above 0 and
        at most 2^1000, in float32 above 0 and at most 2^120.

    predicted_11: derivative of the variance of the predicted position over sigma_v^2. Relative
        error at most 12.42 * 2^-52 (float64), 12.42 * 2^-23 (float32), proved for 5e-324 <=
        tracking_index <= 1.0715086071862673e301 (float64) and 1e-45 <= tracking_index <=
        1.329228e36 (float32).
    predicted_12: derivative of the covariance of predicted position and velocity times T/sigma_v^2.
        Relative error at most 10.91 * 2^-52 (float64), 10.91 * 2^-23 (float32), proved for 5e-324
        <= tracking_index <= 1.0715086071862673e301 (float64) and 1e-45 <= tracking_index <=
        1.329228e36 (float32).
    predicted_13: derivative of the covariance of predicted position and acceleration times
        T^2/sigma_v^2. Relative error at most 6.95 * 2^-52 (float64), 6.95 * 2^-23 (float32), proved
        for 5e-324 <= tracking_index <= 1.0715086071862673e301 (float64) and 1e-45 <= tracking_index
        <= 1.329228e36 (float32).
    predicted_22: derivative of the variance of the predicted velocity times T^2/sigma_v^2. Relative
        error at most 14.88 * 2^-52 (float64), 14.86 * 2^-23 (float32), proved for 5e-324 <=
        tracking_index <= 1.0715086071862673e301 (float64) and 1e-45 <= tracking_index <=
        1.329228e36 (float32).
    predicted_23: derivative of the covariance of predicted velocity and acceleration times
        T^3/sigma_v^2. Relative error at most 9.90 * 2^-52 (float64), 9.89 * 2^-23 (float32), proved
        for 5e-324 <= tracking_index <= 1.0715086071862673e301 (float64) and 1e-45 <= tracking_index
        <= 1.329228e36 (float32).
    predicted_33: derivative of the variance of the predicted acceleration times T^4/sigma_v^2.
        Relative error at most 7.64 * 2^-52 (float64), 7.63 * 2^-23 (float32), proved for 5e-324 <=
        tracking_index <= 1.0715086071862673e301 (float64) and 1e-45 <= tracking_index <=
        1.329228e36 (float32).

    Outside an output's range, a few numbers next to its ends apart, its true value is no normal
    number: it comes as 0, a subnormal number or infinity, never as NaN. Numbers and arrays are
    taken, arrays of any shape; inputs are broadcast. float64 and float32 stay what they are,
    integers become float64. `out`: a tuple of arrays to fill.

    ValueError: an input outside its domain, with its place; `out` that does not fit. TypeError: an
    input that is no real number of these types.

    Source: derivation acceleration-increments
    """
    return PredictedCovarianceDerivatives(
        *evaluate(_PREDICTED_COVARIANCE_DERIVATIVES, (tracking_index,), out)
    )


def _predicted_covariance_derivatives_block(
    given: Arrays, out: Arrays, work: Arrays, single: bool
) -> None:
    (tracking_index,) = given
    predicted_11, predicted_12, predicted_13, predicted_22, predicted_23, predicted_33 = out
    w0, w1, w2, w3, w4, w5, w6, w7, w8, w9, w10, w11 = work
    p = np.sqrt(tracking_index, predicted_11)
    r = np.sqrt(p, predicted_12)
    t4 = np.divide(1.0, p, predicted_13)
    t5 = np.multiply(t4, r, w0)
    t7 = np.multiply(t5, 2.0, w0)
    t9 = np.multiply(p, 0.5, w1)
    t11 = np.multiply(tracking_index, 0.0625, w2)
    t12 = np.multiply(p, r, w3)
    t13 = np.multiply(t12, 1.0, w4)
    t15 = np.divide(8.0, r, predicted_22)
    t16 = np.add(t13, t15, w4)
    t17 = near_cbrt(t16, w4, single)
    t20 = np.multiply(t7, t17, predicted_22)
    t21 = np.add(t20, t11, predicted_22)
    t22 = np.sqrt(t21, predicted_23)
    t23 = np.multiply(t22, 2.0, predicted_22)
    t24 = np.add(t23, t9, predicted_22)
    t25 = np.sqrt(t24, predicted_33)
    t26 = np.multiply(t7, 0.5, predicted_22)
    t27 = np.multiply(t22, t25, predicted_23)
    t28 = np.multiply(t25, t27, predicted_33)
    t29 = np.multiply(t26, t17, w4)
    t30 = np.subtract(t28, t29, predicted_33)
    t31 = np.subtract(t27, t26, predicted_23)
    t32 = np.divide(t30, t31, predicted_33)
    t34 = np.multiply(t7, t32, w4)
    t35 = np.add(t34, t11, w4)
    t36 = np.sqrt(t35, w4)
    t37 = np.multiply(t36, 2.0, predicted_23)
    t38 = np.add(t37, t9, predicted_23)
    t39 = np.sqrt(t38, predicted_23)
    t40 = np.multiply(t36, t39, w4)
    t41 = np.multiply(t39, t40, predicted_23)
    t42 = np.multiply(t26, t32, predicted_33)
    t43 = np.subtract(t41, t42, predicted_23)
    t44 = np.subtract(t40, t26, w4)
    t45 = np.divide(t43, t44, predicted_23)
    t47 = np.multiply(t7, t45, w4)
    t48 = np.add(t47, t11, w4)
    t49 = np.sqrt(t48, w4)
    t50 = np.multiply(t49, 2.0, predicted_33)
    t51 = np.add(t50, t9, predicted_33)
    t52 = np.sqrt(t51, predicted_33)
    t53 = np.multiply(t49, t52, w4)
    t54 = np.multiply(t52, t53, predicted_33)
    t55 = np.multiply(t26, t45, predicted_23)
    t56 = np.subtract(t54, t55, predicted_33)
    t57 = np.subtract(t53, t26, w4)
    t58 = np.divide(t56, t57, predicted_33)
    t60 = np.multiply(t7, t58, w4)
    t61 = np.add(t60, t11, w4)
    t62 = np.sqrt(t61, w4)
    t63 = np.multiply(t62, 2.0, predicted_23)
    t64 = np.add(t63, t9, predicted_23)
    t65 = np.sqrt(t64, predicted_23)
    t66 = np.multiply(t62, t65, w4)
    t67 = np.multiply(t65, t66, predicted_23)
    t68 = np.multiply(t26, t58, predicted_33)
    t69 = np.subtract(t67, t68, predicted_23)
    t70 = np.subtract(t66, t26, w4)
    t71 = np.divide(t69, t70, predicted_23)
    t73 = np.multiply(t7, t71, w0)
    t74 = np.add(t73, t11, w0)
    e = np.sqrt(t74, w0)
    t76 = np.multiply(e, 2.0, w2)
    t77 = np.add(t76, t9, w2)
    x = np.sqrt(t77, w2)
    t79 = np.square(e, w1)
    t81 = np.multiply(t79, 0.75, w4)
    t82 = np.multiply(p, e, predicted_22)
    t84 = np.multiply(t82, 0.25, predicted_23)
    t86 = np.multiply(tracking_index, 0.015625, predicted_33)
    t87 = np.add(t81, t84, w4)
    t88 = np.add(t87, t86, w4)
    t89 = np.multiply(t79, 0.25, predicted_23)
    t90 = np.multiply(t82, 0.125, w5)
    t91 = np.add(t89, t90, w5)
    t92 = np.add(t91, t86, w5)
    t93 = np.multiply(x, r, w6)
    t94 = np.multiply(p, 0.25, w7)
    t95 = np.add(e, t94, w7)
    t96 = np.divide(t92, t88, w5)
    t97 = np.multiply(t96, 2.0, w5)
    t98 = np.divide(t95, t88, w7)
    t99 = np.multiply(t93, 0.25, w6)
    t100 = np.multiply(t98, t99, w7)
    t101 = np.add(t97, 1.0, w8)
    t102 = np.multiply(e, 0.5, w9)
    t103 = np.add(t4, t102, predicted_13)
    t104 = np.multiply(p, 0.125, w9)
    t105 = np.add(t99, t104, w6)
    t106 = np.add(t103, t105, predicted_13)
    t107 = np.multiply(p, t106, w6)
    t108 = np.multiply(t12, x, w3)
    t109 = np.divide(x, r, w9)
    t110 = np.multiply(e, p, w10)
    t112 = np.multiply(t82, 0.09375, w11)
    t113 = np.add(t89, t112, predicted_23)
    t114 = np.add(t113, t86, predicted_23)
    t115 = np.divide(t114, t88, predicted_23)
    t117 = np.multiply(t115, 4.0, predicted_23)
    t118 = np.multiply(t110, t117, predicted_23)
    t119 = np.divide(tracking_index, t88, w11)
    t120 = np.multiply(t119, tracking_index, w11)
    t122 = np.multiply(t120, 0.0078125, w11)
    t123 = np.add(t118, t122, predicted_23)
    t124 = np.divide(t100, p, predicted_11)
    t125 = np.multiply(t124, t106, predicted_11)
    t126 = np.multiply(t107, 2.0, w11)
    t128 = np.add(t97, t100, w5)
    t129 = np.multiply(t109, t128, w9)
    t131 = np.add(t100, 1.0, w7)
    t134 = np.multiply(t79, 0.5625, w1)
    t135 = np.multiply(t82, 0.5, predicted_22)
    t137 = np.multiply(tracking_index, 0.1796875, w5)
    t138 = np.add(t134, t135, w1)
    t139 = np.add(t138, t137, w1)
    t140 = np.multiply(t110, 0.5, w10)
    t142 = np.multiply(tracking_index, 0.03515625, w5)
    t143 = np.add(t140, t142, w10)
    t144 = np.divide(t139, t88, w1)
    t145 = np.multiply(e, t144, w1)
    t146 = np.divide(e, x, w0)
    t147 = np.multiply(t145, t146, w1)
    t148 = np.multiply(r, 2.0, w0)
    t149 = np.multiply(t147, t148, w1)
    t150 = np.divide(t143, t88, w10)
    t151 = np.divide(tracking_index, x, w2)
    t152 = np.multiply(t150, t151, w10)
    t153 = np.multiply(r, 0.125, predicted_12)
    t154 = np.multiply(t152, t153, w10)
    t155 = np.add(t149, t154, w1)
    t156 = np.multiply(t108, 0.5, w0)
    t157 = np.multiply(t101, 0.5, w2)
    t158 = np.multiply(t156, t157, w2)
    t159 = np.multiply(tracking_index, 0.5, w4)
    t160 = np.add(t155, t158, w1)
    t161 = np.add(t160, t123, w1)
    t163 = np.multiply(t156, t101, w0)
    t164 = np.add(t163, t123, w0)
    t166 = np.multiply(t108, t101, w3)
    t167 = np.multiply(tracking_index, 2.0, w2)
    np.multiply(t125, t126, predicted_11)
    np.multiply(t129, t107, predicted_12)
    np.multiply(t107, t131, predicted_13)
    np.add(t161, t159, predicted_22)
    np.add(t164, t159, predicted_23)
    np.add(t166, t167, predicted_33)


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
    12,
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
        delta = 8/Lambda,
        xi = sqrt(2 + 2 eta), eta = sqrt(1 + 2 delta xi), nu = 1 + xi + eta + delta

    tracking_index: Lambda, with Lambda^2 =
        increment_deviation**2*sampling_interval**4/measurement_deviation**2; a number above 0 and
        at most 2^511, in float32 above 0 and at most 2^63.

    updated_11: variance of the updated position over sigma_v^2. Relative error at most 6.18 * 2^-52
        (float64), 6.18 * 2^-23 (float32), proved for 5e-324 <= tracking_index <=
        6.703903964971299e153 (float64) and 1e-45 <= tracking_index <= 9.223372e18 (float32).
    updated_12: covariance of updated position and velocity times T/sigma_v^2. Relative error at
        most 6.09 * 2^-52 (float64), 6.09 * 2^-23 (float32), proved for 5e-324 <= tracking_index <=
        6.703903964971299e153 (float64) and 1e-45 <= tracking_index <= 9.223372e18 (float32).
    updated_13: covariance of updated position and acceleration times T^2/sigma_v^2. Relative error
        at most 4.56 * 2^-52 (float64), 4.56 * 2^-23 (float32), proved for 2.2250738585072014e-308
        <= tracking_index <= 6.703903964971299e153 (float64) and 1.1754945e-38 <= tracking_index <=
        9.223372e18 (float32).
    updated_22: variance of the updated velocity times T^2/sigma_v^2. Relative error at most 42.28 *
        2^-52 (float64), 42.29 * 2^-23 (float32), proved for 7.416912861690675e-309 <=
        tracking_index <= 6.703903964971299e153 (float64) and 3.918315e-39 <= tracking_index <=
        9.223372e18 (float32).
    updated_23: covariance of updated velocity and acceleration times T^3/sigma_v^2. Relative error
        at most 18.48 * 2^-52 (float64), 18.47 * 2^-23 (float32), proved for 1.0832677820940206e-231
        <= tracking_index <= 6.703903964971299e153 (float64) and 2.122721e-29 <= tracking_index <=
        9.223372e18 (float32).
    updated_33: variance of the updated acceleration times T^4/sigma_v^2. Relative error at most
        9.23 * 2^-52 (float64), 9.22 * 2^-23 (float32), proved for 1.6896185209462645e-185 <=
        tracking_index <= 6.703903964971299e153 (float64) and 1.1521641e-23 <= tracking_index <=
        9.223372e18 (float32).

    Outside an output's range, a few numbers next to its ends apart, its true value is no normal
    number: it comes as 0, a subnormal number or infinity, never as NaN. Numbers and arrays are
    taken, arrays of any shape; inputs are broadcast. float64 and float32 stay what they are,
    integers become float64. `out`: a tuple of arrays to fill.

    ValueError: an input outside its domain, with its place; `out` that does not fit. TypeError: an
    input that is no real number of these types.

    Source: derivation acceleration-increments
    """
    return UpdatedCovariance(*evaluate(_UPDATED_COVARIANCE, (tracking_index,), out))


def _updated_covariance_block(given: Arrays, out: Arrays, work: Arrays, single: bool) -> None:
    (tracking_index,) = given
    updated_11, updated_12, updated_13, updated_22, updated_23, updated_33 = out
    w0, w1, w2, w3, w4, w5 = work
    p = np.sqrt(tracking_index, updated_13)
    r = np.sqrt(p, updated_11)
    t4 = np.divide(1.0, p, updated_12)
    t5 = np.multiply(t4, r, w0)
    t7 = np.multiply(t5, 2.0, w0)
    t9 = np.multiply(p, 0.5, w1)
    t11 = np.multiply(tracking_index, 0.0625, w2)
    t12 = np.multiply(p, r, w3)
    t13 = np.multiply(t12, 1.0, w4)
    t15 = np.divide(8.0, r, updated_22)
    t16 = np.add(t13, t15, w4)
    t17 = near_cbrt(t16, w4, single)
    t20 = np.multiply(t7, t17, updated_22)
    t21 = np.add(t20, t11, updated_22)
    t22 = np.sqrt(t21, updated_23)
    t23 = np.multiply(t22, 2.0, updated_22)
    t24 = np.add(t23, t9, updated_22)
    t25 = np.sqrt(t24, updated_33)
    t26 = np.multiply(t7, 0.5, updated_22)
    t27 = np.multiply(t22, t25, updated_23)
    t28 = np.multiply(t25, t27, updated_33)
    t29 = np.multiply(t26, t17, w4)
    t30 = np.subtract(t28, t29, updated_33)
    t31 = np.subtract(t27, t26, updated_23)
    t32 = np.divide(t30, t31, updated_33)
    t34 = np.multiply(t7, t32, w4)
    t35 = np.add(t34, t11, w4)
    t36 = np.sqrt(t35, w4)
    t37 = np.multiply(t36, 2.0, updated_23)
    t38 = np.add(t37, t9, updated_23)
    t39 = np.sqrt(t38, updated_23)
    t40 = np.multiply(t36, t39, w4)
    t41 = np.multiply(t39, t40, updated_23)
    t42 = np.multiply(t26, t32, updated_33)
    t43 = np.subtract(t41, t42, updated_23)
    t44 = np.subtract(t40, t26, w4)
    t45 = np.divide(t43, t44, updated_23)
    t47 = np.multiply(t7, t45, w4)
    t48 = np.add(t47, t11, w4)
    t49 = np.sqrt(t48, w4)
    t50 = np.multiply(t49, 2.0, updated_33)
    t51 = np.add(t50, t9, updated_33)
    t52 = np.sqrt(t51, updated_33)
    t53 = np.multiply(t49, t52, w4)
    t54 = np.multiply(t52, t53, updated_33)
    t55 = np.multiply(t26, t45, updated_23)
    t56 = np.subtract(t54, t55, updated_33)
    t57 = np.subtract(t53, t26, w4)
    t58 = np.divide(t56, t57, updated_33)
    t60 = np.multiply(t7, t58, w4)
    t61 = np.add(t60, t11, w4)
    t62 = np.sqrt(t61, w4)
    t63 = np.multiply(t62, 2.0, updated_23)
    t64 = np.add(t63, t9, updated_23)
    t65 = np.sqrt(t64, updated_23)
    t66 = np.multiply(t62, t65, w4)
    t67 = np.multiply(t65, t66, updated_23)
    t68 = np.multiply(t26, t58, updated_33)
    t69 = np.subtract(t67, t68, updated_23)
    t70 = np.subtract(t66, t26, w4)
    t71 = np.divide(t69, t70, updated_23)
    t73 = np.multiply(t7, t71, w0)
    t74 = np.add(t73, t11, w0)
    e = np.sqrt(t74, w0)
    t76 = np.multiply(e, 2.0, w2)
    t77 = np.add(t76, t9, w2)
    x = np.sqrt(t77, w2)
    t79 = np.multiply(e, x, w1)
    t80 = np.multiply(x, p, w4)
    t82 = np.multiply(t80, 0.25, w4)
    t83 = np.multiply(e, r, updated_22)
    t84 = np.multiply(t83, 1.0, updated_22)
    t85 = np.multiply(t12, 0.25, w3)
    t86 = np.add(t79, t82, w1)
    t87 = np.add(t86, t84, w1)
    t88 = np.add(t87, t85, w1)
    t89 = np.multiply(x, 8.0, w3)
    t90 = np.divide(t89, t4, w3)
    t91 = np.divide(t90, t88, w3)
    t92 = np.divide(t91, tracking_index, w1)
    t93 = np.multiply(t91, 0.5, w4)
    t94 = np.add(t93, tracking_index, w4)
    t95 = np.multiply(t92, 0.125, updated_22)
    t96 = np.add(t95, 0.25, updated_22)
    t97 = np.multiply(t91, t96, updated_23)
    t98 = np.multiply(e, 0.5, updated_22)
    t99 = np.add(t4, t98, updated_12)
    t100 = np.multiply(x, r, updated_22)
    t101 = np.multiply(t100, 0.25, updated_33)
    t102 = np.multiply(p, 0.125, w5)
    t103 = np.add(t101, t102, updated_33)
    t104 = np.add(t99, t103, updated_33)
    t105 = np.multiply(p, 0.25, w5)
    t106 = np.add(e, t105, w0)
    t111 = np.multiply(t92, 0.046875, w5)
    t112 = np.add(t111, 0.25, w5)
    t113 = np.multiply(t92, t112, w1)
    t115 = np.add(t113, 0.4375, w1)
    t116 = np.multiply(r, 0.5, updated_11)
    t117 = np.divide(t116, x, updated_11)
    t118 = np.multiply(t91, t117, w2)
    t119 = np.multiply(t91, t115, w3)
    t120 = np.multiply(tracking_index, 0.25, w1)
    t121 = np.add(t119, t120, w3)
    np.divide(t106, t104, updated_11)
    np.divide(t100, t104, updated_12)
    np.divide(p, t104, updated_13)
    np.multiply(t118, t121, updated_22)
    np.multiply(tracking_index, t97, updated_23)
    np.multiply(tracking_index, t94, updated_33)


_UPDATED_COVARIANCE = Signature(
    "updated_covariance",
    (_TRACKING_INDEX_DOMAIN_2,),
    ("updated_11", "updated_12", "updated_13", "updated_22", "updated_23", "updated_33"),
    6,
    _updated_covariance_block,
)


class IndexFromAlpha(NamedTuple):
    """Result of `index_from_alpha`."""

    tracking_index: Real
    """Tracking index Lambda."""


def index_from_alpha(alpha: ArrayLike, *, out: tuple[Real] | None = None) -> IndexFromAlpha:
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
    integers become float64. `out`: a tuple of arrays to fill.

    ValueError: an input outside its domain, with its place; `out` that does not fit. TypeError: an
    input that is no real number of these types.

    Source: derivation acceleration-increments
    """
    return IndexFromAlpha(*evaluate(_INDEX_FROM_ALPHA, (alpha,), out))


def _index_from_alpha_block(given: Arrays, out: Arrays, work: Arrays, _single: bool) -> None:
    (alpha,) = given
    (tracking_index,) = out
    w0, w1, w2 = work
    t2 = np.subtract(1.0, alpha, w0)
    w = np.sqrt(t2, tracking_index)
    t4 = np.add(w, 1.0, w0)
    t5 = np.divide(alpha, t4, w1)
    t6 = np.square(t5, w2)
    t8 = np.multiply(t6, 2.0, w2)
    t9 = np.divide(t5, t4, w1)
    t10 = np.multiply(t8, t9, w2)
    np.divide(t10, w, tracking_index)


_INDEX_FROM_ALPHA = Signature(
    "index_from_alpha",
    (_ALPHA_DOMAIN,),
    ("tracking_index",),
    3,
    _index_from_alpha_block,
)


class GainsFromAlpha(NamedTuple):
    """Result of `gains_from_alpha`."""

    beta: Real
    """Velocity gain times the sampling interval."""
    gamma: Real
    """Acceleration gain times the square of the sampling interval."""


def gains_from_alpha(alpha: ArrayLike, *, out: tuple[Real, Real] | None = None) -> GainsFromAlpha:
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
    integers become float64. `out`: a tuple of arrays to fill.

    ValueError: an input outside its domain, with its place; `out` that does not fit. TypeError: an
    input that is no real number of these types.

    Source: derivation acceleration-increments
    """
    return GainsFromAlpha(*evaluate(_GAINS_FROM_ALPHA, (alpha,), out))


def _gains_from_alpha_block(given: Arrays, out: Arrays, work: Arrays, _single: bool) -> None:
    (alpha,) = given
    beta, gamma = out
    (w0,) = work
    t2 = np.subtract(1.0, alpha, w0)
    w = np.sqrt(t2, beta)
    t4 = np.add(w, 1.0, w0)
    t5 = np.divide(alpha, t4, gamma)
    t6 = np.square(t5, beta)
    np.multiply(t6, 2.0, beta)
    t9 = np.divide(t5, t4, gamma)
    np.multiply(beta, t9, gamma)


_GAINS_FROM_ALPHA = Signature(
    "gains_from_alpha",
    (_ALPHA_DOMAIN,),
    ("beta", "gamma"),
    1,
    _gains_from_alpha_block,
)
