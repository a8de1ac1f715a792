"""A hundred million float64 inputs of kernels of one input, against the same graph in long double.

The whole domain has some 2,000 powers of 2, and the terms of sums are of like size on few of them,
near index 1, where errors are largest: a second hundred million is drawn there.
"""

from __future__ import annotations

from collections.abc import Sequence
from functools import partial

import numpy as np

from gainproof.campaign.campaign import Campaign
from gainproof.campaign.float64.block import block, graph
from gainproof.campaign.float64.c_text import rounded_constants
from gainproof.campaign.float64.kernels import Sampled, sampled
from gainproof.campaign.float64.report import fault, report

TITLE = "1e8 float64 inputs of each kernel of gains of two states, and 1e8 more near index 1"
POINTS = 100_000_000
"""Of a kernel and range."""
BLOCK = 1 << 22
MIDDLE = 2.0**-24, 2.0**24
"""The range in which the terms of sums are of like size: the worst errors are there."""


def campaign(names: Sequence[str] = (), points: int = POINTS) -> Campaign:
    """That of the kernels of these names (module or module.kernel); without, gains of two states.

    Raises BadInputError for a name that is none, and a kernel that cannot be compared.
    """
    kernels = {each.swept.id: each for each in sampled(names)}
    doubts = {name: rounded_constants(graph(name)) for name in kernels}
    ranges = {}
    blocks = []
    for name, kernel in kernels.items():
        for place, words in _ranges(kernel):
            ranges[place] = words
            blocks += [
                (name, kernel.digest(), *place, points, first, min(BLOCK, points - first))
                for first in range(0, points, BLOCK)
            ]
    return Campaign(
        "float64",
        block,
        blocks,
        partial(report, kernels, doubts, ranges),
        partial(fault, kernels),
    )


def _ranges(kernel: Sampled) -> list[tuple[tuple[int, int], str]]:
    """The bits of the ends of the whole domain, and of what is in the middle of it."""
    low, high = kernel.bits
    least, most = np.array(MIDDLE).view(np.int64).tolist()
    middle = max(low, least), min(high, most)
    return [((low, high), "whole domain"), (middle, "2^-24 to 2^24")]
