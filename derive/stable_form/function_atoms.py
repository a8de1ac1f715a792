"""Functions of a library as positive numbers of their own, and the rules that put them there.

An atom is a number between 0 and its `high`; sums of it and 1 that a function gives without
subtraction are its `LINES`, and of the squares among them the roots are its `ROOTS`:

    decay        e = 1 - exp(-u)      exp(k u) = (1 - e)^-k          u > 0
    growth       g = exp(u) - 1       exp(k u) = (1 + g)^k           0 < u < 700
    half_angle   q = sin(u/2)^2       cos u = 1 - 2 q, sin u = 2 sqrt(q (1 - q))     0 < u <= 3
    logarithm    l = log(1 + u)       log(r) = log(1 + (r - 1)), -log(1/r)           u > 0
    arctangent   a = arctan(u)        arctan x - arctan y = arctan((x - y)/(1 + x y))  u > 0

The first four are definitions and double angles; the last is the tangent of a difference, of
angles between 0 and pi/2 (Abramowitz and Stegun, 4.3.17 and 4.4.34).
"""

from __future__ import annotations

from collections.abc import Callable, Iterator, Mapping
from dataclasses import dataclass
from fractions import Fraction

import sympy as sp

from gainproof.derive.printer.graph import Graph, GraphBuilder, Node
from gainproof.derive.stable_form.coordinates import Coordinate
from gainproof.derive.stable_form.polynomial_products import Product
from gainproof.derive.stable_form.root_tower import Reading

Line = tuple[int | Fraction, int | Fraction]
"""Constant and slope: (1, -1) is 1 - e."""

Call = Callable[[GraphBuilder, Node], Node]

ARGUMENT = "argument"
"""The symbol of an atom's argument in `patterns`."""

RULES: Mapping[str, str] = {
    "decay": "exp(u) = 1/(1 - e) with e = -expm1(-u)",
    "growth": "exp(u) = 1 + expm1(u)",
    "half_angle": "cos u = 1 - 2 sin(u/2)^2, sin u = 2 sin(u/2) cos(u/2)",
    "logarithm": "log r = log1p(r - 1) for r > 1, -log1p(1/r - 1) for r < 1",
    "arctangent": "arctan x - arctan y = arctan2(x - y, 1 + x y) for x > y >= 0",
}
"""What is used of each kind of atom, as it is reported."""


def _sine(b: GraphBuilder, u: Node) -> Node:
    return b.call("sin", u / 2)


def _cosine(b: GraphBuilder, u: Node) -> Node:
    return b.call("cos", u / 2)


LINES: Mapping[str, Mapping[Line, Call]] = {
    "growth": {
        (0, 1): lambda b, u: b.call("expm1", u),
        (1, 1): lambda b, u: b.call("exp", u),
    },
    "decay": {
        (0, 1): lambda b, u: -b.call("expm1", -u),
        (1, -1): lambda b, u: b.call("exp", -u),
    },
    "half_angle": {
        (0, 1): lambda b, u: _sine(b, u) * _sine(b, u),
        (1, -1): lambda b, u: _cosine(b, u) * _cosine(b, u),
        (1, -2): lambda b, u: b.call("cos", u),
    },
    "logarithm": {(0, 1): lambda b, u: b.call("log1p", u)},
    "arctangent": {(0, 1): lambda b, u: b.call("atan2", u, b.number(1))},
}

ROOTS: Mapping[str, Mapping[Line, Call]] = {"half_angle": {(0, 1): _sine, (1, -1): _cosine}}

HIGH: Mapping[str, Fraction | None] = {
    "decay": Fraction(1),
    "growth": None,
    "half_angle": Fraction(1),
    "logarithm": None,
    "arctangent": None,
}


@dataclass(frozen=True)
class Atom:
    """One number; its argument, `value` as it came, is a positive product over `reading`."""

    name: str
    kind: str
    value: sp.Expr
    reading: Reading
    argument: Product

    @property
    def coordinate(self) -> Coordinate:
        """The atom as what a reading holds beside inputs."""
        return Coordinate(self.name, Fraction(0), HIGH[self.kind])


class Sources:
    """Nodes of inputs and atoms in one builder.

    `argument` writes that of an atom. With `abstract` atoms are symbols and their lines arithmetic,
    which is what a certificate is about.
    """

    def __init__(
        self,
        builder: GraphBuilder,
        atoms: Mapping[str, Atom],
        argument: Callable[[Atom], Node],
        abstract: bool,
    ) -> None:
        self.builder, self.atoms = builder, atoms
        self.argument, self.abstract = argument, abstract

    def line(self, name: str, constant: Fraction, slope: Fraction) -> Node | None:
        """A multiple of a line of an atom, without the multiple; None if it is no line of it."""
        return self._called(LINES, name, constant, slope)

    def root(self, name: str, constant: Fraction, slope: Fraction) -> Node | None:
        """The root of a line, where a function gives it."""
        return self._called(ROOTS, name, constant, slope)

    def _called(
        self,
        calls: Mapping[str, Mapping[Line, Call]],
        name: str,
        constant: Fraction,
        slope: Fraction,
    ) -> Node | None:
        atom = self.atoms[name]
        call = calls.get(atom.kind, {}).get((constant, slope))
        if call is None:
            return None
        if not self.abstract:
            return call(self.builder, self.argument(atom))
        line = _line(self.builder, name, (constant, slope))
        return self.builder.sqrt(line) if calls is ROOTS else line


def patterns(name: str, kind: str) -> Iterator[tuple[Graph, Graph]]:
    """Of an atom its lines and roots: over its symbol, and as functions of `ARGUMENT`."""
    for calls in (ROOTS, LINES):
        for (constant, slope), call in calls.get(kind, {}).items():
            abstract, printed = GraphBuilder(), GraphBuilder()
            line = _line(abstract, name, (Fraction(constant), Fraction(slope)))
            end = abstract.sqrt(line) if calls is ROOTS else line
            value = call(printed, printed.symbol(ARGUMENT))
            yield abstract.graph({name: end}), printed.graph({name: value})


def _line(builder: GraphBuilder, name: str, line: tuple[Fraction, Fraction]) -> Node:
    (constant, slope), symbol = line, builder.symbol(name)
    return constant + slope * symbol if constant else symbol
