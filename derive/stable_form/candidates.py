"""Every way of writing one value that is tried, and the one with the smallest proved bound."""

from __future__ import annotations

from collections.abc import Iterator, Sequence
from dataclasses import replace
from fractions import Fraction
from itertools import product as combinations

import sympy as sp

from gainproof.derive.printer.graph import Graph
from gainproof.derive.printer.kernel import Input
from gainproof.derive.stable_form.coordinates import Coordinate, coordinates
from gainproof.derive.stable_form.function_rewriting import Rewriting
from gainproof.derive.stable_form.graph_nodes import Order
from gainproof.derive.stable_form.ranking import Candidate, Found, bounded, cost, within_range
from gainproof.derive.stable_form.root_tower import NoReading, RootOfParameter
from gainproof.derive.stable_form.signed_products import Products, shown
from gainproof.derive.stable_form.written_value import Text, Writing

SCALED = Fraction(1, 2**60)  # keeps 1/x from overflowing for the least numbers x
LONGER = 2  # times as many nodes as the shortest candidate: not worth a proof
BY_SHARES = "root of a sum of squares by the shares of what is squared"
PLACES = (Fraction(0), Fraction(1, 2), Fraction(1))


def best(expression: sp.Expr, inputs: Sequence[Input], prefix: str, budget: int) -> Found:
    """The candidate with the fewest subtractions, then the widest domain, then the least bound, of
    the first `budget` ones.

    `prefix` begins the names of functions' values.

    NoReading if the expression is none of what can be read.
    """
    found: list[tuple[tuple[float, ...], Found]] = []
    seen: list[Graph] = []
    refusal = _tried(expression, inputs, prefix, False, found, seen, budget)
    if not found:
        raise refusal or NoReading(f"no form of {expression}")
    if min(each[0] for each in found)[:2] == (0, 1):  # no subtraction, and no bound for all inputs
        _tried(expression, inputs, prefix, True, found, seen, budget)
    ranked = [each for _, each in sorted(found, key=lambda each: each[0])]
    return replace(within_range(ranked, inputs), tried=len(seen))


def _tried(
    expression: sp.Expr,
    inputs: Sequence[Input],
    prefix: str,
    shares: bool,
    found: list[tuple[tuple[float, ...], Found]],
    seen: list[Graph],
    budget: int,
) -> NoReading | None:
    """Adds what is found, with its cost, to those found before, whose graphs were `seen`, until
    these are as many as the budget.
    """
    refusal: NoReading | None = None
    domains = list(coordinates(inputs))
    for domain in domains:
        for rooted, scale in combinations((False, True), (Fraction(1), SCALED)):
            try:
                marked = tuple(replace(each, rooted=rooted) for each in domain)
                orders = _orders(shares)
                candidates = list(
                    _candidates(expression, marked, domains[-1], prefix, scale, orders)
                )
            except NoReading as error:
                refusal = error
                break
            shortest = min(len(candidate.graph["nodes"]) for candidate in candidates)
            for candidate in candidates:
                if len(seen) >= budget:
                    return refusal
                if candidate.graph in seen or len(candidate.graph["nodes"]) > LONGER * shortest:
                    continue
                seen.append(candidate.graph)
                # proofs of differences take long: only those of the shortest are made, at the end
                bound, reason = None, ""
                if not candidate.differences:
                    bound, reason = bounded(candidate, inputs)
                found.append((cost(candidate, bound), Found(candidate, bound, reason, 0)))
            subtracts = all(candidate.differences for candidate in candidates)
            if subtracts or (found and min(each[0] for each in found)[:2] == (0, 0)):
                break
        if found and min(each[0] for each in found)[:2] <= (0, 0 if shares else 1):
            break
    return refusal


def _orders(shares: bool) -> list[tuple[Fraction, Order]]:
    """The powers drawn out and the orders of operations that are tried together."""
    return [
        (place, Order(nested, alternating, shares))
        for place in (PLACES[:1] if shares else PLACES)
        for nested in (True, False)
        for alternating in (False, True)
    ]


def _candidates(
    expression: sp.Expr,
    domain: tuple[Coordinate, ...],
    narrow: tuple[Coordinate, ...],
    prefix: str,
    scale: Fraction,
    orders: Sequence[tuple[Fraction, Order]],
) -> Iterator[Candidate]:
    text = _read(expression, domain, narrow, prefix)
    products = [text.reading.product(text.value), Products(text.reading.tower).whole(text.value)]
    if not products[0].constant:
        raise NoReading("the expression is 0")
    if products[0].powers == products[1].powers or shown(products[0]) > shown(products[1]):
        products.pop()
    for product, (place, order) in combinations(products, orders):
        writing = Writing(text, product, place, scale, order)
        graph, differences = writing.graph(abstract=False)
        rules = (*product.rules, BY_SHARES) if order.shares else product.rules
        yield Candidate(text, rules, writing, graph, differences)


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
            required = tuple(rewriting.required.values())
            return Text(rewritten, reading, value, rewriting.atoms, required)
        except RootOfParameter as root:
            rooted.add(root.parameter)
