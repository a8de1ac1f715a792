"""Products of polynomials as nodes of a graph, every operation in its place.

Linear functions c0 + c1 x of one input are exact data until their own rounding, whatever the sign,
and cost one rounding at most; of a function's value only those sums are free of subtraction that
`function_atoms` lists, and those of two positive terms.
"""

from __future__ import annotations

from collections.abc import Mapping, Sequence
from dataclasses import dataclass
from fractions import Fraction
from functools import reduce
from math import isqrt
from operator import mul

from gainproof.derive.algebra.tower import Poly
from gainproof.derive.printer.graph import GraphBuilder, Node
from gainproof.derive.stable_form.coordinates import Coordinate
from gainproof.derive.stable_form.difference_polynomials import Letters
from gainproof.derive.stable_form.exponents import BLOCKS, Exponents, Terms
from gainproof.derive.stable_form.function_atoms import Sources
from gainproof.derive.stable_form.polynomial_products import Product


@dataclass(frozen=True)
class Order:
    """How sums and quotients are written.

    `nested`: sums by Horner's rule, else term by term. `alternating`: factors and divisors in turn,
    else one quotient of two products. `shares`: roots of sums of squares by the shares of what is
    squared in its sum, sqrt(x^2 + y^2) as s sqrt((x/s)^2 + (y/s)^2) with s = x + y, so that no
    square leaves the range of numbers where the root does not.
    """

    nested: bool
    alternating: bool
    shares: bool = False


class Emission:
    """Writes products into a builder.

    `sources` gives nodes of inputs and atoms. `differences`: what is left of subtractions, by name;
    `added`: their two sides are added instead, which gives the scale that errors are measured by.
    """

    def __init__(
        self,
        builder: GraphBuilder,
        letters: Letters,
        sources: Sources,
        order: Order,
        added: bool = False,
    ) -> None:
        self.builder, self.letters, self.sources = builder, letters, sources
        self.order, self.added = order, added
        self.lines = Lines(letters.reading.coordinates, sources)
        self.differences: dict[str, Node] = {}

    def product(self, product: Product) -> Node:
        """The node of a product."""
        constant, outside = product.constant, [0] * self.letters.size
        over: list[Node] = []
        under: list[Node] = []
        for factor, power in sorted(self._squares(product.powers), key=str):
            whole = self.letters.whole(factor)
            terms = whole.terms
            constant *= whole.factor**power
            drawn: Exponents = whole.outside
            number = self.lines.constant(terms)
            if number is not None:
                constant *= number**power
            elif len(terms) == 1:
                ((alone, coefficient),) = terms.items()
                constant *= coefficient**power
                drawn = tuple(a + b for a, b in zip(drawn, alone, strict=True))
            else:
                (over if power > 0 else under).extend([self.polynomial(terms)] * abs(power))
            outside = [a + power * b for a, b in zip(outside, drawn, strict=True)]
        for place, power in enumerate(outside):
            (over if power > 0 else under).extend(self._letters(place, abs(power)))
        return self._quotient(constant, over, under)

    def _squares(self, powers: Mapping[Poly, int]) -> list[tuple[Poly, int]]:
        """Powers in which squares of generators are their radicands."""
        tower = self.letters.reading.tower
        radicands = dict(zip(tower.ring.gens[self.letters.count :], tower.radicands, strict=True))
        found: dict[Poly, int] = {}
        for factor, power in powers.items():
            double = int(power / 2) if factor in radicands else 0
            if double:
                square = radicands[factor]
                found[square] = found.get(square, 0) + double
            found[factor] = found.get(factor, 0) + power - 2 * double
        return [(factor, power) for factor, power in found.items() if power]

    def _quotient(self, constant: Fraction, over: list[Node], under: list[Node]) -> Node:
        sign, size = (-1 if constant < 0 else 1), abs(constant)
        if size.numerator & (size.numerator - 1) == 0 and size.denominator != 1:
            under = [self.builder.number(size.denominator), *under]
            size = Fraction(size.numerator)
        if size != 1 or not over:
            over = [self.builder.number(size), *over]
        if self.order.alternating:
            value = over[0]
            for number in range(max(len(over) - 1, len(under))):
                value = value / under[number] if number < len(under) else value
                value = value * over[number + 1] if number + 1 < len(over) else value
        else:
            value = reduce(mul, over)
            value = value / reduce(mul, under) if under else value
        return -value if sign < 0 else value

    def polynomial(self, terms: Terms) -> Node:
        """The node of a sum of terms; one of mixed signs that is not exact data is a difference."""
        exact = self.lines.affine(terms)
        if exact is not None:
            return exact
        positive = {term: value for term, value in terms.items() if value > 0}
        negative = {term: -value for term, value in terms.items() if value < 0}
        if not negative:
            return self._sum(positive)
        if not positive:
            return -self._sum(negative)
        first, second = self._sum(positive), self._sum(negative)
        if self.added:
            return first + second
        node = first - second
        known = {each.number: name for name, each in self.differences.items()}
        self.differences.setdefault(known.get(node.number, f"difference_{len(known) + 1}"), node)
        return node

    def _sum(self, terms: Terms) -> Node:
        """Positive terms, one at least."""
        exact = self.lines.affine(terms)
        if exact is not None:
            return exact
        if len(terms) == 1 or not self.order.nested:
            return self._term_by_term(terms)
        place = max(range(self.letters.size), key=lambda n: sum(1 for term in terms if term[n]))
        parts: list[Node] = []
        for sign in (1, -1):
            powers = [sign * term[place] for term in terms if sign * term[place] > 0]
            if not powers:
                continue
            least = min(powers)
            inner = {
                (*term[:place], term[place] - sign * least, *term[place + 1 :]): value
                for term, value in terms.items()
                if sign * term[place] > 0
            }
            letters = self._letters(place, least)
            part = self.polynomial(inner)
            parts.append(self._times(part, letters) if sign > 0 else part / reduce(mul, letters))
        rest = {term: value for term, value in terms.items() if not term[place]}
        if rest:
            parts.append(self.polynomial(rest))
        return reduce(Node.__add__, parts)

    def _term_by_term(self, terms: Terms) -> Node:
        """The terms' sum, what is a linear function of one input as exact data."""
        lines: dict[str, dict[Exponents, Fraction]] = {}
        for term, value in terms.items():
            for name in self.lines.slopes({term: value}) or ():
                lines.setdefault(name, {})[term] = value
        constants = lines.pop("", {})
        largest = max(lines.values(), key=len, default={}) | constants
        line = largest if len(largest) > 1 and self.lines.affine(largest) is not None else {}
        rest = sorted((term, value) for term, value in terms.items() if term not in line)
        nodes = [self._term(*term) for term in rest[::-1]]
        return reduce(Node.__add__, [self.polynomial(line), *nodes] if line else nodes)

    def _term(self, term: Exponents, coefficient: Fraction) -> Node:
        over: list[Node] = []
        under: list[Node] = []
        for place, power in enumerate(term):
            (over if power > 0 else under).extend(self._letters(place, abs(power)))
        return self._quotient(coefficient, over, under)

    def _times(self, part: Node, letters: Sequence[Node]) -> Node:
        alone = part.number == self.builder.number(1).number
        return reduce(mul, letters) if alone else reduce(mul, letters, part)

    def _letters(self, place: int, power: int) -> list[Node]:
        """Nodes whose product is the power of a letter."""
        if not power:
            return []
        if place >= self.letters.roots:
            return self._generator(place - self.letters.roots, power)
        name = self.letters.reading.coordinates[place % self.letters.count].name
        slope, constant = self.lines.letter(place)
        node = self.lines.line(name, slope, constant)
        assert node is not None, "a letter of an atom is a line of it"
        root: Node | None = None
        if name in self.sources.atoms:
            root = self.sources.root(name, constant, slope)
        root = self.builder.sqrt(node) if root is None else root
        return [node] * (power // 2) + [root] * (power % 2)

    def _generator(self, number: int, power: int) -> list[Node]:
        """The root of its terms and of a factor, which is a power of 4."""
        whole = self.letters.generators[number]
        by_shares = self._by_shares(whole.terms) if self.order.shares else None
        if by_shares is not None:
            root = self.lines.scaled(by_shares, _root(whole.factor))
            return [root] * power
        node = self.polynomial(whole.terms)
        outer = _root(whole.factor)
        square = self.lines.scaled(node, whole.factor)
        root = self.lines.scaled(self.builder.sqrt(node), outer)
        return [square] * (power // 2) + [root] * (power % 2)

    def _by_shares(self, terms: Terms) -> Node | None:
        """The root of a sum of squares times positive numbers; None of anything else."""
        whole_powers = all(
            not each % (4 if place < self.letters.roots else 2)  # inputs in halves
            for term in terms
            for place, each in enumerate(term)
        )
        if not whole_powers or len(terms) < 2 or min(terms.values()) <= 0:
            return None
        squared = {term: tuple(each // 2 for each in term) for term in terms}
        whole = self._term_by_term(dict.fromkeys(squared.values(), Fraction(1)))
        parts: list[Node] = []
        for term, value in sorted(terms.items()):
            share = self._term(squared[term], Fraction(1)) / whole
            square = share * share
            parts.append(square if value == 1 else square * value)
        return whole * self.builder.sqrt(reduce(Node.__add__, parts))


def _root(factor: Fraction) -> Fraction:
    """Of a power of 4."""
    return Fraction(isqrt(factor.numerator), isqrt(factor.denominator))


class Lines:
    """Nodes of linear functions of the letters of some coordinates."""

    def __init__(self, coordinates: Sequence[Coordinate], sources: Sources) -> None:
        self.coordinates, self.sources = coordinates, sources
        self.builder = sources.builder

    def affine(self, terms: Terms) -> Node | None:
        """c0 + c1 x where the terms are that: exact data until its own one rounding."""
        slopes = self.slopes(terms)
        if slopes is None or len(slopes) > 2:
            return None
        constant = slopes.pop("", Fraction(0))
        if not slopes:
            return self.builder.number(constant)
        ((name, slope),) = slopes.items()
        return self.line(name, slope, constant)

    def constant(self, terms: Terms) -> Fraction | None:
        """The number that terms are, as x + (1 - x) is one."""
        slopes = self.slopes(terms)
        return None if slopes is None or set(slopes) - {""} else slopes.get("", Fraction(0))

    def slopes(self, terms: Terms) -> dict[str, Fraction] | None:
        """Factors of inputs, and the constant as that of "", of a linear function."""
        found = {"": Fraction(0)}
        count = len(self.coordinates)
        for term, value in terms.items():
            places = [place for place, power in enumerate(term) if power]
            if len(places) > 1 or any(
                term[n] != 2 or n >= BLOCKS * len(self.coordinates) for n in places
            ):
                return None
            for place in places:
                each = self.coordinates[place % count]
                slope, end = self.letter(place)
                found[each.name] = found.get(each.name, Fraction(0)) + value * slope
                found[""] += value * end
            found[""] += 0 if places else value
        return {name: value for name, value in found.items() if value or not name}

    def letter(self, place: int) -> tuple[Fraction, Fraction]:
        """Slope and constant of x - a, b - x, or x."""
        each = self.coordinates[place % len(self.coordinates)]
        block = place // len(self.coordinates)
        if block == 1:
            assert each.high is not None
            return Fraction(-1), each.high
        return Fraction(1), Fraction(0) if block else -each.low

    def line(self, name: str, slope: Fraction, constant: Fraction) -> Node | None:
        if name in self.sources.atoms:
            return self._atom_line(name, slope, constant)
        x, size = self.builder.symbol(name), abs(slope)
        outer = Fraction(1)
        if slope * constant < 0:
            outer, constant, size = size, constant / size, Fraction(1)
        if not constant:
            return self.scaled(x, slope)
        if slope < 0:
            return self.scaled(constant - self.scaled(x, size), outer)
        return self.scaled(self.scaled(x, size) + constant, outer)

    def _atom_line(self, name: str, slope: Fraction, constant: Fraction) -> Node | None:
        """A multiple of what a function gives, or a sum without subtraction."""
        outer = constant or abs(slope)
        node = self.sources.line(name, constant / outer, slope / outer)
        if node is not None:
            return self.scaled(node, outer)
        if constant > 0 and slope > 0:
            letter = self.sources.line(name, Fraction(0), Fraction(1))
            return None if letter is None else self.scaled(letter, slope) + constant
        return None

    def scaled(self, node: Node, factor: Fraction) -> Node:
        if factor.numerator == 1 and factor != 1:
            return node / factor.denominator
        return node if factor == 1 else node * factor
