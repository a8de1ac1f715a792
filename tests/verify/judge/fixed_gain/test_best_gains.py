"""Minimum-variance gains: what a lecture prints is proved, false neighbours are refuted by a filter
that is better in plain numbers.
"""

from __future__ import annotations

import re
from fractions import Fraction

import pytest
from free_gains import predicted_covariance, radius, verdict
from one_of_each import further
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
        further(TWO.replace("{2}", "{3}"), 2),
        further(TWO.replace("\\sqrt{\\beta}", "\\sqrt{2\\beta}"), 2),
        further(TWO.replace("+ \\sqrt", "- \\sqrt"), 2),
        (r"(\alpha + \frac{\beta}{2})^2 = 2\beta", 2),
        (r"\alpha(\alpha + \beta) = 2\beta", 2),
        (r"\alpha = \frac{1}{2}", 2),
        (FIRST, 3),
        further(SECOND, 3),
        (EXPLICIT.replace("{4}", "{2}"), 3),
        (EXPLICIT.replace("- \\frac", "+ \\frac"), 3),
        further(THREE.replace("8 - 4", "8 + 4"), 3),
        further(THREE.replace("4\\alpha\\beta =", "2\\alpha\\beta ="), 3),
        further(THREE.replace("- 8\\alpha^2", "- 4\\alpha^2"), 3),
        further(THREE.replace("3\\alpha - 8", "3\\alpha + 8"), 3),
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
        (r"\alpha", "p_{11}"),
        ("e_{10}", "p_{11}"),
        ("p_{11}", "p_{11}"),
    ],
)
def test_what_is_not_covered_is_not_proved(fixed: str, least: str) -> None:
    fields = f"latex = '{TWO}'\nminimised = '{least}'\nfixed = ['{fixed}']"
    assert verdict("optimum", fields).verdict == "undecided"


SMOOTHED = r"\alpha = \frac{\sqrt{\beta}(2 + \sqrt{\beta})}{2(1 + \sqrt{\beta})}"
FAST = r"\alpha = \frac{\sqrt{\beta}(2 - \sqrt{\beta})}{2(\sqrt{\beta} - 1)}"


def compared(latex: str, least: str, domain: str = "") -> ClaimVerdict:
    fields = f"latex = '{latex}'\nminimised = '{least}'\nfixed = ['e_{{12}}']"
    return verdict("optimum", f"{fields}\ndomain = '{domain}'" if domain else fields)


@pytest.mark.parametrize(
    ("latex", "least", "domain", "wanted"),
    [
        # the smoothed variance has no minimum at one lag, and another formula beyond it
        (SMOOTHED, "s_{11}", r"\beta < 2", "proved"),
        further(SMOOTHED, r"\sqrt{s_{11}}", r"\beta < 2", "proved"),
        (SMOOTHED, "s_{11}", r"\beta \leq 2", "conditional"),
        further(SMOOTHED, "s_{11}", "", "conditional"),
        (FAST, "s_{11}", r"\beta > 2", "proved"),
        (FAST, "s_{11}", "", "conditional"),
        (TWO, "p_{11} - B", "", "proved"),
        # stable, but others are better
        (TWO, "s_{11}", r"\beta < 2", "refuted"),
        (SMOOTHED.replace("2(1", "3(1"), "s_{11}", r"\beta < 2", "refuted"),
        (SMOOTHED.replace("(2 +", "(2 -"), "s_{11}", r"\beta < 2", "refuted"),
        further(
            r"\alpha = \frac{\sqrt{\beta^2 + 16\beta} - \beta}{4}",
            "s_{11}",
            r"\beta < 2",
            "refuted",
        ),
        (SMOOTHED, "-s_{11}", r"\beta < 2", "refuted"),
        # as good as all others, so not the only one
        (SMOOTHED, "0", r"\beta < 2", "refuted"),
        further(SMOOTHED, "B", r"\beta < 2", "refuted"),
        (TWO, r"\alpha", "", "refuted"),
        # the domain says which filters of a lag are meant, or admits no lag
        (SMOOTHED, "s_{11}", r"\alpha < 1", "undecided"),
        (SMOOTHED, "s_{11}", r"\beta > 5", "undecided"),
    ],
)
def test_gains_compared_with_all_others(latex: str, least: str, domain: str, wanted: str) -> None:
    found = compared(latex, least, domain)
    assert found.verdict == wanted, found.reason
    if wanted == "conditional":
        limits = "0 < \\beta < 2" if latex == SMOOTHED else "2 < \\beta < 4"
        assert limits in (found.domain or "")


def test_the_better_smoother_is_better() -> None:
    found = compared(TWO, "s_{11}", r"\beta < 2")
    assert found.witness is not None
    alpha, beta = (float(Fraction(found.witness["point"][x])) for x in (r"\alpha", r"\beta"))
    stated = beta**0.5 - beta / 2
    smoothed = [
        (1 - a) ** 2 * predicted_covariance([a, beta])[0, 0] + a**2 for a in (alpha, stated)
    ]
    assert max(radius([alpha, beta]), radius([stated, beta])) < 1
    assert smoothed[0] < smoothed[1]
