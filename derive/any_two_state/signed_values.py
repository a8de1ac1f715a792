"""Values as a positive part less another: what cancels in a form is seen, never hidden.

The parts are anything with the operators + * /, positive wherever they occur: SymPy expressions or
nodes of a kernel's graph.
"""

from __future__ import annotations

from dataclasses import dataclass
from typing import Any

import sympy as sp


@dataclass(frozen=True)
class Signed:
    """plus - minus; None stands for a part that is not there."""

    plus: Any = None
    minus: Any = None

    def __add__(self, other: Signed) -> Signed:
        return Signed(_total(self.plus, other.plus), _total(self.minus, other.minus))

    def __neg__(self) -> Signed:
        return Signed(self.minus, self.plus)

    def __sub__(self, other: Signed) -> Signed:
        return self + -other

    def __mul__(self, other: Signed) -> Signed:
        return Signed(
            _total(_product(self.plus, other.plus), _product(self.minus, other.minus)),
            _total(_product(self.plus, other.minus), _product(self.minus, other.plus)),
        )

    def times(self, positive: Any) -> Signed:
        """The product with a positive value."""
        return self * Signed(positive)

    def over(self, positive: Any) -> Signed:
        """The quotient by a positive value."""
        return Signed(*(None if part is None else part / positive for part in self.parts))

    @property
    def parts(self) -> tuple[Any, Any]:
        """Both parts."""
        return self.plus, self.minus

    @property
    def cancels(self) -> bool:
        """Whether both parts are there."""
        return self.plus is not None and self.minus is not None

    @property
    def is_positive(self) -> bool:
        """Whether only the positive part is there."""
        return self.plus is not None and self.minus is None

    @property
    def is_zero(self) -> bool:
        """Whether no part is there."""
        return self.plus is None and self.minus is None

    @property
    def value(self) -> Any:
        """plus - minus, for values of a sign that is known or not; 0 where nothing is there."""
        if self.minus is None:
            return sp.Integer(0) if self.plus is None else self.plus
        return -self.minus if self.plus is None else self.plus - self.minus

    @property
    def scale(self) -> Any:
        """plus + minus, what the error of a difference is measured by."""
        return self.plus + self.minus


def total(*terms: Signed) -> Signed:
    """The sum of any number of terms."""
    result = Signed()
    for term in terms:
        result = result + term
    return result


def _total(first: Any, second: Any) -> Any:
    if first is None or second is None:
        return second if first is None else first
    return first + second


def _product(first: Any, second: Any) -> Any:
    return None if first is None or second is None else first * second
