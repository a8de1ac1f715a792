"""The worst error met at random points, by evaluating the kernel's graph in balls.

The graph is read anew here and evaluated by python-flint at rising precision until the ball is
narrower than 2^-80 of its size: what the kernel should have returned, apart from rounding.
"""

from __future__ import annotations

import math
from collections.abc import Mapping, Sequence
from fractions import Fraction
from typing import Any

from flint import arb, ctx, fmpq

Graph = Mapping[str, Any]
Ball = Any  # flint.arb; python-flint ships no types


def ball_outputs(graph: Graph, point: Mapping[str, float], precision: int = 192) -> dict[str, Ball]:
    """Balls round the exact outputs of a graph at floats, one for each symbol."""
    with ctx.workprec(precision):
        values: list[Ball] = []
        for operation, *operands in graph["nodes"]:
            values.append(_value(operation, operands, values, point))
        found = {name: values[number] for name, number in graph["outputs"].items()}
        narrow = all(value.rel_accuracy_bits() > 80 or value == 0 for value in found.values())
    if narrow or precision > 4000:
        return found
    return ball_outputs(graph, point, 2 * precision)


def _value(
    operation: str, operands: Sequence[Any], values: list[Ball], point: Mapping[str, float]
) -> Ball:
    if operation == "number":
        number = Fraction(operands[0])
        return arb(fmpq(number.numerator, number.denominator))
    if operation == "symbol":
        return arb(point[operands[0]])
    if operation == "call":
        name, *rest = operands
        chosen = [values[number] for number in rest]
        if name == "abs":
            return abs(chosen[0])
        if chosen[0] < chosen[1]:
            return chosen[2]
        if chosen[0] >= chosen[1]:
            return chosen[3]
        raise ArithmeticError(f"the branch at {point!r} is not decided at this precision")
    if operation == "pow":
        return values[operands[0]].sqrt()
    first, *rest = (values[number] for number in operands)
    for other in rest:
        if operation == "add":
            first += other
        elif operation == "mul":
            first *= other
        else:
            first /= other
    return -first if operation == "neg" else first


def error(value: float, exact: Ball, scale: Ball, epsilon: float) -> float:
    """|value - exact|/|scale| in units of epsilon, rounded to a float."""
    return float(((arb(value) - exact) / scale).abs_upper().mid()) / epsilon


def log_uniform(lowest: float, highest: float, count: int, generator: Any) -> list[float]:
    """Points between two positive floats, uniform in the logarithm, the ends included."""
    low, high = math.log2(lowest), math.log2(highest)
    exponents = low + (high - low) * generator.random(count)
    points = [2.0 ** float(entry) for entry in exponents]
    return [lowest, highest, *(min(max(point, lowest), highest) for point in points)]
