// Plots as plain SVG: axes with ticks, curves, areas, points. Colours come from the style sheet.
(function (root) {
  "use strict";
  const { play } = root.gainproof;
  const SPACE = "http://www.w3.org/2000/svg";
  const [WIDTH, HEIGHT] = [310, 225];
  const FRAME = { left: 46, right: 18, top: 10, bottom: 40 };

  function element(name, attributes, text) {
    const made = document.createElementNS(SPACE, name);
    for (const [key, value] of Object.entries(attributes)) made.setAttribute(key, value);
    if (text !== undefined) made.textContent = text;
    return made;
  }

  const short = (x) => String(Number(x.toPrecision(6)));

  // Places of a line's ticks with their texts: whole powers of ten, or steps of 1, 2 or 5.
  function ticks({ least, most, logarithmic }) {
    if (logarithmic) {
      const [first, last] = [Math.ceil(Math.log10(least) - 1e-9), Math.floor(Math.log10(most) + 1e-9)];
      const stride = Math.max(1, Math.ceil((last - first) / 5));
      const powers = Array.from({ length: Math.max(last - first + 1, 0) }, (_, k) => first + k);
      return powers.filter((k) => (k - first) % stride === 0).map((k) => [10 ** k, Math.abs(k) < 4 ? short(10 ** k) : `1e${k}`]);
    }
    const rough = (most - least) / 4;
    const power = 10 ** Math.floor(Math.log10(rough));
    const step = [1, 2, 5, 10].map((k) => k * power).find((k) => k >= rough * 0.999);
    const [first, last] = [Math.ceil(least / step - 1e-9), Math.floor(most / step + 1e-9)];
    return Array.from({ length: last - first + 1 }, (_, k) => {
      const value = (first + k) * step;
      return [value, short(value)];
    });
  }

  // From a value on an axis to its place in the drawing, held a little beyond the frame.
  function scale({ least, most, logarithmic }, from, to) {
    const f = logarithmic ? Math.log10 : (x) => x;
    const [a, b] = [f(least), f(most)];
    const room = Math.abs(to - from) * 4;
    return (x) => {
      const place = from + ((f(x) - a) / (b - a)) * (to - from);
      const held = Math.min(Math.max(place, Math.min(from, to) - room), Math.max(from, to) + room);
      return Number(held.toFixed(2));
    };
  }

  // A square plot where both axes have the same unit, else the whole frame.
  function frame(square) {
    const box = { left: FRAME.left, right: WIDTH - FRAME.right, top: FRAME.top };
    box.bottom = HEIGHT - FRAME.bottom;
    if (square) {
      const spare = box.right - box.left - (box.bottom - box.top);
      box.left += spare / 2;
      box.right -= spare / 2;
    }
    return box;
  }

  function axes(svg, plot, box, at) {
    const [x, y] = at;
    for (const [value, text] of ticks(plot.x)) {
      const place = x(value);
      svg.append(element("line", { class: "grid", x1: place, x2: place, y1: box.top, y2: box.bottom }));
      const label = { class: "tick", x: place, y: box.bottom + 15, "text-anchor": "middle" };
      svg.append(element("text", label, text));
    }
    for (const [value, text] of ticks(plot.y)) {
      const place = y(value);
      svg.append(element("line", { class: "grid", x1: box.left, x2: box.right, y1: place, y2: place }));
      const label = { class: "tick", x: box.left - 5, y: place + 4, "text-anchor": "end" };
      svg.append(element("text", label, text));
    }
    const middle = (box.left + box.right) / 2;
    const below = { class: "name", x: middle, y: HEIGHT - 6, "text-anchor": "middle" };
    svg.append(element("text", below, plot.x.name));
    const height = (box.top + box.bottom) / 2;
    const turned = { class: "name", "text-anchor": "middle" };
    turned.transform = `translate(${box.left - 36} ${height}) rotate(-90)`;
    svg.append(element("text", turned, plot.y.name));
  }

  // `plot`: axes x and y as {least, most, logarithmic, name}, `areas` and `curves` as {points, look},
  // `crosses` and `points` as {at, look}; looks are classes of the style sheet.
  let clips = 0;
  function draw(svg, plot) {
    const box = frame(plot.square);
    const x = scale(plot.x, box.left, box.right);
    const y = scale(plot.y, box.bottom, box.top);
    svg.setAttribute("viewBox", `0 0 ${WIDTH} ${HEIGHT}`);
    svg.replaceChildren();
    axes(svg, plot, box, [x, y]);
    const inside = svg.dataset.clip || (svg.dataset.clip = `play-clip-${(clips += 1)}`);
    const size = { x: box.left, y: box.top, width: box.right - box.left, height: box.bottom - box.top };
    const clip = element("clipPath", { id: inside });
    clip.append(element("rect", size));
    const held = element("g", { "clip-path": `url(#${inside})` });
    svg.append(clip, held, element("rect", { class: "frame", ...size }));
    const path = (points) =>
      points.map(([a, b], k) => `${k ? "L" : "M"}${x(a)} ${y(b)}`).join("");
    for (const { points, look } of plot.areas || [])
      if (points.length) held.append(element("path", { class: look, d: `${path(points)}Z` }));
    for (const { points, look } of plot.curves || [])
      if (points.length) held.append(element("path", { class: `curve ${look}`, d: path(points) }));
    for (const { points, look } of plot.dots || [])
      for (const [a, b] of points)
        held.append(element("circle", { class: look, cx: x(a), cy: y(b), r: 1.4 }));
    for (const { at, look } of plot.crosses || []) {
      const [a, b] = [x(at[0]), y(at[1])];
      const d = `M${a - 5} ${b - 5}L${a + 5} ${b + 5}M${a - 5} ${b + 5}L${a + 5} ${b - 5}`;
      svg.append(element("path", { class: `cross ${look}`, d }));
    }
    for (const { at, look } of plot.points || [])
      held.append(element("circle", { class: `point ${look}`, cx: x(at[0]), cy: y(at[1]), r: 5 }));
  }

  play.drawing = { draw, short };
})(globalThis);
