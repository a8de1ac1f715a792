"""Polynomials without minus signs, nested so that they need few operations."""

from __future__ import annotations

from collections.abc import Mapping, Sequence
from fractions import Fraction
from typing import Any

import sympy as sp


class SignError(ValueError):
    """A polynomial with a negative coefficient, or none."""


def nested(expression: Any, order: Sequence[sp.Symbol], values: Mapping[sp.Symbol, Any]) -> Any:
    """The value of a polynomial at symbols or nodes; None for zero.

    It is nested in the first symbol, its coefficients in the next. Raises SignError for a negative
    coefficient: sums of positive terms keep their digits.
    """
    polynomial = sp.Poly(sp.expand(expression), *order)
    if any(value < 0 for value in polynomial.coeffs()):
        raise SignError(f"no minus sign is wanted, got {polynomial.as_expr()}")
    return _nested(polynomial.as_expr(), list(order), values)


def _nested(expression: Any, order: list[sp.Symbol], values: Mapping[sp.Symbol, Any]) -> Any:
    if expression == 0:
        return None
    if not order:
        number = Fraction(str(expression))
        return number.numerator if number.denominator == 1 else number
    symbol, *rest = order
    result: Any = None
    for coefficient in sp.Poly(expression, symbol).all_coeffs():
        inner = _nested(coefficient, rest, values)
        if result is not None:
            result = values[symbol] if _is_one(result) else times(values[symbol], result)
        result = inner if result is None else result if inner is None else result + inner
    return result


def _is_one(value: Any) -> bool:
    return isinstance(value, int) and value == 1


def times(value: Any, factor: Any) -> Any:
    """A product; by a number as one product and one division at most."""
    if isinstance(factor, Fraction):
        above = value if factor.numerator == 1 else value * factor.numerator
        return above if factor.denominator == 1 else above / factor.denominator
    return value if _is_one(factor) else value * factor
