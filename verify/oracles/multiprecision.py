"""Multiprecision floats in a context of their own, so that no shared precision is changed."""

from __future__ import annotations

from collections.abc import Callable
from fractions import Fraction
from typing import Any

import mpmath


def context(bits: int) -> Any:
    """A multiprecision context that works with ``bits`` bits."""
    own = mpmath.mp.clone()
    own.prec = bits
    return own


def bits_for(digits: int) -> int:
    """The bits that hold ``digits`` decimal digits."""
    return digits * 10 // 3 + 1


def number_in(own: Any) -> Callable[[Fraction], Any]:
    """Conversion of fractions to floats of the context, rounded once."""
    return lambda value: own.mpf(value.numerator) / value.denominator


def carried(value: Any, own: Any) -> Any:
    """A fraction, or a float of any context, as a float of this one."""
    if isinstance(value, Fraction | int):
        return number_in(own)(Fraction(value))
    return own.make_mpf(value._mpf_)


def fraction(value: Any) -> Fraction:
    """A float of any context as the fraction it is."""
    sign, mantissa, exponent, _ = value._mpf_
    return Fraction(-int(mantissa) if sign else int(mantissa)) * Fraction(2) ** int(exponent)
