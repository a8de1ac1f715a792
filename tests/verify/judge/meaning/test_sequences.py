"""Sums over symbols with an index: terms of a sequence, a recursion against its batch."""

from __future__ import annotations

import pytest
from small_claims import check, judged

from gainproof.verify.judge.explanation import sections

NUMBER = "{ unit = '1', meaning = 'a term' }"
SYMBOLS = {
    **dict.fromkeys(("x_i", "x_k", "x_{k-1}", "x_1", "x_2"), NUMBER),
    "m_k": r"{ definition = '\frac{1}{k} \sum_{i=1}^{k} x_i', meaning = 'mean' }",
    "m_{k-1}": r"{ definition = '\frac{1}{k-1} \sum_{i=1}^{k-1} x_i', meaning = 'mean before' }",
    "z_i": "{ unit = '1', domain = 'z_i > 0', meaning = 'positive terms' }",
    "w_i": "{ unit = '1', variance = 'q', meaning = 'noises' }",
    "s_i": "{ definition = 'x_i + 1', meaning = 'uses the index' }",
}
LATER = "\ndomain = 'k \\geq 2'"
TRUE = [
    r"\sum_{i=1}^{k} x_i = \sum_{i=1}^{k-1} x_i + x_k",
    r"\sum_{i=1}^{k} x_i = \sum_{i=1}^{k-2} x_i + x_{k-1} + x_k",
    r"\sum_{i=1}^{2} x_i = x_1 + x_2",
    r"\sum_{i=1}^{2} x_i^2 = x_1^2 + x_2^2",
    r"\sum_{i=1}^{k} (a x_i + 1) = a \sum_{i=1}^{k} x_i + k",
    r"latex = 'm_k = m_{k-1} + \frac{1}{k} (x_k - m_{k-1})'" + LATER,
    r"latex = 'm_k = \frac{k-1}{k} m_{k-1} + \frac{x_k}{k}'" + LATER,
]
FALSE = [
    r"\sum_{i=1}^{2} x_i = x_1 - x_2",
    r"\sum_{i=1}^{k} x_i = \sum_{i=1}^{k-1} x_i - x_k",
    r"\sum_{i=1}^{k} x_i^2 = \left(\sum_{i=1}^{k} x_i\right)^2",
    r"latex = 'm_k = m_{k-1} + \frac{1}{k-1} (x_k - m_{k-1})'" + LATER,
    r"latex = 'm_k = m_{k-1} + \frac{1}{k} (x_{k-1} - m_{k-1})'" + LATER,
]


@pytest.mark.parametrize("fields", TRUE)
def test_true(fields: str) -> None:
    check(judged("recursion", fields, SYMBOLS), "proved")


@pytest.mark.parametrize("fields", FALSE)
def test_false(fields: str) -> None:
    check(judged("recursion", fields, SYMBOLS), "refuted")


@pytest.mark.parametrize(
    ("latex", "why"),
    [
        (r"\sum_{i=1}^{2} z_i = 2", "a domain of its own"),
        (r"E\left[\sum_{i=1}^{2} w_i\right] = 0", "a noise"),
        (r"\sum_{i=1}^{2} s_i = 2", "a symbol with that index"),
    ],
)
def test_what_is_no_plain_sequence_is_left_open(latex: str, why: str) -> None:
    found = judged("identity", latex, SYMBOLS)
    check(found, "undecided")
    assert why in found.reason


@pytest.mark.parametrize(
    "latex", [r"\sum_{i=1}^{3} x_i = 3", r"\sum_{i=1}^{k} x_i = 3", r"\sum_{i=3}^{4} x_i^2 > 0"]
)
def test_terms_that_a_sum_makes_are_shown_as_the_source_writes_them(latex: str) -> None:
    """No symbol x_3 is declared: the variable for it is made when the sum is written out."""
    found = judged("inequality" if ">" in latex else "identity", latex, SYMBOLS)
    assert found.witness is not None
    assert {"x_1", "x_3"} & set(found.witness["point"])
    assert "free " not in f"{found.reason} {found.domain} {found.witness}"


def test_a_proof_speaks_of_sums_and_terms_as_the_source_does() -> None:
    """The index of a sum is no variable of the claim, so its domain is none of the claim's."""
    latex = r"\frac{\sum_{i=1}^{k} x_i}{x_k} = \frac{\sum_{i=1}^{k-1} x_i}{x_k} + 1"
    found = judged("identity", latex, SYMBOLS)
    assert found.domain == "k >= 2, k an integer, where every part has a value"
    shown = " ".join(line for section in sections(found.certificate) for line in section.lines)
    assert "call" not in shown
    assert "/ x_k" in shown
