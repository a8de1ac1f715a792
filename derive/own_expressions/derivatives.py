"""Derivatives of a user's results as results of their own: rows of a Jacobian."""

from __future__ import annotations

from collections.abc import Iterator, Sequence

from gainproof.derive.algebra.derivative import by
from gainproof.derive.own_expressions.expressions import Result
from gainproof.derive.quantity import Quantity


def derivatives(results: Sequence[Result], variables: Sequence[Quantity]) -> tuple[Result, ...]:
    """Of each result by each variable, but for those that are 0: that of `range` by `x` is called
    `range_D_x`, in the unit of the one over that of the other. Where an error beside the terms of
    a result will do, it does for its derivatives.
    """
    return tuple(_slopes(results, variables))


def _slopes(results: Sequence[Result], variables: Sequence[Quantity]) -> Iterator[Result]:
    for result in results:
        for variable in variables:
            slope = by(result.expression, variable.symbol)
            if slope == 0:
                continue
            one = result.quantity
            quantity = Quantity(
                f"{one.name}_D_{variable.name}",
                rf"\partial {one.latex}/\partial {variable.latex}",
                f"derivative of {one.name} by {variable.name}",
                one.unit / variable.unit,
            )
            yield Result(quantity, slope, result.by_terms)
