"""The explanation of a claim shows the ground it stands on, the steps and the witnesses."""

from __future__ import annotations

import re
from fractions import Fraction

import pytest
from lecture_judged import lecture_claims

from gainproof.verify.judge.exact.expression import add, mul, neg, number, power, sqrt, symbol
from gainproof.verify.judge.exact.expression_text import written
from gainproof.verify.judge.explanation import sections
from gainproof.verify.judge.readable_expression import readable


@pytest.fixture(scope="module")
def texts() -> dict[str, str]:
    """Title and lines of all sections of each claim."""
    return {
        claim["id"]: "\n".join(
            line
            for section in sections(claim["evidence"]["certificate"] or {})
            for line in (f"[{section.title}]", *section.lines)
        )
        for claim in lecture_claims()
    }


def test_proof_of_a_gain_relation(texts: dict[str, str]) -> None:
    text = texts["table-ab-RV"]
    for part in (
        "the Riccati equation, gain and innovation variance hold identically",
        "stable (Hurwitz",
        r"\alpha (\alpha + \beta) = 2 \beta",
        r"\beta = ",
        "t1^2 = tracking_index^2 + 16",
    ):
        assert part in text


def test_limit_and_equivalence(texts: dict[str, str]) -> None:
    assert "a finite limit L has L = 0" in texts["line-alpha-limit"]
    assert "\nexactly where\n" in texts["table-ab-RV-same"]


def test_auxiliary_variables_of_the_arithmetic_are_not_shown(texts: dict[str, str]) -> None:
    own = {
        claim["id"]: set(re.findall(r"[A-Za-z]\w*?(?=[\W_]|$)", claim["latex"] or ""))
        for claim in lecture_claims()
    }
    for name, text in texts.items():
        words = re.findall(r"(?<![\\_{A-Za-z])[A-Za-z][A-Za-z0-9]*(?![A-Za-z0-9_{}])", text)
        assert not ({"x", "u0", "u1"} - own[name]) & set(words), name


def test_no_line_is_repeated_in_a_section(texts: dict[str, str]) -> None:
    for text in texts.values():
        for part in text.split("\n["):
            lines = part.split("\n")[1:]
            assert len(lines) == len(set(lines)), part


def test_readable_expressions() -> None:
    x, y = symbol("x"), symbol("y")
    for expr, shown in (
        (number(1) * x + number(0), x),
        (mul(x, number(2), y, number(3)), mul(number(6), x, y)),
        (power(x, 1) / number(1), x),
        (x * number(0), number(0)),
        (number(-1) * x, -x),
        (neg(neg(x)), x),
        (number(2) - x, number(2) - x),
        (add(x, number(1), number(2)), x + 3),
    ):
        assert written(readable(expr)) == written(shown)


def test_text_of_expressions() -> None:
    x = symbol("free x")
    expr = -power(x + 1, 2) / sqrt(number(Fraction(1, 2)) - x) * number(-3)
    assert written(expr) == ([], ["((-(x + 1)^2) / sqrt(1/2 - x)) (-3)"])
    long = sqrt(sqrt(x + 1) + sqrt(x + 2) + sqrt(x + 3) + sqrt(x + 4) + sqrt(x + 5) + sqrt(x + 6))
    lines, (text,) = written(long + power(long, 2))
    assert text == "e1 + e1^2"
    assert lines[0].startswith("e1 = sqrt(")
    assert written(x + 1, names={x + 1: "y"}) == (["y = x + 1"], ["y"])
