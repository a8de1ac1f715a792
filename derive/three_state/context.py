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
from gainproof.derive.three_state.curvature import powers
from gainproof.derive.three_state.forms import numbers
from gainproof.derive.three_state.lowest_terms import Quotients, quotients
from gainproof.derive.three_state.spectrum import Spectrum, factorise
from gainproof.derive.three_state.tower_ends import end, start
from gainproof.derive.three_state.towers import (
    Constants,
    constants,
    main_tower,
    named_elements,
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

    @property
    def running(self) -> str:
        """The variable of limits: the index where it is rational in the parameter, else that."""
        return "p" if self.spectrum.m2 else "tracking_index"


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
