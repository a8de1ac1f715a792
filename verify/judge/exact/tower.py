"""One tower of radicals for all expressions of a claim.

Every root (N/D)^(1/n), n = 2 or 3, becomes a variable t = D * root with the monic relation t^n = N
D^(n-1). Every subexpression becomes a quotient of polynomials, reduced by the relations from the
top down. Nothing is inverted, and nothing is supposed about the signs of roots: that is decided at
a place (see `decision`).
"""

from __future__ import annotations

from dataclasses import dataclass, field
from math import prod

from gainproof.verify.judge.exact.expression import Expr
from gainproof.verify.judge.exact.polynomial import Poly, Ring, text
from gainproof.verify.judge.exact.radicands import (
    Element,
)
from gainproof.verify.judge.exact.tower_variables import Variables
from gainproof.verify.judge.exact.work_limits import DEFAULT_LIMITS, Limits, Undecided


@dataclass(frozen=True)
class Root:
    """Variable number `index` is t = D * (N/D)^(1/order); `radicand` is N/D."""

    index: int
    order: int
    radicand: Element
    relation: Poly

    @property
    def sign_poly(self) -> Poly:
        """N D, which has the sign of the radicand."""
        return self.radicand.num * self.radicand.den


@dataclass(frozen=True)
class Check:
    """What must hold for `node` to be defined: the divisor `poly` is not zero, or the root's
    radicand not negative.
    """

    node: Expr
    poly: Poly
    root: Root | None


@dataclass
class Tower:
    """Variables, highest first: roots (last made first), free symbols, then the parameters.

    Elements are polynomials in the free symbols, coefficient by coefficient functions of the real
    parameters; only parameters may stand under roots, unless the tower is `formal`.
    """

    parameters: tuple[str, ...]
    free: tuple[str, ...]
    positive: frozenset[str]
    limits: Limits = DEFAULT_LIMITS
    names: tuple[str, ...] = ()
    context: Ring = None
    roots: list[Root] = field(default_factory=list)
    elements: dict[bytes, Element] = field(default_factory=dict)
    checks: list[Check] = field(default_factory=list)
    nonnegative: frozenset[str] = frozenset()
    formal: bool = False
    _slots: int = 0

    @property
    def parameter(self) -> str | None:
        """The parameter of a tower with one, else None."""
        return self.parameters[0] if len(self.parameters) == 1 else None

    @property
    def parameter_index(self) -> int | None:
        """Position of the one parameter among the variables."""
        return None if self.parameter is None else len(self.names) - 1

    @property
    def parameter_indices(self) -> tuple[int, ...]:
        """Positions of the parameters."""
        return tuple(range(len(self.names) - len(self.parameters), len(self.names)))

    @property
    def variables(self) -> Variables:
        """What is known about the variables below the roots."""
        return Variables(
            self.free,
            self.free_indices,
            self.parameters,
            self.parameter_indices,
            self.positive,
            self.nonnegative,
        )

    @property
    def free_indices(self) -> tuple[int, ...]:
        """Positions of the free symbols."""
        return tuple(range(self._slots, self._slots + len(self.free)))

    @property
    def degree(self) -> int:
        """The product of the orders of all roots."""
        return prod(root.order for root in self.roots)

    def reduce(self, p: Poly) -> Poly:
        """Remainder by all relations, from the top down. Raises Undecided if it grows too long."""
        degrees = p.degrees()  # of 0 they are -1
        for root in reversed(self.roots):
            if degrees[root.index] >= root.order:
                p = divmod(p, root.relation)[1]
                degrees = p.degrees()
        if len(p) > self.limits.terms:
            raise Undecided(f"a polynomial of more than {self.limits.terms} terms")
        return p

    def element(self, expr: Expr) -> Element:
        """The element of an expression that was given when the tower was built."""
        return self.elements[expr.key]

    def relations_text(self) -> list[str]:
        """The relations, readable, lowest first."""
        found = []
        for root in self.roots:
            right = self.context.gen(root.index) ** root.order - root.relation
            found.append(f"{self.names[root.index]}^{root.order} = {text(right)}")
        return found
