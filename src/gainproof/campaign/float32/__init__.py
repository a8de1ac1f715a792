"""Every float32 input of the kernels of one input, against the same graph in double precision."""

from __future__ import annotations

from collections.abc import Sequence
from functools import partial

from gainproof.campaign.campaign import Campaign
from gainproof.campaign.float32.fault import fault
from gainproof.campaign.float32.kernels import Swept, chosen, swept_kernels
from gainproof.campaign.float32.report import Row, report
from gainproof.campaign.float32.sweep import block

TITLE = "every float32 input of each kernel of one input: worst errors beside the proved bounds"
BLOCK = 1 << 24
"""Inputs of a block: a second or less, and 128 blocks a kernel of all positive numbers."""


def campaign(names: Sequence[str] = ()) -> Campaign:
    """The sweep of the kernels of these names (module or module.kernel), of all without: gains
    first. Raises BadInputError for a name that is none.

    Kernels of the same digest are the same arithmetic on the same inputs: they are swept once, by
    the name of the first of all.
    """
    alike: dict[str, list[Swept]] = {}
    for kernel in swept_kernels():
        alike.setdefault(kernel.digest(), []).append(kernel)
    wanted = {kernel.id for kernel in chosen(swept_kernels(), names)}
    groups = [
        (digest, kernels)
        for digest, kernels in alike.items()
        if wanted & {kernel.id for kernel in kernels}
    ]
    groups.sort(key=lambda group: group[1][0].name != "gains")
    starts = {digest: _starts(kernels[0]) for digest, kernels in groups}
    blocks = [
        (kernels[0].id, digest, start, min(BLOCK, kernels[0].stop - start))
        for digest, kernels in groups
        for start in starts[digest]
    ]
    rows = {
        digest: Row(", ".join(each.id for each in kernels), kernels[0].stated, len(starts[digest]))
        for digest, kernels in groups
    }
    known = {kernels[0].id: kernels[0] for _, kernels in groups}
    return Campaign("float32", block, blocks, partial(report, rows), partial(fault, known))


def _starts(kernel: Swept) -> range:
    return range(kernel.start, kernel.stop, BLOCK)
