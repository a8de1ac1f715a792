"""Linear functions of one input or of one function's value, which cost one rounding at most.

c0 + c1 x is exact data until its own rounding, whatever its sign; of a function's value only those
sums are free of subtraction that `atoms` lists, and those of two positive terms.
"""

from __future__ import annotations

from collections.abc import Sequence
from fractions import Fraction

from gainproof.derive.printer.graph import Node
from gainproof.derive.stable_form.atoms import Sources
from gainproof.derive.stable_form.coordinates import Coordinate
from gainproof.derive.stable_form.exponents import BLOCKS, Terms


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
