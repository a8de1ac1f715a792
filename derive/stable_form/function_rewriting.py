"""Functions of a library in an expression replaced by atoms: see `function_atoms` for the rules."""

from __future__ import annotations

from collections.abc import Callable, Iterable, Mapping, Sequence
from typing import Any

import sympy as sp

from gainproof.derive.expression import real
from gainproof.derive.stable_form.coordinates import Coordinate
from gainproof.derive.stable_form.function_atoms import Atom
from gainproof.derive.stable_form.real_values import Required, requirements
from gainproof.derive.stable_form.root_tower import NoReading, Reading, shown

BELOW_PI = sp.Integer(3)  # an angle up to here lies below pi
GREATEST = sp.Integer(700)  # exponent: exp of it is a number of float64
MOST_ANGLES = 6  # of cos(k u) as a polynomial of cos u
_RATIOS: Mapping[Any, Callable[[sp.Expr], sp.Expr]] = {
    sp.tan: lambda x: sp.sin(x) / sp.cos(x),
    sp.cot: lambda x: sp.cos(x) / sp.sin(x),
    sp.sec: lambda x: 1 / sp.cos(x),
    sp.csc: lambda x: 1 / sp.sin(x),
}


class Rewriting:
    """The atoms of one expression on one domain; their arguments may hold inputs and other atoms.

    `required`: what has to be positive besides arguments of atoms, by value.

    `narrow`: the same inputs between all their ends, where a function asks for a range. `prefix`
    begins the names of atoms; `rooted`: names of those of which the root is the parameter.
    """

    def __init__(
        self,
        domain: Sequence[Coordinate],
        narrow: Sequence[Coordinate],
        prefix: str,
        rooted: Callable[[Coordinate], Coordinate],
    ) -> None:
        self.domain, self.narrow = tuple(map(rooted, domain)), tuple(map(rooted, narrow))
        self.prefix, self.rooted = prefix, rooted
        self.atoms: dict[str, Atom] = {}
        self.required: dict[sp.Expr, Required] = {}
        self._numbers: dict[sp.Expr, set[sp.Rational]] = {}

    def reading(self, value: sp.Expr, domain: Sequence[Coordinate] = ()) -> Reading:
        """An empty reading of those inputs and atoms that occur in a value."""
        atoms = (self.rooted(atom.coordinate) for atom in self.atoms.values())
        names = {symbol.name for symbol in value.free_symbols}
        return Reading([each for each in (*(domain or self.domain), *atoms) if each.name in names])

    def rewrite(self, expression: sp.Expr) -> sp.Expr:
        """The expression without functions; NoReading for those that no rule replaces, and where
        it is not shown to be a real number.
        """
        if not expression.has(sp.Function) and not expression.has(sp.exp):
            return expression
        plain = exact(expression)
        asked = [(each, exact(each.value)) for each in requirements(expression)]
        self._numbers = numbers([plain, *(value for _, value in asked)])
        for each, value in asked:
            self._require(self._replaced(value), each.reason, each.either, each.value)
        return self._replaced(plain)

    def _require(
        self, value: sp.Expr, reason: str, either: bool = False, came: sp.Expr | None = None
    ) -> None:
        """NoReading unless the value, as it `came`, is shown to be positive, or with `either`
        negative.
        """
        for domain in (self.domain, self.narrow):
            reading = self.reading(value, domain)
            product = reading.product(reading.read(value))
            if product.constant and shown(product) and (either or product.constant > 0):
                positive = value if product.constant > 0 else -value
                if not positive.is_number and positive not in self.required:
                    name = f"{self.prefix}_required_{len(self.required) + 1}_"
                    self.required[positive] = Required(name, positive, reading, reason)
                return
        wanted = "other than 0" if either else "positive"
        raise NoReading(f"{came or value} is not shown to be {wanted}, and {reason}")

    def _replaced(self, expression: sp.Expr) -> sp.Expr:
        if isinstance(expression, sp.Add):
            return self._sum(expression)
        if isinstance(expression, sp.log):
            return self._logarithm(self._replaced(expression.args[0]))
        if isinstance(expression, sp.atan):
            return self._arctangent(self._replaced(expression.args[0]), sp.Integer(0))
        if isinstance(expression, sp.exp):
            return self._exponential(expression.args[0])
        if isinstance(expression, (sp.sin, sp.cos)):
            return self._angle(expression)
        if not expression.args:
            return expression
        return expression.func(*map(self._replaced, expression.args))

    def _sum(self, expression: sp.Add) -> sp.Expr:
        """Logarithms with the same factor as one, arctangents of opposite sign as one."""
        rest: list[sp.Expr] = []
        ratios: dict[sp.Expr, sp.Expr] = {}
        angles: dict[sp.Expr, list[sp.Expr]] = {}
        for term in expression.args:
            number, product = term.as_coeff_Mul()
            factors = sp.Mul.make_args(product)
            functions = [each for each in factors if isinstance(each, (sp.log, sp.atan))]
            if len(functions) != 1:
                rest.append(self._replaced(term))
                continue
            (function,) = functions
            factor = self._replaced(product / function)
            argument = self._replaced(function.args[0])
            if isinstance(function, sp.log) and number.is_Integer:
                ratios[factor] = ratios.get(factor, sp.Integer(1)) * argument**number
            elif isinstance(function, sp.atan) and -number * factor in angles:
                other = angles[-number * factor].pop()
                rest.append(-number * factor * self._arctangent(other, argument))
            elif isinstance(function, sp.atan):
                angles.setdefault(number * factor, []).append(argument)
            else:
                rest.append(number * factor * self._logarithm(argument))
        rest += [factor * self._logarithm(ratio) for factor, ratio in ratios.items()]
        for factor, alone in angles.items():
            rest += [factor * self._arctangent(each, sp.Integer(0)) for each in alone]
        return sp.Add(*rest)

    def _logarithm(self, ratio: sp.Expr) -> sp.Expr:
        sign, atom = self._either("logarithm", ratio - 1, 1 / ratio - 1)
        return sign * atom

    def _arctangent(self, first: sp.Expr, second: sp.Expr) -> sp.Expr:
        under = 1 + first * second
        self._require(under, "a difference of arctangents is one arctangent")
        sign, atom = self._either("arctangent", (first - second) / under, (second - first) / under)
        return sign * atom

    def _either(self, kind: str, above: sp.Expr, below: sp.Expr) -> tuple[int, sp.Expr]:
        """The sign of a function, and the atom of its argument, which is one of two."""
        sign = self._sign(above)
        if not sign:
            raise NoReading(f"{kind}: the sign of an argument is not found: {above}")
        return sign, self._atom(kind, above if sign > 0 else below)

    def _exponential(self, exponent: sp.Expr) -> sp.Expr:
        """exp(k u) by exp(u) - 1 or 1 - exp(-u), with a positive u and a whole k."""
        number, product = exponent.as_coeff_Mul()
        step = self._step(product)
        sign = self._sign(self._replaced(product))
        if not sign:
            raise NoReading(f"an exponent whose sign is not found: {exponent}")
        argument, power = self._replaced(sign * step * product), sign * number / step
        grows = any(sign * each > 0 for each in self._numbers.get(product, ()))
        if grows and self._sign(GREATEST - argument) == 1:
            return (1 + self._atom("growth", argument)) ** power
        return (1 - self._atom("decay", argument)) ** -power

    def _step(self, product: sp.Expr) -> sp.Rational:
        """The greatest common divisor of the numbers that stand with a product."""
        return abs(sp.gcd_list(sorted(self._numbers.get(product, {sp.Integer(1)}))))

    def _angle(self, function: sp.Expr) -> sp.Expr:
        """cos(k u) and sin(k u) as polynomials of cos u and sin u, those by the half angle."""
        number, product = function.args[0].as_coeff_Mul()
        step = self._step(product)
        angle = self._replaced(step * product)
        count = int(abs(number / step))
        if count > MOST_ANGLES:
            raise NoReading(f"a multiple of an angle above {MOST_ANGLES}: {function}")
        self._require(BELOW_PI - angle, "an angle is not above 3")
        half = self._atom("half_angle", angle)
        cosine, sine = 1 - 2 * half, 2 * sp.sqrt(half) * sp.sqrt(1 - half)
        if isinstance(function, sp.cos):
            return sp.chebyshevt_poly(count, cosine)
        return sp.sign(number) * sine * sp.chebyshevu_poly(count - 1, cosine)

    def _sign(self, value: sp.Expr) -> int:
        """1 or -1 where the sign is shown on the whole domain, else 0."""
        for domain in (self.domain, self.narrow):
            reading = self.reading(value, domain)
            product = reading.product(reading.read(value))
            if shown(product):
                return (product.constant > 0) - (product.constant < 0)
        return 0

    def _atom(self, kind: str, value: sp.Expr) -> sp.Expr:
        """The symbol of an atom with this argument."""
        for atom in self.atoms.values():
            if (atom.kind, atom.value) == (kind, value):
                return real(atom.name)
        reading = self.reading(value)
        argument = reading.product(reading.read(value))
        if argument.constant <= 0 or not shown(argument):
            raise NoReading(f"{kind}: an argument that is not shown to be positive: {value}")
        name = f"{self.prefix}_{kind}_{len(self.atoms) + 1}_"
        self.atoms[name] = Atom(name, kind, value, reading, argument)
        return real(name)


def exact(expression: sp.Expr) -> sp.Expr:
    """Hyperbolic functions by exponentials of single terms, tangents by sines and cosines."""
    found = expression.rewrite([sp.sinh, sp.cosh, sp.tanh, sp.coth], sp.exp)
    for function in (sp.tan, sp.cot, sp.sec, sp.csc):
        found = found.replace(function, lambda x, f=function: _RATIOS[f](x))
    return sp.expand_power_exp(found)


def numbers(expressions: Iterable[sp.Expr]) -> dict[sp.Expr, set[sp.Rational]]:
    """Of exponents and angles, number times a product: which numbers stand with each product."""
    found: dict[sp.Expr, set[sp.Rational]] = {}
    for expression in expressions:
        for function in expression.atoms(sp.exp, sp.sin, sp.cos):
            number, product = function.args[0].as_coeff_Mul()
            found.setdefault(product, set()).add(number)
    return found
