"""Arithmetic of numbers and matrices (lists of rows) in multiprecision; when two values differ."""

from __future__ import annotations

from fractions import Fraction
from typing import Any

import mpmath

AGREED = mpmath.mpf(10) ** -35
"""Relative difference below which two values count as equal."""


class NoValue(Exception):
    """Division by zero, an even root of a negative number, or a symbol without value."""


class Misshapen(Exception):
    """Matrices whose sizes do not fit: no relation at all, so neither true nor false."""


def real(x: Fraction | int) -> Any:
    """A rational number."""
    return mpmath.mpf(x.numerator) / x.denominator


def root(base: Any, exponent: Fraction) -> Any:
    """A rational power; roots of odd order are real for negative numbers too."""
    if isinstance(base, list):
        raise Misshapen("power of a matrix")
    if (base == 0 and exponent < 0) or (base < 0 and exponent.denominator % 2 == 0):
        raise NoValue("power")
    if exponent.denominator == 1:
        return base ** int(exponent)
    sign = -1 if base < 0 and exponent.numerator % 2 else 1
    return sign * mpmath.root(abs(base), exponent.denominator) ** exponent.numerator


def plus(a: Any, b: Any) -> Any:
    """Sum of two of a shape."""
    if isinstance(a, list) != isinstance(b, list):
        raise Misshapen("sum of a matrix and a number")
    if isinstance(a, list):
        if len(a) != len(b) or len(a[0]) != len(b[0]):
            raise Misshapen("sizes")
        return [[x + y for x, y in zip(p, q, strict=True)] for p, q in zip(a, b, strict=True)]
    return a + b


def times(factor: Any, a: Any) -> Any:
    """A number times anything."""
    return [[factor * x for x in row] for row in a] if isinstance(a, list) else factor * a


def product(a: Any, b: Any) -> Any:
    """Product in this order."""
    if not isinstance(a, list):
        return times(a, b)
    if not isinstance(b, list):
        return times(b, a)
    if len(a[0]) != len(b):
        raise Misshapen("sizes")
    return [
        [sum(x * y for x, y in zip(row, col, strict=True)) for col in zip(*b, strict=True)]
        for row in a
    ]


def differ(a: Any, b: Any) -> bool:
    """Whether two values differ by more than rounding can."""
    if isinstance(a, list) != isinstance(b, list):
        raise Misshapen("a matrix and a number")
    if isinstance(a, list):
        if len(a) != len(b) or len(a[0]) != len(b[0]):
            raise Misshapen("sizes")
        return any(
            differ(x, y) for p, q in zip(a, b, strict=True) for x, y in zip(p, q, strict=True)
        )
    return bool(abs(a - b) > AGREED * max(abs(a), abs(b), mpmath.mpf(10) ** -10))
