"""Asymptotics: the order of the error, and leading terms."""

from __future__ import annotations

import pytest
from small_claims import check, judged

SMALL = "\\quad (x \\to 0)'\ndomain = 'a > 0'"
WIDER = "\\quad (x \\to 0)'\ndomain = 'a > -1'"
RIGHT = r"\sqrt{(a + x p)^2 + (b + x q)^2} = \sqrt{a^2 + b^2}"
FALLING = r"\frac{4 n - 2}{n (n+1)}"


@pytest.mark.alike
@pytest.mark.parametrize(
    ("fields", "wanted"),
    [
        (r"\sqrt{1 + x} = 1 + \frac{x}{2} + O(x^2) \quad (x \to 0)", "proved"),
        (r"\sqrt{1 + x} = 1 + \frac{x}{2} - \frac{x^2}{8} + O(x^3) \quad (x \to 0)", "proved"),
        # true to order 2, and no further
        (r"\sqrt{1 + x} = 1 + \frac{x}{2} + O(x^3) \quad (x \to 0)", "refuted"),
        (r"\sqrt{1 + x} = 1 + \frac{x}{3} + O(x^2) \quad (x \to 0)", "refuted"),
        (r"latex = '\sqrt{a^2 + x} = a + \frac{x}{2 a} + O(x^2) " + SMALL, "proved"),
        (r"latex = '\sqrt{a^2 + x} = a + \frac{x}{a} + O(x^2) " + SMALL, "refuted"),
        (r"\sqrt{a^2 + x} = a + \frac{x}{2 a} + O(x^2) \quad (x \to 0)", "undecided"),
        # where the right side has a value, the root stands over something positive
        (RIGHT + r" + \frac{a p + b q}{\sqrt{a^2 + b^2}} x + O(x^2) \quad (x \to 0)", "proved"),
        (RIGHT + r" + \frac{a p - b q}{\sqrt{a^2 + b^2}} x + O(x^2) \quad (x \to 0)", "refuted"),
        (RIGHT + r" + \frac{a p + b q}{\sqrt{a^2 + b^2}} x + O(x^3) \quad (x \to 0)", "refuted"),
        (r"\frac{x}{\sqrt{a^2 + x b}} = \frac{x}{\sqrt{a^2}} + O(x^2) \quad (x \to 0)", "proved"),
        # at a = b = 0 it is false, and there both sides have values
        (RIGHT + r" + O(x^2) \quad (x \to 0)", "undecided"),
        (r"\sqrt{a^2 + x} = \sqrt{a^2} + O(x) \quad (x \to 0)", "undecided"),
        # at a = 0 they have no values, and that is in a domain that is stated
        (r"\frac{x + x^2}{a} = \frac{x}{a} + O(x^2) \quad (x \to 0)", "proved"),
        ("latex = '" + r"\frac{x + x^2}{a} = \frac{x}{a} + O(x^2) " + SMALL, "proved"),
        ("latex = '" + r"\frac{x + x^2}{a} = \frac{x}{a} + O(x^2) " + WIDER, "conditional"),
        (r"\sqrt{-1 - a^2 + x} = \sqrt{-1 - a^2} + O(x) \quad (x \to 0)", "undecided"),
        (FALLING + r"\sim \frac{4}{n} \quad (n \to \infty)", "proved"),
        (FALLING + r"\sim \frac{2}{n} \quad (n \to \infty)", "refuted"),
        (FALLING + r"\sim \frac{2}{n^2} \quad (n \to \infty)", "refuted"),
        # the ratio tends to 1, and the term that is printed is none of the expansion
        (r"\sqrt{1 + x} \approx 1 + x \quad (x \to 0)", "refuted"),
        (r"\cos x \approx 1 - x^2 \quad (x \to 0)", "refuted"),
        (r"\sqrt{x^2 + x} \approx x + 1 \quad (x \to \infty)", "refuted"),
        (r"\sqrt{x^2 + x} \sim x + 1 \quad (x \to \infty)", "proved"),
        (r"\sqrt{x^2 + x} \approx x + \frac{1}{2} \quad (x \to \infty)", "proved"),
        (r"\sqrt{1 + x} \approx 1 + \frac{x}{2} \quad (x \to 0)", "proved"),
        (r"\sqrt{1 + x} \approx 1 - (-\frac{x}{2} + \frac{x^2}{8}) \quad (x \to 0)", "proved"),
        (r"\sqrt{1 + x} \approx 1 - (-\frac{x}{2} + \frac{x^2}{4}) \quad (x \to 0)", "refuted"),
        # a product is what it is multiplied out
        (r"\sqrt{1 + x} \approx \frac{2 + x}{2} \quad (x \to 0)", "proved"),
        (r"\sqrt{1 + x} \approx \frac{2 + 2 x}{2} \quad (x \to 0)", "refuted"),
        (r"\sqrt{1 + x} \approx (1 + x)(1 - x) \quad (x \to 0)", "refuted"),
        (r"\sqrt{1 + x} \approx 1 + x (\frac{1}{2} + x) \quad (x \to 0)", "refuted"),
        (r"\sin x \approx x (1 - \frac{x^2}{6}) \quad (x \to 0)", "proved"),
        (r"\sin x \approx x (1 - \frac{x^2}{3}) \quad (x \to 0)", "refuted"),
        # a function has terms without end, and to which of them is not said
        (r"\sqrt{1 + x} \approx \frac{1}{1 - x/2} \quad (x \to 0)", "proved"),
        (r"\sqrt{1 + x} \approx \frac{1}{1 + x} \quad (x \to 0)", "undecided"),
        (r"\sqrt{1 + x} \sim \frac{1}{1 + x} \quad (x \to 0)", "proved"),
        # nor in a sum that hides it
        (r"e^{2x} \approx 1 + e^{3x} - 1 \quad (x \to 0)", "undecided"),
        (r"1 + x + 9 x^2 \approx 1 + \frac{x}{1 - x} \quad (x \to 0)", "undecided"),
        (r"1 + 3 x \approx 2 x + e^x \quad (x \to 0)", "proved"),
        (r"\frac{1}{x} + 1 \approx \frac{1}{x} + e^x - x \quad (x \to 0)", "proved"),
        (r"\frac{x}{1 + x} \approx x \quad (x \to 0)", "proved"),
        (r"\sqrt{a^2 x^2 + x^3} \approx \sqrt{a^2 x^2} \quad (x \to 0+)", "undecided"),
        (FALLING + r"= \frac{4}{n} + O(\frac{1}{n^2}) \quad (n \to \infty)", "proved"),
        (FALLING + r"= \frac{4}{n} + O(\frac{1}{n^3}) \quad (n \to \infty)", "refuted"),
        ("latex = '\\sin x = x \\quad (x \\to 0)'\norder = 3", "proved"),
        ("latex = '\\sin x = x \\quad (x \\to 0)'\norder = 4", "refuted"),
        (r"\sqrt{x} = O(x) \quad (x \to 0)", "refuted"),
        (r"\sqrt{x} \sim x \quad (x \to 0)", "refuted"),
        (r"x = O(\sin x) \quad (x \to 0)", "proved"),
    ],
)  # fmt: skip
def test_order(fields: str, wanted: str) -> None:
    check(judged("asymptotics", fields), wanted)
