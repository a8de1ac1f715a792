"""What all groups of steps of one three-state family share."""

from __future__ import annotations

from collections.abc import Mapping
from dataclasses import dataclass
from typing import Any

import sympy as sp

from gainproof.derive.algebra.limits import End
from gainproof.derive.algebra.tower import Tower
from gainproof.derive.model import Model, ScaledModel, scale
from gainproof.derive.steady_state.towers import rational
from gainproof.derive.three_state.curvature import numbers, powers
from gainproof.derive.three_state.lowest_terms import Quotient, Quotients, over_parameter, quotients
from gainproof.derive.three_state.spectrum import Spectrum, factorise
from gainproof.derive.three_state.tower_ends import end, start
from gainproof.derive.three_state.towers import (
    Constants,
    constants,
    main_tower,
    named_elements,
    scale_of_parameter,
)


@dataclass(frozen=True)
class Context:
    """A scaled model with its spectrum, constants, tower, and its elements as quotients in xi."""

    original: Model
    model: ScaledModel
    spectrum: Spectrum
    constants: Constants
    tower: Tower
    quotients: Quotients

    @property
    def ends(self) -> Mapping[str, End]:
        """Behaviour of the tower at both ends of the parameter."""
        return {"0": start(self.spectrum), "infinity": end(self.spectrum)}

    @property
    def model_data(self) -> dict[str, Any]:
        """The scaled model as plain data."""
        return self.model.data()

    @property
    def numbers(self) -> tuple[sp.Rational, sp.Rational, sp.Rational]:
        """a1, a2 and e: (1 + u)(1 + m1 u + m2 u^2) = 1 + a1 u + a2 u^2 + e u^3."""
        spectrum = self.spectrum
        return rational(spectrum.a1), rational(spectrum.a2), rational(spectrum.e)

    def shown(self, quotient: Quotient) -> sp.Expr:
        """A positive quotient in xi over the parameter.

        Raises ArithmeticError where lowest terms show no sign.
        """
        excess = self.constants.least, scale_of_parameter(self.spectrum)
        return over_parameter(self.tower, excess, quotient)


def context(model: Model) -> Context:
    """Scale a three-state model with measured position and read its spectrum.

    Raises ModelError, naming the reason, outside the method's reach.
    """
    scaled = scale(model)
    spectrum = factorise(scaled)
    tower = main_tower(scaled, spectrum)
    k = constants(spectrum)
    named = {**named_elements(scaled, spectrum), **powers(numbers(scaled, spectrum))}
    known = quotients(spectrum, named)
    return Context(model, scaled, spectrum, k, tower, known)
