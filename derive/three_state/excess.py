"""Polynomials in xi and eta rewritten in x = xi - (1 + b), where their signs show."""

from __future__ import annotations

from collections.abc import Mapping
from fractions import Fraction
from typing import Any

import sympy as sp

from gainproof.derive.steady_state.towers import rational
from gainproof.derive.three_state.kernel_basis import KernelBasis
from gainproof.derive.three_state.names import ETA, XI

X, B, C = sp.symbols("x b c")


def coefficients(k: KernelBasis, form: sp.Expr) -> list[Any]:
    """The coefficients by powers of x, lowest first, as numbers or nodes.

    Raises ArithmeticError when one holds a minus sign.
    """
    m1, m2 = rational(k.spectrum.m1), rational(k.spectrum.m2)
    xi = 1 + B + X
    eta = B + C + (1 + B) * X + X**2 / 2
    expanded = sp.expand(form.subs({XI: xi, ETA: eta}, simultaneous=True))
    reduced = sp.reduced(expanded, [C**2 - m2, B**2 - m1 - 2 * C], X, B, C, order="lex")[1]
    polynomial = sp.Poly(reduced, X)
    return [
        _value(k, polynomial.coeff_monomial(X**power)) for power in range(polynomial.degree() + 1)
    ]


def _value(k: KernelBasis, expression: sp.Expr) -> Any:
    known: Mapping[sp.Symbol, Any] = {B: k.b, C: k.root_e}
    numbers = {
        symbol: rational(value) for symbol, value in known.items() if isinstance(value, Fraction)
    }
    polynomial = sp.Poly(sp.expand(expression.subs(numbers)), B, C)
    value: Any = Fraction(0)
    for (first, second), number in polynomial.terms():
        if number < 0:
            raise ArithmeticError(f"no form without subtraction for {expression}")
        term: Any = Fraction(str(number))
        for symbol, power in ((B, first), (C, second)):
            term = known[symbol] * term if power == 1 else term
        value = term if value == 0 else value + term
    return value
