"""Equations between words, each with the cofactors that show it."""

from __future__ import annotations

from collections.abc import Callable
from dataclasses import dataclass
from typing import Any

from gainproof.verify.judge.matrices.polynomial import Polynomial

Source = tuple[Any, ...]
"""Where an equation comes from, or what is known to be definite, as the checker names it; sizes and
letters by themselves.
"""


@dataclass(frozen=True)
class Cofactor:
    """left * (equation of the source, or its transpose) * right."""

    source: Source
    flipped: bool
    left: Polynomial
    right: Polynomial

    def negative(self) -> Cofactor:
        """Minus it."""
        return Cofactor(self.source, self.flipped, -self.left, self.right)

    def transposed(self) -> Cofactor:
        """Its transpose."""
        return Cofactor(self.source, not self.flipped, self.right.T, self.left.T)

    def inside(self, left: Polynomial, right: Polynomial) -> Cofactor:
        """With more factors on both sides."""
        return Cofactor(self.source, self.flipped, left @ self.left, self.right @ right)


@dataclass(frozen=True)
class Equation:
    """A polynomial in normal form that is the sum of cofactors, hence 0."""

    value: Polynomial
    make: Callable[[], tuple[Cofactor, ...]]

    @property
    def proof(self) -> tuple[Cofactor, ...]:
        """The cofactors, which are formed when they are wanted: most equations are never used."""
        return self.make()

    def transposed(self) -> Equation:
        """The transposed equation, not in normal form."""
        return Equation(self.value.T, lambda: tuple(c.transposed() for c in self.proof))

    def inside(self, left: Polynomial, right: Polynomial) -> Equation:
        """Between two factors, not in normal form."""
        value = left @ self.value @ right
        return Equation(value, lambda: tuple(c.inside(left, right) for c in self.proof))


@dataclass(frozen=True)
class Known:
    """What is known to be positive semidefinite, or definite where `strict`."""

    reference: Source
    value: Polynomial
    strict: bool
