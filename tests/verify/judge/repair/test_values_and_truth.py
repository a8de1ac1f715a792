"""Printed numbers are rounded anew; where no misprint explains a formula, the true one is told."""

from __future__ import annotations

import pytest
from claim_texts import judged, memory, steady


@pytest.mark.parametrize(
    ("latex", "expected"),
    [
        (r"\alpha = 0.668 \quad (\Lambda = 1)", r"\alpha = 0.769 \quad \left( \Lambda = 1 \right)"),
        (r"\beta = 0.40 \quad (\Lambda = 1)", r"\beta = 0.48 \quad \left( \Lambda = 1 \right)"),
    ],
)
def test_digits_are_rounded_anew(latex: str, expected: str) -> None:
    (verdict,) = judged(steady("random-velocity"), ("value", latex))
    assert verdict.verdict == "refuted"
    assert verdict.repair == {"latex": expected, "verdict": "proved"}


def test_the_true_formula_is_told_where_no_misprint_explains_a_claim() -> None:
    (verdict,) = judged(
        memory(1), ("identity", r"\beta = \frac{k^3 + 11}{k^4 + 7 k + 3} \quad (1 \le k)")
    )
    assert verdict.verdict in ("refuted", "conditional")
    assert verdict.repair is None
    assert "no misprint-like repair found; what is true is \\beta = \\frac{6}{" in verdict.reason
