"""Names bound by functions, sums and derivatives hide the symbols of the same name, in definitions
too.
"""

from __future__ import annotations

import pytest
from small_claims import check, judged

SYMBOLS = {
    "f": r"{ arguments = ['x'], definition = '\frac{\partial}{\partial x} (x^2)', meaning = 'f' }",
    "g_1": "{ arguments = ['x'], definition = 'x + w_1', meaning = 'uses w' }",
    "w_1": "{ definition = 'x + 1', meaning = 'uses x' }",
    "q_1": "{ definition = 'i + 1', meaning = 'uses i' }",
    "r_1": "{ arguments = ['a'], definition = 'a i', meaning = 'uses i' }",
    "s_1": r"{ arguments = ['n'], definition = '\sum_{i=1}^{n} i', meaning = 'a sum' }",
    "h_1": "{ arguments = ['y'], definition = 'f(y) + y', meaning = 'calls f' }",
}
TRUE = [
    "f(3) = 6",
    "f(y) = 2 y",
    "f(f(x)) = 4 x",
    "g_1(3) = 7",
    "h_1(x + 1) = 3 x + 3",
    r"\sum_{i=0}^2 q_1 = 6",
    r"\sum_{i=0}^2 r_1(x) = 3 x",
    r"s_1(k) = \frac{k(k+1)}{2} \quad (k \geq 1)",
    r"\sum_{i=0}^2 \left( i + \sum_{i=0}^1 i \right) = 6",
    r"\frac{\partial}{\partial x} g_1(x) = 2",
    r"\frac{\partial f(x)}{\partial x} = 2",
]
FALSE = [
    "f(3) = 0",
    "f(y) = 0",
    "g_1(3) = x + 4",
    "h_1(x) = 2 x",
    r"\sum_{i=0}^2 q_1 = 3 i + 3",
    r"\sum_{i=0}^2 r_1(x) = 3 x i",
    r"\sum_{i=0}^2 \left( i + \sum_{i=0}^1 i \right) = 9",
]


@pytest.mark.parametrize("latex", TRUE)
def test_true(latex: str) -> None:
    check(judged("identity", latex, SYMBOLS), "proved")


@pytest.mark.parametrize("latex", FALSE)
def test_false(latex: str) -> None:
    check(judged("identity", latex, SYMBOLS), "refuted")
