"""The worst errors of each output over all blocks that are done."""

from __future__ import annotations

from collections.abc import Sequence
from typing import Any

from gainproof.campaign.campaign import Done, Report
from gainproof.campaign.float32.tally import COUNTED, Tally, joined

HEAD = ("bound", "worst", "in ulp", *COUNTED, "worst at")
WIDTH = 16


def report(done: Sequence[Done]) -> Report:
    """A table; it is as it should be where no error is above its bound and nothing undocumented."""
    kernels: dict[str, list[Any]] = {}
    for each in done:
        # the digest beside the name: of what the errors are
        kernels.setdefault(" ".join(each.arguments[:2]), []).append(each.result)
    lines = []
    failures = 0
    for kernel, results in kernels.items():
        inputs = sum(result["inputs"] for result in results)
        lines.append(_row(f"{kernel}, {inputs} inputs", HEAD))
        for name in results[0]["outputs"]:
            found = joined([result["outputs"][name] for result in results])
            failures += found["above"] + found["undocumented"]
            lines.append(_row(f"  {name}", _cells(found)))
    inputs = sum(each.result["inputs"] for each in done)
    lines.append(f"{len(kernels)} kernels, {inputs} inputs, above or undocumented: {failures}")
    return Report("\n".join(lines), not failures)


def _cells(found: Tally) -> list[str]:
    sizes = [f"{found['bound']:.2f}", f"{found['worst']:.4f}", f"{found['ulp']:.4f}"]
    counts = [str(found[word]) for word in COUNTED]
    return [*sizes, *counts, "-" if found["at"] is None else f"{found['at']:.9g}"]


def _row(name: str, cells: Sequence[str]) -> str:
    return f"{name:<72}" + "".join(f"{cell:>{WIDTH}}" for cell in cells)
