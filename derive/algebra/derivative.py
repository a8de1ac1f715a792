"""Derivatives: of expressions by a symbol, along rates of several, and over a tower.

The one place where formulas are differentiated; what a map's Newton step takes of a graph, node by
node and over one divisor, is `printer.derivative`, since no printer knows SymPy.
"""

from __future__ import annotations

from collections.abc import Mapping
from typing import Any

import sympy as sp

from gainproof.derive.algebra.tower import Fraction, Poly, Tower


def by(value: Any, variable: Any) -> Any:
    """The derivative of an expression by one of its symbols, or of a polynomial or a quotient of
    polynomials by a generator, everything else held. That of |u| is u u'/|u|, which a kernel can
    compute where u is not 0.
    """
    found = value.diff(variable)
    return found.replace(sp.sign, lambda u: u / sp.Abs(u)) if isinstance(found, sp.Expr) else found


def along(value: sp.Expr, rates: Mapping[sp.Symbol, sp.Expr]) -> sp.Expr:
    """The derivative where these symbols change at these rates: the chain rule."""
    return sp.Add(*(by(value, symbol) * rate for symbol, rate in rates.items()))


def derivative(tower: Tower, expression: Any, variable: str) -> Fraction:
    """The derivative by a parameter, or by an element of one parameter, the others held."""
    parameter = tower.parameter_of(variable)
    result = _along(tower, tower.fraction(expression), _rates(tower, parameter))
    if parameter == variable:
        return result
    run = _along(tower, tower.elements[variable], _rates(tower, parameter))
    return tower.make(result.num * run.den, result.den * run.num)


def _rates(tower: Tower, parameter: str) -> list[Fraction]:
    """The derivative of every variable of the tower: y' = radicand'/(n y^(n-1)), or by pairs."""
    zero, one = tower.ring.zero, tower.ring.one
    rates = [
        Fraction(one if entry.symbol == parameter else zero, one) for entry in tower.parameters
    ]
    for number, generator in enumerate(tower.generators):
        if generator.partner:
            if tower.starts_pair(number):
                rates += _pair_rates(tower, number, rates)
            continue
        slope = _of_poly(tower, tower.radicands[number], rates)
        root = tower.ring.gens[len(tower.parameters) + number]
        power = generator.power
        rates.append(tower.make(slope.num, slope.den * root ** (power - 1) * sp.QQ(power)))
    return rates


def _pair_rates(tower: Tower, number: int, rates: list[Fraction]) -> list[Fraction]:
    """x' and y' of x^2 = a + b y, y^2 = c + e x by Cramer's rule.

    The determinant times x y is 4 a c + 4 a e x + 4 b c y + 3 b e x y.
    """
    place = len(tower.parameters) + number
    x, y = tower.ring.gens[place : place + 2]
    (a, b), (c, e) = tower.couplings(number), tower.couplings(number + 1)
    below = 4 * a * c + 4 * a * e * x + 4 * b * c * y + 3 * b * e * x * y
    da, db, dc, de = (_of_poly(tower, entry, rates) for entry in (a, b, c, e))
    one = tower.make(da.num * db.den + db.num * da.den * y, da.den * db.den)
    two = tower.make(dc.num * de.den + de.num * dc.den * x, dc.den * de.den)
    found = []
    for own, other, root, slope in ((one, two, y, b), (two, one, x, e)):
        top = 2 * root * own.num * other.den + slope * other.num * own.den
        found.append(tower.make(x * y * top, below * own.den * other.den))
    return found


def _along(tower: Tower, value: Fraction, rates: list[Fraction]) -> Fraction:
    above, below = _of_poly(tower, value.num, rates), _of_poly(tower, value.den, rates)
    return tower.make(
        above.num * below.den * value.den - value.num * below.num * above.den,
        above.den * below.den * value.den**2,
    )


def _of_poly(tower: Tower, poly: Poly, rates: list[Fraction]) -> Fraction:
    total = Fraction(tower.ring.zero, tower.ring.one)
    for generator, rate in zip(tower.ring.gens, rates, strict=False):
        slope = by(poly, generator)
        if slope and rate.num:
            total = tower.make(
                total.num * rate.den + slope * rate.num * total.den, total.den * rate.den
            )
    return total
