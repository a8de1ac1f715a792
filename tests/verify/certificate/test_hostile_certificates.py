"""Hostile data ends in a rejection, soon; nothing makes the checker raise."""

from __future__ import annotations

from collections.abc import Callable
from copy import deepcopy
from time import perf_counter
from typing import Any

import pytest
from hypothesis import HealthCheck, given, settings
from hypothesis import strategies as st
from one_of_each import further
from samples import samples
from tests.verify.certificate.toy_writer import statement as written

from gainproof.verify.certificate import check

Data = dict[str, Any]

# Generous beside the few seconds measured, since test machines are busy.
PATIENCE = 300.0


def _graph(nodes: list[Any]) -> Data:
    return {"nodes": nodes, "outputs": {"value": len(nodes) - 1}}


def _certificate(
    nodes: list[Any],
    parameters: int = 1,
    generators: list[Any] | None = None,
    elements: Data | None = None,
) -> Data:
    names = [f"p{i}" for i in range(parameters)]
    claim = {"left": _graph(nodes), "right": _graph([["number", "1"]]), "free": []}
    return {
        "format": "gainproof certificate 1",
        "subject": "hostile",
        "programs": {},
        "towers": {
            "main": {
                "parameters": [{"symbol": n, "above": "0"} for n in names],
                "generators": generators or [],
                "elements": elements or {},
            }
        },
        "statements": [written("x", "equal", claim, {"nonzero": []})],
    }


def _nested_powers() -> Data:
    nodes: list[Any] = [["symbol", "p0"], ["number", "1"], ["add", 0, 1]]
    return _certificate([*nodes, *(["pow", i, "64"] for i in range(2, 40))])


def _many_terms() -> Data:
    nodes: list[Any] = [["symbol", f"p{i}"] for i in range(10)]
    return _certificate([*nodes, ["add", *range(10)], ["pow", 10, "60"]], 10)


def _long_numbers() -> Data:
    return _certificate([["number", "9" * 400], *(["mul", i, i] for i in range(100))])


def _squared_sums() -> Data:
    nodes: list[Any] = [["symbol", "p0"], ["number", "1/3"], ["add", 0, 1]]
    return _certificate([*nodes, *(["mul", i, i] for i in range(2, 60))])


def _different_denominators() -> Data:
    numerator = [[f"1/{10**390 + 2 * i + 1}", [1000 - i]] for i in range(1001)]
    return _certificate([["symbol", "a"]], elements={"a": {"num": numerator, "den": [["1", [0]]]}})


def _long_denominator() -> Data:
    below = [["1", [i, j]] for i in range(120, -1, -1) for j in range(120, -1, -1)]
    nodes: list[Any] = [["symbol", "a"]]
    return _certificate(
        [*nodes, *(["add", i, 0] for i in range(3000))],
        2,
        elements={"a": {"num": [["1", [0, 0]]], "den": below}},
    )


def _many_denominators() -> Data:
    elements = {
        f"a{i}": {"num": [["1", [0]]], "den": [["1", [1]], [str(i + 1), [0]]]} for i in range(500)
    }
    nodes: list[Any] = [["symbol", f"a{i}"] for i in range(500)]
    return _certificate([*nodes, ["add", *range(500)]], elements=elements)


def _nested_multiplicities() -> Data:
    elements = {"a": {"num": [["1", [0]]], "den": [["1", [1]], ["1", [0]]]}}
    nodes: list[Any] = [["symbol", "a"]]
    return _certificate([*nodes, *(["pow", i, "64"] for i in range(20))], elements=elements)


def _tall_tower() -> Data:
    height = 20
    generators: list[Any] = []
    for i in range(height):
        exponents = [0] * (height + 1)
        exponents[i] = 1
        generators.append(
            {
                "symbol": f"y{i}",
                "power": 2,
                "radicand": [["1", exponents], ["1", [0] * (height + 1)]],
            }
        )
    nodes: list[Any] = [
        ["symbol", f"y{height - 1}"],
        ["number", "1"],
        ["add", 0, 1],
        ["pow", 2, "64"],
        ["pow", 3, "8"],
        ["derivative", 4, "p0"],
    ]
    return _certificate(nodes, generators=generators)


def _many_derivatives() -> Data:
    elements = {"a": {"num": [["1", [0]]], "den": [["1", [1]], ["1", [0]]]}}
    nodes: list[Any] = [["symbol", "a"]]
    return _certificate(
        [*nodes, *(["derivative", i, "p0"] for i in range(3000))], elements=elements
    )


def _roots_of_long_numbers() -> Data:
    nodes: list[Any] = [["number", str(7**400 + 2 * i)] for i in range(1500)]
    nodes += [["pow", i, "1/2"] for i in range(1500)]
    return _certificate([*nodes, ["add", *range(1500, 3000)]])


def _nested_substitutions() -> Data:
    nodes: list[Any] = [["symbol", "p0"], ["number", "1"], ["add", 0, 1]]
    for _ in range(60):
        last = len(nodes) - 1
        nodes += [["at", last, "p0", 2], ["add", last + 1, last]]
    return _certificate(nodes)


def _deep() -> Data:
    value: Any = "x"
    for _ in range(5000):
        value = [value]
    return {"format": value}


def _wide() -> Data:
    return {"format": ["x"] * 2_000_000}


def _cyclic() -> Data:
    value: Data = {}
    value["format"] = value
    return value


@pytest.mark.alike
@pytest.mark.parametrize(
    "make",
    [
        _nested_powers,
        _many_terms,
        _long_numbers,
        _squared_sums,
        _different_denominators,
        _long_denominator,
        further(_many_denominators),
        _nested_multiplicities,
        _tall_tower,
        _many_derivatives,
        _roots_of_long_numbers,
        _nested_substitutions,
        _deep,
        _wide,
        _cyclic,
    ],
)
def test_bounded_effort(make: Callable[[], Data]) -> None:
    start = perf_counter()
    report = check(make())
    assert not report.accepted
    assert perf_counter() - start < PATIENCE


json_like = st.recursive(
    st.one_of(
        st.none(),
        st.booleans(),
        st.integers(-3, 30),
        st.floats(),
        st.text(max_size=4),
        st.sampled_from(
            [
                "p",
                "s",
                "alpha",
                "symbol",
                "add",
                "1/2",
                "-1",
                "num",
                "den",
                "value",
                "nodes",
                "outputs",
                "infinity",
                "0",
            ]
        ),
    ),
    lambda inner: st.one_of(
        st.lists(inner, max_size=4),
        st.dictionaries(
            st.sampled_from(
                [
                    "num",
                    "den",
                    "nodes",
                    "outputs",
                    "value",
                    "symbol",
                    "s",
                    "1,1",
                    "nonzero",
                    "weights",
                ]
            ),
            inner,
            max_size=3,
        ),
    ),
    max_leaves=12,
)


def _places(value: Any, path: tuple[Any, ...] = ()) -> list[tuple[Any, ...]]:
    entries = (
        value.items()
        if isinstance(value, dict)
        else enumerate(value)
        if isinstance(value, list)
        else ()
    )
    return [path, *(p for key, entry in entries for p in _places(entry, (*path, key)))]


@settings(
    max_examples=samples(32),
    deadline=None,
    suppress_health_check=[HealthCheck.function_scoped_fixture],
)
@given(st.data())
def test_nonsense_anywhere(acceleration: Data, memory: Data, data: st.DataObject) -> None:
    certificate = deepcopy(data.draw(st.sampled_from([acceleration, memory])))
    path = data.draw(st.sampled_from(_places(certificate)[1:]))
    place: Any = certificate
    for step in path[:-1]:
        place = place[step]
    place[path[-1]] = data.draw(json_like)
    report = check(certificate)
    assert report.accepted == (not report.reason)
    assert "malformed" not in report.reason
