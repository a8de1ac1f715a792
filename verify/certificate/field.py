"""Parameters and positive roots: reduction by the relations, and what is manifestly positive.

A field here is a list of real variables in a fixed order: parameters, each on a half line; then
generators, each the positive real root ``y^n = radicand`` of a polynomial in earlier variables, or
two of them that stand in each other's radicand (`coupled` shows that there is one such pair); then
free symbols, about which nothing is known. Two polynomials whose difference reduces to zero
are equal at every point. The converse may fail (when a radicand is a perfect power): then a true
statement is rejected, never a false one accepted.
"""

from __future__ import annotations

from collections.abc import Iterable
from dataclasses import dataclass
from fractions import Fraction

from gainproof.verify.certificate.coupled_roots import Pair
from gainproof.verify.certificate.monomials import DIGIT, beyond
from gainproof.verify.certificate.polynomial import Polynomial, Ring
from gainproof.verify.certificate.rejection import MAXIMUM_EXPONENT, RejectedError


@dataclass(frozen=True, slots=True)
class Parameter:
    """A real variable above ``lower`` (open), or from ``lower`` on (closed)."""

    symbol: str
    lower: Fraction
    closed: bool


@dataclass(frozen=True, slots=True)
class Generator:
    """The positive real root y of ``y^power = radicand``; one of a ``pair``, or by itself."""

    symbol: str
    power: int
    radicand: Polynomial
    pair: Pair | None = None

    @property
    def coefficients(self) -> tuple[Polynomial, ...]:
        """What it is made of: polynomials in earlier variables."""
        return (self.radicand,) if self.pair is None else self.pair.coefficients


class Field:
    """Variables with their domains and relations.

    Built up one variable at a time by the readers of towers: ``generators`` are only ever appended,
    after the radicand has been shown manifestly positive.
    """

    __slots__ = ("free", "generators", "parameters", "reduced", "ring")

    def __init__(
        self,
        ring: Ring,
        parameters: tuple[Parameter, ...],
        generators: tuple[Generator, ...],
        free: tuple[str, ...],
    ) -> None:
        self.ring = ring
        self.parameters = parameters
        self.generators = generators
        self.free = free
        # the monomial of the highest exponents that no relation lowers
        self.reduced = ring.highest
        for number, generator in enumerate(generators):
            excess = MAXIMUM_EXPONENT - (generator.power - 1)
            self.reduced -= excess << ring.place(self.position(number))

    def position(self, generator_number: int) -> int:
        """The place of a generator among all variables."""
        return len(self.parameters) + generator_number

    def variables(self) -> tuple[str, ...]:
        """The names of all variables in order."""
        return (
            *(p.symbol for p in self.parameters),
            *(g.symbol for g in self.generators),
            *self.free,
        )

    def relation(self, generator_number: int) -> Polynomial:
        """``y^n - radicand``, which vanishes at every point of the field."""
        generator = self.generators[generator_number]
        top = self.ring.monomial({self.position(generator_number): generator.power})
        return top - generator.radicand

    def reduce(self, polynomial: Polynomial) -> Polynomial:
        """The remainder by the relations: every generator y has an exponent below its n."""
        if not beyond(polynomial.degrees(), self.reduced, self.ring.guard):
            return polynomial
        for number in range(len(self.generators) - 1, -1, -1):
            polynomial = self._reduce_by(number, polynomial)
            if self._starts_pair(number):  # y is reduced; x brings it back, of a lower degree
                while polynomial.degree(self.position(number + 1)) > 1:
                    polynomial = self._reduce_by(number + 1, polynomial)
                    polynomial = self._reduce_by(number, polynomial)
        return polynomial

    def _starts_pair(self, number: int) -> bool:
        pair = self.generators[number].pair
        return pair is not None and pair.position == self.position(number)

    def _reduce_by(self, number: int, polynomial: Polynomial) -> Polynomial:
        generator, position = self.generators[number], self.position(number)
        if polynomial.degree(position) < generator.power:
            return polynomial
        # the powers of y^n, each with what it is multiplied by
        parts: dict[int, dict[int, int]] = {}
        place, power = self.ring.place(position), generator.power
        whole = power << place
        for monomial, coefficient in polynomial.terms.items():
            quotient = (monomial >> place & DIGIT) // power
            parts.setdefault(quotient, {})[monomial - quotient * whole] = coefficient
        top = max(parts)
        result = self.ring.normal(parts.pop(top), polynomial.denominator)
        for quotient in range(top - 1, -1, -1):
            result = result * generator.radicand
            if quotient in parts:
                result = result + self.ring.normal(parts[quotient], polynomial.denominator)
        return result

    def is_zero(self, polynomial: Polynomial) -> bool:
        """Whether the polynomial is shown to vanish everywhere."""
        return not self.reduce(polynomial)

    def shifted(self, polynomial: Polynomial) -> Polynomial:
        """The polynomial in the distances x = parameter - lower >= 0."""
        for position, parameter in enumerate(self.parameters):
            if parameter.lower and polynomial.occurs(position):
                distance = self.ring.variable(position) + self.ring.constant(parameter.lower)
                polynomial = polynomial.substitute(position, distance)
        return polynomial

    def shifted_at(self, polynomial: Polynomial, position: int) -> Polynomial:
        """The polynomial in the distance of one parameter from its lower end."""
        lower = self.parameters[position].lower
        if not lower or not polynomial.occurs(position):
            return polynomial
        return polynomial.substitute(
            position, self.ring.variable(position) + self.ring.constant(lower)
        )

    def depends_on(self, polynomial: Polynomial) -> frozenset[int]:
        """The places of the parameters that occur, also those inside generators."""
        found = {i for i in range(len(self.parameters)) if polynomial.occurs(i)}
        for number, generator in enumerate(self.generators):
            if polynomial.occurs(self.position(number)):
                found = found.union(*map(self.depends_on, generator.coefficients))
        return frozenset(found)

    def positive_inside(self, polynomial: Polynomial) -> bool:
        """Positive wherever no parameter lies at the end of its domain.

        Nonempty, no free symbol, and every coefficient positive in the distances from the ends.
        """
        if not polynomial or self.has_free(polynomial):
            return False
        return all(c > 0 for c in self.shifted(polynomial).terms.values())

    def positive(self, polynomial: Polynomial) -> bool:
        """Manifestly positive: positive inside, and one term does not vanish at a closed end."""
        if not self.positive_inside(polynomial):
            return False
        closed = [i for i, parameter in enumerate(self.parameters) if parameter.closed]
        return self._has_term_without(closed, polynomial)

    def positive_along(self, polynomial: Polynomial, position: int) -> bool:
        """Positive wherever the parameter at ``position`` is not at the end of its domain.

        The other parameters may be at theirs: one term holds none of those that are closed.
        """
        if not self.positive_inside(polynomial):
            return False
        others = [i for i, p in enumerate(self.parameters) if p.closed and i != position]
        return self._has_term_without(others, polynomial)

    def _has_term_without(self, positions: Iterable[int], polynomial: Polynomial) -> bool:
        """Whether these parameters are all absent from a term, in the distances."""
        digits = self.ring.digits(positions)
        return any(not m & digits for m in self.shifted(polynomial).terms)

    def nonnegative(self, polynomial: Polynomial) -> bool:
        """Manifestly nonnegative: zero, or positive inside."""
        return not polynomial or self.positive_inside(polynomial)

    def has_free(self, polynomial: Polynomial) -> bool:
        """Whether a free symbol occurs."""
        return any(polynomial.occurs(i) for i in self.free_positions())

    def free_positions(self) -> range:
        """The places of the free symbols among all variables."""
        first = len(self.parameters) + len(self.generators)
        return range(first, first + len(self.free))

    def with_generator(self, generator: Generator) -> Field:
        """The same field with one more generator, whose radicand must be manifestly positive."""
        if not self.positive(generator.radicand):
            raise RejectedError(f"the radicand of {generator.symbol!r} is not manifestly positive")
        return Field(self.ring, self.parameters, (*self.generators, generator), self.free)

    def with_pair(self, pair: Pair) -> Field:
        """The same with two coupled generators: a, c manifestly nonnegative, b, e positive."""
        names = " and ".join(map(repr, pair.symbols))
        if not all(self.nonnegative(entry) for entry in pair.free):
            raise RejectedError(f"a free term of {names} is not manifestly nonnegative")
        if not all(self.positive(entry) for entry in pair.slopes):
            raise RejectedError(f"a coupling of {names} is not manifestly positive")
        both = (
            Generator(symbol, 2, radicand, pair)
            for symbol, radicand in zip(pair.symbols, pair.radicands, strict=True)
        )
        return Field(self.ring, self.parameters, (*self.generators, *both), self.free)
