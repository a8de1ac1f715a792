"""A graph's values step by step, written as the checker of certificates writes them.

It takes sums over the least common multiple of known factors and cancels nothing else, so that a
divisor whose numerator has no plain sign there needs a listed fraction that shows it; which those
are is found by the same steps here. Nothing is decided by it.
"""

from __future__ import annotations

from collections.abc import Mapping
from dataclasses import dataclass
from fractions import Fraction as Number

import sympy as sp

from gainproof.derive.algebra.tower import Fraction, Poly, Tower
from gainproof.derive.expression import real
from gainproof.derive.printer.graph import Graph, operands
from gainproof.derive.stable_form.polynomial_products import Product, of_poly
from gainproof.derive.stable_form.signed_factors import Signs, plain


class NotShown(ValueError):
    """A divisor or a root that is not shown to be positive or negative."""


@dataclass(frozen=True)
class Ratio:
    """numerator / product of factor^multiplicity."""

    numerator: Poly
    factors: Mapping[Poly, int]


class Shown:
    """The values of a graph's nodes that an output needs; `roots` gives those of fractional powers.

    `nonzero`: the fractions that have to be listed, each equal to a divisor or to its negative.
    """

    def __init__(self, tower: Tower, graph: Graph, roots: Mapping[int, Fraction]) -> None:
        self.tower, self.graph, self.roots = tower, graph, roots
        self.signs = Signs(tower, range(len(tower.generators))[::-1])
        self.nonzero: list[Fraction] = []
        self.values: dict[int, Ratio] = {}

    def output(self, name: str) -> Ratio:
        """The value of an output."""
        end = self.graph["outputs"][name]
        for number in needed(self.graph, end):
            self.values[number] = self._value(number)
        return self.values[end]

    def _value(self, number: int) -> Ratio:
        node = self.graph["nodes"][number]
        parts = [self.values[part] for part in operands(node)]
        ring = self.tower.ring
        match node[0]:
            case "number":
                return Ratio(ring.ground_new(ring.domain.from_sympy(sp.Rational(node[1]))), {})
            case "symbol":
                return self._written(self.tower.fraction(real(str(node[1]))))
            case "add":
                total, *rest = parts
                for part in rest:
                    total = self._sum(total, part)
                return total
            case "mul":
                found, *rest = parts
                for part in rest:
                    found = self._times(found, part)
                return found
            case "div":
                return self._over(*parts)
            case "neg":
                return Ratio(-parts[0].numerator, parts[0].factors)
            case "pow":
                return self._power(number, parts[0], Number(str(node[2])))
        raise NotShown(f"node {number} {node} is none that is read")

    def _power(self, number: int, base: Ratio, exponent: Number) -> Ratio:
        one = Ratio(self.tower.ring.one, {})
        found = self._written(self.roots[number]) if exponent.denominator > 1 else base
        if exponent < 0:
            found = self._over(one, found)
        result = one
        for _ in range(abs(exponent.numerator)):
            result = self._times(result, found)
        return result

    def _written(self, value: Fraction) -> Ratio:
        return self._divided(Ratio(self.tower.reduce(value.num), {}), Ratio(value.den, {}))

    def _sum(self, first: Ratio, second: Ratio) -> Ratio:
        common = dict(first.factors)
        for factor, power in second.factors.items():
            common[factor] = max(power, common.get(factor, 0))
        total = self.tower.ring.zero
        for part in (first, second):
            extended = part.numerator
            for factor, power in common.items():
                for _ in range(power - part.factors.get(factor, 0)):
                    extended = self.tower.reduce(extended * factor)
            total += extended
        return Ratio(total, common if total else {})

    def _times(self, first: Ratio, second: Ratio) -> Ratio:
        factors = dict(first.factors)
        for factor, power in second.factors.items():
            factors[factor] = factors.get(factor, 0) + power
        return Ratio(self.tower.reduce(first.numerator * second.numerator), factors)

    def _over(self, first: Ratio, divisor: Ratio) -> Ratio:
        if not divisor.numerator:
            raise NotShown("a division by 0")
        if plain(divisor.numerator):
            return self._divided(first, divisor)
        listed = self._listed(divisor)
        if listed not in self.nonzero:
            self.nonzero.append(listed)
        return self._divided(first, self._written(listed))

    def _listed(self, divisor: Ratio) -> Fraction:
        product = self.signs.product(divisor.numerator)
        for factor, power in divisor.factors.items():
            product = product * of_poly(factor) ** -power
        if product.constant < 0:
            product = Product(-product.constant, product.powers)
        return expanded(self.tower, product)

    def _divided(self, first: Ratio, divisor: Ratio) -> Ratio:
        factors, above = dict(first.factors), first.numerator
        for factor, power in divisor.factors.items():
            cancelled = min(power, factors.get(factor, 0))
            factors[factor] = factors.get(factor, 0) - cancelled
            above = self.tower.reduce(above * factor ** (power - cancelled))
        product = of_poly(divisor.numerator)
        for factor in product.powers:
            factors[factor] = factors.get(factor, 0) + 1
        constant = sp.QQ(product.constant.numerator, product.constant.denominator)
        kept = {factor: power for factor, power in factors.items() if power}
        return Ratio(above.quo_ground(constant), kept)


def expanded(tower: Tower, product: Product, above: bool = False) -> Fraction:
    """A product of factors of one sign each as a fraction of two such polynomials.

    NotShown if a factor has none, or with `above` if one below the line has none.
    """
    if not all(plain(factor) or (above and power > 0) for factor, power in product.powers.items()):
        raise NotShown("a divisor or a root is not shown to be positive or negative")
    ring = tower.ring
    over = ring.ground_new(sp.QQ(product.constant.numerator, product.constant.denominator))
    under = ring.one
    for factor, power in product.powers.items():
        if power > 0:
            over = tower.reduce(over * factor**power)
        else:
            under = tower.reduce(under * factor**-power)
    return Fraction(over, under)


def needed(graph: Graph, end: int) -> list[int]:
    """The nodes that one of them is computed from, in order."""
    found = {end}
    for number in range(end, -1, -1):
        if number in found:
            found.update(operands(graph["nodes"][number]))
    return sorted(found)
