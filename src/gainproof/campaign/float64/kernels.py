"""The kernels that are sampled: of one positive input, with errors relative to the true values."""

from __future__ import annotations

import hashlib
from collections.abc import Sequence
from dataclasses import dataclass
from functools import cache
from pathlib import Path

import numpy as np

from gainproof.bad_input import BadInputError
from gainproof.campaign.float32.kernels import (
    Swept,
    chosen,
    code_of,
    swept_kernels,
)
from gainproof.campaign.float32.traced import computed
from gainproof.campaign.printed_bound import PrintedBound, printed_bounds
from gainproof.files.places import generated_folder

DEFAULT = tuple(
    f"{family}.gains"
    for family in ("random_velocity", "random_acceleration", "continuous_white_acceleration")
)
"""Gains of two states, of one parameter."""
MEASURING = ("block.py", "c_text.py", "compiled.py")


@dataclass(frozen=True)
class Sampled:
    """A kernel with what its docstring promises of each output, in their order."""

    swept: Swept
    promised: tuple[PrintedBound, ...]

    @property
    def bits(self) -> tuple[int, int]:
        """Those of the least and greatest number of the domain, which have the numbers' order."""
        low, high = np.array(self.swept.signature.inputs[0].double).view(np.int64).tolist()
        return low, high

    @property
    def ends(self) -> tuple[tuple[float, float], ...]:
        """For each output the least and greatest input with a bound."""
        return tuple((float(each.domain[0]), float(each.domain[1])) for each in self.promised)

    def digest(self) -> str:
        """Of what the results rest on: arithmetic, domain, ranges, and how errors are measured."""
        found = hashlib.sha256(computed(self.swept.signature, single=False).encode())
        found.update(repr((self.bits, self.swept.signature.outputs, self.ends)).encode())
        found.update(_measuring_code())
        return found.hexdigest()[:16]


def sampled(names: Sequence[str]) -> list[Sampled]:
    """The kernels of these names, module or module.kernel; without names those of DEFAULT.

    Raises BadInputError for a name that is none, and for a kernel of whole numbers or one whose
    docstring states errors over something else than the true value.
    """
    return [_sampled(each) for each in chosen(swept_kernels(), names or DEFAULT)]


def _sampled(swept: Swept) -> Sampled:
    source = (generated_folder() / f"{swept.module}.py").read_text("utf-8")
    known = {each.output: each for each in printed_bounds(source) if each.kernel == swept.name}
    outputs = swept.signature.outputs
    if swept.whole or any(name not in known for name in outputs):
        raise BadInputError(
            f"{swept.id}: a kernel of any positive numbers is wanted, with errors "
            "relative to the true values"
        )
    return Sampled(swept, tuple(known[name] for name in outputs))


@cache
def _measuring_code() -> bytes:
    return code_of(Path(__file__).parent / name for name in MEASURING)
