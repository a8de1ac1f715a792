"""Each kind of misprint in a true formula is undone, and the repair is the formula it was."""

from __future__ import annotations

from collections.abc import Mapping
from typing import Any

import pytest
from claim_texts import algebra, judged, memory, steady

from gainproof.verify.judge.verdict import ClaimVerdict

RV, RA = steady("random-velocity"), steady("random-acceleration")
LINE = memory(1)
LENGTHS = algebra(
    "'x' = { unit = 'm', meaning = 'position' }\n"
    "'v' = { unit = 'm s^-1', meaning = 'velocity' }\n"
    "'a' = { unit = 'm s^-2', meaning = 'acceleration' }\n"
    "'T' = { unit = 's', meaning = 'interval' }\n"
    "'w' = { definition = 'v + a T', meaning = 'velocity later' }\n"
    "'y' = { definition = 'x + v T + \\frac{a T^2}{2}', meaning = 'position later' }\n"
)
NOISE = algebra(
    "'s' = { unit = '1', domain = 's > 0', meaning = 'deviation' }\n"
    "'w' = { unit = '1', variance = 's^2', distribution = 'normal', meaning = 'noise' }\n"
)
MEAN = r"\mathbb{E} [ \cos ( w ) ] = \exp ( -\frac{s^{2}}{2} )"


def repair(
    setting: str, latex: str, kind: str = "identity"
) -> tuple[ClaimVerdict, str, Mapping[str, Any]]:
    (verdict,) = judged(setting, (kind, latex))
    assert verdict.verdict in ("refuted", "conditional"), verdict.reason
    assert verdict.repair is not None, verdict.reason
    assert verdict.repair["verdict"] == "proved"
    told = verdict.repairs[0]
    assert told["changes"]
    return verdict, verdict.repair["latex"].replace("\\left", "").replace("\\right", ""), told


@pytest.mark.alike
@pytest.mark.parametrize(
    ("setting", "latex", "expected"),
    [
        # sign
        (RV, r"\alpha(\alpha - \beta) = 2\beta", r"\alpha ( \alpha + \beta ) = 2 \beta"),
        (RV, r"\beta = \frac{\alpha^2}{2 + \alpha}", r"\beta = \frac{\alpha^{2}}{2 - \alpha}"),
        # operator
        (RV, r"\alpha (\alpha \beta) = 2\beta", r"\alpha ( \alpha + \beta ) = 2 \beta"),
        (RA, r"(\alpha + 2\beta)^2 = 2\beta", r"( \alpha + \frac{\beta}{2} )^{2} = 2 \beta"),
        # bracket
        (RV, r"\alpha \alpha + \beta = 2\beta", r"\alpha ( \alpha + \beta ) = 2 \beta"),
        (RV, r"\beta = \frac{\alpha^2}{2} - \alpha", r"\beta = \frac{\alpha^{2}}{2 - \alpha}"),
        (
            RA,
            r"\alpha + (\frac{\beta}{2})^2 = 2\beta",
            r"( \alpha + \frac{\beta}{2} )^{2} = 2 \beta",
        ),
        (
            RA,
            r"\alpha = \sqrt{2} \beta - \frac{\beta}{2}",
            r"\alpha = \sqrt{2 \beta} - \frac{\beta}{2}",
        ),
        # exponent: one more, lost
        (RV, r"\beta = \frac{\alpha^3}{2 - \alpha}", r"\beta = \frac{\alpha^{2}}{2 - \alpha}"),
        (RV, r"\beta = \frac{\alpha}{2 - \alpha}", r"\beta = \frac{\alpha^{2}}{2 - \alpha}"),
        # symbol for symbol
        (RV, r"\beta = \frac{\beta^2}{2 - \alpha}", r"\beta = \frac{\alpha^{2}}{2 - \alpha}"),
        # number, factor two
        (RV, r"\alpha(\alpha + \beta) = 3\beta", r"\alpha ( \alpha + \beta ) = 2 \beta"),
        (RA, r"(\alpha + \beta)^2 = 2\beta", r"( \alpha + \frac{\beta}{2} )^{2} = 2 \beta"),
        (
            LINE,
            r"\alpha = \frac{2(2k + 1)}{(k + 1)(k + 20)} \quad (1 \le k)",
            r"\alpha = \frac{2 ( 2 k + 1 )}{( k + 1 ) ( k + 2 )} \quad ( 1 \le k )",
        ),
        # dropped term, too many
        (RV, r"\alpha \alpha = 2\beta - \beta", r"\alpha \alpha = 2 \beta - \beta \alpha"),
        (LENGTHS, r"y = x + \frac{a T^2}{2} + v", r"y = x + \frac{a T^{2}}{2} + v T"),
        # a sample later
        (
            LINE,
            r"\beta = \frac{6}{k (k + 1)} \quad (1 \le k)",
            r"\beta = \frac{6}{( k + 1 ) ( k + 2 )} \quad ( 1 \le k )",
        ),
        # a variance printed for its root
        (
            RA,
            r"\Lambda = \frac{\beta^2}{1 - \alpha}",
            r"\Lambda^{2} = \frac{\beta^{2}}{1 - \alpha}",
        ),
        # inside an exponent: a factor two, a sign
        (NOISE, r"E[\cos w] = e^{-s^2}", MEAN),
        (NOISE, r"E[\cos w] = e^{s^2/2}", MEAN),
        # dimensions say what is missing
        (LENGTHS, r"w - v = a", r"w - v = a T"),
    ],
)
def test_nearest_true_formula(setting: str, latex: str, expected: str) -> None:
    _, found, _ = repair(setting, latex)
    assert " ".join(found.split()) == expected


@pytest.mark.parametrize(
    ("kind", "latex", "expected"),
    [
        ("inequality", r"\alpha > 1", r"\alpha < 1"),
        ("inequality", r"\beta \le 0", r"\beta > 0"),
        ("inequality", r"\beta < \frac{\alpha^2}{2}", r"\beta > \frac{\alpha^{2}}{2}"),
        ("inequality", r"2 < \beta", r"2 > \beta"),
        ("limit", r"\alpha \to 1 \quad (\Lambda \to 0)", r"\alpha \to 0 \quad ( \Lambda \to 0 )"),
    ],
)
def test_other_kinds(kind: str, latex: str, expected: str) -> None:
    _, found, _ = repair(RV, latex, kind)
    assert " ".join(found.split()) == expected


def test_slips_in_conditions() -> None:
    verdict, found, _ = repair(LINE, r"\beta = \frac{6}{(k+1)(k+2)} \quad (0 \le k)")
    assert verdict.verdict == "conditional"
    assert found.endswith(r"\quad ( 0 < k )")


def test_bounds_that_nothing_comes_near_are_not_offered() -> None:
    verdict, _, _ = repair(RV, r"\alpha > 1", "inequality")
    assert verdict.repair == {"latex": r"\alpha < 1", "verdict": "proved"}
    assert len(verdict.repairs) == 1


def test_repair_of_a_repair_is_nothing() -> None:
    verdict, _, _ = repair(RV, r"\beta = \frac{\alpha^2}{2 + \alpha}")
    assert verdict.repair is not None
    (again,) = judged(RV, ("identity", verdict.repair["latex"]))
    assert again.verdict == "proved"
    assert again.repair is None


@pytest.mark.parametrize(
    "latex", [r"\Lambda = \alpha + \beta", r"\alpha = \frac{7 - \Lambda^5}{11 + \Lambda}"]
)
def test_no_near_repair_is_said(latex: str) -> None:
    (verdict,) = judged(RA, ("identity", latex))
    assert verdict.verdict in ("refuted", "conditional")
    assert verdict.repair is None
    assert "no misprint-like repair found" in verdict.reason


def test_two_slips_are_named() -> None:
    _, found, told = repair(RA, r"\alpha = \sqrt{\beta} - \frac{\beta}{3}")
    assert found == r"\alpha = \sqrt{2 \beta} - \frac{\beta}{2}"
    assert len(told["changes"]) == 2


@pytest.mark.parametrize(
    ("latex", "expected"),
    [
        # a factor, a power of a symbol, a number, an exponent that no list of slips holds
        (r"7 \alpha(\alpha + \beta) = 5\beta", r"7 \alpha ( \alpha + \beta ) = 14 \beta"),
        (r"\beta = \frac{\alpha^7}{2 - \alpha}", r"\beta = \frac{\alpha^{2}}{2 - \alpha}"),
        (r"\alpha = 2\beta - \alpha\beta", r"\alpha^{2} = 2 \beta - \alpha \beta"),
        (r"\alpha^2 = 2\beta - 35\alpha\beta", r"\alpha^{2} = 2 \beta - \alpha \beta"),
    ],
)
def test_what_would_make_it_true_is_solved_for(latex: str, expected: str) -> None:
    _, found, _ = repair(RV, latex)
    assert " ".join(found.split()) == expected


def test_true_claims_have_no_repair() -> None:
    (verdict,) = judged(RV, ("identity", r"\alpha(\alpha + \beta) = 2\beta"))
    assert verdict.verdict == "proved"
    assert verdict.repair is None
