"""What is wrong with a result of the sweep that is read again: what no block can have given."""

from __future__ import annotations

from collections.abc import Mapping
from typing import Any

import numpy as np

from gainproof.campaign.campaign import Arguments
from gainproof.campaign.float32.kernels import Swept
from gainproof.campaign.float32.tally import COUNTED

SIZES = ("worst", "ulp")


def fault(kernels: Mapping[str, Swept], arguments: Arguments, result: Any) -> str | None:
    """None where it may be the result of a block with these arguments; `kernels` by name."""
    kernel, _digest, first, count = arguments
    swept = kernels[kernel]
    if not isinstance(result, dict) or result.keys() != {"inputs", "outputs"}:
        return f"a result is inputs and outputs, got {_shown(result)}"
    inputs, outputs = result["inputs"], result["outputs"]
    wanted = count_of(swept, first, count)
    if not _whole(inputs) or inputs != wanted:
        return f"inputs must be {wanted}, got {_shown(inputs)}"
    names = swept.signature.outputs
    if not isinstance(outputs, dict) or outputs.keys() != set(names):
        return f"outputs must be {', '.join(names)}, got {_shown(outputs)}"
    for name, tally in outputs.items():
        found = _tally_fault(tally, inputs, (first, count))
        if found is not None:
            return f"{name}: {found}"
    return None


def count_of(swept: Swept, first: int, count: int) -> int:
    """How many of the numbers with the bits `first` and the next ones a kernel takes."""
    if not swept.whole:
        return count
    # from 2^23 on all numbers are whole
    large = int(np.float32(2**23).view(np.int32))
    low, high = (min(max(bits, 0), large) for bits in (first, first + count))
    ends = np.array([low, high], np.int32).view(np.float32)
    small = int(np.ceil(ends[1])) - int(np.ceil(ends[0]))
    return small + count - (high - low)


def _tally_fault(tally: Any, inputs: int, block: tuple[int, int]) -> str | None:
    if not isinstance(tally, dict) or tally.keys() != {*SIZES, *COUNTED, "at"}:
        return f"a tally is {', '.join((*SIZES, 'at', *COUNTED))}, got {_shown(tally)}"
    worst, ulp = (tally[word] for word in SIZES)
    outside, undocumented = (tally[word] for word in COUNTED)
    at = tally["at"]
    if not (_whole(outside) and _whole(undocumented) and 0 <= undocumented <= outside <= inputs):
        return f"of {inputs} inputs {_shown(outside)} outside, {_shown(undocumented)} undocumented"
    if not (_real(worst) and _real(ulp) and 0 <= worst <= ulp <= 2 * worst):
        # a scale is from 1 to 2 times its power of two
        return f"errors of {_shown(worst)}, in the last place {_shown(ulp)}"
    if outside == inputs:
        return None if at is None and worst == 0 else f"an error at {_shown(at)} of no input"
    if not _real(at) or _bits_of(at) - block[0] not in range(block[1]):
        return f"no input of the block is {_shown(at)}"
    return None


def _bits_of(value: float) -> int:
    """Those of a float32 number from 0; -1 of any other number."""
    if not 0 <= value <= float(np.finfo(np.float32).max) or float(np.float32(value)) != value:
        return -1
    return int(np.float32(value).view(np.int32))


def _whole(value: Any) -> bool:
    return isinstance(value, int) and not isinstance(value, bool)


def _real(value: Any) -> bool:
    return isinstance(value, float) or _whole(value)


def _shown(value: Any) -> str:
    text = repr(value)
    return text if len(text) <= 60 else f"{text[:57]}..."
