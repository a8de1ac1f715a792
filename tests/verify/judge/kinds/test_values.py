"""Printed numbers: the exact value against the interval of the digits shown."""

from __future__ import annotations

import re

import pytest
from small_claims import check, judged

from gainproof.verdicts.verdict_reason import reasons

ROOT = "\ngiven = ['x^2 = 3x - 1']\ndomain = '0 < x < "


@pytest.mark.parametrize(
    ("fields", "wanted"),
    [
        (r"\frac{3 - \sqrt{5}}{2} \approx 0.382", "proved"),
        (r"\frac{3 - \sqrt{5}}{2} \approx 0.3820", "proved"),
        (r"\frac{3 - \sqrt{5}}{2} \approx 0.3819", "refuted"),
        (r"\frac{3 - \sqrt{5}}{2} = 0.4", "proved"),
        # a tie is rounded away from zero or to the even digit
        (r"\frac{1}{8} \approx 0.12", "proved"),
        (r"\frac{1}{8} \approx 0.13", "proved"),
        (r"\frac{1}{8} \approx 0.14", "refuted"),
        (r"\frac{3}{4} \approx 0.7", "refuted"),
        (r"\frac{3}{4} \approx 0.8", "proved"),
        (r"-\frac{3}{4} \approx -0.7", "refuted"),
        (r"-\frac{3}{4} \approx -0.8", "proved"),
        (r"\frac{13}{20} \approx 0.6", "proved"),
        (r"\frac{13}{20} \approx 0.7", "proved"),
        (r"-\frac{13}{20} \approx -0.6", "proved"),
        (r"\frac{1}{2} \approx 0", "proved"),
        (r"\frac{1}{2} \approx 1", "proved"),
        (r"\frac{3}{2} \approx 1", "refuted"),
        (r"-\frac{3}{2} \approx -1", "refuted"),
        (r"\frac{a}{4} \approx 0.7 \quad (a = 3)", "refuted"),
        ("latex = 'x \\approx 0.7'\ngiven = ['16 x^2 = 9']\ndomain = 'x > 0'", "refuted"),
        ("latex = 'x \\approx 0.8'\ngiven = ['16 x^2 = 9']\ndomain = 'x > 0'", "proved"),
        (r"\frac{1}{8} \approx 1.25 \times 10^{-1}", "proved"),
        (r"e^{-1} \approx 0.368", "proved"),
        (r"e^{-1} \approx 0.367", "refuted"),
        (r"\frac{a^2}{2 - a} \approx 0.1667 \quad (a = \frac{1}{2})", "proved"),
        (r"\frac{a^2}{2 - a} \approx 0.1666 \quad (a = \frac{1}{2})", "refuted"),
        (r"latex = 'x \approx 0.382'" + ROOT + "1'", "proved"),
        # the other root lies in the domain too
        (r"latex = 'x \approx 0.382'" + ROOT + "4'", "refuted"),
    ],
)
def test_value(fields: str, wanted: str) -> None:
    check(judged("value", fields), wanted)


@pytest.mark.parametrize(
    ("fields", "value", "digits"),
    [
        (r"\frac{3}{4} \approx 0.7", "0.75", "0.7 +/- 0.05"),
        (r"-\frac{3}{4} \approx -0.7", "-0.75", "-0.7 +/- 0.05"),
        (r"(\frac{1}{2}, \frac{3}{4}) \approx (0.5, 0.7)", "0.75", "0.7 +/- 0.05"),
        (r"\frac{a}{b} \approx 0.7 \quad (a = 3, b = 4)", "0.75", "0.7 +/- 0.05"),
    ],
)
def test_a_tie_that_is_not_rounded_so_is_not_told_as_equal(
    fields: str, value: str, digits: str
) -> None:
    found = judged("value", fields)
    check(found, "refuted")
    assert f"left {value} +/- 0, right {digits}" in found.reason
    assert "equal" not in found.reason


@pytest.mark.parametrize(
    ("latex", "domain", "told"),
    [
        (r"0.7 \approx \frac{3}{4}", "", "left 0.7 +/- 0.05, right 0.75 +/- 0"),
        (r"0.4 = \sqrt{2}", "", "left 0.4 +/- 0.05, right 1.41421"),
        (r"\sqrt{2} = 0.4", "", "left 1.4142135623730950488 +/- 2e-19, right 0.4 +/- 0.05"),
        (r"0.2 = x", r"0 \leq x \leq 1", "left 0.2 +/- 0.05, right "),
        (r"\frac{x}{x} = 1.0", "-1 < x < 1", "left no value (a divisor is zero), right 1.0 +/- "),
        (r"1.0 = \frac{x}{x}", "-1 < x < 1", "left 1.0 +/- 0.05, right no value (a divisor"),
    ],
)
def test_a_witness_has_the_sides_of_the_formula(latex: str, domain: str, told: str) -> None:
    found = judged("value", f"latex = '{latex}'" + f"\ndomain = '{domain}'" * bool(domain))
    assert found.verdict in ("refuted", "conditional"), found.reason
    assert told in found.reason


@pytest.mark.parametrize("shown", ["0.3821", "0.3818"])
def test_a_witness_shows_the_exact_value_and_the_number_printed(shown: str) -> None:
    found = judged("value", rf"latex = 'x \approx {shown}'{ROOT}1'")
    check(found, "refuted")
    assert found.witness is not None
    assert found.witness["left"]["midpoint"].startswith("0.38196")
    assert found.witness["right"]["midpoint"] == shown


@pytest.mark.parametrize(
    ("latex", "exact"),
    [
        (r"\frac{5}{9} = 0.5556", "5/9"),
        (r"0.5556 = \frac{5}{9}", "5/9"),
        (r"-\frac{2}{3} = -0.667", "-2/3"),
        (r"\sqrt{2} = 1.41", "the other side"),
        (r"\frac{x}{x + 1} = 0.67 \quad (x = 2)", "2/3"),
    ],
)
def test_a_decimal_after_an_equality_is_said_to_be_exact_or_rounded(latex: str, exact: str) -> None:
    (number,) = re.findall(r"-?\d\.\d+", latex)
    found = judged("identity", latex)
    assert (found.verdict, found.reading) == ("refuted", f"{number} is an exact number")
    note = found.certificate["as a rounded number"]
    assert note == f"{exact} rounded to these digits: a claim of kind value has it"
    assert note in reasons(found.to_json())
    found = judged("value", latex)
    assert (found.verdict, found.reading) == ("proved", f"{number} is rounded to its digits")


@pytest.mark.parametrize(
    ("kind", "latex", "verdict", "reading"),
    [
        ("identity", r"\frac{1}{2} = 0.5", "proved", "0.5 is an exact number"),
        ("identity", r"\frac{5}{9} = 0.57", "refuted", "0.57 is an exact number"),
        ("identity", "x - x = 0", "proved", None),
        ("value", r"\frac{5}{9} \approx 0.556", "proved", None),
    ],
)
def test_no_rounded_number_where_there_is_none(
    kind: str, latex: str, verdict: str, reading: str | None
) -> None:
    found = judged(kind, latex)
    assert (found.verdict, found.reading) == (verdict, reading)
    assert "as a rounded number" not in found.certificate


@pytest.mark.parametrize(
    ("latex", "left", "right"),
    [
        (r"\frac{3}{4} \approx 0.7", 0.75, 0.7),
        (r"0.7 \approx \frac{3}{4}", 0.7, 0.75),
        (r"-\frac{3}{4} \approx -0.7", -0.75, -0.7),
        (r"\frac{3 x}{4 x} \approx 0.7", 0.75, 0.7),
        (r"\frac{3}{2} \approx 1", 1.5, 1),
    ],
)
def test_at_a_tie_the_sides_are_the_value_and_the_number_as_printed(
    latex: str, left: float, right: float
) -> None:
    found = judged("value", latex)
    check(found, "refuted")
    assert found.witness is not None
    sides = [float(found.witness[side]["midpoint"]) for side in ("left", "right")]
    assert sides == [left, right]
    # said of sides only that are one number
    assert "exact" not in found.witness
    assert not any("both sides" in text for text in reasons(found.to_json()))
