"""Formulas multiplied out into words."""

from __future__ import annotations

from dataclasses import dataclass, field

from gainproof.verify.judge.matrices.exact_instance import NoValueError, Unsupported, is_number
from gainproof.verify.judge.matrices.polynomial import Number, Polynomial, Word, reciprocal
from gainproof.verify.judge.matrices.scalar_factors import side_by_side
from gainproof.verify.judge.matrices.shapes import Shapes
from gainproof.verify.judge.matrices.size import ONE as SINGLE
from gainproof.verify.judge.matrices.size import ZERO
from gainproof.verify.judge.matrices.statement_letters import Alphabet
from gainproof.verify.judge.matrices.tree import Node


@dataclass
class Expander:
    """Formulas with filled shapes, as polynomials over the letters of an alphabet."""

    alphabet: Alphabet
    _names: dict[str, Polynomial] = field(default_factory=dict)

    def of(self, node: Node) -> Polynomial:
        """The formula in normal form. Raises TooLongError, Unsupported and, where a number is
        divided by zero, NoValueError.
        """
        return self.alphabet.reduced(self._found(node))

    def _found(self, node: Node) -> Polynomial:
        alphabet = self.alphabet
        match node.kind:
            case "name":
                return self._name(node.name)
            case "number":
                return alphabet.unit(SINGLE).times(node.number)
            case "unit" if node.shape is not None:
                return alphabet.unit(node.shape[0])
            case "zero" if node.shape is not None:
                return Polynomial({}, node.shape)
            case "negative":
                return -self.of(node.parts[0])
            case "transpose":
                return self.of(node.parts[0]).T
            case "sum":
                total = self.of(node.parts[0])
                for part in node.parts[1:]:
                    total = total + self.of(part)
                return total
            case "product":
                return self._product(node)
            case "inverse":
                return self._inverse(node)
            case "expectation":
                return self._mean(self.of(node.parts[0]))
            case "matrix":
                return self._blocks(node)
            case _:
                raise Unsupported(f"a {node.kind} without a shape")

    def _name(self, name: str) -> Polynomial:
        if name not in self._names:
            letter = self.alphabet.setting.letters[name]
            if letter.definition is None:
                self._names[name] = self.alphabet.letter(self.alphabet.number(name))
            else:
                self._names[name] = self.of(letter.definition)
        return self._names[name]

    def _product(self, node: Node) -> Polynomial:
        factor: Number = 1
        total = None
        for part in node.parts:
            if is_number(part):
                factor *= value_of(part)
            else:
                own = self.of(part)
                total = own if total is None else self.alphabet.reduced(total @ own)
        if total is None:
            total = self.alphabet.unit(SINGLE)
        return total.times(factor)

    def _inverse(self, node: Node) -> Polynomial:
        inner = self.of(node.parts[0])
        if len(inner.terms) == 1:
            ((word, factor),) = inner.terms.items()
            if not word:
                return inner.times(reciprocal(factor**2))
            if len(word) == 1:
                other = self.alphabet.inverse_of(word[0] // 2)
                found = self.alphabet.letter(other).times(reciprocal(factor))
                return found.T if word[0] % 2 else found
        if not inner.terms:
            raise NoValueError("the inverse of zero")
        number = self.alphabet.short_for(inner)
        return self.alphabet.letter(self.alphabet.inverse_of(number))

    def _blocks(self, node: Node) -> Polynomial:
        shapes = Shapes(self.alphabet.setting.letters, self.alphabet.setting.sizes)
        heights, widths = shapes.blocks(node)
        whole = (sum(heights, ZERO), sum(widths, ZERO))
        total, down = Polynomial({}, whole), ZERO
        for i, height in enumerate(heights):
            across = ZERO
            for j, width in enumerate(widths):
                cell = self.of(node.parts[i * len(widths) + j])
                if cell.terms:
                    left = self.alphabet.embedded(whole[0], down, height)
                    right = self.alphabet.embedded(whole[1], across, width)
                    total = total + left @ cell @ right.T
                across = across + width
            down = down + height
        return total

    def _mean(self, value: Polynomial) -> Polynomial:
        """E: words without random letters stay, those with one vanish, of those with two v v' of
        one letter becomes its variance, v w' of two independent ones vanishes.
        """
        alphabet = self.alphabet
        variances = {
            alphabet.number(name): letter.variance
            for name, letter in alphabet.setting.letters.items()
            if letter.variance is not None
        }
        total = Polynomial({}, value.shape)
        for word, factor in value.terms.items():
            at = [place for place, letter in enumerate(word) if letter // 2 in variances]
            term = Polynomial({word: factor}, value.shape)
            if len(at) > 2:
                raise Unsupported("the mean of something of degree 3 or more")
            if len(at) == 1:
                continue
            if len(at) == 2:
                found = self._variance_of(word, at, factor, value)
                if found is None:
                    continue
                term = found
            total = total + term
        for number in alphabet.base:
            self._require_not_random(number, set(variances))
        return total

    def _variance_of(
        self, word: Word, at: list[int], factor: Number, value: Polynomial
    ) -> Polynomial | None:
        alphabet = self.alphabet
        first, second = word[at[0]], word[at[1]]
        together = side_by_side(word, at[0], at[1], alphabet.shapes)
        if (at[1] != at[0] + 1 or first % 2 or not second % 2) and together is not None:
            word = together
            random = {first // 2, second // 2}
            at = [place for place, letter in enumerate(word) if letter // 2 in random]
            first, second = word[at[0]], word[at[1]]
        if at[1] != at[0] + 1 or first % 2 or not second % 2:
            raise Unsupported("a mean of words in which the random vectors are not next to another")
        if first // 2 != second // 2:
            return None
        name = next(n for n in alphabet.setting.letters if alphabet.number(n) == first // 2)
        variance = alphabet.setting.letters[name].variance
        assert variance is not None
        size = alphabet.shapes[first // 2][0]
        before = Polynomial({word[: at[0]]: factor}, (value.shape[0], size))
        after = Polynomial({word[at[1] + 1 :]: 1}, (size, value.shape[1]))
        return before @ self.of(variance) @ after

    def _require_not_random(self, number: int, random: set[int]) -> None:
        """Inverses of something random have no mean here."""
        waiting, seen = [number], set[int]()
        while waiting:
            letter = waiting.pop()
            if letter in seen:
                continue
            seen.add(letter)
            if letter in random:
                raise Unsupported("the mean of an inverse of something random")
            if letter in self.alphabet.base:
                waiting.append(self.alphabet.base[letter])
            if letter in self.alphabet.elements:
                words = self.alphabet.elements[letter].terms
                waiting += [each // 2 for word in words for each in word]


def value_of(node: Node) -> Number:
    """Of a formula of numbers alone."""
    parts = [value_of(part) for part in node.parts]
    match node.kind:
        case "number":
            number = node.number
            return number.numerator if number.denominator == 1 else number
        case "negative":
            return -parts[0]
        case "sum":
            return sum(parts)
        case "inverse":
            if parts[0] == 0:
                raise NoValueError("division by zero")
            return reciprocal(parts[0])
        case "transpose":
            return parts[0]
        case _:
            total: Number = 1
            for part in parts:
                total *= part
            return total
