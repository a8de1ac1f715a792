"""Printed numbers: the exact value against the interval of the digits shown."""

from __future__ import annotations

import pytest
from small_claims import check, judged

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


@pytest.mark.parametrize("shown", ["0.3821", "0.3818"])
def test_a_witness_shows_the_exact_value_and_the_number_printed(shown: str) -> None:
    found = judged("value", rf"latex = 'x \approx {shown}'{ROOT}1'")
    check(found, "refuted")
    assert found.witness is not None
    assert found.witness["left"]["midpoint"].startswith("0.38196")
    assert found.witness["right"]["midpoint"] == shown
