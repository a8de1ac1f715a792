"""Minimum-variance gains: what a lecture prints is proved, false neighbours are refuted by a filter
that is better in plain numbers.
"""

from __future__ import annotations

import re
from fractions import Fraction

import pytest
from free_gains import predicted_covariance, radius, verdict
from small_claims import check

from gainproof.verify.judge.verdict import ClaimVerdict

TWO = r"\alpha = -\frac{\beta}{2} + \sqrt{\beta}"
FIRST = r"4\alpha\beta = \gamma(8 - 4\alpha - \beta)"
SECOND = (
    r"\beta^3 + 2(3\alpha - 8)\beta^2 + 4(3\alpha^2 - 12\alpha + 16)\beta"
    r" - 8\alpha^2(2 - \alpha) = 0"
)
THREE = rf"{FIRST} \\ {SECOND}"
EXPLICIT = (
    r"\alpha = 2\sqrt[3]{\gamma} - \sqrt[3]{\gamma}^2 + \frac{\gamma}{4} \\"
    r" \beta = \sqrt[3]{\gamma}^2 - \frac{\gamma}{2}"
)
LAG = {2: "e_{12}", 3: "e_{13}"}


def optimum(latex: str, states: int = 2, fixed: str = "") -> ClaimVerdict:
    fields = f"latex = '{latex}'\nminimised = 'p_{{11}}'\nfixed = ['{fixed or LAG[states]}']"
    return verdict("optimum", fields, states)


@pytest.mark.parametrize(
    ("latex", "states", "fixed"),
    [
        (TWO, 2, ""),
        (TWO, 2, r"\beta"),
        (r"(\alpha + \frac{\beta}{2})^2 = \beta", 2, ""),
        (THREE, 3, ""),
        (THREE, 3, r"\gamma"),
        (EXPLICIT, 3, ""),
    ],
)
def test_best_gains_are_proved(latex: str, states: int, fixed: str) -> None:
    check(optimum(latex, states, fixed), "proved")


@pytest.mark.parametrize(
    ("latex", "states"),
    [
        (TWO.replace("-\\frac", "\\frac"), 2),
        (TWO.replace("{2}", "{3}"), 2),
        (TWO.replace("\\sqrt{\\beta}", "\\sqrt{2\\beta}"), 2),
        (TWO.replace("+ \\sqrt", "- \\sqrt"), 2),
        (r"(\alpha + \frac{\beta}{2})^2 = 2\beta", 2),
        (r"\alpha(\alpha + \beta) = 2\beta", 2),
        (r"\alpha = \frac{1}{2}", 2),
        (FIRST, 3),
        (SECOND, 3),
        (EXPLICIT.replace("{4}", "{2}"), 3),
        (EXPLICIT.replace("- \\frac", "+ \\frac"), 3),
        (THREE.replace("8 - 4", "8 + 4"), 3),
        (THREE.replace("4\\alpha\\beta =", "2\\alpha\\beta ="), 3),
        (THREE.replace("- 8\\alpha^2", "- 4\\alpha^2"), 3),
        (THREE.replace("3\\alpha - 8", "3\\alpha + 8"), 3),
    ],
)
def test_others_are_refuted(latex: str, states: int) -> None:
    check(optimum(latex, states), "refuted")


def test_the_better_filter_is_better() -> None:
    found = optimum(r"\alpha(\alpha + \beta) = 2\beta")
    assert found.witness is not None
    stated = [float(Fraction(found.witness["point"][name])) for name in (r"\alpha", r"\beta")]
    told = dict(re.findall(r"(\\\w+) = ([0-9/]+)", found.witness["note"]))
    better = [float(Fraction(told[name])) for name in (r"\alpha", r"\beta")]
    assert stated[1] == better[1]
    assert max(radius(stated), radius(better)) < 1
    assert predicted_covariance(better)[0, 0] < predicted_covariance(stated)[0, 0]
    assert stated[0] * (stated[0] + stated[1]) == pytest.approx(2 * stated[1])


@pytest.mark.parametrize(
    ("fixed", "least"),
    [
        # another constraint, nothing that grows at the border, no minimum inside
        (r"\alpha", "p_{11}"),
        ("e_{12}", r"\alpha"),
        ("e_{12}", "B"),
        ("e_{12}", "p_{11} - B"),
        ("e_{10}", "p_{11}"),
        ("p_{11}", "p_{11}"),
    ],
)
def test_what_is_not_covered_is_not_proved(fixed: str, least: str) -> None:
    fields = f"latex = '{TWO}'\nminimised = '{least}'\nfixed = ['{fixed}']"
    assert verdict("optimum", fields).verdict == "undecided"
