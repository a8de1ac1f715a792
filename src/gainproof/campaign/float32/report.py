"""The worst errors of each output over all blocks that are done, as a table in Markdown."""

from __future__ import annotations

from collections.abc import Iterator, Mapping, Sequence
from typing import Any, NamedTuple

from gainproof.campaign.campaign import Done, Report
from gainproof.campaign.float32.stated import Stated
from gainproof.campaign.float32.tally import Tally, joined

HEAD = (
    *("kernel", "inputs", "hours", "output", "bound", "worst", "ulp", "worst at", "outside"),
    "undocumented",
)


class Row(NamedTuple):
    """The kernels of a digest by their names, what they promise of each output, and the number of
    blocks of all their inputs.
    """

    names: str
    promised: Sequence[Stated]
    blocks: int


def report(rows: Mapping[str, Row], done: Sequence[Done]) -> Report:
    """`rows` by digest. It is as it should be where no error is above its bound, by as much as the
    reference leaves in doubt, and nothing is undocumented.
    """
    found: dict[str, list[Done]] = {}
    for each in done:
        found.setdefault(each.arguments[1], []).append(each)
    lines = [_line(HEAD), _line(["---"] * len(HEAD))]
    failures = 0
    for digest, blocks in found.items():
        lines += [_line(cells) for cells in _cells(digest, rows[digest], blocks)]
        failures += sum(
            _fails(each, promise)
            for each, promise in zip(_outputs(blocks).values(), rows[digest].promised, strict=True)
        )
    whole = [rows[digest].names for digest in found if len(found[digest]) == rows[digest].blocks]
    kernels = sum(len(names.split(", ")) for names in whole)
    inputs = sum(each.result["inputs"] for each in done)
    lines += ["", f"{kernels} kernels whole, {inputs} inputs, outputs not as stated: {failures}"]
    return Report("\n".join(lines), not failures)


def _outputs(blocks: Sequence[Done]) -> dict[str, Tally]:
    names = blocks[0].result["outputs"]
    return {name: joined([each.result["outputs"][name] for each in blocks]) for name in names}


def _fails(found: Tally, promise: Stated) -> bool:
    return not found["worst"] + promise.doubt <= promise.bound or found["undocumented"] > 0


def _cells(digest: str, row: Row, blocks: Sequence[Done]) -> Iterator[Sequence[str]]:
    part = "" if len(blocks) == row.blocks else f", {len(blocks)} of {row.blocks} blocks"
    inputs = sum(each.result["inputs"] for each in blocks)
    hours = sum(each.seconds for each in blocks) / 3600
    first = [f"{row.names} `{digest}`{part}", str(inputs), f"{hours:.4f}"]
    for (name, found), promise in zip(_outputs(blocks).items(), row.promised, strict=True):
        yield [*first, name, f"{promise.bound:.2f}", *_sizes(found)]
        first = ["", "", ""]


def _sizes(found: Mapping[str, Any]) -> list[str]:
    place = "-" if found["at"] is None else f"{found['at']:.9g}"
    counts = [str(found["outside"]), str(found["undocumented"])]
    return [f"{found['worst']:.4f}", f"{found['ulp']:.4f}", place, *counts]


def _line(cells: Sequence[str]) -> str:
    return f"| {' | '.join(cells)} |"
