"""What a user's file says: quantities, their domains, and expressions over them."""

from __future__ import annotations

from dataclasses import dataclass

import sympy as sp

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
class Result:
    """An output: a quantity, and what it is over the symbols of the inputs' quantities."""

    quantity: Quantity
    expression: sp.Expr


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


@dataclass(frozen=True)
class ExpressionSet:
    """A module: `name` with hyphens for underscores, `title` one line."""

    name: str
    title: str
    kernels: tuple[ExpressionKernel, ...]
