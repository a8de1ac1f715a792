// Made by: gainproof generate random-velocity
// From: gainproof derive random-velocity, SymPy 1.14.0
// Random velocity (velocity random walk): steady state with measured position.
(function () {
  "use strict";
  const { within, refuse, nearCubeRoot } = gainproof.runtime;
  gainproof.kernels["random-velocity"] = {
    // Steady-state filter gain.
    gains(tracking_index) {
      if (!within(tracking_index, 5e-324, 1.7976931348623157e308)) refuse("gains", "tracking_index", "a number above 0 and finite", tracking_index);
      const t2 = tracking_index * 1.8014398509481984e16;
      const index_or_switch = tracking_index < 0.75 ? t2 : 1.3510798882111488e16;
      const t7 = 5.404319552844595e16 / tracking_index;
      const four_or_less = tracking_index < 0.75 ? 7.205759403792794e16 : t7;
      const t10 = four_or_less * four_or_less;
      const t11 = index_or_switch * index_or_switch;
      const t12 = t10 + t11;
      const eta_scaled = Math.sqrt(t12);
      const t15 = eta_scaled * 2.0;
      const t16 = index_or_switch * 2.0;
      const t17 = t15 + t16;
      const t18 = index_or_switch * t17;
      const ratio_scaled = Math.sqrt(t18);
      const t21 = index_or_switch * 6.0;
      const t23 = index_or_switch * 1.152921504606847e18;
      const t25 = ratio_scaled * 4.0;
      const t26 = t25 + t21;
      const t27 = t15 + t26;
      const t28 = t23 / t27;
      const alpha_raised = Math.sqrt(t28);
      const t32 = index_or_switch * 4.0;
      const t33 = index_or_switch + ratio_scaled;
      const t34 = eta_scaled + t33;
      const t31 = alpha_raised * 3.725290298461914e-09;
      const t35 = t32 / t34;
      return { alpha: t31, beta: t35 };
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
      const t12 = t10 + t11;
      const eta_scaled = Math.sqrt(t12);
      const t15 = eta_scaled * 2.0;
      const t16 = index_or_switch * 2.0;
      const t17 = t15 + t16;
      const t18 = index_or_switch * t17;
      const ratio_scaled = Math.sqrt(t18);
      const t21 = index_or_switch * 1.152921504606847e18;
      const t22 = t21 / t17;
      const position_raised = Math.sqrt(t22);
      const t27 = index_or_switch * 4.0;
      const t28 = index_or_switch + ratio_scaled;
      const t29 = eta_scaled + t28;
      const t25 = position_raised * 3.725290298461914e-09;
      const t30 = t27 / t29;
      return { position: t25, velocity: t30 };
    },
    // Poles of the filter: a complex pair or two real numbers.
    closed_loop_poles(tracking_index) {
      if (!within(tracking_index, 5e-324, 1.7976931348623157e308)) refuse("closed_loop_poles", "tracking_index", "a number above 0 and finite", tracking_index);
      const p = Math.sqrt(tracking_index);
      const t3 = 1.9721522630525295e-31 / tracking_index;
      const t5 = tracking_index * 1.232595164407831e-32;
      const t6 = t3 + t5;
      const h_scaled = Math.sqrt(t6);
      const kappa = h_scaled / p;
      const t10 = kappa + 1.1102230246251565e-16;
      const rho_scaled = Math.sqrt(t10);
      const rho = rho_scaled * 1.4901161193847656e-08;
      const t14 = rho + 1.1102230246251565e-16;
      const t15 = kappa + t14;
      const t16 = tracking_index * t15;
      const t18 = 4.440892098500626e-16 / t16;
      const t19 = tracking_index * t10;
      const t21 = t19 * 2251799813685248.0;
      const t23 = t18 / rho;
      const t25 = t23 * 2.220446049250313e-16;
      const t22 = t18 / t21;
      const t26 = -t25;
      return { first_real: t22, first_imaginary: t25, second_real: t22, second_imaginary: t26 };
    },
    // Predicted covariance in units of sigma_v^2 and T.
    predicted_covariance(tracking_index) {
      if (!within(tracking_index, 5e-324, 1.7976931348623157e308)) refuse("predicted_covariance", "tracking_index", "a number above 0 and finite", tracking_index);
      const p = Math.sqrt(tracking_index);
      const t3 = 1.9721522630525295e-31 / tracking_index;
      const t5 = tracking_index * 1.232595164407831e-32;
      const t6 = t3 + t5;
      const h_scaled = Math.sqrt(t6);
      const kappa = h_scaled / p;
      const t10 = kappa + 1.1102230246251565e-16;
      const rho_scaled = Math.sqrt(t10);
      const rho = rho_scaled * 1.4901161193847656e-08;
      const t14 = rho + 1.1102230246251565e-16;
      const t15 = kappa + t14;
      const t16 = tracking_index * t15;
      const t18 = t16 * 2251799813685248.0;
      const t19 = tracking_index * rho;
      const t21 = t19 * 4503599627370496.0;
      const t24 = tracking_index * t21;
      const t25 = tracking_index * tracking_index;
      const t22 = t18 * t21;
      const t23 = tracking_index * t18;
      const t26 = t24 + t25;
      return { predicted_11: t22, predicted_12: t23, predicted_22: t26 };
    },
    // Updated covariance in units of sigma_v^2 and T.
    updated_covariance(tracking_index) {
      if (!within(tracking_index, 5e-324, 1.7976931348623157e308)) refuse("updated_covariance", "tracking_index", "a number above 0 and finite", tracking_index);
      const p = Math.sqrt(tracking_index);
      const t3 = 1.9721522630525295e-31 / tracking_index;
      const t5 = tracking_index * 1.232595164407831e-32;
      const t6 = t3 + t5;
      const h_scaled = Math.sqrt(t6);
      const kappa = h_scaled / p;
      const t10 = kappa + 1.1102230246251565e-16;
      const rho_scaled = Math.sqrt(t10);
      const rho = rho_scaled * 1.4901161193847656e-08;
      const t14 = rho + 1.1102230246251565e-16;
      const t15 = kappa + t14;
      const t17 = 2.0 / t15;
      const t21 = tracking_index * rho;
      const t23 = t21 * 4503599627370496.0;
      const t18 = t17 * rho;
      const t20 = t17 * 2.220446049250313e-16;
      const t24 = tracking_index * t23;
      return { updated_11: t18, updated_12: t20, updated_22: t24 };
    },
  };
})();
