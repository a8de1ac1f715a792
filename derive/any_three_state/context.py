"""What all groups of steps of one three-state model share."""

from __future__ import annotations

from dataclasses import dataclass
from functools import cached_property

from gainproof.derive.algebra.leading_elements import Edge
from gainproof.derive.algebra.tower import Tower
from gainproof.derive.any_three_state.basis import Basis, symbolic_basis
from gainproof.derive.any_three_state.model_numbers import Shape
from gainproof.derive.any_three_state.quantities import Quantities
from gainproof.derive.any_three_state.towers import edges, main_tower
from gainproof.derive.any_two_state.context import MeasuredContext


@dataclass(frozen=True)
class Context(MeasuredContext[Shape]):
    """One of three states; tower, forms and both ends of the index are made once."""

    @cached_property
    def tower(self) -> Tower:
        """The tower of the steady state."""
        return main_tower(self.shape)

    @cached_property
    def basis(self) -> Basis:
        """The basis of the stable forms over the named quantities."""
        return symbolic_basis(self.shape)

    @cached_property
    def quantities(self) -> Quantities:
        """The stable forms."""
        return Quantities(self.tower)

    @cached_property
    def edges(self) -> tuple[Edge, Edge]:
        """Small and large index. Raises NoLeadingTerm."""
        return edges(self.shape, self.tower)
