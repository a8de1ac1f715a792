"""The value of a quotient at an end of the parameter's domain, exactly.

The one parameter p is written as a distance x -> 0: ``p = lower + x`` at the lower end, ``p = 1/x``
at infinity; each generator as ``y = Y x^(-weight)`` so that the rescaled relation
``Y^n = x^(n weight) radicand`` has no negative power of x. Then Y is continuous up to x = 0, where
it is the nonnegative root of the relation at x = 0: the certificate states it over constants (which
are positive roots of rational numbers), and the relation confirms it.

The limit is read from the lowest powers of x above and below the line. If their coefficients
vanish at x = 0 nothing can be concluded, and the statement is rejected.
"""

from __future__ import annotations

from collections.abc import Callable
from dataclasses import dataclass

from gainproof.verify.certificate import schema, written
from gainproof.verify.certificate.field import Field
from gainproof.verify.certificate.plain import Plain
from gainproof.verify.certificate.polynomial import Polynomial, Ring
from gainproof.verify.certificate.ratio import Ratio, number, polynomial
from gainproof.verify.certificate.rejection import RejectedError
from gainproof.verify.certificate.tower import Tower, read_generator

_MAXIMUM_WEIGHT = 64
_MAXIMUM_CONSTANTS = 12


@dataclass(frozen=True, slots=True)
class Boundary:
    """An end of the parameter's domain, with the rescaled generators' values there."""

    field: Field
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
            value = self.field.shifted(value)
        orders: dict[int, Polynomial] = {}
        for monomial, coefficient in value.coefficients():
            order = -monomial[0] if self.at_infinity else monomial[0]
            term = self.constants.ring.constant(coefficient)
            for weight, exponent, root in zip(
                self.weights, monomial[1:], self.values, strict=False
            ):
                order -= weight * exponent
                if exponent:
                    term = self.constants.reduce(term * root**exponent)
            previous = orders.get(order)
            orders[order] = term if previous is None else previous + term
        lowest = min(orders)
        return lowest, orders[lowest]


def read_boundary(
    value: Plain,
    tower: Tower,
    at_infinity: bool,
    place: str,
) -> tuple[Boundary, Callable[[set[int]], None]]:
    """The evidence of a limit, checked; and a function that rejects unused constants.

    The fields are "weights", "constants" and "boundary". Weights and boundary values are given for
    every generator. Weights are nonnegative at infinity and nonpositive at the lower end.
    """
    field = tower.field
    if len(field.parameters) != 1 or field.free:
        raise RejectedError(f"{place}: limits are possible in towers with one parameter only")
    fields = schema.record(value, ("weights", "constants", "boundary"), place)
    names = tuple(generator.symbol for generator in field.generators)
    weights = schema.record(fields["weights"], names, f"{place}.weights")
    lowest, highest = (0, _MAXIMUM_WEIGHT) if at_infinity else (-_MAXIMUM_WEIGHT, 0)
    scaled = tuple(
        schema.integer(weights[n], lowest, highest, f"{place}.weights.{n}") for n in names
    )
    constants = _read_constants(fields["constants"], field, f"{place}.constants")
    entries = schema.record(fields["boundary"], names, f"{place}.boundary")
    boundary = Boundary(field, at_infinity, scaled, constants, ())
    for index, generator_name in enumerate(names):
        root = written.polynomial(
            entries[generator_name], constants.ring, f"{place}.boundary.{generator_name}"
        )
        boundary = _with_root(boundary, index, root, f"{place}.boundary.{generator_name}")
    occurring = {
        i
        for i in range(constants.ring.size)
        if any(root.occurs(i) for root in boundary.values)
        or any(g.radicand.occurs(i) for g in constants.generators)
    }

    def finish(also_used: set[int]) -> None:
        idle = {
            constants.generators[i].symbol
            for i in range(constants.ring.size)
            if i not in occurring | also_used
        }
        schema.unused(idle, "constants", f"{place}.constants")

    return boundary, finish


def _read_constants(value: Plain, tower: Field, place: str) -> Field:
    entries = schema.items(value, place)
    if len(entries) > _MAXIMUM_CONSTANTS:
        raise RejectedError(f"{place}: more than {_MAXIMUM_CONSTANTS} constants")
    field = Field(Ring(len(entries), tower.ring.meter), (), (), ())
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
    return Boundary(
        field, boundary.at_infinity, boundary.weights, constants, (*boundary.values, root)
    )
