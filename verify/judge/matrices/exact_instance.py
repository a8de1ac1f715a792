"""Exact values: sizes as numbers, letters as matrices of rationals, formulas evaluated."""

from __future__ import annotations

from collections.abc import Mapping
from dataclasses import dataclass, field

from flint import fmpq, fmpq_mat

from gainproof.verify.judge.matrices.letters import Letter, MatrixSetting
from gainproof.verify.judge.matrices.size import Shape
from gainproof.verify.judge.matrices.tree import Node

MOST_ENTRIES = 900


class NoValueError(ValueError):
    """A formula that has no value at an instance; the text says what has no inverse."""


class Unsupported(ValueError):
    """What is not evaluated here, such as the mean of a cube."""


@dataclass
class Instance:
    """Values of the steps of sizes and of the free letters, random ones included. `steady` is the
    instance of which this one has other random letters: no inverse depends on them.
    """

    setting: MatrixSetting
    steps: Mapping[str, int]
    values: dict[str, fmpq_mat] = field(default_factory=dict)
    steady: Instance | None = None
    _known: dict[int, tuple[Node, fmpq_mat]] = field(default_factory=dict)
    _names: dict[str, fmpq_mat] = field(default_factory=dict)

    def dimensions(self, shape: Shape) -> tuple[int, int]:
        """Numbers of rows and columns."""
        rows, columns = (size.value(self.steps) for size in shape)
        if rows * columns > MOST_ENTRIES:
            raise Unsupported("matrices of so many entries are not tried")
        return rows, columns

    def zero(self, shape: Shape) -> fmpq_mat:
        """A zero matrix."""
        return fmpq_mat(*self.dimensions(shape))

    def of(self, node: Node) -> fmpq_mat:
        """The value of a formula with filled shapes. Raises NoValueError."""
        known = self._known.get(id(node))
        if known is None:
            known = self._known[id(node)] = (node, self._found(node))
        return known[1]

    def _found(self, node: Node) -> fmpq_mat:
        match node.kind:
            case "name":
                return self.letter(node.name)
            case "unit" | "zero":
                found = self.zero(node.shape) if node.shape else fmpq_mat(1, 1)
                for i in range(found.nrows() if node.kind == "unit" else 0):
                    found[i, i] = 1
                return found
            case "number":
                return fmpq_mat(1, 1, [fmpq(node.number.numerator, node.number.denominator)])
            case "negative":
                return -self.of(node.parts[0])
            case "transpose":
                return self.of(node.parts[0]).transpose()
            case "inverse":
                if self.steady is not None:
                    return self.steady.of(node)
                return _inverse(self.of(node.parts[0]))
            case "sum":
                return _sum([self.of(part) for part in node.parts])
            case "product":
                return _product([(part, self.of(part)) for part in node.parts])
            case "matrix":
                return _joined([self.of(part) for part in node.parts], node.size)
            case _:
                return self._mean(node.parts[0])

    def letter(self, name: str) -> fmpq_mat:
        """The value of a letter."""
        if name in self.values:
            return self.values[name]
        if name not in self._names:
            self._names[name] = self._value(self.setting.letters[name])
        return self._names[name]

    def _value(self, letter: Letter) -> fmpq_mat:
        if letter.definition is not None:
            return self.of(letter.definition)
        found = self.zero(letter.shape)
        for i in range(found.nrows() if letter.scalar else 0):
            found[i, i] = self.letter(letter.scalar)[0, 0]
        return found

    def with_values(self, values: Mapping[str, fmpq_mat]) -> Instance:
        """Other values of some letters; nothing is kept of what was worked out before."""
        return Instance(self.setting, self.steps, {**self.values, **values})

    def _with_random(self, values: Mapping[str, fmpq_mat]) -> Instance:
        """Other values of some random letters, on which no inverse depends."""
        return Instance(self.setting, self.steps, {**self.values, **values}, self)

    def _mean(self, node: Node) -> fmpq_mat:
        """E of a polynomial of degree 2 at most in random letters that are independent, with mean
        0. With V = sum d l l' it is f(0) + sum d (f(l) + f(-l) - 2 f(0)) / 2.
        """
        names = random_letters(node, self.setting)
        zeros = {name: self.zero(self.setting.letters[name].shape) for name in names}
        at_zero = self._with_random(zeros).of(node)
        total = at_zero
        for name in names:
            variance = self.setting.letters[name].variance
            assert variance is not None
            for weight, column in _squares(self.of(variance)):
                both = self._with_random({**zeros, name: column}).of(node)
                both += self._with_random({**zeros, name: -column}).of(node)
                total += (both - at_zero - at_zero) * (weight / 2)
        return total


def random_letters(node: Node, setting: MatrixSetting) -> list[str]:
    """The random letters that a formula depends on. Raises Unsupported unless it is a polynomial
    of degree 2 at most in them.
    """
    if degree(node, setting) > 2:
        raise Unsupported("the mean of something of degree 3 or more in random vectors")
    found: dict[str, None] = {}
    waiting, seen = [node], set[str]()
    while waiting:
        for part in waiting.pop().walk():
            if part.kind == "name" and part.name not in seen:
                seen.add(part.name)
                letter = setting.letters[part.name]
                if letter.variance is not None:
                    found[part.name] = None
                if letter.definition is not None:
                    waiting.append(letter.definition)
    return list(found)


def degree(node: Node, setting: MatrixSetting) -> int:
    """The degree in random letters; what is in an inverse or a mean must not depend on them."""
    if node.kind == "name":
        letter = setting.letters[node.name]
        if letter.definition is not None:
            return degree(letter.definition, setting)
        return int(letter.variance is not None)
    degrees = [degree(part, setting) for part in node.parts]
    if node.kind == "expectation":
        return 0
    if node.kind == "inverse" and degrees[0]:
        raise Unsupported("the mean of an inverse of something random")
    return sum(degrees) if node.kind == "product" else max(degrees, default=0)


def _inverse(value: fmpq_mat) -> fmpq_mat:
    try:
        return value.inv()
    except ZeroDivisionError:
        raise NoValueError("an inverse does not exist") from None


def _sum(values: list[fmpq_mat]) -> fmpq_mat:
    total = values[0]
    for value in values[1:]:
        total = total + value
    return total


def _product(values: list[tuple[Node, fmpq_mat]]) -> fmpq_mat:
    total, factor = None, fmpq(1)
    for node, value in values:
        if is_number(node):
            factor *= value[0, 0]
        else:
            total = value if total is None else total * value
    return fmpq_mat(1, 1, [factor]) if total is None else total * factor


def is_number(node: Node) -> bool:
    """Whether it is made of numbers alone, and stands before matrices of every shape."""
    if node.kind in ("sum", "product", "negative", "inverse", "transpose"):
        return all(is_number(part) for part in node.parts)
    return node.kind == "number"


def _joined(values: list[fmpq_mat], size: tuple[int, int]) -> fmpq_mat:
    rows: list[list[fmpq]] = []
    for at in range(size[0]):
        across = values[at * size[1] : (at + 1) * size[1]]
        rows += [
            [v[i, j] for v in across for j in range(v.ncols())] for i in range(across[0].nrows())
        ]
    width = sum(v.ncols() for v in values[: size[1]])
    return fmpq_mat(len(rows), width, [entry for row in rows for entry in row])


def _squares(matrix: fmpq_mat) -> list[tuple[fmpq, fmpq_mat]]:
    """V = sum of d l l' for a positive semidefinite V."""
    size = matrix.nrows()
    rest = fmpq_mat(matrix)
    found = []
    for i in range(size):
        weight = rest[i, i]
        if weight == 0:
            continue
        column = fmpq_mat(size, 1, [rest[j, i] / weight for j in range(size)])
        found.append((weight, column))
        rest = rest - column * column.transpose() * weight
    if rest != fmpq_mat(size, size):
        raise Unsupported("a variance that is not symmetric")
    return found
