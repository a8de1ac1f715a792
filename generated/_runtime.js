// Made by: gainproof generate
// What printed kernels share: guards and starts of cube roots.
(function (root) {
  "use strict";
  const gainproof = root.gainproof || (root.gainproof = {});
  gainproof.kernels = gainproof.kernels || {};

  // Comparisons with NaN are false, and a text that looks like a number is none.
  function within(x, low, high) {
    return typeof x === "number" && x >= low && x <= high;
  }

  // The error of an input outside its domain, in the words of the NumPy kernels.
  function refuse(kernel, name, wanted, came) {
    if (typeof came !== "number") {
      throw new TypeError(`${kernel}: ${name} must be a number, got ${typeof came}`);
    }
    throw new RangeError(`${kernel}: ${name} must be ${wanted}, got ${numberText(came)}`);
  }

  // The shortest decimal that gives the number back, written as Python writes it.
  function numberText(x) {
    if (Number.isNaN(x)) return "nan";
    if (!Number.isFinite(x)) return x < 0 ? "-inf" : "inf";
    if (x === 0) return Object.is(x, -0) ? "-0.0" : "0.0";
    const size = Math.abs(x);
    if (size < 1e-4 || size >= 1e16) {
      const [digits, exponent] = x.toExponential().split("e");
      return `${digits}e${exponent[0]}${exponent.slice(1).padStart(2, "0")}`;
    }
    const text = String(x);
    return text.includes(".") ? text : `${text}.0`;
  }

  // A number near the cube root: a third of the bits of a float64, and a constant.
  const number = new Float64Array(1);
  const bits = new BigUint64Array(number.buffer);
  function nearCubeRoot(x) {
    number[0] = x;
    bits[0] = bits[0] / 3n + 3071306327078975046n;
    return number[0];
  }

  gainproof.runtime = { within, refuse, nearCubeRoot, numberText };
})(globalThis);
