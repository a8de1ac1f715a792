"""The interface between the evaluation of a formula and the table of symbols."""

from __future__ import annotations

from collections.abc import Mapping, Sequence
from typing import Protocol

from gainproof.verify.judge.exact.expression import Expr
from gainproof.verify.judge.meaning.bindings import Bindings
from gainproof.verify.judge.meaning.value import Value

Marks = tuple[int, int, int, int]
"""How many expressions that need values, requirements, whole numbers and slopes are collected."""


class Names(Protocol):
    """What an evaluation asks of the table of symbols."""

    def symbol(self, token: str, bindings: Bindings) -> Value:
        """What a symbol stands for."""
        ...

    def is_declared(self, token: str) -> bool:
        """Whether the table of symbols has it."""
        ...

    def is_shared(self, name: str, *of: Expr) -> bool:
        """Whether expressions change with a base variable in a way that they do not show."""
        ...

    def angle(self, argument: Expr, value: Expr) -> Expr:
        """The value of the argument of a sine or the like in radians."""
        ...

    def function(self, name: str, arguments: Sequence[Value], bindings: Bindings) -> Value:
        """The value of a declared function."""
        ...

    def derivative(self, value: Value, token: str, bindings: Bindings) -> Value:
        """The derivative with respect to a symbol."""
        ...

    def refuse_free_index(self, body: Expr, token: str) -> None:
        """Raises Undecided if a free symbol has the token as its index."""
        ...

    def refuse_own_terms(self, value: Value, token: str) -> None:
        """Raises Undecided if the token is a term of a sequence in the value."""
        ...

    def marks_alone(self, body: Expr) -> Marks | None:
        """How much is collected before a body of free symbols alone; None for any other."""
        ...

    def require_at(self, token: str, values: Mapping[str, Expr], since: Marks | None) -> None:
        """Notes that sums, integrals and derivatives must have values where a symbol is replaced;
        there alone, if it is known since when they were collected.
        """
        ...

    def bound(
        self, kind: str, body: Expr, token: str, low: Value, high: Value, bindings: Bindings
    ) -> Value:
        """A sum or an integral of `body` over the bound name `token`."""
        ...

    def expectation(self, value: Value, bindings: Bindings) -> Value:
        """The expectation, with variances under the bindings."""
        ...
