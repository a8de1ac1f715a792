// Sliders and number fields of the play: what is moved is computed and drawn anew.
(function (root) {
  "use strict";
  const { play } = root.gainproof;
  const { short } = play.drawing;
  const WORDS = {
    alpha: "gain α", beta: "gain β", gamma: "gain γ",
    gain_11: "position gain on position", gain_12: "position gain on velocity",
    gain_21: "velocity gain on position", gain_22: "velocity gain on velocity",
    predictor_position: "predictor gain, position", predictor_velocity: "predictor gain, velocity",
    predictor_acceleration: "predictor gain, acceleration",
    predicted_11: "Kalman variance, predicted position",
    updated_11: "Kalman variance, updated position",
    variance: "variance under noise alone, predicted position",
    lag: "lag of the predicted position",
    radius: "largest modulus of a pole",
  };

  // What the table shows, [key, words, value] a row; a pole has two rows.
  function rows(found) {
    const plain = { ...found.gains, ...found.more };
    const kept = Object.entries(plain).map(([key, value]) => [key, WORDS[key], value]);
    const poles = found.poles.flatMap(([real, imaginary], k) => [
      [`pole_${k + 1}_real`, `pole ${k + 1}, real part`, real],
      [`pole_${k + 1}_imaginary`, `pole ${k + 1}, imaginary part`, imaginary],
    ]);
    const last = ["radius", "variance", "lag"].map((key) => [key, WORDS[key], found[key]]);
    return [...kept, ...poles, ...last];
  }

  function without(value, { stable }) {
    if (!stable) return "none: not stable";
    return value === undefined ? "outside the kernel's domain" : "no finite number";
  }

  function fill(table, found) {
    const lines = rows(found).map(([key, words, value]) => {
      const line = document.createElement("tr");
      const head = document.createElement("th");
      head.scope = "row";
      head.textContent = words;
      const cell = document.createElement("td");
      cell.dataset.output = key;
      const known = Number.isFinite(value);
      cell.textContent = known ? short(value) : without(value, found);
      if (known) cell.dataset.value = String(value);
      line.append(head, cell);
      return line;
    });
    table.replaceChildren(...lines);
  }

  // A slider and its number field: the field holds the value, the slider follows as far as it goes.
  function wire(box, changed) {
    const [slider, field] = [box.querySelector("input[type=range]"), box.querySelector("input[type=number]")];
    const logarithmic = box.dataset.scale === "logarithmic";
    function tell() {
      slider.setAttribute("aria-valuetext", field.value);
    }
    slider.addEventListener("input", () => {
      const place = Number(slider.value);
      field.value = String(Number((logarithmic ? 10 ** place : place).toPrecision(4)));
      tell();
      changed();
    });
    field.addEventListener("input", () => {
      const value = field.valueAsNumber;
      if (value > 0) slider.value = String(logarithmic ? Math.log10(value) : value);
      tell();
      changed();
    });
    tell();
    return { name: box.dataset.input, field };
  }

  function start(section) {
    const { kind, subject } = section.dataset;
    const changing = section.querySelector(".play-changing");
    const refusal = section.querySelector(".play-refusal");
    const range = [1e-3, 1e3];
    const swept = section.dataset.swept;
    let waiting = false;
    let swum = { key: "", along: [] };
    const inputs = [...section.querySelectorAll(".play-input")].map((box) => wire(box, soon));

    // Curves through all indices change with the other inputs alone.
    function along(values) {
      if (!swept) return [];
      const key = JSON.stringify({ ...values, [swept]: 0 });
      if (key !== swum.key) swum = { key, along: play.families.sweep(kind, subject, values, swept, range, 240) };
      return swum.along;
    }

    function show() {
      waiting = false;
      const values = Object.fromEntries(inputs.map(({ name, field }) => [name, field.valueAsNumber]));
      let found;
      try {
        found = play.families.shown(kind, subject, values);
        refusal.textContent = "";
      } catch (error) {
        if (!(error instanceof RangeError)) throw error;
        refusal.textContent = `Not shown: ${error.message}`;
      }
      section.classList.toggle("play-refused", !found);
      if (!found) return;
      const drawn = { found, along: along(values), range, index: values[swept], kind };
      for (const svg of section.querySelectorAll("svg[data-panel]")) play.panels[svg.dataset.panel](svg, drawn);
      fill(section.querySelector("tbody"), found);
      const gains = Object.entries(found.gains).map(([key, value]) => `${WORDS[key]} ${short(value)}`);
      changing.textContent = `${gains.join(", ")}; ${found.stable ? "stable" : "not stable"}`;
      section.dataset.ready = JSON.stringify(values);
    }

    // However fast a slider moves, it is drawn once a frame.
    function soon() {
      if (waiting) return;
      waiting = true;
      root.requestAnimationFrame(show);
    }

    section.querySelector("form").addEventListener("submit", (event) => event.preventDefault());
    section.classList.add("play-alive");
    show();
  }

  function begin() {
    for (const section of document.querySelectorAll("section.play")) start(section);
  }
  if (document.readyState === "loading") document.addEventListener("DOMContentLoaded", begin);
  else begin();
})(globalThis);
