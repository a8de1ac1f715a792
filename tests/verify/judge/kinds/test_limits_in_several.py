"""Limits with other symbols in them, at infinity, from one side, of exponentials and powers."""

from __future__ import annotations

import pytest
from small_claims import check, judged

NOISES = "\ndomain = 'q > 0, r > 0'"
ABOVE = "\ndomain = 'a > 0'"
GAIN = r"\frac{-q + \sqrt{q^2 + 4 q r}}{2 r}"


@pytest.mark.parametrize(
    ("fields", "wanted"),
    [
        (r"\frac{a x + b}{x} \to a \quad (x \to \infty)", "proved"),
        (r"\frac{a x + b}{x} \to b \quad (x \to \infty)", "refuted"),
        (r"latex = '\lim_{r \to 0} \frac{q}{q + r} = 1'" + NOISES, "proved"),
        (rf"latex = '\lim_{{q \to 0}} {GAIN} = 0'" + NOISES, "proved"),
        (rf"latex = '\lim_{{r \to \infty}} {GAIN} = 0'" + NOISES, "proved"),
        (rf"latex = '\lim_{{r \to 0}} {GAIN} = 1'" + NOISES, "proved"),
        (rf"latex = '\lim_{{r \to 0}} {GAIN} = 2'" + NOISES, "refuted"),
        (r"\lim_{x \to 0} \frac{\sin x}{x} = 1", "proved"),
        (r"\lim_{x \to 0} \frac{\sin (a x)}{x} = a", "proved"),
        (r"\lim_{x \to 0} \frac{1 - \cos x}{x^2} = 1", "refuted"),
        (r"\lim_{x \to 0} \sqrt{x} = 0", "proved"),
        (r"\lim_{x \to 0} \frac{\left|x\right|}{x} = 1", "refuted"),
        (r"latex = '\lim_{x \to 0} \frac{\left|x\right|}{x} = 1'" + "\ndomain = 'x > 0'", "proved"),
        (r"latex = '\lim_{x \to a} \sqrt{a - x} = 0'" + "\ndomain = 'x < a'", "proved"),
        (r"latex = '\lim_{n \to \infty} c^n = 0'" + "\ndomain = '0 < c < 1'", "proved"),
        (r"latex = '\lim_{n \to \infty} n^2 c^n = 0'" + "\ndomain = '-1 < c < 1'", "proved"),
        (r"latex = '\lim_{n \to \infty} c^n = 0'" + "\ndomain = 'c > 0'", "undecided"),
        (r"latex = '\lim_{x \to \infty} x e^{-a x} = 0'" + "\ndomain = 'a > 0'", "proved"),
        (r"\lim_{n \to \infty} (1 + \frac{x}{n})^n = e^x", "proved"),
        (r"\lim_{n \to \infty} (1 + \frac{x}{n})^n = e^{2x}", "refuted"),
        (r"latex = '\lim_{x \to \infty} \frac{x^2}{x + a} = \infty'" + ABOVE, "proved"),
        # between whole numbers a power of a negative number has no value
        (r"latex = '\lim_{x \to \infty} c^x = 0'" + "\ndomain = '-1 < c < 1'", "undecided"),
        # which sign decides is left open by the domain
        (r"\lim_{x \to \infty} a x = \infty", "undecided"),
    ],
)  # fmt: skip
def test_limit(fields: str, wanted: str) -> None:
    check(judged("limit", fields), wanted)
