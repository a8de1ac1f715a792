"""What all groups of steps of one two-state model share."""

from __future__ import annotations

from dataclasses import dataclass
from functools import cached_property

import sympy as sp

from gainproof.derive.algebra.leading_elements import Edge
from gainproof.derive.algebra.tower import Tower
from gainproof.derive.any_two_state.basis import Basis
from gainproof.derive.any_two_state.kernels import symbolic_basis
from gainproof.derive.any_two_state.model_numbers import Shape
from gainproof.derive.any_two_state.names import ODDS
from gainproof.derive.any_two_state.towers import edges, main_tower
from gainproof.derive.expression import real
from gainproof.derive.model import Model, ScaledModel


@dataclass(frozen=True)
class Context:
    """A model with its scaled shape; tower, forms and both ends of the index are made once."""

    original: Model
    shape: Shape

    @property
    def model(self) -> ScaledModel:
        """The scaled model."""
        return self.shape.model

    @cached_property
    def tower(self) -> Tower:
        """The tower of the steady state."""
        return main_tower(self.shape)

    @cached_property
    def basis(self) -> Basis:
        """The basis of the stable forms over the named quantities."""
        return symbolic_basis(self.shape)

    @cached_property
    def edges(self) -> tuple[Edge, Edge]:
        """Small and large index. Raises NoLeadingTerm."""
        return edges(self.shape, self.tower)

    def latex(self) -> dict[str, str]:
        """LaTeX of the model's own symbols."""
        own = {quantity.name: quantity.latex for quantity in self.original.quantities}
        for entry in self.original.parameters:
            name = entry.quantity.name
            own[name] = entry.quantity.latex
            if entry.below_one:
                own[f"{name}{ODDS}"] = rf"x_{{{entry.quantity.latex}}}"
        return own

    def symbols(self) -> list[sp.Symbol]:
        """The model's parameters as symbols."""
        return [real(entry.quantity.name) for entry in self.original.parameters]
