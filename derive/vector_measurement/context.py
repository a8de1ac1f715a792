"""What all groups of steps of one family with position and velocity measured share."""

from __future__ import annotations

from collections.abc import Callable, Mapping
from dataclasses import dataclass
from typing import Any

import sympy as sp

from gainproof.derive.algebra.tower import Tower
from gainproof.derive.model import Model, ScaledModel, scale
from gainproof.derive.vector_measurement.forms import Basis
from gainproof.derive.vector_measurement.names import LEVEL
from gainproof.derive.vector_measurement.process_noise import Noise
from gainproof.derive.vector_measurement.spectrum import Spectrum, closed_loop, factorise
from gainproof.derive.vector_measurement.towers import main_tower, symbolic_basis

More = Callable[[Tower], Mapping[str, sp.Expr]]


@dataclass(frozen=True)
class Context:
    """A scaled model with its spectrum, closed-loop polynomial, tower and stable forms."""

    original: Model
    model: ScaledModel
    spectrum: Spectrum
    closed_loop: sp.Expr
    tower: Tower
    basis: Basis

    @property
    def noise(self) -> Noise:
        """The numbers of the family."""
        return self.spectrum.noise

    @property
    def level(self) -> sp.Expr:
        """w, or 1 where it is 1 for every index."""
        return LEVEL if self.noise.determinant else sp.Integer(1)

    @property
    def model_data(self) -> dict[str, Any]:
        """The scaled model as plain data."""
        return self.model.data()


def context(model: Model, more: More = lambda _: {}) -> Context:
    """Scale and factorise. Raises ModelError, naming the reason, outside the method's reach.

    `more`: further elements of the main tower, made from the tower without them.
    """
    scaled = scale(model)
    spectrum = factorise(scaled)
    noise = spectrum.noise
    return Context(
        model,
        scaled,
        spectrum,
        closed_loop(scaled),
        main_tower(noise, more(main_tower(noise))),
        symbolic_basis(noise),
    )
