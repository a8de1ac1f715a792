"""The numbers of a model in a kernel's graph, over its parameters, without a subtraction."""

from __future__ import annotations

from collections.abc import Mapping
from fractions import Fraction
from typing import Any

import sympy as sp

from gainproof.derive.any_two_state.model_numbers import MeasuredFirst
from gainproof.derive.model import ModelError
from gainproof.derive.printer.graph import GraphBuilder


class Numbers:
    """Positive numbers of the model as nodes, no computed values subtracted.

    A factor of a parameter r below 1 that has minus signs is written in r and 1 - r, which is
    exact but for one rounding.
    """

    def __init__(self, builder: GraphBuilder, shape: MeasuredFirst) -> None:
        self.builder, self.shape = builder, shape
        self.below = {
            entry.quantity.symbol for entry in shape.numbers.parameters if entry.below_one
        }

    def __call__(self, expression: sp.Expr) -> Any:
        value = sp.sympify(expression)
        if value.is_Rational:
            return self.builder.number(Fraction(int(value.p), int(value.q)))
        top, bottom = sp.fraction(sp.together(value))
        above = self._product(top)
        if bottom == 1:
            return above
        return above / self._product(bottom)

    def _product(self, polynomial: sp.Expr) -> Any:
        constant, factors = sp.factor_list(polynomial)
        result: Any = None
        if abs(constant) != 1 or not factors:
            result = self(abs(sp.Rational(constant)))
        for factor, power in factors:
            node = self._factor(factor if self.shape.sign(factor) > 0 else -factor)
            for _ in range(power):
                result = node if result is None else result * node
        return result

    def _factor(self, factor: sp.Expr) -> Any:
        symbols = sorted(factor.free_symbols, key=str)
        poly = sp.Poly(factor, *symbols)
        if all(entry > 0 for entry in poly.coeffs()):
            return self._sum(poly, {})
        if poly.total_degree() == 1 and len(symbols) == 1 and _exact(poly, symbols[0]):
            return self._line(poly, symbols[0])
        mixed = {symbol: poly.degree(symbol) for symbol in symbols if symbol in self.below}
        other = {symbol: sp.Symbol(f"{symbol}_rest", real=True) for symbol in mixed}
        whole = sp.Integer(0)
        for powers, coefficient in poly.terms():
            term = sp.Rational(coefficient)
            for symbol, power in zip(symbols, powers, strict=True):
                term *= symbol**power
                if symbol in mixed:
                    term *= (symbol + other[symbol]) ** (mixed[symbol] - power)
            whole += term
        everything = [*symbols, *other.values()]
        spread = sp.Poly(sp.expand(whole), *everything)
        if any(entry < 0 for entry in spread.coeffs()):
            raise ModelError(
                f"model {self.shape.model.name}: {factor} has no form without a subtraction"
            )
        return self._sum(spread, {rest: symbol for symbol, rest in other.items()})

    def _line(self, poly: sp.Poly, symbol: sp.Symbol) -> Any:
        """a + b r of an exact input, b r exact: one rounding."""
        slope, constant = (self._rational(poly.coeff_monomial(m)) for m in (symbol, 1))
        node = self.builder.symbol(symbol.name)
        if slope == -1:
            return constant - node
        return constant + node * slope if slope > 0 else constant - node * -slope

    def _sum(self, poly: sp.Poly, rests: Mapping[sp.Symbol, sp.Symbol]) -> Any:
        result: Any = None
        for powers, coefficient in poly.terms():
            term: Any = None
            for symbol, power in zip(poly.gens, powers, strict=True):
                known = rests.get(symbol)
                node = (
                    self.builder.symbol(symbol.name)
                    if known is None
                    else 1 - self.builder.symbol(known.name)
                )
                for _ in range(power):
                    term = node if term is None else term * node
            number = self._rational(coefficient)
            if term is None:
                term = self.builder.number(number)
            elif number != 1:
                term = term * number
            result = term if result is None else result + term
        return result

    @staticmethod
    def _rational(value: Any) -> Fraction:
        number = sp.Rational(value)
        return Fraction(int(number.p), int(number.q))


def _exact(poly: sp.Poly, symbol: sp.Symbol) -> bool:
    """Whether the slope is a power of two, so that its product with an input is exact."""
    slope = abs(sp.Rational(poly.coeff_monomial(symbol)))
    return all(number & (number - 1) == 0 for number in (int(slope.p), int(slope.q)))
