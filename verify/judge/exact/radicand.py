"""Radicands made simple before a root becomes a variable, so that equal roots are one variable.

Only steps that hold on every branch: powers of what is manifestly positive, or of rational numbers,
are taken out; a root whose radicand times those of known roots is the square of something
manifestly positive is their product.
"""

from __future__ import annotations

from dataclasses import dataclass
from fractions import Fraction
from itertools import combinations
from typing import Any

from gainproof.verify.judge.exact.poly import (
    Poly,
    constant,
    fraction,
    monomial_content,
    rational,
    terms,
)
from gainproof.verify.judge.exact.rational_root import content_of, number_root, power_part

MOST_TOGETHER = 3


class NeedsPower(Exception):
    """A root of an odd power of a positive symbol: the symbol must be written as a power of a new
    one.
    """

    def __init__(self, name: str, order: int) -> None:
        super().__init__(f"{name} = new^{order}")
        self.name = name
        self.order = order


@dataclass(frozen=True)
class Element:
    """num / den, polynomials of the tower. Where the expression is defined, den is not zero."""

    num: Poly
    den: Poly


@dataclass(frozen=True)
class Variables:
    """Which variables of the ring are what; those named in `positive` are greater than zero."""

    free: tuple[str, ...]
    free_indices: tuple[int, ...]
    parameter_index: int | None
    positive: frozenset[str]


def simplified(
    base: Element, order: int, variables: Variables, parameter: str | None
) -> tuple[Poly, Poly, Element]:
    """num, den, outside with root(base) = outside * root(num / den). Raises NeedsPower."""
    num, den, outside = _without_monomials(base, order, variables, parameter)
    if num.is_zero():
        return num, den, outside
    in_parameter = variables.parameter_index if parameter in variables.positive else None
    one = constant(num.context(), 1)
    if not den.is_constant() and manifestly_positive(den, in_parameter):
        outside = Element(outside.num, outside.den * den)
        num, den = num * den ** (order - 1), one
    num, factor = _without_powers(num, order, in_parameter)
    outside = Element(outside.num * factor, outside.den)
    num, den, number = _without_squares(num, den, order)
    return num, den, Element(outside.num * number, outside.den)


def manifestly_positive(p: Poly, parameter_index: int | None) -> bool:
    """No variable but a positive parameter (its index, else None), and no coefficient that is not
    positive.
    """
    for exponents, coefficient in terms(p):
        others = any(e for i, e in enumerate(exponents) if i != parameter_index)
        if others or fraction(coefficient) <= 0:
            return False
    return not p.is_zero()


def _without_powers(p: Poly, order: int, parameter_index: int | None) -> tuple[Poly, Poly]:
    """p = outside^order * inside, with manifestly positive factors of p taken out."""
    outside = constant(p.context(), 1)
    if p.is_constant():
        return p, outside
    for factor, exponent in p.factor()[1]:
        signed = factor if manifestly_positive(factor, parameter_index) else -factor
        if exponent >= order and manifestly_positive(signed, parameter_index):
            whole = signed ** (exponent // order)
            outside = outside * whole
            p = divmod(p, whole**order)[0]
    return p, outside


def product_of_roots(
    num: Poly,
    den: Poly,
    order: int,
    known: list[tuple[int, Element]],
    variables: Variables,
    parameter: str | None,
) -> Element | None:
    """The root as a product of known roots: num * r1 * ... = P^2, so root(num) = P / (t1 ...) = P
    t1 ... / (r1 ...).

    All radicands and P must be manifestly positive polynomials of the parameter; square roots only.
    """
    in_parameter = variables.parameter_index if parameter in variables.positive else None
    if order != 2 or not den.is_one() or not manifestly_positive(num, in_parameter):
        return None
    usable = [
        (index, radicand.num)
        for index, radicand in known
        if radicand.den.is_one() and manifestly_positive(radicand.num, in_parameter)
    ]
    context = num.context()
    for size in range(1, min(MOST_TOGETHER, len(usable)) + 1):
        for chosen in combinations(usable, size):
            radicands = constant(context, 1)
            roots = constant(context, 1)
            for index, radicand in chosen:
                radicands, roots = radicands * radicand, roots * context.gen(index)
            square = _square_root(num * radicands, in_parameter)
            if square is not None:
                return Element(square * roots, radicands)
    return None


def split_off(
    num: Poly,
    order: int,
    known: list[tuple[int, Element]],
    variables: Variables,
    parameter: str | None,
) -> tuple[Poly, Element] | None:
    """root(num) = root(rest) * product of known roots, by a manifestly positive factor of num."""
    in_parameter = variables.parameter_index if parameter in variables.positive else None
    if order != 2 or num.is_constant() or manifestly_positive(num, in_parameter):
        return None
    one = constant(num.context(), 1)
    for factor, _ in num.factor()[1]:
        signed = factor if manifestly_positive(factor, in_parameter) else -factor
        if manifestly_positive(signed, in_parameter):
            product = product_of_roots(signed, one, order, known, variables, parameter)
            if product is not None:
                return divmod(num, signed)[0], product
    return None


def _square_root(p: Poly, parameter_index: int | None) -> Poly | None:
    """The manifestly positive square root of a polynomial, if it has one."""
    lead, factors = p.factor_squarefree()
    if any(exponent % 2 for _, exponent in factors):
        return None
    number = number_root(constant(p.context(), fraction(lead)), constant(p.context(), 1), 2)
    if number is None:
        return None
    root = constant(p.context(), number)
    for factor, exponent in factors:
        root = root * factor ** (exponent // 2)
    for candidate in (root, -root):
        if manifestly_positive(candidate, parameter_index):
            return candidate
    return None


def _without_monomials(
    base: Element, order: int, variables: Variables, parameter: str | None
) -> tuple[Poly, Poly, Element]:
    """Powers of positive symbols taken out of the radicand."""
    named = list(zip(variables.free_indices, variables.free, strict=True))
    if variables.parameter_index is not None and parameter is not None:
        named.append((variables.parameter_index, parameter))
    indices = [i for i, name in named if name in variables.positive]
    context = base.num.context()
    sides = []
    for p in (base.num, base.den):
        inside, outside = p, constant(context, 1)
        content = monomial_content(p, indices)
        for i, e in zip(indices, content, strict=True):
            if e % order and i in variables.free_indices:
                raise NeedsPower(variables.free[variables.free_indices.index(i)], order)
            whole = e - e % order
            if whole:
                inside = divmod(inside, context.gen(i) ** whole)[0]
                outside = outside * context.gen(i) ** (whole // order)
        sides.append((inside, outside))
    (num, top), (den, bottom) = sides
    return num, den, Element(top, bottom)


def _without_squares(num: Poly, den: Poly, order: int) -> tuple[Poly, Poly, Any]:
    """num / den = factor^order * (num' / den'), both primitive but for a number without small
    powers.

    So that roots that differ by a rational factor are one variable of the tower.
    """
    ratio = Fraction(1)
    made = []
    for p, sign in ((num, 1), (den, -1)):
        content = content_of(p)
        made.append(p / rational(content))
        ratio *= content**sign
    # u / v = u v^(n-1) / v^n
    whole = abs(ratio.numerator) * ratio.denominator ** (order - 1)
    outside, inside = power_part(whole, order)
    inside = -inside if ratio < 0 else inside
    return made[0] * inside, made[1], rational(Fraction(outside, ratio.denominator))
