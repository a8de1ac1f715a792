"""A program of one input between two places where its choices change: what is chosen there."""

from __future__ import annotations

from collections.abc import Iterator
from dataclasses import replace
from fractions import Fraction
from itertools import pairwise

from gainproof.derive.printer.formats import FLOAT64
from gainproof.derive.printer.program import Program, Step
from gainproof.derive.printer.select_conditions import threshold

Domain = tuple[Fraction, Fraction]


def branches(program: Program, domain: Domain) -> Iterator[tuple[Domain, Program]]:
    """The domain in parts, each with a program that chooses nothing.

    A part ends where the next begins; at that number both branches are looked at.
    """
    choices = [step for step in program.steps if step.operation == "select"]
    places = {threshold(program, step, FLOAT64).place for step in choices}
    inner = sorted(place for place in places if domain[0] < place < domain[1])
    for low, high in pairwise([domain[0], *inner, domain[1]]):
        yield (low, high), _chosen(program, low)


def _chosen(program: Program, low: Fraction) -> Program:
    """Each choice replaced by its operand for inputs above `low` and below the next place."""
    same = list(range(len(program.steps)))
    for number, step in enumerate(program.steps):
        if step.operation == "select":
            same[number] = same[_branch(program, step, low)]
    steps = tuple(
        replace(step, operands=tuple(same[part] for part in step.operands))
        for step in program.steps
    )
    outputs = {name: same[end] for name, end in program.outputs.items()}
    return replace(program, steps=steps, outputs=outputs)


def _branch(program: Program, step: Step, low: Fraction) -> int:
    limit = threshold(program, step, FLOAT64)
    below, above = step.operands[2:] if limit.input_first else reversed(step.operands[2:])
    return below if low < limit.place else above
