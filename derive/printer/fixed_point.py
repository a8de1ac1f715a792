"""Graph nodes for the one positive fixed point of a map, where no closed form is to be had.

``["call", "unknown", s, w]`` is a positive number x that only a fixed point below it binds, and
``["call", "fixed_point", x, y, v]`` is the value of node v where x is the positive number at which
node y, a function of x, equals x. The map must show its kind by its shape: sums, products and
square roots of positive terms, divided by what does not hold x, its logarithmic slope x y'/y
between 0 and a bound below 1. So there is one fixed point, and nothing of the start matters to the
meaning: node s is a number near the fixed point, no farther than a factor 1 + w. That is proved
when a kernel is printed (`newton` holds the theorem), and never assumed.

``["call", "near_cbrt", i]`` is a number within 3.3 % of the cube root, made from the bits of a
floating-point number. It stands in starts only.
"""

from __future__ import annotations

from collections.abc import Callable

from gainproof.derive.printer.graph import Node, Number

WITHIN = "1/16"
"""Of a start: Newton's method then takes three steps for a slope of 1/4."""


def fixed_point(start: Node, step: Callable[[Node], Node], within: Number = WITHIN) -> Node:
    """The one positive x with x = step(x), as a node like any other.

    `step` writes the map with the operators of nodes; it is called once. Write it so that what does
    not hold x is computed outside it. `start` is any node for a number that lies between
    x/(1 + within) and x (1 + within) for every input of the kernel: PrintingError when the kernel
    is printed and this is not so, or where the start or the map may over- or underflow. Newton's
    steps are written by the printer, as many as `within` demands; a start within 1/16 takes three,
    within 1/2 four. Scale x so that no step leaves the range of float32.

    >>> from gainproof.derive.printer.graph import GraphBuilder
    >>> b = GraphBuilder()
    >>> a = b.symbol("a")
    >>> x = fixed_point(near_cbrt(2 * a), lambda x: b.sqrt(b.sqrt(2 * a * x)), within="1/25")
    >>> b.graph({"cube_root": x})["nodes"][-1]
    ['call', 'fixed_point', 5, 8, 8]

    A certificate gives the value of x as the root of the node that is the call of "unknown".
    """
    (root,) = fixed_point_values(start, lambda x: (step(x),), within)
    return root


def fixed_point_values(
    start: Node, step: Callable[[Node], tuple[Node, ...]], within: Number = WITHIN
) -> tuple[Node, ...]:
    """The fixed point x = y(x) and further values at it: `step` gives (y, v, w, ...) at x.

    So that what the last evaluation of the map computes on its way need not be computed again.
    """
    builder = start.builder
    unknown = builder.call("unknown", start, within)
    map_value, *others = step(unknown)
    return tuple(
        builder.call("fixed_point", unknown, map_value, value) for value in (map_value, *others)
    )


def near_cbrt(x: Node) -> Node:
    """A number within 3.3 % of the cube root of x, for a start."""
    return x.builder.call("near_cbrt", x)
