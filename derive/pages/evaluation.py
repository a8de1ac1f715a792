"""What formulas of a page stand for: its names and definitions, and their values in SymPy.

Factors of a statement that are matrices stay as they are written, for the checker to multiply out;
what a definition gives a name to is multiplied out.
"""

from __future__ import annotations

from collections.abc import Mapping
from dataclasses import dataclass, field, replace
from typing import Any

import sympy as sp

from gainproof.derive.pages.formula import RESERVED, Formula, FormulaError, nearest, read_formula

MAXIMUM_SIZE = 20_000
"""Nodes of a value, definitions written out."""
FEW = 12
"""Slots that an error lists all of."""
BUILT_IN = ("sqrt", "determinant", "derivative", "at", "as_written")
Model = Mapping[str, Any]


@dataclass(frozen=True)
class Definition:
    """A function of a page, or with no arguments a name for a formula.

    `scope`: what names in it stand for, those above it.
    """

    arguments: tuple[str, ...]
    formula: Formula
    scope: Meanings | None = None


@dataclass(frozen=True)
class Meanings:
    """What names stand for: `symbols` of quantities, values `defined`, functions; slots, models.

    `sizes`: how many nodes values have that were met before.
    """

    symbols: Mapping[str, sp.Symbol] = field(default_factory=dict)
    defined: Mapping[str, Any] = field(default_factory=dict)
    functions: Mapping[str, Definition] = field(default_factory=dict)
    slots: Mapping[str, Any] = field(default_factory=dict)
    models: Mapping[str, Model] = field(default_factory=dict)
    sizes: dict[Any, int] = field(default_factory=dict, repr=False, compare=False)

    @property
    def primed(self) -> frozenset[str]:
        """Names of quantities that end with '."""
        return frozenset(name for name in self.symbols if name.endswith("'"))

    def symbol(self, name: str) -> sp.Symbol:
        """The symbol of a quantity. Raises FormulaError for another name."""
        if name not in self.symbols:
            raise FormulaError(f"{name!r} is no quantity of this page")
        return self.symbols[name]

    def slot(self, name: str) -> Any:
        """The value of a slot. Raises FormulaError for another name."""
        if name not in self.slots:
            near = nearest(name, self.slots, 3) if len(self.slots) > FEW else None
            known = ", ".join(near or self.slots)
            raise FormulaError(f"no slot {name!r}; {'near it' if near else 'known'}: {known}")
        return self.slots[name]

    def model(self, name: str) -> Model:
        """A model by its name. Raises FormulaError for another name."""
        if name not in self.models:
            raise FormulaError(f"a model is wanted ({', '.join(self.models)}), {name!r} came")
        return self.models[name]

    def require_new(self, name: str) -> None:
        """Raise FormulaError for a name that is taken."""
        if name in RESERVED:
            raise FormulaError(f"{name!r} is a word of statements, no name")
        known = (self.symbols, self.defined, self.functions, BUILT_IN, self.models)
        if any(name in each for each in known):
            raise FormulaError(f"{name!r} has a meaning already")

    def define(self, name: str, definition: Definition) -> Meanings:
        """With one more definition; what it refers to has to be above it."""
        self.require_new(name)
        if definition.arguments:
            self._require_known(definition.formula, definition.arguments)
            known = replace(definition, scope=self)
            return replace(self, functions={**self.functions, name: known})
        value = self.value(definition.formula, multiplied=True)
        return replace(self, defined={**self.defined, name: value})

    def _require_known(self, formula: Formula, arguments: tuple[str, ...]) -> None:
        if formula.kind == "name" and formula.text not in arguments:
            self._named(formula.text)
        if formula.kind == "call" and formula.text not in (*self.functions, *BUILT_IN):
            raise self._no_function(formula.text)
        for part in formula.parts:
            self._require_known(part, arguments)

    def value(self, formula: Formula, multiplied: bool = False) -> Any:
        """An expression, a matrix or, unless `multiplied`, of matrices a sum or product.

        Raises FormulaError.
        """
        try:
            return self._value(formula, multiplied)
        except FormulaError:
            raise
        except (TypeError, ValueError, AttributeError) as error:
            # SymPy's words for shapes that do not fit, numbers among matrices and the like
            raise FormulaError(f"{str(formula)!r} has no value: {error}") from None

    def _value(self, formula: Formula, multiplied: bool) -> Any:
        value = self._worked_out(formula, multiplied)
        if value is sp.nan or value is sp.zoo:
            raise FormulaError(f"{str(formula)!r} divides by 0")
        if self._size(value) > MAXIMUM_SIZE:
            raise FormulaError(f"written out it has more than {MAXIMUM_SIZE} parts")
        return value

    def _size(self, value: Any) -> int:
        """Nodes of a value, powers written out; a long number counts more than once."""
        if isinstance(value, sp.MatrixBase):
            return sum(map(self._size, value.flat()))
        if isinstance(value, sp.Rational):
            return 1 + (int(value.p).bit_length() + int(value.q).bit_length()) // 64
        if value not in self.sizes:
            times = abs(value.exp) if isinstance(value, sp.Pow) and value.exp.is_Integer else 1
            self.sizes[value] = 1 + int(times) * sum(map(self._size, value.args))
        return self.sizes[value]

    def _worked_out(self, formula: Formula, multiplied: bool) -> Any:
        parts = formula.parts
        match formula.kind:
            case "number":
                return sp.Integer(int(formula.text))
            case "name":
                return self._named(formula.text)
            case "slot":
                found = self.slot(formula.text)
                if isinstance(found, str):
                    return self._value(read_formula(found, self.primed), multiplied)
                return found
            case "call":
                return self._called(formula.text, parts, multiplied)
        values = [self._value(part, multiplied) for part in parts]
        match formula.kind:
            case "matrix":
                columns = int(formula.text)
                return sp.ImmutableDenseMatrix(len(values) // columns, columns, values)
            case "neg":
                return _negative(values[0])
            case "add":
                return _sum(values, multiplied)
            case "mul":
                return _product(values, multiplied)
            case "div":
                return values[0] / values[1]
            case "pow":
                if _is_matrix(values[0]):
                    raise FormulaError(
                        f"{str(formula)!r} is a power of a matrix: write the product"
                    )
                return values[0] ** int(formula.text)
        return sp.ImmutableDenseMatrix(values[0].T)

    def _named(self, name: str) -> Any:
        if name in self.symbols:
            return self.symbols[name]
        if name in self.defined:
            return self.defined[name]
        if name in self.functions:
            raise FormulaError(f"{name!r} is a function: {name}(...) is wanted")
        near = nearest(name, [*self.symbols, *self.defined])
        hint = f"; {near[0]!r} is one" if near else ""
        raise FormulaError(f"{name!r} is neither a quantity nor a definition of this page{hint}")

    def _in_order(self, formula: Formula) -> Any:
        """With sums, and products of these, in the order in which they are written."""
        values = [self._in_order(part) for part in formula.parts if formula.kind != "call"]
        sums = any(value.has(sp.Add) for value in values)
        match formula.kind:
            case "add":
                return sp.Add(*values, evaluate=False)
            case "pow":
                return values[0] ** int(formula.text)
            case "mul" if sums:
                return sp.Mul(*values, evaluate=False)
            case "div" if sums:
                return sp.Mul(1 / values[1], values[0], evaluate=False)
        return self._value(formula, multiplied=True)

    def _called(self, name: str, parts: tuple[Formula, ...], multiplied: bool) -> Any:
        if name in self.functions:
            definition = self.functions[name]
            if len(parts) != len(definition.arguments):
                wanted = ", ".join(definition.arguments)
                raise FormulaError(f"{name}({wanted}) is wanted, {len(parts)} arguments came")
            values = [self._value(part, multiplied=True) for part in parts]
            assert definition.scope is not None
            inside = definition.scope._with_arguments(definition, values)
            return inside._value(definition.formula, multiplied=True)
        if name not in BUILT_IN:
            raise self._no_function(name)
        if name == "as_written" and len(parts) == 1:
            return self._in_order(parts[0])
        first = self._value(parts[0], multiplied or name == "determinant")
        match name, parts[1:]:
            case "sqrt", ():
                return sp.sqrt(first)
            case "determinant", ():
                return first.det()
            case "derivative", (by, *times) if not times or [x.kind for x in times] == ["number"]:
                variable = self.symbol(str(by))
                if times:
                    return sp.Derivative(first, (variable, int(times[0].text)))
                return sp.Derivative(first, variable)
            case "at", (place, value):
                return sp.Subs(first, self.symbol(str(place)), self._value(value, multiplied))
        raise FormulaError(
            "wanted: sqrt(x), determinant(M), derivative(f, x), derivative(f, x, 2), at(f, x, a), "
            "as_written(x)"
        )

    def _no_function(self, name: str) -> FormulaError:
        return FormulaError(f"{name!r} is no function; a product has a blank: {name} (...)")

    def _with_arguments(self, definition: Definition, values: list[Any]) -> Meanings:
        given = dict(zip(definition.arguments, values, strict=True))
        symbols = {name: value for name, value in self.symbols.items() if name not in given}
        return replace(self, symbols=symbols, defined={**self.defined, **given})


def _is_matrix(value: Any) -> bool:
    return isinstance(value, (sp.MatrixBase, sp.MatrixExpr))


def _sum(values: list[Any], multiplied: bool) -> Any:
    if not multiplied and any(map(_is_matrix, values)):
        return sp.MatAdd(*values, evaluate=False)
    total = values[0]
    for value in values[1:]:
        total = total + value
    return total


def _negative(value: Any) -> Any:
    if isinstance(value, sp.MatAdd):
        return sp.MatMul(-1, value, evaluate=False)
    return sp.MatMul(-1, *value.args, evaluate=False) if isinstance(value, sp.MatMul) else -value


def _product(values: list[Any], multiplied: bool) -> Any:
    if not multiplied and any(map(_is_matrix, values)):
        return sp.MatMul(*values, evaluate=False)
    total = values[0]
    for value in values[1:]:
        total = total * value
    return total
