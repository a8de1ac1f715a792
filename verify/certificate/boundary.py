"""The value of a quotient at an end of one parameter's domain, exactly.

The tending parameter p is written as a distance x -> 0: ``p = lower + x`` at the lower end, ``p =
1/x`` at infinity; each generator as ``y = Y x^(-weight)`` so that the rescaled relation ``Y^n =
x^(n weight) radicand`` has no negative power of x. The other parameters are held, at any point of
their domains. Then Y is continuous up to x = 0, where it is the nonnegative root of the relation at
x = 0 (of a coupled pair see `coupled_boundary`): the certificate states it over constants (which
are positive roots over the other parameters), and the relation confirms it at every point of them.

The limit is read from the lowest powers of x above and below the line. If their coefficients are
not manifestly positive or negative for all values of the other parameters, nothing can be
concluded, and the statement is rejected. So the limit is one for every fixed value of the others;
nothing is said of them tending together.
"""

from __future__ import annotations

from collections.abc import Callable
from dataclasses import dataclass, replace
from fractions import Fraction

from gainproof.verify.certificate import schema, written_polynomials
from gainproof.verify.certificate.coupled_boundary import require_pair, require_root
from gainproof.verify.certificate.field import Field
from gainproof.verify.certificate.generator import read_constants
from gainproof.verify.certificate.plain_data import Plain
from gainproof.verify.certificate.polynomial import Exponents, Polynomial
from gainproof.verify.certificate.ratio import Ratio, number, polynomial
from gainproof.verify.certificate.rejection import RejectedError
from gainproof.verify.certificate.tower import Tower

_MAXIMUM_WEIGHT = 64


@dataclass(frozen=True, slots=True)
class Boundary:
    """An end of one parameter's domain, with the rescaled generators' values there.

    ``constants`` holds the other parameters and then the constants.
    """

    field: Field
    position: int
    at_infinity: bool
    weights: tuple[int, ...]
    constants: Field
    values: tuple[Polynomial, ...]

    def limit(self, value: Ratio) -> Ratio | None:
        """The limit as a quotient of constants; None for plus infinity.

        Raises RejectedError when the lowest coefficients do not decide it.
        """
        if value.is_zero():
            return number(self.constants, 0)
        order, above = self._lowest(value.numerator)
        below = number(self.constants, 1)
        for factor, multiplicity in value.factors.items():
            inner, leading = self._lowest(factor)
            order -= inner * multiplicity
            below = below * polynomial(self.constants, leading).power(multiplicity)
        if order > 0:
            return number(self.constants, 0)
        ratio = polynomial(self.constants, above).over(below)
        if order == 0:
            return ratio
        if not self.constants.positive(ratio.numerator):
            raise RejectedError("the limit is not plus infinity")
        return None

    def _lowest(self, value: Polynomial) -> tuple[int, Polynomial]:
        """The lowest power of x in a polynomial, and its coefficient at the boundary."""
        order, coefficient = self.lowest_terms(value)
        leading = self.constants.reduce(coefficient)
        if not (self.constants.positive(leading) or self.constants.positive(-leading)):
            raise RejectedError(
                "the limit is not determined: the coefficient of the lowest power "
                "is not shown to be nonzero at the boundary"
            )
        return order, leading

    def lowest_terms(self, value: Polynomial) -> tuple[int, Polynomial]:
        """The lowest power of x, and its coefficient at the boundary, not reduced."""
        if not self.at_infinity:
            value = self.field.shifted_at(value, self.position)
        orders: dict[int, Polynomial] = {}
        for monomial, coefficient in value.coefficients():
            order = -monomial[self.position] if self.at_infinity else monomial[self.position]
            term = self._at_boundary(monomial, coefficient)
            for weight, exponent in zip(
                self.weights, monomial[len(self.field.parameters) :], strict=True
            ):
                order -= weight * exponent
            previous = orders.get(order)
            orders[order] = term if previous is None else previous + term
        lowest = min(orders)
        return lowest, orders[lowest]

    def held(self, value: Ratio) -> Ratio:
        """A quantity that does not depend on the tending parameter, over the constants.

        Raises RejectedError for one that does.
        """
        result = polynomial(self.constants, self._held(value.numerator))
        for factor, multiplicity in value.factors.items():
            below = self.constants.reduce(self._held(factor))
            if not self.constants.positive(below):
                raise RejectedError("a denominator is not shown to be positive at the boundary")
            result = result.over(polynomial(self.constants, below).power(multiplicity))
        return result

    def _held(self, value: Polynomial) -> Polynomial:
        field = self.field
        if self.position in field.depends_on(value):
            raise RejectedError(
                f"the value of a limit depends on {field.parameters[self.position].symbol!r}, "
                "the parameter that tends"
            )
        for number_, weight in enumerate(self.weights):
            # with a weight the value here belongs to the rescaled generator, not to itself
            if weight and value.occurs(field.position(number_)):
                raise RejectedError("the value of a limit holds a rescaled generator")
        result = self.constants.ring.constant(0)
        for monomial, coefficient in value.coefficients():
            result = result + self._at_boundary(monomial, coefficient)
        return result

    def _at_boundary(self, monomial: Exponents, coefficient: Fraction) -> Polynomial:
        """A term without the tending parameter, the generators' values put in.

        Values of later generators may still be missing: then their exponents are zero.
        """
        ring, parameters = self.constants.ring, len(self.field.parameters)
        others = [e for i, e in enumerate(monomial[:parameters]) if i != self.position]
        term = ring.monomial(dict(enumerate(others))).times(coefficient)
        if any(monomial[parameters + len(self.values) :]):
            raise RejectedError("a generator without a value at the boundary occurs")
        for exponent, root in zip(monomial[parameters:], self.values, strict=False):
            if exponent:
                term = self.constants.reduce(term * root**exponent)
        return term


def read_boundary(
    value: Plain,
    tower: Tower,
    end: tuple[int, bool],
    place: str,
) -> tuple[Boundary, Callable[[set[int]], None]]:
    """The evidence of a limit, checked; and a function that rejects unused constants.

    ``end`` is the place of the parameter that tends, and whether to infinity. The fields are
    "weights", "constants" and "boundary". Weights and boundary values are given for every
    generator. Weights are nonnegative at infinity and nonpositive at the lower end.
    """
    field = tower.field
    if field.free:
        raise RejectedError(f"{place}: no limits with free symbols")
    position, at_infinity = end
    fields = schema.record(value, ("weights", "constants", "boundary"), place)
    names = tuple(generator.symbol for generator in field.generators)
    weights = schema.record(fields["weights"], names, f"{place}.weights")
    lowest, highest = (0, _MAXIMUM_WEIGHT) if at_infinity else (-_MAXIMUM_WEIGHT, 0)
    scaled = tuple(
        schema.integer(weights[n], lowest, highest, f"{place}.weights.{n}") for n in names
    )
    constants = read_constants(fields["constants"], field, position, f"{place}.constants")
    entries = schema.record(fields["boundary"], names, f"{place}.boundary")
    boundary = Boundary(field, position, at_infinity, scaled, constants, ())
    roots: list[Polynomial] = []
    for generator_name in names:
        root = written_polynomials.polynomial(
            entries[generator_name], constants.ring, f"{place}.boundary.{generator_name}"
        )
        if not constants.nonnegative(root):
            raise RejectedError(f"{place}.boundary.{generator_name}: not manifestly nonnegative")
        roots.append(root)
    for index, generator in enumerate(field.generators):
        if index < len(boundary.values):
            continue  # the second of a pair
        where = f"{place}.boundary.{generator.symbol}"
        if generator.pair is None:
            require_root(boundary, index, roots[index], where)
            boundary = replace(boundary, values=(*boundary.values, roots[index]))
        else:
            both = roots[index], roots[index + 1]
            require_pair(boundary, index, both, where)
            boundary = replace(boundary, values=(*boundary.values, *both))
    first = len(constants.parameters)
    occurring = {
        i
        for i in range(first, constants.ring.size)
        if any(root.occurs(i) for root in boundary.values)
        or any(c.occurs(i) for g in constants.generators for c in g.coefficients)
    }

    def finish(also_used: set[int]) -> None:
        used = occurring | also_used
        for generator in constants.generators:
            if generator.pair is not None:  # there is not the one without the other
                both = {generator.pair.position, generator.pair.position + 1}
                used = used | both if used & both else used
        idle = {
            constants.generators[i - first].symbol
            for i in range(first, constants.ring.size)
            if i not in used
        }
        schema.unused(idle, "constants", f"{place}.constants")

    return boundary, finish
