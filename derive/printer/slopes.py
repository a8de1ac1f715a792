"""Which kernels of a module are first derivatives of its others, found from their values.

A value that agrees with a derivative to 80 bits at every point is taken for it. What either is was
proved when it was derived; that they belong together is read off here, so that no list of pairs
has to be kept for families, sensors and files of users.
"""

from __future__ import annotations

import math
from collections.abc import Iterator, Sequence
from dataclasses import dataclass, replace
from fractions import Fraction
from functools import cached_property
from random import Random

import flint

from gainproof.derive.printer.constant import constant
from gainproof.derive.printer.exact import Point, enclosures_at
from gainproof.derive.printer.formats import FLOAT64
from gainproof.derive.printer.kernel import Input, Kernel

POINTS, PRECISION = 4, 256
STEP = Fraction(1, 2**60)
"""Of a central difference, over the input: its error is near the square of it."""
AGREED = 2.0**-80
SPREAD = Fraction(1, 2**20), Fraction(2**20)
"""Where points are drawn, if the domain has any there: far apart, so that what is equal in a part
of the domain alone is not taken for a derivative.
"""


@dataclass(frozen=True)
class Slope:
    """The derivative of an output by an input, by their places: `sign` times an output of the
    kernel at place `kernel` in the module.
    """

    output: int
    given: int
    kernel: int
    slope: int
    sign: int


def slopes(kernels: Sequence[Kernel]) -> list[tuple[Slope, ...]]:
    """Of each kernel those derivatives that kernels of the same inputs have. Of several the kernel
    with most of them is taken, then the one with fewest outputs.
    """
    sampled = [_Sampled(kernel) for kernel in kernels]
    return [tuple(_found(each, sampled)) for each in sampled]


class _Sampled:
    """A kernel at points of its inputs: the same for all kernels of these inputs."""

    def __init__(self, kernel: Kernel) -> None:
        self.names = tuple(given.name for given in kernel.inputs)
        self.outputs = [output.name for output in kernel.outputs]
        self.program = replace(kernel.program, inputs=self.names)
        random = Random(" ".join(self.names))
        self.points = [
            tuple(_drawn(random, given) for given in kernel.inputs) for _ in range(POINTS)
        ]
        self.whole = any(given.integer for given in kernel.inputs)

    def at(self, point: Point) -> list[flint.arb]:
        balls = enclosures_at(self.program, point, FLOAT64, PRECISION)
        return [balls[self.program.outputs[name]] for name in self.outputs]

    @cached_property
    def values(self) -> list[list[flint.arb]]:
        """By point and output."""
        return [self.at(point) for point in self.points]

    @cached_property
    def derivatives(self) -> list[list[list[flint.arb]]]:
        """By point, input and output."""
        return [[self._by(point, place) for place in range(len(point))] for point in self.points]

    def _by(self, point: Point, place: int) -> list[flint.arb]:
        step = point[place] * STEP
        ends = [
            (*point[:place], point[place] + each, *point[place + 1 :]) for each in (step, -step)
        ]
        with flint.ctx.workprec(PRECISION):
            over = 2 * flint.fmpq(step.numerator, step.denominator)
            return [(a - b) / over for a, b in zip(*map(self.at, ends), strict=True)]


def _found(kernel: _Sampled, every: Sequence[_Sampled]) -> Iterator[Slope]:
    alike = [place for place, each in enumerate(every) if each.points == kernel.points]
    if kernel.whole:
        return
    known = [
        Slope(output, given, place, slope, sign)
        for given in range(len(kernel.names))
        for output in range(len(kernel.outputs))
        for place in alike
        for slope in range(len(every[place].outputs))
        if (sign := _sign(kernel, output, given, every[place], slope))
    ]
    count = {place: sum(each.kernel == place for each in known) for place in alike}
    known.sort(key=lambda each: (-count[each.kernel], len(every[each.kernel].outputs)))
    taken: dict[tuple[int, int], Slope] = {}
    for each in known:
        taken.setdefault((each.output, each.given), each)
    yield from sorted(taken.values(), key=lambda each: (each.output, each.given))


def _sign(kernel: _Sampled, output: int, given: int, other: _Sampled, slope: int) -> int:
    """1 or -1 where a value is so many times the derivative at every point, else 0."""
    signs = set()
    for derivatives, values in zip(kernel.derivatives, other.values, strict=True):
        wanted, value = derivatives[given][output], values[slope]
        with flint.ctx.workprec(PRECISION):
            if not abs(wanted) > 0:
                return 0
            signs.add(next((s for s in (1, -1) if abs(value * s / wanted - 1) < AGREED), 0))
    return signs.pop() if len(signs) == 1 else 0


def _drawn(random: Random, given: Input) -> Fraction:
    """A number inside of the domain, uniform in the logarithm."""
    low = max(_rational(given.lower), Fraction(FLOAT64.least_normal))
    high = Fraction(FLOAT64.largest) if given.upper is None else _rational(given.upper)
    near = max(low, SPREAD[0]), min(high, SPREAD[1])
    low, high = near if near[0] < near[1] else (low, high)
    drawn = Fraction(math.exp(random.uniform(math.log(low), math.log(high))))
    drawn += (high - drawn) / 2**10 if drawn <= low else (low - drawn) / 2**10
    return -drawn if given.signed and random.random() < 0.5 else drawn


def _rational(limit: object) -> Fraction:
    return Fraction(constant(limit).nearest(FLOAT64))  # type: ignore[arg-type]
