"""Sums up to a symbol, series, integrals: true ones proved, false ones shown false at a point."""

from __future__ import annotations

import pytest
from small_claims import check, judged

INSIDE = "\ndomain = '0 < c < 1'"
POSITIVE = "\ndomain = 'a > 0'"
TRUE = [
    r"\sum_{i=0}^{n} i = \frac{n(n+1)}{2}",
    r"\sum_{i=1}^{n} i^2 = \frac{n(n+1)(2n+1)}{6}",
    (
        r"latex = '\sum_{i=k}^{n} (a i + b) = (n - k + 1) \left(a \frac{n + k}{2} + b\right)'"
        "\ndomain = 'k \\geq 0, n \\geq k'"
    ),
    r"3 + 2 \sum_{i=1}^{n} i^3 = 3 + \frac{n^2 (n+1)^2}{2}",
    r"\sum_{i=1}^{n} \sum_{j=1}^{i} j = \frac{n(n+1)(n+2)}{6}",
    r"\sum_{i=1}^{n} \frac{1}{i(i+1)} = \frac{n}{n+1}",
    r"latex = '\sum_{i=0}^{n} c^i = \frac{1 - c^{n+1}}{1 - c}'" + INSIDE,
    r"latex = '\sum_{i=1}^{n} i c^i = \frac{c (1 - (n+1) c^n + n c^{n+1})}{(1 - c)^2}'" + INSIDE,
    r"latex = '\sum_{i=0}^{\infty} a (1-a)^i = 1'" + "\ndomain = '0 < a < 2'",
    r"latex = '\sum_{i=0}^{\infty} a^2 (1-a)^{2i} = \frac{a}{2-a}'" + "\ndomain = '0 < a < 1'",
    r"latex = '\sum_{i=1}^{\infty} i^2 c^i = \frac{c (1 + c)}{(1 - c)^3}'" + INSIDE,
    r"\int_0^t x^2 \, dx = \frac{t^3}{3}",
    r"latex = '\int_0^t e^{-a x} \, dx = \frac{1 - e^{-a t}}{a}'" + POSITIVE,
    r"latex = '\int_0^t x e^{-a x} \, dx = \frac{1 - (1 + a t) e^{-a t}}{a^2}'" + POSITIVE,
    r"latex = '\int_0^\infty x e^{-a x} \, dx = \frac{1}{a^2}'" + POSITIVE,
    (
        r"\int_0^t \begin{pmatrix} x \\ 1 \end{pmatrix} \begin{pmatrix} x & 1 \end{pmatrix} q \, dx"
        r" = q \begin{pmatrix} \frac{t^3}{3} & \frac{t^2}{2} \\ \frac{t^2}{2} & t \end{pmatrix}"
    ),
]
FALSE = [
    r"\sum_{i=1}^{n} i^2 = \frac{n(n+1)(2n+1)}{3}",
    r"\sum_{i=0}^{n} i = \frac{n(n-1)}{2}",
    r"\sum_{i=1}^{n} \frac{1}{i(i+1)} = \frac{n+1}{n+2}",
    r"latex = '\sum_{i=0}^{n} c^i = \frac{1 - c^{n}}{1 - c}'" + INSIDE,
    r"latex = '\sum_{i=0}^{\infty} i c^i = \frac{c}{1 - c}'" + INSIDE,
    r"\int_0^t x^2 \, dx = \frac{t^3}{2}",
    r"latex = '\int_0^t x e^{-a x} \, dx = \frac{1 - e^{-a t}}{a^2}'" + POSITIVE,
]
LEFT_OPEN = [
    (r"\int_0^\infty x \, dx - \int_0^\infty x \, dx = 0", "does not decay"),
    (
        r"latex = '\int_0^\infty e^{-a x} \, dx = \frac{1}{a}'" + "\ndomain = 'a > -1'",
        "does not say that a > 0",
    ),
    (
        r"\int_0^\infty e^{(a^2 - 2 a + 1) x} \, dx = -\frac{1}{(a - 1)^2}",
        "without a value",
    ),
    (r"\int_0^\infty e^{(\frac{a}{a} - 1) x} \, dx = 1", "does not decay"),
    (r"latex = '\sum_{i=0}^{\infty} a (1-a)^i = 1'" + "\ndomain = '0 < a < 3'", "without a value"),
    (r"\sum_{i=0}^{x} i = \frac{x(x+1)}{2}", "no whole number"),
    (r"\int_0^t \frac{1}{x + 1} \, dx = t", "integral of anything but polynomials"),
    (r"\frac{d}{dn} \sum_{i=1}^{n} i = n + \frac{1}{2}", "with respect to n, which is a whole"),
    (
        r"latex = '\sum_{i=3}^{n} i = \frac{n(n+1)}{2} - 3'" + "\ndomain = 'n \\geq 0'",
        "turned round",
    ),
]


@pytest.mark.parametrize("fields", TRUE)
def test_true(fields: str) -> None:
    check(judged("identity", fields), "proved")


@pytest.mark.parametrize("fields", FALSE)
def test_false(fields: str) -> None:
    check(judged("identity", fields), "refuted")


@pytest.mark.parametrize(("fields", "why"), LEFT_OPEN)
def test_what_is_not_decided_says_why(fields: str, why: str) -> None:
    found = judged("identity", fields)
    check(found, "undecided")
    assert why in found.reason


def test_a_sum_begins_where_it_has_a_term() -> None:
    found = judged("identity", r"\sum_{i=3}^{n} i = \frac{n(n+1)}{2} - 3")
    check(found, "proved")
    assert found.domain is not None
    assert "n >= 3" in found.domain


@pytest.mark.alike
@pytest.mark.parametrize(
    ("latex", "domain"),
    [
        (r"\int_0^\infty e^{-a x} \, dx = \frac{1}{a}", "a > 0"),
        (r"\int_0^t e^{-a x} \, dx = \frac{1 - e^{-a t}}{a}", "a != 0"),
        (r"\int_{-\infty}^\infty e^{-a x^2} \, dx = \sqrt{\frac{\pi}{a}}", "a > 0"),
        (r"a \int_0^t \sin(a x) \, dx = 1 - \cos(a t)", "a != 0"),
        (r"\int_0^t \cos(a x) \sin(b x) \, dx = \int_0^t \sin(b x) \cos(a x) \, dx", "a + b != 0"),
        (r"\sum_{i=0}^\infty a^i = \frac{1}{1 - a}", "-1 < a < 1"),
        (r"\sum_{i=k}^{n} i = \frac{(n + k)(n - k + 1)}{2}", "n - k >= -1"),
    ],
)
def test_where_nothing_is_said_it_holds_where_it_has_a_value(latex: str, domain: str) -> None:
    found = judged("identity", latex)
    check(found, "proved")
    assert domain in str(found.domain)


@pytest.mark.parametrize(
    "latex",
    [
        r"\int_0^\infty e^{-a x} \, dx = \frac{2}{a}",
        r"\int_0^t e^{-a x} \, dx = \frac{1 - e^{a t}}{a}",
        r"\sum_{i=k}^{n} i = \frac{(n + k)(n - k)}{2}",
    ],
)
def test_where_nothing_is_said_the_false_is_refuted_where_it_has_a_value(latex: str) -> None:
    check(judged("identity", latex), "refuted")


def test_other_kinds_need_what_is_not_said() -> None:
    about = r"about = ['\int_0^\infty e^{-a x} \, dx', 'a']"
    found = judged("monotone", about + "\ntrend = 'decreasing'\ntext = 'in words'")
    check(found, "undecided")
    assert "does not say that a > 0" in found.reason
