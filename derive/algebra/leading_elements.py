"""Leading terms of a tower's elements where one parameter tends to 0 or to infinity."""

from __future__ import annotations

from collections.abc import Mapping
from dataclasses import dataclass

import sympy as sp

from gainproof.derive.algebra.coupled_leading_terms import Found, add_pair
from gainproof.derive.algebra.leading_terms import (
    Leading,
    NoLeadingTerm,
    leading,
    square_root,
)
from gainproof.derive.algebra.limits import ConstantPair, End
from gainproof.derive.algebra.tower import Fraction, Poly, Tower
from gainproof.derive.expression import real

__all__ = ["Edge", "Leading", "NoLeadingTerm", "edge", "square_root"]


@dataclass(frozen=True)
class Edge:
    """One end of one parameter of a tower whose generators have radicands without minus signs."""

    tower: Tower
    end: End
    at_infinity: bool
    roots: Mapping[str, sp.Expr]

    def order(self, poly: Poly) -> Leading:
        """The leading term of a polynomial. Raises NoLeadingTerm where terms may cancel."""
        return leading(self.tower, poly, self.end, self.roots, self.at_infinity)[0]

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
    constants: dict[str, int | sp.Expr | ConstantPair] = {}
    boundary: dict[str, sp.Expr] = {}
    roots: dict[str, sp.Expr] = {}
    for number, (generator, radicand) in enumerate(
        zip(tower.generators, tower.radicands, strict=True)
    ):
        known = (End(dict(weights), dict(constants), dict(boundary)), dict(roots))
        if generator.partner:
            if tower.starts_pair(number):
                into = Found(weights, constants, boundary, roots)
                add_pair(tower, number, into, likely or {}, at_infinity=at_infinity)
            continue
        found = leading(tower, radicand, *known, at_infinity)[0]
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
    first, written = leading(tower, value.num, *known, at_infinity)
    same = sp.expand(first.coefficient**2 - found.coefficient) == 0
    return written if same and 2 * first.order == found.order else None
