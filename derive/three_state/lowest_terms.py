"""Quantities of the steady state as quotients in xi, written over the parameter in lowest terms.

All but the index, which occurs squared, are quotients of polynomials in xi over the rationals.
There common factors show; over the parameter they do not, since b and c stand in every coefficient
and their squares are put in place.
"""

from __future__ import annotations

from collections.abc import Iterable, Mapping
from dataclasses import dataclass
from typing import Any

import sympy as sp
from sympy.polys.fields import FracField

from gainproof.derive.algebra.derivative import by
from gainproof.derive.algebra.tower import Poly, Tower, is_manifestly_positive
from gainproof.derive.three_state.names import DELTA, INDEX, TAU, XI
from gainproof.derive.three_state.spectrum import Spectrum

Quotient = Any  # an element of a SymPy field of fractions in xi; SymPy ships no types for it


@dataclass(frozen=True)
class Quotients:
    """Named quantities as quotients in xi, each with the power of the index, 0 or 1, beside it."""

    field: Any
    square: Quotient
    known: Mapping[str, tuple[Quotient, int]]

    def of(self, expression: sp.Expr) -> Quotient:
        """An expression as a quotient in xi.

        Raises ArithmeticError where an odd power of the index is left.
        """
        value, power = self.with_index(sp.sympify(expression))
        if power:
            raise ArithmeticError(f"a quotient in xi is wanted, {expression} holds the index")
        return value

    def with_index(self, expression: sp.Expr) -> tuple[Quotient, int]:
        """An expression as a quotient in xi times a power of the index, 0 or 1."""
        if isinstance(expression, sp.Rational):
            return self.field(sp.QQ(int(expression.p), int(expression.q))), 0
        if isinstance(expression, sp.Symbol):
            return self.known[expression.name]
        parts = [self.with_index(part) for part in expression.args[:2]]
        if isinstance(expression, sp.Pow) and isinstance(expression.exp, sp.Integer):
            value, power = parts[0]
            return self._lowered(value ** int(expression.exp), power * int(expression.exp))
        parts += [self.with_index(part) for part in expression.args[2:]]
        value, power = parts[0]
        if isinstance(expression, sp.Mul):
            for other, more in parts[1:]:
                value, power = value * other, power + more
            return self._lowered(value, power)
        if isinstance(expression, sp.Add) and all(more == power for _, more in parts):
            return sum((other for other, _ in parts), self.field.zero), power
        raise ArithmeticError(f"no quotient in xi for {expression}")

    def along_index(self, quotient: Quotient) -> Quotient:
        """Lambda d/dLambda of a quotient: L xi = -64 xi/(Lambda^2 delta tau)."""
        rate = self.of(-64 * XI / (INDEX**2 * DELTA * TAU))
        return rate * by(quotient, self.field.gens[0])

    def _lowered(self, value: Quotient, power: int) -> tuple[Quotient, int]:
        pairs, rest = divmod(power, 2)
        return value * self.square**pairs, rest


def quotients(spectrum: Spectrum, elements: Mapping[str, sp.Expr]) -> Quotients:
    """The elements of a tower, named in their order."""
    field = FracField(["xi"], sp.QQ)
    x = field.gens[0]
    a1, a2, e = (
        field(sp.QQ(*n.as_integer_ratio())) for n in (spectrum.a1, spectrum.a2, spectrum.e)
    )
    eta = (x**2 - a1) / 2
    delta = (eta**2 - a2) / (2 * x)
    known = {"xi": (x, 0), "eta": (eta, 0), "delta": (delta, 0), INDEX.name: (field.one, 1)}
    found = Quotients(field, 64 / (delta**2 - e), known)
    for name, value in elements.items():
        if name not in known:
            known[name] = found.with_index(sp.sympify(value))
    return found


def common_denominator(parts: Iterable[Quotient]) -> Poly:
    """The least common multiple of the denominators of quotients."""
    first, *others = (part.denom for part in parts)
    for other in others:
        first = first.lcm(other)
    return first


def over_parameter(
    tower: Tower,
    excess: tuple[sp.Expr, sp.Expr],
    quotient: Quotient,
    denominator: Poly | None = None,
) -> sp.Expr:
    """A quotient in xi over the parameter, showing its sign.

    `excess` are 1 + b and `wide`: xi = 1 + b + 4/wide. The `denominator`, where one is given, is a
    multiple of that of lowest terms.

    Raises ArithmeticError where these show no sign.
    """
    above, below = quotient.numer, quotient.denom
    if denominator is not None:
        above, below = above * denominator.quo(below), denominator
    top, bottom = (_written(tower, *excess, part) for part in (above, below))
    more, step = below.degree() - above.degree(), tower.fraction(excess[1]).num
    if more > 0:
        top *= step**more
    else:
        bottom *= step**-more
    value = tower.make(top, bottom)
    if not all(is_manifestly_positive(part, tower.parameters) for part in (value.num, value.den)):
        raise ArithmeticError(f"no plain sign in lowest terms of {quotient}")
    return tower.expression(value)


def _written(tower: Tower, least: sp.Expr, wide: sp.Expr, polynomial: Poly) -> Poly:
    """A polynomial in xi times that power of `wide` which clears its denominator."""
    raised, step = tower.fraction(least * wide + 4).num, tower.fraction(wide).num
    total, power = tower.ring.zero, tower.ring.one
    for exponent in range(polynomial.degree(), -1, -1):
        total = tower.reduce(total * raised) + power * polynomial.get((exponent,), sp.QQ(0))
        power *= step
    return total
