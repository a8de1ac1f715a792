"""Every way of writing one value that is tried, and the one with the smallest proved bound."""

from __future__ import annotations

import math
from collections.abc import Iterator, Sequence
from dataclasses import dataclass, replace
from fractions import Fraction
from itertools import product as combinations

import sympy as sp

from gainproof.derive.printer.bound import OutputBound, prove
from gainproof.derive.printer.constant import constant
from gainproof.derive.printer.formats import FLOAT64
from gainproof.derive.printer.graph import Graph
from gainproof.derive.printer.kernel import Input, Kernel, Output
from gainproof.derive.stable_form.coordinates import Coordinate, coordinates
from gainproof.derive.stable_form.emission import Order
from gainproof.derive.stable_form.products import Products, shown
from gainproof.derive.stable_form.reading import NoReading, RootOfParameter
from gainproof.derive.stable_form.rewriting import Rewriting
from gainproof.derive.stable_form.writing import SCALE, VALUE, Text, Writing

SCALED = Fraction(1, 2**60)  # keeps 1/x from overflowing for the least numbers x
LONGER = 2  # times as many nodes as the shortest candidate: not worth a proof
FIRST = 8  # candidates that are tried for fewer inputs, where none has a bound for all
SHORTEST = 3  # candidates that are tried where differences are left
RANGES = (500, 200, 100, 50)  # powers of 2 that inputs are then within
PLACES = (Fraction(0), Fraction(1, 2), Fraction(1))


@dataclass(frozen=True)
class Candidate:
    """One way of writing a value: its graph, and what is left of subtractions there.

    The graph's output is `VALUE`, and `SCALE` where a difference of computed values is left: the
    same with both sides of each added.
    """

    text: Text
    rules: tuple[str, ...]
    writing: Writing
    graph: Graph
    differences: tuple[str, ...]


@dataclass(frozen=True)
class Found:
    """The candidate that was chosen; `bound` in float64, or why there is none."""

    candidate: Candidate
    bound: OutputBound | None
    refusal: str
    tried: int


def best(expression: sp.Expr, inputs: Sequence[Input], prefix: str) -> Found:
    """The candidate with the fewest subtractions, then the widest domain, then the least bound.

    `prefix` begins the names of functions' values.

    NoReading if the expression is none of what can be read.
    """
    found: list[tuple[tuple[float, ...], Found]] = []
    refusal: NoReading | None = None
    seen: list[Graph] = []
    domains = list(coordinates(inputs))
    for domain in domains:
        for rooted, scale in combinations((False, True), (Fraction(1), SCALED)):
            try:
                marked = tuple(replace(each, rooted=rooted) for each in domain)
                candidates = list(_candidates(expression, marked, domains[-1], prefix, scale))
            except NoReading as error:
                refusal = error
                break
            shortest = min(len(candidate.graph["nodes"]) for candidate in candidates)
            for candidate in candidates:
                if candidate.graph in seen or len(candidate.graph["nodes"]) > LONGER * shortest:
                    continue
                seen.append(candidate.graph)
                # proofs of differences take long: only those of the shortest are made, at the end
                bound, reason = None, ""
                if not candidate.differences:
                    bound, reason = _bound(candidate, inputs)
                found.append((_cost(candidate, bound), Found(candidate, bound, reason, 0)))
            if found and min(each[0] for each in found)[:2] == (0, 0):
                break
        if found and min(each[0] for each in found)[:1] == (0,):
            break
    if not found:
        raise refusal or NoReading(f"no form of {expression}")
    ranked = [each for _, each in sorted(found, key=lambda each: each[0])]
    return replace(_within_range(ranked[:FIRST], inputs), tried=len(seen))


def _within_range(ranked: Sequence[Found], inputs: Sequence[Input]) -> Found:
    """The first, if it has no bound with one for fewer inputs: those far from the format's ends."""
    if ranked[0].bound is not None:
        return ranked[0]
    left = len(ranked[0].candidate.differences)
    if left:
        ranked = [_proved(each, inputs) for each in ranked[:SHORTEST]]
        ranked.sort(key=lambda each: _cost(each.candidate, each.bound))
        if ranked[0].bound is not None:
            return ranked[0]
    for exponent in RANGES:
        fewer = [_nearer(given, Fraction(2) ** exponent) for given in inputs]
        found = [
            replace(each, bound=bound)
            for each in ranked
            for bound in [_bound(each.candidate, fewer)[0]]
            if bound is not None and len(each.candidate.differences) == left
        ]
        if found:
            return min(found, key=lambda each: _cost(each.candidate, each.bound))
    return ranked[0]


def _proved(found: Found, inputs: Sequence[Input]) -> Found:
    bound, reason = _bound(found.candidate, inputs)
    return replace(found, bound=bound, refusal=reason)


def _nearer(given: Input, most: Fraction) -> Input:
    """The input, not above `most` and not below its inverse."""
    low, high = constant(given.lower).rational, None
    if given.upper is not None:
        high = constant(given.upper).rational
    found = given
    if low is not None and low < 1 / most:
        found = replace(found, lower=1 / most, lower_open=False, single=None)
    if given.upper is None or (high is not None and high > most):
        found = replace(found, upper=most, upper_open=False, single=None)
    return found


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
    expression: sp.Expr,
    domain: tuple[Coordinate, ...],
    narrow: tuple[Coordinate, ...],
    prefix: str,
    scale: Fraction,
) -> Iterator[Candidate]:
    text = _read(expression, domain, narrow, prefix)
    products = [text.reading.product(text.value), Products(text.reading.tower).whole(text.value)]
    if not products[0].constant:
        raise NoReading("the expression is 0")
    if products[0].powers == products[1].powers or shown(products[0]) > shown(products[1]):
        products.pop()
    for product, place, nested, alternating in combinations(
        products, PLACES, (True, False), (False, True)
    ):
        writing = Writing(text, product, place, scale, Order(nested, alternating))
        graph, differences = writing.graph(abstract=False)
        yield Candidate(text, product.rules, writing, graph, differences)


def _read(
    expression: sp.Expr,
    domain: tuple[Coordinate, ...],
    narrow: tuple[Coordinate, ...],
    prefix: str,
) -> Text:
    rooted = {each.name for each in domain if each.rooted}

    def marked(each: Coordinate) -> Coordinate:
        return replace(each, rooted=each.name in rooted)

    while True:
        rewriting = Rewriting(domain, narrow, prefix, marked)
        try:
            rewritten = rewriting.rewrite(expression)
            reading = rewriting.reading(rewritten)
            value = reading.read(rewritten)
            return Text(rewritten, reading, value, rewriting.atoms)
        except RootOfParameter as root:
            rooted.add(root.parameter)
