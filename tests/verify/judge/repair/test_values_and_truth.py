"""Printed numbers are rounded anew; where no misprint explains a formula, the true one is told."""

from __future__ import annotations

import math

import pytest
from claim_texts import MODELS, algebra, claim_file, judged, memory, steady

from gainproof.verify.judge.convention import Convention, conventions
from gainproof.verify.judge.reader.reader import read_formula
from gainproof.verify.judge.repair.formula_values import Values, values_at
from gainproof.verify.judge.repair.generic_points import free_points
from gainproof.verify.judge.repair.printed_formula import printed
from gainproof.verify.judge.repair.trivial_formulas import OffTheModel
from gainproof.verify.judge.scope import Scope


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


@pytest.mark.parametrize(
    ("printed_number", "expected"),
    [
        # (0.3 pi/180)^2 = 2.74156e-5 (mpmath): as many digits as are printed, at most two
        ("0.0052", "0.000027"),
        ("0.5", "0.00003"),
        ("0.0000283", "0.0000274"),
        ("0.000031", "0.000027"),
        ("17.25", "0.000027"),
    ],
)
def test_digits_are_not_lost(printed_number: str, expected: str) -> None:
    latex = rf"(0.3 \cdot \frac{{\pi}}{{180}})^2 \approx {printed_number}"
    (verdict,) = judged(algebra("'x' = { unit = '1', meaning = 'a number' }\n"), ("value", latex))
    assert verdict.verdict == "refuted"
    assert verdict.repair is not None
    assert verdict.repair["latex"].endswith(rf"\approx {expected}")


def test_the_true_formula_is_told_where_no_misprint_explains_a_claim() -> None:
    (verdict,) = judged(
        memory(1), ("identity", r"\beta = \frac{k^3 + 11}{k^4 + 7 k + 3} \quad (1 \le k)")
    )
    assert verdict.verdict in ("refuted", "conditional")
    assert verdict.repair is None
    assert "no misprint-like repair found; what is true is \\beta = \\frac{6}{" in verdict.reason


def test_what_holds_whatever_the_symbols_are_is_not_offered() -> None:
    setting = claim_file(steady("random-velocity"), [("identity", r"\alpha = \beta")]).settings["s"]
    (convention,) = conventions(setting, MODELS, {})
    assert isinstance(convention, Convention)
    scope = Scope(convention.setting, convention.environment)
    off = OffTheModel(scope, frozenset((r"\alpha", r"\beta")))
    for latex, expected in (
        (r"\alpha = \frac{\alpha \beta}{\beta}", True),
        (r"(\alpha + \beta)^2 = \alpha^2 + 2\alpha\beta + \beta^2", True),
        (r"\sqrt{\alpha^2} \ge 0", True),
        (r"\alpha(\alpha + \beta) = 2\beta", False),
        (r"\alpha > 0", False),
    ):
        reading = read_formula(latex, setting.symbols).readings[0]
        assert off.is_trivial(printed(reading)) is expected, latex


def test_arithmetic_in_print_is_repaired_too() -> None:
    (verdict,) = judged(memory(0), ("value", r"1030 - \frac{1}{2} (989 - 1030) = 1009.5"))
    assert verdict.verdict == "refuted"
    assert verdict.repair is not None
    assert "1030 + " in verdict.repair["latex"]


def test_formula_is_put_in_base_variables_once_for_all_points() -> None:
    found = claim_file(
        algebra("'x' = { unit = '1', domain = 'x > 0', meaning = 'a number' }\n"),
        [("identity", r"\exp(x) = \frac{\partial}{\partial x} \frac{x^2}{2}")],
    )
    (convention,) = conventions(found.settings["s"], MODELS, {})
    assert isinstance(convention, Convention)
    scope = Scope(convention.setting, convention.environment)
    scope.symbol("x")
    assert found.claims[0].formula is not None
    sides = printed(found.claims[0].formula.readings[0]).sides
    at = free_points(found.claims[0], (), scope, 3)
    assert len(at) == 3
    for values, point in zip(values_at(scope, at, {}), at, strict=True):
        (x,) = map(float, point.values())
        for side, expected in zip(sides, (math.exp(x), x), strict=True):
            found_here, alone = values.ball(side), Values(scope, point, {}).ball(side)
            assert found_here is not None
            assert abs(float(found_here.mid()) - expected) < 1e-12
            assert str(found_here) == str(alone)


@pytest.mark.parametrize(
    ("left", "wrong", "domain"),
    [
        (r"\frac{d \left|x\right|}{dx}", "2", ""),
        (r"\frac{d (\left|x\right| + x)}{dx}", "3", ""),
        (r"\frac{d \max(x, 0)}{dx}", "2", ""),
        (r"\frac{d (x^2/x)}{dx}", "2", "-1 < x < 1"),
        (r"\frac{d \left|x\right|}{dx}", "2", "-1 < x < 1"),
        (r"\left. \frac{d \left|x\right|}{dx} \right|_{x=0}", "0", ""),
    ],
)
def test_what_is_told_as_true_is_proved_in_the_place_of_the_claim(
    left: str, wrong: str, domain: str
) -> None:
    """Neither the value of one branch, nor a form that lacks a value in the domain."""
    stated = f"domain = '{domain}', " if domain else ""
    setting = algebra(f"'x' = {{ unit = '1', {stated}meaning = 'a number' }}\n")
    (verdict,) = judged(setting, ("identity", f"{left} = {wrong}"))
    assert verdict.verdict in ("refuted", "conditional")
    if verdict.truth is not None:
        (again,) = judged(setting, ("identity", verdict.truth))
        assert again.verdict == "proved"
