"""Partial derivatives over a tower, generators following."""

from __future__ import annotations

from typing import Any

import sympy as sp

from gainproof.derive.algebra.tower import Fraction, Poly, Tower


def derivative(tower: Tower, expression: Any, variable: str) -> Fraction:
    """The derivative by a parameter, or by an element of one parameter, the others held."""
    parameter = tower.parameter_of(variable)
    result = _along(tower, tower.fraction(expression), _rates(tower, parameter))
    if parameter == variable:
        return result
    run = _along(tower, tower.elements[variable], _rates(tower, parameter))
    return tower.make(result.num * run.den, result.den * run.num)


def _rates(tower: Tower, parameter: str) -> list[Fraction]:
    """The derivative of every variable of the tower: y' = radicand'/(n y^(n-1))."""
    zero, one = tower.ring.zero, tower.ring.one
    rates = [
        Fraction(one if entry.symbol == parameter else zero, one) for entry in tower.parameters
    ]
    for number, generator in enumerate(tower.generators):
        slope = _of_poly(tower, tower.radicands[number], rates)
        root = tower.ring.gens[len(tower.parameters) + number]
        power = generator.power
        rates.append(tower.make(slope.num, slope.den * root ** (power - 1) * sp.QQ(power)))
    return rates


def _along(tower: Tower, value: Fraction, rates: list[Fraction]) -> Fraction:
    above, below = _of_poly(tower, value.num, rates), _of_poly(tower, value.den, rates)
    return tower.make(
        above.num * below.den * value.den - value.num * below.num * above.den,
        above.den * below.den * value.den**2,
    )


def _of_poly(tower: Tower, poly: Poly, rates: list[Fraction]) -> Fraction:
    total = Fraction(tower.ring.zero, tower.ring.one)
    for generator, rate in zip(tower.ring.gens, rates, strict=False):
        slope = poly.diff(generator)
        if slope and rate.num:
            total = tower.make(
                total.num * rate.den + slope * rate.num * total.den, total.den * rate.den
            )
    return total
