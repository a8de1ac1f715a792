"""Forms that show a sign: fractions whose polynomials have no negative coefficient."""

from __future__ import annotations

from typing import Any

from gainproof.derive.algebra.tower import (
    Fraction,
    Poly,
    Tower,
    is_manifestly_positive,
    shift_closed,
)


class NoPlainSign(ArithmeticError):
    """No form with a plain sign was found; the expression may still have one."""


def positive_form(tower: Tower, expression: Any) -> Fraction:
    """A manifestly positive fraction equal to the expression.

    A factor a - b y with the wrong look is multiplied by its conjugate a + b y.

    Raises NoPlainSign when the search ends without one.
    """
    value = expression if isinstance(expression, Fraction) else tower.fraction(expression)
    top = _signed(tower, value.num)
    bottom = _signed(tower, value.den)
    if top[0] * bottom[0] < 0:
        raise NoPlainSign(f"negative in tower {tower.name}: {expression}")
    return tower.make(top[1].num * bottom[1].den, top[1].den * bottom[1].num)


def nonnegative_form(tower: Tower, expression: Any) -> Fraction:
    """A manifestly nonnegative fraction equal to the expression: it may vanish at a closed end.

    Raises NoPlainSign when the search ends without one.
    """
    value = expression if isinstance(expression, Fraction) else tower.fraction(expression)
    plain = all(entry > 0 for entry in shift_closed(value.num, tower.parameters).values())
    if plain and is_manifestly_positive(value.den, tower.parameters):
        return value
    return positive_form(tower, value)


def is_positive_fraction(tower: Tower, value: Fraction) -> bool:
    """Whether both polynomials are manifestly positive."""
    return is_manifestly_positive(value.num, tower.parameters) and is_manifestly_positive(
        value.den, tower.parameters
    )


def _signed(tower: Tower, poly: Poly) -> tuple[int, Fraction]:
    if is_manifestly_positive(poly, tower.parameters):
        return 1, Fraction(poly, tower.ring.one)
    if is_manifestly_positive(-poly, tower.parameters):
        return -1, Fraction(-poly, tower.ring.one)
    constant, factors = poly.factor_list()
    if len(factors) > 1 or (factors and factors[0][1] > 1):
        sign, num, den = (1 if constant > 0 else -1), tower.ring(abs(constant)), tower.ring.one
        for factor, power in factors:
            part_sign, part = _signed(tower, factor)
            sign *= part_sign**power
            num, den = num * part.num**power, den * part.den**power
        return sign, Fraction(num, den)
    return _by_conjugate(tower, poly)


def _by_conjugate(tower: Tower, poly: Poly) -> tuple[int, Fraction]:
    for position in reversed(range(len(tower.generators))):
        index = len(tower.parameters) + position
        single = tower.generators[position].power == 2 and not tower.generators[position].partner
        if not single or poly.degree(index) < 1:
            continue
        generator = tower.ring.gens[index]
        constant, linear = tower.ring.zero, tower.ring.zero
        for exponents, coefficient in poly.terms():
            term = tower.ring.term_new(exponents, coefficient)
            if exponents[index]:
                linear += term.quo(generator)
            else:
                constant += term
        for conjugate in (constant - linear * generator, linear * generator - constant):
            if is_manifestly_positive(conjugate, tower.parameters):
                sign, product = _signed(tower, tower.reduce(poly * conjugate))
                return sign, Fraction(product.num, product.den * conjugate)
    raise NoPlainSign(f"no plain sign for {poly.as_expr()} in tower {tower.name}")
