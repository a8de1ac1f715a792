"""The index, the roots d0, d1, d2 and the numbers of a model, on which all forms are written."""

from __future__ import annotations

from collections.abc import Callable
from dataclasses import dataclass
from typing import Any

import sympy as sp

from gainproof.derive.any_two_state.model_numbers import Shape
from gainproof.derive.any_two_state.signed_values import Signed, total

Number = Callable[[sp.Expr], Any]


@dataclass(frozen=True)
class Basis:
    """The index and the three roots d0, d1, d2; `number` writes a positive number of the model."""

    shape: Shape
    index: Any
    roots: tuple[Any, Any, Any]
    number: Number

    def signed(self, expression: sp.Expr) -> Signed:
        """A number of the model; ModelError where its sign is not known."""
        found = self.shape.signed(expression)
        return Signed(*(None if part is None else self.number(part) for part in found.parts))

    def term(self, expression: sp.Expr, value: Any) -> Signed:
        """A number of the model times a positive value."""
        found = self.shape.signed(expression)
        if found.is_zero:
            return Signed()
        size = found.plus if found.minus is None else found.minus
        product = value if size == 1 else self.number(size) * value
        return Signed(product) if found.minus is None else Signed(None, product)

    def scaled(self, expression: sp.Expr, value: Signed) -> Signed:
        """A number of the model times a value of any sign."""
        plus, minus = (
            Signed() if part is None else self.term(expression, part) for part in value.parts
        )
        return plus - minus

    @property
    def area(self) -> Any:
        """q, the square of the index."""
        return self.index * self.index

    @property
    def sum_of_roots(self) -> Any:
        """N = 4 sigma."""
        d0, d1, d2 = self.roots
        return d0 + d1 + d2

    def weighed(self, weights: tuple[sp.Expr, sp.Expr, sp.Expr], values: tuple[Any, ...]) -> Signed:
        """The sum of the values, each times a number of the model."""
        return total(
            *(
                self.term(weight, value)
                for weight, value in zip(weights, values, strict=True)
                if value is not None
            )
        )

    @property
    def far_weights(self) -> tuple[sp.Expr, sp.Expr, sp.Expr]:
        """g^2, g h and h^2."""
        last = self.shape.entry(2, 2)
        plus, minus = 1 + last, 1 - last
        return sp.expand(plus**2), sp.expand(plus * minus), sp.expand(minus**2)
