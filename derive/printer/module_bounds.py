"""The bounds of a module's kernels, those of one input proved together.

They compute much in common: one program with the outputs of all is walked once for all. Its finer
boxes serve each, so that a bound may be a little better for what stands beside its kernel.
"""

from __future__ import annotations

from collections.abc import Sequence
from dataclasses import replace

from gainproof.derive.printer.bound import Bounds, KernelBound, prove
from gainproof.derive.printer.formats import FORMATS
from gainproof.derive.printer.graph import GraphBuilder, Node, operands
from gainproof.derive.printer.kernel import Kernel, Output


def prove_all(kernels: Sequence[Kernel]) -> list[Bounds]:
    """The bounds of each kernel in float64 and float32.

    PrintingError, naming the kernel and the node, where one cannot be proved.
    """
    found: dict[int, Bounds] = {}
    for places in groups(kernels):
        found |= dict(zip(places, proved([kernels[place] for place in places]), strict=True))
    return [found[place] for place in range(len(kernels))]


def groups(kernels: Sequence[Kernel]) -> list[list[int]]:
    """Places of the kernels that are proved together: those of the same one input; others, and
    those with differences, alone.
    """
    alone: list[list[int]] = []
    joined: dict[str, list[int]] = {}
    for place, kernel in enumerate(kernels):
        if len(kernel.inputs) > 1 or kernel.cancellations:
            alone.append([place])
        else:
            joined.setdefault(repr(kernel.inputs), []).append(place)
    return [*alone, *joined.values()]


def proved(group: Sequence[Kernel]) -> list[Bounds]:
    """The bounds of kernels of one of the `groups`. PrintingError as of `prove_all`."""
    try:
        return _together(group)
    except ValueError:
        # which kernel it is, and at which of its nodes, is said when each is proved by itself
        return [_alone(kernel) for kernel in group]


def _alone(kernel: Kernel) -> Bounds:
    return tuple(prove(kernel, form) for form in FORMATS)


def _together(kernels: Sequence[Kernel]) -> list[Bounds]:
    if len(kernels) == 1:
        return [_alone(kernels[0])]
    bounds = _alone(_joined(kernels))
    return [
        tuple(_part(place, kernel, bound) for bound in bounds)
        for place, kernel in enumerate(kernels)
    ]


def _joined(kernels: Sequence[Kernel]) -> Kernel:
    """One kernel with the outputs of all; what several compute it computes once."""
    builder = GraphBuilder()
    ends: dict[str, Node] = {}
    outputs: list[Output] = []
    for place, kernel in enumerate(kernels):
        made: list[Node] = []
        for node in kernel.graph["nodes"]:
            made.append(builder.operation_of(node, [made[part] for part in operands(node)]))
        ends |= {_named(place, name): made[end] for name, end in kernel.graph["outputs"].items()}
        for output in kernel.outputs:
            scale = output.relative_to
            of_all = None if scale is None else _named(place, scale)
            outputs.append(replace(output, name=_named(place, output.name), relative_to=of_all))
    return replace(kernels[0], outputs=tuple(outputs), graph=builder.graph(ends))


def _part(place: int, kernel: Kernel, bound: KernelBound) -> KernelBound:
    known = {output.name: output for output in bound.outputs}
    own = (replace(known[_named(place, o.name)], name=o.name) for o in kernel.outputs)
    return replace(bound, outputs=tuple(own))


def _named(place: int, output: str) -> str:
    """An output's name among those of all kernels."""
    return f"{place}.{output}"
