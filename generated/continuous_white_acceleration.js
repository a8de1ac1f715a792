// Made by: gainproof generate continuous-white-acceleration
// From: gainproof derive continuous-white-acceleration, SymPy 1.14.0
// Continuous white acceleration: steady state with measured position.
(function () {
  "use strict";
  const { within, refuse, nearCubeRoot } = gainproof.runtime;
  gainproof.kernels["continuous-white-acceleration"] = {
    // Steady-state filter gain.
    gains(tracking_index) {
      if (!within(tracking_index, 5e-324, 1.7976931348623157e308)) refuse("gains", "tracking_index", "a number above 0 and finite", tracking_index);
      const t2 = tracking_index * 1.8014398509481984e16;
      const index_or_switch = tracking_index < 0.75 ? t2 : 1.3510798882111488e16;
      const t7 = 5.404319552844595e16 / tracking_index;
      const four_or_less = tracking_index < 0.75 ? 7.205759403792794e16 : t7;
      const t10 = four_or_less * four_or_less;
      const t11 = index_or_switch * index_or_switch;
      const t13 = t11 / 3.0;
      const t14 = t10 + t13;
      const eta_scaled = Math.sqrt(t14);
      const t17 = eta_scaled * 2.0;
      const t19 = index_or_switch * 1.3333333333333333;
      const t20 = t17 + t19;
      const t21 = index_or_switch * t20;
      const ratio_scaled = Math.sqrt(t21);
      const t24 = index_or_switch * 6.666666666666667;
      const t26 = index_or_switch / 6.0;
      const t27 = t26 / ratio_scaled;
      const t29 = index_or_switch * 16.0;
      const t31 = t27 + 1.0;
      const t32 = t27 * t31;
      const t33 = t29 * t32;
      const t34 = t24 + t33;
      const t36 = index_or_switch * 1.152921504606847e18;
      const t38 = ratio_scaled * 4.0;
      const t39 = t38 + t34;
      const t40 = t17 + t39;
      const t41 = t36 / t40;
      const alpha_raised = Math.sqrt(t41);
      const t45 = index_or_switch * 4.0;
      const t46 = index_or_switch + ratio_scaled;
      const t47 = eta_scaled + t46;
      const t44 = alpha_raised * 3.725290298461914e-09;
      const t48 = t45 / t47;
      return { alpha: t44, beta: t48 };
    },
    // Steady-state predictor gain F K.
    predictor_gains(tracking_index) {
      if (!within(tracking_index, 5e-324, 1.7976931348623157e308)) refuse("predictor_gains", "tracking_index", "a number above 0 and finite", tracking_index);
      const t2 = tracking_index * 1.8014398509481984e16;
      const index_or_switch = tracking_index < 0.75 ? t2 : 1.3510798882111488e16;
      const t7 = 5.404319552844595e16 / tracking_index;
      const four_or_less = tracking_index < 0.75 ? 7.205759403792794e16 : t7;
      const t10 = four_or_less * four_or_less;
      const t11 = index_or_switch * index_or_switch;
      const t13 = t11 / 3.0;
      const t14 = t10 + t13;
      const eta_scaled = Math.sqrt(t14);
      const t17 = eta_scaled * 2.0;
      const t19 = index_or_switch * 1.3333333333333333;
      const t20 = t17 + t19;
      const t21 = index_or_switch * t20;
      const ratio_scaled = Math.sqrt(t21);
      const t24 = index_or_switch * 6.666666666666667;
      const t26 = index_or_switch / 6.0;
      const t27 = t26 / ratio_scaled;
      const t29 = index_or_switch * 16.0;
      const t31 = t27 + 1.0;
      const t32 = t27 * t31;
      const t33 = t29 * t32;
      const t34 = t24 + t33;
      const t36 = index_or_switch * 1.152921504606847e18;
      const t38 = ratio_scaled * 4.0;
      const t39 = t38 + t34;
      const t40 = t17 + t39;
      const t41 = t36 / t40;
      const alpha_raised = Math.sqrt(t41);
      const t44 = alpha_raised * 3.725290298461914e-09;
      const t45 = index_or_switch * 4.0;
      const t46 = index_or_switch + ratio_scaled;
      const t47 = eta_scaled + t46;
      const t48 = t45 / t47;
      const t49 = t44 + t48;
      return { position: t49, velocity: t48 };
    },
    // Poles of the filter: a complex pair or two real numbers.
    closed_loop_poles(tracking_index) {
      if (!within(tracking_index, 5e-324, 1.7976931348623157e308)) refuse("closed_loop_poles", "tracking_index", "a number above 0 and finite", tracking_index);
      const p = Math.sqrt(tracking_index);
      const t3 = 1.9721522630525295e-31 / tracking_index;
      const t5 = tracking_index * 4.108650548026103e-33;
      const t6 = t3 + t5;
      const h_scaled = Math.sqrt(t6);
      const kappa = h_scaled / p;
      const t10 = kappa + 7.401486830834377e-17;
      const rho_scaled = Math.sqrt(t10);
      const rho = rho_scaled * 1.4901161193847656e-08;
      const t17 = tracking_index * 0.25;
      const t18 = 3.0 - t17;
      const distance = Math.abs(t18);
      const below = Math.sqrt(distance);
      const t21 = 3.0 + t17;
      const above = Math.sqrt(t21);
      const t25 = tracking_index * 0.5;
      const t26 = (2.449489742783178 - t25) + (2.168616518103246e-16);
      const t28 = kappa + 1.1102230246251565e-16;
      const t29 = tracking_index * t28;
      const t30 = t26 / t29;
      const t31 = 2.449489742783178 + t25;
      const t32 = rho + 1.1102230246251565e-16;
      const t33 = kappa + t32;
      const t34 = tracking_index * t33;
      const t36 = 4.440892098500626e-16 / t34;
      const t37 = t31 * t36;
      const t38 = t30 * t37;
      const t39 = t38 * 7.401486830834377e-17;
      const t40 = below / rho;
      const t41 = above * t36;
      const t42 = t40 * t41;
      const t43 = t42 * 7.401486830834377e-17;
      const middle_size = Math.abs(t39);
      const t45 = middle_size + t43;
      const t46 = t36 / t45;
      const t47 = t46 * t36;
      const t49 = -t45;
      const t51 = -t47;
      const t54 = -t43;
      const choice_1 = tracking_index < 12.0 ? t39 : t49;
      const choice_2 = tracking_index < 12.0 ? t39 : t51;
      const choice_3 = tracking_index < 12.0 ? t43 : 0.0;
      const choice_4 = tracking_index < 12.0 ? t54 : 0.0;
      return { first_real: choice_1, first_imaginary: choice_3, second_real: choice_2, second_imaginary: choice_4 };
    },
    // Predicted covariance in units of sigma_v^2 and T.
    predicted_covariance(tracking_index) {
      if (!within(tracking_index, 5e-324, 1.7976931348623157e308)) refuse("predicted_covariance", "tracking_index", "a number above 0 and finite", tracking_index);
      const p = Math.sqrt(tracking_index);
      const t3 = 1.9721522630525295e-31 / tracking_index;
      const t5 = tracking_index * 4.108650548026103e-33;
      const t6 = t3 + t5;
      const h_scaled = Math.sqrt(t6);
      const kappa = h_scaled / p;
      const t10 = kappa + 7.401486830834377e-17;
      const rho_scaled = Math.sqrt(t10);
      const rho = rho_scaled * 1.4901161193847656e-08;
      const t15 = rho + 1.1102230246251565e-16;
      const t16 = kappa + t15;
      const t17 = tracking_index * t16;
      const t19 = t17 * 2251799813685248.0;
      const t20 = tracking_index * rho;
      const t22 = t20 * 4503599627370496.0;
      const t26 = kappa + 1.850371707708594e-17;
      const t27 = t26 / t15;
      const t28 = tracking_index * t27;
      const t29 = tracking_index * t28;
      const t30 = tracking_index * tracking_index;
      const t23 = t19 * t22;
      const t24 = tracking_index * t19;
      const t31 = t29 + t30;
      return { predicted_11: t23, predicted_12: t24, predicted_22: t31 };
    },
    // Updated covariance in units of sigma_v^2 and T.
    updated_covariance(tracking_index) {
      if (!within(tracking_index, 5e-324, 1.7976931348623157e308)) refuse("updated_covariance", "tracking_index", "a number above 0 and finite", tracking_index);
      const p = Math.sqrt(tracking_index);
      const t3 = 1.9721522630525295e-31 / tracking_index;
      const t5 = tracking_index * 4.108650548026103e-33;
      const t6 = t3 + t5;
      const h_scaled = Math.sqrt(t6);
      const kappa = h_scaled / p;
      const t10 = kappa + 7.401486830834377e-17;
      const rho_scaled = Math.sqrt(t10);
      const rho = rho_scaled * 1.4901161193847656e-08;
      const t15 = rho + 1.1102230246251565e-16;
      const t16 = kappa + t15;
      const t18 = 2.0 / t16;
      const t23 = kappa + 1.850371707708594e-17;
      const t24 = t23 / t15;
      const t25 = tracking_index * t24;
      const t19 = t18 * rho;
      const t21 = t18 * 2.220446049250313e-16;
      const t26 = tracking_index * t25;
      return { updated_11: t19, updated_12: t21, updated_22: t26 };
    },
  };
})();
