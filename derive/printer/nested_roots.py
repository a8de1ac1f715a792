"""The fixed point of x -> sqrt(a + b sqrt(c + e x)) with a start whose nearness needs no boxes.

Let a, c >= 0, b, e > 0 and X = sqrt(a + b sqrt(c + e X)). Put t1 = sqrt(a), t2 = sqrt(b sqrt(c))
and t3 = cbrt(b^2 e), what X would be if one term stood alone, and s = t1 + t2 + t3.

1. X^2 >= a, X^2 >= b sqrt(c) and X^2 >= b sqrt(e X), so that X is not below any of the t: 3 X >= s.
2. X^2 <= a + b sqrt(c) + b sqrt(e X) = t1^2 + t2^2 + t3^(3/2) X^(1/2). Were X > s, each t would be
   below X and the right side at most (t1 + t2 + t3) X = s X < X^2. So X <= s.
3. X therefore lies within a factor w of s w'/3 for any w' with w'^2 about 3. The map has a
   logarithmic slope of at most 1/4 and keeps X: its value there lies within w^(1/4) of X.

The start is the map at s/`DIVISOR`: by 3 within `FACTOR`, for all inputs. `known_factor` says so of
a graph whose nodes are made in this way, whoever made them.
"""

from __future__ import annotations

from collections.abc import Sequence
from fractions import Fraction

from gainproof.derive.printer.fixed_point import fixed_point_values, near_cbrt
from gainproof.derive.printer.graph import GraphNode, Node

DIVISOR = "71/41"
"""Near the root of 3."""
FACTOR = Fraction(1148, 1000)
"""FACTOR^4 exceeds 71/41 and 3 * 41/71."""
WITHIN = "1/4"
"""With the error of the cube root and roundings."""


def nested_fixed_point(
    free: tuple[Node | None, Node | None], slopes: tuple[Node, Node]
) -> tuple[Node, Node]:
    """x = sqrt(a + b y) and y = sqrt(c + e x); None for an a or c that is 0."""
    (a, c), (b, e) = free, slopes
    root = b.builder.sqrt
    guess = near_cbrt(b * b * e)
    if c is not None:
        guess = root(b * root(c)) + guess
    if a is not None:
        guess = root(a) + guess

    def image(x: Node) -> tuple[Node, Node]:
        inner = root(e * x if c is None else c + e * x)
        return root(b * inner if a is None else a + b * inner), inner

    x, y = fixed_point_values(image(guess / DIVISOR)[0], image, WITHIN)
    return x, y


def known_factor(nodes: Sequence[GraphNode], unknown: int, start: int, end: int) -> Fraction | None:
    """The factor within which a start lies for all inputs; None where the shape does not tell."""
    shape = _Shape(nodes)
    own, there = shape.image(end), shape.image(start)
    if own is None or there is None or own[:4] != there[:4] or own[4] != unknown:
        return None
    a, b, c, e, _ = own
    return FACTOR if shape.is_guess(there[4], (a, b, c, e)) else None


class _Shape:
    """Reads the nodes of a graph back; each equal node is there once."""

    def __init__(self, nodes: Sequence[GraphNode]) -> None:
        self.nodes = nodes

    def image(self, end: int) -> tuple[int | None, int, int | None, int, int] | None:
        """a, b, c, e, x of sqrt(a + b sqrt(c + e x))."""
        outer = self._line(end)
        inner = None if outer is None else self._line(outer[2])
        if outer is None or inner is None:
            return None
        return outer[0], outer[1], inner[0], inner[1], inner[2]

    def _line(self, number: int) -> tuple[int | None, int, int] | None:
        """a, b, y of sqrt(a + b y)."""
        under = self._root(number)
        if under is None:
            return None
        free: int | None = None
        entry = self.nodes[under]
        if entry[0] == "add" and len(entry) == 3:
            free, under = int(entry[1]), int(entry[2])
            entry = self.nodes[under]
        if entry[0] != "mul" or len(entry) != 3:
            return None
        return free, int(entry[1]), int(entry[2])

    def _root(self, number: int) -> int | None:
        entry = self.nodes[number]
        return int(entry[1]) if entry[0] == "pow" and entry[2] == "1/2" else None

    def is_guess(self, number: int, parts: tuple[int | None, int, int | None, int]) -> bool:
        """Whether a node is (t1 + (t2 + t3))/DIVISOR."""
        a, b, c, e = parts
        entry = self.nodes[number]
        if entry[0] != "div" or self.nodes[int(entry[2])] != ["number", DIVISOR]:
            return False
        rest = int(entry[1])
        if a is not None:
            split = self._split(rest)
            if split is None or self._root(split[0]) != a:
                return False
            rest = split[1]
        if c is not None:
            split = self._split(rest)
            if split is None or not self._is_second(split[0], b, c):
                return False
            rest = split[1]
        entry = self.nodes[rest]
        if entry[:2] != ["call", "near_cbrt"]:
            return False
        cube = self.nodes[int(entry[2])]
        square = self.nodes[int(cube[1])] if cube[0] == "mul" and cube[2:] == [e] else None
        return square == ["mul", b, b]

    def _split(self, number: int) -> tuple[int, int] | None:
        entry = self.nodes[number]
        return (int(entry[1]), int(entry[2])) if entry[0] == "add" and len(entry) == 3 else None

    def _is_second(self, number: int, b: int, c: int) -> bool:
        """Whether a node is sqrt(b sqrt(c))."""
        under = self._root(number)
        entry = [] if under is None else self.nodes[under]
        return len(entry) == 3 and entry[:2] == ["mul", b] and self._root(int(entry[2])) == c
