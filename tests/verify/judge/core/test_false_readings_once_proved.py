"""False claims that once came out as proved because of what their symbols were taken for: terms of
sequences, recursions of other symbols, infinities, hypotheses that hold nowhere.
"""

from __future__ import annotations

import pytest
from small_claims import check, judged

NUMBER = "{ unit = '1', meaning = 'a number' }"
SYMBOLS = {
    **dict.fromkeys(("x_i", "x_k", "x_1", "p_k", "p_{k-1}", r"\bar{p}"), NUMBER),
    "p": "{ unit = '1', domain = 'p > 0', meaning = 'positive' }",
    "q": "{ unit = '1', domain = 'q > 0', meaning = 'positive' }",
    "c_k": "{ unit = '1', domain = 'c_k > 5', meaning = 'more than five' }",
    "c_{k-1}": NUMBER,
    "c": NUMBER,
    "f": "{ arguments = ['i'], definition = 'x_i', meaning = 'argument as index' }",
    "g": r"{ arguments = ['x_k'], definition = '\sum_{i=0}^{k} x_i', meaning = 'of a term' }",
    "h": r"{ arguments = ['n'], definition = '\sum_{i=0}^{n} i', meaning = 'of a count' }",
    "u": r"{ definition = '\sum_{i=0}^{k} x_i', meaning = 'a sum' }",
}
RULE = "\nprevious = 'p_{k-1}'\nrecursion = "
FALSE = [
    ("identity", r"\frac{\partial}{\partial x_k} \sum_{i=0}^{k} x_i^2 = 0"),
    ("identity", r"\frac{\partial}{\partial x_1} \sum_{i=0}^{2} x_i^2 = 0"),
    ("identity", r"\frac{\partial u}{\partial x_k} = 0"),
    ("identity", r"\left. u \right|_{x_k = 0} = u"),
    ("identity", r"\int_0^1 u \, dx_k = u"),
    ("identity", "g(0) = u"),
    ("limit", r"u \to u \quad (x_k \to 0)"),
    ("identity", "f(3) = x_i"),
    (
        "identity",
        r"latex = '\int_0^1 \left(\frac{x}{y}\right)^0 \, dx = 1'" + "\ndomain = 'y > -1'",
    ),
    ("identity", r"\int_0^\infty 1 \, dy - \int_1^\infty 1 \, dy = 1"),
    ("inequality", r"\int_0^\infty e^{-y} \, dy < 1"),
    ("inequality", r"\int_0^\infty e^{-y} \, dy \neq 1"),
    ("value", r"latex = 'p \approx 0.5'" + "\ngiven = ['p = 1/2', 'q = -1']"),
    ("value", r"latex = 'n \approx 0.5'" + "\ngiven = ['n = 1/2']"),
    ("value", r"latex = '\frac{1}{2} \approx 0.5'" + "\ngiven = ['q < 0']"),
    ("identity", "latex = 'x + 1 = 1 + x'\ngiven = ['q < 0']"),
    ("steady_state", f"latex = 'x = 3'{RULE}'p_k = 3'"),
    ("steady_state", f"latex = 'p = 3'{RULE}'p_k^2 = 3'"),
    ("steady_state", "latex = 'c = 3'\nprevious = 'c_{k-1}'\nrecursion = 'c_k = 3'"),
]
TRUE = [
    ("identity", "h(3) = 6"),
    ("identity", r"\int_0^\infty e^{-y} \, dy = 1"),
    ("identity", r"\int_0^1 x^0 \, dx = 1"),
    ("value", r"latex = 'p \approx 0.5'" + "\ngiven = ['p = 1/2', 'q = 1']"),
    ("value", r"latex = 'n \approx 2.0'" + "\ngiven = ['n = 2']"),
    ("steady_state", f"latex = 'p = 3'{RULE}'p_k = 3'"),
    ("steady_state", rf"latex = '\bar{{p}} = 3'{RULE}'p_k = 3'"),
    ("steady_state", "latex = 'c = 6'\nprevious = 'c_{k-1}'\nrecursion = 'c_k = 6'"),
]


@pytest.mark.parametrize(("kind", "fields"), FALSE)
def test_is_not_proved(kind: str, fields: str) -> None:
    found = judged(kind, fields, SYMBOLS)
    assert found.verdict in ("undecided", "conditional", "refuted"), found.reason


@pytest.mark.parametrize(("kind", "fields"), TRUE)
def test_the_true_neighbour_is_proved(kind: str, fields: str) -> None:
    check(judged(kind, fields, SYMBOLS), "proved")
