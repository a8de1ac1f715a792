"""Polynomials with rational coefficients in a fixed number of variables, exactly.

A polynomial is a table from monomials to nonzero integers over one common positive denominator:
integer products are much faster than products of fractions. A monomial is a number too, whose
digits are the exponents (`monomials`): lists of them take several times as long. Results are always
in lowest terms, so equal polynomials have equal tables.
"""

from __future__ import annotations

from collections.abc import Iterable, Mapping
from dataclasses import dataclass, field
from fractions import Fraction
from math import gcd

from gainproof.verify.certificate.monomials import (
    DIGIT,
    WIDTH,
    beyond,
    crowding,
    exponents_of,
    guards,
    highest,
    in_every_digit,
    monomial_of,
)
from gainproof.verify.certificate.rejection import (
    MAXIMUM_COEFFICIENT_BITS,
    MAXIMUM_EXPONENT,
    GivenUpError,
    Meter,
    RejectedError,
)
from gainproof.verify.certificate.term_products import product_of

TOO_LONG = f"given up: a number of more than {MAXIMUM_COEFFICIENT_BITS} bits"
# What any operation costs, however short, in products of two terms.
_OVERHEAD = 10


Exponents = tuple[int, ...]


@dataclass(frozen=True, slots=True, eq=False)
class Ring:
    """The polynomials in ``size`` variables, and the meter of the work done with them."""

    size: int
    meter: Meter
    guard: int = field(init=False)
    highest: int = field(init=False)
    """The monomial of the highest exponents that are allowed."""

    def __post_init__(self) -> None:
        object.__setattr__(self, "guard", guards(self.size))
        object.__setattr__(self, "highest", in_every_digit(MAXIMUM_EXPONENT, self.size))

    def place(self, position: int) -> int:
        """Below how many bits of a monomial the exponent of a variable stands."""
        return WIDTH * (self.size - 1 - position)

    def digits(self, positions: Iterable[int]) -> int:
        """All bits of the exponents of these variables."""
        return sum(DIGIT << self.place(position) for position in positions)

    def constant(self, value: Fraction | int) -> Polynomial:
        """A number as a polynomial."""
        return self.polynomial({(0,) * self.size: Fraction(value)})

    def variable(self, position: int) -> Polynomial:
        """The variable at ``position``."""
        return self.monomial({position: 1})

    def monomial(self, exponents: Mapping[int, int]) -> Polynomial:
        """The product of powers of the variables at the given positions."""
        return self.polynomial({tuple(exponents.get(i, 0) for i in range(self.size)): Fraction(1)})

    def polynomial(self, terms: Mapping[Exponents, Fraction]) -> Polynomial:
        """The polynomial with these coefficients by exponents; zero coefficients are dropped."""
        common = 1
        for coefficient in terms.values():
            denominator = coefficient.denominator
            common = common // gcd(common, denominator) * denominator
            if common.bit_length() > MAXIMUM_COEFFICIENT_BITS:
                raise GivenUpError(TOO_LONG)
        return self.normal(
            {monomial_of(m): c.numerator * (common // c.denominator) for m, c in terms.items()},
            common,
        )

    def normal(self, terms: dict[int, int], denominator: int) -> Polynomial:
        """Bring integer terms over a positive denominator to lowest terms, within the limits."""
        if not all(terms.values()):
            terms = {m: c for m, c in terms.items() if c}
        words = denominator.bit_length() // 64
        self.meter.spend(_OVERHEAD + len(terms) * (crowding(terms) + words * words // 128))
        if denominator != 1:
            common = gcd(denominator, *terms.values())
            if common != 1:
                denominator //= common
                terms = {m: c // common for m, c in terms.items()}
        if max(denominator, *terms.values(), -min(terms.values(), default=0)).bit_length() > (
            MAXIMUM_COEFFICIENT_BITS
        ):
            raise GivenUpError(TOO_LONG)
        return Polynomial(self, terms, denominator)


@dataclass(frozen=True, slots=True, eq=False)
class Polynomial:
    """``sum terms[m] x^m / denominator``, in lowest terms. Made by a Ring only."""

    ring: Ring
    terms: Mapping[int, int]
    denominator: int
    _degrees: list[int] = field(default_factory=list)
    """What `degrees` found, once it was asked for."""

    def __bool__(self) -> bool:
        return bool(self.terms)

    def __eq__(self, other: object) -> bool:
        if not isinstance(other, Polynomial):
            return NotImplemented
        return (
            self.ring is other.ring
            and self.denominator == other.denominator
            and self.terms == other.terms
        )

    def __hash__(self) -> int:
        self.ring.meter.spend(len(self.terms))
        return hash((self.denominator, frozenset(self.terms.items())))

    def __neg__(self) -> Polynomial:
        return Polynomial(self.ring, {m: -c for m, c in self.terms.items()}, self.denominator)

    def __add__(self, other: Polynomial) -> Polynomial:
        self._same_ring(other)
        self.ring.meter.spend(len(self.terms) + len(other.terms))
        common = gcd(self.denominator, other.denominator)
        mine, theirs = other.denominator // common, self.denominator // common
        total = dict(self._terms_times(mine))
        known = total.get
        for monomial, coefficient in other._terms_times(theirs).items():
            total[monomial] = known(monomial, 0) + coefficient
        return self.ring.normal(total, self.denominator * mine)

    def __sub__(self, other: Polynomial) -> Polynomial:
        return self + -other

    def __mul__(self, other: Polynomial) -> Polynomial:
        self._same_ring(other)
        self.ring.meter.spend(self._cost(other))
        degrees = self.degrees() + other.degrees()
        if beyond(degrees, self.ring.highest, self.ring.guard):
            raise RejectedError(f"an exponent grew beyond {MAXIMUM_EXPONENT}")
        terms = product_of(self.terms, other.terms)
        return self.ring.normal(terms, self.denominator * other.denominator)

    def __pow__(self, exponent: int) -> Polynomial:
        """A nonnegative integer power."""
        result = self.ring.constant(1)
        for _ in range(exponent):
            result = result * self
        return result

    def times(self, factor: Fraction) -> Polynomial:
        """This polynomial times a number."""
        scaled = {m: c * factor.numerator for m, c in self.terms.items()}
        return self.ring.normal(scaled, self.denominator * factor.denominator)

    def coefficients(self) -> Iterable[tuple[Exponents, Fraction]]:
        """The terms as pairs (exponents, coefficient)."""
        return (
            (exponents_of(m, self.ring.size), Fraction(c, self.denominator))
            for m, c in self.terms.items()
        )

    def constant_value(self) -> Fraction | None:
        """The number this polynomial is, or None if a variable occurs."""
        if any(self.terms):
            return None
        return Fraction(sum(self.terms.values()), self.denominator)

    def occurs(self, position: int) -> bool:
        """Whether the variable at ``position`` occurs."""
        return self.degree(position) > 0

    def degree(self, position: int) -> int:
        """The highest exponent of the variable at ``position``; 0 for the zero polynomial."""
        return self.degrees() >> self.ring.place(position) & DIGIT

    def by_power(self, position: int) -> dict[int, Polynomial]:
        """The coefficients of the powers of one variable, itself removed."""
        parts: dict[int, dict[int, int]] = {}
        place = self.ring.place(position)
        for monomial, coefficient in self.terms.items():
            exponent = monomial >> place & DIGIT
            parts.setdefault(exponent, {})[monomial - (exponent << place)] = coefficient
        return {e: self.ring.normal(part, self.denominator) for e, part in parts.items()}

    def substitute(self, position: int, value: Polynomial) -> Polynomial:
        """Put a polynomial for one variable (Horner)."""
        parts = self.by_power(position)
        result = self.ring.constant(0)
        for exponent in range(max(parts, default=0), -1, -1):
            result = result * value
            if exponent in parts:
                result = result + parts[exponent]
        return result

    def partial(self, position: int) -> Polynomial:
        """The partial derivative by one variable."""
        place = self.ring.place(position)
        lowered = {
            m - (1 << place): c * exponent
            for m, c in self.terms.items()
            if (exponent := m >> place & DIGIT)
        }
        return self.ring.normal(lowered, self.denominator)

    def primitive(self) -> tuple[Fraction, Polynomial]:
        """A positive number and a polynomial of coprime integers whose product this is."""
        content = gcd(*self.terms.values()) if self.terms else 1
        factor = Fraction(content, self.denominator)
        return factor, Polynomial(self.ring, {m: c // content for m, c in self.terms.items()}, 1)

    def _terms_times(self, factor: int) -> Mapping[int, int]:
        return self.terms if factor == 1 else {m: c * factor for m, c in self.terms.items()}

    def _same_ring(self, other: Polynomial) -> None:
        if self.ring is not other.ring:
            raise RejectedError("polynomials over different variables met")

    def _cost(self, other: Polynomial) -> int:
        bits = self._bits() + other._bits()
        products = len(self.terms) * len(other.terms)
        return products * (1 + self.ring.size // 8 + (bits // 256) ** 2 // 32)

    def degrees(self) -> int:
        """The monomial of the degrees in every variable; 0 for the zero polynomial."""
        if not self._degrees:
            self._degrees.append(highest(self.terms, self.ring.guard))
        return self._degrees[0]

    def _bits(self) -> int:
        values = self.terms.values()
        return max(0, *values, -min(values, default=0)).bit_length()
