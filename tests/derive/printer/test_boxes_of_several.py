"""Boxes over two inputs: they cover their domain, and ranges over them hold what they must."""

from __future__ import annotations

import flint
import numpy as np
import pytest
from graph_kernels import function_of, node_balls, several_of
from hypothesis import assume, given, settings
from hypothesis import strategies as st
from samples import samples

from gainproof.derive.printer import boxes, corners
from gainproof.derive.printer.adjoint import Adjoint
from gainproof.derive.printer.box_search import ENOUGH, Frontier, Waiting
from gainproof.derive.printer.formats import FLOAT32, FLOAT64
from gainproof.derive.printer.forward import Forward
from gainproof.derive.printer.graph import GraphBuilder, Node
from gainproof.derive.printer.kernel import Kernel
from gainproof.derive.printer.program import program
from gainproof.derive.printer.proof import Proof
from gainproof.derive.printer.ratio import ratio
from gainproof.derive.printer.special_values import Behaviour
from gainproof.derive.printer.step_ranges import Grid, true_size

DOMAIN = ((2.0**-20, 3.0), (1.0, 2.0**40))


def area(grid: Grid) -> float:
    """Of all boxes, in the logarithms of the inputs."""
    return float(np.prod(np.log2(grid.high / grid.low), axis=0).sum())


def test_boxes_cover_the_domain_once() -> None:
    grid = boxes.cover(DOMAIN, [(), ()], [(), ()])
    whole = (np.log2(3) + 20) * 40
    assert area(grid) == pytest.approx(whole)
    assert (grid.low.min(axis=1), grid.high.max(axis=1)) == (
        pytest.approx([2.0**-20, 1]),
        pytest.approx([3, 2.0**40]),
    )
    for _ in range(4):
        grid = boxes.halves(grid, FLOAT64)
        assert area(grid) == pytest.approx(whole)
    assert np.all(grid.high / grid.low - 1 <= grid.width)


def test_halves_bisect_the_wider_side_down_to_single_points() -> None:
    one, two = 1.0, FLOAT64.after(1.0)
    grid = boxes.grid(np.array([[1.0], [one]]), np.array([[64.0], [two]]))
    first = boxes.halves(grid, FLOAT64)
    assert first.high.tolist() == [[8.0, 64.0], [two, two]]
    thin = boxes.halves(boxes.grid(np.array([[4.0], [one]]), np.array([[4.0], [two]])), FLOAT64)
    assert thin.low.tolist() == thin.high.tolist() == [[4.0, 4.0], [one, two]]


def test_gaps_lie_along_their_own_input() -> None:
    b = GraphBuilder()
    x, z = b.symbol("x"), b.symbol("z")
    graph = b.graph({"y": b.select(z, 5, x, 2 * x) * b.absolute(3 - x)})
    near = boxes.special_points(program(graph), FLOAT64)
    below = FLOAT64.before
    assert [len(gaps) for gaps in near] == [2, 1]
    grid = boxes.cover(((1.0, 8.0), (1.0, 8.0)), near, [(), ()])
    assert not np.any((grid.low[1] < 5) & (grid.high[1] >= 5))
    assert not np.any((grid.low[0] < 3) & (grid.high[0] > below(3.0)))
    assert np.any((grid.low[0] == 3) & (grid.high[0] == 3))


@st.composite
def kernels(draw: st.DrawFn) -> Kernel:
    b = GraphBuilder()
    x, z = b.symbol("x"), b.symbol("z")
    nodes: list[Node] = [x, z, 3 + x, b.absolute(5 - z), b.number("1/3")]
    for _ in range(draw(st.integers(3, 10))):
        first, second = (nodes[draw(st.integers(0, len(nodes) - 1))] for _ in range(2))
        made = [first + second, first * second, first / second, b.sqrt(first)]
        nodes.append(made[draw(st.integers(0, 3))])
    return several_of(b.graph({"y": nodes[-1], "w": nodes[-2]}), "1/64", "4")


def at_points(kernel: Kernel, grid: Grid, parts: list[list[float]]) -> list[list[flint.arb]]:
    """Values of the program's steps at points of one box, given as parts of its sides."""
    steps = program(kernel.graph)
    found = []
    for part in parts:
        point = {
            name: float(np.clip(low * (high / low) ** share, low, high))
            for name, low, high, share in zip(
                steps.inputs, grid.low[:, 0], grid.high[:, 0], part, strict=True
            )
        }
        values = node_balls(kernel.graph, point)
        found.append([abs(values[step.node]) for step in steps.steps])
    return found


SHARE = st.floats(0, 1)


@given(kernels(), st.lists(st.tuples(SHARE, SHARE), min_size=4, max_size=4), st.floats(0, 8))
@settings(max_examples=samples(24), deadline=None)
def test_ranges_ratios_and_slopes_hold(
    kernel: Kernel, shares: list[tuple[float, float]], size: float
) -> None:
    low = np.array([[2.0 ** (-6 + 6 * shares[0][0])], [2.0 ** (-6 + 6 * shares[0][1])]])
    used = program(kernel.graph)
    assume(len(used.inputs) == 2)
    grid = boxes.grid(low, np.minimum(low * 2.0 ** (size / 4), 4.0))
    points = at_points(kernel, grid, [list(each) for each in shares] + [[0, 0], [1, 1], [0, 1]])
    with np.errstate(all="ignore"):
        values = Forward(used, grid, FLOAT32).values
        for number, value in enumerate(values):
            known = value.invalid is None and used.steps[number].operation != "constant"
            for exact in [point[number] for point in points] if known else ():
                least, most = (float(end[0][0]) for end in true_size(value))
                assert exact.upper() >= least
                assert exact.lower() <= most
            for other in range(number if known else 0):
                if values[other].invalid is None:
                    least, most = (float(end[0]) for end in ratio(value, values[other], grid.width))
                    for point in points:
                        quotient = point[number] / point[other]
                        assert not quotient < least
                        assert not quotient > most


@given(st.tuples(SHARE, SHARE), st.floats(0, 8))
@settings(max_examples=samples(8), deadline=None)
def test_computed_values_lie_in_their_ranges(shares: tuple[float, float], size: float) -> None:
    b = GraphBuilder()
    x, z = b.symbol("x"), b.symbol("z")
    graph = b.graph({"y": b.sqrt(x) / (x + z * 3), "w": b.absolute(5 - z) * x})
    steps, function = program(graph), function_of(several_of(graph, "1/64", "4"))
    grid = boxes.grid(np.full((2, 1), 1.0), np.full((2, 1), 1.0 + size / 3))
    with np.errstate(all="ignore"):
        behaviour = Behaviour(Forward(steps, grid, FLOAT64))
    point = [1.0 + size / 3 * share for share in shares]
    for name, value in zip("yw", function(*point), strict=True):
        number = steps.outputs[name]
        assert behaviour.low[number][0] <= value <= behaviour.high[number][0]
        assert not behaviour.lost[number][0]


def test_rows_and_extremes_agree_on_corners() -> None:
    """f = x/z over 1..2 by 1..4: rises with x, falls with z."""
    ends = {1: (np.array([1.0]), np.array([2.0])), 0: (np.array([1.0]), np.array([4.0]))}
    x = corners.rows(ends[1][0], *ends[1], 0, 2)
    z = corners.rows(ends[0][0], *ends[0], 1, 2)
    assert x[1:, 0].tolist() == [1, 1, 2, 2]
    assert z[1:, 0].tolist() == [1, 4, 1, 4]
    size = x / z
    size[0] = 0.0
    slope = np.array([[1.0], [-1.0]])
    low, high = corners.extremes((size, np.where(size == 0, 9.0, size)), (slope, slope))
    assert (low.tolist(), high.tolist()) == ([0.25], [2.0])
    # a slope without a sign: what the width allows, or the range of the box
    vague = np.array([[1.0], [-1.0]]), np.array([[1.0], [1.0]])
    assert corners.extremes((size, size), vague)[0].tolist() == [0.0]
    low, _ = corners.extremes((size, size), vague, np.array([[1.0], [3.0]]))
    assert 0.24 < low[0] <= 0.25


def test_waiting_boxes_count_with_their_own_bounds() -> None:
    """With one box bisected and three waiting, the result is the largest of all."""
    kernel = several_of(GraphBuilderOfSum().graph, "1/64", "4")
    proof = Proof(kernel, FLOAT64, ((1 / 64, 4.0), (1 / 64, 4.0)))
    frontier = Frontier(1, 0, FLOAT64, 100.0, 1_000)
    grid = boxes.grid(np.full((2, 4), 1.0), np.full((2, 4), 2.0))
    upper = np.array([[3.0, 9.0, 5.0, 7.0]])
    frontier.add(Waiting(grid, upper, np.zeros((0, 4))), upper / 9)
    following = frontier.finer()
    assert following is not None
    count = following.count
    assert count == ENOUGH
    assert frontier.settled.tolist() == [0.0]
    with np.errstate(all="ignore"):
        assert isinstance(proof.adjoint(following), Adjoint)
    ones = np.ones((1, count))
    frontier.add(Waiting(following, ones, np.zeros((0, count))), ones)
    assert frontier.finer() is None
    assert frontier.settled.tolist() == [1.0]


def test_few_boxes_are_bisected_further_within_the_budget_only() -> None:
    """Quarters are always made; more of them while the budget has room for twice as many."""
    for budget, count in ((20, 16), (36, 32), (67, 32), (68, 64)):
        frontier = Frontier(1, 0, FLOAT64, 100.0, budget)
        grid = boxes.grid(np.full((2, 4), 1.0), np.full((2, 4), 2.0))
        upper = np.array([[3.0, 9.0, 5.0, 7.0]])
        frontier.add(Waiting(grid, upper, np.zeros((0, 4))), upper / 9)
        following = frontier.finer()
        assert following is not None
        assert following.count == count


class GraphBuilderOfSum:
    """The graph x + z."""

    def __init__(self) -> None:
        b = GraphBuilder()
        self.graph = b.graph({"y": b.symbol("x") + b.symbol("z")})
