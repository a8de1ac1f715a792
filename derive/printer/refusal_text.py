"""Why a bound is refused, in words that name the formula and the input."""

from __future__ import annotations

import numpy as np

from gainproof.derive.printer import boxes
from gainproof.derive.printer.adjoint import Adjoint
from gainproof.derive.printer.domain import greatest_normal
from gainproof.derive.printer.step_ranges import Mask, true_size
from gainproof.derive.printer.step_text import formula


def reason(adjoint: Adjoint, failed: Mask) -> tuple[int, str]:
    """The row of the first output that failed, and where and how its error has no bound."""
    row, box = (int(at[0]) for at in np.nonzero(failed))
    forward = adjoint.forward
    place = f"input {boxes.point_text(forward.grid, box)}"
    several = forward.grid.axes > 1
    low, high = (float(end[0][box]) for end in true_size(forward.values[adjoint.ends[row][1]]))
    if several and not (forward.form.least_normal <= low and high <= greatest_normal(forward.form)):
        return row, (
            f"{place}: its true value or its scale, between {low:.3g} and {high:.3g}, may be "
            "no normal number. Several inputs need a domain where all outputs are normal"
        )
    found: dict[int, str] = {}
    for number, step in enumerate(forward.program.steps):
        value, weight = forward.values[number], adjoint.weights.get(number)
        if weight is None or not weight.is_active(row, box):
            continue
        name = formula(forward.program, number)
        name += f" ({step.label})" if step.label in forward.cancellations else ""
        if found.keys() & set(step.operands):
            continue  # only where it begins
        if value.over is not None and value.over[box]:
            found[number] = f"{name} may overflow"
        elif step.operation == "root" and forward.cycles.complaint(box):
            found[number] = forward.cycles.complaint(box)
        elif value.invalid is not None and value.invalid[box]:
            found[number] = f"{name} divides by, or takes the root of, what is not normal"
        elif value.tiny is not None and value.tiny[box] > 0:
            found[number] = f"{name} may be subnormal or 0"
        elif several and value.loose and value.shares is not None:
            found[number] = f"{name} cancels"
    bounded = f"below {adjoint.upper[row, box] / forward.form.epsilon:.3g} epsilon"
    return row, (
        f"{place}: the true value is a normal number, but the error is not "
        f"{bounded if np.isfinite(adjoint.upper[row, box]) else 'bounded'}: "
        f"{'; '.join(found.values()) or 'ranges too wide'}. "
        "Another order of operations may avoid it"
    )
