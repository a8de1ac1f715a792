"""Taylor polynomials in several variables whose coefficients are balls: programs over boxes.

Where large terms cancel to order m, ranges of the terms say nothing of their sum unless a box is
narrower than what is left. The polynomial of a higher order at the box's centre does: in its
coefficients the terms have cancelled already, and the rest of Taylor's formula, its coefficients of
the highest degree over the whole box, is as small as a power of the box's width.
"""

from __future__ import annotations

import itertools
from collections.abc import Sequence
from dataclasses import dataclass, field
from functools import lru_cache

import flint

from gainproof.derive.printer.library_functions import ball
from gainproof.derive.printer.program import Program

Jet = list[dict[int, flint.arb]]
"""Coefficients by number of the monomial, a dictionary a degree; those that are 0 are absent."""

PRECISION = 256  # bits: cancellation beyond those of any format is still seen


@dataclass(frozen=True)
class Monomials:
    """Those of so many variables up to a degree: exponents, and the number of each product."""

    variables: int
    degree: int
    exponents: tuple[tuple[int, ...], ...] = field(init=False)
    products: tuple[dict[int, int], ...] = field(init=False, repr=False)

    def __post_init__(self) -> None:
        choices = itertools.product(range(self.degree + 1), repeat=self.variables)
        found = sorted((e for e in choices if sum(e) <= self.degree), key=lambda e: (sum(e), e))
        place = {exponents: number for number, exponents in enumerate(found)}
        products: list[dict[int, int]] = []
        for first in found:
            row = {}
            for number, second in enumerate(found):
                both = tuple(map(sum, zip(first, second, strict=True)))
                if both in place:
                    row[number] = place[both]
            products.append(row)
        object.__setattr__(self, "exponents", tuple(found))
        object.__setattr__(self, "products", tuple(products))

    def constant(self, value: flint.arb) -> Jet:
        """A number."""
        return [{0: value}, *({} for _ in range(self.degree))]

    def variable(self, number: int, value: flint.arb) -> Jet:
        """`value` plus the variable of this number."""
        jet = self.constant(value)
        if self.degree:
            wanted = tuple(int(axis == number) for axis in range(self.variables))
            jet[1] = {self.exponents.index(wanted): flint.arb(1)}
        return jet

    def sizes(self, rooms: Sequence[flint.arb]) -> list[flint.arb]:
        """The greatest magnitude of each monomial where variables are at most `rooms`."""
        found = []
        for exponents in self.exponents:
            size = flint.arb(1)
            for room, power in zip(rooms, exponents, strict=True):
                size *= room**power
            found.append(size)
        return found

    def _into(
        self,
        total: dict[int, flint.arb],
        a: dict[int, flint.arb],
        b: dict[int, flint.arb],
        factor: int = 1,
    ) -> None:
        for i, x in a.items():
            row, scaled = self.products[i], x if factor == 1 else factor * x
            for j, y in b.items():
                place = row[j]
                old = total.get(place)
                total[place] = scaled * y if old is None else old + scaled * y

    def multiply(self, a: Jet, b: Jet) -> Jet:
        """The product."""
        made: Jet = []
        for degree in range(self.degree + 1):
            total: dict[int, flint.arb] = {}
            for j in range(degree + 1):
                self._into(total, a[j], b[degree - j])
            made.append(total)
        return made

    def divide(self, a: Jet, b: Jet) -> Jet:
        """The quotient; no number where the divisor's ball holds 0."""
        made: Jet = []
        for degree in range(self.degree + 1):
            total = dict(a[degree])
            for j in range(1, degree + 1):
                self._into(total, b[j], made[degree - j], -1)
            made.append({i: x / b[0][0] for i, x in total.items()})
        return made

    def root(self, a: Jet) -> Jet:
        """The square root."""
        first = a[0][0].sqrt()
        made: Jet = [{0: first}]
        for degree in range(1, self.degree + 1):
            total = dict(a[degree])
            for j in range(1, degree):
                self._into(total, made[j], made[degree - j], -1)
            made.append({i: x / (2 * first) for i, x in total.items()})
        return made

    def _slopes(self, a: Jet) -> Jet:
        """Each part of a polynomial times its degree."""
        return [{i: degree * x for i, x in part.items()} for degree, part in enumerate(a)]

    def _integral(self, a: Jet, first: flint.arb) -> Jet:
        """Of which `a` are the parts times their degrees."""
        later = ({i: x / d for i, x in part.items()} for d, part in enumerate(a) if d)
        return [{0: first}, *later]

    def _exponential(self, a: Jet) -> Jet:
        slopes = self._slopes(a)
        made: Jet = [{0: a[0][0].exp()}]
        for degree in range(1, self.degree + 1):
            total: dict[int, flint.arb] = {}
            for j in range(1, degree + 1):
                self._into(total, slopes[j], made[degree - j])
            made.append({i: x / degree for i, x in total.items()})
        return made

    def _turned(self, a: Jet) -> tuple[Jet, Jet]:
        """Sine and cosine."""
        slopes = self._slopes(a)
        sine: Jet = [{0: a[0][0].sin()}]
        cosine: Jet = [{0: a[0][0].cos()}]
        for degree in range(1, self.degree + 1):
            up: dict[int, flint.arb] = {}
            down: dict[int, flint.arb] = {}
            for j in range(1, degree + 1):
                self._into(up, slopes[j], cosine[degree - j])
                self._into(down, slopes[j], sine[degree - j], -1)
            sine.append({i: x / degree for i, x in up.items()})
            cosine.append({i: x / degree for i, x in down.items()})
        return sine, cosine

    def call(self, name: str, parts: Sequence[Jet]) -> Jet:
        """A function of a library."""
        first = parts[0]
        value = ball(name, [part[0][0] for part in parts])
        match name:
            case "exp" | "expm1":
                return [{0: value}, *self._exponential(first)[1:]]
            case "sin":
                return self._turned(first)[0]
            case "cos":
                return self._turned(first)[1]
            case "log1p":
                under = [{0: 1 + first[0][0]}, *first[1:]]
                return self._integral(self.divide(self._slopes(first), under), value)
            case "hypot":
                return self.root(added(*(self.multiply(part, part) for part in parts)))
            case "atan2":
                over, under = parts
                turn = added(
                    self.multiply(under, self._slopes(over)),
                    negated(self.multiply(over, self._slopes(under))),
                )
                square = added(self.multiply(over, over), self.multiply(under, under))
                return self._integral(self.divide(turn, square), value)
        raise ValueError(f"unknown function {name}")


@lru_cache(maxsize=32)
def monomials(variables: int, degree: int) -> Monomials:
    """The same ones for all programs."""
    return Monomials(variables, degree)


def negated(a: Jet) -> Jet:
    """The polynomial times -1."""
    return [{i: -x for i, x in part.items()} for part in a]


def added(a: Jet, b: Jet) -> Jet:
    """The sum of two polynomials."""
    made: Jet = []
    for first, second in zip(a, b, strict=True):
        both = dict(first)
        for i, x in second.items():
            both[i] = both[i] + x if i in both else x
        made.append(both)
    return made


def evaluated(program: Program, given: Sequence[Jet], used: Monomials, end: int) -> list[Jet]:
    """The steps of a program up to one, its inputs these polynomials.

    ValueError for a step that is no analytic function. An absolute value whose operand's ball holds
    0 is no number.
    """
    made: list[Jet] = []
    for step in program.steps[: end + 1]:
        parts = [made[part] for part in step.operands]
        if step.scale is not None:
            scale = flint.arb(step.scale)
            made.append([{i: scale * x for i, x in part.items()} for part in parts[0]])
            continue
        match step.operation:
            case "input":
                made.append(given[program.inputs.index(step.label)])
            case "constant":
                assert step.constant is not None
                made.append(used.constant(step.constant.ball(PRECISION)))
            case "add":
                made.append(added(*parts))
            case "sub":
                made.append(added(parts[0], negated(parts[1])))
            case "mul":
                made.append(used.multiply(*parts))
            case "div":
                made.append(used.divide(*parts))
            case "sqrt":
                made.append(used.root(parts[0]))
            case "neg":
                made.append(negated(parts[0]))
            case "abs":
                made.append(_magnitude(parts[0], used))
            case name:
                made.append(used.call(name, parts))
    return made


def _magnitude(a: Jet, used: Monomials) -> Jet:
    value = a[0][0]
    if value >= 0:
        return a
    return negated(a) if value <= 0 else used.constant(flint.arb("nan"))


class Enclosed:
    """The steps of a program over a box: Taylor polynomials at its middle with their rests."""

    def __init__(
        self,
        program: Program,
        used: Monomials,
        jets: tuple[list[Jet], list[Jet]],
        rooms: Sequence[flint.arb],
    ) -> None:
        """`jets`: the steps at the middle of a box and over the whole; `rooms`: half its widths."""
        self.program, self.used = program, used
        self.middle, self.whole = jets
        self.sizes = used.sizes(rooms)

    def ball(self, number: int) -> flint.arb:
        """All values of a step."""
        return self._ball(self.middle[number], self.whole[number])

    def _ball(self, middle: Jet, whole: Jet) -> flint.arb:
        rest = flint.arb(0)
        for part in (*middle[1:-1], *whole[-1:]):
            for place, factor in part.items():
                rest += abs(factor) * self.sizes[place]
        first = middle[0][0]
        return first + flint.arb(0, rest.abs_upper()) if rest.is_finite() else flint.arb("nan")

    def least(self, number: int) -> flint.arb:
        """Below the magnitude of a step: of products and quotients by that of their parts, of a
        difference with a root by that of the squares, in which terms cancel exactly.
        """
        step = self.program.steps[number]
        if step.scale is not None:
            return self.least(step.operands[0]) * abs(flint.arb(step.scale))
        match step.operation:
            case "neg" | "abs":
                return self.least(step.operands[0])
            case "sqrt":
                return self.least(step.operands[0]).sqrt()
            case "mul":
                return self.least(step.operands[0]) * self.least(step.operands[1])
            case "div":
                return self.least(step.operands[0]) / self.most(step.operands[1])
        found = flint.arb(self.ball(number).abs_lower())
        if step.operation != "sub" or found > 0:
            return found
        first, second = (self.whole[part][0][0] for part in step.operands)
        roots = [self.program.steps[part].operation == "sqrt" for part in step.operands]
        if not (any(roots) and first >= 0 and second >= 0):
            return found
        squares = [
            [
                self._square(jets, part, root)
                for part, root in zip(step.operands, roots, strict=True)
            ]
            for jets in (self.middle, self.whole)
        ]
        apart = self._ball(*(added(a, negated(b)) for a, b in squares))
        return flint.arb(apart.abs_lower()) / (first + second).abs_upper()

    def most(self, number: int) -> flint.arb:
        """Above the magnitude of a step."""
        ball, plain = self.ball(number), self.whole[number][0][0]
        found = [flint.arb(each.abs_upper()) for each in (ball, plain) if each.is_finite()]
        return min(found, default=flint.arb("inf"))

    def _square(self, jets: Sequence[Jet], number: int, root: bool) -> Jet:
        if root:
            return jets[self.program.steps[number].operands[0]]
        return self.used.multiply(jets[number], jets[number])
