// Filters with fixed gains, in units of the sampling interval: recursion, noise, poles, lag and
// variance. Everything here is plain arithmetic beside the printed kernels, and has tests of its own.
(function (root) {
  "use strict";
  const gainproof = root.gainproof || (root.gainproof = {});
  const play = gainproof.play || (gainproof.play = {});

  const sum = (values) => values.reduce((total, value) => total + value, 0);
  const product = (a, b) => a.map((row) => b[0].map((_, j) => sum(row.map((x, k) => x * b[k][j]))));
  const transposed = (a) => a[0].map((_, j) => a.map((row) => row[j]));
  const added = (a, b) => a.map((row, i) => row.map((x, j) => x + b[i][j]));

  // One interval of a polynomial track: F of n states (position, velocity, acceleration).
  function transition(n) {
    const factorials = [1, 1, 2];
    const row = (i) => Array.from({ length: n }, (_, j) => (j < i ? 0 : 1 / factorials[j - i]));
    return Array.from({ length: n }, (_, i) => row(i));
  }

  // `gain`: a row a state, a column for each of the first states that is measured.
  // Positions after each update, from rest at 0; `measurements`: a row a sample.
  function respond(gain, measurements) {
    const shift = transition(gain.length);
    let state = gain.map(() => 0);
    return measurements.map((measured) => {
      const predicted = shift.map((row) => sum(row.map((x, j) => x * state[j])));
      const innovation = measured.map((x, j) => x - predicted[j]);
      state = predicted.map((x, i) => x + sum(innovation.map((r, j) => gain[i][j] * r)));
      return state[0];
    });
  }

  // The position jumps from 0 to 1 before the first sample; velocities are measured as 0.
  function stepResponse(gain, count) {
    const measured = gain[0].map((_, j) => (j === 0 ? 1 : 0));
    return respond(gain, Array.from({ length: count }, () => measured));
  }

  // Normally distributed numbers of variance 1, the same for the same seed (mulberry32, Box-Muller).
  function noise(count, seed) {
    let state = seed >>> 0;
    function uniform() {
      state = (state + 0x6d2b79f5) >>> 0;
      let x = Math.imul(state ^ (state >>> 15), state | 1);
      x ^= x + Math.imul(x ^ (x >>> 7), x | 61);
      return ((x ^ (x >>> 14)) >>> 0) / 4294967296;
    }
    return Array.from({ length: count }, () => {
      const size = Math.sqrt(-2 * Math.log(1 - uniform()));
      return size * Math.cos(2 * Math.PI * uniform());
    });
  }

  // Measurements of what rests at 0: noise of these deviations, a row a sample.
  function noisyRest(deviations, count, seed) {
    const drawn = noise(count * deviations.length, seed);
    const at = (k, j) => deviations[j] * drawn[k * deviations.length + j];
    return Array.from({ length: count }, (_, k) => deviations.map((_, j) => at(k, j)));
  }

  // Both roots of z^2 - 2 h z + h^2 - d as [real, imaginary], the larger modulus first.
  function pair(halfSum, quarterDiscriminant) {
    const root = Math.sqrt(Math.abs(quarterDiscriminant));
    if (quarterDiscriminant < 0) return [[halfSum, root], [halfSum, -root]];
    const larger = halfSum < 0 ? halfSum - root : halfSum + root;
    const smaller = halfSum < 0 ? halfSum + root : halfSum - root;
    return [[larger, 0], [smaller, 0]];
  }

  // The three poles 1 - m + w with w^3 = 3 p w + 2 q and discriminant = p^3 - q^2.
  function triple({ mean_distance, reduced_linear, reduced_constant, discriminant }) {
    const middle = 1 - mean_distance;
    const [p, q] = [reduced_linear, reduced_constant];
    if (discriminant >= 0) {
      const radius = Math.sqrt(Math.max(p, 0));
      const cosine = radius === 0 ? 1 : Math.min(Math.max(q / radius ** 3, -1), 1);
      const angle = Math.acos(cosine) / 3;
      const turns = [0, 1, 2].map((k) => angle + (2 * Math.PI * k) / 3);
      return turns.map((turn) => [middle + 2 * radius * Math.cos(turn), 0]);
    }
    const sign = q < 0 ? -1 : 1;
    const r = Math.cbrt(Math.abs(q) + Math.sqrt(-discriminant));
    const real = sign * (r + p / r);
    const imaginary = (Math.sqrt(3) / 2) * (r - p / r);
    return [[middle + real, 0], [middle - real / 2, imaginary], [middle - real / 2, -imaginary]];
  }

  const modulus = ([real, imaginary]) => Math.hypot(real, imaginary);
  const radius = (poles) => Math.max(...poles.map(modulus));

  // What an error of the updated state becomes in one step, (I - K H) F.
  function closedLoop(gain) {
    const n = gain.length;
    const rest = gain.map((row, i) =>
      Array.from({ length: n }, (_, j) => (i === j ? 1 : 0) - (j < row.length ? row[j] : 0)));
    return { loop: product(rest, transition(n)), rest };
  }

  // Covariance of the predicted state under measurement noise alone, of a stable filter: the sum of
  // A^k K R K' A'^k, each round of which doubles its terms; then one prediction.
  function noiseCovariance(gain, deviations) {
    const shift = transition(gain.length);
    const scaled = gain.map((row) => row.map((x, j) => x * deviations[j]));
    let total = product(scaled, transposed(scaled));
    let power = closedLoop(gain).loop;
    for (let round = 0; round < 64; round++) {
      const more = product(product(power, total), transposed(power));
      total = added(total, more);
      if (more.every((row, i) => row.every((x, j) => Math.abs(x) <= 1e-17 * Math.abs(total[i][j]))))
        break;
      power = product(power, power);
    }
    return { updated: total, predicted: product(product(shift, total), transposed(shift)) };
  }

  // Truth less predicted position behind a constant acceleration 1, two states, both measured:
  // the updated error solves e = A e + (I - K) g, g = (1/2, 1).
  function lagOfTwo(gain) {
    const { loop, rest } = closedLoop(gain);
    const [[a, b], [c, d]] = [[1 - loop[0][0], -loop[0][1]], [-loop[1][0], 1 - loop[1][1]]];
    const [first, second] = rest.map((row) => row[0] / 2 + row[1]);
    const determinant = a * d - b * c;
    const position = (d * first - b * second) / determinant;
    const velocity = (a * second - c * first) / determinant;
    return position + velocity + 0.5;
  }

  play.filter = {
    transition, respond, stepResponse, noise, noisyRest, pair, triple, modulus, radius,
    noiseCovariance, lagOfTwo,
  };
})(globalThis);
