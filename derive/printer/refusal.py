"""Why a bound is refused, in words that name the node and the input."""

from __future__ import annotations

import numpy as np

from gainproof.derive.printer.adjoint import Adjoint
from gainproof.derive.printer.value import Mask


def reason(adjoint: Adjoint, failed: Mask) -> tuple[int, str]:
    """The row of the first output that failed, and where and how its error has no bound."""
    row, box = (int(at[0]) for at in np.nonzero(failed))
    forward = adjoint.forward
    found: dict[int, str] = {}
    for number, step in enumerate(forward.program.steps):
        value, weight = forward.values[number], adjoint.weights.get(number)
        if weight is None or not weight.active[row, box]:
            continue
        name = f"node {step.node} ({step.label or step.operation})"
        if found.keys() & set(step.operands):
            continue  # only where it begins
        if value.over is not None and value.over[box]:
            found[number] = f"{name} may overflow"
        elif value.invalid is not None and value.invalid[box]:
            found[number] = f"{name} divides by, or takes the root of, what is not normal"
        elif value.tiny is not None and value.tiny[box] > 0:
            found[number] = f"{name} may be subnormal or 0"
    return row, (
        f"input {float(forward.grid.low[box])!r}: the true value is a normal number, but the "
        f"error is not bounded: {'; '.join(found.values()) or 'ranges too wide'}. "
        "Another order of operations may avoid it"
    )
