"""SymPy expressions of square roots read into a tower: each root of an irreducible factor once."""

from __future__ import annotations

from collections.abc import Mapping, Sequence
from fractions import Fraction

import sympy as sp

from gainproof.derive.algebra.tower import Generator, Parameter, Poly, Tower
from gainproof.derive.expression import real
from gainproof.derive.stable_form.coordinates import Coordinate
from gainproof.derive.stable_form.product import Product
from gainproof.derive.stable_form.signs import Signs, plain


class NoReading(ValueError):
    """An expression that is not read on a domain: of a kind that is not known, with a root of what
    is not shown to be positive, or with a divisor that is not shown to be other than 0.
    """


class RootOfParameter(Exception):
    """The root of a parameter is needed: it should be the parameter itself."""

    def __init__(self, parameter: str) -> None:
        super().__init__(parameter)
        self.parameter = parameter


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

    @property
    def signs(self) -> Signs:
        """The search for signs, outer roots first."""
        return Signs(self.tower, range(len(self.generators))[::-1])

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
                if power < 0 and not all(map(plain, self.product(base).powers)):
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
        if product.constant < 0 or not all(map(plain, product.powers)):
            raise NoReading(f"the square root of what is not shown to be positive: {value}")
        number = product.constant.numerator * product.constant.denominator
        found = sp.Integer(1) / product.constant.denominator
        for prime, power in sp.factorint(number).items():
            found *= sp.Integer(prime) ** (power // 2)
            if power % 2:
                found *= self._generator(sp.Integer(prime))
        # once each, for each generator changes the tower, of which the factors are
        for factor, power in [(self._expression(f), p) for f, p in product.powers.items()]:
            found *= factor ** (power // 2)
            if power % 2:
                found *= self._root_of_factor(factor)
        return found

    def product(self, value: sp.Expr) -> Product:
        """A value as a product of factors of one sign each, where they are found."""
        try:
            fraction = self.tower.fraction(value)
        except ZeroDivisionError:
            raise NoReading(f"a division by 0: {value}") from None
        if not fraction.num:
            return Product(Fraction(0))
        signs = self.signs
        return signs.product(fraction.num) * signs.product(fraction.den) ** -1

    def _expression(self, poly: Poly) -> sp.Expr:
        return poly.as_expr(*(real(name) for name in self.tower.variables))

    def _root_of_factor(self, factor: sp.Expr) -> sp.Expr:
        for each in self.coordinates:
            if factor == real(each.parameter):
                raise RootOfParameter(each.name)
        return self._generator(factor)

    def _generator(self, radicand: sp.Expr) -> sp.Expr:
        for entry in self.generators:
            if entry.radicand == radicand:
                return real(entry.symbol)
        symbol = f"root_{len(self.generators) + 1}"
        self.generators.append(Generator(symbol, radicand))
        self.tower = self._tower()
        return real(symbol)
