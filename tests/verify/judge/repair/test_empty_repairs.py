"""True inequalities that are empty are no repairs: those that their hypotheses say, those in which
what the claim speaks of cancels, those of other symbols, which are true by chance.
"""

from __future__ import annotations

import pytest
from claim_texts import algebra, judged

GAINS = algebra(
    "'e' = { unit = '1', domain = 'e > 0', meaning = 'a number' }\n"
    "'n' = { unit = '1', domain = 'n > 0', meaning = 'another' }\n"
    "'f' = { definition = 'e^2', meaning = 'best' }\n"
    "'g' = { definition = 'n^2', meaning = 'nominal' }\n"
    "'h' = { definition = 'n^2 + 3 (e - n)', meaning = 'updated' }\n"
)


@pytest.mark.parametrize(
    "latex",
    [
        r"h - f < f - g \quad (e > n)",
        r"2 h - f < f + h - g \quad (e > n)",
        r"n > e \quad (e > n)",
        r"f < g \quad (g < f)",
        r"2 f + 1 < 2 g \quad (g < f)",
    ],
)
def test_empty_repairs_are_not_offered(latex: str) -> None:
    (verdict,) = judged(GAINS, ("inequality", latex))
    assert verdict.verdict in ("refuted", "conditional"), verdict.reason
    assert verdict.repair is None, verdict.repair


@pytest.mark.parametrize(
    ("latex", "repaired"),
    [
        (r"f < g \quad (e > n)", r"f > g \quad \left( e > n \right)"),
        # what cancels in the claim as printed may cancel in its repair
        (r"h - f > h - g + 2 \quad (e > n)", r"h - f < h - g + 2 \quad \left( e > n \right)"),
    ],
)
def test_what_says_something_is_offered(latex: str, repaired: str) -> None:
    (verdict,) = judged(GAINS, ("inequality", latex))
    assert verdict.verdict in ("refuted", "conditional"), verdict.reason
    assert verdict.repair == {"latex": repaired, "verdict": "proved"}


def test_a_bound_of_another_symbol_is_not_offered() -> None:
    """ "b" for the updated "u", say: l - b < b - m would be another bound, and true."""
    setting = algebra(
        "'e' = { unit = '1', domain = 'e > 0', meaning = 'a number' }\n"
        "'n' = { unit = '1', domain = 'n > 0', meaning = 'another' }\n"
        "'l' = { definition = '2 e^2/(1 + e)', meaning = 'index' }\n"
        "'b' = { definition = '2 e^2/(1 + e)^2', meaning = 'best gain' }\n"
        "'m' = { definition = '2 n^2/(1 + n)^2', meaning = 'nominal gain' }\n"
        "'u' = { definition = 'm + 2 (l - 2 n^2/(1 + n))/((1 + n)(2 + n))', meaning = 'updated' }\n"
    )
    (verdict,) = judged(setting, ("inequality", r"u - b < b - m \quad (e > n)"))
    assert verdict.verdict == "conditional", verdict.reason
    assert verdict.repair is None, verdict.repair
