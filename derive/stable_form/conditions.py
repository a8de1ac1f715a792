"""How much a subtraction that is left may lose: its condition number over a domain.

That of a value over its scale, the same with both sides of each difference added, is scale/|value|:
so many times the error bound that holds over the scale is what the value's own error may be.
"""

from __future__ import annotations

import itertools
import math
from collections.abc import Mapping, Sequence
from dataclasses import dataclass
from fractions import Fraction
from typing import Any

from mpmath import mp

from gainproof.derive.printer.domain import input_range
from gainproof.derive.printer.formats import FLOAT64
from gainproof.derive.printer.graph import Graph, operands
from gainproof.derive.printer.kernel import Input

POINTS = 400  # in all
WIDEST = 1e30  # inputs beyond, and below its inverse, are not looked at
DIGITS = 60


@dataclass(frozen=True)
class Condition:
    """The condition number is at least `least`, which it has at `place`; infinite: the value
    changes its sign on the domain, from `place` on.
    """

    least: float
    place: Mapping[str, float]


def condition(graph: Graph, value: str, scale: str, inputs: Sequence[Input]) -> Condition:
    """The largest of a grid of points of the domain, a logarithmic one."""
    count = max(3, int(POINTS ** (1 / len(inputs))))
    axes = [_axis(given, count) for given in inputs]
    names = [given.name for given in inputs]
    worst = Condition(1.0, {})
    signs: set[bool] = set()
    with mp.workdps(DIGITS):
        for point in itertools.product(*axes):
            place = dict(zip(names, point, strict=True))
            found = _values(graph, place)
            number, size = found[graph["outputs"][value]], found[graph["outputs"][scale]]
            signs.add(number > 0)
            if number == 0 or len(signs) == 2:
                return Condition(math.inf, place)
            least = float(abs(size / number))
            if least > worst.least:
                worst = Condition(least, place)
    return worst


def _axis(given: Input, count: int) -> list[float]:
    low, high = input_range(given, FLOAT64)
    low, high = max(low, 1 / WIDEST), min(high, WIDEST)
    step = math.log(high / low) / (count - 1)
    inner = [low * math.exp(step * number) for number in range(1, count - 1)]
    return [low, *(min(max(x, low), high) for x in inner), high]


def _values(graph: Graph, point: Mapping[str, float]) -> list[Any]:
    """The value of every node."""
    values: list[Any] = []
    for node in graph["nodes"]:
        parts = [values[part] for part in operands(node)]
        match node[0]:
            case "number":
                number = Fraction(str(node[1]))
                values.append(mp.mpf(number.numerator) / number.denominator)
            case "symbol":
                values.append(mp.mpf(point[str(node[1])]))
            case "add":
                values.append(mp.fsum(parts))
            case "mul":
                values.append(mp.fprod(parts))
            case "div":
                values.append(parts[0] / parts[1])
            case "neg":
                values.append(-parts[0])
            case "pow":
                values.append(mp.sqrt(parts[0]))
            case _:
                name = str(node[1])
                values.append(abs(parts[0]) if name == "abs" else getattr(mp, name)(*parts))
    return values
