"""Which terms of a program cancel at a point, as a formula over its inputs."""

from __future__ import annotations

import math
from collections.abc import Collection, Sequence
from fractions import Fraction

import flint

from gainproof.derive.printer.exact import enclosures_at
from gainproof.derive.printer.formats import Format
from gainproof.derive.printer.program import Program
from gainproof.derive.printer.step_text import GAP, PART, formula
from gainproof.derive.printer.taylor import PRECISION

WHOLE = 320  # of a sum's formula without gaps
CANCELS = 1.001  # times as large as their sum: terms of both signs


def cancelling(
    program: Program,
    end: int,
    losing: Collection[int],
    place: Sequence[Fraction],
    form: Format,
    known: Collection[str],
) -> str:
    """The sum whose terms exceed it most at a point, of those that an output is made of and that
    are `losing` digits (a difference of exact numbers loses none); "" where no terms do, or where
    they are too long and have no name of those that are `known`.
    """
    balls = enclosures_at(program, tuple(place), form, PRECISION, end)
    worst, ratio = end, 0.0
    wanted, inner = {end}, set[int]()
    for number in range(end, -1, -1):
        if number not in wanted:
            continue
        step = program.steps[number]
        wanted.update(step.operands)
        if step.operation not in ("add", "sub") or number not in losing:
            continue
        inner.update(
            part for part in step.operands if program.steps[part].operation in ("add", "sub")
        )
        if number in inner:
            continue
        with flint.ctx.workprec(PRECISION):
            size, value = (
                sum((abs(balls[n]) for n in _terms(program, number)), flint.arb(0)),
                balls[number],
            )
            found = math.inf if value.contains(0) else float(abs(size / value).mid())
        if found > 2.0 * ratio:
            worst, ratio = number, found
    return _told(program, worst, known) if ratio >= CANCELS else ""


def _told(program: Program, number: int, known: Collection[str]) -> str:
    """The sum in whole, or as terms of what is known, or with parts left out of it."""
    text, label = formula(program, number, known, WHOLE), program.steps[number].label
    if GAP not in text:
        return text
    if label and not PART.match(label):
        # a name that the kernel's author gave: of such long sums parts alone say nothing
        return f"the terms of {label}" if label in known else ""
    short = formula(program, number, known)
    return "" if short == GAP else short


def _terms(program: Program, number: int) -> list[int]:
    step = program.steps[number]
    if step.operation not in ("add", "sub"):
        return [number]
    return [term for part in step.operands for term in _terms(program, part)]
