"""Every way of writing one value that is tried, and the one with the smallest proved bound."""

from __future__ import annotations

import math
from collections.abc import Iterator, Sequence
from dataclasses import dataclass, replace
from fractions import Fraction
from itertools import product as combinations

import sympy as sp

from gainproof.derive.printer.bound import OutputBound, prove
from gainproof.derive.printer.formats import FLOAT64
from gainproof.derive.printer.graph import Graph, GraphBuilder
from gainproof.derive.printer.kernel import Input, Kernel, Output
from gainproof.derive.stable_form.coordinates import Coordinate, coordinates
from gainproof.derive.stable_form.emission import Emission, Order
from gainproof.derive.stable_form.letters import Letters
from gainproof.derive.stable_form.products import Products, shown
from gainproof.derive.stable_form.reading import NoReading, Reading, RootOfParameter

VALUE, SCALE = "value", "scale"
SCALED = Fraction(1, 2**60)  # keeps 1/x from overflowing for the least numbers x
PLACES = (Fraction(0), Fraction(1, 2), Fraction(1))


@dataclass(frozen=True)
class Candidate:
    """One way of writing a value: its graph, and what is left of subtractions there.

    The graph's output is `VALUE`, and `SCALE` where a difference of computed values is left: the
    same with both sides of each added.
    """

    reading: Reading
    value: sp.Expr
    rules: tuple[str, ...]
    graph: Graph
    differences: tuple[str, ...]


@dataclass(frozen=True)
class Found:
    """The candidate that was chosen; `bound` in float64, or why there is none."""

    candidate: Candidate
    bound: OutputBound | None
    refusal: str
    tried: int


def best(expression: sp.Expr, inputs: Sequence[Input]) -> Found:
    """The candidate with the fewest subtractions, then the widest domain, then the least bound.

    NoReading if the expression is none of what can be read.
    """
    found: list[tuple[tuple[float, ...], Found]] = []
    refusal: NoReading | None = None
    seen: list[Graph] = []
    for domain in coordinates(inputs):
        for rooted, scale in combinations((False, True), (Fraction(1), SCALED)):
            try:
                candidates = list(_candidates(expression, domain, rooted, scale))
            except NoReading as error:
                refusal = error
                break
            for candidate in candidates:
                if candidate.graph in seen:
                    continue
                seen.append(candidate.graph)
                bound, reason = _bound(candidate, inputs)
                found.append((_cost(candidate, bound), Found(candidate, bound, reason, 0)))
            if found and min(each[0] for each in found)[:2] == (0, 0):
                break
        if found and min(each[0] for each in found)[:1] == (0,):
            break
    if not found:
        raise refusal or NoReading(f"no form of {expression}")
    return replace(min(found, key=lambda each: each[0])[1], tried=len(seen))


def _cost(candidate: Candidate, bound: OutputBound | None) -> tuple[float, ...]:
    if bound is None:
        return (len(candidate.differences), 1, 0.0, len(candidate.graph["nodes"]))
    width = sum(math.log(high) - math.log(max(low, 2.0**-1074)) for low, high in bound.domain)
    return (len(candidate.differences), 0, -round(width), float(bound.bound))


def _bound(candidate: Candidate, inputs: Sequence[Input]) -> tuple[OutputBound | None, str]:
    try:
        return prove(kernel(candidate.graph, candidate.differences, inputs), FLOAT64).outputs[0], ""
    except (ValueError, NotImplementedError) as error:
        return None, str(error)


def kernel(graph: Graph, differences: Sequence[str], inputs: Sequence[Input]) -> Kernel:
    """A kernel of one candidate's graph, for its bound."""
    scale = SCALE if SCALE in graph["outputs"] else None
    output = Output(VALUE, "the value", relative_to=scale)
    named = dict.fromkeys(differences, "no form without it was found")
    words = ("stable_form", "StableForm", "A stable form.", ())
    return Kernel(*words, tuple(inputs), (output,), graph, "an expression", named)


def _candidates(
    expression: sp.Expr, domain: tuple[Coordinate, ...], rooted: bool, scale: Fraction
) -> Iterator[Candidate]:
    reading, value = _read(expression, tuple(replace(each, rooted=rooted) for each in domain))
    products = [reading.product(value), Products(reading.tower).whole(value)]
    if not products[0].constant:
        raise NoReading("the expression is 0")
    if products[0].powers == products[1].powers or shown(products[0]) > shown(products[1]):
        products.pop()
    for product, place, nested, alternating in combinations(
        products, PLACES, (True, False), (False, True)
    ):
        builder, letters, order = (
            GraphBuilder(),
            Letters(reading, place, scale),
            Order(nested, alternating),
        )
        emission = Emission(builder, letters, builder.symbol, order)
        outputs = {VALUE: emission.product(product)}
        if emission.differences:
            added = Emission(builder, letters, builder.symbol, order, added=True)
            outputs[SCALE] = builder.absolute(added.product(product))
        graph = builder.graph(outputs, emission.differences)
        yield Candidate(reading, value, product.rules, graph, tuple(emission.differences))


def _read(expression: sp.Expr, domain: tuple[Coordinate, ...]) -> tuple[Reading, sp.Expr]:
    while True:
        reading = Reading(domain)
        try:
            return reading, reading.read(expression)
        except RootOfParameter as root:
            domain = tuple(
                replace(each, rooted=True) if each.name == root.parameter else each
                for each in domain
            )
