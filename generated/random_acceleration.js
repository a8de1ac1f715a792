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
      const alpha_raised = Math.sqrt(t20);
      const t24 = t2 * 2.0;
      const t25 = t7 + 5.551115123125783e-17;
      const t26 = t24 + t25;
      const t23 = alpha_raised * 3.725290298461914e-09;
      const t28 = 2.220446049250313e-16 / t26;
      return { alpha: t23, beta: t28 };
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
      const alpha_raised = Math.sqrt(t20);
      const t23 = alpha_raised * 3.725290298461914e-09;
      const t24 = t2 * 2.0;
      const t25 = t7 + 5.551115123125783e-17;
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
      const t11 = tracking_index * 0.25;
      const t12 = 2.0 - t11;
      const distance = Math.abs(t12);
      const below = Math.sqrt(distance);
      const t15 = 2.0 + t11;
      const above = Math.sqrt(t15);
      const t17 = tracking_index * 0.5;
      const t18 = 2.0 - t17;
      const t20 = kappa + 2.7755575615628914e-17;
      const t21 = tracking_index * t20;
      const t22 = t18 / t21;
      const t23 = 2.0 + t17;
      const t24 = rho + 2.7755575615628914e-17;
      const t25 = kappa + t24;
      const t26 = tracking_index * t25;
      const t27 = 1.1102230246251565e-16 / t26;
      const t28 = t23 * t27;
      const t29 = t22 * t28;
      const t30 = t29 * 2.7755575615628914e-17;
      const t31 = below / rho;
      const t32 = above * t27;
      const t33 = t31 * t32;
      const t34 = t33 * 2.7755575615628914e-17;
      const middle_size = Math.abs(t30);
      const t36 = middle_size + t34;
      const t37 = t27 / t36;
      const t38 = t37 * t27;
      const t40 = -t36;
      const t42 = -t38;
      const t45 = -t34;
      const choice_1 = tracking_index < 8.0 ? t30 : t40;
      const choice_2 = tracking_index < 8.0 ? t30 : t42;
      const choice_3 = tracking_index < 8.0 ? t34 : 0.0;
      const choice_4 = tracking_index < 8.0 ? t45 : 0.0;
      return { first_real: choice_1, first_imaginary: choice_3, second_real: choice_2, second_imaginary: choice_4 };
    },
    // Predicted covariance in units of sigma_v^2 and T.
    predicted_covariance(tracking_index) {
      if (!within(tracking_index, 5e-324, 1.7976931348623157e308)) refuse("predicted_covariance", "tracking_index", "a number above 0 and finite", tracking_index);
      const kappa = 1.1102230246251565e-16 / tracking_index;
      const t4 = kappa + 1.3877787807814457e-17;
      const rho_scaled = Math.sqrt(t4);
      const rho = rho_scaled * 7.450580596923828e-09;
      const t9 = rho + 2.7755575615628914e-17;
      const t10 = kappa + t9;
      const t11 = tracking_index * t10;
      const t13 = t11 * 9007199254740992.0;
      const t14 = tracking_index * rho;
      const t16 = t14 * 1.8014398509481984e16;
      const t19 = 1.1102230246251565e-16 / t9;
      const t20 = tracking_index * t19;
      const t21 = tracking_index * tracking_index;
      const t17 = t13 * t16;
      const t18 = tracking_index * t13;
      const t22 = t20 + t21;
      return { predicted_11: t17, predicted_12: t18, predicted_22: t22 };
    },
    // Updated covariance in units of sigma_v^2 and T.
    updated_covariance(tracking_index) {
      if (!within(tracking_index, 5e-324, 1.7976931348623157e308)) refuse("updated_covariance", "tracking_index", "a number above 0 and finite", tracking_index);
      const kappa = 1.1102230246251565e-16 / tracking_index;
      const t4 = kappa + 1.3877787807814457e-17;
      const rho_scaled = Math.sqrt(t4);
      const rho = rho_scaled * 7.450580596923828e-09;
      const t10 = rho + 2.7755575615628914e-17;
      const t11 = kappa + t10;
      const t12 = 2.0 / t11;
      const t16 = 1.1102230246251565e-16 / t10;
      const t13 = t12 * rho;
      const t15 = t12 * 5.551115123125783e-17;
      const t17 = tracking_index * t16;
      return { updated_11: t13, updated_12: t15, updated_22: t17 };
    },
  };
})();
