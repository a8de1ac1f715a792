"""Connected sets on which the truth of a statement does not change, as the tower sees them."""

from __future__ import annotations

from collections.abc import Sequence
from fractions import Fraction
from typing import Protocol

from gainproof.verify.judge.exact.algebraic_numbers import Algebraic

Sample = Fraction | tuple[Fraction | Algebraic, ...]
"""A rational value of the one parameter, or values of several in the order of the tower."""


class Connected(Protocol):
    """A place, or a cell or point of several parameters."""

    @property
    def at(self) -> Algebraic | None:
        """The point, where it is one of a tower with one parameter."""
        ...

    @property
    def is_cell(self) -> bool:
        """Whether it is an open set."""
        ...

    @property
    def samples(self) -> Sequence[Sample]:
        """Points of a cell, the simplest first; none for a point of a tower with one parameter."""
        ...

    @property
    def moved(self) -> Sequence[Sample]:
        """Further points of a cell, where the samples have coordinates in common."""
        ...
