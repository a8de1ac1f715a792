"""Products up to a symbol: by induction, or for each whole number of a range."""

from __future__ import annotations

from fractions import Fraction
from math import prod

import pytest
from small_claims import check, judged

CONSTANT = r"\prod_{k=1}^{n} (1 - \frac{p}{k p + r})"
POSITIVE = r"n \geq 1, p > 0, r > 0"
EACH = r"\prod_{k=1}^{n} \frac{k}{k+1}"
TURNED = r"\prod_{k=1}^{n} (1 - \frac{k}{n+1}) = \prod_{k=1}^{n} \frac{k}{n+1}"
INVERSE = r"\prod_{k=1}^{n} (1 + \frac{1}{k}) \prod_{k=1}^{n} (1 - \frac{1}{k+1}) = 1"
ONES = r"\begin{pmatrix} 1 & %s \\ 0 & 1 \end{pmatrix}"


@pytest.mark.parametrize(
    ("claim", "domain", "wanted"),
    [
        # telescoping, also two or three factors a step, and from later first numbers
        (r"\prod_{k=1}^{n} (1 - \frac{1}{k+1}) = \frac{1}{n+1}", r"n \geq 1", "proved"),
        (r"\prod_{k=1}^{n} (1 - \frac{1}{k+1}) = \frac{1}{n+2}", r"n \geq 1", "refuted"),
        (r"\frac{1}{n+1} = \prod_{k=1}^{n} \frac{k}{k+1}", r"n \geq 0", "proved"),
        (r"\prod_{k=2}^{2n+1} (1 - \frac{1}{k^2}) = \frac{n+1}{2n+1}", r"n \geq 2", "proved"),
        (r"\prod_{k=2}^{2n+1} (1 - \frac{1}{k^2}) = \frac{n+1}{2n-1}", r"n \geq 2", "refuted"),
        (r"\prod_{k=2}^{3n} (1 - \frac{1}{k^2}) = \frac{3n+1}{6n}", r"n \geq 1", "proved"),
        (r"\prod_{k=3}^{n-1} \frac{k-1}{k} = \frac{2}{n-1}", r"n \geq 3", "proved"),
        # of a free letter: the gain of a constant, P_n/P_0 = R/(n P_0 + R)
        (rf"{CONSTANT} = \frac{{r}}{{n p + r}}", POSITIVE, "proved"),
        (rf"{CONSTANT} = \frac{{p}}{{n p + r}}", POSITIVE, "refuted"),
        (rf"n r {EACH} + r {EACH} = r", r"n \geq 1, r > 0", "proved"),
        (r"\prod_{k=1}^{n} a = a^n", r"n \geq 0", "proved"),
        (r"\prod_{k=1}^{n} a^2 x = a^{2n} x^n", r"n \geq 0", "proved"),
        (r"\prod_{k=0}^{n} (x - x k) = 0", r"n \geq 1", "proved"),
        # a factor without a value, in the middle, at the first number, and beyond the range
        (r"\prod_{k=1}^{n} (1 - \frac{1}{k-3}) = 0", r"n \geq 4", "refuted"),
        (r"\prod_{k=0}^{n} \frac{k-1}{k} = 0", r"n \geq 1", "refuted"),
        # zero is no hypothesis to divide by: true at the first number only
        (r"(n - 2) \prod_{k=1}^{n} k = 0", r"n \geq 2", "refuted"),
        (r"\prod_{k=1}^{n} k = 2^{n-1}", r"n \geq 1", "refuted"),
        # what no short induction shows
        (TURNED, r"n \geq 1", "undecided"),
        (r"\prod_{k=1}^{\infty} (1 + \frac{1}{k^2}) = a", r"a > 0", "undecided"),
        (r"\prod_{k=1}^{n} k \geq n", r"n \geq 1", "undecided"),
    ],
)
def test_product(claim: str, domain: str, wanted: str) -> None:
    kind = "inequality" if r"\geq" in claim else "identity"
    check(judged(kind, f"latex = '{claim}'\ndomain = '{domain}'"), wanted)


@pytest.mark.parametrize("last", [1, 2, 7, 20, 63])
@pytest.mark.parametrize("wrong", [False, True])
def test_every_number_of_a_range(last: int, wrong: bool) -> None:
    """The greatest of the values, from fractions, bounds all of them; a little less does not."""
    values = [
        prod((Fraction(k + n, 2 * n + 1) for k in range(1, n + 1)), start=Fraction(1))
        for n in range(1, last + 1)
    ]
    bound = max(values) - (Fraction(1, 10**6) if wrong else 0)
    product = r"\prod_{k=1}^{n} \frac{k+n}{2n+1}"
    fields = rf"latex = '{product} \leq \frac{{{bound.numerator}}}{{{bound.denominator}}}'"
    fields += f"\ndomain = '1 \\leq n \\leq {last}'"
    found = judged("inequality", fields)
    check(found, "refuted" if wrong else "proved")
    if wrong:
        assert found.witness is not None
        n = int(found.witness["point"].get("n", 1))
        assert values[n - 1] > bound


@pytest.mark.parametrize(
    ("kind", "claim", "domain", "wanted"),
    [
        ("identity", TURNED, r"1 \leq n \leq 12", "proved"),
        # n + 1 times 1/(n + 1)
        ("identity", INVERSE, r"1 \leq n \leq 12", "proved"),
        ("identity", INVERSE.replace("= 1", "= n"), r"1 \leq n \leq 12", "refuted"),
        (
            "inequality",
            r"\prod_{k=1}^{n} (1 + k x) \geq 1 + n x",
            r"1 \leq n \leq 9, x > 0",
            "proved",
        ),
        (
            "inequality",
            r"\prod_{k=1}^{n} (1 + k x) > 1 + n x",
            r"1 \leq n \leq 9, x > 0",
            "refuted",
        ),
        # sums: H_10 = 2.93, H_11 = 3.02, beyond the few numbers that any claim is tried at
        ("inequality", r"\sum_{k=1}^{n} \frac{1}{k} < 3", r"1 \leq n \leq 10", "proved"),
        ("inequality", r"\sum_{k=1}^{n} \frac{1}{k} < 3", r"1 \leq n < 12", "refuted"),
        ("inequality", r"\sum_{k=1}^{n} \frac{1}{k} < 3", r"1 \leq n < 11", "proved"),
        # 2^n > n^2 from 5 on
        ("inequality", "2^n > n^2", r"4 < n \leq 40", "proved"),
        ("inequality", "2^n > n^2", r"4 \leq n \leq 40", "refuted"),
        # functions of numbers: sin 14 = 0.9906, and cos 22 = -0.99996 is the least up to 40
        ("inequality", r"\sin(n) \leq 0.99", r"1 \leq n \leq 13", "proved"),
        ("inequality", r"\sin(n) \leq 0.99", r"1 \leq n \leq 20", "refuted"),
        ("inequality", r"\cos(n) > -0.9999", r"1 \leq n \leq 21", "proved"),
        ("inequality", r"\cos(n) > -0.9999", r"1 \leq n \leq 40", "refuted"),
        ("inequality", r"n e^{-n/9} \leq 3.311", r"1 \leq n \leq 30", "proved"),  # 9/e = 3.3109
        ("inequality", r"n e^{-n/9} \leq 3.31", r"1 \leq n \leq 30", "refuted"),
        # more than a few numbers, and none that is whole
        ("inequality", r"\sum_{k=1}^{n} \frac{1}{k} < 30", r"1 \leq n \leq 100", "undecided"),
    ],
)
def test_in_a_range(kind: str, claim: str, domain: str, wanted: str) -> None:
    check(judged(kind, f"latex = '{claim}'\ndomain = '{domain}'"), wanted)


def test_a_product_of_matrices_up_to_a_symbol_is_not_covered() -> None:
    claim = r"\prod_{k=1}^{n} " + ONES % "a" + " = " + ONES % "n a"
    check(judged("identity", claim), "undecided")
    # it is not the product of the entries
    squared = claim.replace("^{n}", "^{2}").replace("n a", "2 a")
    check(judged("identity", squared), "proved")
