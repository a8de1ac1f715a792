"""Sums and powers have no divisors but those that are written: x^0 is 1, and the slope of x^n at 0
is that of the power rule. Expected verdicts by hand.
"""

from __future__ import annotations

import pytest
from small_claims import check, judged

UNIT, WIDE = r"0 \leq x < 1", "-1 < x < 2"


@pytest.mark.parametrize(
    ("latex", "domain", "wanted"),
    [
        # only the first term is left where the base is 0
        (r"\sum_{j=1}^{\infty} x^{j-1} = \frac{1}{1-x}", UNIT, "proved"),
        (r"\sum_{j=1}^{\infty} x (1-x)^{j-1} = 1", r"0 < x \leq 1", "proved"),
        (r"\sum_{j=1}^{\infty} j x^{j-1} = \frac{1}{(1-x)^2}", UNIT, "proved"),
        (r"\sum_{j=3}^{\infty} x^{2j-6} = \frac{1}{1-x^2}", UNIT, "proved"),
        (r"\sum_{j=1}^{\infty} (x y)^{j-1} = \frac{1}{1-xy}", rf"{UNIT}, 0 \leq y < 1", "proved"),
        (
            r"\sum_{j=1}^{\infty} x^{j-1} \sum_{j=1}^{\infty} y^{j-1} = \frac{1}{(1-x)(1-y)}",
            rf"{UNIT}, 0 \leq y < 1",
            "proved",
        ),
        (r"\sum_{j=k}^{\infty} x^{j-k} = \frac{1}{1-x}", rf"{UNIT}, k \geq 1", "proved"),
        (r"\sum_{j=k}^{\infty} x^{j-1} = \frac{x^{k-1}}{1-x}", rf"{UNIT}, k \geq 1", "proved"),
        (r"x + \sum_{j=1}^{\infty} x^{j-1} = 1", r"0 \leq x \leq 0", "proved"),
        (r"x + \sum_{j=1}^{\infty} x^{j-1} = 0", r"0 \leq x \leq 0", "refuted"),
        # here the first term is 1/x
        (r"\sum_{j=0}^{\infty} x^{j-1} = \frac{1}{x(1-x)}", UNIT, "conditional"),
        (r"\sum_{j=1}^{\infty} x^{j-2} = \frac{1}{x(1-x)}", UNIT, "conditional"),
        # finite ones
        (r"(1-x) \sum_{k=0}^{j-1} x^k = 1 - x^j", rf"{WIDE}, j \geq 1", "proved"),
        (r"\sum_{k=1}^{j} x^{k-1} (1-x) = 1 - x^j", rf"{WIDE}, j \geq 1", "proved"),
        (r"x \sum_{k=1}^{j} x^{k-1} = \sum_{k=1}^{j} x^k", rf"{WIDE}, j \geq 1", "proved"),
        (r"\sum_{k=1}^{j} x^{k-1} = 1 - x^j", rf"{WIDE}, j \geq 1", "refuted"),
        (r"\frac{d}{dx} \sum_{k=1}^{4} x^{k-1} = 1 + 2x + 3x^2", UNIT, "proved"),
        # the power rule
        (r"\frac{d x^n}{dx} = n x^{n-1}", r"0 \leq x < 2, n \geq 3", "proved"),
        (r"\frac{d x^n}{dx} = n x^{n-1}", rf"{WIDE}, n \geq 1", "proved"),
        (r"\frac{d (y x^n)}{dx} = n y x^{n-1}", rf"{WIDE}, n \geq 1", "proved"),
        (r"\frac{d^2 x^n}{dx^2} = n (n-1) x^{n-2}", rf"{WIDE}, n \geq 2", "proved"),
        (r"\frac{d x^n}{dx} = n x^n", rf"{WIDE}, n \geq 2", "refuted"),
        (r"x \frac{d x^n}{dx} = n x^n", rf"{WIDE}, n \geq 1", "proved"),
        (r"\frac{d x^0}{dx} = 0", WIDE, "proved"),
        # 0 x^(-1) at n = 0
        (r"n x^{n-1} x = n x^n", rf"{WIDE}, n \geq 0", "refuted"),
        (r"n x^{n-1} x = n x^n", rf"{WIDE}, n \geq 1", "proved"),
    ],
)
def test_verdicts(latex: str, domain: str, wanted: str) -> None:
    check(judged("identity", f"latex = '{latex}'\ndomain = '{domain}'"), wanted)


@pytest.mark.parametrize(
    "latex",
    [
        r"\sum_{k=0}^{j-1} x^{j-1-k} (1-x) = 1 - x^j",
        r"\sum_{k=0}^{j-1} x^k y^{j-1-k} (x-y) = x^j - y^j",
        r"\sum_{k=0}^{j-1} \frac{x}{j - k} = \sum_{k=0}^{j-1} \frac{x}{k + 1}",
    ],
)
def test_the_term_after_the_last_one_is_not_asked_for(latex: str) -> None:
    """It would be 1/x at j = 1, or x/0; these are true and need not be proved."""
    found = judged("identity", f"latex = '{latex}'\ndomain = '{WIDE}, -1 < y < 2, j \\geq 1'")
    assert found.verdict not in ("refuted", "conditional"), found.reason


@pytest.mark.parametrize("low", ["k", "k+1", "n"])
@pytest.mark.parametrize(
    "latex",
    [
        r"\sum_{j=LOW}^{2n} \frac{1}{j} > 0",
        r"\sum_{j=LOW}^{2n} \sqrt{j} \sqrt{j} = \sum_{j=LOW}^{2n} j",
        r"\sum_{j=LOW}^{2n} \ln j \geq 0",
        r"\sum_{j=LOW}^{2n} \frac{j}{j} = \sum_{j=LOW}^{2n} 1",
    ],
)
def test_the_index_of_a_sum_is_no_symbol_of_a_witness(latex: str, low: str) -> None:
    """True: all terms have values from k >= 1 on, though 1/j has none at j = 0."""
    fields = f"latex = '{latex.replace('LOW', low)}'\ndomain = '1 \\leq k \\leq n'"
    assert judged(
        "inequality" if ">" in latex or "geq" in latex else "identity", fields
    ).verdict in (
        "proved",
        "held",
        "undecided",
    )
