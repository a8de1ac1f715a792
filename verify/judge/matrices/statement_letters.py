"""The letters of one statement as words need them: free letters, blocks of sizes, inverses."""

from __future__ import annotations

from collections.abc import Mapping
from dataclasses import dataclass, field

from gainproof.verify.judge.matrices.exact_instance import Unsupported
from gainproof.verify.judge.matrices.letters import (
    DEFINITE,
    SEMIDEFINITE,
    SYMMETRIC,
    MatrixSetting,
)
from gainproof.verify.judge.matrices.polynomial import Number, Polynomial, Word
from gainproof.verify.judge.matrices.scalar_factors import factors, settled
from gainproof.verify.judge.matrices.size import ONE as SINGLE
from gainproof.verify.judge.matrices.size import ZERO, Shape, Size

FIRST = 1 << 30
"""More letters than there are."""
SYMMETRIC_FACTS = frozenset((SYMMETRIC, DEFINITE, SEMIDEFINITE))


@dataclass
class Alphabet:
    """`names` and `shapes` by number; `blocks`: the letters that fill each size that is cut;
    `inverse`: number of the inverse of a letter; `elements`: what a letter is short for;
    `symmetric`: letters that are their own transpose, free ones, elements or inverses of these.
    """

    setting: MatrixSetting
    cuts: Mapping[Size, list[Size]]
    names: list[str] = field(default_factory=list)
    shapes: list[Shape] = field(default_factory=list)
    blocks: dict[Size, list[int]] = field(default_factory=dict)
    place: dict[int, tuple[Size, int]] = field(default_factory=dict)
    inverse: dict[int, int] = field(default_factory=dict)
    base: dict[int, int] = field(default_factory=dict)
    elements: dict[int, Polynomial] = field(default_factory=dict)
    symmetric: set[int] = field(default_factory=set)
    _numbers: dict[str, int] = field(default_factory=dict)
    _sizes: dict[Size, str] = field(default_factory=dict)
    _ones: set[int] = field(default_factory=set)
    _lasts: set[int] = field(default_factory=set)
    scalars: dict[int, str] = field(default_factory=dict)
    _spread: dict[str, str] = field(default_factory=dict)
    _met: dict[tuple[int, int], bool | None] = field(default_factory=dict)

    def __post_init__(self) -> None:
        self._spread = {n: x.scalar for n, x in self.setting.letters.items() if x.scalar}
        self._spread |= {name: name for name in set(self._spread.values())}
        for size in sorted(self.cuts, key=str):
            self.blocks[size] = []
            for at, width in enumerate(self.cuts[size]):
                number = self._new(f"block_{self.size_name(size)}_{at + 1}", (size, width))
                self.blocks[size].append(number)
                self.place[number] = (size, at)
            self._lasts.add(2 * self.blocks[size][-1])

    def _new(self, name: str, shape: Shape) -> int:
        while name in self.names:
            name += "x"
        self.names.append(name)
        self.shapes.append(shape)
        if SINGLE in shape:
            self._ones.add(len(self.names) - 1)
        return len(self.names) - 1

    def number(self, name: str) -> int:
        """The number of a letter of the setting."""
        if name not in self._numbers:
            shape = self.setting.letters[name].shape
            number = self._numbers[name] = self._new(_plain(name), shape)
            if name in self._spread:
                self.scalars[number] = self._spread[name]
                self.symmetric.add(number)
            if set(self.setting.letters[name].facts) & SYMMETRIC_FACTS:
                self.symmetric.add(number)
        return self._numbers[name]

    def has(self, name: str) -> bool:
        """Whether a letter of the setting was spoken of."""
        return name in self._numbers

    def of_shape(self, shape: Shape) -> tuple[int, bool]:
        """A letter of this shape, and whether its transpose is; a new one if there is none."""
        for number, known in enumerate(self.shapes):
            if shape in (known, known[::-1]):
                return number, shape != known
        return self._new("zero", shape), False

    def letter(self, number: int) -> Polynomial:
        """The letter as a polynomial."""
        return Polynomial({(2 * number,): 1}, self.shapes[number])

    def unit(self, size: Size) -> Polynomial:
        """The unit matrix."""
        return Polynomial({(): 1}, (size, size))

    def short_for(self, value: Polynomial) -> int:
        """The letter that is short for a polynomial, in normal form."""
        for number, known in self.elements.items():
            if known.shape == value.shape and known.key == value.key:
                return number
        number = self._new(f"element_{len(self.elements) + 1}", value.shape)
        self.elements[number] = value
        if value.shape[0] == value.shape[1] and self.reduced(value.T).key == value.key:
            self.symmetric.add(number)
        return number

    def inverse_of(self, number: int) -> int:
        """The letter of the inverse."""
        if number in self.base:
            return self.base[number]
        if number not in self.inverse:
            other = self._new(f"{self.names[number]}_inverse", self.shapes[number])
            self.inverse[number], self.base[other] = other, number
            if number in self.symmetric:
                self.symmetric.add(other)
        return self.inverse[number]

    def embedded(self, whole: Size, start: Size, size: Size) -> Polynomial:
        """The columns of the unit matrix of `whole` that begin at `start`, so many."""
        if size == whole:
            return self.unit(whole)
        total, place, covered = Polynomial({}, (whole, size)), ZERO, ZERO
        own = self.blocks.get(size, [])
        for number, width in zip(self.blocks[whole], self.cuts[whole], strict=True):
            if place - start == ZERO and width == size:
                return self.letter(number)
            before = ZERO
            for other in own:
                if place - start == before and self.shapes[other][1] == width:
                    total = total + self.letter(number) @ self.letter(other).T
                    covered = covered + width
                before = before + self.shapes[other][1]
            place = place + width
        if covered != size:
            raise Unsupported(f"blocks of {whole} and of {size} do not fit together")
        return total

    def normal(self, word: Word) -> Word | None:
        """The word after what is always done: symmetric letters lose their transpose, blocks and
        inverses that meet vanish. None for a word that is zero.
        """
        if self._spread:
            word = tuple(n - 1 if n & 1 and n >> 1 in self.symmetric else n for n in word)
            while (swapped := self.swap(word)) is not None:
                word = swapped[1]
        found: list[int] = []
        known, symmetric = self._met, self.symmetric
        before = -1
        for letter in word:
            if letter & 1 and letter >> 1 in symmetric:
                letter -= 1
            if before >= 0:
                pair = (before, letter)
                # a letter gets its inverse once, before the two can meet
                if pair in known:
                    met = known[pair]
                else:
                    met = known[pair] = self.meeting(before, letter)
                if met is False:
                    return None
                if met:
                    found.pop()
                    before = found[-1] if found else -1
                    continue
            found.append(letter)
            before = letter
        short = tuple(found)
        if self._spread and self.swap(short) is not None:
            return self.normal(short)
        return short if self._ones.isdisjoint(n >> 1 for n in short) else self._numbered(short)

    @property
    def ranks(self) -> Mapping[int, int]:
        """By what factors are ordered: an inverse beside its letter, numbers times unit matrices
        first.
        """
        first = {
            n: self.base.get(n, n) - FIRST for n in range(len(self.names)) if self._is_scalar(n)
        }
        return {**self.base, **first} if self._spread else self.base

    def _is_scalar(self, number: int) -> bool:
        """Whether a letter is a number times a unit matrix."""
        if number in self.base:
            return self._is_scalar(self.base[number])
        made = self.elements.get(number)
        if made is not None:
            return all(self._is_scalar(n >> 1) for word in made.terms for n in word)
        return number in self.scalars

    def _beside(self, number: int, size: Size) -> int | None:
        """What a number times a unit matrix is beside another size, if there is a letter for it."""
        if self.shapes[number][0] == size:
            return number
        if number in self.base:
            other = self._beside(self.base[number], size)
            return None if other is None else self.inverse_of(other)
        same = [n for n, scalar in self._spread.items() if scalar == self.scalars.get(number)]
        fitting = [n for n in same if self.setting.letters[n].shape[0] == size]
        return self.number(fitting[0]) if fitting else None

    def swap(self, word: Word) -> tuple[int, Word] | None:
        """Where a number times a unit matrix stands behind another letter, or behind a number of a
        higher rank, and the word with the two exchanged; None where there is no more such.
        """
        for at in range(1, len(word) if self._spread else 0):
            one, other = word[at - 1], word[at]
            if other & 1 or not self._is_scalar(other >> 1):
                continue
            if self.shapes[one >> 1][1 - (one & 1)] != self.shapes[other >> 1][0]:
                continue  # no product: the search looks at such words too
            ranks = self.ranks
            if self._is_scalar(one >> 1) and ranks[one >> 1] <= ranks[other >> 1]:
                continue
            found = self._beside(other >> 1, self.shapes[one >> 1][one & 1])
            if found is not None:
                return at, (*word[: at - 1], 2 * found, one, *word[at + 1 :])
        return None

    def _numbered(self, word: Word) -> Word | None:
        """With factors of one row and column in their order; what meets then vanishes."""
        cuts = factors(word, self.shapes)
        if len(cuts) < 2:
            return word
        pieces = settled(word, cuts, self.symmetric, self.ranks)
        other = (*word[: cuts[0]], *(n for piece in pieces for n in piece), *word[cuts[-1] :])
        return word if other == word else self.normal(other)

    def last_pair(self, word: Word) -> int | None:
        """Where in a word the last block of a size meets its transpose, if it does: E E' there is
        the unit matrix less those of the other blocks.
        """
        lasts = self._lasts
        for at, letter in enumerate(word[:-1]):
            if letter in lasts and word[at + 1] == letter + 1:
                return at
        return None

    def contracted(self, word: Word) -> dict[Word, int]:
        """The normal form in which no last block meets its transpose, of a word in normal form."""
        total: dict[Word, int] = {}
        waiting = [(word, 1)]
        while waiting:
            word, factor = waiting.pop()
            at = self.last_pair(word)
            if at is None:
                rest = total.pop(word, 0) + factor
                if rest:
                    total[word] = rest
                continue
            before, after = word[:at], word[at + 2 :]
            *others, _ = self.blocks[self.place[word[at] // 2][0]]
            pairs = [((), factor), *(((2 * n, 2 * n + 1), -factor) for n in others)]
            for pair, value in pairs:
                short = self.normal(before + pair + after)
                if short is not None:
                    waiting.append((short, value))
        return total

    def meeting(self, one: int, other: int) -> bool | None:
        """True if two neighbours make the unit matrix, False if zero, None if neither."""
        left, right = self.place.get(one // 2), self.place.get(other // 2)
        if left is not None and right is not None and one % 2 and not other % 2:
            return left == right if left[0] == right[0] else None
        if one % 2 == other % 2 and (
            self.inverse.get(one // 2) == other // 2 or self.base.get(one // 2) == other // 2
        ):
            return True if (one // 2 in self.inverse or one // 2 in self.base) else None
        return None

    def reduced(self, value: Polynomial) -> Polynomial:
        """All words in normal form."""
        terms: dict[Word, Number] = {}
        for word, factor in value.terms.items():
            short = self.normal(word)
            if short is not None:
                total = terms.pop(short, 0) + factor
                if total:
                    terms[short] = total
        return Polynomial(terms, value.shape)

    def size_name(self, size: Size) -> str:
        """A size as certificates name it."""
        if size not in self._sizes:
            if not size.terms and size.constant and size not in self.cuts:
                self._sizes[size] = str(size.constant)
            else:
                name = "size_" + _plain(self.setting.sizes.shown(size))
                while name in self._sizes.values():
                    name += "x"
                self._sizes[size] = name
        return self._sizes[size]

    def sizes_named(self) -> dict[str, list[str | int | dict[str, int]]]:
        """Sizes as certificates name them: as the source does, and the constant and factors of the
        steps that they are made of.
        """
        shown = self.setting.sizes.shown
        return {
            name: [shown(size), size.constant, dict(size.terms)]
            for size, name in self._sizes.items()
            if name.startswith("size_")
        }


def _plain(text: str) -> str:
    """Letters, digits and underscores."""
    words = text.replace("+", " plus ").replace("-", " minus ")
    kept = "".join(c if c.isascii() and c.isalnum() else "_" for c in words).strip("_")
    name = "_".join(part for part in kept.split("_") if part)[:50]
    return name if name[:1].isalpha() else f"m_{name}"
