"""Towers as certificates write them: parameters, positive roots over them, and named elements."""

from __future__ import annotations

from collections.abc import Mapping
from fractions import Fraction

from gainproof.verify.certificate import schema, written_polynomials
from gainproof.verify.certificate.field import Field, Parameter
from gainproof.verify.certificate.generator import (
    extended,
    lifted,
    lifted_generators,
    number_of_variables,
)
from gainproof.verify.certificate.plain_data import Plain
from gainproof.verify.certificate.polynomial import Polynomial, Ring
from gainproof.verify.certificate.ratio import Ratio, polynomial
from gainproof.verify.certificate.rejection import (
    MAXIMUM_ELEMENTS,
    MAXIMUM_VARIABLES,
    Meter,
    RejectedError,
)
from gainproof.verify.certificate.written_polynomials import WrittenFraction


class Tower:
    """A field and the named elements over it; remembers which names were used.

    ``written`` keeps the elements' fractions as they came, for what is expanded unreduced.
    """

    __slots__ = ("_positions", "elements", "field", "used", "written")

    def __init__(
        self,
        field: Field,
        elements: Mapping[str, Ratio],
        used: set[str],
        written: Mapping[str, WrittenFraction] | None = None,
    ) -> None:
        self.field = field
        self.elements = elements
        self.used = used
        self.written = written or {}
        self._positions = {name: i for i, name in enumerate(field.variables())}

    def knows(self, name: str) -> bool:
        """Whether the name is a variable or an element."""
        return name in self._positions or name in self.elements

    def value(self, name: str) -> Ratio:
        """The quantity of that name. Raises RejectedError for an unknown one."""
        self.used.add(name)
        if name in self.elements:
            return self.elements[name]
        if name in self._positions:
            return polynomial(self.field, self.field.ring.variable(self._positions[name]))
        raise RejectedError(f"the symbol {name!r} is neither a variable nor an element here")

    def parameter_position(self, name: str) -> int | None:
        """The place of the parameter of that name, if it is one."""
        for position, parameter in enumerate(self.field.parameters):
            if parameter.symbol == name:
                return position
        return None

    def mark(self, value: Polynomial) -> None:
        """Remember that the variables of a polynomial were used."""
        for position, name in enumerate(self.field.variables()):
            if value.occurs(position):
                self.used.add(name)

    def with_free(self, names: tuple[str, ...]) -> Tower:
        """The same tower with free symbols appended; their names must be new."""
        if not names:
            return self
        for number, name in enumerate(names):
            if self.knows(name) or name in names[:number]:
                raise RejectedError(f"the free symbol {name!r} already has a meaning")
        old = self.field
        ring = Ring(old.ring.size + len(names), old.ring.meter)
        field = Field(ring, old.parameters, lifted_generators(old.generators, ring), names)
        elements = {
            name: Ratio(
                field,
                lifted(value.numerator, ring),
                {lifted(f, ring): m for f, m in value.factors.items()},
            )
            for name, value in self.elements.items()
        }
        return Tower(field, elements, self.used)

    def unused(self) -> set[str]:
        """The variables and elements that nothing used so far."""
        used = set(self.used)
        for generator in self.field.generators:
            if generator.pair is not None and used.intersection(generator.pair.symbols):
                used.update(generator.pair.symbols)  # there is not the one without the other
        return {*self._positions, *self.elements} - used


def read_tower(value: Plain, meter: Meter, place: str) -> Tower:
    """A tower, each radicand and denominator shown manifestly positive, each name new."""
    fields = schema.record(value, ("parameters", "generators", "elements"), place)
    parameters = tuple(
        _parameter(entry, f"{place}.parameters[{i}]")
        for i, entry in enumerate(schema.items(fields["parameters"], f"{place}.parameters"))
    )
    entries = schema.items(fields["generators"], f"{place}.generators")
    elements = schema.table(fields["elements"], f"{place}.elements")
    size = len(parameters) + number_of_variables(entries)
    if size > MAXIMUM_VARIABLES or len(elements) > MAXIMUM_ELEMENTS:
        raise RejectedError(f"{place}: more variables or elements than any certificate needs")
    field = Field(Ring(size, meter), parameters, (), ())
    for number, entry in enumerate(entries):
        field = extended(field, entry, f"{place}.generators[{number}]")
    names = [*field.variables(), *elements]
    for number, name in enumerate(names):
        schema.name(name, f"{place}.elements")
        if name in names[:number]:
            raise RejectedError(f"{place}: the name {name!r} is given twice")
    tower = Tower(field, {}, set())
    for generator in field.generators:
        for coefficient in generator.coefficients:
            tower.mark(coefficient)
    values: dict[str, Ratio] = {}
    fractions: dict[str, WrittenFraction] = {}
    for name, entry in elements.items():
        fraction = written_polynomials.read_fraction(entry, field.ring, f"{place}.elements.{name}")
        tower.mark(fraction.numerator)
        tower.mark(fraction.denominator)
        values[name], fractions[name] = fraction.ratio(field), fraction
    return Tower(field, values, tower.used, fractions)


def _parameter(value: Plain, place: str) -> Parameter:
    bound = "from" if "from" in schema.table(value, place) else "above"
    fields = schema.record(value, ("symbol", bound), place)
    lower = schema.number(fields[bound], f"{place}.{bound}")
    if bound == "above" and lower != Fraction(0):
        raise RejectedError(f"{place}.above: only '0' is possible")
    return Parameter(schema.name(fields["symbol"], f"{place}.symbol"), lower, bound == "from")
