"""The true value of a program at one exact input, in balls of any precision."""

from __future__ import annotations

from collections.abc import Callable
from fractions import Fraction

import flint

from gainproof.derive.printer.formats import Format
from gainproof.derive.printer.program import Program
from gainproof.derive.printer.threshold import threshold

GREATEST_PRECISION = 2048


def enclosures(program: Program, x: float, form: Format, precision: int) -> list[flint.arb]:
    """Balls of all steps at an input of the format; a branch not chosen may hold no number."""
    point = Fraction(x)
    with flint.ctx.workprec(precision):
        balls: list[flint.arb] = []
        for step in program.steps:
            parts = [balls[part] for part in step.operands]
            if step.scale is not None:
                balls.append(parts[0] * flint.arb(step.scale))
                continue
            match step.operation:
                case "input":
                    ball = flint.arb(flint.fmpq(point.numerator, point.denominator))
                case "constant":
                    assert step.constant is not None
                    ball = step.constant.ball(precision)
                case "add":
                    ball = parts[0] + parts[1]
                case "sub":
                    ball = parts[0] - parts[1]
                case "mul":
                    ball = parts[0] * parts[1]
                case "div":
                    ball = parts[0] / parts[1]
                case "sqrt":
                    ball = parts[0].sqrt()
                case "neg":
                    ball = -parts[0]
                case "abs":
                    ball = abs(parts[0])
                case "select":
                    limit = threshold(program, step, form)
                    scaled, value = point * Fraction(limit.factor), Fraction(limit.value)
                    holds = scaled < value if limit.input_first else value < scaled
                    ball = parts[2] if holds else parts[3]
                case _:
                    raise ValueError(f"unknown operation {step.operation}")
            balls.append(ball)
        return balls


def is_normal(program: Program, number: int, x: float, form: Format, top: float) -> bool:
    """Whether a step's true magnitude lies between the least normal number and `top`.

    Precision is doubled until the ball decides; a ball that still holds a limit at 2048 bits is
    taken to be equal to it, which is normal.
    """
    precision = 64
    while True:
        size = abs(enclosures(program, x, form, precision)[number])
        low, high = flint.arb(form.least_normal), flint.arb(top)
        if size >= low and size <= high:
            return True
        if size < low or size > high:
            return False
        if precision >= GREATEST_PRECISION:
            return True
        precision *= 2


def last_that_holds(
    holds: Callable[[float], bool], inside: float, outside: float, form: Format
) -> float:
    """The number of the format farthest from `inside` towards `outside` where `holds` still does.

    `holds` is true at `inside`, false at `outside`, and changes once between them.
    """
    near, far = form.ordinal(inside), form.ordinal(outside)
    while abs(far - near) > 1:
        middle = (near + far) // 2
        if holds(form.from_ordinal(middle)):
            near = middle
        else:
            far = middle
    return form.from_ordinal(near)
