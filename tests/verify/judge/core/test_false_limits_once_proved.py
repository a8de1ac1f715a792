"""False limits that once came out as proved: points that are never come near, conditions that tie
the variable to other symbols, parts without a value that an expansion cancels.
"""

from __future__ import annotations

import pytest
from small_claims import check, judged

SYMBOLS = {
    "m": "{ unit = '1', integer = true, domain = 'm >= 0', meaning = 'count' }",
    "p": "{ unit = '1', domain = 'p > 0', meaning = 'positive' }",
    "r": "{ unit = '1', domain = '0 <= r <= 1', meaning = 'in the unit interval' }",
    "s": "{ unit = '1', domain = '0 <= s <= 1', meaning = 'in the unit interval' }",
}
NEAR_ZERO = "\ndomain = '-1 < y < 1'"
FALSE = [
    # the point is never come near
    r"r^2 \to \infty \quad (r \to \infty)",
    r"r^2 + y \to \infty \quad (r \to \infty)",
    r"m^2 \to \infty \quad (m \to -\infty)",
    r"\lim_{n \to 1/2} n = 1/2",
    r"\lim_{n \to 1/2} n y = \frac{y}{2}",
    r"r \to p \quad (r \to p)",
    "latex = 'r + s \\to p + s \\quad (r \\to p)'\ngiven = ['p > 1']",
    # the other symbols are no constants
    *(
        r"latex = 'x + y \to y \quad (x \to 0)'" + f"\ngiven = ['{tie}']"
        for tie in ("y = x", "y = x + 1", "y^2 = x^2", r"(x - y)^2 \leq 0", "x y = 1")
    ),
    r"latex = 'x + y \to y \quad (x \to 0+)'" + "\ngiven = ['e^{-1/x} = 0']",
    # the conditions hold nowhere
    r"latex = 'x + y \to \infty \quad (x \to \infty)'" + "\ngiven = ['y^2 = -1']",
    r"latex = 'x^2 \to \infty \quad (x \to \infty)'" + "\ngiven = ['p < 0']",
    # a part has no value, everywhere or for y = 0
    r"\left(-\frac{1}{2}\right)^x \to 0 \quad (x \to \infty)",
    r"latex = 'y^x \to 0 \quad (x \to \infty)'" + NEAR_ZERO,
    r"\sqrt{-e^{-1/x}} \to 0 \quad (x \to 0+)",
    r"x y + \frac{0}{y - y} \to 0 \quad (x \to 0)",
    r"latex = 'x + \frac{1}{y} - \frac{1}{y} \to 0 \quad (x \to 0)'" + NEAR_ZERO,
    r"latex = 'x + \frac{y}{y} \to 1 \quad (x \to 0)'" + NEAR_ZERO,
    r"latex = '\frac{1}{x} + \frac{y}{y} \to \infty \quad (x \to 0+)'" + NEAR_ZERO,
    r"latex = 'x \log(y) - x \log(y) \to 0 \quad (x \to 0)'" + NEAR_ZERO,
]
FALSE_ORDERS = [
    r"latex = 'x + \frac{y}{y} = 1 + O(x) \quad (x \to 0)'" + NEAR_ZERO,
    r"latex = 'x + \frac{y}{y} - 1 \sim x \quad (x \to 0)'" + NEAR_ZERO,
    r"latex = 'x^2 = O(x) \quad (x \to 0)'" + "\ngiven = ['p = -1']",
    r"r \sim r + 1 \quad (r \to \infty)",
    r"n = O(n) \quad (n \to 0)",
]
TRUE = [
    r"r \to s \quad (r \to s)",
    r"r y \to s y \quad (r \to s)",
    r"m^2 \to \infty \quad (m \to \infty)",
    r"\left(-\frac{1}{2}\right)^n \to 0 \quad (n \to \infty)",
    r"\sqrt{e^{-1/x}} + y \to y \quad (x \to 0+)",
    "latex = 'x p \\to 0 \\quad (x \\to 0)'\ngiven = ['x < p']",
    "latex = 'x + y \\to y \\quad (x \\to 0)'\ngiven = ['y > x']",
    "latex = 'x + y \\to y \\quad (x \\to 0+)'\ngiven = ['x y \\geq 0']",
    r"x + \frac{1}{y} - \frac{1}{y} \to 0 \quad (x \to 0)",
]


@pytest.mark.parametrize("fields", FALSE)
def test_limit_is_not_proved(fields: str) -> None:
    found = judged("limit", fields, SYMBOLS)
    assert found.verdict in ("undecided", "conditional", "held"), found.reason


@pytest.mark.parametrize("fields", FALSE_ORDERS)
def test_order_is_not_proved(fields: str) -> None:
    found = judged("asymptotics", fields, SYMBOLS)
    assert found.verdict in ("undecided", "conditional"), found.reason


@pytest.mark.parametrize("fields", TRUE)
def test_the_true_neighbour_is_proved(fields: str) -> None:
    check(judged("limit", fields, SYMBOLS), "proved")


def test_where_a_part_has_no_value_is_said() -> None:
    found = judged("limit", r"x + \frac{1}{y} - \frac{1}{y} \to 0 \quad (x \to 0)", SYMBOLS)
    assert found.domain is not None
    assert "y < 0 or y > 0" in found.domain
