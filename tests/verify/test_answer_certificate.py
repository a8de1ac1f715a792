"""Certificates keep what was typed: symbols, the point of a value, convention and filter."""

from __future__ import annotations

from collections.abc import Iterator
from typing import Any

import pytest

from gainproof.answers.judge import Judge
from gainproof.verify import check_answer

VELOCITY = {"model": "random-velocity"}
SAME = {"a": "sampling_interval", "T": "sampling_interval"}
AT_ONE = VELOCITY | {"given": r"\lambda = 1"}


@pytest.fixture(scope="module")
def judge() -> Iterator[Judge]:
    with Judge(seconds=60) as found:
        yield found


def lines(judge: Judge, formula: str, **said: Any) -> list[str]:
    """What the file prints, without spaces that align it; empty where there is no certificate."""
    certificate = judge.ask(formula, **said).certificate
    told = check_answer.Certificate(certificate).decide() if certificate else []
    return [" ".join(line.split()) for line in told]


@pytest.mark.parametrize(
    ("formula", "said", "letters"),
    [
        (r"K_1 = \alpha", VELOCITY, ["K_1 = K[1,1]", "alpha = K[1,1]"]),
        (
            r"\hat P_{11} = P_{11}",
            VELOCITY,
            ["hat_P_11 = X[1,1]", "P_11 = X[1,1]"],
        ),
        ("a = T", VELOCITY | {"symbols": SAME}, ["a = T"]),
        (
            "D + c = E + 3",
            {"symbols": {"D": "= a + b", "E": "= a + b", "c": "= 3"}},
            ["D = a + b", "E = a + b", "c = 3"],
        ),
        (
            "D + c = E + 4",
            {"symbols": {"D": "= a + b", "E": "= a + b", "c": "= 3"}},
            ["D = a + b", "E = a + b", "c = 3"],
        ),
    ],
)
def test_symbols_that_stand_for_the_same_have_a_line_each(
    judge: Judge, formula: str, said: dict[str, Any], letters: list[str]
) -> None:
    found = lines(judge, formula, **said)
    assert {f"with: {letter}" for letter in letters} <= {*found}


@pytest.mark.parametrize("formula", [r"\beta \approx 0.48", r"\beta \approx 0.50"])
def test_a_value_keeps_its_symbol_condition_and_model(judge: Judge, formula: str) -> None:
    found = lines(judge, formula, **AT_ONE)
    assert "with: lambda_ = 1" in found
    assert r"name: lambda_ for \lambda" in found
    assert "with: beta = K[2,1]*sampling_interval" in found
    assert "with: H = [[1, 0]]" in found


@pytest.mark.parametrize(
    ("formula", "convention", "letter"),
    [
        # by hand: alpha = 0.769 and beta = 0.480 there, so K_1 + T K_2 = 1.25 is F K
        (r"\alpha < 0.9", "gains are those of the filter (K)", "K[1,1]"),
        (
            r"\alpha > 0.9",
            "gains are those of the predictor (F K)",
            "(1*K[1,1] + sampling_interval*K[2,1] + 0)*1",
        ),
    ],
)
def test_the_convention_is_told(judge: Judge, formula: str, convention: str, letter: str) -> None:
    found = lines(judge, formula, **AT_ONE)
    assert f"convention: {convention}" in found
    assert f"with: alpha = {letter}" in found


@pytest.mark.parametrize(
    ("formula", "said"),
    [
        (r"\alpha^2 = \beta(2 - \alpha)", VELOCITY | {"given": r"\alpha < 1/2"}),
        (r"X_{11} = (1 - \alpha)^2 P_{11} + \alpha^2 \sigma_v^2", {"model": "fixed"}),
    ],
)
def test_what_is_lost_of_a_filter_has_no_certificate(
    judge: Judge, formula: str, said: dict[str, Any]
) -> None:
    assert lines(judge, formula, **said) == []
