"""The value of a quotient at an end of one parameter's domain, exactly.

The tending parameter p is written as a distance x -> 0: ``p = lower + x`` at the lower end,
``p = 1/x`` at infinity; each generator as ``y = Y x^(-weight)`` so that the rescaled relation
``Y^n = x^(n weight) radicand`` has no negative power of x. The other parameters are held, at any
point of their domains. Then Y is continuous up to x = 0, where it is the nonnegative root of the
relation at x = 0: the certificate states it over constants (which are positive roots over the other
parameters), and the relation confirms it at every point of them.

The limit is read from the lowest powers of x above and below the line. If their coefficients are
not manifestly positive or negative for all values of the other parameters, nothing can be
concluded, and the statement is rejected. So the limit is one for every fixed value of the others;
nothing is said of them tending together.
"""

from __future__ import annotations

from collections.abc import Callable
from dataclasses import dataclass, replace
from fractions import Fraction

from gainproof.verify.certificate import schema, written
from gainproof.verify.certificate.field import Field
from gainproof.verify.certificate.plain import Plain
from gainproof.verify.certificate.polynomial import Monomial, Polynomial, Ring
from gainproof.verify.certificate.ratio import Ratio, number, polynomial
from gainproof.verify.certificate.rejection import RejectedError
from gainproof.verify.certificate.tower import Tower, read_generator

_MAXIMUM_WEIGHT = 64
_MAXIMUM_CONSTANTS = 12


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

    def _at_boundary(self, monomial: Monomial, coefficient: Fraction) -> Polynomial:
        """A term without the tending parameter, the generators' values put in.

        Values of later generators may still be missing: then their exponents are zero.
        """
        ring, parameters = self.constants.ring, len(self.field.parameters)
        others = [e for i, e in enumerate(monomial[:parameters]) if i != self.position]
        term = ring.monomial(dict(enumerate(others))).times(coefficient)
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
    constants = _read_constants(fields["constants"], field, position, f"{place}.constants")
    entries = schema.record(fields["boundary"], names, f"{place}.boundary")
    boundary = Boundary(field, position, at_infinity, scaled, constants, ())
    for index, generator_name in enumerate(names):
        root = written.polynomial(
            entries[generator_name], constants.ring, f"{place}.boundary.{generator_name}"
        )
        boundary = _with_root(boundary, index, root, f"{place}.boundary.{generator_name}")
    first = len(constants.parameters)
    occurring = {
        i
        for i in range(first, constants.ring.size)
        if any(root.occurs(i) for root in boundary.values)
        or any(g.radicand.occurs(i) for g in constants.generators)
    }

    def finish(also_used: set[int]) -> None:
        idle = {
            constants.generators[i - first].symbol
            for i in range(first, constants.ring.size)
            if i not in occurring | also_used
        }
        schema.unused(idle, "constants", f"{place}.constants")

    return boundary, finish


def _read_constants(value: Plain, tower: Field, position: int, place: str) -> Field:
    """The remaining parameters, and positive roots of polynomials in them."""
    entries = schema.items(value, place)
    if len(entries) > _MAXIMUM_CONSTANTS:
        raise RejectedError(f"{place}: more than {_MAXIMUM_CONSTANTS} constants")
    held = tuple(p for i, p in enumerate(tower.parameters) if i != position)
    field = Field(Ring(len(held) + len(entries), tower.ring.meter), held, (), ())
    for number_, entry in enumerate(entries):
        constant = read_generator(entry, field, f"{place}[{number_}]")
        if constant.symbol in (*tower.variables(), *field.variables()):
            raise RejectedError(f"{place}: the name {constant.symbol!r} is given twice")
        field = field.with_generator(constant)
    return field


def _with_root(boundary: Boundary, index: int, root: Polynomial, place: str) -> Boundary:
    """Add a generator's value at the boundary after checking its rescaled relation there."""
    field, constants = boundary.field, boundary.constants
    generator = field.generators[index]
    if not constants.nonnegative(root):
        raise RejectedError(f"{place}: not manifestly nonnegative")
    order, coefficient = boundary.lowest_terms(generator.radicand)
    order += generator.power * boundary.weights[index]
    if order < 0:
        raise RejectedError(
            f"{place}: the weight is too small, the rescaled relation has a negative power of x"
        )
    right = coefficient if order == 0 else constants.ring.constant(0)
    if not constants.is_zero(root**generator.power - right):
        raise RejectedError(f"{place}: not a root of the rescaled relation at the boundary")
    return replace(boundary, values=(*boundary.values, root))
