// Made by: gainproof generate random-acceleration
// From: gainproof derive random-acceleration, SymPy 1.14.0
// Random acceleration (constant over each interval): steady state with measured position.
(function () {
  "use strict";
  const { within, refuse, nearCubeRoot } = gainproof.runtime;
  gainproof.kernels["random-acceleration"] = {
    // Steady-state filter gain.
    gains(tracking_index) {
      if (!within(tracking_index, 5e-324, 1.7976931348623157e308)) refuse("gains", "tracking_index", "a number above 0 and finite", tracking_index);
      const t2 = 1.1102230246251565e-16 / tracking_index;
      const t4 = t2 + 1.3877787807814457e-17;
      const rho_scaled = Math.sqrt(t4);
      const t7 = rho_scaled * 1.4901161193847656e-08;
      const t9 = 2.7755575615628914e-17 / t7;
      const t11 = t9 + 2.0;
      const t12 = t9 * t11;
      const t14 = t12 + 1.5;
      const t16 = t14 * 5.551115123125783e-17;
      const t17 = t7 + t16;
      const t18 = t4 + t17;
      const t20 = 16.0 / t18;
      const t21 = t2 * 2.0;
      const t22 = t7 + 5.551115123125783e-17;
      const t23 = t21 + t22;
      const alpha_raised = Math.sqrt(t20);
      const t25 = 2.220446049250313e-16 / t23;
      const t28 = alpha_raised * 3.725290298461914e-09;
      return { alpha: t28, beta: t25 };
    },
    // Steady-state predictor gain F K.
    predictor_gains(tracking_index) {
      if (!within(tracking_index, 5e-324, 1.7976931348623157e308)) refuse("predictor_gains", "tracking_index", "a number above 0 and finite", tracking_index);
      const t2 = 1.1102230246251565e-16 / tracking_index;
      const t4 = t2 + 1.3877787807814457e-17;
      const rho_scaled = Math.sqrt(t4);
      const t7 = rho_scaled * 1.4901161193847656e-08;
      const t9 = 2.7755575615628914e-17 / t7;
      const t11 = t9 + 2.0;
      const t12 = t9 * t11;
      const t14 = t12 + 1.5;
      const t16 = t14 * 5.551115123125783e-17;
      const t17 = t7 + t16;
      const t18 = t4 + t17;
      const t20 = 16.0 / t18;
      const t21 = t2 * 2.0;
      const t22 = t7 + 5.551115123125783e-17;
      const t23 = t21 + t22;
      const t25 = 2.220446049250313e-16 / t23;
      const alpha_raised = Math.sqrt(t20);
      const t28 = alpha_raised * 3.725290298461914e-09;
      const t29 = t28 + t25;
      return { position: t29, velocity: t25 };
    },
    // Poles of the filter: a complex pair or two real numbers.
    closed_loop_poles(tracking_index) {
      if (!within(tracking_index, 5e-324, 1.7976931348623157e308)) refuse("closed_loop_poles", "tracking_index", "a number above 0 and finite", tracking_index);
      const kappa = 1.1102230246251565e-16 / tracking_index;
      const t4 = kappa + 1.3877787807814457e-17;
      const rho_scaled = Math.sqrt(t4);
      const rho = rho_scaled * 7.450580596923828e-09;
      const twice_rho = rho_scaled * 1.4901161193847656e-08;
      const t13 = tracking_index * 0.25;
      const t14 = 2.0 - t13;
      const distance = Math.abs(t14);
      const below = Math.sqrt(distance);
      const t17 = 2.0 + t13;
      const above = Math.sqrt(t17);
      const t19 = tracking_index * 0.5;
      const t20 = 2.0 - t19;
      const t22 = kappa + 2.7755575615628914e-17;
      const t23 = tracking_index * t22;
      const t24 = t20 / t23;
      const t25 = 2.0 + t19;
      const t27 = twice_rho + 5.551115123125783e-17;
      const t28 = t27 * t27;
      const t29 = tracking_index * t28;
      const t31 = 2.465190328815662e-32 / t29;
      const t32 = t25 * t31;
      const t33 = t24 * t32;
      const t34 = t33 * 2.7755575615628914e-17;
      const t35 = below / rho;
      const t36 = above * t31;
      const t37 = t35 * t36;
      const t38 = t37 * 2.7755575615628914e-17;
      const middle_size = Math.abs(t34);
      const t40 = middle_size + t38;
      const t41 = t31 / t40;
      const t42 = t41 * t31;
      const t44 = -t40;
      const t46 = -t42;
      const t49 = -t38;
      const choice_1 = tracking_index < 8.0 ? t34 : t44;
      const choice_2 = tracking_index < 8.0 ? t34 : t46;
      const choice_3 = tracking_index < 8.0 ? t38 : 0.0;
      const choice_4 = tracking_index < 8.0 ? t49 : 0.0;
      return { first_real: choice_1, first_imaginary: choice_3, second_real: choice_2, second_imaginary: choice_4 };
    },
    // Predicted covariance in units of sigma_v^2 and T.
    predicted_covariance(tracking_index) {
      if (!within(tracking_index, 5e-324, 1.7976931348623157e308)) refuse("predicted_covariance", "tracking_index", "a number above 0 and finite", tracking_index);
      const kappa = 1.1102230246251565e-16 / tracking_index;
      const t4 = kappa + 1.3877787807814457e-17;
      const rho_scaled = Math.sqrt(t4);
      const twice_rho = rho_scaled * 1.4901161193847656e-08;
      const t9 = twice_rho + 5.551115123125783e-17;
      const t10 = t9 * t9;
      const t11 = tracking_index * t10;
      const t13 = t11 * 4.056481920730334e31;
      const t14 = tracking_index * twice_rho;
      const t16 = t14 * 9007199254740992.0;
      const t20 = 2.220446049250313e-16 / t9;
      const t21 = tracking_index * t20;
      const t22 = tracking_index * tracking_index;
      const t17 = t13 * t16;
      const t18 = tracking_index * t13;
      const t23 = t21 + t22;
      return { predicted_11: t17, predicted_12: t18, predicted_22: t23 };
    },
    // Updated covariance in units of sigma_v^2 and T.
    updated_covariance(tracking_index) {
      if (!within(tracking_index, 5e-324, 1.7976931348623157e308)) refuse("updated_covariance", "tracking_index", "a number above 0 and finite", tracking_index);
      const kappa = 1.1102230246251565e-16 / tracking_index;
      const t4 = kappa + 1.3877787807814457e-17;
      const rho_scaled = Math.sqrt(t4);
      const twice_rho = rho_scaled * 1.4901161193847656e-08;
      const t9 = twice_rho + 5.551115123125783e-17;
      const t10 = t9 * t9;
      const t12 = 2.220446049250313e-16 / t10;
      const t15 = 2.220446049250313e-16 / t9;
      const t13 = t12 * twice_rho;
      const t14 = t12 * 1.1102230246251565e-16;
      const t16 = tracking_index * t15;
      return { updated_11: t13, updated_12: t14, updated_22: t16 };
    },
  };
})();
