"""One statement while it is checked: its claim, its evidence, the tower it lives in."""

from __future__ import annotations

from collections.abc import Mapping
from dataclasses import dataclass

from gainproof.verify.certificate import schema, written_polynomials
from gainproof.verify.certificate.expression import Evaluation
from gainproof.verify.certificate.graph import Graph, read_expression
from gainproof.verify.certificate.nonzero_divisors import Nonzero, read_nonzero
from gainproof.verify.certificate.plain_data import Plain
from gainproof.verify.certificate.polynomial import Polynomial
from gainproof.verify.certificate.ratio import Ratio
from gainproof.verify.certificate.rejection import MAXIMUM_ORDER, RejectedError
from gainproof.verify.certificate.tower import Tower


@dataclass(frozen=True, slots=True)
class Program:
    """A kernel's graph, and what each of its inputs stands for in a tower."""

    inputs: Mapping[str, str | Graph]
    graph: Graph


@dataclass(frozen=True, slots=True)
class Case:
    """What a kind of statement is given to decide."""

    place: str
    claim: Plain
    evidence: Plain
    tower: Tower
    programs: Mapping[str, Program]

    def claims(self, *fields: str) -> dict[str, Plain]:
        """The claim, which must have exactly these fields."""
        return schema.record(self.claim, fields, f"{self.place}.claim")

    def evidences(self, *fields: str) -> dict[str, Plain]:
        """The evidence, which must have exactly these fields."""
        return schema.record(self.evidence, fields, f"{self.place}.evidence")

    def with_tower(self, tower: Tower) -> Case:
        """The same statement over an extended tower."""
        return Case(self.place, self.claim, self.evidence, tower, self.programs)

    def expression(self, value: Plain, field: str) -> Graph:
        """A graph of the claim with the single output "value"."""
        return read_expression(value, f"{self.place}.claim.{field}")

    def fraction(self, value: Plain, field: str) -> written_polynomials.WrittenFraction:
        """A fraction of the evidence."""
        fraction = written_polynomials.read_fraction(
            value, self.tower.field.ring, f"{self.place}.evidence.{field}"
        )
        self.tower.mark(fraction.numerator)
        self.tower.mark(fraction.denominator)
        return fraction

    def polynomial(self, value: Plain, field: str) -> Polynomial:
        """A polynomial of the evidence."""
        polynomial = written_polynomials.polynomial(
            value, self.tower.field.ring, f"{self.place}.evidence.{field}"
        )
        self.tower.mark(polynomial)
        return polynomial

    def nonzero(self, value: Plain) -> Nonzero:
        """The fractions listed to show divisors nonzero."""
        return read_nonzero(value, self.tower.field, f"{self.place}.evidence.nonzero")

    def no_fractions(self) -> Nonzero:
        """For kinds whose evidence lists none."""
        return Nonzero(self.tower.field, ())

    def evaluation(self, nonzero: Nonzero) -> Evaluation:
        """An evaluation of the claim's graphs."""
        return Evaluation(self.tower, nonzero)

    def finish(self, nonzero: Nonzero) -> None:
        """Every listed fraction must have been needed."""
        nonzero.finish(f"{self.place}.evidence.nonzero")

    def names(self, value: Plain, field: str) -> list[Ratio]:
        """A nonempty list of names of the tower, as their values."""
        place = f"{self.place}.claim.{field}"
        entries = schema.items(value, place)
        if not 1 <= len(entries) <= MAXIMUM_ORDER:
            raise RejectedError(f"{place}: between 1 and {MAXIMUM_ORDER} names are wanted")
        return [self.tower.value(schema.name(entry, place)) for entry in entries]

    def rows(self, value: Plain, field: str) -> tuple[tuple[Ratio, ...], ...]:
        """A rectangular array of names of the tower, as their values."""
        place = f"{self.place}.claim.{field}"
        rows = tuple(tuple(self.names(row, field)) for row in schema.items(value, place))
        if not 1 <= len(rows) <= MAXIMUM_ORDER or any(len(row) != len(rows[0]) for row in rows):
            raise RejectedError(f"{place}: rows of names of one length are wanted")
        return rows

    def square(self, value: Plain, field: str) -> list[list[Ratio]]:
        """A square array of names, symmetric in value, as their values."""
        place = f"{self.place}.claim.{field}"
        rows = [self.names(row, field) for row in schema.items(value, place)]
        if not rows or any(len(row) != len(rows) for row in rows):
            raise RejectedError(f"{place}: a square array of names is wanted")
        for i, row in enumerate(rows):
            for j in range(i):
                if not row[j].equals(rows[j][i]):
                    raise RejectedError(f"{place}: not symmetric at {i + 1},{j + 1}")
        return rows
