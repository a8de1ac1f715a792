"""Steady states of recursions: fixed, in the domain, attracting."""

from __future__ import annotations

import pytest
from small_claims import check, judged

SYMBOLS = {
    "p": "{ unit = '1', domain = 'p > 0', meaning = 'variance' }",
    "p_k": "{ unit = '1', meaning = 'variance at sample k' }",
    "p_{k-1}": "{ unit = '1', meaning = 'variance at sample k-1' }",
    "g_1": r"{ definition = '\frac{p_{k-1} + q}{p_{k-1} + q + r}', meaning = 'gain' }",
}
RICCATI = "recursion = 'p_k = (1 - g_1)(p_{k-1} + q)'\nprevious = 'p_{k-1}'\ndomain = 'q>0, r>0'"


@pytest.mark.parametrize(
    ("latex", "recursion", "wanted"),
    [
        (r"p = \frac{-q + \sqrt{q^2 + 4 q r}}{2}", RICCATI, "proved"),
        (r"p = \frac{q + \sqrt{q^2 + 4 q r}}{2}", RICCATI, "refuted"),
        # a fixed point too, but no variance
        (r"p = \frac{-q - \sqrt{q^2 + 4 q r}}{2}", RICCATI, "refuted"),
        # fixed, but every neighbour moves away
        ("p = 2 p - 1", "recursion = 'p_k = 2 p_{k-1} - 1'\nprevious = 'p_{k-1}'", "refuted"),
        ("p = 2", "recursion = 'p_k = \\frac{p_{k-1}}{2} + 1'\nprevious = 'p_{k-1}'", "proved"),
        ("p = 1", "recursion = 'p_k = \\frac{p_{k-1}}{2} + 1'\nprevious = 'p_{k-1}'", "refuted"),
        ("p^2 = 2", "recursion = 'p_k = p_{k-1}'\nprevious = 'p_{k-1}'", "undecided"),
    ],
)
def test_steady_state(latex: str, recursion: str, wanted: str) -> None:
    check(judged("steady_state", f"latex = '{latex}'\n{recursion}", SYMBOLS), wanted)


def test_whether_it_attracts_is_said() -> None:
    latex = r"p = \frac{-q + \sqrt{q^2 + 4 q r}}{2}"
    found = judged("steady_state", f"latex = '{latex}'\n{RICCATI}", SYMBOLS)
    assert "attracts its neighbours" in found.reason
