"""Matrix formulas as people write them: trees over named letters, numbers and parameters.

`@` is the product of matrices, `*` that with a number or a parameter, `.T` the transpose,
`.inverse` the inverse of a letter. A formula keeps its parentheses, so that what is claimed is what
is read; `setting.Setting.expand` multiplies it out.
"""

from __future__ import annotations

from dataclasses import dataclass
from fractions import Fraction
from typing import Any

Number = int | Fraction


@dataclass(frozen=True)
class Expression:
    """One node: its kind as in graphs, its name or number, its arguments."""

    kind: str
    value: str = ""
    arguments: tuple[Expression, ...] = ()

    def __add__(self, other: Expression | Number) -> Expression:
        return Expression("add", "", (*self._parts("add"), *_wrapped(other)._parts("add")))

    def __neg__(self) -> Expression:
        return Expression("neg", "", (self,))

    def __sub__(self, other: Expression | Number) -> Expression:
        return self + -_wrapped(other)

    def __radd__(self, other: Number) -> Expression:
        return number(other) + self

    def __rsub__(self, other: Number) -> Expression:
        return number(other) - self

    def __matmul__(self, other: Expression) -> Expression:
        return Expression("mul", "", (*self._parts("mul"), *other._parts("mul")))

    def __mul__(self, other: Expression | Number) -> Expression:
        return self @ _wrapped(other)

    def __rmul__(self, other: Number) -> Expression:
        return number(other) @ self

    def __truediv__(self, other: Expression | Number) -> Expression:
        return Expression("div", "", (self, _wrapped(other)))

    def __pow__(self, exponent: int) -> Expression:
        """Of a number or a parameter."""
        return Expression("pow", str(exponent), (self,))

    @property
    def T(self) -> Expression:
        """The transpose; that of a transpose is the matrix itself."""
        if self.kind == "transpose":
            return self.arguments[0]
        return Expression("transpose", "", (self,))

    @property
    def inverse(self) -> Expression:
        """The inverse, of a letter only."""
        return Expression("inverse", "", (self,))

    @property
    def graph(self) -> dict[str, Any]:
        """The graph, equal nodes stored once."""
        nodes: list[list[Any]] = []
        known: dict[tuple[Any, ...], int] = {}
        last = _write(self, nodes, known)
        return {"nodes": nodes, "outputs": {"value": last}}

    def _parts(self, kind: str) -> tuple[Expression, ...]:
        return self.arguments if self.kind == kind else (self,)


def number(value: Number) -> Expression:
    """A rational number."""
    return Expression("number", str(Fraction(value)))


def symbol(name: str) -> Expression:
    """A letter, a unit matrix or a parameter by its name."""
    return Expression("symbol", name)


def unit(size: str) -> Expression:
    """The unit matrix of a size without a name for it, for proofs: claims name theirs."""
    return Expression("unit", size)


def symbols(names: str) -> tuple[Expression, ...]:
    """Several, their names apart by spaces."""
    return tuple(symbol(name) for name in names.split())


ZERO = number(0)


def _wrapped(value: Expression | Number) -> Expression:
    return value if isinstance(value, Expression) else number(value)


def _write(value: Expression, nodes: list[list[Any]], known: dict[tuple[Any, ...], int]) -> int:
    places = [_write(part, nodes, known) for part in value.arguments]
    text = [value.value] if value.value else []
    node = (value.kind, *(places + text if value.kind == "pow" else text + places))
    if node not in known:
        known[node] = len(nodes)
        nodes.append(list(node))
    return known[node]
