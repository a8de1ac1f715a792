"""The strict schema: one canonical spelling, no field too many, no name twice, nothing idle."""

from __future__ import annotations

import json
from collections import UserDict
from pathlib import Path
from typing import Any

import pytest
from tests.verify.certificate.toy_changes import refused, statement
from tests.verify.certificate.toy_writer import graph
from tests.verify.certificate.toy_writer import statement as written

from gainproof.verify.certificate import MalformedError, check, read_certificate

Data = dict[str, Any]


@pytest.mark.parametrize(
    "new",
    [
        "+4",
        "4.0",
        "4e0",
        "04",
        "-0",
        "8/2",
        "4/1",
        " 4",
        "4 ",
        "4\n",
        "",
        "٤",
        "1/0",
        "0x4",
        "1_0",
        4,
        4.0,
        True,
        None,
        "0",
        "9" * 401,
        ["4"],
    ],
)
def test_spelling_of_coefficients(acceleration: Data, new: Any) -> None:
    term = acceleration["towers"]["main"]["elements"]["x22"]["num"][0]
    assert term[0] == "4"
    term[0] = new
    assert refused(acceleration)


@pytest.mark.parametrize(
    "new",
    [
        [3.0, 0],
        [True, 0],
        ["3", 0],
        [3],
        [3, 0, 0],
        [],
        [-3, 0],
        [10**9, 0],
        [None, 0],
        "30",
        {},
    ],
)
def test_exponents(acceleration: Data, new: Any) -> None:
    acceleration["towers"]["main"]["elements"]["x22"]["num"][0][1] = new
    assert refused(acceleration)


def test_order_of_terms(acceleration: Data) -> None:
    numerator = acceleration["towers"]["main"]["elements"]["sigma"]["num"]
    numerator.reverse()
    assert "descending" in refused(acceleration)
    numerator.reverse()
    numerator.insert(0, list(numerator[0]))
    assert "descending" in refused(acceleration)


@pytest.mark.parametrize(
    "place",
    [
        "top",
        "tower",
        "parameter",
        "generator",
        "element",
        "program",
        "graph",
        "statement",
        "claim",
        "evidence",
        "fraction",
    ],
)
def test_unknown_fields(acceleration: Data, place: str) -> None:
    tower = acceleration["towers"]["main"]
    entry = statement(acceleration, "updated")
    target: Data = {
        "top": acceleration,
        "tower": tower,
        "parameter": tower["parameters"][0],
        "generator": tower["generators"][0],
        "element": tower["elements"]["alpha"],
        "program": acceleration["programs"]["gains"],
        "graph": acceleration["programs"]["gains"]["graph"],
        "statement": entry,
        "claim": entry["claim"],
        "evidence": entry["evidence"],
        "fraction": entry["evidence"]["value"],
    }[place]
    target["comment"] = "harmless"
    assert "not known here" in refused(acceleration)


@pytest.mark.parametrize(
    "parameter",
    [
        {"symbol": "p"},
        {"symbol": "p", "above": "-1"},
        {"symbol": "p", "above": "1"},
        {"symbol": "p", "above": "0", "from": "0"},
        {"symbol": "p", "from": "-1"},
        {"symbol": "p", "from": "0"},
        {"symbol": "p", "below": "0"},
        {"above": "0"},
        {"symbol": "s", "above": "0"},
        {"symbol": "alpha", "above": "0"},
        {"symbol": 1, "above": "0"},
        "p",
        None,
    ],
)
def test_parameters(acceleration: Data, parameter: Any) -> None:
    acceleration["towers"]["main"]["parameters"] = [parameter]
    assert refused(acceleration)


@pytest.mark.parametrize(
    ("field", "new"),
    [
        ("power", 1),
        ("power", 0),
        ("power", -2),
        ("power", 3),
        ("power", 1000),
        ("power", True),
        ("power", "2"),
        ("radicand", []),
        ("radicand", [["-1", [0, 0]]]),
        ("radicand", [["1", [0, 1]]]),
        ("radicand", [["1", [2, 0]], ["-2", [0, 0]]]),
        ("symbol", "p"),
        ("symbol", "alpha"),
        ("symbol", ""),
        ("symbol", "s\n"),
        ("symbol", "s s"),
    ],
)
def test_generators(acceleration: Data, field: str, new: Any) -> None:
    acceleration["towers"]["main"]["generators"][0][field] = new
    assert refused(acceleration)


def test_generators_in_order(acceleration: Data) -> None:
    tower = acceleration["towers"]["main"]
    tower["generators"].append({"symbol": "t", "power": 2, "radicand": [["1", [0, 0, 0]]]})
    tower["generators"][0]["radicand"] = [["1", [0, 0, 1]]]
    assert "earlier" in refused(acceleration)


@pytest.mark.parametrize(
    "denominator",
    [
        [],
        [["-1", [0, 0]]],
        [["1", [1, 0]], ["-1", [0, 0]]],
        [["1", [2, 0]], ["-1", [1, 1]]],
    ],
)
def test_denominators_of_elements(acceleration: Data, denominator: Any) -> None:
    acceleration["towers"]["main"]["elements"]["alpha"]["den"] = denominator
    assert "denominator" in refused(acceleration)


def test_nothing_idle(acceleration: Data) -> None:
    tower = acceleration["towers"]["main"]
    tower["elements"]["idle"] = tower["elements"]["alpha"]
    assert "idle not used" in refused(acceleration)
    del tower["elements"]["idle"]
    acceleration["towers"]["other"] = tower
    assert "other not used" in refused(acceleration)
    del acceleration["towers"]["other"]
    acceleration["programs"]["other"] = acceleration["programs"]["gains"]
    assert "other not used" in refused(acceleration)
    del acceleration["programs"]["other"]
    assert refused(acceleration) == ""


def test_idle_variables(memory: Data) -> None:
    tower = memory["towers"]["branch"]
    tower["parameters"].append({"symbol": "h", "above": "0"})
    for entry in tower["elements"].values():
        for part in ("num", "den"):
            entry[part] = [[c, [*e, 0]] for c, e in entry[part]]
    memory["statements"] = [
        written(
            "x",
            "equal",
            {"left": graph("u"), "right": graph("g**2 + 1"), "free": []},
            {"nonzero": []},
            "branch",
        )
    ]
    del memory["towers"]["samples"]
    memory["programs"] = {}
    assert "h not used" in refused(memory)


@pytest.mark.parametrize(
    "nodes",
    [
        [],
        [["symbol", "p"], ["neg", 0]],
        [["neg", 0]],
        [["add", 0, 0]],
        [["symbol", "p"], ["add", 0]],
        [["symbol", "p"], ["add"]],
        [["symbol", "p"], ["div", 0]],
        [["symbol", "p"], ["mul", 0, 1]],
        [["symbol", "p"], ["mul", 0, -1]],
        [["symbol", "p"], ["mul", 0, "0"]],
        [["symbol", "p"], ["mul", 0, True]],
        [["symbol", "p"], ["pow", 0, 2]],
        [["symbol", "p"], ["pow", 0, "2/4"]],
        [["symbol", "p"], ["pow", 0, "1000000"]],
        [["symbol", "p"], ["pow", 0, "1/1000"]],
        [["symbol", "p"], ["sin", 0]],
        [["symbol", "p"], ["call", "exp", 0]],
        [["symbol", "p"], ["call", "abs"]],
        [["symbol", "p"], ["call", "select", 0, 0]],
        [["symbol", "p"], ["matrix", 1, 2, 0]],
        [["symbol", "p"], ["matrix", 0, 0]],
        [["symbol", "p"], ["matrix", 1, 99, *[0] * 99]],
        [["symbol", "p"], ["derivative", 0, "s"]],
        [["symbol", "p"], ["at", 0, "p"]],
        [["symbol", "p", "p"]],
        [["number", "1", "2"]],
        [["number", 1]],
        [[]],
        [3],
        ["symbol"],
        [["symbol", "p"], ["symbol", "s"]],
    ],
)
def test_graphs(acceleration: Data, nodes: Any) -> None:
    left = {"nodes": nodes, "outputs": {"value": max(len(nodes) - 1, 0)}}
    acceleration["statements"] = [
        written("x", "equal", {"left": left, "right": graph("p"), "free": []}, {"nonzero": []})
    ]
    assert refused(acceleration)


@pytest.mark.parametrize(
    "outputs",
    [
        {},
        {"value": 1},
        {"value": -1},
        {"value": "0"},
        {"value": True},
        {"other": 0},
        {"value": 0, "other": 0},
        [0],
    ],
)
def test_outputs(acceleration: Data, outputs: Any) -> None:
    left = {"nodes": [["symbol", "p"]], "outputs": outputs}
    acceleration["statements"] = [
        written("x", "equal", {"left": left, "right": graph("p"), "free": []}, {"nonzero": []})
    ]
    assert refused(acceleration)


@pytest.mark.parametrize(
    ("field", "new"),
    [
        ("format", "gainproof certificate 2"),
        ("format", 1),
        ("subject", ""),
        ("subject", 7),
        ("towers", {}),
        ("towers", []),
        ("programs", []),
        ("statements", []),
        ("statements", {}),
    ],
)
def test_top(acceleration: Data, field: str, new: Any) -> None:
    acceleration[field] = new
    assert refused(acceleration)


@pytest.mark.parametrize(
    ("field", "new"),
    [
        ("kind", "obvious"),
        ("kind", "proved"),
        ("tower", "nowhere"),
        ("id", "updated"),
        ("id", ""),
        ("claim", []),
        ("claim", None),
        ("evidence", []),
        ("evidence", "yes"),
    ],
)
def test_statements(acceleration: Data, field: str, new: Any) -> None:
    statement(acceleration, "relation")[field] = new
    assert refused(acceleration)


@pytest.mark.parametrize("data", [None, [], "x", 3, {1: 2}, {"format": float("nan")}])
def test_no_record_at_all(data: Any) -> None:
    assert not check(data).accepted


def test_only_plain_types(acceleration: Data) -> None:
    class Text(str):
        __slots__ = ()

    assert check(UserDict(acceleration)).accepted
    acceleration["subject"] = Text("random-acceleration")
    assert "type Text" in refused(acceleration)


def test_reading_files(acceleration: Data, tmp_path: Path) -> None:
    path = tmp_path / "certificate.json"
    path.write_text(json.dumps(acceleration), encoding="utf-8")
    assert read_certificate(path) == acceleration
    assert check(read_certificate(path)).accepted


@pytest.mark.parametrize(
    "content",
    [
        b"",
        b"[]",
        b"{",
        b"\xff{}",
        b'{"a": 1.0}',
        b'{"a": NaN}',
        b'{"a": 1, "a": 1}',
        b'{"a": ' + b"[" * 100_000,
        b'{"a": ' + b"9" * 10_000 + b"}",
        b'{"a": Infinity}',
        b"{}x",
    ],
)
def test_unreadable_files(content: bytes) -> None:
    with pytest.raises(MalformedError):
        read_certificate(content)
