"""Leading terms of a tower's polynomials where its first parameter tends to 0 or to infinity."""

from __future__ import annotations

from collections.abc import Mapping
from dataclasses import dataclass
from math import isqrt

import sympy as sp

from gainproof.derive.algebra.limits import End
from gainproof.derive.algebra.tower import Poly, Tower
from gainproof.derive.expression import real


class NoLeadingTerm(ArithmeticError):
    """The leading coefficient vanishes, or its sign or its root is not shown."""


@dataclass(frozen=True)
class Leading:
    """coefficient * parameter^order; the coefficient is written over held parameters and roots."""

    order: int
    coefficient: sp.Expr


def leading(
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


def prime_powers(number: int) -> dict[int, int]:
    """A positive number by its small primes; what is left of it, or its root, is one more factor.

    The large primes of a number of many decimals take for ever.
    """
    found: dict[int, int] = {}
    rest = int(number)
    for prime in sp.primerange(1 << 15):
        while rest % prime == 0:
            found[prime] = found.get(prime, 0) + 1
            rest //= prime
        if prime * prime > rest:
            break
    if rest > 1:
        root = isqrt(rest)
        whole = root * root == rest
        found[root if whole else rest] = 2 if whole else 1
    return found


def square_root(value: sp.Expr) -> tuple[sp.Expr, sp.Expr]:
    """(a, b) with value = a^2 b, b without a small square factor; 1 for a square.

    A value that holds roots already is left as it is under a root: a = 1.
    """
    if not value.is_polynomial() or any(not p.exp.is_Integer for p in value.atoms(sp.Pow)):
        return sp.Integer(1), value
    constant, factors = sp.factor_list(sp.expand(value))
    constant = sp.Rational(constant)
    outside: sp.Expr = sp.Rational(1, constant.q)
    inside: sp.Expr = sp.Integer(1)
    for prime, power in prime_powers(abs(constant.p * constant.q)).items():
        outside *= sp.Integer(prime) ** (power // 2)
        inside *= sp.Integer(prime) ** (power % 2)
    for factor, power in factors:
        outside *= factor ** (power // 2)
        inside *= factor ** (power % 2)
    return sp.expand(outside), sp.expand(inside)
