"""What all groups of steps of one model share, of two states and of any number."""

from __future__ import annotations

from dataclasses import dataclass
from functools import cached_property
from typing import Generic, TypeVar

from gainproof.derive.algebra.leading_elements import Edge
from gainproof.derive.algebra.tower import Tower
from gainproof.derive.any_two_state.basis import Basis
from gainproof.derive.any_two_state.kernels import symbolic_basis
from gainproof.derive.any_two_state.model_numbers import MeasuredFirst, Shape
from gainproof.derive.any_two_state.names import ODDS
from gainproof.derive.any_two_state.towers import edges, main_tower
from gainproof.derive.model import Model, ScaledModel

Own = TypeVar("Own", bound=MeasuredFirst)


@dataclass(frozen=True)
class MeasuredContext(Generic[Own]):
    """A model with its scaled shape, of any number of states."""

    original: Model
    shape: Own

    @property
    def model(self) -> ScaledModel:
        """The scaled model."""
        return self.shape.model

    def latex(self) -> dict[str, str]:
        """LaTeX of the model's own symbols."""
        own = {quantity.name: quantity.latex for quantity in self.original.quantities}
        for entry in self.original.parameters:
            name = entry.quantity.name
            own[name] = entry.quantity.latex
            if entry.below_one:
                own[f"{name}{ODDS}"] = rf"x_{{{entry.quantity.latex}}}"
        return own


@dataclass(frozen=True)
class Context(MeasuredContext[Shape]):
    """One of two states; tower, forms and both ends of the index are made once."""

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
