// What each kind of subject shows at its inputs: gains, poles, lag and variance, by printed kernels.
(function (root) {
  "use strict";
  const { kernels, play } = root.gainproof;
  const { noiseCovariance, lagOfTwo, pair, triple, radius } = play.filter;

  // A value, or nothing where a kernel refuses: an input outside its domain.
  function within(compute) {
    try {
      return compute();
    } catch (error) {
      if (error instanceof RangeError) return undefined;
      throw error;
    }
  }

  // Two states: lag and variances of stable gains, in the kernel's domain; `beyond` it by plain
  // formulas, the coordinates 2 alpha/beta and (4 - 2 alpha - beta)/beta among them.
  function fixedTwo(alpha, beta, beyond) {
    const kernel = kernels["alpha-beta"];
    const margin = 4 - 2 * alpha - beta;
    const stable = alpha > 0 && beta > 0 && margin > 0;
    if (!stable) return { stable };
    const variances =
      within(() => kernel.variances(alpha, beta)) ||
      (beyond && within(() => kernel.variances_of_coordinates(2 * (alpha / beta), margin / beta)));
    const lag = within(() => kernel.lags(alpha, beta).predicted_position_lag);
    return { stable, lag: lag || (beyond ? 1 / beta : undefined), ...named(variances) };
  }

  // The largest stable gamma, 2 alpha beta/(2 - alpha), divides into gamma as a share.
  function fixedThree(alpha, beta, gamma, beyond) {
    const kernel = kernels["alpha-beta-gamma"];
    const margin = 4 - 2 * alpha - beta;
    const gap = alpha * beta - gamma * (1 - alpha / 2);
    const stable = alpha > 0 && beta > 0 && margin > 0 && gamma > 0 && gap > 0;
    if (!stable) return { stable };
    const share = (gamma / alpha) * ((1 - alpha / 2) / beta);
    const coordinates = [2 * (beta / gamma), 2 * (margin / gamma), 8 * (gap / gamma / gamma)];
    const variances =
      within(() => kernel.variances(alpha, beta, share)) ||
      (beyond && within(() => kernel.variances_of_coordinates(...coordinates)));
    const lag = within(() => kernel.lags(alpha, beta, share).predicted_position_lag);
    return { stable, lag: lag || (beyond ? 1 / gamma : undefined), ...named(variances) };
  }

  // Gains of any size have poles; what is drawn stays far from overflow.
  function moderate(gains) {
    for (const [name, value] of Object.entries(gains)) {
      if (!(Math.abs(value) <= 100))
        throw new RangeError(`${name} must be a number of magnitude at most 100, got ${value}`);
    }
    return gains;
  }

  const named = (variances) => (variances ? { variance: variances.predicted_11 } : {});

  // A steady state is stable at every index; rounded, its gains may lie on the border.
  const steadily = (found) => ({ ...found, stable: true });

  const KINDS = {
    "two-states": {
      gains: (kernel, { tracking_index }) => kernel.gains(tracking_index),
      matrix: ({ alpha, beta }) => [[alpha], [beta]],
      poles(kernel, { tracking_index }) {
        const z = kernel.closed_loop_poles(tracking_index);
        return [[z.first_real, z.first_imaginary], [z.second_real, z.second_imaginary]];
      },
      fixed: ({ alpha, beta }) => steadily(fixedTwo(alpha, beta, false)),
      more: steady,
    },
    "three-states": {
      gains: (kernel, { tracking_index }) => kernel.gains(tracking_index),
      matrix: ({ alpha, beta, gamma }) => [[alpha], [beta], [gamma]],
      poles(kernel, { tracking_index }) {
        const z = kernel.closed_loop_poles(tracking_index);
        return [[z.real_pole, 0], ...pair(z.half_sum, z.quarter_discriminant)];
      },
      fixed: ({ alpha, beta, gamma }) => steadily(fixedThree(alpha, beta, gamma, false)),
      more: steady,
    },
    "both-measured": {
      gains: (kernel, { tracking_index, velocity_ratio }) =>
        kernel.gains(tracking_index, velocity_ratio),
      matrix: (gains) => [[gains.gain_11, gains.gain_12], [gains.gain_21, gains.gain_22]],
      deviations: ({ velocity_ratio }) => [1, velocity_ratio],
      poles(kernel, { tracking_index, velocity_ratio }) {
        const z = kernel.closed_loop_poles(tracking_index, velocity_ratio);
        return pair(z.half_sum, z.quarter_discriminant);
      },
      fixed(gains, inputs) {
        const gain = this.matrix(gains);
        const covariance = noiseCovariance(gain, this.deviations(inputs));
        return { stable: true, lag: lagOfTwo(gain), variance: covariance.predicted[0][0] };
      },
      more(kernel, { tracking_index, velocity_ratio }) {
        const { predicted_11 } = kernel.predicted_covariance(tracking_index, velocity_ratio);
        const { updated_11 } = kernel.updated_covariance(tracking_index, velocity_ratio);
        return { predicted_11, updated_11 };
      },
    },
    "two-gains": {
      gains: (_, { alpha, beta }) => moderate({ alpha, beta }),
      matrix: ({ alpha, beta }) => [[alpha], [beta]],
      poles(kernel, { alpha, beta }) {
        const z = within(() => kernel.closed_loop_poles(alpha, beta));
        if (z) return pair(z.half_sum, z.quarter_discriminant);
        const half = (alpha + beta) / 2;
        return pair(1 - half, half * half - beta);
      },
      fixed: ({ alpha, beta }) => fixedTwo(alpha, beta, true),
      more: () => ({}),
    },
    "three-gains": {
      gains: (_, { alpha, beta, gamma }) => moderate({ alpha, beta, gamma }),
      matrix: ({ alpha, beta, gamma }) => [[alpha], [beta], [gamma]],
      poles: (kernel, { alpha, beta, gamma }) =>
        triple(kernel.closed_loop_poles(alpha, beta, gamma)),
      fixed: ({ alpha, beta, gamma }) => fixedThree(alpha, beta, gamma, true),
      more: () => ({}),
    },
  };

  function steady(kernel, { tracking_index }) {
    const predictor = Object.entries(kernel.predictor_gains(tracking_index));
    const { predicted_11 } = kernel.predicted_covariance(tracking_index);
    const { updated_11 } = kernel.updated_covariance(tracking_index);
    const gains = predictor.map(([name, value]) => [`predictor_${name}`, value]);
    return { ...Object.fromEntries(gains), predicted_11, updated_11 };
  }

  // All that is shown at these inputs; RangeError where a kernel refuses them.
  function shown(kind, subject, inputs) {
    const { gains, matrix, poles, fixed, more, deviations } = KINDS[kind];
    const kernel = kernels[subject];
    const found = gains(kernel, inputs);
    const z = poles(kernel, inputs);
    return {
      gains: found,
      matrix: matrix(found),
      deviations: deviations ? deviations(inputs) : [1],
      poles: z,
      radius: radius(z),
      ...fixed.call(KINDS[kind], found, inputs),
      more: more(kernel, inputs),
    };
  }

  // The same over a range of one input, by its logarithm; what is refused is left out.
  function sweep(kind, subject, inputs, name, [least, most], count) {
    const step = Math.log(most / least) / count;
    const values = Array.from({ length: count + 1 }, (_, k) => least * Math.exp(k * step));
    return values.flatMap((value) => {
      const found = within(() => shown(kind, subject, { ...inputs, [name]: value }));
      return found ? [{ value, ...found }] : [];
    });
  }

  // Least variance at a lag, [lag, variance] a point; undefined for what has no such curve.
  function frontier(kind, [least, most], count) {
    const subject = { "two-states": "alpha-beta", "two-gains": "alpha-beta",
      "three-states": "alpha-beta-gamma", "three-gains": "alpha-beta-gamma" }[kind];
    if (!subject) return undefined;
    const step = Math.log(most / least) / count;
    const lags = Array.from({ length: count + 1 }, (_, k) => least * Math.exp(k * step));
    return lags.flatMap((lag) => {
      const found = within(() => kernels[subject].minimum_variance_by_lag(lag));
      return found ? [[lag, found.minimum_variance_predicted_11]] : [];
    });
  }

  play.families = { shown, sweep, frontier };
})(globalThis);
