"""Every float32 input of the kernels of one input, against the same graph in double precision."""

from __future__ import annotations

from collections.abc import Sequence

from gainproof.campaign.campaign import Campaign
from gainproof.campaign.float32.kernels import chosen, swept_kernels
from gainproof.campaign.float32.report import report
from gainproof.campaign.float32.sweep import block

TITLE = "every float32 input of each kernel of one input: worst errors beside the proved bounds"
BLOCK = 1 << 24
"""Inputs of a block: a second or less, and 128 blocks a kernel of all positive numbers."""


def campaign(names: Sequence[str] = ()) -> Campaign:
    """The sweep of the kernels of these names (module or module.kernel), of all without: gains
    first. Raises BadInputError for a name that is none.
    """
    kernels = sorted(chosen(swept_kernels(), names), key=lambda kernel: kernel.name != "gains")
    blocks = [
        (kernel.id, digest, first, min(BLOCK, kernel.stop - first))
        for kernel in kernels
        for digest in [kernel.digest()]
        for first in range(kernel.start, kernel.stop, BLOCK)
    ]
    return Campaign("float32", block, blocks, report)
