"""The letters of matrix statements as derivations give them: shapes, blocks, elements, inverses."""

from __future__ import annotations

from collections.abc import Collection, Mapping
from dataclasses import dataclass, field
from fractions import Fraction
from functools import cached_property
from typing import Any

from gainproof.derive.words.expression import Expression
from gainproof.derive.words.polynomial import Polynomial, Shape, ShapeError


@dataclass(frozen=True)
class Setting:
    """What is spoken of; the format and the meaning of each field are those of
    `gainproof.verify.certificate.matrix_words.setting`.

    `parameters`: positive numbers by name; `free`: real ones. `matrices`: letters with "rows
    columns". `elements`: what letters stand for. `inverses`: letters that have a named inverse,
    which is called `<letter>_inverse`.
    """

    name: str
    matrices: Mapping[str, str]
    parameters: tuple[str, ...] = ()
    free: tuple[str, ...] = ()
    units: Mapping[str, str] = field(default_factory=dict)
    blocks: Mapping[str, tuple[str, ...]] = field(default_factory=dict)
    elements: Mapping[str, Expression] = field(default_factory=dict)
    inverses: tuple[str, ...] = ()

    @cached_property
    def meanings(self) -> Mapping[str, Polynomial]:
        """The elements multiplied out, which every proof starts with."""
        return {name: self.expand(meaning) for name, meaning in self.elements.items()}

    @property
    def variables(self) -> tuple[str, ...]:
        """All parameters in order."""
        return (*self.parameters, *self.free)

    def shape(self, name: str) -> Shape:
        """Rows and columns of a letter. Raises KeyError for an unknown one."""
        base = name.removesuffix("_inverse")
        known = self.matrices[name if name in self.matrices or base not in self.inverses else base]
        rows, columns = known.split()
        return rows, columns

    def letter(self, name: str, transposed: bool = False) -> Polynomial:
        """One letter."""
        rows, columns = self.shape(name)
        shape = (columns, rows) if transposed else (rows, columns)
        return Polynomial({(((name, transposed),), self._powers()): Fraction(1)}, shape)

    def unit(self, size: str) -> Polynomial:
        """The unit matrix of that size."""
        return Polynomial({((), self._powers()): Fraction(1)}, (size, size))

    def number(self, value: Fraction) -> Polynomial:
        """A number that stands before matrices."""
        return Polynomial({((), self._powers()): value} if value else {}, None)

    def expand(self, value: Expression) -> Polynomial:
        """A formula multiplied out. Raises ShapeError where shapes do not fit."""
        parts = [self.expand(part) for part in value.arguments]
        match value.kind:
            case "number":
                return self.number(Fraction(value.value))
            case "symbol":
                return self._symbol(value.value)
            case "unit":
                return self.unit(value.value)
            case "add":
                return sum(parts[1:], start=parts[0])
            case "neg":
                return -parts[0]
            case "pow":
                product = parts[0]
                for _ in range(int(value.value) - 1):
                    product = product @ parts[0]
                return product
            case "transpose":
                return parts[0].T
            case "inverse":
                return self.letter(f"{value.arguments[0].value}_inverse")
            case "div":
                return parts[0] @ self._reciprocal(parts[1])
            case _:
                product = parts[0]
                for part in parts[1:]:
                    product = product @ part
                return product

    def pair(self, left: Expression, right: Expression) -> tuple[Polynomial, Polynomial]:
        """Two sides of one shape; the number 0 is the zero matrix."""
        one, other = self.expand(left), self.expand(right)
        if one.shape is None and not one.terms:
            one = Polynomial({}, other.shape)
        if other.shape is None and not other.terms:
            other = Polynomial({}, one.shape)
        if one.shape is None or one.shape != other.shape:
            raise ShapeError(f"{one.shape} and {other.shape} are compared")
        return one, other

    def data(self, spoken: Collection[str] | None = None) -> dict[str, Any]:
        """As certificates have it; of the unit matrices only those `spoken` of, if given."""
        named = {**self.matrices, **{f"{n}_inverse": self.matrices[n] for n in self.inverses}}
        return {
            "parameters": [
                *({"symbol": name, "above": "0"} for name in self.parameters),
                *({"symbol": name, "any": "real"} for name in self.free),
            ],
            "matrices": {name: shape.split() for name, shape in named.items()},
            "units": {
                name: size for name, size in self.units.items() if spoken is None or name in spoken
            },
            "blocks": {size: list(names) for size, names in self.blocks.items()},
            "elements": {name: meaning.data() for name, meaning in self.meanings.items()},
            "inverses": {f"{name}_inverse": name for name in self.inverses},
        }

    def _powers(self) -> tuple[int, ...]:
        return (0,) * len(self.variables)

    def _symbol(self, name: str) -> Polynomial:
        if name in self.units:
            return self.unit(self.units[name])
        if name in self.variables:
            powers = tuple(int(other == name) for other in self.variables)
            return Polynomial({((), powers): Fraction(1)}, None)
        return self.letter(name)

    def _reciprocal(self, value: Polynomial) -> Polynomial:
        ((_, powers), coefficient) = next(iter(value.terms.items()))
        if value.shape is not None or len(value.terms) != 1:
            raise ShapeError("a divisor is one term of a number and parameters")
        return Polynomial({((), tuple(-p for p in powers)): 1 / coefficient}, None)
