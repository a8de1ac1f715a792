"""The true value of a program at one exact input, in balls of any precision."""

from __future__ import annotations

import math
from collections.abc import Callable, Sequence
from fractions import Fraction

import flint

from gainproof.derive.printer.fixed_point_enclosure import chain
from gainproof.derive.printer.formats import Format
from gainproof.derive.printer.library_functions import ball
from gainproof.derive.printer.program import FUNCTIONS, Program, Step
from gainproof.derive.printer.select_conditions import threshold
from gainproof.derive.printer.unrolled_fixed_point import Cycle

GREATEST_PRECISION = 2048

Point = tuple[Fraction, ...]
"""An exact number for each input."""

Balls = Sequence[flint.arb]
Numbers = Sequence[flint.fmpq]
BallOf = Callable[[Balls, Numbers], flint.arb]
"""The ball of a step from those of earlier steps and the exact inputs."""


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
        numbers = [flint.fmpq(x.numerator, x.denominator) for x in point]
        balls: list[flint.arb] = []
        for ball_of in _straight(program, form, precision, last):
            balls.append(ball_of(balls, numbers))
        return balls


def _straight(
    program: Program, form: Format, precision: int, last: int | None = None
) -> Sequence[BallOf]:
    """What computes the balls of the steps up to one, each from those before it; made once, since
    the same program is asked for at thousands of points.
    """
    key = f"balls {form.name} {precision}"
    known: list[BallOf] = program.kept.setdefault(key, [])
    count = len(program.steps) if last is None else last + 1
    roots = {cycle.iterates[-1]: cycle for cycle in program.cycles}
    for number in range(len(known), count):
        if number in roots:
            known.append(_root(program, roots[number], form, precision))
        else:
            known.append(_ball_of(program, program.steps[number], form, precision))
    return known if len(known) == count else known[:count]


def _ball_of(program: Program, step: Step, form: Format, precision: int) -> BallOf:
    """The ball of one step, but for the root of a fixed point."""
    first, second = (*step.operands, -1, -1)[:2]
    if step.scale is not None:
        scale = flint.arb(step.scale)
        return lambda balls, _: balls[first] * scale
    match step.operation:
        case "input":
            axis = program.inputs.index(step.label)
            return lambda _, point: flint.arb(point[axis])
        case "constant":
            assert step.constant is not None
            constant = step.constant.ball(precision)
            return lambda *_: constant
        case "add":
            return lambda balls, _: balls[first] + balls[second]
        case "sub" | "less":
            return lambda balls, _: balls[first] - balls[second]
        case "mul":
            return lambda balls, _: balls[first] * balls[second]
        case "div":
            return lambda balls, _: balls[first] / balls[second]
        case "sqrt":
            return lambda balls, _: balls[first].sqrt()
        case "neg":
            return lambda balls, _: -balls[first]
        case "abs":
            return lambda balls, _: abs(balls[first])
        case "near_cbrt":
            return lambda balls, _: balls[first].root(3)
        case "start" | "iterate":
            return lambda balls, _: balls[first]
        case "select":
            return _choice(program, step, form)
    if step.operation in FUNCTIONS:
        return lambda balls, _: ball(step.operation, [balls[part] for part in step.operands])
    raise ValueError(f"unknown operation {step.operation}")


def _choice(program: Program, step: Step, form: Format) -> BallOf:
    """One of two, by a condition on the one input, which is decided exactly; of several inputs by
    balls, and no number where these do not tell.
    """
    less, than, chosen, other = step.operands
    if len(program.inputs) > 1:

        def by_balls(balls: Balls, _: Numbers) -> flint.arb:
            if balls[less] < balls[than]:
                return balls[chosen]
            return balls[other] if balls[less] >= balls[than] else flint.arb("nan")

        return by_balls
    limit = threshold(program, step, form)
    place = flint.fmpq(limit.place.numerator, limit.place.denominator)

    def by_input(balls: Balls, point: Numbers) -> flint.arb:
        holds = point[0] < place if limit.input_first else place < point[0]
        return balls[chosen if holds else other]

    return by_input


def _root(program: Program, cycle: Cycle, form: Format, precision: int) -> BallOf:
    """A ball that holds the fixed point, and no number if it is not found at this precision.

    From the last Newton step on the map is repeated. A number that the map makes greater lies below
    the one fixed point, one that it makes smaller lies above.
    """
    root = cycle.iterates[-1]
    image = chain(program, root, cycle.map_value)
    newton = program.steps[root].operands[0]
    steps = [
        (number, _ball_of(program, program.steps[number], form, precision))
        for number in image.numbers
    ]

    def found(balls: Balls, point: Numbers) -> flint.arb:
        known = [*balls, *[flint.arb(0)] * (cycle.map_value + 1 - len(balls))]

        def mapped(x: flint.arb) -> flint.arb:
            known[root] = x
            for number, ball_of in steps:
                known[number] = ball_of(known, point)
            return known[cycle.map_value]

        x = flint.arb(balls[newton].mid())
        for _ in range(precision):
            x, before = flint.arb(mapped(x).mid()), x
            if abs(x - before) <= abs(x) * flint.arb(2) ** (8 - precision):
                break
        room = flint.arb(2) ** (16 - precision)
        low, high = x * (1 - room), x * (1 + room)
        if mapped(low) > low and mapped(high) < high:
            return low.union(high)
        return flint.arb("nan")

    return found


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
