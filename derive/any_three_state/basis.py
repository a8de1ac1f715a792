"""The index, the roots d0, ..., d3 and the numbers of a model, on which all forms are written."""

from __future__ import annotations

from collections.abc import Callable
from dataclasses import dataclass
from typing import Any

import sympy as sp

from gainproof.derive.any_three_state.forms import Form
from gainproof.derive.any_three_state.model_numbers import Shape
from gainproof.derive.any_three_state.monomials import Term
from gainproof.derive.any_three_state.names import DETERMINANT, INDEX, ROOTS
from gainproof.derive.any_two_state.signed_values import Signed, total


@dataclass(frozen=True)
class Basis:
    """The index and the four roots; `number` writes a positive number of the model."""

    shape: Shape
    index: Any
    roots: tuple[Any, Any, Any, Any]
    number: Callable[[sp.Expr], Any]

    @property
    def area(self) -> Any:
        """q, the square of the index."""
        return self.index * self.index

    @property
    def sum_of_roots(self) -> Any:
        """N = 8 sigma."""
        d0, d1, d2, d3 = self.roots
        return d0 + d1 + d2 + d3

    def term(self, expression: sp.Expr, *values: Any) -> Signed:
        """A number of the model times positive values."""
        found = self.shape.signed(expression)
        if found.is_zero:
            return Signed()
        size = found.plus if found.minus is None else found.minus
        product = None if size == 1 and values else self.number(size)
        for value in values:
            product = value if product is None else product * value
        return Signed(product) if found.minus is None else Signed(None, product)

    def linear(self, weights: sp.Expr) -> Any:
        """A sum of the roots and a number with positive weights."""
        names = [*ROOTS, sp.Integer(1)]
        whole = sp.Poly(weights, *ROOTS)
        parts = [whole.coeff_monomial(name) for name in names]
        return total(
            *(
                self.term(part, *([] if root is None else [root]))
                for part, root in zip(parts, (*self.roots, None), strict=True)
            )
        ).plus

    def valued(self, form: Form) -> Signed:
        """A form as a value, both of its parts over the sums below it."""
        sums = [
            self.determinant if entry == DETERMINANT else self.linear(entry) for entry in form.below
        ]
        parts: list[Any] = []
        for terms in (form.plus, form.minus):
            value = total(*map(self._product, terms)).plus
            for below in sums:
                value = None if value is None else value / below
            parts.append(value)
        return Signed(parts[0], parts[1])

    @property
    def determinant(self) -> Any:
        """d1 d2 - d0 d3 = (A1 A2 + 2 A1 d3 d1 + 2 A2 d0 d2)/(d1 d2) + 3 d0 d3."""
        d0, _, _, d3 = self.roots
        return (self.apart + Signed(3 * (d0 * d3))).plus

    @property
    def apart(self) -> Signed:
        """d1 d2 - 4 d0 d3."""
        d0, d1, d2, d3 = self.roots
        a1, a2 = (
            self.term(self.shape.still[k]) + self.term(self.shape.shaken[k], self.area)
            for k in (1, 2)
        )
        whole = a1 * a2 + a1.times(2 * (d3 * d1)) + a2.times(2 * (d0 * d2))
        return whole.over(d1 * d2)

    def _product(self, term: Term) -> Signed:
        factors = [
            factor
            for factor, power in zip((self.index, *self.roots), term.powers, strict=True)
            for _ in range(power)
        ]
        return self.term(term.number, *factors)


def symbolic_basis(shape: Shape) -> Basis:
    """The basis over the named quantities."""
    return Basis(shape, INDEX, ROOTS, lambda entry: entry)
