"""The free numbers of a model: signs of expressions over their whole domain."""

from __future__ import annotations

from dataclasses import dataclass
from functools import cached_property

import sympy as sp

from gainproof.derive.algebra.tower import Parameter as Positive
from gainproof.derive.algebra.tower import Poly, Tower, is_manifestly_positive
from gainproof.derive.any_two_state.names import ODDS
from gainproof.derive.expression import real
from gainproof.derive.model import Parameter

MOST_SHOWN = 200
"""Characters of an expression within a message: of more nobody reads what the matter is."""


class NoSign(ArithmeticError):
    """An expression without a sign that is shown over the whole domain of the parameters."""


def shown(expression: sp.Basic | sp.MatrixBase) -> str:
    """An expression for a message; of a long one how it begins, and the symbols that it holds."""
    text = str(expression.tolist() if isinstance(expression, sp.MatrixBase) else expression)
    if len(text) <= MOST_SHOWN:
        return text
    names = ", ".join(sorted(map(str, expression.free_symbols)))
    held = f" in {names}" if names else ""
    return f"{text[: MOST_SHOWN // 3].rstrip()} ... ({len(text)} characters{held})"


@dataclass(frozen=True)
class FreeNumbers:
    """The parameters of a model: each positive, or 1/(1 + x) with x positive."""

    parameters: tuple[Parameter, ...]

    @property
    def symbols(self) -> tuple[str, ...]:
        """The names of the tower's parameters."""
        return tuple(
            f"{entry.quantity.name}{ODDS}" if entry.below_one else entry.quantity.name
            for entry in self.parameters
        )

    @property
    def elements(self) -> dict[str, sp.Expr]:
        """The parameters below 1 by name, over those of the tower."""
        return {
            entry.quantity.name: 1 / (1 + real(f"{entry.quantity.name}{ODDS}"))
            for entry in self.parameters
            if entry.below_one
        }

    @cached_property
    def tower(self) -> Tower:
        """The tower of these numbers alone."""
        return Tower("numbers", tuple(Positive(name) for name in self.symbols), (), self.elements)

    def fraction(self, expression: sp.Expr) -> tuple[Poly, Poly]:
        """Numerator and denominator over the tower's parameters, without a common factor."""
        value = self.tower.fraction(sp.sympify(expression))
        top, bottom = value.num.cancel(value.den)
        return top, bottom

    def sign(self, expression: sp.Expr) -> int:
        """1, 0 or -1 on the whole domain. Raises NoSign where none is shown."""
        number = sp.sympify(expression)
        if number.is_Rational:
            return int(sp.sign(number))
        if number not in self._known:
            top, bottom = self.fraction(number)
            found = self._sign(top, number) * self._sign(bottom, number) if top else 0
            self._known[number] = found
        return self._known[number]

    @cached_property
    def _known(self) -> dict[sp.Expr, int]:
        """What has been asked before."""
        return {}

    def _sign(self, poly: Poly, expression: sp.Expr) -> int:
        constant, factors = poly.factor_list()
        sign = 1 if constant > 0 else -1
        for factor, power in factors:
            if is_manifestly_positive(factor, self.tower.parameters):
                continue
            if not is_manifestly_positive(-factor, self.tower.parameters):
                wanted = "to be other than 0" if power % 2 == 0 else "to have one sign"
                told = shown(sp.factor(expression))
                raise NoSign(f"{told} is not shown {wanted} for all parameters")
            sign *= (-1) ** power
        return sign

    def named(self, expression: sp.Expr) -> sp.Expr:
        """An expression over the tower's parameters in terms of the model's own."""
        back = {
            real(f"{entry.quantity.name}{ODDS}"): 1 / entry.quantity.symbol - 1
            for entry in self.parameters
            if entry.below_one
        }
        return sp.factor(sp.together(sp.sympify(expression).subs(back)))
