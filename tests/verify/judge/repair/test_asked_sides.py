"""What is asked for, a derivative, mean, integral or determinant, is no misprint: the other side is
repaired, or what is true is said.
"""

from __future__ import annotations

import pytest
from claim_texts import algebra, judged

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
