"""Functions in terms of those for which there are rules, and the multiples that occur of each."""

from __future__ import annotations

from collections.abc import Callable, Iterable, Mapping
from typing import Any

import sympy as sp

_RATIOS: Mapping[Any, Callable[[sp.Expr], sp.Expr]] = {
    sp.tan: lambda x: sp.sin(x) / sp.cos(x),
    sp.cot: lambda x: sp.cos(x) / sp.sin(x),
    sp.sec: lambda x: 1 / sp.cos(x),
    sp.csc: lambda x: 1 / sp.sin(x),
}


def exact(expression: sp.Expr) -> sp.Expr:
    """Hyperbolic functions by exponentials of single terms, tangents by sines and cosines."""
    found = expression.rewrite([sp.sinh, sp.cosh, sp.tanh, sp.coth], sp.exp)
    for function in (sp.tan, sp.cot, sp.sec, sp.csc):
        found = found.replace(function, lambda x, f=function: _RATIOS[f](x))
    return sp.expand_power_exp(found)


def numbers(expressions: Iterable[sp.Expr]) -> dict[sp.Expr, set[sp.Rational]]:
    """Of exponents and angles, number times a product: which numbers stand with each product."""
    found: dict[sp.Expr, set[sp.Rational]] = {}
    for expression in expressions:
        for function in expression.atoms(sp.exp, sp.sin, sp.cos):
            number, product = function.args[0].as_coeff_Mul()
            found.setdefault(product, set()).add(number)
    return found
