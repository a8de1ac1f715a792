"""How many digits the value of an output may lose where its error is relative to something larger.

A bound holds over a scale S: the error is at most b eps S. Over the value v itself that is
b eps S/|v|, which is large where terms cancel. S/|v| is enclosed over boxes that cover the domain;
a box counts with what is proved of it, so that what is said is never too little. Where no scaling
of the inputs changes the ratio (see `scaling`) boxes are of fewer numbers than there are inputs.
"""

from __future__ import annotations

import itertools
import math
import random
from collections.abc import Iterator, Sequence
from dataclasses import dataclass, replace
from fractions import Fraction
from typing import Protocol

import flint
import numpy as np

from gainproof.derive.printer import boxes as grids
from gainproof.derive.printer.bound import KernelBound, OutputBound
from gainproof.derive.printer.cancellation import cancelling
from gainproof.derive.printer.exact import enclosures_at
from gainproof.derive.printer.formats import Format
from gainproof.derive.printer.forward import Forward
from gainproof.derive.printer.kernel import Kernel, Output, explained
from gainproof.derive.printer.known_values import admitted, scales
from gainproof.derive.printer.lost_digits_text import Axis, Loss, Part, least_rate, lost, power
from gainproof.derive.printer.program import Program
from gainproof.derive.printer.reference import Reference
from gainproof.derive.printer.scaling import Group, groups
from gainproof.derive.printer.signed_inputs import references
from gainproof.derive.printer.step_ranges import true_size
from gainproof.derive.printer.taylor import (
    PRECISION,
    Enclosed,
    Jet,
    Monomials,
    evaluated,
    monomials,
)

DEGREES = {0: (0,), 1: (4, 16), 2: (3, 8), 3: (2, 5)}
"""Of Taylor polynomials in so many variables, of more 2 and 3; the second where the first says
nothing."""
WORK = 30_000  # monomials of all boxes
NEAR = 4.0  # a ratio that need not be known better
WIDE = 2.5  # greatest over least of a side: of wider boxes polynomials say nothing
NARROW = {1: 1e-4, 2: 0.25}  # relative width of boxes that are not halved any more; of more 0.5
POINTS = 96
SMALL = 1e-300
NORMAL = 16.0  # times the least normal number: below, underflow is what the docstring says anyway
WIDEST = 1e30  # of inputs at points that are tried
MORE = 1.0 + 2.0**-30  # than the roundings of a ratio that is passed on


@dataclass(frozen=True)
class Box:
    """Magnitudes from `low` to `high` on each axis, of this sign; 0: the number 0."""

    low: tuple[float, ...]
    high: tuple[float, ...]
    signs: tuple[int, ...]

    def width(self) -> float:
        """The greatest ratio of the ends of a side."""
        return max((b / a for a, b in zip(self.low, self.high, strict=True) if a), default=1.0)

    def halves(self) -> list[Box]:
        """Along the side of the greatest ratio."""
        ratios = [b / a if a else 0.0 for a, b in zip(self.low, self.high, strict=True)]
        axis = ratios.index(max(ratios))
        middle = math.sqrt(self.low[axis]) * math.sqrt(self.high[axis])
        low, high = list(self.low), list(self.high)
        low[axis] = high[axis] = min(max(middle, self.low[axis]), self.high[axis])
        return [replace(self, high=tuple(high)), replace(self, low=tuple(low))]


class Ratio(Protocol):
    """The scale of an output over its value."""

    def most(self, boxes: Sequence[Box]) -> list[float]:
        """At most this anywhere in each box; infinite where nothing is shown."""
        ...

    def least(self, box: Box) -> float:
        """At least this somewhere in the box."""
        ...


@dataclass(frozen=True)
class Asked:
    """One output of a kernel in one format, with what no scaling changes."""

    kernel: Kernel
    output: Output
    form: Format
    program: Program
    known: Sequence[Reference] | None
    ranges: Sequence[tuple[float, float]]
    groups: Sequence[Group]
    ones: Sequence[int]

    @property
    def end(self) -> int:
        """The step of the output."""
        return self.program.outputs[self.output.name]

    def losing(self) -> set[int]:
        """The sums whose terms may cancel."""
        if self.known is not None:
            return {number for number, each in enumerate(self.known) if not each.tight}
        named = self.kernel.cancellations
        return {number for number, step in enumerate(self.program.steps) if step.label in named}

    def at(self, point: Sequence[Fraction]) -> tuple[flint.arb, flint.arb] | None:
        """Value and scale at a point; None where it is not admitted."""
        balls = enclosures_at(self.program, tuple(point), self.form, PRECISION)
        with flint.ctx.workprec(PRECISION):
            if not admitted(self.kernel, self.program, self.known, balls, self.form):
                return None
            value = balls[self.end]
            if self.output.relative_to is not None:
                return value, abs(balls[self.program.outputs[self.output.relative_to]])
            return value, scales(self.program, self.known, balls)[self.end]

    def point(self, box: Box) -> list[Fraction]:
        """The middle of a box, as inputs of which some are 1."""
        point = [Fraction(1)] * len(self.ranges)
        for group, low, high, sign in zip(self.groups, box.low, box.high, box.signs, strict=True):
            middle = math.sqrt(low) * math.sqrt(high)
            point[group.axis] = sign * Fraction(min(max(middle, low), high))
        return point

    def axes(self) -> list[Axis]:
        """The groups with the magnitudes that they take."""
        return [self._axis(group) for group in self.groups]

    def _axis(self, group: Group) -> Axis:
        given = self.kernel.inputs[group.axis]
        low, high = self.ranges[group.axis]
        low = low or self.form.least
        for number, exponent in group.powers:
            ends = [power(end, exponent) for end in self.ranges[number]]
            low, high = low * min(ends) / MORE, high * max(ends) * MORE
        text = group.text([each.name for each in self.kernel.inputs], given.signed)
        return Axis(text, low, high, given.signed, given.zero)

    def reached(self, box: Box) -> bool:
        """Whether inputs may have these groups; not looked at where several are set to 1."""
        if len(self.ones) != 1:
            return True
        (one,) = self.ones
        low, high = (math.log(end) for end in self.ranges[one])
        room = 1e-9
        for group, first, last, sign in zip(self.groups, box.low, box.high, box.signs, strict=True):
            if not group.powers or sign == 0:
                continue
            exponent = float(group.powers[0][1])
            least, most = (math.log(end or self.form.least) for end in self.ranges[group.axis])
            ends = ((math.log(first) - most) / exponent, (math.log(last) - least) / exponent)
            low, high = max(low, min(ends) - room), min(high, max(ends) + room)
        return low <= high


class ByTerms:
    """Of a kernel with signs or functions: Taylor polynomials in balls."""

    def __init__(self, asked: Asked) -> None:
        self.asked = asked
        count = len(asked.groups)
        self.plain = monomials(count, 0)
        self.degrees = DEGREES.get(count, (2, 3))
        self.left = WORK

    def most(self, boxes: Sequence[Box]) -> list[float]:
        """See `Ratio`."""
        return [self._most(box) for box in boxes]

    def _most(self, box: Box) -> float:
        with flint.ctx.workprec(PRECISION):
            return self._enclosed(box)

    def _enclosed(self, box: Box) -> float:
        asked = self.asked
        plain = evaluated(asked.program, self._given(box, self.plain, True), self.plain, asked.end)
        balls = [jet[0][0] for jet in plain]
        scale = scales(asked.program, asked.known, balls)[asked.end]
        ratio = _over(scale, balls[asked.end])
        for degree in self.degrees:
            if ratio < NEAR or box.width() > WIDE or self.left <= 0:
                break
            used = monomials(len(box.low), degree)
            self.left -= len(used.exponents)
            jets = (
                evaluated(asked.program, self._given(box, used, False), used, asked.end),
                evaluated(asked.program, self._given(box, used, True), used, asked.end),
            )
            rooms = [_ball(low, high).rad() for low, high in zip(box.low, box.high, strict=True)]
            enclosed = Enclosed(asked.program, used, jets, [flint.arb(room) for room in rooms])
            ratio = min(ratio, _over(scale, enclosed.least(asked.end)))
            if ratio < math.inf:
                break
        return ratio

    def _given(self, box: Box, used: Monomials, whole: bool) -> list[Jet]:
        """The inputs as polynomials: in the middle of a box, or over the whole of it."""
        given = [used.constant(flint.arb(1)) for _ in self.asked.ranges]
        for place, (group, low, high, sign) in enumerate(
            zip(self.asked.groups, box.low, box.high, box.signs, strict=True)
        ):
            ball = _ball(low, high)
            ball = sign * (ball if whole else flint.arb(ball.mid()))
            given[group.axis] = used.variable(place, ball) if sign else used.constant(flint.arb(0))
        return given

    def least(self, box: Box) -> float:
        """See `Ratio`."""
        return _least(self.asked, box)


class ByScale:
    """Of a kernel of positive inputs and a scale of its own: the ranges of the printer's proofs."""

    def __init__(self, asked: Asked) -> None:
        self.asked = asked

    def most(self, boxes: Sequence[Box]) -> list[float]:
        """See `Ratio`."""
        if not boxes:
            return []
        asked = self.asked
        ends = np.ones((2, len(asked.ranges), len(boxes)))
        for side, name in enumerate(("low", "high")):
            for place, group in enumerate(asked.groups):
                ends[side, group.axis] = [getattr(box, name)[place] for box in boxes]
        with np.errstate(all="ignore"):
            grid = grids.grid(ends[0], ends[1])
            forward = Forward(asked.program, grid, asked.form, asked.kernel.cancellations)
            assert asked.output.relative_to is not None
            scale = asked.program.outputs[asked.output.relative_to]
            value, over = (true_size(forward.values[at]) for at in (asked.end, scale))
            found = over[1][0] / value[0][0] * MORE
            return [float(each) if each >= 1 or each <= 1 else math.inf for each in found]

    def least(self, box: Box) -> float:
        """See `Ratio`."""
        return _least(self.asked, box)


def _ball(low: float, high: float) -> flint.arb:
    """All numbers between."""
    first, last = flint.arb(low), flint.arb(high)
    return (first + last) / 2 + flint.arb(0, ((last - first) / 2).abs_upper())


def _over(scale: flint.arb, value: flint.arb) -> float:
    """The greatest ratio; infinite where nothing is shown."""
    if not scale.is_finite() or not value.is_finite():
        return math.inf
    if scale == 0:
        return 1.0  # nothing is added, nothing is lost
    least = flint.arb(value.abs_lower())
    if not least > 0:
        return math.inf
    found = float((flint.arb(scale.abs_upper()) / least).upper()) * MORE
    return found if found == found else math.inf


def _least(asked: Asked, box: Box) -> float:
    found = asked.at(asked.point(box))
    return 1.0 if found is None else _lower(*found)


def _lower(value: flint.arb, scale: flint.arb) -> float:
    if not value.is_finite() or not scale.is_finite() or scale == 0:
        return 1.0
    with flint.ctx.workprec(PRECISION):
        most = flint.arb(value.abs_upper())
        if most == 0:
            return math.inf
        return max(1.0, float((flint.arb(scale.abs_lower()) / most).lower()) / MORE)


def with_losses(kernel: Kernel, bounds: Sequence[KernelBound]) -> tuple[KernelBound, ...]:
    """The bounds, each that is relative to something larger with what it says of the value."""
    found = []
    for bound in bounds:
        outputs = (
            replace(stated, loss=loss_of(kernel, output, bound, stated))
            if output.by_terms or output.relative_to is not None
            else stated
            for output, stated in zip(kernel.outputs, bound.outputs, strict=True)
        )
        found.append(replace(bound, outputs=tuple(outputs)))
    return tuple(found)


def loss_of(kernel: Kernel, output: Output, bound: KernelBound, stated: OutputBound) -> Loss:
    """What may be lost of one output in one format."""
    asked = _asked(kernel, output, bound, stated)
    form = bound.format
    # where an underflow adds to the error, values beside which it is no larger than the rest
    error = float(stated.bound) * form.epsilon * (2.0 if stated.beside else 1.0)
    quarter_rate, half_rate = (least_rate(form, part) for part in (0.25, 0.5))
    limits = (quarter_rate / error, half_rate / error, 1.0 / error)
    tried = _Tried(asked)
    search = _Search(asked, limits, tried.greatest)
    quarter: Part | None = None
    half: Part | None = None
    if tried.changes and len(asked.groups) > 1:
        search.worst = math.inf  # zeros run through the domain: no ranges tell where
    else:
        search.run()
        quarter, half = search.parts()
    if half is not None and not half.empty and not half.ranges:
        half = None
    place = tried.place
    terms = ""
    if place is not None:
        terms = cancelling(asked.program, asked.end, asked.losing(), place, form, explained(kernel))
    below = stated.beside / (float(stated.bound) * form.epsilon)
    return Loss(
        form,
        lost(min(search.worst, limits[2]) * error, form),
        half,
        quarter,
        min(1.0, 1.0 / limits[1]),
        below if below > NORMAL * form.least_normal else 0.0,
        terms,
    )


def _asked(kernel: Kernel, output: Output, bound: KernelBound, stated: OutputBound) -> Asked:
    names = tuple(given.name for given in kernel.inputs)
    used: Program = replace(kernel.program, inputs=names)
    known: Sequence[Reference] | None = None
    required = [each.name for each in kernel.requirements]
    ends = [used.outputs[name] for name in (output.name, output.relative_to, *required) if name]
    part = _needed(used, ends)
    if output.by_terms:
        every = references(kernel, bound.format)[1]
        known = [every[number] for number in part]
    used = _only(used, part)
    occurring = {used.axis(n) for n, step in enumerate(used.steps) if step.operation == "input"}
    free, ones = groups(used, [not (each.signed or each.zero) for each in kernel.inputs])
    asked = Asked(
        kernel,
        output,
        bound.format,
        used,
        known,
        stated.domain,
        [group for group in free if group.axis in occurring],
        [one for one in ones if one in occurring],
    )
    if all(SMALL < axis.low <= axis.high < 1 / SMALL for axis in asked.axes()):
        return asked
    # products of powers would leave the numbers of float64
    return replace(asked, groups=[Group(axis, ()) for axis in sorted(occurring)], ones=[])


def _needed(program: Program, ends: Sequence[int]) -> list[int]:
    wanted = {*ends, *(cycle.map_value for cycle in program.cycles)}
    for number in range(max(wanted), -1, -1):
        if number in wanted:
            wanted.update(program.steps[number].operands)
    return sorted(wanted)


def _only(program: Program, part: Sequence[int]) -> Program:
    """These steps alone, numbered anew."""
    place = {old: new for new, old in enumerate(part)}
    steps = tuple(
        replace(step, operands=tuple(place[operand] for operand in step.operands))
        for step in (program.steps[number] for number in part)
    )
    outputs = {name: place[end] for name, end in program.outputs.items() if end in place}
    cycles = tuple(cycle.at(place) for cycle in program.cycles)
    return replace(program, steps=steps, outputs=outputs, cycles=cycles)


class _Tried:
    """What is found at points: the greatest ratio, where, and whether the value changes its sign
    between points whose inputs have the same signs.
    """

    def __init__(self, asked: Asked) -> None:
        self.greatest, self.changes = 1.0, False
        self.place: tuple[Fraction, ...] | None = None
        signs: dict[tuple[int, ...], set[bool]] = {}
        for point in _points(asked):
            found = asked.at(point)
            if found is None:
                continue
            value, scale = found
            ratio = _lower(value, scale)
            if self.place is None or ratio > self.greatest:
                self.greatest, self.place = ratio, tuple(point)
            if value > 0 or value < 0:
                orthant = tuple((x > 0) - (x < 0) for x in point)
                signs.setdefault(orthant, set()).add(bool(value > 0))
        self.changes = any(len(each) > 1 for each in signs.values())


def _points(asked: Asked) -> Iterator[list[Fraction]]:
    """Corners of the domain, and numbers of the format between them, the same in every run."""
    draw = random.Random(1)
    ranges = [(max(low, 1 / WIDEST, high * 1e-60), min(high, WIDEST)) for low, high in asked.ranges]
    ranges = [(min(low, high), high) for low, high in ranges]
    if len(ranges) <= 6:
        for corner in itertools.product(*ranges):
            yield [Fraction(x) for x in corner]
    for number in range(POINTS):
        point = []
        for (low, high), given in zip(ranges, asked.kernel.inputs, strict=True):
            x = math.exp(draw.uniform(math.log(low), math.log(high)))
            x = asked.form.nearest(Fraction(min(max(x, low), high)))
            negative = given.signed and draw.random() < 0.5 and number >= POINTS // 2
            point.append(Fraction(-x if negative else x))
        yield point


class _Search:
    """Boxes halved until each is shown to lie below a limit, or has a point above it."""

    def __init__(self, asked: Asked, limits: Sequence[float], greatest: float) -> None:
        self.asked, self.limits, self.greatest = asked, limits, greatest
        self.axes = asked.axes()
        self.ratio: Ratio = ByTerms(asked) if asked.output.by_terms else ByScale(asked)
        self.narrow = 1.0 + NARROW.get(len(self.axes), 0.5)
        self.most_boxes = 20_000 if len(self.axes) < 2 else 8_000
        self.worst = 1.0
        self.kept: tuple[list[Box], list[Box]] = [], []

    def run(self) -> None:
        """Fills `worst` and `kept`."""
        waiting, made = list(self._first()), 0
        while waiting:
            waiting = [box for box in waiting if self.asked.reached(box)]
            made += len(waiting)
            following: list[Box] = []
            for box, most in zip(waiting, self.ratio.most(waiting), strict=True):
                # a quarter is not asked where a half is lost somewhere
                limit = self.limits[self.greatest >= self.limits[1]]
                if most >= limit and made < self.most_boxes and self._open(box, most):
                    following += box.halves()
                else:
                    self._keep(box, most)
            waiting = following

    def _open(self, box: Box, most: float) -> bool:
        """Whether narrower boxes may say more."""
        width = box.width()
        if width <= self.narrow:
            return False
        if width > WIDE:
            return True
        least = self.ratio.least(box)
        self.greatest = max(self.greatest, least)
        known = most <= 10.0 * self.greatest or self.greatest >= self.limits[2]
        asked = self.limits[self.greatest >= self.limits[1] : 2]
        return not known or any(least < limit <= most for limit in asked)

    def _keep(self, box: Box, most: float) -> None:
        self.worst = max(self.worst, most)
        for kept, limit in zip(self.kept, self.limits, strict=False):
            if most >= limit:
                kept.append(box)

    def _first(self) -> Iterator[Box]:
        choices = [
            [1] + ([-1] if axis.signed else []) + ([0] if axis.zero or axis.signed else [])
            for axis in self.axes
        ]
        for signs in itertools.product(*choices):
            ends = list(zip(signs, self.axes, strict=True))
            low = tuple(axis.low if sign else 0.0 for sign, axis in ends)
            high = tuple(axis.high if sign else 0.0 for sign, axis in ends)
            yield Box(low, high, signs)

    def parts(self) -> tuple[Part, ...]:
        """Where a quarter and where a half of the digits, or more, are lost."""
        return tuple(Part.of(self.axes, [(b.low, b.high) for b in kept]) for kept in self.kept)
