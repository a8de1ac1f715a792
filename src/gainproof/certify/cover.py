"""A kernel's domain cut into pieces until on each the roundings weigh no more than is said."""

from __future__ import annotations

from collections.abc import Callable
from dataclasses import dataclass
from fractions import Fraction

from gainproof.certify.gappa import Enclosure
from gainproof.certify.sizes import logarithm

DEPTH = 64
"""Halvings that lead from a wide piece to the two numbers next to 1."""
WIDE = 2.0
"""Octaves above which a piece is cut in the middle of its exponents."""
BITS = 24
"""Cuts have so many bits below the size of what they cut."""

Weighing = Callable[[Fraction, Fraction], Enclosure | None]


@dataclass(frozen=True)
class Cover:
    """`largest`: of the sums on all pieces; `failed`: the piece on which the bound is not reached,
    with what Gappa found there."""

    pieces: int
    largest: Fraction
    failed: tuple[Fraction, Fraction, Enclosure | None] | None = None


def cover(
    weighed: Weighing, domain: tuple[Fraction, Fraction], most: Fraction, say: Callable[[int], None]
) -> Cover:
    """Pieces of the whole domain on which the sum is at most `most`, from below to above.

    Ends where on a piece the sum is larger everywhere, or where one that was halved DEPTH times is
    not small enough. `say` is told the number of pieces done.
    """
    stack = [(*domain, 0)]
    done, largest = 0, Fraction(0)
    while stack:
        low, high, depth = stack.pop()
        found = weighed(low, high)
        if found is not None and found[1] <= most:
            done, largest = done + 1, max(largest, found[1])
            say(done)
        elif depth == DEPTH or low == high or (found is not None and found[0] > most):
            return Cover(done, largest, (low, high, found))
        else:
            middle = _middle(low, high)
            stack += [(middle, high, depth + 1), (low, middle, depth + 1)]
    return Cover(done, largest)


def _middle(low: Fraction, high: Fraction) -> Fraction:
    ends = logarithm(low), logarithm(high)
    if ends[1] - ends[0] > WIDE:
        return Fraction(2) ** round((ends[0] + ends[1]) / 2)
    unit = Fraction(2) ** (round(logarithm(high - low)) - BITS)
    return round((low + high) / 2 / unit) * unit
