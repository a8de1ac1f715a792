"""Angles with whole multiples of pi, and powers of -1, which are 1 or -1."""

from __future__ import annotations

import pytest
from one_of_each import further
from small_claims import check, judged


@pytest.mark.parametrize(
    "latex",
    [
        r"\cos(k\pi) = (-1)^k",
        r"\sin(k\pi) = 0",
        r"\cos(2 k\pi + x) = \cos x",
        r"\cos(3 k\pi + x) = (-1)^k \cos x",
        r"\sin(k\pi - x) = -(-1)^k \sin x",
        r"\sin(k\pi + \frac{\pi}{2}) = (-1)^k",
        r"\tan(k n\pi + x) = \tan x",
        r"\cos(k\pi) \cos(n\pi) = (-1)^{k - n}",
        r"\cos(\pi(2 k + 1)) = -1",
        r"\cos^2(k\pi) = 1",
        r"((-1)^k)^3 = (-1)^k",
        r"\frac{1}{(-1)^k} = (-1)^k",
    ],
)
def test_true_of_all_whole_numbers(latex: str) -> None:
    check(judged("identity", latex), "proved")


@pytest.mark.parametrize(
    "latex",
    [
        r"\cos(k\pi) = (-1)^{k+1}",
        r"\cos(3 k\pi + x) = \cos x",
        r"\sin(k\pi - x) = (-1)^k \sin x",
        r"\cos(k\pi) \cos(n\pi) = (-1)^k",
        r"\cos\frac{k\pi}{2} = 0",
        r"\cos\frac{k\pi}{2} = (-1)^k",
        r"((-1)^k)^3 = 1",
        r"\cos(x\pi) \cos(x\pi) = 1",
        r"\sin(x\pi) = 0",
    ],
)
def test_false_of_some(latex: str) -> None:
    check(judged("identity", latex), "refuted")


def test_a_sign_is_neither_above_1_nor_below_minus_1() -> None:
    check(judged("inequality", r"\cos(k\pi) \geq -1"), "proved")
    check(judged("inequality", r"\cos(k\pi) > -1"), "refuted")
    check(judged("inequality", r"(-1)^k x \leq \left|x\right|"), "proved")
    check(judged("inequality", r"(1 + (-1)^k)/2 > 0"), "refuted")


def test_a_divisor_that_is_always_0_has_no_value() -> None:
    assert judged("identity", r"\frac{x}{\sin(k\pi)} = \frac{x}{\sin(k\pi)}").verdict != "proved"


@pytest.mark.alike
@pytest.mark.parametrize(
    ("kind", "latex", "domain"),
    [
        ("identity", r"\cos(k\pi + \sqrt{-x^2-1} - \sqrt{-x^2-1}) = (-1)^k", "k > 0"),
        ("identity", r"\cos(k\pi + \ln(-x^2) - \ln(-x^2)) = (-1)^k", "k > 0"),
        ("identity", r"\cos(k\pi + \frac{0}{x - x}) = (-1)^k", "k > 0"),
        further("identity", r"\cos(k\pi + x/x) = (-1)^k \cos 1", r"x \geq 0"),
        ("identity", r"\cos(k\pi + \ln x - \ln x) = (-1)^k", "x > -1"),
        ("identity", r"\sin(k\pi\frac{\ln x}{\ln x}) = 0", "x > 0"),
        ("identity", r"\sin(k\pi\frac{n}{n}) = 0", r"n \geq 0"),
        ("identity", r"\tan(k\pi + 0 \tan\theta) = 0", r"0 \leq \theta \leq \pi"),
        ("identity", r"\cos(\pi k^{-1} k^2) = (-1)^k", r"k \geq 0"),
        ("inequality", r"\cos(k\pi + x/x) \leq 1", r"x \geq 0"),
        ("limit", r"x \cos(k\pi + \frac{y}{y}) \to 0 \quad (x \to 0)", r"y \geq 0"),
    ],
)
def test_what_cancels_in_an_angle_has_to_have_a_value(kind: str, latex: str, domain: str) -> None:
    assert judged(kind, f"latex = '{latex}'\ndomain = '{domain}'").verdict != "proved"


def test_of_no_stated_domain_it_is_said_where_an_angle_has_a_value() -> None:
    found = judged("inequality", r"\cos(k\pi + x/x) \leq 1")
    check(found, "proved")
    assert found.domain == "where every part has a value"


@pytest.mark.parametrize(
    "latex",
    [r"(-1)^{k/2} = (-1)^{k/2}", r"(-1)^{k/2} (-1)^{k/2} = (-1)^k", "(-2)^{k/2} = (-2)^{k/2}"],
)
def test_whole_numbers_without_a_value_refute_nothing_where_none_is_stated(latex: str) -> None:
    assert judged("identity", latex).verdict != "refuted"
    check(judged("identity", f"latex = '{latex}'\ndomain = 'k > 0'"), "refuted")
