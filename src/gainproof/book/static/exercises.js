// A marked line of an exercise sheet checked against salted digests: see book/exercises/sealed.py,
// which does the same in Python. Written out because browsers give digests to secure pages only.
"use strict";

const ROUNDS = (() => {
  const primes = [];
  for (let n = 2; primes.length < 64; n += 1) {
    if (primes.every((p) => n % p)) {
      primes.push(n);
    }
  }
  const bits = (x) => Math.floor((x - Math.floor(x)) * 2 ** 32);
  return { start: primes.slice(0, 8).map((p) => bits(Math.sqrt(p))), add: primes.map((p) => bits(Math.cbrt(p))) };
})();

function sha256(text) {
  const given = new TextEncoder().encode(text);
  const length = ((given.length + 8) >> 6) + 1;
  const view = new DataView(new ArrayBuffer(length * 64));
  given.forEach((byte, place) => view.setUint8(place, byte));
  view.setUint8(given.length, 0x80);
  view.setUint32(length * 64 - 4, given.length * 8);
  const hash = [...ROUNDS.start];
  const turn = (x, n) => (x >>> n) | (x << (32 - n));
  for (let block = 0; block < length; block += 1) {
    const w = [];
    for (let t = 0; t < 64; t += 1) {
      if (t < 16) {
        w.push(view.getUint32(block * 64 + t * 4));
      } else {
        const a = w[t - 15];
        const b = w[t - 2];
        const first = turn(a, 7) ^ turn(a, 18) ^ (a >>> 3);
        const second = turn(b, 17) ^ turn(b, 19) ^ (b >>> 10);
        w.push((w[t - 16] + first + w[t - 7] + second) | 0);
      }
    }
    let [a, b, c, d, e, f, g, h] = hash;
    for (let t = 0; t < 64; t += 1) {
      const one = (h + (turn(e, 6) ^ turn(e, 11) ^ turn(e, 25)) + ((e & f) ^ (~e & g)) + ROUNDS.add[t] + w[t]) | 0;
      const two = ((turn(a, 2) ^ turn(a, 13) ^ turn(a, 22)) + ((a & b) ^ (a & c) ^ (b & c))) | 0;
      [a, b, c, d, e, f, g, h] = [(one + two) | 0, a, b, c, (d + one) | 0, e, f, g];
    }
    [a, b, c, d, e, f, g, h].forEach((word, place) => (hash[place] = (hash[place] + word) | 0));
  }
  const bytes = new Uint8Array(32);
  const out = new DataView(bytes.buffer);
  hash.forEach((word, place) => out.setUint32(place * 4, word));
  return bytes;
}

function digest(salt, use, line) {
  return [...sha256(`${salt}:${use}:${line}`)].map((byte) => byte.toString(16).padStart(2, "0")).join("");
}

// Half points of a mark: 2 for the line, 1 for its region.
function halfPoints(sealed, line) {
  if (digest(sealed.salt, "line", line) === sealed.line) {
    return 2;
  }
  return sealed.near.includes(digest(sealed.salt, "near", line)) ? 1 : 0;
}

function answerOf(sealed, line) {
  const mixed = Uint8Array.from(atob(sealed.text), (letter) => letter.charCodeAt(0));
  let block = new Uint8Array(0);
  const bytes = mixed.map((byte, place) => {
    if (place % 32 === 0) {
      block = sha256(`${sealed.salt}:text:${line}:${place / 32}`);
    }
    return byte ^ block[place % 32];
  });
  return new TextDecoder().decode(bytes);
}

function setUpMarking() {
  const form = document.getElementById("marking");
  const sealed = JSON.parse(document.getElementById("exercise").dataset.sealed);
  const told = document.getElementById("told");
  const words = ["0 points", "half a point", "1 point"];
  let score = null;
  form.addEventListener("submit", (event) => {
    event.preventDefault();
    const line = new FormData(form).get("line");
    if (line === null) {
      told.textContent = "No line is marked.";
      return;
    }
    const half = halfPoints(sealed, line);
    const first = score === null;
    score = first ? half : score;
    const verdict = [
      `Line ${line} holds, and the error is not near it.`,
      `Line ${line} holds; the error is near: in the same part, or next to it.`,
      half === 2 ? answerOf(sealed, line) : "",
    ][half];
    told.textContent = `${verdict} ${first ? "This mark" : "The first mark"}: ${words[score]}.`;
  });
}

if (typeof document !== "undefined") {
  setUpMarking();
} else {
  module.exports = { sha256, digest, halfPoints, answerOf };
}
