"""The worst error met at random points, by evaluating the kernel's graph in balls.

The graph is read anew here and evaluated by python-flint at rising precision until the ball is
narrower than 2^-80 of its size: what the kernel should have returned, apart from rounding.
"""

from __future__ import annotations

import math
from collections import ChainMap
from collections.abc import Callable, Mapping, Sequence
from fractions import Fraction
from types import MappingProxyType
from typing import Any

from flint import arb, ctx, fmpq

Graph = Mapping[str, Any]
Ball = Any  # flint.arb; python-flint ships no types
LIBRARY: Mapping[str, Callable[..., Ball]] = MappingProxyType(
    {
        "sin": arb.sin,
        "cos": arb.cos,
        "exp": arb.exp,
        "expm1": arb.expm1,
        "log1p": arb.log1p,
        "atan2": arb.atan2,
        "hypot": lambda x, y: (x * x + y * y).sqrt(),
    }
)
"""What kernels call of NumPy's functions."""


def ball_outputs(graph: Graph, point: Mapping[str, float], precision: int = 192) -> dict[str, Ball]:
    """Balls round the exact outputs of a graph at floats, one for each symbol."""
    with ctx.workprec(precision):
        values: dict[int, Ball] = {}
        nodes = graph["nodes"]
        for number, (operation, *operands) in enumerate(nodes):
            if operands[0] == "unknown":
                values[number] = _fixed_point(nodes, number, values, point, precision)
            else:
                values[number] = _value(operation, operands, values, point)
        found = {name: values[number] for name, number in graph["outputs"].items()}
        narrow = all(value.rel_accuracy_bits() > 80 or value == 0 for value in found.values())
    if narrow or precision > 4000:
        return found
    return ball_outputs(graph, point, 2 * precision)


def _fixed_point(
    nodes: Sequence[Sequence[Any]],
    unknown: int,
    values: dict[int, Ball],
    point: Mapping[str, float],
    precision: int,
) -> Ball:
    """A ball that holds the fixed point, found from 1 by Steffensen's steps: where the map
    contracts little, repeating it alone takes more steps than there are bits, at any precision. Its
    ends hold it for whatever the map's own coefficients, which are balls, may be.

    What the map makes greater lies below the only fixed point, what it makes smaller above; a ball
    without such ends holds no number.
    """
    (image,) = {node[3] for node in nodes if node[:3] == ["call", "fixed_point", unknown]}
    chain = _holding(nodes, unknown, image)

    def mapped(x: Ball) -> Ball:
        known = ChainMap({unknown: x}, values)
        for number in chain:
            operation, *operands = nodes[number]
            if number not in values:
                known[number] = _value(operation, operands, known, point)
        return known[image]

    x = arb(1)
    for _ in range(precision):
        last, x = x, _nearer(mapped, x)
        # nearer by far than the room below, which the two ends then hold against the map
        if abs(x - last) <= x * arb(2) ** (8 - precision):
            break
    # what the map is known to by what it is made of, itself perhaps a fixed point, is within it too
    room = max(arb(2) ** (20 - precision), 64 * arb((mapped(x) / x).rad()))
    low, high = x * (1 - room), x * (1 + room)
    return low.union(high) if mapped(low) > low and mapped(high) < high else arb("nan")


def _nearer(mapped: Callable[[Ball], Ball], x: Ball) -> Ball:
    """Two repetitions of a map, and from them where a line through them meets the diagonal if that
    is a positive number: a guess, as is all that is not held between two ends afterwards.
    """
    once = arb(mapped(x).mid())
    twice = arb(mapped(once).mid())
    bend = arb((twice - 2 * once + x).mid())
    if bend == 0:
        return twice
    guess = arb((x - (once - x) ** 2 / bend).mid())
    return guess if guess.is_finite() and guess > 0 else twice


def _holding(nodes: Sequence[Sequence[Any]], unknown: int, image: int) -> list[int]:
    """The nodes that lead from the unknown to its map, and what else the map needs after it."""
    wanted = {image}
    for number in range(image, unknown, -1):
        if number in wanted:
            wanted.update(entry for entry in nodes[number][1:] if isinstance(entry, int))
    return [number for number in sorted(wanted) if number > unknown]


def _value(
    operation: str, operands: Sequence[Any], values: Mapping[int, Ball], point: Mapping[str, float]
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
        if name == "near_cbrt":
            return chosen[0].root(3)
        if name in LIBRARY:
            return LIBRARY[name](*chosen)
        if name == "fixed_point":
            return chosen[2]
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


def signed_points(highest: float, count: int, generator: Any) -> list[float]:
    """As many points as `log_uniform` gives, of either sign and sizes up to 1e6, or `highest`."""
    sizes = log_uniform(1e-6, min(highest, 1e6), count, generator)
    return [float(generator.choice([-1.0, 1.0])) * size for size in sizes]


def terms(graph: Graph, point: Mapping[str, float], precision: int = 192) -> dict[str, Ball]:
    """The outputs of a graph with every term of its sums taken positive; what a sum is divided by
    is what it is, and so is a difference of two inputs, which errs by one rounding.
    """
    with ctx.workprec(precision):
        values, sizes = dict[int, Ball](), dict[int, Ball]()
        nodes = graph["nodes"]
        for number, (operation, *operands) in enumerate(nodes):
            values[number] = value = _value(operation, operands, values, point)
            exact = operation == "add" and all(_is_input(nodes, part) for part in operands)
            if operation in ("add", "mul") and not exact:
                sizes[number] = _value(operation, operands, sizes, point)
            elif operation in ("div", "neg"):
                sizes[number] = sizes[operands[0]]
                if operation == "div":
                    sizes[number] /= abs(values[operands[1]])
            else:
                sizes[number] = abs(value)
        return {name: sizes[number] for name, number in graph["outputs"].items()}


def _is_input(nodes: Sequence[Sequence[Any]], number: int) -> bool:
    """Whether a node is an input or its negative."""
    operation, *operands = nodes[number]
    return operation == "symbol" or (operation == "neg" and _is_input(nodes, operands[0]))
