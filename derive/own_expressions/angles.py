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
from gainproof.derive.printer.signed_inputs import known_steps
from gainproof.derive.printer.step_text import formula

SOUTH = (
    "where y = 0 and x < 0 the sign of the zero decides between pi and -pi for atan2(y, x):",
    "bounds are of the one that it gives",
)
UNSURE = (
    "where x < 0 and y is within its error of 0 its computed sign decides between angles",
    "near pi and near -pi for atan2(y, x): bounds are up to a whole turn",
)
TERMS = (
    "terms of an angle atan2(y, x) are its magnitude and (Y |x| + X |y|)/(x^2 + y^2), with",
    "the terms Y of y and X of x taken positive",
)


def with_angles(kernel: Kernel) -> Kernel:
    """The kernel of functions or signed inputs, with a sentence on angles whose sign a zero
    decides.

    ExpressionError where both arguments of an atan2 may be 0.
    """
    angles = list(_angles(kernel))
    for over, under, apart, text in angles:
        if over.zero and under.zero and not apart:
            raise ExpressionError(
                f"{kernel.name}: atan2 has no value where both of its arguments are 0, as the "
                "domain admits; wanted: a domain in which one of them is not 0, such as one that "
                f"is not signed, or the condition {text} > 0"
            )
    said: list[str] = []
    in_south = [over.tight for over, under, _, _ in angles if over.zero and under.sign <= 0]
    if in_south:
        said += SOUTH if all(in_south) else UNSURE
    if not all(over.tight and under.tight for over, under, _, _ in angles):
        said += TERMS
    return replace(kernel, equations=(*kernel.equations, *said)) if said else kernel


def _angles(kernel: Kernel) -> Iterator[tuple[Reference, Reference, float, str]]:
    """What is known of both arguments of each atan2, in every format, what the root of the sum of
    their squares is at least, and that sum as a formula.
    """
    for form in FORMATS:
        found = known_steps(kernel, form)
        for step in found.program.steps:
            if step.operation == "atan2":
                over, under = (found.steps[part] for part in step.operands)
                texts = (f"({formula(found.program, part)})**2" for part in step.operands)
                yield over, under, found.apart(*step.operands), " + ".join(texts)
