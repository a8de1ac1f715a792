"""Terms in x - a and b - x written in x, or in one of both, where that has fewer positive terms."""

from __future__ import annotations

from fractions import Fraction
from math import comb

from gainproof.derive.stable_form.coordinates import Coordinate
from gainproof.derive.stable_form.exponents import Exponents, Terms

Line = tuple[Fraction, Fraction]
"""Constant and slope of a letter over another."""


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
