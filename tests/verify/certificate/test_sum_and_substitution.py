"""sum, and substitution in expressions: seen failing."""

from __future__ import annotations

from typing import Any

import pytest
import sympy as sp
from tests.verify.certificate.toy_changes import changed, reason, statement
from tests.verify.certificate.toy_writer import graph

Data = dict[str, Any]

p, s, j, k = sp.symbols("p s j k")


@pytest.mark.parametrize(
    ("path", "new", "why"),
    [
        ("claim.closed", graph(k * (k + 1) * (2 * k + 1) / 6 + 1), "at the start"),
        ("claim.closed", graph(k * (k + 1) / 2), "grow"),
        ("claim.summand", graph(j), "grow"),
        ("claim.summand", graph(j**2 + 0 * k + k), "upper limit occurs"),
        ("claim.start", "0", ""),
        ("claim.start", "2", "integer start"),
        ("claim.start", "1/2", "integer start"),
        ("claim.upper", "j", "parameter"),
        ("claim.upper", "a", "parameter"),
        ("claim.index", "k", "already has a meaning"),
        ("claim.index", "a", "already has a meaning"),
        ("claim.index", "i", "neither"),
        ("claim.closed", graph(1 / (k + 1)), "polynomial"),
        ("claim.summand", graph(sp.Symbol("a")), "polynomial"),
        ("evidence", {"nonzero": []}, "not known"),
    ],
)
def test_sum(memory: Data, path: str, new: Any, why: str) -> None:
    found = changed(memory, "squares", path, new)
    assert (why in found) if why else found == ""


def test_sum_of_cubes_start(memory: Data) -> None:
    """A summand that does not vanish at 0 tells the start 0 from 1."""
    claim = statement(memory, "squares")["claim"]
    claim |= {"summand": graph(sp.Integer(1)), "closed": graph(k)}
    assert "neither" in reason(memory, "squares") or reason(memory, "squares") == ""
    claim["start"] = "0"
    assert "at the start" in reason(memory, "squares")


def test_sum_from_below_the_start(memory: Data) -> None:
    memory["towers"]["samples"]["parameters"][0]["from"] = "0"
    assert "integer start" in reason(memory, "squares")


def test_sum_with_an_open_parameter(acceleration: Data) -> None:
    acceleration["statements"] = [
        {
            "id": "x",
            "kind": "sum",
            "tower": "main",
            "evidence": {},
            "claim": {
                "index": "j",
                "start": "0",
                "upper": "p",
                "summand": graph(j),
                "closed": graph(p),
            },
        }
    ]
    assert "without generators" in reason(acceleration, "x")
    acceleration["towers"]["main"] = {
        "parameters": [{"symbol": "p", "above": "0"}],
        "generators": [],
        "elements": {},
    }
    assert "integer start" in reason(acceleration, "x")


def test_substitution(memory: Data) -> None:
    a = sp.Symbol("a")
    for place, value in ((sp.Integer(0), 1), (sp.Integer(-1), 0), (sp.Integer(-2), 0)):
        left = graph(sp.Subs(a, k, place, evaluate=False))
        found = changed(memory, "first", "claim.left", left)
        assert ("nonzero" in found) == (value == 0)


def _at(inner: list[Any], new: list[Any], right: Any) -> Data:
    """at(inner, k := new) = right."""
    shifted = [[n[0], *(a + len(inner) if isinstance(a, int) else a for a in n[1:])] for n in new]
    nodes = [*inner, *shifted]
    nodes.append(["at", len(inner) - 1, "k", len(nodes) - 1])
    return {
        "left": {"nodes": nodes, "outputs": {"value": len(nodes) - 1}},
        "right": graph(right),
        "free": [],
    }


BACK = [["symbol", "k"], ["number", "-1"], ["add", 0, 1]]


def test_substitution_under_a_root(memory: Data) -> None:
    """sqrt(k^2) is k for k from 1 on; at k - 5 it is |k - 5|, which is not k - 5."""
    root = [["symbol", "k"], ["pow", 0, "2"], ["pow", 1, "1/2"]]
    far = [["symbol", "k"], ["number", "-5"], ["add", 0, 1]]
    assert "not known" in changed(memory, "first", "claim", _at(root, far, k - 5))
    ahead = [["symbol", "k"], ["number", "5"], ["mul", 0, 1]]
    assert changed(memory, "first", "claim", _at(root, ahead, 5 * k)) == ""


def test_substitution_where_a_divisor_vanishes(memory: Data) -> None:
    """(1/k)/(1/k) and 1/k - 1/k mean nothing at k - 1 = 0."""
    start: list[Any] = [["symbol", "k"], ["pow", 0, "-1"]]
    for rest, value in (([["div", 1, 1]], 1), ([["neg", 1], ["add", 1, 2]], 0)):
        claim = _at([*start, *rest], BACK, value)
        assert "nonzero" in changed(memory, "first", "claim", claim)
    zero = [["symbol", "k"], ["number", "0"], ["div", 1, 0]]
    assert "nonzero" in changed(memory, "first", "claim", _at(zero, BACK, 0))


def test_nested_substitution(memory: Data) -> None:
    """at(at(k^2, k := k + 1), k := 2 k) is (2 k + 1)^2."""
    nodes: list[Any] = [
        ["symbol", "k"],
        ["pow", 0, "2"],
        ["number", "1"],
        ["add", 0, 2],
        ["at", 1, "k", 3],
        ["number", "2"],
        ["mul", 0, 5],
        ["at", 4, "k", 6],
    ]
    claim = {
        "left": {"nodes": nodes, "outputs": {"value": 7}},
        "right": graph((2 * k + 1) ** 2),
        "free": [],
    }
    assert changed(memory, "first", "claim", claim) == ""
    claim["right"] = graph(4 * k**2 + 1)
    assert changed(memory, "first", "claim", claim)


def test_simultaneous_substitution(memory: Data) -> None:
    """k and f exchanged: what was put in is not replaced again."""
    nodes: list[Any] = [
        ["symbol", "k"],
        ["symbol", "f"],
        ["neg", 1],
        ["add", 0, 2],
        ["at", 3, "k", 1],
        ["at", 4, "f", 0],
    ]
    claim = {"left": {"nodes": nodes, "outputs": {"value": 5}}, "right": graph(0), "free": ["f"]}
    assert changed(memory, "first", "claim", claim) == ""
    claim["right"] = graph(sp.Symbol("f") - k)
    assert changed(memory, "first", "claim", claim)


def test_no_derivative_inside_a_substitution(memory: Data) -> None:
    inner = [["symbol", "k"], ["derivative", 0, "k"]]
    assert "derivative inside" in changed(memory, "first", "claim", _at(inner, BACK, 1))


def test_no_substitution_over_generators(acceleration: Data) -> None:
    left = graph(sp.Subs(s, p, p + 1, evaluate=False))
    assert "without generators" in changed(acceleration, "relation", "claim.left", left)
