// Appearance, depth of a derivation, copying LaTeX, search. Pages read well without it.
"use strict";

function setUpTheme() {
  const select = document.getElementById("theme");
  select.value = document.documentElement.dataset.theme || "auto";
  select.addEventListener("change", () => {
    if (select.value === "auto") {
      delete document.documentElement.dataset.theme;
    } else {
      document.documentElement.dataset.theme = select.value;
    }
    try {
      localStorage.setItem("gainproof-theme", select.value);
    } catch (error) {
      // without storage the choice holds for this page
    }
  });
}

function setUpDepth() {
  const field = document.querySelector("fieldset.depth");
  if (!field) {
    return;
  }
  field.hidden = false;
  const article = document.getElementById("derivation");
  field.addEventListener("change", (event) => {
    article.classList.toggle("short", event.target.value === "short");
  });
}

// A place inside folded details is opened when somebody is led to it.
function openTarget() {
  let target = null;
  try {
    target = location.hash && document.getElementById(decodeURIComponent(location.hash.slice(1)));
  } catch (error) {
    // a link of others may end in anything
  }
  const folded = target && target.closest("details");
  if (folded && !folded.open) {
    folded.open = true;
    target.scrollIntoView();
  }
}

function setUpCopying() {
  const words = document.body.dataset;
  for (const box of document.querySelectorAll(".formula")) {
    const source = box.querySelector("annotation");
    if (!source) {
      continue;
    }
    const button = document.createElement("button");
    button.type = "button";
    button.className = "copy";
    button.textContent = words.copy;
    button.addEventListener("click", async () => {
      await copyText(source.textContent);
      button.textContent = words.copied;
      setTimeout(() => (button.textContent = words.copy), 1500);
    });
    const frame = document.createElement("div");
    frame.className = "framed";
    box.replaceWith(frame);
    frame.append(box, button);
  }
}

async function copyText(text) {
  if (navigator.clipboard && window.isSecureContext) {
    await navigator.clipboard.writeText(text);
    return;
  }
  const field = document.createElement("textarea");
  field.value = text;
  document.body.append(field);
  field.select();
  document.execCommand("copy");
  field.remove();
}

// How well an entry fits: every word must occur; titles count more, their beginnings most.
function fit(entry, wanted) {
  const title = entry.title.toLowerCase();
  const words = entry.words.toLowerCase();
  let sum = 0;
  for (const word of wanted) {
    if (title.startsWith(word)) {
      sum += 8;
    } else if (title.includes(word)) {
      sum += 4;
    } else if (words.includes(word)) {
      sum += 1;
    } else {
      return 0;
    }
  }
  return sum;
}

function setUpSearch() {
  const results = document.getElementById("results");
  if (!results || !window.gainproofSearch) {
    return;
  }
  const field = document.querySelector(".search input");
  const status = document.getElementById("found");
  const show = () => {
    const wanted = field.value.toLowerCase().split(/\s+/).filter(Boolean);
    const found = wanted.length
      ? window.gainproofSearch
          .map((entry) => [fit(entry, wanted), entry])
          .filter(([sum]) => sum > 0)
          .sort((a, b) => b[0] - a[0])
      : [];
    results.replaceChildren(...found.slice(0, 100).map(([, entry]) => resultOf(entry)));
    const more = found.length > 100 ? ", the first 100 shown" : "";
    status.textContent = wanted.length ? `${found.length} found${more}` : "Write a word into the field above.";
  };
  field.value = new URLSearchParams(location.search).get("q") || "";
  field.addEventListener("input", show);
  show();
}

function resultOf(entry) {
  const line = document.createElement("li");
  const link = document.createElement("a");
  link.href = document.body.dataset.root + entry.path;
  link.textContent = entry.title;
  const kind = document.createElement("span");
  kind.className = "muted";
  kind.textContent = ` ${entry.kind}`;
  const words = document.createElement("p");
  words.textContent = entry.words.slice(0, 200);
  line.append(link, kind, words);
  return line;
}

setUpTheme();
setUpDepth();
setUpCopying();
setUpSearch();
openTarget();
window.addEventListener("hashchange", openTarget);
