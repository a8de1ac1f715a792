"""What matrix statements speak of: shapes, parameters, and what some of the letters stand for.

Beside the towers of a certificate stand settings, records of these fields and no others:

parameters
    [{"symbol", "above": "0"}, ...] are positive numbers, {"symbol", "any": "real"} any real ones.
matrices
    {name: [rows, columns], ...}: every letter. A size is a name, or an integer as text.
units
    {name: size}: unit matrices by name, which are no letters.
blocks
    {size: [names]}: the unit matrix of that size is these matrices side by side. The size is named
    by no other entry and is the sum of their numbers of columns, sizes without blocks; it exists
    for each choice of these.
elements
    {name: polynomial}: the letter stands for the polynomial.
inverses
    {name: letter}: the name is the inverse of that square letter if there is one, and any matrix
    if there is none.

No letter is two of block, element and inverse, and no element rests upon itself, also not through
inverses: so every choice of the other letters and parameters gives all of them a value, and no
contradiction can be written into a setting.
"""

from __future__ import annotations

from collections.abc import Mapping
from dataclasses import dataclass, field
from fractions import Fraction
from json import dumps

from gainproof.verify.certificate import schema
from gainproof.verify.certificate.matrix_words.polynomial import (
    MAXIMUM_WORD,
    MAXIMUM_WORD_TERMS,
    Polynomial,
    Powers,
    Shape,
    Word,
)
from gainproof.verify.certificate.plain_data import Plain
from gainproof.verify.certificate.rejection import (
    MAXIMUM_POWER,
    MalformedError,
    Meter,
    RejectedError,
)


@dataclass(frozen=True)
class Setting:
    """Letters with shapes and meanings; remembers which names were used, and what is known."""

    parameters: tuple[str, ...]
    positive: tuple[bool, ...]
    names: tuple[str, ...]
    shapes: tuple[Shape, ...]
    units: Mapping[str, str]
    blocks: Mapping[str, tuple[int, ...]]
    elements: Mapping[int, Polynomial]
    inverses: Mapping[int, int]
    meter: Meter
    used: set[str] = field(default_factory=set)
    decided: dict[str, tuple[object, object]] = field(default_factory=dict)
    numbers: dict[str, int] = field(default_factory=dict)

    @property
    def no_powers(self) -> Powers:
        """Of no parameter."""
        return (0,) * len(self.parameters)

    def number(self, value: Fraction) -> Polynomial:
        """A number that stands before matrices."""
        return Polynomial({(self.no_powers, ()): value} if value else {}, None)

    def unit(self, size: str) -> Polynomial:
        """The unit matrix of that size."""
        return Polynomial({(self.no_powers, ()): Fraction(1)}, (size, size))

    def zero(self, shape: Shape) -> Polynomial:
        """The zero matrix of that shape."""
        return Polynomial({}, shape)

    def letter(self, number: int) -> Polynomial:
        """One letter."""
        self.used.add(self.names[number])
        return Polynomial({(self.no_powers, (2 * number,)): Fraction(1)}, self.shapes[number])

    def numbered(self, value: Plain) -> int:
        """A number of its own for a hypothesis; the same one wherever the same is written."""
        return self.numbers.setdefault(dumps(value, sort_keys=True), len(self.numbers))

    def index(self, name: str, place: str) -> int:
        """The number of a letter. Raises RejectedError for an unknown name."""
        if name not in self.names:
            raise RejectedError(f"{place}: there is no matrix {name!r}")
        return self.names.index(name)

    def symbol(self, name: str, place: str) -> Polynomial:
        """A letter, a unit or a parameter."""
        self.used.add(name)
        if name in self.units:
            return self.unit(self.units[name])
        if name in self.parameters:
            at = self.parameters.index(name)
            powers = tuple(int(i == at) for i in range(len(self.parameters)))
            return Polynomial({(powers, ()): Fraction(1)}, None)
        return self.letter(self.index(name, place))

    def mark(self, value: Polynomial) -> None:
        """Remember the letters and parameters of a polynomial."""
        self.used.update(self.names[number] for number in value.letters())
        for powers, _ in value.terms:
            self.used.update(name for name, p in zip(self.parameters, powers, strict=True) if p)

    def unused(self) -> set[str]:
        """Names that neither a statement nor a used element speaks of."""
        known = {self.names[number]: poly for number, poly in self.elements.items()}
        waiting = [name for name in self.used if name in known]
        seen = set(waiting)
        while waiting:
            self.mark(known[waiting.pop()])
            fresh = (self.used & set(known)) - seen
            seen |= fresh
            waiting += fresh
        size_blocks = {self.names[n] for columns in self.blocks.values() for n in columns}
        spoken = self.used | (size_blocks if self.used & size_blocks else set())
        return {*self.parameters, *self.names, *self.units} - spoken

    def polynomial(self, value: Plain, shape: Shape | None, place: str) -> Polynomial:
        """A polynomial [[coefficient, [powers], [letters]], ...] of this shape, its terms ascending
        by letters, then powers; a letter is a name, with ' behind it for the transpose.
        """
        entries = schema.items(value, place)
        if len(entries) > MAXIMUM_WORD_TERMS:
            raise MalformedError(f"{place}: more than {MAXIMUM_WORD_TERMS} terms")
        terms: dict[tuple[Powers, Word], Fraction] = {}
        before: tuple[list[str], Powers] | None = None
        for number, entry in enumerate(entries):
            here = f"{place}[{number}]"
            term = schema.items(entry, here)
            if len(term) != 3:
                raise MalformedError(f"{here}: a coefficient, powers and letters are wanted")
            coefficient = schema.number(term[0], here)
            powers, word = self._powers(term[1], here), self._word(term[2], shape, here)
            key = ([str(letter) for letter in schema.items(term[2], here)], powers)
            if coefficient == 0 or (before is not None and not before < key):
                raise MalformedError(f"{here}: nonzero terms in ascending order are wanted")
            before = key
            terms[(powers, word)] = coefficient
        result = Polynomial(terms, shape)
        self.mark(result)
        return result

    def _powers(self, value: Plain, place: str) -> Powers:
        entries = schema.items(value, place)
        if len(entries) != len(self.parameters):
            raise MalformedError(f"{place}: {len(self.parameters)} powers are wanted")
        return tuple(
            schema.integer(entry, -MAXIMUM_POWER if positive else 0, MAXIMUM_POWER, place)
            for entry, positive in zip(entries, self.positive, strict=True)
        )

    def _word(self, value: Plain, shape: Shape | None, place: str) -> Word:
        entries = schema.items(value, place)
        if len(entries) > MAXIMUM_WORD:
            raise MalformedError(f"{place}: a word of more than {MAXIMUM_WORD} letters")
        word: list[int] = []
        columns = None if shape is None else shape[0]
        for entry in entries:
            text = entry if isinstance(entry, str) else ""
            name = schema.name(text.removesuffix("'"), place)
            letter = 2 * self.index(name, place) + text.endswith("'")
            rows, after = self.shapes[letter // 2][:: -1 if letter % 2 else 1]
            if rows != columns:
                raise RejectedError(f"{place}: {text} has {rows} rows, {columns} are wanted")
            columns = after
            word.append(letter)
        if shape is not None and columns != shape[1]:
            raise RejectedError(f"{place}: {columns} columns, {shape[1]} are wanted")
        return tuple(word)
