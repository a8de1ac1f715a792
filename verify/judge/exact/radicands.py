"""Radicands made simple before a root becomes a variable, so that equal roots are one variable.

Only steps that hold on every branch: powers of what is manifestly positive, or of rational numbers,
are taken out; a root whose radicand times those of known roots is the square of something
manifestly positive is their product.
"""

from __future__ import annotations

from collections.abc import Callable
from dataclasses import dataclass
from fractions import Fraction
from itertools import combinations
from typing import Any

from gainproof.verify.judge.exact.polynomial import (
    Poly,
    constant,
    fraction,
    monomial_content,
    rational,
)
from gainproof.verify.judge.exact.rational_roots import content_of, number_root, power_part
from gainproof.verify.judge.exact.tower_variables import Variables

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


def simplified(base: Element, order: int, variables: Variables) -> tuple[Poly, Poly, Element]:
    """num, den, outside with root(base) = outside * root(num / den). Raises NeedsPower."""
    num, den, outside = _without_monomials(base, order, variables)
    if num.is_zero():
        return num, den, outside
    one = constant(num.context(), 1)
    if not den.is_constant() and variables.over_zero(den):
        outside = Element(outside.num, outside.den * den)
        num, den = num * den ** (order - 1), one
    num, factor = _without_powers(num, order, variables.over_zero)
    # sqrt(g^2 h) = g sqrt(h) at g = 0 too, but only where h is not negative: there the left is 0
    left, extra = _without_powers(num, order, variables.not_below_zero)
    if den.is_one() and variables.not_below_zero(left):
        num, factor = left, factor * extra
    outside = Element(outside.num * factor, outside.den)
    num, den, number = _without_squares(num, den, order)
    return num, den, Element(outside.num * number, outside.den)


def _without_powers(p: Poly, order: int, wanted: Callable[[Poly], bool]) -> tuple[Poly, Poly]:
    """p = outside^order * inside, with factors taken out that are as wanted."""
    outside = constant(p.context(), 1)
    if p.is_constant():
        return p, outside
    for factor, exponent in p.factor()[1]:
        signed = factor if wanted(factor) else -factor
        if exponent >= order and wanted(signed):
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
) -> Element | None:
    """The root as a product of known roots: num * r1 * ... = P^2, so root(num) = P / (t1 ...) = P
    t1 ... / (r1 ...).

    All radicands and P must be manifestly positive polynomials of the parameters; square roots
    only.
    """
    if order != 2 or not den.is_one() or not variables.over_zero(num):
        return None
    usable = [
        (index, radicand.num)
        for index, radicand in known
        if radicand.den.is_one() and variables.over_zero(radicand.num)
    ]
    context = num.context()
    for size in range(1, min(MOST_TOGETHER, len(usable)) + 1):
        for chosen in combinations(usable, size):
            radicands = constant(context, 1)
            roots = constant(context, 1)
            for index, radicand in chosen:
                radicands, roots = radicands * radicand, roots * context.gen(index)
            square = _square_root(num * radicands, variables)
            if square is not None:
                return Element(square * roots, radicands)
    return None


def split_off(
    num: Poly,
    order: int,
    known: list[tuple[int, Element]],
    variables: Variables,
) -> tuple[Poly, Element] | None:
    """root(num) = root(rest) * product of known roots, by a manifestly positive factor of num."""
    if order != 2 or num.is_constant() or variables.over_zero(num):
        return None
    one = constant(num.context(), 1)
    for factor, _ in num.factor()[1]:
        signed = factor if variables.over_zero(factor) else -factor
        if variables.over_zero(signed):
            product = product_of_roots(signed, one, order, known, variables)
            if product is not None:
                return divmod(num, signed)[0], product
    return None


def _square_root(p: Poly, variables: Variables) -> Poly | None:
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
        if variables.over_zero(candidate):
            return candidate
    return None


def _without_monomials(
    base: Element, order: int, variables: Variables
) -> tuple[Poly, Poly, Element]:
    """Powers of positive symbols taken out of the radicand."""
    named = [
        *zip(variables.free_indices, variables.free, strict=True),
        *zip(variables.parameter_indices, variables.parameters, strict=True),
    ]
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
