"""Monomials as one number each: the exponents are its digits, so that a product is a sum.

The exponent of the first variable is the highest digit: the numbers are ordered as the lists of
exponents are. A digit has room for the sum of two exponents and, above that, for one bit that no
exponent sets (its `guard`), so that all digits of two numbers are compared by one subtraction.

Tables find numbers by their remainders modulo 2^61 - 1, in which digits lie over one another. With
14 bits to each, no two of the first nine do so by less than five bits: small exponents then have
remainders of their own. Whoever wants can write a polynomial whose monomials all have the same one;
`crowding` tells how much longer its table takes.
"""

from __future__ import annotations

from collections.abc import Collection, Iterable, Sequence

from gainproof.verify.certificate.rejection import MAXIMUM_EXPONENT, RejectedError

WIDTH = 14
"""Bits of a digit."""
_VALUE = WIDTH - 1
DIGIT = (1 << WIDTH) - 1
"""All bits of the lowest digit."""

# Fewer take no time worth asking for.
_MANY = 500


def in_every_digit(value: int, size: int) -> int:
    """The number of which each of so many digits is this one."""
    return sum(value << WIDTH * digit for digit in range(size))


def guards(size: int) -> int:
    """The guards of all digits."""
    return in_every_digit(1 << _VALUE, size)


def monomial_of(exponents: Sequence[int]) -> int:
    """The monomial with these exponents. RejectedError for one that is negative or too high."""
    found = 0
    for exponent in exponents:
        if not 0 <= exponent <= MAXIMUM_EXPONENT:
            raise RejectedError(f"an exponent is not between 0 and {MAXIMUM_EXPONENT}")
        found = found << WIDTH | exponent
    return found


def exponents_of(monomial: int, size: int) -> tuple[int, ...]:
    """The exponents of the variables in their order."""
    return tuple(monomial >> shift & DIGIT for shift in range(WIDTH * (size - 1), -1, -WIDTH))


def highest(monomials: Iterable[int], guard: int) -> int:
    """The monomial whose exponents are each the highest of these."""
    found = 0
    for monomial in monomials:
        # a guard is left where the digit of what was found is not below the monomial's
        left = (found | guard) - monomial & guard
        if left != guard:
            kept = left - (left >> _VALUE)
            found = monomial ^ (found ^ monomial) & kept
    return found


def beyond(monomial: int, limits: int, guard: int) -> int:
    """The guards of the digits that are higher than those of the limits; 0 if there are none."""
    return (limits | guard) - monomial & guard ^ guard


def crowding(monomials: Collection[int]) -> int:
    """How many monomials share a remainder on the average, rounded down; 1 if these are few."""
    if len(monomials) < _MANY:
        return 1
    return len(monomials) // len(set(map(hash, monomials)))
