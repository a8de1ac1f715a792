"""SymPy expressions of square roots read into a tower: each root of an irreducible factor once.

The root of a + b y, with y^2 = r, is with d^2 = a^2 - b^2 r the sum of those of (a + d)/2 and
(a - d)/2 where b is positive, else their difference.
"""

from __future__ import annotations

from collections.abc import Iterator, Mapping, Sequence

import sympy as sp

from gainproof.derive.algebra.leading_terms import prime_powers
from gainproof.derive.algebra.tower import Generator, Parameter, Poly, Tower
from gainproof.derive.expression import real
from gainproof.derive.stable_form.coordinates import Coordinate
from gainproof.derive.stable_form.normal_form import linear
from gainproof.derive.stable_form.polynomial_products import Product
from gainproof.derive.stable_form.signed_factors import plain
from gainproof.derive.stable_form.signed_products import Products, shown


class NoReading(ValueError):
    """An expression that is not read on a domain: of a kind that is not known, with a root of what
    is not shown to be positive, or with a divisor that is not shown to be other than 0.
    """


class RootOfParameter(Exception):
    """The root of a parameter is needed: it should be the parameter itself."""

    def __init__(self, parameter: str) -> None:
        super().__init__(parameter)
        self.parameter = parameter


__all__ = ["NoReading", "Reading", "RootOfParameter", "shown"]


class Reading:
    """A tower that grows with the roots that are met; expressions over its variables are values."""

    def __init__(self, coordinates: Sequence[Coordinate]) -> None:
        self.coordinates = tuple(coordinates)
        self.inputs: Mapping[str, sp.Expr] = {each.name: each.value for each in coordinates}
        self.generators: list[Generator] = []
        self.tower = self._tower()
        self._known: dict[sp.Expr, sp.Expr] = {}

    def _tower(self) -> Tower:
        parameters = tuple(Parameter(each.parameter) for each in self.coordinates)
        return Tower("main", parameters, tuple(self.generators), self.inputs)

    def read(self, expression: sp.Expr) -> sp.Expr:
        """The expression with every root replaced by variables of the tower, inner ones first."""
        if expression not in self._known:
            self._known[expression] = self._read(expression)
        return self._known[expression]

    def _read(self, expression: sp.Expr) -> sp.Expr:
        if isinstance(expression, sp.Symbol):
            if expression.name not in self.inputs:
                raise NoReading(f"{expression} is no input")
            return real(expression.name)
        if isinstance(expression, sp.Rational):
            return expression
        if isinstance(expression, sp.Pow) and isinstance(expression.exp, sp.Rational):
            base, power = self.read(expression.base), expression.exp
            if power.q == 1:
                if power < 0 and not shown(self.product(base)):
                    raise NoReading(f"a division by what is not shown to be other than 0: {base}")
                return base**power
            if power.q == 2:
                return self.root(base) ** power.p
        if isinstance(expression, (sp.Add, sp.Mul)):
            return expression.func(*map(self.read, expression.args))
        raise NoReading(
            f"only sums, products, quotients and square roots are known, not {expression}"
        )

    def root(self, value: sp.Expr) -> sp.Expr:
        """The positive square root of a value; NoReading where its sign is not found."""
        product = self.product(value)
        if product.constant < 0:
            raise NoReading(f"the square root of what is negative: {value}")
        # now, as each generator changes the tower, of which the factors are
        factors = [(self._expression(factor), power) for factor, power in product.powers.items()]
        number = product.constant.numerator * product.constant.denominator
        found = sp.Integer(1) / product.constant.denominator
        for prime, power in prime_powers(number).items():
            found *= sp.Integer(prime) ** (power // 2)
            if power % 2:
                found *= self._generator(sp.Integer(prime))
        for factor, power in factors:
            found *= factor ** (power // 2)
            if power % 2:
                found *= self._root_of_factor(factor)
        return found

    def product(self, value: sp.Expr) -> Product:
        """A value as a product of factors of one sign each, where they are found.

        NoReading where it is divided by 0.
        """
        try:
            return Products(self.tower).by_factors(value)
        except ZeroDivisionError:
            raise NoReading(f"a division by 0: {value}") from None

    def _expression(self, poly: Poly) -> sp.Expr:
        return poly.as_expr(*(real(name) for name in self.tower.variables))

    def _root_of_factor(self, factor: sp.Expr) -> sp.Expr:
        for each in self.coordinates:
            if factor == real(each.parameter) and not each.rooted:
                raise RootOfParameter(each.name)
        poly = self.tower.fraction(factor).num
        for parts in halves(self.tower, poly):
            before = self.generators, self.tower
            found = self._denested(factor, *(self._expression(part) for part in parts))
            if found is not None:
                return found
            self.generators, self.tower = before
        if not plain(poly):
            raise NoReading(f"the square root of what is not shown to be positive: {factor}")
        return self._generator(factor)

    def _denested(self, square: sp.Expr, first: sp.Expr, second: sp.Expr) -> sp.Expr | None:
        """The sum or the difference of two roots, whichever has the square, as it is positive."""
        try:
            one, other = self.root(first), self.root(second)
            for found in (one + other, one - other):
                if self.tower.is_zero(found**2 - square):
                    product = self.product(found)
                    if shown(product):
                        return found if product.constant > 0 else -found
        except NoReading:
            pass
        return None

    def _generator(self, radicand: sp.Expr) -> sp.Expr:
        for entry in self.generators:
            if entry.radicand == radicand:
                return real(entry.symbol)
        symbol = f"root_{len(self.generators) + 1}_"
        self.generators = [*self.generators, Generator(symbol, radicand)]
        self.tower = self._tower()
        return real(symbol)


def halves(tower: Tower, poly: Poly) -> Iterator[tuple[Poly, Poly]]:
    """(a + d)/2 and (a - d)/2 for every generator y for which d is a polynomial."""
    for position in reversed(range(len(tower.generators))):
        index = len(tower.parameters) + position
        if poly.degree(index) != 1:
            continue
        rooted = linear(poly, index)
        free = poly - rooted
        root = _root(tower.reduce(free * free - rooted * rooted))
        if root is not None:
            yield (free + root).quo_ground(2), (free - root).quo_ground(2)


def _root(poly: Poly) -> Poly | None:
    """The polynomial whose square this is, of either sign."""
    if not poly:
        return None
    constant, factors = poly.factor_list()
    number = sp.sqrt(poly.ring.domain.to_sympy(constant))
    if not number.is_Rational or any(power % 2 for _, power in factors):
        return None
    found = poly.ring.ground_new(poly.ring.domain.from_sympy(number))
    for factor, power in factors:
        found *= factor ** (power // 2)
    return found
