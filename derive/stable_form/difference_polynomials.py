"""Polynomials of a tower over what is computed: differences from the ends, and roots.

With t = u/v, u = x - a, v = b - x (v = 1 where nothing bounds x), a polynomial of degree n in t is
v^-n times one in u and v. A generator y with radicand r, of degree n, is v^(-n/2) times the root of
that polynomial; and where powers of u are drawn out of r as well, u^k times that of the rest. So
powers of u and v are counted in halves.
"""

from __future__ import annotations

from dataclasses import dataclass
from fractions import Fraction
from math import comb

from gainproof.derive.algebra.tower import Poly
from gainproof.derive.stable_form.coordinates import Coordinate
from gainproof.derive.stable_form.exponents import BLOCKS, Exponents, Terms
from gainproof.derive.stable_form.polynomial_products import exact
from gainproof.derive.stable_form.root_tower import Reading

Line = tuple[Fraction, Fraction]
"""Constant and slope of a letter over another."""


@dataclass(frozen=True)
class Whole:
    """`factor` times `terms` times the powers `outside`; `ends`: of every u the least and the
    greatest power of the terms, near 0 and far away, in quarters.
    """

    factor: Fraction
    terms: Terms
    outside: Exponents
    ends: tuple[tuple[int, int], ...]


STEEP = 3  # quarters: of powers of an input beyond, a sum may overflow with the input


class Letters:
    """The letters of a reading; `place` in 0..1: which power of u is drawn out of a polynomial.

    0: the least, 1: the greatest, so that the rest is one in 1/u; 1/2: that between them, which
    keeps terms from overflowing. `scale`: a power of 4 by which sums are multiplied that may
    overflow at the ends of the format's range, without rounding.
    """

    def __init__(self, reading: Reading, place: Fraction, scale: Fraction) -> None:
        self.reading, self.place, self.scale = reading, place, scale
        self.count = len(reading.coordinates)
        self.roots = BLOCKS * self.count
        self.size = self.roots + len(reading.generators)
        self.generators: list[Whole] = []
        for radicand in reading.tower.radicands:
            self.generators.append(self.whole(radicand, radicand=True))

    def whole(self, poly: Poly, radicand: bool = False) -> Whole:
        """The letters of a polynomial; powers outside a radicand have roots that are known."""
        terms: dict[Exponents, Fraction] = {}
        for exponents, coefficient in poly.terms():
            term = self._term(exponents)
            terms[term] = terms.get(term, Fraction(0)) + exact(coefficient)
        outside = [0] * self.size
        for number, each in enumerate(self.reading.coordinates):
            step = (1 if each.rooted else 2) * (2 if radicand else 1)
            if each.high is not None:
                # the least power of v may be negative: its terms are brought to that degree
                place = self.count + number
                outside[place] = min(term[place] for term in terms) // step * step
            else:
                low, high = self._ends(terms, number)
                between = low + self.place * (high - low)
                outside[number] = int(between / 2) // step * step
        inside: Terms = {
            tuple(a - b for a, b in zip(term, outside, strict=True)): value
            for term, value in terms.items()
        }
        ends = tuple(self._ends(inside, number) for number in range(self.count))
        for number, each in enumerate(self.reading.coordinates):
            if not any(term[number] < 0 for term in inside):
                inside = fewest(inside, number, self.count, each)
        if len(inside) == 1 or all(low > -STEEP and high < STEEP for low, high in ends):
            return Whole(Fraction(1), inside, tuple(outside), ends)
        scaled = {term: value * self.scale for term, value in inside.items()}
        return Whole(1 / self.scale, scaled, tuple(outside), ends)

    def _term(self, exponents: tuple[int, ...]) -> Exponents:
        found = [0] * self.size
        for number, each in enumerate(self.reading.coordinates):
            halves = exponents[number] * (1 if each.rooted else 2)
            found[number] += halves
            if each.high is not None:
                found[self.count + number] -= halves
        for number, power in enumerate(exponents[self.count :]):
            found[self.roots + number] += power
            if power:
                for place, halves in enumerate(self.generators[number].outside):
                    found[place] += halves * power // 2
        return tuple(found)

    def _ends(self, terms: Terms, number: int) -> tuple[int, int]:
        """Of one u the least and the greatest power, in quarters, generators included."""
        lows, highs = [], []
        for term in terms:
            low = high = 2 * term[number]
            for place, whole in enumerate(self.generators):
                power = term[self.roots + place]
                low += power * whole.ends[number][0] // 2
                high += power * whole.ends[number][1] // 2
            lows.append(low)
            highs.append(high)
        return min(lows), max(highs)


def fewest(terms: Terms, number: int, count: int, coordinate: Coordinate) -> Terms:
    """The terms with the fewest positive coefficients of one input's letters u, v and x."""
    low, high = coordinate.low, coordinate.high
    best = terms
    if any(value < 0 for value in terms.values()) or (not low and high is None):
        return best
    one = Fraction(1)
    lines: list[tuple[int, Line, Line]] = [(2, (-low, one), (high or one, -one))]
    if high is not None:
        itself, other = (Fraction(0), one), (high - low, -one)
        lines += [(0, itself, other), (1, other, itself)]
    for target, above, below in lines:
        found = _over(terms, number, count, target, (above, below))
        if len(found) < len(best) and all(value > 0 for value in found.values()):
            best = found
    return best


def _over(
    terms: Terms, number: int, count: int, target: int, lines: tuple[Line, Line]
) -> dict[Exponents, Fraction]:
    """Whole powers of u and v as powers of one letter; roots of both stay."""
    found: dict[Exponents, Fraction] = {}
    place = number + target * count
    for term, value in terms.items():
        rest = list(term)
        expanded = {0: value}
        for letter, (constant, slope) in enumerate(lines):
            power, odd = divmod(term[number + letter * count], 2)
            rest[number + letter * count] = odd
            expanded = _times_power(expanded, constant, slope, power)
        for power, coefficient in expanded.items():
            whole = (*rest[:place], rest[place] + 2 * power, *rest[place + 1 :])
            found[whole] = found.get(whole, Fraction(0)) + coefficient
    return {term: value for term, value in found.items() if value}


def _times_power(
    poly: dict[int, Fraction], constant: Fraction, slope: Fraction, power: int
) -> dict[int, Fraction]:
    found: dict[int, Fraction] = {}
    for degree, value in poly.items():
        for k in range(power + 1):
            more = value * comb(power, k) * slope**k * constant ** (power - k)
            found[degree + k] = found.get(degree + k, Fraction(0)) + more
    return found
