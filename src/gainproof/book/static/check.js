// The page "Check a formula". What a link or a formula says is shown as text, never as HTML.
import { Judge } from "./check.judge.js";

const MATHML = "http://www.w3.org/1998/Math/MathML";
const PAUSE = 400;
const SECONDS = 60;
const MOST_LINK = 12000;
const MOST_SYMBOLS = 50;

const at = (id) => document.getElementById(id);
const conventions = [...document.querySelectorAll("select.convention")];
const corrections = new Map();
const judge = new Judge(() => {
  // A worker of a blob keeps to the policy of the page, one of a file does not.
  const script = `import ${JSON.stringify(new URL("check.worker.js", import.meta.url).href)};`;
  const address = URL.createObjectURL(new Blob([script], { type: "text/javascript" }));
  return new Worker(address, { type: "module" });
});
let turn = Promise.resolve();
let round = 0;
let waiting = false;
let pause = 0;

function element(name, ...parts) {
  const made = document.createElement(name);
  made.append(...parts);
  return made;
}

// [element, attributes, parts] as the judge vetted it, or text.
function mathematics(formula) {
  if (typeof formula === "string") {
    return document.createTextNode(formula);
  }
  const [name, attributes, parts] = formula;
  const made = document.createElementNS(MATHML, name);
  for (const [key, value] of Object.entries(attributes)) {
    made.setAttribute(key, value);
  }
  made.append(...parts.map(mathematics));
  return made;
}

function within(seconds) {
  return seconds >= 1 && seconds <= Number(at("seconds").max) ? seconds : SECONDS;
}

function request(what) {
  const lines = at("given").value.split("\n").map((line) => line.trim());
  return {
    do: what,
    formula: at("formula").value,
    said: {
      symbols: Object.fromEntries(corrections),
      model: at("model").value,
      domain: at("domain").value.trim(),
      given: lines.filter(Boolean),
      conventions: Object.fromEntries(conventions.filter((each) => each.value).map((each) => [each.name, each.value])),
    },
    seconds: within(at("seconds").valueAsNumber),
    columns: Math.max(30, Math.min(100, Math.floor(at("ask").clientWidth / 9))),
  };
}

function linkOf({ formula, said, seconds }) {
  const parts = new URLSearchParams({ f: formula });
  for (const [name, meaning] of Object.entries(said.symbols)) {
    parts.append("s", `${name}: ${meaning}`);
  }
  for (const [name, value] of Object.entries({ ...said.conventions, model: said.model, domain: said.domain })) {
    if (value) {
      parts.set(name, value);
    }
  }
  said.given.forEach((relation) => parts.append("given", relation));
  parts.set("seconds", seconds);
  return `#${parts}`;
}

// Fills the form from the link and judges nothing.
function takeLink() {
  const text = location.hash.slice(1);
  if (!text.startsWith("f=")) {
    return;
  }
  const parts = new URLSearchParams(text);
  const formula = parts.get("f");
  const symbols = parts.getAll("s");
  if (text.length > MOST_LINK || formula.length > at("formula").maxLength || symbols.length > MOST_SYMBOLS) {
    tell("The link is too long and was not taken.");
    return;
  }
  at("formula").value = formula;
  corrections.clear();
  for (const symbol of symbols) {
    const place = symbol.indexOf(":");
    if (place > 0) {
      corrections.set(symbol.slice(0, place).trim(), symbol.slice(place + 1).trim());
    }
  }
  at("domain").value = parts.get("domain") ?? "";
  at("given").value = parts.getAll("given").join("\n");
  at("seconds").value = within(Number(parts.get("seconds")));
  for (const list of [at("model"), ...conventions]) {
    list.value = parts.get(list.name || list.id) ?? "";
    list.selectedIndex = Math.max(0, list.selectedIndex);
  }
  clear();
  // what a link says of it shall be seen
  at("model").closest("details").open = ["model", "domain", "given"].some((name) => parts.get(name));
  at("symbols").replaceChildren();
  showUnderstood({});
  tell("Taken from the link; nothing is judged until you press Check.");
}

function correct(name, meaning) {
  if (meaning.trim()) {
    corrections.set(name.trim(), meaning.trim());
  } else {
    corrections.delete(name.trim());
  }
  soon();
}

function showSymbols(symbols) {
  const known = new Map(symbols.map((symbol) => [symbol.name, symbol]));
  for (const name of corrections.keys()) {
    if (!known.has(name)) {
      known.set(name, { name, set: name, means: "" });
    }
  }
  const focused = document.activeElement?.dataset?.symbol;
  const typed = new Map([...at("symbols").querySelectorAll("input")].map((field) => [field.dataset.symbol, field.value]));
  at("symbols").replaceChildren(
    ...[...known.values()].map(({ name, set, means }) => {
      const field = element("input");
      field.value = typed.get(name) ?? corrections.get(name) ?? "";
      field.dataset.symbol = name;
      field.maxLength = 1000;
      field.setAttribute("list", "quantities");
      field.setAttribute("aria-label", `What ${name} is`);
      field.addEventListener("change", () => correct(name, field.value));
      const head = element("th", mathematics(set));
      head.scope = "row";
      return element("tr", head, element("td", means), element("td", field));
    })
  );
  [...at("symbols").querySelectorAll("input")].find((field) => field.dataset.symbol === focused)?.focus();
  at("letters").hidden = false;
}

// What cannot be read has an error, and neither a set form nor symbols.
function showUnderstood({ error = "", set = "", symbols = [], filters = [] }) {
  at("problem").textContent = error;
  at("problem").hidden = !error;
  at("set").replaceChildren(mathematics(set));
  at("set").hidden = !set;
  at("filter").textContent = `Filter: ${filters.join("; or ")}`;
  at("filter").hidden = Boolean(error);
  showSymbols(symbols);
}

function long(formula) {
  const made = element("span", mathematics(formula));
  made.className = "long";
  made.tabIndex = 0;
  return made;
}

function showAnswer(asked, answer, took) {
  at("verdict").textContent = answer.headline;
  at("verdict").className = `mark ${answer.verdict}`;
  const repairs = answer.repairs.map(({ set, words }) => ["nearest true", element("span", long(set), ` (${words})`)]);
  const facts = [["formula", long(answer.set)], ...answer.facts, ...repairs];
  at("facts").replaceChildren(
    ...facts.map(([label, words]) => element("div", element("dt", label), element("dd", words)))
  );
  at("explanation").textContent = answer.explanation;
  at("file").textContent = answer.file;
  at("link").href = linkOf(asked);
  at("answer").hidden = false;
  tell(took);
}

function clear() {
  at("verdict").textContent = "";
  at("answer").hidden = true;
}

function tell(words) {
  at("told").textContent = words;
}

// One request after the other: `show` gets what is asked when its turn comes, the answer, and in
// words how long it took.
function inTurn(what, show) {
  const mine = round;
  turn = turn.then(async () => {
    waiting = waiting && what !== "understand";
    const asked = request(what);
    const empty = !asked.formula.trim();
    if (empty) {
      showUnderstood({});
      tell("A formula is wanted.");
    }
    if (empty || mine !== round) {
      return;
    }
    const loading = judge.worker === null;
    const begun = Date.now();
    const seconds = () => (Date.now() - begun) / 1000;
    const clock = setInterval(() => (at("clock").textContent = `${Math.round(seconds())} s`), 1000);
    tell(loading ? "Loading the judge …" : what === "ask" ? "Judging …" : at("told").textContent);
    at("stop").disabled = false;
    const said = await judge.answer(asked);
    clearInterval(clock);
    at("clock").textContent = "";
    at("stop").disabled = true;
    if (said.failed) {
      tell(`The judge does not run here: ${said.failed}`);
    } else if (said.answer) {
      tell(said.answer.error ? "This is not read." : "Ready.");
      showUnderstood(said.answer);
      if (!said.answer.error) {
        show(asked, said.answer, `${loading ? "Loaded and judged" : "Judged"} in ${seconds().toFixed(1)} s.`);
      }
    }
  });
  return turn;
}

// After a change: no verdict stands beside a question that it does not answer.
function soon() {
  clear();
  clearTimeout(pause);
  pause = setTimeout(() => {
    if (!waiting) {
      waiting = true;
      inTurn("understand", () => {});
    }
  }, PAUSE);
}

at("ask").addEventListener("submit", async (event) => {
  event.preventDefault();
  clearTimeout(pause);
  clear();
  at("check").disabled = true;
  await inTurn("ask", (asked, answer, took) => {
    showAnswer(asked, answer, took);
    history.replaceState(null, "", linkOf(asked));
  });
  at("check").disabled = false;
});
at("ask").addEventListener("input", (event) => {
  if (event.target.dataset.symbol === undefined && !["name", "means"].includes(event.target.id)) {
    soon();
  }
});
for (const id of ["name", "means"]) {
  at(id).addEventListener("change", () => {
    if (at("name").value.trim() && at("means").value.trim()) {
      correct(at("name").value, at("means").value);
      at("name").value = at("means").value = "";
    }
  });
}
at("stop").addEventListener("click", () => {
  round += 1;
  judge.stop();
  tell("Stopped. The next formula loads the judge again.");
});
window.addEventListener("hashchange", takeLink);
at("idle").hidden = true;
at("ask").hidden = false;
takeLink();
