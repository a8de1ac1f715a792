"""Exact real constants of a kernel: rationals, and numbers built from them by roots."""

from __future__ import annotations

import math
from collections.abc import Callable, Sequence
from dataclasses import dataclass, field
from fractions import Fraction
from typing import Any

import flint

from gainproof.derive.printer.formats import FLOAT64, Format
from gainproof.derive.printer.graph import Graph, GraphNode

GREATEST_PRECISION = 4096


@dataclass(frozen=True)
class Constant:
    """A real number: `rational` if it is known to be one, always a graph without symbols."""

    rational: Fraction | None
    nodes: tuple[tuple[str | int, ...], ...] = field(repr=False)
    number: int
    _known: dict[tuple[str, object], Any] = field(
        default_factory=dict, init=False, repr=False, compare=False
    )

    def ball(self, precision: int) -> flint.arb:
        """An enclosure whose radius shrinks as the precision in bits grows."""
        with flint.ctx.workprec(precision):
            if self.rational is not None:
                return flint.arb(flint.fmpq(self.rational.numerator, self.rational.denominator))
            return _ball(self.nodes, self.number)

    def between(self, precision: int = 256) -> tuple[Fraction, Fraction]:
        """Rational numbers below and above; equal for a rational constant."""
        if self.rational is not None:
            return self.rational, self.rational
        ends: tuple[Fraction, Fraction] = self._once(
            "between", precision, lambda: self._ends(precision)
        )
        return ends

    def _ends(self, precision: int) -> tuple[Fraction, Fraction]:
        ball = self.ball(precision)
        if not ball.is_finite():
            raise ValueError(f"the constant of node {self.number} is not a finite real number")
        with flint.ctx.workprec(precision + 64):  # the ends themselves are rounded to it
            return _fraction(ball.lower()), _fraction(ball.upper())

    def nearest(self, form: Format) -> float:
        """The nearest number of the format."""
        return self._settled("nearest", form, form.nearest)

    def at_least(self, form: Format) -> float:
        """The least number of the format that is not below the constant."""
        return self._settled("at least", form, form.at_least)

    def at_most(self, form: Format) -> float:
        """The greatest number of the format that is not above the constant."""
        return self._settled("at most", form, form.at_most)

    def is_exact(self, form: Format) -> bool:
        """Whether the format holds the constant itself."""
        return self.rational is not None and Fraction(self.nearest(form)) == self.rational

    def size(self, form: Format) -> tuple[float, float, int, float]:
        """The magnitude between two float64, the sign, and the error of `nearest` over it."""
        found: tuple[float, float, int, float] = self._once(
            "size", form.name, lambda: self._sized(form)
        )
        return found

    def _sized(self, form: Format) -> tuple[float, float, int, float]:
        low, high = self.between()
        below, above = sorted((abs(low), abs(high)))
        sign = 0 if high == 0 else 1 if low > 0 else -1
        error = Fraction(0)
        if not self.is_exact(form):
            nearest = Fraction(self.nearest(form))
            error = max(abs(nearest - low), abs(nearest - high)) / below
        return FLOAT64.at_most(below), FLOAT64.at_least(above), sign, float(error)

    def remainder(self, form: Format) -> float:
        """The part of the constant that `nearest` leaves, itself rounded to the format."""
        high = Fraction(self.nearest(form))
        return self._settled("remainder", form, lambda value: form.nearest(value - high))

    def _once(self, what: str, key: object, compute: Callable[[], Any]) -> Any:
        """A result kept, since the same few are wanted for every box and operation."""
        if (what, key) not in self._known:
            self._known[what, key] = compute()
        return self._known[what, key]

    def _settled(self, what: str, form: Format, rounded: Callable[[Fraction], float]) -> float:
        return float(self._once(what, form.name, lambda: self._decided(rounded)))

    def _decided(self, rounded: Callable[[Fraction], float]) -> float:
        """What rounds alike over a whole enclosure."""
        precision = 128
        while precision <= GREATEST_PRECISION:
            below, above = (rounded(value) for value in self.between(precision))
            if below == above:
                return below
            precision *= 2
        raise ValueError(
            f"the constant of node {self.number} cannot be told from a rounding border"
        )


def _fraction(point: flint.arb) -> Fraction:
    mantissa, exponent = point.man_exp()
    return Fraction(int(mantissa)) * Fraction(2) ** int(exponent)


def constant(value: int | Fraction | str | Graph) -> Constant:
    """The constant of a number, its text, or a graph with one output and no symbols."""
    if not isinstance(value, dict):
        return Constant(Fraction(value), (), 0)
    (number,) = value["outputs"].values()
    return constant_of_node(value["nodes"], number, exact_values(value["nodes"]))


def constant_of_node(
    nodes: Sequence[GraphNode], number: int, exact: Sequence[Fraction | None]
) -> Constant:
    """The constant of one node of a graph, whose `exact_values` are given."""
    return Constant(exact[number], tuple(tuple(node) for node in nodes[: number + 1]), number)


def exact_values(nodes: Sequence[GraphNode]) -> list[Fraction | None]:
    """The rational value of each node, None where it has none or it takes no exact steps."""
    values: list[Fraction | None] = []
    for node in nodes:
        values.append(_exact(node, values))
    return values


def _exact(node: GraphNode, values: Sequence[Fraction | None]) -> Fraction | None:
    name = node[0]
    if name == "number":
        return Fraction(str(node[1]))
    parts = [values[entry] for entry in node[1:] if isinstance(entry, int)]
    known = [part for part in parts if part is not None]
    if name == "symbol" or len(known) < len(parts):
        return None
    match name:
        case "add":
            return sum(known, Fraction(0))
        case "mul":
            return math.prod(known, start=Fraction(1))
        case "div":
            return known[0] / known[1]
        case "neg":
            return -known[0]
        case "pow" if known[0] >= 0:
            top, bottom = (math.isqrt(part) for part in known[0].as_integer_ratio())
            root = Fraction(top, bottom)
            return root if root * root == known[0] else None
        case "call" if node[1] == "abs":
            return abs(known[0])
        case "call" if node[1] == "select":
            return known[2] if known[0] < known[1] else known[3]
    return None


def _ball(nodes: Sequence[tuple[str | int, ...]], number: int) -> flint.arb:
    node = nodes[number]
    if node[0] == "number":
        value = Fraction(str(node[1]))
        return flint.arb(flint.fmpq(value.numerator, value.denominator))
    parts = [_ball(nodes, entry) for entry in node[1:] if isinstance(entry, int)]
    match node[0]:
        case "add":
            return sum(parts[1:], parts[0])
        case "mul":
            return math.prod(parts[1:], start=parts[0])
        case "div":
            return parts[0] / parts[1]
        case "neg":
            return -parts[0]
        case "pow":
            return parts[0].sqrt()
        case "call" if node[1] == "abs":
            return abs(parts[0])
        case "call" if node[1] == "pi":
            return flint.arb.pi()
    raise ValueError(f"node {number} ({node[0]}) is not a real constant")
