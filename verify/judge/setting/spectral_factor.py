"""What a stable factor of an innovation spectrum is."""

from __future__ import annotations

from collections.abc import Mapping
from dataclasses import dataclass, field, replace
from fractions import Fraction
from math import isqrt

from gainproof.verify.judge.exact.box import Box
from gainproof.verify.judge.exact.calculus import substituted
from gainproof.verify.judge.exact.expression import Expr, number, power, sqrt, symbol
from gainproof.verify.judge.exact.simplification import tidied
from gainproof.verify.judge.exact.statement import Rel
from gainproof.verify.judge.setting.environment import INDEX, POSITIVE


@dataclass(frozen=True)
class Factor:
    """c(z) as its coefficients from power 0 up, without the leading 1, and the innovation variance.

    Both in terms of `parameter`, which lives in `box`, and so is the tracking index; or in terms of
    a symbol that `put_in` expresses by the parameter and by roots of numbers. As long as it is a
    symbol all but the index is rational in it.

    Of a filter in numbers there is no parameter, or one whose only value is the root in `box` of
    the equation in `conditions`.
    """

    coefficients: tuple[Expr, ...]
    innovation: Expr
    parameter: str | None = INDEX
    box: Box = POSITIVE
    index: Expr = field(default_factory=lambda: symbol(INDEX))
    squared_index: Expr = field(default_factory=lambda: power(symbol(INDEX), 2))
    put_in: Mapping[str, Expr] = field(default_factory=dict)
    conditions: tuple[Rel, ...] = ()

    def boxes(self) -> dict[str, Box]:
        """Where the parameter lives; empty without one."""
        return {} if self.parameter is None else {self.parameter: self.box}

    def placed(self, expr: Expr) -> Expr:
        """An expression in the parameter alone, equal to this one wherever this one has a value:
        cancelled as long as it is rational.
        """
        return substituted(tidied(expr), self.put_in) if self.put_in else expr

    def in_parameter(self) -> Factor:
        """The same with everything expressed by the parameter."""
        return replace(
            self,
            coefficients=tuple(self.placed(c) for c in self.coefficients),
            innovation=self.placed(self.innovation),
            index=self.placed(self.index),
            squared_index=self.placed(self.squared_index),
            put_in={},
        )


def number_root(value: Fraction) -> Expr:
    """Square root of a number, written without a root where it is rational."""
    top, bottom = isqrt(abs(value.numerator)), isqrt(value.denominator)
    if value == Fraction(top, bottom) ** 2:
        return number(Fraction(top, bottom))
    return sqrt(number(value))
