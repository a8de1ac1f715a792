"""One slip in a definition explains several claims: the definition is repaired, not the claims."""

from __future__ import annotations

import pytest
from claim_texts import MODELS, algebra, claim_file, judged, steady

from gainproof.verify.judge.judge import judge_file

HEAD = (
    "'a' = { unit = 'm s^-2', meaning = 'acceleration' }\n"
    "'v' = { unit = 'm s^-1', meaning = 'velocity' }\n"
    "'x' = { unit = 'm', meaning = 'position' }\n"
    "'T' = { unit = 's', meaning = 'interval' }\n"
)
CLAIMS = (
    ("identity", r"w - v = a T"),
    ("identity", r"T w - T v = a T^2"),
    ("identity", r"(w - v)^2 = a^2 T^2"),
)


def test_definition_is_repaired_by_what_the_claims_need() -> None:
    symbols = algebra(HEAD + "'w' = { definition = 'v - a T', meaning = 'velocity later' }\n")
    definition, *claims = judged(symbols, ("definition", "w = v - a T"), *CLAIMS[:2])
    assert definition.repair == {"latex": "w = v + a T", "verdict": "proved"}
    assert definition.verdict == "definition"
    for claim in claims:
        assert claim.verdict == "refuted"
        assert claim.repair is None
        assert "would be proved with w defined as w = v + a T" in claim.reason


ROW = "'M' = { definition = '(w, 1)', meaning = 'a row' }\n"
FUNCTION = (
    "'t' = { unit = 's', meaning = 'any time' }\n"
    "'f' = { definition = 'w t', arguments = ['t'], meaning = 'f' }\n"
)
MATRIX = "\\begin{pmatrix} w & 0 \\\\ 0 & T \\end{pmatrix}"


@pytest.mark.parametrize(
    ("more", "latex"),
    [
        ("", r"w (1, T) = (v + a T) (1, T)"),
        (ROW, r"M = (v + a T, 1)"),
        (f"'M' = {{ definition = '{MATRIX}', meaning = 'M' }}\n", r"\det M = v T + a T^2"),
        (FUNCTION, r"f(T) = v T + a T^2"),
        ("", r"\exp\left(\frac{w T}{x}\right) = \exp\left(\frac{v T + a T^2}{x}\right)"),
    ],
)
def test_what_values_do_not_decide_is_no_obstacle(more: str, latex: str) -> None:
    """A claim about a matrix, or one whose value the source's own definition gives."""
    head = algebra(HEAD + "'w' = { definition = 'v - a T', meaning = 'velocity later' }\n" + more)
    definition, *claims = judged(
        head, ("definition", "w = v - a T"), *CLAIMS[:2], ("identity", latex)
    )
    assert definition.repair == {"latex": "w = v + a T", "verdict": "proved"}
    for claim in claims:
        assert claim.verdict in ("refuted", "conditional"), claim.reason
        assert "would be proved" in claim.reason
        assert "with w defined as w = v + a T" in claim.reason


def test_a_claim_without_a_formula_is_no_obstacle() -> None:
    """The poles of a closed loop are claimed by a polynomial."""
    symbols = steady("random-velocity") + (
        "[settings.s.symbols]\n"
        "'g' = { definition = '2 - \\alpha + \\beta', meaning = 'trace of the closed loop' }\n"
        "'z' = { unit = '1', meaning = 'a pole' }\n"
    )
    claim = "[[claims]]\nid = '{}'\nplace = 'p'\nkind = '{}'\nsetting = 's'\n"
    more = claim.format("double", "identity") + "latex = '2 g = 4 - 2 \\alpha - 2 \\beta'\n"
    more += claim.format("roots", "location") + "variable = 'z'\n"
    more += "polynomial = 'z^2 - g z + 1 - \\alpha'\nwhere = 'inside the unit circle'\n"
    found = claim_file(symbols, [("identity", r"g = 2 - \alpha - \beta")], more)
    single, double, roots = judge_file(found, MODELS)
    assert roots.verdict == "refuted"
    for verdict in (single, double):
        assert "would be proved with g defined as g = 2 - \\alpha - \\beta" in verdict.reason


def test_dimensions_and_all_claims_have_to_agree() -> None:
    symbols = algebra(HEAD + "'w' = { definition = 'v + a', meaning = 'velocity later' }\n")
    definition, *claims = judged(symbols, ("definition", "w = v + a"), *CLAIMS)
    assert definition.verdict == "refuted"
    assert definition.repair == {"latex": "w = v + a T", "verdict": "proved"}
    assert [claim.repair for claim in claims] == [None] * 3


def test_a_claim_that_is_true_keeps_its_definition() -> None:
    symbols = algebra(HEAD + "'w' = { definition = 'v - a T', meaning = 'velocity later' }\n")
    verdicts = judged(symbols, *CLAIMS[:2], CLAIMS[2])
    # the square is true with either sign
    assert [v.verdict for v in verdicts] == ["refuted", "refuted", "proved"]
    assert all("would be proved with w" in v.reason for v in verdicts[:2])
    contrary = judged(symbols, *CLAIMS[:2], ("identity", "v - w = a T"))
    assert [v.verdict for v in contrary] == ["refuted", "refuted", "proved"]
    assert all("would be proved with w" not in v.reason for v in contrary)
    assert all(v.repair is not None for v in contrary[:2])


CARDANO = algebra(
    "'\\lambda' = { unit = '1', domain = '0 < \\lambda', meaning = 'tracking index' }\n"
    "'b' = { definition = '\\frac{\\lambda}{2} - 3', meaning = 'of the cubic' }\n"
    "'c' = { definition = '\\frac{\\lambda}{2} + 3', meaning = 'of the cubic' }\n"
    "'d' = { definition = '-1', meaning = 'of the cubic' }\n"
    "'p' = { definition = 'c - \\frac{b^2}{3}', meaning = 'of the reduced cubic' }\n"
    "'q' = { definition = '\\frac{2 b^3}{27} - \\frac{bc}{3} + d', meaning = 'of the other' }\n"
    "'v' = { definition = '\\sqrt{q^2 + \\frac{4 p^3}{27}}', meaning = 'root' }\n"
    "'z' = { definition = '-\\sqrt[3]{q + \\frac{v}{2}}', meaning = 'cube root, misprinted' }\n"
    "'s' = { definition = 'z - \\frac{p}{3z} - \\frac{b}{3}', meaning = 'root of the cubic' }\n"
)


def test_the_slightest_slip_in_a_chain_of_definitions() -> None:
    (verdict,) = judged(CARDANO, ("identity", "s^3 + b s^2 + c s + d = 0"))
    assert verdict.verdict == "refuted"
    told = verdict.certificate["repair of a definition"]
    assert told["latex"] == r"z = -\sqrt[3]{\frac{q + v}{2}}"
    # where the cubic has three real roots, the right formula has no real value either
    assert told["verdict"] == "conditional"
    assert "wherever they have a value" in verdict.reason
