"""Expectations over declared noises: linear, independent, with mean zero."""

from __future__ import annotations

import pytest
from small_claims import check, judged

SYMBOLS = {
    "v": "{ unit = '1', variance = 'r', meaning = 'noise' }",
    "w": "{ unit = '1', variance = 'q', meaning = 'noise' }",
    "e_1": "{ definition = '(1 - h) w - h v', meaning = 'error of an update' }",
}
TRUE = [
    "E[v] = 0",
    "E[v^2] = r",
    "E[v w] = 0",
    "E[(a v + b w)^2] = a^2 r + b^2 q",
    "E[e_1^2] = (1 - h)^2 q + h^2 r",
    "E[v^2 w^2] = r q",
    (
        r"E\left[ \begin{pmatrix} v \\ w \end{pmatrix} \begin{pmatrix} v & w \end{pmatrix} \right]"
        r" = \begin{pmatrix} r & 0 \\ 0 & q \end{pmatrix}"
    ),
]
FALSE = [
    "E[v^2] = r^2",
    "E[(a v + b w)^2] = a^2 r + b^2 q + 2 a b",
    "E[e_1^2] = (1 - h) q",
]
LEFT_OPEN = [
    ("E[v^4] = 3 r^2", "beyond its variance"),
    ("E[x] = x", "no symbol is declared a noise"),
    (r"E[\sqrt{v^2 + 1}] = 1", "no polynomial"),
]


@pytest.mark.parametrize("latex", TRUE)
def test_true(latex: str) -> None:
    check(judged("identity", latex, SYMBOLS), "proved")


@pytest.mark.parametrize("latex", FALSE)
def test_false(latex: str) -> None:
    check(judged("identity", latex, SYMBOLS), "refuted")


@pytest.mark.parametrize(("latex", "why"), LEFT_OPEN)
def test_other_moments_are_not_guessed(latex: str, why: str) -> None:
    found = judged("identity", latex, SYMBOLS)
    check(found, "undecided")
    assert why in found.reason
