"""Steady quantities have a value where the filter is stable, in claims of every kind."""

from __future__ import annotations

import pytest
from free_gains import TWO, verdict
from small_claims import judged

INSIDE = "wherever the filter is stable"


@pytest.mark.parametrize(
    ("kind", "fields", "wanted"),
    [
        (
            "limit",
            r"latex = 'p_{11} \to \infty \quad (\beta \to 4 - 2\alpha)'|\alpha < 2",
            "proved",
        ),
        ("limit", r"latex = 'p_{11} \to 0 \quad (\beta \to 4 - 2\alpha)'|\alpha < 2", "refuted"),
        ("monotone", r"about = ['p_{11}', '\beta']|trend = 'increasing'", "proved"),
        ("monotone", r"about = ['p_{11}', '\alpha']|trend = 'increasing'", "conditional"),
        ("monotone", r"about = ['p_{22}', '\beta']|trend = 'decreasing'", "refuted"),
        ("inequality", r"latex = 's_{11} < p_{11}'", "proved"),
        ("inequality", r"latex = 's_{11} > p_{11}'", "refuted"),
        ("inequality", r"latex = 's_{11} < B'", "conditional"),
    ],
)
def test_claims_of_other_kinds(kind: str, fields: str, wanted: str) -> None:
    first, _, more = fields.partition("|")
    second = f"domain = '{more}'" if kind == "limit" else more
    found = verdict(kind, f"{first}\n{second}")
    assert found.verdict == wanted, found.reason
    if wanted in ("proved", "conditional"):
        assert found.domain is not None
        assert INSIDE in found.domain


@pytest.mark.parametrize(
    "fields",
    [
        # true of the formula, which is no variance there
        r"latex = 'p_{11} < 0'|domain = '\alpha > 2'",
        r"latex = 'p_{11} = -\frac{23}{9} B'|given = ['\alpha = 3', '\beta = 1']",
        r"latex = 'e_{12} = -a_c T^2'|given = ['\alpha = 1', '\beta = -1']",
    ],
)
def test_formulas_beyond_stability_are_not_proved(fields: str) -> None:
    first, _, second = fields.partition("|")
    kind = "inequality" if "<" in first else "identity"
    assert verdict(kind, f"{first}\n{second}").verdict == "undecided"


PREDICTOR = {
    **TWO,
    r"\alpha": "{ quantity = 'gain.1', meaning = 'gain of the position' }",
    r"\beta": "{ quantity = 'gain.2', meaning = 'gain of the velocity' }",
}


@pytest.mark.parametrize(
    ("gain", "latex", "wanted"),
    [
        ("filter", r"e_{12} = \frac{a_c}{\beta} T^2", "proved"),
        ("predictor", r"e_{12} = \frac{a_c}{\beta} T^2", "proved"),
        ("filter", r"f_{12} = (1 - \alpha) \frac{a_c}{\beta} T^2", "proved"),
        # the first gain of the predictor is alpha + beta
        ("predictor", r"f_{12} = (1 - \alpha) \frac{a_c}{\beta} T^2", "refuted"),
        ("predictor", r"f_{12} = (1 - \alpha + \beta) \frac{a_c}{\beta} T^2", "proved"),
        ("search", r"f_{12} = (1 - \alpha + \beta) \frac{a_c}{\beta} T^2", "proved"),
    ],
)
def test_conventions_of_gains(gain: str, latex: str, wanted: str) -> None:
    setting = f"kind = 'fixed_gain'\nstates = 2\ngain = '{gain}'"
    found = judged("identity", latex, PREDICTOR, setting)
    assert found.verdict == wanted, found.reason
    if gain == "search":
        assert "predictor" in (found.convention or "")
