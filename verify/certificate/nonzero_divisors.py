"""Divisors are shown not to vanish before anything is divided by them."""

from __future__ import annotations

from collections.abc import Mapping

from gainproof.verify.certificate import schema
from gainproof.verify.certificate.field import Field
from gainproof.verify.certificate.plain_data import Plain
from gainproof.verify.certificate.polynomial import Polynomial
from gainproof.verify.certificate.ratio import Ratio
from gainproof.verify.certificate.rejection import RejectedError
from gainproof.verify.certificate.written_polynomials import read_fraction

_MAXIMUM_LISTED = 100


class Nonzero:
    """The manifestly positive fractions that a statement lists to show its divisors nonzero.

    Each listed fraction must be needed: :meth:`finish` rejects those that no division used.
    """

    def __init__(self, field: Field, listed: tuple[Ratio, ...]) -> None:
        self._field = field
        self._listed = listed
        self._used: set[int] = set()

    def quotient(self, dividend: Ratio, divisor: Ratio) -> Ratio:
        """``dividend / divisor``; raises RejectedError unless the divisor is shown nonzero.

        It is, when its reduced numerator or the negative of that is manifestly positive; or when
        it, or its negative, equals a listed fraction (which then takes its place). When free
        symbols occur in it, one of their coefficients must be shown nonzero in this way, so that
        it is a nonzero polynomial in them at every point of the field.
        """
        field = self._field
        if field.has_free(divisor.numerator):
            parts = by_free_symbols(field, divisor.numerator)
            if any(self._manifest(part) for part in parts.values()):
                return dividend.over(divisor)
            for part in parts.values():
                if self._match(Ratio(field, part, {})) is not None:
                    return dividend.over(divisor)
        elif self._manifest(divisor.numerator):
            return dividend.over(divisor)
        else:
            equal = self._match(divisor)
            if equal is not None:
                return dividend.over(equal)
        raise RejectedError(
            "a divisor is not shown to be nonzero: it is not manifestly positive "
            "or negative, and no fraction listed under 'nonzero' equals it"
        )

    def finish(self, place: str) -> None:
        """Reject listed fractions that no division needed."""
        for number in range(len(self._listed)):
            if number not in self._used:
                raise RejectedError(f"{place}: entry {number} is not needed by any division")

    def _manifest(self, numerator: Polynomial) -> bool:
        return self._field.positive(numerator) or self._field.positive(-numerator)

    def _match(self, divisor: Ratio) -> Ratio | None:
        for number, listed in enumerate(self._listed):
            for candidate in (listed, -listed):
                if divisor.equals(candidate):
                    self._used.add(number)
                    return candidate
        return None


def read_nonzero(value: Plain, field: Field, place: str) -> Nonzero:
    """The list of manifestly positive fractions in a statement's evidence."""
    entries = schema.items(value, place)
    if len(entries) > _MAXIMUM_LISTED:
        raise RejectedError(f"{place}: more than {_MAXIMUM_LISTED} fractions")
    return Nonzero(
        field,
        tuple(
            read_fraction(entry, field.ring, f"{place}[{number}]").positive(field)
            for number, entry in enumerate(entries)
        ),
    )


def by_free_symbols(field: Field, polynomial: Polynomial) -> Mapping[int, Polynomial]:
    """The coefficients of the monomials in the free symbols."""
    frees = field.ring.digits(field.free_positions())
    parts: dict[int, dict[int, int]] = {}
    for monomial, coefficient in polynomial.terms.items():
        free = monomial & frees
        parts.setdefault(free, {})[monomial - free] = coefficient
    return {
        free: field.ring.normal(part, polynomial.denominator)
        for free, part in sorted(parts.items())
    }
