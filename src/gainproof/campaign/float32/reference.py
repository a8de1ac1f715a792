"""What a kernel is compared with: its graph in double precision.

The graph's steps are rounded as in the float64 kernel, whose proved error is some units of 2^-52: a
few 1e-9 of what float32 can tell, and taken into account (`stated.Stated.doubt`). It rests on the
same graph: it shows the rounding of the float32 kernel, and not that the graph is right, which its
certificate proves.
"""

from __future__ import annotations

from dataclasses import dataclass, replace
from functools import cache

from gainproof.campaign.float32.kernels import Swept
from gainproof.derive.printer.kernel import Kernel, Output
from gainproof.derive.subject import Subject
from gainproof.subjects.deriving import build


@dataclass(frozen=True)
class Compared:
    """An output: the rows of its value and scale among what the reference gives, and the least and
    greatest input for which its bound is stated.
    """

    name: str
    value: int
    scale: int
    lowest: float
    highest: float


@dataclass(frozen=True)
class Reference:
    """`kernel` is the graph with an output for each row that is wanted."""

    kernel: Kernel
    outputs: tuple[Compared, ...]


@cache
def reference(swept: Swept) -> Reference:
    """That of a kernel, derived anew.

    Raises ValueError where the derived kernel and the shipped one have other outputs.
    """
    (kernel,) = (each for each in _subject(swept.module).module.kernels if each.name == swept.name)
    names = [output.name for output in kernel.outputs]
    scales = [output.relative_to for output in kernel.outputs]
    promised = swept.stated
    if (*names,) != swept.signature.outputs or scales != [each.scale for each in promised]:
        raise ValueError(f"{swept.id} is not what its derivation gives: gainproof generate")
    rows = [*names, *sorted({scale for scale in scales if scale} - {*names})]
    outputs = tuple(
        Compared(name, rows.index(name), rows.index(scale or name), each.lowest, each.highest)
        for name, scale, each in zip(names, scales, promised, strict=True)
    )
    return Reference(replace(kernel, outputs=tuple(Output(row, "") for row in rows)), outputs)


@cache
def _subject(module: str) -> Subject:
    """A subject is called as its module, with hyphens."""
    return build(module.replace("_", "-"))
