"""Which form of each output is printed: the one with the least loss, and then the least bound."""

from __future__ import annotations

import math
from dataclasses import replace
from fractions import Fraction

import sympy as sp

from gainproof.derive.own_expressions.as_written import as_written
from gainproof.derive.own_expressions.conditions import asked
from gainproof.derive.own_expressions.expressions import ExpressionKernel, Result
from gainproof.derive.own_expressions.other_forms import Form, forms, rooted
from gainproof.derive.printer.bound import KernelBound, prove
from gainproof.derive.printer.formats import FORMATS
from gainproof.derive.printer.kernel import Kernel
from gainproof.derive.printer.known_values import known_values

SEED = "forms"
"""Of the points at which terms are compared with values."""

Cost = tuple[float, ...]


def chosen_forms(given: ExpressionKernel) -> dict[str, Form]:
    """The form of each output; nothing for one of which none has a bound."""
    required = [each.value for each in asked(given.conditions)]
    roots = frozenset[sp.Expr]().union(
        *map(rooted, required), *(rooted(each.expression) for each in given.outputs)
    )
    found = {}
    for output in given.outputs:
        costs = {}
        for form in forms(output.expression, roots, required):
            cost = _cost(given, output, form)
            if cost is not None:
                costs[form] = cost
        if costs:
            found[output.quantity.name] = min(costs, key=lambda form: costs[form])
    return found


def _cost(given: ExpressionKernel, output: Result, form: Form) -> Cost | None:
    """Whether terms may cancel; whether products may underflow; by how much the terms are larger
    than the value at some points; the bounds; the steps. None where there is no bound.
    """
    alone = replace(given, outputs=(output,))
    try:
        kernel = as_written(alone, {output.quantity.name: form}).kernel
        bounds = [prove(kernel, each) for each in FORMATS]
    except (ValueError, NotImplementedError):
        return None
    ends = [each.outputs[0] for each in bounds]
    (printed,) = kernel.outputs
    return (
        float(printed.by_terms),
        float(any(end.beside for end in ends)),
        _excess(kernel, bounds[0]) if printed.by_terms else 0.0,
        float(sum(end.bound for end in ends)),
        float(len(kernel.program.steps)),
    )


def _excess(kernel: Kernel, bound: KernelBound) -> float:
    """The mean of the logarithms of terms over value at a few points of the domain."""
    (output,) = kernel.outputs
    ratios = [
        float(Fraction(point["scales"][output.name]) / abs(value))
        for point in known_values(kernel, (bound,), SEED)["points"][bound.format.name]
        if (value := Fraction(point["values"].get(output.name, 0)))
    ]
    return round(sum(map(math.log, ratios)) / len(ratios), 3) if ratios else 0.0
