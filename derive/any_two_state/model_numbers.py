"""The numbers of a two-state model that its steady state is made of.

With z = (1 + s)/(1 - s), (1 - s)^2 det(zI - F) is f(s) = f2 s^2 + f1 s + f0, and the numerator of
the noise's spectrum H adj(zI - F) Q0 adj(I/z - F)' H' times (1 - s^2)^2 is (1 - s^2)(n0 - n1 s^2):
f0 and f2 are det(I - F) and det(I + F), n0 and n1 the numerator at z = 1 and z = -1.
"""

from __future__ import annotations

from dataclasses import dataclass
from functools import cached_property

import sympy as sp

from gainproof.derive.any_two_state.domain import FreeNumbers, NoSign
from gainproof.derive.any_two_state.signed_values import Signed
from gainproof.derive.model import Model, ModelError, ScaledModel


@dataclass(frozen=True)
class MeasuredFirst:
    """A scaled model with H = [1, 0, ...], R = 1, and the signs of what it is made of."""

    model: ScaledModel
    numbers: FreeNumbers

    def entry(self, i: int, j: int) -> sp.Expr:
        """An entry of F, counted from 1."""
        return self.model.transition[i - 1, j - 1]

    def noise(self, i: int, j: int) -> sp.Expr:
        """An entry of Q0, counted from 1."""
        return self.model.process_noise[i - 1, j - 1]

    @cached_property
    def determinant(self) -> sp.Expr:
        """det F."""
        return sp.factor(self.model.transition.det())

    def sign(self, expression: sp.Expr) -> int:
        """1, 0 or -1. Raises ModelError, naming the expression, where no sign is shown."""
        try:
            return self.numbers.sign(expression)
        except NoSign as error:
            raise ModelError(
                f"model {self.model.name}: {error}, and the formulas depend on its sign; take a "
                "number for a parameter in it"
            ) from None

    def readable(self, expression: sp.Expr) -> sp.Expr:
        """The factors of an expression, each written as a positive number: 1 - r, not r - 1."""
        value = sp.factor(expression)
        if not value.free_symbols:
            return value
        result: sp.Expr = sp.Integer(1)
        for part, exponent in ((sp.fraction(value)[0], 1), (sp.fraction(value)[1], -1)):
            constant, factors = sp.factor_list(part)
            result *= sp.Rational(constant) ** exponent
            for factor, power in factors:
                sign = self._shown_sign(factor)
                result *= sp.expand(sign * factor) ** (power * exponent) * sign**power
        return result

    def _shown_sign(self, factor: sp.Expr) -> int:
        try:
            return self.numbers.sign(factor)
        except NoSign:
            return 1

    @cached_property
    def _known(self) -> dict[sp.Expr, Signed]:
        """What has been asked before: the same numbers stand in many forms."""
        return {}

    def signed(self, expression: sp.Expr) -> Signed:
        """An expression of the model's numbers as a value of known sign."""
        if expression not in self._known:
            self._known[expression] = self._signed(expression)
        return self._known[expression]

    def _signed(self, expression: sp.Expr) -> Signed:
        sign = self.sign(expression)
        if sign == 0:
            return Signed()
        size = self.readable(expression if sign > 0 else -expression)
        return Signed(size) if sign > 0 else Signed(None, size)


@dataclass(frozen=True)
class Shape(MeasuredFirst):
    """The same of two states."""

    @cached_property
    def open_loop(self) -> tuple[sp.Expr, sp.Expr, sp.Expr]:
        """f0, f1, f2."""
        one, matrix = sp.eye(2), self.model.transition
        return (
            self.readable((one - matrix).det()),
            self.readable(2 * (1 - matrix.det())),
            self.readable((one + matrix).det()),
        )

    @cached_property
    def noise_ends(self) -> tuple[sp.Expr, sp.Expr]:
        """n0 and n1."""
        return self.readable(self._numerator(1)), self.readable(self._numerator(-1))

    def _numerator(self, z: int) -> sp.Expr:
        line = self.model.measurement * (z * sp.eye(2) - self.model.transition).adjugate()
        return sp.expand((line * self.model.process_noise * line.T)[0, 0])


def shape_of(model: Model, scaled: ScaledModel) -> Shape:
    """The shape. Raises ModelError unless the first state is measured, with unit gain and noise."""
    require_first_measured(model, scaled)
    return Shape(scaled, FreeNumbers(model.parameters))


def require_first_measured(model: Model, scaled: ScaledModel) -> None:
    """H is [1, 0, ...] and R is 1; raises ModelError otherwise."""
    first = sp.zeros(1, scaled.transition.rows)
    first[0, 0] = 1
    wanted = sp.ImmutableDenseMatrix(first), sp.ImmutableDenseMatrix([[1]])
    if (scaled.measurement, scaled.measurement_noise) != wanted:
        raise ModelError(
            f"model {model.name}: the first state is to be measured: in units T = 1 and sigma_v = "
            f"1 H = {first.tolist()} and R = [[1]] are wanted, they are "
            f"{scaled.measurement.tolist()} and {scaled.measurement_noise.tolist()}; take what is "
            "measured, also a sum of states, as the first state: with the new states C x, F "
            "becomes C F C^-1 and Q becomes C Q C'"
        )
