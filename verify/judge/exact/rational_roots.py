"""Roots and contents of rational numbers."""

from __future__ import annotations

from fractions import Fraction
from math import gcd, lcm

from gainproof.verify.judge.exact.polynomial import (
    Poly,
    fraction,
    terms,
)

SMALL_PRIMES = (2, 3, 5, 7, 11, 13, 17, 19, 23, 29, 31, 37, 41, 43, 47)


def content_of(p: Poly) -> Fraction:
    """The positive number that leaves integer coefficients without common factor."""
    coefficients = [fraction(c) for _, c in terms(p)]
    top, bottom = 0, 1
    for c in coefficients:
        top, bottom = gcd(top, c.numerator), lcm(bottom, c.denominator)
    return Fraction(top, bottom)


def power_part(n: int, order: int) -> tuple[int, int]:
    """n = a^order * b, with no small prime left to that power in b."""
    outside = 1
    for prime in SMALL_PRIMES:
        while n % prime**order == 0:
            n //= prime**order
            outside *= prime
    exact = integer_root(n, order)
    return (outside, n) if exact is None else (outside * exact, 1)


def number_root(num: Poly, den: Poly, order: int) -> Fraction | None:
    """The root of a rational number that has a rational one; negative only for odd order."""
    if not (num.is_constant() and den.is_constant()):
        return None
    value = fraction(num.leading_coefficient()) / fraction(den.leading_coefficient())
    if value < 0 and order == 2:
        return None
    top, bottom = (integer_root(abs(n), order) for n in (value.numerator, value.denominator))
    if top is None or bottom is None:
        return None
    return Fraction(top, bottom) * (-1 if value < 0 else 1)


def integer_root(n: int, order: int) -> int | None:
    """The root of a number that is a power of that order; None for others."""
    low, high = 0, 1 << (n.bit_length() // order + 1)
    while low < high:
        middle = (low + high) // 2
        if middle**order < n:
            low = middle + 1
        else:
            high = middle
    return low if low**order == n else None
