"""Choices that are the smaller of two numbers, which NumPy finds in one pass."""

from __future__ import annotations

from fractions import Fraction

from gainproof.derive.printer.formats import FORMATS
from gainproof.derive.printer.program import Program, Step


def is_least(program: Program, step: Step) -> bool:
    """Whether "y1 where x < c, else y2" is the smaller of y1 and y2 for every positive number x.

    So it is where one of both is k and the other is 2^n x before it or m/x after it, and comes to k
    at x = c; c, k and m are numbers of every format. Rounding keeps the order of what it rounds.
    """
    if step.operation != "select":
        return False
    x, limit, below, above = step.operands
    place = _number(program, limit)
    if program.steps[x].operation != "input" or place is None:
        return False
    rising, top = program.affine(below), _number(program, above)
    if rising is not None and rising[:2] == (None, x) and top is not None:
        return Fraction(rising[2]) * place == top
    bottom, falling = _number(program, below), program.steps[above]
    if bottom is None or falling.operation != "div" or falling.operands[1] != x:
        return False
    return _number(program, falling.operands[0]) == bottom * place


def _number(program: Program, number: int) -> Fraction | None:
    """The value of a step that is a positive constant in every format."""
    constant = program.steps[number].constant
    if constant is None or constant.rational is None or constant.rational <= 0:
        return None
    return constant.rational if all(constant.is_exact(form) for form in FORMATS) else None
