"""Leading terms of a tower's elements where one parameter tends to 0 or to infinity."""

from __future__ import annotations

from collections.abc import Mapping
from dataclasses import dataclass

import sympy as sp

from gainproof.derive.algebra.limits import End
from gainproof.derive.algebra.tower import Fraction, Poly, Tower
from gainproof.derive.expression import real


class NoLeadingTerm(ArithmeticError):
    """The leading coefficient vanishes, or its sign or its root is not shown."""


@dataclass(frozen=True)
class Leading:
    """coefficient * parameter^order; the coefficient is written over held parameters and roots."""

    order: int
    coefficient: sp.Expr


@dataclass(frozen=True)
class Edge:
    """One end of one parameter of a tower whose generators have radicands without minus signs."""

    tower: Tower
    end: End
    at_infinity: bool
    roots: Mapping[str, sp.Expr]

    def order(self, poly: Poly) -> Leading:
        """The leading term of a polynomial. Raises NoLeadingTerm where terms may cancel."""
        return _leading(self.tower, poly, self.end, self.roots, self.at_infinity)[0]

    def of(self, value: Fraction) -> Leading:
        """The leading term of a fraction."""
        top, bottom = self.order(value.num), self.order(value.den)
        coefficient = top.coefficient / bottom.coefficient
        if not coefficient.has(sp.sqrt) and coefficient.is_rational_function():
            coefficient = sp.factor(coefficient)
        return Leading(top.order - bottom.order, coefficient)


def edge(tower: Tower, *, at_infinity: bool, likely: Mapping[str, sp.Expr] | None = None) -> Edge:
    """What the generators do where the first parameter tends to 0, or to infinity.

    `likely`: for some generators an expression in the tower that may have the same leading term;
    it is taken where its square has that of the radicand, and saves a root of a root.

    Raises NoLeadingTerm for a generator without an integer order.
    """
    weights: dict[str, int] = {}
    constants: dict[str, int | sp.Expr] = {}
    boundary: dict[str, sp.Expr] = {}
    roots: dict[str, sp.Expr] = {}
    for generator, radicand in zip(tower.generators, tower.radicands, strict=True):
        known = (End(dict(weights), dict(constants), dict(boundary)), dict(roots))
        found = _leading(tower, radicand, *known, at_infinity)[0]
        if generator.power != 2 or found.order % 2:
            raise NoLeadingTerm(f"{generator.symbol} has no integer order")
        weights[generator.symbol] = found.order // 2 if at_infinity else -(found.order // 2)
        guess = (likely or {}).get(generator.symbol)
        taken = None if guess is None else _taken(tower, guess, known, found, at_infinity)
        if taken is not None:
            boundary[generator.symbol] = taken
            continue
        outside, inside = square_root(found.coefficient)
        boundary[generator.symbol] = outside
        same = [key for key, root in roots.items() if root == sp.sqrt(inside)]
        if inside != 1 and same:
            boundary[generator.symbol] = outside * real(same[0])
        elif inside != 1:
            name = f"root_of_{generator.symbol}"
            constants[name] = inside.subs({value: real(key) for key, value in roots.items()})
            roots[name] = sp.sqrt(inside)
            boundary[generator.symbol] = outside * real(name)
    return Edge(tower, End(weights, constants, boundary), at_infinity, roots)


def _leading(
    tower: Tower, poly: Poly, end: End, roots: Mapping[str, sp.Expr], at_infinity: bool
) -> tuple[Leading, sp.Expr]:
    """The terms of the least order, or of the greatest at infinity, at the boundary.

    The second result is the coefficient over the names of the constants.
    """
    side = 1 if at_infinity else -1
    terms: dict[int, sp.Expr] = {}
    for exponents, coefficient in poly.terms():
        powers = dict(zip(tower.variables, exponents, strict=False))
        order = powers[tower.variables[0]]
        value = sp.Rational(int(coefficient.numerator), int(coefficient.denominator))
        for name, power in powers.items():
            if name in end.boundary and power:
                order += side * end.weights[name] * power
                value *= end.boundary[name] ** power
            elif name != tower.variables[0]:
                value *= real(name) ** power
        terms[order] = terms.get(order, sp.Integer(0)) + value
    if not terms:
        raise NoLeadingTerm("zero has no leading term")
    order = max(terms) if at_infinity else min(terms)
    known = {real(name): root for name, root in roots.items()}
    coefficient = sp.expand(sp.expand(terms[order]).subs(known))
    written = sp.Add.make_args(coefficient)
    if coefficient == 0 or len({bool(term.as_coeff_Mul()[0] > 0) for term in written}) > 1:
        raise NoLeadingTerm(f"the leading coefficient {coefficient} has no plain sign")
    return Leading(order, coefficient), sp.expand(terms[order])


def _taken(
    tower: Tower,
    guess: sp.Expr,
    known: tuple[End, dict[str, sp.Expr]],
    found: Leading,
    at_infinity: bool,
) -> sp.Expr | None:
    """The guess at the boundary where its square is the radicand there."""
    value = tower.fraction(guess)
    if value.den != tower.ring.one:
        return None
    leading, written = _leading(tower, value.num, *known, at_infinity)
    same = sp.expand(leading.coefficient**2 - found.coefficient) == 0
    return written if same and 2 * leading.order == found.order else None


def square_root(value: sp.Expr) -> tuple[sp.Expr, sp.Expr]:
    """(a, b) with value = a^2 b, b without a square factor; 1 for a square.

    A value that holds roots already is left as it is under a root: a = 1.
    """
    if not value.is_polynomial():
        return sp.Integer(1), value
    constant, factors = sp.factor_list(sp.expand(value))
    constant = sp.Rational(constant)
    outside: sp.Expr = sp.Rational(1, constant.q)
    inside: sp.Expr = sp.Integer(1)
    for prime, power in sp.factorint(abs(constant.p * constant.q)).items():
        outside *= sp.Integer(prime) ** (power // 2)
        inside *= sp.Integer(prime) ** (power % 2)
    for factor, power in factors:
        outside *= factor ** (power // 2)
        inside *= factor ** (power % 2)
    return sp.expand(outside), sp.expand(inside)
