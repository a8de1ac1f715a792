// The pictures of the play, each from what `families` says of the filter at its inputs.
(function (root) {
  "use strict";
  const { play } = root.gainproof;
  const { draw } = play.drawing;
  const { stepResponse, noisyRest, respond } = play.filter;
  const LOOKS = ["first", "second", "third", "fourth"];
  const SAMPLES = 100;
  const SEED = 1;

  // Gains over the index, with a point on each at the index chosen.
  function gains(svg, { found, along, range, index }) {
    const names = Object.keys(found.gains);
    const largest = Math.max(...along.flatMap(({ gains: all }) => Object.values(all)));
    const least = Math.min(0, ...along.flatMap(({ gains: all }) => Object.values(all)));
    draw(svg, {
      x: { least: range[0], most: range[1], logarithmic: true, name: "tracking index Λ" },
      y: { least, most: largest * 1.05, name: "gains" },
      curves: names.map((name, k) => ({
        look: LOOKS[k],
        points: along.map(({ value, gains: all }) => [value, all[name]]),
      })),
      points: names.map((name, k) => ({ look: LOOKS[k], at: [index, found.gains[name]] })),
    });
  }

  function circle() {
    const turns = Array.from({ length: 121 }, (_, k) => (2 * Math.PI * k) / 120);
    return turns.map((turn) => [Math.cos(turn), Math.sin(turn)]);
  }

  function poles(svg, { found, along }) {
    const tracks = along.flatMap(({ poles: all }) => all);
    const reach = found.radius > 1.2 ? 1.1 * found.radius : 1.2;
    draw(svg, {
      square: true,
      x: { least: -reach, most: reach, name: "real part" },
      y: { least: -reach, most: reach, name: "imaginary part" },
      areas: [{ look: found.stable ? "inside" : "outside", points: circle() }],
      dots: [{ look: "trace", points: tracks }],
      crosses: found.poles.map((at) => ({ at, look: found.stable ? "fine" : "wrong" })),
    });
  }

  // As many samples as it takes to settle, of a few lengths, so that the axis does not swim.
  function length(found) {
    const wanted = found.radius < 1 ? 4 / (1 - found.radius) : 20;
    return [20, 50, 100, 200, 500].find((count) => count >= wanted) || 1000;
  }

  function step(svg, { found }) {
    const count = length(found);
    const points = stepResponse(found.matrix, count).map((x, k) => [k + 1, x]);
    draw(svg, {
      x: { least: 0, most: count, name: "samples" },
      y: { least: -0.5, most: 2, name: "position after a jump to 1" },
      curves: [
        { look: "truth", points: [[0, 1], [count, 1]] },
        { look: "first", points: [[0, 0], ...points.filter(([, x]) => Math.abs(x) < 1e6)] },
      ],
    });
  }

  function noise(svg, { found }) {
    const measured = noisyRest(found.deviations, SAMPLES, SEED);
    const points = respond(found.matrix, measured).map((x, k) => [k + 1, x]);
    draw(svg, {
      x: { least: 0, most: SAMPLES + 1, name: "samples" },
      y: { least: -3.5, most: 3.5, name: "position of what rests at 0" },
      dots: [{ look: "measured", points: measured.map(([x], k) => [k + 1, x]) }],
      curves: [
        { look: "truth", points: [[0, 0], [SAMPLES, 0]] },
        { look: "first", points: points.filter(([, x]) => Math.abs(x) < 1e6) },
      ],
    });
  }

  // Stable gains: the triangle of two states; of three states its part above the curve at which
  // gamma is the largest stable one.
  function stableGains({ gamma }) {
    if (gamma === undefined) return [[0, 0], [2, 0], [0, 4]];
    const alphas = Array.from({ length: 201 }, (_, k) => (2 * k) / 200).slice(1);
    const lower = alphas.map((alpha) => [alpha, (gamma * (1 - alpha / 2)) / alpha]);
    const kept = lower.filter(([alpha, beta]) => beta < 4 - 2 * alpha);
    return [...kept, ...kept.map(([alpha]) => [alpha, 4 - 2 * alpha]).reverse()];
  }

  function region(svg, { found, along, kind }) {
    if (kind === "both-measured") {
      const place = ({ poles: [[a, b], [c, d]] }) => [a + c, a * c - b * d];
      draw(svg, {
        x: { least: -2.2, most: 2.2, name: "sum of the poles" },
        y: { least: -1.2, most: 1.2, name: "product of the poles" },
        areas: [{ look: "inside", points: [[-2, 1], [2, 1], [0, -1]] }],
        curves: [{ look: "second", points: along.map(place) }],
        points: [{ look: "first", at: place(found) }],
      });
      return;
    }
    const { alpha, beta } = found.gains;
    draw(svg, {
      x: { least: 0, most: 2.1, name: "α" },
      y: { least: 0, most: 4.2, name: "β" },
      areas: [{ look: "inside", points: stableGains(found.gains) }],
      curves: [{ look: "second", points: along.map(({ gains: g }) => [g.alpha, g.beta]) }],
      points: [{ look: found.stable ? "first" : "wrong", at: [alpha, beta] }],
    });
  }

  const LAGS = [0.13, 1e6];
  function tradeoff(svg, { found, along, kind }) {
    const pairs = along.map(({ lag, variance }) => [lag, variance]);
    const best = play.families.frontier(kind, LAGS, 300) || [];
    const three = kind.startsWith("three");
    const what = three ? "jerk" : "acceleration";
    draw(svg, {
      x: { least: 0.1, most: 1e5, logarithmic: true, name: `lag behind a constant ${what}` },
      y: { least: 0.01, most: 100, logarithmic: true, name: "variance" },
      curves: [
        { look: "third", points: best },
        { look: "second", points: pairs.filter(([, variance]) => variance > 0) },
      ],
      points: found.variance > 0 ? [{ look: "first", at: [found.lag, found.variance] }] : [],
    });
  }

  play.panels = { gains, poles, step, noise, region, tradeoff };
  play.panels.stableGains = stableGains;
})(globalThis);
