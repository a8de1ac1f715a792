"""Fixed points in programs: what is accepted, and each way to be wrong seen failing.

The toy is the filter gain for acceleration increments with three states: X = 2 + x is the fixed
point of sqrt(2 + 2 sqrt(1 + 2 D X)) for D = X (X^2 - 4)/8, and alpha = 2 (Y + 1)/(1 + X + Y + D).
"""

from __future__ import annotations

from collections.abc import Mapping, Sequence
from copy import deepcopy
from typing import Any

import pytest
import sympy as sp
from tests.verify.certificate.toy_changes import changed, reason, refused, statement
from tests.verify.certificate.toy_writer import expectations, fraction, graph

from gainproof.verify.certificate import check
from gainproof.verify.certificate.alteration_campaign import Campaign

Data = dict[str, Any]

x = sp.Symbol("x")
X = 2 + x
Y = (X**2 - 2) / 2
D = X * (X**2 - 4) / 8
ALPHA = sp.cancel(2 * (Y + 1) / (1 + X + Y + D))

NODES: list[list[Any]] = [
    ["symbol", "d"],
    ["number", "2"],
    ["number", "1"],
    ["call", "unknown", 0, 1],
    ["mul", 1, 0, 3],
    ["add", 2, 4],
    ["pow", 5, "1/2"],
    ["mul", 1, 6],
    ["add", 1, 7],
    ["pow", 8, "1/2"],
    ["call", "fixed_point", 3, 9, 9],
    ["call", "fixed_point", 3, 9, 6],
    ["add", 2, 11],
    ["mul", 1, 12],
    ["add", 2, 10, 11, 0],
    ["div", 13, 14],
]
UNKNOWN, INNER, MAP = 3, 6, 9


def positive(value: sp.Expr) -> Data:
    """A fraction in x."""
    above, below = sp.fraction(sp.cancel(value))
    return fraction(above, below, [x])


@pytest.fixture
def toy() -> Data:
    """The certificate."""
    kernel = {
        "id": "kernel",
        "kind": "program",
        "tower": "main",
        "claim": {"program": "gain", "outputs": {"alpha": graph(sp.Symbol("alpha"))}},
        "evidence": {
            "roots": {
                str(UNKNOWN): positive(X),
                str(INNER): positive(Y),
                str(MAP): positive(X),
            },
            "branches": {},
            "gaps": {},
            "nonzero": [],
        },
    }
    return deepcopy(
        {
            "format": "gainproof certificate 1",
            "subject": "one fixed point",
            "programs": {
                "gain": {
                    "inputs": {"d": "ratio"},
                    "graph": {"nodes": NODES, "outputs": {"alpha": 15}},
                }
            },
            "towers": {
                "main": {
                    "parameters": [{"symbol": "x", "above": "0"}],
                    "generators": [],
                    "elements": {"ratio": positive(D), "alpha": positive(ALPHA)},
                }
            },
            "statements": [kernel],
        }
    )


def program_reason(
    toy: Data, nodes: Sequence[Any], end: int, roots: Mapping[int, Any], value: Any
) -> str:
    """Why a program of these nodes, with one output and these roots, is rejected."""
    graph_ = {"nodes": nodes, "outputs": {"alpha": end}}
    symbols = {node[1] for node in nodes if node[0] == "symbol"}
    toy["programs"]["gain"] = {"inputs": dict.fromkeys(symbols, "ratio"), "graph": graph_}
    kernel = statement(toy, "kernel")
    kernel["evidence"]["roots"] = {str(n): positive(sp.sympify(v)) for n, v in roots.items()}
    kernel["claim"]["outputs"]["alpha"] = graph(value)
    return reason(toy, "kernel")


def test_accepted(toy: Data) -> None:
    assert refused(toy) == ""


@pytest.mark.parametrize(
    ("field", "new", "why"),
    [
        ("roots", {3: 2 * X, 6: Y, 9: X}, "not a root"),
        ("roots", {3: -X, 6: Y, 9: X}, "not manifestly positive"),
        ("roots", {3: x, 6: Y, 9: X}, "not a root"),
        ("roots", {3: sp.Integer(0), 6: sp.Integer(1), 9: sp.Integer(2)}, "manifestly positive"),
        ("roots", {6: Y, 9: X}, "no root"),
        ("roots", {3: X, 6: Y}, "no root"),
        ("roots", {3: X, 6: Y, 9: X, 10: X}, "not used"),
        ("branches", {"3": "then"}, "no branches"),
        ("branches", {"10": "positive"}, "no branches"),
        ("gaps", {"3": positive(X)}, "not used"),
    ],
)
def test_evidence(toy: Data, field: str, new: Any, why: str) -> None:
    if field == "roots":
        new = {str(number): positive(value) for number, value in new.items()}
    assert why in changed(toy, "kernel", f"evidence.{field}", new)


def test_another_claim(toy: Data) -> None:
    wanted = graph(sp.Symbol("alpha") * 2)
    assert "does not equal" in changed(toy, "kernel", "claim.outputs.alpha", wanted)


def test_a_number_that_is_no_fixed_point(toy: Data) -> None:
    """All square roots are right, at x = 2, where sqrt(3 + 3 x) is 3."""
    nodes = [["number", "3"], ["call", "unknown", 0, 0], ["mul", 0, 1], ["add", 0, 2],
             ["pow", 3, "1/2"], ["call", "fixed_point", 1, 4, 4]]  # fmt: skip
    assert "not a fixed point" in program_reason(toy, nodes, 5, {1: 2, 4: 3}, 3)


def test_one_of_two_fixed_points(toy: Data) -> None:
    """x = (x^2 + 2)/3 holds at 1 and at 2: neither is the one."""
    nodes = [["number", "3"], ["number", "2"], ["call", "unknown", 0, 0], ["mul", 2, 2],
             ["add", 1, 3], ["div", 4, 0], ["call", "fixed_point", 2, 5, 2]]  # fmt: skip
    for point in (1, 2):
        assert "at most 2" in program_reason(toy, nodes, 6, {2: point}, point)


def test_every_number_is_a_fixed_point(toy: Data) -> None:
    """x = sqrt(x^2): a slope of exactly 1."""
    nodes = [["number", "3"], ["call", "unknown", 0, 0], ["mul", 1, 1], ["pow", 2, "1/2"],
             ["call", "fixed_point", 1, 3, 3]]  # fmt: skip
    assert "at most 1" in program_reason(toy, nodes, 4, {1: X, 3: X}, X)


def test_a_negative_fixed_point(toy: Data) -> None:
    """x = -x^(1/2) - 2 has none that is positive; x = 6 - x^(1/2) one, but is no such map."""
    nodes = [["number", "6"], ["call", "unknown", 0, 0], ["pow", 1, "1/2"], ["neg", 2],
             ["add", 0, 3], ["call", "fixed_point", 1, 4, 4]]  # fmt: skip
    assert "sums, products" in program_reason(toy, nodes, 5, {1: 4, 2: 2}, 4)
    nodes[1] = ["call", "unknown", 0, 0]
    assert "not manifestly positive" in program_reason(toy, nodes, 5, {1: -4, 2: 2}, -4)


def test_a_term_that_may_be_negative(toy: Data) -> None:
    """x = sqrt(c + 2 x) with c = -3/4 holds at 1/2 and at 3/2, though its slope seems to be 1/2."""
    nodes = [["number", "-3/4"], ["number", "2"], ["call", "unknown", 1, 1], ["mul", 1, 2],
             ["add", 0, 3], ["pow", 4, "1/2"], ["call", "fixed_point", 2, 5, 5]]  # fmt: skip
    for point in (sp.Rational(1, 2), sp.Rational(3, 2)):
        roots = {2: point, 5: point}
        assert "node 0 of the map is not" in program_reason(toy, nodes, 6, roots, point)
    nodes[0] = ["number", "3"]
    assert program_reason(toy, nodes, 6, {2: 3, 5: 3}, 3) == ""


def test_decreasing_maps_and_other_powers(toy: Data) -> None:
    """x = 8/x^2 has a slope of -2: one fixed point all the same. x = (4 x^2)^(1/3): 2/3."""
    nodes: list[list[Any]] = [["number", "8"], ["call", "unknown", 0, 0], ["mul", 1, 1],
                              ["div", 0, 2], ["call", "fixed_point", 1, 3, 3]]  # fmt: skip
    assert program_reason(toy, nodes, 4, {1: 2}, 2) == ""
    nodes[0], nodes[3] = ["number", "4"], ["mul", 0, 2]
    nodes[4:] = [["pow", 3, "1/3"], ["call", "fixed_point", 1, 4, 4]]
    assert program_reason(toy, nodes, 5, {1: 4, 4: 4}, 4) == ""
    nodes[4] = ["pow", 3, "-1/3"]
    assert "not a fixed point" in program_reason(toy, nodes, 5, {1: 4, 4: 4}, 4)


def test_a_map_without_its_unknown(toy: Data) -> None:
    nodes = [["number", "3"], ["call", "unknown", 0, 0], ["mul", 0, 0], ["add", 1, 2],
             ["call", "fixed_point", 1, 2, 3]]  # fmt: skip
    assert "does not hold" in program_reason(toy, nodes, 4, {1: 9}, 18)


def test_a_choice_inside_the_map(toy: Data) -> None:
    """abs of what holds the unknown has no slope here, select neither."""
    nodes = [["number", "3"], ["call", "unknown", 0, 0], ["call", "abs", 1], ["pow", 2, "1/2"],
             ["mul", 0, 3], ["call", "fixed_point", 1, 4, 4]]  # fmt: skip
    evidence = statement(toy, "kernel")["evidence"]
    evidence["branches"], evidence["gaps"] = {"2": "positive"}, {"2": positive(sp.Integer(9))}
    assert "sums, products" in program_reason(toy, nodes, 5, {1: 9, 3: 3}, 9)


@pytest.mark.parametrize(
    ("node", "new", "why"),
    [
        (10, ["call", "fixed_point", 4, 9, 9], "not an unknown"),
        (10, ["call", "fixed_point", 3, 8, 9], "two maps"),
        (14, ["add", 2, 10, 3, 11, 0], "output 'alpha' holds an unknown"),
        (14, ["add", 2, 10, 9, 11, 0], "output 'alpha' holds an unknown"),
        (0, ["call", "near_cbrt", 1], ""),
        (3, ["call", "unknown", 0], "arguments"),
        (10, ["call", "fixed_point", 3, 9], "arguments"),
    ],
)
def test_unknowns_are_bound(toy: Data, node: int, new: list[Any], why: str) -> None:
    nodes = toy["programs"]["gain"]["graph"]["nodes"]
    nodes[node] = new
    if node == 0:
        nodes[0], nodes[1] = ["number", "2"], ["call", "near_cbrt", 0]
        toy["programs"]["gain"]["inputs"] = {}
        assert "stands only where an unknown starts" in reason(toy, "kernel")
    else:
        assert why in refused(toy)


def test_a_fixed_point_inside_another(toy: Data) -> None:
    """Its map may not hold the other's unknown; a bound one it may."""
    nodes: list[list[Any]] = [
        ["number", "4"],
        ["call", "unknown", 0, 0],
        ["number", "2"],
        ["call", "unknown", 0, 2],
        ["mul", 0, 3],
        ["pow", 4, "1/2"],
        ["call", "fixed_point", 3, 5, 5],
        ["mul", 1, 6],
        ["pow", 7, "1/2"],
        ["call", "fixed_point", 1, 8, 8],
    ]
    roots = {1: 4, 3: 4, 5: 4, 8: 4}
    assert program_reason(toy, nodes, 9, roots, 4) == ""
    nodes[4] = ["mul", 1, 3]
    assert "holds another unknown" in program_reason_whole(toy, nodes, 9, roots, 4)


def program_reason_whole(toy: Data, *given: Any) -> str:
    """The same, of a certificate that is not even well formed."""
    program_reason(toy, *given)
    return refused(toy)


def test_the_start_is_not_evaluated(toy: Data) -> None:
    """It may be anything: the root of a negative number, or the number near a cube root."""
    nodes = toy["programs"]["gain"]["graph"]["nodes"]
    toy["programs"]["gain"]["graph"] = {
        "nodes": [
            ["number", "-1"],
            ["pow", 0, "1/2"],
            ["call", "near_cbrt", 1],
            *(_moved(node, 3) for node in nodes),
        ],
        "outputs": {"alpha": 18},
    }
    toy["programs"]["gain"]["graph"]["nodes"][6] = ["call", "unknown", 2, 4]
    evidence = statement(toy, "kernel")["evidence"]
    evidence["roots"] = {str(int(key) + 3): value for key, value in evidence["roots"].items()}
    assert refused(toy) == ""


def _moved(node: Sequence[Any], by: int) -> list[Any]:
    return [entry + by if isinstance(entry, int) else entry for entry in node]


def test_every_alteration_is_noticed(toy: Data) -> None:
    """Numbers and node numbers of the map, of the tower and of the evidence, each on its own."""
    tally = Campaign(toy).run()
    assert not tally.accepted
    assert tally.refuted > 50


def test_only_the_start_may_change_unnoticed_by_the_mathematics(toy: Data) -> None:
    """And then the comparison with the program that was expected tells."""
    altered = deepcopy(toy)
    altered["programs"]["gain"]["graph"]["nodes"][UNKNOWN] = ["call", "unknown", 1, 2]
    assert refused(altered) == ""
    assert not check(altered, **expectations(toy)).accepted


def test_a_tall_map_is_decided_at_once(toy: Data) -> None:
    """Doubling again and again: each node is looked at once."""
    nodes: list[list[Any]] = [["symbol", "d"], ["number", "-1"], ["mul", 0, 1]]
    nodes += [["add", number, number] for number in range(2, 400)]
    end = len(nodes)
    nodes += [["call", "unknown", 0, 0], ["mul", end - 1, end], ["pow", end + 1, "1/2"],
              ["call", "fixed_point", end, end + 2, end + 2]]  # fmt: skip
    assert program_reason(toy, nodes, end + 3, {end: X, end + 2: X}, X)


def test_many_fixed_points_of_a_wide_map_decide_it_once(toy: Data) -> None:
    """Gone over again for each of them it would be an hour's work that nothing counts."""
    wide: list[Any] = ["mul", *[2] * 20_000]
    nodes: list[list[Any]] = [["number", "1"], ["call", "unknown", 0, 0], ["pow", 1, "0"], wide]
    nodes += [["call", "fixed_point", 1, 3, 0]] * 3000
    nodes.append(["mul", *range(4, 3004)])
    assert program_reason(toy, nodes, 3004, {1: 1}, 1) == ""


def test_a_slope_of_many_digits_is_given_up(toy: Data) -> None:
    nodes: list[list[Any]] = [["number", "1"], ["call", "unknown", 0, 0]]
    nodes += [["pow", number, "64"] for number in range(1, 61)]
    nodes.append(["call", "fixed_point", 1, 61, 1])
    assert "a slope of more than" in program_reason(toy, nodes, 62, {1: 1}, 1)


def test_a_sum_of_many_unknowns_is_refused_at_once(toy: Data) -> None:
    """Sets of a thousand unknowns would be united as often as they are summed."""
    nodes: list[list[Any]] = [["number", "1"]] + [["call", "unknown", 0, 0]] * 1000
    nodes.append(["add", *range(1, 1001)])
    nodes.append(["add", *[1001] * 300_000])
    assert "holds an unknown" in program_reason_whole(toy, nodes, 1002, {1: 1}, 1)
