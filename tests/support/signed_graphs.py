"""Graphs with inputs of either sign and calls of a library, evaluated in balls by other code."""

from __future__ import annotations

from collections.abc import Mapping
from fractions import Fraction
from typing import Any

import flint

BITS = 400


def with_terms(graph: Any, point: Mapping[str, float]) -> dict[str, tuple[flint.arb, flint.arb]]:
    """Of each output its value, and the sum of its terms taken positive: every sum in the graph is
    taken over the magnitudes of its terms.
    """
    with flint.ctx.workprec(BITS):
        values: list[tuple[flint.arb, flint.arb]] = []
        for node in graph["nodes"]:
            values.append(_both(node, values, point))
    return {name: values[number] for name, number in graph["outputs"].items()}


def _both(
    node: Any, values: list[tuple[flint.arb, flint.arb]], point: Mapping[str, float]
) -> tuple[flint.arb, flint.arb]:
    """The value of a node and its sum of terms."""
    parts = [values[part] for part in node[1:] if isinstance(part, int)]
    match node[0]:
        case "symbol":
            value = flint.arb(point[str(node[1])])
        case "number":
            number = Fraction(str(node[1]))
            value = flint.arb(flint.fmpq(number.numerator, number.denominator))
        case "add":
            return sum((v for v, _ in parts), flint.arb(0)), sum(
                (s for _, s in parts), flint.arb(0)
            )
        case "mul":
            (v, s), (w, t) = parts
            return v * w, s * t
        case "div":
            (v, s), (w, _) = parts
            return v / w, s / abs(w)
        case "neg":
            return -parts[0][0], parts[0][1]
        case "pow":
            value = parts[0][0].sqrt()
        case "call":
            value = _called(str(node[1]), [part for part, _ in parts])
        case other:
            raise AssertionError(other)
    return value, abs(value)


def _called(name: str, parts: list[flint.arb]) -> flint.arb:
    """A function of a library; angles as arguments of complex numbers."""
    first, last = parts[0], parts[-1]
    match name:
        case "sin":
            return first.sin()
        case "cos":
            return first.cos()
        case "exp":
            return first.exp()
        case "expm1":
            return first.expm1()
        case "log1p":
            return first.log1p()
        case "atan2":
            # the origin has no angle, and in the south the sign of a zero decides
            return flint.arb("nan") if first == 0 and last <= 0 else flint.acb(last, first).arg()
        case "hypot":
            return abs(flint.acb(first, last))
    raise AssertionError(name)
