"""Scripts run by Node.js, where there is one, on numbers that cross as the bytes of float64."""

from __future__ import annotations

import json
import shutil
import subprocess
from collections.abc import Mapping, Sequence
from pathlib import Path
from typing import Any

import numpy as np
import pytest
from numpy.typing import NDArray

NODE = shutil.which("node")
needs_node = pytest.mark.skipif(NODE is None, reason="there is no Node.js (node) on the path")

Reals = NDArray[np.float64]

DRIVER = """\
"use strict";
const fs = require("node:fs");
const vm = require("node:vm");
const order = JSON.parse(fs.readFileSync(process.argv[1], "utf8"));
for (const path of order.scripts) vm.runInThisContext(fs.readFileSync(path, "utf8"), path);
for (const call of order.calls) {
  const bytes = fs.readFileSync(call.given);
  const given = new Float64Array(bytes.buffer, bytes.byteOffset, bytes.length / 8);
  const rows = given.length / call.inputs;
  const found = new Float64Array(rows * call.outputs.length);
  const kernel = gainproof.kernels[call.module][call.kernel];
  for (let row = 0; row < rows; row++) {
    const inputs = given.subarray(row * call.inputs, (row + 1) * call.inputs);
    const values = kernel(...inputs);
    call.outputs.forEach((name, at) => (found[row * call.outputs.length + at] = values[name]));
  }
  fs.writeFileSync(call.found, new Uint8Array(found.buffer));
}
"""


def run(program: str, *arguments: str) -> str:
    """What a program prints; AssertionError with what it complains of if it fails."""
    assert NODE is not None
    command = [NODE, "-e", program, "--", *arguments]
    done = subprocess.run(command, capture_output=True, text=True, timeout=120, check=False)
    assert done.returncode == 0, done.stderr[-2000:]
    return done.stdout


def answers(program: str, scripts: Sequence[Path], given: Any = None) -> Any:
    """The value of an expression or function body `program` after the scripts, as JSON; `given`
    is what it knows under that name.
    """
    wrapped = (
        "const fs = require('node:fs'); const vm = require('node:vm');"
        f"for (const path of {json.dumps([str(path) for path in scripts])})"
        " vm.runInThisContext(fs.readFileSync(path, 'utf8'), path);"
        "const given = JSON.parse(fs.readFileSync(0, 'utf8'));"
        f"console.log(JSON.stringify((() => {{ {program} }})()));"
    )
    assert NODE is not None
    done = subprocess.run(
        [NODE, "-e", wrapped],
        input=json.dumps(given),
        capture_output=True,
        text=True,
        timeout=120,
        check=False,
    )
    assert done.returncode == 0, done.stderr[-2000:]
    return json.loads(done.stdout)


def evaluated(
    scripts: Sequence[Path],
    calls: Mapping[tuple[str, str], tuple[Reals, Sequence[str]]],
    folder: Path,
) -> dict[tuple[str, str], Reals]:
    """Kernels (module, name) at points, one row each, with the names of their outputs: the values,
    a row for each point. One process for all.
    """
    order: dict[str, Any] = {"scripts": [str(path) for path in scripts], "calls": []}
    for place, ((module, kernel), (points, outputs)) in enumerate(calls.items()):
        given, found = folder / f"given-{place}", folder / f"found-{place}"
        given.write_bytes(np.ascontiguousarray(points, np.float64).tobytes())
        entry = {"module": module, "kernel": kernel, "inputs": points.shape[1]}
        order["calls"].append(
            {**entry, "outputs": list(outputs), "given": str(given), "found": str(found)}
        )
    path = folder / "order.json"
    path.write_text(json.dumps(order), encoding="utf-8")
    run(DRIVER, str(path))
    return {
        key: np.frombuffer((folder / f"found-{place}").read_bytes()).reshape(-1, len(outputs))
        for place, (key, (_, outputs)) in enumerate(calls.items())
    }
