"""What is asked for, a derivative, mean, integral or determinant, is no misprint: the other side is
repaired, or what is true is said.
"""

from __future__ import annotations

import pytest
from claim_texts import algebra, judged, steady

MOTION = algebra(
    "'x' = { unit = 'm', meaning = 'position' }\n"
    "'l' = { unit = 'm', meaning = 'way' }\n"
    "'p' = { unit = '1', meaning = 'course' }\n"
    "'c' = { unit = '1', meaning = 'change of course' }\n"
    "'t' = { unit = 's', domain = 't > 0', meaning = 'a time' }\n"
    "'q' = { unit = 's', meaning = 'any time' }\n"
    "'v' = { unit = 'm s^-1', meaning = 'velocity' }\n"
    "'e' = { definition = 'x + l \\sin(p + c)', meaning = 'next position' }\n"
    "'n' = { definition = 'l \\cos(p + c)', meaning = 'next position north' }\n"
    "'s' = { unit = '1', domain = 's > 0', meaning = 'deviation' }\n"
    "'w' = { unit = '1', variance = 's^2', meaning = 'noise' }\n"
    "'g' = { unit = '1', domain = 'g > 0', meaning = 'a number' }\n"
    "'z' = { unit = '1', meaning = 'a number' }\n"
    "'u' = { unit = '1', meaning = 'a number' }\n"
    "'J' = { definition = '\\begin{pmatrix} 1 & 0 \\\\ 0 & 1 \\end{pmatrix}', meaning = 'J' }\n"
    "'A' = { definition = '\\begin{pmatrix} 1 & 1 \\\\ 0 & g^2 \\end{pmatrix}', meaning = 'A' }\n"
)


def plain(latex: str) -> str:
    return " ".join(latex.replace("\\left", "").replace("\\right", "").split())


@pytest.mark.parametrize(
    ("latex", "right"),
    [
        # one function for another
        (r"\frac{\partial e}{\partial c} = l \sin(p + c)", r"l \cos ( p + c )"),
        (r"\frac{\partial n}{\partial c} = -l \cos(p + c)", r"-l \sin ( p + c )"),
        (r"\frac{d \cosh u}{du} = \cosh u", r"\sinh ( u )"),
        (r"\frac{\partial n}{\partial l} = \sin(p + c)", r"\cos ( p + c )"),
        # an exponent, a sign, a factor, beside a mean or an integral
        (r"E[(w g^2)^2] = s^2 g^2", r"s^{2} g^{4}"),
        (r"E[(g w)(g^2 w)] = -g^3 s^2", r"g^{3} s^{2}"),
        (r"\int_0^t v \, \mathrm{d}q = 2 v t", r"v t"),
        (r"\det A = \frac{g^2}{2}", r"g^{2}"),
    ],
)
def test_only_the_other_side_is_repaired(latex: str, right: str) -> None:
    (verdict,) = judged(MOTION, ("identity", latex))
    assert verdict.verdict == "refuted", verdict.reason
    printed = [plain(repair["latex"]).split(" = ") for repair in verdict.repairs]
    assert right in [sides[1] for sides in printed], verdict.repairs
    assert len({sides[0] for sides in printed}) == 1


@pytest.mark.parametrize(
    ("latex", "truth"),
    [
        # (z - 1)(z - g^2), by hand
        (r"\det(z J - A) = (z - g)^2", r"\det ( z J - A ) = ( z - 1 ) ( z - g^{2} )"),
        (r"\frac{\partial n}{\partial x} = e + n^2", None),
    ],
)
def test_what_is_true_is_said(latex: str, truth: str | None) -> None:
    (verdict,) = judged(MOTION, ("identity", latex))
    assert verdict.verdict == "refuted"
    if truth is not None:
        assert verdict.repairs == ()
        assert plain(verdict.truth or "") == truth
        assert f"what is true is {verdict.truth}" in verdict.reason
    for repair in verdict.repairs:
        assert plain(repair["latex"]).startswith(r"\frac{\partial}{\partial x} n =")


def test_a_definition_of_which_the_derivative_is_asked_is_not_blamed() -> None:
    claims = [
        ("identity", r"\frac{\partial e}{\partial c} = -l \cos(p + c)"),
        ("identity", r"\frac{\partial e}{\partial p} = -l \cos(p + c)"),
    ]
    for verdict in judged(MOTION, *claims):
        assert verdict.verdict == "refuted"
        assert "defined as" not in verdict.reason
        assert verdict.repairs


def test_a_definition_that_other_claims_bear_out_is_not_blamed() -> None:
    """One claim speaks against it, two that would stand with another sign as well do not."""
    setting = algebra(
        "'a' = { unit = '1', meaning = 'a number' }\n"
        "'b' = { unit = '1', meaning = 'a number' }\n"
        "'h' = { definition = 'a - b', meaning = 'difference' }\n"
    )
    claims = [
        ("identity", "h^2 = a^2 - 2 a b + b^2"),
        ("identity", r"\sqrt{h^2} = \sqrt{(a - b)^2}"),
        ("identity", r"h (a^3 + 7 b) = (b - a)(a^3 + 7 b)"),
    ]
    *_, verdict = judged(setting, *claims)
    assert verdict.verdict == "refuted"
    assert "defined as" not in verdict.reason


MATCHED = algebra(
    "'t' = { unit = '1', domain = 't > 0', meaning = 'a time' }\n"
    "'c' = { unit = '1', domain = 'c > 0', meaning = 'a number' }\n"
    "'A' = { definition = 'c t^2', meaning = 'a quantity' }\n"
    "'B' = { definition = 't^2 + c', meaning = 'another' }\n"
    "'D' = { definition = '\\frac{c t^2 + 3 t}{16}', meaning = 'a third' }\n"
)


@pytest.mark.parametrize(
    ("kind", "latex", "expected"),
    [
        # doubled on one side, or halved on the other
        (
            "identity",
            r"t \frac{\partial A}{\partial t} = A",
            r"t ( \frac{\partial}{\partial t} A ) = 2 A",
        ),
        (
            "identity",
            r"\frac{\partial}{\partial t} (c t) = 2 c",
            r"\frac{\partial}{\partial t} ( c t ) = c",
        ),
        # sharp, and one that is weaker
        (
            "inequality",
            r"\frac{t}{B} \frac{\partial B}{\partial t} > 2",
            r"\frac{t}{B} ( \frac{\partial}{\partial t} B ) < 2",
        ),
        (
            "inequality",
            r"2 < \frac{t}{B} \frac{\partial B}{\partial t}",
            r"2 > \frac{t}{B} ( \frac{\partial}{\partial t} B )",
        ),
    ],
)
def test_repairs_beside_a_derivative_do_not_say_the_same_twice(
    kind: str, latex: str, expected: str
) -> None:
    (verdict,) = judged(MATCHED, (kind, latex))
    assert verdict.verdict == "refuted"
    assert [plain(repair["latex"]) for repair in verdict.repairs] == [expected]


def test_numbers_of_what_is_true_are_fractions() -> None:
    (verdict,) = judged(MATCHED, ("identity", r"\frac{\partial D}{\partial t} = c^2 + t^3"))
    assert verdict.repairs == ()
    # (2 c t + 3)/16, by hand
    truth = r"\frac{\partial}{\partial t} D = \frac{1}{8} c t + \frac{3}{16}"
    assert plain(verdict.truth or "") == truth


@pytest.mark.parametrize("model", ["random-velocity", "random-acceleration"])
def test_what_is_true_is_not_said_in_lines_of_roots(model: str) -> None:
    (verdict,) = judged(steady(model), ("identity", r"\alpha = \frac{1}{\beta}"))
    assert verdict.verdict == "refuted"
    assert verdict.truth is None


@pytest.mark.parametrize(
    ("latex", "left"),
    [
        (r"\frac{\partial}{\partial t}(c t) = 2 c", r"\frac{\partial}{\partial t} ( c t )"),
        (r"\frac{\partial}{\partial t}(c + t) = 2", r"\frac{\partial}{\partial t} ( c + t )"),
        (r"\frac{\partial}{\partial t} t^2 = t", r"\frac{\partial}{\partial t} t^{2}"),
        (r"\frac{\partial A}{\partial t} = c t", r"\frac{\partial}{\partial t} A"),
    ],
)
def test_what_is_differentiated_keeps_its_parentheses(latex: str, left: str) -> None:
    (verdict,) = judged(MATCHED, ("identity", latex))
    assert verdict.repairs
    assert {plain(repair["latex"]).split(" = ")[0] for repair in verdict.repairs} == {left}
