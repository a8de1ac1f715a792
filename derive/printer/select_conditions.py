"""Conditions of select steps: an exact input against a constant, decided without error."""

from __future__ import annotations

from dataclasses import dataclass
from fractions import Fraction

from gainproof.derive.printer.formats import Format
from gainproof.derive.printer.program import Program, Step
from gainproof.derive.printer.step_ranges import PrintingError


@dataclass(frozen=True)
class Threshold:
    """A condition factor * input < value, or value < factor * input, on numbers of the format."""

    source: int
    factor: float
    value: float
    input_first: bool
    place: Fraction


def threshold(program: Program, step: Step, form: Format) -> Threshold:
    """The condition of a select step; PrintingError unless it compares an input with a constant."""
    first, second = (program.affine(part) for part in step.operands[:2])
    if first is None or second is None or (first[0] is None) == (second[0] is None):
        raise PrintingError(
            f"node {step.node}: select compares exact things only, an input with a constant"
        )
    input_first = first[0] is None
    source, value = (first, second) if input_first else (second, first)
    assert value[0] is not None
    if value[2] < 0 or source[2] < 0:
        raise PrintingError(f"node {step.node}: select with a negated operand")
    limit = value[0].at_least(form) if input_first else value[0].at_most(form)
    return Threshold(
        source[1], source[2], limit, input_first, Fraction(limit) / Fraction(source[2])
    )
