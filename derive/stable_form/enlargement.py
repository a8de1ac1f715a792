"""How much a subtraction that is left may lose: how far its scale exceeds its value on a domain.

The scale is the same with both sides of each difference added: scale/|value| times the error bound
that holds over the scale is what the value's own relative error may be. It is looked at on a grid
of points, so that what is found is a least, not a bound: a peak or a pair of zeros between two of
them is not seen. (The condition number that a kernel's docstring states is another thing: a bound,
by which factor errors of a difference's operands enter an output.)
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
class Enlargement:
    """scale/|value| reaches `least`, which it has at `place`, the largest of the points looked at;
    infinite: the value is 0 at `place`, or has another sign there than at a point before.
    """

    least: float
    place: Mapping[str, float]


def enlargement(graph: Graph, value: str, scale: str, inputs: Sequence[Input]) -> Enlargement:
    """The largest of a grid of points of the domain, a logarithmic one."""
    count = max(3, int(POINTS ** (1 / len(inputs))))
    axes = [_axis(given, count) for given in inputs]
    names = [given.name for given in inputs]
    worst = Enlargement(1.0, {})
    signs: set[bool] = set()
    with mp.workdps(DIGITS):
        for point in itertools.product(*axes):
            place = dict(zip(names, point, strict=True))
            found = _values(graph, place)
            number, size = found[graph["outputs"][value]], found[graph["outputs"][scale]]
            signs.add(number > 0)
            if number == 0 or len(signs) == 2:
                return Enlargement(math.inf, place)
            least = float(abs(size / number))
            if least > worst.least:
                worst = Enlargement(least, place)
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
