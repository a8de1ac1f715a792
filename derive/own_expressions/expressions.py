"""What a user's file says: quantities, their domains, expressions over them, and derivatives of
these.
"""

from __future__ import annotations

from collections.abc import Iterator, Sequence
from dataclasses import dataclass

import sympy as sp

from gainproof.derive.algebra.derivative import by
from gainproof.derive.quantity import Quantity


class ExpressionError(ValueError):
    """Expressions that cannot be used; the message says what was wanted and what came."""


@dataclass(frozen=True)
class Argument:
    """An input: a quantity with the numbers that it takes, in its unit.

    From `lower` to `upper`, texts such as "1e-3" or "1/7", both admitted. `single`: both in
    float32, where they are others. `zero`: 0 is admitted too. `signed`: either sign, and 0; the
    domain is that of the magnitude. The only input of a kernel may do without: above `lower` if
    that is "0", and up to every finite number if `upper` is None.
    """

    quantity: Quantity
    lower: str = "0"
    upper: str | None = None
    single: tuple[str, str] | None = None
    zero: bool = False
    signed: bool = False


@dataclass(frozen=True)
class Condition:
    """What inputs fulfil together; a kernel refuses others, with their place.

    `relation`: of SymPy, over the symbols of the inputs' quantities: `x**2 + y**2 > 0`,
    `a**2 < b**2`, `sp.Eq(q**2 + r**2, 1)`. Numbers in it are exact, and count as fulfilling it, but
    for 0. `meaning`: a phrase for the greater side, or for the difference where the other is no
    number. `single`: the number in float32, as text, where it is another. `within`: by how much the
    sides of an equality may differ, as texts in float64 and in float32.
    """

    relation: sp.Basic | bool
    meaning: str
    single: str | None = None
    within: tuple[str, str] | None = None


@dataclass(frozen=True)
class Result:
    """An output: a quantity, and what it is over the symbols of the inputs' quantities.

    `by_terms`: an error that is small beside the terms of the expression, taken positive, will do,
    also where it is no small part of the value, as where that passes through 0 whatever its form.
    """

    quantity: Quantity
    expression: sp.Expr
    by_terms: bool = False


@dataclass(frozen=True)
class ExpressionKernel:
    """A function of the printed module: `name` in Python, `title` one line, `source` what it rests
    on.
    """

    name: str
    title: str
    inputs: tuple[Argument, ...]
    outputs: tuple[Result, ...]
    source: str = "the expressions of its author"
    conditions: tuple[Condition, ...] = ()


@dataclass(frozen=True)
class ExpressionSet:
    """A module: `name` with hyphens for underscores, `title` one line."""

    name: str
    title: str
    kernels: tuple[ExpressionKernel, ...]


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
