"""The true value of a program at one exact input, in balls of any precision."""

from __future__ import annotations

import math
from collections import ChainMap
from collections.abc import Callable, Mapping, Sequence
from fractions import Fraction

import flint

from gainproof.derive.printer.enclosed import chain
from gainproof.derive.printer.formats import Format
from gainproof.derive.printer.library import ball
from gainproof.derive.printer.program import FUNCTIONS, Program, Step
from gainproof.derive.printer.threshold import threshold
from gainproof.derive.printer.unrolled import Cycle

GREATEST_PRECISION = 2048

Point = tuple[Fraction, ...]
"""An exact number for each input."""


def enclosures(
    program: Program, x: float, form: Format, precision: int, last: int | None = None
) -> list[flint.arb]:
    """Balls of all steps at an input of the format, or of those up to the `last` that is wanted.

    A branch that is not chosen may hold no number.
    """
    return enclosures_at(program, (Fraction(x),), form, precision, last)


def enclosures_at(
    program: Program, point: Point, form: Format, precision: int, last: int | None = None
) -> list[flint.arb]:
    """The same at numbers of the format for any number of inputs, in their order."""
    with flint.ctx.workprec(precision):
        balls: list[flint.arb] = []
        roots = {cycle.iterates[-1]: cycle for cycle in program.cycles}
        for number, step in enumerate(program.steps[: None if last is None else last + 1]):
            if number in roots:
                balls.append(_root(program, roots[number], balls, point, form, precision))
                continue
            balls.append(_ball(program, step, balls, point, form, precision))
        return balls


def _ball(
    program: Program,
    step: Step,
    balls: Mapping[int, flint.arb] | Sequence[flint.arb],
    point: Point,
    form: Format,
    precision: int,
) -> flint.arb:
    """The ball of one step, but for the root of a fixed point."""
    parts = [balls[part] for part in step.operands]
    if step.scale is not None:
        return parts[0] * flint.arb(step.scale)
    match step.operation:
        case "input":
            x = point[program.inputs.index(step.label)]
            return flint.arb(flint.fmpq(x.numerator, x.denominator))
        case "constant":
            assert step.constant is not None
            return step.constant.ball(precision)
        case "add":
            return parts[0] + parts[1]
        case "sub" | "less":
            return parts[0] - parts[1]
        case "mul":
            return parts[0] * parts[1]
        case "div":
            return parts[0] / parts[1]
        case "sqrt":
            return parts[0].sqrt()
        case "neg":
            return -parts[0]
        case "abs":
            return abs(parts[0])
        case "near_cbrt":
            return parts[0].root(3)
        case "start" | "iterate":
            return parts[0]
        case "select" if len(point) > 1:
            if parts[0] < parts[1]:
                return parts[2]
            return parts[3] if parts[0] >= parts[1] else flint.arb("nan")
        case "select":
            limit = threshold(program, step, form)
            (only,) = list(point)
            scaled, value = only * Fraction(limit.factor), Fraction(limit.value)
            holds = scaled < value if limit.input_first else value < scaled
            return parts[2] if holds else parts[3]
    if step.operation in FUNCTIONS:
        return ball(step.operation, parts)
    raise ValueError(f"unknown operation {step.operation}")


def _root(
    program: Program,
    cycle: Cycle,
    balls: Sequence[flint.arb],
    point: Point,
    form: Format,
    precision: int,
) -> flint.arb:
    """A ball that holds the fixed point, and no number if it is not found at this precision.

    From the last Newton step on the map is repeated. A number that the map makes greater lies below
    the one fixed point, one that it makes smaller lies above.
    """
    root = cycle.iterates[-1]
    image = chain(program, root, cycle.map_value)

    def mapped(x: flint.arb) -> flint.arb:
        known = ChainMap({root: x}, dict(enumerate(balls)))
        for number in image.numbers:
            known[number] = _ball(program, program.steps[number], known, point, form, precision)
        return known[cycle.map_value]

    x = flint.arb(balls[program.steps[root].operands[0]].mid())
    for _ in range(precision):
        x, before = flint.arb(mapped(x).mid()), x
        if abs(x - before) <= abs(x) * flint.arb(2) ** (8 - precision):
            break
    room = flint.arb(2) ** (16 - precision)
    low, high = x * (1 - room), x * (1 + room)
    if mapped(low) > low and mapped(high) < high:
        return low.union(high)
    return flint.arb("nan")


def is_normal(program: Program, number: int, x: float, form: Format, top: float) -> bool:
    """Whether a step's true magnitude lies between the least normal number and `top`.

    Precision is doubled until the ball decides; a ball that still holds a limit at 2048 bits is
    taken to be equal to it, which is normal.
    """
    precision = 64
    while True:
        size = abs(enclosures(program, x, form, precision, number)[number])
        low, high = flint.arb(form.least_normal), flint.arb(top)
        if size >= low and size <= high:
            return True
        if size < low or size > high:
            return False
        if precision >= GREATEST_PRECISION:
            return True
        precision *= 2


def crossing(
    program: Program, number: int, inside: float, outside: float, form: Format, top: float
) -> float:
    """About where a step's magnitude ceases to be normal: a guess, as if it were a power of x.

    Not a number where there is no telling.
    """
    with flint.ctx.workprec(128):
        sizes = [abs(enclosures(program, x, form, 128, number)[number]) for x in (inside, outside)]
        limit = flint.arb(form.least_normal if sizes[1] < sizes[0] else top)
        places = [flint.arb(x).log() for x in (inside, outside)]
        over, under = (limit / sizes[0]).log(), (sizes[1] / sizes[0]).log()
        return float((places[0] + (places[1] - places[0]) * over / under).exp().mid())


def last_that_holds(
    holds: Callable[[float], bool],
    inside: float,
    outside: float,
    form: Format,
    guess: float = math.nan,
) -> float:
    """The number of the format farthest from `inside` towards `outside` where `holds` still does.

    `holds` is true at `inside`, false at `outside`, and changes once between them; a good `guess`
    of the place saves most of the bisection.
    """
    near, far = form.ordinal(inside), form.ordinal(outside)
    least, most = sorted((near, far))
    middle = form.ordinal(guess) if math.isfinite(guess) else least
    step = 1 if far > near else -1
    while least < middle < most:
        if holds(form.from_ordinal(middle)):
            near, middle = middle, middle + step
        else:
            far, middle = middle, middle - step
        step *= 4
        least, most = sorted((near, far))
    while abs(far - near) > 1:
        middle = (near + far) // 2
        if holds(form.from_ordinal(middle)):
            near = middle
        else:
            far = middle
    return form.from_ordinal(near)
