"""What docs/conventions-and-repairs.md says of the points at which a formula is judged."""

from __future__ import annotations

import pytest
from small_claims import judged

CLAIMS = [
    (r"\frac{x}{x} = 1", "", "proved", "for x < 0 or x > 0"),
    (r"\frac{x}{x} = 1", r"x \geq 0", "conditional", "for x > 0"),
    (r"\frac{x}{x} = 1", "x > 0", "proved", "for x > 0"),
    (r"\sqrt{x} \sqrt{y} = \sqrt{x y}", "", "proved", "for x >= 0, y >= 0"),
    (r"\sqrt{x} \sqrt{y} = \sqrt{x y}", "x < 1, y < 1", "conditional", ""),
    (r"\sqrt{x^2} = x", "", "conditional", "for x >= 0"),
    (r"x^{1/3} x^{1/3} x^{1/3} = x", "", "proved", "for all real x"),
    (r"(-8)^{1/3} = -2", "", "proved", ""),
    (r"x^{2/6} = x^{1/3}", "", "proved", ""),
    (r"x^0 = 1", "", "proved", ""),
    (r"0^0 = 0", "", "refuted", ""),
    (r"\frac{1}{0} = \frac{1}{0}", "", "refuted", ""),
    (r"\sqrt{-1} = \sqrt{-1}", "", "refuted", ""),
    (r"\frac{1}{x - x} = 1", "", "undecided", ""),
    (r"\frac{1}{x - x} = 1", "x > 0", "refuted", ""),
]


@pytest.mark.parametrize(("latex", "domain", "verdict", "where"), CLAIMS)
def test_values_decide_where(latex: str, domain: str, verdict: str, where: str) -> None:
    stated = f"\ndomain = '{domain}'" if domain else ""
    found = judged("identity", f"latex = '{latex}'{stated}", {})
    assert found.verdict == verdict, found.reason
    if where:
        assert found.domain == where


CONVERGENT = [
    (r"\int_0^\infty e^{-x/a} dx = a", "-(1 / a) < 0"),
    (r"a^2 \int_0^\infty e^{-a^2 x} dx = 1", "a^2 > 0"),
    (r"\int_0^\infty e^{-a^3 x} dx = a^{-3}", "a^3 > 0"),
    (r"\int_0^\infty e^{-x/(a - 1)} dx = a - 1", "-(1 / (a - 1)) < 0"),
    (r"\int_0^\infty \frac{1}{a} e^{-x/a} \cos(w x) dx = \frac{1}{1 + w^2 a^2}", "-(1 / a) < 0"),
    (r"\int_0^\infty e^{-a x} dx = 1/a", "a > 0"),
]


@pytest.mark.parametrize(("latex", "where"), CONVERGENT)
def test_where_an_integral_converges_is_told(latex: str, where: str) -> None:
    found = judged("identity", f"latex = '{latex}'", {})
    assert found.verdict == "proved", found.reason
    assert found.domain is not None
    assert where in found.domain
