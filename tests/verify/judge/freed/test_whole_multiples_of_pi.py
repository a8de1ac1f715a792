"""Angles with whole multiples of pi, and powers of -1, which are 1 or -1."""

from __future__ import annotations

import pytest
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
