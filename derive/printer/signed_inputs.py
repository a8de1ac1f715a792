"""The bounds of kernels whose inputs have signs, or which call functions of a library."""

from __future__ import annotations

from dataclasses import replace

import numpy as np

from gainproof.derive.printer.domain import product
from gainproof.derive.printer.formats import Format
from gainproof.derive.printer.interval import SLACK
from gainproof.derive.printer.kernel import Kernel
from gainproof.derive.printer.program import FUNCTIONS, Program
from gainproof.derive.printer.proof import Settled
from gainproof.derive.printer.reference import Reference
from gainproof.derive.printer.reference_steps import References
from gainproof.derive.printer.step_ranges import PrintingError


def has_signs(kernel: Kernel) -> bool:
    """Whether a kernel is one of those, or asks something of its inputs together, of which boxes of
    positive numbers say nothing; or is to be bounded as they are.
    """
    calls = any(node[0] == "call" and node[1] in FUNCTIONS for node in kernel.graph["nodes"])
    by_steps = calls or kernel.stepwise or bool(kernel.requirements)
    return by_steps or any(given.signed for given in kernel.inputs)


def by_reference(kernel: Kernel, form: Format) -> Settled:
    """Bounds of every output on the whole domain.

    PrintingError, naming the node, for what may overflow, for a division by what may be 0, and for
    an output whose terms may cancel and that is not said to be measured by them.
    """
    box = product(kernel.inputs, form)
    used, steps = references(kernel, form)
    bounds, beside = [], []
    for output in kernel.outputs:
        if output.relative_to is not None:
            raise PrintingError(f"output {output.name}: its own value or its terms are its scale")
        found = steps[used.outputs[output.name]]
        if found.tight is output.by_terms:
            what = "may cancel, and is not" if output.by_terms is False else "cannot cancel, and is"
            raise PrintingError(f"output {output.name} {what} measured by its terms")
        bounds.append(_bound(found, form))
        beside.append(found.stray)
    return Settled(box, [box for _ in bounds], np.array(bounds), {}, 0, tuple(beside))


def references(kernel: Kernel, form: Format) -> tuple[Program, list[Reference]]:
    """The steps of a kernel over its inputs in their order, and what is known of each."""
    found = known_steps(kernel, form)
    return found.program, found.steps


def known_steps(kernel: Kernel, form: Format) -> References:
    """The same with what is known of them together."""
    names = tuple(given.name for given in kernel.inputs)
    used = kernel.program
    if not set(used.inputs) <= set(names):
        raise PrintingError(f"the graph has inputs {used.inputs}, the kernel has {names}")
    used = replace(used, inputs=names)
    signs = [0 if given.signed else 1 for given in kernel.inputs]
    zeros = [given.zero for given in kernel.inputs]
    found = References(used, form, product(kernel.inputs, form), signs, zeros)
    found.run(kernel.requirements)
    return found


def _bound(found: Reference, form: Format) -> float:
    """(1 - u)^-n - 1 <= n u/(1 - n u)."""
    small = found.count * form.unit_roundoff
    return small / (1.0 - small) * SLACK
