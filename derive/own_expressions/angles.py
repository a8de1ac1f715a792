"""What the angles of a user's kernel are where an argument of atan2 is 0.

Where both arguments are 0 an angle has no value; NumPy and C answer by the signs of the zeros: 0,
pi or their negatives. A bound says nothing there, so that a domain that admits it is refused. Where
the first alone is 0 and the second is negative, the angle is pi, or by the sign of a zero -pi: that
is one direction, and what is printed says so.
"""

from __future__ import annotations

from collections.abc import Iterator
from dataclasses import replace

from gainproof.derive.own_expressions.expressions import ExpressionError
from gainproof.derive.printer.formats import FORMATS
from gainproof.derive.printer.kernel import Kernel
from gainproof.derive.printer.reference import Reference
from gainproof.derive.printer.signed_inputs import references

SOUTH = (
    "where y = 0 and x < 0 the sign of the zero decides between pi and -pi for atan2(y, x): bounds",
    "are of the one that it gives",
)


def with_angles(kernel: Kernel) -> Kernel:
    """The kernel of functions or signed inputs, with a sentence on angles whose sign a zero
    decides.

    ExpressionError where both arguments of an atan2 may be 0.
    """
    angles = list(_angles(kernel))
    if any(over.zero and under.zero for over, under in angles):
        raise ExpressionError(
            f"{kernel.name}: atan2 has no value where both of its arguments are 0, as the domain "
            "admits; wanted: a domain in which one of them is not 0, such as one that is not signed"
        )
    if any(over.zero and under.sign <= 0 for over, under in angles):
        return replace(kernel, equations=(*kernel.equations, *SOUTH))
    return kernel


def _angles(kernel: Kernel) -> Iterator[tuple[Reference, Reference]]:
    """What is known of both arguments of each atan2, in every format."""
    for form in FORMATS:
        used, known = references(kernel, form)
        for step in used.steps:
            if step.operation == "atan2":
                over, under = step.operands
                yield known[over], known[under]
