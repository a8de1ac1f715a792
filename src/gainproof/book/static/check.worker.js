// Python with the judge. It runs in a worker, which the page ends when it likes, and loads from the
// folder of the page alone.
import createPyodideModule from "../runtime/pyodide.asm.js";
import { loadPyodide } from "../runtime/pyodide.js";

const FOLDER = new URL("../runtime/", import.meta.url).href;
const WHEELS = ["python-flint.whl", "lark.whl", "latex2mathml.whl", "gainproof.whl"];

async function bytes(name) {
  const response = await fetch(FOLDER + name);
  if (!response.ok) {
    throw new Error(`${name}: ${response.status} ${response.statusText}`);
  }
  return response.arrayBuffer();
}

try {
  const loading = loadPyodide({ indexURL: FOLDER, createPyodideModule });
  const [python, ...wheels] = await Promise.all([loading, ...WHEELS.map(bytes)]);
  for (const wheel of wheels) {
    python.unpackArchive(wheel, "wheel");
  }
  const page = python.pyimport("gainproof.answers.in_page").InPage((text) => self.postMessage(JSON.parse(text)));
  self.onmessage = ({ data }) => {
    try {
      const answer = JSON.parse(page.answered(JSON.stringify(data)));
      self.postMessage({ answer, memory: python._module.HEAP8.length });
    } catch (error) {
      self.postMessage({ failed: String(error).slice(-500) });
    }
  };
  self.postMessage({ ready: true });
} catch (error) {
  self.postMessage({ failed: String(error).slice(-500) });
}
