"""The worst errors of each output over all blocks that are done, as a table in Markdown."""

from __future__ import annotations

from collections.abc import Iterator, Mapping, Sequence
from typing import Any

from gainproof.campaign.campaign import Arguments, Done, Report
from gainproof.campaign.float32.tally import joined
from gainproof.campaign.float64.kernels import Sampled

HEAD = ("kernel", "points", "output", "bound", "worst", "ulp", "worst at", "outside")
HEAD_MORE = ("undocumented",)
FINER = 2.0**-11
"""The roundings of the reference over those of float64: 64 digits and not 53."""
TALLIED = {"worst", "at", "ulp", "outside", "undocumented"}
Ranges = Mapping[tuple[int, int], str]


def doubt(bound: float, constants: int) -> float:
    """What the reference itself may err by, in units of 2^-52 of the true value.

    It rounds the same steps, so that their weights are those that the bound counts, in smaller
    units; a constant that double precision happens to hold well may be off by more of these, and
    weighs no more than the steps that take it. One in a thousand more stands for second order.
    """
    return 1.001 * bound * (1 + constants) * FINER


def report(
    kernels: Mapping[str, Sampled], doubts: Mapping[str, int], ranges: Ranges, done: Sequence[Done]
) -> Report:
    """`doubts`: of each kernel how many constants are rounded. It is as it should be where no error
    is above its bound, by as much as the reference leaves in doubt, and nothing is undocumented.
    """
    found: dict[tuple[str, tuple[int, int]], list[Done]] = {}
    for each in done:
        kernel, _digest, low, high, *_ = each.arguments
        found.setdefault((kernel, (low, high)), []).append(each)
    lines = [_line((*HEAD, *HEAD_MORE)), _line(["---"] * (len(HEAD) + len(HEAD_MORE)))]
    failures, most = 0, 0.0
    for (kernel, place), blocks in found.items():
        points = sum(each.result["inputs"] for each in blocks)
        first = [f"{kernel} `{blocks[0].arguments[1]}`, {ranges[place]}", str(points)]
        for promise in kernels[kernel].promised:
            tally = joined([each.result["outputs"][promise.output] for each in blocks])
            bound = float(promise.bound)
            failures += not tally["worst"] + doubt(bound, doubts[kernel]) <= bound
            failures += tally["undocumented"] > 0
            most = max(most, tally["ulp"])
            lines.append(_line([*first, promise.output, f"{bound:.2f}", *_sizes(tally)]))
            first = ["", ""]
    total = sum(each.result["inputs"] for each in done)
    said = f"{total} points, at most {most:.4f} units in the last place"
    lines += ["", f"{said}, outputs not as stated: {failures}"]
    return Report("\n".join(lines), not failures)


def fault(kernels: Mapping[str, Sampled], arguments: Arguments, result: Any) -> str | None:
    """What is wrong with a result that is read again; None where a block may have given it."""
    count = arguments[-1]
    if not isinstance(result, dict) or result.get("inputs") != count:
        return f"a result of {count} inputs is wanted, got {str(result)[:80]}"
    names = {each.output for each in kernels[arguments[0]].promised}
    outputs = result.get("outputs")
    if not isinstance(outputs, dict) or outputs.keys() != names:
        return f"outputs must be {', '.join(sorted(names))}, got {str(outputs)[:80]}"
    for name, tally in outputs.items():
        if not isinstance(tally, dict) or tally.keys() != TALLIED:
            return f"{name}: {', '.join(sorted(TALLIED))} are wanted, got {str(tally)[:80]}"
        sizes = [tally["worst"], tally["ulp"], tally["outside"], tally["undocumented"]]
        if not all(isinstance(size, int | float) and size >= 0 for size in sizes):
            return f"{name}: sizes must be numbers from 0, got {sizes}"
    return None


def _sizes(tally: Mapping[str, Any]) -> Iterator[str]:
    yield f"{tally['worst']:.4f}"
    yield f"{tally['ulp']:.4f}"
    yield "-" if tally["at"] is None else repr(tally["at"])
    yield str(tally["outside"])
    yield str(tally["undocumented"])


def _line(cells: Sequence[str]) -> str:
    return f"| {' | '.join(cells)} |"
