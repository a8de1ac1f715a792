"""The constants b and c of a family in kernels: rationals where they are, else square roots."""

from __future__ import annotations

from dataclasses import dataclass
from fractions import Fraction
from math import isqrt
from typing import Any

from gainproof.derive.printer.graph import GraphBuilder, Node
from gainproof.derive.three_state.spectrum import Spectrum


@dataclass(frozen=True)
class GraphConstants:
    """c = sqrt(m2) and b = sqrt(m1 + 2 c), numbers or nodes; `names` those of the square roots."""

    b: Any
    c: Any
    names: dict[str, Node]


def graph_constants(builder: GraphBuilder, spectrum: Spectrum) -> GraphConstants:
    """The constants as operands of a graph."""
    names: dict[str, Node] = {}
    c = constant_root(builder, spectrum.m2, "root_c", names)
    square = spectrum.m1 + 2 * c if isinstance(c, Fraction) else c * 2 + spectrum.m1
    return GraphConstants(constant_root(builder, square, "root_b", names), c, names)


def constant_root(builder: GraphBuilder, square: Any, name: str, names: dict[str, Node]) -> Any:
    """The root of a constant: a rational where it is one, else a node, of which `names` is told."""
    if isinstance(square, Fraction):
        top, below = isqrt(square.numerator), isqrt(square.denominator)
        if top * top == square.numerator and below * below == square.denominator:
            return Fraction(top, below)
    names[name] = builder.sqrt(square)
    return names[name]
