"""Generators as certificates write them: roots one at a time, and coupled pairs."""

from __future__ import annotations

from collections.abc import Sequence

from gainproof.verify.certificate import schema, written_polynomials
from gainproof.verify.certificate.coupled_roots import Pair
from gainproof.verify.certificate.field import Field, Generator
from gainproof.verify.certificate.monomials import WIDTH
from gainproof.verify.certificate.plain_data import Plain
from gainproof.verify.certificate.polynomial import Polynomial, Ring
from gainproof.verify.certificate.rejection import MAXIMUM_ROOT, RejectedError

_MAXIMUM_CONSTANTS = 12


def number_of_variables(entries: Sequence[Plain]) -> int:
    """How many variables these generators are: a coupled pair is two."""
    return sum(2 if _is_pair(entry) else 1 for entry in entries)


def extended(field: Field, value: Plain, place: str) -> Field:
    """The field with one more generator, or with a coupled pair; each shown to be positive."""
    if not _is_pair(value):
        return field.with_generator(_read_generator(value, field, place))
    return field.with_pair(_read_pair(value, field, place))


def read_constants(value: Plain, tower: Field, position: int, place: str) -> Field:
    """The remaining parameters, and positive roots of polynomials in them."""
    entries = schema.items(value, place)
    if len(entries) > _MAXIMUM_CONSTANTS:
        raise RejectedError(f"{place}: more than {_MAXIMUM_CONSTANTS} constants")
    held = tuple(p for i, p in enumerate(tower.parameters) if i != position)
    size = len(held) + number_of_variables(entries)
    field = Field(Ring(size, tower.ring.meter), held, (), ())
    for number_, entry in enumerate(entries):
        field = extended(field, entry, f"{place}[{number_}]")
    names = field.variables()
    for number_, name in enumerate(names):
        if number_ >= len(held) and name in (*tower.variables(), *names[:number_]):
            raise RejectedError(f"{place}: the name {name!r} is given twice")
    return field


def lifted(value: Polynomial, ring: Ring) -> Polynomial:
    """The same polynomial in a ring with further variables at the end."""
    padding = WIDTH * (ring.size - value.ring.size)
    return Polynomial(ring, {m << padding: c for m, c in value.terms.items()}, value.denominator)


def lifted_generators(generators: Sequence[Generator], ring: Ring) -> tuple[Generator, ...]:
    """The same generators over a ring with further variables at the end."""
    found: list[Generator] = []
    for entry in generators:
        pair = entry.pair
        if pair is not None:
            (a, c), (b, e) = pair.free, pair.slopes
            pair = Pair(
                pair.symbols,
                pair.position,
                (lifted(a, ring), lifted(c, ring)),
                (lifted(b, ring), lifted(e, ring)),
            )
        found.append(Generator(entry.symbol, entry.power, lifted(entry.radicand, ring), pair))
    return tuple(found)


def _is_pair(value: Plain) -> bool:
    return isinstance(value, dict) and "coupled" in value


def _read_generator(value: Plain, field: Field, place: str) -> Generator:
    """A generator whose radicand holds earlier variables only."""
    fields = schema.record(value, ("symbol", "power", "radicand"), place)
    return Generator(
        schema.name(fields["symbol"], f"{place}.symbol"),
        schema.integer(fields["power"], 2, MAXIMUM_ROOT, f"{place}.power"),
        _earlier(fields["radicand"], field, f"{place}.radicand"),
    )


def _read_pair(value: Plain, field: Field, place: str) -> Pair:
    """x^2 = a + b y and y^2 = c + e x; a, b, c and e hold earlier variables only."""
    fields = schema.record(value, ("coupled", "free", "slopes"), place)
    names = [schema.name(n, f"{place}.coupled") for n in _two(fields["coupled"], place)]
    a, c = (_earlier(e, field, f"{place}.free") for e in _two(fields["free"], place))
    b, e = (_earlier(e, field, f"{place}.slopes") for e in _two(fields["slopes"], place))
    position = field.position(len(field.generators))
    return Pair((names[0], names[1]), position, (a, c), (b, e))


def _two(value: Plain, place: str) -> list[Plain]:
    found = schema.items(value, place)
    if len(found) != 2:
        raise RejectedError(f"{place}: two entries are wanted for a coupled pair")
    return found


def _earlier(value: Plain, field: Field, place: str) -> Polynomial:
    """A polynomial in the variables that the field has so far."""
    found = written_polynomials.polynomial(value, field.ring, place)
    for position in range(field.position(len(field.generators)), field.ring.size):
        if found.occurs(position):
            raise RejectedError(f"{place}: only earlier variables may occur")
    return found
