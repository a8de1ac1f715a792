"""How much the roundings of a kernel weigh on a piece of its domain, by Gappa.

The value of every operation is that of its rounded operands times 1 + e. On the straight way from
all e = 0 to those of a computation, log(output) changes by the integral of the sum of l e/(1 + e),
with the weights l (`piece`) at the points of the way. `MODEL` says |e| <= u = 2^-53: if S bounds
the sum of the sizes of all weights at every point, the output's relative error is below
exp(S u (1 + 4 u)) - 1 < S u (1 + 2^-41) for S <= MOST.

A term of a sum that may be lost by underflow is held at its exact value on the way, and what it may
be instead is an error of the sum.
"""

from __future__ import annotations

from collections.abc import Iterator, Mapping
from fractions import Fraction
from math import ceil

import flint

from gainproof.certify import gappa
from gainproof.certify.gappa import Enclosure, dyadic
from gainproof.certify.piece import UNIT, Piece, Section
from gainproof.certify.sizes import logarithm

MOST = Fraction(1024)
MARGIN = 1 + Fraction(1, 2**40)
BITS = 100
LARGEST = Fraction(2**54 - 1) * 2**970
"""What is smaller is rounded to a finite number."""
LEAST = Fraction(1, 2**1022)
"""The least normal number."""
LOST = Fraction(1, 2**1060)
"""What is smaller counts as lost by underflow."""
NEARLY = Fraction(1, 2**100)

MODEL = f"""\
@rnd = float<ieee_64,ne>;
a = rnd(A);
b = rnd(B);
{{ (|V| in [{dyadic(2 * LEAST)},{dyadic(LARGEST)}] -> |rnd(V) -/ V| <= {dyadic(UNIT)})
/\\ (|V| <= {dyadic(2 * LEAST)} -> |rnd(V) - V| <= {dyadic(LEAST * UNIT)})
/\\ (|a + b| <= {dyadic(LARGEST)} -> |rnd(a + b) -/ (a + b)| <= {dyadic(UNIT)})
/\\ (|a - b| <= {dyadic(LARGEST)} -> |rnd(a - b) -/ (a - b)| <= {dyadic(UNIT)}) }}
"""
"""What is assumed of roundings, as Gappa proves it of its float64: sums need not be normal."""


def weighed(section: Section, low: Fraction, high: Fraction, stop: float) -> Enclosure | None:
    """An enclosure of S for low <= x <= high; None where Gappa does not find all that it needs.

    It needs that no value overflows, and that those that may be subnormal are terms of sums of
    which they are at most 2^-100.
    """
    faint: set[int] = set()
    factors: dict[int, Fraction] = {}
    while True:
        piece = Piece(section, faint, section.factors | factors)
        if piece.misplaced:
            return None
        given = [between(section.root, low, high), *piece.given]
        names = [*piece.sizes.values(), *piece.ratios.values(), "S"]
        found = gappa.enclosures(piece.definitions(), given, names, stop)
        if any(name not in found for name in piece.sizes.values()):
            return None
        sizes = {number: _magnitude(found[name]) for number, name in piece.sizes.items()}
        lost = {n for n, size in _inexact(section, sizes) if size < LOST}
        more = {n: c for n, size in _inexact(section, sizes) if (c := _factor(size)) > 1}
        if lost <= faint and all(c <= factors.get(n, 0) for n, c in more.items() if n not in lost):
            ratios = [found.get(name) for name in piece.ratios.values()]
            small = all(each and _magnitude(each)[1] <= NEARLY for each in ratios)
            if not (small and all(size[1] < LARGEST for size in sizes.values()) and "S" in found):
                return None
            least, most = found["S"]
            return (Fraction(0) if more else least), most  # on a part of it these may be fewer
        faint |= lost
        # a little more than was needed, since the values move with their errors
        factors = {n: c * (1 + Fraction(1, 2**20)) for n, c in more.items() if n not in lost}


def _inexact(section: Section, sizes: Mapping[int, Enclosure]) -> Iterator[tuple[int, Fraction]]:
    """Operations whose results may be inexact by underflow, with their least sizes."""
    for operation in section.operations:
        n = operation.number
        if n not in sizes:
            continue
        scaled = operation.kind == "scale" and sizes[n][0] < LEAST
        if scaled or operation.kind in ("mul", "div", "sqrt"):
            yield n, sizes[n][0]


def _factor(size: Fraction) -> Fraction:
    """The largest relative error of a rounding to a number of at least this size, over 2^-53.

    That of a subnormal number is at most 2^-1075 over its size; 1/(1 + e) is in it too.
    """
    exact = LEAST / max(size, LOST)
    if exact <= 1:
        return Fraction(1)
    return ceil(exact * (1 + 2 * exact * UNIT) * 2**30) * Fraction(1, 2**30)


def _magnitude(value: Enclosure) -> Enclosure:
    low, high = value
    return max(low, -high, Fraction(0)), max(-low, high)


def between(root: int, low: Fraction, high: Fraction) -> str:
    """The hypothesis on z, where z^root runs over all from low to high."""
    ends = []
    for value, more in ((low, 0), (high, 1)):
        shift = BITS - round(logarithm(value) / root)
        scaled = value * Fraction(2) ** (shift * root)
        whole = int(flint.fmpz(scaled.numerator // scaled.denominator).root(root)) + more
        ends.append(Fraction(whole) / Fraction(2) ** shift)
    if not (ends[0] ** root <= low and high <= ends[1] ** root):
        raise ArithmeticError(f"no ends of a root for {low} to {high}")
    return f"z in [{dyadic(ends[0])},{dyadic(ends[1])}]"
