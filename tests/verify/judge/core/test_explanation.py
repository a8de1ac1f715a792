"""The explanation of a claim shows the ground it stands on, the steps and the witnesses."""

from __future__ import annotations

import json
from fractions import Fraction
from pathlib import Path
from typing import Any

import pytest

from gainproof.derive.catalogue import CATALOGUE
from gainproof.verify.judge.claim_file import read_claim_file
from gainproof.verify.judge.exact.expression import number, power, sqrt, symbol
from gainproof.verify.judge.exact.expression_text import written
from gainproof.verify.judge.explain import explain
from gainproof.verify.judge.judge import judge_file

LECTURE = Path(__file__).parents[4] / "verify" / "claims" / "kosuge-slides.toml"


@pytest.fixture(scope="module")
def texts() -> dict[str, str]:
    models = [m for entry in CATALOGUE if (m := entry.build().model_data)]
    verdicts = judge_file(read_claim_file(LECTURE), models)
    claims: list[dict[str, Any]] = json.loads(json.dumps([v.to_json() for v in verdicts]))
    return {claim["id"]: explain(claim) for claim in claims}


def test_every_claim_has_an_explanation(texts: dict[str, str]) -> None:
    assert all(text.startswith(f"{name}: ") for name, text in texts.items())


def test_proof_of_a_gain_relation(texts: dict[str, str]) -> None:
    text = texts["table-ab-RV"]
    for part in (
        "process noise random-velocity",
        "the Riccati equation, gain and innovation variance hold identically",
        "stable (Jury)",
        r"\alpha (\alpha + \beta) = 2 \beta",
        r"\beta = ",
        "t1^2 = x^2 + 16",
        "Against process noise random-acceleration: tracking_index = 1",
    ):
        assert part in text


def test_limit_and_equivalence(texts: dict[str, str]) -> None:
    assert "They are separated by" in texts["line-alpha-limit"]
    assert "there:" in texts["table-ab-RV-same"]
    assert "back:" in texts["table-ab-RV-same"]


def test_text_of_expressions() -> None:
    x = symbol("free x")
    expr = -power(x + 1, 2) / sqrt(number(Fraction(1, 2)) - x) * number(-3)
    assert written(expr) == ([], ["((-(x + 1)^2) / sqrt(1/2 - x)) (-3)"])
    long = sqrt(sqrt(x + 1) + sqrt(x + 2) + sqrt(x + 3) + sqrt(x + 4) + sqrt(x + 5) + sqrt(x + 6))
    lines, (text,) = written(long + power(long, 2))
    assert text == "e1 + e1^2"
    assert lines[0].startswith("e1 = sqrt(")
    assert written(x + 1, names={x + 1: "y"}) == (["y = x + 1"], ["y"])
