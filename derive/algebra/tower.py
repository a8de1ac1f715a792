"""Towers of radicals: positive parameters, then positive roots of positive radicands.

Elements are fractions of polynomials over the rationals in all variables of the tower; polynomials
are kept reduced by the monic relations y^n = radicand, from the highest generator down; two coupled
generators (see `coupled`) are reduced together.
"""

from __future__ import annotations

from collections.abc import Mapping
from typing import Any

import sympy as sp
from sympy.polys.rings import PolyElement, PolyRing

from gainproof.derive.algebra.common_factor import without_common_factor
from gainproof.derive.algebra.variables import Fraction, Generator, Parameter, Poly, coupled

__all__ = [
    "Fraction",
    "Generator",
    "NoValue",
    "Parameter",
    "Poly",
    "Tower",
    "coupled",
    "is_manifestly_positive",
    "shift_closed",
]


class NoValue(TypeError):
    """An expression that is no fraction of a tower's variables, such as a root."""


class Tower:
    """Parameters, generators and named elements; immutable after construction.

    `elements` maps a name to its value as an expression in the variables and in elements named
    before it.
    """

    def __init__(
        self,
        name: str,
        parameters: tuple[Parameter, ...],
        generators: tuple[Generator, ...],
        elements: Mapping[str, sp.Expr],
        free: tuple[str, ...] = (),
    ) -> None:
        self.name = name
        self.parameters = parameters
        self.generators = generators
        self.expressions = dict(elements)
        self.variables = [entry.symbol for entry in parameters]
        self.variables += [entry.symbol for entry in generators]
        self.free = free
        self.ring = PolyRing([*self.variables, *free], sp.QQ, sp.lex)
        # expressions have real symbols, those of the ring are plain ones
        self._places = {
            symbol: number
            for number, entry in enumerate(self.ring.symbols)
            for symbol in (entry, sp.Symbol(entry.name, real=True))
            if entry.name not in elements
        }
        self.radicands: list[Poly] = []
        self.elements: dict[str, Fraction] = {}
        # steps share many of their expressions
        self._known: dict[sp.Expr, Fraction] = {}
        self._freed: dict[tuple[str, ...], Tower] = {}
        for generator in generators:
            value = self.fraction(generator.radicand)
            if value.den != self.ring.one:
                value = Fraction(value.num.quo(value.den), self.ring.one)
            self.radicands.append(value.num)
        for key, expression in elements.items():
            self.elements[key] = self.fraction(expression)

    def with_free(self, free: tuple[str, ...]) -> Tower:
        """The same tower with further symbols that stand for anything."""
        if not free:
            return self
        if free not in self._freed:
            parts = self.parameters, self.generators, self.expressions
            self._freed[free] = Tower(self.name, *parts, free)
        return self._freed[free]

    def reduce(self, poly: Poly) -> Poly:
        """Normal form modulo the relations."""
        for position in reversed(range(len(self.radicands))):
            poly = self._reduce_by(position, poly)
            if self.starts_pair(position):
                # a product of the two's powers: each replacement lowers the degree in both
                while poly.degree(len(self.parameters) + position + 1) > 1:
                    poly = self._reduce_by(position, self._reduce_by(position + 1, poly))
        return poly

    def _reduce_by(self, position: int, poly: Poly) -> Poly:
        index = len(self.parameters) + position
        power, radicand = self.generators[position].power, self.radicands[position]
        while poly.degree(index) >= power:
            # each term goes to one place of one part, so that nothing needs to be added up
            low, high = {}, {}
            for exponents, coefficient in poly.items():
                if exponents[index] >= power:
                    lowered = exponents[index] - power
                    high[(*exponents[:index], lowered, *exponents[index + 1 :])] = coefficient
                else:
                    low[exponents] = coefficient
            poly = self.ring.from_dict(low) + self.ring.from_dict(high) * radicand
        return poly

    def starts_pair(self, position: int) -> bool:
        """Whether two coupled generators start at this place, both known."""
        following = self.generators[position + 1 : len(self.radicands)]
        return bool(following) and following[0].symbol == self.generators[position].partner

    def couplings(self, position: int) -> tuple[Poly, Poly]:
        """The part of a coupled radicand without the partner, and what the partner is times."""
        radicand = self.radicands[position]
        symbol = sp.Symbol(self.generators[position].partner)
        partner = self.ring.gens[self.ring.symbols.index(symbol)]
        slope = radicand.diff(partner)
        return radicand - slope * partner, slope

    def make(self, num: Poly, den: Poly) -> Fraction:
        """A reduced fraction, common factors of the polynomials cancelled while signs stay plain.

        Cancelling can turn a polynomial without negative coefficients into one with some, as
        (x^3 + 1)/(x + 1) shows; then the fraction is left as it came.
        """
        num, den = self.reduce(num), self.reduce(den)
        if not den:
            raise ZeroDivisionError(f"division by zero in tower {self.name}")
        if not num:
            return Fraction(num, self.ring.one)
        top, bottom = without_common_factor(num, den)
        if _plain_sign(top) >= _plain_sign(num) and _plain_sign(bottom) >= _plain_sign(den):
            num, den = top, bottom
        # One sign and one scale: the denominator's leading coefficient is 1.
        lead = den.LC
        return Fraction(num.quo_ground(lead), den.quo_ground(lead))

    def fraction(self, expression: Any) -> Fraction:
        """Evaluate an expression of variables and element names; roots are not taken here."""
        value = sp.sympify(expression)
        one = self.ring.one
        if isinstance(value, sp.Rational):
            return Fraction(self.ring.ground_new(sp.QQ(int(value.p), int(value.q))), one)
        if isinstance(value, sp.Symbol):
            if value.name in self.elements:
                return self.elements[value.name]
            return Fraction(self.ring.gens[self.ring.symbols.index(sp.Symbol(value.name))], one)
        if value not in self._known:
            self._known[value] = self._composed(value)
        return self._known[value]

    def _composed(self, value: sp.Expr) -> Fraction:
        """The value of a sum, a product or a power from those of its parts."""
        whole = sum_of_powers(value, self._places, self.ring)
        if whole is not None:
            return Fraction(self.reduce(whole), self.ring.one)
        if isinstance(value, sp.Add):
            total, *others = map(self.fraction, value.args)
            for other in others:
                total = self.make(
                    total.num * other.den + other.num * total.den, total.den * other.den
                )
            return total
        if isinstance(value, sp.Mul):
            product, *others = map(self.fraction, value.args)
            for other in others:
                product = self.make(product.num * other.num, product.den * other.den)
            return product
        if isinstance(value, sp.Pow) and isinstance(value.exp, sp.Integer):
            base, power = self.fraction(value.base), int(value.exp)
            if power < 0:
                base, power = Fraction(base.den, base.num), -power
            return self.make(base.num**power, base.den**power)
        raise NoValue(f"no value in tower {self.name} for {value!r}")

    def depends_on(self, poly: Poly) -> frozenset[str]:
        """The parameters that occur in a polynomial, also those inside generators."""
        found: set[str] = set()
        for position, name in enumerate(self.variables):
            if poly.degree(position) > 0:
                number = position - len(self.parameters)
                if number < 0:
                    found |= {name}
                    continue
                parts = [self.radicands[number]]
                if self.generators[number].partner:
                    other = number + (1 if self.starts_pair(number) else -1)
                    parts = [*self.couplings(number), *self.couplings(other)]
                found = found.union(*map(self.depends_on, parts))
        return frozenset(found)

    def parameter_of(self, name: str) -> str:
        """The parameter of that name, or the one on which the element of that name alone depends.

        Raises ValueError for an element that depends on several.
        """
        if any(entry.symbol == name for entry in self.parameters):
            return name
        value = self.elements[name]
        found = self.depends_on(value.num) | self.depends_on(value.den)
        if len(found) != 1:
            raise ValueError(f"{name} in tower {self.name} depends on {sorted(found)}, not on one")
        return next(iter(found))

    def is_zero(self, expression: Any) -> bool:
        """Whether an expression vanishes identically in the tower."""
        return not self.fraction(expression).num

    def expression(self, value: Fraction) -> sp.Expr:
        """A fraction as a SymPy expression in real symbols."""
        symbols = [sp.Symbol(name, real=True) for name in [*self.variables, *self.free]]
        top = value.num.as_expr(*symbols)
        return top / value.den.as_expr(*symbols)


def _plain_sign(poly: Poly) -> bool:
    """Whether all coefficients have one sign."""
    signs = {value > 0 for value in poly.values()}
    return len(signs) == 1


def is_manifestly_positive(poly: PolyElement, parameters: tuple[Parameter, ...]) -> bool:
    """Whether no coefficient is negative and one term is positive on the whole domain."""
    shifted = shift_closed(poly, parameters)
    closed = [n for n, entry in enumerate(parameters) if entry.start is not None]
    if not shifted or any(value < 0 for value in shifted.values()):
        return False
    return any(all(not exponents[n] for n in closed) for exponents in shifted)


def shift_closed(poly: Poly, parameters: tuple[Parameter, ...]) -> Poly:
    """Rewrite a polynomial in k - k0 for every parameter k >= k0."""
    for number, entry in enumerate(parameters):
        if entry.start is not None and entry.start != "0":
            generator = poly.ring.gens[number]
            poly = poly.compose(generator, generator + sp.QQ(int(entry.start)))
    return poly


def sum_of_powers(value: sp.Expr, places: Mapping[sp.Symbol, int], ring: PolyRing) -> Poly | None:
    """A sum of rational numbers times powers of variables; None for anything else.

    `places` are the positions of the variables in the ring's monomials.
    """
    found: dict[tuple[int, ...], Any] = {}
    for term in sp.Add.make_args(value):
        exponents, number = [0] * len(ring.symbols), sp.QQ(1)
        for factor in sp.Mul.make_args(term):
            base, power = factor.as_base_exp()
            if isinstance(factor, sp.Rational):
                number *= sp.QQ(int(factor.p), int(factor.q))
            elif base in places and isinstance(power, sp.Integer) and power > 0:
                exponents[places[base]] += int(power)
            else:
                return None
        key = tuple(exponents)
        found[key] = found.get(key, sp.QQ(0)) + number
    return ring.from_dict(found)
