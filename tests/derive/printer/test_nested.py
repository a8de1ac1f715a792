"""Starts whose nearness is known by their shape: the theorem at random, and what it is not."""

from __future__ import annotations

import copy
import math
import random
from fractions import Fraction
from typing import Any

import pytest

from gainproof.derive.printer.graph import GraphBuilder, Node
from gainproof.derive.printer.nested_roots import DIVISOR, FACTOR, known_factor, nested_fixed_point
from gainproof.derive.printer.unrolled_fixed_point import unrolled


def graph(first: bool = True, second: bool = True) -> dict[str, Any]:
    """x of x^2 = a + b y, y^2 = c + e x, over the inputs; a or c may be left out."""
    b = GraphBuilder()
    free: tuple[Node | None, Node | None] = (
        b.symbol("a") if first else None,
        b.symbol("c") if second else None,
    )
    x, y = nested_fixed_point(free, (b.symbol("b"), b.symbol("e")))
    found: dict[str, Any] = dict(b.graph({"x": x, "y": y}))
    return found


def parts(data: dict[str, Any]) -> tuple[int, int, int]:
    """Numbers of the unknown, its start, and its map."""
    nodes = data["nodes"]
    unknown = next(n for n, node in enumerate(nodes) if node[:2] == ["call", "unknown"])
    bound = next(node for node in nodes if node[:2] == ["call", "fixed_point"])
    return unknown, nodes[unknown][2], bound[3]


def factor(data: dict[str, Any]) -> Fraction | None:
    """What the shape tells."""
    unknown, start, end = parts(data)
    return known_factor(data["nodes"], unknown, start, end)


@pytest.mark.parametrize("first", [True, False])
@pytest.mark.parametrize("second", [True, False])
def test_the_shape_is_read_back(first: bool, second: bool) -> None:
    data = graph(first, second)
    assert factor(data) == FACTOR
    _, (cycle,) = unrolled(data)  # type: ignore[arg-type]
    assert cycle.known == FACTOR


def test_the_theorem_at_random() -> None:
    source = random.Random(3)
    for _ in range(3000):
        a, b, c, e = (10 ** source.uniform(-12, 12) for _ in range(4))
        if source.random() < 0.2:
            a = 0.0
        if source.random() < 0.2:
            c = 0.0
        x = 1.0
        for _ in range(80):
            x = math.sqrt(a + b * math.sqrt(c + e * x))
        sizes = [math.sqrt(a), math.sqrt(b * math.sqrt(c)), (b * b * e) ** (1 / 3)]
        total = sum(sizes)
        assert max(sizes) <= x * (1 + 1e-12)
        assert x <= total * (1 + 1e-12)
        start = math.sqrt(a + b * math.sqrt(c + e * total / float(Fraction(DIVISOR))))
        assert 1 / float(FACTOR) <= x / start <= float(FACTOR)


def test_the_factor_is_what_the_theorem_gives() -> None:
    divisor = Fraction(DIVISOR)
    assert divisor < FACTOR**4
    assert 3 / divisor < FACTOR**4


@pytest.mark.parametrize("seed", range(60))
def test_another_graph_is_not_taken_for_it(seed: int) -> None:
    """One operand or number of the start or the map changed."""
    data = graph()
    nodes = data["nodes"]
    source = random.Random(seed)
    unknown, start, end = parts(data)
    while True:
        altered = copy.deepcopy(nodes)
        number = source.randrange(len(nodes))
        node = altered[number]
        if node[0] == "symbol" or node[:2] in (["call", "fixed_point"], ["call", "unknown"]):
            continue
        if node[0] == "number":
            node[1] = "5"
        else:
            place = source.choice([k for k, entry in enumerate(node) if isinstance(entry, int)])
            other = source.randrange(max(number, 1))
            if other == node[place]:
                continue
            node[place] = other
        if altered != nodes:
            break
    if nodes[number] == ["number", "1/4"]:
        return  # how near the start is said to be
    assert known_factor(altered, unknown, start, end) is None
