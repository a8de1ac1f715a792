"""Functions of vectors, their derivatives at a place, and roots over several parameters."""

from __future__ import annotations

import json

import pytest
from one_of_each import further
from small_claims import check, judged

from gainproof.verify.judge.exact.expression import add, number, power, sqrt, symbol
from gainproof.verify.judge.exact.statement import Rel, Statement
from gainproof.verify.judge.exact.work_limits import Undecided
from gainproof.verify.judge.hypotheses import settle
from gainproof.verify.judge.replay import replay

SYMBOLS = {
    "L": "{ shape = [2, 1], definition = '(x, y)^T', meaning = 'a place' }",
    "B": "{ shape = [2, 1], definition = '(a, b)^T', meaning = 'another' }",
    "F": r"{ arguments = ['L'], definition = '\sqrt{(L - B)^T (L - B)}', meaning = 'distance' }",
    "G": "{ arguments = ['x', 'y'], definition = 'x^2 y', meaning = 'of two numbers' }",
    "M": "{ shape = [2, 1], definition = '(u, v)^T', meaning = 'a place' }",
    "N": "{ definition = 'y + 1', meaning = 'made of an argument of G' }",
    r"\Delta x": "{ unit = '1', meaning = 'a difference' }",
}
TRUE = [
    r"\frac{\partial F}{\partial x}(M) = \frac{u - a}{F(M)}",
    further(r"\frac{\partial^2 F}{\partial x \partial y}(M) = - \frac{(u - a)(v - b)}{F(M)^3}"),
    r"\frac{\partial F}{\partial x}(L) = \frac{\partial F(L)}{\partial x}",
    r"\frac{\partial G}{\partial x}(u, 3) = 6 u",
    r"\frac{\partial G}{\partial y}(x, v) = x^2",
    r"\left. F(L) \right|_{L = M} = F(M)",
    r"\Delta x - x = -(x - \Delta x)",
    r"\left( \sqrt{u^2 + v} \right)^2 = u^2 + v",
    r"\frac{1}{\sqrt{u + v} - w} = \frac{\sqrt{u + v} + w}{u + v - w^2}",
]
FALSE = [
    r"\frac{\partial F}{\partial x}(M) = \frac{u + a}{F(M)}",
    r"\frac{\partial F}{\partial x}(M) = \frac{\partial F}{\partial y}(M)",
    r"\frac{\partial G}{\partial x}(u, 3) = 6 x",
    r"\Delta x = x",
    r"\sqrt{u + v} = - \sqrt{u + v}",
]
OPEN = [
    pytest.param(
        r"\sqrt{(u + v + w + a + b + c + g + h)^2} = u + v + w + a + b + c + g + h",
        marks=pytest.mark.thorough,
    ),
    # N holds y, which is replaced too: of two values put in together none is to change the other
    r"\frac{\partial G}{\partial x}(N, 3) = 6 y + 6",
    # no branch is asked: two roots that multiply to a third
    r"\sqrt{u v} = \frac{u v}{\sqrt{u v + 0 w} + 0 \sqrt{w u} / (u - u)}",
    r"\sqrt{-u^2 - v^2 - 1} = \sqrt{-u^2 - v^2 - 1}",
    r"\frac{\sqrt{u + v}}{u v - v u} = \frac{\sqrt{u + v}}{u v - v u}",
]


@pytest.mark.parametrize("latex", TRUE)
def test_true(latex: str) -> None:
    check(judged("identity", latex, SYMBOLS), "proved")


@pytest.mark.parametrize("latex", FALSE)
def test_false(latex: str) -> None:
    check(judged("identity", latex, SYMBOLS), "refuted")


@pytest.mark.parametrize("latex", OPEN)
def test_never_proved(latex: str) -> None:
    assert judged("identity", latex, SYMBOLS).verdict != "proved"


def test_a_divisor_that_may_vanish_where_the_domain_is_stated_is_not_passed_over() -> None:
    latex = r"\frac{\left( \sqrt{u + v + w} \right)^2}{u - v} = \frac{u + v + w}{u - v}"
    fields = f"latex = '{latex}'\ndomain = 'u > 0, v > 0, w > 0'"
    assert judged("identity", fields).verdict != "proved"
    check(judged("identity", latex), "proved")


def test_what_follows_from_relations_of_roots_is_replayed_and_an_altered_one_is_not() -> None:
    u, v, *others = (symbol(name) for name in "uvwxyzabcg")
    inside = add(u, power(v, 2), *others)
    root = sqrt(inside)
    outcome = settle(Statement((Rel("=", root * root, inside),)), {}, None, {})
    assert (outcome.verdict, outcome.certificate["engine"]) == ("proved", "formal")
    certificate = json.loads(json.dumps(outcome.certificate))
    assert replay(certificate, "proved") is None
    for field in ("tower", "statement"):
        altered = json.loads(json.dumps(certificate))
        if field == "tower":
            altered["tower"] = []
        else:
            altered["statement"]["relations"][0]["right"]["nodes"][0] = ["symbol", "x"]
        assert replay(altered, "proved") is not None


def test_only_identities_follow_from_relations_of_roots() -> None:
    u, v = symbol("u"), symbol("v")
    order = Statement((Rel(">", sqrt(u + v * v * v), number(-1)),))
    try:
        found = settle(order, {}, None, {})
    except Undecided:
        return
    assert found.certificate.get("engine") != "formal"


SIX = " \\\\ ".join(
    " & ".join(r"\sqrt{2}" if i == j else "1" if j == i + 1 else "0" for j in range(6))
    for i in range(6)
)
MATRICES = {
    "A": rf"{{ shape = [6, 6], definition = '\begin{{pmatrix}} {SIX} \end{{pmatrix}}', "
    "meaning = 'numbers' }",
    "C": f"{{ shape = [6, 6], definition = '\\begin{{pmatrix}} {SIX.replace('1', 'u')} "
    "\\end{pmatrix}', meaning = 'no numbers' }",
    "S": "{ shape = [6, 6], definition = 'A A^{-1} - A^{-1} A', meaning = 'zero' }",
    "Z": f"{{ shape = [6, 6], definition = '\\begin{{pmatrix}} "
    f"{SIX.replace(chr(92) + 'sqrt{2}', '0')} \\end{{pmatrix}}', meaning = 'singular' }}",
    "e": "{ shape = [1, 6], definition = '(0, 0, 0, 0, 0, 1)', meaning = 'the last unit row' }",
}


def test_large_matrices_of_numbers_are_inverted_and_others_are_not() -> None:
    check(judged("identity", "S = 0", MATRICES), "proved")
    check(judged("identity", r"e A^{-1} e^T = \frac{1}{\sqrt{2}}", MATRICES), "proved")
    check(judged("identity", r"e A^{-1} e^T = \frac{1}{2}", MATRICES), "refuted")
    check(judged("identity", "C^{-1} C = C C^{-1}", MATRICES), "undecided")
    check(judged("identity", "Z^{-1} = Z^{-1}", MATRICES), "undecided")


@pytest.mark.parametrize(
    ("latex", "wanted"),
    [
        (r"2 \left( \operatorname{erfinv}(1 - 0.05) \right)^2 \approx 3.84", "proved"),
        (r"2 \left( \operatorname{erfinv}(1 - 0.05) \right)^2 \approx 3.85", "refuted"),
        (r"\operatorname{erf}\left( \sqrt{3.84/2} \right) \approx 0.950", "proved"),
        (r"\operatorname{erf}\left( \sqrt{3.84/2} \right) \approx 0.951", "refuted"),
    ],
)
def test_quantiles_of_a_normal_variable(latex: str, wanted: str) -> None:
    check(judged("value", latex), wanted)


def test_the_inverse_of_the_error_function_has_no_value_beyond_one() -> None:
    assert judged("value", r"\operatorname{erfinv}(1) \approx 1.0").verdict == "undecided"
    assert judged("value", r"\operatorname{erfinv}(2) \approx 1.0").verdict == "undecided"


def test_slopes_of_the_error_function_and_its_inverse() -> None:
    slope = r"\left. \frac{d \operatorname{erf}(x)}{d x} \right|_{x=0} \approx 1.128379"
    check(judged("value", slope), "proved")
    inverse = r"\left. \frac{d \operatorname{erfinv}(x)}{d x} \right|_{x=0} \approx 0.886227"
    check(judged("value", inverse), "proved")
