// Made by: gainproof generate alpha-beta
// From: gainproof derive alpha-beta, SymPy 1.14.0
// Alpha-beta filters with any gains.
(function () {
  "use strict";
  const { within, refuse, nearCubeRoot } = gainproof.runtime;
  gainproof.kernels["alpha-beta"] = {
    // Closed-loop poles, half_sum +- sqrt(quarter_discriminant).
    closed_loop_poles(alpha, beta) {
      if (!within(alpha, 1e-30, 0.9999999)) refuse("closed_loop_poles", "alpha", "a number at least 1e-30 and at most 0.9999999, in float32 at least 1e-12 and at most 0.999999", alpha);
      if (!within(beta, 1e-30, 1.9999999)) refuse("closed_loop_poles", "beta", "a number at least 1e-30 and at most 1.9999999, in float32 at least 1e-12 and at most 1.999999", beta);
      const t3 = 1.0 - alpha;
      const t4 = alpha + beta;
      const t6 = t4 * 0.5;
      const t8 = t6 * t6;
      const half_sum_difference = 1.0 - t6;
      const quarter_discriminant_difference = t8 - beta;
      const modulus = Math.sqrt(t3);
      return { half_sum: half_sum_difference, modulus, quarter_discriminant: quarter_discriminant_difference };
    },
    // Steady errors behind a constant acceleration a, over a T^2 (positions) and a T.
    lags(alpha, beta) {
      if (!within(alpha, 1e-30, 0.9999999)) refuse("lags", "alpha", "a number at least 1e-30 and at most 0.9999999, in float32 at least 1e-12 and at most 0.999999", alpha);
      if (!within(beta, 1e-30, 1.9999999)) refuse("lags", "beta", "a number at least 1e-30 and at most 1.9999999, in float32 at least 1e-12 and at most 1.999999", beta);
      const t3 = 1.0 - alpha;
      const t5 = beta * 2.0;
      const t6 = alpha * 2.0;
      const t7 = t6 / t5;
      const t8 = beta / t5;
      const updated_velocity_lag_difference = t7 - t8;
      const t10 = 1.0 / beta;
      const t11 = t7 + t8;
      const t12 = t3 / beta;
      return { predicted_position_lag: t10, predicted_velocity_lag: t11, updated_position_lag: t12, updated_velocity_lag: updated_velocity_lag_difference };
    },
    // Covariances under measurement noise alone, from the gains.
    variances(alpha, beta) {
      if (!within(alpha, 1e-30, 0.9999999)) refuse("variances", "alpha", "a number at least 1e-30 and at most 0.9999999, in float32 at least 1e-12 and at most 0.999999", alpha);
      if (!within(beta, 1e-30, 1.9999999)) refuse("variances", "beta", "a number at least 1e-30 and at most 1.9999999, in float32 at least 1e-12 and at most 1.999999", beta);
      const t3 = 1.0 - alpha;
      const t5 = t3 * 2.0;
      const t6 = 2.0 - beta;
      const t7 = t5 + t6;
      const t8 = beta / alpha;
      const t9 = alpha * 2.0;
      const t10 = t8 * 2.0;
      const t11 = t9 + t10;
      const t12 = t11 + beta;
      const t13 = t12 / t7;
      const t14 = beta * 2.0;
      const t15 = t14 / t7;
      const t16 = t8 * beta;
      const t17 = t16 / t7;
      const t19 = t16 * 2.0;
      const t22 = t3 * t3;
      const t23 = t22 * t13;
      const t24 = alpha * alpha;
      const updated_12_difference = t15 - t17;
      const t20 = t19 / t7;
      const t21 = t15 + t17;
      const t25 = t23 + t24;
      return { predicted_11: t13, predicted_12: t21, predicted_22: t20, updated_11: t25, updated_12: updated_12_difference, updated_22: t20 };
    },
    // Covariances under measurement noise alone, any stable filter.
    variances_of_coordinates(linear_coefficient, quadratic_coefficient) {
      if (!within(linear_coefficient, 1e-60, 1e60)) refuse("variances_of_coordinates", "linear_coefficient", "a number at least 1e-60 and at most 1e60, in float32 at least 1e-9 and at most 1e9", linear_coefficient);
      if (!within(quadratic_coefficient, 1e-60, 1e60)) refuse("variances_of_coordinates", "quadratic_coefficient", "a number at least 1e-60 and at most 1e60, in float32 at least 1e-9 and at most 1e9", quadratic_coefficient);
      const t3 = 1.0 + linear_coefficient;
      const t5 = linear_coefficient + (-1.0);
      const t6 = linear_coefficient * quadratic_coefficient;
      const t7 = t3 * t3;
      const t8 = t7 + quadratic_coefficient;
      const t11 = t3 * 2.0;
      const t15 = t5 * t5;
      const t16 = t15 + quadratic_coefficient;
      const t18 = t5 * 2.0;
      const t9 = t8 / t6;
      const t12 = t11 / t6;
      const t14 = 4.0 / t6;
      const t17 = t16 / t6;
      const t19 = t18 / t6;
      return { predicted_11: t9, predicted_12: t12, predicted_22: t14, updated_11: t17, updated_12: t19, updated_22: t14 };
    },
    // The stable filter of least position variance at a lag (MV).
    minimum_variance_by_lag(lag) {
      if (!within(lag, 0.25000000000000006, 1e30)) refuse("minimum_variance_by_lag", "lag", "a number above 1/4 and at most 1e30, in float32 above 1/4 and at most 1e9", lag);
      const root = Math.sqrt(lag);
      const t3 = root * 2.0;
      const t5 = lag * 4.0;
      const t8 = t5 + (-1.0);
      const t9 = t3 + 1.0;
      const t10 = t8 / t9;
      const t11 = lag * 2.0;
      const t14 = t10 * 2.0;
      const t15 = t14 + 1.0;
      const t16 = t15 / t10;
      const t12 = t10 / t11;
      const t13 = 1.0 / lag;
      const t17 = t16 / t10;
      return { minimum_variance_alpha: t12, minimum_variance_beta: t13, minimum_variance_predicted_11: t17 };
    },
  };
})();
