"""The page that checks formulas: its judge under Node.js, and a server for its folder."""

from __future__ import annotations

import json
import subprocess
import threading
from collections.abc import Iterator, Sequence
from contextlib import contextmanager
from functools import partial
from http.server import SimpleHTTPRequestHandler, ThreadingHTTPServer
from pathlib import Path
from typing import Any

from node import NODE

WORKER = """\
// A worker of Node.js as a web worker is: what Pyodide and the page's script ask of one.
import { parentPort, workerData } from "node:worker_threads";
import { readFile } from "node:fs/promises";
import { fileURLToPath } from "node:url";
globalThis.self = globalThis;
globalThis.WorkerGlobalScope = class {
  static [Symbol.hasInstance](each) { return each === globalThis; }
};
globalThis.location = new URL(workerData);
process.browser = true;
process.type = "renderer";
globalThis.postMessage = (data) => parentPort.postMessage(data);
globalThis.fetch = async (address) => new Response(await readFile(fileURLToPath(address)), {
  headers: { "Content-Type": String(address).endsWith(".wasm") ? "application/wasm" : "" },
});
parentPort.on("message", (data) => globalThis.onmessage({ data }));
await import(workerData);
"""
DRIVER = """\
import { Worker } from "node:worker_threads";
import { readFileSync, writeFileSync } from "node:fs";
import { Judge } from "./static/check.judge.js";
const { script, requests } = JSON.parse(readFileSync("order.json", "utf8"));
let started = 0;
const judge = new Judge(() => {
  started += 1;
  const worker = new Worker(new URL("worker.mjs", import.meta.url), {
    workerData: new URL(script, import.meta.url).href,
  });
  const shown = {
    postMessage: (data) => worker.postMessage(data),
    terminate: () => worker.terminate(),
  };
  worker.on("message", (data) => shown.onmessage({ data }));
  worker.on("error", (error) => shown.onerror({ message: String(error).slice(0, 300) }));
  return shown;
});
const begun = performance.now();
const first = await judge.begin();
const ready = (performance.now() - begun) / 1000;
const answers = [];
for (const request of requests) answers.push(await judge.answer(request));
judge.end();
writeFileSync("answers.json", JSON.stringify({ first, ready, started, answers }));
"""


def judged(
    folder: Path, requests: Sequence[dict[str, Any]], script: str = "static/check.worker.js"
) -> dict[str, Any]:
    """What the judge of the page in a folder says to requests: {"first", "ready", "started",
    "answers"}, its first word, the seconds until that, how many workers there were, and what came
    of each request.
    """
    assert NODE is not None
    texts = {
        "worker.mjs": WORKER,
        "driver.mjs": DRIVER,
        "package.json": '{"type": "module"}',
        "order.json": json.dumps({"script": script, "requests": list(requests)}),
    }
    for name, text in texts.items():
        (folder / name).write_text(text, encoding="utf-8")
    done = subprocess.run(
        [NODE, "driver.mjs"], cwd=folder, capture_output=True, text=True, timeout=3000, check=False
    )
    # Node.js prints the line of a script, and one of Pyodide's is a megabyte
    assert done.returncode == 0, done.stderr[-2000:]
    return json.loads((folder / "answers.json").read_text(encoding="utf-8"))  # type: ignore[no-any-return]


@contextmanager
def served(folder: Path) -> Iterator[tuple[str, list[str]]]:
    """The address of a server for a folder, and the list of what was asked of it."""
    asked: list[str] = []

    class Handler(SimpleHTTPRequestHandler):
        def log_message(self, *_: Any) -> None:
            asked.append(self.path)

    server = ThreadingHTTPServer(("127.0.0.1", 0), partial(Handler, directory=str(folder)))
    thread = threading.Thread(target=server.serve_forever, daemon=True)
    thread.start()
    try:
        yield f"http://127.0.0.1:{server.server_port}/", asked
    finally:
        server.shutdown()
        server.server_close()
        thread.join()
