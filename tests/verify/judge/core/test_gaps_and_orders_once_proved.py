"""False claims that once came out as proved: a quantity that jumps over a pole is no measure, a
domain stated in any form is stated, a root without value is not real, an order on the left counts.
Beside them the true ones that must stay proved.
"""

from __future__ import annotations

import pytest
from small_claims import check, judged

P = "{ unit = '1', domain = 'p > 0', meaning = 'positive' }"
SYMBOLS = {
    "p": P,
    "u": r"{ definition = '\frac{1}{x}', meaning = 'with a pole between its branches' }",
    "v": r"{ definition = '\frac{1}{p}', meaning = 'one branch of it' }",
    "w": r"{ definition = '\sqrt{x}', meaning = 'a root' }",
    "h": "{ unit = '1', domain = 'h^2 < 4', meaning = 'between -2 and 2' }",
}
JUMPS = [
    ("monotone", "about = ['x', 'u']\ntrend = 'decreasing'\ntext = 'in words'"),
    ("monotone", "about = ['x^3', 'u']\ntrend = 'decreasing'\ntext = 'in words'"),
    ("limit", r"\frac{x}{1 + \left|x\right|} \to -1 \quad (u \to 0)"),
    ("limit", r"x \to -\infty \quad (u \to 0)"),
]
NO_JUMPS = [
    ("monotone", "about = ['x', 'u']\ntrend = 'decreasing'\ntext = 'in words'\ndomain = 'x > 0'"),
    ("monotone", "about = ['x', 'u']\ntrend = 'decreasing'\ntext = 'in words'\ndomain = 'x > p'"),
    ("monotone", "about = ['x', 'w']\ntrend = 'increasing'\ntext = 'in words'\ndomain = 'x >= 0'"),
    ("limit", r"p \to \infty \quad (v \to 0)"),
]
OUTSIDE = [
    r"latex = '\sqrt{x}^2 = x'" + "\ndomain = 'x^2 < 4'",
    r"latex = '\sqrt{x}^2 = x'" + "\ngiven = ['x^2 < 4']",
    r"\sqrt{x}^2 = x \quad (x^2 < 4)",
    r"\sqrt{h}^2 = h",
    r"latex = '\sqrt{x} \sqrt{y} = \sqrt{x y}'" + "\ndomain = 'x y > 0'",
    r"latex = '\frac{z}{z} = 1'" + "\ndomain = 'z > x'",
    r"latex = '\sqrt{x}^2 = x'" + "\ndomain = 'x \\neq 0'",
]
INSIDE = [
    r"latex = '\frac{z}{z} = 1'" + "\ndomain = 'z > x^2'",
    r"latex = '\frac{z}{z} = 1'" + "\ndomain = 'y > x'",
    r"latex = '\frac{x}{x} = 1'" + "\ndomain = 'x \\neq 0'",
    r"latex = '\frac{x^2 - y^2}{x - y} = x + y'" + "\ndomain = 'x \\neq y'",
    r"latex = '\sqrt{x - y}^2 = x - y'" + "\ndomain = 'x > y'",
    # where nothing is said, a formula is claimed where it has a value
    r"\sqrt{x}^2 = x",
]
DERIVATIVES = [
    r"latex = '\frac{d}{d x} x^{3/2} = \frac{3}{2} \sqrt{x}'" + "\ndomain = 'x >= 0'",
    r"latex = '\frac{d}{d x} (x^2)^{3/2} = 3 x \left|x\right|'" + "\ndomain = '-1 < x < 1'",
]


@pytest.mark.parametrize(("kind", "fields"), JUMPS)
def test_what_jumps_is_no_measure(kind: str, fields: str) -> None:
    assert judged(kind, fields, SYMBOLS).verdict != "proved"


@pytest.mark.parametrize(("kind", "fields"), NO_JUMPS)
def test_what_moves_one_way_is(kind: str, fields: str) -> None:
    check(judged(kind, fields, SYMBOLS), "proved")


@pytest.mark.parametrize("fields", OUTSIDE)
def test_a_domain_that_is_no_simple_bound_is_stated(fields: str) -> None:
    check(judged("identity", fields, SYMBOLS), "conditional")


@pytest.mark.parametrize("fields", INSIDE)
def test_true_on_such_a_domain(fields: str) -> None:
    check(judged("identity", fields, SYMBOLS), "proved")


@pytest.mark.parametrize("root", [r"\sqrt{1 - x^2}", r"\frac{1}{x}"])
@pytest.mark.parametrize("where", ["real", "equal"])
def test_one_root_without_value_is_nowhere(root: str, where: str) -> None:
    fields = f"latex = 'z = {root}'\nwhere = '{where}'\ndomain = "
    check(judged("location", f"{fields}'-2 < x < 2'", SYMBOLS), "conditional")
    check(judged("location", f"{fields}'0 < x < 1'", SYMBOLS), "proved")


@pytest.mark.parametrize(
    ("latex", "true"),
    [
        (r"x + O(x) = x + O(x^3) \quad (x \to 0)", False),
        (r"O(x^2) = O(x) \quad (x \to \infty)", False),
        (r"O(x^2) = O(x) \quad (x \to 0)", True),
        (r"x + O(x^3) = \sin x \quad (x \to 0)", True),
    ],
)
def test_an_order_on_the_left_is_of_that_on_the_right(latex: str, true: bool) -> None:
    assert (judged("asymptotics", latex).verdict == "proved") == true


@pytest.mark.parametrize("fields", DERIVATIVES)
def test_a_slope_that_is_zero_with_its_base(fields: str) -> None:
    check(judged("identity", fields), "proved")


@pytest.mark.parametrize(("domain", "true"), [("q < 0", False), ("q > 0", True)])
def test_a_model_outside_of_its_domain_is_none(domain: str, true: bool) -> None:
    symbols = {
        "q": f"{{ unit = 'm^2', domain = '{domain}', meaning = 'intensity' }}",
        "r": "{ unit = 'm^2', domain = 'r > 0', meaning = 'variance' }",
        "P": "{ quantity = 'predicted_covariance.1.1', meaning = 'covariance' }",
    }
    matrices = "transition = [['1']]\nprocess_noise = [['q']]\nmeasurement = [['1']]"
    setting = f"kind = 'steady_state'\n{matrices}\nmeasurement_noise = [['r']]"
    assert (judged("inequality", "P > 0", symbols, setting).verdict == "proved") == true


@pytest.mark.parametrize(
    ("fields", "true"),
    [
        (
            r"latex = '\left. \sum_{i=0}^\infty x^i \right|_{x=2} = -1'" + "\ndomain = 'x^2 < 1'",
            False,
        ),
        (r"latex = '\left. \int_0^\infty e^{-p t} \, dt \right|_{p=-1} = -1'", False),
        (r"\left. \sum_{i=1}^n i \right|_{n=-5} = 10", False),
        (r"\left. \sum_{i=1}^n i \right|_{n=1/2} = \frac{3}{8}", False),
        (r"\left. \sum_{i=1}^n i \right|_{n=3} = 6", True),
        (
            r"latex = '\left. \sum_{i=0}^\infty x^i \right|_{x=1/2} = 2'" + "\ndomain = 'x^2 < 1'",
            True,
        ),
    ],
)
def test_a_closed_form_is_not_put_beyond_its_sum(fields: str, true: bool) -> None:
    assert (judged("identity", fields, {"p": P}).verdict == "proved") == true
