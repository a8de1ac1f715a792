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
      const kappa = 1.1102230246251565e-16 / tracking_index;
      const t4 = kappa + 1.3877787807814457e-17;
      const rho_scaled = Math.sqrt(t4);
      const twice_rho = rho_scaled * 1.4901161193847656e-08;
      const t9 = 2.7755575615628914e-17 / twice_rho;
      const t11 = t9 + 2.0;
      const t12 = t9 * t11;
      const t14 = t12 + 1.5;
      const t16 = t14 * 5.551115123125783e-17;
      const t17 = twice_rho + t16;
      const t18 = t4 + t17;
      const t20 = 16.0 / t18;
      const alpha_raised = Math.sqrt(t20);
      const t24 = kappa * 2.0;
      const t25 = twice_rho + 5.551115123125783e-17;
      const t26 = t24 + t25;
      const t23 = alpha_raised * 3.725290298461914e-09;
      const t28 = 2.220446049250313e-16 / t26;
      return { alpha: t23, beta: t28 };
    },
    // Steady-state predictor gain F K.
    predictor_gains(tracking_index) {
      if (!within(tracking_index, 5e-324, 1.7976931348623157e308)) refuse("predictor_gains", "tracking_index", "a number above 0 and finite", tracking_index);
      const kappa = 1.1102230246251565e-16 / tracking_index;
      const t4 = kappa + 1.3877787807814457e-17;
      const rho_scaled = Math.sqrt(t4);
      const twice_rho = rho_scaled * 1.4901161193847656e-08;
      const t9 = 2.7755575615628914e-17 / twice_rho;
      const t11 = t9 + 2.0;
      const t12 = t9 * t11;
      const t14 = t12 + 1.5;
      const t16 = t14 * 5.551115123125783e-17;
      const t17 = twice_rho + t16;
      const t18 = t4 + t17;
      const t20 = 16.0 / t18;
      const alpha_raised = Math.sqrt(t20);
      const t23 = alpha_raised * 3.725290298461914e-09;
      const t24 = kappa * 2.0;
      const t25 = twice_rho + 5.551115123125783e-17;
      const t26 = t24 + t25;
      const t28 = 2.220446049250313e-16 / t26;
      const t29 = t23 + t28;
      return { position: t29, velocity: t28 };
    },
    // Poles of the filter: a complex pair or two real numbers.
    closed_loop_poles(tracking_index) {
      if (!within(tracking_index, 5e-324, 1.7976931348623157e308)) refuse("closed_loop_poles", "tracking_index", "a number above 0 and finite", tracking_index);
      const kappa = 1.1102230246251565e-16 / tracking_index;
      const t4 = kappa + 1.3877787807814457e-17;
      const rho_scaled = Math.sqrt(t4);
      const rho = rho_scaled * 7.450580596923828e-09;
      const twice_rho = rho_scaled * 1.4901161193847656e-08;
      const t11 = twice_rho + 5.551115123125783e-17;
      const t12 = t11 * t11;
      const t13 = tracking_index * t12;
      const t15 = 2.465190328815662e-32 / t13;
      const t19 = tracking_index * 0.25;
      const t20 = 2.0 - t19;
      const distance = Math.abs(t20);
      const below = Math.sqrt(distance);
      const t23 = 2.0 + t19;
      const above = Math.sqrt(t23);
      const t26 = kappa + 2.7755575615628914e-17;
      const t27 = tracking_index * t26;
      const t28 = tracking_index * 0.5;
      const t29 = 2.0 - t28;
      const t30 = t29 / t27;
      const t31 = 2.0 + t28;
      const t32 = t31 * t15;
      const t33 = t30 * t32;
      const t34 = t33 * 2.7755575615628914e-17;
      const t35 = below / rho;
      const t36 = above * t15;
      const t37 = t35 * t36;
      const t38 = t37 * 2.7755575615628914e-17;
      const middle_size = Math.abs(t34);
      const t40 = middle_size + t38;
      const t41 = t15 / t40;
      const t42 = t41 * t15;
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
      const t11 = 2.220446049250313e-16 / t9;
      const t12 = tracking_index * t11;
      const t13 = t9 * t9;
      const t14 = tracking_index * t13;
      const t16 = t14 * 4.056481920730334e31;
      const t17 = tracking_index * twice_rho;
      const t19 = t17 * 9007199254740992.0;
      const t22 = tracking_index * tracking_index;
      const t20 = t16 * t19;
      const t21 = tracking_index * t16;
      const t23 = t12 + t22;
      return { predicted_11: t20, predicted_12: t21, predicted_22: t23 };
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
