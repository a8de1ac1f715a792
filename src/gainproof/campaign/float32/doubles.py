"""The graph of a kernel evaluated in double precision by NumPy, step by step."""

from __future__ import annotations

from collections.abc import Callable, Iterator
from typing import Any

import numpy as np
from numpy.typing import NDArray

from gainproof.derive.printer.affine import in_two_parts
from gainproof.derive.printer.arithmetic import UFUNC
from gainproof.derive.printer.formats import FLOAT64, FORMATS
from gainproof.derive.printer.kernel import Kernel
from gainproof.derive.printer.printed_program import plain
from gainproof.derive.printer.program import Program
from gainproof.derive.printer.register_plan import late
from gainproof.derive.printer.select_conditions import threshold
from gainproof.generated._bits import near_cbrt

Doubles = NDArray[np.float64]


def evaluator(kernel: Kernel) -> Callable[[Doubles], list[Doubles]]:
    """The outputs of a kernel of one input, from inputs; rounded as in the float64 kernel."""
    steps = plain(kernel.program)
    ends = [steps.outputs[output.name] for output in kernel.outputs]
    order = late(steps, ends)

    def evaluated(x: Doubles) -> list[Doubles]:
        values: dict[int, Any] = dict(_given(steps, x))
        for number in order:
            values[number] = _step(steps, number, values)
        return [np.broadcast_to(values[end], x.shape) for end in ends]

    return evaluated


def _given(steps: Program, x: Doubles) -> Iterator[tuple[int, Doubles | float]]:
    """The input and the constants."""
    for number, step in enumerate(steps.steps):
        if step.operation == "input":
            yield number, x
        elif step.constant is not None:
            yield number, step.constant.nearest(FLOAT64)


def _step(steps: Program, number: int, values: dict[int, Any]) -> Doubles:
    step = steps.steps[number]
    parts = [values[part] for part in step.operands]
    value: Doubles
    if step.scale is not None:
        value = parts[0] * step.scale
    elif step.operation == "near_cbrt":
        value = np.empty_like(parts[0])
        near_cbrt(parts[0], value, single=False)
    elif step.operation == "select":
        limit = threshold(steps, step, FLOAT64)
        ahead = parts[0] < limit.value if limit.input_first else limit.value < parts[1]
        value = np.where(ahead, parts[2], parts[3])
    else:
        value = getattr(np, UFUNC[step.operation])(*parts)
        affine = in_two_parts(steps, number)
        if affine is not None:
            found = affine[FORMATS.index(FLOAT64)]
            value = value + found.sign * found.constant.remainder(FLOAT64)
    return value
