"""Units of expressions: what is added agrees, what a function takes has dimension one."""

from __future__ import annotations

from collections.abc import Mapping
from fractions import Fraction
from functools import reduce
from operator import mul

import sympy as sp

from gainproof.derive.own_expressions.conditions import relation_of
from gainproof.derive.own_expressions.expressions import ExpressionError, ExpressionKernel
from gainproof.derive.quantity import ONE, Unit


def require_units(kernel: ExpressionKernel) -> None:
    """Raise ExpressionError unless every output has the unit that it is said to have."""
    units = {each.quantity.symbol: each.quantity.unit for each in kernel.inputs}
    for number, condition in enumerate(kernel.conditions, 1):
        left, right = (sp.sympify(side) for side in relation_of(condition).args)
        if not (left.is_number or right.is_number):
            try:
                unit_of(sp.Add(left, right, evaluate=False), units)
            except ExpressionError as error:
                raise ExpressionError(f"{kernel.name}: condition {number}: {error}") from None
    for output in kernel.outputs:
        quantity = output.quantity
        try:
            found = unit_of(sp.sympify(output.expression), units)
        except ExpressionError as error:
            raise ExpressionError(f"{kernel.name}: {quantity.name}: {error}") from None
        if found != quantity.unit:
            raise ExpressionError(
                f"{kernel.name}: {quantity.name} should have the unit {quantity.unit}, its "
                f"expression has {found}"
            )


def unit_of(value: sp.Expr, units: Mapping[sp.Symbol, Unit]) -> Unit:
    """The unit of an expression; ExpressionError where parts of it do not agree."""
    if isinstance(value, sp.Symbol):
        if value not in units:  # of an integral or a sum
            raise ExpressionError(f"the symbol {value} is of no input's quantity")
        return units[value]
    if value.is_number:
        return ONE
    parts = [unit_of(part, units) for part in value.args]
    if isinstance(value, sp.Mul):
        return reduce(mul, parts)
    if isinstance(value, sp.Pow):
        if not isinstance(value.exp, sp.Rational):
            raise ExpressionError(f"a rational exponent is wanted, {value} came")
        return parts[0] ** Fraction(int(value.exp.p), int(value.exp.q))
    if isinstance(value, (sp.Add, sp.atan2)):
        for part, unit in zip(value.args[1:], parts[1:], strict=True):
            if unit != parts[0]:
                raise ExpressionError(
                    f"{value.args[0]} has the unit {parts[0]} and {part} has {unit}, in {value}"
                )
        return parts[0] if isinstance(value, sp.Add) else ONE
    if isinstance(value, sp.Abs):
        return parts[0]
    for part, unit in zip(value.args, parts, strict=True):
        if unit != ONE:
            raise ExpressionError(f"{part} should have the unit 1, it has {unit}, in {value}")
    return ONE
