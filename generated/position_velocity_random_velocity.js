// Made by: gainproof generate position-velocity-random-velocity
// From: gainproof derive position-velocity-random-velocity, SymPy 1.14.0
// Position and velocity measured, random velocity (velocity random walk).
(function () {
  "use strict";
  const { within, refuse, nearCubeRoot } = gainproof.runtime;
  gainproof.kernels["position-velocity-random-velocity"] = {
    // Steady-state filter gain, position and velocity measured.
    gains(tracking_index, velocity_ratio) {
      if (!within(tracking_index, 1e-12, 1000000000000.0)) refuse("gains", "tracking_index", "a number at least 1e-12 and at most 1e12, in float32 at least 1e-8 and at most 4e6", tracking_index);
      if (!within(velocity_ratio, 1e-12, 1000000000000.0)) refuse("gains", "velocity_ratio", "a number at least 1e-12 and at most 1e12, in float32 at least 1e-6 and at most 1e8", velocity_ratio);
      const t2 = tracking_index * tracking_index;
      const t3 = velocity_ratio * velocity_ratio;
      const t5 = t2 + 16.0;
      const t6 = t5 * t3;
      const t8 = t2 * 4.0;
      const t9 = t6 + t8;
      const eta_scaled = Math.sqrt(t9);
      const t11 = tracking_index * velocity_ratio;
      const t12 = t11 + eta_scaled;
      const t14 = t12 * 0.5;
      const t15 = t11 * t14;
      const t16 = t2 + t15;
      const delta_scaled = Math.sqrt(t16);
      const t18 = t14 + delta_scaled;
      const sigma_scaled = t18 * 0.5;
      const t20 = tracking_index * sigma_scaled;
      const t21 = t20 / velocity_ratio;
      const coupling_scaled = t21 / velocity_ratio;
      const t23 = coupling_scaled + velocity_ratio;
      const cross_share = tracking_index / t23;
      const t25 = velocity_ratio * coupling_scaled;
      const rest_scaled = cross_share * t25;
      const t27 = cross_share / sigma_scaled;
      const t28 = t27 * t3;
      const t29 = delta_scaled * cross_share;
      const t30 = t29 / velocity_ratio;
      const t31 = t30 / velocity_ratio;
      const t32 = rest_scaled / sigma_scaled;
      const t33 = t28 * t27;
      const t34 = t32 + t33;
      const t35 = t34 / t31;
      return { gain_11: t35, gain_12: t27, gain_21: t28, gain_22: t31 };
    },
    // Closed-loop poles: half their sum, their modulus, a quarter of the discriminant.
    closed_loop_poles(tracking_index, velocity_ratio) {
      if (!within(tracking_index, 1e-12, 1000000000000.0)) refuse("closed_loop_poles", "tracking_index", "a number at least 1e-12 and at most 1e12, in float32 at least 1e-6 and at most 1e6", tracking_index);
      if (!within(velocity_ratio, 1e-12, 1000000000000.0)) refuse("closed_loop_poles", "velocity_ratio", "a number at least 1e-12 and at most 1e12, in float32 at least 1e-6 and at most 1e6", velocity_ratio);
      const t2 = tracking_index * tracking_index;
      const t3 = velocity_ratio * velocity_ratio;
      const t5 = t2 + 16.0;
      const t6 = t5 * t3;
      const t8 = t2 * 4.0;
      const t9 = t6 + t8;
      const eta_scaled = Math.sqrt(t9);
      const t11 = tracking_index * velocity_ratio;
      const t12 = t11 + eta_scaled;
      const t14 = t12 * 0.5;
      const t15 = t11 * t14;
      const t16 = t2 + t15;
      const delta_scaled = Math.sqrt(t16);
      const t18 = t14 + delta_scaled;
      const sigma_scaled = t18 * 0.5;
      const t20 = velocity_ratio / t12;
      const t21 = t20 * velocity_ratio;
      const t22 = 4.0 / sigma_scaled;
      const t23 = t21 * t22;
      const t24 = tracking_index / t12;
      const t25 = tracking_index / sigma_scaled;
      const t26 = t24 * t25;
      const t29 = delta_scaled * sigma_scaled;
      const t30 = t29 * 2.0;
      const t31 = tracking_index / t30;
      const t32 = tracking_index * t31;
      const t33 = velocity_ratio * t31;
      const t34 = velocity_ratio * 2.0;
      const t35 = t33 * t34;
      const t36 = t32 * t32;
      const t37 = t35 * t35;
      const t27 = t23 + t26;
      const t28 = velocity_ratio / sigma_scaled;
      const quarter_discriminant_difference = t36 - t37;
      return { half_sum: t27, modulus: t28, quarter_discriminant: quarter_discriminant_difference };
    },
    // Predicted covariance in units of sigma_o^2 and T.
    predicted_covariance(tracking_index, velocity_ratio) {
      if (!within(tracking_index, 1e-12, 1000000000000.0)) refuse("predicted_covariance", "tracking_index", "a number at least 1e-12 and at most 1e12, in float32 at least 1e-8 and at most 4e6", tracking_index);
      if (!within(velocity_ratio, 1e-12, 1000000000000.0)) refuse("predicted_covariance", "velocity_ratio", "a number at least 1e-12 and at most 1e12, in float32 at least 1e-6 and at most 1e8", velocity_ratio);
      const t2 = tracking_index * tracking_index;
      const t3 = velocity_ratio * velocity_ratio;
      const t5 = t2 + 16.0;
      const t6 = t5 * t3;
      const t8 = t2 * 4.0;
      const t9 = t6 + t8;
      const eta_scaled = Math.sqrt(t9);
      const t11 = tracking_index * velocity_ratio;
      const t12 = t11 + eta_scaled;
      const t14 = t12 * 0.5;
      const t15 = t11 * t14;
      const t16 = t2 + t15;
      const delta_scaled = Math.sqrt(t16);
      const t18 = t14 + delta_scaled;
      const sigma_scaled = t18 * 0.5;
      const t20 = tracking_index * sigma_scaled;
      const t21 = t20 / velocity_ratio;
      const coupling_scaled = t21 / velocity_ratio;
      const t23 = coupling_scaled + velocity_ratio;
      const cross_share = tracking_index / t23;
      const t25 = velocity_ratio * coupling_scaled;
      const rest_scaled = cross_share * t25;
      const t27 = cross_share / sigma_scaled;
      const t28 = t27 * t3;
      const t29 = t28 * 2.0;
      const t30 = delta_scaled * cross_share;
      const t31 = t29 + t30;
      const t32 = sigma_scaled * t31;
      const t33 = rest_scaled + t32;
      const t34 = t33 / delta_scaled;
      const t35 = cross_share * sigma_scaled;
      const t36 = t30 + t2;
      return { predicted_11: t34, predicted_12: t35, predicted_22: t36 };
    },
    // Updated covariance in units of sigma_o^2 and T.
    updated_covariance(tracking_index, velocity_ratio) {
      if (!within(tracking_index, 1e-12, 1000000000000.0)) refuse("updated_covariance", "tracking_index", "a number at least 1e-12 and at most 1e12, in float32 at least 1e-8 and at most 4e6", tracking_index);
      if (!within(velocity_ratio, 1e-12, 1000000000000.0)) refuse("updated_covariance", "velocity_ratio", "a number at least 1e-12 and at most 1e12, in float32 at least 1e-6 and at most 1e8", velocity_ratio);
      const t2 = tracking_index * tracking_index;
      const t3 = velocity_ratio * velocity_ratio;
      const t5 = t2 + 16.0;
      const t6 = t5 * t3;
      const t8 = t2 * 4.0;
      const t9 = t6 + t8;
      const eta_scaled = Math.sqrt(t9);
      const t11 = tracking_index * velocity_ratio;
      const t12 = t11 + eta_scaled;
      const t14 = t12 * 0.5;
      const t15 = t11 * t14;
      const t16 = t2 + t15;
      const delta_scaled = Math.sqrt(t16);
      const t18 = t14 + delta_scaled;
      const sigma_scaled = t18 * 0.5;
      const t20 = tracking_index * sigma_scaled;
      const t21 = t20 / velocity_ratio;
      const coupling_scaled = t21 / velocity_ratio;
      const t23 = coupling_scaled + velocity_ratio;
      const cross_share = tracking_index / t23;
      const t25 = velocity_ratio * coupling_scaled;
      const rest_scaled = cross_share * t25;
      const t27 = cross_share / sigma_scaled;
      const t28 = t27 * t3;
      const t29 = t28 * 2.0;
      const t30 = delta_scaled * cross_share;
      const t31 = t29 + t30;
      const t32 = t31 / sigma_scaled;
      const t33 = t3 * t32;
      const t34 = rest_scaled + t33;
      const t35 = t34 / delta_scaled;
      return { updated_11: t35, updated_12: t28, updated_22: t30 };
    },
  };
})();
