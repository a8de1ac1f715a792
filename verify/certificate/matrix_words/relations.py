"""Equations that a proof may use, each with where it comes from.

A source is a list: ["given", n], the hypothesis of that number in the claim; ["element", name],
the letter is its polynomial; ["blocks", size, i, j], E_i' E_j is the unit matrix if i = j and else
zero; ["blocks", size], the sum of E_i E_i' is the unit matrix; ["statement", id], an earlier
equation of the same setting; ["inverse", id, "right" | "left"], A B = I or B A = I of an earlier
statement that A is invertible, B being its inverse in the setting; ["number", polynomial], a
matrix of one row and one column is its own transpose.

Hypotheses, with what they say of a letter:

{"kind": "symmetric", "matrix"}; {"kind": "definite" | "semidefinite", "matrix"}, symmetric and
x' A x > 0 for x not zero, or >= 0 for all x; {"kind": "invertible", "matrix"};
{"kind": "full_column_rank", "matrix"}, A x = 0 only for x = 0; {"kind": "equal", "left", "right"},
graphs of one shape.

An earlier statement may be used if all its hypotheses are among those of the claim.
"""

from __future__ import annotations

from collections.abc import Callable, Mapping
from dataclasses import dataclass, field

from gainproof.verify.certificate import schema
from gainproof.verify.certificate.matrix_words.expression import expand_pair
from gainproof.verify.certificate.matrix_words.polynomial import Polynomial
from gainproof.verify.certificate.matrix_words.setting import Setting
from gainproof.verify.certificate.plain_data import Plain
from gainproof.verify.certificate.rejection import MalformedError, RejectedError

MAXIMUM_HYPOTHESES = 30
SYMMETRIC = ("symmetric", "definite", "semidefinite")
PROPERTIES = (*SYMMETRIC, "invertible", "full_column_rank")


@dataclass(frozen=True, slots=True)
class Hypothesis:
    """What is taken for granted of a letter, or an equation left - right = `equation` = 0."""

    kind: str
    letter: int
    equation: Polynomial | None


@dataclass(frozen=True, slots=True)
class Conclusion:
    """What a statement says: an equation `difference` = 0, an order `difference` >= 0 or > 0
    (`strict`), or that the matrix `letter` is invertible; under the hypotheses `given`.
    """

    kind: str
    given: tuple[int, ...]
    difference: Polynomial
    strict: bool = False
    letter: int = -1


Premise = Callable[[str], Conclusion]
"""The conclusion of an earlier statement, proved. Raises RejectedError if it is not."""


@dataclass(frozen=True, slots=True)
class Ground:
    """What one statement stands on: its hypotheses, of which `used` were named by the proof;
    `given`: their numbers in the setting, which are compared at once, however long they are.
    """

    setting: Setting
    given: tuple[int, ...]
    hypotheses: tuple[Hypothesis, ...]
    premise: Premise
    used: set[int] = field(default_factory=set)

    def hypothesis(self, number: Plain, kinds: tuple[str, ...], place: str) -> Hypothesis:
        """The hypothesis of that number, which must be of one of these kinds."""
        at = schema.integer(number, 0, len(self.hypotheses) - 1, place)
        found = self.hypotheses[at]
        if found.kind not in kinds:
            raise RejectedError(f"{place}: hypothesis {at} is {found.kind}, wanted {kinds}")
        self.used.add(at)
        return found

    def earlier(self, identifier: Plain, kind: str, place: str) -> Conclusion:
        """The conclusion of an earlier statement of that kind, if its hypotheses are given here."""
        found = self.premise(schema.text(identifier, place))
        if found.kind != kind:
            raise RejectedError(f"{place}: {identifier!r} is no statement of kind {kind}")
        if not set(found.given) <= set(self.given):
            raise RejectedError(f"{place}: {identifier!r} has a hypothesis that is not given")
        self.used.update(map(self.given.index, found.given))
        return found

    def equation(self, source: Plain, place: str) -> Polynomial:
        """left - right of the source's equation, zero wherever the hypotheses hold."""
        meter = self.setting.meter
        entries = schema.items(source, place)
        kind = entries[0] if entries else ""
        if kind == "given" and len(entries) == 2:
            return self._given(entries[1], place)
        if kind == "element" and len(entries) == 2:
            number = self.setting.index(schema.name(entries[1], place), place)
            if number not in self.setting.elements:
                raise RejectedError(f"{place}: {entries[1]} stands for nothing but itself")
            meaning = self.setting.elements[number]
            return self.setting.letter(number).minus(meaning, meter, place)
        if kind == "blocks" and len(entries) in (2, 4):
            return self._blocks(entries[1], entries[2:], place)
        if kind == "statement" and len(entries) == 2:
            return self.earlier(entries[1], "matrix_equal", place).difference
        if kind == "number" and len(entries) == 2:
            value = self.setting.polynomial(entries[1], ("1", "1"), place)
            return value.minus(value.transposed(meter), meter, place)
        if kind == "inverse" and len(entries) == 3 and entries[2] in ("left", "right"):
            found = self.earlier(entries[1], "matrix_invertible", place)
            return self._inverse(found.letter, str(entries[2]), place)
        raise MalformedError(f"{place}: {str(kind)[:20]!r} is no source of an equation")

    def _given(self, number: Plain, place: str) -> Polynomial:
        found = self.hypothesis(number, (*SYMMETRIC, "equal"), place)
        if found.equation is not None:
            return found.equation
        letter, meter = self.setting.letter(found.letter), self.setting.meter
        return letter.transposed(meter).minus(letter, meter, place)

    def _blocks(self, size: Plain, pair: list[Plain], place: str) -> Polynomial:
        setting, meter = self.setting, self.setting.meter
        name = schema.text(size, place)
        if name not in setting.blocks:
            raise RejectedError(f"{place}: the size {name!r} has no blocks")
        columns = [setting.letter(number) for number in setting.blocks[name]]
        if not pair:
            total = setting.unit(name).negative(meter)
            for column in columns:
                square = column.times(column.transposed(meter), meter, place)
                total = total.plus(square, meter, place)
            return total
        i, j = (schema.integer(entry, 0, len(columns) - 1, place) for entry in pair)
        product = columns[i].transposed(meter).times(columns[j], meter, place)
        if i != j:
            return product
        width = setting.shapes[setting.blocks[name][i]][1]
        return product.minus(setting.unit(width), meter, place)

    def _inverse(self, letter: int, side: str, place: str) -> Polynomial:
        setting = self.setting
        found = [number for number, base in setting.inverses.items() if base == letter]
        if not found:
            raise RejectedError(f"{place}: the setting names no inverse of it")
        one, other = setting.letter(letter), setting.letter(found[0])
        pair = (one, other) if side == "right" else (other, one)
        product = pair[0].times(pair[1], setting.meter, place)
        unit = setting.unit(setting.shapes[letter][0])
        return product.minus(unit, setting.meter, place)


def read_hypotheses(value: Plain, setting: Setting, place: str) -> tuple[Hypothesis, ...]:
    """The hypotheses of a claim, no one twice."""
    entries = schema.items(value, place)
    if len(entries) > MAXIMUM_HYPOTHESES:
        raise MalformedError(f"{place}: more than {MAXIMUM_HYPOTHESES} hypotheses")
    if len(set(map(setting.numbered, entries))) < len(entries):
        raise MalformedError(f"{place}: a hypothesis is given twice")
    return tuple(
        _hypothesis(schema.table(entry, place), setting, f"{place}[{number}]")
        for number, entry in enumerate(entries)
    )


def _hypothesis(entry: Mapping[str, Plain], setting: Setting, place: str) -> Hypothesis:
    if entry.get("kind") == "equal":
        fields = schema.record(dict(entry), ("kind", "left", "right"), place)
        left, right = expand_pair(fields["left"], fields["right"], setting, place)
        gap = left.minus(right, setting.meter, place)
        if not gap.terms:
            raise RejectedError(f"{place}: the hypothesis is 0 = 0")
        return Hypothesis("equal", -1, gap)
    fields = schema.record(dict(entry), ("kind", "matrix"), place)
    kind = schema.text(fields["kind"], place)
    if kind not in PROPERTIES:
        raise MalformedError(f"{place}: {kind[:20]!r} is no hypothesis")
    name = schema.name(fields["matrix"], place)
    letter = setting.index(name, place)
    setting.used.add(name)
    rows, columns = setting.shapes[letter]
    if rows != columns and kind != "full_column_rank":
        raise RejectedError(f"{place}: {name} is not square")
    return Hypothesis(kind, letter, None)
