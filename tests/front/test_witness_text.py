"""Witnesses in words: points, approaches, and what the sides are there."""

from __future__ import annotations

from typing import Any

import pytest

from gainproof.verdicts import witness_text
from gainproof.verify.judge.verdict_words import Shown

WITNESS = {
    "point": {"r": "1"},
    "left": {"midpoint": "0.500000000", "radius": "0"},
    "operator": "=",
    "right": {"midpoint": "4.383960761730", "radius": "2e-12"},
    "exact": False,
}


def test_digits_tell_the_sides_apart() -> None:
    right = {"midpoint": "0.50000000001", "radius": "0"}
    assert witness_text.sides({**WITNESS, "right": right}).endswith("the right 0.50000000001")


@pytest.mark.parametrize(
    ("midpoint", "shown"),
    [("1e-30", "1e-30"), ("123456.4", "123456"), ("-0.25", "-0.25"), ("0", "0"), ("nan?", "nan?")],
)
def test_numbers(midpoint: str, shown: str) -> None:
    left = {"midpoint": midpoint, "radius": "0"}
    text = witness_text.sides({**WITNESS, "left": left})
    assert text.lower().startswith(f"the left side is {shown.lower()}, ")


@pytest.mark.parametrize(
    ("point", "shown"),
    [
        ({"r": "-> infinity"}, "as r -> infinity"),
        ({"r": "-> 0 from above", "s": "2"}, "at s = 2 as r -> 0 from above"),
        ({"r": "-1"}, "at r = -1"),
        ({}, ""),
    ],
)
def test_points_and_approaches(point: dict[str, str], shown: str) -> None:
    assert witness_text.at_point({**WITNESS, "point": point}) == shown


NUMBER = {"midpoint": "2", "radius": "0"}


@pytest.mark.parametrize(
    ("changed", "shown"),
    [
        (
            {"operator": "->", "left": NUMBER, "right": {"undefined": "infinity"}},
            "as r -> 0 the left side tends to 2, not to infinity",
        ),
        (
            {
                "operator": "sim",
                "left": {"undefined": "of order 1"},
                "right": {"undefined": "of order 2"},
            },
            "as r -> 0 the left side is of order 1, the right of order 2",
        ),
        (
            {"left": NUMBER, "right": {**NUMBER, "midpoint": "0"}, "note": "coefficient"},
            "as r -> 0 the left side is 2, the right 0 (coefficient)",
        ),
        (
            {
                "operator": "->",
                "left": NUMBER,
                "right": {"undefined": "division by zero"},
                "note": "a side has no value",
            },
            "as r -> 0 the right side has no value (division by zero)",
        ),
    ],
)
def test_limits(changed: dict[str, object], shown: str) -> None:
    point = {"r": "-> 0"}
    assert witness_text.in_words({**WITNESS, "point": point, **changed}) == shown


def test_a_side_without_value() -> None:
    side = {"midpoint": "", "radius": "", "undefined": "division by zero"}
    text = witness_text.in_words({**WITNESS, "right": side})
    assert text == "at r = 1 the right side has no value (division by zero), the left is 0.5"
    both = witness_text.in_words({**WITNESS, "left": side, "right": side})
    assert both == "at r = 1 neither side has a value (division by zero)"
    matrix = {"midpoint": "[[1, 2], [3, 4]]", "radius": "0"}
    text = witness_text.in_words({**WITNESS, "left": side, "right": matrix})
    assert text.endswith("(division by zero), the right is [[1, 2], [3, 4]]")


@pytest.mark.parametrize(
    ("changed", "shown"),
    [
        ({"operator": "<="}, "at r = 1 the derivative is 0.5, not at most 0"),
        ({"operator": ">", "point": {}}, "the derivative is 0.5, not above 0"),
        ({"point": {"r": "-> 0"}, "operator": "<"}, "as r -> 0 the left side is 0.5, the right 0"),
        ({"left": {"undefined": "infinity"}, "operator": "<"}, "the left side has no value"),
    ],
)
def test_against_a_trend_stands_the_derivative(changed: dict[str, Any], shown: str) -> None:
    witness = {**WITNESS, "right": {"midpoint": "0", "radius": "0"}, **changed}
    assert shown in witness_text.in_words({**witness, "shows": Shown.SLOPE})
    assert "derivative" not in witness_text.in_words(witness)


def test_of_an_equivalence_the_truth_of_each_side_is_told() -> None:
    none = {"midpoint": "", "radius": "", "undefined": "not compared"}
    note = "the left side of the equivalence holds, the right has no value"
    shows = {"note": note, "shows": Shown.TRUTH}
    text = witness_text.in_words({**WITNESS, "left": none, "right": none, **shows})
    assert text == f"at r = 1 {note}"
    note = "the left side of the equivalence holds, the right does not hold"
    text = witness_text.in_words({**WITNESS, **shows, "note": note})
    assert text == f"at r = 1 {note} (its sides are 0.5 and 4.38396)"


def test_of_a_filter_its_stability_is_told() -> None:
    note = "the filter is stable (poles of modulus 0.707107), though a < 1 fails"
    witness = {**WITNESS, "note": note, "shows": Shown.STABILITY}
    assert witness_text.in_words(witness) == f"at r = 1 {note}"


@pytest.mark.parametrize(
    ("point", "values", "told"),
    [
        ({"tracking_index": "1"}, ["a", "b"], "at a = 0.5, b = 0.5 (tracking_index = 1)"),
        ({"ratio of noises": "1/3"}, ["a"], "at a = 0.5 (ratio of noises = 1/3)"),
        ({"tracking_index": "1"}, [], "at tracking_index = 1"),
        ({r"\Lambda": "1"}, ["a"], r"at \Lambda = 1"),
        ({"K_{11}": "1"}, ["a"], "at K_{11} = 1"),
        ({"tracking_index": "1", "T": "2"}, ["a"], "at a = 0.5, T = 2 (tracking_index = 1)"),
        ({"tracking_index": "-> infinity"}, ["a"], "as tracking_index -> infinity"),
    ],
)
def test_symbols_of_the_formula_come_before_what_no_source_writes(
    point: dict[str, str], values: list[str], told: str
) -> None:
    half = {"midpoint": "0.5", "radius": "0"}
    assert witness_text.at_point({"point": point, "values": dict.fromkeys(values, half)}) == told


@pytest.mark.parametrize(
    ("shape", "changed", "told"),
    [
        ("equal", {}, "At Lambda = 1/2 the left side is 0.5 +/- 1e-9, the right side is 3."),
        (
            "equal",
            {"entry": "1,2", "names": {"beta": {"midpoint": "2", "radius": "0"}}},
            (
                "At Lambda = 1/2, where beta = 2, the left side, in row and column 1,2, is "
                "0.5 +/- 1e-9, the right side is 3."
            ),
        ),
        ("positive", {}, "At Lambda = 1/2 the expression is 0.5 +/- 1e-9, which is not above 0."),
        ("limit", {"point": {}}, "The limit is 0.5 +/- 1e-9, not 3."),
        ("sum", {}, "At Lambda = 1/2 the terms add up to 0.5 +/- 1e-9, the closed form is 3."),
        (
            "monotone increasing",
            {},
            "At Lambda = 1/2 the derivative is 0.5 +/- 1e-9: it falls there.",
        ),
        (
            "monotone decreasing",
            {},
            "At Lambda = 1/2 the derivative is 0.5 +/- 1e-9: it rises there.",
        ),
    ],
)
def test_a_witness_against_a_step_of_a_derivation(
    shape: str, changed: dict[str, Any], told: str
) -> None:
    witness = {
        "shape": shape,
        "point": {"tracking_index": "1/2"},
        "left": {"midpoint": "0.5", "radius": "1e-9"},
        "right": {"midpoint": "3", "radius": "0"},
        "entry": "",
        "names": {},
        **changed,
    }
    symbols = {"tracking_index": r"\Lambda", "beta": r"\beta"}
    assert witness_text.of_relation(witness, symbols) == told
